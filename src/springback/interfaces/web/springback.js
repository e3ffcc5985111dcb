/*! springback, MIT licence; sources cbe82322b0d27df9510e08c6b30401c1a845be31cfd3d44140ee66dace94bc6d

It holds:

fflate 0.8.3

MIT License

Copyright (c) 2026 Arjun Barrett

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.

----

three 0.180.0

The MIT License

Copyright © 2010-2025 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

----

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
(()=>{var fp=i=>{throw TypeError(i)};var Ax=(i,e,t)=>e.has(i)||fp("Cannot "+t);var gl=(i,e,t)=>e.has(i)?fp("Cannot add the same private member more than once"):e instanceof WeakSet?e.add(i):e.set(i,t);var Cn=(i,e,t)=>(Ax(i,e,"access private method"),t);function G(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==!1&&r!=null&&n.setAttribute(s,r);return n.append(...t),n}var Rx={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",back:"M18 5v14l-9.5-7zM5.5 5h2.4v14H5.5z",forth:"M6 5v14l9.5-7zM16.1 5h2.4v14h-2.4z",touch:"M4 4h3v16H4zM20 12l-9 6V6z",link:"M10.6 13.4a4 4 0 0 0 5.7 0l3-3a4 4 0 1 0-5.7-5.7l-1.6 1.6 1.4 1.4 1.6-1.6a2 2 0 1 1 2.9 2.9l-3 3a2 2 0 0 1-2.9 0zm2.8-2.8a4 4 0 0 0-5.7 0l-3 3a4 4 0 1 0 5.7 5.7l1.6-1.6-1.4-1.4-1.6 1.6a2 2 0 1 1-2.9-2.9l3-3a2 2 0 0 1 2.9 0z",picture:"M4 7h4l1.5-2.5h5L16 7h4v12H4zm8 2.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zm0 1.8a1.7 1.7 0 1 1 0 3.4 1.7 1.7 0 0 1 0-3.4z",undo:"M9 4 3.5 9.5 9 15v-4h5a3.5 3.5 0 0 1 0 7h-4v2.2h4a5.7 5.7 0 0 0 0-11.4H9z",film:"M3 6h12v12H3zM16.5 10.5 21 7.5v9l-4.5-3z",full:"M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z",help:"M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 12.5h2v2h-2zm1-9c-2 0-3.5 1.3-3.5 3.2h2c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.4-2.5 1.6-2.5 4.1v.3h2v-.2c0-1.4 2.5-1.8 2.5-4.3 0-1.8-1.5-3-3.5-3z"};function Yi(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Rx[i]),t.setAttribute("fill-rule","evenodd"),e.append(t),e}function Si(i,e,t,n){let s=G("div",{class:"choice",role:"group","aria-label":i});for(let[a,l]of e)s.append(G("button",{type:"button","data-value":a,"aria-pressed":String(a===t),onclick:()=>{r(a),n(a)}},l));function r(a){for(let l of s.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))}let o=a=>(r(a),n(a));return Object.defineProperty(s,"chosen",{get:()=>s.querySelector("[aria-pressed=true]")?.dataset.value}),Object.assign(s,{mark:r,press:o})}function dp(i,e,t,n=""){let s=G("button",{type:"button",title:n,"aria-pressed":String(e),onclick:()=>{s.setAttribute("aria-pressed",String(!s.on)),t(s.on)}},i);return Object.defineProperty(s,"on",{get:()=>s.getAttribute("aria-pressed")==="true"}),s}var Cx=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"],Px=30;function pp(i,e){let t=G("a",{href:URL.createObjectURL(i),download:e});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function yu(i,e,t,n=null){let s=e.getBoundingClientRect(),r=getComputedStyle(e);if(!s.width)return;let[o,a]=[s.left-t.left,s.top-t.top];i.fillStyle=r.backgroundColor,i.fillRect(o,a,s.width,s.height);let l=o+parseFloat(r.paddingLeft);if(n&&parseFloat(n.width)>0){let c=parseFloat(n.height);i.fillStyle=n.backgroundColor,i.fillRect(l,a+(s.height-c)/2,parseFloat(n.width),c),l+=parseFloat(n.width)+parseFloat(n.marginRight)}i.font=`${r.fontWeight} ${r.fontSize} ${r.fontFamily}`,i.textBaseline="middle",i.fillStyle=r.color,i.fillText(e.textContent,l,a+s.height/2+1,o+s.width-l)}function mp({scene:i,stage:e,player:t,name:n,say:s,onRecording:r=()=>{}}){let o=G("div",{class:"stage-clock","aria-hidden":"true"});e.append(o);let a=null,l=null;function c(){let m=Math.min(devicePixelRatio||1,2),g=G("canvas",{width:2*Math.round(e.clientWidth*m/2),height:2*Math.round(e.clientHeight*m/2)});return{canvas:g,pen:g.getContext("2d"),ratio:m}}function u({canvas:m,pen:g,ratio:v},p){o.textContent=`${i.pose().t.toFixed(4)} s`;let d=e.getBoundingClientRect();g.setTransform(1,0,0,1,0,0),g.drawImage(p,0,0,m.width,m.height),g.scale(v,v);let b=e.querySelector(".scene-legend"),M=b.getBoundingClientRect();g.fillStyle=getComputedStyle(b).backgroundColor,g.fillRect(M.left-d.left,M.top-d.top,M.width,M.height);for(let _ of b.children)yu(g,_,d,getComputedStyle(_,"::before"));for(let _ of e.querySelectorAll(".force-labels span:not([hidden])"))yu(g,_,d);yu(g,o,d)}function h(){let m=i.canvas();if(!m)return s("There is no picture without WebGL.");let g=c();u(g,m),g.canvas.toBlob(v=>{pp(v,`${n}-${i.pose().t.toFixed(4)}s.png`),s("The picture is among your downloads.")})}function f(){if(a)return a.stop();let m=window.MediaRecorder&&Cx.find(v=>MediaRecorder.isTypeSupported(v));if(!m||!i.canvas()||!HTMLCanvasElement.prototype.captureStream)return s("This browser cannot record films. The command springback animate RESULT --out film.gif makes one, or film.mp4.");l=c(),u(l,i.canvas());let g=[];a=new MediaRecorder(l.canvas.captureStream(Px),{mimeType:m,videoBitsPerSecond:12e6}),a.ondataavailable=v=>g.push(v.data),a.onstop=()=>{[a,l]=[null,null],t.pause(),r(!1),pp(new Blob(g,{type:m}),`${n}.${m.includes("mp4")?"mp4":"webm"}`),s("The film is among your downloads. springback animate makes one without dropped frames.")},a.start(),r(!0),t.play()}return{picture:h,film:f,drawn(){l&&u(l,i.canvas(!1))},rested(){a?.state==="recording"&&!t.playing&&a.stop()},get recording(){return!!a}}}var Ix=()=>matchMedia("(prefers-color-scheme: dark)").matches,Lx={background:"#f3f5f8",ink:"#222222",faint:"#8c8c8c",line:"#c3cad4",wall:"#7d8794",shapes:["#7d8794","#94806a","#6f8f7c","#8b7a99","#6b8fa3","#a3827f"],mat:"#009e73",ground:"#a8aeb7",metal:"#5b6470",dark:"#30363d",arms:["#0072b2","#d98a00","#009e73","#cc79a7","#3a9bd9","#8c8c8c"],robots:["#0072b2","#d55e00","#007a5a","#a8488a","#8a6d00","#1b2a6b","#6b6b6b","#7a1f1f"],force:"#e69f00",thrust:"#56b4e9",before:"#8c8c8c"},Dx={background:"#14181d",ink:"#e6e9ed",faint:"#9aa3ad",line:"#3a434e",wall:"#98a3b1",shapes:["#98a3b1","#b5a089","#8db39b","#ac9abd","#88b0c6","#c4a19d"],mat:"#2cc79a",ground:"#59626d",metal:"#aab4c0",dark:"#cdd4dc",arms:["#4ea8e0","#f0b429","#35c79b","#e29cc4","#8fd0f5","#a7b0ba"],robots:["#4ea8e0","#ff8a3d","#35c79b","#e29cc4","#e3cf57","#a9b4ff","#c9d1d9","#ff8f8f"],force:"#ffc13d",thrust:"#7cc8f2",before:"#a7b0ba"},Pn=()=>Ix()?Dx:Lx;var mi=Uint8Array,kr=Uint16Array,Ux=Int32Array,gp=new mi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),vp=new mi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Nx=new mi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),xp=function(i,e){for(var t=new kr(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new Ux(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},_p=xp(gp,2),yp=_p.b,Fx=_p.r;yp[28]=258,Fx[258]=28;var bp=xp(vp,0),Ox=bp.b,tA=bp.r,wu=new kr(32768);for(Et=0;Et<32768;++Et)ls=(Et&43690)>>1|(Et&21845)<<1,ls=(ls&52428)>>2|(ls&13107)<<2,ls=(ls&61680)>>4|(ls&3855)<<4,wu[Et]=((ls&65280)>>8|(ls&255)<<8)>>1;var ls,Et,Zo=(function(i,e,t){for(var n=i.length,s=0,r=new kr(e);s<n;++s)i[s]&&++r[i[s]-1];var o=new kr(e);for(s=1;s<e;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(t){a=new kr(1<<e);var l=15-e;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],u=e-i[s],h=o[i[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[wu[h]>>l]=c}else for(a=new kr(n),s=0;s<n;++s)i[s]&&(a[s]=wu[o[i[s]-1]++]>>15-i[s]);return a}),Ko=new mi(288);for(Et=0;Et<144;++Et)Ko[Et]=8;var Et;for(Et=144;Et<256;++Et)Ko[Et]=9;var Et;for(Et=256;Et<280;++Et)Ko[Et]=7;var Et;for(Et=280;Et<288;++Et)Ko[Et]=8;var Et,Mp=new mi(32);for(Et=0;Et<32;++Et)Mp[Et]=5;var Et;var Bx=Zo(Ko,9,1);var zx=Zo(Mp,5,1),bu=function(i){for(var e=i[0],t=1;t<i.length;++t)i[t]>e&&(e=i[t]);return e},Ei=function(i,e,t){var n=e/8|0;return(i[n]|i[n+1]<<8)>>(e&7)&t},Mu=function(i,e){var t=e/8|0;return(i[t]|i[t+1]<<8|i[t+2]<<16)>>(e&7)},kx=function(i){return(i+7)/8|0},Hx=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new mi(i.subarray(e,t))};var Vx=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Ti=function(i,e,t){var n=new Error(e||Vx[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Ti),!t)throw n;return n},Gx=function(i,e,t,n){var s=i.length,r=n?n.length:0;if(!s||e.f&&!e.l)return t||new mi(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new mi(s*3));var c=function(Ge){var dt=t.length;if(Ge>dt){var H=new mi(Math.max(dt*2,Ge));H.set(t),t=H}},u=e.f||0,h=e.p||0,f=e.b||0,m=e.l,g=e.d,v=e.m,p=e.n,d=s*8;do{if(!m){u=Ei(i,h,1);var b=Ei(i,h+1,3);if(h+=3,b)if(b==1)m=Bx,g=zx,v=9,p=5;else if(b==2){var E=Ei(i,h,31)+257,I=Ei(i,h+10,15)+4,D=E+Ei(i,h+5,31)+1;h+=14;for(var w=new mi(D),S=new mi(19),A=0;A<I;++A)S[Nx[A]]=Ei(i,h+A*3,7);h+=I*3;for(var k=bu(S),B=(1<<k)-1,V=Zo(S,k,1),A=0;A<D;){var W=V[Ei(i,h,B)];h+=W&15;var M=W>>4;if(M<16)w[A++]=M;else{var X=0,F=0;for(M==16?(F=3+Ei(i,h,3),h+=2,X=w[A-1]):M==17?(F=3+Ei(i,h,7),h+=3):M==18&&(F=11+Ei(i,h,127),h+=7);F--;)w[A++]=X}}var z=w.subarray(0,E),J=w.subarray(E);v=bu(z),p=bu(J),m=Zo(z,v,1),g=Zo(J,p,1)}else Ti(1);else{var M=kx(h)+4,_=i[M-4]|i[M-3]<<8,P=M+_;if(P>s){l&&Ti(0);break}a&&c(f+_),t.set(i.subarray(M,P),f),e.b=f+=_,e.p=h=P*8,e.f=u;continue}if(h>d){l&&Ti(0);break}}a&&c(f+131072);for(var ne=(1<<v)-1,te=(1<<p)-1,ce=h;;ce=h){var X=m[Mu(i,h)&ne],fe=X>>4;if(h+=X&15,h>d){l&&Ti(0);break}if(X||Ti(2),fe<256)t[f++]=fe;else if(fe==256){ce=h,m=null;break}else{var ye=fe-254;if(fe>264){var A=fe-257,_e=gp[A];ye=Ei(i,h,(1<<_e)-1)+yp[A],h+=_e}var ee=g[Mu(i,h)&te],$=ee>>4;ee||Ti(3),h+=ee&15;var J=Ox[$];if($>3){var _e=vp[$];J+=Mu(i,h)&(1<<_e)-1,h+=_e}if(h>d){l&&Ti(0);break}a&&c(f+131072);var me=f+ye;if(f<J){var ve=r-J,be=Math.min(J,me);for(ve+f<0&&Ti(3);f<be;++f)t[f]=n[ve+f]}for(;f<me;++f)t[f]=t[f-J]}}e.l=m,e.p=ce,e.b=f,e.f=u,m&&(u=1,e.m=v,e.d=g,e.n=p)}while(!u);return f!=t.length&&o?Hx(t,0,f):t.subarray(0,f)};var Wx=new mi(0);var Xx=function(i,e){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Ti(6,"invalid zlib data"),(i[1]>>5&1)==+!e&&Ti(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function wp(i,e){return Gx(i.subarray(Xx(i,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var qx=typeof TextDecoder<"u"&&new TextDecoder,Yx=0;try{qx.decode(Wx,{stream:!0}),Yx=1}catch{}var Sp=i=>Uint8Array.from(atob(i),e=>e.charCodeAt(0));function $x(i,e){let t=wp(Sp(i.data));return i.columns.map(({low:n,step:s},r)=>{let o=2*e*r,a=new Float64Array(e);for(let l=0,c=0;l<e;l++)c=c+t[o+l]+256*t[o+e+l]&65535,a[l]=n+s*c;return a})}function Ep(i){let e=new Map;if(!i)return e;for(let t of["trajectory","telemetry"].filter(n=>i[n])){let n=i[t],s=new Float64Array(Sp(n.t.data).buffer),r=null,o=[];n.columns.forEach(({name:a,unit:l,factor:c,group:u},h)=>e.set(a,{name:a,unit:l,group:u,t:s,held:t==="telemetry",words:i.words[a],get values(){return r??(r=$x(n,s.length)),r[h]},get shown(){return o[h]??(o[h]=c===1?this.values:this.values.map(f=>c*f)),o[h]}}))}return e}var Zx={f4:Float32Array,f8:Float64Array,i4:Int32Array};function Zt(i){let e=Uint8Array.from(atob(i.data),t=>t.charCodeAt(0));return new Zx[i.type](e.buffer)}function Tp(i){if(i.ready)return i;let e=Zt(i.t),t=Zt(i.force.at),n=new Int32Array(e.length).fill(-1);return t.forEach((s,r)=>n[s]=r),{...i,ready:!0,t:e,n:e.length,begin:e[0],end:e[e.length-1],position:Zt(i.position),attitude:Zt(i.attitude),armLength:Zt(i.arm_length),bends:Zt(i.bends),thrust:Zt(i.thrust),force:Zt(i.force.of),point:Zt(i.point.of),bodies:i.bodies.map(s=>({...s,position:Zt(s.position),attitude:Zt(s.attitude)})),rows:n,series:i.series.map(s=>({...s,values:Zt(s.values)})),signals:Ep(i.signals),every:i.signals?.telemetry?.every??1,shift:0}}function vl(i,e){let t=0,n=i.length-1;if(!(e>i[0]))return 0;for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return i[n]<=e?n:t}function Jo(i,e){let t=Math.min(Math.max(e-i.shift,i.begin),i.end),n=vl(i.t,t),s=Math.min(n+1,i.n-1),r=s>n?(t-i.t[n])/(i.t[s]-i.t[n]):0,o=(g,v,p)=>g[n*v+p]*(1-r)+g[s*v+p]*r,a=(g,v)=>Array.from({length:v},(p,d)=>o(g,v,d)),l=i.arms.length,c=g=>{let v=a(g,4),p=0;for(let b=0;b<4;b++)p+=g[n*4+b]*g[s*4+b];if(p<0)for(let b=0;b<4;b++)v[b]=g[n*4+b];let d=Math.hypot(...v);return v.map(b=>b/d)},u=i.rows[n],h=i.rows[s],f=[],m=i.part.length;for(let g=0;g<m;g++){let v=[0,0,0],p=null;for(let[b,M]of[[u,1-r],[h,r]]){if(b<0)continue;let _=(b*m+g)*3;for(let E=0;E<3;E++)v[E]+=M*i.force[_+E];let P=Array.from(i.point.subarray(_,_+3));P.some(E=>E!==0)&&(p=P)}let d=Math.hypot(...v);f.push(p&&d>1e-6?{part:i.part[g],force:v,size:d,point:p}:null)}return{t:t+i.shift,own:t,place:n,position:a(i.position,3),quaternion:c(i.attitude),armLengths:a(i.armLength,l),bends:i.bends.length?a(i.bends,l):[],thrust:a(i.thrust,i.rotors.length),contacts:f,bodies:i.bodies.map(g=>({position:a(g.position,3),quaternion:c(g.attitude)}))}}function jo({flight:i,t:e=i.t,values:t,held:n=!1},s){let r=Math.min(Math.max(s-i.shift,e[0]),e[e.length-1]),o=vl(e,r),a=n?o:Math.min(o+1,e.length-1),l=a>o?(r-e[o])/(e[a]-e[o]):0;return t[o]*(1-l)+t[a]*l}var Hr=i=>["est_x","est_qw"].every(e=>i.signals.has(e));function Su(i,e){let t=(r,o)=>{let a=i.signals.get(r);return a?jo({flight:i,...a,values:a.values},e):o},n=["w","x","y","z"].map(r=>t(`est_q${r}`)),s=Math.hypot(...n)||1;return{own:Math.min(Math.max(e-i.shift,i.begin),i.end),position:["x","y","z"].map(r=>t(`est_${r}`)),quaternion:n.map(r=>r/s),armLengths:i.arms.map((r,o)=>t(`hall${o+1}`,r.length)),bends:[],thrust:i.rotors.map(()=>0),contacts:[]}}function Cs(i){let e=i.first_touch??i.impacts[0]?.[0]??null;return e===null?null:e+i.shift}var xl=i=>i.map(Cs).find(e=>e!==null)??null;function Eu(i){let e=0;for(let t=0;t<i.force.length;t+=3)e=Math.max(e,Math.hypot(i.force[t],i.force[t+1],i.force[t+2]));return e}function Ap(i){let e=i.part.length;return Float32Array.from(i.rows,t=>{let n=[0,0,0];for(let s=0;t>=0&&s<3*e;s++)n[s%3]+=i.force[t*e*3+s];return Math.hypot(...n)})}function Tu(i){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));return e*([5,2,1].find(t=>t*e<=i*1.0000001)??1)}var Kx=.005,Vr=[[],[7,3],[2,3],[9,3,2,3],[12,4],[4,2,1,2],[14,3,2,3],[3,6]],Rp={"Arm compression":["largest",i=>Math.max(...i)],Thrust:["all rotors",i=>i.reduce((e,t)=>e+t,0)],Velocity:["speed",i=>i[0]],Energy:["motion",i=>i[0]],"Contact force":["sum of all contacts"]},tr=i=>[...new Set(i.flatMap(e=>e.series.map(t=>t.panel)))],_l=i=>new Map(i.flatMap(e=>[...e.signals])),Qo=i=>i.map(e=>Array.isArray(e)?e.join():e).join(";");function Au(i,e){let t=tr(e),n=_l(e);return i.split(";").flatMap(s=>t.includes(s)?[s]:yl(s.split(",").filter(r=>n.has(r)),n))}function yl(i,e){let t=new Map;for(let n of new Set(i)){let{unit:s,words:r}=e.get(n),o=r?n:s;t.set(o,[...t.get(o)??[],n])}return[...t.values()]}function Cp(i,e){return e.map(t=>Array.isArray(t)?jx(i,t):Jx(i,t)).filter(t=>t.curves.length)}function Jx(i,e){let t=Pn(),n=i.map(o=>o.series.filter(a=>a.panel===e)),s=i.length>1?n.flatMap((o,a)=>Qx(e,o,i[a])):e_(n[0]);s.forEach((o,a)=>{o.flight??(o.flight=i[0]),o.t=o.flight.t,o.colour??(o.colour=t.arms[a%t.arms.length]),o.dash??(o.dash=Vr[a%Vr.length])});let r=i.length>1?Rp[e]?.[0]:"";return{key:e,name:r?`${e}, ${r}`:e,unit:n.flat()[0]?.unit,own:null,curves:s}}function jx(i,e){let t=Pn(),n=_l(i),s=i.length>1,r=e.flatMap((c,u)=>i.flatMap(h=>{let f=h.signals.get(c);if(!f)return[];let{t:m,shown:g,held:v}=f,p=s&&e.length===1?h.index:u;return[{name:s?e.length===1?h.label:`${h.label}, ${c}`:c,flight:h,t:m,values:g,held:v,dash:Vr[p%Vr.length],colour:s?h.colour:t.arms[u%t.arms.length]}]})),o=e.map(c=>n.get(c)),a=new Set(o.map(c=>c?.group)),l=e.length===1?e[0]:a.size===1?o[0].group:e.slice(0,3).join(", ")+(e.length>3?", …":"");return{key:e.join(),name:l,unit:o[0]?.unit,own:e,words:o[0]?.words,curves:r}}function Qx(i,e,t){if(!e.length)return[];let[,n]=Rp[i]??["",r=>r[0]],s=i==="Contact force"?Ap(t):Float32Array.from(e[0].values,(r,o)=>n(e.map(a=>a.values[o])));return[{name:t.label,values:s,flight:t,colour:t.colour,dash:Vr[t.index%Vr.length]}]}function e_(i){let e=[];for(let t of i){let n=t.values.reduce((r,o)=>Math.max(r,Math.abs(o)),0),s=e.find(r=>{let o=Kx*Math.max(n,r.peak);return r.values.every((a,l)=>Math.abs(a-t.values[l])<=o)});s?s.names.push(t.name):e.push({names:[t.name],values:t.values,peak:n})}return e.map(({names:t,values:n})=>({name:t_(t),values:n}))}function t_(i){let e=i.map(t=>t.match(/^(.*?)\s*(\d+)$/));return i.length<2||e.some(t=>!t||t[1]!==e[0][1])?i.join(", "):`${e[0][1]} ${e.map(t=>t[2]).join(", ")}`}function Pp({signals:i,standard:e,onChoose:t}){let n=G("input",{type:"search",placeholder:"est, N, phase, …","aria-label":"Search signals",oninput:b}),s=G("h2",{id:"chooser-title"}),r=G("span",{class:"count",role:"status"}),o=(E,I,D)=>G("label",{"data-words":`${E} ${I}`.toLowerCase()},G("input",{type:"checkbox",value:E,onchange:M}),E,...D?[G("small",{},D)]:[]),a=(E,...I)=>{let D=G("fieldset",{},G("legend",{},E),...I);return I.length>1&&D.firstChild.append(G("button",{type:"button",class:"small","aria-label":`All of ${E}, or none`,onclick:()=>{let w=[...D.querySelectorAll("label:not([hidden]) input")],S=!w.every(A=>A.checked);w.forEach(A=>A.checked=S),M()}},"all")),D},l=a("Standard plots",...e.map(E=>o(E,"standard"))),c=new Map;for(let{name:E,unit:I,group:D}of i.values()){let w=[D,I,I==="m/s²"?"acceleration":""].join(" ");c.set(D,[...c.get(D)??[],o(E,w,I)])}let u=G("div",{class:"signals"},l,...[...c].map(([E,I])=>a(E,...I))),h=G("p",{hidden:!0},"No signal of this flight matches."),f=G("form",{method:"dialog",onsubmit:_},s,G("p",{class:"hint"},"Signals of one unit share a plot. Names are those of the columns in the files of the result."),n,u,h,G("div",{class:"actions"},r,G("button",{type:"button",onclick:()=>(t(null),m.close())},"Only standard plots"),G("button",{type:"button",onclick:()=>m.close()},"Cancel"),G("button",{type:"submit",class:"main"},"Plot"))),m=G("dialog",{class:"chooser","aria-labelledby":"chooser-title"},f),g=[],v=null,p=E=>[...E.querySelectorAll("input[type=checkbox]:checked")].map(I=>I.value),d=()=>[...u.children].filter(E=>E!==l).flatMap(p);function b(){let E=n.value.toLowerCase().split(/\s+/).filter(Boolean);for(let I of u.children){let D=[...I.querySelectorAll("label")];D.forEach(w=>w.hidden=!E.every(S=>w.dataset.words.includes(S))),I.hidden=D.every(w=>w.hidden)||I===l&&v!==null}h.hidden=[...u.children].some(I=>!I.hidden)}function M(){let E=d(),I=yl(E,i).length;r.textContent=E.length?`${E.length} signal${E.length>1?"s":""} in ${I} plot${I>1?"s":""}`:""}function _(){let E=yl(d(),i);if(v!==null)t(g.flatMap((I,D)=>D===v?E:[I]));else{let I=p(l),D=g.filter(w=>Array.isArray(w)||I.includes(w));t([...D,...I.filter(w=>!g.includes(w)),...E])}}function P(E,I=null){[g,v]=[E,I];let D=I===null?E.filter(w=>!Array.isArray(w)):E[I];u.querySelectorAll("input").forEach(w=>w.checked=D.includes(w.value)),s.textContent=I===null?"Add plots":"Change a plot",n.value="",b(),M(),m.showModal(),n.focus()}return{element:m,open:P}}function bl(i,e){let t=()=>document.fullscreenElement?document.exitFullscreen():i().requestFullscreen().catch(e),n=G("button",{type:"button",class:"tool tool-full",hidden:!document.fullscreenEnabled,onclick:t},Yi("full"));function s(){let r=document.fullscreenElement?"Leave full screen":"Full screen";n.title=`${r} (F)`,n.setAttribute("aria-label",r)}return document.addEventListener("fullscreenchange",s),s(),{button:n,toggle:t}}function Ip({read:i,apply:e}){let t=0,n=location.hash,s=()=>{let a=Object.entries(i()).filter(([,l])=>l!=="");return`#${new URLSearchParams(a)}`.replace(/%2C/g,",").replace(/%3B/g,";")};function r(){clearTimeout(t),n=s();try{history.replaceState(null,"",n)}catch{}}addEventListener("hashchange",()=>{location.hash!==n&&o()});function o(){e(Object.fromEntries(new URLSearchParams(location.hash.slice(1))))}return{follow:o,renew(){clearTimeout(t),t=setTimeout(r,250)},address(){return r(),location.href.replace(/#.*/,"")+n}}}var Hs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Vs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},lm=0,ff=1,cm=2;var df=1,hm=2,Qi=3,gs=0,Wn=1,Sn=2,xs=0,ar=1,pf=2,mf=3,gf=4,um=5,Os=100,fm=101,dm=102,pm=103,mm=104,gm=200,vm=201,xm=202,_m=203,jl=204,Ql=205,ym=206,bm=207,Mm=208,wm=209,Sm=210,Em=211,Tm=212,Am=213,Rm=214,Ic=0,Lc=1,Dc=2,lr=3,Uc=4,Nc=5,Fc=6,Oc=7,vf=0,Cm=1,Pm=2,_s=0,Im=1,Lm=2,Dm=3,Um=4,Nm=5,Fm=6,Om=7;var xf=300,gr=301,vr=302,Bc=303,zc=304,Ha=306,ec=1e3,Fs=1001,tc=1002,vi=1003,Bm=1004;var Va=1005;var Li=1006,kc=1007;var Gs=1008;var Fi=1009,_f=1010,yf=1011,bo=1012,Hc=1013,Ws=1014,es=1015,Mo=1016,Vc=1017,Gc=1018,wo=1020,bf=35902,Mf=35899,wf=1021,Sf=1022,xi=1023,co=1026,So=1027,Ef=1028,Wc=1029,Tf=1030,Xc=1031;var qc=1033,Ga=33776,Wa=33777,Xa=33778,qa=33779,Yc=35840,$c=35841,Zc=35842,Kc=35843,Jc=36196,jc=37492,Qc=37496,eh=37808,th=37809,nh=37810,ih=37811,sh=37812,rh=37813,oh=37814,ah=37815,lh=37816,ch=37817,hh=37818,uh=37819,fh=37820,dh=37821,ph=36492,mh=36494,gh=36495,vh=36283,xh=36284,_h=36285,yh=36286;var ua=2300,nc=2301,Jl=2302,rf=2400,of=2401,af=2402;var zm=3200,km=3201;var Af=0,Hm=1,ys="",Gn="srgb",cr="srgb-linear",fa="linear",Pt="srgb";var or=7680,bh=7681;var Mh=517;var lf=519,Vm=512,Gm=513,Wm=514,Rf=515,Xm=516,qm=517,Ym=518,$m=519,ic=35044;var Cf="300 es",Ii=2e3,da=2001;var Zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},In=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Lp=1234567,ao=Math.PI/180,ho=180/Math.PI;function ps(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(In[i&255]+In[i>>8&255]+In[i>>16&255]+In[i>>24&255]+"-"+In[e&255]+In[e>>8&255]+"-"+In[e>>16&15|64]+In[e>>24&255]+"-"+In[t&63|128]+In[t>>8&255]+"-"+In[t>>16&255]+In[t>>24&255]+In[n&255]+In[n>>8&255]+In[n>>16&255]+In[n>>24&255]).toLowerCase()}function it(i,e,t){return Math.max(e,Math.min(t,i))}function Pf(i,e){return(i%e+e)%e}function n_(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function i_(i,e,t){return i!==e?(t-i)/(e-i):0}function la(i,e,t){return(1-t)*i+t*e}function s_(i,e,t,n){return la(i,e,1-Math.exp(-t*n))}function r_(i,e=1){return e-Math.abs(Pf(i,e*2)-e)}function o_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function a_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function l_(i,e){return i+Math.floor(Math.random()*(e-i+1))}function c_(i,e){return i+Math.random()*(e-i)}function h_(i){return i*(.5-Math.random())}function u_(i){i!==void 0&&(Lp=i);let e=Lp+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function f_(i){return i*ao}function d_(i){return i*ho}function p_(i){return(i&i-1)===0&&i!==0}function m_(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function g_(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function v_(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),f=o((e-n)/2),m=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*g,l*m,a*c);break;case"YXY":i.set(l*m,a*u,l*g,a*c);break;case"ZYZ":i.set(l*g,l*m,a*u,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Pi(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Ct(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Xs={DEG2RAD:ao,RAD2DEG:ho,generateUUID:ps,clamp:it,euclideanModulo:Pf,mapLinear:n_,inverseLerp:i_,lerp:la,damp:s_,pingpong:r_,smoothstep:o_,smootherstep:a_,randInt:l_,randFloat:c_,randFloatSpread:h_,seededRandom:u_,degToRad:f_,radToDeg:d_,isPowerOfTwo:p_,ceilPowerOfTwo:m_,floorPowerOfTwo:g_,setQuaternionFromProperEuler:v_,normalize:Ct,denormalize:Pi},Oe=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(it(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},sn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],m=r[o+1],g=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=f,e[t+1]=m,e[t+2]=g,e[t+3]=v;return}if(h!==v||l!==f||c!==m||u!==g){let p=1-a,d=l*f+c*m+u*g+h*v,b=d>=0?1:-1,M=1-d*d;if(M>Number.EPSILON){let P=Math.sqrt(M),E=Math.atan2(P,d*b);p=Math.sin(p*E)/P,a=Math.sin(a*E)/P}let _=a*b;if(l=l*p+f*_,c=c*p+m*_,u=u*p+g*_,h=h*p+v*_,p===1-a){let P=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=P,c*=P,u*=P,h*=P}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],m=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*m-c*f,e[t+1]=l*g+u*f+c*h-a*m,e[t+2]=c*g+u*m+a*f-l*h,e[t+3]=u*g-a*h-l*f-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),m=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h-f*m*g;break;case"YXZ":this._x=f*u*h+c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h+f*m*g;break;case"ZXY":this._x=f*u*h-c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h-f*m*g;break;case"ZYX":this._x=f*u*h-c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h+f*m*g;break;case"YZX":this._x=f*u*h+c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h-f*m*g;break;case"XZY":this._x=f*u*h-c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h+f*m*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=n+a+h;if(f>0){let m=.5/Math.sqrt(f+1);this._w=.25/m,this._x=(u-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(n>a&&n>h){let m=2*Math.sqrt(1+n-a-h);this._w=(u-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>h){let m=2*Math.sqrt(1+a-n-h);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+u)/m}else{let m=2*Math.sqrt(1+h-n-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+u)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(it(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let m=1-t;return this._w=m*o+t*this._w,this._x=m*n+t*this._x,this._y=m*s+t*this._y,this._z=m*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,f=Math.sin(t*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},L=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Dp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Dp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this.z=it(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this.z=it(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Ru.copy(this).projectOnVector(e),this.sub(Ru)}reflect(e){return this.sub(Ru.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(it(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ru=new L,Dp=new sn,ct=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],m=n[5],g=n[8],v=s[0],p=s[3],d=s[6],b=s[1],M=s[4],_=s[7],P=s[2],E=s[5],I=s[8];return r[0]=o*v+a*b+l*P,r[3]=o*p+a*M+l*E,r[6]=o*d+a*_+l*I,r[1]=c*v+u*b+h*P,r[4]=c*p+u*M+h*E,r[7]=c*d+u*_+h*I,r[2]=f*v+m*b+g*P,r[5]=f*p+m*M+g*E,r[8]=f*d+m*_+g*I,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,m=c*r-o*l,g=t*h+n*f+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return e[0]=h*v,e[1]=(s*c-u*n)*v,e[2]=(a*n-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=m*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Cu.makeScale(e,t)),this}rotate(e){return this.premultiply(Cu.makeRotation(-e)),this}translate(e,t){return this.premultiply(Cu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Cu=new ct;function If(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function pa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Zm(){let i=pa("canvas");return i.style.display="block",i}var Up={};function uo(i){i in Up||(Up[i]=!0,console.warn(i))}function Km(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Np=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Fp=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function x_(){let i={enabled:!0,workingColorSpace:cr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=lo(s.r),s.g=lo(s.g),s.b=lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?fa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return uo("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return uo("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[cr]:{primaries:e,whitePoint:n,transfer:fa,toXYZ:Np,fromXYZ:Fp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Gn},outputColorSpaceConfig:{drawingBufferColorSpace:Gn}},[Gn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:Np,fromXYZ:Fp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Gn}}}),i}var xt=x_();function ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function lo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Gr,sc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Gr===void 0&&(Gr=pa("canvas")),Gr.width=e.width,Gr.height=e.height;let s=Gr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Gr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=pa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ms(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ms(t[n]/255)*255):t[n]=ms(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},__=0,fo=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:__++}),this.uuid=ps(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Pu(s[o].image)):r.push(Pu(s[o]))}else r=Pu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Pu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?sc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var y_=0,Iu=new L,Kn=class i extends Zi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Fs,s=Fs,r=Li,o=Gs,a=xi,l=Fi,c=i.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:y_++}),this.uuid=ps(),this.name="",this.source=new fo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Oe(0,0),this.repeat=new Oe(1,1),this.center=new Oe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Iu).x}get height(){return this.source.getSize(Iu).y}get depth(){return this.source.getSize(Iu).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==xf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ec:e.x=e.x-Math.floor(e.x);break;case Fs:e.x=e.x<0?0:1;break;case tc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ec:e.y=e.y-Math.floor(e.y);break;case Fs:e.y=e.y<0?0:1;break;case tc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=xf;Kn.DEFAULT_ANISOTROPY=1;var It=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],m=l[5],g=l[9],v=l[2],p=l[6],d=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+p)<.1&&Math.abs(c+m+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,_=(m+1)/2,P=(d+1)/2,E=(u+f)/4,I=(h+v)/4,D=(g+p)/4;return M>_&&M>P?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=E/n,r=I/n):_>P?_<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(_),n=E/s,r=D/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=I/r,s=D/r),this.set(n,s,r,t),this}let b=Math.sqrt((p-g)*(p-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(b)<.001&&(b=1),this.x=(p-g)/b,this.y=(h-v)/b,this.z=(f-u)/b,this.w=Math.acos((c+m+d-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this.z=it(this.z,e.z,t.z),this.w=it(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this.z=it(this.z,e,t),this.w=it(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},rc=class extends Zi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Li,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new It(0,0,e,t),this.scissorTest=!1,this.viewport=new It(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new Kn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:Li,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new fo(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ki=class extends rc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ma=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=vi,this.minFilter=vi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var oc=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=vi,this.minFilter=vi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var an=class{constructor(e=new L(1/0,1/0,1/0),t=new L(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ai.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ai.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ai.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(e.matrixWorld),this.expandByPoint(Ai);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ml.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ml.copy(n.boundingBox)),Ml.applyMatrix4(e.matrixWorld),this.union(Ml)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ai),Ai.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ea),wl.subVectors(this.max,ea),Wr.subVectors(e.a,ea),Xr.subVectors(e.b,ea),qr.subVectors(e.c,ea),Ps.subVectors(Xr,Wr),Is.subVectors(qr,Xr),nr.subVectors(Wr,qr);let t=[0,-Ps.z,Ps.y,0,-Is.z,Is.y,0,-nr.z,nr.y,Ps.z,0,-Ps.x,Is.z,0,-Is.x,nr.z,0,-nr.x,-Ps.y,Ps.x,0,-Is.y,Is.x,0,-nr.y,nr.x,0];return!Lu(t,Wr,Xr,qr,wl)||(t=[1,0,0,0,1,0,0,0,1],!Lu(t,Wr,Xr,qr,wl))?!1:(Sl.crossVectors(Ps,Is),t=[Sl.x,Sl.y,Sl.z],Lu(t,Wr,Xr,qr,wl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ai).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ai).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(cs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},cs=[new L,new L,new L,new L,new L,new L,new L,new L],Ai=new L,Ml=new an,Wr=new L,Xr=new L,qr=new L,Ps=new L,Is=new L,nr=new L,ea=new L,wl=new L,Sl=new L,ir=new L;function Lu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ir.fromArray(i,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=e.dot(ir),c=t.dot(ir),u=n.dot(ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var b_=new an,ta=new L,Du=new L,Di=class{constructor(e=new L,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):b_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ta.subVectors(e,this.center);let t=ta.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ta,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Du.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ta.copy(e.center).add(Du)),this.expandByPoint(ta.copy(e.center).sub(Du))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},hs=new L,Uu=new L,El=new L,Ls=new L,Nu=new L,Tl=new L,Fu=new L,hr=class{constructor(e=new L,t=new L(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,hs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=hs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(hs.copy(this.origin).addScaledVector(this.direction,t),hs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Uu.copy(e).add(t).multiplyScalar(.5),El.copy(t).sub(e).normalize(),Ls.copy(this.origin).sub(Uu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(El),a=Ls.dot(this.direction),l=-Ls.dot(El),c=Ls.lengthSq(),u=Math.abs(1-o*o),h,f,m,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let v=1/u;h*=v,f*=v,m=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),m=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),m=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),m=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Uu).addScaledVector(El,f),m}intersectSphere(e,t){hs.subVectors(e.center,this.origin);let n=hs.dot(this.direction),s=hs.dot(hs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,hs)!==null}intersectTriangle(e,t,n,s,r){Nu.subVectors(t,e),Tl.subVectors(n,e),Fu.crossVectors(Nu,Tl);let o=this.direction.dot(Fu),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ls.subVectors(this.origin,e);let l=a*this.direction.dot(Tl.crossVectors(Ls,Tl));if(l<0)return null;let c=a*this.direction.dot(Nu.cross(Ls));if(c<0||l+c>o)return null;let u=-a*Ls.dot(Fu);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ut=class i{constructor(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p)}set(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p){let d=this.elements;return d[0]=e,d[4]=t,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=h,d[14]=f,d[3]=m,d[7]=g,d[11]=v,d[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/Yr.setFromMatrixColumn(e,0).length(),r=1/Yr.setFromMatrixColumn(e,1).length(),o=1/Yr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,m=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=m+g*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=g+m*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,m=l*h,g=c*u,v=c*h;t[0]=f+v*a,t[4]=g*a-m,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=m*a-g,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,m=l*h,g=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=g+m*a,t[1]=m+g*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,m=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=g*c-m,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,m=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=g*h+m,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=m*h+g,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,m=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=m*h-g,t[2]=g*h-m,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(M_,e,w_)}lookAt(e,t,n){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Ds.crossVectors(n,si),Ds.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Ds.crossVectors(n,si)),Ds.normalize(),Al.crossVectors(si,Ds),s[0]=Ds.x,s[4]=Al.x,s[8]=si.x,s[1]=Ds.y,s[5]=Al.y,s[9]=si.y,s[2]=Ds.z,s[6]=Al.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],m=n[13],g=n[2],v=n[6],p=n[10],d=n[14],b=n[3],M=n[7],_=n[11],P=n[15],E=s[0],I=s[4],D=s[8],w=s[12],S=s[1],A=s[5],k=s[9],B=s[13],V=s[2],W=s[6],X=s[10],F=s[14],z=s[3],J=s[7],ne=s[11],te=s[15];return r[0]=o*E+a*S+l*V+c*z,r[4]=o*I+a*A+l*W+c*J,r[8]=o*D+a*k+l*X+c*ne,r[12]=o*w+a*B+l*F+c*te,r[1]=u*E+h*S+f*V+m*z,r[5]=u*I+h*A+f*W+m*J,r[9]=u*D+h*k+f*X+m*ne,r[13]=u*w+h*B+f*F+m*te,r[2]=g*E+v*S+p*V+d*z,r[6]=g*I+v*A+p*W+d*J,r[10]=g*D+v*k+p*X+d*ne,r[14]=g*w+v*B+p*F+d*te,r[3]=b*E+M*S+_*V+P*z,r[7]=b*I+M*A+_*W+P*J,r[11]=b*D+M*k+_*X+P*ne,r[15]=b*w+M*B+_*F+P*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],m=e[14],g=e[3],v=e[7],p=e[11],d=e[15];return g*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*m-n*l*m)+v*(+t*l*m-t*c*f+r*o*f-s*o*m+s*c*u-r*l*u)+p*(+t*c*h-t*a*m-r*o*h+n*o*m+r*a*u-n*c*u)+d*(-s*a*u-t*l*h+t*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],m=e[11],g=e[12],v=e[13],p=e[14],d=e[15],b=h*p*c-v*f*c+v*l*m-a*p*m-h*l*d+a*f*d,M=g*f*c-u*p*c-g*l*m+o*p*m+u*l*d-o*f*d,_=u*v*c-g*h*c+g*a*m-o*v*m-u*a*d+o*h*d,P=g*h*l-u*v*l-g*a*f+o*v*f+u*a*p-o*h*p,E=t*b+n*M+s*_+r*P;if(E===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let I=1/E;return e[0]=b*I,e[1]=(v*f*r-h*p*r-v*s*m+n*p*m+h*s*d-n*f*d)*I,e[2]=(a*p*r-v*l*r+v*s*c-n*p*c-a*s*d+n*l*d)*I,e[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*m-n*l*m)*I,e[4]=M*I,e[5]=(u*p*r-g*f*r+g*s*m-t*p*m-u*s*d+t*f*d)*I,e[6]=(g*l*r-o*p*r-g*s*c+t*p*c+o*s*d-t*l*d)*I,e[7]=(o*f*r-u*l*r+u*s*c-t*f*c-o*s*m+t*l*m)*I,e[8]=_*I,e[9]=(g*h*r-u*v*r-g*n*m+t*v*m+u*n*d-t*h*d)*I,e[10]=(o*v*r-g*a*r+g*n*c-t*v*c-o*n*d+t*a*d)*I,e[11]=(u*a*r-o*h*r-u*n*c+t*h*c+o*n*m-t*a*m)*I,e[12]=P*I,e[13]=(u*v*s-g*h*s+g*n*f-t*v*f-u*n*p+t*h*p)*I,e[14]=(g*a*s-o*v*s-g*n*l+t*v*l+o*n*p-t*a*p)*I,e[15]=(o*h*s-u*a*s+u*n*l-t*h*l-o*n*f+t*a*f)*I,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,m=r*u,g=r*h,v=o*u,p=o*h,d=a*h,b=l*c,M=l*u,_=l*h,P=n.x,E=n.y,I=n.z;return s[0]=(1-(v+d))*P,s[1]=(m+_)*P,s[2]=(g-M)*P,s[3]=0,s[4]=(m-_)*E,s[5]=(1-(f+d))*E,s[6]=(p+b)*E,s[7]=0,s[8]=(g+M)*I,s[9]=(p-b)*I,s[10]=(1-(f+v))*I,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=Yr.set(s[0],s[1],s[2]).length(),o=Yr.set(s[4],s[5],s[6]).length(),a=Yr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Ri.copy(this);let c=1/r,u=1/o,h=1/a;return Ri.elements[0]*=c,Ri.elements[1]*=c,Ri.elements[2]*=c,Ri.elements[4]*=u,Ri.elements[5]*=u,Ri.elements[6]*=u,Ri.elements[8]*=h,Ri.elements[9]*=h,Ri.elements[10]*=h,t.setFromRotationMatrix(Ri),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),f=(t+e)/(t-e),m=(n+s)/(n-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===Ii)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===da)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),f=-(t+e)/(t-e),m=-(n+s)/(n-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===Ii)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===da)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Yr=new L,Ri=new Ut,M_=new L(0,0,0),w_=new L(1,1,1),Ds=new L,Al=new L,si=new L,Op=new Ut,Bp=new sn,Ui=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(it(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-it(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(it(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-it(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(it(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-it(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Op.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Op,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Bp.setFromEuler(this),this.setFromQuaternion(Bp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ui.DEFAULT_ORDER="XYZ";var ga=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},S_=0,zp=new L,$r=new sn,us=new Ut,Rl=new L,na=new L,E_=new L,T_=new sn,kp=new L(1,0,0),Hp=new L(0,1,0),Vp=new L(0,0,1),Gp={type:"added"},A_={type:"removed"},Zr={type:"childadded",child:null},Ou={type:"childremoved",child:null},ln=class i extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:S_++}),this.uuid=ps(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new L,t=new Ui,n=new sn,s=new L(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ut},normalMatrix:{value:new ct}}),this.matrix=new Ut,this.matrixWorld=new Ut,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ga,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.multiply($r),this}rotateOnWorldAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.premultiply($r),this}rotateX(e){return this.rotateOnAxis(kp,e)}rotateY(e){return this.rotateOnAxis(Hp,e)}rotateZ(e){return this.rotateOnAxis(Vp,e)}translateOnAxis(e,t){return zp.copy(e).applyQuaternion(this.quaternion),this.position.add(zp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(kp,e)}translateY(e){return this.translateOnAxis(Hp,e)}translateZ(e){return this.translateOnAxis(Vp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(us.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Rl.copy(e):Rl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?us.lookAt(na,Rl,this.up):us.lookAt(Rl,na,this.up),this.quaternion.setFromRotationMatrix(us),s&&(us.extractRotation(s.matrixWorld),$r.setFromRotationMatrix(us),this.quaternion.premultiply($r.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Gp),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(A_),Ou.child=e,this.dispatchEvent(Ou),Ou.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),us.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),us.multiply(e.parent.matrixWorld)),e.applyMatrix4(us),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Gp),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,e,E_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,T_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),m=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};ln.DEFAULT_UP=new L(0,1,0);ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ci=new L,fs=new L,Bu=new L,ds=new L,Kr=new L,Jr=new L,Wp=new L,zu=new L,ku=new L,Hu=new L,Vu=new It,Gu=new It,Wu=new It,$i=class i{constructor(e=new L,t=new L,n=new L){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ci.subVectors(e,t),s.cross(Ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ci.subVectors(s,t),fs.subVectors(n,t),Bu.subVectors(e,t);let o=Ci.dot(Ci),a=Ci.dot(fs),l=Ci.dot(Bu),c=fs.dot(fs),u=fs.dot(Bu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,m=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-m-g,g,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ds)===null?!1:ds.x>=0&&ds.y>=0&&ds.x+ds.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ds.x),l.addScaledVector(o,ds.y),l.addScaledVector(a,ds.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Vu.setScalar(0),Gu.setScalar(0),Wu.setScalar(0),Vu.fromBufferAttribute(e,t),Gu.fromBufferAttribute(e,n),Wu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Vu,r.x),o.addScaledVector(Gu,r.y),o.addScaledVector(Wu,r.z),o}static isFrontFacing(e,t,n,s){return Ci.subVectors(n,t),fs.subVectors(e,t),Ci.cross(fs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ci.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ci.cross(fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Kr.subVectors(s,n),Jr.subVectors(r,n),zu.subVectors(e,n);let l=Kr.dot(zu),c=Jr.dot(zu);if(l<=0&&c<=0)return t.copy(n);ku.subVectors(e,s);let u=Kr.dot(ku),h=Jr.dot(ku);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(n).addScaledVector(Kr,o);Hu.subVectors(e,r);let m=Kr.dot(Hu),g=Jr.dot(Hu);if(g>=0&&m<=g)return t.copy(r);let v=m*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Jr,a);let p=u*g-m*h;if(p<=0&&h-u>=0&&m-g>=0)return Wp.subVectors(r,s),a=(h-u)/(h-u+(m-g)),t.copy(s).addScaledVector(Wp,a);let d=1/(p+v+f);return o=v*d,a=f*d,t.copy(n).addScaledVector(Kr,o).addScaledVector(Jr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Jm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Us={h:0,s:0,l:0},Cl={h:0,s:0,l:0};function Xu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var at=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Gn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=n,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=xt.workingColorSpace){if(e=Pf(e,1),t=it(t,0,1),n=it(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Xu(o,r,e+1/3),this.g=Xu(o,r,e),this.b=Xu(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=Gn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Gn){let n=Jm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ms(e.r),this.g=ms(e.g),this.b=ms(e.b),this}copyLinearToSRGB(e){return this.r=lo(e.r),this.g=lo(e.g),this.b=lo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Gn){return xt.workingToColorSpace(Ln.copy(this),e),Math.round(it(Ln.r*255,0,255))*65536+Math.round(it(Ln.g*255,0,255))*256+Math.round(it(Ln.b*255,0,255))}getHexString(e=Gn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Ln.copy(this),t);let n=Ln.r,s=Ln.g,r=Ln.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Ln.copy(this),t),e.r=Ln.r,e.g=Ln.g,e.b=Ln.b,e}getStyle(e=Gn){xt.workingToColorSpace(Ln.copy(this),e);let t=Ln.r,n=Ln.g,s=Ln.b;return e!==Gn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Us),this.setHSL(Us.h+e,Us.s+t,Us.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Us),e.getHSL(Cl);let n=la(Us.h,Cl.h,t),s=la(Us.s,Cl.s,t),r=la(Us.l,Cl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ln=new at;at.NAMES=Jm;var R_=0,Ji=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:R_++}),this.uuid=ps(),this.name="",this.type="Material",this.blending=ar,this.side=gs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=jl,this.blendDst=Ql,this.blendEquation=Os,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=lr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=lf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=or,this.stencilZFail=or,this.stencilZPass=or,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==ar&&(n.blending=this.blending),this.side!==gs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==jl&&(n.blendSrc=this.blendSrc),this.blendDst!==Ql&&(n.blendDst=this.blendDst),this.blendEquation!==Os&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==lr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==lf&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==or&&(n.stencilFail=this.stencilFail),this.stencilZFail!==or&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==or&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},oi=class extends Ji{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.combine=vf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var nn=new L,Pl=new Oe,C_=0,Jt=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:C_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=ic,this.updateRanges=[],this.gpuType=es,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Pl.fromBufferAttribute(this,t),Pl.applyMatrix3(e),this.setXY(t,Pl.x,Pl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix3(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix4(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyNormalMatrix(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.transformDirection(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ct(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Pi(t,this.array)),t}setX(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Pi(t,this.array)),t}setY(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Pi(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Pi(t,this.array)),t}setW(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array),r=Ct(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==ic&&(e.usage=this.usage),e}};var va=class extends Jt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var xa=class extends Jt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var mt=class extends Jt{constructor(e,t,n){super(new Float32Array(e),t,n)}},P_=0,gi=new Ut,qu=new ln,jr=new L,ri=new an,ia=new an,yn=new L,Ot=class i extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:P_++}),this.uuid=ps(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(If(e)?xa:va)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ct().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return gi.makeRotationFromQuaternion(e),this.applyMatrix4(gi),this}rotateX(e){return gi.makeRotationX(e),this.applyMatrix4(gi),this}rotateY(e){return gi.makeRotationY(e),this.applyMatrix4(gi),this}rotateZ(e){return gi.makeRotationZ(e),this.applyMatrix4(gi),this}translate(e,t,n){return gi.makeTranslation(e,t,n),this.applyMatrix4(gi),this}scale(e,t,n){return gi.makeScale(e,t,n),this.applyMatrix4(gi),this}lookAt(e){return qu.lookAt(e),qu.updateMatrix(),this.applyMatrix4(qu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jr).negate(),this.translate(jr.x,jr.y,jr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new an);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new L(-1/0,-1/0,-1/0),new L(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(yn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(yn),yn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(yn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new L,1/0);return}if(e){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(yn.addVectors(ri.min,ia.min),ri.expandByPoint(yn),yn.addVectors(ri.max,ia.max),ri.expandByPoint(yn)):(ri.expandByPoint(ia.min),ri.expandByPoint(ia.max))}ri.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)yn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(yn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)yn.fromBufferAttribute(a,c),l&&(jr.fromBufferAttribute(e,c),yn.add(jr)),s=Math.max(s,n.distanceToSquared(yn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Jt(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let D=0;D<n.count;D++)a[D]=new L,l[D]=new L;let c=new L,u=new L,h=new L,f=new Oe,m=new Oe,g=new Oe,v=new L,p=new L;function d(D,w,S){c.fromBufferAttribute(n,D),u.fromBufferAttribute(n,w),h.fromBufferAttribute(n,S),f.fromBufferAttribute(r,D),m.fromBufferAttribute(r,w),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),m.sub(f),g.sub(f);let A=1/(m.x*g.y-g.x*m.y);isFinite(A)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-m.y).multiplyScalar(A),p.copy(h).multiplyScalar(m.x).addScaledVector(u,-g.x).multiplyScalar(A),a[D].add(v),a[w].add(v),a[S].add(v),l[D].add(p),l[w].add(p),l[S].add(p))}let b=this.groups;b.length===0&&(b=[{start:0,count:e.count}]);for(let D=0,w=b.length;D<w;++D){let S=b[D],A=S.start,k=S.count;for(let B=A,V=A+k;B<V;B+=3)d(e.getX(B+0),e.getX(B+1),e.getX(B+2))}let M=new L,_=new L,P=new L,E=new L;function I(D){P.fromBufferAttribute(s,D),E.copy(P);let w=a[D];M.copy(w),M.sub(P.multiplyScalar(P.dot(w))).normalize(),_.crossVectors(E,w);let A=_.dot(l[D])<0?-1:1;o.setXYZW(D,M.x,M.y,M.z,A)}for(let D=0,w=b.length;D<w;++D){let S=b[D],A=S.start,k=S.count;for(let B=A,V=A+k;B<V;B+=3)I(e.getX(B+0)),I(e.getX(B+1)),I(e.getX(B+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Jt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,m=n.count;f<m;f++)n.setXYZ(f,0,0,0);let s=new L,r=new L,o=new L,a=new L,l=new L,c=new L,u=new L,h=new L;if(e)for(let f=0,m=e.count;f<m;f+=3){let g=e.getX(f+0),v=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,p),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,m=t.count;f<m;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)yn.fromBufferAttribute(e,t),yn.normalize(),e.setXYZ(t,yn.x,yn.y,yn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),m=0,g=0;for(let v=0,p=l.length;v<p;v++){a.isInterleavedBufferAttribute?m=l[v]*a.data.stride+a.offset:m=l[v]*u;for(let d=0;d<u;d++)f[g++]=c[m++]}return new Jt(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],m=e(f,n);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let m=c[h];u.push(m.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,m=h.length;f<m;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Xp=new Ut,sr=new hr,Il=new Di,qp=new L,Ll=new L,Dl=new L,Ul=new L,Yu=new L,Nl=new L,Yp=new L,Fl=new L,je=class extends ln{constructor(e=new Ot,t=new oi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Nl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Yu.fromBufferAttribute(h,e),o?Nl.addScaledVector(Yu,u):Nl.addScaledVector(Yu.sub(t),u))}t.add(Nl)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Il.copy(n.boundingSphere),Il.applyMatrix4(r),sr.copy(e.ray).recast(e.near),!(Il.containsPoint(sr.origin)===!1&&(sr.intersectSphere(Il,qp)===null||sr.origin.distanceToSquared(qp)>(e.far-e.near)**2))&&(Xp.copy(r).invert(),sr.copy(e.ray).applyMatrix4(Xp),!(n.boundingBox!==null&&sr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,sr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let p=f[g],d=o[p.materialIndex],b=Math.max(p.start,m.start),M=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let _=b,P=M;_<P;_+=3){let E=a.getX(_),I=a.getX(_+1),D=a.getX(_+2);s=Ol(this,d,e,n,c,u,h,E,I,D),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),v=Math.min(a.count,m.start+m.count);for(let p=g,d=v;p<d;p+=3){let b=a.getX(p),M=a.getX(p+1),_=a.getX(p+2);s=Ol(this,o,e,n,c,u,h,b,M,_),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let p=f[g],d=o[p.materialIndex],b=Math.max(p.start,m.start),M=Math.min(l.count,Math.min(p.start+p.count,m.start+m.count));for(let _=b,P=M;_<P;_+=3){let E=_,I=_+1,D=_+2;s=Ol(this,d,e,n,c,u,h,E,I,D),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),v=Math.min(l.count,m.start+m.count);for(let p=g,d=v;p<d;p+=3){let b=p,M=p+1,_=p+2;s=Ol(this,o,e,n,c,u,h,b,M,_),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function I_(i,e,t,n,s,r,o,a){let l;if(e.side===Wn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===gs,a),l===null)return null;Fl.copy(a),Fl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Fl);return c<t.near||c>t.far?null:{distance:c,point:Fl.clone(),object:i}}function Ol(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Ll),i.getVertexPosition(l,Dl),i.getVertexPosition(c,Ul);let u=I_(i,e,t,n,Ll,Dl,Ul,Yp);if(u){let h=new L;$i.getBarycoord(Yp,Ll,Dl,Ul,h),s&&(u.uv=$i.getInterpolatedAttribute(s,a,l,c,h,new Oe)),r&&(u.uv1=$i.getInterpolatedAttribute(r,a,l,c,h,new Oe)),o&&(u.normal=$i.getInterpolatedAttribute(o,a,l,c,h,new L),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new L,materialIndex:0};$i.getNormal(Ll,Dl,Ul,f.normal),u.face=f,u.barycoord=h}return u}var ji=class i extends Ot{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,m=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(h,2));function g(v,p,d,b,M,_,P,E,I,D,w){let S=_/I,A=P/D,k=_/2,B=P/2,V=E/2,W=I+1,X=D+1,F=0,z=0,J=new L;for(let ne=0;ne<X;ne++){let te=ne*A-B;for(let ce=0;ce<W;ce++){let fe=ce*S-k;J[v]=fe*b,J[p]=te*M,J[d]=V,c.push(J.x,J.y,J.z),J[v]=0,J[p]=0,J[d]=E>0?1:-1,u.push(J.x,J.y,J.z),h.push(ce/I),h.push(1-ne/D),F+=1}}for(let ne=0;ne<D;ne++)for(let te=0;te<I;te++){let ce=f+te+W*ne,fe=f+te+W*(ne+1),ye=f+(te+1)+W*(ne+1),_e=f+(te+1)+W*ne;l.push(ce,fe,_e),l.push(fe,ye,_e),z+=6}a.addGroup(m,z,w),m+=z,f+=F}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function xr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Un(i){let e={};for(let t=0;t<i.length;t++){let n=xr(i[t]);for(let s in n)e[s]=n[s]}return e}function L_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Lf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var Ya={clone:xr,merge:Un},D_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,U_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ai=class extends Ji{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=D_,this.fragmentShader=U_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=xr(e.uniforms),this.uniformsGroups=L_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},_a=class extends ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ut,this.projectionMatrix=new Ut,this.projectionMatrixInverse=new Ut,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Ns=new L,$p=new Oe,Zp=new Oe,Dn=class extends _a{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ho*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ao*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ho*2*Math.atan(Math.tan(ao*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z)}getViewSize(e,t){return this.getViewBounds(e,$p,Zp),t.subVectors(Zp,$p)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ao*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Qr=-90,eo=1,ac=class extends ln{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Dn(Qr,eo,e,t);s.layers=this.layers,this.add(s);let r=new Dn(Qr,eo,e,t);r.layers=this.layers,this.add(r);let o=new Dn(Qr,eo,e,t);o.layers=this.layers,this.add(o);let a=new Dn(Qr,eo,e,t);a.layers=this.layers,this.add(a);let l=new Dn(Qr,eo,e,t);l.layers=this.layers,this.add(l);let c=new Dn(Qr,eo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ii)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===da)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=v,e.setRenderTarget(n,5,s),e.render(t,u),e.setRenderTarget(h,f,m),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},ya=class extends Kn{constructor(e=[],t=gr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},lc=class extends Ki{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ya(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new ji(5,5,5),r=new ai({name:"CubemapFromEquirect",uniforms:xr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Wn,blending:xs});r.uniforms.tEquirect.value=t;let o=new je(s,r),a=t.minFilter;return t.minFilter===Gs&&(t.minFilter=Li),new ac(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},_t=class extends ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},N_={type:"move"},po=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new _t,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new _t,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new L,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new L),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new _t,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new L,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new L),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let p=t.getJointPose(v,n),d=this._getHandJoint(c,v);p!==null&&(d.matrix.fromArray(p.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=p.radius),d.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),m=.02,g=.005;c.inputState.pinching&&f>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(N_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new _t;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var mo=class extends ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ui,this.environmentIntensity=1,this.environmentRotation=new Ui,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},go=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=ic,this.updateRanges=[],this.version=0,this.uuid=ps()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);let t=new this.array.constructor(e.arrayBuffers[this.array.buffer._uuid]),n=new this.constructor(t,this.stride);return n.setUsage(this.usage),n}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){return e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}},Vn=new L,Jn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.applyMatrix4(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.applyNormalMatrix(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.transformDirection(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ct(n,this.array)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=Pi(t,this.array)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=Pi(t,this.array)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=Pi(t,this.array)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=Pi(t,this.array)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array),r=Ct(r,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Jt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}},vo=class extends Ji{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new at(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},to,sa=new L,no=new L,io=new L,so=new Oe,ra=new Oe,jm=new Ut,Bl=new L,oa=new L,zl=new L,Kp=new Oe,$u=new Oe,Jp=new Oe,ba=class extends ln{constructor(e=new vo){if(super(),this.isSprite=!0,this.type="Sprite",to===void 0){to=new Ot;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new go(t,5);to.setIndex([0,1,2,0,2,3]),to.setAttribute("position",new Jn(n,3,0,!1)),to.setAttribute("uv",new Jn(n,2,3,!1))}this.geometry=to,this.material=e,this.center=new Oe(.5,.5),this.count=1}raycast(e,t){e.camera===null&&console.error('THREE.Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),no.setFromMatrixScale(this.matrixWorld),jm.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),io.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&no.multiplyScalar(-io.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;kl(Bl.set(-.5,-.5,0),io,o,no,s,r),kl(oa.set(.5,-.5,0),io,o,no,s,r),kl(zl.set(.5,.5,0),io,o,no,s,r),Kp.set(0,0),$u.set(1,0),Jp.set(1,1);let a=e.ray.intersectTriangle(Bl,oa,zl,!1,sa);if(a===null&&(kl(oa.set(-.5,.5,0),io,o,no,s,r),$u.set(0,1),a=e.ray.intersectTriangle(Bl,zl,oa,!1,sa),a===null))return;let l=e.ray.origin.distanceTo(sa);l<e.near||l>e.far||t.push({distance:l,point:sa.clone(),uv:$i.getInterpolation(sa,Bl,oa,zl,Kp,$u,Jp,new Oe),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}};function kl(i,e,t,n,s,r){so.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(ra.x=r*so.x-s*so.y,ra.y=s*so.x+r*so.y):ra.copy(so),i.copy(e),i.x+=ra.x,i.y+=ra.y,i.applyMatrix4(jm)}var Zu=new L,F_=new L,O_=new ct,Zn=class{constructor(e=new L(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Zu.subVectors(n,t).cross(F_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(Zu),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||O_.getNormalMatrix(e),s=this.coplanarPoint(Zu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},rr=new Di,B_=new Oe(.5,.5),Hl=new L,xo=class{constructor(e=new Zn,t=new Zn,n=new Zn,s=new Zn,r=new Zn,o=new Zn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ii,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],m=r[7],g=r[8],v=r[9],p=r[10],d=r[11],b=r[12],M=r[13],_=r[14],P=r[15];if(s[0].setComponents(c-o,m-u,d-g,P-b).normalize(),s[1].setComponents(c+o,m+u,d+g,P+b).normalize(),s[2].setComponents(c+a,m+h,d+v,P+M).normalize(),s[3].setComponents(c-a,m-h,d-v,P-M).normalize(),n)s[4].setComponents(l,f,p,_).normalize(),s[5].setComponents(c-l,m-f,d-p,P-_).normalize();else if(s[4].setComponents(c-l,m-f,d-p,P-_).normalize(),t===Ii)s[5].setComponents(c+l,m+f,d+p,P+_).normalize();else if(t===da)s[5].setComponents(l,f,p,_).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(e){rr.center.set(0,0,0);let t=B_.distanceTo(e.center);return rr.radius=.7071067811865476+t,rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Hl.x=s.normal.x>0?e.max.x:e.min.x,Hl.y=s.normal.y>0?e.max.y:e.min.y,Hl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Hl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var vs=class extends Ji{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},cc=new L,hc=new L,jp=new Ut,aa=new hr,Vl=new Di,Ku=new L,Qp=new L,ur=class extends ln{constructor(e=new Ot,t=new vs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)cc.fromBufferAttribute(t,s-1),hc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=cc.distanceTo(hc);e.setAttribute("lineDistance",new mt(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Vl.copy(n.boundingSphere),Vl.applyMatrix4(s),Vl.radius+=r,e.ray.intersectsSphere(Vl)===!1)return;jp.copy(s).invert(),aa.copy(e.ray).applyMatrix4(jp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let m=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=m,p=g-1;v<p;v+=c){let d=u.getX(v),b=u.getX(v+1),M=Gl(this,e,aa,l,d,b,v);M&&t.push(M)}if(this.isLineLoop){let v=u.getX(g-1),p=u.getX(m),d=Gl(this,e,aa,l,v,p,g-1);d&&t.push(d)}}else{let m=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=m,p=g-1;v<p;v+=c){let d=Gl(this,e,aa,l,v,v+1,v);d&&t.push(d)}if(this.isLineLoop){let v=Gl(this,e,aa,l,g-1,m,g-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Gl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(cc.fromBufferAttribute(a,s),hc.fromBufferAttribute(a,r),t.distanceSqToSegment(cc,hc,Ku,Qp)>n)return;Ku.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Ku);if(!(c<e.near||c>e.far))return{distance:c,point:Qp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var em=new L,tm=new L,_o=class extends ur{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)em.fromBufferAttribute(t,s),tm.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+em.distanceTo(tm);e.setAttribute("lineDistance",new mt(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ma=class extends Kn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},wa=class extends Kn{constructor(e,t,n=Ws,s,r,o,a=vi,l=vi,c,u=co,h=1){if(u!==co&&u!==So)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new fo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},Sa=class extends Kn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var fr=class i extends Ot{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new L,u=new Oe;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=t;h++,f+=3){let m=n+h/t*s;c.x=e*Math.cos(m),c.y=e*Math.sin(m),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/e+1)/2,u.y=(o[f+1]/e+1)/2,l.push(u.x,u.y)}for(let h=1;h<=t;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new mt(o,3)),this.setAttribute("normal",new mt(a,3)),this.setAttribute("uv",new mt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},wn=class i extends Ot{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],m=[],g=0,v=[],p=n/2,d=0;b(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(m,2));function b(){let _=new L,P=new L,E=0,I=(t-e)/n;for(let D=0;D<=r;D++){let w=[],S=D/r,A=S*(t-e)+e;for(let k=0;k<=s;k++){let B=k/s,V=B*l+a,W=Math.sin(V),X=Math.cos(V);P.x=A*W,P.y=-S*n+p,P.z=A*X,h.push(P.x,P.y,P.z),_.set(W,I,X).normalize(),f.push(_.x,_.y,_.z),m.push(B,1-S),w.push(g++)}v.push(w)}for(let D=0;D<s;D++)for(let w=0;w<r;w++){let S=v[w][D],A=v[w+1][D],k=v[w+1][D+1],B=v[w][D+1];(e>0||w!==0)&&(u.push(S,A,B),E+=3),(t>0||w!==r-1)&&(u.push(A,k,B),E+=3)}c.addGroup(d,E,0),d+=E}function M(_){let P=g,E=new Oe,I=new L,D=0,w=_===!0?e:t,S=_===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,p*S,0),f.push(0,S,0),m.push(.5,.5),g++;let A=g;for(let k=0;k<=s;k++){let V=k/s*l+a,W=Math.cos(V),X=Math.sin(V);I.x=w*X,I.y=p*S,I.z=w*W,h.push(I.x,I.y,I.z),f.push(0,S,0),E.x=W*.5+.5,E.y=X*.5*S+.5,m.push(E.x,E.y),g++}for(let k=0;k<s;k++){let B=P+k,V=A+k;_===!0?u.push(V,V+1,B):u.push(V+1,V,B),D+=3}c.addGroup(d,D,_===!0?1:2),d+=D}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},dr=class i extends wn{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Wl=new L,Xl=new L,Ju=new L,ql=new $i,Ea=class extends Ot{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(ao*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},m=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:v,b:p,c:d}=ql;if(v.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),ql.getNormal(Ju),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,h[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let b=0;b<3;b++){let M=(b+1)%3,_=h[b],P=h[M],E=ql[u[b]],I=ql[u[M]],D=`${_}_${P}`,w=`${P}_${_}`;w in f&&f[w]?(Ju.dot(f[w].normal)<=r&&(m.push(E.x,E.y,E.z),m.push(I.x,I.y,I.z)),f[w]=null):D in f||(f[D]={index0:c[b],index1:c[M],normal:Ju.clone()})}}for(let g in f)if(f[g]){let{index0:v,index1:p}=f[g];Wl.fromBufferAttribute(a,v),Xl.fromBufferAttribute(a,p),m.push(Wl.x,Wl.y,Wl.z),m.push(Xl.x,Xl.y,Xl.z)}this.setAttribute("position",new mt(m,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},jn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let u=n[s],f=n[s+1]-u,m=(o-u)/f;return(s+m)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new Oe:new L);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new L,s=[],r=[],o=[],a=new L,l=new Ut;for(let m=0;m<=e;m++){let g=m/e;s[m]=this.getTangentAt(g,new L)}r[0]=new L,o[0]=new L;let c=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let m=1;m<=e;m++){if(r[m]=r[m-1].clone(),o[m]=o[m-1].clone(),a.crossVectors(s[m-1],s[m]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(it(s[m-1].dot(s[m]),-1,1));r[m].applyMatrix4(l.makeRotationAxis(a,g))}o[m].crossVectors(s[m],r[m])}if(t===!0){let m=Math.acos(it(r[0].dot(r[e]),-1,1));m/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(m=-m);for(let g=1;g<=e;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],m*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}},Ta=class extends jn{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new Oe){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,m=c-this.aY;l=f*u-m*h+this.aX,c=f*h+m*u+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},uc=class extends Ta{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Df(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,m=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,m*=u,s(o,a,f,m)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var Yl=new L,ju=new Df,Qu=new Df,ef=new Df,fc=class extends jn{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new L){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:(Yl.subVectors(s[0],s[1]).add(s[0]),c=Yl);let h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(Yl.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=Yl),this.curveType==="centripetal"||this.curveType==="chordal"){let m=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(h),m),v=Math.pow(h.distanceToSquared(f),m),p=Math.pow(f.distanceToSquared(u),m);v<1e-4&&(v=1),g<1e-4&&(g=v),p<1e-4&&(p=v),ju.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,g,v,p),Qu.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,g,v,p),ef.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,g,v,p)}else this.curveType==="catmullrom"&&(ju.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),Qu.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),ef.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(ju.calc(l),Qu.calc(l),ef.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new L().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function nm(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function z_(i,e){let t=1-i;return t*t*e}function k_(i,e){return 2*(1-i)*i*e}function H_(i,e){return i*i*e}function ca(i,e,t,n){return z_(i,e)+k_(i,t)+H_(i,n)}function V_(i,e){let t=1-i;return t*t*t*e}function G_(i,e){let t=1-i;return 3*t*t*i*e}function W_(i,e){return 3*(1-i)*i*i*e}function X_(i,e){return i*i*i*e}function ha(i,e,t,n,s){return V_(i,e)+G_(i,t)+W_(i,n)+X_(i,s)}var dc=class extends jn{constructor(e=new Oe,t=new Oe,n=new Oe,s=new Oe){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Oe){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ha(e,s.x,r.x,o.x,a.x),ha(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},pc=class extends jn{constructor(e=new L,t=new L,n=new L,s=new L){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new L){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ha(e,s.x,r.x,o.x,a.x),ha(e,s.y,r.y,o.y,a.y),ha(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},mc=class extends jn{constructor(e=new Oe,t=new Oe){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Oe){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Oe){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},gc=class extends jn{constructor(e=new L,t=new L){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new L){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new L){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},vc=class extends jn{constructor(e=new Oe,t=new Oe,n=new Oe){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Oe){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ca(e,s.x,r.x,o.x),ca(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Aa=class extends jn{constructor(e=new L,t=new L,n=new L){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new L){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ca(e,s.x,r.x,o.x),ca(e,s.y,r.y,o.y),ca(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},xc=class extends jn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Oe){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(nm(a,l.x,c.x,u.x,h.x),nm(a,l.y,c.y,u.y,h.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Oe().fromArray(s))}return this}},q_=Object.freeze({__proto__:null,ArcCurve:uc,CatmullRomCurve3:fc,CubicBezierCurve:dc,CubicBezierCurve3:pc,EllipseCurve:Ta,LineCurve:mc,LineCurve3:gc,QuadraticBezierCurve:vc,QuadraticBezierCurve3:Aa,SplineCurve:xc});var Ra=class i extends Ot{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,m=[],g=[],v=[],p=[];for(let d=0;d<u;d++){let b=d*f-o;for(let M=0;M<c;M++){let _=M*h-r;g.push(_,-b,0),v.push(0,0,1),p.push(M/a),p.push(1-d/l)}}for(let d=0;d<l;d++)for(let b=0;b<a;b++){let M=b+c*d,_=b+c*(d+1),P=b+1+c*(d+1),E=b+1+c*d;m.push(M,_,E),m.push(_,P,E)}this.setIndex(m),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(v,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ca=class i extends Ot{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new L,f=new L,m=[],g=[],v=[],p=[];for(let d=0;d<=n;d++){let b=[],M=d/n,_=0;d===0&&o===0?_=.5/t:d===n&&l===Math.PI&&(_=-.5/t);for(let P=0;P<=t;P++){let E=P/t;h.x=-e*Math.cos(s+E*r)*Math.sin(o+M*a),h.y=e*Math.cos(o+M*a),h.z=e*Math.sin(s+E*r)*Math.sin(o+M*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),p.push(E+_,1-M),b.push(c++)}u.push(b)}for(let d=0;d<n;d++)for(let b=0;b<t;b++){let M=u[d][b+1],_=u[d][b],P=u[d+1][b],E=u[d+1][b+1];(d!==0||o>0)&&m.push(M,_,E),(d!==n-1||l<Math.PI)&&m.push(_,P,E)}this.setIndex(m),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(v,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Pa=class i extends Ot{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],l=[],c=[],u=new L,h=new L,f=new L;for(let m=0;m<=n;m++)for(let g=0;g<=s;g++){let v=g/s*r,p=m/n*Math.PI*2;h.x=(e+t*Math.cos(p))*Math.cos(v),h.y=(e+t*Math.cos(p))*Math.sin(v),h.z=t*Math.sin(p),a.push(h.x,h.y,h.z),u.x=e*Math.cos(v),u.y=e*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(m/n)}for(let m=1;m<=n;m++)for(let g=1;g<=s;g++){let v=(s+1)*m+g-1,p=(s+1)*(m-1)+g-1,d=(s+1)*(m-1)+g,b=(s+1)*m+g;o.push(v,p,b),o.push(p,d,b)}this.setIndex(o),this.setAttribute("position",new mt(a,3)),this.setAttribute("normal",new mt(l,3)),this.setAttribute("uv",new mt(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}};var Ia=class i extends Ot{constructor(e=new Aa(new L(-1,-1,0),new L(-1,1,0),new L(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let o=e.computeFrenetFrames(t,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new L,l=new L,c=new Oe,u=new L,h=[],f=[],m=[],g=[];v(),this.setIndex(g),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(m,2));function v(){for(let M=0;M<t;M++)p(M);p(r===!1?t:0),b(),d()}function p(M){u=e.getPointAt(M/t,u);let _=o.normals[M],P=o.binormals[M];for(let E=0;E<=s;E++){let I=E/s*Math.PI*2,D=Math.sin(I),w=-Math.cos(I);l.x=w*_.x+D*P.x,l.y=w*_.y+D*P.y,l.z=w*_.z+D*P.z,l.normalize(),f.push(l.x,l.y,l.z),a.x=u.x+n*l.x,a.y=u.y+n*l.y,a.z=u.z+n*l.z,h.push(a.x,a.y,a.z)}}function d(){for(let M=1;M<=t;M++)for(let _=1;_<=s;_++){let P=(s+1)*(M-1)+(_-1),E=(s+1)*M+(_-1),I=(s+1)*M+_,D=(s+1)*(M-1)+_;g.push(P,E,D),g.push(E,I,D)}}function b(){for(let M=0;M<=t;M++)for(let _=0;_<=s;_++)c.x=M/t,c.y=_/s,m.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new q_[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}},La=class extends Ot{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new L,r=new L;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,m=h.count;for(let g=f,v=f+m;g<v;g+=3)for(let p=0;p<3;p++){let d=a.getX(g+p),b=a.getX(g+(p+1)%3);s.fromBufferAttribute(o,d),r.fromBufferAttribute(o,b),im(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),im(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new mt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function im(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var Ni=class extends Ji{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new at(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Af,this.normalScale=new Oe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var _c=class extends Ji{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=zm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},yc=class extends Ji{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function $l(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Y_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var pr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},bc=class extends pr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:rf,endingEnd:rf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case of:r=e,a=2*t-n;break;case af:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case of:o=e,l=2*n-t;break;case af:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,m=this._weightNext,g=(n-t)/(s-t),v=g*g,p=v*g,d=-f*p+2*f*v-f*g,b=(1+f)*p+(-1.5-2*f)*v+(-.5+f)*g+1,M=(-1-m)*p+(1.5+m)*v+.5*g,_=m*p-m*v;for(let P=0;P!==a;++P)r[P]=d*o[u+P]+b*o[c+P]+M*o[l+P]+_*o[h+P];return r}},Mc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},wc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},li=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=$l(t,this.TimeBufferType),this.values=$l(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:$l(e.times,Array),values:$l(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new wc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Mc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new bc(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case ua:t=this.InterpolantFactoryMethodDiscrete;break;case nc:t=this.InterpolantFactoryMethodLinear;break;case Jl:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ua;case this.InterpolantFactoryMethodLinear:return nc;case this.InterpolantFactoryMethodSmooth:return Jl}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Y_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Jl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,f=h-n,m=h+n;for(let g=0;g!==n;++g){let v=t[h+g];if(v!==t[f+g]||v!==t[m+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,f=o*n;for(let m=0;m!==n;++m)t[f+m]=t[h+m]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};li.prototype.ValueTypeName="";li.prototype.TimeBufferType=Float32Array;li.prototype.ValueBufferType=Float32Array;li.prototype.DefaultInterpolation=nc;var Bs=class extends li{constructor(e,t,n){super(e,t,n)}};Bs.prototype.ValueTypeName="bool";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=ua;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var Sc=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Sc.prototype.ValueTypeName="color";var Ec=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Ec.prototype.ValueTypeName="number";var Tc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)sn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Da=class extends li{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Tc(this.times,this.values,this.getValueSize(),e)}};Da.prototype.ValueTypeName="quaternion";Da.prototype.InterpolantFactoryMethodSmooth=void 0;var zs=class extends li{constructor(e,t,n){super(e,t,n)}};zs.prototype.ValueTypeName="string";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=ua;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ac=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Ac.prototype.ValueTypeName="vector";var Rc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let m=c[h],g=c[h+1];if(m.global&&(m.lastIndex=0),m.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},Qm=new Rc,Cc=class{constructor(e){this.manager=e!==void 0?e:Qm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};Cc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ua=class extends ln{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new at(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}},Na=class extends Ua{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new at(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}},tf=new Ut,sm=new L,rm=new L,cf=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Oe(512,512),this.mapType=Fi,this.map=null,this.mapPass=null,this.matrix=new Ut,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new xo,this._frameExtents=new Oe(1,1),this._viewportCount=1,this._viewports=[new It(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera,n=this.matrix;sm.setFromMatrixPosition(e.matrixWorld),t.position.copy(sm),rm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(rm),t.updateMatrixWorld(),tf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(tf,t.coordinateSystem,t.reversedDepth),t.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(tf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var mr=class extends _a{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},hf=class extends cf{constructor(){super(new mr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fa=class extends Ua{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.target=new ln,this.shadow=new hf}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}};var Oa=class extends Ot{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Pc=class extends Dn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var Uf="\\[\\]\\.:\\/",$_=new RegExp("["+Uf+"]","g"),Nf="[^"+Uf+"]",Z_="[^"+Uf.replace("\\.","")+"]",K_=/((?:WC+[\/:])*)/.source.replace("WC",Nf),J_=/(WCOD+)?/.source.replace("WCOD",Z_),j_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Nf),Q_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Nf),ey=new RegExp("^"+K_+J_+j_+Q_+"$"),ty=["material","materials","bones","map"],uf=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace($_,"")}static parseTrackName(e){let t=ey.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ty.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=uf;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var gA=new Float32Array(1);var ks=class extends go{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var yo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=it(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(it(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var om=new L,Zl=new L,ro=new L,oo=new L,nf=new L,ny=new L,iy=new L,Ba=class{constructor(e=new L,t=new L){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){om.subVectors(e,this.start),Zl.subVectors(this.end,this.start);let n=Zl.dot(Zl),r=Zl.dot(om)/n;return t&&(r=it(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=ny,n=iy){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;ro.subVectors(c,a),oo.subVectors(u,l),nf.subVectors(a,l);let h=ro.dot(ro),f=oo.dot(oo),m=oo.dot(nf);if(h<=s&&f<=s)return t.copy(a),n.copy(l),t.sub(n),t.dot(t);if(h<=s)r=0,o=m/f,o=it(o,0,1);else{let g=ro.dot(nf);if(f<=s)o=0,r=it(-g/h,0,1);else{let v=ro.dot(oo),p=h*f-v*v;p!==0?r=it((v*m-g*f)/p,0,1):r=0,o=(v*r+m)/f,o<0?(o=0,r=it(-g/h,0,1)):o>1&&(o=1,r=it((v-g)/h,0,1))}}return t.copy(a).add(ro.multiplyScalar(r)),n.copy(l).add(oo.multiplyScalar(o)),t.sub(n),t.dot(t)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var am=new L,Kl,sf,za=class extends ln{constructor(e=new L(0,0,1),t=new L(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",Kl===void 0&&(Kl=new Ot,Kl.setAttribute("position",new mt([0,0,0,0,1,0],3)),sf=new dr(.5,1,5,1),sf.translate(0,-.5,0)),this.position.copy(t),this.line=new ur(Kl,new vs({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new je(sf,new oi({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{am.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(am,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var ka=class extends Zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Ff(i,e,t,n){let s=sy(n);switch(t){case wf:return i*e;case Ef:return i*e/s.components*s.byteLength;case Wc:return i*e/s.components*s.byteLength;case Tf:return i*e*2/s.components*s.byteLength;case Xc:return i*e*2/s.components*s.byteLength;case Sf:return i*e*3/s.components*s.byteLength;case xi:return i*e*4/s.components*s.byteLength;case qc:return i*e*4/s.components*s.byteLength;case Ga:case Wa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Xa:case qa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case $c:case Kc:return Math.max(i,16)*Math.max(e,8)/4;case Yc:case Zc:return Math.max(i,8)*Math.max(e,8)/2;case Jc:case jc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Qc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case eh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case th:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case nh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case ih:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case sh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case rh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case oh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case ah:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case lh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case ch:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case hh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case uh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case fh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case dh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case ph:case mh:case gh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case vh:case xh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case _h:case yh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function sy(i){switch(i){case Fi:case _f:return{byteLength:1,components:1};case bo:case yf:case Mo:return{byteLength:2,components:1};case Vc:case Gc:return{byteLength:2,components:4};case Ws:case Hc:case es:return{byteLength:4,components:1};case bf:case Mf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function wg(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function hy(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((m,g)=>m.start-g.start);let f=0;for(let m=1;m<h.length;m++){let g=h[f],v=h[m];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let m=0,g=h.length;m<g;m++){let v=h[m];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var uy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,fy=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,dy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,py=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,my=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,gy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,vy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,xy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,_y=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,yy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,by=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,My=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,wy=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Sy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Ey=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Ty=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ay=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Ry=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Cy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Py=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Iy=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Ly=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Dy=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,Uy=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Ny=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,Fy=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,Oy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,By=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,zy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ky=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Hy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Vy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Gy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,Wy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Xy=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,qy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Yy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,$y=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Zy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ky=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Jy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,jy=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Qy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,eb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,tb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,nb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,ib=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,sb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,rb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ob=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,ab=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,lb=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,cb=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,hb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,ub=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,fb=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,db=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,pb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,mb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,gb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,vb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,xb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,_b=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,yb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,bb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Mb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,wb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Sb=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Eb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Tb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Ab=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Rb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Cb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Pb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ib=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Lb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Db=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Ub=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Nb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Fb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Ob=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Bb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,zb=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,kb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Hb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Vb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Gb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Wb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Xb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,qb=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		float depth = unpackRGBAToDepth( texture2D( depths, uv ) );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			return step( depth, compare );
		#else
			return step( compare, depth );
		#endif
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow( sampler2D shadow, vec2 uv, float compare ) {
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			float hard_shadow = step( distribution.x, compare );
		#else
			float hard_shadow = step( compare, distribution.x );
		#endif
		if ( hard_shadow != 1.0 ) {
			float distance = compare - distribution.x;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,Yb=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,$b=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Zb=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Kb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Jb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,jb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Qb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,eM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,tM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,nM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,iM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,sM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,rM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,oM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,aM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,lM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,cM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,hM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,uM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,dM=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,pM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,vM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,xM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,_M=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,yM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,MM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,wM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,SM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,EM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,TM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,AM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,RM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,CM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,PM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,IM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,LM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,DM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,NM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,FM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,OM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,BM=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,zM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,kM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,HM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,VM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,GM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ft={alphahash_fragment:uy,alphahash_pars_fragment:fy,alphamap_fragment:dy,alphamap_pars_fragment:py,alphatest_fragment:my,alphatest_pars_fragment:gy,aomap_fragment:vy,aomap_pars_fragment:xy,batching_pars_vertex:_y,batching_vertex:yy,begin_vertex:by,beginnormal_vertex:My,bsdfs:wy,iridescence_fragment:Sy,bumpmap_pars_fragment:Ey,clipping_planes_fragment:Ty,clipping_planes_pars_fragment:Ay,clipping_planes_pars_vertex:Ry,clipping_planes_vertex:Cy,color_fragment:Py,color_pars_fragment:Iy,color_pars_vertex:Ly,color_vertex:Dy,common:Uy,cube_uv_reflection_fragment:Ny,defaultnormal_vertex:Fy,displacementmap_pars_vertex:Oy,displacementmap_vertex:By,emissivemap_fragment:zy,emissivemap_pars_fragment:ky,colorspace_fragment:Hy,colorspace_pars_fragment:Vy,envmap_fragment:Gy,envmap_common_pars_fragment:Wy,envmap_pars_fragment:Xy,envmap_pars_vertex:qy,envmap_physical_pars_fragment:ib,envmap_vertex:Yy,fog_vertex:$y,fog_pars_vertex:Zy,fog_fragment:Ky,fog_pars_fragment:Jy,gradientmap_pars_fragment:jy,lightmap_pars_fragment:Qy,lights_lambert_fragment:eb,lights_lambert_pars_fragment:tb,lights_pars_begin:nb,lights_toon_fragment:sb,lights_toon_pars_fragment:rb,lights_phong_fragment:ob,lights_phong_pars_fragment:ab,lights_physical_fragment:lb,lights_physical_pars_fragment:cb,lights_fragment_begin:hb,lights_fragment_maps:ub,lights_fragment_end:fb,logdepthbuf_fragment:db,logdepthbuf_pars_fragment:pb,logdepthbuf_pars_vertex:mb,logdepthbuf_vertex:gb,map_fragment:vb,map_pars_fragment:xb,map_particle_fragment:_b,map_particle_pars_fragment:yb,metalnessmap_fragment:bb,metalnessmap_pars_fragment:Mb,morphinstance_vertex:wb,morphcolor_vertex:Sb,morphnormal_vertex:Eb,morphtarget_pars_vertex:Tb,morphtarget_vertex:Ab,normal_fragment_begin:Rb,normal_fragment_maps:Cb,normal_pars_fragment:Pb,normal_pars_vertex:Ib,normal_vertex:Lb,normalmap_pars_fragment:Db,clearcoat_normal_fragment_begin:Ub,clearcoat_normal_fragment_maps:Nb,clearcoat_pars_fragment:Fb,iridescence_pars_fragment:Ob,opaque_fragment:Bb,packing:zb,premultiplied_alpha_fragment:kb,project_vertex:Hb,dithering_fragment:Vb,dithering_pars_fragment:Gb,roughnessmap_fragment:Wb,roughnessmap_pars_fragment:Xb,shadowmap_pars_fragment:qb,shadowmap_pars_vertex:Yb,shadowmap_vertex:$b,shadowmask_pars_fragment:Zb,skinbase_vertex:Kb,skinning_pars_vertex:Jb,skinning_vertex:jb,skinnormal_vertex:Qb,specularmap_fragment:eM,specularmap_pars_fragment:tM,tonemapping_fragment:nM,tonemapping_pars_fragment:iM,transmission_fragment:sM,transmission_pars_fragment:rM,uv_pars_fragment:oM,uv_pars_vertex:aM,uv_vertex:lM,worldpos_vertex:cM,background_vert:hM,background_frag:uM,backgroundCube_vert:fM,backgroundCube_frag:dM,cube_vert:pM,cube_frag:mM,depth_vert:gM,depth_frag:vM,distanceRGBA_vert:xM,distanceRGBA_frag:_M,equirect_vert:yM,equirect_frag:bM,linedashed_vert:MM,linedashed_frag:wM,meshbasic_vert:SM,meshbasic_frag:EM,meshlambert_vert:TM,meshlambert_frag:AM,meshmatcap_vert:RM,meshmatcap_frag:CM,meshnormal_vert:PM,meshnormal_frag:IM,meshphong_vert:LM,meshphong_frag:DM,meshphysical_vert:UM,meshphysical_frag:NM,meshtoon_vert:FM,meshtoon_frag:OM,points_vert:BM,points_frag:zM,shadow_vert:kM,shadow_frag:HM,sprite_vert:VM,sprite_frag:GM},De={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new Oe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new Oe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},Xn={basic:{uniforms:Un([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Un([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new at(0)}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Un([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Un([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Un([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new at(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Un([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Un([De.points,De.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Un([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Un([De.common,De.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Un([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Un([De.sprite,De.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distanceRGBA:{uniforms:Un([De.common,De.displacementmap,{referencePosition:{value:new L},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distanceRGBA_vert,fragmentShader:ft.distanceRGBA_frag},shadow:{uniforms:Un([De.lights,De.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};Xn.physical={uniforms:Un([Xn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new Oe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new Oe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new Oe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var wh={r:0,b:0,g:0},_r=new Ui,WM=new Ut;function XM(i,e,t,n,s,r,o){let a=new at(0),l=r===!0?0:1,c,u,h=null,f=0,m=null;function g(M){let _=M.isScene===!0?M.background:null;return _&&_.isTexture&&(_=(M.backgroundBlurriness>0?t:e).get(_)),_}function v(M){let _=!1,P=g(M);P===null?d(a,l):P&&P.isColor&&(d(P,1),_=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?n.buffers.color.setClear(0,0,0,1,o):E==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||_)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function p(M,_){let P=g(_);P&&(P.isCubeTexture||P.mapping===Ha)?(u===void 0&&(u=new je(new ji(1,1,1),new ai({name:"BackgroundCubeMaterial",uniforms:xr(Xn.backgroundCube.uniforms),vertexShader:Xn.backgroundCube.vertexShader,fragmentShader:Xn.backgroundCube.fragmentShader,side:Wn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(E,I,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),_r.copy(_.backgroundRotation),_r.x*=-1,_r.y*=-1,_r.z*=-1,P.isCubeTexture&&P.isRenderTargetTexture===!1&&(_r.y*=-1,_r.z*=-1),u.material.uniforms.envMap.value=P,u.material.uniforms.flipEnvMap.value=P.isCubeTexture&&P.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(WM.makeRotationFromEuler(_r)),u.material.toneMapped=xt.getTransfer(P.colorSpace)!==Pt,(h!==P||f!==P.version||m!==i.toneMapping)&&(u.material.needsUpdate=!0,h=P,f=P.version,m=i.toneMapping),u.layers.enableAll(),M.unshift(u,u.geometry,u.material,0,0,null)):P&&P.isTexture&&(c===void 0&&(c=new je(new Ra(2,2),new ai({name:"BackgroundMaterial",uniforms:xr(Xn.background.uniforms),vertexShader:Xn.background.vertexShader,fragmentShader:Xn.background.fragmentShader,side:gs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=P,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,c.material.toneMapped=xt.getTransfer(P.colorSpace)!==Pt,P.matrixAutoUpdate===!0&&P.updateMatrix(),c.material.uniforms.uvTransform.value.copy(P.matrix),(h!==P||f!==P.version||m!==i.toneMapping)&&(c.material.needsUpdate=!0,h=P,f=P.version,m=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function d(M,_){M.getRGB(wh,Lf(i)),n.buffers.color.setClear(wh.r,wh.g,wh.b,_,o)}function b(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,_=1){a.set(M),l=_,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(M){l=M,d(a,l)},render:v,addToRenderList:p,dispose:b}}function qM(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(S,A,k,B,V){let W=!1,X=h(B,k,A);r!==X&&(r=X,c(r.object)),W=m(S,B,k,V),W&&g(S,B,k,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,_(S,A,k,B),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function u(S){return i.deleteVertexArray(S)}function h(S,A,k){let B=k.wireframe===!0,V=n[S.id];V===void 0&&(V={},n[S.id]=V);let W=V[A.id];W===void 0&&(W={},V[A.id]=W);let X=W[B];return X===void 0&&(X=f(l()),W[B]=X),X}function f(S){let A=[],k=[],B=[];for(let V=0;V<t;V++)A[V]=0,k[V]=0,B[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:A,enabledAttributes:k,attributeDivisors:B,object:S,attributes:{},index:null}}function m(S,A,k,B){let V=r.attributes,W=A.attributes,X=0,F=k.getAttributes();for(let z in F)if(F[z].location>=0){let ne=V[z],te=W[z];if(te===void 0&&(z==="instanceMatrix"&&S.instanceMatrix&&(te=S.instanceMatrix),z==="instanceColor"&&S.instanceColor&&(te=S.instanceColor)),ne===void 0||ne.attribute!==te||te&&ne.data!==te.data)return!0;X++}return r.attributesNum!==X||r.index!==B}function g(S,A,k,B){let V={},W=A.attributes,X=0,F=k.getAttributes();for(let z in F)if(F[z].location>=0){let ne=W[z];ne===void 0&&(z==="instanceMatrix"&&S.instanceMatrix&&(ne=S.instanceMatrix),z==="instanceColor"&&S.instanceColor&&(ne=S.instanceColor));let te={};te.attribute=ne,ne&&ne.data&&(te.data=ne.data),V[z]=te,X++}r.attributes=V,r.attributesNum=X,r.index=B}function v(){let S=r.newAttributes;for(let A=0,k=S.length;A<k;A++)S[A]=0}function p(S){d(S,0)}function d(S,A){let k=r.newAttributes,B=r.enabledAttributes,V=r.attributeDivisors;k[S]=1,B[S]===0&&(i.enableVertexAttribArray(S),B[S]=1),V[S]!==A&&(i.vertexAttribDivisor(S,A),V[S]=A)}function b(){let S=r.newAttributes,A=r.enabledAttributes;for(let k=0,B=A.length;k<B;k++)A[k]!==S[k]&&(i.disableVertexAttribArray(k),A[k]=0)}function M(S,A,k,B,V,W,X){X===!0?i.vertexAttribIPointer(S,A,k,V,W):i.vertexAttribPointer(S,A,k,B,V,W)}function _(S,A,k,B){v();let V=B.attributes,W=k.getAttributes(),X=A.defaultAttributeValues;for(let F in W){let z=W[F];if(z.location>=0){let J=V[F];if(J===void 0&&(F==="instanceMatrix"&&S.instanceMatrix&&(J=S.instanceMatrix),F==="instanceColor"&&S.instanceColor&&(J=S.instanceColor)),J!==void 0){let ne=J.normalized,te=J.itemSize,ce=e.get(J);if(ce===void 0)continue;let fe=ce.buffer,ye=ce.type,_e=ce.bytesPerElement,ee=ye===i.INT||ye===i.UNSIGNED_INT||J.gpuType===Hc;if(J.isInterleavedBufferAttribute){let $=J.data,me=$.stride,ve=J.offset;if($.isInstancedInterleavedBuffer){for(let be=0;be<z.locationSize;be++)d(z.location+be,$.meshPerAttribute);S.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=$.meshPerAttribute*$.count)}else for(let be=0;be<z.locationSize;be++)p(z.location+be);i.bindBuffer(i.ARRAY_BUFFER,fe);for(let be=0;be<z.locationSize;be++)M(z.location+be,te/z.locationSize,ye,ne,me*_e,(ve+te/z.locationSize*be)*_e,ee)}else{if(J.isInstancedBufferAttribute){for(let $=0;$<z.locationSize;$++)d(z.location+$,J.meshPerAttribute);S.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let $=0;$<z.locationSize;$++)p(z.location+$);i.bindBuffer(i.ARRAY_BUFFER,fe);for(let $=0;$<z.locationSize;$++)M(z.location+$,te/z.locationSize,ye,ne,te*_e,te/z.locationSize*$*_e,ee)}}else if(X!==void 0){let ne=X[F];if(ne!==void 0)switch(ne.length){case 2:i.vertexAttrib2fv(z.location,ne);break;case 3:i.vertexAttrib3fv(z.location,ne);break;case 4:i.vertexAttrib4fv(z.location,ne);break;default:i.vertexAttrib1fv(z.location,ne)}}}}b()}function P(){D();for(let S in n){let A=n[S];for(let k in A){let B=A[k];for(let V in B)u(B[V].object),delete B[V];delete A[k]}delete n[S]}}function E(S){if(n[S.id]===void 0)return;let A=n[S.id];for(let k in A){let B=A[k];for(let V in B)u(B[V].object),delete B[V];delete A[k]}delete n[S.id]}function I(S){for(let A in n){let k=n[A];if(k[S.id]===void 0)continue;let B=k[S.id];for(let V in B)u(B[V].object),delete B[V];delete k[S.id]}}function D(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:w,dispose:P,releaseStatesOfGeometry:E,releaseStatesOfProgram:I,initAttributes:v,enableAttribute:p,disableUnusedAttributes:b}}function YM(i,e,t){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),t.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),t.update(u,n,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let m=0;for(let g=0;g<h;g++)m+=u[g];t.update(m,n,1)}function l(c,u,h,f){if(h===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{m.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];t.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function $M(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let I=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(I.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(I){return!(I!==xi&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(I){let D=I===Mo&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(I!==Fi&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&I!==es&&!D)}function l(I){if(I==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";I="mediump"}return I==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.logarithmicDepthBuffer===!0,f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),_=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=g>0,E=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:p,maxAttributes:d,maxVertexUniforms:b,maxVaryings:M,maxFragmentUniforms:_,vertexTextures:P,maxSamples:E}}function ZM(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Zn,a=new ct,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let m=h.length!==0||f||n!==0||s;return s=f,n=h.length,m},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,m){let g=h.clippingPlanes,v=h.clipIntersection,p=h.clipShadows,d=i.get(h);if(!s||g===null||g.length===0||r&&!p)r?u(null):c();else{let b=r?0:n,M=b*4,_=d.clippingState||null;l.value=_,_=u(g,f,M,m);for(let P=0;P!==M;++P)_[P]=t[P];d.clippingState=_,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,f,m,g){let v=h!==null?h.length:0,p=null;if(v!==0){if(p=l.value,g!==!0||p===null){let d=m+v*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(p===null||p.length<d)&&(p=new Float32Array(d));for(let M=0,_=m;M!==v;++M,_+=4)o.copy(h[M]).applyMatrix4(b,a),o.normal.toArray(p,_),p[_+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,p}}function KM(i){let e=new WeakMap;function t(o,a){return a===Bc?o.mapping=gr:a===zc&&(o.mapping=vr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Bc||a===zc)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new lc(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var To=4,eg=[.125,.215,.35,.446,.526,.582],Mr=20,Of=new mr,tg=new at,Bf=null,zf=0,kf=0,Hf=!1,br=(1+Math.sqrt(5))/2,Eo=1/br,ng=[new L(-br,Eo,0),new L(br,Eo,0),new L(-Eo,0,br),new L(Eo,0,br),new L(0,br,-Eo),new L(0,br,Eo),new L(-1,1,-1),new L(1,1,-1),new L(-1,1,1),new L(1,1,1)],JM=new L,Th=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=JM}=r;Bf=this._renderer.getRenderTarget(),zf=this._renderer.getActiveCubeFace(),kf=this._renderer.getActiveMipmapLevel(),Hf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=rg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=sg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Bf,zf,kf),this._renderer.xr.enabled=Hf,e.scissorTest=!1,Sh(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===gr||e.mapping===vr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Bf=this._renderer.getRenderTarget(),zf=this._renderer.getActiveCubeFace(),kf=this._renderer.getActiveMipmapLevel(),Hf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:Li,minFilter:Li,generateMipmaps:!1,type:Mo,format:xi,colorSpace:cr,depthBuffer:!1},s=ig(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=ig(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=jM(r)),this._blurMaterial=QM(r,e,t)}return s}_compileMaterial(e){let t=new je(this._lodPlanes[0],e);this._renderer.compile(t,Of)}_sceneToCubeUV(e,t,n,s,r){let l=new Dn(90,1,t,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,m=h.toneMapping;h.getClearColor(tg),h.toneMapping=_s,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let v=new oi({name:"PMREM.Background",side:Wn,depthWrite:!1,depthTest:!1}),p=new je(new ji,v),d=!1,b=e.background;b?b.isColor&&(v.color.copy(b),e.background=null,d=!0):(v.color.copy(tg),d=!0);for(let M=0;M<6;M++){let _=M%3;_===0?(l.up.set(0,c[M],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[M],r.y,r.z)):_===1?(l.up.set(0,0,c[M]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[M],r.z)):(l.up.set(0,c[M],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[M]));let P=this._cubeSize;Sh(s,_*P,M>2?P:0,P,P),h.setRenderTarget(s),d&&h.render(p,l),h.render(e,l)}p.geometry.dispose(),p.material.dispose(),h.toneMapping=m,h.autoClear=f,e.background=b}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===gr||e.mapping===vr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=rg()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=sg());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new je(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Sh(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,Of)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=ng[(s-r-1)%ng.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new je(this._lodPlanes[s],c),f=c.uniforms,m=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*m):2*Math.PI/(2*Mr-1),v=r/g,p=isFinite(r)?1+Math.floor(u*v):Mr;p>Mr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${Mr}`);let d=[],b=0;for(let I=0;I<Mr;++I){let D=I/v,w=Math.exp(-D*D/2);d.push(w),I===0?b+=w:I<p&&(b+=2*w)}for(let I=0;I<d.length;I++)d[I]=d[I]/b;f.envMap.value=e.texture,f.samples.value=p,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:M}=this;f.dTheta.value=g,f.mipInt.value=M-n;let _=this._sizeLods[s],P=3*_*(s>M-To?s-M+To:0),E=4*(this._cubeSize-_);Sh(t,P,E,3*_,2*_),l.setRenderTarget(t),l.render(h,Of)}};function jM(i){let e=[],t=[],n=[],s=i,r=i-To+1+eg.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>i-To?l=eg[o-i+To-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],m=6,g=6,v=3,p=2,d=1,b=new Float32Array(v*g*m),M=new Float32Array(p*g*m),_=new Float32Array(d*g*m);for(let E=0;E<m;E++){let I=E%3*2/3-1,D=E>2?0:-1,w=[I,D,0,I+2/3,D,0,I+2/3,D+1,0,I,D,0,I+2/3,D+1,0,I,D+1,0];b.set(w,v*g*E),M.set(f,p*g*E);let S=[E,E,E,E,E,E];_.set(S,d*g*E)}let P=new Ot;P.setAttribute("position",new Jt(b,v)),P.setAttribute("uv",new Jt(M,p)),P.setAttribute("faceIndex",new Jt(_,d)),e.push(P),s>To&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function ig(i,e,t){let n=new Ki(i,e,t);return n.texture.mapping=Ha,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Sh(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function QM(i,e,t){let n=new Float32Array(Mr),s=new L(0,1,0);return new ai({name:"SphericalGaussianBlur",defines:{n:Mr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Jf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:xs,depthTest:!1,depthWrite:!1})}function sg(){return new ai({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Jf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:xs,depthTest:!1,depthWrite:!1})}function rg(){return new ai({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Jf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:xs,depthTest:!1,depthWrite:!1})}function Jf(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function ew(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Bc||l===zc,u=l===gr||l===vr;if(c||u){let h=e.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new Th(i)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{let m=a.image;return c&&m&&m.height>0||u&&m&&s(m)?(t===null&&(t=new Th(i)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function tw(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&uo("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function nw(i,e,t,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&e.remove(f.index);for(let g in f.attributes)e.remove(f.attributes[g]);f.removeEventListener("dispose",o),delete s[f.id];let m=r.get(f);m&&(e.remove(m),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(h){let f=h.attributes;for(let m in f)e.update(f[m],i.ARRAY_BUFFER)}function c(h){let f=[],m=h.index,g=h.attributes.position,v=0;if(m!==null){let b=m.array;v=m.version;for(let M=0,_=b.length;M<_;M+=3){let P=b[M+0],E=b[M+1],I=b[M+2];f.push(P,E,E,I,I,P)}}else if(g!==void 0){let b=g.array;v=g.version;for(let M=0,_=b.length/3-1;M<_;M+=3){let P=M+0,E=M+1,I=M+2;f.push(P,E,E,I,I,P)}}else return;let p=new(If(f)?xa:va)(f,1);p.version=v;let d=r.get(h);d&&e.remove(d),r.set(h,p)}function u(h){let f=r.get(h);if(f){let m=h.index;m!==null&&f.version<m.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function iw(i,e,t){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,m){i.drawElements(n,m,r,f*o),t.update(m,n,1)}function c(f,m,g){g!==0&&(i.drawElementsInstanced(n,m,r,f*o,g),t.update(m,n,g))}function u(f,m,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,m,0,r,f,0,g);let p=0;for(let d=0;d<g;d++)p+=m[d];t.update(p,n,1)}function h(f,m,g,v){if(g===0)return;let p=e.get("WEBGL_multi_draw");if(p===null)for(let d=0;d<f.length;d++)c(f[d]/o,m[d],v[d]);else{p.multiDrawElementsInstancedWEBGL(n,m,0,r,f,0,v,0,g);let d=0;for(let b=0;b<g;b++)d+=m[b]*v[b];t.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function sw(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function rw(i,e,t){let n=new WeakMap,s=new It;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let w=function(){I.dispose(),n.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();let m=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],M=0;m===!0&&(M=1),g===!0&&(M=2),v===!0&&(M=3);let _=a.attributes.position.count*M,P=1;_>e.maxTextureSize&&(P=Math.ceil(_/e.maxTextureSize),_=e.maxTextureSize);let E=new Float32Array(_*P*4*h),I=new ma(E,_,P,h);I.type=es,I.needsUpdate=!0;let D=M*4;for(let S=0;S<h;S++){let A=p[S],k=d[S],B=b[S],V=_*P*4*S;for(let W=0;W<A.count;W++){let X=W*D;m===!0&&(s.fromBufferAttribute(A,W),E[V+X+0]=s.x,E[V+X+1]=s.y,E[V+X+2]=s.z,E[V+X+3]=0),g===!0&&(s.fromBufferAttribute(k,W),E[V+X+4]=s.x,E[V+X+5]=s.y,E[V+X+6]=s.z,E[V+X+7]=0),v===!0&&(s.fromBufferAttribute(B,W),E[V+X+8]=s.x,E[V+X+9]=s.y,E[V+X+10]=s.z,E[V+X+11]=B.itemSize===4?s.w:1)}}f={count:h,texture:I,size:new Oe(_,P)},n.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let m=0;for(let v=0;v<c.length;v++)m+=c[v];let g=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function ow(i,e,t,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var Sg=new Kn,og=new wa(1,1),Eg=new ma,Tg=new oc,Ag=new ya,ag=[],lg=[],cg=new Float32Array(16),hg=new Float32Array(9),ug=new Float32Array(4);function Ro(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=ag[s];if(r===void 0&&(r=new Float32Array(s),ag[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function cn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function hn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Rh(i,e){let t=lg[e];t===void 0&&(t=new Int32Array(e),lg[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function aw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function lw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2fv(this.addr,e),hn(t,e)}}function cw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(cn(t,e))return;i.uniform3fv(this.addr,e),hn(t,e)}}function hw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4fv(this.addr,e),hn(t,e)}}function uw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;ug.set(n),i.uniformMatrix2fv(this.addr,!1,ug),hn(t,n)}}function fw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;hg.set(n),i.uniformMatrix3fv(this.addr,!1,hg),hn(t,n)}}function dw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;cg.set(n),i.uniformMatrix4fv(this.addr,!1,cg),hn(t,n)}}function pw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function mw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2iv(this.addr,e),hn(t,e)}}function gw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(cn(t,e))return;i.uniform3iv(this.addr,e),hn(t,e)}}function vw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4iv(this.addr,e),hn(t,e)}}function xw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function _w(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2uiv(this.addr,e),hn(t,e)}}function yw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(cn(t,e))return;i.uniform3uiv(this.addr,e),hn(t,e)}}function bw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4uiv(this.addr,e),hn(t,e)}}function Mw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(og.compareFunction=Rf,r=og):r=Sg,t.setTexture2D(e||r,s)}function ww(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Tg,s)}function Sw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Ag,s)}function Ew(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Eg,s)}function Tw(i){switch(i){case 5126:return aw;case 35664:return lw;case 35665:return cw;case 35666:return hw;case 35674:return uw;case 35675:return fw;case 35676:return dw;case 5124:case 35670:return pw;case 35667:case 35671:return mw;case 35668:case 35672:return gw;case 35669:case 35673:return vw;case 5125:return xw;case 36294:return _w;case 36295:return yw;case 36296:return bw;case 35678:case 36198:case 36298:case 36306:case 35682:return Mw;case 35679:case 36299:case 36307:return ww;case 35680:case 36300:case 36308:case 36293:return Sw;case 36289:case 36303:case 36311:case 36292:return Ew}}function Aw(i,e){i.uniform1fv(this.addr,e)}function Rw(i,e){let t=Ro(e,this.size,2);i.uniform2fv(this.addr,t)}function Cw(i,e){let t=Ro(e,this.size,3);i.uniform3fv(this.addr,t)}function Pw(i,e){let t=Ro(e,this.size,4);i.uniform4fv(this.addr,t)}function Iw(i,e){let t=Ro(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Lw(i,e){let t=Ro(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Dw(i,e){let t=Ro(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Uw(i,e){i.uniform1iv(this.addr,e)}function Nw(i,e){i.uniform2iv(this.addr,e)}function Fw(i,e){i.uniform3iv(this.addr,e)}function Ow(i,e){i.uniform4iv(this.addr,e)}function Bw(i,e){i.uniform1uiv(this.addr,e)}function zw(i,e){i.uniform2uiv(this.addr,e)}function kw(i,e){i.uniform3uiv(this.addr,e)}function Hw(i,e){i.uniform4uiv(this.addr,e)}function Vw(i,e,t){let n=this.cache,s=e.length,r=Rh(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||Sg,r[o])}function Gw(i,e,t){let n=this.cache,s=e.length,r=Rh(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Tg,r[o])}function Ww(i,e,t){let n=this.cache,s=e.length,r=Rh(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Ag,r[o])}function Xw(i,e,t){let n=this.cache,s=e.length,r=Rh(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Eg,r[o])}function qw(i){switch(i){case 5126:return Aw;case 35664:return Rw;case 35665:return Cw;case 35666:return Pw;case 35674:return Iw;case 35675:return Lw;case 35676:return Dw;case 5124:case 35670:return Uw;case 35667:case 35671:return Nw;case 35668:case 35672:return Fw;case 35669:case 35673:return Ow;case 5125:return Bw;case 36294:return zw;case 36295:return kw;case 36296:return Hw;case 35678:case 36198:case 36298:case 36306:case 35682:return Vw;case 35679:case 36299:case 36307:return Gw;case 35680:case 36300:case 36308:case 36293:return Ww;case 36289:case 36303:case 36311:case 36292:return Xw}}var Gf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Tw(t.type)}},Wf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=qw(t.type)}},Xf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Vf=/(\w+)(\])?(\[|\.)?/g;function fg(i,e){i.seq.push(e),i.map[e.id]=e}function Yw(i,e,t){let n=i.name,s=n.length;for(Vf.lastIndex=0;;){let r=Vf.exec(n),o=Vf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){fg(t,c===void 0?new Gf(a,i,e):new Wf(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new Xf(a),fg(t,h)),t=h}}}var Ao=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);Yw(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function dg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var $w=37297,Zw=0;function Kw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var pg=new ct;function Jw(i){xt._getMatrix(pg,xt.workingColorSpace,i);let e=`mat3( ${pg.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(i)){case fa:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function mg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Kw(i.getShaderSource(e),a)}else return r}function jw(i,e){let t=Jw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function Qw(i,e){let t;switch(e){case Im:t="Linear";break;case Lm:t="Reinhard";break;case Dm:t="Cineon";break;case Um:t="ACESFilmic";break;case Fm:t="AgX";break;case Om:t="Neutral";break;case Nm:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Eh=new L;function eS(){xt.getLuminanceCoefficients(Eh);let i=Eh.x.toFixed(4),e=Eh.y.toFixed(4),t=Eh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function tS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($a).join(`
`)}function nS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function iS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function $a(i){return i!==""}function gg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function vg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var sS=/^[ \t]*#include +<([\w\d./]+)>/gm;function qf(i){return i.replace(sS,oS)}var rS=new Map;function oS(i,e){let t=ft[e];if(t===void 0){let n=rS.get(e);if(n!==void 0)t=ft[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return qf(t)}var aS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function xg(i){return i.replace(aS,lS)}function lS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function _g(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function cS(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===df?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===hm?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Qi&&(e="SHADOWMAP_TYPE_VSM"),e}function hS(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case gr:case vr:e="ENVMAP_TYPE_CUBE";break;case Ha:e="ENVMAP_TYPE_CUBE_UV";break}return e}function uS(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case vr:e="ENVMAP_MODE_REFRACTION";break}return e}function fS(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case vf:e="ENVMAP_BLENDING_MULTIPLY";break;case Cm:e="ENVMAP_BLENDING_MIX";break;case Pm:e="ENVMAP_BLENDING_ADD";break}return e}function dS(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function pS(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=cS(t),c=hS(t),u=uS(t),h=fS(t),f=dS(t),m=tS(t),g=nS(r),v=s.createProgram(),p,d,b=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter($a).join(`
`),p.length>0&&(p+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter($a).join(`
`),d.length>0&&(d+=`
`)):(p=[_g(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($a).join(`
`),d=[_g(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==_s?"#define TONE_MAPPING":"",t.toneMapping!==_s?ft.tonemapping_pars_fragment:"",t.toneMapping!==_s?Qw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,jw("linearToOutputTexel",t.outputColorSpace),eS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter($a).join(`
`)),o=qf(o),o=gg(o,t),o=vg(o,t),a=qf(a),a=gg(a,t),a=vg(a,t),o=xg(o),a=xg(a),t.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,p=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,d=["#define varying in",t.glslVersion===Cf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Cf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let M=b+p+o,_=b+d+a,P=dg(s,s.VERTEX_SHADER,M),E=dg(s,s.FRAGMENT_SHADER,_);s.attachShader(v,P),s.attachShader(v,E),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function I(A){if(i.debug.checkShaderErrors){let k=s.getProgramInfoLog(v)||"",B=s.getShaderInfoLog(P)||"",V=s.getShaderInfoLog(E)||"",W=k.trim(),X=B.trim(),F=V.trim(),z=!0,J=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,P,E);else{let ne=mg(s,P,"vertex"),te=mg(s,E,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+A.name+`
Material Type: `+A.type+`

Program Info Log: `+W+`
`+ne+`
`+te)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(X===""||F==="")&&(J=!1);J&&(A.diagnostics={runnable:z,programLog:W,vertexShader:{log:X,prefix:p},fragmentShader:{log:F,prefix:d}})}s.deleteShader(P),s.deleteShader(E),D=new Ao(s,v),w=iS(s,v)}let D;this.getUniforms=function(){return D===void 0&&I(this),D};let w;this.getAttributes=function(){return w===void 0&&I(this),w};let S=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,$w)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Zw++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=P,this.fragmentShader=E,this}var mS=0,Yf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new $f(e),t.set(e,n)),n}},$f=class{constructor(e){this.id=mS++,this.code=e,this.usedTimes=0}};function gS(i,e,t,n,s,r,o){let a=new ga,l=new Yf,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,m=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function p(w,S,A,k,B){let V=k.fog,W=B.geometry,X=w.isMeshStandardMaterial?k.environment:null,F=(w.isMeshStandardMaterial?t:e).get(w.envMap||X),z=F&&F.mapping===Ha?F.image.height:null,J=g[w.type];w.precision!==null&&(m=s.getMaxPrecision(w.precision),m!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",m,"instead."));let ne=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,te=ne!==void 0?ne.length:0,ce=0;W.morphAttributes.position!==void 0&&(ce=1),W.morphAttributes.normal!==void 0&&(ce=2),W.morphAttributes.color!==void 0&&(ce=3);let fe,ye,_e,ee;if(J){let yt=Xn[J];fe=yt.vertexShader,ye=yt.fragmentShader}else fe=w.vertexShader,ye=w.fragmentShader,l.update(w),_e=l.getVertexShaderID(w),ee=l.getFragmentShaderID(w);let $=i.getRenderTarget(),me=i.state.buffers.depth.getReversed(),ve=B.isInstancedMesh===!0,be=B.isBatchedMesh===!0,Ge=!!w.map,dt=!!w.matcap,H=!!F,ht=!!w.aoMap,re=!!w.lightMap,we=!!w.bumpMap,Pe=!!w.normalMap,ot=!!w.displacementMap,le=!!w.emissiveMap,j=!!w.metalnessMap,he=!!w.roughnessMap,Se=w.anisotropy>0,C=w.clearcoat>0,y=w.dispersion>0,N=w.iridescence>0,q=w.sheen>0,oe=w.transmission>0,se=Se&&!!w.anisotropyMap,Ue=C&&!!w.clearcoatMap,xe=C&&!!w.clearcoatNormalMap,Fe=C&&!!w.clearcoatRoughnessMap,Be=N&&!!w.iridescenceMap,ge=N&&!!w.iridescenceThicknessMap,Ce=q&&!!w.sheenColorMap,qe=q&&!!w.sheenRoughnessMap,Ye=!!w.specularMap,Le=!!w.specularColorMap,Ze=!!w.specularIntensityMap,Y=oe&&!!w.transmissionMap,Te=oe&&!!w.thicknessMap,Re=!!w.gradientMap,Ve=!!w.alphaMap,Ee=w.alphaTest>0,pe=!!w.alphaHash,$e=!!w.extensions,st=_s;w.toneMapped&&($===null||$.isXRRenderTarget===!0)&&(st=i.toneMapping);let Lt={shaderID:J,shaderType:w.type,shaderName:w.name,vertexShader:fe,fragmentShader:ye,defines:w.defines,customVertexShaderID:_e,customFragmentShaderID:ee,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:m,batching:be,batchingColor:be&&B._colorsTexture!==null,instancing:ve,instancingColor:ve&&B.instanceColor!==null,instancingMorph:ve&&B.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:$===null?i.outputColorSpace:$.isXRRenderTarget===!0?$.texture.colorSpace:cr,alphaToCoverage:!!w.alphaToCoverage,map:Ge,matcap:dt,envMap:H,envMapMode:H&&F.mapping,envMapCubeUVHeight:z,aoMap:ht,lightMap:re,bumpMap:we,normalMap:Pe,displacementMap:f&&ot,emissiveMap:le,normalMapObjectSpace:Pe&&w.normalMapType===Hm,normalMapTangentSpace:Pe&&w.normalMapType===Af,metalnessMap:j,roughnessMap:he,anisotropy:Se,anisotropyMap:se,clearcoat:C,clearcoatMap:Ue,clearcoatNormalMap:xe,clearcoatRoughnessMap:Fe,dispersion:y,iridescence:N,iridescenceMap:Be,iridescenceThicknessMap:ge,sheen:q,sheenColorMap:Ce,sheenRoughnessMap:qe,specularMap:Ye,specularColorMap:Le,specularIntensityMap:Ze,transmission:oe,transmissionMap:Y,thicknessMap:Te,gradientMap:Re,opaque:w.transparent===!1&&w.blending===ar&&w.alphaToCoverage===!1,alphaMap:Ve,alphaTest:Ee,alphaHash:pe,combine:w.combine,mapUv:Ge&&v(w.map.channel),aoMapUv:ht&&v(w.aoMap.channel),lightMapUv:re&&v(w.lightMap.channel),bumpMapUv:we&&v(w.bumpMap.channel),normalMapUv:Pe&&v(w.normalMap.channel),displacementMapUv:ot&&v(w.displacementMap.channel),emissiveMapUv:le&&v(w.emissiveMap.channel),metalnessMapUv:j&&v(w.metalnessMap.channel),roughnessMapUv:he&&v(w.roughnessMap.channel),anisotropyMapUv:se&&v(w.anisotropyMap.channel),clearcoatMapUv:Ue&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:xe&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Fe&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:Be&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:ge&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:Ce&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:qe&&v(w.sheenRoughnessMap.channel),specularMapUv:Ye&&v(w.specularMap.channel),specularColorMapUv:Le&&v(w.specularColorMap.channel),specularIntensityMapUv:Ze&&v(w.specularIntensityMap.channel),transmissionMapUv:Y&&v(w.transmissionMap.channel),thicknessMapUv:Te&&v(w.thicknessMap.channel),alphaMapUv:Ve&&v(w.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Pe||Se),vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:B.isPoints===!0&&!!W.attributes.uv&&(Ge||Ve),fog:!!V,useFog:w.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:w.flatShading===!0&&w.wireframe===!1,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:me,skinning:B.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ce,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:i.shadowMap.enabled&&A.length>0,shadowMapType:i.shadowMap.type,toneMapping:st,decodeVideoTexture:Ge&&w.map.isVideoTexture===!0&&xt.getTransfer(w.map.colorSpace)===Pt,decodeVideoTextureEmissive:le&&w.emissiveMap.isVideoTexture===!0&&xt.getTransfer(w.emissiveMap.colorSpace)===Pt,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===Sn,flipSided:w.side===Wn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:$e&&w.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:($e&&w.extensions.multiDraw===!0||be)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return Lt.vertexUv1s=c.has(1),Lt.vertexUv2s=c.has(2),Lt.vertexUv3s=c.has(3),c.clear(),Lt}function d(w){let S=[];if(w.shaderID?S.push(w.shaderID):(S.push(w.customVertexShaderID),S.push(w.customFragmentShaderID)),w.defines!==void 0)for(let A in w.defines)S.push(A),S.push(w.defines[A]);return w.isRawShaderMaterial===!1&&(b(S,w),M(S,w),S.push(i.outputColorSpace)),S.push(w.customProgramCacheKey),S.join()}function b(w,S){w.push(S.precision),w.push(S.outputColorSpace),w.push(S.envMapMode),w.push(S.envMapCubeUVHeight),w.push(S.mapUv),w.push(S.alphaMapUv),w.push(S.lightMapUv),w.push(S.aoMapUv),w.push(S.bumpMapUv),w.push(S.normalMapUv),w.push(S.displacementMapUv),w.push(S.emissiveMapUv),w.push(S.metalnessMapUv),w.push(S.roughnessMapUv),w.push(S.anisotropyMapUv),w.push(S.clearcoatMapUv),w.push(S.clearcoatNormalMapUv),w.push(S.clearcoatRoughnessMapUv),w.push(S.iridescenceMapUv),w.push(S.iridescenceThicknessMapUv),w.push(S.sheenColorMapUv),w.push(S.sheenRoughnessMapUv),w.push(S.specularMapUv),w.push(S.specularColorMapUv),w.push(S.specularIntensityMapUv),w.push(S.transmissionMapUv),w.push(S.thicknessMapUv),w.push(S.combine),w.push(S.fogExp2),w.push(S.sizeAttenuation),w.push(S.morphTargetsCount),w.push(S.morphAttributeCount),w.push(S.numDirLights),w.push(S.numPointLights),w.push(S.numSpotLights),w.push(S.numSpotLightMaps),w.push(S.numHemiLights),w.push(S.numRectAreaLights),w.push(S.numDirLightShadows),w.push(S.numPointLightShadows),w.push(S.numSpotLightShadows),w.push(S.numSpotLightShadowsWithMaps),w.push(S.numLightProbes),w.push(S.shadowMapType),w.push(S.toneMapping),w.push(S.numClippingPlanes),w.push(S.numClipIntersection),w.push(S.depthPacking)}function M(w,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),S.gradientMap&&a.enable(22),w.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reversedDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),w.push(a.mask)}function _(w){let S=g[w.type],A;if(S){let k=Xn[S];A=Ya.clone(k.uniforms)}else A=w.uniforms;return A}function P(w,S){let A;for(let k=0,B=u.length;k<B;k++){let V=u[k];if(V.cacheKey===S){A=V,++A.usedTimes;break}}return A===void 0&&(A=new pS(i,S,w,r),u.push(A)),A}function E(w){if(--w.usedTimes===0){let S=u.indexOf(w);u[S]=u[u.length-1],u.pop(),w.destroy()}}function I(w){l.remove(w)}function D(){l.dispose()}return{getParameters:p,getProgramCacheKey:d,getUniforms:_,acquireProgram:P,releaseProgram:E,releaseShaderCache:I,programs:u,dispose:D}}function vS(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function xS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function yg(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function bg(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h,f,m,g,v,p){let d=i[e];return d===void 0?(d={id:h.id,object:h,geometry:f,material:m,groupOrder:g,renderOrder:h.renderOrder,z:v,group:p},i[e]=d):(d.id=h.id,d.object=h,d.geometry=f,d.material=m,d.groupOrder=g,d.renderOrder=h.renderOrder,d.z=v,d.group=p),e++,d}function a(h,f,m,g,v,p){let d=o(h,f,m,g,v,p);m.transmission>0?n.push(d):m.transparent===!0?s.push(d):t.push(d)}function l(h,f,m,g,v,p){let d=o(h,f,m,g,v,p);m.transmission>0?n.unshift(d):m.transparent===!0?s.unshift(d):t.unshift(d)}function c(h,f){t.length>1&&t.sort(h||xS),n.length>1&&n.sort(f||yg),s.length>1&&s.sort(f||yg)}function u(){for(let h=e,f=i.length;h<f;h++){let m=i[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function _S(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new bg,i.set(n,[o])):s>=r.length?(o=new bg,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function yS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new L,color:new at};break;case"SpotLight":t={position:new L,direction:new L,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new L,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new L,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new L,halfWidth:new L,halfHeight:new L};break}return i[e.id]=t,t}}}function bS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Oe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Oe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Oe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var MS=0;function wS(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function SS(i){let e=new yS,t=bS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new L);let s=new L,r=new Ut,o=new Ut;function a(c){let u=0,h=0,f=0;for(let w=0;w<9;w++)n.probe[w].set(0,0,0);let m=0,g=0,v=0,p=0,d=0,b=0,M=0,_=0,P=0,E=0,I=0;c.sort(wS);for(let w=0,S=c.length;w<S;w++){let A=c[w],k=A.color,B=A.intensity,V=A.distance,W=A.shadow&&A.shadow.map?A.shadow.map.texture:null;if(A.isAmbientLight)u+=k.r*B,h+=k.g*B,f+=k.b*B;else if(A.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(A.sh.coefficients[X],B);I++}else if(A.isDirectionalLight){let X=e.get(A);if(X.color.copy(A.color).multiplyScalar(A.intensity),A.castShadow){let F=A.shadow,z=t.get(A);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,n.directionalShadow[m]=z,n.directionalShadowMap[m]=W,n.directionalShadowMatrix[m]=A.shadow.matrix,b++}n.directional[m]=X,m++}else if(A.isSpotLight){let X=e.get(A);X.position.setFromMatrixPosition(A.matrixWorld),X.color.copy(k).multiplyScalar(B),X.distance=V,X.coneCos=Math.cos(A.angle),X.penumbraCos=Math.cos(A.angle*(1-A.penumbra)),X.decay=A.decay,n.spot[v]=X;let F=A.shadow;if(A.map&&(n.spotLightMap[P]=A.map,P++,F.updateMatrices(A),A.castShadow&&E++),n.spotLightMatrix[v]=F.matrix,A.castShadow){let z=t.get(A);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,n.spotShadow[v]=z,n.spotShadowMap[v]=W,_++}v++}else if(A.isRectAreaLight){let X=e.get(A);X.color.copy(k).multiplyScalar(B),X.halfWidth.set(A.width*.5,0,0),X.halfHeight.set(0,A.height*.5,0),n.rectArea[p]=X,p++}else if(A.isPointLight){let X=e.get(A);if(X.color.copy(A.color).multiplyScalar(A.intensity),X.distance=A.distance,X.decay=A.decay,A.castShadow){let F=A.shadow,z=t.get(A);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,z.shadowCameraNear=F.camera.near,z.shadowCameraFar=F.camera.far,n.pointShadow[g]=z,n.pointShadowMap[g]=W,n.pointShadowMatrix[g]=A.shadow.matrix,M++}n.point[g]=X,g++}else if(A.isHemisphereLight){let X=e.get(A);X.skyColor.copy(A.color).multiplyScalar(B),X.groundColor.copy(A.groundColor).multiplyScalar(B),n.hemi[d]=X,d++}}p>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=De.LTC_FLOAT_1,n.rectAreaLTC2=De.LTC_FLOAT_2):(n.rectAreaLTC1=De.LTC_HALF_1,n.rectAreaLTC2=De.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let D=n.hash;(D.directionalLength!==m||D.pointLength!==g||D.spotLength!==v||D.rectAreaLength!==p||D.hemiLength!==d||D.numDirectionalShadows!==b||D.numPointShadows!==M||D.numSpotShadows!==_||D.numSpotMaps!==P||D.numLightProbes!==I)&&(n.directional.length=m,n.spot.length=v,n.rectArea.length=p,n.point.length=g,n.hemi.length=d,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.pointShadow.length=M,n.pointShadowMap.length=M,n.spotShadow.length=_,n.spotShadowMap.length=_,n.directionalShadowMatrix.length=b,n.pointShadowMatrix.length=M,n.spotLightMatrix.length=_+P-E,n.spotLightMap.length=P,n.numSpotLightShadowsWithMaps=E,n.numLightProbes=I,D.directionalLength=m,D.pointLength=g,D.spotLength=v,D.rectAreaLength=p,D.hemiLength=d,D.numDirectionalShadows=b,D.numPointShadows=M,D.numSpotShadows=_,D.numSpotMaps=P,D.numLightProbes=I,n.version=MS++)}function l(c,u){let h=0,f=0,m=0,g=0,v=0,p=u.matrixWorldInverse;for(let d=0,b=c.length;d<b;d++){let M=c[d];if(M.isDirectionalLight){let _=n.directional[h];_.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),_.direction.sub(s),_.direction.transformDirection(p),h++}else if(M.isSpotLight){let _=n.spot[m];_.position.setFromMatrixPosition(M.matrixWorld),_.position.applyMatrix4(p),_.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),_.direction.sub(s),_.direction.transformDirection(p),m++}else if(M.isRectAreaLight){let _=n.rectArea[g];_.position.setFromMatrixPosition(M.matrixWorld),_.position.applyMatrix4(p),o.identity(),r.copy(M.matrixWorld),r.premultiply(p),o.extractRotation(r),_.halfWidth.set(M.width*.5,0,0),_.halfHeight.set(0,M.height*.5,0),_.halfWidth.applyMatrix4(o),_.halfHeight.applyMatrix4(o),g++}else if(M.isPointLight){let _=n.point[f];_.position.setFromMatrixPosition(M.matrixWorld),_.position.applyMatrix4(p),f++}else if(M.isHemisphereLight){let _=n.hemi[v];_.direction.setFromMatrixPosition(M.matrixWorld),_.direction.transformDirection(p),v++}}}return{setup:a,setupView:l,state:n}}function Mg(i){let e=new SS(i),t=[],n=[];function s(u){c.camera=u,t.length=0,n.length=0}function r(u){t.push(u)}function o(u){n.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function ES(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Mg(i),e.set(s,[a])):r>=o.length?(a=new Mg(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var TS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,AS=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function RS(i,e,t){let n=new xo,s=new Oe,r=new Oe,o=new It,a=new _c({depthPacking:km}),l=new yc,c={},u=t.maxTextureSize,h={[gs]:Wn,[Wn]:gs,[Sn]:Sn},f=new ai({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Oe},radius:{value:4}},vertexShader:TS,fragmentShader:AS}),m=f.clone();m.defines.HORIZONTAL_PASS=1;let g=new Ot;g.setAttribute("position",new Jt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new je(g,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=df;let d=this.type;this.render=function(E,I,D){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;let w=i.getRenderTarget(),S=i.getActiveCubeFace(),A=i.getActiveMipmapLevel(),k=i.state;k.setBlending(xs),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let B=d!==Qi&&this.type===Qi,V=d===Qi&&this.type!==Qi;for(let W=0,X=E.length;W<X;W++){let F=E[W],z=F.shadow;if(z===void 0){console.warn("THREE.WebGLShadowMap:",F,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let J=z.getFrameExtents();if(s.multiply(J),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/J.x),s.x=r.x*J.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/J.y),s.y=r.y*J.y,z.mapSize.y=r.y)),z.map===null||B===!0||V===!0){let te=this.type!==Qi?{minFilter:vi,magFilter:vi}:{};z.map!==null&&z.map.dispose(),z.map=new Ki(s.x,s.y,te),z.map.texture.name=F.name+".shadowMap",z.camera.updateProjectionMatrix()}i.setRenderTarget(z.map),i.clear();let ne=z.getViewportCount();for(let te=0;te<ne;te++){let ce=z.getViewport(te);o.set(r.x*ce.x,r.y*ce.y,r.x*ce.z,r.y*ce.w),k.viewport(o),z.updateMatrices(F,te),n=z.getFrustum(),_(I,D,z.camera,F,this.type)}z.isPointLightShadow!==!0&&this.type===Qi&&b(z,D),z.needsUpdate=!1}d=this.type,p.needsUpdate=!1,i.setRenderTarget(w,S,A)};function b(E,I){let D=e.update(v);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null&&(E.mapPass=new Ki(s.x,s.y)),f.uniforms.shadow_pass.value=E.map.texture,f.uniforms.resolution.value=E.mapSize,f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(I,null,D,f,v,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value=E.mapSize,m.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(I,null,D,m,v,null)}function M(E,I,D,w){let S=null,A=D.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(A!==void 0)S=A;else if(S=D.isPointLight===!0?l:a,i.localClippingEnabled&&I.clipShadows===!0&&Array.isArray(I.clippingPlanes)&&I.clippingPlanes.length!==0||I.displacementMap&&I.displacementScale!==0||I.alphaMap&&I.alphaTest>0||I.map&&I.alphaTest>0||I.alphaToCoverage===!0){let k=S.uuid,B=I.uuid,V=c[k];V===void 0&&(V={},c[k]=V);let W=V[B];W===void 0&&(W=S.clone(),V[B]=W,I.addEventListener("dispose",P)),S=W}if(S.visible=I.visible,S.wireframe=I.wireframe,w===Qi?S.side=I.shadowSide!==null?I.shadowSide:I.side:S.side=I.shadowSide!==null?I.shadowSide:h[I.side],S.alphaMap=I.alphaMap,S.alphaTest=I.alphaToCoverage===!0?.5:I.alphaTest,S.map=I.map,S.clipShadows=I.clipShadows,S.clippingPlanes=I.clippingPlanes,S.clipIntersection=I.clipIntersection,S.displacementMap=I.displacementMap,S.displacementScale=I.displacementScale,S.displacementBias=I.displacementBias,S.wireframeLinewidth=I.wireframeLinewidth,S.linewidth=I.linewidth,D.isPointLight===!0&&S.isMeshDistanceMaterial===!0){let k=i.properties.get(S);k.light=D}return S}function _(E,I,D,w,S){if(E.visible===!1)return;if(E.layers.test(I.layers)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&S===Qi)&&(!E.frustumCulled||n.intersectsObject(E))){E.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,E.matrixWorld);let B=e.update(E),V=E.material;if(Array.isArray(V)){let W=B.groups;for(let X=0,F=W.length;X<F;X++){let z=W[X],J=V[z.materialIndex];if(J&&J.visible){let ne=M(E,J,w,S);E.onBeforeShadow(i,E,I,D,B,ne,z),i.renderBufferDirect(D,null,B,ne,E,z),E.onAfterShadow(i,E,I,D,B,ne,z)}}}else if(V.visible){let W=M(E,V,w,S);E.onBeforeShadow(i,E,I,D,B,W,null),i.renderBufferDirect(D,null,B,W,E,null),E.onAfterShadow(i,E,I,D,B,W,null)}}let k=E.children;for(let B=0,V=k.length;B<V;B++)_(k[B],I,D,w,S)}function P(E){E.target.removeEventListener("dispose",P);for(let D in c){let w=c[D],S=E.target.uuid;S in w&&(w[S].dispose(),delete w[S])}}}var CS={[Ic]:Lc,[Dc]:Fc,[Uc]:Oc,[lr]:Nc,[Lc]:Ic,[Fc]:Dc,[Oc]:Uc,[Nc]:lr};function PS(i,e){function t(){let Y=!1,Te=new It,Re=null,Ve=new It(0,0,0,0);return{setMask:function(Ee){Re!==Ee&&!Y&&(i.colorMask(Ee,Ee,Ee,Ee),Re=Ee)},setLocked:function(Ee){Y=Ee},setClear:function(Ee,pe,$e,st,Lt){Lt===!0&&(Ee*=st,pe*=st,$e*=st),Te.set(Ee,pe,$e,st),Ve.equals(Te)===!1&&(i.clearColor(Ee,pe,$e,st),Ve.copy(Te))},reset:function(){Y=!1,Re=null,Ve.set(-1,0,0,0)}}}function n(){let Y=!1,Te=!1,Re=null,Ve=null,Ee=null;return{setReversed:function(pe){if(Te!==pe){let $e=e.get("EXT_clip_control");pe?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),Te=pe;let st=Ee;Ee=null,this.setClear(st)}},getReversed:function(){return Te},setTest:function(pe){pe?$(i.DEPTH_TEST):me(i.DEPTH_TEST)},setMask:function(pe){Re!==pe&&!Y&&(i.depthMask(pe),Re=pe)},setFunc:function(pe){if(Te&&(pe=CS[pe]),Ve!==pe){switch(pe){case Ic:i.depthFunc(i.NEVER);break;case Lc:i.depthFunc(i.ALWAYS);break;case Dc:i.depthFunc(i.LESS);break;case lr:i.depthFunc(i.LEQUAL);break;case Uc:i.depthFunc(i.EQUAL);break;case Nc:i.depthFunc(i.GEQUAL);break;case Fc:i.depthFunc(i.GREATER);break;case Oc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ve=pe}},setLocked:function(pe){Y=pe},setClear:function(pe){Ee!==pe&&(Te&&(pe=1-pe),i.clearDepth(pe),Ee=pe)},reset:function(){Y=!1,Re=null,Ve=null,Ee=null,Te=!1}}}function s(){let Y=!1,Te=null,Re=null,Ve=null,Ee=null,pe=null,$e=null,st=null,Lt=null;return{setTest:function(yt){Y||(yt?$(i.STENCIL_TEST):me(i.STENCIL_TEST))},setMask:function(yt){Te!==yt&&!Y&&(i.stencilMask(yt),Te=yt)},setFunc:function(yt,bn,Ft){(Re!==yt||Ve!==bn||Ee!==Ft)&&(i.stencilFunc(yt,bn,Ft),Re=yt,Ve=bn,Ee=Ft)},setOp:function(yt,bn,Ft){(pe!==yt||$e!==bn||st!==Ft)&&(i.stencilOp(yt,bn,Ft),pe=yt,$e=bn,st=Ft)},setLocked:function(yt){Y=yt},setClear:function(yt){Lt!==yt&&(i.clearStencil(yt),Lt=yt)},reset:function(){Y=!1,Te=null,Re=null,Ve=null,Ee=null,pe=null,$e=null,st=null,Lt=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,m=[],g=null,v=!1,p=null,d=null,b=null,M=null,_=null,P=null,E=null,I=new at(0,0,0),D=0,w=!1,S=null,A=null,k=null,B=null,V=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),X=!1,F=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(F=parseFloat(/^WebGL (\d)/.exec(z)[1]),X=F>=1):z.indexOf("OpenGL ES")!==-1&&(F=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),X=F>=2);let J=null,ne={},te=i.getParameter(i.SCISSOR_BOX),ce=i.getParameter(i.VIEWPORT),fe=new It().fromArray(te),ye=new It().fromArray(ce);function _e(Y,Te,Re,Ve){let Ee=new Uint8Array(4),pe=i.createTexture();i.bindTexture(Y,pe),i.texParameteri(Y,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(Y,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let $e=0;$e<Re;$e++)Y===i.TEXTURE_3D||Y===i.TEXTURE_2D_ARRAY?i.texImage3D(Te,0,i.RGBA,1,1,Ve,0,i.RGBA,i.UNSIGNED_BYTE,Ee):i.texImage2D(Te+$e,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Ee);return pe}let ee={};ee[i.TEXTURE_2D]=_e(i.TEXTURE_2D,i.TEXTURE_2D,1),ee[i.TEXTURE_CUBE_MAP]=_e(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ee[i.TEXTURE_2D_ARRAY]=_e(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ee[i.TEXTURE_3D]=_e(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),$(i.DEPTH_TEST),o.setFunc(lr),we(!1),Pe(ff),$(i.CULL_FACE),ht(xs);function $(Y){u[Y]!==!0&&(i.enable(Y),u[Y]=!0)}function me(Y){u[Y]!==!1&&(i.disable(Y),u[Y]=!1)}function ve(Y,Te){return h[Y]!==Te?(i.bindFramebuffer(Y,Te),h[Y]=Te,Y===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=Te),Y===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=Te),!0):!1}function be(Y,Te){let Re=m,Ve=!1;if(Y){Re=f.get(Te),Re===void 0&&(Re=[],f.set(Te,Re));let Ee=Y.textures;if(Re.length!==Ee.length||Re[0]!==i.COLOR_ATTACHMENT0){for(let pe=0,$e=Ee.length;pe<$e;pe++)Re[pe]=i.COLOR_ATTACHMENT0+pe;Re.length=Ee.length,Ve=!0}}else Re[0]!==i.BACK&&(Re[0]=i.BACK,Ve=!0);Ve&&i.drawBuffers(Re)}function Ge(Y){return g!==Y?(i.useProgram(Y),g=Y,!0):!1}let dt={[Os]:i.FUNC_ADD,[fm]:i.FUNC_SUBTRACT,[dm]:i.FUNC_REVERSE_SUBTRACT};dt[pm]=i.MIN,dt[mm]=i.MAX;let H={[gm]:i.ZERO,[vm]:i.ONE,[xm]:i.SRC_COLOR,[jl]:i.SRC_ALPHA,[Sm]:i.SRC_ALPHA_SATURATE,[Mm]:i.DST_COLOR,[ym]:i.DST_ALPHA,[_m]:i.ONE_MINUS_SRC_COLOR,[Ql]:i.ONE_MINUS_SRC_ALPHA,[wm]:i.ONE_MINUS_DST_COLOR,[bm]:i.ONE_MINUS_DST_ALPHA,[Em]:i.CONSTANT_COLOR,[Tm]:i.ONE_MINUS_CONSTANT_COLOR,[Am]:i.CONSTANT_ALPHA,[Rm]:i.ONE_MINUS_CONSTANT_ALPHA};function ht(Y,Te,Re,Ve,Ee,pe,$e,st,Lt,yt){if(Y===xs){v===!0&&(me(i.BLEND),v=!1);return}if(v===!1&&($(i.BLEND),v=!0),Y!==um){if(Y!==p||yt!==w){if((d!==Os||_!==Os)&&(i.blendEquation(i.FUNC_ADD),d=Os,_=Os),yt)switch(Y){case ar:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pf:i.blendFunc(i.ONE,i.ONE);break;case mf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case gf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",Y);break}else switch(Y){case ar:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case mf:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case gf:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",Y);break}b=null,M=null,P=null,E=null,I.set(0,0,0),D=0,p=Y,w=yt}return}Ee=Ee||Te,pe=pe||Re,$e=$e||Ve,(Te!==d||Ee!==_)&&(i.blendEquationSeparate(dt[Te],dt[Ee]),d=Te,_=Ee),(Re!==b||Ve!==M||pe!==P||$e!==E)&&(i.blendFuncSeparate(H[Re],H[Ve],H[pe],H[$e]),b=Re,M=Ve,P=pe,E=$e),(st.equals(I)===!1||Lt!==D)&&(i.blendColor(st.r,st.g,st.b,Lt),I.copy(st),D=Lt),p=Y,w=!1}function re(Y,Te){Y.side===Sn?me(i.CULL_FACE):$(i.CULL_FACE);let Re=Y.side===Wn;Te&&(Re=!Re),we(Re),Y.blending===ar&&Y.transparent===!1?ht(xs):ht(Y.blending,Y.blendEquation,Y.blendSrc,Y.blendDst,Y.blendEquationAlpha,Y.blendSrcAlpha,Y.blendDstAlpha,Y.blendColor,Y.blendAlpha,Y.premultipliedAlpha),o.setFunc(Y.depthFunc),o.setTest(Y.depthTest),o.setMask(Y.depthWrite),r.setMask(Y.colorWrite);let Ve=Y.stencilWrite;a.setTest(Ve),Ve&&(a.setMask(Y.stencilWriteMask),a.setFunc(Y.stencilFunc,Y.stencilRef,Y.stencilFuncMask),a.setOp(Y.stencilFail,Y.stencilZFail,Y.stencilZPass)),le(Y.polygonOffset,Y.polygonOffsetFactor,Y.polygonOffsetUnits),Y.alphaToCoverage===!0?$(i.SAMPLE_ALPHA_TO_COVERAGE):me(i.SAMPLE_ALPHA_TO_COVERAGE)}function we(Y){S!==Y&&(Y?i.frontFace(i.CW):i.frontFace(i.CCW),S=Y)}function Pe(Y){Y!==lm?($(i.CULL_FACE),Y!==A&&(Y===ff?i.cullFace(i.BACK):Y===cm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):me(i.CULL_FACE),A=Y}function ot(Y){Y!==k&&(X&&i.lineWidth(Y),k=Y)}function le(Y,Te,Re){Y?($(i.POLYGON_OFFSET_FILL),(B!==Te||V!==Re)&&(i.polygonOffset(Te,Re),B=Te,V=Re)):me(i.POLYGON_OFFSET_FILL)}function j(Y){Y?$(i.SCISSOR_TEST):me(i.SCISSOR_TEST)}function he(Y){Y===void 0&&(Y=i.TEXTURE0+W-1),J!==Y&&(i.activeTexture(Y),J=Y)}function Se(Y,Te,Re){Re===void 0&&(J===null?Re=i.TEXTURE0+W-1:Re=J);let Ve=ne[Re];Ve===void 0&&(Ve={type:void 0,texture:void 0},ne[Re]=Ve),(Ve.type!==Y||Ve.texture!==Te)&&(J!==Re&&(i.activeTexture(Re),J=Re),i.bindTexture(Y,Te||ee[Y]),Ve.type=Y,Ve.texture=Te)}function C(){let Y=ne[J];Y!==void 0&&Y.type!==void 0&&(i.bindTexture(Y.type,null),Y.type=void 0,Y.texture=void 0)}function y(){try{i.compressedTexImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function N(){try{i.compressedTexImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function q(){try{i.texSubImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function oe(){try{i.texSubImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function se(){try{i.compressedTexSubImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Ue(){try{i.compressedTexSubImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function xe(){try{i.texStorage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Fe(){try{i.texStorage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Be(){try{i.texImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function ge(){try{i.texImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Ce(Y){fe.equals(Y)===!1&&(i.scissor(Y.x,Y.y,Y.z,Y.w),fe.copy(Y))}function qe(Y){ye.equals(Y)===!1&&(i.viewport(Y.x,Y.y,Y.z,Y.w),ye.copy(Y))}function Ye(Y,Te){let Re=c.get(Te);Re===void 0&&(Re=new WeakMap,c.set(Te,Re));let Ve=Re.get(Y);Ve===void 0&&(Ve=i.getUniformBlockIndex(Te,Y.name),Re.set(Y,Ve))}function Le(Y,Te){let Ve=c.get(Te).get(Y);l.get(Te)!==Ve&&(i.uniformBlockBinding(Te,Ve,Y.__bindingPointIndex),l.set(Te,Ve))}function Ze(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},J=null,ne={},h={},f=new WeakMap,m=[],g=null,v=!1,p=null,d=null,b=null,M=null,_=null,P=null,E=null,I=new at(0,0,0),D=0,w=!1,S=null,A=null,k=null,B=null,V=null,fe.set(0,0,i.canvas.width,i.canvas.height),ye.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:$,disable:me,bindFramebuffer:ve,drawBuffers:be,useProgram:Ge,setBlending:ht,setMaterial:re,setFlipSided:we,setCullFace:Pe,setLineWidth:ot,setPolygonOffset:le,setScissorTest:j,activeTexture:he,bindTexture:Se,unbindTexture:C,compressedTexImage2D:y,compressedTexImage3D:N,texImage2D:Be,texImage3D:ge,updateUBOMapping:Ye,uniformBlockBinding:Le,texStorage2D:xe,texStorage3D:Fe,texSubImage2D:q,texSubImage3D:oe,compressedTexSubImage2D:se,compressedTexSubImage3D:Ue,scissor:Ce,viewport:qe,reset:Ze}}function IS(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Oe,u=new WeakMap,h,f=new WeakMap,m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(C,y){return m?new OffscreenCanvas(C,y):pa("canvas")}function v(C,y,N){let q=1,oe=Se(C);if((oe.width>N||oe.height>N)&&(q=N/Math.max(oe.width,oe.height)),q<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let se=Math.floor(q*oe.width),Ue=Math.floor(q*oe.height);h===void 0&&(h=g(se,Ue));let xe=y?g(se,Ue):h;return xe.width=se,xe.height=Ue,xe.getContext("2d").drawImage(C,0,0,se,Ue),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+se+"x"+Ue+")."),xe}else return"data"in C&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),C;return C}function p(C){return C.generateMipmaps}function d(C){i.generateMipmap(C)}function b(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(C,y,N,q,oe=!1){if(C!==null){if(i[C]!==void 0)return i[C];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let se=y;if(y===i.RED&&(N===i.FLOAT&&(se=i.R32F),N===i.HALF_FLOAT&&(se=i.R16F),N===i.UNSIGNED_BYTE&&(se=i.R8)),y===i.RED_INTEGER&&(N===i.UNSIGNED_BYTE&&(se=i.R8UI),N===i.UNSIGNED_SHORT&&(se=i.R16UI),N===i.UNSIGNED_INT&&(se=i.R32UI),N===i.BYTE&&(se=i.R8I),N===i.SHORT&&(se=i.R16I),N===i.INT&&(se=i.R32I)),y===i.RG&&(N===i.FLOAT&&(se=i.RG32F),N===i.HALF_FLOAT&&(se=i.RG16F),N===i.UNSIGNED_BYTE&&(se=i.RG8)),y===i.RG_INTEGER&&(N===i.UNSIGNED_BYTE&&(se=i.RG8UI),N===i.UNSIGNED_SHORT&&(se=i.RG16UI),N===i.UNSIGNED_INT&&(se=i.RG32UI),N===i.BYTE&&(se=i.RG8I),N===i.SHORT&&(se=i.RG16I),N===i.INT&&(se=i.RG32I)),y===i.RGB_INTEGER&&(N===i.UNSIGNED_BYTE&&(se=i.RGB8UI),N===i.UNSIGNED_SHORT&&(se=i.RGB16UI),N===i.UNSIGNED_INT&&(se=i.RGB32UI),N===i.BYTE&&(se=i.RGB8I),N===i.SHORT&&(se=i.RGB16I),N===i.INT&&(se=i.RGB32I)),y===i.RGBA_INTEGER&&(N===i.UNSIGNED_BYTE&&(se=i.RGBA8UI),N===i.UNSIGNED_SHORT&&(se=i.RGBA16UI),N===i.UNSIGNED_INT&&(se=i.RGBA32UI),N===i.BYTE&&(se=i.RGBA8I),N===i.SHORT&&(se=i.RGBA16I),N===i.INT&&(se=i.RGBA32I)),y===i.RGB&&(N===i.UNSIGNED_INT_5_9_9_9_REV&&(se=i.RGB9_E5),N===i.UNSIGNED_INT_10F_11F_11F_REV&&(se=i.R11F_G11F_B10F)),y===i.RGBA){let Ue=oe?fa:xt.getTransfer(q);N===i.FLOAT&&(se=i.RGBA32F),N===i.HALF_FLOAT&&(se=i.RGBA16F),N===i.UNSIGNED_BYTE&&(se=Ue===Pt?i.SRGB8_ALPHA8:i.RGBA8),N===i.UNSIGNED_SHORT_4_4_4_4&&(se=i.RGBA4),N===i.UNSIGNED_SHORT_5_5_5_1&&(se=i.RGB5_A1)}return(se===i.R16F||se===i.R32F||se===i.RG16F||se===i.RG32F||se===i.RGBA16F||se===i.RGBA32F)&&e.get("EXT_color_buffer_float"),se}function _(C,y){let N;return C?y===null||y===Ws||y===wo?N=i.DEPTH24_STENCIL8:y===es?N=i.DEPTH32F_STENCIL8:y===bo&&(N=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Ws||y===wo?N=i.DEPTH_COMPONENT24:y===es?N=i.DEPTH_COMPONENT32F:y===bo&&(N=i.DEPTH_COMPONENT16),N}function P(C,y){return p(C)===!0||C.isFramebufferTexture&&C.minFilter!==vi&&C.minFilter!==Li?Math.log2(Math.max(y.width,y.height))+1:C.mipmaps!==void 0&&C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?y.mipmaps.length:1}function E(C){let y=C.target;y.removeEventListener("dispose",E),D(y),y.isVideoTexture&&u.delete(y)}function I(C){let y=C.target;y.removeEventListener("dispose",I),S(y)}function D(C){let y=n.get(C);if(y.__webglInit===void 0)return;let N=C.source,q=f.get(N);if(q){let oe=q[y.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&w(C),Object.keys(q).length===0&&f.delete(N)}n.remove(C)}function w(C){let y=n.get(C);i.deleteTexture(y.__webglTexture);let N=C.source,q=f.get(N);delete q[y.__cacheKey],o.memory.textures--}function S(C){let y=n.get(C);if(C.depthTexture&&(C.depthTexture.dispose(),n.remove(C.depthTexture)),C.isWebGLCubeRenderTarget)for(let q=0;q<6;q++){if(Array.isArray(y.__webglFramebuffer[q]))for(let oe=0;oe<y.__webglFramebuffer[q].length;oe++)i.deleteFramebuffer(y.__webglFramebuffer[q][oe]);else i.deleteFramebuffer(y.__webglFramebuffer[q]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[q])}else{if(Array.isArray(y.__webglFramebuffer))for(let q=0;q<y.__webglFramebuffer.length;q++)i.deleteFramebuffer(y.__webglFramebuffer[q]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let q=0;q<y.__webglColorRenderbuffer.length;q++)y.__webglColorRenderbuffer[q]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[q]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let N=C.textures;for(let q=0,oe=N.length;q<oe;q++){let se=n.get(N[q]);se.__webglTexture&&(i.deleteTexture(se.__webglTexture),o.memory.textures--),n.remove(N[q])}n.remove(C)}let A=0;function k(){A=0}function B(){let C=A;return C>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+C+" texture units while this GPU supports only "+s.maxTextures),A+=1,C}function V(C){let y=[];return y.push(C.wrapS),y.push(C.wrapT),y.push(C.wrapR||0),y.push(C.magFilter),y.push(C.minFilter),y.push(C.anisotropy),y.push(C.internalFormat),y.push(C.format),y.push(C.type),y.push(C.generateMipmaps),y.push(C.premultiplyAlpha),y.push(C.flipY),y.push(C.unpackAlignment),y.push(C.colorSpace),y.join()}function W(C,y){let N=n.get(C);if(C.isVideoTexture&&j(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&N.__version!==C.version){let q=C.image;if(q===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(q.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ee(N,C,y);return}}else C.isExternalTexture&&(N.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,N.__webglTexture,i.TEXTURE0+y)}function X(C,y){let N=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&N.__version!==C.version){ee(N,C,y);return}t.bindTexture(i.TEXTURE_2D_ARRAY,N.__webglTexture,i.TEXTURE0+y)}function F(C,y){let N=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&N.__version!==C.version){ee(N,C,y);return}t.bindTexture(i.TEXTURE_3D,N.__webglTexture,i.TEXTURE0+y)}function z(C,y){let N=n.get(C);if(C.version>0&&N.__version!==C.version){$(N,C,y);return}t.bindTexture(i.TEXTURE_CUBE_MAP,N.__webglTexture,i.TEXTURE0+y)}let J={[ec]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[tc]:i.MIRRORED_REPEAT},ne={[vi]:i.NEAREST,[Bm]:i.NEAREST_MIPMAP_NEAREST,[Va]:i.NEAREST_MIPMAP_LINEAR,[Li]:i.LINEAR,[kc]:i.LINEAR_MIPMAP_NEAREST,[Gs]:i.LINEAR_MIPMAP_LINEAR},te={[Vm]:i.NEVER,[$m]:i.ALWAYS,[Gm]:i.LESS,[Rf]:i.LEQUAL,[Wm]:i.EQUAL,[Ym]:i.GEQUAL,[Xm]:i.GREATER,[qm]:i.NOTEQUAL};function ce(C,y){if(y.type===es&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===Li||y.magFilter===kc||y.magFilter===Va||y.magFilter===Gs||y.minFilter===Li||y.minFilter===kc||y.minFilter===Va||y.minFilter===Gs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,J[y.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,J[y.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,J[y.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,ne[y.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,ne[y.minFilter]),y.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,te[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===vi||y.minFilter!==Va&&y.minFilter!==Gs||y.type===es&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let N=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,N.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function fe(C,y){let N=!1;C.__webglInit===void 0&&(C.__webglInit=!0,y.addEventListener("dispose",E));let q=y.source,oe=f.get(q);oe===void 0&&(oe={},f.set(q,oe));let se=V(y);if(se!==C.__cacheKey){oe[se]===void 0&&(oe[se]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,N=!0),oe[se].usedTimes++;let Ue=oe[C.__cacheKey];Ue!==void 0&&(oe[C.__cacheKey].usedTimes--,Ue.usedTimes===0&&w(y)),C.__cacheKey=se,C.__webglTexture=oe[se].texture}return N}function ye(C,y,N){return Math.floor(Math.floor(C/N)/y)}function _e(C,y,N,q){let se=C.updateRanges;if(se.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,N,q,y.data);else{se.sort((ge,Ce)=>ge.start-Ce.start);let Ue=0;for(let ge=1;ge<se.length;ge++){let Ce=se[Ue],qe=se[ge],Ye=Ce.start+Ce.count,Le=ye(qe.start,y.width,4),Ze=ye(Ce.start,y.width,4);qe.start<=Ye+1&&Le===Ze&&ye(qe.start+qe.count-1,y.width,4)===Le?Ce.count=Math.max(Ce.count,qe.start+qe.count-Ce.start):(++Ue,se[Ue]=qe)}se.length=Ue+1;let xe=i.getParameter(i.UNPACK_ROW_LENGTH),Fe=i.getParameter(i.UNPACK_SKIP_PIXELS),Be=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let ge=0,Ce=se.length;ge<Ce;ge++){let qe=se[ge],Ye=Math.floor(qe.start/4),Le=Math.ceil(qe.count/4),Ze=Ye%y.width,Y=Math.floor(Ye/y.width),Te=Le,Re=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Ze),i.pixelStorei(i.UNPACK_SKIP_ROWS,Y),t.texSubImage2D(i.TEXTURE_2D,0,Ze,Y,Te,Re,N,q,y.data)}C.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,xe),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Fe),i.pixelStorei(i.UNPACK_SKIP_ROWS,Be)}}function ee(C,y,N){let q=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(q=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(q=i.TEXTURE_3D);let oe=fe(C,y),se=y.source;t.bindTexture(q,C.__webglTexture,i.TEXTURE0+N);let Ue=n.get(se);if(se.version!==Ue.__version||oe===!0){t.activeTexture(i.TEXTURE0+N);let xe=xt.getPrimaries(xt.workingColorSpace),Fe=y.colorSpace===ys?null:xt.getPrimaries(y.colorSpace),Be=y.colorSpace===ys||xe===Fe?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Be);let ge=v(y.image,!1,s.maxTextureSize);ge=he(y,ge);let Ce=r.convert(y.format,y.colorSpace),qe=r.convert(y.type),Ye=M(y.internalFormat,Ce,qe,y.colorSpace,y.isVideoTexture);ce(q,y);let Le,Ze=y.mipmaps,Y=y.isVideoTexture!==!0,Te=Ue.__version===void 0||oe===!0,Re=se.dataReady,Ve=P(y,ge);if(y.isDepthTexture)Ye=_(y.format===So,y.type),Te&&(Y?t.texStorage2D(i.TEXTURE_2D,1,Ye,ge.width,ge.height):t.texImage2D(i.TEXTURE_2D,0,Ye,ge.width,ge.height,0,Ce,qe,null));else if(y.isDataTexture)if(Ze.length>0){Y&&Te&&t.texStorage2D(i.TEXTURE_2D,Ve,Ye,Ze[0].width,Ze[0].height);for(let Ee=0,pe=Ze.length;Ee<pe;Ee++)Le=Ze[Ee],Y?Re&&t.texSubImage2D(i.TEXTURE_2D,Ee,0,0,Le.width,Le.height,Ce,qe,Le.data):t.texImage2D(i.TEXTURE_2D,Ee,Ye,Le.width,Le.height,0,Ce,qe,Le.data);y.generateMipmaps=!1}else Y?(Te&&t.texStorage2D(i.TEXTURE_2D,Ve,Ye,ge.width,ge.height),Re&&_e(y,ge,Ce,qe)):t.texImage2D(i.TEXTURE_2D,0,Ye,ge.width,ge.height,0,Ce,qe,ge.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){Y&&Te&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ve,Ye,Ze[0].width,Ze[0].height,ge.depth);for(let Ee=0,pe=Ze.length;Ee<pe;Ee++)if(Le=Ze[Ee],y.format!==xi)if(Ce!==null)if(Y){if(Re)if(y.layerUpdates.size>0){let $e=Ff(Le.width,Le.height,y.format,y.type);for(let st of y.layerUpdates){let Lt=Le.data.subarray(st*$e/Le.data.BYTES_PER_ELEMENT,(st+1)*$e/Le.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Ee,0,0,st,Le.width,Le.height,1,Ce,Lt)}y.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Ee,0,0,0,Le.width,Le.height,ge.depth,Ce,Le.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,Ee,Ye,Le.width,Le.height,ge.depth,0,Le.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Y?Re&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,Ee,0,0,0,Le.width,Le.height,ge.depth,Ce,qe,Le.data):t.texImage3D(i.TEXTURE_2D_ARRAY,Ee,Ye,Le.width,Le.height,ge.depth,0,Ce,qe,Le.data)}else{Y&&Te&&t.texStorage2D(i.TEXTURE_2D,Ve,Ye,Ze[0].width,Ze[0].height);for(let Ee=0,pe=Ze.length;Ee<pe;Ee++)Le=Ze[Ee],y.format!==xi?Ce!==null?Y?Re&&t.compressedTexSubImage2D(i.TEXTURE_2D,Ee,0,0,Le.width,Le.height,Ce,Le.data):t.compressedTexImage2D(i.TEXTURE_2D,Ee,Ye,Le.width,Le.height,0,Le.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Y?Re&&t.texSubImage2D(i.TEXTURE_2D,Ee,0,0,Le.width,Le.height,Ce,qe,Le.data):t.texImage2D(i.TEXTURE_2D,Ee,Ye,Le.width,Le.height,0,Ce,qe,Le.data)}else if(y.isDataArrayTexture)if(Y){if(Te&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ve,Ye,ge.width,ge.height,ge.depth),Re)if(y.layerUpdates.size>0){let Ee=Ff(ge.width,ge.height,y.format,y.type);for(let pe of y.layerUpdates){let $e=ge.data.subarray(pe*Ee/ge.data.BYTES_PER_ELEMENT,(pe+1)*Ee/ge.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,pe,ge.width,ge.height,1,Ce,qe,$e)}y.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ge.width,ge.height,ge.depth,Ce,qe,ge.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Ye,ge.width,ge.height,ge.depth,0,Ce,qe,ge.data);else if(y.isData3DTexture)Y?(Te&&t.texStorage3D(i.TEXTURE_3D,Ve,Ye,ge.width,ge.height,ge.depth),Re&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ge.width,ge.height,ge.depth,Ce,qe,ge.data)):t.texImage3D(i.TEXTURE_3D,0,Ye,ge.width,ge.height,ge.depth,0,Ce,qe,ge.data);else if(y.isFramebufferTexture){if(Te)if(Y)t.texStorage2D(i.TEXTURE_2D,Ve,Ye,ge.width,ge.height);else{let Ee=ge.width,pe=ge.height;for(let $e=0;$e<Ve;$e++)t.texImage2D(i.TEXTURE_2D,$e,Ye,Ee,pe,0,Ce,qe,null),Ee>>=1,pe>>=1}}else if(Ze.length>0){if(Y&&Te){let Ee=Se(Ze[0]);t.texStorage2D(i.TEXTURE_2D,Ve,Ye,Ee.width,Ee.height)}for(let Ee=0,pe=Ze.length;Ee<pe;Ee++)Le=Ze[Ee],Y?Re&&t.texSubImage2D(i.TEXTURE_2D,Ee,0,0,Ce,qe,Le):t.texImage2D(i.TEXTURE_2D,Ee,Ye,Ce,qe,Le);y.generateMipmaps=!1}else if(Y){if(Te){let Ee=Se(ge);t.texStorage2D(i.TEXTURE_2D,Ve,Ye,Ee.width,Ee.height)}Re&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Ce,qe,ge)}else t.texImage2D(i.TEXTURE_2D,0,Ye,Ce,qe,ge);p(y)&&d(q),Ue.__version=se.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function $(C,y,N){if(y.image.length!==6)return;let q=fe(C,y),oe=y.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+N);let se=n.get(oe);if(oe.version!==se.__version||q===!0){t.activeTexture(i.TEXTURE0+N);let Ue=xt.getPrimaries(xt.workingColorSpace),xe=y.colorSpace===ys?null:xt.getPrimaries(y.colorSpace),Fe=y.colorSpace===ys||Ue===xe?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Fe);let Be=y.isCompressedTexture||y.image[0].isCompressedTexture,ge=y.image[0]&&y.image[0].isDataTexture,Ce=[];for(let pe=0;pe<6;pe++)!Be&&!ge?Ce[pe]=v(y.image[pe],!0,s.maxCubemapSize):Ce[pe]=ge?y.image[pe].image:y.image[pe],Ce[pe]=he(y,Ce[pe]);let qe=Ce[0],Ye=r.convert(y.format,y.colorSpace),Le=r.convert(y.type),Ze=M(y.internalFormat,Ye,Le,y.colorSpace),Y=y.isVideoTexture!==!0,Te=se.__version===void 0||q===!0,Re=oe.dataReady,Ve=P(y,qe);ce(i.TEXTURE_CUBE_MAP,y);let Ee;if(Be){Y&&Te&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ve,Ze,qe.width,qe.height);for(let pe=0;pe<6;pe++){Ee=Ce[pe].mipmaps;for(let $e=0;$e<Ee.length;$e++){let st=Ee[$e];y.format!==xi?Ye!==null?Y?Re&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e,0,0,st.width,st.height,Ye,st.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e,Ze,st.width,st.height,0,st.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e,0,0,st.width,st.height,Ye,Le,st.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e,Ze,st.width,st.height,0,Ye,Le,st.data)}}}else{if(Ee=y.mipmaps,Y&&Te){Ee.length>0&&Ve++;let pe=Se(Ce[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ve,Ze,pe.width,pe.height)}for(let pe=0;pe<6;pe++)if(ge){Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,0,0,Ce[pe].width,Ce[pe].height,Ye,Le,Ce[pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,Ze,Ce[pe].width,Ce[pe].height,0,Ye,Le,Ce[pe].data);for(let $e=0;$e<Ee.length;$e++){let Lt=Ee[$e].image[pe].image;Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e+1,0,0,Lt.width,Lt.height,Ye,Le,Lt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e+1,Ze,Lt.width,Lt.height,0,Ye,Le,Lt.data)}}else{Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,0,0,Ye,Le,Ce[pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,Ze,Ye,Le,Ce[pe]);for(let $e=0;$e<Ee.length;$e++){let st=Ee[$e];Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e+1,0,0,Ye,Le,st.image[pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e+1,Ze,Ye,Le,st.image[pe])}}}p(y)&&d(i.TEXTURE_CUBE_MAP),se.__version=oe.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function me(C,y,N,q,oe,se){let Ue=r.convert(N.format,N.colorSpace),xe=r.convert(N.type),Fe=M(N.internalFormat,Ue,xe,N.colorSpace),Be=n.get(y),ge=n.get(N);if(ge.__renderTarget=y,!Be.__hasExternalTextures){let Ce=Math.max(1,y.width>>se),qe=Math.max(1,y.height>>se);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,se,Fe,Ce,qe,y.depth,0,Ue,xe,null):t.texImage2D(oe,se,Fe,Ce,qe,0,Ue,xe,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),le(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,q,oe,ge.__webglTexture,0,ot(y)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,q,oe,ge.__webglTexture,se),t.bindFramebuffer(i.FRAMEBUFFER,null)}function ve(C,y,N){if(i.bindRenderbuffer(i.RENDERBUFFER,C),y.depthBuffer){let q=y.depthTexture,oe=q&&q.isDepthTexture?q.type:null,se=_(y.stencilBuffer,oe),Ue=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=ot(y);le(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,xe,se,y.width,y.height):N?i.renderbufferStorageMultisample(i.RENDERBUFFER,xe,se,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,se,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ue,i.RENDERBUFFER,C)}else{let q=y.textures;for(let oe=0;oe<q.length;oe++){let se=q[oe],Ue=r.convert(se.format,se.colorSpace),xe=r.convert(se.type),Fe=M(se.internalFormat,Ue,xe,se.colorSpace),Be=ot(y);N&&le(y)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Be,Fe,y.width,y.height):le(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Be,Fe,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,Fe,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function be(C,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let q=n.get(y.depthTexture);q.__renderTarget=y,(!q.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),W(y.depthTexture,0);let oe=q.__webglTexture,se=ot(y);if(y.depthTexture.format===co)le(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,oe,0,se):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,oe,0);else if(y.depthTexture.format===So)le(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,oe,0,se):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,oe,0);else throw new Error("Unknown depthTexture format")}function Ge(C){let y=n.get(C),N=C.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==C.depthTexture){let q=C.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),q){let oe=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,q.removeEventListener("dispose",oe)};q.addEventListener("dispose",oe),y.__depthDisposeCallback=oe}y.__boundDepthTexture=q}if(C.depthTexture&&!y.__autoAllocateDepthBuffer){if(N)throw new Error("target.depthTexture not supported in Cube render targets");let q=C.texture.mipmaps;q&&q.length>0?be(y.__webglFramebuffer[0],C):be(y.__webglFramebuffer,C)}else if(N){y.__webglDepthbuffer=[];for(let q=0;q<6;q++)if(t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[q]),y.__webglDepthbuffer[q]===void 0)y.__webglDepthbuffer[q]=i.createRenderbuffer(),ve(y.__webglDepthbuffer[q],C,!1);else{let oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,se=y.__webglDepthbuffer[q];i.bindRenderbuffer(i.RENDERBUFFER,se),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,se)}}else{let q=C.texture.mipmaps;if(q&&q.length>0?t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),ve(y.__webglDepthbuffer,C,!1);else{let oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,se=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,se),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,se)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function dt(C,y,N){let q=n.get(C);y!==void 0&&me(q.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),N!==void 0&&Ge(C)}function H(C){let y=C.texture,N=n.get(C),q=n.get(y);C.addEventListener("dispose",I);let oe=C.textures,se=C.isWebGLCubeRenderTarget===!0,Ue=oe.length>1;if(Ue||(q.__webglTexture===void 0&&(q.__webglTexture=i.createTexture()),q.__version=y.version,o.memory.textures++),se){N.__webglFramebuffer=[];for(let xe=0;xe<6;xe++)if(y.mipmaps&&y.mipmaps.length>0){N.__webglFramebuffer[xe]=[];for(let Fe=0;Fe<y.mipmaps.length;Fe++)N.__webglFramebuffer[xe][Fe]=i.createFramebuffer()}else N.__webglFramebuffer[xe]=i.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){N.__webglFramebuffer=[];for(let xe=0;xe<y.mipmaps.length;xe++)N.__webglFramebuffer[xe]=i.createFramebuffer()}else N.__webglFramebuffer=i.createFramebuffer();if(Ue)for(let xe=0,Fe=oe.length;xe<Fe;xe++){let Be=n.get(oe[xe]);Be.__webglTexture===void 0&&(Be.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&le(C)===!1){N.__webglMultisampledFramebuffer=i.createFramebuffer(),N.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,N.__webglMultisampledFramebuffer);for(let xe=0;xe<oe.length;xe++){let Fe=oe[xe];N.__webglColorRenderbuffer[xe]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,N.__webglColorRenderbuffer[xe]);let Be=r.convert(Fe.format,Fe.colorSpace),ge=r.convert(Fe.type),Ce=M(Fe.internalFormat,Be,ge,Fe.colorSpace,C.isXRRenderTarget===!0),qe=ot(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,qe,Ce,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xe,i.RENDERBUFFER,N.__webglColorRenderbuffer[xe])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(N.__webglDepthRenderbuffer=i.createRenderbuffer(),ve(N.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(se){t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture),ce(i.TEXTURE_CUBE_MAP,y);for(let xe=0;xe<6;xe++)if(y.mipmaps&&y.mipmaps.length>0)for(let Fe=0;Fe<y.mipmaps.length;Fe++)me(N.__webglFramebuffer[xe][Fe],C,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,Fe);else me(N.__webglFramebuffer[xe],C,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xe,0);p(y)&&d(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Ue){for(let xe=0,Fe=oe.length;xe<Fe;xe++){let Be=oe[xe],ge=n.get(Be),Ce=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Ce=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Ce,ge.__webglTexture),ce(Ce,Be),me(N.__webglFramebuffer,C,Be,i.COLOR_ATTACHMENT0+xe,Ce,0),p(Be)&&d(Ce)}t.unbindTexture()}else{let xe=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(xe=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(xe,q.__webglTexture),ce(xe,y),y.mipmaps&&y.mipmaps.length>0)for(let Fe=0;Fe<y.mipmaps.length;Fe++)me(N.__webglFramebuffer[Fe],C,y,i.COLOR_ATTACHMENT0,xe,Fe);else me(N.__webglFramebuffer,C,y,i.COLOR_ATTACHMENT0,xe,0);p(y)&&d(xe),t.unbindTexture()}C.depthBuffer&&Ge(C)}function ht(C){let y=C.textures;for(let N=0,q=y.length;N<q;N++){let oe=y[N];if(p(oe)){let se=b(C),Ue=n.get(oe).__webglTexture;t.bindTexture(se,Ue),d(se),t.unbindTexture()}}}let re=[],we=[];function Pe(C){if(C.samples>0){if(le(C)===!1){let y=C.textures,N=C.width,q=C.height,oe=i.COLOR_BUFFER_BIT,se=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ue=n.get(C),xe=y.length>1;if(xe)for(let Be=0;Be<y.length;Be++)t.bindFramebuffer(i.FRAMEBUFFER,Ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Ue.__webglMultisampledFramebuffer);let Fe=C.texture.mipmaps;Fe&&Fe.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer);for(let Be=0;Be<y.length;Be++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),xe){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ue.__webglColorRenderbuffer[Be]);let ge=n.get(y[Be]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,ge,0)}i.blitFramebuffer(0,0,N,q,0,0,N,q,oe,i.NEAREST),l===!0&&(re.length=0,we.length=0,re.push(i.COLOR_ATTACHMENT0+Be),C.depthBuffer&&C.resolveDepthBuffer===!1&&(re.push(se),we.push(se),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,we)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,re))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),xe)for(let Be=0;Be<y.length;Be++){t.bindFramebuffer(i.FRAMEBUFFER,Ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.RENDERBUFFER,Ue.__webglColorRenderbuffer[Be]);let ge=n.get(y[Be]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.TEXTURE_2D,ge,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ue.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.resolveDepthBuffer===!1&&l){let y=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function ot(C){return Math.min(s.maxSamples,C.samples)}function le(C){let y=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function j(C){let y=o.render.frame;u.get(C)!==y&&(u.set(C,y),C.update())}function he(C,y){let N=C.colorSpace,q=C.format,oe=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||N!==cr&&N!==ys&&(xt.getTransfer(N)===Pt?(q!==xi||oe!==Fi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",N)),y}function Se(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=B,this.resetTextureUnits=k,this.setTexture2D=W,this.setTexture2DArray=X,this.setTexture3D=F,this.setTextureCube=z,this.rebindTextures=dt,this.setupRenderTarget=H,this.updateRenderTargetMipmap=ht,this.updateMultisampleRenderTarget=Pe,this.setupDepthRenderbuffer=Ge,this.setupFrameBufferTexture=me,this.useMultisampledRTT=le}function LS(i,e){function t(n,s=ys){let r,o=xt.getTransfer(s);if(n===Fi)return i.UNSIGNED_BYTE;if(n===Vc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Gc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===bf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Mf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===_f)return i.BYTE;if(n===yf)return i.SHORT;if(n===bo)return i.UNSIGNED_SHORT;if(n===Hc)return i.INT;if(n===Ws)return i.UNSIGNED_INT;if(n===es)return i.FLOAT;if(n===Mo)return i.HALF_FLOAT;if(n===wf)return i.ALPHA;if(n===Sf)return i.RGB;if(n===xi)return i.RGBA;if(n===co)return i.DEPTH_COMPONENT;if(n===So)return i.DEPTH_STENCIL;if(n===Ef)return i.RED;if(n===Wc)return i.RED_INTEGER;if(n===Tf)return i.RG;if(n===Xc)return i.RG_INTEGER;if(n===qc)return i.RGBA_INTEGER;if(n===Ga||n===Wa||n===Xa||n===qa)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ga)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ga)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Yc||n===$c||n===Zc||n===Kc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Yc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===$c)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Zc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Kc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Jc||n===jc||n===Qc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Jc||n===jc)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Qc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===eh||n===th||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===fh||n===dh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===eh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===th)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===nh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ih)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===sh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===rh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ah)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===lh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ch)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===dh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ph||n===mh||n===gh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===ph)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===mh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===gh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===vh||n===xh||n===_h||n===yh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===vh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===xh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===_h)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===yh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===wo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var DS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,US=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Zf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Sa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ai({vertexShader:DS,fragmentShader:US,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new je(new Ra(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Kf=class extends Zi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,m=null,g=null,v=typeof XRWebGLBinding<"u",p=new Zf,d={},b=t.getContextAttributes(),M=null,_=null,P=[],E=[],I=new Oe,D=null,w=new Dn;w.viewport=new It;let S=new Dn;S.viewport=new It;let A=[w,S],k=new Pc,B=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let $=P[ee];return $===void 0&&($=new po,P[ee]=$),$.getTargetRaySpace()},this.getControllerGrip=function(ee){let $=P[ee];return $===void 0&&($=new po,P[ee]=$),$.getGripSpace()},this.getHand=function(ee){let $=P[ee];return $===void 0&&($=new po,P[ee]=$),$.getHandSpace()};function W(ee){let $=E.indexOf(ee.inputSource);if($===-1)return;let me=P[$];me!==void 0&&(me.update(ee.inputSource,ee.frame,c||o),me.dispatchEvent({type:ee.type,data:ee.inputSource}))}function X(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",X),s.removeEventListener("inputsourceschange",F);for(let ee=0;ee<P.length;ee++){let $=E[ee];$!==null&&(E[ee]=null,P[ee].disconnect($))}B=null,V=null,p.reset();for(let ee in d)delete d[ee];e.setRenderTarget(M),m=null,f=null,h=null,s=null,_=null,_e.stop(),n.isPresenting=!1,e.setPixelRatio(D),e.setSize(I.width,I.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:m},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",X),s.addEventListener("inputsourceschange",F),b.xrCompatible!==!0&&await t.makeXRCompatible(),D=e.getPixelRatio(),e.getSize(I),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let me=null,ve=null,be=null;b.depth&&(be=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,me=b.stencil?So:co,ve=b.stencil?wo:Ws);let Ge={colorFormat:t.RGBA8,depthFormat:be,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Ge),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),_=new Ki(f.textureWidth,f.textureHeight,{format:xi,type:Fi,depthTexture:new wa(f.textureWidth,f.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,me),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let me={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,me),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),_=new Ki(m.framebufferWidth,m.framebufferHeight,{format:xi,type:Fi,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),_e.setContext(s),_e.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function F(ee){for(let $=0;$<ee.removed.length;$++){let me=ee.removed[$],ve=E.indexOf(me);ve>=0&&(E[ve]=null,P[ve].disconnect(me))}for(let $=0;$<ee.added.length;$++){let me=ee.added[$],ve=E.indexOf(me);if(ve===-1){for(let Ge=0;Ge<P.length;Ge++)if(Ge>=E.length){E.push(me),ve=Ge;break}else if(E[Ge]===null){E[Ge]=me,ve=Ge;break}if(ve===-1)break}let be=P[ve];be&&be.connect(me)}}let z=new L,J=new L;function ne(ee,$,me){z.setFromMatrixPosition($.matrixWorld),J.setFromMatrixPosition(me.matrixWorld);let ve=z.distanceTo(J),be=$.projectionMatrix.elements,Ge=me.projectionMatrix.elements,dt=be[14]/(be[10]-1),H=be[14]/(be[10]+1),ht=(be[9]+1)/be[5],re=(be[9]-1)/be[5],we=(be[8]-1)/be[0],Pe=(Ge[8]+1)/Ge[0],ot=dt*we,le=dt*Pe,j=ve/(-we+Pe),he=j*-we;if($.matrixWorld.decompose(ee.position,ee.quaternion,ee.scale),ee.translateX(he),ee.translateZ(j),ee.matrixWorld.compose(ee.position,ee.quaternion,ee.scale),ee.matrixWorldInverse.copy(ee.matrixWorld).invert(),be[10]===-1)ee.projectionMatrix.copy($.projectionMatrix),ee.projectionMatrixInverse.copy($.projectionMatrixInverse);else{let Se=dt+j,C=H+j,y=ot-he,N=le+(ve-he),q=ht*H/C*Se,oe=re*H/C*Se;ee.projectionMatrix.makePerspective(y,N,q,oe,Se,C),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert()}}function te(ee,$){$===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices($.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let $=ee.near,me=ee.far;p.texture!==null&&(p.depthNear>0&&($=p.depthNear),p.depthFar>0&&(me=p.depthFar)),k.near=S.near=w.near=$,k.far=S.far=w.far=me,(B!==k.near||V!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),B=k.near,V=k.far),k.layers.mask=ee.layers.mask|6,w.layers.mask=k.layers.mask&3,S.layers.mask=k.layers.mask&5;let ve=ee.parent,be=k.cameras;te(k,ve);for(let Ge=0;Ge<be.length;Ge++)te(be[Ge],ve);be.length===2?ne(k,w,S):k.projectionMatrix.copy(w.projectionMatrix),ce(ee,k,ve)};function ce(ee,$,me){me===null?ee.matrix.copy($.matrixWorld):(ee.matrix.copy(me.matrixWorld),ee.matrix.invert(),ee.matrix.multiply($.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy($.projectionMatrix),ee.projectionMatrixInverse.copy($.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=ho*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(f===null&&m===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(k)},this.getCameraTexture=function(ee){return d[ee]};let fe=null;function ye(ee,$){if(u=$.getViewerPose(c||o),g=$,u!==null){let me=u.views;m!==null&&(e.setRenderTargetFramebuffer(_,m.framebuffer),e.setRenderTarget(_));let ve=!1;me.length!==k.cameras.length&&(k.cameras.length=0,ve=!0);for(let H=0;H<me.length;H++){let ht=me[H],re=null;if(m!==null)re=m.getViewport(ht);else{let Pe=h.getViewSubImage(f,ht);re=Pe.viewport,H===0&&(e.setRenderTargetTextures(_,Pe.colorTexture,Pe.depthStencilTexture),e.setRenderTarget(_))}let we=A[H];we===void 0&&(we=new Dn,we.layers.enable(H),we.viewport=new It,A[H]=we),we.matrix.fromArray(ht.transform.matrix),we.matrix.decompose(we.position,we.quaternion,we.scale),we.projectionMatrix.fromArray(ht.projectionMatrix),we.projectionMatrixInverse.copy(we.projectionMatrix).invert(),we.viewport.set(re.x,re.y,re.width,re.height),H===0&&(k.matrix.copy(we.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),ve===!0&&k.cameras.push(we)}let be=s.enabledFeatures;if(be&&be.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=n.getBinding();let H=h.getDepthInformation(me[0]);H&&H.isValid&&H.texture&&p.init(H,s.renderState)}if(be&&be.includes("camera-access")&&v){e.state.unbindTexture(),h=n.getBinding();for(let H=0;H<me.length;H++){let ht=me[H].camera;if(ht){let re=d[ht];re||(re=new Sa,d[ht]=re);let we=h.getCameraImage(ht);re.sourceTexture=we}}}}for(let me=0;me<P.length;me++){let ve=E[me],be=P[me];ve!==null&&be!==void 0&&be.update(ve,$,c||o)}fe&&fe(ee,$),$.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:$}),g=null}let _e=new wg;_e.setAnimationLoop(ye),this.setAnimationLoop=function(ee){fe=ee},this.dispose=function(){}}},yr=new Ui,NS=new Ut;function FS(i,e){function t(p,d){p.matrixAutoUpdate===!0&&p.updateMatrix(),d.value.copy(p.matrix)}function n(p,d){d.color.getRGB(p.fogColor.value,Lf(i)),d.isFog?(p.fogNear.value=d.near,p.fogFar.value=d.far):d.isFogExp2&&(p.fogDensity.value=d.density)}function s(p,d,b,M,_){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(p,d):d.isMeshToonMaterial?(r(p,d),h(p,d)):d.isMeshPhongMaterial?(r(p,d),u(p,d)):d.isMeshStandardMaterial?(r(p,d),f(p,d),d.isMeshPhysicalMaterial&&m(p,d,_)):d.isMeshMatcapMaterial?(r(p,d),g(p,d)):d.isMeshDepthMaterial?r(p,d):d.isMeshDistanceMaterial?(r(p,d),v(p,d)):d.isMeshNormalMaterial?r(p,d):d.isLineBasicMaterial?(o(p,d),d.isLineDashedMaterial&&a(p,d)):d.isPointsMaterial?l(p,d,b,M):d.isSpriteMaterial?c(p,d):d.isShadowMaterial?(p.color.value.copy(d.color),p.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(p,d){p.opacity.value=d.opacity,d.color&&p.diffuse.value.copy(d.color),d.emissive&&p.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(p.map.value=d.map,t(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.bumpMap&&(p.bumpMap.value=d.bumpMap,t(d.bumpMap,p.bumpMapTransform),p.bumpScale.value=d.bumpScale,d.side===Wn&&(p.bumpScale.value*=-1)),d.normalMap&&(p.normalMap.value=d.normalMap,t(d.normalMap,p.normalMapTransform),p.normalScale.value.copy(d.normalScale),d.side===Wn&&p.normalScale.value.negate()),d.displacementMap&&(p.displacementMap.value=d.displacementMap,t(d.displacementMap,p.displacementMapTransform),p.displacementScale.value=d.displacementScale,p.displacementBias.value=d.displacementBias),d.emissiveMap&&(p.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,p.emissiveMapTransform)),d.specularMap&&(p.specularMap.value=d.specularMap,t(d.specularMap,p.specularMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest);let b=e.get(d),M=b.envMap,_=b.envMapRotation;M&&(p.envMap.value=M,yr.copy(_),yr.x*=-1,yr.y*=-1,yr.z*=-1,M.isCubeTexture&&M.isRenderTargetTexture===!1&&(yr.y*=-1,yr.z*=-1),p.envMapRotation.value.setFromMatrix4(NS.makeRotationFromEuler(yr)),p.flipEnvMap.value=M.isCubeTexture&&M.isRenderTargetTexture===!1?-1:1,p.reflectivity.value=d.reflectivity,p.ior.value=d.ior,p.refractionRatio.value=d.refractionRatio),d.lightMap&&(p.lightMap.value=d.lightMap,p.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,p.lightMapTransform)),d.aoMap&&(p.aoMap.value=d.aoMap,p.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,p.aoMapTransform))}function o(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,d.map&&(p.map.value=d.map,t(d.map,p.mapTransform))}function a(p,d){p.dashSize.value=d.dashSize,p.totalSize.value=d.dashSize+d.gapSize,p.scale.value=d.scale}function l(p,d,b,M){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.size.value=d.size*b,p.scale.value=M*.5,d.map&&(p.map.value=d.map,t(d.map,p.uvTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function c(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.rotation.value=d.rotation,d.map&&(p.map.value=d.map,t(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function u(p,d){p.specular.value.copy(d.specular),p.shininess.value=Math.max(d.shininess,1e-4)}function h(p,d){d.gradientMap&&(p.gradientMap.value=d.gradientMap)}function f(p,d){p.metalness.value=d.metalness,d.metalnessMap&&(p.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,p.metalnessMapTransform)),p.roughness.value=d.roughness,d.roughnessMap&&(p.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,p.roughnessMapTransform)),d.envMap&&(p.envMapIntensity.value=d.envMapIntensity)}function m(p,d,b){p.ior.value=d.ior,d.sheen>0&&(p.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),p.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(p.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,p.sheenColorMapTransform)),d.sheenRoughnessMap&&(p.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,p.sheenRoughnessMapTransform))),d.clearcoat>0&&(p.clearcoat.value=d.clearcoat,p.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(p.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,p.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(p.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Wn&&p.clearcoatNormalScale.value.negate())),d.dispersion>0&&(p.dispersion.value=d.dispersion),d.iridescence>0&&(p.iridescence.value=d.iridescence,p.iridescenceIOR.value=d.iridescenceIOR,p.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(p.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,p.iridescenceMapTransform)),d.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),d.transmission>0&&(p.transmission.value=d.transmission,p.transmissionSamplerMap.value=b.texture,p.transmissionSamplerSize.value.set(b.width,b.height),d.transmissionMap&&(p.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,p.transmissionMapTransform)),p.thickness.value=d.thickness,d.thicknessMap&&(p.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=d.attenuationDistance,p.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(p.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(p.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=d.specularIntensity,p.specularColor.value.copy(d.specularColor),d.specularColorMap&&(p.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,p.specularColorMapTransform)),d.specularIntensityMap&&(p.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,d){d.matcap&&(p.matcap.value=d.matcap)}function v(p,d){let b=e.get(d).light;p.referencePosition.value.setFromMatrixPosition(b.matrixWorld),p.nearDistance.value=b.shadow.camera.near,p.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function OS(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,M){let _=M.program;n.uniformBlockBinding(b,_)}function c(b,M){let _=s[b.id];_===void 0&&(g(b),_=u(b),s[b.id]=_,b.addEventListener("dispose",p));let P=M.program;n.updateUBOMapping(b,P);let E=e.render.frame;r[b.id]!==E&&(f(b),r[b.id]=E)}function u(b){let M=h();b.__bindingPointIndex=M;let _=i.createBuffer(),P=b.__size,E=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,_),i.bufferData(i.UNIFORM_BUFFER,P,E),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,M,_),_}function h(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(b){let M=s[b.id],_=b.uniforms,P=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let E=0,I=_.length;E<I;E++){let D=Array.isArray(_[E])?_[E]:[_[E]];for(let w=0,S=D.length;w<S;w++){let A=D[w];if(m(A,E,w,P)===!0){let k=A.__offset,B=Array.isArray(A.value)?A.value:[A.value],V=0;for(let W=0;W<B.length;W++){let X=B[W],F=v(X);typeof X=="number"||typeof X=="boolean"?(A.__data[0]=X,i.bufferSubData(i.UNIFORM_BUFFER,k+V,A.__data)):X.isMatrix3?(A.__data[0]=X.elements[0],A.__data[1]=X.elements[1],A.__data[2]=X.elements[2],A.__data[3]=0,A.__data[4]=X.elements[3],A.__data[5]=X.elements[4],A.__data[6]=X.elements[5],A.__data[7]=0,A.__data[8]=X.elements[6],A.__data[9]=X.elements[7],A.__data[10]=X.elements[8],A.__data[11]=0):(X.toArray(A.__data,V),V+=F.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,k,A.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(b,M,_,P){let E=b.value,I=M+"_"+_;if(P[I]===void 0)return typeof E=="number"||typeof E=="boolean"?P[I]=E:P[I]=E.clone(),!0;{let D=P[I];if(typeof E=="number"||typeof E=="boolean"){if(D!==E)return P[I]=E,!0}else if(D.equals(E)===!1)return D.copy(E),!0}return!1}function g(b){let M=b.uniforms,_=0,P=16;for(let I=0,D=M.length;I<D;I++){let w=Array.isArray(M[I])?M[I]:[M[I]];for(let S=0,A=w.length;S<A;S++){let k=w[S],B=Array.isArray(k.value)?k.value:[k.value];for(let V=0,W=B.length;V<W;V++){let X=B[V],F=v(X),z=_%P,J=z%F.boundary,ne=z+J;_+=J,ne!==0&&P-ne<F.storage&&(_+=P-ne),k.__data=new Float32Array(F.storage/Float32Array.BYTES_PER_ELEMENT),k.__offset=_,_+=F.storage}}}let E=_%P;return E>0&&(_+=P-E),b.__size=_,b.__cache={},this}function v(b){let M={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(M.boundary=4,M.storage=4):b.isVector2?(M.boundary=8,M.storage=8):b.isVector3||b.isColor?(M.boundary=16,M.storage=12):b.isVector4?(M.boundary=16,M.storage=16):b.isMatrix3?(M.boundary=48,M.storage=48):b.isMatrix4?(M.boundary=64,M.storage=64):b.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",b),M}function p(b){let M=b.target;M.removeEventListener("dispose",p);let _=o.indexOf(M.__bindingPointIndex);o.splice(_,1),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function d(){for(let b in s)i.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var Ah=class{constructor(e={}){let{canvas:t=Zm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let g=new Uint32Array(4),v=new Int32Array(4),p=null,d=null,b=[],M=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=_s,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let _=this,P=!1;this._outputColorSpace=Gn;let E=0,I=0,D=null,w=-1,S=null,A=new It,k=new It,B=null,V=new at(0),W=0,X=t.width,F=t.height,z=1,J=null,ne=null,te=new It(0,0,X,F),ce=new It(0,0,X,F),fe=!1,ye=new xo,_e=!1,ee=!1,$=new Ut,me=new L,ve=new It,be={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ge=!1;function dt(){return D===null?z:1}let H=n;function ht(R,K){return t.getContext(R,K)}try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"180"}`),t.addEventListener("webglcontextlost",Re,!1),t.addEventListener("webglcontextrestored",Ve,!1),t.addEventListener("webglcontextcreationerror",Ee,!1),H===null){let K="webgl2";if(H=ht(K,R),H===null)throw ht(K)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(R){throw console.error("THREE.WebGLRenderer: "+R.message),R}let re,we,Pe,ot,le,j,he,Se,C,y,N,q,oe,se,Ue,xe,Fe,Be,ge,Ce,qe,Ye,Le,Ze;function Y(){re=new tw(H),re.init(),Ye=new LS(H,re),we=new $M(H,re,e,Ye),Pe=new PS(H,re),we.reversedDepthBuffer&&f&&Pe.buffers.depth.setReversed(!0),ot=new sw(H),le=new vS,j=new IS(H,re,Pe,le,we,Ye,ot),he=new KM(_),Se=new ew(_),C=new hy(H),Le=new qM(H,C),y=new nw(H,C,ot,Le),N=new ow(H,y,C,ot),ge=new rw(H,we,j),xe=new ZM(le),q=new gS(_,he,Se,re,we,Le,xe),oe=new FS(_,le),se=new _S,Ue=new ES(re),Be=new XM(_,he,Se,Pe,N,m,l),Fe=new RS(_,N,we),Ze=new OS(H,ot,we,Pe),Ce=new YM(H,re,ot),qe=new iw(H,re,ot),ot.programs=q.programs,_.capabilities=we,_.extensions=re,_.properties=le,_.renderLists=se,_.shadowMap=Fe,_.state=Pe,_.info=ot}Y();let Te=new Kf(_,H);this.xr=Te,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let R=re.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=re.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return z},this.setPixelRatio=function(R){R!==void 0&&(z=R,this.setSize(X,F,!1))},this.getSize=function(R){return R.set(X,F)},this.setSize=function(R,K,ue=!0){if(Te.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}X=R,F=K,t.width=Math.floor(R*z),t.height=Math.floor(K*z),ue===!0&&(t.style.width=R+"px",t.style.height=K+"px"),this.setViewport(0,0,R,K)},this.getDrawingBufferSize=function(R){return R.set(X*z,F*z).floor()},this.setDrawingBufferSize=function(R,K,ue){X=R,F=K,z=ue,t.width=Math.floor(R*ue),t.height=Math.floor(K*ue),this.setViewport(0,0,R,K)},this.getCurrentViewport=function(R){return R.copy(A)},this.getViewport=function(R){return R.copy(te)},this.setViewport=function(R,K,ue,ae){R.isVector4?te.set(R.x,R.y,R.z,R.w):te.set(R,K,ue,ae),Pe.viewport(A.copy(te).multiplyScalar(z).round())},this.getScissor=function(R){return R.copy(ce)},this.setScissor=function(R,K,ue,ae){R.isVector4?ce.set(R.x,R.y,R.z,R.w):ce.set(R,K,ue,ae),Pe.scissor(k.copy(ce).multiplyScalar(z).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(R){Pe.setScissorTest(fe=R)},this.setOpaqueSort=function(R){J=R},this.setTransparentSort=function(R){ne=R},this.getClearColor=function(R){return R.copy(Be.getClearColor())},this.setClearColor=function(){Be.setClearColor(...arguments)},this.getClearAlpha=function(){return Be.getClearAlpha()},this.setClearAlpha=function(){Be.setClearAlpha(...arguments)},this.clear=function(R=!0,K=!0,ue=!0){let ae=0;if(R){let Q=!1;if(D!==null){let Ae=D.texture.format;Q=Ae===qc||Ae===Xc||Ae===Wc}if(Q){let Ae=D.texture.type,Ne=Ae===Fi||Ae===Ws||Ae===bo||Ae===wo||Ae===Vc||Ae===Gc,We=Be.getClearColor(),ze=Be.getClearAlpha(),et=We.r,tt=We.g,Ke=We.b;Ne?(g[0]=et,g[1]=tt,g[2]=Ke,g[3]=ze,H.clearBufferuiv(H.COLOR,0,g)):(v[0]=et,v[1]=tt,v[2]=Ke,v[3]=ze,H.clearBufferiv(H.COLOR,0,v))}else ae|=H.COLOR_BUFFER_BIT}K&&(ae|=H.DEPTH_BUFFER_BIT),ue&&(ae|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H.clear(ae)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",Re,!1),t.removeEventListener("webglcontextrestored",Ve,!1),t.removeEventListener("webglcontextcreationerror",Ee,!1),Be.dispose(),se.dispose(),Ue.dispose(),le.dispose(),he.dispose(),Se.dispose(),N.dispose(),Le.dispose(),Ze.dispose(),q.dispose(),Te.dispose(),Te.removeEventListener("sessionstart",Ft),Te.removeEventListener("sessionend",ei),Yn.stop()};function Re(R){R.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),P=!0}function Ve(){console.log("THREE.WebGLRenderer: Context Restored."),P=!1;let R=ot.autoReset,K=Fe.enabled,ue=Fe.autoUpdate,ae=Fe.needsUpdate,Q=Fe.type;Y(),ot.autoReset=R,Fe.enabled=K,Fe.autoUpdate=ue,Fe.needsUpdate=ae,Fe.type=Q}function Ee(R){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function pe(R){let K=R.target;K.removeEventListener("dispose",pe),$e(K)}function $e(R){st(R),le.remove(R)}function st(R){let K=le.get(R).programs;K!==void 0&&(K.forEach(function(ue){q.releaseProgram(ue)}),R.isShaderMaterial&&q.releaseShaderCache(R))}this.renderBufferDirect=function(R,K,ue,ae,Q,Ae){K===null&&(K=be);let Ne=Q.isMesh&&Q.matrixWorld.determinant()<0,We=os(R,K,ue,ae,Q);Pe.setMaterial(ae,Ne);let ze=ue.index,et=1;if(ae.wireframe===!0){if(ze=y.getWireframeAttribute(ue),ze===void 0)return;et=2}let tt=ue.drawRange,Ke=ue.attributes.position,ut=tt.start*et,bt=(tt.start+tt.count)*et;Ae!==null&&(ut=Math.max(ut,Ae.start*et),bt=Math.min(bt,(Ae.start+Ae.count)*et)),ze!==null?(ut=Math.max(ut,0),bt=Math.min(bt,ze.count)):Ke!=null&&(ut=Math.max(ut,0),bt=Math.min(bt,Ke.count));let kt=bt-ut;if(kt<0||kt===1/0)return;Le.setup(Q,ae,We,ue,ze);let Rt,lt=Ce;if(ze!==null&&(Rt=C.get(ze),lt=qe,lt.setIndex(Rt)),Q.isMesh)ae.wireframe===!0?(Pe.setLineWidth(ae.wireframeLinewidth*dt()),lt.setMode(H.LINES)):lt.setMode(H.TRIANGLES);else if(Q.isLine){let Qe=ae.linewidth;Qe===void 0&&(Qe=1),Pe.setLineWidth(Qe*dt()),Q.isLineSegments?lt.setMode(H.LINES):Q.isLineLoop?lt.setMode(H.LINE_LOOP):lt.setMode(H.LINE_STRIP)}else Q.isPoints?lt.setMode(H.POINTS):Q.isSprite&&lt.setMode(H.TRIANGLES);if(Q.isBatchedMesh)if(Q._multiDrawInstances!==null)uo("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),lt.renderMultiDrawInstances(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount,Q._multiDrawInstances);else if(re.get("WEBGL_multi_draw"))lt.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let Qe=Q._multiDrawStarts,Ht=Q._multiDrawCounts,gt=Q._multiDrawCount,Rn=ze?C.get(ze).bytesPerElement:1,ws=le.get(ae).currentProgram.getUniforms();for(let On=0;On<gt;On++)ws.setValue(H,"_gl_DrawID",On),lt.render(Qe[On]/Rn,Ht[On])}else if(Q.isInstancedMesh)lt.renderInstances(ut,kt,Q.count);else if(ue.isInstancedBufferGeometry){let Qe=ue._maxInstanceCount!==void 0?ue._maxInstanceCount:1/0,Ht=Math.min(ue.instanceCount,Qe);lt.renderInstances(ut,kt,Ht)}else lt.render(ut,kt)};function Lt(R,K,ue){R.transparent===!0&&R.side===Sn&&R.forceSinglePass===!1?(R.side=Wn,R.needsUpdate=!0,Zs(R,K,ue),R.side=gs,R.needsUpdate=!0,Zs(R,K,ue),R.side=Sn):Zs(R,K,ue)}this.compile=function(R,K,ue=null){ue===null&&(ue=R),d=Ue.get(ue),d.init(K),M.push(d),ue.traverseVisible(function(Q){Q.isLight&&Q.layers.test(K.layers)&&(d.pushLight(Q),Q.castShadow&&d.pushShadow(Q))}),R!==ue&&R.traverseVisible(function(Q){Q.isLight&&Q.layers.test(K.layers)&&(d.pushLight(Q),Q.castShadow&&d.pushShadow(Q))}),d.setupLights();let ae=new Set;return R.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Ae=Q.material;if(Ae)if(Array.isArray(Ae))for(let Ne=0;Ne<Ae.length;Ne++){let We=Ae[Ne];Lt(We,ue,Q),ae.add(We)}else Lt(Ae,ue,Q),ae.add(Ae)}),d=M.pop(),ae},this.compileAsync=function(R,K,ue=null){let ae=this.compile(R,K,ue);return new Promise(Q=>{function Ae(){if(ae.forEach(function(Ne){le.get(Ne).currentProgram.isReady()&&ae.delete(Ne)}),ae.size===0){Q(R);return}setTimeout(Ae,10)}re.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let yt=null;function bn(R){yt&&yt(R)}function Ft(){Yn.stop()}function ei(){Yn.start()}let Yn=new wg;Yn.setAnimationLoop(bn),typeof self<"u"&&Yn.setContext(self),this.setAnimationLoop=function(R){yt=R,Te.setAnimationLoop(R),R===null?Yn.stop():Yn.start()},Te.addEventListener("sessionstart",Ft),Te.addEventListener("sessionend",ei),this.render=function(R,K){if(K!==void 0&&K.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),K.parent===null&&K.matrixWorldAutoUpdate===!0&&K.updateMatrixWorld(),Te.enabled===!0&&Te.isPresenting===!0&&(Te.cameraAutoUpdate===!0&&Te.updateCamera(K),K=Te.getCamera()),R.isScene===!0&&R.onBeforeRender(_,R,K,D),d=Ue.get(R,M.length),d.init(K),M.push(d),$.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),ye.setFromProjectionMatrix($,Ii,K.reversedDepth),ee=this.localClippingEnabled,_e=xe.init(this.clippingPlanes,ee),p=se.get(R,b.length),p.init(),b.push(p),Te.enabled===!0&&Te.isPresenting===!0){let Ae=_.xr.getDepthSensingMesh();Ae!==null&&Hi(Ae,K,-1/0,_.sortObjects)}Hi(R,K,0,_.sortObjects),p.finish(),_.sortObjects===!0&&p.sort(J,ne),Ge=Te.enabled===!1||Te.isPresenting===!1||Te.hasDepthSensing()===!1,Ge&&Be.addToRenderList(p,R),this.info.render.frame++,_e===!0&&xe.beginShadows();let ue=d.state.shadowsArray;Fe.render(ue,R,K),_e===!0&&xe.endShadows(),this.info.autoReset===!0&&this.info.reset();let ae=p.opaque,Q=p.transmissive;if(d.setupLights(),K.isArrayCamera){let Ae=K.cameras;if(Q.length>0)for(let Ne=0,We=Ae.length;Ne<We;Ne++){let ze=Ae[Ne];rs(ae,Q,R,ze)}Ge&&Be.render(R);for(let Ne=0,We=Ae.length;Ne<We;Ne++){let ze=Ae[Ne];Fn(p,R,ze,ze.viewport)}}else Q.length>0&&rs(ae,Q,R,K),Ge&&Be.render(R),Fn(p,R,K);D!==null&&I===0&&(j.updateMultisampleRenderTarget(D),j.updateRenderTargetMipmap(D)),R.isScene===!0&&R.onAfterRender(_,R,K),Le.resetDefaultState(),w=-1,S=null,M.pop(),M.length>0?(d=M[M.length-1],_e===!0&&xe.setGlobalState(_.clippingPlanes,d.state.camera)):d=null,b.pop(),b.length>0?p=b[b.length-1]:p=null};function Hi(R,K,ue,ae){if(R.visible===!1)return;if(R.layers.test(K.layers)){if(R.isGroup)ue=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(K);else if(R.isLight)d.pushLight(R),R.castShadow&&d.pushShadow(R);else if(R.isSprite){if(!R.frustumCulled||ye.intersectsSprite(R)){ae&&ve.setFromMatrixPosition(R.matrixWorld).applyMatrix4($);let Ne=N.update(R),We=R.material;We.visible&&p.push(R,Ne,We,ue,ve.z,null)}}else if((R.isMesh||R.isLine||R.isPoints)&&(!R.frustumCulled||ye.intersectsObject(R))){let Ne=N.update(R),We=R.material;if(ae&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),ve.copy(R.boundingSphere.center)):(Ne.boundingSphere===null&&Ne.computeBoundingSphere(),ve.copy(Ne.boundingSphere.center)),ve.applyMatrix4(R.matrixWorld).applyMatrix4($)),Array.isArray(We)){let ze=Ne.groups;for(let et=0,tt=ze.length;et<tt;et++){let Ke=ze[et],ut=We[Ke.materialIndex];ut&&ut.visible&&p.push(R,Ne,ut,ue,ve.z,Ke)}}else We.visible&&p.push(R,Ne,We,ue,ve.z,null)}}let Ae=R.children;for(let Ne=0,We=Ae.length;Ne<We;Ne++)Hi(Ae[Ne],K,ue,ae)}function Fn(R,K,ue,ae){let Q=R.opaque,Ae=R.transmissive,Ne=R.transparent;d.setupLightsView(ue),_e===!0&&xe.setGlobalState(_.clippingPlanes,ue),ae&&Pe.viewport(A.copy(ae)),Q.length>0&&bi(Q,K,ue),Ae.length>0&&bi(Ae,K,ue),Ne.length>0&&bi(Ne,K,ue),Pe.buffers.depth.setTest(!0),Pe.buffers.depth.setMask(!0),Pe.buffers.color.setMask(!0),Pe.setPolygonOffset(!1)}function rs(R,K,ue,ae){if((ue.isScene===!0?ue.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[ae.id]===void 0&&(d.state.transmissionRenderTarget[ae.id]=new Ki(1,1,{generateMipmaps:!0,type:re.has("EXT_color_buffer_half_float")||re.has("EXT_color_buffer_float")?Mo:Fi,minFilter:Gs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:xt.workingColorSpace}));let Ae=d.state.transmissionRenderTarget[ae.id],Ne=ae.viewport||A;Ae.setSize(Ne.z*_.transmissionResolutionScale,Ne.w*_.transmissionResolutionScale);let We=_.getRenderTarget(),ze=_.getActiveCubeFace(),et=_.getActiveMipmapLevel();_.setRenderTarget(Ae),_.getClearColor(V),W=_.getClearAlpha(),W<1&&_.setClearColor(16777215,.5),_.clear(),Ge&&Be.render(ue);let tt=_.toneMapping;_.toneMapping=_s;let Ke=ae.viewport;if(ae.viewport!==void 0&&(ae.viewport=void 0),d.setupLightsView(ae),_e===!0&&xe.setGlobalState(_.clippingPlanes,ae),bi(R,ue,ae),j.updateMultisampleRenderTarget(Ae),j.updateRenderTargetMipmap(Ae),re.has("WEBGL_multisampled_render_to_texture")===!1){let ut=!1;for(let bt=0,kt=K.length;bt<kt;bt++){let Rt=K[bt],lt=Rt.object,Qe=Rt.geometry,Ht=Rt.material,gt=Rt.group;if(Ht.side===Sn&&lt.layers.test(ae.layers)){let Rn=Ht.side;Ht.side=Wn,Ht.needsUpdate=!0,Go(lt,ue,ae,Qe,Ht,gt),Ht.side=Rn,Ht.needsUpdate=!0,ut=!0}}ut===!0&&(j.updateMultisampleRenderTarget(Ae),j.updateRenderTargetMipmap(Ae))}_.setRenderTarget(We,ze,et),_.setClearColor(V,W),Ke!==void 0&&(ae.viewport=Ke),_.toneMapping=tt}function bi(R,K,ue){let ae=K.isScene===!0?K.overrideMaterial:null;for(let Q=0,Ae=R.length;Q<Ae;Q++){let Ne=R[Q],We=Ne.object,ze=Ne.geometry,et=Ne.group,tt=Ne.material;tt.allowOverride===!0&&ae!==null&&(tt=ae),We.layers.test(ue.layers)&&Go(We,K,ue,ze,tt,et)}}function Go(R,K,ue,ae,Q,Ae){R.onBeforeRender(_,K,ue,ae,Q,Ae),R.modelViewMatrix.multiplyMatrices(ue.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Q.onBeforeRender(_,K,ue,ae,R,Ae),Q.transparent===!0&&Q.side===Sn&&Q.forceSinglePass===!1?(Q.side=Wn,Q.needsUpdate=!0,_.renderBufferDirect(ue,K,ae,Q,R,Ae),Q.side=gs,Q.needsUpdate=!0,_.renderBufferDirect(ue,K,ae,Q,R,Ae),Q.side=Sn):_.renderBufferDirect(ue,K,ae,Q,R,Ae),R.onAfterRender(_,K,ue,ae,Q,Ae)}function Zs(R,K,ue){K.isScene!==!0&&(K=be);let ae=le.get(R),Q=d.state.lights,Ae=d.state.shadowsArray,Ne=Q.state.version,We=q.getParameters(R,Q.state,Ae,K,ue),ze=q.getProgramCacheKey(We),et=ae.programs;ae.environment=R.isMeshStandardMaterial?K.environment:null,ae.fog=K.fog,ae.envMap=(R.isMeshStandardMaterial?Se:he).get(R.envMap||ae.environment),ae.envMapRotation=ae.environment!==null&&R.envMap===null?K.environmentRotation:R.envMapRotation,et===void 0&&(R.addEventListener("dispose",pe),et=new Map,ae.programs=et);let tt=et.get(ze);if(tt!==void 0){if(ae.currentProgram===tt&&ae.lightsStateVersion===Ne)return ul(R,We),tt}else We.uniforms=q.getUniforms(R),R.onBeforeCompile(We,_),tt=q.acquireProgram(We,ze),et.set(ze,tt),ae.uniforms=We.uniforms;let Ke=ae.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ke.clippingPlanes=xe.uniform),ul(R,We),ae.needsLights=Ks(R),ae.lightsStateVersion=Ne,ae.needsLights&&(Ke.ambientLightColor.value=Q.state.ambient,Ke.lightProbe.value=Q.state.probe,Ke.directionalLights.value=Q.state.directional,Ke.directionalLightShadows.value=Q.state.directionalShadow,Ke.spotLights.value=Q.state.spot,Ke.spotLightShadows.value=Q.state.spotShadow,Ke.rectAreaLights.value=Q.state.rectArea,Ke.ltc_1.value=Q.state.rectAreaLTC1,Ke.ltc_2.value=Q.state.rectAreaLTC2,Ke.pointLights.value=Q.state.point,Ke.pointLightShadows.value=Q.state.pointShadow,Ke.hemisphereLights.value=Q.state.hemi,Ke.directionalShadowMap.value=Q.state.directionalShadowMap,Ke.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,Ke.spotShadowMap.value=Q.state.spotShadowMap,Ke.spotLightMatrix.value=Q.state.spotLightMatrix,Ke.spotLightMap.value=Q.state.spotLightMap,Ke.pointShadowMap.value=Q.state.pointShadowMap,Ke.pointShadowMatrix.value=Q.state.pointShadowMatrix),ae.currentProgram=tt,ae.uniformsList=null,tt}function hl(R){if(R.uniformsList===null){let K=R.currentProgram.getUniforms();R.uniformsList=Ao.seqWithValue(K.seq,R.uniforms)}return R.uniformsList}function ul(R,K){let ue=le.get(R);ue.outputColorSpace=K.outputColorSpace,ue.batching=K.batching,ue.batchingColor=K.batchingColor,ue.instancing=K.instancing,ue.instancingColor=K.instancingColor,ue.instancingMorph=K.instancingMorph,ue.skinning=K.skinning,ue.morphTargets=K.morphTargets,ue.morphNormals=K.morphNormals,ue.morphColors=K.morphColors,ue.morphTargetsCount=K.morphTargetsCount,ue.numClippingPlanes=K.numClippingPlanes,ue.numIntersection=K.numClipIntersection,ue.vertexAlphas=K.vertexAlphas,ue.vertexTangents=K.vertexTangents,ue.toneMapping=K.toneMapping}function os(R,K,ue,ae,Q){K.isScene!==!0&&(K=be),j.resetTextureUnits();let Ae=K.fog,Ne=ae.isMeshStandardMaterial?K.environment:null,We=D===null?_.outputColorSpace:D.isXRRenderTarget===!0?D.texture.colorSpace:cr,ze=(ae.isMeshStandardMaterial?Se:he).get(ae.envMap||Ne),et=ae.vertexColors===!0&&!!ue.attributes.color&&ue.attributes.color.itemSize===4,tt=!!ue.attributes.tangent&&(!!ae.normalMap||ae.anisotropy>0),Ke=!!ue.morphAttributes.position,ut=!!ue.morphAttributes.normal,bt=!!ue.morphAttributes.color,kt=_s;ae.toneMapped&&(D===null||D.isXRRenderTarget===!0)&&(kt=_.toneMapping);let Rt=ue.morphAttributes.position||ue.morphAttributes.normal||ue.morphAttributes.color,lt=Rt!==void 0?Rt.length:0,Qe=le.get(ae),Ht=d.state.lights;if(_e===!0&&(ee===!0||R!==S)){let pn=R===S&&ae.id===w;xe.setState(ae,R,pn)}let gt=!1;ae.version===Qe.__version?(Qe.needsLights&&Qe.lightsStateVersion!==Ht.state.version||Qe.outputColorSpace!==We||Q.isBatchedMesh&&Qe.batching===!1||!Q.isBatchedMesh&&Qe.batching===!0||Q.isBatchedMesh&&Qe.batchingColor===!0&&Q.colorTexture===null||Q.isBatchedMesh&&Qe.batchingColor===!1&&Q.colorTexture!==null||Q.isInstancedMesh&&Qe.instancing===!1||!Q.isInstancedMesh&&Qe.instancing===!0||Q.isSkinnedMesh&&Qe.skinning===!1||!Q.isSkinnedMesh&&Qe.skinning===!0||Q.isInstancedMesh&&Qe.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&Qe.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&Qe.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&Qe.instancingMorph===!1&&Q.morphTexture!==null||Qe.envMap!==ze||ae.fog===!0&&Qe.fog!==Ae||Qe.numClippingPlanes!==void 0&&(Qe.numClippingPlanes!==xe.numPlanes||Qe.numIntersection!==xe.numIntersection)||Qe.vertexAlphas!==et||Qe.vertexTangents!==tt||Qe.morphTargets!==Ke||Qe.morphNormals!==ut||Qe.morphColors!==bt||Qe.toneMapping!==kt||Qe.morphTargetsCount!==lt)&&(gt=!0):(gt=!0,Qe.__version=ae.version);let Rn=Qe.currentProgram;gt===!0&&(Rn=Zs(ae,K,Q));let ws=!1,On=!1,Js=!1,Vt=Rn.getUniforms(),Bn=Qe.uniforms;if(Pe.useProgram(Rn.program)&&(ws=!0,On=!0,Js=!0),ae.id!==w&&(w=ae.id,On=!0),ws||S!==R){Pe.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),Vt.setValue(H,"projectionMatrix",R.projectionMatrix),Vt.setValue(H,"viewMatrix",R.matrixWorldInverse);let mn=Vt.map.cameraPosition;mn!==void 0&&mn.setValue(H,me.setFromMatrixPosition(R.matrixWorld)),we.logarithmicDepthBuffer&&Vt.setValue(H,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(ae.isMeshPhongMaterial||ae.isMeshToonMaterial||ae.isMeshLambertMaterial||ae.isMeshBasicMaterial||ae.isMeshStandardMaterial||ae.isShaderMaterial)&&Vt.setValue(H,"isOrthographic",R.isOrthographicCamera===!0),S!==R&&(S=R,On=!0,Js=!0)}if(Q.isSkinnedMesh){Vt.setOptional(H,Q,"bindMatrix"),Vt.setOptional(H,Q,"bindMatrixInverse");let pn=Q.skeleton;pn&&(pn.boneTexture===null&&pn.computeBoneTexture(),Vt.setValue(H,"boneTexture",pn.boneTexture,j))}Q.isBatchedMesh&&(Vt.setOptional(H,Q,"batchingTexture"),Vt.setValue(H,"batchingTexture",Q._matricesTexture,j),Vt.setOptional(H,Q,"batchingIdTexture"),Vt.setValue(H,"batchingIdTexture",Q._indirectTexture,j),Vt.setOptional(H,Q,"batchingColorTexture"),Q._colorsTexture!==null&&Vt.setValue(H,"batchingColorTexture",Q._colorsTexture,j));let $n=ue.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&ge.update(Q,ue,Rn),(On||Qe.receiveShadow!==Q.receiveShadow)&&(Qe.receiveShadow=Q.receiveShadow,Vt.setValue(H,"receiveShadow",Q.receiveShadow)),ae.isMeshGouraudMaterial&&ae.envMap!==null&&(Bn.envMap.value=ze,Bn.flipEnvMap.value=ze.isCubeTexture&&ze.isRenderTargetTexture===!1?-1:1),ae.isMeshStandardMaterial&&ae.envMap===null&&K.environment!==null&&(Bn.envMapIntensity.value=K.environmentIntensity),On&&(Vt.setValue(H,"toneMappingExposure",_.toneMappingExposure),Qe.needsLights&&lu(Bn,Js),Ae&&ae.fog===!0&&oe.refreshFogUniforms(Bn,Ae),oe.refreshMaterialUniforms(Bn,ae,z,F,d.state.transmissionRenderTarget[R.id]),Ao.upload(H,hl(Qe),Bn,j)),ae.isShaderMaterial&&ae.uniformsNeedUpdate===!0&&(Ao.upload(H,hl(Qe),Bn,j),ae.uniformsNeedUpdate=!1),ae.isSpriteMaterial&&Vt.setValue(H,"center",Q.center),Vt.setValue(H,"modelViewMatrix",Q.modelViewMatrix),Vt.setValue(H,"normalMatrix",Q.normalMatrix),Vt.setValue(H,"modelMatrix",Q.matrixWorld),ae.isShaderMaterial||ae.isRawShaderMaterial){let pn=ae.uniformsGroups;for(let mn=0,Ss=pn.length;mn<Ss;mn++){let fi=pn[mn];Ze.update(fi,Rn),Ze.bind(fi,Rn)}}return Rn}function lu(R,K){R.ambientLightColor.needsUpdate=K,R.lightProbe.needsUpdate=K,R.directionalLights.needsUpdate=K,R.directionalLightShadows.needsUpdate=K,R.pointLights.needsUpdate=K,R.pointLightShadows.needsUpdate=K,R.spotLights.needsUpdate=K,R.spotLightShadows.needsUpdate=K,R.rectAreaLights.needsUpdate=K,R.hemisphereLights.needsUpdate=K}function Ks(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return E},this.getActiveMipmapLevel=function(){return I},this.getRenderTarget=function(){return D},this.setRenderTargetTextures=function(R,K,ue){let ae=le.get(R);ae.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,ae.__autoAllocateDepthBuffer===!1&&(ae.__useRenderToTexture=!1),le.get(R.texture).__webglTexture=K,le.get(R.depthTexture).__webglTexture=ae.__autoAllocateDepthBuffer?void 0:ue,ae.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,K){let ue=le.get(R);ue.__webglFramebuffer=K,ue.__useDefaultFramebuffer=K===void 0};let fl=H.createFramebuffer();this.setRenderTarget=function(R,K=0,ue=0){D=R,E=K,I=ue;let ae=!0,Q=null,Ae=!1,Ne=!1;if(R){let ze=le.get(R);if(ze.__useDefaultFramebuffer!==void 0)Pe.bindFramebuffer(H.FRAMEBUFFER,null),ae=!1;else if(ze.__webglFramebuffer===void 0)j.setupRenderTarget(R);else if(ze.__hasExternalTextures)j.rebindTextures(R,le.get(R.texture).__webglTexture,le.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Ke=R.depthTexture;if(ze.__boundDepthTexture!==Ke){if(Ke!==null&&le.has(Ke)&&(R.width!==Ke.image.width||R.height!==Ke.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");j.setupDepthRenderbuffer(R)}}let et=R.texture;(et.isData3DTexture||et.isDataArrayTexture||et.isCompressedArrayTexture)&&(Ne=!0);let tt=le.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(tt[K])?Q=tt[K][ue]:Q=tt[K],Ae=!0):R.samples>0&&j.useMultisampledRTT(R)===!1?Q=le.get(R).__webglMultisampledFramebuffer:Array.isArray(tt)?Q=tt[ue]:Q=tt,A.copy(R.viewport),k.copy(R.scissor),B=R.scissorTest}else A.copy(te).multiplyScalar(z).floor(),k.copy(ce).multiplyScalar(z).floor(),B=fe;if(ue!==0&&(Q=fl),Pe.bindFramebuffer(H.FRAMEBUFFER,Q)&&ae&&Pe.drawBuffers(R,Q),Pe.viewport(A),Pe.scissor(k),Pe.setScissorTest(B),Ae){let ze=le.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+K,ze.__webglTexture,ue)}else if(Ne){let ze=K;for(let et=0;et<R.textures.length;et++){let tt=le.get(R.textures[et]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+et,tt.__webglTexture,ue,ze)}}else if(R!==null&&ue!==0){let ze=le.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,ze.__webglTexture,ue)}w=-1},this.readRenderTargetPixels=function(R,K,ue,ae,Q,Ae,Ne,We=0){if(!(R&&R.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ze=le.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ne!==void 0&&(ze=ze[Ne]),ze){Pe.bindFramebuffer(H.FRAMEBUFFER,ze);try{let et=R.textures[We],tt=et.format,Ke=et.type;if(!we.textureFormatReadable(tt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!we.textureTypeReadable(Ke)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}K>=0&&K<=R.width-ae&&ue>=0&&ue<=R.height-Q&&(R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+We),H.readPixels(K,ue,ae,Q,Ye.convert(tt),Ye.convert(Ke),Ae))}finally{let et=D!==null?le.get(D).__webglFramebuffer:null;Pe.bindFramebuffer(H.FRAMEBUFFER,et)}}},this.readRenderTargetPixelsAsync=async function(R,K,ue,ae,Q,Ae,Ne,We=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ze=le.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ne!==void 0&&(ze=ze[Ne]),ze)if(K>=0&&K<=R.width-ae&&ue>=0&&ue<=R.height-Q){Pe.bindFramebuffer(H.FRAMEBUFFER,ze);let et=R.textures[We],tt=et.format,Ke=et.type;if(!we.textureFormatReadable(tt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!we.textureTypeReadable(Ke))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ut=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,ut),H.bufferData(H.PIXEL_PACK_BUFFER,Ae.byteLength,H.STREAM_READ),R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+We),H.readPixels(K,ue,ae,Q,Ye.convert(tt),Ye.convert(Ke),0);let bt=D!==null?le.get(D).__webglFramebuffer:null;Pe.bindFramebuffer(H.FRAMEBUFFER,bt);let kt=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await Km(H,kt,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,ut),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,Ae),H.deleteBuffer(ut),H.deleteSync(kt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,K=null,ue=0){let ae=Math.pow(2,-ue),Q=Math.floor(R.image.width*ae),Ae=Math.floor(R.image.height*ae),Ne=K!==null?K.x:0,We=K!==null?K.y:0;j.setTexture2D(R,0),H.copyTexSubImage2D(H.TEXTURE_2D,ue,0,0,Ne,We,Q,Ae),Pe.unbindTexture()};let Vi=H.createFramebuffer(),on=H.createFramebuffer();this.copyTextureToTexture=function(R,K,ue=null,ae=null,Q=0,Ae=null){Ae===null&&(Q!==0?(uo("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),Ae=Q,Q=0):Ae=0);let Ne,We,ze,et,tt,Ke,ut,bt,kt,Rt=R.isCompressedTexture?R.mipmaps[Ae]:R.image;if(ue!==null)Ne=ue.max.x-ue.min.x,We=ue.max.y-ue.min.y,ze=ue.isBox3?ue.max.z-ue.min.z:1,et=ue.min.x,tt=ue.min.y,Ke=ue.isBox3?ue.min.z:0;else{let $n=Math.pow(2,-Q);Ne=Math.floor(Rt.width*$n),We=Math.floor(Rt.height*$n),R.isDataArrayTexture?ze=Rt.depth:R.isData3DTexture?ze=Math.floor(Rt.depth*$n):ze=1,et=0,tt=0,Ke=0}ae!==null?(ut=ae.x,bt=ae.y,kt=ae.z):(ut=0,bt=0,kt=0);let lt=Ye.convert(K.format),Qe=Ye.convert(K.type),Ht;K.isData3DTexture?(j.setTexture3D(K,0),Ht=H.TEXTURE_3D):K.isDataArrayTexture||K.isCompressedArrayTexture?(j.setTexture2DArray(K,0),Ht=H.TEXTURE_2D_ARRAY):(j.setTexture2D(K,0),Ht=H.TEXTURE_2D),H.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,K.flipY),H.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,K.premultiplyAlpha),H.pixelStorei(H.UNPACK_ALIGNMENT,K.unpackAlignment);let gt=H.getParameter(H.UNPACK_ROW_LENGTH),Rn=H.getParameter(H.UNPACK_IMAGE_HEIGHT),ws=H.getParameter(H.UNPACK_SKIP_PIXELS),On=H.getParameter(H.UNPACK_SKIP_ROWS),Js=H.getParameter(H.UNPACK_SKIP_IMAGES);H.pixelStorei(H.UNPACK_ROW_LENGTH,Rt.width),H.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Rt.height),H.pixelStorei(H.UNPACK_SKIP_PIXELS,et),H.pixelStorei(H.UNPACK_SKIP_ROWS,tt),H.pixelStorei(H.UNPACK_SKIP_IMAGES,Ke);let Vt=R.isDataArrayTexture||R.isData3DTexture,Bn=K.isDataArrayTexture||K.isData3DTexture;if(R.isDepthTexture){let $n=le.get(R),pn=le.get(K),mn=le.get($n.__renderTarget),Ss=le.get(pn.__renderTarget);Pe.bindFramebuffer(H.READ_FRAMEBUFFER,mn.__webglFramebuffer),Pe.bindFramebuffer(H.DRAW_FRAMEBUFFER,Ss.__webglFramebuffer);for(let fi=0;fi<ze;fi++)Vt&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,le.get(R).__webglTexture,Q,Ke+fi),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,le.get(K).__webglTexture,Ae,kt+fi)),H.blitFramebuffer(et,tt,Ne,We,ut,bt,Ne,We,H.DEPTH_BUFFER_BIT,H.NEAREST);Pe.bindFramebuffer(H.READ_FRAMEBUFFER,null),Pe.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(Q!==0||R.isRenderTargetTexture||le.has(R)){let $n=le.get(R),pn=le.get(K);Pe.bindFramebuffer(H.READ_FRAMEBUFFER,Vi),Pe.bindFramebuffer(H.DRAW_FRAMEBUFFER,on);for(let mn=0;mn<ze;mn++)Vt?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,$n.__webglTexture,Q,Ke+mn):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,$n.__webglTexture,Q),Bn?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,pn.__webglTexture,Ae,kt+mn):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,pn.__webglTexture,Ae),Q!==0?H.blitFramebuffer(et,tt,Ne,We,ut,bt,Ne,We,H.COLOR_BUFFER_BIT,H.NEAREST):Bn?H.copyTexSubImage3D(Ht,Ae,ut,bt,kt+mn,et,tt,Ne,We):H.copyTexSubImage2D(Ht,Ae,ut,bt,et,tt,Ne,We);Pe.bindFramebuffer(H.READ_FRAMEBUFFER,null),Pe.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else Bn?R.isDataTexture||R.isData3DTexture?H.texSubImage3D(Ht,Ae,ut,bt,kt,Ne,We,ze,lt,Qe,Rt.data):K.isCompressedArrayTexture?H.compressedTexSubImage3D(Ht,Ae,ut,bt,kt,Ne,We,ze,lt,Rt.data):H.texSubImage3D(Ht,Ae,ut,bt,kt,Ne,We,ze,lt,Qe,Rt):R.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,Ae,ut,bt,Ne,We,lt,Qe,Rt.data):R.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,Ae,ut,bt,Rt.width,Rt.height,lt,Rt.data):H.texSubImage2D(H.TEXTURE_2D,Ae,ut,bt,Ne,We,lt,Qe,Rt);H.pixelStorei(H.UNPACK_ROW_LENGTH,gt),H.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Rn),H.pixelStorei(H.UNPACK_SKIP_PIXELS,ws),H.pixelStorei(H.UNPACK_SKIP_ROWS,On),H.pixelStorei(H.UNPACK_SKIP_IMAGES,Js),Ae===0&&K.generateMipmaps&&H.generateMipmap(Ht),Pe.unbindTexture()},this.initRenderTarget=function(R){le.get(R).__webglFramebuffer===void 0&&j.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?j.setTextureCube(R,0):R.isData3DTexture?j.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?j.setTexture2DArray(R,0):j.setTexture2D(R,0),Pe.unbindTexture()},this.resetState=function(){E=0,I=0,D=null,Pe.reset(),Le.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};var Ph=({x:i,y:e,z:t})=>new L(i,e,t),BS=1e-9,Rg=i=>i.joint.length?Ph(i.joint[0].path.end).length():i.length,Cg=(i,e,t=0)=>i.joint.length?Math.max(Math.abs(i.length-e),Math.abs(t)):i.length-e,wr,Pg,jf,Qf=class Qf{constructor(e){gl(this,wr);this.free=e.length,this.along=new L(...e.direction);let[t]=e.joint;if(!t)return;Cn(this,wr,Pg).call(this,t);let[n]=e.second;n&&(this.second=new Qf({length:0,direction:e.direction,joint:[n],second:[]}),this.beyond=new L,this.inner=new sn)}get isHinge(){return this.curvature>BS}at(e,t,n=null,s=0){this.second&&s!==0?(Cn(this,wr,jf).call(this,e,t,this.inner),this.second.at(s,this.beyond,n),t.add(this.beyond.sub(this.start).applyQuaternion(this.inner)),n?.premultiply(this.inner)):Cn(this,wr,jf).call(this,e,t,n)}};wr=new WeakSet,Pg=function(e){this.start=Ph(e.path.end),this.along=Ph(e.path.direction),this.inward=Ph(e.path.inward),this.axis=this.along.clone().cross(this.inward),this.curvature=e.path.curvature,this.anchor=new L(...e.anchor)},jf=function(e,t,n){if(n?.identity(),!this.start){t.copy(this.along).multiplyScalar(e);return}let s=e-this.free;if(t.copy(this.start),!this.isHinge){t.addScaledVector(this.along,s);return}let r=this.curvature*s;t.addScaledVector(this.along,Math.sin(r)/this.curvature),t.addScaledVector(this.inward,(1-Math.cos(r))/this.curvature),n?.setFromAxisAngle(this.axis,r)};var Co=Qf;function zS(i){let e=[];for(let n of i)for(let[s,r]of n.impacts.slice(0,12)){let o=s+n.shift-.008;e.push([o,Math.min(r,s+.12)+n.shift+.02])}e.sort((n,s)=>n[0]-s[0]);let t=[];for(let n of e){let s=t[t.length-1];s&&n[0]<s[1]+2*.12?s[1]=Math.max(s[1],n[1]):t.push([...n])}return t.map(([n,s])=>[n,s,Math.min(1,Math.max(.005,(s-n)/3))])}function ed(i,e){let t=1;for(let[n,s,r]of i){let o=Math.max(n-e,e-s,0);o<.12&&(t=Math.min(t,r**((1+Math.cos(Math.PI*o/.12))/2)))}return t}function Lg(i){let e=Math.min(...i.map(l=>l.begin+l.shift)),t=Math.max(...i.map(l=>l.end+l.shift)),n=zS(i),s=new Set([e,t]);for(let l=1;l<200;l++)s.add(e+(t-e)*l/200);for(let[l,c]of n)for(let u=0;u<=60;u++)s.add(l-.12+(c-l+2*.12)*u/60),s.add(l+(c-l)*u/60),s.add(l-.12*u/60),s.add(c+.12*u/60);let r=[...s].filter(l=>l>=e&&l<=t).sort((l,c)=>l-c),o=[0];for(let l=1;l<r.length;l++){let c=Math.sqrt(ed(n,r[l-1])*ed(n,r[l]));o.push(o[l-1]+(r[l]-r[l-1])/c)}let a=o[o.length-1]||1;return{begin:e,end:t,stretches:n,total:a,paceAt:l=>ed(n,l),watchedAt:l=>Ig(r,o,l),timeAt:l=>Ig(o,r,l)}}function Ig(i,e,t){let n=0,s=i.length-1;if(!(t>i[0]))return e[0];if(t>=i[s])return e[s];for(;s-n>1;){let r=n+s>>1;i[r]<=t?n=r:s=r}return e[n]+(e[s]-e[n])*(t-i[n])/(i[s]-i[n])}var kS="uplot",HS="u-hz",VS="u-vt",GS="u-title",WS="u-wrap",XS="u-under",qS="u-over",YS="u-axis",Tr="u-off",$S="u-select",ZS="u-cursor-x",KS="u-cursor-y",JS="u-cursor-pt",jS="u-legend",QS="u-live",e1="u-inline",t1="u-series",n1="u-marker",Dg="u-label",i1="u-value",Ka="width",Ja="height";var Ug="bottom",Po="left",td="right",xd="#000",Ng=xd+"0",nd="mousemove",Fg="mousedown",id="mouseup",Og="mouseenter",Bg="mouseleave",zg="dblclick",s1="resize",r1="scroll",kg="change",Nh="dppxchange",_d="--",Oo=typeof window<"u",ld=Oo?document:null,Lo=Oo?window:null,o1=Oo?navigator:null,Tt,Ih;function cd(){let i=devicePixelRatio;Tt!=i&&(Tt=i,Ih&&ud(kg,Ih,cd),Ih=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),Ar(kg,Ih,cd),Lo.dispatchEvent(new CustomEvent(Nh)))}function ci(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function hd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Oi(i,e,t,n){let s=ld.createElement(i);return e!=null&&ci(s,e),t?.insertBefore(s,n),s}function _i(i,e){return Oi("div",i,e)}var Hg=new WeakMap;function ts(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Hg.get(i);r!=o&&(i.style.transform=r,Hg.set(i,r),e<0||t<0||e>n||t>s?ci(i,Tr):hd(i,Tr))}var Vg=new WeakMap;function Gg(i,e,t){let n=e+t,s=Vg.get(i);n!=s&&(Vg.set(i,n),i.style.background=e,i.style.borderColor=t)}var Wg=new WeakMap;function Xg(i,e,t,n){let s=e+""+t,r=Wg.get(i);s!=r&&(Wg.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var yd={passive:!0},a1={...yd,capture:!0};function Ar(i,e,t,n){e.addEventListener(i,t,n?a1:yd)}function ud(i,e,t,n){e.removeEventListener(i,t,yd)}Oo&&cd();function Bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:hi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function _0(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var y0=i=>i!=null,b0=i=>i!=null&&i>0,Bh=_0(y0),l1=_0(b0);function c1(i,e,t,n=0,s=!1){let r=s?l1:Bh,o=s?b0:y0;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function zh(i,e,t,n){let s=$g(i),r=$g(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?bs:M0,a=s==1?hi:yi,l=r==1?yi:hi,c=a(o(fn(i))),u=l(o(fn(e))),h=Do(t,c),f=Do(t,u);return t==10&&(c<0&&(h=zt(h,-c)),u<0&&(f=zt(f,-u))),n||t==2?(i=h*s,e=f*r):(i=T0(i,h),e=kh(e,f)),[i,e]}function bd(i,e,t,n){let s=zh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Md=.1,qg={mode:3,pad:Md},Qa={pad:0,soft:null,mode:0},h1={min:Qa,max:Qa};function Fh(i,e,t,n){return Hh(t)?Yg(i,e,t):(Qa.pad=t,Qa.soft=n?0:null,Qa.mode=n?3:0,Yg(i,e,h1))}function wt(i,e){return i??e}function u1(i,e,t){for(e=wt(e,0),t=wt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Yg(i,e,t){let n=t.min,s=t.max,r=wt(n.pad,0),o=wt(s.pad,0),a=wt(n.hard,-Bt),l=wt(s.hard,Bt),c=wt(n.soft,Bt),u=wt(s.soft,-Bt),h=wt(n.mode,0),f=wt(s.mode,0),m=e-i,g=bs(m),v=qn(fn(i),fn(e)),p=bs(v),d=fn(p-g);(m<1e-24||d>10)&&(m=0,(i==0||e==0)&&(m=1e-24,h==2&&c!=Bt&&(r=0),f==2&&u!=-Bt&&(o=0)));let b=m||v||1e3,M=bs(b),_=Do(10,hi(M)),P=b*(m==0?i==0?.1:1:r),E=zt(T0(i-P,_/10),24),I=i>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Bt,D=qn(a,E<I&&i>=I?I:zi(I,E)),w=b*(m==0?e==0?.1:1:o),S=zt(kh(e+w,_/10),24),A=e<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-Bt,k=zi(l,S>A&&e<=A?A:qn(A,S));return D==k&&D==0&&(k=100),[D,k]}var f1=new Intl.NumberFormat(Oo?o1.language:"en-US"),wd=i=>f1.format(i),ui=Math,Uh=ui.PI,fn=ui.abs,hi=ui.floor,un=ui.round,yi=ui.ceil,zi=ui.min,qn=ui.max,Do=ui.pow,$g=ui.sign,bs=ui.log10,M0=ui.log2,d1=(i,e=1)=>ui.sinh(i)*e,sd=(i,e=1)=>ui.asinh(i/e),Bt=1/0;function Zg(i){return(bs((i^i>>31)-(i>>31))|0)+1}function fd(i,e,t){return zi(qn(i,e),t)}function w0(i){return typeof i=="function"}function vt(i){return w0(i)?i:()=>i}var p1=()=>{},S0=i=>i,E0=(i,e)=>e,m1=i=>null,Kg=i=>!0,Jg=(i,e)=>i==e,g1=/\.\d*?(?=9{6,}|0{6,})/gm,Rr=i=>{if(R0(i)||Ys.has(i))return i;let e=`${i}`,t=e.match(g1);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Rr(s)}e${r}`}return zt(i,n)};function Sr(i,e){return Rr(zt(Rr(i/e))*e)}function kh(i,e){return Rr(yi(Rr(i/e))*e)}function T0(i,e){return Rr(hi(Rr(i/e))*e)}function zt(i,e=0){if(R0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return un(n)/t}var Ys=new Map;function A0(i){return((""+i).split(".")[1]||"").length}function tl(i,e,t,n){let s=[],r=n.map(A0);for(let o=e;o<t;o++){let a=fn(o),l=zt(Do(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:zt(u,h);s.push(f),Ys.set(f,h)}}return s}var el={},Sd=[],Uo=[null,null],qs=Array.isArray,R0=Number.isInteger,v1=i=>i===void 0;function jg(i){return typeof i=="string"}function Hh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function x1(i){return i!=null&&typeof i=="object"}var _1=Object.getPrototypeOf(Uint8Array),C0="__proto__";function No(i,e=Hh){let t;if(qs(i)){let n=i.find(s=>s!=null);if(qs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=No(i[s],e)}else t=i.slice()}else if(i instanceof _1)t=i.slice();else if(e(i)){t={};for(let n in i)n!=C0&&(t[n]=No(i[n],e))}else t=i;return t}function rn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=C0&&(Hh(i[s])?rn(i[s],No(n[s])):i[s]=No(n[s]))}return i}var y1=0,b1=1,M1=2;function w1(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function S1(i,e){if(A1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return R1(o[0])||(o=T1(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:b1,m=[];for(let g=0;g<u.length;g++){let v=u[g],p=r.get(l[g]);v===null?f!=y1&&(h[p]=v,f==M1&&m.push(p)):h[p]=v}w1(h,m,s),n.push(h)}}return n}var E1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function T1(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function A1(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function R1(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=qn(1,hi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var P0=["January","February","March","April","May","June","July","August","September","October","November","December"],I0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function L0(i){return i.slice(0,3)}var C1=I0.map(L0),P1=P0.map(L0),I1={MMMM:P0,MMM:P1,WWWW:I0,WWW:C1};function Za(i){return(i<10?"0":"")+i}function L1(i){return(i<10?"00":i<100?"0":"")+i}var D1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Za(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Za(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Za(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Za(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Za(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>L1(i.getMilliseconds())};function Ed(i,e){e=e||I1;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?D1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var U1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function N1(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==U1?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var D0=i=>i%1==0,Oh=[1,2,2.5,5],F1=tl(10,-32,0,Oh),U0=tl(10,0,32,Oh),O1=U0.filter(D0),Er=F1.concat(U0),Td=`
`,N0="{YYYY}",Qg=Td+N0,F0="{M}/{D}",ja=Td+F0,Lh=ja+"/{YY}",O0="{aa}",B1="{h}:{mm}",Io=B1+O0,e0=Td+Io,t0=":{ss}",At=null;function B0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?tl(10,0,3,Oh).filter(D0):tl(10,-3,0,Oh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,N0,At,At,At,At,At,At,1],[s*28,"{MMM}",Qg,At,At,At,At,At,1],[s,F0,Qg,At,At,At,At,At,1],[n,"{h}"+O0,Lh,At,ja,At,At,At,1],[t,Io,Lh,At,ja,At,At,At,1],[e,t0,Lh+" "+Io,At,ja+" "+Io,At,e0,At,1],[i,t0+".{fff}",Lh+" "+Io,At,ja+" "+Io,At,e0,At,1]];function u(h){return(f,m,g,v,p,d)=>{let b=[],M=p>=o,_=p>=r&&p<o,P=h(g),E=zt(P*i,3),I=rd(P.getFullYear(),M?0:P.getMonth(),_||M?1:P.getDate()),D=zt(I*i,3);if(_||M){let w=_?p/r:0,S=M?p/o:0,A=E==D?E:zt(rd(I.getFullYear()+S,I.getMonth()+w,1)*i,3),k=new Date(un(A/i)),B=k.getFullYear(),V=k.getMonth();for(let W=0;A<=v;W++){let X=rd(B+S*W,V+w*W,1),F=X-h(zt(X*i,3));A=zt((+X+F)*i,3),A<=v&&b.push(A)}}else{let w=p>=s?s:p,S=hi(g)-hi(E),A=D+S+kh(E-D,w);b.push(A);let k=h(A),B=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,V=p/n,W=f.axes[m]._space,X=d/W;for(;A=zt(A+p,i==1?0:3),!(A>v);)if(V>1){let F=hi(zt(B+V,6))%24,ne=h(A).getHours()-F;ne>1&&(ne=-1),A-=ne*n,B=(B+V)%24;let te=b[b.length-1];zt((A-te)/p,3)*X>=.7&&b.push(A)}else b.push(A)}return b}}return[l,c,u]}var[z1,k1,H1]=B0(1),[V1,G1,W1]=B0(.001);tl(2,-53,53,[1]);function n0(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function i0(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,f,m;return n.map(g=>{let v=i(g),p=v.getFullYear(),d=v.getMonth(),b=v.getDate(),M=v.getHours(),_=v.getMinutes(),P=v.getSeconds(),E=p!=l&&a[2]||d!=c&&a[3]||b!=u&&a[4]||M!=h&&a[5]||_!=f&&a[6]||P!=m&&a[7]||a[1];return l=p,c=d,u=b,h=M,f=_,m=P,E(v)})}}function X1(i,e){let t=Ed(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function rd(i,e,t){return new Date(i,e,t)}function s0(i,e){return e(i)}var q1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function r0(i,e){return(t,n,s,r)=>r==null?_d:e(i(n))}function Y1(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function $1(i,e){return i.series[e].fill(i,e)}var Z1={show:!0,live:!0,isolate:!1,mount:p1,markers:{show:!0,width:2,stroke:Y1,fill:$1,dash:"solid"},idx:null,idxs:null,values:[]};function K1(i,e){let t=i.cursor.points,n=_i(),s=t.size(i,e);Yt(n,Ka,s),Yt(n,Ja,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Yt(n,"borderWidth",o),n}function J1(i,e){let t=i.series[e].points;return t._fill||t._stroke}function j1(i,e){let t=i.series[e].points;return t._stroke||t._fill}function Q1(i,e){return i.series[e].points.size}var od=[0,0];function eE(i,e,t){return od[0]=e,od[1]=t,od}function Dh(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function ad(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var tE={show:!0,x:!0,y:!0,lock:!1,move:eE,points:{one:!1,show:K1,size:Q1,width:0,stroke:j1,fill:J1},bind:{mousedown:Dh,mouseup:Dh,click:Dh,dblclick:Dh,mousemove:ad,mouseleave:ad,mouseenter:ad},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},z0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ad=rn({},z0,{filter:E0}),k0=rn({},Ad,{size:10}),H0=rn({},z0,{show:!1}),Rd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',V0="bold "+Rd,G0=1.5,o0={show:!0,scale:"x",stroke:xd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:V0,side:2,grid:Ad,ticks:k0,border:H0,font:Rd,lineGap:G0,rotate:0},nE="Value",iE="Time",a0={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function sE(i,e,t,n,s){return e.map(r=>r==null?"":wd(r))}function rE(i,e,t,n,s,r,o){let a=[],l=Ys.get(s)||0;t=o?t:zt(kh(t,s),l);for(let c=t;c<=n;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function dd(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?bs:M0,u=hi(c(t));s=Do(l,u),l==10&&(s=Er[Bi(s,Er)]);let h=t,f=s*l;l==10&&(f=Er[Bi(f,Er)]);do a.push(h),h=h+s,l==10&&!Ys.has(h)&&(h=zt(h,Ys.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Er[Bi(f,Er)]));while(h<=n);return a}function oE(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?dd(i,e,qn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?dd(i,e,qn(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var W0=/./,aE=/[12357]/,lE=/[125]/,l0=/1/,pd=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function cE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?W0:l(7,o)-u>=c?aE:l(5,o)-u>=c?lE:l0;if(h==l0){let f=fn(l(1,o)-u);if(f<c)return pd(e.slice().reverse(),a.distr,h,yi(c/f)).reverse()}return pd(e,a.distr,h,1)}function hE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=fn(l(1,o)-l(2,o));return c<a?pd(e.slice().reverse(),3,W0,yi(a/c)).reverse():e}function uE(i,e,t,n){return n==null?_d:e==null?"":wd(e)}var c0={show:!0,scale:"y",stroke:xd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:V0,side:3,grid:Ad,ticks:k0,border:H0,font:Rd,lineGap:G0,rotate:0};function fE(i,e){let t=3+(i||1)*2;return zt(t*e,3)}function dE(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=fn(o-r),l=i.series[e],c=a/(l.points.space*Tt);return n[1]-n[0]<=c}var h0={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},X0=(i,e,t,n,s)=>s,u0={show:!0,auto:!0,sorted:0,gaps:X0,alpha:1,facets:[rn({},h0,{scale:"x"}),rn({},h0,{scale:"y"})]},f0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:X0,alpha:1,points:{show:dE,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function pE(i,e,t,n,s){return t/10}var q0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},mE=rn({},q0,{time:!1,ori:1}),d0={};function Y0(i,e){let t=d0[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(d0[i]=t)),t}var Fo=1,md=2;function Cr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,m=a.top,g=a.width,v=a.height,p=i.valToPosH,d=i.valToPosV;return u.ori==0?t(s,l,c,u,h,p,d,f,m,g,v,Gh,Bo,Xh,Z0,J0):t(s,l,c,u,h,d,p,m,f,v,g,Wh,zo,Id,K0,j0)}function Cd(i,e){let t=0,n=0,s=wt(i.bands,Sd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function gE(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(i,e,t,n,s,r){return Cr(i,e,(o,a,l,c,u,h,f,m,g,v,p)=>{let d=o.pxRound,b=c.dir*(c.ori==0?1:-1),M=c.ori==0?Bo:zo,_,P;b==1?(_=t,P=n):(_=n,P=t);let E=d(h(a[_],c,v,m)),I=d(f(l[_],u,p,g)),D=d(h(a[P],c,v,m)),w=d(f(r==1?u.max:u.min,u,p,g)),S=new Path2D(s);return M(S,D,w),M(S,E,w),M(S,E,I),S})}function Vh(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Xh:Id,l=t;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let m=f[0]-l;m>0&&a(o,l,n,m,n+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function vE(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Pd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let m=r(i[h]),g=f==h?m:r(i[f]),v=h-s;m=o<=0&&v>=0&&v<l?r(i[v]):m;let d=f+s;g=o>=0&&d>=0&&d<l?r(i[d]):g,g>=m&&a.push([m,g])}return a}function p0(i){return i==0?S0:i==1?un:e=>Sr(e,i)}function $0(i){let e=i==0?Gh:Wh,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=zi(c,a/2,l/2),u=zi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Gh=(i,e,t)=>{i.moveTo(e,t)},Wh=(i,e,t)=>{i.moveTo(t,e)},Bo=(i,e,t)=>{i.lineTo(e,t)},zo=(i,e,t)=>{i.lineTo(t,e)},Xh=$0(0),Id=$0(1),Z0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},K0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},J0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},j0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Q0(i){return(e,t,n,s,r)=>Cr(e,t,(o,a,l,c,u,h,f,m,g,v,p)=>{let{pxRound:d,points:b}=o,M,_;c.ori==0?(M=Gh,_=Z0):(M=Wh,_=K0);let P=zt(b.width*Tt,3),E=(b.size-b.width)/2*Tt,I=zt(E*2,3),D=new Path2D,w=new Path2D,{left:S,top:A,width:k,height:B}=e.bbox;Xh(w,S-I,A-I,k+I*2,B+I*2);let V=W=>{if(l[W]!=null){let X=d(h(a[W],c,v,m)),F=d(f(l[W],u,p,g));M(D,X+E,F),_(D,X,F,E,0,Uh*2)}};if(r)r.forEach(V);else for(let W=n;W<=s;W++)V(W);return{stroke:P>0?D:null,fill:D,clip:w,flags:Fo|md}})}function ev(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var xE=ev(Bo),_E=ev(zo);function tv(i){let e=wt(i?.alignGaps,0);return(t,n,s,r)=>Cr(t,n,(o,a,l,c,u,h,f,m,g,v,p)=>{[s,r]=Bh(l,s,r);let d=o.pxRound,b=B=>d(h(B,c,v,m)),M=B=>d(f(B,u,p,g)),_,P;c.ori==0?(_=Bo,P=xE):(_=zo,P=_E);let E=c.dir*(c.ori==0?1:-1),I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},D=I.stroke,w=!1;if(r-s>=v*4){let B=fe=>t.posToVal(fe,c.key,!0),V=null,W=null,X,F,z,J=b(a[E==1?s:r]),ne=b(a[s]),te=b(a[r]),ce=B(E==1?ne+1:te-1);for(let fe=E==1?s:r;fe>=s&&fe<=r;fe+=E){let ye=a[fe],ee=(E==1?ye<ce:ye>ce)?J:b(ye),$=l[fe];ee==J?$!=null?(F=$,V==null?(_(D,ee,M(F)),X=V=W=F):F<V?V=F:F>W&&(W=F)):$===null&&(w=!0):(V!=null&&P(D,J,M(V),M(W),M(X),M(F)),$!=null?(F=$,_(D,ee,M(F)),V=W=X=F):(V=W=null,$===null&&(w=!0)),J=ee,ce=B(J+E))}V!=null&&V!=W&&z!=J&&P(D,J,M(V),M(W),M(X),M(F))}else for(let B=E==1?s:r;B>=s&&B<=r;B+=E){let V=l[B];V===null?w=!0:V!=null&&_(D,b(a[B]),M(V))}let[A,k]=Cd(t,n);if(o.fill!=null||A!=0){let B=I.fill=new Path2D(D),V=o.fillTo(t,n,o.min,o.max,A),W=M(V),X=b(a[s]),F=b(a[r]);E==-1&&([F,X]=[X,F]),_(B,F,W),_(B,X,W)}if(!o.spanGaps){let B=[];w&&B.push(...Pd(a,l,s,r,E,b,e)),I.gaps=B=o.gaps(t,n,s,r,B),I.clip=Vh(B,c.ori,m,g,v,p)}return k!=0&&(I.band=k==2?[Ms(t,n,s,r,D,-1),Ms(t,n,s,r,D,1)]:Ms(t,n,s,r,D,k)),I})}function yE(i){let e=wt(i.align,1),t=wt(i.ascDesc,!1),n=wt(i.alignGaps,0),s=wt(i.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,u,h,f,m,g,v,p,d,b,M)=>{[a,l]=Bh(h,a,l);let _=c.pxRound,{left:P,width:E}=r.bbox,I=ne=>_(g(ne,f,b,p)),D=ne=>_(v(ne,m,M,d)),w=f.ori==0?Bo:zo,S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},A=S.stroke,k=f.dir*(f.ori==0?1:-1),B=D(h[k==1?a:l]),V=I(u[k==1?a:l]),W=V,X=V;s&&e==-1&&(X=P,w(A,X,B)),w(A,V,B);for(let ne=k==1?a:l;ne>=a&&ne<=l;ne+=k){let te=h[ne];if(te==null)continue;let ce=I(u[ne]),fe=D(te);e==1?w(A,ce,B):w(A,W,fe),w(A,ce,fe),B=fe,W=ce}let F=W;s&&e==1&&(F=P+E,w(A,F,B));let[z,J]=Cd(r,o);if(c.fill!=null||z!=0){let ne=S.fill=new Path2D(A),te=c.fillTo(r,o,c.min,c.max,z),ce=D(te);w(ne,F,ce),w(ne,X,ce)}if(!c.spanGaps){let ne=[];ne.push(...Pd(u,h,a,l,k,I,n));let te=c.width*Tt/2,ce=t||e==1?te:-te,fe=t||e==-1?-te:te;ne.forEach(ye=>{ye[0]+=ce,ye[1]+=fe}),S.gaps=ne=c.gaps(r,o,a,l,ne),S.clip=Vh(ne,f.ori,p,d,b,M)}return J!=0&&(S.band=J==2?[Ms(r,o,a,l,A,-1),Ms(r,o,a,l,A,1)]:Ms(r,o,a,l,A,J)),S})}function m0(i,e,t,n,s,r,o=Bt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=fn(i[l]-i[a]);u<c&&(c=u,o=fn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function bE(i){i=i||el;let e=wt(i.size,[.6,Bt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=wt(e[1],Bt),l=wt(e[2],1),c=wt(i.disp,el),u=wt(i.each,m=>{}),{fill:h,stroke:f}=c;return(m,g,v,p)=>Cr(m,g,(d,b,M,_,P,E,I,D,w,S,A)=>{let k=d.pxRound,B=t,V=n*Tt,W=a*Tt,X=l*Tt,F,z;_.ori==0?[F,z]=r(m,g):[z,F]=r(m,g);let J=_.dir*(_.ori==0?1:-1),ne=_.ori==0?Xh:Id,te=_.ori==0?u:(N,q,oe,se,Ue,xe,Fe)=>{u(N,q,oe,Ue,se,Fe,xe)},ce=wt(m.bands,Sd).find(N=>N.series[0]==g),fe=ce!=null?ce.dir:0,ye=d.fillTo(m,g,d.min,d.max,fe),_e=k(I(ye,P,A,w)),ee,$,me,ve=S,be=k(d.width*Tt),Ge=!1,dt=null,H=null,ht=null,re=null;h!=null&&(be==0||f!=null)&&(Ge=!0,dt=h.values(m,g,v,p),H=new Map,new Set(dt).forEach(N=>{N!=null&&H.set(N,new Path2D)}),be>0&&(ht=f.values(m,g,v,p),re=new Map,new Set(ht).forEach(N=>{N!=null&&re.set(N,new Path2D)})));let{x0:we,size:Pe}=c;if(we!=null&&Pe!=null){B=1,b=we.values(m,g,v,p),we.unit==2&&(b=b.map(oe=>m.posToVal(D+oe*S,_.key,!0)));let N=Pe.values(m,g,v,p);Pe.unit==2?$=N[0]*S:$=E(N[0],_,S,D)-E(0,_,S,D),ve=m0(b,M,E,_,S,D,ve),me=ve-$+V}else ve=m0(b,M,E,_,S,D,ve),me=ve*o+V,$=ve-me;me<1&&(me=0),be>=$/2&&(be=0),me<5&&(k=S0);let ot=me>0,le=ve-me-(ot?be:0);$=k(fd(le,X,W)),ee=(B==0?$/2:B==J?0:$)-B*J*((B==0?V/2:0)+(ot?be/2:0));let j={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},he=Ge?null:new Path2D,Se=null;if(ce!=null)Se=m.data[ce.series[1]];else{let{y0:N,y1:q}=c;N!=null&&q!=null&&(M=q.values(m,g,v,p),Se=N.values(m,g,v,p))}let C=F*$,y=z*$;for(let N=J==1?v:p;N>=v&&N<=p;N+=J){let q=M[N];if(q==null)continue;if(Se!=null){let Ce=Se[N]??0;if(q-Ce==0)continue;_e=I(Ce,P,A,w)}let oe=_.distr!=2||c!=null?b[N]:N,se=E(oe,_,S,D),Ue=I(wt(q,ye),P,A,w),xe=k(se-ee),Fe=k(qn(Ue,_e)),Be=k(zi(Ue,_e)),ge=Fe-Be;if(q!=null){let Ce=q<0?y:C,qe=q<0?C:y;Ge?(be>0&&ht[N]!=null&&ne(re.get(ht[N]),xe,Be+hi(be/2),$,qn(0,ge-be),Ce,qe),dt[N]!=null&&ne(H.get(dt[N]),xe,Be+hi(be/2),$,qn(0,ge-be),Ce,qe)):ne(he,xe,Be+hi(be/2),$,qn(0,ge-be),Ce,qe),te(m,g,N,xe-be/2,Be,$+be,ge)}}return be>0?j.stroke=Ge?re:he:Ge||(j._fill=d.width==0?d._fill:d._stroke??d._fill,j.width=0),j.fill=Ge?H:he,j})}function ME(i,e){let t=wt(e?.alignGaps,0);return(n,s,r,o)=>Cr(n,s,(a,l,c,u,h,f,m,g,v,p,d)=>{[r,o]=Bh(c,r,o);let b=a.pxRound,M=F=>b(f(F,u,p,g)),_=F=>b(m(F,h,d,v)),P,E,I;u.ori==0?(P=Gh,I=Bo,E=J0):(P=Wh,I=zo,E=j0);let D=u.dir*(u.ori==0?1:-1),w=M(l[D==1?r:o]),S=w,A=[],k=[];for(let F=D==1?r:o;F>=r&&F<=o;F+=D)if(c[F]!=null){let J=l[F],ne=M(J);A.push(S=ne),k.push(_(c[F]))}let B={stroke:i(A,k,P,I,E,b),fill:null,clip:null,band:null,gaps:null,flags:Fo},V=B.stroke,[W,X]=Cd(n,s);if(a.fill!=null||W!=0){let F=B.fill=new Path2D(V),z=a.fillTo(n,s,a.min,a.max,W),J=_(z);I(F,S,J),I(F,w,J)}if(!a.spanGaps){let F=[];F.push(...Pd(l,c,r,o,D,M,t)),B.gaps=F=a.gaps(n,s,r,o,F),B.clip=Vh(F,u.ori,g,v,p,d)}return X!=0&&(B.band=X==2?[Ms(n,s,r,o,V,-1),Ms(n,s,r,o,V,1)]:Ms(n,s,r,o,V,X)),B})}function wE(i){return ME(SE,i)}function SE(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,e[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,i[f+1],e[f+1])}return a}var gd=new Set;function g0(){for(let i of gd)i.syncRect(!0)}Oo&&(Ar(s1,Lo,g0),Ar(r1,Lo,g0,!0),Ar(Nh,Lo,()=>{Kt.pxRatio=Tt}));var EE=tv(),TE=Q0();function v0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>vd(r,o,e,t))}function AE(i,e){return i.map((t,n)=>n==0?{}:rn({},e,t))}function vd(i,e,t,n){return rn({},e==0?t:n,i)}function nv(i,e,t){return e==null?Uo:[e,t]}var RE=nv;function CE(i,e,t){return e==null?Uo:Fh(e,t,Md,!0)}function iv(i,e,t,n){return e==null?Uo:zh(e,t,i.scales[n].log,!1)}var PE=iv;function sv(i,e,t,n){return e==null?Uo:bd(e,t,i.scales[n].log,!1)}var IE=sv;function LE(i,e,t,n,s){let r=qn(Zg(i),Zg(e)),o=e-i,a=Bi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ys.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function x0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=un((t=+s)*Tt))+"px"),[i,e,t]}function DE(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=zt(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Kt(i,e,t){let n={mode:wt(i.mode,1)},s=n.mode;function r(x,T,U,O){let Z=T.valToPct(x);return O+U*(T.dir==-1?1-Z:Z)}function o(x,T,U,O){let Z=T.valToPct(x);return O+U*(T.dir==-1?Z:1-Z)}function a(x,T,U,O){return T.ori==0?r(x,T,U,O):o(x,T,U,O)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=_i(kS);if(i.id!=null&&(c.id=i.id),ci(c,i.class),i.title){let x=_i(GS,c);x.textContent=i.title}let u=Oi("canvas"),h=n.ctx=u.getContext("2d"),f=_i(WS,c);Ar("click",f,x=>{x.target===g&&(Gt!=Nr||$t!=Fr)&&Mn.click(n,x)},!0);let m=n.under=_i(XS,f);f.appendChild(u);let g=n.over=_i(qS,f);i=No(i);let v=+wt(i.pxAlign,1),p=p0(v);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let d=i.ms||.001,b=n.series=s==1?v0(i.series||[],a0,f0,!1):AE(i.series||[null],u0),M=n.axes=v0(i.axes||[],o0,c0,!0),_=n.scales={},P=n.bands=i.bands||[];P.forEach(x=>{x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1)});let E=s==2?b[1].facets[0].scale:b[0].scale,I={axes:fx,series:Js},D=(i.drawOrder||["axes","series"]).map(x=>I[x]);function w(x){let T=x.distr==3?U=>bs(U>0?U:x.clamp(n,U,x.min,x.max,x.key)):x.distr==4?U=>sd(U,x.asinh):x.distr==100?U=>x.fwd(U):U=>U;return U=>{let O=T(U),{_min:Z,_max:ie}=x,de=ie-Z;return(O-Z)/de}}function S(x){let T=_[x];if(T==null){let U=(i.scales||el)[x]||el;if(U.from!=null){S(U.from);let O=rn({},_[U.from],U,{key:x});O.valToPct=w(O),_[x]=O}else{T=_[x]=rn({},x==E?q0:mE,U),T.key=x;let O=T.time,Z=T.range,ie=qs(Z);if((x!=E||s==2&&!O)&&(ie&&(Z[0]==null||Z[1]==null)&&(Z={min:Z[0]==null?qg:{mode:1,hard:Z[0],soft:Z[0]},max:Z[1]==null?qg:{mode:1,hard:Z[1],soft:Z[1]}},ie=!1),!ie&&Hh(Z))){let de=Z;Z=(Me,Ie,ke)=>Ie==null?Uo:Fh(Ie,ke,de)}T.range=vt(Z||(O?RE:x==E?T.distr==3?PE:T.distr==4?IE:nv:T.distr==3?iv:T.distr==4?sv:CE)),T.auto=vt(ie?!1:T.auto),T.clamp=vt(T.clamp||pE),T._min=T._max=null,T.valToPct=w(T)}}}S("x"),S("y"),s==1&&b.forEach(x=>{S(x.scale)}),M.forEach(x=>{S(x.scale)});for(let x in i.scales)S(x);let A=_[E],k=A.distr,B,V;A.ori==0?(ci(c,HS),B=r,V=o):(ci(c,VS),B=o,V=r);let W={};for(let x in _){let T=_[x];(T.min!=null||T.max!=null)&&(W[x]={min:T.min,max:T.max},T.min=T.max=null)}let X=i.tzDate||(x=>new Date(un(x/d))),F=i.fmtDate||Ed,z=d==1?H1(X):W1(X),J=i0(X,n0(d==1?k1:G1,F)),ne=r0(X,s0(q1,F)),te=[],ce=n.legend=rn({},Z1,i.legend),fe=n.cursor=rn({},tE,{drag:{y:s==2}},i.cursor),ye=ce.show,_e=fe.show,ee=ce.markers;ce.idxs=te,ee.width=vt(ee.width),ee.dash=vt(ee.dash),ee.stroke=vt(ee.stroke),ee.fill=vt(ee.fill);let $,me,ve,be=[],Ge=[],dt,H=!1,ht={};if(ce.live){let x=b[1]?b[1].values:null;H=x!=null,dt=H?x(n,1,0):{_:0};for(let T in dt)ht[T]=_d}if(ye)if($=Oi("table",jS,c),ve=Oi("tbody",null,$),ce.mount(n,$),H){me=Oi("thead",null,$,ve);let x=Oi("tr",null,me);Oi("th",null,x);for(var re in dt)Oi("th",Dg,x).textContent=re}else ci($,e1),ce.live&&ci($,QS);let we={show:!0},Pe={show:!1};function ot(x,T){if(T==0&&(H||!ce.live||s==2))return Uo;let U=[],O=Oi("tr",t1,ve,ve.childNodes[T]);ci(O,x.class),x.show||ci(O,Tr);let Z=Oi("th",null,O);if(ee.show){let Me=_i(n1,Z);if(T>0){let Ie=ee.width(n,T);Ie&&(Me.style.border=Ie+"px "+ee.dash(n,T)+" "+ee.stroke(n,T)),Me.style.background=ee.fill(n,T)}}let ie=_i(Dg,Z);x.label instanceof HTMLElement?ie.appendChild(x.label):ie.textContent=x.label,T>0&&(ee.show||(ie.style.color=x.width>0?ee.stroke(n,T):ee.fill(n,T)),j("click",Z,Me=>{if(fe._lock)return;bn(Me);let Ie=b.indexOf(x);if((Me.ctrlKey||Me.metaKey)!=ce.isolate){let ke=b.some((He,Xe)=>Xe>0&&Xe!=Ie&&He.show);b.forEach((He,Xe)=>{Xe>0&&Gi(Xe,ke?Xe==Ie?we:Pe:we,!0,tn.setSeries)})}else Gi(Ie,{show:!x.show},!0,tn.setSeries)},!1),Yn&&j(Og,Z,Me=>{fe._lock||(bn(Me),Gi(b.indexOf(x),Br,!0,tn.setSeries))},!1));for(var de in dt){let Me=Oi("td",i1,O);Me.textContent="--",U.push(Me)}return[O,U]}let le=new Map;function j(x,T,U,O=!0){let Z=le.get(T)||{},ie=fe.bind[x](n,T,U,O);ie&&(Ar(x,T,Z[x]=ie),le.set(T,Z))}function he(x,T,U){let O=le.get(T)||{};for(let Z in O)(x==null||Z==x)&&(ud(Z,T,O[Z]),delete O[Z]);x==null&&le.delete(T)}let Se=0,C=0,y=0,N=0,q=0,oe=0,se=q,Ue=oe,xe=y,Fe=N,Be=0,ge=0,Ce=0,qe=0;n.bbox={};let Ye=!1,Le=!1,Ze=!1,Y=!1,Te=!1,Re=!1;function Ve(x,T,U){(U||x!=n.width||T!=n.height)&&Ee(x,T),Ir(!1),Ze=!0,Le=!0,Lr()}function Ee(x,T){n.width=Se=y=x,n.height=C=N=T,q=oe=0,Lt(),yt();let U=n.bbox;Be=U.left=Sr(q*Tt,.5),ge=U.top=Sr(oe*Tt,.5),Ce=U.width=Sr(y*Tt,.5),qe=U.height=Sr(N*Tt,.5)}let pe=3;function $e(){let x=!1,T=0;for(;!x;){T++;let U=hx(T),O=ux(T);x=T==pe||U&&O,x||(Ee(n.width,n.height),Le=!0)}}function st({width:x,height:T}){Ve(x,T)}n.setSize=st;function Lt(){let x=!1,T=!1,U=!1,O=!1;M.forEach((Z,ie)=>{if(Z.show&&Z._show){let{side:de,_size:Me}=Z,Ie=de%2,ke=Z.label!=null?Z.labelSize:0,He=Me+ke;He>0&&(Ie?(y-=He,de==3?(q+=He,O=!0):U=!0):(N-=He,de==0?(oe+=He,x=!0):T=!0))}}),os[0]=x,os[1]=U,os[2]=T,os[3]=O,y-=Vi[1]+Vi[3],q+=Vi[3],N-=Vi[2]+Vi[0],oe+=Vi[0]}function yt(){let x=q+y,T=oe+N,U=q,O=oe;function Z(ie,de){switch(ie){case 1:return x+=de,x-de;case 2:return T+=de,T-de;case 3:return U-=de,U+de;case 0:return O-=de,O+de}}M.forEach((ie,de)=>{if(ie.show&&ie._show){let Me=ie.side;ie._pos=Z(Me,ie._size),ie.label!=null&&(ie._lpos=Z(Me,ie.labelSize))}})}if(fe.dataIdx==null){let x=fe.hover,T=x.skip=new Set(x.skip??[]);T.add(void 0);let U=x.prox=vt(x.prox),O=x.bias??(x.bias=0);fe.dataIdx=(Z,ie,de,Me)=>{if(ie==0)return de;let Ie=de,ke=U(Z,ie,de,Me)??Bt,He=ke>=0&&ke<Bt,Xe=A.ori==0?y:N,rt=fe.left,St=e[0],Mt=e[ie];if(T.has(Mt[de])){Ie=null;let pt=null,nt=null,Je;if(O==0||O==-1)for(Je=de;pt==null&&Je-- >0;)T.has(Mt[Je])||(pt=Je);if(O==0||O==1)for(Je=de;nt==null&&Je++<Mt.length;)T.has(Mt[Je])||(nt=Je);if(pt!=null||nt!=null)if(He){let Xt=pt==null?-1/0:B(St[pt],A,Xe,0),jt=nt==null?1/0:B(St[nt],A,Xe,0),_n=rt-Xt,Dt=jt-rt;_n<=Dt?_n<=ke&&(Ie=pt):Dt<=ke&&(Ie=nt)}else Ie=nt==null?pt:pt==null?nt:de-pt<=nt-de?pt:nt}else He&&fn(rt-B(St[de],A,Xe,0))>ke&&(Ie=null);return Ie}}let bn=x=>{fe.event=x};fe.idxs=te,fe._lock=!1;let Ft=fe.points;Ft.show=vt(Ft.show),Ft.size=vt(Ft.size),Ft.stroke=vt(Ft.stroke),Ft.width=vt(Ft.width),Ft.fill=vt(Ft.fill);let ei=n.focus=rn({},i.focus||{alpha:.3},fe.focus),Yn=ei.prox>=0,Hi=Yn&&Ft.one,Fn=[],rs=[],bi=[];function Go(x,T){let U=Ft.show(n,T);if(U instanceof HTMLElement)return ci(U,JS),ci(U,x.class),ts(U,-10,-10,y,N),g.insertBefore(U,Fn[T]),U}function Zs(x,T){if(s==1||T>0){let U=s==1&&_[x.scale].time,O=x.value;x.value=U?jg(O)?r0(X,s0(O,F)):O||ne:O||uE,x.label=x.label||(U?iE:nE)}if(Hi||T>0){x.width=x.width==null?1:x.width,x.paths=x.paths||EE||m1,x.fillTo=vt(x.fillTo||gE),x.pxAlign=+wt(x.pxAlign,v),x.pxRound=p0(x.pxAlign),x.stroke=vt(x.stroke||null),x.fill=vt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let U=fE(qn(1,x.width),1),O=x.points=rn({},{size:U,width:qn(1,U*.2),stroke:x.stroke,space:U*2,paths:TE,_stroke:null,_fill:null},x.points);O.show=vt(O.show),O.filter=vt(O.filter),O.fill=vt(O.fill),O.stroke=vt(O.stroke),O.paths=vt(O.paths),O.pxAlign=x.pxAlign}if(ye){let U=ot(x,T);be.splice(T,0,U[0]),Ge.splice(T,0,U[1]),ce.values.push(null)}if(_e){te.splice(T,0,null);let U=null;Hi?T==0&&(U=Go(x,T)):T>0&&(U=Go(x,T)),Fn.splice(T,0,U),rs.splice(T,0,0),bi.splice(T,0,0)}xn("addSeries",T)}function hl(x,T){T=T??b.length,x=s==1?vd(x,T,a0,f0):vd(x,T,{},u0),b.splice(T,0,x),Zs(b[T],T)}n.addSeries=hl;function ul(x){if(b.splice(x,1),ye){ce.values.splice(x,1),Ge.splice(x,1);let T=be.splice(x,1)[0];he(null,T.firstChild),T.remove()}_e&&(te.splice(x,1),Fn.splice(x,1)[0].remove(),rs.splice(x,1),bi.splice(x,1)),xn("delSeries",x)}n.delSeries=ul;let os=[!1,!1,!1,!1];function lu(x,T){if(x._show=x.show,x.show){let U=x.side%2,O=_[x.scale];O==null&&(x.scale=U?b[1].scale:E,O=_[x.scale]);let Z=O.time;x.size=vt(x.size),x.space=vt(x.space),x.rotate=vt(x.rotate),qs(x.incrs)&&x.incrs.forEach(de=>{!Ys.has(de)&&Ys.set(de,A0(de))}),x.incrs=vt(x.incrs||(O.distr==2?O1:Z?d==1?z1:V1:Er)),x.splits=vt(x.splits||(Z&&O.distr==1?z:O.distr==3?dd:O.distr==4?oE:rE)),x.stroke=vt(x.stroke),x.grid.stroke=vt(x.grid.stroke),x.ticks.stroke=vt(x.ticks.stroke),x.border.stroke=vt(x.border.stroke);let ie=x.values;x.values=qs(ie)&&!qs(ie[0])?vt(ie):Z?qs(ie)?i0(X,n0(ie,F)):jg(ie)?X1(X,ie):ie||J:ie||sE,x.filter=vt(x.filter||(O.distr>=3&&O.log==10?cE:O.distr==3&&O.log==2?hE:E0)),x.font=x0(x.font),x.labelFont=x0(x.labelFont),x._size=x.size(n,null,T,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(os[T]=!0,x._el=_i(YS,f))}}function Ks(x,T,U,O){let[Z,ie,de,Me]=U,Ie=T%2,ke=0;return Ie==0&&(Me||ie)&&(ke=T==0&&!Z||T==2&&!de?un(o0.size/3):0),Ie==1&&(Z||de)&&(ke=T==1&&!ie||T==3&&!Me?un(c0.size/2):0),ke}let fl=n.padding=(i.padding||[Ks,Ks,Ks,Ks]).map(x=>vt(wt(x,Ks))),Vi=n._padding=fl.map((x,T)=>x(n,T,os,0)),on,R=null,K=null,ue=s==1?b[0].idxs:null,ae=null,Q=!1;function Ae(x,T){if(e=x??[],n.data=n._data=e,s==2){on=0;for(let U=1;U<b.length;U++)on+=e[U][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ae=e[0],on=ae.length;let U=e;if(k==2){U=e.slice();let O=U[0]=Array(on);for(let Z=0;Z<on;Z++)O[Z]=Z}n._data=e=U}if(Ir(!0),xn("setData"),k==2&&(Ze=!0),T!==!1){let U=A;U.auto(n,Q)?Ne():Ts(E,U.min,U.max),Y=Y||fe.left>=0,Re=!0,Lr()}}n.setData=Ae;function Ne(){Q=!0;let x,T;s==1&&(on>0?(R=ue[0]=0,K=ue[1]=on-1,x=e[0][R],T=e[0][K],k==2?(x=R,T=K):x==T&&(k==3?[x,T]=zh(x,x,A.log,!1):k==4?[x,T]=bd(x,x,A.log,!1):A.time?T=x+un(86400/d):[x,T]=Fh(x,T,Md,!0))):(R=ue[0]=x=null,K=ue[1]=T=null)),Ts(E,x,T)}let We,ze,et,tt,Ke,ut,bt,kt,Rt,lt;function Qe(x,T,U,O,Z,ie){x??(x=Ng),U??(U=Sd),O??(O="butt"),Z??(Z=Ng),ie??(ie="round"),x!=We&&(h.strokeStyle=We=x),Z!=ze&&(h.fillStyle=ze=Z),T!=et&&(h.lineWidth=et=T),ie!=Ke&&(h.lineJoin=Ke=ie),O!=ut&&(h.lineCap=ut=O),U!=tt&&h.setLineDash(tt=U)}function Ht(x,T,U,O){T!=ze&&(h.fillStyle=ze=T),x!=bt&&(h.font=bt=x),U!=kt&&(h.textAlign=kt=U),O!=Rt&&(h.textBaseline=Rt=O)}function gt(x,T,U,O,Z=0){if(O.length>0&&x.auto(n,Q)&&(T==null||T.min==null)){let ie=wt(R,0),de=wt(K,O.length-1),Me=U.min==null?c1(O,ie,de,Z,x.distr==3):[U.min,U.max];x.min=zi(x.min,U.min=Me[0]),x.max=qn(x.max,U.max=Me[1])}}let Rn={min:null,max:null};function ws(){for(let O in _){let Z=_[O];W[O]==null&&(Z.min==null||W[E]!=null&&Z.auto(n,Q))&&(W[O]=Rn)}for(let O in _){let Z=_[O];W[O]==null&&Z.from!=null&&W[Z.from]!=null&&(W[O]=Rn)}W[E]!=null&&Ir(!0);let x={};for(let O in W){let Z=W[O];if(Z!=null){let ie=x[O]=No(_[O],x1);if(Z.min!=null)rn(ie,Z);else if(O!=E||s==2)if(on==0&&ie.from==null){let de=ie.range(n,null,null,O);ie.min=de[0],ie.max=de[1]}else ie.min=Bt,ie.max=-Bt}}if(on>0){b.forEach((O,Z)=>{if(s==1){let ie=O.scale,de=W[ie];if(de==null)return;let Me=x[ie];if(Z==0){let Ie=Me.range(n,Me.min,Me.max,ie);Me.min=Ie[0],Me.max=Ie[1],R=Bi(Me.min,e[0]),K=Bi(Me.max,e[0]),K-R>1&&(e[0][R]<Me.min&&R++,e[0][K]>Me.max&&K--),O.min=ae[R],O.max=ae[K]}else O.show&&O.auto&&gt(Me,de,O,e[Z],O.sorted);O.idxs[0]=R,O.idxs[1]=K}else if(Z>0&&O.show&&O.auto){let[ie,de]=O.facets,Me=ie.scale,Ie=de.scale,[ke,He]=e[Z],Xe=x[Me],rt=x[Ie];Xe!=null&&gt(Xe,W[Me],ie,ke,ie.sorted),rt!=null&&gt(rt,W[Ie],de,He,de.sorted),O.min=de.min,O.max=de.max}});for(let O in x){let Z=x[O],ie=W[O];if(Z.from==null&&(ie==null||ie.min==null)){let de=Z.range(n,Z.min==Bt?null:Z.min,Z.max==-Bt?null:Z.max,O);Z.min=de[0],Z.max=de[1]}}}for(let O in x){let Z=x[O];if(Z.from!=null){let ie=x[Z.from];if(ie.min==null)Z.min=Z.max=null;else{let de=Z.range(n,ie.min,ie.max,O);Z.min=de[0],Z.max=de[1]}}}let T={},U=!1;for(let O in x){let Z=x[O],ie=_[O];if(ie.min!=Z.min||ie.max!=Z.max){ie.min=Z.min,ie.max=Z.max;let de=ie.distr;ie._min=de==3?bs(ie.min):de==4?sd(ie.min,ie.asinh):de==100?ie.fwd(ie.min):ie.min,ie._max=de==3?bs(ie.max):de==4?sd(ie.max,ie.asinh):de==100?ie.fwd(ie.max):ie.max,T[O]=U=!0}}if(U){b.forEach((O,Z)=>{s==2?Z>0&&T.y&&(O._paths=null):T[O.scale]&&(O._paths=null)});for(let O in T)Ze=!0,xn("setScale",O);_e&&fe.left>=0&&(Y=Re=!0)}for(let O in W)W[O]=null}function On(x){let T=fd(R-1,0,on-1),U=fd(K+1,0,on-1);for(;x[T]==null&&T>0;)T--;for(;x[U]==null&&U<on-1;)U++;return[T,U]}function Js(){if(on>0){let x=b.some(T=>T._focus)&&lt!=ei.alpha;x&&(h.globalAlpha=lt=ei.alpha),b.forEach((T,U)=>{if(U>0&&T.show&&(Vt(U,!1),Vt(U,!0),T._paths==null)){let O=lt;lt!=T.alpha&&(h.globalAlpha=lt=T.alpha);let Z=s==2?[0,e[U][0].length-1]:On(e[U]);T._paths=T.paths(n,U,Z[0],Z[1]),lt!=O&&(h.globalAlpha=lt=O)}}),b.forEach((T,U)=>{if(U>0&&T.show){let O=lt;lt!=T.alpha&&(h.globalAlpha=lt=T.alpha),T._paths!=null&&Bn(U,!1);{let Z=T._paths!=null?T._paths.gaps:null,ie=T.points.show(n,U,R,K,Z),de=T.points.filter(n,U,ie,Z);(ie||de)&&(T.points._paths=T.points.paths(n,U,R,K,de),Bn(U,!0))}lt!=O&&(h.globalAlpha=lt=O),xn("drawSeries",U)}}),x&&(h.globalAlpha=lt=1)}}function Vt(x,T){let U=T?b[x].points:b[x];U._stroke=U.stroke(n,x),U._fill=U.fill(n,x)}function Bn(x,T){let U=T?b[x].points:b[x],{stroke:O,fill:Z,clip:ie,flags:de,_stroke:Me=U._stroke,_fill:Ie=U._fill,_width:ke=U.width}=U._paths;ke=zt(ke*Tt,3);let He=null,Xe=ke%2/2;T&&Ie==null&&(Ie=ke>0?"#fff":Me);let rt=U.pxAlign==1&&Xe>0;if(rt&&h.translate(Xe,Xe),!T){let St=Be-ke/2,Mt=ge-ke/2,pt=Ce+ke,nt=qe+ke;He=new Path2D,He.rect(St,Mt,pt,nt)}T?mn(Me,ke,U.dash,U.cap,Ie,O,Z,de,ie):$n(x,Me,ke,U.dash,U.cap,Ie,O,Z,de,He,ie),rt&&h.translate(-Xe,-Xe)}function $n(x,T,U,O,Z,ie,de,Me,Ie,ke,He){let Xe=!1;Ie!=0&&P.forEach((rt,St)=>{if(rt.series[0]==x){let Mt=b[rt.series[1]],pt=e[rt.series[1]],nt=(Mt._paths||el).band;qs(nt)&&(nt=rt.dir==1?nt[0]:nt[1]);let Je,Xt=null;Mt.show&&nt&&u1(pt,R,K)?(Xt=rt.fill(n,St)||ie,Je=Mt._paths.clip):nt=null,mn(T,U,O,Z,Xt,de,Me,Ie,ke,He,Je,nt),Xe=!0}}),Xe||mn(T,U,O,Z,ie,de,Me,Ie,ke,He)}let pn=Fo|md;function mn(x,T,U,O,Z,ie,de,Me,Ie,ke,He,Xe){Qe(x,T,U,O,Z),(Ie||ke||Xe)&&(h.save(),Ie&&h.clip(Ie),ke&&h.clip(ke)),Xe?(Me&pn)==pn?(h.clip(Xe),He&&h.clip(He),fi(Z,de),Ss(x,ie,T)):Me&md?(fi(Z,de),h.clip(Xe),Ss(x,ie,T)):Me&Fo&&(h.save(),h.clip(Xe),He&&h.clip(He),fi(Z,de),h.restore(),Ss(x,ie,T)):(fi(Z,de),Ss(x,ie,T)),(Ie||ke||Xe)&&h.restore()}function Ss(x,T,U){U>0&&(T instanceof Map?T.forEach((O,Z)=>{h.strokeStyle=We=Z,h.stroke(O)}):T!=null&&x&&h.stroke(T))}function fi(x,T){T instanceof Map?T.forEach((U,O)=>{h.fillStyle=ze=O,h.fill(U)}):T!=null&&x&&h.fill(T)}function cx(x,T,U,O){let Z=M[x],ie;if(O<=0)ie=[0,0];else{let de=Z._space=Z.space(n,x,T,U,O),Me=Z._incrs=Z.incrs(n,x,T,U,O,de);ie=LE(T,U,Me,O,de)}return Z._found=ie}function cu(x,T,U,O,Z,ie,de,Me,Ie,ke){let He=de%2/2;v==1&&h.translate(He,He),Qe(Me,de,Ie,ke,Me),h.beginPath();let Xe,rt,St,Mt,pt=Z+(O==0||O==3?-ie:ie);U==0?(rt=Z,Mt=pt):(Xe=Z,St=pt);for(let nt=0;nt<x.length;nt++)T[nt]!=null&&(U==0?Xe=St=x[nt]:rt=Mt=x[nt],h.moveTo(Xe,rt),h.lineTo(St,Mt));h.stroke(),v==1&&h.translate(-He,-He)}function hx(x){let T=!0;return M.forEach((U,O)=>{if(!U.show)return;let Z=_[U.scale];if(Z.min==null){U._show&&(T=!1,U._show=!1,Ir(!1));return}else U._show||(T=!1,U._show=!0,Ir(!1));let ie=U.side,de=ie%2,{min:Me,max:Ie}=Z,[ke,He]=cx(O,Me,Ie,de==0?y:N);if(He==0)return;let Xe=Z.distr==2,rt=U._splits=U.splits(n,O,Me,Ie,ke,He,Xe),St=Z.distr==2?rt.map(Je=>ae[Je]):rt,Mt=Z.distr==2?ae[rt[1]]-ae[rt[0]]:ke,pt=U._values=U.values(n,U.filter(n,St,O,He,Mt),O,He,Mt);U._rotate=ie==2?U.rotate(n,pt,O,He):0;let nt=U._size;U._size=yi(U.size(n,pt,O,x)),nt!=null&&U._size!=nt&&(T=!1)}),T}function ux(x){let T=!0;return fl.forEach((U,O)=>{let Z=U(n,O,os,x);Z!=Vi[O]&&(T=!1),Vi[O]=Z}),T}function fx(){for(let x=0;x<M.length;x++){let T=M[x];if(!T.show||!T._show)continue;let U=T.side,O=U%2,Z,ie,de=T.stroke(n,x),Me=U==0||U==3?-1:1,[Ie,ke]=T._found;if(T.label!=null){let kn=T.labelGap*Me,ii=un((T._lpos+kn)*Tt);Ht(T.labelFont[0],de,"center",U==2?"top":Ug),h.save(),O==1?(Z=ie=0,h.translate(ii,un(ge+qe/2)),h.rotate((U==3?-Uh:Uh)/2)):(Z=un(Be+Ce/2),ie=ii);let er=w0(T.label)?T.label(n,x,Ie,ke):T.label;h.fillText(er,Z,ie),h.restore()}if(ke==0)continue;let He=_[T.scale],Xe=O==0?Ce:qe,rt=O==0?Be:ge,St=T._splits,Mt=He.distr==2?St.map(kn=>ae[kn]):St,pt=He.distr==2?ae[St[1]]-ae[St[0]]:Ie,nt=T.ticks,Je=T.border,Xt=nt.show?nt.size:0,jt=un(Xt*Tt),_n=un((T.alignTo==2?T._size-Xt-T.gap:T.gap)*Tt),Dt=T._rotate*-Uh/180,Qt=p(T._pos*Tt),ti=(jt+_n)*Me,zn=Qt+ti;ie=O==0?zn:0,Z=O==1?zn:0;let di=T.font[0],Mi=T.align==1?Po:T.align==2?td:Dt>0?Po:Dt<0?td:O==0?"center":U==3?td:Po,Xi=Dt||O==1?"middle":U==2?"top":Ug;Ht(di,de,Mi,Xi);let ni=T.font[1]*T.lineGap,pi=St.map(kn=>p(a(kn,He,Xe,rt))),wi=T._values;for(let kn=0;kn<wi.length;kn++){let ii=wi[kn];if(ii!=null){O==0?Z=pi[kn]:ie=pi[kn],ii=""+ii;let er=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let Hn=0;Hn<er.length;Hn++){let up=er[Hn];Dt?(h.save(),h.translate(Z,ie+Hn*ni),h.rotate(Dt),h.fillText(up,0,0),h.restore()):h.fillText(up,Z,ie+Hn*ni)}}}nt.show&&cu(pi,nt.filter(n,Mt,x,ke,pt),O,U,Qt,jt,zt(nt.width*Tt,3),nt.stroke(n,x),nt.dash,nt.cap);let qi=T.grid;qi.show&&cu(pi,qi.filter(n,Mt,x,ke,pt),O,O==0?2:1,O==0?ge:Be,O==0?qe:Ce,zt(qi.width*Tt,3),qi.stroke(n,x),qi.dash,qi.cap),Je.show&&cu([Qt],[1],O==0?1:0,O==0?1:2,O==1?ge:Be,O==1?qe:Ce,zt(Je.width*Tt,3),Je.stroke(n,x),Je.dash,Je.cap)}xn("drawAxes")}function Ir(x){b.forEach((T,U)=>{U>0&&(T._paths=null,x&&(s==1?(T.min=null,T.max=null):T.facets.forEach(O=>{O.min=null,O.max=null})))})}let dl=!1,hu=!1,Wo=[];function dx(){hu=!1;for(let x=0;x<Wo.length;x++)xn(...Wo[x]);Wo.length=0}function Lr(){dl||(E1(Yd),dl=!0)}function px(x,T=!1){dl=!0,hu=T,x(n),Yd(),T&&Wo.length>0&&queueMicrotask(dx)}n.batch=px;function Yd(){if(Ye&&(ws(),Ye=!1),Ze&&($e(),Ze=!1),Le){if(Yt(m,Po,q),Yt(m,"top",oe),Yt(m,Ka,y),Yt(m,Ja,N),Yt(g,Po,q),Yt(g,"top",oe),Yt(g,Ka,y),Yt(g,Ja,N),Yt(f,Ka,Se),Yt(f,Ja,C),u.width=un(Se*Tt),u.height=un(C*Tt),M.forEach(({_el:x,_show:T,_size:U,_pos:O,side:Z})=>{if(x!=null)if(T){let ie=Z===3||Z===0?U:0,de=Z%2==1;Yt(x,de?"left":"top",O-ie),Yt(x,de?"width":"height",U),Yt(x,de?"top":"left",de?oe:q),Yt(x,de?"height":"width",de?N:y),hd(x,Tr)}else ci(x,Tr)}),We=ze=et=Ke=ut=bt=kt=Rt=tt=null,lt=1,Yo(!0),q!=se||oe!=Ue||y!=xe||N!=Fe){Ir(!1);let x=y/xe,T=N/Fe;if(_e&&!Y&&fe.left>=0){fe.left*=x,fe.top*=T,Dr&&ts(Dr,un(fe.left),0,y,N),Ur&&ts(Ur,0,un(fe.top),y,N);for(let U=0;U<Fn.length;U++){let O=Fn[U];O!=null&&(rs[U]*=x,bi[U]*=T,ts(O,yi(rs[U]),yi(bi[U]),y,N))}}if(Wt.show&&!Te&&Wt.left>=0&&Wt.width>0){Wt.left*=x,Wt.width*=x,Wt.top*=T,Wt.height*=T;for(let U in gu)Yt(Or,U,Wt[U])}se=q,Ue=oe,xe=y,Fe=N}xn("setSize"),Le=!1}Se>0&&C>0&&(h.clearRect(0,0,u.width,u.height),xn("drawClear"),D.forEach(x=>x()),xn("draw")),Wt.show&&Te&&(pl(Wt),Te=!1),_e&&Y&&(Qs(null,!0,!1),Y=!1),ce.show&&ce.live&&Re&&(pu(),Re=!1),l||(l=!0,n.status=1,xn("ready")),Q=!1,dl=!1}n.redraw=(x,T)=>{Ze=T||!1,x!==!1?Ts(E,A.min,A.max):Lr()};function uu(x,T){let U=_[x];if(U.from==null){if(on==0){let O=U.range(n,T.min,T.max,x);T.min=O[0],T.max=O[1]}if(T.min>T.max){let O=T.min;T.min=T.max,T.max=O}if(on>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;x==E&&U.distr==2&&on>0&&(T.min=Bi(T.min,e[0]),T.max=Bi(T.max,e[0]),T.min==T.max&&T.max++),W[x]=T,Ye=!0,Lr()}}n.setScale=uu;let fu,du,Dr,Ur,$d,Zd,Nr,Fr,Kd,Jd,Gt,$t,Es=!1,Mn=fe.drag,gn=Mn.x,vn=Mn.y;_e&&(fe.x&&(fu=_i(ZS,g)),fe.y&&(du=_i(KS,g)),A.ori==0?(Dr=fu,Ur=du):(Dr=du,Ur=fu),Gt=fe.left,$t=fe.top);let Wt=n.select=rn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Or=Wt.show?_i($S,Wt.over?g:m):null;function pl(x,T){if(Wt.show){for(let U in x)Wt[U]=x[U],U in gu&&Yt(Or,U,x[U]);T!==!1&&xn("setSelect")}}n.setSelect=pl;function mx(x){if(b[x].show)ye&&hd(be[x],Tr);else if(ye&&ci(be[x],Tr),_e){let U=Hi?Fn[0]:Fn[x];U!=null&&ts(U,-10,-10,y,N)}}function Ts(x,T,U){uu(x,{min:T,max:U})}function Gi(x,T,U,O){T.focus!=null&&yx(x),T.show!=null&&b.forEach((Z,ie)=>{ie>0&&(x==ie||x==null)&&(Z.show=T.show,mx(ie),s==2?(Ts(Z.facets[0].scale,null,null),Ts(Z.facets[1].scale,null,null)):Ts(Z.scale,null,null),Lr())}),U!==!1&&xn("setSeries",x,T),O&&$o("setSeries",n,x,T)}n.setSeries=Gi;function gx(x,T){rn(P[x],T)}function vx(x,T){x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1),T=T??P.length,P.splice(T,0,x)}function xx(x){x==null?P.length=0:P.splice(x,1)}n.addBand=vx,n.setBand=gx,n.delBand=xx;function _x(x,T){b[x].alpha=T,_e&&Fn[x]!=null&&(Fn[x].style.opacity=T),ye&&be[x]&&(be[x].style.opacity=T)}let as,As,js,Br={focus:!0};function yx(x){if(x!=js){let T=x==null,U=ei.alpha!=1;b.forEach((O,Z)=>{if(s==1||Z>0){let ie=T||Z==0||Z==x;O._focus=T?null:ie,U&&_x(Z,ie?1:ei.alpha)}}),js=x,U&&Lr()}}ye&&Yn&&j(Bg,$,x=>{fe._lock||(bn(x),js!=null&&Gi(null,Br,!0,tn.setSeries))});function Wi(x,T,U){let O=_[T];U&&(x=x/Tt-(O.ori==1?oe:q));let Z=y;O.ori==1&&(Z=N,x=Z-x),O.dir==-1&&(x=Z-x);let ie=O._min,de=O._max,Me=x/Z,Ie=ie+(de-ie)*Me,ke=O.distr;return ke==3?Do(10,Ie):ke==4?d1(Ie,O.asinh):ke==100?O.bwd(Ie):Ie}function bx(x,T){let U=Wi(x,E,T);return Bi(U,e[0],R,K)}n.valToIdx=x=>Bi(x,e[0]),n.posToIdx=bx,n.posToVal=Wi,n.valToPos=(x,T,U)=>_[T].ori==0?r(x,_[T],U?Ce:y,U?Be:0):o(x,_[T],U?qe:N,U?ge:0),n.setCursor=(x,T,U)=>{Gt=x.left,$t=x.top,Qs(null,T,U)};function jd(x,T){Yt(Or,Po,Wt.left=x),Yt(Or,Ka,Wt.width=T)}function Qd(x,T){Yt(Or,"top",Wt.top=x),Yt(Or,Ja,Wt.height=T)}let Xo=A.ori==0?jd:Qd,qo=A.ori==1?jd:Qd;function Mx(){if(ye&&ce.live)for(let x=s==2?1:0;x<b.length;x++){if(x==0&&H)continue;let T=ce.values[x],U=0;for(let O in T)Ge[x][U++].firstChild.nodeValue=T[O]}}function pu(x,T){if(x!=null&&(x.idxs?x.idxs.forEach((U,O)=>{te[O]=U}):v1(x.idx)||te.fill(x.idx),ce.idx=te[0]),ye&&ce.live){for(let U=0;U<b.length;U++)(U>0||s==1&&!H)&&wx(U,te[U]);Mx()}Re=!1,T!==!1&&xn("setLegend")}n.setLegend=pu;function wx(x,T){let U=b[x],O=x==0&&k==2?ae:e[x],Z;H?Z=U.values(n,x,T)??ht:(Z=U.value(n,T==null?null:O[T],x,T),Z=Z==null?ht:{_:Z}),ce.values[x]=Z}function Qs(x,T,U){Kd=Gt,Jd=$t,[Gt,$t]=fe.move(n,Gt,$t),fe.left=Gt,fe.top=$t,_e&&(Dr&&ts(Dr,un(Gt),0,y,N),Ur&&ts(Ur,0,un($t),y,N));let O,Z=R>K;as=Bt,As=null;let ie=A.ori==0?y:N,de=A.ori==1?y:N;if(Gt<0||on==0||Z){O=fe.idx=null;for(let Me=0;Me<b.length;Me++){let Ie=Fn[Me];Ie!=null&&ts(Ie,-10,-10,y,N)}Yn&&Gi(null,Br,!0,x==null&&tn.setSeries),ce.live&&(te.fill(O),Re=!0)}else{let Me,Ie,ke;s==1&&(Me=A.ori==0?Gt:$t,Ie=Wi(Me,E),O=fe.idx=Bi(Ie,e[0],R,K),ke=B(e[0][O],A,ie,0));let He=-10,Xe=-10,rt=0,St=0,Mt=!0,pt="",nt="";for(let Je=s==2?1:0;Je<b.length;Je++){let Xt=b[Je],jt=te[Je],_n=jt==null?null:s==1?e[Je][jt]:e[Je][1][jt],Dt=fe.dataIdx(n,Je,O,Ie),Qt=Dt==null?null:s==1?e[Je][Dt]:e[Je][1][Dt];if(Re=Re||Qt!=_n||Dt!=jt,te[Je]=Dt,Je>0&&Xt.show){let ti=Dt==null?-10:Dt==O?ke:B(s==1?e[0][Dt]:e[Je][0][Dt],A,ie,0),zn=Qt==null?-10:V(Qt,s==1?_[Xt.scale]:_[Xt.facets[1].scale],de,0);if(Yn&&Qt!=null){let di=A.ori==1?Gt:$t,Mi=fn(ei.dist(n,Je,Dt,zn,di));if(Mi<as){let Xi=ei.bias;if(Xi!=0){let ni=Wi(di,Xt.scale),pi=Qt>=0?1:-1,wi=ni>=0?1:-1;wi==pi&&(wi==1?Xi==1?Qt>=ni:Qt<=ni:Xi==1?Qt<=ni:Qt>=ni)&&(as=Mi,As=Je)}else as=Mi,As=Je}}if(Re||Hi){let di,Mi;A.ori==0?(di=ti,Mi=zn):(di=zn,Mi=ti);let Xi,ni,pi,wi,qi,kn,ii=!0,er=Ft.bbox;if(er!=null){ii=!1;let Hn=er(n,Je);pi=Hn.left,wi=Hn.top,Xi=Hn.width,ni=Hn.height}else pi=di,wi=Mi,Xi=ni=Ft.size(n,Je);if(kn=Ft.fill(n,Je),qi=Ft.stroke(n,Je),Hi)Je==As&&as<=ei.prox&&(He=pi,Xe=wi,rt=Xi,St=ni,Mt=ii,pt=kn,nt=qi);else{let Hn=Fn[Je];Hn!=null&&(rs[Je]=pi,bi[Je]=wi,Xg(Hn,Xi,ni,ii),Gg(Hn,kn,qi),ts(Hn,yi(pi),yi(wi),y,N))}}}}if(Hi){let Je=ei.prox,Xt=js==null?as<=Je:as>Je||As!=js;if(Re||Xt){let jt=Fn[0];jt!=null&&(rs[0]=He,bi[0]=Xe,Xg(jt,rt,St,Mt),Gg(jt,pt,nt),ts(jt,yi(He),yi(Xe),y,N))}}}if(Wt.show&&Es)if(x!=null){let[Me,Ie]=tn.scales,[ke,He]=tn.match,[Xe,rt]=x.cursor.sync.scales,St=x.cursor.drag;if(gn=St._x,vn=St._y,gn||vn){let{left:Mt,top:pt,width:nt,height:Je}=x.select,Xt=x.scales[Xe].ori,jt=x.posToVal,_n,Dt,Qt,ti,zn,di=Me!=null&&ke(Me,Xe),Mi=Ie!=null&&He(Ie,rt);di&&gn?(Xt==0?(_n=Mt,Dt=nt):(_n=pt,Dt=Je),Qt=_[Me],ti=B(jt(_n,Xe),Qt,ie,0),zn=B(jt(_n+Dt,Xe),Qt,ie,0),Xo(zi(ti,zn),fn(zn-ti))):Xo(0,ie),Mi&&vn?(Xt==1?(_n=Mt,Dt=nt):(_n=pt,Dt=Je),Qt=_[Ie],ti=V(jt(_n,rt),Qt,de,0),zn=V(jt(_n+Dt,rt),Qt,de,0),qo(zi(ti,zn),fn(zn-ti))):qo(0,de)}else vu()}else{let Me=fn(Kd-$d),Ie=fn(Jd-Zd);if(A.ori==1){let rt=Me;Me=Ie,Ie=rt}gn=Mn.x&&Me>=Mn.dist,vn=Mn.y&&Ie>=Mn.dist;let ke=Mn.uni;ke!=null?gn&&vn&&(gn=Me>=ke,vn=Ie>=ke,!gn&&!vn&&(Ie>Me?vn=!0:gn=!0)):Mn.x&&Mn.y&&(gn||vn)&&(gn=vn=!0);let He,Xe;gn&&(A.ori==0?(He=Nr,Xe=Gt):(He=Fr,Xe=$t),Xo(zi(He,Xe),fn(Xe-He)),vn||qo(0,de)),vn&&(A.ori==1?(He=Nr,Xe=Gt):(He=Fr,Xe=$t),qo(zi(He,Xe),fn(Xe-He)),gn||Xo(0,ie)),!gn&&!vn&&(Xo(0,0),qo(0,0))}if(Mn._x=gn,Mn._y=vn,x==null){if(U){if(hp!=null){let[Me,Ie]=tn.scales;tn.values[0]=Me!=null?Wi(A.ori==0?Gt:$t,Me):null,tn.values[1]=Ie!=null?Wi(A.ori==1?Gt:$t,Ie):null}$o(nd,n,Gt,$t,y,N,O)}if(Yn){let Me=U&&tn.setSeries,Ie=ei.prox;js==null?as<=Ie&&Gi(As,Br,!0,Me):as>Ie?Gi(null,Br,!0,Me):As!=js&&Gi(As,Br,!0,Me)}}Re&&(ce.idx=O,pu()),T!==!1&&xn("setCursor")}let Rs=null;Object.defineProperty(n,"rect",{get(){return Rs==null&&Yo(!1),Rs}});function Yo(x=!1){x?Rs=null:(Rs=g.getBoundingClientRect(),xn("syncRect",Rs))}function ep(x,T,U,O,Z,ie,de){fe._lock||Es&&x!=null&&x.movementX==0&&x.movementY==0||(mu(x,T,U,O,Z,ie,de,!1,x!=null),x!=null?Qs(null,!0,!0):Qs(T,!0,!1))}function mu(x,T,U,O,Z,ie,de,Me,Ie){if(Rs==null&&Yo(!1),bn(x),x!=null)U=x.clientX-Rs.left,O=x.clientY-Rs.top;else{if(U<0||O<0){Gt=-10,$t=-10;return}let[ke,He]=tn.scales,Xe=T.cursor.sync,[rt,St]=Xe.values,[Mt,pt]=Xe.scales,[nt,Je]=tn.match,Xt=T.axes[0].side%2==1,jt=A.ori==0?y:N,_n=A.ori==1?y:N,Dt=Xt?ie:Z,Qt=Xt?Z:ie,ti=Xt?O:U,zn=Xt?U:O;if(Mt!=null?U=nt(ke,Mt)?a(rt,_[ke],jt,0):-10:U=jt*(ti/Dt),pt!=null?O=Je(He,pt)?a(St,_[He],_n,0):-10:O=_n*(zn/Qt),A.ori==1){let di=U;U=O,O=di}}Ie&&(T==null||T.cursor.event.type==nd)&&((U<=1||U>=y-1)&&(U=Sr(U,y)),(O<=1||O>=N-1)&&(O=Sr(O,N))),Me?($d=U,Zd=O,[Nr,Fr]=fe.move(n,U,O)):(Gt=U,$t=O)}let gu={width:0,height:0,left:0,top:0};function vu(){pl(gu,!1)}let tp,np,ip,sp;function rp(x,T,U,O,Z,ie,de){Es=!0,gn=vn=Mn._x=Mn._y=!1,mu(x,T,U,O,Z,ie,de,!0,!1),x!=null&&(j(id,ld,op,!1),$o(Fg,n,Nr,Fr,y,N,null));let{left:Me,top:Ie,width:ke,height:He}=Wt;tp=Me,np=Ie,ip=ke,sp=He}function op(x,T,U,O,Z,ie,de){Es=Mn._x=Mn._y=!1,mu(x,T,U,O,Z,ie,de,!1,!0);let{left:Me,top:Ie,width:ke,height:He}=Wt,Xe=ke>0||He>0,rt=tp!=Me||np!=Ie||ip!=ke||sp!=He;if(Xe&&rt&&pl(Wt),Mn.setScale&&Xe&&rt){let St=Me,Mt=ke,pt=Ie,nt=He;if(A.ori==1&&(St=Ie,Mt=He,pt=Me,nt=ke),gn&&Ts(E,Wi(St,E),Wi(St+Mt,E)),vn)for(let Je in _){let Xt=_[Je];Je!=E&&Xt.from==null&&Xt.min!=Bt&&Ts(Je,Wi(pt+nt,Je),Wi(pt,Je))}vu()}else fe.lock&&(fe._lock=!fe._lock,Qs(T,!0,x!=null));x!=null&&(he(id,ld),$o(id,n,Gt,$t,y,N,null))}function Sx(x,T,U,O,Z,ie,de){if(fe._lock)return;bn(x);let Me=Es;if(Es){let Ie=!0,ke=!0,He=10,Xe,rt;A.ori==0?(Xe=gn,rt=vn):(Xe=vn,rt=gn),Xe&&rt&&(Ie=Gt<=He||Gt>=y-He,ke=$t<=He||$t>=N-He),Xe&&Ie&&(Gt=Gt<Nr?0:y),rt&&ke&&($t=$t<Fr?0:N),Qs(null,!0,!0),Es=!1}Gt=-10,$t=-10,te.fill(null),Qs(null,!0,!0),Me&&(Es=Me)}function ap(x,T,U,O,Z,ie,de){fe._lock||(bn(x),Ne(),vu(),x!=null&&$o(zg,n,Gt,$t,y,N,null))}function lp(){M.forEach(DE),Ve(n.width,n.height,!0)}Ar(Nh,Lo,lp);let zr={};zr.mousedown=rp,zr.mousemove=ep,zr.mouseup=op,zr.dblclick=ap,zr.setSeries=(x,T,U,O)=>{let Z=tn.match[2];U=Z(n,T,U),U!=-1&&Gi(U,O,!0,!1)},_e&&(j(Fg,g,rp),j(nd,g,ep),j(Og,g,x=>{bn(x),Yo(!1)}),j(Bg,g,Sx),j(zg,g,ap),gd.add(n),n.syncRect=Yo);let ml=n.hooks=i.hooks||{};function xn(x,T,U){hu?Wo.push([x,T,U]):x in ml&&ml[x].forEach(O=>{O.call(null,n,T,U)})}(i.plugins||[]).forEach(x=>{for(let T in x.hooks)ml[T]=(ml[T]||[]).concat(x.hooks[T])});let cp=(x,T,U)=>U,tn=rn({key:null,setSeries:!1,filters:{pub:Kg,sub:Kg},scales:[E,b[1]?b[1].scale:null],match:[Jg,Jg,cp],values:[null,null]},fe.sync);tn.match.length==2&&tn.match.push(cp),fe.sync=tn;let hp=tn.key,xu=Y0(hp);function $o(x,T,U,O,Z,ie,de){tn.filters.pub(x,T,U,O,Z,ie,de)&&xu.pub(x,T,U,O,Z,ie,de)}xu.sub(n);function Ex(x,T,U,O,Z,ie,de){tn.filters.sub(x,T,U,O,Z,ie,de)&&zr[x](null,T,U,O,Z,ie,de)}n.pub=Ex;function Tx(){xu.unsub(n),gd.delete(n),le.clear(),ud(Nh,Lo,lp),c.remove(),$?.remove(),xn("destroy")}n.destroy=Tx;function _u(){xn("init",i,e),Ae(e||i.data,!1),W[E]?uu(E,W[E]):Ne(),Te=Wt.show&&(Wt.width>0||Wt.height>0),Y=Re=!0,Ve(i.width,i.height)}return b.forEach(Zs),M.forEach(lu),t?t instanceof HTMLElement?(t.appendChild(c),_u()):t(n,_u):_u(),n}Kt.assign=rn;Kt.fmtNum=wd;Kt.rangeNum=Fh;Kt.rangeLog=zh;Kt.rangeAsinh=bd;Kt.orient=Cr;Kt.pxRatio=Tt;Kt.join=S1;Kt.fmtDate=Ed,Kt.tzDate=N1;Kt.sync=Y0;{Kt.addGap=vE,Kt.clipGaps=Vh;let i=Kt.paths={points:Q0};i.linear=tv,i.stepped=yE,i.bars=bE,i.spline=wE}var rv=112,UE=18,NE=54,FE=1e-5,ov=.1,OE=100,Ld=[1e-6,1e6],Dd=14,lv=i=>{let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)},BE=.005,zE=5;function kE(i,[e,t]){let n=r=>Math.floor(Math.log10(r||1)),s=Math.max(0,Math.min(Math.round(-Math.log10(BE*(t-e||1))),zE-1-n(Math.max(Math.abs(e),Math.abs(t)))));return s>6||Math.abs(i)>=1e6?i===0?"0":i.toExponential(3):i.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1")}function cv(i,{onSeek:e=()=>{},onZoom:t=()=>{},onEdit:n=()=>{},onRemove:s=()=>{}}={}){let r=[],o=[],a=null,l={range:null,heights:{}},c=[],u=0,h=null;i.classList.add("plots");function f(A){a=A&&[...new Map(A.map(k=>[String(k),k])).values()],m(o)}function m(A){o=A,r.forEach(({plot:V})=>V.destroy()),i.replaceChildren();let k=Pn(),B=a??tr(o);r=Cp(o,B).map(V=>{let W=G("div",{class:"plot-keys"}),X=V.curves.map(fe=>{let ye=document.createElementNS("http://www.w3.org/2000/svg","svg");ye.setAttribute("viewBox","0 0 22 6"),ye.setAttribute("aria-hidden","true");let _e=document.createElementNS("http://www.w3.org/2000/svg","line");Object.entries({x1:0,x2:22,y1:3,y2:3,stroke:fe.colour,"stroke-width":2.4,"stroke-dasharray":fe.dash.join(" ")}).forEach(([$,me])=>_e.setAttribute($,me)),ye.append(_e);let ee=G("b");return ee.style.setProperty("--colour",fe.colour),W.append(G("span",{class:"plot-key"},ye,G("span",{},fe.name),ee)),ee}),F=V.unit?`${V.name} [${V.unit}]`:V.name,z=B.findIndex(fe=>V.key===(Array.isArray(fe)?fe.join():fe)),J=(fe,ye,_e)=>G("button",{type:"button",class:"small",title:ye,"aria-label":`${ye}: ${F}`,onclick:_e},fe),ne=G("span",{class:"plot-tools"},...V.own?[J("edit","Change the signals",()=>n(z))]:[],J("×","Remove this plot",()=>s(z))),te=G("div",{class:"plot-canvas"});i.append(G("section",{class:"plot"},G("header",{},G("h3",{},F),ne,W),te));let ce={panel:V,values:X,canvas:te,marker:G("div",{class:"plot-now"}),cross:G("div",{class:"plot-under",hidden:!0}),flag:G("div",{class:"plot-flag",hidden:!0})};return ce.plot=g(ce,k),ce.plot.over.append(ce.marker,ce.cross,ce.flag),ce}),M()}function g({panel:A,canvas:k},B){let V=new Map;for(let $ of A.curves){let me=V.get($.t)??{times:Array.from($.t,ve=>ve+$.flight.shift),curves:[]};V.set($.t,{...me,curves:[...me.curves,$]})}let W=[...V.values()],X=W.map(({times:$,curves:me})=>[$,...me.map(ve=>Array.from(ve.values))]),F=X.length===1?X[0]:Kt.join(X),z=W.flatMap(({curves:$})=>$),J={stroke:B.faint,grid:{stroke:B.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ne=HE(o.flatMap($=>$.impacts.map(([me,ve])=>[me+$.shift,ve+$.shift]))),te=Kt.paths.stepped({align:1}),ce=A.words&&(($,me)=>me.map(ve=>A.words[ve]??"")),fe={width:Math.max(k.clientWidth,200),height:rv,padding:[6,20,0,0],legend:{show:!1},scales:{x:{time:!1},y:{range:($,me,ve)=>l.heights[A.key]??VE(me,ve)}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!0,y:!0,uni:Dd,setScale:!1},bind:{dblclick:()=>()=>d()}},axes:[{...J,size:22,gap:2,space:56,values:($,me)=>me.map(ve=>WE(ve,me))},{...J,size:($,me)=>Math.max(NE,7*Math.max(0,...(me??[]).map(ve=>ve.length))+8),gap:4,space:ce?13:UE,values:ce||(($,me)=>GE(me))}],series:[{},...z.map($=>({stroke:$.colour,width:1.7,dash:$.dash,spanGaps:!0,points:{show:!1},...$.held?{paths:te}:{}}))],hooks:{drawClear:[$=>{$.ctx.fillStyle=B.force+"2e";for(let[me,ve]of ne){let be=$.valToPos(Math.max(me,$.scales.x.min),"x",!0),Ge=$.valToPos(Math.min(ve,$.scales.x.max),"x",!0);Ge>be&&$.ctx.fillRect(be,$.bbox.top,Math.max(Ge-be,1),$.bbox.height)}}],setSelect:[$=>v($,A.key)],draw:[$=>r.filter(me=>me.plot===$).forEach(D)]}},ye=new Kt(fe,F,k),_e=null;ye.over.addEventListener("pointerdown",$=>_e=[$.clientX,$.clientY]),ye.over.addEventListener("pointerup",$=>{_e&&Math.hypot($.clientX-_e[0],$.clientY-_e[1])<5&&e(ee($)),_e=null}),ye.over.addEventListener("pointercancel",()=>_e=null),ye.over.addEventListener("pointermove",$=>$.pointerType!=="touch"&&P(ee($),ye)),ye.over.addEventListener("pointerleave",()=>P(null));let ee=$=>ye.posToVal($.clientX-ye.over.getBoundingClientRect().left,"x");return ye}function v(A,k){let{left:B,top:V,width:W,height:X}=A.select,F=W>=Dd&&W<A.over.clientWidth-1,z=X>=Dd&&X<A.over.clientHeight-1;if(W+X<=0||!(F||z))return;let J=F?[A.posToVal(B,"x"),A.posToVal(B+W,"x")]:l.range,ne=z?{[k]:[A.posToVal(V+X,"y"),A.posToVal(V,"y")]}:{};A.setSelect({left:0,top:0,width:0,height:0},!1),p({range:J,heights:{...l.heights,...ne}})}function p(A){JSON.stringify(A)===JSON.stringify(l)||!av(A.range)||(c=[...c,l].slice(-OE),l=A,M(),t())}function d(A,k){p({range:A===void 0?null:[A,k],heights:{}})}function b(){return c.length?(l=c.pop(),M(),t(),!0):!1}function M(){let A=o.length?[Math.min(...o.map(V=>V.begin+V.shift)),Math.max(...o.map(V=>V.end+V.shift))]:[0,1],[k,B]=l.range??A;r.forEach(({plot:V})=>V.setScale("x",{min:k,max:B})),E(u)}function _({plot:A,marker:k,cross:B}){let{min:V,max:W}=A.scales.x;for(let[X,F]of[[k,u],[B,h]])X.hidden=F===null||!(F>=V&&F<=W),X.hidden||(X.style.transform=`translateX(${A.valToPos(F,"x")}px)`)}function P(A,k){h=A;for(let B of r){if(B.flag.hidden=A===null||B.plot!==k,B.flag.hidden)continue;B.flag.textContent=`${A.toFixed(4)} s`;let V=k.valToPos(A,"x");B.flag.classList.toggle("left",V>.7*k.over.clientWidth),B.flag.style.transform=`translateX(${V}px)`}i.classList.toggle("pointing",A!==null),I()}function E(A){u=A,I()}let I=()=>r.forEach(D);function D(A){let{panel:k,plot:B,values:V}=A,W=[B.scales.y.min??0,B.scales.y.max??1];_(A),k.curves.forEach((X,F)=>{let z=jo(X,h??u);V[F].textContent=k.words?.[Math.round(z)]??kE(z,W)})}function w(){r.forEach(({plot:A,canvas:k})=>{let B=k.clientWidth;B&&Math.abs(B-A.width)>1&&A.setSize({width:B,height:rv})}),E(u)}let S=new ResizeObserver(w);return S.observe(i),{replace:m,choose:f,show:E,zoom:d,back:b,resize:w,restore(A){av(A.range)&&(l=A,M(),t())},get wanted(){return a??tr(o)},get range(){return l.range},get zoomed(){return l},get canGoBack(){return c.length>0},shown:()=>r.map(({panel:A,plot:k,values:B})=>({name:A.name,unit:A.unit,limits:[k.scales.y.min,k.scales.y.max],ticks:[...k.axes[1]._values??[]],values:Object.fromEntries(A.curves.map((V,W)=>[V.name,B[W].textContent]))})),dispose(){S.disconnect(),r.forEach(({plot:A})=>A.destroy()),i.replaceChildren()}}}function av(i){if(i===null)return!0;let[e,t]=i;return t-e>=Ld[0]&&t-e<=Ld[1]&&Math.abs(e)<=Ld[1]}function HE(i){let e=[];for(let[t,n]of i.sort((s,r)=>s[0]-r[0])){let s=e[e.length-1];s&&t<=s[1]?s[1]=Math.max(s[1],n):e.push([t,n])}return e}function VE(i,e){if(i==null||e==null)return[0,1];let t=Math.max(Math.abs(i),Math.abs(e));if(t===0)return[-.1,1];e-i<FE*t&&([i,e]=[i-ov*t,e+ov*t]);let n=Math.max(e-i,.001*Math.max(Math.abs(i),Math.abs(e)),1e-6);return[i-.06*n,e+.08*n]}function GE(i){let e=i.length>1?Math.abs(i[1]-i[0]):Math.abs(i[0]),t=Math.floor(Math.log10(e||1)+1e-9),n=Math.max(...i.map(Math.abs));if(t<-6||n>=1e6)return i.map(r=>r===0?"0":r.toExponential(2));let s=Math.max(0,-t);return Math.abs(e*10**s-Math.round(e*10**s))>1e-6&&s++,i.map(r=>r.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1"))}function WE(i,e){let t=0,n=.001*(e.length>1?e[1]-e[0]:1);for(;t<6&&e.some(s=>Math.abs(s-Number(s.toFixed(t)))>n);)t++;return`${i.toFixed(t)} s`}var nl=[1,2,5,10,20,50,100,200],XE=.25,hv=2,uv=i=>!i.arms.some(e=>e.compliant),qE=i=>{if(i>.995)return"real time";let e=1/i;return`1/${e<10?e.toFixed(1).replace(/\.0$/,""):Math.round(e)} of real time`};function qh({scene:i,plots:e=null,bar:t,readouts:n=null,actions:s={},onRest:r=()=>{}}){let o={t:0,playing:!1,pace:"auto",line:null,flights:[],last:0},a=G("button",{class:"play",type:"button",onclick:()=>o.playing?P():_()}),l=G("button",{type:"button",title:"One instant back (←)","aria-label":"One instant back",onclick:()=>w(-1)},Yi("back")),c=G("button",{type:"button",title:"One instant forward (→)","aria-label":"One instant forward",onclick:()=>w(1)},Yi("forth")),u=G("button",{type:"button",title:"Go to the first touch (T)","aria-label":"Go to the first touch",onclick:S},Yi("touch")),h=G("select",{"aria-label":"Speed",title:"Speed (, and .)",onchange:()=>I(h.value)},G("option",{value:"auto"},"slow at impact"),...nl.map(F=>G("option",{value:String(F)},F===1?"real time":`1/${F}`))),f=G("output",{class:"clock","aria-live":"off"}),m=G("input",{type:"range",min:0,max:1,step:"any",value:0,"aria-label":"Time",oninput:()=>{P(),d(o.line.timeAt(Number(m.value)*o.line.total))}}),g=G("div",{class:"ticks","aria-hidden":"true"}),v=G("div",{class:"track"},g,m),p=G("div",{class:"events"});t.classList.add("player"),t.replaceChildren(G("div",{class:"buttons"},a,l,c,u,h,f),v,p);function d(F){if(!o.line)return;o.t=Math.min(Math.max(F,o.line.begin),o.line.end),i.show(o.t),e?.show(o.t);let z=o.line.watchedAt(o.t)/o.line.total;m.value=z,v.style.setProperty("--share",z),b(),o.playing||r()}function b(){let F=xl(o.flights),z=F===null?"":` · ${o.t>=F?"+":"−"}${Math.abs(1e3*(o.t-F)).toFixed(1)} ms from touch`,J=o.pace==="auto"?o.line.paceAt(o.t):1/Number(o.pace);f.replaceChildren(G("b",{},`${o.t.toFixed(4)} s`),G("span",{},z),G("span",{class:"pace"},qE(J))),m.setAttribute("aria-valuetext",`${o.t.toFixed(3)} s${z}`),n&&V()}function M(F){if(!o.playing)return;let z=Math.min((F-o.last)/1e3,.1);o.last=F;let J=o.line,ne=o.pace==="auto"?J.timeAt(J.watchedAt(o.t)+z):o.t+z/Number(o.pace);d(ne),o.t>=J.end?P():requestAnimationFrame(M)}function _(){!o.line||o.playing||(o.t>=o.line.end-1e-9&&d(o.line.begin),o.playing=!0,o.last=performance.now(),E(),requestAnimationFrame(M))}function P(){o.playing&&setTimeout(r),o.playing=!1,E()}function E(){a.replaceChildren(Yi(o.playing?"pause":"play")),a.setAttribute("aria-label",o.playing?"Pause":"Play"),a.title=o.playing?"Pause (space)":"Play (space)"}function I(F){o.pace=F==="auto"?"auto":String(nl.reduce((z,J)=>Math.abs(J-F)<Math.abs(z-F)?J:z)),h.value=o.pace,b(),r()}function D(F){let z=o.pace==="auto"?F>0?0:1:nl.indexOf(Number(o.pace))+F;I(nl[Math.min(Math.max(z,0),nl.length-1)])}function w(F){P();let z=o.flights[0],J=o.t-z.shift,ne=vl(z.t,J+1e-9),te=z.t[ne]<J-1e-9&&F<0?ne:ne+F;d(z.t[Math.min(Math.max(te,0),z.n-1)]+z.shift)}function S(){P();let F=xl(o.flights);F!==null&&d(F)}function A(){let F=o.line,z=te=>F.watchedAt(te)/F.total;g.replaceChildren(...F.stretches.map(([te,ce])=>{let fe=G("span",{class:"slow"});return fe.style.left=`${100*z(te)}%`,fe.style.width=`${100*Math.max(z(ce)-z(te),.002)}%`,fe}));let J=o.flights.flatMap(te=>te.events.map(ce=>({...ce,t:ce.t+te.shift,flight:te})));J.sort((te,ce)=>te.t-ce.t);for(let te of J){let ce=G("i",{class:te.kind});ce.style.left=`${100*z(te.t)}%`,o.flights.length>1&&(ce.style.background=te.flight.colour),g.append(ce)}let ne=o.flights.length>1;p.replaceChildren(...J.filter(te=>te.kind!=="end"||!ne).slice(0,60).map(te=>{let ce=ne?`${te.flight.label}: ${te.label}`:te.label,fe=G("button",{type:"button",class:`event ${te.kind}`,title:`${te.text}, ${te.t.toFixed(4)} s`,onclick:()=>{P(),d(te.t)}},G("span",{},ce),G("small",{},` ${te.t.toFixed(3)} s`));return ne&&fe.style.setProperty("--colour",te.flight.colour),fe}))}let k=[];function B(){if(!n)return;let F=["speed","acceleration","compression, largest","contact force, sum of all contacts","thrust, all rotors"],z=["m/s","m/s²","mm","N","N"],J=o.flights.length>2,ne=G("table",{class:J?"numbers crowded":"numbers"});o.flights.length>1&&ne.append(G("thead",{},G("tr",{},G("th",{},""),...o.flights.map(ce=>{let fe=G("th",{scope:"col"},ce.label);return fe.style.color=ce.colour,fe}),...J?[]:[G("th",{},"")])));let te=G("tbody");k=F.map((ce,fe)=>{let ye=o.flights.map(()=>G("td")),_e=G("td",{class:"unit"},fe===hv&&o.flights.every(uv)?"":z[fe]);return te.append(G("tr",{},G("th",{scope:"row"},J?`${ce} [${z[fe]}]`:ce),...ye,...J?[]:[_e])),ye}),ne.append(te),n.replaceChildren(ne)}function V(){o.flights.forEach((F,z)=>{let J=Jo(F,o.t),ne=_e=>F.series.find(ee=>ee.panel===_e),te=_e=>ne(_e)?jo({flight:F,values:ne(_e).values},o.t):0,ce=Math.max(0,...F.arms.map((_e,ee)=>_e.compliant?1e3*Cg(_e,J.armLengths[ee],J.bends[ee]):0)),fe=Math.hypot(...[0,1,2].map(_e=>J.contacts.reduce((ee,$)=>ee+($?$.force[_e]:0),0)));[te("Velocity"),te("Acceleration"),ce,fe,J.thrust.reduce((_e,ee)=>_e+ee,0)].forEach((_e,ee)=>k[ee][z].textContent=ee===hv&&uv(F)?"rigid":lv(_e))})}function W(F){if(F.ctrlKey||F.metaKey||F.altKey||F.target.closest?.("dialog"))return;let z=F.target.tagName;if(z==="TEXTAREA"||z==="SELECT"||z==="INPUT"&&F.target.type!=="range"||F.target.type==="range"&&F.target!==m)return;let J=F.shiftKey?10:1,ne={" ":()=>o.playing?P():_(),ArrowRight:()=>w(J),ArrowLeft:()=>w(-J),Home:()=>(P(),d(o.line.begin)),End:()=>(P(),d(o.line.end)),",":()=>D(1),".":()=>D(-1),t:S,...s};if(F.key===" "&&z==="BUTTON")return;let te=ne[F.key];!te||!o.line||te()!==!1&&F.preventDefault()}document.addEventListener("keydown",W);function X({keepTime:F=!0}={}){o.flights=i.flights,o.line=Lg(o.flights),B(),e?.replace(o.flights),A();let z=xl(o.flights);d(F?o.t:z===null?o.line.begin:z-XE)}return E(),{replace:X,seek:d,play:_,pause:P,setPace:I,goToTouch:S,get time(){return o.t},get playing(){return o.playing},get pace(){return o.pace},dispose(){P(),document.removeEventListener("keydown",W),t.replaceChildren()}}}var fv={type:"change"},Nd={type:"start"},pv={type:"end"},Yh=new hr,dv=new Zn,YE=Math.cos(70*Xs.DEG2RAD),dn=new L,Qn=2*Math.PI,Nt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Ud=1e-6,$h=class extends ka{constructor(e,t=null){super(e,t),this.state=Nt.NONE,this.target=new L,this.cursor=new L,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hs.ROTATE,MIDDLE:Hs.DOLLY,RIGHT:Hs.PAN},this.touches={ONE:Vs.ROTATE,TWO:Vs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new L,this._lastQuaternion=new sn,this._lastTargetPosition=new L,this._quat=new sn().setFromUnitVectors(e.up,new L(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new yo,this._sphericalDelta=new yo,this._scale=1,this._panOffset=new L,this._rotateStart=new Oe,this._rotateEnd=new Oe,this._rotateDelta=new Oe,this._panStart=new Oe,this._panEnd=new Oe,this._panDelta=new Oe,this._dollyStart=new Oe,this._dollyEnd=new Oe,this._dollyDelta=new Oe,this._dollyDirection=new L,this._mouse=new Oe,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=ZE.bind(this),this._onPointerDown=$E.bind(this),this._onPointerUp=KE.bind(this),this._onContextMenu=iT.bind(this),this._onMouseWheel=QE.bind(this),this._onKeyDown=eT.bind(this),this._onTouchStart=tT.bind(this),this._onTouchMove=nT.bind(this),this._onMouseDown=JE.bind(this),this._onMouseMove=jE.bind(this),this._interceptControlDown=sT.bind(this),this._interceptControlUp=rT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(fv),this.update(),this.state=Nt.NONE}update(e=null){let t=this.object.position;dn.copy(t).sub(this.target),dn.applyQuaternion(this._quat),this._spherical.setFromVector3(dn),this.autoRotate&&this.state===Nt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Qn:n>Math.PI&&(n-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(dn.setFromSpherical(this._spherical),dn.applyQuaternion(this._quatInverse),t.copy(this.target).add(dn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=dn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new L(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new L(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=dn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Yh.origin.copy(this.object.position),Yh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Yh.direction))<YE?this.object.lookAt(this.target):(dv.setFromNormalAndCoplanarPoint(this.object.up,this.target),Yh.intersectPlane(dv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Ud||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Ud||this._lastTargetPosition.distanceToSquared(this.target)>Ud?(this.dispatchEvent(fv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Qn/60*this.autoRotateSpeed*e:Qn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){dn.setFromMatrixColumn(t,0),dn.multiplyScalar(-e),this._panOffset.add(dn)}_panUp(e,t){this.screenSpacePanning===!0?dn.setFromMatrixColumn(t,1):(dn.setFromMatrixColumn(t,0),dn.crossVectors(this.object.up,dn)),dn.multiplyScalar(e),this._panOffset.add(dn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;dn.copy(s).sub(this.target);let r=dn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Oe,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function $E(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function ZE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function KE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(pv),this.state=Nt.NONE;break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function JE(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Hs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Nt.DOLLY;break;case Hs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Nt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Nt.ROTATE}break;case Hs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Nt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Nt.PAN}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(Nd)}function jE(i){switch(this.state){case Nt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Nt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Nt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function QE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Nt.NONE||(i.preventDefault(),this.dispatchEvent(Nd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(pv))}function eT(i){this.enabled!==!1&&this._handleKeyDown(i)}function tT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Vs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Nt.TOUCH_ROTATE;break;case Vs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Nt.TOUCH_PAN;break;default:this.state=Nt.NONE}break;case 2:switch(this.touches.TWO){case Vs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Nt.TOUCH_DOLLY_PAN;break;case Vs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Nt.TOUCH_DOLLY_ROTATE;break;default:this.state=Nt.NONE}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(Nd)}function nT(i){switch(this._trackPointer(i),this.state){case Nt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Nt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Nt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Nt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Nt.NONE}}function iT(i){this.enabled!==!1&&i.preventDefault()}function sT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function rT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var oT=7,aT=.0022,lT=new L(1,0,0);function Fd(i,e=oT,t=aT){class n extends jn{getPoint(r,o=new L){let a=2*Math.PI*e*r;return o.set(r,i*Math.cos(a),i*Math.sin(a))}}return new Ia(new n,e*14,t,5)}function ki(i,e=14){return new wn(i,i,1,e).rotateZ(-Math.PI/2).translate(.5,0,0)}function Zh(i,e){return new je(new wn(.0155*i,.0155*i,.006*i,20).rotateZ(Math.PI/2),e)}function il(i,e,t){let n=t.clone().sub(e);return i.position.copy(e),i.quaternion.setFromUnitVectors(new L(1,0,0),n.normalize()),i}function mv(i,e){let t=new Ot;t.setAttribute("position",new Jt(Zt(i.vertices),3)),t.setIndex(new Jt(new Uint32Array(Zt(i.triangles)),1));let n=t.toNonIndexed();return n.computeVertexNormals(),new je(n,e)}var Kh=class{constructor(e,t,n){this.group=new _t;let s=new oi({color:e,depthTest:!1,transparent:!0,opacity:n});this.shaft=new je(ki(t,10),s),this.head=new je(new dr(3*t,8*t,14).rotateZ(-Math.PI/2),s),this.size=8*t,this.shaft.renderOrder=this.head.renderOrder=10,this.group.add(this.shaft,this.head),this.along=new L(1,0,0),this.way=new L}show(e,t){let n=this.way.set(...t).length();if(this.group.visible=n>1e-4,!this.group.visible)return;this.group.position.set(...e),this.group.quaternion.setFromUnitVectors(this.along,this.way.divideScalar(n));let s=Math.min(this.size,.6*n);this.head.scale.setScalar(s/this.size),this.head.position.x=n-.5*s,this.shaft.scale.x=Math.max(n-s,1e-5)}hide(){this.group.visible=!1}},en,vv,xv,_v,sl,yv,bv,Mv,wv,rl=class{constructor(e,t,n){gl(this,en);this.flight=e,this.group=new _t;let s=t.opacity<1,r=(v,p={})=>new Ni({color:v,roughness:.55,metalness:.15,transparent:s,opacity:t.opacity,depthWrite:!s,...p}),o=r(n.metal),a=r(n.dark),l=r(t.colour),c=r(n.force,{metalness:.4,roughness:.35}),u=Math.max(...e.arms.map(v=>v.length)),h=u/.19,f=new je(new wn(.042*h,.042*h,.026*h,28),a);f.rotation.x=Math.PI/2;let m=new je(new wn(.032*h,.04*h,.014*h,28),l);m.rotation.x=Math.PI/2,m.position.z=.02*h;let g=new je(new dr(.012*h,.034*h,16).rotateZ(-Math.PI/2),l);g.position.set(.056*h,0,.004*h),this.group.add(f,m,g),this.hulls=e.hull.map(v=>{let p=r(t.colour,{transparent:!0,opacity:.22*t.opacity,depthWrite:!1});if(v.meshes.length){for(let b of v.meshes)this.group.add(mv(b,p));return p}let d=new je(new Ca(v.radius,32,20),p);return d.position.set(...v.centre),this.group.add(d),p}),this.arms=e.arms.map(v=>Cn(this,en,vv).call(this,v,{metal:o,dark:a,own:l,spring:c,paint:r,colours:n,unit:h,faded:s,look:t})),this.springs=e.neighbours.map(({first:v,second:p})=>{let d=new je(Fd(.0075*h,16,.0014*h),c);return this.group.add(d),{coil:d,first:v,second:p,from:new L,to:new L,way:new L}}),this.open=new at(n.force),this.shut=new at(n.dark),this.rotors=e.rotors.map(v=>Cn(this,en,xv).call(this,v,{dark:a,paint:r,colours:n,unit:h,look:t})),this.most=e.max_thrust||1,this.bar=1.2*u}connections(){this.group.updateWorldMatrix(!0,!0);let e=this.group.parent?.position??new L,t=s=>s.getWorldPosition(new L).sub(e).toArray(),n=s=>s.localToWorld(new L(1,0,0)).sub(e).toArray();return{springs:this.springs.map(({coil:s})=>[t(s),n(s)]),latches:this.arms.flatMap(({latches:s})=>s??[]).map(({held:s,moving:r,glow:o})=>({held:t(s),moving:t(r),open:o.color.equals(this.open)}))}}ends(){this.group.updateWorldMatrix(!0,!0);let e=this.group.parent?.position??new L,t=n=>this.rotors[this.flight.rotors.findIndex(s=>s.arm===n)]?.rotor;return this.arms.map(({tip:n},s)=>({centre:n.getWorldPosition(new L).sub(e).toArray(),normal:new L(0,0,1).transformDirection(n.matrixWorld).toArray(),thrust:t(s)?new L(0,0,1).transformDirection(t(s).matrixWorld).toArray():null}))}show(e,t=1){this.group.position.set(...e.position);let[n,s,r,o]=e.quaternion;this.group.quaternion.set(s,r,o,n);let a=new Set(e.contacts.filter(Boolean).map(l=>l.part));this.arms.forEach((l,c)=>{let u=t===1?e.armLengths[c]:l.free-gv(t*(l.free-e.armLengths[c]),l),h=t===1?e.bends[c]??0:gv(t*(e.bends[c]??0),l);l.hung?l.path.at(u,l.end.position,l.end.quaternion,h):l.end.position.x=u,l.middle&&l.path.at(u,l.middle.position,l.middle.quaternion);for(let f of l.latches??[]){let m=f.isSecond?-(e.bends[c]??0):l.free-e.armLengths[c];f.glow.color.copy(m>f.travel?this.open:this.shut)}l.shown=u,l.bend=h,l.coil&&(l.coil.scale.x=Math.max(u-l.collar-l.seat,.004)),l.cagePaint.color.set(a.has(c)?this.flight.glow:this.flight.colour)}),this.rotors.forEach((l,c)=>{l.level&&l.rotor.quaternion.copy(l.level.end.quaternion).invert().multiply(l.aim),l.blades.rotation.z=l.spin*e.own*60;let u=this.bar*e.thrust[c]/this.most;l.thrust.visible=u>.001,l.thrust.scale.z=Math.max(u,.001)});for(let{coil:l,first:c,second:u,from:h,to:f,way:m}of this.springs){for(let[v,p]of[[c,h],[u,f]])this.arms[v].path.at(this.arms[v].shown,p,null,this.arms[v].bend);let g=m.copy(f).sub(h).length();l.position.copy(h),l.quaternion.setFromUnitVectors(lT,m.divideScalar(Math.max(g,1e-6))),l.scale.x=Math.max(g,1e-6)}this.hulls.forEach((l,c)=>{l.color.set(a.has(this.arms.length+c)?this.flight.glow:this.flight.colour)})}};en=new WeakSet,vv=function(e,{metal:t,dark:n,own:s,spring:r,paint:o,colours:a,unit:l,faded:c,look:u}){let h=new _t;this.group.add(h);let f=Math.atan2(e.direction[1],e.direction[0]),m=new _t;h.add(m);let g=new Co(e),v={end:m,frame:h,free:e.length,path:g,hung:e.joint.length>0},p=new _t,d={frame:h,end:m,metal:t,dark:n,own:s,spring:r,unit:l};v.hung?(p.rotation.z=f,e.compliant?g.second?v.middle=Cn(this,en,Mv).call(this,g,d):g.isHinge?Cn(this,en,bv).call(this,g,d):Object.assign(v,Cn(this,en,yv).call(this,e,g,d)):Cn(this,en,sl).call(this,g.start,.007,d),v.latches=e.latch.map(E=>Cn(this,en,wv).call(this,E,g,{...d,middle:v.middle,paint:o,colours:a}))):(h.rotation.z=f,Object.assign(v,Cn(this,en,_v).call(this,e,d))),m.add(p);let b=o(u.colour,{roughness:.4}),M=new je(new Pa(e.cage_radius-.0035*l,.0035*l,10,72),b);e.caged&&p.add(M);let _=o(u.colour,{transparent:!0,opacity:.22*u.opacity,depthWrite:!1}),P=new _t;P.rotation.z=-f;for(let E of e.hulls)P.add(mv(E,_));p.add(P);for(let E=0;E<(e.caged?3:0);E++){let I=new je(ki(.0016*l,6),t);I.rotation.z=2*Math.PI*(E+.5)/3,I.scale.x=e.cage_radius-.004*l,p.add(I)}return Object.assign(v,{cagePaint:b,tip:p,seat:P})},xv=function({arm:e,offset:t,axis:n,level:s,spin:r,radius:o},{dark:a,paint:l,colours:c,unit:u,look:h}){let f=new _t;f.position.set(...t);let m=new sn().setFromUnitVectors(new L(0,0,1),new L(...n));f.quaternion.copy(m),(e<0?this.group:this.arms[e].seat).add(f);let g=new je(new wn(.013*u,.013*u,.024*u,18).rotateX(Math.PI/2),a);g.position.z=.008*u;let v=new je(new fr(o,36),l(c.thrust,{transparent:!0,opacity:.16*h.opacity,side:Sn,depthWrite:!1}));v.position.z=.022*u;let p=new je(new ji(2*o,.012*u,.0015),a);p.position.z=.023*u;let d=new je(new wn(.006*u,.006*u,1,12).rotateX(Math.PI/2).translate(0,0,.5),l(c.thrust,{transparent:!0,opacity:.8*h.opacity,emissive:c.thrust,emissiveIntensity:.3}));return d.position.z=.024*u,f.add(g,v,p,d),{rotor:f,blades:p,thrust:d,spin:r,aim:m,level:s?this.arms[e]:null}},_v=function(e,{frame:t,end:n,metal:s,dark:r,own:o,spring:a,unit:l}){let c=e.length-e.shortest,u=.13*e.length;if(!e.compliant){let d=new je(ki(.007*l),s);return d.scale.x=e.length,t.add(d),{}}let h=Math.max(.24*e.length,e.shortest-u-.8*c),f=new je(ki(.0075*l),s);f.scale.x=e.shortest-.5*u;let m=new je(ki(.0045*l),o);m.position.x=-(e.length-h)+.3*u,m.scale.x=-m.position.x;let g=Zh(l,r);g.position.x=h;let v=Zh(l,r);v.position.x=-u;let p=new je(Fd(.0125*l),a);return p.position.x=h,t.add(f,g,p),n.add(m,v),{coil:p,seat:h,collar:u}},sl=function(e,t,{frame:n,metal:s,unit:r}){let o=new je(ki(t*r),s);o.scale.x=Math.max(e.length(),1e-6),n.add(il(o,new L,e))},yv=function(e,t,{frame:n,end:s,metal:r,dark:o,own:a,spring:l,unit:c}){let u=.13*t.start.length(),h=t.start.distanceTo(t.anchor),f=e.length-e.shortest,m=il(new _t,t.anchor,t.start),g=new je(ki(.0075*c),r);g.scale.x=Math.max(h-f-.5*u,1e-6);let v=new je(Fd(.0125*c),l);m.add(g,Zh(c,o),v);let p=new _t;p.quaternion.copy(m.quaternion);let d=new je(ki(.0045*c),a);d.position.x=-h+.3*u,d.scale.x=-d.position.x;let b=Zh(c,o);return b.position.x=-u,p.add(d,b),n.add(m),s.add(p),Cn(this,en,sl).call(this,t.anchor,.0075,{frame:n,metal:r,unit:c}),{coil:v,seat:e.length-h,collar:u}},bv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,unit:a}){Cn(this,en,sl).call(this,e.anchor,.0075,{frame:t,metal:s,unit:a});let l=new je(new wn(.0105*a,.0105*a,.028*a,20),r);l.quaternion.setFromUnitVectors(new L(0,1,0),e.axis.clone().normalize()),l.position.copy(e.anchor),t.add(l);let c=new je(ki(.006*a),o),u=e.anchor.clone().sub(e.start);c.scale.x=u.length(),n.add(il(c,new L,u))},Mv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,unit:a}){let l=new _t;t.add(l);let c=(v,p,d)=>{let b=new je(new wn(.0105*a,.0105*a,.028*a,20),r);b.quaternion.setFromUnitVectors(new L(0,1,0),v.axis.clone().normalize()),b.position.copy(d),p.add(b)},u=e.second,h=e.isHinge?e.anchor:new L;e.isHinge&&(Cn(this,en,sl).call(this,e.anchor,.0075,{frame:t,metal:s,unit:a}),c(e,t,e.anchor));let f=e.anchor.clone().sub(e.start),m=u.isHinge?u.anchor.clone().sub(e.start):new L;u.isHinge&&c(u,l,m);let g=(v,p,d)=>{let b=new je(ki(.006*a),o);b.scale.x=Math.max(v.distanceTo(p),1e-6),d.add(il(b,v,p))};return e.isHinge?g(f,m,l):g(h,e.start.clone().add(m),t),u.isHinge&&g(new L,m,n),l},wv=function(e,t,{frame:n,end:s,middle:r,metal:o,unit:a,paint:l,colours:c}){let u=e.joint===1,h=u?t.second:t,[f,m]=u?[r??n,s]:[n,r??s],g=f===n?new L:t.start,v=new L(...e.face),p=.006*a,d=l(c.dark),b=()=>{let w=(h.isHinge?.011:.019)*a,S=new wn(w,w,p,20);return new je(S.rotateZ(-Math.PI/2),d)},M=h.along.clone().normalize(),_=new sn().setFromUnitVectors(new L(1,0,0),M),[P,E]=[b(),b()];P.quaternion.copy(_),E.quaternion.copy(_),P.position.copy(v).addScaledVector(M,1.1*p).sub(g),E.position.copy(v).sub(t.start);let I=new je(ki(.0028*a,8),o),D=h.anchor.clone().addScaledVector(M,h.isHinge?p:0).sub(g);return I.scale.x=Math.max(D.distanceTo(P.position),1e-6),f.add(P,il(I,D,P.position)),m.add(E),{glow:d,held:P,moving:E,travel:e.travel,isSecond:u}};function gv(i,e){let t=.4*e.free;return Math.min(e.hung?Math.max(i,-t):i,t)}function ol(i){i.traverse(e=>{e.geometry?.dispose();for(let t of[e.material].flat())t?.map?.dispose(),t?.dispose?.()}),i.removeFromParent()}var Sv=new an,Jh=new L,ko=class extends Oa{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new mt(e,3)),this.setAttribute("uv",new mt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ks(t,6,1);return this.setAttribute("instanceStart",new Jn(n,3,0)),this.setAttribute("instanceEnd",new Jn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ks(t,6,1);return this.setAttribute("instanceColorStart",new Jn(n,3,0)),this.setAttribute("instanceColorEnd",new Jn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new La(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new an);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Sv.setFromBufferAttribute(t),this.boundingBox.union(Sv))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Jh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Jh)),Jh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Jh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};De.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Oe(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Xn.line={uniforms:Ya.merge([De.common,De.fog,De.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		void trimSegment( const in vec4 start, inout vec4 end ) {

			// trim end segment so it terminates between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column
			float nearEstimate = - 0.5 * b / a;

			float alpha = ( nearEstimate - start.z ) / ( end.z - start.z );

			end.xyz = mix( start.xyz, end.xyz, alpha );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? dashScale * instanceDistanceStart : dashScale * instanceDistanceEnd;
				vUv = uv;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					trimSegment( start, end );

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					trimSegment( end, start );

				}

			}

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = normalize( mix( start.xyz, end.xyz, 0.5 ) );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;
				clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				// Find the closest points on the view ray and the line segment
				vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
				vec3 lineDir = worldEnd - worldStart;
				vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

				vec3 p1 = worldStart + lineDir * params.x;
				vec3 p2 = rayEnd * params.y;
				vec3 delta = p1 - p2;
				float len = length( delta );
				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var $s=class extends ai{constructor(e){super({type:"LineMaterial",uniforms:Ya.clone(Xn.line.uniforms),vertexShader:Xn.line.vertexShader,fragmentShader:Xn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Od=new It,Ev=new L,Tv=new L,En=new It,Tn=new It,ns=new It,Bd=new L,zd=new Ut,An=new Ba,Av=new L,jh=new an,Qh=new Di,is=new It,ss,Pr;function Rv(i,e,t){return is.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),is.multiplyScalar(1/is.w),is.x=Pr/t.width,is.y=Pr/t.height,is.applyMatrix4(i.projectionMatrixInverse),is.multiplyScalar(1/is.w),Math.abs(Math.max(is.x,is.y))}function cT(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){An.start.fromBufferAttribute(s,a),An.end.fromBufferAttribute(r,a),An.applyMatrix4(t);let c=new L,u=new L;ss.distanceSqToSegment(An.start,An.end,u,c),u.distanceTo(c)<Pr*.5&&e.push({point:u,pointOnLine:c,distance:ss.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function hT(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;ss.at(1,ns),ns.w=1,ns.applyMatrix4(e.matrixWorldInverse),ns.applyMatrix4(n),ns.multiplyScalar(1/ns.w),ns.x*=r.x/2,ns.y*=r.y/2,ns.z=0,Bd.copy(ns),zd.multiplyMatrices(e.matrixWorldInverse,o);for(let f=0,m=u;f<m;f++){if(En.fromBufferAttribute(l,f),Tn.fromBufferAttribute(c,f),En.w=1,Tn.w=1,En.applyMatrix4(zd),Tn.applyMatrix4(zd),En.z>h&&Tn.z>h)continue;if(En.z>h){let M=En.z-Tn.z,_=(En.z-h)/M;En.lerp(Tn,_)}else if(Tn.z>h){let M=Tn.z-En.z,_=(Tn.z-h)/M;Tn.lerp(En,_)}En.applyMatrix4(n),Tn.applyMatrix4(n),En.multiplyScalar(1/En.w),Tn.multiplyScalar(1/Tn.w),En.x*=r.x/2,En.y*=r.y/2,Tn.x*=r.x/2,Tn.y*=r.y/2,An.start.copy(En),An.start.z=0,An.end.copy(Tn),An.end.z=0;let v=An.closestPointToPointParameter(Bd,!0);An.at(v,Av);let p=Xs.lerp(En.z,Tn.z,v),d=p>=-1&&p<=1,b=Bd.distanceTo(Av)<Pr*.5;if(d&&b){An.start.fromBufferAttribute(l,f),An.end.fromBufferAttribute(c,f),An.start.applyMatrix4(o),An.end.applyMatrix4(o);let M=new L,_=new L;ss.distanceSqToSegment(An.start,An.end,_,M),t.push({point:_,pointOnLine:M,distance:ss.origin.distanceTo(_),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var eu=class extends je{constructor(e=new ko,t=new $s({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Ev.fromBufferAttribute(t,o),Tv.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Ev.distanceTo(Tv);let r=new ks(s,2,1);return e.setAttribute("instanceDistanceStart",new Jn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Jn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;ss=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Pr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Qh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Pr*.5;else{let h=Math.max(s.near,Qh.distanceToPoint(ss.origin));c=Rv(s,h,l.resolution)}if(Qh.radius+=c,ss.intersectsSphere(Qh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),jh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Pr*.5;else{let h=Math.max(s.near,jh.distanceToPoint(ss.origin));u=Rv(s,h,l.resolution)}jh.expandByScalar(u),ss.intersectsBox(jh)!==!1&&(n?cT(this,t):hT(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Od),this.material.uniforms.resolution.value.set(Od.z,Od.w))}};var Ho=class extends ko{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setPositions(n),this}setColors(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setColors(n),this}setFromPoints(e){let t=e.length-1,n=new Float32Array(6*t);for(let s=0;s<t;s++)n[6*s]=e[s].x,n[6*s+1]=e[s].y,n[6*s+2]=e[s].z||0,n[6*s+3]=e[s+1].x,n[6*s+4]=e[s+1].y,n[6*s+5]=e[s+1].z||0;return super.setPositions(n),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var tu=class extends eu{constructor(e=new Ho,t=new $s({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};function Cv(i,e=Math.PI/3){let t=Math.cos(e),n=(1+1e-10)*100,s=[new L,new L,new L],r=new L,o=new L,a=new L,l=new L;function c(v){let p=~~(v.x*n),d=~~(v.y*n),b=~~(v.z*n);return`${p},${d},${b}`}let u=i.index?i.toNonIndexed():i,h=u.attributes.position,f={};for(let v=0,p=h.count/3;v<p;v++){let d=3*v,b=s[0].fromBufferAttribute(h,d+0),M=s[1].fromBufferAttribute(h,d+1),_=s[2].fromBufferAttribute(h,d+2);r.subVectors(_,M),o.subVectors(b,M);let P=new L().crossVectors(r,o).normalize();for(let E=0;E<3;E++){let I=s[E],D=c(I);D in f||(f[D]=[]),f[D].push(P)}}let m=new Float32Array(h.count*3),g=new Jt(m,3,!1);for(let v=0,p=h.count/3;v<p;v++){let d=3*v,b=s[0].fromBufferAttribute(h,d+0),M=s[1].fromBufferAttribute(h,d+1),_=s[2].fromBufferAttribute(h,d+2);r.subVectors(_,M),o.subVectors(b,M),a.crossVectors(r,o).normalize();for(let P=0;P<3;P++){let E=s[P],I=c(E),D=f[I];l.set(0,0,0);for(let w=0,S=D.length;w<S;w++){let A=D[w];a.dot(A)>t&&l.add(A)}l.normalize(),g.setXYZ(d+P,l.x,l.y,l.z)}}return u.setAttribute("normal",g),u}var uT=.6,fT=25,dT=.02,Pv=.004,Nn=i=>new L(...i);function Iv(i,e,t,n,s,r){let o=[],a=e.length(),l=t.length(),c=e.clone().normalize(),u=t.clone().normalize(),h=(v,p)=>o.push(...v.toArray(),...p.toArray()),f=(v,p)=>i.clone().addScaledVector(c,v).addScaledVector(u,p),m=v=>{let p=[-v,v];for(let d=Math.ceil(-v/n)*n;d<v;d+=n)p.push(d);return p};for(let v of m(a))h(f(v,-l),f(v,l));for(let v of m(l))h(f(-a,v),f(a,v));let g=new Ot;return g.setAttribute("position",new mt(o,3)),new _o(g,new vs({color:s,transparent:!0,opacity:r,depthWrite:!1}))}function nu(i,e,t,n,s=0){let r=Nn(i.across),o=Nn(i.along),a=Nn(i.normal),l=new ji(2*r.length(),2*o.length(),e),c=new Ni({color:t,transparent:!0,opacity:n,roughness:.9,depthWrite:!1,side:Sn}),u=new je(l,c),h=new Ut().makeBasis(r.normalize(),o.normalize(),a);return u.quaternion.setFromRotationMatrix(h),u.position.copy(Nn(i.centre)).addScaledVector(a,-s-.5*e),u.renderOrder=1,u}function pT(i,e){let t=new Ot;t.setAttribute("position",new Jt(Zt(i.vertices),3)),t.setAttribute("normal",new Jt(Zt(i.normals),3)),t.setIndex(Array.from(Zt(i.triangles)));let n=new je(t,new oi({colorWrite:!1,transparent:!0,side:Sn})),s=new je(t,new Ni({color:e,transparent:!0,opacity:.55,roughness:.85,depthWrite:!1,side:Sn}));return[n,s].forEach((r,o)=>r.renderOrder=3+o),new _t().add(n,s)}function mT(i,e,t,n){let s=Lv(i),r=Cv(s,uT),o=n===null?[]:[new Zn(new L(0,0,1),-n)],a=new je(r,new oi({colorWrite:!1,transparent:!0,clippingPlanes:o})),l=new je(r,new Ni({color:t,transparent:!0,opacity:.72,roughness:.85,depthWrite:!1,clippingPlanes:o,stencilWrite:!0,stencilRef:1,stencilFunc:Mh,stencilZPass:bh})),c=new _o(new Ea(s,fT),new vs({color:e.ink,transparent:!0,opacity:.35,depthWrite:!1,clippingPlanes:o}));return s.dispose(),[a,l,c].forEach((u,h)=>u.renderOrder=3+h),new _t().add(a,l,c)}function Lv(i){let e=new Ot;return e.setAttribute("position",new Jt(Zt(i.vertices),3)),e.setIndex(Array.from(Zt(i.triangles))),e}var ou=i=>i.kind==="mesh"?`${i.name}${i.track<0?"":", moving"}`:i.kind;function Dv(i,e){let t=[...new Set(i.map(ou))],n=t.filter(r=>r!=="mat"&&r!=="ground");n.sort((r,o)=>(o==="wall")-(r==="wall"));let s=r=>n.includes(r)?e.shapes[n.indexOf(r)%e.shapes.length]:e[r];return new Map(t.map(r=>[r,s(r)]))}function Uv(i,e,t){if(i.kind!=="mesh"||i.normals)return null;let n=Lv(i);if(n.computeBoundingBox(),n.boundingBox.min.z<e-dT&&(t===null||n.boundingBox.max.z<=e))return null;let s=new oi({color:"#000000",transparent:!0,opacity:.14,depthWrite:!1,side:Sn,stencilWrite:!0,stencilRef:2,stencilFunc:Mh,stencilZPass:bh}),r=new je(n,s);return r.renderOrder=2,r.frustumCulled=!1,r}function Nv(i,e){let t=new _t().add(e);return t.scale.z=0,t.position.z=i+.002,t}function Fv(i,e,t){let n=Uv(i,e,t);return n&&Nv(e,n)}function kd(i,e,t,n=null){let s=new _t,r=t.get(ou(i))??e.wall;if(i.kind==="mesh")return i.normals?s.add(pT(i,r)):mT(i,e,r,n);let o=Nn(i.centre),a=Nn(i.normal).multiplyScalar(.001),l=(c,u,h)=>Iv(o.clone().add(a),Nn(i.across),Nn(i.along),h,u,c);return i.kind==="ground"?s.add(nu(i,.004,e.ground,.35),l(.55,e.faint,.25)):i.kind==="mat"?(s.add(nu(i,i.thickness,e.mat,.2),l(.55,e.mat,.1)),s.add(nu(i,.04,e.wall,.25,i.thickness))):s.add(nu(i,.04,r,.22),l(.5,r,.1)),s}var iu=class{constructor(e,t,n,s,r,o){this.origin=Nn(e.origin),this.body=new _t().add(...t.map(c=>kd(c,n,s,r)));let a=t.map(c=>Uv(c,o,r)).filter(Boolean);if(this.shadow=new _t,a.length&&this.shadow.add(...a),this.group=new _t().add(this.body,Nv(o,this.shadow)),this.turn=new sn,this.rod=null,!e.rod.length)return;this.pivot=Nn(e.rod);let l=new wn(Pv,Pv,1,10).translate(0,.5,0);this.rod=new je(l,new Ni({color:n.metal,roughness:.6})),this.rod.position.copy(this.pivot),this.group.add(this.rod)}show(e){let[t,n,s,r]=e.quaternion;if(this.turn.set(n,s,r,t),this.body.quaternion.copy(this.turn),this.body.position.copy(this.origin).negate().applyQuaternion(this.turn).add(Nn(e.position)),this.shadow.quaternion.copy(this.body.quaternion),this.shadow.position.copy(this.body.position),!this.rod)return;let o=Nn(e.position).sub(this.pivot);this.rod.scale.y=o.length(),this.rod.quaternion.setFromUnitVectors(new L(0,1,0),o.normalize())}};function Ov(i,e){let t=i.getSize(new L),n=i.getCenter(new L);n.z=i.min.z;let s=r=>Math.max(.8,Math.ceil((.5*r+.4)*4)/4);return Iv(n,new L(s(t.x),0,0),new L(0,s(t.y),0),.25,e.faint,.35)}function Bv(i,e){let t=Nn(i.guide).normalize(),n=[];for(let c=0;c<i.n;c+=Math.max(1,Math.floor(i.n/200)))n.push(t.dot(Nn(i.position.subarray(3*c,3*c+3))));let s=Math.min(...n)-.5,r=Math.max(...n)+.5-s,o=new wn(.008,.008,r,12).rotateZ(-Math.PI/2).translate(r/2,0,0),a=new je(o,new Ni({color:e.metal,transparent:!0,opacity:.5}));a.quaternion.setFromUnitVectors(new L(1,0,0),t);let l=Nn(i.position.subarray(0,3));return a.position.copy(l).addScaledVector(t,s-t.dot(l)),a}var su=class{constructor(e,t,n){let s=e.impacts,r=s.length?s[0][0]:1/0,o=[],a=[],l=new at(t.before),c=new at(t.force),u=new at(e.colour);this.times=[];let h=-1/0;for(let m=0;m<e.n;m++){let g=e.t[m];if(g-h<.001&&m<e.n-1)continue;h=g,this.times.push(g),o.push(...e.position.subarray(3*m,3*m+3));let v=s.some(([p,d])=>g>=p&&g<=d);a.push(...(v?c:g<r?l:u).toArray())}let f=(m,g)=>{let v=new Ho;v.setPositions(o),v.setColors(a);let p=new $s({vertexColors:!0,linewidth:g,transparent:!0,opacity:m,depthWrite:!1});p.resolution.copy(n);let d=new tu(v,p);return d.computeLineDistances(),d};this.whole=f(.3,1.2),this.flown=f(1,2.6),this.group=new _t,this.group.add(this.whole,this.flown)}show(e){let t=0,n=this.times.length;for(;t<n;){let s=t+n>>1;this.times[s]<=e?t=s+1:n=s}this.flown.geometry.instanceCount=Math.max(t-1,0)}resize(e){this.whole.material.resolution.copy(e),this.flown.material.resolution.copy(e)}},ru=class{constructor(e,t,n){this.level=t,this.group=new _t,this.paths=e.arms.map(a=>new Co(a));let s=()=>new oi({color:"#000000",transparent:!0,opacity:.16,depthWrite:!1}),r=a=>{let l=new je(new fr(a,36),s());return l.renderOrder=2,this.group.add(l),l};this.body=r(.045),this.cages=e.arms.map(a=>r(a.cage_radius));let o=new Ot;o.setAttribute("position",new mt([0,0,0,0,0,1],3)),this.plumb=new ur(o,new vs({color:n.faint,transparent:!0,opacity:.6})),this.group.add(this.plumb),this.turn=new sn,this.at=new L}show(e){let[t,n,s,r]=e.quaternion;this.turn.set(n,s,r,t);let o=this.level+.003;this.body.position.set(e.position[0],e.position[1],o),this.cages.forEach((a,l)=>{this.paths[l].at(e.armLengths[l],this.at,null,e.bends[l]),this.at.applyQuaternion(this.turn),a.position.set(e.position[0]+this.at.x,e.position[1]+this.at.y,o)}),this.plumb.position.set(e.position[0],e.position[1],o),this.plumb.scale.z=Math.max(e.position[2]-o,1e-4)}};function gT(i,e){let t=document.createElement("canvas");t.width=128,t.height=64;let n=t.getContext("2d");n.font="600 40px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle=e,n.fillText(i,64,32);let s=new Ma(t);s.colorSpace=Gn;let r=new ba(new vo({map:s,depthTest:!1,transparent:!0}));return r.scale.set(.9,.45,1),r}function zv(i){let e=new _t;return Object.entries({"x N":[1,0,0],"y W":[0,1,0],"z up":[0,0,1]}).forEach(([n,s])=>{let r=new za(Nn(s),new L,1,i.ink,.28,.16),o=gT(n,i.ink);o.position.set(...s).multiplyScalar(1.38),e.add(r,o)}),e}var vT=(i,e)=>i.map((t,n)=>t+e[n]),kv=(i,e)=>i.kind==="mesh"?{...i,moved:e}:{...i,centre:vT(i.centre,e)},al=(i,e)=>i.reduce((t,n,s)=>t+n*e[s],0);function Hv(i){let e=new Map;for(let t of i){let n=t.kind!=="mesh",s=n?[t.kind,t.thickness,...t.normal,al(t.normal,t.centre)].map(o=>o.toFixed?o.toFixed(4):o).join():`${t.name} ${t.key} ${t.moved}`,r=e.get(s);e.set(s,r?n?_T(r,t):xT(r,t):t)}return[...e.values()]}function xT(i,e){let[t,n]=[i,e].map(s=>{let r=new an().setFromArray(Zt(s.vertices));return s.triangles.shape[0]+.01*r.getSize(new L).length()});return n>t?e:i}function _T(i,e){let t={...i,centre:i.centre.slice()};for(let n of["across","along"]){let s=Math.hypot(...i[n]),r=i[n].map(u=>u/s),o=Math.abs(al(r,e.across))+Math.abs(al(r,e.along)),a=al(r,e.centre)-al(r,i.centre),l=Math.min(-s,a-o),c=Math.max(s,a+o);t[n]=r.map(u=>u*(c-l)/2),t.centre=t.centre.map((u,h)=>u+r[h]*(l+c)/2)}return t}var Vv=.22,yT=.2,bT=2.5,MT=1,wT=.005,ST=["follow","front","side","top"],Vo=["follow","free","front","side","top","impact"],Gv=100,Wv=.4,Xv=400,qv=i=>Math.max(...i.arms.map(e=>Rg(e)+e.cage_radius));function Hd(i,e,t=!0){let n=i.map(Tp),s=e.robots;n.forEach((a,l)=>{let c=!a.arms.some(u=>u.compliant);a.colour=n.length>1?s[l%s.length]:s[c?1:0],a.glow=e.force,a.index=l,a.shift=0});let r=n.map(Cs),o=r.find(a=>a!==null);return r.forEach((a,l)=>{t&&a!==null&&Math.abs(o-a)>wT&&(n[l].shift=o-a)}),n}function au(i,{flights:e=[],compare:t="side",align:n=!0,onCamera:s=()=>{},onDrawn:r=()=>{}}={}){let o={compare:t,align:n,magnified:1,camera:"follow",t:0,all:[],hidden:new Set,flights:[],forces:!0,path:!0,estimate:!1,share:1},a=Pn();i.classList.add("picture");let l=document.createElement("div");l.className="force-labels";let c=document.createElement("div");c.className="scene-legend";let u=null;try{u=new Ah({antialias:!0,alpha:!1,stencil:!0,powerPreference:"high-performance"})}catch{let j=document.createElement("p");j.className="no-graphics",j.textContent="This browser cannot draw 3-D graphics (WebGL is off); plots and numbers work.",i.append(j)}let h=new mo,f=new Dn(38,1,.02,80);f.up.set(0,0,1);let m=new mo,g=new mr(-1.9,1.9,1.9,-1.9,.1,20);g.up.set(0,0,1);let v=new Na("#ffffff","#9aa4b0",2.1),p=new Fa("#ffffff",2);p.position.set(-2,-3,5),h.add(v,p);let d=null,b=new _t,M=[],_=0,P=0,E=-1/0,I=0,D=0,w=new Oe(1,1);if(u){u.localClippingEnabled=!0,i.append(u.domElement,l,c),u.domElement.setAttribute("role","img"),u.domElement.setAttribute("aria-label","The flight in three dimensions, with numbers beside it."),d=new $h(f,u.domElement),d.enableDamping=!1,d.minDistance=.15,d.maxDistance=30,d.addEventListener("change",S);let j=!1;d.addEventListener("start",()=>j=!0),d.addEventListener("end",()=>j=!1),d.addEventListener("change",()=>{j&&o.camera!=="follow"&&s("")})}function S(){!u||_||(P=performance.now(),_=requestAnimationFrame(B))}function A(){let j=performance.now(),he=P-E<Xv;E=j,clearTimeout(I),he&&(D=.7*D+.3*(j-P)),D>Gv&&o.share>Wv&&(o.share=Math.max(Wv,.7*o.share),D=.5*Gv),k(he?o.share:1),he&&o.share<1&&(I=setTimeout(S,Xv))}function k(j){let he=Math.min(devicePixelRatio||1,2)*j;Math.abs(u.getPixelRatio()-he)>.001&&u.setPixelRatio(he)}function B(){_=0,!(!u||!i.clientWidth||!i.clientHeight)&&(A(),V(),r())}function V(){let j=i.clientWidth,he=i.clientHeight;u.setViewport(0,0,j,he),u.setScissorTest(!1),u.setClearColor(a.background,1),u.render(h,f);let Se=Math.min(104,.24*Math.min(j,he));g.position.copy(f.position).sub(d.target).setLength(6),g.up.copy(f.up),g.lookAt(0,0,0),u.autoClear=!1,u.clearDepth(),u.setViewport(6,6,Se,Se),u.render(m,g),u.autoClear=!0,ee(j,he)}function W(){let j=o.flights[0].obstacles.find(Se=>Se.kind==="wall"||Se.kind==="mat"),he=j&&Math.abs(j.normal[2])<.9?new L(...j.across).normalize():new L(0,1,0);return he.y<0?he.negate():he}let X=()=>W().applyAxisAngle(f.up,-Math.PI/2);function F(j){let he=new L,[Se,C]=[1/0,-1/0];for(let y of o.flights.flatMap(N=>N.obstacles)){if(y.kind!=="mesh"||y.normals)continue;let N=Zt(y.vertices);for(let q=0;q<N.length;q+=3){let oe=he.fromArray(N,q).dot(j);[Se,C]=[Math.min(Se,oe),Math.max(C,oe)]}}return Math.max(0,C-Se)}let z=()=>[...new Set(o.flights.map(j=>j.world))];function J(j){let he=o.flights.filter(N=>o.flights.some(q=>q!==N&&q.world===N.world)),Se=new L,[C,y]=[1/0,-1/0];for(let{position:N}of he)for(let q=0;q<N.length;q+=3){let oe=Se.fromArray(N,q).dot(j);[C,y]=[Math.min(C,oe),Math.max(y,oe)]}return Math.max(0,y-C)}let ne=()=>z().length>1&&F(W())>bT?"ghost":o.compare;function te(){if(ne()!=="side")return o.flights.map(()=>[0,0,0]);let j=W(),he=Math.max(...o.flights.map(qv)),Se=Math.max(2*he+J(j),F(j))+yT,C=z(),y=.5*(C.length-1);return o.flights.map(({world:N})=>j.clone().multiplyScalar((y-C.indexOf(N))*Se).toArray())}function ce(j,{keepCamera:he=!0}={}){a=Pn(),o.all=Hd(j,a,o.align),o.flights=o.all.filter((Se,C)=>!o.hidden.has(C)),u&&fe(),he||dt(o.camera),ve(o.t)}function fe(){ol(b),b=new _t,h.add(b),m.children.slice().forEach(ol),m.add(zv(a)),l.replaceChildren();let j=te(),he=new an,Se=Math.max(...o.flights.map(Eu),0),C=Se>0?Vv/Tu(Se):0;o.floor=ye(j),M=o.flights.map((q,oe)=>{let se=new _t;se.position.set(...j[oe]),b.add(se);let Ue=q.world!==z()[0]&&ne()==="ghost",xe=new rl(q,{colour:q.colour,opacity:Ue?.35:1},a),Fe=new su(q,a,w),Be=q.part.map(()=>new Kh(a.force,.007,Ue?.4:.95)),ge=new ru(q,o.floor,a);ge.group.visible=!Ue||o.flights.length===2;let Ce=Hr(q)?new rl(q,{colour:a.ink,opacity:.35},a):null;Ce&&se.add(Ce.group),se.add(xe.group,Fe.group,ge.group,...Be.map(Ze=>Ze.group)),q.guide.length&&se.add(Bv(q,a));let qe=new an,Ye=Math.max(1,Math.floor(q.n/400));for(let Ze=0;Ze<q.n;Ze+=Ye)qe.expandByPoint(new L(...q.position.subarray(3*Ze,3*Ze+3)));he.union(qe.translate(se.position));let Le=q.part.map(()=>{let Ze=document.createElement("span");return l.append(Ze),Ze});return{flight:q,group:se,robot:xe,estimate:Ce,path:Fe,arrows:Be,shadow:ge,scale:C,names:Le,ghost:Ue,contacts:[],movers:[]}});let y=o.flights.flatMap((q,oe)=>q.obstacles.filter(se=>se.track<0).map(se=>kv(se,j[oe]))),N=y.some(q=>q.kind==="ground")?o.floor:null;o.shadows=[],o.shades=Dv(o.flights.flatMap(q=>q.obstacles),a),Hv(y).forEach(q=>{let oe=Fv(q,o.floor,N);oe&&o.shadows.push(oe);for(let se of[kd(q,a,o.shades,N),oe])se&&(se.position.add(new L(...q.moved??[0,0,0])),b.add(se))}),M.forEach(q=>{q.movers=q.flight.bodies.map((oe,se)=>new iu(oe,q.flight.obstacles.filter(Ue=>Ue.track===se),a,o.shades,N,o.floor));for(let oe of q.movers)q.group.add(oe.group)}),o.box=he.clone(),N===null&&(he.min.z=o.floor,b.add(Ov(he,a))),_e()}function ye(){let j=Math.max(...o.flights.flatMap(Se=>Se.obstacles.filter(C=>C.kind==="ground").map(C=>C.centre[2])));if(Number.isFinite(j))return j;let he=1/0;for(let Se of o.flights)for(let C=2;C<3*Se.n;C+=3)he=Math.min(he,Se.position[C]);return he-.45}function _e(){let j=Math.max(...o.flights.map(Eu),0);c.replaceChildren();let he=(C,y)=>{let N=document.createElement("span");N.className=`key ${C}`,N.textContent=y,c.append(N)};if(o.flights.length>1&&o.flights.forEach(C=>{he("robot",C.label),c.lastChild.style.setProperty("--colour",C.colour)}),o.estimate&&o.flights.some(Hr)&&he("estimate","estimated pose"),j>0&&o.forces){let C=Tu(j);he("force",`contact force, each at its point, ${C} N is ${100*Vv} cm`)}o.flights.some(C=>C.thrust.some(y=>y>0))&&he("thrust","thrust");let Se=new Set(o.flights.flatMap(C=>C.obstacles.map(ou)));ne()!==o.compare&&he("words","overlaid: the obstacles are too wide to be put side by side"),o.magnified!==1&&he("travel",`arm travel × ${o.magnified}, not to scale`);for(let C of Se)he("obstacle",C),c.lastChild.style.setProperty("--colour",o.shades?.get(C)??a.wall)}function ee(j,he){let Se=new L,C=[];for(let y of M)y.names.forEach((N,q)=>{let oe=y.contacts[q];if(N.hidden=y.ghost||!o.forces||!oe||oe.size<.5,N.hidden)return;Se.set(...oe.point).addScaledVector(new L(...oe.force),y.scale),Se.add(y.group.position).project(f),N.hidden=Se.z>1||Math.abs(Se.x)>1||Math.abs(Se.y)>1,N.textContent=`${oe.size.toFixed(oe.size<10?1:0)} N`;let se=Math.min(Math.max((Se.x+1)/2*j,24),j-24),Ue=Math.min(Math.max((1-Se.y)/2*he-12,10),he-10);N.hidden=C.some(([xe,Fe])=>Math.abs(xe-se)<50&&Math.abs(Fe-Ue)<18),!N.hidden&&(C.push([se,Ue]),N.style.transform=`translate(${se}px, ${Ue}px) translate(-50%, -50%)`)})}let $=null;function me(){let j=M.map(he=>he.robot.group.position.clone().add(he.group.position));return j.reduce((he,Se)=>he.add(Se),new L).divideScalar(j.length||1)}function ve(j){if(o.t=j,o.poses=o.flights.map(he=>Jo(he,j)),M.forEach((he,Se)=>{let C=o.poses[Se];he.robot.show(C,o.magnified),he.path.group.visible=o.path,he.path.show(C.own),he.estimate&&(he.estimate.group.visible=o.estimate,o.estimate&&he.estimate.show(Su(he.flight,j),o.magnified)),he.shadow.show(C),he.movers.forEach((y,N)=>y.show(C.bodies[N])),he.contacts=C.contacts,he.arrows.forEach((y,N)=>{let q=C.contacts[N];q&&o.forces?y.show(q.point,q.force.map(oe=>he.scale*oe)):y.hide()})}),u&&M.length&&ST.includes(o.camera)){let he=me();if($){let Se=he.clone().sub($);f.position.add(Se),d.target.add(Se)}$=he,d.update()}S()}function be(j){let he=Xs.degToRad(f.fov/2),Se=Math.min(1,f.aspect);return j/Math.sin(Math.atan(Math.tan(he)*Se))}function Ge(j,he){d.target.copy(j),f.position.copy(j).add(he),d.update()}function dt(j){if(o.camera=Vo.includes(j)?j:"follow",$=null,s(o.camera),!u||!M.length)return;let he=Math.max(...o.flights.map(qv)),Se=M.map(Fe=>Fe.group.position),C=Se[0].distanceTo(Se[Se.length-1])/2,y=he+C+H()+.1,N=z().length>2&&C>0,q=N?Math.max(be(he+.2),y/(Math.tan(Xs.degToRad(f.fov/2))*f.aspect)+he):be(y),oe=o.box.clone().expandByScalar(he+.1),se=oe.getCenter(new L),Ue=.5*oe.getSize(new L).length(),xe=N?X().negate().addScaledVector(W(),-.25).setZ(.5).normalize():new L(-.62,-.66,.42).normalize();if(o.camera==="free")Ge(se,xe.clone().multiplyScalar(be(Ue)));else if(o.camera==="impact")Ge(ht(),N?xe.clone().multiplyScalar(q):new L(-.45,-.62,.5).normalize().multiplyScalar(be(y+.05)));else{$=me();let Fe={follow:xe,front:X().setZ(.12),side:W().negate().setZ(.12),top:new L(0,-.001,1)}[o.camera];Ge($.clone(),Fe.clone().normalize().multiplyScalar(o.camera==="side"?be(y):q))}S()}function H(){let j=M.map(({flight:he,robot:Se})=>{let C=M.filter(q=>q.flight.world===he.world);return C.map(q=>q.robot.group.position.clone()).reduce((q,oe)=>q.add(oe),new L).divideScalar(C.length).distanceTo(Se.group.position)});return Math.min(Math.max(...j),MT)}function ht(){let j=o.flights.map((he,Se)=>{let C=Jo(he,Cs(he)??he.begin);return new L(...C.position).add(M[Se].group.position)});return j.reduce((he,Se)=>he.add(Se),new L).divideScalar(j.length)}function re(){if(!u)return;let j=i.clientWidth,he=i.clientHeight;if(!j||!he)return;k(1),u.setSize(j,he,!1);let Se=f.aspect;f.aspect=j/he,f.updateProjectionMatrix(),w.set(j,he),M.forEach(C=>C.path.resize(w)),Math.abs(Se/f.aspect-1)>.15&&dt(o.camera),S()}let we=new ResizeObserver(re);we.observe(i);let Pe=matchMedia("(prefers-color-scheme: dark)"),ot=()=>ce(o.all);Pe.addEventListener("change",ot);function le(){we.disconnect(),Pe.removeEventListener("change",ot),cancelAnimationFrame(_),clearTimeout(I),ol(b),m.children.slice().forEach(ol),d?.dispose(),u?.dispose(),i.replaceChildren()}return re(),e.length&&ce(e,{keepCamera:!1}),{show:ve,replace:ce,setCamera:dt,resize:re,dispose:le,setCompare(j){o.compare=j,o.flights.length&&ce(o.all,{keepCamera:!1})},setShown(j,he){if(typeof j!="number"){o[j]=he,_e(),ve(o.t);return}he?o.hidden.delete(j):o.hidden.add(j),ce(o.all,{keepCamera:!1})},canvas(j=!0){return j&&u&&(k(1),V()),u?.domElement??null},setMagnified(j){o.magnified=j,_e(),ve(o.t)},get flights(){return o.flights},get all(){return o.all},get camera(){return o.camera},pose:()=>({t:o.t,camera:o.camera,pixels:o.share,flights:o.poses??[],places:M.map(({group:j,robot:he})=>he.group.position.clone().add(j.position).toArray()),ends:M.map(({robot:j})=>j.ends()),connections:M.map(({robot:j})=>j.connections()),estimates:o.estimate?o.flights.map(j=>Hr(j)?Su(j,o.t):null):[]}),shadows:()=>[...o.shadows,...M.flatMap(({movers:j})=>j.map(({shadow:he})=>he))].map(j=>{j.updateWorldMatrix(!0,!0);let he=new an().setFromObject(j,!0);return[...he.min.toArray(),...he.max.toArray()]}),memory:()=>({...u?.info.memory})}}var ET={follow:"Follow",free:"Whole flight",front:"Front",side:"Side",top:"Top",impact:"Impact"},TT={1:"front",2:"side",3:"top",4:"follow",5:"free",6:"impact",0:"follow"},AT=[["space","play, pause"],["← →","one instant back, forth; with shift ten"],[", .","slower, faster"],["t","to the first touch"],["Home End","to the start, to the end"],["1 2 3","view from the front, from the side, from above"],["4 5 6","follow, whole flight, impact"],["0","the view as it was at first"],["e","estimated pose, on and off"],["f","full screen"],["p","save a picture"],["l","copy a link to this instant and view"],["a click in a plot","goes to that instant"],["a drag in a plot","zooms: along the time, the values, or both"],["a double click in a plot","shows everything"],["Escape","undoes the last zoom"],["?","these keys"]],Vd="springback.plots",RT=8e3;function Yv(i,e){let t=G("div",{class:"stage"}),n=G("div"),s=G("div",{class:"readouts"}),r=G("div"),o=G("p",{class:"remark",role:"status",hidden:!0}),a=!1,l=null,c=null,u=au(t,{flights:e.flights,onCamera:re=>(l?.mark(re),Ge()),onDrawn:()=>c?.drawn()}),h=u.all,f=h.length>1,m=new Set(h.map(re=>re.world)).size,g=[...new Set(h.map(re=>re.scenario))],v=g.length>2?`${h.length} flights`:g.join(" and ");function p(re){o.textContent=re,o.hidden=!1,clearTimeout(p.ends),p.ends=setTimeout(()=>o.hidden=!0,RT)}let d=h.map((re,we)=>PT(re,f&&(Pe=>w(we,Pe))));l=Si("Camera",Vo.map(re=>[re,ET[re]]),"follow",re=>u.setCamera(re));let b=Si("Flights",[["side","side by side"],["ghost","overlaid"]],"side",re=>(u.setCompare(re),Ge())),M=h.some(re=>re.arms.some(we=>we.compliant)),_=Si("Arm travel",[["1","arms to scale"],["10","arm travel × 10"]],"1",re=>(u.setMagnified(Number(re)),Ge())),P={forces:["Forces",!0],path:["Path",!0],...h.some(Hr)?{estimate:["Estimate",!1]}:{}},E=Object.fromEntries(Object.entries(P).map(([re,[we,Pe]])=>[re,dp(we,Pe,ot=>(u.setShown(re,ot),Ge()),re==="estimate"?"The pose that the pilot estimates, as a grey ghost (E)":"")])),I=G("div",{class:"choice",role:"group","aria-label":"Show"},...Object.values(E)),D=()=>h.flatMap((re,we)=>d[we].shown?[]:[we+1]);function w(re,we){if(!we&&D().length===h.length-1)return p("One flight is always shown.");d[re].mark(we),u.setShown(re,we),ve.replace(),Ge()}let S=cv(r,{onSeek:re=>(ve.pause(),ve.seek(re)),onZoom:()=>(z(),Ge()),onEdit:re=>A.open(S.wanted,re),onRemove:re=>J(S.wanted.filter((we,Pe)=>Pe!==re))}),A=Pp({signals:_l(h),standard:tr(h),onChoose:J}),k=h.find(re=>re.impacts.length),B=()=>{let[re,we]=k.impacts[0].map(ot=>ot+k.shift),Pe=.35*Math.min(we-re,.2)+.004;return[re-Pe,Math.min(we,re+.3)+2*Pe]},V=re=>!!(k&&re)&&re.every((we,Pe)=>Math.abs(we-B()[Pe])<1e-9),W=Si("Plots show",[["all","whole flight"],...k?[["impact","first impact"]]:[]],"all",re=>re==="all"?S.zoom():S.zoom(...B())),X=G("button",{type:"button",class:"undo",title:"Undo the last zoom (Escape)",disabled:!0,"aria-label":"Undo the last zoom",onclick:()=>S.back()},Yi("undo")),F=G("button",{type:"button",class:"adding",title:"Choose plots and signals",onclick:()=>A.open(S.wanted)},"Plots …");function z(){let{range:re,heights:we}=S.zoomed,Pe=!Object.keys(we).length;W.mark(Pe&&!re?"all":Pe&&V(re)?"impact":""),X.disabled=!S.canGoBack}function J(re){S.choose(re);try{re?localStorage.setItem(Vd,Qo(re)):localStorage.removeItem(Vd)}catch{}Ge()}let ne=G("dialog",{class:"keys","aria-label":"Keys and mouse"},G("h2",{},"Keys and mouse"),G("table",{},...AT.map(([re,we])=>G("tr",{},G("th",{scope:"row"},re),G("td",{},we)))),G("form",{method:"dialog"},G("button",{class:"main"},"Close"))),te=(re,we,Pe,ot)=>G("button",{type:"button",class:`tool tool-${re}`,title:`${we}${ot?` (${ot})`:""}`,"aria-label":we,onclick:Pe},Yi(re)),ce=te("film","Record a film from here",()=>c.film()),fe=G("div",{class:"left"},t,n),ye=bl(()=>fe,()=>p("This browser refuses full screen.")),_e=G("div",{class:"tools"},te("link","Copy a link to this instant and view",ee,"L"),te("picture","Save a picture",()=>c.picture(),"P"),ce,ye.button,te("help","Keys and mouse",()=>ne.showModal(),"?"));async function ee(){let re=be.address();try{await navigator.clipboard.writeText(re),p("The link is copied.")}catch{p("The address of this page is now a link to this instant and view.")}}let me={...Object.fromEntries(Object.entries(TT).map(([re,we])=>[re,()=>u.setCamera(we)])),f:ye.toggle,p:()=>c.picture(),l:ee,"?":()=>ne.showModal(),e:()=>E.estimate?.click(),Escape:()=>S.back()};i.replaceChildren(G("header",{class:"top"},G("div",{class:f?"flights several":"flights"},G("h1",{},v),...d.map(re=>re.element)),G("div",{class:"views"},l,...m>1?[b]:[],...M?[_]:[],I)),G("main",{},fe,G("aside",{},s,G("div",{class:"plot-head"},G("h2",{},"Over time"),W,X,F),r,...IT(h),LT(h))),A.element,ne),t.append(o),i.classList.add("replay");let ve=qh({scene:u,plots:S,bar:n,readouts:s,actions:me,onRest:()=>(c?.rested(),Ge())});c=mp({scene:u,stage:t,player:ve,say:p,name:v.replace(/[^\p{L}\p{N}]+/gu,"-").slice(0,60),onRecording:re=>{ce.classList.toggle("recording",re),ce.setAttribute("aria-label",re?"End the film":"Record a film from here")}}),n.querySelector(".buttons").append(_e),ve.replace({keepTime:!1}),k&&S.restore({range:B(),heights:{}}),z(),u.setCamera("follow");let be=Ip({read:dt,apply:H});function Ge(){a&&!ve.playing&&be.renew()}function dt(){let{range:re}=S.zoomed;return{t:ve.time.toFixed(6).replace(/0+$/,"").replace(/\.$/,""),camera:u.camera==="follow"?"":u.camera,speed:ve.pace==="auto"?"":ve.pace,arms:_.chosen==="10"?"10":"",compare:b.chosen==="ghost"?"ghost":"",hide:D().join(),layers:Object.keys(P).filter(we=>E[we].on!==P[we][1]).join(),zoom:V(re)||!re&&!k?"":re?re.map(we=>we.toFixed(6)).join():"all",plots:Qo(S.wanted)===Qo(tr(h))?"":Qo(S.wanted)}}function H(re){let we=le=>le.split(",").map(Number);if(re.hide){let le=we(re.hide);h.every((j,he)=>le.includes(he+1))||h.forEach((j,he)=>d[he].shown===le.includes(he+1)&&w(he,!le.includes(he+1)))}re.compare==="ghost"&&m>1&&b.press("ghost"),re.arms==="10"&&M&&_.press("10");let Pe=(re.layers??"").split(",");for(let le of Object.keys(P))Pe.includes(le)&&E[le].on===P[le][1]&&E[le].click();Vo.includes(re.camera)&&u.setCamera(re.camera);let ot=re.plots?Au(re.plots,h):[];ot.length&&S.choose(ot),re.zoom==="all"?S.restore({range:null,heights:{}}):re.zoom&&S.restore({range:we(re.zoom),heights:{}}),(re.speed==="auto"||Number(re.speed)>0)&&ve.setPace(re.speed),re.t&&Number.isFinite(Number(re.t))&&ve.seek(Number(re.t))}let ht=CT(h);return ht.length&&S.choose(ht),be.follow(),a=!0,window.springback={scene:u,player:ve,plots:S,link:be,pose:()=>({...u.pose(),playing:ve.playing,pace:ve.pace})},matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{h.forEach((re,we)=>d[we].element.style.setProperty("--colour",re.colour)),ve.replace()}),window.springback}function CT(i){try{return Au(localStorage.getItem(Vd)??"",i)}catch{return[]}}function PT(i,e){let t={shown:!0},n=e?G("button",{type:"button",class:"flight","aria-pressed":"true",title:"Hide or show this flight",onclick:()=>e(!t.shown)},i.label):G("b",{},i.label);return t.element=G("p",{class:`outcome ${i.success?"well":"badly"}`},n,G("span",{},` ${i.sentence}`)),t.element.style.setProperty("--colour",i.colour),t.mark=s=>{t.shown=s,n.setAttribute("aria-pressed",String(s)),t.element.classList.toggle("away",!s)},t}function IT(i){let e=i.flatMap(t=>t.touched.map(n=>G("p",{},i.length>1?`${t.label}: ${n}`:n)));return e.length?[G("details",{class:"about touched",open:i.length===1},G("summary",{},"Touched obstacles"),...e)]:[]}function LT(i){let e=i.flatMap(s=>[...s.notes.map(r=>`${s.label}: ${r}.`),s.shift?`${s.label} is shown ${Math.abs(s.shift).toFixed(3)} s ${s.shift<0?"earlier":"later"} than it flew, so that all touch at the same time.`:""]),t=Math.max(...i.map(s=>s.departure.position))*1e3;e.push(`Motion between the drawn instants is interpolated linearly: positions are within ${t<.01?"0.01":t.toFixed(2)} mm of the flight.`);let n=Math.max(...i.map(s=>s.every));return e.push("Signals that you choose are rounded to 1/65534 of their range."),n>1&&e.push(`Telemetry is shown at every tick near impacts and changes of phase, elsewhere at one tick in ${n}.`),G("details",{class:"about"},G("summary",{},"About this view"),...[...new Set(e)].filter(Boolean).map(s=>G("p",{},s)),G("p",{},"World axes: x north, y west, z up. Yellow arrows are the contact forces on cages and main body, including friction; the numbers show their vector sum, in which friction on two cages may cancel. Blue bars are the thrust of the rotors; dark discs are vertical shadows."))}var Gd=1e3,Zv=(i,e)=>Number((Math.round(i/e)*e).toFixed(6));function ll(i,e){let{least:t,most:n,logarithmic:s}=i,r=s?Math.log(e/t)/Math.log(n/t):(e-t)/(n-t);return Math.min(Math.max(r,0),1)}function $v(i,e){let{least:t,most:n,step:s,logarithmic:r}=i,o=r?t*(n/t)**e:t+(n-t)*e,a=r?10**Math.max(Math.floor(Math.log10(o))-1,Math.log10(s)):s;return Math.min(Math.max(Zv(o,Math.max(a,s)),t),n)}function DT(i,e){let t=`set-${i.name}`,n=i.unit.replace("^1.5","¹·⁵"),s=G("input",{type:"range",min:0,max:Gd,step:1,id:`${t}-slider`,"aria-label":i.label,oninput:()=>h($v(i,Number(s.value)/Gd),{moving:!0}),onchange:()=>e(i.name,r.value,{settled:!0}),onkeydown:g=>{let v={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[g.key];if(!v)return;g.preventDefault();let p=Number(r.value);Number.isFinite(p)&&h(Math.min(Math.max(Zv(p+v*i.step,i.step),i.least),i.most),{settled:!0})}}),r=G("input",{type:"text",inputmode:"decimal",id:t,autocomplete:"off",spellcheck:"false",maxlength:40,"aria-describedby":`${t}-words`,oninput:()=>e(i.name,r.value.trim(),{typing:!0}),onchange:()=>e(i.name,r.value.trim(),{settled:!0})}),o=G("p",{class:"words",id:`${t}-words`}),a=G("div",{class:"marks"},...i.marks.map((g,v)=>{let p=M=>String(M.value).length*.013+.01,d=i.marks.some((M,_)=>_<v&&Math.abs(ll(i,M.value)-ll(i,g.value))<p(M)+p(g)),b=G("button",{type:"button",class:d?"tight":"",title:`${g.value} ${n}, ${g.words}`,"aria-label":`${i.label} ${g.value} ${n}, ${g.words}`,onclick:()=>h(g.value,{settled:!0})},G("span",{},String(g.value)));return b.style.setProperty("--share",ll(i,g.value)),b})),l=G("div",{class:"slider-control","data-name":i.name},G("label",{for:t},i.label),G("span",{class:"field"},r,G("span",{class:"unit"},n)),G("div",{class:"rail"},s,a),o);function c(g){let v=Number(g);r.value.trim()!==String(g)&&(r.value=String(g)),Number.isFinite(v)&&(s.value=Math.round(ll(i,v)*Gd),s.setAttribute("aria-valuetext",`${g} ${n}`)),f("")}function u(){let g=i.marks.find(v=>v.value===Number(r.value));o.className=g?"words printed":"words",o.textContent=g?`= ${g.words}`:i.explains}function h(g,v){c(g),e(i.name,String(g),v)}function f(g){r.setAttribute("aria-invalid",String(!!g)),l.classList.toggle("wrong",!!g),g?o.textContent=g:u()}return l.title=i.explains,{element:l,show:c,tellProblem:f,pick:g=>h($v(i,ll(i,g)),{settled:!0})}}function UT(i){let e=G("p",{class:"words"},i.explains);return{element:G("div",{class:"fixed-control","data-name":i.name},G("span",{class:"label"},i.label),e),show:()=>{},tellProblem:s=>e.textContent=s||i.explains}}function NT(i,e){let t=Object.keys(i.words).length>3,n=G("p",{class:"words"},i.explains),s=a=>e(i.name,a,{settled:!0});if(!t){let a=Si(i.label,Object.entries(i.words),i.default,s);return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("span",{class:"label"},i.label),a),show:a.mark,tellProblem:()=>{}}}let r=G("select",{id:`set-${i.name}`,onchange:()=>s(r.value)},...Object.entries(i.words).map(([a,l])=>G("option",{value:a},l)));return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("label",{for:`set-${i.name}`},i.label),r,n),show:a=>r.value=a,tellProblem:a=>n.textContent=a||i.explains}}var FT={slider:DT,fixed:UT,choice:NT};function Kv(i,e){let t={},n={},s=new Map,r=(v,p,d)=>{t[v]=p,l(),e(v,p,d)};for(let v of i)t[v.name]=String(v.default),n[v.name]=FT[v.kind](v,r),s.has(v.group)||s.set(v.group,[]),s.get(v.group).push(n[v.name].element);let o=[...s].map(([v,p])=>G("section",{},...v?[G("h2",{},v)]:[],...p)),a=G("form",{class:"controls",onsubmit:v=>v.preventDefault()},...o);function l(){for(let v of i){let p=Object.entries(v.when).every(([d,b])=>b.includes(t[d]));n[v.name].element.hidden=!p}o.forEach(v=>v.hidden=![...v.querySelectorAll("[data-name]")].some(p=>!p.hidden))}function c(v){for(let[p,d]of Object.entries(v))t[p]=String(d),n[p]?.show(d);l()}function u(v){let p=new URLSearchParams(v);c(Object.fromEntries(i.map(({name:d,words:b,default:M})=>{let _=p.get(d);return[d,_===null||b&&!(_ in b)?M:_]})))}function h(v){for(let p of Object.values(n))p.tellProblem("");for(let p of v){let d=p.split(":")[0],b=d in n?d:i.find(M=>M.path===d)?.name;n[b]?.tellProblem(p.slice(d.length+1).trim())}}let f=()=>i.filter(v=>t[v.name]!==String(v.default)).map(v=>`${v.name}=${encodeURIComponent(t[v.name])}`).join("&");return l(),{element:a,values:t,query:f,show:c,showQuery:u,tellProblems:h,isShown:v=>!n[v].element.hidden,pick:(v,p)=>n[v].pick(p)}}function Jv(i,e){let t=null,n=!1,s=0;function r(l,c){clearTimeout(s),t={query:l,how:c},n||o()}async function o(){let{query:l,how:c}=t;t=null,n=!0;try{await a(l,c)}catch{t||e.gone()}n=!1,t&&o()}async function a(l,c){let u=await fetch(`flight?${l}`,{headers:{"x-lab-page":i}}),h=await u.json();if(u.ok)e.answered(h,{...c,older:t!==null});else if(u.status===503){if(t)return;h.preparing&&e.waits(h.preparing),s=setTimeout(()=>r(l,{...c,since:performance.now()}),700)}else!h.overtaken&&!t&&e.refused(h.errors,c)}return{ask:r}}var jv=100,OT=16,cl="Energy",Qv=[-.01,.13],BT={motion:["#0072b2",.85],"arm springs":["#56b4e9",.85],"end stops":["#cc79a7",.85],contact:["#009e73",.85],"lost in arms":["#e69f00",.6],"lost in contact":["#d55e00",.6],"lost in friction":["#8c8c8c",.6],"lost in stops":["#cc79a7",.4],"lost in locking":["#444444",.4],"lost to air":["#bbbbbb",.4],"moving obstacles":["#b3a100",.75],"lost in obstacles":["#b3a100",.35],"to driven obstacles":["#6b4fa0",.5],"to the other robot":["#6b4fa0",.5]},ex={"put in":{width:1.6,dash:[6,3]},"by driven obstacles":{width:1.4,dash:[2,3]},"by the other robot":{width:1.4,dash:[2,3]}},tx=(i,e)=>i+Math.round(255*e).toString(16).padStart(2,"0");function Wd(i,e=[1,1.5,2,3,5,7,10]){if(!(i>0))return 1;let t=10**Math.floor(Math.log10(i));return t*e.find(n=>n*t>=i*.999999)}function Xd(i,e,t,{moving:n=!1,locked:s=!1}={}){if(i&&s)return i;let r=[e<-1e-9?-Wd(-e):0,t>1e-9?Wd(t):e<-1e-9?0:1],[o,a]=i??r,l=e>=o&&t<=a&&(n||t-e>.3*(a-o));return i&&l?i:n?[Math.min(o,r[0]),Math.max(a,r[1])]:r}function zT(i,e,t){let n=0,s=0;for(let{t:r,values:o}of i)for(let a=0;a<o.length;a++)r[a]<e||r[a]>t||(o[a]<n&&(n=o[a]),o[a]>s&&(s=o[a]));return[n,s]}function kT(i,e){let t=new Map,n=(a,l,c)=>{t.has(a)||t.set(a,{name:a,unit:l,curves:[],stacked:a.startsWith(cl)}),t.get(a).curves.push(c)},s=(a,l)=>{let c=Array.from(a.t,h=>h+a.shift),u=null;for(let h of a.series)if(h.panel===cl){if(l)continue;if(ex[h.name]){n(`${cl}, ${a.label}`,h.unit,{name:h.name,t:c,values:Array.from(h.values),colour:Pn().ink,flight:a,over:!0,...ex[h.name]});continue}u=Array.from(h.values,(g,v)=>g+(u?u[v]:0));let[f,m]=BT[h.name]??["#8c8c8c",.5];n(`${cl}, ${a.label}`,h.unit,{name:h.name,t:c,values:u,colour:f,fill:tx(f,m),flight:a})}else n(h.panel,h.unit,{name:l?`${a.label}, pinned`:a.label,t:c,values:Array.from(h.values),flight:a,colour:l?tx(a.colour,.75):a.colour,dash:l?[3,3]:a.dash,behind:l})};i.forEach((a,l)=>{a.dash=l?[8,3]:[],s(a,!1)}),e.forEach(a=>s(a,!0));let r=i.map(a=>`${cl}, ${a.label}`),o=a=>["Acceleration","Arm compression",...r,"Velocity","Contact force"].indexOf(a.name);return[...t.values()].sort((a,l)=>o(a)-o(l))}function nx(i,{onSeek:e}){let t=new Map,n=[],s=[],r=0,o=null,a=!1;i.classList.add("plots");function l(p,{whole:d=!1,moving:b=!1}={}){s=p;let M=Cs(p[0]),[_,P]=[p[0].begin,p[0].end];o=d||M===null?[_,P]:[M+Qv[0],Math.min(M+Qv[1],P)];let E=M??0,I=kT(p,n);for(let[D,w]of t)I.some(S=>S.name===D&&c(S,d)===w.signature)||(w.plot.destroy(),w.box.remove(),t.delete(D));for(let D of I){let w=t.get(D.name)??f(D,d);w.panel=D,w.zero=E,w.bounds=Xd(w.bounds,...zT(D.curves,...o),{moving:b,locked:a}),w.plot.batch(()=>{w.plot.setData(u(D),!1),w.plot.setScale("x",{min:o[0],max:o[1]}),w.plot.setScale("y",{min:w.bounds[0],max:w.bounds[1]})}),i.append(w.box)}g(r)}let c=(p,d)=>`${d} ${p.curves.map(b=>`${b.name} ${b.colour}`).join()}`;function u(p){let b=p.curves.every(M=>M.flight===p.curves[0].flight)?[p.curves[0].t,...p.curves.map(M=>M.values)]:Kt.join(p.curves.map(M=>[M.t,M.values]));return[b[0],...h(p,b.slice(1))]}function h(p,d){if(!p.stacked)return d;let b=p.curves.map(M=>!!M.over);return[...d.filter((M,_)=>!b[_]).reverse(),...d.filter((M,_)=>b[_])]}function f(p,d){let b=Pn(),M=!p.stacked||p.curves[0].flight===s[0],_=p.curves.filter(()=>M).map(B=>{let V=document.createElementNS("http://www.w3.org/2000/svg","svg");V.setAttribute("viewBox","0 0 22 8"),V.setAttribute("aria-hidden","true");let W=document.createElementNS("http://www.w3.org/2000/svg","line"),X={x1:0,x2:22,y1:4,y2:4,stroke:B.fill??B.colour,"stroke-width":B.fill?8:2.4,"stroke-dasharray":(B.dash??[]).join(" ")};return Object.entries(X).forEach(([F,z])=>W.setAttribute(F,z)),V.append(W),G("span",{class:"plot-key"},V,G("span",{},B.name))}),P=G("div",{class:"plot-canvas"}),E=G("section",{class:"plot","data-panel":p.name},G("header",{},G("h3",{},`${p.name} [${p.unit}]`),G("div",{class:"plot-keys"},..._)),P);i.append(E);let I={box:E,canvas:P,panel:p,signature:c(p,d),bounds:null,zero:0},D={stroke:b.faint,grid:{stroke:b.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},w=h(p,p.curves),S=w.filter(B=>!B.over),A=(B,V)=>V.map(W=>String(d?+W.toFixed(3):Math.round(1e3*(W-I.zero)))),k=(B,V,W,X)=>HT(W,X,I.zero,d);return I.plot=new Kt({width:Math.max(P.clientWidth,200),height:jv,padding:[6,10,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[{...D,size:22,gap:2,values:A,splits:k},{...D,size:46,gap:4,space:OT}],series:[{},...w.map(B=>({stroke:B.colour,width:B.width??(B.fill?1:B.behind?1.4:1.8),dash:B.dash??[],fill:B.fill,spanGaps:!0,points:{show:!1}}))],hooks:{draw:[()=>m(I)]},bands:p.stacked?S.slice(1).map((B,V)=>({series:[V+1,V+2],fill:S[V].fill})):[]},u(p),P),I.marker=G("div",{class:"plot-now"}),I.plot.over.append(I.marker),I.plot.over.addEventListener("click",B=>e(I.plot.posToVal(B.offsetX,"x"))),t.set(p.name,I),I}function m({plot:p,marker:d}){if(!d)return;let{min:b,max:M}=p.scales.x;d.hidden=!(r>=b&&r<=M),d.style.transform=`translateX(${p.valToPos(r,"x")}px)`}function g(p){r=p,t.forEach(m)}function v(){for(let{plot:p,canvas:d}of t.values()){let b=d.clientWidth;b&&Math.abs(b-p.width)>1&&p.setSize({width:b,height:jv})}g(r)}return new ResizeObserver(v).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{t.forEach(({plot:p,box:d})=>(p.destroy(),d.remove())),t.clear()}),{replace:l,show:g,pin(p){n=p},lock(p){a=p},bounds:p=>t.get(p)?.bounds,curve:p=>t.get(p)?.panel.curves.map(d=>({name:d.name,peak:d.values.reduce((b,M)=>Math.max(b,M),0),points:d.values.length})),get flights(){return s}}}function HT(i,e,t,n){let s=n?Wd((e-i)/8,[1,2,5,10]):.02,r=[];for(let o=Math.ceil((i-t*!n)/s);;o++){let a=o*s+(n?0:t);if(a>e)return r;r.push(a)}}var ix=150,VT=700,GT=40;function sx(i,{choices:e,table:t,page:n,isShown:s,onPick:r,onChoice:o}){let a=new Map,l=null,c=null,u=null,h=null,f=0,m="",g=G("select",{id:"sweep-of","aria-label":"Control to sweep",onchange:E}),v=G("select",{id:"sweep-measure","aria-label":"Measure of the sweep",onchange:E},...e.measures.map(F=>G("option",{value:F.name},F.label)));v.value="impact_peak_acceleration";let p=G("div",{class:"plot-canvas"}),d=G("h3"),b=G("p",{class:"words",role:"status"});i.classList.add("sweep"),i.replaceChildren(G("div",{class:"sweep-head"},G("h2",{},"Sweep"),g,v),d,p,b),P();let M=F=>t.find(z=>z.name===F),_=()=>e.measures.find(F=>F.name===v.value);function P(){let F=g.value,z=e.controls.filter(ne=>s(ne.name)||ne.name===F),J=["",...z.map(ne=>ne.name)].join();g.dataset.names!==J&&(g.dataset.names=J,g.replaceChildren(G("option",{value:""},"off"),...z.map(ne=>G("option",{value:ne.name},ne.label))),g.value=F)}function E(){h=null,D(l,{}),o()}function I(F){return F.split("&").filter(z=>z&&z.split("=")[0]!==g.value).join("&")}function D(F,{moving:z=!1}){if(l=F,P(),clearTimeout(f),!l||!g.value)return A("");if(l.is_piloted)return A("Flights with a pilot are not swept here; a campaign can: springback campaign.");if(!s(g.value))return A("This control has no effect here.");let J=`${g.value}?${I(l.query)}`;a.has(J)?(c=a.get(J),S()):z||w(J),V(!a.has(J))}async function w(F){m=F;let[z,J]=F.split(/\?(.*)/s);b.textContent="Flying the sweep …";try{let ne=await fetch(`sweep?${[J,`of=${z}`].filter(Boolean).join("&")}`,{headers:{"x-lab-page":n}}),te=await ne.json();if(m!==F)return;if(ne.ok)a.size>=GT&&a.delete(a.keys().next().value),a.set(F,te),D(l,{});else if(ne.status===503){let ce=te.preparing;b.textContent=ce?`Compiling for ${ce.what}, about ${ce.about} s, once on this machine: ${Math.round(ce.waited)} s so far.`:"Too many requests are waiting.",f=setTimeout(()=>w(F),VT)}else te.overtaken||A(te.errors.join(" "))}catch{b.textContent="The lab does not respond."}}function S(){let F=c.refusals.reduce((te,ce)=>te+ce.count,0),z=Object.keys(c.labels).length>1?c.labels:{},J=te=>Number(te.toPrecision(3)),ne=c.refusals.map(({robot:te,from:ce,to:fe,why:ye})=>` ${z[te]?`${z[te]}, `:""}${ce===fe?"":`${J(ce)} to `}${J(fe)} ${M(c.of).unit}: ${ye}.`);b.textContent=F?`${F} of ${c.at.length*Object.keys(c.labels).length} points cannot be flown.${ne.join("")}`:`${c.at.length} flights for each robot in ${c.took.toFixed(0)} ms. A click sets the value.`}function A(F){m="",c=null,d.textContent="",u?.destroy(),u=null,b.textContent=F,i.classList.toggle("off",!g.value)}function k(){let F=l.measures.find(z=>z.name===v.value);return l.flights.map((z,J)=>({robot:z.robot,label:z.label,colour:Pn().robots[B(J)],dash:J?[8,3]:[],x:l.settings[g.value],y:F?.values[z.robot]??null}))}let B=F=>l.flights.length===1&&l.flights[0].robot==="quad"?1:F%2;function V(F){if(i.classList.remove("off"),!c||c.of!==g.value)return u&&(u.destroy(),u=null);let z=k(),J=M(g.value),ne=z.map(ye=>c.measures[v.value][ye.robot]??c.at.map(()=>null)),te=[...ne.flat(),...z.map(ye=>ye.y)].filter(ye=>ye!==null);h=Xd(h,Math.min(0,...te),Math.max(0,...te));let ce=_();d.textContent=ce.unit?`${ce.label} [${ce.unit}]`:ce.label;let fe=JSON.stringify([J.name,v.value,z.map(ye=>[ye.label,ye.colour])]);u?.look!==fe&&W(J,z,fe),u.batch(()=>{u.setData([c.at,...ne],!1),u.setScale("x",{min:J.least,max:J.most}),u.setScale("y",{min:h[0],max:h[1]})}),u.points=z,p.classList.toggle("old",F),X()}function W(F,z,J){u?.destroy();let ne=Pn(),te={stroke:ne.faint,grid:{stroke:ne.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ce=F.unit?` [${F.unit.replace("^1.5","¹·⁵")}]`:"",fe={...te,size:24,gap:6,label:`${F.label}${ce}`,labelSize:15,labelFont:te.font,labelGap:0};F.logarithmic&&Object.assign(fe,{splits:(ye,_e,ee,$)=>WT(ee,$),values:(ye,_e)=>_e.map(String),filter:(ye,_e)=>_e}),u=new Kt({width:Math.max(p.clientWidth,200),height:ix,padding:[8,12,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1,distr:F.logarithmic?3:1,range:[F.least,F.most]},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[fe,{...te,size:46,gap:4,space:26}],series:[{},...z.map(ye=>({stroke:ye.colour,width:1.8,dash:ye.dash,points:{show:!1}}))],hooks:{draw:[X]}},[[F.least,F.most],...z.map(()=>[null,null])],p),u.look=J,u.line=G("div",{class:"plot-now"}),u.dots=z.map(ye=>{let _e=G("div",{class:"sweep-point",title:ye.label});return _e.style.background=ye.colour,_e}),u.over.append(u.line,...u.dots),u.over.addEventListener("click",ye=>r(F.name,u.posToVal(ye.offsetX,"x")))}function X(){if(!u?.points)return;let F=_();u.line.style.transform=`translateX(${u.valToPos(u.points[0].x,"x")}px)`,u.points.forEach(({x:z,y:J,label:ne},te)=>{let ce=u.dots[te];ce.hidden=J===null,J!==null&&(ce.title=`${ne}: ${Number(J.toPrecision(4))} ${F.unit}`,ce.style.transform=`translate(${u.valToPos(z,"x")}px, ${u.valToPos(J,"y")}px)`)})}return new ResizeObserver(()=>{let F=p.clientWidth;u&&F&&Math.abs(F-u.width)>1&&u.setSize({width:F,height:ix})}).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>l&&D(l,{})),{show:D,hash:()=>g.value?`#sweep=${g.value},${v.value}`:"",restore(F){let[z,J]=(F.match(/^#sweep=([a-z_]+),([a-z_]+)$/)??[]).slice(1),ne=(te,ce)=>te.some(fe=>fe.name===ce);g.dataset.names="",g.replaceChildren(G("option",{value:""},"off"),...e.controls.map(te=>G("option",{value:te.name},te.label))),g.value=ne(e.controls,z)?z:"",ne(e.measures,J)&&(v.value=J),h=null,l&&D(l,{})},state:()=>({of:g.value,measure:v.value,curve:c,points:u?.points??[],bounds:h,words:b.textContent})}}function WT(i,e){let t=[];for(let n=Math.floor(Math.log10(i));n<=Math.log10(e);n++)for(let s of[1,2,5]){let r=Number((s*10**n).toPrecision(3));r>=i&&r<=e&&t.push(r)}return t}var qd=i=>{if(i==null)return"–";if(typeof i=="string")return i;let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)};function rx(i){function e(t,n,s){let r=t.flights.map(m=>[m.robot,m.label]),o=m=>n?.flights.some(g=>g.robot===m),a=t.measures.some(m=>Object.keys(m.printed).length),l=G("tr",{},G("th",{},""));for(let[m,[g,v]]of r.entries()){let p=G("th",{scope:"col"},v);p.style.color=s[m],l.append(p),a&&l.append(G("th",{scope:"col",class:"printed"},"paper")),o(g)&&l.append(G("th",{scope:"col",class:"pinned"},"pinned"))}let c=t.measures.map(m=>{let g=n?.measures.find(p=>p.name===m.name),v=G("tr",{"data-measure":m.name},G("th",{scope:"row"},m.label,...m.unit?[G("small",{},` ${m.unit}`)]:[]));for(let[p]of r){let d=[a&&m.printed[p]?`paper ${m.printed[p]}`:"",o(p)?`pinned ${qd(g?.values[p])}`:""];v.append(G("td",{"data-robot":p,"data-beside":d.filter(Boolean).join(", ")},G("b",{},qd(m.values[p])))),a&&v.append(G("td",{class:"printed"},m.printed[p]??"")),o(p)&&v.append(G("td",{class:"pinned"},qd(g?.values[p])))}return v}),{words:u,same:h}=t.printed_for,f=a?[G("p",{class:h?"note":"note other"},h?u:`${u} The settings here differ.`)]:[];i.replaceChildren(G("table",{},G("thead",{},l),G("tbody",{},...c)),...f),i.classList.toggle("elsewhere",!h)}return{show:e}}var ox={impact:"Impact",follow:"Follow",side:"Side",top:"Top",free:"All"},XT=.012,qT=350;function ax(i,e){let t=Math.random().toString(36).slice(2),n=null,s=null,r=!1,o=[],a=Kv(e.controls,ce),l=G("div",{class:"outcomes","aria-live":"polite"}),c=G("p",{class:"alert",role:"alert",hidden:!0}),u=G("input",{class:"link",readonly:!0,"aria-label":"Link to these settings",id:"link",onfocus:()=>u.select()}),h=G("button",{type:"button",id:"copy",onclick:we},"Copy link"),f=G("button",{type:"button",id:"pin","aria-pressed":"false",title:"Keep this flight behind the next ones for comparison",onclick:Pe},"Pin"),m=G("button",{type:"button",id:"reset",title:e.file?`Return to ${e.file}`:"Return to the paper's slider test",onclick:()=>re("",{push:!0})},"Reset"),g=G("span",{class:"files"}),v=G("div",{class:"stage"}),p=G("div",{class:"preparing",role:"status",hidden:!0}),d=G("div"),b=G("div"),M=G("div",{class:"measures"}),_=G("div"),P=G("button",{type:"button",id:"lock","aria-pressed":"false",title:"Keep the vertical scales of all plots as they are",onclick:me},"Lock y"),E=G("p",{class:"took"}),I=G("button",{type:"button",class:"drawer",id:"drawer","aria-expanded":"false",onclick:()=>ot(!i.classList.contains("open"))},"Settings"),D=Si("Camera",Vo.filter(le=>ox[le]).map(le=>[le,ox[le]]),"impact",le=>V.setCamera(le)),w=Si("Two robots",[["side","side by side"],["ghost","overlaid"]],"side",le=>V.setCompare(le)),S=G("h2"),A=Si("Plots show",[["impact","impact"],["all","all"]],"impact",le=>{r=le==="all",n&&_e()}),k=bl(()=>B,()=>ve(["This browser refuses full screen."])),B=G("div",{class:"middle"},G("div",{class:"frame"},v,G("div",{class:"views"},D,w,k.button),p),d,M);i.classList.add("lab"),i.replaceChildren(G("header",{class:"top"},G("div",{class:"said"},G("h1",{},"Impact lab",...e.file?[G("small",{},e.file)]:[]),l,c),G("div",{class:"actions"},f,m,g,G("span",{class:"linking"},u,h))),G("main",{},G("aside",{class:"settings",id:"settings"},a.element,E),B,G("aside",{class:"curves"},_,G("div",{class:"plot-head"},S,P,A),b)),I);let V=au(v,{onCamera:le=>D.mark(le)}),W=nx(b,{onSeek:le=>(X.pause(),X.seek(le))}),X=qh({scene:V,plots:{show:W.show,replace:()=>_e()},bar:d,actions:{f:k.toggle}}),F=rx(M),z=sx(_,{choices:e.sweeps,table:e.controls,page:t,isShown:a.isShown,onPick:a.pick,onChoice:()=>n&&ht(n.query,{settled:!0})}),J=Jv(t,{answered:fe,refused:be,waits:Ge,gone:dt}),ne=0,te=!1;function ce(le,j,he){clearTimeout(ne);let Se=()=>J.ask(a.query(),{...he,since:performance.now()});he.typing?ne=setTimeout(Se,qT):Se()}function fe(le,j){let he=n;n=le,i.classList.add("ready"),j.aside||ve([]),p.hidden=!0,!j.typing&&!j.older?a.show(le.settings):a.tellProblems([]);let Se=!he||he.settings.mode!==le.settings.mode,C=le.flights.length!==he?.flights.length,y=le.flights.flatMap(N=>N.second?[N.second]:[]);V.replace([...le.flights.map(N=>N.scene),...y],{keepCamera:!Se&&!C}),w.hidden=le.flights.length<2,Se&&A.mark((r=le.is_piloted)?"all":"impact"),te=!!j.moving,X.replace({keepTime:!Se}),Se&&ye(),ee(),$(),z.show(le,j),g.replaceChildren(...le.flights.map(N=>G("a",{class:"button",href:`scenario.toml?${[le.query,`of=${N.robot}`].filter(Boolean).join("&")}`,download:N.file,title:`Scenario for springback fly, ${N.label}`},`${N.label}.toml`))),ht(le.query,j),requestAnimationFrame(()=>{let N=performance.now()-j.since;o.push(N),E.textContent=`Flown in ${le.took.flying.toFixed(0)} ms, answered in ${le.took.all.toFixed(0)} ms, drawn after ${N.toFixed(0)} ms.`})}function ye(){let le=Cs(V.flights[0]),j=!n.is_piloted,he=j?"impact":"follow";D.mark(he),V.setCamera(he),X.seek(le===null?V.flights[0].begin:j?le+XT:le)}function _e(){n&&(S.textContent=r?"Time [s]":"Time from touch [ms]",W.replace(V.flights,{whole:r,moving:te}))}function ee(){l.replaceChildren(...n.flights.map((le,j)=>{let he=G("p",{class:`outcome ${le.well?"well":"badly"}`},G("b",{},le.label),le.sentence.slice(le.label.length));return he.style.setProperty("--colour",V.flights[j].colour),he}))}let $=()=>F.show(n,s,V.flights.map(le=>le.colour));function me(){let le=P.getAttribute("aria-pressed")!=="true";P.setAttribute("aria-pressed",String(le)),W.lock(le),_e()}function ve(le){c.hidden=!le.length,c.textContent=le.join(" ")}function be(le,j){p.hidden=!0,a.tellProblems(le),ve([...le.map(he=>`${he}.`),n?"The previous flight is shown.":"The default flight is shown instead."]),n||J.ask("",{since:performance.now(),aside:!0})}function Ge(le){p.hidden=!1,p.replaceChildren(G("progress",{}),G("p",{},`Compiling for ${le.what}, about ${le.about} s: ${Math.round(le.waited)} s so far.`),G("p",{class:"words"},`Once on this machine; ${n?"the previous flight stays, and ":""}other settings can be flown meanwhile if they are ready.`))}function dt(){ve(["The lab does not respond; it may have been stopped in its terminal. Any change tries again."])}let H=!1;function ht(le,{settled:j=!1,aside:he=!1,restored:Se=!1}){let C=`${location.pathname}${le?`?${le}`:""}${z.hash()}`;u.value=location.origin+C,!(he||Se)&&(`${location.pathname}${location.search}${location.hash}`!==C&&(H?history.replaceState(null,"",C):history.pushState(null,"",C)),H=!j)}function re(le,{push:j=!1}={}){a.showQuery(le),J.ask(le,{since:performance.now(),settled:j,restored:!j})}addEventListener("popstate",()=>(z.restore(location.hash),re(location.search.slice(1))));async function we(){try{await navigator.clipboard.writeText(u.value)}catch{u.select(),document.execCommand("copy")}h.textContent="Copied",setTimeout(()=>h.textContent="Copy link",1500)}function Pe(){s=s?null:n,f.setAttribute("aria-pressed",String(!!s)),f.textContent=s?"Unpin":"Pin";let le=s?Hd(s.flights.map(j=>({...j.scene})),Pn()):[];W.pin(le),_e(),$()}function ot(le){i.classList.toggle("open",le),I.setAttribute("aria-expanded",String(le)),I.textContent=le?"Done":"Settings",le&&v.scrollIntoView({block:"start"})}return z.restore(location.hash),re(location.search.slice(1)),window.springback={scene:V,player:X,plots:W,controls:a,sweep:z,latency:o,pose:()=>({...V.pose(),playing:X.playing,pace:X.pace}),get answer(){return n}},window.springback}var YT={replay:Yv,lab:ax};function lx(){let i=YT[document.body.dataset.app],e=document.getElementById("data");i&&i(document.getElementById("app"),e?JSON.parse(e.textContent):{})}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",lx):lx();})();
