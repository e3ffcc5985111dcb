/*! springback, MIT licence; sources d7a8fc0547c54ecc42786886b1f02851ac20130d44b83ac3a6a29433c3d15e36

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
(()=>{var pp=i=>{throw TypeError(i)};var Dx=(i,e,t)=>e.has(i)||pp("Cannot "+t);var xl=(i,e,t)=>e.has(i)?pp("Cannot add the same private member more than once"):e instanceof WeakSet?e.add(i):e.set(i,t);var Cn=(i,e,t)=>(Dx(i,e,"access private method"),t);function X(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==!1&&r!=null&&n.setAttribute(s,r);return n.append(...t),n}var Ux={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",back:"M18 5v14l-9.5-7zM5.5 5h2.4v14H5.5z",forth:"M6 5v14l9.5-7zM16.1 5h2.4v14h-2.4z",touch:"M4 4h3v16H4zM20 12l-9 6V6z",link:"M10.6 13.4a4 4 0 0 0 5.7 0l3-3a4 4 0 1 0-5.7-5.7l-1.6 1.6 1.4 1.4 1.6-1.6a2 2 0 1 1 2.9 2.9l-3 3a2 2 0 0 1-2.9 0zm2.8-2.8a4 4 0 0 0-5.7 0l-3 3a4 4 0 1 0 5.7 5.7l1.6-1.6-1.4-1.4-1.6 1.6a2 2 0 1 1-2.9-2.9l3-3a2 2 0 0 1 2.9 0z",picture:"M4 7h4l1.5-2.5h5L16 7h4v12H4zm8 2.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zm0 1.8a1.7 1.7 0 1 1 0 3.4 1.7 1.7 0 0 1 0-3.4z",undo:"M9 4 3.5 9.5 9 15v-4h5a3.5 3.5 0 0 1 0 7h-4v2.2h4a5.7 5.7 0 0 0 0-11.4H9z",film:"M3 6h12v12H3zM16.5 10.5 21 7.5v9l-4.5-3z",full:"M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z",help:"M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 12.5h2v2h-2zm1-9c-2 0-3.5 1.3-3.5 3.2h2c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.4-2.5 1.6-2.5 4.1v.3h2v-.2c0-1.4 2.5-1.8 2.5-4.3 0-1.8-1.5-3-3.5-3z"};function Yi(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Ux[i]),t.setAttribute("fill-rule","evenodd"),e.append(t),e}function Si(i,e,t,n){let s=X("div",{class:"choice",role:"group","aria-label":i});for(let[a,l]of e)s.append(X("button",{type:"button","data-value":a,"aria-pressed":String(a===t),onclick:()=>{r(a),n(a)}},l));function r(a){for(let l of s.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))}let o=a=>(r(a),n(a));return Object.defineProperty(s,"chosen",{get:()=>s.querySelector("[aria-pressed=true]")?.dataset.value}),Object.assign(s,{mark:r,press:o})}function tr(i,e){let[t]=i.children;t.disabled=e.tooWide,t.title=t.disabled?"The obstacles are too wide to be put side by side.":"",i.mark(e.compared)}function mp(i,e,t,n=""){let s=X("button",{type:"button",title:n,"aria-pressed":String(e),onclick:()=>{s.setAttribute("aria-pressed",String(!s.on)),t(s.on)}},i);return Object.defineProperty(s,"on",{get:()=>s.getAttribute("aria-pressed")==="true"}),s}var Nx=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"],Fx=30;function gp(i,e){let t=X("a",{href:URL.createObjectURL(i),download:e});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function bu(i,e,t,n=null){let s=e.getBoundingClientRect(),r=getComputedStyle(e);if(!s.width)return;let[o,a]=[s.left-t.left,s.top-t.top];i.fillStyle=r.backgroundColor,i.fillRect(o,a,s.width,s.height);let l=o+parseFloat(r.paddingLeft);if(n&&parseFloat(n.width)>0){let c=parseFloat(n.height);i.fillStyle=n.backgroundColor,i.fillRect(l,a+(s.height-c)/2,parseFloat(n.width),c),l+=parseFloat(n.width)+parseFloat(n.marginRight)}i.font=`${r.fontWeight} ${r.fontSize} ${r.fontFamily}`,i.textBaseline="middle",i.fillStyle=r.color,i.fillText(e.textContent,l,a+s.height/2+1,o+s.width-l)}function vp({scene:i,stage:e,player:t,name:n,say:s,onRecording:r=()=>{}}){let o=X("div",{class:"stage-clock","aria-hidden":"true"});e.append(o);let a=null,l=null;function c(){let m=Math.min(devicePixelRatio||1,2),g=X("canvas",{width:2*Math.round(e.clientWidth*m/2),height:2*Math.round(e.clientHeight*m/2)});return{canvas:g,pen:g.getContext("2d"),ratio:m}}function u({canvas:m,pen:g,ratio:v},p){o.textContent=`${i.pose().t.toFixed(4)} s`;let d=e.getBoundingClientRect();g.setTransform(1,0,0,1,0,0),g.drawImage(p,0,0,m.width,m.height),g.scale(v,v);let y=e.querySelector(".scene-legend"),b=y.getBoundingClientRect();g.fillStyle=getComputedStyle(y).backgroundColor,g.fillRect(b.left-d.left,b.top-d.top,b.width,b.height);for(let _ of y.children)bu(g,_,d,getComputedStyle(_,"::before"));for(let _ of e.querySelectorAll(".force-labels span:not([hidden])"))bu(g,_,d);bu(g,o,d)}function h(){let m=i.canvas();if(!m)return s("There is no picture without WebGL.");let g=c();u(g,m),g.canvas.toBlob(v=>{gp(v,`${n}-${i.pose().t.toFixed(4)}s.png`),s("The picture is among your downloads.")})}function f(){if(a)return a.stop();let m=window.MediaRecorder&&Nx.find(v=>MediaRecorder.isTypeSupported(v));if(!m||!i.canvas()||!HTMLCanvasElement.prototype.captureStream)return s("This browser cannot record films. The command springback animate RESULT --out film.gif makes one, or film.mp4.");l=c(),u(l,i.canvas());let g=[];a=new MediaRecorder(l.canvas.captureStream(Fx),{mimeType:m,videoBitsPerSecond:12e6}),a.ondataavailable=v=>g.push(v.data),a.onstop=()=>{[a,l]=[null,null],t.pause(),r(!1),gp(new Blob(g,{type:m}),`${n}.${m.includes("mp4")?"mp4":"webm"}`),s("The film is among your downloads. springback animate makes one without dropped frames.")},a.start(),r(!0),t.play()}return{picture:h,film:f,drawn(){l&&u(l,i.canvas(!1))},rested(){a?.state==="recording"&&!t.playing&&a.stop()},get recording(){return!!a}}}var Ox=()=>matchMedia("(prefers-color-scheme: dark)").matches,Bx={background:"#f3f5f8",ink:"#222222",faint:"#8c8c8c",line:"#c3cad4",wall:"#7d8794",shapes:["#7d8794","#94806a","#6f8f7c","#8b7a99","#6b8fa3","#a3827f"],mat:"#009e73",ground:"#a8aeb7",metal:"#5b6470",dark:"#30363d",arms:["#0072b2","#d98a00","#009e73","#cc79a7","#3a9bd9","#8c8c8c"],robots:["#0072b2","#d55e00","#007a5a","#a8488a","#8a6d00","#1b2a6b","#6b6b6b","#7a1f1f"],force:"#e69f00",thrust:"#56b4e9",before:"#8c8c8c"},zx={background:"#14181d",ink:"#e6e9ed",faint:"#9aa3ad",line:"#3a434e",wall:"#98a3b1",shapes:["#98a3b1","#b5a089","#8db39b","#ac9abd","#88b0c6","#c4a19d"],mat:"#2cc79a",ground:"#59626d",metal:"#aab4c0",dark:"#cdd4dc",arms:["#4ea8e0","#f0b429","#35c79b","#e29cc4","#8fd0f5","#a7b0ba"],robots:["#4ea8e0","#ff8a3d","#35c79b","#e29cc4","#e3cf57","#a9b4ff","#c9d1d9","#ff8f8f"],force:"#ffc13d",thrust:"#7cc8f2",before:"#a7b0ba"},Pn=()=>Ox()?zx:Bx;var mi=Uint8Array,Hr=Uint16Array,kx=Int32Array,xp=new mi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),_p=new mi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Hx=new mi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),yp=function(i,e){for(var t=new Hr(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new kx(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},bp=yp(xp,2),Mp=bp.b,Vx=bp.r;Mp[28]=258,Vx[258]=28;var wp=yp(_p,0),Gx=wp.b,hA=wp.r,Su=new Hr(32768);for(Et=0;Et<32768;++Et)ls=(Et&43690)>>1|(Et&21845)<<1,ls=(ls&52428)>>2|(ls&13107)<<2,ls=(ls&61680)>>4|(ls&3855)<<4,Su[Et]=((ls&65280)>>8|(ls&255)<<8)>>1;var ls,Et,Ko=(function(i,e,t){for(var n=i.length,s=0,r=new Hr(e);s<n;++s)i[s]&&++r[i[s]-1];var o=new Hr(e);for(s=1;s<e;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(t){a=new Hr(1<<e);var l=15-e;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],u=e-i[s],h=o[i[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[Su[h]>>l]=c}else for(a=new Hr(n),s=0;s<n;++s)i[s]&&(a[s]=Su[o[i[s]-1]++]>>15-i[s]);return a}),Jo=new mi(288);for(Et=0;Et<144;++Et)Jo[Et]=8;var Et;for(Et=144;Et<256;++Et)Jo[Et]=9;var Et;for(Et=256;Et<280;++Et)Jo[Et]=7;var Et;for(Et=280;Et<288;++Et)Jo[Et]=8;var Et,Sp=new mi(32);for(Et=0;Et<32;++Et)Sp[Et]=5;var Et;var Wx=Ko(Jo,9,1);var Xx=Ko(Sp,5,1),Mu=function(i){for(var e=i[0],t=1;t<i.length;++t)i[t]>e&&(e=i[t]);return e},Ei=function(i,e,t){var n=e/8|0;return(i[n]|i[n+1]<<8)>>(e&7)&t},wu=function(i,e){var t=e/8|0;return(i[t]|i[t+1]<<8|i[t+2]<<16)>>(e&7)},qx=function(i){return(i+7)/8|0},Yx=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new mi(i.subarray(e,t))};var $x=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Ti=function(i,e,t){var n=new Error(e||$x[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Ti),!t)throw n;return n},Zx=function(i,e,t,n){var s=i.length,r=n?n.length:0;if(!s||e.f&&!e.l)return t||new mi(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new mi(s*3));var c=function(We){var ut=t.length;if(We>ut){var H=new mi(Math.max(ut*2,We));H.set(t),t=H}},u=e.f||0,h=e.p||0,f=e.b||0,m=e.l,g=e.d,v=e.m,p=e.n,d=s*8;do{if(!m){u=Ei(i,h,1);var y=Ei(i,h+1,3);if(h+=3,y)if(y==1)m=Wx,g=Xx,v=9,p=5;else if(y==2){var E=Ei(i,h,31)+257,P=Ei(i,h+10,15)+4,L=E+Ei(i,h+5,31)+1;h+=14;for(var M=new mi(L),S=new mi(19),A=0;A<P;++A)S[Hx[A]]=Ei(i,h+A*3,7);h+=P*3;for(var k=Mu(S),O=(1<<k)-1,V=Ko(S,k,1),A=0;A<L;){var q=V[Ei(i,h,O)];h+=q&15;var b=q>>4;if(b<16)M[A++]=b;else{var $=0,N=0;for(b==16?(N=3+Ei(i,h,3),h+=2,$=M[A-1]):b==17?(N=3+Ei(i,h,7),h+=3):b==18&&(N=11+Ei(i,h,127),h+=7);N--;)M[A++]=$}}var z=M.subarray(0,E),Q=M.subarray(E);v=Mu(z),p=Mu(Q),m=Ko(z,v,1),g=Ko(Q,p,1)}else Ti(1);else{var b=qx(h)+4,_=i[b-4]|i[b-3]<<8,C=b+_;if(C>s){l&&Ti(0);break}a&&c(f+_),t.set(i.subarray(b,C),f),e.b=f+=_,e.p=h=C*8,e.f=u;continue}if(h>d){l&&Ti(0);break}}a&&c(f+131072);for(var ie=(1<<v)-1,ne=(1<<p)-1,ce=h;;ce=h){var $=m[wu(i,h)&ie],he=$>>4;if(h+=$&15,h>d){l&&Ti(0);break}if($||Ti(2),he<256)t[f++]=he;else if(he==256){ce=h,m=null;break}else{var Me=he-254;if(he>264){var A=he-257,Ee=xp[A];Me=Ei(i,h,(1<<Ee)-1)+Mp[A],h+=Ee}var te=g[wu(i,h)&ne],K=te>>4;te||Ti(3),h+=te&15;var Q=Gx[K];if(K>3){var Ee=_p[K];Q+=wu(i,h)&(1<<Ee)-1,h+=Ee}if(h>d){l&&Ti(0);break}a&&c(f+131072);var ve=f+Me;if(f<Q){var _e=r-Q,Ae=Math.min(Q,ve);for(_e+f<0&&Ti(3);f<Ae;++f)t[f]=n[_e+f]}for(;f<ve;++f)t[f]=t[f-Q]}}e.l=m,e.p=ce,e.b=f,e.f=u,m&&(u=1,e.m=v,e.d=g,e.n=p)}while(!u);return f!=t.length&&o?Yx(t,0,f):t.subarray(0,f)};var Kx=new mi(0);var Jx=function(i,e){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Ti(6,"invalid zlib data"),(i[1]>>5&1)==+!e&&Ti(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function Ep(i,e){return Zx(i.subarray(Jx(i,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var jx=typeof TextDecoder<"u"&&new TextDecoder,Qx=0;try{jx.decode(Kx,{stream:!0}),Qx=1}catch{}var Tp=i=>Uint8Array.from(atob(i),e=>e.charCodeAt(0));function e_(i,e){let t=Ep(Tp(i.data));return i.columns.map(({low:n,step:s},r)=>{let o=2*e*r,a=new Float64Array(e);for(let l=0,c=0;l<e;l++)c=c+t[o+l]+256*t[o+e+l]&65535,a[l]=n+s*c;return a})}function Ap(i){let e=new Map;if(!i)return e;for(let t of["trajectory","telemetry"].filter(n=>i[n])){let n=i[t],s=new Float64Array(Tp(n.t.data).buffer),r=null,o=[];n.columns.forEach(({name:a,unit:l,factor:c,group:u},h)=>e.set(a,{name:a,unit:l,group:u,t:s,held:t==="telemetry",words:i.words[a],get values(){return r??(r=e_(n,s.length)),r[h]},get shown(){return o[h]??(o[h]=c===1?this.values:this.values.map(f=>c*f)),o[h]}}))}return e}var t_={f4:Float32Array,f8:Float64Array,i4:Int32Array};function Zt(i){let e=Uint8Array.from(atob(i.data),t=>t.charCodeAt(0));return new t_[i.type](e.buffer)}function Rp(i){if(i.ready)return i;let e=Zt(i.t),t=Zt(i.force.at),n=new Int32Array(e.length).fill(-1);return t.forEach((s,r)=>n[s]=r),{...i,ready:!0,t:e,n:e.length,begin:e[0],end:e[e.length-1],position:Zt(i.position),attitude:Zt(i.attitude),armLength:Zt(i.arm_length),bends:Zt(i.bends),thrust:Zt(i.thrust),force:Zt(i.force.of),point:Zt(i.point.of),bodies:i.bodies.map(s=>({...s,position:Zt(s.position),attitude:Zt(s.attitude)})),rows:n,series:i.series.map(s=>({...s,values:Zt(s.values)})),signals:Ap(i.signals),every:i.signals?.telemetry?.every??1,shift:0}}function _l(i,e){let t=0,n=i.length-1;if(!(e>i[0]))return 0;for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return i[n]<=e?n:t}function jo(i,e){let t=Math.min(Math.max(e-i.shift,i.begin),i.end),n=_l(i.t,t),s=Math.min(n+1,i.n-1),r=s>n?(t-i.t[n])/(i.t[s]-i.t[n]):0,o=(g,v,p)=>g[n*v+p]*(1-r)+g[s*v+p]*r,a=(g,v)=>Array.from({length:v},(p,d)=>o(g,v,d)),l=i.arms.length,c=g=>{let v=a(g,4),p=0;for(let y=0;y<4;y++)p+=g[n*4+y]*g[s*4+y];if(p<0)for(let y=0;y<4;y++)v[y]=g[n*4+y];let d=Math.hypot(...v);return v.map(y=>y/d)},u=i.rows[n],h=i.rows[s],f=[],m=i.part.length;for(let g=0;g<m;g++){let v=[0,0,0],p=null;for(let[y,b]of[[u,1-r],[h,r]]){if(y<0)continue;let _=(y*m+g)*3;for(let E=0;E<3;E++)v[E]+=b*i.force[_+E];let C=Array.from(i.point.subarray(_,_+3));C.some(E=>E!==0)&&(p=C)}let d=Math.hypot(...v);f.push(p&&d>1e-6?{part:i.part[g],force:v,size:d,point:p}:null)}return{t:t+i.shift,own:t,place:n,position:a(i.position,3),quaternion:c(i.attitude),armLengths:a(i.armLength,l),bends:i.bends.length?a(i.bends,l):[],thrust:a(i.thrust,i.rotors.length),contacts:f,bodies:i.bodies.map(g=>({position:a(g.position,3),quaternion:c(g.attitude)}))}}function Qo({flight:i,t:e=i.t,values:t,held:n=!1},s){let r=Math.min(Math.max(s-i.shift,e[0]),e[e.length-1]),o=_l(e,r),a=n?o:Math.min(o+1,e.length-1),l=a>o?(r-e[o])/(e[a]-e[o]):0;return t[o]*(1-l)+t[a]*l}var Vr=i=>["est_x","est_qw"].every(e=>i.signals.has(e));function Eu(i,e){let t=(r,o)=>{let a=i.signals.get(r);return a?Qo({flight:i,...a,values:a.values},e):o},n=["w","x","y","z"].map(r=>t(`est_q${r}`)),s=Math.hypot(...n)||1;return{own:Math.min(Math.max(e-i.shift,i.begin),i.end),position:["x","y","z"].map(r=>t(`est_${r}`)),quaternion:n.map(r=>r/s),armLengths:i.arms.map((r,o)=>t(`hall${o+1}`,r.length)),bends:[],thrust:i.rotors.map(()=>0),contacts:[]}}function Cs(i){let e=i.first_touch??i.impacts[0]?.[0]??null;return e===null?null:e+i.shift}function Cp(i,e){let t=i.impacts.map(([n])=>n+i.shift).filter(n=>n<=e);return t.length?t[t.length-1]:null}var yl=i=>i.map(Cs).find(e=>e!==null)??null;function Tu(i){let e=0;for(let t=0;t<i.force.length;t+=3)e=Math.max(e,Math.hypot(i.force[t],i.force[t+1],i.force[t+2]));return e}function Pp(i){let e=i.part.length;return Float32Array.from(i.rows,t=>{let n=[0,0,0];for(let s=0;t>=0&&s<3*e;s++)n[s%3]+=i.force[t*e*3+s];return Math.hypot(...n)})}function Au(i){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));return e*([5,2,1].find(t=>t*e<=i*1.0000001)??1)}var n_=.005,Gr=[[],[7,3],[2,3],[9,3,2,3],[12,4],[4,2,1,2],[14,3,2,3],[3,6]],Ip={"Arm compression":["largest",i=>Math.max(...i)],Thrust:["all rotors",i=>i.reduce((e,t)=>e+t,0)],Velocity:["speed",i=>i[0]],Energy:["motion",i=>i[0]],"Contact force":["sum of all contacts"]},nr=i=>[...new Set(i.flatMap(e=>e.series.map(t=>t.panel)))],bl=i=>new Map(i.flatMap(e=>[...e.signals])),ea=i=>i.map(e=>Array.isArray(e)?e.join():e).join(";");function Ru(i,e){let t=nr(e),n=bl(e);return i.split(";").flatMap(s=>t.includes(s)?[s]:Ml(s.split(",").filter(r=>n.has(r)),n))}function Ml(i,e){let t=new Map;for(let n of new Set(i)){let{unit:s,words:r}=e.get(n),o=r?n:s;t.set(o,[...t.get(o)??[],n])}return[...t.values()]}function Lp(i,e){return e.map(t=>Array.isArray(t)?s_(i,t):i_(i,t)).filter(t=>t.curves.length)}function i_(i,e){let t=Pn(),n=i.map(o=>o.series.filter(a=>a.panel===e)),s=i.length>1?n.flatMap((o,a)=>r_(e,o,i[a])):o_(n[0]);s.forEach((o,a)=>{o.flight??(o.flight=i[0]),o.t=o.flight.t,o.colour??(o.colour=t.arms[a%t.arms.length]),o.dash??(o.dash=Gr[a%Gr.length])});let r=i.length>1?Ip[e]?.[0]:"";return{key:e,name:r?`${e}, ${r}`:e,unit:n.flat()[0]?.unit,own:null,curves:s}}function s_(i,e){let t=Pn(),n=bl(i),s=i.length>1,r=e.flatMap((c,u)=>i.flatMap(h=>{let f=h.signals.get(c);if(!f)return[];let{t:m,shown:g,held:v}=f,p=s&&e.length===1?h.index:u;return[{name:s?e.length===1?h.label:`${h.label}, ${c}`:c,flight:h,t:m,values:g,held:v,dash:Gr[p%Gr.length],colour:s?h.colour:t.arms[u%t.arms.length]}]})),o=e.map(c=>n.get(c)),a=new Set(o.map(c=>c?.group)),l=e.length===1?e[0]:a.size===1?o[0].group:e.slice(0,3).join(", ")+(e.length>3?", …":"");return{key:e.join(),name:l,unit:o[0]?.unit,own:e,words:o[0]?.words,curves:r}}function r_(i,e,t){if(!e.length)return[];let[,n]=Ip[i]??["",r=>r[0]],s=i==="Contact force"?Pp(t):Float32Array.from(e[0].values,(r,o)=>n(e.map(a=>a.values[o])));return[{name:t.label,values:s,flight:t,colour:t.colour,dash:Gr[t.index%Gr.length]}]}function o_(i){let e=[];for(let t of i){let n=t.values.reduce((r,o)=>Math.max(r,Math.abs(o)),0),s=e.find(r=>{let o=n_*Math.max(n,r.peak);return r.values.every((a,l)=>Math.abs(a-t.values[l])<=o)});s?s.names.push(t.name):e.push({names:[t.name],values:t.values,peak:n})}return e.map(({names:t,values:n})=>({name:a_(t),values:n}))}function a_(i){let e=i.map(t=>t.match(/^(.*?)\s*(\d+)$/));return i.length<2||e.some(t=>!t||t[1]!==e[0][1])?i.join(", "):`${e[0][1]} ${e.map(t=>t[2]).join(", ")}`}function Dp({signals:i,standard:e,onChoose:t}){let n=X("input",{type:"search",placeholder:"est, N, phase, …","aria-label":"Search signals",oninput:y}),s=X("h2",{id:"chooser-title"}),r=X("span",{class:"count",role:"status"}),o=(E,P,L)=>X("label",{"data-words":`${E} ${P}`.toLowerCase()},X("input",{type:"checkbox",value:E,onchange:b}),E,...L?[X("small",{},L)]:[]),a=(E,...P)=>{let L=X("fieldset",{},X("legend",{},E),...P);return P.length>1&&L.firstChild.append(X("button",{type:"button",class:"small","aria-label":`All of ${E}, or none`,onclick:()=>{let M=[...L.querySelectorAll("label:not([hidden]) input")],S=!M.every(A=>A.checked);M.forEach(A=>A.checked=S),b()}},"all")),L},l=a("Standard plots",...e.map(E=>o(E,"standard"))),c=new Map;for(let{name:E,unit:P,group:L}of i.values()){let M=[L,P,P==="m/s²"?"acceleration":""].join(" ");c.set(L,[...c.get(L)??[],o(E,M,P)])}let u=X("div",{class:"signals"},l,...[...c].map(([E,P])=>a(E,...P))),h=X("p",{hidden:!0},"No signal of this flight matches."),f=X("form",{method:"dialog",onsubmit:_},s,X("p",{class:"hint"},"Signals of one unit share a plot. Names are those of the columns in the files of the result."),n,u,h,X("div",{class:"actions"},r,X("button",{type:"button",onclick:()=>(t(null),m.close())},"Only standard plots"),X("button",{type:"button",onclick:()=>m.close()},"Cancel"),X("button",{type:"submit",class:"main"},"Plot"))),m=X("dialog",{class:"chooser","aria-labelledby":"chooser-title"},f),g=[],v=null,p=E=>[...E.querySelectorAll("input[type=checkbox]:checked")].map(P=>P.value),d=()=>[...u.children].filter(E=>E!==l).flatMap(p);function y(){let E=n.value.toLowerCase().split(/\s+/).filter(Boolean);for(let P of u.children){let L=[...P.querySelectorAll("label")];L.forEach(M=>M.hidden=!E.every(S=>M.dataset.words.includes(S))),P.hidden=L.every(M=>M.hidden)||P===l&&v!==null}h.hidden=[...u.children].some(P=>!P.hidden)}function b(){let E=d(),P=Ml(E,i).length;r.textContent=E.length?`${E.length} signal${E.length>1?"s":""} in ${P} plot${P>1?"s":""}`:""}function _(){let E=Ml(d(),i);if(v!==null)t(g.flatMap((P,L)=>L===v?E:[P]));else{let P=p(l),L=g.filter(M=>Array.isArray(M)||P.includes(M));t([...L,...P.filter(M=>!g.includes(M)),...E])}}function C(E,P=null){[g,v]=[E,P];let L=P===null?E.filter(M=>!Array.isArray(M)):E[P];u.querySelectorAll("input").forEach(M=>M.checked=L.includes(M.value)),s.textContent=P===null?"Add plots":"Change a plot",n.value="",y(),b(),m.showModal(),n.focus()}return{element:m,open:C}}function wl(i,e){let t=()=>document.fullscreenElement?document.exitFullscreen():i().requestFullscreen().catch(e),n=X("button",{type:"button",class:"tool tool-full",hidden:!document.fullscreenEnabled,onclick:t},Yi("full"));function s(){let r=document.fullscreenElement?"Leave full screen":"Full screen";n.title=`${r} (F)`,n.setAttribute("aria-label",r)}return document.addEventListener("fullscreenchange",s),s(),{button:n,toggle:t}}function Up({read:i,apply:e}){let t=0,n=location.hash,s=()=>{let a=Object.entries(i()).filter(([,l])=>l!=="");return`#${new URLSearchParams(a)}`.replace(/%2C/g,",").replace(/%3B/g,";")};function r(){clearTimeout(t),n=s();try{history.replaceState(null,"",n)}catch{}}addEventListener("hashchange",()=>{location.hash!==n&&o()});function o(){e(Object.fromEntries(new URLSearchParams(location.hash.slice(1))))}return{follow:o,renew(){clearTimeout(t),t=setTimeout(r,250)},address(){return r(),location.href.replace(/#.*/,"")+n}}}var Hs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Vs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},um=0,df=1,fm=2;var pf=1,dm=2,Qi=3,gs=0,Wn=1,Sn=2,xs=0,lr=1,mf=2,gf=3,vf=4,pm=5,Os=100,mm=101,gm=102,vm=103,xm=104,_m=200,ym=201,bm=202,Mm=203,ec=204,tc=205,wm=206,Sm=207,Em=208,Tm=209,Am=210,Rm=211,Cm=212,Pm=213,Im=214,Dc=0,Uc=1,Nc=2,cr=3,Fc=4,Oc=5,Bc=6,zc=7,xf=0,Lm=1,Dm=2,_s=0,Um=1,Nm=2,Fm=3,Om=4,Bm=5,zm=6,km=7;var _f=300,vr=301,xr=302,kc=303,Hc=304,Va=306,nc=1e3,Fs=1001,ic=1002,vi=1003,Hm=1004;var Ga=1005;var Li=1006,Vc=1007;var Gs=1008;var Fi=1009,yf=1010,bf=1011,Mo=1012,Gc=1013,Ws=1014,es=1015,wo=1016,Wc=1017,Xc=1018,So=1020,Mf=35902,wf=35899,Sf=1021,Ef=1022,xi=1023,ho=1026,Eo=1027,Tf=1028,qc=1029,Af=1030,Yc=1031;var $c=1033,Wa=33776,Xa=33777,qa=33778,Ya=33779,Zc=35840,Kc=35841,Jc=35842,jc=35843,Qc=36196,eh=37492,th=37496,nh=37808,ih=37809,sh=37810,rh=37811,oh=37812,ah=37813,lh=37814,ch=37815,hh=37816,uh=37817,fh=37818,dh=37819,ph=37820,mh=37821,gh=36492,vh=36494,xh=36495,_h=36283,yh=36284,bh=36285,Mh=36286;var fa=2300,sc=2301,Ql=2302,of=2400,af=2401,lf=2402;var Vm=3200,Gm=3201;var Rf=0,Wm=1,ys="",Gn="srgb",hr="srgb-linear",da="linear",Pt="srgb";var ar=7680,wh=7681;var Sh=517;var cf=519,Xm=512,qm=513,Ym=514,Cf=515,$m=516,Zm=517,Km=518,Jm=519,rc=35044;var Pf="300 es",Ii=2e3,pa=2001;var Zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},In=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Np=1234567,lo=Math.PI/180,uo=180/Math.PI;function ps(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(In[i&255]+In[i>>8&255]+In[i>>16&255]+In[i>>24&255]+"-"+In[e&255]+In[e>>8&255]+"-"+In[e>>16&15|64]+In[e>>24&255]+"-"+In[t&63|128]+In[t>>8&255]+"-"+In[t>>16&255]+In[t>>24&255]+In[n&255]+In[n>>8&255]+In[n>>16&255]+In[n>>24&255]).toLowerCase()}function nt(i,e,t){return Math.max(e,Math.min(t,i))}function If(i,e){return(i%e+e)%e}function l_(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function c_(i,e,t){return i!==e?(t-i)/(e-i):0}function ca(i,e,t){return(1-t)*i+t*e}function h_(i,e,t,n){return ca(i,e,1-Math.exp(-t*n))}function u_(i,e=1){return e-Math.abs(If(i,e*2)-e)}function f_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function d_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function p_(i,e){return i+Math.floor(Math.random()*(e-i+1))}function m_(i,e){return i+Math.random()*(e-i)}function g_(i){return i*(.5-Math.random())}function v_(i){i!==void 0&&(Np=i);let e=Np+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function x_(i){return i*lo}function __(i){return i*uo}function y_(i){return(i&i-1)===0&&i!==0}function b_(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function M_(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function w_(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),f=o((e-n)/2),m=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*g,l*m,a*c);break;case"YXY":i.set(l*m,a*u,l*g,a*c);break;case"ZYZ":i.set(l*g,l*m,a*u,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Pi(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Ct(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Xs={DEG2RAD:lo,RAD2DEG:uo,generateUUID:ps,clamp:nt,euclideanModulo:If,mapLinear:l_,inverseLerp:c_,lerp:ca,damp:h_,pingpong:u_,smoothstep:f_,smootherstep:d_,randInt:p_,randFloat:m_,randFloatSpread:g_,seededRandom:v_,degToRad:x_,radToDeg:__,isPowerOfTwo:y_,ceilPowerOfTwo:b_,floorPowerOfTwo:M_,setQuaternionFromProperEuler:w_,normalize:Ct,denormalize:Pi},Fe=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=nt(this.x,e.x,t.x),this.y=nt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=nt(this.x,e,t),this.y=nt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(nt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(nt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},sn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],m=r[o+1],g=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=f,e[t+1]=m,e[t+2]=g,e[t+3]=v;return}if(h!==v||l!==f||c!==m||u!==g){let p=1-a,d=l*f+c*m+u*g+h*v,y=d>=0?1:-1,b=1-d*d;if(b>Number.EPSILON){let C=Math.sqrt(b),E=Math.atan2(C,d*y);p=Math.sin(p*E)/C,a=Math.sin(a*E)/C}let _=a*y;if(l=l*p+f*_,c=c*p+m*_,u=u*p+g*_,h=h*p+v*_,p===1-a){let C=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=C,c*=C,u*=C,h*=C}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],m=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*m-c*f,e[t+1]=l*g+u*f+c*h-a*m,e[t+2]=c*g+u*m+a*f-l*h,e[t+3]=u*g-a*h-l*f-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),m=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h-f*m*g;break;case"YXZ":this._x=f*u*h+c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h+f*m*g;break;case"ZXY":this._x=f*u*h-c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h-f*m*g;break;case"ZYX":this._x=f*u*h-c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h+f*m*g;break;case"YZX":this._x=f*u*h+c*m*g,this._y=c*m*h+f*u*g,this._z=c*u*g-f*m*h,this._w=c*u*h-f*m*g;break;case"XZY":this._x=f*u*h-c*m*g,this._y=c*m*h-f*u*g,this._z=c*u*g+f*m*h,this._w=c*u*h+f*m*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=n+a+h;if(f>0){let m=.5/Math.sqrt(f+1);this._w=.25/m,this._x=(u-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(n>a&&n>h){let m=2*Math.sqrt(1+n-a-h);this._w=(u-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>h){let m=2*Math.sqrt(1+a-n-h);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+u)/m}else{let m=2*Math.sqrt(1+h-n-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+u)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(nt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let m=1-t;return this._w=m*o+t*this._w,this._x=m*n+t*this._x,this._y=m*s+t*this._y,this._z=m*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,f=Math.sin(t*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},I=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Fp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Fp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=nt(this.x,e.x,t.x),this.y=nt(this.y,e.y,t.y),this.z=nt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=nt(this.x,e,t),this.y=nt(this.y,e,t),this.z=nt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(nt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Cu.copy(this).projectOnVector(e),this.sub(Cu)}reflect(e){return this.sub(Cu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(nt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Cu=new I,Fp=new sn,ht=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],m=n[5],g=n[8],v=s[0],p=s[3],d=s[6],y=s[1],b=s[4],_=s[7],C=s[2],E=s[5],P=s[8];return r[0]=o*v+a*y+l*C,r[3]=o*p+a*b+l*E,r[6]=o*d+a*_+l*P,r[1]=c*v+u*y+h*C,r[4]=c*p+u*b+h*E,r[7]=c*d+u*_+h*P,r[2]=f*v+m*y+g*C,r[5]=f*p+m*b+g*E,r[8]=f*d+m*_+g*P,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,m=c*r-o*l,g=t*h+n*f+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return e[0]=h*v,e[1]=(s*c-u*n)*v,e[2]=(a*n-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=m*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Pu.makeScale(e,t)),this}rotate(e){return this.premultiply(Pu.makeRotation(-e)),this}translate(e,t){return this.premultiply(Pu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Pu=new ht;function Lf(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function ma(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function jm(){let i=ma("canvas");return i.style.display="block",i}var Op={};function fo(i){i in Op||(Op[i]=!0,console.warn(i))}function Qm(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Bp=new ht().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),zp=new ht().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function S_(){let i={enabled:!0,workingColorSpace:hr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=co(s.r),s.g=co(s.g),s.b=co(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?da:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return fo("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return fo("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[hr]:{primaries:e,whitePoint:n,transfer:da,toXYZ:Bp,fromXYZ:zp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Gn},outputColorSpaceConfig:{drawingBufferColorSpace:Gn}},[Gn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:Bp,fromXYZ:zp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Gn}}}),i}var xt=S_();function ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function co(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Wr,oc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Wr===void 0&&(Wr=ma("canvas")),Wr.width=e.width,Wr.height=e.height;let s=Wr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Wr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=ma("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ms(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ms(t[n]/255)*255):t[n]=ms(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},E_=0,po=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:E_++}),this.uuid=ps(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Iu(s[o].image)):r.push(Iu(s[o]))}else r=Iu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Iu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?oc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var T_=0,Lu=new I,Kn=class i extends Zi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Fs,s=Fs,r=Li,o=Gs,a=xi,l=Fi,c=i.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:T_++}),this.uuid=ps(),this.name="",this.source=new po(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Fe(0,0),this.repeat=new Fe(1,1),this.center=new Fe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ht,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Lu).x}get height(){return this.source.getSize(Lu).y}get depth(){return this.source.getSize(Lu).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==_f)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case nc:e.x=e.x-Math.floor(e.x);break;case Fs:e.x=e.x<0?0:1;break;case ic:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case nc:e.y=e.y-Math.floor(e.y);break;case Fs:e.y=e.y<0?0:1;break;case ic:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=_f;Kn.DEFAULT_ANISOTROPY=1;var It=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],m=l[5],g=l[9],v=l[2],p=l[6],d=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+p)<.1&&Math.abs(c+m+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let b=(c+1)/2,_=(m+1)/2,C=(d+1)/2,E=(u+f)/4,P=(h+v)/4,L=(g+p)/4;return b>_&&b>C?b<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(b),s=E/n,r=P/n):_>C?_<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(_),n=E/s,r=L/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=P/r,s=L/r),this.set(n,s,r,t),this}let y=Math.sqrt((p-g)*(p-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(y)<.001&&(y=1),this.x=(p-g)/y,this.y=(h-v)/y,this.z=(f-u)/y,this.w=Math.acos((c+m+d-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=nt(this.x,e.x,t.x),this.y=nt(this.y,e.y,t.y),this.z=nt(this.z,e.z,t.z),this.w=nt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=nt(this.x,e,t),this.y=nt(this.y,e,t),this.z=nt(this.z,e,t),this.w=nt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(nt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ac=class extends Zi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Li,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new It(0,0,e,t),this.scissorTest=!1,this.viewport=new It(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new Kn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:Li,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new po(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ki=class extends ac{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ga=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=vi,this.minFilter=vi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var lc=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=vi,this.minFilter=vi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var an=class{constructor(e=new I(1/0,1/0,1/0),t=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ai.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ai.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ai.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(e.matrixWorld),this.expandByPoint(Ai);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Sl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Sl.copy(n.boundingBox)),Sl.applyMatrix4(e.matrixWorld),this.union(Sl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ai),Ai.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ta),El.subVectors(this.max,ta),Xr.subVectors(e.a,ta),qr.subVectors(e.b,ta),Yr.subVectors(e.c,ta),Ps.subVectors(qr,Xr),Is.subVectors(Yr,qr),ir.subVectors(Xr,Yr);let t=[0,-Ps.z,Ps.y,0,-Is.z,Is.y,0,-ir.z,ir.y,Ps.z,0,-Ps.x,Is.z,0,-Is.x,ir.z,0,-ir.x,-Ps.y,Ps.x,0,-Is.y,Is.x,0,-ir.y,ir.x,0];return!Du(t,Xr,qr,Yr,El)||(t=[1,0,0,0,1,0,0,0,1],!Du(t,Xr,qr,Yr,El))?!1:(Tl.crossVectors(Ps,Is),t=[Tl.x,Tl.y,Tl.z],Du(t,Xr,qr,Yr,El))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ai).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ai).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(cs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},cs=[new I,new I,new I,new I,new I,new I,new I,new I],Ai=new I,Sl=new an,Xr=new I,qr=new I,Yr=new I,Ps=new I,Is=new I,ir=new I,ta=new I,El=new I,Tl=new I,sr=new I;function Du(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){sr.fromArray(i,r);let a=s.x*Math.abs(sr.x)+s.y*Math.abs(sr.y)+s.z*Math.abs(sr.z),l=e.dot(sr),c=t.dot(sr),u=n.dot(sr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var A_=new an,na=new I,Uu=new I,Di=class{constructor(e=new I,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):A_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;na.subVectors(e,this.center);let t=na.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(na,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Uu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(na.copy(e.center).add(Uu)),this.expandByPoint(na.copy(e.center).sub(Uu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},hs=new I,Nu=new I,Al=new I,Ls=new I,Fu=new I,Rl=new I,Ou=new I,ur=class{constructor(e=new I,t=new I(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,hs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=hs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(hs.copy(this.origin).addScaledVector(this.direction,t),hs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Nu.copy(e).add(t).multiplyScalar(.5),Al.copy(t).sub(e).normalize(),Ls.copy(this.origin).sub(Nu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Al),a=Ls.dot(this.direction),l=-Ls.dot(Al),c=Ls.lengthSq(),u=Math.abs(1-o*o),h,f,m,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let v=1/u;h*=v,f*=v,m=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),m=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),m=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),m=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),m=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Nu).addScaledVector(Al,f),m}intersectSphere(e,t){hs.subVectors(e.center,this.origin);let n=hs.dot(this.direction),s=hs.dot(hs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,hs)!==null}intersectTriangle(e,t,n,s,r){Fu.subVectors(t,e),Rl.subVectors(n,e),Ou.crossVectors(Fu,Rl);let o=this.direction.dot(Ou),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ls.subVectors(this.origin,e);let l=a*this.direction.dot(Rl.crossVectors(Ls,Rl));if(l<0)return null;let c=a*this.direction.dot(Fu.cross(Ls));if(c<0||l+c>o)return null;let u=-a*Ls.dot(Ou);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ut=class i{constructor(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p)}set(e,t,n,s,r,o,a,l,c,u,h,f,m,g,v,p){let d=this.elements;return d[0]=e,d[4]=t,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=h,d[14]=f,d[3]=m,d[7]=g,d[11]=v,d[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/$r.setFromMatrixColumn(e,0).length(),r=1/$r.setFromMatrixColumn(e,1).length(),o=1/$r.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,m=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=m+g*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=g+m*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,m=l*h,g=c*u,v=c*h;t[0]=f+v*a,t[4]=g*a-m,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=m*a-g,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,m=l*h,g=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=g+m*a,t[1]=m+g*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,m=o*h,g=a*u,v=a*h;t[0]=l*u,t[4]=g*c-m,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,m=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=g*h+m,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=m*h+g,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,m=o*c,g=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=m*h-g,t[2]=g*h-m,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(R_,e,C_)}lookAt(e,t,n){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Ds.crossVectors(n,si),Ds.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Ds.crossVectors(n,si)),Ds.normalize(),Cl.crossVectors(si,Ds),s[0]=Ds.x,s[4]=Cl.x,s[8]=si.x,s[1]=Ds.y,s[5]=Cl.y,s[9]=si.y,s[2]=Ds.z,s[6]=Cl.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],m=n[13],g=n[2],v=n[6],p=n[10],d=n[14],y=n[3],b=n[7],_=n[11],C=n[15],E=s[0],P=s[4],L=s[8],M=s[12],S=s[1],A=s[5],k=s[9],O=s[13],V=s[2],q=s[6],$=s[10],N=s[14],z=s[3],Q=s[7],ie=s[11],ne=s[15];return r[0]=o*E+a*S+l*V+c*z,r[4]=o*P+a*A+l*q+c*Q,r[8]=o*L+a*k+l*$+c*ie,r[12]=o*M+a*O+l*N+c*ne,r[1]=u*E+h*S+f*V+m*z,r[5]=u*P+h*A+f*q+m*Q,r[9]=u*L+h*k+f*$+m*ie,r[13]=u*M+h*O+f*N+m*ne,r[2]=g*E+v*S+p*V+d*z,r[6]=g*P+v*A+p*q+d*Q,r[10]=g*L+v*k+p*$+d*ie,r[14]=g*M+v*O+p*N+d*ne,r[3]=y*E+b*S+_*V+C*z,r[7]=y*P+b*A+_*q+C*Q,r[11]=y*L+b*k+_*$+C*ie,r[15]=y*M+b*O+_*N+C*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],m=e[14],g=e[3],v=e[7],p=e[11],d=e[15];return g*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*m-n*l*m)+v*(+t*l*m-t*c*f+r*o*f-s*o*m+s*c*u-r*l*u)+p*(+t*c*h-t*a*m-r*o*h+n*o*m+r*a*u-n*c*u)+d*(-s*a*u-t*l*h+t*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],m=e[11],g=e[12],v=e[13],p=e[14],d=e[15],y=h*p*c-v*f*c+v*l*m-a*p*m-h*l*d+a*f*d,b=g*f*c-u*p*c-g*l*m+o*p*m+u*l*d-o*f*d,_=u*v*c-g*h*c+g*a*m-o*v*m-u*a*d+o*h*d,C=g*h*l-u*v*l-g*a*f+o*v*f+u*a*p-o*h*p,E=t*y+n*b+s*_+r*C;if(E===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let P=1/E;return e[0]=y*P,e[1]=(v*f*r-h*p*r-v*s*m+n*p*m+h*s*d-n*f*d)*P,e[2]=(a*p*r-v*l*r+v*s*c-n*p*c-a*s*d+n*l*d)*P,e[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*m-n*l*m)*P,e[4]=b*P,e[5]=(u*p*r-g*f*r+g*s*m-t*p*m-u*s*d+t*f*d)*P,e[6]=(g*l*r-o*p*r-g*s*c+t*p*c+o*s*d-t*l*d)*P,e[7]=(o*f*r-u*l*r+u*s*c-t*f*c-o*s*m+t*l*m)*P,e[8]=_*P,e[9]=(g*h*r-u*v*r-g*n*m+t*v*m+u*n*d-t*h*d)*P,e[10]=(o*v*r-g*a*r+g*n*c-t*v*c-o*n*d+t*a*d)*P,e[11]=(u*a*r-o*h*r-u*n*c+t*h*c+o*n*m-t*a*m)*P,e[12]=C*P,e[13]=(u*v*s-g*h*s+g*n*f-t*v*f-u*n*p+t*h*p)*P,e[14]=(g*a*s-o*v*s-g*n*l+t*v*l+o*n*p-t*a*p)*P,e[15]=(o*h*s-u*a*s+u*n*l-t*h*l-o*n*f+t*a*f)*P,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,m=r*u,g=r*h,v=o*u,p=o*h,d=a*h,y=l*c,b=l*u,_=l*h,C=n.x,E=n.y,P=n.z;return s[0]=(1-(v+d))*C,s[1]=(m+_)*C,s[2]=(g-b)*C,s[3]=0,s[4]=(m-_)*E,s[5]=(1-(f+d))*E,s[6]=(p+y)*E,s[7]=0,s[8]=(g+b)*P,s[9]=(p-y)*P,s[10]=(1-(f+v))*P,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=$r.set(s[0],s[1],s[2]).length(),o=$r.set(s[4],s[5],s[6]).length(),a=$r.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Ri.copy(this);let c=1/r,u=1/o,h=1/a;return Ri.elements[0]*=c,Ri.elements[1]*=c,Ri.elements[2]*=c,Ri.elements[4]*=u,Ri.elements[5]*=u,Ri.elements[6]*=u,Ri.elements[8]*=h,Ri.elements[9]*=h,Ri.elements[10]*=h,t.setFromRotationMatrix(Ri),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),f=(t+e)/(t-e),m=(n+s)/(n-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===Ii)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===pa)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),f=-(t+e)/(t-e),m=-(n+s)/(n-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===Ii)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===pa)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},$r=new I,Ri=new Ut,R_=new I(0,0,0),C_=new I(1,1,1),Ds=new I,Cl=new I,si=new I,kp=new Ut,Hp=new sn,Ui=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(nt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-nt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(nt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-nt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(nt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-nt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,m),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return kp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(kp,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Hp.setFromEuler(this),this.setFromQuaternion(Hp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ui.DEFAULT_ORDER="XYZ";var va=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},P_=0,Vp=new I,Zr=new sn,us=new Ut,Pl=new I,ia=new I,I_=new I,L_=new sn,Gp=new I(1,0,0),Wp=new I(0,1,0),Xp=new I(0,0,1),qp={type:"added"},D_={type:"removed"},Kr={type:"childadded",child:null},Bu={type:"childremoved",child:null},ln=class i extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:P_++}),this.uuid=ps(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new I,t=new Ui,n=new sn,s=new I(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ut},normalMatrix:{value:new ht}}),this.matrix=new Ut,this.matrixWorld=new Ut,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new va,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Zr.setFromAxisAngle(e,t),this.quaternion.multiply(Zr),this}rotateOnWorldAxis(e,t){return Zr.setFromAxisAngle(e,t),this.quaternion.premultiply(Zr),this}rotateX(e){return this.rotateOnAxis(Gp,e)}rotateY(e){return this.rotateOnAxis(Wp,e)}rotateZ(e){return this.rotateOnAxis(Xp,e)}translateOnAxis(e,t){return Vp.copy(e).applyQuaternion(this.quaternion),this.position.add(Vp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Gp,e)}translateY(e){return this.translateOnAxis(Wp,e)}translateZ(e){return this.translateOnAxis(Xp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(us.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Pl.copy(e):Pl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ia.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?us.lookAt(ia,Pl,this.up):us.lookAt(Pl,ia,this.up),this.quaternion.setFromRotationMatrix(us),s&&(us.extractRotation(s.matrixWorld),Zr.setFromRotationMatrix(us),this.quaternion.premultiply(Zr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(qp),Kr.child=e,this.dispatchEvent(Kr),Kr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(D_),Bu.child=e,this.dispatchEvent(Bu),Bu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),us.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),us.multiply(e.parent.matrixWorld)),e.applyMatrix4(us),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(qp),Kr.child=e,this.dispatchEvent(Kr),Kr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ia,e,I_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ia,L_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),m=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};ln.DEFAULT_UP=new I(0,1,0);ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ci=new I,fs=new I,zu=new I,ds=new I,Jr=new I,jr=new I,Yp=new I,ku=new I,Hu=new I,Vu=new I,Gu=new It,Wu=new It,Xu=new It,$i=class i{constructor(e=new I,t=new I,n=new I){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ci.subVectors(e,t),s.cross(Ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ci.subVectors(s,t),fs.subVectors(n,t),zu.subVectors(e,t);let o=Ci.dot(Ci),a=Ci.dot(fs),l=Ci.dot(zu),c=fs.dot(fs),u=fs.dot(zu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,m=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-m-g,g,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ds)===null?!1:ds.x>=0&&ds.y>=0&&ds.x+ds.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ds.x),l.addScaledVector(o,ds.y),l.addScaledVector(a,ds.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Gu.setScalar(0),Wu.setScalar(0),Xu.setScalar(0),Gu.fromBufferAttribute(e,t),Wu.fromBufferAttribute(e,n),Xu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Gu,r.x),o.addScaledVector(Wu,r.y),o.addScaledVector(Xu,r.z),o}static isFrontFacing(e,t,n,s){return Ci.subVectors(n,t),fs.subVectors(e,t),Ci.cross(fs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ci.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ci.cross(fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Jr.subVectors(s,n),jr.subVectors(r,n),ku.subVectors(e,n);let l=Jr.dot(ku),c=jr.dot(ku);if(l<=0&&c<=0)return t.copy(n);Hu.subVectors(e,s);let u=Jr.dot(Hu),h=jr.dot(Hu);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(n).addScaledVector(Jr,o);Vu.subVectors(e,r);let m=Jr.dot(Vu),g=jr.dot(Vu);if(g>=0&&m<=g)return t.copy(r);let v=m*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(jr,a);let p=u*g-m*h;if(p<=0&&h-u>=0&&m-g>=0)return Yp.subVectors(r,s),a=(h-u)/(h-u+(m-g)),t.copy(s).addScaledVector(Yp,a);let d=1/(p+v+f);return o=v*d,a=f*d,t.copy(n).addScaledVector(Jr,o).addScaledVector(jr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},eg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Us={h:0,s:0,l:0},Il={h:0,s:0,l:0};function qu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ot=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Gn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,xt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=xt.workingColorSpace){return this.r=e,this.g=t,this.b=n,xt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=xt.workingColorSpace){if(e=If(e,1),t=nt(t,0,1),n=nt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=qu(o,r,e+1/3),this.g=qu(o,r,e),this.b=qu(o,r,e-1/3)}return xt.colorSpaceToWorking(this,s),this}setStyle(e,t=Gn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Gn){let n=eg[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ms(e.r),this.g=ms(e.g),this.b=ms(e.b),this}copyLinearToSRGB(e){return this.r=co(e.r),this.g=co(e.g),this.b=co(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Gn){return xt.workingToColorSpace(Ln.copy(this),e),Math.round(nt(Ln.r*255,0,255))*65536+Math.round(nt(Ln.g*255,0,255))*256+Math.round(nt(Ln.b*255,0,255))}getHexString(e=Gn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=xt.workingColorSpace){xt.workingToColorSpace(Ln.copy(this),t);let n=Ln.r,s=Ln.g,r=Ln.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=xt.workingColorSpace){return xt.workingToColorSpace(Ln.copy(this),t),e.r=Ln.r,e.g=Ln.g,e.b=Ln.b,e}getStyle(e=Gn){xt.workingToColorSpace(Ln.copy(this),e);let t=Ln.r,n=Ln.g,s=Ln.b;return e!==Gn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Us),this.setHSL(Us.h+e,Us.s+t,Us.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Us),e.getHSL(Il);let n=ca(Us.h,Il.h,t),s=ca(Us.s,Il.s,t),r=ca(Us.l,Il.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ln=new ot;ot.NAMES=eg;var U_=0,Ji=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:U_++}),this.uuid=ps(),this.name="",this.type="Material",this.blending=lr,this.side=gs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ec,this.blendDst=tc,this.blendEquation=Os,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ot(0,0,0),this.blendAlpha=0,this.depthFunc=cr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=cf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ar,this.stencilZFail=ar,this.stencilZPass=ar,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==lr&&(n.blending=this.blending),this.side!==gs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==ec&&(n.blendSrc=this.blendSrc),this.blendDst!==tc&&(n.blendDst=this.blendDst),this.blendEquation!==Os&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==cr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==cf&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==ar&&(n.stencilFail=this.stencilFail),this.stencilZFail!==ar&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==ar&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},oi=class extends Ji{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ot(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.combine=xf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var nn=new I,Ll=new Fe,N_=0,Jt=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:N_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=rc,this.updateRanges=[],this.gpuType=es,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Ll.fromBufferAttribute(this,t),Ll.applyMatrix3(e),this.setXY(t,Ll.x,Ll.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix3(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix4(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyNormalMatrix(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.transformDirection(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ct(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Pi(t,this.array)),t}setX(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Pi(t,this.array)),t}setY(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Pi(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Pi(t,this.array)),t}setW(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array),r=Ct(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==rc&&(e.usage=this.usage),e}};var xa=class extends Jt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var _a=class extends Jt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var mt=class extends Jt{constructor(e,t,n){super(new Float32Array(e),t,n)}},F_=0,gi=new Ut,Yu=new ln,Qr=new I,ri=new an,sa=new an,yn=new I,Ot=class i extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:F_++}),this.uuid=ps(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Lf(e)?_a:xa)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ht().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return gi.makeRotationFromQuaternion(e),this.applyMatrix4(gi),this}rotateX(e){return gi.makeRotationX(e),this.applyMatrix4(gi),this}rotateY(e){return gi.makeRotationY(e),this.applyMatrix4(gi),this}rotateZ(e){return gi.makeRotationZ(e),this.applyMatrix4(gi),this}translate(e,t,n){return gi.makeTranslation(e,t,n),this.applyMatrix4(gi),this}scale(e,t,n){return gi.makeScale(e,t,n),this.applyMatrix4(gi),this}lookAt(e){return Yu.lookAt(e),Yu.updateMatrix(),this.applyMatrix4(Yu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Qr).negate(),this.translate(Qr.x,Qr.y,Qr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new an);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(yn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(yn),yn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(yn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(e){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];sa.setFromBufferAttribute(a),this.morphTargetsRelative?(yn.addVectors(ri.min,sa.min),ri.expandByPoint(yn),yn.addVectors(ri.max,sa.max),ri.expandByPoint(yn)):(ri.expandByPoint(sa.min),ri.expandByPoint(sa.max))}ri.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)yn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(yn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)yn.fromBufferAttribute(a,c),l&&(Qr.fromBufferAttribute(e,c),yn.add(Qr)),s=Math.max(s,n.distanceToSquared(yn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Jt(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let L=0;L<n.count;L++)a[L]=new I,l[L]=new I;let c=new I,u=new I,h=new I,f=new Fe,m=new Fe,g=new Fe,v=new I,p=new I;function d(L,M,S){c.fromBufferAttribute(n,L),u.fromBufferAttribute(n,M),h.fromBufferAttribute(n,S),f.fromBufferAttribute(r,L),m.fromBufferAttribute(r,M),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),m.sub(f),g.sub(f);let A=1/(m.x*g.y-g.x*m.y);isFinite(A)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-m.y).multiplyScalar(A),p.copy(h).multiplyScalar(m.x).addScaledVector(u,-g.x).multiplyScalar(A),a[L].add(v),a[M].add(v),a[S].add(v),l[L].add(p),l[M].add(p),l[S].add(p))}let y=this.groups;y.length===0&&(y=[{start:0,count:e.count}]);for(let L=0,M=y.length;L<M;++L){let S=y[L],A=S.start,k=S.count;for(let O=A,V=A+k;O<V;O+=3)d(e.getX(O+0),e.getX(O+1),e.getX(O+2))}let b=new I,_=new I,C=new I,E=new I;function P(L){C.fromBufferAttribute(s,L),E.copy(C);let M=a[L];b.copy(M),b.sub(C.multiplyScalar(C.dot(M))).normalize(),_.crossVectors(E,M);let A=_.dot(l[L])<0?-1:1;o.setXYZW(L,b.x,b.y,b.z,A)}for(let L=0,M=y.length;L<M;++L){let S=y[L],A=S.start,k=S.count;for(let O=A,V=A+k;O<V;O+=3)P(e.getX(O+0)),P(e.getX(O+1)),P(e.getX(O+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Jt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,m=n.count;f<m;f++)n.setXYZ(f,0,0,0);let s=new I,r=new I,o=new I,a=new I,l=new I,c=new I,u=new I,h=new I;if(e)for(let f=0,m=e.count;f<m;f+=3){let g=e.getX(f+0),v=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,p),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,p),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,m=t.count;f<m;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)yn.fromBufferAttribute(e,t),yn.normalize(),e.setXYZ(t,yn.x,yn.y,yn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),m=0,g=0;for(let v=0,p=l.length;v<p;v++){a.isInterleavedBufferAttribute?m=l[v]*a.data.stride+a.offset:m=l[v]*u;for(let d=0;d<u;d++)f[g++]=c[m++]}return new Jt(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],m=e(f,n);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let m=c[h];u.push(m.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,m=h.length;f<m;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},$p=new Ut,rr=new ur,Dl=new Di,Zp=new I,Ul=new I,Nl=new I,Fl=new I,$u=new I,Ol=new I,Kp=new I,Bl=new I,Ke=class extends ln{constructor(e=new Ot,t=new oi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Ol.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&($u.fromBufferAttribute(h,e),o?Ol.addScaledVector($u,u):Ol.addScaledVector($u.sub(t),u))}t.add(Ol)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Dl.copy(n.boundingSphere),Dl.applyMatrix4(r),rr.copy(e.ray).recast(e.near),!(Dl.containsPoint(rr.origin)===!1&&(rr.intersectSphere(Dl,Zp)===null||rr.origin.distanceToSquared(Zp)>(e.far-e.near)**2))&&($p.copy(r).invert(),rr.copy(e.ray).applyMatrix4($p),!(n.boundingBox!==null&&rr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,rr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let p=f[g],d=o[p.materialIndex],y=Math.max(p.start,m.start),b=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let _=y,C=b;_<C;_+=3){let E=a.getX(_),P=a.getX(_+1),L=a.getX(_+2);s=zl(this,d,e,n,c,u,h,E,P,L),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),v=Math.min(a.count,m.start+m.count);for(let p=g,d=v;p<d;p+=3){let y=a.getX(p),b=a.getX(p+1),_=a.getX(p+2);s=zl(this,o,e,n,c,u,h,y,b,_),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){let p=f[g],d=o[p.materialIndex],y=Math.max(p.start,m.start),b=Math.min(l.count,Math.min(p.start+p.count,m.start+m.count));for(let _=y,C=b;_<C;_+=3){let E=_,P=_+1,L=_+2;s=zl(this,d,e,n,c,u,h,E,P,L),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),v=Math.min(l.count,m.start+m.count);for(let p=g,d=v;p<d;p+=3){let y=p,b=p+1,_=p+2;s=zl(this,o,e,n,c,u,h,y,b,_),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function O_(i,e,t,n,s,r,o,a){let l;if(e.side===Wn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===gs,a),l===null)return null;Bl.copy(a),Bl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Bl);return c<t.near||c>t.far?null:{distance:c,point:Bl.clone(),object:i}}function zl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Ul),i.getVertexPosition(l,Nl),i.getVertexPosition(c,Fl);let u=O_(i,e,t,n,Ul,Nl,Fl,Kp);if(u){let h=new I;$i.getBarycoord(Kp,Ul,Nl,Fl,h),s&&(u.uv=$i.getInterpolatedAttribute(s,a,l,c,h,new Fe)),r&&(u.uv1=$i.getInterpolatedAttribute(r,a,l,c,h,new Fe)),o&&(u.normal=$i.getInterpolatedAttribute(o,a,l,c,h,new I),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new I,materialIndex:0};$i.getNormal(Ul,Nl,Fl,f.normal),u.face=f,u.barycoord=h}return u}var ji=class i extends Ot{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,m=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(h,2));function g(v,p,d,y,b,_,C,E,P,L,M){let S=_/P,A=C/L,k=_/2,O=C/2,V=E/2,q=P+1,$=L+1,N=0,z=0,Q=new I;for(let ie=0;ie<$;ie++){let ne=ie*A-O;for(let ce=0;ce<q;ce++){let he=ce*S-k;Q[v]=he*y,Q[p]=ne*b,Q[d]=V,c.push(Q.x,Q.y,Q.z),Q[v]=0,Q[p]=0,Q[d]=E>0?1:-1,u.push(Q.x,Q.y,Q.z),h.push(ce/P),h.push(1-ie/L),N+=1}}for(let ie=0;ie<L;ie++)for(let ne=0;ne<P;ne++){let ce=f+ne+q*ie,he=f+ne+q*(ie+1),Me=f+(ne+1)+q*(ie+1),Ee=f+(ne+1)+q*ie;l.push(ce,he,Ee),l.push(he,Me,Ee),z+=6}a.addGroup(m,z,M),m+=z,f+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function _r(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Un(i){let e={};for(let t=0;t<i.length;t++){let n=_r(i[t]);for(let s in n)e[s]=n[s]}return e}function B_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Df(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:xt.workingColorSpace}var $a={clone:_r,merge:Un},z_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,k_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ai=class extends Ji{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=z_,this.fragmentShader=k_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=_r(e.uniforms),this.uniformsGroups=B_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},ya=class extends ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ut,this.projectionMatrix=new Ut,this.projectionMatrixInverse=new Ut,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Ns=new I,Jp=new Fe,jp=new Fe,Dn=class extends ya{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=uo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(lo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return uo*2*Math.atan(Math.tan(lo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z)}getViewSize(e,t){return this.getViewBounds(e,Jp,jp),t.subVectors(jp,Jp)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(lo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},eo=-90,to=1,cc=class extends ln{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Dn(eo,to,e,t);s.layers=this.layers,this.add(s);let r=new Dn(eo,to,e,t);r.layers=this.layers,this.add(r);let o=new Dn(eo,to,e,t);o.layers=this.layers,this.add(o);let a=new Dn(eo,to,e,t);a.layers=this.layers,this.add(a);let l=new Dn(eo,to,e,t);l.layers=this.layers,this.add(l);let c=new Dn(eo,to,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ii)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===pa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=v,e.setRenderTarget(n,5,s),e.render(t,u),e.setRenderTarget(h,f,m),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},ba=class extends Kn{constructor(e=[],t=vr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},hc=class extends Ki{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ba(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ji(5,5,5),r=new ai({name:"CubemapFromEquirect",uniforms:_r(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Wn,blending:xs});r.uniforms.tEquirect.value=t;let o=new Ke(s,r),a=t.minFilter;return t.minFilter===Gs&&(t.minFilter=Li),new cc(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},_t=class extends ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},H_={type:"move"},mo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new _t,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new _t,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new _t,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let p=t.getJointPose(v,n),d=this._getHandJoint(c,v);p!==null&&(d.matrix.fromArray(p.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=p.radius),d.visible=p!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),m=.02,g=.005;c.inputState.pinching&&f>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(H_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new _t;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var go=class extends ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ui,this.environmentIntensity=1,this.environmentRotation=new Ui,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},vo=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=rc,this.updateRanges=[],this.version=0,this.uuid=ps()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);let t=new this.array.constructor(e.arrayBuffers[this.array.buffer._uuid]),n=new this.constructor(t,this.stride);return n.setUsage(this.usage),n}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){return e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}},Vn=new I,Jn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.applyMatrix4(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.applyNormalMatrix(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.transformDirection(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ct(n,this.array)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=Pi(t,this.array)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=Pi(t,this.array)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=Pi(t,this.array)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=Pi(t,this.array)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array),r=Ct(r,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Jt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}},xo=class extends Ji{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ot(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},no,ra=new I,io=new I,so=new I,ro=new Fe,oa=new Fe,tg=new Ut,kl=new I,aa=new I,Hl=new I,Qp=new Fe,Zu=new Fe,em=new Fe,Ma=class extends ln{constructor(e=new xo){if(super(),this.isSprite=!0,this.type="Sprite",no===void 0){no=new Ot;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new vo(t,5);no.setIndex([0,1,2,0,2,3]),no.setAttribute("position",new Jn(n,3,0,!1)),no.setAttribute("uv",new Jn(n,2,3,!1))}this.geometry=no,this.material=e,this.center=new Fe(.5,.5),this.count=1}raycast(e,t){e.camera===null&&console.error('THREE.Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),io.setFromMatrixScale(this.matrixWorld),tg.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),so.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&io.multiplyScalar(-so.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;Vl(kl.set(-.5,-.5,0),so,o,io,s,r),Vl(aa.set(.5,-.5,0),so,o,io,s,r),Vl(Hl.set(.5,.5,0),so,o,io,s,r),Qp.set(0,0),Zu.set(1,0),em.set(1,1);let a=e.ray.intersectTriangle(kl,aa,Hl,!1,ra);if(a===null&&(Vl(aa.set(-.5,.5,0),so,o,io,s,r),Zu.set(0,1),a=e.ray.intersectTriangle(kl,Hl,aa,!1,ra),a===null))return;let l=e.ray.origin.distanceTo(ra);l<e.near||l>e.far||t.push({distance:l,point:ra.clone(),uv:$i.getInterpolation(ra,kl,aa,Hl,Qp,Zu,em,new Fe),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}};function Vl(i,e,t,n,s,r){ro.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(oa.x=r*ro.x-s*ro.y,oa.y=s*ro.x+r*ro.y):oa.copy(ro),i.copy(e),i.x+=oa.x,i.y+=oa.y,i.applyMatrix4(tg)}var Ku=new I,V_=new I,G_=new ht,Zn=class{constructor(e=new I(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Ku.subVectors(n,t).cross(V_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(Ku),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||G_.getNormalMatrix(e),s=this.coplanarPoint(Ku).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},or=new Di,W_=new Fe(.5,.5),Gl=new I,_o=class{constructor(e=new Zn,t=new Zn,n=new Zn,s=new Zn,r=new Zn,o=new Zn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ii,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],m=r[7],g=r[8],v=r[9],p=r[10],d=r[11],y=r[12],b=r[13],_=r[14],C=r[15];if(s[0].setComponents(c-o,m-u,d-g,C-y).normalize(),s[1].setComponents(c+o,m+u,d+g,C+y).normalize(),s[2].setComponents(c+a,m+h,d+v,C+b).normalize(),s[3].setComponents(c-a,m-h,d-v,C-b).normalize(),n)s[4].setComponents(l,f,p,_).normalize(),s[5].setComponents(c-l,m-f,d-p,C-_).normalize();else if(s[4].setComponents(c-l,m-f,d-p,C-_).normalize(),t===Ii)s[5].setComponents(c+l,m+f,d+p,C+_).normalize();else if(t===pa)s[5].setComponents(l,f,p,_).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),or.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),or.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(or)}intersectsSprite(e){or.center.set(0,0,0);let t=W_.distanceTo(e.center);return or.radius=.7071067811865476+t,or.applyMatrix4(e.matrixWorld),this.intersectsSphere(or)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Gl.x=s.normal.x>0?e.max.x:e.min.x,Gl.y=s.normal.y>0?e.max.y:e.min.y,Gl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Gl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var vs=class extends Ji{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ot(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},uc=new I,fc=new I,tm=new Ut,la=new ur,Wl=new Di,Ju=new I,nm=new I,fr=class extends ln{constructor(e=new Ot,t=new vs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)uc.fromBufferAttribute(t,s-1),fc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=uc.distanceTo(fc);e.setAttribute("lineDistance",new mt(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Wl.copy(n.boundingSphere),Wl.applyMatrix4(s),Wl.radius+=r,e.ray.intersectsSphere(Wl)===!1)return;tm.copy(s).invert(),la.copy(e.ray).applyMatrix4(tm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let m=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=m,p=g-1;v<p;v+=c){let d=u.getX(v),y=u.getX(v+1),b=Xl(this,e,la,l,d,y,v);b&&t.push(b)}if(this.isLineLoop){let v=u.getX(g-1),p=u.getX(m),d=Xl(this,e,la,l,v,p,g-1);d&&t.push(d)}}else{let m=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=m,p=g-1;v<p;v+=c){let d=Xl(this,e,la,l,v,v+1,v);d&&t.push(d)}if(this.isLineLoop){let v=Xl(this,e,la,l,g-1,m,g-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Xl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(uc.fromBufferAttribute(a,s),fc.fromBufferAttribute(a,r),t.distanceSqToSegment(uc,fc,Ju,nm)>n)return;Ju.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Ju);if(!(c<e.near||c>e.far))return{distance:c,point:nm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var im=new I,sm=new I,yo=class extends fr{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)im.fromBufferAttribute(t,s),sm.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+im.distanceTo(sm);e.setAttribute("lineDistance",new mt(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var wa=class extends Kn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},Sa=class extends Kn{constructor(e,t,n=Ws,s,r,o,a=vi,l=vi,c,u=ho,h=1){if(u!==ho&&u!==Eo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new po(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},Ea=class extends Kn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var dr=class i extends Ot{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new I,u=new Fe;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=t;h++,f+=3){let m=n+h/t*s;c.x=e*Math.cos(m),c.y=e*Math.sin(m),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/e+1)/2,u.y=(o[f+1]/e+1)/2,l.push(u.x,u.y)}for(let h=1;h<=t;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new mt(o,3)),this.setAttribute("normal",new mt(a,3)),this.setAttribute("uv",new mt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},wn=class i extends Ot{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],m=[],g=0,v=[],p=n/2,d=0;y(),o===!1&&(e>0&&b(!0),t>0&&b(!1)),this.setIndex(u),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(m,2));function y(){let _=new I,C=new I,E=0,P=(t-e)/n;for(let L=0;L<=r;L++){let M=[],S=L/r,A=S*(t-e)+e;for(let k=0;k<=s;k++){let O=k/s,V=O*l+a,q=Math.sin(V),$=Math.cos(V);C.x=A*q,C.y=-S*n+p,C.z=A*$,h.push(C.x,C.y,C.z),_.set(q,P,$).normalize(),f.push(_.x,_.y,_.z),m.push(O,1-S),M.push(g++)}v.push(M)}for(let L=0;L<s;L++)for(let M=0;M<r;M++){let S=v[M][L],A=v[M+1][L],k=v[M+1][L+1],O=v[M][L+1];(e>0||M!==0)&&(u.push(S,A,O),E+=3),(t>0||M!==r-1)&&(u.push(A,k,O),E+=3)}c.addGroup(d,E,0),d+=E}function b(_){let C=g,E=new Fe,P=new I,L=0,M=_===!0?e:t,S=_===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,p*S,0),f.push(0,S,0),m.push(.5,.5),g++;let A=g;for(let k=0;k<=s;k++){let V=k/s*l+a,q=Math.cos(V),$=Math.sin(V);P.x=M*$,P.y=p*S,P.z=M*q,h.push(P.x,P.y,P.z),f.push(0,S,0),E.x=q*.5+.5,E.y=$*.5*S+.5,m.push(E.x,E.y),g++}for(let k=0;k<s;k++){let O=C+k,V=A+k;_===!0?u.push(V,V+1,O):u.push(V+1,V,O),L+=3}c.addGroup(d,L,_===!0?1:2),d+=L}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},pr=class i extends wn{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var ql=new I,Yl=new I,ju=new I,$l=new $i,Ta=class extends Ot{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(lo*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},m=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:v,b:p,c:d}=$l;if(v.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),$l.getNormal(ju),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,h[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let y=0;y<3;y++){let b=(y+1)%3,_=h[y],C=h[b],E=$l[u[y]],P=$l[u[b]],L=`${_}_${C}`,M=`${C}_${_}`;M in f&&f[M]?(ju.dot(f[M].normal)<=r&&(m.push(E.x,E.y,E.z),m.push(P.x,P.y,P.z)),f[M]=null):L in f||(f[L]={index0:c[y],index1:c[b],normal:ju.clone()})}}for(let g in f)if(f[g]){let{index0:v,index1:p}=f[g];ql.fromBufferAttribute(a,v),Yl.fromBufferAttribute(a,p),m.push(ql.x,ql.y,ql.z),m.push(Yl.x,Yl.y,Yl.z)}this.setAttribute("position",new mt(m,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},jn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let u=n[s],f=n[s+1]-u,m=(o-u)/f;return(s+m)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new Fe:new I);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new I,s=[],r=[],o=[],a=new I,l=new Ut;for(let m=0;m<=e;m++){let g=m/e;s[m]=this.getTangentAt(g,new I)}r[0]=new I,o[0]=new I;let c=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let m=1;m<=e;m++){if(r[m]=r[m-1].clone(),o[m]=o[m-1].clone(),a.crossVectors(s[m-1],s[m]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(nt(s[m-1].dot(s[m]),-1,1));r[m].applyMatrix4(l.makeRotationAxis(a,g))}o[m].crossVectors(s[m],r[m])}if(t===!0){let m=Math.acos(nt(r[0].dot(r[e]),-1,1));m/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(m=-m);for(let g=1;g<=e;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],m*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}},Aa=class extends jn{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new Fe){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,m=c-this.aY;l=f*u-m*h+this.aX,c=f*h+m*u+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},dc=class extends Aa{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Uf(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,m=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,m*=u,s(o,a,f,m)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var Zl=new I,Qu=new Uf,ef=new Uf,tf=new Uf,pc=class extends jn{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new I){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:(Zl.subVectors(s[0],s[1]).add(s[0]),c=Zl);let h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(Zl.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=Zl),this.curveType==="centripetal"||this.curveType==="chordal"){let m=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(h),m),v=Math.pow(h.distanceToSquared(f),m),p=Math.pow(f.distanceToSquared(u),m);v<1e-4&&(v=1),g<1e-4&&(g=v),p<1e-4&&(p=v),Qu.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,g,v,p),ef.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,g,v,p),tf.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,g,v,p)}else this.curveType==="catmullrom"&&(Qu.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),ef.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),tf.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(Qu.calc(l),ef.calc(l),tf.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new I().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function rm(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function X_(i,e){let t=1-i;return t*t*e}function q_(i,e){return 2*(1-i)*i*e}function Y_(i,e){return i*i*e}function ha(i,e,t,n){return X_(i,e)+q_(i,t)+Y_(i,n)}function $_(i,e){let t=1-i;return t*t*t*e}function Z_(i,e){let t=1-i;return 3*t*t*i*e}function K_(i,e){return 3*(1-i)*i*i*e}function J_(i,e){return i*i*i*e}function ua(i,e,t,n,s){return $_(i,e)+Z_(i,t)+K_(i,n)+J_(i,s)}var mc=class extends jn{constructor(e=new Fe,t=new Fe,n=new Fe,s=new Fe){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Fe){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ua(e,s.x,r.x,o.x,a.x),ua(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},gc=class extends jn{constructor(e=new I,t=new I,n=new I,s=new I){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new I){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ua(e,s.x,r.x,o.x,a.x),ua(e,s.y,r.y,o.y,a.y),ua(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},vc=class extends jn{constructor(e=new Fe,t=new Fe){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Fe){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Fe){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},xc=class extends jn{constructor(e=new I,t=new I){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new I){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new I){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},_c=class extends jn{constructor(e=new Fe,t=new Fe,n=new Fe){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Fe){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ha(e,s.x,r.x,o.x),ha(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Ra=class extends jn{constructor(e=new I,t=new I,n=new I){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new I){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ha(e,s.x,r.x,o.x),ha(e,s.y,r.y,o.y),ha(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},yc=class extends jn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Fe){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(rm(a,l.x,c.x,u.x,h.x),rm(a,l.y,c.y,u.y,h.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Fe().fromArray(s))}return this}},j_=Object.freeze({__proto__:null,ArcCurve:dc,CatmullRomCurve3:pc,CubicBezierCurve:mc,CubicBezierCurve3:gc,EllipseCurve:Aa,LineCurve:vc,LineCurve3:xc,QuadraticBezierCurve:_c,QuadraticBezierCurve3:Ra,SplineCurve:yc});var Ca=class i extends Ot{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,m=[],g=[],v=[],p=[];for(let d=0;d<u;d++){let y=d*f-o;for(let b=0;b<c;b++){let _=b*h-r;g.push(_,-y,0),v.push(0,0,1),p.push(b/a),p.push(1-d/l)}}for(let d=0;d<l;d++)for(let y=0;y<a;y++){let b=y+c*d,_=y+c*(d+1),C=y+1+c*(d+1),E=y+1+c*d;m.push(b,_,E),m.push(_,C,E)}this.setIndex(m),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(v,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Pa=class i extends Ot{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new I,f=new I,m=[],g=[],v=[],p=[];for(let d=0;d<=n;d++){let y=[],b=d/n,_=0;d===0&&o===0?_=.5/t:d===n&&l===Math.PI&&(_=-.5/t);for(let C=0;C<=t;C++){let E=C/t;h.x=-e*Math.cos(s+E*r)*Math.sin(o+b*a),h.y=e*Math.cos(o+b*a),h.z=e*Math.sin(s+E*r)*Math.sin(o+b*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),p.push(E+_,1-b),y.push(c++)}u.push(y)}for(let d=0;d<n;d++)for(let y=0;y<t;y++){let b=u[d][y+1],_=u[d][y],C=u[d+1][y],E=u[d+1][y+1];(d!==0||o>0)&&m.push(b,_,E),(d!==n-1||l<Math.PI)&&m.push(_,C,E)}this.setIndex(m),this.setAttribute("position",new mt(g,3)),this.setAttribute("normal",new mt(v,3)),this.setAttribute("uv",new mt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Ia=class i extends Ot{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],l=[],c=[],u=new I,h=new I,f=new I;for(let m=0;m<=n;m++)for(let g=0;g<=s;g++){let v=g/s*r,p=m/n*Math.PI*2;h.x=(e+t*Math.cos(p))*Math.cos(v),h.y=(e+t*Math.cos(p))*Math.sin(v),h.z=t*Math.sin(p),a.push(h.x,h.y,h.z),u.x=e*Math.cos(v),u.y=e*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(m/n)}for(let m=1;m<=n;m++)for(let g=1;g<=s;g++){let v=(s+1)*m+g-1,p=(s+1)*(m-1)+g-1,d=(s+1)*(m-1)+g,y=(s+1)*m+g;o.push(v,p,y),o.push(p,d,y)}this.setIndex(o),this.setAttribute("position",new mt(a,3)),this.setAttribute("normal",new mt(l,3)),this.setAttribute("uv",new mt(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}};var La=class i extends Ot{constructor(e=new Ra(new I(-1,-1,0),new I(-1,1,0),new I(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let o=e.computeFrenetFrames(t,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new I,l=new I,c=new Fe,u=new I,h=[],f=[],m=[],g=[];v(),this.setIndex(g),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(m,2));function v(){for(let b=0;b<t;b++)p(b);p(r===!1?t:0),y(),d()}function p(b){u=e.getPointAt(b/t,u);let _=o.normals[b],C=o.binormals[b];for(let E=0;E<=s;E++){let P=E/s*Math.PI*2,L=Math.sin(P),M=-Math.cos(P);l.x=M*_.x+L*C.x,l.y=M*_.y+L*C.y,l.z=M*_.z+L*C.z,l.normalize(),f.push(l.x,l.y,l.z),a.x=u.x+n*l.x,a.y=u.y+n*l.y,a.z=u.z+n*l.z,h.push(a.x,a.y,a.z)}}function d(){for(let b=1;b<=t;b++)for(let _=1;_<=s;_++){let C=(s+1)*(b-1)+(_-1),E=(s+1)*b+(_-1),P=(s+1)*b+_,L=(s+1)*(b-1)+_;g.push(C,E,L),g.push(E,P,L)}}function y(){for(let b=0;b<=t;b++)for(let _=0;_<=s;_++)c.x=b/t,c.y=_/s,m.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new j_[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}},Da=class extends Ot{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new I,r=new I;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,m=h.count;for(let g=f,v=f+m;g<v;g+=3)for(let p=0;p<3;p++){let d=a.getX(g+p),y=a.getX(g+(p+1)%3);s.fromBufferAttribute(o,d),r.fromBufferAttribute(o,y),om(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),om(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new mt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function om(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var Ni=class extends Ji{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ot(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ot(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Rf,this.normalScale=new Fe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var bc=class extends Ji{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Vm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Mc=class extends Ji{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Kl(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Q_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var mr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},wc=class extends mr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:of,endingEnd:of}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case af:r=e,a=2*t-n;break;case lf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case af:o=e,l=2*n-t;break;case lf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,m=this._weightNext,g=(n-t)/(s-t),v=g*g,p=v*g,d=-f*p+2*f*v-f*g,y=(1+f)*p+(-1.5-2*f)*v+(-.5+f)*g+1,b=(-1-m)*p+(1.5+m)*v+.5*g,_=m*p-m*v;for(let C=0;C!==a;++C)r[C]=d*o[u+C]+y*o[c+C]+b*o[l+C]+_*o[h+C];return r}},Sc=class extends mr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Ec=class extends mr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},li=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Kl(t,this.TimeBufferType),this.values=Kl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Kl(e.times,Array),values:Kl(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ec(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Sc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new wc(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case fa:t=this.InterpolantFactoryMethodDiscrete;break;case sc:t=this.InterpolantFactoryMethodLinear;break;case Ql:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return fa;case this.InterpolantFactoryMethodLinear:return sc;case this.InterpolantFactoryMethodSmooth:return Ql}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Q_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Ql,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,f=h-n,m=h+n;for(let g=0;g!==n;++g){let v=t[h+g];if(v!==t[f+g]||v!==t[m+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,f=o*n;for(let m=0;m!==n;++m)t[f+m]=t[h+m]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};li.prototype.ValueTypeName="";li.prototype.TimeBufferType=Float32Array;li.prototype.ValueBufferType=Float32Array;li.prototype.DefaultInterpolation=sc;var Bs=class extends li{constructor(e,t,n){super(e,t,n)}};Bs.prototype.ValueTypeName="bool";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=fa;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var Tc=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Tc.prototype.ValueTypeName="color";var Ac=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Ac.prototype.ValueTypeName="number";var Rc=class extends mr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)sn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ua=class extends li{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Rc(this.times,this.values,this.getValueSize(),e)}};Ua.prototype.ValueTypeName="quaternion";Ua.prototype.InterpolantFactoryMethodSmooth=void 0;var zs=class extends li{constructor(e,t,n){super(e,t,n)}};zs.prototype.ValueTypeName="string";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=fa;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Cc=class extends li{constructor(e,t,n,s){super(e,t,n,s)}};Cc.prototype.ValueTypeName="vector";var Pc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let m=c[h],g=c[h+1];if(m.global&&(m.lastIndex=0),m.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},ng=new Pc,Ic=class{constructor(e){this.manager=e!==void 0?e:ng,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};Ic.DEFAULT_MATERIAL_NAME="__DEFAULT";var Na=class extends ln{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ot(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}},Fa=class extends Na{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ot(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}},nf=new Ut,am=new I,lm=new I,hf=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Fe(512,512),this.mapType=Fi,this.map=null,this.mapPass=null,this.matrix=new Ut,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new _o,this._frameExtents=new Fe(1,1),this._viewportCount=1,this._viewports=[new It(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera,n=this.matrix;am.setFromMatrixPosition(e.matrixWorld),t.position.copy(am),lm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(lm),t.updateMatrixWorld(),nf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(nf,t.coordinateSystem,t.reversedDepth),t.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(nf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var gr=class extends ya{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},uf=class extends hf{constructor(){super(new gr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Oa=class extends Na{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(ln.DEFAULT_UP),this.updateMatrix(),this.target=new ln,this.shadow=new uf}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}};var Ba=class extends Ot{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Lc=class extends Dn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var Nf="\\[\\]\\.:\\/",ey=new RegExp("["+Nf+"]","g"),Ff="[^"+Nf+"]",ty="[^"+Nf.replace("\\.","")+"]",ny=/((?:WC+[\/:])*)/.source.replace("WC",Ff),iy=/(WCOD+)?/.source.replace("WCOD",ty),sy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ff),ry=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ff),oy=new RegExp("^"+ny+iy+sy+ry+"$"),ay=["material","materials","bones","map"],ff=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ey,"")}static parseTrackName(e){let t=oy.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ay.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=ff;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var EA=new Float32Array(1);var ks=class extends vo{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var bo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=nt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(nt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var cm=new I,Jl=new I,oo=new I,ao=new I,sf=new I,ly=new I,cy=new I,za=class{constructor(e=new I,t=new I){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){cm.subVectors(e,this.start),Jl.subVectors(this.end,this.start);let n=Jl.dot(Jl),r=Jl.dot(cm)/n;return t&&(r=nt(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=ly,n=cy){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;oo.subVectors(c,a),ao.subVectors(u,l),sf.subVectors(a,l);let h=oo.dot(oo),f=ao.dot(ao),m=ao.dot(sf);if(h<=s&&f<=s)return t.copy(a),n.copy(l),t.sub(n),t.dot(t);if(h<=s)r=0,o=m/f,o=nt(o,0,1);else{let g=oo.dot(sf);if(f<=s)o=0,r=nt(-g/h,0,1);else{let v=oo.dot(ao),p=h*f-v*v;p!==0?r=nt((v*m-g*f)/p,0,1):r=0,o=(v*r+m)/f,o<0?(o=0,r=nt(-g/h,0,1)):o>1&&(o=1,r=nt((v-g)/h,0,1))}}return t.copy(a).add(oo.multiplyScalar(r)),n.copy(l).add(ao.multiplyScalar(o)),t.sub(n),t.dot(t)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var hm=new I,jl,rf,ka=class extends ln{constructor(e=new I(0,0,1),t=new I(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",jl===void 0&&(jl=new Ot,jl.setAttribute("position",new mt([0,0,0,0,1,0],3)),rf=new pr(.5,1,5,1),rf.translate(0,-.5,0)),this.position.copy(t),this.line=new fr(jl,new vs({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Ke(rf,new oi({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{hm.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(hm,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var Ha=class extends Zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Of(i,e,t,n){let s=hy(n);switch(t){case Sf:return i*e;case Tf:return i*e/s.components*s.byteLength;case qc:return i*e/s.components*s.byteLength;case Af:return i*e*2/s.components*s.byteLength;case Yc:return i*e*2/s.components*s.byteLength;case Ef:return i*e*3/s.components*s.byteLength;case xi:return i*e*4/s.components*s.byteLength;case $c:return i*e*4/s.components*s.byteLength;case Wa:case Xa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case qa:case Ya:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Kc:case jc:return Math.max(i,16)*Math.max(e,8)/4;case Zc:case Jc:return Math.max(i,8)*Math.max(e,8)/2;case Qc:case eh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case th:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case nh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ih:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case sh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case rh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case oh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case ah:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case lh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case ch:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case hh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case uh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case fh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case dh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case ph:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case mh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case gh:case vh:case xh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case _h:case yh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case bh:case Mh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function hy(i){switch(i){case Fi:case yf:return{byteLength:1,components:1};case Mo:case bf:case wo:return{byteLength:2,components:1};case Wc:case Xc:return{byteLength:2,components:4};case Ws:case Gc:case es:return{byteLength:4,components:1};case Mf:case wf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function Tg(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function gy(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((m,g)=>m.start-g.start);let f=0;for(let m=1;m<h.length;m++){let g=h[f],v=h[m];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let m=0,g=h.length;m<g;m++){let v=h[m];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var vy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,xy=`#ifdef USE_ALPHAHASH
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
#endif`,_y=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,yy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,by=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,My=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,wy=`#ifdef USE_AOMAP
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
#endif`,Sy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Ey=`#ifdef USE_BATCHING
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
#endif`,Ty=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Ay=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Ry=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Cy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Py=`#ifdef USE_IRIDESCENCE
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
#endif`,Iy=`#ifdef USE_BUMPMAP
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
#endif`,Ly=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Dy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Uy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ny=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Fy=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Oy=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,By=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,zy=`#if defined( USE_COLOR_ALPHA )
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
#endif`,ky=`#define PI 3.141592653589793
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
} // validated`,Hy=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Vy=`vec3 transformedNormal = objectNormal;
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
#endif`,Gy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Wy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Xy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,qy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Yy="gl_FragColor = linearToOutputTexel( gl_FragColor );",$y=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Zy=`#ifdef USE_ENVMAP
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
#endif`,Ky=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Jy=`#ifdef USE_ENVMAP
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
#endif`,jy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Qy=`#ifdef USE_ENVMAP
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
#endif`,eb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,tb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,nb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ib=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,sb=`#ifdef USE_GRADIENTMAP
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
}`,rb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,ob=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,ab=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,lb=`uniform bool receiveShadow;
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
#endif`,cb=`#ifdef USE_ENVMAP
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
#endif`,hb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ub=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,fb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,db=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,pb=`PhysicalMaterial material;
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
#endif`,mb=`struct PhysicalMaterial {
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
}`,gb=`
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
#endif`,vb=`#if defined( RE_IndirectDiffuse )
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
#endif`,xb=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,_b=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,yb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Mb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,wb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Sb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Eb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Tb=`#if defined( USE_POINTS_UV )
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
#endif`,Ab=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Rb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Cb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Pb=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Ib=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Lb=`#ifdef USE_MORPHTARGETS
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
#endif`,Db=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ub=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Nb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Fb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ob=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Bb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,zb=`#ifdef USE_NORMALMAP
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
#endif`,kb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Hb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Vb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Gb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Wb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Xb=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,qb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Yb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,$b=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Zb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Kb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Jb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,jb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Qb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,eM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,tM=`float getShadowMask() {
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
}`,nM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,iM=`#ifdef USE_SKINNING
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
#endif`,sM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,rM=`#ifdef USE_SKINNING
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
#endif`,oM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,aM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,lM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,cM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,hM=`#ifdef USE_TRANSMISSION
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
#endif`,uM=`#ifdef USE_TRANSMISSION
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
#endif`,fM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,gM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,vM=`uniform sampler2D t2D;
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
}`,xM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_M=`#ifdef ENVMAP_TYPE_CUBE
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
}`,yM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,bM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,MM=`#include <common>
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
}`,wM=`#if DEPTH_PACKING == 3200
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
}`,SM=`#define DISTANCE
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
}`,EM=`#define DISTANCE
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
}`,TM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,AM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RM=`uniform float scale;
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
}`,CM=`uniform vec3 diffuse;
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
}`,PM=`#include <common>
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
}`,IM=`uniform vec3 diffuse;
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
}`,LM=`#define LAMBERT
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
}`,DM=`#define LAMBERT
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
}`,UM=`#define MATCAP
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
}`,NM=`#define MATCAP
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
}`,FM=`#define NORMAL
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
}`,OM=`#define NORMAL
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
}`,BM=`#define PHONG
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
}`,zM=`#define PHONG
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
}`,kM=`#define STANDARD
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
}`,HM=`#define STANDARD
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
}`,VM=`#define TOON
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
}`,GM=`#define TOON
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
}`,WM=`uniform float size;
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
}`,XM=`uniform vec3 diffuse;
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
}`,qM=`#include <common>
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
}`,YM=`uniform vec3 color;
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
}`,$M=`uniform float rotation;
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
}`,ZM=`uniform vec3 diffuse;
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
}`,dt={alphahash_fragment:vy,alphahash_pars_fragment:xy,alphamap_fragment:_y,alphamap_pars_fragment:yy,alphatest_fragment:by,alphatest_pars_fragment:My,aomap_fragment:wy,aomap_pars_fragment:Sy,batching_pars_vertex:Ey,batching_vertex:Ty,begin_vertex:Ay,beginnormal_vertex:Ry,bsdfs:Cy,iridescence_fragment:Py,bumpmap_pars_fragment:Iy,clipping_planes_fragment:Ly,clipping_planes_pars_fragment:Dy,clipping_planes_pars_vertex:Uy,clipping_planes_vertex:Ny,color_fragment:Fy,color_pars_fragment:Oy,color_pars_vertex:By,color_vertex:zy,common:ky,cube_uv_reflection_fragment:Hy,defaultnormal_vertex:Vy,displacementmap_pars_vertex:Gy,displacementmap_vertex:Wy,emissivemap_fragment:Xy,emissivemap_pars_fragment:qy,colorspace_fragment:Yy,colorspace_pars_fragment:$y,envmap_fragment:Zy,envmap_common_pars_fragment:Ky,envmap_pars_fragment:Jy,envmap_pars_vertex:jy,envmap_physical_pars_fragment:cb,envmap_vertex:Qy,fog_vertex:eb,fog_pars_vertex:tb,fog_fragment:nb,fog_pars_fragment:ib,gradientmap_pars_fragment:sb,lightmap_pars_fragment:rb,lights_lambert_fragment:ob,lights_lambert_pars_fragment:ab,lights_pars_begin:lb,lights_toon_fragment:hb,lights_toon_pars_fragment:ub,lights_phong_fragment:fb,lights_phong_pars_fragment:db,lights_physical_fragment:pb,lights_physical_pars_fragment:mb,lights_fragment_begin:gb,lights_fragment_maps:vb,lights_fragment_end:xb,logdepthbuf_fragment:_b,logdepthbuf_pars_fragment:yb,logdepthbuf_pars_vertex:bb,logdepthbuf_vertex:Mb,map_fragment:wb,map_pars_fragment:Sb,map_particle_fragment:Eb,map_particle_pars_fragment:Tb,metalnessmap_fragment:Ab,metalnessmap_pars_fragment:Rb,morphinstance_vertex:Cb,morphcolor_vertex:Pb,morphnormal_vertex:Ib,morphtarget_pars_vertex:Lb,morphtarget_vertex:Db,normal_fragment_begin:Ub,normal_fragment_maps:Nb,normal_pars_fragment:Fb,normal_pars_vertex:Ob,normal_vertex:Bb,normalmap_pars_fragment:zb,clearcoat_normal_fragment_begin:kb,clearcoat_normal_fragment_maps:Hb,clearcoat_pars_fragment:Vb,iridescence_pars_fragment:Gb,opaque_fragment:Wb,packing:Xb,premultiplied_alpha_fragment:qb,project_vertex:Yb,dithering_fragment:$b,dithering_pars_fragment:Zb,roughnessmap_fragment:Kb,roughnessmap_pars_fragment:Jb,shadowmap_pars_fragment:jb,shadowmap_pars_vertex:Qb,shadowmap_vertex:eM,shadowmask_pars_fragment:tM,skinbase_vertex:nM,skinning_pars_vertex:iM,skinning_vertex:sM,skinnormal_vertex:rM,specularmap_fragment:oM,specularmap_pars_fragment:aM,tonemapping_fragment:lM,tonemapping_pars_fragment:cM,transmission_fragment:hM,transmission_pars_fragment:uM,uv_pars_fragment:fM,uv_pars_vertex:dM,uv_vertex:pM,worldpos_vertex:mM,background_vert:gM,background_frag:vM,backgroundCube_vert:xM,backgroundCube_frag:_M,cube_vert:yM,cube_frag:bM,depth_vert:MM,depth_frag:wM,distanceRGBA_vert:SM,distanceRGBA_frag:EM,equirect_vert:TM,equirect_frag:AM,linedashed_vert:RM,linedashed_frag:CM,meshbasic_vert:PM,meshbasic_frag:IM,meshlambert_vert:LM,meshlambert_frag:DM,meshmatcap_vert:UM,meshmatcap_frag:NM,meshnormal_vert:FM,meshnormal_frag:OM,meshphong_vert:BM,meshphong_frag:zM,meshphysical_vert:kM,meshphysical_frag:HM,meshtoon_vert:VM,meshtoon_frag:GM,points_vert:WM,points_frag:XM,shadow_vert:qM,shadow_frag:YM,sprite_vert:$M,sprite_frag:ZM},Ue={common:{diffuse:{value:new ot(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ht},alphaMap:{value:null},alphaMapTransform:{value:new ht},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ht}},envmap:{envMap:{value:null},envMapRotation:{value:new ht},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ht}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ht}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ht},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ht},normalScale:{value:new Fe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ht},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ht}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ht}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ht}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ot(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ot(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ht},alphaTest:{value:0},uvTransform:{value:new ht}},sprite:{diffuse:{value:new ot(16777215)},opacity:{value:1},center:{value:new Fe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ht},alphaMap:{value:null},alphaMapTransform:{value:new ht},alphaTest:{value:0}}},Xn={basic:{uniforms:Un([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:dt.meshbasic_vert,fragmentShader:dt.meshbasic_frag},lambert:{uniforms:Un([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new ot(0)}}]),vertexShader:dt.meshlambert_vert,fragmentShader:dt.meshlambert_frag},phong:{uniforms:Un([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new ot(0)},specular:{value:new ot(1118481)},shininess:{value:30}}]),vertexShader:dt.meshphong_vert,fragmentShader:dt.meshphong_frag},standard:{uniforms:Un([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new ot(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag},toon:{uniforms:Un([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new ot(0)}}]),vertexShader:dt.meshtoon_vert,fragmentShader:dt.meshtoon_frag},matcap:{uniforms:Un([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:dt.meshmatcap_vert,fragmentShader:dt.meshmatcap_frag},points:{uniforms:Un([Ue.points,Ue.fog]),vertexShader:dt.points_vert,fragmentShader:dt.points_frag},dashed:{uniforms:Un([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:dt.linedashed_vert,fragmentShader:dt.linedashed_frag},depth:{uniforms:Un([Ue.common,Ue.displacementmap]),vertexShader:dt.depth_vert,fragmentShader:dt.depth_frag},normal:{uniforms:Un([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:dt.meshnormal_vert,fragmentShader:dt.meshnormal_frag},sprite:{uniforms:Un([Ue.sprite,Ue.fog]),vertexShader:dt.sprite_vert,fragmentShader:dt.sprite_frag},background:{uniforms:{uvTransform:{value:new ht},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:dt.background_vert,fragmentShader:dt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ht}},vertexShader:dt.backgroundCube_vert,fragmentShader:dt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:dt.cube_vert,fragmentShader:dt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:dt.equirect_vert,fragmentShader:dt.equirect_frag},distanceRGBA:{uniforms:Un([Ue.common,Ue.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:dt.distanceRGBA_vert,fragmentShader:dt.distanceRGBA_frag},shadow:{uniforms:Un([Ue.lights,Ue.fog,{color:{value:new ot(0)},opacity:{value:1}}]),vertexShader:dt.shadow_vert,fragmentShader:dt.shadow_frag}};Xn.physical={uniforms:Un([Xn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ht},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ht},clearcoatNormalScale:{value:new Fe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ht},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ht},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ht},sheen:{value:0},sheenColor:{value:new ot(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ht},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ht},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ht},transmissionSamplerSize:{value:new Fe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ht},attenuationDistance:{value:0},attenuationColor:{value:new ot(0)},specularColor:{value:new ot(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ht},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ht},anisotropyVector:{value:new Fe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ht}}]),vertexShader:dt.meshphysical_vert,fragmentShader:dt.meshphysical_frag};var Eh={r:0,b:0,g:0},yr=new Ui,KM=new Ut;function JM(i,e,t,n,s,r,o){let a=new ot(0),l=r===!0?0:1,c,u,h=null,f=0,m=null;function g(b){let _=b.isScene===!0?b.background:null;return _&&_.isTexture&&(_=(b.backgroundBlurriness>0?t:e).get(_)),_}function v(b){let _=!1,C=g(b);C===null?d(a,l):C&&C.isColor&&(d(C,1),_=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?n.buffers.color.setClear(0,0,0,1,o):E==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||_)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function p(b,_){let C=g(_);C&&(C.isCubeTexture||C.mapping===Va)?(u===void 0&&(u=new Ke(new ji(1,1,1),new ai({name:"BackgroundCubeMaterial",uniforms:_r(Xn.backgroundCube.uniforms),vertexShader:Xn.backgroundCube.vertexShader,fragmentShader:Xn.backgroundCube.fragmentShader,side:Wn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(E,P,L){this.matrixWorld.copyPosition(L.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),yr.copy(_.backgroundRotation),yr.x*=-1,yr.y*=-1,yr.z*=-1,C.isCubeTexture&&C.isRenderTargetTexture===!1&&(yr.y*=-1,yr.z*=-1),u.material.uniforms.envMap.value=C,u.material.uniforms.flipEnvMap.value=C.isCubeTexture&&C.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(KM.makeRotationFromEuler(yr)),u.material.toneMapped=xt.getTransfer(C.colorSpace)!==Pt,(h!==C||f!==C.version||m!==i.toneMapping)&&(u.material.needsUpdate=!0,h=C,f=C.version,m=i.toneMapping),u.layers.enableAll(),b.unshift(u,u.geometry,u.material,0,0,null)):C&&C.isTexture&&(c===void 0&&(c=new Ke(new Ca(2,2),new ai({name:"BackgroundMaterial",uniforms:_r(Xn.background.uniforms),vertexShader:Xn.background.vertexShader,fragmentShader:Xn.background.fragmentShader,side:gs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=C,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,c.material.toneMapped=xt.getTransfer(C.colorSpace)!==Pt,C.matrixAutoUpdate===!0&&C.updateMatrix(),c.material.uniforms.uvTransform.value.copy(C.matrix),(h!==C||f!==C.version||m!==i.toneMapping)&&(c.material.needsUpdate=!0,h=C,f=C.version,m=i.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null))}function d(b,_){b.getRGB(Eh,Df(i)),n.buffers.color.setClear(Eh.r,Eh.g,Eh.b,_,o)}function y(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(b,_=1){a.set(b),l=_,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(b){l=b,d(a,l)},render:v,addToRenderList:p,dispose:y}}function jM(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(S,A,k,O,V){let q=!1,$=h(O,k,A);r!==$&&(r=$,c(r.object)),q=m(S,O,k,V),q&&g(S,O,k,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,_(S,A,k,O),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function u(S){return i.deleteVertexArray(S)}function h(S,A,k){let O=k.wireframe===!0,V=n[S.id];V===void 0&&(V={},n[S.id]=V);let q=V[A.id];q===void 0&&(q={},V[A.id]=q);let $=q[O];return $===void 0&&($=f(l()),q[O]=$),$}function f(S){let A=[],k=[],O=[];for(let V=0;V<t;V++)A[V]=0,k[V]=0,O[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:A,enabledAttributes:k,attributeDivisors:O,object:S,attributes:{},index:null}}function m(S,A,k,O){let V=r.attributes,q=A.attributes,$=0,N=k.getAttributes();for(let z in N)if(N[z].location>=0){let ie=V[z],ne=q[z];if(ne===void 0&&(z==="instanceMatrix"&&S.instanceMatrix&&(ne=S.instanceMatrix),z==="instanceColor"&&S.instanceColor&&(ne=S.instanceColor)),ie===void 0||ie.attribute!==ne||ne&&ie.data!==ne.data)return!0;$++}return r.attributesNum!==$||r.index!==O}function g(S,A,k,O){let V={},q=A.attributes,$=0,N=k.getAttributes();for(let z in N)if(N[z].location>=0){let ie=q[z];ie===void 0&&(z==="instanceMatrix"&&S.instanceMatrix&&(ie=S.instanceMatrix),z==="instanceColor"&&S.instanceColor&&(ie=S.instanceColor));let ne={};ne.attribute=ie,ie&&ie.data&&(ne.data=ie.data),V[z]=ne,$++}r.attributes=V,r.attributesNum=$,r.index=O}function v(){let S=r.newAttributes;for(let A=0,k=S.length;A<k;A++)S[A]=0}function p(S){d(S,0)}function d(S,A){let k=r.newAttributes,O=r.enabledAttributes,V=r.attributeDivisors;k[S]=1,O[S]===0&&(i.enableVertexAttribArray(S),O[S]=1),V[S]!==A&&(i.vertexAttribDivisor(S,A),V[S]=A)}function y(){let S=r.newAttributes,A=r.enabledAttributes;for(let k=0,O=A.length;k<O;k++)A[k]!==S[k]&&(i.disableVertexAttribArray(k),A[k]=0)}function b(S,A,k,O,V,q,$){$===!0?i.vertexAttribIPointer(S,A,k,V,q):i.vertexAttribPointer(S,A,k,O,V,q)}function _(S,A,k,O){v();let V=O.attributes,q=k.getAttributes(),$=A.defaultAttributeValues;for(let N in q){let z=q[N];if(z.location>=0){let Q=V[N];if(Q===void 0&&(N==="instanceMatrix"&&S.instanceMatrix&&(Q=S.instanceMatrix),N==="instanceColor"&&S.instanceColor&&(Q=S.instanceColor)),Q!==void 0){let ie=Q.normalized,ne=Q.itemSize,ce=e.get(Q);if(ce===void 0)continue;let he=ce.buffer,Me=ce.type,Ee=ce.bytesPerElement,te=Me===i.INT||Me===i.UNSIGNED_INT||Q.gpuType===Gc;if(Q.isInterleavedBufferAttribute){let K=Q.data,ve=K.stride,_e=Q.offset;if(K.isInstancedInterleavedBuffer){for(let Ae=0;Ae<z.locationSize;Ae++)d(z.location+Ae,K.meshPerAttribute);S.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let Ae=0;Ae<z.locationSize;Ae++)p(z.location+Ae);i.bindBuffer(i.ARRAY_BUFFER,he);for(let Ae=0;Ae<z.locationSize;Ae++)b(z.location+Ae,ne/z.locationSize,Me,ie,ve*Ee,(_e+ne/z.locationSize*Ae)*Ee,te)}else{if(Q.isInstancedBufferAttribute){for(let K=0;K<z.locationSize;K++)d(z.location+K,Q.meshPerAttribute);S.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let K=0;K<z.locationSize;K++)p(z.location+K);i.bindBuffer(i.ARRAY_BUFFER,he);for(let K=0;K<z.locationSize;K++)b(z.location+K,ne/z.locationSize,Me,ie,ne*Ee,ne/z.locationSize*K*Ee,te)}}else if($!==void 0){let ie=$[N];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(z.location,ie);break;case 3:i.vertexAttrib3fv(z.location,ie);break;case 4:i.vertexAttrib4fv(z.location,ie);break;default:i.vertexAttrib1fv(z.location,ie)}}}}y()}function C(){L();for(let S in n){let A=n[S];for(let k in A){let O=A[k];for(let V in O)u(O[V].object),delete O[V];delete A[k]}delete n[S]}}function E(S){if(n[S.id]===void 0)return;let A=n[S.id];for(let k in A){let O=A[k];for(let V in O)u(O[V].object),delete O[V];delete A[k]}delete n[S.id]}function P(S){for(let A in n){let k=n[A];if(k[S.id]===void 0)continue;let O=k[S.id];for(let V in O)u(O[V].object),delete O[V];delete k[S.id]}}function L(){M(),o=!0,r!==s&&(r=s,c(r.object))}function M(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:M,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfProgram:P,initAttributes:v,enableAttribute:p,disableUnusedAttributes:y}}function QM(i,e,t){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),t.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),t.update(u,n,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let m=0;for(let g=0;g<h;g++)m+=u[g];t.update(m,n,1)}function l(c,u,h,f){if(h===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{m.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];t.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function ew(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let P=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(P.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(P){return!(P!==xi&&n.convert(P)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(P){let L=P===wo&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(P!==Fi&&n.convert(P)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&P!==es&&!L)}function l(P){if(P==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";P="mediump"}return P==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.logarithmicDepthBuffer===!0,f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),b=i.getParameter(i.MAX_VARYING_VECTORS),_=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=g>0,E=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:m,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:p,maxAttributes:d,maxVertexUniforms:y,maxVaryings:b,maxFragmentUniforms:_,vertexTextures:C,maxSamples:E}}function tw(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Zn,a=new ht,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let m=h.length!==0||f||n!==0||s;return s=f,n=h.length,m},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,m){let g=h.clippingPlanes,v=h.clipIntersection,p=h.clipShadows,d=i.get(h);if(!s||g===null||g.length===0||r&&!p)r?u(null):c();else{let y=r?0:n,b=y*4,_=d.clippingState||null;l.value=_,_=u(g,f,b,m);for(let C=0;C!==b;++C)_[C]=t[C];d.clippingState=_,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,f,m,g){let v=h!==null?h.length:0,p=null;if(v!==0){if(p=l.value,g!==!0||p===null){let d=m+v*4,y=f.matrixWorldInverse;a.getNormalMatrix(y),(p===null||p.length<d)&&(p=new Float32Array(d));for(let b=0,_=m;b!==v;++b,_+=4)o.copy(h[b]).applyMatrix4(y,a),o.normal.toArray(p,_),p[_+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,p}}function nw(i){let e=new WeakMap;function t(o,a){return a===kc?o.mapping=vr:a===Hc&&(o.mapping=xr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===kc||a===Hc)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new hc(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var Ao=4,ig=[.125,.215,.35,.446,.526,.582],wr=20,Bf=new gr,sg=new ot,zf=null,kf=0,Hf=0,Vf=!1,Mr=(1+Math.sqrt(5))/2,To=1/Mr,rg=[new I(-Mr,To,0),new I(Mr,To,0),new I(-To,0,Mr),new I(To,0,Mr),new I(0,Mr,-To),new I(0,Mr,To),new I(-1,1,-1),new I(1,1,-1),new I(-1,1,1),new I(1,1,1)],iw=new I,Rh=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=iw}=r;zf=this._renderer.getRenderTarget(),kf=this._renderer.getActiveCubeFace(),Hf=this._renderer.getActiveMipmapLevel(),Vf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=lg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ag(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(zf,kf,Hf),this._renderer.xr.enabled=Vf,e.scissorTest=!1,Th(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===vr||e.mapping===xr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),zf=this._renderer.getRenderTarget(),kf=this._renderer.getActiveCubeFace(),Hf=this._renderer.getActiveMipmapLevel(),Vf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:Li,minFilter:Li,generateMipmaps:!1,type:wo,format:xi,colorSpace:hr,depthBuffer:!1},s=og(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=og(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=sw(r)),this._blurMaterial=rw(r,e,t)}return s}_compileMaterial(e){let t=new Ke(this._lodPlanes[0],e);this._renderer.compile(t,Bf)}_sceneToCubeUV(e,t,n,s,r){let l=new Dn(90,1,t,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,m=h.toneMapping;h.getClearColor(sg),h.toneMapping=_s,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let v=new oi({name:"PMREM.Background",side:Wn,depthWrite:!1,depthTest:!1}),p=new Ke(new ji,v),d=!1,y=e.background;y?y.isColor&&(v.color.copy(y),e.background=null,d=!0):(v.color.copy(sg),d=!0);for(let b=0;b<6;b++){let _=b%3;_===0?(l.up.set(0,c[b],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[b],r.y,r.z)):_===1?(l.up.set(0,0,c[b]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[b],r.z)):(l.up.set(0,c[b],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[b]));let C=this._cubeSize;Th(s,_*C,b>2?C:0,C,C),h.setRenderTarget(s),d&&h.render(p,l),h.render(e,l)}p.geometry.dispose(),p.material.dispose(),h.toneMapping=m,h.autoClear=f,e.background=y}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===vr||e.mapping===xr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=lg()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=ag());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Ke(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Th(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,Bf)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=rg[(s-r-1)%rg.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new Ke(this._lodPlanes[s],c),f=c.uniforms,m=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*m):2*Math.PI/(2*wr-1),v=r/g,p=isFinite(r)?1+Math.floor(u*v):wr;p>wr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${wr}`);let d=[],y=0;for(let P=0;P<wr;++P){let L=P/v,M=Math.exp(-L*L/2);d.push(M),P===0?y+=M:P<p&&(y+=2*M)}for(let P=0;P<d.length;P++)d[P]=d[P]/y;f.envMap.value=e.texture,f.samples.value=p,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:b}=this;f.dTheta.value=g,f.mipInt.value=b-n;let _=this._sizeLods[s],C=3*_*(s>b-Ao?s-b+Ao:0),E=4*(this._cubeSize-_);Th(t,C,E,3*_,2*_),l.setRenderTarget(t),l.render(h,Bf)}};function sw(i){let e=[],t=[],n=[],s=i,r=i-Ao+1+ig.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>i-Ao?l=ig[o-i+Ao-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],m=6,g=6,v=3,p=2,d=1,y=new Float32Array(v*g*m),b=new Float32Array(p*g*m),_=new Float32Array(d*g*m);for(let E=0;E<m;E++){let P=E%3*2/3-1,L=E>2?0:-1,M=[P,L,0,P+2/3,L,0,P+2/3,L+1,0,P,L,0,P+2/3,L+1,0,P,L+1,0];y.set(M,v*g*E),b.set(f,p*g*E);let S=[E,E,E,E,E,E];_.set(S,d*g*E)}let C=new Ot;C.setAttribute("position",new Jt(y,v)),C.setAttribute("uv",new Jt(b,p)),C.setAttribute("faceIndex",new Jt(_,d)),e.push(C),s>Ao&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function og(i,e,t){let n=new Ki(i,e,t);return n.texture.mapping=Va,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Th(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function rw(i,e,t){let n=new Float32Array(wr),s=new I(0,1,0);return new ai({name:"SphericalGaussianBlur",defines:{n:wr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:jf(),fragmentShader:`

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
		`,blending:xs,depthTest:!1,depthWrite:!1})}function ag(){return new ai({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:jf(),fragmentShader:`

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
		`,blending:xs,depthTest:!1,depthWrite:!1})}function lg(){return new ai({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:jf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:xs,depthTest:!1,depthWrite:!1})}function jf(){return`

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
	`}function ow(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===kc||l===Hc,u=l===vr||l===xr;if(c||u){let h=e.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new Rh(i)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{let m=a.image;return c&&m&&m.height>0||u&&m&&s(m)?(t===null&&(t=new Rh(i)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function aw(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&fo("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function lw(i,e,t,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&e.remove(f.index);for(let g in f.attributes)e.remove(f.attributes[g]);f.removeEventListener("dispose",o),delete s[f.id];let m=r.get(f);m&&(e.remove(m),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(h){let f=h.attributes;for(let m in f)e.update(f[m],i.ARRAY_BUFFER)}function c(h){let f=[],m=h.index,g=h.attributes.position,v=0;if(m!==null){let y=m.array;v=m.version;for(let b=0,_=y.length;b<_;b+=3){let C=y[b+0],E=y[b+1],P=y[b+2];f.push(C,E,E,P,P,C)}}else if(g!==void 0){let y=g.array;v=g.version;for(let b=0,_=y.length/3-1;b<_;b+=3){let C=b+0,E=b+1,P=b+2;f.push(C,E,E,P,P,C)}}else return;let p=new(Lf(f)?_a:xa)(f,1);p.version=v;let d=r.get(h);d&&e.remove(d),r.set(h,p)}function u(h){let f=r.get(h);if(f){let m=h.index;m!==null&&f.version<m.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function cw(i,e,t){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,m){i.drawElements(n,m,r,f*o),t.update(m,n,1)}function c(f,m,g){g!==0&&(i.drawElementsInstanced(n,m,r,f*o,g),t.update(m,n,g))}function u(f,m,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,m,0,r,f,0,g);let p=0;for(let d=0;d<g;d++)p+=m[d];t.update(p,n,1)}function h(f,m,g,v){if(g===0)return;let p=e.get("WEBGL_multi_draw");if(p===null)for(let d=0;d<f.length;d++)c(f[d]/o,m[d],v[d]);else{p.multiDrawElementsInstancedWEBGL(n,m,0,r,f,0,v,0,g);let d=0;for(let y=0;y<g;y++)d+=m[y]*v[y];t.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function hw(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function uw(i,e,t){let n=new WeakMap,s=new It;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let M=function(){P.dispose(),n.delete(a),a.removeEventListener("dispose",M)};f!==void 0&&f.texture.dispose();let m=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],b=0;m===!0&&(b=1),g===!0&&(b=2),v===!0&&(b=3);let _=a.attributes.position.count*b,C=1;_>e.maxTextureSize&&(C=Math.ceil(_/e.maxTextureSize),_=e.maxTextureSize);let E=new Float32Array(_*C*4*h),P=new ga(E,_,C,h);P.type=es,P.needsUpdate=!0;let L=b*4;for(let S=0;S<h;S++){let A=p[S],k=d[S],O=y[S],V=_*C*4*S;for(let q=0;q<A.count;q++){let $=q*L;m===!0&&(s.fromBufferAttribute(A,q),E[V+$+0]=s.x,E[V+$+1]=s.y,E[V+$+2]=s.z,E[V+$+3]=0),g===!0&&(s.fromBufferAttribute(k,q),E[V+$+4]=s.x,E[V+$+5]=s.y,E[V+$+6]=s.z,E[V+$+7]=0),v===!0&&(s.fromBufferAttribute(O,q),E[V+$+8]=s.x,E[V+$+9]=s.y,E[V+$+10]=s.z,E[V+$+11]=O.itemSize===4?s.w:1)}}f={count:h,texture:P,size:new Fe(_,C)},n.set(a,f),a.addEventListener("dispose",M)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let m=0;for(let v=0;v<c.length;v++)m+=c[v];let g=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function fw(i,e,t,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var Ag=new Kn,cg=new Sa(1,1),Rg=new ga,Cg=new lc,Pg=new ba,hg=[],ug=[],fg=new Float32Array(16),dg=new Float32Array(9),pg=new Float32Array(4);function Co(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=hg[s];if(r===void 0&&(r=new Float32Array(s),hg[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function cn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function hn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ph(i,e){let t=ug[e];t===void 0&&(t=new Int32Array(e),ug[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function dw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function pw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2fv(this.addr,e),hn(t,e)}}function mw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(cn(t,e))return;i.uniform3fv(this.addr,e),hn(t,e)}}function gw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4fv(this.addr,e),hn(t,e)}}function vw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;pg.set(n),i.uniformMatrix2fv(this.addr,!1,pg),hn(t,n)}}function xw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;dg.set(n),i.uniformMatrix3fv(this.addr,!1,dg),hn(t,n)}}function _w(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(cn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),hn(t,e)}else{if(cn(t,n))return;fg.set(n),i.uniformMatrix4fv(this.addr,!1,fg),hn(t,n)}}function yw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function bw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2iv(this.addr,e),hn(t,e)}}function Mw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(cn(t,e))return;i.uniform3iv(this.addr,e),hn(t,e)}}function ww(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4iv(this.addr,e),hn(t,e)}}function Sw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function Ew(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(cn(t,e))return;i.uniform2uiv(this.addr,e),hn(t,e)}}function Tw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(cn(t,e))return;i.uniform3uiv(this.addr,e),hn(t,e)}}function Aw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(cn(t,e))return;i.uniform4uiv(this.addr,e),hn(t,e)}}function Rw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(cg.compareFunction=Cf,r=cg):r=Ag,t.setTexture2D(e||r,s)}function Cw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Cg,s)}function Pw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Pg,s)}function Iw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Rg,s)}function Lw(i){switch(i){case 5126:return dw;case 35664:return pw;case 35665:return mw;case 35666:return gw;case 35674:return vw;case 35675:return xw;case 35676:return _w;case 5124:case 35670:return yw;case 35667:case 35671:return bw;case 35668:case 35672:return Mw;case 35669:case 35673:return ww;case 5125:return Sw;case 36294:return Ew;case 36295:return Tw;case 36296:return Aw;case 35678:case 36198:case 36298:case 36306:case 35682:return Rw;case 35679:case 36299:case 36307:return Cw;case 35680:case 36300:case 36308:case 36293:return Pw;case 36289:case 36303:case 36311:case 36292:return Iw}}function Dw(i,e){i.uniform1fv(this.addr,e)}function Uw(i,e){let t=Co(e,this.size,2);i.uniform2fv(this.addr,t)}function Nw(i,e){let t=Co(e,this.size,3);i.uniform3fv(this.addr,t)}function Fw(i,e){let t=Co(e,this.size,4);i.uniform4fv(this.addr,t)}function Ow(i,e){let t=Co(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Bw(i,e){let t=Co(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function zw(i,e){let t=Co(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function kw(i,e){i.uniform1iv(this.addr,e)}function Hw(i,e){i.uniform2iv(this.addr,e)}function Vw(i,e){i.uniform3iv(this.addr,e)}function Gw(i,e){i.uniform4iv(this.addr,e)}function Ww(i,e){i.uniform1uiv(this.addr,e)}function Xw(i,e){i.uniform2uiv(this.addr,e)}function qw(i,e){i.uniform3uiv(this.addr,e)}function Yw(i,e){i.uniform4uiv(this.addr,e)}function $w(i,e,t){let n=this.cache,s=e.length,r=Ph(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||Ag,r[o])}function Zw(i,e,t){let n=this.cache,s=e.length,r=Ph(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Cg,r[o])}function Kw(i,e,t){let n=this.cache,s=e.length,r=Ph(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Pg,r[o])}function Jw(i,e,t){let n=this.cache,s=e.length,r=Ph(t,s);cn(n,r)||(i.uniform1iv(this.addr,r),hn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Rg,r[o])}function jw(i){switch(i){case 5126:return Dw;case 35664:return Uw;case 35665:return Nw;case 35666:return Fw;case 35674:return Ow;case 35675:return Bw;case 35676:return zw;case 5124:case 35670:return kw;case 35667:case 35671:return Hw;case 35668:case 35672:return Vw;case 35669:case 35673:return Gw;case 5125:return Ww;case 36294:return Xw;case 36295:return qw;case 36296:return Yw;case 35678:case 36198:case 36298:case 36306:case 35682:return $w;case 35679:case 36299:case 36307:return Zw;case 35680:case 36300:case 36308:case 36293:return Kw;case 36289:case 36303:case 36311:case 36292:return Jw}}var Wf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Lw(t.type)}},Xf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=jw(t.type)}},qf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Gf=/(\w+)(\])?(\[|\.)?/g;function mg(i,e){i.seq.push(e),i.map[e.id]=e}function Qw(i,e,t){let n=i.name,s=n.length;for(Gf.lastIndex=0;;){let r=Gf.exec(n),o=Gf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){mg(t,c===void 0?new Wf(a,i,e):new Xf(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new qf(a),mg(t,h)),t=h}}}var Ro=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);Qw(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function gg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var eS=37297,tS=0;function nS(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var vg=new ht;function iS(i){xt._getMatrix(vg,xt.workingColorSpace,i);let e=`mat3( ${vg.elements.map(t=>t.toFixed(4))} )`;switch(xt.getTransfer(i)){case da:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function xg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+nS(i.getShaderSource(e),a)}else return r}function sS(i,e){let t=iS(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function rS(i,e){let t;switch(e){case Um:t="Linear";break;case Nm:t="Reinhard";break;case Fm:t="Cineon";break;case Om:t="ACESFilmic";break;case zm:t="AgX";break;case km:t="Neutral";break;case Bm:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ah=new I;function oS(){xt.getLuminanceCoefficients(Ah);let i=Ah.x.toFixed(4),e=Ah.y.toFixed(4),t=Ah.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function aS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Za).join(`
`)}function lS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function cS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Za(i){return i!==""}function _g(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function yg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var hS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Yf(i){return i.replace(hS,fS)}var uS=new Map;function fS(i,e){let t=dt[e];if(t===void 0){let n=uS.get(e);if(n!==void 0)t=dt[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return Yf(t)}var dS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function bg(i){return i.replace(dS,pS)}function pS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Mg(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}function mS(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===pf?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===dm?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Qi&&(e="SHADOWMAP_TYPE_VSM"),e}function gS(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case vr:case xr:e="ENVMAP_TYPE_CUBE";break;case Va:e="ENVMAP_TYPE_CUBE_UV";break}return e}function vS(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case xr:e="ENVMAP_MODE_REFRACTION";break}return e}function xS(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case xf:e="ENVMAP_BLENDING_MULTIPLY";break;case Lm:e="ENVMAP_BLENDING_MIX";break;case Dm:e="ENVMAP_BLENDING_ADD";break}return e}function _S(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function yS(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=mS(t),c=gS(t),u=vS(t),h=xS(t),f=_S(t),m=aS(t),g=lS(r),v=s.createProgram(),p,d,y=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Za).join(`
`),p.length>0&&(p+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Za).join(`
`),d.length>0&&(d+=`
`)):(p=[Mg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Za).join(`
`),d=[Mg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==_s?"#define TONE_MAPPING":"",t.toneMapping!==_s?dt.tonemapping_pars_fragment:"",t.toneMapping!==_s?rS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",dt.colorspace_pars_fragment,sS("linearToOutputTexel",t.outputColorSpace),oS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Za).join(`
`)),o=Yf(o),o=_g(o,t),o=yg(o,t),a=Yf(a),a=_g(a,t),a=yg(a,t),o=bg(o),a=bg(a),t.isRawShaderMaterial!==!0&&(y=`#version 300 es
`,p=[m,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,d=["#define varying in",t.glslVersion===Pf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Pf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let b=y+p+o,_=y+d+a,C=gg(s,s.VERTEX_SHADER,b),E=gg(s,s.FRAGMENT_SHADER,_);s.attachShader(v,C),s.attachShader(v,E),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function P(A){if(i.debug.checkShaderErrors){let k=s.getProgramInfoLog(v)||"",O=s.getShaderInfoLog(C)||"",V=s.getShaderInfoLog(E)||"",q=k.trim(),$=O.trim(),N=V.trim(),z=!0,Q=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,C,E);else{let ie=xg(s,C,"vertex"),ne=xg(s,E,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+A.name+`
Material Type: `+A.type+`

Program Info Log: `+q+`
`+ie+`
`+ne)}else q!==""?console.warn("THREE.WebGLProgram: Program Info Log:",q):($===""||N==="")&&(Q=!1);Q&&(A.diagnostics={runnable:z,programLog:q,vertexShader:{log:$,prefix:p},fragmentShader:{log:N,prefix:d}})}s.deleteShader(C),s.deleteShader(E),L=new Ro(s,v),M=cS(s,v)}let L;this.getUniforms=function(){return L===void 0&&P(this),L};let M;this.getAttributes=function(){return M===void 0&&P(this),M};let S=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,eS)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=tS++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=C,this.fragmentShader=E,this}var bS=0,$f=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Zf(e),t.set(e,n)),n}},Zf=class{constructor(e){this.id=bS++,this.code=e,this.usedTimes=0}};function MS(i,e,t,n,s,r,o){let a=new va,l=new $f,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,m=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(M){return c.add(M),M===0?"uv":`uv${M}`}function p(M,S,A,k,O){let V=k.fog,q=O.geometry,$=M.isMeshStandardMaterial?k.environment:null,N=(M.isMeshStandardMaterial?t:e).get(M.envMap||$),z=N&&N.mapping===Va?N.image.height:null,Q=g[M.type];M.precision!==null&&(m=s.getMaxPrecision(M.precision),m!==M.precision&&console.warn("THREE.WebGLProgram.getParameters:",M.precision,"not supported, using",m,"instead."));let ie=q.morphAttributes.position||q.morphAttributes.normal||q.morphAttributes.color,ne=ie!==void 0?ie.length:0,ce=0;q.morphAttributes.position!==void 0&&(ce=1),q.morphAttributes.normal!==void 0&&(ce=2),q.morphAttributes.color!==void 0&&(ce=3);let he,Me,Ee,te;if(Q){let yt=Xn[Q];he=yt.vertexShader,Me=yt.fragmentShader}else he=M.vertexShader,Me=M.fragmentShader,l.update(M),Ee=l.getVertexShaderID(M),te=l.getFragmentShaderID(M);let K=i.getRenderTarget(),ve=i.state.buffers.depth.getReversed(),_e=O.isInstancedMesh===!0,Ae=O.isBatchedMesh===!0,We=!!M.map,ut=!!M.matcap,H=!!N,lt=!!M.aoMap,oe=!!M.lightMap,we=!!M.bumpMap,Pe=!!M.normalMap,at=!!M.displacementMap,ae=!!M.emissiveMap,De=!!M.metalnessMap,je=!!M.roughnessMap,rt=M.anisotropy>0,U=M.clearcoat>0,w=M.dispersion>0,G=M.iridescence>0,B=M.sheen>0,W=M.transmission>0,j=rt&&!!M.anisotropyMap,pe=U&&!!M.clearcoatMap,de=U&&!!M.clearcoatNormalMap,ye=U&&!!M.clearcoatRoughnessMap,fe=G&&!!M.iridescenceMap,ue=G&&!!M.iridescenceThicknessMap,xe=B&&!!M.sheenColorMap,Oe=B&&!!M.sheenRoughnessMap,He=!!M.specularMap,Le=!!M.specularColorMap,Ze=!!M.specularIntensityMap,Y=W&&!!M.transmissionMap,be=W&&!!M.thicknessMap,Re=!!M.gradientMap,Ge=!!M.alphaMap,Te=M.alphaTest>0,ge=!!M.alphaHash,Be=!!M.extensions,it=_s;M.toneMapped&&(K===null||K.isXRRenderTarget===!0)&&(it=i.toneMapping);let Lt={shaderID:Q,shaderType:M.type,shaderName:M.name,vertexShader:he,fragmentShader:Me,defines:M.defines,customVertexShaderID:Ee,customFragmentShaderID:te,isRawShaderMaterial:M.isRawShaderMaterial===!0,glslVersion:M.glslVersion,precision:m,batching:Ae,batchingColor:Ae&&O._colorsTexture!==null,instancing:_e,instancingColor:_e&&O.instanceColor!==null,instancingMorph:_e&&O.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:K===null?i.outputColorSpace:K.isXRRenderTarget===!0?K.texture.colorSpace:hr,alphaToCoverage:!!M.alphaToCoverage,map:We,matcap:ut,envMap:H,envMapMode:H&&N.mapping,envMapCubeUVHeight:z,aoMap:lt,lightMap:oe,bumpMap:we,normalMap:Pe,displacementMap:f&&at,emissiveMap:ae,normalMapObjectSpace:Pe&&M.normalMapType===Wm,normalMapTangentSpace:Pe&&M.normalMapType===Rf,metalnessMap:De,roughnessMap:je,anisotropy:rt,anisotropyMap:j,clearcoat:U,clearcoatMap:pe,clearcoatNormalMap:de,clearcoatRoughnessMap:ye,dispersion:w,iridescence:G,iridescenceMap:fe,iridescenceThicknessMap:ue,sheen:B,sheenColorMap:xe,sheenRoughnessMap:Oe,specularMap:He,specularColorMap:Le,specularIntensityMap:Ze,transmission:W,transmissionMap:Y,thicknessMap:be,gradientMap:Re,opaque:M.transparent===!1&&M.blending===lr&&M.alphaToCoverage===!1,alphaMap:Ge,alphaTest:Te,alphaHash:ge,combine:M.combine,mapUv:We&&v(M.map.channel),aoMapUv:lt&&v(M.aoMap.channel),lightMapUv:oe&&v(M.lightMap.channel),bumpMapUv:we&&v(M.bumpMap.channel),normalMapUv:Pe&&v(M.normalMap.channel),displacementMapUv:at&&v(M.displacementMap.channel),emissiveMapUv:ae&&v(M.emissiveMap.channel),metalnessMapUv:De&&v(M.metalnessMap.channel),roughnessMapUv:je&&v(M.roughnessMap.channel),anisotropyMapUv:j&&v(M.anisotropyMap.channel),clearcoatMapUv:pe&&v(M.clearcoatMap.channel),clearcoatNormalMapUv:de&&v(M.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ye&&v(M.clearcoatRoughnessMap.channel),iridescenceMapUv:fe&&v(M.iridescenceMap.channel),iridescenceThicknessMapUv:ue&&v(M.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&v(M.sheenColorMap.channel),sheenRoughnessMapUv:Oe&&v(M.sheenRoughnessMap.channel),specularMapUv:He&&v(M.specularMap.channel),specularColorMapUv:Le&&v(M.specularColorMap.channel),specularIntensityMapUv:Ze&&v(M.specularIntensityMap.channel),transmissionMapUv:Y&&v(M.transmissionMap.channel),thicknessMapUv:be&&v(M.thicknessMap.channel),alphaMapUv:Ge&&v(M.alphaMap.channel),vertexTangents:!!q.attributes.tangent&&(Pe||rt),vertexColors:M.vertexColors,vertexAlphas:M.vertexColors===!0&&!!q.attributes.color&&q.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!q.attributes.uv&&(We||Ge),fog:!!V,useFog:M.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:M.flatShading===!0&&M.wireframe===!1,sizeAttenuation:M.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:ve,skinning:O.isSkinnedMesh===!0,morphTargets:q.morphAttributes.position!==void 0,morphNormals:q.morphAttributes.normal!==void 0,morphColors:q.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:ce,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:M.dithering,shadowMapEnabled:i.shadowMap.enabled&&A.length>0,shadowMapType:i.shadowMap.type,toneMapping:it,decodeVideoTexture:We&&M.map.isVideoTexture===!0&&xt.getTransfer(M.map.colorSpace)===Pt,decodeVideoTextureEmissive:ae&&M.emissiveMap.isVideoTexture===!0&&xt.getTransfer(M.emissiveMap.colorSpace)===Pt,premultipliedAlpha:M.premultipliedAlpha,doubleSided:M.side===Sn,flipSided:M.side===Wn,useDepthPacking:M.depthPacking>=0,depthPacking:M.depthPacking||0,index0AttributeName:M.index0AttributeName,extensionClipCullDistance:Be&&M.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Be&&M.extensions.multiDraw===!0||Ae)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:M.customProgramCacheKey()};return Lt.vertexUv1s=c.has(1),Lt.vertexUv2s=c.has(2),Lt.vertexUv3s=c.has(3),c.clear(),Lt}function d(M){let S=[];if(M.shaderID?S.push(M.shaderID):(S.push(M.customVertexShaderID),S.push(M.customFragmentShaderID)),M.defines!==void 0)for(let A in M.defines)S.push(A),S.push(M.defines[A]);return M.isRawShaderMaterial===!1&&(y(S,M),b(S,M),S.push(i.outputColorSpace)),S.push(M.customProgramCacheKey),S.join()}function y(M,S){M.push(S.precision),M.push(S.outputColorSpace),M.push(S.envMapMode),M.push(S.envMapCubeUVHeight),M.push(S.mapUv),M.push(S.alphaMapUv),M.push(S.lightMapUv),M.push(S.aoMapUv),M.push(S.bumpMapUv),M.push(S.normalMapUv),M.push(S.displacementMapUv),M.push(S.emissiveMapUv),M.push(S.metalnessMapUv),M.push(S.roughnessMapUv),M.push(S.anisotropyMapUv),M.push(S.clearcoatMapUv),M.push(S.clearcoatNormalMapUv),M.push(S.clearcoatRoughnessMapUv),M.push(S.iridescenceMapUv),M.push(S.iridescenceThicknessMapUv),M.push(S.sheenColorMapUv),M.push(S.sheenRoughnessMapUv),M.push(S.specularMapUv),M.push(S.specularColorMapUv),M.push(S.specularIntensityMapUv),M.push(S.transmissionMapUv),M.push(S.thicknessMapUv),M.push(S.combine),M.push(S.fogExp2),M.push(S.sizeAttenuation),M.push(S.morphTargetsCount),M.push(S.morphAttributeCount),M.push(S.numDirLights),M.push(S.numPointLights),M.push(S.numSpotLights),M.push(S.numSpotLightMaps),M.push(S.numHemiLights),M.push(S.numRectAreaLights),M.push(S.numDirLightShadows),M.push(S.numPointLightShadows),M.push(S.numSpotLightShadows),M.push(S.numSpotLightShadowsWithMaps),M.push(S.numLightProbes),M.push(S.shadowMapType),M.push(S.toneMapping),M.push(S.numClippingPlanes),M.push(S.numClipIntersection),M.push(S.depthPacking)}function b(M,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),S.gradientMap&&a.enable(22),M.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reversedDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),M.push(a.mask)}function _(M){let S=g[M.type],A;if(S){let k=Xn[S];A=$a.clone(k.uniforms)}else A=M.uniforms;return A}function C(M,S){let A;for(let k=0,O=u.length;k<O;k++){let V=u[k];if(V.cacheKey===S){A=V,++A.usedTimes;break}}return A===void 0&&(A=new yS(i,S,M,r),u.push(A)),A}function E(M){if(--M.usedTimes===0){let S=u.indexOf(M);u[S]=u[u.length-1],u.pop(),M.destroy()}}function P(M){l.remove(M)}function L(){l.dispose()}return{getParameters:p,getProgramCacheKey:d,getUniforms:_,acquireProgram:C,releaseProgram:E,releaseShaderCache:P,programs:u,dispose:L}}function wS(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function SS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function wg(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Sg(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h,f,m,g,v,p){let d=i[e];return d===void 0?(d={id:h.id,object:h,geometry:f,material:m,groupOrder:g,renderOrder:h.renderOrder,z:v,group:p},i[e]=d):(d.id=h.id,d.object=h,d.geometry=f,d.material=m,d.groupOrder=g,d.renderOrder=h.renderOrder,d.z=v,d.group=p),e++,d}function a(h,f,m,g,v,p){let d=o(h,f,m,g,v,p);m.transmission>0?n.push(d):m.transparent===!0?s.push(d):t.push(d)}function l(h,f,m,g,v,p){let d=o(h,f,m,g,v,p);m.transmission>0?n.unshift(d):m.transparent===!0?s.unshift(d):t.unshift(d)}function c(h,f){t.length>1&&t.sort(h||SS),n.length>1&&n.sort(f||wg),s.length>1&&s.sort(f||wg)}function u(){for(let h=e,f=i.length;h<f;h++){let m=i[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function ES(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Sg,i.set(n,[o])):s>=r.length?(o=new Sg,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function TS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new I,color:new ot};break;case"SpotLight":t={position:new I,direction:new I,color:new ot,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new I,color:new ot,distance:0,decay:0};break;case"HemisphereLight":t={direction:new I,skyColor:new ot,groundColor:new ot};break;case"RectAreaLight":t={color:new ot,position:new I,halfWidth:new I,halfHeight:new I};break}return i[e.id]=t,t}}}function AS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var RS=0;function CS(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function PS(i){let e=new TS,t=AS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new I);let s=new I,r=new Ut,o=new Ut;function a(c){let u=0,h=0,f=0;for(let M=0;M<9;M++)n.probe[M].set(0,0,0);let m=0,g=0,v=0,p=0,d=0,y=0,b=0,_=0,C=0,E=0,P=0;c.sort(CS);for(let M=0,S=c.length;M<S;M++){let A=c[M],k=A.color,O=A.intensity,V=A.distance,q=A.shadow&&A.shadow.map?A.shadow.map.texture:null;if(A.isAmbientLight)u+=k.r*O,h+=k.g*O,f+=k.b*O;else if(A.isLightProbe){for(let $=0;$<9;$++)n.probe[$].addScaledVector(A.sh.coefficients[$],O);P++}else if(A.isDirectionalLight){let $=e.get(A);if($.color.copy(A.color).multiplyScalar(A.intensity),A.castShadow){let N=A.shadow,z=t.get(A);z.shadowIntensity=N.intensity,z.shadowBias=N.bias,z.shadowNormalBias=N.normalBias,z.shadowRadius=N.radius,z.shadowMapSize=N.mapSize,n.directionalShadow[m]=z,n.directionalShadowMap[m]=q,n.directionalShadowMatrix[m]=A.shadow.matrix,y++}n.directional[m]=$,m++}else if(A.isSpotLight){let $=e.get(A);$.position.setFromMatrixPosition(A.matrixWorld),$.color.copy(k).multiplyScalar(O),$.distance=V,$.coneCos=Math.cos(A.angle),$.penumbraCos=Math.cos(A.angle*(1-A.penumbra)),$.decay=A.decay,n.spot[v]=$;let N=A.shadow;if(A.map&&(n.spotLightMap[C]=A.map,C++,N.updateMatrices(A),A.castShadow&&E++),n.spotLightMatrix[v]=N.matrix,A.castShadow){let z=t.get(A);z.shadowIntensity=N.intensity,z.shadowBias=N.bias,z.shadowNormalBias=N.normalBias,z.shadowRadius=N.radius,z.shadowMapSize=N.mapSize,n.spotShadow[v]=z,n.spotShadowMap[v]=q,_++}v++}else if(A.isRectAreaLight){let $=e.get(A);$.color.copy(k).multiplyScalar(O),$.halfWidth.set(A.width*.5,0,0),$.halfHeight.set(0,A.height*.5,0),n.rectArea[p]=$,p++}else if(A.isPointLight){let $=e.get(A);if($.color.copy(A.color).multiplyScalar(A.intensity),$.distance=A.distance,$.decay=A.decay,A.castShadow){let N=A.shadow,z=t.get(A);z.shadowIntensity=N.intensity,z.shadowBias=N.bias,z.shadowNormalBias=N.normalBias,z.shadowRadius=N.radius,z.shadowMapSize=N.mapSize,z.shadowCameraNear=N.camera.near,z.shadowCameraFar=N.camera.far,n.pointShadow[g]=z,n.pointShadowMap[g]=q,n.pointShadowMatrix[g]=A.shadow.matrix,b++}n.point[g]=$,g++}else if(A.isHemisphereLight){let $=e.get(A);$.skyColor.copy(A.color).multiplyScalar(O),$.groundColor.copy(A.groundColor).multiplyScalar(O),n.hemi[d]=$,d++}}p>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ue.LTC_FLOAT_1,n.rectAreaLTC2=Ue.LTC_FLOAT_2):(n.rectAreaLTC1=Ue.LTC_HALF_1,n.rectAreaLTC2=Ue.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let L=n.hash;(L.directionalLength!==m||L.pointLength!==g||L.spotLength!==v||L.rectAreaLength!==p||L.hemiLength!==d||L.numDirectionalShadows!==y||L.numPointShadows!==b||L.numSpotShadows!==_||L.numSpotMaps!==C||L.numLightProbes!==P)&&(n.directional.length=m,n.spot.length=v,n.rectArea.length=p,n.point.length=g,n.hemi.length=d,n.directionalShadow.length=y,n.directionalShadowMap.length=y,n.pointShadow.length=b,n.pointShadowMap.length=b,n.spotShadow.length=_,n.spotShadowMap.length=_,n.directionalShadowMatrix.length=y,n.pointShadowMatrix.length=b,n.spotLightMatrix.length=_+C-E,n.spotLightMap.length=C,n.numSpotLightShadowsWithMaps=E,n.numLightProbes=P,L.directionalLength=m,L.pointLength=g,L.spotLength=v,L.rectAreaLength=p,L.hemiLength=d,L.numDirectionalShadows=y,L.numPointShadows=b,L.numSpotShadows=_,L.numSpotMaps=C,L.numLightProbes=P,n.version=RS++)}function l(c,u){let h=0,f=0,m=0,g=0,v=0,p=u.matrixWorldInverse;for(let d=0,y=c.length;d<y;d++){let b=c[d];if(b.isDirectionalLight){let _=n.directional[h];_.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),_.direction.sub(s),_.direction.transformDirection(p),h++}else if(b.isSpotLight){let _=n.spot[m];_.position.setFromMatrixPosition(b.matrixWorld),_.position.applyMatrix4(p),_.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),_.direction.sub(s),_.direction.transformDirection(p),m++}else if(b.isRectAreaLight){let _=n.rectArea[g];_.position.setFromMatrixPosition(b.matrixWorld),_.position.applyMatrix4(p),o.identity(),r.copy(b.matrixWorld),r.premultiply(p),o.extractRotation(r),_.halfWidth.set(b.width*.5,0,0),_.halfHeight.set(0,b.height*.5,0),_.halfWidth.applyMatrix4(o),_.halfHeight.applyMatrix4(o),g++}else if(b.isPointLight){let _=n.point[f];_.position.setFromMatrixPosition(b.matrixWorld),_.position.applyMatrix4(p),f++}else if(b.isHemisphereLight){let _=n.hemi[v];_.direction.setFromMatrixPosition(b.matrixWorld),_.direction.transformDirection(p),v++}}}return{setup:a,setupView:l,state:n}}function Eg(i){let e=new PS(i),t=[],n=[];function s(u){c.camera=u,t.length=0,n.length=0}function r(u){t.push(u)}function o(u){n.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function IS(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Eg(i),e.set(s,[a])):r>=o.length?(a=new Eg(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var LS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,DS=`uniform sampler2D shadow_pass;
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
}`;function US(i,e,t){let n=new _o,s=new Fe,r=new Fe,o=new It,a=new bc({depthPacking:Gm}),l=new Mc,c={},u=t.maxTextureSize,h={[gs]:Wn,[Wn]:gs,[Sn]:Sn},f=new ai({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Fe},radius:{value:4}},vertexShader:LS,fragmentShader:DS}),m=f.clone();m.defines.HORIZONTAL_PASS=1;let g=new Ot;g.setAttribute("position",new Jt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Ke(g,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=pf;let d=this.type;this.render=function(E,P,L){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||E.length===0)return;let M=i.getRenderTarget(),S=i.getActiveCubeFace(),A=i.getActiveMipmapLevel(),k=i.state;k.setBlending(xs),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let O=d!==Qi&&this.type===Qi,V=d===Qi&&this.type!==Qi;for(let q=0,$=E.length;q<$;q++){let N=E[q],z=N.shadow;if(z===void 0){console.warn("THREE.WebGLShadowMap:",N,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let Q=z.getFrameExtents();if(s.multiply(Q),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/Q.x),s.x=r.x*Q.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/Q.y),s.y=r.y*Q.y,z.mapSize.y=r.y)),z.map===null||O===!0||V===!0){let ne=this.type!==Qi?{minFilter:vi,magFilter:vi}:{};z.map!==null&&z.map.dispose(),z.map=new Ki(s.x,s.y,ne),z.map.texture.name=N.name+".shadowMap",z.camera.updateProjectionMatrix()}i.setRenderTarget(z.map),i.clear();let ie=z.getViewportCount();for(let ne=0;ne<ie;ne++){let ce=z.getViewport(ne);o.set(r.x*ce.x,r.y*ce.y,r.x*ce.z,r.y*ce.w),k.viewport(o),z.updateMatrices(N,ne),n=z.getFrustum(),_(P,L,z.camera,N,this.type)}z.isPointLightShadow!==!0&&this.type===Qi&&y(z,L),z.needsUpdate=!1}d=this.type,p.needsUpdate=!1,i.setRenderTarget(M,S,A)};function y(E,P){let L=e.update(v);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,m.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,m.needsUpdate=!0),E.mapPass===null&&(E.mapPass=new Ki(s.x,s.y)),f.uniforms.shadow_pass.value=E.map.texture,f.uniforms.resolution.value=E.mapSize,f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(P,null,L,f,v,null),m.uniforms.shadow_pass.value=E.mapPass.texture,m.uniforms.resolution.value=E.mapSize,m.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(P,null,L,m,v,null)}function b(E,P,L,M){let S=null,A=L.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(A!==void 0)S=A;else if(S=L.isPointLight===!0?l:a,i.localClippingEnabled&&P.clipShadows===!0&&Array.isArray(P.clippingPlanes)&&P.clippingPlanes.length!==0||P.displacementMap&&P.displacementScale!==0||P.alphaMap&&P.alphaTest>0||P.map&&P.alphaTest>0||P.alphaToCoverage===!0){let k=S.uuid,O=P.uuid,V=c[k];V===void 0&&(V={},c[k]=V);let q=V[O];q===void 0&&(q=S.clone(),V[O]=q,P.addEventListener("dispose",C)),S=q}if(S.visible=P.visible,S.wireframe=P.wireframe,M===Qi?S.side=P.shadowSide!==null?P.shadowSide:P.side:S.side=P.shadowSide!==null?P.shadowSide:h[P.side],S.alphaMap=P.alphaMap,S.alphaTest=P.alphaToCoverage===!0?.5:P.alphaTest,S.map=P.map,S.clipShadows=P.clipShadows,S.clippingPlanes=P.clippingPlanes,S.clipIntersection=P.clipIntersection,S.displacementMap=P.displacementMap,S.displacementScale=P.displacementScale,S.displacementBias=P.displacementBias,S.wireframeLinewidth=P.wireframeLinewidth,S.linewidth=P.linewidth,L.isPointLight===!0&&S.isMeshDistanceMaterial===!0){let k=i.properties.get(S);k.light=L}return S}function _(E,P,L,M,S){if(E.visible===!1)return;if(E.layers.test(P.layers)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&S===Qi)&&(!E.frustumCulled||n.intersectsObject(E))){E.modelViewMatrix.multiplyMatrices(L.matrixWorldInverse,E.matrixWorld);let O=e.update(E),V=E.material;if(Array.isArray(V)){let q=O.groups;for(let $=0,N=q.length;$<N;$++){let z=q[$],Q=V[z.materialIndex];if(Q&&Q.visible){let ie=b(E,Q,M,S);E.onBeforeShadow(i,E,P,L,O,ie,z),i.renderBufferDirect(L,null,O,ie,E,z),E.onAfterShadow(i,E,P,L,O,ie,z)}}}else if(V.visible){let q=b(E,V,M,S);E.onBeforeShadow(i,E,P,L,O,q,null),i.renderBufferDirect(L,null,O,q,E,null),E.onAfterShadow(i,E,P,L,O,q,null)}}let k=E.children;for(let O=0,V=k.length;O<V;O++)_(k[O],P,L,M,S)}function C(E){E.target.removeEventListener("dispose",C);for(let L in c){let M=c[L],S=E.target.uuid;S in M&&(M[S].dispose(),delete M[S])}}}var NS={[Dc]:Uc,[Nc]:Bc,[Fc]:zc,[cr]:Oc,[Uc]:Dc,[Bc]:Nc,[zc]:Fc,[Oc]:cr};function FS(i,e){function t(){let Y=!1,be=new It,Re=null,Ge=new It(0,0,0,0);return{setMask:function(Te){Re!==Te&&!Y&&(i.colorMask(Te,Te,Te,Te),Re=Te)},setLocked:function(Te){Y=Te},setClear:function(Te,ge,Be,it,Lt){Lt===!0&&(Te*=it,ge*=it,Be*=it),be.set(Te,ge,Be,it),Ge.equals(be)===!1&&(i.clearColor(Te,ge,Be,it),Ge.copy(be))},reset:function(){Y=!1,Re=null,Ge.set(-1,0,0,0)}}}function n(){let Y=!1,be=!1,Re=null,Ge=null,Te=null;return{setReversed:function(ge){if(be!==ge){let Be=e.get("EXT_clip_control");ge?Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.ZERO_TO_ONE_EXT):Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.NEGATIVE_ONE_TO_ONE_EXT),be=ge;let it=Te;Te=null,this.setClear(it)}},getReversed:function(){return be},setTest:function(ge){ge?K(i.DEPTH_TEST):ve(i.DEPTH_TEST)},setMask:function(ge){Re!==ge&&!Y&&(i.depthMask(ge),Re=ge)},setFunc:function(ge){if(be&&(ge=NS[ge]),Ge!==ge){switch(ge){case Dc:i.depthFunc(i.NEVER);break;case Uc:i.depthFunc(i.ALWAYS);break;case Nc:i.depthFunc(i.LESS);break;case cr:i.depthFunc(i.LEQUAL);break;case Fc:i.depthFunc(i.EQUAL);break;case Oc:i.depthFunc(i.GEQUAL);break;case Bc:i.depthFunc(i.GREATER);break;case zc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ge=ge}},setLocked:function(ge){Y=ge},setClear:function(ge){Te!==ge&&(be&&(ge=1-ge),i.clearDepth(ge),Te=ge)},reset:function(){Y=!1,Re=null,Ge=null,Te=null,be=!1}}}function s(){let Y=!1,be=null,Re=null,Ge=null,Te=null,ge=null,Be=null,it=null,Lt=null;return{setTest:function(yt){Y||(yt?K(i.STENCIL_TEST):ve(i.STENCIL_TEST))},setMask:function(yt){be!==yt&&!Y&&(i.stencilMask(yt),be=yt)},setFunc:function(yt,bn,Ft){(Re!==yt||Ge!==bn||Te!==Ft)&&(i.stencilFunc(yt,bn,Ft),Re=yt,Ge=bn,Te=Ft)},setOp:function(yt,bn,Ft){(ge!==yt||Be!==bn||it!==Ft)&&(i.stencilOp(yt,bn,Ft),ge=yt,Be=bn,it=Ft)},setLocked:function(yt){Y=yt},setClear:function(yt){Lt!==yt&&(i.clearStencil(yt),Lt=yt)},reset:function(){Y=!1,be=null,Re=null,Ge=null,Te=null,ge=null,Be=null,it=null,Lt=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,m=[],g=null,v=!1,p=null,d=null,y=null,b=null,_=null,C=null,E=null,P=new ot(0,0,0),L=0,M=!1,S=null,A=null,k=null,O=null,V=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),$=!1,N=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(N=parseFloat(/^WebGL (\d)/.exec(z)[1]),$=N>=1):z.indexOf("OpenGL ES")!==-1&&(N=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),$=N>=2);let Q=null,ie={},ne=i.getParameter(i.SCISSOR_BOX),ce=i.getParameter(i.VIEWPORT),he=new It().fromArray(ne),Me=new It().fromArray(ce);function Ee(Y,be,Re,Ge){let Te=new Uint8Array(4),ge=i.createTexture();i.bindTexture(Y,ge),i.texParameteri(Y,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(Y,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Be=0;Be<Re;Be++)Y===i.TEXTURE_3D||Y===i.TEXTURE_2D_ARRAY?i.texImage3D(be,0,i.RGBA,1,1,Ge,0,i.RGBA,i.UNSIGNED_BYTE,Te):i.texImage2D(be+Be,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Te);return ge}let te={};te[i.TEXTURE_2D]=Ee(i.TEXTURE_2D,i.TEXTURE_2D,1),te[i.TEXTURE_CUBE_MAP]=Ee(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),te[i.TEXTURE_2D_ARRAY]=Ee(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),te[i.TEXTURE_3D]=Ee(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),K(i.DEPTH_TEST),o.setFunc(cr),we(!1),Pe(df),K(i.CULL_FACE),lt(xs);function K(Y){u[Y]!==!0&&(i.enable(Y),u[Y]=!0)}function ve(Y){u[Y]!==!1&&(i.disable(Y),u[Y]=!1)}function _e(Y,be){return h[Y]!==be?(i.bindFramebuffer(Y,be),h[Y]=be,Y===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=be),Y===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=be),!0):!1}function Ae(Y,be){let Re=m,Ge=!1;if(Y){Re=f.get(be),Re===void 0&&(Re=[],f.set(be,Re));let Te=Y.textures;if(Re.length!==Te.length||Re[0]!==i.COLOR_ATTACHMENT0){for(let ge=0,Be=Te.length;ge<Be;ge++)Re[ge]=i.COLOR_ATTACHMENT0+ge;Re.length=Te.length,Ge=!0}}else Re[0]!==i.BACK&&(Re[0]=i.BACK,Ge=!0);Ge&&i.drawBuffers(Re)}function We(Y){return g!==Y?(i.useProgram(Y),g=Y,!0):!1}let ut={[Os]:i.FUNC_ADD,[mm]:i.FUNC_SUBTRACT,[gm]:i.FUNC_REVERSE_SUBTRACT};ut[vm]=i.MIN,ut[xm]=i.MAX;let H={[_m]:i.ZERO,[ym]:i.ONE,[bm]:i.SRC_COLOR,[ec]:i.SRC_ALPHA,[Am]:i.SRC_ALPHA_SATURATE,[Em]:i.DST_COLOR,[wm]:i.DST_ALPHA,[Mm]:i.ONE_MINUS_SRC_COLOR,[tc]:i.ONE_MINUS_SRC_ALPHA,[Tm]:i.ONE_MINUS_DST_COLOR,[Sm]:i.ONE_MINUS_DST_ALPHA,[Rm]:i.CONSTANT_COLOR,[Cm]:i.ONE_MINUS_CONSTANT_COLOR,[Pm]:i.CONSTANT_ALPHA,[Im]:i.ONE_MINUS_CONSTANT_ALPHA};function lt(Y,be,Re,Ge,Te,ge,Be,it,Lt,yt){if(Y===xs){v===!0&&(ve(i.BLEND),v=!1);return}if(v===!1&&(K(i.BLEND),v=!0),Y!==pm){if(Y!==p||yt!==M){if((d!==Os||_!==Os)&&(i.blendEquation(i.FUNC_ADD),d=Os,_=Os),yt)switch(Y){case lr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case mf:i.blendFunc(i.ONE,i.ONE);break;case gf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case vf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",Y);break}else switch(Y){case lr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case mf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case gf:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case vf:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",Y);break}y=null,b=null,C=null,E=null,P.set(0,0,0),L=0,p=Y,M=yt}return}Te=Te||be,ge=ge||Re,Be=Be||Ge,(be!==d||Te!==_)&&(i.blendEquationSeparate(ut[be],ut[Te]),d=be,_=Te),(Re!==y||Ge!==b||ge!==C||Be!==E)&&(i.blendFuncSeparate(H[Re],H[Ge],H[ge],H[Be]),y=Re,b=Ge,C=ge,E=Be),(it.equals(P)===!1||Lt!==L)&&(i.blendColor(it.r,it.g,it.b,Lt),P.copy(it),L=Lt),p=Y,M=!1}function oe(Y,be){Y.side===Sn?ve(i.CULL_FACE):K(i.CULL_FACE);let Re=Y.side===Wn;be&&(Re=!Re),we(Re),Y.blending===lr&&Y.transparent===!1?lt(xs):lt(Y.blending,Y.blendEquation,Y.blendSrc,Y.blendDst,Y.blendEquationAlpha,Y.blendSrcAlpha,Y.blendDstAlpha,Y.blendColor,Y.blendAlpha,Y.premultipliedAlpha),o.setFunc(Y.depthFunc),o.setTest(Y.depthTest),o.setMask(Y.depthWrite),r.setMask(Y.colorWrite);let Ge=Y.stencilWrite;a.setTest(Ge),Ge&&(a.setMask(Y.stencilWriteMask),a.setFunc(Y.stencilFunc,Y.stencilRef,Y.stencilFuncMask),a.setOp(Y.stencilFail,Y.stencilZFail,Y.stencilZPass)),ae(Y.polygonOffset,Y.polygonOffsetFactor,Y.polygonOffsetUnits),Y.alphaToCoverage===!0?K(i.SAMPLE_ALPHA_TO_COVERAGE):ve(i.SAMPLE_ALPHA_TO_COVERAGE)}function we(Y){S!==Y&&(Y?i.frontFace(i.CW):i.frontFace(i.CCW),S=Y)}function Pe(Y){Y!==um?(K(i.CULL_FACE),Y!==A&&(Y===df?i.cullFace(i.BACK):Y===fm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):ve(i.CULL_FACE),A=Y}function at(Y){Y!==k&&($&&i.lineWidth(Y),k=Y)}function ae(Y,be,Re){Y?(K(i.POLYGON_OFFSET_FILL),(O!==be||V!==Re)&&(i.polygonOffset(be,Re),O=be,V=Re)):ve(i.POLYGON_OFFSET_FILL)}function De(Y){Y?K(i.SCISSOR_TEST):ve(i.SCISSOR_TEST)}function je(Y){Y===void 0&&(Y=i.TEXTURE0+q-1),Q!==Y&&(i.activeTexture(Y),Q=Y)}function rt(Y,be,Re){Re===void 0&&(Q===null?Re=i.TEXTURE0+q-1:Re=Q);let Ge=ie[Re];Ge===void 0&&(Ge={type:void 0,texture:void 0},ie[Re]=Ge),(Ge.type!==Y||Ge.texture!==be)&&(Q!==Re&&(i.activeTexture(Re),Q=Re),i.bindTexture(Y,be||te[Y]),Ge.type=Y,Ge.texture=be)}function U(){let Y=ie[Q];Y!==void 0&&Y.type!==void 0&&(i.bindTexture(Y.type,null),Y.type=void 0,Y.texture=void 0)}function w(){try{i.compressedTexImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function G(){try{i.compressedTexImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function B(){try{i.texSubImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function W(){try{i.texSubImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function j(){try{i.compressedTexSubImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function pe(){try{i.compressedTexSubImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function de(){try{i.texStorage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function ye(){try{i.texStorage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function fe(){try{i.texImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function ue(){try{i.texImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function xe(Y){he.equals(Y)===!1&&(i.scissor(Y.x,Y.y,Y.z,Y.w),he.copy(Y))}function Oe(Y){Me.equals(Y)===!1&&(i.viewport(Y.x,Y.y,Y.z,Y.w),Me.copy(Y))}function He(Y,be){let Re=c.get(be);Re===void 0&&(Re=new WeakMap,c.set(be,Re));let Ge=Re.get(Y);Ge===void 0&&(Ge=i.getUniformBlockIndex(be,Y.name),Re.set(Y,Ge))}function Le(Y,be){let Ge=c.get(be).get(Y);l.get(be)!==Ge&&(i.uniformBlockBinding(be,Ge,Y.__bindingPointIndex),l.set(be,Ge))}function Ze(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},Q=null,ie={},h={},f=new WeakMap,m=[],g=null,v=!1,p=null,d=null,y=null,b=null,_=null,C=null,E=null,P=new ot(0,0,0),L=0,M=!1,S=null,A=null,k=null,O=null,V=null,he.set(0,0,i.canvas.width,i.canvas.height),Me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:K,disable:ve,bindFramebuffer:_e,drawBuffers:Ae,useProgram:We,setBlending:lt,setMaterial:oe,setFlipSided:we,setCullFace:Pe,setLineWidth:at,setPolygonOffset:ae,setScissorTest:De,activeTexture:je,bindTexture:rt,unbindTexture:U,compressedTexImage2D:w,compressedTexImage3D:G,texImage2D:fe,texImage3D:ue,updateUBOMapping:He,uniformBlockBinding:Le,texStorage2D:de,texStorage3D:ye,texSubImage2D:B,texSubImage3D:W,compressedTexSubImage2D:j,compressedTexSubImage3D:pe,scissor:xe,viewport:Oe,reset:Ze}}function OS(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Fe,u=new WeakMap,h,f=new WeakMap,m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(U,w){return m?new OffscreenCanvas(U,w):ma("canvas")}function v(U,w,G){let B=1,W=rt(U);if((W.width>G||W.height>G)&&(B=G/Math.max(W.width,W.height)),B<1)if(typeof HTMLImageElement<"u"&&U instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&U instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&U instanceof ImageBitmap||typeof VideoFrame<"u"&&U instanceof VideoFrame){let j=Math.floor(B*W.width),pe=Math.floor(B*W.height);h===void 0&&(h=g(j,pe));let de=w?g(j,pe):h;return de.width=j,de.height=pe,de.getContext("2d").drawImage(U,0,0,j,pe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+W.width+"x"+W.height+") to ("+j+"x"+pe+")."),de}else return"data"in U&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+W.width+"x"+W.height+")."),U;return U}function p(U){return U.generateMipmaps}function d(U){i.generateMipmap(U)}function y(U){return U.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:U.isWebGL3DRenderTarget?i.TEXTURE_3D:U.isWebGLArrayRenderTarget||U.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function b(U,w,G,B,W=!1){if(U!==null){if(i[U]!==void 0)return i[U];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+U+"'")}let j=w;if(w===i.RED&&(G===i.FLOAT&&(j=i.R32F),G===i.HALF_FLOAT&&(j=i.R16F),G===i.UNSIGNED_BYTE&&(j=i.R8)),w===i.RED_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.R8UI),G===i.UNSIGNED_SHORT&&(j=i.R16UI),G===i.UNSIGNED_INT&&(j=i.R32UI),G===i.BYTE&&(j=i.R8I),G===i.SHORT&&(j=i.R16I),G===i.INT&&(j=i.R32I)),w===i.RG&&(G===i.FLOAT&&(j=i.RG32F),G===i.HALF_FLOAT&&(j=i.RG16F),G===i.UNSIGNED_BYTE&&(j=i.RG8)),w===i.RG_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RG8UI),G===i.UNSIGNED_SHORT&&(j=i.RG16UI),G===i.UNSIGNED_INT&&(j=i.RG32UI),G===i.BYTE&&(j=i.RG8I),G===i.SHORT&&(j=i.RG16I),G===i.INT&&(j=i.RG32I)),w===i.RGB_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RGB8UI),G===i.UNSIGNED_SHORT&&(j=i.RGB16UI),G===i.UNSIGNED_INT&&(j=i.RGB32UI),G===i.BYTE&&(j=i.RGB8I),G===i.SHORT&&(j=i.RGB16I),G===i.INT&&(j=i.RGB32I)),w===i.RGBA_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RGBA8UI),G===i.UNSIGNED_SHORT&&(j=i.RGBA16UI),G===i.UNSIGNED_INT&&(j=i.RGBA32UI),G===i.BYTE&&(j=i.RGBA8I),G===i.SHORT&&(j=i.RGBA16I),G===i.INT&&(j=i.RGBA32I)),w===i.RGB&&(G===i.UNSIGNED_INT_5_9_9_9_REV&&(j=i.RGB9_E5),G===i.UNSIGNED_INT_10F_11F_11F_REV&&(j=i.R11F_G11F_B10F)),w===i.RGBA){let pe=W?da:xt.getTransfer(B);G===i.FLOAT&&(j=i.RGBA32F),G===i.HALF_FLOAT&&(j=i.RGBA16F),G===i.UNSIGNED_BYTE&&(j=pe===Pt?i.SRGB8_ALPHA8:i.RGBA8),G===i.UNSIGNED_SHORT_4_4_4_4&&(j=i.RGBA4),G===i.UNSIGNED_SHORT_5_5_5_1&&(j=i.RGB5_A1)}return(j===i.R16F||j===i.R32F||j===i.RG16F||j===i.RG32F||j===i.RGBA16F||j===i.RGBA32F)&&e.get("EXT_color_buffer_float"),j}function _(U,w){let G;return U?w===null||w===Ws||w===So?G=i.DEPTH24_STENCIL8:w===es?G=i.DEPTH32F_STENCIL8:w===Mo&&(G=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Ws||w===So?G=i.DEPTH_COMPONENT24:w===es?G=i.DEPTH_COMPONENT32F:w===Mo&&(G=i.DEPTH_COMPONENT16),G}function C(U,w){return p(U)===!0||U.isFramebufferTexture&&U.minFilter!==vi&&U.minFilter!==Li?Math.log2(Math.max(w.width,w.height))+1:U.mipmaps!==void 0&&U.mipmaps.length>0?U.mipmaps.length:U.isCompressedTexture&&Array.isArray(U.image)?w.mipmaps.length:1}function E(U){let w=U.target;w.removeEventListener("dispose",E),L(w),w.isVideoTexture&&u.delete(w)}function P(U){let w=U.target;w.removeEventListener("dispose",P),S(w)}function L(U){let w=n.get(U);if(w.__webglInit===void 0)return;let G=U.source,B=f.get(G);if(B){let W=B[w.__cacheKey];W.usedTimes--,W.usedTimes===0&&M(U),Object.keys(B).length===0&&f.delete(G)}n.remove(U)}function M(U){let w=n.get(U);i.deleteTexture(w.__webglTexture);let G=U.source,B=f.get(G);delete B[w.__cacheKey],o.memory.textures--}function S(U){let w=n.get(U);if(U.depthTexture&&(U.depthTexture.dispose(),n.remove(U.depthTexture)),U.isWebGLCubeRenderTarget)for(let B=0;B<6;B++){if(Array.isArray(w.__webglFramebuffer[B]))for(let W=0;W<w.__webglFramebuffer[B].length;W++)i.deleteFramebuffer(w.__webglFramebuffer[B][W]);else i.deleteFramebuffer(w.__webglFramebuffer[B]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[B])}else{if(Array.isArray(w.__webglFramebuffer))for(let B=0;B<w.__webglFramebuffer.length;B++)i.deleteFramebuffer(w.__webglFramebuffer[B]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let B=0;B<w.__webglColorRenderbuffer.length;B++)w.__webglColorRenderbuffer[B]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[B]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let G=U.textures;for(let B=0,W=G.length;B<W;B++){let j=n.get(G[B]);j.__webglTexture&&(i.deleteTexture(j.__webglTexture),o.memory.textures--),n.remove(G[B])}n.remove(U)}let A=0;function k(){A=0}function O(){let U=A;return U>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+U+" texture units while this GPU supports only "+s.maxTextures),A+=1,U}function V(U){let w=[];return w.push(U.wrapS),w.push(U.wrapT),w.push(U.wrapR||0),w.push(U.magFilter),w.push(U.minFilter),w.push(U.anisotropy),w.push(U.internalFormat),w.push(U.format),w.push(U.type),w.push(U.generateMipmaps),w.push(U.premultiplyAlpha),w.push(U.flipY),w.push(U.unpackAlignment),w.push(U.colorSpace),w.join()}function q(U,w){let G=n.get(U);if(U.isVideoTexture&&De(U),U.isRenderTargetTexture===!1&&U.isExternalTexture!==!0&&U.version>0&&G.__version!==U.version){let B=U.image;if(B===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(B.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{te(G,U,w);return}}else U.isExternalTexture&&(G.__webglTexture=U.sourceTexture?U.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,G.__webglTexture,i.TEXTURE0+w)}function $(U,w){let G=n.get(U);if(U.isRenderTargetTexture===!1&&U.version>0&&G.__version!==U.version){te(G,U,w);return}t.bindTexture(i.TEXTURE_2D_ARRAY,G.__webglTexture,i.TEXTURE0+w)}function N(U,w){let G=n.get(U);if(U.isRenderTargetTexture===!1&&U.version>0&&G.__version!==U.version){te(G,U,w);return}t.bindTexture(i.TEXTURE_3D,G.__webglTexture,i.TEXTURE0+w)}function z(U,w){let G=n.get(U);if(U.version>0&&G.__version!==U.version){K(G,U,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,G.__webglTexture,i.TEXTURE0+w)}let Q={[nc]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[ic]:i.MIRRORED_REPEAT},ie={[vi]:i.NEAREST,[Hm]:i.NEAREST_MIPMAP_NEAREST,[Ga]:i.NEAREST_MIPMAP_LINEAR,[Li]:i.LINEAR,[Vc]:i.LINEAR_MIPMAP_NEAREST,[Gs]:i.LINEAR_MIPMAP_LINEAR},ne={[Xm]:i.NEVER,[Jm]:i.ALWAYS,[qm]:i.LESS,[Cf]:i.LEQUAL,[Ym]:i.EQUAL,[Km]:i.GEQUAL,[$m]:i.GREATER,[Zm]:i.NOTEQUAL};function ce(U,w){if(w.type===es&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Li||w.magFilter===Vc||w.magFilter===Ga||w.magFilter===Gs||w.minFilter===Li||w.minFilter===Vc||w.minFilter===Ga||w.minFilter===Gs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(U,i.TEXTURE_WRAP_S,Q[w.wrapS]),i.texParameteri(U,i.TEXTURE_WRAP_T,Q[w.wrapT]),(U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY)&&i.texParameteri(U,i.TEXTURE_WRAP_R,Q[w.wrapR]),i.texParameteri(U,i.TEXTURE_MAG_FILTER,ie[w.magFilter]),i.texParameteri(U,i.TEXTURE_MIN_FILTER,ie[w.minFilter]),w.compareFunction&&(i.texParameteri(U,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(U,i.TEXTURE_COMPARE_FUNC,ne[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===vi||w.minFilter!==Ga&&w.minFilter!==Gs||w.type===es&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let G=e.get("EXT_texture_filter_anisotropic");i.texParameterf(U,G.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function he(U,w){let G=!1;U.__webglInit===void 0&&(U.__webglInit=!0,w.addEventListener("dispose",E));let B=w.source,W=f.get(B);W===void 0&&(W={},f.set(B,W));let j=V(w);if(j!==U.__cacheKey){W[j]===void 0&&(W[j]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,G=!0),W[j].usedTimes++;let pe=W[U.__cacheKey];pe!==void 0&&(W[U.__cacheKey].usedTimes--,pe.usedTimes===0&&M(w)),U.__cacheKey=j,U.__webglTexture=W[j].texture}return G}function Me(U,w,G){return Math.floor(Math.floor(U/G)/w)}function Ee(U,w,G,B){let j=U.updateRanges;if(j.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,G,B,w.data);else{j.sort((ue,xe)=>ue.start-xe.start);let pe=0;for(let ue=1;ue<j.length;ue++){let xe=j[pe],Oe=j[ue],He=xe.start+xe.count,Le=Me(Oe.start,w.width,4),Ze=Me(xe.start,w.width,4);Oe.start<=He+1&&Le===Ze&&Me(Oe.start+Oe.count-1,w.width,4)===Le?xe.count=Math.max(xe.count,Oe.start+Oe.count-xe.start):(++pe,j[pe]=Oe)}j.length=pe+1;let de=i.getParameter(i.UNPACK_ROW_LENGTH),ye=i.getParameter(i.UNPACK_SKIP_PIXELS),fe=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let ue=0,xe=j.length;ue<xe;ue++){let Oe=j[ue],He=Math.floor(Oe.start/4),Le=Math.ceil(Oe.count/4),Ze=He%w.width,Y=Math.floor(He/w.width),be=Le,Re=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Ze),i.pixelStorei(i.UNPACK_SKIP_ROWS,Y),t.texSubImage2D(i.TEXTURE_2D,0,Ze,Y,be,Re,G,B,w.data)}U.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,de),i.pixelStorei(i.UNPACK_SKIP_PIXELS,ye),i.pixelStorei(i.UNPACK_SKIP_ROWS,fe)}}function te(U,w,G){let B=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(B=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(B=i.TEXTURE_3D);let W=he(U,w),j=w.source;t.bindTexture(B,U.__webglTexture,i.TEXTURE0+G);let pe=n.get(j);if(j.version!==pe.__version||W===!0){t.activeTexture(i.TEXTURE0+G);let de=xt.getPrimaries(xt.workingColorSpace),ye=w.colorSpace===ys?null:xt.getPrimaries(w.colorSpace),fe=w.colorSpace===ys||de===ye?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,fe);let ue=v(w.image,!1,s.maxTextureSize);ue=je(w,ue);let xe=r.convert(w.format,w.colorSpace),Oe=r.convert(w.type),He=b(w.internalFormat,xe,Oe,w.colorSpace,w.isVideoTexture);ce(B,w);let Le,Ze=w.mipmaps,Y=w.isVideoTexture!==!0,be=pe.__version===void 0||W===!0,Re=j.dataReady,Ge=C(w,ue);if(w.isDepthTexture)He=_(w.format===Eo,w.type),be&&(Y?t.texStorage2D(i.TEXTURE_2D,1,He,ue.width,ue.height):t.texImage2D(i.TEXTURE_2D,0,He,ue.width,ue.height,0,xe,Oe,null));else if(w.isDataTexture)if(Ze.length>0){Y&&be&&t.texStorage2D(i.TEXTURE_2D,Ge,He,Ze[0].width,Ze[0].height);for(let Te=0,ge=Ze.length;Te<ge;Te++)Le=Ze[Te],Y?Re&&t.texSubImage2D(i.TEXTURE_2D,Te,0,0,Le.width,Le.height,xe,Oe,Le.data):t.texImage2D(i.TEXTURE_2D,Te,He,Le.width,Le.height,0,xe,Oe,Le.data);w.generateMipmaps=!1}else Y?(be&&t.texStorage2D(i.TEXTURE_2D,Ge,He,ue.width,ue.height),Re&&Ee(w,ue,xe,Oe)):t.texImage2D(i.TEXTURE_2D,0,He,ue.width,ue.height,0,xe,Oe,ue.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){Y&&be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ge,He,Ze[0].width,Ze[0].height,ue.depth);for(let Te=0,ge=Ze.length;Te<ge;Te++)if(Le=Ze[Te],w.format!==xi)if(xe!==null)if(Y){if(Re)if(w.layerUpdates.size>0){let Be=Of(Le.width,Le.height,w.format,w.type);for(let it of w.layerUpdates){let Lt=Le.data.subarray(it*Be/Le.data.BYTES_PER_ELEMENT,(it+1)*Be/Le.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Te,0,0,it,Le.width,Le.height,1,xe,Lt)}w.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Te,0,0,0,Le.width,Le.height,ue.depth,xe,Le.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,Te,He,Le.width,Le.height,ue.depth,0,Le.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Y?Re&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,Te,0,0,0,Le.width,Le.height,ue.depth,xe,Oe,Le.data):t.texImage3D(i.TEXTURE_2D_ARRAY,Te,He,Le.width,Le.height,ue.depth,0,xe,Oe,Le.data)}else{Y&&be&&t.texStorage2D(i.TEXTURE_2D,Ge,He,Ze[0].width,Ze[0].height);for(let Te=0,ge=Ze.length;Te<ge;Te++)Le=Ze[Te],w.format!==xi?xe!==null?Y?Re&&t.compressedTexSubImage2D(i.TEXTURE_2D,Te,0,0,Le.width,Le.height,xe,Le.data):t.compressedTexImage2D(i.TEXTURE_2D,Te,He,Le.width,Le.height,0,Le.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Y?Re&&t.texSubImage2D(i.TEXTURE_2D,Te,0,0,Le.width,Le.height,xe,Oe,Le.data):t.texImage2D(i.TEXTURE_2D,Te,He,Le.width,Le.height,0,xe,Oe,Le.data)}else if(w.isDataArrayTexture)if(Y){if(be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ge,He,ue.width,ue.height,ue.depth),Re)if(w.layerUpdates.size>0){let Te=Of(ue.width,ue.height,w.format,w.type);for(let ge of w.layerUpdates){let Be=ue.data.subarray(ge*Te/ue.data.BYTES_PER_ELEMENT,(ge+1)*Te/ue.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ge,ue.width,ue.height,1,xe,Oe,Be)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ue.width,ue.height,ue.depth,xe,Oe,ue.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,He,ue.width,ue.height,ue.depth,0,xe,Oe,ue.data);else if(w.isData3DTexture)Y?(be&&t.texStorage3D(i.TEXTURE_3D,Ge,He,ue.width,ue.height,ue.depth),Re&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ue.width,ue.height,ue.depth,xe,Oe,ue.data)):t.texImage3D(i.TEXTURE_3D,0,He,ue.width,ue.height,ue.depth,0,xe,Oe,ue.data);else if(w.isFramebufferTexture){if(be)if(Y)t.texStorage2D(i.TEXTURE_2D,Ge,He,ue.width,ue.height);else{let Te=ue.width,ge=ue.height;for(let Be=0;Be<Ge;Be++)t.texImage2D(i.TEXTURE_2D,Be,He,Te,ge,0,xe,Oe,null),Te>>=1,ge>>=1}}else if(Ze.length>0){if(Y&&be){let Te=rt(Ze[0]);t.texStorage2D(i.TEXTURE_2D,Ge,He,Te.width,Te.height)}for(let Te=0,ge=Ze.length;Te<ge;Te++)Le=Ze[Te],Y?Re&&t.texSubImage2D(i.TEXTURE_2D,Te,0,0,xe,Oe,Le):t.texImage2D(i.TEXTURE_2D,Te,He,xe,Oe,Le);w.generateMipmaps=!1}else if(Y){if(be){let Te=rt(ue);t.texStorage2D(i.TEXTURE_2D,Ge,He,Te.width,Te.height)}Re&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,xe,Oe,ue)}else t.texImage2D(i.TEXTURE_2D,0,He,xe,Oe,ue);p(w)&&d(B),pe.__version=j.version,w.onUpdate&&w.onUpdate(w)}U.__version=w.version}function K(U,w,G){if(w.image.length!==6)return;let B=he(U,w),W=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,U.__webglTexture,i.TEXTURE0+G);let j=n.get(W);if(W.version!==j.__version||B===!0){t.activeTexture(i.TEXTURE0+G);let pe=xt.getPrimaries(xt.workingColorSpace),de=w.colorSpace===ys?null:xt.getPrimaries(w.colorSpace),ye=w.colorSpace===ys||pe===de?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ye);let fe=w.isCompressedTexture||w.image[0].isCompressedTexture,ue=w.image[0]&&w.image[0].isDataTexture,xe=[];for(let ge=0;ge<6;ge++)!fe&&!ue?xe[ge]=v(w.image[ge],!0,s.maxCubemapSize):xe[ge]=ue?w.image[ge].image:w.image[ge],xe[ge]=je(w,xe[ge]);let Oe=xe[0],He=r.convert(w.format,w.colorSpace),Le=r.convert(w.type),Ze=b(w.internalFormat,He,Le,w.colorSpace),Y=w.isVideoTexture!==!0,be=j.__version===void 0||B===!0,Re=W.dataReady,Ge=C(w,Oe);ce(i.TEXTURE_CUBE_MAP,w);let Te;if(fe){Y&&be&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,Ze,Oe.width,Oe.height);for(let ge=0;ge<6;ge++){Te=xe[ge].mipmaps;for(let Be=0;Be<Te.length;Be++){let it=Te[Be];w.format!==xi?He!==null?Y?Re&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Be,0,0,it.width,it.height,He,it.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Be,Ze,it.width,it.height,0,it.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Be,0,0,it.width,it.height,He,Le,it.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Be,Ze,it.width,it.height,0,He,Le,it.data)}}}else{if(Te=w.mipmaps,Y&&be){Te.length>0&&Ge++;let ge=rt(xe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,Ze,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(ue){Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,xe[ge].width,xe[ge].height,He,Le,xe[ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,Ze,xe[ge].width,xe[ge].height,0,He,Le,xe[ge].data);for(let Be=0;Be<Te.length;Be++){let Lt=Te[Be].image[ge].image;Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Be+1,0,0,Lt.width,Lt.height,He,Le,Lt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Be+1,Ze,Lt.width,Lt.height,0,He,Le,Lt.data)}}else{Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,He,Le,xe[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,Ze,He,Le,xe[ge]);for(let Be=0;Be<Te.length;Be++){let it=Te[Be];Y?Re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Be+1,0,0,He,Le,it.image[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Be+1,Ze,He,Le,it.image[ge])}}}p(w)&&d(i.TEXTURE_CUBE_MAP),j.__version=W.version,w.onUpdate&&w.onUpdate(w)}U.__version=w.version}function ve(U,w,G,B,W,j){let pe=r.convert(G.format,G.colorSpace),de=r.convert(G.type),ye=b(G.internalFormat,pe,de,G.colorSpace),fe=n.get(w),ue=n.get(G);if(ue.__renderTarget=w,!fe.__hasExternalTextures){let xe=Math.max(1,w.width>>j),Oe=Math.max(1,w.height>>j);W===i.TEXTURE_3D||W===i.TEXTURE_2D_ARRAY?t.texImage3D(W,j,ye,xe,Oe,w.depth,0,pe,de,null):t.texImage2D(W,j,ye,xe,Oe,0,pe,de,null)}t.bindFramebuffer(i.FRAMEBUFFER,U),ae(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,B,W,ue.__webglTexture,0,at(w)):(W===i.TEXTURE_2D||W>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&W<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,B,W,ue.__webglTexture,j),t.bindFramebuffer(i.FRAMEBUFFER,null)}function _e(U,w,G){if(i.bindRenderbuffer(i.RENDERBUFFER,U),w.depthBuffer){let B=w.depthTexture,W=B&&B.isDepthTexture?B.type:null,j=_(w.stencilBuffer,W),pe=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,de=at(w);ae(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,de,j,w.width,w.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,de,j,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,j,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,pe,i.RENDERBUFFER,U)}else{let B=w.textures;for(let W=0;W<B.length;W++){let j=B[W],pe=r.convert(j.format,j.colorSpace),de=r.convert(j.type),ye=b(j.internalFormat,pe,de,j.colorSpace),fe=at(w);G&&ae(w)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,fe,ye,w.width,w.height):ae(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,fe,ye,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,ye,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ae(U,w){if(w&&w.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,U),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let B=n.get(w.depthTexture);B.__renderTarget=w,(!B.__webglTexture||w.depthTexture.image.width!==w.width||w.depthTexture.image.height!==w.height)&&(w.depthTexture.image.width=w.width,w.depthTexture.image.height=w.height,w.depthTexture.needsUpdate=!0),q(w.depthTexture,0);let W=B.__webglTexture,j=at(w);if(w.depthTexture.format===ho)ae(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,W,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,W,0);else if(w.depthTexture.format===Eo)ae(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,W,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,W,0);else throw new Error("Unknown depthTexture format")}function We(U){let w=n.get(U),G=U.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==U.depthTexture){let B=U.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),B){let W=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,B.removeEventListener("dispose",W)};B.addEventListener("dispose",W),w.__depthDisposeCallback=W}w.__boundDepthTexture=B}if(U.depthTexture&&!w.__autoAllocateDepthBuffer){if(G)throw new Error("target.depthTexture not supported in Cube render targets");let B=U.texture.mipmaps;B&&B.length>0?Ae(w.__webglFramebuffer[0],U):Ae(w.__webglFramebuffer,U)}else if(G){w.__webglDepthbuffer=[];for(let B=0;B<6;B++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[B]),w.__webglDepthbuffer[B]===void 0)w.__webglDepthbuffer[B]=i.createRenderbuffer(),_e(w.__webglDepthbuffer[B],U,!1);else{let W=U.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,j=w.__webglDepthbuffer[B];i.bindRenderbuffer(i.RENDERBUFFER,j),i.framebufferRenderbuffer(i.FRAMEBUFFER,W,i.RENDERBUFFER,j)}}else{let B=U.texture.mipmaps;if(B&&B.length>0?t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),_e(w.__webglDepthbuffer,U,!1);else{let W=U.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,j=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,j),i.framebufferRenderbuffer(i.FRAMEBUFFER,W,i.RENDERBUFFER,j)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function ut(U,w,G){let B=n.get(U);w!==void 0&&ve(B.__webglFramebuffer,U,U.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),G!==void 0&&We(U)}function H(U){let w=U.texture,G=n.get(U),B=n.get(w);U.addEventListener("dispose",P);let W=U.textures,j=U.isWebGLCubeRenderTarget===!0,pe=W.length>1;if(pe||(B.__webglTexture===void 0&&(B.__webglTexture=i.createTexture()),B.__version=w.version,o.memory.textures++),j){G.__webglFramebuffer=[];for(let de=0;de<6;de++)if(w.mipmaps&&w.mipmaps.length>0){G.__webglFramebuffer[de]=[];for(let ye=0;ye<w.mipmaps.length;ye++)G.__webglFramebuffer[de][ye]=i.createFramebuffer()}else G.__webglFramebuffer[de]=i.createFramebuffer()}else{if(w.mipmaps&&w.mipmaps.length>0){G.__webglFramebuffer=[];for(let de=0;de<w.mipmaps.length;de++)G.__webglFramebuffer[de]=i.createFramebuffer()}else G.__webglFramebuffer=i.createFramebuffer();if(pe)for(let de=0,ye=W.length;de<ye;de++){let fe=n.get(W[de]);fe.__webglTexture===void 0&&(fe.__webglTexture=i.createTexture(),o.memory.textures++)}if(U.samples>0&&ae(U)===!1){G.__webglMultisampledFramebuffer=i.createFramebuffer(),G.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,G.__webglMultisampledFramebuffer);for(let de=0;de<W.length;de++){let ye=W[de];G.__webglColorRenderbuffer[de]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,G.__webglColorRenderbuffer[de]);let fe=r.convert(ye.format,ye.colorSpace),ue=r.convert(ye.type),xe=b(ye.internalFormat,fe,ue,ye.colorSpace,U.isXRRenderTarget===!0),Oe=at(U);i.renderbufferStorageMultisample(i.RENDERBUFFER,Oe,xe,U.width,U.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+de,i.RENDERBUFFER,G.__webglColorRenderbuffer[de])}i.bindRenderbuffer(i.RENDERBUFFER,null),U.depthBuffer&&(G.__webglDepthRenderbuffer=i.createRenderbuffer(),_e(G.__webglDepthRenderbuffer,U,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(j){t.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture),ce(i.TEXTURE_CUBE_MAP,w);for(let de=0;de<6;de++)if(w.mipmaps&&w.mipmaps.length>0)for(let ye=0;ye<w.mipmaps.length;ye++)ve(G.__webglFramebuffer[de][ye],U,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+de,ye);else ve(G.__webglFramebuffer[de],U,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+de,0);p(w)&&d(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(pe){for(let de=0,ye=W.length;de<ye;de++){let fe=W[de],ue=n.get(fe),xe=i.TEXTURE_2D;(U.isWebGL3DRenderTarget||U.isWebGLArrayRenderTarget)&&(xe=U.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(xe,ue.__webglTexture),ce(xe,fe),ve(G.__webglFramebuffer,U,fe,i.COLOR_ATTACHMENT0+de,xe,0),p(fe)&&d(xe)}t.unbindTexture()}else{let de=i.TEXTURE_2D;if((U.isWebGL3DRenderTarget||U.isWebGLArrayRenderTarget)&&(de=U.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(de,B.__webglTexture),ce(de,w),w.mipmaps&&w.mipmaps.length>0)for(let ye=0;ye<w.mipmaps.length;ye++)ve(G.__webglFramebuffer[ye],U,w,i.COLOR_ATTACHMENT0,de,ye);else ve(G.__webglFramebuffer,U,w,i.COLOR_ATTACHMENT0,de,0);p(w)&&d(de),t.unbindTexture()}U.depthBuffer&&We(U)}function lt(U){let w=U.textures;for(let G=0,B=w.length;G<B;G++){let W=w[G];if(p(W)){let j=y(U),pe=n.get(W).__webglTexture;t.bindTexture(j,pe),d(j),t.unbindTexture()}}}let oe=[],we=[];function Pe(U){if(U.samples>0){if(ae(U)===!1){let w=U.textures,G=U.width,B=U.height,W=i.COLOR_BUFFER_BIT,j=U.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,pe=n.get(U),de=w.length>1;if(de)for(let fe=0;fe<w.length;fe++)t.bindFramebuffer(i.FRAMEBUFFER,pe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+fe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,pe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+fe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,pe.__webglMultisampledFramebuffer);let ye=U.texture.mipmaps;ye&&ye.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,pe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,pe.__webglFramebuffer);for(let fe=0;fe<w.length;fe++){if(U.resolveDepthBuffer&&(U.depthBuffer&&(W|=i.DEPTH_BUFFER_BIT),U.stencilBuffer&&U.resolveStencilBuffer&&(W|=i.STENCIL_BUFFER_BIT)),de){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,pe.__webglColorRenderbuffer[fe]);let ue=n.get(w[fe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,ue,0)}i.blitFramebuffer(0,0,G,B,0,0,G,B,W,i.NEAREST),l===!0&&(oe.length=0,we.length=0,oe.push(i.COLOR_ATTACHMENT0+fe),U.depthBuffer&&U.resolveDepthBuffer===!1&&(oe.push(j),we.push(j),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,we)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,oe))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),de)for(let fe=0;fe<w.length;fe++){t.bindFramebuffer(i.FRAMEBUFFER,pe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+fe,i.RENDERBUFFER,pe.__webglColorRenderbuffer[fe]);let ue=n.get(w[fe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,pe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+fe,i.TEXTURE_2D,ue,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,pe.__webglMultisampledFramebuffer)}else if(U.depthBuffer&&U.resolveDepthBuffer===!1&&l){let w=U.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function at(U){return Math.min(s.maxSamples,U.samples)}function ae(U){let w=n.get(U);return U.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function De(U){let w=o.render.frame;u.get(U)!==w&&(u.set(U,w),U.update())}function je(U,w){let G=U.colorSpace,B=U.format,W=U.type;return U.isCompressedTexture===!0||U.isVideoTexture===!0||G!==hr&&G!==ys&&(xt.getTransfer(G)===Pt?(B!==xi||W!==Fi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",G)),w}function rt(U){return typeof HTMLImageElement<"u"&&U instanceof HTMLImageElement?(c.width=U.naturalWidth||U.width,c.height=U.naturalHeight||U.height):typeof VideoFrame<"u"&&U instanceof VideoFrame?(c.width=U.displayWidth,c.height=U.displayHeight):(c.width=U.width,c.height=U.height),c}this.allocateTextureUnit=O,this.resetTextureUnits=k,this.setTexture2D=q,this.setTexture2DArray=$,this.setTexture3D=N,this.setTextureCube=z,this.rebindTextures=ut,this.setupRenderTarget=H,this.updateRenderTargetMipmap=lt,this.updateMultisampleRenderTarget=Pe,this.setupDepthRenderbuffer=We,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=ae}function BS(i,e){function t(n,s=ys){let r,o=xt.getTransfer(s);if(n===Fi)return i.UNSIGNED_BYTE;if(n===Wc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Xc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Mf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===wf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===yf)return i.BYTE;if(n===bf)return i.SHORT;if(n===Mo)return i.UNSIGNED_SHORT;if(n===Gc)return i.INT;if(n===Ws)return i.UNSIGNED_INT;if(n===es)return i.FLOAT;if(n===wo)return i.HALF_FLOAT;if(n===Sf)return i.ALPHA;if(n===Ef)return i.RGB;if(n===xi)return i.RGBA;if(n===ho)return i.DEPTH_COMPONENT;if(n===Eo)return i.DEPTH_STENCIL;if(n===Tf)return i.RED;if(n===qc)return i.RED_INTEGER;if(n===Af)return i.RG;if(n===Yc)return i.RG_INTEGER;if(n===$c)return i.RGBA_INTEGER;if(n===Wa||n===Xa||n===qa||n===Ya)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Wa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Wa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ya)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Zc||n===Kc||n===Jc||n===jc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Zc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Kc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===jc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Qc||n===eh||n===th)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Qc||n===eh)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===th)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===fh||n===dh||n===ph||n===mh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===nh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ih)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===sh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===rh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ah)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===lh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ch)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===dh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ph)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===mh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===gh||n===vh||n===xh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===gh)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===xh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===_h||n===yh||n===bh||n===Mh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===_h)return r.COMPRESSED_RED_RGTC1_EXT;if(n===yh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===bh)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Mh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===So?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var zS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,kS=`
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

}`,Kf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ea(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ai({vertexShader:zS,fragmentShader:kS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ke(new Ca(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Jf=class extends Zi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,m=null,g=null,v=typeof XRWebGLBinding<"u",p=new Kf,d={},y=t.getContextAttributes(),b=null,_=null,C=[],E=[],P=new Fe,L=null,M=new Dn;M.viewport=new It;let S=new Dn;S.viewport=new It;let A=[M,S],k=new Lc,O=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(te){let K=C[te];return K===void 0&&(K=new mo,C[te]=K),K.getTargetRaySpace()},this.getControllerGrip=function(te){let K=C[te];return K===void 0&&(K=new mo,C[te]=K),K.getGripSpace()},this.getHand=function(te){let K=C[te];return K===void 0&&(K=new mo,C[te]=K),K.getHandSpace()};function q(te){let K=E.indexOf(te.inputSource);if(K===-1)return;let ve=C[K];ve!==void 0&&(ve.update(te.inputSource,te.frame,c||o),ve.dispatchEvent({type:te.type,data:te.inputSource}))}function $(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",$),s.removeEventListener("inputsourceschange",N);for(let te=0;te<C.length;te++){let K=E[te];K!==null&&(E[te]=null,C[te].disconnect(K))}O=null,V=null,p.reset();for(let te in d)delete d[te];e.setRenderTarget(b),m=null,f=null,h=null,s=null,_=null,Ee.stop(),n.isPresenting=!1,e.setPixelRatio(L),e.setSize(P.width,P.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(te){r=te,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(te){a=te,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(te){c=te},this.getBaseLayer=function(){return f!==null?f:m},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(te){if(s=te,s!==null){if(b=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",$),s.addEventListener("inputsourceschange",N),y.xrCompatible!==!0&&await t.makeXRCompatible(),L=e.getPixelRatio(),e.getSize(P),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,_e=null,Ae=null;y.depth&&(Ae=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=y.stencil?Eo:ho,_e=y.stencil?So:Ws);let We={colorFormat:t.RGBA8,depthFormat:Ae,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(We),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),_=new Ki(f.textureWidth,f.textureHeight,{format:xi,type:Fi,depthTexture:new Sa(f.textureWidth,f.textureHeight,_e,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let ve={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),_=new Ki(m.framebufferWidth,m.framebufferHeight,{format:xi,type:Fi,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Ee.setContext(s),Ee.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function N(te){for(let K=0;K<te.removed.length;K++){let ve=te.removed[K],_e=E.indexOf(ve);_e>=0&&(E[_e]=null,C[_e].disconnect(ve))}for(let K=0;K<te.added.length;K++){let ve=te.added[K],_e=E.indexOf(ve);if(_e===-1){for(let We=0;We<C.length;We++)if(We>=E.length){E.push(ve),_e=We;break}else if(E[We]===null){E[We]=ve,_e=We;break}if(_e===-1)break}let Ae=C[_e];Ae&&Ae.connect(ve)}}let z=new I,Q=new I;function ie(te,K,ve){z.setFromMatrixPosition(K.matrixWorld),Q.setFromMatrixPosition(ve.matrixWorld);let _e=z.distanceTo(Q),Ae=K.projectionMatrix.elements,We=ve.projectionMatrix.elements,ut=Ae[14]/(Ae[10]-1),H=Ae[14]/(Ae[10]+1),lt=(Ae[9]+1)/Ae[5],oe=(Ae[9]-1)/Ae[5],we=(Ae[8]-1)/Ae[0],Pe=(We[8]+1)/We[0],at=ut*we,ae=ut*Pe,De=_e/(-we+Pe),je=De*-we;if(K.matrixWorld.decompose(te.position,te.quaternion,te.scale),te.translateX(je),te.translateZ(De),te.matrixWorld.compose(te.position,te.quaternion,te.scale),te.matrixWorldInverse.copy(te.matrixWorld).invert(),Ae[10]===-1)te.projectionMatrix.copy(K.projectionMatrix),te.projectionMatrixInverse.copy(K.projectionMatrixInverse);else{let rt=ut+De,U=H+De,w=at-je,G=ae+(_e-je),B=lt*H/U*rt,W=oe*H/U*rt;te.projectionMatrix.makePerspective(w,G,B,W,rt,U),te.projectionMatrixInverse.copy(te.projectionMatrix).invert()}}function ne(te,K){K===null?te.matrixWorld.copy(te.matrix):te.matrixWorld.multiplyMatrices(K.matrixWorld,te.matrix),te.matrixWorldInverse.copy(te.matrixWorld).invert()}this.updateCamera=function(te){if(s===null)return;let K=te.near,ve=te.far;p.texture!==null&&(p.depthNear>0&&(K=p.depthNear),p.depthFar>0&&(ve=p.depthFar)),k.near=S.near=M.near=K,k.far=S.far=M.far=ve,(O!==k.near||V!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),O=k.near,V=k.far),k.layers.mask=te.layers.mask|6,M.layers.mask=k.layers.mask&3,S.layers.mask=k.layers.mask&5;let _e=te.parent,Ae=k.cameras;ne(k,_e);for(let We=0;We<Ae.length;We++)ne(Ae[We],_e);Ae.length===2?ie(k,M,S):k.projectionMatrix.copy(M.projectionMatrix),ce(te,k,_e)};function ce(te,K,ve){ve===null?te.matrix.copy(K.matrixWorld):(te.matrix.copy(ve.matrixWorld),te.matrix.invert(),te.matrix.multiply(K.matrixWorld)),te.matrix.decompose(te.position,te.quaternion,te.scale),te.updateMatrixWorld(!0),te.projectionMatrix.copy(K.projectionMatrix),te.projectionMatrixInverse.copy(K.projectionMatrixInverse),te.isPerspectiveCamera&&(te.fov=uo*2*Math.atan(1/te.projectionMatrix.elements[5]),te.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(f===null&&m===null))return l},this.setFoveation=function(te){l=te,f!==null&&(f.fixedFoveation=te),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=te)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(k)},this.getCameraTexture=function(te){return d[te]};let he=null;function Me(te,K){if(u=K.getViewerPose(c||o),g=K,u!==null){let ve=u.views;m!==null&&(e.setRenderTargetFramebuffer(_,m.framebuffer),e.setRenderTarget(_));let _e=!1;ve.length!==k.cameras.length&&(k.cameras.length=0,_e=!0);for(let H=0;H<ve.length;H++){let lt=ve[H],oe=null;if(m!==null)oe=m.getViewport(lt);else{let Pe=h.getViewSubImage(f,lt);oe=Pe.viewport,H===0&&(e.setRenderTargetTextures(_,Pe.colorTexture,Pe.depthStencilTexture),e.setRenderTarget(_))}let we=A[H];we===void 0&&(we=new Dn,we.layers.enable(H),we.viewport=new It,A[H]=we),we.matrix.fromArray(lt.transform.matrix),we.matrix.decompose(we.position,we.quaternion,we.scale),we.projectionMatrix.fromArray(lt.projectionMatrix),we.projectionMatrixInverse.copy(we.projectionMatrix).invert(),we.viewport.set(oe.x,oe.y,oe.width,oe.height),H===0&&(k.matrix.copy(we.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),_e===!0&&k.cameras.push(we)}let Ae=s.enabledFeatures;if(Ae&&Ae.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=n.getBinding();let H=h.getDepthInformation(ve[0]);H&&H.isValid&&H.texture&&p.init(H,s.renderState)}if(Ae&&Ae.includes("camera-access")&&v){e.state.unbindTexture(),h=n.getBinding();for(let H=0;H<ve.length;H++){let lt=ve[H].camera;if(lt){let oe=d[lt];oe||(oe=new Ea,d[lt]=oe);let we=h.getCameraImage(lt);oe.sourceTexture=we}}}}for(let ve=0;ve<C.length;ve++){let _e=E[ve],Ae=C[ve];_e!==null&&Ae!==void 0&&Ae.update(_e,K,c||o)}he&&he(te,K),K.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:K}),g=null}let Ee=new Tg;Ee.setAnimationLoop(Me),this.setAnimationLoop=function(te){he=te},this.dispose=function(){}}},br=new Ui,HS=new Ut;function VS(i,e){function t(p,d){p.matrixAutoUpdate===!0&&p.updateMatrix(),d.value.copy(p.matrix)}function n(p,d){d.color.getRGB(p.fogColor.value,Df(i)),d.isFog?(p.fogNear.value=d.near,p.fogFar.value=d.far):d.isFogExp2&&(p.fogDensity.value=d.density)}function s(p,d,y,b,_){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(p,d):d.isMeshToonMaterial?(r(p,d),h(p,d)):d.isMeshPhongMaterial?(r(p,d),u(p,d)):d.isMeshStandardMaterial?(r(p,d),f(p,d),d.isMeshPhysicalMaterial&&m(p,d,_)):d.isMeshMatcapMaterial?(r(p,d),g(p,d)):d.isMeshDepthMaterial?r(p,d):d.isMeshDistanceMaterial?(r(p,d),v(p,d)):d.isMeshNormalMaterial?r(p,d):d.isLineBasicMaterial?(o(p,d),d.isLineDashedMaterial&&a(p,d)):d.isPointsMaterial?l(p,d,y,b):d.isSpriteMaterial?c(p,d):d.isShadowMaterial?(p.color.value.copy(d.color),p.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(p,d){p.opacity.value=d.opacity,d.color&&p.diffuse.value.copy(d.color),d.emissive&&p.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(p.map.value=d.map,t(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.bumpMap&&(p.bumpMap.value=d.bumpMap,t(d.bumpMap,p.bumpMapTransform),p.bumpScale.value=d.bumpScale,d.side===Wn&&(p.bumpScale.value*=-1)),d.normalMap&&(p.normalMap.value=d.normalMap,t(d.normalMap,p.normalMapTransform),p.normalScale.value.copy(d.normalScale),d.side===Wn&&p.normalScale.value.negate()),d.displacementMap&&(p.displacementMap.value=d.displacementMap,t(d.displacementMap,p.displacementMapTransform),p.displacementScale.value=d.displacementScale,p.displacementBias.value=d.displacementBias),d.emissiveMap&&(p.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,p.emissiveMapTransform)),d.specularMap&&(p.specularMap.value=d.specularMap,t(d.specularMap,p.specularMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest);let y=e.get(d),b=y.envMap,_=y.envMapRotation;b&&(p.envMap.value=b,br.copy(_),br.x*=-1,br.y*=-1,br.z*=-1,b.isCubeTexture&&b.isRenderTargetTexture===!1&&(br.y*=-1,br.z*=-1),p.envMapRotation.value.setFromMatrix4(HS.makeRotationFromEuler(br)),p.flipEnvMap.value=b.isCubeTexture&&b.isRenderTargetTexture===!1?-1:1,p.reflectivity.value=d.reflectivity,p.ior.value=d.ior,p.refractionRatio.value=d.refractionRatio),d.lightMap&&(p.lightMap.value=d.lightMap,p.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,p.lightMapTransform)),d.aoMap&&(p.aoMap.value=d.aoMap,p.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,p.aoMapTransform))}function o(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,d.map&&(p.map.value=d.map,t(d.map,p.mapTransform))}function a(p,d){p.dashSize.value=d.dashSize,p.totalSize.value=d.dashSize+d.gapSize,p.scale.value=d.scale}function l(p,d,y,b){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.size.value=d.size*y,p.scale.value=b*.5,d.map&&(p.map.value=d.map,t(d.map,p.uvTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function c(p,d){p.diffuse.value.copy(d.color),p.opacity.value=d.opacity,p.rotation.value=d.rotation,d.map&&(p.map.value=d.map,t(d.map,p.mapTransform)),d.alphaMap&&(p.alphaMap.value=d.alphaMap,t(d.alphaMap,p.alphaMapTransform)),d.alphaTest>0&&(p.alphaTest.value=d.alphaTest)}function u(p,d){p.specular.value.copy(d.specular),p.shininess.value=Math.max(d.shininess,1e-4)}function h(p,d){d.gradientMap&&(p.gradientMap.value=d.gradientMap)}function f(p,d){p.metalness.value=d.metalness,d.metalnessMap&&(p.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,p.metalnessMapTransform)),p.roughness.value=d.roughness,d.roughnessMap&&(p.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,p.roughnessMapTransform)),d.envMap&&(p.envMapIntensity.value=d.envMapIntensity)}function m(p,d,y){p.ior.value=d.ior,d.sheen>0&&(p.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),p.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(p.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,p.sheenColorMapTransform)),d.sheenRoughnessMap&&(p.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,p.sheenRoughnessMapTransform))),d.clearcoat>0&&(p.clearcoat.value=d.clearcoat,p.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(p.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,p.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(p.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Wn&&p.clearcoatNormalScale.value.negate())),d.dispersion>0&&(p.dispersion.value=d.dispersion),d.iridescence>0&&(p.iridescence.value=d.iridescence,p.iridescenceIOR.value=d.iridescenceIOR,p.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(p.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,p.iridescenceMapTransform)),d.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),d.transmission>0&&(p.transmission.value=d.transmission,p.transmissionSamplerMap.value=y.texture,p.transmissionSamplerSize.value.set(y.width,y.height),d.transmissionMap&&(p.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,p.transmissionMapTransform)),p.thickness.value=d.thickness,d.thicknessMap&&(p.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=d.attenuationDistance,p.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(p.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(p.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=d.specularIntensity,p.specularColor.value.copy(d.specularColor),d.specularColorMap&&(p.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,p.specularColorMapTransform)),d.specularIntensityMap&&(p.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,d){d.matcap&&(p.matcap.value=d.matcap)}function v(p,d){let y=e.get(d).light;p.referencePosition.value.setFromMatrixPosition(y.matrixWorld),p.nearDistance.value=y.shadow.camera.near,p.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function GS(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(y,b){let _=b.program;n.uniformBlockBinding(y,_)}function c(y,b){let _=s[y.id];_===void 0&&(g(y),_=u(y),s[y.id]=_,y.addEventListener("dispose",p));let C=b.program;n.updateUBOMapping(y,C);let E=e.render.frame;r[y.id]!==E&&(f(y),r[y.id]=E)}function u(y){let b=h();y.__bindingPointIndex=b;let _=i.createBuffer(),C=y.__size,E=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,_),i.bufferData(i.UNIFORM_BUFFER,C,E),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,b,_),_}function h(){for(let y=0;y<a;y++)if(o.indexOf(y)===-1)return o.push(y),y;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(y){let b=s[y.id],_=y.uniforms,C=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,b);for(let E=0,P=_.length;E<P;E++){let L=Array.isArray(_[E])?_[E]:[_[E]];for(let M=0,S=L.length;M<S;M++){let A=L[M];if(m(A,E,M,C)===!0){let k=A.__offset,O=Array.isArray(A.value)?A.value:[A.value],V=0;for(let q=0;q<O.length;q++){let $=O[q],N=v($);typeof $=="number"||typeof $=="boolean"?(A.__data[0]=$,i.bufferSubData(i.UNIFORM_BUFFER,k+V,A.__data)):$.isMatrix3?(A.__data[0]=$.elements[0],A.__data[1]=$.elements[1],A.__data[2]=$.elements[2],A.__data[3]=0,A.__data[4]=$.elements[3],A.__data[5]=$.elements[4],A.__data[6]=$.elements[5],A.__data[7]=0,A.__data[8]=$.elements[6],A.__data[9]=$.elements[7],A.__data[10]=$.elements[8],A.__data[11]=0):($.toArray(A.__data,V),V+=N.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,k,A.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function m(y,b,_,C){let E=y.value,P=b+"_"+_;if(C[P]===void 0)return typeof E=="number"||typeof E=="boolean"?C[P]=E:C[P]=E.clone(),!0;{let L=C[P];if(typeof E=="number"||typeof E=="boolean"){if(L!==E)return C[P]=E,!0}else if(L.equals(E)===!1)return L.copy(E),!0}return!1}function g(y){let b=y.uniforms,_=0,C=16;for(let P=0,L=b.length;P<L;P++){let M=Array.isArray(b[P])?b[P]:[b[P]];for(let S=0,A=M.length;S<A;S++){let k=M[S],O=Array.isArray(k.value)?k.value:[k.value];for(let V=0,q=O.length;V<q;V++){let $=O[V],N=v($),z=_%C,Q=z%N.boundary,ie=z+Q;_+=Q,ie!==0&&C-ie<N.storage&&(_+=C-ie),k.__data=new Float32Array(N.storage/Float32Array.BYTES_PER_ELEMENT),k.__offset=_,_+=N.storage}}}let E=_%C;return E>0&&(_+=C-E),y.__size=_,y.__cache={},this}function v(y){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=48,b.storage=48):y.isMatrix4?(b.boundary=64,b.storage=64):y.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",y),b}function p(y){let b=y.target;b.removeEventListener("dispose",p);let _=o.indexOf(b.__bindingPointIndex);o.splice(_,1),i.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function d(){for(let y in s)i.deleteBuffer(s[y]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var Ch=class{constructor(e={}){let{canvas:t=jm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let g=new Uint32Array(4),v=new Int32Array(4),p=null,d=null,y=[],b=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=_s,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let _=this,C=!1;this._outputColorSpace=Gn;let E=0,P=0,L=null,M=-1,S=null,A=new It,k=new It,O=null,V=new ot(0),q=0,$=t.width,N=t.height,z=1,Q=null,ie=null,ne=new It(0,0,$,N),ce=new It(0,0,$,N),he=!1,Me=new _o,Ee=!1,te=!1,K=new Ut,ve=new I,_e=new It,Ae={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},We=!1;function ut(){return L===null?z:1}let H=n;function lt(R,J){return t.getContext(R,J)}try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"180"}`),t.addEventListener("webglcontextlost",Re,!1),t.addEventListener("webglcontextrestored",Ge,!1),t.addEventListener("webglcontextcreationerror",Te,!1),H===null){let J="webgl2";if(H=lt(J,R),H===null)throw lt(J)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(R){throw console.error("THREE.WebGLRenderer: "+R.message),R}let oe,we,Pe,at,ae,De,je,rt,U,w,G,B,W,j,pe,de,ye,fe,ue,xe,Oe,He,Le,Ze;function Y(){oe=new aw(H),oe.init(),He=new BS(H,oe),we=new ew(H,oe,e,He),Pe=new FS(H,oe),we.reversedDepthBuffer&&f&&Pe.buffers.depth.setReversed(!0),at=new hw(H),ae=new wS,De=new OS(H,oe,Pe,ae,we,He,at),je=new nw(_),rt=new ow(_),U=new gy(H),Le=new jM(H,U),w=new lw(H,U,at,Le),G=new fw(H,w,U,at),ue=new uw(H,we,De),de=new tw(ae),B=new MS(_,je,rt,oe,we,Le,de),W=new VS(_,ae),j=new ES,pe=new IS(oe),fe=new JM(_,je,rt,Pe,G,m,l),ye=new US(_,G,we),Ze=new GS(H,at,we,Pe),xe=new QM(H,oe,at),Oe=new cw(H,oe,at),at.programs=B.programs,_.capabilities=we,_.extensions=oe,_.properties=ae,_.renderLists=j,_.shadowMap=ye,_.state=Pe,_.info=at}Y();let be=new Jf(_,H);this.xr=be,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let R=oe.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=oe.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return z},this.setPixelRatio=function(R){R!==void 0&&(z=R,this.setSize($,N,!1))},this.getSize=function(R){return R.set($,N)},this.setSize=function(R,J,le=!0){if(be.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}$=R,N=J,t.width=Math.floor(R*z),t.height=Math.floor(J*z),le===!0&&(t.style.width=R+"px",t.style.height=J+"px"),this.setViewport(0,0,R,J)},this.getDrawingBufferSize=function(R){return R.set($*z,N*z).floor()},this.setDrawingBufferSize=function(R,J,le){$=R,N=J,z=le,t.width=Math.floor(R*le),t.height=Math.floor(J*le),this.setViewport(0,0,R,J)},this.getCurrentViewport=function(R){return R.copy(A)},this.getViewport=function(R){return R.copy(ne)},this.setViewport=function(R,J,le,re){R.isVector4?ne.set(R.x,R.y,R.z,R.w):ne.set(R,J,le,re),Pe.viewport(A.copy(ne).multiplyScalar(z).round())},this.getScissor=function(R){return R.copy(ce)},this.setScissor=function(R,J,le,re){R.isVector4?ce.set(R.x,R.y,R.z,R.w):ce.set(R,J,le,re),Pe.scissor(k.copy(ce).multiplyScalar(z).round())},this.getScissorTest=function(){return he},this.setScissorTest=function(R){Pe.setScissorTest(he=R)},this.setOpaqueSort=function(R){Q=R},this.setTransparentSort=function(R){ie=R},this.getClearColor=function(R){return R.copy(fe.getClearColor())},this.setClearColor=function(){fe.setClearColor(...arguments)},this.getClearAlpha=function(){return fe.getClearAlpha()},this.setClearAlpha=function(){fe.setClearAlpha(...arguments)},this.clear=function(R=!0,J=!0,le=!0){let re=0;if(R){let ee=!1;if(L!==null){let Ce=L.texture.format;ee=Ce===$c||Ce===Yc||Ce===qc}if(ee){let Ce=L.texture.type,Ne=Ce===Fi||Ce===Ws||Ce===Mo||Ce===So||Ce===Wc||Ce===Xc,Xe=fe.getClearColor(),ze=fe.getClearAlpha(),Qe=Xe.r,et=Xe.g,Ye=Xe.b;Ne?(g[0]=Qe,g[1]=et,g[2]=Ye,g[3]=ze,H.clearBufferuiv(H.COLOR,0,g)):(v[0]=Qe,v[1]=et,v[2]=Ye,v[3]=ze,H.clearBufferiv(H.COLOR,0,v))}else re|=H.COLOR_BUFFER_BIT}J&&(re|=H.DEPTH_BUFFER_BIT),le&&(re|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H.clear(re)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",Re,!1),t.removeEventListener("webglcontextrestored",Ge,!1),t.removeEventListener("webglcontextcreationerror",Te,!1),fe.dispose(),j.dispose(),pe.dispose(),ae.dispose(),je.dispose(),rt.dispose(),G.dispose(),Le.dispose(),Ze.dispose(),B.dispose(),be.dispose(),be.removeEventListener("sessionstart",Ft),be.removeEventListener("sessionend",ei),Yn.stop()};function Re(R){R.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),C=!0}function Ge(){console.log("THREE.WebGLRenderer: Context Restored."),C=!1;let R=at.autoReset,J=ye.enabled,le=ye.autoUpdate,re=ye.needsUpdate,ee=ye.type;Y(),at.autoReset=R,ye.enabled=J,ye.autoUpdate=le,ye.needsUpdate=re,ye.type=ee}function Te(R){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function ge(R){let J=R.target;J.removeEventListener("dispose",ge),Be(J)}function Be(R){it(R),ae.remove(R)}function it(R){let J=ae.get(R).programs;J!==void 0&&(J.forEach(function(le){B.releaseProgram(le)}),R.isShaderMaterial&&B.releaseShaderCache(R))}this.renderBufferDirect=function(R,J,le,re,ee,Ce){J===null&&(J=Ae);let Ne=ee.isMesh&&ee.matrixWorld.determinant()<0,Xe=os(R,J,le,re,ee);Pe.setMaterial(re,Ne);let ze=le.index,Qe=1;if(re.wireframe===!0){if(ze=w.getWireframeAttribute(le),ze===void 0)return;Qe=2}let et=le.drawRange,Ye=le.attributes.position,ft=et.start*Qe,bt=(et.start+et.count)*Qe;Ce!==null&&(ft=Math.max(ft,Ce.start*Qe),bt=Math.min(bt,(Ce.start+Ce.count)*Qe)),ze!==null?(ft=Math.max(ft,0),bt=Math.min(bt,ze.count)):Ye!=null&&(ft=Math.max(ft,0),bt=Math.min(bt,Ye.count));let kt=bt-ft;if(kt<0||kt===1/0)return;Le.setup(ee,re,Xe,le,ze);let Rt,ct=xe;if(ze!==null&&(Rt=U.get(ze),ct=Oe,ct.setIndex(Rt)),ee.isMesh)re.wireframe===!0?(Pe.setLineWidth(re.wireframeLinewidth*ut()),ct.setMode(H.LINES)):ct.setMode(H.TRIANGLES);else if(ee.isLine){let Je=re.linewidth;Je===void 0&&(Je=1),Pe.setLineWidth(Je*ut()),ee.isLineSegments?ct.setMode(H.LINES):ee.isLineLoop?ct.setMode(H.LINE_LOOP):ct.setMode(H.LINE_STRIP)}else ee.isPoints?ct.setMode(H.POINTS):ee.isSprite&&ct.setMode(H.TRIANGLES);if(ee.isBatchedMesh)if(ee._multiDrawInstances!==null)fo("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),ct.renderMultiDrawInstances(ee._multiDrawStarts,ee._multiDrawCounts,ee._multiDrawCount,ee._multiDrawInstances);else if(oe.get("WEBGL_multi_draw"))ct.renderMultiDraw(ee._multiDrawStarts,ee._multiDrawCounts,ee._multiDrawCount);else{let Je=ee._multiDrawStarts,Ht=ee._multiDrawCounts,gt=ee._multiDrawCount,Rn=ze?U.get(ze).bytesPerElement:1,ws=ae.get(re).currentProgram.getUniforms();for(let On=0;On<gt;On++)ws.setValue(H,"_gl_DrawID",On),ct.render(Je[On]/Rn,Ht[On])}else if(ee.isInstancedMesh)ct.renderInstances(ft,kt,ee.count);else if(le.isInstancedBufferGeometry){let Je=le._maxInstanceCount!==void 0?le._maxInstanceCount:1/0,Ht=Math.min(le.instanceCount,Je);ct.renderInstances(ft,kt,Ht)}else ct.render(ft,kt)};function Lt(R,J,le){R.transparent===!0&&R.side===Sn&&R.forceSinglePass===!1?(R.side=Wn,R.needsUpdate=!0,Zs(R,J,le),R.side=gs,R.needsUpdate=!0,Zs(R,J,le),R.side=Sn):Zs(R,J,le)}this.compile=function(R,J,le=null){le===null&&(le=R),d=pe.get(le),d.init(J),b.push(d),le.traverseVisible(function(ee){ee.isLight&&ee.layers.test(J.layers)&&(d.pushLight(ee),ee.castShadow&&d.pushShadow(ee))}),R!==le&&R.traverseVisible(function(ee){ee.isLight&&ee.layers.test(J.layers)&&(d.pushLight(ee),ee.castShadow&&d.pushShadow(ee))}),d.setupLights();let re=new Set;return R.traverse(function(ee){if(!(ee.isMesh||ee.isPoints||ee.isLine||ee.isSprite))return;let Ce=ee.material;if(Ce)if(Array.isArray(Ce))for(let Ne=0;Ne<Ce.length;Ne++){let Xe=Ce[Ne];Lt(Xe,le,ee),re.add(Xe)}else Lt(Ce,le,ee),re.add(Ce)}),d=b.pop(),re},this.compileAsync=function(R,J,le=null){let re=this.compile(R,J,le);return new Promise(ee=>{function Ce(){if(re.forEach(function(Ne){ae.get(Ne).currentProgram.isReady()&&re.delete(Ne)}),re.size===0){ee(R);return}setTimeout(Ce,10)}oe.get("KHR_parallel_shader_compile")!==null?Ce():setTimeout(Ce,10)})};let yt=null;function bn(R){yt&&yt(R)}function Ft(){Yn.stop()}function ei(){Yn.start()}let Yn=new Tg;Yn.setAnimationLoop(bn),typeof self<"u"&&Yn.setContext(self),this.setAnimationLoop=function(R){yt=R,be.setAnimationLoop(R),R===null?Yn.stop():Yn.start()},be.addEventListener("sessionstart",Ft),be.addEventListener("sessionend",ei),this.render=function(R,J){if(J!==void 0&&J.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),J.parent===null&&J.matrixWorldAutoUpdate===!0&&J.updateMatrixWorld(),be.enabled===!0&&be.isPresenting===!0&&(be.cameraAutoUpdate===!0&&be.updateCamera(J),J=be.getCamera()),R.isScene===!0&&R.onBeforeRender(_,R,J,L),d=pe.get(R,b.length),d.init(J),b.push(d),K.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),Me.setFromProjectionMatrix(K,Ii,J.reversedDepth),te=this.localClippingEnabled,Ee=de.init(this.clippingPlanes,te),p=j.get(R,y.length),p.init(),y.push(p),be.enabled===!0&&be.isPresenting===!0){let Ce=_.xr.getDepthSensingMesh();Ce!==null&&Hi(Ce,J,-1/0,_.sortObjects)}Hi(R,J,0,_.sortObjects),p.finish(),_.sortObjects===!0&&p.sort(Q,ie),We=be.enabled===!1||be.isPresenting===!1||be.hasDepthSensing()===!1,We&&fe.addToRenderList(p,R),this.info.render.frame++,Ee===!0&&de.beginShadows();let le=d.state.shadowsArray;ye.render(le,R,J),Ee===!0&&de.endShadows(),this.info.autoReset===!0&&this.info.reset();let re=p.opaque,ee=p.transmissive;if(d.setupLights(),J.isArrayCamera){let Ce=J.cameras;if(ee.length>0)for(let Ne=0,Xe=Ce.length;Ne<Xe;Ne++){let ze=Ce[Ne];rs(re,ee,R,ze)}We&&fe.render(R);for(let Ne=0,Xe=Ce.length;Ne<Xe;Ne++){let ze=Ce[Ne];Fn(p,R,ze,ze.viewport)}}else ee.length>0&&rs(re,ee,R,J),We&&fe.render(R),Fn(p,R,J);L!==null&&P===0&&(De.updateMultisampleRenderTarget(L),De.updateRenderTargetMipmap(L)),R.isScene===!0&&R.onAfterRender(_,R,J),Le.resetDefaultState(),M=-1,S=null,b.pop(),b.length>0?(d=b[b.length-1],Ee===!0&&de.setGlobalState(_.clippingPlanes,d.state.camera)):d=null,y.pop(),y.length>0?p=y[y.length-1]:p=null};function Hi(R,J,le,re){if(R.visible===!1)return;if(R.layers.test(J.layers)){if(R.isGroup)le=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(J);else if(R.isLight)d.pushLight(R),R.castShadow&&d.pushShadow(R);else if(R.isSprite){if(!R.frustumCulled||Me.intersectsSprite(R)){re&&_e.setFromMatrixPosition(R.matrixWorld).applyMatrix4(K);let Ne=G.update(R),Xe=R.material;Xe.visible&&p.push(R,Ne,Xe,le,_e.z,null)}}else if((R.isMesh||R.isLine||R.isPoints)&&(!R.frustumCulled||Me.intersectsObject(R))){let Ne=G.update(R),Xe=R.material;if(re&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),_e.copy(R.boundingSphere.center)):(Ne.boundingSphere===null&&Ne.computeBoundingSphere(),_e.copy(Ne.boundingSphere.center)),_e.applyMatrix4(R.matrixWorld).applyMatrix4(K)),Array.isArray(Xe)){let ze=Ne.groups;for(let Qe=0,et=ze.length;Qe<et;Qe++){let Ye=ze[Qe],ft=Xe[Ye.materialIndex];ft&&ft.visible&&p.push(R,Ne,ft,le,_e.z,Ye)}}else Xe.visible&&p.push(R,Ne,Xe,le,_e.z,null)}}let Ce=R.children;for(let Ne=0,Xe=Ce.length;Ne<Xe;Ne++)Hi(Ce[Ne],J,le,re)}function Fn(R,J,le,re){let ee=R.opaque,Ce=R.transmissive,Ne=R.transparent;d.setupLightsView(le),Ee===!0&&de.setGlobalState(_.clippingPlanes,le),re&&Pe.viewport(A.copy(re)),ee.length>0&&bi(ee,J,le),Ce.length>0&&bi(Ce,J,le),Ne.length>0&&bi(Ne,J,le),Pe.buffers.depth.setTest(!0),Pe.buffers.depth.setMask(!0),Pe.buffers.color.setMask(!0),Pe.setPolygonOffset(!1)}function rs(R,J,le,re){if((le.isScene===!0?le.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[re.id]===void 0&&(d.state.transmissionRenderTarget[re.id]=new Ki(1,1,{generateMipmaps:!0,type:oe.has("EXT_color_buffer_half_float")||oe.has("EXT_color_buffer_float")?wo:Fi,minFilter:Gs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:xt.workingColorSpace}));let Ce=d.state.transmissionRenderTarget[re.id],Ne=re.viewport||A;Ce.setSize(Ne.z*_.transmissionResolutionScale,Ne.w*_.transmissionResolutionScale);let Xe=_.getRenderTarget(),ze=_.getActiveCubeFace(),Qe=_.getActiveMipmapLevel();_.setRenderTarget(Ce),_.getClearColor(V),q=_.getClearAlpha(),q<1&&_.setClearColor(16777215,.5),_.clear(),We&&fe.render(le);let et=_.toneMapping;_.toneMapping=_s;let Ye=re.viewport;if(re.viewport!==void 0&&(re.viewport=void 0),d.setupLightsView(re),Ee===!0&&de.setGlobalState(_.clippingPlanes,re),bi(R,le,re),De.updateMultisampleRenderTarget(Ce),De.updateRenderTargetMipmap(Ce),oe.has("WEBGL_multisampled_render_to_texture")===!1){let ft=!1;for(let bt=0,kt=J.length;bt<kt;bt++){let Rt=J[bt],ct=Rt.object,Je=Rt.geometry,Ht=Rt.material,gt=Rt.group;if(Ht.side===Sn&&ct.layers.test(re.layers)){let Rn=Ht.side;Ht.side=Wn,Ht.needsUpdate=!0,Wo(ct,le,re,Je,Ht,gt),Ht.side=Rn,Ht.needsUpdate=!0,ft=!0}}ft===!0&&(De.updateMultisampleRenderTarget(Ce),De.updateRenderTargetMipmap(Ce))}_.setRenderTarget(Xe,ze,Qe),_.setClearColor(V,q),Ye!==void 0&&(re.viewport=Ye),_.toneMapping=et}function bi(R,J,le){let re=J.isScene===!0?J.overrideMaterial:null;for(let ee=0,Ce=R.length;ee<Ce;ee++){let Ne=R[ee],Xe=Ne.object,ze=Ne.geometry,Qe=Ne.group,et=Ne.material;et.allowOverride===!0&&re!==null&&(et=re),Xe.layers.test(le.layers)&&Wo(Xe,J,le,ze,et,Qe)}}function Wo(R,J,le,re,ee,Ce){R.onBeforeRender(_,J,le,re,ee,Ce),R.modelViewMatrix.multiplyMatrices(le.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),ee.onBeforeRender(_,J,le,re,R,Ce),ee.transparent===!0&&ee.side===Sn&&ee.forceSinglePass===!1?(ee.side=Wn,ee.needsUpdate=!0,_.renderBufferDirect(le,J,re,ee,R,Ce),ee.side=gs,ee.needsUpdate=!0,_.renderBufferDirect(le,J,re,ee,R,Ce),ee.side=Sn):_.renderBufferDirect(le,J,re,ee,R,Ce),R.onAfterRender(_,J,le,re,ee,Ce)}function Zs(R,J,le){J.isScene!==!0&&(J=Ae);let re=ae.get(R),ee=d.state.lights,Ce=d.state.shadowsArray,Ne=ee.state.version,Xe=B.getParameters(R,ee.state,Ce,J,le),ze=B.getProgramCacheKey(Xe),Qe=re.programs;re.environment=R.isMeshStandardMaterial?J.environment:null,re.fog=J.fog,re.envMap=(R.isMeshStandardMaterial?rt:je).get(R.envMap||re.environment),re.envMapRotation=re.environment!==null&&R.envMap===null?J.environmentRotation:R.envMapRotation,Qe===void 0&&(R.addEventListener("dispose",ge),Qe=new Map,re.programs=Qe);let et=Qe.get(ze);if(et!==void 0){if(re.currentProgram===et&&re.lightsStateVersion===Ne)return dl(R,Xe),et}else Xe.uniforms=B.getUniforms(R),R.onBeforeCompile(Xe,_),et=B.acquireProgram(Xe,ze),Qe.set(ze,et),re.uniforms=Xe.uniforms;let Ye=re.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ye.clippingPlanes=de.uniform),dl(R,Xe),re.needsLights=Ks(R),re.lightsStateVersion=Ne,re.needsLights&&(Ye.ambientLightColor.value=ee.state.ambient,Ye.lightProbe.value=ee.state.probe,Ye.directionalLights.value=ee.state.directional,Ye.directionalLightShadows.value=ee.state.directionalShadow,Ye.spotLights.value=ee.state.spot,Ye.spotLightShadows.value=ee.state.spotShadow,Ye.rectAreaLights.value=ee.state.rectArea,Ye.ltc_1.value=ee.state.rectAreaLTC1,Ye.ltc_2.value=ee.state.rectAreaLTC2,Ye.pointLights.value=ee.state.point,Ye.pointLightShadows.value=ee.state.pointShadow,Ye.hemisphereLights.value=ee.state.hemi,Ye.directionalShadowMap.value=ee.state.directionalShadowMap,Ye.directionalShadowMatrix.value=ee.state.directionalShadowMatrix,Ye.spotShadowMap.value=ee.state.spotShadowMap,Ye.spotLightMatrix.value=ee.state.spotLightMatrix,Ye.spotLightMap.value=ee.state.spotLightMap,Ye.pointShadowMap.value=ee.state.pointShadowMap,Ye.pointShadowMatrix.value=ee.state.pointShadowMatrix),re.currentProgram=et,re.uniformsList=null,et}function fl(R){if(R.uniformsList===null){let J=R.currentProgram.getUniforms();R.uniformsList=Ro.seqWithValue(J.seq,R.uniforms)}return R.uniformsList}function dl(R,J){let le=ae.get(R);le.outputColorSpace=J.outputColorSpace,le.batching=J.batching,le.batchingColor=J.batchingColor,le.instancing=J.instancing,le.instancingColor=J.instancingColor,le.instancingMorph=J.instancingMorph,le.skinning=J.skinning,le.morphTargets=J.morphTargets,le.morphNormals=J.morphNormals,le.morphColors=J.morphColors,le.morphTargetsCount=J.morphTargetsCount,le.numClippingPlanes=J.numClippingPlanes,le.numIntersection=J.numClipIntersection,le.vertexAlphas=J.vertexAlphas,le.vertexTangents=J.vertexTangents,le.toneMapping=J.toneMapping}function os(R,J,le,re,ee){J.isScene!==!0&&(J=Ae),De.resetTextureUnits();let Ce=J.fog,Ne=re.isMeshStandardMaterial?J.environment:null,Xe=L===null?_.outputColorSpace:L.isXRRenderTarget===!0?L.texture.colorSpace:hr,ze=(re.isMeshStandardMaterial?rt:je).get(re.envMap||Ne),Qe=re.vertexColors===!0&&!!le.attributes.color&&le.attributes.color.itemSize===4,et=!!le.attributes.tangent&&(!!re.normalMap||re.anisotropy>0),Ye=!!le.morphAttributes.position,ft=!!le.morphAttributes.normal,bt=!!le.morphAttributes.color,kt=_s;re.toneMapped&&(L===null||L.isXRRenderTarget===!0)&&(kt=_.toneMapping);let Rt=le.morphAttributes.position||le.morphAttributes.normal||le.morphAttributes.color,ct=Rt!==void 0?Rt.length:0,Je=ae.get(re),Ht=d.state.lights;if(Ee===!0&&(te===!0||R!==S)){let pn=R===S&&re.id===M;de.setState(re,R,pn)}let gt=!1;re.version===Je.__version?(Je.needsLights&&Je.lightsStateVersion!==Ht.state.version||Je.outputColorSpace!==Xe||ee.isBatchedMesh&&Je.batching===!1||!ee.isBatchedMesh&&Je.batching===!0||ee.isBatchedMesh&&Je.batchingColor===!0&&ee.colorTexture===null||ee.isBatchedMesh&&Je.batchingColor===!1&&ee.colorTexture!==null||ee.isInstancedMesh&&Je.instancing===!1||!ee.isInstancedMesh&&Je.instancing===!0||ee.isSkinnedMesh&&Je.skinning===!1||!ee.isSkinnedMesh&&Je.skinning===!0||ee.isInstancedMesh&&Je.instancingColor===!0&&ee.instanceColor===null||ee.isInstancedMesh&&Je.instancingColor===!1&&ee.instanceColor!==null||ee.isInstancedMesh&&Je.instancingMorph===!0&&ee.morphTexture===null||ee.isInstancedMesh&&Je.instancingMorph===!1&&ee.morphTexture!==null||Je.envMap!==ze||re.fog===!0&&Je.fog!==Ce||Je.numClippingPlanes!==void 0&&(Je.numClippingPlanes!==de.numPlanes||Je.numIntersection!==de.numIntersection)||Je.vertexAlphas!==Qe||Je.vertexTangents!==et||Je.morphTargets!==Ye||Je.morphNormals!==ft||Je.morphColors!==bt||Je.toneMapping!==kt||Je.morphTargetsCount!==ct)&&(gt=!0):(gt=!0,Je.__version=re.version);let Rn=Je.currentProgram;gt===!0&&(Rn=Zs(re,J,ee));let ws=!1,On=!1,Js=!1,Vt=Rn.getUniforms(),Bn=Je.uniforms;if(Pe.useProgram(Rn.program)&&(ws=!0,On=!0,Js=!0),re.id!==M&&(M=re.id,On=!0),ws||S!==R){Pe.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),Vt.setValue(H,"projectionMatrix",R.projectionMatrix),Vt.setValue(H,"viewMatrix",R.matrixWorldInverse);let mn=Vt.map.cameraPosition;mn!==void 0&&mn.setValue(H,ve.setFromMatrixPosition(R.matrixWorld)),we.logarithmicDepthBuffer&&Vt.setValue(H,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(re.isMeshPhongMaterial||re.isMeshToonMaterial||re.isMeshLambertMaterial||re.isMeshBasicMaterial||re.isMeshStandardMaterial||re.isShaderMaterial)&&Vt.setValue(H,"isOrthographic",R.isOrthographicCamera===!0),S!==R&&(S=R,On=!0,Js=!0)}if(ee.isSkinnedMesh){Vt.setOptional(H,ee,"bindMatrix"),Vt.setOptional(H,ee,"bindMatrixInverse");let pn=ee.skeleton;pn&&(pn.boneTexture===null&&pn.computeBoneTexture(),Vt.setValue(H,"boneTexture",pn.boneTexture,De))}ee.isBatchedMesh&&(Vt.setOptional(H,ee,"batchingTexture"),Vt.setValue(H,"batchingTexture",ee._matricesTexture,De),Vt.setOptional(H,ee,"batchingIdTexture"),Vt.setValue(H,"batchingIdTexture",ee._indirectTexture,De),Vt.setOptional(H,ee,"batchingColorTexture"),ee._colorsTexture!==null&&Vt.setValue(H,"batchingColorTexture",ee._colorsTexture,De));let $n=le.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&ue.update(ee,le,Rn),(On||Je.receiveShadow!==ee.receiveShadow)&&(Je.receiveShadow=ee.receiveShadow,Vt.setValue(H,"receiveShadow",ee.receiveShadow)),re.isMeshGouraudMaterial&&re.envMap!==null&&(Bn.envMap.value=ze,Bn.flipEnvMap.value=ze.isCubeTexture&&ze.isRenderTargetTexture===!1?-1:1),re.isMeshStandardMaterial&&re.envMap===null&&J.environment!==null&&(Bn.envMapIntensity.value=J.environmentIntensity),On&&(Vt.setValue(H,"toneMappingExposure",_.toneMappingExposure),Je.needsLights&&cu(Bn,Js),Ce&&re.fog===!0&&W.refreshFogUniforms(Bn,Ce),W.refreshMaterialUniforms(Bn,re,z,N,d.state.transmissionRenderTarget[R.id]),Ro.upload(H,fl(Je),Bn,De)),re.isShaderMaterial&&re.uniformsNeedUpdate===!0&&(Ro.upload(H,fl(Je),Bn,De),re.uniformsNeedUpdate=!1),re.isSpriteMaterial&&Vt.setValue(H,"center",ee.center),Vt.setValue(H,"modelViewMatrix",ee.modelViewMatrix),Vt.setValue(H,"normalMatrix",ee.normalMatrix),Vt.setValue(H,"modelMatrix",ee.matrixWorld),re.isShaderMaterial||re.isRawShaderMaterial){let pn=re.uniformsGroups;for(let mn=0,Ss=pn.length;mn<Ss;mn++){let fi=pn[mn];Ze.update(fi,Rn),Ze.bind(fi,Rn)}}return Rn}function cu(R,J){R.ambientLightColor.needsUpdate=J,R.lightProbe.needsUpdate=J,R.directionalLights.needsUpdate=J,R.directionalLightShadows.needsUpdate=J,R.pointLights.needsUpdate=J,R.pointLightShadows.needsUpdate=J,R.spotLights.needsUpdate=J,R.spotLightShadows.needsUpdate=J,R.rectAreaLights.needsUpdate=J,R.hemisphereLights.needsUpdate=J}function Ks(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return E},this.getActiveMipmapLevel=function(){return P},this.getRenderTarget=function(){return L},this.setRenderTargetTextures=function(R,J,le){let re=ae.get(R);re.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,re.__autoAllocateDepthBuffer===!1&&(re.__useRenderToTexture=!1),ae.get(R.texture).__webglTexture=J,ae.get(R.depthTexture).__webglTexture=re.__autoAllocateDepthBuffer?void 0:le,re.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,J){let le=ae.get(R);le.__webglFramebuffer=J,le.__useDefaultFramebuffer=J===void 0};let pl=H.createFramebuffer();this.setRenderTarget=function(R,J=0,le=0){L=R,E=J,P=le;let re=!0,ee=null,Ce=!1,Ne=!1;if(R){let ze=ae.get(R);if(ze.__useDefaultFramebuffer!==void 0)Pe.bindFramebuffer(H.FRAMEBUFFER,null),re=!1;else if(ze.__webglFramebuffer===void 0)De.setupRenderTarget(R);else if(ze.__hasExternalTextures)De.rebindTextures(R,ae.get(R.texture).__webglTexture,ae.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Ye=R.depthTexture;if(ze.__boundDepthTexture!==Ye){if(Ye!==null&&ae.has(Ye)&&(R.width!==Ye.image.width||R.height!==Ye.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");De.setupDepthRenderbuffer(R)}}let Qe=R.texture;(Qe.isData3DTexture||Qe.isDataArrayTexture||Qe.isCompressedArrayTexture)&&(Ne=!0);let et=ae.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(et[J])?ee=et[J][le]:ee=et[J],Ce=!0):R.samples>0&&De.useMultisampledRTT(R)===!1?ee=ae.get(R).__webglMultisampledFramebuffer:Array.isArray(et)?ee=et[le]:ee=et,A.copy(R.viewport),k.copy(R.scissor),O=R.scissorTest}else A.copy(ne).multiplyScalar(z).floor(),k.copy(ce).multiplyScalar(z).floor(),O=he;if(le!==0&&(ee=pl),Pe.bindFramebuffer(H.FRAMEBUFFER,ee)&&re&&Pe.drawBuffers(R,ee),Pe.viewport(A),Pe.scissor(k),Pe.setScissorTest(O),Ce){let ze=ae.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+J,ze.__webglTexture,le)}else if(Ne){let ze=J;for(let Qe=0;Qe<R.textures.length;Qe++){let et=ae.get(R.textures[Qe]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+Qe,et.__webglTexture,le,ze)}}else if(R!==null&&le!==0){let ze=ae.get(R.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,ze.__webglTexture,le)}M=-1},this.readRenderTargetPixels=function(R,J,le,re,ee,Ce,Ne,Xe=0){if(!(R&&R.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ze=ae.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ne!==void 0&&(ze=ze[Ne]),ze){Pe.bindFramebuffer(H.FRAMEBUFFER,ze);try{let Qe=R.textures[Xe],et=Qe.format,Ye=Qe.type;if(!we.textureFormatReadable(et)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!we.textureTypeReadable(Ye)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}J>=0&&J<=R.width-re&&le>=0&&le<=R.height-ee&&(R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+Xe),H.readPixels(J,le,re,ee,He.convert(et),He.convert(Ye),Ce))}finally{let Qe=L!==null?ae.get(L).__webglFramebuffer:null;Pe.bindFramebuffer(H.FRAMEBUFFER,Qe)}}},this.readRenderTargetPixelsAsync=async function(R,J,le,re,ee,Ce,Ne,Xe=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ze=ae.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ne!==void 0&&(ze=ze[Ne]),ze)if(J>=0&&J<=R.width-re&&le>=0&&le<=R.height-ee){Pe.bindFramebuffer(H.FRAMEBUFFER,ze);let Qe=R.textures[Xe],et=Qe.format,Ye=Qe.type;if(!we.textureFormatReadable(et))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!we.textureTypeReadable(Ye))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ft=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,ft),H.bufferData(H.PIXEL_PACK_BUFFER,Ce.byteLength,H.STREAM_READ),R.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+Xe),H.readPixels(J,le,re,ee,He.convert(et),He.convert(Ye),0);let bt=L!==null?ae.get(L).__webglFramebuffer:null;Pe.bindFramebuffer(H.FRAMEBUFFER,bt);let kt=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await Qm(H,kt,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,ft),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,Ce),H.deleteBuffer(ft),H.deleteSync(kt),Ce}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,J=null,le=0){let re=Math.pow(2,-le),ee=Math.floor(R.image.width*re),Ce=Math.floor(R.image.height*re),Ne=J!==null?J.x:0,Xe=J!==null?J.y:0;De.setTexture2D(R,0),H.copyTexSubImage2D(H.TEXTURE_2D,le,0,0,Ne,Xe,ee,Ce),Pe.unbindTexture()};let Vi=H.createFramebuffer(),on=H.createFramebuffer();this.copyTextureToTexture=function(R,J,le=null,re=null,ee=0,Ce=null){Ce===null&&(ee!==0?(fo("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),Ce=ee,ee=0):Ce=0);let Ne,Xe,ze,Qe,et,Ye,ft,bt,kt,Rt=R.isCompressedTexture?R.mipmaps[Ce]:R.image;if(le!==null)Ne=le.max.x-le.min.x,Xe=le.max.y-le.min.y,ze=le.isBox3?le.max.z-le.min.z:1,Qe=le.min.x,et=le.min.y,Ye=le.isBox3?le.min.z:0;else{let $n=Math.pow(2,-ee);Ne=Math.floor(Rt.width*$n),Xe=Math.floor(Rt.height*$n),R.isDataArrayTexture?ze=Rt.depth:R.isData3DTexture?ze=Math.floor(Rt.depth*$n):ze=1,Qe=0,et=0,Ye=0}re!==null?(ft=re.x,bt=re.y,kt=re.z):(ft=0,bt=0,kt=0);let ct=He.convert(J.format),Je=He.convert(J.type),Ht;J.isData3DTexture?(De.setTexture3D(J,0),Ht=H.TEXTURE_3D):J.isDataArrayTexture||J.isCompressedArrayTexture?(De.setTexture2DArray(J,0),Ht=H.TEXTURE_2D_ARRAY):(De.setTexture2D(J,0),Ht=H.TEXTURE_2D),H.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,J.flipY),H.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,J.premultiplyAlpha),H.pixelStorei(H.UNPACK_ALIGNMENT,J.unpackAlignment);let gt=H.getParameter(H.UNPACK_ROW_LENGTH),Rn=H.getParameter(H.UNPACK_IMAGE_HEIGHT),ws=H.getParameter(H.UNPACK_SKIP_PIXELS),On=H.getParameter(H.UNPACK_SKIP_ROWS),Js=H.getParameter(H.UNPACK_SKIP_IMAGES);H.pixelStorei(H.UNPACK_ROW_LENGTH,Rt.width),H.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Rt.height),H.pixelStorei(H.UNPACK_SKIP_PIXELS,Qe),H.pixelStorei(H.UNPACK_SKIP_ROWS,et),H.pixelStorei(H.UNPACK_SKIP_IMAGES,Ye);let Vt=R.isDataArrayTexture||R.isData3DTexture,Bn=J.isDataArrayTexture||J.isData3DTexture;if(R.isDepthTexture){let $n=ae.get(R),pn=ae.get(J),mn=ae.get($n.__renderTarget),Ss=ae.get(pn.__renderTarget);Pe.bindFramebuffer(H.READ_FRAMEBUFFER,mn.__webglFramebuffer),Pe.bindFramebuffer(H.DRAW_FRAMEBUFFER,Ss.__webglFramebuffer);for(let fi=0;fi<ze;fi++)Vt&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,ae.get(R).__webglTexture,ee,Ye+fi),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,ae.get(J).__webglTexture,Ce,kt+fi)),H.blitFramebuffer(Qe,et,Ne,Xe,ft,bt,Ne,Xe,H.DEPTH_BUFFER_BIT,H.NEAREST);Pe.bindFramebuffer(H.READ_FRAMEBUFFER,null),Pe.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(ee!==0||R.isRenderTargetTexture||ae.has(R)){let $n=ae.get(R),pn=ae.get(J);Pe.bindFramebuffer(H.READ_FRAMEBUFFER,Vi),Pe.bindFramebuffer(H.DRAW_FRAMEBUFFER,on);for(let mn=0;mn<ze;mn++)Vt?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,$n.__webglTexture,ee,Ye+mn):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,$n.__webglTexture,ee),Bn?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,pn.__webglTexture,Ce,kt+mn):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,pn.__webglTexture,Ce),ee!==0?H.blitFramebuffer(Qe,et,Ne,Xe,ft,bt,Ne,Xe,H.COLOR_BUFFER_BIT,H.NEAREST):Bn?H.copyTexSubImage3D(Ht,Ce,ft,bt,kt+mn,Qe,et,Ne,Xe):H.copyTexSubImage2D(Ht,Ce,ft,bt,Qe,et,Ne,Xe);Pe.bindFramebuffer(H.READ_FRAMEBUFFER,null),Pe.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else Bn?R.isDataTexture||R.isData3DTexture?H.texSubImage3D(Ht,Ce,ft,bt,kt,Ne,Xe,ze,ct,Je,Rt.data):J.isCompressedArrayTexture?H.compressedTexSubImage3D(Ht,Ce,ft,bt,kt,Ne,Xe,ze,ct,Rt.data):H.texSubImage3D(Ht,Ce,ft,bt,kt,Ne,Xe,ze,ct,Je,Rt):R.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,Ce,ft,bt,Ne,Xe,ct,Je,Rt.data):R.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,Ce,ft,bt,Rt.width,Rt.height,ct,Rt.data):H.texSubImage2D(H.TEXTURE_2D,Ce,ft,bt,Ne,Xe,ct,Je,Rt);H.pixelStorei(H.UNPACK_ROW_LENGTH,gt),H.pixelStorei(H.UNPACK_IMAGE_HEIGHT,Rn),H.pixelStorei(H.UNPACK_SKIP_PIXELS,ws),H.pixelStorei(H.UNPACK_SKIP_ROWS,On),H.pixelStorei(H.UNPACK_SKIP_IMAGES,Js),Ce===0&&J.generateMipmaps&&H.generateMipmap(Ht),Pe.unbindTexture()},this.initRenderTarget=function(R){ae.get(R).__webglFramebuffer===void 0&&De.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?De.setTextureCube(R,0):R.isData3DTexture?De.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?De.setTexture2DArray(R,0):De.setTexture2D(R,0),Pe.unbindTexture()},this.resetState=function(){E=0,P=0,L=null,Pe.reset(),Le.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=xt._getDrawingBufferColorSpace(e),t.unpackColorSpace=xt._getUnpackColorSpace()}};var Lh=({x:i,y:e,z:t})=>new I(i,e,t),WS=1e-9,Ig=i=>i.joint.length?Lh(i.joint[0].path.end).length():i.length,Lg=(i,e,t=0)=>i.joint.length?Math.max(Math.abs(i.length-e),Math.abs(t)):i.length-e,Sr,Dg,Qf,ed=class ed{constructor(e){xl(this,Sr);this.free=e.length,this.along=new I(...e.direction);let[t]=e.joint;if(!t)return;Cn(this,Sr,Dg).call(this,t);let[n]=e.second;n&&(this.second=new ed({length:0,direction:e.direction,joint:[n],second:[]}),this.beyond=new I,this.inner=new sn)}get isHinge(){return this.curvature>WS}at(e,t,n=null,s=0){this.second&&s!==0?(Cn(this,Sr,Qf).call(this,e,t,this.inner),this.second.at(s,this.beyond,n),t.add(this.beyond.sub(this.start).applyQuaternion(this.inner)),n?.premultiply(this.inner)):Cn(this,Sr,Qf).call(this,e,t,n)}};Sr=new WeakSet,Dg=function(e){this.start=Lh(e.path.end),this.along=Lh(e.path.direction),this.inward=Lh(e.path.inward),this.axis=this.along.clone().cross(this.inward),this.curvature=e.path.curvature,this.anchor=new I(...e.anchor)},Qf=function(e,t,n){if(n?.identity(),!this.start){t.copy(this.along).multiplyScalar(e);return}let s=e-this.free;if(t.copy(this.start),!this.isHinge){t.addScaledVector(this.along,s);return}let r=this.curvature*s;t.addScaledVector(this.along,Math.sin(r)/this.curvature),t.addScaledVector(this.inward,(1-Math.cos(r))/this.curvature),n?.setFromAxisAngle(this.axis,r)};var Po=ed;function XS(i){let e=[];for(let n of i)for(let[s,r]of n.impacts.slice(0,12)){let o=s+n.shift-.008;e.push([o,Math.min(r,s+.12)+n.shift+.02])}e.sort((n,s)=>n[0]-s[0]);let t=[];for(let n of e){let s=t[t.length-1];s&&n[0]<s[1]+2*.12?s[1]=Math.max(s[1],n[1]):t.push([...n])}return t.map(([n,s])=>[n,s,Math.min(1,Math.max(.005,(s-n)/3))])}function td(i,e){let t=1;for(let[n,s,r]of i){let o=Math.max(n-e,e-s,0);o<.12&&(t=Math.min(t,r**((1+Math.cos(Math.PI*o/.12))/2)))}return t}function Ng(i){let e=Math.min(...i.map(l=>l.begin+l.shift)),t=Math.max(...i.map(l=>l.end+l.shift)),n=XS(i),s=new Set([e,t]);for(let l=1;l<200;l++)s.add(e+(t-e)*l/200);for(let[l,c]of n)for(let u=0;u<=60;u++)s.add(l-.12+(c-l+2*.12)*u/60),s.add(l+(c-l)*u/60),s.add(l-.12*u/60),s.add(c+.12*u/60);let r=[...s].filter(l=>l>=e&&l<=t).sort((l,c)=>l-c),o=[0];for(let l=1;l<r.length;l++){let c=Math.sqrt(td(n,r[l-1])*td(n,r[l]));o.push(o[l-1]+(r[l]-r[l-1])/c)}let a=o[o.length-1]||1;return{begin:e,end:t,stretches:n,total:a,paceAt:l=>td(n,l),watchedAt:l=>Ug(r,o,l),timeAt:l=>Ug(o,r,l)}}function Ug(i,e,t){let n=0,s=i.length-1;if(!(t>i[0]))return e[0];if(t>=i[s])return e[s];for(;s-n>1;){let r=n+s>>1;i[r]<=t?n=r:s=r}return e[n]+(e[s]-e[n])*(t-i[n])/(i[s]-i[n])}var qS="uplot",YS="u-hz",$S="u-vt",ZS="u-title",KS="u-wrap",JS="u-under",jS="u-over",QS="u-axis",Ar="u-off",e1="u-select",t1="u-cursor-x",n1="u-cursor-y",i1="u-cursor-pt",s1="u-legend",r1="u-live",o1="u-inline",a1="u-series",l1="u-marker",Fg="u-label",c1="u-value",Ja="width",ja="height";var Og="bottom",Io="left",nd="right",_d="#000",Bg=_d+"0",id="mousemove",zg="mousedown",sd="mouseup",kg="mouseenter",Hg="mouseleave",Vg="dblclick",h1="resize",u1="scroll",Gg="change",Oh="dppxchange",yd="--",Bo=typeof window<"u",cd=Bo?document:null,Do=Bo?window:null,f1=Bo?navigator:null,Tt,Dh;function hd(){let i=devicePixelRatio;Tt!=i&&(Tt=i,Dh&&fd(Gg,Dh,hd),Dh=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),Rr(Gg,Dh,hd),Do.dispatchEvent(new CustomEvent(Oh)))}function ci(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function ud(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Oi(i,e,t,n){let s=cd.createElement(i);return e!=null&&ci(s,e),t?.insertBefore(s,n),s}function _i(i,e){return Oi("div",i,e)}var Wg=new WeakMap;function ts(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Wg.get(i);r!=o&&(i.style.transform=r,Wg.set(i,r),e<0||t<0||e>n||t>s?ci(i,Ar):ud(i,Ar))}var Xg=new WeakMap;function qg(i,e,t){let n=e+t,s=Xg.get(i);n!=s&&(Xg.set(i,n),i.style.background=e,i.style.borderColor=t)}var Yg=new WeakMap;function $g(i,e,t,n){let s=e+""+t,r=Yg.get(i);s!=r&&(Yg.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var bd={passive:!0},d1={...bd,capture:!0};function Rr(i,e,t,n){e.addEventListener(i,t,n?d1:bd)}function fd(i,e,t,n){e.removeEventListener(i,t,bd)}Bo&&hd();function Bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:hi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function M0(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var w0=i=>i!=null,S0=i=>i!=null&&i>0,kh=M0(w0),p1=M0(S0);function m1(i,e,t,n=0,s=!1){let r=s?p1:kh,o=s?S0:w0;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function Hh(i,e,t,n){let s=Jg(i),r=Jg(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?bs:E0,a=s==1?hi:yi,l=r==1?yi:hi,c=a(o(fn(i))),u=l(o(fn(e))),h=Uo(t,c),f=Uo(t,u);return t==10&&(c<0&&(h=zt(h,-c)),u<0&&(f=zt(f,-u))),n||t==2?(i=h*s,e=f*r):(i=C0(i,h),e=Vh(e,f)),[i,e]}function Md(i,e,t,n){let s=Hh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var wd=.1,Zg={mode:3,pad:wd},el={pad:0,soft:null,mode:0},g1={min:el,max:el};function Bh(i,e,t,n){return Gh(t)?Kg(i,e,t):(el.pad=t,el.soft=n?0:null,el.mode=n?3:0,Kg(i,e,g1))}function wt(i,e){return i??e}function v1(i,e,t){for(e=wt(e,0),t=wt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Kg(i,e,t){let n=t.min,s=t.max,r=wt(n.pad,0),o=wt(s.pad,0),a=wt(n.hard,-Bt),l=wt(s.hard,Bt),c=wt(n.soft,Bt),u=wt(s.soft,-Bt),h=wt(n.mode,0),f=wt(s.mode,0),m=e-i,g=bs(m),v=qn(fn(i),fn(e)),p=bs(v),d=fn(p-g);(m<1e-24||d>10)&&(m=0,(i==0||e==0)&&(m=1e-24,h==2&&c!=Bt&&(r=0),f==2&&u!=-Bt&&(o=0)));let y=m||v||1e3,b=bs(y),_=Uo(10,hi(b)),C=y*(m==0?i==0?.1:1:r),E=zt(C0(i-C,_/10),24),P=i>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Bt,L=qn(a,E<P&&i>=P?P:zi(P,E)),M=y*(m==0?e==0?.1:1:o),S=zt(Vh(e+M,_/10),24),A=e<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-Bt,k=zi(l,S>A&&e<=A?A:qn(A,S));return L==k&&L==0&&(k=100),[L,k]}var x1=new Intl.NumberFormat(Bo?f1.language:"en-US"),Sd=i=>x1.format(i),ui=Math,Fh=ui.PI,fn=ui.abs,hi=ui.floor,un=ui.round,yi=ui.ceil,zi=ui.min,qn=ui.max,Uo=ui.pow,Jg=ui.sign,bs=ui.log10,E0=ui.log2,_1=(i,e=1)=>ui.sinh(i)*e,rd=(i,e=1)=>ui.asinh(i/e),Bt=1/0;function jg(i){return(bs((i^i>>31)-(i>>31))|0)+1}function dd(i,e,t){return zi(qn(i,e),t)}function T0(i){return typeof i=="function"}function vt(i){return T0(i)?i:()=>i}var y1=()=>{},A0=i=>i,R0=(i,e)=>e,b1=i=>null,Qg=i=>!0,e0=(i,e)=>i==e,M1=/\.\d*?(?=9{6,}|0{6,})/gm,Cr=i=>{if(I0(i)||Ys.has(i))return i;let e=`${i}`,t=e.match(M1);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Cr(s)}e${r}`}return zt(i,n)};function Er(i,e){return Cr(zt(Cr(i/e))*e)}function Vh(i,e){return Cr(yi(Cr(i/e))*e)}function C0(i,e){return Cr(hi(Cr(i/e))*e)}function zt(i,e=0){if(I0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return un(n)/t}var Ys=new Map;function P0(i){return((""+i).split(".")[1]||"").length}function nl(i,e,t,n){let s=[],r=n.map(P0);for(let o=e;o<t;o++){let a=fn(o),l=zt(Uo(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:zt(u,h);s.push(f),Ys.set(f,h)}}return s}var tl={},Ed=[],No=[null,null],qs=Array.isArray,I0=Number.isInteger,w1=i=>i===void 0;function t0(i){return typeof i=="string"}function Gh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function S1(i){return i!=null&&typeof i=="object"}var E1=Object.getPrototypeOf(Uint8Array),L0="__proto__";function Fo(i,e=Gh){let t;if(qs(i)){let n=i.find(s=>s!=null);if(qs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Fo(i[s],e)}else t=i.slice()}else if(i instanceof E1)t=i.slice();else if(e(i)){t={};for(let n in i)n!=L0&&(t[n]=Fo(i[n],e))}else t=i;return t}function rn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=L0&&(Gh(i[s])?rn(i[s],Fo(n[s])):i[s]=Fo(n[s]))}return i}var T1=0,A1=1,R1=2;function C1(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function P1(i,e){if(D1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return U1(o[0])||(o=L1(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:A1,m=[];for(let g=0;g<u.length;g++){let v=u[g],p=r.get(l[g]);v===null?f!=T1&&(h[p]=v,f==R1&&m.push(p)):h[p]=v}C1(h,m,s),n.push(h)}}return n}var I1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function L1(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function D1(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function U1(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=qn(1,hi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var D0=["January","February","March","April","May","June","July","August","September","October","November","December"],U0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function N0(i){return i.slice(0,3)}var N1=U0.map(N0),F1=D0.map(N0),O1={MMMM:D0,MMM:F1,WWWW:U0,WWW:N1};function Ka(i){return(i<10?"0":"")+i}function B1(i){return(i<10?"00":i<100?"0":"")+i}var z1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Ka(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Ka(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Ka(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Ka(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Ka(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>B1(i.getMilliseconds())};function Td(i,e){e=e||O1;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?z1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var k1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function H1(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==k1?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var F0=i=>i%1==0,zh=[1,2,2.5,5],V1=nl(10,-32,0,zh),O0=nl(10,0,32,zh),G1=O0.filter(F0),Tr=V1.concat(O0),Ad=`
`,B0="{YYYY}",n0=Ad+B0,z0="{M}/{D}",Qa=Ad+z0,Uh=Qa+"/{YY}",k0="{aa}",W1="{h}:{mm}",Lo=W1+k0,i0=Ad+Lo,s0=":{ss}",At=null;function H0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?nl(10,0,3,zh).filter(F0):nl(10,-3,0,zh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,B0,At,At,At,At,At,At,1],[s*28,"{MMM}",n0,At,At,At,At,At,1],[s,z0,n0,At,At,At,At,At,1],[n,"{h}"+k0,Uh,At,Qa,At,At,At,1],[t,Lo,Uh,At,Qa,At,At,At,1],[e,s0,Uh+" "+Lo,At,Qa+" "+Lo,At,i0,At,1],[i,s0+".{fff}",Uh+" "+Lo,At,Qa+" "+Lo,At,i0,At,1]];function u(h){return(f,m,g,v,p,d)=>{let y=[],b=p>=o,_=p>=r&&p<o,C=h(g),E=zt(C*i,3),P=od(C.getFullYear(),b?0:C.getMonth(),_||b?1:C.getDate()),L=zt(P*i,3);if(_||b){let M=_?p/r:0,S=b?p/o:0,A=E==L?E:zt(od(P.getFullYear()+S,P.getMonth()+M,1)*i,3),k=new Date(un(A/i)),O=k.getFullYear(),V=k.getMonth();for(let q=0;A<=v;q++){let $=od(O+S*q,V+M*q,1),N=$-h(zt($*i,3));A=zt((+$+N)*i,3),A<=v&&y.push(A)}}else{let M=p>=s?s:p,S=hi(g)-hi(E),A=L+S+Vh(E-L,M);y.push(A);let k=h(A),O=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,V=p/n,q=f.axes[m]._space,$=d/q;for(;A=zt(A+p,i==1?0:3),!(A>v);)if(V>1){let N=hi(zt(O+V,6))%24,ie=h(A).getHours()-N;ie>1&&(ie=-1),A-=ie*n,O=(O+V)%24;let ne=y[y.length-1];zt((A-ne)/p,3)*$>=.7&&y.push(A)}else y.push(A)}return y}}return[l,c,u]}var[X1,q1,Y1]=H0(1),[$1,Z1,K1]=H0(.001);nl(2,-53,53,[1]);function r0(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function o0(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,f,m;return n.map(g=>{let v=i(g),p=v.getFullYear(),d=v.getMonth(),y=v.getDate(),b=v.getHours(),_=v.getMinutes(),C=v.getSeconds(),E=p!=l&&a[2]||d!=c&&a[3]||y!=u&&a[4]||b!=h&&a[5]||_!=f&&a[6]||C!=m&&a[7]||a[1];return l=p,c=d,u=y,h=b,f=_,m=C,E(v)})}}function J1(i,e){let t=Td(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function od(i,e,t){return new Date(i,e,t)}function a0(i,e){return e(i)}var j1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function l0(i,e){return(t,n,s,r)=>r==null?yd:e(i(n))}function Q1(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function eE(i,e){return i.series[e].fill(i,e)}var tE={show:!0,live:!0,isolate:!1,mount:y1,markers:{show:!0,width:2,stroke:Q1,fill:eE,dash:"solid"},idx:null,idxs:null,values:[]};function nE(i,e){let t=i.cursor.points,n=_i(),s=t.size(i,e);Yt(n,Ja,s),Yt(n,ja,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Yt(n,"borderWidth",o),n}function iE(i,e){let t=i.series[e].points;return t._fill||t._stroke}function sE(i,e){let t=i.series[e].points;return t._stroke||t._fill}function rE(i,e){return i.series[e].points.size}var ad=[0,0];function oE(i,e,t){return ad[0]=e,ad[1]=t,ad}function Nh(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function ld(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var aE={show:!0,x:!0,y:!0,lock:!1,move:oE,points:{one:!1,show:nE,size:rE,width:0,stroke:sE,fill:iE},bind:{mousedown:Nh,mouseup:Nh,click:Nh,dblclick:Nh,mousemove:ld,mouseleave:ld,mouseenter:ld},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},V0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Rd=rn({},V0,{filter:R0}),G0=rn({},Rd,{size:10}),W0=rn({},V0,{show:!1}),Cd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',X0="bold "+Cd,q0=1.5,c0={show:!0,scale:"x",stroke:_d,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:X0,side:2,grid:Rd,ticks:G0,border:W0,font:Cd,lineGap:q0,rotate:0},lE="Value",cE="Time",h0={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function hE(i,e,t,n,s){return e.map(r=>r==null?"":Sd(r))}function uE(i,e,t,n,s,r,o){let a=[],l=Ys.get(s)||0;t=o?t:zt(Vh(t,s),l);for(let c=t;c<=n;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function pd(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?bs:E0,u=hi(c(t));s=Uo(l,u),l==10&&(s=Tr[Bi(s,Tr)]);let h=t,f=s*l;l==10&&(f=Tr[Bi(f,Tr)]);do a.push(h),h=h+s,l==10&&!Ys.has(h)&&(h=zt(h,Ys.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Tr[Bi(f,Tr)]));while(h<=n);return a}function fE(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?pd(i,e,qn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?pd(i,e,qn(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var Y0=/./,dE=/[12357]/,pE=/[125]/,u0=/1/,md=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function mE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Y0:l(7,o)-u>=c?dE:l(5,o)-u>=c?pE:u0;if(h==u0){let f=fn(l(1,o)-u);if(f<c)return md(e.slice().reverse(),a.distr,h,yi(c/f)).reverse()}return md(e,a.distr,h,1)}function gE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=fn(l(1,o)-l(2,o));return c<a?md(e.slice().reverse(),3,Y0,yi(a/c)).reverse():e}function vE(i,e,t,n){return n==null?yd:e==null?"":Sd(e)}var f0={show:!0,scale:"y",stroke:_d,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:X0,side:3,grid:Rd,ticks:G0,border:W0,font:Cd,lineGap:q0,rotate:0};function xE(i,e){let t=3+(i||1)*2;return zt(t*e,3)}function _E(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=fn(o-r),l=i.series[e],c=a/(l.points.space*Tt);return n[1]-n[0]<=c}var d0={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},$0=(i,e,t,n,s)=>s,p0={show:!0,auto:!0,sorted:0,gaps:$0,alpha:1,facets:[rn({},d0,{scale:"x"}),rn({},d0,{scale:"y"})]},m0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:$0,alpha:1,points:{show:_E,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function yE(i,e,t,n,s){return t/10}var Z0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},bE=rn({},Z0,{time:!1,ori:1}),g0={};function K0(i,e){let t=g0[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(g0[i]=t)),t}var Oo=1,gd=2;function Pr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,m=a.top,g=a.width,v=a.height,p=i.valToPosH,d=i.valToPosV;return u.ori==0?t(s,l,c,u,h,p,d,f,m,g,v,Xh,zo,Yh,j0,ev):t(s,l,c,u,h,d,p,m,f,v,g,qh,ko,Ld,Q0,tv)}function Pd(i,e){let t=0,n=0,s=wt(i.bands,Ed);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function ME(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(i,e,t,n,s,r){return Pr(i,e,(o,a,l,c,u,h,f,m,g,v,p)=>{let d=o.pxRound,y=c.dir*(c.ori==0?1:-1),b=c.ori==0?zo:ko,_,C;y==1?(_=t,C=n):(_=n,C=t);let E=d(h(a[_],c,v,m)),P=d(f(l[_],u,p,g)),L=d(h(a[C],c,v,m)),M=d(f(r==1?u.max:u.min,u,p,g)),S=new Path2D(s);return b(S,L,M),b(S,E,M),b(S,E,P),S})}function Wh(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Yh:Ld,l=t;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let m=f[0]-l;m>0&&a(o,l,n,m,n+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function wE(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Id(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let m=r(i[h]),g=f==h?m:r(i[f]),v=h-s;m=o<=0&&v>=0&&v<l?r(i[v]):m;let d=f+s;g=o>=0&&d>=0&&d<l?r(i[d]):g,g>=m&&a.push([m,g])}return a}function v0(i){return i==0?A0:i==1?un:e=>Er(e,i)}function J0(i){let e=i==0?Xh:qh,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=zi(c,a/2,l/2),u=zi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Xh=(i,e,t)=>{i.moveTo(e,t)},qh=(i,e,t)=>{i.moveTo(t,e)},zo=(i,e,t)=>{i.lineTo(e,t)},ko=(i,e,t)=>{i.lineTo(t,e)},Yh=J0(0),Ld=J0(1),j0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Q0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},ev=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},tv=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function nv(i){return(e,t,n,s,r)=>Pr(e,t,(o,a,l,c,u,h,f,m,g,v,p)=>{let{pxRound:d,points:y}=o,b,_;c.ori==0?(b=Xh,_=j0):(b=qh,_=Q0);let C=zt(y.width*Tt,3),E=(y.size-y.width)/2*Tt,P=zt(E*2,3),L=new Path2D,M=new Path2D,{left:S,top:A,width:k,height:O}=e.bbox;Yh(M,S-P,A-P,k+P*2,O+P*2);let V=q=>{if(l[q]!=null){let $=d(h(a[q],c,v,m)),N=d(f(l[q],u,p,g));b(L,$+E,N),_(L,$,N,E,0,Fh*2)}};if(r)r.forEach(V);else for(let q=n;q<=s;q++)V(q);return{stroke:C>0?L:null,fill:L,clip:M,flags:Oo|gd}})}function iv(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var SE=iv(zo),EE=iv(ko);function sv(i){let e=wt(i?.alignGaps,0);return(t,n,s,r)=>Pr(t,n,(o,a,l,c,u,h,f,m,g,v,p)=>{[s,r]=kh(l,s,r);let d=o.pxRound,y=O=>d(h(O,c,v,m)),b=O=>d(f(O,u,p,g)),_,C;c.ori==0?(_=zo,C=SE):(_=ko,C=EE);let E=c.dir*(c.ori==0?1:-1),P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Oo},L=P.stroke,M=!1;if(r-s>=v*4){let O=he=>t.posToVal(he,c.key,!0),V=null,q=null,$,N,z,Q=y(a[E==1?s:r]),ie=y(a[s]),ne=y(a[r]),ce=O(E==1?ie+1:ne-1);for(let he=E==1?s:r;he>=s&&he<=r;he+=E){let Me=a[he],te=(E==1?Me<ce:Me>ce)?Q:y(Me),K=l[he];te==Q?K!=null?(N=K,V==null?(_(L,te,b(N)),$=V=q=N):N<V?V=N:N>q&&(q=N)):K===null&&(M=!0):(V!=null&&C(L,Q,b(V),b(q),b($),b(N)),K!=null?(N=K,_(L,te,b(N)),V=q=$=N):(V=q=null,K===null&&(M=!0)),Q=te,ce=O(Q+E))}V!=null&&V!=q&&z!=Q&&C(L,Q,b(V),b(q),b($),b(N))}else for(let O=E==1?s:r;O>=s&&O<=r;O+=E){let V=l[O];V===null?M=!0:V!=null&&_(L,y(a[O]),b(V))}let[A,k]=Pd(t,n);if(o.fill!=null||A!=0){let O=P.fill=new Path2D(L),V=o.fillTo(t,n,o.min,o.max,A),q=b(V),$=y(a[s]),N=y(a[r]);E==-1&&([N,$]=[$,N]),_(O,N,q),_(O,$,q)}if(!o.spanGaps){let O=[];M&&O.push(...Id(a,l,s,r,E,y,e)),P.gaps=O=o.gaps(t,n,s,r,O),P.clip=Wh(O,c.ori,m,g,v,p)}return k!=0&&(P.band=k==2?[Ms(t,n,s,r,L,-1),Ms(t,n,s,r,L,1)]:Ms(t,n,s,r,L,k)),P})}function TE(i){let e=wt(i.align,1),t=wt(i.ascDesc,!1),n=wt(i.alignGaps,0),s=wt(i.extend,!1);return(r,o,a,l)=>Pr(r,o,(c,u,h,f,m,g,v,p,d,y,b)=>{[a,l]=kh(h,a,l);let _=c.pxRound,{left:C,width:E}=r.bbox,P=ie=>_(g(ie,f,y,p)),L=ie=>_(v(ie,m,b,d)),M=f.ori==0?zo:ko,S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Oo},A=S.stroke,k=f.dir*(f.ori==0?1:-1),O=L(h[k==1?a:l]),V=P(u[k==1?a:l]),q=V,$=V;s&&e==-1&&($=C,M(A,$,O)),M(A,V,O);for(let ie=k==1?a:l;ie>=a&&ie<=l;ie+=k){let ne=h[ie];if(ne==null)continue;let ce=P(u[ie]),he=L(ne);e==1?M(A,ce,O):M(A,q,he),M(A,ce,he),O=he,q=ce}let N=q;s&&e==1&&(N=C+E,M(A,N,O));let[z,Q]=Pd(r,o);if(c.fill!=null||z!=0){let ie=S.fill=new Path2D(A),ne=c.fillTo(r,o,c.min,c.max,z),ce=L(ne);M(ie,N,ce),M(ie,$,ce)}if(!c.spanGaps){let ie=[];ie.push(...Id(u,h,a,l,k,P,n));let ne=c.width*Tt/2,ce=t||e==1?ne:-ne,he=t||e==-1?-ne:ne;ie.forEach(Me=>{Me[0]+=ce,Me[1]+=he}),S.gaps=ie=c.gaps(r,o,a,l,ie),S.clip=Wh(ie,f.ori,p,d,y,b)}return Q!=0&&(S.band=Q==2?[Ms(r,o,a,l,A,-1),Ms(r,o,a,l,A,1)]:Ms(r,o,a,l,A,Q)),S})}function x0(i,e,t,n,s,r,o=Bt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=fn(i[l]-i[a]);u<c&&(c=u,o=fn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function AE(i){i=i||tl;let e=wt(i.size,[.6,Bt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=wt(e[1],Bt),l=wt(e[2],1),c=wt(i.disp,tl),u=wt(i.each,m=>{}),{fill:h,stroke:f}=c;return(m,g,v,p)=>Pr(m,g,(d,y,b,_,C,E,P,L,M,S,A)=>{let k=d.pxRound,O=t,V=n*Tt,q=a*Tt,$=l*Tt,N,z;_.ori==0?[N,z]=r(m,g):[z,N]=r(m,g);let Q=_.dir*(_.ori==0?1:-1),ie=_.ori==0?Yh:Ld,ne=_.ori==0?u:(G,B,W,j,pe,de,ye)=>{u(G,B,W,pe,j,ye,de)},ce=wt(m.bands,Ed).find(G=>G.series[0]==g),he=ce!=null?ce.dir:0,Me=d.fillTo(m,g,d.min,d.max,he),Ee=k(P(Me,C,A,M)),te,K,ve,_e=S,Ae=k(d.width*Tt),We=!1,ut=null,H=null,lt=null,oe=null;h!=null&&(Ae==0||f!=null)&&(We=!0,ut=h.values(m,g,v,p),H=new Map,new Set(ut).forEach(G=>{G!=null&&H.set(G,new Path2D)}),Ae>0&&(lt=f.values(m,g,v,p),oe=new Map,new Set(lt).forEach(G=>{G!=null&&oe.set(G,new Path2D)})));let{x0:we,size:Pe}=c;if(we!=null&&Pe!=null){O=1,y=we.values(m,g,v,p),we.unit==2&&(y=y.map(W=>m.posToVal(L+W*S,_.key,!0)));let G=Pe.values(m,g,v,p);Pe.unit==2?K=G[0]*S:K=E(G[0],_,S,L)-E(0,_,S,L),_e=x0(y,b,E,_,S,L,_e),ve=_e-K+V}else _e=x0(y,b,E,_,S,L,_e),ve=_e*o+V,K=_e-ve;ve<1&&(ve=0),Ae>=K/2&&(Ae=0),ve<5&&(k=A0);let at=ve>0,ae=_e-ve-(at?Ae:0);K=k(dd(ae,$,q)),te=(O==0?K/2:O==Q?0:K)-O*Q*((O==0?V/2:0)+(at?Ae/2:0));let De={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},je=We?null:new Path2D,rt=null;if(ce!=null)rt=m.data[ce.series[1]];else{let{y0:G,y1:B}=c;G!=null&&B!=null&&(b=B.values(m,g,v,p),rt=G.values(m,g,v,p))}let U=N*K,w=z*K;for(let G=Q==1?v:p;G>=v&&G<=p;G+=Q){let B=b[G];if(B==null)continue;if(rt!=null){let xe=rt[G]??0;if(B-xe==0)continue;Ee=P(xe,C,A,M)}let W=_.distr!=2||c!=null?y[G]:G,j=E(W,_,S,L),pe=P(wt(B,Me),C,A,M),de=k(j-te),ye=k(qn(pe,Ee)),fe=k(zi(pe,Ee)),ue=ye-fe;if(B!=null){let xe=B<0?w:U,Oe=B<0?U:w;We?(Ae>0&&lt[G]!=null&&ie(oe.get(lt[G]),de,fe+hi(Ae/2),K,qn(0,ue-Ae),xe,Oe),ut[G]!=null&&ie(H.get(ut[G]),de,fe+hi(Ae/2),K,qn(0,ue-Ae),xe,Oe)):ie(je,de,fe+hi(Ae/2),K,qn(0,ue-Ae),xe,Oe),ne(m,g,G,de-Ae/2,fe,K+Ae,ue)}}return Ae>0?De.stroke=We?oe:je:We||(De._fill=d.width==0?d._fill:d._stroke??d._fill,De.width=0),De.fill=We?H:je,De})}function RE(i,e){let t=wt(e?.alignGaps,0);return(n,s,r,o)=>Pr(n,s,(a,l,c,u,h,f,m,g,v,p,d)=>{[r,o]=kh(c,r,o);let y=a.pxRound,b=N=>y(f(N,u,p,g)),_=N=>y(m(N,h,d,v)),C,E,P;u.ori==0?(C=Xh,P=zo,E=ev):(C=qh,P=ko,E=tv);let L=u.dir*(u.ori==0?1:-1),M=b(l[L==1?r:o]),S=M,A=[],k=[];for(let N=L==1?r:o;N>=r&&N<=o;N+=L)if(c[N]!=null){let Q=l[N],ie=b(Q);A.push(S=ie),k.push(_(c[N]))}let O={stroke:i(A,k,C,P,E,y),fill:null,clip:null,band:null,gaps:null,flags:Oo},V=O.stroke,[q,$]=Pd(n,s);if(a.fill!=null||q!=0){let N=O.fill=new Path2D(V),z=a.fillTo(n,s,a.min,a.max,q),Q=_(z);P(N,S,Q),P(N,M,Q)}if(!a.spanGaps){let N=[];N.push(...Id(l,c,r,o,L,b,t)),O.gaps=N=a.gaps(n,s,r,o,N),O.clip=Wh(N,u.ori,g,v,p,d)}return $!=0&&(O.band=$==2?[Ms(n,s,r,o,V,-1),Ms(n,s,r,o,V,1)]:Ms(n,s,r,o,V,$)),O})}function CE(i){return RE(PE,i)}function PE(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,e[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,i[f+1],e[f+1])}return a}var vd=new Set;function _0(){for(let i of vd)i.syncRect(!0)}Bo&&(Rr(h1,Do,_0),Rr(u1,Do,_0,!0),Rr(Oh,Do,()=>{Kt.pxRatio=Tt}));var IE=sv(),LE=nv();function y0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>xd(r,o,e,t))}function DE(i,e){return i.map((t,n)=>n==0?{}:rn({},e,t))}function xd(i,e,t,n){return rn({},e==0?t:n,i)}function rv(i,e,t){return e==null?No:[e,t]}var UE=rv;function NE(i,e,t){return e==null?No:Bh(e,t,wd,!0)}function ov(i,e,t,n){return e==null?No:Hh(e,t,i.scales[n].log,!1)}var FE=ov;function av(i,e,t,n){return e==null?No:Md(e,t,i.scales[n].log,!1)}var OE=av;function BE(i,e,t,n,s){let r=qn(jg(i),jg(e)),o=e-i,a=Bi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ys.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function b0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=un((t=+s)*Tt))+"px"),[i,e,t]}function zE(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=zt(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Kt(i,e,t){let n={mode:wt(i.mode,1)},s=n.mode;function r(x,T,D,F){let Z=T.valToPct(x);return F+D*(T.dir==-1?1-Z:Z)}function o(x,T,D,F){let Z=T.valToPct(x);return F+D*(T.dir==-1?Z:1-Z)}function a(x,T,D,F){return T.ori==0?r(x,T,D,F):o(x,T,D,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=_i(qS);if(i.id!=null&&(c.id=i.id),ci(c,i.class),i.title){let x=_i(ZS,c);x.textContent=i.title}let u=Oi("canvas"),h=n.ctx=u.getContext("2d"),f=_i(KS,c);Rr("click",f,x=>{x.target===g&&(Gt!=Fr||$t!=Or)&&Mn.click(n,x)},!0);let m=n.under=_i(JS,f);f.appendChild(u);let g=n.over=_i(jS,f);i=Fo(i);let v=+wt(i.pxAlign,1),p=v0(v);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let d=i.ms||.001,y=n.series=s==1?y0(i.series||[],h0,m0,!1):DE(i.series||[null],p0),b=n.axes=y0(i.axes||[],c0,f0,!0),_=n.scales={},C=n.bands=i.bands||[];C.forEach(x=>{x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1)});let E=s==2?y[1].facets[0].scale:y[0].scale,P={axes:xx,series:Js},L=(i.drawOrder||["axes","series"]).map(x=>P[x]);function M(x){let T=x.distr==3?D=>bs(D>0?D:x.clamp(n,D,x.min,x.max,x.key)):x.distr==4?D=>rd(D,x.asinh):x.distr==100?D=>x.fwd(D):D=>D;return D=>{let F=T(D),{_min:Z,_max:se}=x,me=se-Z;return(F-Z)/me}}function S(x){let T=_[x];if(T==null){let D=(i.scales||tl)[x]||tl;if(D.from!=null){S(D.from);let F=rn({},_[D.from],D,{key:x});F.valToPct=M(F),_[x]=F}else{T=_[x]=rn({},x==E?Z0:bE,D),T.key=x;let F=T.time,Z=T.range,se=qs(Z);if((x!=E||s==2&&!F)&&(se&&(Z[0]==null||Z[1]==null)&&(Z={min:Z[0]==null?Zg:{mode:1,hard:Z[0],soft:Z[0]},max:Z[1]==null?Zg:{mode:1,hard:Z[1],soft:Z[1]}},se=!1),!se&&Gh(Z))){let me=Z;Z=(Se,Ie,ke)=>Ie==null?No:Bh(Ie,ke,me)}T.range=vt(Z||(F?UE:x==E?T.distr==3?FE:T.distr==4?OE:rv:T.distr==3?ov:T.distr==4?av:NE)),T.auto=vt(se?!1:T.auto),T.clamp=vt(T.clamp||yE),T._min=T._max=null,T.valToPct=M(T)}}}S("x"),S("y"),s==1&&y.forEach(x=>{S(x.scale)}),b.forEach(x=>{S(x.scale)});for(let x in i.scales)S(x);let A=_[E],k=A.distr,O,V;A.ori==0?(ci(c,YS),O=r,V=o):(ci(c,$S),O=o,V=r);let q={};for(let x in _){let T=_[x];(T.min!=null||T.max!=null)&&(q[x]={min:T.min,max:T.max},T.min=T.max=null)}let $=i.tzDate||(x=>new Date(un(x/d))),N=i.fmtDate||Td,z=d==1?Y1($):K1($),Q=o0($,r0(d==1?q1:Z1,N)),ie=l0($,a0(j1,N)),ne=[],ce=n.legend=rn({},tE,i.legend),he=n.cursor=rn({},aE,{drag:{y:s==2}},i.cursor),Me=ce.show,Ee=he.show,te=ce.markers;ce.idxs=ne,te.width=vt(te.width),te.dash=vt(te.dash),te.stroke=vt(te.stroke),te.fill=vt(te.fill);let K,ve,_e,Ae=[],We=[],ut,H=!1,lt={};if(ce.live){let x=y[1]?y[1].values:null;H=x!=null,ut=H?x(n,1,0):{_:0};for(let T in ut)lt[T]=yd}if(Me)if(K=Oi("table",s1,c),_e=Oi("tbody",null,K),ce.mount(n,K),H){ve=Oi("thead",null,K,_e);let x=Oi("tr",null,ve);Oi("th",null,x);for(var oe in ut)Oi("th",Fg,x).textContent=oe}else ci(K,o1),ce.live&&ci(K,r1);let we={show:!0},Pe={show:!1};function at(x,T){if(T==0&&(H||!ce.live||s==2))return No;let D=[],F=Oi("tr",a1,_e,_e.childNodes[T]);ci(F,x.class),x.show||ci(F,Ar);let Z=Oi("th",null,F);if(te.show){let Se=_i(l1,Z);if(T>0){let Ie=te.width(n,T);Ie&&(Se.style.border=Ie+"px "+te.dash(n,T)+" "+te.stroke(n,T)),Se.style.background=te.fill(n,T)}}let se=_i(Fg,Z);x.label instanceof HTMLElement?se.appendChild(x.label):se.textContent=x.label,T>0&&(te.show||(se.style.color=x.width>0?te.stroke(n,T):te.fill(n,T)),De("click",Z,Se=>{if(he._lock)return;bn(Se);let Ie=y.indexOf(x);if((Se.ctrlKey||Se.metaKey)!=ce.isolate){let ke=y.some((Ve,qe)=>qe>0&&qe!=Ie&&Ve.show);y.forEach((Ve,qe)=>{qe>0&&Gi(qe,ke?qe==Ie?we:Pe:we,!0,tn.setSeries)})}else Gi(Ie,{show:!x.show},!0,tn.setSeries)},!1),Yn&&De(kg,Z,Se=>{he._lock||(bn(Se),Gi(y.indexOf(x),zr,!0,tn.setSeries))},!1));for(var me in ut){let Se=Oi("td",c1,F);Se.textContent="--",D.push(Se)}return[F,D]}let ae=new Map;function De(x,T,D,F=!0){let Z=ae.get(T)||{},se=he.bind[x](n,T,D,F);se&&(Rr(x,T,Z[x]=se),ae.set(T,Z))}function je(x,T,D){let F=ae.get(T)||{};for(let Z in F)(x==null||Z==x)&&(fd(Z,T,F[Z]),delete F[Z]);x==null&&ae.delete(T)}let rt=0,U=0,w=0,G=0,B=0,W=0,j=B,pe=W,de=w,ye=G,fe=0,ue=0,xe=0,Oe=0;n.bbox={};let He=!1,Le=!1,Ze=!1,Y=!1,be=!1,Re=!1;function Ge(x,T,D){(D||x!=n.width||T!=n.height)&&Te(x,T),Lr(!1),Ze=!0,Le=!0,Dr()}function Te(x,T){n.width=rt=w=x,n.height=U=G=T,B=W=0,Lt(),yt();let D=n.bbox;fe=D.left=Er(B*Tt,.5),ue=D.top=Er(W*Tt,.5),xe=D.width=Er(w*Tt,.5),Oe=D.height=Er(G*Tt,.5)}let ge=3;function Be(){let x=!1,T=0;for(;!x;){T++;let D=gx(T),F=vx(T);x=T==ge||D&&F,x||(Te(n.width,n.height),Le=!0)}}function it({width:x,height:T}){Ge(x,T)}n.setSize=it;function Lt(){let x=!1,T=!1,D=!1,F=!1;b.forEach((Z,se)=>{if(Z.show&&Z._show){let{side:me,_size:Se}=Z,Ie=me%2,ke=Z.label!=null?Z.labelSize:0,Ve=Se+ke;Ve>0&&(Ie?(w-=Ve,me==3?(B+=Ve,F=!0):D=!0):(G-=Ve,me==0?(W+=Ve,x=!0):T=!0))}}),os[0]=x,os[1]=D,os[2]=T,os[3]=F,w-=Vi[1]+Vi[3],B+=Vi[3],G-=Vi[2]+Vi[0],W+=Vi[0]}function yt(){let x=B+w,T=W+G,D=B,F=W;function Z(se,me){switch(se){case 1:return x+=me,x-me;case 2:return T+=me,T-me;case 3:return D-=me,D+me;case 0:return F-=me,F+me}}b.forEach((se,me)=>{if(se.show&&se._show){let Se=se.side;se._pos=Z(Se,se._size),se.label!=null&&(se._lpos=Z(Se,se.labelSize))}})}if(he.dataIdx==null){let x=he.hover,T=x.skip=new Set(x.skip??[]);T.add(void 0);let D=x.prox=vt(x.prox),F=x.bias??(x.bias=0);he.dataIdx=(Z,se,me,Se)=>{if(se==0)return me;let Ie=me,ke=D(Z,se,me,Se)??Bt,Ve=ke>=0&&ke<Bt,qe=A.ori==0?w:G,st=he.left,St=e[0],Mt=e[se];if(T.has(Mt[me])){Ie=null;let pt=null,tt=null,$e;if(F==0||F==-1)for($e=me;pt==null&&$e-- >0;)T.has(Mt[$e])||(pt=$e);if(F==0||F==1)for($e=me;tt==null&&$e++<Mt.length;)T.has(Mt[$e])||(tt=$e);if(pt!=null||tt!=null)if(Ve){let Xt=pt==null?-1/0:O(St[pt],A,qe,0),jt=tt==null?1/0:O(St[tt],A,qe,0),_n=st-Xt,Dt=jt-st;_n<=Dt?_n<=ke&&(Ie=pt):Dt<=ke&&(Ie=tt)}else Ie=tt==null?pt:pt==null?tt:me-pt<=tt-me?pt:tt}else Ve&&fn(st-O(St[me],A,qe,0))>ke&&(Ie=null);return Ie}}let bn=x=>{he.event=x};he.idxs=ne,he._lock=!1;let Ft=he.points;Ft.show=vt(Ft.show),Ft.size=vt(Ft.size),Ft.stroke=vt(Ft.stroke),Ft.width=vt(Ft.width),Ft.fill=vt(Ft.fill);let ei=n.focus=rn({},i.focus||{alpha:.3},he.focus),Yn=ei.prox>=0,Hi=Yn&&Ft.one,Fn=[],rs=[],bi=[];function Wo(x,T){let D=Ft.show(n,T);if(D instanceof HTMLElement)return ci(D,i1),ci(D,x.class),ts(D,-10,-10,w,G),g.insertBefore(D,Fn[T]),D}function Zs(x,T){if(s==1||T>0){let D=s==1&&_[x.scale].time,F=x.value;x.value=D?t0(F)?l0($,a0(F,N)):F||ie:F||vE,x.label=x.label||(D?cE:lE)}if(Hi||T>0){x.width=x.width==null?1:x.width,x.paths=x.paths||IE||b1,x.fillTo=vt(x.fillTo||ME),x.pxAlign=+wt(x.pxAlign,v),x.pxRound=v0(x.pxAlign),x.stroke=vt(x.stroke||null),x.fill=vt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let D=xE(qn(1,x.width),1),F=x.points=rn({},{size:D,width:qn(1,D*.2),stroke:x.stroke,space:D*2,paths:LE,_stroke:null,_fill:null},x.points);F.show=vt(F.show),F.filter=vt(F.filter),F.fill=vt(F.fill),F.stroke=vt(F.stroke),F.paths=vt(F.paths),F.pxAlign=x.pxAlign}if(Me){let D=at(x,T);Ae.splice(T,0,D[0]),We.splice(T,0,D[1]),ce.values.push(null)}if(Ee){ne.splice(T,0,null);let D=null;Hi?T==0&&(D=Wo(x,T)):T>0&&(D=Wo(x,T)),Fn.splice(T,0,D),rs.splice(T,0,0),bi.splice(T,0,0)}xn("addSeries",T)}function fl(x,T){T=T??y.length,x=s==1?xd(x,T,h0,m0):xd(x,T,{},p0),y.splice(T,0,x),Zs(y[T],T)}n.addSeries=fl;function dl(x){if(y.splice(x,1),Me){ce.values.splice(x,1),We.splice(x,1);let T=Ae.splice(x,1)[0];je(null,T.firstChild),T.remove()}Ee&&(ne.splice(x,1),Fn.splice(x,1)[0].remove(),rs.splice(x,1),bi.splice(x,1)),xn("delSeries",x)}n.delSeries=dl;let os=[!1,!1,!1,!1];function cu(x,T){if(x._show=x.show,x.show){let D=x.side%2,F=_[x.scale];F==null&&(x.scale=D?y[1].scale:E,F=_[x.scale]);let Z=F.time;x.size=vt(x.size),x.space=vt(x.space),x.rotate=vt(x.rotate),qs(x.incrs)&&x.incrs.forEach(me=>{!Ys.has(me)&&Ys.set(me,P0(me))}),x.incrs=vt(x.incrs||(F.distr==2?G1:Z?d==1?X1:$1:Tr)),x.splits=vt(x.splits||(Z&&F.distr==1?z:F.distr==3?pd:F.distr==4?fE:uE)),x.stroke=vt(x.stroke),x.grid.stroke=vt(x.grid.stroke),x.ticks.stroke=vt(x.ticks.stroke),x.border.stroke=vt(x.border.stroke);let se=x.values;x.values=qs(se)&&!qs(se[0])?vt(se):Z?qs(se)?o0($,r0(se,N)):t0(se)?J1($,se):se||Q:se||hE,x.filter=vt(x.filter||(F.distr>=3&&F.log==10?mE:F.distr==3&&F.log==2?gE:R0)),x.font=b0(x.font),x.labelFont=b0(x.labelFont),x._size=x.size(n,null,T,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(os[T]=!0,x._el=_i(QS,f))}}function Ks(x,T,D,F){let[Z,se,me,Se]=D,Ie=T%2,ke=0;return Ie==0&&(Se||se)&&(ke=T==0&&!Z||T==2&&!me?un(c0.size/3):0),Ie==1&&(Z||me)&&(ke=T==1&&!se||T==3&&!Se?un(f0.size/2):0),ke}let pl=n.padding=(i.padding||[Ks,Ks,Ks,Ks]).map(x=>vt(wt(x,Ks))),Vi=n._padding=pl.map((x,T)=>x(n,T,os,0)),on,R=null,J=null,le=s==1?y[0].idxs:null,re=null,ee=!1;function Ce(x,T){if(e=x??[],n.data=n._data=e,s==2){on=0;for(let D=1;D<y.length;D++)on+=e[D][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),re=e[0],on=re.length;let D=e;if(k==2){D=e.slice();let F=D[0]=Array(on);for(let Z=0;Z<on;Z++)F[Z]=Z}n._data=e=D}if(Lr(!0),xn("setData"),k==2&&(Ze=!0),T!==!1){let D=A;D.auto(n,ee)?Ne():Ts(E,D.min,D.max),Y=Y||he.left>=0,Re=!0,Dr()}}n.setData=Ce;function Ne(){ee=!0;let x,T;s==1&&(on>0?(R=le[0]=0,J=le[1]=on-1,x=e[0][R],T=e[0][J],k==2?(x=R,T=J):x==T&&(k==3?[x,T]=Hh(x,x,A.log,!1):k==4?[x,T]=Md(x,x,A.log,!1):A.time?T=x+un(86400/d):[x,T]=Bh(x,T,wd,!0))):(R=le[0]=x=null,J=le[1]=T=null)),Ts(E,x,T)}let Xe,ze,Qe,et,Ye,ft,bt,kt,Rt,ct;function Je(x,T,D,F,Z,se){x??(x=Bg),D??(D=Ed),F??(F="butt"),Z??(Z=Bg),se??(se="round"),x!=Xe&&(h.strokeStyle=Xe=x),Z!=ze&&(h.fillStyle=ze=Z),T!=Qe&&(h.lineWidth=Qe=T),se!=Ye&&(h.lineJoin=Ye=se),F!=ft&&(h.lineCap=ft=F),D!=et&&h.setLineDash(et=D)}function Ht(x,T,D,F){T!=ze&&(h.fillStyle=ze=T),x!=bt&&(h.font=bt=x),D!=kt&&(h.textAlign=kt=D),F!=Rt&&(h.textBaseline=Rt=F)}function gt(x,T,D,F,Z=0){if(F.length>0&&x.auto(n,ee)&&(T==null||T.min==null)){let se=wt(R,0),me=wt(J,F.length-1),Se=D.min==null?m1(F,se,me,Z,x.distr==3):[D.min,D.max];x.min=zi(x.min,D.min=Se[0]),x.max=qn(x.max,D.max=Se[1])}}let Rn={min:null,max:null};function ws(){for(let F in _){let Z=_[F];q[F]==null&&(Z.min==null||q[E]!=null&&Z.auto(n,ee))&&(q[F]=Rn)}for(let F in _){let Z=_[F];q[F]==null&&Z.from!=null&&q[Z.from]!=null&&(q[F]=Rn)}q[E]!=null&&Lr(!0);let x={};for(let F in q){let Z=q[F];if(Z!=null){let se=x[F]=Fo(_[F],S1);if(Z.min!=null)rn(se,Z);else if(F!=E||s==2)if(on==0&&se.from==null){let me=se.range(n,null,null,F);se.min=me[0],se.max=me[1]}else se.min=Bt,se.max=-Bt}}if(on>0){y.forEach((F,Z)=>{if(s==1){let se=F.scale,me=q[se];if(me==null)return;let Se=x[se];if(Z==0){let Ie=Se.range(n,Se.min,Se.max,se);Se.min=Ie[0],Se.max=Ie[1],R=Bi(Se.min,e[0]),J=Bi(Se.max,e[0]),J-R>1&&(e[0][R]<Se.min&&R++,e[0][J]>Se.max&&J--),F.min=re[R],F.max=re[J]}else F.show&&F.auto&&gt(Se,me,F,e[Z],F.sorted);F.idxs[0]=R,F.idxs[1]=J}else if(Z>0&&F.show&&F.auto){let[se,me]=F.facets,Se=se.scale,Ie=me.scale,[ke,Ve]=e[Z],qe=x[Se],st=x[Ie];qe!=null&&gt(qe,q[Se],se,ke,se.sorted),st!=null&&gt(st,q[Ie],me,Ve,me.sorted),F.min=me.min,F.max=me.max}});for(let F in x){let Z=x[F],se=q[F];if(Z.from==null&&(se==null||se.min==null)){let me=Z.range(n,Z.min==Bt?null:Z.min,Z.max==-Bt?null:Z.max,F);Z.min=me[0],Z.max=me[1]}}}for(let F in x){let Z=x[F];if(Z.from!=null){let se=x[Z.from];if(se.min==null)Z.min=Z.max=null;else{let me=Z.range(n,se.min,se.max,F);Z.min=me[0],Z.max=me[1]}}}let T={},D=!1;for(let F in x){let Z=x[F],se=_[F];if(se.min!=Z.min||se.max!=Z.max){se.min=Z.min,se.max=Z.max;let me=se.distr;se._min=me==3?bs(se.min):me==4?rd(se.min,se.asinh):me==100?se.fwd(se.min):se.min,se._max=me==3?bs(se.max):me==4?rd(se.max,se.asinh):me==100?se.fwd(se.max):se.max,T[F]=D=!0}}if(D){y.forEach((F,Z)=>{s==2?Z>0&&T.y&&(F._paths=null):T[F.scale]&&(F._paths=null)});for(let F in T)Ze=!0,xn("setScale",F);Ee&&he.left>=0&&(Y=Re=!0)}for(let F in q)q[F]=null}function On(x){let T=dd(R-1,0,on-1),D=dd(J+1,0,on-1);for(;x[T]==null&&T>0;)T--;for(;x[D]==null&&D<on-1;)D++;return[T,D]}function Js(){if(on>0){let x=y.some(T=>T._focus)&&ct!=ei.alpha;x&&(h.globalAlpha=ct=ei.alpha),y.forEach((T,D)=>{if(D>0&&T.show&&(Vt(D,!1),Vt(D,!0),T._paths==null)){let F=ct;ct!=T.alpha&&(h.globalAlpha=ct=T.alpha);let Z=s==2?[0,e[D][0].length-1]:On(e[D]);T._paths=T.paths(n,D,Z[0],Z[1]),ct!=F&&(h.globalAlpha=ct=F)}}),y.forEach((T,D)=>{if(D>0&&T.show){let F=ct;ct!=T.alpha&&(h.globalAlpha=ct=T.alpha),T._paths!=null&&Bn(D,!1);{let Z=T._paths!=null?T._paths.gaps:null,se=T.points.show(n,D,R,J,Z),me=T.points.filter(n,D,se,Z);(se||me)&&(T.points._paths=T.points.paths(n,D,R,J,me),Bn(D,!0))}ct!=F&&(h.globalAlpha=ct=F),xn("drawSeries",D)}}),x&&(h.globalAlpha=ct=1)}}function Vt(x,T){let D=T?y[x].points:y[x];D._stroke=D.stroke(n,x),D._fill=D.fill(n,x)}function Bn(x,T){let D=T?y[x].points:y[x],{stroke:F,fill:Z,clip:se,flags:me,_stroke:Se=D._stroke,_fill:Ie=D._fill,_width:ke=D.width}=D._paths;ke=zt(ke*Tt,3);let Ve=null,qe=ke%2/2;T&&Ie==null&&(Ie=ke>0?"#fff":Se);let st=D.pxAlign==1&&qe>0;if(st&&h.translate(qe,qe),!T){let St=fe-ke/2,Mt=ue-ke/2,pt=xe+ke,tt=Oe+ke;Ve=new Path2D,Ve.rect(St,Mt,pt,tt)}T?mn(Se,ke,D.dash,D.cap,Ie,F,Z,me,se):$n(x,Se,ke,D.dash,D.cap,Ie,F,Z,me,Ve,se),st&&h.translate(-qe,-qe)}function $n(x,T,D,F,Z,se,me,Se,Ie,ke,Ve){let qe=!1;Ie!=0&&C.forEach((st,St)=>{if(st.series[0]==x){let Mt=y[st.series[1]],pt=e[st.series[1]],tt=(Mt._paths||tl).band;qs(tt)&&(tt=st.dir==1?tt[0]:tt[1]);let $e,Xt=null;Mt.show&&tt&&v1(pt,R,J)?(Xt=st.fill(n,St)||se,$e=Mt._paths.clip):tt=null,mn(T,D,F,Z,Xt,me,Se,Ie,ke,Ve,$e,tt),qe=!0}}),qe||mn(T,D,F,Z,se,me,Se,Ie,ke,Ve)}let pn=Oo|gd;function mn(x,T,D,F,Z,se,me,Se,Ie,ke,Ve,qe){Je(x,T,D,F,Z),(Ie||ke||qe)&&(h.save(),Ie&&h.clip(Ie),ke&&h.clip(ke)),qe?(Se&pn)==pn?(h.clip(qe),Ve&&h.clip(Ve),fi(Z,me),Ss(x,se,T)):Se&gd?(fi(Z,me),h.clip(qe),Ss(x,se,T)):Se&Oo&&(h.save(),h.clip(qe),Ve&&h.clip(Ve),fi(Z,me),h.restore(),Ss(x,se,T)):(fi(Z,me),Ss(x,se,T)),(Ie||ke||qe)&&h.restore()}function Ss(x,T,D){D>0&&(T instanceof Map?T.forEach((F,Z)=>{h.strokeStyle=Xe=Z,h.stroke(F)}):T!=null&&x&&h.stroke(T))}function fi(x,T){T instanceof Map?T.forEach((D,F)=>{h.fillStyle=ze=F,h.fill(D)}):T!=null&&x&&h.fill(T)}function mx(x,T,D,F){let Z=b[x],se;if(F<=0)se=[0,0];else{let me=Z._space=Z.space(n,x,T,D,F),Se=Z._incrs=Z.incrs(n,x,T,D,F,me);se=BE(T,D,Se,F,me)}return Z._found=se}function hu(x,T,D,F,Z,se,me,Se,Ie,ke){let Ve=me%2/2;v==1&&h.translate(Ve,Ve),Je(Se,me,Ie,ke,Se),h.beginPath();let qe,st,St,Mt,pt=Z+(F==0||F==3?-se:se);D==0?(st=Z,Mt=pt):(qe=Z,St=pt);for(let tt=0;tt<x.length;tt++)T[tt]!=null&&(D==0?qe=St=x[tt]:st=Mt=x[tt],h.moveTo(qe,st),h.lineTo(St,Mt));h.stroke(),v==1&&h.translate(-Ve,-Ve)}function gx(x){let T=!0;return b.forEach((D,F)=>{if(!D.show)return;let Z=_[D.scale];if(Z.min==null){D._show&&(T=!1,D._show=!1,Lr(!1));return}else D._show||(T=!1,D._show=!0,Lr(!1));let se=D.side,me=se%2,{min:Se,max:Ie}=Z,[ke,Ve]=mx(F,Se,Ie,me==0?w:G);if(Ve==0)return;let qe=Z.distr==2,st=D._splits=D.splits(n,F,Se,Ie,ke,Ve,qe),St=Z.distr==2?st.map($e=>re[$e]):st,Mt=Z.distr==2?re[st[1]]-re[st[0]]:ke,pt=D._values=D.values(n,D.filter(n,St,F,Ve,Mt),F,Ve,Mt);D._rotate=se==2?D.rotate(n,pt,F,Ve):0;let tt=D._size;D._size=yi(D.size(n,pt,F,x)),tt!=null&&D._size!=tt&&(T=!1)}),T}function vx(x){let T=!0;return pl.forEach((D,F)=>{let Z=D(n,F,os,x);Z!=Vi[F]&&(T=!1),Vi[F]=Z}),T}function xx(){for(let x=0;x<b.length;x++){let T=b[x];if(!T.show||!T._show)continue;let D=T.side,F=D%2,Z,se,me=T.stroke(n,x),Se=D==0||D==3?-1:1,[Ie,ke]=T._found;if(T.label!=null){let kn=T.labelGap*Se,ii=un((T._lpos+kn)*Tt);Ht(T.labelFont[0],me,"center",D==2?"top":Og),h.save(),F==1?(Z=se=0,h.translate(ii,un(ue+Oe/2)),h.rotate((D==3?-Fh:Fh)/2)):(Z=un(fe+xe/2),se=ii);let er=T0(T.label)?T.label(n,x,Ie,ke):T.label;h.fillText(er,Z,se),h.restore()}if(ke==0)continue;let Ve=_[T.scale],qe=F==0?xe:Oe,st=F==0?fe:ue,St=T._splits,Mt=Ve.distr==2?St.map(kn=>re[kn]):St,pt=Ve.distr==2?re[St[1]]-re[St[0]]:Ie,tt=T.ticks,$e=T.border,Xt=tt.show?tt.size:0,jt=un(Xt*Tt),_n=un((T.alignTo==2?T._size-Xt-T.gap:T.gap)*Tt),Dt=T._rotate*-Fh/180,Qt=p(T._pos*Tt),ti=(jt+_n)*Se,zn=Qt+ti;se=F==0?zn:0,Z=F==1?zn:0;let di=T.font[0],Mi=T.align==1?Io:T.align==2?nd:Dt>0?Io:Dt<0?nd:F==0?"center":D==3?nd:Io,Xi=Dt||F==1?"middle":D==2?"top":Og;Ht(di,me,Mi,Xi);let ni=T.font[1]*T.lineGap,pi=St.map(kn=>p(a(kn,Ve,qe,st))),wi=T._values;for(let kn=0;kn<wi.length;kn++){let ii=wi[kn];if(ii!=null){F==0?Z=pi[kn]:se=pi[kn],ii=""+ii;let er=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let Hn=0;Hn<er.length;Hn++){let dp=er[Hn];Dt?(h.save(),h.translate(Z,se+Hn*ni),h.rotate(Dt),h.fillText(dp,0,0),h.restore()):h.fillText(dp,Z,se+Hn*ni)}}}tt.show&&hu(pi,tt.filter(n,Mt,x,ke,pt),F,D,Qt,jt,zt(tt.width*Tt,3),tt.stroke(n,x),tt.dash,tt.cap);let qi=T.grid;qi.show&&hu(pi,qi.filter(n,Mt,x,ke,pt),F,F==0?2:1,F==0?ue:fe,F==0?Oe:xe,zt(qi.width*Tt,3),qi.stroke(n,x),qi.dash,qi.cap),$e.show&&hu([Qt],[1],F==0?1:0,F==0?1:2,F==1?ue:fe,F==1?Oe:xe,zt($e.width*Tt,3),$e.stroke(n,x),$e.dash,$e.cap)}xn("drawAxes")}function Lr(x){y.forEach((T,D)=>{D>0&&(T._paths=null,x&&(s==1?(T.min=null,T.max=null):T.facets.forEach(F=>{F.min=null,F.max=null})))})}let ml=!1,uu=!1,Xo=[];function _x(){uu=!1;for(let x=0;x<Xo.length;x++)xn(...Xo[x]);Xo.length=0}function Dr(){ml||(I1(Zd),ml=!0)}function yx(x,T=!1){ml=!0,uu=T,x(n),Zd(),T&&Xo.length>0&&queueMicrotask(_x)}n.batch=yx;function Zd(){if(He&&(ws(),He=!1),Ze&&(Be(),Ze=!1),Le){if(Yt(m,Io,B),Yt(m,"top",W),Yt(m,Ja,w),Yt(m,ja,G),Yt(g,Io,B),Yt(g,"top",W),Yt(g,Ja,w),Yt(g,ja,G),Yt(f,Ja,rt),Yt(f,ja,U),u.width=un(rt*Tt),u.height=un(U*Tt),b.forEach(({_el:x,_show:T,_size:D,_pos:F,side:Z})=>{if(x!=null)if(T){let se=Z===3||Z===0?D:0,me=Z%2==1;Yt(x,me?"left":"top",F-se),Yt(x,me?"width":"height",D),Yt(x,me?"top":"left",me?W:B),Yt(x,me?"height":"width",me?G:w),ud(x,Ar)}else ci(x,Ar)}),Xe=ze=Qe=Ye=ft=bt=kt=Rt=et=null,ct=1,$o(!0),B!=j||W!=pe||w!=de||G!=ye){Lr(!1);let x=w/de,T=G/ye;if(Ee&&!Y&&he.left>=0){he.left*=x,he.top*=T,Ur&&ts(Ur,un(he.left),0,w,G),Nr&&ts(Nr,0,un(he.top),w,G);for(let D=0;D<Fn.length;D++){let F=Fn[D];F!=null&&(rs[D]*=x,bi[D]*=T,ts(F,yi(rs[D]),yi(bi[D]),w,G))}}if(Wt.show&&!be&&Wt.left>=0&&Wt.width>0){Wt.left*=x,Wt.width*=x,Wt.top*=T,Wt.height*=T;for(let D in vu)Yt(Br,D,Wt[D])}j=B,pe=W,de=w,ye=G}xn("setSize"),Le=!1}rt>0&&U>0&&(h.clearRect(0,0,u.width,u.height),xn("drawClear"),L.forEach(x=>x()),xn("draw")),Wt.show&&be&&(gl(Wt),be=!1),Ee&&Y&&(Qs(null,!0,!1),Y=!1),ce.show&&ce.live&&Re&&(mu(),Re=!1),l||(l=!0,n.status=1,xn("ready")),ee=!1,ml=!1}n.redraw=(x,T)=>{Ze=T||!1,x!==!1?Ts(E,A.min,A.max):Dr()};function fu(x,T){let D=_[x];if(D.from==null){if(on==0){let F=D.range(n,T.min,T.max,x);T.min=F[0],T.max=F[1]}if(T.min>T.max){let F=T.min;T.min=T.max,T.max=F}if(on>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;x==E&&D.distr==2&&on>0&&(T.min=Bi(T.min,e[0]),T.max=Bi(T.max,e[0]),T.min==T.max&&T.max++),q[x]=T,He=!0,Dr()}}n.setScale=fu;let du,pu,Ur,Nr,Kd,Jd,Fr,Or,jd,Qd,Gt,$t,Es=!1,Mn=he.drag,gn=Mn.x,vn=Mn.y;Ee&&(he.x&&(du=_i(t1,g)),he.y&&(pu=_i(n1,g)),A.ori==0?(Ur=du,Nr=pu):(Ur=pu,Nr=du),Gt=he.left,$t=he.top);let Wt=n.select=rn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Br=Wt.show?_i(e1,Wt.over?g:m):null;function gl(x,T){if(Wt.show){for(let D in x)Wt[D]=x[D],D in vu&&Yt(Br,D,x[D]);T!==!1&&xn("setSelect")}}n.setSelect=gl;function bx(x){if(y[x].show)Me&&ud(Ae[x],Ar);else if(Me&&ci(Ae[x],Ar),Ee){let D=Hi?Fn[0]:Fn[x];D!=null&&ts(D,-10,-10,w,G)}}function Ts(x,T,D){fu(x,{min:T,max:D})}function Gi(x,T,D,F){T.focus!=null&&Tx(x),T.show!=null&&y.forEach((Z,se)=>{se>0&&(x==se||x==null)&&(Z.show=T.show,bx(se),s==2?(Ts(Z.facets[0].scale,null,null),Ts(Z.facets[1].scale,null,null)):Ts(Z.scale,null,null),Dr())}),D!==!1&&xn("setSeries",x,T),F&&Zo("setSeries",n,x,T)}n.setSeries=Gi;function Mx(x,T){rn(C[x],T)}function wx(x,T){x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1),T=T??C.length,C.splice(T,0,x)}function Sx(x){x==null?C.length=0:C.splice(x,1)}n.addBand=wx,n.setBand=Mx,n.delBand=Sx;function Ex(x,T){y[x].alpha=T,Ee&&Fn[x]!=null&&(Fn[x].style.opacity=T),Me&&Ae[x]&&(Ae[x].style.opacity=T)}let as,As,js,zr={focus:!0};function Tx(x){if(x!=js){let T=x==null,D=ei.alpha!=1;y.forEach((F,Z)=>{if(s==1||Z>0){let se=T||Z==0||Z==x;F._focus=T?null:se,D&&Ex(Z,se?1:ei.alpha)}}),js=x,D&&Dr()}}Me&&Yn&&De(Hg,K,x=>{he._lock||(bn(x),js!=null&&Gi(null,zr,!0,tn.setSeries))});function Wi(x,T,D){let F=_[T];D&&(x=x/Tt-(F.ori==1?W:B));let Z=w;F.ori==1&&(Z=G,x=Z-x),F.dir==-1&&(x=Z-x);let se=F._min,me=F._max,Se=x/Z,Ie=se+(me-se)*Se,ke=F.distr;return ke==3?Uo(10,Ie):ke==4?_1(Ie,F.asinh):ke==100?F.bwd(Ie):Ie}function Ax(x,T){let D=Wi(x,E,T);return Bi(D,e[0],R,J)}n.valToIdx=x=>Bi(x,e[0]),n.posToIdx=Ax,n.posToVal=Wi,n.valToPos=(x,T,D)=>_[T].ori==0?r(x,_[T],D?xe:w,D?fe:0):o(x,_[T],D?Oe:G,D?ue:0),n.setCursor=(x,T,D)=>{Gt=x.left,$t=x.top,Qs(null,T,D)};function ep(x,T){Yt(Br,Io,Wt.left=x),Yt(Br,Ja,Wt.width=T)}function tp(x,T){Yt(Br,"top",Wt.top=x),Yt(Br,ja,Wt.height=T)}let qo=A.ori==0?ep:tp,Yo=A.ori==1?ep:tp;function Rx(){if(Me&&ce.live)for(let x=s==2?1:0;x<y.length;x++){if(x==0&&H)continue;let T=ce.values[x],D=0;for(let F in T)We[x][D++].firstChild.nodeValue=T[F]}}function mu(x,T){if(x!=null&&(x.idxs?x.idxs.forEach((D,F)=>{ne[F]=D}):w1(x.idx)||ne.fill(x.idx),ce.idx=ne[0]),Me&&ce.live){for(let D=0;D<y.length;D++)(D>0||s==1&&!H)&&Cx(D,ne[D]);Rx()}Re=!1,T!==!1&&xn("setLegend")}n.setLegend=mu;function Cx(x,T){let D=y[x],F=x==0&&k==2?re:e[x],Z;H?Z=D.values(n,x,T)??lt:(Z=D.value(n,T==null?null:F[T],x,T),Z=Z==null?lt:{_:Z}),ce.values[x]=Z}function Qs(x,T,D){jd=Gt,Qd=$t,[Gt,$t]=he.move(n,Gt,$t),he.left=Gt,he.top=$t,Ee&&(Ur&&ts(Ur,un(Gt),0,w,G),Nr&&ts(Nr,0,un($t),w,G));let F,Z=R>J;as=Bt,As=null;let se=A.ori==0?w:G,me=A.ori==1?w:G;if(Gt<0||on==0||Z){F=he.idx=null;for(let Se=0;Se<y.length;Se++){let Ie=Fn[Se];Ie!=null&&ts(Ie,-10,-10,w,G)}Yn&&Gi(null,zr,!0,x==null&&tn.setSeries),ce.live&&(ne.fill(F),Re=!0)}else{let Se,Ie,ke;s==1&&(Se=A.ori==0?Gt:$t,Ie=Wi(Se,E),F=he.idx=Bi(Ie,e[0],R,J),ke=O(e[0][F],A,se,0));let Ve=-10,qe=-10,st=0,St=0,Mt=!0,pt="",tt="";for(let $e=s==2?1:0;$e<y.length;$e++){let Xt=y[$e],jt=ne[$e],_n=jt==null?null:s==1?e[$e][jt]:e[$e][1][jt],Dt=he.dataIdx(n,$e,F,Ie),Qt=Dt==null?null:s==1?e[$e][Dt]:e[$e][1][Dt];if(Re=Re||Qt!=_n||Dt!=jt,ne[$e]=Dt,$e>0&&Xt.show){let ti=Dt==null?-10:Dt==F?ke:O(s==1?e[0][Dt]:e[$e][0][Dt],A,se,0),zn=Qt==null?-10:V(Qt,s==1?_[Xt.scale]:_[Xt.facets[1].scale],me,0);if(Yn&&Qt!=null){let di=A.ori==1?Gt:$t,Mi=fn(ei.dist(n,$e,Dt,zn,di));if(Mi<as){let Xi=ei.bias;if(Xi!=0){let ni=Wi(di,Xt.scale),pi=Qt>=0?1:-1,wi=ni>=0?1:-1;wi==pi&&(wi==1?Xi==1?Qt>=ni:Qt<=ni:Xi==1?Qt<=ni:Qt>=ni)&&(as=Mi,As=$e)}else as=Mi,As=$e}}if(Re||Hi){let di,Mi;A.ori==0?(di=ti,Mi=zn):(di=zn,Mi=ti);let Xi,ni,pi,wi,qi,kn,ii=!0,er=Ft.bbox;if(er!=null){ii=!1;let Hn=er(n,$e);pi=Hn.left,wi=Hn.top,Xi=Hn.width,ni=Hn.height}else pi=di,wi=Mi,Xi=ni=Ft.size(n,$e);if(kn=Ft.fill(n,$e),qi=Ft.stroke(n,$e),Hi)$e==As&&as<=ei.prox&&(Ve=pi,qe=wi,st=Xi,St=ni,Mt=ii,pt=kn,tt=qi);else{let Hn=Fn[$e];Hn!=null&&(rs[$e]=pi,bi[$e]=wi,$g(Hn,Xi,ni,ii),qg(Hn,kn,qi),ts(Hn,yi(pi),yi(wi),w,G))}}}}if(Hi){let $e=ei.prox,Xt=js==null?as<=$e:as>$e||As!=js;if(Re||Xt){let jt=Fn[0];jt!=null&&(rs[0]=Ve,bi[0]=qe,$g(jt,st,St,Mt),qg(jt,pt,tt),ts(jt,yi(Ve),yi(qe),w,G))}}}if(Wt.show&&Es)if(x!=null){let[Se,Ie]=tn.scales,[ke,Ve]=tn.match,[qe,st]=x.cursor.sync.scales,St=x.cursor.drag;if(gn=St._x,vn=St._y,gn||vn){let{left:Mt,top:pt,width:tt,height:$e}=x.select,Xt=x.scales[qe].ori,jt=x.posToVal,_n,Dt,Qt,ti,zn,di=Se!=null&&ke(Se,qe),Mi=Ie!=null&&Ve(Ie,st);di&&gn?(Xt==0?(_n=Mt,Dt=tt):(_n=pt,Dt=$e),Qt=_[Se],ti=O(jt(_n,qe),Qt,se,0),zn=O(jt(_n+Dt,qe),Qt,se,0),qo(zi(ti,zn),fn(zn-ti))):qo(0,se),Mi&&vn?(Xt==1?(_n=Mt,Dt=tt):(_n=pt,Dt=$e),Qt=_[Ie],ti=V(jt(_n,st),Qt,me,0),zn=V(jt(_n+Dt,st),Qt,me,0),Yo(zi(ti,zn),fn(zn-ti))):Yo(0,me)}else xu()}else{let Se=fn(jd-Kd),Ie=fn(Qd-Jd);if(A.ori==1){let st=Se;Se=Ie,Ie=st}gn=Mn.x&&Se>=Mn.dist,vn=Mn.y&&Ie>=Mn.dist;let ke=Mn.uni;ke!=null?gn&&vn&&(gn=Se>=ke,vn=Ie>=ke,!gn&&!vn&&(Ie>Se?vn=!0:gn=!0)):Mn.x&&Mn.y&&(gn||vn)&&(gn=vn=!0);let Ve,qe;gn&&(A.ori==0?(Ve=Fr,qe=Gt):(Ve=Or,qe=$t),qo(zi(Ve,qe),fn(qe-Ve)),vn||Yo(0,me)),vn&&(A.ori==1?(Ve=Fr,qe=Gt):(Ve=Or,qe=$t),Yo(zi(Ve,qe),fn(qe-Ve)),gn||qo(0,se)),!gn&&!vn&&(qo(0,0),Yo(0,0))}if(Mn._x=gn,Mn._y=vn,x==null){if(D){if(fp!=null){let[Se,Ie]=tn.scales;tn.values[0]=Se!=null?Wi(A.ori==0?Gt:$t,Se):null,tn.values[1]=Ie!=null?Wi(A.ori==1?Gt:$t,Ie):null}Zo(id,n,Gt,$t,w,G,F)}if(Yn){let Se=D&&tn.setSeries,Ie=ei.prox;js==null?as<=Ie&&Gi(As,zr,!0,Se):as>Ie?Gi(null,zr,!0,Se):As!=js&&Gi(As,zr,!0,Se)}}Re&&(ce.idx=F,mu()),T!==!1&&xn("setCursor")}let Rs=null;Object.defineProperty(n,"rect",{get(){return Rs==null&&$o(!1),Rs}});function $o(x=!1){x?Rs=null:(Rs=g.getBoundingClientRect(),xn("syncRect",Rs))}function np(x,T,D,F,Z,se,me){he._lock||Es&&x!=null&&x.movementX==0&&x.movementY==0||(gu(x,T,D,F,Z,se,me,!1,x!=null),x!=null?Qs(null,!0,!0):Qs(T,!0,!1))}function gu(x,T,D,F,Z,se,me,Se,Ie){if(Rs==null&&$o(!1),bn(x),x!=null)D=x.clientX-Rs.left,F=x.clientY-Rs.top;else{if(D<0||F<0){Gt=-10,$t=-10;return}let[ke,Ve]=tn.scales,qe=T.cursor.sync,[st,St]=qe.values,[Mt,pt]=qe.scales,[tt,$e]=tn.match,Xt=T.axes[0].side%2==1,jt=A.ori==0?w:G,_n=A.ori==1?w:G,Dt=Xt?se:Z,Qt=Xt?Z:se,ti=Xt?F:D,zn=Xt?D:F;if(Mt!=null?D=tt(ke,Mt)?a(st,_[ke],jt,0):-10:D=jt*(ti/Dt),pt!=null?F=$e(Ve,pt)?a(St,_[Ve],_n,0):-10:F=_n*(zn/Qt),A.ori==1){let di=D;D=F,F=di}}Ie&&(T==null||T.cursor.event.type==id)&&((D<=1||D>=w-1)&&(D=Er(D,w)),(F<=1||F>=G-1)&&(F=Er(F,G))),Se?(Kd=D,Jd=F,[Fr,Or]=he.move(n,D,F)):(Gt=D,$t=F)}let vu={width:0,height:0,left:0,top:0};function xu(){gl(vu,!1)}let ip,sp,rp,op;function ap(x,T,D,F,Z,se,me){Es=!0,gn=vn=Mn._x=Mn._y=!1,gu(x,T,D,F,Z,se,me,!0,!1),x!=null&&(De(sd,cd,lp,!1),Zo(zg,n,Fr,Or,w,G,null));let{left:Se,top:Ie,width:ke,height:Ve}=Wt;ip=Se,sp=Ie,rp=ke,op=Ve}function lp(x,T,D,F,Z,se,me){Es=Mn._x=Mn._y=!1,gu(x,T,D,F,Z,se,me,!1,!0);let{left:Se,top:Ie,width:ke,height:Ve}=Wt,qe=ke>0||Ve>0,st=ip!=Se||sp!=Ie||rp!=ke||op!=Ve;if(qe&&st&&gl(Wt),Mn.setScale&&qe&&st){let St=Se,Mt=ke,pt=Ie,tt=Ve;if(A.ori==1&&(St=Ie,Mt=Ve,pt=Se,tt=ke),gn&&Ts(E,Wi(St,E),Wi(St+Mt,E)),vn)for(let $e in _){let Xt=_[$e];$e!=E&&Xt.from==null&&Xt.min!=Bt&&Ts($e,Wi(pt+tt,$e),Wi(pt,$e))}xu()}else he.lock&&(he._lock=!he._lock,Qs(T,!0,x!=null));x!=null&&(je(sd,cd),Zo(sd,n,Gt,$t,w,G,null))}function Px(x,T,D,F,Z,se,me){if(he._lock)return;bn(x);let Se=Es;if(Es){let Ie=!0,ke=!0,Ve=10,qe,st;A.ori==0?(qe=gn,st=vn):(qe=vn,st=gn),qe&&st&&(Ie=Gt<=Ve||Gt>=w-Ve,ke=$t<=Ve||$t>=G-Ve),qe&&Ie&&(Gt=Gt<Fr?0:w),st&&ke&&($t=$t<Or?0:G),Qs(null,!0,!0),Es=!1}Gt=-10,$t=-10,ne.fill(null),Qs(null,!0,!0),Se&&(Es=Se)}function cp(x,T,D,F,Z,se,me){he._lock||(bn(x),Ne(),xu(),x!=null&&Zo(Vg,n,Gt,$t,w,G,null))}function hp(){b.forEach(zE),Ge(n.width,n.height,!0)}Rr(Oh,Do,hp);let kr={};kr.mousedown=ap,kr.mousemove=np,kr.mouseup=lp,kr.dblclick=cp,kr.setSeries=(x,T,D,F)=>{let Z=tn.match[2];D=Z(n,T,D),D!=-1&&Gi(D,F,!0,!1)},Ee&&(De(zg,g,ap),De(id,g,np),De(kg,g,x=>{bn(x),$o(!1)}),De(Hg,g,Px),De(Vg,g,cp),vd.add(n),n.syncRect=$o);let vl=n.hooks=i.hooks||{};function xn(x,T,D){uu?Xo.push([x,T,D]):x in vl&&vl[x].forEach(F=>{F.call(null,n,T,D)})}(i.plugins||[]).forEach(x=>{for(let T in x.hooks)vl[T]=(vl[T]||[]).concat(x.hooks[T])});let up=(x,T,D)=>D,tn=rn({key:null,setSeries:!1,filters:{pub:Qg,sub:Qg},scales:[E,y[1]?y[1].scale:null],match:[e0,e0,up],values:[null,null]},he.sync);tn.match.length==2&&tn.match.push(up),he.sync=tn;let fp=tn.key,_u=K0(fp);function Zo(x,T,D,F,Z,se,me){tn.filters.pub(x,T,D,F,Z,se,me)&&_u.pub(x,T,D,F,Z,se,me)}_u.sub(n);function Ix(x,T,D,F,Z,se,me){tn.filters.sub(x,T,D,F,Z,se,me)&&kr[x](null,T,D,F,Z,se,me)}n.pub=Ix;function Lx(){_u.unsub(n),vd.delete(n),ae.clear(),fd(Oh,Do,hp),c.remove(),K?.remove(),xn("destroy")}n.destroy=Lx;function yu(){xn("init",i,e),Ce(e||i.data,!1),q[E]?fu(E,q[E]):Ne(),be=Wt.show&&(Wt.width>0||Wt.height>0),Y=Re=!0,Ge(i.width,i.height)}return y.forEach(Zs),b.forEach(cu),t?t instanceof HTMLElement?(t.appendChild(c),yu()):t(n,yu):yu(),n}Kt.assign=rn;Kt.fmtNum=Sd;Kt.rangeNum=Bh;Kt.rangeLog=Hh;Kt.rangeAsinh=Md;Kt.orient=Pr;Kt.pxRatio=Tt;Kt.join=P1;Kt.fmtDate=Td,Kt.tzDate=H1;Kt.sync=K0;{Kt.addGap=wE,Kt.clipGaps=Wh;let i=Kt.paths={points:nv};i.linear=sv,i.stepped=TE,i.bars=AE,i.spline=CE}var lv=112,kE=18,HE=54,VE=1e-5,cv=.1,GE=100,Dd=[1e-6,1e6],Ud=14,uv=i=>{let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)},WE=.005,XE=5;function qE(i,[e,t]){let n=r=>Math.floor(Math.log10(r||1)),s=Math.max(0,Math.min(Math.round(-Math.log10(WE*(t-e||1))),XE-1-n(Math.max(Math.abs(e),Math.abs(t)))));return s>6||Math.abs(i)>=1e6?i===0?"0":i.toExponential(3):i.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1")}function fv(i,{onSeek:e=()=>{},onZoom:t=()=>{},onEdit:n=()=>{},onRemove:s=()=>{}}={}){let r=[],o=[],a=null,l={range:null,heights:{}},c=[],u=0,h=null;i.classList.add("plots");function f(A){a=A&&[...new Map(A.map(k=>[String(k),k])).values()],m(o)}function m(A){o=A,r.forEach(({plot:V})=>V.destroy()),i.replaceChildren();let k=Pn(),O=a??nr(o);r=Lp(o,O).map(V=>{let q=X("div",{class:"plot-keys"}),$=V.curves.map(he=>{let Me=document.createElementNS("http://www.w3.org/2000/svg","svg");Me.setAttribute("viewBox","0 0 22 6"),Me.setAttribute("aria-hidden","true");let Ee=document.createElementNS("http://www.w3.org/2000/svg","line");Object.entries({x1:0,x2:22,y1:3,y2:3,stroke:he.colour,"stroke-width":2.4,"stroke-dasharray":he.dash.join(" ")}).forEach(([K,ve])=>Ee.setAttribute(K,ve)),Me.append(Ee);let te=X("b");return te.style.setProperty("--colour",he.colour),q.append(X("span",{class:"plot-key"},Me,X("span",{},he.name),te)),te}),N=V.unit?`${V.name} [${V.unit}]`:V.name,z=O.findIndex(he=>V.key===(Array.isArray(he)?he.join():he)),Q=(he,Me,Ee)=>X("button",{type:"button",class:"small",title:Me,"aria-label":`${Me}: ${N}`,onclick:Ee},he),ie=X("span",{class:"plot-tools"},...V.own?[Q("edit","Change the signals",()=>n(z))]:[],Q("×","Remove this plot",()=>s(z))),ne=X("div",{class:"plot-canvas"});i.append(X("section",{class:"plot"},X("header",{},X("h3",{},N),ie,q),ne));let ce={panel:V,values:$,canvas:ne,marker:X("div",{class:"plot-now"}),cross:X("div",{class:"plot-under",hidden:!0}),flag:X("div",{class:"plot-flag",hidden:!0})};return ce.plot=g(ce,k),ce.plot.over.append(ce.marker,ce.cross,ce.flag),ce}),b()}function g({panel:A,canvas:k},O){let V=new Map;for(let K of A.curves){let ve=V.get(K.t)??{times:Array.from(K.t,_e=>_e+K.flight.shift),curves:[]};V.set(K.t,{...ve,curves:[...ve.curves,K]})}let q=[...V.values()],$=q.map(({times:K,curves:ve})=>[K,...ve.map(_e=>Array.from(_e.values))]),N=$.length===1?$[0]:Kt.join($),z=q.flatMap(({curves:K})=>K),Q={stroke:O.faint,grid:{stroke:O.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ie=YE(o.flatMap(K=>K.impacts.map(([ve,_e])=>[ve+K.shift,_e+K.shift]))),ne=Kt.paths.stepped({align:1}),ce=A.words&&((K,ve)=>ve.map(_e=>A.words[_e]??"")),he={width:Math.max(k.clientWidth,200),height:lv,padding:[6,20,0,0],legend:{show:!1},scales:{x:{time:!1},y:{range:(K,ve,_e)=>l.heights[A.key]??$E(ve,_e)}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!0,y:!0,uni:Ud,setScale:!1},bind:{dblclick:()=>()=>d()}},axes:[{...Q,size:22,gap:2,space:56,values:(K,ve)=>ve.map(_e=>KE(_e,ve))},{...Q,size:(K,ve)=>Math.max(HE,7*Math.max(0,...(ve??[]).map(_e=>_e.length))+8),gap:4,space:ce?13:kE,values:ce||((K,ve)=>ZE(ve))}],series:[{},...z.map(K=>({stroke:K.colour,width:1.7,dash:K.dash,spanGaps:!0,points:{show:!1},...K.held?{paths:ne}:{}}))],hooks:{drawClear:[K=>{K.ctx.fillStyle=O.force+"2e";for(let[ve,_e]of ie){let Ae=K.valToPos(Math.max(ve,K.scales.x.min),"x",!0),We=K.valToPos(Math.min(_e,K.scales.x.max),"x",!0);We>Ae&&K.ctx.fillRect(Ae,K.bbox.top,Math.max(We-Ae,1),K.bbox.height)}}],setSelect:[K=>v(K,A.key)],draw:[K=>r.filter(ve=>ve.plot===K).forEach(L)]}},Me=new Kt(he,N,k),Ee=null;Me.over.addEventListener("pointerdown",K=>Ee=[K.clientX,K.clientY]),Me.over.addEventListener("pointerup",K=>{Ee&&Math.hypot(K.clientX-Ee[0],K.clientY-Ee[1])<5&&e(te(K)),Ee=null}),Me.over.addEventListener("pointercancel",()=>Ee=null),Me.over.addEventListener("pointermove",K=>K.pointerType!=="touch"&&C(te(K),Me)),Me.over.addEventListener("pointerleave",()=>C(null));let te=K=>Me.posToVal(K.clientX-Me.over.getBoundingClientRect().left,"x");return Me}function v(A,k){let{left:O,top:V,width:q,height:$}=A.select,N=q>=Ud&&q<A.over.clientWidth-1,z=$>=Ud&&$<A.over.clientHeight-1;if(q+$<=0||!(N||z))return;let Q=N?[A.posToVal(O,"x"),A.posToVal(O+q,"x")]:l.range,ie=z?{[k]:[A.posToVal(V+$,"y"),A.posToVal(V,"y")]}:{};A.setSelect({left:0,top:0,width:0,height:0},!1),p({range:Q,heights:{...l.heights,...ie}})}function p(A){JSON.stringify(A)===JSON.stringify(l)||!hv(A.range)||(c=[...c,l].slice(-GE),l=A,b(),t())}function d(A,k){p({range:A===void 0?null:[A,k],heights:{}})}function y(){return c.length?(l=c.pop(),b(),t(),!0):!1}function b(){let A=o.length?[Math.min(...o.map(V=>V.begin+V.shift)),Math.max(...o.map(V=>V.end+V.shift))]:[0,1],[k,O]=l.range??A;r.forEach(({plot:V})=>V.setScale("x",{min:k,max:O})),E(u)}function _({plot:A,marker:k,cross:O}){let{min:V,max:q}=A.scales.x;for(let[$,N]of[[k,u],[O,h]])$.hidden=N===null||!(N>=V&&N<=q),$.hidden||($.style.transform=`translateX(${A.valToPos(N,"x")}px)`)}function C(A,k){h=A;for(let O of r){if(O.flag.hidden=A===null||O.plot!==k,O.flag.hidden)continue;O.flag.textContent=`${A.toFixed(4)} s`;let V=k.valToPos(A,"x");O.flag.classList.toggle("left",V>.7*k.over.clientWidth),O.flag.style.transform=`translateX(${V}px)`}i.classList.toggle("pointing",A!==null),P()}function E(A){u=A,P()}let P=()=>r.forEach(L);function L(A){let{panel:k,plot:O,values:V}=A,q=[O.scales.y.min??0,O.scales.y.max??1];_(A),k.curves.forEach(($,N)=>{let z=Qo($,h??u);V[N].textContent=k.words?.[Math.round(z)]??qE(z,q)})}function M(){r.forEach(({plot:A,canvas:k})=>{let O=k.clientWidth;O&&Math.abs(O-A.width)>1&&A.setSize({width:O,height:lv})}),E(u)}let S=new ResizeObserver(M);return S.observe(i),{replace:m,choose:f,show:E,zoom:d,back:y,resize:M,restore(A){hv(A.range)&&(l=A,b(),t())},get wanted(){return a??nr(o)},get range(){return l.range},get zoomed(){return l},get canGoBack(){return c.length>0},shown:()=>r.map(({panel:A,plot:k,values:O})=>({name:A.name,unit:A.unit,limits:[k.scales.y.min,k.scales.y.max],ticks:[...k.axes[1]._values??[]],values:Object.fromEntries(A.curves.map((V,q)=>[V.name,O[q].textContent]))})),dispose(){S.disconnect(),r.forEach(({plot:A})=>A.destroy()),i.replaceChildren()}}}function hv(i){if(i===null)return!0;let[e,t]=i;return t-e>=Dd[0]&&t-e<=Dd[1]&&Math.abs(e)<=Dd[1]}function YE(i){let e=[];for(let[t,n]of i.sort((s,r)=>s[0]-r[0])){let s=e[e.length-1];s&&t<=s[1]?s[1]=Math.max(s[1],n):e.push([t,n])}return e}function $E(i,e){if(i==null||e==null)return[0,1];let t=Math.max(Math.abs(i),Math.abs(e));if(t===0)return[-.1,1];e-i<VE*t&&([i,e]=[i-cv*t,e+cv*t]);let n=Math.max(e-i,.001*Math.max(Math.abs(i),Math.abs(e)),1e-6);return[i-.06*n,e+.08*n]}function ZE(i){let e=i.length>1?Math.abs(i[1]-i[0]):Math.abs(i[0]),t=Math.floor(Math.log10(e||1)+1e-9),n=Math.max(...i.map(Math.abs));if(t<-6||n>=1e6)return i.map(r=>r===0?"0":r.toExponential(2));let s=Math.max(0,-t);return Math.abs(e*10**s-Math.round(e*10**s))>1e-6&&s++,i.map(r=>r.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1"))}function KE(i,e){let t=0,n=.001*(e.length>1?e[1]-e[0]:1);for(;t<6&&e.some(s=>Math.abs(s-Number(s.toFixed(t)))>n);)t++;return`${i.toFixed(t)} s`}var il=[1,2,5,10,20,50,100,200],JE=.25,dv=2,pv=i=>!i.arms.some(e=>e.compliant),jE=i=>{if(i>.995)return"real time";let e=1/i;return`1/${e<10?e.toFixed(1).replace(/\.0$/,""):Math.round(e)} of real time`};function $h({scene:i,plots:e=null,bar:t,readouts:n=null,actions:s={},onRest:r=()=>{}}){let o={t:0,playing:!1,pace:"auto",line:null,flights:[],last:0},a=X("button",{class:"play",type:"button",onclick:()=>o.playing?C():_()}),l=X("button",{type:"button",title:"One instant back (←)","aria-label":"One instant back",onclick:()=>M(-1)},Yi("back")),c=X("button",{type:"button",title:"One instant forward (→)","aria-label":"One instant forward",onclick:()=>M(1)},Yi("forth")),u=X("button",{type:"button",title:"Go to the first touch (T)","aria-label":"Go to the first touch",onclick:S},Yi("touch")),h=X("select",{"aria-label":"Speed",title:"Speed (, and .)",onchange:()=>P(h.value)},X("option",{value:"auto"},"slow at impact"),...il.map(N=>X("option",{value:String(N)},N===1?"real time":`1/${N}`))),f=X("output",{class:"clock","aria-live":"off"}),m=X("input",{type:"range",min:0,max:1,step:"any",value:0,"aria-label":"Time",oninput:()=>{C(),d(o.line.timeAt(Number(m.value)*o.line.total))}}),g=X("div",{class:"ticks","aria-hidden":"true"}),v=X("div",{class:"track"},g,m),p=X("div",{class:"events"});t.classList.add("player"),t.replaceChildren(X("div",{class:"buttons"},a,l,c,u,h,f),v,p);function d(N){if(!o.line)return;o.t=Math.min(Math.max(N,o.line.begin),o.line.end),i.show(o.t),e?.show(o.t);let z=o.line.watchedAt(o.t)/o.line.total;m.value=z,v.style.setProperty("--share",z),y(),o.playing||r()}function y(){let N=yl(o.flights),z=N===null?"":` · ${o.t>=N?"+":"−"}${Math.abs(1e3*(o.t-N)).toFixed(1)} ms from touch`,Q=o.pace==="auto"?o.line.paceAt(o.t):1/Number(o.pace);f.replaceChildren(X("b",{},`${o.t.toFixed(4)} s`),X("span",{},z),X("span",{class:"pace"},jE(Q))),m.setAttribute("aria-valuetext",`${o.t.toFixed(3)} s${z}`),n&&V()}function b(N){if(!o.playing)return;let z=Math.min((N-o.last)/1e3,.1);o.last=N;let Q=o.line,ie=o.pace==="auto"?Q.timeAt(Q.watchedAt(o.t)+z):o.t+z/Number(o.pace);d(ie),o.t>=Q.end?C():requestAnimationFrame(b)}function _(){!o.line||o.playing||(o.t>=o.line.end-1e-9&&d(o.line.begin),o.playing=!0,o.last=performance.now(),E(),requestAnimationFrame(b))}function C(){o.playing&&setTimeout(r),o.playing=!1,E()}function E(){a.replaceChildren(Yi(o.playing?"pause":"play")),a.setAttribute("aria-label",o.playing?"Pause":"Play"),a.title=o.playing?"Pause (space)":"Play (space)"}function P(N){o.pace=N==="auto"?"auto":String(il.reduce((z,Q)=>Math.abs(Q-N)<Math.abs(z-N)?Q:z)),h.value=o.pace,y(),r()}function L(N){let z=o.pace==="auto"?N>0?0:1:il.indexOf(Number(o.pace))+N;P(il[Math.min(Math.max(z,0),il.length-1)])}function M(N){C();let z=o.flights[0],Q=o.t-z.shift,ie=_l(z.t,Q+1e-9),ne=z.t[ie]<Q-1e-9&&N<0?ie:ie+N;d(z.t[Math.min(Math.max(ne,0),z.n-1)]+z.shift)}function S(){C();let N=yl(o.flights);N!==null&&d(N)}function A(){let N=o.line,z=ne=>N.watchedAt(ne)/N.total;g.replaceChildren(...N.stretches.map(([ne,ce])=>{let he=X("span",{class:"slow"});return he.style.left=`${100*z(ne)}%`,he.style.width=`${100*Math.max(z(ce)-z(ne),.002)}%`,he}));let Q=o.flights.flatMap(ne=>ne.events.map(ce=>({...ce,t:ce.t+ne.shift,flight:ne})));Q.sort((ne,ce)=>ne.t-ce.t);for(let ne of Q){let ce=X("i",{class:ne.kind});ce.style.left=`${100*z(ne.t)}%`,o.flights.length>1&&(ce.style.background=ne.flight.colour),g.append(ce)}let ie=o.flights.length>1;p.replaceChildren(...Q.filter(ne=>ne.kind!=="end"||!ie).slice(0,60).map(ne=>{let ce=ie?`${ne.flight.label}: ${ne.label}`:ne.label,he=X("button",{type:"button",class:`event ${ne.kind}`,title:`${ne.text}, ${ne.t.toFixed(4)} s`,onclick:()=>{C(),d(ne.t)}},X("span",{},ce),X("small",{},` ${ne.t.toFixed(3)} s`));return ie&&he.style.setProperty("--colour",ne.flight.colour),he}))}let k=[];function O(){if(!n)return;let N=["speed","acceleration","compression, largest","contact force, sum of all contacts","thrust, all rotors"],z=["m/s","m/s²","mm","N","N"],Q=o.flights.length>2,ie=X("table",{class:Q?"numbers crowded":"numbers"});o.flights.length>1&&ie.append(X("thead",{},X("tr",{},X("th",{},""),...o.flights.map(ce=>{let he=X("th",{scope:"col"},ce.label);return he.style.color=ce.colour,he}),...Q?[]:[X("th",{},"")])));let ne=X("tbody");k=N.map((ce,he)=>{let Me=o.flights.map(()=>X("td")),Ee=X("td",{class:"unit"},he===dv&&o.flights.every(pv)?"":z[he]);return ne.append(X("tr",{},X("th",{scope:"row"},Q?`${ce} [${z[he]}]`:ce),...Me,...Q?[]:[Ee])),Me}),ie.append(ne),n.replaceChildren(ie)}function V(){o.flights.forEach((N,z)=>{let Q=jo(N,o.t),ie=Ee=>N.series.find(te=>te.panel===Ee),ne=Ee=>ie(Ee)?Qo({flight:N,values:ie(Ee).values},o.t):0,ce=Math.max(0,...N.arms.map((Ee,te)=>Ee.compliant?1e3*Lg(Ee,Q.armLengths[te],Q.bends[te]):0)),he=Math.hypot(...[0,1,2].map(Ee=>Q.contacts.reduce((te,K)=>te+(K?K.force[Ee]:0),0)));[ne("Velocity"),ne("Acceleration"),ce,he,Q.thrust.reduce((Ee,te)=>Ee+te,0)].forEach((Ee,te)=>k[te][z].textContent=te===dv&&pv(N)?"rigid":uv(Ee))})}function q(N){if(N.ctrlKey||N.metaKey||N.altKey||N.target.closest?.("dialog"))return;let z=N.target.tagName;if(z==="TEXTAREA"||z==="SELECT"||z==="INPUT"&&N.target.type!=="range"||N.target.type==="range"&&N.target!==m)return;let Q=N.shiftKey?10:1,ie={" ":()=>o.playing?C():_(),ArrowRight:()=>M(Q),ArrowLeft:()=>M(-Q),Home:()=>(C(),d(o.line.begin)),End:()=>(C(),d(o.line.end)),",":()=>L(1),".":()=>L(-1),t:S,...s};if(N.key===" "&&z==="BUTTON")return;let ne=ie[N.key];!ne||!o.line||ne()!==!1&&N.preventDefault()}document.addEventListener("keydown",q);function $({keepTime:N=!0}={}){o.flights=i.flights,o.line=Ng(o.flights),O(),e?.replace(o.flights),A();let z=yl(o.flights);d(N?o.t:z===null?o.line.begin:z-JE)}return E(),{replace:$,seek:d,play:_,pause:C,setPace:P,goToTouch:S,get time(){return o.t},get playing(){return o.playing},get pace(){return o.pace},dispose(){C(),document.removeEventListener("keydown",q),t.replaceChildren()}}}var mv={type:"change"},Fd={type:"start"},vv={type:"end"},Zh=new ur,gv=new Zn,QE=Math.cos(70*Xs.DEG2RAD),dn=new I,Qn=2*Math.PI,Nt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Nd=1e-6,Kh=class extends Ha{constructor(e,t=null){super(e,t),this.state=Nt.NONE,this.target=new I,this.cursor=new I,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hs.ROTATE,MIDDLE:Hs.DOLLY,RIGHT:Hs.PAN},this.touches={ONE:Vs.ROTATE,TWO:Vs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new I,this._lastQuaternion=new sn,this._lastTargetPosition=new I,this._quat=new sn().setFromUnitVectors(e.up,new I(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new bo,this._sphericalDelta=new bo,this._scale=1,this._panOffset=new I,this._rotateStart=new Fe,this._rotateEnd=new Fe,this._rotateDelta=new Fe,this._panStart=new Fe,this._panEnd=new Fe,this._panDelta=new Fe,this._dollyStart=new Fe,this._dollyEnd=new Fe,this._dollyDelta=new Fe,this._dollyDirection=new I,this._mouse=new Fe,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=tT.bind(this),this._onPointerDown=eT.bind(this),this._onPointerUp=nT.bind(this),this._onContextMenu=cT.bind(this),this._onMouseWheel=rT.bind(this),this._onKeyDown=oT.bind(this),this._onTouchStart=aT.bind(this),this._onTouchMove=lT.bind(this),this._onMouseDown=iT.bind(this),this._onMouseMove=sT.bind(this),this._interceptControlDown=hT.bind(this),this._interceptControlUp=uT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(mv),this.update(),this.state=Nt.NONE}update(e=null){let t=this.object.position;dn.copy(t).sub(this.target),dn.applyQuaternion(this._quat),this._spherical.setFromVector3(dn),this.autoRotate&&this.state===Nt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Qn:n>Math.PI&&(n-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(dn.setFromSpherical(this._spherical),dn.applyQuaternion(this._quatInverse),t.copy(this.target).add(dn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=dn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new I(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new I(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=dn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Zh.origin.copy(this.object.position),Zh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Zh.direction))<QE?this.object.lookAt(this.target):(gv.setFromNormalAndCoplanarPoint(this.object.up,this.target),Zh.intersectPlane(gv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Nd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Nd||this._lastTargetPosition.distanceToSquared(this.target)>Nd?(this.dispatchEvent(mv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Qn/60*this.autoRotateSpeed*e:Qn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){dn.setFromMatrixColumn(t,0),dn.multiplyScalar(-e),this._panOffset.add(dn)}_panUp(e,t){this.screenSpacePanning===!0?dn.setFromMatrixColumn(t,1):(dn.setFromMatrixColumn(t,0),dn.crossVectors(this.object.up,dn)),dn.multiplyScalar(e),this._panOffset.add(dn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;dn.copy(s).sub(this.target);let r=dn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Fe,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function eT(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function tT(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function nT(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(vv),this.state=Nt.NONE;break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function iT(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Hs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Nt.DOLLY;break;case Hs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Nt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Nt.ROTATE}break;case Hs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Nt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Nt.PAN}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(Fd)}function sT(i){switch(this.state){case Nt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Nt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Nt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function rT(i){this.enabled===!1||this.enableZoom===!1||this.state!==Nt.NONE||(i.preventDefault(),this.dispatchEvent(Fd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(vv))}function oT(i){this.enabled!==!1&&this._handleKeyDown(i)}function aT(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Vs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Nt.TOUCH_ROTATE;break;case Vs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Nt.TOUCH_PAN;break;default:this.state=Nt.NONE}break;case 2:switch(this.touches.TWO){case Vs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Nt.TOUCH_DOLLY_PAN;break;case Vs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Nt.TOUCH_DOLLY_ROTATE;break;default:this.state=Nt.NONE}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(Fd)}function lT(i){switch(this._trackPointer(i),this.state){case Nt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Nt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Nt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Nt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Nt.NONE}}function cT(i){this.enabled!==!1&&i.preventDefault()}function hT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function uT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var fT=7,dT=.0022,pT=new I(1,0,0);function Od(i,e=fT,t=dT){class n extends jn{getPoint(r,o=new I){let a=2*Math.PI*e*r;return o.set(r,i*Math.cos(a),i*Math.sin(a))}}return new La(new n,e*14,t,5)}function ki(i,e=14){return new wn(i,i,1,e).rotateZ(-Math.PI/2).translate(.5,0,0)}function Jh(i,e){return new Ke(new wn(.0155*i,.0155*i,.006*i,20).rotateZ(Math.PI/2),e)}function sl(i,e,t){let n=t.clone().sub(e);return i.position.copy(e),i.quaternion.setFromUnitVectors(new I(1,0,0),n.normalize()),i}function xv(i,e){let t=new Ot;t.setAttribute("position",new Jt(Zt(i.vertices),3)),t.setIndex(new Jt(new Uint32Array(Zt(i.triangles)),1));let n=t.toNonIndexed();return n.computeVertexNormals(),new Ke(n,e)}var jh=class{constructor(e,t,n){this.group=new _t;let s=new oi({color:e,depthTest:!1,transparent:!0,opacity:n});this.shaft=new Ke(ki(t,10),s),this.head=new Ke(new pr(3*t,8*t,14).rotateZ(-Math.PI/2),s),this.size=8*t,this.shaft.renderOrder=this.head.renderOrder=10,this.group.add(this.shaft,this.head),this.along=new I(1,0,0),this.way=new I}show(e,t){let n=this.way.set(...t).length();if(this.group.visible=n>1e-4,!this.group.visible)return;this.group.position.set(...e),this.group.quaternion.setFromUnitVectors(this.along,this.way.divideScalar(n));let s=Math.min(this.size,.6*n);this.head.scale.setScalar(s/this.size),this.head.position.x=n-.5*s,this.shaft.scale.x=Math.max(n-s,1e-5)}hide(){this.group.visible=!1}},en,yv,bv,Mv,rl,wv,Sv,Ev,Tv,ol=class{constructor(e,t,n){xl(this,en);this.flight=e,this.group=new _t;let s=t.opacity<1,r=(v,p={})=>new Ni({color:v,roughness:.55,metalness:.15,transparent:s,opacity:t.opacity,depthWrite:!s,...p}),o=r(n.metal),a=r(n.dark),l=r(t.colour),c=r(n.force,{metalness:.4,roughness:.35}),u=Math.max(...e.arms.map(v=>v.length)),h=u/.19,f=new Ke(new wn(.042*h,.042*h,.026*h,28),a);f.rotation.x=Math.PI/2;let m=new Ke(new wn(.032*h,.04*h,.014*h,28),l);m.rotation.x=Math.PI/2,m.position.z=.02*h;let g=new Ke(new pr(.012*h,.034*h,16).rotateZ(-Math.PI/2),l);g.position.set(.056*h,0,.004*h),this.group.add(f,m,g),this.hulls=e.hull.map(v=>{let p=r(t.colour,{transparent:!0,opacity:.22*t.opacity,depthWrite:!1});if(v.meshes.length){for(let y of v.meshes)this.group.add(xv(y,p));return p}let d=new Ke(new Pa(v.radius,32,20),p);return d.position.set(...v.centre),this.group.add(d),p}),this.arms=e.arms.map(v=>Cn(this,en,yv).call(this,v,{metal:o,dark:a,own:l,spring:c,paint:r,colours:n,unit:h,faded:s,look:t})),this.springs=e.neighbours.map(({first:v,second:p})=>{let d=new Ke(Od(.0075*h,16,.0014*h),c);return this.group.add(d),{coil:d,first:v,second:p,from:new I,to:new I,way:new I}}),this.open=new ot(n.force),this.shut=new ot(n.dark),this.rotors=e.rotors.map(v=>Cn(this,en,bv).call(this,v,{dark:a,paint:r,colours:n,unit:h,look:t})),this.most=e.max_thrust||1,this.bar=1.2*u}connections(){this.group.updateWorldMatrix(!0,!0);let e=this.group.parent?.position??new I,t=s=>s.getWorldPosition(new I).sub(e).toArray(),n=s=>s.localToWorld(new I(1,0,0)).sub(e).toArray();return{springs:this.springs.map(({coil:s})=>[t(s),n(s)]),latches:this.arms.flatMap(({latches:s})=>s??[]).map(({held:s,moving:r,glow:o})=>({held:t(s),moving:t(r),open:o.color.equals(this.open)}))}}ends(){this.group.updateWorldMatrix(!0,!0);let e=this.group.parent?.position??new I,t=n=>this.rotors[this.flight.rotors.findIndex(s=>s.arm===n)]?.rotor;return this.arms.map(({tip:n},s)=>({centre:n.getWorldPosition(new I).sub(e).toArray(),normal:new I(0,0,1).transformDirection(n.matrixWorld).toArray(),thrust:t(s)?new I(0,0,1).transformDirection(t(s).matrixWorld).toArray():null}))}show(e,t=1){this.group.position.set(...e.position);let[n,s,r,o]=e.quaternion;this.group.quaternion.set(s,r,o,n);let a=new Set(e.contacts.filter(Boolean).map(l=>l.part));this.arms.forEach((l,c)=>{let u=t===1?e.armLengths[c]:l.free-_v(t*(l.free-e.armLengths[c]),l),h=t===1?e.bends[c]??0:_v(t*(e.bends[c]??0),l);l.hung?l.path.at(u,l.end.position,l.end.quaternion,h):l.end.position.x=u,l.middle&&l.path.at(u,l.middle.position,l.middle.quaternion);for(let f of l.latches??[]){let m=f.isSecond?-(e.bends[c]??0):l.free-e.armLengths[c];f.glow.color.copy(m>f.travel?this.open:this.shut)}l.shown=u,l.bend=h,l.coil&&(l.coil.scale.x=Math.max(u-l.collar-l.seat,.004)),l.cagePaint.color.set(a.has(c)?this.flight.glow:this.flight.colour)}),this.rotors.forEach((l,c)=>{l.level&&l.rotor.quaternion.copy(l.level.end.quaternion).invert().multiply(l.aim),l.blades.rotation.z=l.spin*e.own*60;let u=this.bar*e.thrust[c]/this.most;l.thrust.visible=u>.001,l.thrust.scale.z=Math.max(u,.001)});for(let{coil:l,first:c,second:u,from:h,to:f,way:m}of this.springs){for(let[v,p]of[[c,h],[u,f]])this.arms[v].path.at(this.arms[v].shown,p,null,this.arms[v].bend);let g=m.copy(f).sub(h).length();l.position.copy(h),l.quaternion.setFromUnitVectors(pT,m.divideScalar(Math.max(g,1e-6))),l.scale.x=Math.max(g,1e-6)}this.hulls.forEach((l,c)=>{l.color.set(a.has(this.arms.length+c)?this.flight.glow:this.flight.colour)})}};en=new WeakSet,yv=function(e,{metal:t,dark:n,own:s,spring:r,paint:o,colours:a,unit:l,faded:c,look:u}){let h=new _t;this.group.add(h);let f=Math.atan2(e.direction[1],e.direction[0]),m=new _t;h.add(m);let g=new Po(e),v={end:m,frame:h,free:e.length,path:g,hung:e.joint.length>0},p=new _t,d={frame:h,end:m,metal:t,dark:n,own:s,spring:r,unit:l};v.hung?(p.rotation.z=f,e.compliant?g.second?v.middle=Cn(this,en,Ev).call(this,g,d):g.isHinge?Cn(this,en,Sv).call(this,g,d):Object.assign(v,Cn(this,en,wv).call(this,e,g,d)):Cn(this,en,rl).call(this,g.start,.007,d),v.latches=e.latch.map(E=>Cn(this,en,Tv).call(this,E,g,{...d,middle:v.middle,paint:o,colours:a}))):(h.rotation.z=f,Object.assign(v,Cn(this,en,Mv).call(this,e,d))),m.add(p);let y=o(u.colour,{roughness:.4}),b=new Ke(new Ia(e.cage_radius-.0035*l,.0035*l,10,72),y);e.caged&&p.add(b);let _=o(u.colour,{transparent:!0,opacity:.22*u.opacity,depthWrite:!1}),C=new _t;C.rotation.z=-f;for(let E of e.hulls)C.add(xv(E,_));p.add(C);for(let E=0;E<(e.caged?3:0);E++){let P=new Ke(ki(.0016*l,6),t);P.rotation.z=2*Math.PI*(E+.5)/3,P.scale.x=e.cage_radius-.004*l,p.add(P)}return Object.assign(v,{cagePaint:y,tip:p,seat:C})},bv=function({arm:e,offset:t,axis:n,level:s,spin:r,radius:o},{dark:a,paint:l,colours:c,unit:u,look:h}){let f=new _t;f.position.set(...t);let m=new sn().setFromUnitVectors(new I(0,0,1),new I(...n));f.quaternion.copy(m),(e<0?this.group:this.arms[e].seat).add(f);let g=new Ke(new wn(.013*u,.013*u,.024*u,18).rotateX(Math.PI/2),a);g.position.z=.008*u;let v=new Ke(new dr(o,36),l(c.thrust,{transparent:!0,opacity:.16*h.opacity,side:Sn,depthWrite:!1}));v.position.z=.022*u;let p=new Ke(new ji(2*o,.012*u,.0015),a);p.position.z=.023*u;let d=new Ke(new wn(.006*u,.006*u,1,12).rotateX(Math.PI/2).translate(0,0,.5),l(c.thrust,{transparent:!0,opacity:.8*h.opacity,emissive:c.thrust,emissiveIntensity:.3}));return d.position.z=.024*u,f.add(g,v,p,d),{rotor:f,blades:p,thrust:d,spin:r,aim:m,level:s?this.arms[e]:null}},Mv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,spring:a,unit:l}){let c=e.length-e.shortest,u=.13*e.length;if(!e.compliant){let d=new Ke(ki(.007*l),s);return d.scale.x=e.length,t.add(d),{}}let h=Math.max(.24*e.length,e.shortest-u-.8*c),f=new Ke(ki(.0075*l),s);f.scale.x=e.shortest-.5*u;let m=new Ke(ki(.0045*l),o);m.position.x=-(e.length-h)+.3*u,m.scale.x=-m.position.x;let g=Jh(l,r);g.position.x=h;let v=Jh(l,r);v.position.x=-u;let p=new Ke(Od(.0125*l),a);return p.position.x=h,t.add(f,g,p),n.add(m,v),{coil:p,seat:h,collar:u}},rl=function(e,t,{frame:n,metal:s,unit:r}){let o=new Ke(ki(t*r),s);o.scale.x=Math.max(e.length(),1e-6),n.add(sl(o,new I,e))},wv=function(e,t,{frame:n,end:s,metal:r,dark:o,own:a,spring:l,unit:c}){let u=.13*t.start.length(),h=t.start.distanceTo(t.anchor),f=e.length-e.shortest,m=sl(new _t,t.anchor,t.start),g=new Ke(ki(.0075*c),r);g.scale.x=Math.max(h-f-.5*u,1e-6);let v=new Ke(Od(.0125*c),l);m.add(g,Jh(c,o),v);let p=new _t;p.quaternion.copy(m.quaternion);let d=new Ke(ki(.0045*c),a);d.position.x=-h+.3*u,d.scale.x=-d.position.x;let y=Jh(c,o);return y.position.x=-u,p.add(d,y),n.add(m),s.add(p),Cn(this,en,rl).call(this,t.anchor,.0075,{frame:n,metal:r,unit:c}),{coil:v,seat:e.length-h,collar:u}},Sv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,unit:a}){Cn(this,en,rl).call(this,e.anchor,.0075,{frame:t,metal:s,unit:a});let l=new Ke(new wn(.0105*a,.0105*a,.028*a,20),r);l.quaternion.setFromUnitVectors(new I(0,1,0),e.axis.clone().normalize()),l.position.copy(e.anchor),t.add(l);let c=new Ke(ki(.006*a),o),u=e.anchor.clone().sub(e.start);c.scale.x=u.length(),n.add(sl(c,new I,u))},Ev=function(e,{frame:t,end:n,metal:s,dark:r,own:o,unit:a}){let l=new _t;t.add(l);let c=(v,p,d)=>{let y=new Ke(new wn(.0105*a,.0105*a,.028*a,20),r);y.quaternion.setFromUnitVectors(new I(0,1,0),v.axis.clone().normalize()),y.position.copy(d),p.add(y)},u=e.second,h=e.isHinge?e.anchor:new I;e.isHinge&&(Cn(this,en,rl).call(this,e.anchor,.0075,{frame:t,metal:s,unit:a}),c(e,t,e.anchor));let f=e.anchor.clone().sub(e.start),m=u.isHinge?u.anchor.clone().sub(e.start):new I;u.isHinge&&c(u,l,m);let g=(v,p,d)=>{let y=new Ke(ki(.006*a),o);y.scale.x=Math.max(v.distanceTo(p),1e-6),d.add(sl(y,v,p))};return e.isHinge?g(f,m,l):g(h,e.start.clone().add(m),t),u.isHinge&&g(new I,m,n),l},Tv=function(e,t,{frame:n,end:s,middle:r,metal:o,unit:a,paint:l,colours:c}){let u=e.joint===1,h=u?t.second:t,[f,m]=u?[r??n,s]:[n,r??s],g=f===n?new I:t.start,v=new I(...e.face),p=.006*a,d=l(c.dark),y=()=>{let M=(h.isHinge?.011:.019)*a,S=new wn(M,M,p,20);return new Ke(S.rotateZ(-Math.PI/2),d)},b=h.along.clone().normalize(),_=new sn().setFromUnitVectors(new I(1,0,0),b),[C,E]=[y(),y()];C.quaternion.copy(_),E.quaternion.copy(_),C.position.copy(v).addScaledVector(b,1.1*p).sub(g),E.position.copy(v).sub(t.start);let P=new Ke(ki(.0028*a,8),o),L=h.anchor.clone().addScaledVector(b,h.isHinge?p:0).sub(g);return P.scale.x=Math.max(L.distanceTo(C.position),1e-6),f.add(C,sl(P,L,C.position)),m.add(E),{glow:d,held:C,moving:E,travel:e.travel,isSecond:u}};function _v(i,e){let t=.4*e.free;return Math.min(e.hung?Math.max(i,-t):i,t)}function al(i){i.traverse(e=>{e.geometry?.dispose();for(let t of[e.material].flat())t?.map?.dispose(),t?.dispose?.()}),i.removeFromParent()}var Av=new an,Qh=new I,Ho=class extends Ba{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new mt(e,3)),this.setAttribute("uv",new mt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ks(t,6,1);return this.setAttribute("instanceStart",new Jn(n,3,0)),this.setAttribute("instanceEnd",new Jn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ks(t,6,1);return this.setAttribute("instanceColorStart",new Jn(n,3,0)),this.setAttribute("instanceColorEnd",new Jn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new Da(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new an);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Av.setFromBufferAttribute(t),this.boundingBox.union(Av))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Qh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Qh)),Qh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Qh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Ue.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Fe(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Xn.line={uniforms:$a.merge([Ue.common,Ue.fog,Ue.line]),vertexShader:`
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
		`};var $s=class extends ai{constructor(e){super({type:"LineMaterial",uniforms:$a.clone(Xn.line.uniforms),vertexShader:Xn.line.vertexShader,fragmentShader:Xn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Bd=new It,Rv=new I,Cv=new I,En=new It,Tn=new It,ns=new It,zd=new I,kd=new Ut,An=new za,Pv=new I,eu=new an,tu=new Di,is=new It,ss,Ir;function Iv(i,e,t){return is.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),is.multiplyScalar(1/is.w),is.x=Ir/t.width,is.y=Ir/t.height,is.applyMatrix4(i.projectionMatrixInverse),is.multiplyScalar(1/is.w),Math.abs(Math.max(is.x,is.y))}function mT(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){An.start.fromBufferAttribute(s,a),An.end.fromBufferAttribute(r,a),An.applyMatrix4(t);let c=new I,u=new I;ss.distanceSqToSegment(An.start,An.end,u,c),u.distanceTo(c)<Ir*.5&&e.push({point:u,pointOnLine:c,distance:ss.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function gT(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;ss.at(1,ns),ns.w=1,ns.applyMatrix4(e.matrixWorldInverse),ns.applyMatrix4(n),ns.multiplyScalar(1/ns.w),ns.x*=r.x/2,ns.y*=r.y/2,ns.z=0,zd.copy(ns),kd.multiplyMatrices(e.matrixWorldInverse,o);for(let f=0,m=u;f<m;f++){if(En.fromBufferAttribute(l,f),Tn.fromBufferAttribute(c,f),En.w=1,Tn.w=1,En.applyMatrix4(kd),Tn.applyMatrix4(kd),En.z>h&&Tn.z>h)continue;if(En.z>h){let b=En.z-Tn.z,_=(En.z-h)/b;En.lerp(Tn,_)}else if(Tn.z>h){let b=Tn.z-En.z,_=(Tn.z-h)/b;Tn.lerp(En,_)}En.applyMatrix4(n),Tn.applyMatrix4(n),En.multiplyScalar(1/En.w),Tn.multiplyScalar(1/Tn.w),En.x*=r.x/2,En.y*=r.y/2,Tn.x*=r.x/2,Tn.y*=r.y/2,An.start.copy(En),An.start.z=0,An.end.copy(Tn),An.end.z=0;let v=An.closestPointToPointParameter(zd,!0);An.at(v,Pv);let p=Xs.lerp(En.z,Tn.z,v),d=p>=-1&&p<=1,y=zd.distanceTo(Pv)<Ir*.5;if(d&&y){An.start.fromBufferAttribute(l,f),An.end.fromBufferAttribute(c,f),An.start.applyMatrix4(o),An.end.applyMatrix4(o);let b=new I,_=new I;ss.distanceSqToSegment(An.start,An.end,_,b),t.push({point:_,pointOnLine:b,distance:ss.origin.distanceTo(_),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var nu=class extends Ke{constructor(e=new Ho,t=new $s({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Rv.fromBufferAttribute(t,o),Cv.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Rv.distanceTo(Cv);let r=new ks(s,2,1);return e.setAttribute("instanceDistanceStart",new Jn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Jn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;ss=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Ir=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),tu.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Ir*.5;else{let h=Math.max(s.near,tu.distanceToPoint(ss.origin));c=Iv(s,h,l.resolution)}if(tu.radius+=c,ss.intersectsSphere(tu)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),eu.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Ir*.5;else{let h=Math.max(s.near,eu.distanceToPoint(ss.origin));u=Iv(s,h,l.resolution)}eu.expandByScalar(u),ss.intersectsBox(eu)!==!1&&(n?mT(this,t):gT(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Bd),this.material.uniforms.resolution.value.set(Bd.z,Bd.w))}};var Vo=class extends Ho{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setPositions(n),this}setColors(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setColors(n),this}setFromPoints(e){let t=e.length-1,n=new Float32Array(6*t);for(let s=0;s<t;s++)n[6*s]=e[s].x,n[6*s+1]=e[s].y,n[6*s+2]=e[s].z||0,n[6*s+3]=e[s+1].x,n[6*s+4]=e[s+1].y,n[6*s+5]=e[s+1].z||0;return super.setPositions(n),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var iu=class extends nu{constructor(e=new Vo,t=new $s({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};function Lv(i,e=Math.PI/3){let t=Math.cos(e),n=(1+1e-10)*100,s=[new I,new I,new I],r=new I,o=new I,a=new I,l=new I;function c(v){let p=~~(v.x*n),d=~~(v.y*n),y=~~(v.z*n);return`${p},${d},${y}`}let u=i.index?i.toNonIndexed():i,h=u.attributes.position,f={};for(let v=0,p=h.count/3;v<p;v++){let d=3*v,y=s[0].fromBufferAttribute(h,d+0),b=s[1].fromBufferAttribute(h,d+1),_=s[2].fromBufferAttribute(h,d+2);r.subVectors(_,b),o.subVectors(y,b);let C=new I().crossVectors(r,o).normalize();for(let E=0;E<3;E++){let P=s[E],L=c(P);L in f||(f[L]=[]),f[L].push(C)}}let m=new Float32Array(h.count*3),g=new Jt(m,3,!1);for(let v=0,p=h.count/3;v<p;v++){let d=3*v,y=s[0].fromBufferAttribute(h,d+0),b=s[1].fromBufferAttribute(h,d+1),_=s[2].fromBufferAttribute(h,d+2);r.subVectors(_,b),o.subVectors(y,b),a.crossVectors(r,o).normalize();for(let C=0;C<3;C++){let E=s[C],P=c(E),L=f[P];l.set(0,0,0);for(let M=0,S=L.length;M<S;M++){let A=L[M];a.dot(A)>t&&l.add(A)}l.normalize(),g.setXYZ(d+C,l.x,l.y,l.z)}}return u.setAttribute("normal",g),u}var vT=.6,xT=25,_T=.02,yT=200,Dv=.004,Nn=i=>new I(...i);function Nv(i,e,t,n,s,r){let o=[],a=e.length(),l=t.length(),c=n;for(;2*Math.max(a,l)>yT*c;)c*=2;let u=e.clone().normalize(),h=t.clone().normalize(),f=(p,d)=>o.push(...p.toArray(),...d.toArray()),m=(p,d)=>i.clone().addScaledVector(u,p).addScaledVector(h,d),g=p=>{let d=[-p,p];for(let y=Math.ceil(-p/c)*c;y<p;y+=c)d.push(y);return d};for(let p of g(a))f(m(p,-l),m(p,l));for(let p of g(l))f(m(-a,p),m(a,p));let v=new Ot;return v.setAttribute("position",new mt(o,3)),new yo(v,new vs({color:s,transparent:!0,opacity:r,depthWrite:!1}))}function su(i,e,t,n,s=0){let r=Nn(i.across),o=Nn(i.along),a=Nn(i.normal),l=new ji(2*r.length(),2*o.length(),e),c=new Ni({color:t,transparent:!0,opacity:n,roughness:.9,depthWrite:!1,side:Sn}),u=new Ke(l,c),h=new Ut().makeBasis(r.normalize(),o.normalize(),a);return u.quaternion.setFromRotationMatrix(h),u.position.copy(Nn(i.centre)).addScaledVector(a,-s-.5*e),u.renderOrder=1,u}function bT(i,e){let t=new Ot;t.setAttribute("position",new Jt(Zt(i.vertices),3)),t.setAttribute("normal",new Jt(Zt(i.normals),3)),t.setIndex(Array.from(Zt(i.triangles)));let n=new Ke(t,new oi({colorWrite:!1,transparent:!0,side:Sn})),s=new Ke(t,new Ni({color:e,transparent:!0,opacity:.55,roughness:.85,depthWrite:!1,side:Sn}));return[n,s].forEach((r,o)=>r.renderOrder=3+o),new _t().add(n,s)}function MT(i,e,t,n){let s=Fv(i),r=Lv(s,vT),o=n===null?[]:[new Zn(new I(0,0,1),-n)],a=new Ke(r,new oi({colorWrite:!1,transparent:!0,clippingPlanes:o})),l=new Ke(r,new Ni({color:t,transparent:!0,opacity:.72,roughness:.85,depthWrite:!1,clippingPlanes:o,stencilWrite:!0,stencilRef:1,stencilFunc:Sh,stencilZPass:wh})),c=new yo(new Ta(s,xT),new vs({color:e.ink,transparent:!0,opacity:.35,depthWrite:!1,clippingPlanes:o}));return s.dispose(),[a,l,c].forEach((u,h)=>u.renderOrder=3+h),new _t().add(a,l,c)}function Fv(i){let e=new Ot;return e.setAttribute("position",new Jt(Zt(i.vertices),3)),e.setIndex(Array.from(Zt(i.triangles))),e}var cl=i=>`${i.name||i.kind}${i.kind!=="mesh"||i.track<0?"":", moving"}`,Uv=i=>i.kind==="mesh"?cl(i):i.kind;function Ov(i,e){let n=[...new Set(i.map(Uv))].filter(r=>r!=="mat"&&r!=="ground");n.sort((r,o)=>(o==="wall")-(r==="wall"));let s=r=>n.includes(r)?e.shapes[n.indexOf(r)%e.shapes.length]:e[r];return new Map(i.map(r=>[cl(r),s(Uv(r))]))}function Bv(i,e,t){if(i.kind!=="mesh"||i.normals)return null;let n=Fv(i);if(n.computeBoundingBox(),n.boundingBox.min.z<e-_T&&(t===null||n.boundingBox.max.z<=e))return null;let s=new oi({color:"#000000",transparent:!0,opacity:.14,depthWrite:!1,side:Sn,stencilWrite:!0,stencilRef:2,stencilFunc:Sh,stencilZPass:wh}),r=new Ke(n,s);return r.renderOrder=2,r.frustumCulled=!1,r}function zv(i,e){let t=new _t().add(e);return t.scale.z=0,t.position.z=i+.002,t}function kv(i,e,t){let n=Bv(i,e,t);return n&&zv(e,n)}function Hd(i,e,t,n=null){let s=new _t,r=t.get(cl(i))??e.wall;if(i.kind==="mesh")return i.normals?s.add(bT(i,r)):MT(i,e,r,n);let o=Nn(i.centre),a=Nn(i.normal).multiplyScalar(.001),l=(c,u,h)=>Nv(o.clone().add(a),Nn(i.across),Nn(i.along),h,u,c);return i.kind==="ground"?s.add(su(i,.004,e.ground,.35),l(.55,e.faint,.25)):i.kind==="mat"?(s.add(su(i,i.thickness,e.mat,.2),l(.55,e.mat,.1)),s.add(su(i,.04,e.wall,.25,i.thickness))):s.add(su(i,.04,r,.22),l(.5,r,.1)),s}var ru=class{constructor(e,t,n,s,r,o){this.origin=Nn(e.origin),this.body=new _t().add(...t.map(c=>Hd(c,n,s,r)));let a=t.map(c=>Bv(c,o,r)).filter(Boolean);if(this.shadow=new _t,a.length&&this.shadow.add(...a),this.group=new _t().add(this.body,zv(o,this.shadow)),this.turn=new sn,this.rod=null,!e.rod.length)return;this.pivot=Nn(e.rod);let l=new wn(Dv,Dv,1,10).translate(0,.5,0);this.rod=new Ke(l,new Ni({color:n.metal,roughness:.6})),this.rod.position.copy(this.pivot),this.group.add(this.rod)}show(e){let[t,n,s,r]=e.quaternion;if(this.turn.set(n,s,r,t),this.body.quaternion.copy(this.turn),this.body.position.copy(this.origin).negate().applyQuaternion(this.turn).add(Nn(e.position)),this.shadow.quaternion.copy(this.body.quaternion),this.shadow.position.copy(this.body.position),!this.rod)return;let o=Nn(e.position).sub(this.pivot);this.rod.scale.y=o.length(),this.rod.quaternion.setFromUnitVectors(new I(0,1,0),o.normalize())}};function Hv(i,e){let t=i.getSize(new I),n=i.getCenter(new I);n.z=i.min.z;let s=r=>Math.max(.8,Math.ceil((.5*r+.4)*4)/4);return Nv(n,new I(s(t.x),0,0),new I(0,s(t.y),0),.25,e.faint,.35)}function Vv(i,e){let t=Nn(i.guide).normalize(),n=[];for(let c=0;c<i.n;c+=Math.max(1,Math.floor(i.n/200)))n.push(t.dot(Nn(i.position.subarray(3*c,3*c+3))));let s=Math.min(...n)-.5,r=Math.max(...n)+.5-s,o=new wn(.008,.008,r,12).rotateZ(-Math.PI/2).translate(r/2,0,0),a=new Ke(o,new Ni({color:e.metal,transparent:!0,opacity:.5}));a.quaternion.setFromUnitVectors(new I(1,0,0),t);let l=Nn(i.position.subarray(0,3));return a.position.copy(l).addScaledVector(t,s-t.dot(l)),a}var ou=class{constructor(e,t,n){let s=e.impacts,r=s.length?s[0][0]:1/0,o=[],a=[],l=new ot(t.before),c=new ot(t.force),u=new ot(e.colour);this.times=[];let h=-1/0;for(let m=0;m<e.n;m++){let g=e.t[m];if(g-h<.001&&m<e.n-1)continue;h=g,this.times.push(g),o.push(...e.position.subarray(3*m,3*m+3));let v=s.some(([p,d])=>g>=p&&g<=d);a.push(...(v?c:g<r?l:u).toArray())}let f=(m,g)=>{let v=new Vo;v.setPositions(o),v.setColors(a);let p=new $s({vertexColors:!0,linewidth:g,transparent:!0,opacity:m,depthWrite:!1});p.resolution.copy(n);let d=new iu(v,p);return d.computeLineDistances(),d};this.whole=f(.3,1.2),this.flown=f(1,2.6),this.group=new _t,this.group.add(this.whole,this.flown)}show(e){let t=0,n=this.times.length;for(;t<n;){let s=t+n>>1;this.times[s]<=e?t=s+1:n=s}this.flown.geometry.instanceCount=Math.max(t-1,0)}resize(e){this.whole.material.resolution.copy(e),this.flown.material.resolution.copy(e)}},au=class{constructor(e,t,n){this.level=t,this.group=new _t,this.paths=e.arms.map(a=>new Po(a));let s=()=>new oi({color:"#000000",transparent:!0,opacity:.16,depthWrite:!1}),r=a=>{let l=new Ke(new dr(a,36),s());return l.renderOrder=2,this.group.add(l),l};this.body=r(.045),this.cages=e.arms.map(a=>r(a.cage_radius));let o=new Ot;o.setAttribute("position",new mt([0,0,0,0,0,1],3)),this.plumb=new fr(o,new vs({color:n.faint,transparent:!0,opacity:.6})),this.group.add(this.plumb),this.turn=new sn,this.at=new I}show(e){let[t,n,s,r]=e.quaternion;this.turn.set(n,s,r,t);let o=this.level+.003;this.body.position.set(e.position[0],e.position[1],o),this.cages.forEach((a,l)=>{this.paths[l].at(e.armLengths[l],this.at,null,e.bends[l]),this.at.applyQuaternion(this.turn),a.position.set(e.position[0]+this.at.x,e.position[1]+this.at.y,o)}),this.plumb.position.set(e.position[0],e.position[1],o),this.plumb.scale.z=Math.max(e.position[2]-o,1e-4)}};function wT(i,e){let t=document.createElement("canvas");t.width=128,t.height=64;let n=t.getContext("2d");n.font="600 40px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle=e,n.fillText(i,64,32);let s=new wa(t);s.colorSpace=Gn;let r=new Ma(new xo({map:s,depthTest:!1,transparent:!0}));return r.scale.set(.9,.45,1),r}function Gv(i){let e=new _t;return Object.entries({"x N":[1,0,0],"y W":[0,1,0],"z up":[0,0,1]}).forEach(([n,s])=>{let r=new ka(Nn(s),new I,1,i.ink,.28,.16),o=wT(n,i.ink);o.position.set(...s).multiplyScalar(1.38),e.add(r,o)}),e}var ST=(i,e)=>i.map((t,n)=>t+e[n]),Wv=(i,e)=>i.kind==="mesh"?{...i,moved:e}:{...i,centre:ST(i.centre,e)},ll=(i,e)=>i.reduce((t,n,s)=>t+n*e[s],0);function Xv(i){let e=new Map;for(let t of i){let n=t.kind!=="mesh",s=n?[t.kind,t.thickness,...t.normal,ll(t.normal,t.centre)].map(o=>o.toFixed?o.toFixed(4):o).join():`${t.name} ${t.key} ${t.moved}`,r=e.get(s);e.set(s,r?n?TT(r,t):ET(r,t):t)}return[...e.values()]}function ET(i,e){let[t,n]=[i,e].map(s=>{let r=new an().setFromArray(Zt(s.vertices));return s.triangles.shape[0]+.01*r.getSize(new I).length()});return n>t?e:i}function TT(i,e){let t={...i,centre:i.centre.slice()};for(let n of["across","along"]){let s=Math.hypot(...i[n]),r=i[n].map(u=>u/s),o=Math.abs(ll(r,e.across))+Math.abs(ll(r,e.along)),a=ll(r,e.centre)-ll(r,i.centre),l=Math.min(-s,a-o),c=Math.max(s,a+o);t[n]=r.map(u=>u*(c-l)/2),t.centre=t.centre.map((u,h)=>u+r[h]*(l+c)/2)}return t}var qv=.22,AT=.2,RT=2.5,CT=1,PT=.005,[Yv,$v,Zv]=[.02,80,30],IT=.01,LT=["follow","front","side","top"],Go=["follow","free","front","side","top","impact"],Kv=100,Jv=.4,jv=400,Vd=i=>Math.max(...i.arms.map(e=>Ig(e)+e.cage_radius));function Gd(i,e,t=!0){let n=i.map(Rp),s=e.robots;n.forEach((a,l)=>{let c=!a.arms.some(u=>u.compliant);a.colour=n.length>1?s[l%s.length]:s[c?1:0],a.glow=e.force,a.index=l,a.shift=0});let r=n.map(Cs),o=r.find(a=>a!==null);return r.forEach((a,l)=>{t&&a!==null&&Math.abs(o-a)>PT&&(n[l].shift=o-a)}),n}function lu(i,{flights:e=[],compare:t="side",align:n=!0,onCamera:s=()=>{},onDrawn:r=()=>{}}={}){let o={compare:t,align:n,magnified:1,camera:"follow",t:0,all:[],hidden:new Set,flights:[],forces:!0,path:!0,estimate:!1,share:1},a=Pn();i.classList.add("picture");let l=document.createElement("div");l.className="force-labels";let c=document.createElement("div");c.className="scene-legend";let u=null;try{u=new Ch({antialias:!0,alpha:!1,stencil:!0,powerPreference:"high-performance"})}catch{let B=document.createElement("p");B.className="no-graphics",B.textContent="This browser cannot draw 3-D graphics (WebGL is off); plots and numbers work.",i.append(B)}let h=new go,f=new Dn(38,1,Yv,$v);f.up.set(0,0,1);let m=new go,g=new gr(-1.9,1.9,1.9,-1.9,.1,20);g.up.set(0,0,1);let v=new Fa("#ffffff","#9aa4b0",2.1),p=new Oa("#ffffff",2);p.position.set(-2,-3,5),h.add(v,p);let d=null,y=new _t,b=[],_=0,C=0,E=-1/0,P=0,L=0,M=new Fe(1,1);if(u){u.localClippingEnabled=!0,i.append(u.domElement,l,c),u.domElement.setAttribute("role","img"),u.domElement.setAttribute("aria-label","The flight in three dimensions, with numbers beside it."),d=new Kh(f,u.domElement),d.enableDamping=!1,d.minDistance=.15,d.maxDistance=Zv,d.addEventListener("change",S);let B=!1;d.addEventListener("start",()=>B=!0),d.addEventListener("end",()=>B=!1),d.addEventListener("change",()=>{B&&o.camera!=="follow"&&s("")})}function S(){!u||_||(C=performance.now(),_=requestAnimationFrame(O))}function A(){let B=performance.now(),W=C-E<jv;E=B,clearTimeout(P),W&&(L=.7*L+.3*(B-C)),L>Kv&&o.share>Jv&&(o.share=Math.max(Jv,.7*o.share),L=.5*Kv),k(W?o.share:1),W&&o.share<1&&(P=setTimeout(S,jv))}function k(B){let W=Math.min(devicePixelRatio||1,2)*B;Math.abs(u.getPixelRatio()-W)>.001&&u.setPixelRatio(W)}function O(){_=0,!(!u||!i.clientWidth||!i.clientHeight)&&(A(),V(),r())}function V(){let B=i.clientWidth,W=i.clientHeight;u.setViewport(0,0,B,W),u.setScissorTest(!1),u.setClearColor(a.background,1),f.near=Math.max(Yv,IT*f.position.distanceTo(d.target)),f.updateProjectionMatrix(),u.render(h,f);let j=Math.min(104,.24*Math.min(B,W));g.position.copy(f.position).sub(d.target).setLength(6),g.up.copy(f.up),g.lookAt(0,0,0),u.autoClear=!1,u.clearDepth(),u.setViewport(6,6,j,j),u.render(m,g),u.autoClear=!0,K(B,W)}function q(){let B=o.flights[0].obstacles.find(j=>j.kind==="wall"||j.kind==="mat"),W=B&&Math.abs(B.normal[2])<.9?new I(...B.across).normalize():new I(0,1,0);return W.y<0?W.negate():W}let $=()=>q().applyAxisAngle(f.up,-Math.PI/2);function N(B){let W=new I,[j,pe]=[1/0,-1/0];for(let de of o.flights.flatMap(ye=>ye.obstacles)){if(de.kind!=="mesh"||de.normals)continue;let ye=Zt(de.vertices);for(let fe=0;fe<ye.length;fe+=3){let ue=W.fromArray(ye,fe).dot(B);[j,pe]=[Math.min(j,ue),Math.max(pe,ue)]}}return Math.max(0,pe-j)}let z=()=>[...new Set(o.flights.map(B=>B.world))];function Q(B){let W=o.flights.filter(ye=>o.flights.some(fe=>fe!==ye&&fe.world===ye.world)),j=new I,[pe,de]=[1/0,-1/0];for(let{position:ye}of W)for(let fe=0;fe<ye.length;fe+=3){let ue=j.fromArray(ye,fe).dot(B);[pe,de]=[Math.min(pe,ue),Math.max(de,ue)]}return Math.max(0,de-pe)}let ie=()=>ne()?"ghost":o.compare,ne=()=>z().length>1&&N(q())>RT;function ce(){if(ie()!=="side")return o.flights.map(()=>[0,0,0]);let B=q(),W=Math.max(...o.flights.map(Vd)),j=Math.max(2*W+Q(B),N(B))+AT,pe=z(),de=.5*(pe.length-1);return o.flights.map(({world:ye})=>B.clone().multiplyScalar((de-pe.indexOf(ye))*j).toArray())}function he(B,{keepCamera:W=!0}={}){a=Pn(),o.all=Gd(B,a,o.align),o.flights=o.all.filter((j,pe)=>!o.hidden.has(pe)),u&&Me(),W||Pe(o.camera),We(o.t)}function Me(){al(y),y=new _t,h.add(y),m.children.slice().forEach(al),m.add(Gv(a)),l.replaceChildren();let B=ce(),W=new an,j=Math.max(...o.flights.map(Tu),0),pe=j>0?qv/Au(j):0;o.floor=Ee(B),b=o.flights.map((fe,ue)=>{let xe=new _t;xe.position.set(...B[ue]),y.add(xe);let Oe=fe.world!==z()[0]&&ie()==="ghost",He=new ol(fe,{colour:fe.colour,opacity:Oe?.35:1},a),Le=new ou(fe,a,M),Ze=fe.part.map(()=>new jh(a.force,.007,Oe?.4:.95)),Y=new au(fe,o.floor,a);Y.group.visible=!Oe||o.flights.length===2;let be=Vr(fe)?new ol(fe,{colour:a.ink,opacity:.35},a):null;be&&xe.add(be.group),xe.add(He.group,Le.group,Y.group,...Ze.map(Be=>Be.group)),fe.guide.length&&xe.add(Vv(fe,a));let Re=new an,Ge=Math.max(1,Math.floor(fe.n/400));for(let Be=0;Be<fe.n;Be+=Ge)Re.expandByPoint(new I(...fe.position.subarray(3*Be,3*Be+3)));W.union(Re.translate(xe.position));let Te=o.flights.length>1,ge=fe.part.map(()=>{let Be=document.createElement("span");return l.append(Be),Te&&(Be.style.color=fe.colour),Be});return{flight:fe,group:xe,robot:He,estimate:be,path:Le,arrows:Ze,shadow:Y,scale:pe,names:ge,ghost:Oe,contacts:[],movers:[]}});let de=o.flights.flatMap((fe,ue)=>fe.obstacles.filter(xe=>xe.track<0).map(xe=>Wv(xe,B[ue]))),ye=de.some(fe=>fe.kind==="ground")?o.floor:null;o.shadows=[],o.shades=Ov(o.flights.flatMap(fe=>fe.obstacles),a),Xv(de).forEach(fe=>{let ue=kv(fe,o.floor,ye);ue&&o.shadows.push(ue);for(let xe of[Hd(fe,a,o.shades,ye),ue])xe&&(xe.position.add(new I(...fe.moved??[0,0,0])),y.add(xe))}),b.forEach(fe=>{fe.movers=fe.flight.bodies.map((ue,xe)=>new ru(ue,fe.flight.obstacles.filter(Oe=>Oe.track===xe),a,o.shades,ye,o.floor));for(let ue of fe.movers)fe.group.add(ue.group)}),o.box=W.clone(),oe(),ye===null&&(W.min.z=o.floor,y.add(Hv(W,a))),te()}function Ee(){let B=Math.max(...o.flights.flatMap(j=>j.obstacles.filter(pe=>pe.kind==="ground").map(pe=>pe.centre[2])));if(Number.isFinite(B))return B;let W=1/0;for(let j of o.flights)for(let pe=2;pe<3*j.n;pe+=3)W=Math.min(W,j.position[pe]);return W-.45}function te(){let B=Math.max(...o.flights.map(Tu),0);c.replaceChildren();let W=(pe,de)=>{let ye=document.createElement("span");ye.className=`key ${pe}`,ye.textContent=de,c.append(ye)};if(o.flights.length>1&&o.flights.forEach(pe=>{W("robot",pe.label),c.lastChild.style.setProperty("--colour",pe.colour)}),o.estimate&&o.flights.some(Vr)&&W("estimate","estimated pose"),B>0&&o.forces){let pe=Au(B);W("force",`contact force, each at its point, ${pe} N is ${100*qv} cm`)}o.flights.some(pe=>pe.thrust.some(de=>de>0))&&W("thrust","thrust");let j=new Set(o.flights.flatMap(pe=>pe.obstacles.map(cl)));ie()!==o.compare&&W("words","overlaid: the obstacles are too wide to be put side by side"),o.magnified!==1&&W("travel",`arm travel × ${o.magnified}, not to scale`);for(let pe of j)W("obstacle",pe),c.lastChild.style.setProperty("--colour",o.shades?.get(pe)??a.wall)}function K(B,W){let j=new I,pe=[];for(let de of b)de.names.forEach((ye,fe)=>{let ue=de.contacts[fe];if(ye.hidden=!o.forces||!ue||ue.size<.5,ye.hidden)return;j.set(...ue.point).addScaledVector(new I(...ue.force),de.scale),j.add(de.group.position).project(f),ye.hidden=j.z>1||Math.abs(j.x)>1||Math.abs(j.y)>1,ye.textContent=`${ue.size.toFixed(ue.size<10?1:0)} N`;let xe=Math.min(Math.max((j.x+1)/2*B,24),B-24),Oe=Math.min(Math.max((1-j.y)/2*W-12,10),W-10),He=Ze=>Ze>=10&&!pe.some(([Y,be])=>Math.abs(Y-xe)<50&&Math.abs(be-Ze)<18),Le=(de.ghost?[0,1,2,3]:[0]).map(Ze=>Oe-20*Ze).find(He);ye.hidden=Le===void 0,!ye.hidden&&(pe.push([xe,Le]),ye.style.transform=`translate(${xe}px, ${Le}px) translate(-50%, -50%)`)})}let ve=null,_e=null;function Ae(){let B=b.map(W=>W.robot.group.position.clone().add(W.group.position));return B.reduce((W,j)=>W.add(j),new I).divideScalar(B.length||1)}function We(B){if(o.t=B,o.poses=o.flights.map(W=>jo(W,B)),b.forEach((W,j)=>{let pe=o.poses[j];W.robot.show(pe,o.magnified),W.path.group.visible=o.path,W.path.show(pe.own),W.estimate&&(W.estimate.group.visible=o.estimate,o.estimate&&W.estimate.show(Eu(W.flight,B),o.magnified)),W.shadow.show(pe),W.movers.forEach((de,ye)=>de.show(pe.bodies[ye])),W.contacts=pe.contacts,W.arrows.forEach((de,ye)=>{let fe=pe.contacts[ye];fe&&o.forces?de.show(fe.point,fe.force.map(ue=>W.scale*ue)):de.hide()})}),u&&b.length&&o.camera==="impact"){let W=De();if(_e&&W.distanceTo(_e)>1e-9){let j=W.clone().sub(_e);f.position.add(j),d.target.add(j),d.update()}_e=W}if(u&&b.length&&LT.includes(o.camera)){let W=Ae();if(ve){let j=W.clone().sub(ve);f.position.add(j),d.target.add(j)}ve=W,d.update()}S()}function ut(B){let W=Xs.degToRad(f.fov/2),j=Math.min(1,f.aspect);return B/Math.sin(Math.atan(Math.tan(W)*j))}let H=()=>o.box.clone().expandByScalar(Math.max(...o.flights.map(Vd))+.1),lt=B=>.5*B.getSize(new I).length();function oe(){if(!u)return;let B=lt(H());d.maxDistance=Math.max(Zv,1.5*ut(B)),f.far=Math.max($v,2*d.maxDistance+2*B)}function we(B,W){d.target.copy(B),f.position.copy(B).add(W),d.update()}function Pe(B){if(o.camera=Go.includes(B)?B:"follow",ve=_e=null,s(o.camera),!u||!b.length)return;let W=Math.max(...o.flights.map(Vd)),j=b.map(He=>He.group.position),pe=j[0].distanceTo(j[j.length-1])/2,de=W+pe+ae()+.1,ye=z().length>2&&pe>0,fe=ye?Math.max(ut(W+.2),de/(Math.tan(Xs.degToRad(f.fov/2))*f.aspect)+W):ut(de),ue=H(),xe=ue.getCenter(new I),Oe=ye?$().negate().addScaledVector(q(),-.25).setZ(.5).normalize():new I(-.62,-.66,.42).normalize();if(o.camera==="free")we(xe,Oe.clone().multiplyScalar(ut(lt(ue))));else if(o.camera==="impact")we(_e=De(),ye?Oe.clone().multiplyScalar(fe):new I(-.45,-.62,.5).normalize().multiplyScalar(ut(de+.05)));else{ve=Ae();let He={follow:Oe,front:$().setZ(.12),side:q().negate().setZ(.12),top:new I(0,-.001,1)}[o.camera];we(ve.clone(),He.clone().normalize().multiplyScalar(o.camera==="side"?ut(de):fe))}S()}function at(B,W){let j=new I;return[0,B.n>>1,B.n-1].map(pe=>j.fromArray(B.position,3*pe).add(W.position).project(f).toArray())}function ae(){let B=b.map(({flight:W,robot:j})=>{let pe=b.filter(fe=>fe.flight.world===W.world);return pe.map(fe=>fe.robot.group.position.clone()).reduce((fe,ue)=>fe.add(ue),new I).divideScalar(pe.length).distanceTo(j.group.position)});return Math.min(Math.max(...B),CT)}function De(){let B=o.flights.map((W,j)=>{let pe=jo(W,Cp(W,o.t)??Cs(W)??W.begin);return new I(...pe.position).add(b[j].group.position)});return B.reduce((W,j)=>W.add(j),new I).divideScalar(B.length)}function je(){if(!u)return;let B=i.clientWidth,W=i.clientHeight;if(!B||!W)return;k(1),u.setSize(B,W,!1);let j=f.aspect;f.aspect=B/W,f.updateProjectionMatrix(),b.length&&oe(),M.set(B,W),b.forEach(pe=>pe.path.resize(M)),Math.abs(j/f.aspect-1)>.15&&Pe(o.camera),S()}let rt=new ResizeObserver(je);rt.observe(i);let U=matchMedia("(prefers-color-scheme: dark)"),w=()=>he(o.all);U.addEventListener("change",w);function G(){rt.disconnect(),U.removeEventListener("change",w),cancelAnimationFrame(_),clearTimeout(P),al(y),m.children.slice().forEach(al),d?.dispose(),u?.dispose(),i.replaceChildren()}return je(),e.length&&he(e,{keepCamera:!1}),{show:We,replace:he,setCamera:Pe,resize:je,dispose:G,setCompare(B){o.compare=B,o.flights.length&&he(o.all,{keepCamera:!1})},get compared(){return ie()},get wantedCompare(){return o.compare},get tooWide(){return ne()},setShown(B,W){if(typeof B!="number"){o[B]=W,te(),We(o.t);return}W?o.hidden.delete(B):o.hidden.add(B),he(o.all,{keepCamera:!1})},canvas(B=!0){return B&&u&&(k(1),V()),u?.domElement??null},setMagnified(B){o.magnified=B,te(),We(o.t)},get flights(){return o.flights},get all(){return o.all},get camera(){return o.camera},pose:()=>({t:o.t,camera:o.camera,target:d?.target.toArray(),pixels:o.share,flights:o.poses??[],places:b.map(({group:B,robot:W})=>W.group.position.clone().add(B.position).toArray()),ends:b.map(({robot:B})=>B.ends()),seen:b.map(({flight:B,group:W})=>at(B,W)),connections:b.map(({robot:B})=>B.connections()),estimates:o.estimate?o.flights.map(B=>Vr(B)?Eu(B,o.t):null):[]}),shadows:()=>[...o.shadows,...b.flatMap(({movers:B})=>B.map(({shadow:W})=>W))].map(B=>{B.updateWorldMatrix(!0,!0);let W=new an().setFromObject(B,!0);return[...W.min.toArray(),...W.max.toArray()]}),memory:()=>({...u?.info.memory})}}var DT={follow:"Follow",free:"Whole flight",front:"Front",side:"Side",top:"Top",impact:"Impact"},UT={1:"front",2:"side",3:"top",4:"follow",5:"free",6:"impact",0:"follow"},NT=[["space","play, pause"],["← →","one instant back, forth; with shift ten"],[", .","slower, faster"],["t","to the first touch"],["Home End","to the start, to the end"],["1 2 3","view from the front, from the side, from above"],["4 5 6","follow, whole flight, impact"],["0","the view as it was at first"],["e","estimated pose, on and off"],["f","full screen"],["p","save a picture"],["l","copy a link to this instant and view"],["a click in a plot","goes to that instant"],["a drag in a plot","zooms: along the time, the values, or both"],["a double click in a plot","shows everything"],["Escape","undoes the last zoom"],["?","these keys"]],Wd="springback.plots",FT=8e3;function Qv(i,e){let t=X("div",{class:"stage"}),n=X("div"),s=X("div",{class:"readouts"}),r=X("div"),o=X("p",{class:"remark",role:"status",hidden:!0}),a=!1,l=null,c=null,u=lu(t,{flights:e.flights,onCamera:oe=>(l?.mark(oe),We()),onDrawn:()=>c?.drawn()}),h=u.all,f=h.length>1,m=new Set(h.map(oe=>oe.world)).size,g=[...new Set(h.map(oe=>oe.scenario))],v=g.length>2?`${h.length} flights`:g.join(" and ");function p(oe){o.textContent=oe,o.hidden=!1,clearTimeout(p.ends),p.ends=setTimeout(()=>o.hidden=!0,FT)}let d=h.map((oe,we)=>BT(oe,f&&(Pe=>M(we,Pe))));l=Si("Camera",Go.map(oe=>[oe,DT[oe]]),"follow",oe=>u.setCamera(oe));let y=Si("Flights",[["side","side by side"],["ghost","overlaid"]],"side",oe=>(u.setCompare(oe),tr(y,u),We())),b=h.some(oe=>oe.arms.some(we=>we.compliant)),_=Si("Arm travel",[["1","arms to scale"],["10","arm travel × 10"]],"1",oe=>(u.setMagnified(Number(oe)),We())),C={forces:["Forces",!0],path:["Path",!0],...h.some(Vr)?{estimate:["Estimate",!1]}:{}},E=Object.fromEntries(Object.entries(C).map(([oe,[we,Pe]])=>[oe,mp(we,Pe,at=>(u.setShown(oe,at),We()),oe==="estimate"?"The pose that the pilot estimates, as a grey ghost (E)":"")])),P=X("div",{class:"choice",role:"group","aria-label":"Show"},...Object.values(E)),L=()=>h.flatMap((oe,we)=>d[we].shown?[]:[we+1]);function M(oe,we){if(!we&&L().length===h.length-1)return p("One flight is always shown.");d[oe].mark(we),u.setShown(oe,we),tr(y,u),_e.replace(),We()}let S=fv(r,{onSeek:oe=>(_e.pause(),_e.seek(oe)),onZoom:()=>(z(),We()),onEdit:oe=>A.open(S.wanted,oe),onRemove:oe=>Q(S.wanted.filter((we,Pe)=>Pe!==oe))}),A=Dp({signals:bl(h),standard:nr(h),onChoose:Q}),k=h.find(oe=>oe.impacts.length),O=()=>{let[oe,we]=k.impacts[0].map(at=>at+k.shift),Pe=.35*Math.min(we-oe,.2)+.004;return[oe-Pe,Math.min(we,oe+.3)+2*Pe]},V=oe=>!!(k&&oe)&&oe.every((we,Pe)=>Math.abs(we-O()[Pe])<1e-9),q=Si("Plots show",[["all","whole flight"],...k?[["impact","first impact"]]:[]],"all",oe=>oe==="all"?S.zoom():S.zoom(...O())),$=X("button",{type:"button",class:"undo",title:"Undo the last zoom (Escape)",disabled:!0,"aria-label":"Undo the last zoom",onclick:()=>S.back()},Yi("undo")),N=X("button",{type:"button",class:"adding",title:"Choose plots and signals",onclick:()=>A.open(S.wanted)},"Plots …");function z(){let{range:oe,heights:we}=S.zoomed,Pe=!Object.keys(we).length;q.mark(Pe&&!oe?"all":Pe&&V(oe)?"impact":""),$.disabled=!S.canGoBack}function Q(oe){S.choose(oe);try{oe?localStorage.setItem(Wd,ea(oe)):localStorage.removeItem(Wd)}catch{}We()}let ie=X("dialog",{class:"keys","aria-label":"Keys and mouse"},X("h2",{},"Keys and mouse"),X("table",{},...NT.map(([oe,we])=>X("tr",{},X("th",{scope:"row"},oe),X("td",{},we)))),X("form",{method:"dialog"},X("button",{class:"main"},"Close"))),ne=(oe,we,Pe,at)=>X("button",{type:"button",class:`tool tool-${oe}`,title:`${we}${at?` (${at})`:""}`,"aria-label":we,onclick:Pe},Yi(oe)),ce=ne("film","Record a film from here",()=>c.film()),he=X("div",{class:"left"},t,n),Me=wl(()=>he,()=>p("This browser refuses full screen.")),Ee=X("div",{class:"tools"},ne("link","Copy a link to this instant and view",te,"L"),ne("picture","Save a picture",()=>c.picture(),"P"),ce,Me.button,ne("help","Keys and mouse",()=>ie.showModal(),"?"));async function te(){let oe=Ae.address();try{await navigator.clipboard.writeText(oe),p("The link is copied.")}catch{p("The address of this page is now a link to this instant and view.")}}let ve={...Object.fromEntries(Object.entries(UT).map(([oe,we])=>[oe,()=>u.setCamera(we)])),f:Me.toggle,p:()=>c.picture(),l:te,"?":()=>ie.showModal(),e:()=>E.estimate?.click(),Escape:()=>S.back()};i.replaceChildren(X("header",{class:"top"},X("div",{class:f?"flights several":"flights"},X("h1",{},v),...d.map(oe=>oe.element)),X("div",{class:"views"},l,...m>1?[y]:[],...b?[_]:[],P)),X("main",{},he,X("aside",{},...kT(h),s,X("div",{class:"plot-head"},X("h2",{},"Over time"),q,$,N),r,...zT(h),HT(h))),A.element,ie),t.append(o),i.classList.add("replay");let _e=$h({scene:u,plots:S,bar:n,readouts:s,actions:ve,onRest:()=>(c?.rested(),We())});c=vp({scene:u,stage:t,player:_e,say:p,name:v.replace(/[^\p{L}\p{N}]+/gu,"-").slice(0,60),onRecording:oe=>{ce.classList.toggle("recording",oe),ce.setAttribute("aria-label",oe?"End the film":"Record a film from here")}}),n.querySelector(".buttons").append(Ee),_e.replace({keepTime:!1}),tr(y,u),k&&S.restore({range:O(),heights:{}}),z(),u.setCamera("follow");let Ae=Up({read:ut,apply:H});function We(){a&&!_e.playing&&Ae.renew()}function ut(){let{range:oe}=S.zoomed;return{t:_e.time.toFixed(6).replace(/0+$/,"").replace(/\.$/,""),camera:u.camera==="follow"?"":u.camera,speed:_e.pace==="auto"?"":_e.pace,arms:_.chosen==="10"?"10":"",compare:u.wantedCompare==="ghost"?"ghost":"",hide:L().join(),layers:Object.keys(C).filter(we=>E[we].on!==C[we][1]).join(),zoom:V(oe)||!oe&&!k?"":oe?oe.map(we=>we.toFixed(6)).join():"all",plots:ea(S.wanted)===ea(nr(h))?"":ea(S.wanted)}}function H(oe){let we=ae=>ae.split(",").map(Number);if(oe.hide){let ae=we(oe.hide);h.every((De,je)=>ae.includes(je+1))||h.forEach((De,je)=>d[je].shown===ae.includes(je+1)&&M(je,!ae.includes(je+1)))}oe.compare==="ghost"&&m>1&&y.press("ghost"),oe.arms==="10"&&b&&_.press("10");let Pe=(oe.layers??"").split(",");for(let ae of Object.keys(C))Pe.includes(ae)&&E[ae].on===C[ae][1]&&E[ae].click();Go.includes(oe.camera)&&u.setCamera(oe.camera);let at=oe.plots?Ru(oe.plots,h):[];at.length&&S.choose(at),oe.zoom==="all"?S.restore({range:null,heights:{}}):oe.zoom&&S.restore({range:we(oe.zoom),heights:{}}),(oe.speed==="auto"||Number(oe.speed)>0)&&_e.setPace(oe.speed),oe.t&&Number.isFinite(Number(oe.t))&&_e.seek(Number(oe.t))}let lt=OT(h);return lt.length&&S.choose(lt),Ae.follow(),a=!0,window.springback={scene:u,player:_e,plots:S,link:Ae,pose:()=>({...u.pose(),playing:_e.playing,pace:_e.pace})},matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{h.forEach((oe,we)=>d[we].element.style.setProperty("--colour",oe.colour)),_e.replace()}),window.springback}function OT(i){try{return Ru(localStorage.getItem(Wd)??"",i)}catch{return[]}}function BT(i,e){let t={shown:!0},n=e?X("button",{type:"button",class:"flight","aria-pressed":"true",title:"Hide or show this flight",onclick:()=>e(!t.shown)},i.label):X("b",{},i.label);return t.element=X("p",{class:`outcome ${i.success?"well":"badly"}`},n,X("span",{},` ${i.sentence}`)),t.element.style.setProperty("--colour",i.colour),t.mark=s=>{t.shown=s,n.setAttribute("aria-pressed",String(s)),t.element.classList.toggle("away",!s)},t}function zT(i){let e=i.flatMap(t=>t.touched.map(n=>X("p",{},i.length>1?`${t.label}: ${n}`:n)));return e.length?[X("details",{class:"about touched",open:i.length===1},X("summary",{},"Touched obstacles"),...e)]:[]}function kT(i){let e=i.flatMap(t=>t.warnings.map(n=>X("p",{},i.length>1?`${t.label}: ${n}`:n)));return e.length?[X("details",{class:"about warned",open:!0},X("summary",{},e.length>1?"Warnings":"Warning"),...e)]:[]}function HT(i){let e=i.flatMap(s=>[...s.notes.map(r=>`${s.label}: ${r}.`),s.shift?`${s.label} is shown ${Math.abs(s.shift).toFixed(3)} s ${s.shift<0?"earlier":"later"} than it flew, so that all touch at the same time.`:""]),t=Math.max(...i.map(s=>s.departure.position))*1e3;e.push(`Motion between the drawn instants is interpolated linearly: positions are within ${t<.01?"0.01":t.toFixed(2)} mm of the flight.`);let n=Math.max(...i.map(s=>s.every));return e.push("Signals that you choose are rounded to 1/65534 of their range."),n>1&&e.push(`Telemetry is shown at every tick near impacts and changes of phase, elsewhere at one tick in ${n}.`),X("details",{class:"about"},X("summary",{},"About this view"),...[...new Set(e)].filter(Boolean).map(s=>X("p",{},s)),X("p",{},"World axes: x north, y west, z up. Yellow arrows are the contact forces on cages and main body, including friction; the numbers show their vector sum, in which friction on two cages may cancel. Blue bars are the thrust of the rotors; dark discs are vertical shadows."))}var Xd=1e3,tx=(i,e)=>Number((Math.round(i/e)*e).toFixed(6));function hl(i,e){let{least:t,most:n,logarithmic:s}=i,r=s?Math.log(e/t)/Math.log(n/t):(e-t)/(n-t);return Math.min(Math.max(r,0),1)}function ex(i,e){let{least:t,most:n,step:s,logarithmic:r}=i,o=r?t*(n/t)**e:t+(n-t)*e,a=r?10**Math.max(Math.floor(Math.log10(o))-1,Math.log10(s)):s;return Math.min(Math.max(tx(o,Math.max(a,s)),t),n)}function VT(i,e){let t=`set-${i.name}`,n=i.unit.replace("^1.5","¹·⁵"),s=X("input",{type:"range",min:0,max:Xd,step:1,id:`${t}-slider`,"aria-label":i.label,oninput:()=>h(ex(i,Number(s.value)/Xd),{moving:!0}),onchange:()=>e(i.name,r.value,{settled:!0}),onkeydown:g=>{let v={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[g.key];if(!v)return;g.preventDefault();let p=Number(r.value);Number.isFinite(p)&&h(Math.min(Math.max(tx(p+v*i.step,i.step),i.least),i.most),{settled:!0})}}),r=X("input",{type:"text",inputmode:"decimal",id:t,autocomplete:"off",spellcheck:"false",maxlength:40,"aria-describedby":`${t}-words`,oninput:()=>e(i.name,r.value.trim(),{typing:!0}),onchange:()=>e(i.name,r.value.trim(),{settled:!0})}),o=X("p",{class:"words",id:`${t}-words`}),a=X("div",{class:"marks"},...i.marks.map((g,v)=>{let p=b=>String(b.value).length*.013+.01,d=i.marks.some((b,_)=>_<v&&Math.abs(hl(i,b.value)-hl(i,g.value))<p(b)+p(g)),y=X("button",{type:"button",class:d?"tight":"",title:`${g.value} ${n}, ${g.words}`,"aria-label":`${i.label} ${g.value} ${n}, ${g.words}`,onclick:()=>h(g.value,{settled:!0})},X("span",{},String(g.value)));return y.style.setProperty("--share",hl(i,g.value)),y})),l=X("div",{class:"slider-control","data-name":i.name},X("label",{for:t},i.label),X("span",{class:"field"},r,X("span",{class:"unit"},n)),X("div",{class:"rail"},s,a),o);function c(g){let v=Number(g);r.value.trim()!==String(g)&&(r.value=String(g)),Number.isFinite(v)&&(s.value=Math.round(hl(i,v)*Xd),s.setAttribute("aria-valuetext",`${g} ${n}`)),f("")}function u(){let g=i.marks.find(v=>v.value===Number(r.value));o.className=g?"words printed":"words",o.textContent=g?`= ${g.words}`:i.explains}function h(g,v){c(g),e(i.name,String(g),v)}function f(g){r.setAttribute("aria-invalid",String(!!g)),l.classList.toggle("wrong",!!g),g?o.textContent=g:u()}return l.title=i.explains,{element:l,show:c,tellProblem:f,pick:g=>h(ex(i,hl(i,g)),{settled:!0})}}function GT(i){let e=X("p",{class:"words"},i.explains);return{element:X("div",{class:"fixed-control","data-name":i.name},X("span",{class:"label"},i.label),e),show:()=>{},tellProblem:s=>e.textContent=s||i.explains}}function WT(i,e){let t=Object.keys(i.words).length>3,n=X("p",{class:"words"},i.explains),s=a=>e(i.name,a,{settled:!0});if(!t){let a=Si(i.label,Object.entries(i.words),i.default,s);return{element:X("div",{class:"picked","data-name":i.name,title:i.explains},X("span",{class:"label"},i.label),a),show:a.mark,tellProblem:()=>{}}}let r=X("select",{id:`set-${i.name}`,onchange:()=>s(r.value)},...Object.entries(i.words).map(([a,l])=>X("option",{value:a},l)));return{element:X("div",{class:"picked","data-name":i.name,title:i.explains},X("label",{for:`set-${i.name}`},i.label),r,n),show:a=>r.value=a,tellProblem:a=>n.textContent=a||i.explains}}var XT={slider:VT,fixed:GT,choice:WT};function nx(i,e){let t={},n={},s=new Map,r=(v,p,d)=>{t[v]=p,l(),e(v,p,d)};for(let v of i)t[v.name]=String(v.default),n[v.name]=XT[v.kind](v,r),s.has(v.group)||s.set(v.group,[]),s.get(v.group).push(n[v.name].element);let o=[...s].map(([v,p])=>X("section",{},...v?[X("h2",{},v)]:[],...p)),a=X("form",{class:"controls",onsubmit:v=>v.preventDefault()},...o);function l(){for(let v of i){let p=Object.entries(v.when).every(([d,y])=>y.includes(t[d]));n[v.name].element.hidden=!p}o.forEach(v=>v.hidden=![...v.querySelectorAll("[data-name]")].some(p=>!p.hidden))}function c(v){for(let[p,d]of Object.entries(v))t[p]=String(d),n[p]?.show(d);l()}function u(v){let p=new URLSearchParams(v);c(Object.fromEntries(i.map(({name:d,words:y,default:b})=>{let _=p.get(d);return[d,_===null||y&&!(_ in y)?b:_]})))}function h(v){for(let p of Object.values(n))p.tellProblem("");for(let p of v){let d=p.split(":")[0],y=d in n?d:i.find(b=>b.path===d)?.name;n[y]?.tellProblem(p.slice(d.length+1).trim())}}let f=()=>i.filter(v=>t[v.name]!==String(v.default)).map(v=>`${v.name}=${encodeURIComponent(t[v.name])}`).join("&");return l(),{element:a,values:t,query:f,show:c,showQuery:u,tellProblems:h,isShown:v=>!n[v].element.hidden,pick:(v,p)=>n[v].pick(p)}}function ix(i,e){let t=null,n=!1,s=0;function r(l,c){clearTimeout(s),t={query:l,how:c},n||o()}async function o(){let{query:l,how:c}=t;t=null,n=!0;try{await a(l,c)}catch{t||e.gone()}n=!1,t&&o()}async function a(l,c){let u=await fetch(`flight?${l}`,{headers:{"x-lab-page":i}}),h=await u.json();if(u.ok)e.answered(h,{...c,older:t!==null});else if(u.status===503){if(t)return;h.preparing&&e.waits(h.preparing),s=setTimeout(()=>r(l,{...c,since:performance.now()}),700)}else!h.overtaken&&!t&&e.refused(h.errors,c)}return{ask:r}}var sx=100,qT=16,ul="Energy",rx=[-.01,.13],YT={motion:["#0072b2",.85],"arm springs":["#56b4e9",.85],"end stops":["#cc79a7",.85],contact:["#009e73",.85],"lost in arms":["#e69f00",.6],"lost in contact":["#d55e00",.6],"lost in friction":["#8c8c8c",.6],"lost in stops":["#cc79a7",.4],"lost in locking":["#444444",.4],"lost to air":["#bbbbbb",.4],"moving obstacles":["#b3a100",.75],"lost in obstacles":["#b3a100",.35],"to driven obstacles":["#6b4fa0",.5],"to the other robot":["#6b4fa0",.5]},ox={"put in":{width:1.6,dash:[6,3]},"by driven obstacles":{width:1.4,dash:[2,3]},"by the other robot":{width:1.4,dash:[2,3]}},ax=(i,e)=>i+Math.round(255*e).toString(16).padStart(2,"0");function qd(i,e=[1,1.5,2,3,5,7,10]){if(!(i>0))return 1;let t=10**Math.floor(Math.log10(i));return t*e.find(n=>n*t>=i*.999999)}function Yd(i,e,t,{moving:n=!1,locked:s=!1}={}){if(i&&s)return i;let r=[e<-1e-9?-qd(-e):0,t>1e-9?qd(t):e<-1e-9?0:1],[o,a]=i??r,l=e>=o&&t<=a&&(n||t-e>.3*(a-o));return i&&l?i:n?[Math.min(o,r[0]),Math.max(a,r[1])]:r}function $T(i,e,t){let n=0,s=0;for(let{t:r,values:o}of i)for(let a=0;a<o.length;a++)r[a]<e||r[a]>t||(o[a]<n&&(n=o[a]),o[a]>s&&(s=o[a]));return[n,s]}function ZT(i,e){let t=new Map,n=(a,l,c)=>{t.has(a)||t.set(a,{name:a,unit:l,curves:[],stacked:a.startsWith(ul)}),t.get(a).curves.push(c)},s=(a,l)=>{let c=Array.from(a.t,h=>h+a.shift),u=null;for(let h of a.series)if(h.panel===ul){if(l)continue;if(ox[h.name]){n(`${ul}, ${a.label}`,h.unit,{name:h.name,t:c,values:Array.from(h.values),colour:Pn().ink,flight:a,over:!0,...ox[h.name]});continue}u=Array.from(h.values,(g,v)=>g+(u?u[v]:0));let[f,m]=YT[h.name]??["#8c8c8c",.5];n(`${ul}, ${a.label}`,h.unit,{name:h.name,t:c,values:u,colour:f,fill:ax(f,m),flight:a})}else n(h.panel,h.unit,{name:l?`${a.label}, pinned`:a.label,t:c,values:Array.from(h.values),flight:a,colour:l?ax(a.colour,.75):a.colour,dash:l?[3,3]:a.dash,behind:l})};i.forEach((a,l)=>{a.dash=l?[8,3]:[],s(a,!1)}),e.forEach(a=>s(a,!0));let r=i.map(a=>`${ul}, ${a.label}`),o=a=>["Acceleration","Arm compression",...r,"Velocity","Contact force"].indexOf(a.name);return[...t.values()].sort((a,l)=>o(a)-o(l))}function lx(i,{onSeek:e}){let t=new Map,n=[],s=[],r=0,o=null,a=!1;i.classList.add("plots");function l(p,{whole:d=!1,moving:y=!1}={}){s=p;let b=Cs(p[0]),[_,C]=[p[0].begin,p[0].end];o=d||b===null?[_,C]:[b+rx[0],Math.min(b+rx[1],C)];let E=b??0,P=ZT(p,n);for(let[L,M]of t)P.some(S=>S.name===L&&c(S,d)===M.signature)||(M.plot.destroy(),M.box.remove(),t.delete(L));for(let L of P){let M=t.get(L.name)??f(L,d);M.panel=L,M.zero=E,M.bounds=Yd(M.bounds,...$T(L.curves,...o),{moving:y,locked:a}),M.plot.batch(()=>{M.plot.setData(u(L),!1),M.plot.setScale("x",{min:o[0],max:o[1]}),M.plot.setScale("y",{min:M.bounds[0],max:M.bounds[1]})}),i.append(M.box)}g(r)}let c=(p,d)=>`${d} ${p.curves.map(y=>`${y.name} ${y.colour}`).join()}`;function u(p){let y=p.curves.every(b=>b.flight===p.curves[0].flight)?[p.curves[0].t,...p.curves.map(b=>b.values)]:Kt.join(p.curves.map(b=>[b.t,b.values]));return[y[0],...h(p,y.slice(1))]}function h(p,d){if(!p.stacked)return d;let y=p.curves.map(b=>!!b.over);return[...d.filter((b,_)=>!y[_]).reverse(),...d.filter((b,_)=>y[_])]}function f(p,d){let y=Pn(),b=!p.stacked||p.curves[0].flight===s[0],_=p.curves.filter(()=>b).map(O=>{let V=document.createElementNS("http://www.w3.org/2000/svg","svg");V.setAttribute("viewBox","0 0 22 8"),V.setAttribute("aria-hidden","true");let q=document.createElementNS("http://www.w3.org/2000/svg","line"),$={x1:0,x2:22,y1:4,y2:4,stroke:O.fill??O.colour,"stroke-width":O.fill?8:2.4,"stroke-dasharray":(O.dash??[]).join(" ")};return Object.entries($).forEach(([N,z])=>q.setAttribute(N,z)),V.append(q),X("span",{class:"plot-key"},V,X("span",{},O.name))}),C=X("div",{class:"plot-canvas"}),E=X("section",{class:"plot","data-panel":p.name},X("header",{},X("h3",{},`${p.name} [${p.unit}]`),X("div",{class:"plot-keys"},..._)),C);i.append(E);let P={box:E,canvas:C,panel:p,signature:c(p,d),bounds:null,zero:0},L={stroke:y.faint,grid:{stroke:y.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},M=h(p,p.curves),S=M.filter(O=>!O.over),A=(O,V)=>V.map(q=>String(d?+q.toFixed(3):Math.round(1e3*(q-P.zero)))),k=(O,V,q,$)=>KT(q,$,P.zero,d);return P.plot=new Kt({width:Math.max(C.clientWidth,200),height:sx,padding:[6,10,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[{...L,size:22,gap:2,values:A,splits:k},{...L,size:46,gap:4,space:qT}],series:[{},...M.map(O=>({stroke:O.colour,width:O.width??(O.fill?1:O.behind?1.4:1.8),dash:O.dash??[],fill:O.fill,spanGaps:!0,points:{show:!1}}))],hooks:{draw:[()=>m(P)]},bands:p.stacked?S.slice(1).map((O,V)=>({series:[V+1,V+2],fill:S[V].fill})):[]},u(p),C),P.marker=X("div",{class:"plot-now"}),P.plot.over.append(P.marker),P.plot.over.addEventListener("click",O=>e(P.plot.posToVal(O.offsetX,"x"))),t.set(p.name,P),P}function m({plot:p,marker:d}){if(!d)return;let{min:y,max:b}=p.scales.x;d.hidden=!(r>=y&&r<=b),d.style.transform=`translateX(${p.valToPos(r,"x")}px)`}function g(p){r=p,t.forEach(m)}function v(){for(let{plot:p,canvas:d}of t.values()){let y=d.clientWidth;y&&Math.abs(y-p.width)>1&&p.setSize({width:y,height:sx})}g(r)}return new ResizeObserver(v).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{t.forEach(({plot:p,box:d})=>(p.destroy(),d.remove())),t.clear()}),{replace:l,show:g,pin(p){n=p},lock(p){a=p},bounds:p=>t.get(p)?.bounds,curve:p=>t.get(p)?.panel.curves.map(d=>({name:d.name,peak:d.values.reduce((y,b)=>Math.max(y,b),0),points:d.values.length})),get flights(){return s}}}function KT(i,e,t,n){let s=n?qd((e-i)/8,[1,2,5,10]):.02,r=[];for(let o=Math.ceil((i-t*!n)/s);;o++){let a=o*s+(n?0:t);if(a>e)return r;r.push(a)}}var cx=150,JT=700,jT=40;function hx(i,{choices:e,table:t,page:n,isShown:s,onPick:r,onChoice:o}){let a=new Map,l=null,c=null,u=null,h=null,f=0,m="",g=X("select",{id:"sweep-of","aria-label":"Control to sweep",onchange:E}),v=X("select",{id:"sweep-measure","aria-label":"Measure of the sweep",onchange:E},...e.measures.map(N=>X("option",{value:N.name},N.label)));v.value="impact_peak_acceleration";let p=X("div",{class:"plot-canvas"}),d=X("h3"),y=X("p",{class:"words",role:"status"});i.classList.add("sweep"),i.replaceChildren(X("div",{class:"sweep-head"},X("h2",{},"Sweep"),g,v),d,p,y),C();let b=N=>t.find(z=>z.name===N),_=()=>e.measures.find(N=>N.name===v.value);function C(){let N=g.value,z=e.controls.filter(ie=>s(ie.name)||ie.name===N),Q=["",...z.map(ie=>ie.name)].join();g.dataset.names!==Q&&(g.dataset.names=Q,g.replaceChildren(X("option",{value:""},"off"),...z.map(ie=>X("option",{value:ie.name},ie.label))),g.value=N)}function E(){h=null,L(l,{}),o()}function P(N){return N.split("&").filter(z=>z&&z.split("=")[0]!==g.value).join("&")}function L(N,{moving:z=!1}){if(l=N,C(),clearTimeout(f),!l||!g.value)return A("");if(l.is_piloted)return A("Flights with a pilot are not swept here; a campaign can: springback campaign.");if(!s(g.value))return A("This control has no effect here.");let Q=`${g.value}?${P(l.query)}`;a.has(Q)?(c=a.get(Q),S()):z||M(Q),V(!a.has(Q))}async function M(N){m=N;let[z,Q]=N.split(/\?(.*)/s);y.textContent="Flying the sweep …";try{let ie=await fetch(`sweep?${[Q,`of=${z}`].filter(Boolean).join("&")}`,{headers:{"x-lab-page":n}}),ne=await ie.json();if(m!==N)return;if(ie.ok)a.size>=jT&&a.delete(a.keys().next().value),a.set(N,ne),L(l,{});else if(ie.status===503){let ce=ne.preparing;y.textContent=ce?`Compiling for ${ce.what}, about ${ce.about} s, once on this machine: ${Math.round(ce.waited)} s so far.`:"Too many requests are waiting.",f=setTimeout(()=>M(N),JT)}else ne.overtaken||A(ne.errors.join(" "))}catch{y.textContent="The lab does not respond."}}function S(){let N=c.refusals.reduce((ne,ce)=>ne+ce.count,0),z=Object.keys(c.labels).length>1?c.labels:{},Q=ne=>Number(ne.toPrecision(3)),ie=c.refusals.map(({robot:ne,from:ce,to:he,why:Me})=>` ${z[ne]?`${z[ne]}, `:""}${ce===he?"":`${Q(ce)} to `}${Q(he)} ${b(c.of).unit}: ${Me}.`);y.textContent=N?`${N} of ${c.at.length*Object.keys(c.labels).length} points cannot be flown.${ie.join("")}`:`${c.at.length} flights for each robot in ${c.took.toFixed(0)} ms. A click sets the value.`}function A(N){m="",c=null,d.textContent="",u?.destroy(),u=null,y.textContent=N,i.classList.toggle("off",!g.value)}function k(){let N=l.measures.find(z=>z.name===v.value);return l.flights.map((z,Q)=>({robot:z.robot,label:z.label,colour:Pn().robots[O(Q)],dash:Q?[8,3]:[],x:l.settings[g.value],y:N?.values[z.robot]??null}))}let O=N=>l.flights.length===1&&l.flights[0].robot==="quad"?1:N%2;function V(N){if(i.classList.remove("off"),!c||c.of!==g.value)return u&&(u.destroy(),u=null);let z=k(),Q=b(g.value),ie=z.map(Me=>c.measures[v.value][Me.robot]??c.at.map(()=>null)),ne=[...ie.flat(),...z.map(Me=>Me.y)].filter(Me=>Me!==null);h=Yd(h,Math.min(0,...ne),Math.max(0,...ne));let ce=_();d.textContent=ce.unit?`${ce.label} [${ce.unit}]`:ce.label;let he=JSON.stringify([Q.name,v.value,z.map(Me=>[Me.label,Me.colour])]);u?.look!==he&&q(Q,z,he),u.batch(()=>{u.setData([c.at,...ie],!1),u.setScale("x",{min:Q.least,max:Q.most}),u.setScale("y",{min:h[0],max:h[1]})}),u.points=z,p.classList.toggle("old",N),$()}function q(N,z,Q){u?.destroy();let ie=Pn(),ne={stroke:ie.faint,grid:{stroke:ie.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ce=N.unit?` [${N.unit.replace("^1.5","¹·⁵")}]`:"",he={...ne,size:24,gap:6,label:`${N.label}${ce}`,labelSize:15,labelFont:ne.font,labelGap:0};N.logarithmic&&Object.assign(he,{splits:(Me,Ee,te,K)=>QT(te,K),values:(Me,Ee)=>Ee.map(String),filter:(Me,Ee)=>Ee}),u=new Kt({width:Math.max(p.clientWidth,200),height:cx,padding:[8,12,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1,distr:N.logarithmic?3:1,range:[N.least,N.most]},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[he,{...ne,size:46,gap:4,space:26}],series:[{},...z.map(Me=>({stroke:Me.colour,width:1.8,dash:Me.dash,points:{show:!1}}))],hooks:{draw:[$]}},[[N.least,N.most],...z.map(()=>[null,null])],p),u.look=Q,u.line=X("div",{class:"plot-now"}),u.dots=z.map(Me=>{let Ee=X("div",{class:"sweep-point",title:Me.label});return Ee.style.background=Me.colour,Ee}),u.over.append(u.line,...u.dots),u.over.addEventListener("click",Me=>r(N.name,u.posToVal(Me.offsetX,"x")))}function $(){if(!u?.points)return;let N=_();u.line.style.transform=`translateX(${u.valToPos(u.points[0].x,"x")}px)`,u.points.forEach(({x:z,y:Q,label:ie},ne)=>{let ce=u.dots[ne];ce.hidden=Q===null,Q!==null&&(ce.title=`${ie}: ${Number(Q.toPrecision(4))} ${N.unit}`,ce.style.transform=`translate(${u.valToPos(z,"x")}px, ${u.valToPos(Q,"y")}px)`)})}return new ResizeObserver(()=>{let N=p.clientWidth;u&&N&&Math.abs(N-u.width)>1&&u.setSize({width:N,height:cx})}).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>l&&L(l,{})),{show:L,hash:()=>g.value?`#sweep=${g.value},${v.value}`:"",restore(N){let[z,Q]=(N.match(/^#sweep=([a-z_]+),([a-z_]+)$/)??[]).slice(1),ie=(ne,ce)=>ne.some(he=>he.name===ce);g.dataset.names="",g.replaceChildren(X("option",{value:""},"off"),...e.controls.map(ne=>X("option",{value:ne.name},ne.label))),g.value=ie(e.controls,z)?z:"",ie(e.measures,Q)&&(v.value=Q),h=null,l&&L(l,{})},state:()=>({of:g.value,measure:v.value,curve:c,points:u?.points??[],bounds:h,words:y.textContent})}}function QT(i,e){let t=[];for(let n=Math.floor(Math.log10(i));n<=Math.log10(e);n++)for(let s of[1,2,5]){let r=Number((s*10**n).toPrecision(3));r>=i&&r<=e&&t.push(r)}return t}var $d=i=>{if(i==null)return"–";if(typeof i=="string")return i;let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)};function ux(i){function e(t,n,s){let r=t.flights.map(m=>[m.robot,m.label]),o=m=>n?.flights.some(g=>g.robot===m),a=t.measures.some(m=>Object.keys(m.printed).length),l=X("tr",{},X("th",{},""));for(let[m,[g,v]]of r.entries()){let p=X("th",{scope:"col"},v);p.style.color=s[m],l.append(p),a&&l.append(X("th",{scope:"col",class:"printed"},"paper")),o(g)&&l.append(X("th",{scope:"col",class:"pinned"},"pinned"))}let c=t.measures.map(m=>{let g=n?.measures.find(p=>p.name===m.name),v=X("tr",{"data-measure":m.name},X("th",{scope:"row"},m.label,...m.unit?[X("small",{},` ${m.unit}`)]:[]));for(let[p]of r){let d=[a&&m.printed[p]?`paper ${m.printed[p]}`:"",o(p)?`pinned ${$d(g?.values[p])}`:""];v.append(X("td",{"data-robot":p,"data-beside":d.filter(Boolean).join(", ")},X("b",{},$d(m.values[p])))),a&&v.append(X("td",{class:"printed"},m.printed[p]??"")),o(p)&&v.append(X("td",{class:"pinned"},$d(g?.values[p])))}return v}),{words:u,same:h}=t.printed_for,f=a?[X("p",{class:h?"note":"note other"},h?u:`${u} The settings here differ.`)]:[];i.replaceChildren(X("table",{},X("thead",{},l),X("tbody",{},...c)),...f),i.classList.toggle("elsewhere",!h)}return{show:e}}var fx={impact:"Impact",follow:"Follow",side:"Side",top:"Top",free:"All"},eA=.012,tA=350;function dx(i,e){let t=Math.random().toString(36).slice(2),n=null,s=null,r=!1,o=[],a=nx(e.controls,ce),l=X("div",{class:"outcomes","aria-live":"polite"}),c=X("p",{class:"alert",role:"alert",hidden:!0}),u=X("input",{class:"link",readonly:!0,"aria-label":"Link to these settings",id:"link",onfocus:()=>u.select()}),h=X("button",{type:"button",id:"copy",onclick:we},"Copy link"),f=X("button",{type:"button",id:"pin","aria-pressed":"false",title:"Keep this flight behind the next ones for comparison",onclick:Pe},"Pin"),m=X("button",{type:"button",id:"reset",title:e.file?`Return to ${e.file}`:"Return to the paper's slider test",onclick:()=>oe("",{push:!0})},"Reset"),g=X("span",{class:"files"}),v=X("div",{class:"stage"}),p=X("div",{class:"preparing",role:"status",hidden:!0}),d=X("div"),y=X("div"),b=X("div",{class:"measures"}),_=X("div"),C=X("button",{type:"button",id:"lock","aria-pressed":"false",title:"Keep the vertical scales of all plots as they are",onclick:ve},"Lock y"),E=X("p",{class:"took"}),P=X("button",{type:"button",class:"drawer",id:"drawer","aria-expanded":"false",onclick:()=>at(!i.classList.contains("open"))},"Settings"),L=Si("Camera",Go.filter(ae=>fx[ae]).map(ae=>[ae,fx[ae]]),"impact",ae=>V.setCamera(ae)),M=Si("Two robots",[["side","side by side"],["ghost","overlaid"]],"side",ae=>(V.setCompare(ae),tr(M,V))),S=X("h2"),A=Si("Plots show",[["impact","impact"],["all","all"]],"impact",ae=>{r=ae==="all",n&&Ee()}),k=wl(()=>O,()=>_e(["This browser refuses full screen."])),O=X("div",{class:"middle"},X("div",{class:"frame"},v,X("div",{class:"views"},L,M,k.button),p),d,b);i.classList.add("lab"),i.replaceChildren(X("header",{class:"top"},X("div",{class:"said"},X("h1",{},"Impact lab",...e.file?[X("small",{},e.file)]:[]),l,c),X("div",{class:"actions"},f,m,g,X("span",{class:"linking"},u,h))),X("main",{},X("aside",{class:"settings",id:"settings"},a.element,E),O,X("aside",{class:"curves"},_,X("div",{class:"plot-head"},S,C,A),y)),P);let V=lu(v,{onCamera:ae=>L.mark(ae)}),q=lx(y,{onSeek:ae=>($.pause(),$.seek(ae))}),$=$h({scene:V,plots:{show:q.show,replace:()=>Ee()},bar:d,actions:{f:k.toggle}}),N=ux(b),z=hx(_,{choices:e.sweeps,table:e.controls,page:t,isShown:a.isShown,onPick:a.pick,onChoice:()=>n&&lt(n.query,{settled:!0})}),Q=ix(t,{answered:he,refused:Ae,waits:We,gone:ut}),ie=0,ne=!1;function ce(ae,De,je){clearTimeout(ie);let rt=()=>Q.ask(a.query(),{...je,since:performance.now()});je.typing?ie=setTimeout(rt,tA):rt()}function he(ae,De){let je=n;n=ae,i.classList.add("ready"),De.aside||_e([]),p.hidden=!0,!De.typing&&!De.older?a.show(ae.settings):a.tellProblems([]);let rt=!je||je.settings.mode!==ae.settings.mode,U=ae.flights.length!==je?.flights.length,w=ae.flights.flatMap(G=>G.second?[G.second]:[]);V.replace([...ae.flights.map(G=>G.scene),...w],{keepCamera:!rt&&!U}),M.hidden=ae.flights.length<2,tr(M,V),rt&&A.mark((r=ae.is_piloted)?"all":"impact"),ne=!!De.moving,$.replace({keepTime:!rt}),rt&&Me(),te(),K(),z.show(ae,De),g.replaceChildren(...ae.flights.map(G=>X("a",{class:"button",href:`scenario.toml?${[ae.query,`of=${G.robot}`].filter(Boolean).join("&")}`,download:G.file,title:`Scenario for springback fly, ${G.label}`},`${G.label}.toml`))),lt(ae.query,De),requestAnimationFrame(()=>{let G=performance.now()-De.since;o.push(G),E.textContent=`Flown in ${ae.took.flying.toFixed(0)} ms, answered in ${ae.took.all.toFixed(0)} ms, drawn after ${G.toFixed(0)} ms.`})}function Me(){let ae=Cs(V.flights[0]),De=!n.is_piloted,je=De?"impact":"follow";L.mark(je),V.setCamera(je),$.seek(ae===null?V.flights[0].begin:De?ae+eA:ae)}function Ee(){n&&(S.textContent=r?"Time [s]":"Time from touch [ms]",q.replace(V.flights,{whole:r,moving:ne}))}function te(){l.replaceChildren(...n.flights.map((ae,De)=>{let je=X("p",{class:`outcome ${ae.well?"well":"badly"}`},X("b",{},ae.label),ae.sentence.slice(ae.label.length));return je.style.setProperty("--colour",V.flights[De].colour),je}))}let K=()=>N.show(n,s,V.flights.map(ae=>ae.colour));function ve(){let ae=C.getAttribute("aria-pressed")!=="true";C.setAttribute("aria-pressed",String(ae)),q.lock(ae),Ee()}function _e(ae){c.hidden=!ae.length,c.textContent=ae.join(" ")}function Ae(ae,De){p.hidden=!0,a.tellProblems(ae),_e([...ae.map(je=>`${je}.`),n?"The previous flight is shown.":"The default flight is shown instead."]),n||Q.ask("",{since:performance.now(),aside:!0})}function We(ae){p.hidden=!1,p.replaceChildren(X("progress",{}),X("p",{},`Compiling for ${ae.what}, about ${ae.about} s: ${Math.round(ae.waited)} s so far.`),X("p",{class:"words"},`Once on this machine; ${n?"the previous flight stays, and ":""}other settings can be flown meanwhile if they are ready.`))}function ut(){_e(["The lab does not respond; it may have been stopped in its terminal. Any change tries again."])}let H=!1;function lt(ae,{settled:De=!1,aside:je=!1,restored:rt=!1}){let U=`${location.pathname}${ae?`?${ae}`:""}${z.hash()}`;u.value=location.origin+U,!(je||rt)&&(`${location.pathname}${location.search}${location.hash}`!==U&&(H?history.replaceState(null,"",U):history.pushState(null,"",U)),H=!De)}function oe(ae,{push:De=!1}={}){a.showQuery(ae),Q.ask(ae,{since:performance.now(),settled:De,restored:!De})}addEventListener("popstate",()=>(z.restore(location.hash),oe(location.search.slice(1))));async function we(){try{await navigator.clipboard.writeText(u.value)}catch{u.select(),document.execCommand("copy")}h.textContent="Copied",setTimeout(()=>h.textContent="Copy link",1500)}function Pe(){s=s?null:n,f.setAttribute("aria-pressed",String(!!s)),f.textContent=s?"Unpin":"Pin";let ae=s?Gd(s.flights.map(De=>({...De.scene})),Pn()):[];q.pin(ae),Ee(),K()}function at(ae){i.classList.toggle("open",ae),P.setAttribute("aria-expanded",String(ae)),P.textContent=ae?"Done":"Settings",ae&&v.scrollIntoView({block:"start"})}return z.restore(location.hash),oe(location.search.slice(1)),window.springback={scene:V,player:$,plots:q,controls:a,sweep:z,latency:o,pose:()=>({...V.pose(),playing:$.playing,pace:$.pace}),get answer(){return n}},window.springback}var nA={replay:Qv,lab:dx};function px(){let i=nA[document.body.dataset.app],e=document.getElementById("data");i&&i(document.getElementById("app"),e?JSON.parse(e.textContent):{})}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",px):px();})();
