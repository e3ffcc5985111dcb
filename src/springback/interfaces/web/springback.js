/*! springback, MIT licence; sources 8fcf48ef648b09c8d8c15c3ea591c756da241e503a71c6a305dfe4162ffe828c

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
(()=>{var up=i=>{throw TypeError(i)};var y_=(i,t,e)=>t.has(i)||up("Cannot "+e);var ml=(i,t,e)=>t.has(i)?up("Cannot add the same private member more than once"):t instanceof WeakSet?t.add(i):t.set(i,e);var Rn=(i,t,e)=>(y_(i,t,"access private method"),e);function G(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))s.startsWith("on")?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==!1&&r!=null&&n.setAttribute(s,r);return n.append(...e),n}var b_={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",back:"M18 5v14l-9.5-7zM5.5 5h2.4v14H5.5z",forth:"M6 5v14l9.5-7zM16.1 5h2.4v14h-2.4z",touch:"M4 4h3v16H4zM20 12l-9 6V6z",link:"M10.6 13.4a4 4 0 0 0 5.7 0l3-3a4 4 0 1 0-5.7-5.7l-1.6 1.6 1.4 1.4 1.6-1.6a2 2 0 1 1 2.9 2.9l-3 3a2 2 0 0 1-2.9 0zm2.8-2.8a4 4 0 0 0-5.7 0l-3 3a4 4 0 1 0 5.7 5.7l1.6-1.6-1.4-1.4-1.6 1.6a2 2 0 1 1-2.9-2.9l3-3a2 2 0 0 1 2.9 0z",picture:"M4 7h4l1.5-2.5h5L16 7h4v12H4zm8 2.5a3.5 3.5 0 1 0 0 7 3.5 3.5 0 0 0 0-7zm0 1.8a1.7 1.7 0 1 1 0 3.4 1.7 1.7 0 0 1 0-3.4z",undo:"M9 4 3.5 9.5 9 15v-4h5a3.5 3.5 0 0 1 0 7h-4v2.2h4a5.7 5.7 0 0 0 0-11.4H9z",film:"M3 6h12v12H3zM16.5 10.5 21 7.5v9l-4.5-3z",full:"M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z",help:"M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 12.5h2v2h-2zm1-9c-2 0-3.5 1.3-3.5 3.2h2c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.4-2.5 1.6-2.5 4.1v.3h2v-.2c0-1.4 2.5-1.8 2.5-4.3 0-1.8-1.5-3-3.5-3z"};function Yi(i){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidden","true");let e=document.createElementNS("http://www.w3.org/2000/svg","path");return e.setAttribute("d",b_[i]),e.setAttribute("fill-rule","evenodd"),t.append(e),t}function Si(i,t,e,n){let s=G("div",{class:"choice",role:"group","aria-label":i});for(let[a,l]of t)s.append(G("button",{type:"button","data-value":a,"aria-pressed":String(a===e),onclick:()=>{r(a),n(a)}},l));function r(a){for(let l of s.children)l.setAttribute("aria-pressed",String(l.dataset.value===a))}let o=a=>(r(a),n(a));return Object.defineProperty(s,"chosen",{get:()=>s.querySelector("[aria-pressed=true]")?.dataset.value}),Object.assign(s,{mark:r,press:o})}function fp(i,t,e,n=""){let s=G("button",{type:"button",title:n,"aria-pressed":String(t),onclick:()=>{s.setAttribute("aria-pressed",String(!s.on)),e(s.on)}},i);return Object.defineProperty(s,"on",{get:()=>s.getAttribute("aria-pressed")==="true"}),s}var M_=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"],w_=30;function dp(i,t){let e=G("a",{href:URL.createObjectURL(i),download:t});e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}function vu(i,t,e,n=null){let s=t.getBoundingClientRect(),r=getComputedStyle(t);if(!s.width)return;let[o,a]=[s.left-e.left,s.top-e.top];i.fillStyle=r.backgroundColor,i.fillRect(o,a,s.width,s.height);let l=o+parseFloat(r.paddingLeft);if(n&&parseFloat(n.width)>0){let c=parseFloat(n.height);i.fillStyle=n.backgroundColor,i.fillRect(l,a+(s.height-c)/2,parseFloat(n.width),c),l+=parseFloat(n.width)+parseFloat(n.marginRight)}i.font=`${r.fontWeight} ${r.fontSize} ${r.fontFamily}`,i.textBaseline="middle",i.fillStyle=r.color,i.fillText(t.textContent,l,a+s.height/2+1,o+s.width-l)}function pp({scene:i,stage:t,player:e,name:n,say:s,onRecording:r=()=>{}}){let o=G("div",{class:"stage-clock","aria-hidden":"true"});t.append(o);let a=null,l=null;function c(){let p=Math.min(devicePixelRatio||1,2),m=G("canvas",{width:2*Math.round(t.clientWidth*p/2),height:2*Math.round(t.clientHeight*p/2)});return{canvas:m,pen:m.getContext("2d"),ratio:p}}function u({canvas:p,pen:m,ratio:v},g){o.textContent=`${i.pose().t.toFixed(4)} s`;let d=t.getBoundingClientRect();m.setTransform(1,0,0,1,0,0),m.drawImage(g,0,0,p.width,p.height),m.scale(v,v);let b=t.querySelector(".scene-legend"),S=b.getBoundingClientRect();m.fillStyle=getComputedStyle(b).backgroundColor,m.fillRect(S.left-d.left,S.top-d.top,S.width,S.height);for(let y of b.children)vu(m,y,d,getComputedStyle(y,"::before"));for(let y of t.querySelectorAll(".force-labels span:not([hidden])"))vu(m,y,d);vu(m,o,d)}function h(){let p=i.canvas();if(!p)return s("There is no picture without WebGL.");let m=c();u(m,p),m.canvas.toBlob(v=>{dp(v,`${n}-${i.pose().t.toFixed(4)}s.png`),s("The picture is among your downloads.")})}function f(){if(a)return a.stop();let p=window.MediaRecorder&&M_.find(v=>MediaRecorder.isTypeSupported(v));if(!p||!i.canvas()||!HTMLCanvasElement.prototype.captureStream)return s("This browser cannot record films. The command springback animate RESULT --out film.gif makes one, or film.mp4.");l=c(),u(l,i.canvas());let m=[];a=new MediaRecorder(l.canvas.captureStream(w_),{mimeType:p,videoBitsPerSecond:12e6}),a.ondataavailable=v=>m.push(v.data),a.onstop=()=>{[a,l]=[null,null],e.pause(),r(!1),dp(new Blob(m,{type:p}),`${n}.${p.includes("mp4")?"mp4":"webm"}`),s("The film is among your downloads. springback animate makes one without dropped frames.")},a.start(),r(!0),e.play()}return{picture:h,film:f,drawn(){l&&u(l,i.canvas(!1))},rested(){a?.state==="recording"&&!e.playing&&a.stop()},get recording(){return!!a}}}var S_=()=>matchMedia("(prefers-color-scheme: dark)").matches,E_={background:"#f3f5f8",ink:"#222222",faint:"#8c8c8c",line:"#c3cad4",wall:"#7d8794",mat:"#009e73",ground:"#a8aeb7",metal:"#5b6470",dark:"#30363d",arms:["#0072b2","#d98a00","#009e73","#cc79a7","#3a9bd9","#8c8c8c"],robots:["#0072b2","#d55e00","#007a5a","#a8488a","#8a6d00","#1b2a6b","#6b6b6b","#7a1f1f"],force:"#e69f00",thrust:"#56b4e9",before:"#8c8c8c"},T_={background:"#14181d",ink:"#e6e9ed",faint:"#9aa3ad",line:"#3a434e",wall:"#98a3b1",mat:"#2cc79a",ground:"#59626d",metal:"#aab4c0",dark:"#cdd4dc",arms:["#4ea8e0","#f0b429","#35c79b","#e29cc4","#8fd0f5","#a7b0ba"],robots:["#4ea8e0","#ff8a3d","#35c79b","#e29cc4","#e3cf57","#a9b4ff","#c9d1d9","#ff8f8f"],force:"#ffc13d",thrust:"#7cc8f2",before:"#a7b0ba"},Hn=()=>S_()?T_:E_;var pi=Uint8Array,kr=Uint16Array,A_=Int32Array,mp=new pi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),gp=new pi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),R_=new pi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),vp=function(i,t){for(var e=new kr(31),n=0;n<31;++n)e[n]=t+=1<<i[n-1];for(var s=new A_(e[30]),n=1;n<30;++n)for(var r=e[n];r<e[n+1];++r)s[r]=r-e[n]<<5|n;return{b:e,r:s}},_p=vp(mp,2),xp=_p.b,C_=_p.r;xp[28]=258,C_[258]=28;var yp=vp(gp,0),P_=yp.b,YT=yp.r,yu=new kr(32768);for(Se=0;Se<32768;++Se)ls=(Se&43690)>>1|(Se&21845)<<1,ls=(ls&52428)>>2|(ls&13107)<<2,ls=(ls&61680)>>4|(ls&3855)<<4,yu[Se]=((ls&65280)>>8|(ls&255)<<8)>>1;var ls,Se,Zo=(function(i,t,e){for(var n=i.length,s=0,r=new kr(t);s<n;++s)i[s]&&++r[i[s]-1];var o=new kr(t);for(s=1;s<t;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(e){a=new kr(1<<t);var l=15-t;for(s=0;s<n;++s)if(i[s])for(var c=s<<4|i[s],u=t-i[s],h=o[i[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[yu[h]>>l]=c}else for(a=new kr(n),s=0;s<n;++s)i[s]&&(a[s]=yu[o[i[s]-1]++]>>15-i[s]);return a}),Ko=new pi(288);for(Se=0;Se<144;++Se)Ko[Se]=8;var Se;for(Se=144;Se<256;++Se)Ko[Se]=9;var Se;for(Se=256;Se<280;++Se)Ko[Se]=7;var Se;for(Se=280;Se<288;++Se)Ko[Se]=8;var Se,bp=new pi(32);for(Se=0;Se<32;++Se)bp[Se]=5;var Se;var I_=Zo(Ko,9,1);var L_=Zo(bp,5,1),_u=function(i){for(var t=i[0],e=1;e<i.length;++e)i[e]>t&&(t=i[e]);return t},Ei=function(i,t,e){var n=t/8|0;return(i[n]|i[n+1]<<8)>>(t&7)&e},xu=function(i,t){var e=t/8|0;return(i[e]|i[e+1]<<8|i[e+2]<<16)>>(t&7)},D_=function(i){return(i+7)/8|0},U_=function(i,t,e){return(t==null||t<0)&&(t=0),(e==null||e>i.length)&&(e=i.length),new pi(i.subarray(t,e))};var N_=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Ti=function(i,t,e){var n=new Error(t||N_[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,Ti),!e)throw n;return n},F_=function(i,t,e,n){var s=i.length,r=n?n.length:0;if(!s||t.f&&!t.l)return e||new pi(0);var o=!e,a=o||t.i!=2,l=t.i;o&&(e=new pi(s*3));var c=function(Gt){var de=e.length;if(Gt>de){var k=new pi(Math.max(de*2,Gt));k.set(e),e=k}},u=t.f||0,h=t.p||0,f=t.b||0,p=t.l,m=t.d,v=t.m,g=t.n,d=s*8;do{if(!p){u=Ei(i,h,1);var b=Ei(i,h+1,3);if(h+=3,b)if(b==1)p=I_,m=L_,v=9,g=5;else if(b==2){var E=Ei(i,h,31)+257,I=Ei(i,h+10,15)+4,D=E+Ei(i,h+5,31)+1;h+=14;for(var M=new pi(D),w=new pi(19),T=0;T<I;++T)w[R_[T]]=Ei(i,h+T*3,7);h+=I*3;for(var B=_u(w),H=(1<<B)-1,V=Zo(w,B,1),T=0;T<D;){var W=V[Ei(i,h,H)];h+=W&15;var S=W>>4;if(S<16)M[T++]=S;else{var X=0,F=0;for(S==16?(F=3+Ei(i,h,3),h+=2,X=M[T-1]):S==17?(F=3+Ei(i,h,7),h+=3):S==18&&(F=11+Ei(i,h,127),h+=7);F--;)M[T++]=X}}var z=M.subarray(0,E),J=M.subarray(E);v=_u(z),g=_u(J),p=Zo(z,v,1),m=Zo(J,g,1)}else Ti(1);else{var S=D_(h)+4,y=i[S-4]|i[S-3]<<8,P=S+y;if(P>s){l&&Ti(0);break}a&&c(f+y),e.set(i.subarray(S,P),f),t.b=f+=y,t.p=h=P*8,t.f=u;continue}if(h>d){l&&Ti(0);break}}a&&c(f+131072);for(var nt=(1<<v)-1,et=(1<<g)-1,ct=h;;ct=h){var X=p[xu(i,h)&nt],ft=X>>4;if(h+=X&15,h>d){l&&Ti(0);break}if(X||Ti(2),ft<256)e[f++]=ft;else if(ft==256){ct=h,p=null;break}else{var yt=ft-254;if(ft>264){var T=ft-257,xt=mp[T];yt=Ei(i,h,(1<<xt)-1)+xp[T],h+=xt}var tt=m[xu(i,h)&et],$=tt>>4;tt||Ti(3),h+=tt&15;var J=P_[$];if($>3){var xt=gp[$];J+=xu(i,h)&(1<<xt)-1,h+=xt}if(h>d){l&&Ti(0);break}a&&c(f+131072);var mt=f+yt;if(f<J){var vt=r-J,bt=Math.min(J,mt);for(vt+f<0&&Ti(3);f<bt;++f)e[f]=n[vt+f]}for(;f<mt;++f)e[f]=e[f-J]}}t.l=p,t.p=ct,t.b=f,t.f=u,p&&(u=1,t.m=v,t.d=m,t.n=g)}while(!u);return f!=e.length&&o?U_(e,0,f):e.subarray(0,f)};var O_=new pi(0);var B_=function(i,t){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&Ti(6,"invalid zlib data"),(i[1]>>5&1)==+!t&&Ti(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function Mp(i,t){return F_(i.subarray(B_(i,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var z_=typeof TextDecoder<"u"&&new TextDecoder,k_=0;try{z_.decode(O_,{stream:!0}),k_=1}catch{}var wp=i=>Uint8Array.from(atob(i),t=>t.charCodeAt(0));function H_(i,t){let e=Mp(wp(i.data));return i.columns.map(({low:n,step:s},r)=>{let o=2*t*r,a=new Float64Array(t);for(let l=0,c=0;l<t;l++)c=c+e[o+l]+256*e[o+t+l]&65535,a[l]=n+s*c;return a})}function Sp(i){let t=new Map;if(!i)return t;for(let e of["trajectory","telemetry"].filter(n=>i[n])){let n=i[e],s=new Float64Array(wp(n.t.data).buffer),r=null,o=[];n.columns.forEach(({name:a,unit:l,factor:c,group:u},h)=>t.set(a,{name:a,unit:l,group:u,t:s,held:e==="telemetry",words:i.words[a],get values(){return r??(r=H_(n,s.length)),r[h]},get shown(){return o[h]??(o[h]=c===1?this.values:this.values.map(f=>c*f)),o[h]}}))}return t}var V_={f4:Float32Array,f8:Float64Array,i4:Int32Array};function Ze(i){let t=Uint8Array.from(atob(i.data),e=>e.charCodeAt(0));return new V_[i.type](t.buffer)}function Ep(i){if(i.ready)return i;let t=Ze(i.t),e=Ze(i.force.at),n=new Int32Array(t.length).fill(-1);return e.forEach((s,r)=>n[s]=r),{...i,ready:!0,t,n:t.length,begin:t[0],end:t[t.length-1],position:Ze(i.position),attitude:Ze(i.attitude),armLength:Ze(i.arm_length),bends:Ze(i.bends),thrust:Ze(i.thrust),force:Ze(i.force.of),point:Ze(i.point.of),bodies:i.bodies.map(s=>({...s,position:Ze(s.position),attitude:Ze(s.attitude)})),rows:n,series:i.series.map(s=>({...s,values:Ze(s.values)})),signals:Sp(i.signals),every:i.signals?.telemetry?.every??1,shift:0}}function gl(i,t){let e=0,n=i.length-1;if(!(t>i[0]))return 0;for(;n-e>1;){let s=e+n>>1;i[s]<=t?e=s:n=s}return i[n]<=t?n:e}function Jo(i,t){let e=Math.min(Math.max(t-i.shift,i.begin),i.end),n=gl(i.t,e),s=Math.min(n+1,i.n-1),r=s>n?(e-i.t[n])/(i.t[s]-i.t[n]):0,o=(m,v,g)=>m[n*v+g]*(1-r)+m[s*v+g]*r,a=(m,v)=>Array.from({length:v},(g,d)=>o(m,v,d)),l=i.arms.length,c=m=>{let v=a(m,4),g=0;for(let b=0;b<4;b++)g+=m[n*4+b]*m[s*4+b];if(g<0)for(let b=0;b<4;b++)v[b]=m[n*4+b];let d=Math.hypot(...v);return v.map(b=>b/d)},u=i.rows[n],h=i.rows[s],f=[],p=i.part.length;for(let m=0;m<p;m++){let v=[0,0,0],g=null;for(let[b,S]of[[u,1-r],[h,r]]){if(b<0)continue;let y=(b*p+m)*3;for(let E=0;E<3;E++)v[E]+=S*i.force[y+E];let P=Array.from(i.point.subarray(y,y+3));P.some(E=>E!==0)&&(g=P)}let d=Math.hypot(...v);f.push(g&&d>1e-6?{part:i.part[m],force:v,size:d,point:g}:null)}return{t:e+i.shift,own:e,place:n,position:a(i.position,3),quaternion:c(i.attitude),armLengths:a(i.armLength,l),bends:i.bends.length?a(i.bends,l):[],thrust:a(i.thrust,i.rotors.length),contacts:f,bodies:i.bodies.map(m=>({position:a(m.position,3),quaternion:c(m.attitude)}))}}function jo({flight:i,t=i.t,values:e,held:n=!1},s){let r=Math.min(Math.max(s-i.shift,t[0]),t[t.length-1]),o=gl(t,r),a=n?o:Math.min(o+1,t.length-1),l=a>o?(r-t[o])/(t[a]-t[o]):0;return e[o]*(1-l)+e[a]*l}var Hr=i=>["est_x","est_qw"].every(t=>i.signals.has(t));function bu(i,t){let e=(r,o)=>{let a=i.signals.get(r);return a?jo({flight:i,...a,values:a.values},t):o},n=["w","x","y","z"].map(r=>e(`est_q${r}`)),s=Math.hypot(...n)||1;return{own:Math.min(Math.max(t-i.shift,i.begin),i.end),position:["x","y","z"].map(r=>e(`est_${r}`)),quaternion:n.map(r=>r/s),armLengths:i.arms.map((r,o)=>e(`hall${o+1}`,r.length)),bends:[],thrust:i.rotors.map(()=>0),contacts:[]}}function Cs(i){let t=i.first_touch??i.impacts[0]?.[0]??null;return t===null?null:t+i.shift}var vl=i=>i.map(Cs).find(t=>t!==null)??null;function Mu(i){let t=0;for(let e=0;e<i.force.length;e+=3)t=Math.max(t,Math.hypot(i.force[e],i.force[e+1],i.force[e+2]));return t}function Tp(i){let t=i.part.length;return Float32Array.from(i.rows,e=>{let n=[0,0,0];for(let s=0;e>=0&&s<3*t;s++)n[s%3]+=i.force[e*t*3+s];return Math.hypot(...n)})}function wu(i){if(!(i>0))return 1;let t=10**Math.floor(Math.log10(i));return t*([5,2,1].find(e=>e*t<=i*1.0000001)??1)}var G_=.005,Vr=[[],[7,3],[2,3],[9,3,2,3],[12,4],[4,2,1,2],[14,3,2,3],[3,6]],Ap={"Arm compression":["largest",i=>Math.max(...i)],Thrust:["all rotors",i=>i.reduce((t,e)=>t+e,0)],Velocity:["speed",i=>i[0]],Energy:["motion",i=>i[0]],"Contact force":["sum of all contacts"]},er=i=>[...new Set(i.flatMap(t=>t.series.map(e=>e.panel)))],_l=i=>new Map(i.flatMap(t=>[...t.signals])),Qo=i=>i.map(t=>Array.isArray(t)?t.join():t).join(";");function Su(i,t){let e=er(t),n=_l(t);return i.split(";").flatMap(s=>e.includes(s)?[s]:xl(s.split(",").filter(r=>n.has(r)),n))}function xl(i,t){let e=new Map;for(let n of new Set(i)){let{unit:s,words:r}=t.get(n),o=r?n:s;e.set(o,[...e.get(o)??[],n])}return[...e.values()]}function Rp(i,t){return t.map(e=>Array.isArray(e)?X_(i,e):W_(i,e)).filter(e=>e.curves.length)}function W_(i,t){let e=Hn(),n=i.map(o=>o.series.filter(a=>a.panel===t)),s=i.length>1?n.flatMap((o,a)=>q_(t,o,i[a])):Y_(n[0]);s.forEach((o,a)=>{o.flight??(o.flight=i[0]),o.t=o.flight.t,o.colour??(o.colour=e.arms[a%e.arms.length]),o.dash??(o.dash=Vr[a%Vr.length])});let r=i.length>1?Ap[t]?.[0]:"";return{key:t,name:r?`${t}, ${r}`:t,unit:n.flat()[0]?.unit,own:null,curves:s}}function X_(i,t){let e=Hn(),n=_l(i),s=i.length>1,r=t.flatMap((c,u)=>i.flatMap(h=>{let f=h.signals.get(c);if(!f)return[];let{t:p,shown:m,held:v}=f,g=s&&t.length===1?h.index:u;return[{name:s?t.length===1?h.label:`${h.label}, ${c}`:c,flight:h,t:p,values:m,held:v,dash:Vr[g%Vr.length],colour:s?h.colour:e.arms[u%e.arms.length]}]})),o=t.map(c=>n.get(c)),a=new Set(o.map(c=>c?.group)),l=t.length===1?t[0]:a.size===1?o[0].group:t.slice(0,3).join(", ")+(t.length>3?", …":"");return{key:t.join(),name:l,unit:o[0]?.unit,own:t,words:o[0]?.words,curves:r}}function q_(i,t,e){if(!t.length)return[];let[,n]=Ap[i]??["",r=>r[0]],s=i==="Contact force"?Tp(e):Float32Array.from(t[0].values,(r,o)=>n(t.map(a=>a.values[o])));return[{name:e.label,values:s,flight:e,colour:e.colour,dash:Vr[e.index%Vr.length]}]}function Y_(i){let t=[];for(let e of i){let n=e.values.reduce((r,o)=>Math.max(r,Math.abs(o)),0),s=t.find(r=>{let o=G_*Math.max(n,r.peak);return r.values.every((a,l)=>Math.abs(a-e.values[l])<=o)});s?s.names.push(e.name):t.push({names:[e.name],values:e.values,peak:n})}return t.map(({names:e,values:n})=>({name:$_(e),values:n}))}function $_(i){let t=i.map(e=>e.match(/^(.*?)\s*(\d+)$/));return i.length<2||t.some(e=>!e||e[1]!==t[0][1])?i.join(", "):`${t[0][1]} ${t.map(e=>e[2]).join(", ")}`}function Cp({signals:i,standard:t,onChoose:e}){let n=G("input",{type:"search",placeholder:"est, N, phase, …","aria-label":"Search signals",oninput:b}),s=G("h2",{id:"chooser-title"}),r=G("span",{class:"count",role:"status"}),o=(E,I,D)=>G("label",{"data-words":`${E} ${I}`.toLowerCase()},G("input",{type:"checkbox",value:E,onchange:S}),E,...D?[G("small",{},D)]:[]),a=(E,...I)=>{let D=G("fieldset",{},G("legend",{},E),...I);return I.length>1&&D.firstChild.append(G("button",{type:"button",class:"small","aria-label":`All of ${E}, or none`,onclick:()=>{let M=[...D.querySelectorAll("label:not([hidden]) input")],w=!M.every(T=>T.checked);M.forEach(T=>T.checked=w),S()}},"all")),D},l=a("Standard plots",...t.map(E=>o(E,"standard"))),c=new Map;for(let{name:E,unit:I,group:D}of i.values()){let M=[D,I,I==="m/s²"?"acceleration":""].join(" ");c.set(D,[...c.get(D)??[],o(E,M,I)])}let u=G("div",{class:"signals"},l,...[...c].map(([E,I])=>a(E,...I))),h=G("p",{hidden:!0},"No signal of this flight matches."),f=G("form",{method:"dialog",onsubmit:y},s,G("p",{class:"hint"},"Signals of one unit share a plot. Names are those of the columns in the files of the result."),n,u,h,G("div",{class:"actions"},r,G("button",{type:"button",onclick:()=>(e(null),p.close())},"Only standard plots"),G("button",{type:"button",onclick:()=>p.close()},"Cancel"),G("button",{type:"submit",class:"main"},"Plot"))),p=G("dialog",{class:"chooser","aria-labelledby":"chooser-title"},f),m=[],v=null,g=E=>[...E.querySelectorAll("input[type=checkbox]:checked")].map(I=>I.value),d=()=>[...u.children].filter(E=>E!==l).flatMap(g);function b(){let E=n.value.toLowerCase().split(/\s+/).filter(Boolean);for(let I of u.children){let D=[...I.querySelectorAll("label")];D.forEach(M=>M.hidden=!E.every(w=>M.dataset.words.includes(w))),I.hidden=D.every(M=>M.hidden)||I===l&&v!==null}h.hidden=[...u.children].some(I=>!I.hidden)}function S(){let E=d(),I=xl(E,i).length;r.textContent=E.length?`${E.length} signal${E.length>1?"s":""} in ${I} plot${I>1?"s":""}`:""}function y(){let E=xl(d(),i);if(v!==null)e(m.flatMap((I,D)=>D===v?E:[I]));else{let I=g(l),D=m.filter(M=>Array.isArray(M)||I.includes(M));e([...D,...I.filter(M=>!m.includes(M)),...E])}}function P(E,I=null){[m,v]=[E,I];let D=I===null?E.filter(M=>!Array.isArray(M)):E[I];u.querySelectorAll("input").forEach(M=>M.checked=D.includes(M.value)),s.textContent=I===null?"Add plots":"Change a plot",n.value="",b(),S(),p.showModal(),n.focus()}return{element:p,open:P}}function yl(i,t){let e=()=>document.fullscreenElement?document.exitFullscreen():i().requestFullscreen().catch(t),n=G("button",{type:"button",class:"tool tool-full",hidden:!document.fullscreenEnabled,onclick:e},Yi("full"));function s(){let r=document.fullscreenElement?"Leave full screen":"Full screen";n.title=`${r} (F)`,n.setAttribute("aria-label",r)}return document.addEventListener("fullscreenchange",s),s(),{button:n,toggle:e}}function Pp({read:i,apply:t}){let e=0,n=location.hash,s=()=>{let a=Object.entries(i()).filter(([,l])=>l!=="");return`#${new URLSearchParams(a)}`.replace(/%2C/g,",").replace(/%3B/g,";")};function r(){clearTimeout(e),n=s();try{history.replaceState(null,"",n)}catch{}}addEventListener("hashchange",()=>{location.hash!==n&&o()});function o(){t(Object.fromEntries(new URLSearchParams(location.hash.slice(1))))}return{follow:o,renew(){clearTimeout(e),e=setTimeout(r,250)},address(){return r(),location.href.replace(/#.*/,"")+n}}}var Hs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Vs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},am=0,cf=1,lm=2;var hf=1,cm=2,Qi=3,gs=0,Wn=1,Ln=2,_s=0,ar=1,uf=2,ff=3,df=4,hm=5,Os=100,um=101,fm=102,dm=103,pm=104,mm=200,gm=201,vm=202,_m=203,Jl=204,jl=205,xm=206,ym=207,bm=208,Mm=209,wm=210,Sm=211,Em=212,Tm=213,Am=214,Pc=0,Ic=1,Lc=2,lr=3,Dc=4,Uc=5,Nc=6,Fc=7,pf=0,Rm=1,Cm=2,xs=0,Pm=1,Im=2,Lm=3,Dm=4,Um=5,Nm=6,Fm=7;var mf=300,gr=301,vr=302,Oc=303,Bc=304,Ha=306,Ql=1e3,Fs=1001,tc=1002,gi=1003,Om=1004;var Va=1005;var Li=1006,zc=1007;var Gs=1008;var Fi=1009,gf=1010,vf=1011,bo=1012,kc=1013,Ws=1014,ts=1015,Mo=1016,Hc=1017,Vc=1018,wo=1020,_f=35902,xf=35899,yf=1021,bf=1022,_i=1023,co=1026,So=1027,Mf=1028,Gc=1029,wf=1030,Wc=1031;var Xc=1033,Ga=33776,Wa=33777,Xa=33778,qa=33779,qc=35840,Yc=35841,$c=35842,Zc=35843,Kc=36196,Jc=37492,jc=37496,Qc=37808,th=37809,eh=37810,nh=37811,ih=37812,sh=37813,rh=37814,oh=37815,ah=37816,lh=37817,ch=37818,hh=37819,uh=37820,fh=37821,dh=36492,ph=36494,mh=36495,gh=36283,vh=36284,_h=36285,xh=36286;var ua=2300,ec=2301,Kl=2302,ef=2400,nf=2401,sf=2402;var Bm=3200,zm=3201;var Sf=0,km=1,ys="",Gn="srgb",cr="srgb-linear",fa="linear",Pe="srgb";var or=7680,Ef=7681;var Tf=517;var rf=519,Hm=512,Vm=513,Gm=514,Af=515,Wm=516,Xm=517,qm=518,Ym=519,nc=35044;var Rf="300 es",Ii=2e3,da=2001;var Zi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Cn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ip=1234567,ao=Math.PI/180,ho=180/Math.PI;function ps(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Cn[i&255]+Cn[i>>8&255]+Cn[i>>16&255]+Cn[i>>24&255]+"-"+Cn[t&255]+Cn[t>>8&255]+"-"+Cn[t>>16&15|64]+Cn[t>>24&255]+"-"+Cn[e&63|128]+Cn[e>>8&255]+"-"+Cn[e>>16&255]+Cn[e>>24&255]+Cn[n&255]+Cn[n>>8&255]+Cn[n>>16&255]+Cn[n>>24&255]).toLowerCase()}function ie(i,t,e){return Math.max(t,Math.min(e,i))}function Cf(i,t){return(i%t+t)%t}function Z_(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function K_(i,t,e){return i!==t?(e-i)/(t-i):0}function la(i,t,e){return(1-e)*i+e*t}function J_(i,t,e,n){return la(i,t,1-Math.exp(-e*n))}function j_(i,t=1){return t-Math.abs(Cf(i,t*2)-t)}function Q_(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function tx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function ex(i,t){return i+Math.floor(Math.random()*(t-i+1))}function nx(i,t){return i+Math.random()*(t-i)}function ix(i){return i*(.5-Math.random())}function sx(i){i!==void 0&&(Ip=i);let t=Ip+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function rx(i){return i*ao}function ox(i){return i*ho}function ax(i){return(i&i-1)===0&&i!==0}function lx(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function cx(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function hx(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),u=o((t+n)/2),h=r((t-n)/2),f=o((t-n)/2),p=r((n-t)/2),m=o((n-t)/2);switch(s){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*p,a*c);break;case"YXY":i.set(l*p,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*p,a*u,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Pi(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Ce(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Xs={DEG2RAD:ao,RAD2DEG:ho,generateUUID:ps,clamp:ie,euclideanModulo:Cf,mapLinear:Z_,inverseLerp:K_,lerp:la,damp:J_,pingpong:j_,smoothstep:Q_,smootherstep:tx,randInt:ex,randFloat:nx,randFloatSpread:ix,seededRandom:sx,degToRad:rx,radToDeg:ox,isPowerOfTwo:ax,ceilPowerOfTwo:lx,floorPowerOfTwo:cx,setQuaternionFromProperEuler:hx,normalize:Ce,denormalize:Pi},Ot=class i{constructor(t=0,e=0){i.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ie(this.x,t.x,e.x),this.y=ie(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ie(this.x,t,e),this.y=ie(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ie(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ie(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},sn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],f=r[o+0],p=r[o+1],m=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=p,t[e+2]=m,t[e+3]=v;return}if(h!==v||l!==f||c!==p||u!==m){let g=1-a,d=l*f+c*p+u*m+h*v,b=d>=0?1:-1,S=1-d*d;if(S>Number.EPSILON){let P=Math.sqrt(S),E=Math.atan2(P,d*b);g=Math.sin(g*E)/P,a=Math.sin(a*E)/P}let y=a*b;if(l=l*g+f*y,c=c*g+p*y,u=u*g+m*y,h=h*g+v*y,g===1-a){let P=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=P,c*=P,u*=P,h*=P}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],p=r[o+2],m=r[o+3];return t[e]=a*m+u*h+l*p-c*f,t[e+1]=l*m+u*f+c*h-a*p,t[e+2]=c*m+u*p+a*f-l*h,t[e+3]=u*m-a*h-l*f-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),p=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h-f*p*m;break;case"YXZ":this._x=f*u*h+c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h+f*p*m;break;case"ZXY":this._x=f*u*h-c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h-f*p*m;break;case"ZYX":this._x=f*u*h-c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h+f*p*m;break;case"YZX":this._x=f*u*h+c*p*m,this._y=c*p*h+f*u*m,this._z=c*u*m-f*p*h,this._w=c*u*h-f*p*m;break;case"XZY":this._x=f*u*h-c*p*m,this._y=c*p*h-f*u*m,this._z=c*u*m+f*p*h,this._w=c*u*h+f*p*m;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>h){let p=2*Math.sqrt(1+n-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-n-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ie(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let p=1-e;return this._w=p*o+e*this._w,this._x=p*n+e*this._x,this._y=p*s+e*this._y,this._z=p*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},L=class i{constructor(t=0,e=0,n=0){i.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Lp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Lp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),u=2*(a*e-r*s),h=2*(r*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ie(this.x,t.x,e.x),this.y=ie(this.y,t.y,e.y),this.z=ie(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ie(this.x,t,e),this.y=ie(this.y,t,e),this.z=ie(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ie(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Eu.copy(this).projectOnVector(t),this.sub(Eu)}reflect(t){return this.sub(Eu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ie(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Eu=new L,Lp=new sn,ce=class i{constructor(t,e,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],p=n[5],m=n[8],v=s[0],g=s[3],d=s[6],b=s[1],S=s[4],y=s[7],P=s[2],E=s[5],I=s[8];return r[0]=o*v+a*b+l*P,r[3]=o*g+a*S+l*E,r[6]=o*d+a*y+l*I,r[1]=c*v+u*b+h*P,r[4]=c*g+u*S+h*E,r[7]=c*d+u*y+h*I,r[2]=f*v+p*b+m*P,r[5]=f*g+p*S+m*E,r[8]=f*d+p*y+m*I,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,p=c*r-o*l,m=e*h+n*f+s*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/m;return t[0]=h*v,t[1]=(s*c-u*n)*v,t[2]=(a*n-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=p*v,t[7]=(n*l-c*e)*v,t[8]=(o*e-n*r)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(Tu.makeScale(t,e)),this}rotate(t){return this.premultiply(Tu.makeRotation(-t)),this}translate(t,e){return this.premultiply(Tu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Tu=new ce;function Pf(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function pa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function $m(){let i=pa("canvas");return i.style.display="block",i}var Dp={};function uo(i){i in Dp||(Dp[i]=!0,console.warn(i))}function Zm(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Up=new ce().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Np=new ce().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ux(){let i={enabled:!0,workingColorSpace:cr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pe&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pe&&(s.r=lo(s.r),s.g=lo(s.g),s.b=lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ys?fa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return uo("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return uo("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[cr]:{primaries:t,whitePoint:n,transfer:fa,toXYZ:Up,fromXYZ:Np,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Gn},outputColorSpaceConfig:{drawingBufferColorSpace:Gn}},[Gn]:{primaries:t,whitePoint:n,transfer:Pe,toXYZ:Up,fromXYZ:Np,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Gn}}}),i}var _e=ux();function ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function lo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Gr,ic=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Gr===void 0&&(Gr=pa("canvas")),Gr.width=t.width,Gr.height=t.height;let s=Gr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Gr}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=pa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ms(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(ms(e[n]/255)*255):e[n]=ms(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},fx=0,fo=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:fx++}),this.uuid=ps(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Au(s[o].image)):r.push(Au(s[o]))}else r=Au(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Au(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ic.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var dx=0,Ru=new L,Kn=class i extends Zi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Fs,s=Fs,r=Li,o=Gs,a=_i,l=Fi,c=i.DEFAULT_ANISOTROPY,u=ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:dx++}),this.uuid=ps(),this.name="",this.source=new fo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ot(0,0),this.repeat=new Ot(1,1),this.center=new Ot(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ce,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Ru).x}get height(){return this.source.getSize(Ru).y}get depth(){return this.source.getSize(Ru).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==mf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ql:t.x=t.x-Math.floor(t.x);break;case Fs:t.x=t.x<0?0:1;break;case tc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ql:t.y=t.y-Math.floor(t.y);break;case Fs:t.y=t.y<0?0:1;break;case tc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Kn.DEFAULT_IMAGE=null;Kn.DEFAULT_MAPPING=mf;Kn.DEFAULT_ANISOTROPY=1;var Ie=class i{constructor(t=0,e=0,n=0,s=1){i.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],m=l[9],v=l[2],g=l[6],d=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(m+g)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(c+1)/2,y=(p+1)/2,P=(d+1)/2,E=(u+f)/4,I=(h+v)/4,D=(m+g)/4;return S>y&&S>P?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=E/n,r=I/n):y>P?y<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),n=E/s,r=D/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=I/r,s=D/r),this.set(n,s,r,e),this}let b=Math.sqrt((g-m)*(g-m)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(b)<.001&&(b=1),this.x=(g-m)/b,this.y=(h-v)/b,this.z=(f-u)/b,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ie(this.x,t.x,e.x),this.y=ie(this.y,t.y,e.y),this.z=ie(this.z,t.z,e.z),this.w=ie(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ie(this.x,t,e),this.y=ie(this.y,t,e),this.z=ie(this.z,t,e),this.w=ie(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ie(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},sc=class extends Zi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Li,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ie(0,0,t,e),this.scissorTest=!1,this.viewport=new Ie(0,0,t,e);let s={width:t,height:e,depth:n.depth},r=new Kn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(t={}){let e={minFilter:Li,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new fo(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ki=class extends sc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ma=class extends Kn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=gi,this.minFilter=gi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var rc=class extends Kn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=gi,this.minFilter=gi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var yn=class{constructor(t=new L(1/0,1/0,1/0),e=new L(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Ai.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Ai.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Ai.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(t.matrixWorld),this.expandByPoint(Ai);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),bl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),bl.copy(n.boundingBox)),bl.applyMatrix4(t.matrixWorld),this.union(bl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ai),Ai.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ta),Ml.subVectors(this.max,ta),Wr.subVectors(t.a,ta),Xr.subVectors(t.b,ta),qr.subVectors(t.c,ta),Ps.subVectors(Xr,Wr),Is.subVectors(qr,Xr),nr.subVectors(Wr,qr);let e=[0,-Ps.z,Ps.y,0,-Is.z,Is.y,0,-nr.z,nr.y,Ps.z,0,-Ps.x,Is.z,0,-Is.x,nr.z,0,-nr.x,-Ps.y,Ps.x,0,-Is.y,Is.x,0,-nr.y,nr.x,0];return!Cu(e,Wr,Xr,qr,Ml)||(e=[1,0,0,0,1,0,0,0,1],!Cu(e,Wr,Xr,qr,Ml))?!1:(wl.crossVectors(Ps,Is),e=[wl.x,wl.y,wl.z],Cu(e,Wr,Xr,qr,Ml))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ai).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ai).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(cs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),cs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),cs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),cs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),cs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),cs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),cs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),cs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(cs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},cs=[new L,new L,new L,new L,new L,new L,new L,new L],Ai=new L,bl=new yn,Wr=new L,Xr=new L,qr=new L,Ps=new L,Is=new L,nr=new L,ta=new L,Ml=new L,wl=new L,ir=new L;function Cu(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ir.fromArray(i,r);let a=s.x*Math.abs(ir.x)+s.y*Math.abs(ir.y)+s.z*Math.abs(ir.z),l=t.dot(ir),c=e.dot(ir),u=n.dot(ir);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var px=new yn,ea=new L,Pu=new L,Di=class{constructor(t=new L,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):px.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ea.subVectors(t,this.center);let e=ea.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(ea,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Pu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ea.copy(t.center).add(Pu)),this.expandByPoint(ea.copy(t.center).sub(Pu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},hs=new L,Iu=new L,Sl=new L,Ls=new L,Lu=new L,El=new L,Du=new L,hr=class{constructor(t=new L,e=new L(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,hs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=hs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(hs.copy(this.origin).addScaledVector(this.direction,e),hs.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Iu.copy(t).add(e).multiplyScalar(.5),Sl.copy(e).sub(t).normalize(),Ls.copy(this.origin).sub(Iu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Sl),a=Ls.dot(this.direction),l=-Ls.dot(Sl),c=Ls.lengthSq(),u=Math.abs(1-o*o),h,f,p,m;if(u>0)if(h=o*l-a,f=o*a-l,m=r*u,h>=0)if(f>=-m)if(f<=m){let v=1/u;h*=v,f*=v,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Iu).addScaledVector(Sl,f),p}intersectSphere(t,e){hs.subVectors(t.center,this.origin);let n=hs.dot(this.direction),s=hs.dot(hs)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,hs)!==null}intersectTriangle(t,e,n,s,r){Lu.subVectors(e,t),El.subVectors(n,t),Du.crossVectors(Lu,El);let o=this.direction.dot(Du),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ls.subVectors(this.origin,t);let l=a*this.direction.dot(El.crossVectors(Ls,El));if(l<0)return null;let c=a*this.direction.dot(Lu.cross(Ls));if(c<0||l+c>o)return null;let u=-a*Ls.dot(Du);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ue=class i{constructor(t,e,n,s,r,o,a,l,c,u,h,f,p,m,v,g){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,u,h,f,p,m,v,g)}set(t,e,n,s,r,o,a,l,c,u,h,f,p,m,v,g){let d=this.elements;return d[0]=t,d[4]=e,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=h,d[14]=f,d[3]=p,d[7]=m,d[11]=v,d[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,n=t.elements,s=1/Yr.setFromMatrixColumn(t,0).length(),r=1/Yr.setFromMatrixColumn(t,1).length(),o=1/Yr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let f=o*u,p=o*h,m=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=p+m*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=m+p*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,p=l*h,m=c*u,v=c*h;e[0]=f+v*a,e[4]=m*a-p,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=p*a-m,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*u,p=l*h,m=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=m+p*a,e[1]=p+m*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,p=o*h,m=a*u,v=a*h;e[0]=l*u,e[4]=m*c-p,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=p*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,p=o*c,m=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=m*h+p,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=p*h+m,e[10]=f-v*h}else if(t.order==="XZY"){let f=o*l,p=o*c,m=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=p*h-m,e[2]=m*h-p,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(mx,t,gx)}lookAt(t,e,n){let s=this.elements;return si.subVectors(t,e),si.lengthSq()===0&&(si.z=1),si.normalize(),Ds.crossVectors(n,si),Ds.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Ds.crossVectors(n,si)),Ds.normalize(),Tl.crossVectors(si,Ds),s[0]=Ds.x,s[4]=Tl.x,s[8]=si.x,s[1]=Ds.y,s[5]=Tl.y,s[9]=si.y,s[2]=Ds.z,s[6]=Tl.z,s[10]=si.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],p=n[13],m=n[2],v=n[6],g=n[10],d=n[14],b=n[3],S=n[7],y=n[11],P=n[15],E=s[0],I=s[4],D=s[8],M=s[12],w=s[1],T=s[5],B=s[9],H=s[13],V=s[2],W=s[6],X=s[10],F=s[14],z=s[3],J=s[7],nt=s[11],et=s[15];return r[0]=o*E+a*w+l*V+c*z,r[4]=o*I+a*T+l*W+c*J,r[8]=o*D+a*B+l*X+c*nt,r[12]=o*M+a*H+l*F+c*et,r[1]=u*E+h*w+f*V+p*z,r[5]=u*I+h*T+f*W+p*J,r[9]=u*D+h*B+f*X+p*nt,r[13]=u*M+h*H+f*F+p*et,r[2]=m*E+v*w+g*V+d*z,r[6]=m*I+v*T+g*W+d*J,r[10]=m*D+v*B+g*X+d*nt,r[14]=m*M+v*H+g*F+d*et,r[3]=b*E+S*w+y*V+P*z,r[7]=b*I+S*T+y*W+P*J,r[11]=b*D+S*B+y*X+P*nt,r[15]=b*M+S*H+y*F+P*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],p=t[14],m=t[3],v=t[7],g=t[11],d=t[15];return m*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*p-n*l*p)+v*(+e*l*p-e*c*f+r*o*f-s*o*p+s*c*u-r*l*u)+g*(+e*c*h-e*a*p-r*o*h+n*o*p+r*a*u-n*c*u)+d*(-s*a*u-e*l*h+e*a*f+s*o*h-n*o*f+n*l*u)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],p=t[11],m=t[12],v=t[13],g=t[14],d=t[15],b=h*g*c-v*f*c+v*l*p-a*g*p-h*l*d+a*f*d,S=m*f*c-u*g*c-m*l*p+o*g*p+u*l*d-o*f*d,y=u*v*c-m*h*c+m*a*p-o*v*p-u*a*d+o*h*d,P=m*h*l-u*v*l-m*a*f+o*v*f+u*a*g-o*h*g,E=e*b+n*S+s*y+r*P;if(E===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let I=1/E;return t[0]=b*I,t[1]=(v*f*r-h*g*r-v*s*p+n*g*p+h*s*d-n*f*d)*I,t[2]=(a*g*r-v*l*r+v*s*c-n*g*c-a*s*d+n*l*d)*I,t[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*p-n*l*p)*I,t[4]=S*I,t[5]=(u*g*r-m*f*r+m*s*p-e*g*p-u*s*d+e*f*d)*I,t[6]=(m*l*r-o*g*r-m*s*c+e*g*c+o*s*d-e*l*d)*I,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*p+e*l*p)*I,t[8]=y*I,t[9]=(m*h*r-u*v*r-m*n*p+e*v*p+u*n*d-e*h*d)*I,t[10]=(o*v*r-m*a*r+m*n*c-e*v*c-o*n*d+e*a*d)*I,t[11]=(u*a*r-o*h*r-u*n*c+e*h*c+o*n*p-e*a*p)*I,t[12]=P*I,t[13]=(u*v*s-m*h*s+m*n*f-e*v*f-u*n*g+e*h*g)*I,t[14]=(m*a*s-o*v*s-m*n*l+e*v*l+o*n*g-e*a*g)*I,t[15]=(o*h*s-u*a*s+u*n*l-e*h*l-o*n*f+e*a*f)*I,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,p=r*u,m=r*h,v=o*u,g=o*h,d=a*h,b=l*c,S=l*u,y=l*h,P=n.x,E=n.y,I=n.z;return s[0]=(1-(v+d))*P,s[1]=(p+y)*P,s[2]=(m-S)*P,s[3]=0,s[4]=(p-y)*E,s[5]=(1-(f+d))*E,s[6]=(g+b)*E,s[7]=0,s[8]=(m+S)*I,s[9]=(g-b)*I,s[10]=(1-(f+v))*I,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements,r=Yr.set(s[0],s[1],s[2]).length(),o=Yr.set(s[4],s[5],s[6]).length(),a=Yr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],Ri.copy(this);let c=1/r,u=1/o,h=1/a;return Ri.elements[0]*=c,Ri.elements[1]*=c,Ri.elements[2]*=c,Ri.elements[4]*=u,Ri.elements[5]*=u,Ri.elements[6]*=u,Ri.elements[8]*=h,Ri.elements[9]*=h,Ri.elements[10]*=h,e.setFromRotationMatrix(Ri),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(n-s),f=(e+t)/(e-t),p=(n+s)/(n-s),m,v;if(l)m=r/(o-r),v=o*r/(o-r);else if(a===Ii)m=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===da)m=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(e-t),h=2/(n-s),f=-(e+t)/(e-t),p=-(n+s)/(n-s),m,v;if(l)m=1/(o-r),v=o/(o-r);else if(a===Ii)m=-2/(o-r),v=-(o+r)/(o-r);else if(a===da)m=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Yr=new L,Ri=new Ue,mx=new L(0,0,0),gx=new L(1,1,1),Ds=new L,Tl=new L,si=new L,Fp=new Ue,Op=new sn,Ui=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(ie(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ie(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ie(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ie(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ie(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ie(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Fp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Fp,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Op.setFromEuler(this),this.setFromQuaternion(Op,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ui.DEFAULT_ORDER="XYZ";var ga=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},vx=0,Bp=new L,$r=new sn,us=new Ue,Al=new L,na=new L,_x=new L,xx=new sn,zp=new L(1,0,0),kp=new L(0,1,0),Hp=new L(0,0,1),Vp={type:"added"},yx={type:"removed"},Zr={type:"childadded",child:null},Uu={type:"childremoved",child:null},an=class i extends Zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:vx++}),this.uuid=ps(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new L,e=new Ui,n=new sn,s=new L(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ue},normalMatrix:{value:new ce}}),this.matrix=new Ue,this.matrixWorld=new Ue,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ga,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return $r.setFromAxisAngle(t,e),this.quaternion.multiply($r),this}rotateOnWorldAxis(t,e){return $r.setFromAxisAngle(t,e),this.quaternion.premultiply($r),this}rotateX(t){return this.rotateOnAxis(zp,t)}rotateY(t){return this.rotateOnAxis(kp,t)}rotateZ(t){return this.rotateOnAxis(Hp,t)}translateOnAxis(t,e){return Bp.copy(t).applyQuaternion(this.quaternion),this.position.add(Bp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(zp,t)}translateY(t){return this.translateOnAxis(kp,t)}translateZ(t){return this.translateOnAxis(Hp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(us.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Al.copy(t):Al.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?us.lookAt(na,Al,this.up):us.lookAt(Al,na,this.up),this.quaternion.setFromRotationMatrix(us),s&&(us.extractRotation(s.matrixWorld),$r.setFromRotationMatrix(us),this.quaternion.premultiply($r.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Vp),Zr.child=t,this.dispatchEvent(Zr),Zr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(yx),Uu.child=t,this.dispatchEvent(Uu),Uu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),us.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),us.multiply(t.parent.matrixWorld)),t.applyMatrix4(us),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Vp),Zr.child=t,this.dispatchEvent(Zr),Zr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,t,_x),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,xx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){let n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),p=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}};an.DEFAULT_UP=new L(0,1,0);an.DEFAULT_MATRIX_AUTO_UPDATE=!0;an.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ci=new L,fs=new L,Nu=new L,ds=new L,Kr=new L,Jr=new L,Gp=new L,Fu=new L,Ou=new L,Bu=new L,zu=new Ie,ku=new Ie,Hu=new Ie,$i=class i{constructor(t=new L,e=new L,n=new L){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Ci.subVectors(t,e),s.cross(Ci);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Ci.subVectors(s,e),fs.subVectors(n,e),Nu.subVectors(t,e);let o=Ci.dot(Ci),a=Ci.dot(fs),l=Ci.dot(Nu),c=fs.dot(fs),u=fs.dot(Nu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,m=(o*u-a*l)*f;return r.set(1-p-m,m,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,ds)===null?!1:ds.x>=0&&ds.y>=0&&ds.x+ds.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ds.x),l.addScaledVector(o,ds.y),l.addScaledVector(a,ds.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return zu.setScalar(0),ku.setScalar(0),Hu.setScalar(0),zu.fromBufferAttribute(t,e),ku.fromBufferAttribute(t,n),Hu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(zu,r.x),o.addScaledVector(ku,r.y),o.addScaledVector(Hu,r.z),o}static isFrontFacing(t,e,n,s){return Ci.subVectors(n,e),fs.subVectors(t,e),Ci.cross(fs).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ci.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ci.cross(fs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Kr.subVectors(s,n),Jr.subVectors(r,n),Fu.subVectors(t,n);let l=Kr.dot(Fu),c=Jr.dot(Fu);if(l<=0&&c<=0)return e.copy(n);Ou.subVectors(t,s);let u=Kr.dot(Ou),h=Jr.dot(Ou);if(u>=0&&h<=u)return e.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(n).addScaledVector(Kr,o);Bu.subVectors(t,r);let p=Kr.dot(Bu),m=Jr.dot(Bu);if(m>=0&&p<=m)return e.copy(r);let v=p*c-l*m;if(v<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(Jr,a);let g=u*m-p*h;if(g<=0&&h-u>=0&&p-m>=0)return Gp.subVectors(r,s),a=(h-u)/(h-u+(p-m)),e.copy(s).addScaledVector(Gp,a);let d=1/(g+v+f);return o=v*d,a=f*d,e.copy(n).addScaledVector(Kr,o).addScaledVector(Jr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Km={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Us={h:0,s:0,l:0},Rl={h:0,s:0,l:0};function Vu(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var ae=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Gn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=n,_e.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=_e.workingColorSpace){if(t=Cf(t,1),e=ie(e,0,1),n=ie(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Vu(o,r,t+1/3),this.g=Vu(o,r,t),this.b=Vu(o,r,t-1/3)}return _e.colorSpaceToWorking(this,s),this}setStyle(t,e=Gn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Gn){let n=Km[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ms(t.r),this.g=ms(t.g),this.b=ms(t.b),this}copyLinearToSRGB(t){return this.r=lo(t.r),this.g=lo(t.g),this.b=lo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Gn){return _e.workingToColorSpace(Pn.copy(this),t),Math.round(ie(Pn.r*255,0,255))*65536+Math.round(ie(Pn.g*255,0,255))*256+Math.round(ie(Pn.b*255,0,255))}getHexString(t=Gn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace(Pn.copy(this),e);let n=Pn.r,s=Pn.g,r=Pn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=_e.workingColorSpace){return _e.workingToColorSpace(Pn.copy(this),e),t.r=Pn.r,t.g=Pn.g,t.b=Pn.b,t}getStyle(t=Gn){_e.workingToColorSpace(Pn.copy(this),t);let e=Pn.r,n=Pn.g,s=Pn.b;return t!==Gn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Us),this.setHSL(Us.h+t,Us.s+e,Us.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Us),t.getHSL(Rl);let n=la(Us.h,Rl.h,e),s=la(Us.s,Rl.s,e),r=la(Us.l,Rl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Pn=new ae;ae.NAMES=Km;var bx=0,Ji=class extends Zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:bx++}),this.uuid=ps(),this.name="",this.type="Material",this.blending=ar,this.side=gs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Jl,this.blendDst=jl,this.blendEquation=Os,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ae(0,0,0),this.blendAlpha=0,this.depthFunc=lr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=rf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=or,this.stencilZFail=or,this.stencilZPass=or,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==ar&&(n.blending=this.blending),this.side!==gs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Jl&&(n.blendSrc=this.blendSrc),this.blendDst!==jl&&(n.blendDst=this.blendDst),this.blendEquation!==Os&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==lr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==rf&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==or&&(n.stencilFail=this.stencilFail),this.stencilZFail!==or&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==or&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},vi=class extends Ji{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ae(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.combine=pf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var nn=new L,Cl=new Ot,Mx=0,Je=class{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Mx++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=nc,this.updateRanges=[],this.gpuType=ts,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Cl.fromBufferAttribute(this,e),Cl.applyMatrix3(t),this.setXY(e,Cl.x,Cl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyMatrix3(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyMatrix4(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.applyNormalMatrix(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)nn.fromBufferAttribute(this,e),nn.transformDirection(t),this.setXYZ(e,nn.x,nn.y,nn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Ce(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Pi(e,this.array)),e}setX(t,e){return this.normalized&&(e=Ce(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Pi(e,this.array)),e}setY(t,e){return this.normalized&&(e=Ce(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Pi(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Ce(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Pi(e,this.array)),e}setW(t,e){return this.normalized&&(e=Ce(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array),s=Ce(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array),s=Ce(s,this.array),r=Ce(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==nc&&(t.usage=this.usage),t}};var va=class extends Je{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var _a=class extends Je{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var me=class extends Je{constructor(t,e,n){super(new Float32Array(t),e,n)}},wx=0,mi=new Ue,Gu=new an,jr=new L,ri=new yn,ia=new yn,xn=new L,Oe=class i extends Zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:wx++}),this.uuid=ps(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Pf(t)?_a:va)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ce().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return mi.makeRotationFromQuaternion(t),this.applyMatrix4(mi),this}rotateX(t){return mi.makeRotationX(t),this.applyMatrix4(mi),this}rotateY(t){return mi.makeRotationY(t),this.applyMatrix4(mi),this}rotateZ(t){return mi.makeRotationZ(t),this.applyMatrix4(mi),this}translate(t,e,n){return mi.makeTranslation(t,e,n),this.applyMatrix4(mi),this}scale(t,e,n){return mi.makeScale(t,e,n),this.applyMatrix4(mi),this}lookAt(t){return Gu.lookAt(t),Gu.updateMatrix(),this.applyMatrix4(Gu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(jr).negate(),this.translate(jr.x,jr.y,jr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new me(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new yn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new L(-1/0,-1/0,-1/0),new L(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(xn.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(xn),xn.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(xn)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new L,1/0);return}if(t){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(xn.addVectors(ri.min,ia.min),ri.expandByPoint(xn),xn.addVectors(ri.max,ia.max),ri.expandByPoint(xn)):(ri.expandByPoint(ia.min),ri.expandByPoint(ia.max))}ri.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)xn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(xn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)xn.fromBufferAttribute(a,c),l&&(jr.fromBufferAttribute(t,c),xn.add(jr)),s=Math.max(s,n.distanceToSquared(xn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Je(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let D=0;D<n.count;D++)a[D]=new L,l[D]=new L;let c=new L,u=new L,h=new L,f=new Ot,p=new Ot,m=new Ot,v=new L,g=new L;function d(D,M,w){c.fromBufferAttribute(n,D),u.fromBufferAttribute(n,M),h.fromBufferAttribute(n,w),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,M),m.fromBufferAttribute(r,w),u.sub(c),h.sub(c),p.sub(f),m.sub(f);let T=1/(p.x*m.y-m.x*p.y);isFinite(T)&&(v.copy(u).multiplyScalar(m.y).addScaledVector(h,-p.y).multiplyScalar(T),g.copy(h).multiplyScalar(p.x).addScaledVector(u,-m.x).multiplyScalar(T),a[D].add(v),a[M].add(v),a[w].add(v),l[D].add(g),l[M].add(g),l[w].add(g))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let D=0,M=b.length;D<M;++D){let w=b[D],T=w.start,B=w.count;for(let H=T,V=T+B;H<V;H+=3)d(t.getX(H+0),t.getX(H+1),t.getX(H+2))}let S=new L,y=new L,P=new L,E=new L;function I(D){P.fromBufferAttribute(s,D),E.copy(P);let M=a[D];S.copy(M),S.sub(P.multiplyScalar(P.dot(M))).normalize(),y.crossVectors(E,M);let T=y.dot(l[D])<0?-1:1;o.setXYZW(D,S.x,S.y,S.z,T)}for(let D=0,M=b.length;D<M;++D){let w=b[D],T=w.start,B=w.count;for(let H=T,V=T+B;H<V;H+=3)I(t.getX(H+0)),I(t.getX(H+1)),I(t.getX(H+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Je(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);let s=new L,r=new L,o=new L,a=new L,l=new L,c=new L,u=new L,h=new L;if(t)for(let f=0,p=t.count;f<p;f+=3){let m=t.getX(f+0),v=t.getX(f+1),g=t.getX(f+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,p=e.count;f<p;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)xn.fromBufferAttribute(t,e),xn.normalize(),t.setXYZ(e,xn.x,xn.y,xn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,m=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?p=l[v]*a.data.stride+a.offset:p=l[v]*u;for(let d=0;d<u;d++)f[m++]=c[p++]}return new Je(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=t(f,n);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Wp=new Ue,sr=new hr,Pl=new Di,Xp=new L,Il=new L,Ll=new L,Dl=new L,Wu=new L,Ul=new L,qp=new L,Nl=new L,Qt=class extends an{constructor(t=new Oe,e=new vi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ul.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Wu.fromBufferAttribute(h,t),o?Ul.addScaledVector(Wu,u):Ul.addScaledVector(Wu.sub(e),u))}e.add(Ul)}return e}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Pl.copy(n.boundingSphere),Pl.applyMatrix4(r),sr.copy(t.ray).recast(t.near),!(Pl.containsPoint(sr.origin)===!1&&(sr.intersectSphere(Pl,Xp)===null||sr.origin.distanceToSquared(Xp)>(t.far-t.near)**2))&&(Wp.copy(r).invert(),sr.copy(t.ray).applyMatrix4(Wp),!(n.boundingBox!==null&&sr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,sr)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,v=f.length;m<v;m++){let g=f[m],d=o[g.materialIndex],b=Math.max(g.start,p.start),S=Math.min(a.count,Math.min(g.start+g.count,p.start+p.count));for(let y=b,P=S;y<P;y+=3){let E=a.getX(y),I=a.getX(y+1),D=a.getX(y+2);s=Fl(this,d,t,n,c,u,h,E,I,D),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,p.start),v=Math.min(a.count,p.start+p.count);for(let g=m,d=v;g<d;g+=3){let b=a.getX(g),S=a.getX(g+1),y=a.getX(g+2);s=Fl(this,o,t,n,c,u,h,b,S,y),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,v=f.length;m<v;m++){let g=f[m],d=o[g.materialIndex],b=Math.max(g.start,p.start),S=Math.min(l.count,Math.min(g.start+g.count,p.start+p.count));for(let y=b,P=S;y<P;y+=3){let E=y,I=y+1,D=y+2;s=Fl(this,d,t,n,c,u,h,E,I,D),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,p.start),v=Math.min(l.count,p.start+p.count);for(let g=m,d=v;g<d;g+=3){let b=g,S=g+1,y=g+2;s=Fl(this,o,t,n,c,u,h,b,S,y),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Sx(i,t,e,n,s,r,o,a){let l;if(t.side===Wn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===gs,a),l===null)return null;Nl.copy(a),Nl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Nl);return c<e.near||c>e.far?null:{distance:c,point:Nl.clone(),object:i}}function Fl(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Il),i.getVertexPosition(l,Ll),i.getVertexPosition(c,Dl);let u=Sx(i,t,e,n,Il,Ll,Dl,qp);if(u){let h=new L;$i.getBarycoord(qp,Il,Ll,Dl,h),s&&(u.uv=$i.getInterpolatedAttribute(s,a,l,c,h,new Ot)),r&&(u.uv1=$i.getInterpolatedAttribute(r,a,l,c,h,new Ot)),o&&(u.normal=$i.getInterpolatedAttribute(o,a,l,c,h,new L),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new L,materialIndex:0};$i.getNormal(Il,Ll,Dl,f.normal),u.face=f,u.barycoord=h}return u}var ji=class i extends Oe{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;m("z","y","x",-1,-1,n,e,t,o,r,0),m("z","y","x",1,-1,n,e,-t,o,r,1),m("x","z","y",1,1,t,n,e,s,o,2),m("x","z","y",1,-1,t,n,-e,s,o,3),m("x","y","z",1,-1,t,e,n,s,r,4),m("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new me(c,3)),this.setAttribute("normal",new me(u,3)),this.setAttribute("uv",new me(h,2));function m(v,g,d,b,S,y,P,E,I,D,M){let w=y/I,T=P/D,B=y/2,H=P/2,V=E/2,W=I+1,X=D+1,F=0,z=0,J=new L;for(let nt=0;nt<X;nt++){let et=nt*T-H;for(let ct=0;ct<W;ct++){let ft=ct*w-B;J[v]=ft*b,J[g]=et*S,J[d]=V,c.push(J.x,J.y,J.z),J[v]=0,J[g]=0,J[d]=E>0?1:-1,u.push(J.x,J.y,J.z),h.push(ct/I),h.push(1-nt/D),F+=1}}for(let nt=0;nt<D;nt++)for(let et=0;et<I;et++){let ct=f+et+W*nt,ft=f+et+W*(nt+1),yt=f+(et+1)+W*(nt+1),xt=f+(et+1)+W*nt;l.push(ct,ft,xt),l.push(ft,yt,xt),z+=6}a.addGroup(p,z,M),p+=z,f+=F}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function _r(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function Dn(i){let t={};for(let e=0;e<i.length;e++){let n=_r(i[e]);for(let s in n)t[s]=n[s]}return t}function Ex(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function If(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var Ya={clone:_r,merge:Dn},Tx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ax=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,oi=class extends Ji{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Tx,this.fragmentShader=Ax,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=_r(t.uniforms),this.uniformsGroups=Ex(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}},xa=class extends an{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ue,this.projectionMatrix=new Ue,this.projectionMatrixInverse=new Ue,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Ns=new L,Yp=new Ot,$p=new Ot,In=class extends xa{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ho*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ao*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ho*2*Math.atan(Math.tan(ao*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ns.x,Ns.y).multiplyScalar(-t/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ns.x,Ns.y).multiplyScalar(-t/Ns.z)}getViewSize(t,e){return this.getViewBounds(t,Yp,$p),e.subVectors($p,Yp)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ao*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},Qr=-90,to=1,oc=class extends an{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new In(Qr,to,t,e);s.layers=this.layers,this.add(s);let r=new In(Qr,to,t,e);r.layers=this.layers,this.add(r);let o=new In(Qr,to,t,e);o.layers=this.layers,this.add(o);let a=new In(Qr,to,t,e);a.layers=this.layers,this.add(a);let l=new In(Qr,to,t,e);l.layers=this.layers,this.add(l);let c=new In(Qr,to,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ii)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===da)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=v,t.setRenderTarget(n,5,s),t.render(e,u),t.setRenderTarget(h,f,p),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},ya=class extends Kn{constructor(t=[],e=gr,n,s,r,o,a,l,c,u){super(t,e,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},ac=class extends Ki{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new ya(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ji(5,5,5),r=new oi({name:"CubemapFromEquirect",uniforms:_r(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Wn,blending:_s});r.uniforms.tEquirect.value=e;let o=new Qt(s,r),a=e.minFilter;return e.minFilter===Gs&&(e.minFilter=Li),new oc(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Ee=class extends an{constructor(){super(),this.isGroup=!0,this.type="Group"}},Rx={type:"move"},po=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ee,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ee,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new L,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new L),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ee,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new L,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new L),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let v of t.hand.values()){let g=e.getJointPose(v,n),d=this._getHandJoint(c,v);g!==null&&(d.matrix.fromArray(g.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=g.radius),d.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,m=.005;c.inputState.pinching&&f>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Rx)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ee;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}};var mo=class extends an{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ui,this.environmentIntensity=1,this.environmentRotation=new Ui,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}},go=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=nc,this.updateRanges=[],this.version=0,this.uuid=ps()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),t.arrayBuffers[this.array.buffer._uuid]===void 0&&(t.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);let e=new this.array.constructor(t.arrayBuffers[this.array.buffer._uuid]),n=new this.constructor(e,this.stride);return n.setUsage(this.usage),n}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){return t.arrayBuffers===void 0&&(t.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=ps()),t.arrayBuffers[this.array.buffer._uuid]===void 0&&(t.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}},Vn=new L,Jn=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)Vn.fromBufferAttribute(this,e),Vn.applyMatrix4(t),this.setXYZ(e,Vn.x,Vn.y,Vn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Vn.fromBufferAttribute(this,e),Vn.applyNormalMatrix(t),this.setXYZ(e,Vn.x,Vn.y,Vn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Vn.fromBufferAttribute(this,e),Vn.transformDirection(t),this.setXYZ(e,Vn.x,Vn.y,Vn.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=Pi(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Ce(n,this.array)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=Ce(e,this.array)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=Ce(e,this.array)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=Ce(e,this.array)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=Ce(e,this.array)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=Pi(e,this.array)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=Pi(e,this.array)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=Pi(e,this.array)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=Pi(e,this.array)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array),s=Ce(s,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ce(e,this.array),n=Ce(n,this.array),s=Ce(s,this.array),r=Ce(r,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){console.log("THREE.InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Je(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){console.log("THREE.InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}},vo=class extends Ji{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new ae(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},eo,sa=new L,no=new L,io=new L,so=new Ot,ra=new Ot,Jm=new Ue,Ol=new L,oa=new L,Bl=new L,Zp=new Ot,Xu=new Ot,Kp=new Ot,ba=class extends an{constructor(t=new vo){if(super(),this.isSprite=!0,this.type="Sprite",eo===void 0){eo=new Oe;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),n=new go(e,5);eo.setIndex([0,1,2,0,2,3]),eo.setAttribute("position",new Jn(n,3,0,!1)),eo.setAttribute("uv",new Jn(n,2,3,!1))}this.geometry=eo,this.material=t,this.center=new Ot(.5,.5),this.count=1}raycast(t,e){t.camera===null&&console.error('THREE.Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),no.setFromMatrixScale(this.matrixWorld),Jm.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),io.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&no.multiplyScalar(-io.z);let n=this.material.rotation,s,r;n!==0&&(r=Math.cos(n),s=Math.sin(n));let o=this.center;zl(Ol.set(-.5,-.5,0),io,o,no,s,r),zl(oa.set(.5,-.5,0),io,o,no,s,r),zl(Bl.set(.5,.5,0),io,o,no,s,r),Zp.set(0,0),Xu.set(1,0),Kp.set(1,1);let a=t.ray.intersectTriangle(Ol,oa,Bl,!1,sa);if(a===null&&(zl(oa.set(-.5,.5,0),io,o,no,s,r),Xu.set(0,1),a=t.ray.intersectTriangle(Ol,Bl,oa,!1,sa),a===null))return;let l=t.ray.origin.distanceTo(sa);l<t.near||l>t.far||e.push({distance:l,point:sa.clone(),uv:$i.getInterpolation(sa,Ol,oa,Bl,Zp,Xu,Kp,new Ot),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}};function zl(i,t,e,n,s,r){so.subVectors(i,e).addScalar(.5).multiply(n),s!==void 0?(ra.x=r*so.x-s*so.y,ra.y=s*so.x+r*so.y):ra.copy(so),i.copy(t),i.x+=ra.x,i.y+=ra.y,i.applyMatrix4(Jm)}var qu=new L,Cx=new L,Px=new ce,Zn=class{constructor(t=new L(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=qu.subVectors(n,e).cross(Cx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let n=t.delta(qu),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Px.getNormalMatrix(t),s=this.coplanarPoint(qu).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},rr=new Di,Ix=new Ot(.5,.5),kl=new L,_o=class{constructor(t=new Zn,e=new Zn,n=new Zn,s=new Zn,r=new Zn,o=new Zn){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ii,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],p=r[7],m=r[8],v=r[9],g=r[10],d=r[11],b=r[12],S=r[13],y=r[14],P=r[15];if(s[0].setComponents(c-o,p-u,d-m,P-b).normalize(),s[1].setComponents(c+o,p+u,d+m,P+b).normalize(),s[2].setComponents(c+a,p+h,d+v,P+S).normalize(),s[3].setComponents(c-a,p-h,d-v,P-S).normalize(),n)s[4].setComponents(l,f,g,y).normalize(),s[5].setComponents(c-l,p-f,d-g,P-y).normalize();else if(s[4].setComponents(c-l,p-f,d-g,P-y).normalize(),e===Ii)s[5].setComponents(c+l,p+f,d+g,P+y).normalize();else if(e===da)s[5].setComponents(l,f,g,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),rr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),rr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(rr)}intersectsSprite(t){rr.center.set(0,0,0);let e=Ix.distanceTo(t.center);return rr.radius=.7071067811865476+e,rr.applyMatrix4(t.matrixWorld),this.intersectsSphere(rr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(kl.x=s.normal.x>0?t.max.x:t.min.x,kl.y=s.normal.y>0?t.max.y:t.min.y,kl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(kl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var vs=class extends Ji{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ae(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},lc=new L,cc=new L,Jp=new Ue,aa=new hr,Hl=new Di,Yu=new L,jp=new L,ur=class extends an{constructor(t=new Oe,e=new vs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)lc.fromBufferAttribute(e,s-1),cc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=lc.distanceTo(cc);t.setAttribute("lineDistance",new me(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Hl.copy(n.boundingSphere),Hl.applyMatrix4(s),Hl.radius+=r,t.ray.intersectsSphere(Hl)===!1)return;Jp.copy(s).invert(),aa.copy(t.ray).applyMatrix4(Jp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let p=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let v=p,g=m-1;v<g;v+=c){let d=u.getX(v),b=u.getX(v+1),S=Vl(this,t,aa,l,d,b,v);S&&e.push(S)}if(this.isLineLoop){let v=u.getX(m-1),g=u.getX(p),d=Vl(this,t,aa,l,v,g,m-1);d&&e.push(d)}}else{let p=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let v=p,g=m-1;v<g;v+=c){let d=Vl(this,t,aa,l,v,v+1,v);d&&e.push(d)}if(this.isLineLoop){let v=Vl(this,t,aa,l,m-1,p,m-1);v&&e.push(v)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Vl(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(lc.fromBufferAttribute(a,s),cc.fromBufferAttribute(a,r),e.distanceSqToSegment(lc,cc,Yu,jp)>n)return;Yu.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Yu);if(!(c<t.near||c>t.far))return{distance:c,point:jp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Qp=new L,tm=new L,xo=class extends ur{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Qp.fromBufferAttribute(e,s),tm.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Qp.distanceTo(tm);t.setAttribute("lineDistance",new me(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ma=class extends Kn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},wa=class extends Kn{constructor(t,e,n=Ws,s,r,o,a=gi,l=gi,c,u=co,h=1){if(u!==co&&u!==So)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new fo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},Sa=class extends Kn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}};var fr=class i extends Oe{constructor(t=1,e=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:n,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],c=new L,u=new Ot;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let h=0,f=3;h<=e;h++,f+=3){let p=n+h/e*s;c.x=t*Math.cos(p),c.y=t*Math.sin(p),o.push(c.x,c.y,c.z),a.push(0,0,1),u.x=(o[f]/t+1)/2,u.y=(o[f+1]/t+1)/2,l.push(u.x,u.y)}for(let h=1;h<=e;h++)r.push(h,h+1,0);this.setIndex(r),this.setAttribute("position",new me(o,3)),this.setAttribute("normal",new me(a,3)),this.setAttribute("uv",new me(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.segments,t.thetaStart,t.thetaLength)}},wn=class i extends Oe{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],f=[],p=[],m=0,v=[],g=n/2,d=0;b(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(u),this.setAttribute("position",new me(h,3)),this.setAttribute("normal",new me(f,3)),this.setAttribute("uv",new me(p,2));function b(){let y=new L,P=new L,E=0,I=(e-t)/n;for(let D=0;D<=r;D++){let M=[],w=D/r,T=w*(e-t)+t;for(let B=0;B<=s;B++){let H=B/s,V=H*l+a,W=Math.sin(V),X=Math.cos(V);P.x=T*W,P.y=-w*n+g,P.z=T*X,h.push(P.x,P.y,P.z),y.set(W,I,X).normalize(),f.push(y.x,y.y,y.z),p.push(H,1-w),M.push(m++)}v.push(M)}for(let D=0;D<s;D++)for(let M=0;M<r;M++){let w=v[M][D],T=v[M+1][D],B=v[M+1][D+1],H=v[M][D+1];(t>0||M!==0)&&(u.push(w,T,H),E+=3),(e>0||M!==r-1)&&(u.push(T,B,H),E+=3)}c.addGroup(d,E,0),d+=E}function S(y){let P=m,E=new Ot,I=new L,D=0,M=y===!0?t:e,w=y===!0?1:-1;for(let B=1;B<=s;B++)h.push(0,g*w,0),f.push(0,w,0),p.push(.5,.5),m++;let T=m;for(let B=0;B<=s;B++){let V=B/s*l+a,W=Math.cos(V),X=Math.sin(V);I.x=M*X,I.y=g*w,I.z=M*W,h.push(I.x,I.y,I.z),f.push(0,w,0),E.x=W*.5+.5,E.y=X*.5*w+.5,p.push(E.x,E.y),m++}for(let B=0;B<s;B++){let H=P+B,V=T+B;y===!0?u.push(V,V+1,H):u.push(V+1,V,H),D+=3}c.addGroup(d,D,y===!0?1:2),d+=D}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},dr=class i extends wn{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Gl=new L,Wl=new L,$u=new L,Xl=new $i,Ea=class extends Oe{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(ao*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},p=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:v,b:g,c:d}=Xl;if(v.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),d.fromBufferAttribute(a,c[2]),Xl.getNormal($u),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,h[2]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let b=0;b<3;b++){let S=(b+1)%3,y=h[b],P=h[S],E=Xl[u[b]],I=Xl[u[S]],D=`${y}_${P}`,M=`${P}_${y}`;M in f&&f[M]?($u.dot(f[M].normal)<=r&&(p.push(E.x,E.y,E.z),p.push(I.x,I.y,I.z)),f[M]=null):D in f||(f[D]={index0:c[b],index1:c[S],normal:$u.clone()})}}for(let m in f)if(f[m]){let{index0:v,index1:g}=f[m];Gl.fromBufferAttribute(a,v),Wl.fromBufferAttribute(a,g),p.push(Gl.x,Gl.y,Gl.z),p.push(Wl.x,Wl.y,Wl.z)}this.setAttribute("position",new me(p,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},jn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let u=n[s],f=n[s+1]-u,p=(o-u)/f;return(s+p)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new Ot:new L);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new L,s=[],r=[],o=[],a=new L,l=new Ue;for(let p=0;p<=t;p++){let m=p/t;s[p]=this.getTangentAt(m,new L)}r[0]=new L,o[0]=new L;let c=Number.MAX_VALUE,u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let p=1;p<=t;p++){if(r[p]=r[p-1].clone(),o[p]=o[p-1].clone(),a.crossVectors(s[p-1],s[p]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(ie(s[p-1].dot(s[p]),-1,1));r[p].applyMatrix4(l.makeRotationAxis(a,m))}o[p].crossVectors(s[p],r[p])}if(e===!0){let p=Math.acos(ie(r[0].dot(r[t]),-1,1));p/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(p=-p);for(let m=1;m<=t;m++)r[m].applyMatrix4(l.makeRotationAxis(s[m],p*m)),o[m].crossVectors(s[m],r[m])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}},Ta=class extends jn{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new Ot){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,p=c-this.aY;l=f*u-p*h+this.aX,c=f*h+p*u+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},hc=class extends Ta{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Lf(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,p=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,p*=u,s(o,a,f,p)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var ql=new L,Zu=new Lf,Ku=new Lf,Ju=new Lf,uc=class extends jn{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new L){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:(ql.subVectors(s[0],s[1]).add(s[0]),c=ql);let h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(ql.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=ql),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(h),p),v=Math.pow(h.distanceToSquared(f),p),g=Math.pow(f.distanceToSquared(u),p);v<1e-4&&(v=1),m<1e-4&&(m=v),g<1e-4&&(g=v),Zu.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,m,v,g),Ku.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,m,v,g),Ju.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,m,v,g)}else this.curveType==="catmullrom"&&(Zu.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),Ku.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),Ju.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(Zu.calc(l),Ku.calc(l),Ju.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new L().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function em(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function Lx(i,t){let e=1-i;return e*e*t}function Dx(i,t){return 2*(1-i)*i*t}function Ux(i,t){return i*i*t}function ca(i,t,e,n){return Lx(i,t)+Dx(i,e)+Ux(i,n)}function Nx(i,t){let e=1-i;return e*e*e*t}function Fx(i,t){let e=1-i;return 3*e*e*i*t}function Ox(i,t){return 3*(1-i)*i*i*t}function Bx(i,t){return i*i*i*t}function ha(i,t,e,n,s){return Nx(i,t)+Fx(i,e)+Ox(i,n)+Bx(i,s)}var fc=class extends jn{constructor(t=new Ot,e=new Ot,n=new Ot,s=new Ot){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new Ot){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ha(t,s.x,r.x,o.x,a.x),ha(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},dc=class extends jn{constructor(t=new L,e=new L,n=new L,s=new L){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new L){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ha(t,s.x,r.x,o.x,a.x),ha(t,s.y,r.y,o.y,a.y),ha(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},pc=class extends jn{constructor(t=new Ot,e=new Ot){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Ot){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Ot){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},mc=class extends jn{constructor(t=new L,e=new L){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new L){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new L){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},gc=class extends jn{constructor(t=new Ot,e=new Ot,n=new Ot){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new Ot){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ca(t,s.x,r.x,o.x),ca(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Aa=class extends jn{constructor(t=new L,e=new L,n=new L){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new L){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ca(t,s.x,r.x,o.x),ca(t,s.y,r.y,o.y),ca(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},vc=class extends jn{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Ot){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(em(a,l.x,c.x,u.x,h.x),em(a,l.y,c.y,u.y,h.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new Ot().fromArray(s))}return this}},zx=Object.freeze({__proto__:null,ArcCurve:hc,CatmullRomCurve3:uc,CubicBezierCurve:fc,CubicBezierCurve3:dc,EllipseCurve:Ta,LineCurve:pc,LineCurve3:mc,QuadraticBezierCurve:gc,QuadraticBezierCurve3:Aa,SplineCurve:vc});var Ra=class i extends Oe{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,p=[],m=[],v=[],g=[];for(let d=0;d<u;d++){let b=d*f-o;for(let S=0;S<c;S++){let y=S*h-r;m.push(y,-b,0),v.push(0,0,1),g.push(S/a),g.push(1-d/l)}}for(let d=0;d<l;d++)for(let b=0;b<a;b++){let S=b+c*d,y=b+c*(d+1),P=b+1+c*(d+1),E=b+1+c*d;p.push(S,y,E),p.push(y,P,E)}this.setIndex(p),this.setAttribute("position",new me(m,3)),this.setAttribute("normal",new me(v,3)),this.setAttribute("uv",new me(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ca=class i extends Oe{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new L,f=new L,p=[],m=[],v=[],g=[];for(let d=0;d<=n;d++){let b=[],S=d/n,y=0;d===0&&o===0?y=.5/e:d===n&&l===Math.PI&&(y=-.5/e);for(let P=0;P<=e;P++){let E=P/e;h.x=-t*Math.cos(s+E*r)*Math.sin(o+S*a),h.y=t*Math.cos(o+S*a),h.z=t*Math.sin(s+E*r)*Math.sin(o+S*a),m.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),g.push(E+y,1-S),b.push(c++)}u.push(b)}for(let d=0;d<n;d++)for(let b=0;b<e;b++){let S=u[d][b+1],y=u[d][b],P=u[d+1][b],E=u[d+1][b+1];(d!==0||o>0)&&p.push(S,y,E),(d!==n-1||l<Math.PI)&&p.push(y,P,E)}this.setIndex(p),this.setAttribute("position",new me(m,3)),this.setAttribute("normal",new me(v,3)),this.setAttribute("uv",new me(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Pa=class i extends Oe{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);let o=[],a=[],l=[],c=[],u=new L,h=new L,f=new L;for(let p=0;p<=n;p++)for(let m=0;m<=s;m++){let v=m/s*r,g=p/n*Math.PI*2;h.x=(t+e*Math.cos(g))*Math.cos(v),h.y=(t+e*Math.cos(g))*Math.sin(v),h.z=e*Math.sin(g),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(m/s),c.push(p/n)}for(let p=1;p<=n;p++)for(let m=1;m<=s;m++){let v=(s+1)*p+m-1,g=(s+1)*(p-1)+m-1,d=(s+1)*(p-1)+m,b=(s+1)*p+m;o.push(v,g,b),o.push(g,d,b)}this.setIndex(o),this.setAttribute("position",new me(a,3)),this.setAttribute("normal",new me(l,3)),this.setAttribute("uv",new me(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}};var Ia=class i extends Oe{constructor(t=new Aa(new L(-1,-1,0),new L(-1,1,0),new L(1,1,0)),e=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:t,tubularSegments:e,radius:n,radialSegments:s,closed:r};let o=t.computeFrenetFrames(e,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new L,l=new L,c=new Ot,u=new L,h=[],f=[],p=[],m=[];v(),this.setIndex(m),this.setAttribute("position",new me(h,3)),this.setAttribute("normal",new me(f,3)),this.setAttribute("uv",new me(p,2));function v(){for(let S=0;S<e;S++)g(S);g(r===!1?e:0),b(),d()}function g(S){u=t.getPointAt(S/e,u);let y=o.normals[S],P=o.binormals[S];for(let E=0;E<=s;E++){let I=E/s*Math.PI*2,D=Math.sin(I),M=-Math.cos(I);l.x=M*y.x+D*P.x,l.y=M*y.y+D*P.y,l.z=M*y.z+D*P.z,l.normalize(),f.push(l.x,l.y,l.z),a.x=u.x+n*l.x,a.y=u.y+n*l.y,a.z=u.z+n*l.z,h.push(a.x,a.y,a.z)}}function d(){for(let S=1;S<=e;S++)for(let y=1;y<=s;y++){let P=(s+1)*(S-1)+(y-1),E=(s+1)*S+(y-1),I=(s+1)*S+y,D=(s+1)*(S-1)+y;m.push(P,E,D),m.push(E,I,D)}}function b(){for(let S=0;S<=e;S++)for(let y=0;y<=s;y++)c.x=S/e,c.y=y/s,p.push(c.x,c.y)}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON();return t.path=this.parameters.path.toJSON(),t}static fromJSON(t){return new i(new zx[t.path.type]().fromJSON(t.path),t.tubularSegments,t.radius,t.radialSegments,t.closed)}},La=class extends Oe{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,s=new L,r=new L;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],f=h.start,p=h.count;for(let m=f,v=f+p;m<v;m+=3)for(let g=0;g<3;g++){let d=a.getX(m+g),b=a.getX(m+(g+1)%3);s.fromBufferAttribute(o,d),r.fromBufferAttribute(o,b),nm(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),nm(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new me(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function nm(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(s)===!0?!1:(e.add(n),e.add(s),!0)}var Ni=class extends Ji{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ae(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ae(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Sf,this.normalScale=new Ot(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var _c=class extends Ji{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Bm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},xc=class extends Ji{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Yl(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function kx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var pr=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},yc=class extends pr{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ef,endingEnd:ef}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case nf:r=t,a=2*e-n;break;case sf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case nf:o=t,l=2*n-e;break;case sf:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,p=this._weightNext,m=(n-e)/(s-e),v=m*m,g=v*m,d=-f*g+2*f*v-f*m,b=(1+f)*g+(-1.5-2*f)*v+(-.5+f)*m+1,S=(-1-p)*g+(1.5+p)*v+.5*m,y=p*g-p*v;for(let P=0;P!==a;++P)r[P]=d*o[u+P]+b*o[c+P]+S*o[l+P]+y*o[h+P];return r}},bc=class extends pr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(n-e)/(s-e),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Mc=class extends pr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},ai=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Yl(e,this.TimeBufferType),this.values=Yl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Yl(t.times,Array),values:Yl(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s)}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Mc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new bc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new yc(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case ua:e=this.InterpolantFactoryMethodDiscrete;break;case ec:e=this.InterpolantFactoryMethodLinear;break;case Kl:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ua;case this.InterpolantFactoryMethodLinear:return ec;case this.InterpolantFactoryMethodSmooth:return Kl}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&kx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Kl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*n,f=h-n,p=h+n;for(let m=0;m!==n;++m){let v=e[h+m];if(v!==e[f+m]||v!==e[p+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*n,f=o*n;for(let p=0;p!==n;++p)e[f+p]=e[h+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};ai.prototype.ValueTypeName="";ai.prototype.TimeBufferType=Float32Array;ai.prototype.ValueBufferType=Float32Array;ai.prototype.DefaultInterpolation=ec;var Bs=class extends ai{constructor(t,e,n){super(t,e,n)}};Bs.prototype.ValueTypeName="bool";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=ua;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var wc=class extends ai{constructor(t,e,n,s){super(t,e,n,s)}};wc.prototype.ValueTypeName="color";var Sc=class extends ai{constructor(t,e,n,s){super(t,e,n,s)}};Sc.prototype.ValueTypeName="number";var Ec=class extends pr{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)sn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Da=class extends ai{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Ec(this.times,this.values,this.getValueSize(),t)}};Da.prototype.ValueTypeName="quaternion";Da.prototype.InterpolantFactoryMethodSmooth=void 0;var zs=class extends ai{constructor(t,e,n){super(t,e,n)}};zs.prototype.ValueTypeName="string";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=ua;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Tc=class extends ai{constructor(t,e,n,s){super(t,e,n,s)}};Tc.prototype.ValueTypeName="vector";var Ac=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let p=c[h],m=c[h+1];if(p.global&&(p.lastIndex=0),p.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},jm=new Ac,Rc=class{constructor(t){this.manager=t!==void 0?t:jm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}abort(){return this}};Rc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ua=class extends an{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ae(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}},Na=class extends Ua{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(an.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ae(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}},ju=new Ue,im=new L,sm=new L,of=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ot(512,512),this.mapType=Fi,this.map=null,this.mapPass=null,this.matrix=new Ue,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new _o,this._frameExtents=new Ot(1,1),this._viewportCount=1,this._viewports=[new Ie(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera,n=this.matrix;im.setFromMatrixPosition(t.matrixWorld),e.position.copy(im),sm.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(sm),e.updateMatrixWorld(),ju.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(ju,e.coordinateSystem,e.reversedDepth),e.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(ju)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}};var mr=class extends xa{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},af=class extends of{constructor(){super(new mr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fa=class extends Ua{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(an.DEFAULT_UP),this.updateMatrix(),this.target=new an,this.shadow=new af}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}};var Oa=class extends Oe{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Cc=class extends In{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}};var Df="\\[\\]\\.:\\/",Hx=new RegExp("["+Df+"]","g"),Uf="[^"+Df+"]",Vx="[^"+Df.replace("\\.","")+"]",Gx=/((?:WC+[\/:])*)/.source.replace("WC",Uf),Wx=/(WCOD+)?/.source.replace("WCOD",Vx),Xx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Uf),qx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Uf),Yx=new RegExp("^"+Gx+Wx+Xx+qx+"$"),$x=["material","materials","bones","map"],lf=class{constructor(t,e,n){let s=n||qe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},qe=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Hx,"")}static parseTrackName(t){let e=Yx.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);$x.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qe.Composite=lf;qe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qe.prototype.GetterByBindingType=[qe.prototype._getValue_direct,qe.prototype._getValue_array,qe.prototype._getValue_arrayElement,qe.prototype._getValue_toArray];qe.prototype.SetterByBindingTypeAndVersioning=[[qe.prototype._setValue_direct,qe.prototype._setValue_direct_setNeedsUpdate,qe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_array,qe.prototype._setValue_array_setNeedsUpdate,qe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_arrayElement,qe.prototype._setValue_arrayElement_setNeedsUpdate,qe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qe.prototype._setValue_fromArray,qe.prototype._setValue_fromArray_setNeedsUpdate,qe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var lA=new Float32Array(1);var ks=class extends go{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var yo=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ie(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ie(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var rm=new L,$l=new L,ro=new L,oo=new L,Qu=new L,Zx=new L,Kx=new L,Ba=class{constructor(t=new L,e=new L){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){rm.subVectors(t,this.start),$l.subVectors(this.end,this.start);let n=$l.dot($l),r=$l.dot(rm)/n;return e&&(r=ie(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=Zx,n=Kx){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,u=t.end;ro.subVectors(c,a),oo.subVectors(u,l),Qu.subVectors(a,l);let h=ro.dot(ro),f=oo.dot(oo),p=oo.dot(Qu);if(h<=s&&f<=s)return e.copy(a),n.copy(l),e.sub(n),e.dot(e);if(h<=s)r=0,o=p/f,o=ie(o,0,1);else{let m=ro.dot(Qu);if(f<=s)o=0,r=ie(-m/h,0,1);else{let v=ro.dot(oo),g=h*f-v*v;g!==0?r=ie((v*p-m*f)/g,0,1):r=0,o=(v*r+p)/f,o<0?(o=0,r=ie(-m/h,0,1)):o>1&&(o=1,r=ie((v-m)/h,0,1))}}return e.copy(a).add(ro.multiplyScalar(r)),n.copy(l).add(oo.multiplyScalar(o)),e.sub(n),e.dot(e)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var om=new L,Zl,tf,za=class extends an{constructor(t=new L(0,0,1),e=new L(0,0,0),n=1,s=16776960,r=n*.2,o=r*.2){super(),this.type="ArrowHelper",Zl===void 0&&(Zl=new Oe,Zl.setAttribute("position",new me([0,0,0,0,1,0],3)),tf=new dr(.5,1,5,1),tf.translate(0,-.5,0)),this.position.copy(e),this.line=new ur(Zl,new vs({color:s,toneMapped:!1})),this.line.matrixAutoUpdate=!1,this.add(this.line),this.cone=new Qt(tf,new vi({color:s,toneMapped:!1})),this.cone.matrixAutoUpdate=!1,this.add(this.cone),this.setDirection(t),this.setLength(n,r,o)}setDirection(t){if(t.y>.99999)this.quaternion.set(0,0,0,1);else if(t.y<-.99999)this.quaternion.set(1,0,0,0);else{om.set(t.z,0,-t.x).normalize();let e=Math.acos(t.y);this.quaternion.setFromAxisAngle(om,e)}}setLength(t,e=t*.2,n=e*.2){this.line.scale.set(1,Math.max(1e-4,t-e),1),this.line.updateMatrix(),this.cone.scale.set(n,e,n),this.cone.position.y=t,this.cone.updateMatrix()}setColor(t){this.line.material.color.set(t),this.cone.material.color.set(t)}copy(t){return super.copy(t,!1),this.line.copy(t.line),this.cone.copy(t.cone),this}dispose(){this.line.geometry.dispose(),this.line.material.dispose(),this.cone.geometry.dispose(),this.cone.material.dispose()}};var ka=class extends Zi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){if(t===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Nf(i,t,e,n){let s=Jx(n);switch(e){case yf:return i*t;case Mf:return i*t/s.components*s.byteLength;case Gc:return i*t/s.components*s.byteLength;case wf:return i*t*2/s.components*s.byteLength;case Wc:return i*t*2/s.components*s.byteLength;case bf:return i*t*3/s.components*s.byteLength;case _i:return i*t*4/s.components*s.byteLength;case Xc:return i*t*4/s.components*s.byteLength;case Ga:case Wa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Xa:case qa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Yc:case Zc:return Math.max(i,16)*Math.max(t,8)/4;case qc:case $c:return Math.max(i,8)*Math.max(t,8)/2;case Kc:case Jc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case jc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Qc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case th:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case eh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case nh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ih:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case sh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case rh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case oh:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case ah:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case lh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case ch:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case hh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case uh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case fh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case dh:case ph:case mh:return Math.ceil(i/4)*Math.ceil(t/4)*16;case gh:case vh:return Math.ceil(i/4)*Math.ceil(t/4)*8;case _h:case xh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Jx(i){switch(i){case Fi:case gf:return{byteLength:1,components:1};case bo:case vf:case Mo:return{byteLength:2,components:1};case Hc:case Vc:return{byteLength:2,components:4};case Ws:case kc:case ts:return{byteLength:4,components:1};case _f:case xf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function Mg(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function iy(i){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((p,m)=>p.start-m.start);let f=0;for(let p=1;p<h.length;p++){let m=h[f],v=h[p];v.start<=m.start+m.count+1?m.count=Math.max(m.count,v.start+v.count-m.start):(++f,h[f]=v)}h.length=f+1;for(let p=0,m=h.length;p<m;p++){let v=h[p];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var sy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ry=`#ifdef USE_ALPHAHASH
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
#endif`,oy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,ay=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ly=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,hy=`#ifdef USE_AOMAP
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
#endif`,uy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,fy=`#ifdef USE_BATCHING
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
#endif`,dy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,py=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,my=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,gy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,vy=`#ifdef USE_IRIDESCENCE
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
#endif`,_y=`#ifdef USE_BUMPMAP
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
#endif`,xy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,yy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,by=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,My=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,wy=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Sy=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Ey=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Ty=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Ay=`#define PI 3.141592653589793
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
} // validated`,Ry=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Cy=`vec3 transformedNormal = objectNormal;
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
#endif`,Py=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Iy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Ly=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Dy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Uy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ny=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Fy=`#ifdef USE_ENVMAP
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
#endif`,Oy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,By=`#ifdef USE_ENVMAP
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
#endif`,zy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ky=`#ifdef USE_ENVMAP
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
#endif`,Hy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Vy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Gy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Wy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Xy=`#ifdef USE_GRADIENTMAP
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
}`,qy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Yy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,$y=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Zy=`uniform bool receiveShadow;
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
#endif`,Ky=`#ifdef USE_ENVMAP
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
#endif`,Jy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,jy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Qy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,tb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,eb=`PhysicalMaterial material;
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
#endif`,nb=`struct PhysicalMaterial {
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
}`,ib=`
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
#endif`,sb=`#if defined( RE_IndirectDiffuse )
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
#endif`,rb=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,ob=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ab=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,cb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,hb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,ub=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,fb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,db=`#if defined( USE_POINTS_UV )
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
#endif`,pb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,mb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,gb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,vb=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,_b=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xb=`#ifdef USE_MORPHTARGETS
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
#endif`,yb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,bb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Mb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,wb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Sb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Eb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Tb=`#ifdef USE_NORMALMAP
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
#endif`,Ab=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Rb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Cb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Pb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Ib=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Lb=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Db=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ub=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Nb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Fb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Ob=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Bb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,zb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,kb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Hb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Vb=`float getShadowMask() {
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
}`,Gb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Wb=`#ifdef USE_SKINNING
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
#endif`,Xb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,qb=`#ifdef USE_SKINNING
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
#endif`,Yb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,$b=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Zb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Kb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Jb=`#ifdef USE_TRANSMISSION
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
#endif`,jb=`#ifdef USE_TRANSMISSION
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
#endif`,Qb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,tM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,eM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,nM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,iM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,sM=`uniform sampler2D t2D;
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
}`,rM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,oM=`#ifdef ENVMAP_TYPE_CUBE
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
}`,aM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cM=`#include <common>
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
}`,hM=`#if DEPTH_PACKING == 3200
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
}`,uM=`#define DISTANCE
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
}`,fM=`#define DISTANCE
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
}`,dM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,pM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mM=`uniform float scale;
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
}`,gM=`uniform vec3 diffuse;
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
}`,vM=`#include <common>
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
}`,_M=`uniform vec3 diffuse;
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
}`,xM=`#define LAMBERT
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
}`,yM=`#define LAMBERT
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
}`,bM=`#define MATCAP
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
}`,MM=`#define MATCAP
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
}`,wM=`#define NORMAL
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
}`,SM=`#define NORMAL
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
}`,EM=`#define PHONG
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
}`,TM=`#define PHONG
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
}`,AM=`#define STANDARD
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
}`,RM=`#define STANDARD
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
}`,CM=`#define TOON
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
}`,PM=`#define TOON
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
}`,IM=`uniform float size;
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
}`,LM=`uniform vec3 diffuse;
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
}`,DM=`#include <common>
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
}`,UM=`uniform vec3 color;
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
}`,NM=`uniform float rotation;
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
}`,FM=`uniform vec3 diffuse;
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
}`,fe={alphahash_fragment:sy,alphahash_pars_fragment:ry,alphamap_fragment:oy,alphamap_pars_fragment:ay,alphatest_fragment:ly,alphatest_pars_fragment:cy,aomap_fragment:hy,aomap_pars_fragment:uy,batching_pars_vertex:fy,batching_vertex:dy,begin_vertex:py,beginnormal_vertex:my,bsdfs:gy,iridescence_fragment:vy,bumpmap_pars_fragment:_y,clipping_planes_fragment:xy,clipping_planes_pars_fragment:yy,clipping_planes_pars_vertex:by,clipping_planes_vertex:My,color_fragment:wy,color_pars_fragment:Sy,color_pars_vertex:Ey,color_vertex:Ty,common:Ay,cube_uv_reflection_fragment:Ry,defaultnormal_vertex:Cy,displacementmap_pars_vertex:Py,displacementmap_vertex:Iy,emissivemap_fragment:Ly,emissivemap_pars_fragment:Dy,colorspace_fragment:Uy,colorspace_pars_fragment:Ny,envmap_fragment:Fy,envmap_common_pars_fragment:Oy,envmap_pars_fragment:By,envmap_pars_vertex:zy,envmap_physical_pars_fragment:Ky,envmap_vertex:ky,fog_vertex:Hy,fog_pars_vertex:Vy,fog_fragment:Gy,fog_pars_fragment:Wy,gradientmap_pars_fragment:Xy,lightmap_pars_fragment:qy,lights_lambert_fragment:Yy,lights_lambert_pars_fragment:$y,lights_pars_begin:Zy,lights_toon_fragment:Jy,lights_toon_pars_fragment:jy,lights_phong_fragment:Qy,lights_phong_pars_fragment:tb,lights_physical_fragment:eb,lights_physical_pars_fragment:nb,lights_fragment_begin:ib,lights_fragment_maps:sb,lights_fragment_end:rb,logdepthbuf_fragment:ob,logdepthbuf_pars_fragment:ab,logdepthbuf_pars_vertex:lb,logdepthbuf_vertex:cb,map_fragment:hb,map_pars_fragment:ub,map_particle_fragment:fb,map_particle_pars_fragment:db,metalnessmap_fragment:pb,metalnessmap_pars_fragment:mb,morphinstance_vertex:gb,morphcolor_vertex:vb,morphnormal_vertex:_b,morphtarget_pars_vertex:xb,morphtarget_vertex:yb,normal_fragment_begin:bb,normal_fragment_maps:Mb,normal_pars_fragment:wb,normal_pars_vertex:Sb,normal_vertex:Eb,normalmap_pars_fragment:Tb,clearcoat_normal_fragment_begin:Ab,clearcoat_normal_fragment_maps:Rb,clearcoat_pars_fragment:Cb,iridescence_pars_fragment:Pb,opaque_fragment:Ib,packing:Lb,premultiplied_alpha_fragment:Db,project_vertex:Ub,dithering_fragment:Nb,dithering_pars_fragment:Fb,roughnessmap_fragment:Ob,roughnessmap_pars_fragment:Bb,shadowmap_pars_fragment:zb,shadowmap_pars_vertex:kb,shadowmap_vertex:Hb,shadowmask_pars_fragment:Vb,skinbase_vertex:Gb,skinning_pars_vertex:Wb,skinning_vertex:Xb,skinnormal_vertex:qb,specularmap_fragment:Yb,specularmap_pars_fragment:$b,tonemapping_fragment:Zb,tonemapping_pars_fragment:Kb,transmission_fragment:Jb,transmission_pars_fragment:jb,uv_pars_fragment:Qb,uv_pars_vertex:tM,uv_vertex:eM,worldpos_vertex:nM,background_vert:iM,background_frag:sM,backgroundCube_vert:rM,backgroundCube_frag:oM,cube_vert:aM,cube_frag:lM,depth_vert:cM,depth_frag:hM,distanceRGBA_vert:uM,distanceRGBA_frag:fM,equirect_vert:dM,equirect_frag:pM,linedashed_vert:mM,linedashed_frag:gM,meshbasic_vert:vM,meshbasic_frag:_M,meshlambert_vert:xM,meshlambert_frag:yM,meshmatcap_vert:bM,meshmatcap_frag:MM,meshnormal_vert:wM,meshnormal_frag:SM,meshphong_vert:EM,meshphong_frag:TM,meshphysical_vert:AM,meshphysical_frag:RM,meshtoon_vert:CM,meshtoon_frag:PM,points_vert:IM,points_frag:LM,shadow_vert:DM,shadow_frag:UM,sprite_vert:NM,sprite_frag:FM},Dt={common:{diffuse:{value:new ae(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ce}},envmap:{envMap:{value:null},envMapRotation:{value:new ce},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ce}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ce}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ce},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ce},normalScale:{value:new Ot(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ce},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ce}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ce}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ce}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ae(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ae(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0},uvTransform:{value:new ce}},sprite:{diffuse:{value:new ae(16777215)},opacity:{value:1},center:{value:new Ot(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ce},alphaMap:{value:null},alphaMapTransform:{value:new ce},alphaTest:{value:0}}},Xn={basic:{uniforms:Dn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:Dn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new ae(0)}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:Dn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new ae(0)},specular:{value:new ae(1118481)},shininess:{value:30}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:Dn([Dt.common,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.roughnessmap,Dt.metalnessmap,Dt.fog,Dt.lights,{emissive:{value:new ae(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:Dn([Dt.common,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.gradientmap,Dt.fog,Dt.lights,{emissive:{value:new ae(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:Dn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:Dn([Dt.points,Dt.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:Dn([Dt.common,Dt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:Dn([Dt.common,Dt.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:Dn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:Dn([Dt.sprite,Dt.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new ce},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ce}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distanceRGBA:{uniforms:Dn([Dt.common,Dt.displacementmap,{referencePosition:{value:new L},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distanceRGBA_vert,fragmentShader:fe.distanceRGBA_frag},shadow:{uniforms:Dn([Dt.lights,Dt.fog,{color:{value:new ae(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};Xn.physical={uniforms:Dn([Xn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ce},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ce},clearcoatNormalScale:{value:new Ot(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ce},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ce},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ce},sheen:{value:0},sheenColor:{value:new ae(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ce},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ce},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ce},transmissionSamplerSize:{value:new Ot},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ce},attenuationDistance:{value:0},attenuationColor:{value:new ae(0)},specularColor:{value:new ae(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ce},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ce},anisotropyVector:{value:new Ot},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ce}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var yh={r:0,b:0,g:0},xr=new Ui,OM=new Ue;function BM(i,t,e,n,s,r,o){let a=new ae(0),l=r===!0?0:1,c,u,h=null,f=0,p=null;function m(S){let y=S.isScene===!0?S.background:null;return y&&y.isTexture&&(y=(S.backgroundBlurriness>0?e:t).get(y)),y}function v(S){let y=!1,P=m(S);P===null?d(a,l):P&&P.isColor&&(d(P,1),y=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?n.buffers.color.setClear(0,0,0,1,o):E==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||y)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function g(S,y){let P=m(y);P&&(P.isCubeTexture||P.mapping===Ha)?(u===void 0&&(u=new Qt(new ji(1,1,1),new oi({name:"BackgroundCubeMaterial",uniforms:_r(Xn.backgroundCube.uniforms),vertexShader:Xn.backgroundCube.vertexShader,fragmentShader:Xn.backgroundCube.fragmentShader,side:Wn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(E,I,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),xr.copy(y.backgroundRotation),xr.x*=-1,xr.y*=-1,xr.z*=-1,P.isCubeTexture&&P.isRenderTargetTexture===!1&&(xr.y*=-1,xr.z*=-1),u.material.uniforms.envMap.value=P,u.material.uniforms.flipEnvMap.value=P.isCubeTexture&&P.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=y.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(OM.makeRotationFromEuler(xr)),u.material.toneMapped=_e.getTransfer(P.colorSpace)!==Pe,(h!==P||f!==P.version||p!==i.toneMapping)&&(u.material.needsUpdate=!0,h=P,f=P.version,p=i.toneMapping),u.layers.enableAll(),S.unshift(u,u.geometry,u.material,0,0,null)):P&&P.isTexture&&(c===void 0&&(c=new Qt(new Ra(2,2),new oi({name:"BackgroundMaterial",uniforms:_r(Xn.background.uniforms),vertexShader:Xn.background.vertexShader,fragmentShader:Xn.background.fragmentShader,side:gs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=P,c.material.uniforms.backgroundIntensity.value=y.backgroundIntensity,c.material.toneMapped=_e.getTransfer(P.colorSpace)!==Pe,P.matrixAutoUpdate===!0&&P.updateMatrix(),c.material.uniforms.uvTransform.value.copy(P.matrix),(h!==P||f!==P.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,h=P,f=P.version,p=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function d(S,y){S.getRGB(yh,If(i)),n.buffers.color.setClear(yh.r,yh.g,yh.b,y,o)}function b(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,y=1){a.set(S),l=y,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(S){l=S,d(a,l)},render:v,addToRenderList:g,dispose:b}}function zM(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,o=!1;function a(w,T,B,H,V){let W=!1,X=h(H,B,T);r!==X&&(r=X,c(r.object)),W=p(w,H,B,V),W&&m(w,H,B,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,y(w,T,B,H),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(w){return i.bindVertexArray(w)}function u(w){return i.deleteVertexArray(w)}function h(w,T,B){let H=B.wireframe===!0,V=n[w.id];V===void 0&&(V={},n[w.id]=V);let W=V[T.id];W===void 0&&(W={},V[T.id]=W);let X=W[H];return X===void 0&&(X=f(l()),W[H]=X),X}function f(w){let T=[],B=[],H=[];for(let V=0;V<e;V++)T[V]=0,B[V]=0,H[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:T,enabledAttributes:B,attributeDivisors:H,object:w,attributes:{},index:null}}function p(w,T,B,H){let V=r.attributes,W=T.attributes,X=0,F=B.getAttributes();for(let z in F)if(F[z].location>=0){let nt=V[z],et=W[z];if(et===void 0&&(z==="instanceMatrix"&&w.instanceMatrix&&(et=w.instanceMatrix),z==="instanceColor"&&w.instanceColor&&(et=w.instanceColor)),nt===void 0||nt.attribute!==et||et&&nt.data!==et.data)return!0;X++}return r.attributesNum!==X||r.index!==H}function m(w,T,B,H){let V={},W=T.attributes,X=0,F=B.getAttributes();for(let z in F)if(F[z].location>=0){let nt=W[z];nt===void 0&&(z==="instanceMatrix"&&w.instanceMatrix&&(nt=w.instanceMatrix),z==="instanceColor"&&w.instanceColor&&(nt=w.instanceColor));let et={};et.attribute=nt,nt&&nt.data&&(et.data=nt.data),V[z]=et,X++}r.attributes=V,r.attributesNum=X,r.index=H}function v(){let w=r.newAttributes;for(let T=0,B=w.length;T<B;T++)w[T]=0}function g(w){d(w,0)}function d(w,T){let B=r.newAttributes,H=r.enabledAttributes,V=r.attributeDivisors;B[w]=1,H[w]===0&&(i.enableVertexAttribArray(w),H[w]=1),V[w]!==T&&(i.vertexAttribDivisor(w,T),V[w]=T)}function b(){let w=r.newAttributes,T=r.enabledAttributes;for(let B=0,H=T.length;B<H;B++)T[B]!==w[B]&&(i.disableVertexAttribArray(B),T[B]=0)}function S(w,T,B,H,V,W,X){X===!0?i.vertexAttribIPointer(w,T,B,V,W):i.vertexAttribPointer(w,T,B,H,V,W)}function y(w,T,B,H){v();let V=H.attributes,W=B.getAttributes(),X=T.defaultAttributeValues;for(let F in W){let z=W[F];if(z.location>=0){let J=V[F];if(J===void 0&&(F==="instanceMatrix"&&w.instanceMatrix&&(J=w.instanceMatrix),F==="instanceColor"&&w.instanceColor&&(J=w.instanceColor)),J!==void 0){let nt=J.normalized,et=J.itemSize,ct=t.get(J);if(ct===void 0)continue;let ft=ct.buffer,yt=ct.type,xt=ct.bytesPerElement,tt=yt===i.INT||yt===i.UNSIGNED_INT||J.gpuType===kc;if(J.isInterleavedBufferAttribute){let $=J.data,mt=$.stride,vt=J.offset;if($.isInstancedInterleavedBuffer){for(let bt=0;bt<z.locationSize;bt++)d(z.location+bt,$.meshPerAttribute);w.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=$.meshPerAttribute*$.count)}else for(let bt=0;bt<z.locationSize;bt++)g(z.location+bt);i.bindBuffer(i.ARRAY_BUFFER,ft);for(let bt=0;bt<z.locationSize;bt++)S(z.location+bt,et/z.locationSize,yt,nt,mt*xt,(vt+et/z.locationSize*bt)*xt,tt)}else{if(J.isInstancedBufferAttribute){for(let $=0;$<z.locationSize;$++)d(z.location+$,J.meshPerAttribute);w.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let $=0;$<z.locationSize;$++)g(z.location+$);i.bindBuffer(i.ARRAY_BUFFER,ft);for(let $=0;$<z.locationSize;$++)S(z.location+$,et/z.locationSize,yt,nt,et*xt,et/z.locationSize*$*xt,tt)}}else if(X!==void 0){let nt=X[F];if(nt!==void 0)switch(nt.length){case 2:i.vertexAttrib2fv(z.location,nt);break;case 3:i.vertexAttrib3fv(z.location,nt);break;case 4:i.vertexAttrib4fv(z.location,nt);break;default:i.vertexAttrib1fv(z.location,nt)}}}}b()}function P(){D();for(let w in n){let T=n[w];for(let B in T){let H=T[B];for(let V in H)u(H[V].object),delete H[V];delete T[B]}delete n[w]}}function E(w){if(n[w.id]===void 0)return;let T=n[w.id];for(let B in T){let H=T[B];for(let V in H)u(H[V].object),delete H[V];delete T[B]}delete n[w.id]}function I(w){for(let T in n){let B=n[T];if(B[w.id]===void 0)continue;let H=B[w.id];for(let V in H)u(H[V].object),delete H[V];delete B[w.id]}}function D(){M(),o=!0,r!==s&&(r=s,c(r.object))}function M(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:M,dispose:P,releaseStatesOfGeometry:E,releaseStatesOfProgram:I,initAttributes:v,enableAttribute:g,disableUnusedAttributes:b}}function kM(i,t,e){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),e.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),e.update(u,n,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let p=0;for(let m=0;m<h;m++)p+=u[m];e.update(p,n,1)}function l(c,u,h,f){if(h===0)return;let p=t.get("WEBGL_multi_draw");if(p===null)for(let m=0;m<c.length;m++)o(c[m],u[m],f[m]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let m=0;for(let v=0;v<h;v++)m+=u[v]*f[v];e.update(m,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function HM(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let I=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(I.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(I){return!(I!==_i&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(I){let D=I===Mo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(I!==Fi&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&I!==ts&&!D)}function l(I){if(I==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";I="mediump"}return I==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.logarithmicDepthBuffer===!0,f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),y=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=m>0,E=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:m,maxTextureSize:v,maxCubemapSize:g,maxAttributes:d,maxVertexUniforms:b,maxVaryings:S,maxFragmentUniforms:y,vertexTextures:P,maxSamples:E}}function VM(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Zn,a=new ce,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||n!==0||s;return s=f,n=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,p){let m=h.clippingPlanes,v=h.clipIntersection,g=h.clipShadows,d=i.get(h);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let b=r?0:n,S=b*4,y=d.clippingState||null;l.value=y,y=u(m,f,S,p);for(let P=0;P!==S;++P)y[P]=e[P];d.clippingState=y,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,p,m){let v=h!==null?h.length:0,g=null;if(v!==0){if(g=l.value,m!==!0||g===null){let d=p+v*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(g===null||g.length<d)&&(g=new Float32Array(d));for(let S=0,y=p;S!==v;++S,y+=4)o.copy(h[S]).applyMatrix4(b,a),o.normal.toArray(g,y),g[y+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,g}}function GM(i){let t=new WeakMap;function e(o,a){return a===Oc?o.mapping=gr:a===Bc&&(o.mapping=vr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Oc||a===Bc)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new ac(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}var To=4,Qm=[.125,.215,.35,.446,.526,.582],Mr=20,Ff=new mr,tg=new ae,Of=null,Bf=0,zf=0,kf=!1,br=(1+Math.sqrt(5))/2,Eo=1/br,eg=[new L(-br,Eo,0),new L(br,Eo,0),new L(-Eo,0,br),new L(Eo,0,br),new L(0,br,-Eo),new L(0,br,Eo),new L(-1,1,-1),new L(1,1,-1),new L(-1,1,1),new L(1,1,1)],WM=new L,wh=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=WM}=r;Of=this._renderer.getRenderTarget(),Bf=this._renderer.getActiveCubeFace(),zf=this._renderer.getActiveMipmapLevel(),kf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,n,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=sg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ig(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Of,Bf,zf),this._renderer.xr.enabled=kf,t.scissorTest=!1,bh(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===gr||t.mapping===vr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Of=this._renderer.getRenderTarget(),Bf=this._renderer.getActiveCubeFace(),zf=this._renderer.getActiveMipmapLevel(),kf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:Li,minFilter:Li,generateMipmaps:!1,type:Mo,format:_i,colorSpace:cr,depthBuffer:!1},s=ng(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=ng(t,e,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=XM(r)),this._blurMaterial=qM(r,t,e)}return s}_compileMaterial(t){let e=new Qt(this._lodPlanes[0],t);this._renderer.compile(e,Ff)}_sceneToCubeUV(t,e,n,s,r){let l=new In(90,1,e,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,p=h.toneMapping;h.getClearColor(tg),h.toneMapping=xs,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let v=new vi({name:"PMREM.Background",side:Wn,depthWrite:!1,depthTest:!1}),g=new Qt(new ji,v),d=!1,b=t.background;b?b.isColor&&(v.color.copy(b),t.background=null,d=!0):(v.color.copy(tg),d=!0);for(let S=0;S<6;S++){let y=S%3;y===0?(l.up.set(0,c[S],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[S],r.y,r.z)):y===1?(l.up.set(0,0,c[S]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[S],r.z)):(l.up.set(0,c[S],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[S]));let P=this._cubeSize;bh(s,y*P,S>2?P:0,P,P),h.setRenderTarget(s),d&&h.render(g,l),h.render(t,l)}g.geometry.dispose(),g.material.dispose(),h.toneMapping=p,h.autoClear=f,t.background=b}_textureToCubeUV(t,e){let n=this._renderer,s=t.mapping===gr||t.mapping===vr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=sg()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=ig());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Qt(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;bh(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,Ff)}_applyPMREM(t){let e=this._renderer,n=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=eg[(s-r-1)%eg.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new Qt(this._lodPlanes[s],c),f=c.uniforms,p=this._sizeLods[n]-1,m=isFinite(r)?Math.PI/(2*p):2*Math.PI/(2*Mr-1),v=r/m,g=isFinite(r)?1+Math.floor(u*v):Mr;g>Mr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${g} samples when the maximum is set to ${Mr}`);let d=[],b=0;for(let I=0;I<Mr;++I){let D=I/v,M=Math.exp(-D*D/2);d.push(M),I===0?b+=M:I<g&&(b+=2*M)}for(let I=0;I<d.length;I++)d[I]=d[I]/b;f.envMap.value=t.texture,f.samples.value=g,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:S}=this;f.dTheta.value=m,f.mipInt.value=S-n;let y=this._sizeLods[s],P=3*y*(s>S-To?s-S+To:0),E=4*(this._cubeSize-y);bh(e,P,E,3*y,2*y),l.setRenderTarget(e),l.render(h,Ff)}};function XM(i){let t=[],e=[],n=[],s=i,r=i-To+1+Qm.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>i-To?l=Qm[o-i+To-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],p=6,m=6,v=3,g=2,d=1,b=new Float32Array(v*m*p),S=new Float32Array(g*m*p),y=new Float32Array(d*m*p);for(let E=0;E<p;E++){let I=E%3*2/3-1,D=E>2?0:-1,M=[I,D,0,I+2/3,D,0,I+2/3,D+1,0,I,D,0,I+2/3,D+1,0,I,D+1,0];b.set(M,v*m*E),S.set(f,g*m*E);let w=[E,E,E,E,E,E];y.set(w,d*m*E)}let P=new Oe;P.setAttribute("position",new Je(b,v)),P.setAttribute("uv",new Je(S,g)),P.setAttribute("faceIndex",new Je(y,d)),t.push(P),s>To&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function ng(i,t,e){let n=new Ki(i,t,e);return n.texture.mapping=Ha,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function bh(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function qM(i,t,e){let n=new Float32Array(Mr),s=new L(0,1,0);return new oi({name:"SphericalGaussianBlur",defines:{n:Mr,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Kf(),fragmentShader:`

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
	`}function YM(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Oc||l===Bc,u=l===gr||l===vr;if(c||u){let h=t.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new wh(i)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{let p=a.image;return c&&p&&p.height>0||u&&p&&s(p)?(e===null&&(e=new wh(i)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function $M(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&uo("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function ZM(i,t,e,n){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&t.remove(f.index);for(let m in f.attributes)t.remove(f.attributes[m]);f.removeEventListener("dispose",o),delete s[f.id];let p=r.get(f);p&&(t.remove(p),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){let f=h.attributes;for(let p in f)t.update(f[p],i.ARRAY_BUFFER)}function c(h){let f=[],p=h.index,m=h.attributes.position,v=0;if(p!==null){let b=p.array;v=p.version;for(let S=0,y=b.length;S<y;S+=3){let P=b[S+0],E=b[S+1],I=b[S+2];f.push(P,E,E,I,I,P)}}else if(m!==void 0){let b=m.array;v=m.version;for(let S=0,y=b.length/3-1;S<y;S+=3){let P=S+0,E=S+1,I=S+2;f.push(P,E,E,I,I,P)}}else return;let g=new(Pf(f)?_a:va)(f,1);g.version=v;let d=r.get(h);d&&t.remove(d),r.set(h,g)}function u(h){let f=r.get(h);if(f){let p=h.index;p!==null&&f.version<p.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function KM(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,p){i.drawElements(n,p,r,f*o),e.update(p,n,1)}function c(f,p,m){m!==0&&(i.drawElementsInstanced(n,p,r,f*o,m),e.update(p,n,m))}function u(f,p,m){if(m===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,r,f,0,m);let g=0;for(let d=0;d<m;d++)g+=p[d];e.update(g,n,1)}function h(f,p,m,v){if(m===0)return;let g=t.get("WEBGL_multi_draw");if(g===null)for(let d=0;d<f.length;d++)c(f[d]/o,p[d],v[d]);else{g.multiDrawElementsInstancedWEBGL(n,p,0,r,f,0,v,0,m);let d=0;for(let b=0;b<m;b++)d+=p[b]*v[b];e.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function JM(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function jM(i,t,e){let n=new WeakMap,s=new Ie;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let M=function(){I.dispose(),n.delete(a),a.removeEventListener("dispose",M)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],S=0;p===!0&&(S=1),m===!0&&(S=2),v===!0&&(S=3);let y=a.attributes.position.count*S,P=1;y>t.maxTextureSize&&(P=Math.ceil(y/t.maxTextureSize),y=t.maxTextureSize);let E=new Float32Array(y*P*4*h),I=new ma(E,y,P,h);I.type=ts,I.needsUpdate=!0;let D=S*4;for(let w=0;w<h;w++){let T=g[w],B=d[w],H=b[w],V=y*P*4*w;for(let W=0;W<T.count;W++){let X=W*D;p===!0&&(s.fromBufferAttribute(T,W),E[V+X+0]=s.x,E[V+X+1]=s.y,E[V+X+2]=s.z,E[V+X+3]=0),m===!0&&(s.fromBufferAttribute(B,W),E[V+X+4]=s.x,E[V+X+5]=s.y,E[V+X+6]=s.z,E[V+X+7]=0),v===!0&&(s.fromBufferAttribute(H,W),E[V+X+8]=s.x,E[V+X+9]=s.y,E[V+X+10]=s.z,E[V+X+11]=H.itemSize===4?s.w:1)}}f={count:h,texture:I,size:new Ot(y,P)},n.set(a,f),a.addEventListener("dispose",M)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let p=0;for(let v=0;v<c.length;v++)p+=c[v];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function QM(i,t,e,n){let s=new WeakMap;function r(l){let c=n.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var wg=new Kn,rg=new wa(1,1),Sg=new ma,Eg=new rc,Tg=new ya,og=[],ag=[],lg=new Float32Array(16),cg=new Float32Array(9),hg=new Float32Array(4);function Ro(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=og[s];if(r===void 0&&(r=new Float32Array(s),og[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function ln(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function cn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Eh(i,t){let e=ag[t];e===void 0&&(e=new Int32Array(t),ag[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function tw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function ew(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ln(e,t))return;i.uniform2fv(this.addr,t),cn(e,t)}}function nw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(ln(e,t))return;i.uniform3fv(this.addr,t),cn(e,t)}}function iw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ln(e,t))return;i.uniform4fv(this.addr,t),cn(e,t)}}function sw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ln(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),cn(e,t)}else{if(ln(e,n))return;hg.set(n),i.uniformMatrix2fv(this.addr,!1,hg),cn(e,n)}}function rw(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ln(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),cn(e,t)}else{if(ln(e,n))return;cg.set(n),i.uniformMatrix3fv(this.addr,!1,cg),cn(e,n)}}function ow(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(ln(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),cn(e,t)}else{if(ln(e,n))return;lg.set(n),i.uniformMatrix4fv(this.addr,!1,lg),cn(e,n)}}function aw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function lw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ln(e,t))return;i.uniform2iv(this.addr,t),cn(e,t)}}function cw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ln(e,t))return;i.uniform3iv(this.addr,t),cn(e,t)}}function hw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ln(e,t))return;i.uniform4iv(this.addr,t),cn(e,t)}}function uw(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function fw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ln(e,t))return;i.uniform2uiv(this.addr,t),cn(e,t)}}function dw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ln(e,t))return;i.uniform3uiv(this.addr,t),cn(e,t)}}function pw(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ln(e,t))return;i.uniform4uiv(this.addr,t),cn(e,t)}}function mw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(rg.compareFunction=Af,r=rg):r=wg,e.setTexture2D(t||r,s)}function gw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Eg,s)}function vw(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||Tg,s)}function _w(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Sg,s)}function xw(i){switch(i){case 5126:return tw;case 35664:return ew;case 35665:return nw;case 35666:return iw;case 35674:return sw;case 35675:return rw;case 35676:return ow;case 5124:case 35670:return aw;case 35667:case 35671:return lw;case 35668:case 35672:return cw;case 35669:case 35673:return hw;case 5125:return uw;case 36294:return fw;case 36295:return dw;case 36296:return pw;case 35678:case 36198:case 36298:case 36306:case 35682:return mw;case 35679:case 36299:case 36307:return gw;case 35680:case 36300:case 36308:case 36293:return vw;case 36289:case 36303:case 36311:case 36292:return _w}}function yw(i,t){i.uniform1fv(this.addr,t)}function bw(i,t){let e=Ro(t,this.size,2);i.uniform2fv(this.addr,e)}function Mw(i,t){let e=Ro(t,this.size,3);i.uniform3fv(this.addr,e)}function ww(i,t){let e=Ro(t,this.size,4);i.uniform4fv(this.addr,e)}function Sw(i,t){let e=Ro(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Ew(i,t){let e=Ro(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Tw(i,t){let e=Ro(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Aw(i,t){i.uniform1iv(this.addr,t)}function Rw(i,t){i.uniform2iv(this.addr,t)}function Cw(i,t){i.uniform3iv(this.addr,t)}function Pw(i,t){i.uniform4iv(this.addr,t)}function Iw(i,t){i.uniform1uiv(this.addr,t)}function Lw(i,t){i.uniform2uiv(this.addr,t)}function Dw(i,t){i.uniform3uiv(this.addr,t)}function Uw(i,t){i.uniform4uiv(this.addr,t)}function Nw(i,t,e){let n=this.cache,s=t.length,r=Eh(e,s);ln(n,r)||(i.uniform1iv(this.addr,r),cn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||wg,r[o])}function Fw(i,t,e){let n=this.cache,s=t.length,r=Eh(e,s);ln(n,r)||(i.uniform1iv(this.addr,r),cn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Eg,r[o])}function Ow(i,t,e){let n=this.cache,s=t.length,r=Eh(e,s);ln(n,r)||(i.uniform1iv(this.addr,r),cn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Tg,r[o])}function Bw(i,t,e){let n=this.cache,s=t.length,r=Eh(e,s);ln(n,r)||(i.uniform1iv(this.addr,r),cn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Sg,r[o])}function zw(i){switch(i){case 5126:return yw;case 35664:return bw;case 35665:return Mw;case 35666:return ww;case 35674:return Sw;case 35675:return Ew;case 35676:return Tw;case 5124:case 35670:return Aw;case 35667:case 35671:return Rw;case 35668:case 35672:return Cw;case 35669:case 35673:return Pw;case 5125:return Iw;case 36294:return Lw;case 36295:return Dw;case 36296:return Uw;case 35678:case 36198:case 36298:case 36306:case 35682:return Nw;case 35679:case 36299:case 36307:return Fw;case 35680:case 36300:case 36308:case 36293:return Ow;case 36289:case 36303:case 36311:case 36292:return Bw}}var Vf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=xw(e.type)}},Gf=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=zw(e.type)}},Wf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Hf=/(\w+)(\])?(\[|\.)?/g;function ug(i,t){i.seq.push(t),i.map[t.id]=t}function kw(i,t,e){let n=i.name,s=n.length;for(Hf.lastIndex=0;;){let r=Hf.exec(n),o=Hf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ug(e,c===void 0?new Vf(a,i,t):new Gf(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new Wf(a),ug(e,h)),e=h}}}var Ao=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);kw(r,o,this)}}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function fg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Hw=37297,Vw=0;function Gw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var dg=new ce;function Ww(i){_e._getMatrix(dg,_e.workingColorSpace,i);let t=`mat3( ${dg.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(i)){case fa:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function pg(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Gw(i.getShaderSource(t),a)}else return r}function Xw(i,t){let e=Ww(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function qw(i,t){let e;switch(t){case Pm:e="Linear";break;case Im:e="Reinhard";break;case Lm:e="Cineon";break;case Dm:e="ACESFilmic";break;case Nm:e="AgX";break;case Fm:e="Neutral";break;case Um:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Mh=new L;function Yw(){_e.getLuminanceCoefficients(Mh);let i=Mh.x.toFixed(4),t=Mh.y.toFixed(4),e=Mh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function $w(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($a).join(`
`)}function Zw(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Kw(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function $a(i){return i!==""}function mg(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function gg(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Jw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Xf(i){return i.replace(Jw,Qw)}var jw=new Map;function Qw(i,t){let e=fe[t];if(e===void 0){let n=jw.get(t);if(n!==void 0)e=fe[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return Xf(e)}var tS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function vg(i){return i.replace(tS,eS)}function eS(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function _g(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}function nS(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===hf?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===cm?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Qi&&(t="SHADOWMAP_TYPE_VSM"),t}function iS(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case gr:case vr:t="ENVMAP_TYPE_CUBE";break;case Ha:t="ENVMAP_TYPE_CUBE_UV";break}return t}function sS(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case vr:t="ENVMAP_MODE_REFRACTION";break}return t}function rS(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case pf:t="ENVMAP_BLENDING_MULTIPLY";break;case Rm:t="ENVMAP_BLENDING_MIX";break;case Cm:t="ENVMAP_BLENDING_ADD";break}return t}function oS(i){let t=i.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function aS(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=nS(e),c=iS(e),u=sS(e),h=rS(e),f=oS(e),p=$w(e),m=Zw(r),v=s.createProgram(),g,d,b=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter($a).join(`
`),g.length>0&&(g+=`
`),d=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m].filter($a).join(`
`),d.length>0&&(d+=`
`)):(g=[_g(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($a).join(`
`),d=[_g(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,m,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==xs?"#define TONE_MAPPING":"",e.toneMapping!==xs?fe.tonemapping_pars_fragment:"",e.toneMapping!==xs?qw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,Xw("linearToOutputTexel",e.outputColorSpace),Yw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter($a).join(`
`)),o=Xf(o),o=mg(o,e),o=gg(o,e),a=Xf(a),a=mg(a,e),a=gg(a,e),o=vg(o),a=vg(a),e.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,g=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,d=["#define varying in",e.glslVersion===Rf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Rf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let S=b+g+o,y=b+d+a,P=fg(s,s.VERTEX_SHADER,S),E=fg(s,s.FRAGMENT_SHADER,y);s.attachShader(v,P),s.attachShader(v,E),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function I(T){if(i.debug.checkShaderErrors){let B=s.getProgramInfoLog(v)||"",H=s.getShaderInfoLog(P)||"",V=s.getShaderInfoLog(E)||"",W=B.trim(),X=H.trim(),F=V.trim(),z=!0,J=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,P,E);else{let nt=pg(s,P,"vertex"),et=pg(s,E,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+W+`
`+nt+`
`+et)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(X===""||F==="")&&(J=!1);J&&(T.diagnostics={runnable:z,programLog:W,vertexShader:{log:X,prefix:g},fragmentShader:{log:F,prefix:d}})}s.deleteShader(P),s.deleteShader(E),D=new Ao(s,v),M=Kw(s,v)}let D;this.getUniforms=function(){return D===void 0&&I(this),D};let M;this.getAttributes=function(){return M===void 0&&I(this),M};let w=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return w===!1&&(w=s.getProgramParameter(v,Hw)),w},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Vw++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=P,this.fragmentShader=E,this}var lS=0,qf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Yf(t),e.set(t,n)),n}},Yf=class{constructor(t){this.id=lS++,this.code=t,this.usedTimes=0}};function cS(i,t,e,n,s,r,o){let a=new ga,l=new qf,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,p=s.precision,m={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(M){return c.add(M),M===0?"uv":`uv${M}`}function g(M,w,T,B,H){let V=B.fog,W=H.geometry,X=M.isMeshStandardMaterial?B.environment:null,F=(M.isMeshStandardMaterial?e:t).get(M.envMap||X),z=F&&F.mapping===Ha?F.image.height:null,J=m[M.type];M.precision!==null&&(p=s.getMaxPrecision(M.precision),p!==M.precision&&console.warn("THREE.WebGLProgram.getParameters:",M.precision,"not supported, using",p,"instead."));let nt=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,et=nt!==void 0?nt.length:0,ct=0;W.morphAttributes.position!==void 0&&(ct=1),W.morphAttributes.normal!==void 0&&(ct=2),W.morphAttributes.color!==void 0&&(ct=3);let ft,yt,xt,tt;if(J){let xe=Xn[J];ft=xe.vertexShader,yt=xe.fragmentShader}else ft=M.vertexShader,yt=M.fragmentShader,l.update(M),xt=l.getVertexShaderID(M),tt=l.getFragmentShaderID(M);let $=i.getRenderTarget(),mt=i.state.buffers.depth.getReversed(),vt=H.isInstancedMesh===!0,bt=H.isBatchedMesh===!0,Gt=!!M.map,de=!!M.matcap,k=!!F,he=!!M.aoMap,st=!!M.lightMap,wt=!!M.bumpMap,Pt=!!M.normalMap,oe=!!M.displacementMap,rt=!!M.emissiveMap,Q=!!M.metalnessMap,ut=!!M.roughnessMap,St=M.anisotropy>0,C=M.clearcoat>0,x=M.dispersion>0,N=M.iridescence>0,q=M.sheen>0,lt=M.transmission>0,ot=St&&!!M.anisotropyMap,Ut=C&&!!M.clearcoatMap,_t=C&&!!M.clearcoatNormalMap,Ft=C&&!!M.clearcoatRoughnessMap,Bt=N&&!!M.iridescenceMap,gt=N&&!!M.iridescenceThicknessMap,Ct=q&&!!M.sheenColorMap,qt=q&&!!M.sheenRoughnessMap,Yt=!!M.specularMap,Lt=!!M.specularColorMap,Zt=!!M.specularIntensityMap,Y=lt&&!!M.transmissionMap,Tt=lt&&!!M.thicknessMap,Rt=!!M.gradientMap,Vt=!!M.alphaMap,Et=M.alphaTest>0,pt=!!M.alphaHash,$t=!!M.extensions,se=xs;M.toneMapped&&($===null||$.isXRRenderTarget===!0)&&(se=i.toneMapping);let Le={shaderID:J,shaderType:M.type,shaderName:M.name,vertexShader:ft,fragmentShader:yt,defines:M.defines,customVertexShaderID:xt,customFragmentShaderID:tt,isRawShaderMaterial:M.isRawShaderMaterial===!0,glslVersion:M.glslVersion,precision:p,batching:bt,batchingColor:bt&&H._colorsTexture!==null,instancing:vt,instancingColor:vt&&H.instanceColor!==null,instancingMorph:vt&&H.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:$===null?i.outputColorSpace:$.isXRRenderTarget===!0?$.texture.colorSpace:cr,alphaToCoverage:!!M.alphaToCoverage,map:Gt,matcap:de,envMap:k,envMapMode:k&&F.mapping,envMapCubeUVHeight:z,aoMap:he,lightMap:st,bumpMap:wt,normalMap:Pt,displacementMap:f&&oe,emissiveMap:rt,normalMapObjectSpace:Pt&&M.normalMapType===km,normalMapTangentSpace:Pt&&M.normalMapType===Sf,metalnessMap:Q,roughnessMap:ut,anisotropy:St,anisotropyMap:ot,clearcoat:C,clearcoatMap:Ut,clearcoatNormalMap:_t,clearcoatRoughnessMap:Ft,dispersion:x,iridescence:N,iridescenceMap:Bt,iridescenceThicknessMap:gt,sheen:q,sheenColorMap:Ct,sheenRoughnessMap:qt,specularMap:Yt,specularColorMap:Lt,specularIntensityMap:Zt,transmission:lt,transmissionMap:Y,thicknessMap:Tt,gradientMap:Rt,opaque:M.transparent===!1&&M.blending===ar&&M.alphaToCoverage===!1,alphaMap:Vt,alphaTest:Et,alphaHash:pt,combine:M.combine,mapUv:Gt&&v(M.map.channel),aoMapUv:he&&v(M.aoMap.channel),lightMapUv:st&&v(M.lightMap.channel),bumpMapUv:wt&&v(M.bumpMap.channel),normalMapUv:Pt&&v(M.normalMap.channel),displacementMapUv:oe&&v(M.displacementMap.channel),emissiveMapUv:rt&&v(M.emissiveMap.channel),metalnessMapUv:Q&&v(M.metalnessMap.channel),roughnessMapUv:ut&&v(M.roughnessMap.channel),anisotropyMapUv:ot&&v(M.anisotropyMap.channel),clearcoatMapUv:Ut&&v(M.clearcoatMap.channel),clearcoatNormalMapUv:_t&&v(M.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Ft&&v(M.clearcoatRoughnessMap.channel),iridescenceMapUv:Bt&&v(M.iridescenceMap.channel),iridescenceThicknessMapUv:gt&&v(M.iridescenceThicknessMap.channel),sheenColorMapUv:Ct&&v(M.sheenColorMap.channel),sheenRoughnessMapUv:qt&&v(M.sheenRoughnessMap.channel),specularMapUv:Yt&&v(M.specularMap.channel),specularColorMapUv:Lt&&v(M.specularColorMap.channel),specularIntensityMapUv:Zt&&v(M.specularIntensityMap.channel),transmissionMapUv:Y&&v(M.transmissionMap.channel),thicknessMapUv:Tt&&v(M.thicknessMap.channel),alphaMapUv:Vt&&v(M.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Pt||St),vertexColors:M.vertexColors,vertexAlphas:M.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:H.isPoints===!0&&!!W.attributes.uv&&(Gt||Vt),fog:!!V,useFog:M.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:M.flatShading===!0&&M.wireframe===!1,sizeAttenuation:M.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:mt,skinning:H.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:ct,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:M.dithering,shadowMapEnabled:i.shadowMap.enabled&&T.length>0,shadowMapType:i.shadowMap.type,toneMapping:se,decodeVideoTexture:Gt&&M.map.isVideoTexture===!0&&_e.getTransfer(M.map.colorSpace)===Pe,decodeVideoTextureEmissive:rt&&M.emissiveMap.isVideoTexture===!0&&_e.getTransfer(M.emissiveMap.colorSpace)===Pe,premultipliedAlpha:M.premultipliedAlpha,doubleSided:M.side===Ln,flipSided:M.side===Wn,useDepthPacking:M.depthPacking>=0,depthPacking:M.depthPacking||0,index0AttributeName:M.index0AttributeName,extensionClipCullDistance:$t&&M.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:($t&&M.extensions.multiDraw===!0||bt)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:M.customProgramCacheKey()};return Le.vertexUv1s=c.has(1),Le.vertexUv2s=c.has(2),Le.vertexUv3s=c.has(3),c.clear(),Le}function d(M){let w=[];if(M.shaderID?w.push(M.shaderID):(w.push(M.customVertexShaderID),w.push(M.customFragmentShaderID)),M.defines!==void 0)for(let T in M.defines)w.push(T),w.push(M.defines[T]);return M.isRawShaderMaterial===!1&&(b(w,M),S(w,M),w.push(i.outputColorSpace)),w.push(M.customProgramCacheKey),w.join()}function b(M,w){M.push(w.precision),M.push(w.outputColorSpace),M.push(w.envMapMode),M.push(w.envMapCubeUVHeight),M.push(w.mapUv),M.push(w.alphaMapUv),M.push(w.lightMapUv),M.push(w.aoMapUv),M.push(w.bumpMapUv),M.push(w.normalMapUv),M.push(w.displacementMapUv),M.push(w.emissiveMapUv),M.push(w.metalnessMapUv),M.push(w.roughnessMapUv),M.push(w.anisotropyMapUv),M.push(w.clearcoatMapUv),M.push(w.clearcoatNormalMapUv),M.push(w.clearcoatRoughnessMapUv),M.push(w.iridescenceMapUv),M.push(w.iridescenceThicknessMapUv),M.push(w.sheenColorMapUv),M.push(w.sheenRoughnessMapUv),M.push(w.specularMapUv),M.push(w.specularColorMapUv),M.push(w.specularIntensityMapUv),M.push(w.transmissionMapUv),M.push(w.thicknessMapUv),M.push(w.combine),M.push(w.fogExp2),M.push(w.sizeAttenuation),M.push(w.morphTargetsCount),M.push(w.morphAttributeCount),M.push(w.numDirLights),M.push(w.numPointLights),M.push(w.numSpotLights),M.push(w.numSpotLightMaps),M.push(w.numHemiLights),M.push(w.numRectAreaLights),M.push(w.numDirLightShadows),M.push(w.numPointLightShadows),M.push(w.numSpotLightShadows),M.push(w.numSpotLightShadowsWithMaps),M.push(w.numLightProbes),M.push(w.shadowMapType),M.push(w.toneMapping),M.push(w.numClippingPlanes),M.push(w.numClipIntersection),M.push(w.depthPacking)}function S(M,w){a.disableAll(),w.supportsVertexTextures&&a.enable(0),w.instancing&&a.enable(1),w.instancingColor&&a.enable(2),w.instancingMorph&&a.enable(3),w.matcap&&a.enable(4),w.envMap&&a.enable(5),w.normalMapObjectSpace&&a.enable(6),w.normalMapTangentSpace&&a.enable(7),w.clearcoat&&a.enable(8),w.iridescence&&a.enable(9),w.alphaTest&&a.enable(10),w.vertexColors&&a.enable(11),w.vertexAlphas&&a.enable(12),w.vertexUv1s&&a.enable(13),w.vertexUv2s&&a.enable(14),w.vertexUv3s&&a.enable(15),w.vertexTangents&&a.enable(16),w.anisotropy&&a.enable(17),w.alphaHash&&a.enable(18),w.batching&&a.enable(19),w.dispersion&&a.enable(20),w.batchingColor&&a.enable(21),w.gradientMap&&a.enable(22),M.push(a.mask),a.disableAll(),w.fog&&a.enable(0),w.useFog&&a.enable(1),w.flatShading&&a.enable(2),w.logarithmicDepthBuffer&&a.enable(3),w.reversedDepthBuffer&&a.enable(4),w.skinning&&a.enable(5),w.morphTargets&&a.enable(6),w.morphNormals&&a.enable(7),w.morphColors&&a.enable(8),w.premultipliedAlpha&&a.enable(9),w.shadowMapEnabled&&a.enable(10),w.doubleSided&&a.enable(11),w.flipSided&&a.enable(12),w.useDepthPacking&&a.enable(13),w.dithering&&a.enable(14),w.transmission&&a.enable(15),w.sheen&&a.enable(16),w.opaque&&a.enable(17),w.pointsUvs&&a.enable(18),w.decodeVideoTexture&&a.enable(19),w.decodeVideoTextureEmissive&&a.enable(20),w.alphaToCoverage&&a.enable(21),M.push(a.mask)}function y(M){let w=m[M.type],T;if(w){let B=Xn[w];T=Ya.clone(B.uniforms)}else T=M.uniforms;return T}function P(M,w){let T;for(let B=0,H=u.length;B<H;B++){let V=u[B];if(V.cacheKey===w){T=V,++T.usedTimes;break}}return T===void 0&&(T=new aS(i,w,M,r),u.push(T)),T}function E(M){if(--M.usedTimes===0){let w=u.indexOf(M);u[w]=u[u.length-1],u.pop(),M.destroy()}}function I(M){l.remove(M)}function D(){l.dispose()}return{getParameters:g,getProgramCacheKey:d,getUniforms:y,acquireProgram:P,releaseProgram:E,releaseShaderCache:I,programs:u,dispose:D}}function hS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function uS(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function xg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function yg(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(h,f,p,m,v,g){let d=i[t];return d===void 0?(d={id:h.id,object:h,geometry:f,material:p,groupOrder:m,renderOrder:h.renderOrder,z:v,group:g},i[t]=d):(d.id=h.id,d.object=h,d.geometry=f,d.material=p,d.groupOrder=m,d.renderOrder=h.renderOrder,d.z=v,d.group=g),t++,d}function a(h,f,p,m,v,g){let d=o(h,f,p,m,v,g);p.transmission>0?n.push(d):p.transparent===!0?s.push(d):e.push(d)}function l(h,f,p,m,v,g){let d=o(h,f,p,m,v,g);p.transmission>0?n.unshift(d):p.transparent===!0?s.unshift(d):e.unshift(d)}function c(h,f){e.length>1&&e.sort(h||uS),n.length>1&&n.sort(f||xg),s.length>1&&s.sort(f||xg)}function u(){for(let h=t,f=i.length;h<f;h++){let p=i[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function fS(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new yg,i.set(n,[o])):s>=r.length?(o=new yg,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function dS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new L,color:new ae};break;case"SpotLight":e={position:new L,direction:new L,color:new ae,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new L,color:new ae,distance:0,decay:0};break;case"HemisphereLight":e={direction:new L,skyColor:new ae,groundColor:new ae};break;case"RectAreaLight":e={color:new ae,position:new L,halfWidth:new L,halfHeight:new L};break}return i[t.id]=e,e}}}function pS(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ot,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var mS=0;function gS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function vS(i){let t=new dS,e=pS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new L);let s=new L,r=new Ue,o=new Ue;function a(c){let u=0,h=0,f=0;for(let M=0;M<9;M++)n.probe[M].set(0,0,0);let p=0,m=0,v=0,g=0,d=0,b=0,S=0,y=0,P=0,E=0,I=0;c.sort(gS);for(let M=0,w=c.length;M<w;M++){let T=c[M],B=T.color,H=T.intensity,V=T.distance,W=T.shadow&&T.shadow.map?T.shadow.map.texture:null;if(T.isAmbientLight)u+=B.r*H,h+=B.g*H,f+=B.b*H;else if(T.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(T.sh.coefficients[X],H);I++}else if(T.isDirectionalLight){let X=t.get(T);if(X.color.copy(T.color).multiplyScalar(T.intensity),T.castShadow){let F=T.shadow,z=e.get(T);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,n.directionalShadow[p]=z,n.directionalShadowMap[p]=W,n.directionalShadowMatrix[p]=T.shadow.matrix,b++}n.directional[p]=X,p++}else if(T.isSpotLight){let X=t.get(T);X.position.setFromMatrixPosition(T.matrixWorld),X.color.copy(B).multiplyScalar(H),X.distance=V,X.coneCos=Math.cos(T.angle),X.penumbraCos=Math.cos(T.angle*(1-T.penumbra)),X.decay=T.decay,n.spot[v]=X;let F=T.shadow;if(T.map&&(n.spotLightMap[P]=T.map,P++,F.updateMatrices(T),T.castShadow&&E++),n.spotLightMatrix[v]=F.matrix,T.castShadow){let z=e.get(T);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,n.spotShadow[v]=z,n.spotShadowMap[v]=W,y++}v++}else if(T.isRectAreaLight){let X=t.get(T);X.color.copy(B).multiplyScalar(H),X.halfWidth.set(T.width*.5,0,0),X.halfHeight.set(0,T.height*.5,0),n.rectArea[g]=X,g++}else if(T.isPointLight){let X=t.get(T);if(X.color.copy(T.color).multiplyScalar(T.intensity),X.distance=T.distance,X.decay=T.decay,T.castShadow){let F=T.shadow,z=e.get(T);z.shadowIntensity=F.intensity,z.shadowBias=F.bias,z.shadowNormalBias=F.normalBias,z.shadowRadius=F.radius,z.shadowMapSize=F.mapSize,z.shadowCameraNear=F.camera.near,z.shadowCameraFar=F.camera.far,n.pointShadow[m]=z,n.pointShadowMap[m]=W,n.pointShadowMatrix[m]=T.shadow.matrix,S++}n.point[m]=X,m++}else if(T.isHemisphereLight){let X=t.get(T);X.skyColor.copy(T.color).multiplyScalar(H),X.groundColor.copy(T.groundColor).multiplyScalar(H),n.hemi[d]=X,d++}}g>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Dt.LTC_FLOAT_1,n.rectAreaLTC2=Dt.LTC_FLOAT_2):(n.rectAreaLTC1=Dt.LTC_HALF_1,n.rectAreaLTC2=Dt.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let D=n.hash;(D.directionalLength!==p||D.pointLength!==m||D.spotLength!==v||D.rectAreaLength!==g||D.hemiLength!==d||D.numDirectionalShadows!==b||D.numPointShadows!==S||D.numSpotShadows!==y||D.numSpotMaps!==P||D.numLightProbes!==I)&&(n.directional.length=p,n.spot.length=v,n.rectArea.length=g,n.point.length=m,n.hemi.length=d,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=y,n.spotShadowMap.length=y,n.directionalShadowMatrix.length=b,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=y+P-E,n.spotLightMap.length=P,n.numSpotLightShadowsWithMaps=E,n.numLightProbes=I,D.directionalLength=p,D.pointLength=m,D.spotLength=v,D.rectAreaLength=g,D.hemiLength=d,D.numDirectionalShadows=b,D.numPointShadows=S,D.numSpotShadows=y,D.numSpotMaps=P,D.numLightProbes=I,n.version=mS++)}function l(c,u){let h=0,f=0,p=0,m=0,v=0,g=u.matrixWorldInverse;for(let d=0,b=c.length;d<b;d++){let S=c[d];if(S.isDirectionalLight){let y=n.directional[h];y.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(g),h++}else if(S.isSpotLight){let y=n.spot[p];y.position.setFromMatrixPosition(S.matrixWorld),y.position.applyMatrix4(g),y.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),y.direction.sub(s),y.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let y=n.rectArea[m];y.position.setFromMatrixPosition(S.matrixWorld),y.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),y.halfWidth.set(S.width*.5,0,0),y.halfHeight.set(0,S.height*.5,0),y.halfWidth.applyMatrix4(o),y.halfHeight.applyMatrix4(o),m++}else if(S.isPointLight){let y=n.point[f];y.position.setFromMatrixPosition(S.matrixWorld),y.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let y=n.hemi[v];y.direction.setFromMatrixPosition(S.matrixWorld),y.direction.transformDirection(g),v++}}}return{setup:a,setupView:l,state:n}}function bg(i){let t=new vS(i),e=[],n=[];function s(u){c.camera=u,e.length=0,n.length=0}function r(u){e.push(u)}function o(u){n.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}let c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function _S(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new bg(i),t.set(s,[a])):r>=o.length?(a=new bg(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var xS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,yS=`uniform sampler2D shadow_pass;
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
}`;function bS(i,t,e){let n=new _o,s=new Ot,r=new Ot,o=new Ie,a=new _c({depthPacking:zm}),l=new xc,c={},u=e.maxTextureSize,h={[gs]:Wn,[Wn]:gs,[Ln]:Ln},f=new oi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ot},radius:{value:4}},vertexShader:xS,fragmentShader:yS}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new Oe;m.setAttribute("position",new Je(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Qt(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=hf;let d=this.type;this.render=function(E,I,D){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;let M=i.getRenderTarget(),w=i.getActiveCubeFace(),T=i.getActiveMipmapLevel(),B=i.state;B.setBlending(_s),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let H=d!==Qi&&this.type===Qi,V=d===Qi&&this.type!==Qi;for(let W=0,X=E.length;W<X;W++){let F=E[W],z=F.shadow;if(z===void 0){console.warn("THREE.WebGLShadowMap:",F,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let J=z.getFrameExtents();if(s.multiply(J),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/J.x),s.x=r.x*J.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/J.y),s.y=r.y*J.y,z.mapSize.y=r.y)),z.map===null||H===!0||V===!0){let et=this.type!==Qi?{minFilter:gi,magFilter:gi}:{};z.map!==null&&z.map.dispose(),z.map=new Ki(s.x,s.y,et),z.map.texture.name=F.name+".shadowMap",z.camera.updateProjectionMatrix()}i.setRenderTarget(z.map),i.clear();let nt=z.getViewportCount();for(let et=0;et<nt;et++){let ct=z.getViewport(et);o.set(r.x*ct.x,r.y*ct.y,r.x*ct.z,r.y*ct.w),B.viewport(o),z.updateMatrices(F,et),n=z.getFrustum(),y(I,D,z.camera,F,this.type)}z.isPointLightShadow!==!0&&this.type===Qi&&b(z,D),z.needsUpdate=!1}d=this.type,g.needsUpdate=!1,i.setRenderTarget(M,w,T)};function b(E,I){let D=t.update(v);f.defines.VSM_SAMPLES!==E.blurSamples&&(f.defines.VSM_SAMPLES=E.blurSamples,p.defines.VSM_SAMPLES=E.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),E.mapPass===null&&(E.mapPass=new Ki(s.x,s.y)),f.uniforms.shadow_pass.value=E.map.texture,f.uniforms.resolution.value=E.mapSize,f.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(I,null,D,f,v,null),p.uniforms.shadow_pass.value=E.mapPass.texture,p.uniforms.resolution.value=E.mapSize,p.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(I,null,D,p,v,null)}function S(E,I,D,M){let w=null,T=D.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(T!==void 0)w=T;else if(w=D.isPointLight===!0?l:a,i.localClippingEnabled&&I.clipShadows===!0&&Array.isArray(I.clippingPlanes)&&I.clippingPlanes.length!==0||I.displacementMap&&I.displacementScale!==0||I.alphaMap&&I.alphaTest>0||I.map&&I.alphaTest>0||I.alphaToCoverage===!0){let B=w.uuid,H=I.uuid,V=c[B];V===void 0&&(V={},c[B]=V);let W=V[H];W===void 0&&(W=w.clone(),V[H]=W,I.addEventListener("dispose",P)),w=W}if(w.visible=I.visible,w.wireframe=I.wireframe,M===Qi?w.side=I.shadowSide!==null?I.shadowSide:I.side:w.side=I.shadowSide!==null?I.shadowSide:h[I.side],w.alphaMap=I.alphaMap,w.alphaTest=I.alphaToCoverage===!0?.5:I.alphaTest,w.map=I.map,w.clipShadows=I.clipShadows,w.clippingPlanes=I.clippingPlanes,w.clipIntersection=I.clipIntersection,w.displacementMap=I.displacementMap,w.displacementScale=I.displacementScale,w.displacementBias=I.displacementBias,w.wireframeLinewidth=I.wireframeLinewidth,w.linewidth=I.linewidth,D.isPointLight===!0&&w.isMeshDistanceMaterial===!0){let B=i.properties.get(w);B.light=D}return w}function y(E,I,D,M,w){if(E.visible===!1)return;if(E.layers.test(I.layers)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&w===Qi)&&(!E.frustumCulled||n.intersectsObject(E))){E.modelViewMatrix.multiplyMatrices(D.matrixWorldInverse,E.matrixWorld);let H=t.update(E),V=E.material;if(Array.isArray(V)){let W=H.groups;for(let X=0,F=W.length;X<F;X++){let z=W[X],J=V[z.materialIndex];if(J&&J.visible){let nt=S(E,J,M,w);E.onBeforeShadow(i,E,I,D,H,nt,z),i.renderBufferDirect(D,null,H,nt,E,z),E.onAfterShadow(i,E,I,D,H,nt,z)}}}else if(V.visible){let W=S(E,V,M,w);E.onBeforeShadow(i,E,I,D,H,W,null),i.renderBufferDirect(D,null,H,W,E,null),E.onAfterShadow(i,E,I,D,H,W,null)}}let B=E.children;for(let H=0,V=B.length;H<V;H++)y(B[H],I,D,M,w)}function P(E){E.target.removeEventListener("dispose",P);for(let D in c){let M=c[D],w=E.target.uuid;w in M&&(M[w].dispose(),delete M[w])}}}var MS={[Pc]:Ic,[Lc]:Nc,[Dc]:Fc,[lr]:Uc,[Ic]:Pc,[Nc]:Lc,[Fc]:Dc,[Uc]:lr};function wS(i,t){function e(){let Y=!1,Tt=new Ie,Rt=null,Vt=new Ie(0,0,0,0);return{setMask:function(Et){Rt!==Et&&!Y&&(i.colorMask(Et,Et,Et,Et),Rt=Et)},setLocked:function(Et){Y=Et},setClear:function(Et,pt,$t,se,Le){Le===!0&&(Et*=se,pt*=se,$t*=se),Tt.set(Et,pt,$t,se),Vt.equals(Tt)===!1&&(i.clearColor(Et,pt,$t,se),Vt.copy(Tt))},reset:function(){Y=!1,Rt=null,Vt.set(-1,0,0,0)}}}function n(){let Y=!1,Tt=!1,Rt=null,Vt=null,Et=null;return{setReversed:function(pt){if(Tt!==pt){let $t=t.get("EXT_clip_control");pt?$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.ZERO_TO_ONE_EXT):$t.clipControlEXT($t.LOWER_LEFT_EXT,$t.NEGATIVE_ONE_TO_ONE_EXT),Tt=pt;let se=Et;Et=null,this.setClear(se)}},getReversed:function(){return Tt},setTest:function(pt){pt?$(i.DEPTH_TEST):mt(i.DEPTH_TEST)},setMask:function(pt){Rt!==pt&&!Y&&(i.depthMask(pt),Rt=pt)},setFunc:function(pt){if(Tt&&(pt=MS[pt]),Vt!==pt){switch(pt){case Pc:i.depthFunc(i.NEVER);break;case Ic:i.depthFunc(i.ALWAYS);break;case Lc:i.depthFunc(i.LESS);break;case lr:i.depthFunc(i.LEQUAL);break;case Dc:i.depthFunc(i.EQUAL);break;case Uc:i.depthFunc(i.GEQUAL);break;case Nc:i.depthFunc(i.GREATER);break;case Fc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Vt=pt}},setLocked:function(pt){Y=pt},setClear:function(pt){Et!==pt&&(Tt&&(pt=1-pt),i.clearDepth(pt),Et=pt)},reset:function(){Y=!1,Rt=null,Vt=null,Et=null,Tt=!1}}}function s(){let Y=!1,Tt=null,Rt=null,Vt=null,Et=null,pt=null,$t=null,se=null,Le=null;return{setTest:function(xe){Y||(xe?$(i.STENCIL_TEST):mt(i.STENCIL_TEST))},setMask:function(xe){Tt!==xe&&!Y&&(i.stencilMask(xe),Tt=xe)},setFunc:function(xe,bn,Fe){(Rt!==xe||Vt!==bn||Et!==Fe)&&(i.stencilFunc(xe,bn,Fe),Rt=xe,Vt=bn,Et=Fe)},setOp:function(xe,bn,Fe){(pt!==xe||$t!==bn||se!==Fe)&&(i.stencilOp(xe,bn,Fe),pt=xe,$t=bn,se=Fe)},setLocked:function(xe){Y=xe},setClear:function(xe){Le!==xe&&(i.clearStencil(xe),Le=xe)},reset:function(){Y=!1,Tt=null,Rt=null,Vt=null,Et=null,pt=null,$t=null,se=null,Le=null}}}let r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,p=[],m=null,v=!1,g=null,d=null,b=null,S=null,y=null,P=null,E=null,I=new ae(0,0,0),D=0,M=!1,w=null,T=null,B=null,H=null,V=null,W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),X=!1,F=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(F=parseFloat(/^WebGL (\d)/.exec(z)[1]),X=F>=1):z.indexOf("OpenGL ES")!==-1&&(F=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),X=F>=2);let J=null,nt={},et=i.getParameter(i.SCISSOR_BOX),ct=i.getParameter(i.VIEWPORT),ft=new Ie().fromArray(et),yt=new Ie().fromArray(ct);function xt(Y,Tt,Rt,Vt){let Et=new Uint8Array(4),pt=i.createTexture();i.bindTexture(Y,pt),i.texParameteri(Y,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(Y,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let $t=0;$t<Rt;$t++)Y===i.TEXTURE_3D||Y===i.TEXTURE_2D_ARRAY?i.texImage3D(Tt,0,i.RGBA,1,1,Vt,0,i.RGBA,i.UNSIGNED_BYTE,Et):i.texImage2D(Tt+$t,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Et);return pt}let tt={};tt[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),tt[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),tt[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),tt[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),$(i.DEPTH_TEST),o.setFunc(lr),wt(!1),Pt(cf),$(i.CULL_FACE),he(_s);function $(Y){u[Y]!==!0&&(i.enable(Y),u[Y]=!0)}function mt(Y){u[Y]!==!1&&(i.disable(Y),u[Y]=!1)}function vt(Y,Tt){return h[Y]!==Tt?(i.bindFramebuffer(Y,Tt),h[Y]=Tt,Y===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=Tt),Y===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=Tt),!0):!1}function bt(Y,Tt){let Rt=p,Vt=!1;if(Y){Rt=f.get(Tt),Rt===void 0&&(Rt=[],f.set(Tt,Rt));let Et=Y.textures;if(Rt.length!==Et.length||Rt[0]!==i.COLOR_ATTACHMENT0){for(let pt=0,$t=Et.length;pt<$t;pt++)Rt[pt]=i.COLOR_ATTACHMENT0+pt;Rt.length=Et.length,Vt=!0}}else Rt[0]!==i.BACK&&(Rt[0]=i.BACK,Vt=!0);Vt&&i.drawBuffers(Rt)}function Gt(Y){return m!==Y?(i.useProgram(Y),m=Y,!0):!1}let de={[Os]:i.FUNC_ADD,[um]:i.FUNC_SUBTRACT,[fm]:i.FUNC_REVERSE_SUBTRACT};de[dm]=i.MIN,de[pm]=i.MAX;let k={[mm]:i.ZERO,[gm]:i.ONE,[vm]:i.SRC_COLOR,[Jl]:i.SRC_ALPHA,[wm]:i.SRC_ALPHA_SATURATE,[bm]:i.DST_COLOR,[xm]:i.DST_ALPHA,[_m]:i.ONE_MINUS_SRC_COLOR,[jl]:i.ONE_MINUS_SRC_ALPHA,[Mm]:i.ONE_MINUS_DST_COLOR,[ym]:i.ONE_MINUS_DST_ALPHA,[Sm]:i.CONSTANT_COLOR,[Em]:i.ONE_MINUS_CONSTANT_COLOR,[Tm]:i.CONSTANT_ALPHA,[Am]:i.ONE_MINUS_CONSTANT_ALPHA};function he(Y,Tt,Rt,Vt,Et,pt,$t,se,Le,xe){if(Y===_s){v===!0&&(mt(i.BLEND),v=!1);return}if(v===!1&&($(i.BLEND),v=!0),Y!==hm){if(Y!==g||xe!==M){if((d!==Os||y!==Os)&&(i.blendEquation(i.FUNC_ADD),d=Os,y=Os),xe)switch(Y){case ar:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case uf:i.blendFunc(i.ONE,i.ONE);break;case ff:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case df:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",Y);break}else switch(Y){case ar:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case uf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case ff:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case df:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",Y);break}b=null,S=null,P=null,E=null,I.set(0,0,0),D=0,g=Y,M=xe}return}Et=Et||Tt,pt=pt||Rt,$t=$t||Vt,(Tt!==d||Et!==y)&&(i.blendEquationSeparate(de[Tt],de[Et]),d=Tt,y=Et),(Rt!==b||Vt!==S||pt!==P||$t!==E)&&(i.blendFuncSeparate(k[Rt],k[Vt],k[pt],k[$t]),b=Rt,S=Vt,P=pt,E=$t),(se.equals(I)===!1||Le!==D)&&(i.blendColor(se.r,se.g,se.b,Le),I.copy(se),D=Le),g=Y,M=!1}function st(Y,Tt){Y.side===Ln?mt(i.CULL_FACE):$(i.CULL_FACE);let Rt=Y.side===Wn;Tt&&(Rt=!Rt),wt(Rt),Y.blending===ar&&Y.transparent===!1?he(_s):he(Y.blending,Y.blendEquation,Y.blendSrc,Y.blendDst,Y.blendEquationAlpha,Y.blendSrcAlpha,Y.blendDstAlpha,Y.blendColor,Y.blendAlpha,Y.premultipliedAlpha),o.setFunc(Y.depthFunc),o.setTest(Y.depthTest),o.setMask(Y.depthWrite),r.setMask(Y.colorWrite);let Vt=Y.stencilWrite;a.setTest(Vt),Vt&&(a.setMask(Y.stencilWriteMask),a.setFunc(Y.stencilFunc,Y.stencilRef,Y.stencilFuncMask),a.setOp(Y.stencilFail,Y.stencilZFail,Y.stencilZPass)),rt(Y.polygonOffset,Y.polygonOffsetFactor,Y.polygonOffsetUnits),Y.alphaToCoverage===!0?$(i.SAMPLE_ALPHA_TO_COVERAGE):mt(i.SAMPLE_ALPHA_TO_COVERAGE)}function wt(Y){w!==Y&&(Y?i.frontFace(i.CW):i.frontFace(i.CCW),w=Y)}function Pt(Y){Y!==am?($(i.CULL_FACE),Y!==T&&(Y===cf?i.cullFace(i.BACK):Y===lm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):mt(i.CULL_FACE),T=Y}function oe(Y){Y!==B&&(X&&i.lineWidth(Y),B=Y)}function rt(Y,Tt,Rt){Y?($(i.POLYGON_OFFSET_FILL),(H!==Tt||V!==Rt)&&(i.polygonOffset(Tt,Rt),H=Tt,V=Rt)):mt(i.POLYGON_OFFSET_FILL)}function Q(Y){Y?$(i.SCISSOR_TEST):mt(i.SCISSOR_TEST)}function ut(Y){Y===void 0&&(Y=i.TEXTURE0+W-1),J!==Y&&(i.activeTexture(Y),J=Y)}function St(Y,Tt,Rt){Rt===void 0&&(J===null?Rt=i.TEXTURE0+W-1:Rt=J);let Vt=nt[Rt];Vt===void 0&&(Vt={type:void 0,texture:void 0},nt[Rt]=Vt),(Vt.type!==Y||Vt.texture!==Tt)&&(J!==Rt&&(i.activeTexture(Rt),J=Rt),i.bindTexture(Y,Tt||tt[Y]),Vt.type=Y,Vt.texture=Tt)}function C(){let Y=nt[J];Y!==void 0&&Y.type!==void 0&&(i.bindTexture(Y.type,null),Y.type=void 0,Y.texture=void 0)}function x(){try{i.compressedTexImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function N(){try{i.compressedTexImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function q(){try{i.texSubImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function lt(){try{i.texSubImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function ot(){try{i.compressedTexSubImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Ut(){try{i.compressedTexSubImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function _t(){try{i.texStorage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Ft(){try{i.texStorage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Bt(){try{i.texImage2D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function gt(){try{i.texImage3D(...arguments)}catch(Y){console.error("THREE.WebGLState:",Y)}}function Ct(Y){ft.equals(Y)===!1&&(i.scissor(Y.x,Y.y,Y.z,Y.w),ft.copy(Y))}function qt(Y){yt.equals(Y)===!1&&(i.viewport(Y.x,Y.y,Y.z,Y.w),yt.copy(Y))}function Yt(Y,Tt){let Rt=c.get(Tt);Rt===void 0&&(Rt=new WeakMap,c.set(Tt,Rt));let Vt=Rt.get(Y);Vt===void 0&&(Vt=i.getUniformBlockIndex(Tt,Y.name),Rt.set(Y,Vt))}function Lt(Y,Tt){let Vt=c.get(Tt).get(Y);l.get(Tt)!==Vt&&(i.uniformBlockBinding(Tt,Vt,Y.__bindingPointIndex),l.set(Tt,Vt))}function Zt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},J=null,nt={},h={},f=new WeakMap,p=[],m=null,v=!1,g=null,d=null,b=null,S=null,y=null,P=null,E=null,I=new ae(0,0,0),D=0,M=!1,w=null,T=null,B=null,H=null,V=null,ft.set(0,0,i.canvas.width,i.canvas.height),yt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:$,disable:mt,bindFramebuffer:vt,drawBuffers:bt,useProgram:Gt,setBlending:he,setMaterial:st,setFlipSided:wt,setCullFace:Pt,setLineWidth:oe,setPolygonOffset:rt,setScissorTest:Q,activeTexture:ut,bindTexture:St,unbindTexture:C,compressedTexImage2D:x,compressedTexImage3D:N,texImage2D:Bt,texImage3D:gt,updateUBOMapping:Yt,uniformBlockBinding:Lt,texStorage2D:_t,texStorage3D:Ft,texSubImage2D:q,texSubImage3D:lt,compressedTexSubImage2D:ot,compressedTexSubImage3D:Ut,scissor:Ct,viewport:qt,reset:Zt}}function SS(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ot,u=new WeakMap,h,f=new WeakMap,p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,x){return p?new OffscreenCanvas(C,x):pa("canvas")}function v(C,x,N){let q=1,lt=St(C);if((lt.width>N||lt.height>N)&&(q=N/Math.max(lt.width,lt.height)),q<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let ot=Math.floor(q*lt.width),Ut=Math.floor(q*lt.height);h===void 0&&(h=m(ot,Ut));let _t=x?m(ot,Ut):h;return _t.width=ot,_t.height=Ut,_t.getContext("2d").drawImage(C,0,0,ot,Ut),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+lt.width+"x"+lt.height+") to ("+ot+"x"+Ut+")."),_t}else return"data"in C&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+lt.width+"x"+lt.height+")."),C;return C}function g(C){return C.generateMipmaps}function d(C){i.generateMipmap(C)}function b(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(C,x,N,q,lt=!1){if(C!==null){if(i[C]!==void 0)return i[C];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ot=x;if(x===i.RED&&(N===i.FLOAT&&(ot=i.R32F),N===i.HALF_FLOAT&&(ot=i.R16F),N===i.UNSIGNED_BYTE&&(ot=i.R8)),x===i.RED_INTEGER&&(N===i.UNSIGNED_BYTE&&(ot=i.R8UI),N===i.UNSIGNED_SHORT&&(ot=i.R16UI),N===i.UNSIGNED_INT&&(ot=i.R32UI),N===i.BYTE&&(ot=i.R8I),N===i.SHORT&&(ot=i.R16I),N===i.INT&&(ot=i.R32I)),x===i.RG&&(N===i.FLOAT&&(ot=i.RG32F),N===i.HALF_FLOAT&&(ot=i.RG16F),N===i.UNSIGNED_BYTE&&(ot=i.RG8)),x===i.RG_INTEGER&&(N===i.UNSIGNED_BYTE&&(ot=i.RG8UI),N===i.UNSIGNED_SHORT&&(ot=i.RG16UI),N===i.UNSIGNED_INT&&(ot=i.RG32UI),N===i.BYTE&&(ot=i.RG8I),N===i.SHORT&&(ot=i.RG16I),N===i.INT&&(ot=i.RG32I)),x===i.RGB_INTEGER&&(N===i.UNSIGNED_BYTE&&(ot=i.RGB8UI),N===i.UNSIGNED_SHORT&&(ot=i.RGB16UI),N===i.UNSIGNED_INT&&(ot=i.RGB32UI),N===i.BYTE&&(ot=i.RGB8I),N===i.SHORT&&(ot=i.RGB16I),N===i.INT&&(ot=i.RGB32I)),x===i.RGBA_INTEGER&&(N===i.UNSIGNED_BYTE&&(ot=i.RGBA8UI),N===i.UNSIGNED_SHORT&&(ot=i.RGBA16UI),N===i.UNSIGNED_INT&&(ot=i.RGBA32UI),N===i.BYTE&&(ot=i.RGBA8I),N===i.SHORT&&(ot=i.RGBA16I),N===i.INT&&(ot=i.RGBA32I)),x===i.RGB&&(N===i.UNSIGNED_INT_5_9_9_9_REV&&(ot=i.RGB9_E5),N===i.UNSIGNED_INT_10F_11F_11F_REV&&(ot=i.R11F_G11F_B10F)),x===i.RGBA){let Ut=lt?fa:_e.getTransfer(q);N===i.FLOAT&&(ot=i.RGBA32F),N===i.HALF_FLOAT&&(ot=i.RGBA16F),N===i.UNSIGNED_BYTE&&(ot=Ut===Pe?i.SRGB8_ALPHA8:i.RGBA8),N===i.UNSIGNED_SHORT_4_4_4_4&&(ot=i.RGBA4),N===i.UNSIGNED_SHORT_5_5_5_1&&(ot=i.RGB5_A1)}return(ot===i.R16F||ot===i.R32F||ot===i.RG16F||ot===i.RG32F||ot===i.RGBA16F||ot===i.RGBA32F)&&t.get("EXT_color_buffer_float"),ot}function y(C,x){let N;return C?x===null||x===Ws||x===wo?N=i.DEPTH24_STENCIL8:x===ts?N=i.DEPTH32F_STENCIL8:x===bo&&(N=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Ws||x===wo?N=i.DEPTH_COMPONENT24:x===ts?N=i.DEPTH_COMPONENT32F:x===bo&&(N=i.DEPTH_COMPONENT16),N}function P(C,x){return g(C)===!0||C.isFramebufferTexture&&C.minFilter!==gi&&C.minFilter!==Li?Math.log2(Math.max(x.width,x.height))+1:C.mipmaps!==void 0&&C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?x.mipmaps.length:1}function E(C){let x=C.target;x.removeEventListener("dispose",E),D(x),x.isVideoTexture&&u.delete(x)}function I(C){let x=C.target;x.removeEventListener("dispose",I),w(x)}function D(C){let x=n.get(C);if(x.__webglInit===void 0)return;let N=C.source,q=f.get(N);if(q){let lt=q[x.__cacheKey];lt.usedTimes--,lt.usedTimes===0&&M(C),Object.keys(q).length===0&&f.delete(N)}n.remove(C)}function M(C){let x=n.get(C);i.deleteTexture(x.__webglTexture);let N=C.source,q=f.get(N);delete q[x.__cacheKey],o.memory.textures--}function w(C){let x=n.get(C);if(C.depthTexture&&(C.depthTexture.dispose(),n.remove(C.depthTexture)),C.isWebGLCubeRenderTarget)for(let q=0;q<6;q++){if(Array.isArray(x.__webglFramebuffer[q]))for(let lt=0;lt<x.__webglFramebuffer[q].length;lt++)i.deleteFramebuffer(x.__webglFramebuffer[q][lt]);else i.deleteFramebuffer(x.__webglFramebuffer[q]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[q])}else{if(Array.isArray(x.__webglFramebuffer))for(let q=0;q<x.__webglFramebuffer.length;q++)i.deleteFramebuffer(x.__webglFramebuffer[q]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let q=0;q<x.__webglColorRenderbuffer.length;q++)x.__webglColorRenderbuffer[q]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[q]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let N=C.textures;for(let q=0,lt=N.length;q<lt;q++){let ot=n.get(N[q]);ot.__webglTexture&&(i.deleteTexture(ot.__webglTexture),o.memory.textures--),n.remove(N[q])}n.remove(C)}let T=0;function B(){T=0}function H(){let C=T;return C>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+C+" texture units while this GPU supports only "+s.maxTextures),T+=1,C}function V(C){let x=[];return x.push(C.wrapS),x.push(C.wrapT),x.push(C.wrapR||0),x.push(C.magFilter),x.push(C.minFilter),x.push(C.anisotropy),x.push(C.internalFormat),x.push(C.format),x.push(C.type),x.push(C.generateMipmaps),x.push(C.premultiplyAlpha),x.push(C.flipY),x.push(C.unpackAlignment),x.push(C.colorSpace),x.join()}function W(C,x){let N=n.get(C);if(C.isVideoTexture&&Q(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&N.__version!==C.version){let q=C.image;if(q===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(q.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{tt(N,C,x);return}}else C.isExternalTexture&&(N.__webglTexture=C.sourceTexture?C.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,N.__webglTexture,i.TEXTURE0+x)}function X(C,x){let N=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&N.__version!==C.version){tt(N,C,x);return}e.bindTexture(i.TEXTURE_2D_ARRAY,N.__webglTexture,i.TEXTURE0+x)}function F(C,x){let N=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&N.__version!==C.version){tt(N,C,x);return}e.bindTexture(i.TEXTURE_3D,N.__webglTexture,i.TEXTURE0+x)}function z(C,x){let N=n.get(C);if(C.version>0&&N.__version!==C.version){$(N,C,x);return}e.bindTexture(i.TEXTURE_CUBE_MAP,N.__webglTexture,i.TEXTURE0+x)}let J={[Ql]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[tc]:i.MIRRORED_REPEAT},nt={[gi]:i.NEAREST,[Om]:i.NEAREST_MIPMAP_NEAREST,[Va]:i.NEAREST_MIPMAP_LINEAR,[Li]:i.LINEAR,[zc]:i.LINEAR_MIPMAP_NEAREST,[Gs]:i.LINEAR_MIPMAP_LINEAR},et={[Hm]:i.NEVER,[Ym]:i.ALWAYS,[Vm]:i.LESS,[Af]:i.LEQUAL,[Gm]:i.EQUAL,[qm]:i.GEQUAL,[Wm]:i.GREATER,[Xm]:i.NOTEQUAL};function ct(C,x){if(x.type===ts&&t.has("OES_texture_float_linear")===!1&&(x.magFilter===Li||x.magFilter===zc||x.magFilter===Va||x.magFilter===Gs||x.minFilter===Li||x.minFilter===zc||x.minFilter===Va||x.minFilter===Gs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,J[x.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,J[x.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,J[x.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,nt[x.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,nt[x.minFilter]),x.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,et[x.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===gi||x.minFilter!==Va&&x.minFilter!==Gs||x.type===ts&&t.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let N=t.get("EXT_texture_filter_anisotropic");i.texParameterf(C,N.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function ft(C,x){let N=!1;C.__webglInit===void 0&&(C.__webglInit=!0,x.addEventListener("dispose",E));let q=x.source,lt=f.get(q);lt===void 0&&(lt={},f.set(q,lt));let ot=V(x);if(ot!==C.__cacheKey){lt[ot]===void 0&&(lt[ot]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,N=!0),lt[ot].usedTimes++;let Ut=lt[C.__cacheKey];Ut!==void 0&&(lt[C.__cacheKey].usedTimes--,Ut.usedTimes===0&&M(x)),C.__cacheKey=ot,C.__webglTexture=lt[ot].texture}return N}function yt(C,x,N){return Math.floor(Math.floor(C/N)/x)}function xt(C,x,N,q){let ot=C.updateRanges;if(ot.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,N,q,x.data);else{ot.sort((gt,Ct)=>gt.start-Ct.start);let Ut=0;for(let gt=1;gt<ot.length;gt++){let Ct=ot[Ut],qt=ot[gt],Yt=Ct.start+Ct.count,Lt=yt(qt.start,x.width,4),Zt=yt(Ct.start,x.width,4);qt.start<=Yt+1&&Lt===Zt&&yt(qt.start+qt.count-1,x.width,4)===Lt?Ct.count=Math.max(Ct.count,qt.start+qt.count-Ct.start):(++Ut,ot[Ut]=qt)}ot.length=Ut+1;let _t=i.getParameter(i.UNPACK_ROW_LENGTH),Ft=i.getParameter(i.UNPACK_SKIP_PIXELS),Bt=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let gt=0,Ct=ot.length;gt<Ct;gt++){let qt=ot[gt],Yt=Math.floor(qt.start/4),Lt=Math.ceil(qt.count/4),Zt=Yt%x.width,Y=Math.floor(Yt/x.width),Tt=Lt,Rt=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Zt),i.pixelStorei(i.UNPACK_SKIP_ROWS,Y),e.texSubImage2D(i.TEXTURE_2D,0,Zt,Y,Tt,Rt,N,q,x.data)}C.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,_t),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Ft),i.pixelStorei(i.UNPACK_SKIP_ROWS,Bt)}}function tt(C,x,N){let q=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(q=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(q=i.TEXTURE_3D);let lt=ft(C,x),ot=x.source;e.bindTexture(q,C.__webglTexture,i.TEXTURE0+N);let Ut=n.get(ot);if(ot.version!==Ut.__version||lt===!0){e.activeTexture(i.TEXTURE0+N);let _t=_e.getPrimaries(_e.workingColorSpace),Ft=x.colorSpace===ys?null:_e.getPrimaries(x.colorSpace),Bt=x.colorSpace===ys||_t===Ft?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Bt);let gt=v(x.image,!1,s.maxTextureSize);gt=ut(x,gt);let Ct=r.convert(x.format,x.colorSpace),qt=r.convert(x.type),Yt=S(x.internalFormat,Ct,qt,x.colorSpace,x.isVideoTexture);ct(q,x);let Lt,Zt=x.mipmaps,Y=x.isVideoTexture!==!0,Tt=Ut.__version===void 0||lt===!0,Rt=ot.dataReady,Vt=P(x,gt);if(x.isDepthTexture)Yt=y(x.format===So,x.type),Tt&&(Y?e.texStorage2D(i.TEXTURE_2D,1,Yt,gt.width,gt.height):e.texImage2D(i.TEXTURE_2D,0,Yt,gt.width,gt.height,0,Ct,qt,null));else if(x.isDataTexture)if(Zt.length>0){Y&&Tt&&e.texStorage2D(i.TEXTURE_2D,Vt,Yt,Zt[0].width,Zt[0].height);for(let Et=0,pt=Zt.length;Et<pt;Et++)Lt=Zt[Et],Y?Rt&&e.texSubImage2D(i.TEXTURE_2D,Et,0,0,Lt.width,Lt.height,Ct,qt,Lt.data):e.texImage2D(i.TEXTURE_2D,Et,Yt,Lt.width,Lt.height,0,Ct,qt,Lt.data);x.generateMipmaps=!1}else Y?(Tt&&e.texStorage2D(i.TEXTURE_2D,Vt,Yt,gt.width,gt.height),Rt&&xt(x,gt,Ct,qt)):e.texImage2D(i.TEXTURE_2D,0,Yt,gt.width,gt.height,0,Ct,qt,gt.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){Y&&Tt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Vt,Yt,Zt[0].width,Zt[0].height,gt.depth);for(let Et=0,pt=Zt.length;Et<pt;Et++)if(Lt=Zt[Et],x.format!==_i)if(Ct!==null)if(Y){if(Rt)if(x.layerUpdates.size>0){let $t=Nf(Lt.width,Lt.height,x.format,x.type);for(let se of x.layerUpdates){let Le=Lt.data.subarray(se*$t/Lt.data.BYTES_PER_ELEMENT,(se+1)*$t/Lt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Et,0,0,se,Lt.width,Lt.height,1,Ct,Le)}x.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,Et,0,0,0,Lt.width,Lt.height,gt.depth,Ct,Lt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,Et,Yt,Lt.width,Lt.height,gt.depth,0,Lt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Y?Rt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,Et,0,0,0,Lt.width,Lt.height,gt.depth,Ct,qt,Lt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,Et,Yt,Lt.width,Lt.height,gt.depth,0,Ct,qt,Lt.data)}else{Y&&Tt&&e.texStorage2D(i.TEXTURE_2D,Vt,Yt,Zt[0].width,Zt[0].height);for(let Et=0,pt=Zt.length;Et<pt;Et++)Lt=Zt[Et],x.format!==_i?Ct!==null?Y?Rt&&e.compressedTexSubImage2D(i.TEXTURE_2D,Et,0,0,Lt.width,Lt.height,Ct,Lt.data):e.compressedTexImage2D(i.TEXTURE_2D,Et,Yt,Lt.width,Lt.height,0,Lt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Y?Rt&&e.texSubImage2D(i.TEXTURE_2D,Et,0,0,Lt.width,Lt.height,Ct,qt,Lt.data):e.texImage2D(i.TEXTURE_2D,Et,Yt,Lt.width,Lt.height,0,Ct,qt,Lt.data)}else if(x.isDataArrayTexture)if(Y){if(Tt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Vt,Yt,gt.width,gt.height,gt.depth),Rt)if(x.layerUpdates.size>0){let Et=Nf(gt.width,gt.height,x.format,x.type);for(let pt of x.layerUpdates){let $t=gt.data.subarray(pt*Et/gt.data.BYTES_PER_ELEMENT,(pt+1)*Et/gt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,pt,gt.width,gt.height,1,Ct,qt,$t)}x.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,gt.width,gt.height,gt.depth,Ct,qt,gt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Yt,gt.width,gt.height,gt.depth,0,Ct,qt,gt.data);else if(x.isData3DTexture)Y?(Tt&&e.texStorage3D(i.TEXTURE_3D,Vt,Yt,gt.width,gt.height,gt.depth),Rt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,gt.width,gt.height,gt.depth,Ct,qt,gt.data)):e.texImage3D(i.TEXTURE_3D,0,Yt,gt.width,gt.height,gt.depth,0,Ct,qt,gt.data);else if(x.isFramebufferTexture){if(Tt)if(Y)e.texStorage2D(i.TEXTURE_2D,Vt,Yt,gt.width,gt.height);else{let Et=gt.width,pt=gt.height;for(let $t=0;$t<Vt;$t++)e.texImage2D(i.TEXTURE_2D,$t,Yt,Et,pt,0,Ct,qt,null),Et>>=1,pt>>=1}}else if(Zt.length>0){if(Y&&Tt){let Et=St(Zt[0]);e.texStorage2D(i.TEXTURE_2D,Vt,Yt,Et.width,Et.height)}for(let Et=0,pt=Zt.length;Et<pt;Et++)Lt=Zt[Et],Y?Rt&&e.texSubImage2D(i.TEXTURE_2D,Et,0,0,Ct,qt,Lt):e.texImage2D(i.TEXTURE_2D,Et,Yt,Ct,qt,Lt);x.generateMipmaps=!1}else if(Y){if(Tt){let Et=St(gt);e.texStorage2D(i.TEXTURE_2D,Vt,Yt,Et.width,Et.height)}Rt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,Ct,qt,gt)}else e.texImage2D(i.TEXTURE_2D,0,Yt,Ct,qt,gt);g(x)&&d(q),Ut.__version=ot.version,x.onUpdate&&x.onUpdate(x)}C.__version=x.version}function $(C,x,N){if(x.image.length!==6)return;let q=ft(C,x),lt=x.source;e.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+N);let ot=n.get(lt);if(lt.version!==ot.__version||q===!0){e.activeTexture(i.TEXTURE0+N);let Ut=_e.getPrimaries(_e.workingColorSpace),_t=x.colorSpace===ys?null:_e.getPrimaries(x.colorSpace),Ft=x.colorSpace===ys||Ut===_t?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ft);let Bt=x.isCompressedTexture||x.image[0].isCompressedTexture,gt=x.image[0]&&x.image[0].isDataTexture,Ct=[];for(let pt=0;pt<6;pt++)!Bt&&!gt?Ct[pt]=v(x.image[pt],!0,s.maxCubemapSize):Ct[pt]=gt?x.image[pt].image:x.image[pt],Ct[pt]=ut(x,Ct[pt]);let qt=Ct[0],Yt=r.convert(x.format,x.colorSpace),Lt=r.convert(x.type),Zt=S(x.internalFormat,Yt,Lt,x.colorSpace),Y=x.isVideoTexture!==!0,Tt=ot.__version===void 0||q===!0,Rt=lt.dataReady,Vt=P(x,qt);ct(i.TEXTURE_CUBE_MAP,x);let Et;if(Bt){Y&&Tt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Vt,Zt,qt.width,qt.height);for(let pt=0;pt<6;pt++){Et=Ct[pt].mipmaps;for(let $t=0;$t<Et.length;$t++){let se=Et[$t];x.format!==_i?Yt!==null?Y?Rt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,$t,0,0,se.width,se.height,Yt,se.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,$t,Zt,se.width,se.height,0,se.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Y?Rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,$t,0,0,se.width,se.height,Yt,Lt,se.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,$t,Zt,se.width,se.height,0,Yt,Lt,se.data)}}}else{if(Et=x.mipmaps,Y&&Tt){Et.length>0&&Vt++;let pt=St(Ct[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Vt,Zt,pt.width,pt.height)}for(let pt=0;pt<6;pt++)if(gt){Y?Rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,0,0,Ct[pt].width,Ct[pt].height,Yt,Lt,Ct[pt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,Zt,Ct[pt].width,Ct[pt].height,0,Yt,Lt,Ct[pt].data);for(let $t=0;$t<Et.length;$t++){let Le=Et[$t].image[pt].image;Y?Rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,$t+1,0,0,Le.width,Le.height,Yt,Lt,Le.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,$t+1,Zt,Le.width,Le.height,0,Yt,Lt,Le.data)}}else{Y?Rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,0,0,Yt,Lt,Ct[pt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,Zt,Yt,Lt,Ct[pt]);for(let $t=0;$t<Et.length;$t++){let se=Et[$t];Y?Rt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,$t+1,0,0,Yt,Lt,se.image[pt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+pt,$t+1,Zt,Yt,Lt,se.image[pt])}}}g(x)&&d(i.TEXTURE_CUBE_MAP),ot.__version=lt.version,x.onUpdate&&x.onUpdate(x)}C.__version=x.version}function mt(C,x,N,q,lt,ot){let Ut=r.convert(N.format,N.colorSpace),_t=r.convert(N.type),Ft=S(N.internalFormat,Ut,_t,N.colorSpace),Bt=n.get(x),gt=n.get(N);if(gt.__renderTarget=x,!Bt.__hasExternalTextures){let Ct=Math.max(1,x.width>>ot),qt=Math.max(1,x.height>>ot);lt===i.TEXTURE_3D||lt===i.TEXTURE_2D_ARRAY?e.texImage3D(lt,ot,Ft,Ct,qt,x.depth,0,Ut,_t,null):e.texImage2D(lt,ot,Ft,Ct,qt,0,Ut,_t,null)}e.bindFramebuffer(i.FRAMEBUFFER,C),rt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,q,lt,gt.__webglTexture,0,oe(x)):(lt===i.TEXTURE_2D||lt>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&lt<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,q,lt,gt.__webglTexture,ot),e.bindFramebuffer(i.FRAMEBUFFER,null)}function vt(C,x,N){if(i.bindRenderbuffer(i.RENDERBUFFER,C),x.depthBuffer){let q=x.depthTexture,lt=q&&q.isDepthTexture?q.type:null,ot=y(x.stencilBuffer,lt),Ut=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=oe(x);rt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,_t,ot,x.width,x.height):N?i.renderbufferStorageMultisample(i.RENDERBUFFER,_t,ot,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,ot,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Ut,i.RENDERBUFFER,C)}else{let q=x.textures;for(let lt=0;lt<q.length;lt++){let ot=q[lt],Ut=r.convert(ot.format,ot.colorSpace),_t=r.convert(ot.type),Ft=S(ot.internalFormat,Ut,_t,ot.colorSpace),Bt=oe(x);N&&rt(x)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Bt,Ft,x.width,x.height):rt(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Bt,Ft,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,Ft,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function bt(C,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,C),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let q=n.get(x.depthTexture);q.__renderTarget=x,(!q.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),W(x.depthTexture,0);let lt=q.__webglTexture,ot=oe(x);if(x.depthTexture.format===co)rt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,lt,0,ot):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,lt,0);else if(x.depthTexture.format===So)rt(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,lt,0,ot):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,lt,0);else throw new Error("Unknown depthTexture format")}function Gt(C){let x=n.get(C),N=C.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==C.depthTexture){let q=C.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),q){let lt=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,q.removeEventListener("dispose",lt)};q.addEventListener("dispose",lt),x.__depthDisposeCallback=lt}x.__boundDepthTexture=q}if(C.depthTexture&&!x.__autoAllocateDepthBuffer){if(N)throw new Error("target.depthTexture not supported in Cube render targets");let q=C.texture.mipmaps;q&&q.length>0?bt(x.__webglFramebuffer[0],C):bt(x.__webglFramebuffer,C)}else if(N){x.__webglDepthbuffer=[];for(let q=0;q<6;q++)if(e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[q]),x.__webglDepthbuffer[q]===void 0)x.__webglDepthbuffer[q]=i.createRenderbuffer(),vt(x.__webglDepthbuffer[q],C,!1);else{let lt=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ot=x.__webglDepthbuffer[q];i.bindRenderbuffer(i.RENDERBUFFER,ot),i.framebufferRenderbuffer(i.FRAMEBUFFER,lt,i.RENDERBUFFER,ot)}}else{let q=C.texture.mipmaps;if(q&&q.length>0?e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),vt(x.__webglDepthbuffer,C,!1);else{let lt=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ot=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ot),i.framebufferRenderbuffer(i.FRAMEBUFFER,lt,i.RENDERBUFFER,ot)}}e.bindFramebuffer(i.FRAMEBUFFER,null)}function de(C,x,N){let q=n.get(C);x!==void 0&&mt(q.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),N!==void 0&&Gt(C)}function k(C){let x=C.texture,N=n.get(C),q=n.get(x);C.addEventListener("dispose",I);let lt=C.textures,ot=C.isWebGLCubeRenderTarget===!0,Ut=lt.length>1;if(Ut||(q.__webglTexture===void 0&&(q.__webglTexture=i.createTexture()),q.__version=x.version,o.memory.textures++),ot){N.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(x.mipmaps&&x.mipmaps.length>0){N.__webglFramebuffer[_t]=[];for(let Ft=0;Ft<x.mipmaps.length;Ft++)N.__webglFramebuffer[_t][Ft]=i.createFramebuffer()}else N.__webglFramebuffer[_t]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){N.__webglFramebuffer=[];for(let _t=0;_t<x.mipmaps.length;_t++)N.__webglFramebuffer[_t]=i.createFramebuffer()}else N.__webglFramebuffer=i.createFramebuffer();if(Ut)for(let _t=0,Ft=lt.length;_t<Ft;_t++){let Bt=n.get(lt[_t]);Bt.__webglTexture===void 0&&(Bt.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&rt(C)===!1){N.__webglMultisampledFramebuffer=i.createFramebuffer(),N.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,N.__webglMultisampledFramebuffer);for(let _t=0;_t<lt.length;_t++){let Ft=lt[_t];N.__webglColorRenderbuffer[_t]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,N.__webglColorRenderbuffer[_t]);let Bt=r.convert(Ft.format,Ft.colorSpace),gt=r.convert(Ft.type),Ct=S(Ft.internalFormat,Bt,gt,Ft.colorSpace,C.isXRRenderTarget===!0),qt=oe(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,qt,Ct,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,N.__webglColorRenderbuffer[_t])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(N.__webglDepthRenderbuffer=i.createRenderbuffer(),vt(N.__webglDepthRenderbuffer,C,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ot){e.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture),ct(i.TEXTURE_CUBE_MAP,x);for(let _t=0;_t<6;_t++)if(x.mipmaps&&x.mipmaps.length>0)for(let Ft=0;Ft<x.mipmaps.length;Ft++)mt(N.__webglFramebuffer[_t][Ft],C,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,Ft);else mt(N.__webglFramebuffer[_t],C,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);g(x)&&d(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(Ut){for(let _t=0,Ft=lt.length;_t<Ft;_t++){let Bt=lt[_t],gt=n.get(Bt),Ct=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(Ct=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Ct,gt.__webglTexture),ct(Ct,Bt),mt(N.__webglFramebuffer,C,Bt,i.COLOR_ATTACHMENT0+_t,Ct,0),g(Bt)&&d(Ct)}e.unbindTexture()}else{let _t=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(_t=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(_t,q.__webglTexture),ct(_t,x),x.mipmaps&&x.mipmaps.length>0)for(let Ft=0;Ft<x.mipmaps.length;Ft++)mt(N.__webglFramebuffer[Ft],C,x,i.COLOR_ATTACHMENT0,_t,Ft);else mt(N.__webglFramebuffer,C,x,i.COLOR_ATTACHMENT0,_t,0);g(x)&&d(_t),e.unbindTexture()}C.depthBuffer&&Gt(C)}function he(C){let x=C.textures;for(let N=0,q=x.length;N<q;N++){let lt=x[N];if(g(lt)){let ot=b(C),Ut=n.get(lt).__webglTexture;e.bindTexture(ot,Ut),d(ot),e.unbindTexture()}}}let st=[],wt=[];function Pt(C){if(C.samples>0){if(rt(C)===!1){let x=C.textures,N=C.width,q=C.height,lt=i.COLOR_BUFFER_BIT,ot=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ut=n.get(C),_t=x.length>1;if(_t)for(let Bt=0;Bt<x.length;Bt++)e.bindFramebuffer(i.FRAMEBUFFER,Ut.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Bt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Ut.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Bt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Ut.__webglMultisampledFramebuffer);let Ft=C.texture.mipmaps;Ft&&Ft.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ut.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ut.__webglFramebuffer);for(let Bt=0;Bt<x.length;Bt++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(lt|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(lt|=i.STENCIL_BUFFER_BIT)),_t){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Ut.__webglColorRenderbuffer[Bt]);let gt=n.get(x[Bt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,gt,0)}i.blitFramebuffer(0,0,N,q,0,0,N,q,lt,i.NEAREST),l===!0&&(st.length=0,wt.length=0,st.push(i.COLOR_ATTACHMENT0+Bt),C.depthBuffer&&C.resolveDepthBuffer===!1&&(st.push(ot),wt.push(ot),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,wt)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,st))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),_t)for(let Bt=0;Bt<x.length;Bt++){e.bindFramebuffer(i.FRAMEBUFFER,Ut.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Bt,i.RENDERBUFFER,Ut.__webglColorRenderbuffer[Bt]);let gt=n.get(x[Bt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Ut.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Bt,i.TEXTURE_2D,gt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Ut.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.resolveDepthBuffer===!1&&l){let x=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function oe(C){return Math.min(s.maxSamples,C.samples)}function rt(C){let x=n.get(C);return C.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Q(C){let x=o.render.frame;u.get(C)!==x&&(u.set(C,x),C.update())}function ut(C,x){let N=C.colorSpace,q=C.format,lt=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||N!==cr&&N!==ys&&(_e.getTransfer(N)===Pe?(q!==_i||lt!==Fi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",N)),x}function St(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=H,this.resetTextureUnits=B,this.setTexture2D=W,this.setTexture2DArray=X,this.setTexture3D=F,this.setTextureCube=z,this.rebindTextures=de,this.setupRenderTarget=k,this.updateRenderTargetMipmap=he,this.updateMultisampleRenderTarget=Pt,this.setupDepthRenderbuffer=Gt,this.setupFrameBufferTexture=mt,this.useMultisampledRTT=rt}function ES(i,t){function e(n,s=ys){let r,o=_e.getTransfer(s);if(n===Fi)return i.UNSIGNED_BYTE;if(n===Hc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Vc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===_f)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===xf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===gf)return i.BYTE;if(n===vf)return i.SHORT;if(n===bo)return i.UNSIGNED_SHORT;if(n===kc)return i.INT;if(n===Ws)return i.UNSIGNED_INT;if(n===ts)return i.FLOAT;if(n===Mo)return i.HALF_FLOAT;if(n===yf)return i.ALPHA;if(n===bf)return i.RGB;if(n===_i)return i.RGBA;if(n===co)return i.DEPTH_COMPONENT;if(n===So)return i.DEPTH_STENCIL;if(n===Mf)return i.RED;if(n===Gc)return i.RED_INTEGER;if(n===wf)return i.RG;if(n===Wc)return i.RG_INTEGER;if(n===Xc)return i.RGBA_INTEGER;if(n===Ga||n===Wa||n===Xa||n===qa)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ga)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ga)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===qc||n===Yc||n===$c||n===Zc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===qc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Yc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===$c)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Zc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Kc||n===Jc||n===jc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Kc||n===Jc)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===jc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Qc||n===th||n===eh||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===hh||n===uh||n===fh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Qc)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===th)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===eh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===nh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ih)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===sh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===rh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===oh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ah)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===lh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===ch)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===hh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===uh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===fh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===dh||n===ph||n===mh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===dh)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===ph)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===mh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===gh||n===vh||n===_h||n===xh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===gh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===vh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===_h)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===xh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===wo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var TS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,AS=`
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

}`,$f=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Sa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new oi({vertexShader:TS,fragmentShader:AS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Qt(new Ra(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Zf=class extends Zi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,m=null,v=typeof XRWebGLBinding<"u",g=new $f,d={},b=e.getContextAttributes(),S=null,y=null,P=[],E=[],I=new Ot,D=null,M=new In;M.viewport=new Ie;let w=new In;w.viewport=new Ie;let T=[M,w],B=new Cc,H=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let $=P[tt];return $===void 0&&($=new po,P[tt]=$),$.getTargetRaySpace()},this.getControllerGrip=function(tt){let $=P[tt];return $===void 0&&($=new po,P[tt]=$),$.getGripSpace()},this.getHand=function(tt){let $=P[tt];return $===void 0&&($=new po,P[tt]=$),$.getHandSpace()};function W(tt){let $=E.indexOf(tt.inputSource);if($===-1)return;let mt=P[$];mt!==void 0&&(mt.update(tt.inputSource,tt.frame,c||o),mt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function X(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",X),s.removeEventListener("inputsourceschange",F);for(let tt=0;tt<P.length;tt++){let $=E[tt];$!==null&&(E[tt]=null,P[tt].disconnect($))}H=null,V=null,g.reset();for(let tt in d)delete d[tt];t.setRenderTarget(S),p=null,f=null,h=null,s=null,y=null,xt.stop(),n.isPresenting=!1,t.setPixelRatio(D),t.setSize(I.width,I.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",X),s.addEventListener("inputsourceschange",F),b.xrCompatible!==!0&&await e.makeXRCompatible(),D=t.getPixelRatio(),t.getSize(I),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let mt=null,vt=null,bt=null;b.depth&&(bt=b.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,mt=b.stencil?So:co,vt=b.stencil?wo:Ws);let Gt={colorFormat:e.RGBA8,depthFormat:bt,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Gt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),y=new Ki(f.textureWidth,f.textureHeight,{format:_i,type:Fi,depthTexture:new wa(f.textureWidth,f.textureHeight,vt,void 0,void 0,void 0,void 0,void 0,void 0,mt),stencilBuffer:b.stencil,colorSpace:t.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let mt={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,mt),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),y=new Ki(p.framebufferWidth,p.framebufferHeight,{format:_i,type:Fi,colorSpace:t.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),xt.setContext(s),xt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function F(tt){for(let $=0;$<tt.removed.length;$++){let mt=tt.removed[$],vt=E.indexOf(mt);vt>=0&&(E[vt]=null,P[vt].disconnect(mt))}for(let $=0;$<tt.added.length;$++){let mt=tt.added[$],vt=E.indexOf(mt);if(vt===-1){for(let Gt=0;Gt<P.length;Gt++)if(Gt>=E.length){E.push(mt),vt=Gt;break}else if(E[Gt]===null){E[Gt]=mt,vt=Gt;break}if(vt===-1)break}let bt=P[vt];bt&&bt.connect(mt)}}let z=new L,J=new L;function nt(tt,$,mt){z.setFromMatrixPosition($.matrixWorld),J.setFromMatrixPosition(mt.matrixWorld);let vt=z.distanceTo(J),bt=$.projectionMatrix.elements,Gt=mt.projectionMatrix.elements,de=bt[14]/(bt[10]-1),k=bt[14]/(bt[10]+1),he=(bt[9]+1)/bt[5],st=(bt[9]-1)/bt[5],wt=(bt[8]-1)/bt[0],Pt=(Gt[8]+1)/Gt[0],oe=de*wt,rt=de*Pt,Q=vt/(-wt+Pt),ut=Q*-wt;if($.matrixWorld.decompose(tt.position,tt.quaternion,tt.scale),tt.translateX(ut),tt.translateZ(Q),tt.matrixWorld.compose(tt.position,tt.quaternion,tt.scale),tt.matrixWorldInverse.copy(tt.matrixWorld).invert(),bt[10]===-1)tt.projectionMatrix.copy($.projectionMatrix),tt.projectionMatrixInverse.copy($.projectionMatrixInverse);else{let St=de+Q,C=k+Q,x=oe-ut,N=rt+(vt-ut),q=he*k/C*St,lt=st*k/C*St;tt.projectionMatrix.makePerspective(x,N,q,lt,St,C),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert()}}function et(tt,$){$===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices($.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let $=tt.near,mt=tt.far;g.texture!==null&&(g.depthNear>0&&($=g.depthNear),g.depthFar>0&&(mt=g.depthFar)),B.near=w.near=M.near=$,B.far=w.far=M.far=mt,(H!==B.near||V!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),H=B.near,V=B.far),B.layers.mask=tt.layers.mask|6,M.layers.mask=B.layers.mask&3,w.layers.mask=B.layers.mask&5;let vt=tt.parent,bt=B.cameras;et(B,vt);for(let Gt=0;Gt<bt.length;Gt++)et(bt[Gt],vt);bt.length===2?nt(B,M,w):B.projectionMatrix.copy(M.projectionMatrix),ct(tt,B,vt)};function ct(tt,$,mt){mt===null?tt.matrix.copy($.matrixWorld):(tt.matrix.copy(mt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply($.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy($.projectionMatrix),tt.projectionMatrixInverse.copy($.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=ho*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(tt){l=tt,f!==null&&(f.fixedFoveation=tt),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function(tt){return d[tt]};let ft=null;function yt(tt,$){if(u=$.getViewerPose(c||o),m=$,u!==null){let mt=u.views;p!==null&&(t.setRenderTargetFramebuffer(y,p.framebuffer),t.setRenderTarget(y));let vt=!1;mt.length!==B.cameras.length&&(B.cameras.length=0,vt=!0);for(let k=0;k<mt.length;k++){let he=mt[k],st=null;if(p!==null)st=p.getViewport(he);else{let Pt=h.getViewSubImage(f,he);st=Pt.viewport,k===0&&(t.setRenderTargetTextures(y,Pt.colorTexture,Pt.depthStencilTexture),t.setRenderTarget(y))}let wt=T[k];wt===void 0&&(wt=new In,wt.layers.enable(k),wt.viewport=new Ie,T[k]=wt),wt.matrix.fromArray(he.transform.matrix),wt.matrix.decompose(wt.position,wt.quaternion,wt.scale),wt.projectionMatrix.fromArray(he.projectionMatrix),wt.projectionMatrixInverse.copy(wt.projectionMatrix).invert(),wt.viewport.set(st.x,st.y,st.width,st.height),k===0&&(B.matrix.copy(wt.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),vt===!0&&B.cameras.push(wt)}let bt=s.enabledFeatures;if(bt&&bt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=n.getBinding();let k=h.getDepthInformation(mt[0]);k&&k.isValid&&k.texture&&g.init(k,s.renderState)}if(bt&&bt.includes("camera-access")&&v){t.state.unbindTexture(),h=n.getBinding();for(let k=0;k<mt.length;k++){let he=mt[k].camera;if(he){let st=d[he];st||(st=new Sa,d[he]=st);let wt=h.getCameraImage(he);st.sourceTexture=wt}}}}for(let mt=0;mt<P.length;mt++){let vt=E[mt],bt=P[mt];vt!==null&&bt!==void 0&&bt.update(vt,$,c||o)}ft&&ft(tt,$),$.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:$}),m=null}let xt=new Mg;xt.setAnimationLoop(yt),this.setAnimationLoop=function(tt){ft=tt},this.dispose=function(){}}},yr=new Ui,RS=new Ue;function CS(i,t){function e(g,d){g.matrixAutoUpdate===!0&&g.updateMatrix(),d.value.copy(g.matrix)}function n(g,d){d.color.getRGB(g.fogColor.value,If(i)),d.isFog?(g.fogNear.value=d.near,g.fogFar.value=d.far):d.isFogExp2&&(g.fogDensity.value=d.density)}function s(g,d,b,S,y){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(g,d):d.isMeshToonMaterial?(r(g,d),h(g,d)):d.isMeshPhongMaterial?(r(g,d),u(g,d)):d.isMeshStandardMaterial?(r(g,d),f(g,d),d.isMeshPhysicalMaterial&&p(g,d,y)):d.isMeshMatcapMaterial?(r(g,d),m(g,d)):d.isMeshDepthMaterial?r(g,d):d.isMeshDistanceMaterial?(r(g,d),v(g,d)):d.isMeshNormalMaterial?r(g,d):d.isLineBasicMaterial?(o(g,d),d.isLineDashedMaterial&&a(g,d)):d.isPointsMaterial?l(g,d,b,S):d.isSpriteMaterial?c(g,d):d.isShadowMaterial?(g.color.value.copy(d.color),g.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(g,d){g.opacity.value=d.opacity,d.color&&g.diffuse.value.copy(d.color),d.emissive&&g.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(g.map.value=d.map,e(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.bumpMap&&(g.bumpMap.value=d.bumpMap,e(d.bumpMap,g.bumpMapTransform),g.bumpScale.value=d.bumpScale,d.side===Wn&&(g.bumpScale.value*=-1)),d.normalMap&&(g.normalMap.value=d.normalMap,e(d.normalMap,g.normalMapTransform),g.normalScale.value.copy(d.normalScale),d.side===Wn&&g.normalScale.value.negate()),d.displacementMap&&(g.displacementMap.value=d.displacementMap,e(d.displacementMap,g.displacementMapTransform),g.displacementScale.value=d.displacementScale,g.displacementBias.value=d.displacementBias),d.emissiveMap&&(g.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,g.emissiveMapTransform)),d.specularMap&&(g.specularMap.value=d.specularMap,e(d.specularMap,g.specularMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest);let b=t.get(d),S=b.envMap,y=b.envMapRotation;S&&(g.envMap.value=S,yr.copy(y),yr.x*=-1,yr.y*=-1,yr.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(yr.y*=-1,yr.z*=-1),g.envMapRotation.value.setFromMatrix4(RS.makeRotationFromEuler(yr)),g.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,g.reflectivity.value=d.reflectivity,g.ior.value=d.ior,g.refractionRatio.value=d.refractionRatio),d.lightMap&&(g.lightMap.value=d.lightMap,g.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,g.lightMapTransform)),d.aoMap&&(g.aoMap.value=d.aoMap,g.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,g.aoMapTransform))}function o(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,d.map&&(g.map.value=d.map,e(d.map,g.mapTransform))}function a(g,d){g.dashSize.value=d.dashSize,g.totalSize.value=d.dashSize+d.gapSize,g.scale.value=d.scale}function l(g,d,b,S){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.size.value=d.size*b,g.scale.value=S*.5,d.map&&(g.map.value=d.map,e(d.map,g.uvTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function c(g,d){g.diffuse.value.copy(d.color),g.opacity.value=d.opacity,g.rotation.value=d.rotation,d.map&&(g.map.value=d.map,e(d.map,g.mapTransform)),d.alphaMap&&(g.alphaMap.value=d.alphaMap,e(d.alphaMap,g.alphaMapTransform)),d.alphaTest>0&&(g.alphaTest.value=d.alphaTest)}function u(g,d){g.specular.value.copy(d.specular),g.shininess.value=Math.max(d.shininess,1e-4)}function h(g,d){d.gradientMap&&(g.gradientMap.value=d.gradientMap)}function f(g,d){g.metalness.value=d.metalness,d.metalnessMap&&(g.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,g.metalnessMapTransform)),g.roughness.value=d.roughness,d.roughnessMap&&(g.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,g.roughnessMapTransform)),d.envMap&&(g.envMapIntensity.value=d.envMapIntensity)}function p(g,d,b){g.ior.value=d.ior,d.sheen>0&&(g.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),g.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(g.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,g.sheenColorMapTransform)),d.sheenRoughnessMap&&(g.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,g.sheenRoughnessMapTransform))),d.clearcoat>0&&(g.clearcoat.value=d.clearcoat,g.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(g.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,g.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(g.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Wn&&g.clearcoatNormalScale.value.negate())),d.dispersion>0&&(g.dispersion.value=d.dispersion),d.iridescence>0&&(g.iridescence.value=d.iridescence,g.iridescenceIOR.value=d.iridescenceIOR,g.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],g.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(g.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,g.iridescenceMapTransform)),d.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),d.transmission>0&&(g.transmission.value=d.transmission,g.transmissionSamplerMap.value=b.texture,g.transmissionSamplerSize.value.set(b.width,b.height),d.transmissionMap&&(g.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,g.transmissionMapTransform)),g.thickness.value=d.thickness,d.thicknessMap&&(g.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=d.attenuationDistance,g.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(g.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(g.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=d.specularIntensity,g.specularColor.value.copy(d.specularColor),d.specularColorMap&&(g.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,g.specularColorMapTransform)),d.specularIntensityMap&&(g.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,d){d.matcap&&(g.matcap.value=d.matcap)}function v(g,d){let b=t.get(d).light;g.referencePosition.value.setFromMatrixPosition(b.matrixWorld),g.nearDistance.value=b.shadow.camera.near,g.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function PS(i,t,e,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,S){let y=S.program;n.uniformBlockBinding(b,y)}function c(b,S){let y=s[b.id];y===void 0&&(m(b),y=u(b),s[b.id]=y,b.addEventListener("dispose",g));let P=S.program;n.updateUBOMapping(b,P);let E=t.render.frame;r[b.id]!==E&&(f(b),r[b.id]=E)}function u(b){let S=h();b.__bindingPointIndex=S;let y=i.createBuffer(),P=b.__size,E=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,y),i.bufferData(i.UNIFORM_BUFFER,P,E),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,y),y}function h(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(b){let S=s[b.id],y=b.uniforms,P=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let E=0,I=y.length;E<I;E++){let D=Array.isArray(y[E])?y[E]:[y[E]];for(let M=0,w=D.length;M<w;M++){let T=D[M];if(p(T,E,M,P)===!0){let B=T.__offset,H=Array.isArray(T.value)?T.value:[T.value],V=0;for(let W=0;W<H.length;W++){let X=H[W],F=v(X);typeof X=="number"||typeof X=="boolean"?(T.__data[0]=X,i.bufferSubData(i.UNIFORM_BUFFER,B+V,T.__data)):X.isMatrix3?(T.__data[0]=X.elements[0],T.__data[1]=X.elements[1],T.__data[2]=X.elements[2],T.__data[3]=0,T.__data[4]=X.elements[3],T.__data[5]=X.elements[4],T.__data[6]=X.elements[5],T.__data[7]=0,T.__data[8]=X.elements[6],T.__data[9]=X.elements[7],T.__data[10]=X.elements[8],T.__data[11]=0):(X.toArray(T.__data,V),V+=F.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,B,T.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(b,S,y,P){let E=b.value,I=S+"_"+y;if(P[I]===void 0)return typeof E=="number"||typeof E=="boolean"?P[I]=E:P[I]=E.clone(),!0;{let D=P[I];if(typeof E=="number"||typeof E=="boolean"){if(D!==E)return P[I]=E,!0}else if(D.equals(E)===!1)return D.copy(E),!0}return!1}function m(b){let S=b.uniforms,y=0,P=16;for(let I=0,D=S.length;I<D;I++){let M=Array.isArray(S[I])?S[I]:[S[I]];for(let w=0,T=M.length;w<T;w++){let B=M[w],H=Array.isArray(B.value)?B.value:[B.value];for(let V=0,W=H.length;V<W;V++){let X=H[V],F=v(X),z=y%P,J=z%F.boundary,nt=z+J;y+=J,nt!==0&&P-nt<F.storage&&(y+=P-nt),B.__data=new Float32Array(F.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=y,y+=F.storage}}}let E=y%P;return E>0&&(y+=P-E),b.__size=y,b.__cache={},this}function v(b){let S={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(S.boundary=4,S.storage=4):b.isVector2?(S.boundary=8,S.storage=8):b.isVector3||b.isColor?(S.boundary=16,S.storage=12):b.isVector4?(S.boundary=16,S.storage=16):b.isMatrix3?(S.boundary=48,S.storage=48):b.isMatrix4?(S.boundary=64,S.storage=64):b.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",b),S}function g(b){let S=b.target;S.removeEventListener("dispose",g);let y=o.indexOf(S.__bindingPointIndex);o.splice(y,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function d(){for(let b in s)i.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var Sh=class{constructor(t={}){let{canvas:e=$m(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let m=new Uint32Array(4),v=new Int32Array(4),g=null,d=null,b=[],S=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=xs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let y=this,P=!1;this._outputColorSpace=Gn;let E=0,I=0,D=null,M=-1,w=null,T=new Ie,B=new Ie,H=null,V=new ae(0),W=0,X=e.width,F=e.height,z=1,J=null,nt=null,et=new Ie(0,0,X,F),ct=new Ie(0,0,X,F),ft=!1,yt=new _o,xt=!1,tt=!1,$=new Ue,mt=new L,vt=new Ie,bt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Gt=!1;function de(){return D===null?z:1}let k=n;function he(R,K){return e.getContext(R,K)}try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"180"}`),e.addEventListener("webglcontextlost",Rt,!1),e.addEventListener("webglcontextrestored",Vt,!1),e.addEventListener("webglcontextcreationerror",Et,!1),k===null){let K="webgl2";if(k=he(K,R),k===null)throw he(K)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(R){throw console.error("THREE.WebGLRenderer: "+R.message),R}let st,wt,Pt,oe,rt,Q,ut,St,C,x,N,q,lt,ot,Ut,_t,Ft,Bt,gt,Ct,qt,Yt,Lt,Zt;function Y(){st=new $M(k),st.init(),Yt=new ES(k,st),wt=new HM(k,st,t,Yt),Pt=new wS(k,st),wt.reversedDepthBuffer&&f&&Pt.buffers.depth.setReversed(!0),oe=new JM(k),rt=new hS,Q=new SS(k,st,Pt,rt,wt,Yt,oe),ut=new GM(y),St=new YM(y),C=new iy(k),Lt=new zM(k,C),x=new ZM(k,C,oe,Lt),N=new QM(k,x,C,oe),gt=new jM(k,wt,Q),_t=new VM(rt),q=new cS(y,ut,St,st,wt,Lt,_t),lt=new CS(y,rt),ot=new fS,Ut=new _S(st),Bt=new BM(y,ut,St,Pt,N,p,l),Ft=new bS(y,N,wt),Zt=new PS(k,oe,wt,Pt),Ct=new kM(k,st,oe),qt=new KM(k,st,oe),oe.programs=q.programs,y.capabilities=wt,y.extensions=st,y.properties=rt,y.renderLists=ot,y.shadowMap=Ft,y.state=Pt,y.info=oe}Y();let Tt=new Zf(y,k);this.xr=Tt,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=st.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=st.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return z},this.setPixelRatio=function(R){R!==void 0&&(z=R,this.setSize(X,F,!1))},this.getSize=function(R){return R.set(X,F)},this.setSize=function(R,K,ht=!0){if(Tt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}X=R,F=K,e.width=Math.floor(R*z),e.height=Math.floor(K*z),ht===!0&&(e.style.width=R+"px",e.style.height=K+"px"),this.setViewport(0,0,R,K)},this.getDrawingBufferSize=function(R){return R.set(X*z,F*z).floor()},this.setDrawingBufferSize=function(R,K,ht){X=R,F=K,z=ht,e.width=Math.floor(R*ht),e.height=Math.floor(K*ht),this.setViewport(0,0,R,K)},this.getCurrentViewport=function(R){return R.copy(T)},this.getViewport=function(R){return R.copy(et)},this.setViewport=function(R,K,ht,at){R.isVector4?et.set(R.x,R.y,R.z,R.w):et.set(R,K,ht,at),Pt.viewport(T.copy(et).multiplyScalar(z).round())},this.getScissor=function(R){return R.copy(ct)},this.setScissor=function(R,K,ht,at){R.isVector4?ct.set(R.x,R.y,R.z,R.w):ct.set(R,K,ht,at),Pt.scissor(B.copy(ct).multiplyScalar(z).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(R){Pt.setScissorTest(ft=R)},this.setOpaqueSort=function(R){J=R},this.setTransparentSort=function(R){nt=R},this.getClearColor=function(R){return R.copy(Bt.getClearColor())},this.setClearColor=function(){Bt.setClearColor(...arguments)},this.getClearAlpha=function(){return Bt.getClearAlpha()},this.setClearAlpha=function(){Bt.setClearAlpha(...arguments)},this.clear=function(R=!0,K=!0,ht=!0){let at=0;if(R){let j=!1;if(D!==null){let At=D.texture.format;j=At===Xc||At===Wc||At===Gc}if(j){let At=D.texture.type,Nt=At===Fi||At===Ws||At===bo||At===wo||At===Hc||At===Vc,Wt=Bt.getClearColor(),zt=Bt.getClearAlpha(),te=Wt.r,ee=Wt.g,Kt=Wt.b;Nt?(m[0]=te,m[1]=ee,m[2]=Kt,m[3]=zt,k.clearBufferuiv(k.COLOR,0,m)):(v[0]=te,v[1]=ee,v[2]=Kt,v[3]=zt,k.clearBufferiv(k.COLOR,0,v))}else at|=k.COLOR_BUFFER_BIT}K&&(at|=k.DEPTH_BUFFER_BIT),ht&&(at|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k.clear(at)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",Rt,!1),e.removeEventListener("webglcontextrestored",Vt,!1),e.removeEventListener("webglcontextcreationerror",Et,!1),Bt.dispose(),ot.dispose(),Ut.dispose(),rt.dispose(),ut.dispose(),St.dispose(),N.dispose(),Lt.dispose(),Zt.dispose(),q.dispose(),Tt.dispose(),Tt.removeEventListener("sessionstart",Fe),Tt.removeEventListener("sessionend",ti),Yn.stop()};function Rt(R){R.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),P=!0}function Vt(){console.log("THREE.WebGLRenderer: Context Restored."),P=!1;let R=oe.autoReset,K=Ft.enabled,ht=Ft.autoUpdate,at=Ft.needsUpdate,j=Ft.type;Y(),oe.autoReset=R,Ft.enabled=K,Ft.autoUpdate=ht,Ft.needsUpdate=at,Ft.type=j}function Et(R){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function pt(R){let K=R.target;K.removeEventListener("dispose",pt),$t(K)}function $t(R){se(R),rt.remove(R)}function se(R){let K=rt.get(R).programs;K!==void 0&&(K.forEach(function(ht){q.releaseProgram(ht)}),R.isShaderMaterial&&q.releaseShaderCache(R))}this.renderBufferDirect=function(R,K,ht,at,j,At){K===null&&(K=bt);let Nt=j.isMesh&&j.matrixWorld.determinant()<0,Wt=os(R,K,ht,at,j);Pt.setMaterial(at,Nt);let zt=ht.index,te=1;if(at.wireframe===!0){if(zt=x.getWireframeAttribute(ht),zt===void 0)return;te=2}let ee=ht.drawRange,Kt=ht.attributes.position,ue=ee.start*te,ye=(ee.start+ee.count)*te;At!==null&&(ue=Math.max(ue,At.start*te),ye=Math.min(ye,(At.start+At.count)*te)),zt!==null?(ue=Math.max(ue,0),ye=Math.min(ye,zt.count)):Kt!=null&&(ue=Math.max(ue,0),ye=Math.min(ye,Kt.count));let ke=ye-ue;if(ke<0||ke===1/0)return;Lt.setup(j,at,Wt,ht,zt);let Re,le=Ct;if(zt!==null&&(Re=C.get(zt),le=qt,le.setIndex(Re)),j.isMesh)at.wireframe===!0?(Pt.setLineWidth(at.wireframeLinewidth*de()),le.setMode(k.LINES)):le.setMode(k.TRIANGLES);else if(j.isLine){let jt=at.linewidth;jt===void 0&&(jt=1),Pt.setLineWidth(jt*de()),j.isLineSegments?le.setMode(k.LINES):j.isLineLoop?le.setMode(k.LINE_LOOP):le.setMode(k.LINE_STRIP)}else j.isPoints?le.setMode(k.POINTS):j.isSprite&&le.setMode(k.TRIANGLES);if(j.isBatchedMesh)if(j._multiDrawInstances!==null)uo("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),le.renderMultiDrawInstances(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount,j._multiDrawInstances);else if(st.get("WEBGL_multi_draw"))le.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let jt=j._multiDrawStarts,He=j._multiDrawCounts,ge=j._multiDrawCount,An=zt?C.get(zt).bytesPerElement:1,ws=rt.get(at).currentProgram.getUniforms();for(let Fn=0;Fn<ge;Fn++)ws.setValue(k,"_gl_DrawID",Fn),le.render(jt[Fn]/An,He[Fn])}else if(j.isInstancedMesh)le.renderInstances(ue,ke,j.count);else if(ht.isInstancedBufferGeometry){let jt=ht._maxInstanceCount!==void 0?ht._maxInstanceCount:1/0,He=Math.min(ht.instanceCount,jt);le.renderInstances(ue,ke,He)}else le.render(ue,ke)};function Le(R,K,ht){R.transparent===!0&&R.side===Ln&&R.forceSinglePass===!1?(R.side=Wn,R.needsUpdate=!0,Zs(R,K,ht),R.side=gs,R.needsUpdate=!0,Zs(R,K,ht),R.side=Ln):Zs(R,K,ht)}this.compile=function(R,K,ht=null){ht===null&&(ht=R),d=Ut.get(ht),d.init(K),S.push(d),ht.traverseVisible(function(j){j.isLight&&j.layers.test(K.layers)&&(d.pushLight(j),j.castShadow&&d.pushShadow(j))}),R!==ht&&R.traverseVisible(function(j){j.isLight&&j.layers.test(K.layers)&&(d.pushLight(j),j.castShadow&&d.pushShadow(j))}),d.setupLights();let at=new Set;return R.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let At=j.material;if(At)if(Array.isArray(At))for(let Nt=0;Nt<At.length;Nt++){let Wt=At[Nt];Le(Wt,ht,j),at.add(Wt)}else Le(At,ht,j),at.add(At)}),d=S.pop(),at},this.compileAsync=function(R,K,ht=null){let at=this.compile(R,K,ht);return new Promise(j=>{function At(){if(at.forEach(function(Nt){rt.get(Nt).currentProgram.isReady()&&at.delete(Nt)}),at.size===0){j(R);return}setTimeout(At,10)}st.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let xe=null;function bn(R){xe&&xe(R)}function Fe(){Yn.stop()}function ti(){Yn.start()}let Yn=new Mg;Yn.setAnimationLoop(bn),typeof self<"u"&&Yn.setContext(self),this.setAnimationLoop=function(R){xe=R,Tt.setAnimationLoop(R),R===null?Yn.stop():Yn.start()},Tt.addEventListener("sessionstart",Fe),Tt.addEventListener("sessionend",ti),this.render=function(R,K){if(K!==void 0&&K.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),K.parent===null&&K.matrixWorldAutoUpdate===!0&&K.updateMatrixWorld(),Tt.enabled===!0&&Tt.isPresenting===!0&&(Tt.cameraAutoUpdate===!0&&Tt.updateCamera(K),K=Tt.getCamera()),R.isScene===!0&&R.onBeforeRender(y,R,K,D),d=Ut.get(R,S.length),d.init(K),S.push(d),$.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),yt.setFromProjectionMatrix($,Ii,K.reversedDepth),tt=this.localClippingEnabled,xt=_t.init(this.clippingPlanes,tt),g=ot.get(R,b.length),g.init(),b.push(g),Tt.enabled===!0&&Tt.isPresenting===!0){let At=y.xr.getDepthSensingMesh();At!==null&&Hi(At,K,-1/0,y.sortObjects)}Hi(R,K,0,y.sortObjects),g.finish(),y.sortObjects===!0&&g.sort(J,nt),Gt=Tt.enabled===!1||Tt.isPresenting===!1||Tt.hasDepthSensing()===!1,Gt&&Bt.addToRenderList(g,R),this.info.render.frame++,xt===!0&&_t.beginShadows();let ht=d.state.shadowsArray;Ft.render(ht,R,K),xt===!0&&_t.endShadows(),this.info.autoReset===!0&&this.info.reset();let at=g.opaque,j=g.transmissive;if(d.setupLights(),K.isArrayCamera){let At=K.cameras;if(j.length>0)for(let Nt=0,Wt=At.length;Nt<Wt;Nt++){let zt=At[Nt];rs(at,j,R,zt)}Gt&&Bt.render(R);for(let Nt=0,Wt=At.length;Nt<Wt;Nt++){let zt=At[Nt];Nn(g,R,zt,zt.viewport)}}else j.length>0&&rs(at,j,R,K),Gt&&Bt.render(R),Nn(g,R,K);D!==null&&I===0&&(Q.updateMultisampleRenderTarget(D),Q.updateRenderTargetMipmap(D)),R.isScene===!0&&R.onAfterRender(y,R,K),Lt.resetDefaultState(),M=-1,w=null,S.pop(),S.length>0?(d=S[S.length-1],xt===!0&&_t.setGlobalState(y.clippingPlanes,d.state.camera)):d=null,b.pop(),b.length>0?g=b[b.length-1]:g=null};function Hi(R,K,ht,at){if(R.visible===!1)return;if(R.layers.test(K.layers)){if(R.isGroup)ht=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(K);else if(R.isLight)d.pushLight(R),R.castShadow&&d.pushShadow(R);else if(R.isSprite){if(!R.frustumCulled||yt.intersectsSprite(R)){at&&vt.setFromMatrixPosition(R.matrixWorld).applyMatrix4($);let Nt=N.update(R),Wt=R.material;Wt.visible&&g.push(R,Nt,Wt,ht,vt.z,null)}}else if((R.isMesh||R.isLine||R.isPoints)&&(!R.frustumCulled||yt.intersectsObject(R))){let Nt=N.update(R),Wt=R.material;if(at&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),vt.copy(R.boundingSphere.center)):(Nt.boundingSphere===null&&Nt.computeBoundingSphere(),vt.copy(Nt.boundingSphere.center)),vt.applyMatrix4(R.matrixWorld).applyMatrix4($)),Array.isArray(Wt)){let zt=Nt.groups;for(let te=0,ee=zt.length;te<ee;te++){let Kt=zt[te],ue=Wt[Kt.materialIndex];ue&&ue.visible&&g.push(R,Nt,ue,ht,vt.z,Kt)}}else Wt.visible&&g.push(R,Nt,Wt,ht,vt.z,null)}}let At=R.children;for(let Nt=0,Wt=At.length;Nt<Wt;Nt++)Hi(At[Nt],K,ht,at)}function Nn(R,K,ht,at){let j=R.opaque,At=R.transmissive,Nt=R.transparent;d.setupLightsView(ht),xt===!0&&_t.setGlobalState(y.clippingPlanes,ht),at&&Pt.viewport(T.copy(at)),j.length>0&&bi(j,K,ht),At.length>0&&bi(At,K,ht),Nt.length>0&&bi(Nt,K,ht),Pt.buffers.depth.setTest(!0),Pt.buffers.depth.setMask(!0),Pt.buffers.color.setMask(!0),Pt.setPolygonOffset(!1)}function rs(R,K,ht,at){if((ht.isScene===!0?ht.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[at.id]===void 0&&(d.state.transmissionRenderTarget[at.id]=new Ki(1,1,{generateMipmaps:!0,type:st.has("EXT_color_buffer_half_float")||st.has("EXT_color_buffer_float")?Mo:Fi,minFilter:Gs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:_e.workingColorSpace}));let At=d.state.transmissionRenderTarget[at.id],Nt=at.viewport||T;At.setSize(Nt.z*y.transmissionResolutionScale,Nt.w*y.transmissionResolutionScale);let Wt=y.getRenderTarget(),zt=y.getActiveCubeFace(),te=y.getActiveMipmapLevel();y.setRenderTarget(At),y.getClearColor(V),W=y.getClearAlpha(),W<1&&y.setClearColor(16777215,.5),y.clear(),Gt&&Bt.render(ht);let ee=y.toneMapping;y.toneMapping=xs;let Kt=at.viewport;if(at.viewport!==void 0&&(at.viewport=void 0),d.setupLightsView(at),xt===!0&&_t.setGlobalState(y.clippingPlanes,at),bi(R,ht,at),Q.updateMultisampleRenderTarget(At),Q.updateRenderTargetMipmap(At),st.has("WEBGL_multisampled_render_to_texture")===!1){let ue=!1;for(let ye=0,ke=K.length;ye<ke;ye++){let Re=K[ye],le=Re.object,jt=Re.geometry,He=Re.material,ge=Re.group;if(He.side===Ln&&le.layers.test(at.layers)){let An=He.side;He.side=Wn,He.needsUpdate=!0,Go(le,ht,at,jt,He,ge),He.side=An,He.needsUpdate=!0,ue=!0}}ue===!0&&(Q.updateMultisampleRenderTarget(At),Q.updateRenderTargetMipmap(At))}y.setRenderTarget(Wt,zt,te),y.setClearColor(V,W),Kt!==void 0&&(at.viewport=Kt),y.toneMapping=ee}function bi(R,K,ht){let at=K.isScene===!0?K.overrideMaterial:null;for(let j=0,At=R.length;j<At;j++){let Nt=R[j],Wt=Nt.object,zt=Nt.geometry,te=Nt.group,ee=Nt.material;ee.allowOverride===!0&&at!==null&&(ee=at),Wt.layers.test(ht.layers)&&Go(Wt,K,ht,zt,ee,te)}}function Go(R,K,ht,at,j,At){R.onBeforeRender(y,K,ht,at,j,At),R.modelViewMatrix.multiplyMatrices(ht.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),j.onBeforeRender(y,K,ht,at,R,At),j.transparent===!0&&j.side===Ln&&j.forceSinglePass===!1?(j.side=Wn,j.needsUpdate=!0,y.renderBufferDirect(ht,K,at,j,R,At),j.side=gs,j.needsUpdate=!0,y.renderBufferDirect(ht,K,at,j,R,At),j.side=Ln):y.renderBufferDirect(ht,K,at,j,R,At),R.onAfterRender(y,K,ht,at,j,At)}function Zs(R,K,ht){K.isScene!==!0&&(K=bt);let at=rt.get(R),j=d.state.lights,At=d.state.shadowsArray,Nt=j.state.version,Wt=q.getParameters(R,j.state,At,K,ht),zt=q.getProgramCacheKey(Wt),te=at.programs;at.environment=R.isMeshStandardMaterial?K.environment:null,at.fog=K.fog,at.envMap=(R.isMeshStandardMaterial?St:ut).get(R.envMap||at.environment),at.envMapRotation=at.environment!==null&&R.envMap===null?K.environmentRotation:R.envMapRotation,te===void 0&&(R.addEventListener("dispose",pt),te=new Map,at.programs=te);let ee=te.get(zt);if(ee!==void 0){if(at.currentProgram===ee&&at.lightsStateVersion===Nt)return hl(R,Wt),ee}else Wt.uniforms=q.getUniforms(R),R.onBeforeCompile(Wt,y),ee=q.acquireProgram(Wt,zt),te.set(zt,ee),at.uniforms=Wt.uniforms;let Kt=at.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Kt.clippingPlanes=_t.uniform),hl(R,Wt),at.needsLights=Ks(R),at.lightsStateVersion=Nt,at.needsLights&&(Kt.ambientLightColor.value=j.state.ambient,Kt.lightProbe.value=j.state.probe,Kt.directionalLights.value=j.state.directional,Kt.directionalLightShadows.value=j.state.directionalShadow,Kt.spotLights.value=j.state.spot,Kt.spotLightShadows.value=j.state.spotShadow,Kt.rectAreaLights.value=j.state.rectArea,Kt.ltc_1.value=j.state.rectAreaLTC1,Kt.ltc_2.value=j.state.rectAreaLTC2,Kt.pointLights.value=j.state.point,Kt.pointLightShadows.value=j.state.pointShadow,Kt.hemisphereLights.value=j.state.hemi,Kt.directionalShadowMap.value=j.state.directionalShadowMap,Kt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Kt.spotShadowMap.value=j.state.spotShadowMap,Kt.spotLightMatrix.value=j.state.spotLightMatrix,Kt.spotLightMap.value=j.state.spotLightMap,Kt.pointShadowMap.value=j.state.pointShadowMap,Kt.pointShadowMatrix.value=j.state.pointShadowMatrix),at.currentProgram=ee,at.uniformsList=null,ee}function cl(R){if(R.uniformsList===null){let K=R.currentProgram.getUniforms();R.uniformsList=Ao.seqWithValue(K.seq,R.uniforms)}return R.uniformsList}function hl(R,K){let ht=rt.get(R);ht.outputColorSpace=K.outputColorSpace,ht.batching=K.batching,ht.batchingColor=K.batchingColor,ht.instancing=K.instancing,ht.instancingColor=K.instancingColor,ht.instancingMorph=K.instancingMorph,ht.skinning=K.skinning,ht.morphTargets=K.morphTargets,ht.morphNormals=K.morphNormals,ht.morphColors=K.morphColors,ht.morphTargetsCount=K.morphTargetsCount,ht.numClippingPlanes=K.numClippingPlanes,ht.numIntersection=K.numClipIntersection,ht.vertexAlphas=K.vertexAlphas,ht.vertexTangents=K.vertexTangents,ht.toneMapping=K.toneMapping}function os(R,K,ht,at,j){K.isScene!==!0&&(K=bt),Q.resetTextureUnits();let At=K.fog,Nt=at.isMeshStandardMaterial?K.environment:null,Wt=D===null?y.outputColorSpace:D.isXRRenderTarget===!0?D.texture.colorSpace:cr,zt=(at.isMeshStandardMaterial?St:ut).get(at.envMap||Nt),te=at.vertexColors===!0&&!!ht.attributes.color&&ht.attributes.color.itemSize===4,ee=!!ht.attributes.tangent&&(!!at.normalMap||at.anisotropy>0),Kt=!!ht.morphAttributes.position,ue=!!ht.morphAttributes.normal,ye=!!ht.morphAttributes.color,ke=xs;at.toneMapped&&(D===null||D.isXRRenderTarget===!0)&&(ke=y.toneMapping);let Re=ht.morphAttributes.position||ht.morphAttributes.normal||ht.morphAttributes.color,le=Re!==void 0?Re.length:0,jt=rt.get(at),He=d.state.lights;if(xt===!0&&(tt===!0||R!==w)){let dn=R===w&&at.id===M;_t.setState(at,R,dn)}let ge=!1;at.version===jt.__version?(jt.needsLights&&jt.lightsStateVersion!==He.state.version||jt.outputColorSpace!==Wt||j.isBatchedMesh&&jt.batching===!1||!j.isBatchedMesh&&jt.batching===!0||j.isBatchedMesh&&jt.batchingColor===!0&&j.colorTexture===null||j.isBatchedMesh&&jt.batchingColor===!1&&j.colorTexture!==null||j.isInstancedMesh&&jt.instancing===!1||!j.isInstancedMesh&&jt.instancing===!0||j.isSkinnedMesh&&jt.skinning===!1||!j.isSkinnedMesh&&jt.skinning===!0||j.isInstancedMesh&&jt.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&jt.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&jt.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&jt.instancingMorph===!1&&j.morphTexture!==null||jt.envMap!==zt||at.fog===!0&&jt.fog!==At||jt.numClippingPlanes!==void 0&&(jt.numClippingPlanes!==_t.numPlanes||jt.numIntersection!==_t.numIntersection)||jt.vertexAlphas!==te||jt.vertexTangents!==ee||jt.morphTargets!==Kt||jt.morphNormals!==ue||jt.morphColors!==ye||jt.toneMapping!==ke||jt.morphTargetsCount!==le)&&(ge=!0):(ge=!0,jt.__version=at.version);let An=jt.currentProgram;ge===!0&&(An=Zs(at,K,j));let ws=!1,Fn=!1,Js=!1,Ve=An.getUniforms(),On=jt.uniforms;if(Pt.useProgram(An.program)&&(ws=!0,Fn=!0,Js=!0),at.id!==M&&(M=at.id,Fn=!0),ws||w!==R){Pt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),Ve.setValue(k,"projectionMatrix",R.projectionMatrix),Ve.setValue(k,"viewMatrix",R.matrixWorldInverse);let pn=Ve.map.cameraPosition;pn!==void 0&&pn.setValue(k,mt.setFromMatrixPosition(R.matrixWorld)),wt.logarithmicDepthBuffer&&Ve.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(at.isMeshPhongMaterial||at.isMeshToonMaterial||at.isMeshLambertMaterial||at.isMeshBasicMaterial||at.isMeshStandardMaterial||at.isShaderMaterial)&&Ve.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),w!==R&&(w=R,Fn=!0,Js=!0)}if(j.isSkinnedMesh){Ve.setOptional(k,j,"bindMatrix"),Ve.setOptional(k,j,"bindMatrixInverse");let dn=j.skeleton;dn&&(dn.boneTexture===null&&dn.computeBoneTexture(),Ve.setValue(k,"boneTexture",dn.boneTexture,Q))}j.isBatchedMesh&&(Ve.setOptional(k,j,"batchingTexture"),Ve.setValue(k,"batchingTexture",j._matricesTexture,Q),Ve.setOptional(k,j,"batchingIdTexture"),Ve.setValue(k,"batchingIdTexture",j._indirectTexture,Q),Ve.setOptional(k,j,"batchingColorTexture"),j._colorsTexture!==null&&Ve.setValue(k,"batchingColorTexture",j._colorsTexture,Q));let $n=ht.morphAttributes;if(($n.position!==void 0||$n.normal!==void 0||$n.color!==void 0)&&gt.update(j,ht,An),(Fn||jt.receiveShadow!==j.receiveShadow)&&(jt.receiveShadow=j.receiveShadow,Ve.setValue(k,"receiveShadow",j.receiveShadow)),at.isMeshGouraudMaterial&&at.envMap!==null&&(On.envMap.value=zt,On.flipEnvMap.value=zt.isCubeTexture&&zt.isRenderTargetTexture===!1?-1:1),at.isMeshStandardMaterial&&at.envMap===null&&K.environment!==null&&(On.envMapIntensity.value=K.environmentIntensity),Fn&&(Ve.setValue(k,"toneMappingExposure",y.toneMappingExposure),jt.needsLights&&ru(On,Js),At&&at.fog===!0&&lt.refreshFogUniforms(On,At),lt.refreshMaterialUniforms(On,at,z,F,d.state.transmissionRenderTarget[R.id]),Ao.upload(k,cl(jt),On,Q)),at.isShaderMaterial&&at.uniformsNeedUpdate===!0&&(Ao.upload(k,cl(jt),On,Q),at.uniformsNeedUpdate=!1),at.isSpriteMaterial&&Ve.setValue(k,"center",j.center),Ve.setValue(k,"modelViewMatrix",j.modelViewMatrix),Ve.setValue(k,"normalMatrix",j.normalMatrix),Ve.setValue(k,"modelMatrix",j.matrixWorld),at.isShaderMaterial||at.isRawShaderMaterial){let dn=at.uniformsGroups;for(let pn=0,Ss=dn.length;pn<Ss;pn++){let ui=dn[pn];Zt.update(ui,An),Zt.bind(ui,An)}}return An}function ru(R,K){R.ambientLightColor.needsUpdate=K,R.lightProbe.needsUpdate=K,R.directionalLights.needsUpdate=K,R.directionalLightShadows.needsUpdate=K,R.pointLights.needsUpdate=K,R.pointLightShadows.needsUpdate=K,R.spotLights.needsUpdate=K,R.spotLightShadows.needsUpdate=K,R.rectAreaLights.needsUpdate=K,R.hemisphereLights.needsUpdate=K}function Ks(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return E},this.getActiveMipmapLevel=function(){return I},this.getRenderTarget=function(){return D},this.setRenderTargetTextures=function(R,K,ht){let at=rt.get(R);at.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,at.__autoAllocateDepthBuffer===!1&&(at.__useRenderToTexture=!1),rt.get(R.texture).__webglTexture=K,rt.get(R.depthTexture).__webglTexture=at.__autoAllocateDepthBuffer?void 0:ht,at.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,K){let ht=rt.get(R);ht.__webglFramebuffer=K,ht.__useDefaultFramebuffer=K===void 0};let ul=k.createFramebuffer();this.setRenderTarget=function(R,K=0,ht=0){D=R,E=K,I=ht;let at=!0,j=null,At=!1,Nt=!1;if(R){let zt=rt.get(R);if(zt.__useDefaultFramebuffer!==void 0)Pt.bindFramebuffer(k.FRAMEBUFFER,null),at=!1;else if(zt.__webglFramebuffer===void 0)Q.setupRenderTarget(R);else if(zt.__hasExternalTextures)Q.rebindTextures(R,rt.get(R.texture).__webglTexture,rt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Kt=R.depthTexture;if(zt.__boundDepthTexture!==Kt){if(Kt!==null&&rt.has(Kt)&&(R.width!==Kt.image.width||R.height!==Kt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Q.setupDepthRenderbuffer(R)}}let te=R.texture;(te.isData3DTexture||te.isDataArrayTexture||te.isCompressedArrayTexture)&&(Nt=!0);let ee=rt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(ee[K])?j=ee[K][ht]:j=ee[K],At=!0):R.samples>0&&Q.useMultisampledRTT(R)===!1?j=rt.get(R).__webglMultisampledFramebuffer:Array.isArray(ee)?j=ee[ht]:j=ee,T.copy(R.viewport),B.copy(R.scissor),H=R.scissorTest}else T.copy(et).multiplyScalar(z).floor(),B.copy(ct).multiplyScalar(z).floor(),H=ft;if(ht!==0&&(j=ul),Pt.bindFramebuffer(k.FRAMEBUFFER,j)&&at&&Pt.drawBuffers(R,j),Pt.viewport(T),Pt.scissor(B),Pt.setScissorTest(H),At){let zt=rt.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+K,zt.__webglTexture,ht)}else if(Nt){let zt=K;for(let te=0;te<R.textures.length;te++){let ee=rt.get(R.textures[te]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+te,ee.__webglTexture,ht,zt)}}else if(R!==null&&ht!==0){let zt=rt.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,zt.__webglTexture,ht)}M=-1},this.readRenderTargetPixels=function(R,K,ht,at,j,At,Nt,Wt=0){if(!(R&&R.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let zt=rt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Nt!==void 0&&(zt=zt[Nt]),zt){Pt.bindFramebuffer(k.FRAMEBUFFER,zt);try{let te=R.textures[Wt],ee=te.format,Kt=te.type;if(!wt.textureFormatReadable(ee)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!wt.textureTypeReadable(Kt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}K>=0&&K<=R.width-at&&ht>=0&&ht<=R.height-j&&(R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Wt),k.readPixels(K,ht,at,j,Yt.convert(ee),Yt.convert(Kt),At))}finally{let te=D!==null?rt.get(D).__webglFramebuffer:null;Pt.bindFramebuffer(k.FRAMEBUFFER,te)}}},this.readRenderTargetPixelsAsync=async function(R,K,ht,at,j,At,Nt,Wt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let zt=rt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Nt!==void 0&&(zt=zt[Nt]),zt)if(K>=0&&K<=R.width-at&&ht>=0&&ht<=R.height-j){Pt.bindFramebuffer(k.FRAMEBUFFER,zt);let te=R.textures[Wt],ee=te.format,Kt=te.type;if(!wt.textureFormatReadable(ee))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!wt.textureTypeReadable(Kt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ue=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ue),k.bufferData(k.PIXEL_PACK_BUFFER,At.byteLength,k.STREAM_READ),R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Wt),k.readPixels(K,ht,at,j,Yt.convert(ee),Yt.convert(Kt),0);let ye=D!==null?rt.get(D).__webglFramebuffer:null;Pt.bindFramebuffer(k.FRAMEBUFFER,ye);let ke=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Zm(k,ke,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ue),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,At),k.deleteBuffer(ue),k.deleteSync(ke),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,K=null,ht=0){let at=Math.pow(2,-ht),j=Math.floor(R.image.width*at),At=Math.floor(R.image.height*at),Nt=K!==null?K.x:0,Wt=K!==null?K.y:0;Q.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,ht,0,0,Nt,Wt,j,At),Pt.unbindTexture()};let Vi=k.createFramebuffer(),on=k.createFramebuffer();this.copyTextureToTexture=function(R,K,ht=null,at=null,j=0,At=null){At===null&&(j!==0?(uo("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),At=j,j=0):At=0);let Nt,Wt,zt,te,ee,Kt,ue,ye,ke,Re=R.isCompressedTexture?R.mipmaps[At]:R.image;if(ht!==null)Nt=ht.max.x-ht.min.x,Wt=ht.max.y-ht.min.y,zt=ht.isBox3?ht.max.z-ht.min.z:1,te=ht.min.x,ee=ht.min.y,Kt=ht.isBox3?ht.min.z:0;else{let $n=Math.pow(2,-j);Nt=Math.floor(Re.width*$n),Wt=Math.floor(Re.height*$n),R.isDataArrayTexture?zt=Re.depth:R.isData3DTexture?zt=Math.floor(Re.depth*$n):zt=1,te=0,ee=0,Kt=0}at!==null?(ue=at.x,ye=at.y,ke=at.z):(ue=0,ye=0,ke=0);let le=Yt.convert(K.format),jt=Yt.convert(K.type),He;K.isData3DTexture?(Q.setTexture3D(K,0),He=k.TEXTURE_3D):K.isDataArrayTexture||K.isCompressedArrayTexture?(Q.setTexture2DArray(K,0),He=k.TEXTURE_2D_ARRAY):(Q.setTexture2D(K,0),He=k.TEXTURE_2D),k.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,K.flipY),k.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,K.premultiplyAlpha),k.pixelStorei(k.UNPACK_ALIGNMENT,K.unpackAlignment);let ge=k.getParameter(k.UNPACK_ROW_LENGTH),An=k.getParameter(k.UNPACK_IMAGE_HEIGHT),ws=k.getParameter(k.UNPACK_SKIP_PIXELS),Fn=k.getParameter(k.UNPACK_SKIP_ROWS),Js=k.getParameter(k.UNPACK_SKIP_IMAGES);k.pixelStorei(k.UNPACK_ROW_LENGTH,Re.width),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Re.height),k.pixelStorei(k.UNPACK_SKIP_PIXELS,te),k.pixelStorei(k.UNPACK_SKIP_ROWS,ee),k.pixelStorei(k.UNPACK_SKIP_IMAGES,Kt);let Ve=R.isDataArrayTexture||R.isData3DTexture,On=K.isDataArrayTexture||K.isData3DTexture;if(R.isDepthTexture){let $n=rt.get(R),dn=rt.get(K),pn=rt.get($n.__renderTarget),Ss=rt.get(dn.__renderTarget);Pt.bindFramebuffer(k.READ_FRAMEBUFFER,pn.__webglFramebuffer),Pt.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ss.__webglFramebuffer);for(let ui=0;ui<zt;ui++)Ve&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,rt.get(R).__webglTexture,j,Kt+ui),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,rt.get(K).__webglTexture,At,ke+ui)),k.blitFramebuffer(te,ee,Nt,Wt,ue,ye,Nt,Wt,k.DEPTH_BUFFER_BIT,k.NEAREST);Pt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Pt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(j!==0||R.isRenderTargetTexture||rt.has(R)){let $n=rt.get(R),dn=rt.get(K);Pt.bindFramebuffer(k.READ_FRAMEBUFFER,Vi),Pt.bindFramebuffer(k.DRAW_FRAMEBUFFER,on);for(let pn=0;pn<zt;pn++)Ve?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,$n.__webglTexture,j,Kt+pn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,$n.__webglTexture,j),On?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,dn.__webglTexture,At,ke+pn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,dn.__webglTexture,At),j!==0?k.blitFramebuffer(te,ee,Nt,Wt,ue,ye,Nt,Wt,k.COLOR_BUFFER_BIT,k.NEAREST):On?k.copyTexSubImage3D(He,At,ue,ye,ke+pn,te,ee,Nt,Wt):k.copyTexSubImage2D(He,At,ue,ye,te,ee,Nt,Wt);Pt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Pt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else On?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(He,At,ue,ye,ke,Nt,Wt,zt,le,jt,Re.data):K.isCompressedArrayTexture?k.compressedTexSubImage3D(He,At,ue,ye,ke,Nt,Wt,zt,le,Re.data):k.texSubImage3D(He,At,ue,ye,ke,Nt,Wt,zt,le,jt,Re):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,At,ue,ye,Nt,Wt,le,jt,Re.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,At,ue,ye,Re.width,Re.height,le,Re.data):k.texSubImage2D(k.TEXTURE_2D,At,ue,ye,Nt,Wt,le,jt,Re);k.pixelStorei(k.UNPACK_ROW_LENGTH,ge),k.pixelStorei(k.UNPACK_IMAGE_HEIGHT,An),k.pixelStorei(k.UNPACK_SKIP_PIXELS,ws),k.pixelStorei(k.UNPACK_SKIP_ROWS,Fn),k.pixelStorei(k.UNPACK_SKIP_IMAGES,Js),At===0&&K.generateMipmaps&&k.generateMipmap(He),Pt.unbindTexture()},this.initRenderTarget=function(R){rt.get(R).__webglFramebuffer===void 0&&Q.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Q.setTextureCube(R,0):R.isData3DTexture?Q.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Q.setTexture2DArray(R,0):Q.setTexture2D(R,0),Pt.unbindTexture()},this.resetState=function(){E=0,I=0,D=null,Pt.reset(),Lt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};var Ah=({x:i,y:t,z:e})=>new L(i,t,e),IS=1e-9,Ag=i=>i.joint.length?Ah(i.joint[0].path.end).length():i.length,Rg=(i,t,e=0)=>i.joint.length?Math.max(Math.abs(i.length-t),Math.abs(e)):i.length-t,wr,Cg,Jf,jf=class jf{constructor(t){ml(this,wr);this.free=t.length,this.along=new L(...t.direction);let[e]=t.joint;if(!e)return;Rn(this,wr,Cg).call(this,e);let[n]=t.second;n&&(this.second=new jf({length:0,direction:t.direction,joint:[n],second:[]}),this.beyond=new L,this.inner=new sn)}get isHinge(){return this.curvature>IS}at(t,e,n=null,s=0){this.second&&s!==0?(Rn(this,wr,Jf).call(this,t,e,this.inner),this.second.at(s,this.beyond,n),e.add(this.beyond.sub(this.start).applyQuaternion(this.inner)),n?.premultiply(this.inner)):Rn(this,wr,Jf).call(this,t,e,n)}};wr=new WeakSet,Cg=function(t){this.start=Ah(t.path.end),this.along=Ah(t.path.direction),this.inward=Ah(t.path.inward),this.axis=this.along.clone().cross(this.inward),this.curvature=t.path.curvature,this.anchor=new L(...t.anchor)},Jf=function(t,e,n){if(n?.identity(),!this.start){e.copy(this.along).multiplyScalar(t);return}let s=t-this.free;if(e.copy(this.start),!this.isHinge){e.addScaledVector(this.along,s);return}let r=this.curvature*s;e.addScaledVector(this.along,Math.sin(r)/this.curvature),e.addScaledVector(this.inward,(1-Math.cos(r))/this.curvature),n?.setFromAxisAngle(this.axis,r)};var Co=jf;function LS(i){let t=[];for(let n of i)for(let[s,r]of n.impacts.slice(0,12)){let o=s+n.shift-.008;t.push([o,Math.min(r,s+.12)+n.shift+.02])}t.sort((n,s)=>n[0]-s[0]);let e=[];for(let n of t){let s=e[e.length-1];s&&n[0]<s[1]+2*.12?s[1]=Math.max(s[1],n[1]):e.push([...n])}return e.map(([n,s])=>[n,s,Math.min(1,Math.max(.005,(s-n)/3))])}function Qf(i,t){let e=1;for(let[n,s,r]of i){let o=Math.max(n-t,t-s,0);o<.12&&(e=Math.min(e,r**((1+Math.cos(Math.PI*o/.12))/2)))}return e}function Ig(i){let t=Math.min(...i.map(l=>l.begin+l.shift)),e=Math.max(...i.map(l=>l.end+l.shift)),n=LS(i),s=new Set([t,e]);for(let l=1;l<200;l++)s.add(t+(e-t)*l/200);for(let[l,c]of n)for(let u=0;u<=60;u++)s.add(l-.12+(c-l+2*.12)*u/60),s.add(l+(c-l)*u/60),s.add(l-.12*u/60),s.add(c+.12*u/60);let r=[...s].filter(l=>l>=t&&l<=e).sort((l,c)=>l-c),o=[0];for(let l=1;l<r.length;l++){let c=Math.sqrt(Qf(n,r[l-1])*Qf(n,r[l]));o.push(o[l-1]+(r[l]-r[l-1])/c)}let a=o[o.length-1]||1;return{begin:t,end:e,stretches:n,total:a,paceAt:l=>Qf(n,l),watchedAt:l=>Pg(r,o,l),timeAt:l=>Pg(o,r,l)}}function Pg(i,t,e){let n=0,s=i.length-1;if(!(e>i[0]))return t[0];if(e>=i[s])return t[s];for(;s-n>1;){let r=n+s>>1;i[r]<=e?n=r:s=r}return t[n]+(t[s]-t[n])*(e-i[n])/(i[s]-i[n])}var DS="uplot",US="u-hz",NS="u-vt",FS="u-title",OS="u-wrap",BS="u-under",zS="u-over",kS="u-axis",Tr="u-off",HS="u-select",VS="u-cursor-x",GS="u-cursor-y",WS="u-cursor-pt",XS="u-legend",qS="u-live",YS="u-inline",$S="u-series",ZS="u-marker",Lg="u-label",KS="u-value",Ka="width",Ja="height";var Dg="bottom",Po="left",td="right",vd="#000",Ug=vd+"0",ed="mousemove",Ng="mousedown",nd="mouseup",Fg="mouseenter",Og="mouseleave",Bg="dblclick",JS="resize",jS="scroll",zg="change",Lh="dppxchange",_d="--",Oo=typeof window<"u",ad=Oo?document:null,Lo=Oo?window:null,QS=Oo?navigator:null,Te,Rh;function ld(){let i=devicePixelRatio;Te!=i&&(Te=i,Rh&&hd(zg,Rh,ld),Rh=matchMedia(`(min-resolution: ${Te-.001}dppx) and (max-resolution: ${Te+.001}dppx)`),Ar(zg,Rh,ld),Lo.dispatchEvent(new CustomEvent(Lh)))}function li(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function cd(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ye(i,t,e){i.style[t]=e+"px"}function Oi(i,t,e,n){let s=ad.createElement(i);return t!=null&&li(s,t),e?.insertBefore(s,n),s}function xi(i,t){return Oi("div",i,t)}var kg=new WeakMap;function es(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=kg.get(i);r!=o&&(i.style.transform=r,kg.set(i,r),t<0||e<0||t>n||e>s?li(i,Tr):cd(i,Tr))}var Hg=new WeakMap;function Vg(i,t,e){let n=t+e,s=Hg.get(i);n!=s&&(Hg.set(i,n),i.style.background=t,i.style.borderColor=e)}var Gg=new WeakMap;function Wg(i,t,e,n){let s=t+""+e,r=Gg.get(i);s!=r&&(Gg.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var xd={passive:!0},t1={...xd,capture:!0};function Ar(i,t,e,n){t.addEventListener(i,e,n?t1:xd)}function hd(i,t,e,n){t.removeEventListener(i,e,xd)}Oo&&ld();function Bi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ci((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function _0(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var x0=i=>i!=null,y0=i=>i!=null&&i>0,Nh=_0(x0),e1=_0(y0);function n1(i,t,e,n=0,s=!1){let r=s?e1:Nh,o=s?y0:x0;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Be,l??-Be]}function Fh(i,t,e,n){let s=Yg(i),r=Yg(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?bs:b0,a=s==1?ci:yi,l=r==1?yi:ci,c=a(o(un(i))),u=l(o(un(t))),h=Do(e,c),f=Do(e,u);return e==10&&(c<0&&(h=ze(h,-c)),u<0&&(f=ze(f,-u))),n||e==2?(i=h*s,t=f*r):(i=E0(i,h),t=Oh(t,f)),[i,t]}function yd(i,t,e,n){let s=Fh(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var bd=.1,Xg={mode:3,pad:bd},Qa={pad:0,soft:null,mode:0},i1={min:Qa,max:Qa};function Dh(i,t,e,n){return Bh(e)?qg(i,t,e):(Qa.pad=e,Qa.soft=n?0:null,Qa.mode=n?3:0,qg(i,t,i1))}function Me(i,t){return i??t}function s1(i,t,e){for(t=Me(t,0),e=Me(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function qg(i,t,e){let n=e.min,s=e.max,r=Me(n.pad,0),o=Me(s.pad,0),a=Me(n.hard,-Be),l=Me(s.hard,Be),c=Me(n.soft,Be),u=Me(s.soft,-Be),h=Me(n.mode,0),f=Me(s.mode,0),p=t-i,m=bs(p),v=qn(un(i),un(t)),g=bs(v),d=un(g-m);(p<1e-24||d>10)&&(p=0,(i==0||t==0)&&(p=1e-24,h==2&&c!=Be&&(r=0),f==2&&u!=-Be&&(o=0)));let b=p||v||1e3,S=bs(b),y=Do(10,ci(S)),P=b*(p==0?i==0?.1:1:r),E=ze(E0(i-P,y/10),24),I=i>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Be,D=qn(a,E<I&&i>=I?I:zi(I,E)),M=b*(p==0?t==0?.1:1:o),w=ze(Oh(t+M,y/10),24),T=t<=u&&(f==1||f==3&&w>=u||f==2&&w<=u)?u:-Be,B=zi(l,w>T&&t<=T?T:qn(T,w));return D==B&&D==0&&(B=100),[D,B]}var r1=new Intl.NumberFormat(Oo?QS.language:"en-US"),Md=i=>r1.format(i),hi=Math,Ih=hi.PI,un=hi.abs,ci=hi.floor,hn=hi.round,yi=hi.ceil,zi=hi.min,qn=hi.max,Do=hi.pow,Yg=hi.sign,bs=hi.log10,b0=hi.log2,o1=(i,t=1)=>hi.sinh(i)*t,id=(i,t=1)=>hi.asinh(i/t),Be=1/0;function $g(i){return(bs((i^i>>31)-(i>>31))|0)+1}function ud(i,t,e){return zi(qn(i,t),e)}function M0(i){return typeof i=="function"}function ve(i){return M0(i)?i:()=>i}var a1=()=>{},w0=i=>i,S0=(i,t)=>t,l1=i=>null,Zg=i=>!0,Kg=(i,t)=>i==t,c1=/\.\d*?(?=9{6,}|0{6,})/gm,Rr=i=>{if(A0(i)||Ys.has(i))return i;let t=`${i}`,e=t.match(c1);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Rr(s)}e${r}`}return ze(i,n)};function Sr(i,t){return Rr(ze(Rr(i/t))*t)}function Oh(i,t){return Rr(yi(Rr(i/t))*t)}function E0(i,t){return Rr(ci(Rr(i/t))*t)}function ze(i,t=0){if(A0(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return hn(n)/e}var Ys=new Map;function T0(i){return((""+i).split(".")[1]||"").length}function el(i,t,e,n){let s=[],r=n.map(T0);for(let o=t;o<e;o++){let a=un(o),l=ze(Do(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:ze(u,h);s.push(f),Ys.set(f,h)}}return s}var tl={},wd=[],Uo=[null,null],qs=Array.isArray,A0=Number.isInteger,h1=i=>i===void 0;function Jg(i){return typeof i=="string"}function Bh(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function u1(i){return i!=null&&typeof i=="object"}var f1=Object.getPrototypeOf(Uint8Array),R0="__proto__";function No(i,t=Bh){let e;if(qs(i)){let n=i.find(s=>s!=null);if(qs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=No(i[s],t)}else e=i.slice()}else if(i instanceof f1)e=i.slice();else if(t(i)){e={};for(let n in i)n!=R0&&(e[n]=No(i[n],t))}else e=i;return e}function rn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=R0&&(Bh(i[s])?rn(i[s],No(n[s])):i[s]=No(n[s]))}return i}var d1=0,p1=1,m1=2;function g1(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function v1(i,t){if(y1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return b1(o[0])||(o=x1(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:p1,p=[];for(let m=0;m<u.length;m++){let v=u[m],g=r.get(l[m]);v===null?f!=d1&&(h[g]=v,f==m1&&p.push(g)):h[g]=v}g1(h,p,s),n.push(h)}}return n}var _1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function x1(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function y1(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function b1(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=qn(1,ci((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var C0=["January","February","March","April","May","June","July","August","September","October","November","December"],P0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function I0(i){return i.slice(0,3)}var M1=P0.map(I0),w1=C0.map(I0),S1={MMMM:C0,MMM:w1,WWWW:P0,WWW:M1};function Za(i){return(i<10?"0":"")+i}function E1(i){return(i<10?"00":i<100?"0":"")+i}var T1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>Za(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Za(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>Za(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Za(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Za(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>E1(i.getMilliseconds())};function Sd(i,t){t=t||S1;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?T1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var A1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function R1(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==A1?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var L0=i=>i%1==0,Uh=[1,2,2.5,5],C1=el(10,-32,0,Uh),D0=el(10,0,32,Uh),P1=D0.filter(L0),Er=C1.concat(D0),Ed=`
`,U0="{YYYY}",jg=Ed+U0,N0="{M}/{D}",ja=Ed+N0,Ch=ja+"/{YY}",F0="{aa}",I1="{h}:{mm}",Io=I1+F0,Qg=Ed+Io,t0=":{ss}",Ae=null;function O0(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?el(10,0,3,Uh).filter(L0):el(10,-3,0,Uh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,U0,Ae,Ae,Ae,Ae,Ae,Ae,1],[s*28,"{MMM}",jg,Ae,Ae,Ae,Ae,Ae,1],[s,N0,jg,Ae,Ae,Ae,Ae,Ae,1],[n,"{h}"+F0,Ch,Ae,ja,Ae,Ae,Ae,1],[e,Io,Ch,Ae,ja,Ae,Ae,Ae,1],[t,t0,Ch+" "+Io,Ae,ja+" "+Io,Ae,Qg,Ae,1],[i,t0+".{fff}",Ch+" "+Io,Ae,ja+" "+Io,Ae,Qg,Ae,1]];function u(h){return(f,p,m,v,g,d)=>{let b=[],S=g>=o,y=g>=r&&g<o,P=h(m),E=ze(P*i,3),I=sd(P.getFullYear(),S?0:P.getMonth(),y||S?1:P.getDate()),D=ze(I*i,3);if(y||S){let M=y?g/r:0,w=S?g/o:0,T=E==D?E:ze(sd(I.getFullYear()+w,I.getMonth()+M,1)*i,3),B=new Date(hn(T/i)),H=B.getFullYear(),V=B.getMonth();for(let W=0;T<=v;W++){let X=sd(H+w*W,V+M*W,1),F=X-h(ze(X*i,3));T=ze((+X+F)*i,3),T<=v&&b.push(T)}}else{let M=g>=s?s:g,w=ci(m)-ci(E),T=D+w+Oh(E-D,M);b.push(T);let B=h(T),H=B.getHours()+B.getMinutes()/e+B.getSeconds()/n,V=g/n,W=f.axes[p]._space,X=d/W;for(;T=ze(T+g,i==1?0:3),!(T>v);)if(V>1){let F=ci(ze(H+V,6))%24,nt=h(T).getHours()-F;nt>1&&(nt=-1),T-=nt*n,H=(H+V)%24;let et=b[b.length-1];ze((T-et)/g,3)*X>=.7&&b.push(T)}else b.push(T)}return b}}return[l,c,u]}var[L1,D1,U1]=O0(1),[N1,F1,O1]=O0(.001);el(2,-53,53,[1]);function e0(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function n0(i,t){return(e,n,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,u,h,f,p;return n.map(m=>{let v=i(m),g=v.getFullYear(),d=v.getMonth(),b=v.getDate(),S=v.getHours(),y=v.getMinutes(),P=v.getSeconds(),E=g!=l&&a[2]||d!=c&&a[3]||b!=u&&a[4]||S!=h&&a[5]||y!=f&&a[6]||P!=p&&a[7]||a[1];return l=g,c=d,u=b,h=S,f=y,p=P,E(v)})}}function B1(i,t){let e=Sd(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function sd(i,t,e){return new Date(i,t,e)}function i0(i,t){return t(i)}var z1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function s0(i,t){return(e,n,s,r)=>r==null?_d:t(i(n))}function k1(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function H1(i,t){return i.series[t].fill(i,t)}var V1={show:!0,live:!0,isolate:!1,mount:a1,markers:{show:!0,width:2,stroke:k1,fill:H1,dash:"solid"},idx:null,idxs:null,values:[]};function G1(i,t){let e=i.cursor.points,n=xi(),s=e.size(i,t);Ye(n,Ka,s),Ye(n,Ja,s);let r=s/-2;Ye(n,"marginLeft",r),Ye(n,"marginTop",r);let o=e.width(i,t,s);return o&&Ye(n,"borderWidth",o),n}function W1(i,t){let e=i.series[t].points;return e._fill||e._stroke}function X1(i,t){let e=i.series[t].points;return e._stroke||e._fill}function q1(i,t){return i.series[t].points.size}var rd=[0,0];function Y1(i,t,e){return rd[0]=t,rd[1]=e,rd}function Ph(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function od(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var $1={show:!0,x:!0,y:!0,lock:!1,move:Y1,points:{one:!1,show:G1,size:q1,width:0,stroke:X1,fill:W1},bind:{mousedown:Ph,mouseup:Ph,click:Ph,dblclick:Ph,mousemove:od,mouseleave:od,mouseenter:od},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},B0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Td=rn({},B0,{filter:S0}),z0=rn({},Td,{size:10}),k0=rn({},B0,{show:!1}),Ad='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',H0="bold "+Ad,V0=1.5,r0={show:!0,scale:"x",stroke:vd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:H0,side:2,grid:Td,ticks:z0,border:k0,font:Ad,lineGap:V0,rotate:0},Z1="Value",K1="Time",o0={show:!0,scale:"x",auto:!1,sorted:1,min:Be,max:-Be,idxs:[]};function J1(i,t,e,n,s){return t.map(r=>r==null?"":Md(r))}function j1(i,t,e,n,s,r,o){let a=[],l=Ys.get(s)||0;e=o?e:ze(Oh(e,s),l);for(let c=e;c<=n;c=ze(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function fd(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?bs:b0,u=ci(c(e));s=Do(l,u),l==10&&(s=Er[Bi(s,Er)]);let h=e,f=s*l;l==10&&(f=Er[Bi(f,Er)]);do a.push(h),h=h+s,l==10&&!Ys.has(h)&&(h=ze(h,Ys.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Er[Bi(f,Er)]));while(h<=n);return a}function Q1(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?fd(i,t,qn(l,e),n,s):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?fd(i,t,qn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}var G0=/./,tE=/[12357]/,eE=/[125]/,a0=/1/,dd=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function nE(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?G0:l(7,o)-u>=c?tE:l(5,o)-u>=c?eE:a0;if(h==a0){let f=un(l(1,o)-u);if(f<c)return dd(t.slice().reverse(),a.distr,h,yi(c/f)).reverse()}return dd(t,a.distr,h,1)}function iE(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=un(l(1,o)-l(2,o));return c<a?dd(t.slice().reverse(),3,G0,yi(a/c)).reverse():t}function sE(i,t,e,n){return n==null?_d:t==null?"":Md(t)}var l0={show:!0,scale:"y",stroke:vd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:H0,side:3,grid:Td,ticks:z0,border:k0,font:Ad,lineGap:V0,rotate:0};function rE(i,t){let e=3+(i||1)*2;return ze(e*t,3)}function oE(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=un(o-r),l=i.series[t],c=a/(l.points.space*Te);return n[1]-n[0]<=c}var c0={scale:null,auto:!0,sorted:0,min:Be,max:-Be},W0=(i,t,e,n,s)=>s,h0={show:!0,auto:!0,sorted:0,gaps:W0,alpha:1,facets:[rn({},c0,{scale:"x"}),rn({},c0,{scale:"y"})]},u0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:W0,alpha:1,points:{show:oE,filter:null},values:null,min:Be,max:-Be,idxs:[],path:null,clip:null};function aE(i,t,e,n,s){return e/10}var X0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},lE=rn({},X0,{time:!1,ori:1}),f0={};function q0(i,t){let e=f0[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(f0[i]=e)),e}var Fo=1,pd=2;function Cr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,m=a.width,v=a.height,g=i.valToPosH,d=i.valToPosV;return u.ori==0?e(s,l,c,u,h,g,d,f,p,m,v,kh,Bo,Vh,$0,K0):e(s,l,c,u,h,d,g,p,f,v,m,Hh,zo,Pd,Z0,J0)}function Rd(i,t){let e=0,n=0,s=Me(i.bands,wd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function cE(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ms(i,t,e,n,s,r){return Cr(i,t,(o,a,l,c,u,h,f,p,m,v,g)=>{let d=o.pxRound,b=c.dir*(c.ori==0?1:-1),S=c.ori==0?Bo:zo,y,P;b==1?(y=e,P=n):(y=n,P=e);let E=d(h(a[y],c,v,p)),I=d(f(l[y],u,g,m)),D=d(h(a[P],c,v,p)),M=d(f(r==1?u.max:u.min,u,g,m)),w=new Path2D(s);return S(w,D,M),S(w,E,M),S(w,E,I),w})}function zh(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?Vh:Pd,l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,n,p,n+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function hE(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Cd(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let p=r(i[h]),m=f==h?p:r(i[f]),v=h-s;p=o<=0&&v>=0&&v<l?r(i[v]):p;let d=f+s;m=o>=0&&d>=0&&d<l?r(i[d]):m,m>=p&&a.push([p,m])}return a}function d0(i){return i==0?w0:i==1?hn:t=>Sr(t,i)}function Y0(i){let t=i==0?kh:Hh,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=zi(c,a/2,l/2),u=zi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var kh=(i,t,e)=>{i.moveTo(t,e)},Hh=(i,t,e)=>{i.moveTo(e,t)},Bo=(i,t,e)=>{i.lineTo(t,e)},zo=(i,t,e)=>{i.lineTo(e,t)},Vh=Y0(0),Pd=Y0(1),$0=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Z0=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},K0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},J0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function j0(i){return(t,e,n,s,r)=>Cr(t,e,(o,a,l,c,u,h,f,p,m,v,g)=>{let{pxRound:d,points:b}=o,S,y;c.ori==0?(S=kh,y=$0):(S=Hh,y=Z0);let P=ze(b.width*Te,3),E=(b.size-b.width)/2*Te,I=ze(E*2,3),D=new Path2D,M=new Path2D,{left:w,top:T,width:B,height:H}=t.bbox;Vh(M,w-I,T-I,B+I*2,H+I*2);let V=W=>{if(l[W]!=null){let X=d(h(a[W],c,v,p)),F=d(f(l[W],u,g,m));S(D,X+E,F),y(D,X,F,E,0,Ih*2)}};if(r)r.forEach(V);else for(let W=n;W<=s;W++)V(W);return{stroke:P>0?D:null,fill:D,clip:M,flags:Fo|pd}})}function Q0(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var uE=Q0(Bo),fE=Q0(zo);function tv(i){let t=Me(i?.alignGaps,0);return(e,n,s,r)=>Cr(e,n,(o,a,l,c,u,h,f,p,m,v,g)=>{[s,r]=Nh(l,s,r);let d=o.pxRound,b=H=>d(h(H,c,v,p)),S=H=>d(f(H,u,g,m)),y,P;c.ori==0?(y=Bo,P=uE):(y=zo,P=fE);let E=c.dir*(c.ori==0?1:-1),I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},D=I.stroke,M=!1;if(r-s>=v*4){let H=ft=>e.posToVal(ft,c.key,!0),V=null,W=null,X,F,z,J=b(a[E==1?s:r]),nt=b(a[s]),et=b(a[r]),ct=H(E==1?nt+1:et-1);for(let ft=E==1?s:r;ft>=s&&ft<=r;ft+=E){let yt=a[ft],tt=(E==1?yt<ct:yt>ct)?J:b(yt),$=l[ft];tt==J?$!=null?(F=$,V==null?(y(D,tt,S(F)),X=V=W=F):F<V?V=F:F>W&&(W=F)):$===null&&(M=!0):(V!=null&&P(D,J,S(V),S(W),S(X),S(F)),$!=null?(F=$,y(D,tt,S(F)),V=W=X=F):(V=W=null,$===null&&(M=!0)),J=tt,ct=H(J+E))}V!=null&&V!=W&&z!=J&&P(D,J,S(V),S(W),S(X),S(F))}else for(let H=E==1?s:r;H>=s&&H<=r;H+=E){let V=l[H];V===null?M=!0:V!=null&&y(D,b(a[H]),S(V))}let[T,B]=Rd(e,n);if(o.fill!=null||T!=0){let H=I.fill=new Path2D(D),V=o.fillTo(e,n,o.min,o.max,T),W=S(V),X=b(a[s]),F=b(a[r]);E==-1&&([F,X]=[X,F]),y(H,F,W),y(H,X,W)}if(!o.spanGaps){let H=[];M&&H.push(...Cd(a,l,s,r,E,b,t)),I.gaps=H=o.gaps(e,n,s,r,H),I.clip=zh(H,c.ori,p,m,v,g)}return B!=0&&(I.band=B==2?[Ms(e,n,s,r,D,-1),Ms(e,n,s,r,D,1)]:Ms(e,n,s,r,D,B)),I})}function dE(i){let t=Me(i.align,1),e=Me(i.ascDesc,!1),n=Me(i.alignGaps,0),s=Me(i.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,u,h,f,p,m,v,g,d,b,S)=>{[a,l]=Nh(h,a,l);let y=c.pxRound,{left:P,width:E}=r.bbox,I=nt=>y(m(nt,f,b,g)),D=nt=>y(v(nt,p,S,d)),M=f.ori==0?Bo:zo,w={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},T=w.stroke,B=f.dir*(f.ori==0?1:-1),H=D(h[B==1?a:l]),V=I(u[B==1?a:l]),W=V,X=V;s&&t==-1&&(X=P,M(T,X,H)),M(T,V,H);for(let nt=B==1?a:l;nt>=a&&nt<=l;nt+=B){let et=h[nt];if(et==null)continue;let ct=I(u[nt]),ft=D(et);t==1?M(T,ct,H):M(T,W,ft),M(T,ct,ft),H=ft,W=ct}let F=W;s&&t==1&&(F=P+E,M(T,F,H));let[z,J]=Rd(r,o);if(c.fill!=null||z!=0){let nt=w.fill=new Path2D(T),et=c.fillTo(r,o,c.min,c.max,z),ct=D(et);M(nt,F,ct),M(nt,X,ct)}if(!c.spanGaps){let nt=[];nt.push(...Cd(u,h,a,l,B,I,n));let et=c.width*Te/2,ct=e||t==1?et:-et,ft=e||t==-1?-et:et;nt.forEach(yt=>{yt[0]+=ct,yt[1]+=ft}),w.gaps=nt=c.gaps(r,o,a,l,nt),w.clip=zh(nt,f.ori,g,d,b,S)}return J!=0&&(w.band=J==2?[Ms(r,o,a,l,T,-1),Ms(r,o,a,l,T,1)]:Ms(r,o,a,l,T,J)),w})}function p0(i,t,e,n,s,r,o=Be){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=un(i[l]-i[a]);u<c&&(c=u,o=un(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function pE(i){i=i||tl;let t=Me(i.size,[.6,Be,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ve(s),o=1-t[0],a=Me(t[1],Be),l=Me(t[2],1),c=Me(i.disp,tl),u=Me(i.each,p=>{}),{fill:h,stroke:f}=c;return(p,m,v,g)=>Cr(p,m,(d,b,S,y,P,E,I,D,M,w,T)=>{let B=d.pxRound,H=e,V=n*Te,W=a*Te,X=l*Te,F,z;y.ori==0?[F,z]=r(p,m):[z,F]=r(p,m);let J=y.dir*(y.ori==0?1:-1),nt=y.ori==0?Vh:Pd,et=y.ori==0?u:(N,q,lt,ot,Ut,_t,Ft)=>{u(N,q,lt,Ut,ot,Ft,_t)},ct=Me(p.bands,wd).find(N=>N.series[0]==m),ft=ct!=null?ct.dir:0,yt=d.fillTo(p,m,d.min,d.max,ft),xt=B(I(yt,P,T,M)),tt,$,mt,vt=w,bt=B(d.width*Te),Gt=!1,de=null,k=null,he=null,st=null;h!=null&&(bt==0||f!=null)&&(Gt=!0,de=h.values(p,m,v,g),k=new Map,new Set(de).forEach(N=>{N!=null&&k.set(N,new Path2D)}),bt>0&&(he=f.values(p,m,v,g),st=new Map,new Set(he).forEach(N=>{N!=null&&st.set(N,new Path2D)})));let{x0:wt,size:Pt}=c;if(wt!=null&&Pt!=null){H=1,b=wt.values(p,m,v,g),wt.unit==2&&(b=b.map(lt=>p.posToVal(D+lt*w,y.key,!0)));let N=Pt.values(p,m,v,g);Pt.unit==2?$=N[0]*w:$=E(N[0],y,w,D)-E(0,y,w,D),vt=p0(b,S,E,y,w,D,vt),mt=vt-$+V}else vt=p0(b,S,E,y,w,D,vt),mt=vt*o+V,$=vt-mt;mt<1&&(mt=0),bt>=$/2&&(bt=0),mt<5&&(B=w0);let oe=mt>0,rt=vt-mt-(oe?bt:0);$=B(ud(rt,X,W)),tt=(H==0?$/2:H==J?0:$)-H*J*((H==0?V/2:0)+(oe?bt/2:0));let Q={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},ut=Gt?null:new Path2D,St=null;if(ct!=null)St=p.data[ct.series[1]];else{let{y0:N,y1:q}=c;N!=null&&q!=null&&(S=q.values(p,m,v,g),St=N.values(p,m,v,g))}let C=F*$,x=z*$;for(let N=J==1?v:g;N>=v&&N<=g;N+=J){let q=S[N];if(q==null)continue;if(St!=null){let Ct=St[N]??0;if(q-Ct==0)continue;xt=I(Ct,P,T,M)}let lt=y.distr!=2||c!=null?b[N]:N,ot=E(lt,y,w,D),Ut=I(Me(q,yt),P,T,M),_t=B(ot-tt),Ft=B(qn(Ut,xt)),Bt=B(zi(Ut,xt)),gt=Ft-Bt;if(q!=null){let Ct=q<0?x:C,qt=q<0?C:x;Gt?(bt>0&&he[N]!=null&&nt(st.get(he[N]),_t,Bt+ci(bt/2),$,qn(0,gt-bt),Ct,qt),de[N]!=null&&nt(k.get(de[N]),_t,Bt+ci(bt/2),$,qn(0,gt-bt),Ct,qt)):nt(ut,_t,Bt+ci(bt/2),$,qn(0,gt-bt),Ct,qt),et(p,m,N,_t-bt/2,Bt,$+bt,gt)}}return bt>0?Q.stroke=Gt?st:ut:Gt||(Q._fill=d.width==0?d._fill:d._stroke??d._fill,Q.width=0),Q.fill=Gt?k:ut,Q})}function mE(i,t){let e=Me(t?.alignGaps,0);return(n,s,r,o)=>Cr(n,s,(a,l,c,u,h,f,p,m,v,g,d)=>{[r,o]=Nh(c,r,o);let b=a.pxRound,S=F=>b(f(F,u,g,m)),y=F=>b(p(F,h,d,v)),P,E,I;u.ori==0?(P=kh,I=Bo,E=K0):(P=Hh,I=zo,E=J0);let D=u.dir*(u.ori==0?1:-1),M=S(l[D==1?r:o]),w=M,T=[],B=[];for(let F=D==1?r:o;F>=r&&F<=o;F+=D)if(c[F]!=null){let J=l[F],nt=S(J);T.push(w=nt),B.push(y(c[F]))}let H={stroke:i(T,B,P,I,E,b),fill:null,clip:null,band:null,gaps:null,flags:Fo},V=H.stroke,[W,X]=Rd(n,s);if(a.fill!=null||W!=0){let F=H.fill=new Path2D(V),z=a.fillTo(n,s,a.min,a.max,W),J=y(z);I(F,w,J),I(F,M,J)}if(!a.spanGaps){let F=[];F.push(...Cd(l,c,r,o,D,S,e)),H.gaps=F=a.gaps(n,s,r,o,F),H.clip=zh(F,u.ori,m,v,g,d)}return X!=0&&(H.band=X==2?[Ms(n,s,r,o,V,-1),Ms(n,s,r,o,V,1)]:Ms(n,s,r,o,V,X)),H})}function gE(i){return mE(vE,i)}function vE(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}return a}var md=new Set;function m0(){for(let i of md)i.syncRect(!0)}Oo&&(Ar(JS,Lo,m0),Ar(jS,Lo,m0,!0),Ar(Lh,Lo,()=>{Ke.pxRatio=Te}));var _E=tv(),xE=j0();function g0(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>gd(r,o,t,e))}function yE(i,t){return i.map((e,n)=>n==0?{}:rn({},t,e))}function gd(i,t,e,n){return rn({},t==0?e:n,i)}function ev(i,t,e){return t==null?Uo:[t,e]}var bE=ev;function ME(i,t,e){return t==null?Uo:Dh(t,e,bd,!0)}function nv(i,t,e,n){return t==null?Uo:Fh(t,e,i.scales[n].log,!1)}var wE=nv;function iv(i,t,e,n){return t==null?Uo:yd(t,e,i.scales[n].log,!1)}var SE=iv;function EE(i,t,e,n,s){let r=qn($g(i),$g(t)),o=t-i,a=Bi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Ys.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function v0(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=hn((e=+s)*Te))+"px"),[i,t,e]}function TE(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=ze(t[2]*Te,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Ke(i,t,e){let n={mode:Me(i.mode,1)},s=n.mode;function r(_,A,U,O){let Z=A.valToPct(_);return O+U*(A.dir==-1?1-Z:Z)}function o(_,A,U,O){let Z=A.valToPct(_);return O+U*(A.dir==-1?Z:1-Z)}function a(_,A,U,O){return A.ori==0?r(_,A,U,O):o(_,A,U,O)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=xi(DS);if(i.id!=null&&(c.id=i.id),li(c,i.class),i.title){let _=xi(FS,c);_.textContent=i.title}let u=Oi("canvas"),h=n.ctx=u.getContext("2d"),f=xi(OS,c);Ar("click",f,_=>{_.target===m&&(Ge!=Nr||$e!=Fr)&&Mn.click(n,_)},!0);let p=n.under=xi(BS,f);f.appendChild(u);let m=n.over=xi(zS,f);i=No(i);let v=+Me(i.pxAlign,1),g=d0(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let d=i.ms||.001,b=n.series=s==1?g0(i.series||[],o0,u0,!1):yE(i.series||[null],h0),S=n.axes=g0(i.axes||[],r0,l0,!0),y=n.scales={},P=n.bands=i.bands||[];P.forEach(_=>{_.fill=ve(_.fill||null),_.dir=Me(_.dir,-1)});let E=s==2?b[1].facets[0].scale:b[0].scale,I={axes:r_,series:Js},D=(i.drawOrder||["axes","series"]).map(_=>I[_]);function M(_){let A=_.distr==3?U=>bs(U>0?U:_.clamp(n,U,_.min,_.max,_.key)):_.distr==4?U=>id(U,_.asinh):_.distr==100?U=>_.fwd(U):U=>U;return U=>{let O=A(U),{_min:Z,_max:it}=_,dt=it-Z;return(O-Z)/dt}}function w(_){let A=y[_];if(A==null){let U=(i.scales||tl)[_]||tl;if(U.from!=null){w(U.from);let O=rn({},y[U.from],U,{key:_});O.valToPct=M(O),y[_]=O}else{A=y[_]=rn({},_==E?X0:lE,U),A.key=_;let O=A.time,Z=A.range,it=qs(Z);if((_!=E||s==2&&!O)&&(it&&(Z[0]==null||Z[1]==null)&&(Z={min:Z[0]==null?Xg:{mode:1,hard:Z[0],soft:Z[0]},max:Z[1]==null?Xg:{mode:1,hard:Z[1],soft:Z[1]}},it=!1),!it&&Bh(Z))){let dt=Z;Z=(Mt,It,kt)=>It==null?Uo:Dh(It,kt,dt)}A.range=ve(Z||(O?bE:_==E?A.distr==3?wE:A.distr==4?SE:ev:A.distr==3?nv:A.distr==4?iv:ME)),A.auto=ve(it?!1:A.auto),A.clamp=ve(A.clamp||aE),A._min=A._max=null,A.valToPct=M(A)}}}w("x"),w("y"),s==1&&b.forEach(_=>{w(_.scale)}),S.forEach(_=>{w(_.scale)});for(let _ in i.scales)w(_);let T=y[E],B=T.distr,H,V;T.ori==0?(li(c,US),H=r,V=o):(li(c,NS),H=o,V=r);let W={};for(let _ in y){let A=y[_];(A.min!=null||A.max!=null)&&(W[_]={min:A.min,max:A.max},A.min=A.max=null)}let X=i.tzDate||(_=>new Date(hn(_/d))),F=i.fmtDate||Sd,z=d==1?U1(X):O1(X),J=n0(X,e0(d==1?D1:F1,F)),nt=s0(X,i0(z1,F)),et=[],ct=n.legend=rn({},V1,i.legend),ft=n.cursor=rn({},$1,{drag:{y:s==2}},i.cursor),yt=ct.show,xt=ft.show,tt=ct.markers;ct.idxs=et,tt.width=ve(tt.width),tt.dash=ve(tt.dash),tt.stroke=ve(tt.stroke),tt.fill=ve(tt.fill);let $,mt,vt,bt=[],Gt=[],de,k=!1,he={};if(ct.live){let _=b[1]?b[1].values:null;k=_!=null,de=k?_(n,1,0):{_:0};for(let A in de)he[A]=_d}if(yt)if($=Oi("table",XS,c),vt=Oi("tbody",null,$),ct.mount(n,$),k){mt=Oi("thead",null,$,vt);let _=Oi("tr",null,mt);Oi("th",null,_);for(var st in de)Oi("th",Lg,_).textContent=st}else li($,YS),ct.live&&li($,qS);let wt={show:!0},Pt={show:!1};function oe(_,A){if(A==0&&(k||!ct.live||s==2))return Uo;let U=[],O=Oi("tr",$S,vt,vt.childNodes[A]);li(O,_.class),_.show||li(O,Tr);let Z=Oi("th",null,O);if(tt.show){let Mt=xi(ZS,Z);if(A>0){let It=tt.width(n,A);It&&(Mt.style.border=It+"px "+tt.dash(n,A)+" "+tt.stroke(n,A)),Mt.style.background=tt.fill(n,A)}}let it=xi(Lg,Z);_.label instanceof HTMLElement?it.appendChild(_.label):it.textContent=_.label,A>0&&(tt.show||(it.style.color=_.width>0?tt.stroke(n,A):tt.fill(n,A)),Q("click",Z,Mt=>{if(ft._lock)return;bn(Mt);let It=b.indexOf(_);if((Mt.ctrlKey||Mt.metaKey)!=ct.isolate){let kt=b.some((Ht,Xt)=>Xt>0&&Xt!=It&&Ht.show);b.forEach((Ht,Xt)=>{Xt>0&&Gi(Xt,kt?Xt==It?wt:Pt:wt,!0,en.setSeries)})}else Gi(It,{show:!_.show},!0,en.setSeries)},!1),Yn&&Q(Fg,Z,Mt=>{ft._lock||(bn(Mt),Gi(b.indexOf(_),Br,!0,en.setSeries))},!1));for(var dt in de){let Mt=Oi("td",KS,O);Mt.textContent="--",U.push(Mt)}return[O,U]}let rt=new Map;function Q(_,A,U,O=!0){let Z=rt.get(A)||{},it=ft.bind[_](n,A,U,O);it&&(Ar(_,A,Z[_]=it),rt.set(A,Z))}function ut(_,A,U){let O=rt.get(A)||{};for(let Z in O)(_==null||Z==_)&&(hd(Z,A,O[Z]),delete O[Z]);_==null&&rt.delete(A)}let St=0,C=0,x=0,N=0,q=0,lt=0,ot=q,Ut=lt,_t=x,Ft=N,Bt=0,gt=0,Ct=0,qt=0;n.bbox={};let Yt=!1,Lt=!1,Zt=!1,Y=!1,Tt=!1,Rt=!1;function Vt(_,A,U){(U||_!=n.width||A!=n.height)&&Et(_,A),Ir(!1),Zt=!0,Lt=!0,Lr()}function Et(_,A){n.width=St=x=_,n.height=C=N=A,q=lt=0,Le(),xe();let U=n.bbox;Bt=U.left=Sr(q*Te,.5),gt=U.top=Sr(lt*Te,.5),Ct=U.width=Sr(x*Te,.5),qt=U.height=Sr(N*Te,.5)}let pt=3;function $t(){let _=!1,A=0;for(;!_;){A++;let U=i_(A),O=s_(A);_=A==pt||U&&O,_||(Et(n.width,n.height),Lt=!0)}}function se({width:_,height:A}){Vt(_,A)}n.setSize=se;function Le(){let _=!1,A=!1,U=!1,O=!1;S.forEach((Z,it)=>{if(Z.show&&Z._show){let{side:dt,_size:Mt}=Z,It=dt%2,kt=Z.label!=null?Z.labelSize:0,Ht=Mt+kt;Ht>0&&(It?(x-=Ht,dt==3?(q+=Ht,O=!0):U=!0):(N-=Ht,dt==0?(lt+=Ht,_=!0):A=!0))}}),os[0]=_,os[1]=U,os[2]=A,os[3]=O,x-=Vi[1]+Vi[3],q+=Vi[3],N-=Vi[2]+Vi[0],lt+=Vi[0]}function xe(){let _=q+x,A=lt+N,U=q,O=lt;function Z(it,dt){switch(it){case 1:return _+=dt,_-dt;case 2:return A+=dt,A-dt;case 3:return U-=dt,U+dt;case 0:return O-=dt,O+dt}}S.forEach((it,dt)=>{if(it.show&&it._show){let Mt=it.side;it._pos=Z(Mt,it._size),it.label!=null&&(it._lpos=Z(Mt,it.labelSize))}})}if(ft.dataIdx==null){let _=ft.hover,A=_.skip=new Set(_.skip??[]);A.add(void 0);let U=_.prox=ve(_.prox),O=_.bias??(_.bias=0);ft.dataIdx=(Z,it,dt,Mt)=>{if(it==0)return dt;let It=dt,kt=U(Z,it,dt,Mt)??Be,Ht=kt>=0&&kt<Be,Xt=T.ori==0?x:N,re=ft.left,we=t[0],be=t[it];if(A.has(be[dt])){It=null;let pe=null,ne=null,Jt;if(O==0||O==-1)for(Jt=dt;pe==null&&Jt-- >0;)A.has(be[Jt])||(pe=Jt);if(O==0||O==1)for(Jt=dt;ne==null&&Jt++<be.length;)A.has(be[Jt])||(ne=Jt);if(pe!=null||ne!=null)if(Ht){let Xe=pe==null?-1/0:H(we[pe],T,Xt,0),je=ne==null?1/0:H(we[ne],T,Xt,0),_n=re-Xe,De=je-re;_n<=De?_n<=kt&&(It=pe):De<=kt&&(It=ne)}else It=ne==null?pe:pe==null?ne:dt-pe<=ne-dt?pe:ne}else Ht&&un(re-H(we[dt],T,Xt,0))>kt&&(It=null);return It}}let bn=_=>{ft.event=_};ft.idxs=et,ft._lock=!1;let Fe=ft.points;Fe.show=ve(Fe.show),Fe.size=ve(Fe.size),Fe.stroke=ve(Fe.stroke),Fe.width=ve(Fe.width),Fe.fill=ve(Fe.fill);let ti=n.focus=rn({},i.focus||{alpha:.3},ft.focus),Yn=ti.prox>=0,Hi=Yn&&Fe.one,Nn=[],rs=[],bi=[];function Go(_,A){let U=Fe.show(n,A);if(U instanceof HTMLElement)return li(U,WS),li(U,_.class),es(U,-10,-10,x,N),m.insertBefore(U,Nn[A]),U}function Zs(_,A){if(s==1||A>0){let U=s==1&&y[_.scale].time,O=_.value;_.value=U?Jg(O)?s0(X,i0(O,F)):O||nt:O||sE,_.label=_.label||(U?K1:Z1)}if(Hi||A>0){_.width=_.width==null?1:_.width,_.paths=_.paths||_E||l1,_.fillTo=ve(_.fillTo||cE),_.pxAlign=+Me(_.pxAlign,v),_.pxRound=d0(_.pxAlign),_.stroke=ve(_.stroke||null),_.fill=ve(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let U=rE(qn(1,_.width),1),O=_.points=rn({},{size:U,width:qn(1,U*.2),stroke:_.stroke,space:U*2,paths:xE,_stroke:null,_fill:null},_.points);O.show=ve(O.show),O.filter=ve(O.filter),O.fill=ve(O.fill),O.stroke=ve(O.stroke),O.paths=ve(O.paths),O.pxAlign=_.pxAlign}if(yt){let U=oe(_,A);bt.splice(A,0,U[0]),Gt.splice(A,0,U[1]),ct.values.push(null)}if(xt){et.splice(A,0,null);let U=null;Hi?A==0&&(U=Go(_,A)):A>0&&(U=Go(_,A)),Nn.splice(A,0,U),rs.splice(A,0,0),bi.splice(A,0,0)}vn("addSeries",A)}function cl(_,A){A=A??b.length,_=s==1?gd(_,A,o0,u0):gd(_,A,{},h0),b.splice(A,0,_),Zs(b[A],A)}n.addSeries=cl;function hl(_){if(b.splice(_,1),yt){ct.values.splice(_,1),Gt.splice(_,1);let A=bt.splice(_,1)[0];ut(null,A.firstChild),A.remove()}xt&&(et.splice(_,1),Nn.splice(_,1)[0].remove(),rs.splice(_,1),bi.splice(_,1)),vn("delSeries",_)}n.delSeries=hl;let os=[!1,!1,!1,!1];function ru(_,A){if(_._show=_.show,_.show){let U=_.side%2,O=y[_.scale];O==null&&(_.scale=U?b[1].scale:E,O=y[_.scale]);let Z=O.time;_.size=ve(_.size),_.space=ve(_.space),_.rotate=ve(_.rotate),qs(_.incrs)&&_.incrs.forEach(dt=>{!Ys.has(dt)&&Ys.set(dt,T0(dt))}),_.incrs=ve(_.incrs||(O.distr==2?P1:Z?d==1?L1:N1:Er)),_.splits=ve(_.splits||(Z&&O.distr==1?z:O.distr==3?fd:O.distr==4?Q1:j1)),_.stroke=ve(_.stroke),_.grid.stroke=ve(_.grid.stroke),_.ticks.stroke=ve(_.ticks.stroke),_.border.stroke=ve(_.border.stroke);let it=_.values;_.values=qs(it)&&!qs(it[0])?ve(it):Z?qs(it)?n0(X,e0(it,F)):Jg(it)?B1(X,it):it||J:it||J1,_.filter=ve(_.filter||(O.distr>=3&&O.log==10?nE:O.distr==3&&O.log==2?iE:S0)),_.font=v0(_.font),_.labelFont=v0(_.labelFont),_._size=_.size(n,null,A,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(os[A]=!0,_._el=xi(kS,f))}}function Ks(_,A,U,O){let[Z,it,dt,Mt]=U,It=A%2,kt=0;return It==0&&(Mt||it)&&(kt=A==0&&!Z||A==2&&!dt?hn(r0.size/3):0),It==1&&(Z||dt)&&(kt=A==1&&!it||A==3&&!Mt?hn(l0.size/2):0),kt}let ul=n.padding=(i.padding||[Ks,Ks,Ks,Ks]).map(_=>ve(Me(_,Ks))),Vi=n._padding=ul.map((_,A)=>_(n,A,os,0)),on,R=null,K=null,ht=s==1?b[0].idxs:null,at=null,j=!1;function At(_,A){if(t=_??[],n.data=n._data=t,s==2){on=0;for(let U=1;U<b.length;U++)on+=t[U][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),at=t[0],on=at.length;let U=t;if(B==2){U=t.slice();let O=U[0]=Array(on);for(let Z=0;Z<on;Z++)O[Z]=Z}n._data=t=U}if(Ir(!0),vn("setData"),B==2&&(Zt=!0),A!==!1){let U=T;U.auto(n,j)?Nt():Ts(E,U.min,U.max),Y=Y||ft.left>=0,Rt=!0,Lr()}}n.setData=At;function Nt(){j=!0;let _,A;s==1&&(on>0?(R=ht[0]=0,K=ht[1]=on-1,_=t[0][R],A=t[0][K],B==2?(_=R,A=K):_==A&&(B==3?[_,A]=Fh(_,_,T.log,!1):B==4?[_,A]=yd(_,_,T.log,!1):T.time?A=_+hn(86400/d):[_,A]=Dh(_,A,bd,!0))):(R=ht[0]=_=null,K=ht[1]=A=null)),Ts(E,_,A)}let Wt,zt,te,ee,Kt,ue,ye,ke,Re,le;function jt(_,A,U,O,Z,it){_??(_=Ug),U??(U=wd),O??(O="butt"),Z??(Z=Ug),it??(it="round"),_!=Wt&&(h.strokeStyle=Wt=_),Z!=zt&&(h.fillStyle=zt=Z),A!=te&&(h.lineWidth=te=A),it!=Kt&&(h.lineJoin=Kt=it),O!=ue&&(h.lineCap=ue=O),U!=ee&&h.setLineDash(ee=U)}function He(_,A,U,O){A!=zt&&(h.fillStyle=zt=A),_!=ye&&(h.font=ye=_),U!=ke&&(h.textAlign=ke=U),O!=Re&&(h.textBaseline=Re=O)}function ge(_,A,U,O,Z=0){if(O.length>0&&_.auto(n,j)&&(A==null||A.min==null)){let it=Me(R,0),dt=Me(K,O.length-1),Mt=U.min==null?n1(O,it,dt,Z,_.distr==3):[U.min,U.max];_.min=zi(_.min,U.min=Mt[0]),_.max=qn(_.max,U.max=Mt[1])}}let An={min:null,max:null};function ws(){for(let O in y){let Z=y[O];W[O]==null&&(Z.min==null||W[E]!=null&&Z.auto(n,j))&&(W[O]=An)}for(let O in y){let Z=y[O];W[O]==null&&Z.from!=null&&W[Z.from]!=null&&(W[O]=An)}W[E]!=null&&Ir(!0);let _={};for(let O in W){let Z=W[O];if(Z!=null){let it=_[O]=No(y[O],u1);if(Z.min!=null)rn(it,Z);else if(O!=E||s==2)if(on==0&&it.from==null){let dt=it.range(n,null,null,O);it.min=dt[0],it.max=dt[1]}else it.min=Be,it.max=-Be}}if(on>0){b.forEach((O,Z)=>{if(s==1){let it=O.scale,dt=W[it];if(dt==null)return;let Mt=_[it];if(Z==0){let It=Mt.range(n,Mt.min,Mt.max,it);Mt.min=It[0],Mt.max=It[1],R=Bi(Mt.min,t[0]),K=Bi(Mt.max,t[0]),K-R>1&&(t[0][R]<Mt.min&&R++,t[0][K]>Mt.max&&K--),O.min=at[R],O.max=at[K]}else O.show&&O.auto&&ge(Mt,dt,O,t[Z],O.sorted);O.idxs[0]=R,O.idxs[1]=K}else if(Z>0&&O.show&&O.auto){let[it,dt]=O.facets,Mt=it.scale,It=dt.scale,[kt,Ht]=t[Z],Xt=_[Mt],re=_[It];Xt!=null&&ge(Xt,W[Mt],it,kt,it.sorted),re!=null&&ge(re,W[It],dt,Ht,dt.sorted),O.min=dt.min,O.max=dt.max}});for(let O in _){let Z=_[O],it=W[O];if(Z.from==null&&(it==null||it.min==null)){let dt=Z.range(n,Z.min==Be?null:Z.min,Z.max==-Be?null:Z.max,O);Z.min=dt[0],Z.max=dt[1]}}}for(let O in _){let Z=_[O];if(Z.from!=null){let it=_[Z.from];if(it.min==null)Z.min=Z.max=null;else{let dt=Z.range(n,it.min,it.max,O);Z.min=dt[0],Z.max=dt[1]}}}let A={},U=!1;for(let O in _){let Z=_[O],it=y[O];if(it.min!=Z.min||it.max!=Z.max){it.min=Z.min,it.max=Z.max;let dt=it.distr;it._min=dt==3?bs(it.min):dt==4?id(it.min,it.asinh):dt==100?it.fwd(it.min):it.min,it._max=dt==3?bs(it.max):dt==4?id(it.max,it.asinh):dt==100?it.fwd(it.max):it.max,A[O]=U=!0}}if(U){b.forEach((O,Z)=>{s==2?Z>0&&A.y&&(O._paths=null):A[O.scale]&&(O._paths=null)});for(let O in A)Zt=!0,vn("setScale",O);xt&&ft.left>=0&&(Y=Rt=!0)}for(let O in W)W[O]=null}function Fn(_){let A=ud(R-1,0,on-1),U=ud(K+1,0,on-1);for(;_[A]==null&&A>0;)A--;for(;_[U]==null&&U<on-1;)U++;return[A,U]}function Js(){if(on>0){let _=b.some(A=>A._focus)&&le!=ti.alpha;_&&(h.globalAlpha=le=ti.alpha),b.forEach((A,U)=>{if(U>0&&A.show&&(Ve(U,!1),Ve(U,!0),A._paths==null)){let O=le;le!=A.alpha&&(h.globalAlpha=le=A.alpha);let Z=s==2?[0,t[U][0].length-1]:Fn(t[U]);A._paths=A.paths(n,U,Z[0],Z[1]),le!=O&&(h.globalAlpha=le=O)}}),b.forEach((A,U)=>{if(U>0&&A.show){let O=le;le!=A.alpha&&(h.globalAlpha=le=A.alpha),A._paths!=null&&On(U,!1);{let Z=A._paths!=null?A._paths.gaps:null,it=A.points.show(n,U,R,K,Z),dt=A.points.filter(n,U,it,Z);(it||dt)&&(A.points._paths=A.points.paths(n,U,R,K,dt),On(U,!0))}le!=O&&(h.globalAlpha=le=O),vn("drawSeries",U)}}),_&&(h.globalAlpha=le=1)}}function Ve(_,A){let U=A?b[_].points:b[_];U._stroke=U.stroke(n,_),U._fill=U.fill(n,_)}function On(_,A){let U=A?b[_].points:b[_],{stroke:O,fill:Z,clip:it,flags:dt,_stroke:Mt=U._stroke,_fill:It=U._fill,_width:kt=U.width}=U._paths;kt=ze(kt*Te,3);let Ht=null,Xt=kt%2/2;A&&It==null&&(It=kt>0?"#fff":Mt);let re=U.pxAlign==1&&Xt>0;if(re&&h.translate(Xt,Xt),!A){let we=Bt-kt/2,be=gt-kt/2,pe=Ct+kt,ne=qt+kt;Ht=new Path2D,Ht.rect(we,be,pe,ne)}A?pn(Mt,kt,U.dash,U.cap,It,O,Z,dt,it):$n(_,Mt,kt,U.dash,U.cap,It,O,Z,dt,Ht,it),re&&h.translate(-Xt,-Xt)}function $n(_,A,U,O,Z,it,dt,Mt,It,kt,Ht){let Xt=!1;It!=0&&P.forEach((re,we)=>{if(re.series[0]==_){let be=b[re.series[1]],pe=t[re.series[1]],ne=(be._paths||tl).band;qs(ne)&&(ne=re.dir==1?ne[0]:ne[1]);let Jt,Xe=null;be.show&&ne&&s1(pe,R,K)?(Xe=re.fill(n,we)||it,Jt=be._paths.clip):ne=null,pn(A,U,O,Z,Xe,dt,Mt,It,kt,Ht,Jt,ne),Xt=!0}}),Xt||pn(A,U,O,Z,it,dt,Mt,It,kt,Ht)}let dn=Fo|pd;function pn(_,A,U,O,Z,it,dt,Mt,It,kt,Ht,Xt){jt(_,A,U,O,Z),(It||kt||Xt)&&(h.save(),It&&h.clip(It),kt&&h.clip(kt)),Xt?(Mt&dn)==dn?(h.clip(Xt),Ht&&h.clip(Ht),ui(Z,dt),Ss(_,it,A)):Mt&pd?(ui(Z,dt),h.clip(Xt),Ss(_,it,A)):Mt&Fo&&(h.save(),h.clip(Xt),Ht&&h.clip(Ht),ui(Z,dt),h.restore(),Ss(_,it,A)):(ui(Z,dt),Ss(_,it,A)),(It||kt||Xt)&&h.restore()}function Ss(_,A,U){U>0&&(A instanceof Map?A.forEach((O,Z)=>{h.strokeStyle=Wt=Z,h.stroke(O)}):A!=null&&_&&h.stroke(A))}function ui(_,A){A instanceof Map?A.forEach((U,O)=>{h.fillStyle=zt=O,h.fill(U)}):A!=null&&_&&h.fill(A)}function n_(_,A,U,O){let Z=S[_],it;if(O<=0)it=[0,0];else{let dt=Z._space=Z.space(n,_,A,U,O),Mt=Z._incrs=Z.incrs(n,_,A,U,O,dt);it=EE(A,U,Mt,O,dt)}return Z._found=it}function ou(_,A,U,O,Z,it,dt,Mt,It,kt){let Ht=dt%2/2;v==1&&h.translate(Ht,Ht),jt(Mt,dt,It,kt,Mt),h.beginPath();let Xt,re,we,be,pe=Z+(O==0||O==3?-it:it);U==0?(re=Z,be=pe):(Xt=Z,we=pe);for(let ne=0;ne<_.length;ne++)A[ne]!=null&&(U==0?Xt=we=_[ne]:re=be=_[ne],h.moveTo(Xt,re),h.lineTo(we,be));h.stroke(),v==1&&h.translate(-Ht,-Ht)}function i_(_){let A=!0;return S.forEach((U,O)=>{if(!U.show)return;let Z=y[U.scale];if(Z.min==null){U._show&&(A=!1,U._show=!1,Ir(!1));return}else U._show||(A=!1,U._show=!0,Ir(!1));let it=U.side,dt=it%2,{min:Mt,max:It}=Z,[kt,Ht]=n_(O,Mt,It,dt==0?x:N);if(Ht==0)return;let Xt=Z.distr==2,re=U._splits=U.splits(n,O,Mt,It,kt,Ht,Xt),we=Z.distr==2?re.map(Jt=>at[Jt]):re,be=Z.distr==2?at[re[1]]-at[re[0]]:kt,pe=U._values=U.values(n,U.filter(n,we,O,Ht,be),O,Ht,be);U._rotate=it==2?U.rotate(n,pe,O,Ht):0;let ne=U._size;U._size=yi(U.size(n,pe,O,_)),ne!=null&&U._size!=ne&&(A=!1)}),A}function s_(_){let A=!0;return ul.forEach((U,O)=>{let Z=U(n,O,os,_);Z!=Vi[O]&&(A=!1),Vi[O]=Z}),A}function r_(){for(let _=0;_<S.length;_++){let A=S[_];if(!A.show||!A._show)continue;let U=A.side,O=U%2,Z,it,dt=A.stroke(n,_),Mt=U==0||U==3?-1:1,[It,kt]=A._found;if(A.label!=null){let zn=A.labelGap*Mt,ii=hn((A._lpos+zn)*Te);He(A.labelFont[0],dt,"center",U==2?"top":Dg),h.save(),O==1?(Z=it=0,h.translate(ii,hn(gt+qt/2)),h.rotate((U==3?-Ih:Ih)/2)):(Z=hn(Bt+Ct/2),it=ii);let tr=M0(A.label)?A.label(n,_,It,kt):A.label;h.fillText(tr,Z,it),h.restore()}if(kt==0)continue;let Ht=y[A.scale],Xt=O==0?Ct:qt,re=O==0?Bt:gt,we=A._splits,be=Ht.distr==2?we.map(zn=>at[zn]):we,pe=Ht.distr==2?at[we[1]]-at[we[0]]:It,ne=A.ticks,Jt=A.border,Xe=ne.show?ne.size:0,je=hn(Xe*Te),_n=hn((A.alignTo==2?A._size-Xe-A.gap:A.gap)*Te),De=A._rotate*-Ih/180,Qe=g(A._pos*Te),ei=(je+_n)*Mt,Bn=Qe+ei;it=O==0?Bn:0,Z=O==1?Bn:0;let fi=A.font[0],Mi=A.align==1?Po:A.align==2?td:De>0?Po:De<0?td:O==0?"center":U==3?td:Po,Xi=De||O==1?"middle":U==2?"top":Dg;He(fi,dt,Mi,Xi);let ni=A.font[1]*A.lineGap,di=we.map(zn=>g(a(zn,Ht,Xt,re))),wi=A._values;for(let zn=0;zn<wi.length;zn++){let ii=wi[zn];if(ii!=null){O==0?Z=di[zn]:it=di[zn],ii=""+ii;let tr=ii.indexOf(`
`)==-1?[ii]:ii.split(/\n/gm);for(let kn=0;kn<tr.length;kn++){let hp=tr[kn];De?(h.save(),h.translate(Z,it+kn*ni),h.rotate(De),h.fillText(hp,0,0),h.restore()):h.fillText(hp,Z,it+kn*ni)}}}ne.show&&ou(di,ne.filter(n,be,_,kt,pe),O,U,Qe,je,ze(ne.width*Te,3),ne.stroke(n,_),ne.dash,ne.cap);let qi=A.grid;qi.show&&ou(di,qi.filter(n,be,_,kt,pe),O,O==0?2:1,O==0?gt:Bt,O==0?qt:Ct,ze(qi.width*Te,3),qi.stroke(n,_),qi.dash,qi.cap),Jt.show&&ou([Qe],[1],O==0?1:0,O==0?1:2,O==1?gt:Bt,O==1?qt:Ct,ze(Jt.width*Te,3),Jt.stroke(n,_),Jt.dash,Jt.cap)}vn("drawAxes")}function Ir(_){b.forEach((A,U)=>{U>0&&(A._paths=null,_&&(s==1?(A.min=null,A.max=null):A.facets.forEach(O=>{O.min=null,O.max=null})))})}let fl=!1,au=!1,Wo=[];function o_(){au=!1;for(let _=0;_<Wo.length;_++)vn(...Wo[_]);Wo.length=0}function Lr(){fl||(_1(qd),fl=!0)}function a_(_,A=!1){fl=!0,au=A,_(n),qd(),A&&Wo.length>0&&queueMicrotask(o_)}n.batch=a_;function qd(){if(Yt&&(ws(),Yt=!1),Zt&&($t(),Zt=!1),Lt){if(Ye(p,Po,q),Ye(p,"top",lt),Ye(p,Ka,x),Ye(p,Ja,N),Ye(m,Po,q),Ye(m,"top",lt),Ye(m,Ka,x),Ye(m,Ja,N),Ye(f,Ka,St),Ye(f,Ja,C),u.width=hn(St*Te),u.height=hn(C*Te),S.forEach(({_el:_,_show:A,_size:U,_pos:O,side:Z})=>{if(_!=null)if(A){let it=Z===3||Z===0?U:0,dt=Z%2==1;Ye(_,dt?"left":"top",O-it),Ye(_,dt?"width":"height",U),Ye(_,dt?"top":"left",dt?lt:q),Ye(_,dt?"height":"width",dt?N:x),cd(_,Tr)}else li(_,Tr)}),Wt=zt=te=Kt=ue=ye=ke=Re=ee=null,le=1,Yo(!0),q!=ot||lt!=Ut||x!=_t||N!=Ft){Ir(!1);let _=x/_t,A=N/Ft;if(xt&&!Y&&ft.left>=0){ft.left*=_,ft.top*=A,Dr&&es(Dr,hn(ft.left),0,x,N),Ur&&es(Ur,0,hn(ft.top),x,N);for(let U=0;U<Nn.length;U++){let O=Nn[U];O!=null&&(rs[U]*=_,bi[U]*=A,es(O,yi(rs[U]),yi(bi[U]),x,N))}}if(We.show&&!Tt&&We.left>=0&&We.width>0){We.left*=_,We.width*=_,We.top*=A,We.height*=A;for(let U in du)Ye(Or,U,We[U])}ot=q,Ut=lt,_t=x,Ft=N}vn("setSize"),Lt=!1}St>0&&C>0&&(h.clearRect(0,0,u.width,u.height),vn("drawClear"),D.forEach(_=>_()),vn("draw")),We.show&&Tt&&(dl(We),Tt=!1),xt&&Y&&(Qs(null,!0,!1),Y=!1),ct.show&&ct.live&&Rt&&(uu(),Rt=!1),l||(l=!0,n.status=1,vn("ready")),j=!1,fl=!1}n.redraw=(_,A)=>{Zt=A||!1,_!==!1?Ts(E,T.min,T.max):Lr()};function lu(_,A){let U=y[_];if(U.from==null){if(on==0){let O=U.range(n,A.min,A.max,_);A.min=O[0],A.max=O[1]}if(A.min>A.max){let O=A.min;A.min=A.max,A.max=O}if(on>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;_==E&&U.distr==2&&on>0&&(A.min=Bi(A.min,t[0]),A.max=Bi(A.max,t[0]),A.min==A.max&&A.max++),W[_]=A,Yt=!0,Lr()}}n.setScale=lu;let cu,hu,Dr,Ur,Yd,$d,Nr,Fr,Zd,Kd,Ge,$e,Es=!1,Mn=ft.drag,mn=Mn.x,gn=Mn.y;xt&&(ft.x&&(cu=xi(VS,m)),ft.y&&(hu=xi(GS,m)),T.ori==0?(Dr=cu,Ur=hu):(Dr=hu,Ur=cu),Ge=ft.left,$e=ft.top);let We=n.select=rn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Or=We.show?xi(HS,We.over?m:p):null;function dl(_,A){if(We.show){for(let U in _)We[U]=_[U],U in du&&Ye(Or,U,_[U]);A!==!1&&vn("setSelect")}}n.setSelect=dl;function l_(_){if(b[_].show)yt&&cd(bt[_],Tr);else if(yt&&li(bt[_],Tr),xt){let U=Hi?Nn[0]:Nn[_];U!=null&&es(U,-10,-10,x,N)}}function Ts(_,A,U){lu(_,{min:A,max:U})}function Gi(_,A,U,O){A.focus!=null&&d_(_),A.show!=null&&b.forEach((Z,it)=>{it>0&&(_==it||_==null)&&(Z.show=A.show,l_(it),s==2?(Ts(Z.facets[0].scale,null,null),Ts(Z.facets[1].scale,null,null)):Ts(Z.scale,null,null),Lr())}),U!==!1&&vn("setSeries",_,A),O&&$o("setSeries",n,_,A)}n.setSeries=Gi;function c_(_,A){rn(P[_],A)}function h_(_,A){_.fill=ve(_.fill||null),_.dir=Me(_.dir,-1),A=A??P.length,P.splice(A,0,_)}function u_(_){_==null?P.length=0:P.splice(_,1)}n.addBand=h_,n.setBand=c_,n.delBand=u_;function f_(_,A){b[_].alpha=A,xt&&Nn[_]!=null&&(Nn[_].style.opacity=A),yt&&bt[_]&&(bt[_].style.opacity=A)}let as,As,js,Br={focus:!0};function d_(_){if(_!=js){let A=_==null,U=ti.alpha!=1;b.forEach((O,Z)=>{if(s==1||Z>0){let it=A||Z==0||Z==_;O._focus=A?null:it,U&&f_(Z,it?1:ti.alpha)}}),js=_,U&&Lr()}}yt&&Yn&&Q(Og,$,_=>{ft._lock||(bn(_),js!=null&&Gi(null,Br,!0,en.setSeries))});function Wi(_,A,U){let O=y[A];U&&(_=_/Te-(O.ori==1?lt:q));let Z=x;O.ori==1&&(Z=N,_=Z-_),O.dir==-1&&(_=Z-_);let it=O._min,dt=O._max,Mt=_/Z,It=it+(dt-it)*Mt,kt=O.distr;return kt==3?Do(10,It):kt==4?o1(It,O.asinh):kt==100?O.bwd(It):It}function p_(_,A){let U=Wi(_,E,A);return Bi(U,t[0],R,K)}n.valToIdx=_=>Bi(_,t[0]),n.posToIdx=p_,n.posToVal=Wi,n.valToPos=(_,A,U)=>y[A].ori==0?r(_,y[A],U?Ct:x,U?Bt:0):o(_,y[A],U?qt:N,U?gt:0),n.setCursor=(_,A,U)=>{Ge=_.left,$e=_.top,Qs(null,A,U)};function Jd(_,A){Ye(Or,Po,We.left=_),Ye(Or,Ka,We.width=A)}function jd(_,A){Ye(Or,"top",We.top=_),Ye(Or,Ja,We.height=A)}let Xo=T.ori==0?Jd:jd,qo=T.ori==1?Jd:jd;function m_(){if(yt&&ct.live)for(let _=s==2?1:0;_<b.length;_++){if(_==0&&k)continue;let A=ct.values[_],U=0;for(let O in A)Gt[_][U++].firstChild.nodeValue=A[O]}}function uu(_,A){if(_!=null&&(_.idxs?_.idxs.forEach((U,O)=>{et[O]=U}):h1(_.idx)||et.fill(_.idx),ct.idx=et[0]),yt&&ct.live){for(let U=0;U<b.length;U++)(U>0||s==1&&!k)&&g_(U,et[U]);m_()}Rt=!1,A!==!1&&vn("setLegend")}n.setLegend=uu;function g_(_,A){let U=b[_],O=_==0&&B==2?at:t[_],Z;k?Z=U.values(n,_,A)??he:(Z=U.value(n,A==null?null:O[A],_,A),Z=Z==null?he:{_:Z}),ct.values[_]=Z}function Qs(_,A,U){Zd=Ge,Kd=$e,[Ge,$e]=ft.move(n,Ge,$e),ft.left=Ge,ft.top=$e,xt&&(Dr&&es(Dr,hn(Ge),0,x,N),Ur&&es(Ur,0,hn($e),x,N));let O,Z=R>K;as=Be,As=null;let it=T.ori==0?x:N,dt=T.ori==1?x:N;if(Ge<0||on==0||Z){O=ft.idx=null;for(let Mt=0;Mt<b.length;Mt++){let It=Nn[Mt];It!=null&&es(It,-10,-10,x,N)}Yn&&Gi(null,Br,!0,_==null&&en.setSeries),ct.live&&(et.fill(O),Rt=!0)}else{let Mt,It,kt;s==1&&(Mt=T.ori==0?Ge:$e,It=Wi(Mt,E),O=ft.idx=Bi(It,t[0],R,K),kt=H(t[0][O],T,it,0));let Ht=-10,Xt=-10,re=0,we=0,be=!0,pe="",ne="";for(let Jt=s==2?1:0;Jt<b.length;Jt++){let Xe=b[Jt],je=et[Jt],_n=je==null?null:s==1?t[Jt][je]:t[Jt][1][je],De=ft.dataIdx(n,Jt,O,It),Qe=De==null?null:s==1?t[Jt][De]:t[Jt][1][De];if(Rt=Rt||Qe!=_n||De!=je,et[Jt]=De,Jt>0&&Xe.show){let ei=De==null?-10:De==O?kt:H(s==1?t[0][De]:t[Jt][0][De],T,it,0),Bn=Qe==null?-10:V(Qe,s==1?y[Xe.scale]:y[Xe.facets[1].scale],dt,0);if(Yn&&Qe!=null){let fi=T.ori==1?Ge:$e,Mi=un(ti.dist(n,Jt,De,Bn,fi));if(Mi<as){let Xi=ti.bias;if(Xi!=0){let ni=Wi(fi,Xe.scale),di=Qe>=0?1:-1,wi=ni>=0?1:-1;wi==di&&(wi==1?Xi==1?Qe>=ni:Qe<=ni:Xi==1?Qe<=ni:Qe>=ni)&&(as=Mi,As=Jt)}else as=Mi,As=Jt}}if(Rt||Hi){let fi,Mi;T.ori==0?(fi=ei,Mi=Bn):(fi=Bn,Mi=ei);let Xi,ni,di,wi,qi,zn,ii=!0,tr=Fe.bbox;if(tr!=null){ii=!1;let kn=tr(n,Jt);di=kn.left,wi=kn.top,Xi=kn.width,ni=kn.height}else di=fi,wi=Mi,Xi=ni=Fe.size(n,Jt);if(zn=Fe.fill(n,Jt),qi=Fe.stroke(n,Jt),Hi)Jt==As&&as<=ti.prox&&(Ht=di,Xt=wi,re=Xi,we=ni,be=ii,pe=zn,ne=qi);else{let kn=Nn[Jt];kn!=null&&(rs[Jt]=di,bi[Jt]=wi,Wg(kn,Xi,ni,ii),Vg(kn,zn,qi),es(kn,yi(di),yi(wi),x,N))}}}}if(Hi){let Jt=ti.prox,Xe=js==null?as<=Jt:as>Jt||As!=js;if(Rt||Xe){let je=Nn[0];je!=null&&(rs[0]=Ht,bi[0]=Xt,Wg(je,re,we,be),Vg(je,pe,ne),es(je,yi(Ht),yi(Xt),x,N))}}}if(We.show&&Es)if(_!=null){let[Mt,It]=en.scales,[kt,Ht]=en.match,[Xt,re]=_.cursor.sync.scales,we=_.cursor.drag;if(mn=we._x,gn=we._y,mn||gn){let{left:be,top:pe,width:ne,height:Jt}=_.select,Xe=_.scales[Xt].ori,je=_.posToVal,_n,De,Qe,ei,Bn,fi=Mt!=null&&kt(Mt,Xt),Mi=It!=null&&Ht(It,re);fi&&mn?(Xe==0?(_n=be,De=ne):(_n=pe,De=Jt),Qe=y[Mt],ei=H(je(_n,Xt),Qe,it,0),Bn=H(je(_n+De,Xt),Qe,it,0),Xo(zi(ei,Bn),un(Bn-ei))):Xo(0,it),Mi&&gn?(Xe==1?(_n=be,De=ne):(_n=pe,De=Jt),Qe=y[It],ei=V(je(_n,re),Qe,dt,0),Bn=V(je(_n+De,re),Qe,dt,0),qo(zi(ei,Bn),un(Bn-ei))):qo(0,dt)}else pu()}else{let Mt=un(Zd-Yd),It=un(Kd-$d);if(T.ori==1){let re=Mt;Mt=It,It=re}mn=Mn.x&&Mt>=Mn.dist,gn=Mn.y&&It>=Mn.dist;let kt=Mn.uni;kt!=null?mn&&gn&&(mn=Mt>=kt,gn=It>=kt,!mn&&!gn&&(It>Mt?gn=!0:mn=!0)):Mn.x&&Mn.y&&(mn||gn)&&(mn=gn=!0);let Ht,Xt;mn&&(T.ori==0?(Ht=Nr,Xt=Ge):(Ht=Fr,Xt=$e),Xo(zi(Ht,Xt),un(Xt-Ht)),gn||qo(0,dt)),gn&&(T.ori==1?(Ht=Nr,Xt=Ge):(Ht=Fr,Xt=$e),qo(zi(Ht,Xt),un(Xt-Ht)),mn||Xo(0,it)),!mn&&!gn&&(Xo(0,0),qo(0,0))}if(Mn._x=mn,Mn._y=gn,_==null){if(U){if(cp!=null){let[Mt,It]=en.scales;en.values[0]=Mt!=null?Wi(T.ori==0?Ge:$e,Mt):null,en.values[1]=It!=null?Wi(T.ori==1?Ge:$e,It):null}$o(ed,n,Ge,$e,x,N,O)}if(Yn){let Mt=U&&en.setSeries,It=ti.prox;js==null?as<=It&&Gi(As,Br,!0,Mt):as>It?Gi(null,Br,!0,Mt):As!=js&&Gi(As,Br,!0,Mt)}}Rt&&(ct.idx=O,uu()),A!==!1&&vn("setCursor")}let Rs=null;Object.defineProperty(n,"rect",{get(){return Rs==null&&Yo(!1),Rs}});function Yo(_=!1){_?Rs=null:(Rs=m.getBoundingClientRect(),vn("syncRect",Rs))}function Qd(_,A,U,O,Z,it,dt){ft._lock||Es&&_!=null&&_.movementX==0&&_.movementY==0||(fu(_,A,U,O,Z,it,dt,!1,_!=null),_!=null?Qs(null,!0,!0):Qs(A,!0,!1))}function fu(_,A,U,O,Z,it,dt,Mt,It){if(Rs==null&&Yo(!1),bn(_),_!=null)U=_.clientX-Rs.left,O=_.clientY-Rs.top;else{if(U<0||O<0){Ge=-10,$e=-10;return}let[kt,Ht]=en.scales,Xt=A.cursor.sync,[re,we]=Xt.values,[be,pe]=Xt.scales,[ne,Jt]=en.match,Xe=A.axes[0].side%2==1,je=T.ori==0?x:N,_n=T.ori==1?x:N,De=Xe?it:Z,Qe=Xe?Z:it,ei=Xe?O:U,Bn=Xe?U:O;if(be!=null?U=ne(kt,be)?a(re,y[kt],je,0):-10:U=je*(ei/De),pe!=null?O=Jt(Ht,pe)?a(we,y[Ht],_n,0):-10:O=_n*(Bn/Qe),T.ori==1){let fi=U;U=O,O=fi}}It&&(A==null||A.cursor.event.type==ed)&&((U<=1||U>=x-1)&&(U=Sr(U,x)),(O<=1||O>=N-1)&&(O=Sr(O,N))),Mt?(Yd=U,$d=O,[Nr,Fr]=ft.move(n,U,O)):(Ge=U,$e=O)}let du={width:0,height:0,left:0,top:0};function pu(){dl(du,!1)}let tp,ep,np,ip;function sp(_,A,U,O,Z,it,dt){Es=!0,mn=gn=Mn._x=Mn._y=!1,fu(_,A,U,O,Z,it,dt,!0,!1),_!=null&&(Q(nd,ad,rp,!1),$o(Ng,n,Nr,Fr,x,N,null));let{left:Mt,top:It,width:kt,height:Ht}=We;tp=Mt,ep=It,np=kt,ip=Ht}function rp(_,A,U,O,Z,it,dt){Es=Mn._x=Mn._y=!1,fu(_,A,U,O,Z,it,dt,!1,!0);let{left:Mt,top:It,width:kt,height:Ht}=We,Xt=kt>0||Ht>0,re=tp!=Mt||ep!=It||np!=kt||ip!=Ht;if(Xt&&re&&dl(We),Mn.setScale&&Xt&&re){let we=Mt,be=kt,pe=It,ne=Ht;if(T.ori==1&&(we=It,be=Ht,pe=Mt,ne=kt),mn&&Ts(E,Wi(we,E),Wi(we+be,E)),gn)for(let Jt in y){let Xe=y[Jt];Jt!=E&&Xe.from==null&&Xe.min!=Be&&Ts(Jt,Wi(pe+ne,Jt),Wi(pe,Jt))}pu()}else ft.lock&&(ft._lock=!ft._lock,Qs(A,!0,_!=null));_!=null&&(ut(nd,ad),$o(nd,n,Ge,$e,x,N,null))}function v_(_,A,U,O,Z,it,dt){if(ft._lock)return;bn(_);let Mt=Es;if(Es){let It=!0,kt=!0,Ht=10,Xt,re;T.ori==0?(Xt=mn,re=gn):(Xt=gn,re=mn),Xt&&re&&(It=Ge<=Ht||Ge>=x-Ht,kt=$e<=Ht||$e>=N-Ht),Xt&&It&&(Ge=Ge<Nr?0:x),re&&kt&&($e=$e<Fr?0:N),Qs(null,!0,!0),Es=!1}Ge=-10,$e=-10,et.fill(null),Qs(null,!0,!0),Mt&&(Es=Mt)}function op(_,A,U,O,Z,it,dt){ft._lock||(bn(_),Nt(),pu(),_!=null&&$o(Bg,n,Ge,$e,x,N,null))}function ap(){S.forEach(TE),Vt(n.width,n.height,!0)}Ar(Lh,Lo,ap);let zr={};zr.mousedown=sp,zr.mousemove=Qd,zr.mouseup=rp,zr.dblclick=op,zr.setSeries=(_,A,U,O)=>{let Z=en.match[2];U=Z(n,A,U),U!=-1&&Gi(U,O,!0,!1)},xt&&(Q(Ng,m,sp),Q(ed,m,Qd),Q(Fg,m,_=>{bn(_),Yo(!1)}),Q(Og,m,v_),Q(Bg,m,op),md.add(n),n.syncRect=Yo);let pl=n.hooks=i.hooks||{};function vn(_,A,U){au?Wo.push([_,A,U]):_ in pl&&pl[_].forEach(O=>{O.call(null,n,A,U)})}(i.plugins||[]).forEach(_=>{for(let A in _.hooks)pl[A]=(pl[A]||[]).concat(_.hooks[A])});let lp=(_,A,U)=>U,en=rn({key:null,setSeries:!1,filters:{pub:Zg,sub:Zg},scales:[E,b[1]?b[1].scale:null],match:[Kg,Kg,lp],values:[null,null]},ft.sync);en.match.length==2&&en.match.push(lp),ft.sync=en;let cp=en.key,mu=q0(cp);function $o(_,A,U,O,Z,it,dt){en.filters.pub(_,A,U,O,Z,it,dt)&&mu.pub(_,A,U,O,Z,it,dt)}mu.sub(n);function __(_,A,U,O,Z,it,dt){en.filters.sub(_,A,U,O,Z,it,dt)&&zr[_](null,A,U,O,Z,it,dt)}n.pub=__;function x_(){mu.unsub(n),md.delete(n),rt.clear(),hd(Lh,Lo,ap),c.remove(),$?.remove(),vn("destroy")}n.destroy=x_;function gu(){vn("init",i,t),At(t||i.data,!1),W[E]?lu(E,W[E]):Nt(),Tt=We.show&&(We.width>0||We.height>0),Y=Rt=!0,Vt(i.width,i.height)}return b.forEach(Zs),S.forEach(ru),e?e instanceof HTMLElement?(e.appendChild(c),gu()):e(n,gu):gu(),n}Ke.assign=rn;Ke.fmtNum=Md;Ke.rangeNum=Dh;Ke.rangeLog=Fh;Ke.rangeAsinh=yd;Ke.orient=Cr;Ke.pxRatio=Te;Ke.join=v1;Ke.fmtDate=Sd,Ke.tzDate=R1;Ke.sync=q0;{Ke.addGap=hE,Ke.clipGaps=zh;let i=Ke.paths={points:j0};i.linear=tv,i.stepped=dE,i.bars=pE,i.spline=gE}var sv=112,AE=18,RE=54,CE=1e-5,rv=.1,PE=100,Id=[1e-6,1e6],Ld=14,av=i=>{let t=Math.abs(i);return t<5e-4?"0":i.toFixed(t<1?3:t<10?2:t<100?1:0)},IE=.005,LE=5;function DE(i,[t,e]){let n=r=>Math.floor(Math.log10(r||1)),s=Math.max(0,Math.min(Math.round(-Math.log10(IE*(e-t||1))),LE-1-n(Math.max(Math.abs(t),Math.abs(e)))));return s>6||Math.abs(i)>=1e6?i===0?"0":i.toExponential(3):i.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1")}function lv(i,{onSeek:t=()=>{},onZoom:e=()=>{},onEdit:n=()=>{},onRemove:s=()=>{}}={}){let r=[],o=[],a=null,l={range:null,heights:{}},c=[],u=0,h=null;i.classList.add("plots");function f(T){a=T&&[...new Map(T.map(B=>[String(B),B])).values()],p(o)}function p(T){o=T,r.forEach(({plot:V})=>V.destroy()),i.replaceChildren();let B=Hn(),H=a??er(o);r=Rp(o,H).map(V=>{let W=G("div",{class:"plot-keys"}),X=V.curves.map(ft=>{let yt=document.createElementNS("http://www.w3.org/2000/svg","svg");yt.setAttribute("viewBox","0 0 22 6"),yt.setAttribute("aria-hidden","true");let xt=document.createElementNS("http://www.w3.org/2000/svg","line");Object.entries({x1:0,x2:22,y1:3,y2:3,stroke:ft.colour,"stroke-width":2.4,"stroke-dasharray":ft.dash.join(" ")}).forEach(([$,mt])=>xt.setAttribute($,mt)),yt.append(xt);let tt=G("b");return tt.style.setProperty("--colour",ft.colour),W.append(G("span",{class:"plot-key"},yt,G("span",{},ft.name),tt)),tt}),F=V.unit?`${V.name} [${V.unit}]`:V.name,z=H.findIndex(ft=>V.key===(Array.isArray(ft)?ft.join():ft)),J=(ft,yt,xt)=>G("button",{type:"button",class:"small",title:yt,"aria-label":`${yt}: ${F}`,onclick:xt},ft),nt=G("span",{class:"plot-tools"},...V.own?[J("edit","Change the signals",()=>n(z))]:[],J("×","Remove this plot",()=>s(z))),et=G("div",{class:"plot-canvas"});i.append(G("section",{class:"plot"},G("header",{},G("h3",{},F),nt,W),et));let ct={panel:V,values:X,canvas:et,marker:G("div",{class:"plot-now"}),cross:G("div",{class:"plot-under",hidden:!0}),flag:G("div",{class:"plot-flag",hidden:!0})};return ct.plot=m(ct,B),ct.plot.over.append(ct.marker,ct.cross,ct.flag),ct}),S()}function m({panel:T,canvas:B},H){let V=new Map;for(let $ of T.curves){let mt=V.get($.t)??{times:Array.from($.t,vt=>vt+$.flight.shift),curves:[]};V.set($.t,{...mt,curves:[...mt.curves,$]})}let W=[...V.values()],X=W.map(({times:$,curves:mt})=>[$,...mt.map(vt=>Array.from(vt.values))]),F=X.length===1?X[0]:Ke.join(X),z=W.flatMap(({curves:$})=>$),J={stroke:H.faint,grid:{stroke:H.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},nt=UE(o.flatMap($=>$.impacts.map(([mt,vt])=>[mt+$.shift,vt+$.shift]))),et=Ke.paths.stepped({align:1}),ct=T.words&&(($,mt)=>mt.map(vt=>T.words[vt]??"")),ft={width:Math.max(B.clientWidth,200),height:sv,padding:[6,20,0,0],legend:{show:!1},scales:{x:{time:!1},y:{range:($,mt,vt)=>l.heights[T.key]??NE(mt,vt)}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!0,y:!0,uni:Ld,setScale:!1},bind:{dblclick:()=>()=>d()}},axes:[{...J,size:22,gap:2,space:56,values:($,mt)=>mt.map(vt=>OE(vt,mt))},{...J,size:($,mt)=>Math.max(RE,7*Math.max(0,...(mt??[]).map(vt=>vt.length))+8),gap:4,space:ct?13:AE,values:ct||(($,mt)=>FE(mt))}],series:[{},...z.map($=>({stroke:$.colour,width:1.7,dash:$.dash,spanGaps:!0,points:{show:!1},...$.held?{paths:et}:{}}))],hooks:{drawClear:[$=>{$.ctx.fillStyle=H.force+"2e";for(let[mt,vt]of nt){let bt=$.valToPos(Math.max(mt,$.scales.x.min),"x",!0),Gt=$.valToPos(Math.min(vt,$.scales.x.max),"x",!0);Gt>bt&&$.ctx.fillRect(bt,$.bbox.top,Math.max(Gt-bt,1),$.bbox.height)}}],setSelect:[$=>v($,T.key)],draw:[$=>r.filter(mt=>mt.plot===$).forEach(D)]}},yt=new Ke(ft,F,B),xt=null;yt.over.addEventListener("pointerdown",$=>xt=[$.clientX,$.clientY]),yt.over.addEventListener("pointerup",$=>{xt&&Math.hypot($.clientX-xt[0],$.clientY-xt[1])<5&&t(tt($)),xt=null}),yt.over.addEventListener("pointercancel",()=>xt=null),yt.over.addEventListener("pointermove",$=>$.pointerType!=="touch"&&P(tt($),yt)),yt.over.addEventListener("pointerleave",()=>P(null));let tt=$=>yt.posToVal($.clientX-yt.over.getBoundingClientRect().left,"x");return yt}function v(T,B){let{left:H,top:V,width:W,height:X}=T.select,F=W>=Ld&&W<T.over.clientWidth-1,z=X>=Ld&&X<T.over.clientHeight-1;if(W+X<=0||!(F||z))return;let J=F?[T.posToVal(H,"x"),T.posToVal(H+W,"x")]:l.range,nt=z?{[B]:[T.posToVal(V+X,"y"),T.posToVal(V,"y")]}:{};T.setSelect({left:0,top:0,width:0,height:0},!1),g({range:J,heights:{...l.heights,...nt}})}function g(T){JSON.stringify(T)===JSON.stringify(l)||!ov(T.range)||(c=[...c,l].slice(-PE),l=T,S(),e())}function d(T,B){g({range:T===void 0?null:[T,B],heights:{}})}function b(){return c.length?(l=c.pop(),S(),e(),!0):!1}function S(){let T=o.length?[Math.min(...o.map(V=>V.begin+V.shift)),Math.max(...o.map(V=>V.end+V.shift))]:[0,1],[B,H]=l.range??T;r.forEach(({plot:V})=>V.setScale("x",{min:B,max:H})),E(u)}function y({plot:T,marker:B,cross:H}){let{min:V,max:W}=T.scales.x;for(let[X,F]of[[B,u],[H,h]])X.hidden=F===null||!(F>=V&&F<=W),X.hidden||(X.style.transform=`translateX(${T.valToPos(F,"x")}px)`)}function P(T,B){h=T;for(let H of r){if(H.flag.hidden=T===null||H.plot!==B,H.flag.hidden)continue;H.flag.textContent=`${T.toFixed(4)} s`;let V=B.valToPos(T,"x");H.flag.classList.toggle("left",V>.7*B.over.clientWidth),H.flag.style.transform=`translateX(${V}px)`}i.classList.toggle("pointing",T!==null),I()}function E(T){u=T,I()}let I=()=>r.forEach(D);function D(T){let{panel:B,plot:H,values:V}=T,W=[H.scales.y.min??0,H.scales.y.max??1];y(T),B.curves.forEach((X,F)=>{let z=jo(X,h??u);V[F].textContent=B.words?.[Math.round(z)]??DE(z,W)})}function M(){r.forEach(({plot:T,canvas:B})=>{let H=B.clientWidth;H&&Math.abs(H-T.width)>1&&T.setSize({width:H,height:sv})}),E(u)}let w=new ResizeObserver(M);return w.observe(i),{replace:p,choose:f,show:E,zoom:d,back:b,resize:M,restore(T){ov(T.range)&&(l=T,S(),e())},get wanted(){return a??er(o)},get range(){return l.range},get zoomed(){return l},get canGoBack(){return c.length>0},shown:()=>r.map(({panel:T,plot:B,values:H})=>({name:T.name,unit:T.unit,limits:[B.scales.y.min,B.scales.y.max],ticks:[...B.axes[1]._values??[]],values:Object.fromEntries(T.curves.map((V,W)=>[V.name,H[W].textContent]))})),dispose(){w.disconnect(),r.forEach(({plot:T})=>T.destroy()),i.replaceChildren()}}}function ov(i){if(i===null)return!0;let[t,e]=i;return e-t>=Id[0]&&e-t<=Id[1]&&Math.abs(t)<=Id[1]}function UE(i){let t=[];for(let[e,n]of i.sort((s,r)=>s[0]-r[0])){let s=t[t.length-1];s&&e<=s[1]?s[1]=Math.max(s[1],n):t.push([e,n])}return t}function NE(i,t){if(i==null||t==null)return[0,1];let e=Math.max(Math.abs(i),Math.abs(t));if(e===0)return[-.1,1];t-i<CE*e&&([i,t]=[i-rv*e,t+rv*e]);let n=Math.max(t-i,.001*Math.max(Math.abs(i),Math.abs(t)),1e-6);return[i-.06*n,t+.08*n]}function FE(i){let t=i.length>1?Math.abs(i[1]-i[0]):Math.abs(i[0]),e=Math.floor(Math.log10(t||1)+1e-9),n=Math.max(...i.map(Math.abs));if(e<-6||n>=1e6)return i.map(r=>r===0?"0":r.toExponential(2));let s=Math.max(0,-e);return Math.abs(t*10**s-Math.round(t*10**s))>1e-6&&s++,i.map(r=>r.toFixed(s).replace(/^-(0(\.0*)?)$/,"$1"))}function OE(i,t){let e=0,n=.001*(t.length>1?t[1]-t[0]:1);for(;e<6&&t.some(s=>Math.abs(s-Number(s.toFixed(e)))>n);)e++;return`${i.toFixed(e)} s`}var nl=[1,2,5,10,20,50,100,200],BE=.25,cv=2,hv=i=>!i.arms.some(t=>t.compliant),zE=i=>{if(i>.995)return"real time";let t=1/i;return`1/${t<10?t.toFixed(1).replace(/\.0$/,""):Math.round(t)} of real time`};function Gh({scene:i,plots:t=null,bar:e,readouts:n=null,actions:s={},onRest:r=()=>{}}){let o={t:0,playing:!1,pace:"auto",line:null,flights:[],last:0},a=G("button",{class:"play",type:"button",onclick:()=>o.playing?P():y()}),l=G("button",{type:"button",title:"One instant back (←)","aria-label":"One instant back",onclick:()=>M(-1)},Yi("back")),c=G("button",{type:"button",title:"One instant forward (→)","aria-label":"One instant forward",onclick:()=>M(1)},Yi("forth")),u=G("button",{type:"button",title:"Go to the first touch (T)","aria-label":"Go to the first touch",onclick:w},Yi("touch")),h=G("select",{"aria-label":"Speed",title:"Speed (, and .)",onchange:()=>I(h.value)},G("option",{value:"auto"},"slow at impact"),...nl.map(F=>G("option",{value:String(F)},F===1?"real time":`1/${F}`))),f=G("output",{class:"clock","aria-live":"off"}),p=G("input",{type:"range",min:0,max:1,step:"any",value:0,"aria-label":"Time",oninput:()=>{P(),d(o.line.timeAt(Number(p.value)*o.line.total))}}),m=G("div",{class:"ticks","aria-hidden":"true"}),v=G("div",{class:"track"},m,p),g=G("div",{class:"events"});e.classList.add("player"),e.replaceChildren(G("div",{class:"buttons"},a,l,c,u,h,f),v,g);function d(F){if(!o.line)return;o.t=Math.min(Math.max(F,o.line.begin),o.line.end),i.show(o.t),t?.show(o.t);let z=o.line.watchedAt(o.t)/o.line.total;p.value=z,v.style.setProperty("--share",z),b(),o.playing||r()}function b(){let F=vl(o.flights),z=F===null?"":` · ${o.t>=F?"+":"−"}${Math.abs(1e3*(o.t-F)).toFixed(1)} ms from touch`,J=o.pace==="auto"?o.line.paceAt(o.t):1/Number(o.pace);f.replaceChildren(G("b",{},`${o.t.toFixed(4)} s`),G("span",{},z),G("span",{class:"pace"},zE(J))),p.setAttribute("aria-valuetext",`${o.t.toFixed(3)} s${z}`),n&&V()}function S(F){if(!o.playing)return;let z=Math.min((F-o.last)/1e3,.1);o.last=F;let J=o.line,nt=o.pace==="auto"?J.timeAt(J.watchedAt(o.t)+z):o.t+z/Number(o.pace);d(nt),o.t>=J.end?P():requestAnimationFrame(S)}function y(){!o.line||o.playing||(o.t>=o.line.end-1e-9&&d(o.line.begin),o.playing=!0,o.last=performance.now(),E(),requestAnimationFrame(S))}function P(){o.playing&&setTimeout(r),o.playing=!1,E()}function E(){a.replaceChildren(Yi(o.playing?"pause":"play")),a.setAttribute("aria-label",o.playing?"Pause":"Play"),a.title=o.playing?"Pause (space)":"Play (space)"}function I(F){o.pace=F==="auto"?"auto":String(nl.reduce((z,J)=>Math.abs(J-F)<Math.abs(z-F)?J:z)),h.value=o.pace,b(),r()}function D(F){let z=o.pace==="auto"?F>0?0:1:nl.indexOf(Number(o.pace))+F;I(nl[Math.min(Math.max(z,0),nl.length-1)])}function M(F){P();let z=o.flights[0],J=o.t-z.shift,nt=gl(z.t,J+1e-9),et=z.t[nt]<J-1e-9&&F<0?nt:nt+F;d(z.t[Math.min(Math.max(et,0),z.n-1)]+z.shift)}function w(){P();let F=vl(o.flights);F!==null&&d(F)}function T(){let F=o.line,z=et=>F.watchedAt(et)/F.total;m.replaceChildren(...F.stretches.map(([et,ct])=>{let ft=G("span",{class:"slow"});return ft.style.left=`${100*z(et)}%`,ft.style.width=`${100*Math.max(z(ct)-z(et),.002)}%`,ft}));let J=o.flights.flatMap(et=>et.events.map(ct=>({...ct,t:ct.t+et.shift,flight:et})));J.sort((et,ct)=>et.t-ct.t);for(let et of J){let ct=G("i",{class:et.kind});ct.style.left=`${100*z(et.t)}%`,o.flights.length>1&&(ct.style.background=et.flight.colour),m.append(ct)}let nt=o.flights.length>1;g.replaceChildren(...J.filter(et=>et.kind!=="end"||!nt).slice(0,60).map(et=>{let ct=nt?`${et.flight.label}: ${et.label}`:et.label,ft=G("button",{type:"button",class:`event ${et.kind}`,title:`${et.text}, ${et.t.toFixed(4)} s`,onclick:()=>{P(),d(et.t)}},G("span",{},ct),G("small",{},` ${et.t.toFixed(3)} s`));return nt&&ft.style.setProperty("--colour",et.flight.colour),ft}))}let B=[];function H(){if(!n)return;let F=["speed","acceleration","compression, largest","contact force, sum of all contacts","thrust, all rotors"],z=["m/s","m/s²","mm","N","N"],J=o.flights.length>2,nt=G("table",{class:J?"numbers crowded":"numbers"});o.flights.length>1&&nt.append(G("thead",{},G("tr",{},G("th",{},""),...o.flights.map(ct=>{let ft=G("th",{scope:"col"},ct.label);return ft.style.color=ct.colour,ft}),...J?[]:[G("th",{},"")])));let et=G("tbody");B=F.map((ct,ft)=>{let yt=o.flights.map(()=>G("td")),xt=G("td",{class:"unit"},ft===cv&&o.flights.every(hv)?"":z[ft]);return et.append(G("tr",{},G("th",{scope:"row"},J?`${ct} [${z[ft]}]`:ct),...yt,...J?[]:[xt])),yt}),nt.append(et),n.replaceChildren(nt)}function V(){o.flights.forEach((F,z)=>{let J=Jo(F,o.t),nt=xt=>F.series.find(tt=>tt.panel===xt),et=xt=>nt(xt)?jo({flight:F,values:nt(xt).values},o.t):0,ct=Math.max(0,...F.arms.map((xt,tt)=>xt.compliant?1e3*Rg(xt,J.armLengths[tt],J.bends[tt]):0)),ft=Math.hypot(...[0,1,2].map(xt=>J.contacts.reduce((tt,$)=>tt+($?$.force[xt]:0),0)));[et("Velocity"),et("Acceleration"),ct,ft,J.thrust.reduce((xt,tt)=>xt+tt,0)].forEach((xt,tt)=>B[tt][z].textContent=tt===cv&&hv(F)?"rigid":av(xt))})}function W(F){if(F.ctrlKey||F.metaKey||F.altKey||F.target.closest?.("dialog"))return;let z=F.target.tagName;if(z==="TEXTAREA"||z==="SELECT"||z==="INPUT"&&F.target.type!=="range"||F.target.type==="range"&&F.target!==p)return;let J=F.shiftKey?10:1,nt={" ":()=>o.playing?P():y(),ArrowRight:()=>M(J),ArrowLeft:()=>M(-J),Home:()=>(P(),d(o.line.begin)),End:()=>(P(),d(o.line.end)),",":()=>D(1),".":()=>D(-1),t:w,...s};if(F.key===" "&&z==="BUTTON")return;let et=nt[F.key];!et||!o.line||et()!==!1&&F.preventDefault()}document.addEventListener("keydown",W);function X({keepTime:F=!0}={}){o.flights=i.flights,o.line=Ig(o.flights),H(),t?.replace(o.flights),T();let z=vl(o.flights);d(F?o.t:z===null?o.line.begin:z-BE)}return E(),{replace:X,seek:d,play:y,pause:P,setPace:I,goToTouch:w,get time(){return o.t},get playing(){return o.playing},get pace(){return o.pace},dispose(){P(),document.removeEventListener("keydown",W),e.replaceChildren()}}}var uv={type:"change"},Ud={type:"start"},dv={type:"end"},Wh=new hr,fv=new Zn,kE=Math.cos(70*Xs.DEG2RAD),fn=new L,Qn=2*Math.PI,Ne={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Dd=1e-6,Xh=class extends ka{constructor(t,e=null){super(t,e),this.state=Ne.NONE,this.target=new L,this.cursor=new L,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hs.ROTATE,MIDDLE:Hs.DOLLY,RIGHT:Hs.PAN},this.touches={ONE:Vs.ROTATE,TWO:Vs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new L,this._lastQuaternion=new sn,this._lastTargetPosition=new L,this._quat=new sn().setFromUnitVectors(t.up,new L(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new yo,this._sphericalDelta=new yo,this._scale=1,this._panOffset=new L,this._rotateStart=new Ot,this._rotateEnd=new Ot,this._rotateDelta=new Ot,this._panStart=new Ot,this._panEnd=new Ot,this._panDelta=new Ot,this._dollyStart=new Ot,this._dollyEnd=new Ot,this._dollyDelta=new Ot,this._dollyDirection=new L,this._mouse=new Ot,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=VE.bind(this),this._onPointerDown=HE.bind(this),this._onPointerUp=GE.bind(this),this._onContextMenu=KE.bind(this),this._onMouseWheel=qE.bind(this),this._onKeyDown=YE.bind(this),this._onTouchStart=$E.bind(this),this._onTouchMove=ZE.bind(this),this._onMouseDown=WE.bind(this),this._onMouseMove=XE.bind(this),this._interceptControlDown=JE.bind(this),this._interceptControlUp=jE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(uv),this.update(),this.state=Ne.NONE}update(t=null){let e=this.object.position;fn.copy(e).sub(this.target),fn.applyQuaternion(this._quat),this._spherical.setFromVector3(fn),this.autoRotate&&this.state===Ne.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Qn:n>Math.PI&&(n-=Qn),s<-Math.PI?s+=Qn:s>Math.PI&&(s-=Qn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(fn.setFromSpherical(this._spherical),fn.applyQuaternion(this._quatInverse),e.copy(this.target).add(fn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=fn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new L(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new L(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=fn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Wh.origin.copy(this.object.position),Wh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Wh.direction))<kE?this.object.lookAt(this.target):(fv.setFromNormalAndCoplanarPoint(this.object.up,this.target),Wh.intersectPlane(fv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Dd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Dd||this._lastTargetPosition.distanceToSquared(this.target)>Dd?(this.dispatchEvent(uv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Qn/60*this.autoRotateSpeed*t:Qn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){fn.setFromMatrixColumn(e,0),fn.multiplyScalar(-t),this._panOffset.add(fn)}_panUp(t,e){this.screenSpacePanning===!0?fn.setFromMatrixColumn(e,1):(fn.setFromMatrixColumn(e,0),fn.crossVectors(this.object.up,fn)),fn.multiplyScalar(t),this._panOffset.add(fn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;fn.copy(s).sub(this.target);let r=fn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Qn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Qn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Qn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Ot,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function HE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function VE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function GE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(dv),this.state=Ne.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function WE(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Hs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Ne.DOLLY;break;case Hs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ne.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ne.ROTATE}break;case Hs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Ne.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Ne.PAN}break;default:this.state=Ne.NONE}this.state!==Ne.NONE&&this.dispatchEvent(Ud)}function XE(i){switch(this.state){case Ne.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Ne.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Ne.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function qE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Ne.NONE||(i.preventDefault(),this.dispatchEvent(Ud),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(dv))}function YE(i){this.enabled!==!1&&this._handleKeyDown(i)}function $E(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Vs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Ne.TOUCH_ROTATE;break;case Vs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Ne.TOUCH_PAN;break;default:this.state=Ne.NONE}break;case 2:switch(this.touches.TWO){case Vs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Ne.TOUCH_DOLLY_PAN;break;case Vs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Ne.TOUCH_DOLLY_ROTATE;break;default:this.state=Ne.NONE}break;default:this.state=Ne.NONE}this.state!==Ne.NONE&&this.dispatchEvent(Ud)}function ZE(i){switch(this._trackPointer(i),this.state){case Ne.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Ne.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Ne.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Ne.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Ne.NONE}}function KE(i){this.enabled!==!1&&i.preventDefault()}function JE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function jE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var QE=7,tT=.0022,eT=new L(1,0,0);function Nd(i,t=QE,e=tT){class n extends jn{getPoint(r,o=new L){let a=2*Math.PI*t*r;return o.set(r,i*Math.cos(a),i*Math.sin(a))}}return new Ia(new n,t*14,e,5)}function ki(i,t=14){return new wn(i,i,1,t).rotateZ(-Math.PI/2).translate(.5,0,0)}function qh(i,t){return new Qt(new wn(.0155*i,.0155*i,.006*i,20).rotateZ(Math.PI/2),t)}function il(i,t,e){let n=e.clone().sub(t);return i.position.copy(t),i.quaternion.setFromUnitVectors(new L(1,0,0),n.normalize()),i}function pv(i,t){let e=new Oe;e.setAttribute("position",new Je(Ze(i.vertices),3)),e.setIndex(new Je(new Uint32Array(Ze(i.triangles)),1));let n=e.toNonIndexed();return n.computeVertexNormals(),new Qt(n,t)}var Yh=class{constructor(t,e,n){this.group=new Ee;let s=new vi({color:t,depthTest:!1,transparent:!0,opacity:n});this.shaft=new Qt(ki(e,10),s),this.head=new Qt(new dr(3*e,8*e,14).rotateZ(-Math.PI/2),s),this.size=8*e,this.shaft.renderOrder=this.head.renderOrder=10,this.group.add(this.shaft,this.head),this.along=new L(1,0,0),this.way=new L}show(t,e){let n=this.way.set(...e).length();if(this.group.visible=n>1e-4,!this.group.visible)return;this.group.position.set(...t),this.group.quaternion.setFromUnitVectors(this.along,this.way.divideScalar(n));let s=Math.min(this.size,.6*n);this.head.scale.setScalar(s/this.size),this.head.position.x=n-.5*s,this.shaft.scale.x=Math.max(n-s,1e-5)}hide(){this.group.visible=!1}},tn,gv,vv,_v,sl,xv,yv,bv,Mv,rl=class{constructor(t,e,n){ml(this,tn);this.flight=t,this.group=new Ee;let s=e.opacity<1,r=(v,g={})=>new Ni({color:v,roughness:.55,metalness:.15,transparent:s,opacity:e.opacity,depthWrite:!s,...g}),o=r(n.metal),a=r(n.dark),l=r(e.colour),c=r(n.force,{metalness:.4,roughness:.35}),u=Math.max(...t.arms.map(v=>v.length)),h=u/.19,f=new Qt(new wn(.042*h,.042*h,.026*h,28),a);f.rotation.x=Math.PI/2;let p=new Qt(new wn(.032*h,.04*h,.014*h,28),l);p.rotation.x=Math.PI/2,p.position.z=.02*h;let m=new Qt(new dr(.012*h,.034*h,16).rotateZ(-Math.PI/2),l);m.position.set(.056*h,0,.004*h),this.group.add(f,p,m),this.hulls=t.hull.map(v=>{let g=r(e.colour,{transparent:!0,opacity:.22*e.opacity,depthWrite:!1});if(v.meshes.length){for(let b of v.meshes)this.group.add(pv(b,g));return g}let d=new Qt(new Ca(v.radius,32,20),g);return d.position.set(...v.centre),this.group.add(d),g}),this.arms=t.arms.map(v=>Rn(this,tn,gv).call(this,v,{metal:o,dark:a,own:l,spring:c,paint:r,colours:n,unit:h,faded:s,look:e})),this.springs=t.neighbours.map(({first:v,second:g})=>{let d=new Qt(Nd(.0075*h,16,.0014*h),c);return this.group.add(d),{coil:d,first:v,second:g,from:new L,to:new L,way:new L}}),this.open=new ae(n.force),this.shut=new ae(n.dark),this.rotors=t.rotors.map(v=>Rn(this,tn,vv).call(this,v,{dark:a,paint:r,colours:n,unit:h,look:e})),this.most=t.max_thrust||1,this.bar=1.2*u}connections(){this.group.updateWorldMatrix(!0,!0);let t=this.group.parent?.position??new L,e=s=>s.getWorldPosition(new L).sub(t).toArray(),n=s=>s.localToWorld(new L(1,0,0)).sub(t).toArray();return{springs:this.springs.map(({coil:s})=>[e(s),n(s)]),latches:this.arms.flatMap(({latches:s})=>s??[]).map(({held:s,moving:r,glow:o})=>({held:e(s),moving:e(r),open:o.color.equals(this.open)}))}}ends(){this.group.updateWorldMatrix(!0,!0);let t=this.group.parent?.position??new L,e=n=>this.rotors[this.flight.rotors.findIndex(s=>s.arm===n)]?.rotor;return this.arms.map(({tip:n},s)=>({centre:n.getWorldPosition(new L).sub(t).toArray(),normal:new L(0,0,1).transformDirection(n.matrixWorld).toArray(),thrust:e(s)?new L(0,0,1).transformDirection(e(s).matrixWorld).toArray():null}))}show(t,e=1){this.group.position.set(...t.position);let[n,s,r,o]=t.quaternion;this.group.quaternion.set(s,r,o,n);let a=new Set(t.contacts.filter(Boolean).map(l=>l.part));this.arms.forEach((l,c)=>{let u=e===1?t.armLengths[c]:l.free-mv(e*(l.free-t.armLengths[c]),l),h=e===1?t.bends[c]??0:mv(e*(t.bends[c]??0),l);l.hung?l.path.at(u,l.end.position,l.end.quaternion,h):l.end.position.x=u,l.middle&&l.path.at(u,l.middle.position,l.middle.quaternion);for(let f of l.latches??[]){let p=f.isSecond?-(t.bends[c]??0):l.free-t.armLengths[c];f.glow.color.copy(p>f.travel?this.open:this.shut)}l.shown=u,l.bend=h,l.coil&&(l.coil.scale.x=Math.max(u-l.collar-l.seat,.004)),l.cagePaint.color.set(a.has(c)?this.flight.glow:this.flight.colour)}),this.rotors.forEach((l,c)=>{l.level&&l.rotor.quaternion.copy(l.level.end.quaternion).invert().multiply(l.aim),l.blades.rotation.z=l.spin*t.own*60;let u=this.bar*t.thrust[c]/this.most;l.thrust.visible=u>.001,l.thrust.scale.z=Math.max(u,.001)});for(let{coil:l,first:c,second:u,from:h,to:f,way:p}of this.springs){for(let[v,g]of[[c,h],[u,f]])this.arms[v].path.at(this.arms[v].shown,g,null,this.arms[v].bend);let m=p.copy(f).sub(h).length();l.position.copy(h),l.quaternion.setFromUnitVectors(eT,p.divideScalar(Math.max(m,1e-6))),l.scale.x=Math.max(m,1e-6)}this.hulls.forEach((l,c)=>{l.color.set(a.has(this.arms.length+c)?this.flight.glow:this.flight.colour)})}};tn=new WeakSet,gv=function(t,{metal:e,dark:n,own:s,spring:r,paint:o,colours:a,unit:l,faded:c,look:u}){let h=new Ee;this.group.add(h);let f=Math.atan2(t.direction[1],t.direction[0]),p=new Ee;h.add(p);let m=new Co(t),v={end:p,frame:h,free:t.length,path:m,hung:t.joint.length>0},g=new Ee,d={frame:h,end:p,metal:e,dark:n,own:s,spring:r,unit:l};v.hung?(g.rotation.z=f,t.compliant?m.second?v.middle=Rn(this,tn,bv).call(this,m,d):m.isHinge?Rn(this,tn,yv).call(this,m,d):Object.assign(v,Rn(this,tn,xv).call(this,t,m,d)):Rn(this,tn,sl).call(this,m.start,.007,d),v.latches=t.latch.map(E=>Rn(this,tn,Mv).call(this,E,m,{...d,middle:v.middle,paint:o,colours:a}))):(h.rotation.z=f,Object.assign(v,Rn(this,tn,_v).call(this,t,d))),p.add(g);let b=o(u.colour,{roughness:.4}),S=new Qt(new Pa(t.cage_radius-.0035*l,.0035*l,10,72),b);t.caged&&g.add(S);let y=o(u.colour,{transparent:!0,opacity:.22*u.opacity,depthWrite:!1}),P=new Ee;P.rotation.z=-f;for(let E of t.hulls)P.add(pv(E,y));g.add(P);for(let E=0;E<(t.caged?3:0);E++){let I=new Qt(ki(.0016*l,6),e);I.rotation.z=2*Math.PI*(E+.5)/3,I.scale.x=t.cage_radius-.004*l,g.add(I)}return Object.assign(v,{cagePaint:b,tip:g,seat:P})},vv=function({arm:t,offset:e,axis:n,level:s,spin:r,radius:o},{dark:a,paint:l,colours:c,unit:u,look:h}){let f=new Ee;f.position.set(...e);let p=new sn().setFromUnitVectors(new L(0,0,1),new L(...n));f.quaternion.copy(p),(t<0?this.group:this.arms[t].seat).add(f);let m=new Qt(new wn(.013*u,.013*u,.024*u,18).rotateX(Math.PI/2),a);m.position.z=.008*u;let v=new Qt(new fr(o,36),l(c.thrust,{transparent:!0,opacity:.16*h.opacity,side:Ln,depthWrite:!1}));v.position.z=.022*u;let g=new Qt(new ji(2*o,.012*u,.0015),a);g.position.z=.023*u;let d=new Qt(new wn(.006*u,.006*u,1,12).rotateX(Math.PI/2).translate(0,0,.5),l(c.thrust,{transparent:!0,opacity:.8*h.opacity,emissive:c.thrust,emissiveIntensity:.3}));return d.position.z=.024*u,f.add(m,v,g,d),{rotor:f,blades:g,thrust:d,spin:r,aim:p,level:s?this.arms[t]:null}},_v=function(t,{frame:e,end:n,metal:s,dark:r,own:o,spring:a,unit:l}){let c=t.length-t.shortest,u=.13*t.length;if(!t.compliant){let d=new Qt(ki(.007*l),s);return d.scale.x=t.length,e.add(d),{}}let h=Math.max(.24*t.length,t.shortest-u-.8*c),f=new Qt(ki(.0075*l),s);f.scale.x=t.shortest-.5*u;let p=new Qt(ki(.0045*l),o);p.position.x=-(t.length-h)+.3*u,p.scale.x=-p.position.x;let m=qh(l,r);m.position.x=h;let v=qh(l,r);v.position.x=-u;let g=new Qt(Nd(.0125*l),a);return g.position.x=h,e.add(f,m,g),n.add(p,v),{coil:g,seat:h,collar:u}},sl=function(t,e,{frame:n,metal:s,unit:r}){let o=new Qt(ki(e*r),s);o.scale.x=Math.max(t.length(),1e-6),n.add(il(o,new L,t))},xv=function(t,e,{frame:n,end:s,metal:r,dark:o,own:a,spring:l,unit:c}){let u=.13*e.start.length(),h=e.start.distanceTo(e.anchor),f=t.length-t.shortest,p=il(new Ee,e.anchor,e.start),m=new Qt(ki(.0075*c),r);m.scale.x=Math.max(h-f-.5*u,1e-6);let v=new Qt(Nd(.0125*c),l);p.add(m,qh(c,o),v);let g=new Ee;g.quaternion.copy(p.quaternion);let d=new Qt(ki(.0045*c),a);d.position.x=-h+.3*u,d.scale.x=-d.position.x;let b=qh(c,o);return b.position.x=-u,g.add(d,b),n.add(p),s.add(g),Rn(this,tn,sl).call(this,e.anchor,.0075,{frame:n,metal:r,unit:c}),{coil:v,seat:t.length-h,collar:u}},yv=function(t,{frame:e,end:n,metal:s,dark:r,own:o,unit:a}){Rn(this,tn,sl).call(this,t.anchor,.0075,{frame:e,metal:s,unit:a});let l=new Qt(new wn(.0105*a,.0105*a,.028*a,20),r);l.quaternion.setFromUnitVectors(new L(0,1,0),t.axis.clone().normalize()),l.position.copy(t.anchor),e.add(l);let c=new Qt(ki(.006*a),o),u=t.anchor.clone().sub(t.start);c.scale.x=u.length(),n.add(il(c,new L,u))},bv=function(t,{frame:e,end:n,metal:s,dark:r,own:o,unit:a}){let l=new Ee;e.add(l);let c=(v,g,d)=>{let b=new Qt(new wn(.0105*a,.0105*a,.028*a,20),r);b.quaternion.setFromUnitVectors(new L(0,1,0),v.axis.clone().normalize()),b.position.copy(d),g.add(b)},u=t.second,h=t.isHinge?t.anchor:new L;t.isHinge&&(Rn(this,tn,sl).call(this,t.anchor,.0075,{frame:e,metal:s,unit:a}),c(t,e,t.anchor));let f=t.anchor.clone().sub(t.start),p=u.isHinge?u.anchor.clone().sub(t.start):new L;u.isHinge&&c(u,l,p);let m=(v,g,d)=>{let b=new Qt(ki(.006*a),o);b.scale.x=Math.max(v.distanceTo(g),1e-6),d.add(il(b,v,g))};return t.isHinge?m(f,p,l):m(h,t.start.clone().add(p),e),u.isHinge&&m(new L,p,n),l},Mv=function(t,e,{frame:n,end:s,middle:r,metal:o,unit:a,paint:l,colours:c}){let u=t.joint===1,h=u?e.second:e,[f,p]=u?[r??n,s]:[n,r??s],m=f===n?new L:e.start,v=new L(...t.face),g=.006*a,d=l(c.dark),b=()=>{let M=(h.isHinge?.011:.019)*a,w=new wn(M,M,g,20);return new Qt(w.rotateZ(-Math.PI/2),d)},S=h.along.clone().normalize(),y=new sn().setFromUnitVectors(new L(1,0,0),S),[P,E]=[b(),b()];P.quaternion.copy(y),E.quaternion.copy(y),P.position.copy(v).addScaledVector(S,1.1*g).sub(m),E.position.copy(v).sub(e.start);let I=new Qt(ki(.0028*a,8),o),D=h.anchor.clone().addScaledVector(S,h.isHinge?g:0).sub(m);return I.scale.x=Math.max(D.distanceTo(P.position),1e-6),f.add(P,il(I,D,P.position)),p.add(E),{glow:d,held:P,moving:E,travel:t.travel,isSecond:u}};function mv(i,t){let e=.4*t.free;return Math.min(t.hung?Math.max(i,-e):i,e)}function ol(i){i.traverse(t=>{t.geometry?.dispose();for(let e of[t.material].flat())e?.map?.dispose(),e?.dispose?.()}),i.removeFromParent()}var wv=new yn,$h=new L,ko=class extends Oa{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new me(t,3)),this.setAttribute("uv",new me(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new ks(e,6,1);return this.setAttribute("instanceStart",new Jn(n,3,0)),this.setAttribute("instanceEnd",new Jn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new ks(e,6,1);return this.setAttribute("instanceColorStart",new Jn(n,3,0)),this.setAttribute("instanceColorEnd",new Jn(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new La(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new yn);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),wv.setFromBufferAttribute(e),this.boundingBox.union(wv))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Di),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)$h.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared($h)),$h.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared($h));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Dt.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ot(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Xn.line={uniforms:Ya.merge([Dt.common,Dt.fog,Dt.line]),vertexShader:`
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
		`};var $s=class extends oi{constructor(t){super({type:"LineMaterial",uniforms:Ya.clone(Xn.line.uniforms),vertexShader:Xn.line.vertexShader,fragmentShader:Xn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Fd=new Ie,Sv=new L,Ev=new L,Sn=new Ie,En=new Ie,ns=new Ie,Od=new L,Bd=new Ue,Tn=new Ba,Tv=new L,Zh=new yn,Kh=new Di,is=new Ie,ss,Pr;function Av(i,t,e){return is.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),is.multiplyScalar(1/is.w),is.x=Pr/e.width,is.y=Pr/e.height,is.applyMatrix4(i.projectionMatrixInverse),is.multiplyScalar(1/is.w),Math.abs(Math.max(is.x,is.y))}function nT(i,t){let e=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Tn.start.fromBufferAttribute(s,a),Tn.end.fromBufferAttribute(r,a),Tn.applyMatrix4(e);let c=new L,u=new L;ss.distanceSqToSegment(Tn.start,Tn.end,u,c),u.distanceTo(c)<Pr*.5&&t.push({point:u,pointOnLine:c,distance:ss.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function iT(i,t,e){let n=t.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-t.near;ss.at(1,ns),ns.w=1,ns.applyMatrix4(t.matrixWorldInverse),ns.applyMatrix4(n),ns.multiplyScalar(1/ns.w),ns.x*=r.x/2,ns.y*=r.y/2,ns.z=0,Od.copy(ns),Bd.multiplyMatrices(t.matrixWorldInverse,o);for(let f=0,p=u;f<p;f++){if(Sn.fromBufferAttribute(l,f),En.fromBufferAttribute(c,f),Sn.w=1,En.w=1,Sn.applyMatrix4(Bd),En.applyMatrix4(Bd),Sn.z>h&&En.z>h)continue;if(Sn.z>h){let S=Sn.z-En.z,y=(Sn.z-h)/S;Sn.lerp(En,y)}else if(En.z>h){let S=En.z-Sn.z,y=(En.z-h)/S;En.lerp(Sn,y)}Sn.applyMatrix4(n),En.applyMatrix4(n),Sn.multiplyScalar(1/Sn.w),En.multiplyScalar(1/En.w),Sn.x*=r.x/2,Sn.y*=r.y/2,En.x*=r.x/2,En.y*=r.y/2,Tn.start.copy(Sn),Tn.start.z=0,Tn.end.copy(En),Tn.end.z=0;let v=Tn.closestPointToPointParameter(Od,!0);Tn.at(v,Tv);let g=Xs.lerp(Sn.z,En.z,v),d=g>=-1&&g<=1,b=Od.distanceTo(Tv)<Pr*.5;if(d&&b){Tn.start.fromBufferAttribute(l,f),Tn.end.fromBufferAttribute(c,f),Tn.start.applyMatrix4(o),Tn.end.applyMatrix4(o);let S=new L,y=new L;ss.distanceSqToSegment(Tn.start,Tn.end,y,S),e.push({point:y,pointOnLine:S,distance:ss.origin.distanceTo(y),object:i,face:null,faceIndex:f,uv:null,uv1:null})}}}var Jh=class extends Qt{constructor(t=new ko,e=new $s({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)Sv.fromBufferAttribute(e,o),Ev.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Sv.distanceTo(Ev);let r=new ks(s,2,1);return t.setAttribute("instanceDistanceStart",new Jn(r,1,0)),t.setAttribute("instanceDistanceEnd",new Jn(r,1,1)),this}raycast(t,e){let n=this.material.worldUnits,s=t.camera;s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;ss=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Pr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Kh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Pr*.5;else{let h=Math.max(s.near,Kh.distanceToPoint(ss.origin));c=Av(s,h,l.resolution)}if(Kh.radius+=c,ss.intersectsSphere(Kh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Zh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Pr*.5;else{let h=Math.max(s.near,Zh.distanceToPoint(ss.origin));u=Av(s,h,l.resolution)}Zh.expandByScalar(u),ss.intersectsBox(Zh)!==!1&&(n?nT(this,e):iT(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(Fd),this.material.uniforms.resolution.value.set(Fd.z,Fd.w))}};var Ho=class extends ko{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,n=new Float32Array(2*e);for(let s=0;s<e;s+=3)n[2*s]=t[s],n[2*s+1]=t[s+1],n[2*s+2]=t[s+2],n[2*s+3]=t[s+3],n[2*s+4]=t[s+4],n[2*s+5]=t[s+5];return super.setPositions(n),this}setColors(t){let e=t.length-3,n=new Float32Array(2*e);for(let s=0;s<e;s+=3)n[2*s]=t[s],n[2*s+1]=t[s+1],n[2*s+2]=t[s+2],n[2*s+3]=t[s+3],n[2*s+4]=t[s+4],n[2*s+5]=t[s+5];return super.setColors(n),this}setFromPoints(t){let e=t.length-1,n=new Float32Array(6*e);for(let s=0;s<e;s++)n[6*s]=t[s].x,n[6*s+1]=t[s].y,n[6*s+2]=t[s].z||0,n[6*s+3]=t[s+1].x,n[6*s+4]=t[s+1].y,n[6*s+5]=t[s+1].z||0;return super.setPositions(n),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var jh=class extends Jh{constructor(t=new Ho,e=new $s({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};function Rv(i,t=Math.PI/3){let e=Math.cos(t),n=(1+1e-10)*100,s=[new L,new L,new L],r=new L,o=new L,a=new L,l=new L;function c(v){let g=~~(v.x*n),d=~~(v.y*n),b=~~(v.z*n);return`${g},${d},${b}`}let u=i.index?i.toNonIndexed():i,h=u.attributes.position,f={};for(let v=0,g=h.count/3;v<g;v++){let d=3*v,b=s[0].fromBufferAttribute(h,d+0),S=s[1].fromBufferAttribute(h,d+1),y=s[2].fromBufferAttribute(h,d+2);r.subVectors(y,S),o.subVectors(b,S);let P=new L().crossVectors(r,o).normalize();for(let E=0;E<3;E++){let I=s[E],D=c(I);D in f||(f[D]=[]),f[D].push(P)}}let p=new Float32Array(h.count*3),m=new Je(p,3,!1);for(let v=0,g=h.count/3;v<g;v++){let d=3*v,b=s[0].fromBufferAttribute(h,d+0),S=s[1].fromBufferAttribute(h,d+1),y=s[2].fromBufferAttribute(h,d+2);r.subVectors(y,S),o.subVectors(b,S),a.crossVectors(r,o).normalize();for(let P=0;P<3;P++){let E=s[P],I=c(E),D=f[I];l.set(0,0,0);for(let M=0,w=D.length;M<w;M++){let T=D[M];a.dot(T)>e&&l.add(T)}l.normalize(),m.setXYZ(d+P,l.x,l.y,l.z)}}return u.setAttribute("normal",m),u}var sT=.6,rT=25,Cv=.004,Un=i=>new L(...i);function Pv(i,t,e,n,s,r){let o=[],a=t.length(),l=e.length(),c=t.clone().normalize(),u=e.clone().normalize(),h=(v,g)=>o.push(...v.toArray(),...g.toArray()),f=(v,g)=>i.clone().addScaledVector(c,v).addScaledVector(u,g),p=v=>{let g=[-v,v];for(let d=Math.ceil(-v/n)*n;d<v;d+=n)g.push(d);return g};for(let v of p(a))h(f(v,-l),f(v,l));for(let v of p(l))h(f(-a,v),f(a,v));let m=new Oe;return m.setAttribute("position",new me(o,3)),new xo(m,new vs({color:s,transparent:!0,opacity:r,depthWrite:!1}))}function Qh(i,t,e,n,s=0){let r=Un(i.across),o=Un(i.along),a=Un(i.normal),l=new ji(2*r.length(),2*o.length(),t),c=new Ni({color:e,transparent:!0,opacity:n,roughness:.9,depthWrite:!1,side:Ln}),u=new Qt(l,c),h=new Ue().makeBasis(r.normalize(),o.normalize(),a);return u.quaternion.setFromRotationMatrix(h),u.position.copy(Un(i.centre)).addScaledVector(a,-s-.5*t),u.renderOrder=1,u}function oT(i,t){let e=new Oe;e.setAttribute("position",new Je(Ze(i.vertices),3)),e.setAttribute("normal",new Je(Ze(i.normals),3)),e.setIndex(Array.from(Ze(i.triangles)));let n=new Qt(e,new vi({colorWrite:!1,transparent:!0,side:Ln})),s=new Qt(e,new Ni({color:t.wall,transparent:!0,opacity:.55,roughness:.85,depthWrite:!1,side:Ln}));return[n,s].forEach((r,o)=>r.renderOrder=3+o),new Ee().add(n,s)}function aT(i,t,e){let n=new Oe;n.setAttribute("position",new Je(Ze(i.vertices),3)),n.setIndex(Array.from(Ze(i.triangles)));let s=Rv(n,sT),r=e===null?[]:[new Zn(new L(0,0,1),-e)],o=new Qt(s,new vi({colorWrite:!1,transparent:!0,clippingPlanes:r})),a=new Qt(s,new Ni({color:t.wall,transparent:!0,opacity:.72,roughness:.85,depthWrite:!1,clippingPlanes:r,stencilWrite:!0,stencilRef:1,stencilFunc:Tf,stencilZPass:Ef})),l=new xo(new Ea(n,rT),new vs({color:t.ink,transparent:!0,opacity:.35,depthWrite:!1,clippingPlanes:r}));return n.dispose(),[o,a,l].forEach((c,u)=>c.renderOrder=3+u),new Ee().add(o,a,l)}function zd(i,t,e=null){let n=new Ee;if(i.kind==="mesh")return i.normals?n.add(oT(i,t)):aT(i,t,e);let s=Un(i.centre),r=Un(i.normal).multiplyScalar(.001),o=(a,l,c)=>Pv(s.clone().add(r),Un(i.across),Un(i.along),c,l,a);return i.kind==="ground"?n.add(Qh(i,.004,t.ground,.35),o(.55,t.faint,.25)):i.kind==="mat"?(n.add(Qh(i,i.thickness,t.mat,.2),o(.55,t.mat,.1)),n.add(Qh(i,.04,t.wall,.25,i.thickness))):n.add(Qh(i,.04,t.wall,.22),o(.5,t.wall,.1)),n}var tu=class{constructor(t,e,n,s){if(this.origin=Un(t.origin),this.body=new Ee().add(...e.map(o=>zd(o,n,s))),this.group=new Ee().add(this.body),this.turn=new sn,this.rod=null,!t.rod.length)return;this.pivot=Un(t.rod);let r=new wn(Cv,Cv,1,10).translate(0,.5,0);this.rod=new Qt(r,new Ni({color:n.metal,roughness:.6})),this.rod.position.copy(this.pivot),this.group.add(this.rod)}show(t){let[e,n,s,r]=t.quaternion;if(this.turn.set(n,s,r,e),this.body.quaternion.copy(this.turn),this.body.position.copy(this.origin).negate().applyQuaternion(this.turn).add(Un(t.position)),!this.rod)return;let o=Un(t.position).sub(this.pivot);this.rod.scale.y=o.length(),this.rod.quaternion.setFromUnitVectors(new L(0,1,0),o.normalize())}};function Iv(i,t){let e=i.getSize(new L),n=i.getCenter(new L);n.z=i.min.z;let s=r=>Math.max(.8,Math.ceil((.5*r+.4)*4)/4);return Pv(n,new L(s(e.x),0,0),new L(0,s(e.y),0),.25,t.faint,.35)}function Lv(i,t){let e=Un(i.guide).normalize(),n=[];for(let c=0;c<i.n;c+=Math.max(1,Math.floor(i.n/200)))n.push(e.dot(Un(i.position.subarray(3*c,3*c+3))));let s=Math.min(...n)-.5,r=Math.max(...n)+.5-s,o=new wn(.008,.008,r,12).rotateZ(-Math.PI/2).translate(r/2,0,0),a=new Qt(o,new Ni({color:t.metal,transparent:!0,opacity:.5}));a.quaternion.setFromUnitVectors(new L(1,0,0),e);let l=Un(i.position.subarray(0,3));return a.position.copy(l).addScaledVector(e,s-e.dot(l)),a}var eu=class{constructor(t,e,n){let s=t.impacts,r=s.length?s[0][0]:1/0,o=[],a=[],l=new ae(e.before),c=new ae(e.force),u=new ae(t.colour);this.times=[];let h=-1/0;for(let p=0;p<t.n;p++){let m=t.t[p];if(m-h<.001&&p<t.n-1)continue;h=m,this.times.push(m),o.push(...t.position.subarray(3*p,3*p+3));let v=s.some(([g,d])=>m>=g&&m<=d);a.push(...(v?c:m<r?l:u).toArray())}let f=(p,m)=>{let v=new Ho;v.setPositions(o),v.setColors(a);let g=new $s({vertexColors:!0,linewidth:m,transparent:!0,opacity:p,depthWrite:!1});g.resolution.copy(n);let d=new jh(v,g);return d.computeLineDistances(),d};this.whole=f(.3,1.2),this.flown=f(1,2.6),this.group=new Ee,this.group.add(this.whole,this.flown)}show(t){let e=0,n=this.times.length;for(;e<n;){let s=e+n>>1;this.times[s]<=t?e=s+1:n=s}this.flown.geometry.instanceCount=Math.max(e-1,0)}resize(t){this.whole.material.resolution.copy(t),this.flown.material.resolution.copy(t)}},nu=class{constructor(t,e,n){this.level=e,this.group=new Ee,this.paths=t.arms.map(a=>new Co(a));let s=()=>new vi({color:"#000000",transparent:!0,opacity:.16,depthWrite:!1}),r=a=>{let l=new Qt(new fr(a,36),s());return l.renderOrder=2,this.group.add(l),l};this.body=r(.045),this.cages=t.arms.map(a=>r(a.cage_radius));let o=new Oe;o.setAttribute("position",new me([0,0,0,0,0,1],3)),this.plumb=new ur(o,new vs({color:n.faint,transparent:!0,opacity:.6})),this.group.add(this.plumb),this.turn=new sn,this.at=new L}show(t){let[e,n,s,r]=t.quaternion;this.turn.set(n,s,r,e);let o=this.level+.003;this.body.position.set(t.position[0],t.position[1],o),this.cages.forEach((a,l)=>{this.paths[l].at(t.armLengths[l],this.at,null,t.bends[l]),this.at.applyQuaternion(this.turn),a.position.set(t.position[0]+this.at.x,t.position[1]+this.at.y,o)}),this.plumb.position.set(t.position[0],t.position[1],o),this.plumb.scale.z=Math.max(t.position[2]-o,1e-4)}};function lT(i,t){let e=document.createElement("canvas");e.width=128,e.height=64;let n=e.getContext("2d");n.font="600 40px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle=t,n.fillText(i,64,32);let s=new Ma(e);s.colorSpace=Gn;let r=new ba(new vo({map:s,depthTest:!1,transparent:!0}));return r.scale.set(.9,.45,1),r}function Dv(i){let t=new Ee;return Object.entries({"x N":[1,0,0],"y W":[0,1,0],"z up":[0,0,1]}).forEach(([n,s])=>{let r=new za(Un(s),new L,1,i.ink,.28,.16),o=lT(n,i.ink);o.position.set(...s).multiplyScalar(1.38),t.add(r,o)}),t}var cT=(i,t)=>i.map((e,n)=>e+t[n]),Uv=(i,t)=>i.kind==="mesh"?{...i,moved:t}:{...i,centre:cT(i.centre,t)},al=(i,t)=>i.reduce((e,n,s)=>e+n*t[s],0);function Nv(i){let t=new Map;for(let e of i){let n=e.kind!=="mesh",s=n?[e.kind,e.thickness,...e.normal,al(e.normal,e.centre)].map(o=>o.toFixed?o.toFixed(4):o).join():`${e.name} ${e.key} ${e.moved}`,r=t.get(s);t.set(s,r?n?uT(r,e):hT(r,e):e)}return[...t.values()]}function hT(i,t){let[e,n]=[i,t].map(s=>{let r=new yn().setFromArray(Ze(s.vertices));return s.triangles.shape[0]+.01*r.getSize(new L).length()});return n>e?t:i}function uT(i,t){let e={...i,centre:i.centre.slice()};for(let n of["across","along"]){let s=Math.hypot(...i[n]),r=i[n].map(u=>u/s),o=Math.abs(al(r,t.across))+Math.abs(al(r,t.along)),a=al(r,t.centre)-al(r,i.centre),l=Math.min(-s,a-o),c=Math.max(s,a+o);e[n]=r.map(u=>u*(c-l)/2),e.centre=e.centre.map((u,h)=>u+r[h]*(l+c)/2)}return e}var Fv=.22,fT=.2,dT=2.5,pT=1,mT=.005,gT=["follow","front","side","top"],Vo=["follow","free","front","side","top","impact"],Ov=100,Bv=.4,zv=400,kv=i=>Math.max(...i.arms.map(t=>Ag(t)+t.cage_radius));function kd(i,t,e=!0){let n=i.map(Ep),s=t.robots;n.forEach((a,l)=>{let c=!a.arms.some(u=>u.compliant);a.colour=n.length>1?s[l%s.length]:s[c?1:0],a.glow=t.force,a.index=l,a.shift=0});let r=n.map(Cs),o=r.find(a=>a!==null);return r.forEach((a,l)=>{e&&a!==null&&Math.abs(o-a)>mT&&(n[l].shift=o-a)}),n}function iu(i,{flights:t=[],compare:e="side",align:n=!0,onCamera:s=()=>{},onDrawn:r=()=>{}}={}){let o={compare:e,align:n,magnified:1,camera:"follow",t:0,all:[],hidden:new Set,flights:[],forces:!0,path:!0,estimate:!1,share:1},a=Hn();i.classList.add("picture");let l=document.createElement("div");l.className="force-labels";let c=document.createElement("div");c.className="scene-legend";let u=null;try{u=new Sh({antialias:!0,alpha:!1,stencil:!0,powerPreference:"high-performance"})}catch{let Q=document.createElement("p");Q.className="no-graphics",Q.textContent="This browser cannot draw 3-D graphics (WebGL is off); plots and numbers work.",i.append(Q)}let h=new mo,f=new In(38,1,.02,80);f.up.set(0,0,1);let p=new mo,m=new mr(-1.9,1.9,1.9,-1.9,.1,20);m.up.set(0,0,1);let v=new Na("#ffffff","#9aa4b0",2.1),g=new Fa("#ffffff",2);g.position.set(-2,-3,5),h.add(v,g);let d=null,b=new Ee,S=[],y=0,P=0,E=-1/0,I=0,D=0,M=new Ot(1,1);if(u){u.localClippingEnabled=!0,i.append(u.domElement,l,c),u.domElement.setAttribute("role","img"),u.domElement.setAttribute("aria-label","The flight in three dimensions, with numbers beside it."),d=new Xh(f,u.domElement),d.enableDamping=!1,d.minDistance=.15,d.maxDistance=30,d.addEventListener("change",w);let Q=!1;d.addEventListener("start",()=>Q=!0),d.addEventListener("end",()=>Q=!1),d.addEventListener("change",()=>{Q&&o.camera!=="follow"&&s("")})}function w(){!u||y||(P=performance.now(),y=requestAnimationFrame(H))}function T(){let Q=performance.now(),ut=P-E<zv;E=Q,clearTimeout(I),ut&&(D=.7*D+.3*(Q-P)),D>Ov&&o.share>Bv&&(o.share=Math.max(Bv,.7*o.share),D=.5*Ov),B(ut?o.share:1),ut&&o.share<1&&(I=setTimeout(w,zv))}function B(Q){let ut=Math.min(devicePixelRatio||1,2)*Q;Math.abs(u.getPixelRatio()-ut)>.001&&u.setPixelRatio(ut)}function H(){y=0,!(!u||!i.clientWidth||!i.clientHeight)&&(T(),V(),r())}function V(){let Q=i.clientWidth,ut=i.clientHeight;u.setViewport(0,0,Q,ut),u.setScissorTest(!1),u.setClearColor(a.background,1),u.render(h,f);let St=Math.min(104,.24*Math.min(Q,ut));m.position.copy(f.position).sub(d.target).setLength(6),m.up.copy(f.up),m.lookAt(0,0,0),u.autoClear=!1,u.clearDepth(),u.setViewport(6,6,St,St),u.render(p,m),u.autoClear=!0,tt(Q,ut)}function W(){let Q=o.flights[0].obstacles.find(St=>St.kind==="wall"||St.kind==="mat"),ut=Q&&Math.abs(Q.normal[2])<.9?new L(...Q.across).normalize():new L(0,1,0);return ut.y<0?ut.negate():ut}let X=()=>W().applyAxisAngle(f.up,-Math.PI/2);function F(Q){let ut=new L,[St,C]=[1/0,-1/0];for(let x of o.flights.flatMap(N=>N.obstacles)){if(x.kind!=="mesh"||x.normals)continue;let N=Ze(x.vertices);for(let q=0;q<N.length;q+=3){let lt=ut.fromArray(N,q).dot(Q);[St,C]=[Math.min(St,lt),Math.max(C,lt)]}}return Math.max(0,C-St)}let z=()=>[...new Set(o.flights.map(Q=>Q.world))];function J(Q){let ut=o.flights.filter(N=>o.flights.some(q=>q!==N&&q.world===N.world)),St=new L,[C,x]=[1/0,-1/0];for(let{position:N}of ut)for(let q=0;q<N.length;q+=3){let lt=St.fromArray(N,q).dot(Q);[C,x]=[Math.min(C,lt),Math.max(x,lt)]}return Math.max(0,x-C)}let nt=()=>z().length>1&&F(W())>dT?"ghost":o.compare;function et(){if(nt()!=="side")return o.flights.map(()=>[0,0,0]);let Q=W(),ut=Math.max(...o.flights.map(kv)),St=Math.max(2*ut+J(Q),F(Q))+fT,C=z(),x=.5*(C.length-1);return o.flights.map(({world:N})=>Q.clone().multiplyScalar((x-C.indexOf(N))*St).toArray())}function ct(Q,{keepCamera:ut=!0}={}){a=Hn(),o.all=kd(Q,a,o.align),o.flights=o.all.filter((St,C)=>!o.hidden.has(C)),u&&ft(),ut||de(o.camera),vt(o.t)}function ft(){ol(b),b=new Ee,h.add(b),p.children.slice().forEach(ol),p.add(Dv(a)),l.replaceChildren();let Q=et(),ut=new yn,St=Math.max(...o.flights.map(Mu),0),C=St>0?Fv/wu(St):0;o.floor=yt(Q),S=o.flights.map((q,lt)=>{let ot=new Ee;ot.position.set(...Q[lt]),b.add(ot);let Ut=q.world!==z()[0]&&nt()==="ghost",_t=new rl(q,{colour:q.colour,opacity:Ut?.35:1},a),Ft=new eu(q,a,M),Bt=q.part.map(()=>new Yh(a.force,.007,Ut?.4:.95)),gt=new nu(q,o.floor,a);gt.group.visible=!Ut||o.flights.length===2;let Ct=Hr(q)?new rl(q,{colour:a.ink,opacity:.35},a):null;Ct&&ot.add(Ct.group),ot.add(_t.group,Ft.group,gt.group,...Bt.map(Zt=>Zt.group)),q.guide.length&&ot.add(Lv(q,a));let qt=new yn,Yt=Math.max(1,Math.floor(q.n/400));for(let Zt=0;Zt<q.n;Zt+=Yt)qt.expandByPoint(new L(...q.position.subarray(3*Zt,3*Zt+3)));ut.union(qt.translate(ot.position));let Lt=q.part.map(()=>{let Zt=document.createElement("span");return l.append(Zt),Zt});return{flight:q,group:ot,robot:_t,estimate:Ct,path:Ft,arrows:Bt,shadow:gt,scale:C,names:Lt,ghost:Ut,contacts:[],movers:[]}});let x=o.flights.flatMap((q,lt)=>q.obstacles.filter(ot=>ot.track<0).map(ot=>Uv(ot,Q[lt]))),N=x.some(q=>q.kind==="ground")?o.floor:null;Nv(x).forEach(q=>{let lt=zd(q,a,N);lt.position.set(...q.moved??[0,0,0]),b.add(lt)}),S.forEach(q=>{q.movers=q.flight.bodies.map((lt,ot)=>new tu(lt,q.flight.obstacles.filter(Ut=>Ut.track===ot),a,N));for(let lt of q.movers)q.group.add(lt.group)}),o.box=ut.clone(),N===null&&(ut.min.z=o.floor,b.add(Iv(ut,a))),xt()}function yt(){let Q=Math.max(...o.flights.flatMap(St=>St.obstacles.filter(C=>C.kind==="ground").map(C=>C.centre[2])));if(Number.isFinite(Q))return Q;let ut=1/0;for(let St of o.flights)for(let C=2;C<3*St.n;C+=3)ut=Math.min(ut,St.position[C]);return ut-.45}function xt(){let Q=Math.max(...o.flights.map(Mu),0);c.replaceChildren();let ut=(C,x)=>{let N=document.createElement("span");N.className=`key ${C}`,N.textContent=x,c.append(N)};if(o.flights.length>1&&o.flights.forEach(C=>{ut("robot",C.label),c.lastChild.style.setProperty("--colour",C.colour)}),o.estimate&&o.flights.some(Hr)&&ut("estimate","estimated pose"),Q>0&&o.forces){let C=wu(Q);ut("force",`contact force, each at its point, ${C} N is ${100*Fv} cm`)}o.flights.some(C=>C.thrust.some(x=>x>0))&&ut("thrust","thrust");let St=new Set(o.flights.flatMap(C=>C.obstacles.map(x=>x.kind==="mesh"?x.name:x.kind)));nt()!==o.compare&&ut("words","overlaid: the obstacles are too wide to be put side by side"),o.magnified!==1&&ut("travel",`arm travel × ${o.magnified}, not to scale`);for(let C of St)ut("obstacle",C),c.lastChild.style.setProperty("--colour",a[C==="mat"||C==="ground"?C:"wall"])}function tt(Q,ut){let St=new L,C=[];for(let x of S)x.names.forEach((N,q)=>{let lt=x.contacts[q];if(N.hidden=x.ghost||!o.forces||!lt||lt.size<.5,N.hidden)return;St.set(...lt.point).addScaledVector(new L(...lt.force),x.scale),St.add(x.group.position).project(f),N.hidden=St.z>1||Math.abs(St.x)>1||Math.abs(St.y)>1,N.textContent=`${lt.size.toFixed(lt.size<10?1:0)} N`;let ot=Math.min(Math.max((St.x+1)/2*Q,24),Q-24),Ut=Math.min(Math.max((1-St.y)/2*ut-12,10),ut-10);N.hidden=C.some(([_t,Ft])=>Math.abs(_t-ot)<50&&Math.abs(Ft-Ut)<18),!N.hidden&&(C.push([ot,Ut]),N.style.transform=`translate(${ot}px, ${Ut}px) translate(-50%, -50%)`)})}let $=null;function mt(){let Q=S.map(ut=>ut.robot.group.position.clone().add(ut.group.position));return Q.reduce((ut,St)=>ut.add(St),new L).divideScalar(Q.length||1)}function vt(Q){if(o.t=Q,o.poses=o.flights.map(ut=>Jo(ut,Q)),S.forEach((ut,St)=>{let C=o.poses[St];ut.robot.show(C,o.magnified),ut.path.group.visible=o.path,ut.path.show(C.own),ut.estimate&&(ut.estimate.group.visible=o.estimate,o.estimate&&ut.estimate.show(bu(ut.flight,Q),o.magnified)),ut.shadow.show(C),ut.movers.forEach((x,N)=>x.show(C.bodies[N])),ut.contacts=C.contacts,ut.arrows.forEach((x,N)=>{let q=C.contacts[N];q&&o.forces?x.show(q.point,q.force.map(lt=>ut.scale*lt)):x.hide()})}),u&&S.length&&gT.includes(o.camera)){let ut=mt();if($){let St=ut.clone().sub($);f.position.add(St),d.target.add(St)}$=ut,d.update()}w()}function bt(Q){let ut=Xs.degToRad(f.fov/2),St=Math.min(1,f.aspect);return Q/Math.sin(Math.atan(Math.tan(ut)*St))}function Gt(Q,ut){d.target.copy(Q),f.position.copy(Q).add(ut),d.update()}function de(Q){if(o.camera=Vo.includes(Q)?Q:"follow",$=null,s(o.camera),!u||!S.length)return;let ut=Math.max(...o.flights.map(kv)),St=S.map(Ft=>Ft.group.position),C=St[0].distanceTo(St[St.length-1])/2,x=ut+C+k()+.1,N=z().length>2&&C>0,q=N?Math.max(bt(ut+.2),x/(Math.tan(Xs.degToRad(f.fov/2))*f.aspect)+ut):bt(x),lt=o.box.clone().expandByScalar(ut+.1),ot=lt.getCenter(new L),Ut=.5*lt.getSize(new L).length(),_t=N?X().negate().addScaledVector(W(),-.25).setZ(.5).normalize():new L(-.62,-.66,.42).normalize();if(o.camera==="free")Gt(ot,_t.clone().multiplyScalar(bt(Ut)));else if(o.camera==="impact")Gt(he(),N?_t.clone().multiplyScalar(q):new L(-.45,-.62,.5).normalize().multiplyScalar(bt(x+.05)));else{$=mt();let Ft={follow:_t,front:X().setZ(.12),side:W().negate().setZ(.12),top:new L(0,-.001,1)}[o.camera];Gt($.clone(),Ft.clone().normalize().multiplyScalar(o.camera==="side"?bt(x):q))}w()}function k(){let Q=S.map(({flight:ut,robot:St})=>{let C=S.filter(q=>q.flight.world===ut.world);return C.map(q=>q.robot.group.position.clone()).reduce((q,lt)=>q.add(lt),new L).divideScalar(C.length).distanceTo(St.group.position)});return Math.min(Math.max(...Q),pT)}function he(){let Q=o.flights.map((ut,St)=>{let C=Jo(ut,Cs(ut)??ut.begin);return new L(...C.position).add(S[St].group.position)});return Q.reduce((ut,St)=>ut.add(St),new L).divideScalar(Q.length)}function st(){if(!u)return;let Q=i.clientWidth,ut=i.clientHeight;if(!Q||!ut)return;B(1),u.setSize(Q,ut,!1);let St=f.aspect;f.aspect=Q/ut,f.updateProjectionMatrix(),M.set(Q,ut),S.forEach(C=>C.path.resize(M)),Math.abs(St/f.aspect-1)>.15&&de(o.camera),w()}let wt=new ResizeObserver(st);wt.observe(i);let Pt=matchMedia("(prefers-color-scheme: dark)"),oe=()=>ct(o.all);Pt.addEventListener("change",oe);function rt(){wt.disconnect(),Pt.removeEventListener("change",oe),cancelAnimationFrame(y),clearTimeout(I),ol(b),p.children.slice().forEach(ol),d?.dispose(),u?.dispose(),i.replaceChildren()}return st(),t.length&&ct(t,{keepCamera:!1}),{show:vt,replace:ct,setCamera:de,resize:st,dispose:rt,setCompare(Q){o.compare=Q,o.flights.length&&ct(o.all,{keepCamera:!1})},setShown(Q,ut){if(typeof Q!="number"){o[Q]=ut,xt(),vt(o.t);return}ut?o.hidden.delete(Q):o.hidden.add(Q),ct(o.all,{keepCamera:!1})},canvas(Q=!0){return Q&&u&&(B(1),V()),u?.domElement??null},setMagnified(Q){o.magnified=Q,xt(),vt(o.t)},get flights(){return o.flights},get all(){return o.all},get camera(){return o.camera},pose:()=>({t:o.t,camera:o.camera,pixels:o.share,flights:o.poses??[],places:S.map(({group:Q,robot:ut})=>ut.group.position.clone().add(Q.position).toArray()),ends:S.map(({robot:Q})=>Q.ends()),connections:S.map(({robot:Q})=>Q.connections()),estimates:o.estimate?o.flights.map(Q=>Hr(Q)?bu(Q,o.t):null):[]}),memory:()=>({...u?.info.memory})}}var vT={follow:"Follow",free:"Whole flight",front:"Front",side:"Side",top:"Top",impact:"Impact"},_T={1:"front",2:"side",3:"top",4:"follow",5:"free",6:"impact",0:"follow"},xT=[["space","play, pause"],["← →","one instant back, forth; with shift ten"],[", .","slower, faster"],["t","to the first touch"],["Home End","to the start, to the end"],["1 2 3","view from the front, from the side, from above"],["4 5 6","follow, whole flight, impact"],["0","the view as it was at first"],["e","estimated pose, on and off"],["f","full screen"],["p","save a picture"],["l","copy a link to this instant and view"],["a click in a plot","goes to that instant"],["a drag in a plot","zooms: along the time, the values, or both"],["a double click in a plot","shows everything"],["Escape","undoes the last zoom"],["?","these keys"]],Hd="springback.plots",yT=8e3;function Hv(i,t){let e=G("div",{class:"stage"}),n=G("div"),s=G("div",{class:"readouts"}),r=G("div"),o=G("p",{class:"remark",role:"status",hidden:!0}),a=!1,l=null,c=null,u=iu(e,{flights:t.flights,onCamera:st=>(l?.mark(st),Gt()),onDrawn:()=>c?.drawn()}),h=u.all,f=h.length>1,p=new Set(h.map(st=>st.world)).size,m=[...new Set(h.map(st=>st.scenario))],v=m.length>2?`${h.length} flights`:m.join(" and ");function g(st){o.textContent=st,o.hidden=!1,clearTimeout(g.ends),g.ends=setTimeout(()=>o.hidden=!0,yT)}let d=h.map((st,wt)=>MT(st,f&&(Pt=>M(wt,Pt))));l=Si("Camera",Vo.map(st=>[st,vT[st]]),"follow",st=>u.setCamera(st));let b=Si("Flights",[["side","side by side"],["ghost","overlaid"]],"side",st=>(u.setCompare(st),Gt())),S=h.some(st=>st.arms.some(wt=>wt.compliant)),y=Si("Arm travel",[["1","arms to scale"],["10","arm travel × 10"]],"1",st=>(u.setMagnified(Number(st)),Gt())),P={forces:["Forces",!0],path:["Path",!0],...h.some(Hr)?{estimate:["Estimate",!1]}:{}},E=Object.fromEntries(Object.entries(P).map(([st,[wt,Pt]])=>[st,fp(wt,Pt,oe=>(u.setShown(st,oe),Gt()),st==="estimate"?"The pose that the pilot estimates, as a grey ghost (E)":"")])),I=G("div",{class:"choice",role:"group","aria-label":"Show"},...Object.values(E)),D=()=>h.flatMap((st,wt)=>d[wt].shown?[]:[wt+1]);function M(st,wt){if(!wt&&D().length===h.length-1)return g("One flight is always shown.");d[st].mark(wt),u.setShown(st,wt),vt.replace(),Gt()}let w=lv(r,{onSeek:st=>(vt.pause(),vt.seek(st)),onZoom:()=>(z(),Gt()),onEdit:st=>T.open(w.wanted,st),onRemove:st=>J(w.wanted.filter((wt,Pt)=>Pt!==st))}),T=Cp({signals:_l(h),standard:er(h),onChoose:J}),B=h.find(st=>st.impacts.length),H=()=>{let[st,wt]=B.impacts[0].map(oe=>oe+B.shift),Pt=.35*Math.min(wt-st,.2)+.004;return[st-Pt,Math.min(wt,st+.3)+2*Pt]},V=st=>!!(B&&st)&&st.every((wt,Pt)=>Math.abs(wt-H()[Pt])<1e-9),W=Si("Plots show",[["all","whole flight"],...B?[["impact","first impact"]]:[]],"all",st=>st==="all"?w.zoom():w.zoom(...H())),X=G("button",{type:"button",class:"undo",title:"Undo the last zoom (Escape)",disabled:!0,"aria-label":"Undo the last zoom",onclick:()=>w.back()},Yi("undo")),F=G("button",{type:"button",class:"adding",title:"Choose plots and signals",onclick:()=>T.open(w.wanted)},"Plots …");function z(){let{range:st,heights:wt}=w.zoomed,Pt=!Object.keys(wt).length;W.mark(Pt&&!st?"all":Pt&&V(st)?"impact":""),X.disabled=!w.canGoBack}function J(st){w.choose(st);try{st?localStorage.setItem(Hd,Qo(st)):localStorage.removeItem(Hd)}catch{}Gt()}let nt=G("dialog",{class:"keys","aria-label":"Keys and mouse"},G("h2",{},"Keys and mouse"),G("table",{},...xT.map(([st,wt])=>G("tr",{},G("th",{scope:"row"},st),G("td",{},wt)))),G("form",{method:"dialog"},G("button",{class:"main"},"Close"))),et=(st,wt,Pt,oe)=>G("button",{type:"button",class:`tool tool-${st}`,title:`${wt}${oe?` (${oe})`:""}`,"aria-label":wt,onclick:Pt},Yi(st)),ct=et("film","Record a film from here",()=>c.film()),ft=G("div",{class:"left"},e,n),yt=yl(()=>ft,()=>g("This browser refuses full screen.")),xt=G("div",{class:"tools"},et("link","Copy a link to this instant and view",tt,"L"),et("picture","Save a picture",()=>c.picture(),"P"),ct,yt.button,et("help","Keys and mouse",()=>nt.showModal(),"?"));async function tt(){let st=bt.address();try{await navigator.clipboard.writeText(st),g("The link is copied.")}catch{g("The address of this page is now a link to this instant and view.")}}let mt={...Object.fromEntries(Object.entries(_T).map(([st,wt])=>[st,()=>u.setCamera(wt)])),f:yt.toggle,p:()=>c.picture(),l:tt,"?":()=>nt.showModal(),e:()=>E.estimate?.click(),Escape:()=>w.back()};i.replaceChildren(G("header",{class:"top"},G("div",{class:f?"flights several":"flights"},G("h1",{},v),...d.map(st=>st.element)),G("div",{class:"views"},l,...p>1?[b]:[],...S?[y]:[],I)),G("main",{},ft,G("aside",{},s,G("div",{class:"plot-head"},G("h2",{},"Over time"),W,X,F),r,...wT(h),ST(h))),T.element,nt),e.append(o),i.classList.add("replay");let vt=Gh({scene:u,plots:w,bar:n,readouts:s,actions:mt,onRest:()=>(c?.rested(),Gt())});c=pp({scene:u,stage:e,player:vt,say:g,name:v.replace(/[^\p{L}\p{N}]+/gu,"-").slice(0,60),onRecording:st=>{ct.classList.toggle("recording",st),ct.setAttribute("aria-label",st?"End the film":"Record a film from here")}}),n.querySelector(".buttons").append(xt),vt.replace({keepTime:!1}),B&&w.restore({range:H(),heights:{}}),z(),u.setCamera("follow");let bt=Pp({read:de,apply:k});function Gt(){a&&!vt.playing&&bt.renew()}function de(){let{range:st}=w.zoomed;return{t:vt.time.toFixed(6).replace(/0+$/,"").replace(/\.$/,""),camera:u.camera==="follow"?"":u.camera,speed:vt.pace==="auto"?"":vt.pace,arms:y.chosen==="10"?"10":"",compare:b.chosen==="ghost"?"ghost":"",hide:D().join(),layers:Object.keys(P).filter(wt=>E[wt].on!==P[wt][1]).join(),zoom:V(st)||!st&&!B?"":st?st.map(wt=>wt.toFixed(6)).join():"all",plots:Qo(w.wanted)===Qo(er(h))?"":Qo(w.wanted)}}function k(st){let wt=rt=>rt.split(",").map(Number);if(st.hide){let rt=wt(st.hide);h.every((Q,ut)=>rt.includes(ut+1))||h.forEach((Q,ut)=>d[ut].shown===rt.includes(ut+1)&&M(ut,!rt.includes(ut+1)))}st.compare==="ghost"&&p>1&&b.press("ghost"),st.arms==="10"&&S&&y.press("10");let Pt=(st.layers??"").split(",");for(let rt of Object.keys(P))Pt.includes(rt)&&E[rt].on===P[rt][1]&&E[rt].click();Vo.includes(st.camera)&&u.setCamera(st.camera);let oe=st.plots?Su(st.plots,h):[];oe.length&&w.choose(oe),st.zoom==="all"?w.restore({range:null,heights:{}}):st.zoom&&w.restore({range:wt(st.zoom),heights:{}}),(st.speed==="auto"||Number(st.speed)>0)&&vt.setPace(st.speed),st.t&&Number.isFinite(Number(st.t))&&vt.seek(Number(st.t))}let he=bT(h);return he.length&&w.choose(he),bt.follow(),a=!0,window.springback={scene:u,player:vt,plots:w,link:bt,pose:()=>({...u.pose(),playing:vt.playing,pace:vt.pace})},matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{h.forEach((st,wt)=>d[wt].element.style.setProperty("--colour",st.colour)),vt.replace()}),window.springback}function bT(i){try{return Su(localStorage.getItem(Hd)??"",i)}catch{return[]}}function MT(i,t){let e={shown:!0},n=t?G("button",{type:"button",class:"flight","aria-pressed":"true",title:"Hide or show this flight",onclick:()=>t(!e.shown)},i.label):G("b",{},i.label);return e.element=G("p",{class:`outcome ${i.success?"well":"badly"}`},n,G("span",{},` ${i.sentence}`)),e.element.style.setProperty("--colour",i.colour),e.mark=s=>{e.shown=s,n.setAttribute("aria-pressed",String(s)),e.element.classList.toggle("away",!s)},e}function wT(i){let t=i.flatMap(e=>e.touched.map(n=>G("p",{},i.length>1?`${e.label}: ${n}`:n)));return t.length?[G("details",{class:"about touched",open:i.length===1},G("summary",{},"Touched obstacles"),...t)]:[]}function ST(i){let t=i.flatMap(s=>[...s.notes.map(r=>`${s.label}: ${r}.`),s.shift?`${s.label} is shown ${Math.abs(s.shift).toFixed(3)} s ${s.shift<0?"earlier":"later"} than it flew, so that all touch at the same time.`:""]),e=Math.max(...i.map(s=>s.departure.position))*1e3;t.push(`Motion between the drawn instants is interpolated linearly: positions are within ${e<.01?"0.01":e.toFixed(2)} mm of the flight.`);let n=Math.max(...i.map(s=>s.every));return t.push("Signals that you choose are rounded to 1/65534 of their range."),n>1&&t.push(`Telemetry is shown at every tick near impacts and changes of phase, elsewhere at one tick in ${n}.`),G("details",{class:"about"},G("summary",{},"About this view"),...[...new Set(t)].filter(Boolean).map(s=>G("p",{},s)),G("p",{},"World axes: x north, y west, z up. Yellow arrows are the contact forces on cages and main body, including friction; the numbers show their vector sum, in which friction on two cages may cancel. Blue bars are the thrust of the rotors; dark discs are vertical shadows."))}var Vd=1e3,Gv=(i,t)=>Number((Math.round(i/t)*t).toFixed(6));function ll(i,t){let{least:e,most:n,logarithmic:s}=i,r=s?Math.log(t/e)/Math.log(n/e):(t-e)/(n-e);return Math.min(Math.max(r,0),1)}function Vv(i,t){let{least:e,most:n,step:s,logarithmic:r}=i,o=r?e*(n/e)**t:e+(n-e)*t,a=r?10**Math.max(Math.floor(Math.log10(o))-1,Math.log10(s)):s;return Math.min(Math.max(Gv(o,Math.max(a,s)),e),n)}function ET(i,t){let e=`set-${i.name}`,n=i.unit.replace("^1.5","¹·⁵"),s=G("input",{type:"range",min:0,max:Vd,step:1,id:`${e}-slider`,"aria-label":i.label,oninput:()=>h(Vv(i,Number(s.value)/Vd),{moving:!0}),onchange:()=>t(i.name,r.value,{settled:!0}),onkeydown:m=>{let v={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[m.key];if(!v)return;m.preventDefault();let g=Number(r.value);Number.isFinite(g)&&h(Math.min(Math.max(Gv(g+v*i.step,i.step),i.least),i.most),{settled:!0})}}),r=G("input",{type:"text",inputmode:"decimal",id:e,autocomplete:"off",spellcheck:"false",maxlength:40,"aria-describedby":`${e}-words`,oninput:()=>t(i.name,r.value.trim(),{typing:!0}),onchange:()=>t(i.name,r.value.trim(),{settled:!0})}),o=G("p",{class:"words",id:`${e}-words`}),a=G("div",{class:"marks"},...i.marks.map((m,v)=>{let g=S=>String(S.value).length*.013+.01,d=i.marks.some((S,y)=>y<v&&Math.abs(ll(i,S.value)-ll(i,m.value))<g(S)+g(m)),b=G("button",{type:"button",class:d?"tight":"",title:`${m.value} ${n}, ${m.words}`,"aria-label":`${i.label} ${m.value} ${n}, ${m.words}`,onclick:()=>h(m.value,{settled:!0})},G("span",{},String(m.value)));return b.style.setProperty("--share",ll(i,m.value)),b})),l=G("div",{class:"slider-control","data-name":i.name},G("label",{for:e},i.label),G("span",{class:"field"},r,G("span",{class:"unit"},n)),G("div",{class:"rail"},s,a),o);function c(m){let v=Number(m);r.value.trim()!==String(m)&&(r.value=String(m)),Number.isFinite(v)&&(s.value=Math.round(ll(i,v)*Vd),s.setAttribute("aria-valuetext",`${m} ${n}`)),f("")}function u(){let m=i.marks.find(v=>v.value===Number(r.value));o.className=m?"words printed":"words",o.textContent=m?`= ${m.words}`:i.explains}function h(m,v){c(m),t(i.name,String(m),v)}function f(m){r.setAttribute("aria-invalid",String(!!m)),l.classList.toggle("wrong",!!m),m?o.textContent=m:u()}return l.title=i.explains,{element:l,show:c,tellProblem:f,pick:m=>h(Vv(i,ll(i,m)),{settled:!0})}}function TT(i){let t=G("p",{class:"words"},i.explains);return{element:G("div",{class:"fixed-control","data-name":i.name},G("span",{class:"label"},i.label),t),show:()=>{},tellProblem:s=>t.textContent=s||i.explains}}function AT(i,t){let e=Object.keys(i.words).length>3,n=G("p",{class:"words"},i.explains),s=a=>t(i.name,a,{settled:!0});if(!e){let a=Si(i.label,Object.entries(i.words),i.default,s);return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("span",{class:"label"},i.label),a),show:a.mark,tellProblem:()=>{}}}let r=G("select",{id:`set-${i.name}`,onchange:()=>s(r.value)},...Object.entries(i.words).map(([a,l])=>G("option",{value:a},l)));return{element:G("div",{class:"picked","data-name":i.name,title:i.explains},G("label",{for:`set-${i.name}`},i.label),r,n),show:a=>r.value=a,tellProblem:a=>n.textContent=a||i.explains}}var RT={slider:ET,fixed:TT,choice:AT};function Wv(i,t){let e={},n={},s=new Map,r=(m,v,g)=>{e[m]=v,l(),t(m,v,g)};for(let m of i)e[m.name]=String(m.default),n[m.name]=RT[m.kind](m,r),s.has(m.group)||s.set(m.group,[]),s.get(m.group).push(n[m.name].element);let o=[...s].map(([m,v])=>G("section",{},...m?[G("h2",{},m)]:[],...v)),a=G("form",{class:"controls",onsubmit:m=>m.preventDefault()},...o);function l(){for(let m of i){let v=Object.entries(m.when).every(([g,d])=>d.includes(e[g]));n[m.name].element.hidden=!v}o.forEach(m=>m.hidden=![...m.querySelectorAll("[data-name]")].some(v=>!v.hidden))}function c(m){for(let[v,g]of Object.entries(m))e[v]=String(g),n[v]?.show(g);l()}function u(m){for(let v of Object.values(n))v.tellProblem("");for(let v of m){let g=v.split(":")[0],d=g in n?g:i.find(b=>b.path===g)?.name;n[d]?.tellProblem(v.slice(g.length+1).trim())}}let h=()=>i.filter(m=>e[m.name]!==String(m.default)).map(m=>`${m.name}=${encodeURIComponent(e[m.name])}`).join("&");return l(),{element:a,values:e,query:h,show:c,tellProblems:u,isShown:m=>!n[m].element.hidden,pick:(m,v)=>n[m].pick(v)}}function Xv(i,t){let e=null,n=!1,s=0;function r(l,c){clearTimeout(s),e={query:l,how:c},n||o()}async function o(){let{query:l,how:c}=e;e=null,n=!0;try{await a(l,c)}catch{e||t.gone()}n=!1,e&&o()}async function a(l,c){let u=await fetch(`flight?${l}`,{headers:{"x-lab-page":i}}),h=await u.json();u.ok?t.answered(h,c):u.status===503?(h.preparing&&t.waits(h.preparing),s=setTimeout(()=>r(l,{...c,since:performance.now()}),700)):!h.overtaken&&!e&&t.refused(h.errors,c)}return{ask:r}}var qv=100,CT=16,su="Energy",Yv=[-.01,.13],PT={motion:["#0072b2",.85],"arm springs":["#56b4e9",.85],"end stops":["#cc79a7",.85],contact:["#009e73",.85],"lost in arms":["#e69f00",.6],"lost in contact":["#d55e00",.6],"lost in friction":["#8c8c8c",.6],"lost in stops":["#cc79a7",.4],"lost in locking":["#444444",.4],"lost to air":["#bbbbbb",.4]},$v=(i,t)=>i+Math.round(255*t).toString(16).padStart(2,"0");function Gd(i,t=[1,1.5,2,3,5,7,10]){if(!(i>0))return 1;let e=10**Math.floor(Math.log10(i));return e*t.find(n=>n*e>=i*.999999)}function Wd(i,t,e,{moving:n=!1,locked:s=!1}={}){if(i&&s)return i;let r=[t<-1e-9?-Gd(-t):0,e>1e-9?Gd(e):t<-1e-9?0:1],[o,a]=i??r,l=t>=o&&e<=a&&(n||e-t>.3*(a-o));return i&&l?i:n?[Math.min(o,r[0]),Math.max(a,r[1])]:r}function IT(i,t,e){let n=0,s=0;for(let{t:r,values:o}of i)for(let a=0;a<o.length;a++)r[a]<t||r[a]>e||(o[a]<n&&(n=o[a]),o[a]>s&&(s=o[a]));return[n,s]}function LT(i,t){let e=new Map,n=(a,l,c)=>{e.has(a)||e.set(a,{name:a,unit:l,curves:[],stacked:a.startsWith(su)}),e.get(a).curves.push(c)},s=(a,l)=>{let c=Array.from(a.t,h=>h+a.shift),u=null;for(let h of a.series)if(h.panel===su){if(l)continue;u=Array.from(h.values,(m,v)=>m+(u?u[v]:0));let[f,p]=PT[h.name]??["#8c8c8c",.5];n(`${su}, ${a.label}`,h.unit,{name:h.name,t:c,values:u,colour:f,fill:$v(f,p),flight:a})}else n(h.panel,h.unit,{name:l?`${a.label}, pinned`:a.label,t:c,values:Array.from(h.values),flight:a,colour:l?$v(a.colour,.75):a.colour,dash:l?[3,3]:a.dash,behind:l})};i.forEach((a,l)=>{a.dash=l?[8,3]:[],s(a,!1)}),t.forEach(a=>s(a,!0));let r=i.map(a=>`${su}, ${a.label}`),o=a=>["Acceleration","Arm compression",...r,"Velocity","Contact force"].indexOf(a.name);return[...e.values()].sort((a,l)=>o(a)-o(l))}function Zv(i,{onSeek:t}){let e=new Map,n=[],s=[],r=0,o=null,a=!1;i.classList.add("plots");function l(v,{whole:g=!1,moving:d=!1}={}){s=v;let b=Cs(v[0]),[S,y]=[v[0].begin,v[0].end];o=g||b===null?[S,y]:[b+Yv[0],Math.min(b+Yv[1],y)];let P=b??0,E=LT(v,n);for(let[I,D]of e)E.some(M=>M.name===I&&c(M,g)===D.signature)||(D.plot.destroy(),D.box.remove(),e.delete(I));for(let I of E){let D=e.get(I.name)??h(I,g);D.panel=I,D.zero=P,D.bounds=Wd(D.bounds,...IT(I.curves,...o),{moving:d,locked:a}),D.plot.batch(()=>{D.plot.setData(u(I),!1),D.plot.setScale("x",{min:o[0],max:o[1]}),D.plot.setScale("y",{min:D.bounds[0],max:D.bounds[1]})}),i.append(D.box)}p(r)}let c=(v,g)=>`${g} ${v.curves.map(d=>`${d.name} ${d.colour}`).join()}`;function u(v){let d=v.curves.every(b=>b.flight===v.curves[0].flight)?[v.curves[0].t,...v.curves.map(b=>b.values)]:Ke.join(v.curves.map(b=>[b.t,b.values]));return v.stacked?[d[0],...d.slice(1).reverse()]:d}function h(v,g){let d=Hn(),b=!v.stacked||v.curves[0].flight===s[0],S=v.curves.filter(()=>b).map(T=>{let B=document.createElementNS("http://www.w3.org/2000/svg","svg");B.setAttribute("viewBox","0 0 22 8"),B.setAttribute("aria-hidden","true");let H=document.createElementNS("http://www.w3.org/2000/svg","line"),V={x1:0,x2:22,y1:4,y2:4,stroke:T.fill??T.colour,"stroke-width":T.fill?8:2.4,"stroke-dasharray":(T.dash??[]).join(" ")};return Object.entries(V).forEach(([W,X])=>H.setAttribute(W,X)),B.append(H),G("span",{class:"plot-key"},B,G("span",{},T.name))}),y=G("div",{class:"plot-canvas"}),P=G("section",{class:"plot","data-panel":v.name},G("header",{},G("h3",{},`${v.name} [${v.unit}]`),G("div",{class:"plot-keys"},...S)),y);i.append(P);let E={box:P,canvas:y,panel:v,signature:c(v,g),bounds:null,zero:0},I={stroke:d.faint,grid:{stroke:d.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},D=v.stacked?[...v.curves].reverse():v.curves,M=(T,B)=>B.map(H=>String(g?+H.toFixed(3):Math.round(1e3*(H-E.zero)))),w=(T,B,H,V)=>DT(H,V,E.zero,g);return E.plot=new Ke({width:Math.max(y.clientWidth,200),height:qv,padding:[6,10,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[{...I,size:22,gap:2,values:M,splits:w},{...I,size:46,gap:4,space:CT}],series:[{},...D.map(T=>({stroke:T.colour,width:T.fill?1:T.behind?1.4:1.8,dash:T.dash??[],fill:T.fill,spanGaps:!0,points:{show:!1}}))],hooks:{draw:[()=>f(E)]},bands:v.stacked?D.slice(1).map((T,B)=>({series:[B+1,B+2],fill:D[B].fill})):[]},u(v),y),E.marker=G("div",{class:"plot-now"}),E.plot.over.append(E.marker),E.plot.over.addEventListener("click",T=>t(E.plot.posToVal(T.offsetX,"x"))),e.set(v.name,E),E}function f({plot:v,marker:g}){if(!g)return;let{min:d,max:b}=v.scales.x;g.hidden=!(r>=d&&r<=b),g.style.transform=`translateX(${v.valToPos(r,"x")}px)`}function p(v){r=v,e.forEach(f)}function m(){for(let{plot:v,canvas:g}of e.values()){let d=g.clientWidth;d&&Math.abs(d-v.width)>1&&v.setSize({width:d,height:qv})}p(r)}return new ResizeObserver(m).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>{e.forEach(({plot:v,box:g})=>(v.destroy(),g.remove())),e.clear()}),{replace:l,show:p,pin(v){n=v},lock(v){a=v},bounds:v=>e.get(v)?.bounds,curve:v=>e.get(v)?.panel.curves.map(g=>({name:g.name,peak:g.values.reduce((d,b)=>Math.max(d,b),0),points:g.values.length})),get flights(){return s}}}function DT(i,t,e,n){let s=n?Gd((t-i)/8,[1,2,5,10]):.02,r=[];for(let o=Math.ceil((i-e*!n)/s);;o++){let a=o*s+(n?0:e);if(a>t)return r;r.push(a)}}var Kv=150,UT=700,NT=40;function Jv(i,{choices:t,table:e,page:n,isShown:s,onPick:r,onChoice:o}){let a=new Map,l=null,c=null,u=null,h=null,f=0,p="",m=G("select",{id:"sweep-of","aria-label":"Control to sweep",onchange:E}),v=G("select",{id:"sweep-measure","aria-label":"Measure of the sweep",onchange:E},...t.measures.map(F=>G("option",{value:F.name},F.label)));v.value="impact_peak_acceleration";let g=G("div",{class:"plot-canvas"}),d=G("h3"),b=G("p",{class:"words",role:"status"});i.classList.add("sweep"),i.replaceChildren(G("div",{class:"sweep-head"},G("h2",{},"Sweep"),m,v),d,g,b),P();let S=F=>e.find(z=>z.name===F),y=()=>t.measures.find(F=>F.name===v.value);function P(){let F=m.value,z=t.controls.filter(nt=>s(nt.name)||nt.name===F),J=["",...z.map(nt=>nt.name)].join();m.dataset.names!==J&&(m.dataset.names=J,m.replaceChildren(G("option",{value:""},"off"),...z.map(nt=>G("option",{value:nt.name},nt.label))),m.value=F)}function E(){h=null,D(l,{}),o()}function I(F){return F.split("&").filter(z=>z&&z.split("=")[0]!==m.value).join("&")}function D(F,{moving:z=!1}){if(l=F,P(),clearTimeout(f),!l||!m.value)return T("");if(l.is_piloted)return T("Flights with a pilot are not swept here; a campaign can: springback campaign.");if(!s(m.value))return T("This control has no effect here.");let J=`${m.value}?${I(l.query)}`;a.has(J)?(c=a.get(J),w()):z||M(J),V(!a.has(J))}async function M(F){p=F;let[z,J]=F.split(/\?(.*)/s);b.textContent="Flying the sweep …";try{let nt=await fetch(`sweep?${[J,`of=${z}`].filter(Boolean).join("&")}`,{headers:{"x-lab-page":n}}),et=await nt.json();if(p!==F)return;if(nt.ok)a.size>=NT&&a.delete(a.keys().next().value),a.set(F,et),D(l,{});else if(nt.status===503){let ct=et.preparing;b.textContent=ct?`Compiling for ${ct.what}, about ${ct.about} s, once on this machine: ${Math.round(ct.waited)} s so far.`:"Too many requests are waiting.",f=setTimeout(()=>M(F),UT)}else et.overtaken||T(et.errors.join(" "))}catch{b.textContent="The lab does not respond."}}function w(){let F=c.refusals.reduce((et,ct)=>et+ct.count,0),z=Object.keys(c.labels).length>1?c.labels:{},J=et=>Number(et.toPrecision(3)),nt=c.refusals.map(({robot:et,from:ct,to:ft,why:yt})=>` ${z[et]?`${z[et]}, `:""}${ct===ft?"":`${J(ct)} to `}${J(ft)} ${S(c.of).unit}: ${yt}.`);b.textContent=F?`${F} of ${c.at.length*Object.keys(c.labels).length} points cannot be flown.${nt.join("")}`:`${c.at.length} flights for each robot in ${c.took.toFixed(0)} ms. A click sets the value.`}function T(F){p="",c=null,d.textContent="",u?.destroy(),u=null,b.textContent=F,i.classList.toggle("off",!m.value)}function B(){let F=l.measures.find(z=>z.name===v.value);return l.flights.map((z,J)=>({robot:z.robot,label:z.label,colour:Hn().robots[H(J)],dash:J?[8,3]:[],x:l.settings[m.value],y:F?.values[z.robot]??null}))}let H=F=>l.flights.length===1&&l.flights[0].robot==="quad"?1:F%2;function V(F){if(i.classList.remove("off"),!c||c.of!==m.value)return u&&(u.destroy(),u=null);let z=B(),J=S(m.value),nt=z.map(yt=>c.measures[v.value][yt.robot]??c.at.map(()=>null)),et=[...nt.flat(),...z.map(yt=>yt.y)].filter(yt=>yt!==null);h=Wd(h,Math.min(0,...et),Math.max(0,...et));let ct=y();d.textContent=ct.unit?`${ct.label} [${ct.unit}]`:ct.label;let ft=JSON.stringify([J.name,v.value,z.map(yt=>[yt.label,yt.colour])]);u?.look!==ft&&W(J,z,ft),u.batch(()=>{u.setData([c.at,...nt],!1),u.setScale("x",{min:J.least,max:J.most}),u.setScale("y",{min:h[0],max:h[1]})}),u.points=z,g.classList.toggle("old",F),X()}function W(F,z,J){u?.destroy();let nt=Hn(),et={stroke:nt.faint,grid:{stroke:nt.line,width:.6},ticks:{show:!1},font:"11px system-ui, sans-serif"},ct=F.unit?` [${F.unit.replace("^1.5","¹·⁵")}]`:"",ft={...et,size:24,gap:6,label:`${F.label}${ct}`,labelSize:15,labelFont:et.font,labelGap:0};F.logarithmic&&Object.assign(ft,{splits:(yt,xt,tt,$)=>FT(tt,$),values:(yt,xt)=>xt.map(String),filter:(yt,xt)=>xt}),u=new Ke({width:Math.max(g.clientWidth,200),height:Kv,padding:[8,12,0,0],legend:{show:!1},scales:{x:{time:!1,auto:!1,distr:F.logarithmic?3:1,range:[F.least,F.most]},y:{auto:!1}},cursor:{x:!1,y:!1,points:{show:!1},drag:{x:!1,y:!1}},axes:[ft,{...et,size:46,gap:4,space:26}],series:[{},...z.map(yt=>({stroke:yt.colour,width:1.8,dash:yt.dash,points:{show:!1}}))],hooks:{draw:[X]}},[[F.least,F.most],...z.map(()=>[null,null])],g),u.look=J,u.line=G("div",{class:"plot-now"}),u.dots=z.map(yt=>{let xt=G("div",{class:"sweep-point",title:yt.label});return xt.style.background=yt.colour,xt}),u.over.append(u.line,...u.dots),u.over.addEventListener("click",yt=>r(F.name,u.posToVal(yt.offsetX,"x")))}function X(){if(!u?.points)return;let F=y();u.line.style.transform=`translateX(${u.valToPos(u.points[0].x,"x")}px)`,u.points.forEach(({x:z,y:J,label:nt},et)=>{let ct=u.dots[et];ct.hidden=J===null,J!==null&&(ct.title=`${nt}: ${Number(J.toPrecision(4))} ${F.unit}`,ct.style.transform=`translate(${u.valToPos(z,"x")}px, ${u.valToPos(J,"y")}px)`)})}return new ResizeObserver(()=>{let F=g.clientWidth;u&&F&&Math.abs(F-u.width)>1&&u.setSize({width:F,height:Kv})}).observe(i),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>l&&D(l,{})),{show:D,hash:()=>m.value?`#sweep=${m.value},${v.value}`:"",restore(F){let[z,J]=(F.match(/^#sweep=([a-z_]+),([a-z_]+)$/)??[]).slice(1),nt=(et,ct)=>et.some(ft=>ft.name===ct);m.dataset.names="",m.replaceChildren(G("option",{value:""},"off"),...t.controls.map(et=>G("option",{value:et.name},et.label))),m.value=nt(t.controls,z)?z:"",nt(t.measures,J)&&(v.value=J),h=null,l&&D(l,{})},state:()=>({of:m.value,measure:v.value,curve:c,points:u?.points??[],bounds:h,words:b.textContent})}}function FT(i,t){let e=[];for(let n=Math.floor(Math.log10(i));n<=Math.log10(t);n++)for(let s of[1,2,5]){let r=Number((s*10**n).toPrecision(3));r>=i&&r<=t&&e.push(r)}return e}var Xd=i=>{if(i==null)return"–";if(typeof i=="string")return i;let t=Math.abs(i);return t<5e-4?"0":i.toFixed(t<1?3:t<10?2:t<100?1:0)};function jv(i){function t(e,n,s){let r=e.flights.map(p=>[p.robot,p.label]),o=p=>n?.flights.some(m=>m.robot===p),a=e.measures.some(p=>Object.keys(p.printed).length),l=G("tr",{},G("th",{},""));for(let[p,[m,v]]of r.entries()){let g=G("th",{scope:"col"},v);g.style.color=s[p],l.append(g),a&&l.append(G("th",{scope:"col",class:"printed"},"paper")),o(m)&&l.append(G("th",{scope:"col",class:"pinned"},"pinned"))}let c=e.measures.map(p=>{let m=n?.measures.find(g=>g.name===p.name),v=G("tr",{"data-measure":p.name},G("th",{scope:"row"},p.label,...p.unit?[G("small",{},` ${p.unit}`)]:[]));for(let[g]of r){let d=[a&&p.printed[g]?`paper ${p.printed[g]}`:"",o(g)?`pinned ${Xd(m?.values[g])}`:""];v.append(G("td",{"data-robot":g,"data-beside":d.filter(Boolean).join(", ")},G("b",{},Xd(p.values[g])))),a&&v.append(G("td",{class:"printed"},p.printed[g]??"")),o(g)&&v.append(G("td",{class:"pinned"},Xd(m?.values[g])))}return v}),{words:u,same:h}=e.printed_for,f=a?[G("p",{class:h?"note":"note other"},h?u:`${u} The settings here differ.`)]:[];i.replaceChildren(G("table",{},G("thead",{},l),G("tbody",{},...c)),...f),i.classList.toggle("elsewhere",!h)}return{show:t}}var Qv={impact:"Impact",follow:"Follow",side:"Side",top:"Top",free:"All"},OT=.012,BT=350;function t_(i,t){let e=Math.random().toString(36).slice(2),n=null,s=null,r=!1,o=[],a=Wv(t.controls,ct),l=G("div",{class:"outcomes","aria-live":"polite"}),c=G("p",{class:"alert",role:"alert",hidden:!0}),u=G("input",{class:"link",readonly:!0,"aria-label":"Link to these settings",id:"link",onfocus:()=>u.select()}),h=G("button",{type:"button",id:"copy",onclick:wt},"Copy link"),f=G("button",{type:"button",id:"pin","aria-pressed":"false",title:"Keep this flight behind the next ones for comparison",onclick:Pt},"Pin"),p=G("button",{type:"button",id:"reset",title:t.file?`Return to ${t.file}`:"Return to the paper's slider test",onclick:()=>st("",{push:!0})},"Reset"),m=G("span",{class:"files"}),v=G("div",{class:"stage"}),g=G("div",{class:"preparing",role:"status",hidden:!0}),d=G("div"),b=G("div"),S=G("div",{class:"measures"}),y=G("div"),P=G("button",{type:"button",id:"lock","aria-pressed":"false",title:"Keep the vertical scales of all plots as they are",onclick:mt},"Lock y"),E=G("p",{class:"took"}),I=G("button",{type:"button",class:"drawer",id:"drawer","aria-expanded":"false",onclick:()=>oe(!i.classList.contains("open"))},"Settings"),D=Si("Camera",Vo.filter(rt=>Qv[rt]).map(rt=>[rt,Qv[rt]]),"impact",rt=>V.setCamera(rt)),M=Si("Two robots",[["side","side by side"],["ghost","overlaid"]],"side",rt=>V.setCompare(rt)),w=G("h2"),T=Si("Plots show",[["impact","impact"],["all","all"]],"impact",rt=>{r=rt==="all",n&&xt()}),B=yl(()=>H,()=>vt(["This browser refuses full screen."])),H=G("div",{class:"middle"},G("div",{class:"frame"},v,G("div",{class:"views"},D,M,B.button),g),d,S);i.classList.add("lab"),i.replaceChildren(G("header",{class:"top"},G("div",{class:"said"},G("h1",{},"Impact lab",...t.file?[G("small",{},t.file)]:[]),l,c),G("div",{class:"actions"},f,p,m,G("span",{class:"linking"},u,h))),G("main",{},G("aside",{class:"settings",id:"settings"},a.element,E),H,G("aside",{class:"curves"},y,G("div",{class:"plot-head"},w,P,T),b)),I);let V=iu(v,{onCamera:rt=>D.mark(rt)}),W=Zv(b,{onSeek:rt=>(X.pause(),X.seek(rt))}),X=Gh({scene:V,plots:{show:W.show,replace:()=>xt()},bar:d,actions:{f:B.toggle}}),F=jv(S),z=Jv(y,{choices:t.sweeps,table:t.controls,page:e,isShown:a.isShown,onPick:a.pick,onChoice:()=>n&&he(n.query,{settled:!0})}),J=Xv(e,{answered:ft,refused:bt,waits:Gt,gone:de}),nt=0,et=!1;function ct(rt,Q,ut){clearTimeout(nt);let St=()=>J.ask(a.query(),{...ut,since:performance.now()});ut.typing?nt=setTimeout(St,BT):St()}function ft(rt,Q){let ut=n;n=rt,i.classList.add("ready"),Q.aside||vt([]),g.hidden=!0,Q.typing?a.tellProblems([]):a.show(rt.settings);let St=!ut||ut.settings.mode!==rt.settings.mode,C=rt.flights.length!==ut?.flights.length,x=rt.flights.flatMap(N=>N.second?[N.second]:[]);V.replace([...rt.flights.map(N=>N.scene),...x],{keepCamera:!St&&!C}),M.hidden=rt.flights.length<2,St&&T.mark((r=rt.is_piloted)?"all":"impact"),et=!!Q.moving,X.replace({keepTime:!St}),St&&yt(),tt(),$(),z.show(rt,Q),m.replaceChildren(...rt.flights.map(N=>G("a",{class:"button",href:`scenario.toml?${[rt.query,`of=${N.robot}`].filter(Boolean).join("&")}`,download:N.file,title:`Scenario for springback fly, ${N.label}`},`${N.label}.toml`))),he(rt.query,Q),requestAnimationFrame(()=>{let N=performance.now()-Q.since;o.push(N),E.textContent=`Flown in ${rt.took.flying.toFixed(0)} ms, answered in ${rt.took.all.toFixed(0)} ms, drawn after ${N.toFixed(0)} ms.`})}function yt(){let rt=Cs(V.flights[0]),Q=!n.is_piloted,ut=Q?"impact":"follow";D.mark(ut),V.setCamera(ut),X.seek(rt===null?V.flights[0].begin:Q?rt+OT:rt)}function xt(){n&&(w.textContent=r?"Time [s]":"Time from touch [ms]",W.replace(V.flights,{whole:r,moving:et}))}function tt(){l.replaceChildren(...n.flights.map((rt,Q)=>{let ut=G("p",{class:`outcome ${rt.well?"well":"badly"}`},G("b",{},rt.label),rt.sentence.slice(rt.label.length));return ut.style.setProperty("--colour",V.flights[Q].colour),ut}))}let $=()=>F.show(n,s,V.flights.map(rt=>rt.colour));function mt(){let rt=P.getAttribute("aria-pressed")!=="true";P.setAttribute("aria-pressed",String(rt)),W.lock(rt),xt()}function vt(rt){c.hidden=!rt.length,c.textContent=rt.join(" ")}function bt(rt,Q){g.hidden=!0,a.tellProblems(rt),vt([...rt.map(ut=>`${ut}.`),n?"The previous flight is shown.":"The default flight is shown instead."]),n||J.ask("",{since:performance.now(),aside:!0})}function Gt(rt){g.hidden=!1,g.replaceChildren(G("progress",{}),G("p",{},`Compiling for ${rt.what}, about ${rt.about} s: ${Math.round(rt.waited)} s so far.`),G("p",{class:"words"},`Once on this machine; ${n?"the previous flight stays, and ":""}other settings can be flown meanwhile if they are ready.`))}function de(){vt(["The lab does not respond; it may have been stopped in its terminal. Any change tries again."])}let k=!1;function he(rt,{settled:Q=!1,aside:ut=!1,restored:St=!1}){let C=`${location.pathname}${rt?`?${rt}`:""}${z.hash()}`;u.value=location.origin+C,!(ut||St)&&(`${location.pathname}${location.search}${location.hash}`!==C&&(k?history.replaceState(null,"",C):history.pushState(null,"",C)),k=!Q)}function st(rt,{push:Q=!1}={}){J.ask(rt,{since:performance.now(),settled:Q,restored:!Q})}addEventListener("popstate",()=>(z.restore(location.hash),st(location.search.slice(1))));async function wt(){try{await navigator.clipboard.writeText(u.value)}catch{u.select(),document.execCommand("copy")}h.textContent="Copied",setTimeout(()=>h.textContent="Copy link",1500)}function Pt(){s=s?null:n,f.setAttribute("aria-pressed",String(!!s)),f.textContent=s?"Unpin":"Pin";let rt=s?kd(s.flights.map(Q=>({...Q.scene})),Hn()):[];W.pin(rt),xt(),$()}function oe(rt){i.classList.toggle("open",rt),I.setAttribute("aria-expanded",String(rt)),I.textContent=rt?"Done":"Settings",rt&&v.scrollIntoView({block:"start"})}return a.show(Object.fromEntries(t.controls.map(rt=>[rt.name,rt.default]))),z.restore(location.hash),st(location.search.slice(1)),window.springback={scene:V,player:X,plots:W,controls:a,sweep:z,latency:o,pose:()=>({...V.pose(),playing:X.playing,pace:X.pace}),get answer(){return n}},window.springback}var zT={replay:Hv,lab:t_};function e_(){let i=zT[document.body.dataset.app],t=document.getElementById("data");i&&i(document.getElementById("app"),t?JSON.parse(t.textContent):{})}document.readyState==="loading"?document.addEventListener("DOMContentLoaded",e_):e_();})();
