/*! springback, MIT licence; sources 64fc8e558525e72990f59c2e778affa2abdf5bfb6f804f8520bbd25d90272a8d

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
(()=>{var up=i=>{throw TypeError(i)};var v_=(i,e,t)=>e.has(i)||up("Cannot "+t);var ml=(i,e,t)=>e.has(i)?up("Cannot add the same private member more than once"):e instanceof WeakSet?e.add(i):e.set(i,t);var Rn=(i,e,t)=>(v_(i,e,"access private method"),t);function G(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==!1&&r!=null&&n.setAttribute(s,r);return n.append(...t),n}var __={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",back:"M18 5v14l-9.5-7zM5.5 5h2.4v14H5.5z",forth:"M6 5v14l9.5-7zM16.1 5h2.4v14h-2.4z",touch:"M4 4h3v16H4zM20 12l-9 6V6z",link:"M10.6 13.4a4 4 0 0 0 5.7 0l3-3a4 4 0 1 0-5.7-5.7l-1.6 1.6 1.4 1.4 1.6-1.6a2 2 0 1 1 2.9 2.9l-3 3a2 2 0 0 1-2.9 0zm2.8-2.8a4 4 0 0 0-5.7 0l-3 3a4 4 0 1 0 5.7 5.7l1.6-1.6-1.4-1.4-1.6 1.6a2 2 0 1 1-2.9-2.9l3-3a2 2 0 0 1 2.9 0z",picture:"M4 7h4l1.5-2.5h5L16 7h4v12H4zm8 2.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zm0 1.8a1.7 1.7 0 1 1 0 3.4 1.7 1.7 0 0 1 0-3.4z",undo:"M9 4 3.5 9.5 9 15v-4h5a3.5 3.5 0 0 1 0 7h-4v2.2h4a5.7 5.7 0 0 0 0-11.4H9z",film:"M3 6h12v12H3zM16.5 10.5 21 7.5v9l-4.5-3z",full:"M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z",help:"M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 12.5h2v2h-2zm1-9c-2 0-3.5 1.3-3.5 3.2h2c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.4-2.5 1.6-2.5 4.1v.3h2v-.2c0-1.4 2.5-1.8 2.5-4.3 0-1.8-1.5-3-3.5-3z"};function Yi(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",__[i]),t.setAttribute("fill-rule","evenodd"),e.append(t),e}function wi(i,e,t,n){let s=G("div",{class:"choice",role:"group","aria-label":i});for(let[a,l]of e)s.append(G("button",{type:"button","data-value":a,"aria-pressed":String(a===t),onclick:()=>{r(a),n(a)}},l));function r(a){for(let l of s.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))}let o=a=>(r(a),n(a));return Object.defineProperty(s,"chosen",{get:()=>s.querySelector("[aria-pressed=true]")?.dataset.value}),Object.assign(s,{mark:r,press:o})}function fp(i,e,t,n=""){let s=G("button",{type:"button",title:n,"aria-pressed":String(e),onclick:()=>{s.setAttribute("aria-pressed",String(!s.on)),t(s.on)}},i);return Object.defineProperty(s,"on",{get:()=>s.getAttribute("aria-pressed")==="true"}),s}var x_=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"],y_=30;function dp(i,e){let t=G("a",{href:URL.createObjectURL(i),download:e});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function vu(i,e,t,n=null){let s=e.getBoundingClientRect(),r=getComputedStyle(e);if(!s.width)return;let[o,a]=[s.left-t.left,s.top-t.top];i.fillStyle=r.backgroundColor,i.fillRect(o,a,s.width,s.height);let l=o+parseFloat(r.paddingLeft);if(n&&parseFloat(n.width)>0){let c=parseFloat(n.height);i.fillStyle=n.backgroundColor,i.fillRect(l,a+(s.height-c)/2,parseFloat(n.width),c),l+=parseFloat(n.width)+parseFloat(n.marginRight)}i.font=`${r.fontWeight} ${r.fontSize} ${r.fontFamily}`,i.textBaseline="middle",i.fillStyle=r.color,i.fillText(e.textContent,l,a+s.height/2+1,o+s.width-l)}function pp({scene:i,stage:e,player:t,name:n,say:s,onRecording:r=()=>{}}){let o=G("div",{class:"stage-clock","aria-hidden":"true"});e.append(o);let a=null,l=null;function c(){let p=Math.min(devicePixelRatio||1,2),m=G("canvas",{width:2*Math.round(e.clientWidth*p/2),height:2*Math.round(e.clientHeight*p/2)});return{canvas:m,pen:m.getContext("2d"),ratio:p}}function u({canvas:p,pen:m,ratio:v},g){o.textContent=`${i.pose().t.toFixed(4)} s`;let d=e.getBoundingClientRect();m.setTransform(1,0,0,1,0,0),m.drawImage(g,0,0,p.width,p.height),m.scale(v,v);let b=e.querySelector(".scene-legend"),M=b.getBoundingClientRect();m.fillStyle=getComputedStyle(b).backgroundColor,m.fillRect(M.left-d.left,M.top-d.top,M.width,M.height);for(let y of b.children)vu(m,y,d,getComputedStyle(y,"::before"));for(let y of e.querySelectorAll(".force-labels span:not([hidden])"))vu(m,y,d);vu(m,o,d)}function h(){let p=i.canvas();if(!p)return s("There is no picture without WebGL.");let m=c();u(m,p),m.canvas.toBlob(v=>{dp(v,`${n}-${i.pose().t.toFixed(4)}s.png`),s("The picture is among your downloads.")})}function f(){if(a)return a.stop();let p=window.MediaRecorder&&x_.find(v=>MediaRecorder.isTypeSupported(v));if(!p||!i.canvas()||!HTMLCanvasElement.prototype.captureStream)return s("This browser cannot record films. The command springback animate RESULT --out film.gif makes one, or film.mp4.");l=c(),u(l,i.canvas());let m=[];a=new MediaRecorder(l.canvas.captureStream(y_),{mimeType:p,videoBitsPerSecond:12e6}),a.ondataavailable=v=>m.push(v.data),a.onstop=()=>{[a,l]=[null,null],t.pause(),r(!1),dp(new Blob(m,{type:p}),`${n}.${p.includes("mp4")?"mp4":"webm"}`),s("The film is among your downloads. springback animate makes one without dropped frames.")},a.start(),r(!0),t.play()}return{picture:h,film:f,drawn(){l&&u(l,i.canvas(!1))},rested(){a?.state==="recording"&&!t.playing&&a.stop()},get recording(){return!!a}}}var b_=()=>matchMedia("(prefers-color-scheme: dark)").matches,M_={background:"#f3f5f8",ink:"#222222",faint:"#8c8c8c",line:"#c3cad4",wall:"#7d8794",mat:"#009e73",ground:"#a8aeb7",metal:"#5b6470",dark:"#30363d",arms:["#0072b2","#d98a00","#009e73","#cc79a7","#3a9bd9","#8c8c8c"],robots:["#0072b2","#d55e00","#007a5a","#a8488a","#8a6d00","#1b2a6b","#6b6b6b","#7a1f1f"],force:"#e69f00",thrust:"#56b4e9",before:"#8c8c8c"},w_={background:"#14181d",ink:"#e6e9ed",faint:"#9aa3ad",line:"#3a434e",wall:"#98a3b1",mat:"#2cc79a",ground:"#59626d",metal:"#aab4c0",dark:"#cdd4dc",arms:["#4ea8e0","#f0b429","#35c79b","#e29cc4","#8fd0f5","#a7b0ba"],robots:["#4ea8e0","#ff8a3d","#35c79b","#e29cc4","#e3cf57","#a9b4ff","#c9d1d9","#ff8f8f"],force:"#ffc13d",thrust:"#7cc8f2",before:"#a7b0ba"},kn=()=>b_()?w_:M_;var pi=Uint8Array,kr=Uint16Array,S_=Int32Array,mp=new pi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),gp=new pi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),E_=new pi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),vp=function(i,e){for(var t=new kr(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new S_(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},_p=vp(mp,2),xp=_p.b,T_=_p.r;xp[28]=258,T_[258]=28;var yp=vp(gp,0),A_=yp.b,HT=yp.r,yu=new kr(32768);for(St=0;St<32768;++St)ls=(St&43690)>>1|(St&21845)<<1,ls=(ls&52428)>>2|(ls&13107)<<2,ls=(ls&61680)>>4|(ls&3855)<<4,yu[St]=((ls&65280)>>8|(ls&255)<<8)>>1;var ls,St,Zo=(function(i,e,t){for(var n=i.length,s=0,r=new kr(e);s<n;++s)i[s]&&++r[i[s]-1];var o=new kr(e);for(s=1;s<e;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(t){a=new kr(1<<e);var l=15-e;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],u=e-i[s],h=o[i[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[yu[h]>>l]=c}else for(a=new kr(n),s=0;s<n;++s)i[s]&&(a[s]=yu[o[i[s]-1]++]>>15-i[s]);return a}),Ko=new pi(288);for(St=0;St<144;++St)Ko[St]=8;var St;for(St=144;St<256;++St)Ko[St]=9;var St;for(St=256;St<280;++St)Ko[St]=7;var St;for(St=280;St<288;++St)Ko[St]=8;var St,bp=new pi(32);for(St=0;St<32;++St)bp[St]=5;var St;var R_=Zo(Ko,9,1);var C_=Zo(bp,5,1),_u=function(i){for(var e=i[0],t=1;t<i.length;++t)i[t]>e&&(e=i[t]);return e},Si=function(i,e,t){var n=e/8|0;return(i[n]|i[n+1]<<8)>>(e&7)&t},xu=function(i,e){var t=e/8|0;return(i[t]|i[t+1]<<8|i[t+2]<<16)>>(e&7)},P_=function(i){return(i+7)/8|0},I_=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new pi(i.subarray(e,t))};var L_=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Ei=function(i,e,t){var n=new Error(e||L_[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Ei),!t)throw n;return n},D_=function(i,e,t,n){var s=i.length,r=n?n.length:0;if(!s||e.f&&!e.l)return t||new pi(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new pi(s*3));var c=function(Ge){var dt=t.length;if(Ge>dt){var k=new pi(Math.max(dt*2,Ge));k.set(t),t=k}},u=e.f||0,h=e.p||0,f=e.b||0,p=e.l,m=e.d,v=e.m,g=e.n,d=s*8;do{if(!p){u=Si(i,h,1);var b=Si(i,h+1,3);if(h+=3,b)if(b==1)p=R_,m=C_,v=9,g=5;else if(b==2){var E=Si(i,h,31)+257,I=Si(i,h+10,15)+4,D=E+Si(i,h+5,31)+1;h+=14;for(var S=new pi(D),w=new pi(19),T=0;T<I;++T)w[E_[T]]=Si(i,h+T*3,7);h+=I*3;for(var B=_u(w),H=(1<<B)-1,V=Zo(w,B,1),T=0;T<D;){var W=V[Si(i,h,H)];h+=W&15;var M=W>>4;if(M<16)S[T++]=M;else{var q=0,F=0;for(M==16?(F=3+Si(i,h,3),h+=2,q=S[T-1]):M==17?(F=3+Si(i,h,7),h+=3):M==18&&(F=11+Si(i,h,127),h+=7);F--;)S[T++]=q}}var z=S.subarray(0,E),J=S.subarray(E);v=_u(z),g=_u(J),p=Zo(z,v,1),m=Zo(J,g,1)}else Ei(1);else{var M=P_(h)+4,y=i[M-4]|i[M-3]<<8,P=M+y;if(P>s){l&&Ei(0);break}a&&c(f+y),t.set(i.subarray(M,P),f),e.b=f+=y,e.p=h=P*8,e.f=u;continue}if(h>d){l&&Ei(0);break}}a&&c(f+131072);for(var ne=(1<<v)-1,te=(1<<g)-1,ce=h;;ce=h){var q=p[xu(i,h)&ne],fe=q>>4;if(h+=q&15,h>d){l&&Ei(0);break}if(q||Ei(2),fe<256)t[f++]=fe;else if(fe==256){ce=h,p=null;break}else{var xe=fe-254;if(fe>264){var T=fe-257,Ie=mp[T];xe=Si(i,h,(1<<Ie)-1)+xp[T],h+=Ie}var Q=m[xu(i,h)&te],X=Q>>4;Q||Ei(3),h+=Q&15;var J=A_[X];if(X>3){var Ie=gp[X];J+=xu(i,h)&(1<<Ie)-1,h+=Ie}if(h>d){l&&Ei(0);break}a&&c(f+131072);var me=f+xe;if(f<J){var ve=r-J,ye=Math.min(J,me);for(ve+f<0&&Ei(3);f<ye;++f)t[f]=n[ve+f]}for(;f<me;++f)t[f]=t[f-J]}}e.l=p,e.p=ce,e.b=f,e.f=u,p&&(u=1,e.m=v,e.d=m,e.n=g)}while(!u);return f!=t.length&&o?I_(t,0,f):t.subarray(0,f)};var U_=new pi(0);var N_=function(i,e){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Ei(6,"invalid zlib data"),(i[1]>>5&1)==+!e&&Ei(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function Mp(i,e){return D_(i.subarray(N_(i,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var F_=typeof TextDecoder<"u"&&new TextDecoder,O_=0;try{F_.decode(U_,{stream:!0}),O_=1}catch{}var wp=i=>Uint8Array.from(atob(i),e=>e.charCodeAt(0));function B_(i,e){let t=Mp(wp(i.data));return i.columns.map(({low:n,step:s},r)=>{let o=2*e*r,a=new Float64Array(e);for(let l=0,c=0;l<e;l++)c=c+t[o+l]+256*t[o+e+l]&65535,a[l]=n+s*c;return a})}function Sp(i){let e=new Map;if(!i)return e;for(let t of["trajectory","telemetry"].filter(n=>i[n])){let n=i[t],s=new Float64Array(wp(n.t.data).buffer),r=null,o=[];n.columns.forEach(({name:a,unit:l,factor:c,group:u},h)=>e.set(a,{name:a,unit:l,group:u,t:s,held:t==="telemetry",words:i.words[a],get values(){return r??(r=B_(n,s.length)),r[h]},get shown(){return o[h]??(o[h]=c===1?this.values:this.values.map(f=>c*f)),o[h]}}))}return e}var z_={f4:Float32Array,f8:Float64Array,i4:Int32Array};function Zt(i){let e=Uint8Array.from(atob(i.data),t=>t.charCodeAt(0));return new z_[i.type](e.buffer)}function Ep(i){if(i.ready)return i;let e=Zt(i.t),t=Zt(i.force.at),n=new Int32Array(e.length).fill(-1);return t.forEach((s,r)=>n[s]=r),{...i,ready:!0,t:e,n:e.length,begin:e[0],end:e[e.length-1],position:Zt(i.position),attitude:Zt(i.attitude),armLength:Zt(i.arm_length),bends:Zt(i.bends),thrust:Zt(i.thrust),force:Zt(i.force.of),point:Zt(i.point.of),bodies:i.bodies.map(s=>({...s,position:Zt(s.position),attitude:Zt(s.attitude)})),rows:n,series:i.series.map(s=>({...s,values:Zt(s.values)})),signals:Sp(i.signals),every:i.signals?.telemetry?.every??1,shift:0}}function gl(i,e){let t=0,n=i.length-1;if(!(e>i[0]))return 0;for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return i[n]<=e?n:t}function Jo(i,e){let t=Math.min(Math.max(e-i.shift,i.begin),i.end),n=gl(i.t,t),s=Math.min(n+1,i.n-1),r=s>n?(t-i.t[n])/(i.t[s]-i.t[n]):0,o=(m,v,g)=>m[n*v+g]*(1-r)+m[s*v+g]*r,a=(m,v)=>Array.from({length:v},(g,d)=>o(m,v,d)),l=i.arms.length,c=m=>{let v=a(m,4),g=0;for(let b=0;b<4;b++)g+=m[n*4+b]*m[s*4+b];if(g<0)for(let b=0;b<4;b++)v[b]=m[n*4+b];let d=Math.hypot(...v);return v.map(b=>b/d)},u=i.rows[n],h=i.rows[s],f=[],p=i.part.length;for(let m=0;m<p;m++){let v=[0,0,0],g=null;for(let[b,M]of[[u,1-r],[h,r]]){if(b<0)continue;let y=(b*p+m)*3;for(let E=0;E<3;E++)v[E]+=M*i.force[y+E];let P=Array.from(i.point.subarray(y,y+3));P.some(E=>E!==0)&&(g=P)}let d=Math.hypot(...v);f.push(g&&d>1e-6?{part:i.part[m],force:v,size:d,point:g}:null)}return{t:t+i.shift,own:t,place:n,position:a(i.position,3),quaternion:c(i.attitude),armLengths:a(i.armLength,l),bends:i.bends.length?a(i.bends,l):[],thrust:a(i.thrust,i.rotors.length),contacts:f,bodies:i.bodies.map(m=>({position:a(m.position,3),quaternion:c(m.attitude)}))}}function jo({flight:i,t:e=i.t,values:t,held:n=!1},s){let r=Math.min(Math.max(s-i.shift,e[0]),e[e.length-1]),o=gl(e,r),a=n?o:Math.min(o+1,e.length-1),l=a>o?(r-e[o])/(e[a]-e[o]):0;return t[o]*(1-l)+t[a]*l}var Hr=i=>["est_x","est_qw"].every(e=>i.signals.has(e));function bu(i,e){let t=(r,o)=>{let a=i.signals.get(r);return a?jo({flight:i,...a,values:a.values},e):o},n=["w","x","y","z"].map(r=>t(`est_q${r}`)),s=Math.hypot(...n)||1;return{own:Math.min(Math.max(e-i.shift,i.begin),i.end),position:["x","y","z"].map(r=>t(`est_${r}`)),quaternion:n.map(r=>r/s),armLengths:i.arms.map((r,o)=>t(`hall${o+1}`,r.length)),bends:[],thrust:i.rotors.map(()=>0),contacts:[]}}function Cs(i){let e=i.first_touch??i.impacts[0]?.[0]??null;return e===null?null:e+i.shift}var vl=i=>i.map(Cs).find(e=>e!==null)??null;function Mu(i){let e=0;for(let t=0;t<i.force.length;t+=3)e=Math.max(e,Math.hypot(i.force[t],i.force[t+1],i.force[t+2]));return e}function Tp(i){let e=i.part.length;return Float32Array.from(i.rows,t=>{let n=[0,0,0];for(let s=0;t>=0&&s<3*e;s++)n[s%3]+=i.force[t*e*3+s];return Math.hypot(...n)})}function wu(i){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));return e*([5,2,1].find(t=>t*e<=i*1.0000001)??1)}var k_=.005,Vr=[[],[7,3],[2,3],[9,3,2,3],[12,4],[4,2,1,2],[14,3,2,3],[3,6]],Ap={"Arm compression":["largest",i=>Math.max(...i)],Thrust:["all rotors",i=>i.reduce((e,t)=>e+t,0)],Velocity:["speed",i=>i[0]],Energy:["motion",i=>i[0]],"Contact force":["sum of all contacts"]},tr=i=>[...new Set(i.flatMap(e=>e.series.map(t=>t.panel)))],_l=i=>new Map(i.flatMap(e=>[...e.signals])),Qo=i=>i.map(e=>Array.isArray(e)?e.join():e).join(";");function Su(i,e){let t=tr(e),n=_l(e);return i.split(";").flatMap(s=>t.includes(s)?[s]:xl(s.split(",").filter(r=>n.has(r)),n))}function xl(i,e){let t=new Map;for(let n of new Set(i)){let{unit:s,words:r}=e.get(n),o=r?n:s;t.set(o,[...t.get(o)??[],n])}return[...t.values()]}function Rp(i,e){return e.map(t=>Array.isArray(t)?V_(i,t):H_(i,t)).filter(t=>t.curves.length)}function H_(i,e){let t=kn(),n=i.map(o=>o.series.filter(a=>a.panel===e)),s=i.length>1?n.flatMap((o,a)=>G_(e,o,i[a])):W_(n[0]);s.forEach((o,a)=>{o.flight??(o.flight=i[0]),o.t=o.flight.t,o.colour??(o.colour=t.arms[a%t.arms.length]),o.dash??(o.dash=Vr[a%Vr.length])});let r=i.length>1?Ap[e]?.[0]:"";return{key:e,name:r?`${e}, ${r}`:e,unit:n.flat()[0]?.unit,own:null,curves:s}}function V_(i,e){let t=kn(),n=_l(i),s=i.length>1,r=e.flatMap((c,u)=>i.flatMap(h=>{let f=h.signals.get(c);if(!f)return[];let{t:p,shown:m,held:v}=f,g=s&&e.length===1?h.index:u;return[{name:s?e.length===1?h.label:`${h.label}, ${c}`:c,flight:h,t:p,values:m,held:v,dash:Vr[g%Vr.length],colour:s?h.colour:t.arms[u%t.arms.length]}]})),o=e.map(c=>n.get(c)),a=new Set(o.map(c=>c?.group)),l=e.length===1?e[0]:a.size===1?o[0].group:e.slice(0,3).join(", ")+(e.length>3?", …":"");return{key:e.join(),name:l,unit:o[0]?.unit,own:e,words:o[0]?.words,curves:r}}function G_(i,e,t){if(!e.length)return[];let[,n]=Ap[i]??["",r=>r[0]],s=i==="Contact force"?Tp(t):Float32Array.from(e[0].values,(r,o)=>n(e.map(a=>a.values[o])));return[{name:t.label,values:s,flight:t,colour:t.colour,dash:Vr[t.index%Vr.length]}]}function W_(i){let e=[];for(let t of i){let n=t.values.reduce((r,o)=>Math.max(r,Math.abs(o)),0),s=e.find(r=>{let o=k_*Math.max(n,r.peak);return r.values.every((a,l)=>Math.abs(a-t.values[l])<=o)});s?s.names.push(t.name):e.push({names:[t.name],values:t.values,peak:n})}return e.map(({names:t,values:n})=>({name:X_(t),values:n}))}function X_(i){let e=i.map(t=>t.match(/^(.*?)\s*(\d+)$/));return i.length<2||e.some(t=>!t||t[1]!==e[0][1])?i.join(", "):`${e[0][1]} ${e.map(t=>t[2]).join(", ")}`}function Cp({signals:i,standard:e,onChoose:t}){let n=G("input",{type:"search",placeholder:"est, N, phase, …","aria-label":"Search signals",oninput:b}),s=G("h2",{id:"chooser-title"}),r=G("span",{class:"count",role:"status"}),o=(E,I,D)=>G("label",{"data-words":`${E} ${I}`.toLowerCase()},G("input",{type:"checkbox",value:E,onchange:M}),E,...D?[G("small",{},D)]:[]),a=(E,...I)=>{let D=G("fieldset",{},G("legend",{},E),...I);return I.length>1&&D.firstChild.append(G("button",{type:"button",class:"small","aria-label":`All of ${E}, or none`,onclick:()=>{let S=[...D.querySelectorAll("label:not([hidden]) input")],w=!S.every(T=>T.checked);S.forEach(T=>T.checked=w),M()}},"all")),D},l=a("Standard plots",...e.map(E=>o(E,"standard"))),c=new Map;for(let{name:E,unit:I,group:D}of i.values()){let S=[D,I,I==="m/s²"?"acceleration":""].join(" ");c.set(D,[...c.get(D)??[],o(E,S,I)])}let u=G("div",{class:"signals"},l,...[...c].map(([E,I])=>a(E,...I))),h=G("p",{hidden:!0},"No signal of this flight matches."),f=G("form",{method:"dialog",onsubmit:y},s,G("p",{class:"hint"},"Signals of one unit share a plot. Names are those of the columns in the files of the result."),n,u,h,G("div",{class:"actions"},r,G("button",{type:"button",onclick:()=>(t(null),p.close())},"Only standard plots"),G("button",{type:"button",onclick:()=>p.close()},"Cancel"),G("button",{type:"submit",class:"main"},"Plot"))),p=G("dialog",{class:"chooser","aria-labelledby":"chooser-title"},f),m=[],v=null,g=E=>[...E.querySelectorAll("input[type=checkbox]:checked")].map(I=>I.value),d=()=>[...u.children].filter(E=>E!==l).flatMap(g);function b(){let E=n.value.toLowerCase().split(/\s+/).filter(Boolean);for(let I of u.children){let D=[...I.querySelectorAll("label")];D.forEach(S=>S.hidden=!E.every(w=>S.dataset.words.includes(w))),I.hidden=D.every(S=>S.hidden)||I===l&&v!==null}h.hidden=[...u.children].some(I=>!I.hidden)}function M(){let E=d(),I=xl(E,i).length;r.textContent=E.length?`${E.length} signal${E.length>1?"s":""} in ${I} plot${I>1?"s":""}`:""}function y(){let E=xl(d(),i);if(v!==null)t(m.flatMap((I,D)=>D===v?E:[I]));else{let I=g(l),D=m.filter(S=>Array.isArray(S)||I.includes(S));t([...D,...I.filter(S=>!m.includes(S)),...E])}}function P(E,I=null){[m,v]=[E,I];let D=I===null?E.filter(S=>!Array.isArray(S)):E[I];u.querySelectorAll("input").forEach(S=>S.checked=D.includes(S.value)),s.textContent=I===null?"Add plots":"Change a plot",n.value="",b(),M(),p.showModal(),n.focus()}return{element:p,open:P}}function yl(i,e){let t=()=>document.fullscreenElement?document.exitFullscreen():i().requestFullscreen().catch(e),n=G("button",{type:"button",class:"tool tool-full",hidden:!document.fullscreenEnabled,onclick:t},Yi("full"));function s(){let r=document.fullscreenElement?"Leave full screen":"Full screen";n.title=`${r} (F)`,n.setAttribute("aria-label",r)}return document.addEventListener("fullscreenchange",s),s(),{button:n,toggle:t}}function Pp({read:i,apply:e}){let t=0,n=location.hash,s=()=>{let a=Object.entries(i()).filter(([,l])=>l!=="");return`#${new URLSearchParams(a)}`.replace(/%2C/g,",").replace(/%3B/g,";")};function r(){clearTimeout(t),n=s();try{history.replaceState(null,"",n)}catch{}}addEventListener("hashchange",()=>{location.hash!==n&&o()});function o(){e(Object.fromEntries(new URLSearchParams(location.hash.slice(1))))}return{follow:o,renew(){clearTimeout(t),t=setTimeout(r,250)},address(){return r(),location.href.replace(/#.*/,"")+n}}}var Hs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Vs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},am=0,cf=1,lm=2;var hf=1,cm=2,Qi=3,gs=0,Gn=1,Wn=2,_s=0,ar=1,uf=2,ff=3,df=4,hm=5,Os=100,um=101,fm=102,dm=103,pm=104,mm=200,gm=201,vm=202,_m=203,Jl=204,jl=205,xm=206,ym=207,bm=208,Mm=209,wm=210,Sm=211,Em=212,Tm=213,Am=214,Pc=0,Ic=1,Lc=2,lr=3,Dc=4,Uc=5,Nc=6,Fc=7,pf=0,Rm=1,Cm=2,xs=0,Pm=1,Im=2,Lm=3,Dm=4,Um=5,Nm=6,Fm=7;var mf=300,gr=301,vr=302,Oc=303,Bc=304,Ha=306,Ql=1e3,Fs=1001,ec=1002,gi=1003,Om=1004;var Va=1005;var Ii=1006,zc=1007;var Gs=1008;var Fi=1009,gf=1010,vf=1011,bo=1012,kc=1013,Ws=1014,es=1015,Mo=1016,Hc=1017,Vc=1018,wo=1020,_f=35902,xf=35899,yf=1021,bf=1022,vi=1023,co=1026,So=1027,Mf=1028,Gc=1029,wf=1030,Wc=1031;var Xc=1033,Ga=33776,Wa=33777,Xa=33778,qa=33779,qc=35840,Yc=35841,$c=35842,Zc=35843,Kc=36196,Jc=37492,jc=37496,Qc=37808,eh=37809,th=37810,nh=37811,ih=37812,sh=37813,rh=37814,oh=37815,ah=37816,lh=37817,ch=37818,hh=37819,uh=37820,fh=37821,dh=36492,ph=36494,mh=36495,gh=36283,vh=36284,_h=36285,xh=36286;var ua=2300,tc=2301,Kl=2302,tf=2400,nf=2401,sf=2402;var Bm=3200,zm=3201;var Sf=0,km=1,ys="",Vn="srgb",cr="srgb-linear",fa="linear",Pt="srgb";var or=7680,Ef=7681;var Tf=517;var rf=519,Hm=512,Vm=513,Gm=514,Af=515,Wm=516,Xm=517,qm=518,Ym=519,nc=35044;var Rf="300 es",Pi=2e3,da=2001;var Zi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Cn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ip=1234567,ao=Math.PI/180,ho=180/Math.PI;function ps(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Cn[i&255]+Cn[i>>8&255]+Cn[i>>16&255]+Cn[i>>24&255]+"-"+Cn[e&255]+Cn[e>>8&255]+"-"+Cn[e>>16&15|64]+Cn[e>>24&255]+"-"+Cn[t&63|128]+Cn[t>>8&255]+"-"+Cn[t>>16&255]+Cn[t>>24&255]+Cn[n&255]+Cn[n>>8&255]+Cn[n>>16&255]+Cn[n>>24&255]).toLowerCase()}function it(i,e,t){return Math.max(e,Math.min(t,i))}function Cf(i,e){return(i%e+e)%e}function q_(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function Y_(i,e,t){return i!==e?(t-i)/(e-i):0}function la(i,e,t){return(1-t)*i+t*e}function $_(i,e,t,n){return la(i,e,1-Math.exp(-t*n))}function Z_(i,e=1){return e-Math.abs(Cf(i,e*2)-e)}function K_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function J_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function j_(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Q_(i,e){return i+Math.random()*(e-i)}function ex(i){return i*(.5-Math.random())}function tx(i){i!==void 0&&(Ip=i);let e=Ip+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function nx(i){return i*ao}function ix(i){return i*ho}function sx(i){return(i&i-1)===0&&i!==0}function rx(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function ox(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ax(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),f=o((e-n)/2),p=r((n-e)/2),m=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*p,a*c);break;case"YXY":i.set(l*p,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*p,a*u,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Ci(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Ct(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Xs={DEG2RAD:ao,RAD2DEG:ho,generateUUID:ps,clamp:it,euclideanModulo:Cf,mapLinear:q_,inverseLerp:Y_,lerp:la,damp:$_,pingpong:Z_,smoothstep:K_,smootherstep:J_,randInt:j_,randFloat:Q_,randFloatSpread:ex,seededRandom:tx,degToRad:nx,radToDeg:ix,isPowerOfTwo:sx,ceilPowerOfTwo:rx,floorPowerOfTwo:ox,setQuaternionFromProperEuler:ax,normalize:Ct,denormalize:Ci},Oe=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(it(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},sn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],p=r[o+1],m=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=f,e[t+1]=p,e[t+2]=m,e[t+3]=v;return}if(h!==v||l!==f||c!==p||u!==m){let g=1-a,d=l*f+c*p+u*m+h*v,b=d>=0?1:-1,M=1-d*d;if(M>Number.EPSILON){let P=Math.sqrt(M),E=Math.atan2(P,d*b);g=Math.sin(g*E)/P,a=Math.sin(a*E)/P}let y=a*b;if(l=l*g+f*y,c=c*g+p*y,u=u*g+m*y,h=h*g+v*y,g===1-a){let P=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=P,c*=P,u*=P,h*=P}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],p=r[o+2],m=r[o+3];return e[t]=a*m+u*h+l*p-c*f,e[t+1]=l*m+u*f+c*h-a*p,e[t+2]=c*m+u*p+a*f-l*h,e[t+3]=u*m-a*h-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),p=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h-f*p*m;break;case"YXZ":this._x=f*u*h+c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h+f*p*m;break;case"ZXY":this._x=f*u*h-c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h-f*p*m;break;case"ZYX":this._x=f*u*h-c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h+f*p*m;break;case"YZX":this._x=f*u*h+c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h-f*p*m;break;case"XZY":this._x=f*u*h-c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h+f*p*m;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=n+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>h){let p=2*Math.sqrt(1+n-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-n-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(it(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let p=1-t;return this._w=p*o+t*this._w,this._x=p*n+t*this._x,this._y=p*s+t*this._y,this._z=p*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,f=Math.sin(t*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},L=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Lp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Lp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this.z=it(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this.z=it(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Eu.copy(this).projectOnVector(e),this.sub(Eu)}reflect(e){return this.sub(Eu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(it(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Eu=new L,Lp=new sn,ct=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],p=n[5],m=n[8],v=s[0],g=s[3],d=s[6],b=s[1],M=s[4],y=s[7],P=s[2],E=s[5],I=s[8];return r[0]=o*v+a*b+l*P,r[3]=o*g+a*M+l*E,r[6]=o*d+a*y+l*I,r[1]=c*v+u*b+h*P,r[4]=c*g+u*M+h*E,r[7]=c*d+u*y+h*I,r[2]=f*v+p*b+m*P,r[5]=f*g+p*M+m*E,r[8]=f*d+p*y+m*I,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,p=c*r-o*l,m=t*h+n*f+s*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/m;return e[0]=h*v,e[1]=(s*c-u*n)*v,e[2]=(a*n-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=p*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Tu.makeScale(e,t)),this}rotate(e){return this.premultiply(Tu.makeRotation(-e)),this}translate(e,t){return this.premultiply(Tu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Tu=new ct;function Pf(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function pa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function $m(){let i=pa("canvas");return i.style.display="block",i}var Dp={};function uo(i){i in Dp||(Dp[i]=!0,console.warn(i))}function Zm(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Up=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Np=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function lx(){let i={enabled:!0,workingColorSpace:cr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=lo(s.r),s.g=lo(s.g),s.b=lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?fa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return uo("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return uo("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[cr]:{primaries:e,whitePoint:n,transfer:fa,toXYZ:Up,fromXYZ:Np,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Vn},outputColorSpaceConfig:{drawingBufferColorSpace:Vn}},[Vn]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:Up,fromXYZ:Np,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Vn}}}),i}var _t=lx();function ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function lo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Gr,ic=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Gr===void 0&&(Gr=pa("canvas")),Gr.width=e.width,Gr.height=e.height;let s=Gr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Gr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=pa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ms(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ms(t[n]/255)*255):t[n]=ms(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},cx=0,fo=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:cx++}),this.uuid=ps(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Au(s[o].image)):r.push(Au(s[o]))}else r=Au(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Au(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ic.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var hx=0,Ru=new L,Kn=class i extends Zi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Fs,s=Fs,r=Ii,o=Gs,a=vi,l=Fi,c=i.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:hx++}),this.uuid=ps(),this.name="",this.source=new fo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Oe(0,0),this.repeat=new Oe(1,1),this.center=new Oe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Ru).x}get height(){return this.source.getSize(Ru).y}get depth(){return this.source.getSize(Ru).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==mf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ql:e.x=e.x-Math.floor(e.x);break;case Fs:e.x=e.x<0?0:1;break;case ec:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ql:e.y=e.y-Math.floor(e.y);break;case Fs:e.y=e.y<0?0:1;break;case ec:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=mf;Kn.DEFAULT_ANISOTROPY=1;var It=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],m=l[9],v=l[2],g=l[6],d=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(m+g)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,y=(p+1)/2,P=(d+1)/2,E=(u+f)/4,I=(h+v)/4,D=(m+g)/4;return M>y&&M>P?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=E/n,r=I/n):y>P?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=E/s,r=D/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=I/r,s=D/r),this.set(n,s,r,t),this}let b=Math.sqrt((g-m)*(g-m)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(b)<.001&&(b=1),this.x=(g-m)/b,this.y=(h-v)/b,this.z=(f-u)/b,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=it(this.x,e.x,t.x),this.y=it(this.y,e.y,t.y),this.z=it(this.z,e.z,t.z),this.w=it(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=it(this.x,e,t),this.y=it(this.y,e,t),this.z=it(this.z,e,t),this.w=it(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(it(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},sc=class extends Zi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ii,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new It(0,0,e,t),this.scissorTest=!1,this.viewport=new It(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new Kn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:Ii,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new fo(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ki=class extends sc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ma=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=gi,this.minFilter=gi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var rc=class extends Kn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=gi,this.minFilter=gi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var yn=class{constructor(e=new L(1/0,1/0,1/0),t=new L(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ti.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ti.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ti.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ti):Ti.fromBufferAttribute(r,o),Ti.applyMatrix4(e.matrixWorld),this.expandByPoint(Ti);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),bl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),bl.copy(n.boundingBox)),bl.applyMatrix4(e.matrixWorld),this.union(bl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ti),Ti.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ea),Ml.subVectors(this.max,ea),Wr.subVectors(e.a,ea),Xr.subVectors(e.b,ea),qr.subVectors(e.c,ea),Ps.subVectors(Xr,Wr),Is.subVectors(qr,Xr),nr.subVectors(Wr,qr);let t=[0,-Ps.z,Ps.y,0,-Is.z,Is.y,0,-nr.z,nr.y,Ps.z,0,-Ps.x,Is.z,0,-Is.x,nr.z,0,-nr.x,-Ps.y,Ps.x,0,-Is.y,Is.x,0,-nr.y,nr.x,0];return!Cu(t,Wr,Xr,qr,Ml)||(t=[1,0,0,0,1,0,0,0,1],!Cu(t,Wr,Xr,qr,Ml))?!1:(wl.crossVectors(Ps,Is),t=[wl.x,wl.y,wl.z],Cu(t,Wr,Xr,qr,Ml))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ti).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ti).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(cs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},cs=[new L,new L,new L,new L,new L,new L,new L,new L],Ti=new L,bl=new yn,Wr=new L,Xr=new L,qr=new L,Ps=new L,Is=new L,nr=new L,ea=new L,Ml=new L,wl=new L,ir=new L;function Cu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ir.fromArray(i,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=e.dot(ir),c=t.dot(ir),u=n.dot(ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var ux=new yn,ta=new L,Pu=new L,Li=class{constructor(e=new L,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):ux.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ta.subVectors(e,this.center);let t=ta.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ta,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Pu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ta.copy(e.center).add(Pu)),this.expandByPoint(ta.copy(e.center).sub(Pu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},hs=new L,Iu=new L,Sl=new L,Ls=new L,Lu=new L,El=new L,Du=new L,hr=class{constructor(e=new L,t=new L(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,hs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=hs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(hs.copy(this.origin).addScaledVector(this.direction,t),hs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Iu.copy(e).add(t).multiplyScalar(.5),Sl.copy(t).sub(e).normalize(),Ls.copy(this.origin).sub(Iu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Sl),a=Ls.dot(this.direction),l=-Ls.dot(Sl),c=Ls.lengthSq(),u=Math.abs(1-o*o),h,f,p,m;if(u>0)if(h=o*l-a,f=o*a-l,m=r*u,h>=0)if(f>=-m)if(f<=m){let v=1/u;h*=v,f*=v,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Iu).addScaledVector(Sl,f),p}intersectSphere(e,t){hs.subVectors(e.center,this.origin);let n=hs.dot(this.direction),s=hs.dot(hs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,hs)!==null}intersectTriangle(e,t,n,s,r){Lu.subVectors(t,e),El.subVectors(n,e),Du.crossVectors(Lu,El);let o=this.direction.dot(Du),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ls.subVectors(this.origin,e);let l=a*this.direction.dot(El.crossVectors(Ls,El));if(l<0)return null;let c=a*this.direction.dot(Lu.cross(Ls));if(c<0||l+c>o)return null;let u=-a*Ls.dot(Du);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ut=class i{constructor(e,t,n,s,r,o,a,l,c,u,h,f,p,m,v,g){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,f,p,m,v,g)}set(e,t,n,s,r,o,a,l,c,u,h,f,p,m,v,g){let d=this.elements;return d[0]=e,d[4]=t,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=h,d[14]=f,d[3]=p,d[7]=m,d[11]=v,d[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/Yr.setFromMatrixColumn(e,0).length(),r=1/Yr.setFromMatrixColumn(e,1).length(),o=1/Yr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,p=o*h,m=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=p+m*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=m+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,p=l*h,m=c*u,v=c*h;t[0]=f+v*a,t[4]=m*a-p,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=p*a-m,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,p=l*h,m=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=m+p*a,t[1]=p+m*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,p=o*h,m=a*u,v=a*h;t[0]=l*u,t[4]=m*c-p,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=p*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,m=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=m*h+p,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*h+m,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,p=o*c,m=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=p*h-m,t[2]=m*h-p,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(fx,e,dx)}lookAt(e,t,n){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Ds.crossVectors(n,si),Ds.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Ds.crossVectors(n,si)),Ds.normalize(),Tl.crossVectors(si,Ds),s[0]=Ds.x,s[4]=Tl.x,s[8]=si.x,s[1]=Ds.y,s[5]=Tl.y,s[9]=si.y,s[2]=Ds.z,s[6]=Tl.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],p=n[13],m=n[2],v=n[6],g=n[10],d=n[14],b=n[3],M=n[7],y=n[11],P=n[15],E=s[0],I=s[4],D=s[8],S=s[12],w=s[1],T=s[5],B=s[9],H=s[13],V=s[2],W=s[6],q=s[10],F=s[14],z=s[3],J=s[7],ne=s[11],te=s[15];return r[0]=o*E+a*w+l*V+c*z,r[4]=o*I+a*T+l*W+c*J,r[8]=o*D+a*B+l*q+c*ne,r[12]=o*S+a*H+l*F+c*te,r[1]=u*E+h*w+f*V+p*z,r[5]=u*I+h*T+f*W+p*J,r[9]=u*D+h*B+f*q+p*ne,r[13]=u*S+h*H+f*F+p*te,r[2]=m*E+v*w+g*V+d*z,r[6]=m*I+v*T+g*W+d*J,r[10]=m*D+v*B+g*q+d*ne,r[14]=m*S+v*H+g*F+d*te,r[3]=b*E+M*w+y*V+P*z,r[7]=b*I+M*T+y*W+P*J,r[11]=b*D+M*B+y*q+P*ne,r[15]=b*S+M*H+y*F+P*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],p=e[14],m=e[3],v=e[7],g=e[11],d=e[15];return m*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*p-n*l*p)+v*(+t*l*p-t*c*f+r*o*f-s*o*p+s*c*u-r*l*u)+g*(+t*c*h-t*a*p-r*o*h+n*o*p+r*a*u-n*c*u)+d*(-s*a*u-t*l*h+t*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],p=e[11],m=e[12],v=e[13],g=e[14],d=e[15],b=h*g*c-v*f*c+v*l*p-a*g*p-h*l*d+a*f*d,M=m*f*c-u*g*c-m*l*p+o*g*p+u*l*d-o*f*d,y=u*v*c-m*h*c+m*a*p-o*v*p-u*a*d+o*h*d,P=m*h*l-u*v*l-m*a*f+o*v*f+u*a*g-o*h*g,E=t*b+n*M+s*y+r*P;if(E===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let I=1/E;return e[0]=b*I,e[1]=(v*f*r-h*g*r-v*s*p+n*g*p+h*s*d-n*f*d)*I,e[2]=(a*g*r-v*l*r+v*s*c-n*g*c-a*s*d+n*l*d)*I,e[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*p-n*l*p)*I,e[4]=M*I,e[5]=(u*g*r-m*f*r+m*s*p-t*g*p-u*s*d+t*f*d)*I,e[6]=(m*l*r-o*g*r-m*s*c+t*g*c+o*s*d-t*l*d)*I,e[7]=(o*f*r-u*l*r+u*s*c-t*f*c-o*s*p+t*l*p)*I,e[8]=y*I,e[9]=(m*h*r-u*v*r-m*n*p+t*v*p+u*n*d-t*h*d)*I,e[10]=(o*v*r-m*a*r+m*n*c-t*v*c-o*n*d+t*a*d)*I,e[11]=(u*a*r-o*h*r-u*n*c+t*h*c+o*n*p-t*a*p)*I,e[12]=P*I,e[13]=(u*v*s-m*h*s+m*n*f-t*v*f-u*n*g+t*h*g)*I,e[14]=(m*a*s-o*v*s-m*n*l+t*v*l+o*n*g-t*a*g)*I,e[15]=(o*h*s-u*a*s+u*n*l-t*h*l-o*n*f+t*a*f)*I,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,p=r*u,m=r*h,v=o*u,g=o*h,d=a*h,b=l*c,M=l*u,y=l*h,P=n.x,E=n.y,I=n.z;return s[0]=(1-(v+d))*P,s[1]=(p+y)*P,s[2]=(m-M)*P,s[3]=0,s[4]=(p-y)*E,s[5]=(1-(f+d))*E,s[6]=(g+b)*E,s[7]=0,s[8]=(m+M)*I,s[9]=(g-b)*I,s[10]=(1-(f+v))*I,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=Yr.set(s[0],s[1],s[2]).length(),o=Yr.set(s[4],s[5],s[6]).length(),a=Yr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Ai.copy(this);let c=1/r,u=1/o,h=1/a;return Ai.elements[0]*=c,Ai.elements[1]*=c,Ai.elements[2]*=c,Ai.elements[4]*=u,Ai.elements[5]*=u,Ai.elements[6]*=u,Ai.elements[8]*=h,Ai.elements[9]*=h,Ai.elements[10]*=h,t.setFromRotationMatrix(Ai),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Pi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),f=(t+e)/(t-e),p=(n+s)/(n-s),m,v;if(l)m=r/(o-r),v=o*r/(o-r);else if(a===Pi)m=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===da)m=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Pi,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),f=-(t+e)/(t-e),p=-(n+s)/(n-s),m,v;if(l)m=1/(o-r),v=o/(o-r);else if(a===Pi)m=-2/(o-r),v=-(o+r)/(o-r);else if(a===da)m=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Yr=new L,Ai=new Ut,fx=new L(0,0,0),dx=new L(1,1,1),Ds=new L,Tl=new L,si=new L,Fp=new Ut,Op=new sn,Di=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(it(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-it(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(it(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-it(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(it(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-it(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Fp.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Fp,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Op.setFromEuler(this),this.setFromQuaternion(Op,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Di.DEFAULT_ORDER="XYZ";var ga=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},px=0,Bp=new L,$r=new sn,us=new Ut,Al=new L,na=new L,mx=new L,gx=new sn,zp=new L(1,0,0),kp=new L(0,1,0),Hp=new L(0,0,1),Vp={type:"added"},vx={type:"removed"},Zr={type:"childadded",child:null},Uu={type:"childremoved",child:null},an=class i extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:px++}),this.uuid=ps(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new L,t=new Di,n=new sn,s=new L(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ut},normalMatrix:{value:new ct}}),this.matrix=new Ut,this.matrixWorld=new Ut,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ga,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.multiply($r),this}rotateOnWorldAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.premultiply($r),this}rotateX(e){return this.rotateOnAxis(zp,e)}rotateY(e){return this.rotateOnAxis(kp,e)}rotateZ(e){return this.rotateOnAxis(Hp,e)}translateOnAxis(e,t){return Bp.copy(e).applyQuaternion(this.quaternion),this.position.add(Bp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(zp,e)}translateY(e){return this.translateOnAxis(kp,e)}translateZ(e){return this.translateOnAxis(Hp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(us.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Al.copy(e):Al.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?us.lookAt(na,Al,this.up):us.lookAt(Al,na,this.up),this.quaternion.setFromRotationMatrix(us),s&&(us.extractRotation(s.matrixWorld),$r.setFromRotationMatrix(us),this.quaternion.premultiply($r.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Vp),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(vx),Uu.child=e,this.dispatchEvent(Uu),Uu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),us.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),us.multiply(e.parent.matrixWorld)),e.applyMatrix4(us),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Vp),Zr.child=e,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,e,mx),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,gx,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),p=o(e.animations),m=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};an.DEFAULT_UP=new L(0,1,0);an.DEFAULT_MATRIX_AUTO_UPDATE=!0;an.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ri=new L,fs=new L,Nu=new L,ds=new L,Kr=new L,Jr=new L,Gp=new L,Fu=new L,Ou=new L,Bu=new L,zu=new It,ku=new It,Hu=new It,$i=class i{constructor(e=new L,t=new L,n=new L){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ri.subVectors(e,t),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ri.subVectors(s,t),fs.subVectors(n,t),Nu.subVectors(e,t);let o=Ri.dot(Ri),a=Ri.dot(fs),l=Ri.dot(Nu),c=fs.dot(fs),u=fs.dot(Nu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,m=(o*u-a*l)*f;return r.set(1-p-m,m,p)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ds)===null?!1:ds.x>=0&&ds.y>=0&&ds.x+ds.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ds.x),l.addScaledVector(o,ds.y),l.addScaledVector(a,ds.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return zu.setScalar(0),ku.setScalar(0),Hu.setScalar(0),zu.fromBufferAttribute(e,t),ku.fromBufferAttribute(e,n),Hu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(zu,r.x),o.addScaledVector(ku,r.y),o.addScaledVector(Hu,r.z),o}static isFrontFacing(e,t,n,s){return Ri.subVectors(n,t),fs.subVectors(e,t),Ri.cross(fs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ri.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ri.cross(fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Kr.subVectors(s,n),Jr.subVectors(r,n),Fu.subVectors(e,n);let l=Kr.dot(Fu),c=Jr.dot(Fu);if(l<=0&&c<=0)return t.copy(n);Ou.subVectors(e,s);let u=Kr.dot(Ou),h=Jr.dot(Ou);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(n).addScaledVector(Kr,o);Bu.subVectors(e,r);let p=Kr.dot(Bu),m=Jr.dot(Bu);if(m>=0&&p<=m)return t.copy(r);let v=p*c-l*m;if(v<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(n).addScaledVector(Jr,a);let g=u*m-p*h;if(g<=0&&h-u>=0&&p-m>=0)return Gp.subVectors(r,s),a=(h-u)/(h-u+(p-m)),t.copy(s).addScaledVector(Gp,a);let d=1/(g+v+f);return o=v*d,a=f*d,t.copy(n).addScaledVector(Kr,o).addScaledVector(Jr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Km={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Us={h:0,s:0,l:0},Rl={h:0,s:0,l:0};function Vu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var at=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Vn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=_t.workingColorSpace){return this.r=e,this.g=t,this.b=n,_t.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=_t.workingColorSpace){if(e=Cf(e,1),t=it(t,0,1),n=it(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Vu(o,r,e+1/3),this.g=Vu(o,r,e),this.b=Vu(o,r,e-1/3)}return _t.colorSpaceToWorking(this,s),this}setStyle(e,t=Vn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Vn){let n=Km[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ms(e.r),this.g=ms(e.g),this.b=ms(e.b),this}copyLinearToSRGB(e){return this.r=lo(e.r),this.g=lo(e.g),this.b=lo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Vn){return _t.workingToColorSpace(Pn.copy(this),e),Math.round(it(Pn.r*255,0,255))*65536+Math.round(it(Pn.g*255,0,255))*256+Math.round(it(Pn.b*255,0,255))}getHexString(e=Vn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(Pn.copy(this),t);let n=Pn.r,s=Pn.g,r=Pn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(Pn.copy(this),t),e.r=Pn.r,e.g=Pn.g,e.b=Pn.b,e}getStyle(e=Vn){_t.workingToColorSpace(Pn.copy(this),e);let t=Pn.r,n=Pn.g,s=Pn.b;return e!==Vn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Us),this.setHSL(Us.h+e,Us.s+t,Us.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Us),e.getHSL(Rl);let n=la(Us.h,Rl.h,t),s=la(Us.s,Rl.s,t),r=la(Us.l,Rl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Pn=new at;at.NAMES=Km;var _x=0,Ji=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:_x++}),this.uuid=ps(),this.name="",this.type="Material",this.blending=ar,this.side=gs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Jl,this.blendDst=jl,this.blendEquation=Os,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new at(0,0,0),this.blendAlpha=0,this.depthFunc=lr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=rf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=or,this.stencilZFail=or,this.stencilZPass=or,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==ar&&(n.blending=this.blending),this.side!==gs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Jl&&(n.blendSrc=this.blendSrc),this.blendDst!==jl&&(n.blendDst=this.blendDst),this.blendEquation!==Os&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==lr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==rf&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==or&&(n.stencilFail=this.stencilFail),this.stencilZFail!==or&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==or&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Ui=class extends Ji{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new at(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Di,this.combine=pf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var nn=new L,Cl=new Oe,xx=0,Jt=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:xx++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=nc,this.updateRanges=[],this.gpuType=es,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Cl.fromBufferAttribute(this,t),Cl.applyMatrix3(e),this.setXY(t,Cl.x,Cl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix3(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix4(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyNormalMatrix(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.transformDirection(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Ci(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ct(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Ci(t,this.array)),t}setX(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Ci(t,this.array)),t}setY(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Ci(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Ci(t,this.array)),t}setW(e,t){return this.normalized&&(t=Ct(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array),r=Ct(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==nc&&(e.usage=this.usage),e}};var va=class extends Jt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var _a=class extends Jt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var mt=class extends Jt{constructor(e,t,n){super(new Float32Array(e),t,n)}},yx=0,mi=new Ut,Gu=new an,jr=new L,ri=new yn,ia=new yn,xn=new L,Ot=class i extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:yx++}),this.uuid=ps(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Pf(e)?_a:va)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ct().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return mi.makeRotationFromQuaternion(e),this.applyMatrix4(mi),this}rotateX(e){return mi.makeRotationX(e),this.applyMatrix4(mi),this}rotateY(e){return mi.makeRotationY(e),this.applyMatrix4(mi),this}rotateZ(e){return mi.makeRotationZ(e),this.applyMatrix4(mi),this}translate(e,t,n){return mi.makeTranslation(e,t,n),this.applyMatrix4(mi),this}scale(e,t,n){return mi.makeScale(e,t,n),this.applyMatrix4(mi),this}lookAt(e){return Gu.lookAt(e),Gu.updateMatrix(),this.applyMatrix4(Gu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jr).negate(),this.translate(jr.x,jr.y,jr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new yn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new L(-1/0,-1/0,-1/0),new L(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(xn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(xn),xn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(xn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Li);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new L,1/0);return}if(e){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(xn.addVectors(ri.min,ia.min),ri.expandByPoint(xn),xn.addVectors(ri.max,ia.max),ri.expandByPoint(xn)):(ri.expandByPoint(ia.min),ri.expandByPoint(ia.max))}ri.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)xn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(xn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)xn.fromBufferAttribute(a,c),l&&(jr.fromBufferAttribute(e,c),xn.add(jr)),s=Math.max(s,n.distanceToSquared(xn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Jt(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let D=0;D<n.count;D++)a[D]=new L,l[D]=new L;let c=new L,u=new L,h=new L,f=new Oe,p=new Oe,m=new Oe,v=new L,g=new L;function d(D,S,w){c.fromBufferAttribute(n,D),u.fromBufferAttribute(n,S),h.fromBufferAttribute(n,w),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,S),m.fromBufferAttribute(r,w),u.sub(c),h.sub(c),p.sub(f),m.sub(f);let T=1/(p.x*m.y-m.x*p.y);isFinite(T)&&(v.copy(u).multiplyScalar(m.y).addScaledVector(h,-p.y).multiplyScalar(T),g.copy(h).multiplyScalar(p.x).addScaledVector(u,-m.x).multiplyScalar(T),a[D].add(v),a[S].add(v),a[w].add(v),l[D].add(g),l[S].add(g),l[w].add(g))}let b=this.groups;b.length===0&&(b=[{start:0,count:e.count}]);for(let D=0,S=b.length;D<S;++D){let w=b[D],T=w.start,B=w.count;for(let H=T,V=T+B;H<V;H+=3)d(e.getX(H+0),e.getX(H+1),e.getX(H+2))}let M=new L,y=new L,P=new L,E=new L;function I(D){P.fromBufferAttribute(s,D),E.copy(P);let S=a[D];M.copy(S),M.sub(P.multiplyScalar(P.dot(S))).normalize(),y.crossVectors(E,S);let T=y.dot(l[D])<0?-1:1;o.setXYZW(D,M.x,M.y,M.z,T)}for(let D=0,S=b.length;D<S;++D){let w=b[D],T=w.start,B=w.count;for(let H=T,V=T+B;H<V;H+=3)I(e.getX(H+0)),I(e.getX(H+1)),I(e.getX(H+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Jt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);let s=new L,r=new L,o=new L,a=new L,l=new L,c=new L,u=new L,h=new L;if(e)for(let f=0,p=e.count;f<p;f+=3){let m=e.getX(f+0),v=e.getX(f+1),g=e.getX(f+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)xn.fromBufferAttribute(e,t),xn.normalize(),e.setXYZ(t,xn.x,xn.y,xn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,m=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?p=l[v]*a.data.stride+a.offset:p=l[v]*u;for(let d=0;d<u;d++)f[m++]=c[p++]}return new Jt(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=e(f,n);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Wp=new Ut,sr=new hr,Pl=new Li,Xp=new L,Il=new L,Ll=new L,Dl=new L,Wu=new L,Ul=new L,qp=new L,Nl=new L,et=class extends an{constructor(e=new Ot,t=new Ui){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Ul.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Wu.fromBufferAttribute(h,e),o?Ul.addScaledVector(Wu,u):Ul.addScaledVector(Wu.sub(t),u))}t.add(Ul)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Pl.copy(n.boundingSphere),Pl.applyMatrix4(r),sr.copy(e.ray).recast(e.near),!(Pl.containsPoint(sr.origin)===!1&&(sr.intersectSphere(Pl,Xp)===null||sr.origin.distanceToSquared(Xp)>(e.far-e.near)**2))&&(Wp.copy(r).invert(),sr.copy(e.ray).applyMatrix4(Wp),!(n.boundingBox!==null&&sr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,sr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,v=f.length;m<v;m++){let g=f[m],d=o[g.materialIndex],b=Math.max(g.start,p.start),M=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let y=b,P=M;y<P;y+=3){let E=a.getX(y),I=a.getX(y+1),D=a.getX(y+2);s=Fl(this,d,e,n,c,u,h,E,I,D),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,p.start),v=Math.min(a.count,p.start+p.count);for(let g=m,d=v;g<d;g+=3){let b=a.getX(g),M=a.getX(g+1),y=a.getX(g+2);s=Fl(this,o,e,n,c,u,h,b,M,y),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,v=f.length;m<v;m++){let g=f[m],d=o[g.materialIndex],b=Math.max(g.start,p.start),M=Math.min(l.count,Math.min(g.start+g.count,p.start+p.count));for(let y=b,P=M;y<P;y+=3){let E=y,I=y+1,D=y+2;s=Fl(this,d,e,n,c,u,h,E,I,D),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,p.start),v=Math.min(l.count,p.start+p.count);for(let g=m,d=v;g<d;g+=3){let b=g,M=g+1,y=g+2;s=Fl(this,o,e,n,c,u,h,b,M,y),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function bx(i,e,t,n,s,r,o,a){let l;if(e.side===Gn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===gs,a),l===null)return null;Nl.copy(a),Nl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Nl);return c<t.near||c>t.far?null:{distance:c,point:Nl.clone(),object:i}}function Fl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Il),i.getVertexPosition(l,Ll),i.getVertexPosition(c,Dl);let u=bx(i,e,t,n,Il,Ll,Dl,qp);if(u){let h=new L;$i.getBarycoord(qp,Il,Ll,Dl,h),s&&(u.uv=$i.getInterpolatedAttribute(s,a,l,c,h,new Oe)),r&&(u.uv1=$i.getInterpolatedAttribute(r,a,l,c,h,new Oe)),o&&(u.normal=$i.getInterpolatedAttribute(o,a,l,c,h,new L),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new L,materialIndex:0};$i.getNormal(Il,Ll,Dl,f.normal),u.face=f,u.barycoord=h}return u}var ji=class i extends Ot{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;m("z","y","x",-1,-1,n,t,e,o,r,0),m("z","y","x",1,-1,n,t,-e,o,r,1),m("x","z","y",1,1,e,n,t,s,o,2),m("x","z","y",1,-1,e,n,-t,s,o,3),m("x","y","z",1,-1,e,t,n,s,r,4),m("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new mt(c,3)),this.setAttribute("normal",new mt(u,3)),this.setAttribute("uv",new mt(h,2));function m(v,g,d,b,M,y,P,E,I,D,S){let w=y/I,T=P/D,B=y/2,H=P/2,V=E/2,W=I+1,q=D+1,F=0,z=0,J=new L;for(let ne=0;ne<q;ne++){let te=ne*T-H;for(let ce=0;ce<W;ce++){let fe=ce*w-B;J[v]=fe*b,J[g]=te*M,J[d]=V,c.push(J.x,J.y,J.z),J[v]=0,J[g]=0,J[d]=E>0?1:-1,u.push(J.x,J.y,J.z),h.push(ce/I),h.push(1-ne/D),F+=1}}for(let ne=0;ne<D;ne++)for(let te=0;te<I;te++){let ce=f+te+W*ne,fe=f+te+W*(ne+1),xe=f+(te+1)+W*(ne+1),Ie=f+(te+1)+W*ne;l.push(ce,fe,Ie),l.push(fe,xe,Ie),z+=6}a.addGroup(p,z,S),p+=z,f+=F}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function _r(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Ln(i){let e={};for(let t=0;t<i.length;t++){let n=_r(i[t]);for(let s in n)e[s]=n[s]}return e}function Mx(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function If(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}var Ya={clone:_r,merge:Ln},wx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Sx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,oi=class extends Ji{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=wx,this.fragmentShader=Sx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=_r(e.uniforms),this.uniformsGroups=Mx(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},xa=class extends an{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ut,this.projectionMatrix=new Ut,this.projectionMatrixInverse=new Ut,this.coordinateSystem=Pi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Ns=new L,Yp=new Oe,$p=new Oe,In=class extends xa{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ho*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ao*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ho*2*Math.atan(Math.tan(ao*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ns.x,Ns.y).multiplyScalar(-e/Ns.z)}getViewSize(e,t){return this.getViewBounds(e,Yp,$p),t.subVectors($p,Yp)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ao*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Qr=-90,eo=1,oc=class extends an{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new In(Qr,eo,e,t);s.layers=this.layers,this.add(s);let r=new In(Qr,eo,e,t);r.layers=this.layers,this.add(r);let o=new In(Qr,eo,e,t);o.layers=this.layers,this.add(o);let a=new In(Qr,eo,e,t);a.layers=this.layers,this.add(a);let l=new In(Qr,eo,e,t);l.layers=this.layers,this.add(l);let c=new In(Qr,eo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Pi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===da)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=v,e.setRenderTarget(n,5,s),e.render(t,u),e.setRenderTarget(h,f,p),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},ya=class extends Kn{constructor(e=[],t=gr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},ac=class extends Ki{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new ya(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ji(5,5,5),r=new oi({name:"CubemapFromEquirect",uniforms:_r(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Gn,blending:_s});r.uniforms.tEquirect.value=t;let o=new et(s,r),a=t.minFilter;return t.minFilter===Gs&&(t.minFilter=Ii),new oc(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Tt=class extends an{constructor(){super(),this.isGroup=!0,this.type="Group"}},Ex={type:"move"},po=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Tt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Tt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new L,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new L),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Tt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new L,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new L),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,n),d=this._getHandJoint(c,v);g!==null&&(d.matrix.fromArray(g.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=g.radius),d.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,m=.005;c.inputState.pinching&&f>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Ex)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Tt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var mo=class extends an{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Di,this.environmentIntensity=1,this.environmentRotation=new Di,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},go=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=nc,this.updateRanges=[],this.version=0,this.uuid=ps()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);let t=new this.array.constructor(e.arrayBuffers[this.array.buffer._uuid]),n=new this.constructor(t,this.stride);return n.setUsage(this.usage),n}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){return e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}},Hn=new L,Jn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.applyMatrix4(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.applyNormalMatrix(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Hn.fromBufferAttribute(this,t),Hn.transformDirection(e),this.setXYZ(t,Hn.x,Hn.y,Hn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=Ci(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Ct(n,this.array)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=Ct(t,this.array)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=Ci(t,this.array)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=Ci(t,this.array)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=Ci(t,this.array)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=Ci(t,this.array)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=Ct(t,this.array),n=Ct(n,this.array),s=Ct(s,this.array),r=Ct(r,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Jt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}},vo=class extends Ji{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new at(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},to,sa=new L,no=new L,io=new L,so=new Oe,ra=new Oe,Jm=new Ut,Ol=new L,oa=new L,Bl=new L,Zp=new Oe,Xu=new Oe,Kp=new Oe,ba=class extends an{constructor(e=new vo){if(super(),this.isSprite=!0,this.type="Sprite",to===void 0){to=new Ot;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new go(t,5);to.setIndex([0,1,2,0,2,3]),to.setAttribute("position",new Jn(n,3,0,!1)),to.setAttribute("uv",new Jn(n,2,3,!1))}this.geometry=to,this.material=e,this.center=new Oe(.5,.5),this.count=1}raycast(e,t){e.camera===null&&console.error('THREE.Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),no.setFromMatrixScale(this.matrixWorld),Jm.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),io.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&no.multiplyScalar(-io.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;zl(Ol.set(-.5,-.5,0),io,o,no,s,r),zl(oa.set(.5,-.5,0),io,o,no,s,r),zl(Bl.set(.5,.5,0),io,o,no,s,r),Zp.set(0,0),Xu.set(1,0),Kp.set(1,1);let a=e.ray.intersectTriangle(Ol,oa,Bl,!1,sa);if(a===null&&(zl(oa.set(-.5,.5,0),io,o,no,s,r),Xu.set(0,1),a=e.ray.intersectTriangle(Ol,Bl,oa,!1,sa),a===null))return;let l=e.ray.origin.distanceTo(sa);l<e.near||l>e.far||t.push({distance:l,point:sa.clone(),uv:$i.getInterpolation(sa,Ol,oa,Bl,Zp,Xu,Kp,new Oe),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}};function zl(i,e,t,n,s,r){so.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(ra.x=r*so.x-s*so.y,ra.y=s*so.x+r*so.y):ra.copy(so),i.copy(e),i.x+=ra.x,i.y+=ra.y,i.applyMatrix4(Jm)}var qu=new L,Tx=new L,Ax=new ct,Zn=class{constructor(e=new L(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=qu.subVectors(n,t).cross(Tx.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(qu),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Ax.getNormalMatrix(e),s=this.coplanarPoint(qu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},rr=new Li,Rx=new Oe(.5,.5),kl=new L,_o=class{constructor(e=new Zn,t=new Zn,n=new Zn,s=new Zn,r=new Zn,o=new Zn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Pi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],p=r[7],m=r[8],v=r[9],g=r[10],d=r[11],b=r[12],M=r[13],y=r[14],P=r[15];if(s[0].setComponents(c-o,p-u,d-m,P-b).normalize(),s[1].setComponents(c+o,p+u,d+m,P+b).normalize(),s[2].setComponents(c+a,p+h,d+v,P+M).normalize(),s[3].setComponents(c-a,p-h,d-v,P-M).normalize(),n)s[4].setComponents(l,f,g,y).normalize(),s[5].setComponents(c-l,p-f,d-g,P-y).normalize();else if(s[4].setComponents(c-l,p-f,d-g,P-y).normalize(),t===Pi)s[5].setComponents(c+l,p+f,d+g,P+y).normalize();else if(t===da)s[5].setComponents(l,f,g,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(e){rr.center.set(0,0,0);let t=Rx.distanceTo(e.center);return rr.radius=.7071067811865476+t,rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(kl.x=s.normal.x>0?e.max.x:e.min.x,kl.y=s.normal.y>0?e.max.y:e.min.y,kl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(kl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var vs=class extends Ji{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new at(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},lc=new L,cc=new L,Jp=new Ut,aa=new hr,Hl=new Li,Yu=new L,jp=new L,ur=class extends an{constructor(e=new Ot,t=new vs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)lc.fromBufferAttribute(t,s-1),cc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=lc.distanceTo(cc);e.setAttribute("lineDistance",new mt(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Hl.copy(n.boundingSphere),Hl.applyMatrix4(s),Hl.radius+=r,e.ray.intersectsSphere(Hl)===!1)return;Jp.copy(s).invert(),aa.copy(e.ray).applyMatrix4(Jp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let p=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let v=p,g=m-1;v<g;v+=c){let d=u.getX(v),b=u.getX(v+1),M=Vl(this,e,aa,l,d,b,v);M&&t.push(M)}if(this.isLineLoop){let v=u.getX(m-1),g=u.getX(p),d=Vl(this,e,aa,l,v,g,m-1);d&&t.push(d)}}else{let p=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let v=p,g=m-1;v<g;v+=c){let d=Vl(this,e,aa,l,v,v+1,v);d&&t.push(d)}if(this.isLineLoop){let v=Vl(this,e,aa,l,m-1,p,m-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Vl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(lc.fromBufferAttribute(a,s),cc.fromBufferAttribute(a,r),t.distanceSqToSegment(lc,cc,Yu,jp)>n)return;Yu.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Yu);if(!(c<e.near||c>e.far))return{distance:c,point:jp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Qp=new L,em=new L,xo=class extends ur{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Qp.fromBufferAttribute(t,s),em.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Qp.distanceTo(em);e.setAttribute("lineDistance",new mt(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ma=class extends Kn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},wa=class extends Kn{constructor(e,t,n=Ws,s,r,o,a=gi,l=gi,c,u=co,h=1){if(u!==co&&u!==So)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new fo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},Sa=class extends Kn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var fr=class i extends Ot{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new L,u=new Oe;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=t;h++,f+=3){let p=n+h/t*s;c.x=e*Math.cos(p),c.y=e*Math.sin(p),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/e+1)/2,u.y=(o[f+1]/e+1)/2,l.push(u.x,u.y)}for(let h=1;h<=t;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new mt(o,3)),this.setAttribute("normal",new mt(a,3)),this.setAttribute("uv",new mt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},wn=class i extends Ot{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],p=[],m=0,v=[],g=n/2,d=0;b(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(u),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(p,2));function b(){let y=new L,P=new L,E=0,I=(t-e)/n;for(let D=0;D<=r;D++){let S=[],w=D/r,T=w*(t-e)+e;for(let B=0;B<=s;B++){let H=B/s,V=H*l+a,W=Math.sin(V),q=Math.cos(V);P.x=T*W,P.y=-w*n+g,P.z=T*q,h.push(P.x,P.y,P.z),y.set(W,I,q).normalize(),f.push(y.x,y.y,y.z),p.push(H,1-w),S.push(m++)}v.push(S)}for(let D=0;D<s;D++)for(let S=0;S<r;S++){let w=v[S][D],T=v[S+1][D],B=v[S+1][D+1],H=v[S][D+1];(e>0||S!==0)&&(u.push(w,T,H),E+=3),(t>0||S!==r-1)&&(u.push(T,B,H),E+=3)}c.addGroup(d,E,0),d+=E}function M(y){let P=m,E=new Oe,I=new L,D=0,S=y===!0?e:t,w=y===!0?1:-1;for(let B=1;B<=s;B++)h.push(0,g*w,0),f.push(0,w,0),p.push(.5,.5),m++;let T=m;for(let B=0;B<=s;B++){let V=B/s*l+a,W=Math.cos(V),q=Math.sin(V);I.x=S*q,I.y=g*w,I.z=S*W,h.push(I.x,I.y,I.z),f.push(0,w,0),E.x=W*.5+.5,E.y=q*.5*w+.5,p.push(E.x,E.y),m++}for(let B=0;B<s;B++){let H=P+B,V=T+B;y===!0?u.push(V,V+1,H):u.push(V+1,V,H),D+=3}c.addGroup(d,D,y===!0?1:2),d+=D}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},dr=class i extends wn{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Gl=new L,Wl=new L,$u=new L,Xl=new $i,Ea=class extends Ot{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(ao*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},p=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:v,b:g,c:d}=Xl;if(v.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),Xl.getNormal($u),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,h[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let b=0;b<3;b++){let M=(b+1)%3,y=h[b],P=h[M],E=Xl[u[b]],I=Xl[u[M]],D=`${y}_${P}`,S=`${P}_${y}`;S in f&&f[S]?($u.dot(f[S].normal)<=r&&(p.push(E.x,E.y,E.z),p.push(I.x,I.y,I.z)),f[S]=null):D in f||(f[D]={index0:c[b],index1:c[M],normal:$u.clone()})}}for(let m in f)if(f[m]){let{index0:v,index1:g}=f[m];Gl.fromBufferAttribute(a,v),Wl.fromBufferAttribute(a,g),p.push(Gl.x,Gl.y,Gl.z),p.push(Wl.x,Wl.y,Wl.z)}this.setAttribute("position",new mt(p,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},jn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let u=n[s],f=n[s+1]-u,p=(o-u)/f;return(s+p)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new Oe:new L);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new L,s=[],r=[],o=[],a=new L,l=new Ut;for(let p=0;p<=e;p++){let m=p/e;s[p]=this.getTangentAt(m,new L)}r[0]=new L,o[0]=new L;let c=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let p=1;p<=e;p++){if(r[p]=r[p-1].clone(),o[p]=o[p-1].clone(),a.crossVectors(s[p-1],s[p]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(it(s[p-1].dot(s[p]),-1,1));r[p].applyMatrix4(l.makeRotationAxis(a,m))}o[p].crossVectors(s[p],r[p])}if(t===!0){let p=Math.acos(it(r[0].dot(r[e]),-1,1));p/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(p=-p);for(let m=1;m<=e;m++)r[m].applyMatrix4(l.makeRotationAxis(s[m],p*m)),o[m].crossVectors(s[m],r[m])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}},Ta=class extends jn{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new Oe){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,p=c-this.aY;l=f*u-p*h+this.aX,c=f*h+p*u+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},hc=class extends Ta{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Lf(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,p=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,p*=u,s(o,a,f,p)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var ql=new L,Zu=new Lf,Ku=new Lf,Ju=new Lf,uc=class extends jn{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new L){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:(ql.subVectors(s[0],s[1]).add(s[0]),c=ql);let h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(ql.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=ql),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(h),p),v=Math.pow(h.distanceToSquared(f),p),g=Math.pow(f.distanceToSquared(u),p);v<1e-4&&(v=1),m<1e-4&&(m=v),g<1e-4&&(g=v),Zu.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,m,v,g),Ku.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,m,v,g),Ju.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,m,v,g)}else this.curveType==="catmullrom"&&(Zu.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),Ku.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),Ju.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(Zu.calc(l),Ku.calc(l),Ju.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new L().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function tm(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function Cx(i,e){let t=1-i;return t*t*e}function Px(i,e){return 2*(1-i)*i*e}function Ix(i,e){return i*i*e}function ca(i,e,t,n){return Cx(i,e)+Px(i,t)+Ix(i,n)}function Lx(i,e){let t=1-i;return t*t*t*e}function Dx(i,e){let t=1-i;return 3*t*t*i*e}function Ux(i,e){return 3*(1-i)*i*i*e}function Nx(i,e){return i*i*i*e}function ha(i,e,t,n,s){return Lx(i,e)+Dx(i,t)+Ux(i,n)+Nx(i,s)}var fc=class extends jn{constructor(e=new Oe,t=new Oe,n=new Oe,s=new Oe){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Oe){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ha(e,s.x,r.x,o.x,a.x),ha(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},dc=class extends jn{constructor(e=new L,t=new L,n=new L,s=new L){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new L){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ha(e,s.x,r.x,o.x,a.x),ha(e,s.y,r.y,o.y,a.y),ha(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},pc=class extends jn{constructor(e=new Oe,t=new Oe){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Oe){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Oe){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},mc=class extends jn{constructor(e=new L,t=new L){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new L){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new L){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},gc=class extends jn{constructor(e=new Oe,t=new Oe,n=new Oe){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Oe){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ca(e,s.x,r.x,o.x),ca(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Aa=class extends jn{constructor(e=new L,t=new L,n=new L){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new L){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(ca(e,s.x,r.x,o.x),ca(e,s.y,r.y,o.y),ca(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},vc=class extends jn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Oe){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(tm(a,l.x,c.x,u.x,h.x),tm(a,l.y,c.y,u.y,h.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Oe().fromArray(s))}return this}},Fx=Object.freeze({__proto__:null,ArcCurve:hc,CatmullRomCurve3:uc,CubicBezierCurve:fc,CubicBezierCurve3:dc,EllipseCurve:Ta,LineCurve:pc,LineCurve3:mc,QuadraticBezierCurve:gc,QuadraticBezierCurve3:Aa,SplineCurve:vc});var Ra=class i extends Ot{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,p=[],m=[],v=[],g=[];for(let d=0;d<u;d++){let b=d*f-o;for(let M=0;M<c;M++){let y=M*h-r;m.push(y,-b,0),v.push(0,0,1),g.push(M/a),g.push(1-d/l)}}for(let d=0;d<l;d++)for(let b=0;b<a;b++){let M=b+c*d,y=b+c*(d+1),P=b+1+c*(d+1),E=b+1+c*d;p.push(M,y,E),p.push(y,P,E)}this.setIndex(p),this.setAttribute("position",new mt(m,3)),this.setAttribute("normal",new mt(v,3)),this.setAttribute("uv",new mt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ca=class i extends Ot{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new L,f=new L,p=[],m=[],v=[],g=[];for(let d=0;d<=n;d++){let b=[],M=d/n,y=0;d===0&&o===0?y=.5/t:d===n&&l===Math.PI&&(y=-.5/t);for(let P=0;P<=t;P++){let E=P/t;h.x=-e*Math.cos(s+E*r)*Math.sin(o+M*a),h.y=e*Math.cos(o+M*a),h.z=e*Math.sin(s+E*r)*Math.sin(o+M*a),m.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),g.push(E+y,1-M),b.push(c++)}u.push(b)}for(let d=0;d<n;d++)for(let b=0;b<t;b++){let M=u[d][b+1],y=u[d][b],P=u[d+1][b],E=u[d+1][b+1];(d!==0||o>0)&&p.push(M,y,E),(d!==n-1||l<Math.PI)&&p.push(y,P,E)}this.setIndex(p),this.setAttribute("position",new mt(m,3)),this.setAttribute("normal",new mt(v,3)),this.setAttribute("uv",new mt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Pa=class i extends Ot{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],l=[],c=[],u=new L,h=new L,f=new L;for(let p=0;p<=n;p++)for(let m=0;m<=s;m++){let v=m/s*r,g=p/n*Math.PI*2;h.x=(e+t*Math.cos(g))*Math.cos(v),h.y=(e+t*Math.cos(g))*Math.sin(v),h.z=t*Math.sin(g),a.push(h.x,h.y,h.z),u.x=e*Math.cos(v),u.y=e*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(m/s),c.push(p/n)}for(let p=1;p<=n;p++)for(let m=1;m<=s;m++){let v=(s+1)*p+m-1,g=(s+1)*(p-1)+m-1,d=(s+1)*(p-1)+m,b=(s+1)*p+m;o.push(v,g,b),o.push(g,d,b)}this.setIndex(o),this.setAttribute("position",new mt(a,3)),this.setAttribute("normal",new mt(l,3)),this.setAttribute("uv",new mt(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}};var Ia=class i extends Ot{constructor(e=new Aa(new L(-1,-1,0),new L(-1,1,0),new L(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let o=e.computeFrenetFrames(t,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new L,l=new L,c=new Oe,u=new L,h=[],f=[],p=[],m=[];v(),this.setIndex(m),this.setAttribute("position",new mt(h,3)),this.setAttribute("normal",new mt(f,3)),this.setAttribute("uv",new mt(p,2));function v(){for(let M=0;M<t;M++)g(M);g(r===!1?t:0),b(),d()}function g(M){u=e.getPointAt(M/t,u);let y=o.normals[M],P=o.binormals[M];for(let E=0;E<=s;E++){let I=E/s*Math.PI*2,D=Math.sin(I),S=-Math.cos(I);l.x=S*y.x+D*P.x,l.y=S*y.y+D*P.y,l.z=S*y.z+D*P.z,l.normalize(),f.push(l.x,l.y,l.z),a.x=u.x+n*l.x,a.y=u.y+n*l.y,a.z=u.z+n*l.z,h.push(a.x,a.y,a.z)}}function d(){for(let M=1;M<=t;M++)for(let y=1;y<=s;y++){let P=(s+1)*(M-1)+(y-1),E=(s+1)*M+(y-1),I=(s+1)*M+y,D=(s+1)*(M-1)+y;m.push(P,E,D),m.push(E,I,D)}}function b(){for(let M=0;M<=t;M++)for(let y=0;y<=s;y++)c.x=M/t,c.y=y/s,p.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new Fx[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}},La=class extends Ot{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new L,r=new L;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,p=h.count;for(let m=f,v=f+p;m<v;m+=3)for(let g=0;g<3;g++){let d=a.getX(m+g),b=a.getX(m+(g+1)%3);s.fromBufferAttribute(o,d),r.fromBufferAttribute(o,b),nm(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),nm(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new mt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function nm(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var Ni=class extends Ji{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new at(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new at(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Sf,this.normalScale=new Oe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Di,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var _c=class extends Ji{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Bm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},xc=class extends Ji{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Yl(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Ox(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var pr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},yc=class extends pr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:tf,endingEnd:tf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case nf:r=e,a=2*t-n;break;case sf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case nf:o=e,l=2*n-t;break;case sf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,p=this._weightNext,m=(n-t)/(s-t),v=m*m,g=v*m,d=-f*g+2*f*v-f*m,b=(1+f)*g+(-1.5-2*f)*v+(-.5+f)*m+1,M=(-1-p)*g+(1.5+p)*v+.5*m,y=p*g-p*v;for(let P=0;P!==a;++P)r[P]=d*o[u+P]+b*o[c+P]+M*o[l+P]+y*o[h+P];return r}},bc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Mc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ai=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Yl(t,this.TimeBufferType),this.values=Yl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Yl(e.times,Array),values:Yl(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Mc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new bc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new yc(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case ua:t=this.InterpolantFactoryMethodDiscrete;break;case tc:t=this.InterpolantFactoryMethodLinear;break;case Kl:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ua;case this.InterpolantFactoryMethodLinear:return tc;case this.InterpolantFactoryMethodSmooth:return Kl}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Ox(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Kl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,f=h-n,p=h+n;for(let m=0;m!==n;++m){let v=t[h+m];if(v!==t[f+m]||v!==t[p+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,f=o*n;for(let p=0;p!==n;++p)t[f+p]=t[h+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};ai.prototype.ValueTypeName="";ai.prototype.TimeBufferType=Float32Array;ai.prototype.ValueBufferType=Float32Array;ai.prototype.DefaultInterpolation=tc;var Bs=class extends ai{constructor(e,t,n){super(e,t,n)}};Bs.prototype.ValueTypeName="bool";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=ua;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var wc=class extends ai{constructor(e,t,n,s){super(e,t,n,s)}};wc.prototype.ValueTypeName="color";var Sc=class extends ai{constructor(e,t,n,s){super(e,t,n,s)}};Sc.prototype.ValueTypeName="number";var Ec=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)sn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Da=class extends ai{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Ec(this.times,this.values,this.getValueSize(),e)}};Da.prototype.ValueTypeName="quaternion";Da.prototype.InterpolantFactoryMethodSmooth=void 0;var zs=class extends ai{constructor(e,t,n){super(e,t,n)}};zs.prototype.ValueTypeName="string";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=ua;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Tc=class extends ai{constructor(e,t,n,s){super(e,t,n,s)}};Tc.prototype.ValueTypeName="vector";var Ac=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let p=c[h],m=c[h+1];if(p.global&&(p.lastIndex=0),p.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},jm=new Ac,Rc=class{constructor(e){this.manager=e!==void 0?e:jm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};Rc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ua=class extends an{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new at(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}},Na=class extends Ua{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(an.DEFAULT_UP),this.updateMatrix(),this.groundColor=new at(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}},ju=new Ut,im=new L,sm=new L,of=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Oe(512,512),this.mapType=Fi,this.map=null,this.mapPass=null,this.matrix=new Ut,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new _o,this._frameExtents=new Oe(1,1),this._viewportCount=1,this._viewports=[new It(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera,n=this.matrix;im.setFromMatrixPosition(e.matrixWorld),t.position.copy(im),sm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(sm),t.updateMatrixWorld(),ju.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(ju,t.coordinateSystem,t.reversedDepth),t.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(ju)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var mr=class extends xa{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},af=class extends of{constructor(){super(new mr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fa=class extends Ua{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(an.DEFAULT_UP),this.updateMatrix(),this.target=new an,this.shadow=new af}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}};var Oa=class extends Ot{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Cc=class extends In{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var Df="\\[\\]\\.:\\/",Bx=new RegExp("["+Df+"]","g"),Uf="[^"+Df+"]",zx="[^"+Df.replace("\\.","")+"]",kx=/((?:WC+[\/:])*)/.source.replace("WC",Uf),Hx=/(WCOD+)?/.source.replace("WCOD",zx),Vx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Uf),Gx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Uf),Wx=new RegExp("^"+kx+Hx+Vx+Gx+"$"),Xx=["material","materials","bones","map"],lf=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Bx,"")}static parseTrackName(e){let t=Wx.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Xx.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=lf;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nA=new Float32Array(1);var ks=class extends go{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var yo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=it(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(it(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var rm=new L,$l=new L,ro=new L,oo=new L,Qu=new L,qx=new L,Yx=new L,Ba=class{constructor(e=new L,t=new L){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){rm.subVectors(e,this.start),$l.subVectors(this.end,this.start);let n=$l.dot($l),r=$l.dot(rm)/n;return t&&(r=it(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=qx,n=Yx){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;ro.subVectors(c,a),oo.subVectors(u,l),Qu.subVectors(a,l);let h=ro.dot(ro),f=oo.dot(oo),p=oo.dot(Qu);if(h<=s&&f<=s)return t.copy(a),n.copy(l),t.sub(n),t.dot(t);if(h<=s)r=0,o=p/f,o=it(o,0,1);else{let m=ro.dot(Qu);if(f<=s)o=0,r=it(-m/h,0,1);else{let v=ro.dot(oo),g=h*f-v*v;g!==0?r=it((v*p-m*f)/g,0,1):r=0,o=(v*r+p)/f,o<0?(o=0,r=it(-m/h,0,1)):o>1&&(o=1,r=it((v-m)/h,0,1))}}return t.copy(a).add(ro.multiplyScalar(r)),n.copy(l).add(oo.multiplyScalar(o)),t.sub(n),t.dot(t)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var om=new L,Zl,ef,za=class extends an{constructor(e=new L(0,0,1),t=new L(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",Zl===void 0&&(Zl=new Ot,Zl.setAttribute("position",new mt([0,0,0,0,1,0],3)),ef=new dr(.5,1,5,1),ef.translate(0,-.5,0)),this.position.copy(t),this.line=new ur(Zl,new vs({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new et(ef,new Ui({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{om.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(om,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var ka=class extends Zi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Nf(i,e,t,n){let s=$x(n);switch(t){case yf:return i*e;case Mf:return i*e/s.components*s.byteLength;case Gc:return i*e/s.components*s.byteLength;case wf:return i*e*2/s.components*s.byteLength;case Wc:return i*e*2/s.components*s.byteLength;case bf:return i*e*3/s.components*s.byteLength;case vi:return i*e*4/s.components*s.byteLength;case Xc:return i*e*4/s.components*s.byteLength;case Ga:case Wa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Xa:case qa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Yc:case Zc:return Math.max(i,16)*Math.max(e,8)/4;case qc:case $c:return Math.max(i,8)*Math.max(e,8)/2;case Kc:case Jc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case jc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Qc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case eh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case th:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case nh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ih:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case sh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case rh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case oh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ah:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case lh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case ch:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case hh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case uh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case fh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case dh:case ph:case mh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case gh:case vh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case _h:case xh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function $x(i){switch(i){case Fi:case gf:return{byteLength:1,components:1};case bo:case vf:case Mo:return{byteLength:2,components:1};case Hc:case Vc:return{byteLength:2,components:4};case Ws:case kc:case es:return{byteLength:4,components:1};case _f:case xf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function Mg(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function ey(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((p,m)=>p.start-m.start);let f=0;for(let p=1;p<h.length;p++){let m=h[f],v=h[p];v.start<=m.start+m.count+1?m.count=Math.max(m.count,v.start+v.count-m.start):(++f,h[f]=v)}h.length=f+1;for(let p=0,m=h.length;p<m;p++){let v=h[p];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var ty=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ny=`#ifdef USE_ALPHAHASH
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
#endif`,iy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,sy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ry=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,oy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ay=`#ifdef USE_AOMAP
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
#endif`,ly=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,cy=`#ifdef USE_BATCHING
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
#endif`,hy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,uy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,fy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,dy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,py=`#ifdef USE_IRIDESCENCE
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
#endif`,my=`#ifdef USE_BUMPMAP
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
#endif`,gy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,vy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,_y=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,xy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,yy=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,by=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,My=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,wy=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Sy=`#define PI 3.141592653589793
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
} // validated`,Ey=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Ty=`vec3 transformedNormal = objectNormal;
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
#endif`,Ay=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ry=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Cy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Py=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Iy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ly=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Dy=`#ifdef USE_ENVMAP
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
#endif`,Uy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Ny=`#ifdef USE_ENVMAP
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
#endif`,Fy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Oy=`#ifdef USE_ENVMAP
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
#endif`,By=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,zy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ky=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Hy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Vy=`#ifdef USE_GRADIENTMAP
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
}`,Gy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Wy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Xy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,qy=`uniform bool receiveShadow;
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
#endif`,Yy=`#ifdef USE_ENVMAP
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
#endif`,$y=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Zy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ky=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Jy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,jy=`PhysicalMaterial material;
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
#endif`,Qy=`struct PhysicalMaterial {
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
}`,eb=`
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
#endif`,tb=`#if defined( RE_IndirectDiffuse )
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
#endif`,nb=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,ib=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,sb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,rb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ob=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,ab=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,lb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,cb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,hb=`#if defined( USE_POINTS_UV )
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
#endif`,ub=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,fb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,db=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,pb=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,mb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,gb=`#ifdef USE_MORPHTARGETS
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
#endif`,vb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,_b=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,xb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,yb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,bb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Mb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,wb=`#ifdef USE_NORMALMAP
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
#endif`,Sb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Eb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Tb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Ab=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Rb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Cb=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Pb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ib=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Lb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Db=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Ub=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Nb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Fb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Ob=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Bb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,zb=`float getShadowMask() {
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
}`,kb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Hb=`#ifdef USE_SKINNING
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
#endif`,Vb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Gb=`#ifdef USE_SKINNING
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
#endif`,Wb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Xb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,qb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Yb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,$b=`#ifdef USE_TRANSMISSION
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
#endif`,Zb=`#ifdef USE_TRANSMISSION
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
#endif`,Kb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Jb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,jb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Qb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,eM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,tM=`uniform sampler2D t2D;
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
}`,nM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,iM=`#ifdef ENVMAP_TYPE_CUBE
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
}`,sM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,rM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,oM=`#include <common>
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
}`,aM=`#if DEPTH_PACKING == 3200
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
}`,lM=`#define DISTANCE
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
}`,cM=`#define DISTANCE
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
}`,hM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,uM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fM=`uniform float scale;
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
}`,dM=`uniform vec3 diffuse;
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
}`,pM=`#include <common>
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
}`,mM=`uniform vec3 diffuse;
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
}`,gM=`#define LAMBERT
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
}`,vM=`#define LAMBERT
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
}`,_M=`#define MATCAP
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
}`,xM=`#define MATCAP
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
}`,yM=`#define NORMAL
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
}`,bM=`#define NORMAL
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
}`,MM=`#define PHONG
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
}`,wM=`#define PHONG
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
}`,SM=`#define STANDARD
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
}`,EM=`#define STANDARD
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
}`,TM=`#define TOON
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
}`,AM=`#define TOON
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
}`,RM=`uniform float size;
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
}`,CM=`uniform vec3 diffuse;
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
}`,PM=`#include <common>
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
}`,IM=`uniform vec3 color;
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
}`,LM=`uniform float rotation;
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
}`,DM=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:ty,alphahash_pars_fragment:ny,alphamap_fragment:iy,alphamap_pars_fragment:sy,alphatest_fragment:ry,alphatest_pars_fragment:oy,aomap_fragment:ay,aomap_pars_fragment:ly,batching_pars_vertex:cy,batching_vertex:hy,begin_vertex:uy,beginnormal_vertex:fy,bsdfs:dy,iridescence_fragment:py,bumpmap_pars_fragment:my,clipping_planes_fragment:gy,clipping_planes_pars_fragment:vy,clipping_planes_pars_vertex:_y,clipping_planes_vertex:xy,color_fragment:yy,color_pars_fragment:by,color_pars_vertex:My,color_vertex:wy,common:Sy,cube_uv_reflection_fragment:Ey,defaultnormal_vertex:Ty,displacementmap_pars_vertex:Ay,displacementmap_vertex:Ry,emissivemap_fragment:Cy,emissivemap_pars_fragment:Py,colorspace_fragment:Iy,colorspace_pars_fragment:Ly,envmap_fragment:Dy,envmap_common_pars_fragment:Uy,envmap_pars_fragment:Ny,envmap_pars_vertex:Fy,envmap_physical_pars_fragment:Yy,envmap_vertex:Oy,fog_vertex:By,fog_pars_vertex:zy,fog_fragment:ky,fog_pars_fragment:Hy,gradientmap_pars_fragment:Vy,lightmap_pars_fragment:Gy,lights_lambert_fragment:Wy,lights_lambert_pars_fragment:Xy,lights_pars_begin:qy,lights_toon_fragment:$y,lights_toon_pars_fragment:Zy,lights_phong_fragment:Ky,lights_phong_pars_fragment:Jy,lights_physical_fragment:jy,lights_physical_pars_fragment:Qy,lights_fragment_begin:eb,lights_fragment_maps:tb,lights_fragment_end:nb,logdepthbuf_fragment:ib,logdepthbuf_pars_fragment:sb,logdepthbuf_pars_vertex:rb,logdepthbuf_vertex:ob,map_fragment:ab,map_pars_fragment:lb,map_particle_fragment:cb,map_particle_pars_fragment:hb,metalnessmap_fragment:ub,metalnessmap_pars_fragment:fb,morphinstance_vertex:db,morphcolor_vertex:pb,morphnormal_vertex:mb,morphtarget_pars_vertex:gb,morphtarget_vertex:vb,normal_fragment_begin:_b,normal_fragment_maps:xb,normal_pars_fragment:yb,normal_pars_vertex:bb,normal_vertex:Mb,normalmap_pars_fragment:wb,clearcoat_normal_fragment_begin:Sb,clearcoat_normal_fragment_maps:Eb,clearcoat_pars_fragment:Tb,iridescence_pars_fragment:Ab,opaque_fragment:Rb,packing:Cb,premultiplied_alpha_fragment:Pb,project_vertex:Ib,dithering_fragment:Lb,dithering_pars_fragment:Db,roughnessmap_fragment:Ub,roughnessmap_pars_fragment:Nb,shadowmap_pars_fragment:Fb,shadowmap_pars_vertex:Ob,shadowmap_vertex:Bb,shadowmask_pars_fragment:zb,skinbase_vertex:kb,skinning_pars_vertex:Hb,skinning_vertex:Vb,skinnormal_vertex:Gb,specularmap_fragment:Wb,specularmap_pars_fragment:Xb,tonemapping_fragment:qb,tonemapping_pars_fragment:Yb,transmission_fragment:$b,transmission_pars_fragment:Zb,uv_pars_fragment:Kb,uv_pars_vertex:Jb,uv_vertex:jb,worldpos_vertex:Qb,background_vert:eM,background_frag:tM,backgroundCube_vert:nM,backgroundCube_frag:iM,cube_vert:sM,cube_frag:rM,depth_vert:oM,depth_frag:aM,distanceRGBA_vert:lM,distanceRGBA_frag:cM,equirect_vert:hM,equirect_frag:uM,linedashed_vert:fM,linedashed_frag:dM,meshbasic_vert:pM,meshbasic_frag:mM,meshlambert_vert:gM,meshlambert_frag:vM,meshmatcap_vert:_M,meshmatcap_frag:xM,meshnormal_vert:yM,meshnormal_frag:bM,meshphong_vert:MM,meshphong_frag:wM,meshphysical_vert:SM,meshphysical_frag:EM,meshtoon_vert:TM,meshtoon_frag:AM,points_vert:RM,points_frag:CM,shadow_vert:PM,shadow_frag:IM,sprite_vert:LM,sprite_frag:DM},De={common:{diffuse:{value:new at(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new Oe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new at(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new at(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new at(16777215)},opacity:{value:1},center:{value:new Oe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},Xn={basic:{uniforms:Ln([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Ln([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new at(0)}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Ln([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new at(0)},specular:{value:new at(1118481)},shininess:{value:30}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Ln([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new at(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Ln([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new at(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Ln([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Ln([De.points,De.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Ln([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Ln([De.common,De.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Ln([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Ln([De.sprite,De.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distanceRGBA:{uniforms:Ln([De.common,De.displacementmap,{referencePosition:{value:new L},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distanceRGBA_vert,fragmentShader:ft.distanceRGBA_frag},shadow:{uniforms:Ln([De.lights,De.fog,{color:{value:new at(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};Xn.physical={uniforms:Ln([Xn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new Oe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new at(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new Oe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new at(0)},specularColor:{value:new at(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new Oe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var yh={r:0,b:0,g:0},xr=new Di,UM=new Ut;function NM(i,e,t,n,s,r,o){let a=new at(0),l=r===!0?0:1,c,u,h=null,f=0,p=null;function m(M){let y=M.isScene===!0?M.background:null;return y&&y.isTexture&&(y=(M.backgroundBlurriness>0?t:e).get(y)),y}function v(M){let y=!1,P=m(M);P===null?d(a,l):P&&P.isColor&&(d(P,1),y=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?n.buffers.color.setClear(0,0,0,1,o):E==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||y)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function g(M,y){let P=m(y);P&&(P.isCubeTexture||P.mapping===Ha)?(u===void 0&&(u=new et(new ji(1,1,1),new oi({name:"BackgroundCubeMaterial",uniforms:_r(Xn.backgroundCube.uniforms),vertexShader:Xn.backgroundCube.vertexShader,fragmentShader:Xn.backgroundCube.fragmentShader,side:Gn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(E,I,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),xr.copy(y.backgroundRotation),xr.x*=-1,xr.y*=-1,xr.z*=-1,P.isCubeTexture&&P.isRenderTargetTexture===!1&&(xr.y*=-1,xr.z*=-1),u.material.uniforms.envMap.value=P,u.material.uniforms.flipEnvMap.value=P.isCubeTexture&&P.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=y.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(UM.makeRotationFromEuler(xr)),u.material.toneMapped=_t.getTransfer(P.colorSpace)!==Pt,(h!==P||f!==P.version||p!==i.toneMapping)&&(u.material.needsUpdate=!0,h=P,f=P.version,p=i.toneMapping),u.layers.enableAll(),M.unshift(u,u.geometry,u.material,0,0,null)):P&&P.isTexture&&(c===void 0&&(c=new et(new Ra(2,2),new oi({name:"BackgroundMaterial",uniforms:_r(Xn.background.uniforms),vertexShader:Xn.background.vertexShader,fragmentShader:Xn.background.fragmentShader,side:gs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=P,c.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,c.material.toneMapped=_t.getTransfer(P.colorSpace)!==Pt,P.matrixAutoUpdate===!0&&P.updateMatrix(),c.material.uniforms.uvTransform.value.copy(P.matrix),(h!==P||f!==P.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,h=P,f=P.version,p=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function d(M,y){M.getRGB(yh,If(i)),n.buffers.color.setClear(yh.r,yh.g,yh.b,y,o)}function b(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(M,y=1){a.set(M),l=y,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(M){l=M,d(a,l)},render:v,addToRenderList:g,dispose:b}}function FM(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(w,T,B,H,V){let W=!1,q=h(H,B,T);r!==q&&(r=q,c(r.object)),W=p(w,H,B,V),W&&m(w,H,B,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,y(w,T,B,H),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(w){return i.bindVertexArray(w)}function u(w){return i.deleteVertexArray(w)}function h(w,T,B){let H=B.wireframe===!0,V=n[w.id];V===void 0&&(V={},n[w.id]=V);let W=V[T.id];W===void 0&&(W={},V[T.id]=W);let q=W[H];return q===void 0&&(q=f(l()),W[H]=q),q}function f(w){let T=[],B=[],H=[];for(let V=0;V<t;V++)T[V]=0,B[V]=0,H[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:T,enabledAttributes:B,attributeDivisors:H,object:w,attributes:{},index:null}}function p(w,T,B,H){let V=r.attributes,W=T.attributes,q=0,F=B.getAttributes();for(let z in F)if(F[z].location>=0){let ne=V[z],te=W[z];if(te===void 0&&(z==="instanceMatrix"&&w.instanceMatrix&&(te=w.instanceMatrix),z==="instanceColor"&&w.instanceColor&&(te=w.instanceColor)),ne===void 0||ne.attribute!==te||te&&ne.data!==te.data)return!0;q++}return r.attributesNum!==q||r.index!==H}function m(w,T,B,H){let V={},W=T.attributes,q=0,F=B.getAttributes();for(let z in F)if(F[z].location>=0){let ne=W[z];ne===void 0&&(z==="instanceMatrix"&&w.instanceMatrix&&(ne=w.instanceMatrix),z==="instanceColor"&&w.instanceColor&&(ne=w.instanceColor));let te={};te.attribute=ne,ne&&ne.data&&(te.data=ne.data),V[z]=te,q++}r.attributes=V,r.attributesNum=q,r.index=H}function v(){let w=r.newAttributes;for(let T=0,B=w.length;T<B;T++)w[T]=0}function g(w){d(w,0)}function d(w,T){let B=r.newAttributes,H=r.enabledAttributes,V=r.attributeDivisors;B[w]=1,H[w]===0&&(i.enableVertexAttribArray(w),H[w]=1),V[w]!==T&&(i.vertexAttribDivisor(w,T),V[w]=T)}function b(){let w=r.newAttributes,T=r.enabledAttributes;for(let B=0,H=T.length;B<H;B++)T[B]!==w[B]&&(i.disableVertexAttribArray(B),T[B]=0)}function M(w,T,B,H,V,W,q){q===!0?i.vertexAttribIPointer(w,T,B,V,W):i.vertexAttribPointer(w,T,B,H,V,W)}function y(w,T,B,H){v();let V=H.attributes,W=B.getAttributes(),q=T.defaultAttributeValues;for(let F in W){let z=W[F];if(z.location>=0){let J=V[F];if(J===void 0&&(F==="instanceMatrix"&&w.instanceMatrix&&(J=w.instanceMatrix),F==="instanceColor"&&w.instanceColor&&(J=w.instanceColor)),J!==void 0){let ne=J.normalized,te=J.itemSize,ce=e.get(J);if(ce===void 0)continue;let fe=ce.buffer,xe=ce.type,Ie=ce.bytesPerElement,Q=xe===i.INT||xe===i.UNSIGNED_INT||J.gpuType===kc;if(J.isInterleavedBufferAttribute){let X=J.data,me=X.stride,ve=J.offset;if(X.isInstancedInterleavedBuffer){for(let ye=0;ye<z.locationSize;ye++)d(z.location+ye,X.meshPerAttribute);w.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=X.meshPerAttribute*X.count)}else for(let ye=0;ye<z.locationSize;ye++)g(z.location+ye);i.bindBuffer(i.ARRAY_BUFFER,fe);for(let ye=0;ye<z.locationSize;ye++)M(z.location+ye,te/z.locationSize,xe,ne,me*Ie,(ve+te/z.locationSize*ye)*Ie,Q)}else{if(J.isInstancedBufferAttribute){for(let X=0;X<z.locationSize;X++)d(z.location+X,J.meshPerAttribute);w.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let X=0;X<z.locationSize;X++)g(z.location+X);i.bindBuffer(i.ARRAY_BUFFER,fe);for(let X=0;X<z.locationSize;X++)M(z.location+X,te/z.locationSize,xe,ne,te*Ie,te/z.locationSize*X*Ie,Q)}}else if(q!==void 0){let ne=q[F];if(ne!==void 0)switch(ne.length){case 2:i.vertexAttrib2fv(z.location,ne);break;case 3:i.vertexAttrib3fv(z.location,ne);break;case 4:i.vertexAttrib4fv(z.location,ne);break;default:i.vertexAttrib1fv(z.location,ne)}}}}b()}function P(){D();for(let w in n){let T=n[w];for(let B in T){let H=T[B];for(let V in H)u(H[V].object),delete H[V];delete T[B]}delete n[w]}}function E(w){if(n[w.id]===void 0)return;let T=n[w.id];for(let B in T){let H=T[B];for(let V in H)u(H[V].object),delete H[V];delete T[B]}delete n[w.id]}function I(w){for(let T in n){let B=n[T];if(B[w.id]===void 0)continue;let H=B[w.id];for(let V in H)u(H[V].object),delete H[V];delete B[w.id]}}function D(){S(),o=!0,r!==s&&(r=s,c(r.object))}function S(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:S,dispose:P,releaseStatesOfGeometry:E,releaseStatesOfProgram:I,initAttributes:v,enableAttribute:g,disableUnusedAttributes:b}}function OM(i,e,t){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),t.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),t.update(u,n,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let p=0;for(let m=0;m<h;m++)p+=u[m];t.update(p,n,1)}function l(c,u,h,f){if(h===0)return;let p=e.get("WEBGL_multi_draw");if(p===null)for(let m=0;m<c.length;m++)o(c[m],u[m],f[m]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let m=0;for(let v=0;v<h;v++)m+=u[v]*f[v];t.update(m,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function BM(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let I=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(I.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(I){return!(I!==vi&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(I){let D=I===Mo&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(I!==Fi&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&I!==es&&!D)}function l(I){if(I==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";I="mediump"}return I==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.logarithmicDepthBuffer===!0,f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=m>0,E=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:m,maxTextureSize:v,maxCubemapSize:g,maxAttributes:d,maxVertexUniforms:b,maxVaryings:M,maxFragmentUniforms:y,vertexTextures:P,maxSamples:E}}function zM(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Zn,a=new ct,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||n!==0||s;return s=f,n=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,p){let m=h.clippingPlanes,v=h.clipIntersection,g=h.clipShadows,d=i.get(h);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let b=r?0:n,M=b*4,y=d.clippingState||null;l.value=y,y=u(m,f,M,p);for(let P=0;P!==M;++P)y[P]=t[P];d.clippingState=y,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,f,p,m){let v=h!==null?h.length:0,g=null;if(v!==0){if(g=l.value,m!==!0||g===null){let d=p+v*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(g===null||g.length<d)&&(g=new Float32Array(d));for(let M=0,y=p;M!==v;++M,y+=4)o.copy(h[M]).applyMatrix4(b,a),o.normal.toArray(g,y),g[y+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}function kM(i){let e=new WeakMap;function t(o,a){return a===Oc?o.mapping=gr:a===Bc&&(o.mapping=vr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Oc||a===Bc)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new ac(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var To=4,Qm=[.125,.215,.35,.446,.526,.582],Mr=20,Ff=new mr,eg=new at,Of=null,Bf=0,zf=0,kf=!1,br=(1+Math.sqrt(5))/2,Eo=1/br,tg=[new L(-br,Eo,0),new L(br,Eo,0),new L(-Eo,0,br),new L(Eo,0,br),new L(0,br,-Eo),new L(0,br,Eo),new L(-1,1,-1),new L(1,1,-1),new L(-1,1,1),new L(1,1,1)],HM=new L,wh=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=HM}=r;Of=this._renderer.getRenderTarget(),Bf=this._renderer.getActiveCubeFace(),zf=this._renderer.getActiveMipmapLevel(),kf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=sg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ig(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Of,Bf,zf),this._renderer.xr.enabled=kf,e.scissorTest=!1,bh(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===gr||e.mapping===vr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Of=this._renderer.getRenderTarget(),Bf=this._renderer.getActiveCubeFace(),zf=this._renderer.getActiveMipmapLevel(),kf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:Ii,minFilter:Ii,generateMipmaps:!1,type:Mo,format:vi,colorSpace:cr,depthBuffer:!1},s=ng(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=ng(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=VM(r)),this._blurMaterial=GM(r,e,t)}return s}_compileMaterial(e){let t=new et(this._lodPlanes[0],e);this._renderer.compile(t,Ff)}_sceneToCubeUV(e,t,n,s,r){let l=new In(90,1,t,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,p=h.toneMapping;h.getClearColor(eg),h.toneMapping=xs,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let v=new Ui({name:"PMREM.Background",side:Gn,depthWrite:!1,depthTest:!1}),g=new et(new ji,v),d=!1,b=e.background;b?b.isColor&&(v.color.copy(b),e.background=null,d=!0):(v.color.copy(eg),d=!0);for(let M=0;M<6;M++){let y=M%3;y===0?(l.up.set(0,c[M],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[M],r.y,r.z)):y===1?(l.up.set(0,0,c[M]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[M],r.z)):(l.up.set(0,c[M],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[M]));let P=this._cubeSize;bh(s,y*P,M>2?P:0,P,P),h.setRenderTarget(s),d&&h.render(g,l),h.render(e,l)}g.geometry.dispose(),g.material.dispose(),h.toneMapping=p,h.autoClear=f,e.background=b}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===gr||e.mapping===vr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=sg()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=ig());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new et(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;bh(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,Ff)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=tg[(s-r-1)%tg.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new et(this._lodPlanes[s],c),f=c.uniforms,p=this._sizeLods[n]-1,m=isFinite(r)?Math.PI/(2*p):2*Math.PI/(2*Mr-1),v=r/m,g=isFinite(r)?1+Math.floor(u*v):Mr;g>Mr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${Mr}`);let d=[],b=0;for(let I=0;I<Mr;++I){let D=I/v,S=Math.exp(-D*D/2);d.push(S),I===0?b+=S:I<g&&(b+=2*S)}for(let I=0;I<d.length;I++)d[I]=d[I]/b;f.envMap.value=e.texture,f.samples.value=g,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:M}=this;f.dTheta.value=m,f.mipInt.value=M-n;let y=this._sizeLods[s],P=3*y*(s>M-To?s-M+To:0),E=4*(this._cubeSize-y);bh(t,P,E,3*y,2*y),l.setRenderTarget(t),l.render(h,Ff)}};function VM(i){let e=[],t=[],n=[],s=i,r=i-To+1+Qm.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>i-To?l=Qm[o-i+To-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],p=6,m=6,v=3,g=2,d=1,b=new Float32Array(v*m*p),M=new Float32Array(g*m*p),y=new Float32Array(d*m*p);for(let E=0;E<p;E++){let I=E%3*2/3-1,D=E>2?0:-1,S=[I,D,0,I+2/3,D,0,I+2/3,D+1,0,I,D,0,I+2/3,D+1,0,I,D+1,0];b.set(S,v*m*E),M.set(f,g*m*E);let w=[E,E,E,E,E,E];y.set(w,d*m*E)}let P=new Ot;P.setAttribute("position",new Jt(b,v)),P.setAttribute("uv",new Jt(M,g)),P.setAttribute("faceIndex",new Jt(y,d)),e.push(P),s>To&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function ng(i,e,t){let n=new Ki(i,e,t);return n.texture.mapping=Ha,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function bh(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function GM(i,e,t){let n=new Float32Array(Mr),s=new L(0,1,0);return new oi({name:"SphericalGaussianBlur",defines:{n:Mr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Kf(),fragmentShader:`

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
		`,blending:_s,depthTest:!1,depthWrite:!1})}function ig(){return new oi({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Kf(),fragmentShader:`

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
		`,blending:_s,depthTest:!1,depthWrite:!1})}function sg(){return new oi({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Kf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:_s,depthTest:!1,depthWrite:!1})}function Kf(){return`

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
	`}function WM(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Oc||l===Bc,u=l===gr||l===vr;if(c||u){let h=e.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new wh(i)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{let p=a.image;return c&&p&&p.height>0||u&&p&&s(p)?(t===null&&(t=new wh(i)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function XM(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&uo("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function qM(i,e,t,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&e.remove(f.index);for(let m in f.attributes)e.remove(f.attributes[m]);f.removeEventListener("dispose",o),delete s[f.id];let p=r.get(f);p&&(e.remove(p),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(h){let f=h.attributes;for(let p in f)e.update(f[p],i.ARRAY_BUFFER)}function c(h){let f=[],p=h.index,m=h.attributes.position,v=0;if(p!==null){let b=p.array;v=p.version;for(let M=0,y=b.length;M<y;M+=3){let P=b[M+0],E=b[M+1],I=b[M+2];f.push(P,E,E,I,I,P)}}else if(m!==void 0){let b=m.array;v=m.version;for(let M=0,y=b.length/3-1;M<y;M+=3){let P=M+0,E=M+1,I=M+2;f.push(P,E,E,I,I,P)}}else return;let g=new(Pf(f)?_a:va)(f,1);g.version=v;let d=r.get(h);d&&e.remove(d),r.set(h,g)}function u(h){let f=r.get(h);if(f){let p=h.index;p!==null&&f.version<p.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function YM(i,e,t){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,p){i.drawElements(n,p,r,f*o),t.update(p,n,1)}function c(f,p,m){m!==0&&(i.drawElementsInstanced(n,p,r,f*o,m),t.update(p,n,m))}function u(f,p,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,r,f,0,m);let g=0;for(let d=0;d<m;d++)g+=p[d];t.update(g,n,1)}function h(f,p,m,v){if(m===0)return;let g=e.get("WEBGL_multi_draw");if(g===null)for(let d=0;d<f.length;d++)c(f[d]/o,p[d],v[d]);else{g.multiDrawElementsInstancedWEBGL(n,p,0,r,f,0,v,0,m);let d=0;for(let b=0;b<m;b++)d+=p[b]*v[b];t.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function $M(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function ZM(i,e,t){let n=new WeakMap,s=new It;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let S=function(){I.dispose(),n.delete(a),a.removeEventListener("dispose",S)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],M=0;p===!0&&(M=1),m===!0&&(M=2),v===!0&&(M=3);let y=a.attributes.position.count*M,P=1;y>e.maxTextureSize&&(P=Math.ceil(y/e.maxTextureSize),y=e.maxTextureSize);let E=new Float32Array(y*P*4*h),I=new ma(E,y,P,h);I.type=es,I.needsUpdate=!0;let D=M*4;for(let w=0;w<h;w++){let T=g[w],B=d[w],H=b[w],V=y*P*4*w;for(let W=0;W<T.count;W++){let q=W*D;p===!0&&(s.fromBufferAttribute(T,W),E[V+q+0]=s.x,E[V+q+1]=s.y,E[V+q+2]=s.z,E[V+q+3]=0),m===!0&&(s.fromBufferAttribute(B,W),E[V+q+4]=s.x,E[V+q+5]=s.y,E[V+q+6]=s.z,E[V+q+7]=0),v===!0&&(s.fromBufferAttribute(H,W),E[V+q+8]=s.x,E[V+q+9]=s.y,E[V+q+10]=s.z,E[V+q+11]=H.itemSize===4?s.w:1)}}f={count:h,texture:I,size:new Oe(y,P)},n.set(a,f),a.addEventListener("dispose",S)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let p=0;for(let v=0;v<c.length;v++)p+=c[v];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function KM(i,e,t,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var wg=new Kn,rg=new wa(1,1),Sg=new ma,Eg=new rc,Tg=new ya,og=[],ag=[],lg=new Float32Array(16),cg=new Float32Array(9),hg=new Float32Array(4);function Ro(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=og[s];if(r===void 0&&(r=new Float32Array(s),og[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function ln(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function cn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Eh(i,e){let t=ag[e];t===void 0&&(t=new Int32Array(e),ag[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function JM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function jM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(ln(t,e))return;i.uniform2fv(this.addr,e),cn(t,e)}}function QM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(ln(t,e))return;i.uniform3fv(this.addr,e),cn(t,e)}}function ew(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(ln(t,e))return;i.uniform4fv(this.addr,e),cn(t,e)}}function tw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(ln(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),cn(t,e)}else{if(ln(t,n))return;hg.set(n),i.uniformMatrix2fv(this.addr,!1,hg),cn(t,n)}}function nw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(ln(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),cn(t,e)}else{if(ln(t,n))return;cg.set(n),i.uniformMatrix3fv(this.addr,!1,cg),cn(t,n)}}function iw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(ln(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),cn(t,e)}else{if(ln(t,n))return;lg.set(n),i.uniformMatrix4fv(this.addr,!1,lg),cn(t,n)}}function sw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function rw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(ln(t,e))return;i.uniform2iv(this.addr,e),cn(t,e)}}function ow(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(ln(t,e))return;i.uniform3iv(this.addr,e),cn(t,e)}}function aw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(ln(t,e))return;i.uniform4iv(this.addr,e),cn(t,e)}}function lw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function cw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(ln(t,e))return;i.uniform2uiv(this.addr,e),cn(t,e)}}function hw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(ln(t,e))return;i.uniform3uiv(this.addr,e),cn(t,e)}}function uw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(ln(t,e))return;i.uniform4uiv(this.addr,e),cn(t,e)}}function fw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(rg.compareFunction=Af,r=rg):r=wg,t.setTexture2D(e||r,s)}function dw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Eg,s)}function pw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Tg,s)}function mw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Sg,s)}function gw(i){switch(i){case 5126:return JM;case 35664:return jM;case 35665:return QM;case 35666:return ew;case 35674:return tw;case 35675:return nw;case 35676:return iw;case 5124:case 35670:return sw;case 35667:case 35671:return rw;case 35668:case 35672:return ow;case 35669:case 35673:return aw;case 5125:return lw;case 36294:return cw;case 36295:return hw;case 36296:return uw;case 35678:case 36198:case 36298:case 36306:case 35682:return fw;case 35679:case 36299:case 36307:return dw;case 35680:case 36300:case 36308:case 36293:return pw;case 36289:case 36303:case 36311:case 36292:return mw}}function vw(i,e){i.uniform1fv(this.addr,e)}function _w(i,e){let t=Ro(e,this.size,2);i.uniform2fv(this.addr,t)}function xw(i,e){let t=Ro(e,this.size,3);i.uniform3fv(this.addr,t)}function yw(i,e){let t=Ro(e,this.size,4);i.uniform4fv(this.addr,t)}function bw(i,e){let t=Ro(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Mw(i,e){let t=Ro(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function ww(i,e){let t=Ro(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Sw(i,e){i.uniform1iv(this.addr,e)}function Ew(i,e){i.uniform2iv(this.addr,e)}function Tw(i,e){i.uniform3iv(this.addr,e)}function Aw(i,e){i.uniform4iv(this.addr,e)}function Rw(i,e){i.uniform1uiv(this.addr,e)}function Cw(i,e){i.uniform2uiv(this.addr,e)}function Pw(i,e){i.uniform3uiv(this.addr,e)}function Iw(i,e){i.uniform4uiv(this.addr,e)}function Lw(i,e,t){let n=this.cache,s=e.length,r=Eh(t,s);ln(n,r)||(i.uniform1iv(this.addr,r),cn(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||wg,r[o])}function Dw(i,e,t){let n=this.cache,s=e.length,r=Eh(t,s);ln(n,r)||(i.uniform1iv(this.addr,r),cn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Eg,r[o])}function Uw(i,e,t){let n=this.cache,s=e.length,r=Eh(t,s);ln(n,r)||(i.uniform1iv(this.addr,r),cn(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||Tg,r[o])}function Nw(i,e,t){let n=this.cache,s=e.length,r=Eh(t,s);ln(n,r)||(i.uniform1iv(this.addr,r),cn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Sg,r[o])}function Fw(i){switch(i){case 5126:return vw;case 35664:return _w;case 35665:return xw;case 35666:return yw;case 35674:return bw;case 35675:return Mw;case 35676:return ww;case 5124:case 35670:return Sw;case 35667:case 35671:return Ew;case 35668:case 35672:return Tw;case 35669:case 35673:return Aw;case 5125:return Rw;case 36294:return Cw;case 36295:return Pw;case 36296:return Iw;case 35678:case 36198:case 36298:case 36306:case 35682:return Lw;case 35679:case 36299:case 36307:return Dw;case 35680:case 36300:case 36308:case 36293:return Uw;case 36289:case 36303:case 36311:case 36292:return Nw}}var Vf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=gw(t.type)}},Gf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Fw(t.type)}},Wf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Hf=/(\w+)(\])?(\[|\.)?/g;function ug(i,e){i.seq.push(e),i.map[e.id]=e}function Ow(i,e,t){let n=i.name,s=n.length;for(Hf.lastIndex=0;;){let r=Hf.exec(n),o=Hf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ug(t,c===void 0?new Vf(a,i,e):new Gf(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new Wf(a),ug(t,h)),t=h}}}var Ao=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);Ow(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function fg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Bw=37297,zw=0;function kw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var dg=new ct;function Hw(i){_t._getMatrix(dg,_t.workingColorSpace,i);let e=`mat3( ${dg.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(i)){case fa:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function pg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+kw(i.getShaderSource(e),a)}else return r}function Vw(i,e){let t=Hw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function Gw(i,e){let t;switch(e){case Pm:t="Linear";break;case Im:t="Reinhard";break;case Lm:t="Cineon";break;case Dm:t="ACESFilmic";break;case Nm:t="AgX";break;case Fm:t="Neutral";break;case Um:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Mh=new L;function Ww(){_t.getLuminanceCoefficients(Mh);let i=Mh.x.toFixed(4),e=Mh.y.toFixed(4),t=Mh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Xw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($a).join(`
`)}function qw(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Yw(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function $a(i){return i!==""}function mg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function gg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var $w=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xf(i){return i.replace($w,Kw)}var Zw=new Map;function Kw(i,e){let t=ft[e];if(t===void 0){let n=Zw.get(e);if(n!==void 0)t=ft[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return Xf(t)}var Jw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function vg(i){return i.replace(Jw,jw)}function jw(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function _g(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}function Qw(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===hf?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===cm?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Qi&&(e="SHADOWMAP_TYPE_VSM"),e}function eS(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case gr:case vr:e="ENVMAP_TYPE_CUBE";break;case Ha:e="ENVMAP_TYPE_CUBE_UV";break}return e}function tS(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case vr:e="ENVMAP_MODE_REFRACTION";break}return e}function nS(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case pf:e="ENVMAP_BLENDING_MULTIPLY";break;case Rm:e="ENVMAP_BLENDING_MIX";break;case Cm:e="ENVMAP_BLENDING_ADD";break}return e}function iS(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function sS(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Qw(t),c=eS(t),u=tS(t),h=nS(t),f=iS(t),p=Xw(t),m=qw(r),v=s.createProgram(),g,d,b=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter($a).join(`
`),g.length>0&&(g+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter($a).join(`
`),d.length>0&&(d+=`
`)):(g=[_g(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($a).join(`
`),d=[_g(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==xs?"#define TONE_MAPPING":"",t.toneMapping!==xs?ft.tonemapping_pars_fragment:"",t.toneMapping!==xs?Gw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,Vw("linearToOutputTexel",t.outputColorSpace),Ww(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter($a).join(`
`)),o=Xf(o),o=mg(o,t),o=gg(o,t),a=Xf(a),a=mg(a,t),a=gg(a,t),o=vg(o),a=vg(a),t.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,g=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,d=["#define varying in",t.glslVersion===Rf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Rf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let M=b+g+o,y=b+d+a,P=fg(s,s.VERTEX_SHADER,M),E=fg(s,s.FRAGMENT_SHADER,y);s.attachShader(v,P),s.attachShader(v,E),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function I(T){if(i.debug.checkShaderErrors){let B=s.getProgramInfoLog(v)||"",H=s.getShaderInfoLog(P)||"",V=s.getShaderInfoLog(E)||"",W=B.trim(),q=H.trim(),F=V.trim(),z=!0,J=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,P,E);else{let ne=pg(s,P,"vertex"),te=pg(s,E,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+W+`
`+ne+`
`+te)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(q===""||F==="")&&(J=!1);J&&(T.diagnostics={runnable:z,programLog:W,vertexShader:{log:q,prefix:g},fragmentShader:{log:F,prefix:d}})}s.deleteShader(P),s.deleteShader(E),D=new Ao(s,v),S=Yw(s,v)}let D;this.getUniforms=function(){return D===void 0&&I(this),D};let S;this.getAttributes=function(){return S===void 0&&I(this),S};let w=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return w===!1&&(w=s.getProgramParameter(v,Bw)),w},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=zw++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=P,this.fragmentShader=E,this}var rS=0,qf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Yf(e),t.set(e,n)),n}},Yf=class{constructor(e){this.id=rS++,this.code=e,this.usedTimes=0}};function oS(i,e,t,n,s,r,o){let a=new ga,l=new qf,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,p=s.precision,m={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(S){return c.add(S),S===0?"uv":`uv${S}`}function g(S,w,T,B,H){let V=B.fog,W=H.geometry,q=S.isMeshStandardMaterial?B.environment:null,F=(S.isMeshStandardMaterial?t:e).get(S.envMap||q),z=F&&F.mapping===Ha?F.image.height:null,J=m[S.type];S.precision!==null&&(p=s.getMaxPrecision(S.precision),p!==S.precision&&console.warn("THREE.WebGLProgram.getParameters:",S.precision,"not supported, using",p,"instead."));let ne=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,te=ne!==void 0?ne.length:0,ce=0;W.morphAttributes.position!==void 0&&(ce=1),W.morphAttributes.normal!==void 0&&(ce=2),W.morphAttributes.color!==void 0&&(ce=3);let fe,xe,Ie,Q;if(J){let xt=Xn[J];fe=xt.vertexShader,xe=xt.fragmentShader}else fe=S.vertexShader,xe=S.fragmentShader,l.update(S),Ie=l.getVertexShaderID(S),Q=l.getFragmentShaderID(S);let X=i.getRenderTarget(),me=i.state.buffers.depth.getReversed(),ve=H.isInstancedMesh===!0,ye=H.isBatchedMesh===!0,Ge=!!S.map,dt=!!S.matcap,k=!!F,ht=!!S.aoMap,se=!!S.lightMap,Me=!!S.bumpMap,Ce=!!S.normalMap,ot=!!S.displacementMap,re=!!S.emissiveMap,ee=!!S.metalnessMap,ue=!!S.roughnessMap,we=S.anisotropy>0,C=S.clearcoat>0,x=S.dispersion>0,N=S.iridescence>0,Y=S.sheen>0,le=S.transmission>0,oe=we&&!!S.anisotropyMap,Ue=C&&!!S.clearcoatMap,_e=C&&!!S.clearcoatNormalMap,Fe=C&&!!S.clearcoatRoughnessMap,Be=N&&!!S.iridescenceMap,ge=N&&!!S.iridescenceThicknessMap,Re=Y&&!!S.sheenColorMap,qe=Y&&!!S.sheenRoughnessMap,Ye=!!S.specularMap,Le=!!S.specularColorMap,Ze=!!S.specularIntensityMap,$=le&&!!S.transmissionMap,Ee=le&&!!S.thicknessMap,Ae=!!S.gradientMap,Ve=!!S.alphaMap,Se=S.alphaTest>0,pe=!!S.alphaHash,$e=!!S.extensions,st=xs;S.toneMapped&&(X===null||X.isXRRenderTarget===!0)&&(st=i.toneMapping);let Lt={shaderID:J,shaderType:S.type,shaderName:S.name,vertexShader:fe,fragmentShader:xe,defines:S.defines,customVertexShaderID:Ie,customFragmentShaderID:Q,isRawShaderMaterial:S.isRawShaderMaterial===!0,glslVersion:S.glslVersion,precision:p,batching:ye,batchingColor:ye&&H._colorsTexture!==null,instancing:ve,instancingColor:ve&&H.instanceColor!==null,instancingMorph:ve&&H.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:X===null?i.outputColorSpace:X.isXRRenderTarget===!0?X.texture.colorSpace:cr,alphaToCoverage:!!S.alphaToCoverage,map:Ge,matcap:dt,envMap:k,envMapMode:k&&F.mapping,envMapCubeUVHeight:z,aoMap:ht,lightMap:se,bumpMap:Me,normalMap:Ce,displacementMap:f&&ot,emissiveMap:re,normalMapObjectSpace:Ce&&S.normalMapType===km,normalMapTangentSpace:Ce&&S.normalMapType===Sf,metalnessMap:ee,roughnessMap:ue,anisotropy:we,anisotropyMap:oe,clearcoat:C,clearcoatMap:Ue,clearcoatNormalMap:_e,clearcoatRoughnessMap:Fe,dispersion:x,iridescence:N,iridescenceMap:Be,iridescenceThicknessMap:ge,sheen:Y,sheenColorMap:Re,sheenRoughnessMap:qe,specularMap:Ye,specularColorMap:Le,specularIntensityMap:Ze,transmission:le,transmissionMap:$,thicknessMap:Ee,gradientMap:Ae,opaque:S.transparent===!1&&S.blending===ar&&S.alphaToCoverage===!1,alphaMap:Ve,alphaTest:Se,alphaHash:pe,combine:S.combine,mapUv:Ge&&v(S.map.channel),aoMapUv:ht&&v(S.aoMap.channel),lightMapUv:se&&v(S.lightMap.channel),bumpMapUv:Me&&v(S.bumpMap.channel),normalMapUv:Ce&&v(S.normalMap.channel),displacementMapUv:ot&&v(S.displacementMap.channel),emissiveMapUv:re&&v(S.emissiveMap.channel),metalnessMapUv:ee&&v(S.metalnessMap.channel),roughnessMapUv:ue&&v(S.roughnessMap.channel),anisotropyMapUv:oe&&v(S.anisotropyMap.channel),clearcoatMapUv:Ue&&v(S.clearcoatMap.channel),clearcoatNormalMapUv:_e&&v(S.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Fe&&v(S.clearcoatRoughnessMap.channel),iridescenceMapUv:Be&&v(S.iridescenceMap.channel),iridescenceThicknessMapUv:ge&&v(S.iridescenceThicknessMap.channel),sheenColorMapUv:Re&&v(S.sheenColorMap.channel),sheenRoughnessMapUv:qe&&v(S.sheenRoughnessMap.channel),specularMapUv:Ye&&v(S.specularMap.channel),specularColorMapUv:Le&&v(S.specularColorMap.channel),specularIntensityMapUv:Ze&&v(S.specularIntensityMap.channel),transmissionMapUv:$&&v(S.transmissionMap.channel),thicknessMapUv:Ee&&v(S.thicknessMap.channel),alphaMapUv:Ve&&v(S.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Ce||we),vertexColors:S.vertexColors,vertexAlphas:S.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:H.isPoints===!0&&!!W.attributes.uv&&(Ge||Ve),fog:!!V,useFog:S.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:S.flatShading===!0&&S.wireframe===!1,sizeAttenuation:S.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:me,skinning:H.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ce,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:S.dithering,shadowMapEnabled:i.shadowMap.enabled&&T.length>0,shadowMapType:i.shadowMap.type,toneMapping:st,decodeVideoTexture:Ge&&S.map.isVideoTexture===!0&&_t.getTransfer(S.map.colorSpace)===Pt,decodeVideoTextureEmissive:re&&S.emissiveMap.isVideoTexture===!0&&_t.getTransfer(S.emissiveMap.colorSpace)===Pt,premultipliedAlpha:S.premultipliedAlpha,doubleSided:S.side===Wn,flipSided:S.side===Gn,useDepthPacking:S.depthPacking>=0,depthPacking:S.depthPacking||0,index0AttributeName:S.index0AttributeName,extensionClipCullDistance:$e&&S.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:($e&&S.extensions.multiDraw===!0||ye)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:S.customProgramCacheKey()};return Lt.vertexUv1s=c.has(1),Lt.vertexUv2s=c.has(2),Lt.vertexUv3s=c.has(3),c.clear(),Lt}function d(S){let w=[];if(S.shaderID?w.push(S.shaderID):(w.push(S.customVertexShaderID),w.push(S.customFragmentShaderID)),S.defines!==void 0)for(let T in S.defines)w.push(T),w.push(S.defines[T]);return S.isRawShaderMaterial===!1&&(b(w,S),M(w,S),w.push(i.outputColorSpace)),w.push(S.customProgramCacheKey),w.join()}function b(S,w){S.push(w.precision),S.push(w.outputColorSpace),S.push(w.envMapMode),S.push(w.envMapCubeUVHeight),S.push(w.mapUv),S.push(w.alphaMapUv),S.push(w.lightMapUv),S.push(w.aoMapUv),S.push(w.bumpMapUv),S.push(w.normalMapUv),S.push(w.displacementMapUv),S.push(w.emissiveMapUv),S.push(w.metalnessMapUv),S.push(w.roughnessMapUv),S.push(w.anisotropyMapUv),S.push(w.clearcoatMapUv),S.push(w.clearcoatNormalMapUv),S.push(w.clearcoatRoughnessMapUv),S.push(w.iridescenceMapUv),S.push(w.iridescenceThicknessMapUv),S.push(w.sheenColorMapUv),S.push(w.sheenRoughnessMapUv),S.push(w.specularMapUv),S.push(w.specularColorMapUv),S.push(w.specularIntensityMapUv),S.push(w.transmissionMapUv),S.push(w.thicknessMapUv),S.push(w.combine),S.push(w.fogExp2),S.push(w.sizeAttenuation),S.push(w.morphTargetsCount),S.push(w.morphAttributeCount),S.push(w.numDirLights),S.push(w.numPointLights),S.push(w.numSpotLights),S.push(w.numSpotLightMaps),S.push(w.numHemiLights),S.push(w.numRectAreaLights),S.push(w.numDirLightShadows),S.push(w.numPointLightShadows),S.push(w.numSpotLightShadows),S.push(w.numSpotLightShadowsWithMaps),S.push(w.numLightProbes),S.push(w.shadowMapType),S.push(w.toneMapping),S.push(w.numClippingPlanes),S.push(w.numClipIntersection),S.push(w.depthPacking)}function M(S,w){a.disableAll(),w.supportsVertexTextures&&a.enable(0),w.instancing&&a.enable(1),w.instancingColor&&a.enable(2),w.instancingMorph&&a.enable(3),w.matcap&&a.enable(4),w.envMap&&a.enable(5),w.normalMapObjectSpace&&a.enable(6),w.normalMapTangentSpace&&a.enable(7),w.clearcoat&&a.enable(8),w.iridescence&&a.enable(9),w.alphaTest&&a.enable(10),w.vertexColors&&a.enable(11),w.vertexAlphas&&a.enable(12),w.vertexUv1s&&a.enable(13),w.vertexUv2s&&a.enable(14),w.vertexUv3s&&a.enable(15),w.vertexTangents&&a.enable(16),w.anisotropy&&a.enable(17),w.alphaHash&&a.enable(18),w.batching&&a.enable(19),w.dispersion&&a.enable(20),w.batchingColor&&a.enable(21),w.gradientMap&&a.enable(22),S.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),S.push(a.mask)}function y(S){let w=m[S.type],T;if(w){let B=Xn[w];T=Ya.clone(B.uniforms)}else T=S.uniforms;return T}function P(S,w){let T;for(let B=0,H=u.length;B<H;B++){let V=u[B];if(V.cacheKey===w){T=V,++T.usedTimes;break}}return T===void 0&&(T=new sS(i,w,S,r),u.push(T)),T}function E(S){if(--S.usedTimes===0){let w=u.indexOf(S);u[w]=u[u.length-1],u.pop(),S.destroy()}}function I(S){l.remove(S)}function D(){l.dispose()}return{getParameters:g,getProgramCacheKey:d,getUniforms:y,acquireProgram:P,releaseProgram:E,releaseShaderCache:I,programs:u,dispose:D}}function aS(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function lS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function xg(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function yg(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h,f,p,m,v,g){let d=i[e];return d===void 0?(d={id:h.id,object:h,geometry:f,material:p,groupOrder:m,renderOrder:h.renderOrder,z:v,group:g},i[e]=d):(d.id=h.id,d.object=h,d.geometry=f,d.material=p,d.groupOrder=m,d.renderOrder=h.renderOrder,d.z=v,d.group=g),e++,d}function a(h,f,p,m,v,g){let d=o(h,f,p,m,v,g);p.transmission>0?n.push(d):p.transparent===!0?s.push(d):t.push(d)}function l(h,f,p,m,v,g){let d=o(h,f,p,m,v,g);p.transmission>0?n.unshift(d):p.transparent===!0?s.unshift(d):t.unshift(d)}function c(h,f){t.length>1&&t.sort(h||lS),n.length>1&&n.sort(f||xg),s.length>1&&s.sort(f||xg)}function u(){for(let h=e,f=i.length;h<f;h++){let p=i[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function cS(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new yg,i.set(n,[o])):s>=r.length?(o=new yg,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function hS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new L,color:new at};break;case"SpotLight":t={position:new L,direction:new L,color:new at,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new L,color:new at,distance:0,decay:0};break;case"HemisphereLight":t={direction:new L,skyColor:new at,groundColor:new at};break;case"RectAreaLight":t={color:new at,position:new L,halfWidth:new L,halfHeight:new L};break}return i[e.id]=t,t}}}function uS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Oe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Oe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Oe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var fS=0;function dS(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function pS(i){let e=new hS,t=uS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new L);let s=new L,r=new Ut,o=new Ut;function a(c){let u=0,h=0,f=0;for(let S=0;S<9;S++)n.probe[S].set(0,0,0);let p=0,m=0,v=0,g=0,d=0,b=0,M=0,y=0,P=0,E=0,I=0;c.sort(dS);for(let S=0,w=c.length;S<w;S++){let T=c[S],B=T.color,H=T.intensity,V=T.distance,W=T.shadow&&T.shadow.map?T.shadow.map.texture:null;if(T.isAmbientLight)u+=B.r*H,h+=B.g*H,f+=B.b*H;else if(T.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(T.sh.coefficients[q],H);I++}else if(T.isDirectionalLight){let q=e.get(T);if(q.color.copy(T.color).multiplyScalar(T.intensity),T.castShadow){let F=T.shadow,z=t.get(T);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,n.directionalShadow[p]=z,n.directionalShadowMap[p]=W,n.directionalShadowMatrix[p]=T.shadow.matrix,b++}n.directional[p]=q,p++}else if(T.isSpotLight){let q=e.get(T);q.position.setFromMatrixPosition(T.matrixWorld),q.color.copy(B).multiplyScalar(H),q.distance=V,q.coneCos=Math.cos(T.angle),q.penumbraCos=Math.cos(T.angle*(1-T.penumbra)),q.decay=T.decay,n.spot[v]=q;let F=T.shadow;if(T.map&&(n.spotLightMap[P]=T.map,P++,F.updateMatrices(T),T.castShadow&&E++),n.spotLightMatrix[v]=F.matrix,T.castShadow){let z=t.get(T);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,n.spotShadow[v]=z,n.spotShadowMap[v]=W,y++}v++}else if(T.isRectAreaLight){let q=e.get(T);q.color.copy(B).multiplyScalar(H),q.halfWidth.set(T.width*.5,0,0),q.halfHeight.set(0,T.height*.5,0),n.rectArea[g]=q,g++}else if(T.isPointLight){let q=e.get(T);if(q.color.copy(T.color).multiplyScalar(T.intensity),q.distance=T.distance,q.decay=T.decay,T.castShadow){let F=T.shadow,z=t.get(T);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,z.shadowCameraNear=F.camera.near,z.shadowCameraFar=F.camera.far,n.pointShadow[m]=z,n.pointShadowMap[m]=W,n.pointShadowMatrix[m]=T.shadow.matrix,M++}n.point[m]=q,m++}else if(T.isHemisphereLight){let q=e.get(T);q.skyColor.copy(T.color).multiplyScalar(H),q.groundColor.copy(T.groundColor).multiplyScalar(H),n.hemi[d]=q,d++}}g>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=De.LTC_FLOAT_1,n.rectAreaLTC2=De.LTC_FLOAT_2):(n.rectAreaLTC1=De.LTC_HALF_1,n.rectAreaLTC2=De.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let D=n.hash;(D.directionalLength!==p||D.pointLength!==m||D.spotLength!==v||D.rectAreaLength!==g||D.hemiLength!==d||D.numDirectionalShadows!==b||D.numPointShadows!==M||D.numSpotShadows!==y||D.numSpotMaps!==P||D.numLightProbes!==I)&&(n.directional.length=p,n.spot.length=v,n.rectArea.length=g,n.point.length=m,n.hemi.length=d,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.pointShadow.length=M,n.pointShadowMap.length=M,n.spotShadow.length=y,n.spotShadowMap.length=y,n.directionalShadowMatrix.length=b,n.pointShadowMatrix.length=M,n.spotLightMatrix.length=y+P-E,n.spotLightMap.length=P,n.numSpotLightShadowsWithMaps=E,n.numLightProbes=I,D.directionalLength=p,D.pointLength=m,D.spotLength=v,D.rectAreaLength=g,D.hemiLength=d,D.numDirectionalShadows=b,D.numPointShadows=M,D.numSpotShadows=y,D.numSpotMaps=P,D.numLightProbes=I,n.version=fS++)}function l(c,u){let h=0,f=0,p=0,m=0,v=0,g=u.matrixWorldInverse;for(let d=0,b=c.length;d<b;d++){let M=c[d];if(M.isDirectionalLight){let y=n.directional[h];y.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(g),h++}else if(M.isSpotLight){let y=n.spot[p];y.position.setFromMatrixPosition(M.matrixWorld),y.position.applyMatrix4(g),y.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(g),p++}else if(M.isRectAreaLight){let y=n.rectArea[m];y.position.setFromMatrixPosition(M.matrixWorld),y.position.applyMatrix4(g),o.identity(),r.copy(M.matrixWorld),r.premultiply(g),o.extractRotation(r),y.halfWidth.set(M.width*.5,0,0),y.halfHeight.set(0,M.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),m++}else if(M.isPointLight){let y=n.point[f];y.position.setFromMatrixPosition(M.matrixWorld),y.position.applyMatrix4(g),f++}else if(M.isHemisphereLight){let y=n.hemi[v];y.direction.setFromMatrixPosition(M.matrixWorld),y.direction.transformDirection(g),v++}}}return{setup:a,setupView:l,state:n}}function bg(i){let e=new pS(i),t=[],n=[];function s(u){c.camera=u,t.length=0,n.length=0}function r(u){t.push(u)}function o(u){n.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function mS(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new bg(i),e.set(s,[a])):r>=o.length?(a=new bg(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var gS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,vS=`uniform sampler2D shadow_pass;
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
}`;function _S(i,e,t){let n=new _o,s=new Oe,r=new Oe,o=new It,a=new _c({depthPacking:zm}),l=new xc,c={},u=t.maxTextureSize,h={[gs]:Gn,[Gn]:gs,[Wn]:Wn},f=new oi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Oe},radius:{value:4}},vertexShader:gS,fragmentShader:vS}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new Ot;m.setAttribute("position",new Jt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new et(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=hf;let d=this.type;this.render=function(E,I,D){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;let S=i.getRenderTarget(),w=i.getActiveCubeFace(),T=i.getActiveMipmapLevel(),B=i.state;B.setBlending(_s),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let H=d!==Qi&&this.type===Qi,V=d===Qi&&this.type!==Qi;for(let W=0,q=E.length;W<q;W++){let F=E[W],z=F.shadow;if(z===void 0){console.warn("THREE.WebGLShadowMap:",F,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let J=z.getFrameExtents();if(s.multiply(J),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/J.x),s.x=r.x*J.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/J.y),s.y=r.y*J.y,z.mapSize.y=r.y)),z.map===null||H===!0||V===!0){let te=this.type!==Qi?{minFilter:gi,magFilter:gi}:{};z.map!==null&&z.map.dispose(),z.map=new Ki(s.x,s.y,te),z.map.texture.name=F.name+".shadowMap",z.camera.updateProjectionMatrix()}i.setRenderTarget(z.map),i.clear();let ne=z.getViewportCount();for(let te=0;te<ne;te++){let ce=z.getViewport(te);o.set(r.x*ce.x,r.y*ce.y,r.x*ce.z,r.y*ce.w),B.viewport(o),z.updateMatrices(F,te),n=z.getFrustum(),y(I,D,z.camera,F,this.type)}z.isPointLightShadow!==!0&&this.type===Qi&&b(z,D),z.needsUpdate=!1}d=this.type,g.needsUpdate=!1,i.setRenderTarget(S,w,T)};function b(E,I){let D=e.update(v);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,p.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),E.mapPass===null&&(E.mapPass=new Ki(s.x,s.y)),f.uniforms.shadow_pass.value=E.map.texture,f.uniforms.resolution.value=E.mapSize,f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(I,null,D,f,v,null),p.uniforms.shadow_pass.value=E.mapPass.texture,p.uniforms.resolution.value=E.mapSize,p.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(I,null,D,p,v,null)}function M(E,I,D,S){let w=null,T=D.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(T!==void 0)w=T;else if(w=D.isPointLight===!0?l:a,i.localClippingEnabled&&I.clipShadows===!0&&Array.isArray(I.clippingPlanes)&&I.clippingPlanes.length!==0||I.displacementMap&&I.displacementScale!==0||I.alphaMap&&I.alphaTest>0||I.map&&I.alphaTest>0||I.alphaToCoverage===!0){let B=w.uuid,H=I.uuid,V=c[B];V===void 0&&(V={},c[B]=V);let W=V[H];W===void 0&&(W=w.clone(),V[H]=W,I.addEventListener("dispose",P)),w=W}if(w.visible=I.visible,w.wireframe=I.wireframe,S===Qi?w.side=I.shadowSide!==null?I.shadowSide:I.side:w.side=I.shadowSide!==null?I.shadowSide:h[I.side],w.alphaMap=I.alphaMap,w.alphaTest=I.alphaToCoverage===!0?.5:I.alphaTest,w.map=I.map,w.clipShadows=I.clipShadows,w.clippingPlanes=I.clippingPlanes,w.clipIntersection=I.clipIntersection,w.displacementMap=I.displacementMap,w.displacementScale=I.displacementScale,w.displacementBias=I.displacementBias,w.wireframeLinewidth=I.wireframeLinewidth,w.linewidth=I.linewidth,D.isPointLight===!0&&w.isMeshDistanceMaterial===!0){let B=i.properties.get(w);B.light=D}return w}function y(E,I,D,S,w){if(E.visible===!1)return;if(E.layers.test(I.layers)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&w===Qi)&&(!E.frustumCulled||n.intersectsObject(E))){E.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,E.matrixWorld);let H=e.update(E),V=E.material;if(Array.isArray(V)){let W=H.groups;for(let q=0,F=W.length;q<F;q++){let z=W[q],J=V[z.materialIndex];if(J&&J.visible){let ne=M(E,J,S,w);E.onBeforeShadow(i,E,I,D,H,ne,z),i.renderBufferDirect(D,null,H,ne,E,z),E.onAfterShadow(i,E,I,D,H,ne,z)}}}else if(V.visible){let W=M(E,V,S,w);E.onBeforeShadow(i,E,I,D,H,W,null),i.renderBufferDirect(D,null,H,W,E,null),E.onAfterShadow(i,E,I,D,H,W,null)}}let B=E.children;for(let H=0,V=B.length;H<V;H++)y(B[H],I,D,S,w)}function P(E){E.target.removeEventListener("dispose",P);for(let D in c){let S=c[D],w=E.target.uuid;w in S&&(S[w].dispose(),delete S[w])}}}var xS={[Pc]:Ic,[Lc]:Nc,[Dc]:Fc,[lr]:Uc,[Ic]:Pc,[Nc]:Lc,[Fc]:Dc,[Uc]:lr};function yS(i,e){function t(){let $=!1,Ee=new It,Ae=null,Ve=new It(0,0,0,0);return{setMask:function(Se){Ae!==Se&&!$&&(i.colorMask(Se,Se,Se,Se),Ae=Se)},setLocked:function(Se){$=Se},setClear:function(Se,pe,$e,st,Lt){Lt===!0&&(Se*=st,pe*=st,$e*=st),Ee.set(Se,pe,$e,st),Ve.equals(Ee)===!1&&(i.clearColor(Se,pe,$e,st),Ve.copy(Ee))},reset:function(){$=!1,Ae=null,Ve.set(-1,0,0,0)}}}function n(){let $=!1,Ee=!1,Ae=null,Ve=null,Se=null;return{setReversed:function(pe){if(Ee!==pe){let $e=e.get("EXT_clip_control");pe?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),Ee=pe;let st=Se;Se=null,this.setClear(st)}},getReversed:function(){return Ee},setTest:function(pe){pe?X(i.DEPTH_TEST):me(i.DEPTH_TEST)},setMask:function(pe){Ae!==pe&&!$&&(i.depthMask(pe),Ae=pe)},setFunc:function(pe){if(Ee&&(pe=xS[pe]),Ve!==pe){switch(pe){case Pc:i.depthFunc(i.NEVER);break;case Ic:i.depthFunc(i.ALWAYS);break;case Lc:i.depthFunc(i.LESS);break;case lr:i.depthFunc(i.LEQUAL);break;case Dc:i.depthFunc(i.EQUAL);break;case Uc:i.depthFunc(i.GEQUAL);break;case Nc:i.depthFunc(i.GREATER);break;case Fc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ve=pe}},setLocked:function(pe){$=pe},setClear:function(pe){Se!==pe&&(Ee&&(pe=1-pe),i.clearDepth(pe),Se=pe)},reset:function(){$=!1,Ae=null,Ve=null,Se=null,Ee=!1}}}function s(){let $=!1,Ee=null,Ae=null,Ve=null,Se=null,pe=null,$e=null,st=null,Lt=null;return{setTest:function(xt){$||(xt?X(i.STENCIL_TEST):me(i.STENCIL_TEST))},setMask:function(xt){Ee!==xt&&!$&&(i.stencilMask(xt),Ee=xt)},setFunc:function(xt,bn,Ft){(Ae!==xt||Ve!==bn||Se!==Ft)&&(i.stencilFunc(xt,bn,Ft),Ae=xt,Ve=bn,Se=Ft)},setOp:function(xt,bn,Ft){(pe!==xt||$e!==bn||st!==Ft)&&(i.stencilOp(xt,bn,Ft),pe=xt,$e=bn,st=Ft)},setLocked:function(xt){$=xt},setClear:function(xt){Lt!==xt&&(i.clearStencil(xt),Lt=xt)},reset:function(){$=!1,Ee=null,Ae=null,Ve=null,Se=null,pe=null,$e=null,st=null,Lt=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,p=[],m=null,v=!1,g=null,d=null,b=null,M=null,y=null,P=null,E=null,I=new at(0,0,0),D=0,S=!1,w=null,T=null,B=null,H=null,V=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,F=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(F=parseFloat(/^WebGL (\d)/.exec(z)[1]),q=F>=1):z.indexOf("OpenGL ES")!==-1&&(F=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),q=F>=2);let J=null,ne={},te=i.getParameter(i.SCISSOR_BOX),ce=i.getParameter(i.VIEWPORT),fe=new It().fromArray(te),xe=new It().fromArray(ce);function Ie($,Ee,Ae,Ve){let Se=new Uint8Array(4),pe=i.createTexture();i.bindTexture($,pe),i.texParameteri($,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri($,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let $e=0;$e<Ae;$e++)$===i.TEXTURE_3D||$===i.TEXTURE_2D_ARRAY?i.texImage3D(Ee,0,i.RGBA,1,1,Ve,0,i.RGBA,i.UNSIGNED_BYTE,Se):i.texImage2D(Ee+$e,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Se);return pe}let Q={};Q[i.TEXTURE_2D]=Ie(i.TEXTURE_2D,i.TEXTURE_2D,1),Q[i.TEXTURE_CUBE_MAP]=Ie(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Q[i.TEXTURE_2D_ARRAY]=Ie(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Q[i.TEXTURE_3D]=Ie(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),X(i.DEPTH_TEST),o.setFunc(lr),Me(!1),Ce(cf),X(i.CULL_FACE),ht(_s);function X($){u[$]!==!0&&(i.enable($),u[$]=!0)}function me($){u[$]!==!1&&(i.disable($),u[$]=!1)}function ve($,Ee){return h[$]!==Ee?(i.bindFramebuffer($,Ee),h[$]=Ee,$===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=Ee),$===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=Ee),!0):!1}function ye($,Ee){let Ae=p,Ve=!1;if($){Ae=f.get(Ee),Ae===void 0&&(Ae=[],f.set(Ee,Ae));let Se=$.textures;if(Ae.length!==Se.length||Ae[0]!==i.COLOR_ATTACHMENT0){for(let pe=0,$e=Se.length;pe<$e;pe++)Ae[pe]=i.COLOR_ATTACHMENT0+pe;Ae.length=Se.length,Ve=!0}}else Ae[0]!==i.BACK&&(Ae[0]=i.BACK,Ve=!0);Ve&&i.drawBuffers(Ae)}function Ge($){return m!==$?(i.useProgram($),m=$,!0):!1}let dt={[Os]:i.FUNC_ADD,[um]:i.FUNC_SUBTRACT,[fm]:i.FUNC_REVERSE_SUBTRACT};dt[dm]=i.MIN,dt[pm]=i.MAX;let k={[mm]:i.ZERO,[gm]:i.ONE,[vm]:i.SRC_COLOR,[Jl]:i.SRC_ALPHA,[wm]:i.SRC_ALPHA_SATURATE,[bm]:i.DST_COLOR,[xm]:i.DST_ALPHA,[_m]:i.ONE_MINUS_SRC_COLOR,[jl]:i.ONE_MINUS_SRC_ALPHA,[Mm]:i.ONE_MINUS_DST_COLOR,[ym]:i.ONE_MINUS_DST_ALPHA,[Sm]:i.CONSTANT_COLOR,[Em]:i.ONE_MINUS_CONSTANT_COLOR,[Tm]:i.CONSTANT_ALPHA,[Am]:i.ONE_MINUS_CONSTANT_ALPHA};function ht($,Ee,Ae,Ve,Se,pe,$e,st,Lt,xt){if($===_s){v===!0&&(me(i.BLEND),v=!1);return}if(v===!1&&(X(i.BLEND),v=!0),$!==hm){if($!==g||xt!==S){if((d!==Os||y!==Os)&&(i.blendEquation(i.FUNC_ADD),d=Os,y=Os),xt)switch($){case ar:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case uf:i.blendFunc(i.ONE,i.ONE);break;case ff:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case df:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",$);break}else switch($){case ar:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case uf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case ff:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case df:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",$);break}b=null,M=null,P=null,E=null,I.set(0,0,0),D=0,g=$,S=xt}return}Se=Se||Ee,pe=pe||Ae,$e=$e||Ve,(Ee!==d||Se!==y)&&(i.blendEquationSeparate(dt[Ee],dt[Se]),d=Ee,y=Se),(Ae!==b||Ve!==M||pe!==P||$e!==E)&&(i.blendFuncSeparate(k[Ae],k[Ve],k[pe],k[$e]),b=Ae,M=Ve,P=pe,E=$e),(st.equals(I)===!1||Lt!==D)&&(i.blendColor(st.r,st.g,st.b,Lt),I.copy(st),D=Lt),g=$,S=!1}function se($,Ee){$.side===Wn?me(i.CULL_FACE):X(i.CULL_FACE);let Ae=$.side===Gn;Ee&&(Ae=!Ae),Me(Ae),$.blending===ar&&$.transparent===!1?ht(_s):ht($.blending,$.blendEquation,$.blendSrc,$.blendDst,$.blendEquationAlpha,$.blendSrcAlpha,$.blendDstAlpha,$.blendColor,$.blendAlpha,$.premultipliedAlpha),o.setFunc($.depthFunc),o.setTest($.depthTest),o.setMask($.depthWrite),r.setMask($.colorWrite);let Ve=$.stencilWrite;a.setTest(Ve),Ve&&(a.setMask($.stencilWriteMask),a.setFunc($.stencilFunc,$.stencilRef,$.stencilFuncMask),a.setOp($.stencilFail,$.stencilZFail,$.stencilZPass)),re($.polygonOffset,$.polygonOffsetFactor,$.polygonOffsetUnits),$.alphaToCoverage===!0?X(i.SAMPLE_ALPHA_TO_COVERAGE):me(i.SAMPLE_ALPHA_TO_COVERAGE)}function Me($){w!==$&&($?i.frontFace(i.CW):i.frontFace(i.CCW),w=$)}function Ce($){$!==am?(X(i.CULL_FACE),$!==T&&($===cf?i.cullFace(i.BACK):$===lm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):me(i.CULL_FACE),T=$}function ot($){$!==B&&(q&&i.lineWidth($),B=$)}function re($,Ee,Ae){$?(X(i.POLYGON_OFFSET_FILL),(H!==Ee||V!==Ae)&&(i.polygonOffset(Ee,Ae),H=Ee,V=Ae)):me(i.POLYGON_OFFSET_FILL)}function ee($){$?X(i.SCISSOR_TEST):me(i.SCISSOR_TEST)}function ue($){$===void 0&&($=i.TEXTURE0+W-1),J!==$&&(i.activeTexture($),J=$)}function we($,Ee,Ae){Ae===void 0&&(J===null?Ae=i.TEXTURE0+W-1:Ae=J);let Ve=ne[Ae];Ve===void 0&&(Ve={type:void 0,texture:void 0},ne[Ae]=Ve),(Ve.type!==$||Ve.texture!==Ee)&&(J!==Ae&&(i.activeTexture(Ae),J=Ae),i.bindTexture($,Ee||Q[$]),Ve.type=$,Ve.texture=Ee)}function C(){let $=ne[J];$!==void 0&&$.type!==void 0&&(i.bindTexture($.type,null),$.type=void 0,$.texture=void 0)}function x(){try{i.compressedTexImage2D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function N(){try{i.compressedTexImage3D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function Y(){try{i.texSubImage2D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function le(){try{i.texSubImage3D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function oe(){try{i.compressedTexSubImage2D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function Ue(){try{i.compressedTexSubImage3D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function _e(){try{i.texStorage2D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function Fe(){try{i.texStorage3D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function Be(){try{i.texImage2D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function ge(){try{i.texImage3D(...arguments)}catch($){console.error("THREE.WebGLState:",$)}}function Re($){fe.equals($)===!1&&(i.scissor($.x,$.y,$.z,$.w),fe.copy($))}function qe($){xe.equals($)===!1&&(i.viewport($.x,$.y,$.z,$.w),xe.copy($))}function Ye($,Ee){let Ae=c.get(Ee);Ae===void 0&&(Ae=new WeakMap,c.set(Ee,Ae));let Ve=Ae.get($);Ve===void 0&&(Ve=i.getUniformBlockIndex(Ee,$.name),Ae.set($,Ve))}function Le($,Ee){let Ve=c.get(Ee).get($);l.get(Ee)!==Ve&&(i.uniformBlockBinding(Ee,Ve,$.__bindingPointIndex),l.set(Ee,Ve))}function Ze(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},J=null,ne={},h={},f=new WeakMap,p=[],m=null,v=!1,g=null,d=null,b=null,M=null,y=null,P=null,E=null,I=new at(0,0,0),D=0,S=!1,w=null,T=null,B=null,H=null,V=null,fe.set(0,0,i.canvas.width,i.canvas.height),xe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:X,disable:me,bindFramebuffer:ve,drawBuffers:ye,useProgram:Ge,setBlending:ht,setMaterial:se,setFlipSided:Me,setCullFace:Ce,setLineWidth:ot,setPolygonOffset:re,setScissorTest:ee,activeTexture:ue,bindTexture:we,unbindTexture:C,compressedTexImage2D:x,compressedTexImage3D:N,texImage2D:Be,texImage3D:ge,updateUBOMapping:Ye,uniformBlockBinding:Le,texStorage2D:_e,texStorage3D:Fe,texSubImage2D:Y,texSubImage3D:le,compressedTexSubImage2D:oe,compressedTexSubImage3D:Ue,scissor:Re,viewport:qe,reset:Ze}}function bS(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Oe,u=new WeakMap,h,f=new WeakMap,p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,x){return p?new OffscreenCanvas(C,x):pa("canvas")}function v(C,x,N){let Y=1,le=we(C);if((le.width>N||le.height>N)&&(Y=N/Math.max(le.width,le.height)),Y<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let oe=Math.floor(Y*le.width),Ue=Math.floor(Y*le.height);h===void 0&&(h=m(oe,Ue));let _e=x?m(oe,Ue):h;return _e.width=oe,_e.height=Ue,_e.getContext("2d").drawImage(C,0,0,oe,Ue),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+le.width+"x"+le.height+") to ("+oe+"x"+Ue+")."),_e}else return"data"in C&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+le.width+"x"+le.height+")."),C;return C}function g(C){return C.generateMipmaps}function d(C){i.generateMipmap(C)}function b(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function M(C,x,N,Y,le=!1){if(C!==null){if(i[C]!==void 0)return i[C];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let oe=x;if(x===i.RED&&(N===i.FLOAT&&(oe=i.R32F),N===i.HALF_FLOAT&&(oe=i.R16F),N===i.UNSIGNED_BYTE&&(oe=i.R8)),x===i.RED_INTEGER&&(N===i.UNSIGNED_BYTE&&(oe=i.R8UI),N===i.UNSIGNED_SHORT&&(oe=i.R16UI),N===i.UNSIGNED_INT&&(oe=i.R32UI),N===i.BYTE&&(oe=i.R8I),N===i.SHORT&&(oe=i.R16I),N===i.INT&&(oe=i.R32I)),x===i.RG&&(N===i.FLOAT&&(oe=i.RG32F),N===i.HALF_FLOAT&&(oe=i.RG16F),N===i.UNSIGNED_BYTE&&(oe=i.RG8)),x===i.RG_INTEGER&&(N===i.UNSIGNED_BYTE&&(oe=i.RG8UI),N===i.UNSIGNED_SHORT&&(oe=i.RG16UI),N===i.UNSIGNED_INT&&(oe=i.RG32UI),N===i.BYTE&&(oe=i.RG8I),N===i.SHORT&&(oe=i.RG16I),N===i.INT&&(oe=i.RG32I)),x===i.RGB_INTEGER&&(N===i.UNSIGNED_BYTE&&(oe=i.RGB8UI),N===i.UNSIGNED_SHORT&&(oe=i.RGB16UI),N===i.UNSIGNED_INT&&(oe=i.RGB32UI),N===i.BYTE&&(oe=i.RGB8I),N===i.SHORT&&(oe=i.RGB16I),N===i.INT&&(oe=i.RGB32I)),x===i.RGBA_INTEGER&&(N===i.UNSIGNED_BYTE&&(oe=i.RGBA8UI),N===i.UNSIGNED_SHORT&&(oe=i.RGBA16UI),N===i.UNSIGNED_INT&&(oe=i.RGBA32UI),N===i.BYTE&&(oe=i.RGBA8I),N===i.SHORT&&(oe=i.RGBA16I),N===i.INT&&(oe=i.RGBA32I)),x===i.RGB&&(N===i.UNSIGNED_INT_5_9_9_9_REV&&(oe=i.RGB9_E5),N===i.UNSIGNED_INT_10F_11F_11F_REV&&(oe=i.R11F_G11F_B10F)),x===i.RGBA){let Ue=le?fa:_t.getTransfer(Y);N===i.FLOAT&&(oe=i.RGBA32F),N===i.HALF_FLOAT&&(oe=i.RGBA16F),N===i.UNSIGNED_BYTE&&(oe=Ue===Pt?i.SRGB8_ALPHA8:i.RGBA8),N===i.UNSIGNED_SHORT_4_4_4_4&&(oe=i.RGBA4),N===i.UNSIGNED_SHORT_5_5_5_1&&(oe=i.RGB5_A1)}return(oe===i.R16F||oe===i.R32F||oe===i.RG16F||oe===i.RG32F||oe===i.RGBA16F||oe===i.RGBA32F)&&e.get("EXT_color_buffer_float"),oe}function y(C,x){let N;return C?x===null||x===Ws||x===wo?N=i.DEPTH24_STENCIL8:x===es?N=i.DEPTH32F_STENCIL8:x===bo&&(N=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Ws||x===wo?N=i.DEPTH_COMPONENT24:x===es?N=i.DEPTH_COMPONENT32F:x===bo&&(N=i.DEPTH_COMPONENT16),N}function P(C,x){return g(C)===!0||C.isFramebufferTexture&&C.minFilter!==gi&&C.minFilter!==Ii?Math.log2(Math.max(x.width,x.height))+1:C.mipmaps!==void 0&&C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?x.mipmaps.length:1}function E(C){let x=C.target;x.removeEventListener("dispose",E),D(x),x.isVideoTexture&&u.delete(x)}function I(C){let x=C.target;x.removeEventListener("dispose",I),w(x)}function D(C){let x=n.get(C);if(x.__webglInit===void 0)return;let N=C.source,Y=f.get(N);if(Y){let le=Y[x.__cacheKey];le.usedTimes--,le.usedTimes===0&&S(C),Object.keys(Y).length===0&&f.delete(N)}n.remove(C)}function S(C){let x=n.get(C);i.deleteTexture(x.__webglTexture);let N=C.source,Y=f.get(N);delete Y[x.__cacheKey],o.memory.textures--}function w(C){let x=n.get(C);if(C.depthTexture&&(C.depthTexture.dispose(),n.remove(C.depthTexture)),C.isWebGLCubeRenderTarget)for(let Y=0;Y<6;Y++){if(Array.isArray(x.__webglFramebuffer[Y]))for(let le=0;le<x.__webglFramebuffer[Y].length;le++)i.deleteFramebuffer(x.__webglFramebuffer[Y][le]);else i.deleteFramebuffer(x.__webglFramebuffer[Y]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[Y])}else{if(Array.isArray(x.__webglFramebuffer))for(let Y=0;Y<x.__webglFramebuffer.length;Y++)i.deleteFramebuffer(x.__webglFramebuffer[Y]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let Y=0;Y<x.__webglColorRenderbuffer.length;Y++)x.__webglColorRenderbuffer[Y]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[Y]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let N=C.textures;for(let Y=0,le=N.length;Y<le;Y++){let oe=n.get(N[Y]);oe.__webglTexture&&(i.deleteTexture(oe.__webglTexture),o.memory.textures--),n.remove(N[Y])}n.remove(C)}let T=0;function B(){T=0}function H(){let C=T;return C>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+C+" texture units while this GPU supports only "+s.maxTextures),T+=1,C}function V(C){let x=[];return x.push(C.wrapS),x.push(C.wrapT),x.push(C.wrapR||0),x.push(C.magFilter),x.push(C.minFilter),x.push(C.anisotropy),x.push(C.internalFormat),x.push(C.format),x.push(C.type),x.push(C.generateMipmaps),x.push(C.premultiplyAlpha),x.push(C.flipY),x.push(C.unpackAlignment),x.push(C.colorSpace),x.join()}function W(C,x){let N=n.get(C);if(C.isVideoTexture&&ee(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&N.__version!==C.version){let Y=C.image;if(Y===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(Y.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{Q(N,C,x);return}}else C.isExternalTexture&&(N.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,N.__webglTexture,i.TEXTURE0+x)}function q(C,x){let N=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&N.__version!==C.version){Q(N,C,x);return}t.bindTexture(i.TEXTURE_2D_ARRAY,N.__webglTexture,i.TEXTURE0+x)}function F(C,x){let N=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&N.__version!==C.version){Q(N,C,x);return}t.bindTexture(i.TEXTURE_3D,N.__webglTexture,i.TEXTURE0+x)}function z(C,x){let N=n.get(C);if(C.version>0&&N.__version!==C.version){X(N,C,x);return}t.bindTexture(i.TEXTURE_CUBE_MAP,N.__webglTexture,i.TEXTURE0+x)}let J={[Ql]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[ec]:i.MIRRORED_REPEAT},ne={[gi]:i.NEAREST,[Om]:i.NEAREST_MIPMAP_NEAREST,[Va]:i.NEAREST_MIPMAP_LINEAR,[Ii]:i.LINEAR,[zc]:i.LINEAR_MIPMAP_NEAREST,[Gs]:i.LINEAR_MIPMAP_LINEAR},te={[Hm]:i.NEVER,[Ym]:i.ALWAYS,[Vm]:i.LESS,[Af]:i.LEQUAL,[Gm]:i.EQUAL,[qm]:i.GEQUAL,[Wm]:i.GREATER,[Xm]:i.NOTEQUAL};function ce(C,x){if(x.type===es&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===Ii||x.magFilter===zc||x.magFilter===Va||x.magFilter===Gs||x.minFilter===Ii||x.minFilter===zc||x.minFilter===Va||x.minFilter===Gs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,J[x.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,J[x.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,J[x.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,ne[x.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,ne[x.minFilter]),x.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,te[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===gi||x.minFilter!==Va&&x.minFilter!==Gs||x.type===es&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let N=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,N.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function fe(C,x){let N=!1;C.__webglInit===void 0&&(C.__webglInit=!0,x.addEventListener("dispose",E));let Y=x.source,le=f.get(Y);le===void 0&&(le={},f.set(Y,le));let oe=V(x);if(oe!==C.__cacheKey){le[oe]===void 0&&(le[oe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,N=!0),le[oe].usedTimes++;let Ue=le[C.__cacheKey];Ue!==void 0&&(le[C.__cacheKey].usedTimes--,Ue.usedTimes===0&&S(x)),C.__cacheKey=oe,C.__webglTexture=le[oe].texture}return N}function xe(C,x,N){return Math.floor(Math.floor(C/N)/x)}function Ie(C,x,N,Y){let oe=C.updateRanges;if(oe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,N,Y,x.data);else{oe.sort((ge,Re)=>ge.start-Re.start);let Ue=0;for(let ge=1;ge<oe.length;ge++){let Re=oe[Ue],qe=oe[ge],Ye=Re.start+Re.count,Le=xe(qe.start,x.width,4),Ze=xe(Re.start,x.width,4);qe.start<=Ye+1&&Le===Ze&&xe(qe.start+qe.count-1,x.width,4)===Le?Re.count=Math.max(Re.count,qe.start+qe.count-Re.start):(++Ue,oe[Ue]=qe)}oe.length=Ue+1;let _e=i.getParameter(i.UNPACK_ROW_LENGTH),Fe=i.getParameter(i.UNPACK_SKIP_PIXELS),Be=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let ge=0,Re=oe.length;ge<Re;ge++){let qe=oe[ge],Ye=Math.floor(qe.start/4),Le=Math.ceil(qe.count/4),Ze=Ye%x.width,$=Math.floor(Ye/x.width),Ee=Le,Ae=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Ze),i.pixelStorei(i.UNPACK_SKIP_ROWS,$),t.texSubImage2D(i.TEXTURE_2D,0,Ze,$,Ee,Ae,N,Y,x.data)}C.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,_e),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Fe),i.pixelStorei(i.UNPACK_SKIP_ROWS,Be)}}function Q(C,x,N){let Y=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(Y=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(Y=i.TEXTURE_3D);let le=fe(C,x),oe=x.source;t.bindTexture(Y,C.__webglTexture,i.TEXTURE0+N);let Ue=n.get(oe);if(oe.version!==Ue.__version||le===!0){t.activeTexture(i.TEXTURE0+N);let _e=_t.getPrimaries(_t.workingColorSpace),Fe=x.colorSpace===ys?null:_t.getPrimaries(x.colorSpace),Be=x.colorSpace===ys||_e===Fe?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Be);let ge=v(x.image,!1,s.maxTextureSize);ge=ue(x,ge);let Re=r.convert(x.format,x.colorSpace),qe=r.convert(x.type),Ye=M(x.internalFormat,Re,qe,x.colorSpace,x.isVideoTexture);ce(Y,x);let Le,Ze=x.mipmaps,$=x.isVideoTexture!==!0,Ee=Ue.__version===void 0||le===!0,Ae=oe.dataReady,Ve=P(x,ge);if(x.isDepthTexture)Ye=y(x.format===So,x.type),Ee&&($?t.texStorage2D(i.TEXTURE_2D,1,Ye,ge.width,ge.height):t.texImage2D(i.TEXTURE_2D,0,Ye,ge.width,ge.height,0,Re,qe,null));else if(x.isDataTexture)if(Ze.length>0){$&&Ee&&t.texStorage2D(i.TEXTURE_2D,Ve,Ye,Ze[0].width,Ze[0].height);for(let Se=0,pe=Ze.length;Se<pe;Se++)Le=Ze[Se],$?Ae&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,Le.width,Le.height,Re,qe,Le.data):t.texImage2D(i.TEXTURE_2D,Se,Ye,Le.width,Le.height,0,Re,qe,Le.data);x.generateMipmaps=!1}else $?(Ee&&t.texStorage2D(i.TEXTURE_2D,Ve,Ye,ge.width,ge.height),Ae&&Ie(x,ge,Re,qe)):t.texImage2D(i.TEXTURE_2D,0,Ye,ge.width,ge.height,0,Re,qe,ge.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){$&&Ee&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ve,Ye,Ze[0].width,Ze[0].height,ge.depth);for(let Se=0,pe=Ze.length;Se<pe;Se++)if(Le=Ze[Se],x.format!==vi)if(Re!==null)if($){if(Ae)if(x.layerUpdates.size>0){let $e=Nf(Le.width,Le.height,x.format,x.type);for(let st of x.layerUpdates){let Lt=Le.data.subarray(st*$e/Le.data.BYTES_PER_ELEMENT,(st+1)*$e/Le.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,st,Le.width,Le.height,1,Re,Lt)}x.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,0,Le.width,Le.height,ge.depth,Re,Le.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,Se,Ye,Le.width,Le.height,ge.depth,0,Le.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else $?Ae&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,0,Le.width,Le.height,ge.depth,Re,qe,Le.data):t.texImage3D(i.TEXTURE_2D_ARRAY,Se,Ye,Le.width,Le.height,ge.depth,0,Re,qe,Le.data)}else{$&&Ee&&t.texStorage2D(i.TEXTURE_2D,Ve,Ye,Ze[0].width,Ze[0].height);for(let Se=0,pe=Ze.length;Se<pe;Se++)Le=Ze[Se],x.format!==vi?Re!==null?$?Ae&&t.compressedTexSubImage2D(i.TEXTURE_2D,Se,0,0,Le.width,Le.height,Re,Le.data):t.compressedTexImage2D(i.TEXTURE_2D,Se,Ye,Le.width,Le.height,0,Le.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):$?Ae&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,Le.width,Le.height,Re,qe,Le.data):t.texImage2D(i.TEXTURE_2D,Se,Ye,Le.width,Le.height,0,Re,qe,Le.data)}else if(x.isDataArrayTexture)if($){if(Ee&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ve,Ye,ge.width,ge.height,ge.depth),Ae)if(x.layerUpdates.size>0){let Se=Nf(ge.width,ge.height,x.format,x.type);for(let pe of x.layerUpdates){let $e=ge.data.subarray(pe*Se/ge.data.BYTES_PER_ELEMENT,(pe+1)*Se/ge.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,pe,ge.width,ge.height,1,Re,qe,$e)}x.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ge.width,ge.height,ge.depth,Re,qe,ge.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Ye,ge.width,ge.height,ge.depth,0,Re,qe,ge.data);else if(x.isData3DTexture)$?(Ee&&t.texStorage3D(i.TEXTURE_3D,Ve,Ye,ge.width,ge.height,ge.depth),Ae&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ge.width,ge.height,ge.depth,Re,qe,ge.data)):t.texImage3D(i.TEXTURE_3D,0,Ye,ge.width,ge.height,ge.depth,0,Re,qe,ge.data);else if(x.isFramebufferTexture){if(Ee)if($)t.texStorage2D(i.TEXTURE_2D,Ve,Ye,ge.width,ge.height);else{let Se=ge.width,pe=ge.height;for(let $e=0;$e<Ve;$e++)t.texImage2D(i.TEXTURE_2D,$e,Ye,Se,pe,0,Re,qe,null),Se>>=1,pe>>=1}}else if(Ze.length>0){if($&&Ee){let Se=we(Ze[0]);t.texStorage2D(i.TEXTURE_2D,Ve,Ye,Se.width,Se.height)}for(let Se=0,pe=Ze.length;Se<pe;Se++)Le=Ze[Se],$?Ae&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,Re,qe,Le):t.texImage2D(i.TEXTURE_2D,Se,Ye,Re,qe,Le);x.generateMipmaps=!1}else if($){if(Ee){let Se=we(ge);t.texStorage2D(i.TEXTURE_2D,Ve,Ye,Se.width,Se.height)}Ae&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Re,qe,ge)}else t.texImage2D(i.TEXTURE_2D,0,Ye,Re,qe,ge);g(x)&&d(Y),Ue.__version=oe.version,x.onUpdate&&x.onUpdate(x)}C.__version=x.version}function X(C,x,N){if(x.image.length!==6)return;let Y=fe(C,x),le=x.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+N);let oe=n.get(le);if(le.version!==oe.__version||Y===!0){t.activeTexture(i.TEXTURE0+N);let Ue=_t.getPrimaries(_t.workingColorSpace),_e=x.colorSpace===ys?null:_t.getPrimaries(x.colorSpace),Fe=x.colorSpace===ys||Ue===_e?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Fe);let Be=x.isCompressedTexture||x.image[0].isCompressedTexture,ge=x.image[0]&&x.image[0].isDataTexture,Re=[];for(let pe=0;pe<6;pe++)!Be&&!ge?Re[pe]=v(x.image[pe],!0,s.maxCubemapSize):Re[pe]=ge?x.image[pe].image:x.image[pe],Re[pe]=ue(x,Re[pe]);let qe=Re[0],Ye=r.convert(x.format,x.colorSpace),Le=r.convert(x.type),Ze=M(x.internalFormat,Ye,Le,x.colorSpace),$=x.isVideoTexture!==!0,Ee=oe.__version===void 0||Y===!0,Ae=le.dataReady,Ve=P(x,qe);ce(i.TEXTURE_CUBE_MAP,x);let Se;if(Be){$&&Ee&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ve,Ze,qe.width,qe.height);for(let pe=0;pe<6;pe++){Se=Re[pe].mipmaps;for(let $e=0;$e<Se.length;$e++){let st=Se[$e];x.format!==vi?Ye!==null?$?Ae&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e,0,0,st.width,st.height,Ye,st.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e,Ze,st.width,st.height,0,st.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e,0,0,st.width,st.height,Ye,Le,st.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e,Ze,st.width,st.height,0,Ye,Le,st.data)}}}else{if(Se=x.mipmaps,$&&Ee){Se.length>0&&Ve++;let pe=we(Re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ve,Ze,pe.width,pe.height)}for(let pe=0;pe<6;pe++)if(ge){$?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,0,0,Re[pe].width,Re[pe].height,Ye,Le,Re[pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,Ze,Re[pe].width,Re[pe].height,0,Ye,Le,Re[pe].data);for(let $e=0;$e<Se.length;$e++){let Lt=Se[$e].image[pe].image;$?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e+1,0,0,Lt.width,Lt.height,Ye,Le,Lt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e+1,Ze,Lt.width,Lt.height,0,Ye,Le,Lt.data)}}else{$?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,0,0,Ye,Le,Re[pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,0,Ze,Ye,Le,Re[pe]);for(let $e=0;$e<Se.length;$e++){let st=Se[$e];$?Ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e+1,0,0,Ye,Le,st.image[pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pe,$e+1,Ze,Ye,Le,st.image[pe])}}}g(x)&&d(i.TEXTURE_CUBE_MAP),oe.__version=le.version,x.onUpdate&&x.onUpdate(x)}C.__version=x.version}function me(C,x,N,Y,le,oe){let Ue=r.convert(N.format,N.colorSpace),_e=r.convert(N.type),Fe=M(N.internalFormat,Ue,_e,N.colorSpace),Be=n.get(x),ge=n.get(N);if(ge.__renderTarget=x,!Be.__hasExternalTextures){let Re=Math.max(1,x.width>>oe),qe=Math.max(1,x.height>>oe);le===i.TEXTURE_3D||le===i.TEXTURE_2D_ARRAY?t.texImage3D(le,oe,Fe,Re,qe,x.depth,0,Ue,_e,null):t.texImage2D(le,oe,Fe,Re,qe,0,Ue,_e,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),re(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Y,le,ge.__webglTexture,0,ot(x)):(le===i.TEXTURE_2D||le>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&le<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,Y,le,ge.__webglTexture,oe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function ve(C,x,N){if(i.bindRenderbuffer(i.RENDERBUFFER,C),x.depthBuffer){let Y=x.depthTexture,le=Y&&Y.isDepthTexture?Y.type:null,oe=y(x.stencilBuffer,le),Ue=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=ot(x);re(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,_e,oe,x.width,x.height):N?i.renderbufferStorageMultisample(i.RENDERBUFFER,_e,oe,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,oe,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ue,i.RENDERBUFFER,C)}else{let Y=x.textures;for(let le=0;le<Y.length;le++){let oe=Y[le],Ue=r.convert(oe.format,oe.colorSpace),_e=r.convert(oe.type),Fe=M(oe.internalFormat,Ue,_e,oe.colorSpace),Be=ot(x);N&&re(x)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Be,Fe,x.width,x.height):re(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Be,Fe,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,Fe,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ye(C,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let Y=n.get(x.depthTexture);Y.__renderTarget=x,(!Y.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),W(x.depthTexture,0);let le=Y.__webglTexture,oe=ot(x);if(x.depthTexture.format===co)re(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,le,0,oe):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,le,0);else if(x.depthTexture.format===So)re(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,le,0,oe):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,le,0);else throw new Error("Unknown depthTexture format")}function Ge(C){let x=n.get(C),N=C.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==C.depthTexture){let Y=C.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),Y){let le=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,Y.removeEventListener("dispose",le)};Y.addEventListener("dispose",le),x.__depthDisposeCallback=le}x.__boundDepthTexture=Y}if(C.depthTexture&&!x.__autoAllocateDepthBuffer){if(N)throw new Error("target.depthTexture not supported in Cube render targets");let Y=C.texture.mipmaps;Y&&Y.length>0?ye(x.__webglFramebuffer[0],C):ye(x.__webglFramebuffer,C)}else if(N){x.__webglDepthbuffer=[];for(let Y=0;Y<6;Y++)if(t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[Y]),x.__webglDepthbuffer[Y]===void 0)x.__webglDepthbuffer[Y]=i.createRenderbuffer(),ve(x.__webglDepthbuffer[Y],C,!1);else{let le=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,oe=x.__webglDepthbuffer[Y];i.bindRenderbuffer(i.RENDERBUFFER,oe),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,oe)}}else{let Y=C.texture.mipmaps;if(Y&&Y.length>0?t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),ve(x.__webglDepthbuffer,C,!1);else{let le=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,oe=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,oe),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,oe)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function dt(C,x,N){let Y=n.get(C);x!==void 0&&me(Y.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),N!==void 0&&Ge(C)}function k(C){let x=C.texture,N=n.get(C),Y=n.get(x);C.addEventListener("dispose",I);let le=C.textures,oe=C.isWebGLCubeRenderTarget===!0,Ue=le.length>1;if(Ue||(Y.__webglTexture===void 0&&(Y.__webglTexture=i.createTexture()),Y.__version=x.version,o.memory.textures++),oe){N.__webglFramebuffer=[];for(let _e=0;_e<6;_e++)if(x.mipmaps&&x.mipmaps.length>0){N.__webglFramebuffer[_e]=[];for(let Fe=0;Fe<x.mipmaps.length;Fe++)N.__webglFramebuffer[_e][Fe]=i.createFramebuffer()}else N.__webglFramebuffer[_e]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){N.__webglFramebuffer=[];for(let _e=0;_e<x.mipmaps.length;_e++)N.__webglFramebuffer[_e]=i.createFramebuffer()}else N.__webglFramebuffer=i.createFramebuffer();if(Ue)for(let _e=0,Fe=le.length;_e<Fe;_e++){let Be=n.get(le[_e]);Be.__webglTexture===void 0&&(Be.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&re(C)===!1){N.__webglMultisampledFramebuffer=i.createFramebuffer(),N.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,N.__webglMultisampledFramebuffer);for(let _e=0;_e<le.length;_e++){let Fe=le[_e];N.__webglColorRenderbuffer[_e]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,N.__webglColorRenderbuffer[_e]);let Be=r.convert(Fe.format,Fe.colorSpace),ge=r.convert(Fe.type),Re=M(Fe.internalFormat,Be,ge,Fe.colorSpace,C.isXRRenderTarget===!0),qe=ot(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,qe,Re,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,N.__webglColorRenderbuffer[_e])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(N.__webglDepthRenderbuffer=i.createRenderbuffer(),ve(N.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(oe){t.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture),ce(i.TEXTURE_CUBE_MAP,x);for(let _e=0;_e<6;_e++)if(x.mipmaps&&x.mipmaps.length>0)for(let Fe=0;Fe<x.mipmaps.length;Fe++)me(N.__webglFramebuffer[_e][Fe],C,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,Fe);else me(N.__webglFramebuffer[_e],C,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0);g(x)&&d(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Ue){for(let _e=0,Fe=le.length;_e<Fe;_e++){let Be=le[_e],ge=n.get(Be),Re=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Re=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Re,ge.__webglTexture),ce(Re,Be),me(N.__webglFramebuffer,C,Be,i.COLOR_ATTACHMENT0+_e,Re,0),g(Be)&&d(Re)}t.unbindTexture()}else{let _e=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(_e=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(_e,Y.__webglTexture),ce(_e,x),x.mipmaps&&x.mipmaps.length>0)for(let Fe=0;Fe<x.mipmaps.length;Fe++)me(N.__webglFramebuffer[Fe],C,x,i.COLOR_ATTACHMENT0,_e,Fe);else me(N.__webglFramebuffer,C,x,i.COLOR_ATTACHMENT0,_e,0);g(x)&&d(_e),t.unbindTexture()}C.depthBuffer&&Ge(C)}function ht(C){let x=C.textures;for(let N=0,Y=x.length;N<Y;N++){let le=x[N];if(g(le)){let oe=b(C),Ue=n.get(le).__webglTexture;t.bindTexture(oe,Ue),d(oe),t.unbindTexture()}}}let se=[],Me=[];function Ce(C){if(C.samples>0){if(re(C)===!1){let x=C.textures,N=C.width,Y=C.height,le=i.COLOR_BUFFER_BIT,oe=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ue=n.get(C),_e=x.length>1;if(_e)for(let Be=0;Be<x.length;Be++)t.bindFramebuffer(i.FRAMEBUFFER,Ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Ue.__webglMultisampledFramebuffer);let Fe=C.texture.mipmaps;Fe&&Fe.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer);for(let Be=0;Be<x.length;Be++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(le|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(le|=i.STENCIL_BUFFER_BIT)),_e){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ue.__webglColorRenderbuffer[Be]);let ge=n.get(x[Be]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,ge,0)}i.blitFramebuffer(0,0,N,Y,0,0,N,Y,le,i.NEAREST),l===!0&&(se.length=0,Me.length=0,se.push(i.COLOR_ATTACHMENT0+Be),C.depthBuffer&&C.resolveDepthBuffer===!1&&(se.push(oe),Me.push(oe),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,Me)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,se))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),_e)for(let Be=0;Be<x.length;Be++){t.bindFramebuffer(i.FRAMEBUFFER,Ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.RENDERBUFFER,Ue.__webglColorRenderbuffer[Be]);let ge=n.get(x[Be]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Be,i.TEXTURE_2D,ge,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ue.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.resolveDepthBuffer===!1&&l){let x=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function ot(C){return Math.min(s.maxSamples,C.samples)}function re(C){let x=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function ee(C){let x=o.render.frame;u.get(C)!==x&&(u.set(C,x),C.update())}function ue(C,x){let N=C.colorSpace,Y=C.format,le=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||N!==cr&&N!==ys&&(_t.getTransfer(N)===Pt?(Y!==vi||le!==Fi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",N)),x}function we(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=H,this.resetTextureUnits=B,this.setTexture2D=W,this.setTexture2DArray=q,this.setTexture3D=F,this.setTextureCube=z,this.rebindTextures=dt,this.setupRenderTarget=k,this.updateRenderTargetMipmap=ht,this.updateMultisampleRenderTarget=Ce,this.setupDepthRenderbuffer=Ge,this.setupFrameBufferTexture=me,this.useMultisampledRTT=re}function MS(i,e){function t(n,s=ys){let r,o=_t.getTransfer(s);if(n===Fi)return i.UNSIGNED_BYTE;if(n===Hc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Vc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===_f)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===xf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===gf)return i.BYTE;if(n===vf)return i.SHORT;if(n===bo)return i.UNSIGNED_SHORT;if(n===kc)return i.INT;if(n===Ws)return i.UNSIGNED_INT;if(n===es)return i.FLOAT;if(n===Mo)return i.HALF_FLOAT;if(n===yf)return i.ALPHA;if(n===bf)return i.RGB;if(n===vi)return i.RGBA;if(n===co)return i.DEPTH_COMPONENT;if(n===So)return i.DEPTH_STENCIL;if(n===Mf)return i.RED;if(n===Gc)return i.RED_INTEGER;if(n===wf)return i.RG;if(n===Wc)return i.RG_INTEGER;if(n===Xc)return i.RGBA_INTEGER;if(n===Ga||n===Wa||n===Xa||n===qa)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ga)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ga)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===qc||n===Yc||n===$c||n===Zc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===qc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Yc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===$c)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Zc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Kc||n===Jc||n===jc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Kc||n===Jc)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===jc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Qc||n===eh||n===th||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===fh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Qc)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===eh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===th)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===nh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ih)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===sh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===rh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ah)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===lh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===ch)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===dh||n===ph||n===mh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===dh)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===ph)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===mh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===gh||n===vh||n===_h||n===xh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===gh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===vh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===_h)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===xh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===wo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var wS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,SS=`
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

}`,$f=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Sa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new oi({vertexShader:wS,fragmentShader:SS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new et(new Ra(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Zf=class extends Zi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,m=null,v=typeof XRWebGLBinding<"u",g=new $f,d={},b=t.getContextAttributes(),M=null,y=null,P=[],E=[],I=new Oe,D=null,S=new In;S.viewport=new It;let w=new In;w.viewport=new It;let T=[S,w],B=new Cc,H=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let X=P[Q];return X===void 0&&(X=new po,P[Q]=X),X.getTargetRaySpace()},this.getControllerGrip=function(Q){let X=P[Q];return X===void 0&&(X=new po,P[Q]=X),X.getGripSpace()},this.getHand=function(Q){let X=P[Q];return X===void 0&&(X=new po,P[Q]=X),X.getHandSpace()};function W(Q){let X=E.indexOf(Q.inputSource);if(X===-1)return;let me=P[X];me!==void 0&&(me.update(Q.inputSource,Q.frame,c||o),me.dispatchEvent({type:Q.type,data:Q.inputSource}))}function q(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",F);for(let Q=0;Q<P.length;Q++){let X=E[Q];X!==null&&(E[Q]=null,P[Q].disconnect(X))}H=null,V=null,g.reset();for(let Q in d)delete d[Q];e.setRenderTarget(M),p=null,f=null,h=null,s=null,y=null,Ie.stop(),n.isPresenting=!1,e.setPixelRatio(D),e.setSize(I.width,I.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",q),s.addEventListener("inputsourceschange",F),b.xrCompatible!==!0&&await t.makeXRCompatible(),D=e.getPixelRatio(),e.getSize(I),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let me=null,ve=null,ye=null;b.depth&&(ye=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,me=b.stencil?So:co,ve=b.stencil?wo:Ws);let Ge={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Ge),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),y=new Ki(f.textureWidth,f.textureHeight,{format:vi,type:Fi,depthTexture:new wa(f.textureWidth,f.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,me),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let me={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,me),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),y=new Ki(p.framebufferWidth,p.framebufferHeight,{format:vi,type:Fi,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Ie.setContext(s),Ie.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function F(Q){for(let X=0;X<Q.removed.length;X++){let me=Q.removed[X],ve=E.indexOf(me);ve>=0&&(E[ve]=null,P[ve].disconnect(me))}for(let X=0;X<Q.added.length;X++){let me=Q.added[X],ve=E.indexOf(me);if(ve===-1){for(let Ge=0;Ge<P.length;Ge++)if(Ge>=E.length){E.push(me),ve=Ge;break}else if(E[Ge]===null){E[Ge]=me,ve=Ge;break}if(ve===-1)break}let ye=P[ve];ye&&ye.connect(me)}}let z=new L,J=new L;function ne(Q,X,me){z.setFromMatrixPosition(X.matrixWorld),J.setFromMatrixPosition(me.matrixWorld);let ve=z.distanceTo(J),ye=X.projectionMatrix.elements,Ge=me.projectionMatrix.elements,dt=ye[14]/(ye[10]-1),k=ye[14]/(ye[10]+1),ht=(ye[9]+1)/ye[5],se=(ye[9]-1)/ye[5],Me=(ye[8]-1)/ye[0],Ce=(Ge[8]+1)/Ge[0],ot=dt*Me,re=dt*Ce,ee=ve/(-Me+Ce),ue=ee*-Me;if(X.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(ue),Q.translateZ(ee),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),ye[10]===-1)Q.projectionMatrix.copy(X.projectionMatrix),Q.projectionMatrixInverse.copy(X.projectionMatrixInverse);else{let we=dt+ee,C=k+ee,x=ot-ue,N=re+(ve-ue),Y=ht*k/C*we,le=se*k/C*we;Q.projectionMatrix.makePerspective(x,N,Y,le,we,C),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function te(Q,X){X===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(X.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let X=Q.near,me=Q.far;g.texture!==null&&(g.depthNear>0&&(X=g.depthNear),g.depthFar>0&&(me=g.depthFar)),B.near=w.near=S.near=X,B.far=w.far=S.far=me,(H!==B.near||V!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),H=B.near,V=B.far),B.layers.mask=Q.layers.mask|6,S.layers.mask=B.layers.mask&3,w.layers.mask=B.layers.mask&5;let ve=Q.parent,ye=B.cameras;te(B,ve);for(let Ge=0;Ge<ye.length;Ge++)te(ye[Ge],ve);ye.length===2?ne(B,S,w):B.projectionMatrix.copy(S.projectionMatrix),ce(Q,B,ve)};function ce(Q,X,me){me===null?Q.matrix.copy(X.matrixWorld):(Q.matrix.copy(me.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(X.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(X.projectionMatrix),Q.projectionMatrixInverse.copy(X.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=ho*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function(Q){return d[Q]};let fe=null;function xe(Q,X){if(u=X.getViewerPose(c||o),m=X,u!==null){let me=u.views;p!==null&&(e.setRenderTargetFramebuffer(y,p.framebuffer),e.setRenderTarget(y));let ve=!1;me.length!==B.cameras.length&&(B.cameras.length=0,ve=!0);for(let k=0;k<me.length;k++){let ht=me[k],se=null;if(p!==null)se=p.getViewport(ht);else{let Ce=h.getViewSubImage(f,ht);se=Ce.viewport,k===0&&(e.setRenderTargetTextures(y,Ce.colorTexture,Ce.depthStencilTexture),e.setRenderTarget(y))}let Me=T[k];Me===void 0&&(Me=new In,Me.layers.enable(k),Me.viewport=new It,T[k]=Me),Me.matrix.fromArray(ht.transform.matrix),Me.matrix.decompose(Me.position,Me.quaternion,Me.scale),Me.projectionMatrix.fromArray(ht.projectionMatrix),Me.projectionMatrixInverse.copy(Me.projectionMatrix).invert(),Me.viewport.set(se.x,se.y,se.width,se.height),k===0&&(B.matrix.copy(Me.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),ve===!0&&B.cameras.push(Me)}let ye=s.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=n.getBinding();let k=h.getDepthInformation(me[0]);k&&k.isValid&&k.texture&&g.init(k,s.renderState)}if(ye&&ye.includes("camera-access")&&v){e.state.unbindTexture(),h=n.getBinding();for(let k=0;k<me.length;k++){let ht=me[k].camera;if(ht){let se=d[ht];se||(se=new Sa,d[ht]=se);let Me=h.getCameraImage(ht);se.sourceTexture=Me}}}}for(let me=0;me<P.length;me++){let ve=E[me],ye=P[me];ve!==null&&ye!==void 0&&ye.update(ve,X,c||o)}fe&&fe(Q,X),X.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:X}),m=null}let Ie=new Mg;Ie.setAnimationLoop(xe),this.setAnimationLoop=function(Q){fe=Q},this.dispose=function(){}}},yr=new Di,ES=new Ut;function TS(i,e){function t(g,d){g.matrixAutoUpdate===!0&&g.updateMatrix(),d.value.copy(g.matrix)}function n(g,d){d.color.getRGB(g.fogColor.value,If(i)),d.isFog?(g.fogNear.value=d.near,g.fogFar.value=d.far):d.isFogExp2&&(g.fogDensity.value=d.density)}function s(g,d,b,M,y){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(g,d):d.isMeshToonMaterial?(r(g,d),h(g,d)):d.isMeshPhongMaterial?(r(g,d),u(g,d)):d.isMeshStandardMaterial?(r(g,d),f(g,d),d.isMeshPhysicalMaterial&&p(g,d,y)):d.isMeshMatcapMaterial?(r(g,d),m(g,d)):d.isMeshDepthMaterial?r(g,d):d.isMeshDistanceMaterial?(r(g,d),v(g,d)):d.isMeshNormalMaterial?r(g,d):d.isLineBasicMaterial?(o(g,d),d.isLineDashedMaterial&&a(g,d)):d.isPointsMaterial?l(g,d,b,M):d.isSpriteMaterial?c(g,d):d.isShadowMaterial?(g.color.value.copy(d.color),g.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(g,d){g.opacity.value=d.opacity,d.color&&g.diffuse.value.copy(d.color),d.emissive&&g.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(g.map.value=d.map,t(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,t(d.alphaMap,g.alphaMapTransform)),d.bumpMap&&(g.bumpMap.value=d.bumpMap,t(d.bumpMap,g.bumpMapTransform),g.bumpScale.value=d.bumpScale,d.side===Gn&&(g.bumpScale.value*=-1)),d.normalMap&&(g.normalMap.value=d.normalMap,t(d.normalMap,g.normalMapTransform),g.normalScale.value.copy(d.normalScale),d.side===Gn&&g.normalScale.value.negate()),d.displacementMap&&(g.displacementMap.value=d.displacementMap,t(d.displacementMap,g.displacementMapTransform),g.displacementScale.value=d.displacementScale,g.displacementBias.value=d.displacementBias),d.emissiveMap&&(g.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,g.emissiveMapTransform)),d.specularMap&&(g.specularMap.value=d.specularMap,t(d.specularMap,g.specularMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest);let b=e.get(d),M=b.envMap,y=b.envMapRotation;M&&(g.envMap.value=M,yr.copy(y),yr.x*=-1,yr.y*=-1,yr.z*=-1,M.isCubeTexture&&M.isRenderTargetTexture===!1&&(yr.y*=-1,yr.z*=-1),g.envMapRotation.value.setFromMatrix4(ES.makeRotationFromEuler(yr)),g.flipEnvMap.value=M.isCubeTexture&&M.isRenderTargetTexture===!1?-1:1,g.reflectivity.value=d.reflectivity,g.ior.value=d.ior,g.refractionRatio.value=d.refractionRatio),d.lightMap&&(g.lightMap.value=d.lightMap,g.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,g.lightMapTransform)),d.aoMap&&(g.aoMap.value=d.aoMap,g.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,g.aoMapTransform))}function o(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,d.map&&(g.map.value=d.map,t(d.map,g.mapTransform))}function a(g,d){g.dashSize.value=d.dashSize,g.totalSize.value=d.dashSize+d.gapSize,g.scale.value=d.scale}function l(g,d,b,M){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.size.value=d.size*b,g.scale.value=M*.5,d.map&&(g.map.value=d.map,t(d.map,g.uvTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,t(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function c(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.rotation.value=d.rotation,d.map&&(g.map.value=d.map,t(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,t(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function u(g,d){g.specular.value.copy(d.specular),g.shininess.value=Math.max(d.shininess,1e-4)}function h(g,d){d.gradientMap&&(g.gradientMap.value=d.gradientMap)}function f(g,d){g.metalness.value=d.metalness,d.metalnessMap&&(g.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,g.metalnessMapTransform)),g.roughness.value=d.roughness,d.roughnessMap&&(g.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,g.roughnessMapTransform)),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)}function p(g,d,b){g.ior.value=d.ior,d.sheen>0&&(g.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),g.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(g.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,g.sheenColorMapTransform)),d.sheenRoughnessMap&&(g.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,g.sheenRoughnessMapTransform))),d.clearcoat>0&&(g.clearcoat.value=d.clearcoat,g.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(g.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,g.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(g.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Gn&&g.clearcoatNormalScale.value.negate())),d.dispersion>0&&(g.dispersion.value=d.dispersion),d.iridescence>0&&(g.iridescence.value=d.iridescence,g.iridescenceIOR.value=d.iridescenceIOR,g.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(g.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,g.iridescenceMapTransform)),d.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),d.transmission>0&&(g.transmission.value=d.transmission,g.transmissionSamplerMap.value=b.texture,g.transmissionSamplerSize.value.set(b.width,b.height),d.transmissionMap&&(g.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,g.transmissionMapTransform)),g.thickness.value=d.thickness,d.thicknessMap&&(g.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=d.attenuationDistance,g.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(g.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(g.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=d.specularIntensity,g.specularColor.value.copy(d.specularColor),d.specularColorMap&&(g.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,g.specularColorMapTransform)),d.specularIntensityMap&&(g.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,d){d.matcap&&(g.matcap.value=d.matcap)}function v(g,d){let b=e.get(d).light;g.referencePosition.value.setFromMatrixPosition(b.matrixWorld),g.nearDistance.value=b.shadow.camera.near,g.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function AS(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,M){let y=M.program;n.uniformBlockBinding(b,y)}function c(b,M){let y=s[b.id];y===void 0&&(m(b),y=u(b),s[b.id]=y,b.addEventListener("dispose",g));let P=M.program;n.updateUBOMapping(b,P);let E=e.render.frame;r[b.id]!==E&&(f(b),r[b.id]=E)}function u(b){let M=h();b.__bindingPointIndex=M;let y=i.createBuffer(),P=b.__size,E=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,y),i.bufferData(i.UNIFORM_BUFFER,P,E),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,M,y),y}function h(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(b){let M=s[b.id],y=b.uniforms,P=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let E=0,I=y.length;E<I;E++){let D=Array.isArray(y[E])?y[E]:[y[E]];for(let S=0,w=D.length;S<w;S++){let T=D[S];if(p(T,E,S,P)===!0){let B=T.__offset,H=Array.isArray(T.value)?T.value:[T.value],V=0;for(let W=0;W<H.length;W++){let q=H[W],F=v(q);typeof q=="number"||typeof q=="boolean"?(T.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,B+V,T.__data)):q.isMatrix3?(T.__data[0]=q.elements[0],T.__data[1]=q.elements[1],T.__data[2]=q.elements[2],T.__data[3]=0,T.__data[4]=q.elements[3],T.__data[5]=q.elements[4],T.__data[6]=q.elements[5],T.__data[7]=0,T.__data[8]=q.elements[6],T.__data[9]=q.elements[7],T.__data[10]=q.elements[8],T.__data[11]=0):(q.toArray(T.__data,V),V+=F.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,B,T.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(b,M,y,P){let E=b.value,I=M+"_"+y;if(P[I]===void 0)return typeof E=="number"||typeof E=="boolean"?P[I]=E:P[I]=E.clone(),!0;{let D=P[I];if(typeof E=="number"||typeof E=="boolean"){if(D!==E)return P[I]=E,!0}else if(D.equals(E)===!1)return D.copy(E),!0}return!1}function m(b){let M=b.uniforms,y=0,P=16;for(let I=0,D=M.length;I<D;I++){let S=Array.isArray(M[I])?M[I]:[M[I]];for(let w=0,T=S.length;w<T;w++){let B=S[w],H=Array.isArray(B.value)?B.value:[B.value];for(let V=0,W=H.length;V<W;V++){let q=H[V],F=v(q),z=y%P,J=z%F.boundary,ne=z+J;y+=J,ne!==0&&P-ne<F.storage&&(y+=P-ne),B.__data=new Float32Array(F.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=y,y+=F.storage}}}let E=y%P;return E>0&&(y+=P-E),b.__size=y,b.__cache={},this}function v(b){let M={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(M.boundary=4,M.storage=4):b.isVector2?(M.boundary=8,M.storage=8):b.isVector3||b.isColor?(M.boundary=16,M.storage=12):b.isVector4?(M.boundary=16,M.storage=16):b.isMatrix3?(M.boundary=48,M.storage=48):b.isMatrix4?(M.boundary=64,M.storage=64):b.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",b),M}function g(b){let M=b.target;M.removeEventListener("dispose",g);let y=o.indexOf(M.__bindingPointIndex);o.splice(y,1),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function d(){for(let b in s)i.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var Sh=class{constructor(e={}){let{canvas:t=$m(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let m=new Uint32Array(4),v=new Int32Array(4),g=null,d=null,b=[],M=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=xs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let y=this,P=!1;this._outputColorSpace=Vn;let E=0,I=0,D=null,S=-1,w=null,T=new It,B=new It,H=null,V=new at(0),W=0,q=t.width,F=t.height,z=1,J=null,ne=null,te=new It(0,0,q,F),ce=new It(0,0,q,F),fe=!1,xe=new _o,Ie=!1,Q=!1,X=new Ut,me=new L,ve=new It,ye={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ge=!1;function dt(){return D===null?z:1}let k=n;function ht(R,K){return t.getContext(R,K)}try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"180"}`),t.addEventListener("webglcontextlost",Ae,!1),t.addEventListener("webglcontextrestored",Ve,!1),t.addEventListener("webglcontextcreationerror",Se,!1),k===null){let K="webgl2";if(k=ht(K,R),k===null)throw ht(K)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(R){throw console.error("THREE.WebGLRenderer: "+R.message),R}let se,Me,Ce,ot,re,ee,ue,we,C,x,N,Y,le,oe,Ue,_e,Fe,Be,ge,Re,qe,Ye,Le,Ze;function $(){se=new XM(k),se.init(),Ye=new MS(k,se),Me=new BM(k,se,e,Ye),Ce=new yS(k,se),Me.reversedDepthBuffer&&f&&Ce.buffers.depth.setReversed(!0),ot=new $M(k),re=new aS,ee=new bS(k,se,Ce,re,Me,Ye,ot),ue=new kM(y),we=new WM(y),C=new ey(k),Le=new FM(k,C),x=new qM(k,C,ot,Le),N=new KM(k,x,C,ot),ge=new ZM(k,Me,ee),_e=new zM(re),Y=new oS(y,ue,we,se,Me,Le,_e),le=new TS(y,re),oe=new cS,Ue=new mS(se),Be=new NM(y,ue,we,Ce,N,p,l),Fe=new _S(y,N,Me),Ze=new AS(k,ot,Me,Ce),Re=new OM(k,se,ot),qe=new YM(k,se,ot),ot.programs=Y.programs,y.capabilities=Me,y.extensions=se,y.properties=re,y.renderLists=oe,y.shadowMap=Fe,y.state=Ce,y.info=ot}$();let Ee=new Zf(y,k);this.xr=Ee,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=se.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=se.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return z},this.setPixelRatio=function(R){R!==void 0&&(z=R,this.setSize(q,F,!1))},this.getSize=function(R){return R.set(q,F)},this.setSize=function(R,K,he=!0){if(Ee.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=R,F=K,t.width=Math.floor(R*z),t.height=Math.floor(K*z),he===!0&&(t.style.width=R+"px",t.style.height=K+"px"),this.setViewport(0,0,R,K)},this.getDrawingBufferSize=function(R){return R.set(q*z,F*z).floor()},this.setDrawingBufferSize=function(R,K,he){q=R,F=K,z=he,t.width=Math.floor(R*he),t.height=Math.floor(K*he),this.setViewport(0,0,R,K)},this.getCurrentViewport=function(R){return R.copy(T)},this.getViewport=function(R){return R.copy(te)},this.setViewport=function(R,K,he,ae){R.isVector4?te.set(R.x,R.y,R.z,R.w):te.set(R,K,he,ae),Ce.viewport(T.copy(te).multiplyScalar(z).round())},this.getScissor=function(R){return R.copy(ce)},this.setScissor=function(R,K,he,ae){R.isVector4?ce.set(R.x,R.y,R.z,R.w):ce.set(R,K,he,ae),Ce.scissor(B.copy(ce).multiplyScalar(z).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(R){Ce.setScissorTest(fe=R)},this.setOpaqueSort=function(R){J=R},this.setTransparentSort=function(R){ne=R},this.getClearColor=function(R){return R.copy(Be.getClearColor())},this.setClearColor=function(){Be.setClearColor(...arguments)},this.getClearAlpha=function(){return Be.getClearAlpha()},this.setClearAlpha=function(){Be.setClearAlpha(...arguments)},this.clear=function(R=!0,K=!0,he=!0){let ae=0;if(R){let j=!1;if(D!==null){let Te=D.texture.format;j=Te===Xc||Te===Wc||Te===Gc}if(j){let Te=D.texture.type,Ne=Te===Fi||Te===Ws||Te===bo||Te===wo||Te===Hc||Te===Vc,We=Be.getClearColor(),ze=Be.getClearAlpha(),Qe=We.r,tt=We.g,Ke=We.b;Ne?(m[0]=Qe,m[1]=tt,m[2]=Ke,m[3]=ze,k.clearBufferuiv(k.COLOR,0,m)):(v[0]=Qe,v[1]=tt,v[2]=Ke,v[3]=ze,k.clearBufferiv(k.COLOR,0,v))}else ae|=k.COLOR_BUFFER_BIT}K&&(ae|=k.DEPTH_BUFFER_BIT),he&&(ae|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k.clear(ae)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",Ae,!1),t.removeEventListener("webglcontextrestored",Ve,!1),t.removeEventListener("webglcontextcreationerror",Se,!1),Be.dispose(),oe.dispose(),Ue.dispose(),re.dispose(),ue.dispose(),we.dispose(),N.dispose(),Le.dispose(),Ze.dispose(),Y.dispose(),Ee.dispose(),Ee.removeEventListener("sessionstart",Ft),Ee.removeEventListener("sessionend",ei),Yn.stop()};function Ae(R){R.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),P=!0}function Ve(){console.log("THREE.WebGLRenderer: Context Restored."),P=!1;let R=ot.autoReset,K=Fe.enabled,he=Fe.autoUpdate,ae=Fe.needsUpdate,j=Fe.type;$(),ot.autoReset=R,Fe.enabled=K,Fe.autoUpdate=he,Fe.needsUpdate=ae,Fe.type=j}function Se(R){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function pe(R){let K=R.target;K.removeEventListener("dispose",pe),$e(K)}function $e(R){st(R),re.remove(R)}function st(R){let K=re.get(R).programs;K!==void 0&&(K.forEach(function(he){Y.releaseProgram(he)}),R.isShaderMaterial&&Y.releaseShaderCache(R))}this.renderBufferDirect=function(R,K,he,ae,j,Te){K===null&&(K=ye);let Ne=j.isMesh&&j.matrixWorld.determinant()<0,We=os(R,K,he,ae,j);Ce.setMaterial(ae,Ne);let ze=he.index,Qe=1;if(ae.wireframe===!0){if(ze=x.getWireframeAttribute(he),ze===void 0)return;Qe=2}let tt=he.drawRange,Ke=he.attributes.position,ut=tt.start*Qe,yt=(tt.start+tt.count)*Qe;Te!==null&&(ut=Math.max(ut,Te.start*Qe),yt=Math.min(yt,(Te.start+Te.count)*Qe)),ze!==null?(ut=Math.max(ut,0),yt=Math.min(yt,ze.count)):Ke!=null&&(ut=Math.max(ut,0),yt=Math.min(yt,Ke.count));let kt=yt-ut;if(kt<0||kt===1/0)return;Le.setup(j,ae,We,he,ze);let Rt,lt=Re;if(ze!==null&&(Rt=C.get(ze),lt=qe,lt.setIndex(Rt)),j.isMesh)ae.wireframe===!0?(Ce.setLineWidth(ae.wireframeLinewidth*dt()),lt.setMode(k.LINES)):lt.setMode(k.TRIANGLES);else if(j.isLine){let je=ae.linewidth;je===void 0&&(je=1),Ce.setLineWidth(je*dt()),j.isLineSegments?lt.setMode(k.LINES):j.isLineLoop?lt.setMode(k.LINE_LOOP):lt.setMode(k.LINE_STRIP)}else j.isPoints?lt.setMode(k.POINTS):j.isSprite&&lt.setMode(k.TRIANGLES);if(j.isBatchedMesh)if(j._multiDrawInstances!==null)uo("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),lt.renderMultiDrawInstances(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount,j._multiDrawInstances);else if(se.get("WEBGL_multi_draw"))lt.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let je=j._multiDrawStarts,Ht=j._multiDrawCounts,gt=j._multiDrawCount,An=ze?C.get(ze).bytesPerElement:1,ws=re.get(ae).currentProgram.getUniforms();for(let Nn=0;Nn<gt;Nn++)ws.setValue(k,"_gl_DrawID",Nn),lt.render(je[Nn]/An,Ht[Nn])}else if(j.isInstancedMesh)lt.renderInstances(ut,kt,j.count);else if(he.isInstancedBufferGeometry){let je=he._maxInstanceCount!==void 0?he._maxInstanceCount:1/0,Ht=Math.min(he.instanceCount,je);lt.renderInstances(ut,kt,Ht)}else lt.render(ut,kt)};function Lt(R,K,he){R.transparent===!0&&R.side===Wn&&R.forceSinglePass===!1?(R.side=Gn,R.needsUpdate=!0,Zs(R,K,he),R.side=gs,R.needsUpdate=!0,Zs(R,K,he),R.side=Wn):Zs(R,K,he)}this.compile=function(R,K,he=null){he===null&&(he=R),d=Ue.get(he),d.init(K),M.push(d),he.traverseVisible(function(j){j.isLight&&j.layers.test(K.layers)&&(d.pushLight(j),j.castShadow&&d.pushShadow(j))}),R!==he&&R.traverseVisible(function(j){j.isLight&&j.layers.test(K.layers)&&(d.pushLight(j),j.castShadow&&d.pushShadow(j))}),d.setupLights();let ae=new Set;return R.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Te=j.material;if(Te)if(Array.isArray(Te))for(let Ne=0;Ne<Te.length;Ne++){let We=Te[Ne];Lt(We,he,j),ae.add(We)}else Lt(Te,he,j),ae.add(Te)}),d=M.pop(),ae},this.compileAsync=function(R,K,he=null){let ae=this.compile(R,K,he);return new Promise(j=>{function Te(){if(ae.forEach(function(Ne){re.get(Ne).currentProgram.isReady()&&ae.delete(Ne)}),ae.size===0){j(R);return}setTimeout(Te,10)}se.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let xt=null;function bn(R){xt&&xt(R)}function Ft(){Yn.stop()}function ei(){Yn.start()}let Yn=new Mg;Yn.setAnimationLoop(bn),typeof self<"u"&&Yn.setContext(self),this.setAnimationLoop=function(R){xt=R,Ee.setAnimationLoop(R),R===null?Yn.stop():Yn.start()},Ee.addEventListener("sessionstart",Ft),Ee.addEventListener("sessionend",ei),this.render=function(R,K){if(K!==void 0&&K.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),K.parent===null&&K.matrixWorldAutoUpdate===!0&&K.updateMatrixWorld(),Ee.enabled===!0&&Ee.isPresenting===!0&&(Ee.cameraAutoUpdate===!0&&Ee.updateCamera(K),K=Ee.getCamera()),R.isScene===!0&&R.onBeforeRender(y,R,K,D),d=Ue.get(R,M.length),d.init(K),M.push(d),X.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),xe.setFromProjectionMatrix(X,Pi,K.reversedDepth),Q=this.localClippingEnabled,Ie=_e.init(this.clippingPlanes,Q),g=oe.get(R,b.length),g.init(),b.push(g),Ee.enabled===!0&&Ee.isPresenting===!0){let Te=y.xr.getDepthSensingMesh();Te!==null&&Hi(Te,K,-1/0,y.sortObjects)}Hi(R,K,0,y.sortObjects),g.finish(),y.sortObjects===!0&&g.sort(J,ne),Ge=Ee.enabled===!1||Ee.isPresenting===!1||Ee.hasDepthSensing()===!1,Ge&&Be.addToRenderList(g,R),this.info.render.frame++,Ie===!0&&_e.beginShadows();let he=d.state.shadowsArray;Fe.render(he,R,K),Ie===!0&&_e.endShadows(),this.info.autoReset===!0&&this.info.reset();let ae=g.opaque,j=g.transmissive;if(d.setupLights(),K.isArrayCamera){let Te=K.cameras;if(j.length>0)for(let Ne=0,We=Te.length;Ne<We;Ne++){let ze=Te[Ne];rs(ae,j,R,ze)}Ge&&Be.render(R);for(let Ne=0,We=Te.length;Ne<We;Ne++){let ze=Te[Ne];Un(g,R,ze,ze.viewport)}}else j.length>0&&rs(ae,j,R,K),Ge&&Be.render(R),Un(g,R,K);D!==null&&I===0&&(ee.updateMultisampleRenderTarget(D),ee.updateRenderTargetMipmap(D)),R.isScene===!0&&R.onAfterRender(y,R,K),Le.resetDefaultState(),S=-1,w=null,M.pop(),M.length>0?(d=M[M.length-1],Ie===!0&&_e.setGlobalState(y.clippingPlanes,d.state.camera)):d=null,b.pop(),b.length>0?g=b[b.length-1]:g=null};function Hi(R,K,he,ae){if(R.visible===!1)return;if(R.layers.test(K.layers)){if(R.isGroup)he=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(K);else if(R.isLight)d.pushLight(R),R.castShadow&&d.pushShadow(R);else if(R.isSprite){if(!R.frustumCulled||xe.intersectsSprite(R)){ae&&ve.setFromMatrixPosition(R.matrixWorld).applyMatrix4(X);let Ne=N.update(R),We=R.material;We.visible&&g.push(R,Ne,We,he,ve.z,null)}}else if((R.isMesh||R.isLine||R.isPoints)&&(!R.frustumCulled||xe.intersectsObject(R))){let Ne=N.update(R),We=R.material;if(ae&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),ve.copy(R.boundingSphere.center)):(Ne.boundingSphere===null&&Ne.computeBoundingSphere(),ve.copy(Ne.boundingSphere.center)),ve.applyMatrix4(R.matrixWorld).applyMatrix4(X)),Array.isArray(We)){let ze=Ne.groups;for(let Qe=0,tt=ze.length;Qe<tt;Qe++){let Ke=ze[Qe],ut=We[Ke.materialIndex];ut&&ut.visible&&g.push(R,Ne,ut,he,ve.z,Ke)}}else We.visible&&g.push(R,Ne,We,he,ve.z,null)}}let Te=R.children;for(let Ne=0,We=Te.length;Ne<We;Ne++)Hi(Te[Ne],K,he,ae)}function Un(R,K,he,ae){let j=R.opaque,Te=R.transmissive,Ne=R.transparent;d.setupLightsView(he),Ie===!0&&_e.setGlobalState(y.clippingPlanes,he),ae&&Ce.viewport(T.copy(ae)),j.length>0&&yi(j,K,he),Te.length>0&&yi(Te,K,he),Ne.length>0&&yi(Ne,K,he),Ce.buffers.depth.setTest(!0),Ce.buffers.depth.setMask(!0),Ce.buffers.color.setMask(!0),Ce.setPolygonOffset(!1)}function rs(R,K,he,ae){if((he.isScene===!0?he.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[ae.id]===void 0&&(d.state.transmissionRenderTarget[ae.id]=new Ki(1,1,{generateMipmaps:!0,type:se.has("EXT_color_buffer_half_float")||se.has("EXT_color_buffer_float")?Mo:Fi,minFilter:Gs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:_t.workingColorSpace}));let Te=d.state.transmissionRenderTarget[ae.id],Ne=ae.viewport||T;Te.setSize(Ne.z*y.transmissionResolutionScale,Ne.w*y.transmissionResolutionScale);let We=y.getRenderTarget(),ze=y.getActiveCubeFace(),Qe=y.getActiveMipmapLevel();y.setRenderTarget(Te),y.getClearColor(V),W=y.getClearAlpha(),W<1&&y.setClearColor(16777215,.5),y.clear(),Ge&&Be.render(he);let tt=y.toneMapping;y.toneMapping=xs;let Ke=ae.viewport;if(ae.viewport!==void 0&&(ae.viewport=void 0),d.setupLightsView(ae),Ie===!0&&_e.setGlobalState(y.clippingPlanes,ae),yi(R,he,ae),ee.updateMultisampleRenderTarget(Te),ee.updateRenderTargetMipmap(Te),se.has("WEBGL_multisampled_render_to_texture")===!1){let ut=!1;for(let yt=0,kt=K.length;yt<kt;yt++){let Rt=K[yt],lt=Rt.object,je=Rt.geometry,Ht=Rt.material,gt=Rt.group;if(Ht.side===Wn&&lt.layers.test(ae.layers)){let An=Ht.side;Ht.side=Gn,Ht.needsUpdate=!0,Go(lt,he,ae,je,Ht,gt),Ht.side=An,Ht.needsUpdate=!0,ut=!0}}ut===!0&&(ee.updateMultisampleRenderTarget(Te),ee.updateRenderTargetMipmap(Te))}y.setRenderTarget(We,ze,Qe),y.setClearColor(V,W),Ke!==void 0&&(ae.viewport=Ke),y.toneMapping=tt}function yi(R,K,he){let ae=K.isScene===!0?K.overrideMaterial:null;for(let j=0,Te=R.length;j<Te;j++){let Ne=R[j],We=Ne.object,ze=Ne.geometry,Qe=Ne.group,tt=Ne.material;tt.allowOverride===!0&&ae!==null&&(tt=ae),We.layers.test(he.layers)&&Go(We,K,he,ze,tt,Qe)}}function Go(R,K,he,ae,j,Te){R.onBeforeRender(y,K,he,ae,j,Te),R.modelViewMatrix.multiplyMatrices(he.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),j.onBeforeRender(y,K,he,ae,R,Te),j.transparent===!0&&j.side===Wn&&j.forceSinglePass===!1?(j.side=Gn,j.needsUpdate=!0,y.renderBufferDirect(he,K,ae,j,R,Te),j.side=gs,j.needsUpdate=!0,y.renderBufferDirect(he,K,ae,j,R,Te),j.side=Wn):y.renderBufferDirect(he,K,ae,j,R,Te),R.onAfterRender(y,K,he,ae,j,Te)}function Zs(R,K,he){K.isScene!==!0&&(K=ye);let ae=re.get(R),j=d.state.lights,Te=d.state.shadowsArray,Ne=j.state.version,We=Y.getParameters(R,j.state,Te,K,he),ze=Y.getProgramCacheKey(We),Qe=ae.programs;ae.environment=R.isMeshStandardMaterial?K.environment:null,ae.fog=K.fog,ae.envMap=(R.isMeshStandardMaterial?we:ue).get(R.envMap||ae.environment),ae.envMapRotation=ae.environment!==null&&R.envMap===null?K.environmentRotation:R.envMapRotation,Qe===void 0&&(R.addEventListener("dispose",pe),Qe=new Map,ae.programs=Qe);let tt=Qe.get(ze);if(tt!==void 0){if(ae.currentProgram===tt&&ae.lightsStateVersion===Ne)return hl(R,We),tt}else We.uniforms=Y.getUniforms(R),R.onBeforeCompile(We,y),tt=Y.acquireProgram(We,ze),Qe.set(ze,tt),ae.uniforms=We.uniforms;let Ke=ae.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ke.clippingPlanes=_e.uniform),hl(R,We),ae.needsLights=Ks(R),ae.lightsStateVersion=Ne,ae.needsLights&&(Ke.ambientLightColor.value=j.state.ambient,Ke.lightProbe.value=j.state.probe,Ke.directionalLights.value=j.state.directional,Ke.directionalLightShadows.value=j.state.directionalShadow,Ke.spotLights.value=j.state.spot,Ke.spotLightShadows.value=j.state.spotShadow,Ke.rectAreaLights.value=j.state.rectArea,Ke.ltc_1.value=j.state.rectAreaLTC1,Ke.ltc_2.value=j.state.rectAreaLTC2,Ke.pointLights.value=j.state.point,Ke.pointLightShadows.value=j.state.pointShadow,Ke.hemisphereLights.value=j.state.hemi,Ke.directionalShadowMap.value=j.state.directionalShadowMap,Ke.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Ke.spotShadowMap.value=j.state.spotShadowMap,Ke.spotLightMatrix.value=j.state.spotLightMatrix,Ke.spotLightMap.value=j.state.spotLightMap,Ke.pointShadowMap.value=j.state.pointShadowMap,Ke.pointShadowMatrix.value=j.state.pointShadowMatrix),ae.currentProgram=tt,ae.uniformsList=null,tt}function cl(R){if(R.uniformsList===null){let K=R.currentProgram.getUniforms();R.uniformsList=Ao.seqWithValue(K.seq,R.uniforms)}return R.uniformsList}function hl(R,K){let he=re.get(R);he.outputColorSpace=K.outputColorSpace,he.batching=K.batching,he.batchingColor=K.batchingColor,he.instancing=K.instancing,he.instancingColor=K.instancingColor,he.instancingMorph=K.instancingMorph,he.skinning=K.skinning,he.morphTargets=K.morphTargets,he.morphNormals=K.morphNormals,he.morphColors=K.morphColors,he.morphTargetsCount=K.morphTargetsCount,he.numClippingPlanes=K.numClippingPlanes,he.numIntersection=K.numClipIntersection,he.vertexAlphas=K.vertexAlphas,he.vertexTangents=K.vertexTangents,he.toneMapping=K.toneMapping}function os(R,K,he,ae,j){K.isScene!==!0&&(K=ye),ee.resetTextureUnits();let Te=K.fog,Ne=ae.isMeshStandardMaterial?K.environment:null,We=D===null?y.outputColorSpace:D.isXRRenderTarget===!0?D.texture.colorSpace:cr,ze=(ae.isMeshStandardMaterial?we:ue).get(ae.envMap||Ne),Qe=ae.vertexColors===!0&&!!he.attributes.color&&he.attributes.color.itemSize===4,tt=!!he.attributes.tangent&&(!!ae.normalMap||ae.anisotropy>0),Ke=!!he.morphAttributes.position,ut=!!he.morphAttributes.normal,yt=!!he.morphAttributes.color,kt=xs;ae.toneMapped&&(D===null||D.isXRRenderTarget===!0)&&(kt=y.toneMapping);let Rt=he.morphAttributes.position||he.morphAttributes.normal||he.morphAttributes.color,lt=Rt!==void 0?Rt.length:0,je=re.get(ae),Ht=d.state.lights;if(Ie===!0&&(Q===!0||R!==w)){let dn=R===w&&ae.id===S;_e.setState(ae,R,dn)}let gt=!1;ae.version===je.__version?(je.needsLights&&je.lightsStateVersion!==Ht.state.version||je.outputColorSpace!==We||j.isBatchedMesh&&je.batching===!1||!j.isBatchedMesh&&je.batching===!0||j.isBatchedMesh&&je.batchingColor===!0&&j.colorTexture===null||j.isBatchedMesh&&je.batchingColor===!1&&j.colorTexture!==null||j.isInstancedMesh&&je.instancing===!1||!j.isInstancedMesh&&je.instancing===!0||j.isSkinnedMesh&&je.skinning===!1||!j.isSkinnedMesh&&je.skinning===!0||j.isInstancedMesh&&je.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&je.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&je.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&je.instancingMorph===!1&&j.morphTexture!==null||je.envMap!==ze||ae.fog===!0&&je.fog!==Te||je.numClippingPlanes!==void 0&&(je.numClippingPlanes!==_e.numPlanes||je.numIntersection!==_e.numIntersection)||je.vertexAlphas!==Qe||je.vertexTangents!==tt||je.morphTargets!==Ke||je.morphNormals!==ut||je.morphColors!==yt||je.toneMapping!==kt||je.morphTargetsCount!==lt)&&(gt=!0):(gt=!0,je.__version=ae.version);let An=je.currentProgram;gt===!0&&(An=Zs(ae,K,j));let ws=!1,Nn=!1,Js=!1,Vt=An.getUniforms(),Fn=je.uniforms;if(Ce.useProgram(An.program)&&(ws=!0,Nn=!0,Js=!0),ae.id!==S&&(S=ae.id,Nn=!0),ws||w!==R){Ce.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),Vt.setValue(k,"projectionMatrix",R.projectionMatrix),Vt.setValue(k,"viewMatrix",R.matrixWorldInverse);let pn=Vt.map.cameraPosition;pn!==void 0&&pn.setValue(k,me.setFromMatrixPosition(R.matrixWorld)),Me.logarithmicDepthBuffer&&Vt.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(ae.isMeshPhongMaterial||ae.isMeshToonMaterial||ae.isMeshLambertMaterial||ae.isMeshBasicMaterial||ae.isMeshStandardMaterial||ae.isShaderMaterial)&&Vt.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),w!==R&&(w=R,Nn=!0,Js=!0)}if(j.isSkinnedMesh){Vt.setOptional(k,j,"bindMatrix"),Vt.setOptional(k,j,"bindMatrixInverse");let dn=j.skeleton;dn&&(dn.boneTexture===null&&dn.computeBoneTexture(),Vt.setValue(k,"boneTexture",dn.boneTexture,ee))}j.isBatchedMesh&&(Vt.setOptional(k,j,"batchingTexture"),Vt.setValue(k,"batchingTexture",j._matricesTexture,ee),Vt.setOptional(k,j,"batchingIdTexture"),Vt.setValue(k,"batchingIdTexture",j._indirectTexture,ee),Vt.setOptional(k,j,"batchingColorTexture"),j._colorsTexture!==null&&Vt.setValue(k,"batchingColorTexture",j._colorsTexture,ee));let $n=he.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&ge.update(j,he,An),(Nn||je.receiveShadow!==j.receiveShadow)&&(je.receiveShadow=j.receiveShadow,Vt.setValue(k,"receiveShadow",j.receiveShadow)),ae.isMeshGouraudMaterial&&ae.envMap!==null&&(Fn.envMap.value=ze,Fn.flipEnvMap.value=ze.isCubeTexture&&ze.isRenderTargetTexture===!1?-1:1),ae.isMeshStandardMaterial&&ae.envMap===null&&K.environment!==null&&(Fn.envMapIntensity.value=K.environmentIntensity),Nn&&(Vt.setValue(k,"toneMappingExposure",y.toneMappingExposure),je.needsLights&&ru(Fn,Js),Te&&ae.fog===!0&&le.refreshFogUniforms(Fn,Te),le.refreshMaterialUniforms(Fn,ae,z,F,d.state.transmissionRenderTarget[R.id]),Ao.upload(k,cl(je),Fn,ee)),ae.isShaderMaterial&&ae.uniformsNeedUpdate===!0&&(Ao.upload(k,cl(je),Fn,ee),ae.uniformsNeedUpdate=!1),ae.isSpriteMaterial&&Vt.setValue(k,"center",j.center),Vt.setValue(k,"modelViewMatrix",j.modelViewMatrix),Vt.setValue(k,"normalMatrix",j.normalMatrix),Vt.setValue(k,"modelMatrix",j.matrixWorld),ae.isShaderMaterial||ae.isRawShaderMaterial){let dn=ae.uniformsGroups;for(let pn=0,Ss=dn.length;pn<Ss;pn++){let ui=dn[pn];Ze.update(ui,An),Ze.bind(ui,An)}}return An}function ru(R,K){R.ambientLightColor.needsUpdate=K,R.lightProbe.needsUpdate=K,R.directionalLights.needsUpdate=K,R.directionalLightShadows.needsUpdate=K,R.pointLights.needsUpdate=K,R.pointLightShadows.needsUpdate=K,R.spotLights.needsUpdate=K,R.spotLightShadows.needsUpdate=K,R.rectAreaLights.needsUpdate=K,R.hemisphereLights.needsUpdate=K}function Ks(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return E},this.getActiveMipmapLevel=function(){return I},this.getRenderTarget=function(){return D},this.setRenderTargetTextures=function(R,K,he){let ae=re.get(R);ae.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,ae.__autoAllocateDepthBuffer===!1&&(ae.__useRenderToTexture=!1),re.get(R.texture).__webglTexture=K,re.get(R.depthTexture).__webglTexture=ae.__autoAllocateDepthBuffer?void 0:he,ae.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,K){let he=re.get(R);he.__webglFramebuffer=K,he.__useDefaultFramebuffer=K===void 0};let ul=k.createFramebuffer();this.setRenderTarget=function(R,K=0,he=0){D=R,E=K,I=he;let ae=!0,j=null,Te=!1,Ne=!1;if(R){let ze=re.get(R);if(ze.__useDefaultFramebuffer!==void 0)Ce.bindFramebuffer(k.FRAMEBUFFER,null),ae=!1;else if(ze.__webglFramebuffer===void 0)ee.setupRenderTarget(R);else if(ze.__hasExternalTextures)ee.rebindTextures(R,re.get(R.texture).__webglTexture,re.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Ke=R.depthTexture;if(ze.__boundDepthTexture!==Ke){if(Ke!==null&&re.has(Ke)&&(R.width!==Ke.image.width||R.height!==Ke.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");ee.setupDepthRenderbuffer(R)}}let Qe=R.texture;(Qe.isData3DTexture||Qe.isDataArrayTexture||Qe.isCompressedArrayTexture)&&(Ne=!0);let tt=re.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(tt[K])?j=tt[K][he]:j=tt[K],Te=!0):R.samples>0&&ee.useMultisampledRTT(R)===!1?j=re.get(R).__webglMultisampledFramebuffer:Array.isArray(tt)?j=tt[he]:j=tt,T.copy(R.viewport),B.copy(R.scissor),H=R.scissorTest}else T.copy(te).multiplyScalar(z).floor(),B.copy(ce).multiplyScalar(z).floor(),H=fe;if(he!==0&&(j=ul),Ce.bindFramebuffer(k.FRAMEBUFFER,j)&&ae&&Ce.drawBuffers(R,j),Ce.viewport(T),Ce.scissor(B),Ce.setScissorTest(H),Te){let ze=re.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+K,ze.__webglTexture,he)}else if(Ne){let ze=K;for(let Qe=0;Qe<R.textures.length;Qe++){let tt=re.get(R.textures[Qe]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Qe,tt.__webglTexture,he,ze)}}else if(R!==null&&he!==0){let ze=re.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,ze.__webglTexture,he)}S=-1},this.readRenderTargetPixels=function(R,K,he,ae,j,Te,Ne,We=0){if(!(R&&R.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ze=re.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ne!==void 0&&(ze=ze[Ne]),ze){Ce.bindFramebuffer(k.FRAMEBUFFER,ze);try{let Qe=R.textures[We],tt=Qe.format,Ke=Qe.type;if(!Me.textureFormatReadable(tt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Me.textureTypeReadable(Ke)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}K>=0&&K<=R.width-ae&&he>=0&&he<=R.height-j&&(R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+We),k.readPixels(K,he,ae,j,Ye.convert(tt),Ye.convert(Ke),Te))}finally{let Qe=D!==null?re.get(D).__webglFramebuffer:null;Ce.bindFramebuffer(k.FRAMEBUFFER,Qe)}}},this.readRenderTargetPixelsAsync=async function(R,K,he,ae,j,Te,Ne,We=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ze=re.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ne!==void 0&&(ze=ze[Ne]),ze)if(K>=0&&K<=R.width-ae&&he>=0&&he<=R.height-j){Ce.bindFramebuffer(k.FRAMEBUFFER,ze);let Qe=R.textures[We],tt=Qe.format,Ke=Qe.type;if(!Me.textureFormatReadable(tt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Me.textureTypeReadable(Ke))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ut=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ut),k.bufferData(k.PIXEL_PACK_BUFFER,Te.byteLength,k.STREAM_READ),R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+We),k.readPixels(K,he,ae,j,Ye.convert(tt),Ye.convert(Ke),0);let yt=D!==null?re.get(D).__webglFramebuffer:null;Ce.bindFramebuffer(k.FRAMEBUFFER,yt);let kt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Zm(k,kt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ut),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Te),k.deleteBuffer(ut),k.deleteSync(kt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,K=null,he=0){let ae=Math.pow(2,-he),j=Math.floor(R.image.width*ae),Te=Math.floor(R.image.height*ae),Ne=K!==null?K.x:0,We=K!==null?K.y:0;ee.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,he,0,0,Ne,We,j,Te),Ce.unbindTexture()};let Vi=k.createFramebuffer(),on=k.createFramebuffer();this.copyTextureToTexture=function(R,K,he=null,ae=null,j=0,Te=null){Te===null&&(j!==0?(uo("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),Te=j,j=0):Te=0);let Ne,We,ze,Qe,tt,Ke,ut,yt,kt,Rt=R.isCompressedTexture?R.mipmaps[Te]:R.image;if(he!==null)Ne=he.max.x-he.min.x,We=he.max.y-he.min.y,ze=he.isBox3?he.max.z-he.min.z:1,Qe=he.min.x,tt=he.min.y,Ke=he.isBox3?he.min.z:0;else{let $n=Math.pow(2,-j);Ne=Math.floor(Rt.width*$n),We=Math.floor(Rt.height*$n),R.isDataArrayTexture?ze=Rt.depth:R.isData3DTexture?ze=Math.floor(Rt.depth*$n):ze=1,Qe=0,tt=0,Ke=0}ae!==null?(ut=ae.x,yt=ae.y,kt=ae.z):(ut=0,yt=0,kt=0);let lt=Ye.convert(K.format),je=Ye.convert(K.type),Ht;K.isData3DTexture?(ee.setTexture3D(K,0),Ht=k.TEXTURE_3D):K.isDataArrayTexture||K.isCompressedArrayTexture?(ee.setTexture2DArray(K,0),Ht=k.TEXTURE_2D_ARRAY):(ee.setTexture2D(K,0),Ht=k.TEXTURE_2D),k.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,K.flipY),k.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,K.premultiplyAlpha),k.pixelStorei(k.UNPACK_ALIGNMENT,K.unpackAlignment);let gt=k.getParameter(k.UNPACK_ROW_LENGTH),An=k.getParameter(k.UNPACK_IMAGE_HEIGHT),ws=k.getParameter(k.UNPACK_SKIP_PIXELS),Nn=k.getParameter(k.UNPACK_SKIP_ROWS),Js=k.getParameter(k.UNPACK_SKIP_IMAGES);k.pixelStorei(k.UNPACK_ROW_LENGTH,Rt.width),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Rt.height),k.pixelStorei(k.UNPACK_SKIP_PIXELS,Qe),k.pixelStorei(k.UNPACK_SKIP_ROWS,tt),k.pixelStorei(k.UNPACK_SKIP_IMAGES,Ke);let Vt=R.isDataArrayTexture||R.isData3DTexture,Fn=K.isDataArrayTexture||K.isData3DTexture;if(R.isDepthTexture){let $n=re.get(R),dn=re.get(K),pn=re.get($n.__renderTarget),Ss=re.get(dn.__renderTarget);Ce.bindFramebuffer(k.READ_FRAMEBUFFER,pn.__webglFramebuffer),Ce.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ss.__webglFramebuffer);for(let ui=0;ui<ze;ui++)Vt&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,re.get(R).__webglTexture,j,Ke+ui),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,re.get(K).__webglTexture,Te,kt+ui)),k.blitFramebuffer(Qe,tt,Ne,We,ut,yt,Ne,We,k.DEPTH_BUFFER_BIT,k.NEAREST);Ce.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(j!==0||R.isRenderTargetTexture||re.has(R)){let $n=re.get(R),dn=re.get(K);Ce.bindFramebuffer(k.READ_FRAMEBUFFER,Vi),Ce.bindFramebuffer(k.DRAW_FRAMEBUFFER,on);for(let pn=0;pn<ze;pn++)Vt?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,$n.__webglTexture,j,Ke+pn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,$n.__webglTexture,j),Fn?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,dn.__webglTexture,Te,kt+pn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,dn.__webglTexture,Te),j!==0?k.blitFramebuffer(Qe,tt,Ne,We,ut,yt,Ne,We,k.COLOR_BUFFER_BIT,k.NEAREST):Fn?k.copyTexSubImage3D(Ht,Te,ut,yt,kt+pn,Qe,tt,Ne,We):k.copyTexSubImage2D(Ht,Te,ut,yt,Qe,tt,Ne,We);Ce.bindFramebuffer(k.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Fn?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(Ht,Te,ut,yt,kt,Ne,We,ze,lt,je,Rt.data):K.isCompressedArrayTexture?k.compressedTexSubImage3D(Ht,Te,ut,yt,kt,Ne,We,ze,lt,Rt.data):k.texSubImage3D(Ht,Te,ut,yt,kt,Ne,We,ze,lt,je,Rt):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Te,ut,yt,Ne,We,lt,je,Rt.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Te,ut,yt,Rt.width,Rt.height,lt,Rt.data):k.texSubImage2D(k.TEXTURE_2D,Te,ut,yt,Ne,We,lt,je,Rt);k.pixelStorei(k.UNPACK_ROW_LENGTH,gt),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,An),k.pixelStorei(k.UNPACK_SKIP_PIXELS,ws),k.pixelStorei(k.UNPACK_SKIP_ROWS,Nn),k.pixelStorei(k.UNPACK_SKIP_IMAGES,Js),Te===0&&K.generateMipmaps&&k.generateMipmap(Ht),Ce.unbindTexture()},this.initRenderTarget=function(R){re.get(R).__webglFramebuffer===void 0&&ee.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?ee.setTextureCube(R,0):R.isData3DTexture?ee.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?ee.setTexture2DArray(R,0):ee.setTexture2D(R,0),Ce.unbindTexture()},this.resetState=function(){E=0,I=0,D=null,Ce.reset(),Le.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Pi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};var Ah=({x:i,y:e,z:t})=>new L(i,e,t),RS=1e-9,Ag=i=>i.joint.length?Ah(i.joint[0].path.end).length():i.length,Rg=(i,e,t=0)=>i.joint.length?Math.max(Math.abs(i.length-e),Math.abs(t)):i.length-e,wr,Cg,Jf,jf=class jf{constructor(e){ml(this,wr);this.free=e.length,this.along=new L(...e.direction);let[t]=e.joint;if(!t)return;Rn(this,wr,Cg).call(this,t);let[n]=e.second;n&&(this.second=new jf({length:0,direction:e.direction,joint:[n],second:[]}),this.beyond=new L,this.inner=new sn)}get isHinge(){return this.curvature>RS}at(e,t,n=null,s=0){this.second&&s!==0?(Rn(this,wr,Jf).call(this,e,t,this.inner),this.second.at(s,this.beyond,n),t.add(this.beyond.sub(this.start).applyQuaternion(this.inner)),n?.premultiply(this.inner)):Rn(this,wr,Jf).call(this,e,t,n)}};wr=new WeakSet,Cg=function(e){this.start=Ah(e.path.end),this.along=Ah(e.path.direction),this.inward=Ah(e.path.inward),this.axis=this.along.clone().cross(this.inward),this.curvature=e.path.curvature,this.anchor=new L(...e.anchor)},Jf=function(e,t,n){if(n?.identity(),!this.start){t.copy(this.along).multiplyScalar(e);return}let s=e-this.free;if(t.copy(this.start),!this.isHinge){t.addScaledVector(this.along,s);return}let r=this.curvature*s;t.addScaledVector(this.along,Math.sin(r)/this.curvature),t.addScaledVector(this.inward,(1-Math.cos(r))/this.curvature),n?.setFromAxisAngle(this.axis,r)};var Co=jf;function CS(i){let e=[];for(let n of i)for(let[s,r]of n.impacts.slice(0,12)){let o=s+n.shift-.008;e.push([o,Math.min(r,s+.12)+n.shift+.02])}e.sort((n,s)=>n[0]-s[0]);let t=[];for(let n of e){let s=t[t.length-1];s&&n[0]<s[1]+2*.12?s[1]=Math.max(s[1],n[1]):t.push([...n])}return t.map(([n,s])=>[n,s,Math.min(1,Math.max(.005,(s-n)/3))])}function Qf(i,e){let t=1;for(let[n,s,r]of i){let o=Math.max(n-e,e-s,0);o<.12&&(t=Math.min(t,r**((1+Math.cos(Math.PI*o/.12))/2)))}return t}function Ig(i){let e=Math.min(...i.map(l=>l.begin+l.shift)),t=Math.max(...i.map(l=>l.end+l.shift)),n=CS(i),s=new Set([e,t]);for(let l=1;l<200;l++)s.add(e+(t-e)*l/200);for(let[l,c]of n)for(let u=0;u<=60;u++)s.add(l-.12+(c-l+2*.12)*u/60),s.add(l+(c-l)*u/60),s.add(l-.12*u/60),s.add(c+.12*u/60);let r=[...s].filter(l=>l>=e&&l<=t).sort((l,c)=>l-c),o=[0];for(let l=1;l<r.length;l++){let c=Math.sqrt(Qf(n,r[l-1])*Qf(n,r[l]));o.push(o[l-1]+(r[l]-r[l-1])/c)}let a=o[o.length-1]||1;return{begin:e,end:t,stretches:n,total:a,paceAt:l=>Qf(n,l),watchedAt:l=>Pg(r,o,l),timeAt:l=>Pg(o,r,l)}}function Pg(i,e,t){let n=0,s=i.length-1;if(!(t>i[0]))return e[0];if(t>=i[s])return e[s];for(;s-n>1;){let r=n+s>>1;i[r]<=t?n=r:s=r}return e[n]+(e[s]-e[n])*(t-i[n])/(i[s]-i[n])}var PS="uplot",IS="u-hz",LS="u-vt",DS="u-title",US="u-wrap",NS="u-under",FS="u-over",OS="u-axis",Tr="u-off",BS="u-select",zS="u-cursor-x",kS="u-cursor-y",HS="u-cursor-pt",VS="u-legend",GS="u-live",WS="u-inline",XS="u-series",qS="u-marker",Lg="u-label",YS="u-value",Ka="width",Ja="height";var Dg="bottom",Po="left",ed="right",vd="#000",Ug=vd+"0",td="mousemove",Ng="mousedown",nd="mouseup",Fg="mouseenter",Og="mouseleave",Bg="dblclick",$S="resize",ZS="scroll",zg="change",Lh="dppxchange",_d="--",Oo=typeof window<"u",ad=Oo?document:null,Lo=Oo?window:null,KS=Oo?navigator:null,Et,Rh;function ld(){let i=devicePixelRatio;Et!=i&&(Et=i,Rh&&hd(zg,Rh,ld),Rh=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),Ar(zg,Rh,ld),Lo.dispatchEvent(new CustomEvent(Lh)))}function li(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function cd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Oi(i,e,t,n){let s=ad.createElement(i);return e!=null&&li(s,e),t?.insertBefore(s,n),s}function _i(i,e){return Oi("div",i,e)}var kg=new WeakMap;function ts(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=kg.get(i);r!=o&&(i.style.transform=r,kg.set(i,r),e<0||t<0||e>n||t>s?li(i,Tr):cd(i,Tr))}var Hg=new WeakMap;function Vg(i,e,t){let n=e+t,s=Hg.get(i);n!=s&&(Hg.set(i,n),i.style.background=e,i.style.borderColor=t)}var Gg=new WeakMap;function Wg(i,e,t,n){let s=e+""+t,r=Gg.get(i);s!=r&&(Gg.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var xd={passive:!0},JS={...xd,capture:!0};function Ar(i,e,t,n){e.addEventListener(i,t,n?JS:xd)}function hd(i,e,t,n){e.removeEventListener(i,t,xd)}Oo&&ld();function Bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ci((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function _0(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var x0=i=>i!=null,y0=i=>i!=null&&i>0,Nh=_0(x0),jS=_0(y0);function QS(i,e,t,n=0,s=!1){let r=s?jS:Nh,o=s?y0:x0;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function Fh(i,e,t,n){let s=Yg(i),r=Yg(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?bs:b0,a=s==1?ci:xi,l=r==1?xi:ci,c=a(o(un(i))),u=l(o(un(e))),h=Do(t,c),f=Do(t,u);return t==10&&(c<0&&(h=zt(h,-c)),u<0&&(f=zt(f,-u))),n||t==2?(i=h*s,e=f*r):(i=E0(i,h),e=Oh(e,f)),[i,e]}function yd(i,e,t,n){let s=Fh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var bd=.1,Xg={mode:3,pad:bd},Qa={pad:0,soft:null,mode:0},e1={min:Qa,max:Qa};function Dh(i,e,t,n){return Bh(t)?qg(i,e,t):(Qa.pad=t,Qa.soft=n?0:null,Qa.mode=n?3:0,qg(i,e,e1))}function Mt(i,e){return i??e}function t1(i,e,t){for(e=Mt(e,0),t=Mt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function qg(i,e,t){let n=t.min,s=t.max,r=Mt(n.pad,0),o=Mt(s.pad,0),a=Mt(n.hard,-Bt),l=Mt(s.hard,Bt),c=Mt(n.soft,Bt),u=Mt(s.soft,-Bt),h=Mt(n.mode,0),f=Mt(s.mode,0),p=e-i,m=bs(p),v=qn(un(i),un(e)),g=bs(v),d=un(g-m);(p<1e-24||d>10)&&(p=0,(i==0||e==0)&&(p=1e-24,h==2&&c!=Bt&&(r=0),f==2&&u!=-Bt&&(o=0)));let b=p||v||1e3,M=bs(b),y=Do(10,ci(M)),P=b*(p==0?i==0?.1:1:r),E=zt(E0(i-P,y/10),24),I=i>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Bt,D=qn(a,E<I&&i>=I?I:zi(I,E)),S=b*(p==0?e==0?.1:1:o),w=zt(Oh(e+S,y/10),24),T=e<=u&&(f==1||f==3&&w>=u||f==2&&w<=u)?u:-Bt,B=zi(l,w>T&&e<=T?T:qn(T,w));return D==B&&D==0&&(B=100),[D,B]}var n1=new Intl.NumberFormat(Oo?KS.language:"en-US"),Md=i=>n1.format(i),hi=Math,Ih=hi.PI,un=hi.abs,ci=hi.floor,hn=hi.round,xi=hi.ceil,zi=hi.min,qn=hi.max,Do=hi.pow,Yg=hi.sign,bs=hi.log10,b0=hi.log2,i1=(i,e=1)=>hi.sinh(i)*e,id=(i,e=1)=>hi.asinh(i/e),Bt=1/0;function $g(i){return(bs((i^i>>31)-(i>>31))|0)+1}function ud(i,e,t){return zi(qn(i,e),t)}function M0(i){return typeof i=="function"}function vt(i){return M0(i)?i:()=>i}var s1=()=>{},w0=i=>i,S0=(i,e)=>e,r1=i=>null,Zg=i=>!0,Kg=(i,e)=>i==e,o1=/\.\d*?(?=9{6,}|0{6,})/gm,Rr=i=>{if(A0(i)||Ys.has(i))return i;let e=`${i}`,t=e.match(o1);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Rr(s)}e${r}`}return zt(i,n)};function Sr(i,e){return Rr(zt(Rr(i/e))*e)}function Oh(i,e){return Rr(xi(Rr(i/e))*e)}function E0(i,e){return Rr(ci(Rr(i/e))*e)}function zt(i,e=0){if(A0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return hn(n)/t}var Ys=new Map;function T0(i){return((""+i).split(".")[1]||"").length}function tl(i,e,t,n){let s=[],r=n.map(T0);for(let o=e;o<t;o++){let a=un(o),l=zt(Do(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:zt(u,h);s.push(f),Ys.set(f,h)}}return s}var el={},wd=[],Uo=[null,null],qs=Array.isArray,A0=Number.isInteger,a1=i=>i===void 0;function Jg(i){return typeof i=="string"}function Bh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function l1(i){return i!=null&&typeof i=="object"}var c1=Object.getPrototypeOf(Uint8Array),R0="__proto__";function No(i,e=Bh){let t;if(qs(i)){let n=i.find(s=>s!=null);if(qs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=No(i[s],e)}else t=i.slice()}else if(i instanceof c1)t=i.slice();else if(e(i)){t={};for(let n in i)n!=R0&&(t[n]=No(i[n],e))}else t=i;return t}function rn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=R0&&(Bh(i[s])?rn(i[s],No(n[s])):i[s]=No(n[s]))}return i}var h1=0,u1=1,f1=2;function d1(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function p1(i,e){if(v1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return _1(o[0])||(o=g1(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:u1,p=[];for(let m=0;m<u.length;m++){let v=u[m],g=r.get(l[m]);v===null?f!=h1&&(h[g]=v,f==f1&&p.push(g)):h[g]=v}d1(h,p,s),n.push(h)}}return n}var m1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function g1(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function v1(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function _1(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=qn(1,ci((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var C0=["January","February","March","April","May","June","July","August","September","October","November","December"],P0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function I0(i){return i.slice(0,3)}var x1=P0.map(I0),y1=C0.map(I0),b1={MMMM:C0,MMM:y1,WWWW:P0,WWW:x1};function Za(i){return(i<10?"0":"")+i}function M1(i){return(i<10?"00":i<100?"0":"")+i}var w1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Za(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Za(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Za(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Za(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Za(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>M1(i.getMilliseconds())};function Sd(i,e){e=e||b1;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?w1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var S1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function E1(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==S1?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var L0=i=>i%1==0,Uh=[1,2,2.5,5],T1=tl(10,-32,0,Uh),D0=tl(10,0,32,Uh),A1=D0.filter(L0),Er=T1.concat(D0),Ed=`
`,U0="{YYYY}",jg=Ed+U0,N0="{M}/{D}",ja=Ed+N0,Ch=ja+"/{YY}",F0="{aa}",R1="{h}:{mm}",Io=R1+F0,Qg=Ed+Io,e0=":{ss}",At=null;function O0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?tl(10,0,3,Uh).filter(L0):tl(10,-3,0,Uh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,U0,At,At,At,At,At,At,1],[s*28,"{MMM}",jg,At,At,At,At,At,1],[s,N0,jg,At,At,At,At,At,1],[n,"{h}"+F0,Ch,At,ja,At,At,At,1],[t,Io,Ch,At,ja,At,At,At,1],[e,e0,Ch+" "+Io,At,ja+" "+Io,At,Qg,At,1],[i,e0+".{fff}",Ch+" "+Io,At,ja+" "+Io,At,Qg,At,1]];function u(h){return(f,p,m,v,g,d)=>{let b=[],M=g>=o,y=g>=r&&g<o,P=h(m),E=zt(P*i,3),I=sd(P.getFullYear(),M?0:P.getMonth(),y||M?1:P.getDate()),D=zt(I*i,3);if(y||M){let S=y?g/r:0,w=M?g/o:0,T=E==D?E:zt(sd(I.getFullYear()+w,I.getMonth()+S,1)*i,3),B=new Date(hn(T/i)),H=B.getFullYear(),V=B.getMonth();for(let W=0;T<=v;W++){let q=sd(H+w*W,V+S*W,1),F=q-h(zt(q*i,3));T=zt((+q+F)*i,3),T<=v&&b.push(T)}}else{let S=g>=s?s:g,w=ci(m)-ci(E),T=D+w+Oh(E-D,S);b.push(T);let B=h(T),H=B.getHours()+B.getMinutes()/t+B.getSeconds()/n,V=g/n,W=f.axes[p]._space,q=d/W;for(;T=zt(T+g,i==1?0:3),!(T>v);)if(V>1){let F=ci(zt(H+V,6))%24,ne=h(T).getHours()-F;ne>1&&(ne=-1),T-=ne*n,H=(H+V)%24;let te=b[b.length-1];zt((T-te)/g,3)*q>=.7&&b.push(T)}else b.push(T)}return b}}return[l,c,u]}var[C1,P1,I1]=O0(1),[L1,D1,U1]=O0(.001);tl(2,-53,53,[1]);function t0(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function n0(i,e){return(t,n,s,r,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,f,p;return n.map(m=>{let v=i(m),g=v.getFullYear(),d=v.getMonth(),b=v.getDate(),M=v.getHours(),y=v.getMinutes(),P=v.getSeconds(),E=g!=l&&a[2]||d!=c&&a[3]||b!=u&&a[4]||M!=h&&a[5]||y!=f&&a[6]||P!=p&&a[7]||a[1];return l=g,c=d,u=b,h=M,f=y,p=P,E(v)})}}function N1(i,e){let t=Sd(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function sd(i,e,t){return new Date(i,e,t)}function i0(i,e){return e(i)}var F1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function s0(i,e){return(t,n,s,r)=>r==null?_d:e(i(n))}function O1(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function B1(i,e){return i.series[e].fill(i,e)}var z1={show:!0,live:!0,isolate:!1,mount:s1,markers:{show:!0,width:2,stroke:O1,fill:B1,dash:"solid"},idx:null,idxs:null,values:[]};function k1(i,e){let t=i.cursor.points,n=_i(),s=t.size(i,e);Yt(n,Ka,s),Yt(n,Ja,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Yt(n,"borderWidth",o),n}function H1(i,e){let t=i.series[e].points;return t._fill||t._stroke}function V1(i,e){let t=i.series[e].points;return t._stroke||t._fill}function G1(i,e){return i.series[e].points.size}var rd=[0,0];function W1(i,e,t){return rd[0]=e,rd[1]=t,rd}function Ph(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function od(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var X1={show:!0,x:!0,y:!0,lock:!1,move:W1,points:{one:!1,show:k1,size:G1,width:0,stroke:V1,fill:H1},bind:{mousedown:Ph,mouseup:Ph,click:Ph,dblclick:Ph,mousemove:od,mouseleave:od,mouseenter:od},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},B0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Td=rn({},B0,{filter:S0}),z0=rn({},Td,{size:10}),k0=rn({},B0,{show:!1}),Ad='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',H0="bold "+Ad,V0=1.5,r0={show:!0,scale:"x",stroke:vd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:H0,side:2,grid:Td,ticks:z0,border:k0,font:Ad,lineGap:V0,rotate:0},q1="Value",Y1="Time",o0={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function $1(i,e,t,n,s){return e.map(r=>r==null?"":Md(r))}function Z1(i,e,t,n,s,r,o){let a=[],l=Ys.get(s)||0;t=o?t:zt(Oh(t,s),l);for(let c=t;c<=n;c=zt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function fd(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?bs:b0,u=ci(c(t));s=Do(l,u),l==10&&(s=Er[Bi(s,Er)]);let h=t,f=s*l;l==10&&(f=Er[Bi(f,Er)]);do a.push(h),h=h+s,l==10&&!Ys.has(h)&&(h=zt(h,Ys.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Er[Bi(f,Er)]));while(h<=n);return a}function K1(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?fd(i,e,qn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?fd(i,e,qn(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var G0=/./,J1=/[12357]/,j1=/[125]/,a0=/1/,dd=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Q1(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?G0:l(7,o)-u>=c?J1:l(5,o)-u>=c?j1:a0;if(h==a0){let f=un(l(1,o)-u);if(f<c)return dd(e.slice().reverse(),a.distr,h,xi(c/f)).reverse()}return dd(e,a.distr,h,1)}function eE(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=un(l(1,o)-l(2,o));return c<a?dd(e.slice().reverse(),3,G0,xi(a/c)).reverse():e}function tE(i,e,t,n){return n==null?_d:e==null?"":Md(e)}var l0={show:!0,scale:"y",stroke:vd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:H0,side:3,grid:Td,ticks:z0,border:k0,font:Ad,lineGap:V0,rotate:0};function nE(i,e){let t=3+(i||1)*2;return zt(t*e,3)}function iE(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=un(o-r),l=i.series[e],c=a/(l.points.space*Et);return n[1]-n[0]<=c}var c0={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},W0=(i,e,t,n,s)=>s,h0={show:!0,auto:!0,sorted:0,gaps:W0,alpha:1,facets:[rn({},c0,{scale:"x"}),rn({},c0,{scale:"y"})]},u0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:W0,alpha:1,points:{show:iE,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function sE(i,e,t,n,s){return t/10}var X0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},rE=rn({},X0,{time:!1,ori:1}),f0={};function q0(i,e){let t=f0[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(f0[i]=t)),t}var Fo=1,pd=2;function Cr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,m=a.width,v=a.height,g=i.valToPosH,d=i.valToPosV;return u.ori==0?t(s,l,c,u,h,g,d,f,p,m,v,kh,Bo,Vh,$0,K0):t(s,l,c,u,h,d,g,p,f,v,m,Hh,zo,Pd,Z0,J0)}function Rd(i,e){let t=0,n=0,s=Mt(i.bands,wd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function oE(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(i,e,t,n,s,r){return Cr(i,e,(o,a,l,c,u,h,f,p,m,v,g)=>{let d=o.pxRound,b=c.dir*(c.ori==0?1:-1),M=c.ori==0?Bo:zo,y,P;b==1?(y=t,P=n):(y=n,P=t);let E=d(h(a[y],c,v,p)),I=d(f(l[y],u,g,m)),D=d(h(a[P],c,v,p)),S=d(f(r==1?u.max:u.min,u,g,m)),w=new Path2D(s);return M(w,D,S),M(w,E,S),M(w,E,I),w})}function zh(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Vh:Pd,l=t;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,n,p,n+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function aE(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Cd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=r(i[h]),m=f==h?p:r(i[f]),v=h-s;p=o<=0&&v>=0&&v<l?r(i[v]):p;let d=f+s;m=o>=0&&d>=0&&d<l?r(i[d]):m,m>=p&&a.push([p,m])}return a}function d0(i){return i==0?w0:i==1?hn:e=>Sr(e,i)}function Y0(i){let e=i==0?kh:Hh,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=zi(c,a/2,l/2),u=zi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var kh=(i,e,t)=>{i.moveTo(e,t)},Hh=(i,e,t)=>{i.moveTo(t,e)},Bo=(i,e,t)=>{i.lineTo(e,t)},zo=(i,e,t)=>{i.lineTo(t,e)},Vh=Y0(0),Pd=Y0(1),$0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Z0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},K0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},J0=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function j0(i){return(e,t,n,s,r)=>Cr(e,t,(o,a,l,c,u,h,f,p,m,v,g)=>{let{pxRound:d,points:b}=o,M,y;c.ori==0?(M=kh,y=$0):(M=Hh,y=Z0);let P=zt(b.width*Et,3),E=(b.size-b.width)/2*Et,I=zt(E*2,3),D=new Path2D,S=new Path2D,{left:w,top:T,width:B,height:H}=e.bbox;Vh(S,w-I,T-I,B+I*2,H+I*2);let V=W=>{if(l[W]!=null){let q=d(h(a[W],c,v,p)),F=d(f(l[W],u,g,m));M(D,q+E,F),y(D,q,F,E,0,Ih*2)}};if(r)r.forEach(V);else for(let W=n;W<=s;W++)V(W);return{stroke:P>0?D:null,fill:D,clip:S,flags:Fo|pd}})}function Q0(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var lE=Q0(Bo),cE=Q0(zo);function ev(i){let e=Mt(i?.alignGaps,0);return(t,n,s,r)=>Cr(t,n,(o,a,l,c,u,h,f,p,m,v,g)=>{[s,r]=Nh(l,s,r);let d=o.pxRound,b=H=>d(h(H,c,v,p)),M=H=>d(f(H,u,g,m)),y,P;c.ori==0?(y=Bo,P=lE):(y=zo,P=cE);let E=c.dir*(c.ori==0?1:-1),I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},D=I.stroke,S=!1;if(r-s>=v*4){let H=fe=>t.posToVal(fe,c.key,!0),V=null,W=null,q,F,z,J=b(a[E==1?s:r]),ne=b(a[s]),te=b(a[r]),ce=H(E==1?ne+1:te-1);for(let fe=E==1?s:r;fe>=s&&fe<=r;fe+=E){let xe=a[fe],Q=(E==1?xe<ce:xe>ce)?J:b(xe),X=l[fe];Q==J?X!=null?(F=X,V==null?(y(D,Q,M(F)),q=V=W=F):F<V?V=F:F>W&&(W=F)):X===null&&(S=!0):(V!=null&&P(D,J,M(V),M(W),M(q),M(F)),X!=null?(F=X,y(D,Q,M(F)),V=W=q=F):(V=W=null,X===null&&(S=!0)),J=Q,ce=H(J+E))}V!=null&&V!=W&&z!=J&&P(D,J,M(V),M(W),M(q),M(F))}else for(let H=E==1?s:r;H>=s&&H<=r;H+=E){let V=l[H];V===null?S=!0:V!=null&&y(D,b(a[H]),M(V))}let[T,B]=Rd(t,n);if(o.fill!=null||T!=0){let H=I.fill=new Path2D(D),V=o.fillTo(t,n,o.min,o.max,T),W=M(V),q=b(a[s]),F=b(a[r]);E==-1&&([F,q]=[q,F]),y(H,F,W),y(H,q,W)}if(!o.spanGaps){let H=[];S&&H.push(...Cd(a,l,s,r,E,b,e)),I.gaps=H=o.gaps(t,n,s,r,H),I.clip=zh(H,c.ori,p,m,v,g)}return B!=0&&(I.band=B==2?[Ms(t,n,s,r,D,-1),Ms(t,n,s,r,D,1)]:Ms(t,n,s,r,D,B)),I})}function hE(i){let e=Mt(i.align,1),t=Mt(i.ascDesc,!1),n=Mt(i.alignGaps,0),s=Mt(i.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,u,h,f,p,m,v,g,d,b,M)=>{[a,l]=Nh(h,a,l);let y=c.pxRound,{left:P,width:E}=r.bbox,I=ne=>y(m(ne,f,b,g)),D=ne=>y(v(ne,p,M,d)),S=f.ori==0?Bo:zo,w={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},T=w.stroke,B=f.dir*(f.ori==0?1:-1),H=D(h[B==1?a:l]),V=I(u[B==1?a:l]),W=V,q=V;s&&e==-1&&(q=P,S(T,q,H)),S(T,V,H);for(let ne=B==1?a:l;ne>=a&&ne<=l;ne+=B){let te=h[ne];if(te==null)continue;let ce=I(u[ne]),fe=D(te);e==1?S(T,ce,H):S(T,W,fe),S(T,ce,fe),H=fe,W=ce}let F=W;s&&e==1&&(F=P+E,S(T,F,H));let[z,J]=Rd(r,o);if(c.fill!=null||z!=0){let ne=w.fill=new Path2D(T),te=c.fillTo(r,o,c.min,c.max,z),ce=D(te);S(ne,F,ce),S(ne,q,ce)}if(!c.spanGaps){let ne=[];ne.push(...Cd(u,h,a,l,B,I,n));let te=c.width*Et/2,ce=t||e==1?te:-te,fe=t||e==-1?-te:te;ne.forEach(xe=>{xe[0]+=ce,xe[1]+=fe}),w.gaps=ne=c.gaps(r,o,a,l,ne),w.clip=zh(ne,f.ori,g,d,b,M)}return J!=0&&(w.band=J==2?[Ms(r,o,a,l,T,-1),Ms(r,o,a,l,T,1)]:Ms(r,o,a,l,T,J)),w})}function p0(i,e,t,n,s,r,o=Bt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=un(i[l]-i[a]);u<c&&(c=u,o=un(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function uE(i){i=i||el;let e=Mt(i.size,[.6,Bt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=Mt(e[1],Bt),l=Mt(e[2],1),c=Mt(i.disp,el),u=Mt(i.each,p=>{}),{fill:h,stroke:f}=c;return(p,m,v,g)=>Cr(p,m,(d,b,M,y,P,E,I,D,S,w,T)=>{let B=d.pxRound,H=t,V=n*Et,W=a*Et,q=l*Et,F,z;y.ori==0?[F,z]=r(p,m):[z,F]=r(p,m);let J=y.dir*(y.ori==0?1:-1),ne=y.ori==0?Vh:Pd,te=y.ori==0?u:(N,Y,le,oe,Ue,_e,Fe)=>{u(N,Y,le,Ue,oe,Fe,_e)},ce=Mt(p.bands,wd).find(N=>N.series[0]==m),fe=ce!=null?ce.dir:0,xe=d.fillTo(p,m,d.min,d.max,fe),Ie=B(I(xe,P,T,S)),Q,X,me,ve=w,ye=B(d.width*Et),Ge=!1,dt=null,k=null,ht=null,se=null;h!=null&&(ye==0||f!=null)&&(Ge=!0,dt=h.values(p,m,v,g),k=new Map,new Set(dt).forEach(N=>{N!=null&&k.set(N,new Path2D)}),ye>0&&(ht=f.values(p,m,v,g),se=new Map,new Set(ht).forEach(N=>{N!=null&&se.set(N,new Path2D)})));let{x0:Me,size:Ce}=c;if(Me!=null&&Ce!=null){H=1,b=Me.values(p,m,v,g),Me.unit==2&&(b=b.map(le=>p.posToVal(D+le*w,y.key,!0)));let N=Ce.values(p,m,v,g);Ce.unit==2?X=N[0]*w:X=E(N[0],y,w,D)-E(0,y,w,D),ve=p0(b,M,E,y,w,D,ve),me=ve-X+V}else ve=p0(b,M,E,y,w,D,ve),me=ve*o+V,X=ve-me;me<1&&(me=0),ye>=X/2&&(ye=0),me<5&&(B=w0);let ot=me>0,re=ve-me-(ot?ye:0);X=B(ud(re,q,W)),Q=(H==0?X/2:H==J?0:X)-H*J*((H==0?V/2:0)+(ot?ye/2:0));let ee={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},ue=Ge?null:new Path2D,we=null;if(ce!=null)we=p.data[ce.series[1]];else{let{y0:N,y1:Y}=c;N!=null&&Y!=null&&(M=Y.values(p,m,v,g),we=N.values(p,m,v,g))}let C=F*X,x=z*X;for(let N=J==1?v:g;N>=v&&N<=g;N+=J){let Y=M[N];if(Y==null)continue;if(we!=null){let Re=we[N]??0;if(Y-Re==0)continue;Ie=I(Re,P,T,S)}let le=y.distr!=2||c!=null?b[N]:N,oe=E(le,y,w,D),Ue=I(Mt(Y,xe),P,T,S),_e=B(oe-Q),Fe=B(qn(Ue,Ie)),Be=B(zi(Ue,Ie)),ge=Fe-Be;if(Y!=null){let Re=Y<0?x:C,qe=Y<0?C:x;Ge?(ye>0&&ht[N]!=null&&ne(se.get(ht[N]),_e,Be+ci(ye/2),X,qn(0,ge-ye),Re,qe),dt[N]!=null&&ne(k.get(dt[N]),_e,Be+ci(ye/2),X,qn(0,ge-ye),Re,qe)):ne(ue,_e,Be+ci(ye/2),X,qn(0,ge-ye),Re,qe),te(p,m,N,_e-ye/2,Be,X+ye,ge)}}return ye>0?ee.stroke=Ge?se:ue:Ge||(ee._fill=d.width==0?d._fill:d._stroke??d._fill,ee.width=0),ee.fill=Ge?k:ue,ee})}function fE(i,e){let t=Mt(e?.alignGaps,0);return(n,s,r,o)=>Cr(n,s,(a,l,c,u,h,f,p,m,v,g,d)=>{[r,o]=Nh(c,r,o);let b=a.pxRound,M=F=>b(f(F,u,g,m)),y=F=>b(p(F,h,d,v)),P,E,I;u.ori==0?(P=kh,I=Bo,E=K0):(P=Hh,I=zo,E=J0);let D=u.dir*(u.ori==0?1:-1),S=M(l[D==1?r:o]),w=S,T=[],B=[];for(let F=D==1?r:o;F>=r&&F<=o;F+=D)if(c[F]!=null){let J=l[F],ne=M(J);T.push(w=ne),B.push(y(c[F]))}let H={stroke:i(T,B,P,I,E,b),fill:null,clip:null,band:null,gaps:null,flags:Fo},V=H.stroke,[W,q]=Rd(n,s);if(a.fill!=null||W!=0){let F=H.fill=new Path2D(V),z=a.fillTo(n,s,a.min,a.max,W),J=y(z);I(F,w,J),I(F,S,J)}if(!a.spanGaps){let F=[];F.push(...Cd(l,c,r,o,D,M,t)),H.gaps=F=a.gaps(n,s,r,o,F),H.clip=zh(F,u.ori,m,v,g,d)}return q!=0&&(H.band=q==2?[Ms(n,s,r,o,V,-1),Ms(n,s,r,o,V,1)]:Ms(n,s,r,o,V,q)),H})}function dE(i){return fE(pE,i)}function pE(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,e[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,i[f+1],e[f+1])}return a}var md=new Set;function m0(){for(let i of md)i.syncRect(!0)}Oo&&(Ar($S,Lo,m0),Ar(ZS,Lo,m0,!0),Ar(Lh,Lo,()=>{Kt.pxRatio=Et}));var mE=ev(),gE=j0();function g0(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>gd(r,o,e,t))}function vE(i,e){return i.map((t,n)=>n==0?{}:rn({},e,t))}function gd(i,e,t,n){return rn({},e==0?t:n,i)}function tv(i,e,t){return e==null?Uo:[e,t]}var _E=tv;function xE(i,e,t){return e==null?Uo:Dh(e,t,bd,!0)}function nv(i,e,t,n){return e==null?Uo:Fh(e,t,i.scales[n].log,!1)}var yE=nv;function iv(i,e,t,n){return e==null?Uo:yd(e,t,i.scales[n].log,!1)}var bE=iv;function ME(i,e,t,n,s){let r=qn($g(i),$g(e)),o=e-i,a=Bi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ys.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function v0(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=hn((t=+s)*Et))+"px"),[i,e,t]}function wE(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=zt(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Kt(i,e,t){let n={mode:Mt(i.mode,1)},s=n.mode;function r(_,A,U,O){let Z=A.valToPct(_);return O+U*(A.dir==-1?1-Z:Z)}function o(_,A,U,O){let Z=A.valToPct(_);return O+U*(A.dir==-1?Z:1-Z)}function a(_,A,U,O){return A.ori==0?r(_,A,U,O):o(_,A,U,O)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=_i(PS);if(i.id!=null&&(c.id=i.id),li(c,i.class),i.title){let _=_i(DS,c);_.textContent=i.title}let u=Oi("canvas"),h=n.ctx=u.getContext("2d"),f=_i(US,c);Ar("click",f,_=>{_.target===m&&(Gt!=Nr||$t!=Fr)&&Mn.click(n,_)},!0);let p=n.under=_i(NS,f);f.appendChild(u);let m=n.over=_i(FS,f);i=No(i);let v=+Mt(i.pxAlign,1),g=d0(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let d=i.ms||.001,b=n.series=s==1?g0(i.series||[],o0,u0,!1):vE(i.series||[null],h0),M=n.axes=g0(i.axes||[],r0,l0,!0),y=n.scales={},P=n.bands=i.bands||[];P.forEach(_=>{_.fill=vt(_.fill||null),_.dir=Mt(_.dir,-1)});let E=s==2?b[1].facets[0].scale:b[0].scale,I={axes:n_,series:Js},D=(i.drawOrder||["axes","series"]).map(_=>I[_]);function S(_){let A=_.distr==3?U=>bs(U>0?U:_.clamp(n,U,_.min,_.max,_.key)):_.distr==4?U=>id(U,_.asinh):_.distr==100?U=>_.fwd(U):U=>U;return U=>{let O=A(U),{_min:Z,_max:ie}=_,de=ie-Z;return(O-Z)/de}}function w(_){let A=y[_];if(A==null){let U=(i.scales||el)[_]||el;if(U.from!=null){w(U.from);let O=rn({},y[U.from],U,{key:_});O.valToPct=S(O),y[_]=O}else{A=y[_]=rn({},_==E?X0:rE,U),A.key=_;let O=A.time,Z=A.range,ie=qs(Z);if((_!=E||s==2&&!O)&&(ie&&(Z[0]==null||Z[1]==null)&&(Z={min:Z[0]==null?Xg:{mode:1,hard:Z[0],soft:Z[0]},max:Z[1]==null?Xg:{mode:1,hard:Z[1],soft:Z[1]}},ie=!1),!ie&&Bh(Z))){let de=Z;Z=(be,Pe,ke)=>Pe==null?Uo:Dh(Pe,ke,de)}A.range=vt(Z||(O?_E:_==E?A.distr==3?yE:A.distr==4?bE:tv:A.distr==3?nv:A.distr==4?iv:xE)),A.auto=vt(ie?!1:A.auto),A.clamp=vt(A.clamp||sE),A._min=A._max=null,A.valToPct=S(A)}}}w("x"),w("y"),s==1&&b.forEach(_=>{w(_.scale)}),M.forEach(_=>{w(_.scale)});for(let _ in i.scales)w(_);let T=y[E],B=T.distr,H,V;T.ori==0?(li(c,IS),H=r,V=o):(li(c,LS),H=o,V=r);let W={};for(let _ in y){let A=y[_];(A.min!=null||A.max!=null)&&(W[_]={min:A.min,max:A.max},A.min=A.max=null)}let q=i.tzDate||(_=>new Date(hn(_/d))),F=i.fmtDate||Sd,z=d==1?I1(q):U1(q),J=n0(q,t0(d==1?P1:D1,F)),ne=s0(q,i0(F1,F)),te=[],ce=n.legend=rn({},z1,i.legend),fe=n.cursor=rn({},X1,{drag:{y:s==2}},i.cursor),xe=ce.show,Ie=fe.show,Q=ce.markers;ce.idxs=te,Q.width=vt(Q.width),Q.dash=vt(Q.dash),Q.stroke=vt(Q.stroke),Q.fill=vt(Q.fill);let X,me,ve,ye=[],Ge=[],dt,k=!1,ht={};if(ce.live){let _=b[1]?b[1].values:null;k=_!=null,dt=k?_(n,1,0):{_:0};for(let A in dt)ht[A]=_d}if(xe)if(X=Oi("table",VS,c),ve=Oi("tbody",null,X),ce.mount(n,X),k){me=Oi("thead",null,X,ve);let _=Oi("tr",null,me);Oi("th",null,_);for(var se in dt)Oi("th",Lg,_).textContent=se}else li(X,WS),ce.live&&li(X,GS);let Me={show:!0},Ce={show:!1};function ot(_,A){if(A==0&&(k||!ce.live||s==2))return Uo;let U=[],O=Oi("tr",XS,ve,ve.childNodes[A]);li(O,_.class),_.show||li(O,Tr);let Z=Oi("th",null,O);if(Q.show){let be=_i(qS,Z);if(A>0){let Pe=Q.width(n,A);Pe&&(be.style.border=Pe+"px "+Q.dash(n,A)+" "+Q.stroke(n,A)),be.style.background=Q.fill(n,A)}}let ie=_i(Lg,Z);_.label instanceof HTMLElement?ie.appendChild(_.label):ie.textContent=_.label,A>0&&(Q.show||(ie.style.color=_.width>0?Q.stroke(n,A):Q.fill(n,A)),ee("click",Z,be=>{if(fe._lock)return;bn(be);let Pe=b.indexOf(_);if((be.ctrlKey||be.metaKey)!=ce.isolate){let ke=b.some((He,Xe)=>Xe>0&&Xe!=Pe&&He.show);b.forEach((He,Xe)=>{Xe>0&&Gi(Xe,ke?Xe==Pe?Me:Ce:Me,!0,tn.setSeries)})}else Gi(Pe,{show:!_.show},!0,tn.setSeries)},!1),Yn&&ee(Fg,Z,be=>{fe._lock||(bn(be),Gi(b.indexOf(_),Br,!0,tn.setSeries))},!1));for(var de in dt){let be=Oi("td",YS,O);be.textContent="--",U.push(be)}return[O,U]}let re=new Map;function ee(_,A,U,O=!0){let Z=re.get(A)||{},ie=fe.bind[_](n,A,U,O);ie&&(Ar(_,A,Z[_]=ie),re.set(A,Z))}function ue(_,A,U){let O=re.get(A)||{};for(let Z in O)(_==null||Z==_)&&(hd(Z,A,O[Z]),delete O[Z]);_==null&&re.delete(A)}let we=0,C=0,x=0,N=0,Y=0,le=0,oe=Y,Ue=le,_e=x,Fe=N,Be=0,ge=0,Re=0,qe=0;n.bbox={};let Ye=!1,Le=!1,Ze=!1,$=!1,Ee=!1,Ae=!1;function Ve(_,A,U){(U||_!=n.width||A!=n.height)&&Se(_,A),Ir(!1),Ze=!0,Le=!0,Lr()}function Se(_,A){n.width=we=x=_,n.height=C=N=A,Y=le=0,Lt(),xt();let U=n.bbox;Be=U.left=Sr(Y*Et,.5),ge=U.top=Sr(le*Et,.5),Re=U.width=Sr(x*Et,.5),qe=U.height=Sr(N*Et,.5)}let pe=3;function $e(){let _=!1,A=0;for(;!_;){A++;let U=e_(A),O=t_(A);_=A==pe||U&&O,_||(Se(n.width,n.height),Le=!0)}}function st({width:_,height:A}){Ve(_,A)}n.setSize=st;function Lt(){let _=!1,A=!1,U=!1,O=!1;M.forEach((Z,ie)=>{if(Z.show&&Z._show){let{side:de,_size:be}=Z,Pe=de%2,ke=Z.label!=null?Z.labelSize:0,He=be+ke;He>0&&(Pe?(x-=He,de==3?(Y+=He,O=!0):U=!0):(N-=He,de==0?(le+=He,_=!0):A=!0))}}),os[0]=_,os[1]=U,os[2]=A,os[3]=O,x-=Vi[1]+Vi[3],Y+=Vi[3],N-=Vi[2]+Vi[0],le+=Vi[0]}function xt(){let _=Y+x,A=le+N,U=Y,O=le;function Z(ie,de){switch(ie){case 1:return _+=de,_-de;case 2:return A+=de,A-de;case 3:return U-=de,U+de;case 0:return O-=de,O+de}}M.forEach((ie,de)=>{if(ie.show&&ie._show){let be=ie.side;ie._pos=Z(be,ie._size),ie.label!=null&&(ie._lpos=Z(be,ie.labelSize))}})}if(fe.dataIdx==null){let _=fe.hover,A=_.skip=new Set(_.skip??[]);A.add(void 0);let U=_.prox=vt(_.prox),O=_.bias??(_.bias=0);fe.dataIdx=(Z,ie,de,be)=>{if(ie==0)return de;let Pe=de,ke=U(Z,ie,de,be)??Bt,He=ke>=0&&ke<Bt,Xe=T.ori==0?x:N,rt=fe.left,wt=e[0],bt=e[ie];if(A.has(bt[de])){Pe=null;let pt=null,nt=null,Je;if(O==0||O==-1)for(Je=de;pt==null&&Je-- >0;)A.has(bt[Je])||(pt=Je);if(O==0||O==1)for(Je=de;nt==null&&Je++<bt.length;)A.has(bt[Je])||(nt=Je);if(pt!=null||nt!=null)if(He){let Xt=pt==null?-1/0:H(wt[pt],T,Xe,0),jt=nt==null?1/0:H(wt[nt],T,Xe,0),_n=rt-Xt,Dt=jt-rt;_n<=Dt?_n<=ke&&(Pe=pt):Dt<=ke&&(Pe=nt)}else Pe=nt==null?pt:pt==null?nt:de-pt<=nt-de?pt:nt}else He&&un(rt-H(wt[de],T,Xe,0))>ke&&(Pe=null);return Pe}}let bn=_=>{fe.event=_};fe.idxs=te,fe._lock=!1;let Ft=fe.points;Ft.show=vt(Ft.show),Ft.size=vt(Ft.size),Ft.stroke=vt(Ft.stroke),Ft.width=vt(Ft.width),Ft.fill=vt(Ft.fill);let ei=n.focus=rn({},i.focus||{alpha:.3},fe.focus),Yn=ei.prox>=0,Hi=Yn&&Ft.one,Un=[],rs=[],yi=[];function Go(_,A){let U=Ft.show(n,A);if(U instanceof HTMLElement)return li(U,HS),li(U,_.class),ts(U,-10,-10,x,N),m.insertBefore(U,Un[A]),U}function Zs(_,A){if(s==1||A>0){let U=s==1&&y[_.scale].time,O=_.value;_.value=U?Jg(O)?s0(q,i0(O,F)):O||ne:O||tE,_.label=_.label||(U?Y1:q1)}if(Hi||A>0){_.width=_.width==null?1:_.width,_.paths=_.paths||mE||r1,_.fillTo=vt(_.fillTo||oE),_.pxAlign=+Mt(_.pxAlign,v),_.pxRound=d0(_.pxAlign),_.stroke=vt(_.stroke||null),_.fill=vt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let U=nE(qn(1,_.width),1),O=_.points=rn({},{size:U,width:qn(1,U*.2),stroke:_.stroke,space:U*2,paths:gE,_stroke:null,_fill:null},_.points);O.show=vt(O.show),O.filter=vt(O.filter),O.fill=vt(O.fill),O.stroke=vt(O.stroke),O.paths=vt(O.paths),O.pxAlign=_.pxAlign}if(xe){let U=ot(_,A);ye.splice(A,0,U[0]),Ge.splice(A,0,U[1]),ce.values.push(null)}if(Ie){te.splice(A,0,null);let U=null;Hi?A==0&&(U=Go(_,A)):A>0&&(U=Go(_,A)),Un.splice(A,0,U),rs.splice(A,0,0),yi.splice(A,0,0)}vn("addSeries",A)}function cl(_,A){A=A??b.length,_=s==1?gd(_,A,o0,u0):gd(_,A,{},h0),b.splice(A,0,_),Zs(b[A],A)}n.addSeries=cl;function hl(_){if(b.splice(_,1),xe){ce.values.splice(_,1),Ge.splice(_,1);let A=ye.splice(_,1)[0];ue(null,A.firstChild),A.remove()}Ie&&(te.splice(_,1),Un.splice(_,1)[0].remove(),rs.splice(_,1),yi.splice(_,1)),vn("delSeries",_)}n.delSeries=hl;let os=[!1,!1,!1,!1];function ru(_,A){if(_._show=_.show,_.show){let U=_.side%2,O=y[_.scale];O==null&&(_.scale=U?b[1].scale:E,O=y[_.scale]);let Z=O.time;_.size=vt(_.size),_.space=vt(_.space),_.rotate=vt(_.rotate),qs(_.incrs)&&_.incrs.forEach(de=>{!Ys.has(de)&&Ys.set(de,T0(de))}),_.incrs=vt(_.incrs||(O.distr==2?A1:Z?d==1?C1:L1:Er)),_.splits=vt(_.splits||(Z&&O.distr==1?z:O.distr==3?fd:O.distr==4?K1:Z1)),_.stroke=vt(_.stroke),_.grid.stroke=vt(_.grid.stroke),_.ticks.stroke=vt(_.ticks.stroke),_.border.stroke=vt(_.border.stroke);let ie=_.values;_.values=qs(ie)&&!qs(ie[0])?vt(ie):Z?qs(ie)?n0(q,t0(ie,F)):Jg(ie)?N1(q,ie):ie||J:ie||$1,_.filter=vt(_.filter||(O.distr>=3&&O.log==10?Q1:O.distr==3&&O.log==2?eE:S0)),_.font=v0(_.font),_.labelFont=v0(_.labelFont),_._size=_.size(n,null,A,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(os[A]=!0,_._el=_i(OS,f))}}function Ks(_,A,U,O){let[Z,ie,de,be]=U,Pe=A%2,ke=0;return Pe==0&&(be||ie)&&(ke=A==0&&!Z||A==2&&!de?hn(r0.size/3):0),Pe==1&&(Z||de)&&(ke=A==1&&!ie||A==3&&!be?hn(l0.size/2):0),ke}let ul=n.padding=(i.padding||[Ks,Ks,Ks,Ks]).map(_=>vt(Mt(_,Ks))),Vi=n._padding=ul.map((_,A)=>_(n,A,os,0)),on,R=null,K=null,he=s==1?b[0].idxs:null,ae=null,j=!1;function Te(_,A){if(e=_??[],n.data=n._data=e,s==2){on=0;for(let U=1;U<b.length;U++)on+=e[U][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ae=e[0],on=ae.length;let U=e;if(B==2){U=e.slice();let O=U[0]=Array(on);for(let Z=0;Z<on;Z++)O[Z]=Z}n._data=e=U}if(Ir(!0),vn("setData"),B==2&&(Ze=!0),A!==!1){let U=T;U.auto(n,j)?Ne():Ts(E,U.min,U.max),$=$||fe.left>=0,Ae=!0,Lr()}}n.setData=Te;function Ne(){j=!0;let _,A;s==1&&(on>0?(R=he[0]=0,K=he[1]=on-1,_=e[0][R],A=e[0][K],B==2?(_=R,A=K):_==A&&(B==3?[_,A]=Fh(_,_,T.log,!1):B==4?[_,A]=yd(_,_,T.log,!1):T.time?A=_+hn(86400/d):[_,A]=Dh(_,A,bd,!0))):(R=he[0]=_=null,K=he[1]=A=null)),Ts(E,_,A)}let We,ze,Qe,tt,Ke,ut,yt,kt,Rt,lt;function je(_,A,U,O,Z,ie){_??(_=Ug),U??(U=wd),O??(O="butt"),Z??(Z=Ug),ie??(ie="round"),_!=We&&(h.strokeStyle=We=_),Z!=ze&&(h.fillStyle=ze=Z),A!=Qe&&(h.lineWidth=Qe=A),ie!=Ke&&(h.lineJoin=Ke=ie),O!=ut&&(h.lineCap=ut=O),U!=tt&&h.setLineDash(tt=U)}function Ht(_,A,U,O){A!=ze&&(h.fillStyle=ze=A),_!=yt&&(h.font=yt=_),U!=kt&&(h.textAlign=kt=U),O!=Rt&&(h.textBaseline=Rt=O)}function gt(_,A,U,O,Z=0){if(O.length>0&&_.auto(n,j)&&(A==null||A.min==null)){let ie=Mt(R,0),de=Mt(K,O.length-1),be=U.min==null?QS(O,ie,de,Z,_.distr==3):[U.min,U.max];_.min=zi(_.min,U.min=be[0]),_.max=qn(_.max,U.max=be[1])}}let An={min:null,max:null};function ws(){for(let O in y){let Z=y[O];W[O]==null&&(Z.min==null||W[E]!=null&&Z.auto(n,j))&&(W[O]=An)}for(let O in y){let Z=y[O];W[O]==null&&Z.from!=null&&W[Z.from]!=null&&(W[O]=An)}W[E]!=null&&Ir(!0);let _={};for(let O in W){let Z=W[O];if(Z!=null){let ie=_[O]=No(y[O],l1);if(Z.min!=null)rn(ie,Z);else if(O!=E||s==2)if(on==0&&ie.from==null){let de=ie.range(n,null,null,O);ie.min=de[0],ie.max=de[1]}else ie.min=Bt,ie.max=-Bt}}if(on>0){b.forEach((O,Z)=>{if(s==1){let ie=O.scale,de=W[ie];if(de==null)return;let be=_[ie];if(Z==0){let Pe=be.range(n,be.min,be.max,ie);be.min=Pe[0],be.max=Pe[1],R=Bi(be.min,e[0]),K=Bi(be.max,e[0]),K-R>1&&(e[0][R]<be.min&&R++,e[0][K]>be.max&&K--),O.min=ae[R],O.max=ae[K]}else O.show&&O.auto&&gt(be,de,O,e[Z],O.sorted);O.idxs[0]=R,O.idxs[1]=K}else if(Z>0&&O.show&&O.auto){let[ie,de]=O.facets,be=ie.scale,Pe=de.scale,[ke,He]=e[Z],Xe=_[be],rt=_[Pe];Xe!=null&&gt(Xe,W[be],ie,ke,ie.sorted),rt!=null&&gt(rt,W[Pe],de,He,de.sorted),O.min=de.min,O.max=de.max}});for(let O in _){let Z=_[O],ie=W[O];if(Z.from==null&&(ie==null||ie.min==null)){let de=Z.range(n,Z.min==Bt?null:Z.min,Z.max==-Bt?null:Z.max,O);Z.min=de[0],Z.max=de[1]}}}for(let O in _){let Z=_[O];if(Z.from!=null){let ie=_[Z.from];if(ie.min==null)Z.min=Z.max=null;else{let de=Z.range(n,ie.min,ie.max,O);Z.min=de[0],Z.max=de[1]}}}let A={},U=!1;for(let O in _){let Z=_[O],ie=y[O];if(ie.min!=Z.min||ie.max!=Z.max){ie.min=Z.min,ie.max=Z.max;let de=ie.distr;ie._min=de==3?bs(ie.min):de==4?id(ie.min,ie.asinh):de==100?ie.fwd(ie.min):ie.min,ie._max=de==3?bs(ie.max):de==4?id(ie.max,ie.asinh):de==100?ie.fwd(ie.max):ie.max,A[O]=U=!0}}if(U){b.forEach((O,Z)=>{s==2?Z>0&&A.y&&(O._paths=null):A[O.scale]&&(O._paths=null)});for(let O in A)Ze=!0,vn("setScale",O);Ie&&fe.left>=0&&($=Ae=!0)}for(let O in W)W[O]=null}function Nn(_){let A=ud(R-1,0,on-1),U=ud(K+1,0,on-1);for(;_[A]==null&&A>0;)A--;for(;_[U]==null&&U<on-1;)U++;return[A,U]}function Js(){if(on>0){let _=b.some(A=>A._focus)&&lt!=ei.alpha;_&&(h.globalAlpha=lt=ei.alpha),b.forEach((A,U)=>{if(U>0&&A.show&&(Vt(U,!1),Vt(U,!0),A._paths==null)){let O=lt;lt!=A.alpha&&(h.globalAlpha=lt=A.alpha);let Z=s==2?[0,e[U][0].length-1]:Nn(e[U]);A._paths=A.paths(n,U,Z[0],Z[1]),lt!=O&&(h.globalAlpha=lt=O)}}),b.forEach((A,U)=>{if(U>0&&A.show){let O=lt;lt!=A.alpha&&(h.globalAlpha=lt=A.alpha),A._paths!=null&&Fn(U,!1);{let Z=A._paths!=null?A._paths.gaps:null,ie=A.points.show(n,U,R,K,Z),de=A.points.filter(n,U,ie,Z);(ie||de)&&(A.points._paths=A.points.paths(n,U,R,K,de),Fn(U,!0))}lt!=O&&(h.globalAlpha=lt=O),vn("drawSeries",U)}}),_&&(h.globalAlpha=lt=1)}}function Vt(_,A){let U=A?b[_].points:b[_];U._stroke=U.stroke(n,_),U._fill=U.fill(n,_)}function Fn(_,A){let U=A?b[_].points:b[_],{stroke:O,fill:Z,clip:ie,flags:de,_stroke:be=U._stroke,_fill:Pe=U._fill,_width:ke=U.width}=U._paths;ke=zt(ke*Et,3);let He=null,Xe=ke%2/2;A&&Pe==null&&(Pe=ke>0?"#fff":be);let rt=U.pxAlign==1&&Xe>0;if(rt&&h.translate(Xe,Xe),!A){let wt=Be-ke/2,bt=ge-ke/2,pt=Re+ke,nt=qe+ke;He=new Path2D,He.rect(wt,bt,pt,nt)}A?pn(be,ke,U.dash,U.cap,Pe,O,Z,de,ie):$n(_,be,ke,U.dash,U.cap,Pe,O,Z,de,He,ie),rt&&h.translate(-Xe,-Xe)}function $n(_,A,U,O,Z,ie,de,be,Pe,ke,He){let Xe=!1;Pe!=0&&P.forEach((rt,wt)=>{if(rt.series[0]==_){let bt=b[rt.series[1]],pt=e[rt.series[1]],nt=(bt._paths||el).band;qs(nt)&&(nt=rt.dir==1?nt[0]:nt[1]);let Je,Xt=null;bt.show&&nt&&t1(pt,R,K)?(Xt=rt.fill(n,wt)||ie,Je=bt._paths.clip):nt=null,pn(A,U,O,Z,Xt,de,be,Pe,ke,He,Je,nt),Xe=!0}}),Xe||pn(A,U,O,Z,ie,de,be,Pe,ke,He)}let dn=Fo|pd;function pn(_,A,U,O,Z,ie,de,be,Pe,ke,He,Xe){je(_,A,U,O,Z),(Pe||ke||Xe)&&(h.save(),Pe&&h.clip(Pe),ke&&h.clip(ke)),Xe?(be&dn)==dn?(h.clip(Xe),He&&h.clip(He),ui(Z,de),Ss(_,ie,A)):be&pd?(ui(Z,de),h.clip(Xe),Ss(_,ie,A)):be&Fo&&(h.save(),h.clip(Xe),He&&h.clip(He),ui(Z,de),h.restore(),Ss(_,ie,A)):(ui(Z,de),Ss(_,ie,A)),(Pe||ke||Xe)&&h.restore()}function Ss(_,A,U){U>0&&(A instanceof Map?A.forEach((O,Z)=>{h.strokeStyle=We=Z,h.stroke(O)}):A!=null&&_&&h.stroke(A))}function ui(_,A){A instanceof Map?A.forEach((U,O)=>{h.fillStyle=ze=O,h.fill(U)}):A!=null&&_&&h.fill(A)}function Qv(_,A,U,O){let Z=M[_],ie;if(O<=0)ie=[0,0];else{let de=Z._space=Z.space(n,_,A,U,O),be=Z._incrs=Z.incrs(n,_,A,U,O,de);ie=ME(A,U,be,O,de)}return Z._found=ie}function ou(_,A,U,O,Z,ie,de,be,Pe,ke){let He=de%2/2;v==1&&h.translate(He,He),je(be,de,Pe,ke,be),h.beginPath();let Xe,rt,wt,bt,pt=Z+(O==0||O==3?-ie:ie);U==0?(rt=Z,bt=pt):(Xe=Z,wt=pt);for(let nt=0;nt<_.length;nt++)A[nt]!=null&&(U==0?Xe=wt=_[nt]:rt=bt=_[nt],h.moveTo(Xe,rt),h.lineTo(wt,bt));h.stroke(),v==1&&h.translate(-He,-He)}function e_(_){let A=!0;return M.forEach((U,O)=>{if(!U.show)return;let Z=y[U.scale];if(Z.min==null){U._show&&(A=!1,U._show=!1,Ir(!1));return}else U._show||(A=!1,U._show=!0,Ir(!1));let ie=U.side,de=ie%2,{min:be,max:Pe}=Z,[ke,He]=Qv(O,be,Pe,de==0?x:N);if(He==0)return;let Xe=Z.distr==2,rt=U._splits=U.splits(n,O,be,Pe,ke,He,Xe),wt=Z.distr==2?rt.map(Je=>ae[Je]):rt,bt=Z.distr==2?ae[rt[1]]-ae[rt[0]]:ke,pt=U._values=U.values(n,U.filter(n,wt,O,He,bt),O,He,bt);U._rotate=ie==2?U.rotate(n,pt,O,He):0;let nt=U._size;U._size=xi(U.size(n,pt,O,_)),nt!=null&&U._size!=nt&&(A=!1)}),A}function t_(_){let A=!0;return ul.forEach((U,O)=>{let Z=U(n,O,os,_);Z!=Vi[O]&&(A=!1),Vi[O]=Z}),A}function n_(){for(let _=0;_<M.length;_++){let A=M[_];if(!A.show||!A._show)continue;let U=A.side,O=U%2,Z,ie,de=A.stroke(n,_),be=U==0||U==3?-1:1,[Pe,ke]=A._found;if(A.label!=null){let Bn=A.labelGap*be,ii=hn((A._lpos+Bn)*Et);Ht(A.labelFont[0],de,"center",U==2?"top":Dg),h.save(),O==1?(Z=ie=0,h.translate(ii,hn(ge+qe/2)),h.rotate((U==3?-Ih:Ih)/2)):(Z=hn(Be+Re/2),ie=ii);let er=M0(A.label)?A.label(n,_,Pe,ke):A.label;h.fillText(er,Z,ie),h.restore()}if(ke==0)continue;let He=y[A.scale],Xe=O==0?Re:qe,rt=O==0?Be:ge,wt=A._splits,bt=He.distr==2?wt.map(Bn=>ae[Bn]):wt,pt=He.distr==2?ae[wt[1]]-ae[wt[0]]:Pe,nt=A.ticks,Je=A.border,Xt=nt.show?nt.size:0,jt=hn(Xt*Et),_n=hn((A.alignTo==2?A._size-Xt-A.gap:A.gap)*Et),Dt=A._rotate*-Ih/180,Qt=g(A._pos*Et),ti=(jt+_n)*be,On=Qt+ti;ie=O==0?On:0,Z=O==1?On:0;let fi=A.font[0],bi=A.align==1?Po:A.align==2?ed:Dt>0?Po:Dt<0?ed:O==0?"center":U==3?ed:Po,Xi=Dt||O==1?"middle":U==2?"top":Dg;Ht(fi,de,bi,Xi);let ni=A.font[1]*A.lineGap,di=wt.map(Bn=>g(a(Bn,He,Xe,rt))),Mi=A._values;for(let Bn=0;Bn<Mi.length;Bn++){let ii=Mi[Bn];if(ii!=null){O==0?Z=di[Bn]:ie=di[Bn],ii=""+ii;let er=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let zn=0;zn<er.length;zn++){let hp=er[zn];Dt?(h.save(),h.translate(Z,ie+zn*ni),h.rotate(Dt),h.fillText(hp,0,0),h.restore()):h.fillText(hp,Z,ie+zn*ni)}}}nt.show&&ou(di,nt.filter(n,bt,_,ke,pt),O,U,Qt,jt,zt(nt.width*Et,3),nt.stroke(n,_),nt.dash,nt.cap);let qi=A.grid;qi.show&&ou(di,qi.filter(n,bt,_,ke,pt),O,O==0?2:1,O==0?ge:Be,O==0?qe:Re,zt(qi.width*Et,3),qi.stroke(n,_),qi.dash,qi.cap),Je.show&&ou([Qt],[1],O==0?1:0,O==0?1:2,O==1?ge:Be,O==1?qe:Re,zt(Je.width*Et,3),Je.stroke(n,_),Je.dash,Je.cap)}vn("drawAxes")}function Ir(_){b.forEach((A,U)=>{U>0&&(A._paths=null,_&&(s==1?(A.min=null,A.max=null):A.facets.forEach(O=>{O.min=null,O.max=null})))})}let fl=!1,au=!1,Wo=[];function i_(){au=!1;for(let _=0;_<Wo.length;_++)vn(...Wo[_]);Wo.length=0}function Lr(){fl||(m1(qd),fl=!0)}function s_(_,A=!1){fl=!0,au=A,_(n),qd(),A&&Wo.length>0&&queueMicrotask(i_)}n.batch=s_;function qd(){if(Ye&&(ws(),Ye=!1),Ze&&($e(),Ze=!1),Le){if(Yt(p,Po,Y),Yt(p,"top",le),Yt(p,Ka,x),Yt(p,Ja,N),Yt(m,Po,Y),Yt(m,"top",le),Yt(m,Ka,x),Yt(m,Ja,N),Yt(f,Ka,we),Yt(f,Ja,C),u.width=hn(we*Et),u.height=hn(C*Et),M.forEach(({_el:_,_show:A,_size:U,_pos:O,side:Z})=>{if(_!=null)if(A){let ie=Z===3||Z===0?U:0,de=Z%2==1;Yt(_,de?"left":"top",O-ie),Yt(_,de?"width":"height",U),Yt(_,de?"top":"left",de?le:Y),Yt(_,de?"height":"width",de?N:x),cd(_,Tr)}else li(_,Tr)}),We=ze=Qe=Ke=ut=yt=kt=Rt=tt=null,lt=1,Yo(!0),Y!=oe||le!=Ue||x!=_e||N!=Fe){Ir(!1);let _=x/_e,A=N/Fe;if(Ie&&!$&&fe.left>=0){fe.left*=_,fe.top*=A,Dr&&ts(Dr,hn(fe.left),0,x,N),Ur&&ts(Ur,0,hn(fe.top),x,N);for(let U=0;U<Un.length;U++){let O=Un[U];O!=null&&(rs[U]*=_,yi[U]*=A,ts(O,xi(rs[U]),xi(yi[U]),x,N))}}if(Wt.show&&!Ee&&Wt.left>=0&&Wt.width>0){Wt.left*=_,Wt.width*=_,Wt.top*=A,Wt.height*=A;for(let U in du)Yt(Or,U,Wt[U])}oe=Y,Ue=le,_e=x,Fe=N}vn("setSize"),Le=!1}we>0&&C>0&&(h.clearRect(0,0,u.width,u.height),vn("drawClear"),D.forEach(_=>_()),vn("draw")),Wt.show&&Ee&&(dl(Wt),Ee=!1),Ie&&$&&(Qs(null,!0,!1),$=!1),ce.show&&ce.live&&Ae&&(uu(),Ae=!1),l||(l=!0,n.status=1,vn("ready")),j=!1,fl=!1}n.redraw=(_,A)=>{Ze=A||!1,_!==!1?Ts(E,T.min,T.max):Lr()};function lu(_,A){let U=y[_];if(U.from==null){if(on==0){let O=U.range(n,A.min,A.max,_);A.min=O[0],A.max=O[1]}if(A.min>A.max){let O=A.min;A.min=A.max,A.max=O}if(on>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;_==E&&U.distr==2&&on>0&&(A.min=Bi(A.min,e[0]),A.max=Bi(A.max,e[0]),A.min==A.max&&A.max++),W[_]=A,Ye=!0,Lr()}}n.setScale=lu;let cu,hu,Dr,Ur,Yd,$d,Nr,Fr,Zd,Kd,Gt,$t,Es=!1,Mn=fe.drag,mn=Mn.x,gn=Mn.y;Ie&&(fe.x&&(cu=_i(zS,m)),fe.y&&(hu=_i(kS,m)),T.ori==0?(Dr=cu,Ur=hu):(Dr=hu,Ur=cu),Gt=fe.left,$t=fe.top);let Wt=n.select=rn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Or=Wt.show?_i(BS,Wt.over?m:p):null;function dl(_,A){if(Wt.show){for(let U in _)Wt[U]=_[U],U in du&&Yt(Or,U,_[U]);A!==!1&&vn("setSelect")}}n.setSelect=dl;function r_(_){if(b[_].show)xe&&cd(ye[_],Tr);else if(xe&&li(ye[_],Tr),Ie){let U=Hi?Un[0]:Un[_];U!=null&&ts(U,-10,-10,x,N)}}function Ts(_,A,U){lu(_,{min:A,max:U})}function Gi(_,A,U,O){A.focus!=null&&h_(_),A.show!=null&&b.forEach((Z,ie)=>{ie>0&&(_==ie||_==null)&&(Z.show=A.show,r_(ie),s==2?(Ts(Z.facets[0].scale,null,null),Ts(Z.facets[1].scale,null,null)):Ts(Z.scale,null,null),Lr())}),U!==!1&&vn("setSeries",_,A),O&&$o("setSeries",n,_,A)}n.setSeries=Gi;function o_(_,A){rn(P[_],A)}function a_(_,A){_.fill=vt(_.fill||null),_.dir=Mt(_.dir,-1),A=A??P.length,P.splice(A,0,_)}function l_(_){_==null?P.length=0:P.splice(_,1)}n.addBand=a_,n.setBand=o_,n.delBand=l_;function c_(_,A){b[_].alpha=A,Ie&&Un[_]!=null&&(Un[_].style.opacity=A),xe&&ye[_]&&(ye[_].style.opacity=A)}let as,As,js,Br={focus:!0};function h_(_){if(_!=js){let A=_==null,U=ei.alpha!=1;b.forEach((O,Z)=>{if(s==1||Z>0){let ie=A||Z==0||Z==_;O._focus=A?null:ie,U&&c_(Z,ie?1:ei.alpha)}}),js=_,U&&Lr()}}xe&&Yn&&ee(Og,X,_=>{fe._lock||(bn(_),js!=null&&Gi(null,Br,!0,tn.setSeries))});function Wi(_,A,U){let O=y[A];U&&(_=_/Et-(O.ori==1?le:Y));let Z=x;O.ori==1&&(Z=N,_=Z-_),O.dir==-1&&(_=Z-_);let ie=O._min,de=O._max,be=_/Z,Pe=ie+(de-ie)*be,ke=O.distr;return ke==3?Do(10,Pe):ke==4?i1(Pe,O.asinh):ke==100?O.bwd(Pe):Pe}function u_(_,A){let U=Wi(_,E,A);return Bi(U,e[0],R,K)}n.valToIdx=_=>Bi(_,e[0]),n.posToIdx=u_,n.posToVal=Wi,n.valToPos=(_,A,U)=>y[A].ori==0?r(_,y[A],U?Re:x,U?Be:0):o(_,y[A],U?qe:N,U?ge:0),n.setCursor=(_,A,U)=>{Gt=_.left,$t=_.top,Qs(null,A,U)};function Jd(_,A){Yt(Or,Po,Wt.left=_),Yt(Or,Ka,Wt.width=A)}function jd(_,A){Yt(Or,"top",Wt.top=_),Yt(Or,Ja,Wt.height=A)}let Xo=T.ori==0?Jd:jd,qo=T.ori==1?Jd:jd;function f_(){if(xe&&ce.live)for(let _=s==2?1:0;_<b.length;_++){if(_==0&&k)continue;let A=ce.values[_],U=0;for(let O in A)Ge[_][U++].firstChild.nodeValue=A[O]}}function uu(_,A){if(_!=null&&(_.idxs?_.idxs.forEach((U,O)=>{te[O]=U}):a1(_.idx)||te.fill(_.idx),ce.idx=te[0]),xe&&ce.live){for(let U=0;U<b.length;U++)(U>0||s==1&&!k)&&d_(U,te[U]);f_()}Ae=!1,A!==!1&&vn("setLegend")}n.setLegend=uu;function d_(_,A){let U=b[_],O=_==0&&B==2?ae:e[_],Z;k?Z=U.values(n,_,A)??ht:(Z=U.value(n,A==null?null:O[A],_,A),Z=Z==null?ht:{_:Z}),ce.values[_]=Z}function Qs(_,A,U){Zd=Gt,Kd=$t,[Gt,$t]=fe.move(n,Gt,$t),fe.left=Gt,fe.top=$t,Ie&&(Dr&&ts(Dr,hn(Gt),0,x,N),Ur&&ts(Ur,0,hn($t),x,N));let O,Z=R>K;as=Bt,As=null;let ie=T.ori==0?x:N,de=T.ori==1?x:N;if(Gt<0||on==0||Z){O=fe.idx=null;for(let be=0;be<b.length;be++){let Pe=Un[be];Pe!=null&&ts(Pe,-10,-10,x,N)}Yn&&Gi(null,Br,!0,_==null&&tn.setSeries),ce.live&&(te.fill(O),Ae=!0)}else{let be,Pe,ke;s==1&&(be=T.ori==0?Gt:$t,Pe=Wi(be,E),O=fe.idx=Bi(Pe,e[0],R,K),ke=H(e[0][O],T,ie,0));let He=-10,Xe=-10,rt=0,wt=0,bt=!0,pt="",nt="";for(let Je=s==2?1:0;Je<b.length;Je++){let Xt=b[Je],jt=te[Je],_n=jt==null?null:s==1?e[Je][jt]:e[Je][1][jt],Dt=fe.dataIdx(n,Je,O,Pe),Qt=Dt==null?null:s==1?e[Je][Dt]:e[Je][1][Dt];if(Ae=Ae||Qt!=_n||Dt!=jt,te[Je]=Dt,Je>0&&Xt.show){let ti=Dt==null?-10:Dt==O?ke:H(s==1?e[0][Dt]:e[Je][0][Dt],T,ie,0),On=Qt==null?-10:V(Qt,s==1?y[Xt.scale]:y[Xt.facets[1].scale],de,0);if(Yn&&Qt!=null){let fi=T.ori==1?Gt:$t,bi=un(ei.dist(n,Je,Dt,On,fi));if(bi<as){let Xi=ei.bias;if(Xi!=0){let ni=Wi(fi,Xt.scale),di=Qt>=0?1:-1,Mi=ni>=0?1:-1;Mi==di&&(Mi==1?Xi==1?Qt>=ni:Qt<=ni:Xi==1?Qt<=ni:Qt>=ni)&&(as=bi,As=Je)}else as=bi,As=Je}}if(Ae||Hi){let fi,bi;T.ori==0?(fi=ti,bi=On):(fi=On,bi=ti);let Xi,ni,di,Mi,qi,Bn,ii=!0,er=Ft.bbox;if(er!=null){ii=!1;let zn=er(n,Je);di=zn.left,Mi=zn.top,Xi=zn.width,ni=zn.height}else di=fi,Mi=bi,Xi=ni=Ft.size(n,Je);if(Bn=Ft.fill(n,Je),qi=Ft.stroke(n,Je),Hi)Je==As&&as<=ei.prox&&(He=di,Xe=Mi,rt=Xi,wt=ni,bt=ii,pt=Bn,nt=qi);else{let zn=Un[Je];zn!=null&&(rs[Je]=di,yi[Je]=Mi,Wg(zn,Xi,ni,ii),Vg(zn,Bn,qi),ts(zn,xi(di),xi(Mi),x,N))}}}}if(Hi){let Je=ei.prox,Xt=js==null?as<=Je:as>Je||As!=js;if(Ae||Xt){let jt=Un[0];jt!=null&&(rs[0]=He,yi[0]=Xe,Wg(jt,rt,wt,bt),Vg(jt,pt,nt),ts(jt,xi(He),xi(Xe),x,N))}}}if(Wt.show&&Es)if(_!=null){let[be,Pe]=tn.scales,[ke,He]=tn.match,[Xe,rt]=_.cursor.sync.scales,wt=_.cursor.drag;if(mn=wt._x,gn=wt._y,mn||gn){let{left:bt,top:pt,width:nt,height:Je}=_.select,Xt=_.scales[Xe].ori,jt=_.posToVal,_n,Dt,Qt,ti,On,fi=be!=null&&ke(be,Xe),bi=Pe!=null&&He(Pe,rt);fi&&mn?(Xt==0?(_n=bt,Dt=nt):(_n=pt,Dt=Je),Qt=y[be],ti=H(jt(_n,Xe),Qt,ie,0),On=H(jt(_n+Dt,Xe),Qt,ie,0),Xo(zi(ti,On),un(On-ti))):Xo(0,ie),bi&&gn?(Xt==1?(_n=bt,Dt=nt):(_n=pt,Dt=Je),Qt=y[Pe],ti=V(jt(_n,rt),Qt,de,0),On=V(jt(_n+Dt,rt),Qt,de,0),qo(zi(ti,On),un(On-ti))):qo(0,de)}else pu()}else{let be=un(Zd-Yd),Pe=un(Kd-$d);if(T.ori==1){let rt=be;be=Pe,Pe=rt}mn=Mn.x&&be>=Mn.dist,gn=Mn.y&&Pe>=Mn.dist;let ke=Mn.uni;ke!=null?mn&&gn&&(mn=be>=ke,gn=Pe>=ke,!mn&&!gn&&(Pe>be?gn=!0:mn=!0)):Mn.x&&Mn.y&&(mn||gn)&&(mn=gn=!0);let He,Xe;mn&&(T.ori==0?(He=Nr,Xe=Gt):(He=Fr,Xe=$t),Xo(zi(He,Xe),un(Xe-He)),gn||qo(0,de)),gn&&(T.ori==1?(He=Nr,Xe=Gt):(He=Fr,Xe=$t),qo(zi(He,Xe),un(Xe-He)),mn||Xo(0,ie)),!mn&&!gn&&(Xo(0,0),qo(0,0))}if(Mn._x=mn,Mn._y=gn,_==null){if(U){if(cp!=null){let[be,Pe]=tn.scales;tn.values[0]=be!=null?Wi(T.ori==0?Gt:$t,be):null,tn.values[1]=Pe!=null?Wi(T.ori==1?Gt:$t,Pe):null}$o(td,n,Gt,$t,x,N,O)}if(Yn){let be=U&&tn.setSeries,Pe=ei.prox;js==null?as<=Pe&&Gi(As,Br,!0,be):as>Pe?Gi(null,Br,!0,be):As!=js&&Gi(As,Br,!0,be)}}Ae&&(ce.idx=O,uu()),A!==!1&&vn("setCursor")}let Rs=null;Object.defineProperty(n,"rect",{get(){return Rs==null&&Yo(!1),Rs}});function Yo(_=!1){_?Rs=null:(Rs=m.getBoundingClientRect(),vn("syncRect",Rs))}function Qd(_,A,U,O,Z,ie,de){fe._lock||Es&&_!=null&&_.movementX==0&&_.movementY==0||(fu(_,A,U,O,Z,ie,de,!1,_!=null),_!=null?Qs(null,!0,!0):Qs(A,!0,!1))}function fu(_,A,U,O,Z,ie,de,be,Pe){if(Rs==null&&Yo(!1),bn(_),_!=null)U=_.clientX-Rs.left,O=_.clientY-Rs.top;else{if(U<0||O<0){Gt=-10,$t=-10;return}let[ke,He]=tn.scales,Xe=A.cursor.sync,[rt,wt]=Xe.values,[bt,pt]=Xe.scales,[nt,Je]=tn.match,Xt=A.axes[0].side%2==1,jt=T.ori==0?x:N,_n=T.ori==1?x:N,Dt=Xt?ie:Z,Qt=Xt?Z:ie,ti=Xt?O:U,On=Xt?U:O;if(bt!=null?U=nt(ke,bt)?a(rt,y[ke],jt,0):-10:U=jt*(ti/Dt),pt!=null?O=Je(He,pt)?a(wt,y[He],_n,0):-10:O=_n*(On/Qt),T.ori==1){let fi=U;U=O,O=fi}}Pe&&(A==null||A.cursor.event.type==td)&&((U<=1||U>=x-1)&&(U=Sr(U,x)),(O<=1||O>=N-1)&&(O=Sr(O,N))),be?(Yd=U,$d=O,[Nr,Fr]=fe.move(n,U,O)):(Gt=U,$t=O)}let du={width:0,height:0,left:0,top:0};function pu(){dl(du,!1)}let ep,tp,np,ip;function sp(_,A,U,O,Z,ie,de){Es=!0,mn=gn=Mn._x=Mn._y=!1,fu(_,A,U,O,Z,ie,de,!0,!1),_!=null&&(ee(nd,ad,rp,!1),$o(Ng,n,Nr,Fr,x,N,null));let{left:be,top:Pe,width:ke,height:He}=Wt;ep=be,tp=Pe,np=ke,ip=He}function rp(_,A,U,O,Z,ie,de){Es=Mn._x=Mn._y=!1,fu(_,A,U,O,Z,ie,de,!1,!0);let{left:be,top:Pe,width:ke,height:He}=Wt,Xe=ke>0||He>0,rt=ep!=be||tp!=Pe||np!=ke||ip!=He;if(Xe&&rt&&dl(Wt),Mn.setScale&&Xe&&rt){let wt=be,bt=ke,pt=Pe,nt=He;if(T.ori==1&&(wt=Pe,bt=He,pt=be,nt=ke),mn&&Ts(E,Wi(wt,E),Wi(wt+bt,E)),gn)for(let Je in y){let Xt=y[Je];Je!=E&&Xt.from==null&&Xt.min!=Bt&&Ts(Je,Wi(pt+nt,Je),Wi(pt,Je))}pu()}else fe.lock&&(fe._lock=!fe._lock,Qs(A,!0,_!=null));_!=null&&(ue(nd,ad),$o(nd,n,Gt,$t,x,N,null))}function p_(_,A,U,O,Z,ie,de){if(fe._lock)return;bn(_);let be=Es;if(Es){let Pe=!0,ke=!0,He=10,Xe,rt;T.ori==0?(Xe=mn,rt=gn):(Xe=gn,rt=mn),Xe&&rt&&(Pe=Gt<=He||Gt>=x-He,ke=$t<=He||$t>=N-He),Xe&&Pe&&(Gt=Gt<Nr?0:x),rt&&ke&&($t=$t<Fr?0:N),Qs(null,!0,!0),Es=!1}Gt=-10,$t=-10,te.fill(null),Qs(null,!0,!0),be&&(Es=be)}function op(_,A,U,O,Z,ie,de){fe._lock||(bn(_),Ne(),pu(),_!=null&&$o(Bg,n,Gt,$t,x,N,null))}function ap(){M.forEach(wE),Ve(n.width,n.height,!0)}Ar(Lh,Lo,ap);let zr={};zr.mousedown=sp,zr.mousemove=Qd,zr.mouseup=rp,zr.dblclick=op,zr.setSeries=(_,A,U,O)=>{let Z=tn.match[2];U=Z(n,A,U),U!=-1&&Gi(U,O,!0,!1)},Ie&&(ee(Ng,m,sp),ee(td,m,Qd),ee(Fg,m,_=>{bn(_),Yo(!1)}),ee(Og,m,p_),ee(Bg,m,op),md.add(n),n.syncRect=Yo);let pl=n.hooks=i.hooks||{};function vn(_,A,U){au?Wo.push([_,A,U]):_ in pl&&pl[_].forEach(O=>{O.call(null,n,A,U)})}(i.plugins||[]).forEach(_=>{for(let A in _.hooks)pl[A]=(pl[A]||[]).concat(_.hooks[A])});let lp=(_,A,U)=>U,tn=rn({key:null,setSeries:!1,filters:{pub:Zg,sub:Zg},scales:[E,b[1]?b[1].scale:null],match:[Kg,Kg,lp],values:[null,null]},fe.sync);tn.match.length==2&&tn.match.push(lp),fe.sync=tn;let cp=tn.key,mu=q0(cp);function $o(_,A,U,O,Z,ie,de){tn.filters.pub(_,A,U,O,Z,ie,de)&&mu.pub(_,A,U,O,Z,ie,de)}mu.sub(n);function m_(_,A,U,O,Z,ie,de){tn.filters.sub(_,A,U,O,Z,ie,de)&&zr[_](null,A,U,O,Z,ie,de)}n.pub=m_;function g_(){mu.unsub(n),md.delete(n),re.clear(),hd(Lh,Lo,ap),c.remove(),X?.remove(),vn("destroy")}n.destroy=g_;function gu(){vn("init",i,e),Te(e||i.data,!1),W[E]?lu(E,W[E]):Ne(),Ee=Wt.show&&(Wt.width>0||Wt.height>0),$=Ae=!0,Ve(i.width,i.height)}return b.forEach(Zs),M.forEach(ru),t?t instanceof HTMLElement?(t.appendChild(c),gu()):t(n,gu):gu(),n}Kt.assign=rn;Kt.fmtNum=Md;Kt.rangeNum=Dh;Kt.rangeLog=Fh;Kt.rangeAsinh=yd;Kt.orient=Cr;Kt.pxRatio=Et;Kt.join=p1;Kt.fmtDate=Sd,Kt.tzDate=E1;Kt.sync=q0;{Kt.addGap=aE,Kt.clipGaps=zh;let i=Kt.paths={points:j0};i.linear=ev,i.stepped=hE,i.bars=uE,i.spline=dE}var sv=112,SE=18,EE=54,TE=100,Id=[1e-6,1e6],Ld=14,ov=i=>{let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)},AE=.005,RE=5;function CE(i,[e,t]){let n=r=>Math.floor(Math.log10(r||1)),s=Math.max(0,Math.min(Math.round(-Math.log10(AE*(t-e||1))),RE-1-n(Math.max(Math.abs(e),Math.abs(t)))));return s>6||Math.abs(i)>=1e6?i===0?"0":i.toExponential(3):i.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1")}function av(i,{onSeek:e=()=>{},onZoom:t=()=>{},onEdit:n=()=>{},onRemove:s=()=>{}}={}){let r=[],o=[],a=null,l={range:null,heights:{}},c=[],u=0,h=null;i.classList.add("plots");function f(T){a=T&&[...new Map(T.map(B=>[String(B),B])).values()],p(o)}function p(T){o=T,r.forEach(({plot:V})=>V.destroy()),i.replaceChildren();let B=kn(),H=a??tr(o);r=Rp(o,H).map(V=>{let W=G("div",{class:"plot-keys"}),q=V.curves.map(fe=>{let xe=document.createElementNS("http://www.w3.org/2000/svg","svg");xe.setAttribute("viewBox","0 0 22 6"),xe.setAttribute("aria-hidden","true");let Ie=document.createElementNS("http://www.w3.org/2000/svg","line");Object.entries({x1:0,x2:22,y1:3,y2:3,stroke:fe.colour,"stroke-width":2.4,"stroke-dasharray":fe.dash.join(" ")}).forEach(([X,me])=>Ie.setAttribute(X,me)),xe.append(Ie);let Q=G("b");return Q.style.setProperty("--colour",fe.colour),W.append(G("span",{class:"plot-key"},xe,G("span",{},fe.name),Q)),Q}),F=V.unit?`${V.name} [${V.unit}]`:V.name,z=H.findIndex(fe=>V.key===(Array.isArray(fe)?fe.join():fe)),J=(fe,xe,Ie)=>G("button",{type:"button",class:"small",title:xe,"aria-label":`${xe}: ${F}`,onclick:Ie},fe),ne=G("span",{class:"plot-tools"},...V.own?[J("edit","Change the signals",()=>n(z))]:[],J("×","Remove this plot",()=>s(z))),te=G("div",{class:"plot-canvas"});i.append(G("section",{class:"plot"},G("header",{},G("h3",{},F),ne,W),te));let ce={panel:V,values:q,canvas:te,marker:G("div",{class:"plot-now"}),cross:G("div",{class:"plot-under",hidden:!0}),flag:G("div",{class:"plot-flag",hidden:!0})};return ce.plot=m(ce,B),ce.plot.over.append(ce.marker,ce.cross,ce.flag),ce}),M()}function m({panel:T,canvas:B},H){let V=new Map;for(let X of T.curves){let me=V.get(X.t)??{times:Array.from(X.t,ve=>ve+X.flight.shift),curves:[]};V.set(X.t,{...me,curves:[...me.curves,X]})}let W=[...V.values()],q=W.map(({times:X,curves:me})=>[X,...me.map(ve=>Array.from(ve.values))]),F=q.length===1?q[0]:Kt.join(q),z=W.flatMap(({curves:X})=>X),J={stroke:H.faint,grid:{stroke:H.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ne=PE(o.flatMap(X=>X.impacts.map(([me,ve])=>[me+X.shift,ve+X.shift]))),te=Kt.paths.stepped({align:1}),ce=T.words&&((X,me)=>me.map(ve=>T.words[ve]??"")),fe={width:Math.max(B.clientWidth,200),height:sv,padding:[6,20,0,0],legend:{show:!1},scales:{x:{time:!1},y:{range:(X,me,ve)=>l.heights[T.key]??IE(me,ve)}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!0,y:!0,uni:Ld,setScale:!1},bind:{dblclick:()=>()=>d()}},axes:[{...J,size:22,gap:2,space:56,values:(X,me)=>me.map(ve=>LE(ve,me))},{...J,size:(X,me)=>Math.max(EE,7*Math.max(0,...(me??[]).map(ve=>ve.length))+8),gap:4,space:ce?13:SE,...ce?{values:ce}:{}}],series:[{},...z.map(X=>({stroke:X.colour,width:1.7,dash:X.dash,spanGaps:!0,points:{show:!1},...X.held?{paths:te}:{}}))],hooks:{drawClear:[X=>{X.ctx.fillStyle=H.force+"2e";for(let[me,ve]of ne){let ye=X.valToPos(Math.max(me,X.scales.x.min),"x",!0),Ge=X.valToPos(Math.min(ve,X.scales.x.max),"x",!0);Ge>ye&&X.ctx.fillRect(ye,X.bbox.top,Math.max(Ge-ye,1),X.bbox.height)}}],setSelect:[X=>v(X,T.key)],draw:[X=>r.filter(me=>me.plot===X).forEach(D)]}},xe=new Kt(fe,F,B),Ie=null;xe.over.addEventListener("pointerdown",X=>Ie=[X.clientX,X.clientY]),xe.over.addEventListener("pointerup",X=>{Ie&&Math.hypot(X.clientX-Ie[0],X.clientY-Ie[1])<5&&e(Q(X)),Ie=null}),xe.over.addEventListener("pointercancel",()=>Ie=null),xe.over.addEventListener("pointermove",X=>X.pointerType!=="touch"&&P(Q(X),xe)),xe.over.addEventListener("pointerleave",()=>P(null));let Q=X=>xe.posToVal(X.clientX-xe.over.getBoundingClientRect().left,"x");return xe}function v(T,B){let{left:H,top:V,width:W,height:q}=T.select,F=W>=Ld&&W<T.over.clientWidth-1,z=q>=Ld&&q<T.over.clientHeight-1;if(W+q<=0||!(F||z))return;let J=F?[T.posToVal(H,"x"),T.posToVal(H+W,"x")]:l.range,ne=z?{[B]:[T.posToVal(V+q,"y"),T.posToVal(V,"y")]}:{};T.setSelect({left:0,top:0,width:0,height:0},!1),g({range:J,heights:{...l.heights,...ne}})}function g(T){JSON.stringify(T)===JSON.stringify(l)||!rv(T.range)||(c=[...c,l].slice(-TE),l=T,M(),t())}function d(T,B){g({range:T===void 0?null:[T,B],heights:{}})}function b(){return c.length?(l=c.pop(),M(),t(),!0):!1}function M(){let T=o.length?[Math.min(...o.map(V=>V.begin+V.shift)),Math.max(...o.map(V=>V.end+V.shift))]:[0,1],[B,H]=l.range??T;r.forEach(({plot:V})=>V.setScale("x",{min:B,max:H})),E(u)}function y({plot:T,marker:B,cross:H}){let{min:V,max:W}=T.scales.x;for(let[q,F]of[[B,u],[H,h]])q.hidden=F===null||!(F>=V&&F<=W),q.hidden||(q.style.transform=`translateX(${T.valToPos(F,"x")}px)`)}function P(T,B){h=T;for(let H of r){if(H.flag.hidden=T===null||H.plot!==B,H.flag.hidden)continue;H.flag.textContent=`${T.toFixed(4)} s`;let V=B.valToPos(T,"x");H.flag.classList.toggle("left",V>.7*B.over.clientWidth),H.flag.style.transform=`translateX(${V}px)`}i.classList.toggle("pointing",T!==null),I()}function E(T){u=T,I()}let I=()=>r.forEach(D);function D(T){let{panel:B,plot:H,values:V}=T,W=[H.scales.y.min??0,H.scales.y.max??1];y(T),B.curves.forEach((q,F)=>{let z=jo(q,h??u);V[F].textContent=B.words?.[Math.round(z)]??CE(z,W)})}function S(){r.forEach(({plot:T,canvas:B})=>{let H=B.clientWidth;H&&Math.abs(H-T.width)>1&&T.setSize({width:H,height:sv})}),E(u)}let w=new ResizeObserver(S);return w.observe(i),{replace:p,choose:f,show:E,zoom:d,back:b,resize:S,restore(T){rv(T.range)&&(l=T,M(),t())},get wanted(){return a??tr(o)},get range(){return l.range},get zoomed(){return l},get canGoBack(){return c.length>0},shown:()=>r.map(({panel:T,plot:B,values:H})=>({name:T.name,unit:T.unit,limits:[B.scales.y.min,B.scales.y.max],ticks:[...B.axes[1]._values??[]],values:Object.fromEntries(T.curves.map((V,W)=>[V.name,H[W].textContent]))})),dispose(){w.disconnect(),r.forEach(({plot:T})=>T.destroy()),i.replaceChildren()}}}function rv(i){if(i===null)return!0;let[e,t]=i;return t-e>=Id[0]&&t-e<=Id[1]&&Math.abs(e)<=Id[1]}function PE(i){let e=[];for(let[t,n]of i.sort((s,r)=>s[0]-r[0])){let s=e[e.length-1];s&&t<=s[1]?s[1]=Math.max(s[1],n):e.push([t,n])}return e}function IE(i,e){if(i==null||e==null)return[0,1];let t=Math.max(e-i,.001*Math.max(Math.abs(i),Math.abs(e)),1e-6);return[i-.06*t,e+.08*t]}function LE(i,e){let t=0,n=.001*(e.length>1?e[1]-e[0]:1);for(;t<6&&e.some(s=>Math.abs(s-Number(s.toFixed(t)))>n);)t++;return`${i.toFixed(t)} s`}var nl=[1,2,5,10,20,50,100,200],DE=.25,UE=i=>{if(i>.995)return"real time";let e=1/i;return`1/${e<10?e.toFixed(1).replace(/\.0$/,""):Math.round(e)} of real time`};function Gh({scene:i,plots:e=null,bar:t,readouts:n=null,actions:s={},onRest:r=()=>{}}){let o={t:0,playing:!1,pace:"auto",line:null,flights:[],last:0},a=G("button",{class:"play",type:"button",onclick:()=>o.playing?P():y()}),l=G("button",{type:"button",title:"One instant back (←)","aria-label":"One instant back",onclick:()=>S(-1)},Yi("back")),c=G("button",{type:"button",title:"One instant forward (→)","aria-label":"One instant forward",onclick:()=>S(1)},Yi("forth")),u=G("button",{type:"button",title:"Go to the first touch (T)","aria-label":"Go to the first touch",onclick:w},Yi("touch")),h=G("select",{"aria-label":"Speed",title:"Speed (, and .)",onchange:()=>I(h.value)},G("option",{value:"auto"},"slow at impact"),...nl.map(F=>G("option",{value:String(F)},F===1?"real time":`1/${F}`))),f=G("output",{class:"clock","aria-live":"off"}),p=G("input",{type:"range",min:0,max:1,step:"any",value:0,"aria-label":"Time",oninput:()=>{P(),d(o.line.timeAt(Number(p.value)*o.line.total))}}),m=G("div",{class:"ticks","aria-hidden":"true"}),v=G("div",{class:"track"},m,p),g=G("div",{class:"events"});t.classList.add("player"),t.replaceChildren(G("div",{class:"buttons"},a,l,c,u,h,f),v,g);function d(F){if(!o.line)return;o.t=Math.min(Math.max(F,o.line.begin),o.line.end),i.show(o.t),e?.show(o.t);let z=o.line.watchedAt(o.t)/o.line.total;p.value=z,v.style.setProperty("--share",z),b(),o.playing||r()}function b(){let F=vl(o.flights),z=F===null?"":` · ${o.t>=F?"+":"−"}${Math.abs(1e3*(o.t-F)).toFixed(1)} ms from touch`,J=o.pace==="auto"?o.line.paceAt(o.t):1/Number(o.pace);f.replaceChildren(G("b",{},`${o.t.toFixed(4)} s`),G("span",{},z),G("span",{class:"pace"},UE(J))),p.setAttribute("aria-valuetext",`${o.t.toFixed(3)} s${z}`),n&&V()}function M(F){if(!o.playing)return;let z=Math.min((F-o.last)/1e3,.1);o.last=F;let J=o.line,ne=o.pace==="auto"?J.timeAt(J.watchedAt(o.t)+z):o.t+z/Number(o.pace);d(ne),o.t>=J.end?P():requestAnimationFrame(M)}function y(){!o.line||o.playing||(o.t>=o.line.end-1e-9&&d(o.line.begin),o.playing=!0,o.last=performance.now(),E(),requestAnimationFrame(M))}function P(){o.playing&&setTimeout(r),o.playing=!1,E()}function E(){a.replaceChildren(Yi(o.playing?"pause":"play")),a.setAttribute("aria-label",o.playing?"Pause":"Play"),a.title=o.playing?"Pause (space)":"Play (space)"}function I(F){o.pace=F==="auto"?"auto":String(nl.reduce((z,J)=>Math.abs(J-F)<Math.abs(z-F)?J:z)),h.value=o.pace,b(),r()}function D(F){let z=o.pace==="auto"?F>0?0:1:nl.indexOf(Number(o.pace))+F;I(nl[Math.min(Math.max(z,0),nl.length-1)])}function S(F){P();let z=o.flights[0],J=o.t-z.shift,ne=gl(z.t,J+1e-9),te=z.t[ne]<J-1e-9&&F<0?ne:ne+F;d(z.t[Math.min(Math.max(te,0),z.n-1)]+z.shift)}function w(){P();let F=vl(o.flights);F!==null&&d(F)}function T(){let F=o.line,z=te=>F.watchedAt(te)/F.total;m.replaceChildren(...F.stretches.map(([te,ce])=>{let fe=G("span",{class:"slow"});return fe.style.left=`${100*z(te)}%`,fe.style.width=`${100*Math.max(z(ce)-z(te),.002)}%`,fe}));let J=o.flights.flatMap(te=>te.events.map(ce=>({...ce,t:ce.t+te.shift,flight:te})));J.sort((te,ce)=>te.t-ce.t);for(let te of J){let ce=G("i",{class:te.kind});ce.style.left=`${100*z(te.t)}%`,o.flights.length>1&&(ce.style.background=te.flight.colour),m.append(ce)}let ne=o.flights.length>1;g.replaceChildren(...J.filter(te=>te.kind!=="end"||!ne).slice(0,60).map(te=>{let ce=ne?`${te.flight.label}: ${te.label}`:te.label,fe=G("button",{type:"button",class:`event ${te.kind}`,title:`${te.text}, ${te.t.toFixed(4)} s`,onclick:()=>{P(),d(te.t)}},G("span",{},ce),G("small",{},` ${te.t.toFixed(3)} s`));return ne&&fe.style.setProperty("--colour",te.flight.colour),fe}))}let B=[];function H(){if(!n)return;let F=["speed","acceleration","compression, largest","contact force, sum of all contacts","thrust, all rotors"],z=["m/s","m/s²","mm","N","N"],J=o.flights.length>2,ne=G("table",{class:J?"numbers crowded":"numbers"});o.flights.length>1&&ne.append(G("thead",{},G("tr",{},G("th",{},""),...o.flights.map(ce=>{let fe=G("th",{scope:"col"},ce.label);return fe.style.color=ce.colour,fe}),...J?[]:[G("th",{},"")])));let te=G("tbody");B=F.map((ce,fe)=>{let xe=o.flights.map(()=>G("td")),Ie=G("td",{class:"unit"},z[fe]);return te.append(G("tr",{},G("th",{scope:"row"},J?`${ce} [${z[fe]}]`:ce),...xe,...J?[]:[Ie])),xe}),ne.append(te),n.replaceChildren(ne)}function V(){o.flights.forEach((F,z)=>{let J=Jo(F,o.t),ne=Q=>F.series.find(X=>X.panel===Q),te=Q=>ne(Q)?jo({flight:F,values:ne(Q).values},o.t):0,ce=Math.max(0,...F.arms.map((Q,X)=>Q.compliant?1e3*Rg(Q,J.armLengths[X],J.bends[X]):0)),fe=Math.hypot(...[0,1,2].map(Q=>J.contacts.reduce((X,me)=>X+(me?me.force[Q]:0),0))),xe=[te("Velocity"),te("Acceleration"),ce,fe,J.thrust.reduce((Q,X)=>Q+X,0)],Ie=!F.arms.some(Q=>Q.compliant);xe.forEach((Q,X)=>B[X][z].textContent=X===2&&Ie?"rigid":ov(Q))})}function W(F){if(F.ctrlKey||F.metaKey||F.altKey||F.target.closest?.("dialog"))return;let z=F.target.tagName;if(z==="TEXTAREA"||z==="SELECT"||z==="INPUT"&&F.target.type!=="range"||F.target.type==="range"&&F.target!==p)return;let J=F.shiftKey?10:1,ne={" ":()=>o.playing?P():y(),ArrowRight:()=>S(J),ArrowLeft:()=>S(-J),Home:()=>(P(),d(o.line.begin)),End:()=>(P(),d(o.line.end)),",":()=>D(1),".":()=>D(-1),t:w,...s};if(F.key===" "&&z==="BUTTON")return;let te=ne[F.key];!te||!o.line||te()!==!1&&F.preventDefault()}document.addEventListener("keydown",W);function q({keepTime:F=!0}={}){o.flights=i.flights,o.line=Ig(o.flights),H(),e?.replace(o.flights),T();let z=vl(o.flights);d(F?o.t:z===null?o.line.begin:z-DE)}return E(),{replace:q,seek:d,play:y,pause:P,setPace:I,goToTouch:w,get time(){return o.t},get playing(){return o.playing},get pace(){return o.pace},dispose(){P(),document.removeEventListener("keydown",W),t.replaceChildren()}}}var lv={type:"change"},Ud={type:"start"},hv={type:"end"},Wh=new hr,cv=new Zn,NE=Math.cos(70*Xs.DEG2RAD),fn=new L,Qn=2*Math.PI,Nt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Dd=1e-6,Xh=class extends ka{constructor(e,t=null){super(e,t),this.state=Nt.NONE,this.target=new L,this.cursor=new L,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hs.ROTATE,MIDDLE:Hs.DOLLY,RIGHT:Hs.PAN},this.touches={ONE:Vs.ROTATE,TWO:Vs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new L,this._lastQuaternion=new sn,this._lastTargetPosition=new L,this._quat=new sn().setFromUnitVectors(e.up,new L(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new yo,this._sphericalDelta=new yo,this._scale=1,this._panOffset=new L,this._rotateStart=new Oe,this._rotateEnd=new Oe,this._rotateDelta=new Oe,this._panStart=new Oe,this._panEnd=new Oe,this._panDelta=new Oe,this._dollyStart=new Oe,this._dollyEnd=new Oe,this._dollyDelta=new Oe,this._dollyDirection=new L,this._mouse=new Oe,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=OE.bind(this),this._onPointerDown=FE.bind(this),this._onPointerUp=BE.bind(this),this._onContextMenu=XE.bind(this),this._onMouseWheel=HE.bind(this),this._onKeyDown=VE.bind(this),this._onTouchStart=GE.bind(this),this._onTouchMove=WE.bind(this),this._onMouseDown=zE.bind(this),this._onMouseMove=kE.bind(this),this._interceptControlDown=qE.bind(this),this._interceptControlUp=YE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(lv),this.update(),this.state=Nt.NONE}update(e=null){let t=this.object.position;fn.copy(t).sub(this.target),fn.applyQuaternion(this._quat),this._spherical.setFromVector3(fn),this.autoRotate&&this.state===Nt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Qn:n>Math.PI&&(n-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(fn.setFromSpherical(this._spherical),fn.applyQuaternion(this._quatInverse),t.copy(this.target).add(fn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=fn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new L(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new L(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=fn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Wh.origin.copy(this.object.position),Wh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Wh.direction))<NE?this.object.lookAt(this.target):(cv.setFromNormalAndCoplanarPoint(this.object.up,this.target),Wh.intersectPlane(cv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Dd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Dd||this._lastTargetPosition.distanceToSquared(this.target)>Dd?(this.dispatchEvent(lv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Qn/60*this.autoRotateSpeed*e:Qn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){fn.setFromMatrixColumn(t,0),fn.multiplyScalar(-e),this._panOffset.add(fn)}_panUp(e,t){this.screenSpacePanning===!0?fn.setFromMatrixColumn(t,1):(fn.setFromMatrixColumn(t,0),fn.crossVectors(this.object.up,fn)),fn.multiplyScalar(e),this._panOffset.add(fn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;fn.copy(s).sub(this.target);let r=fn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Oe,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function FE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function OE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function BE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(hv),this.state=Nt.NONE;break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function zE(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Hs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Nt.DOLLY;break;case Hs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Nt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Nt.ROTATE}break;case Hs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Nt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Nt.PAN}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(Ud)}function kE(i){switch(this.state){case Nt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Nt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Nt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function HE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Nt.NONE||(i.preventDefault(),this.dispatchEvent(Ud),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(hv))}function VE(i){this.enabled!==!1&&this._handleKeyDown(i)}function GE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Vs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Nt.TOUCH_ROTATE;break;case Vs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Nt.TOUCH_PAN;break;default:this.state=Nt.NONE}break;case 2:switch(this.touches.TWO){case Vs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Nt.TOUCH_DOLLY_PAN;break;case Vs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Nt.TOUCH_DOLLY_ROTATE;break;default:this.state=Nt.NONE}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(Ud)}function WE(i){switch(this._trackPointer(i),this.state){case Nt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Nt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Nt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Nt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Nt.NONE}}function XE(i){this.enabled!==!1&&i.preventDefault()}function qE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function YE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var $E=7,ZE=.0022,KE=new L(1,0,0);function Nd(i,e=$E,t=ZE){class n extends jn{getPoint(r,o=new L){let a=2*Math.PI*e*r;return o.set(r,i*Math.cos(a),i*Math.sin(a))}}return new Ia(new n,e*14,t,5)}function ki(i,e=14){return new wn(i,i,1,e).rotateZ(-Math.PI/2).translate(.5,0,0)}function qh(i,e){return new et(new wn(.0155*i,.0155*i,.006*i,20).rotateZ(Math.PI/2),e)}function il(i,e,t){let n=t.clone().sub(e);return i.position.copy(e),i.quaternion.setFromUnitVectors(new L(1,0,0),n.normalize()),i}function uv(i,e){let t=new Ot;t.setAttribute("position",new Jt(Zt(i.vertices),3)),t.setIndex(new Jt(new Uint32Array(Zt(i.triangles)),1));let n=t.toNonIndexed();return n.computeVertexNormals(),new et(n,e)}var Yh=class{constructor(e,t,n){this.group=new Tt;let s=new Ui({color:e,depthTest:!1,transparent:!0,opacity:n});this.shaft=new et(ki(t,10),s),this.head=new et(new dr(3*t,8*t,14).rotateZ(-Math.PI/2),s),this.size=8*t,this.shaft.renderOrder=this.head.renderOrder=10,this.group.add(this.shaft,this.head),this.along=new L(1,0,0),this.way=new L}show(e,t){let n=this.way.set(...t).length();if(this.group.visible=n>1e-4,!this.group.visible)return;this.group.position.set(...e),this.group.quaternion.setFromUnitVectors(this.along,this.way.divideScalar(n));let s=Math.min(this.size,.6*n);this.head.scale.setScalar(s/this.size),this.head.position.x=n-.5*s,this.shaft.scale.x=Math.max(n-s,1e-5)}hide(){this.group.visible=!1}},en,dv,pv,mv,sl,gv,vv,_v,xv,rl=class{constructor(e,t,n){ml(this,en);this.flight=e,this.group=new Tt;let s=t.opacity<1,r=(v,g={})=>new Ni({color:v,roughness:.55,metalness:.15,transparent:s,opacity:t.opacity,depthWrite:!s,...g}),o=r(n.metal),a=r(n.dark),l=r(t.colour),c=r(n.force,{metalness:.4,roughness:.35}),u=Math.max(...e.arms.map(v=>v.length)),h=u/.19,f=new et(new wn(.042*h,.042*h,.026*h,28),a);f.rotation.x=Math.PI/2;let p=new et(new wn(.032*h,.04*h,.014*h,28),l);p.rotation.x=Math.PI/2,p.position.z=.02*h;let m=new et(new dr(.012*h,.034*h,16).rotateZ(-Math.PI/2),l);m.position.set(.056*h,0,.004*h),this.group.add(f,p,m),this.hulls=e.hull.map(v=>{let g=r(t.colour,{transparent:!0,opacity:.22*t.opacity,depthWrite:!1});if(v.meshes.length){for(let b of v.meshes)this.group.add(uv(b,g));return g}let d=new et(new Ca(v.radius,32,20),g);return d.position.set(...v.centre),this.group.add(d),g}),this.arms=e.arms.map(v=>Rn(this,en,dv).call(this,v,{metal:o,dark:a,own:l,spring:c,paint:r,colours:n,unit:h,faded:s,look:t})),this.springs=e.neighbours.map(({first:v,second:g})=>{let d=new et(Nd(.0075*h,16,.0014*h),c);return this.group.add(d),{coil:d,first:v,second:g,from:new L,to:new L,way:new L}}),this.open=new at(n.force),this.shut=new at(n.dark),this.rotors=e.rotors.map(v=>Rn(this,en,pv).call(this,v,{dark:a,paint:r,colours:n,unit:h,look:t})),this.most=e.max_thrust||1,this.bar=1.2*u}connections(){this.group.updateWorldMatrix(!0,!0);let e=this.group.parent?.position??new L,t=s=>s.getWorldPosition(new L).sub(e).toArray(),n=s=>s.localToWorld(new L(1,0,0)).sub(e).toArray();return{springs:this.springs.map(({coil:s})=>[t(s),n(s)]),latches:this.arms.flatMap(({latches:s})=>s??[]).map(({held:s,moving:r,glow:o})=>({held:t(s),moving:t(r),open:o.color.equals(this.open)}))}}ends(){this.group.updateWorldMatrix(!0,!0);let e=this.group.parent?.position??new L,t=n=>this.rotors[this.flight.rotors.findIndex(s=>s.arm===n)]?.rotor;return this.arms.map(({tip:n},s)=>({centre:n.getWorldPosition(new L).sub(e).toArray(),normal:new L(0,0,1).transformDirection(n.matrixWorld).toArray(),thrust:t(s)?new L(0,0,1).transformDirection(t(s).matrixWorld).toArray():null}))}show(e,t=1){this.group.position.set(...e.position);let[n,s,r,o]=e.quaternion;this.group.quaternion.set(s,r,o,n);let a=new Set(e.contacts.filter(Boolean).map(l=>l.part));this.arms.forEach((l,c)=>{let u=t===1?e.armLengths[c]:l.free-fv(t*(l.free-e.armLengths[c]),l),h=t===1?e.bends[c]??0:fv(t*(e.bends[c]??0),l);l.hung?l.path.at(u,l.end.position,l.end.quaternion,h):l.end.position.x=u,l.middle&&l.path.at(u,l.middle.position,l.middle.quaternion);for(let f of l.latches??[])f.glow.color.copy(l.free-e.armLengths[c]>f.travel?this.open:this.shut);l.shown=u,l.bend=h,l.coil&&(l.coil.scale.x=Math.max(u-l.collar-l.seat,.004)),l.cagePaint.color.set(a.has(c)?this.flight.glow:this.flight.colour)}),this.rotors.forEach((l,c)=>{l.level&&l.rotor.quaternion.copy(l.level.end.quaternion).invert().multiply(l.aim),l.blades.rotation.z=l.spin*e.own*60;let u=this.bar*e.thrust[c]/this.most;l.thrust.visible=u>.001,l.thrust.scale.z=Math.max(u,.001)});for(let{coil:l,first:c,second:u,from:h,to:f,way:p}of this.springs){for(let[v,g]of[[c,h],[u,f]])this.arms[v].path.at(this.arms[v].shown,g,null,this.arms[v].bend);let m=p.copy(f).sub(h).length();l.position.copy(h),l.quaternion.setFromUnitVectors(KE,p.divideScalar(Math.max(m,1e-6))),l.scale.x=Math.max(m,1e-6)}this.hulls.forEach((l,c)=>{l.color.set(a.has(this.arms.length+c)?this.flight.glow:this.flight.colour)})}};en=new WeakSet,dv=function(e,{metal:t,dark:n,own:s,spring:r,paint:o,colours:a,unit:l,faded:c,look:u}){let h=new Tt;this.group.add(h);let f=Math.atan2(e.direction[1],e.direction[0]),p=new Tt;h.add(p);let m=new Co(e),v={end:p,frame:h,free:e.length,path:m,hung:e.joint.length>0},g=new Tt,d={frame:h,end:p,metal:t,dark:n,own:s,spring:r,unit:l};v.hung?(g.rotation.z=f,e.compliant?m.second?v.middle=Rn(this,en,_v).call(this,m,d):m.isHinge?Rn(this,en,vv).call(this,m,d):Object.assign(v,Rn(this,en,gv).call(this,e,m,d)):Rn(this,en,sl).call(this,m.start,.007,d),v.latches=e.latch.map(E=>Rn(this,en,xv).call(this,E,m,{...d,end:v.middle??p,paint:o,colours:a}))):(h.rotation.z=f,Object.assign(v,Rn(this,en,mv).call(this,e,d))),p.add(g);let b=o(u.colour,{roughness:.4}),M=new et(new Pa(e.cage_radius-.0035*l,.0035*l,10,72),b);e.caged&&g.add(M);let y=o(u.colour,{transparent:!0,opacity:.22*u.opacity,depthWrite:!1}),P=new Tt;P.rotation.z=-f;for(let E of e.hulls)P.add(uv(E,y));g.add(P);for(let E=0;E<(e.caged?3:0);E++){let I=new et(ki(.0016*l,6),t);I.rotation.z=2*Math.PI*(E+.5)/3,I.scale.x=e.cage_radius-.004*l,g.add(I)}return Object.assign(v,{cagePaint:b,tip:g,seat:P})},pv=function({arm:e,offset:t,axis:n,level:s,spin:r,radius:o},{dark:a,paint:l,colours:c,unit:u,look:h}){let f=new Tt;f.position.set(...t);let p=new sn().setFromUnitVectors(new L(0,0,1),new L(...n));f.quaternion.copy(p),(e<0?this.group:this.arms[e].seat).add(f);let m=new et(new wn(.013*u,.013*u,.024*u,18).rotateX(Math.PI/2),a);m.position.z=.008*u;let v=new et(new fr(o,36),l(c.thrust,{transparent:!0,opacity:.16*h.opacity,side:Wn,depthWrite:!1}));v.position.z=.022*u;let g=new et(new ji(2*o,.012*u,.0015),a);g.position.z=.023*u;let d=new et(new wn(.006*u,.006*u,1,12).rotateX(Math.PI/2).translate(0,0,.5),l(c.thrust,{transparent:!0,opacity:.8*h.opacity,emissive:c.thrust,emissiveIntensity:.3}));return d.position.z=.024*u,f.add(m,v,g,d),{rotor:f,blades:g,thrust:d,spin:r,aim:p,level:s?this.arms[e]:null}},mv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,spring:a,unit:l}){let c=e.length-e.shortest,u=.13*e.length;if(!e.compliant){let d=new et(ki(.007*l),s);return d.scale.x=e.length,t.add(d),{}}let h=Math.max(.24*e.length,e.shortest-u-.8*c),f=new et(ki(.0075*l),s);f.scale.x=e.shortest-.5*u;let p=new et(ki(.0045*l),o);p.position.x=-(e.length-h)+.3*u,p.scale.x=-p.position.x;let m=qh(l,r);m.position.x=h;let v=qh(l,r);v.position.x=-u;let g=new et(Nd(.0125*l),a);return g.position.x=h,t.add(f,m,g),n.add(p,v),{coil:g,seat:h,collar:u}},sl=function(e,t,{frame:n,metal:s,unit:r}){let o=new et(ki(t*r),s);o.scale.x=Math.max(e.length(),1e-6),n.add(il(o,new L,e))},gv=function(e,t,{frame:n,end:s,metal:r,dark:o,own:a,spring:l,unit:c}){let u=.13*t.start.length(),h=t.start.distanceTo(t.anchor),f=e.length-e.shortest,p=il(new Tt,t.anchor,t.start),m=new et(ki(.0075*c),r);m.scale.x=Math.max(h-f-.5*u,1e-6);let v=new et(Nd(.0125*c),l);p.add(m,qh(c,o),v);let g=new Tt;g.quaternion.copy(p.quaternion);let d=new et(ki(.0045*c),a);d.position.x=-h+.3*u,d.scale.x=-d.position.x;let b=qh(c,o);return b.position.x=-u,g.add(d,b),n.add(p),s.add(g),Rn(this,en,sl).call(this,t.anchor,.0075,{frame:n,metal:r,unit:c}),{coil:v,seat:e.length-h,collar:u}},vv=function(e,{frame:t,end:n,metal:s,dark:r,own:o,unit:a}){Rn(this,en,sl).call(this,e.anchor,.0075,{frame:t,metal:s,unit:a});let l=new et(new wn(.0105*a,.0105*a,.028*a,20),r);l.quaternion.setFromUnitVectors(new L(0,1,0),e.axis.clone().normalize()),l.position.copy(e.anchor),t.add(l);let c=new et(ki(.006*a),o),u=e.anchor.clone().sub(e.start);c.scale.x=u.length(),n.add(il(c,new L,u))},_v=function(e,{frame:t,end:n,metal:s,dark:r,own:o,unit:a}){let l=new Tt;t.add(l);let c=(v,g,d)=>{let b=new et(new wn(.0105*a,.0105*a,.028*a,20),r);b.quaternion.setFromUnitVectors(new L(0,1,0),v.axis.clone().normalize()),b.position.copy(d),g.add(b)},u=e.second,h=e.isHinge?e.anchor:new L;e.isHinge&&(Rn(this,en,sl).call(this,e.anchor,.0075,{frame:t,metal:s,unit:a}),c(e,t,e.anchor));let f=e.anchor.clone().sub(e.start),p=u.isHinge?u.anchor.clone().sub(e.start):new L;u.isHinge&&c(u,l,p);let m=(v,g,d)=>{let b=new et(ki(.006*a),o);b.scale.x=Math.max(v.distanceTo(g),1e-6),d.add(il(b,v,g))};return e.isHinge?m(f,p,l):m(h,e.start.clone().add(p),t),u.isHinge&&m(new L,p,n),l},xv=function(e,t,{frame:n,end:s,metal:r,unit:o,paint:a,colours:l}){let c=new L(...e.face),u=.006*o,h=a(l.dark),f=()=>{let M=(t.isHinge?.011:.019)*o,y=new wn(M,M,u,20);return new et(y.rotateZ(-Math.PI/2),h)},p=t.along.clone().normalize(),m=new sn().setFromUnitVectors(new L(1,0,0),p),[v,g]=[f(),f()];v.quaternion.copy(m),g.quaternion.copy(m),v.position.copy(c).addScaledVector(p,1.1*u),g.position.copy(c).sub(t.start);let d=new et(ki(.0028*o,8),r),b=t.anchor.clone().addScaledVector(p,t.isHinge?u:0);return d.scale.x=Math.max(b.distanceTo(v.position),1e-6),n.add(v,il(d,b,v.position)),s.add(g),{glow:h,held:v,moving:g,travel:e.travel}};function fv(i,e){let t=.4*e.free;return Math.min(e.hung?Math.max(i,-t):i,t)}function ol(i){i.traverse(e=>{e.geometry?.dispose();for(let t of[e.material].flat())t?.map?.dispose(),t?.dispose?.()}),i.removeFromParent()}var yv=new yn,$h=new L,ko=class extends Oa{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new mt(e,3)),this.setAttribute("uv",new mt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ks(t,6,1);return this.setAttribute("instanceStart",new Jn(n,3,0)),this.setAttribute("instanceEnd",new Jn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new ks(t,6,1);return this.setAttribute("instanceColorStart",new Jn(n,3,0)),this.setAttribute("instanceColorEnd",new Jn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new La(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new yn);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),yv.setFromBufferAttribute(t),this.boundingBox.union(yv))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Li),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)$h.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared($h)),$h.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared($h));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};De.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Oe(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Xn.line={uniforms:Ya.merge([De.common,De.fog,De.line]),vertexShader:`
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
		`};var $s=class extends oi{constructor(e){super({type:"LineMaterial",uniforms:Ya.clone(Xn.line.uniforms),vertexShader:Xn.line.vertexShader,fragmentShader:Xn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Fd=new It,bv=new L,Mv=new L,Sn=new It,En=new It,ns=new It,Od=new L,Bd=new Ut,Tn=new Ba,wv=new L,Zh=new yn,Kh=new Li,is=new It,ss,Pr;function Sv(i,e,t){return is.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),is.multiplyScalar(1/is.w),is.x=Pr/t.width,is.y=Pr/t.height,is.applyMatrix4(i.projectionMatrixInverse),is.multiplyScalar(1/is.w),Math.abs(Math.max(is.x,is.y))}function JE(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Tn.start.fromBufferAttribute(s,a),Tn.end.fromBufferAttribute(r,a),Tn.applyMatrix4(t);let c=new L,u=new L;ss.distanceSqToSegment(Tn.start,Tn.end,u,c),u.distanceTo(c)<Pr*.5&&e.push({point:u,pointOnLine:c,distance:ss.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function jE(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;ss.at(1,ns),ns.w=1,ns.applyMatrix4(e.matrixWorldInverse),ns.applyMatrix4(n),ns.multiplyScalar(1/ns.w),ns.x*=r.x/2,ns.y*=r.y/2,ns.z=0,Od.copy(ns),Bd.multiplyMatrices(e.matrixWorldInverse,o);for(let f=0,p=u;f<p;f++){if(Sn.fromBufferAttribute(l,f),En.fromBufferAttribute(c,f),Sn.w=1,En.w=1,Sn.applyMatrix4(Bd),En.applyMatrix4(Bd),Sn.z>h&&En.z>h)continue;if(Sn.z>h){let M=Sn.z-En.z,y=(Sn.z-h)/M;Sn.lerp(En,y)}else if(En.z>h){let M=En.z-Sn.z,y=(En.z-h)/M;En.lerp(Sn,y)}Sn.applyMatrix4(n),En.applyMatrix4(n),Sn.multiplyScalar(1/Sn.w),En.multiplyScalar(1/En.w),Sn.x*=r.x/2,Sn.y*=r.y/2,En.x*=r.x/2,En.y*=r.y/2,Tn.start.copy(Sn),Tn.start.z=0,Tn.end.copy(En),Tn.end.z=0;let v=Tn.closestPointToPointParameter(Od,!0);Tn.at(v,wv);let g=Xs.lerp(Sn.z,En.z,v),d=g>=-1&&g<=1,b=Od.distanceTo(wv)<Pr*.5;if(d&&b){Tn.start.fromBufferAttribute(l,f),Tn.end.fromBufferAttribute(c,f),Tn.start.applyMatrix4(o),Tn.end.applyMatrix4(o);let M=new L,y=new L;ss.distanceSqToSegment(Tn.start,Tn.end,y,M),t.push({point:y,pointOnLine:M,distance:ss.origin.distanceTo(y),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var Jh=class extends et{constructor(e=new ko,t=new $s({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)bv.fromBufferAttribute(t,o),Mv.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+bv.distanceTo(Mv);let r=new ks(s,2,1);return e.setAttribute("instanceDistanceStart",new Jn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Jn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;ss=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Pr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Kh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Pr*.5;else{let h=Math.max(s.near,Kh.distanceToPoint(ss.origin));c=Sv(s,h,l.resolution)}if(Kh.radius+=c,ss.intersectsSphere(Kh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Zh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Pr*.5;else{let h=Math.max(s.near,Zh.distanceToPoint(ss.origin));u=Sv(s,h,l.resolution)}Zh.expandByScalar(u),ss.intersectsBox(Zh)!==!1&&(n?JE(this,t):jE(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Fd),this.material.uniforms.resolution.value.set(Fd.z,Fd.w))}};var Ho=class extends ko{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setPositions(n),this}setColors(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setColors(n),this}setFromPoints(e){let t=e.length-1,n=new Float32Array(6*t);for(let s=0;s<t;s++)n[6*s]=e[s].x,n[6*s+1]=e[s].y,n[6*s+2]=e[s].z||0,n[6*s+3]=e[s+1].x,n[6*s+4]=e[s+1].y,n[6*s+5]=e[s+1].z||0;return super.setPositions(n),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var jh=class extends Jh{constructor(e=new Ho,t=new $s({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};function Ev(i,e=Math.PI/3){let t=Math.cos(e),n=(1+1e-10)*100,s=[new L,new L,new L],r=new L,o=new L,a=new L,l=new L;function c(v){let g=~~(v.x*n),d=~~(v.y*n),b=~~(v.z*n);return`${g},${d},${b}`}let u=i.index?i.toNonIndexed():i,h=u.attributes.position,f={};for(let v=0,g=h.count/3;v<g;v++){let d=3*v,b=s[0].fromBufferAttribute(h,d+0),M=s[1].fromBufferAttribute(h,d+1),y=s[2].fromBufferAttribute(h,d+2);r.subVectors(y,M),o.subVectors(b,M);let P=new L().crossVectors(r,o).normalize();for(let E=0;E<3;E++){let I=s[E],D=c(I);D in f||(f[D]=[]),f[D].push(P)}}let p=new Float32Array(h.count*3),m=new Jt(p,3,!1);for(let v=0,g=h.count/3;v<g;v++){let d=3*v,b=s[0].fromBufferAttribute(h,d+0),M=s[1].fromBufferAttribute(h,d+1),y=s[2].fromBufferAttribute(h,d+2);r.subVectors(y,M),o.subVectors(b,M),a.crossVectors(r,o).normalize();for(let P=0;P<3;P++){let E=s[P],I=c(E),D=f[I];l.set(0,0,0);for(let S=0,w=D.length;S<w;S++){let T=D[S];a.dot(T)>t&&l.add(T)}l.normalize(),m.setXYZ(d+P,l.x,l.y,l.z)}}return u.setAttribute("normal",m),u}var QE=.6,eT=25,Tv=.004,Dn=i=>new L(...i);function Av(i,e,t,n,s,r){let o=[],a=e.length(),l=t.length(),c=e.clone().normalize(),u=t.clone().normalize(),h=(v,g)=>o.push(...v.toArray(),...g.toArray()),f=(v,g)=>i.clone().addScaledVector(c,v).addScaledVector(u,g),p=v=>{let g=[-v,v];for(let d=Math.ceil(-v/n)*n;d<v;d+=n)g.push(d);return g};for(let v of p(a))h(f(v,-l),f(v,l));for(let v of p(l))h(f(-a,v),f(a,v));let m=new Ot;return m.setAttribute("position",new mt(o,3)),new xo(m,new vs({color:s,transparent:!0,opacity:r,depthWrite:!1}))}function Qh(i,e,t,n,s=0){let r=Dn(i.across),o=Dn(i.along),a=Dn(i.normal),l=new ji(2*r.length(),2*o.length(),e),c=new Ni({color:t,transparent:!0,opacity:n,roughness:.9,depthWrite:!1,side:Wn}),u=new et(l,c),h=new Ut().makeBasis(r.normalize(),o.normalize(),a);return u.quaternion.setFromRotationMatrix(h),u.position.copy(Dn(i.centre)).addScaledVector(a,-s-.5*e),u.renderOrder=1,u}function tT(i,e){let t=new Ot;return t.setAttribute("position",new Jt(Zt(i.vertices),3)),t.setAttribute("normal",new Jt(Zt(i.normals),3)),t.setIndex(Array.from(Zt(i.triangles))),new et(t,new Ni({color:e.wall,transparent:!0,opacity:.55,roughness:.85,side:Wn}))}function nT(i,e,t){let n=new Ot;n.setAttribute("position",new Jt(Zt(i.vertices),3)),n.setIndex(Array.from(Zt(i.triangles)));let s=Ev(n,QE),r=t===null?[]:[new Zn(new L(0,0,1),-t)],o=new et(s,new Ui({colorWrite:!1,transparent:!0,clippingPlanes:r})),a=new et(s,new Ni({color:e.wall,transparent:!0,opacity:.72,roughness:.85,depthWrite:!1,clippingPlanes:r,stencilWrite:!0,stencilRef:1,stencilFunc:Tf,stencilZPass:Ef})),l=new xo(new Ea(n,eT),new vs({color:e.ink,transparent:!0,opacity:.35,depthWrite:!1,clippingPlanes:r}));return n.dispose(),[o,a,l].forEach((c,u)=>c.renderOrder=3+u),new Tt().add(o,a,l)}function zd(i,e,t=null){let n=new Tt;if(i.kind==="mesh")return i.normals?n.add(tT(i,e)):nT(i,e,t);let s=Dn(i.centre),r=Dn(i.normal).multiplyScalar(.001),o=(a,l,c)=>Av(s.clone().add(r),Dn(i.across),Dn(i.along),c,l,a);return i.kind==="ground"?n.add(Qh(i,.004,e.ground,.35),o(.55,e.faint,.25)):i.kind==="mat"?(n.add(Qh(i,i.thickness,e.mat,.2),o(.55,e.mat,.1)),n.add(Qh(i,.04,e.wall,.25,i.thickness))):n.add(Qh(i,.04,e.wall,.22),o(.5,e.wall,.1)),n}var eu=class{constructor(e,t,n,s){if(this.origin=Dn(e.origin),this.body=new Tt().add(...t.map(o=>zd(o,n,s))),this.group=new Tt().add(this.body),this.turn=new sn,this.rod=null,!e.rod.length)return;this.pivot=Dn(e.rod);let r=new wn(Tv,Tv,1,10).translate(0,.5,0);this.rod=new et(r,new Ni({color:n.metal,roughness:.6})),this.rod.position.copy(this.pivot),this.group.add(this.rod)}show(e){let[t,n,s,r]=e.quaternion;if(this.turn.set(n,s,r,t),this.body.quaternion.copy(this.turn),this.body.position.copy(this.origin).negate().applyQuaternion(this.turn).add(Dn(e.position)),!this.rod)return;let o=Dn(e.position).sub(this.pivot);this.rod.scale.y=o.length(),this.rod.quaternion.setFromUnitVectors(new L(0,1,0),o.normalize())}};function Rv(i,e){let t=i.getSize(new L),n=i.getCenter(new L);n.z=i.min.z;let s=r=>Math.max(.8,Math.ceil((.5*r+.4)*4)/4);return Av(n,new L(s(t.x),0,0),new L(0,s(t.y),0),.25,e.faint,.35)}function Cv(i,e){let t=Dn(i.guide).normalize(),n=[];for(let c=0;c<i.n;c+=Math.max(1,Math.floor(i.n/200)))n.push(t.dot(Dn(i.position.subarray(3*c,3*c+3))));let s=Math.min(...n)-.5,r=Math.max(...n)+.5-s,o=new wn(.008,.008,r,12).rotateZ(-Math.PI/2).translate(r/2,0,0),a=new et(o,new Ni({color:e.metal,transparent:!0,opacity:.5}));a.quaternion.setFromUnitVectors(new L(1,0,0),t);let l=Dn(i.position.subarray(0,3));return a.position.copy(l).addScaledVector(t,s-t.dot(l)),a}var tu=class{constructor(e,t,n){let s=e.impacts,r=s.length?s[0][0]:1/0,o=[],a=[],l=new at(t.before),c=new at(t.force),u=new at(e.colour);this.times=[];let h=-1/0;for(let p=0;p<e.n;p++){let m=e.t[p];if(m-h<.001&&p<e.n-1)continue;h=m,this.times.push(m),o.push(...e.position.subarray(3*p,3*p+3));let v=s.some(([g,d])=>m>=g&&m<=d);a.push(...(v?c:m<r?l:u).toArray())}let f=(p,m)=>{let v=new Ho;v.setPositions(o),v.setColors(a);let g=new $s({vertexColors:!0,linewidth:m,transparent:!0,opacity:p,depthWrite:!1});g.resolution.copy(n);let d=new jh(v,g);return d.computeLineDistances(),d};this.whole=f(.3,1.2),this.flown=f(1,2.6),this.group=new Tt,this.group.add(this.whole,this.flown)}show(e){let t=0,n=this.times.length;for(;t<n;){let s=t+n>>1;this.times[s]<=e?t=s+1:n=s}this.flown.geometry.instanceCount=Math.max(t-1,0)}resize(e){this.whole.material.resolution.copy(e),this.flown.material.resolution.copy(e)}},nu=class{constructor(e,t,n){this.level=t,this.group=new Tt,this.paths=e.arms.map(a=>new Co(a));let s=()=>new Ui({color:"#000000",transparent:!0,opacity:.16,depthWrite:!1}),r=a=>{let l=new et(new fr(a,36),s());return l.renderOrder=2,this.group.add(l),l};this.body=r(.045),this.cages=e.arms.map(a=>r(a.cage_radius));let o=new Ot;o.setAttribute("position",new mt([0,0,0,0,0,1],3)),this.plumb=new ur(o,new vs({color:n.faint,transparent:!0,opacity:.6})),this.group.add(this.plumb),this.turn=new sn,this.at=new L}show(e){let[t,n,s,r]=e.quaternion;this.turn.set(n,s,r,t);let o=this.level+.003;this.body.position.set(e.position[0],e.position[1],o),this.cages.forEach((a,l)=>{this.paths[l].at(e.armLengths[l],this.at,null,e.bends[l]),this.at.applyQuaternion(this.turn),a.position.set(e.position[0]+this.at.x,e.position[1]+this.at.y,o)}),this.plumb.position.set(e.position[0],e.position[1],o),this.plumb.scale.z=Math.max(e.position[2]-o,1e-4)}};function iT(i,e){let t=document.createElement("canvas");t.width=128,t.height=64;let n=t.getContext("2d");n.font="600 40px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle=e,n.fillText(i,64,32);let s=new Ma(t);s.colorSpace=Vn;let r=new ba(new vo({map:s,depthTest:!1,transparent:!0}));return r.scale.set(.9,.45,1),r}function Pv(i){let e=new Tt;return Object.entries({"x N":[1,0,0],"y W":[0,1,0],"z up":[0,0,1]}).forEach(([n,s])=>{let r=new za(Dn(s),new L,1,i.ink,.28,.16),o=iT(n,i.ink);o.position.set(...s).multiplyScalar(1.38),e.add(r,o)}),e}var sT=(i,e)=>i.map((t,n)=>t+e[n]),Iv=(i,e)=>i.kind==="mesh"?{...i,moved:e}:{...i,centre:sT(i.centre,e)},al=(i,e)=>i.reduce((t,n,s)=>t+n*e[s],0);function Lv(i){let e=new Map;for(let t of i){let n=t.kind!=="mesh",s=n?[t.kind,t.thickness,...t.normal,al(t.normal,t.centre)].map(o=>o.toFixed?o.toFixed(4):o).join():`${t.name} ${t.key} ${t.moved}`,r=e.get(s);e.set(s,r?n?oT(r,t):rT(r,t):t)}return[...e.values()]}function rT(i,e){let[t,n]=[i,e].map(s=>{let r=new yn().setFromArray(Zt(s.vertices));return s.triangles.shape[0]+.01*r.getSize(new L).length()});return n>t?e:i}function oT(i,e){let t={...i,centre:i.centre.slice()};for(let n of["across","along"]){let s=Math.hypot(...i[n]),r=i[n].map(u=>u/s),o=Math.abs(al(r,e.across))+Math.abs(al(r,e.along)),a=al(r,e.centre)-al(r,i.centre),l=Math.min(-s,a-o),c=Math.max(s,a+o);t[n]=r.map(u=>u*(c-l)/2),t.centre=t.centre.map((u,h)=>u+r[h]*(l+c)/2)}return t}var Dv=.22,aT=.2,lT=2.5,cT=1,hT=.005,uT=["follow","front","side","top"],Vo=["follow","free","front","side","top","impact"],Uv=100,Nv=.4,Fv=400,Ov=i=>Math.max(...i.arms.map(e=>Ag(e)+e.cage_radius));function kd(i,e,t=!0){let n=i.map(Ep),s=e.robots;n.forEach((a,l)=>{let c=!a.arms.some(u=>u.compliant);a.colour=n.length>1?s[l%s.length]:s[c?1:0],a.glow=e.force,a.index=l,a.shift=0});let r=n.map(Cs),o=r.find(a=>a!==null);return r.forEach((a,l)=>{t&&a!==null&&Math.abs(o-a)>hT&&(n[l].shift=o-a)}),n}function iu(i,{flights:e=[],compare:t="side",align:n=!0,onCamera:s=()=>{},onDrawn:r=()=>{}}={}){let o={compare:t,align:n,magnified:1,camera:"follow",t:0,all:[],hidden:new Set,flights:[],forces:!0,path:!0,estimate:!1,share:1},a=kn();i.classList.add("picture");let l=document.createElement("div");l.className="force-labels";let c=document.createElement("div");c.className="scene-legend";let u=null;try{u=new Sh({antialias:!0,alpha:!1,stencil:!0,powerPreference:"high-performance"})}catch{let ee=document.createElement("p");ee.className="no-graphics",ee.textContent="This browser cannot draw 3-D graphics (WebGL is off); plots and numbers work.",i.append(ee)}let h=new mo,f=new In(38,1,.02,80);f.up.set(0,0,1);let p=new mo,m=new mr(-1.9,1.9,1.9,-1.9,.1,20);m.up.set(0,0,1);let v=new Na("#ffffff","#9aa4b0",2.1),g=new Fa("#ffffff",2);g.position.set(-2,-3,5),h.add(v,g);let d=null,b=new Tt,M=[],y=0,P=0,E=-1/0,I=0,D=0,S=new Oe(1,1);if(u){u.localClippingEnabled=!0,i.append(u.domElement,l,c),u.domElement.setAttribute("role","img"),u.domElement.setAttribute("aria-label","The flight in three dimensions, with numbers beside it."),d=new Xh(f,u.domElement),d.enableDamping=!1,d.minDistance=.15,d.maxDistance=30,d.addEventListener("change",w);let ee=!1;d.addEventListener("start",()=>ee=!0),d.addEventListener("end",()=>ee=!1),d.addEventListener("change",()=>{ee&&o.camera!=="follow"&&s("")})}function w(){!u||y||(P=performance.now(),y=requestAnimationFrame(H))}function T(){let ee=performance.now(),ue=P-E<Fv;E=ee,clearTimeout(I),ue&&(D=.7*D+.3*(ee-P)),D>Uv&&o.share>Nv&&(o.share=Math.max(Nv,.7*o.share),D=.5*Uv),B(ue?o.share:1),ue&&o.share<1&&(I=setTimeout(w,Fv))}function B(ee){let ue=Math.min(devicePixelRatio||1,2)*ee;Math.abs(u.getPixelRatio()-ue)>.001&&u.setPixelRatio(ue)}function H(){y=0,!(!u||!i.clientWidth||!i.clientHeight)&&(T(),V(),r())}function V(){let ee=i.clientWidth,ue=i.clientHeight;u.setViewport(0,0,ee,ue),u.setScissorTest(!1),u.setClearColor(a.background,1),u.render(h,f);let we=Math.min(104,.24*Math.min(ee,ue));m.position.copy(f.position).sub(d.target).setLength(6),m.up.copy(f.up),m.lookAt(0,0,0),u.autoClear=!1,u.clearDepth(),u.setViewport(6,6,we,we),u.render(p,m),u.autoClear=!0,Q(ee,ue)}function W(){let ee=o.flights[0].obstacles.find(we=>we.kind==="wall"||we.kind==="mat"),ue=ee&&Math.abs(ee.normal[2])<.9?new L(...ee.across).normalize():new L(0,1,0);return ue.y<0?ue.negate():ue}let q=()=>W().applyAxisAngle(f.up,-Math.PI/2);function F(ee){let ue=new L,[we,C]=[1/0,-1/0];for(let x of o.flights.flatMap(N=>N.obstacles)){if(x.kind!=="mesh"||x.normals)continue;let N=Zt(x.vertices);for(let Y=0;Y<N.length;Y+=3){let le=ue.fromArray(N,Y).dot(ee);[we,C]=[Math.min(we,le),Math.max(C,le)]}}return Math.max(0,C-we)}let z=()=>[...new Set(o.flights.map(ee=>ee.world))];function J(ee){let ue=o.flights.filter(N=>o.flights.some(Y=>Y!==N&&Y.world===N.world)),we=new L,[C,x]=[1/0,-1/0];for(let{position:N}of ue)for(let Y=0;Y<N.length;Y+=3){let le=we.fromArray(N,Y).dot(ee);[C,x]=[Math.min(C,le),Math.max(x,le)]}return Math.max(0,x-C)}let ne=()=>z().length>1&&F(W())>lT?"ghost":o.compare;function te(){if(ne()!=="side")return o.flights.map(()=>[0,0,0]);let ee=W(),ue=Math.max(...o.flights.map(Ov)),we=Math.max(2*ue+J(ee),F(ee))+aT,C=z(),x=.5*(C.length-1);return o.flights.map(({world:N})=>ee.clone().multiplyScalar((x-C.indexOf(N))*we).toArray())}function ce(ee,{keepCamera:ue=!0}={}){a=kn(),o.all=kd(ee,a,o.align),o.flights=o.all.filter((we,C)=>!o.hidden.has(C)),u&&fe(),ue||dt(o.camera),ve(o.t)}function fe(){ol(b),b=new Tt,h.add(b),p.children.slice().forEach(ol),p.add(Pv(a)),l.replaceChildren();let ee=te(),ue=new yn,we=Math.max(...o.flights.map(Mu),0),C=we>0?Dv/wu(we):0;o.floor=xe(ee),M=o.flights.map((Y,le)=>{let oe=new Tt;oe.position.set(...ee[le]),b.add(oe);let Ue=Y.world!==z()[0]&&ne()==="ghost",_e=new rl(Y,{colour:Y.colour,opacity:Ue?.35:1},a),Fe=new tu(Y,a,S),Be=Y.part.map(()=>new Yh(a.force,.007,Ue?.4:.95)),ge=new nu(Y,o.floor,a);ge.group.visible=!Ue||o.flights.length===2;let Re=Hr(Y)?new rl(Y,{colour:a.ink,opacity:.35},a):null;Re&&oe.add(Re.group),oe.add(_e.group,Fe.group,ge.group,...Be.map(Ze=>Ze.group)),Y.guide.length&&oe.add(Cv(Y,a));let qe=new yn,Ye=Math.max(1,Math.floor(Y.n/400));for(let Ze=0;Ze<Y.n;Ze+=Ye)qe.expandByPoint(new L(...Y.position.subarray(3*Ze,3*Ze+3)));ue.union(qe.translate(oe.position));let Le=Y.part.map(()=>{let Ze=document.createElement("span");return l.append(Ze),Ze});return{flight:Y,group:oe,robot:_e,estimate:Re,path:Fe,arrows:Be,shadow:ge,scale:C,names:Le,ghost:Ue,contacts:[],movers:[]}});let x=o.flights.flatMap((Y,le)=>Y.obstacles.filter(oe=>oe.track<0).map(oe=>Iv(oe,ee[le]))),N=x.some(Y=>Y.kind==="ground")?o.floor:null;Lv(x).forEach(Y=>{let le=zd(Y,a,N);le.position.set(...Y.moved??[0,0,0]),b.add(le)}),M.forEach(Y=>{Y.movers=Y.flight.bodies.map((le,oe)=>new eu(le,Y.flight.obstacles.filter(Ue=>Ue.track===oe),a,N));for(let le of Y.movers)Y.group.add(le.group)}),o.box=ue.clone(),N===null&&(ue.min.z=o.floor,b.add(Rv(ue,a))),Ie()}function xe(){let ee=Math.max(...o.flights.flatMap(we=>we.obstacles.filter(C=>C.kind==="ground").map(C=>C.centre[2])));if(Number.isFinite(ee))return ee;let ue=1/0;for(let we of o.flights)for(let C=2;C<3*we.n;C+=3)ue=Math.min(ue,we.position[C]);return ue-.45}function Ie(){let ee=Math.max(...o.flights.map(Mu),0);c.replaceChildren();let ue=(C,x)=>{let N=document.createElement("span");N.className=`key ${C}`,N.textContent=x,c.append(N)};if(o.flights.length>1&&o.flights.forEach(C=>{ue("robot",C.label),c.lastChild.style.setProperty("--colour",C.colour)}),o.estimate&&o.flights.some(Hr)&&ue("estimate","estimated pose"),ee>0&&o.forces){let C=wu(ee);ue("force",`contact force, each at its point, ${C} N is ${100*Dv} cm`)}o.flights.some(C=>C.thrust.some(x=>x>0))&&ue("thrust","thrust");let we=new Set(o.flights.flatMap(C=>C.obstacles.map(x=>x.kind==="mesh"?x.name:x.kind)));ne()!==o.compare&&ue("words","overlaid: the obstacles are too wide to be put side by side"),o.magnified!==1&&ue("travel",`arm travel × ${o.magnified}, not to scale`),we.has("mat")&&ue("mat","mat"),[...we].filter(C=>!["wall","mat","ground"].includes(C)).forEach(C=>ue("own",C))}function Q(ee,ue){let we=new L,C=[];for(let x of M)x.names.forEach((N,Y)=>{let le=x.contacts[Y];if(N.hidden=x.ghost||!o.forces||!le||le.size<.5,N.hidden)return;we.set(...le.point).addScaledVector(new L(...le.force),x.scale),we.add(x.group.position).project(f),N.hidden=we.z>1||Math.abs(we.x)>1||Math.abs(we.y)>1,N.textContent=`${le.size.toFixed(le.size<10?1:0)} N`;let oe=Math.min(Math.max((we.x+1)/2*ee,24),ee-24),Ue=Math.min(Math.max((1-we.y)/2*ue-12,10),ue-10);N.hidden=C.some(([_e,Fe])=>Math.abs(_e-oe)<50&&Math.abs(Fe-Ue)<18),!N.hidden&&(C.push([oe,Ue]),N.style.transform=`translate(${oe}px, ${Ue}px) translate(-50%, -50%)`)})}let X=null;function me(){let ee=M.map(ue=>ue.robot.group.position.clone().add(ue.group.position));return ee.reduce((ue,we)=>ue.add(we),new L).divideScalar(ee.length||1)}function ve(ee){if(o.t=ee,o.poses=o.flights.map(ue=>Jo(ue,ee)),M.forEach((ue,we)=>{let C=o.poses[we];ue.robot.show(C,o.magnified),ue.path.group.visible=o.path,ue.path.show(C.own),ue.estimate&&(ue.estimate.group.visible=o.estimate,o.estimate&&ue.estimate.show(bu(ue.flight,ee),o.magnified)),ue.shadow.show(C),ue.movers.forEach((x,N)=>x.show(C.bodies[N])),ue.contacts=C.contacts,ue.arrows.forEach((x,N)=>{let Y=C.contacts[N];Y&&o.forces?x.show(Y.point,Y.force.map(le=>ue.scale*le)):x.hide()})}),u&&M.length&&uT.includes(o.camera)){let ue=me();if(X){let we=ue.clone().sub(X);f.position.add(we),d.target.add(we)}X=ue,d.update()}w()}function ye(ee){let ue=Xs.degToRad(f.fov/2),we=Math.min(1,f.aspect);return ee/Math.sin(Math.atan(Math.tan(ue)*we))}function Ge(ee,ue){d.target.copy(ee),f.position.copy(ee).add(ue),d.update()}function dt(ee){if(o.camera=Vo.includes(ee)?ee:"follow",X=null,s(o.camera),!u||!M.length)return;let ue=Math.max(...o.flights.map(Ov)),we=M.map(Fe=>Fe.group.position),C=we[0].distanceTo(we[we.length-1])/2,x=ue+C+k()+.1,N=z().length>2&&C>0,Y=N?Math.max(ye(ue+.2),x/(Math.tan(Xs.degToRad(f.fov/2))*f.aspect)+ue):ye(x),le=o.box.clone().expandByScalar(ue+.1),oe=le.getCenter(new L),Ue=.5*le.getSize(new L).length(),_e=N?q().negate().addScaledVector(W(),-.25).setZ(.5).normalize():new L(-.62,-.66,.42).normalize();if(o.camera==="free")Ge(oe,_e.clone().multiplyScalar(ye(Ue)));else if(o.camera==="impact")Ge(ht(),N?_e.clone().multiplyScalar(Y):new L(-.45,-.62,.5).normalize().multiplyScalar(ye(x+.05)));else{X=me();let Fe={follow:_e,front:q().setZ(.12),side:W().negate().setZ(.12),top:new L(0,-.001,1)}[o.camera];Ge(X.clone(),Fe.clone().normalize().multiplyScalar(o.camera==="side"?ye(x):Y))}w()}function k(){let ee=M.map(({flight:ue,robot:we})=>{let C=M.filter(Y=>Y.flight.world===ue.world);return C.map(Y=>Y.robot.group.position.clone()).reduce((Y,le)=>Y.add(le),new L).divideScalar(C.length).distanceTo(we.group.position)});return Math.min(Math.max(...ee),cT)}function ht(){let ee=o.flights.map((ue,we)=>{let C=Jo(ue,Cs(ue)??ue.begin);return new L(...C.position).add(M[we].group.position)});return ee.reduce((ue,we)=>ue.add(we),new L).divideScalar(ee.length)}function se(){if(!u)return;let ee=i.clientWidth,ue=i.clientHeight;if(!ee||!ue)return;B(1),u.setSize(ee,ue,!1);let we=f.aspect;f.aspect=ee/ue,f.updateProjectionMatrix(),S.set(ee,ue),M.forEach(C=>C.path.resize(S)),Math.abs(we/f.aspect-1)>.15&&dt(o.camera),w()}let Me=new ResizeObserver(se);Me.observe(i);let Ce=matchMedia("(prefers-color-scheme: dark)"),ot=()=>ce(o.all);Ce.addEventListener("change",ot);function re(){Me.disconnect(),Ce.removeEventListener("change",ot),cancelAnimationFrame(y),clearTimeout(I),ol(b),p.children.slice().forEach(ol),d?.dispose(),u?.dispose(),i.replaceChildren()}return se(),e.length&&ce(e,{keepCamera:!1}),{show:ve,replace:ce,setCamera:dt,resize:se,dispose:re,setCompare(ee){o.compare=ee,o.flights.length&&ce(o.all,{keepCamera:!1})},setShown(ee,ue){if(typeof ee!="number"){o[ee]=ue,Ie(),ve(o.t);return}ue?o.hidden.delete(ee):o.hidden.add(ee),ce(o.all,{keepCamera:!1})},canvas(ee=!0){return ee&&u&&(B(1),V()),u?.domElement??null},setMagnified(ee){o.magnified=ee,Ie(),ve(o.t)},get flights(){return o.flights},get all(){return o.all},get camera(){return o.camera},pose:()=>({t:o.t,camera:o.camera,pixels:o.share,flights:o.poses??[],places:M.map(({group:ee,robot:ue})=>ue.group.position.clone().add(ee.position).toArray()),ends:M.map(({robot:ee})=>ee.ends()),connections:M.map(({robot:ee})=>ee.connections()),estimates:o.estimate?o.flights.map(ee=>Hr(ee)?bu(ee,o.t):null):[]}),memory:()=>({...u?.info.memory})}}var fT={follow:"Follow",free:"Whole flight",front:"Front",side:"Side",top:"Top",impact:"Impact"},dT={1:"front",2:"side",3:"top",4:"follow",5:"free",6:"impact",0:"follow"},pT=[["space","play, pause"],["← →","one instant back, forth; with shift ten"],[", .","slower, faster"],["t","to the first touch"],["Home End","to the start, to the end"],["1 2 3","view from the front, from the side, from above"],["4 5 6","follow, whole flight, impact"],["0","the view as it was at first"],["e","estimated pose, on and off"],["f","full screen"],["p","save a picture"],["l","copy a link to this instant and view"],["a click in a plot","goes to that instant"],["a drag in a plot","zooms: along the time, the values, or both"],["a double click in a plot","shows everything"],["Escape","undoes the last zoom"],["?","these keys"]],Hd="springback.plots",mT=8e3;function Bv(i,e){let t=G("div",{class:"stage"}),n=G("div"),s=G("div",{class:"readouts"}),r=G("div"),o=G("p",{class:"remark",role:"status",hidden:!0}),a=!1,l=null,c=null,u=iu(t,{flights:e.flights,onCamera:se=>(l?.mark(se),Ge()),onDrawn:()=>c?.drawn()}),h=u.all,f=h.length>1,p=new Set(h.map(se=>se.world)).size,m=[...new Set(h.map(se=>se.scenario))],v=m.length>2?`${h.length} flights`:m.join(" and ");function g(se){o.textContent=se,o.hidden=!1,clearTimeout(g.ends),g.ends=setTimeout(()=>o.hidden=!0,mT)}let d=h.map((se,Me)=>vT(se,f&&(Ce=>S(Me,Ce))));l=wi("Camera",Vo.map(se=>[se,fT[se]]),"follow",se=>u.setCamera(se));let b=wi("Flights",[["side","side by side"],["ghost","overlaid"]],"side",se=>(u.setCompare(se),Ge())),M=h.some(se=>se.arms.some(Me=>Me.compliant)),y=wi("Arm travel",[["1","arms to scale"],["10","arm travel × 10"]],"1",se=>(u.setMagnified(Number(se)),Ge())),P={forces:["Forces",!0],path:["Path",!0],...h.some(Hr)?{estimate:["Estimate",!1]}:{}},E=Object.fromEntries(Object.entries(P).map(([se,[Me,Ce]])=>[se,fp(Me,Ce,ot=>(u.setShown(se,ot),Ge()),se==="estimate"?"The pose that the pilot estimates, as a grey ghost (E)":"")])),I=G("div",{class:"choice",role:"group","aria-label":"Show"},...Object.values(E)),D=()=>h.flatMap((se,Me)=>d[Me].shown?[]:[Me+1]);function S(se,Me){if(!Me&&D().length===h.length-1)return g("One flight is always shown.");d[se].mark(Me),u.setShown(se,Me),ve.replace(),Ge()}let w=av(r,{onSeek:se=>(ve.pause(),ve.seek(se)),onZoom:()=>(z(),Ge()),onEdit:se=>T.open(w.wanted,se),onRemove:se=>J(w.wanted.filter((Me,Ce)=>Ce!==se))}),T=Cp({signals:_l(h),standard:tr(h),onChoose:J}),B=h.find(se=>se.impacts.length),H=()=>{let[se,Me]=B.impacts[0].map(ot=>ot+B.shift),Ce=.35*Math.min(Me-se,.2)+.004;return[se-Ce,Math.min(Me,se+.3)+2*Ce]},V=se=>!!(B&&se)&&se.every((Me,Ce)=>Math.abs(Me-H()[Ce])<1e-9),W=wi("Plots show",[["all","whole flight"],...B?[["impact","first impact"]]:[]],"all",se=>se==="all"?w.zoom():w.zoom(...H())),q=G("button",{type:"button",class:"undo",title:"Undo the last zoom (Escape)",disabled:!0,"aria-label":"Undo the last zoom",onclick:()=>w.back()},Yi("undo")),F=G("button",{type:"button",class:"adding",title:"Choose plots and signals",onclick:()=>T.open(w.wanted)},"Plots …");function z(){let{range:se,heights:Me}=w.zoomed,Ce=!Object.keys(Me).length;W.mark(Ce&&!se?"all":Ce&&V(se)?"impact":""),q.disabled=!w.canGoBack}function J(se){w.choose(se);try{se?localStorage.setItem(Hd,Qo(se)):localStorage.removeItem(Hd)}catch{}Ge()}let ne=G("dialog",{class:"keys","aria-label":"Keys and mouse"},G("h2",{},"Keys and mouse"),G("table",{},...pT.map(([se,Me])=>G("tr",{},G("th",{scope:"row"},se),G("td",{},Me)))),G("form",{method:"dialog"},G("button",{class:"main"},"Close"))),te=(se,Me,Ce,ot)=>G("button",{type:"button",class:`tool tool-${se}`,title:`${Me}${ot?` (${ot})`:""}`,"aria-label":Me,onclick:Ce},Yi(se)),ce=te("film","Record a film from here",()=>c.film()),fe=G("div",{class:"left"},t,n),xe=yl(()=>fe,()=>g("This browser refuses full screen.")),Ie=G("div",{class:"tools"},te("link","Copy a link to this instant and view",Q,"L"),te("picture","Save a picture",()=>c.picture(),"P"),ce,xe.button,te("help","Keys and mouse",()=>ne.showModal(),"?"));async function Q(){let se=ye.address();try{await navigator.clipboard.writeText(se),g("The link is copied.")}catch{g("The address of this page is now a link to this instant and view.")}}let me={...Object.fromEntries(Object.entries(dT).map(([se,Me])=>[se,()=>u.setCamera(Me)])),f:xe.toggle,p:()=>c.picture(),l:Q,"?":()=>ne.showModal(),e:()=>E.estimate?.click(),Escape:()=>w.back()};i.replaceChildren(G("header",{class:"top"},G("div",{class:f?"flights several":"flights"},G("h1",{},v),...d.map(se=>se.element)),G("div",{class:"views"},l,...p>1?[b]:[],...M?[y]:[],I)),G("main",{},fe,G("aside",{},s,G("div",{class:"plot-head"},G("h2",{},"Over time"),W,q,F),r,_T(h))),T.element,ne),t.append(o),i.classList.add("replay");let ve=Gh({scene:u,plots:w,bar:n,readouts:s,actions:me,onRest:()=>(c?.rested(),Ge())});c=pp({scene:u,stage:t,player:ve,say:g,name:v.replace(/[^\p{L}\p{N}]+/gu,"-").slice(0,60),onRecording:se=>{ce.classList.toggle("recording",se),ce.setAttribute("aria-label",se?"End the film":"Record a film from here")}}),n.querySelector(".buttons").append(Ie),ve.replace({keepTime:!1}),B&&w.restore({range:H(),heights:{}}),z(),u.setCamera("follow");let ye=Pp({read:dt,apply:k});function Ge(){a&&!ve.playing&&ye.renew()}function dt(){let{range:se}=w.zoomed;return{t:ve.time.toFixed(6).replace(/0+$/,"").replace(/\.$/,""),camera:u.camera==="follow"?"":u.camera,speed:ve.pace==="auto"?"":ve.pace,arms:y.chosen==="10"?"10":"",compare:b.chosen==="ghost"?"ghost":"",hide:D().join(),layers:Object.keys(P).filter(Me=>E[Me].on!==P[Me][1]).join(),zoom:V(se)||!se&&!B?"":se?se.map(Me=>Me.toFixed(6)).join():"all",plots:Qo(w.wanted)===Qo(tr(h))?"":Qo(w.wanted)}}function k(se){let Me=re=>re.split(",").map(Number);if(se.hide){let re=Me(se.hide);h.every((ee,ue)=>re.includes(ue+1))||h.forEach((ee,ue)=>d[ue].shown===re.includes(ue+1)&&S(ue,!re.includes(ue+1)))}se.compare==="ghost"&&p>1&&b.press("ghost"),se.arms==="10"&&M&&y.press("10");let Ce=(se.layers??"").split(",");for(let re of Object.keys(P))Ce.includes(re)&&E[re].on===P[re][1]&&E[re].click();Vo.includes(se.camera)&&u.setCamera(se.camera);let ot=se.plots?Su(se.plots,h):[];ot.length&&w.choose(ot),se.zoom==="all"?w.restore({range:null,heights:{}}):se.zoom&&w.restore({range:Me(se.zoom),heights:{}}),(se.speed==="auto"||Number(se.speed)>0)&&ve.setPace(se.speed),se.t&&Number.isFinite(Number(se.t))&&ve.seek(Number(se.t))}let ht=gT(h);return ht.length&&w.choose(ht),ye.follow(),a=!0,window.springback={scene:u,player:ve,plots:w,link:ye,pose:()=>({...u.pose(),playing:ve.playing,pace:ve.pace})},matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{h.forEach((se,Me)=>d[Me].element.style.setProperty("--colour",se.colour)),ve.replace()}),window.springback}function gT(i){try{return Su(localStorage.getItem(Hd)??"",i)}catch{return[]}}function vT(i,e){let t={shown:!0},n=e?G("button",{type:"button",class:"flight","aria-pressed":"true",title:"Hide or show this flight",onclick:()=>e(!t.shown)},i.label):G("b",{},i.label);return t.element=G("p",{class:`outcome ${i.success?"well":"badly"}`},n,G("span",{},` ${i.sentence}`)),t.element.style.setProperty("--colour",i.colour),t.mark=s=>{t.shown=s,n.setAttribute("aria-pressed",String(s)),t.element.classList.toggle("away",!s)},t}function _T(i){let e=i.flatMap(s=>[...s.notes.map(r=>`${s.label}: ${r}.`),s.shift?`${s.label} is shown ${Math.abs(s.shift).toFixed(3)} s ${s.shift<0?"earlier":"later"} than it flew, so that all touch at the same time.`:""]),t=Math.max(...i.map(s=>s.departure.position))*1e3;e.push(`Motion between the drawn instants is interpolated linearly: positions are within ${t<.01?"0.01":t.toFixed(2)} mm of the flight.`);let n=Math.max(...i.map(s=>s.every));return e.push("Signals that you choose are rounded to 1/65534 of their range."),n>1&&e.push(`Telemetry is shown at every tick near impacts and changes of phase, elsewhere at one tick in ${n}.`),G("details",{class:"about"},G("summary",{},"About this view"),...[...new Set(e)].filter(Boolean).map(s=>G("p",{},s)),G("p",{},"World axes: x north, y west, z up. Yellow arrows are the contact forces on cages and main body, including friction; the numbers show their vector sum, in which friction on two cages may cancel. Blue bars are the thrust of the rotors; dark discs are vertical shadows."))}var Vd=1e3,kv=(i,e)=>Number((Math.round(i/e)*e).toFixed(6));function ll(i,e){let{least:t,most:n,logarithmic:s}=i,r=s?Math.log(e/t)/Math.log(n/t):(e-t)/(n-t);return Math.min(Math.max(r,0),1)}function zv(i,e){let{least:t,most:n,step:s,logarithmic:r}=i,o=r?t*(n/t)**e:t+(n-t)*e,a=r?10**Math.max(Math.floor(Math.log10(o))-1,Math.log10(s)):s;return Math.min(Math.max(kv(o,Math.max(a,s)),t),n)}function xT(i,e){let t=`set-${i.name}`,n=i.unit.replace("^1.5","¹·⁵"),s=G("input",{type:"range",min:0,max:Vd,step:1,id:`${t}-slider`,"aria-label":i.label,oninput:()=>h(zv(i,Number(s.value)/Vd),{moving:!0}),onchange:()=>e(i.name,r.value,{settled:!0}),onkeydown:m=>{let v={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[m.key];if(!v)return;m.preventDefault();let g=Number(r.value);Number.isFinite(g)&&h(Math.min(Math.max(kv(g+v*i.step,i.step),i.least),i.most),{settled:!0})}}),r=G("input",{type:"text",inputmode:"decimal",id:t,autocomplete:"off",spellcheck:"false",maxlength:40,"aria-describedby":`${t}-words`,oninput:()=>e(i.name,r.value.trim(),{typing:!0}),onchange:()=>e(i.name,r.value.trim(),{settled:!0})}),o=G("p",{class:"words",id:`${t}-words`}),a=G("div",{class:"marks"},...i.marks.map((m,v)=>{let g=M=>String(M.value).length*.013+.01,d=i.marks.some((M,y)=>y<v&&Math.abs(ll(i,M.value)-ll(i,m.value))<g(M)+g(m)),b=G("button",{type:"button",class:d?"tight":"",title:`${m.value} ${n}, ${m.words}`,"aria-label":`${i.label} ${m.value} ${n}, ${m.words}`,onclick:()=>h(m.value,{settled:!0})},G("span",{},String(m.value)));return b.style.setProperty("--share",ll(i,m.value)),b})),l=G("div",{class:"slider-control","data-name":i.name},G("label",{for:t},i.label),G("span",{class:"field"},r,G("span",{class:"unit"},n)),G("div",{class:"rail"},s,a),o);function c(m){let v=Number(m);r.value.trim()!==String(m)&&(r.value=String(m)),Number.isFinite(v)&&(s.value=Math.round(ll(i,v)*Vd),s.setAttribute("aria-valuetext",`${m} ${n}`)),f("")}function u(){let m=i.marks.find(v=>v.value===Number(r.value));o.className=m?"words printed":"words",o.textContent=m?`= ${m.words}`:i.explains}function h(m,v){c(m),e(i.name,String(m),v)}function f(m){r.setAttribute("aria-invalid",String(!!m)),l.classList.toggle("wrong",!!m),m?o.textContent=m:u()}return l.title=i.explains,{element:l,show:c,tellProblem:f,pick:m=>h(zv(i,ll(i,m)),{settled:!0})}}function yT(i){let e=G("p",{class:"words"},i.explains);return{element:G("div",{class:"fixed-control","data-name":i.name},G("span",{class:"label"},i.label),e),show:()=>{},tellProblem:s=>e.textContent=s||i.explains}}function bT(i,e){let t=Object.keys(i.words).length>3,n=G("p",{class:"words"},i.explains),s=a=>e(i.name,a,{settled:!0});if(!t){let a=wi(i.label,Object.entries(i.words),i.default,s);return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("span",{class:"label"},i.label),a),show:a.mark,tellProblem:()=>{}}}let r=G("select",{id:`set-${i.name}`,onchange:()=>s(r.value)},...Object.entries(i.words).map(([a,l])=>G("option",{value:a},l)));return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("label",{for:`set-${i.name}`},i.label),r,n),show:a=>r.value=a,tellProblem:a=>n.textContent=a||i.explains}}var MT={slider:xT,fixed:yT,choice:bT};function Hv(i,e){let t={},n={},s=new Map,r=(m,v,g)=>{t[m]=v,l(),e(m,v,g)};for(let m of i)t[m.name]=String(m.default),n[m.name]=MT[m.kind](m,r),s.has(m.group)||s.set(m.group,[]),s.get(m.group).push(n[m.name].element);let o=[...s].map(([m,v])=>G("section",{},...m?[G("h2",{},m)]:[],...v)),a=G("form",{class:"controls",onsubmit:m=>m.preventDefault()},...o);function l(){for(let m of i){let v=Object.entries(m.when).every(([g,d])=>d.includes(t[g]));n[m.name].element.hidden=!v}o.forEach(m=>m.hidden=![...m.querySelectorAll("[data-name]")].some(v=>!v.hidden))}function c(m){for(let[v,g]of Object.entries(m))t[v]=String(g),n[v]?.show(g);l()}function u(m){for(let v of Object.values(n))v.tellProblem("");for(let v of m){let g=v.split(":")[0],d=g in n?g:i.find(b=>b.path===g)?.name;n[d]?.tellProblem(v.slice(g.length+1).trim())}}let h=()=>i.filter(m=>t[m.name]!==String(m.default)).map(m=>`${m.name}=${encodeURIComponent(t[m.name])}`).join("&");return l(),{element:a,values:t,query:h,show:c,tellProblems:u,isShown:m=>!n[m].element.hidden,pick:(m,v)=>n[m].pick(v)}}function Vv(i,e){let t=null,n=!1,s=0;function r(l,c){clearTimeout(s),t={query:l,how:c},n||o()}async function o(){let{query:l,how:c}=t;t=null,n=!0;try{await a(l,c)}catch{t||e.gone()}n=!1,t&&o()}async function a(l,c){let u=await fetch(`flight?${l}`,{headers:{"x-lab-page":i}}),h=await u.json();u.ok?e.answered(h,c):u.status===503?(h.preparing&&e.waits(h.preparing),s=setTimeout(()=>r(l,{...c,since:performance.now()}),700)):!h.overtaken&&!t&&e.refused(h.errors,c)}return{ask:r}}var Gv=100,wT=16,su="Energy",Wv=[-.01,.13],ST={motion:["#0072b2",.85],"arm springs":["#56b4e9",.85],"end stops":["#cc79a7",.85],contact:["#009e73",.85],"lost in arms":["#e69f00",.6],"lost in contact":["#d55e00",.6],"lost in friction":["#8c8c8c",.6],"lost in stops":["#cc79a7",.4],"lost in locking":["#444444",.4],"lost to air":["#bbbbbb",.4]},Xv=(i,e)=>i+Math.round(255*e).toString(16).padStart(2,"0");function Gd(i,e=[1,1.5,2,3,5,7,10]){if(!(i>0))return 1;let t=10**Math.floor(Math.log10(i));return t*e.find(n=>n*t>=i*.999999)}function Wd(i,e,t,{moving:n=!1,locked:s=!1}={}){if(i&&s)return i;let r=[e<-1e-9?-Gd(-e):0,t>1e-9?Gd(t):e<-1e-9?0:1],[o,a]=i??r,l=e>=o&&t<=a&&(n||t-e>.3*(a-o));return i&&l?i:n?[Math.min(o,r[0]),Math.max(a,r[1])]:r}function ET(i,e,t){let n=0,s=0;for(let{t:r,values:o}of i)for(let a=0;a<o.length;a++)r[a]<e||r[a]>t||(o[a]<n&&(n=o[a]),o[a]>s&&(s=o[a]));return[n,s]}function TT(i,e){let t=new Map,n=(a,l,c)=>{t.has(a)||t.set(a,{name:a,unit:l,curves:[],stacked:a.startsWith(su)}),t.get(a).curves.push(c)},s=(a,l)=>{let c=Array.from(a.t,h=>h+a.shift),u=null;for(let h of a.series)if(h.panel===su){if(l)continue;u=Array.from(h.values,(m,v)=>m+(u?u[v]:0));let[f,p]=ST[h.name]??["#8c8c8c",.5];n(`${su}, ${a.label}`,h.unit,{name:h.name,t:c,values:u,colour:f,fill:Xv(f,p),flight:a})}else n(h.panel,h.unit,{name:l?`${a.label}, pinned`:a.label,t:c,values:Array.from(h.values),flight:a,colour:l?Xv(a.colour,.75):a.colour,dash:l?[3,3]:a.dash,behind:l})};i.forEach((a,l)=>{a.dash=l?[8,3]:[],s(a,!1)}),e.forEach(a=>s(a,!0));let r=i.map(a=>`${su}, ${a.label}`),o=a=>["Acceleration","Arm compression",...r,"Velocity","Contact force"].indexOf(a.name);return[...t.values()].sort((a,l)=>o(a)-o(l))}function qv(i,{onSeek:e}){let t=new Map,n=[],s=[],r=0,o=null,a=!1;i.classList.add("plots");function l(v,{whole:g=!1,moving:d=!1}={}){s=v;let b=Cs(v[0]),[M,y]=[v[0].begin,v[0].end];o=g||b===null?[M,y]:[b+Wv[0],Math.min(b+Wv[1],y)];let P=b??0,E=TT(v,n);for(let[I,D]of t)E.some(S=>S.name===I&&c(S,g)===D.signature)||(D.plot.destroy(),D.box.remove(),t.delete(I));for(let I of E){let D=t.get(I.name)??h(I,g);D.panel=I,D.zero=P,D.bounds=Wd(D.bounds,...ET(I.curves,...o),{moving:d,locked:a}),D.plot.batch(()=>{D.plot.setData(u(I),!1),D.plot.setScale("x",{min:o[0],max:o[1]}),D.plot.setScale("y",{min:D.bounds[0],max:D.bounds[1]})}),i.append(D.box)}p(r)}let c=(v,g)=>`${g} ${v.curves.map(d=>`${d.name} ${d.colour}`).join()}`;function u(v){let d=v.curves.every(b=>b.flight===v.curves[0].flight)?[v.curves[0].t,...v.curves.map(b=>b.values)]:Kt.join(v.curves.map(b=>[b.t,b.values]));return v.stacked?[d[0],...d.slice(1).reverse()]:d}function h(v,g){let d=kn(),b=!v.stacked||v.curves[0].flight===s[0],M=v.curves.filter(()=>b).map(T=>{let B=document.createElementNS("http://www.w3.org/2000/svg","svg");B.setAttribute("viewBox","0 0 22 8"),B.setAttribute("aria-hidden","true");let H=document.createElementNS("http://www.w3.org/2000/svg","line"),V={x1:0,x2:22,y1:4,y2:4,stroke:T.fill??T.colour,"stroke-width":T.fill?8:2.4,"stroke-dasharray":(T.dash??[]).join(" ")};return Object.entries(V).forEach(([W,q])=>H.setAttribute(W,q)),B.append(H),G("span",{class:"plot-key"},B,G("span",{},T.name))}),y=G("div",{class:"plot-canvas"}),P=G("section",{class:"plot","data-panel":v.name},G("header",{},G("h3",{},`${v.name} [${v.unit}]`),G("div",{class:"plot-keys"},...M)),y);i.append(P);let E={box:P,canvas:y,panel:v,signature:c(v,g),bounds:null,zero:0},I={stroke:d.faint,grid:{stroke:d.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},D=v.stacked?[...v.curves].reverse():v.curves,S=(T,B)=>B.map(H=>String(g?+H.toFixed(3):Math.round(1e3*(H-E.zero)))),w=(T,B,H,V)=>AT(H,V,E.zero,g);return E.plot=new Kt({width:Math.max(y.clientWidth,200),height:Gv,padding:[6,10,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[{...I,size:22,gap:2,values:S,splits:w},{...I,size:46,gap:4,space:wT}],series:[{},...D.map(T=>({stroke:T.colour,width:T.fill?1:T.behind?1.4:1.8,dash:T.dash??[],fill:T.fill,spanGaps:!0,points:{show:!1}}))],hooks:{draw:[()=>f(E)]},bands:v.stacked?D.slice(1).map((T,B)=>({series:[B+1,B+2],fill:D[B].fill})):[]},u(v),y),E.marker=G("div",{class:"plot-now"}),E.plot.over.append(E.marker),E.plot.over.addEventListener("click",T=>e(E.plot.posToVal(T.offsetX,"x"))),t.set(v.name,E),E}function f({plot:v,marker:g}){if(!g)return;let{min:d,max:b}=v.scales.x;g.hidden=!(r>=d&&r<=b),g.style.transform=`translateX(${v.valToPos(r,"x")}px)`}function p(v){r=v,t.forEach(f)}function m(){for(let{plot:v,canvas:g}of t.values()){let d=g.clientWidth;d&&Math.abs(d-v.width)>1&&v.setSize({width:d,height:Gv})}p(r)}return new ResizeObserver(m).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{t.forEach(({plot:v,box:g})=>(v.destroy(),g.remove())),t.clear()}),{replace:l,show:p,pin(v){n=v},lock(v){a=v},bounds:v=>t.get(v)?.bounds,curve:v=>t.get(v)?.panel.curves.map(g=>({name:g.name,peak:g.values.reduce((d,b)=>Math.max(d,b),0),points:g.values.length})),get flights(){return s}}}function AT(i,e,t,n){let s=n?Gd((e-i)/8,[1,2,5,10]):.02,r=[];for(let o=Math.ceil((i-t*!n)/s);;o++){let a=o*s+(n?0:t);if(a>e)return r;r.push(a)}}var Yv=150,RT=700,CT=40;function $v(i,{choices:e,table:t,page:n,isShown:s,onPick:r,onChoice:o}){let a=new Map,l=null,c=null,u=null,h=null,f=0,p="",m=G("select",{id:"sweep-of","aria-label":"Control to sweep",onchange:E}),v=G("select",{id:"sweep-measure","aria-label":"Measure of the sweep",onchange:E},...e.measures.map(F=>G("option",{value:F.name},F.label)));v.value="impact_peak_acceleration";let g=G("div",{class:"plot-canvas"}),d=G("h3"),b=G("p",{class:"words",role:"status"});i.classList.add("sweep"),i.replaceChildren(G("div",{class:"sweep-head"},G("h2",{},"Sweep"),m,v),d,g,b),P();let M=F=>t.find(z=>z.name===F),y=()=>e.measures.find(F=>F.name===v.value);function P(){let F=m.value,z=e.controls.filter(ne=>s(ne.name)||ne.name===F),J=["",...z.map(ne=>ne.name)].join();m.dataset.names!==J&&(m.dataset.names=J,m.replaceChildren(G("option",{value:""},"off"),...z.map(ne=>G("option",{value:ne.name},ne.label))),m.value=F)}function E(){h=null,D(l,{}),o()}function I(F){return F.split("&").filter(z=>z&&z.split("=")[0]!==m.value).join("&")}function D(F,{moving:z=!1}){if(l=F,P(),clearTimeout(f),!l||!m.value)return T("");if(l.is_piloted)return T("Flights with a pilot are not swept here; a campaign can: springback campaign.");if(!s(m.value))return T("This control has no effect here.");let J=`${m.value}?${I(l.query)}`;a.has(J)?(c=a.get(J),w()):z||S(J),V(!a.has(J))}async function S(F){p=F;let[z,J]=F.split(/\?(.*)/s);b.textContent="Flying the sweep …";try{let ne=await fetch(`sweep?${[J,`of=${z}`].filter(Boolean).join("&")}`,{headers:{"x-lab-page":n}}),te=await ne.json();if(p!==F)return;if(ne.ok)a.size>=CT&&a.delete(a.keys().next().value),a.set(F,te),D(l,{});else if(ne.status===503){let ce=te.preparing;b.textContent=ce?`Compiling for ${ce.what}, about ${ce.about} s, once on this machine: ${Math.round(ce.waited)} s so far.`:"Too many requests are waiting.",f=setTimeout(()=>S(F),RT)}else te.overtaken||T(te.errors.join(" "))}catch{b.textContent="The lab does not respond."}}function w(){let F=c.refusals.reduce((te,ce)=>te+ce.count,0),z=Object.keys(c.labels).length>1?c.labels:{},J=te=>Number(te.toPrecision(3)),ne=c.refusals.map(({robot:te,from:ce,to:fe,why:xe})=>` ${z[te]?`${z[te]}, `:""}${ce===fe?"":`${J(ce)} to `}${J(fe)} ${M(c.of).unit}: ${xe}.`);b.textContent=F?`${F} of ${c.at.length*Object.keys(c.labels).length} points cannot be flown.${ne.join("")}`:`${c.at.length} flights for each robot in ${c.took.toFixed(0)} ms. A click sets the value.`}function T(F){p="",c=null,d.textContent="",u?.destroy(),u=null,b.textContent=F,i.classList.toggle("off",!m.value)}function B(){let F=l.measures.find(z=>z.name===v.value);return l.flights.map((z,J)=>({robot:z.robot,label:z.label,colour:kn().robots[H(J)],dash:J?[8,3]:[],x:l.settings[m.value],y:F?.values[z.robot]??null}))}let H=F=>l.flights.length===1&&l.flights[0].robot==="quad"?1:F%2;function V(F){if(i.classList.remove("off"),!c||c.of!==m.value)return u&&(u.destroy(),u=null);let z=B(),J=M(m.value),ne=z.map(xe=>c.measures[v.value][xe.robot]??c.at.map(()=>null)),te=[...ne.flat(),...z.map(xe=>xe.y)].filter(xe=>xe!==null);h=Wd(h,Math.min(0,...te),Math.max(0,...te));let ce=y();d.textContent=ce.unit?`${ce.label} [${ce.unit}]`:ce.label;let fe=JSON.stringify([J.name,v.value,z.map(xe=>[xe.label,xe.colour])]);u?.look!==fe&&W(J,z,fe),u.batch(()=>{u.setData([c.at,...ne],!1),u.setScale("x",{min:J.least,max:J.most}),u.setScale("y",{min:h[0],max:h[1]})}),u.points=z,g.classList.toggle("old",F),q()}function W(F,z,J){u?.destroy();let ne=kn(),te={stroke:ne.faint,grid:{stroke:ne.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ce=F.unit?` [${F.unit.replace("^1.5","¹·⁵")}]`:"",fe={...te,size:24,gap:6,label:`${F.label}${ce}`,labelSize:15,labelFont:te.font,labelGap:0};F.logarithmic&&Object.assign(fe,{splits:(xe,Ie,Q,X)=>PT(Q,X),values:(xe,Ie)=>Ie.map(String),filter:(xe,Ie)=>Ie}),u=new Kt({width:Math.max(g.clientWidth,200),height:Yv,padding:[8,12,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1,distr:F.logarithmic?3:1,range:[F.least,F.most]},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[fe,{...te,size:46,gap:4,space:26}],series:[{},...z.map(xe=>({stroke:xe.colour,width:1.8,dash:xe.dash,points:{show:!1}}))],hooks:{draw:[q]}},[[F.least,F.most],...z.map(()=>[null,null])],g),u.look=J,u.line=G("div",{class:"plot-now"}),u.dots=z.map(xe=>{let Ie=G("div",{class:"sweep-point",title:xe.label});return Ie.style.background=xe.colour,Ie}),u.over.append(u.line,...u.dots),u.over.addEventListener("click",xe=>r(F.name,u.posToVal(xe.offsetX,"x")))}function q(){if(!u?.points)return;let F=y();u.line.style.transform=`translateX(${u.valToPos(u.points[0].x,"x")}px)`,u.points.forEach(({x:z,y:J,label:ne},te)=>{let ce=u.dots[te];ce.hidden=J===null,J!==null&&(ce.title=`${ne}: ${Number(J.toPrecision(4))} ${F.unit}`,ce.style.transform=`translate(${u.valToPos(z,"x")}px, ${u.valToPos(J,"y")}px)`)})}return new ResizeObserver(()=>{let F=g.clientWidth;u&&F&&Math.abs(F-u.width)>1&&u.setSize({width:F,height:Yv})}).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>l&&D(l,{})),{show:D,hash:()=>m.value?`#sweep=${m.value},${v.value}`:"",restore(F){let[z,J]=(F.match(/^#sweep=([a-z_]+),([a-z_]+)$/)??[]).slice(1),ne=(te,ce)=>te.some(fe=>fe.name===ce);m.dataset.names="",m.replaceChildren(G("option",{value:""},"off"),...e.controls.map(te=>G("option",{value:te.name},te.label))),m.value=ne(e.controls,z)?z:"",ne(e.measures,J)&&(v.value=J),h=null,l&&D(l,{})},state:()=>({of:m.value,measure:v.value,curve:c,points:u?.points??[],bounds:h,words:b.textContent})}}function PT(i,e){let t=[];for(let n=Math.floor(Math.log10(i));n<=Math.log10(e);n++)for(let s of[1,2,5]){let r=Number((s*10**n).toPrecision(3));r>=i&&r<=e&&t.push(r)}return t}var Xd=i=>{if(i==null)return"–";if(typeof i=="string")return i;let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)};function Zv(i){function e(t,n,s){let r=t.flights.map(p=>[p.robot,p.label]),o=p=>n?.flights.some(m=>m.robot===p),a=t.measures.some(p=>Object.keys(p.printed).length),l=G("tr",{},G("th",{},""));for(let[p,[m,v]]of r.entries()){let g=G("th",{scope:"col"},v);g.style.color=s[p],l.append(g),a&&l.append(G("th",{scope:"col",class:"printed"},"paper")),o(m)&&l.append(G("th",{scope:"col",class:"pinned"},"pinned"))}let c=t.measures.map(p=>{let m=n?.measures.find(g=>g.name===p.name),v=G("tr",{"data-measure":p.name},G("th",{scope:"row"},p.label,...p.unit?[G("small",{},` ${p.unit}`)]:[]));for(let[g]of r){let d=[a&&p.printed[g]?`paper ${p.printed[g]}`:"",o(g)?`pinned ${Xd(m?.values[g])}`:""];v.append(G("td",{"data-robot":g,"data-beside":d.filter(Boolean).join(", ")},G("b",{},Xd(p.values[g])))),a&&v.append(G("td",{class:"printed"},p.printed[g]??"")),o(g)&&v.append(G("td",{class:"pinned"},Xd(m?.values[g])))}return v}),{words:u,same:h}=t.printed_for,f=a?[G("p",{class:h?"note":"note other"},h?u:`${u} The settings here differ.`)]:[];i.replaceChildren(G("table",{},G("thead",{},l),G("tbody",{},...c)),...f),i.classList.toggle("elsewhere",!h)}return{show:e}}var Kv={impact:"Impact",follow:"Follow",side:"Side",top:"Top",free:"All"},IT=.012,LT=350;function Jv(i,e){let t=Math.random().toString(36).slice(2),n=null,s=null,r=!1,o=[],a=Hv(e.controls,ce),l=G("div",{class:"outcomes","aria-live":"polite"}),c=G("p",{class:"alert",role:"alert",hidden:!0}),u=G("input",{class:"link",readonly:!0,"aria-label":"Link to these settings",id:"link",onfocus:()=>u.select()}),h=G("button",{type:"button",id:"copy",onclick:Me},"Copy link"),f=G("button",{type:"button",id:"pin","aria-pressed":"false",title:"Keep this flight behind the next ones for comparison",onclick:Ce},"Pin"),p=G("button",{type:"button",id:"reset",title:e.file?`Return to ${e.file}`:"Return to the paper's slider test",onclick:()=>se("",{push:!0})},"Reset"),m=G("span",{class:"files"}),v=G("div",{class:"stage"}),g=G("div",{class:"preparing",role:"status",hidden:!0}),d=G("div"),b=G("div"),M=G("div",{class:"measures"}),y=G("div"),P=G("button",{type:"button",id:"lock","aria-pressed":"false",title:"Keep the vertical scales of all plots as they are",onclick:me},"Lock y"),E=G("p",{class:"took"}),I=G("button",{type:"button",class:"drawer",id:"drawer","aria-expanded":"false",onclick:()=>ot(!i.classList.contains("open"))},"Settings"),D=wi("Camera",Vo.filter(re=>Kv[re]).map(re=>[re,Kv[re]]),"impact",re=>V.setCamera(re)),S=wi("Two robots",[["side","side by side"],["ghost","overlaid"]],"side",re=>V.setCompare(re)),w=G("h2"),T=wi("Plots show",[["impact","impact"],["all","all"]],"impact",re=>{r=re==="all",n&&Ie()}),B=yl(()=>H,()=>ve(["This browser refuses full screen."])),H=G("div",{class:"middle"},G("div",{class:"frame"},v,G("div",{class:"views"},D,S,B.button),g),d,M);i.classList.add("lab"),i.replaceChildren(G("header",{class:"top"},G("div",{class:"said"},G("h1",{},"Impact lab",...e.file?[G("small",{},e.file)]:[]),l,c),G("div",{class:"actions"},f,p,m,G("span",{class:"linking"},u,h))),G("main",{},G("aside",{class:"settings",id:"settings"},a.element,E),H,G("aside",{class:"curves"},y,G("div",{class:"plot-head"},w,P,T),b)),I);let V=iu(v,{onCamera:re=>D.mark(re)}),W=qv(b,{onSeek:re=>(q.pause(),q.seek(re))}),q=Gh({scene:V,plots:{show:W.show,replace:()=>Ie()},bar:d,actions:{f:B.toggle}}),F=Zv(M),z=$v(y,{choices:e.sweeps,table:e.controls,page:t,isShown:a.isShown,onPick:a.pick,onChoice:()=>n&&ht(n.query,{settled:!0})}),J=Vv(t,{answered:fe,refused:ye,waits:Ge,gone:dt}),ne=0,te=!1;function ce(re,ee,ue){clearTimeout(ne);let we=()=>J.ask(a.query(),{...ue,since:performance.now()});ue.typing?ne=setTimeout(we,LT):we()}function fe(re,ee){let ue=n;n=re,i.classList.add("ready"),ee.aside||ve([]),g.hidden=!0,ee.typing?a.tellProblems([]):a.show(re.settings);let we=!ue||ue.settings.mode!==re.settings.mode,C=re.flights.length!==ue?.flights.length,x=re.flights.flatMap(N=>N.second?[N.second]:[]);V.replace([...re.flights.map(N=>N.scene),...x],{keepCamera:!we&&!C}),S.hidden=re.flights.length<2,we&&T.mark((r=re.is_piloted)?"all":"impact"),te=!!ee.moving,q.replace({keepTime:!we}),we&&xe(),Q(),X(),z.show(re,ee),m.replaceChildren(...re.flights.map(N=>G("a",{class:"button",href:`scenario.toml?${[re.query,`of=${N.robot}`].filter(Boolean).join("&")}`,download:N.file,title:`Scenario for springback fly, ${N.label}`},`${N.label}.toml`))),ht(re.query,ee),requestAnimationFrame(()=>{let N=performance.now()-ee.since;o.push(N),E.textContent=`Flown in ${re.took.flying.toFixed(0)} ms, answered in ${re.took.all.toFixed(0)} ms, drawn after ${N.toFixed(0)} ms.`})}function xe(){let re=Cs(V.flights[0]),ee=!n.is_piloted,ue=ee?"impact":"follow";D.mark(ue),V.setCamera(ue),q.seek(re===null?V.flights[0].begin:ee?re+IT:re)}function Ie(){n&&(w.textContent=r?"Time [s]":"Time from touch [ms]",W.replace(V.flights,{whole:r,moving:te}))}function Q(){l.replaceChildren(...n.flights.map((re,ee)=>{let ue=G("p",{class:`outcome ${re.well?"well":"badly"}`},G("b",{},re.label),re.sentence.slice(re.label.length));return ue.style.setProperty("--colour",V.flights[ee].colour),ue}))}let X=()=>F.show(n,s,V.flights.map(re=>re.colour));function me(){let re=P.getAttribute("aria-pressed")!=="true";P.setAttribute("aria-pressed",String(re)),W.lock(re),Ie()}function ve(re){c.hidden=!re.length,c.textContent=re.join(" ")}function ye(re,ee){g.hidden=!0,a.tellProblems(re),ve([...re.map(ue=>`${ue}.`),n?"The previous flight is shown.":"The default flight is shown instead."]),n||J.ask("",{since:performance.now(),aside:!0})}function Ge(re){g.hidden=!1,g.replaceChildren(G("progress",{}),G("p",{},`Compiling for ${re.what}, about ${re.about} s: ${Math.round(re.waited)} s so far.`),G("p",{class:"words"},`Once on this machine; ${n?"the previous flight stays, and ":""}other settings can be flown meanwhile if they are ready.`))}function dt(){ve(["The lab does not respond; it may have been stopped in its terminal. Any change tries again."])}let k=!1;function ht(re,{settled:ee=!1,aside:ue=!1,restored:we=!1}){let C=`${location.pathname}${re?`?${re}`:""}${z.hash()}`;u.value=location.origin+C,!(ue||we)&&(`${location.pathname}${location.search}${location.hash}`!==C&&(k?history.replaceState(null,"",C):history.pushState(null,"",C)),k=!ee)}function se(re,{push:ee=!1}={}){J.ask(re,{since:performance.now(),settled:ee,restored:!ee})}addEventListener("popstate",()=>(z.restore(location.hash),se(location.search.slice(1))));async function Me(){try{await navigator.clipboard.writeText(u.value)}catch{u.select(),document.execCommand("copy")}h.textContent="Copied",setTimeout(()=>h.textContent="Copy link",1500)}function Ce(){s=s?null:n,f.setAttribute("aria-pressed",String(!!s)),f.textContent=s?"Unpin":"Pin";let re=s?kd(s.flights.map(ee=>({...ee.scene})),kn()):[];W.pin(re),Ie(),X()}function ot(re){i.classList.toggle("open",re),I.setAttribute("aria-expanded",String(re)),I.textContent=re?"Done":"Settings",re&&v.scrollIntoView({block:"start"})}return a.show(Object.fromEntries(e.controls.map(re=>[re.name,re.default]))),z.restore(location.hash),se(location.search.slice(1)),window.springback={scene:V,player:q,plots:W,controls:a,sweep:z,latency:o,pose:()=>({...V.pose(),playing:q.playing,pace:q.pace}),get answer(){return n}},window.springback}var DT={replay:Bv,lab:Jv};function jv(){let i=DT[document.body.dataset.app],e=document.getElementById("data");i&&i(document.getElementById("app"),e?JSON.parse(e.textContent):{})}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",jv):jv();})();
