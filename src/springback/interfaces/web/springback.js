/*! springback, MIT licence; sources ad8735e4070b8284b360dc3fb2aa5c463e5a4e9578d7ed9f0e88447675c96dcc

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
(()=>{var Kd=i=>{throw TypeError(i)};var $_=(i,e,t)=>e.has(i)||Kd("Cannot "+t);var Jd=(i,e,t)=>e.has(i)?Kd("Cannot add the same private member more than once"):e instanceof WeakSet?e.add(i):e.set(i,t);var jd=(i,e,t)=>($_(i,e,"access private method"),t);function G(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==!1&&r!=null&&n.setAttribute(s,r);return n.append(...t),n}var Z_={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",back:"M18 5v14l-9.5-7zM5.5 5h2.4v14H5.5z",forth:"M6 5v14l9.5-7zM16.1 5h2.4v14h-2.4z",touch:"M4 4h3v16H4zM20 12l-9 6V6z",link:"M10.6 13.4a4 4 0 0 0 5.7 0l3-3a4 4 0 1 0-5.7-5.7l-1.6 1.6 1.4 1.4 1.6-1.6a2 2 0 1 1 2.9 2.9l-3 3a2 2 0 0 1-2.9 0zm2.8-2.8a4 4 0 0 0-5.7 0l-3 3a4 4 0 1 0 5.7 5.7l1.6-1.6-1.4-1.4-1.6 1.6a2 2 0 1 1-2.9-2.9l3-3a2 2 0 0 1 2.9 0z",picture:"M4 7h4l1.5-2.5h5L16 7h4v12H4zm8 2.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zm0 1.8a1.7 1.7 0 1 1 0 3.4 1.7 1.7 0 0 1 0-3.4z",undo:"M9 4 3.5 9.5 9 15v-4h5a3.5 3.5 0 0 1 0 7h-4v2.2h4a5.7 5.7 0 0 0 0-11.4H9z",film:"M3 6h12v12H3zM16.5 10.5 21 7.5v9l-4.5-3z",full:"M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z",help:"M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 12.5h2v2h-2zm1-9c-2 0-3.5 1.3-3.5 3.2h2c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.4-2.5 1.6-2.5 4.1v.3h2v-.2c0-1.4 2.5-1.8 2.5-4.3 0-1.8-1.5-3-3.5-3z"};function Gi(i){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",Z_[i]),t.setAttribute("fill-rule","evenodd"),e.append(t),e}function bi(i,e,t,n){let s=G("div",{class:"choice",role:"group","aria-label":i});for(let[a,l]of e)s.append(G("button",{type:"button","data-value":a,"aria-pressed":String(a===t),onclick:()=>{r(a),n(a)}},l));function r(a){for(let l of s.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))}let o=a=>(r(a),n(a));return Object.defineProperty(s,"chosen",{get:()=>s.querySelector("[aria-pressed=true]")?.dataset.value}),Object.assign(s,{mark:r,press:o})}function Qd(i,e,t,n=""){let s=G("button",{type:"button",title:n,"aria-pressed":String(e),onclick:()=>{s.setAttribute("aria-pressed",String(!s.on)),t(s.on)}},i);return Object.defineProperty(s,"on",{get:()=>s.getAttribute("aria-pressed")==="true"}),s}var K_=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"],J_=30;function ep(i,e){let t=G("a",{href:URL.createObjectURL(i),download:e});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}function au(i,e,t,n=null){let s=e.getBoundingClientRect(),r=getComputedStyle(e);if(!s.width)return;let[o,a]=[s.left-t.left,s.top-t.top];i.fillStyle=r.backgroundColor,i.fillRect(o,a,s.width,s.height);let l=o+parseFloat(r.paddingLeft);if(n&&parseFloat(n.width)>0){let c=parseFloat(n.height);i.fillStyle=n.backgroundColor,i.fillRect(l,a+(s.height-c)/2,parseFloat(n.width),c),l+=parseFloat(n.width)+parseFloat(n.marginRight)}i.font=`${r.fontWeight} ${r.fontSize} ${r.fontFamily}`,i.textBaseline="middle",i.fillStyle=r.color,i.fillText(e.textContent,l,a+s.height/2+1,o+s.width-l)}function tp({scene:i,stage:e,player:t,name:n,say:s,onRecording:r=()=>{}}){let o=G("div",{class:"stage-clock","aria-hidden":"true"});e.append(o);let a=null,l=null;function c(){let p=Math.min(devicePixelRatio||1,2),g=G("canvas",{width:2*Math.round(e.clientWidth*p/2),height:2*Math.round(e.clientHeight*p/2)});return{canvas:g,pen:g.getContext("2d"),ratio:p}}function u({canvas:p,pen:g,ratio:_},m){o.textContent=`${i.pose().t.toFixed(4)} s`;let d=e.getBoundingClientRect();g.setTransform(1,0,0,1,0,0),g.drawImage(m,0,0,p.width,p.height),g.scale(_,_);let M=e.querySelector(".scene-legend"),S=M.getBoundingClientRect();g.fillStyle=getComputedStyle(M).backgroundColor,g.fillRect(S.left-d.left,S.top-d.top,S.width,S.height);for(let x of M.children)au(g,x,d,getComputedStyle(x,"::before"));for(let x of e.querySelectorAll(".force-labels span:not([hidden])"))au(g,x,d);au(g,o,d)}function h(){let p=i.canvas();if(!p)return s("There is no picture without WebGL.");let g=c();u(g,p),g.canvas.toBlob(_=>{ep(_,`${n}-${i.pose().t.toFixed(4)}s.png`),s("The picture is among your downloads.")})}function f(){if(a)return a.stop();let p=window.MediaRecorder&&K_.find(_=>MediaRecorder.isTypeSupported(_));if(!p||!i.canvas()||!HTMLCanvasElement.prototype.captureStream)return s("This browser cannot record films. The command springback animate RESULT --out film.gif makes one, or film.mp4.");l=c(),u(l,i.canvas());let g=[];a=new MediaRecorder(l.canvas.captureStream(J_),{mimeType:p,videoBitsPerSecond:12e6}),a.ondataavailable=_=>g.push(_.data),a.onstop=()=>{[a,l]=[null,null],t.pause(),r(!1),ep(new Blob(g,{type:p}),`${n}.${p.includes("mp4")?"mp4":"webm"}`),s("The film is among your downloads. springback animate makes one without dropped frames.")},a.start(),r(!0),t.play()}return{picture:h,film:f,drawn(){l&&u(l,i.canvas(!1))},rested(){a?.state==="recording"&&!t.playing&&a.stop()},get recording(){return!!a}}}var j_=()=>matchMedia("(prefers-color-scheme: dark)").matches,Q_={background:"#f3f5f8",ink:"#222222",faint:"#8c8c8c",line:"#c3cad4",wall:"#7d8794",mat:"#009e73",ground:"#a8aeb7",metal:"#5b6470",dark:"#30363d",arms:["#0072b2","#d98a00","#009e73","#cc79a7","#3a9bd9","#8c8c8c"],robots:["#0072b2","#d55e00","#007a5a","#a8488a","#8a6d00","#1b2a6b","#6b6b6b","#7a1f1f"],force:"#e69f00",thrust:"#56b4e9",before:"#8c8c8c"},ev={background:"#14181d",ink:"#e6e9ed",faint:"#9aa3ad",line:"#3a434e",wall:"#98a3b1",mat:"#2cc79a",ground:"#59626d",metal:"#aab4c0",dark:"#cdd4dc",arms:["#4ea8e0","#f0b429","#35c79b","#e29cc4","#8fd0f5","#a7b0ba"],robots:["#4ea8e0","#ff8a3d","#35c79b","#e29cc4","#e3cf57","#a9b4ff","#c9d1d9","#ff8f8f"],force:"#ffc13d",thrust:"#7cc8f2",before:"#a7b0ba"},Nn=()=>j_()?ev:Q_;var ui=Uint8Array,Fr=Uint16Array,tv=Int32Array,np=new ui([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),ip=new ui([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),nv=new ui([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),sp=function(i,e){for(var t=new Fr(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new tv(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},rp=sp(np,2),op=rp.b,iv=rp.r;op[28]=258,iv[258]=28;var ap=sp(ip,0),sv=ap.b,fT=ap.r,hu=new Fr(32768);for(wt=0;wt<32768;++wt)os=(wt&43690)>>1|(wt&21845)<<1,os=(os&52428)>>2|(os&13107)<<2,os=(os&61680)>>4|(os&3855)<<4,hu[wt]=((os&65280)>>8|(os&255)<<8)>>1;var os,wt,Wo=(function(i,e,t){for(var n=i.length,s=0,r=new Fr(e);s<n;++s)i[s]&&++r[i[s]-1];var o=new Fr(e);for(s=1;s<e;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(t){a=new Fr(1<<e);var l=15-e;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],u=e-i[s],h=o[i[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[hu[h]>>l]=c}else for(a=new Fr(n),s=0;s<n;++s)i[s]&&(a[s]=hu[o[i[s]-1]++]>>15-i[s]);return a}),Xo=new ui(288);for(wt=0;wt<144;++wt)Xo[wt]=8;var wt;for(wt=144;wt<256;++wt)Xo[wt]=9;var wt;for(wt=256;wt<280;++wt)Xo[wt]=7;var wt;for(wt=280;wt<288;++wt)Xo[wt]=8;var wt,lp=new ui(32);for(wt=0;wt<32;++wt)lp[wt]=5;var wt;var rv=Wo(Xo,9,1);var ov=Wo(lp,5,1),lu=function(i){for(var e=i[0],t=1;t<i.length;++t)i[t]>e&&(e=i[t]);return e},Mi=function(i,e,t){var n=e/8|0;return(i[n]|i[n+1]<<8)>>(e&7)&t},cu=function(i,e){var t=e/8|0;return(i[t]|i[t+1]<<8|i[t+2]<<16)>>(e&7)},av=function(i){return(i+7)/8|0},lv=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new ui(i.subarray(e,t))};var cv=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Si=function(i,e,t){var n=new Error(e||cv[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Si),!t)throw n;return n},hv=function(i,e,t,n){var s=i.length,r=n?n.length:0;if(!s||e.f&&!e.l)return t||new ui(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new ui(s*3));var c=function(Ke){var mt=t.length;if(Ke>mt){var k=new ui(Math.max(mt*2,Ke));k.set(t),t=k}},u=e.f||0,h=e.p||0,f=e.b||0,p=e.l,g=e.d,_=e.m,m=e.n,d=s*8;do{if(!p){u=Mi(i,h,1);var M=Mi(i,h+1,3);if(h+=3,M)if(M==1)p=rv,g=ov,_=9,m=5;else if(M==2){var T=Mi(i,h,31)+257,C=Mi(i,h+10,15)+4,I=T+Mi(i,h+5,31)+1;h+=14;for(var b=new ui(I),E=new ui(19),w=0;w<C;++w)E[nv[w]]=Mi(i,h+w*3,7);h+=C*3;for(var O=lu(E),z=(1<<O)-1,V=Wo(E,O,1),w=0;w<I;){var W=V[Mi(i,h,z)];h+=W&15;var S=W>>4;if(S<16)b[w++]=S;else{var q=0,U=0;for(S==16?(U=3+Mi(i,h,3),h+=2,q=b[w-1]):S==17?(U=3+Mi(i,h,7),h+=3):S==18&&(U=11+Mi(i,h,127),h+=7);U--;)b[w++]=q}}var B=b.subarray(0,T),K=b.subarray(T);_=lu(B),m=lu(K),p=Wo(B,_,1),g=Wo(K,m,1)}else Si(1);else{var S=av(h)+4,x=i[S-4]|i[S-3]<<8,P=S+x;if(P>s){l&&Si(0);break}a&&c(f+x),t.set(i.subarray(S,P),f),e.b=f+=x,e.p=h=P*8,e.f=u;continue}if(h>d){l&&Si(0);break}}a&&c(f+131072);for(var ne=(1<<_)-1,ee=(1<<m)-1,le=h;;le=h){var q=p[cu(i,h)&ne],ce=q>>4;if(h+=q&15,h>d){l&&Si(0);break}if(q||Si(2),ce<256)t[f++]=ce;else if(ce==256){le=h,p=null;break}else{var ye=ce-254;if(ce>264){var w=ce-257,Re=np[w];ye=Mi(i,h,(1<<Re)-1)+op[w],h+=Re}var j=g[cu(i,h)&ee],X=j>>4;j||Si(3),h+=j&15;var K=sv[X];if(X>3){var Re=ip[X];K+=cu(i,h)&(1<<Re)-1,h+=Re}if(h>d){l&&Si(0);break}a&&c(f+131072);var de=f+ye;if(f<K){var Ae=r-K,xe=Math.min(K,de);for(Ae+f<0&&Si(3);f<xe;++f)t[f]=n[Ae+f]}for(;f<de;++f)t[f]=t[f-K]}}e.l=p,e.p=le,e.b=f,e.f=u,p&&(u=1,e.m=_,e.d=g,e.n=m)}while(!u);return f!=t.length&&o?lv(t,0,f):t.subarray(0,f)};var uv=new ui(0);var fv=function(i,e){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Si(6,"invalid zlib data"),(i[1]>>5&1)==+!e&&Si(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function cp(i,e){return hv(i.subarray(fv(i,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var dv=typeof TextDecoder<"u"&&new TextDecoder,pv=0;try{dv.decode(uv,{stream:!0}),pv=1}catch{}var hp=i=>Uint8Array.from(atob(i),e=>e.charCodeAt(0));function mv(i,e){let t=cp(hp(i.data));return i.columns.map(({low:n,step:s},r)=>{let o=2*e*r,a=new Float64Array(e);for(let l=0,c=0;l<e;l++)c=c+t[o+l]+256*t[o+e+l]&65535,a[l]=n+s*c;return a})}function up(i){let e=new Map;if(!i)return e;for(let t of["trajectory","telemetry"].filter(n=>i[n])){let n=i[t],s=new Float64Array(hp(n.t.data).buffer),r=null,o=[];n.columns.forEach(({name:a,unit:l,factor:c,group:u},h)=>e.set(a,{name:a,unit:l,group:u,t:s,held:t==="telemetry",words:i.words[a],get values(){return r??(r=mv(n,s.length)),r[h]},get shown(){return o[h]??(o[h]=c===1?this.values:this.values.map(f=>c*f)),o[h]}}))}return e}var gv={f4:Float32Array,f8:Float64Array,i4:Int32Array};function wn(i){let e=Uint8Array.from(atob(i.data),t=>t.charCodeAt(0));return new gv[i.type](e.buffer)}function fp(i){if(i.ready)return i;let e=wn(i.t),t=wn(i.force.at),n=new Int32Array(e.length).fill(-1);return t.forEach((s,r)=>n[s]=r),{...i,ready:!0,t:e,n:e.length,begin:e[0],end:e[e.length-1],position:wn(i.position),attitude:wn(i.attitude),armLength:wn(i.arm_length),thrust:wn(i.thrust),force:wn(i.force.of),point:wn(i.point.of),rows:n,series:i.series.map(s=>({...s,values:wn(s.values)})),signals:up(i.signals),every:i.signals?.telemetry?.every??1,shift:0}}function cl(i,e){let t=0,n=i.length-1;if(!(e>i[0]))return 0;for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return i[n]<=e?n:t}function qo(i,e){let t=Math.min(Math.max(e-i.shift,i.begin),i.end),n=cl(i.t,t),s=Math.min(n+1,i.n-1),r=s>n?(t-i.t[n])/(i.t[s]-i.t[n]):0,o=(m,d,M)=>m[n*d+M]*(1-r)+m[s*d+M]*r,a=(m,d)=>Array.from({length:d},(M,S)=>o(m,d,S)),l=i.arms.length,c=l+i.hull.length,u=a(i.attitude,4),h=0;for(let m=0;m<4;m++)h+=i.attitude[n*4+m]*i.attitude[s*4+m];if(h<0)for(let m=0;m<4;m++)u[m]=i.attitude[n*4+m];let f=Math.hypot(...u),p=i.rows[n],g=i.rows[s],_=[];for(let m=0;m<c;m++){let d=[0,0,0],M=null;for(let[x,P]of[[p,1-r],[g,r]]){if(x<0)continue;let T=(x*c+m)*3;for(let I=0;I<3;I++)d[I]+=P*i.force[T+I];let C=Array.from(i.point.subarray(T,T+3));C.some(I=>I!==0)&&(M=C)}let S=Math.hypot(...d);_.push(M&&S>1e-6?{force:d,size:S,point:M}:null)}return{t:t+i.shift,own:t,place:n,position:a(i.position,3),quaternion:u.map(m=>m/f),armLengths:a(i.armLength,l),thrust:a(i.thrust,l),contacts:_}}function Yo({flight:i,t:e=i.t,values:t,held:n=!1},s){let r=Math.min(Math.max(s-i.shift,e[0]),e[e.length-1]),o=cl(e,r),a=n?o:Math.min(o+1,e.length-1),l=a>o?(r-e[o])/(e[a]-e[o]):0;return t[o]*(1-l)+t[a]*l}var Or=i=>["est_x","est_qw"].every(e=>i.signals.has(e));function uu(i,e){let t=(r,o)=>{let a=i.signals.get(r);return a?Yo({flight:i,...a,values:a.values},e):o},n=["w","x","y","z"].map(r=>t(`est_q${r}`)),s=Math.hypot(...n)||1;return{own:Math.min(Math.max(e-i.shift,i.begin),i.end),position:["x","y","z"].map(r=>t(`est_${r}`)),quaternion:n.map(r=>r/s),armLengths:i.arms.map((r,o)=>t(`hall${o+1}`,r.length)),thrust:i.arms.map(()=>0),contacts:[]}}var Wi=i=>i.impacts.length?i.impacts[0][0]+i.shift:null,hl=i=>i.map(Wi).find(e=>e!==null)??null;function fu(i){let e=0;for(let t=0;t<i.force.length;t+=3)e=Math.max(e,Math.hypot(i.force[t],i.force[t+1],i.force[t+2]));return e}function dp(i){let e=i.arms.length+i.hull.length;return Float32Array.from(i.rows,t=>{let n=[0,0,0];for(let s=0;t>=0&&s<3*e;s++)n[s%3]+=i.force[t*e*3+s];return Math.hypot(...n)})}function du(i){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));return e*([5,2,1].find(t=>t*e<=i*1.0000001)??1)}var _v=.005,Br=[[],[7,3],[2,3],[9,3,2,3],[12,4],[4,2,1,2],[14,3,2,3],[3,6]],pp={"Arm compression":["largest",i=>Math.max(...i)],Thrust:["all rotors",i=>i.reduce((e,t)=>e+t,0)],Velocity:["speed",i=>i[0]],Energy:["motion",i=>i[0]],"Contact force":["sum of all contacts"]},js=i=>[...new Set(i.flatMap(e=>e.series.map(t=>t.panel)))],ul=i=>new Map(i.flatMap(e=>[...e.signals])),$o=i=>i.map(e=>Array.isArray(e)?e.join():e).join(";");function pu(i,e){let t=js(e),n=ul(e);return i.split(";").flatMap(s=>t.includes(s)?[s]:fl(s.split(",").filter(r=>n.has(r)),n))}function fl(i,e){let t=new Map;for(let n of new Set(i)){let{unit:s,words:r}=e.get(n),o=r?n:s;t.set(o,[...t.get(o)??[],n])}return[...t.values()]}function mp(i,e){return e.map(t=>Array.isArray(t)?xv(i,t):vv(i,t)).filter(t=>t.curves.length)}function vv(i,e){let t=Nn(),n=i.map(o=>o.series.filter(a=>a.panel===e)),s=i.length>1?n.flatMap((o,a)=>yv(e,o,i[a])):bv(n[0]);s.forEach((o,a)=>{o.flight??(o.flight=i[0]),o.t=o.flight.t,o.colour??(o.colour=t.arms[a%t.arms.length]),o.dash??(o.dash=Br[a%Br.length])});let r=i.length>1?pp[e]?.[0]:"";return{key:e,name:r?`${e}, ${r}`:e,unit:n.flat()[0]?.unit,own:null,curves:s}}function xv(i,e){let t=Nn(),n=ul(i),s=i.length>1,r=e.flatMap((c,u)=>i.flatMap(h=>{let f=h.signals.get(c);if(!f)return[];let{t:p,shown:g,held:_}=f,m=s&&e.length===1?h.index:u;return[{name:s?e.length===1?h.label:`${h.label}, ${c}`:c,flight:h,t:p,values:g,held:_,dash:Br[m%Br.length],colour:s?h.colour:t.arms[u%t.arms.length]}]})),o=e.map(c=>n.get(c)),a=new Set(o.map(c=>c?.group)),l=e.length===1?e[0]:a.size===1?o[0].group:e.slice(0,3).join(", ")+(e.length>3?", …":"");return{key:e.join(),name:l,unit:o[0]?.unit,own:e,words:o[0]?.words,curves:r}}function yv(i,e,t){if(!e.length)return[];let[,n]=pp[i]??["",r=>r[0]],s=i==="Contact force"?dp(t):Float32Array.from(e[0].values,(r,o)=>n(e.map(a=>a.values[o])));return[{name:t.label,values:s,flight:t,colour:t.colour,dash:Br[t.index%Br.length]}]}function bv(i){let e=[];for(let t of i){let n=t.values.reduce((r,o)=>Math.max(r,Math.abs(o)),0),s=e.find(r=>{let o=_v*Math.max(n,r.peak);return r.values.every((a,l)=>Math.abs(a-t.values[l])<=o)});s?s.names.push(t.name):e.push({names:[t.name],values:t.values,peak:n})}return e.map(({names:t,values:n})=>({name:Mv(t),values:n}))}function Mv(i){let e=i.map(t=>t.match(/^(.*?)\s*(\d+)$/));return i.length<2||e.some(t=>!t||t[1]!==e[0][1])?i.join(", "):`${e[0][1]} ${e.map(t=>t[2]).join(", ")}`}function gp({signals:i,standard:e,onChoose:t}){let n=G("input",{type:"search",placeholder:"est, N, phase, …","aria-label":"Search signals",oninput:M}),s=G("h2",{id:"chooser-title"}),r=G("span",{class:"count",role:"status"}),o=(T,C,I)=>G("label",{"data-words":`${T} ${C}`.toLowerCase()},G("input",{type:"checkbox",value:T,onchange:S}),T,...I?[G("small",{},I)]:[]),a=(T,...C)=>{let I=G("fieldset",{},G("legend",{},T),...C);return C.length>1&&I.firstChild.append(G("button",{type:"button",class:"small","aria-label":`All of ${T}, or none`,onclick:()=>{let b=[...I.querySelectorAll("label:not([hidden]) input")],E=!b.every(w=>w.checked);b.forEach(w=>w.checked=E),S()}},"all")),I},l=a("Standard plots",...e.map(T=>o(T,"standard"))),c=new Map;for(let{name:T,unit:C,group:I}of i.values()){let b=[I,C,C==="m/s²"?"acceleration":""].join(" ");c.set(I,[...c.get(I)??[],o(T,b,C)])}let u=G("div",{class:"signals"},l,...[...c].map(([T,C])=>a(T,...C))),h=G("p",{hidden:!0},"No signal of this flight matches."),f=G("form",{method:"dialog",onsubmit:x},s,G("p",{class:"hint"},"Signals of one unit share a plot. Names are those of the columns in the files of the result."),n,u,h,G("div",{class:"actions"},r,G("button",{type:"button",onclick:()=>(t(null),p.close())},"Only standard plots"),G("button",{type:"button",onclick:()=>p.close()},"Cancel"),G("button",{type:"submit",class:"main"},"Plot"))),p=G("dialog",{class:"chooser","aria-labelledby":"chooser-title"},f),g=[],_=null,m=T=>[...T.querySelectorAll("input[type=checkbox]:checked")].map(C=>C.value),d=()=>[...u.children].filter(T=>T!==l).flatMap(m);function M(){let T=n.value.toLowerCase().split(/\s+/).filter(Boolean);for(let C of u.children){let I=[...C.querySelectorAll("label")];I.forEach(b=>b.hidden=!T.every(E=>b.dataset.words.includes(E))),C.hidden=I.every(b=>b.hidden)||C===l&&_!==null}h.hidden=[...u.children].some(C=>!C.hidden)}function S(){let T=d(),C=fl(T,i).length;r.textContent=T.length?`${T.length} signal${T.length>1?"s":""} in ${C} plot${C>1?"s":""}`:""}function x(){let T=fl(d(),i);if(_!==null)t(g.flatMap((C,I)=>I===_?T:[C]));else{let C=m(l),I=g.filter(b=>Array.isArray(b)||C.includes(b));t([...I,...C.filter(b=>!g.includes(b)),...T])}}function P(T,C=null){[g,_]=[T,C];let I=C===null?T.filter(b=>!Array.isArray(b)):T[C];u.querySelectorAll("input").forEach(b=>b.checked=I.includes(b.value)),s.textContent=C===null?"Add plots":"Change a plot",n.value="",M(),S(),p.showModal(),n.focus()}return{element:p,open:P}}function dl(i,e){let t=()=>document.fullscreenElement?document.exitFullscreen():i().requestFullscreen().catch(e),n=G("button",{type:"button",class:"tool tool-full",hidden:!document.fullscreenEnabled,onclick:t},Gi("full"));function s(){let r=document.fullscreenElement?"Leave full screen":"Full screen";n.title=`${r} (F)`,n.setAttribute("aria-label",r)}return document.addEventListener("fullscreenchange",s),s(),{button:n,toggle:t}}function _p({read:i,apply:e}){let t=0,n=location.hash,s=()=>{let a=Object.entries(i()).filter(([,l])=>l!=="");return`#${new URLSearchParams(a)}`.replace(/%2C/g,",").replace(/%3B/g,";")};function r(){clearTimeout(t),n=s();try{history.replaceState(null,"",n)}catch{}}addEventListener("hashchange",()=>{location.hash!==n&&o()});function o(){e(Object.fromEntries(new URLSearchParams(location.hash.slice(1))))}return{follow:o,renew(){clearTimeout(t),t=setTimeout(r,250)},address(){return r(),location.href.replace(/#.*/,"")+n}}}function Sv(i){let e=[];for(let n of i)for(let[s,r]of n.impacts.slice(0,12)){let o=s+n.shift-.008;e.push([o,Math.min(r,s+.12)+n.shift+.02])}e.sort((n,s)=>n[0]-s[0]);let t=[];for(let n of e){let s=t[t.length-1];s&&n[0]<s[1]+2*.12?s[1]=Math.max(s[1],n[1]):t.push([...n])}return t.map(([n,s])=>[n,s,Math.min(1,Math.max(.005,(s-n)/3))])}function mu(i,e){let t=1;for(let[n,s,r]of i){let o=Math.max(n-e,e-s,0);o<.12&&(t=Math.min(t,r**((1+Math.cos(Math.PI*o/.12))/2)))}return t}function xp(i){let e=Math.min(...i.map(l=>l.begin+l.shift)),t=Math.max(...i.map(l=>l.end+l.shift)),n=Sv(i),s=new Set([e,t]);for(let l=1;l<200;l++)s.add(e+(t-e)*l/200);for(let[l,c]of n)for(let u=0;u<=60;u++)s.add(l-.12+(c-l+2*.12)*u/60),s.add(l+(c-l)*u/60),s.add(l-.12*u/60),s.add(c+.12*u/60);let r=[...s].filter(l=>l>=e&&l<=t).sort((l,c)=>l-c),o=[0];for(let l=1;l<r.length;l++){let c=Math.sqrt(mu(n,r[l-1])*mu(n,r[l]));o.push(o[l-1]+(r[l]-r[l-1])/c)}let a=o[o.length-1]||1;return{begin:e,end:t,stretches:n,total:a,paceAt:l=>mu(n,l),watchedAt:l=>vp(r,o,l),timeAt:l=>vp(o,r,l)}}function vp(i,e,t){let n=0,s=i.length-1;if(!(t>i[0]))return e[0];if(t>=i[s])return e[s];for(;s-n>1;){let r=n+s>>1;i[r]<=t?n=r:s=r}return e[n]+(e[s]-e[n])*(t-i[n])/(i[s]-i[n])}var wv="uplot",Ev="u-hz",Tv="u-vt",Av="u-title",Rv="u-wrap",Cv="u-under",Pv="u-over",Iv="u-axis",tr="u-off",Lv="u-select",Dv="u-cursor-x",Uv="u-cursor-y",Nv="u-cursor-pt",Fv="u-legend",Ov="u-live",Bv="u-inline",zv="u-series",kv="u-marker",yp="u-label",Hv="u-value",Ko="width",Jo="height";var bp="bottom",zr="left",gu="right",Du="#000",Mp=Du+"0",_u="mousemove",Sp="mousedown",vu="mouseup",wp="mouseenter",Ep="mouseleave",Tp="dblclick",Vv="resize",Gv="scroll",Ap="change",vl="dppxchange",Uu="--",qr=typeof window<"u",Su=qr?document:null,Hr=qr?window:null,Wv=qr?navigator:null,Et,pl;function wu(){let i=devicePixelRatio;Et!=i&&(Et=i,pl&&Tu(Ap,pl,wu),pl=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),nr(Ap,pl,wu),Hr.dispatchEvent(new CustomEvent(vl)))}function ei(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Eu(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Wt(i,e,t){i.style[e]=t+"px"}function wi(i,e,t,n){let s=Su.createElement(i);return e!=null&&ei(s,e),t?.insertBefore(s,n),s}function fi(i,e){return wi("div",i,e)}var Rp=new WeakMap;function Xi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Rp.get(i);r!=o&&(i.style.transform=r,Rp.set(i,r),e<0||t<0||e>n||t>s?ei(i,tr):Eu(i,tr))}var Cp=new WeakMap;function Pp(i,e,t){let n=e+t,s=Cp.get(i);n!=s&&(Cp.set(i,n),i.style.background=e,i.style.borderColor=t)}var Ip=new WeakMap;function Lp(i,e,t,n){let s=e+""+t,r=Ip.get(i);s!=r&&(Ip.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Nu={passive:!0},Xv={...Nu,capture:!0};function nr(i,e,t,n){e.addEventListener(i,t,n?Xv:Nu)}function Tu(i,e,t,n){e.removeEventListener(i,t,Nu)}qr&&wu();function Ei(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ti((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function om(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var am=i=>i!=null,lm=i=>i!=null&&i>0,bl=om(am),qv=om(lm);function Yv(i,e,t,n=0,s=!1){let r=s?qv:bl,o=s?lm:am;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ft,l??-Ft]}function Ml(i,e,t,n){let s=Np(i),r=Np(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?as:cm,a=s==1?ti:di,l=r==1?di:ti,c=a(o(rn(i))),u=l(o(rn(e))),h=Vr(t,c),f=Vr(t,u);return t==10&&(c<0&&(h=Ot(h,-c)),u<0&&(f=Ot(f,-u))),n||t==2?(i=h*s,e=f*r):(i=dm(i,h),e=Sl(e,f)),[i,e]}function Fu(i,e,t,n){let s=Ml(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Ou=.1,Dp={mode:3,pad:Ou},Qo={pad:0,soft:null,mode:0},$v={min:Qo,max:Qo};function xl(i,e,t,n){return wl(t)?Up(i,e,t):(Qo.pad=t,Qo.soft=n?0:null,Qo.mode=n?3:0,Up(i,e,$v))}function Mt(i,e){return i??e}function Zv(i,e,t){for(e=Mt(e,0),t=Mt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Up(i,e,t){let n=t.min,s=t.max,r=Mt(n.pad,0),o=Mt(s.pad,0),a=Mt(n.hard,-Ft),l=Mt(s.hard,Ft),c=Mt(n.soft,Ft),u=Mt(s.soft,-Ft),h=Mt(n.mode,0),f=Mt(s.mode,0),p=e-i,g=as(p),_=Fn(rn(i),rn(e)),m=as(_),d=rn(m-g);(p<1e-24||d>10)&&(p=0,(i==0||e==0)&&(p=1e-24,h==2&&c!=Ft&&(r=0),f==2&&u!=-Ft&&(o=0)));let M=p||_||1e3,S=as(M),x=Vr(10,ti(S)),P=M*(p==0?i==0?.1:1:r),T=Ot(dm(i-P,x/10),24),C=i>=c&&(h==1||h==3&&T<=c||h==2&&T>=c)?c:Ft,I=Fn(a,T<C&&i>=C?C:Ti(C,T)),b=M*(p==0?e==0?.1:1:o),E=Ot(Sl(e+b,x/10),24),w=e<=u&&(f==1||f==3&&E>=u||f==2&&E<=u)?u:-Ft,O=Ti(l,E>w&&e<=w?w:Fn(w,E));return I==O&&I==0&&(O=100),[I,O]}var Kv=new Intl.NumberFormat(qr?Wv.language:"en-US"),Bu=i=>Kv.format(i),ni=Math,_l=ni.PI,rn=ni.abs,ti=ni.floor,sn=ni.round,di=ni.ceil,Ti=ni.min,Fn=ni.max,Vr=ni.pow,Np=ni.sign,as=ni.log10,cm=ni.log2,Jv=(i,e=1)=>ni.sinh(i)*e,xu=(i,e=1)=>ni.asinh(i/e),Ft=1/0;function Fp(i){return(as((i^i>>31)-(i>>31))|0)+1}function Au(i,e,t){return Ti(Fn(i,e),t)}function hm(i){return typeof i=="function"}function _t(i){return hm(i)?i:()=>i}var jv=()=>{},um=i=>i,fm=(i,e)=>e,Qv=i=>null,Op=i=>!0,Bp=(i,e)=>i==e,ex=/\.\d*?(?=9{6,}|0{6,})/gm,ir=i=>{if(mm(i)||Rs.has(i))return i;let e=`${i}`,t=e.match(ex);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${ir(s)}e${r}`}return Ot(i,n)};function Qs(i,e){return ir(Ot(ir(i/e))*e)}function Sl(i,e){return ir(di(ir(i/e))*e)}function dm(i,e){return ir(ti(ir(i/e))*e)}function Ot(i,e=0){if(mm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return sn(n)/t}var Rs=new Map;function pm(i){return((""+i).split(".")[1]||"").length}function ta(i,e,t,n){let s=[],r=n.map(pm);for(let o=e;o<t;o++){let a=rn(o),l=Ot(Vr(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:Ot(u,h);s.push(f),Rs.set(f,h)}}return s}var ea={},zu=[],Gr=[null,null],As=Array.isArray,mm=Number.isInteger,tx=i=>i===void 0;function zp(i){return typeof i=="string"}function wl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function nx(i){return i!=null&&typeof i=="object"}var ix=Object.getPrototypeOf(Uint8Array),gm="__proto__";function Wr(i,e=wl){let t;if(As(i)){let n=i.find(s=>s!=null);if(As(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Wr(i[s],e)}else t=i.slice()}else if(i instanceof ix)t=i.slice();else if(e(i)){t={};for(let n in i)n!=gm&&(t[n]=Wr(i[n],e))}else t=i;return t}function Qt(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=gm&&(wl(i[s])?Qt(i[s],Wr(n[s])):i[s]=Wr(n[s]))}return i}var sx=0,rx=1,ox=2;function ax(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function lx(i,e){if(ux(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return fx(o[0])||(o=hx(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:rx,p=[];for(let g=0;g<u.length;g++){let _=u[g],m=r.get(l[g]);_===null?f!=sx&&(h[m]=_,f==ox&&p.push(m)):h[m]=_}ax(h,p,s),n.push(h)}}return n}var cx=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function hx(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function ux(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function fx(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Fn(1,ti((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var _m=["January","February","March","April","May","June","July","August","September","October","November","December"],vm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function xm(i){return i.slice(0,3)}var dx=vm.map(xm),px=_m.map(xm),mx={MMMM:_m,MMM:px,WWWW:vm,WWW:dx};function Zo(i){return(i<10?"0":"")+i}function gx(i){return(i<10?"00":i<100?"0":"")+i}var _x={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Zo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Zo(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Zo(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Zo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Zo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>gx(i.getMilliseconds())};function ku(i,e){e=e||mx;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?_x[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var vx=new Intl.DateTimeFormat().resolvedOptions().timeZone;function xx(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==vx?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var ym=i=>i%1==0,yl=[1,2,2.5,5],yx=ta(10,-32,0,yl),bm=ta(10,0,32,yl),bx=bm.filter(ym),er=yx.concat(bm),Hu=`
`,Mm="{YYYY}",kp=Hu+Mm,Sm="{M}/{D}",jo=Hu+Sm,ml=jo+"/{YY}",wm="{aa}",Mx="{h}:{mm}",kr=Mx+wm,Hp=Hu+kr,Vp=":{ss}",Tt=null;function Em(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?ta(10,0,3,yl).filter(ym):ta(10,-3,0,yl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Mm,Tt,Tt,Tt,Tt,Tt,Tt,1],[s*28,"{MMM}",kp,Tt,Tt,Tt,Tt,Tt,1],[s,Sm,kp,Tt,Tt,Tt,Tt,Tt,1],[n,"{h}"+wm,ml,Tt,jo,Tt,Tt,Tt,1],[t,kr,ml,Tt,jo,Tt,Tt,Tt,1],[e,Vp,ml+" "+kr,Tt,jo+" "+kr,Tt,Hp,Tt,1],[i,Vp+".{fff}",ml+" "+kr,Tt,jo+" "+kr,Tt,Hp,Tt,1]];function u(h){return(f,p,g,_,m,d)=>{let M=[],S=m>=o,x=m>=r&&m<o,P=h(g),T=Ot(P*i,3),C=yu(P.getFullYear(),S?0:P.getMonth(),x||S?1:P.getDate()),I=Ot(C*i,3);if(x||S){let b=x?m/r:0,E=S?m/o:0,w=T==I?T:Ot(yu(C.getFullYear()+E,C.getMonth()+b,1)*i,3),O=new Date(sn(w/i)),z=O.getFullYear(),V=O.getMonth();for(let W=0;w<=_;W++){let q=yu(z+E*W,V+b*W,1),U=q-h(Ot(q*i,3));w=Ot((+q+U)*i,3),w<=_&&M.push(w)}}else{let b=m>=s?s:m,E=ti(g)-ti(T),w=I+E+Sl(T-I,b);M.push(w);let O=h(w),z=O.getHours()+O.getMinutes()/t+O.getSeconds()/n,V=m/n,W=f.axes[p]._space,q=d/W;for(;w=Ot(w+m,i==1?0:3),!(w>_);)if(V>1){let U=ti(Ot(z+V,6))%24,ne=h(w).getHours()-U;ne>1&&(ne=-1),w-=ne*n,z=(z+V)%24;let ee=M[M.length-1];Ot((w-ee)/m,3)*q>=.7&&M.push(w)}else M.push(w)}return M}}return[l,c,u]}var[Sx,wx,Ex]=Em(1),[Tx,Ax,Rx]=Em(.001);ta(2,-53,53,[1]);function Gp(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Wp(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,f,p;return n.map(g=>{let _=i(g),m=_.getFullYear(),d=_.getMonth(),M=_.getDate(),S=_.getHours(),x=_.getMinutes(),P=_.getSeconds(),T=m!=l&&a[2]||d!=c&&a[3]||M!=u&&a[4]||S!=h&&a[5]||x!=f&&a[6]||P!=p&&a[7]||a[1];return l=m,c=d,u=M,h=S,f=x,p=P,T(_)})}}function Cx(i,e){let t=ku(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function yu(i,e,t){return new Date(i,e,t)}function Xp(i,e){return e(i)}var Px="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function qp(i,e){return(t,n,s,r)=>r==null?Uu:e(i(n))}function Ix(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function Lx(i,e){return i.series[e].fill(i,e)}var Dx={show:!0,live:!0,isolate:!1,mount:jv,markers:{show:!0,width:2,stroke:Ix,fill:Lx,dash:"solid"},idx:null,idxs:null,values:[]};function Ux(i,e){let t=i.cursor.points,n=fi(),s=t.size(i,e);Wt(n,Ko,s),Wt(n,Jo,s);let r=s/-2;Wt(n,"marginLeft",r),Wt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Wt(n,"borderWidth",o),n}function Nx(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Fx(i,e){let t=i.series[e].points;return t._stroke||t._fill}function Ox(i,e){return i.series[e].points.size}var bu=[0,0];function Bx(i,e,t){return bu[0]=e,bu[1]=t,bu}function gl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Mu(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var zx={show:!0,x:!0,y:!0,lock:!1,move:Bx,points:{one:!1,show:Ux,size:Ox,width:0,stroke:Fx,fill:Nx},bind:{mousedown:gl,mouseup:gl,click:gl,dblclick:gl,mousemove:Mu,mouseleave:Mu,mouseenter:Mu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Tm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Vu=Qt({},Tm,{filter:fm}),Am=Qt({},Vu,{size:10}),Rm=Qt({},Tm,{show:!1}),Gu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Cm="bold "+Gu,Pm=1.5,Yp={show:!0,scale:"x",stroke:Du,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Cm,side:2,grid:Vu,ticks:Am,border:Rm,font:Gu,lineGap:Pm,rotate:0},kx="Value",Hx="Time",$p={show:!0,scale:"x",auto:!1,sorted:1,min:Ft,max:-Ft,idxs:[]};function Vx(i,e,t,n,s){return e.map(r=>r==null?"":Bu(r))}function Gx(i,e,t,n,s,r,o){let a=[],l=Rs.get(s)||0;t=o?t:Ot(Sl(t,s),l);for(let c=t;c<=n;c=Ot(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Ru(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?as:cm,u=ti(c(t));s=Vr(l,u),l==10&&(s=er[Ei(s,er)]);let h=t,f=s*l;l==10&&(f=er[Ei(f,er)]);do a.push(h),h=h+s,l==10&&!Rs.has(h)&&(h=Ot(h,Rs.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=er[Ei(f,er)]));while(h<=n);return a}function Wx(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Ru(i,e,Fn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?Ru(i,e,Fn(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var Im=/./,Xx=/[12357]/,qx=/[125]/,Zp=/1/,Cu=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Yx(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Im:l(7,o)-u>=c?Xx:l(5,o)-u>=c?qx:Zp;if(h==Zp){let f=rn(l(1,o)-u);if(f<c)return Cu(e.slice().reverse(),a.distr,h,di(c/f)).reverse()}return Cu(e,a.distr,h,1)}function $x(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=rn(l(1,o)-l(2,o));return c<a?Cu(e.slice().reverse(),3,Im,di(a/c)).reverse():e}function Zx(i,e,t,n){return n==null?Uu:e==null?"":Bu(e)}var Kp={show:!0,scale:"y",stroke:Du,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Cm,side:3,grid:Vu,ticks:Am,border:Rm,font:Gu,lineGap:Pm,rotate:0};function Kx(i,e){let t=3+(i||1)*2;return Ot(t*e,3)}function Jx(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=rn(o-r),l=i.series[e],c=a/(l.points.space*Et);return n[1]-n[0]<=c}var Jp={scale:null,auto:!0,sorted:0,min:Ft,max:-Ft},Lm=(i,e,t,n,s)=>s,jp={show:!0,auto:!0,sorted:0,gaps:Lm,alpha:1,facets:[Qt({},Jp,{scale:"x"}),Qt({},Jp,{scale:"y"})]},Qp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Lm,alpha:1,points:{show:Jx,filter:null},values:null,min:Ft,max:-Ft,idxs:[],path:null,clip:null};function jx(i,e,t,n,s){return t/10}var Dm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Qx=Qt({},Dm,{time:!1,ori:1}),em={};function Um(i,e){let t=em[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(em[i]=t)),t}var Xr=1,Pu=2;function sr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,g=a.width,_=a.height,m=i.valToPosH,d=i.valToPosV;return u.ori==0?t(s,l,c,u,h,m,d,f,p,g,_,Tl,Yr,Rl,Fm,Bm):t(s,l,c,u,h,d,m,p,f,_,g,Al,$r,qu,Om,zm)}function Wu(i,e){let t=0,n=0,s=Mt(i.bands,zu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function ey(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ls(i,e,t,n,s,r){return sr(i,e,(o,a,l,c,u,h,f,p,g,_,m)=>{let d=o.pxRound,M=c.dir*(c.ori==0?1:-1),S=c.ori==0?Yr:$r,x,P;M==1?(x=t,P=n):(x=n,P=t);let T=d(h(a[x],c,_,p)),C=d(f(l[x],u,m,g)),I=d(h(a[P],c,_,p)),b=d(f(r==1?u.max:u.min,u,m,g)),E=new Path2D(s);return S(E,I,b),S(E,T,b),S(E,T,C),E})}function El(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Rl:qu,l=t;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,n,p,n+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function ty(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Xu(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=r(i[h]),g=f==h?p:r(i[f]),_=h-s;p=o<=0&&_>=0&&_<l?r(i[_]):p;let d=f+s;g=o>=0&&d>=0&&d<l?r(i[d]):g,g>=p&&a.push([p,g])}return a}function tm(i){return i==0?um:i==1?sn:e=>Qs(e,i)}function Nm(i){let e=i==0?Tl:Al,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=Ti(c,a/2,l/2),u=Ti(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Tl=(i,e,t)=>{i.moveTo(e,t)},Al=(i,e,t)=>{i.moveTo(t,e)},Yr=(i,e,t)=>{i.lineTo(e,t)},$r=(i,e,t)=>{i.lineTo(t,e)},Rl=Nm(0),qu=Nm(1),Fm=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Om=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Bm=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},zm=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function km(i){return(e,t,n,s,r)=>sr(e,t,(o,a,l,c,u,h,f,p,g,_,m)=>{let{pxRound:d,points:M}=o,S,x;c.ori==0?(S=Tl,x=Fm):(S=Al,x=Om);let P=Ot(M.width*Et,3),T=(M.size-M.width)/2*Et,C=Ot(T*2,3),I=new Path2D,b=new Path2D,{left:E,top:w,width:O,height:z}=e.bbox;Rl(b,E-C,w-C,O+C*2,z+C*2);let V=W=>{if(l[W]!=null){let q=d(h(a[W],c,_,p)),U=d(f(l[W],u,m,g));S(I,q+T,U),x(I,q,U,T,0,_l*2)}};if(r)r.forEach(V);else for(let W=n;W<=s;W++)V(W);return{stroke:P>0?I:null,fill:I,clip:b,flags:Xr|Pu}})}function Hm(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var ny=Hm(Yr),iy=Hm($r);function Vm(i){let e=Mt(i?.alignGaps,0);return(t,n,s,r)=>sr(t,n,(o,a,l,c,u,h,f,p,g,_,m)=>{[s,r]=bl(l,s,r);let d=o.pxRound,M=z=>d(h(z,c,_,p)),S=z=>d(f(z,u,m,g)),x,P;c.ori==0?(x=Yr,P=ny):(x=$r,P=iy);let T=c.dir*(c.ori==0?1:-1),C={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xr},I=C.stroke,b=!1;if(r-s>=_*4){let z=ce=>t.posToVal(ce,c.key,!0),V=null,W=null,q,U,B,K=M(a[T==1?s:r]),ne=M(a[s]),ee=M(a[r]),le=z(T==1?ne+1:ee-1);for(let ce=T==1?s:r;ce>=s&&ce<=r;ce+=T){let ye=a[ce],j=(T==1?ye<le:ye>le)?K:M(ye),X=l[ce];j==K?X!=null?(U=X,V==null?(x(I,j,S(U)),q=V=W=U):U<V?V=U:U>W&&(W=U)):X===null&&(b=!0):(V!=null&&P(I,K,S(V),S(W),S(q),S(U)),X!=null?(U=X,x(I,j,S(U)),V=W=q=U):(V=W=null,X===null&&(b=!0)),K=j,le=z(K+T))}V!=null&&V!=W&&B!=K&&P(I,K,S(V),S(W),S(q),S(U))}else for(let z=T==1?s:r;z>=s&&z<=r;z+=T){let V=l[z];V===null?b=!0:V!=null&&x(I,M(a[z]),S(V))}let[w,O]=Wu(t,n);if(o.fill!=null||w!=0){let z=C.fill=new Path2D(I),V=o.fillTo(t,n,o.min,o.max,w),W=S(V),q=M(a[s]),U=M(a[r]);T==-1&&([U,q]=[q,U]),x(z,U,W),x(z,q,W)}if(!o.spanGaps){let z=[];b&&z.push(...Xu(a,l,s,r,T,M,e)),C.gaps=z=o.gaps(t,n,s,r,z),C.clip=El(z,c.ori,p,g,_,m)}return O!=0&&(C.band=O==2?[ls(t,n,s,r,I,-1),ls(t,n,s,r,I,1)]:ls(t,n,s,r,I,O)),C})}function sy(i){let e=Mt(i.align,1),t=Mt(i.ascDesc,!1),n=Mt(i.alignGaps,0),s=Mt(i.extend,!1);return(r,o,a,l)=>sr(r,o,(c,u,h,f,p,g,_,m,d,M,S)=>{[a,l]=bl(h,a,l);let x=c.pxRound,{left:P,width:T}=r.bbox,C=ne=>x(g(ne,f,M,m)),I=ne=>x(_(ne,p,S,d)),b=f.ori==0?Yr:$r,E={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xr},w=E.stroke,O=f.dir*(f.ori==0?1:-1),z=I(h[O==1?a:l]),V=C(u[O==1?a:l]),W=V,q=V;s&&e==-1&&(q=P,b(w,q,z)),b(w,V,z);for(let ne=O==1?a:l;ne>=a&&ne<=l;ne+=O){let ee=h[ne];if(ee==null)continue;let le=C(u[ne]),ce=I(ee);e==1?b(w,le,z):b(w,W,ce),b(w,le,ce),z=ce,W=le}let U=W;s&&e==1&&(U=P+T,b(w,U,z));let[B,K]=Wu(r,o);if(c.fill!=null||B!=0){let ne=E.fill=new Path2D(w),ee=c.fillTo(r,o,c.min,c.max,B),le=I(ee);b(ne,U,le),b(ne,q,le)}if(!c.spanGaps){let ne=[];ne.push(...Xu(u,h,a,l,O,C,n));let ee=c.width*Et/2,le=t||e==1?ee:-ee,ce=t||e==-1?-ee:ee;ne.forEach(ye=>{ye[0]+=le,ye[1]+=ce}),E.gaps=ne=c.gaps(r,o,a,l,ne),E.clip=El(ne,f.ori,m,d,M,S)}return K!=0&&(E.band=K==2?[ls(r,o,a,l,w,-1),ls(r,o,a,l,w,1)]:ls(r,o,a,l,w,K)),E})}function nm(i,e,t,n,s,r,o=Ft){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=rn(i[l]-i[a]);u<c&&(c=u,o=rn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function ry(i){i=i||ea;let e=Mt(i.size,[.6,Ft,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_t(s),o=1-e[0],a=Mt(e[1],Ft),l=Mt(e[2],1),c=Mt(i.disp,ea),u=Mt(i.each,p=>{}),{fill:h,stroke:f}=c;return(p,g,_,m)=>sr(p,g,(d,M,S,x,P,T,C,I,b,E,w)=>{let O=d.pxRound,z=t,V=n*Et,W=a*Et,q=l*Et,U,B;x.ori==0?[U,B]=r(p,g):[B,U]=r(p,g);let K=x.dir*(x.ori==0?1:-1),ne=x.ori==0?Rl:qu,ee=x.ori==0?u:(H,re,pe,he,He,Me,Ve)=>{u(H,re,pe,He,he,Ve,Me)},le=Mt(p.bands,zu).find(H=>H.series[0]==g),ce=le!=null?le.dir:0,ye=d.fillTo(p,g,d.min,d.max,ce),Re=O(C(ye,P,w,b)),j,X,de,Ae=E,xe=O(d.width*Et),Ke=!1,mt=null,k=null,ue=null,Q=null;h!=null&&(xe==0||f!=null)&&(Ke=!0,mt=h.values(p,g,_,m),k=new Map,new Set(mt).forEach(H=>{H!=null&&k.set(H,new Path2D)}),xe>0&&(ue=f.values(p,g,_,m),Q=new Map,new Set(ue).forEach(H=>{H!=null&&Q.set(H,new Path2D)})));let{x0:se,size:fe}=c;if(se!=null&&fe!=null){z=1,M=se.values(p,g,_,m),se.unit==2&&(M=M.map(pe=>p.posToVal(I+pe*E,x.key,!0)));let H=fe.values(p,g,_,m);fe.unit==2?X=H[0]*E:X=T(H[0],x,E,I)-T(0,x,E,I),Ae=nm(M,S,T,x,E,I,Ae),de=Ae-X+V}else Ae=nm(M,S,T,x,E,I,Ae),de=Ae*o+V,X=Ae-de;de<1&&(de=0),xe>=X/2&&(xe=0),de<5&&(O=um);let Pe=de>0,te=Ae-de-(Pe?xe:0);X=O(Au(te,q,W)),j=(z==0?X/2:z==K?0:X)-z*K*((z==0?V/2:0)+(Pe?xe/2:0));let ve={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Ne=Ke?null:new Path2D,Ye=null;if(le!=null)Ye=p.data[le.series[1]];else{let{y0:H,y1:re}=c;H!=null&&re!=null&&(S=re.values(p,g,_,m),Ye=H.values(p,g,_,m))}let L=U*X,y=B*X;for(let H=K==1?_:m;H>=_&&H<=m;H+=K){let re=S[H];if(re==null)continue;if(Ye!=null){let Ie=Ye[H]??0;if(re-Ie==0)continue;Re=C(Ie,P,w,b)}let pe=x.distr!=2||c!=null?M[H]:H,he=T(pe,x,E,I),He=C(Mt(re,ye),P,w,b),Me=O(he-j),Ve=O(Fn(He,Re)),Oe=O(Ti(He,Re)),ge=Ve-Oe;if(re!=null){let Ie=re<0?y:L,Ze=re<0?L:y;Ke?(xe>0&&ue[H]!=null&&ne(Q.get(ue[H]),Me,Oe+ti(xe/2),X,Fn(0,ge-xe),Ie,Ze),mt[H]!=null&&ne(k.get(mt[H]),Me,Oe+ti(xe/2),X,Fn(0,ge-xe),Ie,Ze)):ne(Ne,Me,Oe+ti(xe/2),X,Fn(0,ge-xe),Ie,Ze),ee(p,g,H,Me-xe/2,Oe,X+xe,ge)}}return xe>0?ve.stroke=Ke?Q:Ne:Ke||(ve._fill=d.width==0?d._fill:d._stroke??d._fill,ve.width=0),ve.fill=Ke?k:Ne,ve})}function oy(i,e){let t=Mt(e?.alignGaps,0);return(n,s,r,o)=>sr(n,s,(a,l,c,u,h,f,p,g,_,m,d)=>{[r,o]=bl(c,r,o);let M=a.pxRound,S=U=>M(f(U,u,m,g)),x=U=>M(p(U,h,d,_)),P,T,C;u.ori==0?(P=Tl,C=Yr,T=Bm):(P=Al,C=$r,T=zm);let I=u.dir*(u.ori==0?1:-1),b=S(l[I==1?r:o]),E=b,w=[],O=[];for(let U=I==1?r:o;U>=r&&U<=o;U+=I)if(c[U]!=null){let K=l[U],ne=S(K);w.push(E=ne),O.push(x(c[U]))}let z={stroke:i(w,O,P,C,T,M),fill:null,clip:null,band:null,gaps:null,flags:Xr},V=z.stroke,[W,q]=Wu(n,s);if(a.fill!=null||W!=0){let U=z.fill=new Path2D(V),B=a.fillTo(n,s,a.min,a.max,W),K=x(B);C(U,E,K),C(U,b,K)}if(!a.spanGaps){let U=[];U.push(...Xu(l,c,r,o,I,S,t)),z.gaps=U=a.gaps(n,s,r,o,U),z.clip=El(U,u.ori,g,_,m,d)}return q!=0&&(z.band=q==2?[ls(n,s,r,o,V,-1),ls(n,s,r,o,V,1)]:ls(n,s,r,o,V,q)),z})}function ay(i){return oy(ly,i)}function ly(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,e[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,i[f+1],e[f+1])}return a}var Iu=new Set;function im(){for(let i of Iu)i.syncRect(!0)}qr&&(nr(Vv,Hr,im),nr(Gv,Hr,im,!0),nr(vl,Hr,()=>{$t.pxRatio=Et}));var cy=Vm(),hy=km();function sm(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Lu(r,o,e,t))}function uy(i,e){return i.map((t,n)=>n==0?{}:Qt({},e,t))}function Lu(i,e,t,n){return Qt({},e==0?t:n,i)}function Gm(i,e,t){return e==null?Gr:[e,t]}var fy=Gm;function dy(i,e,t){return e==null?Gr:xl(e,t,Ou,!0)}function Wm(i,e,t,n){return e==null?Gr:Ml(e,t,i.scales[n].log,!1)}var py=Wm;function Xm(i,e,t,n){return e==null?Gr:Fu(e,t,i.scales[n].log,!1)}var my=Xm;function gy(i,e,t,n,s){let r=Fn(Fp(i),Fp(e)),o=e-i,a=Ei(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Rs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function rm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=sn((t=+s)*Et))+"px"),[i,e,t]}function _y(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ot(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function $t(i,e,t){let n={mode:Mt(i.mode,1)},s=n.mode;function r(v,A,D,F){let $=A.valToPct(v);return F+D*(A.dir==-1?1-$:$)}function o(v,A,D,F){let $=A.valToPct(v);return F+D*(A.dir==-1?$:1-$)}function a(v,A,D,F){return A.ori==0?r(v,A,D,F):o(v,A,D,F)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=fi(wv);if(i.id!=null&&(c.id=i.id),ei(c,i.class),i.title){let v=fi(Av,c);v.textContent=i.title}let u=wi("canvas"),h=n.ctx=u.getContext("2d"),f=fi(Rv,c);nr("click",f,v=>{v.target===g&&(Ht!=Ir||Yt!=Lr)&&xn.click(n,v)},!0);let p=n.under=fi(Cv,f);f.appendChild(u);let g=n.over=fi(Pv,f);i=Wr(i);let _=+Mt(i.pxAlign,1),m=tm(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let d=i.ms||.001,M=n.series=s==1?sm(i.series||[],$p,Qp,!1):uy(i.series||[null],jp),S=n.axes=sm(i.axes||[],Yp,Kp,!0),x=n.scales={},P=n.bands=i.bands||[];P.forEach(v=>{v.fill=_t(v.fill||null),v.dir=Mt(v.dir,-1)});let T=s==2?M[1].facets[0].scale:M[0].scale,C={axes:D_,series:$s},I=(i.drawOrder||["axes","series"]).map(v=>C[v]);function b(v){let A=v.distr==3?D=>as(D>0?D:v.clamp(n,D,v.min,v.max,v.key)):v.distr==4?D=>xu(D,v.asinh):v.distr==100?D=>v.fwd(D):D=>D;return D=>{let F=A(D),{_min:$,_max:ie}=v,me=ie-$;return(F-$)/me}}function E(v){let A=x[v];if(A==null){let D=(i.scales||ea)[v]||ea;if(D.from!=null){E(D.from);let F=Qt({},x[D.from],D,{key:v});F.valToPct=b(F),x[v]=F}else{A=x[v]=Qt({},v==T?Dm:Qx,D),A.key=v;let F=A.time,$=A.range,ie=As($);if((v!=T||s==2&&!F)&&(ie&&($[0]==null||$[1]==null)&&($={min:$[0]==null?Dp:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?Dp:{mode:1,hard:$[1],soft:$[1]}},ie=!1),!ie&&wl($))){let me=$;$=(be,Ce,ze)=>Ce==null?Gr:xl(Ce,ze,me)}A.range=_t($||(F?fy:v==T?A.distr==3?py:A.distr==4?my:Gm:A.distr==3?Wm:A.distr==4?Xm:dy)),A.auto=_t(ie?!1:A.auto),A.clamp=_t(A.clamp||jx),A._min=A._max=null,A.valToPct=b(A)}}}E("x"),E("y"),s==1&&M.forEach(v=>{E(v.scale)}),S.forEach(v=>{E(v.scale)});for(let v in i.scales)E(v);let w=x[T],O=w.distr,z,V;w.ori==0?(ei(c,Ev),z=r,V=o):(ei(c,Tv),z=o,V=r);let W={};for(let v in x){let A=x[v];(A.min!=null||A.max!=null)&&(W[v]={min:A.min,max:A.max},A.min=A.max=null)}let q=i.tzDate||(v=>new Date(sn(v/d))),U=i.fmtDate||ku,B=d==1?Ex(q):Rx(q),K=Wp(q,Gp(d==1?wx:Ax,U)),ne=qp(q,Xp(Px,U)),ee=[],le=n.legend=Qt({},Dx,i.legend),ce=n.cursor=Qt({},zx,{drag:{y:s==2}},i.cursor),ye=le.show,Re=ce.show,j=le.markers;le.idxs=ee,j.width=_t(j.width),j.dash=_t(j.dash),j.stroke=_t(j.stroke),j.fill=_t(j.fill);let X,de,Ae,xe=[],Ke=[],mt,k=!1,ue={};if(le.live){let v=M[1]?M[1].values:null;k=v!=null,mt=k?v(n,1,0):{_:0};for(let A in mt)ue[A]=Uu}if(ye)if(X=wi("table",Fv,c),Ae=wi("tbody",null,X),le.mount(n,X),k){de=wi("thead",null,X,Ae);let v=wi("tr",null,de);wi("th",null,v);for(var Q in mt)wi("th",yp,v).textContent=Q}else ei(X,Bv),le.live&&ei(X,Ov);let se={show:!0},fe={show:!1};function Pe(v,A){if(A==0&&(k||!le.live||s==2))return Gr;let D=[],F=wi("tr",zv,Ae,Ae.childNodes[A]);ei(F,v.class),v.show||ei(F,tr);let $=wi("th",null,F);if(j.show){let be=fi(kv,$);if(A>0){let Ce=j.width(n,A);Ce&&(be.style.border=Ce+"px "+j.dash(n,A)+" "+j.stroke(n,A)),be.style.background=j.fill(n,A)}}let ie=fi(yp,$);v.label instanceof HTMLElement?ie.appendChild(v.label):ie.textContent=v.label,A>0&&(j.show||(ie.style.color=v.width>0?j.stroke(n,A):j.fill(n,A)),ve("click",$,be=>{if(ce._lock)return;vn(be);let Ce=M.indexOf(v);if((be.ctrlKey||be.metaKey)!=le.isolate){let ze=M.some((ke,Xe)=>Xe>0&&Xe!=Ce&&ke.show);M.forEach((ke,Xe)=>{Xe>0&&zi(Xe,ze?Xe==Ce?se:fe:se,!0,jt.setSeries)})}else zi(Ce,{show:!v.show},!0,jt.setSeries)},!1),Vn&&ve(wp,$,be=>{ce._lock||(vn(be),zi(M.indexOf(v),Ur,!0,jt.setSeries))},!1));for(var me in mt){let be=wi("td",Hv,F);be.textContent="--",D.push(be)}return[F,D]}let te=new Map;function ve(v,A,D,F=!0){let $=te.get(A)||{},ie=ce.bind[v](n,A,D,F);ie&&(nr(v,A,$[v]=ie),te.set(A,$))}function Ne(v,A,D){let F=te.get(A)||{};for(let $ in F)(v==null||$==v)&&(Tu($,A,F[$]),delete F[$]);v==null&&te.delete(A)}let Ye=0,L=0,y=0,H=0,re=0,pe=0,he=re,He=pe,Me=y,Ve=H,Oe=0,ge=0,Ie=0,Ze=0;n.bbox={};let $e=!1,De=!1,it=!1,Y=!1,we=!1,Te=!1;function Ge(v,A,D){(D||v!=n.width||A!=n.height)&&Se(v,A),Ar(!1),it=!0,De=!0,Rr()}function Se(v,A){n.width=Ye=y=v,n.height=L=H=A,re=pe=0,It(),xt();let D=n.bbox;Oe=D.left=Qs(re*Et,.5),ge=D.top=Qs(pe*Et,.5),Ie=D.width=Qs(y*Et,.5),Ze=D.height=Qs(H*Et,.5)}let _e=3;function qe(){let v=!1,A=0;for(;!v;){A++;let D=I_(A),F=L_(A);v=A==_e||D&&F,v||(Se(n.width,n.height),De=!0)}}function rt({width:v,height:A}){Ge(v,A)}n.setSize=rt;function It(){let v=!1,A=!1,D=!1,F=!1;S.forEach(($,ie)=>{if($.show&&$._show){let{side:me,_size:be}=$,Ce=me%2,ze=$.label!=null?$.labelSize:0,ke=be+ze;ke>0&&(Ce?(y-=ke,me==3?(re+=ke,F=!0):D=!0):(H-=ke,me==0?(pe+=ke,v=!0):A=!0))}}),ss[0]=v,ss[1]=D,ss[2]=A,ss[3]=F,y-=Bi[1]+Bi[3],re+=Bi[3],H-=Bi[2]+Bi[0],pe+=Bi[0]}function xt(){let v=re+y,A=pe+H,D=re,F=pe;function $(ie,me){switch(ie){case 1:return v+=me,v-me;case 2:return A+=me,A-me;case 3:return D-=me,D+me;case 0:return F-=me,F+me}}S.forEach((ie,me)=>{if(ie.show&&ie._show){let be=ie.side;ie._pos=$(be,ie._size),ie.label!=null&&(ie._lpos=$(be,ie.labelSize))}})}if(ce.dataIdx==null){let v=ce.hover,A=v.skip=new Set(v.skip??[]);A.add(void 0);let D=v.prox=_t(v.prox),F=v.bias??(v.bias=0);ce.dataIdx=($,ie,me,be)=>{if(ie==0)return me;let Ce=me,ze=D($,ie,me,be)??Ft,ke=ze>=0&&ze<Ft,Xe=w.ori==0?y:H,ot=ce.left,St=e[0],bt=e[ie];if(A.has(bt[me])){Ce=null;let dt=null,nt=null,je;if(F==0||F==-1)for(je=me;dt==null&&je-- >0;)A.has(bt[je])||(dt=je);if(F==0||F==1)for(je=me;nt==null&&je++<bt.length;)A.has(bt[je])||(nt=je);if(dt!=null||nt!=null)if(ke){let Gt=dt==null?-1/0:z(St[dt],w,Xe,0),Zt=nt==null?1/0:z(St[nt],w,Xe,0),mn=ot-Gt,Lt=Zt-ot;mn<=Lt?mn<=ze&&(Ce=dt):Lt<=ze&&(Ce=nt)}else Ce=nt==null?dt:dt==null?nt:me-dt<=nt-me?dt:nt}else ke&&rn(ot-z(St[me],w,Xe,0))>ze&&(Ce=null);return Ce}}let vn=v=>{ce.event=v};ce.idxs=ee,ce._lock=!1;let Nt=ce.points;Nt.show=_t(Nt.show),Nt.size=_t(Nt.size),Nt.stroke=_t(Nt.stroke),Nt.width=_t(Nt.width),Nt.fill=_t(Nt.fill);let Kn=n.focus=Qt({},i.focus||{alpha:.3},ce.focus),Vn=Kn.prox>=0,Oi=Vn&&Nt.one,Cn=[],is=[],vi=[];function Bo(v,A){let D=Nt.show(n,A);if(D instanceof HTMLElement)return ei(D,Nv),ei(D,v.class),Xi(D,-10,-10,y,H),g.insertBefore(D,Cn[A]),D}function qs(v,A){if(s==1||A>0){let D=s==1&&x[v.scale].time,F=v.value;v.value=D?zp(F)?qp(q,Xp(F,U)):F||ne:F||Zx,v.label=v.label||(D?Hx:kx)}if(Oi||A>0){v.width=v.width==null?1:v.width,v.paths=v.paths||cy||Qv,v.fillTo=_t(v.fillTo||ey),v.pxAlign=+Mt(v.pxAlign,_),v.pxRound=tm(v.pxAlign),v.stroke=_t(v.stroke||null),v.fill=_t(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let D=Kx(Fn(1,v.width),1),F=v.points=Qt({},{size:D,width:Fn(1,D*.2),stroke:v.stroke,space:D*2,paths:hy,_stroke:null,_fill:null},v.points);F.show=_t(F.show),F.filter=_t(F.filter),F.fill=_t(F.fill),F.stroke=_t(F.stroke),F.paths=_t(F.paths),F.pxAlign=v.pxAlign}if(ye){let D=Pe(v,A);xe.splice(A,0,D[0]),Ke.splice(A,0,D[1]),le.values.push(null)}if(Re){ee.splice(A,0,null);let D=null;Oi?A==0&&(D=Bo(v,A)):A>0&&(D=Bo(v,A)),Cn.splice(A,0,D),is.splice(A,0,0),vi.splice(A,0,0)}pn("addSeries",A)}function il(v,A){A=A??M.length,v=s==1?Lu(v,A,$p,Qp):Lu(v,A,{},jp),M.splice(A,0,v),qs(M[A],A)}n.addSeries=il;function sl(v){if(M.splice(v,1),ye){le.values.splice(v,1),Ke.splice(v,1);let A=xe.splice(v,1)[0];Ne(null,A.firstChild),A.remove()}Re&&(ee.splice(v,1),Cn.splice(v,1)[0].remove(),is.splice(v,1),vi.splice(v,1)),pn("delSeries",v)}n.delSeries=sl;let ss=[!1,!1,!1,!1];function Zh(v,A){if(v._show=v.show,v.show){let D=v.side%2,F=x[v.scale];F==null&&(v.scale=D?M[1].scale:T,F=x[v.scale]);let $=F.time;v.size=_t(v.size),v.space=_t(v.space),v.rotate=_t(v.rotate),As(v.incrs)&&v.incrs.forEach(me=>{!Rs.has(me)&&Rs.set(me,pm(me))}),v.incrs=_t(v.incrs||(F.distr==2?bx:$?d==1?Sx:Tx:er)),v.splits=_t(v.splits||($&&F.distr==1?B:F.distr==3?Ru:F.distr==4?Wx:Gx)),v.stroke=_t(v.stroke),v.grid.stroke=_t(v.grid.stroke),v.ticks.stroke=_t(v.ticks.stroke),v.border.stroke=_t(v.border.stroke);let ie=v.values;v.values=As(ie)&&!As(ie[0])?_t(ie):$?As(ie)?Wp(q,Gp(ie,U)):zp(ie)?Cx(q,ie):ie||K:ie||Vx,v.filter=_t(v.filter||(F.distr>=3&&F.log==10?Yx:F.distr==3&&F.log==2?$x:fm)),v.font=rm(v.font),v.labelFont=rm(v.labelFont),v._size=v.size(n,null,A,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(ss[A]=!0,v._el=fi(Iv,f))}}function Ys(v,A,D,F){let[$,ie,me,be]=D,Ce=A%2,ze=0;return Ce==0&&(be||ie)&&(ze=A==0&&!$||A==2&&!me?sn(Yp.size/3):0),Ce==1&&($||me)&&(ze=A==1&&!ie||A==3&&!be?sn(Kp.size/2):0),ze}let rl=n.padding=(i.padding||[Ys,Ys,Ys,Ys]).map(v=>_t(Mt(v,Ys))),Bi=n._padding=rl.map((v,A)=>v(n,A,ss,0)),nn,R=null,Z=null,ae=s==1?M[0].idxs:null,oe=null,J=!1;function Ee(v,A){if(e=v??[],n.data=n._data=e,s==2){nn=0;for(let D=1;D<M.length;D++)nn+=e[D][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),oe=e[0],nn=oe.length;let D=e;if(O==2){D=e.slice();let F=D[0]=Array(nn);for(let $=0;$<nn;$++)F[$]=$}n._data=e=D}if(Ar(!0),pn("setData"),O==2&&(it=!0),A!==!1){let D=w;D.auto(n,J)?Ue():ws(T,D.min,D.max),Y=Y||ce.left>=0,Te=!0,Rr()}}n.setData=Ee;function Ue(){J=!0;let v,A;s==1&&(nn>0?(R=ae[0]=0,Z=ae[1]=nn-1,v=e[0][R],A=e[0][Z],O==2?(v=R,A=Z):v==A&&(O==3?[v,A]=Ml(v,v,w.log,!1):O==4?[v,A]=Fu(v,v,w.log,!1):w.time?A=v+sn(86400/d):[v,A]=xl(v,A,Ou,!0))):(R=ae[0]=v=null,Z=ae[1]=A=null)),ws(T,v,A)}let We,Be,et,tt,Je,ht,yt,Bt,At,at;function Qe(v,A,D,F,$,ie){v??(v=Mp),D??(D=zu),F??(F="butt"),$??($=Mp),ie??(ie="round"),v!=We&&(h.strokeStyle=We=v),$!=Be&&(h.fillStyle=Be=$),A!=et&&(h.lineWidth=et=A),ie!=Je&&(h.lineJoin=Je=ie),F!=ht&&(h.lineCap=ht=F),D!=tt&&h.setLineDash(tt=D)}function zt(v,A,D,F){A!=Be&&(h.fillStyle=Be=A),v!=yt&&(h.font=yt=v),D!=Bt&&(h.textAlign=Bt=D),F!=At&&(h.textBaseline=At=F)}function gt(v,A,D,F,$=0){if(F.length>0&&v.auto(n,J)&&(A==null||A.min==null)){let ie=Mt(R,0),me=Mt(Z,F.length-1),be=D.min==null?Yv(F,ie,me,$,v.distr==3):[D.min,D.max];v.min=Ti(v.min,D.min=be[0]),v.max=Fn(v.max,D.max=be[1])}}let Sn={min:null,max:null};function bs(){for(let F in x){let $=x[F];W[F]==null&&($.min==null||W[T]!=null&&$.auto(n,J))&&(W[F]=Sn)}for(let F in x){let $=x[F];W[F]==null&&$.from!=null&&W[$.from]!=null&&(W[F]=Sn)}W[T]!=null&&Ar(!0);let v={};for(let F in W){let $=W[F];if($!=null){let ie=v[F]=Wr(x[F],nx);if($.min!=null)Qt(ie,$);else if(F!=T||s==2)if(nn==0&&ie.from==null){let me=ie.range(n,null,null,F);ie.min=me[0],ie.max=me[1]}else ie.min=Ft,ie.max=-Ft}}if(nn>0){M.forEach((F,$)=>{if(s==1){let ie=F.scale,me=W[ie];if(me==null)return;let be=v[ie];if($==0){let Ce=be.range(n,be.min,be.max,ie);be.min=Ce[0],be.max=Ce[1],R=Ei(be.min,e[0]),Z=Ei(be.max,e[0]),Z-R>1&&(e[0][R]<be.min&&R++,e[0][Z]>be.max&&Z--),F.min=oe[R],F.max=oe[Z]}else F.show&&F.auto&&gt(be,me,F,e[$],F.sorted);F.idxs[0]=R,F.idxs[1]=Z}else if($>0&&F.show&&F.auto){let[ie,me]=F.facets,be=ie.scale,Ce=me.scale,[ze,ke]=e[$],Xe=v[be],ot=v[Ce];Xe!=null&&gt(Xe,W[be],ie,ze,ie.sorted),ot!=null&&gt(ot,W[Ce],me,ke,me.sorted),F.min=me.min,F.max=me.max}});for(let F in v){let $=v[F],ie=W[F];if($.from==null&&(ie==null||ie.min==null)){let me=$.range(n,$.min==Ft?null:$.min,$.max==-Ft?null:$.max,F);$.min=me[0],$.max=me[1]}}}for(let F in v){let $=v[F];if($.from!=null){let ie=v[$.from];if(ie.min==null)$.min=$.max=null;else{let me=$.range(n,ie.min,ie.max,F);$.min=me[0],$.max=me[1]}}}let A={},D=!1;for(let F in v){let $=v[F],ie=x[F];if(ie.min!=$.min||ie.max!=$.max){ie.min=$.min,ie.max=$.max;let me=ie.distr;ie._min=me==3?as(ie.min):me==4?xu(ie.min,ie.asinh):me==100?ie.fwd(ie.min):ie.min,ie._max=me==3?as(ie.max):me==4?xu(ie.max,ie.asinh):me==100?ie.fwd(ie.max):ie.max,A[F]=D=!0}}if(D){M.forEach((F,$)=>{s==2?$>0&&A.y&&(F._paths=null):A[F.scale]&&(F._paths=null)});for(let F in A)it=!0,pn("setScale",F);Re&&ce.left>=0&&(Y=Te=!0)}for(let F in W)W[F]=null}function Pn(v){let A=Au(R-1,0,nn-1),D=Au(Z+1,0,nn-1);for(;v[A]==null&&A>0;)A--;for(;v[D]==null&&D<nn-1;)D++;return[A,D]}function $s(){if(nn>0){let v=M.some(A=>A._focus)&&at!=Kn.alpha;v&&(h.globalAlpha=at=Kn.alpha),M.forEach((A,D)=>{if(D>0&&A.show&&(kt(D,!1),kt(D,!0),A._paths==null)){let F=at;at!=A.alpha&&(h.globalAlpha=at=A.alpha);let $=s==2?[0,e[D][0].length-1]:Pn(e[D]);A._paths=A.paths(n,D,$[0],$[1]),at!=F&&(h.globalAlpha=at=F)}}),M.forEach((A,D)=>{if(D>0&&A.show){let F=at;at!=A.alpha&&(h.globalAlpha=at=A.alpha),A._paths!=null&&In(D,!1);{let $=A._paths!=null?A._paths.gaps:null,ie=A.points.show(n,D,R,Z,$),me=A.points.filter(n,D,ie,$);(ie||me)&&(A.points._paths=A.points.paths(n,D,R,Z,me),In(D,!0))}at!=F&&(h.globalAlpha=at=F),pn("drawSeries",D)}}),v&&(h.globalAlpha=at=1)}}function kt(v,A){let D=A?M[v].points:M[v];D._stroke=D.stroke(n,v),D._fill=D.fill(n,v)}function In(v,A){let D=A?M[v].points:M[v],{stroke:F,fill:$,clip:ie,flags:me,_stroke:be=D._stroke,_fill:Ce=D._fill,_width:ze=D.width}=D._paths;ze=Ot(ze*Et,3);let ke=null,Xe=ze%2/2;A&&Ce==null&&(Ce=ze>0?"#fff":be);let ot=D.pxAlign==1&&Xe>0;if(ot&&h.translate(Xe,Xe),!A){let St=Oe-ze/2,bt=ge-ze/2,dt=Ie+ze,nt=Ze+ze;ke=new Path2D,ke.rect(St,bt,dt,nt)}A?un(be,ze,D.dash,D.cap,Ce,F,$,me,ie):Gn(v,be,ze,D.dash,D.cap,Ce,F,$,me,ke,ie),ot&&h.translate(-Xe,-Xe)}function Gn(v,A,D,F,$,ie,me,be,Ce,ze,ke){let Xe=!1;Ce!=0&&P.forEach((ot,St)=>{if(ot.series[0]==v){let bt=M[ot.series[1]],dt=e[ot.series[1]],nt=(bt._paths||ea).band;As(nt)&&(nt=ot.dir==1?nt[0]:nt[1]);let je,Gt=null;bt.show&&nt&&Zv(dt,R,Z)?(Gt=ot.fill(n,St)||ie,je=bt._paths.clip):nt=null,un(A,D,F,$,Gt,me,be,Ce,ze,ke,je,nt),Xe=!0}}),Xe||un(A,D,F,$,ie,me,be,Ce,ze,ke)}let hn=Xr|Pu;function un(v,A,D,F,$,ie,me,be,Ce,ze,ke,Xe){Qe(v,A,D,F,$),(Ce||ze||Xe)&&(h.save(),Ce&&h.clip(Ce),ze&&h.clip(ze)),Xe?(be&hn)==hn?(h.clip(Xe),ke&&h.clip(ke),li($,me),Ms(v,ie,A)):be&Pu?(li($,me),h.clip(Xe),Ms(v,ie,A)):be&Xr&&(h.save(),h.clip(Xe),ke&&h.clip(ke),li($,me),h.restore(),Ms(v,ie,A)):(li($,me),Ms(v,ie,A)),(Ce||ze||Xe)&&h.restore()}function Ms(v,A,D){D>0&&(A instanceof Map?A.forEach((F,$)=>{h.strokeStyle=We=$,h.stroke(F)}):A!=null&&v&&h.stroke(A))}function li(v,A){A instanceof Map?A.forEach((D,F)=>{h.fillStyle=Be=F,h.fill(D)}):A!=null&&v&&h.fill(A)}function P_(v,A,D,F){let $=S[v],ie;if(F<=0)ie=[0,0];else{let me=$._space=$.space(n,v,A,D,F),be=$._incrs=$.incrs(n,v,A,D,F,me);ie=gy(A,D,be,F,me)}return $._found=ie}function Kh(v,A,D,F,$,ie,me,be,Ce,ze){let ke=me%2/2;_==1&&h.translate(ke,ke),Qe(be,me,Ce,ze,be),h.beginPath();let Xe,ot,St,bt,dt=$+(F==0||F==3?-ie:ie);D==0?(ot=$,bt=dt):(Xe=$,St=dt);for(let nt=0;nt<v.length;nt++)A[nt]!=null&&(D==0?Xe=St=v[nt]:ot=bt=v[nt],h.moveTo(Xe,ot),h.lineTo(St,bt));h.stroke(),_==1&&h.translate(-ke,-ke)}function I_(v){let A=!0;return S.forEach((D,F)=>{if(!D.show)return;let $=x[D.scale];if($.min==null){D._show&&(A=!1,D._show=!1,Ar(!1));return}else D._show||(A=!1,D._show=!0,Ar(!1));let ie=D.side,me=ie%2,{min:be,max:Ce}=$,[ze,ke]=P_(F,be,Ce,me==0?y:H);if(ke==0)return;let Xe=$.distr==2,ot=D._splits=D.splits(n,F,be,Ce,ze,ke,Xe),St=$.distr==2?ot.map(je=>oe[je]):ot,bt=$.distr==2?oe[ot[1]]-oe[ot[0]]:ze,dt=D._values=D.values(n,D.filter(n,St,F,ke,bt),F,ke,bt);D._rotate=ie==2?D.rotate(n,dt,F,ke):0;let nt=D._size;D._size=di(D.size(n,dt,F,v)),nt!=null&&D._size!=nt&&(A=!1)}),A}function L_(v){let A=!0;return rl.forEach((D,F)=>{let $=D(n,F,ss,v);$!=Bi[F]&&(A=!1),Bi[F]=$}),A}function D_(){for(let v=0;v<S.length;v++){let A=S[v];if(!A.show||!A._show)continue;let D=A.side,F=D%2,$,ie,me=A.stroke(n,v),be=D==0||D==3?-1:1,[Ce,ze]=A._found;if(A.label!=null){let Dn=A.labelGap*be,Qn=sn((A._lpos+Dn)*Et);zt(A.labelFont[0],me,"center",D==2?"top":bp),h.save(),F==1?($=ie=0,h.translate(Qn,sn(ge+Ze/2)),h.rotate((D==3?-_l:_l)/2)):($=sn(Oe+Ie/2),ie=Qn);let Js=hm(A.label)?A.label(n,v,Ce,ze):A.label;h.fillText(Js,$,ie),h.restore()}if(ze==0)continue;let ke=x[A.scale],Xe=F==0?Ie:Ze,ot=F==0?Oe:ge,St=A._splits,bt=ke.distr==2?St.map(Dn=>oe[Dn]):St,dt=ke.distr==2?oe[St[1]]-oe[St[0]]:Ce,nt=A.ticks,je=A.border,Gt=nt.show?nt.size:0,Zt=sn(Gt*Et),mn=sn((A.alignTo==2?A._size-Gt-A.gap:A.gap)*Et),Lt=A._rotate*-_l/180,Kt=m(A._pos*Et),Jn=(Zt+mn)*be,Ln=Kt+Jn;ie=F==0?Ln:0,$=F==1?Ln:0;let ci=A.font[0],xi=A.align==1?zr:A.align==2?gu:Lt>0?zr:Lt<0?gu:F==0?"center":D==3?gu:zr,Hi=Lt||F==1?"middle":D==2?"top":bp;zt(ci,me,xi,Hi);let jn=A.font[1]*A.lineGap,hi=St.map(Dn=>m(a(Dn,ke,Xe,ot))),yi=A._values;for(let Dn=0;Dn<yi.length;Dn++){let Qn=yi[Dn];if(Qn!=null){F==0?$=hi[Dn]:ie=hi[Dn],Qn=""+Qn;let Js=Qn.indexOf(`
`)==-1?[Qn]:Qn.split(/\n/gm);for(let Un=0;Un<Js.length;Un++){let Zd=Js[Un];Lt?(h.save(),h.translate($,ie+Un*jn),h.rotate(Lt),h.fillText(Zd,0,0),h.restore()):h.fillText(Zd,$,ie+Un*jn)}}}nt.show&&Kh(hi,nt.filter(n,bt,v,ze,dt),F,D,Kt,Zt,Ot(nt.width*Et,3),nt.stroke(n,v),nt.dash,nt.cap);let Vi=A.grid;Vi.show&&Kh(hi,Vi.filter(n,bt,v,ze,dt),F,F==0?2:1,F==0?ge:Oe,F==0?Ze:Ie,Ot(Vi.width*Et,3),Vi.stroke(n,v),Vi.dash,Vi.cap),je.show&&Kh([Kt],[1],F==0?1:0,F==0?1:2,F==1?ge:Oe,F==1?Ze:Ie,Ot(je.width*Et,3),je.stroke(n,v),je.dash,je.cap)}pn("drawAxes")}function Ar(v){M.forEach((A,D)=>{D>0&&(A._paths=null,v&&(s==1?(A.min=null,A.max=null):A.facets.forEach(F=>{F.min=null,F.max=null})))})}let ol=!1,Jh=!1,zo=[];function U_(){Jh=!1;for(let v=0;v<zo.length;v++)pn(...zo[v]);zo.length=0}function Rr(){ol||(cx(Id),ol=!0)}function N_(v,A=!1){ol=!0,Jh=A,v(n),Id(),A&&zo.length>0&&queueMicrotask(U_)}n.batch=N_;function Id(){if($e&&(bs(),$e=!1),it&&(qe(),it=!1),De){if(Wt(p,zr,re),Wt(p,"top",pe),Wt(p,Ko,y),Wt(p,Jo,H),Wt(g,zr,re),Wt(g,"top",pe),Wt(g,Ko,y),Wt(g,Jo,H),Wt(f,Ko,Ye),Wt(f,Jo,L),u.width=sn(Ye*Et),u.height=sn(L*Et),S.forEach(({_el:v,_show:A,_size:D,_pos:F,side:$})=>{if(v!=null)if(A){let ie=$===3||$===0?D:0,me=$%2==1;Wt(v,me?"left":"top",F-ie),Wt(v,me?"width":"height",D),Wt(v,me?"top":"left",me?pe:re),Wt(v,me?"height":"width",me?H:y),Eu(v,tr)}else ei(v,tr)}),We=Be=et=Je=ht=yt=Bt=At=tt=null,at=1,Vo(!0),re!=he||pe!=He||y!=Me||H!=Ve){Ar(!1);let v=y/Me,A=H/Ve;if(Re&&!Y&&ce.left>=0){ce.left*=v,ce.top*=A,Cr&&Xi(Cr,sn(ce.left),0,y,H),Pr&&Xi(Pr,0,sn(ce.top),y,H);for(let D=0;D<Cn.length;D++){let F=Cn[D];F!=null&&(is[D]*=v,vi[D]*=A,Xi(F,di(is[D]),di(vi[D]),y,H))}}if(Vt.show&&!we&&Vt.left>=0&&Vt.width>0){Vt.left*=v,Vt.width*=v,Vt.top*=A,Vt.height*=A;for(let D in iu)Wt(Dr,D,Vt[D])}he=re,He=pe,Me=y,Ve=H}pn("setSize"),De=!1}Ye>0&&L>0&&(h.clearRect(0,0,u.width,u.height),pn("drawClear"),I.forEach(v=>v()),pn("draw")),Vt.show&&we&&(al(Vt),we=!1),Re&&Y&&(Ks(null,!0,!1),Y=!1),le.show&&le.live&&Te&&(tu(),Te=!1),l||(l=!0,n.status=1,pn("ready")),J=!1,ol=!1}n.redraw=(v,A)=>{it=A||!1,v!==!1?ws(T,w.min,w.max):Rr()};function jh(v,A){let D=x[v];if(D.from==null){if(nn==0){let F=D.range(n,A.min,A.max,v);A.min=F[0],A.max=F[1]}if(A.min>A.max){let F=A.min;A.min=A.max,A.max=F}if(nn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;v==T&&D.distr==2&&nn>0&&(A.min=Ei(A.min,e[0]),A.max=Ei(A.max,e[0]),A.min==A.max&&A.max++),W[v]=A,$e=!0,Rr()}}n.setScale=jh;let Qh,eu,Cr,Pr,Ld,Dd,Ir,Lr,Ud,Nd,Ht,Yt,Ss=!1,xn=ce.drag,fn=xn.x,dn=xn.y;Re&&(ce.x&&(Qh=fi(Dv,g)),ce.y&&(eu=fi(Uv,g)),w.ori==0?(Cr=Qh,Pr=eu):(Cr=eu,Pr=Qh),Ht=ce.left,Yt=ce.top);let Vt=n.select=Qt({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Dr=Vt.show?fi(Lv,Vt.over?g:p):null;function al(v,A){if(Vt.show){for(let D in v)Vt[D]=v[D],D in iu&&Wt(Dr,D,v[D]);A!==!1&&pn("setSelect")}}n.setSelect=al;function F_(v){if(M[v].show)ye&&Eu(xe[v],tr);else if(ye&&ei(xe[v],tr),Re){let D=Oi?Cn[0]:Cn[v];D!=null&&Xi(D,-10,-10,y,H)}}function ws(v,A,D){jh(v,{min:A,max:D})}function zi(v,A,D,F){A.focus!=null&&H_(v),A.show!=null&&M.forEach(($,ie)=>{ie>0&&(v==ie||v==null)&&($.show=A.show,F_(ie),s==2?(ws($.facets[0].scale,null,null),ws($.facets[1].scale,null,null)):ws($.scale,null,null),Rr())}),D!==!1&&pn("setSeries",v,A),F&&Go("setSeries",n,v,A)}n.setSeries=zi;function O_(v,A){Qt(P[v],A)}function B_(v,A){v.fill=_t(v.fill||null),v.dir=Mt(v.dir,-1),A=A??P.length,P.splice(A,0,v)}function z_(v){v==null?P.length=0:P.splice(v,1)}n.addBand=B_,n.setBand=O_,n.delBand=z_;function k_(v,A){M[v].alpha=A,Re&&Cn[v]!=null&&(Cn[v].style.opacity=A),ye&&xe[v]&&(xe[v].style.opacity=A)}let rs,Es,Zs,Ur={focus:!0};function H_(v){if(v!=Zs){let A=v==null,D=Kn.alpha!=1;M.forEach((F,$)=>{if(s==1||$>0){let ie=A||$==0||$==v;F._focus=A?null:ie,D&&k_($,ie?1:Kn.alpha)}}),Zs=v,D&&Rr()}}ye&&Vn&&ve(Ep,X,v=>{ce._lock||(vn(v),Zs!=null&&zi(null,Ur,!0,jt.setSeries))});function ki(v,A,D){let F=x[A];D&&(v=v/Et-(F.ori==1?pe:re));let $=y;F.ori==1&&($=H,v=$-v),F.dir==-1&&(v=$-v);let ie=F._min,me=F._max,be=v/$,Ce=ie+(me-ie)*be,ze=F.distr;return ze==3?Vr(10,Ce):ze==4?Jv(Ce,F.asinh):ze==100?F.bwd(Ce):Ce}function V_(v,A){let D=ki(v,T,A);return Ei(D,e[0],R,Z)}n.valToIdx=v=>Ei(v,e[0]),n.posToIdx=V_,n.posToVal=ki,n.valToPos=(v,A,D)=>x[A].ori==0?r(v,x[A],D?Ie:y,D?Oe:0):o(v,x[A],D?Ze:H,D?ge:0),n.setCursor=(v,A,D)=>{Ht=v.left,Yt=v.top,Ks(null,A,D)};function Fd(v,A){Wt(Dr,zr,Vt.left=v),Wt(Dr,Ko,Vt.width=A)}function Od(v,A){Wt(Dr,"top",Vt.top=v),Wt(Dr,Jo,Vt.height=A)}let ko=w.ori==0?Fd:Od,Ho=w.ori==1?Fd:Od;function G_(){if(ye&&le.live)for(let v=s==2?1:0;v<M.length;v++){if(v==0&&k)continue;let A=le.values[v],D=0;for(let F in A)Ke[v][D++].firstChild.nodeValue=A[F]}}function tu(v,A){if(v!=null&&(v.idxs?v.idxs.forEach((D,F)=>{ee[F]=D}):tx(v.idx)||ee.fill(v.idx),le.idx=ee[0]),ye&&le.live){for(let D=0;D<M.length;D++)(D>0||s==1&&!k)&&W_(D,ee[D]);G_()}Te=!1,A!==!1&&pn("setLegend")}n.setLegend=tu;function W_(v,A){let D=M[v],F=v==0&&O==2?oe:e[v],$;k?$=D.values(n,v,A)??ue:($=D.value(n,A==null?null:F[A],v,A),$=$==null?ue:{_:$}),le.values[v]=$}function Ks(v,A,D){Ud=Ht,Nd=Yt,[Ht,Yt]=ce.move(n,Ht,Yt),ce.left=Ht,ce.top=Yt,Re&&(Cr&&Xi(Cr,sn(Ht),0,y,H),Pr&&Xi(Pr,0,sn(Yt),y,H));let F,$=R>Z;rs=Ft,Es=null;let ie=w.ori==0?y:H,me=w.ori==1?y:H;if(Ht<0||nn==0||$){F=ce.idx=null;for(let be=0;be<M.length;be++){let Ce=Cn[be];Ce!=null&&Xi(Ce,-10,-10,y,H)}Vn&&zi(null,Ur,!0,v==null&&jt.setSeries),le.live&&(ee.fill(F),Te=!0)}else{let be,Ce,ze;s==1&&(be=w.ori==0?Ht:Yt,Ce=ki(be,T),F=ce.idx=Ei(Ce,e[0],R,Z),ze=z(e[0][F],w,ie,0));let ke=-10,Xe=-10,ot=0,St=0,bt=!0,dt="",nt="";for(let je=s==2?1:0;je<M.length;je++){let Gt=M[je],Zt=ee[je],mn=Zt==null?null:s==1?e[je][Zt]:e[je][1][Zt],Lt=ce.dataIdx(n,je,F,Ce),Kt=Lt==null?null:s==1?e[je][Lt]:e[je][1][Lt];if(Te=Te||Kt!=mn||Lt!=Zt,ee[je]=Lt,je>0&&Gt.show){let Jn=Lt==null?-10:Lt==F?ze:z(s==1?e[0][Lt]:e[je][0][Lt],w,ie,0),Ln=Kt==null?-10:V(Kt,s==1?x[Gt.scale]:x[Gt.facets[1].scale],me,0);if(Vn&&Kt!=null){let ci=w.ori==1?Ht:Yt,xi=rn(Kn.dist(n,je,Lt,Ln,ci));if(xi<rs){let Hi=Kn.bias;if(Hi!=0){let jn=ki(ci,Gt.scale),hi=Kt>=0?1:-1,yi=jn>=0?1:-1;yi==hi&&(yi==1?Hi==1?Kt>=jn:Kt<=jn:Hi==1?Kt<=jn:Kt>=jn)&&(rs=xi,Es=je)}else rs=xi,Es=je}}if(Te||Oi){let ci,xi;w.ori==0?(ci=Jn,xi=Ln):(ci=Ln,xi=Jn);let Hi,jn,hi,yi,Vi,Dn,Qn=!0,Js=Nt.bbox;if(Js!=null){Qn=!1;let Un=Js(n,je);hi=Un.left,yi=Un.top,Hi=Un.width,jn=Un.height}else hi=ci,yi=xi,Hi=jn=Nt.size(n,je);if(Dn=Nt.fill(n,je),Vi=Nt.stroke(n,je),Oi)je==Es&&rs<=Kn.prox&&(ke=hi,Xe=yi,ot=Hi,St=jn,bt=Qn,dt=Dn,nt=Vi);else{let Un=Cn[je];Un!=null&&(is[je]=hi,vi[je]=yi,Lp(Un,Hi,jn,Qn),Pp(Un,Dn,Vi),Xi(Un,di(hi),di(yi),y,H))}}}}if(Oi){let je=Kn.prox,Gt=Zs==null?rs<=je:rs>je||Es!=Zs;if(Te||Gt){let Zt=Cn[0];Zt!=null&&(is[0]=ke,vi[0]=Xe,Lp(Zt,ot,St,bt),Pp(Zt,dt,nt),Xi(Zt,di(ke),di(Xe),y,H))}}}if(Vt.show&&Ss)if(v!=null){let[be,Ce]=jt.scales,[ze,ke]=jt.match,[Xe,ot]=v.cursor.sync.scales,St=v.cursor.drag;if(fn=St._x,dn=St._y,fn||dn){let{left:bt,top:dt,width:nt,height:je}=v.select,Gt=v.scales[Xe].ori,Zt=v.posToVal,mn,Lt,Kt,Jn,Ln,ci=be!=null&&ze(be,Xe),xi=Ce!=null&&ke(Ce,ot);ci&&fn?(Gt==0?(mn=bt,Lt=nt):(mn=dt,Lt=je),Kt=x[be],Jn=z(Zt(mn,Xe),Kt,ie,0),Ln=z(Zt(mn+Lt,Xe),Kt,ie,0),ko(Ti(Jn,Ln),rn(Ln-Jn))):ko(0,ie),xi&&dn?(Gt==1?(mn=bt,Lt=nt):(mn=dt,Lt=je),Kt=x[Ce],Jn=V(Zt(mn,ot),Kt,me,0),Ln=V(Zt(mn+Lt,ot),Kt,me,0),Ho(Ti(Jn,Ln),rn(Ln-Jn))):Ho(0,me)}else su()}else{let be=rn(Ud-Ld),Ce=rn(Nd-Dd);if(w.ori==1){let ot=be;be=Ce,Ce=ot}fn=xn.x&&be>=xn.dist,dn=xn.y&&Ce>=xn.dist;let ze=xn.uni;ze!=null?fn&&dn&&(fn=be>=ze,dn=Ce>=ze,!fn&&!dn&&(Ce>be?dn=!0:fn=!0)):xn.x&&xn.y&&(fn||dn)&&(fn=dn=!0);let ke,Xe;fn&&(w.ori==0?(ke=Ir,Xe=Ht):(ke=Lr,Xe=Yt),ko(Ti(ke,Xe),rn(Xe-ke)),dn||Ho(0,me)),dn&&(w.ori==1?(ke=Ir,Xe=Ht):(ke=Lr,Xe=Yt),Ho(Ti(ke,Xe),rn(Xe-ke)),fn||ko(0,ie)),!fn&&!dn&&(ko(0,0),Ho(0,0))}if(xn._x=fn,xn._y=dn,v==null){if(D){if($d!=null){let[be,Ce]=jt.scales;jt.values[0]=be!=null?ki(w.ori==0?Ht:Yt,be):null,jt.values[1]=Ce!=null?ki(w.ori==1?Ht:Yt,Ce):null}Go(_u,n,Ht,Yt,y,H,F)}if(Vn){let be=D&&jt.setSeries,Ce=Kn.prox;Zs==null?rs<=Ce&&zi(Es,Ur,!0,be):rs>Ce?zi(null,Ur,!0,be):Es!=Zs&&zi(Es,Ur,!0,be)}}Te&&(le.idx=F,tu()),A!==!1&&pn("setCursor")}let Ts=null;Object.defineProperty(n,"rect",{get(){return Ts==null&&Vo(!1),Ts}});function Vo(v=!1){v?Ts=null:(Ts=g.getBoundingClientRect(),pn("syncRect",Ts))}function Bd(v,A,D,F,$,ie,me){ce._lock||Ss&&v!=null&&v.movementX==0&&v.movementY==0||(nu(v,A,D,F,$,ie,me,!1,v!=null),v!=null?Ks(null,!0,!0):Ks(A,!0,!1))}function nu(v,A,D,F,$,ie,me,be,Ce){if(Ts==null&&Vo(!1),vn(v),v!=null)D=v.clientX-Ts.left,F=v.clientY-Ts.top;else{if(D<0||F<0){Ht=-10,Yt=-10;return}let[ze,ke]=jt.scales,Xe=A.cursor.sync,[ot,St]=Xe.values,[bt,dt]=Xe.scales,[nt,je]=jt.match,Gt=A.axes[0].side%2==1,Zt=w.ori==0?y:H,mn=w.ori==1?y:H,Lt=Gt?ie:$,Kt=Gt?$:ie,Jn=Gt?F:D,Ln=Gt?D:F;if(bt!=null?D=nt(ze,bt)?a(ot,x[ze],Zt,0):-10:D=Zt*(Jn/Lt),dt!=null?F=je(ke,dt)?a(St,x[ke],mn,0):-10:F=mn*(Ln/Kt),w.ori==1){let ci=D;D=F,F=ci}}Ce&&(A==null||A.cursor.event.type==_u)&&((D<=1||D>=y-1)&&(D=Qs(D,y)),(F<=1||F>=H-1)&&(F=Qs(F,H))),be?(Ld=D,Dd=F,[Ir,Lr]=ce.move(n,D,F)):(Ht=D,Yt=F)}let iu={width:0,height:0,left:0,top:0};function su(){al(iu,!1)}let zd,kd,Hd,Vd;function Gd(v,A,D,F,$,ie,me){Ss=!0,fn=dn=xn._x=xn._y=!1,nu(v,A,D,F,$,ie,me,!0,!1),v!=null&&(ve(vu,Su,Wd,!1),Go(Sp,n,Ir,Lr,y,H,null));let{left:be,top:Ce,width:ze,height:ke}=Vt;zd=be,kd=Ce,Hd=ze,Vd=ke}function Wd(v,A,D,F,$,ie,me){Ss=xn._x=xn._y=!1,nu(v,A,D,F,$,ie,me,!1,!0);let{left:be,top:Ce,width:ze,height:ke}=Vt,Xe=ze>0||ke>0,ot=zd!=be||kd!=Ce||Hd!=ze||Vd!=ke;if(Xe&&ot&&al(Vt),xn.setScale&&Xe&&ot){let St=be,bt=ze,dt=Ce,nt=ke;if(w.ori==1&&(St=Ce,bt=ke,dt=be,nt=ze),fn&&ws(T,ki(St,T),ki(St+bt,T)),dn)for(let je in x){let Gt=x[je];je!=T&&Gt.from==null&&Gt.min!=Ft&&ws(je,ki(dt+nt,je),ki(dt,je))}su()}else ce.lock&&(ce._lock=!ce._lock,Ks(A,!0,v!=null));v!=null&&(Ne(vu,Su),Go(vu,n,Ht,Yt,y,H,null))}function X_(v,A,D,F,$,ie,me){if(ce._lock)return;vn(v);let be=Ss;if(Ss){let Ce=!0,ze=!0,ke=10,Xe,ot;w.ori==0?(Xe=fn,ot=dn):(Xe=dn,ot=fn),Xe&&ot&&(Ce=Ht<=ke||Ht>=y-ke,ze=Yt<=ke||Yt>=H-ke),Xe&&Ce&&(Ht=Ht<Ir?0:y),ot&&ze&&(Yt=Yt<Lr?0:H),Ks(null,!0,!0),Ss=!1}Ht=-10,Yt=-10,ee.fill(null),Ks(null,!0,!0),be&&(Ss=be)}function Xd(v,A,D,F,$,ie,me){ce._lock||(vn(v),Ue(),su(),v!=null&&Go(Tp,n,Ht,Yt,y,H,null))}function qd(){S.forEach(_y),Ge(n.width,n.height,!0)}nr(vl,Hr,qd);let Nr={};Nr.mousedown=Gd,Nr.mousemove=Bd,Nr.mouseup=Wd,Nr.dblclick=Xd,Nr.setSeries=(v,A,D,F)=>{let $=jt.match[2];D=$(n,A,D),D!=-1&&zi(D,F,!0,!1)},Re&&(ve(Sp,g,Gd),ve(_u,g,Bd),ve(wp,g,v=>{vn(v),Vo(!1)}),ve(Ep,g,X_),ve(Tp,g,Xd),Iu.add(n),n.syncRect=Vo);let ll=n.hooks=i.hooks||{};function pn(v,A,D){Jh?zo.push([v,A,D]):v in ll&&ll[v].forEach(F=>{F.call(null,n,A,D)})}(i.plugins||[]).forEach(v=>{for(let A in v.hooks)ll[A]=(ll[A]||[]).concat(v.hooks[A])});let Yd=(v,A,D)=>D,jt=Qt({key:null,setSeries:!1,filters:{pub:Op,sub:Op},scales:[T,M[1]?M[1].scale:null],match:[Bp,Bp,Yd],values:[null,null]},ce.sync);jt.match.length==2&&jt.match.push(Yd),ce.sync=jt;let $d=jt.key,ru=Um($d);function Go(v,A,D,F,$,ie,me){jt.filters.pub(v,A,D,F,$,ie,me)&&ru.pub(v,A,D,F,$,ie,me)}ru.sub(n);function q_(v,A,D,F,$,ie,me){jt.filters.sub(v,A,D,F,$,ie,me)&&Nr[v](null,A,D,F,$,ie,me)}n.pub=q_;function Y_(){ru.unsub(n),Iu.delete(n),te.clear(),Tu(vl,Hr,qd),c.remove(),X?.remove(),pn("destroy")}n.destroy=Y_;function ou(){pn("init",i,e),Ee(e||i.data,!1),W[T]?jh(T,W[T]):Ue(),we=Vt.show&&(Vt.width>0||Vt.height>0),Y=Te=!0,Ge(i.width,i.height)}return M.forEach(qs),S.forEach(Zh),t?t instanceof HTMLElement?(t.appendChild(c),ou()):t(n,ou):ou(),n}$t.assign=Qt;$t.fmtNum=Bu;$t.rangeNum=xl;$t.rangeLog=Ml;$t.rangeAsinh=Fu;$t.orient=sr;$t.pxRatio=Et;$t.join=lx;$t.fmtDate=ku,$t.tzDate=xx;$t.sync=Um;{$t.addGap=ty,$t.clipGaps=El;let i=$t.paths={points:km};i.linear=Vm,i.stepped=sy,i.bars=ry,i.spline=ay}var qm=112,vy=54,xy=100,Yu=[1e-6,1e6],$u=14,$m=i=>{let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)},yy=.005,by=5;function My(i,[e,t]){let n=r=>Math.floor(Math.log10(r||1)),s=Math.max(0,Math.min(Math.round(-Math.log10(yy*(t-e||1))),by-1-n(Math.max(Math.abs(e),Math.abs(t)))));return s>6||Math.abs(i)>=1e6?i===0?"0":i.toExponential(3):i.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1")}function Zm(i,{onSeek:e=()=>{},onZoom:t=()=>{},onEdit:n=()=>{},onRemove:s=()=>{}}={}){let r=[],o=[],a=null,l={range:null,heights:{}},c=[],u=0,h=null;i.classList.add("plots");function f(w){a=w&&[...new Map(w.map(O=>[String(O),O])).values()],p(o)}function p(w){o=w,r.forEach(({plot:V})=>V.destroy()),i.replaceChildren();let O=Nn(),z=a??js(o);r=mp(o,z).map(V=>{let W=G("div",{class:"plot-keys"}),q=V.curves.map(ce=>{let ye=document.createElementNS("http://www.w3.org/2000/svg","svg");ye.setAttribute("viewBox","0 0 22 6"),ye.setAttribute("aria-hidden","true");let Re=document.createElementNS("http://www.w3.org/2000/svg","line");Object.entries({x1:0,x2:22,y1:3,y2:3,stroke:ce.colour,"stroke-width":2.4,"stroke-dasharray":ce.dash.join(" ")}).forEach(([X,de])=>Re.setAttribute(X,de)),ye.append(Re);let j=G("b");return j.style.setProperty("--colour",ce.colour),W.append(G("span",{class:"plot-key"},ye,G("span",{},ce.name),j)),j}),U=V.unit?`${V.name} [${V.unit}]`:V.name,B=z.findIndex(ce=>V.key===(Array.isArray(ce)?ce.join():ce)),K=(ce,ye,Re)=>G("button",{type:"button",class:"small",title:ye,"aria-label":`${ye}: ${U}`,onclick:Re},ce),ne=G("span",{class:"plot-tools"},...V.own?[K("edit","Change the signals",()=>n(B))]:[],K("×","Remove this plot",()=>s(B))),ee=G("div",{class:"plot-canvas"});i.append(G("section",{class:"plot"},G("header",{},G("h3",{},U),ne,W),ee));let le={panel:V,values:q,canvas:ee,marker:G("div",{class:"plot-now"}),cross:G("div",{class:"plot-under",hidden:!0}),flag:G("div",{class:"plot-flag",hidden:!0})};return le.plot=g(le,O),le.plot.over.append(le.marker,le.cross,le.flag),le}),S()}function g({panel:w,canvas:O},z){let V=new Map;for(let X of w.curves){let de=V.get(X.t)??{times:Array.from(X.t,Ae=>Ae+X.flight.shift),curves:[]};V.set(X.t,{...de,curves:[...de.curves,X]})}let W=[...V.values()],q=W.map(({times:X,curves:de})=>[X,...de.map(Ae=>Array.from(Ae.values))]),U=q.length===1?q[0]:$t.join(q),B=W.flatMap(({curves:X})=>X),K={stroke:z.faint,grid:{stroke:z.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ne=Sy(o.flatMap(X=>X.impacts.map(([de,Ae])=>[de+X.shift,Ae+X.shift]))),ee=$t.paths.stepped({align:1}),le=w.words&&((X,de)=>de.map(Ae=>w.words[Ae]??"")),ce={width:Math.max(O.clientWidth,200),height:qm,padding:[6,20,0,0],legend:{show:!1},scales:{x:{time:!1},y:{range:(X,de,Ae)=>l.heights[w.key]??wy(de,Ae)}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!0,y:!0,uni:$u,setScale:!1},bind:{dblclick:()=>()=>d()}},axes:[{...K,size:22,gap:2,space:56,values:(X,de)=>de.map(Ae=>Ey(Ae,de))},{...K,size:(X,de)=>Math.max(vy,7*Math.max(0,...(de??[]).map(Ae=>Ae.length))+8),gap:4,space:le?13:22,...le?{values:le}:{}}],series:[{},...B.map(X=>({stroke:X.colour,width:1.7,dash:X.dash,spanGaps:!0,points:{show:!1},...X.held?{paths:ee}:{}}))],hooks:{drawClear:[X=>{X.ctx.fillStyle=z.force+"2e";for(let[de,Ae]of ne){let xe=X.valToPos(Math.max(de,X.scales.x.min),"x",!0),Ke=X.valToPos(Math.min(Ae,X.scales.x.max),"x",!0);Ke>xe&&X.ctx.fillRect(xe,X.bbox.top,Math.max(Ke-xe,1),X.bbox.height)}}],setSelect:[X=>_(X,w.key)],draw:[X=>r.filter(de=>de.plot===X).forEach(I)]}},ye=new $t(ce,U,O),Re=null;ye.over.addEventListener("pointerdown",X=>Re=[X.clientX,X.clientY]),ye.over.addEventListener("pointerup",X=>{Re&&Math.hypot(X.clientX-Re[0],X.clientY-Re[1])<5&&e(j(X)),Re=null}),ye.over.addEventListener("pointercancel",()=>Re=null),ye.over.addEventListener("pointermove",X=>X.pointerType!=="touch"&&P(j(X),ye)),ye.over.addEventListener("pointerleave",()=>P(null));let j=X=>ye.posToVal(X.clientX-ye.over.getBoundingClientRect().left,"x");return ye}function _(w,O){let{left:z,top:V,width:W,height:q}=w.select,U=W>=$u&&W<w.over.clientWidth-1,B=q>=$u&&q<w.over.clientHeight-1;if(W+q<=0||!(U||B))return;let K=U?[w.posToVal(z,"x"),w.posToVal(z+W,"x")]:l.range,ne=B?{[O]:[w.posToVal(V+q,"y"),w.posToVal(V,"y")]}:{};w.setSelect({left:0,top:0,width:0,height:0},!1),m({range:K,heights:{...l.heights,...ne}})}function m(w){JSON.stringify(w)===JSON.stringify(l)||!Ym(w.range)||(c=[...c,l].slice(-xy),l=w,S(),t())}function d(w,O){m({range:w===void 0?null:[w,O],heights:{}})}function M(){return c.length?(l=c.pop(),S(),t(),!0):!1}function S(){let w=o.length?[Math.min(...o.map(V=>V.begin+V.shift)),Math.max(...o.map(V=>V.end+V.shift))]:[0,1],[O,z]=l.range??w;r.forEach(({plot:V})=>V.setScale("x",{min:O,max:z})),T(u)}function x({plot:w,marker:O,cross:z}){let{min:V,max:W}=w.scales.x;for(let[q,U]of[[O,u],[z,h]])q.hidden=U===null||!(U>=V&&U<=W),q.hidden||(q.style.transform=`translateX(${w.valToPos(U,"x")}px)`)}function P(w,O){h=w;for(let z of r){if(z.flag.hidden=w===null||z.plot!==O,z.flag.hidden)continue;z.flag.textContent=`${w.toFixed(4)} s`;let V=O.valToPos(w,"x");z.flag.classList.toggle("left",V>.7*O.over.clientWidth),z.flag.style.transform=`translateX(${V}px)`}i.classList.toggle("pointing",w!==null),C()}function T(w){u=w,C()}let C=()=>r.forEach(I);function I(w){let{panel:O,plot:z,values:V}=w,W=[z.scales.y.min??0,z.scales.y.max??1];x(w),O.curves.forEach((q,U)=>{let B=Yo(q,h??u);V[U].textContent=O.words?.[Math.round(B)]??My(B,W)})}function b(){r.forEach(({plot:w,canvas:O})=>{let z=O.clientWidth;z&&Math.abs(z-w.width)>1&&w.setSize({width:z,height:qm})}),T(u)}let E=new ResizeObserver(b);return E.observe(i),{replace:p,choose:f,show:T,zoom:d,back:M,resize:b,restore(w){Ym(w.range)&&(l=w,S(),t())},get wanted(){return a??js(o)},get range(){return l.range},get zoomed(){return l},get canGoBack(){return c.length>0},shown:()=>r.map(({panel:w,plot:O,values:z})=>({name:w.name,unit:w.unit,limits:[O.scales.y.min,O.scales.y.max],values:Object.fromEntries(w.curves.map((V,W)=>[V.name,z[W].textContent]))})),dispose(){E.disconnect(),r.forEach(({plot:w})=>w.destroy()),i.replaceChildren()}}}function Ym(i){if(i===null)return!0;let[e,t]=i;return t-e>=Yu[0]&&t-e<=Yu[1]&&Math.abs(e)<=Yu[1]}function Sy(i){let e=[];for(let[t,n]of i.sort((s,r)=>s[0]-r[0])){let s=e[e.length-1];s&&t<=s[1]?s[1]=Math.max(s[1],n):e.push([t,n])}return e}function wy(i,e){if(i==null||e==null)return[0,1];let t=Math.max(e-i,.001*Math.max(Math.abs(i),Math.abs(e)),1e-6);return[i-.06*t,e+.08*t]}function Ey(i,e){let t=0,n=.001*(e.length>1?e[1]-e[0]:1);for(;t<6&&e.some(s=>Math.abs(s-Number(s.toFixed(t)))>n);)t++;return`${i.toFixed(t)} s`}var na=[1,2,5,10,20,50,100,200],Ty=.25,Ay=i=>{if(i>.995)return"real time";let e=1/i;return`1/${e<10?e.toFixed(1).replace(/\.0$/,""):Math.round(e)} of real time`};function Cl({scene:i,plots:e=null,bar:t,readouts:n=null,actions:s={},onRest:r=()=>{}}){let o={t:0,playing:!1,pace:"auto",line:null,flights:[],last:0},a=G("button",{class:"play",type:"button",onclick:()=>o.playing?P():x()}),l=G("button",{type:"button",title:"One instant back (←)","aria-label":"One instant back",onclick:()=>b(-1)},Gi("back")),c=G("button",{type:"button",title:"One instant forward (→)","aria-label":"One instant forward",onclick:()=>b(1)},Gi("forth")),u=G("button",{type:"button",title:"Go to the first touch (T)","aria-label":"Go to the first touch",onclick:E},Gi("touch")),h=G("select",{"aria-label":"Speed",title:"Speed (, and .)",onchange:()=>C(h.value)},G("option",{value:"auto"},"slow at impact"),...na.map(U=>G("option",{value:String(U)},U===1?"real time":`1/${U}`))),f=G("output",{class:"clock","aria-live":"off"}),p=G("input",{type:"range",min:0,max:1,step:"any",value:0,"aria-label":"Time",oninput:()=>{P(),d(o.line.timeAt(Number(p.value)*o.line.total))}}),g=G("div",{class:"ticks","aria-hidden":"true"}),_=G("div",{class:"track"},g,p),m=G("div",{class:"events"});t.classList.add("player"),t.replaceChildren(G("div",{class:"buttons"},a,l,c,u,h,f),_,m);function d(U){if(!o.line)return;o.t=Math.min(Math.max(U,o.line.begin),o.line.end),i.show(o.t),e?.show(o.t);let B=o.line.watchedAt(o.t)/o.line.total;p.value=B,_.style.setProperty("--share",B),M(),o.playing||r()}function M(){let U=hl(o.flights),B=U===null?"":` · ${o.t>=U?"+":"−"}${Math.abs(1e3*(o.t-U)).toFixed(1)} ms from touch`,K=o.pace==="auto"?o.line.paceAt(o.t):1/Number(o.pace);f.replaceChildren(G("b",{},`${o.t.toFixed(4)} s`),G("span",{},B),G("span",{class:"pace"},Ay(K))),p.setAttribute("aria-valuetext",`${o.t.toFixed(3)} s${B}`),n&&V()}function S(U){if(!o.playing)return;let B=Math.min((U-o.last)/1e3,.1);o.last=U;let K=o.line,ne=o.pace==="auto"?K.timeAt(K.watchedAt(o.t)+B):o.t+B/Number(o.pace);d(ne),o.t>=K.end?P():requestAnimationFrame(S)}function x(){!o.line||o.playing||(o.t>=o.line.end-1e-9&&d(o.line.begin),o.playing=!0,o.last=performance.now(),T(),requestAnimationFrame(S))}function P(){o.playing&&setTimeout(r),o.playing=!1,T()}function T(){a.replaceChildren(Gi(o.playing?"pause":"play")),a.setAttribute("aria-label",o.playing?"Pause":"Play"),a.title=o.playing?"Pause (space)":"Play (space)"}function C(U){o.pace=U==="auto"?"auto":String(na.reduce((B,K)=>Math.abs(K-U)<Math.abs(B-U)?K:B)),h.value=o.pace,M(),r()}function I(U){let B=o.pace==="auto"?U>0?0:1:na.indexOf(Number(o.pace))+U;C(na[Math.min(Math.max(B,0),na.length-1)])}function b(U){P();let B=o.flights[0],K=o.t-B.shift,ne=cl(B.t,K+1e-9),ee=B.t[ne]<K-1e-9&&U<0?ne:ne+U;d(B.t[Math.min(Math.max(ee,0),B.n-1)]+B.shift)}function E(){P();let U=hl(o.flights);U!==null&&d(U)}function w(){let U=o.line,B=ee=>U.watchedAt(ee)/U.total;g.replaceChildren(...U.stretches.map(([ee,le])=>{let ce=G("span",{class:"slow"});return ce.style.left=`${100*B(ee)}%`,ce.style.width=`${100*Math.max(B(le)-B(ee),.002)}%`,ce}));let K=o.flights.flatMap(ee=>ee.events.map(le=>({...le,t:le.t+ee.shift,flight:ee})));K.sort((ee,le)=>ee.t-le.t);for(let ee of K){let le=G("i",{class:ee.kind});le.style.left=`${100*B(ee.t)}%`,o.flights.length>1&&(le.style.background=ee.flight.colour),g.append(le)}let ne=o.flights.length>1;m.replaceChildren(...K.filter(ee=>ee.kind!=="end"||!ne).slice(0,60).map(ee=>{let le=ne?`${ee.flight.label}: ${ee.label}`:ee.label,ce=G("button",{type:"button",class:`event ${ee.kind}`,title:`${ee.text}, ${ee.t.toFixed(4)} s`,onclick:()=>{P(),d(ee.t)}},G("span",{},le),G("small",{},` ${ee.t.toFixed(3)} s`));return ne&&ce.style.setProperty("--colour",ee.flight.colour),ce}))}let O=[];function z(){if(!n)return;let U=["speed","acceleration","compression, largest","contact force, sum of all contacts","thrust, all rotors"],B=["m/s","m/s²","mm","N","N"],K=o.flights.length>2,ne=G("table",{class:K?"numbers crowded":"numbers"});o.flights.length>1&&ne.append(G("thead",{},G("tr",{},G("th",{},""),...o.flights.map(le=>{let ce=G("th",{scope:"col"},le.label);return ce.style.color=le.colour,ce}),...K?[]:[G("th",{},"")])));let ee=G("tbody");O=U.map((le,ce)=>{let ye=o.flights.map(()=>G("td")),Re=G("td",{class:"unit"},B[ce]);return ee.append(G("tr",{},G("th",{scope:"row"},K?`${le} [${B[ce]}]`:le),...ye,...K?[]:[Re])),ye}),ne.append(ee),n.replaceChildren(ne)}function V(){o.flights.forEach((U,B)=>{let K=qo(U,o.t),ne=j=>U.series.find(X=>X.panel===j),ee=j=>ne(j)?Yo({flight:U,values:ne(j).values},o.t):0,le=Math.max(0,...U.arms.map((j,X)=>j.compliant?1e3*(j.length-K.armLengths[X]):0)),ce=Math.hypot(...[0,1,2].map(j=>K.contacts.reduce((X,de)=>X+(de?de.force[j]:0),0))),ye=[ee("Velocity"),ee("Acceleration"),le,ce,K.thrust.reduce((j,X)=>j+X,0)],Re=!U.arms.some(j=>j.compliant);ye.forEach((j,X)=>O[X][B].textContent=X===2&&Re?"rigid":$m(j))})}function W(U){if(U.ctrlKey||U.metaKey||U.altKey||U.target.closest?.("dialog"))return;let B=U.target.tagName;if(B==="TEXTAREA"||B==="SELECT"||B==="INPUT"&&U.target.type!=="range"||U.target.type==="range"&&U.target!==p)return;let K=U.shiftKey?10:1,ne={" ":()=>o.playing?P():x(),ArrowRight:()=>b(K),ArrowLeft:()=>b(-K),Home:()=>(P(),d(o.line.begin)),End:()=>(P(),d(o.line.end)),",":()=>I(1),".":()=>I(-1),t:E,...s};if(U.key===" "&&B==="BUTTON")return;let ee=ne[U.key];!ee||!o.line||ee()!==!1&&U.preventDefault()}document.addEventListener("keydown",W);function q({keepTime:U=!0}={}){o.flights=i.flights,o.line=xp(o.flights),z(),e?.replace(o.flights),w();let B=hl(o.flights);d(U?o.t:B===null?o.line.begin:B-Ty)}return T(),{replace:q,seek:d,play:x,pause:P,setPace:C,goToTouch:E,get time(){return o.t},get playing(){return o.playing},get pace(){return o.pace},dispose(){P(),document.removeEventListener("keydown",W),t.replaceChildren()}}}var ks={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Tg=0,Df=1,Ag=2;var Uf=1,Rg=2,ji=3,gs=0,zn=1,kn=2,vs=0,hr=1,Nf=2,Ff=3,Of=4,Cg=5,Fs=100,Pg=101,Ig=102,Lg=103,Dg=104,Ug=200,Ng=201,Fg=202,Og=203,oc=204,ac=205,Bg=206,zg=207,kg=208,Hg=209,Vg=210,Gg=211,Wg=212,Xg=213,qg=214,zc=0,kc=1,Hc=2,ur=3,Vc=4,Gc=5,Wc=6,Xc=7,Bf=0,Yg=1,$g=2,xs=0,Zg=1,Kg=2,Jg=3,jg=4,Qg=5,e0=6,t0=7;var zf=300,xr=301,yr=302,qc=303,Yc=304,Wa=306,lc=1e3,Ns=1001,cc=1002,mi=1003,n0=1004;var Xa=1005;var Li=1006,$c=1007;var Vs=1008;var Fi=1009,kf=1010,Hf=1011,Ao=1012,Zc=1013,Gs=1014,Qi=1015,Ro=1016,Kc=1017,Jc=1018,Co=1020,Vf=35902,Gf=35899,Wf=1021,Xf=1022,gi=1023,go=1026,Po=1027,qf=1028,jc=1029,Yf=1030,Qc=1031;var eh=1033,qa=33776,Ya=33777,$a=33778,Za=33779,th=35840,nh=35841,ih=35842,sh=35843,rh=36196,oh=37492,ah=37496,lh=37808,ch=37809,hh=37810,uh=37811,fh=37812,dh=37813,ph=37814,mh=37815,gh=37816,_h=37817,vh=37818,xh=37819,yh=37820,bh=37821,Mh=36492,Sh=36494,wh=36495,Eh=36283,Th=36284,Ah=36285,Rh=36286;var pa=2300,hc=2301,rc=2302,Tf=2400,Af=2401,Rf=2402;var i0=3200,s0=3201;var $f=0,r0=1,ys="",Bn="srgb",fr="srgb-linear",ma="linear",Ct="srgb";var cr=7680;var Cf=519,o0=512,a0=513,l0=514,Zf=515,c0=516,h0=517,u0=518,f0=519,uc=35044;var Kf="300 es",Ii=2e3,ga=2001;var Yi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},En=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Km=1234567,po=Math.PI/180,_o=180/Math.PI;function ps(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(En[i&255]+En[i>>8&255]+En[i>>16&255]+En[i>>24&255]+"-"+En[e&255]+En[e>>8&255]+"-"+En[e>>16&15|64]+En[e>>24&255]+"-"+En[t&63|128]+En[t>>8&255]+"-"+En[t>>16&255]+En[t>>24&255]+En[n&255]+En[n>>8&255]+En[n>>16&255]+En[n>>24&255]).toLowerCase()}function st(i,e,t){return Math.max(e,Math.min(t,i))}function Jf(i,e){return(i%e+e)%e}function Ry(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function Cy(i,e,t){return i!==e?(t-i)/(e-i):0}function ua(i,e,t){return(1-t)*i+t*e}function Py(i,e,t,n){return ua(i,e,1-Math.exp(-t*n))}function Iy(i,e=1){return e-Math.abs(Jf(i,e*2)-e)}function Ly(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Dy(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Uy(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Ny(i,e){return i+Math.random()*(e-i)}function Fy(i){return i*(.5-Math.random())}function Oy(i){i!==void 0&&(Km=i);let e=Km+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function By(i){return i*po}function zy(i){return i*_o}function ky(i){return(i&i-1)===0&&i!==0}function Hy(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Vy(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Gy(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),f=o((e-n)/2),p=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*g,l*p,a*c);break;case"YXY":i.set(l*p,a*u,l*g,a*c);break;case"ZYZ":i.set(l*g,l*p,a*u,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Pi(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Rt(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Ws={DEG2RAD:po,RAD2DEG:_o,generateUUID:ps,clamp:st,euclideanModulo:Jf,mapLinear:Ry,inverseLerp:Cy,lerp:ua,damp:Py,pingpong:Iy,smoothstep:Ly,smootherstep:Dy,randInt:Uy,randFloat:Ny,randFloatSpread:Fy,seededRandom:Oy,degToRad:By,radToDeg:zy,isPowerOfTwo:ky,ceilPowerOfTwo:Hy,floorPowerOfTwo:Vy,setQuaternionFromProperEuler:Gy,normalize:Rt,denormalize:Pi},Fe=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=st(this.x,e.x,t.x),this.y=st(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=st(this.x,e,t),this.y=st(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(st(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(st(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Xn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],p=r[o+1],g=r[o+2],_=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=f,e[t+1]=p,e[t+2]=g,e[t+3]=_;return}if(h!==_||l!==f||c!==p||u!==g){let m=1-a,d=l*f+c*p+u*g+h*_,M=d>=0?1:-1,S=1-d*d;if(S>Number.EPSILON){let P=Math.sqrt(S),T=Math.atan2(P,d*M);m=Math.sin(m*T)/P,a=Math.sin(a*T)/P}let x=a*M;if(l=l*m+f*x,c=c*m+p*x,u=u*m+g*x,h=h*m+_*x,m===1-a){let P=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=P,c*=P,u*=P,h*=P}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],p=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*p-c*f,e[t+1]=l*g+u*f+c*h-a*p,e[t+2]=c*g+u*p+a*f-l*h,e[t+3]=u*g-a*h-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h-f*p*g;break;case"YXZ":this._x=f*u*h+c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h+f*p*g;break;case"ZXY":this._x=f*u*h-c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h-f*p*g;break;case"ZYX":this._x=f*u*h-c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h+f*p*g;break;case"YZX":this._x=f*u*h+c*p*g,this._y=c*p*h+f*u*g,this._z=c*u*g-f*p*h,this._w=c*u*h-f*p*g;break;case"XZY":this._x=f*u*h-c*p*g,this._y=c*p*h-f*u*g,this._z=c*u*g+f*p*h,this._w=c*u*h+f*p*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=n+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>h){let p=2*Math.sqrt(1+n-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-n-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(st(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let p=1-t;return this._w=p*o+t*this._w,this._x=p*n+t*this._x,this._y=p*s+t*this._y,this._z=p*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,f=Math.sin(t*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},N=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Jm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Jm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=st(this.x,e.x,t.x),this.y=st(this.y,e.y,t.y),this.z=st(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=st(this.x,e,t),this.y=st(this.y,e,t),this.z=st(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(st(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Zu.copy(this).projectOnVector(e),this.sub(Zu)}reflect(e){return this.sub(Zu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(st(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Zu=new N,Jm=new Xn,lt=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],p=n[5],g=n[8],_=s[0],m=s[3],d=s[6],M=s[1],S=s[4],x=s[7],P=s[2],T=s[5],C=s[8];return r[0]=o*_+a*M+l*P,r[3]=o*m+a*S+l*T,r[6]=o*d+a*x+l*C,r[1]=c*_+u*M+h*P,r[4]=c*m+u*S+h*T,r[7]=c*d+u*x+h*C,r[2]=f*_+p*M+g*P,r[5]=f*m+p*S+g*T,r[8]=f*d+p*x+g*C,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,p=c*r-o*l,g=t*h+n*f+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return e[0]=h*_,e[1]=(s*c-u*n)*_,e[2]=(a*n-s*o)*_,e[3]=f*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=p*_,e[7]=(n*l-c*t)*_,e[8]=(o*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Ku.makeScale(e,t)),this}rotate(e){return this.premultiply(Ku.makeRotation(-e)),this}translate(e,t){return this.premultiply(Ku.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ku=new lt;function jf(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function _a(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function d0(){let i=_a("canvas");return i.style.display="block",i}var jm={};function vo(i){i in jm||(jm[i]=!0,console.warn(i))}function p0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Qm=new lt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),eg=new lt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Wy(){let i={enabled:!0,workingColorSpace:fr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=mo(s.r),s.g=mo(s.g),s.b=mo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?ma:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return vo("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return vo("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[fr]:{primaries:e,whitePoint:n,transfer:ma,toXYZ:Qm,fromXYZ:eg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Bn},outputColorSpaceConfig:{drawingBufferColorSpace:Bn}},[Bn]:{primaries:e,whitePoint:n,transfer:Ct,toXYZ:Qm,fromXYZ:eg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Bn}}}),i}var vt=Wy();function ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function mo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Zr,fc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Zr===void 0&&(Zr=_a("canvas")),Zr.width=e.width,Zr.height=e.height;let s=Zr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Zr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=_a("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ms(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ms(t[n]/255)*255):t[n]=ms(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Xy=0,xo=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Xy++}),this.uuid=ps(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ju(s[o].image)):r.push(Ju(s[o]))}else r=Ju(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Ju(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?fc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var qy=0,ju=new N,qn=class i extends Yi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Ns,s=Ns,r=Li,o=Vs,a=gi,l=Fi,c=i.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:qy++}),this.uuid=ps(),this.name="",this.source=new xo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Fe(0,0),this.repeat=new Fe(1,1),this.center=new Fe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new lt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(ju).x}get height(){return this.source.getSize(ju).y}get depth(){return this.source.getSize(ju).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==zf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case lc:e.x=e.x-Math.floor(e.x);break;case Ns:e.x=e.x<0?0:1;break;case cc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case lc:e.y=e.y-Math.floor(e.y);break;case Ns:e.y=e.y<0?0:1;break;case cc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};qn.DEFAULT_IMAGE=null;qn.DEFAULT_MAPPING=zf;qn.DEFAULT_ANISOTROPY=1;var Pt=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],g=l[9],_=l[2],m=l[6],d=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-_)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+_)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(c+1)/2,x=(p+1)/2,P=(d+1)/2,T=(u+f)/4,C=(h+_)/4,I=(g+m)/4;return S>x&&S>P?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=T/n,r=C/n):x>P?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=T/s,r=I/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=C/r,s=I/r),this.set(n,s,r,t),this}let M=Math.sqrt((m-g)*(m-g)+(h-_)*(h-_)+(f-u)*(f-u));return Math.abs(M)<.001&&(M=1),this.x=(m-g)/M,this.y=(h-_)/M,this.z=(f-u)/M,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=st(this.x,e.x,t.x),this.y=st(this.y,e.y,t.y),this.z=st(this.z,e.z,t.z),this.w=st(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=st(this.x,e,t),this.y=st(this.y,e,t),this.z=st(this.z,e,t),this.w=st(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(st(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},dc=class extends Yi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Li,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Pt(0,0,e,t),this.scissorTest=!1,this.viewport=new Pt(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new qn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:Li,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new xo(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},$i=class extends dc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},va=class extends qn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=mi,this.minFilter=mi,this.wrapR=Ns,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var pc=class extends qn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=mi,this.minFilter=mi,this.wrapR=Ns,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var _n=class{constructor(e=new N(1/0,1/0,1/0),t=new N(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ai.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ai.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ai.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(e.matrixWorld),this.expandByPoint(Ai);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Pl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Pl.copy(n.boundingBox)),Pl.applyMatrix4(e.matrixWorld),this.union(Pl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ai),Ai.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ia),Il.subVectors(this.max,ia),Kr.subVectors(e.a,ia),Jr.subVectors(e.b,ia),jr.subVectors(e.c,ia),Cs.subVectors(Jr,Kr),Ps.subVectors(jr,Jr),rr.subVectors(Kr,jr);let t=[0,-Cs.z,Cs.y,0,-Ps.z,Ps.y,0,-rr.z,rr.y,Cs.z,0,-Cs.x,Ps.z,0,-Ps.x,rr.z,0,-rr.x,-Cs.y,Cs.x,0,-Ps.y,Ps.x,0,-rr.y,rr.x,0];return!Qu(t,Kr,Jr,jr,Il)||(t=[1,0,0,0,1,0,0,0,1],!Qu(t,Kr,Jr,jr,Il))?!1:(Ll.crossVectors(Cs,Ps),t=[Ll.x,Ll.y,Ll.z],Qu(t,Kr,Jr,jr,Il))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ai).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ai).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(cs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},cs=[new N,new N,new N,new N,new N,new N,new N,new N],Ai=new N,Pl=new _n,Kr=new N,Jr=new N,jr=new N,Cs=new N,Ps=new N,rr=new N,ia=new N,Il=new N,Ll=new N,or=new N;function Qu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){or.fromArray(i,r);let a=s.x*Math.abs(or.x)+s.y*Math.abs(or.y)+s.z*Math.abs(or.z),l=e.dot(or),c=t.dot(or),u=n.dot(or);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Yy=new _n,sa=new N,ef=new N,Di=class{constructor(e=new N,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Yy.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;sa.subVectors(e,this.center);let t=sa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(sa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ef.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(sa.copy(e.center).add(ef)),this.expandByPoint(sa.copy(e.center).sub(ef))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},hs=new N,tf=new N,Dl=new N,Is=new N,nf=new N,Ul=new N,sf=new N,dr=class{constructor(e=new N,t=new N(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,hs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=hs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(hs.copy(this.origin).addScaledVector(this.direction,t),hs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){tf.copy(e).add(t).multiplyScalar(.5),Dl.copy(t).sub(e).normalize(),Is.copy(this.origin).sub(tf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Dl),a=Is.dot(this.direction),l=-Is.dot(Dl),c=Is.lengthSq(),u=Math.abs(1-o*o),h,f,p,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){let _=1/u;h*=_,f*=_,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(tf).addScaledVector(Dl,f),p}intersectSphere(e,t){hs.subVectors(e.center,this.origin);let n=hs.dot(this.direction),s=hs.dot(hs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,hs)!==null}intersectTriangle(e,t,n,s,r){nf.subVectors(t,e),Ul.subVectors(n,e),sf.crossVectors(nf,Ul);let o=this.direction.dot(sf),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Is.subVectors(this.origin,e);let l=a*this.direction.dot(Ul.crossVectors(Is,Ul));if(l<0)return null;let c=a*this.direction.dot(nf.cross(Is));if(c<0||l+c>o)return null;let u=-a*Is.dot(sf);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Dt=class i{constructor(e,t,n,s,r,o,a,l,c,u,h,f,p,g,_,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,f,p,g,_,m)}set(e,t,n,s,r,o,a,l,c,u,h,f,p,g,_,m){let d=this.elements;return d[0]=e,d[4]=t,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=h,d[14]=f,d[3]=p,d[7]=g,d[11]=_,d[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/Qr.setFromMatrixColumn(e,0).length(),r=1/Qr.setFromMatrixColumn(e,1).length(),o=1/Qr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,p=o*h,g=a*u,_=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=p+g*c,t[5]=f-_*c,t[9]=-a*l,t[2]=_-f*c,t[6]=g+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,p=l*h,g=c*u,_=c*h;t[0]=f+_*a,t[4]=g*a-p,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=p*a-g,t[6]=_+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,p=l*h,g=c*u,_=c*h;t[0]=f-_*a,t[4]=-o*h,t[8]=g+p*a,t[1]=p+g*a,t[5]=o*u,t[9]=_-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,p=o*h,g=a*u,_=a*h;t[0]=l*u,t[4]=g*c-p,t[8]=f*c+_,t[1]=l*h,t[5]=_*c+f,t[9]=p*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,g=a*l,_=a*c;t[0]=l*u,t[4]=_-f*h,t[8]=g*h+p,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*h+g,t[10]=f-_*h}else if(e.order==="XZY"){let f=o*l,p=o*c,g=a*l,_=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+_,t[5]=o*u,t[9]=p*h-g,t[2]=g*h-p,t[6]=a*u,t[10]=_*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose($y,e,Zy)}lookAt(e,t,n){let s=this.elements;return ii.subVectors(e,t),ii.lengthSq()===0&&(ii.z=1),ii.normalize(),Ls.crossVectors(n,ii),Ls.lengthSq()===0&&(Math.abs(n.z)===1?ii.x+=1e-4:ii.z+=1e-4,ii.normalize(),Ls.crossVectors(n,ii)),Ls.normalize(),Nl.crossVectors(ii,Ls),s[0]=Ls.x,s[4]=Nl.x,s[8]=ii.x,s[1]=Ls.y,s[5]=Nl.y,s[9]=ii.y,s[2]=Ls.z,s[6]=Nl.z,s[10]=ii.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],p=n[13],g=n[2],_=n[6],m=n[10],d=n[14],M=n[3],S=n[7],x=n[11],P=n[15],T=s[0],C=s[4],I=s[8],b=s[12],E=s[1],w=s[5],O=s[9],z=s[13],V=s[2],W=s[6],q=s[10],U=s[14],B=s[3],K=s[7],ne=s[11],ee=s[15];return r[0]=o*T+a*E+l*V+c*B,r[4]=o*C+a*w+l*W+c*K,r[8]=o*I+a*O+l*q+c*ne,r[12]=o*b+a*z+l*U+c*ee,r[1]=u*T+h*E+f*V+p*B,r[5]=u*C+h*w+f*W+p*K,r[9]=u*I+h*O+f*q+p*ne,r[13]=u*b+h*z+f*U+p*ee,r[2]=g*T+_*E+m*V+d*B,r[6]=g*C+_*w+m*W+d*K,r[10]=g*I+_*O+m*q+d*ne,r[14]=g*b+_*z+m*U+d*ee,r[3]=M*T+S*E+x*V+P*B,r[7]=M*C+S*w+x*W+P*K,r[11]=M*I+S*O+x*q+P*ne,r[15]=M*b+S*z+x*U+P*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],p=e[14],g=e[3],_=e[7],m=e[11],d=e[15];return g*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*p-n*l*p)+_*(+t*l*p-t*c*f+r*o*f-s*o*p+s*c*u-r*l*u)+m*(+t*c*h-t*a*p-r*o*h+n*o*p+r*a*u-n*c*u)+d*(-s*a*u-t*l*h+t*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],p=e[11],g=e[12],_=e[13],m=e[14],d=e[15],M=h*m*c-_*f*c+_*l*p-a*m*p-h*l*d+a*f*d,S=g*f*c-u*m*c-g*l*p+o*m*p+u*l*d-o*f*d,x=u*_*c-g*h*c+g*a*p-o*_*p-u*a*d+o*h*d,P=g*h*l-u*_*l-g*a*f+o*_*f+u*a*m-o*h*m,T=t*M+n*S+s*x+r*P;if(T===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let C=1/T;return e[0]=M*C,e[1]=(_*f*r-h*m*r-_*s*p+n*m*p+h*s*d-n*f*d)*C,e[2]=(a*m*r-_*l*r+_*s*c-n*m*c-a*s*d+n*l*d)*C,e[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*p-n*l*p)*C,e[4]=S*C,e[5]=(u*m*r-g*f*r+g*s*p-t*m*p-u*s*d+t*f*d)*C,e[6]=(g*l*r-o*m*r-g*s*c+t*m*c+o*s*d-t*l*d)*C,e[7]=(o*f*r-u*l*r+u*s*c-t*f*c-o*s*p+t*l*p)*C,e[8]=x*C,e[9]=(g*h*r-u*_*r-g*n*p+t*_*p+u*n*d-t*h*d)*C,e[10]=(o*_*r-g*a*r+g*n*c-t*_*c-o*n*d+t*a*d)*C,e[11]=(u*a*r-o*h*r-u*n*c+t*h*c+o*n*p-t*a*p)*C,e[12]=P*C,e[13]=(u*_*s-g*h*s+g*n*f-t*_*f-u*n*m+t*h*m)*C,e[14]=(g*a*s-o*_*s-g*n*l+t*_*l+o*n*m-t*a*m)*C,e[15]=(o*h*s-u*a*s+u*n*l-t*h*l-o*n*f+t*a*f)*C,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,p=r*u,g=r*h,_=o*u,m=o*h,d=a*h,M=l*c,S=l*u,x=l*h,P=n.x,T=n.y,C=n.z;return s[0]=(1-(_+d))*P,s[1]=(p+x)*P,s[2]=(g-S)*P,s[3]=0,s[4]=(p-x)*T,s[5]=(1-(f+d))*T,s[6]=(m+M)*T,s[7]=0,s[8]=(g+S)*C,s[9]=(m-M)*C,s[10]=(1-(f+_))*C,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=Qr.set(s[0],s[1],s[2]).length(),o=Qr.set(s[4],s[5],s[6]).length(),a=Qr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Ri.copy(this);let c=1/r,u=1/o,h=1/a;return Ri.elements[0]*=c,Ri.elements[1]*=c,Ri.elements[2]*=c,Ri.elements[4]*=u,Ri.elements[5]*=u,Ri.elements[6]*=u,Ri.elements[8]*=h,Ri.elements[9]*=h,Ri.elements[10]*=h,t.setFromRotationMatrix(Ri),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),f=(t+e)/(t-e),p=(n+s)/(n-s),g,_;if(l)g=r/(o-r),_=o*r/(o-r);else if(a===Ii)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ga)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),f=-(t+e)/(t-e),p=-(n+s)/(n-s),g,_;if(l)g=1/(o-r),_=o/(o-r);else if(a===Ii)g=-2/(o-r),_=-(o+r)/(o-r);else if(a===ga)g=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Qr=new N,Ri=new Dt,$y=new N(0,0,0),Zy=new N(1,1,1),Ls=new N,Nl=new N,ii=new N,tg=new Dt,ng=new Xn,Ui=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(st(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-st(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(st(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-st(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(st(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-st(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return tg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(tg,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ng.setFromEuler(this),this.setFromQuaternion(ng,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ui.DEFAULT_ORDER="XYZ";var xa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Ky=0,ig=new N,eo=new Xn,us=new Dt,Fl=new N,ra=new N,Jy=new N,jy=new Xn,sg=new N(1,0,0),rg=new N(0,1,0),og=new N(0,0,1),ag={type:"added"},Qy={type:"removed"},to={type:"childadded",child:null},rf={type:"childremoved",child:null},on=class i extends Yi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ky++}),this.uuid=ps(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new N,t=new Ui,n=new Xn,s=new N(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Dt},normalMatrix:{value:new lt}}),this.matrix=new Dt,this.matrixWorld=new Dt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new xa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return eo.setFromAxisAngle(e,t),this.quaternion.multiply(eo),this}rotateOnWorldAxis(e,t){return eo.setFromAxisAngle(e,t),this.quaternion.premultiply(eo),this}rotateX(e){return this.rotateOnAxis(sg,e)}rotateY(e){return this.rotateOnAxis(rg,e)}rotateZ(e){return this.rotateOnAxis(og,e)}translateOnAxis(e,t){return ig.copy(e).applyQuaternion(this.quaternion),this.position.add(ig.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(sg,e)}translateY(e){return this.translateOnAxis(rg,e)}translateZ(e){return this.translateOnAxis(og,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(us.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Fl.copy(e):Fl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ra.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?us.lookAt(ra,Fl,this.up):us.lookAt(Fl,ra,this.up),this.quaternion.setFromRotationMatrix(us),s&&(us.extractRotation(s.matrixWorld),eo.setFromRotationMatrix(us),this.quaternion.premultiply(eo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ag),to.child=e,this.dispatchEvent(to),to.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Qy),rf.child=e,this.dispatchEvent(rf),rf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),us.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),us.multiply(e.parent.matrixWorld)),e.applyMatrix4(us),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ag),to.child=e,this.dispatchEvent(to),to.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ra,e,Jy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ra,jy,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),p=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};on.DEFAULT_UP=new N(0,1,0);on.DEFAULT_MATRIX_AUTO_UPDATE=!0;on.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ci=new N,fs=new N,of=new N,ds=new N,no=new N,io=new N,lg=new N,af=new N,lf=new N,cf=new N,hf=new Pt,uf=new Pt,ff=new Pt,qi=class i{constructor(e=new N,t=new N,n=new N){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ci.subVectors(e,t),s.cross(Ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ci.subVectors(s,t),fs.subVectors(n,t),of.subVectors(e,t);let o=Ci.dot(Ci),a=Ci.dot(fs),l=Ci.dot(of),c=fs.dot(fs),u=fs.dot(of),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-p-g,g,p)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ds)===null?!1:ds.x>=0&&ds.y>=0&&ds.x+ds.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ds.x),l.addScaledVector(o,ds.y),l.addScaledVector(a,ds.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return hf.setScalar(0),uf.setScalar(0),ff.setScalar(0),hf.fromBufferAttribute(e,t),uf.fromBufferAttribute(e,n),ff.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(hf,r.x),o.addScaledVector(uf,r.y),o.addScaledVector(ff,r.z),o}static isFrontFacing(e,t,n,s){return Ci.subVectors(n,t),fs.subVectors(e,t),Ci.cross(fs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ci.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ci.cross(fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;no.subVectors(s,n),io.subVectors(r,n),af.subVectors(e,n);let l=no.dot(af),c=io.dot(af);if(l<=0&&c<=0)return t.copy(n);lf.subVectors(e,s);let u=no.dot(lf),h=io.dot(lf);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(n).addScaledVector(no,o);cf.subVectors(e,r);let p=no.dot(cf),g=io.dot(cf);if(g>=0&&p<=g)return t.copy(r);let _=p*c-l*g;if(_<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(io,a);let m=u*g-p*h;if(m<=0&&h-u>=0&&p-g>=0)return lg.subVectors(r,s),a=(h-u)/(h-u+(p-g)),t.copy(s).addScaledVector(lg,a);let d=1/(m+_+f);return o=_*d,a=f*d,t.copy(n).addScaledVector(no,o).addScaledVector(io,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},m0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ds={h:0,s:0,l:0},Ol={h:0,s:0,l:0};function df(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ct=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Bn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=n,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=vt.workingColorSpace){if(e=Jf(e,1),t=st(t,0,1),n=st(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=df(o,r,e+1/3),this.g=df(o,r,e),this.b=df(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=Bn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Bn){let n=m0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ms(e.r),this.g=ms(e.g),this.b=ms(e.b),this}copyLinearToSRGB(e){return this.r=mo(e.r),this.g=mo(e.g),this.b=mo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Bn){return vt.workingToColorSpace(Tn.copy(this),e),Math.round(st(Tn.r*255,0,255))*65536+Math.round(st(Tn.g*255,0,255))*256+Math.round(st(Tn.b*255,0,255))}getHexString(e=Bn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(Tn.copy(this),t);let n=Tn.r,s=Tn.g,r=Tn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(Tn.copy(this),t),e.r=Tn.r,e.g=Tn.g,e.b=Tn.b,e}getStyle(e=Bn){vt.workingToColorSpace(Tn.copy(this),e);let t=Tn.r,n=Tn.g,s=Tn.b;return e!==Bn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Ds),this.setHSL(Ds.h+e,Ds.s+t,Ds.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ds),e.getHSL(Ol);let n=ua(Ds.h,Ol.h,t),s=ua(Ds.s,Ol.s,t),r=ua(Ds.l,Ol.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Tn=new ct;ct.NAMES=m0;var eb=0,Zi=class extends Yi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:eb++}),this.uuid=ps(),this.name="",this.type="Material",this.blending=hr,this.side=gs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=oc,this.blendDst=ac,this.blendEquation=Fs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ct(0,0,0),this.blendAlpha=0,this.depthFunc=ur,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Cf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=cr,this.stencilZFail=cr,this.stencilZPass=cr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==hr&&(n.blending=this.blending),this.side!==gs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==oc&&(n.blendSrc=this.blendSrc),this.blendDst!==ac&&(n.blendDst=this.blendDst),this.blendEquation!==Fs&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==ur&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Cf&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==cr&&(n.stencilFail=this.stencilFail),this.stencilZFail!==cr&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==cr&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Ni=class extends Zi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ct(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.combine=Bf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var en=new N,Bl=new Fe,tb=0,tn=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:tb++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=uc,this.updateRanges=[],this.gpuType=Qi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Bl.fromBufferAttribute(this,t),Bl.applyMatrix3(e),this.setXY(t,Bl.x,Bl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)en.fromBufferAttribute(this,t),en.applyMatrix3(e),this.setXYZ(t,en.x,en.y,en.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)en.fromBufferAttribute(this,t),en.applyMatrix4(e),this.setXYZ(t,en.x,en.y,en.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)en.fromBufferAttribute(this,t),en.applyNormalMatrix(e),this.setXYZ(t,en.x,en.y,en.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)en.fromBufferAttribute(this,t),en.transformDirection(e),this.setXYZ(t,en.x,en.y,en.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Rt(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Pi(t,this.array)),t}setX(e,t){return this.normalized&&(t=Rt(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Pi(t,this.array)),t}setY(e,t){return this.normalized&&(t=Rt(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Pi(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Rt(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Pi(t,this.array)),t}setW(e,t){return this.normalized&&(t=Rt(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Rt(t,this.array),n=Rt(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Rt(t,this.array),n=Rt(n,this.array),s=Rt(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Rt(t,this.array),n=Rt(n,this.array),s=Rt(s,this.array),r=Rt(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==uc&&(e.usage=this.usage),e}};var ya=class extends tn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var ba=class extends tn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var pt=class extends tn{constructor(e,t,n){super(new Float32Array(e),t,n)}},nb=0,pi=new Dt,pf=new on,so=new N,si=new _n,oa=new _n,gn=new N,qt=class i extends Yi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:nb++}),this.uuid=ps(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(jf(e)?ba:ya)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new lt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return pi.makeRotationFromQuaternion(e),this.applyMatrix4(pi),this}rotateX(e){return pi.makeRotationX(e),this.applyMatrix4(pi),this}rotateY(e){return pi.makeRotationY(e),this.applyMatrix4(pi),this}rotateZ(e){return pi.makeRotationZ(e),this.applyMatrix4(pi),this}translate(e,t,n){return pi.makeTranslation(e,t,n),this.applyMatrix4(pi),this}scale(e,t,n){return pi.makeScale(e,t,n),this.applyMatrix4(pi),this}lookAt(e){return pf.lookAt(e),pf.updateMatrix(),this.applyMatrix4(pf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(so).negate(),this.translate(so.x,so.y,so.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new pt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new _n);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new N(-1/0,-1/0,-1/0),new N(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];si.setFromBufferAttribute(r),this.morphTargetsRelative?(gn.addVectors(this.boundingBox.min,si.min),this.boundingBox.expandByPoint(gn),gn.addVectors(this.boundingBox.max,si.max),this.boundingBox.expandByPoint(gn)):(this.boundingBox.expandByPoint(si.min),this.boundingBox.expandByPoint(si.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new N,1/0);return}if(e){let n=this.boundingSphere.center;if(si.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];oa.setFromBufferAttribute(a),this.morphTargetsRelative?(gn.addVectors(si.min,oa.min),si.expandByPoint(gn),gn.addVectors(si.max,oa.max),si.expandByPoint(gn)):(si.expandByPoint(oa.min),si.expandByPoint(oa.max))}si.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)gn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(gn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)gn.fromBufferAttribute(a,c),l&&(so.fromBufferAttribute(e,c),gn.add(so)),s=Math.max(s,n.distanceToSquared(gn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new tn(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let I=0;I<n.count;I++)a[I]=new N,l[I]=new N;let c=new N,u=new N,h=new N,f=new Fe,p=new Fe,g=new Fe,_=new N,m=new N;function d(I,b,E){c.fromBufferAttribute(n,I),u.fromBufferAttribute(n,b),h.fromBufferAttribute(n,E),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,b),g.fromBufferAttribute(r,E),u.sub(c),h.sub(c),p.sub(f),g.sub(f);let w=1/(p.x*g.y-g.x*p.y);isFinite(w)&&(_.copy(u).multiplyScalar(g.y).addScaledVector(h,-p.y).multiplyScalar(w),m.copy(h).multiplyScalar(p.x).addScaledVector(u,-g.x).multiplyScalar(w),a[I].add(_),a[b].add(_),a[E].add(_),l[I].add(m),l[b].add(m),l[E].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let I=0,b=M.length;I<b;++I){let E=M[I],w=E.start,O=E.count;for(let z=w,V=w+O;z<V;z+=3)d(e.getX(z+0),e.getX(z+1),e.getX(z+2))}let S=new N,x=new N,P=new N,T=new N;function C(I){P.fromBufferAttribute(s,I),T.copy(P);let b=a[I];S.copy(b),S.sub(P.multiplyScalar(P.dot(b))).normalize(),x.crossVectors(T,b);let w=x.dot(l[I])<0?-1:1;o.setXYZW(I,S.x,S.y,S.z,w)}for(let I=0,b=M.length;I<b;++I){let E=M[I],w=E.start,O=E.count;for(let z=w,V=w+O;z<V;z+=3)C(e.getX(z+0)),C(e.getX(z+1)),C(e.getX(z+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new tn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);let s=new N,r=new N,o=new N,a=new N,l=new N,c=new N,u=new N,h=new N;if(e)for(let f=0,p=e.count;f<p;f+=3){let g=e.getX(f+0),_=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)gn.fromBufferAttribute(e,t),gn.normalize(),e.setXYZ(t,gn.x,gn.y,gn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,g=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?p=l[_]*a.data.stride+a.offset:p=l[_]*u;for(let d=0;d<u;d++)f[g++]=c[p++]}return new tn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=e(f,n);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},cg=new Dt,ar=new dr,zl=new Di,hg=new N,kl=new N,Hl=new N,Vl=new N,mf=new N,Gl=new N,ug=new N,Wl=new N,ut=class extends on{constructor(e=new qt,t=new Ni){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Gl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(mf.fromBufferAttribute(h,e),o?Gl.addScaledVector(mf,u):Gl.addScaledVector(mf.sub(t),u))}t.add(Gl)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),zl.copy(n.boundingSphere),zl.applyMatrix4(r),ar.copy(e.ray).recast(e.near),!(zl.containsPoint(ar.origin)===!1&&(ar.intersectSphere(zl,hg)===null||ar.origin.distanceToSquared(hg)>(e.far-e.near)**2))&&(cg.copy(r).invert(),ar.copy(e.ray).applyMatrix4(cg),!(n.boundingBox!==null&&ar.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,ar)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,_=f.length;g<_;g++){let m=f[g],d=o[m.materialIndex],M=Math.max(m.start,p.start),S=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let x=M,P=S;x<P;x+=3){let T=a.getX(x),C=a.getX(x+1),I=a.getX(x+2);s=Xl(this,d,e,n,c,u,h,T,C,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),_=Math.min(a.count,p.start+p.count);for(let m=g,d=_;m<d;m+=3){let M=a.getX(m),S=a.getX(m+1),x=a.getX(m+2);s=Xl(this,o,e,n,c,u,h,M,S,x),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,_=f.length;g<_;g++){let m=f[g],d=o[m.materialIndex],M=Math.max(m.start,p.start),S=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let x=M,P=S;x<P;x+=3){let T=x,C=x+1,I=x+2;s=Xl(this,d,e,n,c,u,h,T,C,I),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),_=Math.min(l.count,p.start+p.count);for(let m=g,d=_;m<d;m+=3){let M=m,S=m+1,x=m+2;s=Xl(this,o,e,n,c,u,h,M,S,x),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function ib(i,e,t,n,s,r,o,a){let l;if(e.side===zn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===gs,a),l===null)return null;Wl.copy(a),Wl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Wl);return c<t.near||c>t.far?null:{distance:c,point:Wl.clone(),object:i}}function Xl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,kl),i.getVertexPosition(l,Hl),i.getVertexPosition(c,Vl);let u=ib(i,e,t,n,kl,Hl,Vl,ug);if(u){let h=new N;qi.getBarycoord(ug,kl,Hl,Vl,h),s&&(u.uv=qi.getInterpolatedAttribute(s,a,l,c,h,new Fe)),r&&(u.uv1=qi.getInterpolatedAttribute(r,a,l,c,h,new Fe)),o&&(u.normal=qi.getInterpolatedAttribute(o,a,l,c,h,new N),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new N,materialIndex:0};qi.getNormal(kl,Hl,Vl,f.normal),u.face=f,u.barycoord=h}return u}var Ki=class i extends qt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new pt(c,3)),this.setAttribute("normal",new pt(u,3)),this.setAttribute("uv",new pt(h,2));function g(_,m,d,M,S,x,P,T,C,I,b){let E=x/C,w=P/I,O=x/2,z=P/2,V=T/2,W=C+1,q=I+1,U=0,B=0,K=new N;for(let ne=0;ne<q;ne++){let ee=ne*w-z;for(let le=0;le<W;le++){let ce=le*E-O;K[_]=ce*M,K[m]=ee*S,K[d]=V,c.push(K.x,K.y,K.z),K[_]=0,K[m]=0,K[d]=T>0?1:-1,u.push(K.x,K.y,K.z),h.push(le/C),h.push(1-ne/I),U+=1}}for(let ne=0;ne<I;ne++)for(let ee=0;ee<C;ee++){let le=f+ee+W*ne,ce=f+ee+W*(ne+1),ye=f+(ee+1)+W*(ne+1),Re=f+(ee+1)+W*ne;l.push(le,ce,Re),l.push(ce,ye,Re),B+=6}a.addGroup(p,B,b),p+=B,f+=U}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function br(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Rn(i){let e={};for(let t=0;t<i.length;t++){let n=br(i[t]);for(let s in n)e[s]=n[s]}return e}function sb(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Qf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var Ka={clone:br,merge:Rn},rb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,ob=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ri=class extends Zi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=rb,this.fragmentShader=ob,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=br(e.uniforms),this.uniformsGroups=sb(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},Ma=class extends on{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Dt,this.projectionMatrix=new Dt,this.projectionMatrixInverse=new Dt,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Us=new N,fg=new Fe,dg=new Fe,An=class extends Ma{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=_o*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(po*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return _o*2*Math.atan(Math.tan(po*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Us.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Us.x,Us.y).multiplyScalar(-e/Us.z),Us.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Us.x,Us.y).multiplyScalar(-e/Us.z)}getViewSize(e,t){return this.getViewBounds(e,fg,dg),t.subVectors(dg,fg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(po*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},ro=-90,oo=1,mc=class extends on{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new An(ro,oo,e,t);s.layers=this.layers,this.add(s);let r=new An(ro,oo,e,t);r.layers=this.layers,this.add(r);let o=new An(ro,oo,e,t);o.layers=this.layers,this.add(o);let a=new An(ro,oo,e,t);a.layers=this.layers,this.add(a);let l=new An(ro,oo,e,t);l.layers=this.layers,this.add(l);let c=new An(ro,oo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ii)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ga)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=_,e.setRenderTarget(n,5,s),e.render(t,u),e.setRenderTarget(h,f,p),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Sa=class extends qn{constructor(e=[],t=xr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},gc=class extends $i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Sa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ki(5,5,5),r=new ri({name:"CubemapFromEquirect",uniforms:br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:zn,blending:vs});r.uniforms.tEquirect.value=t;let o=new ut(s,r),a=t.minFilter;return t.minFilter===Vs&&(t.minFilter=Li),new mc(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Jt=class extends on{constructor(){super(),this.isGroup=!0,this.type="Group"}},ab={type:"move"},yo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Jt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Jt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new N,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new N),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Jt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new N,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new N),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let m=t.getJointPose(_,n),d=this._getHandJoint(c,_);m!==null&&(d.matrix.fromArray(m.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=m.radius),d.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,g=.005;c.inputState.pinching&&f>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ab)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Jt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var bo=class extends on{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ui,this.environmentIntensity=1,this.environmentRotation=new Ui,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}},Mo=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=uc,this.updateRanges=[],this.version=0,this.uuid=ps()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);let t=new this.array.constructor(e.arrayBuffers[this.array.buffer._uuid]),n=new this.constructor(t,this.stride);return n.setUsage(this.usage),n}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){return e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}},On=new N,Yn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)On.fromBufferAttribute(this,t),On.applyMatrix4(e),this.setXYZ(t,On.x,On.y,On.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)On.fromBufferAttribute(this,t),On.applyNormalMatrix(e),this.setXYZ(t,On.x,On.y,On.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)On.fromBufferAttribute(this,t),On.transformDirection(e),this.setXYZ(t,On.x,On.y,On.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Rt(n,this.array)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=Rt(t,this.array)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=Rt(t,this.array)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=Rt(t,this.array)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=Rt(t,this.array)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=Pi(t,this.array)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=Pi(t,this.array)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=Pi(t,this.array)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=Pi(t,this.array)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=Rt(t,this.array),n=Rt(n,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=Rt(t,this.array),n=Rt(n,this.array),s=Rt(s,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=Rt(t,this.array),n=Rt(n,this.array),s=Rt(s,this.array),r=Rt(r,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new tn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){console.log("THREE.InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}},So=class extends Zi{constructor(e){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ct(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.rotation=e.rotation,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},ao,aa=new N,lo=new N,co=new N,ho=new Fe,la=new Fe,g0=new Dt,ql=new N,ca=new N,Yl=new N,pg=new Fe,gf=new Fe,mg=new Fe,wa=class extends on{constructor(e=new So){if(super(),this.isSprite=!0,this.type="Sprite",ao===void 0){ao=new qt;let t=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new Mo(t,5);ao.setIndex([0,1,2,0,2,3]),ao.setAttribute("position",new Yn(n,3,0,!1)),ao.setAttribute("uv",new Yn(n,2,3,!1))}this.geometry=ao,this.material=e,this.center=new Fe(.5,.5),this.count=1}raycast(e,t){e.camera===null&&console.error('THREE.Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),lo.setFromMatrixScale(this.matrixWorld),g0.copy(e.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(e.camera.matrixWorldInverse,this.matrixWorld),co.setFromMatrixPosition(this.modelViewMatrix),e.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&lo.multiplyScalar(-co.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;$l(ql.set(-.5,-.5,0),co,o,lo,s,r),$l(ca.set(.5,-.5,0),co,o,lo,s,r),$l(Yl.set(.5,.5,0),co,o,lo,s,r),pg.set(0,0),gf.set(1,0),mg.set(1,1);let a=e.ray.intersectTriangle(ql,ca,Yl,!1,aa);if(a===null&&($l(ca.set(-.5,.5,0),co,o,lo,s,r),gf.set(0,1),a=e.ray.intersectTriangle(ql,Yl,ca,!1,aa),a===null))return;let l=e.ray.origin.distanceTo(aa);l<e.near||l>e.far||t.push({distance:l,point:aa.clone(),uv:qi.getInterpolation(aa,ql,ca,Yl,pg,gf,mg,new Fe),face:null,object:this})}copy(e,t){return super.copy(e,t),e.center!==void 0&&this.center.copy(e.center),this.material=e.material,this}};function $l(i,e,t,n,s,r){ho.subVectors(i,t).addScalar(.5).multiply(n),s!==void 0?(la.x=r*ho.x-s*ho.y,la.y=s*ho.x+r*ho.y):la.copy(ho),i.copy(e),i.x+=la.x,i.y+=la.y,i.applyMatrix4(g0)}var _f=new N,lb=new N,cb=new lt,Wn=class{constructor(e=new N(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=_f.subVectors(n,t).cross(lb.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(_f),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||cb.getNormalMatrix(e),s=this.coplanarPoint(_f).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},lr=new Di,hb=new Fe(.5,.5),Zl=new N,wo=class{constructor(e=new Wn,t=new Wn,n=new Wn,s=new Wn,r=new Wn,o=new Wn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ii,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],p=r[7],g=r[8],_=r[9],m=r[10],d=r[11],M=r[12],S=r[13],x=r[14],P=r[15];if(s[0].setComponents(c-o,p-u,d-g,P-M).normalize(),s[1].setComponents(c+o,p+u,d+g,P+M).normalize(),s[2].setComponents(c+a,p+h,d+_,P+S).normalize(),s[3].setComponents(c-a,p-h,d-_,P-S).normalize(),n)s[4].setComponents(l,f,m,x).normalize(),s[5].setComponents(c-l,p-f,d-m,P-x).normalize();else if(s[4].setComponents(c-l,p-f,d-m,P-x).normalize(),t===Ii)s[5].setComponents(c+l,p+f,d+m,P+x).normalize();else if(t===ga)s[5].setComponents(l,f,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),lr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),lr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(lr)}intersectsSprite(e){lr.center.set(0,0,0);let t=hb.distanceTo(e.center);return lr.radius=.7071067811865476+t,lr.applyMatrix4(e.matrixWorld),this.intersectsSphere(lr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Zl.x=s.normal.x>0?e.max.x:e.min.x,Zl.y=s.normal.y>0?e.max.y:e.min.y,Zl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Zl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var _s=class extends Zi{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ct(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},_c=new N,vc=new N,gg=new Dt,ha=new dr,Kl=new Di,vf=new N,_g=new N,pr=class extends on{constructor(e=new qt,t=new _s){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)_c.fromBufferAttribute(t,s-1),vc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=_c.distanceTo(vc);e.setAttribute("lineDistance",new pt(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Kl.copy(n.boundingSphere),Kl.applyMatrix4(s),Kl.radius+=r,e.ray.intersectsSphere(Kl)===!1)return;gg.copy(s).invert(),ha.copy(e.ray).applyMatrix4(gg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let p=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let _=p,m=g-1;_<m;_+=c){let d=u.getX(_),M=u.getX(_+1),S=Jl(this,e,ha,l,d,M,_);S&&t.push(S)}if(this.isLineLoop){let _=u.getX(g-1),m=u.getX(p),d=Jl(this,e,ha,l,_,m,g-1);d&&t.push(d)}}else{let p=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let _=p,m=g-1;_<m;_+=c){let d=Jl(this,e,ha,l,_,_+1,_);d&&t.push(d)}if(this.isLineLoop){let _=Jl(this,e,ha,l,g-1,p,g-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Jl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(_c.fromBufferAttribute(a,s),vc.fromBufferAttribute(a,r),t.distanceSqToSegment(_c,vc,vf,_g)>n)return;vf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(vf);if(!(c<e.near||c>e.far))return{distance:c,point:_g.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var vg=new N,xg=new N,Eo=class extends pr{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)vg.fromBufferAttribute(t,s),xg.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+vg.distanceTo(xg);e.setAttribute("lineDistance",new pt(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ea=class extends qn{constructor(e,t,n,s,r,o,a,l,c){super(e,t,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},Ta=class extends qn{constructor(e,t,n=Gs,s,r,o,a=mi,l=mi,c,u=go,h=1){if(u!==go&&u!==Po)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new xo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},Aa=class extends qn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var mr=class i extends qt{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new N,u=new Fe;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=t;h++,f+=3){let p=n+h/t*s;c.x=e*Math.cos(p),c.y=e*Math.sin(p),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/e+1)/2,u.y=(o[f+1]/e+1)/2,l.push(u.x,u.y)}for(let h=1;h<=t;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new pt(o,3)),this.setAttribute("normal",new pt(a,3)),this.setAttribute("uv",new pt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},oi=class i extends qt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],p=[],g=0,_=[],m=n/2,d=0;M(),o===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(u),this.setAttribute("position",new pt(h,3)),this.setAttribute("normal",new pt(f,3)),this.setAttribute("uv",new pt(p,2));function M(){let x=new N,P=new N,T=0,C=(t-e)/n;for(let I=0;I<=r;I++){let b=[],E=I/r,w=E*(t-e)+e;for(let O=0;O<=s;O++){let z=O/s,V=z*l+a,W=Math.sin(V),q=Math.cos(V);P.x=w*W,P.y=-E*n+m,P.z=w*q,h.push(P.x,P.y,P.z),x.set(W,C,q).normalize(),f.push(x.x,x.y,x.z),p.push(z,1-E),b.push(g++)}_.push(b)}for(let I=0;I<s;I++)for(let b=0;b<r;b++){let E=_[b][I],w=_[b+1][I],O=_[b+1][I+1],z=_[b][I+1];(e>0||b!==0)&&(u.push(E,w,z),T+=3),(t>0||b!==r-1)&&(u.push(w,O,z),T+=3)}c.addGroup(d,T,0),d+=T}function S(x){let P=g,T=new Fe,C=new N,I=0,b=x===!0?e:t,E=x===!0?1:-1;for(let O=1;O<=s;O++)h.push(0,m*E,0),f.push(0,E,0),p.push(.5,.5),g++;let w=g;for(let O=0;O<=s;O++){let V=O/s*l+a,W=Math.cos(V),q=Math.sin(V);C.x=b*q,C.y=m*E,C.z=b*W,h.push(C.x,C.y,C.z),f.push(0,E,0),T.x=W*.5+.5,T.y=q*.5*E+.5,p.push(T.x,T.y),g++}for(let O=0;O<s;O++){let z=P+O,V=w+O;x===!0?u.push(V,V+1,z):u.push(V+1,V,z),I+=3}c.addGroup(d,I,x===!0?1:2),d+=I}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},gr=class i extends oi{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var jl=new N,Ql=new N,xf=new N,ec=new qi,Ra=class extends qt{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(po*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},p=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:_,b:m,c:d}=ec;if(_.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),ec.getNormal(xf),h[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let M=0;M<3;M++){let S=(M+1)%3,x=h[M],P=h[S],T=ec[u[M]],C=ec[u[S]],I=`${x}_${P}`,b=`${P}_${x}`;b in f&&f[b]?(xf.dot(f[b].normal)<=r&&(p.push(T.x,T.y,T.z),p.push(C.x,C.y,C.z)),f[b]=null):I in f||(f[I]={index0:c[M],index1:c[S],normal:xf.clone()})}}for(let g in f)if(f[g]){let{index0:_,index1:m}=f[g];jl.fromBufferAttribute(a,_),Ql.fromBufferAttribute(a,m),p.push(jl.x,jl.y,jl.z),p.push(Ql.x,Ql.y,Ql.z)}this.setAttribute("position",new pt(p,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}},$n=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let u=n[s],f=n[s+1]-u,p=(o-u)/f;return(s+p)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new Fe:new N);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new N,s=[],r=[],o=[],a=new N,l=new Dt;for(let p=0;p<=e;p++){let g=p/e;s[p]=this.getTangentAt(g,new N)}r[0]=new N,o[0]=new N;let c=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let p=1;p<=e;p++){if(r[p]=r[p-1].clone(),o[p]=o[p-1].clone(),a.crossVectors(s[p-1],s[p]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(st(s[p-1].dot(s[p]),-1,1));r[p].applyMatrix4(l.makeRotationAxis(a,g))}o[p].crossVectors(s[p],r[p])}if(t===!0){let p=Math.acos(st(r[0].dot(r[e]),-1,1));p/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(p=-p);for(let g=1;g<=e;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],p*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}},Ca=class extends $n{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new Fe){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,p=c-this.aY;l=f*u-p*h+this.aX,c=f*h+p*u+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},xc=class extends Ca{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function ed(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,p=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,p*=u,s(o,a,f,p)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var tc=new N,yf=new ed,bf=new ed,Mf=new ed,yc=class extends $n{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new N){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:(tc.subVectors(s[0],s[1]).add(s[0]),c=tc);let h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(tc.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=tc),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(h),p),_=Math.pow(h.distanceToSquared(f),p),m=Math.pow(f.distanceToSquared(u),p);_<1e-4&&(_=1),g<1e-4&&(g=_),m<1e-4&&(m=_),yf.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,g,_,m),bf.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,g,_,m),Mf.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,g,_,m)}else this.curveType==="catmullrom"&&(yf.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),bf.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),Mf.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(yf.calc(l),bf.calc(l),Mf.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new N().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function yg(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function ub(i,e){let t=1-i;return t*t*e}function fb(i,e){return 2*(1-i)*i*e}function db(i,e){return i*i*e}function fa(i,e,t,n){return ub(i,e)+fb(i,t)+db(i,n)}function pb(i,e){let t=1-i;return t*t*t*e}function mb(i,e){let t=1-i;return 3*t*t*i*e}function gb(i,e){return 3*(1-i)*i*i*e}function _b(i,e){return i*i*i*e}function da(i,e,t,n,s){return pb(i,e)+mb(i,t)+gb(i,n)+_b(i,s)}var bc=class extends $n{constructor(e=new Fe,t=new Fe,n=new Fe,s=new Fe){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Fe){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(da(e,s.x,r.x,o.x,a.x),da(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Mc=class extends $n{constructor(e=new N,t=new N,n=new N,s=new N){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new N){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(da(e,s.x,r.x,o.x,a.x),da(e,s.y,r.y,o.y,a.y),da(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Sc=class extends $n{constructor(e=new Fe,t=new Fe){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Fe){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Fe){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},wc=class extends $n{constructor(e=new N,t=new N){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new N){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new N){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Ec=class extends $n{constructor(e=new Fe,t=new Fe,n=new Fe){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Fe){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(fa(e,s.x,r.x,o.x),fa(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Pa=class extends $n{constructor(e=new N,t=new N,n=new N){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new N){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(fa(e,s.x,r.x,o.x),fa(e,s.y,r.y,o.y),fa(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Tc=class extends $n{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Fe){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(yg(a,l.x,c.x,u.x,h.x),yg(a,l.y,c.y,u.y,h.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Fe().fromArray(s))}return this}},vb=Object.freeze({__proto__:null,ArcCurve:xc,CatmullRomCurve3:yc,CubicBezierCurve:bc,CubicBezierCurve3:Mc,EllipseCurve:Ca,LineCurve:Sc,LineCurve3:wc,QuadraticBezierCurve:Ec,QuadraticBezierCurve3:Pa,SplineCurve:Tc});var Ia=class i extends qt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,p=[],g=[],_=[],m=[];for(let d=0;d<u;d++){let M=d*f-o;for(let S=0;S<c;S++){let x=S*h-r;g.push(x,-M,0),_.push(0,0,1),m.push(S/a),m.push(1-d/l)}}for(let d=0;d<l;d++)for(let M=0;M<a;M++){let S=M+c*d,x=M+c*(d+1),P=M+1+c*(d+1),T=M+1+c*d;p.push(S,x,T),p.push(x,P,T)}this.setIndex(p),this.setAttribute("position",new pt(g,3)),this.setAttribute("normal",new pt(_,3)),this.setAttribute("uv",new pt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var La=class i extends qt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new N,f=new N,p=[],g=[],_=[],m=[];for(let d=0;d<=n;d++){let M=[],S=d/n,x=0;d===0&&o===0?x=.5/t:d===n&&l===Math.PI&&(x=-.5/t);for(let P=0;P<=t;P++){let T=P/t;h.x=-e*Math.cos(s+T*r)*Math.sin(o+S*a),h.y=e*Math.cos(o+S*a),h.z=e*Math.sin(s+T*r)*Math.sin(o+S*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),_.push(f.x,f.y,f.z),m.push(T+x,1-S),M.push(c++)}u.push(M)}for(let d=0;d<n;d++)for(let M=0;M<t;M++){let S=u[d][M+1],x=u[d][M],P=u[d+1][M],T=u[d+1][M+1];(d!==0||o>0)&&p.push(S,x,T),(d!==n-1||l<Math.PI)&&p.push(x,P,T)}this.setIndex(p),this.setAttribute("position",new pt(g,3)),this.setAttribute("normal",new pt(_,3)),this.setAttribute("uv",new pt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Da=class i extends qt{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],l=[],c=[],u=new N,h=new N,f=new N;for(let p=0;p<=n;p++)for(let g=0;g<=s;g++){let _=g/s*r,m=p/n*Math.PI*2;h.x=(e+t*Math.cos(m))*Math.cos(_),h.y=(e+t*Math.cos(m))*Math.sin(_),h.z=t*Math.sin(m),a.push(h.x,h.y,h.z),u.x=e*Math.cos(_),u.y=e*Math.sin(_),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(p/n)}for(let p=1;p<=n;p++)for(let g=1;g<=s;g++){let _=(s+1)*p+g-1,m=(s+1)*(p-1)+g-1,d=(s+1)*(p-1)+g,M=(s+1)*p+g;o.push(_,m,M),o.push(m,d,M)}this.setIndex(o),this.setAttribute("position",new pt(a,3)),this.setAttribute("normal",new pt(l,3)),this.setAttribute("uv",new pt(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc)}};var Ua=class i extends qt{constructor(e=new Pa(new N(-1,-1,0),new N(-1,1,0),new N(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let o=e.computeFrenetFrames(t,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new N,l=new N,c=new Fe,u=new N,h=[],f=[],p=[],g=[];_(),this.setIndex(g),this.setAttribute("position",new pt(h,3)),this.setAttribute("normal",new pt(f,3)),this.setAttribute("uv",new pt(p,2));function _(){for(let S=0;S<t;S++)m(S);m(r===!1?t:0),M(),d()}function m(S){u=e.getPointAt(S/t,u);let x=o.normals[S],P=o.binormals[S];for(let T=0;T<=s;T++){let C=T/s*Math.PI*2,I=Math.sin(C),b=-Math.cos(C);l.x=b*x.x+I*P.x,l.y=b*x.y+I*P.y,l.z=b*x.z+I*P.z,l.normalize(),f.push(l.x,l.y,l.z),a.x=u.x+n*l.x,a.y=u.y+n*l.y,a.z=u.z+n*l.z,h.push(a.x,a.y,a.z)}}function d(){for(let S=1;S<=t;S++)for(let x=1;x<=s;x++){let P=(s+1)*(S-1)+(x-1),T=(s+1)*S+(x-1),C=(s+1)*S+x,I=(s+1)*(S-1)+x;g.push(P,T,I),g.push(T,C,I)}}function M(){for(let S=0;S<=t;S++)for(let x=0;x<=s;x++)c.x=S/t,c.y=x/s,p.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new vb[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}},Na=class extends qt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new N,r=new N;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,p=h.count;for(let g=f,_=f+p;g<_;g+=3)for(let m=0;m<3;m++){let d=a.getX(g+m),M=a.getX(g+(m+1)%3);s.fromBufferAttribute(o,d),r.fromBufferAttribute(o,M),bg(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),bg(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new pt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function bg(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}var Ji=class extends Zi{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ct(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ct(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=$f,this.normalScale=new Fe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Ac=class extends Zi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=i0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Rc=class extends Zi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function nc(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function xb(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var _r=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},Cc=class extends _r{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Tf,endingEnd:Tf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Af:r=e,a=2*t-n;break;case Rf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Af:o=e,l=2*n-t;break;case Rf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,p=this._weightNext,g=(n-t)/(s-t),_=g*g,m=_*g,d=-f*m+2*f*_-f*g,M=(1+f)*m+(-1.5-2*f)*_+(-.5+f)*g+1,S=(-1-p)*m+(1.5+p)*_+.5*g,x=p*m-p*_;for(let P=0;P!==a;++P)r[P]=d*o[u+P]+M*o[c+P]+S*o[l+P]+x*o[h+P];return r}},Pc=class extends _r{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Ic=class extends _r{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ai=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=nc(t,this.TimeBufferType),this.values=nc(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:nc(e.times,Array),values:nc(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ic(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Pc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Cc(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case pa:t=this.InterpolantFactoryMethodDiscrete;break;case hc:t=this.InterpolantFactoryMethodLinear;break;case rc:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return pa;case this.InterpolantFactoryMethodLinear:return hc;case this.InterpolantFactoryMethodSmooth:return rc}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&xb(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===rc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,f=h-n,p=h+n;for(let g=0;g!==n;++g){let _=t[h+g];if(_!==t[f+g]||_!==t[p+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,f=o*n;for(let p=0;p!==n;++p)t[f+p]=t[h+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};ai.prototype.ValueTypeName="";ai.prototype.TimeBufferType=Float32Array;ai.prototype.ValueBufferType=Float32Array;ai.prototype.DefaultInterpolation=hc;var Os=class extends ai{constructor(e,t,n){super(e,t,n)}};Os.prototype.ValueTypeName="bool";Os.prototype.ValueBufferType=Array;Os.prototype.DefaultInterpolation=pa;Os.prototype.InterpolantFactoryMethodLinear=void 0;Os.prototype.InterpolantFactoryMethodSmooth=void 0;var Lc=class extends ai{constructor(e,t,n,s){super(e,t,n,s)}};Lc.prototype.ValueTypeName="color";var Dc=class extends ai{constructor(e,t,n,s){super(e,t,n,s)}};Dc.prototype.ValueTypeName="number";var Uc=class extends _r{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Xn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Fa=class extends ai{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Uc(this.times,this.values,this.getValueSize(),e)}};Fa.prototype.ValueTypeName="quaternion";Fa.prototype.InterpolantFactoryMethodSmooth=void 0;var Bs=class extends ai{constructor(e,t,n){super(e,t,n)}};Bs.prototype.ValueTypeName="string";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=pa;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var Nc=class extends ai{constructor(e,t,n,s){super(e,t,n,s)}};Nc.prototype.ValueTypeName="vector";var Fc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let p=c[h],g=c[h+1];if(p.global&&(p.lastIndex=0),p.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},_0=new Fc,Oc=class{constructor(e){this.manager=e!==void 0?e:_0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};Oc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Oa=class extends on{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ct(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}},Ba=class extends Oa{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(on.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ct(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}},Sf=new Dt,Mg=new N,Sg=new N,Pf=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Fe(512,512),this.mapType=Fi,this.map=null,this.mapPass=null,this.matrix=new Dt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new wo,this._frameExtents=new Fe(1,1),this._viewportCount=1,this._viewports=[new Pt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera,n=this.matrix;Mg.setFromMatrixPosition(e.matrixWorld),t.position.copy(Mg),Sg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Sg),t.updateMatrixWorld(),Sf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Sf,t.coordinateSystem,t.reversedDepth),t.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Sf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var vr=class extends Ma{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},If=class extends Pf{constructor(){super(new vr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},za=class extends Oa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(on.DEFAULT_UP),this.updateMatrix(),this.target=new on,this.shadow=new If}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}};var ka=class extends qt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Bc=class extends An{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var td="\\[\\]\\.:\\/",yb=new RegExp("["+td+"]","g"),nd="[^"+td+"]",bb="[^"+td.replace("\\.","")+"]",Mb=/((?:WC+[\/:])*)/.source.replace("WC",nd),Sb=/(WCOD+)?/.source.replace("WCOD",bb),wb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",nd),Eb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",nd),Tb=new RegExp("^"+Mb+Sb+wb+Eb+"$"),Ab=["material","materials","bones","map"],Lf=class{constructor(e,t,n){let s=n||Xt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Xt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(yb,"")}static parseTrackName(e){let t=Tb.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Ab.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xt.Composite=Lf;Xt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xt.prototype.GetterByBindingType=[Xt.prototype._getValue_direct,Xt.prototype._getValue_array,Xt.prototype._getValue_arrayElement,Xt.prototype._getValue_toArray];Xt.prototype.SetterByBindingTypeAndVersioning=[[Xt.prototype._setValue_direct,Xt.prototype._setValue_direct_setNeedsUpdate,Xt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_array,Xt.prototype._setValue_array_setNeedsUpdate,Xt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_arrayElement,Xt.prototype._setValue_arrayElement_setNeedsUpdate,Xt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_fromArray,Xt.prototype._setValue_fromArray_setNeedsUpdate,Xt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var GT=new Float32Array(1);var zs=class extends Mo{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var To=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=st(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(st(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var wg=new N,ic=new N,uo=new N,fo=new N,wf=new N,Rb=new N,Cb=new N,Ha=class{constructor(e=new N,t=new N){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){wg.subVectors(e,this.start),ic.subVectors(this.end,this.start);let n=ic.dot(ic),r=ic.dot(wg)/n;return t&&(r=st(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=Rb,n=Cb){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;uo.subVectors(c,a),fo.subVectors(u,l),wf.subVectors(a,l);let h=uo.dot(uo),f=fo.dot(fo),p=fo.dot(wf);if(h<=s&&f<=s)return t.copy(a),n.copy(l),t.sub(n),t.dot(t);if(h<=s)r=0,o=p/f,o=st(o,0,1);else{let g=uo.dot(wf);if(f<=s)o=0,r=st(-g/h,0,1);else{let _=uo.dot(fo),m=h*f-_*_;m!==0?r=st((_*p-g*f)/m,0,1):r=0,o=(_*r+p)/f,o<0?(o=0,r=st(-g/h,0,1)):o>1&&(o=1,r=st((_-g)/h,0,1))}}return t.copy(a).add(uo.multiplyScalar(r)),n.copy(l).add(fo.multiplyScalar(o)),t.sub(n),t.dot(t)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var Eg=new N,sc,Ef,Va=class extends on{constructor(e=new N(0,0,1),t=new N(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",sc===void 0&&(sc=new qt,sc.setAttribute("position",new pt([0,0,0,0,1,0],3)),Ef=new gr(.5,1,5,1),Ef.translate(0,-.5,0)),this.position.copy(t),this.line=new pr(sc,new _s({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new ut(Ef,new Ni({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(e),this.setLength(n,r,o)}setDirection(e){if(e.y>.99999)this.quaternion.set(0,0,0,1);else if(e.y<-.99999)this.quaternion.set(1,0,0,0);else{Eg.set(e.z,0,-e.x).normalize();let t=Math.acos(e.y);this.quaternion.setFromAxisAngle(Eg,t)}}setLength(e,t=e*.2,n=t*.2){this.line.scale.set(1,Math.max(1e-4,e-t),1),this.line.updateMatrix(),this.cone.scale.set(n,t,n),this.cone.position.y=e,this.cone.updateMatrix()}setColor(e){this.line.material.color.set(e),this.cone.material.color.set(e)}copy(e){return super.copy(e,!1),this.line.copy(e.line),this.cone.copy(e.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var Ga=class extends Yi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function id(i,e,t,n){let s=Pb(n);switch(t){case Wf:return i*e;case qf:return i*e/s.components*s.byteLength;case jc:return i*e/s.components*s.byteLength;case Yf:return i*e*2/s.components*s.byteLength;case Qc:return i*e*2/s.components*s.byteLength;case Xf:return i*e*3/s.components*s.byteLength;case gi:return i*e*4/s.components*s.byteLength;case eh:return i*e*4/s.components*s.byteLength;case qa:case Ya:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case $a:case Za:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case nh:case sh:return Math.max(i,16)*Math.max(e,8)/4;case th:case ih:return Math.max(i,8)*Math.max(e,8)/2;case rh:case oh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ah:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case lh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ch:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case hh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case uh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case fh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case dh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case ph:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case mh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case gh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case _h:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case vh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case xh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case yh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case bh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Mh:case Sh:case wh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Eh:case Th:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ah:case Rh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Pb(i){switch(i){case Fi:case kf:return{byteLength:1,components:1};case Ao:case Hf:case Ro:return{byteLength:2,components:1};case Kc:case Jc:return{byteLength:2,components:4};case Gs:case Zc:case Qi:return{byteLength:4,components:1};case Vf:case Gf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function H0(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Fb(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((p,g)=>p.start-g.start);let f=0;for(let p=1;p<h.length;p++){let g=h[f],_=h[p];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++f,h[f]=_)}h.length=f+1;for(let p=0,g=h.length;p<g;p++){let _=h[p];i.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Ob=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Bb=`#ifdef USE_ALPHAHASH
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
#endif`,zb=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,kb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Hb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Vb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Gb=`#ifdef USE_AOMAP
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
#endif`,Wb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Xb=`#ifdef USE_BATCHING
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
#endif`,qb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Yb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,$b=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Zb=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Kb=`#ifdef USE_IRIDESCENCE
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
#endif`,Jb=`#ifdef USE_BUMPMAP
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
#endif`,jb=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Qb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,eM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,tM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,nM=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,iM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,sM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,rM=`#if defined( USE_COLOR_ALPHA )
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
#endif`,oM=`#define PI 3.141592653589793
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
} // validated`,aM=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,lM=`vec3 transformedNormal = objectNormal;
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
#endif`,cM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,hM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,uM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,fM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,dM="gl_FragColor = linearToOutputTexel( gl_FragColor );",pM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,mM=`#ifdef USE_ENVMAP
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
#endif`,gM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,_M=`#ifdef USE_ENVMAP
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
#endif`,vM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,xM=`#ifdef USE_ENVMAP
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
#endif`,yM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,bM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,MM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,SM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,wM=`#ifdef USE_GRADIENTMAP
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
}`,EM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,TM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,AM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,RM=`uniform bool receiveShadow;
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
#endif`,CM=`#ifdef USE_ENVMAP
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
#endif`,PM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,IM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,LM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,DM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,UM=`PhysicalMaterial material;
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
#endif`,NM=`struct PhysicalMaterial {
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
}`,FM=`
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
#endif`,OM=`#if defined( RE_IndirectDiffuse )
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
#endif`,BM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,zM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,kM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,HM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,VM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,GM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,WM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,XM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,qM=`#if defined( USE_POINTS_UV )
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
#endif`,YM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,$M=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ZM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,KM=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,JM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jM=`#ifdef USE_MORPHTARGETS
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
#endif`,QM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,eS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,tS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,nS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,iS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,sS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,rS=`#ifdef USE_NORMALMAP
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
#endif`,oS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,aS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,lS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,cS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,hS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,uS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,fS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,dS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,pS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,mS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,gS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,_S=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,vS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,xS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,yS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,bS=`float getShadowMask() {
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
}`,MS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,SS=`#ifdef USE_SKINNING
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
#endif`,wS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ES=`#ifdef USE_SKINNING
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
#endif`,TS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,AS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,RS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,CS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,PS=`#ifdef USE_TRANSMISSION
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
#endif`,IS=`#ifdef USE_TRANSMISSION
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
#endif`,LS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,DS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,US=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,NS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,FS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,OS=`uniform sampler2D t2D;
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
}`,BS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,zS=`#ifdef ENVMAP_TYPE_CUBE
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
}`,kS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,HS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VS=`#include <common>
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
}`,GS=`#if DEPTH_PACKING == 3200
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
}`,WS=`#define DISTANCE
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
}`,XS=`#define DISTANCE
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
}`,qS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,YS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$S=`uniform float scale;
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
}`,ZS=`uniform vec3 diffuse;
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
}`,KS=`#include <common>
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
}`,JS=`uniform vec3 diffuse;
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
}`,jS=`#define LAMBERT
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
}`,QS=`#define LAMBERT
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
}`,ew=`#define MATCAP
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
}`,tw=`#define MATCAP
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
}`,nw=`#define NORMAL
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
}`,iw=`#define NORMAL
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
}`,sw=`#define PHONG
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
}`,rw=`#define PHONG
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
}`,ow=`#define STANDARD
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
}`,aw=`#define STANDARD
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
}`,lw=`#define TOON
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
}`,cw=`#define TOON
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
}`,hw=`uniform float size;
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
}`,uw=`uniform vec3 diffuse;
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
}`,fw=`#include <common>
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
}`,dw=`uniform vec3 color;
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
}`,pw=`uniform float rotation;
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
}`,mw=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:Ob,alphahash_pars_fragment:Bb,alphamap_fragment:zb,alphamap_pars_fragment:kb,alphatest_fragment:Hb,alphatest_pars_fragment:Vb,aomap_fragment:Gb,aomap_pars_fragment:Wb,batching_pars_vertex:Xb,batching_vertex:qb,begin_vertex:Yb,beginnormal_vertex:$b,bsdfs:Zb,iridescence_fragment:Kb,bumpmap_pars_fragment:Jb,clipping_planes_fragment:jb,clipping_planes_pars_fragment:Qb,clipping_planes_pars_vertex:eM,clipping_planes_vertex:tM,color_fragment:nM,color_pars_fragment:iM,color_pars_vertex:sM,color_vertex:rM,common:oM,cube_uv_reflection_fragment:aM,defaultnormal_vertex:lM,displacementmap_pars_vertex:cM,displacementmap_vertex:hM,emissivemap_fragment:uM,emissivemap_pars_fragment:fM,colorspace_fragment:dM,colorspace_pars_fragment:pM,envmap_fragment:mM,envmap_common_pars_fragment:gM,envmap_pars_fragment:_M,envmap_pars_vertex:vM,envmap_physical_pars_fragment:CM,envmap_vertex:xM,fog_vertex:yM,fog_pars_vertex:bM,fog_fragment:MM,fog_pars_fragment:SM,gradientmap_pars_fragment:wM,lightmap_pars_fragment:EM,lights_lambert_fragment:TM,lights_lambert_pars_fragment:AM,lights_pars_begin:RM,lights_toon_fragment:PM,lights_toon_pars_fragment:IM,lights_phong_fragment:LM,lights_phong_pars_fragment:DM,lights_physical_fragment:UM,lights_physical_pars_fragment:NM,lights_fragment_begin:FM,lights_fragment_maps:OM,lights_fragment_end:BM,logdepthbuf_fragment:zM,logdepthbuf_pars_fragment:kM,logdepthbuf_pars_vertex:HM,logdepthbuf_vertex:VM,map_fragment:GM,map_pars_fragment:WM,map_particle_fragment:XM,map_particle_pars_fragment:qM,metalnessmap_fragment:YM,metalnessmap_pars_fragment:$M,morphinstance_vertex:ZM,morphcolor_vertex:KM,morphnormal_vertex:JM,morphtarget_pars_vertex:jM,morphtarget_vertex:QM,normal_fragment_begin:eS,normal_fragment_maps:tS,normal_pars_fragment:nS,normal_pars_vertex:iS,normal_vertex:sS,normalmap_pars_fragment:rS,clearcoat_normal_fragment_begin:oS,clearcoat_normal_fragment_maps:aS,clearcoat_pars_fragment:lS,iridescence_pars_fragment:cS,opaque_fragment:hS,packing:uS,premultiplied_alpha_fragment:fS,project_vertex:dS,dithering_fragment:pS,dithering_pars_fragment:mS,roughnessmap_fragment:gS,roughnessmap_pars_fragment:_S,shadowmap_pars_fragment:vS,shadowmap_pars_vertex:xS,shadowmap_vertex:yS,shadowmask_pars_fragment:bS,skinbase_vertex:MS,skinning_pars_vertex:SS,skinning_vertex:wS,skinnormal_vertex:ES,specularmap_fragment:TS,specularmap_pars_fragment:AS,tonemapping_fragment:RS,tonemapping_pars_fragment:CS,transmission_fragment:PS,transmission_pars_fragment:IS,uv_pars_fragment:LS,uv_pars_vertex:DS,uv_vertex:US,worldpos_vertex:NS,background_vert:FS,background_frag:OS,backgroundCube_vert:BS,backgroundCube_frag:zS,cube_vert:kS,cube_frag:HS,depth_vert:VS,depth_frag:GS,distanceRGBA_vert:WS,distanceRGBA_frag:XS,equirect_vert:qS,equirect_frag:YS,linedashed_vert:$S,linedashed_frag:ZS,meshbasic_vert:KS,meshbasic_frag:JS,meshlambert_vert:jS,meshlambert_frag:QS,meshmatcap_vert:ew,meshmatcap_frag:tw,meshnormal_vert:nw,meshnormal_frag:iw,meshphong_vert:sw,meshphong_frag:rw,meshphysical_vert:ow,meshphysical_frag:aw,meshtoon_vert:lw,meshtoon_frag:cw,points_vert:hw,points_frag:uw,shadow_vert:fw,shadow_frag:dw,sprite_vert:pw,sprite_frag:mw},Le={common:{diffuse:{value:new ct(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new lt}},envmap:{envMap:{value:null},envMapRotation:{value:new lt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new lt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new lt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new lt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new lt},normalScale:{value:new Fe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new lt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new lt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new lt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new lt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ct(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ct(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0},uvTransform:{value:new lt}},sprite:{diffuse:{value:new ct(16777215)},opacity:{value:1},center:{value:new Fe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}}},Hn={basic:{uniforms:Rn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Rn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new ct(0)}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Rn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new ct(0)},specular:{value:new ct(1118481)},shininess:{value:30}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Rn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new ct(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Rn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new ct(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Rn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Rn([Le.points,Le.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Rn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Rn([Le.common,Le.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Rn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Rn([Le.sprite,Le.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new lt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new lt}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distanceRGBA:{uniforms:Rn([Le.common,Le.displacementmap,{referencePosition:{value:new N},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distanceRGBA_vert,fragmentShader:ft.distanceRGBA_frag},shadow:{uniforms:Rn([Le.lights,Le.fog,{color:{value:new ct(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};Hn.physical={uniforms:Rn([Hn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new lt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new lt},clearcoatNormalScale:{value:new Fe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new lt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new lt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new lt},sheen:{value:0},sheenColor:{value:new ct(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new lt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new lt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new lt},transmissionSamplerSize:{value:new Fe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new lt},attenuationDistance:{value:0},attenuationColor:{value:new ct(0)},specularColor:{value:new ct(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new lt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new lt},anisotropyVector:{value:new Fe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new lt}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Ch={r:0,b:0,g:0},Mr=new Ui,gw=new Dt;function _w(i,e,t,n,s,r,o){let a=new ct(0),l=r===!0?0:1,c,u,h=null,f=0,p=null;function g(S){let x=S.isScene===!0?S.background:null;return x&&x.isTexture&&(x=(S.backgroundBlurriness>0?t:e).get(x)),x}function _(S){let x=!1,P=g(S);P===null?d(a,l):P&&P.isColor&&(d(P,1),x=!0);let T=i.xr.getEnvironmentBlendMode();T==="additive"?n.buffers.color.setClear(0,0,0,1,o):T==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||x)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(S,x){let P=g(x);P&&(P.isCubeTexture||P.mapping===Wa)?(u===void 0&&(u=new ut(new Ki(1,1,1),new ri({name:"BackgroundCubeMaterial",uniforms:br(Hn.backgroundCube.uniforms),vertexShader:Hn.backgroundCube.vertexShader,fragmentShader:Hn.backgroundCube.fragmentShader,side:zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(T,C,I){this.matrixWorld.copyPosition(I.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),Mr.copy(x.backgroundRotation),Mr.x*=-1,Mr.y*=-1,Mr.z*=-1,P.isCubeTexture&&P.isRenderTargetTexture===!1&&(Mr.y*=-1,Mr.z*=-1),u.material.uniforms.envMap.value=P,u.material.uniforms.flipEnvMap.value=P.isCubeTexture&&P.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=x.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(gw.makeRotationFromEuler(Mr)),u.material.toneMapped=vt.getTransfer(P.colorSpace)!==Ct,(h!==P||f!==P.version||p!==i.toneMapping)&&(u.material.needsUpdate=!0,h=P,f=P.version,p=i.toneMapping),u.layers.enableAll(),S.unshift(u,u.geometry,u.material,0,0,null)):P&&P.isTexture&&(c===void 0&&(c=new ut(new Ia(2,2),new ri({name:"BackgroundMaterial",uniforms:br(Hn.background.uniforms),vertexShader:Hn.background.vertexShader,fragmentShader:Hn.background.fragmentShader,side:gs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=P,c.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,c.material.toneMapped=vt.getTransfer(P.colorSpace)!==Ct,P.matrixAutoUpdate===!0&&P.updateMatrix(),c.material.uniforms.uvTransform.value.copy(P.matrix),(h!==P||f!==P.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,h=P,f=P.version,p=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function d(S,x){S.getRGB(Ch,Qf(i)),n.buffers.color.setClear(Ch.r,Ch.g,Ch.b,x,o)}function M(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,x=1){a.set(S),l=x,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(S){l=S,d(a,l)},render:_,addToRenderList:m,dispose:M}}function vw(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(E,w,O,z,V){let W=!1,q=h(z,O,w);r!==q&&(r=q,c(r.object)),W=p(E,z,O,V),W&&g(E,z,O,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,x(E,w,O,z),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(E){return i.bindVertexArray(E)}function u(E){return i.deleteVertexArray(E)}function h(E,w,O){let z=O.wireframe===!0,V=n[E.id];V===void 0&&(V={},n[E.id]=V);let W=V[w.id];W===void 0&&(W={},V[w.id]=W);let q=W[z];return q===void 0&&(q=f(l()),W[z]=q),q}function f(E){let w=[],O=[],z=[];for(let V=0;V<t;V++)w[V]=0,O[V]=0,z[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:w,enabledAttributes:O,attributeDivisors:z,object:E,attributes:{},index:null}}function p(E,w,O,z){let V=r.attributes,W=w.attributes,q=0,U=O.getAttributes();for(let B in U)if(U[B].location>=0){let ne=V[B],ee=W[B];if(ee===void 0&&(B==="instanceMatrix"&&E.instanceMatrix&&(ee=E.instanceMatrix),B==="instanceColor"&&E.instanceColor&&(ee=E.instanceColor)),ne===void 0||ne.attribute!==ee||ee&&ne.data!==ee.data)return!0;q++}return r.attributesNum!==q||r.index!==z}function g(E,w,O,z){let V={},W=w.attributes,q=0,U=O.getAttributes();for(let B in U)if(U[B].location>=0){let ne=W[B];ne===void 0&&(B==="instanceMatrix"&&E.instanceMatrix&&(ne=E.instanceMatrix),B==="instanceColor"&&E.instanceColor&&(ne=E.instanceColor));let ee={};ee.attribute=ne,ne&&ne.data&&(ee.data=ne.data),V[B]=ee,q++}r.attributes=V,r.attributesNum=q,r.index=z}function _(){let E=r.newAttributes;for(let w=0,O=E.length;w<O;w++)E[w]=0}function m(E){d(E,0)}function d(E,w){let O=r.newAttributes,z=r.enabledAttributes,V=r.attributeDivisors;O[E]=1,z[E]===0&&(i.enableVertexAttribArray(E),z[E]=1),V[E]!==w&&(i.vertexAttribDivisor(E,w),V[E]=w)}function M(){let E=r.newAttributes,w=r.enabledAttributes;for(let O=0,z=w.length;O<z;O++)w[O]!==E[O]&&(i.disableVertexAttribArray(O),w[O]=0)}function S(E,w,O,z,V,W,q){q===!0?i.vertexAttribIPointer(E,w,O,V,W):i.vertexAttribPointer(E,w,O,z,V,W)}function x(E,w,O,z){_();let V=z.attributes,W=O.getAttributes(),q=w.defaultAttributeValues;for(let U in W){let B=W[U];if(B.location>=0){let K=V[U];if(K===void 0&&(U==="instanceMatrix"&&E.instanceMatrix&&(K=E.instanceMatrix),U==="instanceColor"&&E.instanceColor&&(K=E.instanceColor)),K!==void 0){let ne=K.normalized,ee=K.itemSize,le=e.get(K);if(le===void 0)continue;let ce=le.buffer,ye=le.type,Re=le.bytesPerElement,j=ye===i.INT||ye===i.UNSIGNED_INT||K.gpuType===Zc;if(K.isInterleavedBufferAttribute){let X=K.data,de=X.stride,Ae=K.offset;if(X.isInstancedInterleavedBuffer){for(let xe=0;xe<B.locationSize;xe++)d(B.location+xe,X.meshPerAttribute);E.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=X.meshPerAttribute*X.count)}else for(let xe=0;xe<B.locationSize;xe++)m(B.location+xe);i.bindBuffer(i.ARRAY_BUFFER,ce);for(let xe=0;xe<B.locationSize;xe++)S(B.location+xe,ee/B.locationSize,ye,ne,de*Re,(Ae+ee/B.locationSize*xe)*Re,j)}else{if(K.isInstancedBufferAttribute){for(let X=0;X<B.locationSize;X++)d(B.location+X,K.meshPerAttribute);E.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let X=0;X<B.locationSize;X++)m(B.location+X);i.bindBuffer(i.ARRAY_BUFFER,ce);for(let X=0;X<B.locationSize;X++)S(B.location+X,ee/B.locationSize,ye,ne,ee*Re,ee/B.locationSize*X*Re,j)}}else if(q!==void 0){let ne=q[U];if(ne!==void 0)switch(ne.length){case 2:i.vertexAttrib2fv(B.location,ne);break;case 3:i.vertexAttrib3fv(B.location,ne);break;case 4:i.vertexAttrib4fv(B.location,ne);break;default:i.vertexAttrib1fv(B.location,ne)}}}}M()}function P(){I();for(let E in n){let w=n[E];for(let O in w){let z=w[O];for(let V in z)u(z[V].object),delete z[V];delete w[O]}delete n[E]}}function T(E){if(n[E.id]===void 0)return;let w=n[E.id];for(let O in w){let z=w[O];for(let V in z)u(z[V].object),delete z[V];delete w[O]}delete n[E.id]}function C(E){for(let w in n){let O=n[w];if(O[E.id]===void 0)continue;let z=O[E.id];for(let V in z)u(z[V].object),delete z[V];delete O[E.id]}}function I(){b(),o=!0,r!==s&&(r=s,c(r.object))}function b(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:b,dispose:P,releaseStatesOfGeometry:T,releaseStatesOfProgram:C,initAttributes:_,enableAttribute:m,disableUnusedAttributes:M}}function xw(i,e,t){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),t.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),t.update(u,n,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let p=0;for(let g=0;g<h;g++)p+=u[g];t.update(p,n,1)}function l(c,u,h,f){if(h===0)return;let p=e.get("WEBGL_multi_draw");if(p===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let g=0;for(let _=0;_<h;_++)g+=u[_]*f[_];t.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function yw(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let C=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(C.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(C){return!(C!==gi&&n.convert(C)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(C){let I=C===Ro&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(C!==Fi&&n.convert(C)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&C!==Qi&&!I)}function l(C){if(C==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";C="mediump"}return C==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.logarithmicDepthBuffer===!0,f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=g>0,T=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:m,maxAttributes:d,maxVertexUniforms:M,maxVaryings:S,maxFragmentUniforms:x,vertexTextures:P,maxSamples:T}}function bw(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Wn,a=new lt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||n!==0||s;return s=f,n=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,p){let g=h.clippingPlanes,_=h.clipIntersection,m=h.clipShadows,d=i.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let M=r?0:n,S=M*4,x=d.clippingState||null;l.value=x,x=u(g,f,S,p);for(let P=0;P!==S;++P)x[P]=t[P];d.clippingState=x,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,f,p,g){let _=h!==null?h.length:0,m=null;if(_!==0){if(m=l.value,g!==!0||m===null){let d=p+_*4,M=f.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<d)&&(m=new Float32Array(d));for(let S=0,x=p;S!==_;++S,x+=4)o.copy(h[S]).applyMatrix4(M,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,m}}function Mw(i){let e=new WeakMap;function t(o,a){return a===qc?o.mapping=xr:a===Yc&&(o.mapping=yr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===qc||a===Yc)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new gc(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var Lo=4,v0=[.125,.215,.35,.446,.526,.582],Er=20,sd=new vr,x0=new ct,rd=null,od=0,ad=0,ld=!1,wr=(1+Math.sqrt(5))/2,Io=1/wr,y0=[new N(-wr,Io,0),new N(wr,Io,0),new N(-Io,0,wr),new N(Io,0,wr),new N(0,wr,-Io),new N(0,wr,Io),new N(-1,1,-1),new N(1,1,-1),new N(-1,1,1),new N(1,1,1)],Sw=new N,Lh=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=Sw}=r;rd=this._renderer.getRenderTarget(),od=this._renderer.getActiveCubeFace(),ad=this._renderer.getActiveMipmapLevel(),ld=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=S0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=M0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(rd,od,ad),this._renderer.xr.enabled=ld,e.scissorTest=!1,Ph(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===xr||e.mapping===yr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),rd=this._renderer.getRenderTarget(),od=this._renderer.getActiveCubeFace(),ad=this._renderer.getActiveMipmapLevel(),ld=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:Li,minFilter:Li,generateMipmaps:!1,type:Ro,format:gi,colorSpace:fr,depthBuffer:!1},s=b0(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=b0(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=ww(r)),this._blurMaterial=Ew(r,e,t)}return s}_compileMaterial(e){let t=new ut(this._lodPlanes[0],e);this._renderer.compile(t,sd)}_sceneToCubeUV(e,t,n,s,r){let l=new An(90,1,t,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,p=h.toneMapping;h.getClearColor(x0),h.toneMapping=xs,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let _=new Ni({name:"PMREM.Background",side:zn,depthWrite:!1,depthTest:!1}),m=new ut(new Ki,_),d=!1,M=e.background;M?M.isColor&&(_.color.copy(M),e.background=null,d=!0):(_.color.copy(x0),d=!0);for(let S=0;S<6;S++){let x=S%3;x===0?(l.up.set(0,c[S],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[S],r.y,r.z)):x===1?(l.up.set(0,0,c[S]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[S],r.z)):(l.up.set(0,c[S],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[S]));let P=this._cubeSize;Ph(s,x*P,S>2?P:0,P,P),h.setRenderTarget(s),d&&h.render(m,l),h.render(e,l)}m.geometry.dispose(),m.material.dispose(),h.toneMapping=p,h.autoClear=f,e.background=M}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===xr||e.mapping===yr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=S0()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=M0());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new ut(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Ph(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,sd)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=y0[(s-r-1)%y0.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new ut(this._lodPlanes[s],c),f=c.uniforms,p=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*p):2*Math.PI/(2*Er-1),_=r/g,m=isFinite(r)?1+Math.floor(u*_):Er;m>Er&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Er}`);let d=[],M=0;for(let C=0;C<Er;++C){let I=C/_,b=Math.exp(-I*I/2);d.push(b),C===0?M+=b:C<m&&(M+=2*b)}for(let C=0;C<d.length;C++)d[C]=d[C]/M;f.envMap.value=e.texture,f.samples.value=m,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:S}=this;f.dTheta.value=g,f.mipInt.value=S-n;let x=this._sizeLods[s],P=3*x*(s>S-Lo?s-S+Lo:0),T=4*(this._cubeSize-x);Ph(t,P,T,3*x,2*x),l.setRenderTarget(t),l.render(h,sd)}};function ww(i){let e=[],t=[],n=[],s=i,r=i-Lo+1+v0.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>i-Lo?l=v0[o-i+Lo-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],p=6,g=6,_=3,m=2,d=1,M=new Float32Array(_*g*p),S=new Float32Array(m*g*p),x=new Float32Array(d*g*p);for(let T=0;T<p;T++){let C=T%3*2/3-1,I=T>2?0:-1,b=[C,I,0,C+2/3,I,0,C+2/3,I+1,0,C,I,0,C+2/3,I+1,0,C,I+1,0];M.set(b,_*g*T),S.set(f,m*g*T);let E=[T,T,T,T,T,T];x.set(E,d*g*T)}let P=new qt;P.setAttribute("position",new tn(M,_)),P.setAttribute("uv",new tn(S,m)),P.setAttribute("faceIndex",new tn(x,d)),e.push(P),s>Lo&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function b0(i,e,t){let n=new $i(i,e,t);return n.texture.mapping=Wa,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Ph(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function Ew(i,e,t){let n=new Float32Array(Er),s=new N(0,1,0);return new ri({name:"SphericalGaussianBlur",defines:{n:Er,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:vd(),fragmentShader:`

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
		`,blending:vs,depthTest:!1,depthWrite:!1})}function M0(){return new ri({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:vd(),fragmentShader:`

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
		`,blending:vs,depthTest:!1,depthWrite:!1})}function S0(){return new ri({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:vd(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:vs,depthTest:!1,depthWrite:!1})}function vd(){return`

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
	`}function Tw(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===qc||l===Yc,u=l===xr||l===yr;if(c||u){let h=e.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new Lh(i)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{let p=a.image;return c&&p&&p.height>0||u&&p&&s(p)?(t===null&&(t=new Lh(i)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function Aw(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&vo("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function Rw(i,e,t,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&e.remove(f.index);for(let g in f.attributes)e.remove(f.attributes[g]);f.removeEventListener("dispose",o),delete s[f.id];let p=r.get(f);p&&(e.remove(p),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(h){let f=h.attributes;for(let p in f)e.update(f[p],i.ARRAY_BUFFER)}function c(h){let f=[],p=h.index,g=h.attributes.position,_=0;if(p!==null){let M=p.array;_=p.version;for(let S=0,x=M.length;S<x;S+=3){let P=M[S+0],T=M[S+1],C=M[S+2];f.push(P,T,T,C,C,P)}}else if(g!==void 0){let M=g.array;_=g.version;for(let S=0,x=M.length/3-1;S<x;S+=3){let P=S+0,T=S+1,C=S+2;f.push(P,T,T,C,C,P)}}else return;let m=new(jf(f)?ba:ya)(f,1);m.version=_;let d=r.get(h);d&&e.remove(d),r.set(h,m)}function u(h){let f=r.get(h);if(f){let p=h.index;p!==null&&f.version<p.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function Cw(i,e,t){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,p){i.drawElements(n,p,r,f*o),t.update(p,n,1)}function c(f,p,g){g!==0&&(i.drawElementsInstanced(n,p,r,f*o,g),t.update(p,n,g))}function u(f,p,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,r,f,0,g);let m=0;for(let d=0;d<g;d++)m+=p[d];t.update(m,n,1)}function h(f,p,g,_){if(g===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let d=0;d<f.length;d++)c(f[d]/o,p[d],_[d]);else{m.multiDrawElementsInstancedWEBGL(n,p,0,r,f,0,_,0,g);let d=0;for(let M=0;M<g;M++)d+=p[M]*_[M];t.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function Pw(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Iw(i,e,t){let n=new WeakMap,s=new Pt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let b=function(){C.dispose(),n.delete(a),a.removeEventListener("dispose",b)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],S=0;p===!0&&(S=1),g===!0&&(S=2),_===!0&&(S=3);let x=a.attributes.position.count*S,P=1;x>e.maxTextureSize&&(P=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let T=new Float32Array(x*P*4*h),C=new va(T,x,P,h);C.type=Qi,C.needsUpdate=!0;let I=S*4;for(let E=0;E<h;E++){let w=m[E],O=d[E],z=M[E],V=x*P*4*E;for(let W=0;W<w.count;W++){let q=W*I;p===!0&&(s.fromBufferAttribute(w,W),T[V+q+0]=s.x,T[V+q+1]=s.y,T[V+q+2]=s.z,T[V+q+3]=0),g===!0&&(s.fromBufferAttribute(O,W),T[V+q+4]=s.x,T[V+q+5]=s.y,T[V+q+6]=s.z,T[V+q+7]=0),_===!0&&(s.fromBufferAttribute(z,W),T[V+q+8]=s.x,T[V+q+9]=s.y,T[V+q+10]=s.z,T[V+q+11]=z.itemSize===4?s.w:1)}}f={count:h,texture:C,size:new Fe(x,P)},n.set(a,f),a.addEventListener("dispose",b)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let p=0;for(let _=0;_<c.length;_++)p+=c[_];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function Lw(i,e,t,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var V0=new qn,w0=new Ta(1,1),G0=new va,W0=new pc,X0=new Sa,E0=[],T0=[],A0=new Float32Array(16),R0=new Float32Array(9),C0=new Float32Array(4);function Uo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=E0[s];if(r===void 0&&(r=new Float32Array(s),E0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function an(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function ln(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Uh(i,e){let t=T0[e];t===void 0&&(t=new Int32Array(e),T0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Dw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function Uw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2fv(this.addr,e),ln(t,e)}}function Nw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(an(t,e))return;i.uniform3fv(this.addr,e),ln(t,e)}}function Fw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4fv(this.addr,e),ln(t,e)}}function Ow(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;C0.set(n),i.uniformMatrix2fv(this.addr,!1,C0),ln(t,n)}}function Bw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;R0.set(n),i.uniformMatrix3fv(this.addr,!1,R0),ln(t,n)}}function zw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;A0.set(n),i.uniformMatrix4fv(this.addr,!1,A0),ln(t,n)}}function kw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Hw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2iv(this.addr,e),ln(t,e)}}function Vw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(an(t,e))return;i.uniform3iv(this.addr,e),ln(t,e)}}function Gw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4iv(this.addr,e),ln(t,e)}}function Ww(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function Xw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2uiv(this.addr,e),ln(t,e)}}function qw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(an(t,e))return;i.uniform3uiv(this.addr,e),ln(t,e)}}function Yw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4uiv(this.addr,e),ln(t,e)}}function $w(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(w0.compareFunction=Zf,r=w0):r=V0,t.setTexture2D(e||r,s)}function Zw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||W0,s)}function Kw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||X0,s)}function Jw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||G0,s)}function jw(i){switch(i){case 5126:return Dw;case 35664:return Uw;case 35665:return Nw;case 35666:return Fw;case 35674:return Ow;case 35675:return Bw;case 35676:return zw;case 5124:case 35670:return kw;case 35667:case 35671:return Hw;case 35668:case 35672:return Vw;case 35669:case 35673:return Gw;case 5125:return Ww;case 36294:return Xw;case 36295:return qw;case 36296:return Yw;case 35678:case 36198:case 36298:case 36306:case 35682:return $w;case 35679:case 36299:case 36307:return Zw;case 35680:case 36300:case 36308:case 36293:return Kw;case 36289:case 36303:case 36311:case 36292:return Jw}}function Qw(i,e){i.uniform1fv(this.addr,e)}function e1(i,e){let t=Uo(e,this.size,2);i.uniform2fv(this.addr,t)}function t1(i,e){let t=Uo(e,this.size,3);i.uniform3fv(this.addr,t)}function n1(i,e){let t=Uo(e,this.size,4);i.uniform4fv(this.addr,t)}function i1(i,e){let t=Uo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function s1(i,e){let t=Uo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function r1(i,e){let t=Uo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function o1(i,e){i.uniform1iv(this.addr,e)}function a1(i,e){i.uniform2iv(this.addr,e)}function l1(i,e){i.uniform3iv(this.addr,e)}function c1(i,e){i.uniform4iv(this.addr,e)}function h1(i,e){i.uniform1uiv(this.addr,e)}function u1(i,e){i.uniform2uiv(this.addr,e)}function f1(i,e){i.uniform3uiv(this.addr,e)}function d1(i,e){i.uniform4uiv(this.addr,e)}function p1(i,e,t){let n=this.cache,s=e.length,r=Uh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||V0,r[o])}function m1(i,e,t){let n=this.cache,s=e.length,r=Uh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||W0,r[o])}function g1(i,e,t){let n=this.cache,s=e.length,r=Uh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||X0,r[o])}function _1(i,e,t){let n=this.cache,s=e.length,r=Uh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||G0,r[o])}function v1(i){switch(i){case 5126:return Qw;case 35664:return e1;case 35665:return t1;case 35666:return n1;case 35674:return i1;case 35675:return s1;case 35676:return r1;case 5124:case 35670:return o1;case 35667:case 35671:return a1;case 35668:case 35672:return l1;case 35669:case 35673:return c1;case 5125:return h1;case 36294:return u1;case 36295:return f1;case 36296:return d1;case 35678:case 36198:case 36298:case 36306:case 35682:return p1;case 35679:case 36299:case 36307:return m1;case 35680:case 36300:case 36308:case 36293:return g1;case 36289:case 36303:case 36311:case 36292:return _1}}var hd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=jw(t.type)}},ud=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=v1(t.type)}},fd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},cd=/(\w+)(\])?(\[|\.)?/g;function P0(i,e){i.seq.push(e),i.map[e.id]=e}function x1(i,e,t){let n=i.name,s=n.length;for(cd.lastIndex=0;;){let r=cd.exec(n),o=cd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){P0(t,c===void 0?new hd(a,i,e):new ud(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new fd(a),P0(t,h)),t=h}}}var Do=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);x1(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function I0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var y1=37297,b1=0;function M1(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var L0=new lt;function S1(i){vt._getMatrix(L0,vt.workingColorSpace,i);let e=`mat3( ${L0.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(i)){case ma:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function D0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+M1(i.getShaderSource(e),a)}else return r}function w1(i,e){let t=S1(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function E1(i,e){let t;switch(e){case Zg:t="Linear";break;case Kg:t="Reinhard";break;case Jg:t="Cineon";break;case jg:t="ACESFilmic";break;case e0:t="AgX";break;case t0:t="Neutral";break;case Qg:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ih=new N;function T1(){vt.getLuminanceCoefficients(Ih);let i=Ih.x.toFixed(4),e=Ih.y.toFixed(4),t=Ih.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function A1(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ja).join(`
`)}function R1(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function C1(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ja(i){return i!==""}function U0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function N0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var P1=/^[ \t]*#include +<([\w\d./]+)>/gm;function dd(i){return i.replace(P1,L1)}var I1=new Map;function L1(i,e){let t=ft[e];if(t===void 0){let n=I1.get(e);if(n!==void 0)t=ft[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return dd(t)}var D1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function F0(i){return i.replace(D1,U1)}function U1(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function O0(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}function N1(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Uf?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===Rg?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===ji&&(e="SHADOWMAP_TYPE_VSM"),e}function F1(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case xr:case yr:e="ENVMAP_TYPE_CUBE";break;case Wa:e="ENVMAP_TYPE_CUBE_UV";break}return e}function O1(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case yr:e="ENVMAP_MODE_REFRACTION";break}return e}function B1(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Bf:e="ENVMAP_BLENDING_MULTIPLY";break;case Yg:e="ENVMAP_BLENDING_MIX";break;case $g:e="ENVMAP_BLENDING_ADD";break}return e}function z1(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function k1(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=N1(t),c=F1(t),u=O1(t),h=B1(t),f=z1(t),p=A1(t),g=R1(r),_=s.createProgram(),m,d,M=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Ja).join(`
`),m.length>0&&(m+=`
`),d=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Ja).join(`
`),d.length>0&&(d+=`
`)):(m=[O0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ja).join(`
`),d=[O0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==xs?"#define TONE_MAPPING":"",t.toneMapping!==xs?ft.tonemapping_pars_fragment:"",t.toneMapping!==xs?E1("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,w1("linearToOutputTexel",t.outputColorSpace),T1(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ja).join(`
`)),o=dd(o),o=U0(o,t),o=N0(o,t),a=dd(a),a=U0(a,t),a=N0(a,t),o=F0(o),a=F0(a),t.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,d=["#define varying in",t.glslVersion===Kf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Kf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let S=M+m+o,x=M+d+a,P=I0(s,s.VERTEX_SHADER,S),T=I0(s,s.FRAGMENT_SHADER,x);s.attachShader(_,P),s.attachShader(_,T),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function C(w){if(i.debug.checkShaderErrors){let O=s.getProgramInfoLog(_)||"",z=s.getShaderInfoLog(P)||"",V=s.getShaderInfoLog(T)||"",W=O.trim(),q=z.trim(),U=V.trim(),B=!0,K=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(B=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,_,P,T);else{let ne=D0(s,P,"vertex"),ee=D0(s,T,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+w.name+`
Material Type: `+w.type+`

Program Info Log: `+W+`
`+ne+`
`+ee)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(q===""||U==="")&&(K=!1);K&&(w.diagnostics={runnable:B,programLog:W,vertexShader:{log:q,prefix:m},fragmentShader:{log:U,prefix:d}})}s.deleteShader(P),s.deleteShader(T),I=new Do(s,_),b=C1(s,_)}let I;this.getUniforms=function(){return I===void 0&&C(this),I};let b;this.getAttributes=function(){return b===void 0&&C(this),b};let E=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return E===!1&&(E=s.getProgramParameter(_,y1)),E},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=b1++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=P,this.fragmentShader=T,this}var H1=0,pd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new md(e),t.set(e,n)),n}},md=class{constructor(e){this.id=H1++,this.code=e,this.usedTimes=0}};function V1(i,e,t,n,s,r,o){let a=new xa,l=new pd,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,p=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function _(b){return c.add(b),b===0?"uv":`uv${b}`}function m(b,E,w,O,z){let V=O.fog,W=z.geometry,q=b.isMeshStandardMaterial?O.environment:null,U=(b.isMeshStandardMaterial?t:e).get(b.envMap||q),B=U&&U.mapping===Wa?U.image.height:null,K=g[b.type];b.precision!==null&&(p=s.getMaxPrecision(b.precision),p!==b.precision&&console.warn("THREE.WebGLProgram.getParameters:",b.precision,"not supported, using",p,"instead."));let ne=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,ee=ne!==void 0?ne.length:0,le=0;W.morphAttributes.position!==void 0&&(le=1),W.morphAttributes.normal!==void 0&&(le=2),W.morphAttributes.color!==void 0&&(le=3);let ce,ye,Re,j;if(K){let xt=Hn[K];ce=xt.vertexShader,ye=xt.fragmentShader}else ce=b.vertexShader,ye=b.fragmentShader,l.update(b),Re=l.getVertexShaderID(b),j=l.getFragmentShaderID(b);let X=i.getRenderTarget(),de=i.state.buffers.depth.getReversed(),Ae=z.isInstancedMesh===!0,xe=z.isBatchedMesh===!0,Ke=!!b.map,mt=!!b.matcap,k=!!U,ue=!!b.aoMap,Q=!!b.lightMap,se=!!b.bumpMap,fe=!!b.normalMap,Pe=!!b.displacementMap,te=!!b.emissiveMap,ve=!!b.metalnessMap,Ne=!!b.roughnessMap,Ye=b.anisotropy>0,L=b.clearcoat>0,y=b.dispersion>0,H=b.iridescence>0,re=b.sheen>0,pe=b.transmission>0,he=Ye&&!!b.anisotropyMap,He=L&&!!b.clearcoatMap,Me=L&&!!b.clearcoatNormalMap,Ve=L&&!!b.clearcoatRoughnessMap,Oe=H&&!!b.iridescenceMap,ge=H&&!!b.iridescenceThicknessMap,Ie=re&&!!b.sheenColorMap,Ze=re&&!!b.sheenRoughnessMap,$e=!!b.specularMap,De=!!b.specularColorMap,it=!!b.specularIntensityMap,Y=pe&&!!b.transmissionMap,we=pe&&!!b.thicknessMap,Te=!!b.gradientMap,Ge=!!b.alphaMap,Se=b.alphaTest>0,_e=!!b.alphaHash,qe=!!b.extensions,rt=xs;b.toneMapped&&(X===null||X.isXRRenderTarget===!0)&&(rt=i.toneMapping);let It={shaderID:K,shaderType:b.type,shaderName:b.name,vertexShader:ce,fragmentShader:ye,defines:b.defines,customVertexShaderID:Re,customFragmentShaderID:j,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:p,batching:xe,batchingColor:xe&&z._colorsTexture!==null,instancing:Ae,instancingColor:Ae&&z.instanceColor!==null,instancingMorph:Ae&&z.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:X===null?i.outputColorSpace:X.isXRRenderTarget===!0?X.texture.colorSpace:fr,alphaToCoverage:!!b.alphaToCoverage,map:Ke,matcap:mt,envMap:k,envMapMode:k&&U.mapping,envMapCubeUVHeight:B,aoMap:ue,lightMap:Q,bumpMap:se,normalMap:fe,displacementMap:f&&Pe,emissiveMap:te,normalMapObjectSpace:fe&&b.normalMapType===r0,normalMapTangentSpace:fe&&b.normalMapType===$f,metalnessMap:ve,roughnessMap:Ne,anisotropy:Ye,anisotropyMap:he,clearcoat:L,clearcoatMap:He,clearcoatNormalMap:Me,clearcoatRoughnessMap:Ve,dispersion:y,iridescence:H,iridescenceMap:Oe,iridescenceThicknessMap:ge,sheen:re,sheenColorMap:Ie,sheenRoughnessMap:Ze,specularMap:$e,specularColorMap:De,specularIntensityMap:it,transmission:pe,transmissionMap:Y,thicknessMap:we,gradientMap:Te,opaque:b.transparent===!1&&b.blending===hr&&b.alphaToCoverage===!1,alphaMap:Ge,alphaTest:Se,alphaHash:_e,combine:b.combine,mapUv:Ke&&_(b.map.channel),aoMapUv:ue&&_(b.aoMap.channel),lightMapUv:Q&&_(b.lightMap.channel),bumpMapUv:se&&_(b.bumpMap.channel),normalMapUv:fe&&_(b.normalMap.channel),displacementMapUv:Pe&&_(b.displacementMap.channel),emissiveMapUv:te&&_(b.emissiveMap.channel),metalnessMapUv:ve&&_(b.metalnessMap.channel),roughnessMapUv:Ne&&_(b.roughnessMap.channel),anisotropyMapUv:he&&_(b.anisotropyMap.channel),clearcoatMapUv:He&&_(b.clearcoatMap.channel),clearcoatNormalMapUv:Me&&_(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Ve&&_(b.clearcoatRoughnessMap.channel),iridescenceMapUv:Oe&&_(b.iridescenceMap.channel),iridescenceThicknessMapUv:ge&&_(b.iridescenceThicknessMap.channel),sheenColorMapUv:Ie&&_(b.sheenColorMap.channel),sheenRoughnessMapUv:Ze&&_(b.sheenRoughnessMap.channel),specularMapUv:$e&&_(b.specularMap.channel),specularColorMapUv:De&&_(b.specularColorMap.channel),specularIntensityMapUv:it&&_(b.specularIntensityMap.channel),transmissionMapUv:Y&&_(b.transmissionMap.channel),thicknessMapUv:we&&_(b.thicknessMap.channel),alphaMapUv:Ge&&_(b.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(fe||Ye),vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:z.isPoints===!0&&!!W.attributes.uv&&(Ke||Ge),fog:!!V,useFog:b.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:b.flatShading===!0&&b.wireframe===!1,sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:de,skinning:z.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:le,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&w.length>0,shadowMapType:i.shadowMap.type,toneMapping:rt,decodeVideoTexture:Ke&&b.map.isVideoTexture===!0&&vt.getTransfer(b.map.colorSpace)===Ct,decodeVideoTextureEmissive:te&&b.emissiveMap.isVideoTexture===!0&&vt.getTransfer(b.emissiveMap.colorSpace)===Ct,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===kn,flipSided:b.side===zn,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:qe&&b.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(qe&&b.extensions.multiDraw===!0||xe)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return It.vertexUv1s=c.has(1),It.vertexUv2s=c.has(2),It.vertexUv3s=c.has(3),c.clear(),It}function d(b){let E=[];if(b.shaderID?E.push(b.shaderID):(E.push(b.customVertexShaderID),E.push(b.customFragmentShaderID)),b.defines!==void 0)for(let w in b.defines)E.push(w),E.push(b.defines[w]);return b.isRawShaderMaterial===!1&&(M(E,b),S(E,b),E.push(i.outputColorSpace)),E.push(b.customProgramCacheKey),E.join()}function M(b,E){b.push(E.precision),b.push(E.outputColorSpace),b.push(E.envMapMode),b.push(E.envMapCubeUVHeight),b.push(E.mapUv),b.push(E.alphaMapUv),b.push(E.lightMapUv),b.push(E.aoMapUv),b.push(E.bumpMapUv),b.push(E.normalMapUv),b.push(E.displacementMapUv),b.push(E.emissiveMapUv),b.push(E.metalnessMapUv),b.push(E.roughnessMapUv),b.push(E.anisotropyMapUv),b.push(E.clearcoatMapUv),b.push(E.clearcoatNormalMapUv),b.push(E.clearcoatRoughnessMapUv),b.push(E.iridescenceMapUv),b.push(E.iridescenceThicknessMapUv),b.push(E.sheenColorMapUv),b.push(E.sheenRoughnessMapUv),b.push(E.specularMapUv),b.push(E.specularColorMapUv),b.push(E.specularIntensityMapUv),b.push(E.transmissionMapUv),b.push(E.thicknessMapUv),b.push(E.combine),b.push(E.fogExp2),b.push(E.sizeAttenuation),b.push(E.morphTargetsCount),b.push(E.morphAttributeCount),b.push(E.numDirLights),b.push(E.numPointLights),b.push(E.numSpotLights),b.push(E.numSpotLightMaps),b.push(E.numHemiLights),b.push(E.numRectAreaLights),b.push(E.numDirLightShadows),b.push(E.numPointLightShadows),b.push(E.numSpotLightShadows),b.push(E.numSpotLightShadowsWithMaps),b.push(E.numLightProbes),b.push(E.shadowMapType),b.push(E.toneMapping),b.push(E.numClippingPlanes),b.push(E.numClipIntersection),b.push(E.depthPacking)}function S(b,E){a.disableAll(),E.supportsVertexTextures&&a.enable(0),E.instancing&&a.enable(1),E.instancingColor&&a.enable(2),E.instancingMorph&&a.enable(3),E.matcap&&a.enable(4),E.envMap&&a.enable(5),E.normalMapObjectSpace&&a.enable(6),E.normalMapTangentSpace&&a.enable(7),E.clearcoat&&a.enable(8),E.iridescence&&a.enable(9),E.alphaTest&&a.enable(10),E.vertexColors&&a.enable(11),E.vertexAlphas&&a.enable(12),E.vertexUv1s&&a.enable(13),E.vertexUv2s&&a.enable(14),E.vertexUv3s&&a.enable(15),E.vertexTangents&&a.enable(16),E.anisotropy&&a.enable(17),E.alphaHash&&a.enable(18),E.batching&&a.enable(19),E.dispersion&&a.enable(20),E.batchingColor&&a.enable(21),E.gradientMap&&a.enable(22),b.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),b.push(a.mask)}function x(b){let E=g[b.type],w;if(E){let O=Hn[E];w=Ka.clone(O.uniforms)}else w=b.uniforms;return w}function P(b,E){let w;for(let O=0,z=u.length;O<z;O++){let V=u[O];if(V.cacheKey===E){w=V,++w.usedTimes;break}}return w===void 0&&(w=new k1(i,E,b,r),u.push(w)),w}function T(b){if(--b.usedTimes===0){let E=u.indexOf(b);u[E]=u[u.length-1],u.pop(),b.destroy()}}function C(b){l.remove(b)}function I(){l.dispose()}return{getParameters:m,getProgramCacheKey:d,getUniforms:x,acquireProgram:P,releaseProgram:T,releaseShaderCache:C,programs:u,dispose:I}}function G1(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function W1(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function B0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function z0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h,f,p,g,_,m){let d=i[e];return d===void 0?(d={id:h.id,object:h,geometry:f,material:p,groupOrder:g,renderOrder:h.renderOrder,z:_,group:m},i[e]=d):(d.id=h.id,d.object=h,d.geometry=f,d.material=p,d.groupOrder=g,d.renderOrder=h.renderOrder,d.z=_,d.group=m),e++,d}function a(h,f,p,g,_,m){let d=o(h,f,p,g,_,m);p.transmission>0?n.push(d):p.transparent===!0?s.push(d):t.push(d)}function l(h,f,p,g,_,m){let d=o(h,f,p,g,_,m);p.transmission>0?n.unshift(d):p.transparent===!0?s.unshift(d):t.unshift(d)}function c(h,f){t.length>1&&t.sort(h||W1),n.length>1&&n.sort(f||B0),s.length>1&&s.sort(f||B0)}function u(){for(let h=e,f=i.length;h<f;h++){let p=i[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function X1(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new z0,i.set(n,[o])):s>=r.length?(o=new z0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function q1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new N,color:new ct};break;case"SpotLight":t={position:new N,direction:new N,color:new ct,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new N,color:new ct,distance:0,decay:0};break;case"HemisphereLight":t={direction:new N,skyColor:new ct,groundColor:new ct};break;case"RectAreaLight":t={color:new ct,position:new N,halfWidth:new N,halfHeight:new N};break}return i[e.id]=t,t}}}function Y1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var $1=0;function Z1(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function K1(i){let e=new q1,t=Y1(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new N);let s=new N,r=new Dt,o=new Dt;function a(c){let u=0,h=0,f=0;for(let b=0;b<9;b++)n.probe[b].set(0,0,0);let p=0,g=0,_=0,m=0,d=0,M=0,S=0,x=0,P=0,T=0,C=0;c.sort(Z1);for(let b=0,E=c.length;b<E;b++){let w=c[b],O=w.color,z=w.intensity,V=w.distance,W=w.shadow&&w.shadow.map?w.shadow.map.texture:null;if(w.isAmbientLight)u+=O.r*z,h+=O.g*z,f+=O.b*z;else if(w.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(w.sh.coefficients[q],z);C++}else if(w.isDirectionalLight){let q=e.get(w);if(q.color.copy(w.color).multiplyScalar(w.intensity),w.castShadow){let U=w.shadow,B=t.get(w);B.shadowIntensity=U.intensity,B.shadowBias=U.bias,B.shadowNormalBias=U.normalBias,B.shadowRadius=U.radius,B.shadowMapSize=U.mapSize,n.directionalShadow[p]=B,n.directionalShadowMap[p]=W,n.directionalShadowMatrix[p]=w.shadow.matrix,M++}n.directional[p]=q,p++}else if(w.isSpotLight){let q=e.get(w);q.position.setFromMatrixPosition(w.matrixWorld),q.color.copy(O).multiplyScalar(z),q.distance=V,q.coneCos=Math.cos(w.angle),q.penumbraCos=Math.cos(w.angle*(1-w.penumbra)),q.decay=w.decay,n.spot[_]=q;let U=w.shadow;if(w.map&&(n.spotLightMap[P]=w.map,P++,U.updateMatrices(w),w.castShadow&&T++),n.spotLightMatrix[_]=U.matrix,w.castShadow){let B=t.get(w);B.shadowIntensity=U.intensity,B.shadowBias=U.bias,B.shadowNormalBias=U.normalBias,B.shadowRadius=U.radius,B.shadowMapSize=U.mapSize,n.spotShadow[_]=B,n.spotShadowMap[_]=W,x++}_++}else if(w.isRectAreaLight){let q=e.get(w);q.color.copy(O).multiplyScalar(z),q.halfWidth.set(w.width*.5,0,0),q.halfHeight.set(0,w.height*.5,0),n.rectArea[m]=q,m++}else if(w.isPointLight){let q=e.get(w);if(q.color.copy(w.color).multiplyScalar(w.intensity),q.distance=w.distance,q.decay=w.decay,w.castShadow){let U=w.shadow,B=t.get(w);B.shadowIntensity=U.intensity,B.shadowBias=U.bias,B.shadowNormalBias=U.normalBias,B.shadowRadius=U.radius,B.shadowMapSize=U.mapSize,B.shadowCameraNear=U.camera.near,B.shadowCameraFar=U.camera.far,n.pointShadow[g]=B,n.pointShadowMap[g]=W,n.pointShadowMatrix[g]=w.shadow.matrix,S++}n.point[g]=q,g++}else if(w.isHemisphereLight){let q=e.get(w);q.skyColor.copy(w.color).multiplyScalar(z),q.groundColor.copy(w.groundColor).multiplyScalar(z),n.hemi[d]=q,d++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Le.LTC_FLOAT_1,n.rectAreaLTC2=Le.LTC_FLOAT_2):(n.rectAreaLTC1=Le.LTC_HALF_1,n.rectAreaLTC2=Le.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let I=n.hash;(I.directionalLength!==p||I.pointLength!==g||I.spotLength!==_||I.rectAreaLength!==m||I.hemiLength!==d||I.numDirectionalShadows!==M||I.numPointShadows!==S||I.numSpotShadows!==x||I.numSpotMaps!==P||I.numLightProbes!==C)&&(n.directional.length=p,n.spot.length=_,n.rectArea.length=m,n.point.length=g,n.hemi.length=d,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=x,n.spotShadowMap.length=x,n.directionalShadowMatrix.length=M,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=x+P-T,n.spotLightMap.length=P,n.numSpotLightShadowsWithMaps=T,n.numLightProbes=C,I.directionalLength=p,I.pointLength=g,I.spotLength=_,I.rectAreaLength=m,I.hemiLength=d,I.numDirectionalShadows=M,I.numPointShadows=S,I.numSpotShadows=x,I.numSpotMaps=P,I.numLightProbes=C,n.version=$1++)}function l(c,u){let h=0,f=0,p=0,g=0,_=0,m=u.matrixWorldInverse;for(let d=0,M=c.length;d<M;d++){let S=c[d];if(S.isDirectionalLight){let x=n.directional[h];x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),h++}else if(S.isSpotLight){let x=n.spot[p];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),p++}else if(S.isRectAreaLight){let x=n.rectArea[g];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(S.width*.5,0,0),x.halfHeight.set(0,S.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),g++}else if(S.isPointLight){let x=n.point[f];x.position.setFromMatrixPosition(S.matrixWorld),x.position.applyMatrix4(m),f++}else if(S.isHemisphereLight){let x=n.hemi[_];x.direction.setFromMatrixPosition(S.matrixWorld),x.direction.transformDirection(m),_++}}}return{setup:a,setupView:l,state:n}}function k0(i){let e=new K1(i),t=[],n=[];function s(u){c.camera=u,t.length=0,n.length=0}function r(u){t.push(u)}function o(u){n.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function J1(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new k0(i),e.set(s,[a])):r>=o.length?(a=new k0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var j1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Q1=`uniform sampler2D shadow_pass;
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
}`;function eE(i,e,t){let n=new wo,s=new Fe,r=new Fe,o=new Pt,a=new Ac({depthPacking:s0}),l=new Rc,c={},u=t.maxTextureSize,h={[gs]:zn,[zn]:gs,[kn]:kn},f=new ri({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Fe},radius:{value:4}},vertexShader:j1,fragmentShader:Q1}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let g=new qt;g.setAttribute("position",new tn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new ut(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Uf;let d=this.type;this.render=function(T,C,I){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;let b=i.getRenderTarget(),E=i.getActiveCubeFace(),w=i.getActiveMipmapLevel(),O=i.state;O.setBlending(vs),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let z=d!==ji&&this.type===ji,V=d===ji&&this.type!==ji;for(let W=0,q=T.length;W<q;W++){let U=T[W],B=U.shadow;if(B===void 0){console.warn("THREE.WebGLShadowMap:",U,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let K=B.getFrameExtents();if(s.multiply(K),r.copy(B.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/K.x),s.x=r.x*K.x,B.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/K.y),s.y=r.y*K.y,B.mapSize.y=r.y)),B.map===null||z===!0||V===!0){let ee=this.type!==ji?{minFilter:mi,magFilter:mi}:{};B.map!==null&&B.map.dispose(),B.map=new $i(s.x,s.y,ee),B.map.texture.name=U.name+".shadowMap",B.camera.updateProjectionMatrix()}i.setRenderTarget(B.map),i.clear();let ne=B.getViewportCount();for(let ee=0;ee<ne;ee++){let le=B.getViewport(ee);o.set(r.x*le.x,r.y*le.y,r.x*le.z,r.y*le.w),O.viewport(o),B.updateMatrices(U,ee),n=B.getFrustum(),x(C,I,B.camera,U,this.type)}B.isPointLightShadow!==!0&&this.type===ji&&M(B,I),B.needsUpdate=!1}d=this.type,m.needsUpdate=!1,i.setRenderTarget(b,E,w)};function M(T,C){let I=e.update(_);f.defines.VSM_SAMPLES!==T.blurSamples&&(f.defines.VSM_SAMPLES=T.blurSamples,p.defines.VSM_SAMPLES=T.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),T.mapPass===null&&(T.mapPass=new $i(s.x,s.y)),f.uniforms.shadow_pass.value=T.map.texture,f.uniforms.resolution.value=T.mapSize,f.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(C,null,I,f,_,null),p.uniforms.shadow_pass.value=T.mapPass.texture,p.uniforms.resolution.value=T.mapSize,p.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(C,null,I,p,_,null)}function S(T,C,I,b){let E=null,w=I.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(w!==void 0)E=w;else if(E=I.isPointLight===!0?l:a,i.localClippingEnabled&&C.clipShadows===!0&&Array.isArray(C.clippingPlanes)&&C.clippingPlanes.length!==0||C.displacementMap&&C.displacementScale!==0||C.alphaMap&&C.alphaTest>0||C.map&&C.alphaTest>0||C.alphaToCoverage===!0){let O=E.uuid,z=C.uuid,V=c[O];V===void 0&&(V={},c[O]=V);let W=V[z];W===void 0&&(W=E.clone(),V[z]=W,C.addEventListener("dispose",P)),E=W}if(E.visible=C.visible,E.wireframe=C.wireframe,b===ji?E.side=C.shadowSide!==null?C.shadowSide:C.side:E.side=C.shadowSide!==null?C.shadowSide:h[C.side],E.alphaMap=C.alphaMap,E.alphaTest=C.alphaToCoverage===!0?.5:C.alphaTest,E.map=C.map,E.clipShadows=C.clipShadows,E.clippingPlanes=C.clippingPlanes,E.clipIntersection=C.clipIntersection,E.displacementMap=C.displacementMap,E.displacementScale=C.displacementScale,E.displacementBias=C.displacementBias,E.wireframeLinewidth=C.wireframeLinewidth,E.linewidth=C.linewidth,I.isPointLight===!0&&E.isMeshDistanceMaterial===!0){let O=i.properties.get(E);O.light=I}return E}function x(T,C,I,b,E){if(T.visible===!1)return;if(T.layers.test(C.layers)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&E===ji)&&(!T.frustumCulled||n.intersectsObject(T))){T.modelViewMatrix.multiplyMatrices(I.matrixWorldInverse,T.matrixWorld);let z=e.update(T),V=T.material;if(Array.isArray(V)){let W=z.groups;for(let q=0,U=W.length;q<U;q++){let B=W[q],K=V[B.materialIndex];if(K&&K.visible){let ne=S(T,K,b,E);T.onBeforeShadow(i,T,C,I,z,ne,B),i.renderBufferDirect(I,null,z,ne,T,B),T.onAfterShadow(i,T,C,I,z,ne,B)}}}else if(V.visible){let W=S(T,V,b,E);T.onBeforeShadow(i,T,C,I,z,W,null),i.renderBufferDirect(I,null,z,W,T,null),T.onAfterShadow(i,T,C,I,z,W,null)}}let O=T.children;for(let z=0,V=O.length;z<V;z++)x(O[z],C,I,b,E)}function P(T){T.target.removeEventListener("dispose",P);for(let I in c){let b=c[I],E=T.target.uuid;E in b&&(b[E].dispose(),delete b[E])}}}var tE={[zc]:kc,[Hc]:Wc,[Vc]:Xc,[ur]:Gc,[kc]:zc,[Wc]:Hc,[Xc]:Vc,[Gc]:ur};function nE(i,e){function t(){let Y=!1,we=new Pt,Te=null,Ge=new Pt(0,0,0,0);return{setMask:function(Se){Te!==Se&&!Y&&(i.colorMask(Se,Se,Se,Se),Te=Se)},setLocked:function(Se){Y=Se},setClear:function(Se,_e,qe,rt,It){It===!0&&(Se*=rt,_e*=rt,qe*=rt),we.set(Se,_e,qe,rt),Ge.equals(we)===!1&&(i.clearColor(Se,_e,qe,rt),Ge.copy(we))},reset:function(){Y=!1,Te=null,Ge.set(-1,0,0,0)}}}function n(){let Y=!1,we=!1,Te=null,Ge=null,Se=null;return{setReversed:function(_e){if(we!==_e){let qe=e.get("EXT_clip_control");_e?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),we=_e;let rt=Se;Se=null,this.setClear(rt)}},getReversed:function(){return we},setTest:function(_e){_e?X(i.DEPTH_TEST):de(i.DEPTH_TEST)},setMask:function(_e){Te!==_e&&!Y&&(i.depthMask(_e),Te=_e)},setFunc:function(_e){if(we&&(_e=tE[_e]),Ge!==_e){switch(_e){case zc:i.depthFunc(i.NEVER);break;case kc:i.depthFunc(i.ALWAYS);break;case Hc:i.depthFunc(i.LESS);break;case ur:i.depthFunc(i.LEQUAL);break;case Vc:i.depthFunc(i.EQUAL);break;case Gc:i.depthFunc(i.GEQUAL);break;case Wc:i.depthFunc(i.GREATER);break;case Xc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ge=_e}},setLocked:function(_e){Y=_e},setClear:function(_e){Se!==_e&&(we&&(_e=1-_e),i.clearDepth(_e),Se=_e)},reset:function(){Y=!1,Te=null,Ge=null,Se=null,we=!1}}}function s(){let Y=!1,we=null,Te=null,Ge=null,Se=null,_e=null,qe=null,rt=null,It=null;return{setTest:function(xt){Y||(xt?X(i.STENCIL_TEST):de(i.STENCIL_TEST))},setMask:function(xt){we!==xt&&!Y&&(i.stencilMask(xt),we=xt)},setFunc:function(xt,vn,Nt){(Te!==xt||Ge!==vn||Se!==Nt)&&(i.stencilFunc(xt,vn,Nt),Te=xt,Ge=vn,Se=Nt)},setOp:function(xt,vn,Nt){(_e!==xt||qe!==vn||rt!==Nt)&&(i.stencilOp(xt,vn,Nt),_e=xt,qe=vn,rt=Nt)},setLocked:function(xt){Y=xt},setClear:function(xt){It!==xt&&(i.clearStencil(xt),It=xt)},reset:function(){Y=!1,we=null,Te=null,Ge=null,Se=null,_e=null,qe=null,rt=null,It=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,p=[],g=null,_=!1,m=null,d=null,M=null,S=null,x=null,P=null,T=null,C=new ct(0,0,0),I=0,b=!1,E=null,w=null,O=null,z=null,V=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,U=0,B=i.getParameter(i.VERSION);B.indexOf("WebGL")!==-1?(U=parseFloat(/^WebGL (\d)/.exec(B)[1]),q=U>=1):B.indexOf("OpenGL ES")!==-1&&(U=parseFloat(/^OpenGL ES (\d)/.exec(B)[1]),q=U>=2);let K=null,ne={},ee=i.getParameter(i.SCISSOR_BOX),le=i.getParameter(i.VIEWPORT),ce=new Pt().fromArray(ee),ye=new Pt().fromArray(le);function Re(Y,we,Te,Ge){let Se=new Uint8Array(4),_e=i.createTexture();i.bindTexture(Y,_e),i.texParameteri(Y,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(Y,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qe=0;qe<Te;qe++)Y===i.TEXTURE_3D||Y===i.TEXTURE_2D_ARRAY?i.texImage3D(we,0,i.RGBA,1,1,Ge,0,i.RGBA,i.UNSIGNED_BYTE,Se):i.texImage2D(we+qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Se);return _e}let j={};j[i.TEXTURE_2D]=Re(i.TEXTURE_2D,i.TEXTURE_2D,1),j[i.TEXTURE_CUBE_MAP]=Re(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),j[i.TEXTURE_2D_ARRAY]=Re(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),j[i.TEXTURE_3D]=Re(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),X(i.DEPTH_TEST),o.setFunc(ur),se(!1),fe(Df),X(i.CULL_FACE),ue(vs);function X(Y){u[Y]!==!0&&(i.enable(Y),u[Y]=!0)}function de(Y){u[Y]!==!1&&(i.disable(Y),u[Y]=!1)}function Ae(Y,we){return h[Y]!==we?(i.bindFramebuffer(Y,we),h[Y]=we,Y===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=we),Y===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=we),!0):!1}function xe(Y,we){let Te=p,Ge=!1;if(Y){Te=f.get(we),Te===void 0&&(Te=[],f.set(we,Te));let Se=Y.textures;if(Te.length!==Se.length||Te[0]!==i.COLOR_ATTACHMENT0){for(let _e=0,qe=Se.length;_e<qe;_e++)Te[_e]=i.COLOR_ATTACHMENT0+_e;Te.length=Se.length,Ge=!0}}else Te[0]!==i.BACK&&(Te[0]=i.BACK,Ge=!0);Ge&&i.drawBuffers(Te)}function Ke(Y){return g!==Y?(i.useProgram(Y),g=Y,!0):!1}let mt={[Fs]:i.FUNC_ADD,[Pg]:i.FUNC_SUBTRACT,[Ig]:i.FUNC_REVERSE_SUBTRACT};mt[Lg]=i.MIN,mt[Dg]=i.MAX;let k={[Ug]:i.ZERO,[Ng]:i.ONE,[Fg]:i.SRC_COLOR,[oc]:i.SRC_ALPHA,[Vg]:i.SRC_ALPHA_SATURATE,[kg]:i.DST_COLOR,[Bg]:i.DST_ALPHA,[Og]:i.ONE_MINUS_SRC_COLOR,[ac]:i.ONE_MINUS_SRC_ALPHA,[Hg]:i.ONE_MINUS_DST_COLOR,[zg]:i.ONE_MINUS_DST_ALPHA,[Gg]:i.CONSTANT_COLOR,[Wg]:i.ONE_MINUS_CONSTANT_COLOR,[Xg]:i.CONSTANT_ALPHA,[qg]:i.ONE_MINUS_CONSTANT_ALPHA};function ue(Y,we,Te,Ge,Se,_e,qe,rt,It,xt){if(Y===vs){_===!0&&(de(i.BLEND),_=!1);return}if(_===!1&&(X(i.BLEND),_=!0),Y!==Cg){if(Y!==m||xt!==b){if((d!==Fs||x!==Fs)&&(i.blendEquation(i.FUNC_ADD),d=Fs,x=Fs),xt)switch(Y){case hr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Nf:i.blendFunc(i.ONE,i.ONE);break;case Ff:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Of:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",Y);break}else switch(Y){case hr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Nf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Ff:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Of:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",Y);break}M=null,S=null,P=null,T=null,C.set(0,0,0),I=0,m=Y,b=xt}return}Se=Se||we,_e=_e||Te,qe=qe||Ge,(we!==d||Se!==x)&&(i.blendEquationSeparate(mt[we],mt[Se]),d=we,x=Se),(Te!==M||Ge!==S||_e!==P||qe!==T)&&(i.blendFuncSeparate(k[Te],k[Ge],k[_e],k[qe]),M=Te,S=Ge,P=_e,T=qe),(rt.equals(C)===!1||It!==I)&&(i.blendColor(rt.r,rt.g,rt.b,It),C.copy(rt),I=It),m=Y,b=!1}function Q(Y,we){Y.side===kn?de(i.CULL_FACE):X(i.CULL_FACE);let Te=Y.side===zn;we&&(Te=!Te),se(Te),Y.blending===hr&&Y.transparent===!1?ue(vs):ue(Y.blending,Y.blendEquation,Y.blendSrc,Y.blendDst,Y.blendEquationAlpha,Y.blendSrcAlpha,Y.blendDstAlpha,Y.blendColor,Y.blendAlpha,Y.premultipliedAlpha),o.setFunc(Y.depthFunc),o.setTest(Y.depthTest),o.setMask(Y.depthWrite),r.setMask(Y.colorWrite);let Ge=Y.stencilWrite;a.setTest(Ge),Ge&&(a.setMask(Y.stencilWriteMask),a.setFunc(Y.stencilFunc,Y.stencilRef,Y.stencilFuncMask),a.setOp(Y.stencilFail,Y.stencilZFail,Y.stencilZPass)),te(Y.polygonOffset,Y.polygonOffsetFactor,Y.polygonOffsetUnits),Y.alphaToCoverage===!0?X(i.SAMPLE_ALPHA_TO_COVERAGE):de(i.SAMPLE_ALPHA_TO_COVERAGE)}function se(Y){E!==Y&&(Y?i.frontFace(i.CW):i.frontFace(i.CCW),E=Y)}function fe(Y){Y!==Tg?(X(i.CULL_FACE),Y!==w&&(Y===Df?i.cullFace(i.BACK):Y===Ag?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):de(i.CULL_FACE),w=Y}function Pe(Y){Y!==O&&(q&&i.lineWidth(Y),O=Y)}function te(Y,we,Te){Y?(X(i.POLYGON_OFFSET_FILL),(z!==we||V!==Te)&&(i.polygonOffset(we,Te),z=we,V=Te)):de(i.POLYGON_OFFSET_FILL)}function ve(Y){Y?X(i.SCISSOR_TEST):de(i.SCISSOR_TEST)}function Ne(Y){Y===void 0&&(Y=i.TEXTURE0+W-1),K!==Y&&(i.activeTexture(Y),K=Y)}function Ye(Y,we,Te){Te===void 0&&(K===null?Te=i.TEXTURE0+W-1:Te=K);let Ge=ne[Te];Ge===void 0&&(Ge={type:void 0,texture:void 0},ne[Te]=Ge),(Ge.type!==Y||Ge.texture!==we)&&(K!==Te&&(i.activeTexture(Te),K=Te),i.bindTexture(Y,we||j[Y]),Ge.type=Y,Ge.texture=we)}function L(){let Y=ne[K];Y!==void 0&&Y.type!==void 0&&(i.bindTexture(Y.type,null),Y.type=void 0,Y.texture=void 0)}function y(){try{i.compressedTexImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function H(){try{i.compressedTexImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function re(){try{i.texSubImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function pe(){try{i.texSubImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function he(){try{i.compressedTexSubImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function He(){try{i.compressedTexSubImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Me(){try{i.texStorage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Ve(){try{i.texStorage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Oe(){try{i.texImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function ge(){try{i.texImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Ie(Y){ce.equals(Y)===!1&&(i.scissor(Y.x,Y.y,Y.z,Y.w),ce.copy(Y))}function Ze(Y){ye.equals(Y)===!1&&(i.viewport(Y.x,Y.y,Y.z,Y.w),ye.copy(Y))}function $e(Y,we){let Te=c.get(we);Te===void 0&&(Te=new WeakMap,c.set(we,Te));let Ge=Te.get(Y);Ge===void 0&&(Ge=i.getUniformBlockIndex(we,Y.name),Te.set(Y,Ge))}function De(Y,we){let Ge=c.get(we).get(Y);l.get(we)!==Ge&&(i.uniformBlockBinding(we,Ge,Y.__bindingPointIndex),l.set(we,Ge))}function it(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},K=null,ne={},h={},f=new WeakMap,p=[],g=null,_=!1,m=null,d=null,M=null,S=null,x=null,P=null,T=null,C=new ct(0,0,0),I=0,b=!1,E=null,w=null,O=null,z=null,V=null,ce.set(0,0,i.canvas.width,i.canvas.height),ye.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:X,disable:de,bindFramebuffer:Ae,drawBuffers:xe,useProgram:Ke,setBlending:ue,setMaterial:Q,setFlipSided:se,setCullFace:fe,setLineWidth:Pe,setPolygonOffset:te,setScissorTest:ve,activeTexture:Ne,bindTexture:Ye,unbindTexture:L,compressedTexImage2D:y,compressedTexImage3D:H,texImage2D:Oe,texImage3D:ge,updateUBOMapping:$e,uniformBlockBinding:De,texStorage2D:Me,texStorage3D:Ve,texSubImage2D:re,texSubImage3D:pe,compressedTexSubImage2D:he,compressedTexSubImage3D:He,scissor:Ie,viewport:Ze,reset:it}}function iE(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Fe,u=new WeakMap,h,f=new WeakMap,p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,y){return p?new OffscreenCanvas(L,y):_a("canvas")}function _(L,y,H){let re=1,pe=Ye(L);if((pe.width>H||pe.height>H)&&(re=H/Math.max(pe.width,pe.height)),re<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let he=Math.floor(re*pe.width),He=Math.floor(re*pe.height);h===void 0&&(h=g(he,He));let Me=y?g(he,He):h;return Me.width=he,Me.height=He,Me.getContext("2d").drawImage(L,0,0,he,He),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+pe.width+"x"+pe.height+") to ("+he+"x"+He+")."),Me}else return"data"in L&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+pe.width+"x"+pe.height+")."),L;return L}function m(L){return L.generateMipmaps}function d(L){i.generateMipmap(L)}function M(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(L,y,H,re,pe=!1){if(L!==null){if(i[L]!==void 0)return i[L];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let he=y;if(y===i.RED&&(H===i.FLOAT&&(he=i.R32F),H===i.HALF_FLOAT&&(he=i.R16F),H===i.UNSIGNED_BYTE&&(he=i.R8)),y===i.RED_INTEGER&&(H===i.UNSIGNED_BYTE&&(he=i.R8UI),H===i.UNSIGNED_SHORT&&(he=i.R16UI),H===i.UNSIGNED_INT&&(he=i.R32UI),H===i.BYTE&&(he=i.R8I),H===i.SHORT&&(he=i.R16I),H===i.INT&&(he=i.R32I)),y===i.RG&&(H===i.FLOAT&&(he=i.RG32F),H===i.HALF_FLOAT&&(he=i.RG16F),H===i.UNSIGNED_BYTE&&(he=i.RG8)),y===i.RG_INTEGER&&(H===i.UNSIGNED_BYTE&&(he=i.RG8UI),H===i.UNSIGNED_SHORT&&(he=i.RG16UI),H===i.UNSIGNED_INT&&(he=i.RG32UI),H===i.BYTE&&(he=i.RG8I),H===i.SHORT&&(he=i.RG16I),H===i.INT&&(he=i.RG32I)),y===i.RGB_INTEGER&&(H===i.UNSIGNED_BYTE&&(he=i.RGB8UI),H===i.UNSIGNED_SHORT&&(he=i.RGB16UI),H===i.UNSIGNED_INT&&(he=i.RGB32UI),H===i.BYTE&&(he=i.RGB8I),H===i.SHORT&&(he=i.RGB16I),H===i.INT&&(he=i.RGB32I)),y===i.RGBA_INTEGER&&(H===i.UNSIGNED_BYTE&&(he=i.RGBA8UI),H===i.UNSIGNED_SHORT&&(he=i.RGBA16UI),H===i.UNSIGNED_INT&&(he=i.RGBA32UI),H===i.BYTE&&(he=i.RGBA8I),H===i.SHORT&&(he=i.RGBA16I),H===i.INT&&(he=i.RGBA32I)),y===i.RGB&&(H===i.UNSIGNED_INT_5_9_9_9_REV&&(he=i.RGB9_E5),H===i.UNSIGNED_INT_10F_11F_11F_REV&&(he=i.R11F_G11F_B10F)),y===i.RGBA){let He=pe?ma:vt.getTransfer(re);H===i.FLOAT&&(he=i.RGBA32F),H===i.HALF_FLOAT&&(he=i.RGBA16F),H===i.UNSIGNED_BYTE&&(he=He===Ct?i.SRGB8_ALPHA8:i.RGBA8),H===i.UNSIGNED_SHORT_4_4_4_4&&(he=i.RGBA4),H===i.UNSIGNED_SHORT_5_5_5_1&&(he=i.RGB5_A1)}return(he===i.R16F||he===i.R32F||he===i.RG16F||he===i.RG32F||he===i.RGBA16F||he===i.RGBA32F)&&e.get("EXT_color_buffer_float"),he}function x(L,y){let H;return L?y===null||y===Gs||y===Co?H=i.DEPTH24_STENCIL8:y===Qi?H=i.DEPTH32F_STENCIL8:y===Ao&&(H=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Gs||y===Co?H=i.DEPTH_COMPONENT24:y===Qi?H=i.DEPTH_COMPONENT32F:y===Ao&&(H=i.DEPTH_COMPONENT16),H}function P(L,y){return m(L)===!0||L.isFramebufferTexture&&L.minFilter!==mi&&L.minFilter!==Li?Math.log2(Math.max(y.width,y.height))+1:L.mipmaps!==void 0&&L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?y.mipmaps.length:1}function T(L){let y=L.target;y.removeEventListener("dispose",T),I(y),y.isVideoTexture&&u.delete(y)}function C(L){let y=L.target;y.removeEventListener("dispose",C),E(y)}function I(L){let y=n.get(L);if(y.__webglInit===void 0)return;let H=L.source,re=f.get(H);if(re){let pe=re[y.__cacheKey];pe.usedTimes--,pe.usedTimes===0&&b(L),Object.keys(re).length===0&&f.delete(H)}n.remove(L)}function b(L){let y=n.get(L);i.deleteTexture(y.__webglTexture);let H=L.source,re=f.get(H);delete re[y.__cacheKey],o.memory.textures--}function E(L){let y=n.get(L);if(L.depthTexture&&(L.depthTexture.dispose(),n.remove(L.depthTexture)),L.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(y.__webglFramebuffer[re]))for(let pe=0;pe<y.__webglFramebuffer[re].length;pe++)i.deleteFramebuffer(y.__webglFramebuffer[re][pe]);else i.deleteFramebuffer(y.__webglFramebuffer[re]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[re])}else{if(Array.isArray(y.__webglFramebuffer))for(let re=0;re<y.__webglFramebuffer.length;re++)i.deleteFramebuffer(y.__webglFramebuffer[re]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let re=0;re<y.__webglColorRenderbuffer.length;re++)y.__webglColorRenderbuffer[re]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[re]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let H=L.textures;for(let re=0,pe=H.length;re<pe;re++){let he=n.get(H[re]);he.__webglTexture&&(i.deleteTexture(he.__webglTexture),o.memory.textures--),n.remove(H[re])}n.remove(L)}let w=0;function O(){w=0}function z(){let L=w;return L>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+L+" texture units while this GPU supports only "+s.maxTextures),w+=1,L}function V(L){let y=[];return y.push(L.wrapS),y.push(L.wrapT),y.push(L.wrapR||0),y.push(L.magFilter),y.push(L.minFilter),y.push(L.anisotropy),y.push(L.internalFormat),y.push(L.format),y.push(L.type),y.push(L.generateMipmaps),y.push(L.premultiplyAlpha),y.push(L.flipY),y.push(L.unpackAlignment),y.push(L.colorSpace),y.join()}function W(L,y){let H=n.get(L);if(L.isVideoTexture&&ve(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&H.__version!==L.version){let re=L.image;if(re===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(re.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{j(H,L,y);return}}else L.isExternalTexture&&(H.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,H.__webglTexture,i.TEXTURE0+y)}function q(L,y){let H=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&H.__version!==L.version){j(H,L,y);return}t.bindTexture(i.TEXTURE_2D_ARRAY,H.__webglTexture,i.TEXTURE0+y)}function U(L,y){let H=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&H.__version!==L.version){j(H,L,y);return}t.bindTexture(i.TEXTURE_3D,H.__webglTexture,i.TEXTURE0+y)}function B(L,y){let H=n.get(L);if(L.version>0&&H.__version!==L.version){X(H,L,y);return}t.bindTexture(i.TEXTURE_CUBE_MAP,H.__webglTexture,i.TEXTURE0+y)}let K={[lc]:i.REPEAT,[Ns]:i.CLAMP_TO_EDGE,[cc]:i.MIRRORED_REPEAT},ne={[mi]:i.NEAREST,[n0]:i.NEAREST_MIPMAP_NEAREST,[Xa]:i.NEAREST_MIPMAP_LINEAR,[Li]:i.LINEAR,[$c]:i.LINEAR_MIPMAP_NEAREST,[Vs]:i.LINEAR_MIPMAP_LINEAR},ee={[o0]:i.NEVER,[f0]:i.ALWAYS,[a0]:i.LESS,[Zf]:i.LEQUAL,[l0]:i.EQUAL,[u0]:i.GEQUAL,[c0]:i.GREATER,[h0]:i.NOTEQUAL};function le(L,y){if(y.type===Qi&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===Li||y.magFilter===$c||y.magFilter===Xa||y.magFilter===Vs||y.minFilter===Li||y.minFilter===$c||y.minFilter===Xa||y.minFilter===Vs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,K[y.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,K[y.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,K[y.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,ne[y.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,ne[y.minFilter]),y.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,ee[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===mi||y.minFilter!==Xa&&y.minFilter!==Vs||y.type===Qi&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let H=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,H.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function ce(L,y){let H=!1;L.__webglInit===void 0&&(L.__webglInit=!0,y.addEventListener("dispose",T));let re=y.source,pe=f.get(re);pe===void 0&&(pe={},f.set(re,pe));let he=V(y);if(he!==L.__cacheKey){pe[he]===void 0&&(pe[he]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,H=!0),pe[he].usedTimes++;let He=pe[L.__cacheKey];He!==void 0&&(pe[L.__cacheKey].usedTimes--,He.usedTimes===0&&b(y)),L.__cacheKey=he,L.__webglTexture=pe[he].texture}return H}function ye(L,y,H){return Math.floor(Math.floor(L/H)/y)}function Re(L,y,H,re){let he=L.updateRanges;if(he.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,H,re,y.data);else{he.sort((ge,Ie)=>ge.start-Ie.start);let He=0;for(let ge=1;ge<he.length;ge++){let Ie=he[He],Ze=he[ge],$e=Ie.start+Ie.count,De=ye(Ze.start,y.width,4),it=ye(Ie.start,y.width,4);Ze.start<=$e+1&&De===it&&ye(Ze.start+Ze.count-1,y.width,4)===De?Ie.count=Math.max(Ie.count,Ze.start+Ze.count-Ie.start):(++He,he[He]=Ze)}he.length=He+1;let Me=i.getParameter(i.UNPACK_ROW_LENGTH),Ve=i.getParameter(i.UNPACK_SKIP_PIXELS),Oe=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let ge=0,Ie=he.length;ge<Ie;ge++){let Ze=he[ge],$e=Math.floor(Ze.start/4),De=Math.ceil(Ze.count/4),it=$e%y.width,Y=Math.floor($e/y.width),we=De,Te=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,it),i.pixelStorei(i.UNPACK_SKIP_ROWS,Y),t.texSubImage2D(i.TEXTURE_2D,0,it,Y,we,Te,H,re,y.data)}L.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,Me),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Ve),i.pixelStorei(i.UNPACK_SKIP_ROWS,Oe)}}function j(L,y,H){let re=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(re=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(re=i.TEXTURE_3D);let pe=ce(L,y),he=y.source;t.bindTexture(re,L.__webglTexture,i.TEXTURE0+H);let He=n.get(he);if(he.version!==He.__version||pe===!0){t.activeTexture(i.TEXTURE0+H);let Me=vt.getPrimaries(vt.workingColorSpace),Ve=y.colorSpace===ys?null:vt.getPrimaries(y.colorSpace),Oe=y.colorSpace===ys||Me===Ve?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Oe);let ge=_(y.image,!1,s.maxTextureSize);ge=Ne(y,ge);let Ie=r.convert(y.format,y.colorSpace),Ze=r.convert(y.type),$e=S(y.internalFormat,Ie,Ze,y.colorSpace,y.isVideoTexture);le(re,y);let De,it=y.mipmaps,Y=y.isVideoTexture!==!0,we=He.__version===void 0||pe===!0,Te=he.dataReady,Ge=P(y,ge);if(y.isDepthTexture)$e=x(y.format===Po,y.type),we&&(Y?t.texStorage2D(i.TEXTURE_2D,1,$e,ge.width,ge.height):t.texImage2D(i.TEXTURE_2D,0,$e,ge.width,ge.height,0,Ie,Ze,null));else if(y.isDataTexture)if(it.length>0){Y&&we&&t.texStorage2D(i.TEXTURE_2D,Ge,$e,it[0].width,it[0].height);for(let Se=0,_e=it.length;Se<_e;Se++)De=it[Se],Y?Te&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,De.width,De.height,Ie,Ze,De.data):t.texImage2D(i.TEXTURE_2D,Se,$e,De.width,De.height,0,Ie,Ze,De.data);y.generateMipmaps=!1}else Y?(we&&t.texStorage2D(i.TEXTURE_2D,Ge,$e,ge.width,ge.height),Te&&Re(y,ge,Ie,Ze)):t.texImage2D(i.TEXTURE_2D,0,$e,ge.width,ge.height,0,Ie,Ze,ge.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){Y&&we&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ge,$e,it[0].width,it[0].height,ge.depth);for(let Se=0,_e=it.length;Se<_e;Se++)if(De=it[Se],y.format!==gi)if(Ie!==null)if(Y){if(Te)if(y.layerUpdates.size>0){let qe=id(De.width,De.height,y.format,y.type);for(let rt of y.layerUpdates){let It=De.data.subarray(rt*qe/De.data.BYTES_PER_ELEMENT,(rt+1)*qe/De.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,rt,De.width,De.height,1,Ie,It)}y.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,0,De.width,De.height,ge.depth,Ie,De.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,Se,$e,De.width,De.height,ge.depth,0,De.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Y?Te&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,Se,0,0,0,De.width,De.height,ge.depth,Ie,Ze,De.data):t.texImage3D(i.TEXTURE_2D_ARRAY,Se,$e,De.width,De.height,ge.depth,0,Ie,Ze,De.data)}else{Y&&we&&t.texStorage2D(i.TEXTURE_2D,Ge,$e,it[0].width,it[0].height);for(let Se=0,_e=it.length;Se<_e;Se++)De=it[Se],y.format!==gi?Ie!==null?Y?Te&&t.compressedTexSubImage2D(i.TEXTURE_2D,Se,0,0,De.width,De.height,Ie,De.data):t.compressedTexImage2D(i.TEXTURE_2D,Se,$e,De.width,De.height,0,De.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Y?Te&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,De.width,De.height,Ie,Ze,De.data):t.texImage2D(i.TEXTURE_2D,Se,$e,De.width,De.height,0,Ie,Ze,De.data)}else if(y.isDataArrayTexture)if(Y){if(we&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ge,$e,ge.width,ge.height,ge.depth),Te)if(y.layerUpdates.size>0){let Se=id(ge.width,ge.height,y.format,y.type);for(let _e of y.layerUpdates){let qe=ge.data.subarray(_e*Se/ge.data.BYTES_PER_ELEMENT,(_e+1)*Se/ge.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,_e,ge.width,ge.height,1,Ie,Ze,qe)}y.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ge.width,ge.height,ge.depth,Ie,Ze,ge.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,$e,ge.width,ge.height,ge.depth,0,Ie,Ze,ge.data);else if(y.isData3DTexture)Y?(we&&t.texStorage3D(i.TEXTURE_3D,Ge,$e,ge.width,ge.height,ge.depth),Te&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ge.width,ge.height,ge.depth,Ie,Ze,ge.data)):t.texImage3D(i.TEXTURE_3D,0,$e,ge.width,ge.height,ge.depth,0,Ie,Ze,ge.data);else if(y.isFramebufferTexture){if(we)if(Y)t.texStorage2D(i.TEXTURE_2D,Ge,$e,ge.width,ge.height);else{let Se=ge.width,_e=ge.height;for(let qe=0;qe<Ge;qe++)t.texImage2D(i.TEXTURE_2D,qe,$e,Se,_e,0,Ie,Ze,null),Se>>=1,_e>>=1}}else if(it.length>0){if(Y&&we){let Se=Ye(it[0]);t.texStorage2D(i.TEXTURE_2D,Ge,$e,Se.width,Se.height)}for(let Se=0,_e=it.length;Se<_e;Se++)De=it[Se],Y?Te&&t.texSubImage2D(i.TEXTURE_2D,Se,0,0,Ie,Ze,De):t.texImage2D(i.TEXTURE_2D,Se,$e,Ie,Ze,De);y.generateMipmaps=!1}else if(Y){if(we){let Se=Ye(ge);t.texStorage2D(i.TEXTURE_2D,Ge,$e,Se.width,Se.height)}Te&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Ie,Ze,ge)}else t.texImage2D(i.TEXTURE_2D,0,$e,Ie,Ze,ge);m(y)&&d(re),He.__version=he.version,y.onUpdate&&y.onUpdate(y)}L.__version=y.version}function X(L,y,H){if(y.image.length!==6)return;let re=ce(L,y),pe=y.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+H);let he=n.get(pe);if(pe.version!==he.__version||re===!0){t.activeTexture(i.TEXTURE0+H);let He=vt.getPrimaries(vt.workingColorSpace),Me=y.colorSpace===ys?null:vt.getPrimaries(y.colorSpace),Ve=y.colorSpace===ys||He===Me?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ve);let Oe=y.isCompressedTexture||y.image[0].isCompressedTexture,ge=y.image[0]&&y.image[0].isDataTexture,Ie=[];for(let _e=0;_e<6;_e++)!Oe&&!ge?Ie[_e]=_(y.image[_e],!0,s.maxCubemapSize):Ie[_e]=ge?y.image[_e].image:y.image[_e],Ie[_e]=Ne(y,Ie[_e]);let Ze=Ie[0],$e=r.convert(y.format,y.colorSpace),De=r.convert(y.type),it=S(y.internalFormat,$e,De,y.colorSpace),Y=y.isVideoTexture!==!0,we=he.__version===void 0||re===!0,Te=pe.dataReady,Ge=P(y,Ze);le(i.TEXTURE_CUBE_MAP,y);let Se;if(Oe){Y&&we&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,it,Ze.width,Ze.height);for(let _e=0;_e<6;_e++){Se=Ie[_e].mipmaps;for(let qe=0;qe<Se.length;qe++){let rt=Se[qe];y.format!==gi?$e!==null?Y?Te&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,qe,0,0,rt.width,rt.height,$e,rt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,qe,it,rt.width,rt.height,0,rt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Y?Te&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,qe,0,0,rt.width,rt.height,$e,De,rt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,qe,it,rt.width,rt.height,0,$e,De,rt.data)}}}else{if(Se=y.mipmaps,Y&&we){Se.length>0&&Ge++;let _e=Ye(Ie[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,it,_e.width,_e.height)}for(let _e=0;_e<6;_e++)if(ge){Y?Te&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,0,0,Ie[_e].width,Ie[_e].height,$e,De,Ie[_e].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,it,Ie[_e].width,Ie[_e].height,0,$e,De,Ie[_e].data);for(let qe=0;qe<Se.length;qe++){let It=Se[qe].image[_e].image;Y?Te&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,qe+1,0,0,It.width,It.height,$e,De,It.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,qe+1,it,It.width,It.height,0,$e,De,It.data)}}else{Y?Te&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,0,0,$e,De,Ie[_e]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,it,$e,De,Ie[_e]);for(let qe=0;qe<Se.length;qe++){let rt=Se[qe];Y?Te&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,qe+1,0,0,$e,De,rt.image[_e]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_e,qe+1,it,$e,De,rt.image[_e])}}}m(y)&&d(i.TEXTURE_CUBE_MAP),he.__version=pe.version,y.onUpdate&&y.onUpdate(y)}L.__version=y.version}function de(L,y,H,re,pe,he){let He=r.convert(H.format,H.colorSpace),Me=r.convert(H.type),Ve=S(H.internalFormat,He,Me,H.colorSpace),Oe=n.get(y),ge=n.get(H);if(ge.__renderTarget=y,!Oe.__hasExternalTextures){let Ie=Math.max(1,y.width>>he),Ze=Math.max(1,y.height>>he);pe===i.TEXTURE_3D||pe===i.TEXTURE_2D_ARRAY?t.texImage3D(pe,he,Ve,Ie,Ze,y.depth,0,He,Me,null):t.texImage2D(pe,he,Ve,Ie,Ze,0,He,Me,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),te(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,re,pe,ge.__webglTexture,0,Pe(y)):(pe===i.TEXTURE_2D||pe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&pe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,re,pe,ge.__webglTexture,he),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Ae(L,y,H){if(i.bindRenderbuffer(i.RENDERBUFFER,L),y.depthBuffer){let re=y.depthTexture,pe=re&&re.isDepthTexture?re.type:null,he=x(y.stencilBuffer,pe),He=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=Pe(y);te(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Me,he,y.width,y.height):H?i.renderbufferStorageMultisample(i.RENDERBUFFER,Me,he,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,he,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,He,i.RENDERBUFFER,L)}else{let re=y.textures;for(let pe=0;pe<re.length;pe++){let he=re[pe],He=r.convert(he.format,he.colorSpace),Me=r.convert(he.type),Ve=S(he.internalFormat,He,Me,he.colorSpace),Oe=Pe(y);H&&te(y)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Oe,Ve,y.width,y.height):te(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Oe,Ve,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,Ve,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(L,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let re=n.get(y.depthTexture);re.__renderTarget=y,(!re.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),W(y.depthTexture,0);let pe=re.__webglTexture,he=Pe(y);if(y.depthTexture.format===go)te(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,pe,0,he):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,pe,0);else if(y.depthTexture.format===Po)te(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,pe,0,he):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,pe,0);else throw new Error("Unknown depthTexture format")}function Ke(L){let y=n.get(L),H=L.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==L.depthTexture){let re=L.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),re){let pe=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,re.removeEventListener("dispose",pe)};re.addEventListener("dispose",pe),y.__depthDisposeCallback=pe}y.__boundDepthTexture=re}if(L.depthTexture&&!y.__autoAllocateDepthBuffer){if(H)throw new Error("target.depthTexture not supported in Cube render targets");let re=L.texture.mipmaps;re&&re.length>0?xe(y.__webglFramebuffer[0],L):xe(y.__webglFramebuffer,L)}else if(H){y.__webglDepthbuffer=[];for(let re=0;re<6;re++)if(t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[re]),y.__webglDepthbuffer[re]===void 0)y.__webglDepthbuffer[re]=i.createRenderbuffer(),Ae(y.__webglDepthbuffer[re],L,!1);else{let pe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,he=y.__webglDepthbuffer[re];i.bindRenderbuffer(i.RENDERBUFFER,he),i.framebufferRenderbuffer(i.FRAMEBUFFER,pe,i.RENDERBUFFER,he)}}else{let re=L.texture.mipmaps;if(re&&re.length>0?t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),Ae(y.__webglDepthbuffer,L,!1);else{let pe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,he=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,he),i.framebufferRenderbuffer(i.FRAMEBUFFER,pe,i.RENDERBUFFER,he)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function mt(L,y,H){let re=n.get(L);y!==void 0&&de(re.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),H!==void 0&&Ke(L)}function k(L){let y=L.texture,H=n.get(L),re=n.get(y);L.addEventListener("dispose",C);let pe=L.textures,he=L.isWebGLCubeRenderTarget===!0,He=pe.length>1;if(He||(re.__webglTexture===void 0&&(re.__webglTexture=i.createTexture()),re.__version=y.version,o.memory.textures++),he){H.__webglFramebuffer=[];for(let Me=0;Me<6;Me++)if(y.mipmaps&&y.mipmaps.length>0){H.__webglFramebuffer[Me]=[];for(let Ve=0;Ve<y.mipmaps.length;Ve++)H.__webglFramebuffer[Me][Ve]=i.createFramebuffer()}else H.__webglFramebuffer[Me]=i.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){H.__webglFramebuffer=[];for(let Me=0;Me<y.mipmaps.length;Me++)H.__webglFramebuffer[Me]=i.createFramebuffer()}else H.__webglFramebuffer=i.createFramebuffer();if(He)for(let Me=0,Ve=pe.length;Me<Ve;Me++){let Oe=n.get(pe[Me]);Oe.__webglTexture===void 0&&(Oe.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&te(L)===!1){H.__webglMultisampledFramebuffer=i.createFramebuffer(),H.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,H.__webglMultisampledFramebuffer);for(let Me=0;Me<pe.length;Me++){let Ve=pe[Me];H.__webglColorRenderbuffer[Me]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,H.__webglColorRenderbuffer[Me]);let Oe=r.convert(Ve.format,Ve.colorSpace),ge=r.convert(Ve.type),Ie=S(Ve.internalFormat,Oe,ge,Ve.colorSpace,L.isXRRenderTarget===!0),Ze=Pe(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,Ze,Ie,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Me,i.RENDERBUFFER,H.__webglColorRenderbuffer[Me])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(H.__webglDepthRenderbuffer=i.createRenderbuffer(),Ae(H.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(he){t.bindTexture(i.TEXTURE_CUBE_MAP,re.__webglTexture),le(i.TEXTURE_CUBE_MAP,y);for(let Me=0;Me<6;Me++)if(y.mipmaps&&y.mipmaps.length>0)for(let Ve=0;Ve<y.mipmaps.length;Ve++)de(H.__webglFramebuffer[Me][Ve],L,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Ve);else de(H.__webglFramebuffer[Me],L,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0);m(y)&&d(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(He){for(let Me=0,Ve=pe.length;Me<Ve;Me++){let Oe=pe[Me],ge=n.get(Oe),Ie=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(Ie=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Ie,ge.__webglTexture),le(Ie,Oe),de(H.__webglFramebuffer,L,Oe,i.COLOR_ATTACHMENT0+Me,Ie,0),m(Oe)&&d(Ie)}t.unbindTexture()}else{let Me=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(Me=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Me,re.__webglTexture),le(Me,y),y.mipmaps&&y.mipmaps.length>0)for(let Ve=0;Ve<y.mipmaps.length;Ve++)de(H.__webglFramebuffer[Ve],L,y,i.COLOR_ATTACHMENT0,Me,Ve);else de(H.__webglFramebuffer,L,y,i.COLOR_ATTACHMENT0,Me,0);m(y)&&d(Me),t.unbindTexture()}L.depthBuffer&&Ke(L)}function ue(L){let y=L.textures;for(let H=0,re=y.length;H<re;H++){let pe=y[H];if(m(pe)){let he=M(L),He=n.get(pe).__webglTexture;t.bindTexture(he,He),d(he),t.unbindTexture()}}}let Q=[],se=[];function fe(L){if(L.samples>0){if(te(L)===!1){let y=L.textures,H=L.width,re=L.height,pe=i.COLOR_BUFFER_BIT,he=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,He=n.get(L),Me=y.length>1;if(Me)for(let Oe=0;Oe<y.length;Oe++)t.bindFramebuffer(i.FRAMEBUFFER,He.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Oe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,He.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Oe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,He.__webglMultisampledFramebuffer);let Ve=L.texture.mipmaps;Ve&&Ve.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,He.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,He.__webglFramebuffer);for(let Oe=0;Oe<y.length;Oe++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(pe|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(pe|=i.STENCIL_BUFFER_BIT)),Me){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,He.__webglColorRenderbuffer[Oe]);let ge=n.get(y[Oe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,ge,0)}i.blitFramebuffer(0,0,H,re,0,0,H,re,pe,i.NEAREST),l===!0&&(Q.length=0,se.length=0,Q.push(i.COLOR_ATTACHMENT0+Oe),L.depthBuffer&&L.resolveDepthBuffer===!1&&(Q.push(he),se.push(he),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,se)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Q))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Me)for(let Oe=0;Oe<y.length;Oe++){t.bindFramebuffer(i.FRAMEBUFFER,He.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Oe,i.RENDERBUFFER,He.__webglColorRenderbuffer[Oe]);let ge=n.get(y[Oe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,He.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Oe,i.TEXTURE_2D,ge,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,He.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.resolveDepthBuffer===!1&&l){let y=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function Pe(L){return Math.min(s.maxSamples,L.samples)}function te(L){let y=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function ve(L){let y=o.render.frame;u.get(L)!==y&&(u.set(L,y),L.update())}function Ne(L,y){let H=L.colorSpace,re=L.format,pe=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||H!==fr&&H!==ys&&(vt.getTransfer(H)===Ct?(re!==gi||pe!==Fi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",H)),y}function Ye(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=z,this.resetTextureUnits=O,this.setTexture2D=W,this.setTexture2DArray=q,this.setTexture3D=U,this.setTextureCube=B,this.rebindTextures=mt,this.setupRenderTarget=k,this.updateRenderTargetMipmap=ue,this.updateMultisampleRenderTarget=fe,this.setupDepthRenderbuffer=Ke,this.setupFrameBufferTexture=de,this.useMultisampledRTT=te}function sE(i,e){function t(n,s=ys){let r,o=vt.getTransfer(s);if(n===Fi)return i.UNSIGNED_BYTE;if(n===Kc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Jc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Vf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Gf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===kf)return i.BYTE;if(n===Hf)return i.SHORT;if(n===Ao)return i.UNSIGNED_SHORT;if(n===Zc)return i.INT;if(n===Gs)return i.UNSIGNED_INT;if(n===Qi)return i.FLOAT;if(n===Ro)return i.HALF_FLOAT;if(n===Wf)return i.ALPHA;if(n===Xf)return i.RGB;if(n===gi)return i.RGBA;if(n===go)return i.DEPTH_COMPONENT;if(n===Po)return i.DEPTH_STENCIL;if(n===qf)return i.RED;if(n===jc)return i.RED_INTEGER;if(n===Yf)return i.RG;if(n===Qc)return i.RG_INTEGER;if(n===eh)return i.RGBA_INTEGER;if(n===qa||n===Ya||n===$a||n===Za)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===qa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===qa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===$a)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Za)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===th||n===nh||n===ih||n===sh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===th)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===nh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ih)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===sh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===rh||n===oh||n===ah)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===rh||n===oh)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===ah)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===lh||n===ch||n===hh||n===uh||n===fh||n===dh||n===ph||n===mh||n===gh||n===_h||n===vh||n===xh||n===yh||n===bh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===lh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ch)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===hh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===uh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===fh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===dh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===ph)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===mh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===gh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===_h)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===vh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===xh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===yh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===bh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Mh||n===Sh||n===wh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Mh)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Sh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===wh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Eh||n===Th||n===Ah||n===Rh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Eh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Th)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ah)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Co?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var rE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,oE=`
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

}`,gd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Aa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ri({vertexShader:rE,fragmentShader:oE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ut(new Ia(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},_d=class extends Yi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,g=null,_=typeof XRWebGLBinding<"u",m=new gd,d={},M=t.getContextAttributes(),S=null,x=null,P=[],T=[],C=new Fe,I=null,b=new An;b.viewport=new Pt;let E=new An;E.viewport=new Pt;let w=[b,E],O=new Bc,z=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let X=P[j];return X===void 0&&(X=new yo,P[j]=X),X.getTargetRaySpace()},this.getControllerGrip=function(j){let X=P[j];return X===void 0&&(X=new yo,P[j]=X),X.getGripSpace()},this.getHand=function(j){let X=P[j];return X===void 0&&(X=new yo,P[j]=X),X.getHandSpace()};function W(j){let X=T.indexOf(j.inputSource);if(X===-1)return;let de=P[X];de!==void 0&&(de.update(j.inputSource,j.frame,c||o),de.dispatchEvent({type:j.type,data:j.inputSource}))}function q(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",U);for(let j=0;j<P.length;j++){let X=T[j];X!==null&&(T[j]=null,P[j].disconnect(X))}z=null,V=null,m.reset();for(let j in d)delete d[j];e.setRenderTarget(S),p=null,f=null,h=null,s=null,x=null,Re.stop(),n.isPresenting=!1,e.setPixelRatio(I),e.setSize(C.width,C.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){a=j,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(S=e.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",q),s.addEventListener("inputsourceschange",U),M.xrCompatible!==!0&&await t.makeXRCompatible(),I=e.getPixelRatio(),e.getSize(C),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let de=null,Ae=null,xe=null;M.depth&&(xe=M.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,de=M.stencil?Po:go,Ae=M.stencil?Co:Gs);let Ke={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Ke),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),x=new $i(f.textureWidth,f.textureHeight,{format:gi,type:Fi,depthTexture:new Ta(f.textureWidth,f.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,de),stencilBuffer:M.stencil,colorSpace:e.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let de={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,de),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),x=new $i(p.framebufferWidth,p.framebufferHeight,{format:gi,type:Fi,colorSpace:e.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Re.setContext(s),Re.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function U(j){for(let X=0;X<j.removed.length;X++){let de=j.removed[X],Ae=T.indexOf(de);Ae>=0&&(T[Ae]=null,P[Ae].disconnect(de))}for(let X=0;X<j.added.length;X++){let de=j.added[X],Ae=T.indexOf(de);if(Ae===-1){for(let Ke=0;Ke<P.length;Ke++)if(Ke>=T.length){T.push(de),Ae=Ke;break}else if(T[Ke]===null){T[Ke]=de,Ae=Ke;break}if(Ae===-1)break}let xe=P[Ae];xe&&xe.connect(de)}}let B=new N,K=new N;function ne(j,X,de){B.setFromMatrixPosition(X.matrixWorld),K.setFromMatrixPosition(de.matrixWorld);let Ae=B.distanceTo(K),xe=X.projectionMatrix.elements,Ke=de.projectionMatrix.elements,mt=xe[14]/(xe[10]-1),k=xe[14]/(xe[10]+1),ue=(xe[9]+1)/xe[5],Q=(xe[9]-1)/xe[5],se=(xe[8]-1)/xe[0],fe=(Ke[8]+1)/Ke[0],Pe=mt*se,te=mt*fe,ve=Ae/(-se+fe),Ne=ve*-se;if(X.matrixWorld.decompose(j.position,j.quaternion,j.scale),j.translateX(Ne),j.translateZ(ve),j.matrixWorld.compose(j.position,j.quaternion,j.scale),j.matrixWorldInverse.copy(j.matrixWorld).invert(),xe[10]===-1)j.projectionMatrix.copy(X.projectionMatrix),j.projectionMatrixInverse.copy(X.projectionMatrixInverse);else{let Ye=mt+ve,L=k+ve,y=Pe-Ne,H=te+(Ae-Ne),re=ue*k/L*Ye,pe=Q*k/L*Ye;j.projectionMatrix.makePerspective(y,H,re,pe,Ye,L),j.projectionMatrixInverse.copy(j.projectionMatrix).invert()}}function ee(j,X){X===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(X.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let X=j.near,de=j.far;m.texture!==null&&(m.depthNear>0&&(X=m.depthNear),m.depthFar>0&&(de=m.depthFar)),O.near=E.near=b.near=X,O.far=E.far=b.far=de,(z!==O.near||V!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),z=O.near,V=O.far),O.layers.mask=j.layers.mask|6,b.layers.mask=O.layers.mask&3,E.layers.mask=O.layers.mask&5;let Ae=j.parent,xe=O.cameras;ee(O,Ae);for(let Ke=0;Ke<xe.length;Ke++)ee(xe[Ke],Ae);xe.length===2?ne(O,b,E):O.projectionMatrix.copy(b.projectionMatrix),le(j,O,Ae)};function le(j,X,de){de===null?j.matrix.copy(X.matrixWorld):(j.matrix.copy(de.matrixWorld),j.matrix.invert(),j.matrix.multiply(X.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(X.projectionMatrix),j.projectionMatrixInverse.copy(X.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=_o*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(j){l=j,f!==null&&(f.fixedFoveation=j),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=j)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(O)},this.getCameraTexture=function(j){return d[j]};let ce=null;function ye(j,X){if(u=X.getViewerPose(c||o),g=X,u!==null){let de=u.views;p!==null&&(e.setRenderTargetFramebuffer(x,p.framebuffer),e.setRenderTarget(x));let Ae=!1;de.length!==O.cameras.length&&(O.cameras.length=0,Ae=!0);for(let k=0;k<de.length;k++){let ue=de[k],Q=null;if(p!==null)Q=p.getViewport(ue);else{let fe=h.getViewSubImage(f,ue);Q=fe.viewport,k===0&&(e.setRenderTargetTextures(x,fe.colorTexture,fe.depthStencilTexture),e.setRenderTarget(x))}let se=w[k];se===void 0&&(se=new An,se.layers.enable(k),se.viewport=new Pt,w[k]=se),se.matrix.fromArray(ue.transform.matrix),se.matrix.decompose(se.position,se.quaternion,se.scale),se.projectionMatrix.fromArray(ue.projectionMatrix),se.projectionMatrixInverse.copy(se.projectionMatrix).invert(),se.viewport.set(Q.x,Q.y,Q.width,Q.height),k===0&&(O.matrix.copy(se.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),Ae===!0&&O.cameras.push(se)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=n.getBinding();let k=h.getDepthInformation(de[0]);k&&k.isValid&&k.texture&&m.init(k,s.renderState)}if(xe&&xe.includes("camera-access")&&_){e.state.unbindTexture(),h=n.getBinding();for(let k=0;k<de.length;k++){let ue=de[k].camera;if(ue){let Q=d[ue];Q||(Q=new Aa,d[ue]=Q);let se=h.getCameraImage(ue);Q.sourceTexture=se}}}}for(let de=0;de<P.length;de++){let Ae=T[de],xe=P[de];Ae!==null&&xe!==void 0&&xe.update(Ae,X,c||o)}ce&&ce(j,X),X.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:X}),g=null}let Re=new H0;Re.setAnimationLoop(ye),this.setAnimationLoop=function(j){ce=j},this.dispose=function(){}}},Sr=new Ui,aE=new Dt;function lE(i,e){function t(m,d){m.matrixAutoUpdate===!0&&m.updateMatrix(),d.value.copy(m.matrix)}function n(m,d){d.color.getRGB(m.fogColor.value,Qf(i)),d.isFog?(m.fogNear.value=d.near,m.fogFar.value=d.far):d.isFogExp2&&(m.fogDensity.value=d.density)}function s(m,d,M,S,x){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(m,d):d.isMeshToonMaterial?(r(m,d),h(m,d)):d.isMeshPhongMaterial?(r(m,d),u(m,d)):d.isMeshStandardMaterial?(r(m,d),f(m,d),d.isMeshPhysicalMaterial&&p(m,d,x)):d.isMeshMatcapMaterial?(r(m,d),g(m,d)):d.isMeshDepthMaterial?r(m,d):d.isMeshDistanceMaterial?(r(m,d),_(m,d)):d.isMeshNormalMaterial?r(m,d):d.isLineBasicMaterial?(o(m,d),d.isLineDashedMaterial&&a(m,d)):d.isPointsMaterial?l(m,d,M,S):d.isSpriteMaterial?c(m,d):d.isShadowMaterial?(m.color.value.copy(d.color),m.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(m,d){m.opacity.value=d.opacity,d.color&&m.diffuse.value.copy(d.color),d.emissive&&m.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(m.map.value=d.map,t(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.bumpMap&&(m.bumpMap.value=d.bumpMap,t(d.bumpMap,m.bumpMapTransform),m.bumpScale.value=d.bumpScale,d.side===zn&&(m.bumpScale.value*=-1)),d.normalMap&&(m.normalMap.value=d.normalMap,t(d.normalMap,m.normalMapTransform),m.normalScale.value.copy(d.normalScale),d.side===zn&&m.normalScale.value.negate()),d.displacementMap&&(m.displacementMap.value=d.displacementMap,t(d.displacementMap,m.displacementMapTransform),m.displacementScale.value=d.displacementScale,m.displacementBias.value=d.displacementBias),d.emissiveMap&&(m.emissiveMap.value=d.emissiveMap,t(d.emissiveMap,m.emissiveMapTransform)),d.specularMap&&(m.specularMap.value=d.specularMap,t(d.specularMap,m.specularMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest);let M=e.get(d),S=M.envMap,x=M.envMapRotation;S&&(m.envMap.value=S,Sr.copy(x),Sr.x*=-1,Sr.y*=-1,Sr.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(Sr.y*=-1,Sr.z*=-1),m.envMapRotation.value.setFromMatrix4(aE.makeRotationFromEuler(Sr)),m.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=d.reflectivity,m.ior.value=d.ior,m.refractionRatio.value=d.refractionRatio),d.lightMap&&(m.lightMap.value=d.lightMap,m.lightMapIntensity.value=d.lightMapIntensity,t(d.lightMap,m.lightMapTransform)),d.aoMap&&(m.aoMap.value=d.aoMap,m.aoMapIntensity.value=d.aoMapIntensity,t(d.aoMap,m.aoMapTransform))}function o(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,d.map&&(m.map.value=d.map,t(d.map,m.mapTransform))}function a(m,d){m.dashSize.value=d.dashSize,m.totalSize.value=d.dashSize+d.gapSize,m.scale.value=d.scale}function l(m,d,M,S){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.size.value=d.size*M,m.scale.value=S*.5,d.map&&(m.map.value=d.map,t(d.map,m.uvTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function c(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.rotation.value=d.rotation,d.map&&(m.map.value=d.map,t(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,t(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function u(m,d){m.specular.value.copy(d.specular),m.shininess.value=Math.max(d.shininess,1e-4)}function h(m,d){d.gradientMap&&(m.gradientMap.value=d.gradientMap)}function f(m,d){m.metalness.value=d.metalness,d.metalnessMap&&(m.metalnessMap.value=d.metalnessMap,t(d.metalnessMap,m.metalnessMapTransform)),m.roughness.value=d.roughness,d.roughnessMap&&(m.roughnessMap.value=d.roughnessMap,t(d.roughnessMap,m.roughnessMapTransform)),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)}function p(m,d,M){m.ior.value=d.ior,d.sheen>0&&(m.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),m.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(m.sheenColorMap.value=d.sheenColorMap,t(d.sheenColorMap,m.sheenColorMapTransform)),d.sheenRoughnessMap&&(m.sheenRoughnessMap.value=d.sheenRoughnessMap,t(d.sheenRoughnessMap,m.sheenRoughnessMapTransform))),d.clearcoat>0&&(m.clearcoat.value=d.clearcoat,m.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(m.clearcoatMap.value=d.clearcoatMap,t(d.clearcoatMap,m.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,t(d.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(m.clearcoatNormalMap.value=d.clearcoatNormalMap,t(d.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===zn&&m.clearcoatNormalScale.value.negate())),d.dispersion>0&&(m.dispersion.value=d.dispersion),d.iridescence>0&&(m.iridescence.value=d.iridescence,m.iridescenceIOR.value=d.iridescenceIOR,m.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(m.iridescenceMap.value=d.iridescenceMap,t(d.iridescenceMap,m.iridescenceMapTransform)),d.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=d.iridescenceThicknessMap,t(d.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),d.transmission>0&&(m.transmission.value=d.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),d.transmissionMap&&(m.transmissionMap.value=d.transmissionMap,t(d.transmissionMap,m.transmissionMapTransform)),m.thickness.value=d.thickness,d.thicknessMap&&(m.thicknessMap.value=d.thicknessMap,t(d.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=d.attenuationDistance,m.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(m.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(m.anisotropyMap.value=d.anisotropyMap,t(d.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=d.specularIntensity,m.specularColor.value.copy(d.specularColor),d.specularColorMap&&(m.specularColorMap.value=d.specularColorMap,t(d.specularColorMap,m.specularColorMapTransform)),d.specularIntensityMap&&(m.specularIntensityMap.value=d.specularIntensityMap,t(d.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,d){d.matcap&&(m.matcap.value=d.matcap)}function _(m,d){let M=e.get(d).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function cE(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(M,S){let x=S.program;n.uniformBlockBinding(M,x)}function c(M,S){let x=s[M.id];x===void 0&&(g(M),x=u(M),s[M.id]=x,M.addEventListener("dispose",m));let P=S.program;n.updateUBOMapping(M,P);let T=e.render.frame;r[M.id]!==T&&(f(M),r[M.id]=T)}function u(M){let S=h();M.__bindingPointIndex=S;let x=i.createBuffer(),P=M.__size,T=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,x),i.bufferData(i.UNIFORM_BUFFER,P,T),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,x),x}function h(){for(let M=0;M<a;M++)if(o.indexOf(M)===-1)return o.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(M){let S=s[M.id],x=M.uniforms,P=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let T=0,C=x.length;T<C;T++){let I=Array.isArray(x[T])?x[T]:[x[T]];for(let b=0,E=I.length;b<E;b++){let w=I[b];if(p(w,T,b,P)===!0){let O=w.__offset,z=Array.isArray(w.value)?w.value:[w.value],V=0;for(let W=0;W<z.length;W++){let q=z[W],U=_(q);typeof q=="number"||typeof q=="boolean"?(w.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,O+V,w.__data)):q.isMatrix3?(w.__data[0]=q.elements[0],w.__data[1]=q.elements[1],w.__data[2]=q.elements[2],w.__data[3]=0,w.__data[4]=q.elements[3],w.__data[5]=q.elements[4],w.__data[6]=q.elements[5],w.__data[7]=0,w.__data[8]=q.elements[6],w.__data[9]=q.elements[7],w.__data[10]=q.elements[8],w.__data[11]=0):(q.toArray(w.__data,V),V+=U.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,O,w.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(M,S,x,P){let T=M.value,C=S+"_"+x;if(P[C]===void 0)return typeof T=="number"||typeof T=="boolean"?P[C]=T:P[C]=T.clone(),!0;{let I=P[C];if(typeof T=="number"||typeof T=="boolean"){if(I!==T)return P[C]=T,!0}else if(I.equals(T)===!1)return I.copy(T),!0}return!1}function g(M){let S=M.uniforms,x=0,P=16;for(let C=0,I=S.length;C<I;C++){let b=Array.isArray(S[C])?S[C]:[S[C]];for(let E=0,w=b.length;E<w;E++){let O=b[E],z=Array.isArray(O.value)?O.value:[O.value];for(let V=0,W=z.length;V<W;V++){let q=z[V],U=_(q),B=x%P,K=B%U.boundary,ne=B+K;x+=K,ne!==0&&P-ne<U.storage&&(x+=P-ne),O.__data=new Float32Array(U.storage/Float32Array.BYTES_PER_ELEMENT),O.__offset=x,x+=U.storage}}}let T=x%P;return T>0&&(x+=P-T),M.__size=x,M.__cache={},this}function _(M){let S={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(S.boundary=4,S.storage=4):M.isVector2?(S.boundary=8,S.storage=8):M.isVector3||M.isColor?(S.boundary=16,S.storage=12):M.isVector4?(S.boundary=16,S.storage=16):M.isMatrix3?(S.boundary=48,S.storage=48):M.isMatrix4?(S.boundary=64,S.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),S}function m(M){let S=M.target;S.removeEventListener("dispose",m);let x=o.indexOf(S.__bindingPointIndex);o.splice(x,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function d(){for(let M in s)i.deleteBuffer(s[M]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var Dh=class{constructor(e={}){let{canvas:t=d0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let g=new Uint32Array(4),_=new Int32Array(4),m=null,d=null,M=[],S=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=xs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let x=this,P=!1;this._outputColorSpace=Bn;let T=0,C=0,I=null,b=-1,E=null,w=new Pt,O=new Pt,z=null,V=new ct(0),W=0,q=t.width,U=t.height,B=1,K=null,ne=null,ee=new Pt(0,0,q,U),le=new Pt(0,0,q,U),ce=!1,ye=new wo,Re=!1,j=!1,X=new Dt,de=new N,Ae=new Pt,xe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ke=!1;function mt(){return I===null?B:1}let k=n;function ue(R,Z){return t.getContext(R,Z)}try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"180"}`),t.addEventListener("webglcontextlost",Te,!1),t.addEventListener("webglcontextrestored",Ge,!1),t.addEventListener("webglcontextcreationerror",Se,!1),k===null){let Z="webgl2";if(k=ue(Z,R),k===null)throw ue(Z)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(R){throw console.error("THREE.WebGLRenderer: "+R.message),R}let Q,se,fe,Pe,te,ve,Ne,Ye,L,y,H,re,pe,he,He,Me,Ve,Oe,ge,Ie,Ze,$e,De,it;function Y(){Q=new Aw(k),Q.init(),$e=new sE(k,Q),se=new yw(k,Q,e,$e),fe=new nE(k,Q),se.reversedDepthBuffer&&f&&fe.buffers.depth.setReversed(!0),Pe=new Pw(k),te=new G1,ve=new iE(k,Q,fe,te,se,$e,Pe),Ne=new Mw(x),Ye=new Tw(x),L=new Fb(k),De=new vw(k,L),y=new Rw(k,L,Pe,De),H=new Lw(k,y,L,Pe),ge=new Iw(k,se,ve),Me=new bw(te),re=new V1(x,Ne,Ye,Q,se,De,Me),pe=new lE(x,te),he=new X1,He=new J1(Q),Oe=new _w(x,Ne,Ye,fe,H,p,l),Ve=new eE(x,H,se),it=new cE(k,Pe,se,fe),Ie=new xw(k,Q,Pe),Ze=new Cw(k,Q,Pe),Pe.programs=re.programs,x.capabilities=se,x.extensions=Q,x.properties=te,x.renderLists=he,x.shadowMap=Ve,x.state=fe,x.info=Pe}Y();let we=new _d(x,k);this.xr=we,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=Q.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Q.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return B},this.setPixelRatio=function(R){R!==void 0&&(B=R,this.setSize(q,U,!1))},this.getSize=function(R){return R.set(q,U)},this.setSize=function(R,Z,ae=!0){if(we.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=R,U=Z,t.width=Math.floor(R*B),t.height=Math.floor(Z*B),ae===!0&&(t.style.width=R+"px",t.style.height=Z+"px"),this.setViewport(0,0,R,Z)},this.getDrawingBufferSize=function(R){return R.set(q*B,U*B).floor()},this.setDrawingBufferSize=function(R,Z,ae){q=R,U=Z,B=ae,t.width=Math.floor(R*ae),t.height=Math.floor(Z*ae),this.setViewport(0,0,R,Z)},this.getCurrentViewport=function(R){return R.copy(w)},this.getViewport=function(R){return R.copy(ee)},this.setViewport=function(R,Z,ae,oe){R.isVector4?ee.set(R.x,R.y,R.z,R.w):ee.set(R,Z,ae,oe),fe.viewport(w.copy(ee).multiplyScalar(B).round())},this.getScissor=function(R){return R.copy(le)},this.setScissor=function(R,Z,ae,oe){R.isVector4?le.set(R.x,R.y,R.z,R.w):le.set(R,Z,ae,oe),fe.scissor(O.copy(le).multiplyScalar(B).round())},this.getScissorTest=function(){return ce},this.setScissorTest=function(R){fe.setScissorTest(ce=R)},this.setOpaqueSort=function(R){K=R},this.setTransparentSort=function(R){ne=R},this.getClearColor=function(R){return R.copy(Oe.getClearColor())},this.setClearColor=function(){Oe.setClearColor(...arguments)},this.getClearAlpha=function(){return Oe.getClearAlpha()},this.setClearAlpha=function(){Oe.setClearAlpha(...arguments)},this.clear=function(R=!0,Z=!0,ae=!0){let oe=0;if(R){let J=!1;if(I!==null){let Ee=I.texture.format;J=Ee===eh||Ee===Qc||Ee===jc}if(J){let Ee=I.texture.type,Ue=Ee===Fi||Ee===Gs||Ee===Ao||Ee===Co||Ee===Kc||Ee===Jc,We=Oe.getClearColor(),Be=Oe.getClearAlpha(),et=We.r,tt=We.g,Je=We.b;Ue?(g[0]=et,g[1]=tt,g[2]=Je,g[3]=Be,k.clearBufferuiv(k.COLOR,0,g)):(_[0]=et,_[1]=tt,_[2]=Je,_[3]=Be,k.clearBufferiv(k.COLOR,0,_))}else oe|=k.COLOR_BUFFER_BIT}Z&&(oe|=k.DEPTH_BUFFER_BIT),ae&&(oe|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k.clear(oe)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Ge,!1),t.removeEventListener("webglcontextcreationerror",Se,!1),Oe.dispose(),he.dispose(),He.dispose(),te.dispose(),Ne.dispose(),Ye.dispose(),H.dispose(),De.dispose(),it.dispose(),re.dispose(),we.dispose(),we.removeEventListener("sessionstart",Nt),we.removeEventListener("sessionend",Kn),Vn.stop()};function Te(R){R.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),P=!0}function Ge(){console.log("THREE.WebGLRenderer: Context Restored."),P=!1;let R=Pe.autoReset,Z=Ve.enabled,ae=Ve.autoUpdate,oe=Ve.needsUpdate,J=Ve.type;Y(),Pe.autoReset=R,Ve.enabled=Z,Ve.autoUpdate=ae,Ve.needsUpdate=oe,Ve.type=J}function Se(R){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function _e(R){let Z=R.target;Z.removeEventListener("dispose",_e),qe(Z)}function qe(R){rt(R),te.remove(R)}function rt(R){let Z=te.get(R).programs;Z!==void 0&&(Z.forEach(function(ae){re.releaseProgram(ae)}),R.isShaderMaterial&&re.releaseShaderCache(R))}this.renderBufferDirect=function(R,Z,ae,oe,J,Ee){Z===null&&(Z=xe);let Ue=J.isMesh&&J.matrixWorld.determinant()<0,We=ss(R,Z,ae,oe,J);fe.setMaterial(oe,Ue);let Be=ae.index,et=1;if(oe.wireframe===!0){if(Be=y.getWireframeAttribute(ae),Be===void 0)return;et=2}let tt=ae.drawRange,Je=ae.attributes.position,ht=tt.start*et,yt=(tt.start+tt.count)*et;Ee!==null&&(ht=Math.max(ht,Ee.start*et),yt=Math.min(yt,(Ee.start+Ee.count)*et)),Be!==null?(ht=Math.max(ht,0),yt=Math.min(yt,Be.count)):Je!=null&&(ht=Math.max(ht,0),yt=Math.min(yt,Je.count));let Bt=yt-ht;if(Bt<0||Bt===1/0)return;De.setup(J,oe,We,ae,Be);let At,at=Ie;if(Be!==null&&(At=L.get(Be),at=Ze,at.setIndex(At)),J.isMesh)oe.wireframe===!0?(fe.setLineWidth(oe.wireframeLinewidth*mt()),at.setMode(k.LINES)):at.setMode(k.TRIANGLES);else if(J.isLine){let Qe=oe.linewidth;Qe===void 0&&(Qe=1),fe.setLineWidth(Qe*mt()),J.isLineSegments?at.setMode(k.LINES):J.isLineLoop?at.setMode(k.LINE_LOOP):at.setMode(k.LINE_STRIP)}else J.isPoints?at.setMode(k.POINTS):J.isSprite&&at.setMode(k.TRIANGLES);if(J.isBatchedMesh)if(J._multiDrawInstances!==null)vo("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),at.renderMultiDrawInstances(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount,J._multiDrawInstances);else if(Q.get("WEBGL_multi_draw"))at.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Qe=J._multiDrawStarts,zt=J._multiDrawCounts,gt=J._multiDrawCount,Sn=Be?L.get(Be).bytesPerElement:1,bs=te.get(oe).currentProgram.getUniforms();for(let Pn=0;Pn<gt;Pn++)bs.setValue(k,"_gl_DrawID",Pn),at.render(Qe[Pn]/Sn,zt[Pn])}else if(J.isInstancedMesh)at.renderInstances(ht,Bt,J.count);else if(ae.isInstancedBufferGeometry){let Qe=ae._maxInstanceCount!==void 0?ae._maxInstanceCount:1/0,zt=Math.min(ae.instanceCount,Qe);at.renderInstances(ht,Bt,zt)}else at.render(ht,Bt)};function It(R,Z,ae){R.transparent===!0&&R.side===kn&&R.forceSinglePass===!1?(R.side=zn,R.needsUpdate=!0,qs(R,Z,ae),R.side=gs,R.needsUpdate=!0,qs(R,Z,ae),R.side=kn):qs(R,Z,ae)}this.compile=function(R,Z,ae=null){ae===null&&(ae=R),d=He.get(ae),d.init(Z),S.push(d),ae.traverseVisible(function(J){J.isLight&&J.layers.test(Z.layers)&&(d.pushLight(J),J.castShadow&&d.pushShadow(J))}),R!==ae&&R.traverseVisible(function(J){J.isLight&&J.layers.test(Z.layers)&&(d.pushLight(J),J.castShadow&&d.pushShadow(J))}),d.setupLights();let oe=new Set;return R.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Ee=J.material;if(Ee)if(Array.isArray(Ee))for(let Ue=0;Ue<Ee.length;Ue++){let We=Ee[Ue];It(We,ae,J),oe.add(We)}else It(Ee,ae,J),oe.add(Ee)}),d=S.pop(),oe},this.compileAsync=function(R,Z,ae=null){let oe=this.compile(R,Z,ae);return new Promise(J=>{function Ee(){if(oe.forEach(function(Ue){te.get(Ue).currentProgram.isReady()&&oe.delete(Ue)}),oe.size===0){J(R);return}setTimeout(Ee,10)}Q.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let xt=null;function vn(R){xt&&xt(R)}function Nt(){Vn.stop()}function Kn(){Vn.start()}let Vn=new H0;Vn.setAnimationLoop(vn),typeof self<"u"&&Vn.setContext(self),this.setAnimationLoop=function(R){xt=R,we.setAnimationLoop(R),R===null?Vn.stop():Vn.start()},we.addEventListener("sessionstart",Nt),we.addEventListener("sessionend",Kn),this.render=function(R,Z){if(Z!==void 0&&Z.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),Z.parent===null&&Z.matrixWorldAutoUpdate===!0&&Z.updateMatrixWorld(),we.enabled===!0&&we.isPresenting===!0&&(we.cameraAutoUpdate===!0&&we.updateCamera(Z),Z=we.getCamera()),R.isScene===!0&&R.onBeforeRender(x,R,Z,I),d=He.get(R,S.length),d.init(Z),S.push(d),X.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),ye.setFromProjectionMatrix(X,Ii,Z.reversedDepth),j=this.localClippingEnabled,Re=Me.init(this.clippingPlanes,j),m=he.get(R,M.length),m.init(),M.push(m),we.enabled===!0&&we.isPresenting===!0){let Ee=x.xr.getDepthSensingMesh();Ee!==null&&Oi(Ee,Z,-1/0,x.sortObjects)}Oi(R,Z,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(K,ne),Ke=we.enabled===!1||we.isPresenting===!1||we.hasDepthSensing()===!1,Ke&&Oe.addToRenderList(m,R),this.info.render.frame++,Re===!0&&Me.beginShadows();let ae=d.state.shadowsArray;Ve.render(ae,R,Z),Re===!0&&Me.endShadows(),this.info.autoReset===!0&&this.info.reset();let oe=m.opaque,J=m.transmissive;if(d.setupLights(),Z.isArrayCamera){let Ee=Z.cameras;if(J.length>0)for(let Ue=0,We=Ee.length;Ue<We;Ue++){let Be=Ee[Ue];is(oe,J,R,Be)}Ke&&Oe.render(R);for(let Ue=0,We=Ee.length;Ue<We;Ue++){let Be=Ee[Ue];Cn(m,R,Be,Be.viewport)}}else J.length>0&&is(oe,J,R,Z),Ke&&Oe.render(R),Cn(m,R,Z);I!==null&&C===0&&(ve.updateMultisampleRenderTarget(I),ve.updateRenderTargetMipmap(I)),R.isScene===!0&&R.onAfterRender(x,R,Z),De.resetDefaultState(),b=-1,E=null,S.pop(),S.length>0?(d=S[S.length-1],Re===!0&&Me.setGlobalState(x.clippingPlanes,d.state.camera)):d=null,M.pop(),M.length>0?m=M[M.length-1]:m=null};function Oi(R,Z,ae,oe){if(R.visible===!1)return;if(R.layers.test(Z.layers)){if(R.isGroup)ae=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(Z);else if(R.isLight)d.pushLight(R),R.castShadow&&d.pushShadow(R);else if(R.isSprite){if(!R.frustumCulled||ye.intersectsSprite(R)){oe&&Ae.setFromMatrixPosition(R.matrixWorld).applyMatrix4(X);let Ue=H.update(R),We=R.material;We.visible&&m.push(R,Ue,We,ae,Ae.z,null)}}else if((R.isMesh||R.isLine||R.isPoints)&&(!R.frustumCulled||ye.intersectsObject(R))){let Ue=H.update(R),We=R.material;if(oe&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Ae.copy(R.boundingSphere.center)):(Ue.boundingSphere===null&&Ue.computeBoundingSphere(),Ae.copy(Ue.boundingSphere.center)),Ae.applyMatrix4(R.matrixWorld).applyMatrix4(X)),Array.isArray(We)){let Be=Ue.groups;for(let et=0,tt=Be.length;et<tt;et++){let Je=Be[et],ht=We[Je.materialIndex];ht&&ht.visible&&m.push(R,Ue,ht,ae,Ae.z,Je)}}else We.visible&&m.push(R,Ue,We,ae,Ae.z,null)}}let Ee=R.children;for(let Ue=0,We=Ee.length;Ue<We;Ue++)Oi(Ee[Ue],Z,ae,oe)}function Cn(R,Z,ae,oe){let J=R.opaque,Ee=R.transmissive,Ue=R.transparent;d.setupLightsView(ae),Re===!0&&Me.setGlobalState(x.clippingPlanes,ae),oe&&fe.viewport(w.copy(oe)),J.length>0&&vi(J,Z,ae),Ee.length>0&&vi(Ee,Z,ae),Ue.length>0&&vi(Ue,Z,ae),fe.buffers.depth.setTest(!0),fe.buffers.depth.setMask(!0),fe.buffers.color.setMask(!0),fe.setPolygonOffset(!1)}function is(R,Z,ae,oe){if((ae.isScene===!0?ae.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[oe.id]===void 0&&(d.state.transmissionRenderTarget[oe.id]=new $i(1,1,{generateMipmaps:!0,type:Q.has("EXT_color_buffer_half_float")||Q.has("EXT_color_buffer_float")?Ro:Fi,minFilter:Vs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:vt.workingColorSpace}));let Ee=d.state.transmissionRenderTarget[oe.id],Ue=oe.viewport||w;Ee.setSize(Ue.z*x.transmissionResolutionScale,Ue.w*x.transmissionResolutionScale);let We=x.getRenderTarget(),Be=x.getActiveCubeFace(),et=x.getActiveMipmapLevel();x.setRenderTarget(Ee),x.getClearColor(V),W=x.getClearAlpha(),W<1&&x.setClearColor(16777215,.5),x.clear(),Ke&&Oe.render(ae);let tt=x.toneMapping;x.toneMapping=xs;let Je=oe.viewport;if(oe.viewport!==void 0&&(oe.viewport=void 0),d.setupLightsView(oe),Re===!0&&Me.setGlobalState(x.clippingPlanes,oe),vi(R,ae,oe),ve.updateMultisampleRenderTarget(Ee),ve.updateRenderTargetMipmap(Ee),Q.has("WEBGL_multisampled_render_to_texture")===!1){let ht=!1;for(let yt=0,Bt=Z.length;yt<Bt;yt++){let At=Z[yt],at=At.object,Qe=At.geometry,zt=At.material,gt=At.group;if(zt.side===kn&&at.layers.test(oe.layers)){let Sn=zt.side;zt.side=zn,zt.needsUpdate=!0,Bo(at,ae,oe,Qe,zt,gt),zt.side=Sn,zt.needsUpdate=!0,ht=!0}}ht===!0&&(ve.updateMultisampleRenderTarget(Ee),ve.updateRenderTargetMipmap(Ee))}x.setRenderTarget(We,Be,et),x.setClearColor(V,W),Je!==void 0&&(oe.viewport=Je),x.toneMapping=tt}function vi(R,Z,ae){let oe=Z.isScene===!0?Z.overrideMaterial:null;for(let J=0,Ee=R.length;J<Ee;J++){let Ue=R[J],We=Ue.object,Be=Ue.geometry,et=Ue.group,tt=Ue.material;tt.allowOverride===!0&&oe!==null&&(tt=oe),We.layers.test(ae.layers)&&Bo(We,Z,ae,Be,tt,et)}}function Bo(R,Z,ae,oe,J,Ee){R.onBeforeRender(x,Z,ae,oe,J,Ee),R.modelViewMatrix.multiplyMatrices(ae.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),J.onBeforeRender(x,Z,ae,oe,R,Ee),J.transparent===!0&&J.side===kn&&J.forceSinglePass===!1?(J.side=zn,J.needsUpdate=!0,x.renderBufferDirect(ae,Z,oe,J,R,Ee),J.side=gs,J.needsUpdate=!0,x.renderBufferDirect(ae,Z,oe,J,R,Ee),J.side=kn):x.renderBufferDirect(ae,Z,oe,J,R,Ee),R.onAfterRender(x,Z,ae,oe,J,Ee)}function qs(R,Z,ae){Z.isScene!==!0&&(Z=xe);let oe=te.get(R),J=d.state.lights,Ee=d.state.shadowsArray,Ue=J.state.version,We=re.getParameters(R,J.state,Ee,Z,ae),Be=re.getProgramCacheKey(We),et=oe.programs;oe.environment=R.isMeshStandardMaterial?Z.environment:null,oe.fog=Z.fog,oe.envMap=(R.isMeshStandardMaterial?Ye:Ne).get(R.envMap||oe.environment),oe.envMapRotation=oe.environment!==null&&R.envMap===null?Z.environmentRotation:R.envMapRotation,et===void 0&&(R.addEventListener("dispose",_e),et=new Map,oe.programs=et);let tt=et.get(Be);if(tt!==void 0){if(oe.currentProgram===tt&&oe.lightsStateVersion===Ue)return sl(R,We),tt}else We.uniforms=re.getUniforms(R),R.onBeforeCompile(We,x),tt=re.acquireProgram(We,Be),et.set(Be,tt),oe.uniforms=We.uniforms;let Je=oe.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Je.clippingPlanes=Me.uniform),sl(R,We),oe.needsLights=Ys(R),oe.lightsStateVersion=Ue,oe.needsLights&&(Je.ambientLightColor.value=J.state.ambient,Je.lightProbe.value=J.state.probe,Je.directionalLights.value=J.state.directional,Je.directionalLightShadows.value=J.state.directionalShadow,Je.spotLights.value=J.state.spot,Je.spotLightShadows.value=J.state.spotShadow,Je.rectAreaLights.value=J.state.rectArea,Je.ltc_1.value=J.state.rectAreaLTC1,Je.ltc_2.value=J.state.rectAreaLTC2,Je.pointLights.value=J.state.point,Je.pointLightShadows.value=J.state.pointShadow,Je.hemisphereLights.value=J.state.hemi,Je.directionalShadowMap.value=J.state.directionalShadowMap,Je.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Je.spotShadowMap.value=J.state.spotShadowMap,Je.spotLightMatrix.value=J.state.spotLightMatrix,Je.spotLightMap.value=J.state.spotLightMap,Je.pointShadowMap.value=J.state.pointShadowMap,Je.pointShadowMatrix.value=J.state.pointShadowMatrix),oe.currentProgram=tt,oe.uniformsList=null,tt}function il(R){if(R.uniformsList===null){let Z=R.currentProgram.getUniforms();R.uniformsList=Do.seqWithValue(Z.seq,R.uniforms)}return R.uniformsList}function sl(R,Z){let ae=te.get(R);ae.outputColorSpace=Z.outputColorSpace,ae.batching=Z.batching,ae.batchingColor=Z.batchingColor,ae.instancing=Z.instancing,ae.instancingColor=Z.instancingColor,ae.instancingMorph=Z.instancingMorph,ae.skinning=Z.skinning,ae.morphTargets=Z.morphTargets,ae.morphNormals=Z.morphNormals,ae.morphColors=Z.morphColors,ae.morphTargetsCount=Z.morphTargetsCount,ae.numClippingPlanes=Z.numClippingPlanes,ae.numIntersection=Z.numClipIntersection,ae.vertexAlphas=Z.vertexAlphas,ae.vertexTangents=Z.vertexTangents,ae.toneMapping=Z.toneMapping}function ss(R,Z,ae,oe,J){Z.isScene!==!0&&(Z=xe),ve.resetTextureUnits();let Ee=Z.fog,Ue=oe.isMeshStandardMaterial?Z.environment:null,We=I===null?x.outputColorSpace:I.isXRRenderTarget===!0?I.texture.colorSpace:fr,Be=(oe.isMeshStandardMaterial?Ye:Ne).get(oe.envMap||Ue),et=oe.vertexColors===!0&&!!ae.attributes.color&&ae.attributes.color.itemSize===4,tt=!!ae.attributes.tangent&&(!!oe.normalMap||oe.anisotropy>0),Je=!!ae.morphAttributes.position,ht=!!ae.morphAttributes.normal,yt=!!ae.morphAttributes.color,Bt=xs;oe.toneMapped&&(I===null||I.isXRRenderTarget===!0)&&(Bt=x.toneMapping);let At=ae.morphAttributes.position||ae.morphAttributes.normal||ae.morphAttributes.color,at=At!==void 0?At.length:0,Qe=te.get(oe),zt=d.state.lights;if(Re===!0&&(j===!0||R!==E)){let hn=R===E&&oe.id===b;Me.setState(oe,R,hn)}let gt=!1;oe.version===Qe.__version?(Qe.needsLights&&Qe.lightsStateVersion!==zt.state.version||Qe.outputColorSpace!==We||J.isBatchedMesh&&Qe.batching===!1||!J.isBatchedMesh&&Qe.batching===!0||J.isBatchedMesh&&Qe.batchingColor===!0&&J.colorTexture===null||J.isBatchedMesh&&Qe.batchingColor===!1&&J.colorTexture!==null||J.isInstancedMesh&&Qe.instancing===!1||!J.isInstancedMesh&&Qe.instancing===!0||J.isSkinnedMesh&&Qe.skinning===!1||!J.isSkinnedMesh&&Qe.skinning===!0||J.isInstancedMesh&&Qe.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Qe.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Qe.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Qe.instancingMorph===!1&&J.morphTexture!==null||Qe.envMap!==Be||oe.fog===!0&&Qe.fog!==Ee||Qe.numClippingPlanes!==void 0&&(Qe.numClippingPlanes!==Me.numPlanes||Qe.numIntersection!==Me.numIntersection)||Qe.vertexAlphas!==et||Qe.vertexTangents!==tt||Qe.morphTargets!==Je||Qe.morphNormals!==ht||Qe.morphColors!==yt||Qe.toneMapping!==Bt||Qe.morphTargetsCount!==at)&&(gt=!0):(gt=!0,Qe.__version=oe.version);let Sn=Qe.currentProgram;gt===!0&&(Sn=qs(oe,Z,J));let bs=!1,Pn=!1,$s=!1,kt=Sn.getUniforms(),In=Qe.uniforms;if(fe.useProgram(Sn.program)&&(bs=!0,Pn=!0,$s=!0),oe.id!==b&&(b=oe.id,Pn=!0),bs||E!==R){fe.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),kt.setValue(k,"projectionMatrix",R.projectionMatrix),kt.setValue(k,"viewMatrix",R.matrixWorldInverse);let un=kt.map.cameraPosition;un!==void 0&&un.setValue(k,de.setFromMatrixPosition(R.matrixWorld)),se.logarithmicDepthBuffer&&kt.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(oe.isMeshPhongMaterial||oe.isMeshToonMaterial||oe.isMeshLambertMaterial||oe.isMeshBasicMaterial||oe.isMeshStandardMaterial||oe.isShaderMaterial)&&kt.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),E!==R&&(E=R,Pn=!0,$s=!0)}if(J.isSkinnedMesh){kt.setOptional(k,J,"bindMatrix"),kt.setOptional(k,J,"bindMatrixInverse");let hn=J.skeleton;hn&&(hn.boneTexture===null&&hn.computeBoneTexture(),kt.setValue(k,"boneTexture",hn.boneTexture,ve))}J.isBatchedMesh&&(kt.setOptional(k,J,"batchingTexture"),kt.setValue(k,"batchingTexture",J._matricesTexture,ve),kt.setOptional(k,J,"batchingIdTexture"),kt.setValue(k,"batchingIdTexture",J._indirectTexture,ve),kt.setOptional(k,J,"batchingColorTexture"),J._colorsTexture!==null&&kt.setValue(k,"batchingColorTexture",J._colorsTexture,ve));let Gn=ae.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&ge.update(J,ae,Sn),(Pn||Qe.receiveShadow!==J.receiveShadow)&&(Qe.receiveShadow=J.receiveShadow,kt.setValue(k,"receiveShadow",J.receiveShadow)),oe.isMeshGouraudMaterial&&oe.envMap!==null&&(In.envMap.value=Be,In.flipEnvMap.value=Be.isCubeTexture&&Be.isRenderTargetTexture===!1?-1:1),oe.isMeshStandardMaterial&&oe.envMap===null&&Z.environment!==null&&(In.envMapIntensity.value=Z.environmentIntensity),Pn&&(kt.setValue(k,"toneMappingExposure",x.toneMappingExposure),Qe.needsLights&&Zh(In,$s),Ee&&oe.fog===!0&&pe.refreshFogUniforms(In,Ee),pe.refreshMaterialUniforms(In,oe,B,U,d.state.transmissionRenderTarget[R.id]),Do.upload(k,il(Qe),In,ve)),oe.isShaderMaterial&&oe.uniformsNeedUpdate===!0&&(Do.upload(k,il(Qe),In,ve),oe.uniformsNeedUpdate=!1),oe.isSpriteMaterial&&kt.setValue(k,"center",J.center),kt.setValue(k,"modelViewMatrix",J.modelViewMatrix),kt.setValue(k,"normalMatrix",J.normalMatrix),kt.setValue(k,"modelMatrix",J.matrixWorld),oe.isShaderMaterial||oe.isRawShaderMaterial){let hn=oe.uniformsGroups;for(let un=0,Ms=hn.length;un<Ms;un++){let li=hn[un];it.update(li,Sn),it.bind(li,Sn)}}return Sn}function Zh(R,Z){R.ambientLightColor.needsUpdate=Z,R.lightProbe.needsUpdate=Z,R.directionalLights.needsUpdate=Z,R.directionalLightShadows.needsUpdate=Z,R.pointLights.needsUpdate=Z,R.pointLightShadows.needsUpdate=Z,R.spotLights.needsUpdate=Z,R.spotLightShadows.needsUpdate=Z,R.rectAreaLights.needsUpdate=Z,R.hemisphereLights.needsUpdate=Z}function Ys(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return T},this.getActiveMipmapLevel=function(){return C},this.getRenderTarget=function(){return I},this.setRenderTargetTextures=function(R,Z,ae){let oe=te.get(R);oe.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,oe.__autoAllocateDepthBuffer===!1&&(oe.__useRenderToTexture=!1),te.get(R.texture).__webglTexture=Z,te.get(R.depthTexture).__webglTexture=oe.__autoAllocateDepthBuffer?void 0:ae,oe.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,Z){let ae=te.get(R);ae.__webglFramebuffer=Z,ae.__useDefaultFramebuffer=Z===void 0};let rl=k.createFramebuffer();this.setRenderTarget=function(R,Z=0,ae=0){I=R,T=Z,C=ae;let oe=!0,J=null,Ee=!1,Ue=!1;if(R){let Be=te.get(R);if(Be.__useDefaultFramebuffer!==void 0)fe.bindFramebuffer(k.FRAMEBUFFER,null),oe=!1;else if(Be.__webglFramebuffer===void 0)ve.setupRenderTarget(R);else if(Be.__hasExternalTextures)ve.rebindTextures(R,te.get(R.texture).__webglTexture,te.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Je=R.depthTexture;if(Be.__boundDepthTexture!==Je){if(Je!==null&&te.has(Je)&&(R.width!==Je.image.width||R.height!==Je.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");ve.setupDepthRenderbuffer(R)}}let et=R.texture;(et.isData3DTexture||et.isDataArrayTexture||et.isCompressedArrayTexture)&&(Ue=!0);let tt=te.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(tt[Z])?J=tt[Z][ae]:J=tt[Z],Ee=!0):R.samples>0&&ve.useMultisampledRTT(R)===!1?J=te.get(R).__webglMultisampledFramebuffer:Array.isArray(tt)?J=tt[ae]:J=tt,w.copy(R.viewport),O.copy(R.scissor),z=R.scissorTest}else w.copy(ee).multiplyScalar(B).floor(),O.copy(le).multiplyScalar(B).floor(),z=ce;if(ae!==0&&(J=rl),fe.bindFramebuffer(k.FRAMEBUFFER,J)&&oe&&fe.drawBuffers(R,J),fe.viewport(w),fe.scissor(O),fe.setScissorTest(z),Ee){let Be=te.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+Z,Be.__webglTexture,ae)}else if(Ue){let Be=Z;for(let et=0;et<R.textures.length;et++){let tt=te.get(R.textures[et]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+et,tt.__webglTexture,ae,Be)}}else if(R!==null&&ae!==0){let Be=te.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Be.__webglTexture,ae)}b=-1},this.readRenderTargetPixels=function(R,Z,ae,oe,J,Ee,Ue,We=0){if(!(R&&R.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Be=te.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ue!==void 0&&(Be=Be[Ue]),Be){fe.bindFramebuffer(k.FRAMEBUFFER,Be);try{let et=R.textures[We],tt=et.format,Je=et.type;if(!se.textureFormatReadable(tt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!se.textureTypeReadable(Je)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}Z>=0&&Z<=R.width-oe&&ae>=0&&ae<=R.height-J&&(R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+We),k.readPixels(Z,ae,oe,J,$e.convert(tt),$e.convert(Je),Ee))}finally{let et=I!==null?te.get(I).__webglFramebuffer:null;fe.bindFramebuffer(k.FRAMEBUFFER,et)}}},this.readRenderTargetPixelsAsync=async function(R,Z,ae,oe,J,Ee,Ue,We=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Be=te.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ue!==void 0&&(Be=Be[Ue]),Be)if(Z>=0&&Z<=R.width-oe&&ae>=0&&ae<=R.height-J){fe.bindFramebuffer(k.FRAMEBUFFER,Be);let et=R.textures[We],tt=et.format,Je=et.type;if(!se.textureFormatReadable(tt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!se.textureTypeReadable(Je))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ht=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ht),k.bufferData(k.PIXEL_PACK_BUFFER,Ee.byteLength,k.STREAM_READ),R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+We),k.readPixels(Z,ae,oe,J,$e.convert(tt),$e.convert(Je),0);let yt=I!==null?te.get(I).__webglFramebuffer:null;fe.bindFramebuffer(k.FRAMEBUFFER,yt);let Bt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await p0(k,Bt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ht),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Ee),k.deleteBuffer(ht),k.deleteSync(Bt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,Z=null,ae=0){let oe=Math.pow(2,-ae),J=Math.floor(R.image.width*oe),Ee=Math.floor(R.image.height*oe),Ue=Z!==null?Z.x:0,We=Z!==null?Z.y:0;ve.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,ae,0,0,Ue,We,J,Ee),fe.unbindTexture()};let Bi=k.createFramebuffer(),nn=k.createFramebuffer();this.copyTextureToTexture=function(R,Z,ae=null,oe=null,J=0,Ee=null){Ee===null&&(J!==0?(vo("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),Ee=J,J=0):Ee=0);let Ue,We,Be,et,tt,Je,ht,yt,Bt,At=R.isCompressedTexture?R.mipmaps[Ee]:R.image;if(ae!==null)Ue=ae.max.x-ae.min.x,We=ae.max.y-ae.min.y,Be=ae.isBox3?ae.max.z-ae.min.z:1,et=ae.min.x,tt=ae.min.y,Je=ae.isBox3?ae.min.z:0;else{let Gn=Math.pow(2,-J);Ue=Math.floor(At.width*Gn),We=Math.floor(At.height*Gn),R.isDataArrayTexture?Be=At.depth:R.isData3DTexture?Be=Math.floor(At.depth*Gn):Be=1,et=0,tt=0,Je=0}oe!==null?(ht=oe.x,yt=oe.y,Bt=oe.z):(ht=0,yt=0,Bt=0);let at=$e.convert(Z.format),Qe=$e.convert(Z.type),zt;Z.isData3DTexture?(ve.setTexture3D(Z,0),zt=k.TEXTURE_3D):Z.isDataArrayTexture||Z.isCompressedArrayTexture?(ve.setTexture2DArray(Z,0),zt=k.TEXTURE_2D_ARRAY):(ve.setTexture2D(Z,0),zt=k.TEXTURE_2D),k.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,Z.flipY),k.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,Z.premultiplyAlpha),k.pixelStorei(k.UNPACK_ALIGNMENT,Z.unpackAlignment);let gt=k.getParameter(k.UNPACK_ROW_LENGTH),Sn=k.getParameter(k.UNPACK_IMAGE_HEIGHT),bs=k.getParameter(k.UNPACK_SKIP_PIXELS),Pn=k.getParameter(k.UNPACK_SKIP_ROWS),$s=k.getParameter(k.UNPACK_SKIP_IMAGES);k.pixelStorei(k.UNPACK_ROW_LENGTH,At.width),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,At.height),k.pixelStorei(k.UNPACK_SKIP_PIXELS,et),k.pixelStorei(k.UNPACK_SKIP_ROWS,tt),k.pixelStorei(k.UNPACK_SKIP_IMAGES,Je);let kt=R.isDataArrayTexture||R.isData3DTexture,In=Z.isDataArrayTexture||Z.isData3DTexture;if(R.isDepthTexture){let Gn=te.get(R),hn=te.get(Z),un=te.get(Gn.__renderTarget),Ms=te.get(hn.__renderTarget);fe.bindFramebuffer(k.READ_FRAMEBUFFER,un.__webglFramebuffer),fe.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ms.__webglFramebuffer);for(let li=0;li<Be;li++)kt&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,te.get(R).__webglTexture,J,Je+li),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,te.get(Z).__webglTexture,Ee,Bt+li)),k.blitFramebuffer(et,tt,Ue,We,ht,yt,Ue,We,k.DEPTH_BUFFER_BIT,k.NEAREST);fe.bindFramebuffer(k.READ_FRAMEBUFFER,null),fe.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(J!==0||R.isRenderTargetTexture||te.has(R)){let Gn=te.get(R),hn=te.get(Z);fe.bindFramebuffer(k.READ_FRAMEBUFFER,Bi),fe.bindFramebuffer(k.DRAW_FRAMEBUFFER,nn);for(let un=0;un<Be;un++)kt?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gn.__webglTexture,J,Je+un):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Gn.__webglTexture,J),In?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,hn.__webglTexture,Ee,Bt+un):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,hn.__webglTexture,Ee),J!==0?k.blitFramebuffer(et,tt,Ue,We,ht,yt,Ue,We,k.COLOR_BUFFER_BIT,k.NEAREST):In?k.copyTexSubImage3D(zt,Ee,ht,yt,Bt+un,et,tt,Ue,We):k.copyTexSubImage2D(zt,Ee,ht,yt,et,tt,Ue,We);fe.bindFramebuffer(k.READ_FRAMEBUFFER,null),fe.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else In?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(zt,Ee,ht,yt,Bt,Ue,We,Be,at,Qe,At.data):Z.isCompressedArrayTexture?k.compressedTexSubImage3D(zt,Ee,ht,yt,Bt,Ue,We,Be,at,At.data):k.texSubImage3D(zt,Ee,ht,yt,Bt,Ue,We,Be,at,Qe,At):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Ee,ht,yt,Ue,We,at,Qe,At.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Ee,ht,yt,At.width,At.height,at,At.data):k.texSubImage2D(k.TEXTURE_2D,Ee,ht,yt,Ue,We,at,Qe,At);k.pixelStorei(k.UNPACK_ROW_LENGTH,gt),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Sn),k.pixelStorei(k.UNPACK_SKIP_PIXELS,bs),k.pixelStorei(k.UNPACK_SKIP_ROWS,Pn),k.pixelStorei(k.UNPACK_SKIP_IMAGES,$s),Ee===0&&Z.generateMipmaps&&k.generateMipmap(zt),fe.unbindTexture()},this.initRenderTarget=function(R){te.get(R).__webglFramebuffer===void 0&&ve.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?ve.setTextureCube(R,0):R.isData3DTexture?ve.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?ve.setTexture2DArray(R,0):ve.setTexture2D(R,0),fe.unbindTexture()},this.resetState=function(){T=0,C=0,I=null,fe.reset(),De.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var q0={type:"change"},bd={type:"start"},$0={type:"end"},Nh=new dr,Y0=new Wn,hE=Math.cos(70*Ws.DEG2RAD),cn=new N,Zn=2*Math.PI,Ut={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},yd=1e-6,Fh=class extends Ga{constructor(e,t=null){super(e,t),this.state=Ut.NONE,this.target=new N,this.cursor=new N,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ks.ROTATE,MIDDLE:ks.DOLLY,RIGHT:ks.PAN},this.touches={ONE:Hs.ROTATE,TWO:Hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new N,this._lastQuaternion=new Xn,this._lastTargetPosition=new N,this._quat=new Xn().setFromUnitVectors(e.up,new N(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new To,this._sphericalDelta=new To,this._scale=1,this._panOffset=new N,this._rotateStart=new Fe,this._rotateEnd=new Fe,this._rotateDelta=new Fe,this._panStart=new Fe,this._panEnd=new Fe,this._panDelta=new Fe,this._dollyStart=new Fe,this._dollyEnd=new Fe,this._dollyDelta=new Fe,this._dollyDirection=new N,this._mouse=new Fe,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=fE.bind(this),this._onPointerDown=uE.bind(this),this._onPointerUp=dE.bind(this),this._onContextMenu=yE.bind(this),this._onMouseWheel=gE.bind(this),this._onKeyDown=_E.bind(this),this._onTouchStart=vE.bind(this),this._onTouchMove=xE.bind(this),this._onMouseDown=pE.bind(this),this._onMouseMove=mE.bind(this),this._interceptControlDown=bE.bind(this),this._interceptControlUp=ME.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(q0),this.update(),this.state=Ut.NONE}update(e=null){let t=this.object.position;cn.copy(t).sub(this.target),cn.applyQuaternion(this._quat),this._spherical.setFromVector3(cn),this.autoRotate&&this.state===Ut.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Zn:n>Math.PI&&(n-=Zn),s<-Math.PI?s+=Zn:s>Math.PI&&(s-=Zn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(cn.setFromSpherical(this._spherical),cn.applyQuaternion(this._quatInverse),t.copy(this.target).add(cn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=cn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new N(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new N(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=cn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Nh.origin.copy(this.object.position),Nh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Nh.direction))<hE?this.object.lookAt(this.target):(Y0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Nh.intersectPlane(Y0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>yd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>yd||this._lastTargetPosition.distanceToSquared(this.target)>yd?(this.dispatchEvent(q0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Zn/60*this.autoRotateSpeed*e:Zn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){cn.setFromMatrixColumn(t,0),cn.multiplyScalar(-e),this._panOffset.add(cn)}_panUp(e,t){this.screenSpacePanning===!0?cn.setFromMatrixColumn(t,1):(cn.setFromMatrixColumn(t,0),cn.crossVectors(this.object.up,cn)),cn.multiplyScalar(e),this._panOffset.add(cn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;cn.copy(s).sub(this.target);let r=cn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Zn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Zn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Zn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Zn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Fe,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function uE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function fE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function dE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent($0),this.state=Ut.NONE;break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function pE(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ks.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ut.DOLLY;break;case ks.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ut.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ut.ROTATE}break;case ks.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ut.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ut.PAN}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(bd)}function mE(i){switch(this.state){case Ut.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ut.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ut.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function gE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ut.NONE||(i.preventDefault(),this.dispatchEvent(bd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent($0))}function _E(i){this.enabled!==!1&&this._handleKeyDown(i)}function vE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Hs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Ut.TOUCH_ROTATE;break;case Hs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Ut.TOUCH_PAN;break;default:this.state=Ut.NONE}break;case 2:switch(this.touches.TWO){case Hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ut.TOUCH_DOLLY_PAN;break;case Hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ut.TOUCH_DOLLY_ROTATE;break;default:this.state=Ut.NONE}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(bd)}function xE(i){switch(this._trackPointer(i),this.state){case Ut.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ut.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ut.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ut.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ut.NONE}}function yE(i){this.enabled!==!1&&i.preventDefault()}function bE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function ME(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Z0=7,SE=.0022;function wE(i){class e extends $n{getPoint(n,s=new N){let r=2*Math.PI*Z0*n;return s.set(n,i*Math.cos(r),i*Math.sin(r))}}return new Ua(new e,Z0*14,SE,5)}function ja(i,e=14){return new oi(i,i,1,e).rotateZ(-Math.PI/2).translate(.5,0,0)}var Oh=class{constructor(e,t,n){this.group=new Jt;let s=new Ni({color:e,depthTest:!1,transparent:!0,opacity:n});this.shaft=new ut(ja(t,10),s),this.head=new ut(new gr(3*t,8*t,14).rotateZ(-Math.PI/2),s),this.size=8*t,this.shaft.renderOrder=this.head.renderOrder=10,this.group.add(this.shaft,this.head),this.along=new N(1,0,0),this.way=new N}show(e,t){let n=this.way.set(...t).length();if(this.group.visible=n>1e-4,!this.group.visible)return;this.group.position.set(...e),this.group.quaternion.setFromUnitVectors(this.along,this.way.divideScalar(n));let s=Math.min(this.size,.6*n);this.head.scale.setScalar(s/this.size),this.head.position.x=n-.5*s,this.shaft.scale.x=Math.max(n-s,1e-5)}hide(){this.group.visible=!1}},Bh,K0,Qa=class{constructor(e,t,n){Jd(this,Bh);this.flight=e,this.group=new Jt;let s=t.opacity<1,r=(_,m={})=>new Ji({color:_,roughness:.55,metalness:.15,transparent:s,opacity:t.opacity,depthWrite:!s,...m}),o=r(n.metal),a=r(n.dark),l=r(t.colour),c=r(n.force,{metalness:.4,roughness:.35}),u=Math.max(...e.arms.map(_=>_.length)),h=u/.19,f=new ut(new oi(.042*h,.042*h,.026*h,28),a);f.rotation.x=Math.PI/2;let p=new ut(new oi(.032*h,.04*h,.014*h,28),l);p.rotation.x=Math.PI/2,p.position.z=.02*h;let g=new ut(new gr(.012*h,.034*h,16).rotateZ(-Math.PI/2),l);g.position.set(.056*h,0,.004*h),this.group.add(f,p,g),this.hulls=e.hull.map(_=>{let m=r(t.colour,{transparent:!0,opacity:.22*t.opacity,depthWrite:!1}),d=new ut(new La(_.radius,32,20),m);return d.position.set(..._.centre),this.group.add(d),m}),this.arms=e.arms.map(_=>jd(this,Bh,K0).call(this,_,{metal:o,dark:a,own:l,spring:c,paint:r,colours:n,unit:h,faded:s,look:t})),this.most=e.max_thrust||1,this.bar=1.2*u}show(e,t=1){this.group.position.set(...e.position);let[n,s,r,o]=e.quaternion;this.group.quaternion.set(s,r,o,n),this.arms.forEach((a,l)=>{let c=Math.min(t*(a.free-e.armLengths[l]),.4*a.free),u=t===1?e.armLengths[l]:a.free-c;a.end.position.x=u,a.coil&&(a.coil.scale.x=Math.max(u-a.collar-a.seat,.004)),a.blades.rotation.z=a.spin*e.own*60;let h=this.bar*e.thrust[l]/this.most;a.thrust.visible=h>.001,a.thrust.scale.z=Math.max(h,.001),a.cagePaint.color.set(e.contacts[l]?this.flight.glow:this.flight.colour)}),this.hulls.forEach((a,l)=>{a.color.set(e.contacts[this.arms.length+l]?this.flight.glow:this.flight.colour)})}};Bh=new WeakSet,K0=function(e,{metal:t,dark:n,own:s,spring:r,paint:o,colours:a,unit:l,faded:c,look:u}){let h=new Jt;h.rotation.z=Math.atan2(e.direction[1],e.direction[0]),this.group.add(h);let f=e.length-e.shortest,p=new Jt;h.add(p);let g={end:p,frame:h,free:e.length},_=.13*e.length;if(e.compliant){let C=Math.max(.24*e.length,e.shortest-_-.8*f),I=new ut(ja(.0075*l),t);I.scale.x=e.shortest-.5*_;let b=new ut(ja(.0045*l),s);b.position.x=-(e.length-C)+.3*_,b.scale.x=-b.position.x;let E=()=>new ut(new oi(.0155*l,.0155*l,.006*l,20).rotateZ(Math.PI/2),n),w=E();w.position.x=C;let O=E();O.position.x=-_;let z=new ut(wE(.0125*l),r);z.position.x=C,h.add(I,w,z),p.add(b,O),Object.assign(g,{coil:z,seat:C,collar:_})}else{let C=new ut(ja(.007*l),t);C.scale.x=e.length,h.add(C)}let m=new ut(new oi(.013*l,.013*l,.024*l,18).rotateX(Math.PI/2),n);m.position.z=.008*l;let d=.62*e.cage_radius,M=new ut(new mr(d,36),o(a.thrust,{transparent:!0,opacity:.16*u.opacity,side:kn,depthWrite:!1}));M.position.z=.022*l;let S=new ut(new Ki(2*d,.012*l,.0015),n);S.position.z=.023*l;let x=o(u.colour,{roughness:.4}),P=new ut(new Da(e.cage_radius-.0035*l,.0035*l,10,72),x);p.add(m,M,S,P);for(let C=0;C<3;C++){let I=new ut(ja(.0016*l,6),t);I.rotation.z=2*Math.PI*(C+.5)/3,I.scale.x=e.cage_radius-.004*l,p.add(I)}let T=new ut(new oi(.006*l,.006*l,1,12).rotateX(Math.PI/2).translate(0,0,.5),o(a.thrust,{transparent:!0,opacity:.8*u.opacity,emissive:a.thrust,emissiveIntensity:.3}));return T.position.z=.024*l,p.add(T),Object.assign(g,{blades:S,cagePaint:x,thrust:T,spin:e.spin})};function el(i){i.traverse(e=>{e.geometry?.dispose();for(let t of[e.material].flat())t?.map?.dispose(),t?.dispose?.()}),i.removeFromParent()}var J0=new _n,zh=new N,No=class extends ka{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new pt(e,3)),this.setAttribute("uv",new pt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new zs(t,6,1);return this.setAttribute("instanceStart",new Yn(n,3,0)),this.setAttribute("instanceEnd",new Yn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new zs(t,6,1);return this.setAttribute("instanceColorStart",new Yn(n,3,0)),this.setAttribute("instanceColorEnd",new Yn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new Na(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new _n);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),J0.setFromBufferAttribute(t),this.boundingBox.union(J0))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)zh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(zh)),zh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(zh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Le.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Fe(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Hn.line={uniforms:Ka.merge([Le.common,Le.fog,Le.line]),vertexShader:`
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
		`};var Xs=class extends ri{constructor(e){super({type:"LineMaterial",uniforms:Ka.clone(Hn.line.uniforms),vertexShader:Hn.line.vertexShader,fragmentShader:Hn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Md=new Pt,j0=new N,Q0=new N,yn=new Pt,bn=new Pt,es=new Pt,Sd=new N,wd=new Dt,Mn=new Ha,e_=new N,kh=new _n,Hh=new Di,ts=new Pt,ns,Tr;function t_(i,e,t){return ts.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),ts.multiplyScalar(1/ts.w),ts.x=Tr/t.width,ts.y=Tr/t.height,ts.applyMatrix4(i.projectionMatrixInverse),ts.multiplyScalar(1/ts.w),Math.abs(Math.max(ts.x,ts.y))}function EE(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Mn.start.fromBufferAttribute(s,a),Mn.end.fromBufferAttribute(r,a),Mn.applyMatrix4(t);let c=new N,u=new N;ns.distanceSqToSegment(Mn.start,Mn.end,u,c),u.distanceTo(c)<Tr*.5&&e.push({point:u,pointOnLine:c,distance:ns.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function TE(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;ns.at(1,es),es.w=1,es.applyMatrix4(e.matrixWorldInverse),es.applyMatrix4(n),es.multiplyScalar(1/es.w),es.x*=r.x/2,es.y*=r.y/2,es.z=0,Sd.copy(es),wd.multiplyMatrices(e.matrixWorldInverse,o);for(let f=0,p=u;f<p;f++){if(yn.fromBufferAttribute(l,f),bn.fromBufferAttribute(c,f),yn.w=1,bn.w=1,yn.applyMatrix4(wd),bn.applyMatrix4(wd),yn.z>h&&bn.z>h)continue;if(yn.z>h){let S=yn.z-bn.z,x=(yn.z-h)/S;yn.lerp(bn,x)}else if(bn.z>h){let S=bn.z-yn.z,x=(bn.z-h)/S;bn.lerp(yn,x)}yn.applyMatrix4(n),bn.applyMatrix4(n),yn.multiplyScalar(1/yn.w),bn.multiplyScalar(1/bn.w),yn.x*=r.x/2,yn.y*=r.y/2,bn.x*=r.x/2,bn.y*=r.y/2,Mn.start.copy(yn),Mn.start.z=0,Mn.end.copy(bn),Mn.end.z=0;let _=Mn.closestPointToPointParameter(Sd,!0);Mn.at(_,e_);let m=Ws.lerp(yn.z,bn.z,_),d=m>=-1&&m<=1,M=Sd.distanceTo(e_)<Tr*.5;if(d&&M){Mn.start.fromBufferAttribute(l,f),Mn.end.fromBufferAttribute(c,f),Mn.start.applyMatrix4(o),Mn.end.applyMatrix4(o);let S=new N,x=new N;ns.distanceSqToSegment(Mn.start,Mn.end,x,S),t.push({point:x,pointOnLine:S,distance:ns.origin.distanceTo(x),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var Vh=class extends ut{constructor(e=new No,t=new Xs({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)j0.fromBufferAttribute(t,o),Q0.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+j0.distanceTo(Q0);let r=new zs(s,2,1);return e.setAttribute("instanceDistanceStart",new Yn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Yn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;ns=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Tr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Hh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Tr*.5;else{let h=Math.max(s.near,Hh.distanceToPoint(ns.origin));c=t_(s,h,l.resolution)}if(Hh.radius+=c,ns.intersectsSphere(Hh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),kh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Tr*.5;else{let h=Math.max(s.near,kh.distanceToPoint(ns.origin));u=t_(s,h,l.resolution)}kh.expandByScalar(u),ns.intersectsBox(kh)!==!1&&(n?EE(this,t):TE(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Md),this.material.uniforms.resolution.value.set(Md.z,Md.w))}};var Fo=class extends No{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setPositions(n),this}setColors(e){let t=e.length-3,n=new Float32Array(2*t);for(let s=0;s<t;s+=3)n[2*s]=e[s],n[2*s+1]=e[s+1],n[2*s+2]=e[s+2],n[2*s+3]=e[s+3],n[2*s+4]=e[s+4],n[2*s+5]=e[s+5];return super.setColors(n),this}setFromPoints(e){let t=e.length-1,n=new Float32Array(6*t);for(let s=0;s<t;s++)n[6*s]=e[s].x,n[6*s+1]=e[s].y,n[6*s+2]=e[s].z||0,n[6*s+3]=e[s+1].x,n[6*s+4]=e[s+1].y,n[6*s+5]=e[s+1].z||0;return super.setPositions(n),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var Gh=class extends Vh{constructor(e=new Fo,t=new Xs({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};function n_(i,e=Math.PI/3){let t=Math.cos(e),n=(1+1e-10)*100,s=[new N,new N,new N],r=new N,o=new N,a=new N,l=new N;function c(_){let m=~~(_.x*n),d=~~(_.y*n),M=~~(_.z*n);return`${m},${d},${M}`}let u=i.index?i.toNonIndexed():i,h=u.attributes.position,f={};for(let _=0,m=h.count/3;_<m;_++){let d=3*_,M=s[0].fromBufferAttribute(h,d+0),S=s[1].fromBufferAttribute(h,d+1),x=s[2].fromBufferAttribute(h,d+2);r.subVectors(x,S),o.subVectors(M,S);let P=new N().crossVectors(r,o).normalize();for(let T=0;T<3;T++){let C=s[T],I=c(C);I in f||(f[I]=[]),f[I].push(P)}}let p=new Float32Array(h.count*3),g=new tn(p,3,!1);for(let _=0,m=h.count/3;_<m;_++){let d=3*_,M=s[0].fromBufferAttribute(h,d+0),S=s[1].fromBufferAttribute(h,d+1),x=s[2].fromBufferAttribute(h,d+2);r.subVectors(x,S),o.subVectors(M,S),a.crossVectors(r,o).normalize();for(let P=0;P<3;P++){let T=s[P],C=c(T),I=f[C];l.set(0,0,0);for(let b=0,E=I.length;b<E;b++){let w=I[b];a.dot(w)>t&&l.add(w)}l.normalize(),g.setXYZ(d+P,l.x,l.y,l.z)}}return u.setAttribute("normal",g),u}var AE=.6,RE=25,_i=i=>new N(...i);function i_(i,e,t,n,s,r){let o=[],a=e.length(),l=t.length(),c=e.clone().normalize(),u=t.clone().normalize(),h=(_,m)=>o.push(..._.toArray(),...m.toArray()),f=(_,m)=>i.clone().addScaledVector(c,_).addScaledVector(u,m),p=_=>{let m=[-_,_];for(let d=Math.ceil(-_/n)*n;d<_;d+=n)m.push(d);return m};for(let _ of p(a))h(f(_,-l),f(_,l));for(let _ of p(l))h(f(-a,_),f(a,_));let g=new qt;return g.setAttribute("position",new pt(o,3)),new Eo(g,new _s({color:s,transparent:!0,opacity:r,depthWrite:!1}))}function Wh(i,e,t,n,s=0){let r=_i(i.across),o=_i(i.along),a=_i(i.normal),l=new Ki(2*r.length(),2*o.length(),e),c=new Ji({color:t,transparent:!0,opacity:n,roughness:.9,depthWrite:!1,side:kn}),u=new ut(l,c),h=new Dt().makeBasis(r.normalize(),o.normalize(),a);return u.quaternion.setFromRotationMatrix(h),u.position.copy(_i(i.centre)).addScaledVector(a,-s-.5*e),u.renderOrder=1,u}function CE(i,e){let t=new qt;return t.setAttribute("position",new tn(wn(i.vertices),3)),t.setAttribute("normal",new tn(wn(i.normals),3)),t.setIndex(Array.from(wn(i.triangles))),new ut(t,new Ji({color:e.wall,transparent:!0,opacity:.55,roughness:.85,side:kn}))}function PE(i,e,t){let n=new qt;n.setAttribute("position",new tn(wn(i.vertices),3)),n.setIndex(Array.from(wn(i.triangles)));let s=n_(n,AE),r=t===null?[]:[new Wn(new N(0,0,1),-t)],o=new ut(s,new Ni({colorWrite:!1,transparent:!0,clippingPlanes:r})),a=new ut(s,new Ji({color:e.wall,transparent:!0,opacity:.72,roughness:.85,depthWrite:!1,clippingPlanes:r})),l=new Eo(new Ra(n,RE),new _s({color:e.ink,transparent:!0,opacity:.35,depthWrite:!1,clippingPlanes:r}));return n.dispose(),[o,a,l].forEach((c,u)=>c.renderOrder=3+u),new Jt().add(o,a,l)}function s_(i,e,t=null){let n=new Jt;if(i.kind==="mesh")return i.normals?n.add(CE(i,e)):PE(i,e,t);let s=_i(i.centre),r=_i(i.normal).multiplyScalar(.001),o=(a,l,c)=>i_(s.clone().add(r),_i(i.across),_i(i.along),c,l,a);return i.kind==="ground"?n.add(Wh(i,.004,e.ground,.35),o(.55,e.faint,.25)):i.kind==="mat"?(n.add(Wh(i,i.thickness,e.mat,.2),o(.55,e.mat,.1)),n.add(Wh(i,.04,e.wall,.25,i.thickness))):n.add(Wh(i,.04,e.wall,.22),o(.5,e.wall,.1)),n}function r_(i,e){let t=i.getSize(new N),n=i.getCenter(new N);n.z=i.min.z;let s=r=>Math.max(.8,Math.ceil((.5*r+.4)*4)/4);return i_(n,new N(s(t.x),0,0),new N(0,s(t.y),0),.25,e.faint,.35)}function o_(i,e){let t=_i(i.guide).normalize(),n=[];for(let c=0;c<i.n;c+=Math.max(1,Math.floor(i.n/200)))n.push(t.dot(_i(i.position.subarray(3*c,3*c+3))));let s=Math.min(...n)-.5,r=Math.max(...n)+.5-s,o=new oi(.008,.008,r,12).rotateZ(-Math.PI/2).translate(r/2,0,0),a=new ut(o,new Ji({color:e.metal,transparent:!0,opacity:.5}));a.quaternion.setFromUnitVectors(new N(1,0,0),t);let l=_i(i.position.subarray(0,3));return a.position.copy(l).addScaledVector(t,s-t.dot(l)),a}var Xh=class{constructor(e,t,n){let s=e.impacts,r=s.length?s[0][0]:1/0,o=[],a=[],l=new ct(t.before),c=new ct(t.force),u=new ct(e.colour);this.times=[];let h=-1/0;for(let p=0;p<e.n;p++){let g=e.t[p];if(g-h<.001&&p<e.n-1)continue;h=g,this.times.push(g),o.push(...e.position.subarray(3*p,3*p+3));let _=s.some(([m,d])=>g>=m&&g<=d);a.push(...(_?c:g<r?l:u).toArray())}let f=(p,g)=>{let _=new Fo;_.setPositions(o),_.setColors(a);let m=new Xs({vertexColors:!0,linewidth:g,transparent:!0,opacity:p,depthWrite:!1});m.resolution.copy(n);let d=new Gh(_,m);return d.computeLineDistances(),d};this.whole=f(.3,1.2),this.flown=f(1,2.6),this.group=new Jt,this.group.add(this.whole,this.flown)}show(e){let t=0,n=this.times.length;for(;t<n;){let s=t+n>>1;this.times[s]<=e?t=s+1:n=s}this.flown.geometry.instanceCount=Math.max(t-1,0)}resize(e){this.whole.material.resolution.copy(e),this.flown.material.resolution.copy(e)}},qh=class{constructor(e,t,n){this.level=t,this.group=new Jt,this.arms=e.arms;let s=()=>new Ni({color:"#000000",transparent:!0,opacity:.16,depthWrite:!1}),r=a=>{let l=new ut(new mr(a,36),s());return l.renderOrder=2,this.group.add(l),l};this.body=r(.045),this.cages=e.arms.map(a=>r(a.cage_radius));let o=new qt;o.setAttribute("position",new pt([0,0,0,0,0,1],3)),this.plumb=new pr(o,new _s({color:n.faint,transparent:!0,opacity:.6})),this.group.add(this.plumb),this.turn=new Xn,this.at=new N}show(e){let[t,n,s,r]=e.quaternion;this.turn.set(n,s,r,t);let o=this.level+.003;this.body.position.set(e.position[0],e.position[1],o),this.cages.forEach((a,l)=>{this.at.set(...this.arms[l].direction).multiplyScalar(e.armLengths[l]).applyQuaternion(this.turn),a.position.set(e.position[0]+this.at.x,e.position[1]+this.at.y,o)}),this.plumb.position.set(e.position[0],e.position[1],o),this.plumb.scale.z=Math.max(e.position[2]-o,1e-4)}};function IE(i,e){let t=document.createElement("canvas");t.width=128,t.height=64;let n=t.getContext("2d");n.font="600 40px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle=e,n.fillText(i,64,32);let s=new Ea(t);s.colorSpace=Bn;let r=new wa(new So({map:s,depthTest:!1,transparent:!0}));return r.scale.set(.9,.45,1),r}function a_(i){let e=new Jt;return Object.entries({"x N":[1,0,0],"y W":[0,1,0],"z up":[0,0,1]}).forEach(([n,s])=>{let r=new Va(_i(s),new N,1,i.ink,.28,.16),o=IE(n,i.ink);o.position.set(...s).multiplyScalar(1.38),e.add(r,o)}),e}var LE=(i,e)=>i.map((t,n)=>t+e[n]),l_=(i,e)=>i.kind==="mesh"?{...i,moved:e}:{...i,centre:LE(i.centre,e)},tl=(i,e)=>i.reduce((t,n,s)=>t+n*e[s],0);function c_(i){let e=new Map;for(let t of i){let n=t.kind!=="mesh",s=n?[t.kind,t.thickness,...t.normal,tl(t.normal,t.centre)].map(o=>o.toFixed?o.toFixed(4):o).join():`${t.name} ${t.key} ${t.moved}`,r=e.get(s);e.set(s,r?n?UE(r,t):DE(r,t):t)}return[...e.values()]}function DE(i,e){let[t,n]=[i,e].map(s=>{let r=new _n().setFromArray(wn(s.vertices));return s.triangles.shape[0]+.01*r.getSize(new N).length()});return n>t?e:i}function UE(i,e){let t={...i,centre:i.centre.slice()};for(let n of["across","along"]){let s=Math.hypot(...i[n]),r=i[n].map(u=>u/s),o=Math.abs(tl(r,e.across))+Math.abs(tl(r,e.along)),a=tl(r,e.centre)-tl(r,i.centre),l=Math.min(-s,a-o),c=Math.max(s,a+o);t[n]=r.map(u=>u*(c-l)/2),t.centre=t.centre.map((u,h)=>u+r[h]*(l+c)/2)}return t}var h_=.22,NE=.2,FE=.005,OE=["follow","front","side","top"],Oo=["follow","free","front","side","top","impact"],u_=100,f_=.4,d_=400,p_=i=>Math.max(...i.arms.map(e=>e.length+e.cage_radius));function Ed(i,e,t=!0){let n=i.map(fp),s=e.robots;n.forEach((a,l)=>{let c=!a.arms.some(u=>u.compliant);a.colour=n.length>1?s[l%s.length]:s[c?1:0],a.glow=e.force,a.index=l,a.shift=0});let r=n.map(Wi),o=r.find(a=>a!==null);return r.forEach((a,l)=>{t&&a!==null&&Math.abs(o-a)>FE&&(n[l].shift=o-a)}),n}function Yh(i,{flights:e=[],compare:t="side",align:n=!0,onCamera:s=()=>{},onDrawn:r=()=>{}}={}){let o={compare:t,align:n,magnified:1,camera:"follow",t:0,all:[],hidden:new Set,flights:[],forces:!0,path:!0,estimate:!1,share:1},a=Nn();i.classList.add("picture");let l=document.createElement("div");l.className="force-labels";let c=document.createElement("div");c.className="scene-legend";let u=null;try{u=new Dh({antialias:!0,alpha:!1,powerPreference:"high-performance"})}catch{let Q=document.createElement("p");Q.className="no-graphics",Q.textContent="This browser cannot draw 3-D graphics (WebGL is off); plots and numbers work.",i.append(Q)}let h=new bo,f=new An(38,1,.02,80);f.up.set(0,0,1);let p=new bo,g=new vr(-1.9,1.9,1.9,-1.9,.1,20);g.up.set(0,0,1);let _=new Ba("#ffffff","#9aa4b0",2.1),m=new za("#ffffff",2);m.position.set(-2,-3,5),h.add(_,m);let d=null,M=new Jt,S=[],x=0,P=0,T=-1/0,C=0,I=0,b=new Fe(1,1);if(u){u.localClippingEnabled=!0,i.append(u.domElement,l,c),u.domElement.setAttribute("role","img"),u.domElement.setAttribute("aria-label","The flight in three dimensions, with numbers beside it."),d=new Fh(f,u.domElement),d.enableDamping=!1,d.minDistance=.15,d.maxDistance=30,d.addEventListener("change",E);let Q=!1;d.addEventListener("start",()=>Q=!0),d.addEventListener("end",()=>Q=!1),d.addEventListener("change",()=>{Q&&o.camera!=="follow"&&s("")})}function E(){!u||x||(P=performance.now(),x=requestAnimationFrame(z))}function w(){let Q=performance.now(),se=P-T<d_;T=Q,clearTimeout(C),se&&(I=.7*I+.3*(Q-P)),I>u_&&o.share>f_&&(o.share=Math.max(f_,.7*o.share),I=.5*u_),O(se?o.share:1),se&&o.share<1&&(C=setTimeout(E,d_))}function O(Q){let se=Math.min(devicePixelRatio||1,2)*Q;Math.abs(u.getPixelRatio()-se)>.001&&u.setPixelRatio(se)}function z(){x=0,!(!u||!i.clientWidth||!i.clientHeight)&&(w(),V(),r())}function V(){let Q=i.clientWidth,se=i.clientHeight;u.setViewport(0,0,Q,se),u.setScissorTest(!1),u.setClearColor(a.background,1),u.render(h,f);let fe=Math.min(104,.24*Math.min(Q,se));g.position.copy(f.position).sub(d.target).setLength(6),g.up.copy(f.up),g.lookAt(0,0,0),u.autoClear=!1,u.clearDepth(),u.setViewport(6,6,fe,fe),u.render(p,g),u.autoClear=!0,le(Q,se)}function W(){let Q=o.flights[0].obstacles.find(fe=>fe.kind==="wall"||fe.kind==="mat"),se=Q&&Math.abs(Q.normal[2])<.9?new N(...Q.across).normalize():new N(0,1,0);return se.y<0?se.negate():se}let q=()=>W().applyAxisAngle(f.up,-Math.PI/2);function U(){if(o.compare!=="side")return o.flights.map(()=>[0,0,0]);let Q=W(),se=Math.max(...o.flights.map(p_)),fe=.5*(o.flights.length-1);return o.flights.map((Pe,te)=>Q.clone().multiplyScalar((fe-te)*(2*se+NE)).toArray())}function B(Q,{keepCamera:se=!0}={}){a=Nn(),o.all=Ed(Q,a,o.align),o.flights=o.all.filter((fe,Pe)=>!o.hidden.has(Pe)),u&&K(),se||de(o.camera),Re(o.t)}function K(){el(M),M=new Jt,h.add(M),p.children.slice().forEach(el),p.add(a_(a)),l.replaceChildren();let Q=U(),se=new _n,fe=Math.max(...o.flights.map(fu),0),Pe=fe>0?h_/du(fe):0;o.floor=ne(Q),S=o.flights.map((Ne,Ye)=>{let L=new Jt;L.position.set(...Q[Ye]),M.add(L);let y=Ye>0&&o.compare==="ghost",H=new Qa(Ne,{colour:Ne.colour,opacity:y?.35:1},a),re=new Xh(Ne,a,b),pe=[...Ne.arms,...Ne.hull].map(()=>new Oh(a.force,.007,y?.4:.95)),he=new qh(Ne,o.floor,a);he.group.visible=!y||o.flights.length===2;let He=Or(Ne)?new Qa(Ne,{colour:a.ink,opacity:.35},a):null;He&&L.add(He.group),L.add(H.group,re.group,he.group,...pe.map(ge=>ge.group)),Ne.guide.length&&L.add(o_(Ne,a));let Me=new _n,Ve=Math.max(1,Math.floor(Ne.n/400));for(let ge=0;ge<Ne.n;ge+=Ve)Me.expandByPoint(new N(...Ne.position.subarray(3*ge,3*ge+3)));se.union(Me.translate(L.position));let Oe=[...Ne.arms,...Ne.hull].map(()=>{let ge=document.createElement("span");return l.append(ge),ge});return{flight:Ne,group:L,robot:H,estimate:He,path:re,arrows:pe,shadow:he,scale:Pe,names:Oe,ghost:y,contacts:[]}});let te=o.flights.flatMap((Ne,Ye)=>Ne.obstacles.map(L=>l_(L,Q[Ye]))),ve=te.some(Ne=>Ne.kind==="ground")?o.floor:null;c_(te).forEach(Ne=>{let Ye=s_(Ne,a,ve);Ye.position.set(...Ne.moved??[0,0,0]),M.add(Ye)}),o.box=se.clone(),ve===null&&(se.min.z=o.floor,M.add(r_(se,a))),ee()}function ne(){let Q=Math.max(...o.flights.flatMap(fe=>fe.obstacles.filter(Pe=>Pe.kind==="ground").map(Pe=>Pe.centre[2])));if(Number.isFinite(Q))return Q;let se=1/0;for(let fe of o.flights)for(let Pe=2;Pe<3*fe.n;Pe+=3)se=Math.min(se,fe.position[Pe]);return se-.45}function ee(){let Q=Math.max(...o.flights.map(fu),0);c.replaceChildren();let se=(Pe,te)=>{let ve=document.createElement("span");ve.className=`key ${Pe}`,ve.textContent=te,c.append(ve)};if(o.flights.length>1&&o.flights.forEach(Pe=>{se("robot",Pe.label),c.lastChild.style.setProperty("--colour",Pe.colour)}),o.estimate&&o.flights.some(Or)&&se("estimate","estimated pose"),Q>0&&o.forces){let Pe=du(Q);se("force",`contact force on a cage or the main body, ${Pe} N is ${100*h_} cm`)}o.flights.some(Pe=>Pe.thrust.some(te=>te>0))&&se("thrust","thrust");let fe=new Set(o.flights.flatMap(Pe=>Pe.obstacles.map(te=>te.kind==="mesh"?te.name:te.kind)));o.magnified!==1&&se("travel",`arm travel × ${o.magnified}, not to scale`),fe.has("mat")&&se("mat","mat"),[...fe].filter(Pe=>!["wall","mat","ground"].includes(Pe)).forEach(Pe=>se("own",Pe))}function le(Q,se){let fe=new N,Pe=[];for(let te of S)te.names.forEach((ve,Ne)=>{let Ye=te.contacts[Ne];if(ve.hidden=te.ghost||!o.forces||!Ye||Ye.size<.5,ve.hidden)return;fe.set(...Ye.point).addScaledVector(new N(...Ye.force),te.scale),fe.add(te.group.position).project(f),ve.hidden=fe.z>1||Math.abs(fe.x)>1||Math.abs(fe.y)>1,ve.textContent=`${Ye.size.toFixed(Ye.size<10?1:0)} N`;let L=Math.min(Math.max((fe.x+1)/2*Q,24),Q-24),y=Math.min(Math.max((1-fe.y)/2*se-12,10),se-10);ve.hidden=Pe.some(([H,re])=>Math.abs(H-L)<50&&Math.abs(re-y)<18),!ve.hidden&&(Pe.push([L,y]),ve.style.transform=`translate(${L}px, ${y}px) translate(-50%, -50%)`)})}let ce=null;function ye(){let Q=S.map(se=>se.robot.group.position.clone().add(se.group.position));return Q.reduce((se,fe)=>se.add(fe),new N).divideScalar(Q.length||1)}function Re(Q){if(o.t=Q,o.poses=o.flights.map(se=>qo(se,Q)),S.forEach((se,fe)=>{let Pe=o.poses[fe];se.robot.show(Pe,o.magnified),se.path.group.visible=o.path,se.path.show(Pe.own),se.estimate&&(se.estimate.group.visible=o.estimate,o.estimate&&se.estimate.show(uu(se.flight,Q),o.magnified)),se.shadow.show(Pe),se.contacts=Pe.contacts,se.arrows.forEach((te,ve)=>{let Ne=Pe.contacts[ve];Ne&&o.forces?te.show(Ne.point,Ne.force.map(Ye=>se.scale*Ye)):te.hide()})}),u&&S.length&&OE.includes(o.camera)){let se=ye();if(ce){let fe=se.clone().sub(ce);f.position.add(fe),d.target.add(fe)}ce=se,d.update()}E()}function j(Q){let se=Ws.degToRad(f.fov/2),fe=Math.min(1,f.aspect);return Q/Math.sin(Math.atan(Math.tan(se)*fe))}function X(Q,se){d.target.copy(Q),f.position.copy(Q).add(se),d.update()}function de(Q){if(o.camera=Oo.includes(Q)?Q:"follow",ce=null,s(o.camera),!u||!S.length)return;let se=Math.max(...o.flights.map(p_)),fe=S.map(re=>re.group.position),Pe=fe[0].distanceTo(fe[fe.length-1])/2,te=se+Pe+.1,ve=fe.length>2&&Pe>0,Ne=ve?Math.max(j(se+.2),te/(Math.tan(Ws.degToRad(f.fov/2))*f.aspect)+se):j(te),Ye=o.box.clone().expandByScalar(se+.1),L=Ye.getCenter(new N),y=.5*Ye.getSize(new N).length(),H=ve?q().negate().addScaledVector(W(),-.25).setZ(.5).normalize():new N(-.62,-.66,.42).normalize();if(o.camera==="free")X(L,H.clone().multiplyScalar(j(y)));else if(o.camera==="impact")X(Ae(),ve?H.clone().multiplyScalar(Ne):new N(-.45,-.62,.5).normalize().multiplyScalar(j(te+.05)));else{ce=ye();let re={follow:H,front:q().setZ(.12),side:W().negate().setZ(.12),top:new N(0,-.001,1)}[o.camera];X(ce.clone(),re.clone().normalize().multiplyScalar(o.camera==="side"?j(te):Ne))}E()}function Ae(){let Q=o.flights.map((se,fe)=>{let Pe=qo(se,Wi(se)??se.begin);return new N(...Pe.position).add(S[fe].group.position)});return Q.reduce((se,fe)=>se.add(fe),new N).divideScalar(Q.length)}function xe(){if(!u)return;let Q=i.clientWidth,se=i.clientHeight;if(!Q||!se)return;O(1),u.setSize(Q,se,!1);let fe=f.aspect;f.aspect=Q/se,f.updateProjectionMatrix(),b.set(Q,se),S.forEach(Pe=>Pe.path.resize(b)),Math.abs(fe/f.aspect-1)>.15&&de(o.camera),E()}let Ke=new ResizeObserver(xe);Ke.observe(i);let mt=matchMedia("(prefers-color-scheme: dark)"),k=()=>B(o.all);mt.addEventListener("change",k);function ue(){Ke.disconnect(),mt.removeEventListener("change",k),cancelAnimationFrame(x),clearTimeout(C),el(M),p.children.slice().forEach(el),d?.dispose(),u?.dispose(),i.replaceChildren()}return xe(),e.length&&B(e,{keepCamera:!1}),{show:Re,replace:B,setCamera:de,resize:xe,dispose:ue,setCompare(Q){o.compare=Q,o.flights.length&&B(o.all,{keepCamera:!1})},setShown(Q,se){if(typeof Q!="number"){o[Q]=se,ee(),Re(o.t);return}se?o.hidden.delete(Q):o.hidden.add(Q),B(o.all,{keepCamera:!1})},canvas(Q=!0){return Q&&u&&(O(1),V()),u?.domElement??null},setMagnified(Q){o.magnified=Q,ee(),Re(o.t)},get flights(){return o.flights},get all(){return o.all},get camera(){return o.camera},pose:()=>({t:o.t,camera:o.camera,pixels:o.share,flights:o.poses??[],estimates:o.estimate?o.flights.map(Q=>Or(Q)?uu(Q,o.t):null):[]}),memory:()=>({...u?.info.memory})}}var BE={follow:"Follow",free:"Whole flight",front:"Front",side:"Side",top:"Top",impact:"Impact"},zE={1:"front",2:"side",3:"top",4:"follow",5:"free",6:"impact",0:"follow"},kE=[["space","play, pause"],["← →","one instant back, forth; with shift ten"],[", .","slower, faster"],["t","to the first touch"],["Home End","to the start, to the end"],["1 2 3","view from the front, from the side, from above"],["4 5 6","follow, whole flight, impact"],["0","the view as it was at first"],["e","estimated pose, on and off"],["f","full screen"],["p","save a picture"],["l","copy a link to this instant and view"],["a click in a plot","goes to that instant"],["a drag in a plot","zooms: along the time, the values, or both"],["a double click in a plot","shows everything"],["Escape","undoes the last zoom"],["?","these keys"]],Td="springback.plots",HE=8e3;function m_(i,e){let t=G("div",{class:"stage"}),n=G("div"),s=G("div",{class:"readouts"}),r=G("div"),o=G("p",{class:"remark",role:"status",hidden:!0}),a=!1,l=null,c=null,u=Yh(t,{flights:e.flights,onCamera:ue=>(l?.mark(ue),xe()),onDrawn:()=>c?.drawn()}),h=u.all,f=h.length>1,p=[...new Set(h.map(ue=>ue.scenario))],g=p.length>2?`${h.length} flights`:p.join(" and ");function _(ue){o.textContent=ue,o.hidden=!1,clearTimeout(_.ends),_.ends=setTimeout(()=>o.hidden=!0,HE)}let m=h.map((ue,Q)=>GE(ue,f&&(se=>I(Q,se))));l=bi("Camera",Oo.map(ue=>[ue,BE[ue]]),"follow",ue=>u.setCamera(ue));let d=bi("Flights",[["side","side by side"],["ghost","overlaid"]],"side",ue=>(u.setCompare(ue),xe())),M=h.some(ue=>ue.arms.some(Q=>Q.compliant)),S=bi("Arm travel",[["1","arms to scale"],["10","arm travel × 10"]],"1",ue=>(u.setMagnified(Number(ue)),xe())),x={forces:["Forces",!0],path:["Path",!0],...h.some(Or)?{estimate:["Estimate",!1]}:{}},P=Object.fromEntries(Object.entries(x).map(([ue,[Q,se]])=>[ue,Qd(Q,se,fe=>(u.setShown(ue,fe),xe()),ue==="estimate"?"The pose that the pilot estimates, as a grey ghost (E)":"")])),T=G("div",{class:"choice",role:"group","aria-label":"Show"},...Object.values(P)),C=()=>h.flatMap((ue,Q)=>m[Q].shown?[]:[Q+1]);function I(ue,Q){if(!Q&&C().length===h.length-1)return _("One flight is always shown.");m[ue].mark(Q),u.setShown(ue,Q),de.replace(),xe()}let b=Zm(r,{onSeek:ue=>(de.pause(),de.seek(ue)),onZoom:()=>(U(),xe()),onEdit:ue=>E.open(b.wanted,ue),onRemove:ue=>B(b.wanted.filter((Q,se)=>se!==ue))}),E=gp({signals:ul(h),standard:js(h),onChoose:B}),w=h.find(ue=>Wi(ue)!==null),O=()=>{let[ue,Q]=w.impacts[0].map(fe=>fe+w.shift),se=.35*Math.min(Q-ue,.2)+.004;return[ue-se,Math.min(Q,ue+.3)+2*se]},z=ue=>!!(w&&ue)&&ue.every((Q,se)=>Math.abs(Q-O()[se])<1e-9),V=bi("Plots show",[["all","whole flight"],...w?[["impact","first impact"]]:[]],"all",ue=>ue==="all"?b.zoom():b.zoom(...O())),W=G("button",{type:"button",class:"undo",title:"Undo the last zoom (Escape)",disabled:!0,"aria-label":"Undo the last zoom",onclick:()=>b.back()},Gi("undo")),q=G("button",{type:"button",class:"adding",title:"Choose plots and signals",onclick:()=>E.open(b.wanted)},"Plots …");function U(){let{range:ue,heights:Q}=b.zoomed,se=!Object.keys(Q).length;V.mark(se&&!ue?"all":se&&z(ue)?"impact":""),W.disabled=!b.canGoBack}function B(ue){b.choose(ue);try{ue?localStorage.setItem(Td,$o(ue)):localStorage.removeItem(Td)}catch{}xe()}let K=G("dialog",{class:"keys","aria-label":"Keys and mouse"},G("h2",{},"Keys and mouse"),G("table",{},...kE.map(([ue,Q])=>G("tr",{},G("th",{scope:"row"},ue),G("td",{},Q)))),G("form",{method:"dialog"},G("button",{class:"main"},"Close"))),ne=(ue,Q,se,fe)=>G("button",{type:"button",class:`tool tool-${ue}`,title:`${Q}${fe?` (${fe})`:""}`,"aria-label":Q,onclick:se},Gi(ue)),ee=ne("film","Record a film from here",()=>c.film()),le=G("div",{class:"left"},t,n),ce=dl(()=>le,()=>_("This browser refuses full screen.")),ye=G("div",{class:"tools"},ne("link","Copy a link to this instant and view",Re,"L"),ne("picture","Save a picture",()=>c.picture(),"P"),ee,ce.button,ne("help","Keys and mouse",()=>K.showModal(),"?"));async function Re(){let ue=Ae.address();try{await navigator.clipboard.writeText(ue),_("The link is copied.")}catch{_("The address of this page is now a link to this instant and view.")}}let X={...Object.fromEntries(Object.entries(zE).map(([ue,Q])=>[ue,()=>u.setCamera(Q)])),f:ce.toggle,p:()=>c.picture(),l:Re,"?":()=>K.showModal(),e:()=>P.estimate?.click(),Escape:()=>b.back()};i.replaceChildren(G("header",{class:"top"},G("div",{class:f?"flights several":"flights"},G("h1",{},g),...m.map(ue=>ue.element)),G("div",{class:"views"},l,...f?[d]:[],...M?[S]:[],T)),G("main",{},le,G("aside",{},s,G("div",{class:"plot-head"},G("h2",{},"Over time"),V,W,q),r,WE(h))),E.element,K),t.append(o),i.classList.add("replay");let de=Cl({scene:u,plots:b,bar:n,readouts:s,actions:X,onRest:()=>(c?.rested(),xe())});c=tp({scene:u,stage:t,player:de,say:_,name:g.replace(/[^\p{L}\p{N}]+/gu,"-").slice(0,60),onRecording:ue=>{ee.classList.toggle("recording",ue),ee.setAttribute("aria-label",ue?"End the film":"Record a film from here")}}),n.querySelector(".buttons").append(ye),de.replace({keepTime:!1}),w&&b.restore({range:O(),heights:{}}),U(),u.setCamera("follow");let Ae=_p({read:Ke,apply:mt});function xe(){a&&!de.playing&&Ae.renew()}function Ke(){let{range:ue}=b.zoomed;return{t:de.time.toFixed(6).replace(/0+$/,"").replace(/\.$/,""),camera:u.camera==="follow"?"":u.camera,speed:de.pace==="auto"?"":de.pace,arms:S.chosen==="10"?"10":"",compare:d.chosen==="ghost"?"ghost":"",hide:C().join(),layers:Object.keys(x).filter(Q=>P[Q].on!==x[Q][1]).join(),zoom:z(ue)||!ue&&!w?"":ue?ue.map(Q=>Q.toFixed(6)).join():"all",plots:$o(b.wanted)===$o(js(h))?"":$o(b.wanted)}}function mt(ue){let Q=Pe=>Pe.split(",").map(Number);if(ue.hide){let Pe=Q(ue.hide);h.every((te,ve)=>Pe.includes(ve+1))||h.forEach((te,ve)=>m[ve].shown===Pe.includes(ve+1)&&I(ve,!Pe.includes(ve+1)))}ue.compare==="ghost"&&f&&d.press("ghost"),ue.arms==="10"&&M&&S.press("10");let se=(ue.layers??"").split(",");for(let Pe of Object.keys(x))se.includes(Pe)&&P[Pe].on===x[Pe][1]&&P[Pe].click();Oo.includes(ue.camera)&&u.setCamera(ue.camera);let fe=ue.plots?pu(ue.plots,h):[];fe.length&&b.choose(fe),ue.zoom==="all"?b.restore({range:null,heights:{}}):ue.zoom&&b.restore({range:Q(ue.zoom),heights:{}}),(ue.speed==="auto"||Number(ue.speed)>0)&&de.setPace(ue.speed),ue.t&&Number.isFinite(Number(ue.t))&&de.seek(Number(ue.t))}let k=VE(h);return k.length&&b.choose(k),Ae.follow(),a=!0,window.springback={scene:u,player:de,plots:b,link:Ae,pose:()=>({...u.pose(),playing:de.playing,pace:de.pace})},matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{h.forEach((ue,Q)=>m[Q].element.style.setProperty("--colour",ue.colour)),de.replace()}),window.springback}function VE(i){try{return pu(localStorage.getItem(Td)??"",i)}catch{return[]}}function GE(i,e){let t={shown:!0},n=e?G("button",{type:"button",class:"flight","aria-pressed":"true",title:"Hide or show this flight",onclick:()=>e(!t.shown)},i.label):G("b",{},i.label);return t.element=G("p",{class:`outcome ${i.success?"well":"badly"}`},n,G("span",{},` ${i.sentence}`)),t.element.style.setProperty("--colour",i.colour),t.mark=s=>{t.shown=s,n.setAttribute("aria-pressed",String(s)),t.element.classList.toggle("away",!s)},t}function WE(i){let e=i.flatMap(s=>[...s.notes.map(r=>`${s.label}: ${r}.`),s.shift?`${s.label} is shown ${Math.abs(s.shift).toFixed(3)} s ${s.shift<0?"earlier":"later"} than it flew, so that all touch at the same time.`:""]),t=Math.max(...i.map(s=>s.departure.position))*1e3;e.push(`Motion between the drawn instants is interpolated linearly: positions are within ${t<.01?"0.01":t.toFixed(2)} mm of the flight.`);let n=Math.max(...i.map(s=>s.every));return e.push("Signals that you choose are rounded to 1/65534 of their range."),n>1&&e.push(`Telemetry is shown at every tick near impacts and changes of phase, elsewhere at one tick in ${n}.`),G("details",{class:"about"},G("summary",{},"About this view"),...[...new Set(e)].filter(Boolean).map(s=>G("p",{},s)),G("p",{},"World axes: x north, y west, z up. Yellow arrows are the contact forces on cages and main body, including friction; the numbers show their vector sum, in which friction on two cages may cancel. Blue bars are the thrust of the rotors; dark discs are vertical shadows."))}var Ad=1e3,__=(i,e)=>Number((Math.round(i/e)*e).toFixed(6));function nl(i,e){let{least:t,most:n,logarithmic:s}=i,r=s?Math.log(e/t)/Math.log(n/t):(e-t)/(n-t);return Math.min(Math.max(r,0),1)}function g_(i,e){let{least:t,most:n,step:s,logarithmic:r}=i,o=r?t*(n/t)**e:t+(n-t)*e,a=r?10**Math.max(Math.floor(Math.log10(o))-1,Math.log10(s)):s;return Math.min(Math.max(__(o,Math.max(a,s)),t),n)}function XE(i,e){let t=`set-${i.name}`,n=i.unit.replace("^1.5","¹·⁵"),s=G("input",{type:"range",min:0,max:Ad,step:1,id:`${t}-slider`,"aria-label":i.label,oninput:()=>h(g_(i,Number(s.value)/Ad),{moving:!0}),onchange:()=>e(i.name,r.value,{settled:!0}),onkeydown:g=>{let _={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[g.key];if(!_)return;g.preventDefault();let m=Number(r.value);Number.isFinite(m)&&h(Math.min(Math.max(__(m+_*i.step,i.step),i.least),i.most),{settled:!0})}}),r=G("input",{type:"text",inputmode:"decimal",id:t,autocomplete:"off",spellcheck:"false",maxlength:40,"aria-describedby":`${t}-words`,oninput:()=>e(i.name,r.value.trim(),{typing:!0}),onchange:()=>e(i.name,r.value.trim(),{settled:!0})}),o=G("p",{class:"words",id:`${t}-words`}),a=G("div",{class:"marks"},...i.marks.map((g,_)=>{let m=S=>String(S.value).length*.013+.01,d=i.marks.some((S,x)=>x<_&&Math.abs(nl(i,S.value)-nl(i,g.value))<m(S)+m(g)),M=G("button",{type:"button",class:d?"tight":"",title:`${g.value} ${n}, ${g.words}`,"aria-label":`${i.label} ${g.value} ${n}, ${g.words}`,onclick:()=>h(g.value,{settled:!0})},G("span",{},String(g.value)));return M.style.setProperty("--share",nl(i,g.value)),M})),l=G("div",{class:"slider-control","data-name":i.name},G("label",{for:t},i.label),G("span",{class:"field"},r,G("span",{class:"unit"},n)),G("div",{class:"rail"},s,a),o);function c(g){let _=Number(g);r.value.trim()!==String(g)&&(r.value=String(g)),Number.isFinite(_)&&(s.value=Math.round(nl(i,_)*Ad),s.setAttribute("aria-valuetext",`${g} ${n}`)),f("")}function u(){let g=i.marks.find(_=>_.value===Number(r.value));o.className=g?"words printed":"words",o.textContent=g?`= ${g.words}`:i.explains}function h(g,_){c(g),e(i.name,String(g),_)}function f(g){r.setAttribute("aria-invalid",String(!!g)),l.classList.toggle("wrong",!!g),g?o.textContent=g:u()}return l.title=i.explains,{element:l,show:c,tellProblem:f,pick:g=>h(g_(i,nl(i,g)),{settled:!0})}}function qE(i){let e=G("p",{class:"words"},i.explains);return{element:G("div",{class:"fixed-control","data-name":i.name},G("span",{class:"label"},i.label),e),show:()=>{},tellProblem:s=>e.textContent=s||i.explains}}function YE(i,e){let t=Object.keys(i.words).length>3,n=G("p",{class:"words"},i.explains),s=a=>e(i.name,a,{settled:!0});if(!t){let a=bi(i.label,Object.entries(i.words),i.default,s);return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("span",{class:"label"},i.label),a),show:a.mark,tellProblem:()=>{}}}let r=G("select",{id:`set-${i.name}`,onchange:()=>s(r.value)},...Object.entries(i.words).map(([a,l])=>G("option",{value:a},l)));return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("label",{for:`set-${i.name}`},i.label),r,n),show:a=>r.value=a,tellProblem:a=>n.textContent=a||i.explains}}var $E={slider:XE,fixed:qE,choice:YE};function v_(i,e){let t={},n={},s=new Map,r=(g,_,m)=>{t[g]=_,l(),e(g,_,m)};for(let g of i)t[g.name]=String(g.default),n[g.name]=$E[g.kind](g,r),s.has(g.group)||s.set(g.group,[]),s.get(g.group).push(n[g.name].element);let o=[...s].map(([g,_])=>G("section",{},...g?[G("h2",{},g)]:[],..._)),a=G("form",{class:"controls",onsubmit:g=>g.preventDefault()},...o);function l(){for(let g of i){let _=Object.entries(g.when).every(([m,d])=>d.includes(t[m]));n[g.name].element.hidden=!_}o.forEach(g=>g.hidden=![...g.querySelectorAll("[data-name]")].some(_=>!_.hidden))}function c(g){for(let[_,m]of Object.entries(g))t[_]=String(m),n[_]?.show(m);l()}function u(g){for(let _ of Object.values(n))_.tellProblem("");for(let _ of g){let m=_.split(":")[0],d=m in n?m:i.find(M=>M.path===m)?.name;n[d]?.tellProblem(_.slice(m.length+1).trim())}}let h=()=>i.filter(g=>t[g.name]!==String(g.default)).map(g=>`${g.name}=${encodeURIComponent(t[g.name])}`).join("&");return l(),{element:a,values:t,query:h,show:c,tellProblems:u,isShown:g=>!n[g].element.hidden,pick:(g,_)=>n[g].pick(_)}}function x_(i,e){let t=null,n=!1,s=0;function r(l,c){clearTimeout(s),t={query:l,how:c},n||o()}async function o(){let{query:l,how:c}=t;t=null,n=!0;try{await a(l,c)}catch{t||e.gone()}n=!1,t&&o()}async function a(l,c){let u=await fetch(`flight?${l}`,{headers:{"x-lab-page":i}}),h=await u.json();u.ok?e.answered(h,c):u.status===503?(h.preparing&&e.waits(h.preparing),s=setTimeout(()=>r(l,{...c,since:performance.now()}),700)):!h.overtaken&&!t&&e.refused(h.errors,c)}return{ask:r}}var y_=100,$h="Energy",b_=[-.01,.13],ZE={motion:["#0072b2",.85],"arm springs":["#56b4e9",.85],"end stops":["#cc79a7",.85],contact:["#009e73",.85],"lost in arms":["#e69f00",.6],"lost in contact":["#d55e00",.6],"lost in friction":["#8c8c8c",.6],"lost in stops":["#cc79a7",.4],"lost in locking":["#444444",.4],"lost to air":["#bbbbbb",.4]},M_=(i,e)=>i+Math.round(255*e).toString(16).padStart(2,"0");function Rd(i,e=[1,1.5,2,3,5,7,10]){if(!(i>0))return 1;let t=10**Math.floor(Math.log10(i));return t*e.find(n=>n*t>=i*.999999)}function Cd(i,e,t,{moving:n=!1,locked:s=!1}={}){if(i&&s)return i;let r=[e<-1e-9?-Rd(-e):0,t>1e-9?Rd(t):e<-1e-9?0:1],[o,a]=i??r,l=e>=o&&t<=a&&(n||t-e>.3*(a-o));return i&&l?i:n?[Math.min(o,r[0]),Math.max(a,r[1])]:r}function KE(i,e,t){let n=0,s=0;for(let{t:r,values:o}of i)for(let a=0;a<o.length;a++)r[a]<e||r[a]>t||(o[a]<n&&(n=o[a]),o[a]>s&&(s=o[a]));return[n,s]}function JE(i,e){let t=new Map,n=(a,l,c)=>{t.has(a)||t.set(a,{name:a,unit:l,curves:[],stacked:a.startsWith($h)}),t.get(a).curves.push(c)},s=(a,l)=>{let c=Array.from(a.t,h=>h+a.shift),u=null;for(let h of a.series)if(h.panel===$h){if(l)continue;u=Array.from(h.values,(g,_)=>g+(u?u[_]:0));let[f,p]=ZE[h.name]??["#8c8c8c",.5];n(`${$h}, ${a.label}`,h.unit,{name:h.name,t:c,values:u,colour:f,fill:M_(f,p),flight:a})}else n(h.panel,h.unit,{name:l?`${a.label}, pinned`:a.label,t:c,values:Array.from(h.values),flight:a,colour:l?M_(a.colour,.75):a.colour,dash:l?[3,3]:a.dash,behind:l})};i.forEach((a,l)=>{a.dash=l?[8,3]:[],s(a,!1)}),e.forEach(a=>s(a,!0));let r=i.map(a=>`${$h}, ${a.label}`),o=a=>["Acceleration","Arm compression",...r,"Velocity","Contact force"].indexOf(a.name);return[...t.values()].sort((a,l)=>o(a)-o(l))}function S_(i,{onSeek:e}){let t=new Map,n=[],s=[],r=0,o=null,a=!1;i.classList.add("plots");function l(_,{whole:m=!1,moving:d=!1}={}){s=_;let M=Wi(_[0]),[S,x]=[_[0].begin,_[0].end];o=m||M===null?[S,x]:[M+b_[0],Math.min(M+b_[1],x)];let P=M??0,T=JE(_,n);for(let[C,I]of t)T.some(b=>b.name===C&&c(b,m)===I.signature)||(I.plot.destroy(),I.box.remove(),t.delete(C));for(let C of T){let I=t.get(C.name)??h(C,m);I.panel=C,I.zero=P,I.bounds=Cd(I.bounds,...KE(C.curves,...o),{moving:d,locked:a}),I.plot.batch(()=>{I.plot.setData(u(C),!1),I.plot.setScale("x",{min:o[0],max:o[1]}),I.plot.setScale("y",{min:I.bounds[0],max:I.bounds[1]})}),i.append(I.box)}p(r)}let c=(_,m)=>`${m} ${_.curves.map(d=>`${d.name} ${d.colour}`).join()}`;function u(_){let d=_.curves.every(M=>M.flight===_.curves[0].flight)?[_.curves[0].t,..._.curves.map(M=>M.values)]:$t.join(_.curves.map(M=>[M.t,M.values]));return _.stacked?[d[0],...d.slice(1).reverse()]:d}function h(_,m){let d=Nn(),M=!_.stacked||_.curves[0].flight===s[0],S=_.curves.filter(()=>M).map(w=>{let O=document.createElementNS("http://www.w3.org/2000/svg","svg");O.setAttribute("viewBox","0 0 22 8"),O.setAttribute("aria-hidden","true");let z=document.createElementNS("http://www.w3.org/2000/svg","line"),V={x1:0,x2:22,y1:4,y2:4,stroke:w.fill??w.colour,"stroke-width":w.fill?8:2.4,"stroke-dasharray":(w.dash??[]).join(" ")};return Object.entries(V).forEach(([W,q])=>z.setAttribute(W,q)),O.append(z),G("span",{class:"plot-key"},O,G("span",{},w.name))}),x=G("div",{class:"plot-canvas"}),P=G("section",{class:"plot","data-panel":_.name},G("header",{},G("h3",{},`${_.name} [${_.unit}]`),G("div",{class:"plot-keys"},...S)),x);i.append(P);let T={box:P,canvas:x,panel:_,signature:c(_,m),bounds:null,zero:0},C={stroke:d.faint,grid:{stroke:d.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},I=_.stacked?[..._.curves].reverse():_.curves,b=(w,O)=>O.map(z=>String(m?+z.toFixed(3):Math.round(1e3*(z-T.zero)))),E=(w,O,z,V)=>jE(z,V,T.zero,m);return T.plot=new $t({width:Math.max(x.clientWidth,200),height:y_,padding:[6,10,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[{...C,size:22,gap:2,values:b,splits:E},{...C,size:46,gap:4,space:24}],series:[{},...I.map(w=>({stroke:w.colour,width:w.fill?1:w.behind?1.4:1.8,dash:w.dash??[],fill:w.fill,spanGaps:!0,points:{show:!1}}))],hooks:{draw:[()=>f(T)]},bands:_.stacked?I.slice(1).map((w,O)=>({series:[O+1,O+2],fill:I[O].fill})):[]},u(_),x),T.marker=G("div",{class:"plot-now"}),T.plot.over.append(T.marker),T.plot.over.addEventListener("click",w=>e(T.plot.posToVal(w.offsetX,"x"))),t.set(_.name,T),T}function f({plot:_,marker:m}){if(!m)return;let{min:d,max:M}=_.scales.x;m.hidden=!(r>=d&&r<=M),m.style.transform=`translateX(${_.valToPos(r,"x")}px)`}function p(_){r=_,t.forEach(f)}function g(){for(let{plot:_,canvas:m}of t.values()){let d=m.clientWidth;d&&Math.abs(d-_.width)>1&&_.setSize({width:d,height:y_})}p(r)}return new ResizeObserver(g).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{t.forEach(({plot:_,box:m})=>(_.destroy(),m.remove())),t.clear()}),{replace:l,show:p,pin(_){n=_},lock(_){a=_},bounds:_=>t.get(_)?.bounds,curve:_=>t.get(_)?.panel.curves.map(m=>({name:m.name,peak:m.values.reduce((d,M)=>Math.max(d,M),0),points:m.values.length})),get flights(){return s}}}function jE(i,e,t,n){let s=n?Rd((e-i)/8,[1,2,5,10]):.02,r=[];for(let o=Math.ceil((i-t*!n)/s);;o++){let a=o*s+(n?0:t);if(a>e)return r;r.push(a)}}var w_=150,QE=700,eT=40;function E_(i,{choices:e,table:t,page:n,isShown:s,onPick:r,onChoice:o}){let a=new Map,l=null,c=null,u=null,h=null,f=0,p="",g=G("select",{id:"sweep-of","aria-label":"Control to sweep",onchange:T}),_=G("select",{id:"sweep-measure","aria-label":"Measure of the sweep",onchange:T},...e.measures.map(U=>G("option",{value:U.name},U.label)));_.value="impact_peak_acceleration";let m=G("div",{class:"plot-canvas"}),d=G("h3"),M=G("p",{class:"words",role:"status"});i.classList.add("sweep"),i.replaceChildren(G("div",{class:"sweep-head"},G("h2",{},"Sweep"),g,_),d,m,M),P();let S=U=>t.find(B=>B.name===U),x=()=>e.measures.find(U=>U.name===_.value);function P(){let U=g.value,B=e.controls.filter(ne=>s(ne.name)||ne.name===U),K=["",...B.map(ne=>ne.name)].join();g.dataset.names!==K&&(g.dataset.names=K,g.replaceChildren(G("option",{value:""},"off"),...B.map(ne=>G("option",{value:ne.name},ne.label))),g.value=U)}function T(){h=null,I(l,{}),o()}function C(U){return U.split("&").filter(B=>B&&B.split("=")[0]!==g.value).join("&")}function I(U,{moving:B=!1}){if(l=U,P(),clearTimeout(f),!l||!g.value)return w("");if(l.is_piloted)return w("Flights with a pilot are not swept here; a campaign can: springback campaign.");if(!s(g.value))return w("This control has no effect here.");let K=`${g.value}?${C(l.query)}`;a.has(K)?(c=a.get(K),E()):B||b(K),V(!a.has(K))}async function b(U){p=U;let[B,K]=U.split(/\?(.*)/s);M.textContent="Flying the sweep …";try{let ne=await fetch(`sweep?${[K,`of=${B}`].filter(Boolean).join("&")}`,{headers:{"x-lab-page":n}}),ee=await ne.json();if(p!==U)return;if(ne.ok)a.size>=eT&&a.delete(a.keys().next().value),a.set(U,ee),I(l,{});else if(ne.status===503){let le=ee.preparing;M.textContent=le?`Compiling for ${le.what}, about ${le.about} s, once on this machine: ${Math.round(le.waited)} s so far.`:"Too many requests are waiting.",f=setTimeout(()=>b(U),QE)}else ee.overtaken||w(ee.errors.join(" "))}catch{M.textContent="The lab does not respond."}}function E(){let U=c.refusals.reduce((ee,le)=>ee+le.count,0),B=Object.keys(c.labels).length>1?c.labels:{},K=ee=>Number(ee.toPrecision(3)),ne=c.refusals.map(({robot:ee,from:le,to:ce,why:ye})=>` ${B[ee]?`${B[ee]}, `:""}${le===ce?"":`${K(le)} to `}${K(ce)} ${S(c.of).unit}: ${ye}.`);M.textContent=U?`${U} of ${c.at.length*Object.keys(c.labels).length} points cannot be flown.${ne.join("")}`:`${c.at.length} flights for each robot in ${c.took.toFixed(0)} ms. A click sets the value.`}function w(U){p="",c=null,d.textContent="",u?.destroy(),u=null,M.textContent=U,i.classList.toggle("off",!g.value)}function O(){let U=l.measures.find(B=>B.name===_.value);return l.flights.map((B,K)=>({robot:B.robot,label:B.label,colour:Nn().robots[z(K)],dash:K?[8,3]:[],x:l.settings[g.value],y:U?.values[B.robot]??null}))}let z=U=>l.flights.length===1&&l.flights[0].robot==="quad"?1:U%2;function V(U){if(i.classList.remove("off"),!c||c.of!==g.value)return u&&(u.destroy(),u=null);let B=O(),K=S(g.value),ne=B.map(ye=>c.measures[_.value][ye.robot]??c.at.map(()=>null)),ee=[...ne.flat(),...B.map(ye=>ye.y)].filter(ye=>ye!==null);h=Cd(h,Math.min(0,...ee),Math.max(0,...ee));let le=x();d.textContent=le.unit?`${le.label} [${le.unit}]`:le.label;let ce=JSON.stringify([K.name,_.value,B.map(ye=>[ye.label,ye.colour])]);u?.look!==ce&&W(K,B,ce),u.batch(()=>{u.setData([c.at,...ne],!1),u.setScale("x",{min:K.least,max:K.most}),u.setScale("y",{min:h[0],max:h[1]})}),u.points=B,m.classList.toggle("old",U),q()}function W(U,B,K){u?.destroy();let ne=Nn(),ee={stroke:ne.faint,grid:{stroke:ne.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},le=U.unit?` [${U.unit.replace("^1.5","¹·⁵")}]`:"",ce={...ee,size:24,gap:6,label:`${U.label}${le}`,labelSize:15,labelFont:ee.font,labelGap:0};U.logarithmic&&Object.assign(ce,{splits:(ye,Re,j,X)=>tT(j,X),values:(ye,Re)=>Re.map(String),filter:(ye,Re)=>Re}),u=new $t({width:Math.max(m.clientWidth,200),height:w_,padding:[8,12,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1,distr:U.logarithmic?3:1,range:[U.least,U.most]},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[ce,{...ee,size:46,gap:4,space:26}],series:[{},...B.map(ye=>({stroke:ye.colour,width:1.8,dash:ye.dash,points:{show:!1}}))],hooks:{draw:[q]}},[[U.least,U.most],...B.map(()=>[null,null])],m),u.look=K,u.line=G("div",{class:"plot-now"}),u.dots=B.map(ye=>{let Re=G("div",{class:"sweep-point",title:ye.label});return Re.style.background=ye.colour,Re}),u.over.append(u.line,...u.dots),u.over.addEventListener("click",ye=>r(U.name,u.posToVal(ye.offsetX,"x")))}function q(){if(!u?.points)return;let U=x();u.line.style.transform=`translateX(${u.valToPos(u.points[0].x,"x")}px)`,u.points.forEach(({x:B,y:K,label:ne},ee)=>{let le=u.dots[ee];le.hidden=K===null,K!==null&&(le.title=`${ne}: ${Number(K.toPrecision(4))} ${U.unit}`,le.style.transform=`translate(${u.valToPos(B,"x")}px, ${u.valToPos(K,"y")}px)`)})}return new ResizeObserver(()=>{let U=m.clientWidth;u&&U&&Math.abs(U-u.width)>1&&u.setSize({width:U,height:w_})}).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>l&&I(l,{})),{show:I,hash:()=>g.value?`#sweep=${g.value},${_.value}`:"",restore(U){let[B,K]=(U.match(/^#sweep=([a-z_]+),([a-z_]+)$/)??[]).slice(1),ne=(ee,le)=>ee.some(ce=>ce.name===le);g.dataset.names="",g.replaceChildren(G("option",{value:""},"off"),...e.controls.map(ee=>G("option",{value:ee.name},ee.label))),g.value=ne(e.controls,B)?B:"",ne(e.measures,K)&&(_.value=K),h=null,l&&I(l,{})},state:()=>({of:g.value,measure:_.value,curve:c,points:u?.points??[],bounds:h,words:M.textContent})}}function tT(i,e){let t=[];for(let n=Math.floor(Math.log10(i));n<=Math.log10(e);n++)for(let s of[1,2,5]){let r=Number((s*10**n).toPrecision(3));r>=i&&r<=e&&t.push(r)}return t}var Pd=i=>{if(i==null)return"–";if(typeof i=="string")return i;let e=Math.abs(i);return e<5e-4?"0":i.toFixed(e<1?3:e<10?2:e<100?1:0)};function T_(i){function e(t,n,s){let r=t.flights.map(p=>[p.robot,p.label]),o=p=>n?.flights.some(g=>g.robot===p),a=t.measures.some(p=>Object.keys(p.printed).length),l=G("tr",{},G("th",{},""));for(let[p,[g,_]]of r.entries()){let m=G("th",{scope:"col"},_);m.style.color=s[p],l.append(m),a&&l.append(G("th",{scope:"col",class:"printed"},"paper")),o(g)&&l.append(G("th",{scope:"col",class:"pinned"},"pinned"))}let c=t.measures.map(p=>{let g=n?.measures.find(m=>m.name===p.name),_=G("tr",{"data-measure":p.name},G("th",{scope:"row"},p.label,...p.unit?[G("small",{},` ${p.unit}`)]:[]));for(let[m]of r){let d=[a&&p.printed[m]?`paper ${p.printed[m]}`:"",o(m)?`pinned ${Pd(g?.values[m])}`:""];_.append(G("td",{"data-robot":m,"data-beside":d.filter(Boolean).join(", ")},G("b",{},Pd(p.values[m])))),a&&_.append(G("td",{class:"printed"},p.printed[m]??"")),o(m)&&_.append(G("td",{class:"pinned"},Pd(g?.values[m])))}return _}),{words:u,same:h}=t.printed_for,f=a?[G("p",{class:h?"note":"note other"},h?u:`${u} The settings here differ.`)]:[];i.replaceChildren(G("table",{},G("thead",{},l),G("tbody",{},...c)),...f),i.classList.toggle("elsewhere",!h)}return{show:e}}var A_={impact:"Impact",follow:"Follow",side:"Side",top:"Top",free:"All"},nT=.012,iT=350;function R_(i,e){let t=Math.random().toString(36).slice(2),n=null,s=null,r=!1,o=[],a=v_(e.controls,le),l=G("div",{class:"outcomes","aria-live":"polite"}),c=G("p",{class:"alert",role:"alert",hidden:!0}),u=G("input",{class:"link",readonly:!0,"aria-label":"Link to these settings",id:"link",onfocus:()=>u.select()}),h=G("button",{type:"button",id:"copy",onclick:se},"Copy link"),f=G("button",{type:"button",id:"pin","aria-pressed":"false",title:"Keep this flight behind the next ones for comparison",onclick:fe},"Pin"),p=G("button",{type:"button",id:"reset",title:e.file?`Return to ${e.file}`:"Return to the paper's slider test",onclick:()=>Q("",{push:!0})},"Reset"),g=G("span",{class:"files"}),_=G("div",{class:"stage"}),m=G("div",{class:"preparing",role:"status",hidden:!0}),d=G("div"),M=G("div"),S=G("div",{class:"measures"}),x=G("div"),P=G("button",{type:"button",id:"lock","aria-pressed":"false",title:"Keep the vertical scales of all plots as they are",onclick:de},"Lock y"),T=G("p",{class:"took"}),C=G("button",{type:"button",class:"drawer",id:"drawer","aria-expanded":"false",onclick:()=>Pe(!i.classList.contains("open"))},"Settings"),I=bi("Camera",Oo.filter(te=>A_[te]).map(te=>[te,A_[te]]),"impact",te=>V.setCamera(te)),b=bi("Two robots",[["side","side by side"],["ghost","overlaid"]],"side",te=>V.setCompare(te)),E=G("h2"),w=bi("Plots show",[["impact","impact"],["all","all"]],"impact",te=>{r=te==="all",n&&Re()}),O=dl(()=>z,()=>Ae(["This browser refuses full screen."])),z=G("div",{class:"middle"},G("div",{class:"frame"},_,G("div",{class:"views"},I,b,O.button),m),d,S);i.classList.add("lab"),i.replaceChildren(G("header",{class:"top"},G("div",{class:"said"},G("h1",{},"Impact lab",...e.file?[G("small",{},e.file)]:[]),l,c),G("div",{class:"actions"},f,p,g,G("span",{class:"linking"},u,h))),G("main",{},G("aside",{class:"settings",id:"settings"},a.element,T),z,G("aside",{class:"curves"},x,G("div",{class:"plot-head"},E,P,w),M)),C);let V=Yh(_,{onCamera:te=>I.mark(te)}),W=S_(M,{onSeek:te=>(q.pause(),q.seek(te))}),q=Cl({scene:V,plots:{show:W.show,replace:()=>Re()},bar:d,actions:{f:O.toggle}}),U=T_(S),B=E_(x,{choices:e.sweeps,table:e.controls,page:t,isShown:a.isShown,onPick:a.pick,onChoice:()=>n&&ue(n.query,{settled:!0})}),K=x_(t,{answered:ce,refused:xe,waits:Ke,gone:mt}),ne=0,ee=!1;function le(te,ve,Ne){clearTimeout(ne);let Ye=()=>K.ask(a.query(),{...Ne,since:performance.now()});Ne.typing?ne=setTimeout(Ye,iT):Ye()}function ce(te,ve){let Ne=n;n=te,i.classList.add("ready"),ve.aside||Ae([]),m.hidden=!0,ve.typing?a.tellProblems([]):a.show(te.settings);let Ye=!Ne||Ne.settings.mode!==te.settings.mode,L=te.flights.length!==Ne?.flights.length;V.replace(te.flights.map(y=>y.scene),{keepCamera:!Ye&&!L}),b.hidden=te.flights.length<2,Ye&&w.mark((r=te.is_piloted)?"all":"impact"),ee=!!ve.moving,q.replace({keepTime:!Ye}),Ye&&ye(),j(),X(),B.show(te,ve),g.replaceChildren(...te.flights.map(y=>G("a",{class:"button",href:`scenario.toml?${[te.query,`of=${y.robot}`].filter(Boolean).join("&")}`,download:y.file,title:`Scenario for springback fly, ${y.label}`},`${y.label}.toml`))),ue(te.query,ve),requestAnimationFrame(()=>{let y=performance.now()-ve.since;o.push(y),T.textContent=`Flown in ${te.took.flying.toFixed(0)} ms, answered in ${te.took.all.toFixed(0)} ms, drawn after ${y.toFixed(0)} ms.`})}function ye(){let te=Wi(V.flights[0]),ve=!n.is_piloted,Ne=ve?"impact":"follow";I.mark(Ne),V.setCamera(Ne),q.seek(te===null?V.flights[0].begin:ve?te+nT:te)}function Re(){n&&(E.textContent=r?"Time [s]":"Time from touch [ms]",W.replace(V.flights,{whole:r,moving:ee}))}function j(){l.replaceChildren(...n.flights.map((te,ve)=>{let Ne=G("p",{class:`outcome ${te.well?"well":"badly"}`},G("b",{},te.label),te.sentence.slice(te.label.length));return Ne.style.setProperty("--colour",V.flights[ve].colour),Ne}))}let X=()=>U.show(n,s,V.flights.map(te=>te.colour));function de(){let te=P.getAttribute("aria-pressed")!=="true";P.setAttribute("aria-pressed",String(te)),W.lock(te),Re()}function Ae(te){c.hidden=!te.length,c.textContent=te.join(" ")}function xe(te,ve){m.hidden=!0,a.tellProblems(te),Ae([...te.map(Ne=>`${Ne}.`),n?"The previous flight is shown.":"The default flight is shown instead."]),n||K.ask("",{since:performance.now(),aside:!0})}function Ke(te){m.hidden=!1,m.replaceChildren(G("progress",{}),G("p",{},`Compiling for ${te.what}, about ${te.about} s: ${Math.round(te.waited)} s so far.`),G("p",{class:"words"},`Once on this machine; ${n?"the previous flight stays, and ":""}other settings can be flown meanwhile if they are ready.`))}function mt(){Ae(["The lab does not respond; it may have been stopped in its terminal. Any change tries again."])}let k=!1;function ue(te,{settled:ve=!1,aside:Ne=!1,restored:Ye=!1}){let L=`${location.pathname}${te?`?${te}`:""}${B.hash()}`;u.value=location.origin+L,!(Ne||Ye)&&(`${location.pathname}${location.search}${location.hash}`!==L&&(k?history.replaceState(null,"",L):history.pushState(null,"",L)),k=!ve)}function Q(te,{push:ve=!1}={}){K.ask(te,{since:performance.now(),settled:ve,restored:!ve})}addEventListener("popstate",()=>(B.restore(location.hash),Q(location.search.slice(1))));async function se(){try{await navigator.clipboard.writeText(u.value)}catch{u.select(),document.execCommand("copy")}h.textContent="Copied",setTimeout(()=>h.textContent="Copy link",1500)}function fe(){s=s?null:n,f.setAttribute("aria-pressed",String(!!s)),f.textContent=s?"Unpin":"Pin";let te=s?Ed(s.flights.map(ve=>({...ve.scene})),Nn()):[];W.pin(te),Re(),X()}function Pe(te){i.classList.toggle("open",te),C.setAttribute("aria-expanded",String(te)),C.textContent=te?"Done":"Settings",te&&_.scrollIntoView({block:"start"})}return a.show(Object.fromEntries(e.controls.map(te=>[te.name,te.default]))),B.restore(location.hash),Q(location.search.slice(1)),window.springback={scene:V,player:q,plots:W,controls:a,sweep:B,latency:o,pose:()=>({...V.pose(),playing:q.playing,pace:q.pace}),get answer(){return n}},window.springback}var sT={replay:m_,lab:R_};function C_(){let i=sT[document.body.dataset.app],e=document.getElementById("data");i&&i(document.getElementById("app"),e?JSON.parse(e.textContent):{})}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",C_):C_();})();
