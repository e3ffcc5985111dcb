/*! springback, MIT licence; sources 3fbce555ac549546bb5c5f31a3108b6dc09b1cec09a24caf6041ba7213a2f62e

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
(()=>{var Gd=i=>{throw TypeError(i)};var B_=(i,t,e)=>t.has(i)||Gd("Cannot "+e);var Wd=(i,t,e)=>t.has(i)?Gd("Cannot add the same private member more than once"):t instanceof WeakSet?t.add(i):t.set(i,e);var Xd=(i,t,e)=>(B_(i,t,"access private method"),e);function $(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))s.startsWith("on")?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==!1&&r!=null&&n.setAttribute(s,r);return n.append(...e),n}var z_={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",back:"M18 5v14l-9.5-7zM5.5 5h2.4v14H5.5z",forth:"M6 5v14l9.5-7zM16.1 5h2.4v14h-2.4z",touch:"M4 4h3v16H4zM20 12l-9 6V6z",link:"M10.6 13.4a4 4 0 0 0 5.7 0l3-3a4 4 0 1 0-5.7-5.7l-1.6 1.6 1.4 1.4 1.6-1.6a2 2 0 1 1 2.9 2.9l-3 3a2 2 0 0 1-2.9 0zm2.8-2.8a4 4 0 0 0-5.7 0l-3 3a4 4 0 1 0 5.7 5.7l1.6-1.6-1.4-1.4-1.6 1.6a2 2 0 1 1-2.9-2.9l3-3a2 2 0 0 1 2.9 0z",picture:"M4 7h4l1.5-2.5h5L16 7h4v12H4zm8 2.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zm0 1.8a1.7 1.7 0 1 1 0 3.4 1.7 1.7 0 0 1 0-3.4z",undo:"M9 4 3.5 9.5 9 15v-4h5a3.5 3.5 0 0 1 0 7h-4v2.2h4a5.7 5.7 0 0 0 0-11.4H9z",film:"M3 6h12v12H3zM16.5 10.5 21 7.5v9l-4.5-3z",full:"M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z",help:"M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 12.5h2v2h-2zm1-9c-2 0-3.5 1.3-3.5 3.2h2c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.4-2.5 1.6-2.5 4.1v.3h2v-.2c0-1.4 2.5-1.8 2.5-4.3 0-1.8-1.5-3-3.5-3z"};function Es(i){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidden","true");let e=document.createElementNS("http://www.w3.org/2000/svg","path");return e.setAttribute("d",z_[i]),e.setAttribute("fill-rule","evenodd"),t.append(e),t}function yi(i,t,e,n){let s=$("div",{class:"choice",role:"group","aria-label":i});for(let[a,l]of t)s.append($("button",{type:"button","data-value":a,"aria-pressed":String(a===e),onclick:()=>{r(a),n(a)}},l));function r(a){for(let l of s.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))}let o=a=>(r(a),n(a));return Object.defineProperty(s,"chosen",{get:()=>s.querySelector("[aria-pressed=true]")?.dataset.value}),Object.assign(s,{mark:r,press:o})}function qd(i,t,e,n=""){let s=$("button",{type:"button",title:n,"aria-pressed":String(t),onclick:()=>{s.setAttribute("aria-pressed",String(!s.on)),e(s.on)}},i);return Object.defineProperty(s,"on",{get:()=>s.getAttribute("aria-pressed")==="true"}),s}var k_=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"],H_=30;function Yd(i,t){let e=$("a",{href:URL.createObjectURL(i),download:t});e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function nu(i,t,e,n=null){let s=t.getBoundingClientRect(),r=getComputedStyle(t);if(!s.width)return;let[o,a]=[s.left-e.left,s.top-e.top];i.fillStyle=r.backgroundColor,i.fillRect(o,a,s.width,s.height);let l=o+parseFloat(r.paddingLeft);if(n&&parseFloat(n.width)>0){let c=parseFloat(n.height);i.fillStyle=n.backgroundColor,i.fillRect(l,a+(s.height-c)/2,parseFloat(n.width),c),l+=parseFloat(n.width)+parseFloat(n.marginRight)}i.font=`${r.fontWeight} ${r.fontSize} ${r.fontFamily}`,i.textBaseline="middle",i.fillStyle=r.color,i.fillText(t.textContent,l,a+s.height/2+1)}function $d({scene:i,stage:t,player:e,name:n,say:s,onRecording:r=()=>{}}){let o=$("div",{class:"stage-clock","aria-hidden":"true"});t.append(o);let a=null,l=null;function c(){let d=Math.min(devicePixelRatio||1,2),m=$("canvas",{width:2*Math.round(t.clientWidth*d/2),height:2*Math.round(t.clientHeight*d/2)});return{canvas:m,pen:m.getContext("2d"),ratio:d}}function u({canvas:d,pen:m,ratio:_},g){o.textContent=`${i.pose().t.toFixed(4)} s`;let p=t.getBoundingClientRect();m.setTransform(1,0,0,1,0,0),m.drawImage(g,0,0,d.width,d.height),m.scale(_,_);let A=t.querySelector(".scene-legend"),S=A.getBoundingClientRect();m.fillStyle=getComputedStyle(A).backgroundColor,m.fillRect(S.left-p.left,S.top-p.top,S.width,S.height);for(let x of A.children)nu(m,x,p,getComputedStyle(x,"::before"));for(let x of t.querySelectorAll(".force-labels span:not([hidden])"))nu(m,x,p);nu(m,o,p)}function h(){let d=i.canvas();if(!d)return s("There is no picture without WebGL.");let m=c();u(m,d),m.canvas.toBlob(_=>{Yd(_,`${n}-${i.pose().t.toFixed(4)}s.png`),s("The picture is among your downloads.")})}function f(){if(a)return a.stop();let d=window.MediaRecorder&&k_.find(_=>MediaRecorder.isTypeSupported(_));if(!d||!i.canvas()||!HTMLCanvasElement.prototype.captureStream)return s("This browser cannot record films. The command springback animate RESULT --out film.gif makes one, or film.mp4.");l=c(),u(l,i.canvas());let m=[];a=new MediaRecorder(l.canvas.captureStream(H_),{mimeType:d,videoBitsPerSecond:12e6}),a.ondataavailable=_=>m.push(_.data),a.onstop=()=>{[a,l]=[null,null],e.pause(),r(!1),Yd(new Blob(m,{type:d}),`${n}.${d.includes("mp4")?"mp4":"webm"}`),s("The film is among your downloads. springback animate makes one without dropped frames.")},a.start(),r(!0),e.play()}return{picture:h,film:f,drawn(){l&&u(l,i.canvas(!1))},rested(){a?.state==="recording"&&!e.playing&&a.stop()},get recording(){return!!a}}}var V_=()=>matchMedia("(prefers-color-scheme: dark)").matches,G_={background:"#f3f5f8",ink:"#222222",faint:"#8c8c8c",line:"#c3cad4",wall:"#7d8794",mat:"#009e73",ground:"#a8aeb7",metal:"#5b6470",dark:"#30363d",arms:["#0072b2","#d98a00","#009e73","#cc79a7","#3a9bd9","#8c8c8c"],robots:["#0072b2","#d55e00","#007a5a","#a8488a","#8a6d00","#1b2a6b","#6b6b6b","#7a1f1f"],force:"#e69f00",thrust:"#56b4e9",before:"#8c8c8c"},W_={background:"#14181d",ink:"#e6e9ed",faint:"#9aa3ad",line:"#3a434e",wall:"#98a3b1",mat:"#2cc79a",ground:"#59626d",metal:"#aab4c0",dark:"#cdd4dc",arms:["#4ea8e0","#f0b429","#35c79b","#e29cc4","#8fd0f5","#a7b0ba"],robots:["#4ea8e0","#ff8a3d","#35c79b","#e29cc4","#e3cf57","#a9b4ff","#c9d1d9","#ff8f8f"],force:"#ffc13d",thrust:"#7cc8f2",before:"#a7b0ba"},Un=()=>V_()?W_:G_;var ci=Uint8Array,Fr=Uint16Array,X_=Int32Array,Zd=new ci([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Jd=new ci([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),q_=new ci([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Kd=function(i,t){for(var e=new Fr(31),n=0;n<31;++n)e[n]=t+=1<<i[n-1];for(var s=new X_(e[30]),n=1;n<30;++n)for(var r=e[n];r<e[n+1];++r)s[r]=r-e[n]<<5|n;return{b:e,r:s}},jd=Kd(Zd,2),Qd=jd.b,Y_=jd.r;Qd[28]=258,Y_[258]=28;var tp=Kd(Jd,0),$_=tp.b,VE=tp.r,ru=new Fr(32768);for(we=0;we<32768;++we)is=(we&43690)>>1|(we&21845)<<1,is=(is&52428)>>2|(is&13107)<<2,is=(is&61680)>>4|(is&3855)<<4,ru[we]=((is&65280)>>8|(is&255)<<8)>>1;var is,we,Ho=(function(i,t,e){for(var n=i.length,s=0,r=new Fr(t);s<n;++s)i[s]&&++r[i[s]-1];var o=new Fr(t);for(s=1;s<t;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(e){a=new Fr(1<<t);var l=15-t;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],u=t-i[s],h=o[i[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[ru[h]>>l]=c}else for(a=new Fr(n),s=0;s<n;++s)i[s]&&(a[s]=ru[o[i[s]-1]++]>>15-i[s]);return a}),Vo=new ci(288);for(we=0;we<144;++we)Vo[we]=8;var we;for(we=144;we<256;++we)Vo[we]=9;var we;for(we=256;we<280;++we)Vo[we]=7;var we;for(we=280;we<288;++we)Vo[we]=8;var we,ep=new ci(32);for(we=0;we<32;++we)ep[we]=5;var we;var Z_=Ho(Vo,9,1);var J_=Ho(ep,5,1),iu=function(i){for(var t=i[0],e=1;e<i.length;++e)i[e]>t&&(t=i[e]);return t},bi=function(i,t,e){var n=t/8|0;return(i[n]|i[n+1]<<8)>>(t&7)&e},su=function(i,t){var e=t/8|0;return(i[e]|i[e+1]<<8|i[e+2]<<16)>>(t&7)},K_=function(i){return(i+7)/8|0},j_=function(i,t,e){return(t==null||t<0)&&(t=0),(e==null||e>i.length)&&(e=i.length),new ci(i.subarray(t,e))};var Q_=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Mi=function(i,t,e){var n=new Error(t||Q_[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Mi),!e)throw n;return n},tv=function(i,t,e,n){var s=i.length,r=n?n.length:0;if(!s||t.f&&!t.l)return e||new ci(0);var o=!e,a=o||t.i!=2,l=t.i;o&&(e=new ci(s*3));var c=function(ft){var Jt=e.length;if(ft>Jt){var C=new ci(Math.max(Jt*2,ft));C.set(e),e=C}},u=t.f||0,h=t.p||0,f=t.b||0,d=t.l,m=t.d,_=t.m,g=t.n,p=s*8;do{if(!d){u=bi(i,h,1);var A=bi(i,h+1,3);if(h+=3,A)if(A==1)d=Z_,m=J_,_=9,g=5;else if(A==2){var T=bi(i,h,31)+257,P=bi(i,h+10,15)+4,L=T+bi(i,h+5,31)+1;h+=14;for(var M=new ci(L),b=new ci(19),E=0;E<P;++E)b[q_[E]]=bi(i,h+E*3,7);h+=P*3;for(var O=iu(b),B=(1<<O)-1,H=Ho(b,O,1),E=0;E<L;){var W=H[bi(i,h,B)];h+=W&15;var S=W>>4;if(S<16)M[E++]=S;else{var Z=0,k=0;for(S==16?(k=3+bi(i,h,3),h+=2,Z=M[E-1]):S==17?(k=3+bi(i,h,7),h+=3):S==18&&(k=11+bi(i,h,127),h+=7);k--;)M[E++]=Z}}var G=M.subarray(0,T),tt=M.subarray(T);_=iu(G),g=iu(tt),d=Ho(G,_,1),m=Ho(tt,g,1)}else Mi(1);else{var S=K_(h)+4,x=i[S-4]|i[S-3]<<8,I=S+x;if(I>s){l&&Mi(0);break}a&&c(f+x),e.set(i.subarray(S,I),f),t.b=f+=x,t.p=h=I*8,t.f=u;continue}if(h>p){l&&Mi(0);break}}a&&c(f+131072);for(var ot=(1<<_)-1,rt=(1<<g)-1,ut=h;;ut=h){var Z=d[su(i,h)&ot],lt=Z>>4;if(h+=Z&15,h>p){l&&Mi(0);break}if(Z||Mi(2),lt<256)e[f++]=lt;else if(lt==256){ut=h,d=null;break}else{var Pt=lt-254;if(lt>264){var E=lt-257,Lt=Zd[E];Pt=bi(i,h,(1<<Lt)-1)+Qd[E],h+=Lt}var K=m[su(i,h)&rt],V=K>>4;K||Mi(3),h+=K&15;var tt=$_[V];if(V>3){var Lt=Jd[V];tt+=su(i,h)&(1<<Lt)-1,h+=Lt}if(h>p){l&&Mi(0);break}a&&c(f+131072);var pt=f+Pt;if(f<tt){var Et=r-tt,bt=Math.min(tt,pt);for(Et+f<0&&Mi(3);f<bt;++f)e[f]=n[Et+f]}for(;f<pt;++f)e[f]=e[f-tt]}}t.l=d,t.p=ut,t.b=f,t.f=u,d&&(u=1,t.m=_,t.d=m,t.n=g)}while(!u);return f!=e.length&&o?j_(e,0,f):e.subarray(0,f)};var ev=new ci(0);var nv=function(i,t){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Mi(6,"invalid zlib data"),(i[1]>>5&1)==+!t&&Mi(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function np(i,t){return tv(i.subarray(nv(i,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var iv=typeof TextDecoder<"u"&&new TextDecoder,sv=0;try{iv.decode(ev,{stream:!0}),sv=1}catch{}var ip=i=>Uint8Array.from(atob(i),t=>t.charCodeAt(0));function rv(i,t){let e=np(ip(i.data));return i.columns.map(({low:n,step:s},r)=>{let o=2*t*r,a=new Float64Array(t);for(let l=0,c=0;l<t;l++)c=c+e[o+l]+256*e[o+t+l]&65535,a[l]=n+s*c;return a})}function sp(i){let t=new Map;if(!i)return t;for(let e of["trajectory","telemetry"].filter(n=>i[n])){let n=i[e],s=new Float64Array(ip(n.t.data).buffer),r=null;n.columns.forEach(({name:o,unit:a,group:l},c)=>t.set(o,{name:o,unit:a,group:l,t:s,held:e==="telemetry",words:i.words[o],get values(){return r??(r=rv(n,s.length)),r[c]}}))}return t}var ov={f4:Float32Array,f8:Float64Array,i4:Int32Array};function Si(i){let t=Uint8Array.from(atob(i.data),e=>e.charCodeAt(0));return new ov[i.type](t.buffer)}function rp(i){if(i.ready)return i;let t=Si(i.t),e=Si(i.force.at),n=new Int32Array(t.length).fill(-1);return e.forEach((s,r)=>n[s]=r),{...i,ready:!0,t,n:t.length,begin:t[0],end:t[t.length-1],position:Si(i.position),attitude:Si(i.attitude),armLength:Si(i.arm_length),thrust:Si(i.thrust),force:Si(i.force.of),point:Si(i.point.of),rows:n,series:i.series.map(s=>({...s,values:Si(s.values)})),signals:sp(i.signals),every:i.signals?.telemetry?.every??1,shift:0}}function ll(i,t){let e=0,n=i.length-1;if(!(t>i[0]))return 0;for(;n-e>1;){let s=e+n>>1;i[s]<=t?e=s:n=s}return i[n]<=t?n:e}function Go(i,t){let e=Math.min(Math.max(t-i.shift,i.begin),i.end),n=ll(i.t,e),s=Math.min(n+1,i.n-1),r=s>n?(e-i.t[n])/(i.t[s]-i.t[n]):0,o=(g,p,A)=>g[n*p+A]*(1-r)+g[s*p+A]*r,a=(g,p)=>Array.from({length:p},(A,S)=>o(g,p,S)),l=i.arms.length,c=l+i.hull.length,u=a(i.attitude,4),h=0;for(let g=0;g<4;g++)h+=i.attitude[n*4+g]*i.attitude[s*4+g];if(h<0)for(let g=0;g<4;g++)u[g]=i.attitude[n*4+g];let f=Math.hypot(...u),d=i.rows[n],m=i.rows[s],_=[];for(let g=0;g<c;g++){let p=[0,0,0],A=null;for(let[x,I]of[[d,1-r],[m,r]]){if(x<0)continue;let T=(x*c+g)*3;for(let L=0;L<3;L++)p[L]+=I*i.force[T+L];let P=Array.from(i.point.subarray(T,T+3));P.some(L=>L!==0)&&(A=P)}let S=Math.hypot(...p);_.push(A&&S>1e-6?{force:p,size:S,point:A}:null)}return{t:e+i.shift,own:e,place:n,position:a(i.position,3),quaternion:u.map(g=>g/f),armLengths:a(i.armLength,l),thrust:a(i.thrust,l),contacts:_}}function Wo({flight:i,t=i.t,values:e,held:n=!1},s){let r=Math.min(Math.max(s-i.shift,t[0]),t[t.length-1]),o=ll(t,r),a=n?o:Math.min(o+1,t.length-1),l=a>o?(r-t[o])/(t[a]-t[o]):0;return e[o]*(1-l)+e[a]*l}var Or=i=>["est_x","est_qw"].every(t=>i.signals.has(t));function ou(i,t){let e=(r,o)=>{let a=i.signals.get(r);return a?Wo({flight:i,...a,values:a.values},t):o},n=["w","x","y","z"].map(r=>e(`est_q${r}`)),s=Math.hypot(...n)||1;return{own:Math.min(Math.max(t-i.shift,i.begin),i.end),position:["x","y","z"].map(r=>e(`est_${r}`)),quaternion:n.map(r=>r/s),armLengths:i.arms.map((r,o)=>e(`hall${o+1}`,r.length)),thrust:i.arms.map(()=>0),contacts:[]}}var Vi=i=>i.impacts.length?i.impacts[0][0]+i.shift:null,cl=i=>i.map(Vi).find(t=>t!==null)??null;function au(i){let t=0;for(let e=0;e<i.force.length;e+=3)t=Math.max(t,Math.hypot(i.force[e],i.force[e+1],i.force[e+2]));return t}function op(i){let t=i.arms.length+i.hull.length;return Float32Array.from(i.rows,e=>{let n=[0,0,0];for(let s=0;e>=0&&s<3*t;s++)n[s%3]+=i.force[e*t*3+s];return Math.hypot(...n)})}function lu(i){if(!(i>0))return 1;let t=10**Math.floor(Math.log10(i));return t*([5,2,1].find(e=>e*t<=i*1.0000001)??1)}var av=.005,Br=[[],[7,3],[2,3],[9,3,2,3],[12,4],[4,2,1,2],[14,3,2,3],[3,6]],ap={"Arm compression":["largest",i=>Math.max(...i)],Thrust:["all rotors",i=>i.reduce((t,e)=>t+e,0)],Velocity:["speed",i=>i[0]],Energy:["motion",i=>i[0]],"Contact force":["sum of all contacts"]},js=i=>[...new Set(i.flatMap(t=>t.series.map(e=>e.panel)))],hl=i=>new Map(i.flatMap(t=>[...t.signals])),Xo=i=>i.map(t=>Array.isArray(t)?t.join():t).join(";");function cu(i,t){let e=js(t),n=hl(t);return i.split(";").flatMap(s=>e.includes(s)?[s]:ul(s.split(",").filter(r=>n.has(r)),n))}function ul(i,t){let e=new Map;for(let n of new Set(i)){let{unit:s,words:r}=t.get(n),o=r?n:s;e.set(o,[...e.get(o)??[],n])}return[...e.values()]}function lp(i,t){return t.map(e=>Array.isArray(e)?cv(i,e):lv(i,e)).filter(e=>e.curves.length)}function lv(i,t){let e=Un(),n=i.map(o=>o.series.filter(a=>a.panel===t)),s=i.length>1?n.flatMap((o,a)=>hv(t,o,i[a])):uv(n[0]);s.forEach((o,a)=>{o.flight??(o.flight=i[0]),o.t=o.flight.t,o.colour??(o.colour=e.arms[a%e.arms.length]),o.dash??(o.dash=Br[a%Br.length])});let r=i.length>1?ap[t]?.[0]:"";return{key:t,name:r?`${t}, ${r}`:t,unit:n.flat()[0]?.unit,own:null,curves:s}}function cv(i,t){let e=Un(),n=hl(i),s=i.length>1,r=t.flatMap((c,u)=>i.flatMap(h=>{let f=h.signals.get(c);if(!f)return[];let{t:d,values:m,held:_}=f,g=s&&t.length===1?h.index:u;return[{name:s?t.length===1?h.label:`${h.label}, ${c}`:c,flight:h,t:d,values:m,held:_,dash:Br[g%Br.length],colour:s?h.colour:e.arms[u%e.arms.length]}]})),o=t.map(c=>n.get(c)),a=new Set(o.map(c=>c?.group)),l=t.length===1?t[0]:a.size===1?o[0].group:t.slice(0,3).join(", ")+(t.length>3?", …":"");return{key:t.join(),name:l,unit:o[0]?.unit,own:t,words:o[0]?.words,curves:r}}function hv(i,t,e){if(!t.length)return[];let[,n]=ap[i]??["",r=>r[0]],s=i==="Contact force"?op(e):Float32Array.from(t[0].values,(r,o)=>n(t.map(a=>a.values[o])));return[{name:e.label,values:s,flight:e,colour:e.colour,dash:Br[e.index%Br.length]}]}function uv(i){let t=[];for(let e of i){let n=e.values.reduce((r,o)=>Math.max(r,Math.abs(o)),0),s=t.find(r=>{let o=av*Math.max(n,r.peak);return r.values.every((a,l)=>Math.abs(a-e.values[l])<=o)});s?s.names.push(e.name):t.push({names:[e.name],values:e.values,peak:n})}return t.map(({names:e,values:n})=>({name:fv(e),values:n}))}function fv(i){let t=i.map(e=>e.match(/^(.*?)\s*(\d+)$/));return i.length<2||t.some(e=>!e||e[1]!==t[0][1])?i.join(", "):`${t[0][1]} ${t.map(e=>e[2]).join(", ")}`}function cp({signals:i,standard:t,onChoose:e}){let n=$("input",{type:"search",placeholder:"est, N, phase, …","aria-label":"Search signals",oninput:A}),s=$("h2",{id:"chooser-title"}),r=$("span",{class:"count",role:"status"}),o=(T,P,L)=>$("label",{"data-words":`${T} ${P}`.toLowerCase()},$("input",{type:"checkbox",value:T,onchange:S}),T,...L?[$("small",{},L)]:[]),a=(T,...P)=>{let L=$("fieldset",{},$("legend",{},T),...P);return P.length>1&&L.firstChild.append($("button",{type:"button",class:"small","aria-label":`All of ${T}, or none`,onclick:()=>{let M=[...L.querySelectorAll("label:not([hidden]) input")],b=!M.every(E=>E.checked);M.forEach(E=>E.checked=b),S()}},"all")),L},l=a("Standard plots",...t.map(T=>o(T,"standard"))),c=new Map;for(let{name:T,unit:P,group:L}of i.values()){let M=[L,P,P==="m/s²"?"acceleration":""].join(" ");c.set(L,[...c.get(L)??[],o(T,M,P)])}let u=$("div",{class:"signals"},l,...[...c].map(([T,P])=>a(T,...P))),h=$("p",{hidden:!0},"No signal of this flight matches."),f=$("form",{method:"dialog",onsubmit:x},s,$("p",{class:"hint"},"Signals of one unit share a plot. Names are those of the columns in the files of the result."),n,u,h,$("div",{class:"actions"},r,$("button",{type:"button",onclick:()=>(e(null),d.close())},"Only standard plots"),$("button",{type:"button",onclick:()=>d.close()},"Cancel"),$("button",{type:"submit",class:"main"},"Plot"))),d=$("dialog",{class:"chooser","aria-labelledby":"chooser-title"},f),m=[],_=null,g=T=>[...T.querySelectorAll("input[type=checkbox]:checked")].map(P=>P.value),p=()=>[...u.children].filter(T=>T!==l).flatMap(g);function A(){let T=n.value.toLowerCase().split(/\s+/).filter(Boolean);for(let P of u.children){let L=[...P.querySelectorAll("label")];L.forEach(M=>M.hidden=!T.every(b=>M.dataset.words.includes(b))),P.hidden=L.every(M=>M.hidden)||P===l&&_!==null}h.hidden=[...u.children].some(P=>!P.hidden)}function S(){let T=p(),P=ul(T,i).length;r.textContent=T.length?`${T.length} signal${T.length>1?"s":""} in ${P} plot${P>1?"s":""}`:""}function x(){let T=ul(p(),i);if(_!==null)e(m.flatMap((P,L)=>L===_?T:[P]));else{let P=g(l),L=m.filter(M=>Array.isArray(M)||P.includes(M));e([...L,...P.filter(M=>!m.includes(M)),...T])}}function I(T,P=null){[m,_]=[T,P];let L=P===null?T.filter(M=>!Array.isArray(M)):T[P];u.querySelectorAll("input").forEach(M=>M.checked=L.includes(M.value)),s.textContent=P===null?"Add plots":"Change a plot",n.value="",A(),S(),d.showModal(),n.focus()}return{element:d,open:I}}function hp({read:i,apply:t}){let e=0,n=location.hash,s=()=>{let a=Object.entries(i()).filter(([,l])=>l!=="");return`#${new URLSearchParams(a)}`.replace(/%2C/g,",").replace(/%3B/g,";")};function r(){clearTimeout(e),n=s();try{history.replaceState(null,"",n)}catch{}}addEventListener("hashchange",()=>{location.hash!==n&&o()});function o(){t(Object.fromEntries(new URLSearchParams(location.hash.slice(1))))}return{follow:o,renew(){clearTimeout(e),e=setTimeout(r,250)},address(){return r(),location.href.replace(/#.*/,"")+n}}}function dv(i){let t=[];for(let n of i)for(let[s,r]of n.impacts.slice(0,12)){let o=s+n.shift-.008;t.push([o,Math.min(r,s+.12)+n.shift+.02])}t.sort((n,s)=>n[0]-s[0]);let e=[];for(let n of t){let s=e[e.length-1];s&&n[0]<s[1]+2*.12?s[1]=Math.max(s[1],n[1]):e.push([...n])}return e.map(([n,s])=>[n,s,Math.min(1,Math.max(.005,(s-n)/3))])}function hu(i,t){let e=1;for(let[n,s,r]of i){let o=Math.max(n-t,t-s,0);o<.12&&(e=Math.min(e,r**((1+Math.cos(Math.PI*o/.12))/2)))}return e}function fp(i){let t=Math.min(...i.map(l=>l.begin+l.shift)),e=Math.max(...i.map(l=>l.end+l.shift)),n=dv(i),s=new Set([t,e]);for(let l=1;l<200;l++)s.add(t+(e-t)*l/200);for(let[l,c]of n)for(let u=0;u<=60;u++)s.add(l-.12+(c-l+2*.12)*u/60),s.add(l+(c-l)*u/60),s.add(l-.12*u/60),s.add(c+.12*u/60);let r=[...s].filter(l=>l>=t&&l<=e).sort((l,c)=>l-c),o=[0];for(let l=1;l<r.length;l++){let c=Math.sqrt(hu(n,r[l-1])*hu(n,r[l]));o.push(o[l-1]+(r[l]-r[l-1])/c)}let a=o[o.length-1]||1;return{begin:t,end:e,stretches:n,total:a,paceAt:l=>hu(n,l),watchedAt:l=>up(r,o,l),timeAt:l=>up(o,r,l)}}function up(i,t,e){let n=0,s=i.length-1;if(!(e>i[0]))return t[0];if(e>=i[s])return t[s];for(;s-n>1;){let r=n+s>>1;i[r]<=e?n=r:s=r}return t[n]+(t[s]-t[n])*(e-i[n])/(i[s]-i[n])}var pv="uplot",mv="u-hz",gv="u-vt",_v="u-title",vv="u-wrap",xv="u-under",yv="u-over",bv="u-axis",er="u-off",Mv="u-select",Sv="u-cursor-x",wv="u-cursor-y",Ev="u-cursor-pt",Tv="u-legend",Av="u-live",Cv="u-inline",Rv="u-series",Pv="u-marker",dp="u-label",Iv="u-value",Yo="width",$o="height";var pp="bottom",zr="left",uu="right",Cu="#000",mp=Cu+"0",fu="mousemove",gp="mousedown",du="mouseup",_p="mouseenter",vp="mouseleave",xp="dblclick",Lv="resize",Dv="scroll",yp="change",gl="dppxchange",Ru="--",qr=typeof window<"u",vu=qr?document:null,Hr=qr?window:null,Uv=qr?navigator:null,Ee,fl;function xu(){let i=devicePixelRatio;Ee!=i&&(Ee=i,fl&&bu(yp,fl,xu),fl=matchMedia(`(min-resolution: ${Ee-.001}dppx) and (max-resolution: ${Ee+.001}dppx)`),nr(yp,fl,xu),Hr.dispatchEvent(new CustomEvent(gl)))}function Kn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function yu(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function We(i,t,e){i.style[t]=e+"px"}function wi(i,t,e,n){let s=vu.createElement(i);return t!=null&&Kn(s,t),e?.insertBefore(s,n),s}function hi(i,t){return wi("div",i,t)}var bp=new WeakMap;function Gi(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=bp.get(i);r!=o&&(i.style.transform=r,bp.set(i,r),t<0||e<0||t>n||e>s?Kn(i,er):yu(i,er))}var Mp=new WeakMap;function Sp(i,t,e){let n=t+e,s=Mp.get(i);n!=s&&(Mp.set(i,n),i.style.background=t,i.style.borderColor=e)}var wp=new WeakMap;function Ep(i,t,e,n){let s=t+""+e,r=wp.get(i);s!=r&&(wp.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Pu={passive:!0},Nv={...Pu,capture:!0};function nr(i,t,e,n){t.addEventListener(i,e,n?Nv:Pu)}function bu(i,t,e,n){t.removeEventListener(i,e,Pu)}qr&&xu();function Ei(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:jn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Qp(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var tm=i=>i!=null,em=i=>i!=null&&i>0,xl=Qp(tm),Fv=Qp(em);function Ov(i,t,e,n=0,s=!1){let r=s?Fv:xl,o=s?em:tm;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Fe,l??-Fe]}function yl(i,t,e,n){let s=Cp(i),r=Cp(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?ss:nm,a=s==1?jn:ui,l=r==1?ui:jn,c=a(o(sn(i))),u=l(o(sn(t))),h=Vr(e,c),f=Vr(e,u);return e==10&&(c<0&&(h=Oe(h,-c)),u<0&&(f=Oe(f,-u))),n||e==2?(i=h*s,t=f*r):(i=om(i,h),t=bl(t,f)),[i,t]}function Iu(i,t,e,n){let s=yl(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Lu=.1,Tp={mode:3,pad:Lu},Jo={pad:0,soft:null,mode:0},Bv={min:Jo,max:Jo};function _l(i,t,e,n){return Ml(e)?Ap(i,t,e):(Jo.pad=e,Jo.soft=n?0:null,Jo.mode=n?3:0,Ap(i,t,Bv))}function Me(i,t){return i??t}function zv(i,t,e){for(t=Me(t,0),e=Me(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Ap(i,t,e){let n=e.min,s=e.max,r=Me(n.pad,0),o=Me(s.pad,0),a=Me(n.hard,-Fe),l=Me(s.hard,Fe),c=Me(n.soft,Fe),u=Me(s.soft,-Fe),h=Me(n.mode,0),f=Me(s.mode,0),d=t-i,m=ss(d),_=Nn(sn(i),sn(t)),g=ss(_),p=sn(g-m);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,h==2&&c!=Fe&&(r=0),f==2&&u!=-Fe&&(o=0)));let A=d||_||1e3,S=ss(A),x=Vr(10,jn(S)),I=A*(d==0?i==0?.1:1:r),T=Oe(om(i-I,x/10),24),P=i>=c&&(h==1||h==3&&T<=c||h==2&&T>=c)?c:Fe,L=Nn(a,T<P&&i>=P?P:Ti(P,T)),M=A*(d==0?t==0?.1:1:o),b=Oe(bl(t+M,x/10),24),E=t<=u&&(f==1||f==3&&b>=u||f==2&&b<=u)?u:-Fe,O=Ti(l,b>E&&t<=E?E:Nn(E,b));return L==O&&L==0&&(O=100),[L,O]}var kv=new Intl.NumberFormat(qr?Uv.language:"en-US"),Du=i=>kv.format(i),Qn=Math,ml=Qn.PI,sn=Qn.abs,jn=Qn.floor,nn=Qn.round,ui=Qn.ceil,Ti=Qn.min,Nn=Qn.max,Vr=Qn.pow,Cp=Qn.sign,ss=Qn.log10,nm=Qn.log2,Hv=(i,t=1)=>Qn.sinh(i)*t,pu=(i,t=1)=>Qn.asinh(i/t),Fe=1/0;function Rp(i){return(ss((i^i>>31)-(i>>31))|0)+1}function Mu(i,t,e){return Ti(Nn(i,t),e)}function im(i){return typeof i=="function"}function ge(i){return im(i)?i:()=>i}var Vv=()=>{},sm=i=>i,rm=(i,t)=>t,Gv=i=>null,Pp=i=>!0,Ip=(i,t)=>i==t,Wv=/\.\d*?(?=9{6,}|0{6,})/gm,ir=i=>{if(lm(i)||As.has(i))return i;let t=`${i}`,e=t.match(Wv);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ir(s)}e${r}`}return Oe(i,n)};function Qs(i,t){return ir(Oe(ir(i/t))*t)}function bl(i,t){return ir(ui(ir(i/t))*t)}function om(i,t){return ir(jn(ir(i/t))*t)}function Oe(i,t=0){if(lm(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return nn(n)/e}var As=new Map;function am(i){return((""+i).split(".")[1]||"").length}function jo(i,t,e,n){let s=[],r=n.map(am);for(let o=t;o<e;o++){let a=sn(o),l=Oe(Vr(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:Oe(u,h);s.push(f),As.set(f,h)}}return s}var Ko={},Uu=[],Gr=[null,null],Ts=Array.isArray,lm=Number.isInteger,Xv=i=>i===void 0;function Lp(i){return typeof i=="string"}function Ml(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function qv(i){return i!=null&&typeof i=="object"}var Yv=Object.getPrototypeOf(Uint8Array),cm="__proto__";function Wr(i,t=Ml){let e;if(Ts(i)){let n=i.find(s=>s!=null);if(Ts(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Wr(i[s],t)}else e=i.slice()}else if(i instanceof Yv)e=i.slice();else if(t(i)){e={};for(let n in i)n!=cm&&(e[n]=Wr(i[n],t))}else e=i;return e}function Qe(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=cm&&(Ml(i[s])?Qe(i[s],Wr(n[s])):i[s]=Wr(n[s]))}return i}var $v=0,Zv=1,Jv=2;function Kv(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function jv(i,t){if(ex(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return nx(o[0])||(o=tx(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:Zv,d=[];for(let m=0;m<u.length;m++){let _=u[m],g=r.get(l[m]);_===null?f!=$v&&(h[g]=_,f==Jv&&d.push(g)):h[g]=_}Kv(h,d,s),n.push(h)}}return n}var Qv=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function tx(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function ex(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function nx(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Nn(1,jn((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var hm=["January","February","March","April","May","June","July","August","September","October","November","December"],um=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function fm(i){return i.slice(0,3)}var ix=um.map(fm),sx=hm.map(fm),rx={MMMM:hm,MMM:sx,WWWW:um,WWW:ix};function qo(i){return(i<10?"0":"")+i}function ox(i){return(i<10?"00":i<100?"0":"")+i}var ax={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>qo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>qo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>qo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>qo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>qo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>ox(i.getMilliseconds())};function Nu(i,t){t=t||rx;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?ax[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var lx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function cx(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==lx?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var dm=i=>i%1==0,vl=[1,2,2.5,5],hx=jo(10,-32,0,vl),pm=jo(10,0,32,vl),ux=pm.filter(dm),tr=hx.concat(pm),Fu=`
`,mm="{YYYY}",Dp=Fu+mm,gm="{M}/{D}",Zo=Fu+gm,dl=Zo+"/{YY}",_m="{aa}",fx="{h}:{mm}",kr=fx+_m,Up=Fu+kr,Np=":{ss}",Te=null;function vm(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?jo(10,0,3,vl).filter(dm):jo(10,-3,0,vl)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,mm,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",Dp,Te,Te,Te,Te,Te,1],[s,gm,Dp,Te,Te,Te,Te,Te,1],[n,"{h}"+_m,dl,Te,Zo,Te,Te,Te,1],[e,kr,dl,Te,Zo,Te,Te,Te,1],[t,Np,dl+" "+kr,Te,Zo+" "+kr,Te,Up,Te,1],[i,Np+".{fff}",dl+" "+kr,Te,Zo+" "+kr,Te,Up,Te,1]];function u(h){return(f,d,m,_,g,p)=>{let A=[],S=g>=o,x=g>=r&&g<o,I=h(m),T=Oe(I*i,3),P=mu(I.getFullYear(),S?0:I.getMonth(),x||S?1:I.getDate()),L=Oe(P*i,3);if(x||S){let M=x?g/r:0,b=S?g/o:0,E=T==L?T:Oe(mu(P.getFullYear()+b,P.getMonth()+M,1)*i,3),O=new Date(nn(E/i)),B=O.getFullYear(),H=O.getMonth();for(let W=0;E<=_;W++){let Z=mu(B+b*W,H+M*W,1),k=Z-h(Oe(Z*i,3));E=Oe((+Z+k)*i,3),E<=_&&A.push(E)}}else{let M=g>=s?s:g,b=jn(m)-jn(T),E=L+b+bl(T-L,M);A.push(E);let O=h(E),B=O.getHours()+O.getMinutes()/e+O.getSeconds()/n,H=g/n,W=f.axes[d]._space,Z=p/W;for(;E=Oe(E+g,i==1?0:3),!(E>_);)if(H>1){let k=jn(Oe(B+H,6))%24,ot=h(E).getHours()-k;ot>1&&(ot=-1),E-=ot*n,B=(B+H)%24;let rt=A[A.length-1];Oe((E-rt)/g,3)*Z>=.7&&A.push(E)}else A.push(E)}return A}}return[l,c,u]}var[dx,px,mx]=vm(1),[gx,_x,vx]=vm(.001);jo(2,-53,53,[1]);function Fp(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Op(i,t){return(e,n,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,h,f,d;return n.map(m=>{let _=i(m),g=_.getFullYear(),p=_.getMonth(),A=_.getDate(),S=_.getHours(),x=_.getMinutes(),I=_.getSeconds(),T=g!=l&&a[2]||p!=c&&a[3]||A!=u&&a[4]||S!=h&&a[5]||x!=f&&a[6]||I!=d&&a[7]||a[1];return l=g,c=p,u=A,h=S,f=x,d=I,T(_)})}}function xx(i,t){let e=Nu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function mu(i,t,e){return new Date(i,t,e)}function Bp(i,t){return t(i)}var yx="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function zp(i,t){return(e,n,s,r)=>r==null?Ru:t(i(n))}function bx(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function Mx(i,t){return i.series[t].fill(i,t)}var Sx={show:!0,live:!0,isolate:!1,mount:Vv,markers:{show:!0,width:2,stroke:bx,fill:Mx,dash:"solid"},idx:null,idxs:null,values:[]};function wx(i,t){let e=i.cursor.points,n=hi(),s=e.size(i,t);We(n,Yo,s),We(n,$o,s);let r=s/-2;We(n,"marginLeft",r),We(n,"marginTop",r);let o=e.width(i,t,s);return o&&We(n,"borderWidth",o),n}function Ex(i,t){let e=i.series[t].points;return e._fill||e._stroke}function Tx(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Ax(i,t){return i.series[t].points.size}var gu=[0,0];function Cx(i,t,e){return gu[0]=t,gu[1]=e,gu}function pl(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function _u(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var Rx={show:!0,x:!0,y:!0,lock:!1,move:Cx,points:{one:!1,show:wx,size:Ax,width:0,stroke:Tx,fill:Ex},bind:{mousedown:pl,mouseup:pl,click:pl,dblclick:pl,mousemove:_u,mouseleave:_u,mouseenter:_u},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},xm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Ou=Qe({},xm,{filter:rm}),ym=Qe({},Ou,{size:10}),bm=Qe({},xm,{show:!1}),Bu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Mm="bold "+Bu,Sm=1.5,kp={show:!0,scale:"x",stroke:Cu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Mm,side:2,grid:Ou,ticks:ym,border:bm,font:Bu,lineGap:Sm,rotate:0},Px="Value",Ix="Time",Hp={show:!0,scale:"x",auto:!1,sorted:1,min:Fe,max:-Fe,idxs:[]};function Lx(i,t,e,n,s){return t.map(r=>r==null?"":Du(r))}function Dx(i,t,e,n,s,r,o){let a=[],l=As.get(s)||0;e=o?e:Oe(bl(e,s),l);for(let c=e;c<=n;c=Oe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Su(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?ss:nm,u=jn(c(e));s=Vr(l,u),l==10&&(s=tr[Ei(s,tr)]);let h=e,f=s*l;l==10&&(f=tr[Ei(f,tr)]);do a.push(h),h=h+s,l==10&&!As.has(h)&&(h=Oe(h,As.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=tr[Ei(f,tr)]));while(h<=n);return a}function Ux(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Su(i,t,Nn(l,e),n,s):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?Su(i,t,Nn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}var wm=/./,Nx=/[12357]/,Fx=/[125]/,Vp=/1/,wu=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Ox(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?wm:l(7,o)-u>=c?Nx:l(5,o)-u>=c?Fx:Vp;if(h==Vp){let f=sn(l(1,o)-u);if(f<c)return wu(t.slice().reverse(),a.distr,h,ui(c/f)).reverse()}return wu(t,a.distr,h,1)}function Bx(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=sn(l(1,o)-l(2,o));return c<a?wu(t.slice().reverse(),3,wm,ui(a/c)).reverse():t}function zx(i,t,e,n){return n==null?Ru:t==null?"":Du(t)}var Gp={show:!0,scale:"y",stroke:Cu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Mm,side:3,grid:Ou,ticks:ym,border:bm,font:Bu,lineGap:Sm,rotate:0};function kx(i,t){let e=3+(i||1)*2;return Oe(e*t,3)}function Hx(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=sn(o-r),l=i.series[t],c=a/(l.points.space*Ee);return n[1]-n[0]<=c}var Wp={scale:null,auto:!0,sorted:0,min:Fe,max:-Fe},Em=(i,t,e,n,s)=>s,Xp={show:!0,auto:!0,sorted:0,gaps:Em,alpha:1,facets:[Qe({},Wp,{scale:"x"}),Qe({},Wp,{scale:"y"})]},qp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Em,alpha:1,points:{show:Hx,filter:null},values:null,min:Fe,max:-Fe,idxs:[],path:null,clip:null};function Vx(i,t,e,n,s){return e/10}var Tm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Gx=Qe({},Tm,{time:!1,ori:1}),Yp={};function Am(i,t){let e=Yp[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(Yp[i]=e)),e}var Xr=1,Eu=2;function sr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,m=a.width,_=a.height,g=i.valToPosH,p=i.valToPosV;return u.ori==0?e(s,l,c,u,h,g,p,f,d,m,_,wl,Yr,Tl,Rm,Im):e(s,l,c,u,h,p,g,d,f,_,m,El,$r,Hu,Pm,Lm)}function zu(i,t){let e=0,n=0,s=Me(i.bands,Uu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Wx(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function rs(i,t,e,n,s,r){return sr(i,t,(o,a,l,c,u,h,f,d,m,_,g)=>{let p=o.pxRound,A=c.dir*(c.ori==0?1:-1),S=c.ori==0?Yr:$r,x,I;A==1?(x=e,I=n):(x=n,I=e);let T=p(h(a[x],c,_,d)),P=p(f(l[x],u,g,m)),L=p(h(a[I],c,_,d)),M=p(f(r==1?u.max:u.min,u,g,m)),b=new Path2D(s);return S(b,L,M),S(b,T,M),S(b,T,P),b})}function Sl(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Tl:Hu,l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function Xx(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function ku(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[h]),m=f==h?d:r(i[f]),_=h-s;d=o<=0&&_>=0&&_<l?r(i[_]):d;let p=f+s;m=o>=0&&p>=0&&p<l?r(i[p]):m,m>=d&&a.push([d,m])}return a}function $p(i){return i==0?sm:i==1?nn:t=>Qs(t,i)}function Cm(i){let t=i==0?wl:El,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=Ti(c,a/2,l/2),u=Ti(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var wl=(i,t,e)=>{i.moveTo(t,e)},El=(i,t,e)=>{i.moveTo(e,t)},Yr=(i,t,e)=>{i.lineTo(t,e)},$r=(i,t,e)=>{i.lineTo(e,t)},Tl=Cm(0),Hu=Cm(1),Rm=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Pm=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Im=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Lm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function Dm(i){return(t,e,n,s,r)=>sr(t,e,(o,a,l,c,u,h,f,d,m,_,g)=>{let{pxRound:p,points:A}=o,S,x;c.ori==0?(S=wl,x=Rm):(S=El,x=Pm);let I=Oe(A.width*Ee,3),T=(A.size-A.width)/2*Ee,P=Oe(T*2,3),L=new Path2D,M=new Path2D,{left:b,top:E,width:O,height:B}=t.bbox;Tl(M,b-P,E-P,O+P*2,B+P*2);let H=W=>{if(l[W]!=null){let Z=p(h(a[W],c,_,d)),k=p(f(l[W],u,g,m));S(L,Z+T,k),x(L,Z,k,T,0,ml*2)}};if(r)r.forEach(H);else for(let W=n;W<=s;W++)H(W);return{stroke:I>0?L:null,fill:L,clip:M,flags:Xr|Eu}})}function Um(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var qx=Um(Yr),Yx=Um($r);function Nm(i){let t=Me(i?.alignGaps,0);return(e,n,s,r)=>sr(e,n,(o,a,l,c,u,h,f,d,m,_,g)=>{[s,r]=xl(l,s,r);let p=o.pxRound,A=B=>p(h(B,c,_,d)),S=B=>p(f(B,u,g,m)),x,I;c.ori==0?(x=Yr,I=qx):(x=$r,I=Yx);let T=c.dir*(c.ori==0?1:-1),P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xr},L=P.stroke,M=!1;if(r-s>=_*4){let B=lt=>e.posToVal(lt,c.key,!0),H=null,W=null,Z,k,G,tt=A(a[T==1?s:r]),ot=A(a[s]),rt=A(a[r]),ut=B(T==1?ot+1:rt-1);for(let lt=T==1?s:r;lt>=s&&lt<=r;lt+=T){let Pt=a[lt],K=(T==1?Pt<ut:Pt>ut)?tt:A(Pt),V=l[lt];K==tt?V!=null?(k=V,H==null?(x(L,K,S(k)),Z=H=W=k):k<H?H=k:k>W&&(W=k)):V===null&&(M=!0):(H!=null&&I(L,tt,S(H),S(W),S(Z),S(k)),V!=null?(k=V,x(L,K,S(k)),H=W=Z=k):(H=W=null,V===null&&(M=!0)),tt=K,ut=B(tt+T))}H!=null&&H!=W&&G!=tt&&I(L,tt,S(H),S(W),S(Z),S(k))}else for(let B=T==1?s:r;B>=s&&B<=r;B+=T){let H=l[B];H===null?M=!0:H!=null&&x(L,A(a[B]),S(H))}let[E,O]=zu(e,n);if(o.fill!=null||E!=0){let B=P.fill=new Path2D(L),H=o.fillTo(e,n,o.min,o.max,E),W=S(H),Z=A(a[s]),k=A(a[r]);T==-1&&([k,Z]=[Z,k]),x(B,k,W),x(B,Z,W)}if(!o.spanGaps){let B=[];M&&B.push(...ku(a,l,s,r,T,A,t)),P.gaps=B=o.gaps(e,n,s,r,B),P.clip=Sl(B,c.ori,d,m,_,g)}return O!=0&&(P.band=O==2?[rs(e,n,s,r,L,-1),rs(e,n,s,r,L,1)]:rs(e,n,s,r,L,O)),P})}function $x(i){let t=Me(i.align,1),e=Me(i.ascDesc,!1),n=Me(i.alignGaps,0),s=Me(i.extend,!1);return(r,o,a,l)=>sr(r,o,(c,u,h,f,d,m,_,g,p,A,S)=>{[a,l]=xl(h,a,l);let x=c.pxRound,{left:I,width:T}=r.bbox,P=ot=>x(m(ot,f,A,g)),L=ot=>x(_(ot,d,S,p)),M=f.ori==0?Yr:$r,b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xr},E=b.stroke,O=f.dir*(f.ori==0?1:-1),B=L(h[O==1?a:l]),H=P(u[O==1?a:l]),W=H,Z=H;s&&t==-1&&(Z=I,M(E,Z,B)),M(E,H,B);for(let ot=O==1?a:l;ot>=a&&ot<=l;ot+=O){let rt=h[ot];if(rt==null)continue;let ut=P(u[ot]),lt=L(rt);t==1?M(E,ut,B):M(E,W,lt),M(E,ut,lt),B=lt,W=ut}let k=W;s&&t==1&&(k=I+T,M(E,k,B));let[G,tt]=zu(r,o);if(c.fill!=null||G!=0){let ot=b.fill=new Path2D(E),rt=c.fillTo(r,o,c.min,c.max,G),ut=L(rt);M(ot,k,ut),M(ot,Z,ut)}if(!c.spanGaps){let ot=[];ot.push(...ku(u,h,a,l,O,P,n));let rt=c.width*Ee/2,ut=e||t==1?rt:-rt,lt=e||t==-1?-rt:rt;ot.forEach(Pt=>{Pt[0]+=ut,Pt[1]+=lt}),b.gaps=ot=c.gaps(r,o,a,l,ot),b.clip=Sl(ot,f.ori,g,p,A,S)}return tt!=0&&(b.band=tt==2?[rs(r,o,a,l,E,-1),rs(r,o,a,l,E,1)]:rs(r,o,a,l,E,tt)),b})}function Zp(i,t,e,n,s,r,o=Fe){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=sn(i[l]-i[a]);u<c&&(c=u,o=sn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function Zx(i){i=i||Ko;let t=Me(i.size,[.6,Fe,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ge(s),o=1-t[0],a=Me(t[1],Fe),l=Me(t[2],1),c=Me(i.disp,Ko),u=Me(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,m,_,g)=>sr(d,m,(p,A,S,x,I,T,P,L,M,b,E)=>{let O=p.pxRound,B=e,H=n*Ee,W=a*Ee,Z=l*Ee,k,G;x.ori==0?[k,G]=r(d,m):[G,k]=r(d,m);let tt=x.dir*(x.ori==0?1:-1),ot=x.ori==0?Tl:Hu,rt=x.ori==0?u:(z,et,ht,at,Ht,xt,Vt)=>{u(z,et,ht,Ht,at,Vt,xt)},ut=Me(d.bands,Uu).find(z=>z.series[0]==m),lt=ut!=null?ut.dir:0,Pt=p.fillTo(d,m,p.min,p.max,lt),Lt=O(P(Pt,I,E,M)),K,V,pt,Et=b,bt=O(p.width*Ee),ft=!1,Jt=null,C=null,Ct=null,it=null;h!=null&&(bt==0||f!=null)&&(ft=!0,Jt=h.values(d,m,_,g),C=new Map,new Set(Jt).forEach(z=>{z!=null&&C.set(z,new Path2D)}),bt>0&&(Ct=f.values(d,m,_,g),it=new Map,new Set(Ct).forEach(z=>{z!=null&&it.set(z,new Path2D)})));let{x0:j,size:ct}=c;if(j!=null&&ct!=null){B=1,A=j.values(d,m,_,g),j.unit==2&&(A=A.map(ht=>d.posToVal(L+ht*b,x.key,!0)));let z=ct.values(d,m,_,g);ct.unit==2?V=z[0]*b:V=T(z[0],x,b,L)-T(0,x,b,L),Et=Zp(A,S,T,x,b,L,Et),pt=Et-V+H}else Et=Zp(A,S,T,x,b,L,Et),pt=Et*o+H,V=Et-pt;pt<1&&(pt=0),bt>=V/2&&(bt=0),pt<5&&(O=sm);let Nt=pt>0,_t=Et-pt-(Nt?bt:0);V=O(Mu(_t,Z,W)),K=(B==0?V/2:B==tt?0:V)-B*tt*((B==0?H/2:0)+(Nt?bt/2:0));let Dt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Zt=ft?null:new Path2D,ee=null;if(ut!=null)ee=d.data[ut.series[1]];else{let{y0:z,y1:et}=c;z!=null&&et!=null&&(S=et.values(d,m,_,g),ee=z.values(d,m,_,g))}let U=k*V,y=G*V;for(let z=tt==1?_:g;z>=_&&z<=g;z+=tt){let et=S[z];if(et==null)continue;if(ee!=null){let At=ee[z]??0;if(et-At==0)continue;Lt=P(At,I,E,M)}let ht=x.distr!=2||c!=null?A[z]:z,at=T(ht,x,b,L),Ht=P(Me(et,Pt),I,E,M),xt=O(at-K),Vt=O(Nn(Ht,Lt)),Ot=O(Ti(Ht,Lt)),mt=Vt-Ot;if(et!=null){let At=et<0?y:U,$t=et<0?U:y;ft?(bt>0&&Ct[z]!=null&&ot(it.get(Ct[z]),xt,Ot+jn(bt/2),V,Nn(0,mt-bt),At,$t),Jt[z]!=null&&ot(C.get(Jt[z]),xt,Ot+jn(bt/2),V,Nn(0,mt-bt),At,$t)):ot(Zt,xt,Ot+jn(bt/2),V,Nn(0,mt-bt),At,$t),rt(d,m,z,xt-bt/2,Ot,V+bt,mt)}}return bt>0?Dt.stroke=ft?it:Zt:ft||(Dt._fill=p.width==0?p._fill:p._stroke??p._fill,Dt.width=0),Dt.fill=ft?C:Zt,Dt})}function Jx(i,t){let e=Me(t?.alignGaps,0);return(n,s,r,o)=>sr(n,s,(a,l,c,u,h,f,d,m,_,g,p)=>{[r,o]=xl(c,r,o);let A=a.pxRound,S=k=>A(f(k,u,g,m)),x=k=>A(d(k,h,p,_)),I,T,P;u.ori==0?(I=wl,P=Yr,T=Im):(I=El,P=$r,T=Lm);let L=u.dir*(u.ori==0?1:-1),M=S(l[L==1?r:o]),b=M,E=[],O=[];for(let k=L==1?r:o;k>=r&&k<=o;k+=L)if(c[k]!=null){let tt=l[k],ot=S(tt);E.push(b=ot),O.push(x(c[k]))}let B={stroke:i(E,O,I,P,T,A),fill:null,clip:null,band:null,gaps:null,flags:Xr},H=B.stroke,[W,Z]=zu(n,s);if(a.fill!=null||W!=0){let k=B.fill=new Path2D(H),G=a.fillTo(n,s,a.min,a.max,W),tt=x(G);P(k,b,tt),P(k,M,tt)}if(!a.spanGaps){let k=[];k.push(...ku(l,c,r,o,L,S,e)),B.gaps=k=a.gaps(n,s,r,o,k),B.clip=Sl(k,u.ori,m,_,g,p)}return Z!=0&&(B.band=Z==2?[rs(n,s,r,o,H,-1),rs(n,s,r,o,H,1)]:rs(n,s,r,o,H,Z)),B})}function Kx(i){return Jx(jx,i)}function jx(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}return a}var Tu=new Set;function Jp(){for(let i of Tu)i.syncRect(!0)}qr&&(nr(Lv,Hr,Jp),nr(Dv,Hr,Jp,!0),nr(gl,Hr,()=>{Ze.pxRatio=Ee}));var Qx=Nm(),ty=Dm();function Kp(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Au(r,o,t,e))}function ey(i,t){return i.map((e,n)=>n==0?{}:Qe({},t,e))}function Au(i,t,e,n){return Qe({},t==0?e:n,i)}function Fm(i,t,e){return t==null?Gr:[t,e]}var ny=Fm;function iy(i,t,e){return t==null?Gr:_l(t,e,Lu,!0)}function Om(i,t,e,n){return t==null?Gr:yl(t,e,i.scales[n].log,!1)}var sy=Om;function Bm(i,t,e,n){return t==null?Gr:Iu(t,e,i.scales[n].log,!1)}var ry=Bm;function oy(i,t,e,n,s){let r=Nn(Rp(i),Rp(t)),o=t-i,a=Ei(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?As.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function jp(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=nn((e=+s)*Ee))+"px"),[i,t,e]}function ay(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Oe(t[2]*Ee,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Ze(i,t,e){let n={mode:Me(i.mode,1)},s=n.mode;function r(v,w,D,N){let q=w.valToPct(v);return N+D*(w.dir==-1?1-q:q)}function o(v,w,D,N){let q=w.valToPct(v);return N+D*(w.dir==-1?q:1-q)}function a(v,w,D,N){return w.ori==0?r(v,w,D,N):o(v,w,D,N)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=hi(pv);if(i.id!=null&&(c.id=i.id),Kn(c,i.class),i.title){let v=hi(_v,c);v.textContent=i.title}let u=wi("canvas"),h=n.ctx=u.getContext("2d"),f=hi(vv,c);nr("click",f,v=>{v.target===m&&(He!=Ir||qe!=Lr)&&_n.click(n,v)},!0);let d=n.under=hi(xv,f);f.appendChild(u);let m=n.over=hi(yv,f);i=Wr(i);let _=+Me(i.pxAlign,1),g=$p(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let p=i.ms||.001,A=n.series=s==1?Kp(i.series||[],Hp,qp,!1):ey(i.series||[null],Xp),S=n.axes=Kp(i.axes||[],kp,Gp,!0),x=n.scales={},I=n.bands=i.bands||[];I.forEach(v=>{v.fill=ge(v.fill||null),v.dir=Me(v.dir,-1)});let T=s==2?A[1].facets[0].scale:A[0].scale,P={axes:S_,series:$s},L=(i.drawOrder||["axes","series"]).map(v=>P[v]);function M(v){let w=v.distr==3?D=>ss(D>0?D:v.clamp(n,D,v.min,v.max,v.key)):v.distr==4?D=>pu(D,v.asinh):v.distr==100?D=>v.fwd(D):D=>D;return D=>{let N=w(D),{_min:q,_max:Q}=v,dt=Q-q;return(N-q)/dt}}function b(v){let w=x[v];if(w==null){let D=(i.scales||Ko)[v]||Ko;if(D.from!=null){b(D.from);let N=Qe({},x[D.from],D,{key:v});N.valToPct=M(N),x[v]=N}else{w=x[v]=Qe({},v==T?Tm:Gx,D),w.key=v;let N=w.time,q=w.range,Q=Ts(q);if((v!=T||s==2&&!N)&&(Q&&(q[0]==null||q[1]==null)&&(q={min:q[0]==null?Tp:{mode:1,hard:q[0],soft:q[0]},max:q[1]==null?Tp:{mode:1,hard:q[1],soft:q[1]}},Q=!1),!Q&&Ml(q))){let dt=q;q=(vt,Tt,zt)=>Tt==null?Gr:_l(Tt,zt,dt)}w.range=ge(q||(N?ny:v==T?w.distr==3?sy:w.distr==4?ry:Fm:w.distr==3?Om:w.distr==4?Bm:iy)),w.auto=ge(Q?!1:w.auto),w.clamp=ge(w.clamp||Vx),w._min=w._max=null,w.valToPct=M(w)}}}b("x"),b("y"),s==1&&A.forEach(v=>{b(v.scale)}),S.forEach(v=>{b(v.scale)});for(let v in i.scales)b(v);let E=x[T],O=E.distr,B,H;E.ori==0?(Kn(c,mv),B=r,H=o):(Kn(c,gv),B=o,H=r);let W={};for(let v in x){let w=x[v];(w.min!=null||w.max!=null)&&(W[v]={min:w.min,max:w.max},w.min=w.max=null)}let Z=i.tzDate||(v=>new Date(nn(v/p))),k=i.fmtDate||Nu,G=p==1?mx(Z):vx(Z),tt=Op(Z,Fp(p==1?px:_x,k)),ot=zp(Z,Bp(yx,k)),rt=[],ut=n.legend=Qe({},Sx,i.legend),lt=n.cursor=Qe({},Rx,{drag:{y:s==2}},i.cursor),Pt=ut.show,Lt=lt.show,K=ut.markers;ut.idxs=rt,K.width=ge(K.width),K.dash=ge(K.dash),K.stroke=ge(K.stroke),K.fill=ge(K.fill);let V,pt,Et,bt=[],ft=[],Jt,C=!1,Ct={};if(ut.live){let v=A[1]?A[1].values:null;C=v!=null,Jt=C?v(n,1,0):{_:0};for(let w in Jt)Ct[w]=Ru}if(Pt)if(V=wi("table",Tv,c),Et=wi("tbody",null,V),ut.mount(n,V),C){pt=wi("thead",null,V,Et);let v=wi("tr",null,pt);wi("th",null,v);for(var it in Jt)wi("th",dp,v).textContent=it}else Kn(V,Cv),ut.live&&Kn(V,Av);let j={show:!0},ct={show:!1};function Nt(v,w){if(w==0&&(C||!ut.live||s==2))return Gr;let D=[],N=wi("tr",Rv,Et,Et.childNodes[w]);Kn(N,v.class),v.show||Kn(N,er);let q=wi("th",null,N);if(K.show){let vt=hi(Pv,q);if(w>0){let Tt=K.width(n,w);Tt&&(vt.style.border=Tt+"px "+K.dash(n,w)+" "+K.stroke(n,w)),vt.style.background=K.fill(n,w)}}let Q=hi(dp,q);v.label instanceof HTMLElement?Q.appendChild(v.label):Q.textContent=v.label,w>0&&(K.show||(Q.style.color=v.width>0?K.stroke(n,w):K.fill(n,w)),Dt("click",q,vt=>{if(lt._lock)return;gn(vt);let Tt=A.indexOf(v);if((vt.ctrlKey||vt.metaKey)!=ut.isolate){let zt=A.some((kt,Xt)=>Xt>0&&Xt!=Tt&&kt.show);A.forEach((kt,Xt)=>{Xt>0&&Bi(Xt,zt?Xt==Tt?j:ct:j,!0,je.setSeries)})}else Bi(Tt,{show:!v.show},!0,je.setSeries)},!1),Hn&&Dt(_p,q,vt=>{lt._lock||(gn(vt),Bi(A.indexOf(v),Ur,!0,je.setSeries))},!1));for(var dt in Jt){let vt=wi("td",Iv,N);vt.textContent="--",D.push(vt)}return[N,D]}let _t=new Map;function Dt(v,w,D,N=!0){let q=_t.get(w)||{},Q=lt.bind[v](n,w,D,N);Q&&(nr(v,w,q[v]=Q),_t.set(w,q))}function Zt(v,w,D){let N=_t.get(w)||{};for(let q in N)(v==null||q==v)&&(bu(q,w,N[q]),delete N[q]);v==null&&_t.delete(w)}let ee=0,U=0,y=0,z=0,et=0,ht=0,at=et,Ht=ht,xt=y,Vt=z,Ot=0,mt=0,At=0,$t=0;n.bbox={};let Yt=!1,It=!1,se=!1,X=!1,Mt=!1,wt=!1;function Gt(v,w,D){(D||v!=n.width||w!=n.height)&&yt(v,w),Ar(!1),se=!0,It=!0,Cr()}function yt(v,w){n.width=ee=y=v,n.height=U=z=w,et=ht=0,Ie(),xe();let D=n.bbox;Ot=D.left=Qs(et*Ee,.5),mt=D.top=Qs(ht*Ee,.5),At=D.width=Qs(y*Ee,.5),$t=D.height=Qs(z*Ee,.5)}let gt=3;function qt(){let v=!1,w=0;for(;!v;){w++;let D=b_(w),N=M_(w);v=w==gt||D&&N,v||(yt(n.width,n.height),It=!0)}}function oe({width:v,height:w}){Gt(v,w)}n.setSize=oe;function Ie(){let v=!1,w=!1,D=!1,N=!1;S.forEach((q,Q)=>{if(q.show&&q._show){let{side:dt,_size:vt}=q,Tt=dt%2,zt=q.label!=null?q.labelSize:0,kt=vt+zt;kt>0&&(Tt?(y-=kt,dt==3?(et+=kt,N=!0):D=!0):(z-=kt,dt==0?(ht+=kt,v=!0):w=!0))}}),es[0]=v,es[1]=D,es[2]=w,es[3]=N,y-=Oi[1]+Oi[3],et+=Oi[3],z-=Oi[2]+Oi[0],ht+=Oi[0]}function xe(){let v=et+y,w=ht+z,D=et,N=ht;function q(Q,dt){switch(Q){case 1:return v+=dt,v-dt;case 2:return w+=dt,w-dt;case 3:return D-=dt,D+dt;case 0:return N-=dt,N+dt}}S.forEach((Q,dt)=>{if(Q.show&&Q._show){let vt=Q.side;Q._pos=q(vt,Q._size),Q.label!=null&&(Q._lpos=q(vt,Q.labelSize))}})}if(lt.dataIdx==null){let v=lt.hover,w=v.skip=new Set(v.skip??[]);w.add(void 0);let D=v.prox=ge(v.prox),N=v.bias??(v.bias=0);lt.dataIdx=(q,Q,dt,vt)=>{if(Q==0)return dt;let Tt=dt,zt=D(q,Q,dt,vt)??Fe,kt=zt>=0&&zt<Fe,Xt=E.ori==0?y:z,ae=lt.left,Se=t[0],be=t[Q];if(w.has(be[dt])){Tt=null;let pe=null,ie=null,jt;if(N==0||N==-1)for(jt=dt;pe==null&&jt-- >0;)w.has(be[jt])||(pe=jt);if(N==0||N==1)for(jt=dt;ie==null&&jt++<be.length;)w.has(be[jt])||(ie=jt);if(pe!=null||ie!=null)if(kt){let Ge=pe==null?-1/0:B(Se[pe],E,Xt,0),Ye=ie==null?1/0:B(Se[ie],E,Xt,0),pn=ae-Ge,Le=Ye-ae;pn<=Le?pn<=zt&&(Tt=pe):Le<=zt&&(Tt=ie)}else Tt=ie==null?pe:pe==null?ie:dt-pe<=ie-dt?pe:ie}else kt&&sn(ae-B(Se[dt],E,Xt,0))>zt&&(Tt=null);return Tt}}let gn=v=>{lt.event=v};lt.idxs=rt,lt._lock=!1;let Ne=lt.points;Ne.show=ge(Ne.show),Ne.size=ge(Ne.size),Ne.stroke=ge(Ne.stroke),Ne.width=ge(Ne.width),Ne.fill=ge(Ne.fill);let Yn=n.focus=Qe({},i.focus||{alpha:.3},lt.focus),Hn=Yn.prox>=0,Fi=Hn&&Ne.one,Cn=[],ts=[],_i=[];function No(v,w){let D=Ne.show(n,w);if(D instanceof HTMLElement)return Kn(D,Ev),Kn(D,v.class),Gi(D,-10,-10,y,z),m.insertBefore(D,Cn[w]),D}function qs(v,w){if(s==1||w>0){let D=s==1&&x[v.scale].time,N=v.value;v.value=D?Lp(N)?zp(Z,Bp(N,k)):N||ot:N||zx,v.label=v.label||(D?Ix:Px)}if(Fi||w>0){v.width=v.width==null?1:v.width,v.paths=v.paths||Qx||Gv,v.fillTo=ge(v.fillTo||Wx),v.pxAlign=+Me(v.pxAlign,_),v.pxRound=$p(v.pxAlign),v.stroke=ge(v.stroke||null),v.fill=ge(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let D=kx(Nn(1,v.width),1),N=v.points=Qe({},{size:D,width:Nn(1,D*.2),stroke:v.stroke,space:D*2,paths:ty,_stroke:null,_fill:null},v.points);N.show=ge(N.show),N.filter=ge(N.filter),N.fill=ge(N.fill),N.stroke=ge(N.stroke),N.paths=ge(N.paths),N.pxAlign=v.pxAlign}if(Pt){let D=Nt(v,w);bt.splice(w,0,D[0]),ft.splice(w,0,D[1]),ut.values.push(null)}if(Lt){rt.splice(w,0,null);let D=null;Fi?w==0&&(D=No(v,w)):w>0&&(D=No(v,w)),Cn.splice(w,0,D),ts.splice(w,0,0),_i.splice(w,0,0)}dn("addSeries",w)}function nl(v,w){w=w??A.length,v=s==1?Au(v,w,Hp,qp):Au(v,w,{},Xp),A.splice(w,0,v),qs(A[w],w)}n.addSeries=nl;function il(v){if(A.splice(v,1),Pt){ut.values.splice(v,1),ft.splice(v,1);let w=bt.splice(v,1)[0];Zt(null,w.firstChild),w.remove()}Lt&&(rt.splice(v,1),Cn.splice(v,1)[0].remove(),ts.splice(v,1),_i.splice(v,1)),dn("delSeries",v)}n.delSeries=il;let es=[!1,!1,!1,!1];function Wh(v,w){if(v._show=v.show,v.show){let D=v.side%2,N=x[v.scale];N==null&&(v.scale=D?A[1].scale:T,N=x[v.scale]);let q=N.time;v.size=ge(v.size),v.space=ge(v.space),v.rotate=ge(v.rotate),Ts(v.incrs)&&v.incrs.forEach(dt=>{!As.has(dt)&&As.set(dt,am(dt))}),v.incrs=ge(v.incrs||(N.distr==2?ux:q?p==1?dx:gx:tr)),v.splits=ge(v.splits||(q&&N.distr==1?G:N.distr==3?Su:N.distr==4?Ux:Dx)),v.stroke=ge(v.stroke),v.grid.stroke=ge(v.grid.stroke),v.ticks.stroke=ge(v.ticks.stroke),v.border.stroke=ge(v.border.stroke);let Q=v.values;v.values=Ts(Q)&&!Ts(Q[0])?ge(Q):q?Ts(Q)?Op(Z,Fp(Q,k)):Lp(Q)?xx(Z,Q):Q||tt:Q||Lx,v.filter=ge(v.filter||(N.distr>=3&&N.log==10?Ox:N.distr==3&&N.log==2?Bx:rm)),v.font=jp(v.font),v.labelFont=jp(v.labelFont),v._size=v.size(n,null,w,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(es[w]=!0,v._el=hi(bv,f))}}function Ys(v,w,D,N){let[q,Q,dt,vt]=D,Tt=w%2,zt=0;return Tt==0&&(vt||Q)&&(zt=w==0&&!q||w==2&&!dt?nn(kp.size/3):0),Tt==1&&(q||dt)&&(zt=w==1&&!Q||w==3&&!vt?nn(Gp.size/2):0),zt}let sl=n.padding=(i.padding||[Ys,Ys,Ys,Ys]).map(v=>ge(Me(v,Ys))),Oi=n._padding=sl.map((v,w)=>v(n,w,es,0)),en,R=null,Y=null,st=s==1?A[0].idxs:null,nt=null,J=!1;function St(v,w){if(t=v??[],n.data=n._data=t,s==2){en=0;for(let D=1;D<A.length;D++)en+=t[D][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),nt=t[0],en=nt.length;let D=t;if(O==2){D=t.slice();let N=D[0]=Array(en);for(let q=0;q<en;q++)N[q]=q}n._data=t=D}if(Ar(!0),dn("setData"),O==2&&(se=!0),w!==!1){let D=E;D.auto(n,J)?Ut():Ms(T,D.min,D.max),X=X||lt.left>=0,wt=!0,Cr()}}n.setData=St;function Ut(){J=!0;let v,w;s==1&&(en>0?(R=st[0]=0,Y=st[1]=en-1,v=t[0][R],w=t[0][Y],O==2?(v=R,w=Y):v==w&&(O==3?[v,w]=yl(v,v,E.log,!1):O==4?[v,w]=Iu(v,v,E.log,!1):E.time?w=v+nn(86400/p):[v,w]=_l(v,w,Lu,!0))):(R=st[0]=v=null,Y=st[1]=w=null)),Ms(T,v,w)}let Wt,Bt,te,ne,Kt,ue,ye,Be,Ae,le;function Qt(v,w,D,N,q,Q){v??(v=mp),D??(D=Uu),N??(N="butt"),q??(q=mp),Q??(Q="round"),v!=Wt&&(h.strokeStyle=Wt=v),q!=Bt&&(h.fillStyle=Bt=q),w!=te&&(h.lineWidth=te=w),Q!=Kt&&(h.lineJoin=Kt=Q),N!=ue&&(h.lineCap=ue=N),D!=ne&&h.setLineDash(ne=D)}function ze(v,w,D,N){w!=Bt&&(h.fillStyle=Bt=w),v!=ye&&(h.font=ye=v),D!=Be&&(h.textAlign=Be=D),N!=Ae&&(h.textBaseline=Ae=N)}function me(v,w,D,N,q=0){if(N.length>0&&v.auto(n,J)&&(w==null||w.min==null)){let Q=Me(R,0),dt=Me(Y,N.length-1),vt=D.min==null?Ov(N,Q,dt,q,v.distr==3):[D.min,D.max];v.min=Ti(v.min,D.min=vt[0]),v.max=Nn(v.max,D.max=vt[1])}}let Mn={min:null,max:null};function xs(){for(let N in x){let q=x[N];W[N]==null&&(q.min==null||W[T]!=null&&q.auto(n,J))&&(W[N]=Mn)}for(let N in x){let q=x[N];W[N]==null&&q.from!=null&&W[q.from]!=null&&(W[N]=Mn)}W[T]!=null&&Ar(!0);let v={};for(let N in W){let q=W[N];if(q!=null){let Q=v[N]=Wr(x[N],qv);if(q.min!=null)Qe(Q,q);else if(N!=T||s==2)if(en==0&&Q.from==null){let dt=Q.range(n,null,null,N);Q.min=dt[0],Q.max=dt[1]}else Q.min=Fe,Q.max=-Fe}}if(en>0){A.forEach((N,q)=>{if(s==1){let Q=N.scale,dt=W[Q];if(dt==null)return;let vt=v[Q];if(q==0){let Tt=vt.range(n,vt.min,vt.max,Q);vt.min=Tt[0],vt.max=Tt[1],R=Ei(vt.min,t[0]),Y=Ei(vt.max,t[0]),Y-R>1&&(t[0][R]<vt.min&&R++,t[0][Y]>vt.max&&Y--),N.min=nt[R],N.max=nt[Y]}else N.show&&N.auto&&me(vt,dt,N,t[q],N.sorted);N.idxs[0]=R,N.idxs[1]=Y}else if(q>0&&N.show&&N.auto){let[Q,dt]=N.facets,vt=Q.scale,Tt=dt.scale,[zt,kt]=t[q],Xt=v[vt],ae=v[Tt];Xt!=null&&me(Xt,W[vt],Q,zt,Q.sorted),ae!=null&&me(ae,W[Tt],dt,kt,dt.sorted),N.min=dt.min,N.max=dt.max}});for(let N in v){let q=v[N],Q=W[N];if(q.from==null&&(Q==null||Q.min==null)){let dt=q.range(n,q.min==Fe?null:q.min,q.max==-Fe?null:q.max,N);q.min=dt[0],q.max=dt[1]}}}for(let N in v){let q=v[N];if(q.from!=null){let Q=v[q.from];if(Q.min==null)q.min=q.max=null;else{let dt=q.range(n,Q.min,Q.max,N);q.min=dt[0],q.max=dt[1]}}}let w={},D=!1;for(let N in v){let q=v[N],Q=x[N];if(Q.min!=q.min||Q.max!=q.max){Q.min=q.min,Q.max=q.max;let dt=Q.distr;Q._min=dt==3?ss(Q.min):dt==4?pu(Q.min,Q.asinh):dt==100?Q.fwd(Q.min):Q.min,Q._max=dt==3?ss(Q.max):dt==4?pu(Q.max,Q.asinh):dt==100?Q.fwd(Q.max):Q.max,w[N]=D=!0}}if(D){A.forEach((N,q)=>{s==2?q>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)se=!0,dn("setScale",N);Lt&&lt.left>=0&&(X=wt=!0)}for(let N in W)W[N]=null}function Rn(v){let w=Mu(R-1,0,en-1),D=Mu(Y+1,0,en-1);for(;v[w]==null&&w>0;)w--;for(;v[D]==null&&D<en-1;)D++;return[w,D]}function $s(){if(en>0){let v=A.some(w=>w._focus)&&le!=Yn.alpha;v&&(h.globalAlpha=le=Yn.alpha),A.forEach((w,D)=>{if(D>0&&w.show&&(ke(D,!1),ke(D,!0),w._paths==null)){let N=le;le!=w.alpha&&(h.globalAlpha=le=w.alpha);let q=s==2?[0,t[D][0].length-1]:Rn(t[D]);w._paths=w.paths(n,D,q[0],q[1]),le!=N&&(h.globalAlpha=le=N)}}),A.forEach((w,D)=>{if(D>0&&w.show){let N=le;le!=w.alpha&&(h.globalAlpha=le=w.alpha),w._paths!=null&&Pn(D,!1);{let q=w._paths!=null?w._paths.gaps:null,Q=w.points.show(n,D,R,Y,q),dt=w.points.filter(n,D,Q,q);(Q||dt)&&(w.points._paths=w.points.paths(n,D,R,Y,dt),Pn(D,!0))}le!=N&&(h.globalAlpha=le=N),dn("drawSeries",D)}}),v&&(h.globalAlpha=le=1)}}function ke(v,w){let D=w?A[v].points:A[v];D._stroke=D.stroke(n,v),D._fill=D.fill(n,v)}function Pn(v,w){let D=w?A[v].points:A[v],{stroke:N,fill:q,clip:Q,flags:dt,_stroke:vt=D._stroke,_fill:Tt=D._fill,_width:zt=D.width}=D._paths;zt=Oe(zt*Ee,3);let kt=null,Xt=zt%2/2;w&&Tt==null&&(Tt=zt>0?"#fff":vt);let ae=D.pxAlign==1&&Xt>0;if(ae&&h.translate(Xt,Xt),!w){let Se=Ot-zt/2,be=mt-zt/2,pe=At+zt,ie=$t+zt;kt=new Path2D,kt.rect(Se,be,pe,ie)}w?hn(vt,zt,D.dash,D.cap,Tt,N,q,dt,Q):Vn(v,vt,zt,D.dash,D.cap,Tt,N,q,dt,kt,Q),ae&&h.translate(-Xt,-Xt)}function Vn(v,w,D,N,q,Q,dt,vt,Tt,zt,kt){let Xt=!1;Tt!=0&&I.forEach((ae,Se)=>{if(ae.series[0]==v){let be=A[ae.series[1]],pe=t[ae.series[1]],ie=(be._paths||Ko).band;Ts(ie)&&(ie=ae.dir==1?ie[0]:ie[1]);let jt,Ge=null;be.show&&ie&&zv(pe,R,Y)?(Ge=ae.fill(n,Se)||Q,jt=be._paths.clip):ie=null,hn(w,D,N,q,Ge,dt,vt,Tt,zt,kt,jt,ie),Xt=!0}}),Xt||hn(w,D,N,q,Q,dt,vt,Tt,zt,kt)}let cn=Xr|Eu;function hn(v,w,D,N,q,Q,dt,vt,Tt,zt,kt,Xt){Qt(v,w,D,N,q),(Tt||zt||Xt)&&(h.save(),Tt&&h.clip(Tt),zt&&h.clip(zt)),Xt?(vt&cn)==cn?(h.clip(Xt),kt&&h.clip(kt),oi(q,dt),ys(v,Q,w)):vt&Eu?(oi(q,dt),h.clip(Xt),ys(v,Q,w)):vt&Xr&&(h.save(),h.clip(Xt),kt&&h.clip(kt),oi(q,dt),h.restore(),ys(v,Q,w)):(oi(q,dt),ys(v,Q,w)),(Tt||zt||Xt)&&h.restore()}function ys(v,w,D){D>0&&(w instanceof Map?w.forEach((N,q)=>{h.strokeStyle=Wt=q,h.stroke(N)}):w!=null&&v&&h.stroke(w))}function oi(v,w){w instanceof Map?w.forEach((D,N)=>{h.fillStyle=Bt=N,h.fill(D)}):w!=null&&v&&h.fill(w)}function y_(v,w,D,N){let q=S[v],Q;if(N<=0)Q=[0,0];else{let dt=q._space=q.space(n,v,w,D,N),vt=q._incrs=q.incrs(n,v,w,D,N,dt);Q=oy(w,D,vt,N,dt)}return q._found=Q}function Xh(v,w,D,N,q,Q,dt,vt,Tt,zt){let kt=dt%2/2;_==1&&h.translate(kt,kt),Qt(vt,dt,Tt,zt,vt),h.beginPath();let Xt,ae,Se,be,pe=q+(N==0||N==3?-Q:Q);D==0?(ae=q,be=pe):(Xt=q,Se=pe);for(let ie=0;ie<v.length;ie++)w[ie]!=null&&(D==0?Xt=Se=v[ie]:ae=be=v[ie],h.moveTo(Xt,ae),h.lineTo(Se,be));h.stroke(),_==1&&h.translate(-kt,-kt)}function b_(v){let w=!0;return S.forEach((D,N)=>{if(!D.show)return;let q=x[D.scale];if(q.min==null){D._show&&(w=!1,D._show=!1,Ar(!1));return}else D._show||(w=!1,D._show=!0,Ar(!1));let Q=D.side,dt=Q%2,{min:vt,max:Tt}=q,[zt,kt]=y_(N,vt,Tt,dt==0?y:z);if(kt==0)return;let Xt=q.distr==2,ae=D._splits=D.splits(n,N,vt,Tt,zt,kt,Xt),Se=q.distr==2?ae.map(jt=>nt[jt]):ae,be=q.distr==2?nt[ae[1]]-nt[ae[0]]:zt,pe=D._values=D.values(n,D.filter(n,Se,N,kt,be),N,kt,be);D._rotate=Q==2?D.rotate(n,pe,N,kt):0;let ie=D._size;D._size=ui(D.size(n,pe,N,v)),ie!=null&&D._size!=ie&&(w=!1)}),w}function M_(v){let w=!0;return sl.forEach((D,N)=>{let q=D(n,N,es,v);q!=Oi[N]&&(w=!1),Oi[N]=q}),w}function S_(){for(let v=0;v<S.length;v++){let w=S[v];if(!w.show||!w._show)continue;let D=w.side,N=D%2,q,Q,dt=w.stroke(n,v),vt=D==0||D==3?-1:1,[Tt,zt]=w._found;if(w.label!=null){let Ln=w.labelGap*vt,Jn=nn((w._lpos+Ln)*Ee);ze(w.labelFont[0],dt,"center",D==2?"top":pp),h.save(),N==1?(q=Q=0,h.translate(Jn,nn(mt+$t/2)),h.rotate((D==3?-ml:ml)/2)):(q=nn(Ot+At/2),Q=Jn);let Ks=im(w.label)?w.label(n,v,Tt,zt):w.label;h.fillText(Ks,q,Q),h.restore()}if(zt==0)continue;let kt=x[w.scale],Xt=N==0?At:$t,ae=N==0?Ot:mt,Se=w._splits,be=kt.distr==2?Se.map(Ln=>nt[Ln]):Se,pe=kt.distr==2?nt[Se[1]]-nt[Se[0]]:Tt,ie=w.ticks,jt=w.border,Ge=ie.show?ie.size:0,Ye=nn(Ge*Ee),pn=nn((w.alignTo==2?w._size-Ge-w.gap:w.gap)*Ee),Le=w._rotate*-ml/180,$e=g(w._pos*Ee),$n=(Ye+pn)*vt,In=$e+$n;Q=N==0?In:0,q=N==1?In:0;let ai=w.font[0],vi=w.align==1?zr:w.align==2?uu:Le>0?zr:Le<0?uu:N==0?"center":D==3?uu:zr,ki=Le||N==1?"middle":D==2?"top":pp;ze(ai,dt,vi,ki);let Zn=w.font[1]*w.lineGap,li=Se.map(Ln=>g(a(Ln,kt,Xt,ae))),xi=w._values;for(let Ln=0;Ln<xi.length;Ln++){let Jn=xi[Ln];if(Jn!=null){N==0?q=li[Ln]:Q=li[Ln],Jn=""+Jn;let Ks=Jn.indexOf(`
`)==-1?[Jn]:Jn.split(/\n/gm);for(let Dn=0;Dn<Ks.length;Dn++){let Vd=Ks[Dn];Le?(h.save(),h.translate(q,Q+Dn*Zn),h.rotate(Le),h.fillText(Vd,0,0),h.restore()):h.fillText(Vd,q,Q+Dn*Zn)}}}ie.show&&Xh(li,ie.filter(n,be,v,zt,pe),N,D,$e,Ye,Oe(ie.width*Ee,3),ie.stroke(n,v),ie.dash,ie.cap);let Hi=w.grid;Hi.show&&Xh(li,Hi.filter(n,be,v,zt,pe),N,N==0?2:1,N==0?mt:Ot,N==0?$t:At,Oe(Hi.width*Ee,3),Hi.stroke(n,v),Hi.dash,Hi.cap),jt.show&&Xh([$e],[1],N==0?1:0,N==0?1:2,N==1?mt:Ot,N==1?$t:At,Oe(jt.width*Ee,3),jt.stroke(n,v),jt.dash,jt.cap)}dn("drawAxes")}function Ar(v){A.forEach((w,D)=>{D>0&&(w._paths=null,v&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let rl=!1,qh=!1,Fo=[];function w_(){qh=!1;for(let v=0;v<Fo.length;v++)dn(...Fo[v]);Fo.length=0}function Cr(){rl||(Qv(wd),rl=!0)}function E_(v,w=!1){rl=!0,qh=w,v(n),wd(),w&&Fo.length>0&&queueMicrotask(w_)}n.batch=E_;function wd(){if(Yt&&(xs(),Yt=!1),se&&(qt(),se=!1),It){if(We(d,zr,et),We(d,"top",ht),We(d,Yo,y),We(d,$o,z),We(m,zr,et),We(m,"top",ht),We(m,Yo,y),We(m,$o,z),We(f,Yo,ee),We(f,$o,U),u.width=nn(ee*Ee),u.height=nn(U*Ee),S.forEach(({_el:v,_show:w,_size:D,_pos:N,side:q})=>{if(v!=null)if(w){let Q=q===3||q===0?D:0,dt=q%2==1;We(v,dt?"left":"top",N-Q),We(v,dt?"width":"height",D),We(v,dt?"top":"left",dt?ht:et),We(v,dt?"height":"width",dt?z:y),yu(v,er)}else Kn(v,er)}),Wt=Bt=te=Kt=ue=ye=Be=Ae=ne=null,le=1,zo(!0),et!=at||ht!=Ht||y!=xt||z!=Vt){Ar(!1);let v=y/xt,w=z/Vt;if(Lt&&!X&&lt.left>=0){lt.left*=v,lt.top*=w,Rr&&Gi(Rr,nn(lt.left),0,y,z),Pr&&Gi(Pr,0,nn(lt.top),y,z);for(let D=0;D<Cn.length;D++){let N=Cn[D];N!=null&&(ts[D]*=v,_i[D]*=w,Gi(N,ui(ts[D]),ui(_i[D]),y,z))}}if(Ve.show&&!Mt&&Ve.left>=0&&Ve.width>0){Ve.left*=v,Ve.width*=v,Ve.top*=w,Ve.height*=w;for(let D in jh)We(Dr,D,Ve[D])}at=et,Ht=ht,xt=y,Vt=z}dn("setSize"),It=!1}ee>0&&U>0&&(h.clearRect(0,0,u.width,u.height),dn("drawClear"),L.forEach(v=>v()),dn("draw")),Ve.show&&Mt&&(ol(Ve),Mt=!1),Lt&&X&&(Js(null,!0,!1),X=!1),ut.show&&ut.live&&wt&&(Jh(),wt=!1),l||(l=!0,n.status=1,dn("ready")),J=!1,rl=!1}n.redraw=(v,w)=>{se=w||!1,v!==!1?Ms(T,E.min,E.max):Cr()};function Yh(v,w){let D=x[v];if(D.from==null){if(en==0){let N=D.range(n,w.min,w.max,v);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(en>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;v==T&&D.distr==2&&en>0&&(w.min=Ei(w.min,t[0]),w.max=Ei(w.max,t[0]),w.min==w.max&&w.max++),W[v]=w,Yt=!0,Cr()}}n.setScale=Yh;let $h,Zh,Rr,Pr,Ed,Td,Ir,Lr,Ad,Cd,He,qe,bs=!1,_n=lt.drag,un=_n.x,fn=_n.y;Lt&&(lt.x&&($h=hi(Sv,m)),lt.y&&(Zh=hi(wv,m)),E.ori==0?(Rr=$h,Pr=Zh):(Rr=Zh,Pr=$h),He=lt.left,qe=lt.top);let Ve=n.select=Qe({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Dr=Ve.show?hi(Mv,Ve.over?m:d):null;function ol(v,w){if(Ve.show){for(let D in v)Ve[D]=v[D],D in jh&&We(Dr,D,v[D]);w!==!1&&dn("setSelect")}}n.setSelect=ol;function T_(v){if(A[v].show)Pt&&yu(bt[v],er);else if(Pt&&Kn(bt[v],er),Lt){let D=Fi?Cn[0]:Cn[v];D!=null&&Gi(D,-10,-10,y,z)}}function Ms(v,w,D){Yh(v,{min:w,max:D})}function Bi(v,w,D,N){w.focus!=null&&I_(v),w.show!=null&&A.forEach((q,Q)=>{Q>0&&(v==Q||v==null)&&(q.show=w.show,T_(Q),s==2?(Ms(q.facets[0].scale,null,null),Ms(q.facets[1].scale,null,null)):Ms(q.scale,null,null),Cr())}),D!==!1&&dn("setSeries",v,w),N&&ko("setSeries",n,v,w)}n.setSeries=Bi;function A_(v,w){Qe(I[v],w)}function C_(v,w){v.fill=ge(v.fill||null),v.dir=Me(v.dir,-1),w=w??I.length,I.splice(w,0,v)}function R_(v){v==null?I.length=0:I.splice(v,1)}n.addBand=C_,n.setBand=A_,n.delBand=R_;function P_(v,w){A[v].alpha=w,Lt&&Cn[v]!=null&&(Cn[v].style.opacity=w),Pt&&bt[v]&&(bt[v].style.opacity=w)}let ns,Ss,Zs,Ur={focus:!0};function I_(v){if(v!=Zs){let w=v==null,D=Yn.alpha!=1;A.forEach((N,q)=>{if(s==1||q>0){let Q=w||q==0||q==v;N._focus=w?null:Q,D&&P_(q,Q?1:Yn.alpha)}}),Zs=v,D&&Cr()}}Pt&&Hn&&Dt(vp,V,v=>{lt._lock||(gn(v),Zs!=null&&Bi(null,Ur,!0,je.setSeries))});function zi(v,w,D){let N=x[w];D&&(v=v/Ee-(N.ori==1?ht:et));let q=y;N.ori==1&&(q=z,v=q-v),N.dir==-1&&(v=q-v);let Q=N._min,dt=N._max,vt=v/q,Tt=Q+(dt-Q)*vt,zt=N.distr;return zt==3?Vr(10,Tt):zt==4?Hv(Tt,N.asinh):zt==100?N.bwd(Tt):Tt}function L_(v,w){let D=zi(v,T,w);return Ei(D,t[0],R,Y)}n.valToIdx=v=>Ei(v,t[0]),n.posToIdx=L_,n.posToVal=zi,n.valToPos=(v,w,D)=>x[w].ori==0?r(v,x[w],D?At:y,D?Ot:0):o(v,x[w],D?$t:z,D?mt:0),n.setCursor=(v,w,D)=>{He=v.left,qe=v.top,Js(null,w,D)};function Rd(v,w){We(Dr,zr,Ve.left=v),We(Dr,Yo,Ve.width=w)}function Pd(v,w){We(Dr,"top",Ve.top=v),We(Dr,$o,Ve.height=w)}let Oo=E.ori==0?Rd:Pd,Bo=E.ori==1?Rd:Pd;function D_(){if(Pt&&ut.live)for(let v=s==2?1:0;v<A.length;v++){if(v==0&&C)continue;let w=ut.values[v],D=0;for(let N in w)ft[v][D++].firstChild.nodeValue=w[N]}}function Jh(v,w){if(v!=null&&(v.idxs?v.idxs.forEach((D,N)=>{rt[N]=D}):Xv(v.idx)||rt.fill(v.idx),ut.idx=rt[0]),Pt&&ut.live){for(let D=0;D<A.length;D++)(D>0||s==1&&!C)&&U_(D,rt[D]);D_()}wt=!1,w!==!1&&dn("setLegend")}n.setLegend=Jh;function U_(v,w){let D=A[v],N=v==0&&O==2?nt:t[v],q;C?q=D.values(n,v,w)??Ct:(q=D.value(n,w==null?null:N[w],v,w),q=q==null?Ct:{_:q}),ut.values[v]=q}function Js(v,w,D){Ad=He,Cd=qe,[He,qe]=lt.move(n,He,qe),lt.left=He,lt.top=qe,Lt&&(Rr&&Gi(Rr,nn(He),0,y,z),Pr&&Gi(Pr,0,nn(qe),y,z));let N,q=R>Y;ns=Fe,Ss=null;let Q=E.ori==0?y:z,dt=E.ori==1?y:z;if(He<0||en==0||q){N=lt.idx=null;for(let vt=0;vt<A.length;vt++){let Tt=Cn[vt];Tt!=null&&Gi(Tt,-10,-10,y,z)}Hn&&Bi(null,Ur,!0,v==null&&je.setSeries),ut.live&&(rt.fill(N),wt=!0)}else{let vt,Tt,zt;s==1&&(vt=E.ori==0?He:qe,Tt=zi(vt,T),N=lt.idx=Ei(Tt,t[0],R,Y),zt=B(t[0][N],E,Q,0));let kt=-10,Xt=-10,ae=0,Se=0,be=!0,pe="",ie="";for(let jt=s==2?1:0;jt<A.length;jt++){let Ge=A[jt],Ye=rt[jt],pn=Ye==null?null:s==1?t[jt][Ye]:t[jt][1][Ye],Le=lt.dataIdx(n,jt,N,Tt),$e=Le==null?null:s==1?t[jt][Le]:t[jt][1][Le];if(wt=wt||$e!=pn||Le!=Ye,rt[jt]=Le,jt>0&&Ge.show){let $n=Le==null?-10:Le==N?zt:B(s==1?t[0][Le]:t[jt][0][Le],E,Q,0),In=$e==null?-10:H($e,s==1?x[Ge.scale]:x[Ge.facets[1].scale],dt,0);if(Hn&&$e!=null){let ai=E.ori==1?He:qe,vi=sn(Yn.dist(n,jt,Le,In,ai));if(vi<ns){let ki=Yn.bias;if(ki!=0){let Zn=zi(ai,Ge.scale),li=$e>=0?1:-1,xi=Zn>=0?1:-1;xi==li&&(xi==1?ki==1?$e>=Zn:$e<=Zn:ki==1?$e<=Zn:$e>=Zn)&&(ns=vi,Ss=jt)}else ns=vi,Ss=jt}}if(wt||Fi){let ai,vi;E.ori==0?(ai=$n,vi=In):(ai=In,vi=$n);let ki,Zn,li,xi,Hi,Ln,Jn=!0,Ks=Ne.bbox;if(Ks!=null){Jn=!1;let Dn=Ks(n,jt);li=Dn.left,xi=Dn.top,ki=Dn.width,Zn=Dn.height}else li=ai,xi=vi,ki=Zn=Ne.size(n,jt);if(Ln=Ne.fill(n,jt),Hi=Ne.stroke(n,jt),Fi)jt==Ss&&ns<=Yn.prox&&(kt=li,Xt=xi,ae=ki,Se=Zn,be=Jn,pe=Ln,ie=Hi);else{let Dn=Cn[jt];Dn!=null&&(ts[jt]=li,_i[jt]=xi,Ep(Dn,ki,Zn,Jn),Sp(Dn,Ln,Hi),Gi(Dn,ui(li),ui(xi),y,z))}}}}if(Fi){let jt=Yn.prox,Ge=Zs==null?ns<=jt:ns>jt||Ss!=Zs;if(wt||Ge){let Ye=Cn[0];Ye!=null&&(ts[0]=kt,_i[0]=Xt,Ep(Ye,ae,Se,be),Sp(Ye,pe,ie),Gi(Ye,ui(kt),ui(Xt),y,z))}}}if(Ve.show&&bs)if(v!=null){let[vt,Tt]=je.scales,[zt,kt]=je.match,[Xt,ae]=v.cursor.sync.scales,Se=v.cursor.drag;if(un=Se._x,fn=Se._y,un||fn){let{left:be,top:pe,width:ie,height:jt}=v.select,Ge=v.scales[Xt].ori,Ye=v.posToVal,pn,Le,$e,$n,In,ai=vt!=null&&zt(vt,Xt),vi=Tt!=null&&kt(Tt,ae);ai&&un?(Ge==0?(pn=be,Le=ie):(pn=pe,Le=jt),$e=x[vt],$n=B(Ye(pn,Xt),$e,Q,0),In=B(Ye(pn+Le,Xt),$e,Q,0),Oo(Ti($n,In),sn(In-$n))):Oo(0,Q),vi&&fn?(Ge==1?(pn=be,Le=ie):(pn=pe,Le=jt),$e=x[Tt],$n=H(Ye(pn,ae),$e,dt,0),In=H(Ye(pn+Le,ae),$e,dt,0),Bo(Ti($n,In),sn(In-$n))):Bo(0,dt)}else Qh()}else{let vt=sn(Ad-Ed),Tt=sn(Cd-Td);if(E.ori==1){let ae=vt;vt=Tt,Tt=ae}un=_n.x&&vt>=_n.dist,fn=_n.y&&Tt>=_n.dist;let zt=_n.uni;zt!=null?un&&fn&&(un=vt>=zt,fn=Tt>=zt,!un&&!fn&&(Tt>vt?fn=!0:un=!0)):_n.x&&_n.y&&(un||fn)&&(un=fn=!0);let kt,Xt;un&&(E.ori==0?(kt=Ir,Xt=He):(kt=Lr,Xt=qe),Oo(Ti(kt,Xt),sn(Xt-kt)),fn||Bo(0,dt)),fn&&(E.ori==1?(kt=Ir,Xt=He):(kt=Lr,Xt=qe),Bo(Ti(kt,Xt),sn(Xt-kt)),un||Oo(0,Q)),!un&&!fn&&(Oo(0,0),Bo(0,0))}if(_n._x=un,_n._y=fn,v==null){if(D){if(Hd!=null){let[vt,Tt]=je.scales;je.values[0]=vt!=null?zi(E.ori==0?He:qe,vt):null,je.values[1]=Tt!=null?zi(E.ori==1?He:qe,Tt):null}ko(fu,n,He,qe,y,z,N)}if(Hn){let vt=D&&je.setSeries,Tt=Yn.prox;Zs==null?ns<=Tt&&Bi(Ss,Ur,!0,vt):ns>Tt?Bi(null,Ur,!0,vt):Ss!=Zs&&Bi(Ss,Ur,!0,vt)}}wt&&(ut.idx=N,Jh()),w!==!1&&dn("setCursor")}let ws=null;Object.defineProperty(n,"rect",{get(){return ws==null&&zo(!1),ws}});function zo(v=!1){v?ws=null:(ws=m.getBoundingClientRect(),dn("syncRect",ws))}function Id(v,w,D,N,q,Q,dt){lt._lock||bs&&v!=null&&v.movementX==0&&v.movementY==0||(Kh(v,w,D,N,q,Q,dt,!1,v!=null),v!=null?Js(null,!0,!0):Js(w,!0,!1))}function Kh(v,w,D,N,q,Q,dt,vt,Tt){if(ws==null&&zo(!1),gn(v),v!=null)D=v.clientX-ws.left,N=v.clientY-ws.top;else{if(D<0||N<0){He=-10,qe=-10;return}let[zt,kt]=je.scales,Xt=w.cursor.sync,[ae,Se]=Xt.values,[be,pe]=Xt.scales,[ie,jt]=je.match,Ge=w.axes[0].side%2==1,Ye=E.ori==0?y:z,pn=E.ori==1?y:z,Le=Ge?Q:q,$e=Ge?q:Q,$n=Ge?N:D,In=Ge?D:N;if(be!=null?D=ie(zt,be)?a(ae,x[zt],Ye,0):-10:D=Ye*($n/Le),pe!=null?N=jt(kt,pe)?a(Se,x[kt],pn,0):-10:N=pn*(In/$e),E.ori==1){let ai=D;D=N,N=ai}}Tt&&(w==null||w.cursor.event.type==fu)&&((D<=1||D>=y-1)&&(D=Qs(D,y)),(N<=1||N>=z-1)&&(N=Qs(N,z))),vt?(Ed=D,Td=N,[Ir,Lr]=lt.move(n,D,N)):(He=D,qe=N)}let jh={width:0,height:0,left:0,top:0};function Qh(){ol(jh,!1)}let Ld,Dd,Ud,Nd;function Fd(v,w,D,N,q,Q,dt){bs=!0,un=fn=_n._x=_n._y=!1,Kh(v,w,D,N,q,Q,dt,!0,!1),v!=null&&(Dt(du,vu,Od,!1),ko(gp,n,Ir,Lr,y,z,null));let{left:vt,top:Tt,width:zt,height:kt}=Ve;Ld=vt,Dd=Tt,Ud=zt,Nd=kt}function Od(v,w,D,N,q,Q,dt){bs=_n._x=_n._y=!1,Kh(v,w,D,N,q,Q,dt,!1,!0);let{left:vt,top:Tt,width:zt,height:kt}=Ve,Xt=zt>0||kt>0,ae=Ld!=vt||Dd!=Tt||Ud!=zt||Nd!=kt;if(Xt&&ae&&ol(Ve),_n.setScale&&Xt&&ae){let Se=vt,be=zt,pe=Tt,ie=kt;if(E.ori==1&&(Se=Tt,be=kt,pe=vt,ie=zt),un&&Ms(T,zi(Se,T),zi(Se+be,T)),fn)for(let jt in x){let Ge=x[jt];jt!=T&&Ge.from==null&&Ge.min!=Fe&&Ms(jt,zi(pe+ie,jt),zi(pe,jt))}Qh()}else lt.lock&&(lt._lock=!lt._lock,Js(w,!0,v!=null));v!=null&&(Zt(du,vu),ko(du,n,He,qe,y,z,null))}function N_(v,w,D,N,q,Q,dt){if(lt._lock)return;gn(v);let vt=bs;if(bs){let Tt=!0,zt=!0,kt=10,Xt,ae;E.ori==0?(Xt=un,ae=fn):(Xt=fn,ae=un),Xt&&ae&&(Tt=He<=kt||He>=y-kt,zt=qe<=kt||qe>=z-kt),Xt&&Tt&&(He=He<Ir?0:y),ae&&zt&&(qe=qe<Lr?0:z),Js(null,!0,!0),bs=!1}He=-10,qe=-10,rt.fill(null),Js(null,!0,!0),vt&&(bs=vt)}function Bd(v,w,D,N,q,Q,dt){lt._lock||(gn(v),Ut(),Qh(),v!=null&&ko(xp,n,He,qe,y,z,null))}function zd(){S.forEach(ay),Gt(n.width,n.height,!0)}nr(gl,Hr,zd);let Nr={};Nr.mousedown=Fd,Nr.mousemove=Id,Nr.mouseup=Od,Nr.dblclick=Bd,Nr.setSeries=(v,w,D,N)=>{let q=je.match[2];D=q(n,w,D),D!=-1&&Bi(D,N,!0,!1)},Lt&&(Dt(gp,m,Fd),Dt(fu,m,Id),Dt(_p,m,v=>{gn(v),zo(!1)}),Dt(vp,m,N_),Dt(xp,m,Bd),Tu.add(n),n.syncRect=zo);let al=n.hooks=i.hooks||{};function dn(v,w,D){qh?Fo.push([v,w,D]):v in al&&al[v].forEach(N=>{N.call(null,n,w,D)})}(i.plugins||[]).forEach(v=>{for(let w in v.hooks)al[w]=(al[w]||[]).concat(v.hooks[w])});let kd=(v,w,D)=>D,je=Qe({key:null,setSeries:!1,filters:{pub:Pp,sub:Pp},scales:[T,A[1]?A[1].scale:null],match:[Ip,Ip,kd],values:[null,null]},lt.sync);je.match.length==2&&je.match.push(kd),lt.sync=je;let Hd=je.key,tu=Am(Hd);function ko(v,w,D,N,q,Q,dt){je.filters.pub(v,w,D,N,q,Q,dt)&&tu.pub(v,w,D,N,q,Q,dt)}tu.sub(n);function F_(v,w,D,N,q,Q,dt){je.filters.sub(v,w,D,N,q,Q,dt)&&Nr[v](null,w,D,N,q,Q,dt)}n.pub=F_;function O_(){tu.unsub(n),Tu.delete(n),_t.clear(),bu(gl,Hr,zd),c.remove(),V?.remove(),dn("destroy")}n.destroy=O_;function eu(){dn("init",i,t),St(t||i.data,!1),W[T]?Yh(T,W[T]):Ut(),Mt=Ve.show&&(Ve.width>0||Ve.height>0),X=wt=!0,Gt(i.width,i.height)}return A.forEach(qs),S.forEach(Wh),e?e instanceof HTMLElement?(e.appendChild(c),eu()):e(n,eu):eu(),n}Ze.assign=Qe;Ze.fmtNum=Du;Ze.rangeNum=_l;Ze.rangeLog=yl;Ze.rangeAsinh=Iu;Ze.orient=sr;Ze.pxRatio=Ee;Ze.join=jv;Ze.fmtDate=Nu,Ze.tzDate=cx;Ze.sync=Am;{Ze.addGap=Xx,Ze.clipGaps=Sl;let i=Ze.paths={points:Dm};i.linear=Nm,i.stepped=$x,i.bars=Zx,i.spline=Kx}var zm=112,ly=54,cy=100,Vu=[1e-6,1e6],Gu=14,Hm=i=>{let t=Math.abs(i);return t<5e-4?"0":i.toFixed(t<1?3:t<10?2:t<100?1:0)};function hy(i,[t,e]){let n=Math.max(0,Math.ceil(-Math.log10(.001*(e-t||1))));return n>6||Math.abs(i)>=1e6?i===0?"0":i.toExponential(3):i.toFixed(n).replace(/^-(0(\.0*)?)$/,"$1")}function Vm(i,{onSeek:t=()=>{},onZoom:e=()=>{},onEdit:n=()=>{},onRemove:s=()=>{}}={}){let r=[],o=[],a=null,l={range:null,heights:{}},c=[],u=0,h=null;i.classList.add("plots");function f(E){a=E&&[...new Map(E.map(O=>[String(O),O])).values()],d(o)}function d(E){o=E,r.forEach(({plot:H})=>H.destroy()),i.replaceChildren();let O=Un(),B=a??js(o);r=lp(o,B).map(H=>{let W=$("div",{class:"plot-keys"}),Z=H.curves.map(lt=>{let Pt=document.createElementNS("http://www.w3.org/2000/svg","svg");Pt.setAttribute("viewBox","0 0 22 6"),Pt.setAttribute("aria-hidden","true");let Lt=document.createElementNS("http://www.w3.org/2000/svg","line");Object.entries({x1:0,x2:22,y1:3,y2:3,stroke:lt.colour,"stroke-width":2.4,"stroke-dasharray":lt.dash.join(" ")}).forEach(([V,pt])=>Lt.setAttribute(V,pt)),Pt.append(Lt);let K=$("b");return W.append($("span",{class:"plot-key"},Pt,$("span",{},lt.name),K)),K}),k=H.unit?`${H.name} [${H.unit}]`:H.name,G=B.findIndex(lt=>H.key===(Array.isArray(lt)?lt.join():lt)),tt=(lt,Pt,Lt)=>$("button",{type:"button",class:"small",title:Pt,"aria-label":`${Pt}: ${k}`,onclick:Lt},lt),ot=$("span",{class:"plot-tools"},...H.own?[tt("edit","Change the signals",()=>n(G))]:[],tt("×","Remove this plot",()=>s(G))),rt=$("div",{class:"plot-canvas"});i.append($("section",{class:"plot"},$("header",{},$("h3",{},k),ot,W),rt));let ut={panel:H,values:Z,canvas:rt,marker:$("div",{class:"plot-now"}),cross:$("div",{class:"plot-under",hidden:!0}),flag:$("div",{class:"plot-flag",hidden:!0})};return ut.plot=m(ut,O),ut.plot.over.append(ut.marker,ut.cross,ut.flag),ut}),S()}function m({panel:E,canvas:O},B){let H=new Map;for(let V of E.curves){let pt=H.get(V.t)??{times:Array.from(V.t,Et=>Et+V.flight.shift),curves:[]};H.set(V.t,{...pt,curves:[...pt.curves,V]})}let W=[...H.values()],Z=W.map(({times:V,curves:pt})=>[V,...pt.map(Et=>Array.from(Et.values))]),k=Z.length===1?Z[0]:Ze.join(Z),G=W.flatMap(({curves:V})=>V),tt={stroke:B.faint,grid:{stroke:B.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ot=uy(o.flatMap(V=>V.impacts.map(([pt,Et])=>[pt+V.shift,Et+V.shift]))),rt=Ze.paths.stepped({align:1}),ut=E.words&&((V,pt)=>pt.map(Et=>E.words[Et]??"")),lt={width:Math.max(O.clientWidth,200),height:zm,padding:[6,20,0,0],legend:{show:!1},scales:{x:{time:!1},y:{range:(V,pt,Et)=>l.heights[E.key]??fy(pt,Et)}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!0,y:!0,uni:Gu,setScale:!1},bind:{dblclick:()=>()=>p()}},axes:[{...tt,size:22,gap:2,space:56,values:(V,pt)=>pt.map(Et=>dy(Et,pt))},{...tt,size:(V,pt)=>Math.max(ly,7*Math.max(0,...(pt??[]).map(Et=>Et.length))+8),gap:4,space:ut?13:22,...ut?{values:ut}:{}}],series:[{},...G.map(V=>({stroke:V.colour,width:1.7,dash:V.dash,spanGaps:!0,points:{show:!1},...V.held?{paths:rt}:{}}))],hooks:{drawClear:[V=>{V.ctx.fillStyle=B.force+"2e";for(let[pt,Et]of ot){let bt=V.valToPos(Math.max(pt,V.scales.x.min),"x",!0),ft=V.valToPos(Math.min(Et,V.scales.x.max),"x",!0);ft>bt&&V.ctx.fillRect(bt,V.bbox.top,Math.max(ft-bt,1),V.bbox.height)}}],setSelect:[V=>_(V,E.key)],draw:[V=>r.filter(pt=>pt.plot===V).forEach(L)]}},Pt=new Ze(lt,k,O),Lt=null;Pt.over.addEventListener("pointerdown",V=>Lt=[V.clientX,V.clientY]),Pt.over.addEventListener("pointerup",V=>{Lt&&Math.hypot(V.clientX-Lt[0],V.clientY-Lt[1])<5&&t(K(V)),Lt=null}),Pt.over.addEventListener("pointercancel",()=>Lt=null),Pt.over.addEventListener("pointermove",V=>V.pointerType!=="touch"&&I(K(V),Pt)),Pt.over.addEventListener("pointerleave",()=>I(null));let K=V=>Pt.posToVal(V.clientX-Pt.over.getBoundingClientRect().left,"x");return Pt}function _(E,O){let{left:B,top:H,width:W,height:Z}=E.select,k=W>=Gu&&W<E.over.clientWidth-1,G=Z>=Gu&&Z<E.over.clientHeight-1;if(W+Z<=0||!(k||G))return;let tt=k?[E.posToVal(B,"x"),E.posToVal(B+W,"x")]:l.range,ot=G?{[O]:[E.posToVal(H+Z,"y"),E.posToVal(H,"y")]}:{};E.setSelect({left:0,top:0,width:0,height:0},!1),g({range:tt,heights:{...l.heights,...ot}})}function g(E){JSON.stringify(E)===JSON.stringify(l)||!km(E.range)||(c=[...c,l].slice(-cy),l=E,S(),e())}function p(E,O){g({range:E===void 0?null:[E,O],heights:{}})}function A(){return c.length?(l=c.pop(),S(),e(),!0):!1}function S(){let E=o.length?[Math.min(...o.map(H=>H.begin+H.shift)),Math.max(...o.map(H=>H.end+H.shift))]:[0,1],[O,B]=l.range??E;r.forEach(({plot:H})=>H.setScale("x",{min:O,max:B})),T(u)}function x({plot:E,marker:O,cross:B}){let{min:H,max:W}=E.scales.x;for(let[Z,k]of[[O,u],[B,h]])Z.hidden=k===null||!(k>=H&&k<=W),Z.hidden||(Z.style.transform=`translateX(${E.valToPos(k,"x")}px)`)}function I(E,O){h=E;for(let B of r){if(B.flag.hidden=E===null||B.plot!==O,B.flag.hidden)continue;B.flag.textContent=`${E.toFixed(4)} s`;let H=O.valToPos(E,"x");B.flag.classList.toggle("left",H>.7*O.over.clientWidth),B.flag.style.transform=`translateX(${H}px)`}i.classList.toggle("pointing",E!==null),P()}function T(E){u=E,P()}let P=()=>r.forEach(L);function L(E){let{panel:O,plot:B,values:H}=E,W=[B.scales.y.min??0,B.scales.y.max??1];x(E),O.curves.forEach((Z,k)=>{let G=Wo(Z,h??u);H[k].textContent=O.words?.[Math.round(G)]??hy(G,W)})}function M(){r.forEach(({plot:E,canvas:O})=>{let B=O.clientWidth;B&&Math.abs(B-E.width)>1&&E.setSize({width:B,height:zm})}),T(u)}let b=new ResizeObserver(M);return b.observe(i),{replace:d,choose:f,show:T,zoom:p,back:A,resize:M,restore(E){km(E.range)&&(l=E,S(),e())},get wanted(){return a??js(o)},get range(){return l.range},get zoomed(){return l},get canGoBack(){return c.length>0},shown:()=>r.map(({panel:E,plot:O,values:B})=>({name:E.name,unit:E.unit,limits:[O.scales.y.min,O.scales.y.max],values:Object.fromEntries(E.curves.map((H,W)=>[H.name,B[W].textContent]))})),dispose(){b.disconnect(),r.forEach(({plot:E})=>E.destroy()),i.replaceChildren()}}}function km(i){if(i===null)return!0;let[t,e]=i;return e-t>=Vu[0]&&e-t<=Vu[1]&&Math.abs(t)<=Vu[1]}function uy(i){let t=[];for(let[e,n]of i.sort((s,r)=>s[0]-r[0])){let s=t[t.length-1];s&&e<=s[1]?s[1]=Math.max(s[1],n):t.push([e,n])}return t}function fy(i,t){if(i==null||t==null)return[0,1];let e=Math.max(t-i,.001*Math.max(Math.abs(i),Math.abs(t)),1e-6);return[i-.06*e,t+.08*e]}function dy(i,t){let e=0,n=.001*(t.length>1?t[1]-t[0]:1);for(;e<6&&t.some(s=>Math.abs(s-Number(s.toFixed(e)))>n);)e++;return`${i.toFixed(e)} s`}var Qo=[1,2,5,10,20,50,100,200],py=.25,my=i=>{if(i>.995)return"real time";let t=1/i;return`1/${t<10?t.toFixed(1).replace(/\.0$/,""):Math.round(t)} of real time`};function Al({scene:i,plots:t=null,bar:e,readouts:n=null,actions:s={},onRest:r=()=>{}}){let o={t:0,playing:!1,pace:"auto",line:null,flights:[],last:0},a=$("button",{class:"play",type:"button",onclick:()=>o.playing?I():x()}),l=$("button",{type:"button",title:"One instant back (←)","aria-label":"One instant back",onclick:()=>M(-1)},Es("back")),c=$("button",{type:"button",title:"One instant forward (→)","aria-label":"One instant forward",onclick:()=>M(1)},Es("forth")),u=$("button",{type:"button",title:"Go to the first touch (T)","aria-label":"Go to the first touch",onclick:b},Es("touch")),h=$("select",{"aria-label":"Speed",title:"Speed (, and .)",onchange:()=>P(h.value)},$("option",{value:"auto"},"slow at impact"),...Qo.map(k=>$("option",{value:String(k)},k===1?"real time":`1/${k}`))),f=$("output",{class:"clock","aria-live":"off"}),d=$("input",{type:"range",min:0,max:1,step:"any",value:0,"aria-label":"Time",oninput:()=>{I(),p(o.line.timeAt(Number(d.value)*o.line.total))}}),m=$("div",{class:"ticks","aria-hidden":"true"}),_=$("div",{class:"track"},m,d),g=$("div",{class:"events"});e.classList.add("player"),e.replaceChildren($("div",{class:"buttons"},a,l,c,u,h,f),_,g);function p(k){if(!o.line)return;o.t=Math.min(Math.max(k,o.line.begin),o.line.end),i.show(o.t),t?.show(o.t);let G=o.line.watchedAt(o.t)/o.line.total;d.value=G,_.style.setProperty("--share",G),A(),o.playing||r()}function A(){let k=cl(o.flights),G=k===null?"":` · ${o.t>=k?"+":"−"}${Math.abs(1e3*(o.t-k)).toFixed(1)} ms from touch`,tt=o.pace==="auto"?o.line.paceAt(o.t):1/Number(o.pace);f.replaceChildren($("b",{},`${o.t.toFixed(4)} s`),$("span",{},G),$("span",{class:"pace"},my(tt))),d.setAttribute("aria-valuetext",`${o.t.toFixed(3)} s${G}`),n&&H()}function S(k){if(!o.playing)return;let G=Math.min((k-o.last)/1e3,.1);o.last=k;let tt=o.line,ot=o.pace==="auto"?tt.timeAt(tt.watchedAt(o.t)+G):o.t+G/Number(o.pace);p(ot),o.t>=tt.end?I():requestAnimationFrame(S)}function x(){!o.line||o.playing||(o.t>=o.line.end-1e-9&&p(o.line.begin),o.playing=!0,o.last=performance.now(),T(),requestAnimationFrame(S))}function I(){o.playing&&setTimeout(r),o.playing=!1,T()}function T(){a.replaceChildren(Es(o.playing?"pause":"play")),a.setAttribute("aria-label",o.playing?"Pause":"Play"),a.title=o.playing?"Pause (space)":"Play (space)"}function P(k){o.pace=k==="auto"?"auto":String(Qo.reduce((G,tt)=>Math.abs(tt-k)<Math.abs(G-k)?tt:G)),h.value=o.pace,A(),r()}function L(k){let G=o.pace==="auto"?k>0?0:1:Qo.indexOf(Number(o.pace))+k;P(Qo[Math.min(Math.max(G,0),Qo.length-1)])}function M(k){I();let G=o.flights[0],tt=o.t-G.shift,ot=ll(G.t,tt+1e-9),rt=G.t[ot]<tt-1e-9&&k<0?ot:ot+k;p(G.t[Math.min(Math.max(rt,0),G.n-1)]+G.shift)}function b(){I();let k=cl(o.flights);k!==null&&p(k)}function E(){let k=o.line,G=rt=>k.watchedAt(rt)/k.total;m.replaceChildren(...k.stretches.map(([rt,ut])=>{let lt=$("span",{class:"slow"});return lt.style.left=`${100*G(rt)}%`,lt.style.width=`${100*Math.max(G(ut)-G(rt),.002)}%`,lt}));let tt=o.flights.flatMap(rt=>rt.events.map(ut=>({...ut,t:ut.t+rt.shift,flight:rt})));tt.sort((rt,ut)=>rt.t-ut.t);for(let rt of tt){let ut=$("i",{class:rt.kind});ut.style.left=`${100*G(rt.t)}%`,o.flights.length>1&&(ut.style.background=rt.flight.colour),m.append(ut)}let ot=o.flights.length>1;g.replaceChildren(...tt.filter(rt=>rt.kind!=="end"||!ot).slice(0,60).map(rt=>{let ut=ot?`${rt.flight.label}: ${rt.label}`:rt.label,lt=$("button",{type:"button",class:`event ${rt.kind}`,title:`${rt.text}, ${rt.t.toFixed(4)} s`,onclick:()=>{I(),p(rt.t)}},$("span",{},ut),$("small",{},` ${rt.t.toFixed(3)} s`));return ot&&lt.style.setProperty("--colour",rt.flight.colour),lt}))}let O=[];function B(){if(!n)return;let k=["speed","acceleration","compression, largest","contact force, sum of all contacts","thrust, all rotors"],G=["m/s","m/s²","mm","N","N"],tt=o.flights.length>2,ot=$("table",{class:tt?"numbers crowded":"numbers"});o.flights.length>1&&ot.append($("thead",{},$("tr",{},$("th",{},""),...o.flights.map(ut=>{let lt=$("th",{scope:"col"},ut.label);return lt.style.color=ut.colour,lt}),...tt?[]:[$("th",{},"")])));let rt=$("tbody");O=k.map((ut,lt)=>{let Pt=o.flights.map(()=>$("td")),Lt=$("td",{class:"unit"},G[lt]);return rt.append($("tr",{},$("th",{scope:"row"},tt?`${ut} [${G[lt]}]`:ut),...Pt,...tt?[]:[Lt])),Pt}),ot.append(rt),n.replaceChildren(ot)}function H(){o.flights.forEach((k,G)=>{let tt=Go(k,o.t),ot=K=>k.series.find(V=>V.panel===K),rt=K=>ot(K)?Wo({flight:k,values:ot(K).values},o.t):0,ut=Math.max(0,...k.arms.map((K,V)=>K.compliant?1e3*(K.length-tt.armLengths[V]):0)),lt=Math.hypot(...[0,1,2].map(K=>tt.contacts.reduce((V,pt)=>V+(pt?pt.force[K]:0),0))),Pt=[rt("Velocity"),rt("Acceleration"),ut,lt,tt.thrust.reduce((K,V)=>K+V,0)],Lt=!k.arms.some(K=>K.compliant);Pt.forEach((K,V)=>O[V][G].textContent=V===2&&Lt?"rigid":Hm(K))})}function W(k){if(k.ctrlKey||k.metaKey||k.altKey||k.target.closest?.("dialog"))return;let G=k.target.tagName;if(G==="TEXTAREA"||G==="SELECT"||G==="INPUT"&&k.target.type!=="range"||k.target.type==="range"&&k.target!==d)return;let tt=k.shiftKey?10:1,ot={" ":()=>o.playing?I():x(),ArrowRight:()=>M(tt),ArrowLeft:()=>M(-tt),Home:()=>(I(),p(o.line.begin)),End:()=>(I(),p(o.line.end)),",":()=>L(1),".":()=>L(-1),t:b,...s};if(k.key===" "&&G==="BUTTON")return;let rt=ot[k.key];!rt||!o.line||rt()!==!1&&k.preventDefault()}document.addEventListener("keydown",W);function Z({keepTime:k=!0}={}){o.flights=i.flights,o.line=fp(o.flights),B(),t?.replace(o.flights),E();let G=cl(o.flights);p(k?o.t:G===null?o.line.begin:G-py)}return T(),{replace:Z,seek:p,play:x,pause:I,setPace:P,goToTouch:b,get time(){return o.t},get playing(){return o.playing},get pace(){return o.pace},dispose(){I(),document.removeEventListener("keydown",W),e.replaceChildren()}}}var ks={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},xg=0,Af=1,yg=2;var Cf=1,bg=2,Zi=3,ps=0,Bn=1,zn=2,gs=0,hr=1,Rf=2,Pf=3,If=4,Mg=5,Ns=100,Sg=101,wg=102,Eg=103,Tg=104,Ag=200,Cg=201,Rg=202,Pg=203,ec=204,nc=205,Ig=206,Lg=207,Dg=208,Ug=209,Ng=210,Fg=211,Og=212,Bg=213,zg=214,Uc=0,Nc=1,Fc=2,ur=3,Oc=4,Bc=5,zc=6,kc=7,Lf=0,kg=1,Hg=2,_s=0,Vg=1,Gg=2,Wg=3,Xg=4,qg=5,Yg=6,$g=7;var Df=300,xr=301,yr=302,Hc=303,Vc=304,Ga=306,ic=1e3,Us=1001,sc=1002,pi=1003,Zg=1004;var Wa=1005;var Li=1006,Gc=1007;var Vs=1008;var Ni=1009,Uf=1010,Nf=1011,wo=1012,Wc=1013,Gs=1014,Ji=1015,Eo=1016,Xc=1017,qc=1018,To=1020,Ff=35902,Of=35899,Bf=1021,zf=1022,mi=1023,mo=1026,Ao=1027,kf=1028,Yc=1029,Hf=1030,$c=1031;var Zc=1033,Xa=33776,qa=33777,Ya=33778,$a=33779,Jc=35840,Kc=35841,jc=35842,Qc=35843,th=36196,eh=37492,nh=37496,ih=37808,sh=37809,rh=37810,oh=37811,ah=37812,lh=37813,ch=37814,hh=37815,uh=37816,fh=37817,dh=37818,ph=37819,mh=37820,gh=37821,_h=36492,vh=36494,xh=36495,yh=36283,bh=36284,Mh=36285,Sh=36286;var fa=2300,rc=2301,tc=2302,yf=2400,bf=2401,Mf=2402;var Jg=3200,Kg=3201;var Vf=0,jg=1,vs="",On="srgb",fr="srgb-linear",da="linear",Re="srgb";var cr=7680;var Sf=519,Qg=512,t0=513,e0=514,Gf=515,n0=516,i0=517,s0=518,r0=519,oc=35044;var Wf="300 es",Ii=2e3,pa=2001;var Wi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Sn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Gm=1234567,la=Math.PI/180,go=180/Math.PI;function fs(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Sn[i&255]+Sn[i>>8&255]+Sn[i>>16&255]+Sn[i>>24&255]+"-"+Sn[t&255]+Sn[t>>8&255]+"-"+Sn[t>>16&15|64]+Sn[t>>24&255]+"-"+Sn[e&63|128]+Sn[e>>8&255]+"-"+Sn[e>>16&255]+Sn[e>>24&255]+Sn[n&255]+Sn[n>>8&255]+Sn[n>>16&255]+Sn[n>>24&255]).toLowerCase()}function re(i,t,e){return Math.max(t,Math.min(e,i))}function Xf(i,t){return(i%t+t)%t}function gy(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function _y(i,t,e){return i!==t?(e-i)/(t-i):0}function ca(i,t,e){return(1-e)*i+e*t}function vy(i,t,e,n){return ca(i,t,1-Math.exp(-e*n))}function xy(i,t=1){return t-Math.abs(Xf(i,t*2)-t)}function yy(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function by(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function My(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Sy(i,t){return i+Math.random()*(t-i)}function wy(i){return i*(.5-Math.random())}function Ey(i){i!==void 0&&(Gm=i);let t=Gm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Ty(i){return i*la}function Ay(i){return i*go}function Cy(i){return(i&i-1)===0&&i!==0}function Ry(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Py(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Iy(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),u=o((t+n)/2),h=r((t-n)/2),f=o((t-n)/2),d=r((n-t)/2),m=o((n-t)/2);switch(s){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*u,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Pi(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Ce(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Ws={DEG2RAD:la,RAD2DEG:go,generateUUID:fs,clamp:re,euclideanModulo:Xf,mapLinear:gy,inverseLerp:_y,lerp:ca,damp:vy,pingpong:xy,smoothstep:yy,smootherstep:by,randInt:My,randFloat:Sy,randFloatSpread:wy,seededRandom:Ey,degToRad:Ty,radToDeg:Ay,isPowerOfTwo:Cy,ceilPowerOfTwo:Ry,floorPowerOfTwo:Py,setQuaternionFromProperEuler:Iy,normalize:Ce,denormalize:Pi},Ft=class i{constructor(t=0,e=0){i.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(re(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(re(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Gn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],d=r[o+1],m=r[o+2],_=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=m,t[e+3]=_;return}if(h!==_||l!==f||c!==d||u!==m){let g=1-a,p=l*f+c*d+u*m+h*_,A=p>=0?1:-1,S=1-p*p;if(S>Number.EPSILON){let I=Math.sqrt(S),T=Math.atan2(I,p*A);g=Math.sin(g*T)/I,a=Math.sin(a*T)/I}let x=a*A;if(l=l*g+f*x,c=c*g+d*x,u=u*g+m*x,h=h*g+_*x,g===1-a){let I=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=I,c*=I,u*=I,h*=I}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],d=r[o+2],m=r[o+3];return t[e]=a*m+u*h+l*d-c*f,t[e+1]=l*m+u*f+c*h-a*d,t[e+2]=c*m+u*d+a*f-l*h,t[e+3]=u*m-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),d=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"YXZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"ZXY":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"ZYX":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"YZX":this._x=f*u*h+c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h-f*d*m;break;case"XZY":this._x=f*u*h-c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h+f*d*m;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-n-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(re(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let d=1-e;return this._w=d*o+e*this._w,this._x=d*n+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},F=class i{constructor(t=0,e=0,n=0){i.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Wm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Wm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),u=2*(a*e-r*s),h=2*(r*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this.z=re(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this.z=re(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(re(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Wu.copy(this).projectOnVector(t),this.sub(Wu)}reflect(t){return this.sub(Wu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(re(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Wu=new F,Wm=new Gn,ce=class i{constructor(t,e,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],m=n[8],_=s[0],g=s[3],p=s[6],A=s[1],S=s[4],x=s[7],I=s[2],T=s[5],P=s[8];return r[0]=o*_+a*A+l*I,r[3]=o*g+a*S+l*T,r[6]=o*p+a*x+l*P,r[1]=c*_+u*A+h*I,r[4]=c*g+u*S+h*T,r[7]=c*p+u*x+h*P,r[2]=f*_+d*A+m*I,r[5]=f*g+d*S+m*T,r[8]=f*p+d*x+m*P,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,m=e*h+n*f+s*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return t[0]=h*_,t[1]=(s*c-u*n)*_,t[2]=(a*n-s*o)*_,t[3]=f*_,t[4]=(u*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=d*_,t[7]=(n*l-c*e)*_,t[8]=(o*e-n*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Xu.makeScale(t,e)),this}rotate(t){return this.premultiply(Xu.makeRotation(-t)),this}translate(t,e){return this.premultiply(Xu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Xu=new ce;function qf(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function ma(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function o0(){let i=ma("canvas");return i.style.display="block",i}var Xm={};function _o(i){i in Xm||(Xm[i]=!0,console.warn(i))}function a0(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var qm=new ce().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ym=new ce().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ly(){let i={enabled:!0,workingColorSpace:fr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Re&&(s.r=ds(s.r),s.g=ds(s.g),s.b=ds(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Re&&(s.r=po(s.r),s.g=po(s.g),s.b=po(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===vs?da:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return _o("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return _o("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[fr]:{primaries:t,whitePoint:n,transfer:da,toXYZ:qm,fromXYZ:Ym,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:On},outputColorSpaceConfig:{drawingBufferColorSpace:On}},[On]:{primaries:t,whitePoint:n,transfer:Re,toXYZ:qm,fromXYZ:Ym,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:On}}}),i}var ve=Ly();function ds(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function po(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Zr,ac=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Zr===void 0&&(Zr=ma("canvas")),Zr.width=t.width,Zr.height=t.height;let s=Zr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Zr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ma("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ds(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(ds(e[n]/255)*255):e[n]=ds(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Dy=0,vo=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Dy++}),this.uuid=fs(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(qu(s[o].image)):r.push(qu(s[o]))}else r=qu(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function qu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ac.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Uy=0,Yu=new F,Wn=class i extends Wi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Us,s=Us,r=Li,o=Vs,a=mi,l=Ni,c=i.DEFAULT_ANISOTROPY,u=vs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Uy++}),this.uuid=fs(),this.name="",this.source=new vo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ft(0,0),this.repeat=new Ft(1,1),this.center=new Ft(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ce,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Yu).x}get height(){return this.source.getSize(Yu).y}get depth(){return this.source.getSize(Yu).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Df)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ic:t.x=t.x-Math.floor(t.x);break;case Us:t.x=t.x<0?0:1;break;case sc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ic:t.y=t.y-Math.floor(t.y);break;case Us:t.y=t.y<0?0:1;break;case sc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Wn.DEFAULT_IMAGE=null;Wn.DEFAULT_MAPPING=Df;Wn.DEFAULT_ANISOTROPY=1;var Pe=class i{constructor(t=0,e=0,n=0,s=1){i.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],m=l[9],_=l[2],g=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-_)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+_)<.1&&Math.abs(m+g)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(c+1)/2,x=(d+1)/2,I=(p+1)/2,T=(u+f)/4,P=(h+_)/4,L=(m+g)/4;return S>x&&S>I?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=T/n,r=P/n):x>I?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=T/s,r=L/s):I<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),n=P/r,s=L/r),this.set(n,s,r,e),this}let A=Math.sqrt((g-m)*(g-m)+(h-_)*(h-_)+(f-u)*(f-u));return Math.abs(A)<.001&&(A=1),this.x=(g-m)/A,this.y=(h-_)/A,this.z=(f-u)/A,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=re(this.x,t.x,e.x),this.y=re(this.y,t.y,e.y),this.z=re(this.z,t.z,e.z),this.w=re(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=re(this.x,t,e),this.y=re(this.y,t,e),this.z=re(this.z,t,e),this.w=re(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(re(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},lc=class extends Wi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Li,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Pe(0,0,t,e),this.scissorTest=!1,this.viewport=new Pe(0,0,t,e);let s={width:t,height:e,depth:n.depth},r=new Wn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(t={}){let e={minFilter:Li,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new vo(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Xi=class extends lc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ga=class extends Wn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=pi,this.minFilter=pi,this.wrapR=Us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var cc=class extends Wn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=pi,this.minFilter=pi,this.wrapR=Us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Tn=class{constructor(t=new F(1/0,1/0,1/0),e=new F(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ai.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ai.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ai.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(t.matrixWorld),this.expandByPoint(Ai);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Cl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Cl.copy(n.boundingBox)),Cl.applyMatrix4(t.matrixWorld),this.union(Cl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ai),Ai.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ta),Rl.subVectors(this.max,ta),Jr.subVectors(t.a,ta),Kr.subVectors(t.b,ta),jr.subVectors(t.c,ta),Cs.subVectors(Kr,Jr),Rs.subVectors(jr,Kr),rr.subVectors(Jr,jr);let e=[0,-Cs.z,Cs.y,0,-Rs.z,Rs.y,0,-rr.z,rr.y,Cs.z,0,-Cs.x,Rs.z,0,-Rs.x,rr.z,0,-rr.x,-Cs.y,Cs.x,0,-Rs.y,Rs.x,0,-rr.y,rr.x,0];return!$u(e,Jr,Kr,jr,Rl)||(e=[1,0,0,0,1,0,0,0,1],!$u(e,Jr,Kr,jr,Rl))?!1:(Pl.crossVectors(Cs,Rs),e=[Pl.x,Pl.y,Pl.z],$u(e,Jr,Kr,jr,Rl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ai).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ai).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(os[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),os[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),os[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),os[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),os[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),os[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),os[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),os[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(os),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},os=[new F,new F,new F,new F,new F,new F,new F,new F],Ai=new F,Cl=new Tn,Jr=new F,Kr=new F,jr=new F,Cs=new F,Rs=new F,rr=new F,ta=new F,Rl=new F,Pl=new F,or=new F;function $u(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){or.fromArray(i,r);let a=s.x*Math.abs(or.x)+s.y*Math.abs(or.y)+s.z*Math.abs(or.z),l=t.dot(or),c=e.dot(or),u=n.dot(or);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Ny=new Tn,ea=new F,Zu=new F,Di=class{constructor(t=new F,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Ny.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ea.subVectors(t,this.center);let e=ea.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(ea,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Zu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ea.copy(t.center).add(Zu)),this.expandByPoint(ea.copy(t.center).sub(Zu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},as=new F,Ju=new F,Il=new F,Ps=new F,Ku=new F,Ll=new F,ju=new F,dr=class{constructor(t=new F,e=new F(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,as)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=as.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(as.copy(this.origin).addScaledVector(this.direction,e),as.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Ju.copy(t).add(e).multiplyScalar(.5),Il.copy(e).sub(t).normalize(),Ps.copy(this.origin).sub(Ju);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Il),a=Ps.dot(this.direction),l=-Ps.dot(Il),c=Ps.lengthSq(),u=Math.abs(1-o*o),h,f,d,m;if(u>0)if(h=o*l-a,f=o*a-l,m=r*u,h>=0)if(f>=-m)if(f<=m){let _=1/u;h*=_,f*=_,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Ju).addScaledVector(Il,f),d}intersectSphere(t,e){as.subVectors(t.center,this.origin);let n=as.dot(this.direction),s=as.dot(as)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,as)!==null}intersectTriangle(t,e,n,s,r){Ku.subVectors(e,t),Ll.subVectors(n,t),ju.crossVectors(Ku,Ll);let o=this.direction.dot(ju),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ps.subVectors(this.origin,t);let l=a*this.direction.dot(Ll.crossVectors(Ps,Ll));if(l<0)return null;let c=a*this.direction.dot(Ku.cross(Ps));if(c<0||l+c>o)return null;let u=-a*Ps.dot(ju);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},De=class i{constructor(t,e,n,s,r,o,a,l,c,u,h,f,d,m,_,g){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,u,h,f,d,m,_,g)}set(t,e,n,s,r,o,a,l,c,u,h,f,d,m,_,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=m,p[11]=_,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,n=t.elements,s=1/Qr.setFromMatrixColumn(t,0).length(),r=1/Qr.setFromMatrixColumn(t,1).length(),o=1/Qr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let f=o*u,d=o*h,m=a*u,_=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+m*c,e[5]=f-_*c,e[9]=-a*l,e[2]=_-f*c,e[6]=m+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,d=l*h,m=c*u,_=c*h;e[0]=f+_*a,e[4]=m*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-m,e[6]=_+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*u,d=l*h,m=c*u,_=c*h;e[0]=f-_*a,e[4]=-o*h,e[8]=m+d*a,e[1]=d+m*a,e[5]=o*u,e[9]=_-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,d=o*h,m=a*u,_=a*h;e[0]=l*u,e[4]=m*c-d,e[8]=f*c+_,e[1]=l*h,e[5]=_*c+f,e[9]=d*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,m=a*l,_=a*c;e[0]=l*u,e[4]=_-f*h,e[8]=m*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+m,e[10]=f-_*h}else if(t.order==="XZY"){let f=o*l,d=o*c,m=a*l,_=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+_,e[5]=o*u,e[9]=d*h-m,e[2]=m*h-d,e[6]=a*u,e[10]=_*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Fy,t,Oy)}lookAt(t,e,n){let s=this.elements;return ti.subVectors(t,e),ti.lengthSq()===0&&(ti.z=1),ti.normalize(),Is.crossVectors(n,ti),Is.lengthSq()===0&&(Math.abs(n.z)===1?ti.x+=1e-4:ti.z+=1e-4,ti.normalize(),Is.crossVectors(n,ti)),Is.normalize(),Dl.crossVectors(ti,Is),s[0]=Is.x,s[4]=Dl.x,s[8]=ti.x,s[1]=Is.y,s[5]=Dl.y,s[9]=ti.y,s[2]=Is.z,s[6]=Dl.z,s[10]=ti.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],m=n[2],_=n[6],g=n[10],p=n[14],A=n[3],S=n[7],x=n[11],I=n[15],T=s[0],P=s[4],L=s[8],M=s[12],b=s[1],E=s[5],O=s[9],B=s[13],H=s[2],W=s[6],Z=s[10],k=s[14],G=s[3],tt=s[7],ot=s[11],rt=s[15];return r[0]=o*T+a*b+l*H+c*G,r[4]=o*P+a*E+l*W+c*tt,r[8]=o*L+a*O+l*Z+c*ot,r[12]=o*M+a*B+l*k+c*rt,r[1]=u*T+h*b+f*H+d*G,r[5]=u*P+h*E+f*W+d*tt,r[9]=u*L+h*O+f*Z+d*ot,r[13]=u*M+h*B+f*k+d*rt,r[2]=m*T+_*b+g*H+p*G,r[6]=m*P+_*E+g*W+p*tt,r[10]=m*L+_*O+g*Z+p*ot,r[14]=m*M+_*B+g*k+p*rt,r[3]=A*T+S*b+x*H+I*G,r[7]=A*P+S*E+x*W+I*tt,r[11]=A*L+S*O+x*Z+I*ot,r[15]=A*M+S*B+x*k+I*rt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],m=t[3],_=t[7],g=t[11],p=t[15];return m*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*d-n*l*d)+_*(+e*l*d-e*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+g*(+e*c*h-e*a*d-r*o*h+n*o*d+r*a*u-n*c*u)+p*(-s*a*u-e*l*h+e*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],m=t[12],_=t[13],g=t[14],p=t[15],A=h*g*c-_*f*c+_*l*d-a*g*d-h*l*p+a*f*p,S=m*f*c-u*g*c-m*l*d+o*g*d+u*l*p-o*f*p,x=u*_*c-m*h*c+m*a*d-o*_*d-u*a*p+o*h*p,I=m*h*l-u*_*l-m*a*f+o*_*f+u*a*g-o*h*g,T=e*A+n*S+s*x+r*I;if(T===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let P=1/T;return t[0]=A*P,t[1]=(_*f*r-h*g*r-_*s*d+n*g*d+h*s*p-n*f*p)*P,t[2]=(a*g*r-_*l*r+_*s*c-n*g*c-a*s*p+n*l*p)*P,t[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*d-n*l*d)*P,t[4]=S*P,t[5]=(u*g*r-m*f*r+m*s*d-e*g*d-u*s*p+e*f*p)*P,t[6]=(m*l*r-o*g*r-m*s*c+e*g*c+o*s*p-e*l*p)*P,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*d+e*l*d)*P,t[8]=x*P,t[9]=(m*h*r-u*_*r-m*n*d+e*_*d+u*n*p-e*h*p)*P,t[10]=(o*_*r-m*a*r+m*n*c-e*_*c-o*n*p+e*a*p)*P,t[11]=(u*a*r-o*h*r-u*n*c+e*h*c+o*n*d-e*a*d)*P,t[12]=I*P,t[13]=(u*_*s-m*h*s+m*n*f-e*_*f-u*n*g+e*h*g)*P,t[14]=(m*a*s-o*_*s-m*n*l+e*_*l+o*n*g-e*a*g)*P,t[15]=(o*h*s-u*a*s+u*n*l-e*h*l-o*n*f+e*a*f)*P,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,m=r*h,_=o*u,g=o*h,p=a*h,A=l*c,S=l*u,x=l*h,I=n.x,T=n.y,P=n.z;return s[0]=(1-(_+p))*I,s[1]=(d+x)*I,s[2]=(m-S)*I,s[3]=0,s[4]=(d-x)*T,s[5]=(1-(f+p))*T,s[6]=(g+A)*T,s[7]=0,s[8]=(m+S)*P,s[9]=(g-A)*P,s[10]=(1-(f+_))*P,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements,r=Qr.set(s[0],s[1],s[2]).length(),o=Qr.set(s[4],s[5],s[6]).length(),a=Qr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],Ci.copy(this);let c=1/r,u=1/o,h=1/a;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=u,Ci.elements[5]*=u,Ci.elements[6]*=u,Ci.elements[8]*=h,Ci.elements[9]*=h,Ci.elements[10]*=h,e.setFromRotationMatrix(Ci),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===Ii)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===pa)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(e-t),h=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===Ii)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===pa)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Qr=new F,Ci=new De,Fy=new F(0,0,0),Oy=new F(1,1,1),Is=new F,Dl=new F,ti=new F,$m=new De,Zm=new Gn,Ui=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(re(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-re(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(re(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-re(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(re(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-re(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return $m.makeRotationFromQuaternion(t),this.setFromRotationMatrix($m,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Zm.setFromEuler(this),this.setFromQuaternion(Zm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ui.DEFAULT_ORDER="XYZ";var _a=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},By=0,Jm=new F,to=new Gn,ls=new De,Ul=new F,na=new F,zy=new F,ky=new Gn,Km=new F(1,0,0),jm=new F(0,1,0),Qm=new F(0,0,1),tg={type:"added"},Hy={type:"removed"},eo={type:"childadded",child:null},Qu={type:"childremoved",child:null},rn=class i extends Wi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:By++}),this.uuid=fs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new F,e=new Ui,n=new Gn,s=new F(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new De},normalMatrix:{value:new ce}}),this.matrix=new De,this.matrixWorld=new De,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new _a,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return to.setFromAxisAngle(t,e),this.quaternion.multiply(to),this}rotateOnWorldAxis(t,e){return to.setFromAxisAngle(t,e),this.quaternion.premultiply(to),this}rotateX(t){return this.rotateOnAxis(Km,t)}rotateY(t){return this.rotateOnAxis(jm,t)}rotateZ(t){return this.rotateOnAxis(Qm,t)}translateOnAxis(t,e){return Jm.copy(t).applyQuaternion(this.quaternion),this.position.add(Jm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Km,t)}translateY(t){return this.translateOnAxis(jm,t)}translateZ(t){return this.translateOnAxis(Qm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ls.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Ul.copy(t):Ul.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ls.lookAt(na,Ul,this.up):ls.lookAt(Ul,na,this.up),this.quaternion.setFromRotationMatrix(ls),s&&(ls.extractRotation(s.matrixWorld),to.setFromRotationMatrix(ls),this.quaternion.premultiply(to.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(tg),eo.child=t,this.dispatchEvent(eo),eo.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Hy),Qu.child=t,this.dispatchEvent(Qu),Qu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ls.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ls.multiply(t.parent.matrixWorld)),t.applyMatrix4(ls),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(tg),eo.child=t,this.dispatchEvent(eo),eo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,t,zy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,ky,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}};rn.DEFAULT_UP=new F(0,1,0);rn.DEFAULT_MATRIX_AUTO_UPDATE=!0;rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ri=new F,cs=new F,tf=new F,hs=new F,no=new F,io=new F,eg=new F,ef=new F,nf=new F,sf=new F,rf=new Pe,of=new Pe,af=new Pe,us=class i{constructor(t=new F,e=new F,n=new F){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ri.subVectors(t,e),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ri.subVectors(s,e),cs.subVectors(n,e),tf.subVectors(t,e);let o=Ri.dot(Ri),a=Ri.dot(cs),l=Ri.dot(tf),c=cs.dot(cs),u=cs.dot(tf),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,m=(o*u-a*l)*f;return r.set(1-d-m,m,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,hs)===null?!1:hs.x>=0&&hs.y>=0&&hs.x+hs.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,hs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,hs.x),l.addScaledVector(o,hs.y),l.addScaledVector(a,hs.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return rf.setScalar(0),of.setScalar(0),af.setScalar(0),rf.fromBufferAttribute(t,e),of.fromBufferAttribute(t,n),af.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(rf,r.x),o.addScaledVector(of,r.y),o.addScaledVector(af,r.z),o}static isFrontFacing(t,e,n,s){return Ri.subVectors(n,e),cs.subVectors(t,e),Ri.cross(cs).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ri.subVectors(this.c,this.b),cs.subVectors(this.a,this.b),Ri.cross(cs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;no.subVectors(s,n),io.subVectors(r,n),ef.subVectors(t,n);let l=no.dot(ef),c=io.dot(ef);if(l<=0&&c<=0)return e.copy(n);nf.subVectors(t,s);let u=no.dot(nf),h=io.dot(nf);if(u>=0&&h<=u)return e.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(n).addScaledVector(no,o);sf.subVectors(t,r);let d=no.dot(sf),m=io.dot(sf);if(m>=0&&d<=m)return e.copy(r);let _=d*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(io,a);let g=u*m-d*h;if(g<=0&&h-u>=0&&d-m>=0)return eg.subVectors(r,s),a=(h-u)/(h-u+(d-m)),e.copy(s).addScaledVector(eg,a);let p=1/(g+_+f);return o=_*p,a=f*p,e.copy(n).addScaledVector(no,o).addScaledVector(io,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},l0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ls={h:0,s:0,l:0},Nl={h:0,s:0,l:0};function lf(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=On){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=n,ve.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ve.workingColorSpace){if(t=Xf(t,1),e=re(e,0,1),n=re(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=lf(o,r,t+1/3),this.g=lf(o,r,t),this.b=lf(o,r,t-1/3)}return ve.colorSpaceToWorking(this,s),this}setStyle(t,e=On){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=On){let n=l0[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ds(t.r),this.g=ds(t.g),this.b=ds(t.b),this}copyLinearToSRGB(t){return this.r=po(t.r),this.g=po(t.g),this.b=po(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=On){return ve.workingToColorSpace(wn.copy(this),t),Math.round(re(wn.r*255,0,255))*65536+Math.round(re(wn.g*255,0,255))*256+Math.round(re(wn.b*255,0,255))}getHexString(t=On){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.workingToColorSpace(wn.copy(this),e);let n=wn.r,s=wn.g,r=wn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=ve.workingColorSpace){return ve.workingToColorSpace(wn.copy(this),e),t.r=wn.r,t.g=wn.g,t.b=wn.b,t}getStyle(t=On){ve.workingToColorSpace(wn.copy(this),t);let e=wn.r,n=wn.g,s=wn.b;return t!==On?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ls),this.setHSL(Ls.h+t,Ls.s+e,Ls.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ls),t.getHSL(Nl);let n=ca(Ls.h,Nl.h,e),s=ca(Ls.s,Nl.s,e),r=ca(Ls.l,Nl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},wn=new he;he.NAMES=l0;var Vy=0,qi=class extends Wi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Vy++}),this.uuid=fs(),this.name="",this.type="Material",this.blending=hr,this.side=ps,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ec,this.blendDst=nc,this.blendEquation=Ns,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=ur,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Sf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=cr,this.stencilZFail=cr,this.stencilZPass=cr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==hr&&(n.blending=this.blending),this.side!==ps&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==ec&&(n.blendSrc=this.blendSrc),this.blendDst!==nc&&(n.blendDst=this.blendDst),this.blendEquation!==Ns&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==ur&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Sf&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==cr&&(n.stencilFail=this.stencilFail),this.stencilZFail!==cr&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==cr&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},Yi=class extends qi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.combine=Lf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var tn=new F,Fl=new Ft,Gy=0,vn=class{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Gy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=oc,this.updateRanges=[],this.gpuType=Ji,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Fl.fromBufferAttribute(this,e),Fl.applyMatrix3(t),this.setXY(e,Fl.x,Fl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)tn.fromBufferAttribute(this,e),tn.applyMatrix3(t),this.setXYZ(e,tn.x,tn.y,tn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)tn.fromBufferAttribute(this,e),tn.applyMatrix4(t),this.setXYZ(e,tn.x,tn.y,tn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)tn.fromBufferAttribute(this,e),tn.applyNormalMatrix(t),this.setXYZ(e,tn.x,tn.y,tn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)tn.fromBufferAttribute(this,e),tn.transformDirection(t),this.setXYZ(e,tn.x,tn.y,tn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Ce(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Pi(e,this.array)),e}setX(t,e){return this.normalized&&(e=Ce(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Pi(e,this.array)),e}setY(t,e){return this.normalized&&(e=Ce(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Pi(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Ce(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Pi(e,this.array)),e}setW(t,e){return this.normalized&&(e=Ce(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array),s=Ce(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array),s=Ce(s,this.array),r=Ce(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==oc&&(t.usage=this.usage),t}};var va=class extends vn{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var xa=class extends vn{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var _e=class extends vn{constructor(t,e,n){super(new Float32Array(t),e,n)}},Wy=0,fi=new De,cf=new rn,so=new F,ei=new Tn,ia=new Tn,mn=new F,Je=class i extends Wi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Wy++}),this.uuid=fs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(qf(t)?xa:va)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ce().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return fi.makeRotationFromQuaternion(t),this.applyMatrix4(fi),this}rotateX(t){return fi.makeRotationX(t),this.applyMatrix4(fi),this}rotateY(t){return fi.makeRotationY(t),this.applyMatrix4(fi),this}rotateZ(t){return fi.makeRotationZ(t),this.applyMatrix4(fi),this}translate(t,e,n){return fi.makeTranslation(t,e,n),this.applyMatrix4(fi),this}scale(t,e,n){return fi.makeScale(t,e,n),this.applyMatrix4(fi),this}lookAt(t){return cf.lookAt(t),cf.updateMatrix(),this.applyMatrix4(cf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(so).negate(),this.translate(so.x,so.y,so.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new _e(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Tn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new F(-1/0,-1/0,-1/0),new F(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ei.setFromBufferAttribute(r),this.morphTargetsRelative?(mn.addVectors(this.boundingBox.min,ei.min),this.boundingBox.expandByPoint(mn),mn.addVectors(this.boundingBox.max,ei.max),this.boundingBox.expandByPoint(mn)):(this.boundingBox.expandByPoint(ei.min),this.boundingBox.expandByPoint(ei.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new F,1/0);return}if(t){let n=this.boundingSphere.center;if(ei.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(mn.addVectors(ei.min,ia.min),ei.expandByPoint(mn),mn.addVectors(ei.max,ia.max),ei.expandByPoint(mn)):(ei.expandByPoint(ia.min),ei.expandByPoint(ia.max))}ei.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)mn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(mn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)mn.fromBufferAttribute(a,c),l&&(so.fromBufferAttribute(t,c),mn.add(so)),s=Math.max(s,n.distanceToSquared(mn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new vn(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let L=0;L<n.count;L++)a[L]=new F,l[L]=new F;let c=new F,u=new F,h=new F,f=new Ft,d=new Ft,m=new Ft,_=new F,g=new F;function p(L,M,b){c.fromBufferAttribute(n,L),u.fromBufferAttribute(n,M),h.fromBufferAttribute(n,b),f.fromBufferAttribute(r,L),d.fromBufferAttribute(r,M),m.fromBufferAttribute(r,b),u.sub(c),h.sub(c),d.sub(f),m.sub(f);let E=1/(d.x*m.y-m.x*d.y);isFinite(E)&&(_.copy(u).multiplyScalar(m.y).addScaledVector(h,-d.y).multiplyScalar(E),g.copy(h).multiplyScalar(d.x).addScaledVector(u,-m.x).multiplyScalar(E),a[L].add(_),a[M].add(_),a[b].add(_),l[L].add(g),l[M].add(g),l[b].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let L=0,M=A.length;L<M;++L){let b=A[L],E=b.start,O=b.count;for(let B=E,H=E+O;B<H;B+=3)p(t.getX(B+0),t.getX(B+1),t.getX(B+2))}let S=new F,x=new F,I=new F,T=new F;function P(L){I.fromBufferAttribute(s,L),T.copy(I);let M=a[L];S.copy(M),S.sub(I.multiplyScalar(I.dot(M))).normalize(),x.crossVectors(T,M);let E=x.dot(l[L])<0?-1:1;o.setXYZW(L,S.x,S.y,S.z,E)}for(let L=0,M=A.length;L<M;++L){let b=A[L],E=b.start,O=b.count;for(let B=E,H=E+O;B<H;B+=3)P(t.getX(B+0)),P(t.getX(B+1)),P(t.getX(B+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new vn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new F,r=new F,o=new F,a=new F,l=new F,c=new F,u=new F,h=new F;if(t)for(let f=0,d=t.count;f<d;f+=3){let m=t.getX(f+0),_=t.getX(f+1),g=t.getX(f+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)mn.fromBufferAttribute(t,e),mn.normalize(),t.setXYZ(e,mn.x,mn.y,mn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,m=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?d=l[_]*a.data.stride+a.offset:d=l[_]*u;for(let p=0;p<u;p++)f[m++]=c[d++]}return new vn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},ng=new De,ar=new dr,Ol=new Di,ig=new F,Bl=new F,zl=new F,kl=new F,hf=new F,Hl=new F,sg=new F,Vl=new F,de=class extends rn{constructor(t=new Je,e=new Yi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Hl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(hf.fromBufferAttribute(h,t),o?Hl.addScaledVector(hf,u):Hl.addScaledVector(hf.sub(e),u))}e.add(Hl)}return e}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ol.copy(n.boundingSphere),Ol.applyMatrix4(r),ar.copy(t.ray).recast(t.near),!(Ol.containsPoint(ar.origin)===!1&&(ar.intersectSphere(Ol,ig)===null||ar.origin.distanceToSquared(ig)>(t.far-t.near)**2))&&(ng.copy(r).invert(),ar.copy(t.ray).applyMatrix4(ng),!(n.boundingBox!==null&&ar.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,ar)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=f.length;m<_;m++){let g=f[m],p=o[g.materialIndex],A=Math.max(g.start,d.start),S=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let x=A,I=S;x<I;x+=3){let T=a.getX(x),P=a.getX(x+1),L=a.getX(x+2);s=Gl(this,p,t,n,c,u,h,T,P,L),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,d.start),_=Math.min(a.count,d.start+d.count);for(let g=m,p=_;g<p;g+=3){let A=a.getX(g),S=a.getX(g+1),x=a.getX(g+2);s=Gl(this,o,t,n,c,u,h,A,S,x),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=f.length;m<_;m++){let g=f[m],p=o[g.materialIndex],A=Math.max(g.start,d.start),S=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let x=A,I=S;x<I;x+=3){let T=x,P=x+1,L=x+2;s=Gl(this,p,t,n,c,u,h,T,P,L),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,d.start),_=Math.min(l.count,d.start+d.count);for(let g=m,p=_;g<p;g+=3){let A=g,S=g+1,x=g+2;s=Gl(this,o,t,n,c,u,h,A,S,x),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Xy(i,t,e,n,s,r,o,a){let l;if(t.side===Bn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===ps,a),l===null)return null;Vl.copy(a),Vl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Vl);return c<e.near||c>e.far?null:{distance:c,point:Vl.clone(),object:i}}function Gl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Bl),i.getVertexPosition(l,zl),i.getVertexPosition(c,kl);let u=Xy(i,t,e,n,Bl,zl,kl,sg);if(u){let h=new F;us.getBarycoord(sg,Bl,zl,kl,h),s&&(u.uv=us.getInterpolatedAttribute(s,a,l,c,h,new Ft)),r&&(u.uv1=us.getInterpolatedAttribute(r,a,l,c,h,new Ft)),o&&(u.normal=us.getInterpolatedAttribute(o,a,l,c,h,new F),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new F,materialIndex:0};us.getNormal(Bl,zl,kl,f.normal),u.face=f,u.barycoord=h}return u}var $i=class i extends Je{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;m("z","y","x",-1,-1,n,e,t,o,r,0),m("z","y","x",1,-1,n,e,-t,o,r,1),m("x","z","y",1,1,t,n,e,s,o,2),m("x","z","y",1,-1,t,n,-e,s,o,3),m("x","y","z",1,-1,t,e,n,s,r,4),m("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new _e(c,3)),this.setAttribute("normal",new _e(u,3)),this.setAttribute("uv",new _e(h,2));function m(_,g,p,A,S,x,I,T,P,L,M){let b=x/P,E=I/L,O=x/2,B=I/2,H=T/2,W=P+1,Z=L+1,k=0,G=0,tt=new F;for(let ot=0;ot<Z;ot++){let rt=ot*E-B;for(let ut=0;ut<W;ut++){let lt=ut*b-O;tt[_]=lt*A,tt[g]=rt*S,tt[p]=H,c.push(tt.x,tt.y,tt.z),tt[_]=0,tt[g]=0,tt[p]=T>0?1:-1,u.push(tt.x,tt.y,tt.z),h.push(ut/P),h.push(1-ot/L),k+=1}}for(let ot=0;ot<L;ot++)for(let rt=0;rt<P;rt++){let ut=f+rt+W*ot,lt=f+rt+W*(ot+1),Pt=f+(rt+1)+W*(ot+1),Lt=f+(rt+1)+W*ot;l.push(ut,lt,Lt),l.push(lt,Pt,Lt),G+=6}a.addGroup(d,G,M),d+=G,f+=k}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function br(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function An(i){let t={};for(let e=0;e<i.length;e++){let n=br(i[e]);for(let s in n)t[s]=n[s]}return t}function qy(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Yf(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var Za={clone:br,merge:An},Yy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,$y=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ni=class extends qi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Yy,this.fragmentShader=$y,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=br(t.uniforms),this.uniformsGroups=qy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}},ya=class extends rn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new De,this.projectionMatrix=new De,this.projectionMatrixInverse=new De,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Ds=new F,rg=new Ft,og=new Ft,En=class extends ya{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=go*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(la*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return go*2*Math.atan(Math.tan(la*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ds.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ds.x,Ds.y).multiplyScalar(-t/Ds.z),Ds.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ds.x,Ds.y).multiplyScalar(-t/Ds.z)}getViewSize(t,e){return this.getViewBounds(t,rg,og),e.subVectors(og,rg)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(la*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},ro=-90,oo=1,hc=class extends rn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new En(ro,oo,t,e);s.layers=this.layers,this.add(s);let r=new En(ro,oo,t,e);r.layers=this.layers,this.add(r);let o=new En(ro,oo,t,e);o.layers=this.layers,this.add(o);let a=new En(ro,oo,t,e);a.layers=this.layers,this.add(a);let l=new En(ro,oo,t,e);l.layers=this.layers,this.add(l);let c=new En(ro,oo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ii)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===pa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let _=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=_,t.setRenderTarget(n,5,s),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},ba=class extends Wn{constructor(t=[],e=xr,n,s,r,o,a,l,c,u){super(t,e,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},uc=class extends Xi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ba(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new $i(5,5,5),r=new ni({name:"CubemapFromEquirect",uniforms:br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Bn,blending:gs});r.uniforms.tEquirect.value=e;let o=new de(s,r),a=e.minFilter;return e.minFilter===Vs&&(e.minFilter=Li),new hc(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Ke=class extends rn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Zy={type:"move"},xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ke,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ke,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new F,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new F),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ke,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new F,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new F),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let g=e.getJointPose(_,n),p=this._getHandJoint(c,_);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Zy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ke;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}};var yo=class extends rn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ui,this.environmentIntensity=1,this.environmentRotation=new Ui,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ma=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=oc,this.updateRanges=[],this.version=0,this.uuid=fs()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=fs()),t.arrayBuffers[this.array.buffer._uuid]===void 0&&(t.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);let e=new this.array.constructor(t.arrayBuffers[this.array.buffer._uuid]),n=new this.constructor(e,this.stride);return n.setUsage(this.usage),n}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){return t.arrayBuffers===void 0&&(t.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=fs()),t.arrayBuffers[this.array.buffer._uuid]===void 0&&(t.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}},Fn=new F,ii=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)Fn.fromBufferAttribute(this,e),Fn.applyMatrix4(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Fn.fromBufferAttribute(this,e),Fn.applyNormalMatrix(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Fn.fromBufferAttribute(this,e),Fn.transformDirection(t),this.setXYZ(e,Fn.x,Fn.y,Fn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Ce(n,this.array)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=Ce(e,this.array)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=Ce(e,this.array)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=Ce(e,this.array)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=Ce(e,this.array)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=Pi(e,this.array)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=Pi(e,this.array)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=Pi(e,this.array)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=Pi(e,this.array)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array),s=Ce(s,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array),s=Ce(s,this.array),r=Ce(r,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){console.log("THREE.InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new vn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){console.log("THREE.InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}},bo=class extends qi{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new he(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},ao,sa=new F,lo=new F,co=new F,ho=new Ft,ra=new Ft,c0=new De,Wl=new F,oa=new F,Xl=new F,ag=new Ft,uf=new Ft,lg=new Ft,Sa=class extends rn{constructor(t=new bo){if(super(),this.isSprite=!0,this.type="Sprite",ao===void 0){ao=new Je;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Ma(e,5);ao.setIndex([0,1,2,0,2,3]),ao.setAttribute("position",new ii(n,3,0,!1)),ao.setAttribute("uv",new ii(n,2,3,!1))}this.geometry=ao,this.material=t,this.center=new Ft(.5,.5),this.count=1}raycast(t,e){t.camera===null&&console.error('THREE.Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),lo.setFromMatrixScale(this.matrixWorld),c0.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),co.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&lo.multiplyScalar(-co.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;ql(Wl.set(-.5,-.5,0),co,o,lo,s,r),ql(oa.set(.5,-.5,0),co,o,lo,s,r),ql(Xl.set(.5,.5,0),co,o,lo,s,r),ag.set(0,0),uf.set(1,0),lg.set(1,1);let a=t.ray.intersectTriangle(Wl,oa,Xl,!1,sa);if(a===null&&(ql(oa.set(-.5,.5,0),co,o,lo,s,r),uf.set(0,1),a=t.ray.intersectTriangle(Wl,Xl,oa,!1,sa),a===null))return;let l=t.ray.origin.distanceTo(sa);l<t.near||l>t.far||e.push({distance:l,point:sa.clone(),uv:us.getInterpolation(sa,Wl,oa,Xl,ag,uf,lg,new Ft),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}};function ql(i,t,e,n,s,r){ho.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(ra.x=r*ho.x-s*ho.y,ra.y=s*ho.x+r*ho.y):ra.copy(ho),i.copy(t),i.x+=ra.x,i.y+=ra.y,i.applyMatrix4(c0)}var ff=new F,Jy=new F,Ky=new ce,di=class{constructor(t=new F(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=ff.subVectors(n,e).cross(Jy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let n=t.delta(ff),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Ky.getNormalMatrix(t),s=this.coplanarPoint(ff).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},lr=new Di,jy=new Ft(.5,.5),Yl=new F,Mo=class{constructor(t=new di,e=new di,n=new di,s=new di,r=new di,o=new di){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ii,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],m=r[8],_=r[9],g=r[10],p=r[11],A=r[12],S=r[13],x=r[14],I=r[15];if(s[0].setComponents(c-o,d-u,p-m,I-A).normalize(),s[1].setComponents(c+o,d+u,p+m,I+A).normalize(),s[2].setComponents(c+a,d+h,p+_,I+S).normalize(),s[3].setComponents(c-a,d-h,p-_,I-S).normalize(),n)s[4].setComponents(l,f,g,x).normalize(),s[5].setComponents(c-l,d-f,p-g,I-x).normalize();else if(s[4].setComponents(c-l,d-f,p-g,I-x).normalize(),e===Ii)s[5].setComponents(c+l,d+f,p+g,I+x).normalize();else if(e===pa)s[5].setComponents(l,f,g,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),lr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),lr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(lr)}intersectsSprite(t){lr.center.set(0,0,0);let e=jy.distanceTo(t.center);return lr.radius=.7071067811865476+e,lr.applyMatrix4(t.matrixWorld),this.intersectsSphere(lr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Yl.x=s.normal.x>0?t.max.x:t.min.x,Yl.y=s.normal.y>0?t.max.y:t.min.y,Yl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Yl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Fs=class extends qi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},fc=new F,dc=new F,cg=new De,aa=new dr,$l=new Di,df=new F,hg=new F,pr=class extends rn{constructor(t=new Je,e=new Fs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)fc.fromBufferAttribute(e,s-1),dc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=fc.distanceTo(dc);t.setAttribute("lineDistance",new _e(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),$l.copy(n.boundingSphere),$l.applyMatrix4(s),$l.radius+=r,t.ray.intersectsSphere($l)===!1)return;cg.copy(s).invert(),aa.copy(t.ray).applyMatrix4(cg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let _=d,g=m-1;_<g;_+=c){let p=u.getX(_),A=u.getX(_+1),S=Zl(this,t,aa,l,p,A,_);S&&e.push(S)}if(this.isLineLoop){let _=u.getX(m-1),g=u.getX(d),p=Zl(this,t,aa,l,_,g,m-1);p&&e.push(p)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let _=d,g=m-1;_<g;_+=c){let p=Zl(this,t,aa,l,_,_+1,_);p&&e.push(p)}if(this.isLineLoop){let _=Zl(this,t,aa,l,m-1,d,m-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Zl(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(fc.fromBufferAttribute(a,s),dc.fromBufferAttribute(a,r),e.distanceSqToSegment(fc,dc,df,hg)>n)return;df.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(df);if(!(c<t.near||c>t.far))return{distance:c,point:hg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var ug=new F,fg=new F,wa=class extends pr{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)ug.fromBufferAttribute(e,s),fg.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+ug.distanceTo(fg);t.setAttribute("lineDistance",new _e(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ea=class extends Wn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},Ta=class extends Wn{constructor(t,e,n=Gs,s,r,o,a=pi,l=pi,c,u=mo,h=1){if(u!==mo&&u!==Ao)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new vo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},Aa=class extends Wn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}};var mr=class i extends Je{constructor(t=1,e=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:n,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new F,u=new Ft;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=e;h++,f+=3){let d=n+h/e*s;c.x=t*Math.cos(d),c.y=t*Math.sin(d),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/t+1)/2,u.y=(o[f+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new _e(o,3)),this.setAttribute("normal",new _e(a,3)),this.setAttribute("uv",new _e(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.segments,t.thetaStart,t.thetaLength)}},si=class i extends Je{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],d=[],m=0,_=[],g=n/2,p=0;A(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(u),this.setAttribute("position",new _e(h,3)),this.setAttribute("normal",new _e(f,3)),this.setAttribute("uv",new _e(d,2));function A(){let x=new F,I=new F,T=0,P=(e-t)/n;for(let L=0;L<=r;L++){let M=[],b=L/r,E=b*(e-t)+t;for(let O=0;O<=s;O++){let B=O/s,H=B*l+a,W=Math.sin(H),Z=Math.cos(H);I.x=E*W,I.y=-b*n+g,I.z=E*Z,h.push(I.x,I.y,I.z),x.set(W,P,Z).normalize(),f.push(x.x,x.y,x.z),d.push(B,1-b),M.push(m++)}_.push(M)}for(let L=0;L<s;L++)for(let M=0;M<r;M++){let b=_[M][L],E=_[M+1][L],O=_[M+1][L+1],B=_[M][L+1];(t>0||M!==0)&&(u.push(b,E,B),T+=3),(e>0||M!==r-1)&&(u.push(E,O,B),T+=3)}c.addGroup(p,T,0),p+=T}function S(x){let I=m,T=new Ft,P=new F,L=0,M=x===!0?t:e,b=x===!0?1:-1;for(let O=1;O<=s;O++)h.push(0,g*b,0),f.push(0,b,0),d.push(.5,.5),m++;let E=m;for(let O=0;O<=s;O++){let H=O/s*l+a,W=Math.cos(H),Z=Math.sin(H);P.x=M*Z,P.y=g*b,P.z=M*W,h.push(P.x,P.y,P.z),f.push(0,b,0),T.x=W*.5+.5,T.y=Z*.5*b+.5,d.push(T.x,T.y),m++}for(let O=0;O<s;O++){let B=I+O,H=E+O;x===!0?u.push(H,H+1,B):u.push(H+1,H,B),L+=3}c.addGroup(p,L,x===!0?1:2),p+=L}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},gr=class i extends si{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Xn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let u=n[s],f=n[s+1]-u,d=(o-u)/f;return(s+d)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new Ft:new F);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new F,s=[],r=[],o=[],a=new F,l=new De;for(let d=0;d<=t;d++){let m=d/t;s[d]=this.getTangentAt(m,new F)}r[0]=new F,o[0]=new F;let c=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let d=1;d<=t;d++){if(r[d]=r[d-1].clone(),o[d]=o[d-1].clone(),a.crossVectors(s[d-1],s[d]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(re(s[d-1].dot(s[d]),-1,1));r[d].applyMatrix4(l.makeRotationAxis(a,m))}o[d].crossVectors(s[d],r[d])}if(e===!0){let d=Math.acos(re(r[0].dot(r[t]),-1,1));d/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(d=-d);for(let m=1;m<=t;m++)r[m].applyMatrix4(l.makeRotationAxis(s[m],d*m)),o[m].crossVectors(s[m],r[m])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}},Ca=class extends Xn{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new Ft){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,d=c-this.aY;l=f*u-d*h+this.aX,c=f*h+d*u+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},pc=class extends Ca{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function $f(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,d=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,d*=u,s(o,a,f,d)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var Jl=new F,pf=new $f,mf=new $f,gf=new $f,mc=class extends Xn{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new F){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:(Jl.subVectors(s[0],s[1]).add(s[0]),c=Jl);let h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(Jl.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=Jl),this.curveType==="centripetal"||this.curveType==="chordal"){let d=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(h),d),_=Math.pow(h.distanceToSquared(f),d),g=Math.pow(f.distanceToSquared(u),d);_<1e-4&&(_=1),m<1e-4&&(m=_),g<1e-4&&(g=_),pf.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,m,_,g),mf.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,m,_,g),gf.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,m,_,g)}else this.curveType==="catmullrom"&&(pf.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),mf.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),gf.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(pf.calc(l),mf.calc(l),gf.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new F().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function dg(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function Qy(i,t){let e=1-i;return e*e*t}function tb(i,t){return 2*(1-i)*i*t}function eb(i,t){return i*i*t}function ha(i,t,e,n){return Qy(i,t)+tb(i,e)+eb(i,n)}function nb(i,t){let e=1-i;return e*e*e*t}function ib(i,t){let e=1-i;return 3*e*e*i*t}function sb(i,t){return 3*(1-i)*i*i*t}function rb(i,t){return i*i*i*t}function ua(i,t,e,n,s){return nb(i,t)+ib(i,e)+sb(i,n)+rb(i,s)}var gc=class extends Xn{constructor(t=new Ft,e=new Ft,n=new Ft,s=new Ft){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new Ft){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ua(t,s.x,r.x,o.x,a.x),ua(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},_c=class extends Xn{constructor(t=new F,e=new F,n=new F,s=new F){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new F){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ua(t,s.x,r.x,o.x,a.x),ua(t,s.y,r.y,o.y,a.y),ua(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},vc=class extends Xn{constructor(t=new Ft,e=new Ft){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Ft){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Ft){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},xc=class extends Xn{constructor(t=new F,e=new F){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new F){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new F){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},yc=class extends Xn{constructor(t=new Ft,e=new Ft,n=new Ft){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new Ft){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ha(t,s.x,r.x,o.x),ha(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Ra=class extends Xn{constructor(t=new F,e=new F,n=new F){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new F){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ha(t,s.x,r.x,o.x),ha(t,s.y,r.y,o.y),ha(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},bc=class extends Xn{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Ft){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(dg(a,l.x,c.x,u.x,h.x),dg(a,l.y,c.y,u.y,h.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new Ft().fromArray(s))}return this}},ob=Object.freeze({__proto__:null,ArcCurve:pc,CatmullRomCurve3:mc,CubicBezierCurve:gc,CubicBezierCurve3:_c,EllipseCurve:Ca,LineCurve:vc,LineCurve3:xc,QuadraticBezierCurve:yc,QuadraticBezierCurve3:Ra,SplineCurve:bc});var Pa=class i extends Je{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],m=[],_=[],g=[];for(let p=0;p<u;p++){let A=p*f-o;for(let S=0;S<c;S++){let x=S*h-r;m.push(x,-A,0),_.push(0,0,1),g.push(S/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let A=0;A<a;A++){let S=A+c*p,x=A+c*(p+1),I=A+1+c*(p+1),T=A+1+c*p;d.push(S,x,T),d.push(x,I,T)}this.setIndex(d),this.setAttribute("position",new _e(m,3)),this.setAttribute("normal",new _e(_,3)),this.setAttribute("uv",new _e(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ia=class i extends Je{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new F,f=new F,d=[],m=[],_=[],g=[];for(let p=0;p<=n;p++){let A=[],S=p/n,x=0;p===0&&o===0?x=.5/e:p===n&&l===Math.PI&&(x=-.5/e);for(let I=0;I<=e;I++){let T=I/e;h.x=-t*Math.cos(s+T*r)*Math.sin(o+S*a),h.y=t*Math.cos(o+S*a),h.z=t*Math.sin(s+T*r)*Math.sin(o+S*a),m.push(h.x,h.y,h.z),f.copy(h).normalize(),_.push(f.x,f.y,f.z),g.push(T+x,1-S),A.push(c++)}u.push(A)}for(let p=0;p<n;p++)for(let A=0;A<e;A++){let S=u[p][A+1],x=u[p][A],I=u[p+1][A],T=u[p+1][A+1];(p!==0||o>0)&&d.push(S,x,T),(p!==n-1||l<Math.PI)&&d.push(x,I,T)}this.setIndex(d),this.setAttribute("position",new _e(m,3)),this.setAttribute("normal",new _e(_,3)),this.setAttribute("uv",new _e(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var La=class i extends Je{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],l=[],c=[],u=new F,h=new F,f=new F;for(let d=0;d<=n;d++)for(let m=0;m<=s;m++){let _=m/s*r,g=d/n*Math.PI*2;h.x=(t+e*Math.cos(g))*Math.cos(_),h.y=(t+e*Math.cos(g))*Math.sin(_),h.z=e*Math.sin(g),a.push(h.x,h.y,h.z),u.x=t*Math.cos(_),u.y=t*Math.sin(_),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(m/s),c.push(d/n)}for(let d=1;d<=n;d++)for(let m=1;m<=s;m++){let _=(s+1)*d+m-1,g=(s+1)*(d-1)+m-1,p=(s+1)*(d-1)+m,A=(s+1)*d+m;o.push(_,g,A),o.push(g,p,A)}this.setIndex(o),this.setAttribute("position",new _e(a,3)),this.setAttribute("normal",new _e(l,3)),this.setAttribute("uv",new _e(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}};var Da=class i extends Je{constructor(t=new Ra(new F(-1,-1,0),new F(-1,1,0),new F(1,1,0)),e=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:t,tubularSegments:e,radius:n,radialSegments:s,closed:r};let o=t.computeFrenetFrames(e,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new F,l=new F,c=new Ft,u=new F,h=[],f=[],d=[],m=[];_(),this.setIndex(m),this.setAttribute("position",new _e(h,3)),this.setAttribute("normal",new _e(f,3)),this.setAttribute("uv",new _e(d,2));function _(){for(let S=0;S<e;S++)g(S);g(r===!1?e:0),A(),p()}function g(S){u=t.getPointAt(S/e,u);let x=o.normals[S],I=o.binormals[S];for(let T=0;T<=s;T++){let P=T/s*Math.PI*2,L=Math.sin(P),M=-Math.cos(P);l.x=M*x.x+L*I.x,l.y=M*x.y+L*I.y,l.z=M*x.z+L*I.z,l.normalize(),f.push(l.x,l.y,l.z),a.x=u.x+n*l.x,a.y=u.y+n*l.y,a.z=u.z+n*l.z,h.push(a.x,a.y,a.z)}}function p(){for(let S=1;S<=e;S++)for(let x=1;x<=s;x++){let I=(s+1)*(S-1)+(x-1),T=(s+1)*S+(x-1),P=(s+1)*S+x,L=(s+1)*(S-1)+x;m.push(I,T,L),m.push(T,P,L)}}function A(){for(let S=0;S<=e;S++)for(let x=0;x<=s;x++)c.x=S/e,c.y=x/s,d.push(c.x,c.y)}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON();return t.path=this.parameters.path.toJSON(),t}static fromJSON(t){return new i(new ob[t.path.type]().fromJSON(t.path),t.tubularSegments,t.radius,t.radialSegments,t.closed)}},Ua=class extends Je{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,s=new F,r=new F;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,d=h.count;for(let m=f,_=f+d;m<_;m+=3)for(let g=0;g<3;g++){let p=a.getX(m+g),A=a.getX(m+(g+1)%3);s.fromBufferAttribute(o,p),r.fromBufferAttribute(o,A),pg(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),pg(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new _e(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function pg(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(s)===!0?!1:(e.add(n),e.add(s),!0)}var ms=class extends qi{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new he(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Vf,this.normalScale=new Ft(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Mc=class extends qi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Jg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Sc=class extends qi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Kl(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function ab(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var _r=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},wc=class extends _r{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:yf,endingEnd:yf}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case bf:r=t,a=2*e-n;break;case Mf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case bf:o=t,l=2*n-e;break;case Mf:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(n-e)/(s-e),_=m*m,g=_*m,p=-f*g+2*f*_-f*m,A=(1+f)*g+(-1.5-2*f)*_+(-.5+f)*m+1,S=(-1-d)*g+(1.5+d)*_+.5*m,x=d*g-d*_;for(let I=0;I!==a;++I)r[I]=p*o[u+I]+A*o[c+I]+S*o[l+I]+x*o[h+I];return r}},Ec=class extends _r{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(n-e)/(s-e),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Tc=class extends _r{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},ri=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Kl(e,this.TimeBufferType),this.values=Kl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Kl(t.times,Array),values:Kl(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s)}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Tc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Ec(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new wc(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case fa:e=this.InterpolantFactoryMethodDiscrete;break;case rc:e=this.InterpolantFactoryMethodLinear;break;case tc:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return fa;case this.InterpolantFactoryMethodLinear:return rc;case this.InterpolantFactoryMethodSmooth:return tc}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&ab(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===tc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let m=0;m!==n;++m){let _=e[h+m];if(_!==e[f+m]||_!==e[d+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)e[f+d]=e[h+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};ri.prototype.ValueTypeName="";ri.prototype.TimeBufferType=Float32Array;ri.prototype.ValueBufferType=Float32Array;ri.prototype.DefaultInterpolation=rc;var Os=class extends ri{constructor(t,e,n){super(t,e,n)}};Os.prototype.ValueTypeName="bool";Os.prototype.ValueBufferType=Array;Os.prototype.DefaultInterpolation=fa;Os.prototype.InterpolantFactoryMethodLinear=void 0;Os.prototype.InterpolantFactoryMethodSmooth=void 0;var Ac=class extends ri{constructor(t,e,n,s){super(t,e,n,s)}};Ac.prototype.ValueTypeName="color";var Cc=class extends ri{constructor(t,e,n,s){super(t,e,n,s)}};Cc.prototype.ValueTypeName="number";var Rc=class extends _r{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)Gn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Na=class extends ri{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Rc(this.times,this.values,this.getValueSize(),t)}};Na.prototype.ValueTypeName="quaternion";Na.prototype.InterpolantFactoryMethodSmooth=void 0;var Bs=class extends ri{constructor(t,e,n){super(t,e,n)}};Bs.prototype.ValueTypeName="string";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=fa;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var Pc=class extends ri{constructor(t,e,n,s){super(t,e,n,s)}};Pc.prototype.ValueTypeName="vector";var Ic=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],m=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},h0=new Ic,Lc=class{constructor(t){this.manager=t!==void 0?t:h0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}abort(){return this}};Lc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Fa=class extends rn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}},Oa=class extends Fa{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(rn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}},_f=new De,mg=new F,gg=new F,wf=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ft(512,512),this.mapType=Ni,this.map=null,this.mapPass=null,this.matrix=new De,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Mo,this._frameExtents=new Ft(1,1),this._viewportCount=1,this._viewports=[new Pe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera,n=this.matrix;mg.setFromMatrixPosition(t.matrixWorld),e.position.copy(mg),gg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(gg),e.updateMatrixWorld(),_f.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(_f,e.coordinateSystem,e.reversedDepth),e.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(_f)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}};var vr=class extends ya{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Ef=class extends wf{constructor(){super(new vr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ba=class extends Fa{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(rn.DEFAULT_UP),this.updateMatrix(),this.target=new rn,this.shadow=new Ef}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}};var za=class extends Je{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Dc=class extends En{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}};var Zf="\\[\\]\\.:\\/",lb=new RegExp("["+Zf+"]","g"),Jf="[^"+Zf+"]",cb="[^"+Zf.replace("\\.","")+"]",hb=/((?:WC+[\/:])*)/.source.replace("WC",Jf),ub=/(WCOD+)?/.source.replace("WCOD",cb),fb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Jf),db=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Jf),pb=new RegExp("^"+hb+ub+fb+db+"$"),mb=["material","materials","bones","map"],Tf=class{constructor(t,e,n){let s=n||Xe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Xe=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(lb,"")}static parseTrackName(t){let e=pb.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);mb.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xe.Composite=Tf;Xe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xe.prototype.GetterByBindingType=[Xe.prototype._getValue_direct,Xe.prototype._getValue_array,Xe.prototype._getValue_arrayElement,Xe.prototype._getValue_toArray];Xe.prototype.SetterByBindingTypeAndVersioning=[[Xe.prototype._setValue_direct,Xe.prototype._setValue_direct_setNeedsUpdate,Xe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_array,Xe.prototype._setValue_array_setNeedsUpdate,Xe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_arrayElement,Xe.prototype._setValue_arrayElement_setNeedsUpdate,Xe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_fromArray,Xe.prototype._setValue_fromArray_setNeedsUpdate,Xe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var _T=new Float32Array(1);var zs=class extends Ma{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var So=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=re(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(re(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var _g=new F,jl=new F,uo=new F,fo=new F,vf=new F,gb=new F,_b=new F,ka=class{constructor(t=new F,e=new F){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){_g.subVectors(t,this.start),jl.subVectors(this.end,this.start);let n=jl.dot(jl),r=jl.dot(_g)/n;return e&&(r=re(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=gb,n=_b){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,u=t.end;uo.subVectors(c,a),fo.subVectors(u,l),vf.subVectors(a,l);let h=uo.dot(uo),f=fo.dot(fo),d=fo.dot(vf);if(h<=s&&f<=s)return e.copy(a),n.copy(l),e.sub(n),e.dot(e);if(h<=s)r=0,o=d/f,o=re(o,0,1);else{let m=uo.dot(vf);if(f<=s)o=0,r=re(-m/h,0,1);else{let _=uo.dot(fo),g=h*f-_*_;g!==0?r=re((_*d-m*f)/g,0,1):r=0,o=(_*r+d)/f,o<0?(o=0,r=re(-m/h,0,1)):o>1&&(o=1,r=re((_-m)/h,0,1))}}return e.copy(a).add(uo.multiplyScalar(r)),n.copy(l).add(fo.multiplyScalar(o)),e.sub(n),e.dot(e)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var vg=new F,Ql,xf,Ha=class extends rn{constructor(t=new F(0,0,1),e=new F(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",Ql===void 0&&(Ql=new Je,Ql.setAttribute("position",new _e([0,0,0,0,1,0],3)),xf=new gr(.5,1,5,1),xf.translate(0,-.5,0)),this.position.copy(e),this.line=new pr(Ql,new Fs({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new de(xf,new Yi({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(t),this.setLength(n,r,o)}setDirection(t){if(t.y>.99999)this.quaternion.set(0,0,0,1);else if(t.y<-.99999)this.quaternion.set(1,0,0,0);else{vg.set(t.z,0,-t.x).normalize();let e=Math.acos(t.y);this.quaternion.setFromAxisAngle(vg,e)}}setLength(t,e=t*.2,n=e*.2){this.line.scale.set(1,Math.max(1e-4,t-e),1),this.line.updateMatrix(),this.cone.scale.set(n,e,n),this.cone.position.y=t,this.cone.updateMatrix()}setColor(t){this.line.material.color.set(t),this.cone.material.color.set(t)}copy(t){return super.copy(t,!1),this.line.copy(t.line),this.cone.copy(t.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var Va=class extends Wi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){if(t===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Kf(i,t,e,n){let s=vb(n);switch(e){case Bf:return i*t;case kf:return i*t/s.components*s.byteLength;case Yc:return i*t/s.components*s.byteLength;case Hf:return i*t*2/s.components*s.byteLength;case $c:return i*t*2/s.components*s.byteLength;case zf:return i*t*3/s.components*s.byteLength;case mi:return i*t*4/s.components*s.byteLength;case Zc:return i*t*4/s.components*s.byteLength;case Xa:case qa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Ya:case $a:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Kc:case Qc:return Math.max(i,16)*Math.max(t,8)/4;case Jc:case jc:return Math.max(i,8)*Math.max(t,8)/2;case th:case eh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case nh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ih:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case sh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case rh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case oh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ah:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case lh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case ch:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case hh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case uh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case fh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case dh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case ph:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case mh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case gh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case _h:case vh:case xh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case yh:case bh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Mh:case Sh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function vb(i){switch(i){case Ni:case Uf:return{byteLength:1,components:1};case wo:case Nf:case Eo:return{byteLength:2,components:1};case Xc:case qc:return{byteLength:2,components:4};case Gs:case Wc:case Ji:return{byteLength:4,components:1};case Ff:case Of:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function U0(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function yb(i){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<h.length;d++){let m=h[f],_=h[d];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++f,h[f]=_)}h.length=f+1;for(let d=0,m=h.length;d<m;d++){let _=h[d];i.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var bb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Mb=`#ifdef USE_ALPHAHASH
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
#endif`,Sb=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,wb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Eb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Tb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ab=`#ifdef USE_AOMAP
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
#endif`,Cb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Rb=`#ifdef USE_BATCHING
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
#endif`,Pb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Ib=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Lb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Db=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Ub=`#ifdef USE_IRIDESCENCE
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
#endif`,Nb=`#ifdef USE_BUMPMAP
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
#endif`,Fb=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Ob=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Bb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,zb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,kb=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Hb=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Vb=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Gb=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Wb=`#define PI 3.141592653589793
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
} // validated`,Xb=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,qb=`vec3 transformedNormal = objectNormal;
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
#endif`,Yb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,$b=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Zb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Jb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Kb="gl_FragColor = linearToOutputTexel( gl_FragColor );",jb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Qb=`#ifdef USE_ENVMAP
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
#endif`,tM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,eM=`#ifdef USE_ENVMAP
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
#endif`,nM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,iM=`#ifdef USE_ENVMAP
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
#endif`,sM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,rM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,oM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,aM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,lM=`#ifdef USE_GRADIENTMAP
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
}`,cM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,hM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,uM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,fM=`uniform bool receiveShadow;
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
#endif`,dM=`#ifdef USE_ENVMAP
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
#endif`,pM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,mM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,gM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,_M=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,vM=`PhysicalMaterial material;
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
#endif`,xM=`struct PhysicalMaterial {
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
}`,yM=`
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
#endif`,bM=`#if defined( RE_IndirectDiffuse )
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
#endif`,MM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,SM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,wM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,EM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,TM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,AM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,CM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,RM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,PM=`#if defined( USE_POINTS_UV )
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
#endif`,IM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,LM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,DM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,UM=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,NM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,FM=`#ifdef USE_MORPHTARGETS
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
#endif`,OM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,BM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,zM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,kM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,HM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,VM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,GM=`#ifdef USE_NORMALMAP
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
#endif`,WM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,XM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,YM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,$M=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ZM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,JM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,KM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,jM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,QM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,tS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,eS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,iS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,sS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,rS=`float getShadowMask() {
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
}`,oS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,aS=`#ifdef USE_SKINNING
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
#endif`,lS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cS=`#ifdef USE_SKINNING
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
#endif`,hS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,uS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,fS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,dS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,pS=`#ifdef USE_TRANSMISSION
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
#endif`,mS=`#ifdef USE_TRANSMISSION
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
#endif`,gS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,_S=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,vS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,xS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,yS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,bS=`uniform sampler2D t2D;
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
}`,MS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,SS=`#ifdef ENVMAP_TYPE_CUBE
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
}`,wS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ES=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,TS=`#include <common>
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
}`,AS=`#if DEPTH_PACKING == 3200
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
}`,CS=`#define DISTANCE
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
}`,RS=`#define DISTANCE
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
}`,PS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,IS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LS=`uniform float scale;
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
}`,DS=`uniform vec3 diffuse;
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
}`,US=`#include <common>
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
}`,NS=`uniform vec3 diffuse;
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
}`,FS=`#define LAMBERT
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
}`,OS=`#define LAMBERT
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
}`,BS=`#define MATCAP
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
}`,zS=`#define MATCAP
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
}`,kS=`#define NORMAL
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
}`,HS=`#define NORMAL
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
}`,VS=`#define PHONG
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
}`,GS=`#define PHONG
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
}`,WS=`#define STANDARD
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
}`,XS=`#define STANDARD
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
}`,qS=`#define TOON
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
}`,YS=`#define TOON
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
}`,$S=`uniform float size;
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
}`,ZS=`uniform vec3 diffuse;
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
}`,JS=`#include <common>
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
}`,KS=`uniform vec3 color;
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
}`,jS=`uniform float rotation;
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
}`,QS=`uniform vec3 diffuse;
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
}`,fe={alphahash_fragment:bb,alphahash_pars_fragment:Mb,alphamap_fragment:Sb,alphamap_pars_fragment:wb,alphatest_fragment:Eb,alphatest_pars_fragment:Tb,aomap_fragment:Ab,aomap_pars_fragment:Cb,batching_pars_vertex:Rb,batching_vertex:Pb,begin_vertex:Ib,beginnormal_vertex:Lb,bsdfs:Db,iridescence_fragment:Ub,bumpmap_pars_fragment:Nb,clipping_planes_fragment:Fb,clipping_planes_pars_fragment:Ob,clipping_planes_pars_vertex:Bb,clipping_planes_vertex:zb,color_fragment:kb,color_pars_fragment:Hb,color_pars_vertex:Vb,color_vertex:Gb,common:Wb,cube_uv_reflection_fragment:Xb,defaultnormal_vertex:qb,displacementmap_pars_vertex:Yb,displacementmap_vertex:$b,emissivemap_fragment:Zb,emissivemap_pars_fragment:Jb,colorspace_fragment:Kb,colorspace_pars_fragment:jb,envmap_fragment:Qb,envmap_common_pars_fragment:tM,envmap_pars_fragment:eM,envmap_pars_vertex:nM,envmap_physical_pars_fragment:dM,envmap_vertex:iM,fog_vertex:sM,fog_pars_vertex:rM,fog_fragment:oM,fog_pars_fragment:aM,gradientmap_pars_fragment:lM,lightmap_pars_fragment:cM,lights_lambert_fragment:hM,lights_lambert_pars_fragment:uM,lights_pars_begin:fM,lights_toon_fragment:pM,lights_toon_pars_fragment:mM,lights_phong_fragment:gM,lights_phong_pars_fragment:_M,lights_physical_fragment:vM,lights_physical_pars_fragment:xM,lights_fragment_begin:yM,lights_fragment_maps:bM,lights_fragment_end:MM,logdepthbuf_fragment:SM,logdepthbuf_pars_fragment:wM,logdepthbuf_pars_vertex:EM,logdepthbuf_vertex:TM,map_fragment:AM,map_pars_fragment:CM,map_particle_fragment:RM,map_particle_pars_fragment:PM,metalnessmap_fragment:IM,metalnessmap_pars_fragment:LM,morphinstance_vertex:DM,morphcolor_vertex:UM,morphnormal_vertex:NM,morphtarget_pars_vertex:FM,morphtarget_vertex:OM,normal_fragment_begin:BM,normal_fragment_maps:zM,normal_pars_fragment:kM,normal_pars_vertex:HM,normal_vertex:VM,normalmap_pars_fragment:GM,clearcoat_normal_fragment_begin:WM,clearcoat_normal_fragment_maps:XM,clearcoat_pars_fragment:qM,iridescence_pars_fragment:YM,opaque_fragment:$M,packing:ZM,premultiplied_alpha_fragment:JM,project_vertex:KM,dithering_fragment:jM,dithering_pars_fragment:QM,roughnessmap_fragment:tS,roughnessmap_pars_fragment:eS,shadowmap_pars_fragment:nS,shadowmap_pars_vertex:iS,shadowmap_vertex:sS,shadowmask_pars_fragment:rS,skinbase_vertex:oS,skinning_pars_vertex:aS,skinning_vertex:lS,skinnormal_vertex:cS,specularmap_fragment:hS,specularmap_pars_fragment:uS,tonemapping_fragment:fS,tonemapping_pars_fragment:dS,transmission_fragment:pS,transmission_pars_fragment:mS,uv_pars_fragment:gS,uv_pars_vertex:_S,uv_vertex:vS,worldpos_vertex:xS,background_vert:yS,background_frag:bS,backgroundCube_vert:MS,backgroundCube_frag:SS,cube_vert:wS,cube_frag:ES,depth_vert:TS,depth_frag:AS,distanceRGBA_vert:CS,distanceRGBA_frag:RS,equirect_vert:PS,equirect_frag:IS,linedashed_vert:LS,linedashed_frag:DS,meshbasic_vert:US,meshbasic_frag:NS,meshlambert_vert:FS,meshlambert_frag:OS,meshmatcap_vert:BS,meshmatcap_frag:zS,meshnormal_vert:kS,meshnormal_frag:HS,meshphong_vert:VS,meshphong_frag:GS,meshphysical_vert:WS,meshphysical_frag:XS,meshtoon_vert:qS,meshtoon_frag:YS,points_vert:$S,points_frag:ZS,shadow_vert:JS,shadow_frag:KS,sprite_vert:jS,sprite_frag:QS},Rt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ce}},envmap:{envMap:{value:null},envMapRotation:{value:new ce},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ce}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ce}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ce},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ce},normalScale:{value:new Ft(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ce},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ce}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ce}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ce}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0},uvTransform:{value:new ce}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new Ft(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}}},kn={basic:{uniforms:An([Rt.common,Rt.specularmap,Rt.envmap,Rt.aomap,Rt.lightmap,Rt.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:An([Rt.common,Rt.specularmap,Rt.envmap,Rt.aomap,Rt.lightmap,Rt.emissivemap,Rt.bumpmap,Rt.normalmap,Rt.displacementmap,Rt.fog,Rt.lights,{emissive:{value:new he(0)}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:An([Rt.common,Rt.specularmap,Rt.envmap,Rt.aomap,Rt.lightmap,Rt.emissivemap,Rt.bumpmap,Rt.normalmap,Rt.displacementmap,Rt.fog,Rt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:An([Rt.common,Rt.envmap,Rt.aomap,Rt.lightmap,Rt.emissivemap,Rt.bumpmap,Rt.normalmap,Rt.displacementmap,Rt.roughnessmap,Rt.metalnessmap,Rt.fog,Rt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:An([Rt.common,Rt.aomap,Rt.lightmap,Rt.emissivemap,Rt.bumpmap,Rt.normalmap,Rt.displacementmap,Rt.gradientmap,Rt.fog,Rt.lights,{emissive:{value:new he(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:An([Rt.common,Rt.bumpmap,Rt.normalmap,Rt.displacementmap,Rt.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:An([Rt.points,Rt.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:An([Rt.common,Rt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:An([Rt.common,Rt.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:An([Rt.common,Rt.bumpmap,Rt.normalmap,Rt.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:An([Rt.sprite,Rt.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new ce},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ce}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distanceRGBA:{uniforms:An([Rt.common,Rt.displacementmap,{referencePosition:{value:new F},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distanceRGBA_vert,fragmentShader:fe.distanceRGBA_frag},shadow:{uniforms:An([Rt.lights,Rt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};kn.physical={uniforms:An([kn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ce},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ce},clearcoatNormalScale:{value:new Ft(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ce},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ce},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ce},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ce},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ce},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ce},transmissionSamplerSize:{value:new Ft},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ce},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ce},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ce},anisotropyVector:{value:new Ft},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ce}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var wh={r:0,b:0,g:0},Mr=new Ui,tw=new De;function ew(i,t,e,n,s,r,o){let a=new he(0),l=r===!0?0:1,c,u,h=null,f=0,d=null;function m(S){let x=S.isScene===!0?S.background:null;return x&&x.isTexture&&(x=(S.backgroundBlurriness>0?e:t).get(x)),x}function _(S){let x=!1,I=m(S);I===null?p(a,l):I&&I.isColor&&(p(I,1),x=!0);let T=i.xr.getEnvironmentBlendMode();T==="additive"?n.buffers.color.setClear(0,0,0,1,o):T==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||x)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function g(S,x){let I=m(x);I&&(I.isCubeTexture||I.mapping===Ga)?(u===void 0&&(u=new de(new $i(1,1,1),new ni({name:"BackgroundCubeMaterial",uniforms:br(kn.backgroundCube.uniforms),vertexShader:kn.backgroundCube.vertexShader,fragmentShader:kn.backgroundCube.fragmentShader,side:Bn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(T,P,L){this.matrixWorld.copyPosition(L.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),Mr.copy(x.backgroundRotation),Mr.x*=-1,Mr.y*=-1,Mr.z*=-1,I.isCubeTexture&&I.isRenderTargetTexture===!1&&(Mr.y*=-1,Mr.z*=-1),u.material.uniforms.envMap.value=I,u.material.uniforms.flipEnvMap.value=I.isCubeTexture&&I.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=x.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(tw.makeRotationFromEuler(Mr)),u.material.toneMapped=ve.getTransfer(I.colorSpace)!==Re,(h!==I||f!==I.version||d!==i.toneMapping)&&(u.material.needsUpdate=!0,h=I,f=I.version,d=i.toneMapping),u.layers.enableAll(),S.unshift(u,u.geometry,u.material,0,0,null)):I&&I.isTexture&&(c===void 0&&(c=new de(new Pa(2,2),new ni({name:"BackgroundMaterial",uniforms:br(kn.background.uniforms),vertexShader:kn.background.vertexShader,fragmentShader:kn.background.fragmentShader,side:ps,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=I,c.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,c.material.toneMapped=ve.getTransfer(I.colorSpace)!==Re,I.matrixAutoUpdate===!0&&I.updateMatrix(),c.material.uniforms.uvTransform.value.copy(I.matrix),(h!==I||f!==I.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=I,f=I.version,d=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function p(S,x){S.getRGB(wh,Yf(i)),n.buffers.color.setClear(wh.r,wh.g,wh.b,x,o)}function A(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,x=1){a.set(S),l=x,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(S){l=S,p(a,l)},render:_,addToRenderList:g,dispose:A}}function nw(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(b,E,O,B,H){let W=!1,Z=h(B,O,E);r!==Z&&(r=Z,c(r.object)),W=d(b,B,O,H),W&&m(b,B,O,H),H!==null&&t.update(H,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,x(b,E,O,B),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function l(){return i.createVertexArray()}function c(b){return i.bindVertexArray(b)}function u(b){return i.deleteVertexArray(b)}function h(b,E,O){let B=O.wireframe===!0,H=n[b.id];H===void 0&&(H={},n[b.id]=H);let W=H[E.id];W===void 0&&(W={},H[E.id]=W);let Z=W[B];return Z===void 0&&(Z=f(l()),W[B]=Z),Z}function f(b){let E=[],O=[],B=[];for(let H=0;H<e;H++)E[H]=0,O[H]=0,B[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:E,enabledAttributes:O,attributeDivisors:B,object:b,attributes:{},index:null}}function d(b,E,O,B){let H=r.attributes,W=E.attributes,Z=0,k=O.getAttributes();for(let G in k)if(k[G].location>=0){let ot=H[G],rt=W[G];if(rt===void 0&&(G==="instanceMatrix"&&b.instanceMatrix&&(rt=b.instanceMatrix),G==="instanceColor"&&b.instanceColor&&(rt=b.instanceColor)),ot===void 0||ot.attribute!==rt||rt&&ot.data!==rt.data)return!0;Z++}return r.attributesNum!==Z||r.index!==B}function m(b,E,O,B){let H={},W=E.attributes,Z=0,k=O.getAttributes();for(let G in k)if(k[G].location>=0){let ot=W[G];ot===void 0&&(G==="instanceMatrix"&&b.instanceMatrix&&(ot=b.instanceMatrix),G==="instanceColor"&&b.instanceColor&&(ot=b.instanceColor));let rt={};rt.attribute=ot,ot&&ot.data&&(rt.data=ot.data),H[G]=rt,Z++}r.attributes=H,r.attributesNum=Z,r.index=B}function _(){let b=r.newAttributes;for(let E=0,O=b.length;E<O;E++)b[E]=0}function g(b){p(b,0)}function p(b,E){let O=r.newAttributes,B=r.enabledAttributes,H=r.attributeDivisors;O[b]=1,B[b]===0&&(i.enableVertexAttribArray(b),B[b]=1),H[b]!==E&&(i.vertexAttribDivisor(b,E),H[b]=E)}function A(){let b=r.newAttributes,E=r.enabledAttributes;for(let O=0,B=E.length;O<B;O++)E[O]!==b[O]&&(i.disableVertexAttribArray(O),E[O]=0)}function S(b,E,O,B,H,W,Z){Z===!0?i.vertexAttribIPointer(b,E,O,H,W):i.vertexAttribPointer(b,E,O,B,H,W)}function x(b,E,O,B){_();let H=B.attributes,W=O.getAttributes(),Z=E.defaultAttributeValues;for(let k in W){let G=W[k];if(G.location>=0){let tt=H[k];if(tt===void 0&&(k==="instanceMatrix"&&b.instanceMatrix&&(tt=b.instanceMatrix),k==="instanceColor"&&b.instanceColor&&(tt=b.instanceColor)),tt!==void 0){let ot=tt.normalized,rt=tt.itemSize,ut=t.get(tt);if(ut===void 0)continue;let lt=ut.buffer,Pt=ut.type,Lt=ut.bytesPerElement,K=Pt===i.INT||Pt===i.UNSIGNED_INT||tt.gpuType===Wc;if(tt.isInterleavedBufferAttribute){let V=tt.data,pt=V.stride,Et=tt.offset;if(V.isInstancedInterleavedBuffer){for(let bt=0;bt<G.locationSize;bt++)p(G.location+bt,V.meshPerAttribute);b.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=V.meshPerAttribute*V.count)}else for(let bt=0;bt<G.locationSize;bt++)g(G.location+bt);i.bindBuffer(i.ARRAY_BUFFER,lt);for(let bt=0;bt<G.locationSize;bt++)S(G.location+bt,rt/G.locationSize,Pt,ot,pt*Lt,(Et+rt/G.locationSize*bt)*Lt,K)}else{if(tt.isInstancedBufferAttribute){for(let V=0;V<G.locationSize;V++)p(G.location+V,tt.meshPerAttribute);b.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=tt.meshPerAttribute*tt.count)}else for(let V=0;V<G.locationSize;V++)g(G.location+V);i.bindBuffer(i.ARRAY_BUFFER,lt);for(let V=0;V<G.locationSize;V++)S(G.location+V,rt/G.locationSize,Pt,ot,rt*Lt,rt/G.locationSize*V*Lt,K)}}else if(Z!==void 0){let ot=Z[k];if(ot!==void 0)switch(ot.length){case 2:i.vertexAttrib2fv(G.location,ot);break;case 3:i.vertexAttrib3fv(G.location,ot);break;case 4:i.vertexAttrib4fv(G.location,ot);break;default:i.vertexAttrib1fv(G.location,ot)}}}}A()}function I(){L();for(let b in n){let E=n[b];for(let O in E){let B=E[O];for(let H in B)u(B[H].object),delete B[H];delete E[O]}delete n[b]}}function T(b){if(n[b.id]===void 0)return;let E=n[b.id];for(let O in E){let B=E[O];for(let H in B)u(B[H].object),delete B[H];delete E[O]}delete n[b.id]}function P(b){for(let E in n){let O=n[E];if(O[b.id]===void 0)continue;let B=O[b.id];for(let H in B)u(B[H].object),delete B[H];delete O[b.id]}}function L(){M(),o=!0,r!==s&&(r=s,c(r.object))}function M(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:M,dispose:I,releaseStatesOfGeometry:T,releaseStatesOfProgram:P,initAttributes:_,enableAttribute:g,disableUnusedAttributes:A}}function iw(i,t,e){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),e.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),e.update(u,n,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let d=0;for(let m=0;m<h;m++)d+=u[m];e.update(d,n,1)}function l(c,u,h,f){if(h===0)return;let d=t.get("WEBGL_multi_draw");if(d===null)for(let m=0;m<c.length;m++)o(c[m],u[m],f[m]);else{d.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let m=0;for(let _=0;_<h;_++)m+=u[_]*f[_];e.update(m,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function sw(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let P=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(P.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(P){return!(P!==mi&&n.convert(P)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(P){let L=P===Eo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(P!==Ni&&n.convert(P)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&P!==Ji&&!L)}function l(P){if(P==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";P="mediump"}return P==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.logarithmicDepthBuffer===!0,f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),A=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),I=m>0,T=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:A,maxVaryings:S,maxFragmentUniforms:x,vertexTextures:I,maxSamples:T}}function rw(i){let t=this,e=null,n=0,s=!1,r=!1,o=new di,a=new ce,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||s;return s=f,n=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){let m=h.clippingPlanes,_=h.clipIntersection,g=h.clipShadows,p=i.get(h);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let A=r?0:n,S=A*4,x=p.clippingState||null;l.value=x,x=u(m,f,S,d);for(let I=0;I!==S;++I)x[I]=e[I];p.clippingState=x,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=A}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,d,m){let _=h!==null?h.length:0,g=null;if(_!==0){if(g=l.value,m!==!0||g===null){let p=d+_*4,A=f.matrixWorldInverse;a.getNormalMatrix(A),(g===null||g.length<p)&&(g=new Float32Array(p));for(let S=0,x=d;S!==_;++S,x+=4)o.copy(h[S]).applyMatrix4(A,a),o.normal.toArray(g,x),g[x+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,g}}function ow(i){let t=new WeakMap;function e(o,a){return a===Hc?o.mapping=xr:a===Vc&&(o.mapping=yr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Hc||a===Vc)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new uc(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}var Ro=4,u0=[.125,.215,.35,.446,.526,.582],Er=20,jf=new vr,f0=new he,Qf=null,td=0,ed=0,nd=!1,wr=(1+Math.sqrt(5))/2,Co=1/wr,d0=[new F(-wr,Co,0),new F(wr,Co,0),new F(-Co,0,wr),new F(Co,0,wr),new F(0,wr,-Co),new F(0,wr,Co),new F(-1,1,-1),new F(1,1,-1),new F(-1,1,1),new F(1,1,1)],aw=new F,Ah=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=aw}=r;Qf=this._renderer.getRenderTarget(),td=this._renderer.getActiveCubeFace(),ed=this._renderer.getActiveMipmapLevel(),nd=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,n,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=g0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=m0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Qf,td,ed),this._renderer.xr.enabled=nd,t.scissorTest=!1,Eh(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===xr||t.mapping===yr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Qf=this._renderer.getRenderTarget(),td=this._renderer.getActiveCubeFace(),ed=this._renderer.getActiveMipmapLevel(),nd=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:Li,minFilter:Li,generateMipmaps:!1,type:Eo,format:mi,colorSpace:fr,depthBuffer:!1},s=p0(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=p0(t,e,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=lw(r)),this._blurMaterial=cw(r,t,e)}return s}_compileMaterial(t){let e=new de(this._lodPlanes[0],t);this._renderer.compile(e,jf)}_sceneToCubeUV(t,e,n,s,r){let l=new En(90,1,e,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,d=h.toneMapping;h.getClearColor(f0),h.toneMapping=_s,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let _=new Yi({name:"PMREM.Background",side:Bn,depthWrite:!1,depthTest:!1}),g=new de(new $i,_),p=!1,A=t.background;A?A.isColor&&(_.color.copy(A),t.background=null,p=!0):(_.color.copy(f0),p=!0);for(let S=0;S<6;S++){let x=S%3;x===0?(l.up.set(0,c[S],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[S],r.y,r.z)):x===1?(l.up.set(0,0,c[S]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[S],r.z)):(l.up.set(0,c[S],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[S]));let I=this._cubeSize;Eh(s,x*I,S>2?I:0,I,I),h.setRenderTarget(s),p&&h.render(g,l),h.render(t,l)}g.geometry.dispose(),g.material.dispose(),h.toneMapping=d,h.autoClear=f,t.background=A}_textureToCubeUV(t,e){let n=this._renderer,s=t.mapping===xr||t.mapping===yr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=g0()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=m0());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new de(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;Eh(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,jf)}_applyPMREM(t){let e=this._renderer,n=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=d0[(s-r-1)%d0.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new de(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[n]-1,m=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*Er-1),_=r/m,g=isFinite(r)?1+Math.floor(u*_):Er;g>Er&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${Er}`);let p=[],A=0;for(let P=0;P<Er;++P){let L=P/_,M=Math.exp(-L*L/2);p.push(M),P===0?A+=M:P<g&&(A+=2*M)}for(let P=0;P<p.length;P++)p[P]=p[P]/A;f.envMap.value=t.texture,f.samples.value=g,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:S}=this;f.dTheta.value=m,f.mipInt.value=S-n;let x=this._sizeLods[s],I=3*x*(s>S-Ro?s-S+Ro:0),T=4*(this._cubeSize-x);Eh(e,I,T,3*x,2*x),l.setRenderTarget(e),l.render(h,jf)}};function lw(i){let t=[],e=[],n=[],s=i,r=i-Ro+1+u0.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>i-Ro?l=u0[o-i+Ro-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,m=6,_=3,g=2,p=1,A=new Float32Array(_*m*d),S=new Float32Array(g*m*d),x=new Float32Array(p*m*d);for(let T=0;T<d;T++){let P=T%3*2/3-1,L=T>2?0:-1,M=[P,L,0,P+2/3,L,0,P+2/3,L+1,0,P,L,0,P+2/3,L+1,0,P,L+1,0];A.set(M,_*m*T),S.set(f,g*m*T);let b=[T,T,T,T,T,T];x.set(b,p*m*T)}let I=new Je;I.setAttribute("position",new vn(A,_)),I.setAttribute("uv",new vn(S,g)),I.setAttribute("faceIndex",new vn(x,p)),t.push(I),s>Ro&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function p0(i,t,e){let n=new Xi(i,t,e);return n.texture.mapping=Ga,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Eh(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function cw(i,t,e){let n=new Float32Array(Er),s=new F(0,1,0);return new ni({name:"SphericalGaussianBlur",defines:{n:Er,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:fd(),fragmentShader:`

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
		`,blending:gs,depthTest:!1,depthWrite:!1})}function m0(){return new ni({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:fd(),fragmentShader:`

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
		`,blending:gs,depthTest:!1,depthWrite:!1})}function g0(){return new ni({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:fd(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:gs,depthTest:!1,depthWrite:!1})}function fd(){return`

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
	`}function hw(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Hc||l===Vc,u=l===xr||l===yr;if(c||u){let h=t.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new Ah(i)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{let d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(e===null&&(e=new Ah(i)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function uw(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&_o("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function fw(i,t,e,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&t.remove(f.index);for(let m in f.attributes)t.remove(f.attributes[m]);f.removeEventListener("dispose",o),delete s[f.id];let d=r.get(f);d&&(t.remove(d),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){let f=h.attributes;for(let d in f)t.update(f[d],i.ARRAY_BUFFER)}function c(h){let f=[],d=h.index,m=h.attributes.position,_=0;if(d!==null){let A=d.array;_=d.version;for(let S=0,x=A.length;S<x;S+=3){let I=A[S+0],T=A[S+1],P=A[S+2];f.push(I,T,T,P,P,I)}}else if(m!==void 0){let A=m.array;_=m.version;for(let S=0,x=A.length/3-1;S<x;S+=3){let I=S+0,T=S+1,P=S+2;f.push(I,T,T,P,P,I)}}else return;let g=new(qf(f)?xa:va)(f,1);g.version=_;let p=r.get(h);p&&t.remove(p),r.set(h,g)}function u(h){let f=r.get(h);if(f){let d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function dw(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){i.drawElements(n,d,r,f*o),e.update(d,n,1)}function c(f,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,f*o,m),e.update(d,n,m))}function u(f,d,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,m);let g=0;for(let p=0;p<m;p++)g+=d[p];e.update(g,n,1)}function h(f,d,m,_){if(m===0)return;let g=t.get("WEBGL_multi_draw");if(g===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],_[p]);else{g.multiDrawElementsInstancedWEBGL(n,d,0,r,f,0,_,0,m);let p=0;for(let A=0;A<m;A++)p+=d[A]*_[A];e.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function pw(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function mw(i,t,e){let n=new WeakMap,s=new Pe;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let M=function(){P.dispose(),n.delete(a),a.removeEventListener("dispose",M)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],A=a.morphAttributes.color||[],S=0;d===!0&&(S=1),m===!0&&(S=2),_===!0&&(S=3);let x=a.attributes.position.count*S,I=1;x>t.maxTextureSize&&(I=Math.ceil(x/t.maxTextureSize),x=t.maxTextureSize);let T=new Float32Array(x*I*4*h),P=new ga(T,x,I,h);P.type=Ji,P.needsUpdate=!0;let L=S*4;for(let b=0;b<h;b++){let E=g[b],O=p[b],B=A[b],H=x*I*4*b;for(let W=0;W<E.count;W++){let Z=W*L;d===!0&&(s.fromBufferAttribute(E,W),T[H+Z+0]=s.x,T[H+Z+1]=s.y,T[H+Z+2]=s.z,T[H+Z+3]=0),m===!0&&(s.fromBufferAttribute(O,W),T[H+Z+4]=s.x,T[H+Z+5]=s.y,T[H+Z+6]=s.z,T[H+Z+7]=0),_===!0&&(s.fromBufferAttribute(B,W),T[H+Z+8]=s.x,T[H+Z+9]=s.y,T[H+Z+10]=s.z,T[H+Z+11]=B.itemSize===4?s.w:1)}}f={count:h,texture:P,size:new Ft(x,I)},n.set(a,f),a.addEventListener("dispose",M)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let _=0;_<c.length;_++)d+=c[_];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function gw(i,t,e,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var N0=new Wn,_0=new Ta(1,1),F0=new ga,O0=new cc,B0=new ba,v0=[],x0=[],y0=new Float32Array(16),b0=new Float32Array(9),M0=new Float32Array(4);function Io(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=v0[s];if(r===void 0&&(r=new Float32Array(s),v0[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function on(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function an(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Rh(i,t){let e=x0[t];e===void 0&&(e=new Int32Array(t),x0[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function _w(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function vw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(on(e,t))return;i.uniform2fv(this.addr,t),an(e,t)}}function xw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(on(e,t))return;i.uniform3fv(this.addr,t),an(e,t)}}function yw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(on(e,t))return;i.uniform4fv(this.addr,t),an(e,t)}}function bw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(on(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),an(e,t)}else{if(on(e,n))return;M0.set(n),i.uniformMatrix2fv(this.addr,!1,M0),an(e,n)}}function Mw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(on(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),an(e,t)}else{if(on(e,n))return;b0.set(n),i.uniformMatrix3fv(this.addr,!1,b0),an(e,n)}}function Sw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(on(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),an(e,t)}else{if(on(e,n))return;y0.set(n),i.uniformMatrix4fv(this.addr,!1,y0),an(e,n)}}function ww(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Ew(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(on(e,t))return;i.uniform2iv(this.addr,t),an(e,t)}}function Tw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(on(e,t))return;i.uniform3iv(this.addr,t),an(e,t)}}function Aw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(on(e,t))return;i.uniform4iv(this.addr,t),an(e,t)}}function Cw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function Rw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(on(e,t))return;i.uniform2uiv(this.addr,t),an(e,t)}}function Pw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(on(e,t))return;i.uniform3uiv(this.addr,t),an(e,t)}}function Iw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(on(e,t))return;i.uniform4uiv(this.addr,t),an(e,t)}}function Lw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(_0.compareFunction=Gf,r=_0):r=N0,e.setTexture2D(t||r,s)}function Dw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||O0,s)}function Uw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||B0,s)}function Nw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||F0,s)}function Fw(i){switch(i){case 5126:return _w;case 35664:return vw;case 35665:return xw;case 35666:return yw;case 35674:return bw;case 35675:return Mw;case 35676:return Sw;case 5124:case 35670:return ww;case 35667:case 35671:return Ew;case 35668:case 35672:return Tw;case 35669:case 35673:return Aw;case 5125:return Cw;case 36294:return Rw;case 36295:return Pw;case 36296:return Iw;case 35678:case 36198:case 36298:case 36306:case 35682:return Lw;case 35679:case 36299:case 36307:return Dw;case 35680:case 36300:case 36308:case 36293:return Uw;case 36289:case 36303:case 36311:case 36292:return Nw}}function Ow(i,t){i.uniform1fv(this.addr,t)}function Bw(i,t){let e=Io(t,this.size,2);i.uniform2fv(this.addr,e)}function zw(i,t){let e=Io(t,this.size,3);i.uniform3fv(this.addr,e)}function kw(i,t){let e=Io(t,this.size,4);i.uniform4fv(this.addr,e)}function Hw(i,t){let e=Io(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Vw(i,t){let e=Io(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Gw(i,t){let e=Io(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Ww(i,t){i.uniform1iv(this.addr,t)}function Xw(i,t){i.uniform2iv(this.addr,t)}function qw(i,t){i.uniform3iv(this.addr,t)}function Yw(i,t){i.uniform4iv(this.addr,t)}function $w(i,t){i.uniform1uiv(this.addr,t)}function Zw(i,t){i.uniform2uiv(this.addr,t)}function Jw(i,t){i.uniform3uiv(this.addr,t)}function Kw(i,t){i.uniform4uiv(this.addr,t)}function jw(i,t,e){let n=this.cache,s=t.length,r=Rh(e,s);on(n,r)||(i.uniform1iv(this.addr,r),an(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||N0,r[o])}function Qw(i,t,e){let n=this.cache,s=t.length,r=Rh(e,s);on(n,r)||(i.uniform1iv(this.addr,r),an(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||O0,r[o])}function t1(i,t,e){let n=this.cache,s=t.length,r=Rh(e,s);on(n,r)||(i.uniform1iv(this.addr,r),an(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||B0,r[o])}function e1(i,t,e){let n=this.cache,s=t.length,r=Rh(e,s);on(n,r)||(i.uniform1iv(this.addr,r),an(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||F0,r[o])}function n1(i){switch(i){case 5126:return Ow;case 35664:return Bw;case 35665:return zw;case 35666:return kw;case 35674:return Hw;case 35675:return Vw;case 35676:return Gw;case 5124:case 35670:return Ww;case 35667:case 35671:return Xw;case 35668:case 35672:return qw;case 35669:case 35673:return Yw;case 5125:return $w;case 36294:return Zw;case 36295:return Jw;case 36296:return Kw;case 35678:case 36198:case 36298:case 36306:case 35682:return jw;case 35679:case 36299:case 36307:return Qw;case 35680:case 36300:case 36308:case 36293:return t1;case 36289:case 36303:case 36311:case 36292:return e1}}var sd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Fw(e.type)}},rd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=n1(e.type)}},od=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},id=/(\w+)(\])?(\[|\.)?/g;function S0(i,t){i.seq.push(t),i.map[t.id]=t}function i1(i,t,e){let n=i.name,s=n.length;for(id.lastIndex=0;;){let r=id.exec(n),o=id.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){S0(e,c===void 0?new sd(a,i,t):new rd(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new od(a),S0(e,h)),e=h}}}var Po=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);i1(r,o,this)}}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function w0(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var s1=37297,r1=0;function o1(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var E0=new ce;function a1(i){ve._getMatrix(E0,ve.workingColorSpace,i);let t=`mat3( ${E0.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(i)){case da:return[t,"LinearTransferOETF"];case Re:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function T0(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+o1(i.getShaderSource(t),a)}else return r}function l1(i,t){let e=a1(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function c1(i,t){let e;switch(t){case Vg:e="Linear";break;case Gg:e="Reinhard";break;case Wg:e="Cineon";break;case Xg:e="ACESFilmic";break;case Yg:e="AgX";break;case $g:e="Neutral";break;case qg:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Th=new F;function h1(){ve.getLuminanceCoefficients(Th);let i=Th.x.toFixed(4),t=Th.y.toFixed(4),e=Th.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function u1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ja).join(`
`)}function f1(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function d1(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Ja(i){return i!==""}function A0(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function C0(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var p1=/^[ \t]*#include +<([\w\d./]+)>/gm;function ad(i){return i.replace(p1,g1)}var m1=new Map;function g1(i,t){let e=fe[t];if(e===void 0){let n=m1.get(t);if(n!==void 0)e=fe[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return ad(e)}var _1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function R0(i){return i.replace(_1,v1)}function v1(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function P0(i){let t=`precision ${i.precision} float;
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
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function x1(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Cf?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===bg?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Zi&&(t="SHADOWMAP_TYPE_VSM"),t}function y1(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case xr:case yr:t="ENVMAP_TYPE_CUBE";break;case Ga:t="ENVMAP_TYPE_CUBE_UV";break}return t}function b1(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case yr:t="ENVMAP_MODE_REFRACTION";break}return t}function M1(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Lf:t="ENVMAP_BLENDING_MULTIPLY";break;case kg:t="ENVMAP_BLENDING_MIX";break;case Hg:t="ENVMAP_BLENDING_ADD";break}return t}function S1(i){let t=i.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function w1(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=x1(e),c=y1(e),u=b1(e),h=M1(e),f=S1(e),d=u1(e),m=f1(r),_=s.createProgram(),g,p,A=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Ja).join(`
`),g.length>0&&(g+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter(Ja).join(`
`),p.length>0&&(p+=`
`)):(g=[P0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ja).join(`
`),p=[P0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==_s?"#define TONE_MAPPING":"",e.toneMapping!==_s?fe.tonemapping_pars_fragment:"",e.toneMapping!==_s?c1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,l1("linearToOutputTexel",e.outputColorSpace),h1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ja).join(`
`)),o=ad(o),o=A0(o,e),o=C0(o,e),a=ad(a),a=A0(a,e),a=C0(a,e),o=R0(o),a=R0(a),e.isRawShaderMaterial!==!0&&(A=`#version 300 es
`,g=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,p=["#define varying in",e.glslVersion===Wf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Wf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let S=A+g+o,x=A+p+a,I=w0(s,s.VERTEX_SHADER,S),T=w0(s,s.FRAGMENT_SHADER,x);s.attachShader(_,I),s.attachShader(_,T),e.index0AttributeName!==void 0?s.bindAttribLocation(_,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function P(E){if(i.debug.checkShaderErrors){let O=s.getProgramInfoLog(_)||"",B=s.getShaderInfoLog(I)||"",H=s.getShaderInfoLog(T)||"",W=O.trim(),Z=B.trim(),k=H.trim(),G=!0,tt=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(G=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,_,I,T);else{let ot=T0(s,I,"vertex"),rt=T0(s,T,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+E.name+`
Material Type: `+E.type+`

Program Info Log: `+W+`
`+ot+`
`+rt)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(Z===""||k==="")&&(tt=!1);tt&&(E.diagnostics={runnable:G,programLog:W,vertexShader:{log:Z,prefix:g},fragmentShader:{log:k,prefix:p}})}s.deleteShader(I),s.deleteShader(T),L=new Po(s,_),M=d1(s,_)}let L;this.getUniforms=function(){return L===void 0&&P(this),L};let M;this.getAttributes=function(){return M===void 0&&P(this),M};let b=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(_,s1)),b},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=r1++,this.cacheKey=t,this.usedTimes=1,this.program=_,this.vertexShader=I,this.fragmentShader=T,this}var E1=0,ld=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new cd(t),e.set(t,n)),n}},cd=class{constructor(t){this.id=E1++,this.code=t,this.usedTimes=0}};function T1(i,t,e,n,s,r,o){let a=new _a,l=new ld,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,d=s.precision,m={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function _(M){return c.add(M),M===0?"uv":`uv${M}`}function g(M,b,E,O,B){let H=O.fog,W=B.geometry,Z=M.isMeshStandardMaterial?O.environment:null,k=(M.isMeshStandardMaterial?e:t).get(M.envMap||Z),G=k&&k.mapping===Ga?k.image.height:null,tt=m[M.type];M.precision!==null&&(d=s.getMaxPrecision(M.precision),d!==M.precision&&console.warn("THREE.WebGLProgram.getParameters:",M.precision,"not supported, using",d,"instead."));let ot=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,rt=ot!==void 0?ot.length:0,ut=0;W.morphAttributes.position!==void 0&&(ut=1),W.morphAttributes.normal!==void 0&&(ut=2),W.morphAttributes.color!==void 0&&(ut=3);let lt,Pt,Lt,K;if(tt){let xe=kn[tt];lt=xe.vertexShader,Pt=xe.fragmentShader}else lt=M.vertexShader,Pt=M.fragmentShader,l.update(M),Lt=l.getVertexShaderID(M),K=l.getFragmentShaderID(M);let V=i.getRenderTarget(),pt=i.state.buffers.depth.getReversed(),Et=B.isInstancedMesh===!0,bt=B.isBatchedMesh===!0,ft=!!M.map,Jt=!!M.matcap,C=!!k,Ct=!!M.aoMap,it=!!M.lightMap,j=!!M.bumpMap,ct=!!M.normalMap,Nt=!!M.displacementMap,_t=!!M.emissiveMap,Dt=!!M.metalnessMap,Zt=!!M.roughnessMap,ee=M.anisotropy>0,U=M.clearcoat>0,y=M.dispersion>0,z=M.iridescence>0,et=M.sheen>0,ht=M.transmission>0,at=ee&&!!M.anisotropyMap,Ht=U&&!!M.clearcoatMap,xt=U&&!!M.clearcoatNormalMap,Vt=U&&!!M.clearcoatRoughnessMap,Ot=z&&!!M.iridescenceMap,mt=z&&!!M.iridescenceThicknessMap,At=et&&!!M.sheenColorMap,$t=et&&!!M.sheenRoughnessMap,Yt=!!M.specularMap,It=!!M.specularColorMap,se=!!M.specularIntensityMap,X=ht&&!!M.transmissionMap,Mt=ht&&!!M.thicknessMap,wt=!!M.gradientMap,Gt=!!M.alphaMap,yt=M.alphaTest>0,gt=!!M.alphaHash,qt=!!M.extensions,oe=_s;M.toneMapped&&(V===null||V.isXRRenderTarget===!0)&&(oe=i.toneMapping);let Ie={shaderID:tt,shaderType:M.type,shaderName:M.name,vertexShader:lt,fragmentShader:Pt,defines:M.defines,customVertexShaderID:Lt,customFragmentShaderID:K,isRawShaderMaterial:M.isRawShaderMaterial===!0,glslVersion:M.glslVersion,precision:d,batching:bt,batchingColor:bt&&B._colorsTexture!==null,instancing:Et,instancingColor:Et&&B.instanceColor!==null,instancingMorph:Et&&B.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:V===null?i.outputColorSpace:V.isXRRenderTarget===!0?V.texture.colorSpace:fr,alphaToCoverage:!!M.alphaToCoverage,map:ft,matcap:Jt,envMap:C,envMapMode:C&&k.mapping,envMapCubeUVHeight:G,aoMap:Ct,lightMap:it,bumpMap:j,normalMap:ct,displacementMap:f&&Nt,emissiveMap:_t,normalMapObjectSpace:ct&&M.normalMapType===jg,normalMapTangentSpace:ct&&M.normalMapType===Vf,metalnessMap:Dt,roughnessMap:Zt,anisotropy:ee,anisotropyMap:at,clearcoat:U,clearcoatMap:Ht,clearcoatNormalMap:xt,clearcoatRoughnessMap:Vt,dispersion:y,iridescence:z,iridescenceMap:Ot,iridescenceThicknessMap:mt,sheen:et,sheenColorMap:At,sheenRoughnessMap:$t,specularMap:Yt,specularColorMap:It,specularIntensityMap:se,transmission:ht,transmissionMap:X,thicknessMap:Mt,gradientMap:wt,opaque:M.transparent===!1&&M.blending===hr&&M.alphaToCoverage===!1,alphaMap:Gt,alphaTest:yt,alphaHash:gt,combine:M.combine,mapUv:ft&&_(M.map.channel),aoMapUv:Ct&&_(M.aoMap.channel),lightMapUv:it&&_(M.lightMap.channel),bumpMapUv:j&&_(M.bumpMap.channel),normalMapUv:ct&&_(M.normalMap.channel),displacementMapUv:Nt&&_(M.displacementMap.channel),emissiveMapUv:_t&&_(M.emissiveMap.channel),metalnessMapUv:Dt&&_(M.metalnessMap.channel),roughnessMapUv:Zt&&_(M.roughnessMap.channel),anisotropyMapUv:at&&_(M.anisotropyMap.channel),clearcoatMapUv:Ht&&_(M.clearcoatMap.channel),clearcoatNormalMapUv:xt&&_(M.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Vt&&_(M.clearcoatRoughnessMap.channel),iridescenceMapUv:Ot&&_(M.iridescenceMap.channel),iridescenceThicknessMapUv:mt&&_(M.iridescenceThicknessMap.channel),sheenColorMapUv:At&&_(M.sheenColorMap.channel),sheenRoughnessMapUv:$t&&_(M.sheenRoughnessMap.channel),specularMapUv:Yt&&_(M.specularMap.channel),specularColorMapUv:It&&_(M.specularColorMap.channel),specularIntensityMapUv:se&&_(M.specularIntensityMap.channel),transmissionMapUv:X&&_(M.transmissionMap.channel),thicknessMapUv:Mt&&_(M.thicknessMap.channel),alphaMapUv:Gt&&_(M.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(ct||ee),vertexColors:M.vertexColors,vertexAlphas:M.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:B.isPoints===!0&&!!W.attributes.uv&&(ft||Gt),fog:!!H,useFog:M.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:M.flatShading===!0&&M.wireframe===!1,sizeAttenuation:M.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:pt,skinning:B.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:rt,morphTextureStride:ut,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:M.dithering,shadowMapEnabled:i.shadowMap.enabled&&E.length>0,shadowMapType:i.shadowMap.type,toneMapping:oe,decodeVideoTexture:ft&&M.map.isVideoTexture===!0&&ve.getTransfer(M.map.colorSpace)===Re,decodeVideoTextureEmissive:_t&&M.emissiveMap.isVideoTexture===!0&&ve.getTransfer(M.emissiveMap.colorSpace)===Re,premultipliedAlpha:M.premultipliedAlpha,doubleSided:M.side===zn,flipSided:M.side===Bn,useDepthPacking:M.depthPacking>=0,depthPacking:M.depthPacking||0,index0AttributeName:M.index0AttributeName,extensionClipCullDistance:qt&&M.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(qt&&M.extensions.multiDraw===!0||bt)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:M.customProgramCacheKey()};return Ie.vertexUv1s=c.has(1),Ie.vertexUv2s=c.has(2),Ie.vertexUv3s=c.has(3),c.clear(),Ie}function p(M){let b=[];if(M.shaderID?b.push(M.shaderID):(b.push(M.customVertexShaderID),b.push(M.customFragmentShaderID)),M.defines!==void 0)for(let E in M.defines)b.push(E),b.push(M.defines[E]);return M.isRawShaderMaterial===!1&&(A(b,M),S(b,M),b.push(i.outputColorSpace)),b.push(M.customProgramCacheKey),b.join()}function A(M,b){M.push(b.precision),M.push(b.outputColorSpace),M.push(b.envMapMode),M.push(b.envMapCubeUVHeight),M.push(b.mapUv),M.push(b.alphaMapUv),M.push(b.lightMapUv),M.push(b.aoMapUv),M.push(b.bumpMapUv),M.push(b.normalMapUv),M.push(b.displacementMapUv),M.push(b.emissiveMapUv),M.push(b.metalnessMapUv),M.push(b.roughnessMapUv),M.push(b.anisotropyMapUv),M.push(b.clearcoatMapUv),M.push(b.clearcoatNormalMapUv),M.push(b.clearcoatRoughnessMapUv),M.push(b.iridescenceMapUv),M.push(b.iridescenceThicknessMapUv),M.push(b.sheenColorMapUv),M.push(b.sheenRoughnessMapUv),M.push(b.specularMapUv),M.push(b.specularColorMapUv),M.push(b.specularIntensityMapUv),M.push(b.transmissionMapUv),M.push(b.thicknessMapUv),M.push(b.combine),M.push(b.fogExp2),M.push(b.sizeAttenuation),M.push(b.morphTargetsCount),M.push(b.morphAttributeCount),M.push(b.numDirLights),M.push(b.numPointLights),M.push(b.numSpotLights),M.push(b.numSpotLightMaps),M.push(b.numHemiLights),M.push(b.numRectAreaLights),M.push(b.numDirLightShadows),M.push(b.numPointLightShadows),M.push(b.numSpotLightShadows),M.push(b.numSpotLightShadowsWithMaps),M.push(b.numLightProbes),M.push(b.shadowMapType),M.push(b.toneMapping),M.push(b.numClippingPlanes),M.push(b.numClipIntersection),M.push(b.depthPacking)}function S(M,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),b.gradientMap&&a.enable(22),M.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),M.push(a.mask)}function x(M){let b=m[M.type],E;if(b){let O=kn[b];E=Za.clone(O.uniforms)}else E=M.uniforms;return E}function I(M,b){let E;for(let O=0,B=u.length;O<B;O++){let H=u[O];if(H.cacheKey===b){E=H,++E.usedTimes;break}}return E===void 0&&(E=new w1(i,b,M,r),u.push(E)),E}function T(M){if(--M.usedTimes===0){let b=u.indexOf(M);u[b]=u[u.length-1],u.pop(),M.destroy()}}function P(M){l.remove(M)}function L(){l.dispose()}return{getParameters:g,getProgramCacheKey:p,getUniforms:x,acquireProgram:I,releaseProgram:T,releaseShaderCache:P,programs:u,dispose:L}}function A1(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function C1(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function I0(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function L0(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(h,f,d,m,_,g){let p=i[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:m,renderOrder:h.renderOrder,z:_,group:g},i[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=m,p.renderOrder=h.renderOrder,p.z=_,p.group=g),t++,p}function a(h,f,d,m,_,g){let p=o(h,f,d,m,_,g);d.transmission>0?n.push(p):d.transparent===!0?s.push(p):e.push(p)}function l(h,f,d,m,_,g){let p=o(h,f,d,m,_,g);d.transmission>0?n.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,f){e.length>1&&e.sort(h||C1),n.length>1&&n.sort(f||I0),s.length>1&&s.sort(f||I0)}function u(){for(let h=t,f=i.length;h<f;h++){let d=i[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function R1(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new L0,i.set(n,[o])):s>=r.length?(o=new L0,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function P1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new F,color:new he};break;case"SpotLight":e={position:new F,direction:new F,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new F,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new F,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new F,halfWidth:new F,halfHeight:new F};break}return i[t.id]=e,e}}}function I1(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ft};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ft};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ft,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var L1=0;function D1(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function U1(i){let t=new P1,e=I1(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new F);let s=new F,r=new De,o=new De;function a(c){let u=0,h=0,f=0;for(let M=0;M<9;M++)n.probe[M].set(0,0,0);let d=0,m=0,_=0,g=0,p=0,A=0,S=0,x=0,I=0,T=0,P=0;c.sort(D1);for(let M=0,b=c.length;M<b;M++){let E=c[M],O=E.color,B=E.intensity,H=E.distance,W=E.shadow&&E.shadow.map?E.shadow.map.texture:null;if(E.isAmbientLight)u+=O.r*B,h+=O.g*B,f+=O.b*B;else if(E.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(E.sh.coefficients[Z],B);P++}else if(E.isDirectionalLight){let Z=t.get(E);if(Z.color.copy(E.color).multiplyScalar(E.intensity),E.castShadow){let k=E.shadow,G=e.get(E);G.shadowIntensity=k.intensity,G.shadowBias=k.bias,G.shadowNormalBias=k.normalBias,G.shadowRadius=k.radius,G.shadowMapSize=k.mapSize,n.directionalShadow[d]=G,n.directionalShadowMap[d]=W,n.directionalShadowMatrix[d]=E.shadow.matrix,A++}n.directional[d]=Z,d++}else if(E.isSpotLight){let Z=t.get(E);Z.position.setFromMatrixPosition(E.matrixWorld),Z.color.copy(O).multiplyScalar(B),Z.distance=H,Z.coneCos=Math.cos(E.angle),Z.penumbraCos=Math.cos(E.angle*(1-E.penumbra)),Z.decay=E.decay,n.spot[_]=Z;let k=E.shadow;if(E.map&&(n.spotLightMap[I]=E.map,I++,k.updateMatrices(E),E.castShadow&&T++),n.spotLightMatrix[_]=k.matrix,E.castShadow){let G=e.get(E);G.shadowIntensity=k.intensity,G.shadowBias=k.bias,G.shadowNormalBias=k.normalBias,G.shadowRadius=k.radius,G.shadowMapSize=k.mapSize,n.spotShadow[_]=G,n.spotShadowMap[_]=W,x++}_++}else if(E.isRectAreaLight){let Z=t.get(E);Z.color.copy(O).multiplyScalar(B),Z.halfWidth.set(E.width*.5,0,0),Z.halfHeight.set(0,E.height*.5,0),n.rectArea[g]=Z,g++}else if(E.isPointLight){let Z=t.get(E);if(Z.color.copy(E.color).multiplyScalar(E.intensity),Z.distance=E.distance,Z.decay=E.decay,E.castShadow){let k=E.shadow,G=e.get(E);G.shadowIntensity=k.intensity,G.shadowBias=k.bias,G.shadowNormalBias=k.normalBias,G.shadowRadius=k.radius,G.shadowMapSize=k.mapSize,G.shadowCameraNear=k.camera.near,G.shadowCameraFar=k.camera.far,n.pointShadow[m]=G,n.pointShadowMap[m]=W,n.pointShadowMatrix[m]=E.shadow.matrix,S++}n.point[m]=Z,m++}else if(E.isHemisphereLight){let Z=t.get(E);Z.skyColor.copy(E.color).multiplyScalar(B),Z.groundColor.copy(E.groundColor).multiplyScalar(B),n.hemi[p]=Z,p++}}g>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Rt.LTC_FLOAT_1,n.rectAreaLTC2=Rt.LTC_FLOAT_2):(n.rectAreaLTC1=Rt.LTC_HALF_1,n.rectAreaLTC2=Rt.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let L=n.hash;(L.directionalLength!==d||L.pointLength!==m||L.spotLength!==_||L.rectAreaLength!==g||L.hemiLength!==p||L.numDirectionalShadows!==A||L.numPointShadows!==S||L.numSpotShadows!==x||L.numSpotMaps!==I||L.numLightProbes!==P)&&(n.directional.length=d,n.spot.length=_,n.rectArea.length=g,n.point.length=m,n.hemi.length=p,n.directionalShadow.length=A,n.directionalShadowMap.length=A,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=x,n.spotShadowMap.length=x,n.directionalShadowMatrix.length=A,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=x+I-T,n.spotLightMap.length=I,n.numSpotLightShadowsWithMaps=T,n.numLightProbes=P,L.directionalLength=d,L.pointLength=m,L.spotLength=_,L.rectAreaLength=g,L.hemiLength=p,L.numDirectionalShadows=A,L.numPointShadows=S,L.numSpotShadows=x,L.numSpotMaps=I,L.numLightProbes=P,n.version=L1++)}function l(c,u){let h=0,f=0,d=0,m=0,_=0,g=u.matrixWorldInverse;for(let p=0,A=c.length;p<A;p++){let S=c[p];if(S.isDirectionalLight){let x=n.directional[h];x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(g),h++}else if(S.isSpotLight){let x=n.spot[d];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(g),x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(g),d++}else if(S.isRectAreaLight){let x=n.rectArea[m];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),x.halfWidth.set(S.width*.5,0,0),x.halfHeight.set(0,S.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),m++}else if(S.isPointLight){let x=n.point[f];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let x=n.hemi[_];x.direction.setFromMatrixPosition(S.matrixWorld),x.direction.transformDirection(g),_++}}}return{setup:a,setupView:l,state:n}}function D0(i){let t=new U1(i),e=[],n=[];function s(u){c.camera=u,e.length=0,n.length=0}function r(u){e.push(u)}function o(u){n.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}let c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function N1(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new D0(i),t.set(s,[a])):r>=o.length?(a=new D0(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var F1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,O1=`uniform sampler2D shadow_pass;
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
}`;function B1(i,t,e){let n=new Mo,s=new Ft,r=new Ft,o=new Pe,a=new Mc({depthPacking:Kg}),l=new Sc,c={},u=e.maxTextureSize,h={[ps]:Bn,[Bn]:ps,[zn]:zn},f=new ni({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ft},radius:{value:4}},vertexShader:F1,fragmentShader:O1}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new Je;m.setAttribute("position",new vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new de(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Cf;let p=this.type;this.render=function(T,P,L){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;let M=i.getRenderTarget(),b=i.getActiveCubeFace(),E=i.getActiveMipmapLevel(),O=i.state;O.setBlending(gs),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let B=p!==Zi&&this.type===Zi,H=p===Zi&&this.type!==Zi;for(let W=0,Z=T.length;W<Z;W++){let k=T[W],G=k.shadow;if(G===void 0){console.warn("THREE.WebGLShadowMap:",k,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let tt=G.getFrameExtents();if(s.multiply(tt),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/tt.x),s.x=r.x*tt.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/tt.y),s.y=r.y*tt.y,G.mapSize.y=r.y)),G.map===null||B===!0||H===!0){let rt=this.type!==Zi?{minFilter:pi,magFilter:pi}:{};G.map!==null&&G.map.dispose(),G.map=new Xi(s.x,s.y,rt),G.map.texture.name=k.name+".shadowMap",G.camera.updateProjectionMatrix()}i.setRenderTarget(G.map),i.clear();let ot=G.getViewportCount();for(let rt=0;rt<ot;rt++){let ut=G.getViewport(rt);o.set(r.x*ut.x,r.y*ut.y,r.x*ut.z,r.y*ut.w),O.viewport(o),G.updateMatrices(k,rt),n=G.getFrustum(),x(P,L,G.camera,k,this.type)}G.isPointLightShadow!==!0&&this.type===Zi&&A(G,L),G.needsUpdate=!1}p=this.type,g.needsUpdate=!1,i.setRenderTarget(M,b,E)};function A(T,P){let L=t.update(_);f.defines.VSM_SAMPLES!==T.blurSamples&&(f.defines.VSM_SAMPLES=T.blurSamples,d.defines.VSM_SAMPLES=T.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),T.mapPass===null&&(T.mapPass=new Xi(s.x,s.y)),f.uniforms.shadow_pass.value=T.map.texture,f.uniforms.resolution.value=T.mapSize,f.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(P,null,L,f,_,null),d.uniforms.shadow_pass.value=T.mapPass.texture,d.uniforms.resolution.value=T.mapSize,d.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(P,null,L,d,_,null)}function S(T,P,L,M){let b=null,E=L.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(E!==void 0)b=E;else if(b=L.isPointLight===!0?l:a,i.localClippingEnabled&&P.clipShadows===!0&&Array.isArray(P.clippingPlanes)&&P.clippingPlanes.length!==0||P.displacementMap&&P.displacementScale!==0||P.alphaMap&&P.alphaTest>0||P.map&&P.alphaTest>0||P.alphaToCoverage===!0){let O=b.uuid,B=P.uuid,H=c[O];H===void 0&&(H={},c[O]=H);let W=H[B];W===void 0&&(W=b.clone(),H[B]=W,P.addEventListener("dispose",I)),b=W}if(b.visible=P.visible,b.wireframe=P.wireframe,M===Zi?b.side=P.shadowSide!==null?P.shadowSide:P.side:b.side=P.shadowSide!==null?P.shadowSide:h[P.side],b.alphaMap=P.alphaMap,b.alphaTest=P.alphaToCoverage===!0?.5:P.alphaTest,b.map=P.map,b.clipShadows=P.clipShadows,b.clippingPlanes=P.clippingPlanes,b.clipIntersection=P.clipIntersection,b.displacementMap=P.displacementMap,b.displacementScale=P.displacementScale,b.displacementBias=P.displacementBias,b.wireframeLinewidth=P.wireframeLinewidth,b.linewidth=P.linewidth,L.isPointLight===!0&&b.isMeshDistanceMaterial===!0){let O=i.properties.get(b);O.light=L}return b}function x(T,P,L,M,b){if(T.visible===!1)return;if(T.layers.test(P.layers)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&b===Zi)&&(!T.frustumCulled||n.intersectsObject(T))){T.modelViewMatrix.multiplyMatrices(L.matrixWorldInverse,T.matrixWorld);let B=t.update(T),H=T.material;if(Array.isArray(H)){let W=B.groups;for(let Z=0,k=W.length;Z<k;Z++){let G=W[Z],tt=H[G.materialIndex];if(tt&&tt.visible){let ot=S(T,tt,M,b);T.onBeforeShadow(i,T,P,L,B,ot,G),i.renderBufferDirect(L,null,B,ot,T,G),T.onAfterShadow(i,T,P,L,B,ot,G)}}}else if(H.visible){let W=S(T,H,M,b);T.onBeforeShadow(i,T,P,L,B,W,null),i.renderBufferDirect(L,null,B,W,T,null),T.onAfterShadow(i,T,P,L,B,W,null)}}let O=T.children;for(let B=0,H=O.length;B<H;B++)x(O[B],P,L,M,b)}function I(T){T.target.removeEventListener("dispose",I);for(let L in c){let M=c[L],b=T.target.uuid;b in M&&(M[b].dispose(),delete M[b])}}}var z1={[Uc]:Nc,[Fc]:zc,[Oc]:kc,[ur]:Bc,[Nc]:Uc,[zc]:Fc,[kc]:Oc,[Bc]:ur};function k1(i,t){function e(){let X=!1,Mt=new Pe,wt=null,Gt=new Pe(0,0,0,0);return{setMask:function(yt){wt!==yt&&!X&&(i.colorMask(yt,yt,yt,yt),wt=yt)},setLocked:function(yt){X=yt},setClear:function(yt,gt,qt,oe,Ie){Ie===!0&&(yt*=oe,gt*=oe,qt*=oe),Mt.set(yt,gt,qt,oe),Gt.equals(Mt)===!1&&(i.clearColor(yt,gt,qt,oe),Gt.copy(Mt))},reset:function(){X=!1,wt=null,Gt.set(-1,0,0,0)}}}function n(){let X=!1,Mt=!1,wt=null,Gt=null,yt=null;return{setReversed:function(gt){if(Mt!==gt){let qt=t.get("EXT_clip_control");gt?qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.ZERO_TO_ONE_EXT):qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.NEGATIVE_ONE_TO_ONE_EXT),Mt=gt;let oe=yt;yt=null,this.setClear(oe)}},getReversed:function(){return Mt},setTest:function(gt){gt?V(i.DEPTH_TEST):pt(i.DEPTH_TEST)},setMask:function(gt){wt!==gt&&!X&&(i.depthMask(gt),wt=gt)},setFunc:function(gt){if(Mt&&(gt=z1[gt]),Gt!==gt){switch(gt){case Uc:i.depthFunc(i.NEVER);break;case Nc:i.depthFunc(i.ALWAYS);break;case Fc:i.depthFunc(i.LESS);break;case ur:i.depthFunc(i.LEQUAL);break;case Oc:i.depthFunc(i.EQUAL);break;case Bc:i.depthFunc(i.GEQUAL);break;case zc:i.depthFunc(i.GREATER);break;case kc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Gt=gt}},setLocked:function(gt){X=gt},setClear:function(gt){yt!==gt&&(Mt&&(gt=1-gt),i.clearDepth(gt),yt=gt)},reset:function(){X=!1,wt=null,Gt=null,yt=null,Mt=!1}}}function s(){let X=!1,Mt=null,wt=null,Gt=null,yt=null,gt=null,qt=null,oe=null,Ie=null;return{setTest:function(xe){X||(xe?V(i.STENCIL_TEST):pt(i.STENCIL_TEST))},setMask:function(xe){Mt!==xe&&!X&&(i.stencilMask(xe),Mt=xe)},setFunc:function(xe,gn,Ne){(wt!==xe||Gt!==gn||yt!==Ne)&&(i.stencilFunc(xe,gn,Ne),wt=xe,Gt=gn,yt=Ne)},setOp:function(xe,gn,Ne){(gt!==xe||qt!==gn||oe!==Ne)&&(i.stencilOp(xe,gn,Ne),gt=xe,qt=gn,oe=Ne)},setLocked:function(xe){X=xe},setClear:function(xe){Ie!==xe&&(i.clearStencil(xe),Ie=xe)},reset:function(){X=!1,Mt=null,wt=null,Gt=null,yt=null,gt=null,qt=null,oe=null,Ie=null}}}let r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,d=[],m=null,_=!1,g=null,p=null,A=null,S=null,x=null,I=null,T=null,P=new he(0,0,0),L=0,M=!1,b=null,E=null,O=null,B=null,H=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),Z=!1,k=0,G=i.getParameter(i.VERSION);G.indexOf("WebGL")!==-1?(k=parseFloat(/^WebGL (\d)/.exec(G)[1]),Z=k>=1):G.indexOf("OpenGL ES")!==-1&&(k=parseFloat(/^OpenGL ES (\d)/.exec(G)[1]),Z=k>=2);let tt=null,ot={},rt=i.getParameter(i.SCISSOR_BOX),ut=i.getParameter(i.VIEWPORT),lt=new Pe().fromArray(rt),Pt=new Pe().fromArray(ut);function Lt(X,Mt,wt,Gt){let yt=new Uint8Array(4),gt=i.createTexture();i.bindTexture(X,gt),i.texParameteri(X,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(X,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qt=0;qt<wt;qt++)X===i.TEXTURE_3D||X===i.TEXTURE_2D_ARRAY?i.texImage3D(Mt,0,i.RGBA,1,1,Gt,0,i.RGBA,i.UNSIGNED_BYTE,yt):i.texImage2D(Mt+qt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,yt);return gt}let K={};K[i.TEXTURE_2D]=Lt(i.TEXTURE_2D,i.TEXTURE_2D,1),K[i.TEXTURE_CUBE_MAP]=Lt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),K[i.TEXTURE_2D_ARRAY]=Lt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),K[i.TEXTURE_3D]=Lt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),V(i.DEPTH_TEST),o.setFunc(ur),j(!1),ct(Af),V(i.CULL_FACE),Ct(gs);function V(X){u[X]!==!0&&(i.enable(X),u[X]=!0)}function pt(X){u[X]!==!1&&(i.disable(X),u[X]=!1)}function Et(X,Mt){return h[X]!==Mt?(i.bindFramebuffer(X,Mt),h[X]=Mt,X===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=Mt),X===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=Mt),!0):!1}function bt(X,Mt){let wt=d,Gt=!1;if(X){wt=f.get(Mt),wt===void 0&&(wt=[],f.set(Mt,wt));let yt=X.textures;if(wt.length!==yt.length||wt[0]!==i.COLOR_ATTACHMENT0){for(let gt=0,qt=yt.length;gt<qt;gt++)wt[gt]=i.COLOR_ATTACHMENT0+gt;wt.length=yt.length,Gt=!0}}else wt[0]!==i.BACK&&(wt[0]=i.BACK,Gt=!0);Gt&&i.drawBuffers(wt)}function ft(X){return m!==X?(i.useProgram(X),m=X,!0):!1}let Jt={[Ns]:i.FUNC_ADD,[Sg]:i.FUNC_SUBTRACT,[wg]:i.FUNC_REVERSE_SUBTRACT};Jt[Eg]=i.MIN,Jt[Tg]=i.MAX;let C={[Ag]:i.ZERO,[Cg]:i.ONE,[Rg]:i.SRC_COLOR,[ec]:i.SRC_ALPHA,[Ng]:i.SRC_ALPHA_SATURATE,[Dg]:i.DST_COLOR,[Ig]:i.DST_ALPHA,[Pg]:i.ONE_MINUS_SRC_COLOR,[nc]:i.ONE_MINUS_SRC_ALPHA,[Ug]:i.ONE_MINUS_DST_COLOR,[Lg]:i.ONE_MINUS_DST_ALPHA,[Fg]:i.CONSTANT_COLOR,[Og]:i.ONE_MINUS_CONSTANT_COLOR,[Bg]:i.CONSTANT_ALPHA,[zg]:i.ONE_MINUS_CONSTANT_ALPHA};function Ct(X,Mt,wt,Gt,yt,gt,qt,oe,Ie,xe){if(X===gs){_===!0&&(pt(i.BLEND),_=!1);return}if(_===!1&&(V(i.BLEND),_=!0),X!==Mg){if(X!==g||xe!==M){if((p!==Ns||x!==Ns)&&(i.blendEquation(i.FUNC_ADD),p=Ns,x=Ns),xe)switch(X){case hr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Rf:i.blendFunc(i.ONE,i.ONE);break;case Pf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case If:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",X);break}else switch(X){case hr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Rf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Pf:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case If:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",X);break}A=null,S=null,I=null,T=null,P.set(0,0,0),L=0,g=X,M=xe}return}yt=yt||Mt,gt=gt||wt,qt=qt||Gt,(Mt!==p||yt!==x)&&(i.blendEquationSeparate(Jt[Mt],Jt[yt]),p=Mt,x=yt),(wt!==A||Gt!==S||gt!==I||qt!==T)&&(i.blendFuncSeparate(C[wt],C[Gt],C[gt],C[qt]),A=wt,S=Gt,I=gt,T=qt),(oe.equals(P)===!1||Ie!==L)&&(i.blendColor(oe.r,oe.g,oe.b,Ie),P.copy(oe),L=Ie),g=X,M=!1}function it(X,Mt){X.side===zn?pt(i.CULL_FACE):V(i.CULL_FACE);let wt=X.side===Bn;Mt&&(wt=!wt),j(wt),X.blending===hr&&X.transparent===!1?Ct(gs):Ct(X.blending,X.blendEquation,X.blendSrc,X.blendDst,X.blendEquationAlpha,X.blendSrcAlpha,X.blendDstAlpha,X.blendColor,X.blendAlpha,X.premultipliedAlpha),o.setFunc(X.depthFunc),o.setTest(X.depthTest),o.setMask(X.depthWrite),r.setMask(X.colorWrite);let Gt=X.stencilWrite;a.setTest(Gt),Gt&&(a.setMask(X.stencilWriteMask),a.setFunc(X.stencilFunc,X.stencilRef,X.stencilFuncMask),a.setOp(X.stencilFail,X.stencilZFail,X.stencilZPass)),_t(X.polygonOffset,X.polygonOffsetFactor,X.polygonOffsetUnits),X.alphaToCoverage===!0?V(i.SAMPLE_ALPHA_TO_COVERAGE):pt(i.SAMPLE_ALPHA_TO_COVERAGE)}function j(X){b!==X&&(X?i.frontFace(i.CW):i.frontFace(i.CCW),b=X)}function ct(X){X!==xg?(V(i.CULL_FACE),X!==E&&(X===Af?i.cullFace(i.BACK):X===yg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):pt(i.CULL_FACE),E=X}function Nt(X){X!==O&&(Z&&i.lineWidth(X),O=X)}function _t(X,Mt,wt){X?(V(i.POLYGON_OFFSET_FILL),(B!==Mt||H!==wt)&&(i.polygonOffset(Mt,wt),B=Mt,H=wt)):pt(i.POLYGON_OFFSET_FILL)}function Dt(X){X?V(i.SCISSOR_TEST):pt(i.SCISSOR_TEST)}function Zt(X){X===void 0&&(X=i.TEXTURE0+W-1),tt!==X&&(i.activeTexture(X),tt=X)}function ee(X,Mt,wt){wt===void 0&&(tt===null?wt=i.TEXTURE0+W-1:wt=tt);let Gt=ot[wt];Gt===void 0&&(Gt={type:void 0,texture:void 0},ot[wt]=Gt),(Gt.type!==X||Gt.texture!==Mt)&&(tt!==wt&&(i.activeTexture(wt),tt=wt),i.bindTexture(X,Mt||K[X]),Gt.type=X,Gt.texture=Mt)}function U(){let X=ot[tt];X!==void 0&&X.type!==void 0&&(i.bindTexture(X.type,null),X.type=void 0,X.texture=void 0)}function y(){try{i.compressedTexImage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function z(){try{i.compressedTexImage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function et(){try{i.texSubImage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function ht(){try{i.texSubImage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function at(){try{i.compressedTexSubImage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function Ht(){try{i.compressedTexSubImage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function xt(){try{i.texStorage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function Vt(){try{i.texStorage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function Ot(){try{i.texImage2D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function mt(){try{i.texImage3D(...arguments)}catch(X){console.error("THREE.WebGLState:",X)}}function At(X){lt.equals(X)===!1&&(i.scissor(X.x,X.y,X.z,X.w),lt.copy(X))}function $t(X){Pt.equals(X)===!1&&(i.viewport(X.x,X.y,X.z,X.w),Pt.copy(X))}function Yt(X,Mt){let wt=c.get(Mt);wt===void 0&&(wt=new WeakMap,c.set(Mt,wt));let Gt=wt.get(X);Gt===void 0&&(Gt=i.getUniformBlockIndex(Mt,X.name),wt.set(X,Gt))}function It(X,Mt){let Gt=c.get(Mt).get(X);l.get(Mt)!==Gt&&(i.uniformBlockBinding(Mt,Gt,X.__bindingPointIndex),l.set(Mt,Gt))}function se(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},tt=null,ot={},h={},f=new WeakMap,d=[],m=null,_=!1,g=null,p=null,A=null,S=null,x=null,I=null,T=null,P=new he(0,0,0),L=0,M=!1,b=null,E=null,O=null,B=null,H=null,lt.set(0,0,i.canvas.width,i.canvas.height),Pt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:V,disable:pt,bindFramebuffer:Et,drawBuffers:bt,useProgram:ft,setBlending:Ct,setMaterial:it,setFlipSided:j,setCullFace:ct,setLineWidth:Nt,setPolygonOffset:_t,setScissorTest:Dt,activeTexture:Zt,bindTexture:ee,unbindTexture:U,compressedTexImage2D:y,compressedTexImage3D:z,texImage2D:Ot,texImage3D:mt,updateUBOMapping:Yt,uniformBlockBinding:It,texStorage2D:xt,texStorage3D:Vt,texSubImage2D:et,texSubImage3D:ht,compressedTexSubImage2D:at,compressedTexSubImage3D:Ht,scissor:At,viewport:$t,reset:se}}function H1(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ft,u=new WeakMap,h,f=new WeakMap,d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(U,y){return d?new OffscreenCanvas(U,y):ma("canvas")}function _(U,y,z){let et=1,ht=ee(U);if((ht.width>z||ht.height>z)&&(et=z/Math.max(ht.width,ht.height)),et<1)if(typeof HTMLImageElement<"u"&&U instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&U instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&U instanceof ImageBitmap||typeof VideoFrame<"u"&&U instanceof VideoFrame){let at=Math.floor(et*ht.width),Ht=Math.floor(et*ht.height);h===void 0&&(h=m(at,Ht));let xt=y?m(at,Ht):h;return xt.width=at,xt.height=Ht,xt.getContext("2d").drawImage(U,0,0,at,Ht),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+ht.width+"x"+ht.height+") to ("+at+"x"+Ht+")."),xt}else return"data"in U&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+ht.width+"x"+ht.height+")."),U;return U}function g(U){return U.generateMipmaps}function p(U){i.generateMipmap(U)}function A(U){return U.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:U.isWebGL3DRenderTarget?i.TEXTURE_3D:U.isWebGLArrayRenderTarget||U.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(U,y,z,et,ht=!1){if(U!==null){if(i[U]!==void 0)return i[U];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+U+"'")}let at=y;if(y===i.RED&&(z===i.FLOAT&&(at=i.R32F),z===i.HALF_FLOAT&&(at=i.R16F),z===i.UNSIGNED_BYTE&&(at=i.R8)),y===i.RED_INTEGER&&(z===i.UNSIGNED_BYTE&&(at=i.R8UI),z===i.UNSIGNED_SHORT&&(at=i.R16UI),z===i.UNSIGNED_INT&&(at=i.R32UI),z===i.BYTE&&(at=i.R8I),z===i.SHORT&&(at=i.R16I),z===i.INT&&(at=i.R32I)),y===i.RG&&(z===i.FLOAT&&(at=i.RG32F),z===i.HALF_FLOAT&&(at=i.RG16F),z===i.UNSIGNED_BYTE&&(at=i.RG8)),y===i.RG_INTEGER&&(z===i.UNSIGNED_BYTE&&(at=i.RG8UI),z===i.UNSIGNED_SHORT&&(at=i.RG16UI),z===i.UNSIGNED_INT&&(at=i.RG32UI),z===i.BYTE&&(at=i.RG8I),z===i.SHORT&&(at=i.RG16I),z===i.INT&&(at=i.RG32I)),y===i.RGB_INTEGER&&(z===i.UNSIGNED_BYTE&&(at=i.RGB8UI),z===i.UNSIGNED_SHORT&&(at=i.RGB16UI),z===i.UNSIGNED_INT&&(at=i.RGB32UI),z===i.BYTE&&(at=i.RGB8I),z===i.SHORT&&(at=i.RGB16I),z===i.INT&&(at=i.RGB32I)),y===i.RGBA_INTEGER&&(z===i.UNSIGNED_BYTE&&(at=i.RGBA8UI),z===i.UNSIGNED_SHORT&&(at=i.RGBA16UI),z===i.UNSIGNED_INT&&(at=i.RGBA32UI),z===i.BYTE&&(at=i.RGBA8I),z===i.SHORT&&(at=i.RGBA16I),z===i.INT&&(at=i.RGBA32I)),y===i.RGB&&(z===i.UNSIGNED_INT_5_9_9_9_REV&&(at=i.RGB9_E5),z===i.UNSIGNED_INT_10F_11F_11F_REV&&(at=i.R11F_G11F_B10F)),y===i.RGBA){let Ht=ht?da:ve.getTransfer(et);z===i.FLOAT&&(at=i.RGBA32F),z===i.HALF_FLOAT&&(at=i.RGBA16F),z===i.UNSIGNED_BYTE&&(at=Ht===Re?i.SRGB8_ALPHA8:i.RGBA8),z===i.UNSIGNED_SHORT_4_4_4_4&&(at=i.RGBA4),z===i.UNSIGNED_SHORT_5_5_5_1&&(at=i.RGB5_A1)}return(at===i.R16F||at===i.R32F||at===i.RG16F||at===i.RG32F||at===i.RGBA16F||at===i.RGBA32F)&&t.get("EXT_color_buffer_float"),at}function x(U,y){let z;return U?y===null||y===Gs||y===To?z=i.DEPTH24_STENCIL8:y===Ji?z=i.DEPTH32F_STENCIL8:y===wo&&(z=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Gs||y===To?z=i.DEPTH_COMPONENT24:y===Ji?z=i.DEPTH_COMPONENT32F:y===wo&&(z=i.DEPTH_COMPONENT16),z}function I(U,y){return g(U)===!0||U.isFramebufferTexture&&U.minFilter!==pi&&U.minFilter!==Li?Math.log2(Math.max(y.width,y.height))+1:U.mipmaps!==void 0&&U.mipmaps.length>0?U.mipmaps.length:U.isCompressedTexture&&Array.isArray(U.image)?y.mipmaps.length:1}function T(U){let y=U.target;y.removeEventListener("dispose",T),L(y),y.isVideoTexture&&u.delete(y)}function P(U){let y=U.target;y.removeEventListener("dispose",P),b(y)}function L(U){let y=n.get(U);if(y.__webglInit===void 0)return;let z=U.source,et=f.get(z);if(et){let ht=et[y.__cacheKey];ht.usedTimes--,ht.usedTimes===0&&M(U),Object.keys(et).length===0&&f.delete(z)}n.remove(U)}function M(U){let y=n.get(U);i.deleteTexture(y.__webglTexture);let z=U.source,et=f.get(z);delete et[y.__cacheKey],o.memory.textures--}function b(U){let y=n.get(U);if(U.depthTexture&&(U.depthTexture.dispose(),n.remove(U.depthTexture)),U.isWebGLCubeRenderTarget)for(let et=0;et<6;et++){if(Array.isArray(y.__webglFramebuffer[et]))for(let ht=0;ht<y.__webglFramebuffer[et].length;ht++)i.deleteFramebuffer(y.__webglFramebuffer[et][ht]);else i.deleteFramebuffer(y.__webglFramebuffer[et]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[et])}else{if(Array.isArray(y.__webglFramebuffer))for(let et=0;et<y.__webglFramebuffer.length;et++)i.deleteFramebuffer(y.__webglFramebuffer[et]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let et=0;et<y.__webglColorRenderbuffer.length;et++)y.__webglColorRenderbuffer[et]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[et]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let z=U.textures;for(let et=0,ht=z.length;et<ht;et++){let at=n.get(z[et]);at.__webglTexture&&(i.deleteTexture(at.__webglTexture),o.memory.textures--),n.remove(z[et])}n.remove(U)}let E=0;function O(){E=0}function B(){let U=E;return U>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+U+" texture units while this GPU supports only "+s.maxTextures),E+=1,U}function H(U){let y=[];return y.push(U.wrapS),y.push(U.wrapT),y.push(U.wrapR||0),y.push(U.magFilter),y.push(U.minFilter),y.push(U.anisotropy),y.push(U.internalFormat),y.push(U.format),y.push(U.type),y.push(U.generateMipmaps),y.push(U.premultiplyAlpha),y.push(U.flipY),y.push(U.unpackAlignment),y.push(U.colorSpace),y.join()}function W(U,y){let z=n.get(U);if(U.isVideoTexture&&Dt(U),U.isRenderTargetTexture===!1&&U.isExternalTexture!==!0&&U.version>0&&z.__version!==U.version){let et=U.image;if(et===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(et.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{K(z,U,y);return}}else U.isExternalTexture&&(z.__webglTexture=U.sourceTexture?U.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,z.__webglTexture,i.TEXTURE0+y)}function Z(U,y){let z=n.get(U);if(U.isRenderTargetTexture===!1&&U.version>0&&z.__version!==U.version){K(z,U,y);return}e.bindTexture(i.TEXTURE_2D_ARRAY,z.__webglTexture,i.TEXTURE0+y)}function k(U,y){let z=n.get(U);if(U.isRenderTargetTexture===!1&&U.version>0&&z.__version!==U.version){K(z,U,y);return}e.bindTexture(i.TEXTURE_3D,z.__webglTexture,i.TEXTURE0+y)}function G(U,y){let z=n.get(U);if(U.version>0&&z.__version!==U.version){V(z,U,y);return}e.bindTexture(i.TEXTURE_CUBE_MAP,z.__webglTexture,i.TEXTURE0+y)}let tt={[ic]:i.REPEAT,[Us]:i.CLAMP_TO_EDGE,[sc]:i.MIRRORED_REPEAT},ot={[pi]:i.NEAREST,[Zg]:i.NEAREST_MIPMAP_NEAREST,[Wa]:i.NEAREST_MIPMAP_LINEAR,[Li]:i.LINEAR,[Gc]:i.LINEAR_MIPMAP_NEAREST,[Vs]:i.LINEAR_MIPMAP_LINEAR},rt={[Qg]:i.NEVER,[r0]:i.ALWAYS,[t0]:i.LESS,[Gf]:i.LEQUAL,[e0]:i.EQUAL,[s0]:i.GEQUAL,[n0]:i.GREATER,[i0]:i.NOTEQUAL};function ut(U,y){if(y.type===Ji&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===Li||y.magFilter===Gc||y.magFilter===Wa||y.magFilter===Vs||y.minFilter===Li||y.minFilter===Gc||y.minFilter===Wa||y.minFilter===Vs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(U,i.TEXTURE_WRAP_S,tt[y.wrapS]),i.texParameteri(U,i.TEXTURE_WRAP_T,tt[y.wrapT]),(U===i.TEXTURE_3D||U===i.TEXTURE_2D_ARRAY)&&i.texParameteri(U,i.TEXTURE_WRAP_R,tt[y.wrapR]),i.texParameteri(U,i.TEXTURE_MAG_FILTER,ot[y.magFilter]),i.texParameteri(U,i.TEXTURE_MIN_FILTER,ot[y.minFilter]),y.compareFunction&&(i.texParameteri(U,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(U,i.TEXTURE_COMPARE_FUNC,rt[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===pi||y.minFilter!==Wa&&y.minFilter!==Vs||y.type===Ji&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let z=t.get("EXT_texture_filter_anisotropic");i.texParameterf(U,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function lt(U,y){let z=!1;U.__webglInit===void 0&&(U.__webglInit=!0,y.addEventListener("dispose",T));let et=y.source,ht=f.get(et);ht===void 0&&(ht={},f.set(et,ht));let at=H(y);if(at!==U.__cacheKey){ht[at]===void 0&&(ht[at]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,z=!0),ht[at].usedTimes++;let Ht=ht[U.__cacheKey];Ht!==void 0&&(ht[U.__cacheKey].usedTimes--,Ht.usedTimes===0&&M(y)),U.__cacheKey=at,U.__webglTexture=ht[at].texture}return z}function Pt(U,y,z){return Math.floor(Math.floor(U/z)/y)}function Lt(U,y,z,et){let at=U.updateRanges;if(at.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,z,et,y.data);else{at.sort((mt,At)=>mt.start-At.start);let Ht=0;for(let mt=1;mt<at.length;mt++){let At=at[Ht],$t=at[mt],Yt=At.start+At.count,It=Pt($t.start,y.width,4),se=Pt(At.start,y.width,4);$t.start<=Yt+1&&It===se&&Pt($t.start+$t.count-1,y.width,4)===It?At.count=Math.max(At.count,$t.start+$t.count-At.start):(++Ht,at[Ht]=$t)}at.length=Ht+1;let xt=i.getParameter(i.UNPACK_ROW_LENGTH),Vt=i.getParameter(i.UNPACK_SKIP_PIXELS),Ot=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let mt=0,At=at.length;mt<At;mt++){let $t=at[mt],Yt=Math.floor($t.start/4),It=Math.ceil($t.count/4),se=Yt%y.width,X=Math.floor(Yt/y.width),Mt=It,wt=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,se),i.pixelStorei(i.UNPACK_SKIP_ROWS,X),e.texSubImage2D(i.TEXTURE_2D,0,se,X,Mt,wt,z,et,y.data)}U.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,xt),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Vt),i.pixelStorei(i.UNPACK_SKIP_ROWS,Ot)}}function K(U,y,z){let et=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(et=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(et=i.TEXTURE_3D);let ht=lt(U,y),at=y.source;e.bindTexture(et,U.__webglTexture,i.TEXTURE0+z);let Ht=n.get(at);if(at.version!==Ht.__version||ht===!0){e.activeTexture(i.TEXTURE0+z);let xt=ve.getPrimaries(ve.workingColorSpace),Vt=y.colorSpace===vs?null:ve.getPrimaries(y.colorSpace),Ot=y.colorSpace===vs||xt===Vt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ot);let mt=_(y.image,!1,s.maxTextureSize);mt=Zt(y,mt);let At=r.convert(y.format,y.colorSpace),$t=r.convert(y.type),Yt=S(y.internalFormat,At,$t,y.colorSpace,y.isVideoTexture);ut(et,y);let It,se=y.mipmaps,X=y.isVideoTexture!==!0,Mt=Ht.__version===void 0||ht===!0,wt=at.dataReady,Gt=I(y,mt);if(y.isDepthTexture)Yt=x(y.format===Ao,y.type),Mt&&(X?e.texStorage2D(i.TEXTURE_2D,1,Yt,mt.width,mt.height):e.texImage2D(i.TEXTURE_2D,0,Yt,mt.width,mt.height,0,At,$t,null));else if(y.isDataTexture)if(se.length>0){X&&Mt&&e.texStorage2D(i.TEXTURE_2D,Gt,Yt,se[0].width,se[0].height);for(let yt=0,gt=se.length;yt<gt;yt++)It=se[yt],X?wt&&e.texSubImage2D(i.TEXTURE_2D,yt,0,0,It.width,It.height,At,$t,It.data):e.texImage2D(i.TEXTURE_2D,yt,Yt,It.width,It.height,0,At,$t,It.data);y.generateMipmaps=!1}else X?(Mt&&e.texStorage2D(i.TEXTURE_2D,Gt,Yt,mt.width,mt.height),wt&&Lt(y,mt,At,$t)):e.texImage2D(i.TEXTURE_2D,0,Yt,mt.width,mt.height,0,At,$t,mt.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){X&&Mt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Gt,Yt,se[0].width,se[0].height,mt.depth);for(let yt=0,gt=se.length;yt<gt;yt++)if(It=se[yt],y.format!==mi)if(At!==null)if(X){if(wt)if(y.layerUpdates.size>0){let qt=Kf(It.width,It.height,y.format,y.type);for(let oe of y.layerUpdates){let Ie=It.data.subarray(oe*qt/It.data.BYTES_PER_ELEMENT,(oe+1)*qt/It.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,yt,0,0,oe,It.width,It.height,1,At,Ie)}y.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,yt,0,0,0,It.width,It.height,mt.depth,At,It.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,yt,Yt,It.width,It.height,mt.depth,0,It.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else X?wt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,yt,0,0,0,It.width,It.height,mt.depth,At,$t,It.data):e.texImage3D(i.TEXTURE_2D_ARRAY,yt,Yt,It.width,It.height,mt.depth,0,At,$t,It.data)}else{X&&Mt&&e.texStorage2D(i.TEXTURE_2D,Gt,Yt,se[0].width,se[0].height);for(let yt=0,gt=se.length;yt<gt;yt++)It=se[yt],y.format!==mi?At!==null?X?wt&&e.compressedTexSubImage2D(i.TEXTURE_2D,yt,0,0,It.width,It.height,At,It.data):e.compressedTexImage2D(i.TEXTURE_2D,yt,Yt,It.width,It.height,0,It.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):X?wt&&e.texSubImage2D(i.TEXTURE_2D,yt,0,0,It.width,It.height,At,$t,It.data):e.texImage2D(i.TEXTURE_2D,yt,Yt,It.width,It.height,0,At,$t,It.data)}else if(y.isDataArrayTexture)if(X){if(Mt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Gt,Yt,mt.width,mt.height,mt.depth),wt)if(y.layerUpdates.size>0){let yt=Kf(mt.width,mt.height,y.format,y.type);for(let gt of y.layerUpdates){let qt=mt.data.subarray(gt*yt/mt.data.BYTES_PER_ELEMENT,(gt+1)*yt/mt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,gt,mt.width,mt.height,1,At,$t,qt)}y.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,mt.width,mt.height,mt.depth,At,$t,mt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Yt,mt.width,mt.height,mt.depth,0,At,$t,mt.data);else if(y.isData3DTexture)X?(Mt&&e.texStorage3D(i.TEXTURE_3D,Gt,Yt,mt.width,mt.height,mt.depth),wt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,mt.width,mt.height,mt.depth,At,$t,mt.data)):e.texImage3D(i.TEXTURE_3D,0,Yt,mt.width,mt.height,mt.depth,0,At,$t,mt.data);else if(y.isFramebufferTexture){if(Mt)if(X)e.texStorage2D(i.TEXTURE_2D,Gt,Yt,mt.width,mt.height);else{let yt=mt.width,gt=mt.height;for(let qt=0;qt<Gt;qt++)e.texImage2D(i.TEXTURE_2D,qt,Yt,yt,gt,0,At,$t,null),yt>>=1,gt>>=1}}else if(se.length>0){if(X&&Mt){let yt=ee(se[0]);e.texStorage2D(i.TEXTURE_2D,Gt,Yt,yt.width,yt.height)}for(let yt=0,gt=se.length;yt<gt;yt++)It=se[yt],X?wt&&e.texSubImage2D(i.TEXTURE_2D,yt,0,0,At,$t,It):e.texImage2D(i.TEXTURE_2D,yt,Yt,At,$t,It);y.generateMipmaps=!1}else if(X){if(Mt){let yt=ee(mt);e.texStorage2D(i.TEXTURE_2D,Gt,Yt,yt.width,yt.height)}wt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,At,$t,mt)}else e.texImage2D(i.TEXTURE_2D,0,Yt,At,$t,mt);g(y)&&p(et),Ht.__version=at.version,y.onUpdate&&y.onUpdate(y)}U.__version=y.version}function V(U,y,z){if(y.image.length!==6)return;let et=lt(U,y),ht=y.source;e.bindTexture(i.TEXTURE_CUBE_MAP,U.__webglTexture,i.TEXTURE0+z);let at=n.get(ht);if(ht.version!==at.__version||et===!0){e.activeTexture(i.TEXTURE0+z);let Ht=ve.getPrimaries(ve.workingColorSpace),xt=y.colorSpace===vs?null:ve.getPrimaries(y.colorSpace),Vt=y.colorSpace===vs||Ht===xt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Vt);let Ot=y.isCompressedTexture||y.image[0].isCompressedTexture,mt=y.image[0]&&y.image[0].isDataTexture,At=[];for(let gt=0;gt<6;gt++)!Ot&&!mt?At[gt]=_(y.image[gt],!0,s.maxCubemapSize):At[gt]=mt?y.image[gt].image:y.image[gt],At[gt]=Zt(y,At[gt]);let $t=At[0],Yt=r.convert(y.format,y.colorSpace),It=r.convert(y.type),se=S(y.internalFormat,Yt,It,y.colorSpace),X=y.isVideoTexture!==!0,Mt=at.__version===void 0||et===!0,wt=ht.dataReady,Gt=I(y,$t);ut(i.TEXTURE_CUBE_MAP,y);let yt;if(Ot){X&&Mt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Gt,se,$t.width,$t.height);for(let gt=0;gt<6;gt++){yt=At[gt].mipmaps;for(let qt=0;qt<yt.length;qt++){let oe=yt[qt];y.format!==mi?Yt!==null?X?wt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,qt,0,0,oe.width,oe.height,Yt,oe.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,qt,se,oe.width,oe.height,0,oe.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):X?wt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,qt,0,0,oe.width,oe.height,Yt,It,oe.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,qt,se,oe.width,oe.height,0,Yt,It,oe.data)}}}else{if(yt=y.mipmaps,X&&Mt){yt.length>0&&Gt++;let gt=ee(At[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Gt,se,gt.width,gt.height)}for(let gt=0;gt<6;gt++)if(mt){X?wt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,0,0,0,At[gt].width,At[gt].height,Yt,It,At[gt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,0,se,At[gt].width,At[gt].height,0,Yt,It,At[gt].data);for(let qt=0;qt<yt.length;qt++){let Ie=yt[qt].image[gt].image;X?wt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,qt+1,0,0,Ie.width,Ie.height,Yt,It,Ie.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,qt+1,se,Ie.width,Ie.height,0,Yt,It,Ie.data)}}else{X?wt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,0,0,0,Yt,It,At[gt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,0,se,Yt,It,At[gt]);for(let qt=0;qt<yt.length;qt++){let oe=yt[qt];X?wt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,qt+1,0,0,Yt,It,oe.image[gt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+gt,qt+1,se,Yt,It,oe.image[gt])}}}g(y)&&p(i.TEXTURE_CUBE_MAP),at.__version=ht.version,y.onUpdate&&y.onUpdate(y)}U.__version=y.version}function pt(U,y,z,et,ht,at){let Ht=r.convert(z.format,z.colorSpace),xt=r.convert(z.type),Vt=S(z.internalFormat,Ht,xt,z.colorSpace),Ot=n.get(y),mt=n.get(z);if(mt.__renderTarget=y,!Ot.__hasExternalTextures){let At=Math.max(1,y.width>>at),$t=Math.max(1,y.height>>at);ht===i.TEXTURE_3D||ht===i.TEXTURE_2D_ARRAY?e.texImage3D(ht,at,Vt,At,$t,y.depth,0,Ht,xt,null):e.texImage2D(ht,at,Vt,At,$t,0,Ht,xt,null)}e.bindFramebuffer(i.FRAMEBUFFER,U),_t(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,et,ht,mt.__webglTexture,0,Nt(y)):(ht===i.TEXTURE_2D||ht>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ht<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,et,ht,mt.__webglTexture,at),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Et(U,y,z){if(i.bindRenderbuffer(i.RENDERBUFFER,U),y.depthBuffer){let et=y.depthTexture,ht=et&&et.isDepthTexture?et.type:null,at=x(y.stencilBuffer,ht),Ht=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xt=Nt(y);_t(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,xt,at,y.width,y.height):z?i.renderbufferStorageMultisample(i.RENDERBUFFER,xt,at,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,at,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ht,i.RENDERBUFFER,U)}else{let et=y.textures;for(let ht=0;ht<et.length;ht++){let at=et[ht],Ht=r.convert(at.format,at.colorSpace),xt=r.convert(at.type),Vt=S(at.internalFormat,Ht,xt,at.colorSpace),Ot=Nt(y);z&&_t(y)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ot,Vt,y.width,y.height):_t(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ot,Vt,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,Vt,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function bt(U,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,U),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let et=n.get(y.depthTexture);et.__renderTarget=y,(!et.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),W(y.depthTexture,0);let ht=et.__webglTexture,at=Nt(y);if(y.depthTexture.format===mo)_t(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,ht,0,at):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,ht,0);else if(y.depthTexture.format===Ao)_t(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,ht,0,at):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,ht,0);else throw new Error("Unknown depthTexture format")}function ft(U){let y=n.get(U),z=U.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==U.depthTexture){let et=U.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),et){let ht=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,et.removeEventListener("dispose",ht)};et.addEventListener("dispose",ht),y.__depthDisposeCallback=ht}y.__boundDepthTexture=et}if(U.depthTexture&&!y.__autoAllocateDepthBuffer){if(z)throw new Error("target.depthTexture not supported in Cube render targets");let et=U.texture.mipmaps;et&&et.length>0?bt(y.__webglFramebuffer[0],U):bt(y.__webglFramebuffer,U)}else if(z){y.__webglDepthbuffer=[];for(let et=0;et<6;et++)if(e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[et]),y.__webglDepthbuffer[et]===void 0)y.__webglDepthbuffer[et]=i.createRenderbuffer(),Et(y.__webglDepthbuffer[et],U,!1);else{let ht=U.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,at=y.__webglDepthbuffer[et];i.bindRenderbuffer(i.RENDERBUFFER,at),i.framebufferRenderbuffer(i.FRAMEBUFFER,ht,i.RENDERBUFFER,at)}}else{let et=U.texture.mipmaps;if(et&&et.length>0?e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),Et(y.__webglDepthbuffer,U,!1);else{let ht=U.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,at=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,at),i.framebufferRenderbuffer(i.FRAMEBUFFER,ht,i.RENDERBUFFER,at)}}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Jt(U,y,z){let et=n.get(U);y!==void 0&&pt(et.__webglFramebuffer,U,U.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),z!==void 0&&ft(U)}function C(U){let y=U.texture,z=n.get(U),et=n.get(y);U.addEventListener("dispose",P);let ht=U.textures,at=U.isWebGLCubeRenderTarget===!0,Ht=ht.length>1;if(Ht||(et.__webglTexture===void 0&&(et.__webglTexture=i.createTexture()),et.__version=y.version,o.memory.textures++),at){z.__webglFramebuffer=[];for(let xt=0;xt<6;xt++)if(y.mipmaps&&y.mipmaps.length>0){z.__webglFramebuffer[xt]=[];for(let Vt=0;Vt<y.mipmaps.length;Vt++)z.__webglFramebuffer[xt][Vt]=i.createFramebuffer()}else z.__webglFramebuffer[xt]=i.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){z.__webglFramebuffer=[];for(let xt=0;xt<y.mipmaps.length;xt++)z.__webglFramebuffer[xt]=i.createFramebuffer()}else z.__webglFramebuffer=i.createFramebuffer();if(Ht)for(let xt=0,Vt=ht.length;xt<Vt;xt++){let Ot=n.get(ht[xt]);Ot.__webglTexture===void 0&&(Ot.__webglTexture=i.createTexture(),o.memory.textures++)}if(U.samples>0&&_t(U)===!1){z.__webglMultisampledFramebuffer=i.createFramebuffer(),z.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let xt=0;xt<ht.length;xt++){let Vt=ht[xt];z.__webglColorRenderbuffer[xt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,z.__webglColorRenderbuffer[xt]);let Ot=r.convert(Vt.format,Vt.colorSpace),mt=r.convert(Vt.type),At=S(Vt.internalFormat,Ot,mt,Vt.colorSpace,U.isXRRenderTarget===!0),$t=Nt(U);i.renderbufferStorageMultisample(i.RENDERBUFFER,$t,At,U.width,U.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+xt,i.RENDERBUFFER,z.__webglColorRenderbuffer[xt])}i.bindRenderbuffer(i.RENDERBUFFER,null),U.depthBuffer&&(z.__webglDepthRenderbuffer=i.createRenderbuffer(),Et(z.__webglDepthRenderbuffer,U,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(at){e.bindTexture(i.TEXTURE_CUBE_MAP,et.__webglTexture),ut(i.TEXTURE_CUBE_MAP,y);for(let xt=0;xt<6;xt++)if(y.mipmaps&&y.mipmaps.length>0)for(let Vt=0;Vt<y.mipmaps.length;Vt++)pt(z.__webglFramebuffer[xt][Vt],U,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,Vt);else pt(z.__webglFramebuffer[xt],U,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+xt,0);g(y)&&p(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(Ht){for(let xt=0,Vt=ht.length;xt<Vt;xt++){let Ot=ht[xt],mt=n.get(Ot),At=i.TEXTURE_2D;(U.isWebGL3DRenderTarget||U.isWebGLArrayRenderTarget)&&(At=U.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(At,mt.__webglTexture),ut(At,Ot),pt(z.__webglFramebuffer,U,Ot,i.COLOR_ATTACHMENT0+xt,At,0),g(Ot)&&p(At)}e.unbindTexture()}else{let xt=i.TEXTURE_2D;if((U.isWebGL3DRenderTarget||U.isWebGLArrayRenderTarget)&&(xt=U.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(xt,et.__webglTexture),ut(xt,y),y.mipmaps&&y.mipmaps.length>0)for(let Vt=0;Vt<y.mipmaps.length;Vt++)pt(z.__webglFramebuffer[Vt],U,y,i.COLOR_ATTACHMENT0,xt,Vt);else pt(z.__webglFramebuffer,U,y,i.COLOR_ATTACHMENT0,xt,0);g(y)&&p(xt),e.unbindTexture()}U.depthBuffer&&ft(U)}function Ct(U){let y=U.textures;for(let z=0,et=y.length;z<et;z++){let ht=y[z];if(g(ht)){let at=A(U),Ht=n.get(ht).__webglTexture;e.bindTexture(at,Ht),p(at),e.unbindTexture()}}}let it=[],j=[];function ct(U){if(U.samples>0){if(_t(U)===!1){let y=U.textures,z=U.width,et=U.height,ht=i.COLOR_BUFFER_BIT,at=U.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ht=n.get(U),xt=y.length>1;if(xt)for(let Ot=0;Ot<y.length;Ot++)e.bindFramebuffer(i.FRAMEBUFFER,Ht.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ot,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Ht.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ot,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Ht.__webglMultisampledFramebuffer);let Vt=U.texture.mipmaps;Vt&&Vt.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ht.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ht.__webglFramebuffer);for(let Ot=0;Ot<y.length;Ot++){if(U.resolveDepthBuffer&&(U.depthBuffer&&(ht|=i.DEPTH_BUFFER_BIT),U.stencilBuffer&&U.resolveStencilBuffer&&(ht|=i.STENCIL_BUFFER_BIT)),xt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ht.__webglColorRenderbuffer[Ot]);let mt=n.get(y[Ot]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,mt,0)}i.blitFramebuffer(0,0,z,et,0,0,z,et,ht,i.NEAREST),l===!0&&(it.length=0,j.length=0,it.push(i.COLOR_ATTACHMENT0+Ot),U.depthBuffer&&U.resolveDepthBuffer===!1&&(it.push(at),j.push(at),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,j)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,it))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),xt)for(let Ot=0;Ot<y.length;Ot++){e.bindFramebuffer(i.FRAMEBUFFER,Ht.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ot,i.RENDERBUFFER,Ht.__webglColorRenderbuffer[Ot]);let mt=n.get(y[Ot]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Ht.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ot,i.TEXTURE_2D,mt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ht.__webglMultisampledFramebuffer)}else if(U.depthBuffer&&U.resolveDepthBuffer===!1&&l){let y=U.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function Nt(U){return Math.min(s.maxSamples,U.samples)}function _t(U){let y=n.get(U);return U.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Dt(U){let y=o.render.frame;u.get(U)!==y&&(u.set(U,y),U.update())}function Zt(U,y){let z=U.colorSpace,et=U.format,ht=U.type;return U.isCompressedTexture===!0||U.isVideoTexture===!0||z!==fr&&z!==vs&&(ve.getTransfer(z)===Re?(et!==mi||ht!==Ni)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",z)),y}function ee(U){return typeof HTMLImageElement<"u"&&U instanceof HTMLImageElement?(c.width=U.naturalWidth||U.width,c.height=U.naturalHeight||U.height):typeof VideoFrame<"u"&&U instanceof VideoFrame?(c.width=U.displayWidth,c.height=U.displayHeight):(c.width=U.width,c.height=U.height),c}this.allocateTextureUnit=B,this.resetTextureUnits=O,this.setTexture2D=W,this.setTexture2DArray=Z,this.setTexture3D=k,this.setTextureCube=G,this.rebindTextures=Jt,this.setupRenderTarget=C,this.updateRenderTargetMipmap=Ct,this.updateMultisampleRenderTarget=ct,this.setupDepthRenderbuffer=ft,this.setupFrameBufferTexture=pt,this.useMultisampledRTT=_t}function V1(i,t){function e(n,s=vs){let r,o=ve.getTransfer(s);if(n===Ni)return i.UNSIGNED_BYTE;if(n===Xc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===qc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ff)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Of)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Uf)return i.BYTE;if(n===Nf)return i.SHORT;if(n===wo)return i.UNSIGNED_SHORT;if(n===Wc)return i.INT;if(n===Gs)return i.UNSIGNED_INT;if(n===Ji)return i.FLOAT;if(n===Eo)return i.HALF_FLOAT;if(n===Bf)return i.ALPHA;if(n===zf)return i.RGB;if(n===mi)return i.RGBA;if(n===mo)return i.DEPTH_COMPONENT;if(n===Ao)return i.DEPTH_STENCIL;if(n===kf)return i.RED;if(n===Yc)return i.RED_INTEGER;if(n===Hf)return i.RG;if(n===$c)return i.RG_INTEGER;if(n===Zc)return i.RGBA_INTEGER;if(n===Xa||n===qa||n===Ya||n===$a)if(o===Re)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Xa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Xa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===$a)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Jc||n===Kc||n===jc||n===Qc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Jc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Kc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Qc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===th||n===eh||n===nh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===th||n===eh)return o===Re?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===nh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===fh||n===dh||n===ph||n===mh||n===gh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===ih)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===sh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===rh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===oh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ah)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===lh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===ch)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===hh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===uh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===fh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===dh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ph)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===mh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===gh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===_h||n===vh||n===xh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===_h)return o===Re?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===xh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===yh||n===bh||n===Mh||n===Sh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===yh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===bh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Mh)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Sh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===To?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var G1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,W1=`
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

}`,hd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Aa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new ni({vertexShader:G1,fragmentShader:W1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new de(new Pa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ud=class extends Wi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,m=null,_=typeof XRWebGLBinding<"u",g=new hd,p={},A=e.getContextAttributes(),S=null,x=null,I=[],T=[],P=new Ft,L=null,M=new En;M.viewport=new Pe;let b=new En;b.viewport=new Pe;let E=[M,b],O=new Dc,B=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let V=I[K];return V===void 0&&(V=new xo,I[K]=V),V.getTargetRaySpace()},this.getControllerGrip=function(K){let V=I[K];return V===void 0&&(V=new xo,I[K]=V),V.getGripSpace()},this.getHand=function(K){let V=I[K];return V===void 0&&(V=new xo,I[K]=V),V.getHandSpace()};function W(K){let V=T.indexOf(K.inputSource);if(V===-1)return;let pt=I[V];pt!==void 0&&(pt.update(K.inputSource,K.frame,c||o),pt.dispatchEvent({type:K.type,data:K.inputSource}))}function Z(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",Z),s.removeEventListener("inputsourceschange",k);for(let K=0;K<I.length;K++){let V=T[K];V!==null&&(T[K]=null,I[K].disconnect(V))}B=null,H=null,g.reset();for(let K in p)delete p[K];t.setRenderTarget(S),d=null,f=null,h=null,s=null,x=null,Lt.stop(),n.isPresenting=!1,t.setPixelRatio(L),t.setSize(P.width,P.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",Z),s.addEventListener("inputsourceschange",k),A.xrCompatible!==!0&&await e.makeXRCompatible(),L=t.getPixelRatio(),t.getSize(P),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let pt=null,Et=null,bt=null;A.depth&&(bt=A.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,pt=A.stencil?Ao:mo,Et=A.stencil?To:Gs);let ft={colorFormat:e.RGBA8,depthFormat:bt,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(ft),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),x=new Xi(f.textureWidth,f.textureHeight,{format:mi,type:Ni,depthTexture:new Ta(f.textureWidth,f.textureHeight,Et,void 0,void 0,void 0,void 0,void 0,void 0,pt),stencilBuffer:A.stencil,colorSpace:t.outputColorSpace,samples:A.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let pt={antialias:A.antialias,alpha:!0,depth:A.depth,stencil:A.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,pt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),x=new Xi(d.framebufferWidth,d.framebufferHeight,{format:mi,type:Ni,colorSpace:t.outputColorSpace,stencilBuffer:A.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Lt.setContext(s),Lt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function k(K){for(let V=0;V<K.removed.length;V++){let pt=K.removed[V],Et=T.indexOf(pt);Et>=0&&(T[Et]=null,I[Et].disconnect(pt))}for(let V=0;V<K.added.length;V++){let pt=K.added[V],Et=T.indexOf(pt);if(Et===-1){for(let ft=0;ft<I.length;ft++)if(ft>=T.length){T.push(pt),Et=ft;break}else if(T[ft]===null){T[ft]=pt,Et=ft;break}if(Et===-1)break}let bt=I[Et];bt&&bt.connect(pt)}}let G=new F,tt=new F;function ot(K,V,pt){G.setFromMatrixPosition(V.matrixWorld),tt.setFromMatrixPosition(pt.matrixWorld);let Et=G.distanceTo(tt),bt=V.projectionMatrix.elements,ft=pt.projectionMatrix.elements,Jt=bt[14]/(bt[10]-1),C=bt[14]/(bt[10]+1),Ct=(bt[9]+1)/bt[5],it=(bt[9]-1)/bt[5],j=(bt[8]-1)/bt[0],ct=(ft[8]+1)/ft[0],Nt=Jt*j,_t=Jt*ct,Dt=Et/(-j+ct),Zt=Dt*-j;if(V.matrixWorld.decompose(K.position,K.quaternion,K.scale),K.translateX(Zt),K.translateZ(Dt),K.matrixWorld.compose(K.position,K.quaternion,K.scale),K.matrixWorldInverse.copy(K.matrixWorld).invert(),bt[10]===-1)K.projectionMatrix.copy(V.projectionMatrix),K.projectionMatrixInverse.copy(V.projectionMatrixInverse);else{let ee=Jt+Dt,U=C+Dt,y=Nt-Zt,z=_t+(Et-Zt),et=Ct*C/U*ee,ht=it*C/U*ee;K.projectionMatrix.makePerspective(y,z,et,ht,ee,U),K.projectionMatrixInverse.copy(K.projectionMatrix).invert()}}function rt(K,V){V===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(V.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let V=K.near,pt=K.far;g.texture!==null&&(g.depthNear>0&&(V=g.depthNear),g.depthFar>0&&(pt=g.depthFar)),O.near=b.near=M.near=V,O.far=b.far=M.far=pt,(B!==O.near||H!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),B=O.near,H=O.far),O.layers.mask=K.layers.mask|6,M.layers.mask=O.layers.mask&3,b.layers.mask=O.layers.mask&5;let Et=K.parent,bt=O.cameras;rt(O,Et);for(let ft=0;ft<bt.length;ft++)rt(bt[ft],Et);bt.length===2?ot(O,M,b):O.projectionMatrix.copy(M.projectionMatrix),ut(K,O,Et)};function ut(K,V,pt){pt===null?K.matrix.copy(V.matrixWorld):(K.matrix.copy(pt.matrixWorld),K.matrix.invert(),K.matrix.multiply(V.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(V.projectionMatrix),K.projectionMatrixInverse.copy(V.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=go*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(K){l=K,f!==null&&(f.fixedFoveation=K),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=K)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(O)},this.getCameraTexture=function(K){return p[K]};let lt=null;function Pt(K,V){if(u=V.getViewerPose(c||o),m=V,u!==null){let pt=u.views;d!==null&&(t.setRenderTargetFramebuffer(x,d.framebuffer),t.setRenderTarget(x));let Et=!1;pt.length!==O.cameras.length&&(O.cameras.length=0,Et=!0);for(let C=0;C<pt.length;C++){let Ct=pt[C],it=null;if(d!==null)it=d.getViewport(Ct);else{let ct=h.getViewSubImage(f,Ct);it=ct.viewport,C===0&&(t.setRenderTargetTextures(x,ct.colorTexture,ct.depthStencilTexture),t.setRenderTarget(x))}let j=E[C];j===void 0&&(j=new En,j.layers.enable(C),j.viewport=new Pe,E[C]=j),j.matrix.fromArray(Ct.transform.matrix),j.matrix.decompose(j.position,j.quaternion,j.scale),j.projectionMatrix.fromArray(Ct.projectionMatrix),j.projectionMatrixInverse.copy(j.projectionMatrix).invert(),j.viewport.set(it.x,it.y,it.width,it.height),C===0&&(O.matrix.copy(j.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),Et===!0&&O.cameras.push(j)}let bt=s.enabledFeatures;if(bt&&bt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=n.getBinding();let C=h.getDepthInformation(pt[0]);C&&C.isValid&&C.texture&&g.init(C,s.renderState)}if(bt&&bt.includes("camera-access")&&_){t.state.unbindTexture(),h=n.getBinding();for(let C=0;C<pt.length;C++){let Ct=pt[C].camera;if(Ct){let it=p[Ct];it||(it=new Aa,p[Ct]=it);let j=h.getCameraImage(Ct);it.sourceTexture=j}}}}for(let pt=0;pt<I.length;pt++){let Et=T[pt],bt=I[pt];Et!==null&&bt!==void 0&&bt.update(Et,V,c||o)}lt&&lt(K,V),V.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:V}),m=null}let Lt=new U0;Lt.setAnimationLoop(Pt),this.setAnimationLoop=function(K){lt=K},this.dispose=function(){}}},Sr=new Ui,X1=new De;function q1(i,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function n(g,p){p.color.getRGB(g.fogColor.value,Yf(i)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,A,S,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(g,p):p.isMeshToonMaterial?(r(g,p),h(g,p)):p.isMeshPhongMaterial?(r(g,p),u(g,p)):p.isMeshStandardMaterial?(r(g,p),f(g,p),p.isMeshPhysicalMaterial&&d(g,p,x)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),_(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,A,S):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===Bn&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===Bn&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let A=t.get(p),S=A.envMap,x=A.envMapRotation;S&&(g.envMap.value=S,Sr.copy(x),Sr.x*=-1,Sr.y*=-1,Sr.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(Sr.y*=-1,Sr.z*=-1),g.envMapRotation.value.setFromMatrix4(X1.makeRotationFromEuler(Sr)),g.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,A,S){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*A,g.scale.value=S*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function f(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function d(g,p,A){g.ior.value=p.ior,p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Bn&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=A.texture,g.transmissionSamplerSize.value.set(A.width,A.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function _(g,p){let A=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(A.matrixWorld),g.nearDistance.value=A.shadow.camera.near,g.farDistance.value=A.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Y1(i,t,e,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(A,S){let x=S.program;n.uniformBlockBinding(A,x)}function c(A,S){let x=s[A.id];x===void 0&&(m(A),x=u(A),s[A.id]=x,A.addEventListener("dispose",g));let I=S.program;n.updateUBOMapping(A,I);let T=t.render.frame;r[A.id]!==T&&(f(A),r[A.id]=T)}function u(A){let S=h();A.__bindingPointIndex=S;let x=i.createBuffer(),I=A.__size,T=A.usage;return i.bindBuffer(i.UNIFORM_BUFFER,x),i.bufferData(i.UNIFORM_BUFFER,I,T),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,x),x}function h(){for(let A=0;A<a;A++)if(o.indexOf(A)===-1)return o.push(A),A;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(A){let S=s[A.id],x=A.uniforms,I=A.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let T=0,P=x.length;T<P;T++){let L=Array.isArray(x[T])?x[T]:[x[T]];for(let M=0,b=L.length;M<b;M++){let E=L[M];if(d(E,T,M,I)===!0){let O=E.__offset,B=Array.isArray(E.value)?E.value:[E.value],H=0;for(let W=0;W<B.length;W++){let Z=B[W],k=_(Z);typeof Z=="number"||typeof Z=="boolean"?(E.__data[0]=Z,i.bufferSubData(i.UNIFORM_BUFFER,O+H,E.__data)):Z.isMatrix3?(E.__data[0]=Z.elements[0],E.__data[1]=Z.elements[1],E.__data[2]=Z.elements[2],E.__data[3]=0,E.__data[4]=Z.elements[3],E.__data[5]=Z.elements[4],E.__data[6]=Z.elements[5],E.__data[7]=0,E.__data[8]=Z.elements[6],E.__data[9]=Z.elements[7],E.__data[10]=Z.elements[8],E.__data[11]=0):(Z.toArray(E.__data,H),H+=k.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,O,E.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function d(A,S,x,I){let T=A.value,P=S+"_"+x;if(I[P]===void 0)return typeof T=="number"||typeof T=="boolean"?I[P]=T:I[P]=T.clone(),!0;{let L=I[P];if(typeof T=="number"||typeof T=="boolean"){if(L!==T)return I[P]=T,!0}else if(L.equals(T)===!1)return L.copy(T),!0}return!1}function m(A){let S=A.uniforms,x=0,I=16;for(let P=0,L=S.length;P<L;P++){let M=Array.isArray(S[P])?S[P]:[S[P]];for(let b=0,E=M.length;b<E;b++){let O=M[b],B=Array.isArray(O.value)?O.value:[O.value];for(let H=0,W=B.length;H<W;H++){let Z=B[H],k=_(Z),G=x%I,tt=G%k.boundary,ot=G+tt;x+=tt,ot!==0&&I-ot<k.storage&&(x+=I-ot),O.__data=new Float32Array(k.storage/Float32Array.BYTES_PER_ELEMENT),O.__offset=x,x+=k.storage}}}let T=x%I;return T>0&&(x+=I-T),A.__size=x,A.__cache={},this}function _(A){let S={boundary:0,storage:0};return typeof A=="number"||typeof A=="boolean"?(S.boundary=4,S.storage=4):A.isVector2?(S.boundary=8,S.storage=8):A.isVector3||A.isColor?(S.boundary=16,S.storage=12):A.isVector4?(S.boundary=16,S.storage=16):A.isMatrix3?(S.boundary=48,S.storage=48):A.isMatrix4?(S.boundary=64,S.storage=64):A.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",A),S}function g(A){let S=A.target;S.removeEventListener("dispose",g);let x=o.indexOf(S.__bindingPointIndex);o.splice(x,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function p(){for(let A in s)i.deleteBuffer(s[A]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}var Ch=class{constructor(t={}){let{canvas:e=o0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=n.getContextAttributes().alpha}else d=o;let m=new Uint32Array(4),_=new Int32Array(4),g=null,p=null,A=[],S=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=_s,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let x=this,I=!1;this._outputColorSpace=On;let T=0,P=0,L=null,M=-1,b=null,E=new Pe,O=new Pe,B=null,H=new he(0),W=0,Z=e.width,k=e.height,G=1,tt=null,ot=null,rt=new Pe(0,0,Z,k),ut=new Pe(0,0,Z,k),lt=!1,Pt=new Mo,Lt=!1,K=!1,V=new De,pt=new F,Et=new Pe,bt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ft=!1;function Jt(){return L===null?G:1}let C=n;function Ct(R,Y){return e.getContext(R,Y)}try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"180"}`),e.addEventListener("webglcontextlost",wt,!1),e.addEventListener("webglcontextrestored",Gt,!1),e.addEventListener("webglcontextcreationerror",yt,!1),C===null){let Y="webgl2";if(C=Ct(Y,R),C===null)throw Ct(Y)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(R){throw console.error("THREE.WebGLRenderer: "+R.message),R}let it,j,ct,Nt,_t,Dt,Zt,ee,U,y,z,et,ht,at,Ht,xt,Vt,Ot,mt,At,$t,Yt,It,se;function X(){it=new uw(C),it.init(),Yt=new V1(C,it),j=new sw(C,it,t,Yt),ct=new k1(C,it),j.reversedDepthBuffer&&f&&ct.buffers.depth.setReversed(!0),Nt=new pw(C),_t=new A1,Dt=new H1(C,it,ct,_t,j,Yt,Nt),Zt=new ow(x),ee=new hw(x),U=new yb(C),It=new nw(C,U),y=new fw(C,U,Nt,It),z=new gw(C,y,U,Nt),mt=new mw(C,j,Dt),xt=new rw(_t),et=new T1(x,Zt,ee,it,j,It,xt),ht=new q1(x,_t),at=new R1,Ht=new N1(it),Ot=new ew(x,Zt,ee,ct,z,d,l),Vt=new B1(x,z,j),se=new Y1(C,Nt,j,ct),At=new iw(C,it,Nt),$t=new dw(C,it,Nt),Nt.programs=et.programs,x.capabilities=j,x.extensions=it,x.properties=_t,x.renderLists=at,x.shadowMap=Vt,x.state=ct,x.info=Nt}X();let Mt=new ud(x,C);this.xr=Mt,this.getContext=function(){return C},this.getContextAttributes=function(){return C.getContextAttributes()},this.forceContextLoss=function(){let R=it.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=it.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return G},this.setPixelRatio=function(R){R!==void 0&&(G=R,this.setSize(Z,k,!1))},this.getSize=function(R){return R.set(Z,k)},this.setSize=function(R,Y,st=!0){if(Mt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Z=R,k=Y,e.width=Math.floor(R*G),e.height=Math.floor(Y*G),st===!0&&(e.style.width=R+"px",e.style.height=Y+"px"),this.setViewport(0,0,R,Y)},this.getDrawingBufferSize=function(R){return R.set(Z*G,k*G).floor()},this.setDrawingBufferSize=function(R,Y,st){Z=R,k=Y,G=st,e.width=Math.floor(R*st),e.height=Math.floor(Y*st),this.setViewport(0,0,R,Y)},this.getCurrentViewport=function(R){return R.copy(E)},this.getViewport=function(R){return R.copy(rt)},this.setViewport=function(R,Y,st,nt){R.isVector4?rt.set(R.x,R.y,R.z,R.w):rt.set(R,Y,st,nt),ct.viewport(E.copy(rt).multiplyScalar(G).round())},this.getScissor=function(R){return R.copy(ut)},this.setScissor=function(R,Y,st,nt){R.isVector4?ut.set(R.x,R.y,R.z,R.w):ut.set(R,Y,st,nt),ct.scissor(O.copy(ut).multiplyScalar(G).round())},this.getScissorTest=function(){return lt},this.setScissorTest=function(R){ct.setScissorTest(lt=R)},this.setOpaqueSort=function(R){tt=R},this.setTransparentSort=function(R){ot=R},this.getClearColor=function(R){return R.copy(Ot.getClearColor())},this.setClearColor=function(){Ot.setClearColor(...arguments)},this.getClearAlpha=function(){return Ot.getClearAlpha()},this.setClearAlpha=function(){Ot.setClearAlpha(...arguments)},this.clear=function(R=!0,Y=!0,st=!0){let nt=0;if(R){let J=!1;if(L!==null){let St=L.texture.format;J=St===Zc||St===$c||St===Yc}if(J){let St=L.texture.type,Ut=St===Ni||St===Gs||St===wo||St===To||St===Xc||St===qc,Wt=Ot.getClearColor(),Bt=Ot.getClearAlpha(),te=Wt.r,ne=Wt.g,Kt=Wt.b;Ut?(m[0]=te,m[1]=ne,m[2]=Kt,m[3]=Bt,C.clearBufferuiv(C.COLOR,0,m)):(_[0]=te,_[1]=ne,_[2]=Kt,_[3]=Bt,C.clearBufferiv(C.COLOR,0,_))}else nt|=C.COLOR_BUFFER_BIT}Y&&(nt|=C.DEPTH_BUFFER_BIT),st&&(nt|=C.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),C.clear(nt)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",wt,!1),e.removeEventListener("webglcontextrestored",Gt,!1),e.removeEventListener("webglcontextcreationerror",yt,!1),Ot.dispose(),at.dispose(),Ht.dispose(),_t.dispose(),Zt.dispose(),ee.dispose(),z.dispose(),It.dispose(),se.dispose(),et.dispose(),Mt.dispose(),Mt.removeEventListener("sessionstart",Ne),Mt.removeEventListener("sessionend",Yn),Hn.stop()};function wt(R){R.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),I=!0}function Gt(){console.log("THREE.WebGLRenderer: Context Restored."),I=!1;let R=Nt.autoReset,Y=Vt.enabled,st=Vt.autoUpdate,nt=Vt.needsUpdate,J=Vt.type;X(),Nt.autoReset=R,Vt.enabled=Y,Vt.autoUpdate=st,Vt.needsUpdate=nt,Vt.type=J}function yt(R){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function gt(R){let Y=R.target;Y.removeEventListener("dispose",gt),qt(Y)}function qt(R){oe(R),_t.remove(R)}function oe(R){let Y=_t.get(R).programs;Y!==void 0&&(Y.forEach(function(st){et.releaseProgram(st)}),R.isShaderMaterial&&et.releaseShaderCache(R))}this.renderBufferDirect=function(R,Y,st,nt,J,St){Y===null&&(Y=bt);let Ut=J.isMesh&&J.matrixWorld.determinant()<0,Wt=es(R,Y,st,nt,J);ct.setMaterial(nt,Ut);let Bt=st.index,te=1;if(nt.wireframe===!0){if(Bt=y.getWireframeAttribute(st),Bt===void 0)return;te=2}let ne=st.drawRange,Kt=st.attributes.position,ue=ne.start*te,ye=(ne.start+ne.count)*te;St!==null&&(ue=Math.max(ue,St.start*te),ye=Math.min(ye,(St.start+St.count)*te)),Bt!==null?(ue=Math.max(ue,0),ye=Math.min(ye,Bt.count)):Kt!=null&&(ue=Math.max(ue,0),ye=Math.min(ye,Kt.count));let Be=ye-ue;if(Be<0||Be===1/0)return;It.setup(J,nt,Wt,st,Bt);let Ae,le=At;if(Bt!==null&&(Ae=U.get(Bt),le=$t,le.setIndex(Ae)),J.isMesh)nt.wireframe===!0?(ct.setLineWidth(nt.wireframeLinewidth*Jt()),le.setMode(C.LINES)):le.setMode(C.TRIANGLES);else if(J.isLine){let Qt=nt.linewidth;Qt===void 0&&(Qt=1),ct.setLineWidth(Qt*Jt()),J.isLineSegments?le.setMode(C.LINES):J.isLineLoop?le.setMode(C.LINE_LOOP):le.setMode(C.LINE_STRIP)}else J.isPoints?le.setMode(C.POINTS):J.isSprite&&le.setMode(C.TRIANGLES);if(J.isBatchedMesh)if(J._multiDrawInstances!==null)_o("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),le.renderMultiDrawInstances(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount,J._multiDrawInstances);else if(it.get("WEBGL_multi_draw"))le.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Qt=J._multiDrawStarts,ze=J._multiDrawCounts,me=J._multiDrawCount,Mn=Bt?U.get(Bt).bytesPerElement:1,xs=_t.get(nt).currentProgram.getUniforms();for(let Rn=0;Rn<me;Rn++)xs.setValue(C,"_gl_DrawID",Rn),le.render(Qt[Rn]/Mn,ze[Rn])}else if(J.isInstancedMesh)le.renderInstances(ue,Be,J.count);else if(st.isInstancedBufferGeometry){let Qt=st._maxInstanceCount!==void 0?st._maxInstanceCount:1/0,ze=Math.min(st.instanceCount,Qt);le.renderInstances(ue,Be,ze)}else le.render(ue,Be)};function Ie(R,Y,st){R.transparent===!0&&R.side===zn&&R.forceSinglePass===!1?(R.side=Bn,R.needsUpdate=!0,qs(R,Y,st),R.side=ps,R.needsUpdate=!0,qs(R,Y,st),R.side=zn):qs(R,Y,st)}this.compile=function(R,Y,st=null){st===null&&(st=R),p=Ht.get(st),p.init(Y),S.push(p),st.traverseVisible(function(J){J.isLight&&J.layers.test(Y.layers)&&(p.pushLight(J),J.castShadow&&p.pushShadow(J))}),R!==st&&R.traverseVisible(function(J){J.isLight&&J.layers.test(Y.layers)&&(p.pushLight(J),J.castShadow&&p.pushShadow(J))}),p.setupLights();let nt=new Set;return R.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let St=J.material;if(St)if(Array.isArray(St))for(let Ut=0;Ut<St.length;Ut++){let Wt=St[Ut];Ie(Wt,st,J),nt.add(Wt)}else Ie(St,st,J),nt.add(St)}),p=S.pop(),nt},this.compileAsync=function(R,Y,st=null){let nt=this.compile(R,Y,st);return new Promise(J=>{function St(){if(nt.forEach(function(Ut){_t.get(Ut).currentProgram.isReady()&&nt.delete(Ut)}),nt.size===0){J(R);return}setTimeout(St,10)}it.get("KHR_parallel_shader_compile")!==null?St():setTimeout(St,10)})};let xe=null;function gn(R){xe&&xe(R)}function Ne(){Hn.stop()}function Yn(){Hn.start()}let Hn=new U0;Hn.setAnimationLoop(gn),typeof self<"u"&&Hn.setContext(self),this.setAnimationLoop=function(R){xe=R,Mt.setAnimationLoop(R),R===null?Hn.stop():Hn.start()},Mt.addEventListener("sessionstart",Ne),Mt.addEventListener("sessionend",Yn),this.render=function(R,Y){if(Y!==void 0&&Y.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),Y.parent===null&&Y.matrixWorldAutoUpdate===!0&&Y.updateMatrixWorld(),Mt.enabled===!0&&Mt.isPresenting===!0&&(Mt.cameraAutoUpdate===!0&&Mt.updateCamera(Y),Y=Mt.getCamera()),R.isScene===!0&&R.onBeforeRender(x,R,Y,L),p=Ht.get(R,S.length),p.init(Y),S.push(p),V.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),Pt.setFromProjectionMatrix(V,Ii,Y.reversedDepth),K=this.localClippingEnabled,Lt=xt.init(this.clippingPlanes,K),g=at.get(R,A.length),g.init(),A.push(g),Mt.enabled===!0&&Mt.isPresenting===!0){let St=x.xr.getDepthSensingMesh();St!==null&&Fi(St,Y,-1/0,x.sortObjects)}Fi(R,Y,0,x.sortObjects),g.finish(),x.sortObjects===!0&&g.sort(tt,ot),ft=Mt.enabled===!1||Mt.isPresenting===!1||Mt.hasDepthSensing()===!1,ft&&Ot.addToRenderList(g,R),this.info.render.frame++,Lt===!0&&xt.beginShadows();let st=p.state.shadowsArray;Vt.render(st,R,Y),Lt===!0&&xt.endShadows(),this.info.autoReset===!0&&this.info.reset();let nt=g.opaque,J=g.transmissive;if(p.setupLights(),Y.isArrayCamera){let St=Y.cameras;if(J.length>0)for(let Ut=0,Wt=St.length;Ut<Wt;Ut++){let Bt=St[Ut];ts(nt,J,R,Bt)}ft&&Ot.render(R);for(let Ut=0,Wt=St.length;Ut<Wt;Ut++){let Bt=St[Ut];Cn(g,R,Bt,Bt.viewport)}}else J.length>0&&ts(nt,J,R,Y),ft&&Ot.render(R),Cn(g,R,Y);L!==null&&P===0&&(Dt.updateMultisampleRenderTarget(L),Dt.updateRenderTargetMipmap(L)),R.isScene===!0&&R.onAfterRender(x,R,Y),It.resetDefaultState(),M=-1,b=null,S.pop(),S.length>0?(p=S[S.length-1],Lt===!0&&xt.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,A.pop(),A.length>0?g=A[A.length-1]:g=null};function Fi(R,Y,st,nt){if(R.visible===!1)return;if(R.layers.test(Y.layers)){if(R.isGroup)st=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(Y);else if(R.isLight)p.pushLight(R),R.castShadow&&p.pushShadow(R);else if(R.isSprite){if(!R.frustumCulled||Pt.intersectsSprite(R)){nt&&Et.setFromMatrixPosition(R.matrixWorld).applyMatrix4(V);let Ut=z.update(R),Wt=R.material;Wt.visible&&g.push(R,Ut,Wt,st,Et.z,null)}}else if((R.isMesh||R.isLine||R.isPoints)&&(!R.frustumCulled||Pt.intersectsObject(R))){let Ut=z.update(R),Wt=R.material;if(nt&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Et.copy(R.boundingSphere.center)):(Ut.boundingSphere===null&&Ut.computeBoundingSphere(),Et.copy(Ut.boundingSphere.center)),Et.applyMatrix4(R.matrixWorld).applyMatrix4(V)),Array.isArray(Wt)){let Bt=Ut.groups;for(let te=0,ne=Bt.length;te<ne;te++){let Kt=Bt[te],ue=Wt[Kt.materialIndex];ue&&ue.visible&&g.push(R,Ut,ue,st,Et.z,Kt)}}else Wt.visible&&g.push(R,Ut,Wt,st,Et.z,null)}}let St=R.children;for(let Ut=0,Wt=St.length;Ut<Wt;Ut++)Fi(St[Ut],Y,st,nt)}function Cn(R,Y,st,nt){let J=R.opaque,St=R.transmissive,Ut=R.transparent;p.setupLightsView(st),Lt===!0&&xt.setGlobalState(x.clippingPlanes,st),nt&&ct.viewport(E.copy(nt)),J.length>0&&_i(J,Y,st),St.length>0&&_i(St,Y,st),Ut.length>0&&_i(Ut,Y,st),ct.buffers.depth.setTest(!0),ct.buffers.depth.setMask(!0),ct.buffers.color.setMask(!0),ct.setPolygonOffset(!1)}function ts(R,Y,st,nt){if((st.isScene===!0?st.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[nt.id]===void 0&&(p.state.transmissionRenderTarget[nt.id]=new Xi(1,1,{generateMipmaps:!0,type:it.has("EXT_color_buffer_half_float")||it.has("EXT_color_buffer_float")?Eo:Ni,minFilter:Vs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ve.workingColorSpace}));let St=p.state.transmissionRenderTarget[nt.id],Ut=nt.viewport||E;St.setSize(Ut.z*x.transmissionResolutionScale,Ut.w*x.transmissionResolutionScale);let Wt=x.getRenderTarget(),Bt=x.getActiveCubeFace(),te=x.getActiveMipmapLevel();x.setRenderTarget(St),x.getClearColor(H),W=x.getClearAlpha(),W<1&&x.setClearColor(16777215,.5),x.clear(),ft&&Ot.render(st);let ne=x.toneMapping;x.toneMapping=_s;let Kt=nt.viewport;if(nt.viewport!==void 0&&(nt.viewport=void 0),p.setupLightsView(nt),Lt===!0&&xt.setGlobalState(x.clippingPlanes,nt),_i(R,st,nt),Dt.updateMultisampleRenderTarget(St),Dt.updateRenderTargetMipmap(St),it.has("WEBGL_multisampled_render_to_texture")===!1){let ue=!1;for(let ye=0,Be=Y.length;ye<Be;ye++){let Ae=Y[ye],le=Ae.object,Qt=Ae.geometry,ze=Ae.material,me=Ae.group;if(ze.side===zn&&le.layers.test(nt.layers)){let Mn=ze.side;ze.side=Bn,ze.needsUpdate=!0,No(le,st,nt,Qt,ze,me),ze.side=Mn,ze.needsUpdate=!0,ue=!0}}ue===!0&&(Dt.updateMultisampleRenderTarget(St),Dt.updateRenderTargetMipmap(St))}x.setRenderTarget(Wt,Bt,te),x.setClearColor(H,W),Kt!==void 0&&(nt.viewport=Kt),x.toneMapping=ne}function _i(R,Y,st){let nt=Y.isScene===!0?Y.overrideMaterial:null;for(let J=0,St=R.length;J<St;J++){let Ut=R[J],Wt=Ut.object,Bt=Ut.geometry,te=Ut.group,ne=Ut.material;ne.allowOverride===!0&&nt!==null&&(ne=nt),Wt.layers.test(st.layers)&&No(Wt,Y,st,Bt,ne,te)}}function No(R,Y,st,nt,J,St){R.onBeforeRender(x,Y,st,nt,J,St),R.modelViewMatrix.multiplyMatrices(st.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),J.onBeforeRender(x,Y,st,nt,R,St),J.transparent===!0&&J.side===zn&&J.forceSinglePass===!1?(J.side=Bn,J.needsUpdate=!0,x.renderBufferDirect(st,Y,nt,J,R,St),J.side=ps,J.needsUpdate=!0,x.renderBufferDirect(st,Y,nt,J,R,St),J.side=zn):x.renderBufferDirect(st,Y,nt,J,R,St),R.onAfterRender(x,Y,st,nt,J,St)}function qs(R,Y,st){Y.isScene!==!0&&(Y=bt);let nt=_t.get(R),J=p.state.lights,St=p.state.shadowsArray,Ut=J.state.version,Wt=et.getParameters(R,J.state,St,Y,st),Bt=et.getProgramCacheKey(Wt),te=nt.programs;nt.environment=R.isMeshStandardMaterial?Y.environment:null,nt.fog=Y.fog,nt.envMap=(R.isMeshStandardMaterial?ee:Zt).get(R.envMap||nt.environment),nt.envMapRotation=nt.environment!==null&&R.envMap===null?Y.environmentRotation:R.envMapRotation,te===void 0&&(R.addEventListener("dispose",gt),te=new Map,nt.programs=te);let ne=te.get(Bt);if(ne!==void 0){if(nt.currentProgram===ne&&nt.lightsStateVersion===Ut)return il(R,Wt),ne}else Wt.uniforms=et.getUniforms(R),R.onBeforeCompile(Wt,x),ne=et.acquireProgram(Wt,Bt),te.set(Bt,ne),nt.uniforms=Wt.uniforms;let Kt=nt.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Kt.clippingPlanes=xt.uniform),il(R,Wt),nt.needsLights=Ys(R),nt.lightsStateVersion=Ut,nt.needsLights&&(Kt.ambientLightColor.value=J.state.ambient,Kt.lightProbe.value=J.state.probe,Kt.directionalLights.value=J.state.directional,Kt.directionalLightShadows.value=J.state.directionalShadow,Kt.spotLights.value=J.state.spot,Kt.spotLightShadows.value=J.state.spotShadow,Kt.rectAreaLights.value=J.state.rectArea,Kt.ltc_1.value=J.state.rectAreaLTC1,Kt.ltc_2.value=J.state.rectAreaLTC2,Kt.pointLights.value=J.state.point,Kt.pointLightShadows.value=J.state.pointShadow,Kt.hemisphereLights.value=J.state.hemi,Kt.directionalShadowMap.value=J.state.directionalShadowMap,Kt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Kt.spotShadowMap.value=J.state.spotShadowMap,Kt.spotLightMatrix.value=J.state.spotLightMatrix,Kt.spotLightMap.value=J.state.spotLightMap,Kt.pointShadowMap.value=J.state.pointShadowMap,Kt.pointShadowMatrix.value=J.state.pointShadowMatrix),nt.currentProgram=ne,nt.uniformsList=null,ne}function nl(R){if(R.uniformsList===null){let Y=R.currentProgram.getUniforms();R.uniformsList=Po.seqWithValue(Y.seq,R.uniforms)}return R.uniformsList}function il(R,Y){let st=_t.get(R);st.outputColorSpace=Y.outputColorSpace,st.batching=Y.batching,st.batchingColor=Y.batchingColor,st.instancing=Y.instancing,st.instancingColor=Y.instancingColor,st.instancingMorph=Y.instancingMorph,st.skinning=Y.skinning,st.morphTargets=Y.morphTargets,st.morphNormals=Y.morphNormals,st.morphColors=Y.morphColors,st.morphTargetsCount=Y.morphTargetsCount,st.numClippingPlanes=Y.numClippingPlanes,st.numIntersection=Y.numClipIntersection,st.vertexAlphas=Y.vertexAlphas,st.vertexTangents=Y.vertexTangents,st.toneMapping=Y.toneMapping}function es(R,Y,st,nt,J){Y.isScene!==!0&&(Y=bt),Dt.resetTextureUnits();let St=Y.fog,Ut=nt.isMeshStandardMaterial?Y.environment:null,Wt=L===null?x.outputColorSpace:L.isXRRenderTarget===!0?L.texture.colorSpace:fr,Bt=(nt.isMeshStandardMaterial?ee:Zt).get(nt.envMap||Ut),te=nt.vertexColors===!0&&!!st.attributes.color&&st.attributes.color.itemSize===4,ne=!!st.attributes.tangent&&(!!nt.normalMap||nt.anisotropy>0),Kt=!!st.morphAttributes.position,ue=!!st.morphAttributes.normal,ye=!!st.morphAttributes.color,Be=_s;nt.toneMapped&&(L===null||L.isXRRenderTarget===!0)&&(Be=x.toneMapping);let Ae=st.morphAttributes.position||st.morphAttributes.normal||st.morphAttributes.color,le=Ae!==void 0?Ae.length:0,Qt=_t.get(nt),ze=p.state.lights;if(Lt===!0&&(K===!0||R!==b)){let cn=R===b&&nt.id===M;xt.setState(nt,R,cn)}let me=!1;nt.version===Qt.__version?(Qt.needsLights&&Qt.lightsStateVersion!==ze.state.version||Qt.outputColorSpace!==Wt||J.isBatchedMesh&&Qt.batching===!1||!J.isBatchedMesh&&Qt.batching===!0||J.isBatchedMesh&&Qt.batchingColor===!0&&J.colorTexture===null||J.isBatchedMesh&&Qt.batchingColor===!1&&J.colorTexture!==null||J.isInstancedMesh&&Qt.instancing===!1||!J.isInstancedMesh&&Qt.instancing===!0||J.isSkinnedMesh&&Qt.skinning===!1||!J.isSkinnedMesh&&Qt.skinning===!0||J.isInstancedMesh&&Qt.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Qt.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Qt.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Qt.instancingMorph===!1&&J.morphTexture!==null||Qt.envMap!==Bt||nt.fog===!0&&Qt.fog!==St||Qt.numClippingPlanes!==void 0&&(Qt.numClippingPlanes!==xt.numPlanes||Qt.numIntersection!==xt.numIntersection)||Qt.vertexAlphas!==te||Qt.vertexTangents!==ne||Qt.morphTargets!==Kt||Qt.morphNormals!==ue||Qt.morphColors!==ye||Qt.toneMapping!==Be||Qt.morphTargetsCount!==le)&&(me=!0):(me=!0,Qt.__version=nt.version);let Mn=Qt.currentProgram;me===!0&&(Mn=qs(nt,Y,J));let xs=!1,Rn=!1,$s=!1,ke=Mn.getUniforms(),Pn=Qt.uniforms;if(ct.useProgram(Mn.program)&&(xs=!0,Rn=!0,$s=!0),nt.id!==M&&(M=nt.id,Rn=!0),xs||b!==R){ct.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),ke.setValue(C,"projectionMatrix",R.projectionMatrix),ke.setValue(C,"viewMatrix",R.matrixWorldInverse);let hn=ke.map.cameraPosition;hn!==void 0&&hn.setValue(C,pt.setFromMatrixPosition(R.matrixWorld)),j.logarithmicDepthBuffer&&ke.setValue(C,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(nt.isMeshPhongMaterial||nt.isMeshToonMaterial||nt.isMeshLambertMaterial||nt.isMeshBasicMaterial||nt.isMeshStandardMaterial||nt.isShaderMaterial)&&ke.setValue(C,"isOrthographic",R.isOrthographicCamera===!0),b!==R&&(b=R,Rn=!0,$s=!0)}if(J.isSkinnedMesh){ke.setOptional(C,J,"bindMatrix"),ke.setOptional(C,J,"bindMatrixInverse");let cn=J.skeleton;cn&&(cn.boneTexture===null&&cn.computeBoneTexture(),ke.setValue(C,"boneTexture",cn.boneTexture,Dt))}J.isBatchedMesh&&(ke.setOptional(C,J,"batchingTexture"),ke.setValue(C,"batchingTexture",J._matricesTexture,Dt),ke.setOptional(C,J,"batchingIdTexture"),ke.setValue(C,"batchingIdTexture",J._indirectTexture,Dt),ke.setOptional(C,J,"batchingColorTexture"),J._colorsTexture!==null&&ke.setValue(C,"batchingColorTexture",J._colorsTexture,Dt));let Vn=st.morphAttributes;if((Vn.position!==void 0||Vn.normal!==void 0||Vn.color!==void 0)&&mt.update(J,st,Mn),(Rn||Qt.receiveShadow!==J.receiveShadow)&&(Qt.receiveShadow=J.receiveShadow,ke.setValue(C,"receiveShadow",J.receiveShadow)),nt.isMeshGouraudMaterial&&nt.envMap!==null&&(Pn.envMap.value=Bt,Pn.flipEnvMap.value=Bt.isCubeTexture&&Bt.isRenderTargetTexture===!1?-1:1),nt.isMeshStandardMaterial&&nt.envMap===null&&Y.environment!==null&&(Pn.envMapIntensity.value=Y.environmentIntensity),Rn&&(ke.setValue(C,"toneMappingExposure",x.toneMappingExposure),Qt.needsLights&&Wh(Pn,$s),St&&nt.fog===!0&&ht.refreshFogUniforms(Pn,St),ht.refreshMaterialUniforms(Pn,nt,G,k,p.state.transmissionRenderTarget[R.id]),Po.upload(C,nl(Qt),Pn,Dt)),nt.isShaderMaterial&&nt.uniformsNeedUpdate===!0&&(Po.upload(C,nl(Qt),Pn,Dt),nt.uniformsNeedUpdate=!1),nt.isSpriteMaterial&&ke.setValue(C,"center",J.center),ke.setValue(C,"modelViewMatrix",J.modelViewMatrix),ke.setValue(C,"normalMatrix",J.normalMatrix),ke.setValue(C,"modelMatrix",J.matrixWorld),nt.isShaderMaterial||nt.isRawShaderMaterial){let cn=nt.uniformsGroups;for(let hn=0,ys=cn.length;hn<ys;hn++){let oi=cn[hn];se.update(oi,Mn),se.bind(oi,Mn)}}return Mn}function Wh(R,Y){R.ambientLightColor.needsUpdate=Y,R.lightProbe.needsUpdate=Y,R.directionalLights.needsUpdate=Y,R.directionalLightShadows.needsUpdate=Y,R.pointLights.needsUpdate=Y,R.pointLightShadows.needsUpdate=Y,R.spotLights.needsUpdate=Y,R.spotLightShadows.needsUpdate=Y,R.rectAreaLights.needsUpdate=Y,R.hemisphereLights.needsUpdate=Y}function Ys(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return T},this.getActiveMipmapLevel=function(){return P},this.getRenderTarget=function(){return L},this.setRenderTargetTextures=function(R,Y,st){let nt=_t.get(R);nt.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,nt.__autoAllocateDepthBuffer===!1&&(nt.__useRenderToTexture=!1),_t.get(R.texture).__webglTexture=Y,_t.get(R.depthTexture).__webglTexture=nt.__autoAllocateDepthBuffer?void 0:st,nt.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,Y){let st=_t.get(R);st.__webglFramebuffer=Y,st.__useDefaultFramebuffer=Y===void 0};let sl=C.createFramebuffer();this.setRenderTarget=function(R,Y=0,st=0){L=R,T=Y,P=st;let nt=!0,J=null,St=!1,Ut=!1;if(R){let Bt=_t.get(R);if(Bt.__useDefaultFramebuffer!==void 0)ct.bindFramebuffer(C.FRAMEBUFFER,null),nt=!1;else if(Bt.__webglFramebuffer===void 0)Dt.setupRenderTarget(R);else if(Bt.__hasExternalTextures)Dt.rebindTextures(R,_t.get(R.texture).__webglTexture,_t.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Kt=R.depthTexture;if(Bt.__boundDepthTexture!==Kt){if(Kt!==null&&_t.has(Kt)&&(R.width!==Kt.image.width||R.height!==Kt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Dt.setupDepthRenderbuffer(R)}}let te=R.texture;(te.isData3DTexture||te.isDataArrayTexture||te.isCompressedArrayTexture)&&(Ut=!0);let ne=_t.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(ne[Y])?J=ne[Y][st]:J=ne[Y],St=!0):R.samples>0&&Dt.useMultisampledRTT(R)===!1?J=_t.get(R).__webglMultisampledFramebuffer:Array.isArray(ne)?J=ne[st]:J=ne,E.copy(R.viewport),O.copy(R.scissor),B=R.scissorTest}else E.copy(rt).multiplyScalar(G).floor(),O.copy(ut).multiplyScalar(G).floor(),B=lt;if(st!==0&&(J=sl),ct.bindFramebuffer(C.FRAMEBUFFER,J)&&nt&&ct.drawBuffers(R,J),ct.viewport(E),ct.scissor(O),ct.setScissorTest(B),St){let Bt=_t.get(R.texture);C.framebufferTexture2D(C.FRAMEBUFFER,C.COLOR_ATTACHMENT0,C.TEXTURE_CUBE_MAP_POSITIVE_X+Y,Bt.__webglTexture,st)}else if(Ut){let Bt=Y;for(let te=0;te<R.textures.length;te++){let ne=_t.get(R.textures[te]);C.framebufferTextureLayer(C.FRAMEBUFFER,C.COLOR_ATTACHMENT0+te,ne.__webglTexture,st,Bt)}}else if(R!==null&&st!==0){let Bt=_t.get(R.texture);C.framebufferTexture2D(C.FRAMEBUFFER,C.COLOR_ATTACHMENT0,C.TEXTURE_2D,Bt.__webglTexture,st)}M=-1},this.readRenderTargetPixels=function(R,Y,st,nt,J,St,Ut,Wt=0){if(!(R&&R.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Bt=_t.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ut!==void 0&&(Bt=Bt[Ut]),Bt){ct.bindFramebuffer(C.FRAMEBUFFER,Bt);try{let te=R.textures[Wt],ne=te.format,Kt=te.type;if(!j.textureFormatReadable(ne)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!j.textureTypeReadable(Kt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}Y>=0&&Y<=R.width-nt&&st>=0&&st<=R.height-J&&(R.textures.length>1&&C.readBuffer(C.COLOR_ATTACHMENT0+Wt),C.readPixels(Y,st,nt,J,Yt.convert(ne),Yt.convert(Kt),St))}finally{let te=L!==null?_t.get(L).__webglFramebuffer:null;ct.bindFramebuffer(C.FRAMEBUFFER,te)}}},this.readRenderTargetPixelsAsync=async function(R,Y,st,nt,J,St,Ut,Wt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Bt=_t.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ut!==void 0&&(Bt=Bt[Ut]),Bt)if(Y>=0&&Y<=R.width-nt&&st>=0&&st<=R.height-J){ct.bindFramebuffer(C.FRAMEBUFFER,Bt);let te=R.textures[Wt],ne=te.format,Kt=te.type;if(!j.textureFormatReadable(ne))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!j.textureTypeReadable(Kt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ue=C.createBuffer();C.bindBuffer(C.PIXEL_PACK_BUFFER,ue),C.bufferData(C.PIXEL_PACK_BUFFER,St.byteLength,C.STREAM_READ),R.textures.length>1&&C.readBuffer(C.COLOR_ATTACHMENT0+Wt),C.readPixels(Y,st,nt,J,Yt.convert(ne),Yt.convert(Kt),0);let ye=L!==null?_t.get(L).__webglFramebuffer:null;ct.bindFramebuffer(C.FRAMEBUFFER,ye);let Be=C.fenceSync(C.SYNC_GPU_COMMANDS_COMPLETE,0);return C.flush(),await a0(C,Be,4),C.bindBuffer(C.PIXEL_PACK_BUFFER,ue),C.getBufferSubData(C.PIXEL_PACK_BUFFER,0,St),C.deleteBuffer(ue),C.deleteSync(Be),St}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,Y=null,st=0){let nt=Math.pow(2,-st),J=Math.floor(R.image.width*nt),St=Math.floor(R.image.height*nt),Ut=Y!==null?Y.x:0,Wt=Y!==null?Y.y:0;Dt.setTexture2D(R,0),C.copyTexSubImage2D(C.TEXTURE_2D,st,0,0,Ut,Wt,J,St),ct.unbindTexture()};let Oi=C.createFramebuffer(),en=C.createFramebuffer();this.copyTextureToTexture=function(R,Y,st=null,nt=null,J=0,St=null){St===null&&(J!==0?(_o("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),St=J,J=0):St=0);let Ut,Wt,Bt,te,ne,Kt,ue,ye,Be,Ae=R.isCompressedTexture?R.mipmaps[St]:R.image;if(st!==null)Ut=st.max.x-st.min.x,Wt=st.max.y-st.min.y,Bt=st.isBox3?st.max.z-st.min.z:1,te=st.min.x,ne=st.min.y,Kt=st.isBox3?st.min.z:0;else{let Vn=Math.pow(2,-J);Ut=Math.floor(Ae.width*Vn),Wt=Math.floor(Ae.height*Vn),R.isDataArrayTexture?Bt=Ae.depth:R.isData3DTexture?Bt=Math.floor(Ae.depth*Vn):Bt=1,te=0,ne=0,Kt=0}nt!==null?(ue=nt.x,ye=nt.y,Be=nt.z):(ue=0,ye=0,Be=0);let le=Yt.convert(Y.format),Qt=Yt.convert(Y.type),ze;Y.isData3DTexture?(Dt.setTexture3D(Y,0),ze=C.TEXTURE_3D):Y.isDataArrayTexture||Y.isCompressedArrayTexture?(Dt.setTexture2DArray(Y,0),ze=C.TEXTURE_2D_ARRAY):(Dt.setTexture2D(Y,0),ze=C.TEXTURE_2D),C.pixelStorei(C.UNPACK_FLIP_Y_WEBGL,Y.flipY),C.pixelStorei(C.UNPACK_PREMULTIPLY_ALPHA_WEBGL,Y.premultiplyAlpha),C.pixelStorei(C.UNPACK_ALIGNMENT,Y.unpackAlignment);let me=C.getParameter(C.UNPACK_ROW_LENGTH),Mn=C.getParameter(C.UNPACK_IMAGE_HEIGHT),xs=C.getParameter(C.UNPACK_SKIP_PIXELS),Rn=C.getParameter(C.UNPACK_SKIP_ROWS),$s=C.getParameter(C.UNPACK_SKIP_IMAGES);C.pixelStorei(C.UNPACK_ROW_LENGTH,Ae.width),C.pixelStorei(C.UNPACK_IMAGE_HEIGHT,Ae.height),C.pixelStorei(C.UNPACK_SKIP_PIXELS,te),C.pixelStorei(C.UNPACK_SKIP_ROWS,ne),C.pixelStorei(C.UNPACK_SKIP_IMAGES,Kt);let ke=R.isDataArrayTexture||R.isData3DTexture,Pn=Y.isDataArrayTexture||Y.isData3DTexture;if(R.isDepthTexture){let Vn=_t.get(R),cn=_t.get(Y),hn=_t.get(Vn.__renderTarget),ys=_t.get(cn.__renderTarget);ct.bindFramebuffer(C.READ_FRAMEBUFFER,hn.__webglFramebuffer),ct.bindFramebuffer(C.DRAW_FRAMEBUFFER,ys.__webglFramebuffer);for(let oi=0;oi<Bt;oi++)ke&&(C.framebufferTextureLayer(C.READ_FRAMEBUFFER,C.COLOR_ATTACHMENT0,_t.get(R).__webglTexture,J,Kt+oi),C.framebufferTextureLayer(C.DRAW_FRAMEBUFFER,C.COLOR_ATTACHMENT0,_t.get(Y).__webglTexture,St,Be+oi)),C.blitFramebuffer(te,ne,Ut,Wt,ue,ye,Ut,Wt,C.DEPTH_BUFFER_BIT,C.NEAREST);ct.bindFramebuffer(C.READ_FRAMEBUFFER,null),ct.bindFramebuffer(C.DRAW_FRAMEBUFFER,null)}else if(J!==0||R.isRenderTargetTexture||_t.has(R)){let Vn=_t.get(R),cn=_t.get(Y);ct.bindFramebuffer(C.READ_FRAMEBUFFER,Oi),ct.bindFramebuffer(C.DRAW_FRAMEBUFFER,en);for(let hn=0;hn<Bt;hn++)ke?C.framebufferTextureLayer(C.READ_FRAMEBUFFER,C.COLOR_ATTACHMENT0,Vn.__webglTexture,J,Kt+hn):C.framebufferTexture2D(C.READ_FRAMEBUFFER,C.COLOR_ATTACHMENT0,C.TEXTURE_2D,Vn.__webglTexture,J),Pn?C.framebufferTextureLayer(C.DRAW_FRAMEBUFFER,C.COLOR_ATTACHMENT0,cn.__webglTexture,St,Be+hn):C.framebufferTexture2D(C.DRAW_FRAMEBUFFER,C.COLOR_ATTACHMENT0,C.TEXTURE_2D,cn.__webglTexture,St),J!==0?C.blitFramebuffer(te,ne,Ut,Wt,ue,ye,Ut,Wt,C.COLOR_BUFFER_BIT,C.NEAREST):Pn?C.copyTexSubImage3D(ze,St,ue,ye,Be+hn,te,ne,Ut,Wt):C.copyTexSubImage2D(ze,St,ue,ye,te,ne,Ut,Wt);ct.bindFramebuffer(C.READ_FRAMEBUFFER,null),ct.bindFramebuffer(C.DRAW_FRAMEBUFFER,null)}else Pn?R.isDataTexture||R.isData3DTexture?C.texSubImage3D(ze,St,ue,ye,Be,Ut,Wt,Bt,le,Qt,Ae.data):Y.isCompressedArrayTexture?C.compressedTexSubImage3D(ze,St,ue,ye,Be,Ut,Wt,Bt,le,Ae.data):C.texSubImage3D(ze,St,ue,ye,Be,Ut,Wt,Bt,le,Qt,Ae):R.isDataTexture?C.texSubImage2D(C.TEXTURE_2D,St,ue,ye,Ut,Wt,le,Qt,Ae.data):R.isCompressedTexture?C.compressedTexSubImage2D(C.TEXTURE_2D,St,ue,ye,Ae.width,Ae.height,le,Ae.data):C.texSubImage2D(C.TEXTURE_2D,St,ue,ye,Ut,Wt,le,Qt,Ae);C.pixelStorei(C.UNPACK_ROW_LENGTH,me),C.pixelStorei(C.UNPACK_IMAGE_HEIGHT,Mn),C.pixelStorei(C.UNPACK_SKIP_PIXELS,xs),C.pixelStorei(C.UNPACK_SKIP_ROWS,Rn),C.pixelStorei(C.UNPACK_SKIP_IMAGES,$s),St===0&&Y.generateMipmaps&&C.generateMipmap(ze),ct.unbindTexture()},this.initRenderTarget=function(R){_t.get(R).__webglFramebuffer===void 0&&Dt.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Dt.setTextureCube(R,0):R.isData3DTexture?Dt.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Dt.setTexture2DArray(R,0):Dt.setTexture2D(R,0),ct.unbindTexture()},this.resetState=function(){T=0,P=0,L=null,ct.reset(),It.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var z0={type:"change"},md={type:"start"},H0={type:"end"},Ph=new dr,k0=new di,$1=Math.cos(70*Ws.DEG2RAD),ln=new F,qn=2*Math.PI,Ue={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},pd=1e-6,Ih=class extends Va{constructor(t,e=null){super(t,e),this.state=Ue.NONE,this.target=new F,this.cursor=new F,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ks.ROTATE,MIDDLE:ks.DOLLY,RIGHT:ks.PAN},this.touches={ONE:Hs.ROTATE,TWO:Hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new F,this._lastQuaternion=new Gn,this._lastTargetPosition=new F,this._quat=new Gn().setFromUnitVectors(t.up,new F(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new So,this._sphericalDelta=new So,this._scale=1,this._panOffset=new F,this._rotateStart=new Ft,this._rotateEnd=new Ft,this._rotateDelta=new Ft,this._panStart=new Ft,this._panEnd=new Ft,this._panDelta=new Ft,this._dollyStart=new Ft,this._dollyEnd=new Ft,this._dollyDelta=new Ft,this._dollyDirection=new F,this._mouse=new Ft,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=J1.bind(this),this._onPointerDown=Z1.bind(this),this._onPointerUp=K1.bind(this),this._onContextMenu=sE.bind(this),this._onMouseWheel=tE.bind(this),this._onKeyDown=eE.bind(this),this._onTouchStart=nE.bind(this),this._onTouchMove=iE.bind(this),this._onMouseDown=j1.bind(this),this._onMouseMove=Q1.bind(this),this._interceptControlDown=rE.bind(this),this._interceptControlUp=oE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(z0),this.update(),this.state=Ue.NONE}update(t=null){let e=this.object.position;ln.copy(e).sub(this.target),ln.applyQuaternion(this._quat),this._spherical.setFromVector3(ln),this.autoRotate&&this.state===Ue.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=qn:n>Math.PI&&(n-=qn),s<-Math.PI?s+=qn:s>Math.PI&&(s-=qn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(ln.setFromSpherical(this._spherical),ln.applyQuaternion(this._quatInverse),e.copy(this.target).add(ln),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=ln.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new F(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new F(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=ln.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Ph.origin.copy(this.object.position),Ph.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ph.direction))<$1?this.object.lookAt(this.target):(k0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ph.intersectPlane(k0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>pd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>pd||this._lastTargetPosition.distanceToSquared(this.target)>pd?(this.dispatchEvent(z0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?qn/60*this.autoRotateSpeed*t:qn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){ln.setFromMatrixColumn(e,0),ln.multiplyScalar(-t),this._panOffset.add(ln)}_panUp(t,e){this.screenSpacePanning===!0?ln.setFromMatrixColumn(e,1):(ln.setFromMatrixColumn(e,0),ln.crossVectors(this.object.up,ln)),ln.multiplyScalar(t),this._panOffset.add(ln)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;ln.copy(s).sub(this.target);let r=ln.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Ft,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function Z1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function J1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function K1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(H0),this.state=Ue.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function j1(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case ks.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ue.DOLLY;break;case ks.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ue.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ue.ROTATE}break;case ks.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ue.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ue.PAN}break;default:this.state=Ue.NONE}this.state!==Ue.NONE&&this.dispatchEvent(md)}function Q1(i){switch(this.state){case Ue.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ue.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ue.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function tE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ue.NONE||(i.preventDefault(),this.dispatchEvent(md),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(H0))}function eE(i){this.enabled!==!1&&this._handleKeyDown(i)}function nE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Hs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Ue.TOUCH_ROTATE;break;case Hs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Ue.TOUCH_PAN;break;default:this.state=Ue.NONE}break;case 2:switch(this.touches.TWO){case Hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ue.TOUCH_DOLLY_PAN;break;case Hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ue.TOUCH_DOLLY_ROTATE;break;default:this.state=Ue.NONE}break;default:this.state=Ue.NONE}this.state!==Ue.NONE&&this.dispatchEvent(md)}function iE(i){switch(this._trackPointer(i),this.state){case Ue.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ue.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ue.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ue.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ue.NONE}}function sE(i){this.enabled!==!1&&i.preventDefault()}function rE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function oE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var V0=7,aE=.0022;function lE(i){class t extends Xn{getPoint(n,s=new F){let r=2*Math.PI*V0*n;return s.set(n,i*Math.cos(r),i*Math.sin(r))}}return new Da(new t,V0*14,aE,5)}function Ka(i,t=14){return new si(i,i,1,t).rotateZ(-Math.PI/2).translate(.5,0,0)}var Lh=class{constructor(t,e,n){this.group=new Ke;let s=new Yi({color:t,depthTest:!1,transparent:!0,opacity:n});this.shaft=new de(Ka(e,10),s),this.head=new de(new gr(3*e,8*e,14).rotateZ(-Math.PI/2),s),this.size=8*e,this.shaft.renderOrder=this.head.renderOrder=10,this.group.add(this.shaft,this.head),this.along=new F(1,0,0),this.way=new F}show(t,e){let n=this.way.set(...e).length();if(this.group.visible=n>1e-4,!this.group.visible)return;this.group.position.set(...t),this.group.quaternion.setFromUnitVectors(this.along,this.way.divideScalar(n));let s=Math.min(this.size,.6*n);this.head.scale.setScalar(s/this.size),this.head.position.x=n-.5*s,this.shaft.scale.x=Math.max(n-s,1e-5)}hide(){this.group.visible=!1}},Dh,G0,ja=class{constructor(t,e,n){Wd(this,Dh);this.flight=t,this.group=new Ke;let s=e.opacity<1,r=(_,g={})=>new ms({color:_,roughness:.55,metalness:.15,transparent:s,opacity:e.opacity,depthWrite:!s,...g}),o=r(n.metal),a=r(n.dark),l=r(e.colour),c=r(n.force,{metalness:.4,roughness:.35}),u=Math.max(...t.arms.map(_=>_.length)),h=u/.19,f=new de(new si(.042*h,.042*h,.026*h,28),a);f.rotation.x=Math.PI/2;let d=new de(new si(.032*h,.04*h,.014*h,28),l);d.rotation.x=Math.PI/2,d.position.z=.02*h;let m=new de(new gr(.012*h,.034*h,16).rotateZ(-Math.PI/2),l);m.position.set(.056*h,0,.004*h),this.group.add(f,d,m),this.hulls=t.hull.map(_=>{let g=r(e.colour,{transparent:!0,opacity:.22*e.opacity,depthWrite:!1}),p=new de(new Ia(_.radius,32,20),g);return p.position.set(..._.centre),this.group.add(p),g}),this.arms=t.arms.map(_=>Xd(this,Dh,G0).call(this,_,{metal:o,dark:a,own:l,spring:c,paint:r,colours:n,unit:h,faded:s,look:e})),this.most=t.max_thrust||1,this.bar=1.2*u}show(t,e=1){this.group.position.set(...t.position);let[n,s,r,o]=t.quaternion;this.group.quaternion.set(s,r,o,n),this.arms.forEach((a,l)=>{let c=Math.min(e*(a.free-t.armLengths[l]),.4*a.free),u=e===1?t.armLengths[l]:a.free-c;a.end.position.x=u,a.coil&&(a.coil.scale.x=Math.max(u-a.collar-a.seat,.004)),a.blades.rotation.z=a.spin*t.own*60;let h=this.bar*t.thrust[l]/this.most;a.thrust.visible=h>.001,a.thrust.scale.z=Math.max(h,.001),a.cagePaint.color.set(t.contacts[l]?this.flight.glow:this.flight.colour)}),this.hulls.forEach((a,l)=>{a.color.set(t.contacts[this.arms.length+l]?this.flight.glow:this.flight.colour)})}};Dh=new WeakSet,G0=function(t,{metal:e,dark:n,own:s,spring:r,paint:o,colours:a,unit:l,faded:c,look:u}){let h=new Ke;h.rotation.z=Math.atan2(t.direction[1],t.direction[0]),this.group.add(h);let f=t.length-t.shortest,d=new Ke;h.add(d);let m={end:d,frame:h,free:t.length},_=.13*t.length;if(t.compliant){let P=Math.max(.24*t.length,t.shortest-_-.8*f),L=new de(Ka(.0075*l),e);L.scale.x=t.shortest-.5*_;let M=new de(Ka(.0045*l),s);M.position.x=-(t.length-P)+.3*_,M.scale.x=-M.position.x;let b=()=>new de(new si(.0155*l,.0155*l,.006*l,20).rotateZ(Math.PI/2),n),E=b();E.position.x=P;let O=b();O.position.x=-_;let B=new de(lE(.0125*l),r);B.position.x=P,h.add(L,E,B),d.add(M,O),Object.assign(m,{coil:B,seat:P,collar:_})}else{let P=new de(Ka(.007*l),e);P.scale.x=t.length,h.add(P)}let g=new de(new si(.013*l,.013*l,.024*l,18).rotateX(Math.PI/2),n);g.position.z=.008*l;let p=.62*t.cage_radius,A=new de(new mr(p,36),o(a.thrust,{transparent:!0,opacity:.16*u.opacity,side:zn,depthWrite:!1}));A.position.z=.022*l;let S=new de(new $i(2*p,.012*l,.0015),n);S.position.z=.023*l;let x=o(u.colour,{roughness:.4}),I=new de(new La(t.cage_radius-.0035*l,.0035*l,10,72),x);d.add(g,A,S,I);for(let P=0;P<3;P++){let L=new de(Ka(.0016*l,6),e);L.rotation.z=2*Math.PI*(P+.5)/3,L.scale.x=t.cage_radius-.004*l,d.add(L)}let T=new de(new si(.006*l,.006*l,1,12).rotateX(Math.PI/2).translate(0,0,.5),o(a.thrust,{transparent:!0,opacity:.8*u.opacity,emissive:a.thrust,emissiveIntensity:.3}));return T.position.z=.024*l,d.add(T),Object.assign(m,{blades:S,cagePaint:x,thrust:T,spin:t.spin})};function Qa(i){i.traverse(t=>{t.geometry?.dispose();for(let e of[t.material].flat())e?.map?.dispose(),e?.dispose?.()}),i.removeFromParent()}var W0=new Tn,Uh=new F,Lo=class extends za{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new _e(t,3)),this.setAttribute("uv",new _e(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new zs(e,6,1);return this.setAttribute("instanceStart",new ii(n,3,0)),this.setAttribute("instanceEnd",new ii(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new zs(e,6,1);return this.setAttribute("instanceColorStart",new ii(n,3,0)),this.setAttribute("instanceColorEnd",new ii(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new Ua(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Tn);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),W0.setFromBufferAttribute(e),this.boundingBox.union(W0))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Uh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Uh)),Uh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Uh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Rt.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ft(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};kn.line={uniforms:Za.merge([Rt.common,Rt.fog,Rt.line]),vertexShader:`
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
		`};var Xs=class extends ni{constructor(t){super({type:"LineMaterial",uniforms:Za.clone(kn.line.uniforms),vertexShader:kn.line.vertexShader,fragmentShader:kn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var gd=new Pe,X0=new F,q0=new F,xn=new Pe,yn=new Pe,Ki=new Pe,_d=new F,vd=new De,bn=new ka,Y0=new F,Nh=new Tn,Fh=new Di,ji=new Pe,Qi,Tr;function $0(i,t,e){return ji.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),ji.multiplyScalar(1/ji.w),ji.x=Tr/e.width,ji.y=Tr/e.height,ji.applyMatrix4(i.projectionMatrixInverse),ji.multiplyScalar(1/ji.w),Math.abs(Math.max(ji.x,ji.y))}function cE(i,t){let e=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){bn.start.fromBufferAttribute(s,a),bn.end.fromBufferAttribute(r,a),bn.applyMatrix4(e);let c=new F,u=new F;Qi.distanceSqToSegment(bn.start,bn.end,u,c),u.distanceTo(c)<Tr*.5&&t.push({point:u,pointOnLine:c,distance:Qi.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function hE(i,t,e){let n=t.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-t.near;Qi.at(1,Ki),Ki.w=1,Ki.applyMatrix4(t.matrixWorldInverse),Ki.applyMatrix4(n),Ki.multiplyScalar(1/Ki.w),Ki.x*=r.x/2,Ki.y*=r.y/2,Ki.z=0,_d.copy(Ki),vd.multiplyMatrices(t.matrixWorldInverse,o);for(let f=0,d=u;f<d;f++){if(xn.fromBufferAttribute(l,f),yn.fromBufferAttribute(c,f),xn.w=1,yn.w=1,xn.applyMatrix4(vd),yn.applyMatrix4(vd),xn.z>h&&yn.z>h)continue;if(xn.z>h){let S=xn.z-yn.z,x=(xn.z-h)/S;xn.lerp(yn,x)}else if(yn.z>h){let S=yn.z-xn.z,x=(yn.z-h)/S;yn.lerp(xn,x)}xn.applyMatrix4(n),yn.applyMatrix4(n),xn.multiplyScalar(1/xn.w),yn.multiplyScalar(1/yn.w),xn.x*=r.x/2,xn.y*=r.y/2,yn.x*=r.x/2,yn.y*=r.y/2,bn.start.copy(xn),bn.start.z=0,bn.end.copy(yn),bn.end.z=0;let _=bn.closestPointToPointParameter(_d,!0);bn.at(_,Y0);let g=Ws.lerp(xn.z,yn.z,_),p=g>=-1&&g<=1,A=_d.distanceTo(Y0)<Tr*.5;if(p&&A){bn.start.fromBufferAttribute(l,f),bn.end.fromBufferAttribute(c,f),bn.start.applyMatrix4(o),bn.end.applyMatrix4(o);let S=new F,x=new F;Qi.distanceSqToSegment(bn.start,bn.end,x,S),e.push({point:x,pointOnLine:S,distance:Qi.origin.distanceTo(x),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var Oh=class extends de{constructor(t=new Lo,e=new Xs({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)X0.fromBufferAttribute(e,o),q0.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+X0.distanceTo(q0);let r=new zs(s,2,1);return t.setAttribute("instanceDistanceStart",new ii(r,1,0)),t.setAttribute("instanceDistanceEnd",new ii(r,1,1)),this}raycast(t,e){let n=this.material.worldUnits,s=t.camera;s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;Qi=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Tr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Fh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Tr*.5;else{let h=Math.max(s.near,Fh.distanceToPoint(Qi.origin));c=$0(s,h,l.resolution)}if(Fh.radius+=c,Qi.intersectsSphere(Fh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Nh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Tr*.5;else{let h=Math.max(s.near,Nh.distanceToPoint(Qi.origin));u=$0(s,h,l.resolution)}Nh.expandByScalar(u),Qi.intersectsBox(Nh)!==!1&&(n?cE(this,e):hE(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(gd),this.material.uniforms.resolution.value.set(gd.z,gd.w))}};var Do=class extends Lo{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,n=new Float32Array(2*e);for(let s=0;s<e;s+=3)n[2*s]=t[s],n[2*s+1]=t[s+1],n[2*s+2]=t[s+2],n[2*s+3]=t[s+3],n[2*s+4]=t[s+4],n[2*s+5]=t[s+5];return super.setPositions(n),this}setColors(t){let e=t.length-3,n=new Float32Array(2*e);for(let s=0;s<e;s+=3)n[2*s]=t[s],n[2*s+1]=t[s+1],n[2*s+2]=t[s+2],n[2*s+3]=t[s+3],n[2*s+4]=t[s+4],n[2*s+5]=t[s+5];return super.setColors(n),this}setFromPoints(t){let e=t.length-1,n=new Float32Array(6*e);for(let s=0;s<e;s++)n[6*s]=t[s].x,n[6*s+1]=t[s].y,n[6*s+2]=t[s].z||0,n[6*s+3]=t[s+1].x,n[6*s+4]=t[s+1].y,n[6*s+5]=t[s+1].z||0;return super.setPositions(n),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Bh=class extends Oh{constructor(t=new Do,e=new Xs({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var gi=i=>new F(...i);function Z0(i,t,e,n,s,r){let o=[],a=t.length(),l=e.length(),c=t.clone().normalize(),u=e.clone().normalize(),h=(_,g)=>o.push(..._.toArray(),...g.toArray()),f=(_,g)=>i.clone().addScaledVector(c,_).addScaledVector(u,g),d=_=>{let g=[-_,_];for(let p=Math.ceil(-_/n)*n;p<_;p+=n)g.push(p);return g};for(let _ of d(a))h(f(_,-l),f(_,l));for(let _ of d(l))h(f(-a,_),f(a,_));let m=new Je;return m.setAttribute("position",new _e(o,3)),new wa(m,new Fs({color:s,transparent:!0,opacity:r,depthWrite:!1}))}function zh(i,t,e,n,s=0){let r=gi(i.across),o=gi(i.along),a=gi(i.normal),l=new $i(2*r.length(),2*o.length(),t),c=new ms({color:e,transparent:!0,opacity:n,roughness:.9,depthWrite:!1,side:zn}),u=new de(l,c),h=new De().makeBasis(r.normalize(),o.normalize(),a);return u.quaternion.setFromRotationMatrix(h),u.position.copy(gi(i.centre)).addScaledVector(a,-s-.5*t),u.renderOrder=1,u}function J0(i,t,e){let n=new Ke;if(i.kind==="mesh"){let a=new Je;return a.setAttribute("position",new vn(e(i.vertices),3)),a.setAttribute("normal",new vn(e(i.normals),3)),a.setIndex(Array.from(e(i.triangles))),n.add(new de(a,new ms({color:t.wall,transparent:!0,opacity:.55,roughness:.85,side:zn}))),n}let s=gi(i.centre),r=gi(i.normal).multiplyScalar(.001),o=(a,l,c)=>Z0(s.clone().add(r),gi(i.across),gi(i.along),c,l,a);return i.kind==="ground"?n.add(zh(i,.004,t.ground,.35),o(.55,t.faint,.25)):i.kind==="mat"?(n.add(zh(i,i.thickness,t.mat,.2),o(.55,t.mat,.1)),n.add(zh(i,.04,t.wall,.25,i.thickness))):n.add(zh(i,.04,t.wall,.22),o(.5,t.wall,.1)),n}function K0(i,t){let e=i.getSize(new F),n=i.getCenter(new F);n.z=i.min.z;let s=r=>Math.max(.8,Math.ceil((.5*r+.4)*4)/4);return Z0(n,new F(s(e.x),0,0),new F(0,s(e.y),0),.25,t.faint,.35)}function j0(i,t){let e=gi(i.guide).normalize(),n=[];for(let c=0;c<i.n;c+=Math.max(1,Math.floor(i.n/200)))n.push(e.dot(gi(i.position.subarray(3*c,3*c+3))));let s=Math.min(...n)-.5,r=Math.max(...n)+.5-s,o=new si(.008,.008,r,12).rotateZ(-Math.PI/2).translate(r/2,0,0),a=new de(o,new ms({color:t.metal,transparent:!0,opacity:.5}));a.quaternion.setFromUnitVectors(new F(1,0,0),e);let l=gi(i.position.subarray(0,3));return a.position.copy(l).addScaledVector(e,s-e.dot(l)),a}var kh=class{constructor(t,e,n){let s=t.impacts,r=s.length?s[0][0]:1/0,o=[],a=[],l=new he(e.before),c=new he(e.force),u=new he(t.colour);this.times=[];let h=-1/0;for(let d=0;d<t.n;d++){let m=t.t[d];if(m-h<.001&&d<t.n-1)continue;h=m,this.times.push(m),o.push(...t.position.subarray(3*d,3*d+3));let _=s.some(([g,p])=>m>=g&&m<=p);a.push(...(_?c:m<r?l:u).toArray())}let f=(d,m)=>{let _=new Do;_.setPositions(o),_.setColors(a);let g=new Xs({vertexColors:!0,linewidth:m,transparent:!0,opacity:d,depthWrite:!1});g.resolution.copy(n);let p=new Bh(_,g);return p.computeLineDistances(),p};this.whole=f(.3,1.2),this.flown=f(1,2.6),this.group=new Ke,this.group.add(this.whole,this.flown)}show(t){let e=0,n=this.times.length;for(;e<n;){let s=e+n>>1;this.times[s]<=t?e=s+1:n=s}this.flown.geometry.instanceCount=Math.max(e-1,0)}resize(t){this.whole.material.resolution.copy(t),this.flown.material.resolution.copy(t)}},Hh=class{constructor(t,e,n){this.level=e,this.group=new Ke,this.arms=t.arms;let s=()=>new Yi({color:"#000000",transparent:!0,opacity:.16,depthWrite:!1}),r=a=>{let l=new de(new mr(a,36),s());return l.renderOrder=2,this.group.add(l),l};this.body=r(.045),this.cages=t.arms.map(a=>r(a.cage_radius));let o=new Je;o.setAttribute("position",new _e([0,0,0,0,0,1],3)),this.plumb=new pr(o,new Fs({color:n.faint,transparent:!0,opacity:.6})),this.group.add(this.plumb),this.turn=new Gn,this.at=new F}show(t){let[e,n,s,r]=t.quaternion;this.turn.set(n,s,r,e);let o=this.level+.003;this.body.position.set(t.position[0],t.position[1],o),this.cages.forEach((a,l)=>{this.at.set(...this.arms[l].direction).multiplyScalar(t.armLengths[l]).applyQuaternion(this.turn),a.position.set(t.position[0]+this.at.x,t.position[1]+this.at.y,o)}),this.plumb.position.set(t.position[0],t.position[1],o),this.plumb.scale.z=Math.max(t.position[2]-o,1e-4)}};function uE(i,t){let e=document.createElement("canvas");e.width=128,e.height=64;let n=e.getContext("2d");n.font="600 40px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle=t,n.fillText(i,64,32);let s=new Ea(e);s.colorSpace=On;let r=new Sa(new bo({map:s,depthTest:!1,transparent:!0}));return r.scale.set(.9,.45,1),r}function Q0(i){let t=new Ke;return Object.entries({"x N":[1,0,0],"y W":[0,1,0],"z up":[0,0,1]}).forEach(([n,s])=>{let r=new Ha(gi(s),new F,1,i.ink,.28,.16),o=uE(n,i.ink);o.position.set(...s).multiplyScalar(1.38),t.add(r,o)}),t}var fE=(i,t)=>i.map((e,n)=>e+t[n]),t_=(i,t)=>i.kind==="mesh"?{...i,moved:t}:{...i,centre:fE(i.centre,t)},tl=(i,t)=>i.reduce((e,n,s)=>e+n*t[s],0);function e_(i){let t=new Map;for(let e of i){let n=e.kind!=="mesh",s=n?[e.kind,e.thickness,...e.normal,tl(e.normal,e.centre)].map(o=>o.toFixed?o.toFixed(4):o).join():`${e.name} ${e.moved}`,r=t.get(s);t.set(s,r&&n?dE(r,e):e)}return[...t.values()]}function dE(i,t){let e={...i,centre:i.centre.slice()};for(let n of["across","along"]){let s=Math.hypot(...i[n]),r=i[n].map(u=>u/s),o=Math.abs(tl(r,t.across))+Math.abs(tl(r,t.along)),a=tl(r,t.centre)-tl(r,i.centre),l=Math.min(-s,a-o),c=Math.max(s,a+o);e[n]=r.map(u=>u*(c-l)/2),e.centre=e.centre.map((u,h)=>u+r[h]*(l+c)/2)}return e}var n_=.22,pE=.2,mE=.005,gE=["follow","front","side","top"],Uo=["follow","free","front","side","top","impact"],i_=100,s_=.4,r_=400,o_=i=>Math.max(...i.arms.map(t=>t.length+t.cage_radius));function xd(i,t,e=!0){let n=i.map(rp),s=t.robots;n.forEach((a,l)=>{let c=!a.arms.some(u=>u.compliant);a.colour=n.length>1?s[l%s.length]:s[c?1:0],a.glow=t.force,a.index=l,a.shift=0});let r=n.map(Vi),o=r.find(a=>a!==null);return r.forEach((a,l)=>{e&&a!==null&&Math.abs(o-a)>mE&&(n[l].shift=o-a)}),n}function Vh(i,{flights:t=[],compare:e="side",align:n=!0,onCamera:s=()=>{},onDrawn:r=()=>{}}={}){let o={compare:e,align:n,magnified:1,camera:"follow",t:0,all:[],hidden:new Set,flights:[],forces:!0,path:!0,estimate:!1,share:1},a=Un();i.classList.add("picture");let l=document.createElement("div");l.className="force-labels";let c=document.createElement("div");c.className="scene-legend";let u=null;try{u=new Ch({antialias:!0,alpha:!1,powerPreference:"high-performance"})}catch{let it=document.createElement("p");it.className="no-graphics",it.textContent="This browser cannot draw 3-D graphics (WebGL is off); plots and numbers work.",i.append(it)}let h=new yo,f=new En(38,1,.02,80);f.up.set(0,0,1);let d=new yo,m=new vr(-1.9,1.9,1.9,-1.9,.1,20);m.up.set(0,0,1);let _=new Oa("#ffffff","#9aa4b0",2.1),g=new Ba("#ffffff",2);g.position.set(-2,-3,5),h.add(_,g);let p=null,A=new Ke,S=[],x=0,I=0,T=-1/0,P=0,L=0,M=new Ft(1,1);if(u){i.append(u.domElement,l,c),u.domElement.setAttribute("role","img"),u.domElement.setAttribute("aria-label","The flight in three dimensions, with numbers beside it."),p=new Ih(f,u.domElement),p.enableDamping=!1,p.minDistance=.15,p.maxDistance=30,p.addEventListener("change",b);let it=!1;p.addEventListener("start",()=>it=!0),p.addEventListener("end",()=>it=!1),p.addEventListener("change",()=>{it&&o.camera!=="follow"&&s("")})}function b(){!u||x||(I=performance.now(),x=requestAnimationFrame(B))}function E(){let it=performance.now(),j=I-T<r_;T=it,clearTimeout(P),j&&(L=.7*L+.3*(it-I)),L>i_&&o.share>s_&&(o.share=Math.max(s_,.7*o.share),L=.5*i_),O(j?o.share:1),j&&o.share<1&&(P=setTimeout(b,r_))}function O(it){let j=Math.min(devicePixelRatio||1,2)*it;Math.abs(u.getPixelRatio()-j)>.001&&u.setPixelRatio(j)}function B(){x=0,!(!u||!i.clientWidth||!i.clientHeight)&&(E(),H(),r())}function H(){let it=i.clientWidth,j=i.clientHeight;u.setViewport(0,0,it,j),u.setScissorTest(!1),u.setClearColor(a.background,1),u.render(h,f);let ct=Math.min(104,.24*Math.min(it,j));m.position.copy(f.position).sub(p.target).setLength(6),m.up.copy(f.up),m.lookAt(0,0,0),u.autoClear=!1,u.clearDepth(),u.setViewport(6,6,ct,ct),u.render(d,m),u.autoClear=!0,ut(it,j)}function W(){let it=o.flights[0].obstacles.find(ct=>ct.kind==="wall"||ct.kind==="mat"),j=it&&Math.abs(it.normal[2])<.9?new F(...it.across).normalize():new F(0,1,0);return j.y<0?j.negate():j}let Z=()=>W().applyAxisAngle(f.up,-Math.PI/2);function k(){if(o.compare!=="side")return o.flights.map(()=>[0,0,0]);let it=W(),j=Math.max(...o.flights.map(o_)),ct=.5*(o.flights.length-1);return o.flights.map((Nt,_t)=>it.clone().multiplyScalar((ct-_t)*(2*j+pE)).toArray())}function G(it,{keepCamera:j=!0}={}){a=Un(),o.all=xd(it,a,o.align),o.flights=o.all.filter((ct,Nt)=>!o.hidden.has(Nt)),u&&tt(),j||pt(o.camera),Lt(o.t)}function tt(){Qa(A),A=new Ke,h.add(A),d.children.slice().forEach(Qa),d.add(Q0(a)),l.replaceChildren();let it=k(),j=new Tn,ct=Math.max(...o.flights.map(au),0),Nt=ct>0?n_/lu(ct):0;o.floor=ot(it),S=o.flights.map((Zt,ee)=>{let U=new Ke;U.position.set(...it[ee]),A.add(U);let y=ee>0&&o.compare==="ghost",z=new ja(Zt,{colour:Zt.colour,opacity:y?.35:1},a),et=new kh(Zt,a,M),ht=[...Zt.arms,...Zt.hull].map(()=>new Lh(a.force,.007,y?.4:.95)),at=new Hh(Zt,o.floor,a);at.group.visible=!y||o.flights.length===2;let Ht=Or(Zt)?new ja(Zt,{colour:a.ink,opacity:.35},a):null;Ht&&U.add(Ht.group),U.add(z.group,et.group,at.group,...ht.map(mt=>mt.group)),Zt.guide.length&&U.add(j0(Zt,a));let xt=new Tn,Vt=Math.max(1,Math.floor(Zt.n/400));for(let mt=0;mt<Zt.n;mt+=Vt)xt.expandByPoint(new F(...Zt.position.subarray(3*mt,3*mt+3)));j.union(xt.translate(U.position));let Ot=[...Zt.arms,...Zt.hull].map(()=>{let mt=document.createElement("span");return l.append(mt),mt});return{flight:Zt,group:U,robot:z,estimate:Ht,path:et,arrows:ht,shadow:at,scale:Nt,names:Ot,ghost:y,contacts:[]}});let _t=o.flights.flatMap((Zt,ee)=>Zt.obstacles.map(U=>t_(U,it[ee])));e_(_t).forEach(Zt=>{let ee=J0(Zt,a,Si);ee.position.set(...Zt.moved??[0,0,0]),A.add(ee)});let Dt=_t.filter(Zt=>Zt.kind==="ground");o.box=j.clone(),Dt.length||(j.min.z=o.floor,A.add(K0(j,a))),rt()}function ot(){let it=Math.max(...o.flights.flatMap(ct=>ct.obstacles.filter(Nt=>Nt.kind==="ground").map(Nt=>Nt.centre[2])));if(Number.isFinite(it))return it;let j=1/0;for(let ct of o.flights)for(let Nt=2;Nt<3*ct.n;Nt+=3)j=Math.min(j,ct.position[Nt]);return j-.45}function rt(){let it=Math.max(...o.flights.map(au),0);c.replaceChildren();let j=(Nt,_t)=>{let Dt=document.createElement("span");Dt.className=`key ${Nt}`,Dt.textContent=_t,c.append(Dt)};if(o.flights.length>1&&o.flights.forEach(Nt=>{j("robot",Nt.label),c.lastChild.style.setProperty("--colour",Nt.colour)}),o.estimate&&o.flights.some(Or)&&j("estimate","estimated pose"),it>0&&o.forces){let Nt=lu(it);j("force",`contact force on a cage or the main body, ${Nt} N is ${100*n_} cm`)}o.flights.some(Nt=>Nt.thrust.some(_t=>_t>0))&&j("thrust","thrust");let ct=new Set(o.flights.flatMap(Nt=>Nt.obstacles.map(_t=>_t.kind==="mesh"?_t.name:_t.kind)));o.magnified!==1&&j("travel",`arm travel × ${o.magnified}, not to scale`),ct.has("mat")&&j("mat","mat"),[...ct].filter(Nt=>!["wall","mat","ground"].includes(Nt)).forEach(Nt=>j("own",Nt))}function ut(it,j){let ct=new F,Nt=[];for(let _t of S)_t.names.forEach((Dt,Zt)=>{let ee=_t.contacts[Zt];if(Dt.hidden=_t.ghost||!o.forces||!ee||ee.size<.5,Dt.hidden)return;ct.set(...ee.point).addScaledVector(new F(...ee.force),_t.scale),ct.add(_t.group.position).project(f),Dt.hidden=ct.z>1||Math.abs(ct.x)>1||Math.abs(ct.y)>1,Dt.textContent=`${ee.size.toFixed(ee.size<10?1:0)} N`;let U=Math.min(Math.max((ct.x+1)/2*it,24),it-24),y=Math.min(Math.max((1-ct.y)/2*j-12,10),j-10);Dt.hidden=Nt.some(([z,et])=>Math.abs(z-U)<50&&Math.abs(et-y)<18),!Dt.hidden&&(Nt.push([U,y]),Dt.style.transform=`translate(${U}px, ${y}px) translate(-50%, -50%)`)})}let lt=null;function Pt(){let it=S.map(j=>j.robot.group.position.clone().add(j.group.position));return it.reduce((j,ct)=>j.add(ct),new F).divideScalar(it.length||1)}function Lt(it){if(o.t=it,o.poses=o.flights.map(j=>Go(j,it)),S.forEach((j,ct)=>{let Nt=o.poses[ct];j.robot.show(Nt,o.magnified),j.path.group.visible=o.path,j.path.show(Nt.own),j.estimate&&(j.estimate.group.visible=o.estimate,o.estimate&&j.estimate.show(ou(j.flight,it),o.magnified)),j.shadow.show(Nt),j.contacts=Nt.contacts,j.arrows.forEach((_t,Dt)=>{let Zt=Nt.contacts[Dt];Zt&&o.forces?_t.show(Zt.point,Zt.force.map(ee=>j.scale*ee)):_t.hide()})}),u&&S.length&&gE.includes(o.camera)){let j=Pt();if(lt){let ct=j.clone().sub(lt);f.position.add(ct),p.target.add(ct)}lt=j,p.update()}b()}function K(it){let j=Ws.degToRad(f.fov/2),ct=Math.min(1,f.aspect);return it/Math.sin(Math.atan(Math.tan(j)*ct))}function V(it,j){p.target.copy(it),f.position.copy(it).add(j),p.update()}function pt(it){if(o.camera=Uo.includes(it)?it:"follow",lt=null,s(o.camera),!u||!S.length)return;let j=Math.max(...o.flights.map(o_)),ct=S.map(et=>et.group.position),Nt=ct[0].distanceTo(ct[ct.length-1])/2,_t=j+Nt+.1,Dt=ct.length>2&&Nt>0,Zt=Dt?Math.max(K(j+.2),_t/(Math.tan(Ws.degToRad(f.fov/2))*f.aspect)+j):K(_t),ee=o.box.clone().expandByScalar(j+.1),U=ee.getCenter(new F),y=.5*ee.getSize(new F).length(),z=Dt?Z().negate().addScaledVector(W(),-.25).setZ(.5).normalize():new F(-.62,-.66,.42).normalize();if(o.camera==="free")V(U,z.clone().multiplyScalar(K(y)));else if(o.camera==="impact")V(Et(),Dt?z.clone().multiplyScalar(Zt):new F(-.45,-.62,.5).normalize().multiplyScalar(K(_t+.05)));else{lt=Pt();let et={follow:z,front:Z().setZ(.12),side:W().negate().setZ(.12),top:new F(0,-.001,1)}[o.camera];V(lt.clone(),et.clone().normalize().multiplyScalar(o.camera==="side"?K(_t):Zt))}b()}function Et(){let it=o.flights.map((j,ct)=>{let Nt=Go(j,Vi(j)??j.begin);return new F(...Nt.position).add(S[ct].group.position)});return it.reduce((j,ct)=>j.add(ct),new F).divideScalar(it.length)}function bt(){if(!u)return;let it=i.clientWidth,j=i.clientHeight;if(!it||!j)return;O(1),u.setSize(it,j,!1);let ct=f.aspect;f.aspect=it/j,f.updateProjectionMatrix(),M.set(it,j),S.forEach(Nt=>Nt.path.resize(M)),Math.abs(ct/f.aspect-1)>.15&&pt(o.camera),b()}let ft=new ResizeObserver(bt);ft.observe(i);let Jt=matchMedia("(prefers-color-scheme: dark)"),C=()=>G(o.all);Jt.addEventListener("change",C);function Ct(){ft.disconnect(),Jt.removeEventListener("change",C),cancelAnimationFrame(x),clearTimeout(P),Qa(A),d.children.slice().forEach(Qa),p?.dispose(),u?.dispose(),i.replaceChildren()}return bt(),t.length&&G(t,{keepCamera:!1}),{show:Lt,replace:G,setCamera:pt,resize:bt,dispose:Ct,setCompare(it){o.compare=it,o.flights.length&&G(o.all,{keepCamera:!1})},setShown(it,j){if(typeof it!="number"){o[it]=j,rt(),Lt(o.t);return}j?o.hidden.delete(it):o.hidden.add(it),G(o.all,{keepCamera:!1})},canvas(it=!0){return it&&u&&(O(1),H()),u?.domElement??null},setMagnified(it){o.magnified=it,rt(),Lt(o.t)},get flights(){return o.flights},get all(){return o.all},get camera(){return o.camera},pose:()=>({t:o.t,camera:o.camera,pixels:o.share,flights:o.poses??[],estimates:o.estimate?o.flights.map(it=>Or(it)?ou(it,o.t):null):[]}),memory:()=>({...u?.info.memory})}}var _E={follow:"Follow",free:"Whole flight",front:"Front",side:"Side",top:"Top",impact:"Impact"},vE={1:"front",2:"side",3:"top",4:"follow",5:"free",6:"impact",0:"follow"},xE=[["space","play, pause"],["← →","one instant back, forth; with shift ten"],[", .","slower, faster"],["t","to the first touch"],["Home End","to the start, to the end"],["1 2 3","view from the front, from the side, from above"],["4 5 6","follow, whole flight, impact"],["0","the view as it was at first"],["e","estimated pose, on and off"],["f","full screen"],["p","save a picture"],["l","copy a link to this instant and view"],["a click in a plot","goes to that instant"],["a drag in a plot","zooms: along the time, the values, or both"],["a double click in a plot","shows everything"],["Escape","undoes the last zoom"],["?","these keys"]],yd="springback.plots",yE=8e3;function a_(i,t){let e=$("div",{class:"stage"}),n=$("div"),s=$("div",{class:"readouts"}),r=$("div"),o=$("p",{class:"remark",role:"status",hidden:!0}),a=!1,l=null,c=null,u=Vh(e,{flights:t.flights,onCamera:C=>(l?.mark(C),Et()),onDrawn:()=>c?.drawn()}),h=u.all,f=h.length>1,d=[...new Set(h.map(C=>C.scenario))].join(" and ");function m(C){o.textContent=C,o.hidden=!1,clearTimeout(m.ends),m.ends=setTimeout(()=>o.hidden=!0,yE)}let _=h.map((C,Ct)=>ME(C,f&&(it=>P(Ct,it))));l=yi("Camera",Uo.map(C=>[C,_E[C]]),"follow",C=>u.setCamera(C));let g=yi("Flights",[["side","side by side"],["ghost","overlaid"]],"side",C=>(u.setCompare(C),Et())),p=h.some(C=>C.arms.some(Ct=>Ct.compliant)),A=yi("Arm travel",[["1","arms to scale"],["10","arm travel × 10"]],"1",C=>(u.setMagnified(Number(C)),Et())),S={forces:["Forces",!0],path:["Path",!0],...h.some(Or)?{estimate:["Estimate",!1]}:{}},x=Object.fromEntries(Object.entries(S).map(([C,[Ct,it]])=>[C,qd(Ct,it,j=>(u.setShown(C,j),Et()),C==="estimate"?"The pose that the pilot estimates, as a grey ghost (E)":"")])),I=$("div",{class:"choice",role:"group","aria-label":"Show"},...Object.values(x)),T=()=>h.flatMap((C,Ct)=>_[Ct].shown?[]:[Ct+1]);function P(C,Ct){if(!Ct&&T().length===h.length-1)return m("One flight is always shown.");_[C].mark(Ct),u.setShown(C,Ct),V.replace(),Et()}let L=Vm(r,{onSeek:C=>(V.pause(),V.seek(C)),onZoom:()=>(Z(),Et()),onEdit:C=>M.open(L.wanted,C),onRemove:C=>k(L.wanted.filter((Ct,it)=>it!==C))}),M=cp({signals:hl(h),standard:js(h),onChoose:k}),b=h.find(C=>Vi(C)!==null),E=()=>{let[C,Ct]=b.impacts[0].map(j=>j+b.shift),it=.35*Math.min(Ct-C,.2)+.004;return[C-it,Math.min(Ct,C+.3)+2*it]},O=C=>!!(b&&C)&&C.every((Ct,it)=>Math.abs(Ct-E()[it])<1e-9),B=yi("Plots show",[["all","whole flight"],...b?[["impact","first impact"]]:[]],"all",C=>C==="all"?L.zoom():L.zoom(...E())),H=$("button",{type:"button",class:"undo",title:"Undo the last zoom (Escape)",disabled:!0,"aria-label":"Undo the last zoom",onclick:()=>L.back()},Es("undo")),W=$("button",{type:"button",class:"adding",title:"Choose plots and signals",onclick:()=>M.open(L.wanted)},"Plots …");function Z(){let{range:C,heights:Ct}=L.zoomed,it=!Object.keys(Ct).length;B.mark(it&&!C?"all":it&&O(C)?"impact":""),H.disabled=!L.canGoBack}function k(C){L.choose(C);try{C?localStorage.setItem(yd,Xo(C)):localStorage.removeItem(yd)}catch{}Et()}let G=$("dialog",{class:"keys","aria-label":"Keys and mouse"},$("h2",{},"Keys and mouse"),$("table",{},...xE.map(([C,Ct])=>$("tr",{},$("th",{scope:"row"},C),$("td",{},Ct)))),$("form",{method:"dialog"},$("button",{class:"main"},"Close"))),tt=(C,Ct,it,j)=>$("button",{type:"button",class:`tool tool-${C}`,title:`${Ct}${j?` (${j})`:""}`,"aria-label":Ct,onclick:it},Es(C)),ot=tt("film","Record a film from here",()=>c.film()),rt=$("div",{class:"tools"},tt("link","Copy a link to this instant and view",lt,"L"),tt("picture","Save a picture",()=>c.picture(),"P"),ot,...document.fullscreenEnabled?[tt("full","Full screen",Pt,"F")]:[],tt("help","Keys and mouse",()=>G.showModal(),"?")),ut=$("div",{class:"left"},e,n);async function lt(){let C=pt.address();try{await navigator.clipboard.writeText(C),m("The link is copied.")}catch{m("The address of this page is now a link to this instant and view.")}}function Pt(){document.fullscreenElement?document.exitFullscreen():ut.requestFullscreen().catch(()=>m("This browser refuses full screen."))}let K={...Object.fromEntries(Object.entries(vE).map(([C,Ct])=>[C,()=>u.setCamera(Ct)])),f:Pt,p:()=>c.picture(),l:lt,"?":()=>G.showModal(),e:()=>x.estimate?.click(),Escape:()=>L.back()};i.replaceChildren($("header",{class:"top"},$("div",{class:f?"flights several":"flights"},$("h1",{},d),..._.map(C=>C.element)),$("div",{class:"views"},l,...f?[g]:[],...p?[A]:[],I)),$("main",{},ut,$("aside",{},s,$("div",{class:"plot-head"},$("h2",{},"Over time"),B,H,W),r,SE(h))),M.element,G),e.append(o),i.classList.add("replay");let V=Al({scene:u,plots:L,bar:n,readouts:s,actions:K,onRest:()=>(c?.rested(),Et())});c=$d({scene:u,stage:e,player:V,say:m,name:d.replace(/[^\p{L}\p{N}]+/gu,"-").slice(0,60),onRecording:C=>{ot.classList.toggle("recording",C),ot.setAttribute("aria-label",C?"End the film":"Record a film from here")}}),n.querySelector(".buttons").append(rt),V.replace({keepTime:!1}),b&&L.restore({range:E(),heights:{}}),Z(),u.setCamera("follow");let pt=hp({read:bt,apply:ft});function Et(){a&&!V.playing&&pt.renew()}function bt(){let{range:C}=L.zoomed;return{t:V.time.toFixed(6).replace(/0+$/,"").replace(/\.$/,""),camera:u.camera==="follow"?"":u.camera,speed:V.pace==="auto"?"":V.pace,arms:A.chosen==="10"?"10":"",compare:g.chosen==="ghost"?"ghost":"",hide:T().join(),layers:Object.keys(S).filter(Ct=>x[Ct].on!==S[Ct][1]).join(),zoom:O(C)||!C&&!b?"":C?C.map(Ct=>Ct.toFixed(6)).join():"all",plots:Xo(L.wanted)===Xo(js(h))?"":Xo(L.wanted)}}function ft(C){let Ct=ct=>ct.split(",").map(Number);if(C.hide){let ct=Ct(C.hide);h.every((Nt,_t)=>ct.includes(_t+1))||h.forEach((Nt,_t)=>_[_t].shown===ct.includes(_t+1)&&P(_t,!ct.includes(_t+1)))}C.compare==="ghost"&&f&&g.press("ghost"),C.arms==="10"&&p&&A.press("10");let it=(C.layers??"").split(",");for(let ct of Object.keys(S))it.includes(ct)&&x[ct].on===S[ct][1]&&x[ct].click();Uo.includes(C.camera)&&u.setCamera(C.camera);let j=C.plots?cu(C.plots,h):[];j.length&&L.choose(j),C.zoom==="all"?L.restore({range:null,heights:{}}):C.zoom&&L.restore({range:Ct(C.zoom),heights:{}}),(C.speed==="auto"||Number(C.speed)>0)&&V.setPace(C.speed),C.t&&Number.isFinite(Number(C.t))&&V.seek(Number(C.t))}let Jt=bE(h);return Jt.length&&L.choose(Jt),pt.follow(),a=!0,window.springback={scene:u,player:V,plots:L,link:pt,pose:()=>({...u.pose(),playing:V.playing,pace:V.pace})},matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{h.forEach((C,Ct)=>_[Ct].element.style.setProperty("--colour",C.colour)),V.replace()}),window.springback}function bE(i){try{return cu(localStorage.getItem(yd)??"",i)}catch{return[]}}function ME(i,t){let e={shown:!0},n=t?$("button",{type:"button",class:"flight","aria-pressed":"true",title:"Hide or show this flight",onclick:()=>t(!e.shown)},i.label):$("b",{},i.label);return e.element=$("p",{class:`outcome ${i.success?"well":"badly"}`},n,$("span",{},` ${i.sentence}`)),e.element.style.setProperty("--colour",i.colour),e.mark=s=>{e.shown=s,n.setAttribute("aria-pressed",String(s)),e.element.classList.toggle("away",!s)},e}function SE(i){let t=i.flatMap(s=>[...s.notes.map(r=>`${s.label}: ${r}.`),s.shift?`${s.label} is shown ${Math.abs(s.shift).toFixed(3)} s ${s.shift<0?"earlier":"later"} than it flew, so that all touch at the same time.`:""]),e=Math.max(...i.map(s=>s.departure.position))*1e3;t.push(`Motion between the drawn instants is interpolated linearly: positions are within ${e<.01?"0.01":e.toFixed(2)} mm of the flight.`);let n=Math.max(...i.map(s=>s.every));return t.push("Signals that you choose are rounded to 1/65534 of their range."),n>1&&t.push(`Telemetry is shown at every tick near impacts and changes of phase, elsewhere at one tick in ${n}.`),$("details",{class:"about"},$("summary",{},"About this view"),...[...new Set(t)].filter(Boolean).map(s=>$("p",{},s)),$("p",{},"World axes: x north, y west, z up. Yellow arrows are the contact forces on cages and main body, including friction; the numbers show their vector sum, in which friction on two cages may cancel. Blue bars are the thrust of the rotors; dark discs are vertical shadows."))}var bd=1e3,l_=(i,t)=>Number((Math.round(i/t)*t).toFixed(6));function Gh(i,t){let{least:e,most:n,logarithmic:s}=i,r=s?Math.log(t/e)/Math.log(n/e):(t-e)/(n-e);return Math.min(Math.max(r,0),1)}function wE(i,t){let{least:e,most:n,step:s,logarithmic:r}=i,o=r?e*(n/e)**t:e+(n-e)*t,a=r?10**Math.max(Math.floor(Math.log10(o))-1,Math.log10(s)):s;return Math.min(Math.max(l_(o,Math.max(a,s)),e),n)}function EE(i,t){let e=`set-${i.name}`,n=i.unit.replace("^1.5","¹·⁵"),s=$("input",{type:"range",min:0,max:bd,step:1,id:`${e}-slider`,"aria-label":i.label,oninput:()=>h(wE(i,Number(s.value)/bd),{moving:!0}),onchange:()=>t(i.name,r.value,{settled:!0}),onkeydown:d=>{let m={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[d.key];if(!m)return;d.preventDefault();let _=Number(r.value);Number.isFinite(_)&&h(Math.min(Math.max(l_(_+m*i.step,i.step),i.least),i.most),{settled:!0})}}),r=$("input",{type:"text",inputmode:"decimal",id:e,autocomplete:"off",spellcheck:"false",maxlength:40,"aria-describedby":`${e}-words`,oninput:()=>t(i.name,r.value.trim(),{typing:!0}),onchange:()=>t(i.name,r.value.trim(),{settled:!0})}),o=$("p",{class:"words",id:`${e}-words`}),a=$("div",{class:"marks"},...i.marks.map((d,m)=>{let _=A=>String(A.value).length*.013+.01,g=i.marks.some((A,S)=>S<m&&Math.abs(Gh(i,A.value)-Gh(i,d.value))<_(A)+_(d)),p=$("button",{type:"button",class:g?"tight":"",title:`${d.value} ${n}, ${d.words}`,"aria-label":`${i.label} ${d.value} ${n}, ${d.words}`,onclick:()=>h(d.value,{settled:!0})},$("span",{},String(d.value)));return p.style.setProperty("--share",Gh(i,d.value)),p})),l=$("div",{class:"slider-control","data-name":i.name},$("label",{for:e},i.label),$("span",{class:"field"},r,$("span",{class:"unit"},n)),$("div",{class:"rail"},s,a),o);function c(d){let m=Number(d);r.value.trim()!==String(d)&&(r.value=String(d)),Number.isFinite(m)&&(s.value=Math.round(Gh(i,m)*bd),s.setAttribute("aria-valuetext",`${d} ${n}`)),f("")}function u(){let d=i.marks.find(m=>m.value===Number(r.value));o.className=d?"words printed":"words",o.textContent=d?`= ${d.words}`:i.explains}function h(d,m){c(d),t(i.name,String(d),m)}function f(d){r.setAttribute("aria-invalid",String(!!d)),l.classList.toggle("wrong",!!d),d?o.textContent=d:u()}return l.title=i.explains,{element:l,show:c,tellProblem:f}}function TE(i,t){let e=Object.keys(i.words).length>3,n=$("p",{class:"words"},i.explains),s=a=>t(i.name,a,{settled:!0});if(!e){let a=yi(i.label,Object.entries(i.words),i.default,s);return{element:$("div",{class:"picked","data-name":i.name,title:i.explains},$("span",{class:"label"},i.label),a),show:a.mark,tellProblem:()=>{}}}let r=$("select",{id:`set-${i.name}`,onchange:()=>s(r.value)},...Object.entries(i.words).map(([a,l])=>$("option",{value:a},l)));return{element:$("div",{class:"picked","data-name":i.name,title:i.explains},$("label",{for:`set-${i.name}`},i.label),r,n),show:a=>r.value=a,tellProblem:a=>n.textContent=a||i.explains}}function c_(i,t){let e={},n={},s=new Map,r=(f,d,m)=>{e[f]=d,l(),t(f,d,m)};for(let f of i)e[f.name]=String(f.default),n[f.name]=(f.kind==="slider"?EE:TE)(f,r),s.has(f.group)||s.set(f.group,[]),s.get(f.group).push(n[f.name].element);let o=[...s].map(([f,d])=>$("section",{},...f?[$("h2",{},f)]:[],...d)),a=$("form",{class:"controls",onsubmit:f=>f.preventDefault()},...o);function l(){for(let f of i){let d=Object.entries(f.when).every(([m,_])=>_.includes(e[m]));n[f.name].element.hidden=!d}o.forEach(f=>f.hidden=![...f.querySelectorAll("[data-name]")].some(d=>!d.hidden))}function c(f){for(let[d,m]of Object.entries(f))e[d]=String(m),n[d]?.show(m);l()}function u(f){for(let d of Object.values(n))d.tellProblem("");for(let d of f){let m=d.split(":")[0];n[m]?.tellProblem(d.slice(m.length+1).trim())}}let h=()=>i.filter(f=>e[f.name]!==String(f.default)).map(f=>`${f.name}=${encodeURIComponent(e[f.name])}`).join("&");return l(),{element:a,values:e,query:h,show:c,tellProblems:u}}function h_(i,t){let e=null,n=!1,s=0;function r(l,c){clearTimeout(s),e={query:l,how:c},n||o()}async function o(){let{query:l,how:c}=e;e=null,n=!0;try{await a(l,c)}catch{e||t.gone()}n=!1,e&&o()}async function a(l,c){let u=await fetch(`flight?${l}`,{headers:{"x-lab-page":i}}),h=await u.json();u.ok?t.answered(h,c):u.status===503?(h.preparing&&t.waits(h.preparing),s=setTimeout(()=>r(l,{...c,since:performance.now()}),700)):!h.overtaken&&!e&&t.refused(h.errors,c)}return{ask:r}}var u_=100,el="Energy",f_=[-.01,.13],AE={motion:["#0072b2",.85],"arm springs":["#56b4e9",.85],"end stops":["#cc79a7",.85],contact:["#009e73",.85],"lost in arms":["#e69f00",.6],"lost in contact":["#d55e00",.6],"lost in friction":["#8c8c8c",.6],"lost in stops":["#cc79a7",.4],"lost in locking":["#444444",.4],"lost to air":["#bbbbbb",.4]},d_=(i,t)=>i+Math.round(255*t).toString(16).padStart(2,"0");function Md(i,t=[1,1.5,2,3,5,7,10]){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));return e*t.find(n=>n*e>=i*.999999)}function CE(i,t,e){let n=[t<-1e-9?-Md(-t):0,e>1e-9?Md(e):t<-1e-9?0:1],[s,r]=i??n,o=t>=s&&e<=r&&e-t>.4*(r-s);return i&&o?i:n}function RE(i,t,e){let n=0,s=0;for(let{t:r,values:o}of i)for(let a=0;a<o.length;a++)r[a]<t||r[a]>e||(o[a]<n&&(n=o[a]),o[a]>s&&(s=o[a]));return[n,s]}function PE(i,t){let e=new Map,n=(o,a,l)=>{e.has(o)||e.set(o,{name:o,unit:a,curves:[],stacked:o.startsWith(el)}),e.get(o).curves.push(l)},s=(o,a)=>{let l=Array.from(o.t,u=>u+o.shift),c=null;for(let u of o.series)if(u.panel===el){if(a)continue;c=Array.from(u.values,(d,m)=>d+(c?c[m]:0));let[h,f]=AE[u.name]??["#8c8c8c",.5];n(`${el}, ${o.label}`,u.unit,{name:u.name,t:l,values:c,colour:h,fill:d_(h,f),flight:o})}else n(u.panel,u.unit,{name:a?`${o.label}, pinned`:o.label,t:l,values:Array.from(u.values),flight:o,colour:a?d_(o.colour,.75):o.colour,dash:a?[3,3]:o.dash,behind:a})};i.forEach((o,a)=>{o.dash=a?[8,3]:[],s(o,!1)}),t.forEach(o=>s(o,!0));let r=o=>["Acceleration","Arm compression",`${el}, ARQ`,`${el}, Quad`,"Velocity","Contact force"].indexOf(o.name);return[...e.values()].sort((o,a)=>r(o)-r(a))}function p_(i,{onSeek:t}){let e=new Map,n=[],s=[],r=0,o=null;i.classList.add("plots");function a(m,{whole:_=!1}={}){s=m;let g=Vi(m[0]),[p,A]=[m[0].begin,m[0].end];o=_||g===null?[p,A]:[g+f_[0],Math.min(g+f_[1],A)];let S=g??0,x=PE(m,n);for(let[I,T]of e)x.some(P=>P.name===I&&l(P,_)===T.signature)||(T.plot.destroy(),T.box.remove(),e.delete(I));for(let I of x){let T=e.get(I.name)??u(I,_);T.panel=I,T.zero=S,T.bounds=CE(T.bounds,...RE(I.curves,...o)),T.plot.batch(()=>{T.plot.setData(c(I),!1),T.plot.setScale("x",{min:o[0],max:o[1]}),T.plot.setScale("y",{min:T.bounds[0],max:T.bounds[1]})}),i.append(T.box)}f(r)}let l=(m,_)=>`${_} ${m.curves.map(g=>`${g.name} ${g.colour}`).join()}`;function c(m){let g=m.curves.every(p=>p.flight===m.curves[0].flight)?[m.curves[0].t,...m.curves.map(p=>p.values)]:Ze.join(m.curves.map(p=>[p.t,p.values]));return m.stacked?[g[0],...g.slice(1).reverse()]:g}function u(m,_){let g=Un(),p=!m.stacked||m.curves[0].flight===s[0],A=m.curves.filter(()=>p).map(b=>{let E=document.createElementNS("http://www.w3.org/2000/svg","svg");E.setAttribute("viewBox","0 0 22 8"),E.setAttribute("aria-hidden","true");let O=document.createElementNS("http://www.w3.org/2000/svg","line"),B={x1:0,x2:22,y1:4,y2:4,stroke:b.fill??b.colour,"stroke-width":b.fill?8:2.4,"stroke-dasharray":(b.dash??[]).join(" ")};return Object.entries(B).forEach(([H,W])=>O.setAttribute(H,W)),E.append(O),$("span",{class:"plot-key"},E,$("span",{},b.name))}),S=$("div",{class:"plot-canvas"}),x=$("section",{class:"plot","data-panel":m.name},$("header",{},$("h3",{},`${m.name} [${m.unit}]`),$("div",{class:"plot-keys"},...A)),S);i.append(x);let I={box:x,canvas:S,panel:m,signature:l(m,_),bounds:null,zero:0},T={stroke:g.faint,grid:{stroke:g.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},P=m.stacked?[...m.curves].reverse():m.curves,L=(b,E)=>E.map(O=>String(_?+O.toFixed(3):Math.round(1e3*(O-I.zero)))),M=(b,E,O,B)=>IE(O,B,I.zero,_);return I.plot=new Ze({width:Math.max(S.clientWidth,200),height:u_,padding:[6,10,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[{...T,size:22,gap:2,values:L,splits:M},{...T,size:46,gap:4,space:24}],series:[{},...P.map(b=>({stroke:b.colour,width:b.fill?1:b.behind?1.4:1.8,dash:b.dash??[],fill:b.fill,spanGaps:!0,points:{show:!1}}))],hooks:{draw:[()=>h(I)]},bands:m.stacked?P.slice(1).map((b,E)=>({series:[E+1,E+2],fill:P[E].fill})):[]},c(m),S),I.marker=$("div",{class:"plot-now"}),I.plot.over.append(I.marker),I.plot.over.addEventListener("click",b=>t(I.plot.posToVal(b.offsetX,"x"))),e.set(m.name,I),I}function h({plot:m,marker:_}){if(!_)return;let{min:g,max:p}=m.scales.x;_.hidden=!(r>=g&&r<=p),_.style.transform=`translateX(${m.valToPos(r,"x")}px)`}function f(m){r=m,e.forEach(h)}function d(){for(let{plot:m,canvas:_}of e.values()){let g=_.clientWidth;g&&Math.abs(g-m.width)>1&&m.setSize({width:g,height:u_})}f(r)}return new ResizeObserver(d).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{e.forEach(({plot:m,box:_})=>(m.destroy(),_.remove())),e.clear()}),{replace:a,show:f,pin(m){n=m},curve:m=>e.get(m)?.panel.curves.map(_=>({name:_.name,peak:_.values.reduce((g,p)=>Math.max(g,p),0),points:_.values.length})),get flights(){return s}}}function IE(i,t,e,n){let s=n?Md((t-i)/8,[1,2,5,10]):.02,r=[];for(let o=Math.ceil((i-e*!n)/s);;o++){let a=o*s+(n?0:e);if(a>t)return r;r.push(a)}}var Sd=i=>{if(i==null)return"–";if(typeof i=="string")return i;let t=Math.abs(i);return t<5e-4?"0":i.toFixed(t<1?3:t<10?2:t<100?1:0)};function m_(i){function t(e,n){let s=e.flights.map(f=>[f.robot,f.label]),r=f=>n?.flights.some(d=>d.robot===f),o=e.measures.some(f=>Object.keys(f.printed).length),a=$("tr",{},$("th",{},""));for(let[f,d]of s){let m=$("th",{scope:"col"},d);m.style.color=Un().robots[f==="quad"?1:0],a.append(m),o&&a.append($("th",{scope:"col",class:"printed"},"paper")),r(f)&&a.append($("th",{scope:"col",class:"pinned"},"pinned"))}let l=e.measures.map(f=>{let d=n?.measures.find(_=>_.name===f.name),m=$("tr",{"data-measure":f.name},$("th",{scope:"row"},f.label,...f.unit?[$("small",{},` ${f.unit}`)]:[]));for(let[_]of s){let g=[o&&f.printed[_]?`paper ${f.printed[_]}`:"",r(_)?`pinned ${Sd(d?.values[_])}`:""];m.append($("td",{"data-robot":_,"data-beside":g.filter(Boolean).join(", ")},$("b",{},Sd(f.values[_])))),o&&m.append($("td",{class:"printed"},f.printed[_]??"")),r(_)&&m.append($("td",{class:"pinned"},Sd(d?.values[_])))}return m}),{words:c,same:u}=e.printed_for,h=o?[$("p",{class:u?"note":"note other"},u?c:`${c} The settings here differ.`)]:[];i.replaceChildren($("table",{},$("thead",{},a),$("tbody",{},...l)),...h),i.classList.toggle("elsewhere",!u)}return{show:t}}var g_={impact:"Impact",follow:"Follow",side:"Side",top:"Top",free:"All"},LE=.012,DE=350,__=i=>Un().robots[i.label==="Quad"?1:0];function v_(i,t){let e=Math.random().toString(36).slice(2),n=null,s=null,r=!1,o=[],a=c_(t.controls,Z),l=$("div",{class:"outcomes","aria-live":"polite"}),c=$("p",{class:"alert",role:"alert",hidden:!0}),u=$("input",{class:"link",readonly:!0,"aria-label":"Link to these settings",id:"link",onfocus:()=>u.select()}),h=$("button",{type:"button",id:"copy",onclick:pt},"Copy link"),f=$("button",{type:"button",id:"pin","aria-pressed":"false",title:"Keep this flight behind the next ones for comparison",onclick:Et},"Pin"),d=$("button",{type:"button",id:"reset",title:"Return to the paper's slider test",onclick:()=>V("",{push:!0})},"Reset"),m=$("span",{class:"files"}),_=$("div",{class:"stage"}),g=$("div",{class:"preparing",role:"status",hidden:!0}),p=$("div"),A=$("div"),S=$("div",{class:"measures"}),x=$("p",{class:"took"}),I=$("button",{type:"button",class:"drawer",id:"drawer","aria-expanded":"false",onclick:()=>bt(!i.classList.contains("open"))},"Settings"),T=yi("Camera",Uo.filter(ft=>g_[ft]).map(ft=>[ft,g_[ft]]),"impact",ft=>b.setCamera(ft)),P=yi("Two robots",[["side","side by side"],["ghost","overlaid"]],"side",ft=>b.setCompare(ft)),L=$("h2"),M=yi("Plots show",[["impact","impact"],["all","all"]],"impact",ft=>{r=ft==="all",n&&tt()});i.classList.add("lab"),i.replaceChildren($("header",{class:"top"},$("div",{class:"said"},$("h1",{},"Impact lab"),l,c),$("div",{class:"actions"},f,d,m,$("span",{class:"linking"},u,h))),$("main",{},$("aside",{class:"settings",id:"settings"},a.element,x),$("div",{class:"middle"},$("div",{class:"frame"},_,$("div",{class:"views"},T,P),g),p,S),$("aside",{class:"curves"},$("div",{class:"plot-head"},L,M),A)),I);let b=Vh(_,{onCamera:ft=>T.mark(ft)}),E=p_(A,{onSeek:ft=>(O.pause(),O.seek(ft))}),O=Al({scene:b,plots:{show:E.show,replace:()=>tt()},bar:p}),B=m_(S),H=h_(e,{answered:k,refused:ut,waits:lt,gone:Pt}),W=0;function Z(ft,Jt,C){clearTimeout(W);let Ct=()=>H.ask(a.query(),{...C,since:performance.now()});C.typing?W=setTimeout(Ct,DE):Ct()}function k(ft,Jt){let C=n;n=ft,i.classList.add("ready"),Jt.aside||rt([]),g.hidden=!0,Jt.typing?a.tellProblems([]):a.show(ft.settings);let Ct=!C||C.settings.mode!==ft.settings.mode,it=ft.flights.length!==C?.flights.length;b.replace(ft.flights.map(j=>j.scene),{keepCamera:!Ct&&!it});for(let j of b.flights)j.colour=__(j);P.hidden=ft.flights.length<2,Ct&&M.mark((r=ft.settings.mode==="flight")?"all":"impact"),O.replace({keepTime:!Ct}),Ct&&G(),ot(),B.show(ft,s),m.replaceChildren(...ft.flights.map(j=>$("a",{class:"button",href:`scenario.toml?${[ft.query,`of=${j.robot}`].filter(Boolean).join("&")}`,download:j.file,title:`Scenario for springback fly, ${j.label}`},`${j.label}.toml`))),K(ft.query,Jt),requestAnimationFrame(()=>{let j=performance.now()-Jt.since;o.push(j),x.textContent=`Flown in ${ft.took.flying.toFixed(0)} ms, answered in ${ft.took.all.toFixed(0)} ms, drawn after ${j.toFixed(0)} ms.`})}function G(){let ft=Vi(b.flights[0]),Jt=n.settings.mode==="impact",C=Jt?"impact":"follow";T.mark(C),b.setCamera(C),O.seek(ft===null?b.flights[0].begin:Jt?ft+LE:ft)}function tt(){n&&(L.textContent=r?"Time [s]":"Time from touch [ms]",E.replace(b.flights,{whole:r}))}function ot(){l.replaceChildren(...n.flights.map((ft,Jt)=>{let C=$("p",{class:`outcome ${ft.well?"well":"badly"}`},$("b",{},ft.label),ft.sentence.slice(ft.label.length));return C.style.setProperty("--colour",b.flights[Jt].colour),C}))}function rt(ft){c.hidden=!ft.length,c.textContent=ft.join(" ")}function ut(ft,Jt){g.hidden=!0,a.tellProblems(ft),rt([...ft.map(C=>`${C}.`),n?"The previous flight is shown.":"The default flight is shown instead."]),n||H.ask("",{since:performance.now(),aside:!0})}function lt(ft){g.hidden=!1,g.replaceChildren($("progress",{}),$("p",{},`Compiling for ${ft.what}: ${Math.round(ft.waited)} s so far.`),$("p",{class:"words"},"Once on this machine, 10 s to a minute or two; other settings can be flown meanwhile if they are ready."))}function Pt(){rt(["The lab does not respond; it may have been stopped in its terminal. Any change tries again."])}let Lt=!1;function K(ft,{settled:Jt=!1,aside:C=!1,restored:Ct=!1}){let it=`${location.pathname}${ft?`?${ft}`:""}`;u.value=location.origin+it,!(C||Ct)&&(`${location.pathname}${location.search}`!==it&&(Lt?history.replaceState(null,"",it):history.pushState(null,"",it)),Lt=!Jt)}function V(ft,{push:Jt=!1}={}){H.ask(ft,{since:performance.now(),settled:Jt,restored:!Jt})}addEventListener("popstate",()=>V(location.search.slice(1)));async function pt(){try{await navigator.clipboard.writeText(u.value)}catch{u.select(),document.execCommand("copy")}h.textContent="Copied",setTimeout(()=>h.textContent="Copy link",1500)}function Et(){s=s?null:n,f.setAttribute("aria-pressed",String(!!s)),f.textContent=s?"Unpin":"Pin";let ft=s?xd(s.flights.map(Jt=>({...Jt.scene})),Un()):[];for(let Jt of ft)Jt.colour=__(Jt);E.pin(ft),tt(),B.show(n,s)}function bt(ft){i.classList.toggle("open",ft),I.setAttribute("aria-expanded",String(ft)),I.textContent=ft?"Done":"Settings",ft&&_.scrollIntoView({block:"start"})}return a.show(Object.fromEntries(t.controls.map(ft=>[ft.name,ft.default]))),V(location.search.slice(1)),window.springback={scene:b,player:O,plots:E,controls:a,latency:o,pose:()=>({...b.pose(),playing:O.playing,pace:O.pace}),get answer(){return n}},window.springback}var UE={replay:a_,lab:v_};function x_(){let i=UE[document.body.dataset.app],t=document.getElementById("data");i&&i(document.getElementById("app"),t?JSON.parse(t.textContent):{})}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",x_):x_();})();
