/*! springback, MIT licence; sources 3153b0f3addf3a0cabb82560e793a210062d98380650aabaa9935a0cfd9fc0ae

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
(()=>{var fp=i=>{throw TypeError(i)};var Cx=(i,e,t)=>e.has(i)||fp("Cannot "+t);var vl=(i,e,t)=>e.has(i)?fp("Cannot add the same private member more than once"):e instanceof WeakSet?e.add(i):e.set(i,t);var Cn=(i,e,t)=>(Cx(i,e,"access private method"),t);function G(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==!1&&r!=null&&n.setAttribute(s,r);return n.append(...t),n}var Px={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",back:"M18 5v14l-9.5-7zM5.5 5h2.4v14H5.5z",forth:"M6 5v14l9.5-7zM16.1 5h2.4v14h-2.4z",touch:"M4 4h3v16H4zM20 12l-9 6V6z",link:"M10.6 13.4a4 4 0 0 0 5.7 0l3-3a4 4 0 1 0-5.7-5.7l-1.6 1.6 1.4 1.4 1.6-1.6a2 2 0 1 1 2.9 2.9l-3 3a2 2 0 0 1-2.9 0zm2.8-2.8a4 4 0 0 0-5.7 0l-3 3a4 4 0 1 0 5.7 5.7l1.6-1.6-1.4-1.4-1.6 1.6a2 2 0 1 1-2.9-2.9l3-3a2 2 0 0 1 2.9 0z",picture:"M4 7h4l1.5-2.5h5L16 7h4v12H4zm8 2.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zm0 1.8a1.7 1.7 0 1 1 0 3.4 1.7 1.7 0 0 1 0-3.4z",undo:"M9 4 3.5 9.5 9 15v-4h5a3.5 3.5 0 0 1 0 7h-4v2.2h4a5.7 5.7 0 0 0 0-11.4H9z",film:"M3 6h12v12H3zM16.5 10.5 21 7.5v9l-4.5-3z",full:"M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z",help:"M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 12.5h2v2h-2zm1-9c-2 0-3.5 1.3-3.5 3.2h2c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.4-2.5 1.6-2.5 4.1v.3h2v-.2c0-1.4 2.5-1.8 2.5-4.3 0-1.8-1.5-3-3.5-3z"};function Yi(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Px[i]),t.setAttribute("fill-rule","evenodd"),e.append(t),e}function Si(i,e,t,n){let s=G("div",{class:"choice",role:"group","aria-label":i});for(let[a,l]of e)s.append(G("button",{type:"button","data-value":a,"aria-pressed":String(a===t),onclick:()=>{r(a),n(a)}},l));function r(a){for(let l of s.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))}let o=a=>(r(a),n(a));return Object.defineProperty(s,"chosen",{get:()=>s.querySelector("[aria-pressed=true]")?.dataset.value}),Object.assign(s,{mark:r,press:o})}function dp(i,e,t,n=""){let s=G("button",{type:"button",title:n,"aria-pressed":String(e),onclick:()=>{s.setAttribute("aria-pressed",String(!s.on)),t(s.on)}},i);return Object.defineProperty(s,"on",{get:()=>s.getAttribute("aria-pressed")==="true"}),s}var Ix=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"],Lx=30;function pp(i,e){let t=G("a",{href:URL.createObjectURL(i),download:e});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function yu(i,e,t,n=null){let s=e.getBoundingClientRect(),r=getComputedStyle(e);if(!s.width)return;let[o,a]=[s.left-t.left,s.top-t.top];i.fillStyle=r.backgroundColor,i.fillRect(o,a,s.width,s.height);let l=o+parseFloat(r.paddingLeft);if(n&&parseFloat(n.width)>0){let c=parseFloat(n.height);i.fillStyle=n.backgroundColor,i.fillRect(l,a+(s.height-c)/2,parseFloat(n.width),c),l+=parseFloat(n.width)+parseFloat(n.marginRight)}i.font=`${r.fontWeight} ${r.fontSize} ${r.fontFamily}`,i.textBaseline="middle",i.fillStyle=r.color,i.fillText(e.textContent,l,a+s.height/2+1,o+s.width-l)}function mp({scene:i,stage:e,player:t,name:n,say:s,onRecording:r=()=>{}}){let o=G("div",{class:"stage-clock","aria-hidden":"true"});e.append(o);let a=null,l=null;function c(){let m=Math.min(devicePixelRatio||1,2),g=G("canvas",{width:2*Math.round(e.clientWidth*m/2),height:2*Math.round(e.clientHeight*m/2)});return{canvas:g,pen:g.getContext("2d"),ratio:m}}function u({canvas:m,pen:g,ratio:v},p){o.textContent=`${i.pose().t.toFixed(4)} s`;let d=e.getBoundingClientRect();g.setTransform(1,0,0,1,0,0),g.drawImage(p,0,0,m.width,m.height),g.scale(v,v);let b=e.querySelector(".scene-legend"),M=b.getBoundingClientRect();g.fillStyle=getComputedStyle(b).backgroundColor,g.fillRect(M.left-d.left,M.top-d.top,M.width,M.height);for(let y of b.children)yu(g,y,d,getComputedStyle(y,"::before"));for(let y of e.querySelectorAll(".force-labels span:not([hidden])"))yu(g,y,d);yu(g,o,d)}function h(){let m=i.canvas();if(!m)return s("There is no picture without WebGL.");let g=c();u(g,m),g.canvas.toBlob(v=>{pp(v,`${n}-${i.pose().t.toFixed(4)}s.png`),s("The picture is among your downloads.")})}function f(){if(a)return a.stop();let m=window.MediaRecorder&&Ix.find(v=>MediaRecorder.isTypeSupported(v));if(!m||!i.canvas()||!HTMLCanvasElement.prototype.captureStream)return s("This browser cannot record films. The command springback animate RESULT --out film.gif makes one, or film.mp4.");l=c(),u(l,i.canvas());let g=[];a=new MediaRecorder(l.canvas.captureStream(Lx),{mimeType:m,videoBitsPerSecond:12e6}),a.ondataavailable=v=>g.push(v.data),a.onstop=()=>{[a,l]=[null,null],t.pause(),r(!1),pp(new Blob(g,{type:m}),`${n}.${m.includes("mp4")?"mp4":"webm"}`),s("The film is among your downloads. springback animate makes one without dropped frames.")},a.start(),r(!0),t.play()}return{picture:h,film:f,drawn(){l&&u(l,i.canvas(!1))},rested(){a?.state==="recording"&&!t.playing&&a.stop()},get recording(){return!!a}}}var Dx=()=>matchMedia("(prefers-color-scheme: dark)").matches,Ux={background:"#f3f5f8",ink:"#222222",faint:"#8c8c8c",line:"#c3cad4",wall:"#7d8794",shapes:["#7d8794","#94806a","#6f8f7c","#8b7a99","#6b8fa3","#a3827f"],mat:"#009e73",ground:"#a8aeb7",metal:"#5b6470",dark:"#30363d",arms:["#0072b2","#d98a00","#009e73","#cc79a7","#3a9bd9","#8c8c8c"],robots:["#0072b2","#d55e00","#007a5a","#a8488a","#8a6d00","#1b2a6b","#6b6b6b","#7a1f1f"],force:"#e69f00",thrust:"#56b4e9",before:"#8c8c8c"},Nx={background:"#14181d",ink:"#e6e9ed",faint:"#9aa3ad",line:"#3a434e",wall:"#98a3b1",shapes:["#98a3b1","#b5a089","#8db39b","#ac9abd","#88b0c6","#c4a19d"],mat:"#2cc79a",ground:"#59626d",metal:"#aab4c0",dark:"#cdd4dc",arms:["#4ea8e0","#f0b429","#35c79b","#e29cc4","#8fd0f5","#a7b0ba"],robots:["#4ea8e0","#ff8a3d","#35c79b","#e29cc4","#e3cf57","#a9b4ff","#c9d1d9","#ff8f8f"],force:"#ffc13d",thrust:"#7cc8f2",before:"#a7b0ba"},Pn=()=>Dx()?Nx:Ux;var mi=Uint8Array,kr=Uint16Array,Fx=Int32Array,gp=new mi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),vp=new mi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Ox=new mi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),xp=function(i,e){for(var t=new kr(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new Fx(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},_p=xp(gp,2),yp=_p.b,Bx=_p.r;yp[28]=258,Bx[258]=28;var bp=xp(vp,0),zx=bp.b,iA=bp.r,wu=new kr(32768);for(Et=0;Et<32768;++Et)ls=(Et&43690)>>1|(Et&21845)<<1,ls=(ls&52428)>>2|(ls&13107)<<2,ls=(ls&61680)>>4|(ls&3855)<<4,wu[Et]=((ls&65280)>>8|(ls&255)<<8)>>1;var ls,Et,Zo=(function(i,e,t){for(var n=i.length,s=0,r=new kr(e);s<n;++s)i[s]&&++r[i[s]-1];var o=new kr(e);for(s=1;s<e;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(t){a=new kr(1<<e);var l=15-e;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],u=e-i[s],h=o[i[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[wu[h]>>l]=c}else for(a=new kr(n),s=0;s<n;++s)i[s]&&(a[s]=wu[o[i[s]-1]++]>>15-i[s]);return a}),Ko=new mi(288);for(Et=0;Et<144;++Et)Ko[Et]=8;var Et;for(Et=144;Et<256;++Et)Ko[Et]=9;var Et;for(Et=256;Et<280;++Et)Ko[Et]=7;var Et;for(Et=280;Et<288;++Et)Ko[Et]=8;var Et,Mp=new mi(32);for(Et=0;Et<32;++Et)Mp[Et]=5;var Et;var kx=Zo(Ko,9,1);var Hx=Zo(Mp,5,1),bu=function(i){for(var e=i[0],t=1;t<i.length;++t)i[t]>e&&(e=i[t]);return e},Ei=function(i,e,t){var n=e/8|0;return(i[n]|i[n+1]<<8)>>(e&7)&t},Mu=function(i,e){var t=e/8|0;return(i[t]|i[t+1]<<8|i[t+2]<<16)>>(e&7)},Vx=function(i){return(i+7)/8|0},Gx=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new mi(i.subarray(e,t))};var Wx=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Ti=function(i,e,t){var n=new Error(e||Wx[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Ti),!t)throw n;return n},Xx=function(i,e,t,n){var s=i.length,r=n?n.length:0;if(!s||e.f&&!e.l)return t||new mi(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new mi(s*3));var c=function(Ve){var dt=t.length;if(Ve>dt){var H=new mi(Math.max(dt*2,Ve));H.set(t),t=H}},u=e.f||0,h=e.p||0,f=e.b||0,m=e.l,g=e.d,v=e.m,p=e.n,d=s*8;do{if(!m){u=Ei(i,h,1);var b=Ei(i,h+1,3);if(h+=3,b)if(b==1)m=kx,g=Hx,v=9,p=5;else if(b==2){var E=Ei(i,h,31)+257,I=Ei(i,h+10,15)+4,D=E+Ei(i,h+5,31)+1;h+=14;for(var w=new mi(D),S=new mi(19),A=0;A<I;++A)S[Ox[A]]=Ei(i,h+A*3,7);h+=I*3;for(var k=bu(S),B=(1<<k)-1,V=Zo(S,k,1),A=0;A<D;){var W=V[Ei(i,h,B)];h+=W&15;var M=W>>4;if(M<16)w[A++]=M;else{var q=0,N=0;for(M==16?(N=3+Ei(i,h,3),h+=2,q=w[A-1]):M==17?(N=3+Ei(i,h,7),h+=3):M==18&&(N=11+Ei(i,h,127),h+=7);N--;)w[A++]=q}}var z=w.subarray(0,E),K=w.subarray(E);v=bu(z),p=bu(K),m=Zo(z,v,1),g=Zo(K,p,1)}else Ti(1);else{var M=Vx(h)+4,y=i[M-4]|i[M-3]<<8,P=M+y;if(P>s){l&&Ti(0);break}a&&c(f+y),t.set(i.subarray(M,P),f),e.b=f+=y,e.p=h=P*8,e.f=u;continue}if(h>d){l&&Ti(0);break}}a&&c(f+131072);for(var ne=(1<<v)-1,te=(1<<p)-1,le=h;;le=h){var q=m[Mu(i,h)&ne],fe=q>>4;if(h+=q&15,h>d){l&&Ti(0);break}if(q||Ti(2),fe<256)t[f++]=fe;else if(fe==256){le=h,m=null;break}else{var ye=fe-254;if(fe>264){var A=fe-257,_e=gp[A];ye=Ei(i,h,(1<<_e)-1)+yp[A],h+=_e}var ee=g[Mu(i,h)&te],Y=ee>>4;ee||Ti(3),h+=ee&15;var K=zx[Y];if(Y>3){var _e=vp[Y];K+=Mu(i,h)&(1<<_e)-1,h+=_e}if(h>d){l&&Ti(0);break}a&&c(f+131072);var pe=f+ye;if(f<K){var xe=r-K,we=Math.min(K,pe);for(xe+f<0&&Ti(3);f<we;++f)t[f]=n[xe+f]}for(;f<pe;++f)t[f]=t[f-K]}}e.l=m,e.p=le,e.b=f,e.f=u,m&&(u=1,e.m=v,e.d=g,e.n=p)}while(!u);return f!=t.length&&o?Gx(t,0,f):t.subarray(0,f)};var qx=new mi(0);var Yx=function(i,e){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Ti(6,"invalid zlib data"),(i[1]>>5&1)==+!e&&Ti(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function wp(i,e){return Xx(i.subarray(Yx(i,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var $x=typeof TextDecoder<"u"&&new TextDecoder,Zx=0;try{$x.decode(qx,{stream:!0}),Zx=1}catch{}var Sp=i=>Uint8Array.from(atob(i),e=>e.charCodeAt(0));function Kx(i,e){let t=wp(Sp(i.data));return i.columns.map(({low:n,step:s},r)=>{let o=2*e*r,a=new Float64Array(e);for(let l=0,c=0;l<e;l++)c=c+t[o+l]+256*t[o+e+l]&65535,a[l]=n+s*c;return a})}function Ep(i){let e=new Map;if(!i)return e;for(let t of["trajectory","telemetry"].filter(n=>i[n])){let n=i[t],s=new Float64Array(Sp(n.t.data).buffer),r=null,o=[];n.columns.forEach(({name:a,unit:l,factor:c,group:u},h)=>e.set(a,{name:a,unit:l,group:u,t:s,held:t==="telemetry",words:i.words[a],get values(){return r??(r=Kx(n,s.length)),r[h]},get shown(){return o[h]??(o[h]=c===1?this.values:this.values.map(f=>c*f)),o[h]}}))}return e}var Jx={f4:Float32Array,f8:Float64Array,i4:Int32Array};function Zt(i){let e=Uint8Array.from(atob(i.data),t=>t.charCodeAt(0));return new Jx[i.type](e.buffer)}function Tp(i){if(i.ready)return i;let e=Zt(i.t),t=Zt(i.force.at),n=new Int32Array(e.length).fill(-1);return t.forEach((s,r)=>n[s]=r),{...i,ready:!0,t:e,n:e.length,begin:e[0],end:e[e.length-1],position:Zt(i.position),attitude:Zt(i.attitude),armLength:Zt(i.arm_length),bends:Zt(i.bends),thrust:Zt(i.thrust),force:Zt(i.force.of),point:Zt(i.point.of),bodies:i.bodies.map(s=>({...s,position:Zt(s.position),attitude:Zt(s.attitude)})),rows:n,series:i.series.map(s=>({...s,values:Zt(s.values)})),signals:Ep(i.signals),every:i.signals?.telemetry?.every??1,shift:0}}function xl(i,e){let t=0,n=i.length-1;if(!(e>i[0]))return 0;for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return i[n]<=e?n:t}function Jo(i,e){let t=Math.min(Math.max(e-i.shift,i.begin),i.end),n=xl(i.t,t),s=Math.min(n+1,i.n-1),r=s>n?(t-i.t[n])/(i.t[s]-i.t[n]):0,o=(g,v,p)=>g[n*v+p]*(1-r)+g[s*v+p]*r,a=(g,v)=>Array.from({length:v},(p,d)=>o(g,v,d)),l=i.arms.length,c=g=>{let v=a(g,4),p=0;for(let b=0;b<4;b++)p+=g[n*4+b]*g[s*4+b];if(p<0)for(let b=0;b<4;b++)v[b]=g[n*4+b];let d=Math.hypot(...v);return v.map(b=>b/d)},u=i.rows[n],h=i.rows[s],f=[],m=i.part.length;for(let g=0;g<m;g++){let v=[0,0,0],p=null;for(let[b,M]of[[u,1-r],[h,r]]){if(b<0)continue;let y=(b*m+g)*3;for(let E=0;E<3;E++)v[E]+=M*i.force[y+E];let P=Array.from(i.point.subarray(y,y+3));P.some(E=>E!==0)&&(p=P)}let d=Math.hypot(...v);f.push(p&&d>1e-6?{part:i.part[g],force:v,size:d,point:p}:null)}return{t:t+i.shift,own:t,place:n,position:a(i.position,3),quaternion:c(i.attitude),armLengths:a(i.armLength,l),bends:i.bends.length?a(i.bends,l):[],thrust:a(i.thrust,i.rotors.length),contacts:f,bodies:i.bodies.map(g=>({position:a(g.position,3),quaternion:c(g.attitude)}))}}function jo({flight:i,t:e=i.t,values:t,held:n=!1},s){let r=Math.min(Math.max(s-i.shift,e[0]),e[e.length-1]),o=xl(e,r),a=n?o:Math.min(o+1,e.length-1),l=a>o?(r-e[o])/(e[a]-e[o]):0;return t[o]*(1-l)+t[a]*l}var Hr=i=>["est_x","est_qw"].every(e=>i.signals.has(e));function Su(i,e){let t=(r,o)=>{let a=i.signals.get(r);return a?jo({flight:i,...a,values:a.values},e):o},n=["w","x","y","z"].map(r=>t(`est_q${r}`)),s=Math.hypot(...n)||1;return{own:Math.min(Math.max(e-i.shift,i.begin),i.end),position:["x","y","z"].map(r=>t(`est_${r}`)),quaternion:n.map(r=>r/s),armLengths:i.arms.map((r,o)=>t(`hall${o+1}`,r.length)),bends:[],thrust:i.rotors.map(()=>0),contacts:[]}}function Cs(i){let e=i.first_touch??i.impacts[0]?.[0]??null;return e===null?null:e+i.shift}function Ap(i,e){let t=i.impacts.map(([n])=>n+i.shift).filter(n=>n<=e);return t.length?t[t.length-1]:null}var _l=i=>i.map(Cs).find(e=>e!==null)??null;function Eu(i){let e=0;for(let t=0;t<i.force.length;t+=3)e=Math.max(e,Math.hypot(i.force[t],i.force[t+1],i.force[t+2]));return e}function Rp(i){let e=i.part.length;return Float32Array.from(i.rows,t=>{let n=[0,0,0];for(let s=0;t>=0&&s<3*e;s++)n[s%3]+=i.force[t*e*3+s];return Math.hypot(...n)})}function Tu(i){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));return e*([5,2,1].find(t=>t*e<=i*1.0000001)??1)}var jx=.005,Vr=[[],[7,3],[2,3],[9,3,2,3],[12,4],[4,2,1,2],[14,3,2,3],[3,6]],Cp={"Arm compression":["largest",i=>Math.max(...i)],Thrust:["all rotors",i=>i.reduce((e,t)=>e+t,0)],Velocity:["speed",i=>i[0]],Energy:["motion",i=>i[0]],"Contact force":["sum of all contacts"]},tr=i=>[...new Set(i.flatMap(e=>e.series.map(t=>t.panel)))],yl=i=>new Map(i.flatMap(e=>[...e.signals])),Qo=i=>i.map(e=>Array.isArray(e)?e.join():e).join(";");function Au(i,e){let t=tr(e),n=yl(e);return i.split(";").flatMap(s=>t.includes(s)?[s]:bl(s.split(",").filter(r=>n.has(r)),n))}function bl(i,e){let t=new Map;for(let n of new Set(i)){let{unit:s,words:r}=e.get(n),o=r?n:s;t.set(o,[...t.get(o)??[],n])}return[...t.values()]}function Pp(i,e){return e.map(t=>Array.isArray(t)?e_(i,t):Qx(i,t)).filter(t=>t.curves.length)}function Qx(i,e){let t=Pn(),n=i.map(o=>o.series.filter(a=>a.panel===e)),s=i.length>1?n.flatMap((o,a)=>t_(e,o,i[a])):n_(n[0]);s.forEach((o,a)=>{o.flight??(o.flight=i[0]),o.t=o.flight.t,o.colour??(o.colour=t.arms[a%t.arms.length]),o.dash??(o.dash=Vr[a%Vr.length])});let r=i.length>1?Cp[e]?.[0]:"";return{key:e,name:r?`${e}, ${r}`:e,unit:n.flat()[0]?.unit,own:null,curves:s}}function e_(i,e){let t=Pn(),n=yl(i),s=i.length>1,r=e.flatMap((c,u)=>i.flatMap(h=>{let f=h.signals.get(c);if(!f)return[];let{t:m,shown:g,held:v}=f,p=s&&e.length===1?h.index:u;return[{name:s?e.length===1?h.label:`${h.label}, ${c}`:c,flight:h,t:m,values:g,held:v,dash:Vr[p%Vr.length],colour:s?h.colour:t.arms[u%t.arms.length]}]})),o=e.map(c=>n.get(c)),a=new Set(o.map(c=>c?.group)),l=e.length===1?e[0]:a.size===1?o[0].group:e.slice(0,3).join(", ")+(e.length>3?", …":"");return{key:e.join(),name:l,unit:o[0]?.unit,own:e,words:o[0]?.words,curves:r}}function t_(i,e,t){if(!e.length)return[];let[,n]=Cp[i]??["",r=>r[0]],s=i==="Contact force"?Rp(t):Float32Array.from(e[0].values,(r,o)=>n(e.map(a=>a.values[o])));return[{name:t.label,values:s,flight:t,colour:t.colour,dash:Vr[t.index%Vr.length]}]}function n_(i){let e=[];for(let t of i){let n=t.values.reduce((r,o)=>Math.max(r,Math.abs(o)),0),s=e.find(r=>{let o=jx*Math.max(n,r.peak);return r.values.every((a,l)=>Math.abs(a-t.values[l])<=o)});s?s.names.push(t.name):e.push({names:[t.name],values:t.values,peak:n})}return e.map(({names:t,values:n})=>({name:i_(t),values:n}))}function i_(i){let e=i.map(t=>t.match(/^(.*?)\s*(\d+)$/));return i.length<2||e.some(t=>!t||t[1]!==e[0][1])?i.join(", "):`${e[0][1]} ${e.map(t=>t[2]).join(", ")}`}function Ip({signals:i,standard:e,onChoose:t}){let n=G("input",{type:"search",placeholder:"est, N, phase, …","aria-label":"Search signals",oninput:b}),s=G("h2",{id:"chooser-title"}),r=G("span",{class:"count",role:"status"}),o=(E,I,D)=>G("label",{"data-words":`${E} ${I}`.toLowerCase()},G("input",{type:"checkbox",value:E,onchange:M}),E,...D?[G("small",{},D)]:[]),a=(E,...I)=>{let D=G("fieldset",{},G("legend",{},E),...I);return I.length>1&&D.firstChild.append(G("button",{type:"button",class:"small","aria-label":`All of ${E}, or none`,onclick:()=>{let w=[...D.querySelectorAll("label:not([hidden]) input")],S=!w.every(A=>A.checked);w.forEach(A=>A.checked=S),M()}},"all")),D},l=a("Standard plots",...e.map(E=>o(E,"standard"))),c=new Map;for(let{name:E,unit:I,group:D}of i.values()){let w=[D,I,I==="m/s²"?"acceleration":""].join(" ");c.set(D,[...c.get(D)??[],o(E,w,I)])}let u=G("div",{class:"signals"},l,...[...c].map(([E,I])=>a(E,...I))),h=G("p",{hidden:!0},"No signal of this flight matches."),f=G("form",{method:"dialog",onsubmit:y},s,G("p",{class:"hint"},"Signals of one unit share a plot. Names are those of the columns in the files of the result."),n,u,h,G("div",{class:"actions"},r,G("button",{type:"button",onclick:()=>(t(null),m.close())},"Only standard plots"),G("button",{type:"button",onclick:()=>m.close()},"Cancel"),G("button",{type:"submit",class:"main"},"Plot"))),m=G("dialog",{class:"chooser","aria-labelledby":"chooser-title"},f),g=[],v=null,p=E=>[...E.querySelectorAll("input[type=checkbox]:checked")].map(I=>I.value),d=()=>[...u.children].filter(E=>E!==l).flatMap(p);function b(){let E=n.value.toLowerCase().split(/\s+/).filter(Boolean);for(let I of u.children){let D=[...I.querySelectorAll("label")];D.forEach(w=>w.hidden=!E.every(S=>w.dataset.words.includes(S))),I.hidden=D.every(w=>w.hidden)||I===l&&v!==null}h.hidden=[...u.children].some(I=>!I.hidden)}function M(){let E=d(),I=bl(E,i).length;r.textContent=E.length?`${E.length} signal${E.length>1?"s":""} in ${I} plot${I>1?"s":""}`:""}function y(){let E=bl(d(),i);if(v!==null)t(g.flatMap((I,D)=>D===v?E:[I]));else{let I=p(l),D=g.filter(w=>Array.isArray(w)||I.includes(w));t([...D,...I.filter(w=>!g.includes(w)),...E])}}function P(E,I=null){[g,v]=[E,I];let D=I===null?E.filter(w=>!Array.isArray(w)):E[I];u.querySelectorAll("input").forEach(w=>w.checked=D.includes(w.value)),s.textContent=I===null?"Add plots":"Change a plot",n.value="",b(),M(),m.showModal(),n.focus()}return{element:m,open:P}}function Ml(i,e){let t=()=>document.fullscreenElement?document.exitFullscreen():i().requestFullscreen().catch(e),n=G("button",{type:"button",class:"tool tool-full",hidden:!document.fullscreenEnabled,onclick:t},Yi("full"));function s(){let r=document.fullscreenElement?"Leave full screen":"Full screen";n.title=`${r} (F)`,n.setAttribute("aria-label",r)}return document.addEventListener("fullscreenchange",s),s(),{button:n,toggle:t}}function Lp({read:i,apply:e}){let t=0,n=location.hash,s=()=>{let a=Object.entries(i()).filter(([,l])=>l!=="");return`#${new URLSearchParams(a)}`.replace(/%2C/g,",").replace(/%3B/g,";")};function r(){clearTimeout(t),n=s();try{history.replaceState(null,"",n)}catch{}}addEventListener("hashchange",()=>{location.hash!==n&&o()});function o(){e(Object.fromEntries(new URLSearchParams(location.hash.slice(1))))}return{follow:o,renew(){clearTimeout(t),t=setTimeout(r,250)},address(){return r(),location.href.replace(/#.*/,"")+n}}}var Hs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Vs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},cm=0,ff=1,hm=2;var df=1,um=2,Qi=3,gs=0,Wn=1,Sn=2,xs=0,ar=1,pf=2,mf=3,gf=4,fm=5,Os=100,dm=101,pm=102,mm=103,gm=104,vm=200,xm=201,_m=202,ym=203,Ql=204,ec=205,bm=206,Mm=207,wm=208,Sm=209,Em=210,Tm=211,Am=212,Rm=213,Cm=214,Lc=0,Dc=1,Uc=2,lr=3,Nc=4,Fc=5,Oc=6,Bc=7,vf=0,Pm=1,Im=2,_s=0,Lm=1,Dm=2,Um=3,Nm=4,Fm=5,Om=6,Bm=7;var xf=300,gr=301,vr=302,zc=303,kc=304,Ha=306,tc=1e3,Fs=1001,nc=1002,vi=1003,zm=1004;var Va=1005;var Li=1006,Hc=1007;var Gs=1008;var Fi=1009,_f=1010,yf=1011,bo=1012,Vc=1013,Ws=1014,es=1015,Mo=1016,Gc=1017,Wc=1018,wo=1020,bf=35902,Mf=35899,wf=1021,Sf=1022,xi=1023,co=1026,So=1027,Ef=1028,Xc=1029,Tf=1030,qc=1031;var Yc=1033,Ga=33776,Wa=33777,Xa=33778,qa=33779,$c=35840,Zc=35841,Kc=35842,Jc=35843,jc=36196,Qc=37492,eh=37496,th=37808,nh=37809,ih=37810,sh=37811,rh=37812,oh=37813,ah=37814,lh=37815,ch=37816,hh=37817,uh=37818,fh=37819,dh=37820,ph=37821,mh=36492,gh=36494,vh=36495,xh=36283,_h=36284,yh=36285,bh=36286;var ua=2300,ic=2301,jl=2302,rf=2400,of=2401,af=2402;var km=3200,Hm=3201;var Af=0,Vm=1,ys="",Gn="srgb",cr="srgb-linear",fa="linear",Pt="srgb";var or=7680,Mh=7681;var wh=517;var lf=519,Gm=512,Wm=513,Xm=514,Rf=515,qm=516,Ym=517,$m=518,Zm=519,sc=35044;var Cf="300 es",Ii=2e3,da=2001;var Zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},In=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Dp=1234567,ao=Math.PI/180,ho=180/Math.PI;function ps(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(In[i&255]+In[i>>8&255]+In[i>>16&255]+In[i>>24&255]+"-"+In[e&255]+In[e>>8&255]+"-"+In[e>>16&15|64]+In[e>>24&255]+"-"+In[t&63|128]+In[t>>8&255]+"-"+In[t>>16&255]+In[t>>24&255]+In[n&255]+In[n>>8&255]+In[n>>16&255]+In[n>>24&255]).toLowerCase()}function it(i,e,t){return Math.max(e,Math.min(t,i))}function Pf(i,e){return(i%e+e)%e}function s_(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function r_(i,e,t){return i!==e?(t-i)/(e-i):0}function la(i,e,t){return(1-t)*i+t*e}function o_(i,e,t,n){return la(i,e,1-Math.exp(-t*n))}function a_(i,e=1){return e-Math.abs(Pf(i,e*2)-e)}function l_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function c_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function h_(i,e){return i+Math.floor(Math.random()*(e-i+1))}function u_(i,e){return i+Math.random()*(e-i)}function f_(i){return i*(.5-Math.random())}function d_(i){i!==void 0&&(Dp=i);let e=Dp+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function p_(i){return i*ao}function m_(i){return i*ho}function g_(i){return(i&i-1)===0&&i!==0}function v_(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function x_(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function __(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),f=o((e-n)/2),m=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*g,l*m,a*c);break;case"YXY":i.set(l*m,a*u,l*g,a*c);break;case"ZYZ":i.set(l*g,l*m,a*u,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Pi(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Ct(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Xs={DEG2RAD:ao,RAD2DEG:ho,generateUUID:ps,clamp:it,euclideanModulo:Pf,mapLinear:s_,inverseLerp:r_,lerp:la,damp:o_,pingpong:a_,smoothstep:l_,smootherstep:c_,randInt:h_,randFloat:u_,randFloatSpread:f_,seededRandom:d_,degToRad:p_,radToDeg:m_,isPowerOfTwo:g_,ceilPowerOfTwo:v_,floorPowerOfTwo:x_,setQuaternionFromProperEuler:__,normalize:Ct,denormalize:Pi},Be=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(it(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},sn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],m=r[o+1],g=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=f,e[t+1]=m,e[t+2]=g,e[t+3]=v;return}if(h!==v||l!==f||c!==m||u!==g){let p=1-a,d=l*f+c*m+u*g+h*v,b=d>=0?1:-1,M=1-d*d;if(M>Number.EPSILON){let P=Math.sqrt(M),E=Math.atan2(P,d*b);p=Math.sin(p*E)/P,a=Math.sin(a*E)/P}let y=a*b;if(l=l*p+f*y,c=c*p+m*y,u=u*p+g*y,h=h*p+v*y,p===1-a){let P=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=P,c*=P,u*=P,h*=P}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],m=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*m-c*f,e[t+1]=l*g+u*f+c*h-a*m,e[t+2]=c*g+u*m+a*f-l*h,e[t+3]=u*g-a*h-l*f-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),m=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h-f*m*g;break;case"YXZ":this._x=f*u*h+c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h+f*m*g;break;case"ZXY":this._x=f*u*h-c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h-f*m*g;break;case"ZYX":this._x=f*u*h-c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h+f*m*g;break;case"YZX":this._x=f*u*h+c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h-f*m*g;break;case"XZY":this._x=f*u*h-c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h+f*m*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=n+a+h;if(f>0){let m=.5/Math.sqrt(f+1);this._w=.25/m,this._x=(u-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(n>a&&n>h){let m=2*Math.sqrt(1+n-a-h);this._w=(u-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>h){let m=2*Math.sqrt(1+a-n-h);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+u)/m}else{let m=2*Math.sqrt(1+h-n-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+u)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(it(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let m=1-t;return this._w=m*o+t*this._w,this._x=m*n+t*this._x,this._y=m*s+t*this._y,this._z=m*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,f=Math.sin(t*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},L=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Up.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Up.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this.z=it(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this.z=it(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Ru.copy(this).projectOnVector(e),this.sub(Ru)}reflect(e){return this.sub(Ru.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(it(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ru=new L,Up=new sn,ct=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],m=n[5],g=n[8],v=s[0],p=s[3],d=s[6],b=s[1],M=s[4],y=s[7],P=s[2],E=s[5],I=s[8];return r[0]=o*v+a*b+l*P,r[3]=o*p+a*M+l*E,r[6]=o*d+a*y+l*I,r[1]=c*v+u*b+h*P,r[4]=c*p+u*M+h*E,r[7]=c*d+u*y+h*I,r[2]=f*v+m*b+g*P,r[5]=f*p+m*M+g*E,r[8]=f*d+m*y+g*I,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,m=c*r-o*l,g=t*h+n*f+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return e[0]=h*v,e[1]=(s*c-u*n)*v,e[2]=(a*n-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=m*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Cu.makeScale(e,t)),this}rotate(e){return this.premultiply(Cu.makeRotation(-e)),this}translate(e,t){return this.premultiply(Cu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Cu=new ct;function If(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function pa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Km(){let i=pa("canvas");return i.style.display="block",i}var Np={};function uo(i){i in Np||(Np[i]=!0,console.warn(i))}function Jm(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Fp=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Op=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function y_(){let i={enabled:!0,workingColorSpace:cr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=lo(s.r),s.g=lo(s.g),s.b=lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?fa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return uo("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return uo("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[cr]:{primaries:e,whitePoint:n,transfer:fa,toXYZ:Fp,fromXYZ:Op,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Gn},outputColorSpaceConfig:{drawingBufferColorSpace:Gn}},[Gn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:Fp,fromXYZ:Op,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Gn}}}),i}var xt=y_();function ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function lo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Gr,rc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Gr===void 0&&(Gr=pa("canvas")),Gr.width=e.width,Gr.height=e.height;let s=Gr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Gr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=pa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ms(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ms(t[n]/255)*255):t[n]=ms(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},b_=0,fo=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:b_++}),this.uuid=ps(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Pu(s[o].image)):r.push(Pu(s[o]))}else r=Pu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Pu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?rc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var M_=0,Iu=new L,Kn=class i extends Zi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Fs,s=Fs,r=Li,o=Gs,a=xi,l=Fi,c=i.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:M_++}),this.uuid=ps(),this.name="",this.source=new fo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Be(0,0),this.repeat=new Be(1,1),this.center=new Be(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Iu).x}get height(){return this.source.getSize(Iu).y}get depth(){return this.source.getSize(Iu).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==xf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case tc:e.x=e.x-Math.floor(e.x);break;case Fs:e.x=e.x<0?0:1;break;case nc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case tc:e.y=e.y-Math.floor(e.y);break;case Fs:e.y=e.y<0?0:1;break;case nc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=xf;Kn.DEFAULT_ANISOTROPY=1;var It=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],m=l[5],g=l[9],v=l[2],p=l[6],d=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+p)<.1&&Math.abs(c+m+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,y=(m+1)/2,P=(d+1)/2,E=(u+f)/4,I=(h+v)/4,D=(g+p)/4;return M>y&&M>P?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=E/n,r=I/n):y>P?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=E/s,r=D/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=I/r,s=D/r),this.set(n,s,r,t),this}let b=Math.sqrt((p-g)*(p-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(b)<.001&&(b=1),this.x=(p-g)/b,this.y=(h-v)/b,this.z=(f-u)/b,this.w=Math.acos((c+m+d-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this.z=it(this.z,e.z,t.z),this.w=it(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this.z=it(this.z,e,t),this.w=it(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},oc=class extends Zi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Li,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new It(0,0,e,t),this.scissorTest=!1,this.viewport=new It(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new Kn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:Li,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new fo(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ki=class extends oc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ma=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=vi,this.minFilter=vi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ac=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=vi,this.minFilter=vi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var an=class{constructor(e=new L(1/0,1/0,1/0),t=new L(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ai.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ai.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ai.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(e.matrixWorld),this.expandByPoint(Ai);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),wl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),wl.copy(n.boundingBox)),wl.applyMatrix4(e.matrixWorld),this.union(wl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ai),Ai.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ea),Sl.subVectors(this.max,ea),Wr.subVectors(e.a,ea),Xr.subVectors(e.b,ea),qr.subVectors(e.c,ea),Ps.subVectors(Xr,Wr),Is.subVectors(qr,Xr),nr.subVectors(Wr,qr);let t=[0,-Ps.z,Ps.y,0,-Is.z,Is.y,0,-nr.z,nr.y,Ps.z,0,-Ps.x,Is.z,0,-Is.x,nr.z,0,-nr.x,-Ps.y,Ps.x,0,-Is.y,Is.x,0,-nr.y,nr.x,0];return!Lu(t,Wr,Xr,qr,Sl)||(t=[1,0,0,0,1,0,0,0,1],!Lu(t,Wr,Xr,qr,Sl))?!1:(El.crossVectors(Ps,Is),t=[El.x,El.y,El.z],Lu(t,Wr,Xr,qr,Sl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ai).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ai).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(cs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},cs=[new L,new L,new L,new L,new L,new L,new L,new L],Ai=new L,wl=new an,Wr=new L,Xr=new L,qr=new L,Ps=new L,Is=new L,nr=new L,ea=new L,Sl=new L,El=new L,ir=new L;function Lu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ir.fromArray(i,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=e.dot(ir),c=t.dot(ir),u=n.dot(ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var w_=new an,ta=new L,Du=new L,Di=class{constructor(e=new L,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):w_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ta.subVectors(e,this.center);let t=ta.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ta,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Du.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ta.copy(e.center).add(Du)),this.expandByPoint(ta.copy(e.center).sub(Du))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},hs=new L,Uu=new L,Tl=new L,Ls=new L,Nu=new L,Al=new L,Fu=new L,hr=class{constructor(e=new L,t=new L(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,hs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=hs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(hs.copy(this.origin).addScaledVector(this.direction,t),hs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Uu.copy(e).add(t).multiplyScalar(.5),Tl.copy(t).sub(e).normalize(),Ls.copy(this.origin).sub(Uu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Tl),a=Ls.dot(this.direction),l=-Ls.dot(Tl),c=Ls.lengthSq(),u=Math.abs(1-o*o),h,f,m,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let v=1/u;h*=v,f*=v,m=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),m=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),m=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),m=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Uu).addScaledVector(Tl,f),m}intersectSphere(e,t){hs.subVectors(e.center,this.origin);let n=hs.dot(this.direction),s=hs.dot(hs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,hs)!==null}intersectTriangle(e,t,n,s,r){Nu.subVectors(t,e),Al.subVectors(n,e),Fu.crossVectors(Nu,Al);let o=this.direction.dot(Fu),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ls.subVectors(this.origin,e);let l=a*this.direction.dot(Al.crossVectors(Ls,Al));if(l<0)return null;let c=a*this.direction.dot(Nu.cross(Ls));if(c<0||l+c>o)return null;let u=-a*Ls.dot(Fu);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ut=class i{constructor(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p)}set(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p){let d=this.elements;return d[0]=e,d[4]=t,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=h,d[14]=f,d[3]=m,d[7]=g,d[11]=v,d[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/Yr.setFromMatrixColumn(e,0).length(),r=1/Yr.setFromMatrixColumn(e,1).length(),o=1/Yr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,m=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=m+g*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=g+m*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,m=l*h,g=c*u,v=c*h;t[0]=f+v*a,t[4]=g*a-m,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=m*a-g,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,m=l*h,g=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=g+m*a,t[1]=m+g*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,m=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=g*c-m,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,m=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=g*h+m,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=m*h+g,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,m=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=m*h-g,t[2]=g*h-m,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(S_,e,E_)}lookAt(e,t,n){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Ds.crossVectors(n,si),Ds.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Ds.crossVectors(n,si)),Ds.normalize(),Rl.crossVectors(si,Ds),s[0]=Ds.x,s[4]=Rl.x,s[8]=si.x,s[1]=Ds.y,s[5]=Rl.y,s[9]=si.y,s[2]=Ds.z,s[6]=Rl.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],m=n[13],g=n[2],v=n[6],p=n[10],d=n[14],b=n[3],M=n[7],y=n[11],P=n[15],E=s[0],I=s[4],D=s[8],w=s[12],S=s[1],A=s[5],k=s[9],B=s[13],V=s[2],W=s[6],q=s[10],N=s[14],z=s[3],K=s[7],ne=s[11],te=s[15];return r[0]=o*E+a*S+l*V+c*z,r[4]=o*I+a*A+l*W+c*K,r[8]=o*D+a*k+l*q+c*ne,r[12]=o*w+a*B+l*N+c*te,r[1]=u*E+h*S+f*V+m*z,r[5]=u*I+h*A+f*W+m*K,r[9]=u*D+h*k+f*q+m*ne,r[13]=u*w+h*B+f*N+m*te,r[2]=g*E+v*S+p*V+d*z,r[6]=g*I+v*A+p*W+d*K,r[10]=g*D+v*k+p*q+d*ne,r[14]=g*w+v*B+p*N+d*te,r[3]=b*E+M*S+y*V+P*z,r[7]=b*I+M*A+y*W+P*K,r[11]=b*D+M*k+y*q+P*ne,r[15]=b*w+M*B+y*N+P*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],m=e[14],g=e[3],v=e[7],p=e[11],d=e[15];return g*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*m-n*l*m)+v*(+t*l*m-t*c*f+r*o*f-s*o*m+s*c*u-r*l*u)+p*(+t*c*h-t*a*m-r*o*h+n*o*m+r*a*u-n*c*u)+d*(-s*a*u-t*l*h+t*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],m=e[11],g=e[12],v=e[13],p=e[14],d=e[15],b=h*p*c-v*f*c+v*l*m-a*p*m-h*l*d+a*f*d,M=g*f*c-u*p*c-g*l*m+o*p*m+u*l*d-o*f*d,y=u*v*c-g*h*c+g*a*m-o*v*m-u*a*d+o*h*d,P=g*h*l-u*v*l-g*a*f+o*v*f+u*a*p-o*h*p,E=t*b+n*M+s*y+r*P;if(E===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let I=1/E;return e[0]=b*I,e[1]=(v*f*r-h*p*r-v*s*m+n*p*m+h*s*d-n*f*d)*I,e[2]=(a*p*r-v*l*r+v*s*c-n*p*c-a*s*d+n*l*d)*I,e[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*m-n*l*m)*I,e[4]=M*I,e[5]=(u*p*r-g*f*r+g*s*m-t*p*m-u*s*d+t*f*d)*I,e[6]=(g*l*r-o*p*r-g*s*c+t*p*c+o*s*d-t*l*d)*I,e[7]=(o*f*r-u*l*r+u*s*c-t*f*c-o*s*m+t*l*m)*I,e[8]=y*I,e[9]=(g*h*r-u*v*r-g*n*m+t*v*m+u*n*d-t*h*d)*I,e[10]=(o*v*r-g*a*r+g*n*c-t*v*c-o*n*d+t*a*d)*I,e[11]=(u*a*r-o*h*r-u*n*c+t*h*c+o*n*m-t*a*m)*I,e[12]=P*I,e[13]=(u*v*s-g*h*s+g*n*f-t*v*f-u*n*p+t*h*p)*I,e[14]=(g*a*s-o*v*s-g*n*l+t*v*l+o*n*p-t*a*p)*I,e[15]=(o*h*s-u*a*s+u*n*l-t*h*l-o*n*f+t*a*f)*I,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,m=r*u,g=r*h,v=o*u,p=o*h,d=a*h,b=l*c,M=l*u,y=l*h,P=n.x,E=n.y,I=n.z;return s[0]=(1-(v+d))*P,s[1]=(m+y)*P,s[2]=(g-M)*P,s[3]=0,s[4]=(m-y)*E,s[5]=(1-(f+d))*E,s[6]=(p+b)*E,s[7]=0,s[8]=(g+M)*I,s[9]=(p-b)*I,s[10]=(1-(f+v))*I,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=Yr.set(s[0],s[1],s[2]).length(),o=Yr.set(s[4],s[5],s[6]).length(),a=Yr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Ri.copy(this);let c=1/r,u=1/o,h=1/a;return Ri.elements[0]*=c,Ri.elements[1]*=c,Ri.elements[2]*=c,Ri.elements[4]*=u,Ri.elements[5]*=u,Ri.elements[6]*=u,Ri.elements[8]*=h,Ri.elements[9]*=h,Ri.elements[10]*=h,t.setFromRotationMatrix(Ri),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),f=(t+e)/(t-e),m=(n+s)/(n-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===Ii)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===da)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),f=-(t+e)/(t-e),m=-(n+s)/(n-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===Ii)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===da)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Yr=new L,Ri=new Ut,S_=new L(0,0,0),E_=new L(1,1,1),Ds=new L,Rl=new L,si=new L,Bp=new Ut,zp=new sn,Ui=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(it(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-it(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(it(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-it(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(it(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-it(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Bp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Bp,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return zp.setFromEuler(this),this.setFromQuaternion(zp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ui.DEFAULT_ORDER="XYZ";var ga=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},T_=0,kp=new L,$r=new sn,us=new Ut,Cl=new L,na=new L,A_=new L,R_=new sn,Hp=new L(1,0,0),Vp=new L(0,1,0),Gp=new L(0,0,1),Wp={type:"added"},C_={type:"removed"},Zr={type:"childadded",child:null},Ou={type:"childremoved",child:null},ln=class i extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:T_++}),this.uuid=ps(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new L,t=new Ui,n=new sn,s=new L(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ut},normalMatrix:{value:new ct}}),this.matrix=new Ut,this.matrixWorld=new Ut,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ga,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.multiply($r),this}rotateOnWorldAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.premultiply($r),this}rotateX(e){return this.rotateOnAxis(Hp,e)}rotateY(e){return this.rotateOnAxis(Vp,e)}rotateZ(e){return this.rotateOnAxis(Gp,e)}translateOnAxis(e,t){return kp.copy(e).applyQuaternion(this.quaternion),this.position.add(kp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Hp,e)}translateY(e){return this.translateOnAxis(Vp,e)}translateZ(e){return this.translateOnAxis(Gp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(us.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Cl.copy(e):Cl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?us.lookAt(na,Cl,this.up):us.lookAt(Cl,na,this.up),this.quaternion.setFromRotationMatrix(us),s&&(us.extractRotation(s.matrixWorld),$r.setFromRotationMatrix(us),this.quaternion.premultiply($r.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Wp),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(C_),Ou.child=e,this.dispatchEvent(Ou),Ou.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),us.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),us.multiply(e.parent.matrixWorld)),e.applyMatrix4(us),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Wp),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,e,A_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,R_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),m=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};ln.DEFAULT_UP=new L(0,1,0);ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ci=new L,fs=new L,Bu=new L,ds=new L,Kr=new L,Jr=new L,Xp=new L,zu=new L,ku=new L,Hu=new L,Vu=new It,Gu=new It,Wu=new It,$i=class i{constructor(e=new L,t=new L,n=new L){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ci.subVectors(e,t),s.cross(Ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ci.subVectors(s,t),fs.subVectors(n,t),Bu.subVectors(e,t);let o=Ci.dot(Ci),a=Ci.dot(fs),l=Ci.dot(Bu),c=fs.dot(fs),u=fs.dot(Bu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,m=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-m-g,g,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ds)===null?!1:ds.x>=0&&ds.y>=0&&ds.x+ds.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ds.x),l.addScaledVector(o,ds.y),l.addScaledVector(a,ds.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Vu.setScalar(0),Gu.setScalar(0),Wu.setScalar(0),Vu.fromBufferAttribute(e,t),Gu.fromBufferAttribute(e,n),Wu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Vu,r.x),o.addScaledVector(Gu,r.y),o.addScaledVector(Wu,r.z),o}static isFrontFacing(e,t,n,s){return Ci.subVectors(n,t),fs.subVectors(e,t),Ci.cross(fs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ci.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ci.cross(fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Kr.subVectors(s,n),Jr.subVectors(r,n),zu.subVectors(e,n);let l=Kr.dot(zu),c=Jr.dot(zu);if(l<=0&&c<=0)return t.copy(n);ku.subVectors(e,s);let u=Kr.dot(ku),h=Jr.dot(ku);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(n).addScaledVector(Kr,o);Hu.subVectors(e,r);let m=Kr.dot(Hu),g=Jr.dot(Hu);if(g>=0&&m<=g)return t.copy(r);let v=m*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Jr,a);let p=u*g-m*h;if(p<=0&&h-u>=0&&m-g>=0)return Xp.subVectors(r,s),a=(h-u)/(h-u+(m-g)),t.copy(s).addScaledVector(Xp,a);let d=1/(p+v+f);return o=v*d,a=f*d,t.copy(n).addScaledVector(Kr,o).addScaledVector(Jr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},jm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Us={h:0,s:0,l:0},Pl={h:0,s:0,l:0};function Xu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var at=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Gn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=n,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=xt.workingColorSpace){if(e=Pf(e,1),t=it(t,0,1),n=it(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Xu(o,r,e+1/3),this.g=Xu(o,r,e),this.b=Xu(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=Gn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Gn){let n=jm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ms(e.r),this.g=ms(e.g),this.b=ms(e.b),this}copyLinearToSRGB(e){return this.r=lo(e.r),this.g=lo(e.g),this.b=lo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Gn){return xt.workingToColorSpace(Ln.copy(this),e),Math.round(it(Ln.r*255,0,255))*65536+Math.round(it(Ln.g*255,0,255))*256+Math.round(it(Ln.b*255,0,255))}getHexString(e=Gn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Ln.copy(this),t);let n=Ln.r,s=Ln.g,r=Ln.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Ln.copy(this),t),e.r=Ln.r,e.g=Ln.g,e.b=Ln.b,e}getStyle(e=Gn){xt.workingToColorSpace(Ln.copy(this),e);let t=Ln.r,n=Ln.g,s=Ln.b;return e!==Gn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Us),this.setHSL(Us.h+e,Us.s+t,Us.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Us),e.getHSL(Pl);let n=la(Us.h,Pl.h,t),s=la(Us.s,Pl.s,t),r=la(Us.l,Pl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ln=new at;at.NAMES=jm;var P_=0,Ji=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:P_++}),this.uuid=ps(),this.name="",this.type="Material",this.blending=ar,this.side=gs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ql,this.blendDst=ec,this.blendEquation=Os,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=lr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=lf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=or,this.stencilZFail=or,this.stencilZPass=or,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==ar&&(n.blending=this.blending),this.side!==gs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Ql&&(n.blendSrc=this.blendSrc),this.blendDst!==ec&&(n.blendDst=this.blendDst),this.blendEquation!==Os&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==lr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==lf&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==or&&(n.stencilFail=this.stencilFail),this.stencilZFail!==or&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==or&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},oi=class extends Ji{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.combine=vf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var nn=new L,Il=new Be,I_=0,Jt=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:I_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=sc,this.updateRanges=[],this.gpuType=es,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Il.fromBufferAttribute(this,t),Il.applyMatrix3(e),this.setXY(t,Il.x,Il.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix3(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix4(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyNormalMatrix(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.transformDirection(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ct(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Pi(t,this.array)),t}setX(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Pi(t,this.array)),t}setY(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Pi(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Pi(t,this.array)),t}setW(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array),r=Ct(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==sc&&(e.usage=this.usage),e}};var va=class extends Jt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var xa=class extends Jt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var mt=class extends Jt{constructor(e,t,n){super(new Float32Array(e),t,n)}},L_=0,gi=new Ut,qu=new ln,jr=new L,ri=new an,ia=new an,yn=new L,Ot=class i extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:L_++}),this.uuid=ps(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(If(e)?xa:va)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ct().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return gi.makeRotationFromQuaternion(e),this.applyMatrix4(gi),this}rotateX(e){return gi.makeRotationX(e),this.applyMatrix4(gi),this}rotateY(e){return gi.makeRotationY(e),this.applyMatrix4(gi),this}rotateZ(e){return gi.makeRotationZ(e),this.applyMatrix4(gi),this}translate(e,t,n){return gi.makeTranslation(e,t,n),this.applyMatrix4(gi),this}scale(e,t,n){return gi.makeScale(e,t,n),this.applyMatrix4(gi),this}lookAt(e){return qu.lookAt(e),qu.updateMatrix(),this.applyMatrix4(qu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jr).negate(),this.translate(jr.x,jr.y,jr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new an);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new L(-1/0,-1/0,-1/0),new L(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(yn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(yn),yn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(yn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new L,1/0);return}if(e){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(yn.addVectors(ri.min,ia.min),ri.expandByPoint(yn),yn.addVectors(ri.max,ia.max),ri.expandByPoint(yn)):(ri.expandByPoint(ia.min),ri.expandByPoint(ia.max))}ri.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)yn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(yn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)yn.fromBufferAttribute(a,c),l&&(jr.fromBufferAttribute(e,c),yn.add(jr)),s=Math.max(s,n.distanceToSquared(yn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Jt(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let D=0;D<n.count;D++)a[D]=new L,l[D]=new L;let c=new L,u=new L,h=new L,f=new Be,m=new Be,g=new Be,v=new L,p=new L;function d(D,w,S){c.fromBufferAttribute(n,D),u.fromBufferAttribute(n,w),h.fromBufferAttribute(n,S),f.fromBufferAttribute(r,D),m.fromBufferAttribute(r,w),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),m.sub(f),g.sub(f);let A=1/(m.x*g.y-g.x*m.y);isFinite(A)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-m.y).multiplyScalar(A),p.copy(h).multiplyScalar(m.x).addScaledVector(u,-g.x).multiplyScalar(A),a[D].add(v),a[w].add(v),a[S].add(v),l[D].add(p),l[w].add(p),l[S].add(p))}let b=this.groups;b.length===0&&(b=[{start:0,count:e.count}]);for(let D=0,w=b.length;D<w;++D){let S=b[D],A=S.start,k=S.count;for(let B=A,V=A+k;B<V;B+=3)d(e.getX(B+0),e.getX(B+1),e.getX(B+2))}let M=new L,y=new L,P=new L,E=new L;function I(D){P.fromBufferAttribute(s,D),E.copy(P);let w=a[D];M.copy(w),M.sub(P.multiplyScalar(P.dot(w))).normalize(),y.crossVectors(E,w);let A=y.dot(l[D])<0?-1:1;o.setXYZW(D,M.x,M.y,M.z,A)}for(let D=0,w=b.length;D<w;++D){let S=b[D],A=S.start,k=S.count;for(let B=A,V=A+k;B<V;B+=3)I(e.getX(B+0)),I(e.getX(B+1)),I(e.getX(B+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Jt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,m=n.count;f<m;f++)n.setXYZ(f,0,0,0);let s=new L,r=new L,o=new L,a=new L,l=new L,c=new L,u=new L,h=new L;if(e)for(let f=0,m=e.count;f<m;f+=3){let g=e.getX(f+0),v=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,p),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,m=t.count;f<m;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)yn.fromBufferAttribute(e,t),yn.normalize(),e.setXYZ(t,yn.x,yn.y,yn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),m=0,g=0;for(let v=0,p=l.length;v<p;v++){a.isInterleavedBufferAttribute?m=l[v]*a.data.stride+a.offset:m=l[v]*u;for(let d=0;d<u;d++)f[g++]=c[m++]}return new Jt(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],m=e(f,n);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let m=c[h];u.push(m.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,m=h.length;f<m;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},qp=new Ut,sr=new hr,Ll=new Di,Yp=new L,Dl=new L,Ul=new L,Nl=new L,Yu=new L,Fl=new L,$p=new L,Ol=new L,Je=class extends ln{constructor(e=new Ot,t=new oi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Fl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Yu.fromBufferAttribute(h,e),o?Fl.addScaledVector(Yu,u):Fl.addScaledVector(Yu.sub(t),u))}t.add(Fl)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ll.copy(n.boundingSphere),Ll.applyMatrix4(r),sr.copy(e.ray).recast(e.near),!(Ll.containsPoint(sr.origin)===!1&&(sr.intersectSphere(Ll,Yp)===null||sr.origin.distanceToSquared(Yp)>(e.far-e.near)**2))&&(qp.copy(r).invert(),sr.copy(e.ray).applyMatrix4(qp),!(n.boundingBox!==null&&sr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,sr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let p=f[g],d=o[p.materialIndex],b=Math.max(p.start,m.start),M=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let y=b,P=M;y<P;y+=3){let E=a.getX(y),I=a.getX(y+1),D=a.getX(y+2);s=Bl(this,d,e,n,c,u,h,E,I,D),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),v=Math.min(a.count,m.start+m.count);for(let p=g,d=v;p<d;p+=3){let b=a.getX(p),M=a.getX(p+1),y=a.getX(p+2);s=Bl(this,o,e,n,c,u,h,b,M,y),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let p=f[g],d=o[p.materialIndex],b=Math.max(p.start,m.start),M=Math.min(l.count,Math.min(p.start+p.count,m.start+m.count));for(let y=b,P=M;y<P;y+=3){let E=y,I=y+1,D=y+2;s=Bl(this,d,e,n,c,u,h,E,I,D),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),v=Math.min(l.count,m.start+m.count);for(let p=g,d=v;p<d;p+=3){let b=p,M=p+1,y=p+2;s=Bl(this,o,e,n,c,u,h,b,M,y),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function D_(i,e,t,n,s,r,o,a){let l;if(e.side===Wn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===gs,a),l===null)return null;Ol.copy(a),Ol.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Ol);return c<t.near||c>t.far?null:{distance:c,point:Ol.clone(),object:i}}function Bl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Dl),i.getVertexPosition(l,Ul),i.getVertexPosition(c,Nl);let u=D_(i,e,t,n,Dl,Ul,Nl,$p);if(u){let h=new L;$i.getBarycoord($p,Dl,Ul,Nl,h),s&&(u.uv=$i.getInterpolatedAttribute(s,a,l,c,h,new Be)),r&&(u.uv1=$i.getInterpolatedAttribute(r,a,l,c,h,new Be)),o&&(u.normal=$i.getInterpolatedAttribute(o,a,l,c,h,new L),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new L,materialIndex:0};$i.getNormal(Dl,Ul,Nl,f.normal),u.face=f,u.barycoord=h}return u}var ji=class i extends Ot{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,m=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(h,2));function g(v,p,d,b,M,y,P,E,I,D,w){let S=y/I,A=P/D,k=y/2,B=P/2,V=E/2,W=I+1,q=D+1,N=0,z=0,K=new L;for(let ne=0;ne<q;ne++){let te=ne*A-B;for(let le=0;le<W;le++){let fe=le*S-k;K[v]=fe*b,K[p]=te*M,K[d]=V,c.push(K.x,K.y,K.z),K[v]=0,K[p]=0,K[d]=E>0?1:-1,u.push(K.x,K.y,K.z),h.push(le/I),h.push(1-ne/D),N+=1}}for(let ne=0;ne<D;ne++)for(let te=0;te<I;te++){let le=f+te+W*ne,fe=f+te+W*(ne+1),ye=f+(te+1)+W*(ne+1),_e=f+(te+1)+W*ne;l.push(le,fe,_e),l.push(fe,ye,_e),z+=6}a.addGroup(m,z,w),m+=z,f+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function xr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Un(i){let e={};for(let t=0;t<i.length;t++){let n=xr(i[t]);for(let s in n)e[s]=n[s]}return e}function U_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Lf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var Ya={clone:xr,merge:Un},N_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,F_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ai=class extends Ji{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=N_,this.fragmentShader=F_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=xr(e.uniforms),this.uniformsGroups=U_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},_a=class extends ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ut,this.projectionMatrix=new Ut,this.projectionMatrixInverse=new Ut,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Ns=new L,Zp=new Be,Kp=new Be,Dn=class extends _a{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ho*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ao*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ho*2*Math.atan(Math.tan(ao*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z)}getViewSize(e,t){return this.getViewBounds(e,Zp,Kp),t.subVectors(Kp,Zp)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ao*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Qr=-90,eo=1,lc=class extends ln{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Dn(Qr,eo,e,t);s.layers=this.layers,this.add(s);let r=new Dn(Qr,eo,e,t);r.layers=this.layers,this.add(r);let o=new Dn(Qr,eo,e,t);o.layers=this.layers,this.add(o);let a=new Dn(Qr,eo,e,t);a.layers=this.layers,this.add(a);let l=new Dn(Qr,eo,e,t);l.layers=this.layers,this.add(l);let c=new Dn(Qr,eo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ii)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===da)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=v,e.setRenderTarget(n,5,s),e.render(t,u),e.setRenderTarget(h,f,m),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},ya=class extends Kn{constructor(e=[],t=gr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},cc=class extends Ki{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ya(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ji(5,5,5),r=new ai({name:"CubemapFromEquirect",uniforms:xr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Wn,blending:xs});r.uniforms.tEquirect.value=t;let o=new Je(s,r),a=t.minFilter;return t.minFilter===Gs&&(t.minFilter=Li),new lc(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},_t=class extends ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},O_={type:"move"},po=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new _t,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new _t,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new L,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new L),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new _t,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new L,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new L),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let p=t.getJointPose(v,n),d=this._getHandJoint(c,v);p!==null&&(d.matrix.fromArray(p.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=p.radius),d.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),m=.02,g=.005;c.inputState.pinching&&f>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(O_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new _t;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var mo=class extends ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ui,this.environmentIntensity=1,this.environmentRotation=new Ui,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},go=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=sc,this.updateRanges=[],this.version=0,this.uuid=ps()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);let t=new this.array.constructor(e.arrayBuffers[this.array.buffer._uuid]),n=new this.constructor(t,this.stride);return n.setUsage(this.usage),n}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){return e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}},Vn=new L,Jn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.applyMatrix4(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.applyNormalMatrix(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.transformDirection(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ct(n,this.array)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=Pi(t,this.array)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=Pi(t,this.array)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=Pi(t,this.array)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=Pi(t,this.array)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array),r=Ct(r,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Jt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}},vo=class extends Ji{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new at(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},to,sa=new L,no=new L,io=new L,so=new Be,ra=new Be,Qm=new Ut,zl=new L,oa=new L,kl=new L,Jp=new Be,$u=new Be,jp=new Be,ba=class extends ln{constructor(e=new vo){if(super(),this.isSprite=!0,this.type="Sprite",to===void 0){to=new Ot;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new go(t,5);to.setIndex([0,1,2,0,2,3]),to.setAttribute("position",new Jn(n,3,0,!1)),to.setAttribute("uv",new Jn(n,2,3,!1))}this.geometry=to,this.material=e,this.center=new Be(.5,.5),this.count=1}raycast(e,t){e.camera===null&&console.error('THREE.Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),no.setFromMatrixScale(this.matrixWorld),Qm.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),io.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&no.multiplyScalar(-io.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Hl(zl.set(-.5,-.5,0),io,o,no,s,r),Hl(oa.set(.5,-.5,0),io,o,no,s,r),Hl(kl.set(.5,.5,0),io,o,no,s,r),Jp.set(0,0),$u.set(1,0),jp.set(1,1);let a=e.ray.intersectTriangle(zl,oa,kl,!1,sa);if(a===null&&(Hl(oa.set(-.5,.5,0),io,o,no,s,r),$u.set(0,1),a=e.ray.intersectTriangle(zl,kl,oa,!1,sa),a===null))return;let l=e.ray.origin.distanceTo(sa);l<e.near||l>e.far||t.push({distance:l,point:sa.clone(),uv:$i.getInterpolation(sa,zl,oa,kl,Jp,$u,jp,new Be),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}};function Hl(i,e,t,n,s,r){so.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(ra.x=r*so.x-s*so.y,ra.y=s*so.x+r*so.y):ra.copy(so),i.copy(e),i.x+=ra.x,i.y+=ra.y,i.applyMatrix4(Qm)}var Zu=new L,B_=new L,z_=new ct,Zn=class{constructor(e=new L(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Zu.subVectors(n,t).cross(B_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(Zu),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||z_.getNormalMatrix(e),s=this.coplanarPoint(Zu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},rr=new Di,k_=new Be(.5,.5),Vl=new L,xo=class{constructor(e=new Zn,t=new Zn,n=new Zn,s=new Zn,r=new Zn,o=new Zn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ii,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],m=r[7],g=r[8],v=r[9],p=r[10],d=r[11],b=r[12],M=r[13],y=r[14],P=r[15];if(s[0].setComponents(c-o,m-u,d-g,P-b).normalize(),s[1].setComponents(c+o,m+u,d+g,P+b).normalize(),s[2].setComponents(c+a,m+h,d+v,P+M).normalize(),s[3].setComponents(c-a,m-h,d-v,P-M).normalize(),n)s[4].setComponents(l,f,p,y).normalize(),s[5].setComponents(c-l,m-f,d-p,P-y).normalize();else if(s[4].setComponents(c-l,m-f,d-p,P-y).normalize(),t===Ii)s[5].setComponents(c+l,m+f,d+p,P+y).normalize();else if(t===da)s[5].setComponents(l,f,p,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(e){rr.center.set(0,0,0);let t=k_.distanceTo(e.center);return rr.radius=.7071067811865476+t,rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Vl.x=s.normal.x>0?e.max.x:e.min.x,Vl.y=s.normal.y>0?e.max.y:e.min.y,Vl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Vl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var vs=class extends Ji{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},hc=new L,uc=new L,Qp=new Ut,aa=new hr,Gl=new Di,Ku=new L,em=new L,ur=class extends ln{constructor(e=new Ot,t=new vs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)hc.fromBufferAttribute(t,s-1),uc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=hc.distanceTo(uc);e.setAttribute("lineDistance",new mt(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Gl.copy(n.boundingSphere),Gl.applyMatrix4(s),Gl.radius+=r,e.ray.intersectsSphere(Gl)===!1)return;Qp.copy(s).invert(),aa.copy(e.ray).applyMatrix4(Qp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let m=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=m,p=g-1;v<p;v+=c){let d=u.getX(v),b=u.getX(v+1),M=Wl(this,e,aa,l,d,b,v);M&&t.push(M)}if(this.isLineLoop){let v=u.getX(g-1),p=u.getX(m),d=Wl(this,e,aa,l,v,p,g-1);d&&t.push(d)}}else{let m=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=m,p=g-1;v<p;v+=c){let d=Wl(this,e,aa,l,v,v+1,v);d&&t.push(d)}if(this.isLineLoop){let v=Wl(this,e,aa,l,g-1,m,g-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Wl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(hc.fromBufferAttribute(a,s),uc.fromBufferAttribute(a,r),t.distanceSqToSegment(hc,uc,Ku,em)>n)return;Ku.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Ku);if(!(c<e.near||c>e.far))return{distance:c,point:em.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var tm=new L,nm=new L,_o=class extends ur{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)tm.fromBufferAttribute(t,s),nm.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+tm.distanceTo(nm);e.setAttribute("lineDistance",new mt(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ma=class extends Kn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},wa=class extends Kn{constructor(e,t,n=Ws,s,r,o,a=vi,l=vi,c,u=co,h=1){if(u!==co&&u!==So)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new fo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},Sa=class extends Kn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var fr=class i extends Ot{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new L,u=new Be;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=t;h++,f+=3){let m=n+h/t*s;c.x=e*Math.cos(m),c.y=e*Math.sin(m),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/e+1)/2,u.y=(o[f+1]/e+1)/2,l.push(u.x,u.y)}for(let h=1;h<=t;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new mt(o,3)),this.setAttribute("normal",new mt(a,3)),this.setAttribute("uv",new mt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},wn=class i extends Ot{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],m=[],g=0,v=[],p=n/2,d=0;b(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(m,2));function b(){let y=new L,P=new L,E=0,I=(t-e)/n;for(let D=0;D<=r;D++){let w=[],S=D/r,A=S*(t-e)+e;for(let k=0;k<=s;k++){let B=k/s,V=B*l+a,W=Math.sin(V),q=Math.cos(V);P.x=A*W,P.y=-S*n+p,P.z=A*q,h.push(P.x,P.y,P.z),y.set(W,I,q).normalize(),f.push(y.x,y.y,y.z),m.push(B,1-S),w.push(g++)}v.push(w)}for(let D=0;D<s;D++)for(let w=0;w<r;w++){let S=v[w][D],A=v[w+1][D],k=v[w+1][D+1],B=v[w][D+1];(e>0||w!==0)&&(u.push(S,A,B),E+=3),(t>0||w!==r-1)&&(u.push(A,k,B),E+=3)}c.addGroup(d,E,0),d+=E}function M(y){let P=g,E=new Be,I=new L,D=0,w=y===!0?e:t,S=y===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,p*S,0),f.push(0,S,0),m.push(.5,.5),g++;let A=g;for(let k=0;k<=s;k++){let V=k/s*l+a,W=Math.cos(V),q=Math.sin(V);I.x=w*q,I.y=p*S,I.z=w*W,h.push(I.x,I.y,I.z),f.push(0,S,0),E.x=W*.5+.5,E.y=q*.5*S+.5,m.push(E.x,E.y),g++}for(let k=0;k<s;k++){let B=P+k,V=A+k;y===!0?u.push(V,V+1,B):u.push(V+1,V,B),D+=3}c.addGroup(d,D,y===!0?1:2),d+=D}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},dr=class i extends wn{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Xl=new L,ql=new L,Ju=new L,Yl=new $i,Ea=class extends Ot{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(ao*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},m=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:v,b:p,c:d}=Yl;if(v.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),Yl.getNormal(Ju),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,h[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let b=0;b<3;b++){let M=(b+1)%3,y=h[b],P=h[M],E=Yl[u[b]],I=Yl[u[M]],D=`${y}_${P}`,w=`${P}_${y}`;w in f&&f[w]?(Ju.dot(f[w].normal)<=r&&(m.push(E.x,E.y,E.z),m.push(I.x,I.y,I.z)),f[w]=null):D in f||(f[D]={index0:c[b],index1:c[M],normal:Ju.clone()})}}for(let g in f)if(f[g]){let{index0:v,index1:p}=f[g];Xl.fromBufferAttribute(a,v),ql.fromBufferAttribute(a,p),m.push(Xl.x,Xl.y,Xl.z),m.push(ql.x,ql.y,ql.z)}this.setAttribute("position",new mt(m,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},jn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let u=n[s],f=n[s+1]-u,m=(o-u)/f;return(s+m)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new Be:new L);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new L,s=[],r=[],o=[],a=new L,l=new Ut;for(let m=0;m<=e;m++){let g=m/e;s[m]=this.getTangentAt(g,new L)}r[0]=new L,o[0]=new L;let c=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let m=1;m<=e;m++){if(r[m]=r[m-1].clone(),o[m]=o[m-1].clone(),a.crossVectors(s[m-1],s[m]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(it(s[m-1].dot(s[m]),-1,1));r[m].applyMatrix4(l.makeRotationAxis(a,g))}o[m].crossVectors(s[m],r[m])}if(t===!0){let m=Math.acos(it(r[0].dot(r[e]),-1,1));m/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(m=-m);for(let g=1;g<=e;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],m*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}},Ta=class extends jn{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new Be){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,m=c-this.aY;l=f*u-m*h+this.aX,c=f*h+m*u+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},fc=class extends Ta{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Df(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,m=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,m*=u,s(o,a,f,m)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var $l=new L,ju=new Df,Qu=new Df,ef=new Df,dc=class extends jn{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new L){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:($l.subVectors(s[0],s[1]).add(s[0]),c=$l);let h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:($l.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=$l),this.curveType==="centripetal"||this.curveType==="chordal"){let m=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(h),m),v=Math.pow(h.distanceToSquared(f),m),p=Math.pow(f.distanceToSquared(u),m);v<1e-4&&(v=1),g<1e-4&&(g=v),p<1e-4&&(p=v),ju.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,g,v,p),Qu.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,g,v,p),ef.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,g,v,p)}else this.curveType==="catmullrom"&&(ju.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),Qu.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),ef.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(ju.calc(l),Qu.calc(l),ef.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new L().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function im(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function H_(i,e){let t=1-i;return t*t*e}function V_(i,e){return 2*(1-i)*i*e}function G_(i,e){return i*i*e}function ca(i,e,t,n){return H_(i,e)+V_(i,t)+G_(i,n)}function W_(i,e){let t=1-i;return t*t*t*e}function X_(i,e){let t=1-i;return 3*t*t*i*e}function q_(i,e){return 3*(1-i)*i*i*e}function Y_(i,e){return i*i*i*e}function ha(i,e,t,n,s){return W_(i,e)+X_(i,t)+q_(i,n)+Y_(i,s)}var pc=class extends jn{constructor(e=new Be,t=new Be,n=new Be,s=new Be){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Be){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ha(e,s.x,r.x,o.x,a.x),ha(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},mc=class extends jn{constructor(e=new L,t=new L,n=new L,s=new L){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new L){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ha(e,s.x,r.x,o.x,a.x),ha(e,s.y,r.y,o.y,a.y),ha(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},gc=class extends jn{constructor(e=new Be,t=new Be){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Be){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Be){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},vc=class extends jn{constructor(e=new L,t=new L){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new L){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new L){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},xc=class extends jn{constructor(e=new Be,t=new Be,n=new Be){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Be){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ca(e,s.x,r.x,o.x),ca(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Aa=class extends jn{constructor(e=new L,t=new L,n=new L){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new L){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ca(e,s.x,r.x,o.x),ca(e,s.y,r.y,o.y),ca(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},_c=class extends jn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Be){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(im(a,l.x,c.x,u.x,h.x),im(a,l.y,c.y,u.y,h.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Be().fromArray(s))}return this}},$_=Object.freeze({__proto__:null,ArcCurve:fc,CatmullRomCurve3:dc,CubicBezierCurve:pc,CubicBezierCurve3:mc,EllipseCurve:Ta,LineCurve:gc,LineCurve3:vc,QuadraticBezierCurve:xc,QuadraticBezierCurve3:Aa,SplineCurve:_c});var Ra=class i extends Ot{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,m=[],g=[],v=[],p=[];for(let d=0;d<u;d++){let b=d*f-o;for(let M=0;M<c;M++){let y=M*h-r;g.push(y,-b,0),v.push(0,0,1),p.push(M/a),p.push(1-d/l)}}for(let d=0;d<l;d++)for(let b=0;b<a;b++){let M=b+c*d,y=b+c*(d+1),P=b+1+c*(d+1),E=b+1+c*d;m.push(M,y,E),m.push(y,P,E)}this.setIndex(m),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(v,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ca=class i extends Ot{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new L,f=new L,m=[],g=[],v=[],p=[];for(let d=0;d<=n;d++){let b=[],M=d/n,y=0;d===0&&o===0?y=.5/t:d===n&&l===Math.PI&&(y=-.5/t);for(let P=0;P<=t;P++){let E=P/t;h.x=-e*Math.cos(s+E*r)*Math.sin(o+M*a),h.y=e*Math.cos(o+M*a),h.z=e*Math.sin(s+E*r)*Math.sin(o+M*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),p.push(E+y,1-M),b.push(c++)}u.push(b)}for(let d=0;d<n;d++)for(let b=0;b<t;b++){let M=u[d][b+1],y=u[d][b],P=u[d+1][b],E=u[d+1][b+1];(d!==0||o>0)&&m.push(M,y,E),(d!==n-1||l<Math.PI)&&m.push(y,P,E)}this.setIndex(m),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(v,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Pa=class i extends Ot{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],l=[],c=[],u=new L,h=new L,f=new L;for(let m=0;m<=n;m++)for(let g=0;g<=s;g++){let v=g/s*r,p=m/n*Math.PI*2;h.x=(e+t*Math.cos(p))*Math.cos(v),h.y=(e+t*Math.cos(p))*Math.sin(v),h.z=t*Math.sin(p),a.push(h.x,h.y,h.z),u.x=e*Math.cos(v),u.y=e*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(m/n)}for(let m=1;m<=n;m++)for(let g=1;g<=s;g++){let v=(s+1)*m+g-1,p=(s+1)*(m-1)+g-1,d=(s+1)*(m-1)+g,b=(s+1)*m+g;o.push(v,p,b),o.push(p,d,b)}this.setIndex(o),this.setAttribute("position",new mt(a,3)),this.setAttribute("normal",new mt(l,3)),this.setAttribute("uv",new mt(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}};var Ia=class i extends Ot{constructor(e=new Aa(new L(-1,-1,0),new L(-1,1,0),new L(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let o=e.computeFrenetFrames(t,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new L,l=new L,c=new Be,u=new L,h=[],f=[],m=[],g=[];v(),this.setIndex(g),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(m,2));function v(){for(let M=0;M<t;M++)p(M);p(r===!1?t:0),b(),d()}function p(M){u=e.getPointAt(M/t,u);let y=o.normals[M],P=o.binormals[M];for(let E=0;E<=s;E++){let I=E/s*Math.PI*2,D=Math.sin(I),w=-Math.cos(I);l.x=w*y.x+D*P.x,l.y=w*y.y+D*P.y,l.z=w*y.z+D*P.z,l.normalize(),f.push(l.x,l.y,l.z),a.x=u.x+n*l.x,a.y=u.y+n*l.y,a.z=u.z+n*l.z,h.push(a.x,a.y,a.z)}}function d(){for(let M=1;M<=t;M++)for(let y=1;y<=s;y++){let P=(s+1)*(M-1)+(y-1),E=(s+1)*M+(y-1),I=(s+1)*M+y,D=(s+1)*(M-1)+y;g.push(P,E,D),g.push(E,I,D)}}function b(){for(let M=0;M<=t;M++)for(let y=0;y<=s;y++)c.x=M/t,c.y=y/s,m.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new $_[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}},La=class extends Ot{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new L,r=new L;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,m=h.count;for(let g=f,v=f+m;g<v;g+=3)for(let p=0;p<3;p++){let d=a.getX(g+p),b=a.getX(g+(p+1)%3);s.fromBufferAttribute(o,d),r.fromBufferAttribute(o,b),sm(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),sm(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new mt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function sm(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var Ni=class extends Ji{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new at(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Af,this.normalScale=new Be(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var yc=class extends Ji{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=km,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},bc=class extends Ji{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Zl(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Z_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var pr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},Mc=class extends pr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:rf,endingEnd:rf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case of:r=e,a=2*t-n;break;case af:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case of:o=e,l=2*n-t;break;case af:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,m=this._weightNext,g=(n-t)/(s-t),v=g*g,p=v*g,d=-f*p+2*f*v-f*g,b=(1+f)*p+(-1.5-2*f)*v+(-.5+f)*g+1,M=(-1-m)*p+(1.5+m)*v+.5*g,y=m*p-m*v;for(let P=0;P!==a;++P)r[P]=d*o[u+P]+b*o[c+P]+M*o[l+P]+y*o[h+P];return r}},wc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Sc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},li=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Zl(t,this.TimeBufferType),this.values=Zl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Zl(e.times,Array),values:Zl(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Sc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new wc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Mc(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case ua:t=this.InterpolantFactoryMethodDiscrete;break;case ic:t=this.InterpolantFactoryMethodLinear;break;case jl:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ua;case this.InterpolantFactoryMethodLinear:return ic;case this.InterpolantFactoryMethodSmooth:return jl}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Z_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===jl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,f=h-n,m=h+n;for(let g=0;g!==n;++g){let v=t[h+g];if(v!==t[f+g]||v!==t[m+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,f=o*n;for(let m=0;m!==n;++m)t[f+m]=t[h+m]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};li.prototype.ValueTypeName="";li.prototype.TimeBufferType=Float32Array;li.prototype.ValueBufferType=Float32Array;li.prototype.DefaultInterpolation=ic;var Bs=class extends li{constructor(e,t,n){super(e,t,n)}};Bs.prototype.ValueTypeName="bool";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=ua;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ec=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Ec.prototype.ValueTypeName="color";var Tc=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Tc.prototype.ValueTypeName="number";var Ac=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)sn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Da=class extends li{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Ac(this.times,this.values,this.getValueSize(),e)}};Da.prototype.ValueTypeName="quaternion";Da.prototype.InterpolantFactoryMethodSmooth=void 0;var zs=class extends li{constructor(e,t,n){super(e,t,n)}};zs.prototype.ValueTypeName="string";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=ua;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Rc=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Rc.prototype.ValueTypeName="vector";var Cc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let m=c[h],g=c[h+1];if(m.global&&(m.lastIndex=0),m.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},eg=new Cc,Pc=class{constructor(e){this.manager=e!==void 0?e:eg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};Pc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ua=class extends ln{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new at(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}},Na=class extends Ua{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new at(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}},tf=new Ut,rm=new L,om=new L,cf=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Be(512,512),this.mapType=Fi,this.map=null,this.mapPass=null,this.matrix=new Ut,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new xo,this._frameExtents=new Be(1,1),this._viewportCount=1,this._viewports=[new It(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera,n=this.matrix;rm.setFromMatrixPosition(e.matrixWorld),t.position.copy(rm),om.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(om),t.updateMatrixWorld(),tf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(tf,t.coordinateSystem,t.reversedDepth),t.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(tf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var mr=class extends _a{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},hf=class extends cf{constructor(){super(new mr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fa=class extends Ua{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.target=new ln,this.shadow=new hf}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}};var Oa=class extends Ot{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Ic=class extends Dn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var Uf="\\[\\]\\.:\\/",K_=new RegExp("["+Uf+"]","g"),Nf="[^"+Uf+"]",J_="[^"+Uf.replace("\\.","")+"]",j_=/((?:WC+[\/:])*)/.source.replace("WC",Nf),Q_=/(WCOD+)?/.source.replace("WCOD",J_),ey=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Nf),ty=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Nf),ny=new RegExp("^"+j_+Q_+ey+ty+"$"),iy=["material","materials","bones","map"],uf=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(K_,"")}static parseTrackName(e){let t=ny.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);iy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=uf;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var xA=new Float32Array(1);var ks=class extends go{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var yo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=it(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(it(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var am=new L,Kl=new L,ro=new L,oo=new L,nf=new L,sy=new L,ry=new L,Ba=class{constructor(e=new L,t=new L){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){am.subVectors(e,this.start),Kl.subVectors(this.end,this.start);let n=Kl.dot(Kl),r=Kl.dot(am)/n;return t&&(r=it(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=sy,n=ry){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;ro.subVectors(c,a),oo.subVectors(u,l),nf.subVectors(a,l);let h=ro.dot(ro),f=oo.dot(oo),m=oo.dot(nf);if(h<=s&&f<=s)return t.copy(a),n.copy(l),t.sub(n),t.dot(t);if(h<=s)r=0,o=m/f,o=it(o,0,1);else{let g=ro.dot(nf);if(f<=s)o=0,r=it(-g/h,0,1);else{let v=ro.dot(oo),p=h*f-v*v;p!==0?r=it((v*m-g*f)/p,0,1):r=0,o=(v*r+m)/f,o<0?(o=0,r=it(-g/h,0,1)):o>1&&(o=1,r=it((v-g)/h,0,1))}}return t.copy(a).add(ro.multiplyScalar(r)),n.copy(l).add(oo.multiplyScalar(o)),t.sub(n),t.dot(t)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var lm=new L,Jl,sf,za=class extends ln{constructor(e=new L(0,0,1),t=new L(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",Jl===void 0&&(Jl=new Ot,Jl.setAttribute("position",new mt([0,0,0,0,1,0],3)),sf=new dr(.5,1,5,1),sf.translate(0,-.5,0)),this.position.copy(t),this.line=new ur(Jl,new vs({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Je(sf,new oi({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{lm.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(lm,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var ka=class extends Zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Ff(i,e,t,n){let s=oy(n);switch(t){case wf:return i*e;case Ef:return i*e/s.components*s.byteLength;case Xc:return i*e/s.components*s.byteLength;case Tf:return i*e*2/s.components*s.byteLength;case qc:return i*e*2/s.components*s.byteLength;case Sf:return i*e*3/s.components*s.byteLength;case xi:return i*e*4/s.components*s.byteLength;case Yc:return i*e*4/s.components*s.byteLength;case Ga:case Wa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Xa:case qa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Zc:case Jc:return Math.max(i,16)*Math.max(e,8)/4;case $c:case Kc:return Math.max(i,8)*Math.max(e,8)/2;case jc:case Qc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case eh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case th:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case nh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case ih:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case sh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case rh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case oh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case ah:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case lh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ch:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case hh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case uh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case fh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case dh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case ph:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case mh:case gh:case vh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case xh:case _h:return Math.ceil(i/4)*Math.ceil(e/4)*8;case yh:case bh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function oy(i){switch(i){case Fi:case _f:return{byteLength:1,components:1};case bo:case yf:case Mo:return{byteLength:2,components:1};case Gc:case Wc:return{byteLength:2,components:4};case Ws:case Vc:case es:return{byteLength:4,components:1};case bf:case Mf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function Sg(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function fy(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((m,g)=>m.start-g.start);let f=0;for(let m=1;m<h.length;m++){let g=h[f],v=h[m];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let m=0,g=h.length;m<g;m++){let v=h[m];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var dy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,py=`#ifdef USE_ALPHAHASH
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
#endif`,my=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,gy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,xy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,_y=`#ifdef USE_AOMAP
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
#endif`,yy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,by=`#ifdef USE_BATCHING
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
#endif`,My=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,wy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Sy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Ey=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Ty=`#ifdef USE_IRIDESCENCE
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
#endif`,Ay=`#ifdef USE_BUMPMAP
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
#endif`,Ry=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Cy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Py=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Iy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ly=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Dy=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Uy=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Ny=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Fy=`#define PI 3.141592653589793
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
} // validated`,Oy=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,By=`vec3 transformedNormal = objectNormal;
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
#endif`,zy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ky=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Hy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Vy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Gy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Wy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Xy=`#ifdef USE_ENVMAP
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
#endif`,qy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Yy=`#ifdef USE_ENVMAP
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
#endif`,$y=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Zy=`#ifdef USE_ENVMAP
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
#endif`,Ky=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Jy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,jy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Qy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,eb=`#ifdef USE_GRADIENTMAP
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
}`,tb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,nb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,ib=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,sb=`uniform bool receiveShadow;
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
#endif`,rb=`#ifdef USE_ENVMAP
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
#endif`,ob=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ab=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,lb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,cb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,hb=`PhysicalMaterial material;
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
#endif`,ub=`struct PhysicalMaterial {
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
}`,fb=`
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
#endif`,db=`#if defined( RE_IndirectDiffuse )
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
#endif`,pb=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,mb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,gb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,xb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,_b=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,yb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,bb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Mb=`#if defined( USE_POINTS_UV )
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
#endif`,wb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Sb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Eb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Tb=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Ab=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Rb=`#ifdef USE_MORPHTARGETS
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
#endif`,Cb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Pb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Ib=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Lb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Db=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ub=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Nb=`#ifdef USE_NORMALMAP
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
#endif`,Fb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Ob=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Bb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,zb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,kb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Hb=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Vb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Gb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Wb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Xb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,qb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Yb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,$b=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Zb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Kb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Jb=`float getShadowMask() {
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
}`,jb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Qb=`#ifdef USE_SKINNING
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
#endif`,eM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,tM=`#ifdef USE_SKINNING
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
#endif`,nM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,iM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,sM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,rM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,oM=`#ifdef USE_TRANSMISSION
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
#endif`,aM=`#ifdef USE_TRANSMISSION
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
#endif`,lM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,cM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,hM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,uM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,fM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,dM=`uniform sampler2D t2D;
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
}`,pM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mM=`#ifdef ENVMAP_TYPE_CUBE
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
}`,gM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xM=`#include <common>
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
}`,_M=`#if DEPTH_PACKING == 3200
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
}`,yM=`#define DISTANCE
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
}`,bM=`#define DISTANCE
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
}`,MM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,wM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SM=`uniform float scale;
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
}`,EM=`uniform vec3 diffuse;
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
}`,TM=`#include <common>
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
}`,AM=`uniform vec3 diffuse;
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
}`,RM=`#define LAMBERT
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
}`,CM=`#define LAMBERT
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
}`,PM=`#define MATCAP
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
}`,IM=`#define MATCAP
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
}`,LM=`#define NORMAL
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
}`,DM=`#define NORMAL
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
}`,UM=`#define PHONG
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
}`,NM=`#define PHONG
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
}`,FM=`#define STANDARD
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
}`,OM=`#define STANDARD
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
}`,BM=`#define TOON
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
}`,zM=`#define TOON
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
}`,kM=`uniform float size;
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
}`,HM=`uniform vec3 diffuse;
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
}`,VM=`#include <common>
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
}`,GM=`uniform vec3 color;
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
}`,WM=`uniform float rotation;
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
}`,XM=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:dy,alphahash_pars_fragment:py,alphamap_fragment:my,alphamap_pars_fragment:gy,alphatest_fragment:vy,alphatest_pars_fragment:xy,aomap_fragment:_y,aomap_pars_fragment:yy,batching_pars_vertex:by,batching_vertex:My,begin_vertex:wy,beginnormal_vertex:Sy,bsdfs:Ey,iridescence_fragment:Ty,bumpmap_pars_fragment:Ay,clipping_planes_fragment:Ry,clipping_planes_pars_fragment:Cy,clipping_planes_pars_vertex:Py,clipping_planes_vertex:Iy,color_fragment:Ly,color_pars_fragment:Dy,color_pars_vertex:Uy,color_vertex:Ny,common:Fy,cube_uv_reflection_fragment:Oy,defaultnormal_vertex:By,displacementmap_pars_vertex:zy,displacementmap_vertex:ky,emissivemap_fragment:Hy,emissivemap_pars_fragment:Vy,colorspace_fragment:Gy,colorspace_pars_fragment:Wy,envmap_fragment:Xy,envmap_common_pars_fragment:qy,envmap_pars_fragment:Yy,envmap_pars_vertex:$y,envmap_physical_pars_fragment:rb,envmap_vertex:Zy,fog_vertex:Ky,fog_pars_vertex:Jy,fog_fragment:jy,fog_pars_fragment:Qy,gradientmap_pars_fragment:eb,lightmap_pars_fragment:tb,lights_lambert_fragment:nb,lights_lambert_pars_fragment:ib,lights_pars_begin:sb,lights_toon_fragment:ob,lights_toon_pars_fragment:ab,lights_phong_fragment:lb,lights_phong_pars_fragment:cb,lights_physical_fragment:hb,lights_physical_pars_fragment:ub,lights_fragment_begin:fb,lights_fragment_maps:db,lights_fragment_end:pb,logdepthbuf_fragment:mb,logdepthbuf_pars_fragment:gb,logdepthbuf_pars_vertex:vb,logdepthbuf_vertex:xb,map_fragment:_b,map_pars_fragment:yb,map_particle_fragment:bb,map_particle_pars_fragment:Mb,metalnessmap_fragment:wb,metalnessmap_pars_fragment:Sb,morphinstance_vertex:Eb,morphcolor_vertex:Tb,morphnormal_vertex:Ab,morphtarget_pars_vertex:Rb,morphtarget_vertex:Cb,normal_fragment_begin:Pb,normal_fragment_maps:Ib,normal_pars_fragment:Lb,normal_pars_vertex:Db,normal_vertex:Ub,normalmap_pars_fragment:Nb,clearcoat_normal_fragment_begin:Fb,clearcoat_normal_fragment_maps:Ob,clearcoat_pars_fragment:Bb,iridescence_pars_fragment:zb,opaque_fragment:kb,packing:Hb,premultiplied_alpha_fragment:Vb,project_vertex:Gb,dithering_fragment:Wb,dithering_pars_fragment:Xb,roughnessmap_fragment:qb,roughnessmap_pars_fragment:Yb,shadowmap_pars_fragment:$b,shadowmap_pars_vertex:Zb,shadowmap_vertex:Kb,shadowmask_pars_fragment:Jb,skinbase_vertex:jb,skinning_pars_vertex:Qb,skinning_vertex:eM,skinnormal_vertex:tM,specularmap_fragment:nM,specularmap_pars_fragment:iM,tonemapping_fragment:sM,tonemapping_pars_fragment:rM,transmission_fragment:oM,transmission_pars_fragment:aM,uv_pars_fragment:lM,uv_pars_vertex:cM,uv_vertex:hM,worldpos_vertex:uM,background_vert:fM,background_frag:dM,backgroundCube_vert:pM,backgroundCube_frag:mM,cube_vert:gM,cube_frag:vM,depth_vert:xM,depth_frag:_M,distanceRGBA_vert:yM,distanceRGBA_frag:bM,equirect_vert:MM,equirect_frag:wM,linedashed_vert:SM,linedashed_frag:EM,meshbasic_vert:TM,meshbasic_frag:AM,meshlambert_vert:RM,meshlambert_frag:CM,meshmatcap_vert:PM,meshmatcap_frag:IM,meshnormal_vert:LM,meshnormal_frag:DM,meshphong_vert:UM,meshphong_frag:NM,meshphysical_vert:FM,meshphysical_frag:OM,meshtoon_vert:BM,meshtoon_frag:zM,points_vert:kM,points_frag:HM,shadow_vert:VM,shadow_frag:GM,sprite_vert:WM,sprite_frag:XM},Ne={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new Be(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new Be(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},Xn={basic:{uniforms:Un([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Un([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new at(0)}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Un([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Un([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Un([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new at(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Un([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Un([Ne.points,Ne.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Un([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Un([Ne.common,Ne.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Un([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Un([Ne.sprite,Ne.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distanceRGBA:{uniforms:Un([Ne.common,Ne.displacementmap,{referencePosition:{value:new L},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distanceRGBA_vert,fragmentShader:ft.distanceRGBA_frag},shadow:{uniforms:Un([Ne.lights,Ne.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};Xn.physical={uniforms:Un([Xn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new Be(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new Be},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new Be},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Sh={r:0,b:0,g:0},_r=new Ui,qM=new Ut;function YM(i,e,t,n,s,r,o){let a=new at(0),l=r===!0?0:1,c,u,h=null,f=0,m=null;function g(M){let y=M.isScene===!0?M.background:null;return y&&y.isTexture&&(y=(M.backgroundBlurriness>0?t:e).get(y)),y}function v(M){let y=!1,P=g(M);P===null?d(a,l):P&&P.isColor&&(d(P,1),y=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?n.buffers.color.setClear(0,0,0,1,o):E==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||y)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function p(M,y){let P=g(y);P&&(P.isCubeTexture||P.mapping===Ha)?(u===void 0&&(u=new Je(new ji(1,1,1),new ai({name:"BackgroundCubeMaterial",uniforms:xr(Xn.backgroundCube.uniforms),vertexShader:Xn.backgroundCube.vertexShader,fragmentShader:Xn.backgroundCube.fragmentShader,side:Wn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(E,I,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),_r.copy(y.backgroundRotation),_r.x*=-1,_r.y*=-1,_r.z*=-1,P.isCubeTexture&&P.isRenderTargetTexture===!1&&(_r.y*=-1,_r.z*=-1),u.material.uniforms.envMap.value=P,u.material.uniforms.flipEnvMap.value=P.isCubeTexture&&P.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=y.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(qM.makeRotationFromEuler(_r)),u.material.toneMapped=xt.getTransfer(P.colorSpace)!==Pt,(h!==P||f!==P.version||m!==i.toneMapping)&&(u.material.needsUpdate=!0,h=P,f=P.version,m=i.toneMapping),u.layers.enableAll(),M.unshift(u,u.geometry,u.material,0,0,null)):P&&P.isTexture&&(c===void 0&&(c=new Je(new Ra(2,2),new ai({name:"BackgroundMaterial",uniforms:xr(Xn.background.uniforms),vertexShader:Xn.background.vertexShader,fragmentShader:Xn.background.fragmentShader,side:gs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=P,c.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,c.material.toneMapped=xt.getTransfer(P.colorSpace)!==Pt,P.matrixAutoUpdate===!0&&P.updateMatrix(),c.material.uniforms.uvTransform.value.copy(P.matrix),(h!==P||f!==P.version||m!==i.toneMapping)&&(c.material.needsUpdate=!0,h=P,f=P.version,m=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function d(M,y){M.getRGB(Sh,Lf(i)),n.buffers.color.setClear(Sh.r,Sh.g,Sh.b,y,o)}function b(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,y=1){a.set(M),l=y,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(M){l=M,d(a,l)},render:v,addToRenderList:p,dispose:b}}function $M(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(S,A,k,B,V){let W=!1,q=h(B,k,A);r!==q&&(r=q,c(r.object)),W=m(S,B,k,V),W&&g(S,B,k,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,y(S,A,k,B),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function u(S){return i.deleteVertexArray(S)}function h(S,A,k){let B=k.wireframe===!0,V=n[S.id];V===void 0&&(V={},n[S.id]=V);let W=V[A.id];W===void 0&&(W={},V[A.id]=W);let q=W[B];return q===void 0&&(q=f(l()),W[B]=q),q}function f(S){let A=[],k=[],B=[];for(let V=0;V<t;V++)A[V]=0,k[V]=0,B[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:A,enabledAttributes:k,attributeDivisors:B,object:S,attributes:{},index:null}}function m(S,A,k,B){let V=r.attributes,W=A.attributes,q=0,N=k.getAttributes();for(let z in N)if(N[z].location>=0){let ne=V[z],te=W[z];if(te===void 0&&(z==="instanceMatrix"&&S.instanceMatrix&&(te=S.instanceMatrix),z==="instanceColor"&&S.instanceColor&&(te=S.instanceColor)),ne===void 0||ne.attribute!==te||te&&ne.data!==te.data)return!0;q++}return r.attributesNum!==q||r.index!==B}function g(S,A,k,B){let V={},W=A.attributes,q=0,N=k.getAttributes();for(let z in N)if(N[z].location>=0){let ne=W[z];ne===void 0&&(z==="instanceMatrix"&&S.instanceMatrix&&(ne=S.instanceMatrix),z==="instanceColor"&&S.instanceColor&&(ne=S.instanceColor));let te={};te.attribute=ne,ne&&ne.data&&(te.data=ne.data),V[z]=te,q++}r.attributes=V,r.attributesNum=q,r.index=B}function v(){let S=r.newAttributes;for(let A=0,k=S.length;A<k;A++)S[A]=0}function p(S){d(S,0)}function d(S,A){let k=r.newAttributes,B=r.enabledAttributes,V=r.attributeDivisors;k[S]=1,B[S]===0&&(i.enableVertexAttribArray(S),B[S]=1),V[S]!==A&&(i.vertexAttribDivisor(S,A),V[S]=A)}function b(){let S=r.newAttributes,A=r.enabledAttributes;for(let k=0,B=A.length;k<B;k++)A[k]!==S[k]&&(i.disableVertexAttribArray(k),A[k]=0)}function M(S,A,k,B,V,W,q){q===!0?i.vertexAttribIPointer(S,A,k,V,W):i.vertexAttribPointer(S,A,k,B,V,W)}function y(S,A,k,B){v();let V=B.attributes,W=k.getAttributes(),q=A.defaultAttributeValues;for(let N in W){let z=W[N];if(z.location>=0){let K=V[N];if(K===void 0&&(N==="instanceMatrix"&&S.instanceMatrix&&(K=S.instanceMatrix),N==="instanceColor"&&S.instanceColor&&(K=S.instanceColor)),K!==void 0){let ne=K.normalized,te=K.itemSize,le=e.get(K);if(le===void 0)continue;let fe=le.buffer,ye=le.type,_e=le.bytesPerElement,ee=ye===i.INT||ye===i.UNSIGNED_INT||K.gpuType===Vc;if(K.isInterleavedBufferAttribute){let Y=K.data,pe=Y.stride,xe=K.offset;if(Y.isInstancedInterleavedBuffer){for(let we=0;we<z.locationSize;we++)d(z.location+we,Y.meshPerAttribute);S.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=Y.meshPerAttribute*Y.count)}else for(let we=0;we<z.locationSize;we++)p(z.location+we);i.bindBuffer(i.ARRAY_BUFFER,fe);for(let we=0;we<z.locationSize;we++)M(z.location+we,te/z.locationSize,ye,ne,pe*_e,(xe+te/z.locationSize*we)*_e,ee)}else{if(K.isInstancedBufferAttribute){for(let Y=0;Y<z.locationSize;Y++)d(z.location+Y,K.meshPerAttribute);S.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let Y=0;Y<z.locationSize;Y++)p(z.location+Y);i.bindBuffer(i.ARRAY_BUFFER,fe);for(let Y=0;Y<z.locationSize;Y++)M(z.location+Y,te/z.locationSize,ye,ne,te*_e,te/z.locationSize*Y*_e,ee)}}else if(q!==void 0){let ne=q[N];if(ne!==void 0)switch(ne.length){case 2:i.vertexAttrib2fv(z.location,ne);break;case 3:i.vertexAttrib3fv(z.location,ne);break;case 4:i.vertexAttrib4fv(z.location,ne);break;default:i.vertexAttrib1fv(z.location,ne)}}}}b()}function P(){D();for(let S in n){let A=n[S];for(let k in A){let B=A[k];for(let V in B)u(B[V].object),delete B[V];delete A[k]}delete n[S]}}function E(S){if(n[S.id]===void 0)return;let A=n[S.id];for(let k in A){let B=A[k];for(let V in B)u(B[V].object),delete B[V];delete A[k]}delete n[S.id]}function I(S){for(let A in n){let k=n[A];if(k[S.id]===void 0)continue;let B=k[S.id];for(let V in B)u(B[V].object),delete B[V];delete k[S.id]}}function D(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:w,dispose:P,releaseStatesOfGeometry:E,releaseStatesOfProgram:I,initAttributes:v,enableAttribute:p,disableUnusedAttributes:b}}function ZM(i,e,t){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),t.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),t.update(u,n,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let m=0;for(let g=0;g<h;g++)m+=u[g];t.update(m,n,1)}function l(c,u,h,f){if(h===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{m.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];t.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function KM(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let I=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(I.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(I){return!(I!==xi&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(I){let D=I===Mo&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(I!==Fi&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&I!==es&&!D)}function l(I){if(I==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";I="mediump"}return I==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.logarithmicDepthBuffer===!0,f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=g>0,E=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:p,maxAttributes:d,maxVertexUniforms:b,maxVaryings:M,maxFragmentUniforms:y,vertexTextures:P,maxSamples:E}}function JM(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Zn,a=new ct,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let m=h.length!==0||f||n!==0||s;return s=f,n=h.length,m},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,m){let g=h.clippingPlanes,v=h.clipIntersection,p=h.clipShadows,d=i.get(h);if(!s||g===null||g.length===0||r&&!p)r?u(null):c();else{let b=r?0:n,M=b*4,y=d.clippingState||null;l.value=y,y=u(g,f,M,m);for(let P=0;P!==M;++P)y[P]=t[P];d.clippingState=y,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,f,m,g){let v=h!==null?h.length:0,p=null;if(v!==0){if(p=l.value,g!==!0||p===null){let d=m+v*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(p===null||p.length<d)&&(p=new Float32Array(d));for(let M=0,y=m;M!==v;++M,y+=4)o.copy(h[M]).applyMatrix4(b,a),o.normal.toArray(p,y),p[y+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,p}}function jM(i){let e=new WeakMap;function t(o,a){return a===zc?o.mapping=gr:a===kc&&(o.mapping=vr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===zc||a===kc)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new cc(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var To=4,tg=[.125,.215,.35,.446,.526,.582],Mr=20,Of=new mr,ng=new at,Bf=null,zf=0,kf=0,Hf=!1,br=(1+Math.sqrt(5))/2,Eo=1/br,ig=[new L(-br,Eo,0),new L(br,Eo,0),new L(-Eo,0,br),new L(Eo,0,br),new L(0,br,-Eo),new L(0,br,Eo),new L(-1,1,-1),new L(1,1,-1),new L(-1,1,1),new L(1,1,1)],QM=new L,Ah=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=QM}=r;Bf=this._renderer.getRenderTarget(),zf=this._renderer.getActiveCubeFace(),kf=this._renderer.getActiveMipmapLevel(),Hf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=og(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=rg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Bf,zf,kf),this._renderer.xr.enabled=Hf,e.scissorTest=!1,Eh(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===gr||e.mapping===vr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Bf=this._renderer.getRenderTarget(),zf=this._renderer.getActiveCubeFace(),kf=this._renderer.getActiveMipmapLevel(),Hf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:Li,minFilter:Li,generateMipmaps:!1,type:Mo,format:xi,colorSpace:cr,depthBuffer:!1},s=sg(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=sg(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=ew(r)),this._blurMaterial=tw(r,e,t)}return s}_compileMaterial(e){let t=new Je(this._lodPlanes[0],e);this._renderer.compile(t,Of)}_sceneToCubeUV(e,t,n,s,r){let l=new Dn(90,1,t,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,m=h.toneMapping;h.getClearColor(ng),h.toneMapping=_s,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let v=new oi({name:"PMREM.Background",side:Wn,depthWrite:!1,depthTest:!1}),p=new Je(new ji,v),d=!1,b=e.background;b?b.isColor&&(v.color.copy(b),e.background=null,d=!0):(v.color.copy(ng),d=!0);for(let M=0;M<6;M++){let y=M%3;y===0?(l.up.set(0,c[M],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[M],r.y,r.z)):y===1?(l.up.set(0,0,c[M]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[M],r.z)):(l.up.set(0,c[M],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[M]));let P=this._cubeSize;Eh(s,y*P,M>2?P:0,P,P),h.setRenderTarget(s),d&&h.render(p,l),h.render(e,l)}p.geometry.dispose(),p.material.dispose(),h.toneMapping=m,h.autoClear=f,e.background=b}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===gr||e.mapping===vr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=og()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=rg());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Je(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Eh(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,Of)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=ig[(s-r-1)%ig.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new Je(this._lodPlanes[s],c),f=c.uniforms,m=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*m):2*Math.PI/(2*Mr-1),v=r/g,p=isFinite(r)?1+Math.floor(u*v):Mr;p>Mr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${Mr}`);let d=[],b=0;for(let I=0;I<Mr;++I){let D=I/v,w=Math.exp(-D*D/2);d.push(w),I===0?b+=w:I<p&&(b+=2*w)}for(let I=0;I<d.length;I++)d[I]=d[I]/b;f.envMap.value=e.texture,f.samples.value=p,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:M}=this;f.dTheta.value=g,f.mipInt.value=M-n;let y=this._sizeLods[s],P=3*y*(s>M-To?s-M+To:0),E=4*(this._cubeSize-y);Eh(t,P,E,3*y,2*y),l.setRenderTarget(t),l.render(h,Of)}};function ew(i){let e=[],t=[],n=[],s=i,r=i-To+1+tg.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>i-To?l=tg[o-i+To-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],m=6,g=6,v=3,p=2,d=1,b=new Float32Array(v*g*m),M=new Float32Array(p*g*m),y=new Float32Array(d*g*m);for(let E=0;E<m;E++){let I=E%3*2/3-1,D=E>2?0:-1,w=[I,D,0,I+2/3,D,0,I+2/3,D+1,0,I,D,0,I+2/3,D+1,0,I,D+1,0];b.set(w,v*g*E),M.set(f,p*g*E);let S=[E,E,E,E,E,E];y.set(S,d*g*E)}let P=new Ot;P.setAttribute("position",new Jt(b,v)),P.setAttribute("uv",new Jt(M,p)),P.setAttribute("faceIndex",new Jt(y,d)),e.push(P),s>To&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function sg(i,e,t){let n=new Ki(i,e,t);return n.texture.mapping=Ha,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Eh(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function tw(i,e,t){let n=new Float32Array(Mr),s=new L(0,1,0);return new ai({name:"SphericalGaussianBlur",defines:{n:Mr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Jf(),fragmentShader:`

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
		`,blending:xs,depthTest:!1,depthWrite:!1})}function rg(){return new ai({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Jf(),fragmentShader:`

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
		`,blending:xs,depthTest:!1,depthWrite:!1})}function og(){return new ai({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Jf(),fragmentShader:`

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
	`}function nw(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===zc||l===kc,u=l===gr||l===vr;if(c||u){let h=e.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new Ah(i)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{let m=a.image;return c&&m&&m.height>0||u&&m&&s(m)?(t===null&&(t=new Ah(i)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function iw(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&uo("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function sw(i,e,t,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&e.remove(f.index);for(let g in f.attributes)e.remove(f.attributes[g]);f.removeEventListener("dispose",o),delete s[f.id];let m=r.get(f);m&&(e.remove(m),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(h){let f=h.attributes;for(let m in f)e.update(f[m],i.ARRAY_BUFFER)}function c(h){let f=[],m=h.index,g=h.attributes.position,v=0;if(m!==null){let b=m.array;v=m.version;for(let M=0,y=b.length;M<y;M+=3){let P=b[M+0],E=b[M+1],I=b[M+2];f.push(P,E,E,I,I,P)}}else if(g!==void 0){let b=g.array;v=g.version;for(let M=0,y=b.length/3-1;M<y;M+=3){let P=M+0,E=M+1,I=M+2;f.push(P,E,E,I,I,P)}}else return;let p=new(If(f)?xa:va)(f,1);p.version=v;let d=r.get(h);d&&e.remove(d),r.set(h,p)}function u(h){let f=r.get(h);if(f){let m=h.index;m!==null&&f.version<m.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function rw(i,e,t){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,m){i.drawElements(n,m,r,f*o),t.update(m,n,1)}function c(f,m,g){g!==0&&(i.drawElementsInstanced(n,m,r,f*o,g),t.update(m,n,g))}function u(f,m,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,m,0,r,f,0,g);let p=0;for(let d=0;d<g;d++)p+=m[d];t.update(p,n,1)}function h(f,m,g,v){if(g===0)return;let p=e.get("WEBGL_multi_draw");if(p===null)for(let d=0;d<f.length;d++)c(f[d]/o,m[d],v[d]);else{p.multiDrawElementsInstancedWEBGL(n,m,0,r,f,0,v,0,g);let d=0;for(let b=0;b<g;b++)d+=m[b]*v[b];t.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function ow(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function aw(i,e,t){let n=new WeakMap,s=new It;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let w=function(){I.dispose(),n.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();let m=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],M=0;m===!0&&(M=1),g===!0&&(M=2),v===!0&&(M=3);let y=a.attributes.position.count*M,P=1;y>e.maxTextureSize&&(P=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let E=new Float32Array(y*P*4*h),I=new ma(E,y,P,h);I.type=es,I.needsUpdate=!0;let D=M*4;for(let S=0;S<h;S++){let A=p[S],k=d[S],B=b[S],V=y*P*4*S;for(let W=0;W<A.count;W++){let q=W*D;m===!0&&(s.fromBufferAttribute(A,W),E[V+q+0]=s.x,E[V+q+1]=s.y,E[V+q+2]=s.z,E[V+q+3]=0),g===!0&&(s.fromBufferAttribute(k,W),E[V+q+4]=s.x,E[V+q+5]=s.y,E[V+q+6]=s.z,E[V+q+7]=0),v===!0&&(s.fromBufferAttribute(B,W),E[V+q+8]=s.x,E[V+q+9]=s.y,E[V+q+10]=s.z,E[V+q+11]=B.itemSize===4?s.w:1)}}f={count:h,texture:I,size:new Be(y,P)},n.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let m=0;for(let v=0;v<c.length;v++)m+=c[v];let g=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function lw(i,e,t,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var Eg=new Kn,ag=new wa(1,1),Tg=new ma,Ag=new ac,Rg=new ya,lg=[],cg=[],hg=new Float32Array(16),ug=new Float32Array(9),fg=new Float32Array(4);function Ro(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=lg[s];if(r===void 0&&(r=new Float32Array(s),lg[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function cn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function hn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ch(i,e){let t=cg[e];t===void 0&&(t=new Int32Array(e),cg[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function cw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function hw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2fv(this.addr,e),hn(t,e)}}function uw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(cn(t,e))return;i.uniform3fv(this.addr,e),hn(t,e)}}function fw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4fv(this.addr,e),hn(t,e)}}function dw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;fg.set(n),i.uniformMatrix2fv(this.addr,!1,fg),hn(t,n)}}function pw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;ug.set(n),i.uniformMatrix3fv(this.addr,!1,ug),hn(t,n)}}function mw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;hg.set(n),i.uniformMatrix4fv(this.addr,!1,hg),hn(t,n)}}function gw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function vw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2iv(this.addr,e),hn(t,e)}}function xw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(cn(t,e))return;i.uniform3iv(this.addr,e),hn(t,e)}}function _w(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4iv(this.addr,e),hn(t,e)}}function yw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function bw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2uiv(this.addr,e),hn(t,e)}}function Mw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(cn(t,e))return;i.uniform3uiv(this.addr,e),hn(t,e)}}function ww(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4uiv(this.addr,e),hn(t,e)}}function Sw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(ag.compareFunction=Rf,r=ag):r=Eg,t.setTexture2D(e||r,s)}function Ew(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Ag,s)}function Tw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Rg,s)}function Aw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Tg,s)}function Rw(i){switch(i){case 5126:return cw;case 35664:return hw;case 35665:return uw;case 35666:return fw;case 35674:return dw;case 35675:return pw;case 35676:return mw;case 5124:case 35670:return gw;case 35667:case 35671:return vw;case 35668:case 35672:return xw;case 35669:case 35673:return _w;case 5125:return yw;case 36294:return bw;case 36295:return Mw;case 36296:return ww;case 35678:case 36198:case 36298:case 36306:case 35682:return Sw;case 35679:case 36299:case 36307:return Ew;case 35680:case 36300:case 36308:case 36293:return Tw;case 36289:case 36303:case 36311:case 36292:return Aw}}function Cw(i,e){i.uniform1fv(this.addr,e)}function Pw(i,e){let t=Ro(e,this.size,2);i.uniform2fv(this.addr,t)}function Iw(i,e){let t=Ro(e,this.size,3);i.uniform3fv(this.addr,t)}function Lw(i,e){let t=Ro(e,this.size,4);i.uniform4fv(this.addr,t)}function Dw(i,e){let t=Ro(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Uw(i,e){let t=Ro(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Nw(i,e){let t=Ro(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Fw(i,e){i.uniform1iv(this.addr,e)}function Ow(i,e){i.uniform2iv(this.addr,e)}function Bw(i,e){i.uniform3iv(this.addr,e)}function zw(i,e){i.uniform4iv(this.addr,e)}function kw(i,e){i.uniform1uiv(this.addr,e)}function Hw(i,e){i.uniform2uiv(this.addr,e)}function Vw(i,e){i.uniform3uiv(this.addr,e)}function Gw(i,e){i.uniform4uiv(this.addr,e)}function Ww(i,e,t){let n=this.cache,s=e.length,r=Ch(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||Eg,r[o])}function Xw(i,e,t){let n=this.cache,s=e.length,r=Ch(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Ag,r[o])}function qw(i,e,t){let n=this.cache,s=e.length,r=Ch(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Rg,r[o])}function Yw(i,e,t){let n=this.cache,s=e.length,r=Ch(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Tg,r[o])}function $w(i){switch(i){case 5126:return Cw;case 35664:return Pw;case 35665:return Iw;case 35666:return Lw;case 35674:return Dw;case 35675:return Uw;case 35676:return Nw;case 5124:case 35670:return Fw;case 35667:case 35671:return Ow;case 35668:case 35672:return Bw;case 35669:case 35673:return zw;case 5125:return kw;case 36294:return Hw;case 36295:return Vw;case 36296:return Gw;case 35678:case 36198:case 36298:case 36306:case 35682:return Ww;case 35679:case 36299:case 36307:return Xw;case 35680:case 36300:case 36308:case 36293:return qw;case 36289:case 36303:case 36311:case 36292:return Yw}}var Gf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Rw(t.type)}},Wf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=$w(t.type)}},Xf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Vf=/(\w+)(\])?(\[|\.)?/g;function dg(i,e){i.seq.push(e),i.map[e.id]=e}function Zw(i,e,t){let n=i.name,s=n.length;for(Vf.lastIndex=0;;){let r=Vf.exec(n),o=Vf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){dg(t,c===void 0?new Gf(a,i,e):new Wf(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new Xf(a),dg(t,h)),t=h}}}var Ao=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);Zw(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function pg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Kw=37297,Jw=0;function jw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var mg=new ct;function Qw(i){xt._getMatrix(mg,xt.workingColorSpace,i);let e=`mat3( ${mg.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(i)){case fa:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function gg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+jw(i.getShaderSource(e),a)}else return r}function eS(i,e){let t=Qw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function tS(i,e){let t;switch(e){case Lm:t="Linear";break;case Dm:t="Reinhard";break;case Um:t="Cineon";break;case Nm:t="ACESFilmic";break;case Om:t="AgX";break;case Bm:t="Neutral";break;case Fm:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Th=new L;function nS(){xt.getLuminanceCoefficients(Th);let i=Th.x.toFixed(4),e=Th.y.toFixed(4),t=Th.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function iS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($a).join(`
`)}function sS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function rS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function $a(i){return i!==""}function vg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function xg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var oS=/^[ \t]*#include +<([\w\d./]+)>/gm;function qf(i){return i.replace(oS,lS)}var aS=new Map;function lS(i,e){let t=ft[e];if(t===void 0){let n=aS.get(e);if(n!==void 0)t=ft[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return qf(t)}var cS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function _g(i){return i.replace(cS,hS)}function hS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function yg(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}function uS(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===df?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===um?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Qi&&(e="SHADOWMAP_TYPE_VSM"),e}function fS(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case gr:case vr:e="ENVMAP_TYPE_CUBE";break;case Ha:e="ENVMAP_TYPE_CUBE_UV";break}return e}function dS(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case vr:e="ENVMAP_MODE_REFRACTION";break}return e}function pS(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case vf:e="ENVMAP_BLENDING_MULTIPLY";break;case Pm:e="ENVMAP_BLENDING_MIX";break;case Im:e="ENVMAP_BLENDING_ADD";break}return e}function mS(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function gS(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=uS(t),c=fS(t),u=dS(t),h=pS(t),f=mS(t),m=iS(t),g=sS(r),v=s.createProgram(),p,d,b=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter($a).join(`
`),p.length>0&&(p+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter($a).join(`
`),d.length>0&&(d+=`
`)):(p=[yg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($a).join(`
`),d=[yg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==_s?"#define TONE_MAPPING":"",t.toneMapping!==_s?ft.tonemapping_pars_fragment:"",t.toneMapping!==_s?tS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,eS("linearToOutputTexel",t.outputColorSpace),nS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter($a).join(`
`)),o=qf(o),o=vg(o,t),o=xg(o,t),a=qf(a),a=vg(a,t),a=xg(a,t),o=_g(o),a=_g(a),t.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,p=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,d=["#define varying in",t.glslVersion===Cf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Cf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let M=b+p+o,y=b+d+a,P=pg(s,s.VERTEX_SHADER,M),E=pg(s,s.FRAGMENT_SHADER,y);s.attachShader(v,P),s.attachShader(v,E),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function I(A){if(i.debug.checkShaderErrors){let k=s.getProgramInfoLog(v)||"",B=s.getShaderInfoLog(P)||"",V=s.getShaderInfoLog(E)||"",W=k.trim(),q=B.trim(),N=V.trim(),z=!0,K=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,P,E);else{let ne=gg(s,P,"vertex"),te=gg(s,E,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+A.name+`
Material Type: `+A.type+`

Program Info Log: `+W+`
`+ne+`
`+te)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(q===""||N==="")&&(K=!1);K&&(A.diagnostics={runnable:z,programLog:W,vertexShader:{log:q,prefix:p},fragmentShader:{log:N,prefix:d}})}s.deleteShader(P),s.deleteShader(E),D=new Ao(s,v),w=rS(s,v)}let D;this.getUniforms=function(){return D===void 0&&I(this),D};let w;this.getAttributes=function(){return w===void 0&&I(this),w};let S=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,Kw)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Jw++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=P,this.fragmentShader=E,this}var vS=0,Yf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new $f(e),t.set(e,n)),n}},$f=class{constructor(e){this.id=vS++,this.code=e,this.usedTimes=0}};function xS(i,e,t,n,s,r,o){let a=new ga,l=new Yf,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,m=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function p(w,S,A,k,B){let V=k.fog,W=B.geometry,q=w.isMeshStandardMaterial?k.environment:null,N=(w.isMeshStandardMaterial?t:e).get(w.envMap||q),z=N&&N.mapping===Ha?N.image.height:null,K=g[w.type];w.precision!==null&&(m=s.getMaxPrecision(w.precision),m!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",m,"instead."));let ne=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,te=ne!==void 0?ne.length:0,le=0;W.morphAttributes.position!==void 0&&(le=1),W.morphAttributes.normal!==void 0&&(le=2),W.morphAttributes.color!==void 0&&(le=3);let fe,ye,_e,ee;if(K){let yt=Xn[K];fe=yt.vertexShader,ye=yt.fragmentShader}else fe=w.vertexShader,ye=w.fragmentShader,l.update(w),_e=l.getVertexShaderID(w),ee=l.getFragmentShaderID(w);let Y=i.getRenderTarget(),pe=i.state.buffers.depth.getReversed(),xe=B.isInstancedMesh===!0,we=B.isBatchedMesh===!0,Ve=!!w.map,dt=!!w.matcap,H=!!N,ht=!!w.aoMap,oe=!!w.lightMap,be=!!w.bumpMap,Ce=!!w.normalMap,ot=!!w.displacementMap,ae=!!w.emissiveMap,Le=!!w.metalnessMap,ce=!!w.roughnessMap,ue=w.anisotropy>0,C=w.clearcoat>0,_=w.dispersion>0,F=w.iridescence>0,J=w.sheen>0,j=w.transmission>0,ie=ue&&!!w.anisotropyMap,Pe=C&&!!w.clearcoatMap,ge=C&&!!w.clearcoatNormalMap,Oe=C&&!!w.clearcoatRoughnessMap,De=F&&!!w.iridescenceMap,ve=F&&!!w.iridescenceThicknessMap,Re=J&&!!w.sheenColorMap,qe=J&&!!w.sheenRoughnessMap,Ye=!!w.specularMap,Ue=!!w.specularColorMap,tt=!!w.specularIntensityMap,X=j&&!!w.transmissionMap,Ee=j&&!!w.thicknessMap,Ae=!!w.gradientMap,Ge=!!w.alphaMap,Se=w.alphaTest>0,me=!!w.alphaHash,$e=!!w.extensions,st=_s;w.toneMapped&&(Y===null||Y.isXRRenderTarget===!0)&&(st=i.toneMapping);let Lt={shaderID:K,shaderType:w.type,shaderName:w.name,vertexShader:fe,fragmentShader:ye,defines:w.defines,customVertexShaderID:_e,customFragmentShaderID:ee,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:m,batching:we,batchingColor:we&&B._colorsTexture!==null,instancing:xe,instancingColor:xe&&B.instanceColor!==null,instancingMorph:xe&&B.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:Y===null?i.outputColorSpace:Y.isXRRenderTarget===!0?Y.texture.colorSpace:cr,alphaToCoverage:!!w.alphaToCoverage,map:Ve,matcap:dt,envMap:H,envMapMode:H&&N.mapping,envMapCubeUVHeight:z,aoMap:ht,lightMap:oe,bumpMap:be,normalMap:Ce,displacementMap:f&&ot,emissiveMap:ae,normalMapObjectSpace:Ce&&w.normalMapType===Vm,normalMapTangentSpace:Ce&&w.normalMapType===Af,metalnessMap:Le,roughnessMap:ce,anisotropy:ue,anisotropyMap:ie,clearcoat:C,clearcoatMap:Pe,clearcoatNormalMap:ge,clearcoatRoughnessMap:Oe,dispersion:_,iridescence:F,iridescenceMap:De,iridescenceThicknessMap:ve,sheen:J,sheenColorMap:Re,sheenRoughnessMap:qe,specularMap:Ye,specularColorMap:Ue,specularIntensityMap:tt,transmission:j,transmissionMap:X,thicknessMap:Ee,gradientMap:Ae,opaque:w.transparent===!1&&w.blending===ar&&w.alphaToCoverage===!1,alphaMap:Ge,alphaTest:Se,alphaHash:me,combine:w.combine,mapUv:Ve&&v(w.map.channel),aoMapUv:ht&&v(w.aoMap.channel),lightMapUv:oe&&v(w.lightMap.channel),bumpMapUv:be&&v(w.bumpMap.channel),normalMapUv:Ce&&v(w.normalMap.channel),displacementMapUv:ot&&v(w.displacementMap.channel),emissiveMapUv:ae&&v(w.emissiveMap.channel),metalnessMapUv:Le&&v(w.metalnessMap.channel),roughnessMapUv:ce&&v(w.roughnessMap.channel),anisotropyMapUv:ie&&v(w.anisotropyMap.channel),clearcoatMapUv:Pe&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:ge&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Oe&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:De&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:Re&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:qe&&v(w.sheenRoughnessMap.channel),specularMapUv:Ye&&v(w.specularMap.channel),specularColorMapUv:Ue&&v(w.specularColorMap.channel),specularIntensityMapUv:tt&&v(w.specularIntensityMap.channel),transmissionMapUv:X&&v(w.transmissionMap.channel),thicknessMapUv:Ee&&v(w.thicknessMap.channel),alphaMapUv:Ge&&v(w.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Ce||ue),vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:B.isPoints===!0&&!!W.attributes.uv&&(Ve||Ge),fog:!!V,useFog:w.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:w.flatShading===!0&&w.wireframe===!1,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:pe,skinning:B.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:le,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:i.shadowMap.enabled&&A.length>0,shadowMapType:i.shadowMap.type,toneMapping:st,decodeVideoTexture:Ve&&w.map.isVideoTexture===!0&&xt.getTransfer(w.map.colorSpace)===Pt,decodeVideoTextureEmissive:ae&&w.emissiveMap.isVideoTexture===!0&&xt.getTransfer(w.emissiveMap.colorSpace)===Pt,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===Sn,flipSided:w.side===Wn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:$e&&w.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:($e&&w.extensions.multiDraw===!0||we)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return Lt.vertexUv1s=c.has(1),Lt.vertexUv2s=c.has(2),Lt.vertexUv3s=c.has(3),c.clear(),Lt}function d(w){let S=[];if(w.shaderID?S.push(w.shaderID):(S.push(w.customVertexShaderID),S.push(w.customFragmentShaderID)),w.defines!==void 0)for(let A in w.defines)S.push(A),S.push(w.defines[A]);return w.isRawShaderMaterial===!1&&(b(S,w),M(S,w),S.push(i.outputColorSpace)),S.push(w.customProgramCacheKey),S.join()}function b(w,S){w.push(S.precision),w.push(S.outputColorSpace),w.push(S.envMapMode),w.push(S.envMapCubeUVHeight),w.push(S.mapUv),w.push(S.alphaMapUv),w.push(S.lightMapUv),w.push(S.aoMapUv),w.push(S.bumpMapUv),w.push(S.normalMapUv),w.push(S.displacementMapUv),w.push(S.emissiveMapUv),w.push(S.metalnessMapUv),w.push(S.roughnessMapUv),w.push(S.anisotropyMapUv),w.push(S.clearcoatMapUv),w.push(S.clearcoatNormalMapUv),w.push(S.clearcoatRoughnessMapUv),w.push(S.iridescenceMapUv),w.push(S.iridescenceThicknessMapUv),w.push(S.sheenColorMapUv),w.push(S.sheenRoughnessMapUv),w.push(S.specularMapUv),w.push(S.specularColorMapUv),w.push(S.specularIntensityMapUv),w.push(S.transmissionMapUv),w.push(S.thicknessMapUv),w.push(S.combine),w.push(S.fogExp2),w.push(S.sizeAttenuation),w.push(S.morphTargetsCount),w.push(S.morphAttributeCount),w.push(S.numDirLights),w.push(S.numPointLights),w.push(S.numSpotLights),w.push(S.numSpotLightMaps),w.push(S.numHemiLights),w.push(S.numRectAreaLights),w.push(S.numDirLightShadows),w.push(S.numPointLightShadows),w.push(S.numSpotLightShadows),w.push(S.numSpotLightShadowsWithMaps),w.push(S.numLightProbes),w.push(S.shadowMapType),w.push(S.toneMapping),w.push(S.numClippingPlanes),w.push(S.numClipIntersection),w.push(S.depthPacking)}function M(w,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),S.gradientMap&&a.enable(22),w.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reversedDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),w.push(a.mask)}function y(w){let S=g[w.type],A;if(S){let k=Xn[S];A=Ya.clone(k.uniforms)}else A=w.uniforms;return A}function P(w,S){let A;for(let k=0,B=u.length;k<B;k++){let V=u[k];if(V.cacheKey===S){A=V,++A.usedTimes;break}}return A===void 0&&(A=new gS(i,S,w,r),u.push(A)),A}function E(w){if(--w.usedTimes===0){let S=u.indexOf(w);u[S]=u[u.length-1],u.pop(),w.destroy()}}function I(w){l.remove(w)}function D(){l.dispose()}return{getParameters:p,getProgramCacheKey:d,getUniforms:y,acquireProgram:P,releaseProgram:E,releaseShaderCache:I,programs:u,dispose:D}}function _S(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function yS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function bg(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Mg(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h,f,m,g,v,p){let d=i[e];return d===void 0?(d={id:h.id,object:h,geometry:f,material:m,groupOrder:g,renderOrder:h.renderOrder,z:v,group:p},i[e]=d):(d.id=h.id,d.object=h,d.geometry=f,d.material=m,d.groupOrder=g,d.renderOrder=h.renderOrder,d.z=v,d.group=p),e++,d}function a(h,f,m,g,v,p){let d=o(h,f,m,g,v,p);m.transmission>0?n.push(d):m.transparent===!0?s.push(d):t.push(d)}function l(h,f,m,g,v,p){let d=o(h,f,m,g,v,p);m.transmission>0?n.unshift(d):m.transparent===!0?s.unshift(d):t.unshift(d)}function c(h,f){t.length>1&&t.sort(h||yS),n.length>1&&n.sort(f||bg),s.length>1&&s.sort(f||bg)}function u(){for(let h=e,f=i.length;h<f;h++){let m=i[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function bS(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Mg,i.set(n,[o])):s>=r.length?(o=new Mg,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function MS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new L,color:new at};break;case"SpotLight":t={position:new L,direction:new L,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new L,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new L,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new L,halfWidth:new L,halfHeight:new L};break}return i[e.id]=t,t}}}function wS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Be};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Be};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Be,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var SS=0;function ES(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function TS(i){let e=new MS,t=wS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new L);let s=new L,r=new Ut,o=new Ut;function a(c){let u=0,h=0,f=0;for(let w=0;w<9;w++)n.probe[w].set(0,0,0);let m=0,g=0,v=0,p=0,d=0,b=0,M=0,y=0,P=0,E=0,I=0;c.sort(ES);for(let w=0,S=c.length;w<S;w++){let A=c[w],k=A.color,B=A.intensity,V=A.distance,W=A.shadow&&A.shadow.map?A.shadow.map.texture:null;if(A.isAmbientLight)u+=k.r*B,h+=k.g*B,f+=k.b*B;else if(A.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(A.sh.coefficients[q],B);I++}else if(A.isDirectionalLight){let q=e.get(A);if(q.color.copy(A.color).multiplyScalar(A.intensity),A.castShadow){let N=A.shadow,z=t.get(A);z.shadowIntensity=N.intensity,z.shadowBias=N.bias,z.shadowNormalBias=N.normalBias,z.shadowRadius=N.radius,z.shadowMapSize=N.mapSize,n.directionalShadow[m]=z,n.directionalShadowMap[m]=W,n.directionalShadowMatrix[m]=A.shadow.matrix,b++}n.directional[m]=q,m++}else if(A.isSpotLight){let q=e.get(A);q.position.setFromMatrixPosition(A.matrixWorld),q.color.copy(k).multiplyScalar(B),q.distance=V,q.coneCos=Math.cos(A.angle),q.penumbraCos=Math.cos(A.angle*(1-A.penumbra)),q.decay=A.decay,n.spot[v]=q;let N=A.shadow;if(A.map&&(n.spotLightMap[P]=A.map,P++,N.updateMatrices(A),A.castShadow&&E++),n.spotLightMatrix[v]=N.matrix,A.castShadow){let z=t.get(A);z.shadowIntensity=N.intensity,z.shadowBias=N.bias,z.shadowNormalBias=N.normalBias,z.shadowRadius=N.radius,z.shadowMapSize=N.mapSize,n.spotShadow[v]=z,n.spotShadowMap[v]=W,y++}v++}else if(A.isRectAreaLight){let q=e.get(A);q.color.copy(k).multiplyScalar(B),q.halfWidth.set(A.width*.5,0,0),q.halfHeight.set(0,A.height*.5,0),n.rectArea[p]=q,p++}else if(A.isPointLight){let q=e.get(A);if(q.color.copy(A.color).multiplyScalar(A.intensity),q.distance=A.distance,q.decay=A.decay,A.castShadow){let N=A.shadow,z=t.get(A);z.shadowIntensity=N.intensity,z.shadowBias=N.bias,z.shadowNormalBias=N.normalBias,z.shadowRadius=N.radius,z.shadowMapSize=N.mapSize,z.shadowCameraNear=N.camera.near,z.shadowCameraFar=N.camera.far,n.pointShadow[g]=z,n.pointShadowMap[g]=W,n.pointShadowMatrix[g]=A.shadow.matrix,M++}n.point[g]=q,g++}else if(A.isHemisphereLight){let q=e.get(A);q.skyColor.copy(A.color).multiplyScalar(B),q.groundColor.copy(A.groundColor).multiplyScalar(B),n.hemi[d]=q,d++}}p>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ne.LTC_FLOAT_1,n.rectAreaLTC2=Ne.LTC_FLOAT_2):(n.rectAreaLTC1=Ne.LTC_HALF_1,n.rectAreaLTC2=Ne.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let D=n.hash;(D.directionalLength!==m||D.pointLength!==g||D.spotLength!==v||D.rectAreaLength!==p||D.hemiLength!==d||D.numDirectionalShadows!==b||D.numPointShadows!==M||D.numSpotShadows!==y||D.numSpotMaps!==P||D.numLightProbes!==I)&&(n.directional.length=m,n.spot.length=v,n.rectArea.length=p,n.point.length=g,n.hemi.length=d,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.pointShadow.length=M,n.pointShadowMap.length=M,n.spotShadow.length=y,n.spotShadowMap.length=y,n.directionalShadowMatrix.length=b,n.pointShadowMatrix.length=M,n.spotLightMatrix.length=y+P-E,n.spotLightMap.length=P,n.numSpotLightShadowsWithMaps=E,n.numLightProbes=I,D.directionalLength=m,D.pointLength=g,D.spotLength=v,D.rectAreaLength=p,D.hemiLength=d,D.numDirectionalShadows=b,D.numPointShadows=M,D.numSpotShadows=y,D.numSpotMaps=P,D.numLightProbes=I,n.version=SS++)}function l(c,u){let h=0,f=0,m=0,g=0,v=0,p=u.matrixWorldInverse;for(let d=0,b=c.length;d<b;d++){let M=c[d];if(M.isDirectionalLight){let y=n.directional[h];y.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(p),h++}else if(M.isSpotLight){let y=n.spot[m];y.position.setFromMatrixPosition(M.matrixWorld),y.position.applyMatrix4(p),y.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(p),m++}else if(M.isRectAreaLight){let y=n.rectArea[g];y.position.setFromMatrixPosition(M.matrixWorld),y.position.applyMatrix4(p),o.identity(),r.copy(M.matrixWorld),r.premultiply(p),o.extractRotation(r),y.halfWidth.set(M.width*.5,0,0),y.halfHeight.set(0,M.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),g++}else if(M.isPointLight){let y=n.point[f];y.position.setFromMatrixPosition(M.matrixWorld),y.position.applyMatrix4(p),f++}else if(M.isHemisphereLight){let y=n.hemi[v];y.direction.setFromMatrixPosition(M.matrixWorld),y.direction.transformDirection(p),v++}}}return{setup:a,setupView:l,state:n}}function wg(i){let e=new TS(i),t=[],n=[];function s(u){c.camera=u,t.length=0,n.length=0}function r(u){t.push(u)}function o(u){n.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function AS(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new wg(i),e.set(s,[a])):r>=o.length?(a=new wg(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var RS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,CS=`uniform sampler2D shadow_pass;
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
}`;function PS(i,e,t){let n=new xo,s=new Be,r=new Be,o=new It,a=new yc({depthPacking:Hm}),l=new bc,c={},u=t.maxTextureSize,h={[gs]:Wn,[Wn]:gs,[Sn]:Sn},f=new ai({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Be},radius:{value:4}},vertexShader:RS,fragmentShader:CS}),m=f.clone();m.defines.HORIZONTAL_PASS=1;let g=new Ot;g.setAttribute("position",new Jt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Je(g,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=df;let d=this.type;this.render=function(E,I,D){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;let w=i.getRenderTarget(),S=i.getActiveCubeFace(),A=i.getActiveMipmapLevel(),k=i.state;k.setBlending(xs),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let B=d!==Qi&&this.type===Qi,V=d===Qi&&this.type!==Qi;for(let W=0,q=E.length;W<q;W++){let N=E[W],z=N.shadow;if(z===void 0){console.warn("THREE.WebGLShadowMap:",N,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let K=z.getFrameExtents();if(s.multiply(K),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/K.x),s.x=r.x*K.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/K.y),s.y=r.y*K.y,z.mapSize.y=r.y)),z.map===null||B===!0||V===!0){let te=this.type!==Qi?{minFilter:vi,magFilter:vi}:{};z.map!==null&&z.map.dispose(),z.map=new Ki(s.x,s.y,te),z.map.texture.name=N.name+".shadowMap",z.camera.updateProjectionMatrix()}i.setRenderTarget(z.map),i.clear();let ne=z.getViewportCount();for(let te=0;te<ne;te++){let le=z.getViewport(te);o.set(r.x*le.x,r.y*le.y,r.x*le.z,r.y*le.w),k.viewport(o),z.updateMatrices(N,te),n=z.getFrustum(),y(I,D,z.camera,N,this.type)}z.isPointLightShadow!==!0&&this.type===Qi&&b(z,D),z.needsUpdate=!1}d=this.type,p.needsUpdate=!1,i.setRenderTarget(w,S,A)};function b(E,I){let D=e.update(v);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null&&(E.mapPass=new Ki(s.x,s.y)),f.uniforms.shadow_pass.value=E.map.texture,f.uniforms.resolution.value=E.mapSize,f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(I,null,D,f,v,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value=E.mapSize,m.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(I,null,D,m,v,null)}function M(E,I,D,w){let S=null,A=D.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(A!==void 0)S=A;else if(S=D.isPointLight===!0?l:a,i.localClippingEnabled&&I.clipShadows===!0&&Array.isArray(I.clippingPlanes)&&I.clippingPlanes.length!==0||I.displacementMap&&I.displacementScale!==0||I.alphaMap&&I.alphaTest>0||I.map&&I.alphaTest>0||I.alphaToCoverage===!0){let k=S.uuid,B=I.uuid,V=c[k];V===void 0&&(V={},c[k]=V);let W=V[B];W===void 0&&(W=S.clone(),V[B]=W,I.addEventListener("dispose",P)),S=W}if(S.visible=I.visible,S.wireframe=I.wireframe,w===Qi?S.side=I.shadowSide!==null?I.shadowSide:I.side:S.side=I.shadowSide!==null?I.shadowSide:h[I.side],S.alphaMap=I.alphaMap,S.alphaTest=I.alphaToCoverage===!0?.5:I.alphaTest,S.map=I.map,S.clipShadows=I.clipShadows,S.clippingPlanes=I.clippingPlanes,S.clipIntersection=I.clipIntersection,S.displacementMap=I.displacementMap,S.displacementScale=I.displacementScale,S.displacementBias=I.displacementBias,S.wireframeLinewidth=I.wireframeLinewidth,S.linewidth=I.linewidth,D.isPointLight===!0&&S.isMeshDistanceMaterial===!0){let k=i.properties.get(S);k.light=D}return S}function y(E,I,D,w,S){if(E.visible===!1)return;if(E.layers.test(I.layers)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&S===Qi)&&(!E.frustumCulled||n.intersectsObject(E))){E.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,E.matrixWorld);let B=e.update(E),V=E.material;if(Array.isArray(V)){let W=B.groups;for(let q=0,N=W.length;q<N;q++){let z=W[q],K=V[z.materialIndex];if(K&&K.visible){let ne=M(E,K,w,S);E.onBeforeShadow(i,E,I,D,B,ne,z),i.renderBufferDirect(D,null,B,ne,E,z),E.onAfterShadow(i,E,I,D,B,ne,z)}}}else if(V.visible){let W=M(E,V,w,S);E.onBeforeShadow(i,E,I,D,B,W,null),i.renderBufferDirect(D,null,B,W,E,null),E.onAfterShadow(i,E,I,D,B,W,null)}}let k=E.children;for(let B=0,V=k.length;B<V;B++)y(k[B],I,D,w,S)}function P(E){E.target.removeEventListener("dispose",P);for(let D in c){let w=c[D],S=E.target.uuid;S in w&&(w[S].dispose(),delete w[S])}}}var IS={[Lc]:Dc,[Uc]:Oc,[Nc]:Bc,[lr]:Fc,[Dc]:Lc,[Oc]:Uc,[Bc]:Nc,[Fc]:lr};function LS(i,e){function t(){let X=!1,Ee=new It,Ae=null,Ge=new It(0,0,0,0);return{setMask:function(Se){Ae!==Se&&!X&&(i.colorMask(Se,Se,Se,Se),Ae=Se)},setLocked:function(Se){X=Se},setClear:function(Se,me,$e,st,Lt){Lt===!0&&(Se*=st,me*=st,$e*=st),Ee.set(Se,me,$e,st),Ge.equals(Ee)===!1&&(i.clearColor(Se,me,$e,st),Ge.copy(Ee))},reset:function(){X=!1,Ae=null,Ge.set(-1,0,0,0)}}}function n(){let X=!1,Ee=!1,Ae=null,Ge=null,Se=null;return{setReversed:function(me){if(Ee!==me){let $e=e.get("EXT_clip_control");me?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),Ee=me;let st=Se;Se=null,this.setClear(st)}},getReversed:function(){return Ee},setTest:function(me){me?Y(i.DEPTH_TEST):pe(i.DEPTH_TEST)},setMask:function(me){Ae!==me&&!X&&(i.depthMask(me),Ae=me)},setFunc:function(me){if(Ee&&(me=IS[me]),Ge!==me){switch(me){case Lc:i.depthFunc(i.NEVER);break;case Dc:i.depthFunc(i.ALWAYS);break;case Uc:i.depthFunc(i.LESS);break;case lr:i.depthFunc(i.LEQUAL);break;case Nc:i.depthFunc(i.EQUAL);break;case Fc:i.depthFunc(i.GEQUAL);break;case Oc:i.depthFunc(i.GREATER);break;case Bc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ge=me}},setLocked:function(me){X=me},setClear:function(me){Se!==me&&(Ee&&(me=1-me),i.clearDepth(me),Se=me)},reset:function(){X=!1,Ae=null,Ge=null,Se=null,Ee=!1}}}function s(){let X=!1,Ee=null,Ae=null,Ge=null,Se=null,me=null,$e=null,st=null,Lt=null;return{setTest:function(yt){X||(yt?Y(i.STENCIL_TEST):pe(i.STENCIL_TEST))},setMask:function(yt){Ee!==yt&&!X&&(i.stencilMask(yt),Ee=yt)},setFunc:function(yt,bn,Ft){(Ae!==yt||Ge!==bn||Se!==Ft)&&(i.stencilFunc(yt,bn,Ft),Ae=yt,Ge=bn,Se=Ft)},setOp:function(yt,bn,Ft){(me!==yt||$e!==bn||st!==Ft)&&(i.stencilOp(yt,bn,Ft),me=yt,$e=bn,st=Ft)},setLocked:function(yt){X=yt},setClear:function(yt){Lt!==yt&&(i.clearStencil(yt),Lt=yt)},reset:function(){X=!1,Ee=null,Ae=null,Ge=null,Se=null,me=null,$e=null,st=null,Lt=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,m=[],g=null,v=!1,p=null,d=null,b=null,M=null,y=null,P=null,E=null,I=new at(0,0,0),D=0,w=!1,S=null,A=null,k=null,B=null,V=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,N=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(N=parseFloat(/^WebGL (\d)/.exec(z)[1]),q=N>=1):z.indexOf("OpenGL ES")!==-1&&(N=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),q=N>=2);let K=null,ne={},te=i.getParameter(i.SCISSOR_BOX),le=i.getParameter(i.VIEWPORT),fe=new It().fromArray(te),ye=new It().fromArray(le);function _e(X,Ee,Ae,Ge){let Se=new Uint8Array(4),me=i.createTexture();i.bindTexture(X,me),i.texParameteri(X,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(X,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let $e=0;$e<Ae;$e++)X===i.TEXTURE_3D||X===i.TEXTURE_2D_ARRAY?i.texImage3D(Ee,0,i.RGBA,1,1,Ge,0,i.RGBA,i.UNSIGNED_BYTE,Se):i.texImage2D(Ee+$e,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Se);return me}let ee={};ee[i.TEXTURE_2D]=_e(i.TEXTURE_2D,i.TEXTURE_2D,1),ee[i.TEXTURE_CUBE_MAP]=_e(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ee[i.TEXTURE_2D_ARRAY]=_e(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ee[i.TEXTURE_3D]=_e(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Y(i.DEPTH_TEST),o.setFunc(lr),be(!1),Ce(ff),Y(i.CULL_FACE),ht(xs);function Y(X){u[X]!==!0&&(i.enable(X),u[X]=!0)}function pe(X){u[X]!==!1&&(i.disable(X),u[X]=!1)}function xe(X,Ee){return h[X]!==Ee?(i.bindFramebuffer(X,Ee),h[X]=Ee,X===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=Ee),X===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=Ee),!0):!1}function we(X,Ee){let Ae=m,Ge=!1;if(X){Ae=f.get(Ee),Ae===void 0&&(Ae=[],f.set(Ee,Ae));let Se=X.textures;if(Ae.length!==Se.length||Ae[0]!==i.COLOR_ATTACHMENT0){for(let me=0,$e=Se.length;me<$e;me++)Ae[me]=i.COLOR_ATTACHMENT0+me;Ae.length=Se.length,Ge=!0}}else Ae[0]!==i.BACK&&(Ae[0]=i.BACK,Ge=!0);Ge&&i.drawBuffers(Ae)}function Ve(X){return g!==X?(i.useProgram(X),g=X,!0):!1}let dt={[Os]:i.FUNC_ADD,[dm]:i.FUNC_SUBTRACT,[pm]:i.FUNC_REVERSE_SUBTRACT};dt[mm]=i.MIN,dt[gm]=i.MAX;let H={[vm]:i.ZERO,[xm]:i.ONE,[_m]:i.SRC_COLOR,[Ql]:i.SRC_ALPHA,[Em]:i.SRC_ALPHA_SATURATE,[wm]:i.DST_COLOR,[bm]:i.DST_ALPHA,[ym]:i.ONE_MINUS_SRC_COLOR,[ec]:i.ONE_MINUS_SRC_ALPHA,[Sm]:i.ONE_MINUS_DST_COLOR,[Mm]:i.ONE_MINUS_DST_ALPHA,[Tm]:i.CONSTANT_COLOR,[Am]:i.ONE_MINUS_CONSTANT_COLOR,[Rm]:i.CONSTANT_ALPHA,[Cm]:i.ONE_MINUS_CONSTANT_ALPHA};function ht(X,Ee,Ae,Ge,Se,me,$e,st,Lt,yt){if(X===xs){v===!0&&(pe(i.BLEND),v=!1);return}if(v===!1&&(Y(i.BLEND),v=!0),X!==fm){if(X!==p||yt!==w){if((d!==Os||y!==Os)&&(i.blendEquation(i.FUNC_ADD),d=Os,y=Os),yt)switch(X){case ar:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pf:i.blendFunc(i.ONE,i.ONE);break;case mf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case gf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",X);break}else switch(X){case ar:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case mf:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case gf:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",X);break}b=null,M=null,P=null,E=null,I.set(0,0,0),D=0,p=X,w=yt}return}Se=Se||Ee,me=me||Ae,$e=$e||Ge,(Ee!==d||Se!==y)&&(i.blendEquationSeparate(dt[Ee],dt[Se]),d=Ee,y=Se),(Ae!==b||Ge!==M||me!==P||$e!==E)&&(i.blendFuncSeparate(H[Ae],H[Ge],H[me],H[$e]),b=Ae,M=Ge,P=me,E=$e),(st.equals(I)===!1||Lt!==D)&&(i.blendColor(st.r,st.g,st.b,Lt),I.copy(st),D=Lt),p=X,w=!1}function oe(X,Ee){X.side===Sn?pe(i.CULL_FACE):Y(i.CULL_FACE);let Ae=X.side===Wn;Ee&&(Ae=!Ae),be(Ae),X.blending===ar&&X.transparent===!1?ht(xs):ht(X.blending,X.blendEquation,X.blendSrc,X.blendDst,X.blendEquationAlpha,X.blendSrcAlpha,X.blendDstAlpha,X.blendColor,X.blendAlpha,X.premultipliedAlpha),o.setFunc(X.depthFunc),o.setTest(X.depthTest),o.setMask(X.depthWrite),r.setMask(X.colorWrite);let Ge=X.stencilWrite;a.setTest(Ge),Ge&&(a.setMask(X.stencilWriteMask),a.setFunc(X.stencilFunc,X.stencilRef,X.stencilFuncMask),a.setOp(X.stencilFail,X.stencilZFail,X.stencilZPass)),ae(X.polygonOffset,X.polygonOffsetFactor,X.polygonOffsetUnits),X.alphaToCoverage===!0?Y(i.SAMPLE_ALPHA_TO_COVERAGE):pe(i.SAMPLE_ALPHA_TO_COVERAGE)}function be(X){S!==X&&(X?i.frontFace(i.CW):i.frontFace(i.CCW),S=X)}function Ce(X){X!==cm?(Y(i.CULL_FACE),X!==A&&(X===ff?i.cullFace(i.BACK):X===hm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):pe(i.CULL_FACE),A=X}function ot(X){X!==k&&(q&&i.lineWidth(X),k=X)}function ae(X,Ee,Ae){X?(Y(i.POLYGON_OFFSET_FILL),(B!==Ee||V!==Ae)&&(i.polygonOffset(Ee,Ae),B=Ee,V=Ae)):pe(i.POLYGON_OFFSET_FILL)}function Le(X){X?Y(i.SCISSOR_TEST):pe(i.SCISSOR_TEST)}function ce(X){X===void 0&&(X=i.TEXTURE0+W-1),K!==X&&(i.activeTexture(X),K=X)}function ue(X,Ee,Ae){Ae===void 0&&(K===null?Ae=i.TEXTURE0+W-1:Ae=K);let Ge=ne[Ae];Ge===void 0&&(Ge={type:void 0,texture:void 0},ne[Ae]=Ge),(Ge.type!==X||Ge.texture!==Ee)&&(K!==Ae&&(i.activeTexture(Ae),K=Ae),i.bindTexture(X,Ee||ee[X]),Ge.type=X,Ge.texture=Ee)}function C(){let X=ne[K];X!==void 0&&X.type!==void 0&&(i.bindTexture(X.type,null),X.type=void 0,X.texture=void 0)}function _(){try{i.compressedTexImage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function F(){try{i.compressedTexImage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function J(){try{i.texSubImage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function j(){try{i.texSubImage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function ie(){try{i.compressedTexSubImage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function Pe(){try{i.compressedTexSubImage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function ge(){try{i.texStorage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function Oe(){try{i.texStorage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function De(){try{i.texImage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function ve(){try{i.texImage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function Re(X){fe.equals(X)===!1&&(i.scissor(X.x,X.y,X.z,X.w),fe.copy(X))}function qe(X){ye.equals(X)===!1&&(i.viewport(X.x,X.y,X.z,X.w),ye.copy(X))}function Ye(X,Ee){let Ae=c.get(Ee);Ae===void 0&&(Ae=new WeakMap,c.set(Ee,Ae));let Ge=Ae.get(X);Ge===void 0&&(Ge=i.getUniformBlockIndex(Ee,X.name),Ae.set(X,Ge))}function Ue(X,Ee){let Ge=c.get(Ee).get(X);l.get(Ee)!==Ge&&(i.uniformBlockBinding(Ee,Ge,X.__bindingPointIndex),l.set(Ee,Ge))}function tt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},K=null,ne={},h={},f=new WeakMap,m=[],g=null,v=!1,p=null,d=null,b=null,M=null,y=null,P=null,E=null,I=new at(0,0,0),D=0,w=!1,S=null,A=null,k=null,B=null,V=null,fe.set(0,0,i.canvas.width,i.canvas.height),ye.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Y,disable:pe,bindFramebuffer:xe,drawBuffers:we,useProgram:Ve,setBlending:ht,setMaterial:oe,setFlipSided:be,setCullFace:Ce,setLineWidth:ot,setPolygonOffset:ae,setScissorTest:Le,activeTexture:ce,bindTexture:ue,unbindTexture:C,compressedTexImage2D:_,compressedTexImage3D:F,texImage2D:De,texImage3D:ve,updateUBOMapping:Ye,uniformBlockBinding:Ue,texStorage2D:ge,texStorage3D:Oe,texSubImage2D:J,texSubImage3D:j,compressedTexSubImage2D:ie,compressedTexSubImage3D:Pe,scissor:Re,viewport:qe,reset:tt}}function DS(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Be,u=new WeakMap,h,f=new WeakMap,m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(C,_){return m?new OffscreenCanvas(C,_):pa("canvas")}function v(C,_,F){let J=1,j=ue(C);if((j.width>F||j.height>F)&&(J=F/Math.max(j.width,j.height)),J<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ie=Math.floor(J*j.width),Pe=Math.floor(J*j.height);h===void 0&&(h=g(ie,Pe));let ge=_?g(ie,Pe):h;return ge.width=ie,ge.height=Pe,ge.getContext("2d").drawImage(C,0,0,ie,Pe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+ie+"x"+Pe+")."),ge}else return"data"in C&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),C;return C}function p(C){return C.generateMipmaps}function d(C){i.generateMipmap(C)}function b(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(C,_,F,J,j=!1){if(C!==null){if(i[C]!==void 0)return i[C];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ie=_;if(_===i.RED&&(F===i.FLOAT&&(ie=i.R32F),F===i.HALF_FLOAT&&(ie=i.R16F),F===i.UNSIGNED_BYTE&&(ie=i.R8)),_===i.RED_INTEGER&&(F===i.UNSIGNED_BYTE&&(ie=i.R8UI),F===i.UNSIGNED_SHORT&&(ie=i.R16UI),F===i.UNSIGNED_INT&&(ie=i.R32UI),F===i.BYTE&&(ie=i.R8I),F===i.SHORT&&(ie=i.R16I),F===i.INT&&(ie=i.R32I)),_===i.RG&&(F===i.FLOAT&&(ie=i.RG32F),F===i.HALF_FLOAT&&(ie=i.RG16F),F===i.UNSIGNED_BYTE&&(ie=i.RG8)),_===i.RG_INTEGER&&(F===i.UNSIGNED_BYTE&&(ie=i.RG8UI),F===i.UNSIGNED_SHORT&&(ie=i.RG16UI),F===i.UNSIGNED_INT&&(ie=i.RG32UI),F===i.BYTE&&(ie=i.RG8I),F===i.SHORT&&(ie=i.RG16I),F===i.INT&&(ie=i.RG32I)),_===i.RGB_INTEGER&&(F===i.UNSIGNED_BYTE&&(ie=i.RGB8UI),F===i.UNSIGNED_SHORT&&(ie=i.RGB16UI),F===i.UNSIGNED_INT&&(ie=i.RGB32UI),F===i.BYTE&&(ie=i.RGB8I),F===i.SHORT&&(ie=i.RGB16I),F===i.INT&&(ie=i.RGB32I)),_===i.RGBA_INTEGER&&(F===i.UNSIGNED_BYTE&&(ie=i.RGBA8UI),F===i.UNSIGNED_SHORT&&(ie=i.RGBA16UI),F===i.UNSIGNED_INT&&(ie=i.RGBA32UI),F===i.BYTE&&(ie=i.RGBA8I),F===i.SHORT&&(ie=i.RGBA16I),F===i.INT&&(ie=i.RGBA32I)),_===i.RGB&&(F===i.UNSIGNED_INT_5_9_9_9_REV&&(ie=i.RGB9_E5),F===i.UNSIGNED_INT_10F_11F_11F_REV&&(ie=i.R11F_G11F_B10F)),_===i.RGBA){let Pe=j?fa:xt.getTransfer(J);F===i.FLOAT&&(ie=i.RGBA32F),F===i.HALF_FLOAT&&(ie=i.RGBA16F),F===i.UNSIGNED_BYTE&&(ie=Pe===Pt?i.SRGB8_ALPHA8:i.RGBA8),F===i.UNSIGNED_SHORT_4_4_4_4&&(ie=i.RGBA4),F===i.UNSIGNED_SHORT_5_5_5_1&&(ie=i.RGB5_A1)}return(ie===i.R16F||ie===i.R32F||ie===i.RG16F||ie===i.RG32F||ie===i.RGBA16F||ie===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function y(C,_){let F;return C?_===null||_===Ws||_===wo?F=i.DEPTH24_STENCIL8:_===es?F=i.DEPTH32F_STENCIL8:_===bo&&(F=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):_===null||_===Ws||_===wo?F=i.DEPTH_COMPONENT24:_===es?F=i.DEPTH_COMPONENT32F:_===bo&&(F=i.DEPTH_COMPONENT16),F}function P(C,_){return p(C)===!0||C.isFramebufferTexture&&C.minFilter!==vi&&C.minFilter!==Li?Math.log2(Math.max(_.width,_.height))+1:C.mipmaps!==void 0&&C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?_.mipmaps.length:1}function E(C){let _=C.target;_.removeEventListener("dispose",E),D(_),_.isVideoTexture&&u.delete(_)}function I(C){let _=C.target;_.removeEventListener("dispose",I),S(_)}function D(C){let _=n.get(C);if(_.__webglInit===void 0)return;let F=C.source,J=f.get(F);if(J){let j=J[_.__cacheKey];j.usedTimes--,j.usedTimes===0&&w(C),Object.keys(J).length===0&&f.delete(F)}n.remove(C)}function w(C){let _=n.get(C);i.deleteTexture(_.__webglTexture);let F=C.source,J=f.get(F);delete J[_.__cacheKey],o.memory.textures--}function S(C){let _=n.get(C);if(C.depthTexture&&(C.depthTexture.dispose(),n.remove(C.depthTexture)),C.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(_.__webglFramebuffer[J]))for(let j=0;j<_.__webglFramebuffer[J].length;j++)i.deleteFramebuffer(_.__webglFramebuffer[J][j]);else i.deleteFramebuffer(_.__webglFramebuffer[J]);_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer[J])}else{if(Array.isArray(_.__webglFramebuffer))for(let J=0;J<_.__webglFramebuffer.length;J++)i.deleteFramebuffer(_.__webglFramebuffer[J]);else i.deleteFramebuffer(_.__webglFramebuffer);if(_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer),_.__webglMultisampledFramebuffer&&i.deleteFramebuffer(_.__webglMultisampledFramebuffer),_.__webglColorRenderbuffer)for(let J=0;J<_.__webglColorRenderbuffer.length;J++)_.__webglColorRenderbuffer[J]&&i.deleteRenderbuffer(_.__webglColorRenderbuffer[J]);_.__webglDepthRenderbuffer&&i.deleteRenderbuffer(_.__webglDepthRenderbuffer)}let F=C.textures;for(let J=0,j=F.length;J<j;J++){let ie=n.get(F[J]);ie.__webglTexture&&(i.deleteTexture(ie.__webglTexture),o.memory.textures--),n.remove(F[J])}n.remove(C)}let A=0;function k(){A=0}function B(){let C=A;return C>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+C+" texture units while this GPU supports only "+s.maxTextures),A+=1,C}function V(C){let _=[];return _.push(C.wrapS),_.push(C.wrapT),_.push(C.wrapR||0),_.push(C.magFilter),_.push(C.minFilter),_.push(C.anisotropy),_.push(C.internalFormat),_.push(C.format),_.push(C.type),_.push(C.generateMipmaps),_.push(C.premultiplyAlpha),_.push(C.flipY),_.push(C.unpackAlignment),_.push(C.colorSpace),_.join()}function W(C,_){let F=n.get(C);if(C.isVideoTexture&&Le(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&F.__version!==C.version){let J=C.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ee(F,C,_);return}}else C.isExternalTexture&&(F.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,F.__webglTexture,i.TEXTURE0+_)}function q(C,_){let F=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&F.__version!==C.version){ee(F,C,_);return}t.bindTexture(i.TEXTURE_2D_ARRAY,F.__webglTexture,i.TEXTURE0+_)}function N(C,_){let F=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&F.__version!==C.version){ee(F,C,_);return}t.bindTexture(i.TEXTURE_3D,F.__webglTexture,i.TEXTURE0+_)}function z(C,_){let F=n.get(C);if(C.version>0&&F.__version!==C.version){Y(F,C,_);return}t.bindTexture(i.TEXTURE_CUBE_MAP,F.__webglTexture,i.TEXTURE0+_)}let K={[tc]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[nc]:i.MIRRORED_REPEAT},ne={[vi]:i.NEAREST,[zm]:i.NEAREST_MIPMAP_NEAREST,[Va]:i.NEAREST_MIPMAP_LINEAR,[Li]:i.LINEAR,[Hc]:i.LINEAR_MIPMAP_NEAREST,[Gs]:i.LINEAR_MIPMAP_LINEAR},te={[Gm]:i.NEVER,[Zm]:i.ALWAYS,[Wm]:i.LESS,[Rf]:i.LEQUAL,[Xm]:i.EQUAL,[$m]:i.GEQUAL,[qm]:i.GREATER,[Ym]:i.NOTEQUAL};function le(C,_){if(_.type===es&&e.has("OES_texture_float_linear")===!1&&(_.magFilter===Li||_.magFilter===Hc||_.magFilter===Va||_.magFilter===Gs||_.minFilter===Li||_.minFilter===Hc||_.minFilter===Va||_.minFilter===Gs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,K[_.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,K[_.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,K[_.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,ne[_.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,ne[_.minFilter]),_.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,te[_.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(_.magFilter===vi||_.minFilter!==Va&&_.minFilter!==Gs||_.type===es&&e.has("OES_texture_float_linear")===!1)return;if(_.anisotropy>1||n.get(_).__currentAnisotropy){let F=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,F.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(_.anisotropy,s.getMaxAnisotropy())),n.get(_).__currentAnisotropy=_.anisotropy}}}function fe(C,_){let F=!1;C.__webglInit===void 0&&(C.__webglInit=!0,_.addEventListener("dispose",E));let J=_.source,j=f.get(J);j===void 0&&(j={},f.set(J,j));let ie=V(_);if(ie!==C.__cacheKey){j[ie]===void 0&&(j[ie]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,F=!0),j[ie].usedTimes++;let Pe=j[C.__cacheKey];Pe!==void 0&&(j[C.__cacheKey].usedTimes--,Pe.usedTimes===0&&w(_)),C.__cacheKey=ie,C.__webglTexture=j[ie].texture}return F}function ye(C,_,F){return Math.floor(Math.floor(C/F)/_)}function _e(C,_,F,J){let ie=C.updateRanges;if(ie.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,_.width,_.height,F,J,_.data);else{ie.sort((ve,Re)=>ve.start-Re.start);let Pe=0;for(let ve=1;ve<ie.length;ve++){let Re=ie[Pe],qe=ie[ve],Ye=Re.start+Re.count,Ue=ye(qe.start,_.width,4),tt=ye(Re.start,_.width,4);qe.start<=Ye+1&&Ue===tt&&ye(qe.start+qe.count-1,_.width,4)===Ue?Re.count=Math.max(Re.count,qe.start+qe.count-Re.start):(++Pe,ie[Pe]=qe)}ie.length=Pe+1;let ge=i.getParameter(i.UNPACK_ROW_LENGTH),Oe=i.getParameter(i.UNPACK_SKIP_PIXELS),De=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,_.width);for(let ve=0,Re=ie.length;ve<Re;ve++){let qe=ie[ve],Ye=Math.floor(qe.start/4),Ue=Math.ceil(qe.count/4),tt=Ye%_.width,X=Math.floor(Ye/_.width),Ee=Ue,Ae=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,tt),i.pixelStorei(i.UNPACK_SKIP_ROWS,X),t.texSubImage2D(i.TEXTURE_2D,0,tt,X,Ee,Ae,F,J,_.data)}C.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,ge),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Oe),i.pixelStorei(i.UNPACK_SKIP_ROWS,De)}}function ee(C,_,F){let J=i.TEXTURE_2D;(_.isDataArrayTexture||_.isCompressedArrayTexture)&&(J=i.TEXTURE_2D_ARRAY),_.isData3DTexture&&(J=i.TEXTURE_3D);let j=fe(C,_),ie=_.source;t.bindTexture(J,C.__webglTexture,i.TEXTURE0+F);let Pe=n.get(ie);if(ie.version!==Pe.__version||j===!0){t.activeTexture(i.TEXTURE0+F);let ge=xt.getPrimaries(xt.workingColorSpace),Oe=_.colorSpace===ys?null:xt.getPrimaries(_.colorSpace),De=_.colorSpace===ys||ge===Oe?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,De);let ve=v(_.image,!1,s.maxTextureSize);ve=ce(_,ve);let Re=r.convert(_.format,_.colorSpace),qe=r.convert(_.type),Ye=M(_.internalFormat,Re,qe,_.colorSpace,_.isVideoTexture);le(J,_);let Ue,tt=_.mipmaps,X=_.isVideoTexture!==!0,Ee=Pe.__version===void 0||j===!0,Ae=ie.dataReady,Ge=P(_,ve);if(_.isDepthTexture)Ye=y(_.format===So,_.type),Ee&&(X?t.texStorage2D(i.TEXTURE_2D,1,Ye,ve.width,ve.height):t.texImage2D(i.TEXTURE_2D,0,Ye,ve.width,ve.height,0,Re,qe,null));else if(_.isDataTexture)if(tt.length>0){X&&Ee&&t.texStorage2D(i.TEXTURE_2D,Ge,Ye,tt[0].width,tt[0].height);for(let Se=0,me=tt.length;Se<me;Se++)Ue=tt[Se],X?Ae&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,Ue.width,Ue.height,Re,qe,Ue.data):t.texImage2D(i.TEXTURE_2D,Se,Ye,Ue.width,Ue.height,0,Re,qe,Ue.data);_.generateMipmaps=!1}else X?(Ee&&t.texStorage2D(i.TEXTURE_2D,Ge,Ye,ve.width,ve.height),Ae&&_e(_,ve,Re,qe)):t.texImage2D(i.TEXTURE_2D,0,Ye,ve.width,ve.height,0,Re,qe,ve.data);else if(_.isCompressedTexture)if(_.isCompressedArrayTexture){X&&Ee&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ge,Ye,tt[0].width,tt[0].height,ve.depth);for(let Se=0,me=tt.length;Se<me;Se++)if(Ue=tt[Se],_.format!==xi)if(Re!==null)if(X){if(Ae)if(_.layerUpdates.size>0){let $e=Ff(Ue.width,Ue.height,_.format,_.type);for(let st of _.layerUpdates){let Lt=Ue.data.subarray(st*$e/Ue.data.BYTES_PER_ELEMENT,(st+1)*$e/Ue.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,st,Ue.width,Ue.height,1,Re,Lt)}_.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,0,Ue.width,Ue.height,ve.depth,Re,Ue.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,Se,Ye,Ue.width,Ue.height,ve.depth,0,Ue.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else X?Ae&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,0,Ue.width,Ue.height,ve.depth,Re,qe,Ue.data):t.texImage3D(i.TEXTURE_2D_ARRAY,Se,Ye,Ue.width,Ue.height,ve.depth,0,Re,qe,Ue.data)}else{X&&Ee&&t.texStorage2D(i.TEXTURE_2D,Ge,Ye,tt[0].width,tt[0].height);for(let Se=0,me=tt.length;Se<me;Se++)Ue=tt[Se],_.format!==xi?Re!==null?X?Ae&&t.compressedTexSubImage2D(i.TEXTURE_2D,Se,0,0,Ue.width,Ue.height,Re,Ue.data):t.compressedTexImage2D(i.TEXTURE_2D,Se,Ye,Ue.width,Ue.height,0,Ue.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):X?Ae&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,Ue.width,Ue.height,Re,qe,Ue.data):t.texImage2D(i.TEXTURE_2D,Se,Ye,Ue.width,Ue.height,0,Re,qe,Ue.data)}else if(_.isDataArrayTexture)if(X){if(Ee&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ge,Ye,ve.width,ve.height,ve.depth),Ae)if(_.layerUpdates.size>0){let Se=Ff(ve.width,ve.height,_.format,_.type);for(let me of _.layerUpdates){let $e=ve.data.subarray(me*Se/ve.data.BYTES_PER_ELEMENT,(me+1)*Se/ve.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,me,ve.width,ve.height,1,Re,qe,$e)}_.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ve.width,ve.height,ve.depth,Re,qe,ve.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Ye,ve.width,ve.height,ve.depth,0,Re,qe,ve.data);else if(_.isData3DTexture)X?(Ee&&t.texStorage3D(i.TEXTURE_3D,Ge,Ye,ve.width,ve.height,ve.depth),Ae&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ve.width,ve.height,ve.depth,Re,qe,ve.data)):t.texImage3D(i.TEXTURE_3D,0,Ye,ve.width,ve.height,ve.depth,0,Re,qe,ve.data);else if(_.isFramebufferTexture){if(Ee)if(X)t.texStorage2D(i.TEXTURE_2D,Ge,Ye,ve.width,ve.height);else{let Se=ve.width,me=ve.height;for(let $e=0;$e<Ge;$e++)t.texImage2D(i.TEXTURE_2D,$e,Ye,Se,me,0,Re,qe,null),Se>>=1,me>>=1}}else if(tt.length>0){if(X&&Ee){let Se=ue(tt[0]);t.texStorage2D(i.TEXTURE_2D,Ge,Ye,Se.width,Se.height)}for(let Se=0,me=tt.length;Se<me;Se++)Ue=tt[Se],X?Ae&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,Re,qe,Ue):t.texImage2D(i.TEXTURE_2D,Se,Ye,Re,qe,Ue);_.generateMipmaps=!1}else if(X){if(Ee){let Se=ue(ve);t.texStorage2D(i.TEXTURE_2D,Ge,Ye,Se.width,Se.height)}Ae&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Re,qe,ve)}else t.texImage2D(i.TEXTURE_2D,0,Ye,Re,qe,ve);p(_)&&d(J),Pe.__version=ie.version,_.onUpdate&&_.onUpdate(_)}C.__version=_.version}function Y(C,_,F){if(_.image.length!==6)return;let J=fe(C,_),j=_.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+F);let ie=n.get(j);if(j.version!==ie.__version||J===!0){t.activeTexture(i.TEXTURE0+F);let Pe=xt.getPrimaries(xt.workingColorSpace),ge=_.colorSpace===ys?null:xt.getPrimaries(_.colorSpace),Oe=_.colorSpace===ys||Pe===ge?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Oe);let De=_.isCompressedTexture||_.image[0].isCompressedTexture,ve=_.image[0]&&_.image[0].isDataTexture,Re=[];for(let me=0;me<6;me++)!De&&!ve?Re[me]=v(_.image[me],!0,s.maxCubemapSize):Re[me]=ve?_.image[me].image:_.image[me],Re[me]=ce(_,Re[me]);let qe=Re[0],Ye=r.convert(_.format,_.colorSpace),Ue=r.convert(_.type),tt=M(_.internalFormat,Ye,Ue,_.colorSpace),X=_.isVideoTexture!==!0,Ee=ie.__version===void 0||J===!0,Ae=j.dataReady,Ge=P(_,qe);le(i.TEXTURE_CUBE_MAP,_);let Se;if(De){X&&Ee&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,tt,qe.width,qe.height);for(let me=0;me<6;me++){Se=Re[me].mipmaps;for(let $e=0;$e<Se.length;$e++){let st=Se[$e];_.format!==xi?Ye!==null?X?Ae&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,$e,0,0,st.width,st.height,Ye,st.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,$e,tt,st.width,st.height,0,st.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):X?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,$e,0,0,st.width,st.height,Ye,Ue,st.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,$e,tt,st.width,st.height,0,Ye,Ue,st.data)}}}else{if(Se=_.mipmaps,X&&Ee){Se.length>0&&Ge++;let me=ue(Re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,tt,me.width,me.height)}for(let me=0;me<6;me++)if(ve){X?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,0,0,0,Re[me].width,Re[me].height,Ye,Ue,Re[me].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,0,tt,Re[me].width,Re[me].height,0,Ye,Ue,Re[me].data);for(let $e=0;$e<Se.length;$e++){let Lt=Se[$e].image[me].image;X?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,$e+1,0,0,Lt.width,Lt.height,Ye,Ue,Lt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,$e+1,tt,Lt.width,Lt.height,0,Ye,Ue,Lt.data)}}else{X?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,0,0,0,Ye,Ue,Re[me]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,0,tt,Ye,Ue,Re[me]);for(let $e=0;$e<Se.length;$e++){let st=Se[$e];X?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,$e+1,0,0,Ye,Ue,st.image[me]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+me,$e+1,tt,Ye,Ue,st.image[me])}}}p(_)&&d(i.TEXTURE_CUBE_MAP),ie.__version=j.version,_.onUpdate&&_.onUpdate(_)}C.__version=_.version}function pe(C,_,F,J,j,ie){let Pe=r.convert(F.format,F.colorSpace),ge=r.convert(F.type),Oe=M(F.internalFormat,Pe,ge,F.colorSpace),De=n.get(_),ve=n.get(F);if(ve.__renderTarget=_,!De.__hasExternalTextures){let Re=Math.max(1,_.width>>ie),qe=Math.max(1,_.height>>ie);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?t.texImage3D(j,ie,Oe,Re,qe,_.depth,0,Pe,ge,null):t.texImage2D(j,ie,Oe,Re,qe,0,Pe,ge,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),ae(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,J,j,ve.__webglTexture,0,ot(_)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,J,j,ve.__webglTexture,ie),t.bindFramebuffer(i.FRAMEBUFFER,null)}function xe(C,_,F){if(i.bindRenderbuffer(i.RENDERBUFFER,C),_.depthBuffer){let J=_.depthTexture,j=J&&J.isDepthTexture?J.type:null,ie=y(_.stencilBuffer,j),Pe=_.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ge=ot(_);ae(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ge,ie,_.width,_.height):F?i.renderbufferStorageMultisample(i.RENDERBUFFER,ge,ie,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,ie,_.width,_.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Pe,i.RENDERBUFFER,C)}else{let J=_.textures;for(let j=0;j<J.length;j++){let ie=J[j],Pe=r.convert(ie.format,ie.colorSpace),ge=r.convert(ie.type),Oe=M(ie.internalFormat,Pe,ge,ie.colorSpace),De=ot(_);F&&ae(_)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,De,Oe,_.width,_.height):ae(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,De,Oe,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,Oe,_.width,_.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function we(C,_){if(_&&_.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(_.depthTexture&&_.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let J=n.get(_.depthTexture);J.__renderTarget=_,(!J.__webglTexture||_.depthTexture.image.width!==_.width||_.depthTexture.image.height!==_.height)&&(_.depthTexture.image.width=_.width,_.depthTexture.image.height=_.height,_.depthTexture.needsUpdate=!0),W(_.depthTexture,0);let j=J.__webglTexture,ie=ot(_);if(_.depthTexture.format===co)ae(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0);else if(_.depthTexture.format===So)ae(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0);else throw new Error("Unknown depthTexture format")}function Ve(C){let _=n.get(C),F=C.isWebGLCubeRenderTarget===!0;if(_.__boundDepthTexture!==C.depthTexture){let J=C.depthTexture;if(_.__depthDisposeCallback&&_.__depthDisposeCallback(),J){let j=()=>{delete _.__boundDepthTexture,delete _.__depthDisposeCallback,J.removeEventListener("dispose",j)};J.addEventListener("dispose",j),_.__depthDisposeCallback=j}_.__boundDepthTexture=J}if(C.depthTexture&&!_.__autoAllocateDepthBuffer){if(F)throw new Error("target.depthTexture not supported in Cube render targets");let J=C.texture.mipmaps;J&&J.length>0?we(_.__webglFramebuffer[0],C):we(_.__webglFramebuffer,C)}else if(F){_.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[J]),_.__webglDepthbuffer[J]===void 0)_.__webglDepthbuffer[J]=i.createRenderbuffer(),xe(_.__webglDepthbuffer[J],C,!1);else{let j=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ie=_.__webglDepthbuffer[J];i.bindRenderbuffer(i.RENDERBUFFER,ie),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,ie)}}else{let J=C.texture.mipmaps;if(J&&J.length>0?t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer),_.__webglDepthbuffer===void 0)_.__webglDepthbuffer=i.createRenderbuffer(),xe(_.__webglDepthbuffer,C,!1);else{let j=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ie=_.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ie),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,ie)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function dt(C,_,F){let J=n.get(C);_!==void 0&&pe(J.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),F!==void 0&&Ve(C)}function H(C){let _=C.texture,F=n.get(C),J=n.get(_);C.addEventListener("dispose",I);let j=C.textures,ie=C.isWebGLCubeRenderTarget===!0,Pe=j.length>1;if(Pe||(J.__webglTexture===void 0&&(J.__webglTexture=i.createTexture()),J.__version=_.version,o.memory.textures++),ie){F.__webglFramebuffer=[];for(let ge=0;ge<6;ge++)if(_.mipmaps&&_.mipmaps.length>0){F.__webglFramebuffer[ge]=[];for(let Oe=0;Oe<_.mipmaps.length;Oe++)F.__webglFramebuffer[ge][Oe]=i.createFramebuffer()}else F.__webglFramebuffer[ge]=i.createFramebuffer()}else{if(_.mipmaps&&_.mipmaps.length>0){F.__webglFramebuffer=[];for(let ge=0;ge<_.mipmaps.length;ge++)F.__webglFramebuffer[ge]=i.createFramebuffer()}else F.__webglFramebuffer=i.createFramebuffer();if(Pe)for(let ge=0,Oe=j.length;ge<Oe;ge++){let De=n.get(j[ge]);De.__webglTexture===void 0&&(De.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&ae(C)===!1){F.__webglMultisampledFramebuffer=i.createFramebuffer(),F.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,F.__webglMultisampledFramebuffer);for(let ge=0;ge<j.length;ge++){let Oe=j[ge];F.__webglColorRenderbuffer[ge]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,F.__webglColorRenderbuffer[ge]);let De=r.convert(Oe.format,Oe.colorSpace),ve=r.convert(Oe.type),Re=M(Oe.internalFormat,De,ve,Oe.colorSpace,C.isXRRenderTarget===!0),qe=ot(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,qe,Re,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ge,i.RENDERBUFFER,F.__webglColorRenderbuffer[ge])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(F.__webglDepthRenderbuffer=i.createRenderbuffer(),xe(F.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ie){t.bindTexture(i.TEXTURE_CUBE_MAP,J.__webglTexture),le(i.TEXTURE_CUBE_MAP,_);for(let ge=0;ge<6;ge++)if(_.mipmaps&&_.mipmaps.length>0)for(let Oe=0;Oe<_.mipmaps.length;Oe++)pe(F.__webglFramebuffer[ge][Oe],C,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Oe);else pe(F.__webglFramebuffer[ge],C,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0);p(_)&&d(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Pe){for(let ge=0,Oe=j.length;ge<Oe;ge++){let De=j[ge],ve=n.get(De),Re=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Re=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Re,ve.__webglTexture),le(Re,De),pe(F.__webglFramebuffer,C,De,i.COLOR_ATTACHMENT0+ge,Re,0),p(De)&&d(Re)}t.unbindTexture()}else{let ge=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ge=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ge,J.__webglTexture),le(ge,_),_.mipmaps&&_.mipmaps.length>0)for(let Oe=0;Oe<_.mipmaps.length;Oe++)pe(F.__webglFramebuffer[Oe],C,_,i.COLOR_ATTACHMENT0,ge,Oe);else pe(F.__webglFramebuffer,C,_,i.COLOR_ATTACHMENT0,ge,0);p(_)&&d(ge),t.unbindTexture()}C.depthBuffer&&Ve(C)}function ht(C){let _=C.textures;for(let F=0,J=_.length;F<J;F++){let j=_[F];if(p(j)){let ie=b(C),Pe=n.get(j).__webglTexture;t.bindTexture(ie,Pe),d(ie),t.unbindTexture()}}}let oe=[],be=[];function Ce(C){if(C.samples>0){if(ae(C)===!1){let _=C.textures,F=C.width,J=C.height,j=i.COLOR_BUFFER_BIT,ie=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Pe=n.get(C),ge=_.length>1;if(ge)for(let De=0;De<_.length;De++)t.bindFramebuffer(i.FRAMEBUFFER,Pe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+De,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Pe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+De,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Pe.__webglMultisampledFramebuffer);let Oe=C.texture.mipmaps;Oe&&Oe.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Pe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Pe.__webglFramebuffer);for(let De=0;De<_.length;De++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),ge){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Pe.__webglColorRenderbuffer[De]);let ve=n.get(_[De]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,ve,0)}i.blitFramebuffer(0,0,F,J,0,0,F,J,j,i.NEAREST),l===!0&&(oe.length=0,be.length=0,oe.push(i.COLOR_ATTACHMENT0+De),C.depthBuffer&&C.resolveDepthBuffer===!1&&(oe.push(ie),be.push(ie),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,be)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,oe))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ge)for(let De=0;De<_.length;De++){t.bindFramebuffer(i.FRAMEBUFFER,Pe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+De,i.RENDERBUFFER,Pe.__webglColorRenderbuffer[De]);let ve=n.get(_[De]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Pe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+De,i.TEXTURE_2D,ve,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Pe.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.resolveDepthBuffer===!1&&l){let _=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[_])}}}function ot(C){return Math.min(s.maxSamples,C.samples)}function ae(C){let _=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&_.__useRenderToTexture!==!1}function Le(C){let _=o.render.frame;u.get(C)!==_&&(u.set(C,_),C.update())}function ce(C,_){let F=C.colorSpace,J=C.format,j=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||F!==cr&&F!==ys&&(xt.getTransfer(F)===Pt?(J!==xi||j!==Fi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",F)),_}function ue(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=B,this.resetTextureUnits=k,this.setTexture2D=W,this.setTexture2DArray=q,this.setTexture3D=N,this.setTextureCube=z,this.rebindTextures=dt,this.setupRenderTarget=H,this.updateRenderTargetMipmap=ht,this.updateMultisampleRenderTarget=Ce,this.setupDepthRenderbuffer=Ve,this.setupFrameBufferTexture=pe,this.useMultisampledRTT=ae}function US(i,e){function t(n,s=ys){let r,o=xt.getTransfer(s);if(n===Fi)return i.UNSIGNED_BYTE;if(n===Gc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Wc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===bf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Mf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===_f)return i.BYTE;if(n===yf)return i.SHORT;if(n===bo)return i.UNSIGNED_SHORT;if(n===Vc)return i.INT;if(n===Ws)return i.UNSIGNED_INT;if(n===es)return i.FLOAT;if(n===Mo)return i.HALF_FLOAT;if(n===wf)return i.ALPHA;if(n===Sf)return i.RGB;if(n===xi)return i.RGBA;if(n===co)return i.DEPTH_COMPONENT;if(n===So)return i.DEPTH_STENCIL;if(n===Ef)return i.RED;if(n===Xc)return i.RED_INTEGER;if(n===Tf)return i.RG;if(n===qc)return i.RG_INTEGER;if(n===Yc)return i.RGBA_INTEGER;if(n===Ga||n===Wa||n===Xa||n===qa)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ga)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ga)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===$c||n===Zc||n===Kc||n===Jc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===$c)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Zc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Kc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Jc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===jc||n===Qc||n===eh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===jc||n===Qc)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===eh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===th||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===fh||n===dh||n===ph)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===th)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===nh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===ih)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===sh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===rh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===ah)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===lh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ch)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===dh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ph)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===mh||n===gh||n===vh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===mh)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===gh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===vh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===xh||n===_h||n===yh||n===bh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===xh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===_h)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===yh)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===bh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===wo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var NS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,FS=`
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

}`,Zf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Sa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ai({vertexShader:NS,fragmentShader:FS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Je(new Ra(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Kf=class extends Zi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,m=null,g=null,v=typeof XRWebGLBinding<"u",p=new Zf,d={},b=t.getContextAttributes(),M=null,y=null,P=[],E=[],I=new Be,D=null,w=new Dn;w.viewport=new It;let S=new Dn;S.viewport=new It;let A=[w,S],k=new Ic,B=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let Y=P[ee];return Y===void 0&&(Y=new po,P[ee]=Y),Y.getTargetRaySpace()},this.getControllerGrip=function(ee){let Y=P[ee];return Y===void 0&&(Y=new po,P[ee]=Y),Y.getGripSpace()},this.getHand=function(ee){let Y=P[ee];return Y===void 0&&(Y=new po,P[ee]=Y),Y.getHandSpace()};function W(ee){let Y=E.indexOf(ee.inputSource);if(Y===-1)return;let pe=P[Y];pe!==void 0&&(pe.update(ee.inputSource,ee.frame,c||o),pe.dispatchEvent({type:ee.type,data:ee.inputSource}))}function q(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",N);for(let ee=0;ee<P.length;ee++){let Y=E[ee];Y!==null&&(E[ee]=null,P[ee].disconnect(Y))}B=null,V=null,p.reset();for(let ee in d)delete d[ee];e.setRenderTarget(M),m=null,f=null,h=null,s=null,y=null,_e.stop(),n.isPresenting=!1,e.setPixelRatio(D),e.setSize(I.width,I.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:m},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",q),s.addEventListener("inputsourceschange",N),b.xrCompatible!==!0&&await t.makeXRCompatible(),D=e.getPixelRatio(),e.getSize(I),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let pe=null,xe=null,we=null;b.depth&&(we=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,pe=b.stencil?So:co,xe=b.stencil?wo:Ws);let Ve={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Ve),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),y=new Ki(f.textureWidth,f.textureHeight,{format:xi,type:Fi,depthTexture:new wa(f.textureWidth,f.textureHeight,xe,void 0,void 0,void 0,void 0,void 0,void 0,pe),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let pe={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,pe),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),y=new Ki(m.framebufferWidth,m.framebufferHeight,{format:xi,type:Fi,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),_e.setContext(s),_e.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function N(ee){for(let Y=0;Y<ee.removed.length;Y++){let pe=ee.removed[Y],xe=E.indexOf(pe);xe>=0&&(E[xe]=null,P[xe].disconnect(pe))}for(let Y=0;Y<ee.added.length;Y++){let pe=ee.added[Y],xe=E.indexOf(pe);if(xe===-1){for(let Ve=0;Ve<P.length;Ve++)if(Ve>=E.length){E.push(pe),xe=Ve;break}else if(E[Ve]===null){E[Ve]=pe,xe=Ve;break}if(xe===-1)break}let we=P[xe];we&&we.connect(pe)}}let z=new L,K=new L;function ne(ee,Y,pe){z.setFromMatrixPosition(Y.matrixWorld),K.setFromMatrixPosition(pe.matrixWorld);let xe=z.distanceTo(K),we=Y.projectionMatrix.elements,Ve=pe.projectionMatrix.elements,dt=we[14]/(we[10]-1),H=we[14]/(we[10]+1),ht=(we[9]+1)/we[5],oe=(we[9]-1)/we[5],be=(we[8]-1)/we[0],Ce=(Ve[8]+1)/Ve[0],ot=dt*be,ae=dt*Ce,Le=xe/(-be+Ce),ce=Le*-be;if(Y.matrixWorld.decompose(ee.position,ee.quaternion,ee.scale),ee.translateX(ce),ee.translateZ(Le),ee.matrixWorld.compose(ee.position,ee.quaternion,ee.scale),ee.matrixWorldInverse.copy(ee.matrixWorld).invert(),we[10]===-1)ee.projectionMatrix.copy(Y.projectionMatrix),ee.projectionMatrixInverse.copy(Y.projectionMatrixInverse);else{let ue=dt+Le,C=H+Le,_=ot-ce,F=ae+(xe-ce),J=ht*H/C*ue,j=oe*H/C*ue;ee.projectionMatrix.makePerspective(_,F,J,j,ue,C),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert()}}function te(ee,Y){Y===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(Y.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let Y=ee.near,pe=ee.far;p.texture!==null&&(p.depthNear>0&&(Y=p.depthNear),p.depthFar>0&&(pe=p.depthFar)),k.near=S.near=w.near=Y,k.far=S.far=w.far=pe,(B!==k.near||V!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),B=k.near,V=k.far),k.layers.mask=ee.layers.mask|6,w.layers.mask=k.layers.mask&3,S.layers.mask=k.layers.mask&5;let xe=ee.parent,we=k.cameras;te(k,xe);for(let Ve=0;Ve<we.length;Ve++)te(we[Ve],xe);we.length===2?ne(k,w,S):k.projectionMatrix.copy(w.projectionMatrix),le(ee,k,xe)};function le(ee,Y,pe){pe===null?ee.matrix.copy(Y.matrixWorld):(ee.matrix.copy(pe.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(Y.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(Y.projectionMatrix),ee.projectionMatrixInverse.copy(Y.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=ho*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(f===null&&m===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(k)},this.getCameraTexture=function(ee){return d[ee]};let fe=null;function ye(ee,Y){if(u=Y.getViewerPose(c||o),g=Y,u!==null){let pe=u.views;m!==null&&(e.setRenderTargetFramebuffer(y,m.framebuffer),e.setRenderTarget(y));let xe=!1;pe.length!==k.cameras.length&&(k.cameras.length=0,xe=!0);for(let H=0;H<pe.length;H++){let ht=pe[H],oe=null;if(m!==null)oe=m.getViewport(ht);else{let Ce=h.getViewSubImage(f,ht);oe=Ce.viewport,H===0&&(e.setRenderTargetTextures(y,Ce.colorTexture,Ce.depthStencilTexture),e.setRenderTarget(y))}let be=A[H];be===void 0&&(be=new Dn,be.layers.enable(H),be.viewport=new It,A[H]=be),be.matrix.fromArray(ht.transform.matrix),be.matrix.decompose(be.position,be.quaternion,be.scale),be.projectionMatrix.fromArray(ht.projectionMatrix),be.projectionMatrixInverse.copy(be.projectionMatrix).invert(),be.viewport.set(oe.x,oe.y,oe.width,oe.height),H===0&&(k.matrix.copy(be.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),xe===!0&&k.cameras.push(be)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=n.getBinding();let H=h.getDepthInformation(pe[0]);H&&H.isValid&&H.texture&&p.init(H,s.renderState)}if(we&&we.includes("camera-access")&&v){e.state.unbindTexture(),h=n.getBinding();for(let H=0;H<pe.length;H++){let ht=pe[H].camera;if(ht){let oe=d[ht];oe||(oe=new Sa,d[ht]=oe);let be=h.getCameraImage(ht);oe.sourceTexture=be}}}}for(let pe=0;pe<P.length;pe++){let xe=E[pe],we=P[pe];xe!==null&&we!==void 0&&we.update(xe,Y,c||o)}fe&&fe(ee,Y),Y.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Y}),g=null}let _e=new Sg;_e.setAnimationLoop(ye),this.setAnimationLoop=function(ee){fe=ee},this.dispose=function(){}}},yr=new Ui,OS=new Ut;function BS(i,e){function t(p,d){p.matrixAutoUpdate===!0&&p.updateMatrix(),d.value.copy(p.matrix)}function n(p,d){d.color.getRGB(p.fogColor.value,Lf(i)),d.isFog?(p.fogNear.value=d.near,p.fogFar.value=d.far):d.isFogExp2&&(p.fogDensity.value=d.density)}function s(p,d,b,M,y){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(p,d):d.isMeshToonMaterial?(r(p,d),h(p,d)):d.isMeshPhongMaterial?(r(p,d),u(p,d)):d.isMeshStandardMaterial?(r(p,d),f(p,d),d.isMeshPhysicalMaterial&&m(p,d,y)):d.isMeshMatcapMaterial?(r(p,d),g(p,d)):d.isMeshDepthMaterial?r(p,d):d.isMeshDistanceMaterial?(r(p,d),v(p,d)):d.isMeshNormalMaterial?r(p,d):d.isLineBasicMaterial?(o(p,d),d.isLineDashedMaterial&&a(p,d)):d.isPointsMaterial?l(p,d,b,M):d.isSpriteMaterial?c(p,d):d.isShadowMaterial?(p.color.value.copy(d.color),p.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(p,d){p.opacity.value=d.opacity,d.color&&p.diffuse.value.copy(d.color),d.emissive&&p.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(p.map.value=d.map,t(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.bumpMap&&(p.bumpMap.value=d.bumpMap,t(d.bumpMap,p.bumpMapTransform),p.bumpScale.value=d.bumpScale,d.side===Wn&&(p.bumpScale.value*=-1)),d.normalMap&&(p.normalMap.value=d.normalMap,t(d.normalMap,p.normalMapTransform),p.normalScale.value.copy(d.normalScale),d.side===Wn&&p.normalScale.value.negate()),d.displacementMap&&(p.displacementMap.value=d.displacementMap,t(d.displacementMap,p.displacementMapTransform),p.displacementScale.value=d.displacementScale,p.displacementBias.value=d.displacementBias),d.emissiveMap&&(p.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,p.emissiveMapTransform)),d.specularMap&&(p.specularMap.value=d.specularMap,t(d.specularMap,p.specularMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest);let b=e.get(d),M=b.envMap,y=b.envMapRotation;M&&(p.envMap.value=M,yr.copy(y),yr.x*=-1,yr.y*=-1,yr.z*=-1,M.isCubeTexture&&M.isRenderTargetTexture===!1&&(yr.y*=-1,yr.z*=-1),p.envMapRotation.value.setFromMatrix4(OS.makeRotationFromEuler(yr)),p.flipEnvMap.value=M.isCubeTexture&&M.isRenderTargetTexture===!1?-1:1,p.reflectivity.value=d.reflectivity,p.ior.value=d.ior,p.refractionRatio.value=d.refractionRatio),d.lightMap&&(p.lightMap.value=d.lightMap,p.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,p.lightMapTransform)),d.aoMap&&(p.aoMap.value=d.aoMap,p.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,p.aoMapTransform))}function o(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,d.map&&(p.map.value=d.map,t(d.map,p.mapTransform))}function a(p,d){p.dashSize.value=d.dashSize,p.totalSize.value=d.dashSize+d.gapSize,p.scale.value=d.scale}function l(p,d,b,M){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.size.value=d.size*b,p.scale.value=M*.5,d.map&&(p.map.value=d.map,t(d.map,p.uvTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function c(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.rotation.value=d.rotation,d.map&&(p.map.value=d.map,t(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function u(p,d){p.specular.value.copy(d.specular),p.shininess.value=Math.max(d.shininess,1e-4)}function h(p,d){d.gradientMap&&(p.gradientMap.value=d.gradientMap)}function f(p,d){p.metalness.value=d.metalness,d.metalnessMap&&(p.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,p.metalnessMapTransform)),p.roughness.value=d.roughness,d.roughnessMap&&(p.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,p.roughnessMapTransform)),d.envMap&&(p.envMapIntensity.value=d.envMapIntensity)}function m(p,d,b){p.ior.value=d.ior,d.sheen>0&&(p.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),p.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(p.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,p.sheenColorMapTransform)),d.sheenRoughnessMap&&(p.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,p.sheenRoughnessMapTransform))),d.clearcoat>0&&(p.clearcoat.value=d.clearcoat,p.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(p.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,p.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(p.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Wn&&p.clearcoatNormalScale.value.negate())),d.dispersion>0&&(p.dispersion.value=d.dispersion),d.iridescence>0&&(p.iridescence.value=d.iridescence,p.iridescenceIOR.value=d.iridescenceIOR,p.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(p.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,p.iridescenceMapTransform)),d.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),d.transmission>0&&(p.transmission.value=d.transmission,p.transmissionSamplerMap.value=b.texture,p.transmissionSamplerSize.value.set(b.width,b.height),d.transmissionMap&&(p.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,p.transmissionMapTransform)),p.thickness.value=d.thickness,d.thicknessMap&&(p.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=d.attenuationDistance,p.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(p.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(p.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=d.specularIntensity,p.specularColor.value.copy(d.specularColor),d.specularColorMap&&(p.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,p.specularColorMapTransform)),d.specularIntensityMap&&(p.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,d){d.matcap&&(p.matcap.value=d.matcap)}function v(p,d){let b=e.get(d).light;p.referencePosition.value.setFromMatrixPosition(b.matrixWorld),p.nearDistance.value=b.shadow.camera.near,p.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function zS(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,M){let y=M.program;n.uniformBlockBinding(b,y)}function c(b,M){let y=s[b.id];y===void 0&&(g(b),y=u(b),s[b.id]=y,b.addEventListener("dispose",p));let P=M.program;n.updateUBOMapping(b,P);let E=e.render.frame;r[b.id]!==E&&(f(b),r[b.id]=E)}function u(b){let M=h();b.__bindingPointIndex=M;let y=i.createBuffer(),P=b.__size,E=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,y),i.bufferData(i.UNIFORM_BUFFER,P,E),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,M,y),y}function h(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(b){let M=s[b.id],y=b.uniforms,P=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let E=0,I=y.length;E<I;E++){let D=Array.isArray(y[E])?y[E]:[y[E]];for(let w=0,S=D.length;w<S;w++){let A=D[w];if(m(A,E,w,P)===!0){let k=A.__offset,B=Array.isArray(A.value)?A.value:[A.value],V=0;for(let W=0;W<B.length;W++){let q=B[W],N=v(q);typeof q=="number"||typeof q=="boolean"?(A.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,k+V,A.__data)):q.isMatrix3?(A.__data[0]=q.elements[0],A.__data[1]=q.elements[1],A.__data[2]=q.elements[2],A.__data[3]=0,A.__data[4]=q.elements[3],A.__data[5]=q.elements[4],A.__data[6]=q.elements[5],A.__data[7]=0,A.__data[8]=q.elements[6],A.__data[9]=q.elements[7],A.__data[10]=q.elements[8],A.__data[11]=0):(q.toArray(A.__data,V),V+=N.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,k,A.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(b,M,y,P){let E=b.value,I=M+"_"+y;if(P[I]===void 0)return typeof E=="number"||typeof E=="boolean"?P[I]=E:P[I]=E.clone(),!0;{let D=P[I];if(typeof E=="number"||typeof E=="boolean"){if(D!==E)return P[I]=E,!0}else if(D.equals(E)===!1)return D.copy(E),!0}return!1}function g(b){let M=b.uniforms,y=0,P=16;for(let I=0,D=M.length;I<D;I++){let w=Array.isArray(M[I])?M[I]:[M[I]];for(let S=0,A=w.length;S<A;S++){let k=w[S],B=Array.isArray(k.value)?k.value:[k.value];for(let V=0,W=B.length;V<W;V++){let q=B[V],N=v(q),z=y%P,K=z%N.boundary,ne=z+K;y+=K,ne!==0&&P-ne<N.storage&&(y+=P-ne),k.__data=new Float32Array(N.storage/Float32Array.BYTES_PER_ELEMENT),k.__offset=y,y+=N.storage}}}let E=y%P;return E>0&&(y+=P-E),b.__size=y,b.__cache={},this}function v(b){let M={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(M.boundary=4,M.storage=4):b.isVector2?(M.boundary=8,M.storage=8):b.isVector3||b.isColor?(M.boundary=16,M.storage=12):b.isVector4?(M.boundary=16,M.storage=16):b.isMatrix3?(M.boundary=48,M.storage=48):b.isMatrix4?(M.boundary=64,M.storage=64):b.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",b),M}function p(b){let M=b.target;M.removeEventListener("dispose",p);let y=o.indexOf(M.__bindingPointIndex);o.splice(y,1),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function d(){for(let b in s)i.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var Rh=class{constructor(e={}){let{canvas:t=Km(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let g=new Uint32Array(4),v=new Int32Array(4),p=null,d=null,b=[],M=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=_s,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let y=this,P=!1;this._outputColorSpace=Gn;let E=0,I=0,D=null,w=-1,S=null,A=new It,k=new It,B=null,V=new at(0),W=0,q=t.width,N=t.height,z=1,K=null,ne=null,te=new It(0,0,q,N),le=new It(0,0,q,N),fe=!1,ye=new xo,_e=!1,ee=!1,Y=new Ut,pe=new L,xe=new It,we={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ve=!1;function dt(){return D===null?z:1}let H=n;function ht(R,Z){return t.getContext(R,Z)}try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"180"}`),t.addEventListener("webglcontextlost",Ae,!1),t.addEventListener("webglcontextrestored",Ge,!1),t.addEventListener("webglcontextcreationerror",Se,!1),H===null){let Z="webgl2";if(H=ht(Z,R),H===null)throw ht(Z)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(R){throw console.error("THREE.WebGLRenderer: "+R.message),R}let oe,be,Ce,ot,ae,Le,ce,ue,C,_,F,J,j,ie,Pe,ge,Oe,De,ve,Re,qe,Ye,Ue,tt;function X(){oe=new iw(H),oe.init(),Ye=new US(H,oe),be=new KM(H,oe,e,Ye),Ce=new LS(H,oe),be.reversedDepthBuffer&&f&&Ce.buffers.depth.setReversed(!0),ot=new ow(H),ae=new _S,Le=new DS(H,oe,Ce,ae,be,Ye,ot),ce=new jM(y),ue=new nw(y),C=new fy(H),Ue=new $M(H,C),_=new sw(H,C,ot,Ue),F=new lw(H,_,C,ot),ve=new aw(H,be,Le),ge=new JM(ae),J=new xS(y,ce,ue,oe,be,Ue,ge),j=new BS(y,ae),ie=new bS,Pe=new AS(oe),De=new YM(y,ce,ue,Ce,F,m,l),Oe=new PS(y,F,be),tt=new zS(H,ot,be,Ce),Re=new ZM(H,oe,ot),qe=new rw(H,oe,ot),ot.programs=J.programs,y.capabilities=be,y.extensions=oe,y.properties=ae,y.renderLists=ie,y.shadowMap=Oe,y.state=Ce,y.info=ot}X();let Ee=new Kf(y,H);this.xr=Ee,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let R=oe.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=oe.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return z},this.setPixelRatio=function(R){R!==void 0&&(z=R,this.setSize(q,N,!1))},this.getSize=function(R){return R.set(q,N)},this.setSize=function(R,Z,he=!0){if(Ee.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=R,N=Z,t.width=Math.floor(R*z),t.height=Math.floor(Z*z),he===!0&&(t.style.width=R+"px",t.style.height=Z+"px"),this.setViewport(0,0,R,Z)},this.getDrawingBufferSize=function(R){return R.set(q*z,N*z).floor()},this.setDrawingBufferSize=function(R,Z,he){q=R,N=Z,z=he,t.width=Math.floor(R*he),t.height=Math.floor(Z*he),this.setViewport(0,0,R,Z)},this.getCurrentViewport=function(R){return R.copy(A)},this.getViewport=function(R){return R.copy(te)},this.setViewport=function(R,Z,he,re){R.isVector4?te.set(R.x,R.y,R.z,R.w):te.set(R,Z,he,re),Ce.viewport(A.copy(te).multiplyScalar(z).round())},this.getScissor=function(R){return R.copy(le)},this.setScissor=function(R,Z,he,re){R.isVector4?le.set(R.x,R.y,R.z,R.w):le.set(R,Z,he,re),Ce.scissor(k.copy(le).multiplyScalar(z).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(R){Ce.setScissorTest(fe=R)},this.setOpaqueSort=function(R){K=R},this.setTransparentSort=function(R){ne=R},this.getClearColor=function(R){return R.copy(De.getClearColor())},this.setClearColor=function(){De.setClearColor(...arguments)},this.getClearAlpha=function(){return De.getClearAlpha()},this.setClearAlpha=function(){De.setClearAlpha(...arguments)},this.clear=function(R=!0,Z=!0,he=!0){let re=0;if(R){let Q=!1;if(D!==null){let Te=D.texture.format;Q=Te===Yc||Te===qc||Te===Xc}if(Q){let Te=D.texture.type,Fe=Te===Fi||Te===Ws||Te===bo||Te===wo||Te===Gc||Te===Wc,We=De.getClearColor(),ze=De.getClearAlpha(),Qe=We.r,et=We.g,Ze=We.b;Fe?(g[0]=Qe,g[1]=et,g[2]=Ze,g[3]=ze,H.clearBufferuiv(H.COLOR,0,g)):(v[0]=Qe,v[1]=et,v[2]=Ze,v[3]=ze,H.clearBufferiv(H.COLOR,0,v))}else re|=H.COLOR_BUFFER_BIT}Z&&(re|=H.DEPTH_BUFFER_BIT),he&&(re|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H.clear(re)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",Ae,!1),t.removeEventListener("webglcontextrestored",Ge,!1),t.removeEventListener("webglcontextcreationerror",Se,!1),De.dispose(),ie.dispose(),Pe.dispose(),ae.dispose(),ce.dispose(),ue.dispose(),F.dispose(),Ue.dispose(),tt.dispose(),J.dispose(),Ee.dispose(),Ee.removeEventListener("sessionstart",Ft),Ee.removeEventListener("sessionend",ei),Yn.stop()};function Ae(R){R.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),P=!0}function Ge(){console.log("THREE.WebGLRenderer: Context Restored."),P=!1;let R=ot.autoReset,Z=Oe.enabled,he=Oe.autoUpdate,re=Oe.needsUpdate,Q=Oe.type;X(),ot.autoReset=R,Oe.enabled=Z,Oe.autoUpdate=he,Oe.needsUpdate=re,Oe.type=Q}function Se(R){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function me(R){let Z=R.target;Z.removeEventListener("dispose",me),$e(Z)}function $e(R){st(R),ae.remove(R)}function st(R){let Z=ae.get(R).programs;Z!==void 0&&(Z.forEach(function(he){J.releaseProgram(he)}),R.isShaderMaterial&&J.releaseShaderCache(R))}this.renderBufferDirect=function(R,Z,he,re,Q,Te){Z===null&&(Z=we);let Fe=Q.isMesh&&Q.matrixWorld.determinant()<0,We=os(R,Z,he,re,Q);Ce.setMaterial(re,Fe);let ze=he.index,Qe=1;if(re.wireframe===!0){if(ze=_.getWireframeAttribute(he),ze===void 0)return;Qe=2}let et=he.drawRange,Ze=he.attributes.position,ut=et.start*Qe,bt=(et.start+et.count)*Qe;Te!==null&&(ut=Math.max(ut,Te.start*Qe),bt=Math.min(bt,(Te.start+Te.count)*Qe)),ze!==null?(ut=Math.max(ut,0),bt=Math.min(bt,ze.count)):Ze!=null&&(ut=Math.max(ut,0),bt=Math.min(bt,Ze.count));let kt=bt-ut;if(kt<0||kt===1/0)return;Ue.setup(Q,re,We,he,ze);let Rt,lt=Re;if(ze!==null&&(Rt=C.get(ze),lt=qe,lt.setIndex(Rt)),Q.isMesh)re.wireframe===!0?(Ce.setLineWidth(re.wireframeLinewidth*dt()),lt.setMode(H.LINES)):lt.setMode(H.TRIANGLES);else if(Q.isLine){let je=re.linewidth;je===void 0&&(je=1),Ce.setLineWidth(je*dt()),Q.isLineSegments?lt.setMode(H.LINES):Q.isLineLoop?lt.setMode(H.LINE_LOOP):lt.setMode(H.LINE_STRIP)}else Q.isPoints?lt.setMode(H.POINTS):Q.isSprite&&lt.setMode(H.TRIANGLES);if(Q.isBatchedMesh)if(Q._multiDrawInstances!==null)uo("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),lt.renderMultiDrawInstances(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount,Q._multiDrawInstances);else if(oe.get("WEBGL_multi_draw"))lt.renderMultiDraw(Q._multiDrawStarts,Q._multiDrawCounts,Q._multiDrawCount);else{let je=Q._multiDrawStarts,Ht=Q._multiDrawCounts,gt=Q._multiDrawCount,Rn=ze?C.get(ze).bytesPerElement:1,ws=ae.get(re).currentProgram.getUniforms();for(let On=0;On<gt;On++)ws.setValue(H,"_gl_DrawID",On),lt.render(je[On]/Rn,Ht[On])}else if(Q.isInstancedMesh)lt.renderInstances(ut,kt,Q.count);else if(he.isInstancedBufferGeometry){let je=he._maxInstanceCount!==void 0?he._maxInstanceCount:1/0,Ht=Math.min(he.instanceCount,je);lt.renderInstances(ut,kt,Ht)}else lt.render(ut,kt)};function Lt(R,Z,he){R.transparent===!0&&R.side===Sn&&R.forceSinglePass===!1?(R.side=Wn,R.needsUpdate=!0,Zs(R,Z,he),R.side=gs,R.needsUpdate=!0,Zs(R,Z,he),R.side=Sn):Zs(R,Z,he)}this.compile=function(R,Z,he=null){he===null&&(he=R),d=Pe.get(he),d.init(Z),M.push(d),he.traverseVisible(function(Q){Q.isLight&&Q.layers.test(Z.layers)&&(d.pushLight(Q),Q.castShadow&&d.pushShadow(Q))}),R!==he&&R.traverseVisible(function(Q){Q.isLight&&Q.layers.test(Z.layers)&&(d.pushLight(Q),Q.castShadow&&d.pushShadow(Q))}),d.setupLights();let re=new Set;return R.traverse(function(Q){if(!(Q.isMesh||Q.isPoints||Q.isLine||Q.isSprite))return;let Te=Q.material;if(Te)if(Array.isArray(Te))for(let Fe=0;Fe<Te.length;Fe++){let We=Te[Fe];Lt(We,he,Q),re.add(We)}else Lt(Te,he,Q),re.add(Te)}),d=M.pop(),re},this.compileAsync=function(R,Z,he=null){let re=this.compile(R,Z,he);return new Promise(Q=>{function Te(){if(re.forEach(function(Fe){ae.get(Fe).currentProgram.isReady()&&re.delete(Fe)}),re.size===0){Q(R);return}setTimeout(Te,10)}oe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let yt=null;function bn(R){yt&&yt(R)}function Ft(){Yn.stop()}function ei(){Yn.start()}let Yn=new Sg;Yn.setAnimationLoop(bn),typeof self<"u"&&Yn.setContext(self),this.setAnimationLoop=function(R){yt=R,Ee.setAnimationLoop(R),R===null?Yn.stop():Yn.start()},Ee.addEventListener("sessionstart",Ft),Ee.addEventListener("sessionend",ei),this.render=function(R,Z){if(Z!==void 0&&Z.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),Z.parent===null&&Z.matrixWorldAutoUpdate===!0&&Z.updateMatrixWorld(),Ee.enabled===!0&&Ee.isPresenting===!0&&(Ee.cameraAutoUpdate===!0&&Ee.updateCamera(Z),Z=Ee.getCamera()),R.isScene===!0&&R.onBeforeRender(y,R,Z,D),d=Pe.get(R,M.length),d.init(Z),M.push(d),Y.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),ye.setFromProjectionMatrix(Y,Ii,Z.reversedDepth),ee=this.localClippingEnabled,_e=ge.init(this.clippingPlanes,ee),p=ie.get(R,b.length),p.init(),b.push(p),Ee.enabled===!0&&Ee.isPresenting===!0){let Te=y.xr.getDepthSensingMesh();Te!==null&&Hi(Te,Z,-1/0,y.sortObjects)}Hi(R,Z,0,y.sortObjects),p.finish(),y.sortObjects===!0&&p.sort(K,ne),Ve=Ee.enabled===!1||Ee.isPresenting===!1||Ee.hasDepthSensing()===!1,Ve&&De.addToRenderList(p,R),this.info.render.frame++,_e===!0&&ge.beginShadows();let he=d.state.shadowsArray;Oe.render(he,R,Z),_e===!0&&ge.endShadows(),this.info.autoReset===!0&&this.info.reset();let re=p.opaque,Q=p.transmissive;if(d.setupLights(),Z.isArrayCamera){let Te=Z.cameras;if(Q.length>0)for(let Fe=0,We=Te.length;Fe<We;Fe++){let ze=Te[Fe];rs(re,Q,R,ze)}Ve&&De.render(R);for(let Fe=0,We=Te.length;Fe<We;Fe++){let ze=Te[Fe];Fn(p,R,ze,ze.viewport)}}else Q.length>0&&rs(re,Q,R,Z),Ve&&De.render(R),Fn(p,R,Z);D!==null&&I===0&&(Le.updateMultisampleRenderTarget(D),Le.updateRenderTargetMipmap(D)),R.isScene===!0&&R.onAfterRender(y,R,Z),Ue.resetDefaultState(),w=-1,S=null,M.pop(),M.length>0?(d=M[M.length-1],_e===!0&&ge.setGlobalState(y.clippingPlanes,d.state.camera)):d=null,b.pop(),b.length>0?p=b[b.length-1]:p=null};function Hi(R,Z,he,re){if(R.visible===!1)return;if(R.layers.test(Z.layers)){if(R.isGroup)he=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(Z);else if(R.isLight)d.pushLight(R),R.castShadow&&d.pushShadow(R);else if(R.isSprite){if(!R.frustumCulled||ye.intersectsSprite(R)){re&&xe.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Y);let Fe=F.update(R),We=R.material;We.visible&&p.push(R,Fe,We,he,xe.z,null)}}else if((R.isMesh||R.isLine||R.isPoints)&&(!R.frustumCulled||ye.intersectsObject(R))){let Fe=F.update(R),We=R.material;if(re&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),xe.copy(R.boundingSphere.center)):(Fe.boundingSphere===null&&Fe.computeBoundingSphere(),xe.copy(Fe.boundingSphere.center)),xe.applyMatrix4(R.matrixWorld).applyMatrix4(Y)),Array.isArray(We)){let ze=Fe.groups;for(let Qe=0,et=ze.length;Qe<et;Qe++){let Ze=ze[Qe],ut=We[Ze.materialIndex];ut&&ut.visible&&p.push(R,Fe,ut,he,xe.z,Ze)}}else We.visible&&p.push(R,Fe,We,he,xe.z,null)}}let Te=R.children;for(let Fe=0,We=Te.length;Fe<We;Fe++)Hi(Te[Fe],Z,he,re)}function Fn(R,Z,he,re){let Q=R.opaque,Te=R.transmissive,Fe=R.transparent;d.setupLightsView(he),_e===!0&&ge.setGlobalState(y.clippingPlanes,he),re&&Ce.viewport(A.copy(re)),Q.length>0&&bi(Q,Z,he),Te.length>0&&bi(Te,Z,he),Fe.length>0&&bi(Fe,Z,he),Ce.buffers.depth.setTest(!0),Ce.buffers.depth.setMask(!0),Ce.buffers.color.setMask(!0),Ce.setPolygonOffset(!1)}function rs(R,Z,he,re){if((he.isScene===!0?he.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[re.id]===void 0&&(d.state.transmissionRenderTarget[re.id]=new Ki(1,1,{generateMipmaps:!0,type:oe.has("EXT_color_buffer_half_float")||oe.has("EXT_color_buffer_float")?Mo:Fi,minFilter:Gs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:xt.workingColorSpace}));let Te=d.state.transmissionRenderTarget[re.id],Fe=re.viewport||A;Te.setSize(Fe.z*y.transmissionResolutionScale,Fe.w*y.transmissionResolutionScale);let We=y.getRenderTarget(),ze=y.getActiveCubeFace(),Qe=y.getActiveMipmapLevel();y.setRenderTarget(Te),y.getClearColor(V),W=y.getClearAlpha(),W<1&&y.setClearColor(16777215,.5),y.clear(),Ve&&De.render(he);let et=y.toneMapping;y.toneMapping=_s;let Ze=re.viewport;if(re.viewport!==void 0&&(re.viewport=void 0),d.setupLightsView(re),_e===!0&&ge.setGlobalState(y.clippingPlanes,re),bi(R,he,re),Le.updateMultisampleRenderTarget(Te),Le.updateRenderTargetMipmap(Te),oe.has("WEBGL_multisampled_render_to_texture")===!1){let ut=!1;for(let bt=0,kt=Z.length;bt<kt;bt++){let Rt=Z[bt],lt=Rt.object,je=Rt.geometry,Ht=Rt.material,gt=Rt.group;if(Ht.side===Sn&&lt.layers.test(re.layers)){let Rn=Ht.side;Ht.side=Wn,Ht.needsUpdate=!0,Go(lt,he,re,je,Ht,gt),Ht.side=Rn,Ht.needsUpdate=!0,ut=!0}}ut===!0&&(Le.updateMultisampleRenderTarget(Te),Le.updateRenderTargetMipmap(Te))}y.setRenderTarget(We,ze,Qe),y.setClearColor(V,W),Ze!==void 0&&(re.viewport=Ze),y.toneMapping=et}function bi(R,Z,he){let re=Z.isScene===!0?Z.overrideMaterial:null;for(let Q=0,Te=R.length;Q<Te;Q++){let Fe=R[Q],We=Fe.object,ze=Fe.geometry,Qe=Fe.group,et=Fe.material;et.allowOverride===!0&&re!==null&&(et=re),We.layers.test(he.layers)&&Go(We,Z,he,ze,et,Qe)}}function Go(R,Z,he,re,Q,Te){R.onBeforeRender(y,Z,he,re,Q,Te),R.modelViewMatrix.multiplyMatrices(he.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),Q.onBeforeRender(y,Z,he,re,R,Te),Q.transparent===!0&&Q.side===Sn&&Q.forceSinglePass===!1?(Q.side=Wn,Q.needsUpdate=!0,y.renderBufferDirect(he,Z,re,Q,R,Te),Q.side=gs,Q.needsUpdate=!0,y.renderBufferDirect(he,Z,re,Q,R,Te),Q.side=Sn):y.renderBufferDirect(he,Z,re,Q,R,Te),R.onAfterRender(y,Z,he,re,Q,Te)}function Zs(R,Z,he){Z.isScene!==!0&&(Z=we);let re=ae.get(R),Q=d.state.lights,Te=d.state.shadowsArray,Fe=Q.state.version,We=J.getParameters(R,Q.state,Te,Z,he),ze=J.getProgramCacheKey(We),Qe=re.programs;re.environment=R.isMeshStandardMaterial?Z.environment:null,re.fog=Z.fog,re.envMap=(R.isMeshStandardMaterial?ue:ce).get(R.envMap||re.environment),re.envMapRotation=re.environment!==null&&R.envMap===null?Z.environmentRotation:R.envMapRotation,Qe===void 0&&(R.addEventListener("dispose",me),Qe=new Map,re.programs=Qe);let et=Qe.get(ze);if(et!==void 0){if(re.currentProgram===et&&re.lightsStateVersion===Fe)return fl(R,We),et}else We.uniforms=J.getUniforms(R),R.onBeforeCompile(We,y),et=J.acquireProgram(We,ze),Qe.set(ze,et),re.uniforms=We.uniforms;let Ze=re.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ze.clippingPlanes=ge.uniform),fl(R,We),re.needsLights=Ks(R),re.lightsStateVersion=Fe,re.needsLights&&(Ze.ambientLightColor.value=Q.state.ambient,Ze.lightProbe.value=Q.state.probe,Ze.directionalLights.value=Q.state.directional,Ze.directionalLightShadows.value=Q.state.directionalShadow,Ze.spotLights.value=Q.state.spot,Ze.spotLightShadows.value=Q.state.spotShadow,Ze.rectAreaLights.value=Q.state.rectArea,Ze.ltc_1.value=Q.state.rectAreaLTC1,Ze.ltc_2.value=Q.state.rectAreaLTC2,Ze.pointLights.value=Q.state.point,Ze.pointLightShadows.value=Q.state.pointShadow,Ze.hemisphereLights.value=Q.state.hemi,Ze.directionalShadowMap.value=Q.state.directionalShadowMap,Ze.directionalShadowMatrix.value=Q.state.directionalShadowMatrix,Ze.spotShadowMap.value=Q.state.spotShadowMap,Ze.spotLightMatrix.value=Q.state.spotLightMatrix,Ze.spotLightMap.value=Q.state.spotLightMap,Ze.pointShadowMap.value=Q.state.pointShadowMap,Ze.pointShadowMatrix.value=Q.state.pointShadowMatrix),re.currentProgram=et,re.uniformsList=null,et}function ul(R){if(R.uniformsList===null){let Z=R.currentProgram.getUniforms();R.uniformsList=Ao.seqWithValue(Z.seq,R.uniforms)}return R.uniformsList}function fl(R,Z){let he=ae.get(R);he.outputColorSpace=Z.outputColorSpace,he.batching=Z.batching,he.batchingColor=Z.batchingColor,he.instancing=Z.instancing,he.instancingColor=Z.instancingColor,he.instancingMorph=Z.instancingMorph,he.skinning=Z.skinning,he.morphTargets=Z.morphTargets,he.morphNormals=Z.morphNormals,he.morphColors=Z.morphColors,he.morphTargetsCount=Z.morphTargetsCount,he.numClippingPlanes=Z.numClippingPlanes,he.numIntersection=Z.numClipIntersection,he.vertexAlphas=Z.vertexAlphas,he.vertexTangents=Z.vertexTangents,he.toneMapping=Z.toneMapping}function os(R,Z,he,re,Q){Z.isScene!==!0&&(Z=we),Le.resetTextureUnits();let Te=Z.fog,Fe=re.isMeshStandardMaterial?Z.environment:null,We=D===null?y.outputColorSpace:D.isXRRenderTarget===!0?D.texture.colorSpace:cr,ze=(re.isMeshStandardMaterial?ue:ce).get(re.envMap||Fe),Qe=re.vertexColors===!0&&!!he.attributes.color&&he.attributes.color.itemSize===4,et=!!he.attributes.tangent&&(!!re.normalMap||re.anisotropy>0),Ze=!!he.morphAttributes.position,ut=!!he.morphAttributes.normal,bt=!!he.morphAttributes.color,kt=_s;re.toneMapped&&(D===null||D.isXRRenderTarget===!0)&&(kt=y.toneMapping);let Rt=he.morphAttributes.position||he.morphAttributes.normal||he.morphAttributes.color,lt=Rt!==void 0?Rt.length:0,je=ae.get(re),Ht=d.state.lights;if(_e===!0&&(ee===!0||R!==S)){let pn=R===S&&re.id===w;ge.setState(re,R,pn)}let gt=!1;re.version===je.__version?(je.needsLights&&je.lightsStateVersion!==Ht.state.version||je.outputColorSpace!==We||Q.isBatchedMesh&&je.batching===!1||!Q.isBatchedMesh&&je.batching===!0||Q.isBatchedMesh&&je.batchingColor===!0&&Q.colorTexture===null||Q.isBatchedMesh&&je.batchingColor===!1&&Q.colorTexture!==null||Q.isInstancedMesh&&je.instancing===!1||!Q.isInstancedMesh&&je.instancing===!0||Q.isSkinnedMesh&&je.skinning===!1||!Q.isSkinnedMesh&&je.skinning===!0||Q.isInstancedMesh&&je.instancingColor===!0&&Q.instanceColor===null||Q.isInstancedMesh&&je.instancingColor===!1&&Q.instanceColor!==null||Q.isInstancedMesh&&je.instancingMorph===!0&&Q.morphTexture===null||Q.isInstancedMesh&&je.instancingMorph===!1&&Q.morphTexture!==null||je.envMap!==ze||re.fog===!0&&je.fog!==Te||je.numClippingPlanes!==void 0&&(je.numClippingPlanes!==ge.numPlanes||je.numIntersection!==ge.numIntersection)||je.vertexAlphas!==Qe||je.vertexTangents!==et||je.morphTargets!==Ze||je.morphNormals!==ut||je.morphColors!==bt||je.toneMapping!==kt||je.morphTargetsCount!==lt)&&(gt=!0):(gt=!0,je.__version=re.version);let Rn=je.currentProgram;gt===!0&&(Rn=Zs(re,Z,Q));let ws=!1,On=!1,Js=!1,Vt=Rn.getUniforms(),Bn=je.uniforms;if(Ce.useProgram(Rn.program)&&(ws=!0,On=!0,Js=!0),re.id!==w&&(w=re.id,On=!0),ws||S!==R){Ce.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),Vt.setValue(H,"projectionMatrix",R.projectionMatrix),Vt.setValue(H,"viewMatrix",R.matrixWorldInverse);let mn=Vt.map.cameraPosition;mn!==void 0&&mn.setValue(H,pe.setFromMatrixPosition(R.matrixWorld)),be.logarithmicDepthBuffer&&Vt.setValue(H,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(re.isMeshPhongMaterial||re.isMeshToonMaterial||re.isMeshLambertMaterial||re.isMeshBasicMaterial||re.isMeshStandardMaterial||re.isShaderMaterial)&&Vt.setValue(H,"isOrthographic",R.isOrthographicCamera===!0),S!==R&&(S=R,On=!0,Js=!0)}if(Q.isSkinnedMesh){Vt.setOptional(H,Q,"bindMatrix"),Vt.setOptional(H,Q,"bindMatrixInverse");let pn=Q.skeleton;pn&&(pn.boneTexture===null&&pn.computeBoneTexture(),Vt.setValue(H,"boneTexture",pn.boneTexture,Le))}Q.isBatchedMesh&&(Vt.setOptional(H,Q,"batchingTexture"),Vt.setValue(H,"batchingTexture",Q._matricesTexture,Le),Vt.setOptional(H,Q,"batchingIdTexture"),Vt.setValue(H,"batchingIdTexture",Q._indirectTexture,Le),Vt.setOptional(H,Q,"batchingColorTexture"),Q._colorsTexture!==null&&Vt.setValue(H,"batchingColorTexture",Q._colorsTexture,Le));let $n=he.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&ve.update(Q,he,Rn),(On||je.receiveShadow!==Q.receiveShadow)&&(je.receiveShadow=Q.receiveShadow,Vt.setValue(H,"receiveShadow",Q.receiveShadow)),re.isMeshGouraudMaterial&&re.envMap!==null&&(Bn.envMap.value=ze,Bn.flipEnvMap.value=ze.isCubeTexture&&ze.isRenderTargetTexture===!1?-1:1),re.isMeshStandardMaterial&&re.envMap===null&&Z.environment!==null&&(Bn.envMapIntensity.value=Z.environmentIntensity),On&&(Vt.setValue(H,"toneMappingExposure",y.toneMappingExposure),je.needsLights&&lu(Bn,Js),Te&&re.fog===!0&&j.refreshFogUniforms(Bn,Te),j.refreshMaterialUniforms(Bn,re,z,N,d.state.transmissionRenderTarget[R.id]),Ao.upload(H,ul(je),Bn,Le)),re.isShaderMaterial&&re.uniformsNeedUpdate===!0&&(Ao.upload(H,ul(je),Bn,Le),re.uniformsNeedUpdate=!1),re.isSpriteMaterial&&Vt.setValue(H,"center",Q.center),Vt.setValue(H,"modelViewMatrix",Q.modelViewMatrix),Vt.setValue(H,"normalMatrix",Q.normalMatrix),Vt.setValue(H,"modelMatrix",Q.matrixWorld),re.isShaderMaterial||re.isRawShaderMaterial){let pn=re.uniformsGroups;for(let mn=0,Ss=pn.length;mn<Ss;mn++){let fi=pn[mn];tt.update(fi,Rn),tt.bind(fi,Rn)}}return Rn}function lu(R,Z){R.ambientLightColor.needsUpdate=Z,R.lightProbe.needsUpdate=Z,R.directionalLights.needsUpdate=Z,R.directionalLightShadows.needsUpdate=Z,R.pointLights.needsUpdate=Z,R.pointLightShadows.needsUpdate=Z,R.spotLights.needsUpdate=Z,R.spotLightShadows.needsUpdate=Z,R.rectAreaLights.needsUpdate=Z,R.hemisphereLights.needsUpdate=Z}function Ks(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return E},this.getActiveMipmapLevel=function(){return I},this.getRenderTarget=function(){return D},this.setRenderTargetTextures=function(R,Z,he){let re=ae.get(R);re.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,re.__autoAllocateDepthBuffer===!1&&(re.__useRenderToTexture=!1),ae.get(R.texture).__webglTexture=Z,ae.get(R.depthTexture).__webglTexture=re.__autoAllocateDepthBuffer?void 0:he,re.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,Z){let he=ae.get(R);he.__webglFramebuffer=Z,he.__useDefaultFramebuffer=Z===void 0};let dl=H.createFramebuffer();this.setRenderTarget=function(R,Z=0,he=0){D=R,E=Z,I=he;let re=!0,Q=null,Te=!1,Fe=!1;if(R){let ze=ae.get(R);if(ze.__useDefaultFramebuffer!==void 0)Ce.bindFramebuffer(H.FRAMEBUFFER,null),re=!1;else if(ze.__webglFramebuffer===void 0)Le.setupRenderTarget(R);else if(ze.__hasExternalTextures)Le.rebindTextures(R,ae.get(R.texture).__webglTexture,ae.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Ze=R.depthTexture;if(ze.__boundDepthTexture!==Ze){if(Ze!==null&&ae.has(Ze)&&(R.width!==Ze.image.width||R.height!==Ze.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Le.setupDepthRenderbuffer(R)}}let Qe=R.texture;(Qe.isData3DTexture||Qe.isDataArrayTexture||Qe.isCompressedArrayTexture)&&(Fe=!0);let et=ae.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(et[Z])?Q=et[Z][he]:Q=et[Z],Te=!0):R.samples>0&&Le.useMultisampledRTT(R)===!1?Q=ae.get(R).__webglMultisampledFramebuffer:Array.isArray(et)?Q=et[he]:Q=et,A.copy(R.viewport),k.copy(R.scissor),B=R.scissorTest}else A.copy(te).multiplyScalar(z).floor(),k.copy(le).multiplyScalar(z).floor(),B=fe;if(he!==0&&(Q=dl),Ce.bindFramebuffer(H.FRAMEBUFFER,Q)&&re&&Ce.drawBuffers(R,Q),Ce.viewport(A),Ce.scissor(k),Ce.setScissorTest(B),Te){let ze=ae.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+Z,ze.__webglTexture,he)}else if(Fe){let ze=Z;for(let Qe=0;Qe<R.textures.length;Qe++){let et=ae.get(R.textures[Qe]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+Qe,et.__webglTexture,he,ze)}}else if(R!==null&&he!==0){let ze=ae.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,ze.__webglTexture,he)}w=-1},this.readRenderTargetPixels=function(R,Z,he,re,Q,Te,Fe,We=0){if(!(R&&R.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ze=ae.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Fe!==void 0&&(ze=ze[Fe]),ze){Ce.bindFramebuffer(H.FRAMEBUFFER,ze);try{let Qe=R.textures[We],et=Qe.format,Ze=Qe.type;if(!be.textureFormatReadable(et)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!be.textureTypeReadable(Ze)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}Z>=0&&Z<=R.width-re&&he>=0&&he<=R.height-Q&&(R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+We),H.readPixels(Z,he,re,Q,Ye.convert(et),Ye.convert(Ze),Te))}finally{let Qe=D!==null?ae.get(D).__webglFramebuffer:null;Ce.bindFramebuffer(H.FRAMEBUFFER,Qe)}}},this.readRenderTargetPixelsAsync=async function(R,Z,he,re,Q,Te,Fe,We=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ze=ae.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Fe!==void 0&&(ze=ze[Fe]),ze)if(Z>=0&&Z<=R.width-re&&he>=0&&he<=R.height-Q){Ce.bindFramebuffer(H.FRAMEBUFFER,ze);let Qe=R.textures[We],et=Qe.format,Ze=Qe.type;if(!be.textureFormatReadable(et))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!be.textureTypeReadable(Ze))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ut=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,ut),H.bufferData(H.PIXEL_PACK_BUFFER,Te.byteLength,H.STREAM_READ),R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+We),H.readPixels(Z,he,re,Q,Ye.convert(et),Ye.convert(Ze),0);let bt=D!==null?ae.get(D).__webglFramebuffer:null;Ce.bindFramebuffer(H.FRAMEBUFFER,bt);let kt=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await Jm(H,kt,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,ut),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,Te),H.deleteBuffer(ut),H.deleteSync(kt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,Z=null,he=0){let re=Math.pow(2,-he),Q=Math.floor(R.image.width*re),Te=Math.floor(R.image.height*re),Fe=Z!==null?Z.x:0,We=Z!==null?Z.y:0;Le.setTexture2D(R,0),H.copyTexSubImage2D(H.TEXTURE_2D,he,0,0,Fe,We,Q,Te),Ce.unbindTexture()};let Vi=H.createFramebuffer(),on=H.createFramebuffer();this.copyTextureToTexture=function(R,Z,he=null,re=null,Q=0,Te=null){Te===null&&(Q!==0?(uo("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),Te=Q,Q=0):Te=0);let Fe,We,ze,Qe,et,Ze,ut,bt,kt,Rt=R.isCompressedTexture?R.mipmaps[Te]:R.image;if(he!==null)Fe=he.max.x-he.min.x,We=he.max.y-he.min.y,ze=he.isBox3?he.max.z-he.min.z:1,Qe=he.min.x,et=he.min.y,Ze=he.isBox3?he.min.z:0;else{let $n=Math.pow(2,-Q);Fe=Math.floor(Rt.width*$n),We=Math.floor(Rt.height*$n),R.isDataArrayTexture?ze=Rt.depth:R.isData3DTexture?ze=Math.floor(Rt.depth*$n):ze=1,Qe=0,et=0,Ze=0}re!==null?(ut=re.x,bt=re.y,kt=re.z):(ut=0,bt=0,kt=0);let lt=Ye.convert(Z.format),je=Ye.convert(Z.type),Ht;Z.isData3DTexture?(Le.setTexture3D(Z,0),Ht=H.TEXTURE_3D):Z.isDataArrayTexture||Z.isCompressedArrayTexture?(Le.setTexture2DArray(Z,0),Ht=H.TEXTURE_2D_ARRAY):(Le.setTexture2D(Z,0),Ht=H.TEXTURE_2D),H.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,Z.flipY),H.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,Z.premultiplyAlpha),H.pixelStorei(H.UNPACK_ALIGNMENT,Z.unpackAlignment);let gt=H.getParameter(H.UNPACK_ROW_LENGTH),Rn=H.getParameter(H.UNPACK_IMAGE_HEIGHT),ws=H.getParameter(H.UNPACK_SKIP_PIXELS),On=H.getParameter(H.UNPACK_SKIP_ROWS),Js=H.getParameter(H.UNPACK_SKIP_IMAGES);H.pixelStorei(H.UNPACK_ROW_LENGTH,Rt.width),H.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Rt.height),H.pixelStorei(H.UNPACK_SKIP_PIXELS,Qe),H.pixelStorei(H.UNPACK_SKIP_ROWS,et),H.pixelStorei(H.UNPACK_SKIP_IMAGES,Ze);let Vt=R.isDataArrayTexture||R.isData3DTexture,Bn=Z.isDataArrayTexture||Z.isData3DTexture;if(R.isDepthTexture){let $n=ae.get(R),pn=ae.get(Z),mn=ae.get($n.__renderTarget),Ss=ae.get(pn.__renderTarget);Ce.bindFramebuffer(H.READ_FRAMEBUFFER,mn.__webglFramebuffer),Ce.bindFramebuffer(H.DRAW_FRAMEBUFFER,Ss.__webglFramebuffer);for(let fi=0;fi<ze;fi++)Vt&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,ae.get(R).__webglTexture,Q,Ze+fi),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,ae.get(Z).__webglTexture,Te,kt+fi)),H.blitFramebuffer(Qe,et,Fe,We,ut,bt,Fe,We,H.DEPTH_BUFFER_BIT,H.NEAREST);Ce.bindFramebuffer(H.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(Q!==0||R.isRenderTargetTexture||ae.has(R)){let $n=ae.get(R),pn=ae.get(Z);Ce.bindFramebuffer(H.READ_FRAMEBUFFER,Vi),Ce.bindFramebuffer(H.DRAW_FRAMEBUFFER,on);for(let mn=0;mn<ze;mn++)Vt?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,$n.__webglTexture,Q,Ze+mn):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,$n.__webglTexture,Q),Bn?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,pn.__webglTexture,Te,kt+mn):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,pn.__webglTexture,Te),Q!==0?H.blitFramebuffer(Qe,et,Fe,We,ut,bt,Fe,We,H.COLOR_BUFFER_BIT,H.NEAREST):Bn?H.copyTexSubImage3D(Ht,Te,ut,bt,kt+mn,Qe,et,Fe,We):H.copyTexSubImage2D(Ht,Te,ut,bt,Qe,et,Fe,We);Ce.bindFramebuffer(H.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else Bn?R.isDataTexture||R.isData3DTexture?H.texSubImage3D(Ht,Te,ut,bt,kt,Fe,We,ze,lt,je,Rt.data):Z.isCompressedArrayTexture?H.compressedTexSubImage3D(Ht,Te,ut,bt,kt,Fe,We,ze,lt,Rt.data):H.texSubImage3D(Ht,Te,ut,bt,kt,Fe,We,ze,lt,je,Rt):R.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,Te,ut,bt,Fe,We,lt,je,Rt.data):R.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,Te,ut,bt,Rt.width,Rt.height,lt,Rt.data):H.texSubImage2D(H.TEXTURE_2D,Te,ut,bt,Fe,We,lt,je,Rt);H.pixelStorei(H.UNPACK_ROW_LENGTH,gt),H.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Rn),H.pixelStorei(H.UNPACK_SKIP_PIXELS,ws),H.pixelStorei(H.UNPACK_SKIP_ROWS,On),H.pixelStorei(H.UNPACK_SKIP_IMAGES,Js),Te===0&&Z.generateMipmaps&&H.generateMipmap(Ht),Ce.unbindTexture()},this.initRenderTarget=function(R){ae.get(R).__webglFramebuffer===void 0&&Le.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Le.setTextureCube(R,0):R.isData3DTexture?Le.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Le.setTexture2DArray(R,0):Le.setTexture2D(R,0),Ce.unbindTexture()},this.resetState=function(){E=0,I=0,D=null,Ce.reset(),Ue.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};var Ih=({x:i,y:e,z:t})=>new L(i,e,t),kS=1e-9,Cg=i=>i.joint.length?Ih(i.joint[0].path.end).length():i.length,Pg=(i,e,t=0)=>i.joint.length?Math.max(Math.abs(i.length-e),Math.abs(t)):i.length-e,wr,Ig,jf,Qf=class Qf{constructor(e){vl(this,wr);this.free=e.length,this.along=new L(...e.direction);let[t]=e.joint;if(!t)return;Cn(this,wr,Ig).call(this,t);let[n]=e.second;n&&(this.second=new Qf({length:0,direction:e.direction,joint:[n],second:[]}),this.beyond=new L,this.inner=new sn)}get isHinge(){return this.curvature>kS}at(e,t,n=null,s=0){this.second&&s!==0?(Cn(this,wr,jf).call(this,e,t,this.inner),this.second.at(s,this.beyond,n),t.add(this.beyond.sub(this.start).applyQuaternion(this.inner)),n?.premultiply(this.inner)):Cn(this,wr,jf).call(this,e,t,n)}};wr=new WeakSet,Ig=function(e){this.start=Ih(e.path.end),this.along=Ih(e.path.direction),this.inward=Ih(e.path.inward),this.axis=this.along.clone().cross(this.inward),this.curvature=e.path.curvature,this.anchor=new L(...e.anchor)},jf=function(e,t,n){if(n?.identity(),!this.start){t.copy(this.along).multiplyScalar(e);return}let s=e-this.free;if(t.copy(this.start),!this.isHinge){t.addScaledVector(this.along,s);return}let r=this.curvature*s;t.addScaledVector(this.along,Math.sin(r)/this.curvature),t.addScaledVector(this.inward,(1-Math.cos(r))/this.curvature),n?.setFromAxisAngle(this.axis,r)};var Co=Qf;function HS(i){let e=[];for(let n of i)for(let[s,r]of n.impacts.slice(0,12)){let o=s+n.shift-.008;e.push([o,Math.min(r,s+.12)+n.shift+.02])}e.sort((n,s)=>n[0]-s[0]);let t=[];for(let n of e){let s=t[t.length-1];s&&n[0]<s[1]+2*.12?s[1]=Math.max(s[1],n[1]):t.push([...n])}return t.map(([n,s])=>[n,s,Math.min(1,Math.max(.005,(s-n)/3))])}function ed(i,e){let t=1;for(let[n,s,r]of i){let o=Math.max(n-e,e-s,0);o<.12&&(t=Math.min(t,r**((1+Math.cos(Math.PI*o/.12))/2)))}return t}function Dg(i){let e=Math.min(...i.map(l=>l.begin+l.shift)),t=Math.max(...i.map(l=>l.end+l.shift)),n=HS(i),s=new Set([e,t]);for(let l=1;l<200;l++)s.add(e+(t-e)*l/200);for(let[l,c]of n)for(let u=0;u<=60;u++)s.add(l-.12+(c-l+2*.12)*u/60),s.add(l+(c-l)*u/60),s.add(l-.12*u/60),s.add(c+.12*u/60);let r=[...s].filter(l=>l>=e&&l<=t).sort((l,c)=>l-c),o=[0];for(let l=1;l<r.length;l++){let c=Math.sqrt(ed(n,r[l-1])*ed(n,r[l]));o.push(o[l-1]+(r[l]-r[l-1])/c)}let a=o[o.length-1]||1;return{begin:e,end:t,stretches:n,total:a,paceAt:l=>ed(n,l),watchedAt:l=>Lg(r,o,l),timeAt:l=>Lg(o,r,l)}}function Lg(i,e,t){let n=0,s=i.length-1;if(!(t>i[0]))return e[0];if(t>=i[s])return e[s];for(;s-n>1;){let r=n+s>>1;i[r]<=t?n=r:s=r}return e[n]+(e[s]-e[n])*(t-i[n])/(i[s]-i[n])}var VS="uplot",GS="u-hz",WS="u-vt",XS="u-title",qS="u-wrap",YS="u-under",$S="u-over",ZS="u-axis",Tr="u-off",KS="u-select",JS="u-cursor-x",jS="u-cursor-y",QS="u-cursor-pt",e1="u-legend",t1="u-live",n1="u-inline",i1="u-series",s1="u-marker",Ug="u-label",r1="u-value",Ka="width",Ja="height";var Ng="bottom",Po="left",td="right",xd="#000",Fg=xd+"0",nd="mousemove",Og="mousedown",id="mouseup",Bg="mouseenter",zg="mouseleave",kg="dblclick",o1="resize",a1="scroll",Hg="change",Fh="dppxchange",_d="--",Oo=typeof window<"u",ld=Oo?document:null,Lo=Oo?window:null,l1=Oo?navigator:null,Tt,Lh;function cd(){let i=devicePixelRatio;Tt!=i&&(Tt=i,Lh&&ud(Hg,Lh,cd),Lh=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),Ar(Hg,Lh,cd),Lo.dispatchEvent(new CustomEvent(Fh)))}function ci(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function hd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Oi(i,e,t,n){let s=ld.createElement(i);return e!=null&&ci(s,e),t?.insertBefore(s,n),s}function _i(i,e){return Oi("div",i,e)}var Vg=new WeakMap;function ts(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Vg.get(i);r!=o&&(i.style.transform=r,Vg.set(i,r),e<0||t<0||e>n||t>s?ci(i,Tr):hd(i,Tr))}var Gg=new WeakMap;function Wg(i,e,t){let n=e+t,s=Gg.get(i);n!=s&&(Gg.set(i,n),i.style.background=e,i.style.borderColor=t)}var Xg=new WeakMap;function qg(i,e,t,n){let s=e+""+t,r=Xg.get(i);s!=r&&(Xg.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var yd={passive:!0},c1={...yd,capture:!0};function Ar(i,e,t,n){e.addEventListener(i,t,n?c1:yd)}function ud(i,e,t,n){e.removeEventListener(i,t,yd)}Oo&&cd();function Bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:hi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function y0(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var b0=i=>i!=null,M0=i=>i!=null&&i>0,zh=y0(b0),h1=y0(M0);function u1(i,e,t,n=0,s=!1){let r=s?h1:zh,o=s?M0:b0;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function kh(i,e,t,n){let s=Zg(i),r=Zg(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?bs:w0,a=s==1?hi:yi,l=r==1?yi:hi,c=a(o(fn(i))),u=l(o(fn(e))),h=Do(t,c),f=Do(t,u);return t==10&&(c<0&&(h=zt(h,-c)),u<0&&(f=zt(f,-u))),n||t==2?(i=h*s,e=f*r):(i=A0(i,h),e=Hh(e,f)),[i,e]}function bd(i,e,t,n){let s=kh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Md=.1,Yg={mode:3,pad:Md},Qa={pad:0,soft:null,mode:0},f1={min:Qa,max:Qa};function Oh(i,e,t,n){return Vh(t)?$g(i,e,t):(Qa.pad=t,Qa.soft=n?0:null,Qa.mode=n?3:0,$g(i,e,f1))}function wt(i,e){return i??e}function d1(i,e,t){for(e=wt(e,0),t=wt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function $g(i,e,t){let n=t.min,s=t.max,r=wt(n.pad,0),o=wt(s.pad,0),a=wt(n.hard,-Bt),l=wt(s.hard,Bt),c=wt(n.soft,Bt),u=wt(s.soft,-Bt),h=wt(n.mode,0),f=wt(s.mode,0),m=e-i,g=bs(m),v=qn(fn(i),fn(e)),p=bs(v),d=fn(p-g);(m<1e-24||d>10)&&(m=0,(i==0||e==0)&&(m=1e-24,h==2&&c!=Bt&&(r=0),f==2&&u!=-Bt&&(o=0)));let b=m||v||1e3,M=bs(b),y=Do(10,hi(M)),P=b*(m==0?i==0?.1:1:r),E=zt(A0(i-P,y/10),24),I=i>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Bt,D=qn(a,E<I&&i>=I?I:zi(I,E)),w=b*(m==0?e==0?.1:1:o),S=zt(Hh(e+w,y/10),24),A=e<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-Bt,k=zi(l,S>A&&e<=A?A:qn(A,S));return D==k&&D==0&&(k=100),[D,k]}var p1=new Intl.NumberFormat(Oo?l1.language:"en-US"),wd=i=>p1.format(i),ui=Math,Nh=ui.PI,fn=ui.abs,hi=ui.floor,un=ui.round,yi=ui.ceil,zi=ui.min,qn=ui.max,Do=ui.pow,Zg=ui.sign,bs=ui.log10,w0=ui.log2,m1=(i,e=1)=>ui.sinh(i)*e,sd=(i,e=1)=>ui.asinh(i/e),Bt=1/0;function Kg(i){return(bs((i^i>>31)-(i>>31))|0)+1}function fd(i,e,t){return zi(qn(i,e),t)}function S0(i){return typeof i=="function"}function vt(i){return S0(i)?i:()=>i}var g1=()=>{},E0=i=>i,T0=(i,e)=>e,v1=i=>null,Jg=i=>!0,jg=(i,e)=>i==e,x1=/\.\d*?(?=9{6,}|0{6,})/gm,Rr=i=>{if(C0(i)||Ys.has(i))return i;let e=`${i}`,t=e.match(x1);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Rr(s)}e${r}`}return zt(i,n)};function Sr(i,e){return Rr(zt(Rr(i/e))*e)}function Hh(i,e){return Rr(yi(Rr(i/e))*e)}function A0(i,e){return Rr(hi(Rr(i/e))*e)}function zt(i,e=0){if(C0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return un(n)/t}var Ys=new Map;function R0(i){return((""+i).split(".")[1]||"").length}function tl(i,e,t,n){let s=[],r=n.map(R0);for(let o=e;o<t;o++){let a=fn(o),l=zt(Do(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:zt(u,h);s.push(f),Ys.set(f,h)}}return s}var el={},Sd=[],Uo=[null,null],qs=Array.isArray,C0=Number.isInteger,_1=i=>i===void 0;function Qg(i){return typeof i=="string"}function Vh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function y1(i){return i!=null&&typeof i=="object"}var b1=Object.getPrototypeOf(Uint8Array),P0="__proto__";function No(i,e=Vh){let t;if(qs(i)){let n=i.find(s=>s!=null);if(qs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=No(i[s],e)}else t=i.slice()}else if(i instanceof b1)t=i.slice();else if(e(i)){t={};for(let n in i)n!=P0&&(t[n]=No(i[n],e))}else t=i;return t}function rn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=P0&&(Vh(i[s])?rn(i[s],No(n[s])):i[s]=No(n[s]))}return i}var M1=0,w1=1,S1=2;function E1(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function T1(i,e){if(C1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return P1(o[0])||(o=R1(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:w1,m=[];for(let g=0;g<u.length;g++){let v=u[g],p=r.get(l[g]);v===null?f!=M1&&(h[p]=v,f==S1&&m.push(p)):h[p]=v}E1(h,m,s),n.push(h)}}return n}var A1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function R1(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function C1(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function P1(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=qn(1,hi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var I0=["January","February","March","April","May","June","July","August","September","October","November","December"],L0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function D0(i){return i.slice(0,3)}var I1=L0.map(D0),L1=I0.map(D0),D1={MMMM:I0,MMM:L1,WWWW:L0,WWW:I1};function Za(i){return(i<10?"0":"")+i}function U1(i){return(i<10?"00":i<100?"0":"")+i}var N1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Za(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Za(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Za(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Za(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Za(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>U1(i.getMilliseconds())};function Ed(i,e){e=e||D1;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?N1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var F1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function O1(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==F1?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var U0=i=>i%1==0,Bh=[1,2,2.5,5],B1=tl(10,-32,0,Bh),N0=tl(10,0,32,Bh),z1=N0.filter(U0),Er=B1.concat(N0),Td=`
`,F0="{YYYY}",e0=Td+F0,O0="{M}/{D}",ja=Td+O0,Dh=ja+"/{YY}",B0="{aa}",k1="{h}:{mm}",Io=k1+B0,t0=Td+Io,n0=":{ss}",At=null;function z0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?tl(10,0,3,Bh).filter(U0):tl(10,-3,0,Bh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,F0,At,At,At,At,At,At,1],[s*28,"{MMM}",e0,At,At,At,At,At,1],[s,O0,e0,At,At,At,At,At,1],[n,"{h}"+B0,Dh,At,ja,At,At,At,1],[t,Io,Dh,At,ja,At,At,At,1],[e,n0,Dh+" "+Io,At,ja+" "+Io,At,t0,At,1],[i,n0+".{fff}",Dh+" "+Io,At,ja+" "+Io,At,t0,At,1]];function u(h){return(f,m,g,v,p,d)=>{let b=[],M=p>=o,y=p>=r&&p<o,P=h(g),E=zt(P*i,3),I=rd(P.getFullYear(),M?0:P.getMonth(),y||M?1:P.getDate()),D=zt(I*i,3);if(y||M){let w=y?p/r:0,S=M?p/o:0,A=E==D?E:zt(rd(I.getFullYear()+S,I.getMonth()+w,1)*i,3),k=new Date(un(A/i)),B=k.getFullYear(),V=k.getMonth();for(let W=0;A<=v;W++){let q=rd(B+S*W,V+w*W,1),N=q-h(zt(q*i,3));A=zt((+q+N)*i,3),A<=v&&b.push(A)}}else{let w=p>=s?s:p,S=hi(g)-hi(E),A=D+S+Hh(E-D,w);b.push(A);let k=h(A),B=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,V=p/n,W=f.axes[m]._space,q=d/W;for(;A=zt(A+p,i==1?0:3),!(A>v);)if(V>1){let N=hi(zt(B+V,6))%24,ne=h(A).getHours()-N;ne>1&&(ne=-1),A-=ne*n,B=(B+V)%24;let te=b[b.length-1];zt((A-te)/p,3)*q>=.7&&b.push(A)}else b.push(A)}return b}}return[l,c,u]}var[H1,V1,G1]=z0(1),[W1,X1,q1]=z0(.001);tl(2,-53,53,[1]);function i0(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function s0(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,f,m;return n.map(g=>{let v=i(g),p=v.getFullYear(),d=v.getMonth(),b=v.getDate(),M=v.getHours(),y=v.getMinutes(),P=v.getSeconds(),E=p!=l&&a[2]||d!=c&&a[3]||b!=u&&a[4]||M!=h&&a[5]||y!=f&&a[6]||P!=m&&a[7]||a[1];return l=p,c=d,u=b,h=M,f=y,m=P,E(v)})}}function Y1(i,e){let t=Ed(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function rd(i,e,t){return new Date(i,e,t)}function r0(i,e){return e(i)}var $1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function o0(i,e){return(t,n,s,r)=>r==null?_d:e(i(n))}function Z1(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function K1(i,e){return i.series[e].fill(i,e)}var J1={show:!0,live:!0,isolate:!1,mount:g1,markers:{show:!0,width:2,stroke:Z1,fill:K1,dash:"solid"},idx:null,idxs:null,values:[]};function j1(i,e){let t=i.cursor.points,n=_i(),s=t.size(i,e);Yt(n,Ka,s),Yt(n,Ja,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Yt(n,"borderWidth",o),n}function Q1(i,e){let t=i.series[e].points;return t._fill||t._stroke}function eE(i,e){let t=i.series[e].points;return t._stroke||t._fill}function tE(i,e){return i.series[e].points.size}var od=[0,0];function nE(i,e,t){return od[0]=e,od[1]=t,od}function Uh(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function ad(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var iE={show:!0,x:!0,y:!0,lock:!1,move:nE,points:{one:!1,show:j1,size:tE,width:0,stroke:eE,fill:Q1},bind:{mousedown:Uh,mouseup:Uh,click:Uh,dblclick:Uh,mousemove:ad,mouseleave:ad,mouseenter:ad},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},k0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ad=rn({},k0,{filter:T0}),H0=rn({},Ad,{size:10}),V0=rn({},k0,{show:!1}),Rd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',G0="bold "+Rd,W0=1.5,a0={show:!0,scale:"x",stroke:xd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:G0,side:2,grid:Ad,ticks:H0,border:V0,font:Rd,lineGap:W0,rotate:0},sE="Value",rE="Time",l0={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function oE(i,e,t,n,s){return e.map(r=>r==null?"":wd(r))}function aE(i,e,t,n,s,r,o){let a=[],l=Ys.get(s)||0;t=o?t:zt(Hh(t,s),l);for(let c=t;c<=n;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function dd(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?bs:w0,u=hi(c(t));s=Do(l,u),l==10&&(s=Er[Bi(s,Er)]);let h=t,f=s*l;l==10&&(f=Er[Bi(f,Er)]);do a.push(h),h=h+s,l==10&&!Ys.has(h)&&(h=zt(h,Ys.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Er[Bi(f,Er)]));while(h<=n);return a}function lE(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?dd(i,e,qn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?dd(i,e,qn(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var X0=/./,cE=/[12357]/,hE=/[125]/,c0=/1/,pd=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function uE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?X0:l(7,o)-u>=c?cE:l(5,o)-u>=c?hE:c0;if(h==c0){let f=fn(l(1,o)-u);if(f<c)return pd(e.slice().reverse(),a.distr,h,yi(c/f)).reverse()}return pd(e,a.distr,h,1)}function fE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=fn(l(1,o)-l(2,o));return c<a?pd(e.slice().reverse(),3,X0,yi(a/c)).reverse():e}function dE(i,e,t,n){return n==null?_d:e==null?"":wd(e)}var h0={show:!0,scale:"y",stroke:xd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:G0,side:3,grid:Ad,ticks:H0,border:V0,font:Rd,lineGap:W0,rotate:0};function pE(i,e){let t=3+(i||1)*2;return zt(t*e,3)}function mE(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=fn(o-r),l=i.series[e],c=a/(l.points.space*Tt);return n[1]-n[0]<=c}var u0={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},q0=(i,e,t,n,s)=>s,f0={show:!0,auto:!0,sorted:0,gaps:q0,alpha:1,facets:[rn({},u0,{scale:"x"}),rn({},u0,{scale:"y"})]},d0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:q0,alpha:1,points:{show:mE,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function gE(i,e,t,n,s){return t/10}var Y0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},vE=rn({},Y0,{time:!1,ori:1}),p0={};function $0(i,e){let t=p0[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(p0[i]=t)),t}var Fo=1,md=2;function Cr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,m=a.top,g=a.width,v=a.height,p=i.valToPosH,d=i.valToPosV;return u.ori==0?t(s,l,c,u,h,p,d,f,m,g,v,Wh,Bo,qh,K0,j0):t(s,l,c,u,h,d,p,m,f,v,g,Xh,zo,Id,J0,Q0)}function Cd(i,e){let t=0,n=0,s=wt(i.bands,Sd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function xE(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(i,e,t,n,s,r){return Cr(i,e,(o,a,l,c,u,h,f,m,g,v,p)=>{let d=o.pxRound,b=c.dir*(c.ori==0?1:-1),M=c.ori==0?Bo:zo,y,P;b==1?(y=t,P=n):(y=n,P=t);let E=d(h(a[y],c,v,m)),I=d(f(l[y],u,p,g)),D=d(h(a[P],c,v,m)),w=d(f(r==1?u.max:u.min,u,p,g)),S=new Path2D(s);return M(S,D,w),M(S,E,w),M(S,E,I),S})}function Gh(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?qh:Id,l=t;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let m=f[0]-l;m>0&&a(o,l,n,m,n+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function _E(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Pd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let m=r(i[h]),g=f==h?m:r(i[f]),v=h-s;m=o<=0&&v>=0&&v<l?r(i[v]):m;let d=f+s;g=o>=0&&d>=0&&d<l?r(i[d]):g,g>=m&&a.push([m,g])}return a}function m0(i){return i==0?E0:i==1?un:e=>Sr(e,i)}function Z0(i){let e=i==0?Wh:Xh,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=zi(c,a/2,l/2),u=zi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Wh=(i,e,t)=>{i.moveTo(e,t)},Xh=(i,e,t)=>{i.moveTo(t,e)},Bo=(i,e,t)=>{i.lineTo(e,t)},zo=(i,e,t)=>{i.lineTo(t,e)},qh=Z0(0),Id=Z0(1),K0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},J0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},j0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Q0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function ev(i){return(e,t,n,s,r)=>Cr(e,t,(o,a,l,c,u,h,f,m,g,v,p)=>{let{pxRound:d,points:b}=o,M,y;c.ori==0?(M=Wh,y=K0):(M=Xh,y=J0);let P=zt(b.width*Tt,3),E=(b.size-b.width)/2*Tt,I=zt(E*2,3),D=new Path2D,w=new Path2D,{left:S,top:A,width:k,height:B}=e.bbox;qh(w,S-I,A-I,k+I*2,B+I*2);let V=W=>{if(l[W]!=null){let q=d(h(a[W],c,v,m)),N=d(f(l[W],u,p,g));M(D,q+E,N),y(D,q,N,E,0,Nh*2)}};if(r)r.forEach(V);else for(let W=n;W<=s;W++)V(W);return{stroke:P>0?D:null,fill:D,clip:w,flags:Fo|md}})}function tv(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var yE=tv(Bo),bE=tv(zo);function nv(i){let e=wt(i?.alignGaps,0);return(t,n,s,r)=>Cr(t,n,(o,a,l,c,u,h,f,m,g,v,p)=>{[s,r]=zh(l,s,r);let d=o.pxRound,b=B=>d(h(B,c,v,m)),M=B=>d(f(B,u,p,g)),y,P;c.ori==0?(y=Bo,P=yE):(y=zo,P=bE);let E=c.dir*(c.ori==0?1:-1),I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},D=I.stroke,w=!1;if(r-s>=v*4){let B=fe=>t.posToVal(fe,c.key,!0),V=null,W=null,q,N,z,K=b(a[E==1?s:r]),ne=b(a[s]),te=b(a[r]),le=B(E==1?ne+1:te-1);for(let fe=E==1?s:r;fe>=s&&fe<=r;fe+=E){let ye=a[fe],ee=(E==1?ye<le:ye>le)?K:b(ye),Y=l[fe];ee==K?Y!=null?(N=Y,V==null?(y(D,ee,M(N)),q=V=W=N):N<V?V=N:N>W&&(W=N)):Y===null&&(w=!0):(V!=null&&P(D,K,M(V),M(W),M(q),M(N)),Y!=null?(N=Y,y(D,ee,M(N)),V=W=q=N):(V=W=null,Y===null&&(w=!0)),K=ee,le=B(K+E))}V!=null&&V!=W&&z!=K&&P(D,K,M(V),M(W),M(q),M(N))}else for(let B=E==1?s:r;B>=s&&B<=r;B+=E){let V=l[B];V===null?w=!0:V!=null&&y(D,b(a[B]),M(V))}let[A,k]=Cd(t,n);if(o.fill!=null||A!=0){let B=I.fill=new Path2D(D),V=o.fillTo(t,n,o.min,o.max,A),W=M(V),q=b(a[s]),N=b(a[r]);E==-1&&([N,q]=[q,N]),y(B,N,W),y(B,q,W)}if(!o.spanGaps){let B=[];w&&B.push(...Pd(a,l,s,r,E,b,e)),I.gaps=B=o.gaps(t,n,s,r,B),I.clip=Gh(B,c.ori,m,g,v,p)}return k!=0&&(I.band=k==2?[Ms(t,n,s,r,D,-1),Ms(t,n,s,r,D,1)]:Ms(t,n,s,r,D,k)),I})}function ME(i){let e=wt(i.align,1),t=wt(i.ascDesc,!1),n=wt(i.alignGaps,0),s=wt(i.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,u,h,f,m,g,v,p,d,b,M)=>{[a,l]=zh(h,a,l);let y=c.pxRound,{left:P,width:E}=r.bbox,I=ne=>y(g(ne,f,b,p)),D=ne=>y(v(ne,m,M,d)),w=f.ori==0?Bo:zo,S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},A=S.stroke,k=f.dir*(f.ori==0?1:-1),B=D(h[k==1?a:l]),V=I(u[k==1?a:l]),W=V,q=V;s&&e==-1&&(q=P,w(A,q,B)),w(A,V,B);for(let ne=k==1?a:l;ne>=a&&ne<=l;ne+=k){let te=h[ne];if(te==null)continue;let le=I(u[ne]),fe=D(te);e==1?w(A,le,B):w(A,W,fe),w(A,le,fe),B=fe,W=le}let N=W;s&&e==1&&(N=P+E,w(A,N,B));let[z,K]=Cd(r,o);if(c.fill!=null||z!=0){let ne=S.fill=new Path2D(A),te=c.fillTo(r,o,c.min,c.max,z),le=D(te);w(ne,N,le),w(ne,q,le)}if(!c.spanGaps){let ne=[];ne.push(...Pd(u,h,a,l,k,I,n));let te=c.width*Tt/2,le=t||e==1?te:-te,fe=t||e==-1?-te:te;ne.forEach(ye=>{ye[0]+=le,ye[1]+=fe}),S.gaps=ne=c.gaps(r,o,a,l,ne),S.clip=Gh(ne,f.ori,p,d,b,M)}return K!=0&&(S.band=K==2?[Ms(r,o,a,l,A,-1),Ms(r,o,a,l,A,1)]:Ms(r,o,a,l,A,K)),S})}function g0(i,e,t,n,s,r,o=Bt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=fn(i[l]-i[a]);u<c&&(c=u,o=fn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function wE(i){i=i||el;let e=wt(i.size,[.6,Bt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=wt(e[1],Bt),l=wt(e[2],1),c=wt(i.disp,el),u=wt(i.each,m=>{}),{fill:h,stroke:f}=c;return(m,g,v,p)=>Cr(m,g,(d,b,M,y,P,E,I,D,w,S,A)=>{let k=d.pxRound,B=t,V=n*Tt,W=a*Tt,q=l*Tt,N,z;y.ori==0?[N,z]=r(m,g):[z,N]=r(m,g);let K=y.dir*(y.ori==0?1:-1),ne=y.ori==0?qh:Id,te=y.ori==0?u:(F,J,j,ie,Pe,ge,Oe)=>{u(F,J,j,Pe,ie,Oe,ge)},le=wt(m.bands,Sd).find(F=>F.series[0]==g),fe=le!=null?le.dir:0,ye=d.fillTo(m,g,d.min,d.max,fe),_e=k(I(ye,P,A,w)),ee,Y,pe,xe=S,we=k(d.width*Tt),Ve=!1,dt=null,H=null,ht=null,oe=null;h!=null&&(we==0||f!=null)&&(Ve=!0,dt=h.values(m,g,v,p),H=new Map,new Set(dt).forEach(F=>{F!=null&&H.set(F,new Path2D)}),we>0&&(ht=f.values(m,g,v,p),oe=new Map,new Set(ht).forEach(F=>{F!=null&&oe.set(F,new Path2D)})));let{x0:be,size:Ce}=c;if(be!=null&&Ce!=null){B=1,b=be.values(m,g,v,p),be.unit==2&&(b=b.map(j=>m.posToVal(D+j*S,y.key,!0)));let F=Ce.values(m,g,v,p);Ce.unit==2?Y=F[0]*S:Y=E(F[0],y,S,D)-E(0,y,S,D),xe=g0(b,M,E,y,S,D,xe),pe=xe-Y+V}else xe=g0(b,M,E,y,S,D,xe),pe=xe*o+V,Y=xe-pe;pe<1&&(pe=0),we>=Y/2&&(we=0),pe<5&&(k=E0);let ot=pe>0,ae=xe-pe-(ot?we:0);Y=k(fd(ae,q,W)),ee=(B==0?Y/2:B==K?0:Y)-B*K*((B==0?V/2:0)+(ot?we/2:0));let Le={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},ce=Ve?null:new Path2D,ue=null;if(le!=null)ue=m.data[le.series[1]];else{let{y0:F,y1:J}=c;F!=null&&J!=null&&(M=J.values(m,g,v,p),ue=F.values(m,g,v,p))}let C=N*Y,_=z*Y;for(let F=K==1?v:p;F>=v&&F<=p;F+=K){let J=M[F];if(J==null)continue;if(ue!=null){let Re=ue[F]??0;if(J-Re==0)continue;_e=I(Re,P,A,w)}let j=y.distr!=2||c!=null?b[F]:F,ie=E(j,y,S,D),Pe=I(wt(J,ye),P,A,w),ge=k(ie-ee),Oe=k(qn(Pe,_e)),De=k(zi(Pe,_e)),ve=Oe-De;if(J!=null){let Re=J<0?_:C,qe=J<0?C:_;Ve?(we>0&&ht[F]!=null&&ne(oe.get(ht[F]),ge,De+hi(we/2),Y,qn(0,ve-we),Re,qe),dt[F]!=null&&ne(H.get(dt[F]),ge,De+hi(we/2),Y,qn(0,ve-we),Re,qe)):ne(ce,ge,De+hi(we/2),Y,qn(0,ve-we),Re,qe),te(m,g,F,ge-we/2,De,Y+we,ve)}}return we>0?Le.stroke=Ve?oe:ce:Ve||(Le._fill=d.width==0?d._fill:d._stroke??d._fill,Le.width=0),Le.fill=Ve?H:ce,Le})}function SE(i,e){let t=wt(e?.alignGaps,0);return(n,s,r,o)=>Cr(n,s,(a,l,c,u,h,f,m,g,v,p,d)=>{[r,o]=zh(c,r,o);let b=a.pxRound,M=N=>b(f(N,u,p,g)),y=N=>b(m(N,h,d,v)),P,E,I;u.ori==0?(P=Wh,I=Bo,E=j0):(P=Xh,I=zo,E=Q0);let D=u.dir*(u.ori==0?1:-1),w=M(l[D==1?r:o]),S=w,A=[],k=[];for(let N=D==1?r:o;N>=r&&N<=o;N+=D)if(c[N]!=null){let K=l[N],ne=M(K);A.push(S=ne),k.push(y(c[N]))}let B={stroke:i(A,k,P,I,E,b),fill:null,clip:null,band:null,gaps:null,flags:Fo},V=B.stroke,[W,q]=Cd(n,s);if(a.fill!=null||W!=0){let N=B.fill=new Path2D(V),z=a.fillTo(n,s,a.min,a.max,W),K=y(z);I(N,S,K),I(N,w,K)}if(!a.spanGaps){let N=[];N.push(...Pd(l,c,r,o,D,M,t)),B.gaps=N=a.gaps(n,s,r,o,N),B.clip=Gh(N,u.ori,g,v,p,d)}return q!=0&&(B.band=q==2?[Ms(n,s,r,o,V,-1),Ms(n,s,r,o,V,1)]:Ms(n,s,r,o,V,q)),B})}function EE(i){return SE(TE,i)}function TE(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,e[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,i[f+1],e[f+1])}return a}var gd=new Set;function v0(){for(let i of gd)i.syncRect(!0)}Oo&&(Ar(o1,Lo,v0),Ar(a1,Lo,v0,!0),Ar(Fh,Lo,()=>{Kt.pxRatio=Tt}));var AE=nv(),RE=ev();function x0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>vd(r,o,e,t))}function CE(i,e){return i.map((t,n)=>n==0?{}:rn({},e,t))}function vd(i,e,t,n){return rn({},e==0?t:n,i)}function iv(i,e,t){return e==null?Uo:[e,t]}var PE=iv;function IE(i,e,t){return e==null?Uo:Oh(e,t,Md,!0)}function sv(i,e,t,n){return e==null?Uo:kh(e,t,i.scales[n].log,!1)}var LE=sv;function rv(i,e,t,n){return e==null?Uo:bd(e,t,i.scales[n].log,!1)}var DE=rv;function UE(i,e,t,n,s){let r=qn(Kg(i),Kg(e)),o=e-i,a=Bi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ys.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function _0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=un((t=+s)*Tt))+"px"),[i,e,t]}function NE(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=zt(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Kt(i,e,t){let n={mode:wt(i.mode,1)},s=n.mode;function r(x,T,U,O){let $=T.valToPct(x);return O+U*(T.dir==-1?1-$:$)}function o(x,T,U,O){let $=T.valToPct(x);return O+U*(T.dir==-1?$:1-$)}function a(x,T,U,O){return T.ori==0?r(x,T,U,O):o(x,T,U,O)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=_i(VS);if(i.id!=null&&(c.id=i.id),ci(c,i.class),i.title){let x=_i(XS,c);x.textContent=i.title}let u=Oi("canvas"),h=n.ctx=u.getContext("2d"),f=_i(qS,c);Ar("click",f,x=>{x.target===g&&(Gt!=Nr||$t!=Fr)&&Mn.click(n,x)},!0);let m=n.under=_i(YS,f);f.appendChild(u);let g=n.over=_i($S,f);i=No(i);let v=+wt(i.pxAlign,1),p=m0(v);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let d=i.ms||.001,b=n.series=s==1?x0(i.series||[],l0,d0,!1):CE(i.series||[null],f0),M=n.axes=x0(i.axes||[],a0,h0,!0),y=n.scales={},P=n.bands=i.bands||[];P.forEach(x=>{x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1)});let E=s==2?b[1].facets[0].scale:b[0].scale,I={axes:px,series:Js},D=(i.drawOrder||["axes","series"]).map(x=>I[x]);function w(x){let T=x.distr==3?U=>bs(U>0?U:x.clamp(n,U,x.min,x.max,x.key)):x.distr==4?U=>sd(U,x.asinh):x.distr==100?U=>x.fwd(U):U=>U;return U=>{let O=T(U),{_min:$,_max:se}=x,de=se-$;return(O-$)/de}}function S(x){let T=y[x];if(T==null){let U=(i.scales||el)[x]||el;if(U.from!=null){S(U.from);let O=rn({},y[U.from],U,{key:x});O.valToPct=w(O),y[x]=O}else{T=y[x]=rn({},x==E?Y0:vE,U),T.key=x;let O=T.time,$=T.range,se=qs($);if((x!=E||s==2&&!O)&&(se&&($[0]==null||$[1]==null)&&($={min:$[0]==null?Yg:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?Yg:{mode:1,hard:$[1],soft:$[1]}},se=!1),!se&&Vh($))){let de=$;$=(Me,Ie,ke)=>Ie==null?Uo:Oh(Ie,ke,de)}T.range=vt($||(O?PE:x==E?T.distr==3?LE:T.distr==4?DE:iv:T.distr==3?sv:T.distr==4?rv:IE)),T.auto=vt(se?!1:T.auto),T.clamp=vt(T.clamp||gE),T._min=T._max=null,T.valToPct=w(T)}}}S("x"),S("y"),s==1&&b.forEach(x=>{S(x.scale)}),M.forEach(x=>{S(x.scale)});for(let x in i.scales)S(x);let A=y[E],k=A.distr,B,V;A.ori==0?(ci(c,GS),B=r,V=o):(ci(c,WS),B=o,V=r);let W={};for(let x in y){let T=y[x];(T.min!=null||T.max!=null)&&(W[x]={min:T.min,max:T.max},T.min=T.max=null)}let q=i.tzDate||(x=>new Date(un(x/d))),N=i.fmtDate||Ed,z=d==1?G1(q):q1(q),K=s0(q,i0(d==1?V1:X1,N)),ne=o0(q,r0($1,N)),te=[],le=n.legend=rn({},J1,i.legend),fe=n.cursor=rn({},iE,{drag:{y:s==2}},i.cursor),ye=le.show,_e=fe.show,ee=le.markers;le.idxs=te,ee.width=vt(ee.width),ee.dash=vt(ee.dash),ee.stroke=vt(ee.stroke),ee.fill=vt(ee.fill);let Y,pe,xe,we=[],Ve=[],dt,H=!1,ht={};if(le.live){let x=b[1]?b[1].values:null;H=x!=null,dt=H?x(n,1,0):{_:0};for(let T in dt)ht[T]=_d}if(ye)if(Y=Oi("table",e1,c),xe=Oi("tbody",null,Y),le.mount(n,Y),H){pe=Oi("thead",null,Y,xe);let x=Oi("tr",null,pe);Oi("th",null,x);for(var oe in dt)Oi("th",Ug,x).textContent=oe}else ci(Y,n1),le.live&&ci(Y,t1);let be={show:!0},Ce={show:!1};function ot(x,T){if(T==0&&(H||!le.live||s==2))return Uo;let U=[],O=Oi("tr",i1,xe,xe.childNodes[T]);ci(O,x.class),x.show||ci(O,Tr);let $=Oi("th",null,O);if(ee.show){let Me=_i(s1,$);if(T>0){let Ie=ee.width(n,T);Ie&&(Me.style.border=Ie+"px "+ee.dash(n,T)+" "+ee.stroke(n,T)),Me.style.background=ee.fill(n,T)}}let se=_i(Ug,$);x.label instanceof HTMLElement?se.appendChild(x.label):se.textContent=x.label,T>0&&(ee.show||(se.style.color=x.width>0?ee.stroke(n,T):ee.fill(n,T)),Le("click",$,Me=>{if(fe._lock)return;bn(Me);let Ie=b.indexOf(x);if((Me.ctrlKey||Me.metaKey)!=le.isolate){let ke=b.some((He,Xe)=>Xe>0&&Xe!=Ie&&He.show);b.forEach((He,Xe)=>{Xe>0&&Gi(Xe,ke?Xe==Ie?be:Ce:be,!0,tn.setSeries)})}else Gi(Ie,{show:!x.show},!0,tn.setSeries)},!1),Yn&&Le(Bg,$,Me=>{fe._lock||(bn(Me),Gi(b.indexOf(x),Br,!0,tn.setSeries))},!1));for(var de in dt){let Me=Oi("td",r1,O);Me.textContent="--",U.push(Me)}return[O,U]}let ae=new Map;function Le(x,T,U,O=!0){let $=ae.get(T)||{},se=fe.bind[x](n,T,U,O);se&&(Ar(x,T,$[x]=se),ae.set(T,$))}function ce(x,T,U){let O=ae.get(T)||{};for(let $ in O)(x==null||$==x)&&(ud($,T,O[$]),delete O[$]);x==null&&ae.delete(T)}let ue=0,C=0,_=0,F=0,J=0,j=0,ie=J,Pe=j,ge=_,Oe=F,De=0,ve=0,Re=0,qe=0;n.bbox={};let Ye=!1,Ue=!1,tt=!1,X=!1,Ee=!1,Ae=!1;function Ge(x,T,U){(U||x!=n.width||T!=n.height)&&Se(x,T),Ir(!1),tt=!0,Ue=!0,Lr()}function Se(x,T){n.width=ue=_=x,n.height=C=F=T,J=j=0,Lt(),yt();let U=n.bbox;De=U.left=Sr(J*Tt,.5),ve=U.top=Sr(j*Tt,.5),Re=U.width=Sr(_*Tt,.5),qe=U.height=Sr(F*Tt,.5)}let me=3;function $e(){let x=!1,T=0;for(;!x;){T++;let U=fx(T),O=dx(T);x=T==me||U&&O,x||(Se(n.width,n.height),Ue=!0)}}function st({width:x,height:T}){Ge(x,T)}n.setSize=st;function Lt(){let x=!1,T=!1,U=!1,O=!1;M.forEach(($,se)=>{if($.show&&$._show){let{side:de,_size:Me}=$,Ie=de%2,ke=$.label!=null?$.labelSize:0,He=Me+ke;He>0&&(Ie?(_-=He,de==3?(J+=He,O=!0):U=!0):(F-=He,de==0?(j+=He,x=!0):T=!0))}}),os[0]=x,os[1]=U,os[2]=T,os[3]=O,_-=Vi[1]+Vi[3],J+=Vi[3],F-=Vi[2]+Vi[0],j+=Vi[0]}function yt(){let x=J+_,T=j+F,U=J,O=j;function $(se,de){switch(se){case 1:return x+=de,x-de;case 2:return T+=de,T-de;case 3:return U-=de,U+de;case 0:return O-=de,O+de}}M.forEach((se,de)=>{if(se.show&&se._show){let Me=se.side;se._pos=$(Me,se._size),se.label!=null&&(se._lpos=$(Me,se.labelSize))}})}if(fe.dataIdx==null){let x=fe.hover,T=x.skip=new Set(x.skip??[]);T.add(void 0);let U=x.prox=vt(x.prox),O=x.bias??(x.bias=0);fe.dataIdx=($,se,de,Me)=>{if(se==0)return de;let Ie=de,ke=U($,se,de,Me)??Bt,He=ke>=0&&ke<Bt,Xe=A.ori==0?_:F,rt=fe.left,St=e[0],Mt=e[se];if(T.has(Mt[de])){Ie=null;let pt=null,nt=null,Ke;if(O==0||O==-1)for(Ke=de;pt==null&&Ke-- >0;)T.has(Mt[Ke])||(pt=Ke);if(O==0||O==1)for(Ke=de;nt==null&&Ke++<Mt.length;)T.has(Mt[Ke])||(nt=Ke);if(pt!=null||nt!=null)if(He){let Xt=pt==null?-1/0:B(St[pt],A,Xe,0),jt=nt==null?1/0:B(St[nt],A,Xe,0),_n=rt-Xt,Dt=jt-rt;_n<=Dt?_n<=ke&&(Ie=pt):Dt<=ke&&(Ie=nt)}else Ie=nt==null?pt:pt==null?nt:de-pt<=nt-de?pt:nt}else He&&fn(rt-B(St[de],A,Xe,0))>ke&&(Ie=null);return Ie}}let bn=x=>{fe.event=x};fe.idxs=te,fe._lock=!1;let Ft=fe.points;Ft.show=vt(Ft.show),Ft.size=vt(Ft.size),Ft.stroke=vt(Ft.stroke),Ft.width=vt(Ft.width),Ft.fill=vt(Ft.fill);let ei=n.focus=rn({},i.focus||{alpha:.3},fe.focus),Yn=ei.prox>=0,Hi=Yn&&Ft.one,Fn=[],rs=[],bi=[];function Go(x,T){let U=Ft.show(n,T);if(U instanceof HTMLElement)return ci(U,QS),ci(U,x.class),ts(U,-10,-10,_,F),g.insertBefore(U,Fn[T]),U}function Zs(x,T){if(s==1||T>0){let U=s==1&&y[x.scale].time,O=x.value;x.value=U?Qg(O)?o0(q,r0(O,N)):O||ne:O||dE,x.label=x.label||(U?rE:sE)}if(Hi||T>0){x.width=x.width==null?1:x.width,x.paths=x.paths||AE||v1,x.fillTo=vt(x.fillTo||xE),x.pxAlign=+wt(x.pxAlign,v),x.pxRound=m0(x.pxAlign),x.stroke=vt(x.stroke||null),x.fill=vt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let U=pE(qn(1,x.width),1),O=x.points=rn({},{size:U,width:qn(1,U*.2),stroke:x.stroke,space:U*2,paths:RE,_stroke:null,_fill:null},x.points);O.show=vt(O.show),O.filter=vt(O.filter),O.fill=vt(O.fill),O.stroke=vt(O.stroke),O.paths=vt(O.paths),O.pxAlign=x.pxAlign}if(ye){let U=ot(x,T);we.splice(T,0,U[0]),Ve.splice(T,0,U[1]),le.values.push(null)}if(_e){te.splice(T,0,null);let U=null;Hi?T==0&&(U=Go(x,T)):T>0&&(U=Go(x,T)),Fn.splice(T,0,U),rs.splice(T,0,0),bi.splice(T,0,0)}xn("addSeries",T)}function ul(x,T){T=T??b.length,x=s==1?vd(x,T,l0,d0):vd(x,T,{},f0),b.splice(T,0,x),Zs(b[T],T)}n.addSeries=ul;function fl(x){if(b.splice(x,1),ye){le.values.splice(x,1),Ve.splice(x,1);let T=we.splice(x,1)[0];ce(null,T.firstChild),T.remove()}_e&&(te.splice(x,1),Fn.splice(x,1)[0].remove(),rs.splice(x,1),bi.splice(x,1)),xn("delSeries",x)}n.delSeries=fl;let os=[!1,!1,!1,!1];function lu(x,T){if(x._show=x.show,x.show){let U=x.side%2,O=y[x.scale];O==null&&(x.scale=U?b[1].scale:E,O=y[x.scale]);let $=O.time;x.size=vt(x.size),x.space=vt(x.space),x.rotate=vt(x.rotate),qs(x.incrs)&&x.incrs.forEach(de=>{!Ys.has(de)&&Ys.set(de,R0(de))}),x.incrs=vt(x.incrs||(O.distr==2?z1:$?d==1?H1:W1:Er)),x.splits=vt(x.splits||($&&O.distr==1?z:O.distr==3?dd:O.distr==4?lE:aE)),x.stroke=vt(x.stroke),x.grid.stroke=vt(x.grid.stroke),x.ticks.stroke=vt(x.ticks.stroke),x.border.stroke=vt(x.border.stroke);let se=x.values;x.values=qs(se)&&!qs(se[0])?vt(se):$?qs(se)?s0(q,i0(se,N)):Qg(se)?Y1(q,se):se||K:se||oE,x.filter=vt(x.filter||(O.distr>=3&&O.log==10?uE:O.distr==3&&O.log==2?fE:T0)),x.font=_0(x.font),x.labelFont=_0(x.labelFont),x._size=x.size(n,null,T,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(os[T]=!0,x._el=_i(ZS,f))}}function Ks(x,T,U,O){let[$,se,de,Me]=U,Ie=T%2,ke=0;return Ie==0&&(Me||se)&&(ke=T==0&&!$||T==2&&!de?un(a0.size/3):0),Ie==1&&($||de)&&(ke=T==1&&!se||T==3&&!Me?un(h0.size/2):0),ke}let dl=n.padding=(i.padding||[Ks,Ks,Ks,Ks]).map(x=>vt(wt(x,Ks))),Vi=n._padding=dl.map((x,T)=>x(n,T,os,0)),on,R=null,Z=null,he=s==1?b[0].idxs:null,re=null,Q=!1;function Te(x,T){if(e=x??[],n.data=n._data=e,s==2){on=0;for(let U=1;U<b.length;U++)on+=e[U][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),re=e[0],on=re.length;let U=e;if(k==2){U=e.slice();let O=U[0]=Array(on);for(let $=0;$<on;$++)O[$]=$}n._data=e=U}if(Ir(!0),xn("setData"),k==2&&(tt=!0),T!==!1){let U=A;U.auto(n,Q)?Fe():Ts(E,U.min,U.max),X=X||fe.left>=0,Ae=!0,Lr()}}n.setData=Te;function Fe(){Q=!0;let x,T;s==1&&(on>0?(R=he[0]=0,Z=he[1]=on-1,x=e[0][R],T=e[0][Z],k==2?(x=R,T=Z):x==T&&(k==3?[x,T]=kh(x,x,A.log,!1):k==4?[x,T]=bd(x,x,A.log,!1):A.time?T=x+un(86400/d):[x,T]=Oh(x,T,Md,!0))):(R=he[0]=x=null,Z=he[1]=T=null)),Ts(E,x,T)}let We,ze,Qe,et,Ze,ut,bt,kt,Rt,lt;function je(x,T,U,O,$,se){x??(x=Fg),U??(U=Sd),O??(O="butt"),$??($=Fg),se??(se="round"),x!=We&&(h.strokeStyle=We=x),$!=ze&&(h.fillStyle=ze=$),T!=Qe&&(h.lineWidth=Qe=T),se!=Ze&&(h.lineJoin=Ze=se),O!=ut&&(h.lineCap=ut=O),U!=et&&h.setLineDash(et=U)}function Ht(x,T,U,O){T!=ze&&(h.fillStyle=ze=T),x!=bt&&(h.font=bt=x),U!=kt&&(h.textAlign=kt=U),O!=Rt&&(h.textBaseline=Rt=O)}function gt(x,T,U,O,$=0){if(O.length>0&&x.auto(n,Q)&&(T==null||T.min==null)){let se=wt(R,0),de=wt(Z,O.length-1),Me=U.min==null?u1(O,se,de,$,x.distr==3):[U.min,U.max];x.min=zi(x.min,U.min=Me[0]),x.max=qn(x.max,U.max=Me[1])}}let Rn={min:null,max:null};function ws(){for(let O in y){let $=y[O];W[O]==null&&($.min==null||W[E]!=null&&$.auto(n,Q))&&(W[O]=Rn)}for(let O in y){let $=y[O];W[O]==null&&$.from!=null&&W[$.from]!=null&&(W[O]=Rn)}W[E]!=null&&Ir(!0);let x={};for(let O in W){let $=W[O];if($!=null){let se=x[O]=No(y[O],y1);if($.min!=null)rn(se,$);else if(O!=E||s==2)if(on==0&&se.from==null){let de=se.range(n,null,null,O);se.min=de[0],se.max=de[1]}else se.min=Bt,se.max=-Bt}}if(on>0){b.forEach((O,$)=>{if(s==1){let se=O.scale,de=W[se];if(de==null)return;let Me=x[se];if($==0){let Ie=Me.range(n,Me.min,Me.max,se);Me.min=Ie[0],Me.max=Ie[1],R=Bi(Me.min,e[0]),Z=Bi(Me.max,e[0]),Z-R>1&&(e[0][R]<Me.min&&R++,e[0][Z]>Me.max&&Z--),O.min=re[R],O.max=re[Z]}else O.show&&O.auto&&gt(Me,de,O,e[$],O.sorted);O.idxs[0]=R,O.idxs[1]=Z}else if($>0&&O.show&&O.auto){let[se,de]=O.facets,Me=se.scale,Ie=de.scale,[ke,He]=e[$],Xe=x[Me],rt=x[Ie];Xe!=null&&gt(Xe,W[Me],se,ke,se.sorted),rt!=null&&gt(rt,W[Ie],de,He,de.sorted),O.min=de.min,O.max=de.max}});for(let O in x){let $=x[O],se=W[O];if($.from==null&&(se==null||se.min==null)){let de=$.range(n,$.min==Bt?null:$.min,$.max==-Bt?null:$.max,O);$.min=de[0],$.max=de[1]}}}for(let O in x){let $=x[O];if($.from!=null){let se=x[$.from];if(se.min==null)$.min=$.max=null;else{let de=$.range(n,se.min,se.max,O);$.min=de[0],$.max=de[1]}}}let T={},U=!1;for(let O in x){let $=x[O],se=y[O];if(se.min!=$.min||se.max!=$.max){se.min=$.min,se.max=$.max;let de=se.distr;se._min=de==3?bs(se.min):de==4?sd(se.min,se.asinh):de==100?se.fwd(se.min):se.min,se._max=de==3?bs(se.max):de==4?sd(se.max,se.asinh):de==100?se.fwd(se.max):se.max,T[O]=U=!0}}if(U){b.forEach((O,$)=>{s==2?$>0&&T.y&&(O._paths=null):T[O.scale]&&(O._paths=null)});for(let O in T)tt=!0,xn("setScale",O);_e&&fe.left>=0&&(X=Ae=!0)}for(let O in W)W[O]=null}function On(x){let T=fd(R-1,0,on-1),U=fd(Z+1,0,on-1);for(;x[T]==null&&T>0;)T--;for(;x[U]==null&&U<on-1;)U++;return[T,U]}function Js(){if(on>0){let x=b.some(T=>T._focus)&&lt!=ei.alpha;x&&(h.globalAlpha=lt=ei.alpha),b.forEach((T,U)=>{if(U>0&&T.show&&(Vt(U,!1),Vt(U,!0),T._paths==null)){let O=lt;lt!=T.alpha&&(h.globalAlpha=lt=T.alpha);let $=s==2?[0,e[U][0].length-1]:On(e[U]);T._paths=T.paths(n,U,$[0],$[1]),lt!=O&&(h.globalAlpha=lt=O)}}),b.forEach((T,U)=>{if(U>0&&T.show){let O=lt;lt!=T.alpha&&(h.globalAlpha=lt=T.alpha),T._paths!=null&&Bn(U,!1);{let $=T._paths!=null?T._paths.gaps:null,se=T.points.show(n,U,R,Z,$),de=T.points.filter(n,U,se,$);(se||de)&&(T.points._paths=T.points.paths(n,U,R,Z,de),Bn(U,!0))}lt!=O&&(h.globalAlpha=lt=O),xn("drawSeries",U)}}),x&&(h.globalAlpha=lt=1)}}function Vt(x,T){let U=T?b[x].points:b[x];U._stroke=U.stroke(n,x),U._fill=U.fill(n,x)}function Bn(x,T){let U=T?b[x].points:b[x],{stroke:O,fill:$,clip:se,flags:de,_stroke:Me=U._stroke,_fill:Ie=U._fill,_width:ke=U.width}=U._paths;ke=zt(ke*Tt,3);let He=null,Xe=ke%2/2;T&&Ie==null&&(Ie=ke>0?"#fff":Me);let rt=U.pxAlign==1&&Xe>0;if(rt&&h.translate(Xe,Xe),!T){let St=De-ke/2,Mt=ve-ke/2,pt=Re+ke,nt=qe+ke;He=new Path2D,He.rect(St,Mt,pt,nt)}T?mn(Me,ke,U.dash,U.cap,Ie,O,$,de,se):$n(x,Me,ke,U.dash,U.cap,Ie,O,$,de,He,se),rt&&h.translate(-Xe,-Xe)}function $n(x,T,U,O,$,se,de,Me,Ie,ke,He){let Xe=!1;Ie!=0&&P.forEach((rt,St)=>{if(rt.series[0]==x){let Mt=b[rt.series[1]],pt=e[rt.series[1]],nt=(Mt._paths||el).band;qs(nt)&&(nt=rt.dir==1?nt[0]:nt[1]);let Ke,Xt=null;Mt.show&&nt&&d1(pt,R,Z)?(Xt=rt.fill(n,St)||se,Ke=Mt._paths.clip):nt=null,mn(T,U,O,$,Xt,de,Me,Ie,ke,He,Ke,nt),Xe=!0}}),Xe||mn(T,U,O,$,se,de,Me,Ie,ke,He)}let pn=Fo|md;function mn(x,T,U,O,$,se,de,Me,Ie,ke,He,Xe){je(x,T,U,O,$),(Ie||ke||Xe)&&(h.save(),Ie&&h.clip(Ie),ke&&h.clip(ke)),Xe?(Me&pn)==pn?(h.clip(Xe),He&&h.clip(He),fi($,de),Ss(x,se,T)):Me&md?(fi($,de),h.clip(Xe),Ss(x,se,T)):Me&Fo&&(h.save(),h.clip(Xe),He&&h.clip(He),fi($,de),h.restore(),Ss(x,se,T)):(fi($,de),Ss(x,se,T)),(Ie||ke||Xe)&&h.restore()}function Ss(x,T,U){U>0&&(T instanceof Map?T.forEach((O,$)=>{h.strokeStyle=We=$,h.stroke(O)}):T!=null&&x&&h.stroke(T))}function fi(x,T){T instanceof Map?T.forEach((U,O)=>{h.fillStyle=ze=O,h.fill(U)}):T!=null&&x&&h.fill(T)}function ux(x,T,U,O){let $=M[x],se;if(O<=0)se=[0,0];else{let de=$._space=$.space(n,x,T,U,O),Me=$._incrs=$.incrs(n,x,T,U,O,de);se=UE(T,U,Me,O,de)}return $._found=se}function cu(x,T,U,O,$,se,de,Me,Ie,ke){let He=de%2/2;v==1&&h.translate(He,He),je(Me,de,Ie,ke,Me),h.beginPath();let Xe,rt,St,Mt,pt=$+(O==0||O==3?-se:se);U==0?(rt=$,Mt=pt):(Xe=$,St=pt);for(let nt=0;nt<x.length;nt++)T[nt]!=null&&(U==0?Xe=St=x[nt]:rt=Mt=x[nt],h.moveTo(Xe,rt),h.lineTo(St,Mt));h.stroke(),v==1&&h.translate(-He,-He)}function fx(x){let T=!0;return M.forEach((U,O)=>{if(!U.show)return;let $=y[U.scale];if($.min==null){U._show&&(T=!1,U._show=!1,Ir(!1));return}else U._show||(T=!1,U._show=!0,Ir(!1));let se=U.side,de=se%2,{min:Me,max:Ie}=$,[ke,He]=ux(O,Me,Ie,de==0?_:F);if(He==0)return;let Xe=$.distr==2,rt=U._splits=U.splits(n,O,Me,Ie,ke,He,Xe),St=$.distr==2?rt.map(Ke=>re[Ke]):rt,Mt=$.distr==2?re[rt[1]]-re[rt[0]]:ke,pt=U._values=U.values(n,U.filter(n,St,O,He,Mt),O,He,Mt);U._rotate=se==2?U.rotate(n,pt,O,He):0;let nt=U._size;U._size=yi(U.size(n,pt,O,x)),nt!=null&&U._size!=nt&&(T=!1)}),T}function dx(x){let T=!0;return dl.forEach((U,O)=>{let $=U(n,O,os,x);$!=Vi[O]&&(T=!1),Vi[O]=$}),T}function px(){for(let x=0;x<M.length;x++){let T=M[x];if(!T.show||!T._show)continue;let U=T.side,O=U%2,$,se,de=T.stroke(n,x),Me=U==0||U==3?-1:1,[Ie,ke]=T._found;if(T.label!=null){let kn=T.labelGap*Me,ii=un((T._lpos+kn)*Tt);Ht(T.labelFont[0],de,"center",U==2?"top":Ng),h.save(),O==1?($=se=0,h.translate(ii,un(ve+qe/2)),h.rotate((U==3?-Nh:Nh)/2)):($=un(De+Re/2),se=ii);let er=S0(T.label)?T.label(n,x,Ie,ke):T.label;h.fillText(er,$,se),h.restore()}if(ke==0)continue;let He=y[T.scale],Xe=O==0?Re:qe,rt=O==0?De:ve,St=T._splits,Mt=He.distr==2?St.map(kn=>re[kn]):St,pt=He.distr==2?re[St[1]]-re[St[0]]:Ie,nt=T.ticks,Ke=T.border,Xt=nt.show?nt.size:0,jt=un(Xt*Tt),_n=un((T.alignTo==2?T._size-Xt-T.gap:T.gap)*Tt),Dt=T._rotate*-Nh/180,Qt=p(T._pos*Tt),ti=(jt+_n)*Me,zn=Qt+ti;se=O==0?zn:0,$=O==1?zn:0;let di=T.font[0],Mi=T.align==1?Po:T.align==2?td:Dt>0?Po:Dt<0?td:O==0?"center":U==3?td:Po,Xi=Dt||O==1?"middle":U==2?"top":Ng;Ht(di,de,Mi,Xi);let ni=T.font[1]*T.lineGap,pi=St.map(kn=>p(a(kn,He,Xe,rt))),wi=T._values;for(let kn=0;kn<wi.length;kn++){let ii=wi[kn];if(ii!=null){O==0?$=pi[kn]:se=pi[kn],ii=""+ii;let er=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let Hn=0;Hn<er.length;Hn++){let up=er[Hn];Dt?(h.save(),h.translate($,se+Hn*ni),h.rotate(Dt),h.fillText(up,0,0),h.restore()):h.fillText(up,$,se+Hn*ni)}}}nt.show&&cu(pi,nt.filter(n,Mt,x,ke,pt),O,U,Qt,jt,zt(nt.width*Tt,3),nt.stroke(n,x),nt.dash,nt.cap);let qi=T.grid;qi.show&&cu(pi,qi.filter(n,Mt,x,ke,pt),O,O==0?2:1,O==0?ve:De,O==0?qe:Re,zt(qi.width*Tt,3),qi.stroke(n,x),qi.dash,qi.cap),Ke.show&&cu([Qt],[1],O==0?1:0,O==0?1:2,O==1?ve:De,O==1?qe:Re,zt(Ke.width*Tt,3),Ke.stroke(n,x),Ke.dash,Ke.cap)}xn("drawAxes")}function Ir(x){b.forEach((T,U)=>{U>0&&(T._paths=null,x&&(s==1?(T.min=null,T.max=null):T.facets.forEach(O=>{O.min=null,O.max=null})))})}let pl=!1,hu=!1,Wo=[];function mx(){hu=!1;for(let x=0;x<Wo.length;x++)xn(...Wo[x]);Wo.length=0}function Lr(){pl||(A1(Yd),pl=!0)}function gx(x,T=!1){pl=!0,hu=T,x(n),Yd(),T&&Wo.length>0&&queueMicrotask(mx)}n.batch=gx;function Yd(){if(Ye&&(ws(),Ye=!1),tt&&($e(),tt=!1),Ue){if(Yt(m,Po,J),Yt(m,"top",j),Yt(m,Ka,_),Yt(m,Ja,F),Yt(g,Po,J),Yt(g,"top",j),Yt(g,Ka,_),Yt(g,Ja,F),Yt(f,Ka,ue),Yt(f,Ja,C),u.width=un(ue*Tt),u.height=un(C*Tt),M.forEach(({_el:x,_show:T,_size:U,_pos:O,side:$})=>{if(x!=null)if(T){let se=$===3||$===0?U:0,de=$%2==1;Yt(x,de?"left":"top",O-se),Yt(x,de?"width":"height",U),Yt(x,de?"top":"left",de?j:J),Yt(x,de?"height":"width",de?F:_),hd(x,Tr)}else ci(x,Tr)}),We=ze=Qe=Ze=ut=bt=kt=Rt=et=null,lt=1,Yo(!0),J!=ie||j!=Pe||_!=ge||F!=Oe){Ir(!1);let x=_/ge,T=F/Oe;if(_e&&!X&&fe.left>=0){fe.left*=x,fe.top*=T,Dr&&ts(Dr,un(fe.left),0,_,F),Ur&&ts(Ur,0,un(fe.top),_,F);for(let U=0;U<Fn.length;U++){let O=Fn[U];O!=null&&(rs[U]*=x,bi[U]*=T,ts(O,yi(rs[U]),yi(bi[U]),_,F))}}if(Wt.show&&!Ee&&Wt.left>=0&&Wt.width>0){Wt.left*=x,Wt.width*=x,Wt.top*=T,Wt.height*=T;for(let U in gu)Yt(Or,U,Wt[U])}ie=J,Pe=j,ge=_,Oe=F}xn("setSize"),Ue=!1}ue>0&&C>0&&(h.clearRect(0,0,u.width,u.height),xn("drawClear"),D.forEach(x=>x()),xn("draw")),Wt.show&&Ee&&(ml(Wt),Ee=!1),_e&&X&&(Qs(null,!0,!1),X=!1),le.show&&le.live&&Ae&&(pu(),Ae=!1),l||(l=!0,n.status=1,xn("ready")),Q=!1,pl=!1}n.redraw=(x,T)=>{tt=T||!1,x!==!1?Ts(E,A.min,A.max):Lr()};function uu(x,T){let U=y[x];if(U.from==null){if(on==0){let O=U.range(n,T.min,T.max,x);T.min=O[0],T.max=O[1]}if(T.min>T.max){let O=T.min;T.min=T.max,T.max=O}if(on>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;x==E&&U.distr==2&&on>0&&(T.min=Bi(T.min,e[0]),T.max=Bi(T.max,e[0]),T.min==T.max&&T.max++),W[x]=T,Ye=!0,Lr()}}n.setScale=uu;let fu,du,Dr,Ur,$d,Zd,Nr,Fr,Kd,Jd,Gt,$t,Es=!1,Mn=fe.drag,gn=Mn.x,vn=Mn.y;_e&&(fe.x&&(fu=_i(JS,g)),fe.y&&(du=_i(jS,g)),A.ori==0?(Dr=fu,Ur=du):(Dr=du,Ur=fu),Gt=fe.left,$t=fe.top);let Wt=n.select=rn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Or=Wt.show?_i(KS,Wt.over?g:m):null;function ml(x,T){if(Wt.show){for(let U in x)Wt[U]=x[U],U in gu&&Yt(Or,U,x[U]);T!==!1&&xn("setSelect")}}n.setSelect=ml;function vx(x){if(b[x].show)ye&&hd(we[x],Tr);else if(ye&&ci(we[x],Tr),_e){let U=Hi?Fn[0]:Fn[x];U!=null&&ts(U,-10,-10,_,F)}}function Ts(x,T,U){uu(x,{min:T,max:U})}function Gi(x,T,U,O){T.focus!=null&&Mx(x),T.show!=null&&b.forEach(($,se)=>{se>0&&(x==se||x==null)&&($.show=T.show,vx(se),s==2?(Ts($.facets[0].scale,null,null),Ts($.facets[1].scale,null,null)):Ts($.scale,null,null),Lr())}),U!==!1&&xn("setSeries",x,T),O&&$o("setSeries",n,x,T)}n.setSeries=Gi;function xx(x,T){rn(P[x],T)}function _x(x,T){x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1),T=T??P.length,P.splice(T,0,x)}function yx(x){x==null?P.length=0:P.splice(x,1)}n.addBand=_x,n.setBand=xx,n.delBand=yx;function bx(x,T){b[x].alpha=T,_e&&Fn[x]!=null&&(Fn[x].style.opacity=T),ye&&we[x]&&(we[x].style.opacity=T)}let as,As,js,Br={focus:!0};function Mx(x){if(x!=js){let T=x==null,U=ei.alpha!=1;b.forEach((O,$)=>{if(s==1||$>0){let se=T||$==0||$==x;O._focus=T?null:se,U&&bx($,se?1:ei.alpha)}}),js=x,U&&Lr()}}ye&&Yn&&Le(zg,Y,x=>{fe._lock||(bn(x),js!=null&&Gi(null,Br,!0,tn.setSeries))});function Wi(x,T,U){let O=y[T];U&&(x=x/Tt-(O.ori==1?j:J));let $=_;O.ori==1&&($=F,x=$-x),O.dir==-1&&(x=$-x);let se=O._min,de=O._max,Me=x/$,Ie=se+(de-se)*Me,ke=O.distr;return ke==3?Do(10,Ie):ke==4?m1(Ie,O.asinh):ke==100?O.bwd(Ie):Ie}function wx(x,T){let U=Wi(x,E,T);return Bi(U,e[0],R,Z)}n.valToIdx=x=>Bi(x,e[0]),n.posToIdx=wx,n.posToVal=Wi,n.valToPos=(x,T,U)=>y[T].ori==0?r(x,y[T],U?Re:_,U?De:0):o(x,y[T],U?qe:F,U?ve:0),n.setCursor=(x,T,U)=>{Gt=x.left,$t=x.top,Qs(null,T,U)};function jd(x,T){Yt(Or,Po,Wt.left=x),Yt(Or,Ka,Wt.width=T)}function Qd(x,T){Yt(Or,"top",Wt.top=x),Yt(Or,Ja,Wt.height=T)}let Xo=A.ori==0?jd:Qd,qo=A.ori==1?jd:Qd;function Sx(){if(ye&&le.live)for(let x=s==2?1:0;x<b.length;x++){if(x==0&&H)continue;let T=le.values[x],U=0;for(let O in T)Ve[x][U++].firstChild.nodeValue=T[O]}}function pu(x,T){if(x!=null&&(x.idxs?x.idxs.forEach((U,O)=>{te[O]=U}):_1(x.idx)||te.fill(x.idx),le.idx=te[0]),ye&&le.live){for(let U=0;U<b.length;U++)(U>0||s==1&&!H)&&Ex(U,te[U]);Sx()}Ae=!1,T!==!1&&xn("setLegend")}n.setLegend=pu;function Ex(x,T){let U=b[x],O=x==0&&k==2?re:e[x],$;H?$=U.values(n,x,T)??ht:($=U.value(n,T==null?null:O[T],x,T),$=$==null?ht:{_:$}),le.values[x]=$}function Qs(x,T,U){Kd=Gt,Jd=$t,[Gt,$t]=fe.move(n,Gt,$t),fe.left=Gt,fe.top=$t,_e&&(Dr&&ts(Dr,un(Gt),0,_,F),Ur&&ts(Ur,0,un($t),_,F));let O,$=R>Z;as=Bt,As=null;let se=A.ori==0?_:F,de=A.ori==1?_:F;if(Gt<0||on==0||$){O=fe.idx=null;for(let Me=0;Me<b.length;Me++){let Ie=Fn[Me];Ie!=null&&ts(Ie,-10,-10,_,F)}Yn&&Gi(null,Br,!0,x==null&&tn.setSeries),le.live&&(te.fill(O),Ae=!0)}else{let Me,Ie,ke;s==1&&(Me=A.ori==0?Gt:$t,Ie=Wi(Me,E),O=fe.idx=Bi(Ie,e[0],R,Z),ke=B(e[0][O],A,se,0));let He=-10,Xe=-10,rt=0,St=0,Mt=!0,pt="",nt="";for(let Ke=s==2?1:0;Ke<b.length;Ke++){let Xt=b[Ke],jt=te[Ke],_n=jt==null?null:s==1?e[Ke][jt]:e[Ke][1][jt],Dt=fe.dataIdx(n,Ke,O,Ie),Qt=Dt==null?null:s==1?e[Ke][Dt]:e[Ke][1][Dt];if(Ae=Ae||Qt!=_n||Dt!=jt,te[Ke]=Dt,Ke>0&&Xt.show){let ti=Dt==null?-10:Dt==O?ke:B(s==1?e[0][Dt]:e[Ke][0][Dt],A,se,0),zn=Qt==null?-10:V(Qt,s==1?y[Xt.scale]:y[Xt.facets[1].scale],de,0);if(Yn&&Qt!=null){let di=A.ori==1?Gt:$t,Mi=fn(ei.dist(n,Ke,Dt,zn,di));if(Mi<as){let Xi=ei.bias;if(Xi!=0){let ni=Wi(di,Xt.scale),pi=Qt>=0?1:-1,wi=ni>=0?1:-1;wi==pi&&(wi==1?Xi==1?Qt>=ni:Qt<=ni:Xi==1?Qt<=ni:Qt>=ni)&&(as=Mi,As=Ke)}else as=Mi,As=Ke}}if(Ae||Hi){let di,Mi;A.ori==0?(di=ti,Mi=zn):(di=zn,Mi=ti);let Xi,ni,pi,wi,qi,kn,ii=!0,er=Ft.bbox;if(er!=null){ii=!1;let Hn=er(n,Ke);pi=Hn.left,wi=Hn.top,Xi=Hn.width,ni=Hn.height}else pi=di,wi=Mi,Xi=ni=Ft.size(n,Ke);if(kn=Ft.fill(n,Ke),qi=Ft.stroke(n,Ke),Hi)Ke==As&&as<=ei.prox&&(He=pi,Xe=wi,rt=Xi,St=ni,Mt=ii,pt=kn,nt=qi);else{let Hn=Fn[Ke];Hn!=null&&(rs[Ke]=pi,bi[Ke]=wi,qg(Hn,Xi,ni,ii),Wg(Hn,kn,qi),ts(Hn,yi(pi),yi(wi),_,F))}}}}if(Hi){let Ke=ei.prox,Xt=js==null?as<=Ke:as>Ke||As!=js;if(Ae||Xt){let jt=Fn[0];jt!=null&&(rs[0]=He,bi[0]=Xe,qg(jt,rt,St,Mt),Wg(jt,pt,nt),ts(jt,yi(He),yi(Xe),_,F))}}}if(Wt.show&&Es)if(x!=null){let[Me,Ie]=tn.scales,[ke,He]=tn.match,[Xe,rt]=x.cursor.sync.scales,St=x.cursor.drag;if(gn=St._x,vn=St._y,gn||vn){let{left:Mt,top:pt,width:nt,height:Ke}=x.select,Xt=x.scales[Xe].ori,jt=x.posToVal,_n,Dt,Qt,ti,zn,di=Me!=null&&ke(Me,Xe),Mi=Ie!=null&&He(Ie,rt);di&&gn?(Xt==0?(_n=Mt,Dt=nt):(_n=pt,Dt=Ke),Qt=y[Me],ti=B(jt(_n,Xe),Qt,se,0),zn=B(jt(_n+Dt,Xe),Qt,se,0),Xo(zi(ti,zn),fn(zn-ti))):Xo(0,se),Mi&&vn?(Xt==1?(_n=Mt,Dt=nt):(_n=pt,Dt=Ke),Qt=y[Ie],ti=V(jt(_n,rt),Qt,de,0),zn=V(jt(_n+Dt,rt),Qt,de,0),qo(zi(ti,zn),fn(zn-ti))):qo(0,de)}else vu()}else{let Me=fn(Kd-$d),Ie=fn(Jd-Zd);if(A.ori==1){let rt=Me;Me=Ie,Ie=rt}gn=Mn.x&&Me>=Mn.dist,vn=Mn.y&&Ie>=Mn.dist;let ke=Mn.uni;ke!=null?gn&&vn&&(gn=Me>=ke,vn=Ie>=ke,!gn&&!vn&&(Ie>Me?vn=!0:gn=!0)):Mn.x&&Mn.y&&(gn||vn)&&(gn=vn=!0);let He,Xe;gn&&(A.ori==0?(He=Nr,Xe=Gt):(He=Fr,Xe=$t),Xo(zi(He,Xe),fn(Xe-He)),vn||qo(0,de)),vn&&(A.ori==1?(He=Nr,Xe=Gt):(He=Fr,Xe=$t),qo(zi(He,Xe),fn(Xe-He)),gn||Xo(0,se)),!gn&&!vn&&(Xo(0,0),qo(0,0))}if(Mn._x=gn,Mn._y=vn,x==null){if(U){if(hp!=null){let[Me,Ie]=tn.scales;tn.values[0]=Me!=null?Wi(A.ori==0?Gt:$t,Me):null,tn.values[1]=Ie!=null?Wi(A.ori==1?Gt:$t,Ie):null}$o(nd,n,Gt,$t,_,F,O)}if(Yn){let Me=U&&tn.setSeries,Ie=ei.prox;js==null?as<=Ie&&Gi(As,Br,!0,Me):as>Ie?Gi(null,Br,!0,Me):As!=js&&Gi(As,Br,!0,Me)}}Ae&&(le.idx=O,pu()),T!==!1&&xn("setCursor")}let Rs=null;Object.defineProperty(n,"rect",{get(){return Rs==null&&Yo(!1),Rs}});function Yo(x=!1){x?Rs=null:(Rs=g.getBoundingClientRect(),xn("syncRect",Rs))}function ep(x,T,U,O,$,se,de){fe._lock||Es&&x!=null&&x.movementX==0&&x.movementY==0||(mu(x,T,U,O,$,se,de,!1,x!=null),x!=null?Qs(null,!0,!0):Qs(T,!0,!1))}function mu(x,T,U,O,$,se,de,Me,Ie){if(Rs==null&&Yo(!1),bn(x),x!=null)U=x.clientX-Rs.left,O=x.clientY-Rs.top;else{if(U<0||O<0){Gt=-10,$t=-10;return}let[ke,He]=tn.scales,Xe=T.cursor.sync,[rt,St]=Xe.values,[Mt,pt]=Xe.scales,[nt,Ke]=tn.match,Xt=T.axes[0].side%2==1,jt=A.ori==0?_:F,_n=A.ori==1?_:F,Dt=Xt?se:$,Qt=Xt?$:se,ti=Xt?O:U,zn=Xt?U:O;if(Mt!=null?U=nt(ke,Mt)?a(rt,y[ke],jt,0):-10:U=jt*(ti/Dt),pt!=null?O=Ke(He,pt)?a(St,y[He],_n,0):-10:O=_n*(zn/Qt),A.ori==1){let di=U;U=O,O=di}}Ie&&(T==null||T.cursor.event.type==nd)&&((U<=1||U>=_-1)&&(U=Sr(U,_)),(O<=1||O>=F-1)&&(O=Sr(O,F))),Me?($d=U,Zd=O,[Nr,Fr]=fe.move(n,U,O)):(Gt=U,$t=O)}let gu={width:0,height:0,left:0,top:0};function vu(){ml(gu,!1)}let tp,np,ip,sp;function rp(x,T,U,O,$,se,de){Es=!0,gn=vn=Mn._x=Mn._y=!1,mu(x,T,U,O,$,se,de,!0,!1),x!=null&&(Le(id,ld,op,!1),$o(Og,n,Nr,Fr,_,F,null));let{left:Me,top:Ie,width:ke,height:He}=Wt;tp=Me,np=Ie,ip=ke,sp=He}function op(x,T,U,O,$,se,de){Es=Mn._x=Mn._y=!1,mu(x,T,U,O,$,se,de,!1,!0);let{left:Me,top:Ie,width:ke,height:He}=Wt,Xe=ke>0||He>0,rt=tp!=Me||np!=Ie||ip!=ke||sp!=He;if(Xe&&rt&&ml(Wt),Mn.setScale&&Xe&&rt){let St=Me,Mt=ke,pt=Ie,nt=He;if(A.ori==1&&(St=Ie,Mt=He,pt=Me,nt=ke),gn&&Ts(E,Wi(St,E),Wi(St+Mt,E)),vn)for(let Ke in y){let Xt=y[Ke];Ke!=E&&Xt.from==null&&Xt.min!=Bt&&Ts(Ke,Wi(pt+nt,Ke),Wi(pt,Ke))}vu()}else fe.lock&&(fe._lock=!fe._lock,Qs(T,!0,x!=null));x!=null&&(ce(id,ld),$o(id,n,Gt,$t,_,F,null))}function Tx(x,T,U,O,$,se,de){if(fe._lock)return;bn(x);let Me=Es;if(Es){let Ie=!0,ke=!0,He=10,Xe,rt;A.ori==0?(Xe=gn,rt=vn):(Xe=vn,rt=gn),Xe&&rt&&(Ie=Gt<=He||Gt>=_-He,ke=$t<=He||$t>=F-He),Xe&&Ie&&(Gt=Gt<Nr?0:_),rt&&ke&&($t=$t<Fr?0:F),Qs(null,!0,!0),Es=!1}Gt=-10,$t=-10,te.fill(null),Qs(null,!0,!0),Me&&(Es=Me)}function ap(x,T,U,O,$,se,de){fe._lock||(bn(x),Fe(),vu(),x!=null&&$o(kg,n,Gt,$t,_,F,null))}function lp(){M.forEach(NE),Ge(n.width,n.height,!0)}Ar(Fh,Lo,lp);let zr={};zr.mousedown=rp,zr.mousemove=ep,zr.mouseup=op,zr.dblclick=ap,zr.setSeries=(x,T,U,O)=>{let $=tn.match[2];U=$(n,T,U),U!=-1&&Gi(U,O,!0,!1)},_e&&(Le(Og,g,rp),Le(nd,g,ep),Le(Bg,g,x=>{bn(x),Yo(!1)}),Le(zg,g,Tx),Le(kg,g,ap),gd.add(n),n.syncRect=Yo);let gl=n.hooks=i.hooks||{};function xn(x,T,U){hu?Wo.push([x,T,U]):x in gl&&gl[x].forEach(O=>{O.call(null,n,T,U)})}(i.plugins||[]).forEach(x=>{for(let T in x.hooks)gl[T]=(gl[T]||[]).concat(x.hooks[T])});let cp=(x,T,U)=>U,tn=rn({key:null,setSeries:!1,filters:{pub:Jg,sub:Jg},scales:[E,b[1]?b[1].scale:null],match:[jg,jg,cp],values:[null,null]},fe.sync);tn.match.length==2&&tn.match.push(cp),fe.sync=tn;let hp=tn.key,xu=$0(hp);function $o(x,T,U,O,$,se,de){tn.filters.pub(x,T,U,O,$,se,de)&&xu.pub(x,T,U,O,$,se,de)}xu.sub(n);function Ax(x,T,U,O,$,se,de){tn.filters.sub(x,T,U,O,$,se,de)&&zr[x](null,T,U,O,$,se,de)}n.pub=Ax;function Rx(){xu.unsub(n),gd.delete(n),ae.clear(),ud(Fh,Lo,lp),c.remove(),Y?.remove(),xn("destroy")}n.destroy=Rx;function _u(){xn("init",i,e),Te(e||i.data,!1),W[E]?uu(E,W[E]):Fe(),Ee=Wt.show&&(Wt.width>0||Wt.height>0),X=Ae=!0,Ge(i.width,i.height)}return b.forEach(Zs),M.forEach(lu),t?t instanceof HTMLElement?(t.appendChild(c),_u()):t(n,_u):_u(),n}Kt.assign=rn;Kt.fmtNum=wd;Kt.rangeNum=Oh;Kt.rangeLog=kh;Kt.rangeAsinh=bd;Kt.orient=Cr;Kt.pxRatio=Tt;Kt.join=T1;Kt.fmtDate=Ed,Kt.tzDate=O1;Kt.sync=$0;{Kt.addGap=_E,Kt.clipGaps=Gh;let i=Kt.paths={points:ev};i.linear=nv,i.stepped=ME,i.bars=wE,i.spline=EE}var ov=112,FE=18,OE=54,BE=1e-5,av=.1,zE=100,Ld=[1e-6,1e6],Dd=14,cv=i=>{let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)},kE=.005,HE=5;function VE(i,[e,t]){let n=r=>Math.floor(Math.log10(r||1)),s=Math.max(0,Math.min(Math.round(-Math.log10(kE*(t-e||1))),HE-1-n(Math.max(Math.abs(e),Math.abs(t)))));return s>6||Math.abs(i)>=1e6?i===0?"0":i.toExponential(3):i.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1")}function hv(i,{onSeek:e=()=>{},onZoom:t=()=>{},onEdit:n=()=>{},onRemove:s=()=>{}}={}){let r=[],o=[],a=null,l={range:null,heights:{}},c=[],u=0,h=null;i.classList.add("plots");function f(A){a=A&&[...new Map(A.map(k=>[String(k),k])).values()],m(o)}function m(A){o=A,r.forEach(({plot:V})=>V.destroy()),i.replaceChildren();let k=Pn(),B=a??tr(o);r=Pp(o,B).map(V=>{let W=G("div",{class:"plot-keys"}),q=V.curves.map(fe=>{let ye=document.createElementNS("http://www.w3.org/2000/svg","svg");ye.setAttribute("viewBox","0 0 22 6"),ye.setAttribute("aria-hidden","true");let _e=document.createElementNS("http://www.w3.org/2000/svg","line");Object.entries({x1:0,x2:22,y1:3,y2:3,stroke:fe.colour,"stroke-width":2.4,"stroke-dasharray":fe.dash.join(" ")}).forEach(([Y,pe])=>_e.setAttribute(Y,pe)),ye.append(_e);let ee=G("b");return ee.style.setProperty("--colour",fe.colour),W.append(G("span",{class:"plot-key"},ye,G("span",{},fe.name),ee)),ee}),N=V.unit?`${V.name} [${V.unit}]`:V.name,z=B.findIndex(fe=>V.key===(Array.isArray(fe)?fe.join():fe)),K=(fe,ye,_e)=>G("button",{type:"button",class:"small",title:ye,"aria-label":`${ye}: ${N}`,onclick:_e},fe),ne=G("span",{class:"plot-tools"},...V.own?[K("edit","Change the signals",()=>n(z))]:[],K("×","Remove this plot",()=>s(z))),te=G("div",{class:"plot-canvas"});i.append(G("section",{class:"plot"},G("header",{},G("h3",{},N),ne,W),te));let le={panel:V,values:q,canvas:te,marker:G("div",{class:"plot-now"}),cross:G("div",{class:"plot-under",hidden:!0}),flag:G("div",{class:"plot-flag",hidden:!0})};return le.plot=g(le,k),le.plot.over.append(le.marker,le.cross,le.flag),le}),M()}function g({panel:A,canvas:k},B){let V=new Map;for(let Y of A.curves){let pe=V.get(Y.t)??{times:Array.from(Y.t,xe=>xe+Y.flight.shift),curves:[]};V.set(Y.t,{...pe,curves:[...pe.curves,Y]})}let W=[...V.values()],q=W.map(({times:Y,curves:pe})=>[Y,...pe.map(xe=>Array.from(xe.values))]),N=q.length===1?q[0]:Kt.join(q),z=W.flatMap(({curves:Y})=>Y),K={stroke:B.faint,grid:{stroke:B.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ne=GE(o.flatMap(Y=>Y.impacts.map(([pe,xe])=>[pe+Y.shift,xe+Y.shift]))),te=Kt.paths.stepped({align:1}),le=A.words&&((Y,pe)=>pe.map(xe=>A.words[xe]??"")),fe={width:Math.max(k.clientWidth,200),height:ov,padding:[6,20,0,0],legend:{show:!1},scales:{x:{time:!1},y:{range:(Y,pe,xe)=>l.heights[A.key]??WE(pe,xe)}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!0,y:!0,uni:Dd,setScale:!1},bind:{dblclick:()=>()=>d()}},axes:[{...K,size:22,gap:2,space:56,values:(Y,pe)=>pe.map(xe=>qE(xe,pe))},{...K,size:(Y,pe)=>Math.max(OE,7*Math.max(0,...(pe??[]).map(xe=>xe.length))+8),gap:4,space:le?13:FE,values:le||((Y,pe)=>XE(pe))}],series:[{},...z.map(Y=>({stroke:Y.colour,width:1.7,dash:Y.dash,spanGaps:!0,points:{show:!1},...Y.held?{paths:te}:{}}))],hooks:{drawClear:[Y=>{Y.ctx.fillStyle=B.force+"2e";for(let[pe,xe]of ne){let we=Y.valToPos(Math.max(pe,Y.scales.x.min),"x",!0),Ve=Y.valToPos(Math.min(xe,Y.scales.x.max),"x",!0);Ve>we&&Y.ctx.fillRect(we,Y.bbox.top,Math.max(Ve-we,1),Y.bbox.height)}}],setSelect:[Y=>v(Y,A.key)],draw:[Y=>r.filter(pe=>pe.plot===Y).forEach(D)]}},ye=new Kt(fe,N,k),_e=null;ye.over.addEventListener("pointerdown",Y=>_e=[Y.clientX,Y.clientY]),ye.over.addEventListener("pointerup",Y=>{_e&&Math.hypot(Y.clientX-_e[0],Y.clientY-_e[1])<5&&e(ee(Y)),_e=null}),ye.over.addEventListener("pointercancel",()=>_e=null),ye.over.addEventListener("pointermove",Y=>Y.pointerType!=="touch"&&P(ee(Y),ye)),ye.over.addEventListener("pointerleave",()=>P(null));let ee=Y=>ye.posToVal(Y.clientX-ye.over.getBoundingClientRect().left,"x");return ye}function v(A,k){let{left:B,top:V,width:W,height:q}=A.select,N=W>=Dd&&W<A.over.clientWidth-1,z=q>=Dd&&q<A.over.clientHeight-1;if(W+q<=0||!(N||z))return;let K=N?[A.posToVal(B,"x"),A.posToVal(B+W,"x")]:l.range,ne=z?{[k]:[A.posToVal(V+q,"y"),A.posToVal(V,"y")]}:{};A.setSelect({left:0,top:0,width:0,height:0},!1),p({range:K,heights:{...l.heights,...ne}})}function p(A){JSON.stringify(A)===JSON.stringify(l)||!lv(A.range)||(c=[...c,l].slice(-zE),l=A,M(),t())}function d(A,k){p({range:A===void 0?null:[A,k],heights:{}})}function b(){return c.length?(l=c.pop(),M(),t(),!0):!1}function M(){let A=o.length?[Math.min(...o.map(V=>V.begin+V.shift)),Math.max(...o.map(V=>V.end+V.shift))]:[0,1],[k,B]=l.range??A;r.forEach(({plot:V})=>V.setScale("x",{min:k,max:B})),E(u)}function y({plot:A,marker:k,cross:B}){let{min:V,max:W}=A.scales.x;for(let[q,N]of[[k,u],[B,h]])q.hidden=N===null||!(N>=V&&N<=W),q.hidden||(q.style.transform=`translateX(${A.valToPos(N,"x")}px)`)}function P(A,k){h=A;for(let B of r){if(B.flag.hidden=A===null||B.plot!==k,B.flag.hidden)continue;B.flag.textContent=`${A.toFixed(4)} s`;let V=k.valToPos(A,"x");B.flag.classList.toggle("left",V>.7*k.over.clientWidth),B.flag.style.transform=`translateX(${V}px)`}i.classList.toggle("pointing",A!==null),I()}function E(A){u=A,I()}let I=()=>r.forEach(D);function D(A){let{panel:k,plot:B,values:V}=A,W=[B.scales.y.min??0,B.scales.y.max??1];y(A),k.curves.forEach((q,N)=>{let z=jo(q,h??u);V[N].textContent=k.words?.[Math.round(z)]??VE(z,W)})}function w(){r.forEach(({plot:A,canvas:k})=>{let B=k.clientWidth;B&&Math.abs(B-A.width)>1&&A.setSize({width:B,height:ov})}),E(u)}let S=new ResizeObserver(w);return S.observe(i),{replace:m,choose:f,show:E,zoom:d,back:b,resize:w,restore(A){lv(A.range)&&(l=A,M(),t())},get wanted(){return a??tr(o)},get range(){return l.range},get zoomed(){return l},get canGoBack(){return c.length>0},shown:()=>r.map(({panel:A,plot:k,values:B})=>({name:A.name,unit:A.unit,limits:[k.scales.y.min,k.scales.y.max],ticks:[...k.axes[1]._values??[]],values:Object.fromEntries(A.curves.map((V,W)=>[V.name,B[W].textContent]))})),dispose(){S.disconnect(),r.forEach(({plot:A})=>A.destroy()),i.replaceChildren()}}}function lv(i){if(i===null)return!0;let[e,t]=i;return t-e>=Ld[0]&&t-e<=Ld[1]&&Math.abs(e)<=Ld[1]}function GE(i){let e=[];for(let[t,n]of i.sort((s,r)=>s[0]-r[0])){let s=e[e.length-1];s&&t<=s[1]?s[1]=Math.max(s[1],n):e.push([t,n])}return e}function WE(i,e){if(i==null||e==null)return[0,1];let t=Math.max(Math.abs(i),Math.abs(e));if(t===0)return[-.1,1];e-i<BE*t&&([i,e]=[i-av*t,e+av*t]);let n=Math.max(e-i,.001*Math.max(Math.abs(i),Math.abs(e)),1e-6);return[i-.06*n,e+.08*n]}function XE(i){let e=i.length>1?Math.abs(i[1]-i[0]):Math.abs(i[0]),t=Math.floor(Math.log10(e||1)+1e-9),n=Math.max(...i.map(Math.abs));if(t<-6||n>=1e6)return i.map(r=>r===0?"0":r.toExponential(2));let s=Math.max(0,-t);return Math.abs(e*10**s-Math.round(e*10**s))>1e-6&&s++,i.map(r=>r.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1"))}function qE(i,e){let t=0,n=.001*(e.length>1?e[1]-e[0]:1);for(;t<6&&e.some(s=>Math.abs(s-Number(s.toFixed(t)))>n);)t++;return`${i.toFixed(t)} s`}var nl=[1,2,5,10,20,50,100,200],YE=.25,uv=2,fv=i=>!i.arms.some(e=>e.compliant),$E=i=>{if(i>.995)return"real time";let e=1/i;return`1/${e<10?e.toFixed(1).replace(/\.0$/,""):Math.round(e)} of real time`};function Yh({scene:i,plots:e=null,bar:t,readouts:n=null,actions:s={},onRest:r=()=>{}}){let o={t:0,playing:!1,pace:"auto",line:null,flights:[],last:0},a=G("button",{class:"play",type:"button",onclick:()=>o.playing?P():y()}),l=G("button",{type:"button",title:"One instant back (←)","aria-label":"One instant back",onclick:()=>w(-1)},Yi("back")),c=G("button",{type:"button",title:"One instant forward (→)","aria-label":"One instant forward",onclick:()=>w(1)},Yi("forth")),u=G("button",{type:"button",title:"Go to the first touch (T)","aria-label":"Go to the first touch",onclick:S},Yi("touch")),h=G("select",{"aria-label":"Speed",title:"Speed (, and .)",onchange:()=>I(h.value)},G("option",{value:"auto"},"slow at impact"),...nl.map(N=>G("option",{value:String(N)},N===1?"real time":`1/${N}`))),f=G("output",{class:"clock","aria-live":"off"}),m=G("input",{type:"range",min:0,max:1,step:"any",value:0,"aria-label":"Time",oninput:()=>{P(),d(o.line.timeAt(Number(m.value)*o.line.total))}}),g=G("div",{class:"ticks","aria-hidden":"true"}),v=G("div",{class:"track"},g,m),p=G("div",{class:"events"});t.classList.add("player"),t.replaceChildren(G("div",{class:"buttons"},a,l,c,u,h,f),v,p);function d(N){if(!o.line)return;o.t=Math.min(Math.max(N,o.line.begin),o.line.end),i.show(o.t),e?.show(o.t);let z=o.line.watchedAt(o.t)/o.line.total;m.value=z,v.style.setProperty("--share",z),b(),o.playing||r()}function b(){let N=_l(o.flights),z=N===null?"":` · ${o.t>=N?"+":"−"}${Math.abs(1e3*(o.t-N)).toFixed(1)} ms from touch`,K=o.pace==="auto"?o.line.paceAt(o.t):1/Number(o.pace);f.replaceChildren(G("b",{},`${o.t.toFixed(4)} s`),G("span",{},z),G("span",{class:"pace"},$E(K))),m.setAttribute("aria-valuetext",`${o.t.toFixed(3)} s${z}`),n&&V()}function M(N){if(!o.playing)return;let z=Math.min((N-o.last)/1e3,.1);o.last=N;let K=o.line,ne=o.pace==="auto"?K.timeAt(K.watchedAt(o.t)+z):o.t+z/Number(o.pace);d(ne),o.t>=K.end?P():requestAnimationFrame(M)}function y(){!o.line||o.playing||(o.t>=o.line.end-1e-9&&d(o.line.begin),o.playing=!0,o.last=performance.now(),E(),requestAnimationFrame(M))}function P(){o.playing&&setTimeout(r),o.playing=!1,E()}function E(){a.replaceChildren(Yi(o.playing?"pause":"play")),a.setAttribute("aria-label",o.playing?"Pause":"Play"),a.title=o.playing?"Pause (space)":"Play (space)"}function I(N){o.pace=N==="auto"?"auto":String(nl.reduce((z,K)=>Math.abs(K-N)<Math.abs(z-N)?K:z)),h.value=o.pace,b(),r()}function D(N){let z=o.pace==="auto"?N>0?0:1:nl.indexOf(Number(o.pace))+N;I(nl[Math.min(Math.max(z,0),nl.length-1)])}function w(N){P();let z=o.flights[0],K=o.t-z.shift,ne=xl(z.t,K+1e-9),te=z.t[ne]<K-1e-9&&N<0?ne:ne+N;d(z.t[Math.min(Math.max(te,0),z.n-1)]+z.shift)}function S(){P();let N=_l(o.flights);N!==null&&d(N)}function A(){let N=o.line,z=te=>N.watchedAt(te)/N.total;g.replaceChildren(...N.stretches.map(([te,le])=>{let fe=G("span",{class:"slow"});return fe.style.left=`${100*z(te)}%`,fe.style.width=`${100*Math.max(z(le)-z(te),.002)}%`,fe}));let K=o.flights.flatMap(te=>te.events.map(le=>({...le,t:le.t+te.shift,flight:te})));K.sort((te,le)=>te.t-le.t);for(let te of K){let le=G("i",{class:te.kind});le.style.left=`${100*z(te.t)}%`,o.flights.length>1&&(le.style.background=te.flight.colour),g.append(le)}let ne=o.flights.length>1;p.replaceChildren(...K.filter(te=>te.kind!=="end"||!ne).slice(0,60).map(te=>{let le=ne?`${te.flight.label}: ${te.label}`:te.label,fe=G("button",{type:"button",class:`event ${te.kind}`,title:`${te.text}, ${te.t.toFixed(4)} s`,onclick:()=>{P(),d(te.t)}},G("span",{},le),G("small",{},` ${te.t.toFixed(3)} s`));return ne&&fe.style.setProperty("--colour",te.flight.colour),fe}))}let k=[];function B(){if(!n)return;let N=["speed","acceleration","compression, largest","contact force, sum of all contacts","thrust, all rotors"],z=["m/s","m/s²","mm","N","N"],K=o.flights.length>2,ne=G("table",{class:K?"numbers crowded":"numbers"});o.flights.length>1&&ne.append(G("thead",{},G("tr",{},G("th",{},""),...o.flights.map(le=>{let fe=G("th",{scope:"col"},le.label);return fe.style.color=le.colour,fe}),...K?[]:[G("th",{},"")])));let te=G("tbody");k=N.map((le,fe)=>{let ye=o.flights.map(()=>G("td")),_e=G("td",{class:"unit"},fe===uv&&o.flights.every(fv)?"":z[fe]);return te.append(G("tr",{},G("th",{scope:"row"},K?`${le} [${z[fe]}]`:le),...ye,...K?[]:[_e])),ye}),ne.append(te),n.replaceChildren(ne)}function V(){o.flights.forEach((N,z)=>{let K=Jo(N,o.t),ne=_e=>N.series.find(ee=>ee.panel===_e),te=_e=>ne(_e)?jo({flight:N,values:ne(_e).values},o.t):0,le=Math.max(0,...N.arms.map((_e,ee)=>_e.compliant?1e3*Pg(_e,K.armLengths[ee],K.bends[ee]):0)),fe=Math.hypot(...[0,1,2].map(_e=>K.contacts.reduce((ee,Y)=>ee+(Y?Y.force[_e]:0),0)));[te("Velocity"),te("Acceleration"),le,fe,K.thrust.reduce((_e,ee)=>_e+ee,0)].forEach((_e,ee)=>k[ee][z].textContent=ee===uv&&fv(N)?"rigid":cv(_e))})}function W(N){if(N.ctrlKey||N.metaKey||N.altKey||N.target.closest?.("dialog"))return;let z=N.target.tagName;if(z==="TEXTAREA"||z==="SELECT"||z==="INPUT"&&N.target.type!=="range"||N.target.type==="range"&&N.target!==m)return;let K=N.shiftKey?10:1,ne={" ":()=>o.playing?P():y(),ArrowRight:()=>w(K),ArrowLeft:()=>w(-K),Home:()=>(P(),d(o.line.begin)),End:()=>(P(),d(o.line.end)),",":()=>D(1),".":()=>D(-1),t:S,...s};if(N.key===" "&&z==="BUTTON")return;let te=ne[N.key];!te||!o.line||te()!==!1&&N.preventDefault()}document.addEventListener("keydown",W);function q({keepTime:N=!0}={}){o.flights=i.flights,o.line=Dg(o.flights),B(),e?.replace(o.flights),A();let z=_l(o.flights);d(N?o.t:z===null?o.line.begin:z-YE)}return E(),{replace:q,seek:d,play:y,pause:P,setPace:I,goToTouch:S,get time(){return o.t},get playing(){return o.playing},get pace(){return o.pace},dispose(){P(),document.removeEventListener("keydown",W),t.replaceChildren()}}}var dv={type:"change"},Nd={type:"start"},mv={type:"end"},$h=new hr,pv=new Zn,ZE=Math.cos(70*Xs.DEG2RAD),dn=new L,Qn=2*Math.PI,Nt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Ud=1e-6,Zh=class extends ka{constructor(e,t=null){super(e,t),this.state=Nt.NONE,this.target=new L,this.cursor=new L,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hs.ROTATE,MIDDLE:Hs.DOLLY,RIGHT:Hs.PAN},this.touches={ONE:Vs.ROTATE,TWO:Vs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new L,this._lastQuaternion=new sn,this._lastTargetPosition=new L,this._quat=new sn().setFromUnitVectors(e.up,new L(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new yo,this._sphericalDelta=new yo,this._scale=1,this._panOffset=new L,this._rotateStart=new Be,this._rotateEnd=new Be,this._rotateDelta=new Be,this._panStart=new Be,this._panEnd=new Be,this._panDelta=new Be,this._dollyStart=new Be,this._dollyEnd=new Be,this._dollyDelta=new Be,this._dollyDirection=new L,this._mouse=new Be,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=JE.bind(this),this._onPointerDown=KE.bind(this),this._onPointerUp=jE.bind(this),this._onContextMenu=rT.bind(this),this._onMouseWheel=tT.bind(this),this._onKeyDown=nT.bind(this),this._onTouchStart=iT.bind(this),this._onTouchMove=sT.bind(this),this._onMouseDown=QE.bind(this),this._onMouseMove=eT.bind(this),this._interceptControlDown=oT.bind(this),this._interceptControlUp=aT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(dv),this.update(),this.state=Nt.NONE}update(e=null){let t=this.object.position;dn.copy(t).sub(this.target),dn.applyQuaternion(this._quat),this._spherical.setFromVector3(dn),this.autoRotate&&this.state===Nt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Qn:n>Math.PI&&(n-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(dn.setFromSpherical(this._spherical),dn.applyQuaternion(this._quatInverse),t.copy(this.target).add(dn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=dn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new L(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new L(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=dn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):($h.origin.copy(this.object.position),$h.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot($h.direction))<ZE?this.object.lookAt(this.target):(pv.setFromNormalAndCoplanarPoint(this.object.up,this.target),$h.intersectPlane(pv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Ud||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Ud||this._lastTargetPosition.distanceToSquared(this.target)>Ud?(this.dispatchEvent(dv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Qn/60*this.autoRotateSpeed*e:Qn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){dn.setFromMatrixColumn(t,0),dn.multiplyScalar(-e),this._panOffset.add(dn)}_panUp(e,t){this.screenSpacePanning===!0?dn.setFromMatrixColumn(t,1):(dn.setFromMatrixColumn(t,0),dn.crossVectors(this.object.up,dn)),dn.multiplyScalar(e),this._panOffset.add(dn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;dn.copy(s).sub(this.target);let r=dn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Be,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function KE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function JE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function jE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(mv),this.state=Nt.NONE;break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function QE(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Hs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Nt.DOLLY;break;case Hs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Nt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Nt.ROTATE}break;case Hs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Nt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Nt.PAN}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(Nd)}function eT(i){switch(this.state){case Nt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Nt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Nt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function tT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Nt.NONE||(i.preventDefault(),this.dispatchEvent(Nd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(mv))}function nT(i){this.enabled!==!1&&this._handleKeyDown(i)}function iT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Vs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Nt.TOUCH_ROTATE;break;case Vs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Nt.TOUCH_PAN;break;default:this.state=Nt.NONE}break;case 2:switch(this.touches.TWO){case Vs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Nt.TOUCH_DOLLY_PAN;break;case Vs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Nt.TOUCH_DOLLY_ROTATE;break;default:this.state=Nt.NONE}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(Nd)}function sT(i){switch(this._trackPointer(i),this.state){case Nt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Nt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Nt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Nt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Nt.NONE}}function rT(i){this.enabled!==!1&&i.preventDefault()}function oT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function aT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var lT=7,cT=.0022,hT=new L(1,0,0);function Fd(i,e=lT,t=cT){class n extends jn{getPoint(r,o=new L){let a=2*Math.PI*e*r;return o.set(r,i*Math.cos(a),i*Math.sin(a))}}return new Ia(new n,e*14,t,5)}function ki(i,e=14){return new wn(i,i,1,e).rotateZ(-Math.PI/2).translate(.5,0,0)}function Kh(i,e){return new Je(new wn(.0155*i,.0155*i,.006*i,20).rotateZ(Math.PI/2),e)}function il(i,e,t){let n=t.clone().sub(e);return i.position.copy(e),i.quaternion.setFromUnitVectors(new L(1,0,0),n.normalize()),i}function gv(i,e){let t=new Ot;t.setAttribute("position",new Jt(Zt(i.vertices),3)),t.setIndex(new Jt(new Uint32Array(Zt(i.triangles)),1));let n=t.toNonIndexed();return n.computeVertexNormals(),new Je(n,e)}var Jh=class{constructor(e,t,n){this.group=new _t;let s=new oi({color:e,depthTest:!1,transparent:!0,opacity:n});this.shaft=new Je(ki(t,10),s),this.head=new Je(new dr(3*t,8*t,14).rotateZ(-Math.PI/2),s),this.size=8*t,this.shaft.renderOrder=this.head.renderOrder=10,this.group.add(this.shaft,this.head),this.along=new L(1,0,0),this.way=new L}show(e,t){let n=this.way.set(...t).length();if(this.group.visible=n>1e-4,!this.group.visible)return;this.group.position.set(...e),this.group.quaternion.setFromUnitVectors(this.along,this.way.divideScalar(n));let s=Math.min(this.size,.6*n);this.head.scale.setScalar(s/this.size),this.head.position.x=n-.5*s,this.shaft.scale.x=Math.max(n-s,1e-5)}hide(){this.group.visible=!1}},en,xv,_v,yv,sl,bv,Mv,wv,Sv,rl=class{constructor(e,t,n){vl(this,en);this.flight=e,this.group=new _t;let s=t.opacity<1,r=(v,p={})=>new Ni({color:v,roughness:.55,metalness:.15,transparent:s,opacity:t.opacity,depthWrite:!s,...p}),o=r(n.metal),a=r(n.dark),l=r(t.colour),c=r(n.force,{metalness:.4,roughness:.35}),u=Math.max(...e.arms.map(v=>v.length)),h=u/.19,f=new Je(new wn(.042*h,.042*h,.026*h,28),a);f.rotation.x=Math.PI/2;let m=new Je(new wn(.032*h,.04*h,.014*h,28),l);m.rotation.x=Math.PI/2,m.position.z=.02*h;let g=new Je(new dr(.012*h,.034*h,16).rotateZ(-Math.PI/2),l);g.position.set(.056*h,0,.004*h),this.group.add(f,m,g),this.hulls=e.hull.map(v=>{let p=r(t.colour,{transparent:!0,opacity:.22*t.opacity,depthWrite:!1});if(v.meshes.length){for(let b of v.meshes)this.group.add(gv(b,p));return p}let d=new Je(new Ca(v.radius,32,20),p);return d.position.set(...v.centre),this.group.add(d),p}),this.arms=e.arms.map(v=>Cn(this,en,xv).call(this,v,{metal:o,dark:a,own:l,spring:c,paint:r,colours:n,unit:h,faded:s,look:t})),this.springs=e.neighbours.map(({first:v,second:p})=>{let d=new Je(Fd(.0075*h,16,.0014*h),c);return this.group.add(d),{coil:d,first:v,second:p,from:new L,to:new L,way:new L}}),this.open=new at(n.force),this.shut=new at(n.dark),this.rotors=e.rotors.map(v=>Cn(this,en,_v).call(this,v,{dark:a,paint:r,colours:n,unit:h,look:t})),this.most=e.max_thrust||1,this.bar=1.2*u}connections(){this.group.updateWorldMatrix(!0,!0);let e=this.group.parent?.position??new L,t=s=>s.getWorldPosition(new L).sub(e).toArray(),n=s=>s.localToWorld(new L(1,0,0)).sub(e).toArray();return{springs:this.springs.map(({coil:s})=>[t(s),n(s)]),latches:this.arms.flatMap(({latches:s})=>s??[]).map(({held:s,moving:r,glow:o})=>({held:t(s),moving:t(r),open:o.color.equals(this.open)}))}}ends(){this.group.updateWorldMatrix(!0,!0);let e=this.group.parent?.position??new L,t=n=>this.rotors[this.flight.rotors.findIndex(s=>s.arm===n)]?.rotor;return this.arms.map(({tip:n},s)=>({centre:n.getWorldPosition(new L).sub(e).toArray(),normal:new L(0,0,1).transformDirection(n.matrixWorld).toArray(),thrust:t(s)?new L(0,0,1).transformDirection(t(s).matrixWorld).toArray():null}))}show(e,t=1){this.group.position.set(...e.position);let[n,s,r,o]=e.quaternion;this.group.quaternion.set(s,r,o,n);let a=new Set(e.contacts.filter(Boolean).map(l=>l.part));this.arms.forEach((l,c)=>{let u=t===1?e.armLengths[c]:l.free-vv(t*(l.free-e.armLengths[c]),l),h=t===1?e.bends[c]??0:vv(t*(e.bends[c]??0),l);l.hung?l.path.at(u,l.end.position,l.end.quaternion,h):l.end.position.x=u,l.middle&&l.path.at(u,l.middle.position,l.middle.quaternion);for(let f of l.latches??[]){let m=f.isSecond?-(e.bends[c]??0):l.free-e.armLengths[c];f.glow.color.copy(m>f.travel?this.open:this.shut)}l.shown=u,l.bend=h,l.coil&&(l.coil.scale.x=Math.max(u-l.collar-l.seat,.004)),l.cagePaint.color.set(a.has(c)?this.flight.glow:this.flight.colour)}),this.rotors.forEach((l,c)=>{l.level&&l.rotor.quaternion.copy(l.level.end.quaternion).invert().multiply(l.aim),l.blades.rotation.z=l.spin*e.own*60;let u=this.bar*e.thrust[c]/this.most;l.thrust.visible=u>.001,l.thrust.scale.z=Math.max(u,.001)});for(let{coil:l,first:c,second:u,from:h,to:f,way:m}of this.springs){for(let[v,p]of[[c,h],[u,f]])this.arms[v].path.at(this.arms[v].shown,p,null,this.arms[v].bend);let g=m.copy(f).sub(h).length();l.position.copy(h),l.quaternion.setFromUnitVectors(hT,m.divideScalar(Math.max(g,1e-6))),l.scale.x=Math.max(g,1e-6)}this.hulls.forEach((l,c)=>{l.color.set(a.has(this.arms.length+c)?this.flight.glow:this.flight.colour)})}};en=new WeakSet,xv=function(e,{metal:t,dark:n,own:s,spring:r,paint:o,colours:a,unit:l,faded:c,look:u}){let h=new _t;this.group.add(h);let f=Math.atan2(e.direction[1],e.direction[0]),m=new _t;h.add(m);let g=new Co(e),v={end:m,frame:h,free:e.length,path:g,hung:e.joint.length>0},p=new _t,d={frame:h,end:m,metal:t,dark:n,own:s,spring:r,unit:l};v.hung?(p.rotation.z=f,e.compliant?g.second?v.middle=Cn(this,en,wv).call(this,g,d):g.isHinge?Cn(this,en,Mv).call(this,g,d):Object.assign(v,Cn(this,en,bv).call(this,e,g,d)):Cn(this,en,sl).call(this,g.start,.007,d),v.latches=e.latch.map(E=>Cn(this,en,Sv).call(this,E,g,{...d,middle:v.middle,paint:o,colours:a}))):(h.rotation.z=f,Object.assign(v,Cn(this,en,yv).call(this,e,d))),m.add(p);let b=o(u.colour,{roughness:.4}),M=new Je(new Pa(e.cage_radius-.0035*l,.0035*l,10,72),b);e.caged&&p.add(M);let y=o(u.colour,{transparent:!0,opacity:.22*u.opacity,depthWrite:!1}),P=new _t;P.rotation.z=-f;for(let E of e.hulls)P.add(gv(E,y));p.add(P);for(let E=0;E<(e.caged?3:0);E++){let I=new Je(ki(.0016*l,6),t);I.rotation.z=2*Math.PI*(E+.5)/3,I.scale.x=e.cage_radius-.004*l,p.add(I)}return Object.assign(v,{cagePaint:b,tip:p,seat:P})},_v=function({arm:e,offset:t,axis:n,level:s,spin:r,radius:o},{dark:a,paint:l,colours:c,unit:u,look:h}){let f=new _t;f.position.set(...t);let m=new sn().setFromUnitVectors(new L(0,0,1),new L(...n));f.quaternion.copy(m),(e<0?this.group:this.arms[e].seat).add(f);let g=new Je(new wn(.013*u,.013*u,.024*u,18).rotateX(Math.PI/2),a);g.position.z=.008*u;let v=new Je(new fr(o,36),l(c.thrust,{transparent:!0,opacity:.16*h.opacity,side:Sn,depthWrite:!1}));v.position.z=.022*u;let p=new Je(new ji(2*o,.012*u,.0015),a);p.position.z=.023*u;let d=new Je(new wn(.006*u,.006*u,1,12).rotateX(Math.PI/2).translate(0,0,.5),l(c.thrust,{transparent:!0,opacity:.8*h.opacity,emissive:c.thrust,emissiveIntensity:.3}));return d.position.z=.024*u,f.add(g,v,p,d),{rotor:f,blades:p,thrust:d,spin:r,aim:m,level:s?this.arms[e]:null}},yv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,spring:a,unit:l}){let c=e.length-e.shortest,u=.13*e.length;if(!e.compliant){let d=new Je(ki(.007*l),s);return d.scale.x=e.length,t.add(d),{}}let h=Math.max(.24*e.length,e.shortest-u-.8*c),f=new Je(ki(.0075*l),s);f.scale.x=e.shortest-.5*u;let m=new Je(ki(.0045*l),o);m.position.x=-(e.length-h)+.3*u,m.scale.x=-m.position.x;let g=Kh(l,r);g.position.x=h;let v=Kh(l,r);v.position.x=-u;let p=new Je(Fd(.0125*l),a);return p.position.x=h,t.add(f,g,p),n.add(m,v),{coil:p,seat:h,collar:u}},sl=function(e,t,{frame:n,metal:s,unit:r}){let o=new Je(ki(t*r),s);o.scale.x=Math.max(e.length(),1e-6),n.add(il(o,new L,e))},bv=function(e,t,{frame:n,end:s,metal:r,dark:o,own:a,spring:l,unit:c}){let u=.13*t.start.length(),h=t.start.distanceTo(t.anchor),f=e.length-e.shortest,m=il(new _t,t.anchor,t.start),g=new Je(ki(.0075*c),r);g.scale.x=Math.max(h-f-.5*u,1e-6);let v=new Je(Fd(.0125*c),l);m.add(g,Kh(c,o),v);let p=new _t;p.quaternion.copy(m.quaternion);let d=new Je(ki(.0045*c),a);d.position.x=-h+.3*u,d.scale.x=-d.position.x;let b=Kh(c,o);return b.position.x=-u,p.add(d,b),n.add(m),s.add(p),Cn(this,en,sl).call(this,t.anchor,.0075,{frame:n,metal:r,unit:c}),{coil:v,seat:e.length-h,collar:u}},Mv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,unit:a}){Cn(this,en,sl).call(this,e.anchor,.0075,{frame:t,metal:s,unit:a});let l=new Je(new wn(.0105*a,.0105*a,.028*a,20),r);l.quaternion.setFromUnitVectors(new L(0,1,0),e.axis.clone().normalize()),l.position.copy(e.anchor),t.add(l);let c=new Je(ki(.006*a),o),u=e.anchor.clone().sub(e.start);c.scale.x=u.length(),n.add(il(c,new L,u))},wv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,unit:a}){let l=new _t;t.add(l);let c=(v,p,d)=>{let b=new Je(new wn(.0105*a,.0105*a,.028*a,20),r);b.quaternion.setFromUnitVectors(new L(0,1,0),v.axis.clone().normalize()),b.position.copy(d),p.add(b)},u=e.second,h=e.isHinge?e.anchor:new L;e.isHinge&&(Cn(this,en,sl).call(this,e.anchor,.0075,{frame:t,metal:s,unit:a}),c(e,t,e.anchor));let f=e.anchor.clone().sub(e.start),m=u.isHinge?u.anchor.clone().sub(e.start):new L;u.isHinge&&c(u,l,m);let g=(v,p,d)=>{let b=new Je(ki(.006*a),o);b.scale.x=Math.max(v.distanceTo(p),1e-6),d.add(il(b,v,p))};return e.isHinge?g(f,m,l):g(h,e.start.clone().add(m),t),u.isHinge&&g(new L,m,n),l},Sv=function(e,t,{frame:n,end:s,middle:r,metal:o,unit:a,paint:l,colours:c}){let u=e.joint===1,h=u?t.second:t,[f,m]=u?[r??n,s]:[n,r??s],g=f===n?new L:t.start,v=new L(...e.face),p=.006*a,d=l(c.dark),b=()=>{let w=(h.isHinge?.011:.019)*a,S=new wn(w,w,p,20);return new Je(S.rotateZ(-Math.PI/2),d)},M=h.along.clone().normalize(),y=new sn().setFromUnitVectors(new L(1,0,0),M),[P,E]=[b(),b()];P.quaternion.copy(y),E.quaternion.copy(y),P.position.copy(v).addScaledVector(M,1.1*p).sub(g),E.position.copy(v).sub(t.start);let I=new Je(ki(.0028*a,8),o),D=h.anchor.clone().addScaledVector(M,h.isHinge?p:0).sub(g);return I.scale.x=Math.max(D.distanceTo(P.position),1e-6),f.add(P,il(I,D,P.position)),m.add(E),{glow:d,held:P,moving:E,travel:e.travel,isSecond:u}};function vv(i,e){let t=.4*e.free;return Math.min(e.hung?Math.max(i,-t):i,t)}function ol(i){i.traverse(e=>{e.geometry?.dispose();for(let t of[e.material].flat())t?.map?.dispose(),t?.dispose?.()}),i.removeFromParent()}var Ev=new an,jh=new L,ko=class extends Oa{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new mt(e,3)),this.setAttribute("uv",new mt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ks(t,6,1);return this.setAttribute("instanceStart",new Jn(n,3,0)),this.setAttribute("instanceEnd",new Jn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ks(t,6,1);return this.setAttribute("instanceColorStart",new Jn(n,3,0)),this.setAttribute("instanceColorEnd",new Jn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new La(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new an);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Ev.setFromBufferAttribute(t),this.boundingBox.union(Ev))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)jh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(jh)),jh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(jh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Ne.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Be(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Xn.line={uniforms:Ya.merge([Ne.common,Ne.fog,Ne.line]),vertexShader:`
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
		`};var $s=class extends ai{constructor(e){super({type:"LineMaterial",uniforms:Ya.clone(Xn.line.uniforms),vertexShader:Xn.line.vertexShader,fragmentShader:Xn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Od=new It,Tv=new L,Av=new L,En=new It,Tn=new It,ns=new It,Bd=new L,zd=new Ut,An=new Ba,Rv=new L,Qh=new an,eu=new Di,is=new It,ss,Pr;function Cv(i,e,t){return is.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),is.multiplyScalar(1/is.w),is.x=Pr/t.width,is.y=Pr/t.height,is.applyMatrix4(i.projectionMatrixInverse),is.multiplyScalar(1/is.w),Math.abs(Math.max(is.x,is.y))}function uT(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){An.start.fromBufferAttribute(s,a),An.end.fromBufferAttribute(r,a),An.applyMatrix4(t);let c=new L,u=new L;ss.distanceSqToSegment(An.start,An.end,u,c),u.distanceTo(c)<Pr*.5&&e.push({point:u,pointOnLine:c,distance:ss.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function fT(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;ss.at(1,ns),ns.w=1,ns.applyMatrix4(e.matrixWorldInverse),ns.applyMatrix4(n),ns.multiplyScalar(1/ns.w),ns.x*=r.x/2,ns.y*=r.y/2,ns.z=0,Bd.copy(ns),zd.multiplyMatrices(e.matrixWorldInverse,o);for(let f=0,m=u;f<m;f++){if(En.fromBufferAttribute(l,f),Tn.fromBufferAttribute(c,f),En.w=1,Tn.w=1,En.applyMatrix4(zd),Tn.applyMatrix4(zd),En.z>h&&Tn.z>h)continue;if(En.z>h){let M=En.z-Tn.z,y=(En.z-h)/M;En.lerp(Tn,y)}else if(Tn.z>h){let M=Tn.z-En.z,y=(Tn.z-h)/M;Tn.lerp(En,y)}En.applyMatrix4(n),Tn.applyMatrix4(n),En.multiplyScalar(1/En.w),Tn.multiplyScalar(1/Tn.w),En.x*=r.x/2,En.y*=r.y/2,Tn.x*=r.x/2,Tn.y*=r.y/2,An.start.copy(En),An.start.z=0,An.end.copy(Tn),An.end.z=0;let v=An.closestPointToPointParameter(Bd,!0);An.at(v,Rv);let p=Xs.lerp(En.z,Tn.z,v),d=p>=-1&&p<=1,b=Bd.distanceTo(Rv)<Pr*.5;if(d&&b){An.start.fromBufferAttribute(l,f),An.end.fromBufferAttribute(c,f),An.start.applyMatrix4(o),An.end.applyMatrix4(o);let M=new L,y=new L;ss.distanceSqToSegment(An.start,An.end,y,M),t.push({point:y,pointOnLine:M,distance:ss.origin.distanceTo(y),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var tu=class extends Je{constructor(e=new ko,t=new $s({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Tv.fromBufferAttribute(t,o),Av.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Tv.distanceTo(Av);let r=new ks(s,2,1);return e.setAttribute("instanceDistanceStart",new Jn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Jn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;ss=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Pr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),eu.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Pr*.5;else{let h=Math.max(s.near,eu.distanceToPoint(ss.origin));c=Cv(s,h,l.resolution)}if(eu.radius+=c,ss.intersectsSphere(eu)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Qh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Pr*.5;else{let h=Math.max(s.near,Qh.distanceToPoint(ss.origin));u=Cv(s,h,l.resolution)}Qh.expandByScalar(u),ss.intersectsBox(Qh)!==!1&&(n?uT(this,t):fT(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Od),this.material.uniforms.resolution.value.set(Od.z,Od.w))}};var Ho=class extends ko{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setPositions(n),this}setColors(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setColors(n),this}setFromPoints(e){let t=e.length-1,n=new Float32Array(6*t);for(let s=0;s<t;s++)n[6*s]=e[s].x,n[6*s+1]=e[s].y,n[6*s+2]=e[s].z||0,n[6*s+3]=e[s+1].x,n[6*s+4]=e[s+1].y,n[6*s+5]=e[s+1].z||0;return super.setPositions(n),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var nu=class extends tu{constructor(e=new Ho,t=new $s({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};function Pv(i,e=Math.PI/3){let t=Math.cos(e),n=(1+1e-10)*100,s=[new L,new L,new L],r=new L,o=new L,a=new L,l=new L;function c(v){let p=~~(v.x*n),d=~~(v.y*n),b=~~(v.z*n);return`${p},${d},${b}`}let u=i.index?i.toNonIndexed():i,h=u.attributes.position,f={};for(let v=0,p=h.count/3;v<p;v++){let d=3*v,b=s[0].fromBufferAttribute(h,d+0),M=s[1].fromBufferAttribute(h,d+1),y=s[2].fromBufferAttribute(h,d+2);r.subVectors(y,M),o.subVectors(b,M);let P=new L().crossVectors(r,o).normalize();for(let E=0;E<3;E++){let I=s[E],D=c(I);D in f||(f[D]=[]),f[D].push(P)}}let m=new Float32Array(h.count*3),g=new Jt(m,3,!1);for(let v=0,p=h.count/3;v<p;v++){let d=3*v,b=s[0].fromBufferAttribute(h,d+0),M=s[1].fromBufferAttribute(h,d+1),y=s[2].fromBufferAttribute(h,d+2);r.subVectors(y,M),o.subVectors(b,M),a.crossVectors(r,o).normalize();for(let P=0;P<3;P++){let E=s[P],I=c(E),D=f[I];l.set(0,0,0);for(let w=0,S=D.length;w<S;w++){let A=D[w];a.dot(A)>t&&l.add(A)}l.normalize(),g.setXYZ(d+P,l.x,l.y,l.z)}}return u.setAttribute("normal",g),u}var dT=.6,pT=25,mT=.02,Iv=.004,Nn=i=>new L(...i);function Dv(i,e,t,n,s,r){let o=[],a=e.length(),l=t.length(),c=e.clone().normalize(),u=t.clone().normalize(),h=(v,p)=>o.push(...v.toArray(),...p.toArray()),f=(v,p)=>i.clone().addScaledVector(c,v).addScaledVector(u,p),m=v=>{let p=[-v,v];for(let d=Math.ceil(-v/n)*n;d<v;d+=n)p.push(d);return p};for(let v of m(a))h(f(v,-l),f(v,l));for(let v of m(l))h(f(-a,v),f(a,v));let g=new Ot;return g.setAttribute("position",new mt(o,3)),new _o(g,new vs({color:s,transparent:!0,opacity:r,depthWrite:!1}))}function iu(i,e,t,n,s=0){let r=Nn(i.across),o=Nn(i.along),a=Nn(i.normal),l=new ji(2*r.length(),2*o.length(),e),c=new Ni({color:t,transparent:!0,opacity:n,roughness:.9,depthWrite:!1,side:Sn}),u=new Je(l,c),h=new Ut().makeBasis(r.normalize(),o.normalize(),a);return u.quaternion.setFromRotationMatrix(h),u.position.copy(Nn(i.centre)).addScaledVector(a,-s-.5*e),u.renderOrder=1,u}function gT(i,e){let t=new Ot;t.setAttribute("position",new Jt(Zt(i.vertices),3)),t.setAttribute("normal",new Jt(Zt(i.normals),3)),t.setIndex(Array.from(Zt(i.triangles)));let n=new Je(t,new oi({colorWrite:!1,transparent:!0,side:Sn})),s=new Je(t,new Ni({color:e,transparent:!0,opacity:.55,roughness:.85,depthWrite:!1,side:Sn}));return[n,s].forEach((r,o)=>r.renderOrder=3+o),new _t().add(n,s)}function vT(i,e,t,n){let s=Uv(i),r=Pv(s,dT),o=n===null?[]:[new Zn(new L(0,0,1),-n)],a=new Je(r,new oi({colorWrite:!1,transparent:!0,clippingPlanes:o})),l=new Je(r,new Ni({color:t,transparent:!0,opacity:.72,roughness:.85,depthWrite:!1,clippingPlanes:o,stencilWrite:!0,stencilRef:1,stencilFunc:wh,stencilZPass:Mh})),c=new _o(new Ea(s,pT),new vs({color:e.ink,transparent:!0,opacity:.35,depthWrite:!1,clippingPlanes:o}));return s.dispose(),[a,l,c].forEach((u,h)=>u.renderOrder=3+h),new _t().add(a,l,c)}function Uv(i){let e=new Ot;return e.setAttribute("position",new Jt(Zt(i.vertices),3)),e.setIndex(Array.from(Zt(i.triangles))),e}var ll=i=>`${i.name||i.kind}${i.kind!=="mesh"||i.track<0?"":", moving"}`,Lv=i=>i.kind==="mesh"?ll(i):i.kind;function Nv(i,e){let n=[...new Set(i.map(Lv))].filter(r=>r!=="mat"&&r!=="ground");n.sort((r,o)=>(o==="wall")-(r==="wall"));let s=r=>n.includes(r)?e.shapes[n.indexOf(r)%e.shapes.length]:e[r];return new Map(i.map(r=>[ll(r),s(Lv(r))]))}function Fv(i,e,t){if(i.kind!=="mesh"||i.normals)return null;let n=Uv(i);if(n.computeBoundingBox(),n.boundingBox.min.z<e-mT&&(t===null||n.boundingBox.max.z<=e))return null;let s=new oi({color:"#000000",transparent:!0,opacity:.14,depthWrite:!1,side:Sn,stencilWrite:!0,stencilRef:2,stencilFunc:wh,stencilZPass:Mh}),r=new Je(n,s);return r.renderOrder=2,r.frustumCulled=!1,r}function Ov(i,e){let t=new _t().add(e);return t.scale.z=0,t.position.z=i+.002,t}function Bv(i,e,t){let n=Fv(i,e,t);return n&&Ov(e,n)}function kd(i,e,t,n=null){let s=new _t,r=t.get(ll(i))??e.wall;if(i.kind==="mesh")return i.normals?s.add(gT(i,r)):vT(i,e,r,n);let o=Nn(i.centre),a=Nn(i.normal).multiplyScalar(.001),l=(c,u,h)=>Dv(o.clone().add(a),Nn(i.across),Nn(i.along),h,u,c);return i.kind==="ground"?s.add(iu(i,.004,e.ground,.35),l(.55,e.faint,.25)):i.kind==="mat"?(s.add(iu(i,i.thickness,e.mat,.2),l(.55,e.mat,.1)),s.add(iu(i,.04,e.wall,.25,i.thickness))):s.add(iu(i,.04,r,.22),l(.5,r,.1)),s}var su=class{constructor(e,t,n,s,r,o){this.origin=Nn(e.origin),this.body=new _t().add(...t.map(c=>kd(c,n,s,r)));let a=t.map(c=>Fv(c,o,r)).filter(Boolean);if(this.shadow=new _t,a.length&&this.shadow.add(...a),this.group=new _t().add(this.body,Ov(o,this.shadow)),this.turn=new sn,this.rod=null,!e.rod.length)return;this.pivot=Nn(e.rod);let l=new wn(Iv,Iv,1,10).translate(0,.5,0);this.rod=new Je(l,new Ni({color:n.metal,roughness:.6})),this.rod.position.copy(this.pivot),this.group.add(this.rod)}show(e){let[t,n,s,r]=e.quaternion;if(this.turn.set(n,s,r,t),this.body.quaternion.copy(this.turn),this.body.position.copy(this.origin).negate().applyQuaternion(this.turn).add(Nn(e.position)),this.shadow.quaternion.copy(this.body.quaternion),this.shadow.position.copy(this.body.position),!this.rod)return;let o=Nn(e.position).sub(this.pivot);this.rod.scale.y=o.length(),this.rod.quaternion.setFromUnitVectors(new L(0,1,0),o.normalize())}};function zv(i,e){let t=i.getSize(new L),n=i.getCenter(new L);n.z=i.min.z;let s=r=>Math.max(.8,Math.ceil((.5*r+.4)*4)/4);return Dv(n,new L(s(t.x),0,0),new L(0,s(t.y),0),.25,e.faint,.35)}function kv(i,e){let t=Nn(i.guide).normalize(),n=[];for(let c=0;c<i.n;c+=Math.max(1,Math.floor(i.n/200)))n.push(t.dot(Nn(i.position.subarray(3*c,3*c+3))));let s=Math.min(...n)-.5,r=Math.max(...n)+.5-s,o=new wn(.008,.008,r,12).rotateZ(-Math.PI/2).translate(r/2,0,0),a=new Je(o,new Ni({color:e.metal,transparent:!0,opacity:.5}));a.quaternion.setFromUnitVectors(new L(1,0,0),t);let l=Nn(i.position.subarray(0,3));return a.position.copy(l).addScaledVector(t,s-t.dot(l)),a}var ru=class{constructor(e,t,n){let s=e.impacts,r=s.length?s[0][0]:1/0,o=[],a=[],l=new at(t.before),c=new at(t.force),u=new at(e.colour);this.times=[];let h=-1/0;for(let m=0;m<e.n;m++){let g=e.t[m];if(g-h<.001&&m<e.n-1)continue;h=g,this.times.push(g),o.push(...e.position.subarray(3*m,3*m+3));let v=s.some(([p,d])=>g>=p&&g<=d);a.push(...(v?c:g<r?l:u).toArray())}let f=(m,g)=>{let v=new Ho;v.setPositions(o),v.setColors(a);let p=new $s({vertexColors:!0,linewidth:g,transparent:!0,opacity:m,depthWrite:!1});p.resolution.copy(n);let d=new nu(v,p);return d.computeLineDistances(),d};this.whole=f(.3,1.2),this.flown=f(1,2.6),this.group=new _t,this.group.add(this.whole,this.flown)}show(e){let t=0,n=this.times.length;for(;t<n;){let s=t+n>>1;this.times[s]<=e?t=s+1:n=s}this.flown.geometry.instanceCount=Math.max(t-1,0)}resize(e){this.whole.material.resolution.copy(e),this.flown.material.resolution.copy(e)}},ou=class{constructor(e,t,n){this.level=t,this.group=new _t,this.paths=e.arms.map(a=>new Co(a));let s=()=>new oi({color:"#000000",transparent:!0,opacity:.16,depthWrite:!1}),r=a=>{let l=new Je(new fr(a,36),s());return l.renderOrder=2,this.group.add(l),l};this.body=r(.045),this.cages=e.arms.map(a=>r(a.cage_radius));let o=new Ot;o.setAttribute("position",new mt([0,0,0,0,0,1],3)),this.plumb=new ur(o,new vs({color:n.faint,transparent:!0,opacity:.6})),this.group.add(this.plumb),this.turn=new sn,this.at=new L}show(e){let[t,n,s,r]=e.quaternion;this.turn.set(n,s,r,t);let o=this.level+.003;this.body.position.set(e.position[0],e.position[1],o),this.cages.forEach((a,l)=>{this.paths[l].at(e.armLengths[l],this.at,null,e.bends[l]),this.at.applyQuaternion(this.turn),a.position.set(e.position[0]+this.at.x,e.position[1]+this.at.y,o)}),this.plumb.position.set(e.position[0],e.position[1],o),this.plumb.scale.z=Math.max(e.position[2]-o,1e-4)}};function xT(i,e){let t=document.createElement("canvas");t.width=128,t.height=64;let n=t.getContext("2d");n.font="600 40px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle=e,n.fillText(i,64,32);let s=new Ma(t);s.colorSpace=Gn;let r=new ba(new vo({map:s,depthTest:!1,transparent:!0}));return r.scale.set(.9,.45,1),r}function Hv(i){let e=new _t;return Object.entries({"x N":[1,0,0],"y W":[0,1,0],"z up":[0,0,1]}).forEach(([n,s])=>{let r=new za(Nn(s),new L,1,i.ink,.28,.16),o=xT(n,i.ink);o.position.set(...s).multiplyScalar(1.38),e.add(r,o)}),e}var _T=(i,e)=>i.map((t,n)=>t+e[n]),Vv=(i,e)=>i.kind==="mesh"?{...i,moved:e}:{...i,centre:_T(i.centre,e)},al=(i,e)=>i.reduce((t,n,s)=>t+n*e[s],0);function Gv(i){let e=new Map;for(let t of i){let n=t.kind!=="mesh",s=n?[t.kind,t.thickness,...t.normal,al(t.normal,t.centre)].map(o=>o.toFixed?o.toFixed(4):o).join():`${t.name} ${t.key} ${t.moved}`,r=e.get(s);e.set(s,r?n?bT(r,t):yT(r,t):t)}return[...e.values()]}function yT(i,e){let[t,n]=[i,e].map(s=>{let r=new an().setFromArray(Zt(s.vertices));return s.triangles.shape[0]+.01*r.getSize(new L).length()});return n>t?e:i}function bT(i,e){let t={...i,centre:i.centre.slice()};for(let n of["across","along"]){let s=Math.hypot(...i[n]),r=i[n].map(u=>u/s),o=Math.abs(al(r,e.across))+Math.abs(al(r,e.along)),a=al(r,e.centre)-al(r,i.centre),l=Math.min(-s,a-o),c=Math.max(s,a+o);t[n]=r.map(u=>u*(c-l)/2),t.centre=t.centre.map((u,h)=>u+r[h]*(l+c)/2)}return t}var Wv=.22,MT=.2,wT=2.5,ST=1,ET=.005,TT=["follow","front","side","top"],Vo=["follow","free","front","side","top","impact"],Xv=100,qv=.4,Yv=400,$v=i=>Math.max(...i.arms.map(e=>Cg(e)+e.cage_radius));function Hd(i,e,t=!0){let n=i.map(Tp),s=e.robots;n.forEach((a,l)=>{let c=!a.arms.some(u=>u.compliant);a.colour=n.length>1?s[l%s.length]:s[c?1:0],a.glow=e.force,a.index=l,a.shift=0});let r=n.map(Cs),o=r.find(a=>a!==null);return r.forEach((a,l)=>{t&&a!==null&&Math.abs(o-a)>ET&&(n[l].shift=o-a)}),n}function au(i,{flights:e=[],compare:t="side",align:n=!0,onCamera:s=()=>{},onDrawn:r=()=>{}}={}){let o={compare:t,align:n,magnified:1,camera:"follow",t:0,all:[],hidden:new Set,flights:[],forces:!0,path:!0,estimate:!1,share:1},a=Pn();i.classList.add("picture");let l=document.createElement("div");l.className="force-labels";let c=document.createElement("div");c.className="scene-legend";let u=null;try{u=new Rh({antialias:!0,alpha:!1,stencil:!0,powerPreference:"high-performance"})}catch{let ce=document.createElement("p");ce.className="no-graphics",ce.textContent="This browser cannot draw 3-D graphics (WebGL is off); plots and numbers work.",i.append(ce)}let h=new mo,f=new Dn(38,1,.02,80);f.up.set(0,0,1);let m=new mo,g=new mr(-1.9,1.9,1.9,-1.9,.1,20);g.up.set(0,0,1);let v=new Na("#ffffff","#9aa4b0",2.1),p=new Fa("#ffffff",2);p.position.set(-2,-3,5),h.add(v,p);let d=null,b=new _t,M=[],y=0,P=0,E=-1/0,I=0,D=0,w=new Be(1,1);if(u){u.localClippingEnabled=!0,i.append(u.domElement,l,c),u.domElement.setAttribute("role","img"),u.domElement.setAttribute("aria-label","The flight in three dimensions, with numbers beside it."),d=new Zh(f,u.domElement),d.enableDamping=!1,d.minDistance=.15,d.maxDistance=30,d.addEventListener("change",S);let ce=!1;d.addEventListener("start",()=>ce=!0),d.addEventListener("end",()=>ce=!1),d.addEventListener("change",()=>{ce&&o.camera!=="follow"&&s("")})}function S(){!u||y||(P=performance.now(),y=requestAnimationFrame(B))}function A(){let ce=performance.now(),ue=P-E<Yv;E=ce,clearTimeout(I),ue&&(D=.7*D+.3*(ce-P)),D>Xv&&o.share>qv&&(o.share=Math.max(qv,.7*o.share),D=.5*Xv),k(ue?o.share:1),ue&&o.share<1&&(I=setTimeout(S,Yv))}function k(ce){let ue=Math.min(devicePixelRatio||1,2)*ce;Math.abs(u.getPixelRatio()-ue)>.001&&u.setPixelRatio(ue)}function B(){y=0,!(!u||!i.clientWidth||!i.clientHeight)&&(A(),V(),r())}function V(){let ce=i.clientWidth,ue=i.clientHeight;u.setViewport(0,0,ce,ue),u.setScissorTest(!1),u.setClearColor(a.background,1),u.render(h,f);let C=Math.min(104,.24*Math.min(ce,ue));g.position.copy(f.position).sub(d.target).setLength(6),g.up.copy(f.up),g.lookAt(0,0,0),u.autoClear=!1,u.clearDepth(),u.setViewport(6,6,C,C),u.render(m,g),u.autoClear=!0,ee(ce,ue)}function W(){let ce=o.flights[0].obstacles.find(C=>C.kind==="wall"||C.kind==="mat"),ue=ce&&Math.abs(ce.normal[2])<.9?new L(...ce.across).normalize():new L(0,1,0);return ue.y<0?ue.negate():ue}let q=()=>W().applyAxisAngle(f.up,-Math.PI/2);function N(ce){let ue=new L,[C,_]=[1/0,-1/0];for(let F of o.flights.flatMap(J=>J.obstacles)){if(F.kind!=="mesh"||F.normals)continue;let J=Zt(F.vertices);for(let j=0;j<J.length;j+=3){let ie=ue.fromArray(J,j).dot(ce);[C,_]=[Math.min(C,ie),Math.max(_,ie)]}}return Math.max(0,_-C)}let z=()=>[...new Set(o.flights.map(ce=>ce.world))];function K(ce){let ue=o.flights.filter(J=>o.flights.some(j=>j!==J&&j.world===J.world)),C=new L,[_,F]=[1/0,-1/0];for(let{position:J}of ue)for(let j=0;j<J.length;j+=3){let ie=C.fromArray(J,j).dot(ce);[_,F]=[Math.min(_,ie),Math.max(F,ie)]}return Math.max(0,F-_)}let ne=()=>z().length>1&&N(W())>wT?"ghost":o.compare;function te(){if(ne()!=="side")return o.flights.map(()=>[0,0,0]);let ce=W(),ue=Math.max(...o.flights.map($v)),C=Math.max(2*ue+K(ce),N(ce))+MT,_=z(),F=.5*(_.length-1);return o.flights.map(({world:J})=>ce.clone().multiplyScalar((F-_.indexOf(J))*C).toArray())}function le(ce,{keepCamera:ue=!0}={}){a=Pn(),o.all=Hd(ce,a,o.align),o.flights=o.all.filter((C,_)=>!o.hidden.has(_)),u&&fe(),ue||H(o.camera),we(o.t)}function fe(){ol(b),b=new _t,h.add(b),m.children.slice().forEach(ol),m.add(Hv(a)),l.replaceChildren();let ce=te(),ue=new an,C=Math.max(...o.flights.map(Eu),0),_=C>0?Wv/Tu(C):0;o.floor=ye(ce),M=o.flights.map((j,ie)=>{let Pe=new _t;Pe.position.set(...ce[ie]),b.add(Pe);let ge=j.world!==z()[0]&&ne()==="ghost",Oe=new rl(j,{colour:j.colour,opacity:ge?.35:1},a),De=new ru(j,a,w),ve=j.part.map(()=>new Jh(a.force,.007,ge?.4:.95)),Re=new ou(j,o.floor,a);Re.group.visible=!ge||o.flights.length===2;let qe=Hr(j)?new rl(j,{colour:a.ink,opacity:.35},a):null;qe&&Pe.add(qe.group),Pe.add(Oe.group,De.group,Re.group,...ve.map(X=>X.group)),j.guide.length&&Pe.add(kv(j,a));let Ye=new an,Ue=Math.max(1,Math.floor(j.n/400));for(let X=0;X<j.n;X+=Ue)Ye.expandByPoint(new L(...j.position.subarray(3*X,3*X+3)));ue.union(Ye.translate(Pe.position));let tt=j.part.map(()=>{let X=document.createElement("span");return l.append(X),X});return{flight:j,group:Pe,robot:Oe,estimate:qe,path:De,arrows:ve,shadow:Re,scale:_,names:tt,ghost:ge,contacts:[],movers:[]}});let F=o.flights.flatMap((j,ie)=>j.obstacles.filter(Pe=>Pe.track<0).map(Pe=>Vv(Pe,ce[ie]))),J=F.some(j=>j.kind==="ground")?o.floor:null;o.shadows=[],o.shades=Nv(o.flights.flatMap(j=>j.obstacles),a),Gv(F).forEach(j=>{let ie=Bv(j,o.floor,J);ie&&o.shadows.push(ie);for(let Pe of[kd(j,a,o.shades,J),ie])Pe&&(Pe.position.add(new L(...j.moved??[0,0,0])),b.add(Pe))}),M.forEach(j=>{j.movers=j.flight.bodies.map((ie,Pe)=>new su(ie,j.flight.obstacles.filter(ge=>ge.track===Pe),a,o.shades,J,o.floor));for(let ie of j.movers)j.group.add(ie.group)}),o.box=ue.clone(),J===null&&(ue.min.z=o.floor,b.add(zv(ue,a))),_e()}function ye(){let ce=Math.max(...o.flights.flatMap(C=>C.obstacles.filter(_=>_.kind==="ground").map(_=>_.centre[2])));if(Number.isFinite(ce))return ce;let ue=1/0;for(let C of o.flights)for(let _=2;_<3*C.n;_+=3)ue=Math.min(ue,C.position[_]);return ue-.45}function _e(){let ce=Math.max(...o.flights.map(Eu),0);c.replaceChildren();let ue=(_,F)=>{let J=document.createElement("span");J.className=`key ${_}`,J.textContent=F,c.append(J)};if(o.flights.length>1&&o.flights.forEach(_=>{ue("robot",_.label),c.lastChild.style.setProperty("--colour",_.colour)}),o.estimate&&o.flights.some(Hr)&&ue("estimate","estimated pose"),ce>0&&o.forces){let _=Tu(ce);ue("force",`contact force, each at its point, ${_} N is ${100*Wv} cm`)}o.flights.some(_=>_.thrust.some(F=>F>0))&&ue("thrust","thrust");let C=new Set(o.flights.flatMap(_=>_.obstacles.map(ll)));ne()!==o.compare&&ue("words","overlaid: the obstacles are too wide to be put side by side"),o.magnified!==1&&ue("travel",`arm travel × ${o.magnified}, not to scale`);for(let _ of C)ue("obstacle",_),c.lastChild.style.setProperty("--colour",o.shades?.get(_)??a.wall)}function ee(ce,ue){let C=new L,_=[];for(let F of M)F.names.forEach((J,j)=>{let ie=F.contacts[j];if(J.hidden=F.ghost||!o.forces||!ie||ie.size<.5,J.hidden)return;C.set(...ie.point).addScaledVector(new L(...ie.force),F.scale),C.add(F.group.position).project(f),J.hidden=C.z>1||Math.abs(C.x)>1||Math.abs(C.y)>1,J.textContent=`${ie.size.toFixed(ie.size<10?1:0)} N`;let Pe=Math.min(Math.max((C.x+1)/2*ce,24),ce-24),ge=Math.min(Math.max((1-C.y)/2*ue-12,10),ue-10);J.hidden=_.some(([Oe,De])=>Math.abs(Oe-Pe)<50&&Math.abs(De-ge)<18),!J.hidden&&(_.push([Pe,ge]),J.style.transform=`translate(${Pe}px, ${ge}px) translate(-50%, -50%)`)})}let Y=null,pe=null;function xe(){let ce=M.map(ue=>ue.robot.group.position.clone().add(ue.group.position));return ce.reduce((ue,C)=>ue.add(C),new L).divideScalar(ce.length||1)}function we(ce){if(o.t=ce,o.poses=o.flights.map(ue=>Jo(ue,ce)),M.forEach((ue,C)=>{let _=o.poses[C];ue.robot.show(_,o.magnified),ue.path.group.visible=o.path,ue.path.show(_.own),ue.estimate&&(ue.estimate.group.visible=o.estimate,o.estimate&&ue.estimate.show(Su(ue.flight,ce),o.magnified)),ue.shadow.show(_),ue.movers.forEach((F,J)=>F.show(_.bodies[J])),ue.contacts=_.contacts,ue.arrows.forEach((F,J)=>{let j=_.contacts[J];j&&o.forces?F.show(j.point,j.force.map(ie=>ue.scale*ie)):F.hide()})}),u&&M.length&&o.camera==="impact"){let ue=oe();if(pe&&ue.distanceTo(pe)>1e-9){let C=ue.clone().sub(pe);f.position.add(C),d.target.add(C),d.update()}pe=ue}if(u&&M.length&&TT.includes(o.camera)){let ue=xe();if(Y){let C=ue.clone().sub(Y);f.position.add(C),d.target.add(C)}Y=ue,d.update()}S()}function Ve(ce){let ue=Xs.degToRad(f.fov/2),C=Math.min(1,f.aspect);return ce/Math.sin(Math.atan(Math.tan(ue)*C))}function dt(ce,ue){d.target.copy(ce),f.position.copy(ce).add(ue),d.update()}function H(ce){if(o.camera=Vo.includes(ce)?ce:"follow",Y=pe=null,s(o.camera),!u||!M.length)return;let ue=Math.max(...o.flights.map($v)),C=M.map(De=>De.group.position),_=C[0].distanceTo(C[C.length-1])/2,F=ue+_+ht()+.1,J=z().length>2&&_>0,j=J?Math.max(Ve(ue+.2),F/(Math.tan(Xs.degToRad(f.fov/2))*f.aspect)+ue):Ve(F),ie=o.box.clone().expandByScalar(ue+.1),Pe=ie.getCenter(new L),ge=.5*ie.getSize(new L).length(),Oe=J?q().negate().addScaledVector(W(),-.25).setZ(.5).normalize():new L(-.62,-.66,.42).normalize();if(o.camera==="free")dt(Pe,Oe.clone().multiplyScalar(Ve(ge)));else if(o.camera==="impact")dt(pe=oe(),J?Oe.clone().multiplyScalar(j):new L(-.45,-.62,.5).normalize().multiplyScalar(Ve(F+.05)));else{Y=xe();let De={follow:Oe,front:q().setZ(.12),side:W().negate().setZ(.12),top:new L(0,-.001,1)}[o.camera];dt(Y.clone(),De.clone().normalize().multiplyScalar(o.camera==="side"?Ve(F):j))}S()}function ht(){let ce=M.map(({flight:ue,robot:C})=>{let _=M.filter(j=>j.flight.world===ue.world);return _.map(j=>j.robot.group.position.clone()).reduce((j,ie)=>j.add(ie),new L).divideScalar(_.length).distanceTo(C.group.position)});return Math.min(Math.max(...ce),ST)}function oe(){let ce=o.flights.map((ue,C)=>{let _=Jo(ue,Ap(ue,o.t)??Cs(ue)??ue.begin);return new L(..._.position).add(M[C].group.position)});return ce.reduce((ue,C)=>ue.add(C),new L).divideScalar(ce.length)}function be(){if(!u)return;let ce=i.clientWidth,ue=i.clientHeight;if(!ce||!ue)return;k(1),u.setSize(ce,ue,!1);let C=f.aspect;f.aspect=ce/ue,f.updateProjectionMatrix(),w.set(ce,ue),M.forEach(_=>_.path.resize(w)),Math.abs(C/f.aspect-1)>.15&&H(o.camera),S()}let Ce=new ResizeObserver(be);Ce.observe(i);let ot=matchMedia("(prefers-color-scheme: dark)"),ae=()=>le(o.all);ot.addEventListener("change",ae);function Le(){Ce.disconnect(),ot.removeEventListener("change",ae),cancelAnimationFrame(y),clearTimeout(I),ol(b),m.children.slice().forEach(ol),d?.dispose(),u?.dispose(),i.replaceChildren()}return be(),e.length&&le(e,{keepCamera:!1}),{show:we,replace:le,setCamera:H,resize:be,dispose:Le,setCompare(ce){o.compare=ce,o.flights.length&&le(o.all,{keepCamera:!1})},setShown(ce,ue){if(typeof ce!="number"){o[ce]=ue,_e(),we(o.t);return}ue?o.hidden.delete(ce):o.hidden.add(ce),le(o.all,{keepCamera:!1})},canvas(ce=!0){return ce&&u&&(k(1),V()),u?.domElement??null},setMagnified(ce){o.magnified=ce,_e(),we(o.t)},get flights(){return o.flights},get all(){return o.all},get camera(){return o.camera},pose:()=>({t:o.t,camera:o.camera,target:d?.target.toArray(),pixels:o.share,flights:o.poses??[],places:M.map(({group:ce,robot:ue})=>ue.group.position.clone().add(ce.position).toArray()),ends:M.map(({robot:ce})=>ce.ends()),connections:M.map(({robot:ce})=>ce.connections()),estimates:o.estimate?o.flights.map(ce=>Hr(ce)?Su(ce,o.t):null):[]}),shadows:()=>[...o.shadows,...M.flatMap(({movers:ce})=>ce.map(({shadow:ue})=>ue))].map(ce=>{ce.updateWorldMatrix(!0,!0);let ue=new an().setFromObject(ce,!0);return[...ue.min.toArray(),...ue.max.toArray()]}),memory:()=>({...u?.info.memory})}}var AT={follow:"Follow",free:"Whole flight",front:"Front",side:"Side",top:"Top",impact:"Impact"},RT={1:"front",2:"side",3:"top",4:"follow",5:"free",6:"impact",0:"follow"},CT=[["space","play, pause"],["← →","one instant back, forth; with shift ten"],[", .","slower, faster"],["t","to the first touch"],["Home End","to the start, to the end"],["1 2 3","view from the front, from the side, from above"],["4 5 6","follow, whole flight, impact"],["0","the view as it was at first"],["e","estimated pose, on and off"],["f","full screen"],["p","save a picture"],["l","copy a link to this instant and view"],["a click in a plot","goes to that instant"],["a drag in a plot","zooms: along the time, the values, or both"],["a double click in a plot","shows everything"],["Escape","undoes the last zoom"],["?","these keys"]],Vd="springback.plots",PT=8e3;function Zv(i,e){let t=G("div",{class:"stage"}),n=G("div"),s=G("div",{class:"readouts"}),r=G("div"),o=G("p",{class:"remark",role:"status",hidden:!0}),a=!1,l=null,c=null,u=au(t,{flights:e.flights,onCamera:oe=>(l?.mark(oe),Ve()),onDrawn:()=>c?.drawn()}),h=u.all,f=h.length>1,m=new Set(h.map(oe=>oe.world)).size,g=[...new Set(h.map(oe=>oe.scenario))],v=g.length>2?`${h.length} flights`:g.join(" and ");function p(oe){o.textContent=oe,o.hidden=!1,clearTimeout(p.ends),p.ends=setTimeout(()=>o.hidden=!0,PT)}let d=h.map((oe,be)=>LT(oe,f&&(Ce=>w(be,Ce))));l=Si("Camera",Vo.map(oe=>[oe,AT[oe]]),"follow",oe=>u.setCamera(oe));let b=Si("Flights",[["side","side by side"],["ghost","overlaid"]],"side",oe=>(u.setCompare(oe),Ve())),M=h.some(oe=>oe.arms.some(be=>be.compliant)),y=Si("Arm travel",[["1","arms to scale"],["10","arm travel × 10"]],"1",oe=>(u.setMagnified(Number(oe)),Ve())),P={forces:["Forces",!0],path:["Path",!0],...h.some(Hr)?{estimate:["Estimate",!1]}:{}},E=Object.fromEntries(Object.entries(P).map(([oe,[be,Ce]])=>[oe,dp(be,Ce,ot=>(u.setShown(oe,ot),Ve()),oe==="estimate"?"The pose that the pilot estimates, as a grey ghost (E)":"")])),I=G("div",{class:"choice",role:"group","aria-label":"Show"},...Object.values(E)),D=()=>h.flatMap((oe,be)=>d[be].shown?[]:[be+1]);function w(oe,be){if(!be&&D().length===h.length-1)return p("One flight is always shown.");d[oe].mark(be),u.setShown(oe,be),xe.replace(),Ve()}let S=hv(r,{onSeek:oe=>(xe.pause(),xe.seek(oe)),onZoom:()=>(z(),Ve()),onEdit:oe=>A.open(S.wanted,oe),onRemove:oe=>K(S.wanted.filter((be,Ce)=>Ce!==oe))}),A=Ip({signals:yl(h),standard:tr(h),onChoose:K}),k=h.find(oe=>oe.impacts.length),B=()=>{let[oe,be]=k.impacts[0].map(ot=>ot+k.shift),Ce=.35*Math.min(be-oe,.2)+.004;return[oe-Ce,Math.min(be,oe+.3)+2*Ce]},V=oe=>!!(k&&oe)&&oe.every((be,Ce)=>Math.abs(be-B()[Ce])<1e-9),W=Si("Plots show",[["all","whole flight"],...k?[["impact","first impact"]]:[]],"all",oe=>oe==="all"?S.zoom():S.zoom(...B())),q=G("button",{type:"button",class:"undo",title:"Undo the last zoom (Escape)",disabled:!0,"aria-label":"Undo the last zoom",onclick:()=>S.back()},Yi("undo")),N=G("button",{type:"button",class:"adding",title:"Choose plots and signals",onclick:()=>A.open(S.wanted)},"Plots …");function z(){let{range:oe,heights:be}=S.zoomed,Ce=!Object.keys(be).length;W.mark(Ce&&!oe?"all":Ce&&V(oe)?"impact":""),q.disabled=!S.canGoBack}function K(oe){S.choose(oe);try{oe?localStorage.setItem(Vd,Qo(oe)):localStorage.removeItem(Vd)}catch{}Ve()}let ne=G("dialog",{class:"keys","aria-label":"Keys and mouse"},G("h2",{},"Keys and mouse"),G("table",{},...CT.map(([oe,be])=>G("tr",{},G("th",{scope:"row"},oe),G("td",{},be)))),G("form",{method:"dialog"},G("button",{class:"main"},"Close"))),te=(oe,be,Ce,ot)=>G("button",{type:"button",class:`tool tool-${oe}`,title:`${be}${ot?` (${ot})`:""}`,"aria-label":be,onclick:Ce},Yi(oe)),le=te("film","Record a film from here",()=>c.film()),fe=G("div",{class:"left"},t,n),ye=Ml(()=>fe,()=>p("This browser refuses full screen.")),_e=G("div",{class:"tools"},te("link","Copy a link to this instant and view",ee,"L"),te("picture","Save a picture",()=>c.picture(),"P"),le,ye.button,te("help","Keys and mouse",()=>ne.showModal(),"?"));async function ee(){let oe=we.address();try{await navigator.clipboard.writeText(oe),p("The link is copied.")}catch{p("The address of this page is now a link to this instant and view.")}}let pe={...Object.fromEntries(Object.entries(RT).map(([oe,be])=>[oe,()=>u.setCamera(be)])),f:ye.toggle,p:()=>c.picture(),l:ee,"?":()=>ne.showModal(),e:()=>E.estimate?.click(),Escape:()=>S.back()};i.replaceChildren(G("header",{class:"top"},G("div",{class:f?"flights several":"flights"},G("h1",{},v),...d.map(oe=>oe.element)),G("div",{class:"views"},l,...m>1?[b]:[],...M?[y]:[],I)),G("main",{},fe,G("aside",{},s,G("div",{class:"plot-head"},G("h2",{},"Over time"),W,q,N),r,...DT(h),UT(h))),A.element,ne),t.append(o),i.classList.add("replay");let xe=Yh({scene:u,plots:S,bar:n,readouts:s,actions:pe,onRest:()=>(c?.rested(),Ve())});c=mp({scene:u,stage:t,player:xe,say:p,name:v.replace(/[^\p{L}\p{N}]+/gu,"-").slice(0,60),onRecording:oe=>{le.classList.toggle("recording",oe),le.setAttribute("aria-label",oe?"End the film":"Record a film from here")}}),n.querySelector(".buttons").append(_e),xe.replace({keepTime:!1}),k&&S.restore({range:B(),heights:{}}),z(),u.setCamera("follow");let we=Lp({read:dt,apply:H});function Ve(){a&&!xe.playing&&we.renew()}function dt(){let{range:oe}=S.zoomed;return{t:xe.time.toFixed(6).replace(/0+$/,"").replace(/\.$/,""),camera:u.camera==="follow"?"":u.camera,speed:xe.pace==="auto"?"":xe.pace,arms:y.chosen==="10"?"10":"",compare:b.chosen==="ghost"?"ghost":"",hide:D().join(),layers:Object.keys(P).filter(be=>E[be].on!==P[be][1]).join(),zoom:V(oe)||!oe&&!k?"":oe?oe.map(be=>be.toFixed(6)).join():"all",plots:Qo(S.wanted)===Qo(tr(h))?"":Qo(S.wanted)}}function H(oe){let be=ae=>ae.split(",").map(Number);if(oe.hide){let ae=be(oe.hide);h.every((Le,ce)=>ae.includes(ce+1))||h.forEach((Le,ce)=>d[ce].shown===ae.includes(ce+1)&&w(ce,!ae.includes(ce+1)))}oe.compare==="ghost"&&m>1&&b.press("ghost"),oe.arms==="10"&&M&&y.press("10");let Ce=(oe.layers??"").split(",");for(let ae of Object.keys(P))Ce.includes(ae)&&E[ae].on===P[ae][1]&&E[ae].click();Vo.includes(oe.camera)&&u.setCamera(oe.camera);let ot=oe.plots?Au(oe.plots,h):[];ot.length&&S.choose(ot),oe.zoom==="all"?S.restore({range:null,heights:{}}):oe.zoom&&S.restore({range:be(oe.zoom),heights:{}}),(oe.speed==="auto"||Number(oe.speed)>0)&&xe.setPace(oe.speed),oe.t&&Number.isFinite(Number(oe.t))&&xe.seek(Number(oe.t))}let ht=IT(h);return ht.length&&S.choose(ht),we.follow(),a=!0,window.springback={scene:u,player:xe,plots:S,link:we,pose:()=>({...u.pose(),playing:xe.playing,pace:xe.pace})},matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{h.forEach((oe,be)=>d[be].element.style.setProperty("--colour",oe.colour)),xe.replace()}),window.springback}function IT(i){try{return Au(localStorage.getItem(Vd)??"",i)}catch{return[]}}function LT(i,e){let t={shown:!0},n=e?G("button",{type:"button",class:"flight","aria-pressed":"true",title:"Hide or show this flight",onclick:()=>e(!t.shown)},i.label):G("b",{},i.label);return t.element=G("p",{class:`outcome ${i.success?"well":"badly"}`},n,G("span",{},` ${i.sentence}`)),t.element.style.setProperty("--colour",i.colour),t.mark=s=>{t.shown=s,n.setAttribute("aria-pressed",String(s)),t.element.classList.toggle("away",!s)},t}function DT(i){let e=i.flatMap(t=>t.touched.map(n=>G("p",{},i.length>1?`${t.label}: ${n}`:n)));return e.length?[G("details",{class:"about touched",open:i.length===1},G("summary",{},"Touched obstacles"),...e)]:[]}function UT(i){let e=i.flatMap(s=>[...s.notes.map(r=>`${s.label}: ${r}.`),s.shift?`${s.label} is shown ${Math.abs(s.shift).toFixed(3)} s ${s.shift<0?"earlier":"later"} than it flew, so that all touch at the same time.`:""]),t=Math.max(...i.map(s=>s.departure.position))*1e3;e.push(`Motion between the drawn instants is interpolated linearly: positions are within ${t<.01?"0.01":t.toFixed(2)} mm of the flight.`);let n=Math.max(...i.map(s=>s.every));return e.push("Signals that you choose are rounded to 1/65534 of their range."),n>1&&e.push(`Telemetry is shown at every tick near impacts and changes of phase, elsewhere at one tick in ${n}.`),G("details",{class:"about"},G("summary",{},"About this view"),...[...new Set(e)].filter(Boolean).map(s=>G("p",{},s)),G("p",{},"World axes: x north, y west, z up. Yellow arrows are the contact forces on cages and main body, including friction; the numbers show their vector sum, in which friction on two cages may cancel. Blue bars are the thrust of the rotors; dark discs are vertical shadows."))}var Gd=1e3,Jv=(i,e)=>Number((Math.round(i/e)*e).toFixed(6));function cl(i,e){let{least:t,most:n,logarithmic:s}=i,r=s?Math.log(e/t)/Math.log(n/t):(e-t)/(n-t);return Math.min(Math.max(r,0),1)}function Kv(i,e){let{least:t,most:n,step:s,logarithmic:r}=i,o=r?t*(n/t)**e:t+(n-t)*e,a=r?10**Math.max(Math.floor(Math.log10(o))-1,Math.log10(s)):s;return Math.min(Math.max(Jv(o,Math.max(a,s)),t),n)}function NT(i,e){let t=`set-${i.name}`,n=i.unit.replace("^1.5","¹·⁵"),s=G("input",{type:"range",min:0,max:Gd,step:1,id:`${t}-slider`,"aria-label":i.label,oninput:()=>h(Kv(i,Number(s.value)/Gd),{moving:!0}),onchange:()=>e(i.name,r.value,{settled:!0}),onkeydown:g=>{let v={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[g.key];if(!v)return;g.preventDefault();let p=Number(r.value);Number.isFinite(p)&&h(Math.min(Math.max(Jv(p+v*i.step,i.step),i.least),i.most),{settled:!0})}}),r=G("input",{type:"text",inputmode:"decimal",id:t,autocomplete:"off",spellcheck:"false",maxlength:40,"aria-describedby":`${t}-words`,oninput:()=>e(i.name,r.value.trim(),{typing:!0}),onchange:()=>e(i.name,r.value.trim(),{settled:!0})}),o=G("p",{class:"words",id:`${t}-words`}),a=G("div",{class:"marks"},...i.marks.map((g,v)=>{let p=M=>String(M.value).length*.013+.01,d=i.marks.some((M,y)=>y<v&&Math.abs(cl(i,M.value)-cl(i,g.value))<p(M)+p(g)),b=G("button",{type:"button",class:d?"tight":"",title:`${g.value} ${n}, ${g.words}`,"aria-label":`${i.label} ${g.value} ${n}, ${g.words}`,onclick:()=>h(g.value,{settled:!0})},G("span",{},String(g.value)));return b.style.setProperty("--share",cl(i,g.value)),b})),l=G("div",{class:"slider-control","data-name":i.name},G("label",{for:t},i.label),G("span",{class:"field"},r,G("span",{class:"unit"},n)),G("div",{class:"rail"},s,a),o);function c(g){let v=Number(g);r.value.trim()!==String(g)&&(r.value=String(g)),Number.isFinite(v)&&(s.value=Math.round(cl(i,v)*Gd),s.setAttribute("aria-valuetext",`${g} ${n}`)),f("")}function u(){let g=i.marks.find(v=>v.value===Number(r.value));o.className=g?"words printed":"words",o.textContent=g?`= ${g.words}`:i.explains}function h(g,v){c(g),e(i.name,String(g),v)}function f(g){r.setAttribute("aria-invalid",String(!!g)),l.classList.toggle("wrong",!!g),g?o.textContent=g:u()}return l.title=i.explains,{element:l,show:c,tellProblem:f,pick:g=>h(Kv(i,cl(i,g)),{settled:!0})}}function FT(i){let e=G("p",{class:"words"},i.explains);return{element:G("div",{class:"fixed-control","data-name":i.name},G("span",{class:"label"},i.label),e),show:()=>{},tellProblem:s=>e.textContent=s||i.explains}}function OT(i,e){let t=Object.keys(i.words).length>3,n=G("p",{class:"words"},i.explains),s=a=>e(i.name,a,{settled:!0});if(!t){let a=Si(i.label,Object.entries(i.words),i.default,s);return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("span",{class:"label"},i.label),a),show:a.mark,tellProblem:()=>{}}}let r=G("select",{id:`set-${i.name}`,onchange:()=>s(r.value)},...Object.entries(i.words).map(([a,l])=>G("option",{value:a},l)));return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("label",{for:`set-${i.name}`},i.label),r,n),show:a=>r.value=a,tellProblem:a=>n.textContent=a||i.explains}}var BT={slider:NT,fixed:FT,choice:OT};function jv(i,e){let t={},n={},s=new Map,r=(v,p,d)=>{t[v]=p,l(),e(v,p,d)};for(let v of i)t[v.name]=String(v.default),n[v.name]=BT[v.kind](v,r),s.has(v.group)||s.set(v.group,[]),s.get(v.group).push(n[v.name].element);let o=[...s].map(([v,p])=>G("section",{},...v?[G("h2",{},v)]:[],...p)),a=G("form",{class:"controls",onsubmit:v=>v.preventDefault()},...o);function l(){for(let v of i){let p=Object.entries(v.when).every(([d,b])=>b.includes(t[d]));n[v.name].element.hidden=!p}o.forEach(v=>v.hidden=![...v.querySelectorAll("[data-name]")].some(p=>!p.hidden))}function c(v){for(let[p,d]of Object.entries(v))t[p]=String(d),n[p]?.show(d);l()}function u(v){let p=new URLSearchParams(v);c(Object.fromEntries(i.map(({name:d,words:b,default:M})=>{let y=p.get(d);return[d,y===null||b&&!(y in b)?M:y]})))}function h(v){for(let p of Object.values(n))p.tellProblem("");for(let p of v){let d=p.split(":")[0],b=d in n?d:i.find(M=>M.path===d)?.name;n[b]?.tellProblem(p.slice(d.length+1).trim())}}let f=()=>i.filter(v=>t[v.name]!==String(v.default)).map(v=>`${v.name}=${encodeURIComponent(t[v.name])}`).join("&");return l(),{element:a,values:t,query:f,show:c,showQuery:u,tellProblems:h,isShown:v=>!n[v].element.hidden,pick:(v,p)=>n[v].pick(p)}}function Qv(i,e){let t=null,n=!1,s=0;function r(l,c){clearTimeout(s),t={query:l,how:c},n||o()}async function o(){let{query:l,how:c}=t;t=null,n=!0;try{await a(l,c)}catch{t||e.gone()}n=!1,t&&o()}async function a(l,c){let u=await fetch(`flight?${l}`,{headers:{"x-lab-page":i}}),h=await u.json();if(u.ok)e.answered(h,{...c,older:t!==null});else if(u.status===503){if(t)return;h.preparing&&e.waits(h.preparing),s=setTimeout(()=>r(l,{...c,since:performance.now()}),700)}else!h.overtaken&&!t&&e.refused(h.errors,c)}return{ask:r}}var ex=100,zT=16,hl="Energy",tx=[-.01,.13],kT={motion:["#0072b2",.85],"arm springs":["#56b4e9",.85],"end stops":["#cc79a7",.85],contact:["#009e73",.85],"lost in arms":["#e69f00",.6],"lost in contact":["#d55e00",.6],"lost in friction":["#8c8c8c",.6],"lost in stops":["#cc79a7",.4],"lost in locking":["#444444",.4],"lost to air":["#bbbbbb",.4],"moving obstacles":["#b3a100",.75],"lost in obstacles":["#b3a100",.35],"to driven obstacles":["#6b4fa0",.5],"to the other robot":["#6b4fa0",.5]},nx={"put in":{width:1.6,dash:[6,3]},"by driven obstacles":{width:1.4,dash:[2,3]},"by the other robot":{width:1.4,dash:[2,3]}},ix=(i,e)=>i+Math.round(255*e).toString(16).padStart(2,"0");function Wd(i,e=[1,1.5,2,3,5,7,10]){if(!(i>0))return 1;let t=10**Math.floor(Math.log10(i));return t*e.find(n=>n*t>=i*.999999)}function Xd(i,e,t,{moving:n=!1,locked:s=!1}={}){if(i&&s)return i;let r=[e<-1e-9?-Wd(-e):0,t>1e-9?Wd(t):e<-1e-9?0:1],[o,a]=i??r,l=e>=o&&t<=a&&(n||t-e>.3*(a-o));return i&&l?i:n?[Math.min(o,r[0]),Math.max(a,r[1])]:r}function HT(i,e,t){let n=0,s=0;for(let{t:r,values:o}of i)for(let a=0;a<o.length;a++)r[a]<e||r[a]>t||(o[a]<n&&(n=o[a]),o[a]>s&&(s=o[a]));return[n,s]}function VT(i,e){let t=new Map,n=(a,l,c)=>{t.has(a)||t.set(a,{name:a,unit:l,curves:[],stacked:a.startsWith(hl)}),t.get(a).curves.push(c)},s=(a,l)=>{let c=Array.from(a.t,h=>h+a.shift),u=null;for(let h of a.series)if(h.panel===hl){if(l)continue;if(nx[h.name]){n(`${hl}, ${a.label}`,h.unit,{name:h.name,t:c,values:Array.from(h.values),colour:Pn().ink,flight:a,over:!0,...nx[h.name]});continue}u=Array.from(h.values,(g,v)=>g+(u?u[v]:0));let[f,m]=kT[h.name]??["#8c8c8c",.5];n(`${hl}, ${a.label}`,h.unit,{name:h.name,t:c,values:u,colour:f,fill:ix(f,m),flight:a})}else n(h.panel,h.unit,{name:l?`${a.label}, pinned`:a.label,t:c,values:Array.from(h.values),flight:a,colour:l?ix(a.colour,.75):a.colour,dash:l?[3,3]:a.dash,behind:l})};i.forEach((a,l)=>{a.dash=l?[8,3]:[],s(a,!1)}),e.forEach(a=>s(a,!0));let r=i.map(a=>`${hl}, ${a.label}`),o=a=>["Acceleration","Arm compression",...r,"Velocity","Contact force"].indexOf(a.name);return[...t.values()].sort((a,l)=>o(a)-o(l))}function sx(i,{onSeek:e}){let t=new Map,n=[],s=[],r=0,o=null,a=!1;i.classList.add("plots");function l(p,{whole:d=!1,moving:b=!1}={}){s=p;let M=Cs(p[0]),[y,P]=[p[0].begin,p[0].end];o=d||M===null?[y,P]:[M+tx[0],Math.min(M+tx[1],P)];let E=M??0,I=VT(p,n);for(let[D,w]of t)I.some(S=>S.name===D&&c(S,d)===w.signature)||(w.plot.destroy(),w.box.remove(),t.delete(D));for(let D of I){let w=t.get(D.name)??f(D,d);w.panel=D,w.zero=E,w.bounds=Xd(w.bounds,...HT(D.curves,...o),{moving:b,locked:a}),w.plot.batch(()=>{w.plot.setData(u(D),!1),w.plot.setScale("x",{min:o[0],max:o[1]}),w.plot.setScale("y",{min:w.bounds[0],max:w.bounds[1]})}),i.append(w.box)}g(r)}let c=(p,d)=>`${d} ${p.curves.map(b=>`${b.name} ${b.colour}`).join()}`;function u(p){let b=p.curves.every(M=>M.flight===p.curves[0].flight)?[p.curves[0].t,...p.curves.map(M=>M.values)]:Kt.join(p.curves.map(M=>[M.t,M.values]));return[b[0],...h(p,b.slice(1))]}function h(p,d){if(!p.stacked)return d;let b=p.curves.map(M=>!!M.over);return[...d.filter((M,y)=>!b[y]).reverse(),...d.filter((M,y)=>b[y])]}function f(p,d){let b=Pn(),M=!p.stacked||p.curves[0].flight===s[0],y=p.curves.filter(()=>M).map(B=>{let V=document.createElementNS("http://www.w3.org/2000/svg","svg");V.setAttribute("viewBox","0 0 22 8"),V.setAttribute("aria-hidden","true");let W=document.createElementNS("http://www.w3.org/2000/svg","line"),q={x1:0,x2:22,y1:4,y2:4,stroke:B.fill??B.colour,"stroke-width":B.fill?8:2.4,"stroke-dasharray":(B.dash??[]).join(" ")};return Object.entries(q).forEach(([N,z])=>W.setAttribute(N,z)),V.append(W),G("span",{class:"plot-key"},V,G("span",{},B.name))}),P=G("div",{class:"plot-canvas"}),E=G("section",{class:"plot","data-panel":p.name},G("header",{},G("h3",{},`${p.name} [${p.unit}]`),G("div",{class:"plot-keys"},...y)),P);i.append(E);let I={box:E,canvas:P,panel:p,signature:c(p,d),bounds:null,zero:0},D={stroke:b.faint,grid:{stroke:b.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},w=h(p,p.curves),S=w.filter(B=>!B.over),A=(B,V)=>V.map(W=>String(d?+W.toFixed(3):Math.round(1e3*(W-I.zero)))),k=(B,V,W,q)=>GT(W,q,I.zero,d);return I.plot=new Kt({width:Math.max(P.clientWidth,200),height:ex,padding:[6,10,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[{...D,size:22,gap:2,values:A,splits:k},{...D,size:46,gap:4,space:zT}],series:[{},...w.map(B=>({stroke:B.colour,width:B.width??(B.fill?1:B.behind?1.4:1.8),dash:B.dash??[],fill:B.fill,spanGaps:!0,points:{show:!1}}))],hooks:{draw:[()=>m(I)]},bands:p.stacked?S.slice(1).map((B,V)=>({series:[V+1,V+2],fill:S[V].fill})):[]},u(p),P),I.marker=G("div",{class:"plot-now"}),I.plot.over.append(I.marker),I.plot.over.addEventListener("click",B=>e(I.plot.posToVal(B.offsetX,"x"))),t.set(p.name,I),I}function m({plot:p,marker:d}){if(!d)return;let{min:b,max:M}=p.scales.x;d.hidden=!(r>=b&&r<=M),d.style.transform=`translateX(${p.valToPos(r,"x")}px)`}function g(p){r=p,t.forEach(m)}function v(){for(let{plot:p,canvas:d}of t.values()){let b=d.clientWidth;b&&Math.abs(b-p.width)>1&&p.setSize({width:b,height:ex})}g(r)}return new ResizeObserver(v).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{t.forEach(({plot:p,box:d})=>(p.destroy(),d.remove())),t.clear()}),{replace:l,show:g,pin(p){n=p},lock(p){a=p},bounds:p=>t.get(p)?.bounds,curve:p=>t.get(p)?.panel.curves.map(d=>({name:d.name,peak:d.values.reduce((b,M)=>Math.max(b,M),0),points:d.values.length})),get flights(){return s}}}function GT(i,e,t,n){let s=n?Wd((e-i)/8,[1,2,5,10]):.02,r=[];for(let o=Math.ceil((i-t*!n)/s);;o++){let a=o*s+(n?0:t);if(a>e)return r;r.push(a)}}var rx=150,WT=700,XT=40;function ox(i,{choices:e,table:t,page:n,isShown:s,onPick:r,onChoice:o}){let a=new Map,l=null,c=null,u=null,h=null,f=0,m="",g=G("select",{id:"sweep-of","aria-label":"Control to sweep",onchange:E}),v=G("select",{id:"sweep-measure","aria-label":"Measure of the sweep",onchange:E},...e.measures.map(N=>G("option",{value:N.name},N.label)));v.value="impact_peak_acceleration";let p=G("div",{class:"plot-canvas"}),d=G("h3"),b=G("p",{class:"words",role:"status"});i.classList.add("sweep"),i.replaceChildren(G("div",{class:"sweep-head"},G("h2",{},"Sweep"),g,v),d,p,b),P();let M=N=>t.find(z=>z.name===N),y=()=>e.measures.find(N=>N.name===v.value);function P(){let N=g.value,z=e.controls.filter(ne=>s(ne.name)||ne.name===N),K=["",...z.map(ne=>ne.name)].join();g.dataset.names!==K&&(g.dataset.names=K,g.replaceChildren(G("option",{value:""},"off"),...z.map(ne=>G("option",{value:ne.name},ne.label))),g.value=N)}function E(){h=null,D(l,{}),o()}function I(N){return N.split("&").filter(z=>z&&z.split("=")[0]!==g.value).join("&")}function D(N,{moving:z=!1}){if(l=N,P(),clearTimeout(f),!l||!g.value)return A("");if(l.is_piloted)return A("Flights with a pilot are not swept here; a campaign can: springback campaign.");if(!s(g.value))return A("This control has no effect here.");let K=`${g.value}?${I(l.query)}`;a.has(K)?(c=a.get(K),S()):z||w(K),V(!a.has(K))}async function w(N){m=N;let[z,K]=N.split(/\?(.*)/s);b.textContent="Flying the sweep …";try{let ne=await fetch(`sweep?${[K,`of=${z}`].filter(Boolean).join("&")}`,{headers:{"x-lab-page":n}}),te=await ne.json();if(m!==N)return;if(ne.ok)a.size>=XT&&a.delete(a.keys().next().value),a.set(N,te),D(l,{});else if(ne.status===503){let le=te.preparing;b.textContent=le?`Compiling for ${le.what}, about ${le.about} s, once on this machine: ${Math.round(le.waited)} s so far.`:"Too many requests are waiting.",f=setTimeout(()=>w(N),WT)}else te.overtaken||A(te.errors.join(" "))}catch{b.textContent="The lab does not respond."}}function S(){let N=c.refusals.reduce((te,le)=>te+le.count,0),z=Object.keys(c.labels).length>1?c.labels:{},K=te=>Number(te.toPrecision(3)),ne=c.refusals.map(({robot:te,from:le,to:fe,why:ye})=>` ${z[te]?`${z[te]}, `:""}${le===fe?"":`${K(le)} to `}${K(fe)} ${M(c.of).unit}: ${ye}.`);b.textContent=N?`${N} of ${c.at.length*Object.keys(c.labels).length} points cannot be flown.${ne.join("")}`:`${c.at.length} flights for each robot in ${c.took.toFixed(0)} ms. A click sets the value.`}function A(N){m="",c=null,d.textContent="",u?.destroy(),u=null,b.textContent=N,i.classList.toggle("off",!g.value)}function k(){let N=l.measures.find(z=>z.name===v.value);return l.flights.map((z,K)=>({robot:z.robot,label:z.label,colour:Pn().robots[B(K)],dash:K?[8,3]:[],x:l.settings[g.value],y:N?.values[z.robot]??null}))}let B=N=>l.flights.length===1&&l.flights[0].robot==="quad"?1:N%2;function V(N){if(i.classList.remove("off"),!c||c.of!==g.value)return u&&(u.destroy(),u=null);let z=k(),K=M(g.value),ne=z.map(ye=>c.measures[v.value][ye.robot]??c.at.map(()=>null)),te=[...ne.flat(),...z.map(ye=>ye.y)].filter(ye=>ye!==null);h=Xd(h,Math.min(0,...te),Math.max(0,...te));let le=y();d.textContent=le.unit?`${le.label} [${le.unit}]`:le.label;let fe=JSON.stringify([K.name,v.value,z.map(ye=>[ye.label,ye.colour])]);u?.look!==fe&&W(K,z,fe),u.batch(()=>{u.setData([c.at,...ne],!1),u.setScale("x",{min:K.least,max:K.most}),u.setScale("y",{min:h[0],max:h[1]})}),u.points=z,p.classList.toggle("old",N),q()}function W(N,z,K){u?.destroy();let ne=Pn(),te={stroke:ne.faint,grid:{stroke:ne.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},le=N.unit?` [${N.unit.replace("^1.5","¹·⁵")}]`:"",fe={...te,size:24,gap:6,label:`${N.label}${le}`,labelSize:15,labelFont:te.font,labelGap:0};N.logarithmic&&Object.assign(fe,{splits:(ye,_e,ee,Y)=>qT(ee,Y),values:(ye,_e)=>_e.map(String),filter:(ye,_e)=>_e}),u=new Kt({width:Math.max(p.clientWidth,200),height:rx,padding:[8,12,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1,distr:N.logarithmic?3:1,range:[N.least,N.most]},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[fe,{...te,size:46,gap:4,space:26}],series:[{},...z.map(ye=>({stroke:ye.colour,width:1.8,dash:ye.dash,points:{show:!1}}))],hooks:{draw:[q]}},[[N.least,N.most],...z.map(()=>[null,null])],p),u.look=K,u.line=G("div",{class:"plot-now"}),u.dots=z.map(ye=>{let _e=G("div",{class:"sweep-point",title:ye.label});return _e.style.background=ye.colour,_e}),u.over.append(u.line,...u.dots),u.over.addEventListener("click",ye=>r(N.name,u.posToVal(ye.offsetX,"x")))}function q(){if(!u?.points)return;let N=y();u.line.style.transform=`translateX(${u.valToPos(u.points[0].x,"x")}px)`,u.points.forEach(({x:z,y:K,label:ne},te)=>{let le=u.dots[te];le.hidden=K===null,K!==null&&(le.title=`${ne}: ${Number(K.toPrecision(4))} ${N.unit}`,le.style.transform=`translate(${u.valToPos(z,"x")}px, ${u.valToPos(K,"y")}px)`)})}return new ResizeObserver(()=>{let N=p.clientWidth;u&&N&&Math.abs(N-u.width)>1&&u.setSize({width:N,height:rx})}).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>l&&D(l,{})),{show:D,hash:()=>g.value?`#sweep=${g.value},${v.value}`:"",restore(N){let[z,K]=(N.match(/^#sweep=([a-z_]+),([a-z_]+)$/)??[]).slice(1),ne=(te,le)=>te.some(fe=>fe.name===le);g.dataset.names="",g.replaceChildren(G("option",{value:""},"off"),...e.controls.map(te=>G("option",{value:te.name},te.label))),g.value=ne(e.controls,z)?z:"",ne(e.measures,K)&&(v.value=K),h=null,l&&D(l,{})},state:()=>({of:g.value,measure:v.value,curve:c,points:u?.points??[],bounds:h,words:b.textContent})}}function qT(i,e){let t=[];for(let n=Math.floor(Math.log10(i));n<=Math.log10(e);n++)for(let s of[1,2,5]){let r=Number((s*10**n).toPrecision(3));r>=i&&r<=e&&t.push(r)}return t}var qd=i=>{if(i==null)return"–";if(typeof i=="string")return i;let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)};function ax(i){function e(t,n,s){let r=t.flights.map(m=>[m.robot,m.label]),o=m=>n?.flights.some(g=>g.robot===m),a=t.measures.some(m=>Object.keys(m.printed).length),l=G("tr",{},G("th",{},""));for(let[m,[g,v]]of r.entries()){let p=G("th",{scope:"col"},v);p.style.color=s[m],l.append(p),a&&l.append(G("th",{scope:"col",class:"printed"},"paper")),o(g)&&l.append(G("th",{scope:"col",class:"pinned"},"pinned"))}let c=t.measures.map(m=>{let g=n?.measures.find(p=>p.name===m.name),v=G("tr",{"data-measure":m.name},G("th",{scope:"row"},m.label,...m.unit?[G("small",{},` ${m.unit}`)]:[]));for(let[p]of r){let d=[a&&m.printed[p]?`paper ${m.printed[p]}`:"",o(p)?`pinned ${qd(g?.values[p])}`:""];v.append(G("td",{"data-robot":p,"data-beside":d.filter(Boolean).join(", ")},G("b",{},qd(m.values[p])))),a&&v.append(G("td",{class:"printed"},m.printed[p]??"")),o(p)&&v.append(G("td",{class:"pinned"},qd(g?.values[p])))}return v}),{words:u,same:h}=t.printed_for,f=a?[G("p",{class:h?"note":"note other"},h?u:`${u} The settings here differ.`)]:[];i.replaceChildren(G("table",{},G("thead",{},l),G("tbody",{},...c)),...f),i.classList.toggle("elsewhere",!h)}return{show:e}}var lx={impact:"Impact",follow:"Follow",side:"Side",top:"Top",free:"All"},YT=.012,$T=350;function cx(i,e){let t=Math.random().toString(36).slice(2),n=null,s=null,r=!1,o=[],a=jv(e.controls,le),l=G("div",{class:"outcomes","aria-live":"polite"}),c=G("p",{class:"alert",role:"alert",hidden:!0}),u=G("input",{class:"link",readonly:!0,"aria-label":"Link to these settings",id:"link",onfocus:()=>u.select()}),h=G("button",{type:"button",id:"copy",onclick:be},"Copy link"),f=G("button",{type:"button",id:"pin","aria-pressed":"false",title:"Keep this flight behind the next ones for comparison",onclick:Ce},"Pin"),m=G("button",{type:"button",id:"reset",title:e.file?`Return to ${e.file}`:"Return to the paper's slider test",onclick:()=>oe("",{push:!0})},"Reset"),g=G("span",{class:"files"}),v=G("div",{class:"stage"}),p=G("div",{class:"preparing",role:"status",hidden:!0}),d=G("div"),b=G("div"),M=G("div",{class:"measures"}),y=G("div"),P=G("button",{type:"button",id:"lock","aria-pressed":"false",title:"Keep the vertical scales of all plots as they are",onclick:pe},"Lock y"),E=G("p",{class:"took"}),I=G("button",{type:"button",class:"drawer",id:"drawer","aria-expanded":"false",onclick:()=>ot(!i.classList.contains("open"))},"Settings"),D=Si("Camera",Vo.filter(ae=>lx[ae]).map(ae=>[ae,lx[ae]]),"impact",ae=>V.setCamera(ae)),w=Si("Two robots",[["side","side by side"],["ghost","overlaid"]],"side",ae=>V.setCompare(ae)),S=G("h2"),A=Si("Plots show",[["impact","impact"],["all","all"]],"impact",ae=>{r=ae==="all",n&&_e()}),k=Ml(()=>B,()=>xe(["This browser refuses full screen."])),B=G("div",{class:"middle"},G("div",{class:"frame"},v,G("div",{class:"views"},D,w,k.button),p),d,M);i.classList.add("lab"),i.replaceChildren(G("header",{class:"top"},G("div",{class:"said"},G("h1",{},"Impact lab",...e.file?[G("small",{},e.file)]:[]),l,c),G("div",{class:"actions"},f,m,g,G("span",{class:"linking"},u,h))),G("main",{},G("aside",{class:"settings",id:"settings"},a.element,E),B,G("aside",{class:"curves"},y,G("div",{class:"plot-head"},S,P,A),b)),I);let V=au(v,{onCamera:ae=>D.mark(ae)}),W=sx(b,{onSeek:ae=>(q.pause(),q.seek(ae))}),q=Yh({scene:V,plots:{show:W.show,replace:()=>_e()},bar:d,actions:{f:k.toggle}}),N=ax(M),z=ox(y,{choices:e.sweeps,table:e.controls,page:t,isShown:a.isShown,onPick:a.pick,onChoice:()=>n&&ht(n.query,{settled:!0})}),K=Qv(t,{answered:fe,refused:we,waits:Ve,gone:dt}),ne=0,te=!1;function le(ae,Le,ce){clearTimeout(ne);let ue=()=>K.ask(a.query(),{...ce,since:performance.now()});ce.typing?ne=setTimeout(ue,$T):ue()}function fe(ae,Le){let ce=n;n=ae,i.classList.add("ready"),Le.aside||xe([]),p.hidden=!0,!Le.typing&&!Le.older?a.show(ae.settings):a.tellProblems([]);let ue=!ce||ce.settings.mode!==ae.settings.mode,C=ae.flights.length!==ce?.flights.length,_=ae.flights.flatMap(F=>F.second?[F.second]:[]);V.replace([...ae.flights.map(F=>F.scene),..._],{keepCamera:!ue&&!C}),w.hidden=ae.flights.length<2,ue&&A.mark((r=ae.is_piloted)?"all":"impact"),te=!!Le.moving,q.replace({keepTime:!ue}),ue&&ye(),ee(),Y(),z.show(ae,Le),g.replaceChildren(...ae.flights.map(F=>G("a",{class:"button",href:`scenario.toml?${[ae.query,`of=${F.robot}`].filter(Boolean).join("&")}`,download:F.file,title:`Scenario for springback fly, ${F.label}`},`${F.label}.toml`))),ht(ae.query,Le),requestAnimationFrame(()=>{let F=performance.now()-Le.since;o.push(F),E.textContent=`Flown in ${ae.took.flying.toFixed(0)} ms, answered in ${ae.took.all.toFixed(0)} ms, drawn after ${F.toFixed(0)} ms.`})}function ye(){let ae=Cs(V.flights[0]),Le=!n.is_piloted,ce=Le?"impact":"follow";D.mark(ce),V.setCamera(ce),q.seek(ae===null?V.flights[0].begin:Le?ae+YT:ae)}function _e(){n&&(S.textContent=r?"Time [s]":"Time from touch [ms]",W.replace(V.flights,{whole:r,moving:te}))}function ee(){l.replaceChildren(...n.flights.map((ae,Le)=>{let ce=G("p",{class:`outcome ${ae.well?"well":"badly"}`},G("b",{},ae.label),ae.sentence.slice(ae.label.length));return ce.style.setProperty("--colour",V.flights[Le].colour),ce}))}let Y=()=>N.show(n,s,V.flights.map(ae=>ae.colour));function pe(){let ae=P.getAttribute("aria-pressed")!=="true";P.setAttribute("aria-pressed",String(ae)),W.lock(ae),_e()}function xe(ae){c.hidden=!ae.length,c.textContent=ae.join(" ")}function we(ae,Le){p.hidden=!0,a.tellProblems(ae),xe([...ae.map(ce=>`${ce}.`),n?"The previous flight is shown.":"The default flight is shown instead."]),n||K.ask("",{since:performance.now(),aside:!0})}function Ve(ae){p.hidden=!1,p.replaceChildren(G("progress",{}),G("p",{},`Compiling for ${ae.what}, about ${ae.about} s: ${Math.round(ae.waited)} s so far.`),G("p",{class:"words"},`Once on this machine; ${n?"the previous flight stays, and ":""}other settings can be flown meanwhile if they are ready.`))}function dt(){xe(["The lab does not respond; it may have been stopped in its terminal. Any change tries again."])}let H=!1;function ht(ae,{settled:Le=!1,aside:ce=!1,restored:ue=!1}){let C=`${location.pathname}${ae?`?${ae}`:""}${z.hash()}`;u.value=location.origin+C,!(ce||ue)&&(`${location.pathname}${location.search}${location.hash}`!==C&&(H?history.replaceState(null,"",C):history.pushState(null,"",C)),H=!Le)}function oe(ae,{push:Le=!1}={}){a.showQuery(ae),K.ask(ae,{since:performance.now(),settled:Le,restored:!Le})}addEventListener("popstate",()=>(z.restore(location.hash),oe(location.search.slice(1))));async function be(){try{await navigator.clipboard.writeText(u.value)}catch{u.select(),document.execCommand("copy")}h.textContent="Copied",setTimeout(()=>h.textContent="Copy link",1500)}function Ce(){s=s?null:n,f.setAttribute("aria-pressed",String(!!s)),f.textContent=s?"Unpin":"Pin";let ae=s?Hd(s.flights.map(Le=>({...Le.scene})),Pn()):[];W.pin(ae),_e(),Y()}function ot(ae){i.classList.toggle("open",ae),I.setAttribute("aria-expanded",String(ae)),I.textContent=ae?"Done":"Settings",ae&&v.scrollIntoView({block:"start"})}return z.restore(location.hash),oe(location.search.slice(1)),window.springback={scene:V,player:q,plots:W,controls:a,sweep:z,latency:o,pose:()=>({...V.pose(),playing:q.playing,pace:q.pace}),get answer(){return n}},window.springback}var ZT={replay:Zv,lab:cx};function hx(){let i=ZT[document.body.dataset.app],e=document.getElementById("data");i&&i(document.getElementById("app"),e?JSON.parse(e.textContent):{})}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",hx):hx();})();
