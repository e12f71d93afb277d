const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=["./boat-DORtwM3C.js","./three.core-BWW9jns8.js","./value_reader-DqdNRaa2.js","./character-D1qa07sR.js","./destruction-BqBWabhl.js","./module_renderer-LVa06Nj3.js","./fields-BvRz8Tp0.js","./hovercraft-Cj2ozCZT.js","./ragdoll-BQIEZOv8.js","./vehicle-wLzOpZRd.js","./players_panel-Bk36jZnu.js","./identity-DH0PFGjC.js","./text-JHe4DEUZ.js","./identity_panel-DFD26-B2.js","./room_panel-DS5cqr15.js","./src-BQ7cTmD2.js","./describe_inspected-GMI-0Jl4.js","./line_plot-BGVVLUil.js","./elements-CP8yiCN9.js","./inspector_panel-Bnu8PzVg.js","./plots_panel-CCxX14jf.js","./time_panel-C-iAyApW.js","./prediction-Cr37pRhx.js","./lobby_panel-Da-fVIOj.js","./describe_events-CRn1Is0D.js","./stats-DGkkpex8.js","./events-uhH-c3T7.js"])))=>i.map(i=>d[i]);
import{_ as e,a as t,b as n,c as r,d as i,f as a,g as o,i as s,l as c,m as l,n as u,o as d,p as f,r as p,s as m,t as h,u as g,v as _,x as v,y}from"./src-BQ7cTmD2.js";import{$ as b,$t as x,A as S,An as C,Bn as w,C as T,Cn as E,D,E as O,En as k,F as A,Fn as j,G as M,Gn as N,H as ee,Hn as te,I as ne,In as re,J as ie,Jn as P,K as ae,Kn as F,L as oe,Ln as se,M as ce,Mn as le,Nn as ue,O as de,On as fe,P as pe,Pn as I,Q as L,Qt as me,R as he,Rn as ge,S as _e,Sn as ve,St as ye,T as be,Tn as xe,U as Se,Un as R,V as Ce,Vn as we,W as Te,Wn as Ee,X as De,Xn as z,Y as Oe,Yn as ke,Z as Ae,Zn as je,_ as Me,_n as Ne,_t as Pe,a as Fe,an as Ie,at as Le,b as B,bn as Re,c as ze,ct as Be,d as Ve,dn as He,dt as V,en as Ue,et as H,f as U,fn as We,ft as Ge,g as Ke,gn as qe,h as Je,ht as W,i as Ye,in as Xe,it as Ze,j as Qe,jn as $e,k as et,l as tt,lt as nt,m as rt,mn as it,mt as at,n as ot,nn as st,nt as ct,o as lt,on as ut,ot as dt,p as ft,pn as pt,pt as mt,q as ht,qn as gt,r as _t,rt as vt,st as yt,tn as bt,tt as xt,u as G,ut as St,v as Ct,vn as wt,w as Tt,wn as Et,x as Dt,xn as Ot,xt as kt,y as At,yn as jt,z as Mt,zn as Nt}from"./three.core-BWW9jns8.js";import{a as Pt,i as Ft,n as It,o as Lt,r as Rt}from"./identity-DH0PFGjC.js";import{n as zt,r as Bt,t as Vt}from"./text-JHe4DEUZ.js";var Ht=`modulepreload`,Ut=function(e,t){return new URL(e,t).href},Wt={},Gt=function(e){return e.pathname.endsWith(`.css`)},Kt=function(e,t,n){if(t in e)return e[t];let r=n();if(!r){e[t]=void 0;return}let i=r.then(()=>{e[t]=void 0},n=>{throw e[t]=void 0,n});return e[t]=i,i},K=function(e,t,n){let r=Promise.resolve();if(t&&t.length>0){let e,i=document.querySelector(`meta[property=csp-nonce]`),a=i?.nonce||i?.getAttribute(`nonce`);function o(e){return Promise.all(e.map(e=>Promise.resolve(e).then(e=>({status:`fulfilled`,value:e}),e=>({status:`rejected`,reason:e}))))}function s(e){return import.meta.resolve?new URL(import.meta.resolve(e)):new URL(e,import.meta.url)}r=o(t.map(t=>{t=Ut(t,n);let r=s(t),i=Gt(r);return Kt(Wt,r.href,()=>{if(e===void 0){e={all:new Set,styles:new Set};let t=document.getElementsByTagName(`link`);for(let n=t.length-1;n>=0;n--){let r=t[n];e.all.add(r.href),r.rel===`stylesheet`&&e.styles.add(r.href)}}if((i?e.styles:e.all).has(r.href))return;let t=document.createElement(`link`);if(t.rel=i?`stylesheet`:Ht,i||(t.as=`script`),t.crossOrigin=``,t.href=r.href,a&&t.setAttribute(`nonce`,a),document.head.appendChild(t),i)return new Promise((e,n)=>{let i=a=>{t.removeEventListener(`load`,i),t.removeEventListener(`error`,i),a.type===`error`?n(Error(`Unable to preload CSS for ${r}`)):e(a)};t.addEventListener(`load`,i),t.addEventListener(`error`,i)})})}).filter(e=>e!==void 0))}function i(e){let t=new Event(`vite:preloadError`,{cancelable:!0});if(t.payload=e,window.dispatchEvent(t),!t.defaultPrevented)throw e}return r.then(t=>{for(let e of t||[])e.status===`rejected`&&i(e.reason);return e().catch(i)})};function qt(e,t,n,r,i,a,o,s){let c=r-1,l=(r,i)=>e[3*(t+r*n)+i],u=(e,t)=>e<0?2*l(0,t)-l(Math.min(1,c),t):e>c?2*l(c,t)-l(Math.max(0,c-1),t):l(e,t),d=o;for(let e=0;e<c;e++)for(let t=0;t<i;t++,d+=s){let n=t/i,[r,o]=[n*n,n*n*n];for(let t=0;t<3;t++)a[3*d+t]=.5*((-o+2*r-n)*u(e-1,t)+(3*o-5*r+2)*u(e,t)+(-3*o+4*r+n)*u(e+1,t)+(o-r)*u(e+2,t))}for(let e=0;e<3;e++)a[3*d+e]=l(c,e)}var Jt=(e,t)=>(e-1)*t+1;function Yt(e,t,n=0,r=e.length/3){if(r===0)return new Float32Array;let i=new Float32Array(3*Jt(r,t));return qt(e,n,1,r,t,i,0,1),i}function Xt(e,t,n,r){if(t===0||n===0)return new Float32Array;let i=Jt(t,r),a=new Float32Array(3*i*n);for(let o=0;o<n;o++)qt(e,o*t,1,t,r,a,o*i,1);let o=new Float32Array(3*i*Jt(n,r));for(let e=0;e<i;e++)qt(a,e,i,n,r,o,e,i);return o}var Zt=2e5,Qt=1e6,$t=25e4,en=class{recording;binaryType=``;onopen=null;onmessage=null;onclose=null;playing=!0;speed=1;renderTimeUs;firstUs;lastUs;lastFrameUs=0;next=0;welcomed=!1;seekUs;constructor(e){this.recording=e,this.firstUs=this.renderTimeUs=e.dueUs(e.firstTick),this.lastUs=e.dueUs(e.lastTick)}open(){return this.welcomed=!1,queueMicrotask(()=>this.onopen?.()),this}send(e){let{message:t}=y(r,e);if(t.case===`hello`)this.welcomed=!0,this.seekUs??=this.renderTimeUs;else if(t.case===`ping`){let{clientTimeUs:e}=t.value,r=n(f,{message:{case:`pong`,value:{clientTimeUs:e,serverTimeUs:BigInt(Math.round(this.renderTimeUs))}}});this.deliver(_(f,r))}}close(){this.welcomed=!1}get tick(){let{welcome:e,firstTick:t,lastTick:n}=this.recording,r=Math.round((this.renderTimeUs-this.firstUs)*e.tickHz/1e6);return Math.min(n,t+r)}get seconds(){return(this.renderTimeUs-this.firstUs)/1e6}get length(){return(this.lastUs-this.firstUs)/1e6}seek(e){this.seekUs=Math.min(this.lastUs,Math.max(this.firstUs,this.firstUs+e*1e6))}play(){this.renderTimeUs>=this.lastUs&&this.seek(0),this.playing=!0}advance(e){let t=Math.min($t,Math.max(0,e-this.lastFrameUs));if(this.lastFrameUs=e,!this.welcomed)return this.renderTimeUs;if(this.seekUs!==void 0){let e=this.seekUs-this.renderTimeUs;this.renderTimeUs=this.seekUs,this.seekUs=void 0,(this.next===0||e<0||e>Qt)&&this.begin()}else this.playing&&(this.renderTimeUs=Math.min(this.lastUs,this.renderTimeUs+t*this.speed),this.renderTimeUs>=this.lastUs&&(this.playing=!1));return this.deliverMessages(),this.renderTimeUs}begin(){let{messages:e}=this.recording,t=this.recording.keyframeBefore(this.recording.firstTick);for(let n=t;n<e.length;n++)e[n].keyframe&&e[n].dueUs<=this.renderTimeUs&&(t=n);this.deliver(e[0].bytes);for(let n=1;n<t;n++)e[n].persistent&&this.deliver(e[n].bytes);this.next=t}deliverMessages(){let{messages:e}=this.recording;for(;this.next<e.length&&e[this.next].dueUs<=this.renderTimeUs+Zt;this.next++)this.deliver(e[this.next].bytes)}deliver(e){this.onmessage?.({data:e.slice().buffer})}},tn={latencyMs:0,jitterMs:0,jitterTailMs:0,stallMs:0,stallIntervalMs:5e3,loss:0,lossBurst:1,retransmitMs:200,duplicate:0,reorder:0,reorderMs:20,rateKbps:0,seed:1};function nn(e){let{latencyMs:t,jitterMs:n,jitterTailMs:r,stallMs:i,loss:a,duplicate:o,reorder:s,rateKbps:c}=e;return[t,n,r,i,a,o,s,c].some(e=>e>0)}var rn=e=>Math.round(1e3*e),an=class{conditions;delivery;random;lastArrival=0;stall=0;free=0;started=!1;previousLost=!1;constructor(e,t=0,n=`stream`){this.conditions=e,this.delivery=n,this.random=e.seed^Math.imul(2654435769,t)}send(e,t=0){let{stallIntervalMs:n,retransmitMs:r,duplicate:i,reorder:a,reorderMs:o}=this.conditions;this.started||(this.started=!0,this.stall=e+rn(n*(.5+this.nextUniform())));let s=this.departure(e,t),c=this.nextTransitMs(),l=this.nextLost();if(l&&this.delivery===`datagrams`)return{copies:0,arrivalUs:0};if(l&&(c+=r),this.lastArrival=this.skipStalls(Math.max(s+rn(c),this.lastArrival)),this.delivery===`stream`)return{copies:1,arrivalUs:this.lastArrival};let u=i>0&&this.nextUniform()<i?2:1,d=a>0&&this.nextUniform()<a;return{copies:u,arrivalUs:this.lastArrival+(d?rn(o):0)}}departure(e,t){let{rateKbps:n}=this.conditions;return n>0?(this.free=Math.max(this.free,e)+8e3*t/n,Math.round(this.free)):e}nextTransitMs(){let{latencyMs:e,jitterMs:t,jitterTailMs:n}=this.conditions,r=e;return t>0&&(r+=t*this.nextUniform()),n>0&&(r-=n*Math.log(1-this.nextUniform())),r}nextLost(){let{loss:e,lossBurst:t}=this.conditions;if(!(e>0))return!1;let n=e;return t>1&&e<1&&(n=this.previousLost?1-1/t:e/(t*(1-e))),this.previousLost=this.nextUniform()<n}skipStalls(e){let{stallMs:t,stallIntervalMs:n}=this.conditions;if(!(t>0))return e;let r=rn(t);for(;e>=this.stall+r;)this.stall+=Math.max(rn(n*(.5+this.nextUniform())),r+1e3);return e>=this.stall?this.stall+r:e}nextUniform(){this.random=this.random+1831565813|0;let e=Math.imul(this.random^this.random>>>15,this.random|1);return e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/2**32}},on=class{due=[];simulator;constructor(e,t){this.simulator=new an(e,t)}push(e,t){this.due.push({at:this.simulator.send(Math.round(v()),e).arrivalUs,deliver:t}),this.due.length===1&&this.schedule()}schedule(){setTimeout(()=>this.deliverDue(),Math.max(0,Math.ceil((this.due[0].at-v())/1e3)))}deliverDue(){for(;this.due.length>0&&this.due[0].at<=v();)this.due.shift().deliver();this.due.length>0&&this.schedule()}};function sn(e,t){return n=>{let r=e(n),i=new on(t,0),a=new on(t,1),o=!1,s={get binaryType(){return r.binaryType},set binaryType(e){r.binaryType=e},onopen:null,onmessage:null,onclose:null,send:e=>a.push(e.byteLength,()=>o||r.send(e)),close:()=>{o=!0,r.close()}};return r.onopen=()=>s.onopen?.(),r.onmessage=e=>i.push(e.data.byteLength,()=>s.onmessage?.(e)),r.onclose=e=>{o=!0,i.push(0,()=>s.onclose?.(e))},s}}function cn(){let e=null,t=!1,n=null,r=null;function i(t,a){r=e.requestAnimationFrame(i),n(t,a)}return{start:function(){t!==!0&&n!==null&&e!==null&&(r=e.requestAnimationFrame(i),t=!0)},stop:function(){e!==null&&e.cancelAnimationFrame(r),t=!1},setAnimationLoop:function(e){n=e},setContext:function(t){e=t}}}function ln(e){let t=new WeakMap;function n(t,n){let r=t.array,i=t.usage,a=r.byteLength,o=e.createBuffer();e.bindBuffer(n,o),e.bufferData(n,r,i),t.onUploadCallback();let s;if(r instanceof Float32Array)s=e.FLOAT;else if(typeof Float16Array<`u`&&r instanceof Float16Array)s=e.HALF_FLOAT;else if(r instanceof Uint16Array)s=t.isFloat16BufferAttribute?e.HALF_FLOAT:e.UNSIGNED_SHORT;else if(r instanceof Int16Array)s=e.SHORT;else if(r instanceof Uint32Array)s=e.UNSIGNED_INT;else if(r instanceof Int32Array)s=e.INT;else if(r instanceof Int8Array)s=e.BYTE;else if(r instanceof Uint8Array)s=e.UNSIGNED_BYTE;else if(r instanceof Uint8ClampedArray)s=e.UNSIGNED_BYTE;else throw Error(`THREE.WebGLAttributes: Unsupported buffer data format: `+r);return{buffer:o,type:s,bytesPerElement:r.BYTES_PER_ELEMENT,version:t.version,size:a}}function r(t,n,r){let i=n.array,a=n.updateRanges;if(e.bindBuffer(r,t),a.length===0)e.bufferSubData(r,0,i);else{a.sort((e,t)=>e.start-t.start);let t=0;for(let e=1;e<a.length;e++){let n=a[t],r=a[e];r.start<=n.start+n.count+1?n.count=Math.max(n.count,r.start+r.count-n.start):(++t,a[t]=r)}a.length=t+1;for(let t=0,n=a.length;t<n;t++){let n=a[t];e.bufferSubData(r,n.start*i.BYTES_PER_ELEMENT,i,n.start,n.count)}n.clearUpdateRanges()}n.onUploadCallback()}function i(e){return e.isInterleavedBufferAttribute&&(e=e.data),t.get(e)}function a(n){n.isInterleavedBufferAttribute&&(n=n.data);let r=t.get(n);r&&(e.deleteBuffer(r.buffer),t.delete(n))}function o(e,i){if(e.isInterleavedBufferAttribute&&(e=e.data),e.isGLBufferAttribute){let n=t.get(e);(!n||n.version<e.version)&&t.set(e,{buffer:e.buffer,type:e.type,bytesPerElement:e.elementSize,version:e.version});return}let a=t.get(e);if(a===void 0)t.set(e,n(e,i));else if(a.version<e.version){if(a.size!==e.array.byteLength)throw Error(`THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.`);r(a.buffer,e,i),a.version=e.version}}return{get:i,remove:a,update:o}}var q={alphahash_fragment:`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,alphahash_pars_fragment:`#ifdef USE_ALPHAHASH
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
#endif`,alphamap_fragment:`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,alphamap_pars_fragment:`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,alphatest_fragment:`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,alphatest_pars_fragment:`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,aomap_fragment:`#ifdef USE_AOMAP
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
#endif`,aomap_pars_fragment:`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,batching_pars_vertex:`#ifdef USE_BATCHING
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
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,batching_vertex:`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,begin_vertex:`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,beginnormal_vertex:`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,bsdfs:`float G_BlinnPhong_Implicit( ) {
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
} // validated`,iridescence_fragment:`#ifdef USE_IRIDESCENCE
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
#endif`,bumpmap_pars_fragment:`#ifdef USE_BUMPMAP
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
#endif`,clipping_planes_fragment:`#if NUM_CLIPPING_PLANES > 0
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
#endif`,clipping_planes_pars_fragment:`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,clipping_planes_pars_vertex:`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,clipping_planes_vertex:`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,color_fragment:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,color_pars_fragment:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,color_pars_vertex:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,color_vertex:`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,common:`#define PI 3.141592653589793
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
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
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
} // validated`,defaultnormal_vertex:`vec3 transformedNormal = objectNormal;
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
#endif`,displacementmap_pars_vertex:`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,displacementmap_vertex:`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,emissivemap_fragment:`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,emissivemap_pars_fragment:`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,colorspace_fragment:`gl_FragColor = linearToOutputTexel( gl_FragColor );`,colorspace_pars_fragment:`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,envmap_fragment:`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,envmap_common_pars_fragment:`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,envmap_pars_fragment:`#ifdef USE_ENVMAP
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
#endif`,envmap_pars_vertex:`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,envmap_physical_pars_fragment:`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,envmap_vertex:`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,fog_vertex:`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,fog_pars_vertex:`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,fog_fragment:`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,fog_pars_fragment:`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,gradientmap_pars_fragment:`#ifdef USE_GRADIENTMAP
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
}`,lightmap_pars_fragment:`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,lights_lambert_fragment:`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lights_lambert_pars_fragment:`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,lights_pars_begin:`uniform bool receiveShadow;
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
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
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
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
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
#endif
#include <lightprobes_pars_fragment>`,lights_toon_fragment:`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lights_toon_pars_fragment:`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,lights_phong_fragment:`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,lights_phong_pars_fragment:`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,lights_physical_fragment:`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
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
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
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
#endif`,lights_physical_pars_fragment:`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
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
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
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
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
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
		return 0.5 / max( gv + gl, EPSILON );
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
		float roughness = max( material.clearcoatRoughness, 0.045 );
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
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
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
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
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
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
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
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
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
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,lights_fragment_begin:`
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
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
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
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,lights_fragment_maps:`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,lights_fragment_end:`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lightprobes_pars_fragment:`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,logdepthbuf_fragment:`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,logdepthbuf_pars_fragment:`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,logdepthbuf_pars_vertex:`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,logdepthbuf_vertex:`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,map_fragment:`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,map_pars_fragment:`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,map_particle_fragment:`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,map_particle_pars_fragment:`#if defined( USE_POINTS_UV )
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
#endif`,metalnessmap_fragment:`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,metalnessmap_pars_fragment:`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,morphinstance_vertex:`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,morphcolor_vertex:`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,morphnormal_vertex:`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,morphtarget_pars_vertex:`#ifdef USE_MORPHTARGETS
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
#endif`,morphtarget_vertex:`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,normal_fragment_begin:`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#ifdef DOUBLE_SIDED
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
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,normal_fragment_maps:`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,normal_pars_fragment:`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,normal_pars_vertex:`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,normal_vertex:`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,normalmap_pars_fragment:`#ifdef USE_NORMALMAP
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
#endif`,clearcoat_normal_fragment_begin:`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,clearcoat_normal_fragment_maps:`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,clearcoat_pars_fragment:`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iridescence_pars_fragment:`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,opaque_fragment:`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,packing:`vec3 packNormalToRGB( const in vec3 normal ) {
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,premultiplied_alpha_fragment:`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,project_vertex:`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,dithering_fragment:`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,dithering_pars_fragment:`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,roughnessmap_fragment:`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,roughnessmap_pars_fragment:`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,shadowmap_pars_fragment:`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
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
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,shadowmap_pars_vertex:`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
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
#endif`,shadowmap_vertex:`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
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
#endif`,shadowmask_pars_fragment:`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
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
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
}`,skinbase_vertex:`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,skinning_pars_vertex:`#ifdef USE_SKINNING
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
#endif`,skinning_vertex:`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,skinnormal_vertex:`#ifdef USE_SKINNING
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
#endif`,specularmap_fragment:`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,specularmap_pars_fragment:`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,tonemapping_fragment:`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,tonemapping_pars_fragment:`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,transmission_fragment:`#ifdef USE_TRANSMISSION
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
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,transmission_pars_fragment:`#ifdef USE_TRANSMISSION
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
#endif`,uv_pars_fragment:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,uv_pars_vertex:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,uv_vertex:`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
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
#endif`,worldpos_vertex:`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,background_vert:`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,background_frag:`uniform sampler2D t2D;
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
}`,backgroundCube_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,backgroundCube_frag:`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cube_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cube_frag:`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,depth_vert:`#include <common>
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
}`,depth_frag:`#if DEPTH_PACKING == 3200
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
}`,distance_vert:`#define DISTANCE
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
}`,distance_frag:`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,equirect_vert:`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,equirect_frag:`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,linedashed_vert:`uniform float scale;
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
}`,linedashed_frag:`uniform vec3 diffuse;
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
}`,meshbasic_vert:`#include <common>
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
}`,meshbasic_frag:`uniform vec3 diffuse;
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
}`,meshlambert_vert:`#define LAMBERT
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
}`,meshlambert_frag:`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,meshmatcap_vert:`#define MATCAP
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
}`,meshmatcap_frag:`#define MATCAP
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
}`,meshnormal_vert:`#define NORMAL
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
}`,meshnormal_frag:`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
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
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,meshphong_vert:`#define PHONG
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
}`,meshphong_frag:`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,meshphysical_vert:`#define STANDARD
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
}`,meshphysical_frag:`#define STANDARD
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
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
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
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
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
}`,meshtoon_vert:`#define TOON
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
}`,meshtoon_frag:`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
}`,points_vert:`uniform float size;
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
}`,points_frag:`uniform vec3 diffuse;
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
}`,shadow_vert:`#include <common>
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
}`,shadow_frag:`uniform vec3 color;
uniform float opacity;
#include <common>
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
	#include <premultiplied_alpha_fragment>
}`,sprite_vert:`uniform float rotation;
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
}`,sprite_frag:`uniform vec3 diffuse;
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
}`},J={common:{diffuse:{value:new G(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new L},alphaMap:{value:null},alphaMapTransform:{value:new L},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new L}},envmap:{envMap:{value:null},envMapRotation:{value:new L},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new L}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new L}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new L},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new L},normalScale:{value:new I(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new L},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new L}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new L}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new L}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new G(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new G(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new L},alphaTest:{value:0},uvTransform:{value:new L}},sprite:{diffuse:{value:new G(16777215)},opacity:{value:1},center:{value:new I(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new L},alphaMap:{value:null},alphaMapTransform:{value:new L},alphaTest:{value:0}}},un={basic:{uniforms:P([J.common,J.specularmap,J.envmap,J.aomap,J.lightmap,J.fog]),vertexShader:q.meshbasic_vert,fragmentShader:q.meshbasic_frag},lambert:{uniforms:P([J.common,J.specularmap,J.envmap,J.aomap,J.lightmap,J.emissivemap,J.bumpmap,J.normalmap,J.displacementmap,J.fog,J.lights,{emissive:{value:new G(0)},envMapIntensity:{value:1}}]),vertexShader:q.meshlambert_vert,fragmentShader:q.meshlambert_frag},phong:{uniforms:P([J.common,J.specularmap,J.envmap,J.aomap,J.lightmap,J.emissivemap,J.bumpmap,J.normalmap,J.displacementmap,J.fog,J.lights,{emissive:{value:new G(0)},specular:{value:new G(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:q.meshphong_vert,fragmentShader:q.meshphong_frag},standard:{uniforms:P([J.common,J.envmap,J.aomap,J.lightmap,J.emissivemap,J.bumpmap,J.normalmap,J.displacementmap,J.roughnessmap,J.metalnessmap,J.fog,J.lights,{emissive:{value:new G(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:q.meshphysical_vert,fragmentShader:q.meshphysical_frag},toon:{uniforms:P([J.common,J.aomap,J.lightmap,J.emissivemap,J.bumpmap,J.normalmap,J.displacementmap,J.gradientmap,J.fog,J.lights,{emissive:{value:new G(0)}}]),vertexShader:q.meshtoon_vert,fragmentShader:q.meshtoon_frag},matcap:{uniforms:P([J.common,J.bumpmap,J.normalmap,J.displacementmap,J.fog,{matcap:{value:null}}]),vertexShader:q.meshmatcap_vert,fragmentShader:q.meshmatcap_frag},points:{uniforms:P([J.points,J.fog]),vertexShader:q.points_vert,fragmentShader:q.points_frag},dashed:{uniforms:P([J.common,J.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:q.linedashed_vert,fragmentShader:q.linedashed_frag},depth:{uniforms:P([J.common,J.displacementmap]),vertexShader:q.depth_vert,fragmentShader:q.depth_frag},normal:{uniforms:P([J.common,J.bumpmap,J.normalmap,J.displacementmap,{opacity:{value:1}}]),vertexShader:q.meshnormal_vert,fragmentShader:q.meshnormal_frag},sprite:{uniforms:P([J.sprite,J.fog]),vertexShader:q.sprite_vert,fragmentShader:q.sprite_frag},background:{uniforms:{uvTransform:{value:new L},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:q.background_vert,fragmentShader:q.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new L}},vertexShader:q.backgroundCube_vert,fragmentShader:q.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:q.cube_vert,fragmentShader:q.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:q.equirect_vert,fragmentShader:q.equirect_frag},distance:{uniforms:P([J.common,J.displacementmap,{referencePosition:{value:new j},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:q.distance_vert,fragmentShader:q.distance_frag},shadow:{uniforms:P([J.lights,J.fog,{color:{value:new G(0)},opacity:{value:1}}]),vertexShader:q.shadow_vert,fragmentShader:q.shadow_frag}};un.physical={uniforms:P([un.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new L},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new L},clearcoatNormalScale:{value:new I(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new L},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new L},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new L},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new L},sheen:{value:0},sheenColor:{value:new G(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new L},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new L},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new L},transmissionSamplerSize:{value:new I},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new L},attenuationDistance:{value:0},attenuationColor:{value:new G(0)},specularColor:{value:new G(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new L},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new L},anisotropyVector:{value:new I},anisotropyMap:{value:null},anisotropyMapTransform:{value:new L}}]),vertexShader:q.meshphysical_vert,fragmentShader:q.meshphysical_frag};var dn={r:0,b:0,g:0},fn=new b,pn=new L;pn.set(-1,0,0,0,1,0,0,0,1);function mn(e,t,n,r,i,a){let o=new G(0),s=i===!0?0:1,c,l,u=null,d=0,f=null;function p(e){let n=e.isScene===!0?e.background:null;if(n&&n.isTexture){let r=e.backgroundBlurriness>0;n=t.get(n,r)}return n}function m(t){let r=!1,i=p(t);i===null?g(o,s):i&&i.isColor&&(g(i,1),r=!0);let c=e.xr.getEnvironmentBlendMode();c===`additive`?n.buffers.color.setClear(0,0,0,1,a):c===`alpha-blend`&&n.buffers.color.setClear(0,0,0,0,a),(e.autoClear||r)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),e.clear(e.autoClearColor,e.autoClearDepth,e.autoClearStencil))}function h(t,n){let i=p(n);i&&i.isCubeTexture?(l===void 0&&(l=new H(new Ye(1,1,1),new it({name:`BackgroundCubeMaterial`,uniforms:w(un.backgroundCube.uniforms),vertexShader:un.backgroundCube.vertexShader,fragmentShader:un.backgroundCube.fragmentShader,side:1,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute(`normal`),l.geometry.deleteAttribute(`uv`),l.onBeforeRender=function(e,t,n){this.matrixWorld.copyPosition(n.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),r.update(l)),l.material.uniforms.envMap.value=i,l.material.uniforms.backgroundBlurriness.value=n.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=n.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(fn.makeRotationFromEuler(n.backgroundRotation)).transpose(),i.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(pn),l.material.toneMapped=Ve.getTransfer(i.colorSpace)!==We,(u!==i||d!==i.version||f!==e.toneMapping)&&(l.material.needsUpdate=!0,u=i,d=i.version,f=e.toneMapping),l.layers.enableAll(),t.unshift(l,l.geometry,l.material,0,0,null)):i&&i.isTexture&&(c===void 0&&(c=new H(new Ge(2,2),new it({name:`BackgroundMaterial`,uniforms:w(un.background.uniforms),vertexShader:un.background.vertexShader,fragmentShader:un.background.fragmentShader,side:0,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute(`normal`),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),r.update(c)),c.material.uniforms.t2D.value=i,c.material.uniforms.backgroundIntensity.value=n.backgroundIntensity,c.material.toneMapped=Ve.getTransfer(i.colorSpace)!==We,i.matrixAutoUpdate===!0&&i.updateMatrix(),c.material.uniforms.uvTransform.value.copy(i.matrix),(u!==i||d!==i.version||f!==e.toneMapping)&&(c.material.needsUpdate=!0,u=i,d=i.version,f=e.toneMapping),c.layers.enableAll(),t.unshift(c,c.geometry,c.material,0,0,null))}function g(t,r){t.getRGB(dn,F(e)),n.buffers.color.setClear(dn.r,dn.g,dn.b,r,a)}function _(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(e,t=1){o.set(e),s=t,g(o,s)},getClearAlpha:function(){return s},setClearAlpha:function(e){s=e,g(o,s)},render:m,addToRenderList:h,dispose:_}}function hn(e,t){let n=e.getParameter(e.MAX_VERTEX_ATTRIBS),r={},i=f(null),a=i,o=!1;function s(n,r,i,s,c){let u=!1,f=d(n,s,i,r);a!==f&&(a=f,l(a.object)),u=p(n,s,i,c),u&&m(n,s,i,c),c!==null&&t.update(c,e.ELEMENT_ARRAY_BUFFER),(u||o)&&(o=!1,b(n,r,i,s),c!==null&&e.bindBuffer(e.ELEMENT_ARRAY_BUFFER,t.get(c).buffer))}function c(){return e.createVertexArray()}function l(t){return e.bindVertexArray(t)}function u(t){return e.deleteVertexArray(t)}function d(e,t,n,i){let a=i.wireframe===!0,o=r[t.id];o===void 0&&(o={},r[t.id]=o);let s=e.isInstancedMesh===!0?e.id:0,l=o[s];l===void 0&&(l={},o[s]=l);let u=l[n.id];u===void 0&&(u={},l[n.id]=u);let d=u[a];return d===void 0&&(d=f(c()),u[a]=d),d}function f(e){let t=[],r=[],i=[];for(let e=0;e<n;e++)t[e]=0,r[e]=0,i[e]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:t,enabledAttributes:r,attributeDivisors:i,object:e,attributes:{},index:null}}function p(e,t,n,r){let i=a.attributes,o=t.attributes,s=0,c=n.getAttributes();for(let t in c)if(c[t].location>=0){let n=i[t],r=o[t];if(r===void 0&&(t===`instanceMatrix`&&e.instanceMatrix&&(r=e.instanceMatrix),t===`instanceColor`&&e.instanceColor&&(r=e.instanceColor)),n===void 0||n.attribute!==r||r&&n.data!==r.data)return!0;s++}return a.attributesNum!==s||a.index!==r}function m(e,t,n,r){let i={},o=t.attributes,s=0,c=n.getAttributes();for(let t in c)if(c[t].location>=0){let n=o[t];n===void 0&&(t===`instanceMatrix`&&e.instanceMatrix&&(n=e.instanceMatrix),t===`instanceColor`&&e.instanceColor&&(n=e.instanceColor));let r={};r.attribute=n,n&&n.data&&(r.data=n.data),i[t]=r,s++}a.attributes=i,a.attributesNum=s,a.index=r}function h(){let e=a.newAttributes;for(let t=0,n=e.length;t<n;t++)e[t]=0}function g(e){_(e,0)}function _(t,n){let r=a.newAttributes,i=a.enabledAttributes,o=a.attributeDivisors;r[t]=1,i[t]===0&&(e.enableVertexAttribArray(t),i[t]=1),o[t]!==n&&(e.vertexAttribDivisor(t,n),o[t]=n)}function v(){let t=a.newAttributes,n=a.enabledAttributes;for(let r=0,i=n.length;r<i;r++)n[r]!==t[r]&&(e.disableVertexAttribArray(r),n[r]=0)}function y(t,n,r,i,a,o,s){s===!0?e.vertexAttribIPointer(t,n,r,a,o):e.vertexAttribPointer(t,n,r,i,a,o)}function b(n,r,i,a){h();let o=a.attributes,s=i.getAttributes(),c=r.defaultAttributeValues;for(let r in s){let i=s[r];if(i.location>=0){let s=o[r];if(s===void 0&&(r===`instanceMatrix`&&n.instanceMatrix&&(s=n.instanceMatrix),r===`instanceColor`&&n.instanceColor&&(s=n.instanceColor)),s!==void 0){let r=s.normalized,o=s.itemSize,c=t.get(s);if(c===void 0)continue;let l=c.buffer,u=c.type,d=c.bytesPerElement,f=u===e.INT||u===e.UNSIGNED_INT||s.gpuType===1013;if(s.isInterleavedBufferAttribute){let t=s.data,c=t.isInterleavedBuffer===!0?t.stride:t.itemSize,p=s.offset;if(t.isInstancedInterleavedBuffer||t.isInstancedBufferAttribute){for(let e=0;e<i.locationSize;e++)_(i.location+e,t.meshPerAttribute);n.isInstancedMesh!==!0&&a._maxInstanceCount===void 0&&(a._maxInstanceCount=t.meshPerAttribute*t.count)}else for(let e=0;e<i.locationSize;e++)g(i.location+e);e.bindBuffer(e.ARRAY_BUFFER,l);for(let e=0;e<i.locationSize;e++)y(i.location+e,o/i.locationSize,u,r,c*d,(p+o/i.locationSize*e)*d,f)}else{if(s.isInstancedBufferAttribute){for(let e=0;e<i.locationSize;e++)_(i.location+e,s.meshPerAttribute);n.isInstancedMesh!==!0&&a._maxInstanceCount===void 0&&(a._maxInstanceCount=s.meshPerAttribute*s.count)}else for(let e=0;e<i.locationSize;e++)g(i.location+e);e.bindBuffer(e.ARRAY_BUFFER,l);for(let e=0;e<i.locationSize;e++)y(i.location+e,o/i.locationSize,u,r,o*d,o/i.locationSize*e*d,f)}}else if(c!==void 0){let t=c[r];if(t!==void 0)switch(t.length){case 2:e.vertexAttrib2fv(i.location,t);break;case 3:e.vertexAttrib3fv(i.location,t);break;case 4:e.vertexAttrib4fv(i.location,t);break;default:e.vertexAttrib1fv(i.location,t)}}}}v()}function x(){T();for(let e in r){let t=r[e];for(let e in t){let n=t[e];for(let e in n){let t=n[e];for(let e in t)u(t[e].object),delete t[e];delete n[e]}}delete r[e]}}function S(e){if(r[e.id]===void 0)return;let t=r[e.id];for(let e in t){let n=t[e];for(let e in n){let t=n[e];for(let e in t)u(t[e].object),delete t[e];delete n[e]}}delete r[e.id]}function C(e){for(let t in r){let n=r[t];for(let t in n){let r=n[t];if(r[e.id]===void 0)continue;let i=r[e.id];for(let e in i)u(i[e].object),delete i[e];delete r[e.id]}}}function w(e){for(let t in r){let n=r[t],i=e.isInstancedMesh===!0?e.id:0,a=n[i];if(a!==void 0){for(let e in a){let t=a[e];for(let e in t)u(t[e].object),delete t[e];delete a[e]}delete n[i],Object.keys(n).length===0&&delete r[t]}}}function T(){E(),o=!0,a!==i&&(a=i,l(a.object))}function E(){i.geometry=null,i.program=null,i.wireframe=!1}return{setup:s,reset:T,resetDefaultState:E,dispose:x,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:C,initAttributes:h,enableAttribute:g,disableUnusedAttributes:v}}function gn(e,t,n){let r;function i(e){r=e}function a(t,i){e.drawArrays(r,t,i),n.update(i,r,1)}function o(t,i,a){a!==0&&(e.drawArraysInstanced(r,t,i,a),n.update(i,r,a))}function s(e,i,a){if(a===0)return;t.get(`WEBGL_multi_draw`).multiDrawArraysWEBGL(r,e,0,i,0,a);let o=0;for(let e=0;e<a;e++)o+=i[e];n.update(o,r,1)}this.setMode=i,this.render=a,this.renderInstances=o,this.renderMultiDraw=s}function _n(e,t,n,r){let i;function a(){if(i!==void 0)return i;if(t.has(`EXT_texture_filter_anisotropic`)===!0){let n=t.get(`EXT_texture_filter_anisotropic`);i=e.getParameter(n.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else i=0;return i}function o(t){return t===1023||r.convert(t)===e.getParameter(e.IMPLEMENTATION_COLOR_READ_FORMAT)}function s(n){let i=n===1016&&(t.has(`EXT_color_buffer_half_float`)||t.has(`EXT_color_buffer_float`));return!(n!==1009&&n!==1015&&!i&&r.convert(n)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_TYPE))}function c(t){if(t===`highp`){if(e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.HIGH_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.HIGH_FLOAT).precision>0)return`highp`;t=`mediump`}return t===`mediump`&&e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.MEDIUM_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.MEDIUM_FLOAT).precision>0?`mediump`:`lowp`}let l=n.precision===void 0?`highp`:n.precision,u=c(l);u!==l&&(z(`WebGLRenderer:`,l,`not supported, using`,u,`instead.`),l=u);let d=n.reversedDepthBuffer===!0&&t.has(`EXT_clip_control`),f=n.logarithmicDepthBuffer===!0&&d===!1;n.reversedDepthBuffer===!0&&d===!1&&z(`WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.`),n.logarithmicDepthBuffer===!0&&d===!0&&z(`WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.`);let p=e.getParameter(e.MAX_TEXTURE_IMAGE_UNITS),m=e.getParameter(e.MAX_VERTEX_TEXTURE_IMAGE_UNITS),h=e.getParameter(e.MAX_TEXTURE_SIZE),g=e.getParameter(e.MAX_CUBE_MAP_TEXTURE_SIZE),_=e.getParameter(e.MAX_VERTEX_ATTRIBS),v=e.getParameter(e.MAX_VERTEX_UNIFORM_VECTORS),y=e.getParameter(e.MAX_VARYING_VECTORS),b=e.getParameter(e.MAX_FRAGMENT_UNIFORM_VECTORS),x=e.getParameter(e.MAX_SAMPLES),S=e.getParameter(e.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:a,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:s,precision:l,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:m,maxTextureSize:h,maxCubemapSize:g,maxAttributes:_,maxVertexUniforms:v,maxVaryings:y,maxFragmentUniforms:b,maxSamples:x,samples:S}}function vn(e){let t=this,n=null,r=0,i=!1,a=!1,o=new V,s=new L,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(e,t){let n=e.length!==0||t||r!==0||i;return i=t,r=e.length,n},this.beginShadows=function(){a=!0,u(null)},this.endShadows=function(){a=!1},this.setGlobalState=function(e,t){n=u(e,t,0)},this.setState=function(t,o,s){let d=t.clippingPlanes,f=t.clipIntersection,p=t.clipShadows,m=e.get(t);if(!i||d===null||d.length===0||a&&!p)a?u(null):l();else{let e=a?0:r,t=e*4,i=m.clippingState||null;c.value=i,i=u(d,o,t,s);for(let e=0;e!==t;++e)i[e]=n[e];m.clippingState=i,this.numIntersection=f?this.numPlanes:0,this.numPlanes+=e}};function l(){c.value!==n&&(c.value=n,c.needsUpdate=r>0),t.numPlanes=r,t.numIntersection=0}function u(e,n,r,i){let a=e===null?0:e.length,l=null;if(a!==0){if(l=c.value,i!==!0||l===null){let t=r+a*4,i=n.matrixWorldInverse;s.getNormalMatrix(i),(l===null||l.length<t)&&(l=new Float32Array(t));for(let t=0,n=r;t!==a;++t,n+=4)o.copy(e[t]).applyMatrix4(i,s),o.normal.toArray(l,n),l[n+3]=o.constant}c.value=l,c.needsUpdate=!0}return t.numPlanes=a,t.numIntersection=0,l}}var yn=class extends ge{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new Ke(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new Ye(5,5,5),i=new it({name:`CubemapFromEquirect`,uniforms:w(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:1,blending:0});i.uniforms.tEquirect.value=t;let a=new H(r,i),o=t.minFilter;return t.minFilter===1008&&(t.minFilter=M),new rt(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let i=e.getRenderTarget();for(let i=0;i<6;i++)e.setRenderTarget(this,i),e.clear(t,n,r);e.setRenderTarget(i)}},bn=256,xn=3,Sn=20,Cn=256,wn=16,Tn=3,En=new j,Dn=new G,On=class e{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new rt(1,10,null),this._boxMesh=new H(new Ye(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,i={}){let{size:a=256,position:o=En}=i,s=this._renderer;this._setSize(a);let c=this._allocateTarget(),l=this._getSourceTarget(!0);t>0&&(l.texture.mipmapsAutoUpdate=!1);let u=s.autoClear,d=s.autoClearColor,f=s.autoClearDepth,p=s.autoClearStencil,m=e.background;s.autoClear=!0,s.autoClearColor=!0,s.autoClearDepth=!0,s.autoClearStencil=!0,m===null&&(e.background=s.getClearColor(Dn));let h=new rt(n,r,l);return h.position.copy(o),h.update(s,e),s.autoClear=u,s.autoClearColor=d,s.autoClearDepth=f,s.autoClearStencil=p,e.background=m,t>0&&(l.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Fn(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Pn(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(bn,Ee(e))}_fromTexture(e,t){e.mapping===301||e.mapping===302?this._setSize(e.image.length===0?bn:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=kn(e,!1,!1),n=Math.log2(e)-xn;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name=`PMREM`,t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=kn(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,i=this._cubeCamera;r.material=n,i.renderTarget=e,i.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),i.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===301||e.mapping===302?(this._cubemapMaterial===null&&(this._cubemapMaterial=Fn()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Pn()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=jn(),this._integrationMaterial=Mn());let n=this._cubeSize,r=t.texture.mipmaps.length-1,i=this._ggxMaterial.uniforms;i.envMap.value=this._sourceTarget.texture;let a=this._integrationMaterial.uniforms;a.envMap.value=this._sourceTarget.texture,a.sourceLod.value=Math.log2(n/wn);for(let o=0;o<=r;o++){let s=e.lodToRoughness(o,r);if(o>r-Tn)a.roughness.value=s,this._renderCube(t,o,this._integrationMaterial);else{let e=s>0?Math.log2(n)+.5*Math.log2(6/(Cn*s**4))+.5:0;i.roughness.value=s,i.lodBias.value=e,this._renderCube(t,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Nn());let n=this._blurMaterial,r=n.uniforms,i=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=i.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(i,0,n)}};function kn(e,t,n){return new yn(e,{minFilter:ae,generateMipmaps:t,type:A,colorSpace:ie,depthBuffer:n})}function An(e,t,n){return new it({name:e,uniforms:t,vertexShader:q.cube_vert,fragmentShader:n,side:1,blending:0,depthTest:!1,depthWrite:!1})}function jn(){return An(`PMREMGGXConvolution`,{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Cn}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Mn(){return An(`PMREMGGXIntegration`,{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:wn}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Nn(){return An(`PMREMSphericalGaussianBlur`,{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Sn}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Pn(){return An(`PMREMEquirectangularToCubemap`,{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Fn(){return An(`PMREMCubemapToCubemap`,{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function In(e){let t=new WeakMap,n=new WeakMap,r=null;function i(e,t=!1){return e==null?null:t?o(e):a(e)}function a(n){if(n&&n.isTexture){let r=n.mapping;if(r===303||r===304){if(t.has(n)){let e=t.get(n).texture;return s(e,n.mapping)}{let r=n.image;if(r&&r.height>0){let i=new yn(r.height);return i.fromEquirectangularTexture(e,n),t.set(n,i),n.addEventListener(`dispose`,l),s(i.texture,n.mapping)}return null}}}return n}function o(t){if(t&&t.isTexture&&t.isPMREMTexture!==!0){let i=t.mapping,a=i===303||i===304,o=i===301||i===302;if(a||o){let i=n.get(t),s=i===void 0?0:i.texture.pmremVersion;if(t.isRenderTargetTexture&&t.pmremVersion!==s)return r===null&&(r=new On(e)),i=a?r.fromEquirectangular(t,i):r.fromCubemap(t,i),i.texture.pmremVersion=t.pmremVersion,n.set(t,i),i.texture;if(i!==void 0)return i.texture;{let s=t.image;return a&&s&&s.height>0||o&&s&&c(s)?(r===null&&(r=new On(e)),i=a?r.fromEquirectangular(t):r.fromCubemap(t),i.texture.pmremVersion=t.pmremVersion,n.set(t,i),t.addEventListener(`dispose`,u),i.texture):null}}}return t}function s(e,t){return t===303?e.mapping=301:t===304&&(e.mapping=302),e}function c(e){let t=0;for(let n=0;n<6;n++)e[n]!==void 0&&t++;return t===6}function l(e){let n=e.target;n.removeEventListener(`dispose`,l);let r=t.get(n);r!==void 0&&(t.delete(n),r.dispose())}function u(e){let t=e.target;t.removeEventListener(`dispose`,u);let r=n.get(t);r!==void 0&&(n.delete(t),r.dispose())}function d(){t=new WeakMap,n=new WeakMap,r!==null&&(r.dispose(),r=null)}return{get:i,dispose:d}}function Ln(e){let t={};function n(n){if(t[n]!==void 0)return t[n];let r=e.getExtension(n);return t[n]=r,r}return{has:function(e){return n(e)!==null},init:function(){n(`EXT_color_buffer_float`),n(`WEBGL_clip_cull_distance`),n(`OES_texture_float_linear`),n(`EXT_color_buffer_half_float`),n(`WEBGL_multisampled_render_to_texture`),n(`WEBGL_render_shared_exponent`)},get:function(e){let t=n(e);return t===null&&je(`WebGLRenderer: `+e+` extension not supported.`),t}}}function Rn(e,t,n,r){let i={},a=new WeakMap,o=new FinalizationRegistry(e=>delete i[e]);function s(e){c(e.target)}function c(e){e.index!==null&&t.remove(e.index);for(let n in e.attributes)t.remove(e.attributes[n]);e.removeEventListener(`dispose`,s),delete i[e.id],o.unregister(e);let c=a.get(e);c&&(t.remove(c),a.delete(e)),r.releaseStatesOfGeometry(e),e.isInstancedBufferGeometry===!0&&delete e._maxInstanceCount,n.memory.geometries--}function l(e,t){return i[t.id]===void 0&&(t.addEventListener(`dispose`,s),i[t.id]=new WeakRef(t),o.register(t,t.id,t),n.memory.geometries++),t}function u(n){let r=n.attributes;for(let n in r)t.update(r[n],e.ARRAY_BUFFER)}function d(e){let n=e.index,r=e.attributes.position,i=0;if(r===void 0)return;let o=n===null?r.array.length/3-1:n.array.length,s=new(r.count>=65535?Et:E)(Math.ceil(o/3)*6,1),c=s.array;if(n!==null){let e=n.array;i=n.version;for(let t=0,n=0;t<o;t+=3){let r=e[t+0],i=e[t+1],a=e[t+2];c[n++]=r,c[n++]=i,c[n++]=i,c[n++]=a,c[n++]=a,c[n++]=r}}else{i=r.version;for(let e=0,t=0;e<o;e+=3){let n=e+0,r=e+1,i=e+2;c[t++]=n,c[t++]=r,c[t++]=r,c[t++]=i,c[t++]=i,c[t++]=n}}s.version=i;let l=a.get(e);l&&t.remove(l),a.set(e,s)}function f(e){let t=a.get(e);if(t){let n=e.index;n!==null&&t.version<n.version&&d(e)}else d(e);return a.get(e)}function p(){for(let e in i){let t=i[e].deref();t!==void 0&&c(t)}}return{get:l,update:u,getWireframeAttribute:f,dispose:p}}function zn(e,t,n){let r;function i(e){r=e}let a,o;function s(e){a=e.type,o=e.bytesPerElement}function c(t,i){e.drawElements(r,i,a,t*o),n.update(i,r,1)}function l(t,i,s){s!==0&&(e.drawElementsInstanced(r,i,a,t*o,s),n.update(i,r,s))}function u(e,i,o){if(o===0)return;t.get(`WEBGL_multi_draw`).multiDrawElementsWEBGL(r,i,0,a,e,0,o);let s=0;for(let e=0;e<o;e++)s+=i[e];n.update(s,r,1)}this.setMode=i,this.setIndex=s,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function Bn(e){let t={geometries:0,textures:0},n={frame:0,calls:0,triangles:0,points:0,lines:0};function r(t,r,i){switch(n.calls++,r){case e.TRIANGLES:n.triangles+=t/3*i;break;case e.LINES:n.lines+=t/2*i;break;case e.LINE_STRIP:n.lines+=i*(t-1);break;case e.LINE_LOOP:n.lines+=i*t;break;case e.POINTS:n.points+=i*t;break;default:R(`WebGLInfo: Unknown draw mode:`,r)}}function i(){n.calls=0,n.triangles=0,n.points=0,n.lines=0}return{memory:t,render:n,programs:null,autoReset:!0,reset:i,update:r}}function Vn(e,t,n){let r=new WeakMap,i=new re;function a(a,o,s){let c=a.morphTargetInfluences,l=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=l===void 0?0:l.length,d=r.get(o);if(d===void 0||d.count!==u){d!==void 0&&d.texture.dispose();let e=o.morphAttributes.position!==void 0,n=o.morphAttributes.normal!==void 0,a=o.morphAttributes.color!==void 0,s=o.morphAttributes.position||[],c=o.morphAttributes.normal||[],l=o.morphAttributes.color||[],f=0;e===!0&&(f=1),n===!0&&(f=2),a===!0&&(f=3);let p=o.attributes.position.count*f,m=1;p>t.maxTextureSize&&(m=Math.ceil(p/t.maxTextureSize),p=t.maxTextureSize);let h=new Float32Array(p*m*4*u),g=new At(h,p,m,u);g.type=et,g.needsUpdate=!0;let _=f*4;for(let t=0;t<u;t++){let r=s[t],o=c[t],u=l[t],d=p*m*4*t;for(let t=0;t<r.count;t++){let s=t*_;e===!0&&(i.fromBufferAttribute(r,t),h[d+s+0]=i.x,h[d+s+1]=i.y,h[d+s+2]=i.z,h[d+s+3]=0),n===!0&&(i.fromBufferAttribute(o,t),h[d+s+4]=i.x,h[d+s+5]=i.y,h[d+s+6]=i.z,h[d+s+7]=0),a===!0&&(i.fromBufferAttribute(u,t),h[d+s+8]=i.x,h[d+s+9]=i.y,h[d+s+10]=i.z,h[d+s+11]=u.itemSize===4?i.w:1)}}d={count:u,texture:g,size:new I(p,m)},r.set(o,d);function v(){g.dispose(),r.delete(o),o.removeEventListener(`dispose`,v)}o.addEventListener(`dispose`,v)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)s.getUniforms().setValue(e,`morphTexture`,a.morphTexture,n);else{let t=0;for(let e=0;e<c.length;e++)t+=c[e];let n=o.morphTargetsRelative?1:1-t;s.getUniforms().setValue(e,`morphTargetBaseInfluence`,n),s.getUniforms().setValue(e,`morphTargetInfluences`,c)}s.getUniforms().setValue(e,`morphTargetsTexture`,d.texture,n),s.getUniforms().setValue(e,`morphTargetsTextureSize`,d.size)}return{update:a}}function Hn(e,t,n,r,i){let a=new WeakMap;function o(r){let o=i.render.frame,s=r.geometry,l=t.get(r,s);if(a.get(l)!==o&&(t.update(l),a.set(l,o)),r.isInstancedMesh&&(r.hasEventListener(`dispose`,c)===!1&&r.addEventListener(`dispose`,c),a.get(r)!==o&&(n.update(r.instanceMatrix,e.ARRAY_BUFFER),r.instanceColor!==null&&n.update(r.instanceColor,e.ARRAY_BUFFER),a.set(r,o))),r.isSkinnedMesh){let e=r.skeleton;a.get(e)!==o&&(e.update(),a.set(e,o))}return l}function s(){a=new WeakMap}function c(e){let t=e.target;t.removeEventListener(`dispose`,c),r.releaseStatesOfObject(t),n.remove(t.instanceMatrix),t.instanceColor!==null&&n.remove(t.instanceColor)}return{update:o,dispose:s}}var Un={1:`LINEAR_TONE_MAPPING`,2:`REINHARD_TONE_MAPPING`,3:`CINEON_TONE_MAPPING`,4:`ACES_FILMIC_TONE_MAPPING`,6:`AGX_TONE_MAPPING`,7:`NEUTRAL_TONE_MAPPING`,5:`CUSTOM_TONE_MAPPING`};function Wn(e,t,n,r,i,a){let o=new ge(t,n,{type:e,depthBuffer:i,stencilBuffer:a,samples:r?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),s=null,c=null,l=null,u=new lt;u.setAttribute(`position`,new de([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute(`uv`,new de([0,2,0,0,2,0],2));let d=new Ue({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new H(u,d),p=new nt(-1,1,1,-1,0,1),m=null,h=null,g=!1,_,v=null,y=[],b=!1;this.setSize=function(e,t){o.setSize(e,t),s!==null&&s.setSize(e,t),c!==null&&c.setSize(e,t);for(let n=0;n<y.length;n++){let r=y[n];r.setSize&&r.setSize(e,t)}},this.setEffects=function(e){y=e,b=y.length>0&&y[0].isRenderPass===!0;let t=o.width,n=o.height;y.length>0&&s===null&&(s=new ge(t,n,{type:A,depthBuffer:!1,stencilBuffer:!1}),c=new ge(t,n,{type:A,depthBuffer:!1,stencilBuffer:!1}));let r=i===!0&&y.some(e=>e.needsDepthTexture===!0);r!==(o.depthTexture!==null)&&(r===!0&&l===null&&(l=new T(t,n),a===!0&&(l.format=_e,l.type=fe)),o.dispose(),o.depthTexture=r?l:null,o.resolveDepthBuffer=r,o.storeMultisampledDepthBuffer=r);for(let e=0;e<y.length;e++){let i=y[e];i.setSize&&i.setSize(t,n),r&&i.needsDepthTexture===!0&&i.setDepthTexture&&i.setDepthTexture(l)}},this.begin=function(e,t){if(g||e.toneMapping===0&&y.length===0)return!1;if(v=t,t!==null){let e=t.width,n=t.height;(o.width!==e||o.height!==n)&&this.setSize(e,n)}return b===!1&&e.setRenderTarget(o),_=e.toneMapping,e.toneMapping=0,!0},this.hasRenderPass=function(){return b},this.end=function(e,t){e.toneMapping=_,g=!0;let n=o,r=s;for(let i=0;i<y.length;i++){let a=y[i];a.enabled!==!1&&(a.render(e,r,n,t),a.needsSwap!==!1&&(n=r,r=r===s?c:s))}if(m!==e.outputColorSpace||h!==e.toneMapping){m=e.outputColorSpace,h=e.toneMapping,d.defines={},Ve.getTransfer(m)===`srgb`&&(d.defines.SRGB_TRANSFER=``);let t=Un[h];t&&(d.defines[t]=``),d.needsUpdate=!0}d.uniforms.tDiffuse.value=n.texture,e.setRenderTarget(v),e.render(f,p),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),s!==null&&s.dispose(),c!==null&&c.dispose(),u.dispose(),d.dispose()}}var Gn=new jt,Kn=new T(1,1),qn=new Je(1),Jn=new At,Yn=new Ct,Xn=new Ke,Zn=[],Qn=[],$n=new Float32Array(16),er=new Float32Array(9),tr=new Float32Array(4);function nr(e,t,n){let r=e[0];if(r<=0||r>0)return e;let i=t*n,a=Zn[i];if(a===void 0&&(a=new Float32Array(i),Zn[i]=a),t!==0){r.toArray(a,0);for(let r=1,i=0;r!==t;++r)i+=n,e[r].toArray(a,i)}return a}function rr(e,t){if(e.length!==t.length)return!1;for(let n=0,r=e.length;n<r;n++)if(e[n]!==t[n])return!1;return!0}function ir(e,t){for(let n=0,r=t.length;n<r;n++)e[n]=t[n]}function ar(e,t){let n=Qn[t];n===void 0&&(n=new Int32Array(t),Qn[t]=n);for(let r=0;r!==t;++r)n[r]=e.allocateTextureUnit();return n}function or(e,t){let n=this.cache;n[0]!==t&&(e.uniform1f(this.addr,t),n[0]=t)}function sr(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2f(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(rr(n,t))return;e.uniform2fv(this.addr,t),ir(n,t)}}function cr(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3f(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else if(t.r!==void 0)(n[0]!==t.r||n[1]!==t.g||n[2]!==t.b)&&(e.uniform3f(this.addr,t.r,t.g,t.b),n[0]=t.r,n[1]=t.g,n[2]=t.b);else{if(rr(n,t))return;e.uniform3fv(this.addr,t),ir(n,t)}}function lr(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4f(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(rr(n,t))return;e.uniform4fv(this.addr,t),ir(n,t)}}function ur(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(rr(n,t))return;e.uniformMatrix2fv(this.addr,!1,t),ir(n,t)}else{if(rr(n,r))return;tr.set(r),e.uniformMatrix2fv(this.addr,!1,tr),ir(n,r)}}function dr(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(rr(n,t))return;e.uniformMatrix3fv(this.addr,!1,t),ir(n,t)}else{if(rr(n,r))return;er.set(r),e.uniformMatrix3fv(this.addr,!1,er),ir(n,r)}}function fr(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(rr(n,t))return;e.uniformMatrix4fv(this.addr,!1,t),ir(n,t)}else{if(rr(n,r))return;$n.set(r),e.uniformMatrix4fv(this.addr,!1,$n),ir(n,r)}}function pr(e,t){let n=this.cache;n[0]!==t&&(e.uniform1i(this.addr,t),n[0]=t)}function mr(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2i(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(rr(n,t))return;e.uniform2iv(this.addr,t),ir(n,t)}}function hr(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3i(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(rr(n,t))return;e.uniform3iv(this.addr,t),ir(n,t)}}function gr(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4i(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(rr(n,t))return;e.uniform4iv(this.addr,t),ir(n,t)}}function _r(e,t){let n=this.cache;n[0]!==t&&(e.uniform1ui(this.addr,t),n[0]=t)}function vr(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2ui(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(rr(n,t))return;e.uniform2uiv(this.addr,t),ir(n,t)}}function yr(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3ui(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(rr(n,t))return;e.uniform3uiv(this.addr,t),ir(n,t)}}function br(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4ui(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(rr(n,t))return;e.uniform4uiv(this.addr,t),ir(n,t)}}function xr(e){return e.version===0&&(e.compareFunction=519,e.needsUpdate=!0),e}function Sr(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i);let a;a=this.type===e.SAMPLER_2D_SHADOW?xr(Kn):Gn,n.setTexture2D(t||a,i)}function Cr(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i),n.setTexture3D(t||Yn,i)}function wr(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i);let a;a=this.type===e.SAMPLER_CUBE_SHADOW?xr(qn):Xn,n.setTextureCube(t||a,i)}function Tr(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i),n.setTexture2DArray(t||Jn,i)}function Er(e){switch(e){case 5126:return or;case 35664:return sr;case 35665:return cr;case 35666:return lr;case 35674:return ur;case 35675:return dr;case 35676:return fr;case 5124:case 35670:return pr;case 35667:case 35671:return mr;case 35668:case 35672:return hr;case 35669:case 35673:return gr;case 5125:return _r;case 36294:return vr;case 36295:return yr;case 36296:return br;case 35678:case 36198:case 36298:case 36306:case 35682:return Sr;case 35679:case 36299:case 36307:return Cr;case 35680:case 36300:case 36308:case 36293:return wr;case 36289:case 36303:case 36311:case 36292:return Tr}}function Dr(e,t){e.uniform1fv(this.addr,t)}function Or(e,t){let n=nr(t,this.size,2);e.uniform2fv(this.addr,n)}function kr(e,t){let n=nr(t,this.size,3);e.uniform3fv(this.addr,n)}function Ar(e,t){let n=nr(t,this.size,4);e.uniform4fv(this.addr,n)}function jr(e,t){let n=nr(t,this.size,4);e.uniformMatrix2fv(this.addr,!1,n)}function Mr(e,t){let n=nr(t,this.size,9);e.uniformMatrix3fv(this.addr,!1,n)}function Nr(e,t){let n=nr(t,this.size,16);e.uniformMatrix4fv(this.addr,!1,n)}function Pr(e,t){e.uniform1iv(this.addr,t)}function Fr(e,t){e.uniform2iv(this.addr,t)}function Ir(e,t){e.uniform3iv(this.addr,t)}function Lr(e,t){e.uniform4iv(this.addr,t)}function Rr(e,t){e.uniform1uiv(this.addr,t)}function zr(e,t){e.uniform2uiv(this.addr,t)}function Br(e,t){e.uniform3uiv(this.addr,t)}function Vr(e,t){e.uniform4uiv(this.addr,t)}function Hr(e,t,n){let r=this.cache,i=t.length,a=ar(n,i);rr(r,a)||(e.uniform1iv(this.addr,a),ir(r,a));let o;o=this.type===e.SAMPLER_2D_SHADOW?xr(Kn):Gn;for(let e=0;e!==i;++e)n.setTexture2D(t[e]||o,a[e])}function Ur(e,t,n){let r=this.cache,i=t.length,a=ar(n,i);rr(r,a)||(e.uniform1iv(this.addr,a),ir(r,a));for(let e=0;e!==i;++e)n.setTexture3D(t[e]||Yn,a[e])}function Wr(e,t,n){let r=this.cache,i=t.length,a=ar(n,i);rr(r,a)||(e.uniform1iv(this.addr,a),ir(r,a));let o;o=this.type===e.SAMPLER_CUBE_SHADOW?xr(qn):Xn;for(let e=0;e!==i;++e)n.setTextureCube(t[e]||o,a[e])}function Gr(e,t,n){let r=this.cache,i=t.length,a=ar(n,i);rr(r,a)||(e.uniform1iv(this.addr,a),ir(r,a));for(let e=0;e!==i;++e)n.setTexture2DArray(t[e]||Jn,a[e])}function Kr(e){switch(e){case 5126:return Dr;case 35664:return Or;case 35665:return kr;case 35666:return Ar;case 35674:return jr;case 35675:return Mr;case 35676:return Nr;case 5124:case 35670:return Pr;case 35667:case 35671:return Fr;case 35668:case 35672:return Ir;case 35669:case 35673:return Lr;case 5125:return Rr;case 36294:return zr;case 36295:return Br;case 36296:return Vr;case 35678:case 36198:case 36298:case 36306:case 35682:return Hr;case 35679:case 36299:case 36307:return Ur;case 35680:case 36300:case 36308:case 36293:return Wr;case 36289:case 36303:case 36311:case 36292:return Gr}}var qr=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Er(t.type)}},Jr=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Kr(t.type)}},Yr=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let i=0,a=r.length;i!==a;++i){let a=r[i];a.setValue(e,t[a.id],n)}}},Xr=/(\w+)(\])?(\[|\.)?/g;function Zr(e,t){e.seq.push(t),e.map[t.id]=t}function Qr(e,t,n){let r=e.name,i=r.length;for(Xr.lastIndex=0;;){let a=Xr.exec(r),o=Xr.lastIndex,s=a[1],c=a[2]===`]`,l=a[3];if(c&&(s|=0),l===void 0||l===`[`&&o+2===i){Zr(n,l===void 0?new qr(s,e,t):new Jr(s,e,t));break}{let e=n.map[s];e===void 0&&(e=new Yr(s),Zr(n,e)),n=e}}}var $r=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let r=0;r<n;++r){let n=e.getActiveUniform(t,r);Qr(n,e.getUniformLocation(t,n.name),this)}let r=[],i=[];for(let t of this.seq)t.type===e.SAMPLER_2D_SHADOW||t.type===e.SAMPLER_CUBE_SHADOW||t.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(t):i.push(t);r.length>0&&(this.seq=r.concat(i))}setValue(e,t,n,r){let i=this.map[t];i!==void 0&&i.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let i=0,a=t.length;i!==a;++i){let a=t[i],o=n[a.id];o.needsUpdate!==!1&&a.setValue(e,o.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,i=e.length;r!==i;++r){let i=e[r];i.id in t&&n.push(i)}return n}};function ei(e,t,n){let r=e.createShader(t);return e.shaderSource(r,n),e.compileShader(r),r}var ti=37297,ni=0;function ri(e,t){let n=e.split(`
`),r=[],i=Math.max(t-6,0),a=Math.min(t+6,n.length);for(let e=i;e<a;e++){let i=e+1;r.push(`${i===t?`>`:` `} ${i}: ${n[e]}`)}return r.join(`
`)}var ii=new L;function ai(e){Ve._getMatrix(ii,Ve.workingColorSpace,e);let t=`mat3( ${ii.elements.map(e=>e.toFixed(4))} )`;switch(Ve.getTransfer(e)){case Oe:return[t,`LinearTransferOETF`];case We:return[t,`sRGBTransferOETF`];default:return z(`WebGLProgram: Unsupported color space: `,e),[t,`LinearTransferOETF`]}}function oi(e,t,n){let r=e.getShaderParameter(t,e.COMPILE_STATUS),i=(e.getShaderInfoLog(t)||``).trim();if(r&&i===``)return``;let a=/ERROR: 0:(\d+)/.exec(i);if(a){let r=parseInt(a[1]);return n.toUpperCase()+`

`+i+`

`+ri(e.getShaderSource(t),r)}return i}function si(e,t){let n=ai(t);return[`vec4 ${e}( vec4 value ) {`,`	return ${n[1]}( vec4( ${n[0]} * value.rgb, value.a ) );`,`}`].join(`
`)}var ci={1:`Linear`,2:`Reinhard`,3:`Cineon`,4:`ACESFilmic`,6:`AgX`,7:`Neutral`,5:`Custom`};function li(e,t){let n=ci[t];return n===void 0?(z(`WebGLProgram: Unsupported toneMapping:`,t),`vec3 `+e+`( vec3 color ) { return LinearToneMapping( color ); }`):`vec3 `+e+`( vec3 color ) { return `+n+`ToneMapping( color ); }`}var ui=new j;function di(){return Ve.getLuminanceCoefficients(ui),[`float luminance( const in vec3 rgb ) {`,`	const vec3 weights = vec3( ${ui.x.toFixed(4)}, ${ui.y.toFixed(4)}, ${ui.z.toFixed(4)} );`,`	return dot( weights, rgb );`,`}`].join(`
`)}function fi(e){return[e.extensionClipCullDistance?`#extension GL_ANGLE_clip_cull_distance : require`:``,e.extensionMultiDraw?`#extension GL_ANGLE_multi_draw : require`:``].filter(hi).join(`
`)}function pi(e){let t=[];for(let n in e){let r=e[n];r!==!1&&t.push(`#define `+n+` `+r)}return t.join(`
`)}function mi(e,t){let n={},r=e.getProgramParameter(t,e.ACTIVE_ATTRIBUTES);for(let i=0;i<r;i++){let r=e.getActiveAttrib(t,i),a=r.name,o=1;r.type===e.FLOAT_MAT2&&(o=2),r.type===e.FLOAT_MAT3&&(o=3),r.type===e.FLOAT_MAT4&&(o=4),n[a]={type:r.type,location:e.getAttribLocation(t,a),locationSize:o}}return n}function hi(e){return e!==``}function gi(e,t){let n=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return e.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,n).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function _i(e,t){return e.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var vi=/^[ \t]*#include +<([\w\d./]+)>/gm;function yi(e){return e.replace(vi,bi)}function bi(e,t){let n=q[t];if(n===void 0)throw Error(`THREE.WebGLProgram: Can not resolve #include <`+t+`>`);return yi(n)}var xi=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Si(e){return e.replace(xi,Ci)}function Ci(e,t,n,r){let i=``;for(let e=parseInt(t);e<parseInt(n);e++)i+=r.replace(/\[\s*i\s*\]/g,`[ `+e+` ]`).replace(/UNROLLED_LOOP_INDEX/g,e);return i}function wi(e){let t=`precision ${e.precision} float;
	precision ${e.precision} int;
	precision ${e.precision} sampler2D;
	precision ${e.precision} samplerCube;
	precision ${e.precision} sampler3D;
	precision ${e.precision} sampler2DArray;
	precision ${e.precision} sampler2DShadow;
	precision ${e.precision} samplerCubeShadow;
	precision ${e.precision} sampler2DArrayShadow;
	precision ${e.precision} isampler2D;
	precision ${e.precision} isampler3D;
	precision ${e.precision} isamplerCube;
	precision ${e.precision} isampler2DArray;
	precision ${e.precision} usampler2D;
	precision ${e.precision} usampler3D;
	precision ${e.precision} usamplerCube;
	precision ${e.precision} usampler2DArray;
	`;return e.precision===`highp`?t+=`
#define HIGH_PRECISION`:e.precision===`mediump`?t+=`
#define MEDIUM_PRECISION`:e.precision===`lowp`&&(t+=`
#define LOW_PRECISION`),t}var Ti={1:`SHADOWMAP_TYPE_PCF`,3:`SHADOWMAP_TYPE_VSM`};function Ei(e){return Ti[e.shadowMapType]||`SHADOWMAP_TYPE_BASIC`}var Di={302:`ENVMAP_MODE_REFRACTION`};function Oi(e){return e.envMap===!1?`ENVMAP_MODE_REFLECTION`:Di[e.envMapMode]||`ENVMAP_MODE_REFLECTION`}var ki={0:`ENVMAP_BLENDING_MULTIPLY`,1:`ENVMAP_BLENDING_MIX`,2:`ENVMAP_BLENDING_ADD`};function Ai(e){return e.envMap===!1?`ENVMAP_BLENDING_NONE`:ki[e.combine]||`ENVMAP_BLENDING_NONE`}function ji(e,t,n,r){let i=e.getContext(),a=n.defines,o=n.vertexShader,s=n.fragmentShader,c=Ei(n),l=n.envMapPMREM===!0?`ENVMAP_TYPE_PMREM`:`ENVMAP_TYPE_CUBE`,u=Oi(n),d=Ai(n),f=fi(n),p=pi(a),m=i.createProgram(),h,g,_=n.glslVersion?`#version `+n.glslVersion+`
`:``;n.isRawShaderMaterial?(h=[`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p].filter(hi).join(`
`),h.length>0&&(h+=`
`),g=[`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p].filter(hi).join(`
`),g.length>0&&(g+=`
`)):(h=[wi(n),`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p,n.extensionClipCullDistance?`#define USE_CLIP_DISTANCE`:``,n.batching?`#define USE_BATCHING`:``,n.batchingColor?`#define USE_BATCHING_COLOR`:``,n.instancing?`#define USE_INSTANCING`:``,n.instancingColor?`#define USE_INSTANCING_COLOR`:``,n.instancingMorph?`#define USE_INSTANCING_MORPH`:``,n.useFog&&n.fog?`#define USE_FOG`:``,n.useFog&&n.fogExp2?`#define FOG_EXP2`:``,n.map?`#define USE_MAP`:``,n.envMap?`#define USE_ENVMAP`:``,n.envMap?`#define `+u:``,n.lightMap?`#define USE_LIGHTMAP`:``,n.aoMap?`#define USE_AOMAP`:``,n.bumpMap?`#define USE_BUMPMAP`:``,n.normalMap?`#define USE_NORMALMAP`:``,n.normalMapObjectSpace?`#define USE_NORMALMAP_OBJECTSPACE`:``,n.normalMapTangentSpace?`#define USE_NORMALMAP_TANGENTSPACE`:``,n.displacementMap?`#define USE_DISPLACEMENTMAP`:``,n.emissiveMap?`#define USE_EMISSIVEMAP`:``,n.anisotropy?`#define USE_ANISOTROPY`:``,n.anisotropyMap?`#define USE_ANISOTROPYMAP`:``,n.clearcoatMap?`#define USE_CLEARCOATMAP`:``,n.clearcoatRoughnessMap?`#define USE_CLEARCOAT_ROUGHNESSMAP`:``,n.clearcoatNormalMap?`#define USE_CLEARCOAT_NORMALMAP`:``,n.diffuseRoughnessMap?`#define USE_DIFFUSE_ROUGHNESSMAP`:``,n.iridescenceMap?`#define USE_IRIDESCENCEMAP`:``,n.iridescenceThicknessMap?`#define USE_IRIDESCENCE_THICKNESSMAP`:``,n.specularMap?`#define USE_SPECULARMAP`:``,n.specularColorMap?`#define USE_SPECULAR_COLORMAP`:``,n.specularIntensityMap?`#define USE_SPECULAR_INTENSITYMAP`:``,n.roughnessMap?`#define USE_ROUGHNESSMAP`:``,n.metalnessMap?`#define USE_METALNESSMAP`:``,n.alphaMap?`#define USE_ALPHAMAP`:``,n.alphaHash?`#define USE_ALPHAHASH`:``,n.transmission?`#define USE_TRANSMISSION`:``,n.transmissionMap?`#define USE_TRANSMISSIONMAP`:``,n.thicknessMap?`#define USE_THICKNESSMAP`:``,n.sheenColorMap?`#define USE_SHEEN_COLORMAP`:``,n.sheenRoughnessMap?`#define USE_SHEEN_ROUGHNESSMAP`:``,n.mapUv?`#define MAP_UV `+n.mapUv:``,n.alphaMapUv?`#define ALPHAMAP_UV `+n.alphaMapUv:``,n.lightMapUv?`#define LIGHTMAP_UV `+n.lightMapUv:``,n.aoMapUv?`#define AOMAP_UV `+n.aoMapUv:``,n.emissiveMapUv?`#define EMISSIVEMAP_UV `+n.emissiveMapUv:``,n.bumpMapUv?`#define BUMPMAP_UV `+n.bumpMapUv:``,n.normalMapUv?`#define NORMALMAP_UV `+n.normalMapUv:``,n.displacementMapUv?`#define DISPLACEMENTMAP_UV `+n.displacementMapUv:``,n.metalnessMapUv?`#define METALNESSMAP_UV `+n.metalnessMapUv:``,n.roughnessMapUv?`#define ROUGHNESSMAP_UV `+n.roughnessMapUv:``,n.anisotropyMapUv?`#define ANISOTROPYMAP_UV `+n.anisotropyMapUv:``,n.clearcoatMapUv?`#define CLEARCOATMAP_UV `+n.clearcoatMapUv:``,n.clearcoatNormalMapUv?`#define CLEARCOAT_NORMALMAP_UV `+n.clearcoatNormalMapUv:``,n.clearcoatRoughnessMapUv?`#define CLEARCOAT_ROUGHNESSMAP_UV `+n.clearcoatRoughnessMapUv:``,n.diffuseRoughnessMapUv?`#define DIFFUSE_ROUGHNESSMAP_UV `+n.diffuseRoughnessMapUv:``,n.iridescenceMapUv?`#define IRIDESCENCEMAP_UV `+n.iridescenceMapUv:``,n.iridescenceThicknessMapUv?`#define IRIDESCENCE_THICKNESSMAP_UV `+n.iridescenceThicknessMapUv:``,n.sheenColorMapUv?`#define SHEEN_COLORMAP_UV `+n.sheenColorMapUv:``,n.sheenRoughnessMapUv?`#define SHEEN_ROUGHNESSMAP_UV `+n.sheenRoughnessMapUv:``,n.specularMapUv?`#define SPECULARMAP_UV `+n.specularMapUv:``,n.specularColorMapUv?`#define SPECULAR_COLORMAP_UV `+n.specularColorMapUv:``,n.specularIntensityMapUv?`#define SPECULAR_INTENSITYMAP_UV `+n.specularIntensityMapUv:``,n.transmissionMapUv?`#define TRANSMISSIONMAP_UV `+n.transmissionMapUv:``,n.thicknessMapUv?`#define THICKNESSMAP_UV `+n.thicknessMapUv:``,n.vertexTangents&&n.flatShading===!1?`#define USE_TANGENT`:``,n.vertexNormals?`#define HAS_NORMAL`:``,n.vertexColors?`#define USE_COLOR`:``,n.vertexAlphas?`#define USE_COLOR_ALPHA`:``,n.vertexUv1s?`#define USE_UV1`:``,n.vertexUv2s?`#define USE_UV2`:``,n.vertexUv3s?`#define USE_UV3`:``,n.pointsUvs?`#define USE_POINTS_UV`:``,n.flatShading?`#define FLAT_SHADED`:``,n.skinning?`#define USE_SKINNING`:``,n.morphTargets?`#define USE_MORPHTARGETS`:``,n.morphNormals&&n.flatShading===!1?`#define USE_MORPHNORMALS`:``,n.morphColors?`#define USE_MORPHCOLORS`:``,n.morphTargetsCount>0?`#define MORPHTARGETS_TEXTURE_STRIDE `+n.morphTextureStride:``,n.morphTargetsCount>0?`#define MORPHTARGETS_COUNT `+n.morphTargetsCount:``,n.doubleSided?`#define DOUBLE_SIDED`:``,n.flipSided?`#define FLIP_SIDED`:``,n.shadowMapEnabled?`#define USE_SHADOWMAP`:``,n.shadowMapEnabled?`#define `+c:``,n.sizeAttenuation?`#define USE_SIZEATTENUATION`:``,n.numLightProbes>0?`#define USE_LIGHT_PROBES`:``,n.logarithmicDepthBuffer?`#define USE_LOGARITHMIC_DEPTH_BUFFER`:``,n.reversedDepthBuffer?`#define USE_REVERSED_DEPTH_BUFFER`:``,`uniform mat4 modelMatrix;`,`uniform mat4 modelViewMatrix;`,`uniform mat4 projectionMatrix;`,`uniform mat4 viewMatrix;`,`uniform mat3 normalMatrix;`,`uniform vec3 cameraPosition;`,`uniform bool isOrthographic;`,`#ifdef USE_INSTANCING`,`	attribute mat4 instanceMatrix;`,`#endif`,`#ifdef USE_INSTANCING_COLOR`,`	attribute vec3 instanceColor;`,`#endif`,`#ifdef USE_INSTANCING_MORPH`,`	uniform sampler2D morphTexture;`,`#endif`,`attribute vec3 position;`,`attribute vec3 normal;`,`attribute vec2 uv;`,`#ifdef USE_UV1`,`	attribute vec2 uv1;`,`#endif`,`#ifdef USE_UV2`,`	attribute vec2 uv2;`,`#endif`,`#ifdef USE_UV3`,`	attribute vec2 uv3;`,`#endif`,`#ifdef USE_TANGENT`,`	attribute vec4 tangent;`,`#endif`,`#if defined( USE_COLOR_ALPHA )`,`	attribute vec4 color;`,`#elif defined( USE_COLOR )`,`	attribute vec3 color;`,`#endif`,`#ifdef USE_SKINNING`,`	attribute vec4 skinIndex;`,`	attribute vec4 skinWeight;`,`#endif`,`
`].filter(hi).join(`
`),g=[wi(n),`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p,n.useFog&&n.fog?`#define USE_FOG`:``,n.useFog&&n.fogExp2?`#define FOG_EXP2`:``,n.alphaToCoverage?`#define ALPHA_TO_COVERAGE`:``,n.map?`#define USE_MAP`:``,n.matcap?`#define USE_MATCAP`:``,n.envMap?`#define USE_ENVMAP`:``,n.envMap?`#define `+l:``,n.envMap?`#define `+u:``,n.envMap?`#define `+d:``,n.envMapPMREM?`#define ENVMAP_MAX_LOD `+n.envMapMaxLod+`.0`:``,n.envMapPMREM?`#define ENVMAP_SIZE `+n.envMapSize+`.0`:``,n.lightMap?`#define USE_LIGHTMAP`:``,n.aoMap?`#define USE_AOMAP`:``,n.bumpMap?`#define USE_BUMPMAP`:``,n.normalMap?`#define USE_NORMALMAP`:``,n.normalMapObjectSpace?`#define USE_NORMALMAP_OBJECTSPACE`:``,n.normalMapTangentSpace?`#define USE_NORMALMAP_TANGENTSPACE`:``,n.packedNormalMap?`#define USE_PACKED_NORMALMAP`:``,n.emissiveMap?`#define USE_EMISSIVEMAP`:``,n.anisotropy?`#define USE_ANISOTROPY`:``,n.anisotropyMap?`#define USE_ANISOTROPYMAP`:``,n.clearcoat?`#define USE_CLEARCOAT`:``,n.clearcoatMap?`#define USE_CLEARCOATMAP`:``,n.clearcoatRoughnessMap?`#define USE_CLEARCOAT_ROUGHNESSMAP`:``,n.clearcoatNormalMap?`#define USE_CLEARCOAT_NORMALMAP`:``,n.diffuseRoughness?`#define USE_DIFFUSE_ROUGHNESS`:``,n.diffuseRoughnessMap?`#define USE_DIFFUSE_ROUGHNESSMAP`:``,n.dispersion?`#define USE_DISPERSION`:``,n.retroreflection?`#define USE_RETROREFLECTION`:``,n.iridescence?`#define USE_IRIDESCENCE`:``,n.iridescenceMap?`#define USE_IRIDESCENCEMAP`:``,n.iridescenceThicknessMap?`#define USE_IRIDESCENCE_THICKNESSMAP`:``,n.specularMap?`#define USE_SPECULARMAP`:``,n.specularColorMap?`#define USE_SPECULAR_COLORMAP`:``,n.specularIntensityMap?`#define USE_SPECULAR_INTENSITYMAP`:``,n.roughnessMap?`#define USE_ROUGHNESSMAP`:``,n.metalnessMap?`#define USE_METALNESSMAP`:``,n.alphaMap?`#define USE_ALPHAMAP`:``,n.alphaTest?`#define USE_ALPHATEST`:``,n.alphaHash?`#define USE_ALPHAHASH`:``,n.sheen?`#define USE_SHEEN`:``,n.sheenColorMap?`#define USE_SHEEN_COLORMAP`:``,n.sheenRoughnessMap?`#define USE_SHEEN_ROUGHNESSMAP`:``,n.transmission?`#define USE_TRANSMISSION`:``,n.transmissionMap?`#define USE_TRANSMISSIONMAP`:``,n.thicknessMap?`#define USE_THICKNESSMAP`:``,n.vertexTangents&&n.flatShading===!1?`#define USE_TANGENT`:``,n.vertexColors||n.instancingColor?`#define USE_COLOR`:``,n.vertexAlphas||n.batchingColor?`#define USE_COLOR_ALPHA`:``,n.vertexUv1s?`#define USE_UV1`:``,n.vertexUv2s?`#define USE_UV2`:``,n.vertexUv3s?`#define USE_UV3`:``,n.pointsUvs?`#define USE_POINTS_UV`:``,n.gradientMap?`#define USE_GRADIENTMAP`:``,n.flatShading?`#define FLAT_SHADED`:``,n.doubleSided?`#define DOUBLE_SIDED`:``,n.flipSided?`#define FLIP_SIDED`:``,n.shadowMapEnabled?`#define USE_SHADOWMAP`:``,n.shadowMapEnabled?`#define `+c:``,n.premultipliedAlpha?`#define PREMULTIPLIED_ALPHA`:``,n.numLightProbes>0?`#define USE_LIGHT_PROBES`:``,n.decodeVideoTexture?`#define DECODE_VIDEO_TEXTURE`:``,n.decodeVideoTextureEmissive?`#define DECODE_VIDEO_TEXTURE_EMISSIVE`:``,n.logarithmicDepthBuffer?`#define USE_LOGARITHMIC_DEPTH_BUFFER`:``,n.reversedDepthBuffer?`#define USE_REVERSED_DEPTH_BUFFER`:``,`uniform mat4 viewMatrix;`,`uniform vec3 cameraPosition;`,`uniform bool isOrthographic;`,n.toneMapping===0?``:`#define TONE_MAPPING`,n.toneMapping===0?``:q.tonemapping_pars_fragment,n.toneMapping===0?``:li(`toneMapping`,n.toneMapping),n.dithering?`#define DITHERING`:``,n.opaque?`#define OPAQUE`:``,q.colorspace_pars_fragment,si(`linearToOutputTexel`,n.outputColorSpace),di(),n.useDepthPacking?`#define DEPTH_PACKING `+n.depthPacking:``,`
`].filter(hi).join(`
`)),o=yi(o),o=gi(o,n),o=_i(o,n),s=yi(s),s=gi(s,n),s=_i(s,n),o=Si(o),s=Si(s),n.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,h=[f,`#define attribute in`,`#define varying out`,`#define texture2D texture`].join(`
`)+`
`+h,g=[`#define varying in`,n.glslVersion===`300 es`?``:`layout(location = 0) out highp vec4 pc_fragColor;`,n.glslVersion===`300 es`?``:`#define gl_FragColor pc_fragColor`,`#define gl_FragDepthEXT gl_FragDepth`,`#define texture2D texture`,`#define textureCube texture`,`#define texture2DProj textureProj`,`#define texture2DLodEXT textureLod`,`#define texture2DProjLodEXT textureProjLod`,`#define textureCubeLodEXT textureLod`,`#define texture2DGradEXT textureGrad`,`#define texture2DProjGradEXT textureProjGrad`,`#define textureCubeGradEXT textureGrad`].join(`
`)+`
`+g);let v=_+h+o,y=_+g+s,b=ei(i,i.VERTEX_SHADER,v),x=ei(i,i.FRAGMENT_SHADER,y);i.attachShader(m,b),i.attachShader(m,x),n.index0AttributeName===void 0?n.hasPositionAttribute===!0&&i.bindAttribLocation(m,0,`position`):i.bindAttribLocation(m,0,n.index0AttributeName),i.linkProgram(m);function S(t){if(e.debug.checkShaderErrors){let n=i.getProgramInfoLog(m)||``,r=i.getShaderInfoLog(b)||``,a=i.getShaderInfoLog(x)||``,o=n.trim(),s=r.trim(),c=a.trim(),l=!0,u=!0;if(i.getProgramParameter(m,i.LINK_STATUS)===!1){if(l=!1,typeof e.debug.onShaderError==`function`)e.debug.onShaderError(i,m,b,x);else{let e=oi(i,b,`vertex`),n=oi(i,x,`fragment`);R(`WebGLProgram: Shader Error `+i.getError()+` - VALIDATE_STATUS `+i.getProgramParameter(m,i.VALIDATE_STATUS)+`

Material Name: `+t.name+`
Material Type: `+t.type+`

Program Info Log: `+o+`
`+e+`
`+n)}}else o===``?(s===``||c===``)&&(u=!1):z(`WebGLProgram: Program Info Log:`,o);u&&(t.diagnostics={runnable:l,programLog:o,vertexShader:{log:s,prefix:h},fragmentShader:{log:c,prefix:g}})}i.deleteShader(b),i.deleteShader(x),C=new $r(i,m),w=mi(i,m)}let C;this.getUniforms=function(){return C===void 0&&S(this),C};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let T=n.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return T===!1&&(T=i.getProgramParameter(m,ti)),T},this.destroy=function(){r.releaseStatesOfProgram(this),i.deleteProgram(m),this.program=void 0},this.type=n.shaderType,this.name=n.shaderName,this.id=ni++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=x,this}var Mi=0,Ni=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let e of t)e.usedTimes--,e.usedTimes===0&&this.shaderCache.delete(e.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Pi(e),t.set(e,n)),n}},Pi=class{constructor(e){this.id=Mi++,this.code=e,this.usedTimes=0}};function Fi(e){return e===1030||e===37490||e===36285}function Ii(e,t,n,r,i,a){let o=new Ce,s=new Ni,c=new Set,l=[],u=new Map,d=r.logarithmicDepthBuffer,f={MeshDepthMaterial:`depth`,MeshDistanceMaterial:`distance`,MeshNormalMaterial:`normal`,MeshBasicMaterial:`basic`,MeshLambertMaterial:`lambert`,MeshPhongMaterial:`phong`,MeshToonMaterial:`toon`,MeshStandardMaterial:`physical`,MeshPhysicalMaterial:`physical`,MeshMatcapMaterial:`matcap`,LineBasicMaterial:`basic`,LineDashedMaterial:`dashed`,PointsMaterial:`points`,ShadowMaterial:`shadow`,SpriteMaterial:`sprite`};function p(e){return c.add(e),e===0?`uv`:`uv${e}`}function m(i,o,l,u,m,h){let g=u.fog,_=m.geometry,v=i.isMeshStandardMaterial||i.isMeshLambertMaterial||i.isMeshPhongMaterial?u.environment:null,y=i.isMeshStandardMaterial||i.isMeshLambertMaterial&&!i.envMap||i.isMeshPhongMaterial&&!i.envMap,b=t.get(i.envMap||v,y),x=f[i.type],S=r.precision;i.precision!==null&&(S=r.getMaxPrecision(i.precision),S!==i.precision&&z(`WebGLProgram.getParameters:`,i.precision,`not supported, using`,S,`instead.`));let C=_.morphAttributes.position||_.morphAttributes.normal||_.morphAttributes.color,w=C===void 0?0:C.length,T=0;_.morphAttributes.position!==void 0&&(T=1),_.morphAttributes.normal!==void 0&&(T=2),_.morphAttributes.color!==void 0&&(T=3);let E,D,O,k;if(x){let e=un[x];E=e.vertexShader,D=e.fragmentShader}else{E=i.vertexShader,D=i.fragmentShader;let e=s.getVertexShaderStage(i),t=s.getFragmentShaderStage(i);s.update(i,e,t),O=e.id,k=t.id}let A=e.getRenderTarget(),j=e.state.buffers.depth.getReversed(),M=m.isInstancedMesh===!0,N=m.isBatchedMesh===!0,ee=!!i.map,te=!!i.matcap,ne=!!b,re=ne&&b.isPMREMTexture===!0,ie=!!i.aoMap,P=!!i.lightMap,ae=!!i.bumpMap&&i.wireframe===!1,F=!!i.normalMap,oe=!!i.displacementMap,se=!!i.emissiveMap,ce=!!i.metalnessMap,le=!!i.roughnessMap,ue=i.anisotropy>0,de=i.clearcoat>0,fe=i.diffuseRoughness>0,pe=i.dispersion>0,I=i.retroreflectivity>0,L=i.iridescence>0,me=i.sheen>0,he=i.transmission>0,ge=ue&&!!i.anisotropyMap,_e=de&&!!i.clearcoatMap,ve=de&&!!i.clearcoatNormalMap,ye=de&&!!i.clearcoatRoughnessMap,be=fe&&!!i.diffuseRoughnessMap,xe=L&&!!i.iridescenceMap,Se=L&&!!i.iridescenceThicknessMap,R=me&&!!i.sheenColorMap,Ce=me&&!!i.sheenRoughnessMap,we=!!i.specularMap,Te=!!i.specularColorMap,Ee=!!i.specularIntensityMap,De=he&&!!i.transmissionMap,Oe=he&&!!i.thicknessMap,ke=!!i.gradientMap,Ae=!!i.alphaMap,je=i.alphaTest>0,Me=!!i.alphaHash,Ne=!!i.extensions,Pe=0;i.toneMapped&&(A===null||A.isXRRenderTarget===!0)&&(Pe=e.toneMapping);let Fe=re?b.isCompressedCubeTexture?b.image[0].mipmaps:b.mipmaps:null,Ie={shaderID:x,shaderType:i.type,shaderName:i.name,vertexShader:E,fragmentShader:D,defines:i.defines,customVertexShaderID:O,customFragmentShaderID:k,isRawShaderMaterial:i.isRawShaderMaterial===!0,glslVersion:i.glslVersion,precision:S,batching:N,batchingColor:N&&m._colorsTexture!==null,instancing:M,instancingColor:M&&m.instanceColor!==null,instancingMorph:M&&m.morphTexture!==null,outputColorSpace:A===null?e.outputColorSpace:A.isXRRenderTarget===!0?A.texture.colorSpace:Ve.workingColorSpace,alphaToCoverage:!!i.alphaToCoverage,map:ee,matcap:te,envMap:ne,envMapMode:ne&&b.mapping,envMapPMREM:re,envMapMaxLod:re?Fe.length-1:null,envMapSize:re?Fe[0].width:null,aoMap:ie,lightMap:P,bumpMap:ae,normalMap:F,displacementMap:oe,emissiveMap:se,normalMapObjectSpace:F&&i.normalMapType===1,normalMapTangentSpace:F&&i.normalMapType===0,packedNormalMap:F&&i.normalMapType===0&&Fi(i.normalMap.format),metalnessMap:ce,roughnessMap:le,anisotropy:ue,anisotropyMap:ge,clearcoat:de,clearcoatMap:_e,clearcoatNormalMap:ve,clearcoatRoughnessMap:ye,diffuseRoughness:fe,diffuseRoughnessMap:be,dispersion:pe,retroreflection:I,iridescence:L,iridescenceMap:xe,iridescenceThicknessMap:Se,sheen:me,sheenColorMap:R,sheenRoughnessMap:Ce,specularMap:we,specularColorMap:Te,specularIntensityMap:Ee,transmission:he,transmissionMap:De,thicknessMap:Oe,gradientMap:ke,opaque:i.transparent===!1&&i.blending===1&&i.alphaToCoverage===!1,alphaMap:Ae,alphaTest:je,alphaHash:Me,combine:i.combine,mapUv:ee&&p(i.map.channel),aoMapUv:ie&&p(i.aoMap.channel),lightMapUv:P&&p(i.lightMap.channel),bumpMapUv:ae&&p(i.bumpMap.channel),normalMapUv:F&&p(i.normalMap.channel),displacementMapUv:oe&&p(i.displacementMap.channel),emissiveMapUv:se&&p(i.emissiveMap.channel),metalnessMapUv:ce&&p(i.metalnessMap.channel),roughnessMapUv:le&&p(i.roughnessMap.channel),anisotropyMapUv:ge&&p(i.anisotropyMap.channel),clearcoatMapUv:_e&&p(i.clearcoatMap.channel),clearcoatNormalMapUv:ve&&p(i.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ye&&p(i.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:be&&p(i.diffuseRoughnessMap.channel),iridescenceMapUv:xe&&p(i.iridescenceMap.channel),iridescenceThicknessMapUv:Se&&p(i.iridescenceThicknessMap.channel),sheenColorMapUv:R&&p(i.sheenColorMap.channel),sheenRoughnessMapUv:Ce&&p(i.sheenRoughnessMap.channel),specularMapUv:we&&p(i.specularMap.channel),specularColorMapUv:Te&&p(i.specularColorMap.channel),specularIntensityMapUv:Ee&&p(i.specularIntensityMap.channel),transmissionMapUv:De&&p(i.transmissionMap.channel),thicknessMapUv:Oe&&p(i.thicknessMap.channel),alphaMapUv:Ae&&p(i.alphaMap.channel),vertexTangents:!!_.attributes.tangent&&(F||ue),vertexNormals:!!_.attributes.normal,vertexColors:i.vertexColors,vertexAlphas:i.vertexColors===!0&&!!_.attributes.color&&_.attributes.color.itemSize===4,pointsUvs:m.isPoints===!0&&!!_.attributes.uv&&(ee||Ae),fog:!!g,useFog:i.fog===!0,fogExp2:!!g&&g.isFogExp2,flatShading:i.wireframe===!1&&(i.flatShading===!0||_.attributes.normal===void 0&&F===!1&&(i.isMeshLambertMaterial||i.isMeshPhongMaterial||i.isMeshStandardMaterial||i.isMeshPhysicalMaterial)),sizeAttenuation:i.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:j,skinning:m.isSkinnedMesh===!0,hasPositionAttribute:_.attributes.position!==void 0,morphTargets:_.morphAttributes.position!==void 0,morphNormals:_.morphAttributes.normal!==void 0,morphColors:_.morphAttributes.color!==void 0,morphTargetsCount:w,morphTextureStride:T,numSunLights:o.sun.length,numDirLights:o.directional.length,numPointLights:o.point.length,numSpotLights:o.spot.length,numSpotLightMaps:o.spotLightMap.length,numRectAreaLights:o.rectArea.length,numHemiLights:o.hemi.length,numSunLightShadows:o.sunShadowMap.length,numDirLightShadows:o.directionalShadowMap.length,numPointLightShadows:o.pointShadowMap.length,numSpotLightShadows:o.spotShadowMap.length,numSpotLightShadowsWithMaps:o.numSpotLightShadowsWithMaps,numLightProbes:o.numLightProbes,numLightProbeGrids:h.filter(e=>e.texture!==null).length,numClippingPlanes:a.numPlanes,numClipIntersection:a.numIntersection,dithering:i.dithering,shadowMapEnabled:e.shadowMap.enabled&&l.length>0,shadowMapType:e.shadowMap.type,toneMapping:Pe,decodeVideoTexture:ee&&i.map.isVideoTexture===!0&&Ve.getTransfer(i.map.colorSpace)===`srgb`,decodeVideoTextureEmissive:se&&i.emissiveMap.isVideoTexture===!0&&Ve.getTransfer(i.emissiveMap.colorSpace)===`srgb`,premultipliedAlpha:i.premultipliedAlpha,doubleSided:i.side===2,flipSided:i.side===1,useDepthPacking:i.depthPacking>=0,depthPacking:i.depthPacking||0,index0AttributeName:i.index0AttributeName,extensionClipCullDistance:Ne&&i.extensions.clipCullDistance===!0&&n.has(`WEBGL_clip_cull_distance`),extensionMultiDraw:(Ne&&i.extensions.multiDraw===!0||N)&&n.has(`WEBGL_multi_draw`),rendererExtensionParallelShaderCompile:n.has(`KHR_parallel_shader_compile`),customProgramCacheKey:i.customProgramCacheKey()};return Ie.vertexUv1s=c.has(1),Ie.vertexUv2s=c.has(2),Ie.vertexUv3s=c.has(3),c.clear(),Ie}function h(t){let n=[];if(t.shaderID?n.push(t.shaderID):(n.push(t.customVertexShaderID),n.push(t.customFragmentShaderID)),t.defines!==void 0)for(let e in t.defines)n.push(e),n.push(t.defines[e]);return t.isRawShaderMaterial===!1&&(g(n,t),_(n,t),n.push(e.outputColorSpace)),n.push(t.customProgramCacheKey),n.join()}function g(e,t){e.push(t.precision),e.push(t.outputColorSpace),e.push(t.envMapMode),e.push(t.envMapPMREM),e.push(t.envMapMaxLod),e.push(t.envMapSize),e.push(t.mapUv),e.push(t.alphaMapUv),e.push(t.lightMapUv),e.push(t.aoMapUv),e.push(t.bumpMapUv),e.push(t.normalMapUv),e.push(t.displacementMapUv),e.push(t.emissiveMapUv),e.push(t.metalnessMapUv),e.push(t.roughnessMapUv),e.push(t.anisotropyMapUv),e.push(t.clearcoatMapUv),e.push(t.clearcoatNormalMapUv),e.push(t.clearcoatRoughnessMapUv),e.push(t.diffuseRoughnessMapUv),e.push(t.iridescenceMapUv),e.push(t.iridescenceThicknessMapUv),e.push(t.sheenColorMapUv),e.push(t.sheenRoughnessMapUv),e.push(t.specularMapUv),e.push(t.specularColorMapUv),e.push(t.specularIntensityMapUv),e.push(t.transmissionMapUv),e.push(t.thicknessMapUv),e.push(t.combine),e.push(t.fogExp2),e.push(t.sizeAttenuation),e.push(t.morphTargetsCount),e.push(t.numSunLights),e.push(t.numDirLights),e.push(t.numPointLights),e.push(t.numSpotLights),e.push(t.numSpotLightMaps),e.push(t.numHemiLights),e.push(t.numRectAreaLights),e.push(t.numSunLightShadows),e.push(t.numDirLightShadows),e.push(t.numPointLightShadows),e.push(t.numSpotLightShadows),e.push(t.numSpotLightShadowsWithMaps),e.push(t.numLightProbes),e.push(t.numLightProbeGrids),e.push(t.shadowMapType),e.push(t.toneMapping),e.push(t.numClippingPlanes),e.push(t.numClipIntersection),e.push(t.depthPacking)}function _(e,t){o.disableAll(),t.instancing&&o.enable(0),t.instancingColor&&o.enable(1),t.instancingMorph&&o.enable(2),t.matcap&&o.enable(3),t.envMap&&o.enable(4),t.normalMapObjectSpace&&o.enable(5),t.normalMapTangentSpace&&o.enable(6),t.clearcoat&&o.enable(7),t.iridescence&&o.enable(8),t.alphaTest&&o.enable(9),t.vertexColors&&o.enable(10),t.vertexAlphas&&o.enable(11),t.vertexUv1s&&o.enable(12),t.vertexUv2s&&o.enable(13),t.vertexUv3s&&o.enable(14),t.vertexTangents&&o.enable(15),t.anisotropy&&o.enable(16),t.alphaHash&&o.enable(17),t.batching&&o.enable(18),t.dispersion&&o.enable(19),t.retroreflection&&o.enable(24),t.diffuseRoughness&&o.enable(25),t.batchingColor&&o.enable(20),t.gradientMap&&o.enable(21),t.packedNormalMap&&o.enable(22),t.vertexNormals&&o.enable(23),e.push(o.mask),o.disableAll(),t.fog&&o.enable(0),t.useFog&&o.enable(1),t.flatShading&&o.enable(2),t.logarithmicDepthBuffer&&o.enable(3),t.reversedDepthBuffer&&o.enable(4),t.skinning&&o.enable(5),t.morphTargets&&o.enable(6),t.morphNormals&&o.enable(7),t.morphColors&&o.enable(8),t.premultipliedAlpha&&o.enable(9),t.shadowMapEnabled&&o.enable(10),t.doubleSided&&o.enable(11),t.flipSided&&o.enable(12),t.useDepthPacking&&o.enable(13),t.dithering&&o.enable(14),t.transmission&&o.enable(15),t.sheen&&o.enable(16),t.opaque&&o.enable(17),t.pointsUvs&&o.enable(18),t.decodeVideoTexture&&o.enable(19),t.decodeVideoTextureEmissive&&o.enable(20),t.alphaToCoverage&&o.enable(21),t.numLightProbeGrids>0&&o.enable(22),t.hasPositionAttribute&&o.enable(23),e.push(o.mask)}function v(e){let t=f[e.type],n;if(t){let e=un[t];n=xe.clone(e.uniforms)}else n=e.uniforms;return n}function y(t,n){let r=u.get(n);return r===void 0?(r=new ji(e,n,t,i),l.push(r),u.set(n,r)):++r.usedTimes,r}function b(e){if(--e.usedTimes===0){let t=l.indexOf(e);l[t]=l[l.length-1],l.pop(),u.delete(e.cacheKey),e.destroy()}}function x(e){s.remove(e)}function S(){s.dispose()}return{getParameters:m,getProgramCacheKey:h,getUniforms:v,acquireProgram:y,releaseProgram:b,releaseShaderCache:x,programs:l,dispose:S}}function Li(){let e=new WeakMap;function t(t){return e.has(t)}function n(t){let n=e.get(t);return n===void 0&&(n={},e.set(t,n)),n}function r(t){e.delete(t)}function i(t,n,r){e.get(t)[n]=r}function a(){e=new WeakMap}return{has:t,get:n,remove:r,update:i,dispose:a}}function Ri(e,t){return e.groupOrder===t.groupOrder?e.renderOrder===t.renderOrder?e.material.id===t.material.id?e.materialVariant===t.materialVariant?e.z===t.z?e.id-t.id:e.z-t.z:e.materialVariant-t.materialVariant:e.material.id-t.material.id:e.renderOrder-t.renderOrder:e.groupOrder-t.groupOrder}function zi(e,t){return e.groupOrder===t.groupOrder?e.renderOrder===t.renderOrder?e.z===t.z?e.id-t.id:t.z-e.z:e.renderOrder-t.renderOrder:e.groupOrder-t.groupOrder}function Bi(){let e=[],t=0,n=[],r=[],i=[];function a(){t=0,n.length=0,r.length=0,i.length=0}function o(e){let t=0;return e.isInstancedMesh&&(t+=2),e.isSkinnedMesh&&(t+=1),t}function s(n,r,i,a,s,c){let l=e[t];return l===void 0?(l={id:n.id,object:n,geometry:r,material:i,materialVariant:o(n),groupOrder:a,renderOrder:n.renderOrder,z:s,group:c},e[t]=l):(l.id=n.id,l.object=n,l.geometry=r,l.material=i,l.materialVariant=o(n),l.groupOrder=a,l.renderOrder=n.renderOrder,l.z=s,l.group=c),t++,l}function c(e,t,a,o,c,l,u){u.reversedDepth===!0&&(c=-c);let d=s(e,t,a,o,c,l);a.transmission>0?r.push(d):a.transparent===!0?i.push(d):n.push(d)}function l(e,t,a,o,c,l){let u=s(e,t,a,o,c,l);a.transmission>0?r.unshift(u):a.transparent===!0?i.unshift(u):n.unshift(u)}function u(e,t){n.length>1&&n.sort(e||Ri),r.length>1&&r.sort(t||zi),i.length>1&&i.sort(t||zi)}function d(){for(let n=t,r=e.length;n<r;n++){let t=e[n];if(t.id===null)break;t.id=null,t.object=null,t.geometry=null,t.material=null,t.group=null}}return{opaque:n,transmissive:r,transparent:i,init:a,push:c,unshift:l,finish:d,sort:u}}function Vi(){let e=new WeakMap;function t(t,n){let r=e.get(t),i;return r===void 0?(i=new Bi,e.set(t,[i])):n>=r.length?(i=new Bi,r.push(i)):i=r[n],i}function n(){e=new WeakMap}return{get:t,dispose:n}}function Hi(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case`SunLight`:case`DirectionalLight`:n={direction:new j,color:new G};break;case`SpotLight`:n={position:new j,direction:new j,color:new G,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case`PointLight`:n={position:new j,color:new G,distance:0,decay:0};break;case`HemisphereLight`:n={direction:new j,skyColor:new G,groundColor:new G};break;case`RectAreaLight`:n={color:new G,position:new j,halfWidth:new j,halfHeight:new j}}return e[t.id]=n,n}}}function Ui(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case`SunLight`:case`DirectionalLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new I};break;case`SpotLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new I};break;case`PointLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new I,shadowCameraNear:1,shadowCameraFar:1e3}}return e[t.id]=n,n}}}var Wi=0;function Gi(e,t){return(t.castShadow?2:0)-(e.castShadow?2:0)+ +!!t.map-!!e.map}function Ki(e){let t=new Hi,n=Ui(),r={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let e=0;e<9;e++)r.probe.push(new j);let i=new j,a=new b,o=new b;function s(i){let a=0,o=0,s=0;for(let e=0;e<9;e++)r.probe[e].set(0,0,0);let c=0,l=0,u=0,d=0,f=0,p=0,m=0,h=0,g=0,_=0,v=0,y=0,b=0,x=0;i.sort(Gi);for(let e=0,S=i.length;e<S;e++){let S=i[e],C=S.color,w=S.intensity,T=S.distance,E=null;if(S.shadow&&S.shadow.map&&(E=S.shadow.map.texture.format===1030?S.shadow.map.texture:S.shadow.map.depthTexture||S.shadow.map.texture),S.isAmbientLight)a+=C.r*w,o+=C.g*w,s+=C.b*w;else if(S.isLightProbe){for(let e=0;e<9;e++)r.probe[e].addScaledVector(S.sh.coefficients[e],w);x++}else if(S.isSunLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize.copy(e.mapSize).multiply(e.getFrameExtents()),r.sunShadow[l]=t,r.sunShadowMap[l]=E;let i=e.getViewportCount();for(let t=0;t<i;t++)r.sunShadowMatrix[u+t]=e.getMatrix(t),r.sunShadowCascade[u+t]=e._cascadeData[t];u+=i,l++}r.sun[c]=e,c++}else if(S.isDirectionalLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize=e.mapSize,r.directionalShadow[d]=t,r.directionalShadowMap[d]=E,r.directionalShadowMatrix[d]=S.shadow.matrix,g++}r.directional[d]=e,d++}else if(S.isSpotLight){let e=t.get(S);e.position.setFromMatrixPosition(S.matrixWorld),e.color.copy(C).multiplyScalar(w),e.distance=T,e.coneCos=Math.cos(S.angle),e.penumbraCos=Math.cos(S.angle*(1-S.penumbra)),e.decay=S.decay,r.spot[p]=e;let i=S.shadow;if(S.map&&(r.spotLightMap[y]=S.map,y++,i.updateMatrices(S),S.castShadow&&b++),r.spotLightMatrix[p]=i.matrix,S.castShadow){let e=n.get(S);e.shadowIntensity=i.intensity,e.shadowBias=i.bias,e.shadowNormalBias=i.normalBias,e.shadowRadius=i.radius,e.shadowMapSize=i.mapSize,r.spotShadow[p]=e,r.spotShadowMap[p]=E,v++}p++}else if(S.isRectAreaLight){let e=t.get(S);e.color.copy(C).multiplyScalar(w),e.halfWidth.set(S.width*.5,0,0),e.halfHeight.set(0,S.height*.5,0),r.rectArea[m]=e,m++}else if(S.isPointLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),e.distance=S.distance,e.decay=S.decay,S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize=e.mapSize,t.shadowCameraNear=e.camera.near,t.shadowCameraFar=e.camera.far,r.pointShadow[f]=t,r.pointShadowMap[f]=E,r.pointShadowMatrix[f]=S.shadow.matrix,_++}r.point[f]=e,f++}else if(S.isHemisphereLight){let e=t.get(S);e.skyColor.copy(S.color).multiplyScalar(w),e.groundColor.copy(S.groundColor).multiplyScalar(w),r.hemi[h]=e,h++}}m>0&&(e.has(`OES_texture_float_linear`)===!0?(r.rectAreaLTC1=J.LTC_FLOAT_1,r.rectAreaLTC2=J.LTC_FLOAT_2):(r.rectAreaLTC1=J.LTC_HALF_1,r.rectAreaLTC2=J.LTC_HALF_2)),r.ambient[0]=a,r.ambient[1]=o,r.ambient[2]=s;let S=r.hash;(S.sunLength!==c||S.directionalLength!==d||S.pointLength!==f||S.spotLength!==p||S.rectAreaLength!==m||S.hemiLength!==h||S.numSunShadows!==l||S.numDirectionalShadows!==g||S.numPointShadows!==_||S.numSpotShadows!==v||S.numSpotMaps!==y||S.numLightProbes!==x)&&(r.sun.length=c,r.directional.length=d,r.spot.length=p,r.rectArea.length=m,r.point.length=f,r.hemi.length=h,r.sunShadow.length=l,r.sunShadowMap.length=l,r.sunShadowMatrix.length=u,r.sunShadowCascade.length=u,r.directionalShadow.length=g,r.directionalShadowMap.length=g,r.directionalShadowMatrix.length=g,r.pointShadow.length=_,r.pointShadowMap.length=_,r.pointShadowMatrix.length=_,r.spotShadow.length=v,r.spotShadowMap.length=v,r.spotLightMatrix.length=v+y-b,r.spotLightMap.length=y,r.numSpotLightShadowsWithMaps=b,r.numLightProbes=x,S.sunLength=c,S.directionalLength=d,S.pointLength=f,S.spotLength=p,S.rectAreaLength=m,S.hemiLength=h,S.numSunShadows=l,S.numDirectionalShadows=g,S.numPointShadows=_,S.numSpotShadows=v,S.numSpotMaps=y,S.numLightProbes=x,r.version=Wi++)}function c(e,t){let n=0,s=0,c=0,l=0,u=0,d=0,f=t.matrixWorldInverse;for(let t=0,p=e.length;t<p;t++){let p=e[t];if(p.isSunLight){let e=r.sun[n];e.direction.setFromMatrixPosition(p.matrixWorld),e.direction.transformDirection(f),n++}else if(p.isDirectionalLight){let e=r.directional[s];e.direction.setFromMatrixPosition(p.matrixWorld),i.setFromMatrixPosition(p.target.matrixWorld),e.direction.sub(i),e.direction.transformDirection(f),s++}else if(p.isSpotLight){let e=r.spot[l];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),e.direction.setFromMatrixPosition(p.matrixWorld),i.setFromMatrixPosition(p.target.matrixWorld),e.direction.sub(i),e.direction.transformDirection(f),l++}else if(p.isRectAreaLight){let e=r.rectArea[u];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),o.identity(),a.copy(p.matrixWorld),a.premultiply(f),o.extractRotation(a),e.halfWidth.set(p.width*.5,0,0),e.halfHeight.set(0,p.height*.5,0),e.halfWidth.applyMatrix4(o),e.halfHeight.applyMatrix4(o),u++}else if(p.isPointLight){let e=r.point[c];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),c++}else if(p.isHemisphereLight){let e=r.hemi[d];e.direction.setFromMatrixPosition(p.matrixWorld),e.direction.transformDirection(f),d++}}}return{setup:s,setupView:c,state:r}}function qi(e){let t=new Ki(e),n=[],r=[],i=[];function a(e){u.camera=e,n.length=0,r.length=0,i.length=0}function o(e){e.isLightProbeGrid?i.push(e):n.push(e)}function s(e){r.push(e)}function c(){t.setup(n),i.sort((e,t)=>e.priority-t.priority||e.id-t.id)}function l(e){t.setupView(n,e)}let u={lightsArray:n,shadowsArray:r,lightProbeGridArray:i,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:a,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:s}}function Ji(e){let t=new WeakMap;function n(n,r=0){let i=t.get(n),a;return i===void 0?(a=new qi(e),t.set(n,[a])):r>=i.length?(a=new qi(e),i.push(a)):a=i[r],a}function r(){t=new WeakMap}return{get:n,dispose:r}}var Yi=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Xi=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Zi=[new j(1,0,0),new j(-1,0,0),new j(0,1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1)],Qi=[new j(0,-1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1),new j(0,-1,0),new j(0,-1,0)],$i=new b,ea=new j,ta=new j;function na(e,t,n){let r=new Qe,i=new I,a=new I,o=new re,s=new ct,c=new vt,l={},u=n.maxTextureSize,d={0:1,1:0,2:2},f=new it({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new I},radius:{value:4}},vertexShader:Yi,fragmentShader:Xi}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new lt;m.setAttribute(`position`,new Fe(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let h=new H(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=1;let _=this.type;this.render=function(t,n,s){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||t.length===0)return;this.type===2&&(z(`WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead.`),this.type=1);let c=e.getRenderTarget(),l=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),f=e.state;f.setBlending(0),f.buffers.depth.getReversed()===!0?f.buffers.color.setClear(0,0,0,0):f.buffers.color.setClear(1,1,1,1),f.buffers.depth.setTest(!0),f.setScissorTest(!1);let p=_!==this.type;p&&n.traverse(function(e){e.material&&(Array.isArray(e.material)?e.material.forEach(e=>e.needsUpdate=!0):e.material.needsUpdate=!0)});for(let c=0,l=t.length;c<l;c++){let l=t[c],d=l.shadow;if(d===void 0){z(`WebGLShadowMap:`,l,`has no shadow.`);continue}if(d.autoUpdate===!1&&d.needsUpdate===!1)continue;i.copy(d.mapSize);let m=d.getFrameExtents();i.multiply(m),a.copy(d.mapSize),(i.x>u||i.y>u)&&(i.x>u&&(a.x=Math.floor(u/m.x),i.x=a.x*m.x,d.mapSize.x=a.x),i.y>u&&(a.y=Math.floor(u/m.y),i.y=a.y*m.y,d.mapSize.y=a.y));let h=e.state.buffers.depth.getReversed();if(d.camera._reversedDepth=h,d.map===null||p===!0){if(d.map!==null&&(d.map.depthTexture!==null&&(d.map.depthTexture.dispose(),d.map.depthTexture=null),d.map.dispose()),this.type===3){if(l.isPointLight){z(`WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.`);continue}d.map=new ge(i.x,i.y,{format:me,type:A,minFilter:M,magFilter:M,generateMipmaps:!1}),d.map.texture.name=l.name+`.shadowMap`,d.map.depthTexture=new T(i.x,i.y,et),d.map.depthTexture.name=l.name+`.shadowMapDepth`,d.map.depthTexture.format=Dt,d.map.depthTexture.compareFunction=null,d.map.depthTexture.minFilter=dt,d.map.depthTexture.magFilter=dt}else l.isPointLight?(d.map=new yn(i.x),d.map.depthTexture=new Je(i.x,C)):(d.map=new ge(i.x,i.y),d.map.depthTexture=new T(i.x,i.y,C)),d.map.depthTexture.name=l.name+`.shadowMap`,d.map.depthTexture.format=Dt,this.type===1?(d.map.depthTexture.compareFunction=h?518:515,d.map.depthTexture.minFilter=M,d.map.depthTexture.magFilter=M):(d.map.depthTexture.compareFunction=null,d.map.depthTexture.minFilter=dt,d.map.depthTexture.magFilter=dt);d.camera.updateProjectionMatrix()}d.map.isWebGLCubeRenderTarget!==!0&&(d.map.width!==i.x||d.map.height!==i.y)&&d.map.setSize(i.x,i.y);let g=d.map.isWebGLCubeRenderTarget?6:d.getViewportCount();l.isPointLight!==!0&&d.updateMatrices(l,s);let _=d.camera.layers.mask&4294967294?d.camera.layers:s.layers;for(let t=0;t<g;t++){let i=d.getCamera(t);if(l.isPointLight){let e=d.camera,n=d.matrix,r=l.distance||e.far;r!==e.far&&(e.far=r,e.updateProjectionMatrix()),ea.setFromMatrixPosition(l.matrixWorld),e.position.copy(ea),ta.copy(e.position),ta.add(Zi[t]),e.up.copy(Qi[t]),e.lookAt(ta),e.updateMatrixWorld(),n.makeTranslation(-ea.x,-ea.y,-ea.z),$i.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),d._frustum.setFromProjectionMatrix($i,e.coordinateSystem,e.reversedDepth)}if(d.map.isWebGLCubeRenderTarget)e.setRenderTarget(d.map,t),e.clear();else{t===0&&(e.setRenderTarget(d.map),e.clear());let n=d.getViewport(t);o.set(a.x*n.x,a.y*n.y,a.x*n.z,a.y*n.w),f.viewport(o)}r=d.getFrustum(t),b(n,s,i,l,_,this.type)}d.isPointLightShadow!==!0&&this.type===3&&v(d,s),d.needsUpdate=!1}_=this.type,g.needsUpdate=!1,e.setRenderTarget(c,l,d)};function v(n,r){let a=t.update(h);f.defines.VSM_SAMPLES!==n.blurSamples&&(f.defines.VSM_SAMPLES=n.blurSamples,p.defines.VSM_SAMPLES=n.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),n.mapPass===null?n.mapPass=new ge(i.x,i.y,{format:me,type:A}):(n.mapPass.width!==n.map.width||n.mapPass.height!==n.map.height)&&n.mapPass.setSize(n.map.width,n.map.height),f.uniforms.shadow_pass.value=n.map.depthTexture,f.uniforms.resolution.value.set(n.map.width,n.map.height),f.uniforms.radius.value=n.radius,e.setRenderTarget(n.mapPass),e.clear(),e.renderBufferDirect(r,null,a,f,h,null),p.uniforms.shadow_pass.value=n.mapPass.texture,p.uniforms.resolution.value.set(n.map.width,n.map.height),p.uniforms.radius.value=n.radius,e.setRenderTarget(n.map),e.clear(),e.renderBufferDirect(r,null,a,p,h,null)}function y(t,n,r,i){let a=null,o=r.isPointLight===!0?t.customDistanceMaterial:t.customDepthMaterial;if(o!==void 0)a=o;else if(a=r.isPointLight===!0?c:s,e.localClippingEnabled&&n.clipShadows===!0&&Array.isArray(n.clippingPlanes)&&n.clippingPlanes.length!==0||n.displacementMap&&n.displacementScale!==0||n.alphaMap&&n.alphaTest>0||n.map&&n.alphaTest>0||n.alphaToCoverage===!0){let e=a.uuid,t=n.uuid,r=l[e];r===void 0&&(r={},l[e]=r);let i=r[t];i===void 0&&(i=a.clone(),r[t]=i,n.addEventListener(`dispose`,x)),a=i}if(a.visible=n.visible,a.wireframe=n.wireframe,i===3?a.side=n.shadowSide===null?n.side:n.shadowSide:a.side=n.shadowSide===null?d[n.side]:n.shadowSide,a.alphaMap=n.alphaMap,a.alphaTest=n.alphaToCoverage===!0?.5:n.alphaTest,a.map=n.map,a.clipShadows=n.clipShadows,a.clippingPlanes=n.clippingPlanes,a.clipIntersection=n.clipIntersection,a.displacementMap=n.displacementMap,a.displacementScale=n.displacementScale,a.displacementBias=n.displacementBias,a.wireframeLinewidth=n.wireframeLinewidth,a.linewidth=n.linewidth,r.isPointLight===!0&&a.isMeshDistanceMaterial===!0){let t=e.properties.get(a);t.light=r}return a}function b(n,i,a,o,s,c){if(n.visible===!1)return;if(n.layers.test(s)&&(n.isMesh||n.isLine||n.isPoints)&&(n.castShadow||n.receiveShadow&&c===3)&&(!n.frustumCulled||n.intersectsFrustum(r))){n.modelViewMatrix.multiplyMatrices(a.matrixWorldInverse,n.matrixWorld);let r=t.update(n),s=n.material;if(Array.isArray(s)){let t=r.groups;for(let l=0,u=t.length;l<u;l++){let u=t[l],d=s[u.materialIndex];if(d&&d.visible){let t=y(n,d,o,c);n.onBeforeShadow(e,n,i,a,r,t,u),e.renderBufferDirect(a,null,r,t,n,u),n.onAfterShadow(e,n,i,a,r,t,u)}}}else if(s.visible){let t=y(n,s,o,c);n.onBeforeShadow(e,n,i,a,r,t,null),e.renderBufferDirect(a,null,r,t,n,null),n.onAfterShadow(e,n,i,a,r,t,null)}}let l=n.children;for(let e=0,t=l.length;e<t;e++)b(l[e],i,a,o,s,c)}function x(e){e.target.removeEventListener(`dispose`,x);for(let t in l){let n=l[t],r=e.target.uuid;r in n&&(n[r].dispose(),delete n[r])}}}function ra(e,t){function n(){let t=!1,n=new re,r=null,i=new re(0,0,0,0);return{setMask:function(n){r!==n&&!t&&(e.colorMask(n,n,n,n),r=n)},setLocked:function(e){t=e},setClear:function(t,r,a,o,s){s===!0&&(t*=o,r*=o,a*=o),n.set(t,r,a,o),i.equals(n)===!1&&(e.clearColor(t,r,a,o),i.copy(n))},reset:function(){t=!1,r=null,i.set(-1,0,0,0)}}}function r(){let n=!1,r=!1,i=null,a=null,o=null;return{setReversed:function(e){if(r!==e){let n=t.get(`EXT_clip_control`);e?n.clipControlEXT(n.LOWER_LEFT_EXT,n.ZERO_TO_ONE_EXT):n.clipControlEXT(n.LOWER_LEFT_EXT,n.NEGATIVE_ONE_TO_ONE_EXT),r=e;let i=o;o=null,this.setClear(i)}},getReversed:function(){return r},setTest:function(t){t?le(e.DEPTH_TEST):ue(e.DEPTH_TEST)},setMask:function(t){i!==t&&!n&&(e.depthMask(t),i=t)},setFunc:function(t){if(r&&(t=ut[t]),a!==t){switch(t){case 0:e.depthFunc(e.NEVER);break;case 1:e.depthFunc(e.ALWAYS);break;case 2:e.depthFunc(e.LESS);break;case 3:e.depthFunc(e.LEQUAL);break;case 4:e.depthFunc(e.EQUAL);break;case 5:e.depthFunc(e.GEQUAL);break;case 6:e.depthFunc(e.GREATER);break;case 7:e.depthFunc(e.NOTEQUAL);break;default:e.depthFunc(e.LEQUAL)}a=t}},setLocked:function(e){n=e},setClear:function(t){o!==t&&(o=t,r&&(t=1-t),e.clearDepth(t))},reset:function(){n=!1,i=null,a=null,o=null,r=!1}}}function i(){let t=!1,n=null,r=null,i=null,a=null,o=null,s=null,c=null,l=null;return{setTest:function(n){t||(n?le(e.STENCIL_TEST):ue(e.STENCIL_TEST))},setMask:function(r){n!==r&&!t&&(e.stencilMask(r),n=r)},setFunc:function(t,n,o){(r!==t||i!==n||a!==o)&&(e.stencilFunc(t,n,o),r=t,i=n,a=o)},setOp:function(t,n,r){(o!==t||s!==n||c!==r)&&(e.stencilOp(t,n,r),o=t,s=n,c=r)},setLocked:function(e){t=e},setClear:function(t){l!==t&&(e.clearStencil(t),l=t)},reset:function(){t=!1,n=null,r=null,i=null,a=null,o=null,s=null,c=null,l=null}}}let a=new n,o=new r,s=new i,c={},l=new WeakMap,u={},d={},f={},p=new WeakMap,m=[],h=null,g=!1,_=null,v=null,y=null,b=null,x=null,S=null,C=null,w=new G(0,0,0),T=0,E=!1,D=null,O=null,k=null,A=null,j=null,M=e.getParameter(e.MAX_COMBINED_TEXTURE_IMAGE_UNITS),N=!1,ee=0,te=e.getParameter(e.VERSION);te.indexOf(`WebGL`)===-1?te.indexOf(`OpenGL ES`)!==-1&&(ee=parseFloat(/^OpenGL ES (\d)/.exec(te)[1]),N=ee>=2):(ee=parseFloat(/^WebGL (\d)/.exec(te)[1]),N=ee>=1);let ne=null,ie={},P=e.getParameter(e.SCISSOR_BOX),ae=e.getParameter(e.VIEWPORT),F=new re().fromArray(P),oe=new re().fromArray(ae);function se(t,n,r,i){let a=new Uint8Array(4),o=e.createTexture();e.bindTexture(t,o),e.texParameteri(t,e.TEXTURE_MIN_FILTER,e.NEAREST),e.texParameteri(t,e.TEXTURE_MAG_FILTER,e.NEAREST);for(let o=0;o<r;o++)t===e.TEXTURE_3D||t===e.TEXTURE_2D_ARRAY?e.texImage3D(n,0,e.RGBA,1,1,i,0,e.RGBA,e.UNSIGNED_BYTE,a):e.texImage2D(n+o,0,e.RGBA,1,1,0,e.RGBA,e.UNSIGNED_BYTE,a);return o}let ce={};ce[e.TEXTURE_2D]=se(e.TEXTURE_2D,e.TEXTURE_2D,1),ce[e.TEXTURE_CUBE_MAP]=se(e.TEXTURE_CUBE_MAP,e.TEXTURE_CUBE_MAP_POSITIVE_X,6),ce[e.TEXTURE_2D_ARRAY]=se(e.TEXTURE_2D_ARRAY,e.TEXTURE_2D_ARRAY,1,1),ce[e.TEXTURE_3D]=se(e.TEXTURE_3D,e.TEXTURE_3D,1,1),a.setClear(0,0,0,1),o.setClear(1),s.setClear(0),le(e.DEPTH_TEST),o.setFunc(3),ge(!1),_e(1),le(e.CULL_FACE),me(0);function le(t){u[t]!==!0&&(e.enable(t),u[t]=!0)}function ue(t){u[t]!==!1&&(e.disable(t),u[t]=!1)}function de(t,n){return f[t]!==n&&(e.bindFramebuffer(t,n),f[t]=n,t===e.DRAW_FRAMEBUFFER&&(f[e.FRAMEBUFFER]=n),t===e.FRAMEBUFFER&&(f[e.DRAW_FRAMEBUFFER]=n),!0)}function fe(t,n){let r=m,i=!1;if(t){r=p.get(n),r===void 0&&(r=[],p.set(n,r));let a=t.textures;if(r.length!==a.length||r[0]!==e.COLOR_ATTACHMENT0){for(let t=0,n=a.length;t<n;t++)r[t]=e.COLOR_ATTACHMENT0+t;r.length=a.length,i=!0}}else r[0]!==e.BACK&&(r[0]=e.BACK,i=!0);i&&e.drawBuffers(r)}function pe(t){return h!==t&&(e.useProgram(t),h=t,!0)}let I={100:e.FUNC_ADD,101:e.FUNC_SUBTRACT,102:e.FUNC_REVERSE_SUBTRACT};I[103]=e.MIN,I[104]=e.MAX;let L={200:e.ZERO,201:e.ONE,202:e.SRC_COLOR,204:e.SRC_ALPHA,210:e.SRC_ALPHA_SATURATE,208:e.DST_COLOR,206:e.DST_ALPHA,203:e.ONE_MINUS_SRC_COLOR,205:e.ONE_MINUS_SRC_ALPHA,209:e.ONE_MINUS_DST_COLOR,207:e.ONE_MINUS_DST_ALPHA,211:e.CONSTANT_COLOR,212:e.ONE_MINUS_CONSTANT_COLOR,213:e.CONSTANT_ALPHA,214:e.ONE_MINUS_CONSTANT_ALPHA};function me(t,n,r,i,a,o,s,c,l,u){if(t===0)g===!0&&(ue(e.BLEND),g=!1);else if(g===!1&&(le(e.BLEND),g=!0),t!==5){if(t!==_||u!==E){if((v!==100||x!==100)&&(e.blendEquation(e.FUNC_ADD),v=100,x=100),u)switch(t){case 1:e.blendFuncSeparate(e.ONE,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case 2:e.blendFunc(e.ONE,e.ONE);break;case 3:e.blendFuncSeparate(e.ZERO,e.ONE_MINUS_SRC_COLOR,e.ZERO,e.ONE);break;case 4:e.blendFuncSeparate(e.DST_COLOR,e.ONE_MINUS_SRC_ALPHA,e.ZERO,e.ONE);break;default:R(`WebGLState: Invalid blending: `,t)}else switch(t){case 1:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case 2:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE,e.ONE,e.ONE);break;case 3:R(`WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true`);break;case 4:R(`WebGLState: MultiplyBlending requires material.premultipliedAlpha = true`);break;default:R(`WebGLState: Invalid blending: `,t)}y=null,b=null,S=null,C=null,w.set(0,0,0),T=0,_=t,E=u}}else a||=n,o||=r,s||=i,(n!==v||a!==x)&&(e.blendEquationSeparate(I[n],I[a]),v=n,x=a),(r!==y||i!==b||o!==S||s!==C)&&(e.blendFuncSeparate(L[r],L[i],L[o],L[s]),y=r,b=i,S=o,C=s),(c.equals(w)===!1||l!==T)&&(e.blendColor(c.r,c.g,c.b,l),w.copy(c),T=l),_=t,E=!1}function he(t,n){t.side===2?ue(e.CULL_FACE):le(e.CULL_FACE);let r=t.side===1;n&&(r=!r),ge(r),t.blending===1&&t.transparent===!1?me(0):me(t.blending,t.blendEquation,t.blendSrc,t.blendDst,t.blendEquationAlpha,t.blendSrcAlpha,t.blendDstAlpha,t.blendColor,t.blendAlpha,t.premultipliedAlpha),o.setFunc(t.depthFunc),o.setTest(t.depthTest),o.setMask(t.depthWrite),a.setMask(t.colorWrite);let i=t.stencilWrite;s.setTest(i),i&&(s.setMask(t.stencilWriteMask),s.setFunc(t.stencilFunc,t.stencilRef,t.stencilFuncMask),s.setOp(t.stencilFail,t.stencilZFail,t.stencilZPass)),ye(t.polygonOffset,t.polygonOffsetFactor,t.polygonOffsetUnits),t.alphaToCoverage===!0?le(e.SAMPLE_ALPHA_TO_COVERAGE):ue(e.SAMPLE_ALPHA_TO_COVERAGE)}function ge(t){D!==t&&(t?e.frontFace(e.CW):e.frontFace(e.CCW),D=t)}function _e(t){t===0?ue(e.CULL_FACE):(le(e.CULL_FACE),t!==O&&(t===1?e.cullFace(e.BACK):t===2?e.cullFace(e.FRONT):e.cullFace(e.FRONT_AND_BACK))),O=t}function ve(t){t!==k&&(N&&e.lineWidth(t),k=t)}function ye(t,n,r){t?(le(e.POLYGON_OFFSET_FILL),(A!==n||j!==r)&&(A=n,j=r,o.getReversed()&&(n=-n,r=-r),e.polygonOffset(n,r))):ue(e.POLYGON_OFFSET_FILL)}function be(t){t?le(e.SCISSOR_TEST):ue(e.SCISSOR_TEST)}function xe(t){t===void 0&&(t=e.TEXTURE0+M-1),ne!==t&&(e.activeTexture(t),ne=t)}function Se(t,n,r){r===void 0&&(r=ne===null?e.TEXTURE0+M-1:ne);let i=ie[r];i===void 0&&(i={type:void 0,texture:void 0},ie[r]=i),(i.type!==t||i.texture!==n)&&(ne!==r&&(e.activeTexture(r),ne=r),e.bindTexture(t,n||ce[t]),i.type=t,i.texture=n)}function Ce(){let t=ie[ne];t!==void 0&&t.type!==void 0&&(e.bindTexture(t.type,null),t.type=void 0,t.texture=void 0)}function we(){try{e.compressedTexImage2D(...arguments)}catch(e){R(`WebGLState:`,e)}}function Te(){try{e.compressedTexImage3D(...arguments)}catch(e){R(`WebGLState:`,e)}}function Ee(){try{e.texSubImage2D(...arguments)}catch(e){R(`WebGLState:`,e)}}function De(){try{e.texSubImage3D(...arguments)}catch(e){R(`WebGLState:`,e)}}function z(){try{e.compressedTexSubImage2D(...arguments)}catch(e){R(`WebGLState:`,e)}}function Oe(){try{e.compressedTexSubImage3D(...arguments)}catch(e){R(`WebGLState:`,e)}}function ke(){try{e.texStorage2D(...arguments)}catch(e){R(`WebGLState:`,e)}}function Ae(){try{e.texStorage3D(...arguments)}catch(e){R(`WebGLState:`,e)}}function je(){try{e.texImage2D(...arguments)}catch(e){R(`WebGLState:`,e)}}function Me(){try{e.texImage3D(...arguments)}catch(e){R(`WebGLState:`,e)}}function Ne(t){return d[t]===void 0?e.getParameter(t):d[t]}function Pe(t,n){d[t]!==n&&(e.pixelStorei(t,n),d[t]=n)}function Fe(t){F.equals(t)===!1&&(e.scissor(t.x,t.y,t.z,t.w),F.copy(t))}function Ie(t){oe.equals(t)===!1&&(e.viewport(t.x,t.y,t.z,t.w),oe.copy(t))}function Le(t,n){let r=l.get(n);r===void 0&&(r=new WeakMap,l.set(n,r));let i=r.get(t);i===void 0&&(i=e.getUniformBlockIndex(n,t.name),e.uniformBlockBinding(n,i,i),r.set(t,i))}function B(t,n,r){let i=l.get(n).get(t);c[i]!==r&&(e.bindBufferBase(e.UNIFORM_BUFFER,i,r),c[i]=r)}function Re(){e.disable(e.BLEND),e.disable(e.CULL_FACE),e.disable(e.DEPTH_TEST),e.disable(e.POLYGON_OFFSET_FILL),e.disable(e.SCISSOR_TEST),e.disable(e.STENCIL_TEST),e.disable(e.SAMPLE_ALPHA_TO_COVERAGE),e.blendEquation(e.FUNC_ADD),e.blendFunc(e.ONE,e.ZERO),e.blendFuncSeparate(e.ONE,e.ZERO,e.ONE,e.ZERO),e.blendColor(0,0,0,0),e.colorMask(!0,!0,!0,!0),e.clearColor(0,0,0,0),e.depthMask(!0),e.depthFunc(e.LESS),o.setReversed(!1),e.clearDepth(1),e.stencilMask(4294967295),e.stencilFunc(e.ALWAYS,0,4294967295),e.stencilOp(e.KEEP,e.KEEP,e.KEEP),e.clearStencil(0),e.cullFace(e.BACK),e.frontFace(e.CCW),e.polygonOffset(0,0),e.activeTexture(e.TEXTURE0),e.bindFramebuffer(e.FRAMEBUFFER,null),e.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),e.bindFramebuffer(e.READ_FRAMEBUFFER,null),e.useProgram(null),e.lineWidth(1),e.scissor(0,0,e.canvas.width,e.canvas.height),e.viewport(0,0,e.canvas.width,e.canvas.height),e.pixelStorei(e.PACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,!1),e.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),e.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,e.BROWSER_DEFAULT_WEBGL),e.pixelStorei(e.PACK_ROW_LENGTH,0),e.pixelStorei(e.PACK_SKIP_PIXELS,0),e.pixelStorei(e.PACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_ROW_LENGTH,0),e.pixelStorei(e.UNPACK_IMAGE_HEIGHT,0),e.pixelStorei(e.UNPACK_SKIP_PIXELS,0),e.pixelStorei(e.UNPACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_SKIP_IMAGES,0),u={},d={},ne=null,ie={},f={},c={},p=new WeakMap,m=[],h=null,g=!1,_=null,v=null,y=null,b=null,x=null,S=null,C=null,w=new G(0,0,0),T=0,E=!1,D=null,O=null,k=null,A=null,j=null,F.set(0,0,e.canvas.width,e.canvas.height),oe.set(0,0,e.canvas.width,e.canvas.height),a.reset(),o.reset(),s.reset()}return{buffers:{color:a,depth:o,stencil:s},enable:le,disable:ue,bindFramebuffer:de,drawBuffers:fe,useProgram:pe,setBlending:me,setMaterial:he,setFlipSided:ge,setCullFace:_e,setLineWidth:ve,setPolygonOffset:ye,setScissorTest:be,activeTexture:xe,bindTexture:Se,unbindTexture:Ce,compressedTexImage2D:we,compressedTexImage3D:Te,texImage2D:je,texImage3D:Me,pixelStorei:Pe,getParameter:Ne,updateUBOMapping:Le,uniformBlockBinding:B,texStorage2D:ke,texStorage3D:Ae,texSubImage2D:Ee,texSubImage3D:De,compressedTexSubImage2D:z,compressedTexSubImage3D:Oe,scissor:Fe,viewport:Ie,reset:Re}}function ia(e,t,n,r,i,a,o){let s=t.has(`WEBGL_multisampled_render_to_texture`)?t.get(`WEBGL_multisampled_render_to_texture`):null,c=typeof navigator>`u`?!1:/OculusBrowser/g.test(navigator.userAgent),l=new I,u=new WeakMap,d=new Set,f,p=new WeakMap,m=new Set,h=new FinalizationRegistry(e=>m.delete(e)),g=!1;try{g=typeof OffscreenCanvas<`u`&&new OffscreenCanvas(1,1).getContext(`2d`)!==null}catch{}function _(e,t){return g?new OffscreenCanvas(e,t):te(`canvas`)}function v(e,t,n){let r=1,i=B(e);if((i.width>n||i.height>n)&&(r=n/Math.max(i.width,i.height)),r<1){if(typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<`u`&&e instanceof HTMLCanvasElement||typeof ImageBitmap<`u`&&e instanceof ImageBitmap||typeof VideoFrame<`u`&&e instanceof VideoFrame){let n=Math.floor(r*i.width),a=Math.floor(r*i.height);f===void 0&&(f=_(n,a));let o=t?_(n,a):f;return o.width=n,o.height=a,o.getContext(`2d`).drawImage(e,0,0,n,a),z(`WebGLRenderer: Texture has been resized from (`+i.width+`x`+i.height+`) to (`+n+`x`+a+`).`),o}return`data`in e&&z(`WebGLRenderer: Image in DataTexture is too big (`+i.width+`x`+i.height+`).`),e}return e}function y(e){return e.generateMipmaps}function b(t){e.generateMipmap(t)}function x(t){return t.isWebGLCubeRenderTarget?e.TEXTURE_CUBE_MAP:t.isWebGL3DRenderTarget?e.TEXTURE_3D:t.isWebGLArrayRenderTarget||t.isCompressedArrayTexture?e.TEXTURE_2D_ARRAY:e.TEXTURE_2D}function S(n,r,i,a,o,s=!1){if(n!==null){if(e[n]!==void 0)return e[n];z(`WebGLRenderer: Attempt to use non-existing WebGL internal format '`+n+`'`)}let c;a&&(c=t.get(`EXT_texture_norm16`),c||z(`WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension`));let l=r;if(r===e.RED&&(i===e.FLOAT&&(l=e.R32F),i===e.HALF_FLOAT&&(l=e.R16F),i===e.UNSIGNED_BYTE&&(l=e.R8),i===e.UNSIGNED_SHORT&&c&&(l=c.R16_EXT),i===e.SHORT&&c&&(l=c.R16_SNORM_EXT)),r===e.RED_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.R8UI),i===e.UNSIGNED_SHORT&&(l=e.R16UI),i===e.UNSIGNED_INT&&(l=e.R32UI),i===e.BYTE&&(l=e.R8I),i===e.SHORT&&(l=e.R16I),i===e.INT&&(l=e.R32I)),r===e.RG&&(i===e.FLOAT&&(l=e.RG32F),i===e.HALF_FLOAT&&(l=e.RG16F),i===e.UNSIGNED_BYTE&&(l=e.RG8),i===e.UNSIGNED_SHORT&&c&&(l=c.RG16_EXT),i===e.SHORT&&c&&(l=c.RG16_SNORM_EXT)),r===e.RG_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RG8UI),i===e.UNSIGNED_SHORT&&(l=e.RG16UI),i===e.UNSIGNED_INT&&(l=e.RG32UI),i===e.BYTE&&(l=e.RG8I),i===e.SHORT&&(l=e.RG16I),i===e.INT&&(l=e.RG32I)),r===e.RGB_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RGB8UI),i===e.UNSIGNED_SHORT&&(l=e.RGB16UI),i===e.UNSIGNED_INT&&(l=e.RGB32UI),i===e.BYTE&&(l=e.RGB8I),i===e.SHORT&&(l=e.RGB16I),i===e.INT&&(l=e.RGB32I)),r===e.RGBA_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RGBA8UI),i===e.UNSIGNED_SHORT&&(l=e.RGBA16UI),i===e.UNSIGNED_INT&&(l=e.RGBA32UI),i===e.BYTE&&(l=e.RGBA8I),i===e.SHORT&&(l=e.RGBA16I),i===e.INT&&(l=e.RGBA32I)),r===e.RGB&&(i===e.UNSIGNED_SHORT&&c&&(l=c.RGB16_EXT),i===e.SHORT&&c&&(l=c.RGB16_SNORM_EXT),i===e.UNSIGNED_INT_5_9_9_9_REV&&(l=e.RGB9_E5),i===e.UNSIGNED_INT_10F_11F_11F_REV&&(l=e.R11F_G11F_B10F)),r===e.RGBA){let t=s?Oe:Ve.getTransfer(o);i===e.FLOAT&&(l=e.RGBA32F),i===e.HALF_FLOAT&&(l=e.RGBA16F),i===e.UNSIGNED_BYTE&&(l=t===`srgb`?e.SRGB8_ALPHA8:e.RGBA8),i===e.UNSIGNED_SHORT&&c&&(l=c.RGBA16_EXT),i===e.SHORT&&c&&(l=c.RGBA16_SNORM_EXT),i===e.UNSIGNED_SHORT_4_4_4_4&&(l=e.RGBA4),i===e.UNSIGNED_SHORT_5_5_5_1&&(l=e.RGB5_A1)}return(l===e.R16F||l===e.R32F||l===e.RG16F||l===e.RG32F||l===e.RGBA16F||l===e.RGBA32F)&&t.get(`EXT_color_buffer_float`),l}function C(t,n){let r;return t?n===null||n===1014||n===1020?r=e.DEPTH24_STENCIL8:n===1015?r=e.DEPTH32F_STENCIL8:n===1012&&(r=e.DEPTH24_STENCIL8,z(`DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.`)):n===null||n===1014||n===1020?r=e.DEPTH_COMPONENT24:n===1015?r=e.DEPTH_COMPONENT32F:n===1012&&(r=e.DEPTH_COMPONENT16),r}function w(e,t){return y(e)===!0||e.isFramebufferTexture&&e.minFilter!==1003&&e.minFilter!==1006?Math.log2(Math.max(t.width,t.height))+1:e.mipmaps.length>0?e.mipmaps.length:e.isCompressedTexture&&Array.isArray(e.image)?t.mipmaps.length:1}function T(e){let t=new WeakRef(e);r.get(e).__ref=t,m.add(t),h.register(e,t,t)}function E(e){let t=r.get(e).__ref;t!==void 0&&(m.delete(t),h.unregister(t))}function D(e){k(e.target)}function O(e){A(e.target)}function k(e){e.removeEventListener(`dispose`,D),E(e),ee(e),e.isVideoTexture&&u.delete(e),e.isHTMLTexture&&d.delete(e)}function A(e){e.removeEventListener(`dispose`,O),E(e),re(e)}function j(){for(let e of m){let t=e.deref();t!==void 0&&(t.isRenderTarget===!0?A(t):k(t))}m.clear(),d.clear()}function ee(e){let t=r.get(e);if(t.__webglInit===void 0)return;let n=e.source,i=p.get(n);if(i){let r=i[t.__cacheKey];r.usedTimes--,r.usedTimes===0&&ne(e),Object.keys(i).length===0&&p.delete(n)}r.remove(e)}function ne(t){let n=r.get(t);e.deleteTexture(n.__webglTexture);let i=t.source,a=p.get(i);delete a[n.__cacheKey],o.memory.textures--}function re(t){let n=r.get(t);n.__depthDisposeCallback&&n.__depthDisposeCallback();let i=t.depthTexture;if(i&&i.renderTarget===t&&k(i),t.isWebGLCubeRenderTarget)for(let t=0;t<6;t++){if(Array.isArray(n.__webglFramebuffer[t]))for(let r=0;r<n.__webglFramebuffer[t].length;r++)e.deleteFramebuffer(n.__webglFramebuffer[t][r]);else e.deleteFramebuffer(n.__webglFramebuffer[t]);n.__webglDepthbuffer&&e.deleteRenderbuffer(n.__webglDepthbuffer[t])}else{if(Array.isArray(n.__webglFramebuffer))for(let t=0;t<n.__webglFramebuffer.length;t++)e.deleteFramebuffer(n.__webglFramebuffer[t]);else e.deleteFramebuffer(n.__webglFramebuffer);if(n.__webglDepthbuffer&&e.deleteRenderbuffer(n.__webglDepthbuffer),n.__webglMultisampledFramebuffer&&e.deleteFramebuffer(n.__webglMultisampledFramebuffer),n.__webglColorRenderbuffer)for(let t=0;t<n.__webglColorRenderbuffer.length;t++)n.__webglColorRenderbuffer[t]&&e.deleteRenderbuffer(n.__webglColorRenderbuffer[t]);n.__webglDepthRenderbuffer&&e.deleteRenderbuffer(n.__webglDepthRenderbuffer)}let a=t.textures;for(let t=0,n=a.length;t<n;t++){let n=r.get(a[t]);n.__webglTexture&&(e.deleteTexture(n.__webglTexture),o.memory.textures--),r.remove(a[t])}r.remove(t)}let ie=0;function P(){ie=0}function F(){return ie}function oe(e){ie=e}function se(){let e=ie;return e>=i.maxTextures&&z(`WebGLTextures: Trying to use `+(e+1)+` texture units while this GPU supports only `+i.maxTextures),ie+=1,e}function ce(e){let t=[];return t.push(e.wrapS),t.push(e.wrapT),t.push(e.wrapR||0),t.push(e.magFilter),t.push(e.minFilter),t.push(e.anisotropy),t.push(e.internalFormat),t.push(e.format),t.push(e.type),t.push(e.generateMipmaps),t.push(e.mipmapsAutoUpdate),t.push(e.premultiplyAlpha),t.push(e.flipY),t.push(e.unpackAlignment),t.push(e.colorSpace),t.join()}function le(t,i){let a=r.get(t);if(t.isVideoTexture&&Pe(t),t.isRenderTargetTexture===!1&&t.isExternalTexture!==!0&&t.version>0&&a.__version!==t.version){let e=t.image;if(e===null)z(`WebGLRenderer: Texture marked for update but no image data found.`);else if(e.complete===!1)z(`WebGLRenderer: Texture marked for update but image is incomplete`);else{be(a,t,i);return}}else t.isExternalTexture&&(a.__webglTexture=t.sourceTexture?t.sourceTexture:null);n.bindTexture(e.TEXTURE_2D,a.__webglTexture,e.TEXTURE0+i)}function ue(t,i){let a=r.get(t);t.isRenderTargetTexture===!1&&t.version>0&&a.__version!==t.version?be(a,t,i):(t.isExternalTexture&&(a.__webglTexture=t.sourceTexture?t.sourceTexture:null),n.bindTexture(e.TEXTURE_2D_ARRAY,a.__webglTexture,e.TEXTURE0+i))}function de(t,i){let a=r.get(t);t.isRenderTargetTexture===!1&&t.version>0&&a.__version!==t.version?be(a,t,i):n.bindTexture(e.TEXTURE_3D,a.__webglTexture,e.TEXTURE0+i)}function fe(t,i){let a=r.get(t);t.version>0&&a.__version!==t.version?xe(a,t,i):n.bindTexture(e.TEXTURE_CUBE_MAP,a.__webglTexture,e.TEXTURE0+i)}let pe={[Ie]:e.REPEAT,[tt]:e.CLAMP_TO_EDGE,[Le]:e.MIRRORED_REPEAT},L={[dt]:e.NEAREST,[Be]:e.NEAREST_MIPMAP_NEAREST,[yt]:e.NEAREST_MIPMAP_LINEAR,[M]:e.LINEAR,[ht]:e.LINEAR_MIPMAP_NEAREST,[ae]:e.LINEAR_MIPMAP_LINEAR},me={512:e.NEVER,519:e.ALWAYS,513:e.LESS,515:e.LEQUAL,514:e.EQUAL,518:e.GEQUAL,516:e.GREATER,517:e.NOTEQUAL};function he(n,a){if(a.type===1015&&t.has(`OES_texture_float_linear`)===!1&&(a.magFilter===1006||a.magFilter===1007||a.magFilter===1005||a.magFilter===1008||a.minFilter===1006||a.minFilter===1007||a.minFilter===1005||a.minFilter===1008)&&z(`WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device.`),e.texParameteri(n,e.TEXTURE_WRAP_S,pe[a.wrapS]),e.texParameteri(n,e.TEXTURE_WRAP_T,pe[a.wrapT]),(n===e.TEXTURE_3D||n===e.TEXTURE_2D_ARRAY)&&e.texParameteri(n,e.TEXTURE_WRAP_R,pe[a.wrapR]),e.texParameteri(n,e.TEXTURE_MAG_FILTER,L[a.magFilter]),e.texParameteri(n,e.TEXTURE_MIN_FILTER,L[a.minFilter]),a.compareFunction&&(e.texParameteri(n,e.TEXTURE_COMPARE_MODE,e.COMPARE_REF_TO_TEXTURE),e.texParameteri(n,e.TEXTURE_COMPARE_FUNC,me[a.compareFunction])),t.has(`EXT_texture_filter_anisotropic`)===!0){if(a.magFilter===1003||a.minFilter!==1005&&a.minFilter!==1008||a.type===1015&&t.has(`OES_texture_float_linear`)===!1)return;if(a.anisotropy>1||r.get(a).__currentAnisotropy){let o=t.get(`EXT_texture_filter_anisotropic`);e.texParameterf(n,o.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(a.anisotropy,i.getMaxAnisotropy())),r.get(a).__currentAnisotropy=a.anisotropy}}}function ge(t,n){let r=!1;t.__webglInit===void 0&&(t.__webglInit=!0,n.addEventListener(`dispose`,D),T(n));let i=n.source,a=p.get(i);a===void 0&&(a={},p.set(i,a));let s=ce(n);if(s!==t.__cacheKey){a[s]===void 0&&(a[s]={texture:e.createTexture(),usedTimes:0},o.memory.textures++,r=!0),a[s].usedTimes++;let i=a[t.__cacheKey];i!==void 0&&(a[t.__cacheKey].usedTimes--,i.usedTimes===0&&ne(n)),t.__cacheKey=s,t.__webglTexture=a[s].texture}return r}function ve(e,t,n){return Math.floor(Math.floor(e/n)/t)}function ye(t,r,i,a){let o=t.updateRanges;if(o.length===0)n.texSubImage2D(e.TEXTURE_2D,0,0,0,r.width,r.height,i,a,r.data);else{o.sort((e,t)=>e.start-t.start);let s=0;for(let e=1;e<o.length;e++){let t=o[s],n=o[e],i=t.start+t.count,a=ve(n.start,r.width,4),c=ve(t.start,r.width,4);n.start<=i+1&&a===c&&ve(n.start+n.count-1,r.width,4)===a?t.count=Math.max(t.count,n.start+n.count-t.start):(++s,o[s]=n)}o.length=s+1;let c=n.getParameter(e.UNPACK_ROW_LENGTH),l=n.getParameter(e.UNPACK_SKIP_PIXELS),u=n.getParameter(e.UNPACK_SKIP_ROWS);n.pixelStorei(e.UNPACK_ROW_LENGTH,r.width);for(let t=0,s=o.length;t<s;t++){let s=o[t],c=Math.floor(s.start/4),l=Math.ceil(s.count/4),u=c%r.width,d=Math.floor(c/r.width),f=l;n.pixelStorei(e.UNPACK_SKIP_PIXELS,u),n.pixelStorei(e.UNPACK_SKIP_ROWS,d),n.texSubImage2D(e.TEXTURE_2D,0,u,d,f,1,i,a,r.data)}t.clearUpdateRanges(),n.pixelStorei(e.UNPACK_ROW_LENGTH,c),n.pixelStorei(e.UNPACK_SKIP_PIXELS,l),n.pixelStorei(e.UNPACK_SKIP_ROWS,u)}}function be(t,o,s){let c=e.TEXTURE_2D;(o.isDataArrayTexture||o.isCompressedArrayTexture)&&(c=e.TEXTURE_2D_ARRAY),o.isData3DTexture&&(c=e.TEXTURE_3D);let l=ge(t,o),u=o.source;n.bindTexture(c,t.__webglTexture,e.TEXTURE0+s);let f=r.get(u);if(u.version!==f.__version||l===!0){if(n.activeTexture(e.TEXTURE0+s),!(typeof ImageBitmap<`u`&&o.image instanceof ImageBitmap)){let t=Ve.getPrimaries(Ve.workingColorSpace),r=o.colorSpace===``?null:Ve.getPrimaries(o.colorSpace),i=o.colorSpace===``||t===r?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,o.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,o.premultiplyAlpha),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,i)}n.pixelStorei(e.UNPACK_ALIGNMENT,o.unpackAlignment);let t=v(o.image,!1,i.maxTextureSize);t=Fe(o,t);let r=a.convert(o.format,o.colorSpace),p=a.convert(o.type),m=S(o.internalFormat,r,p,o.normalized,o.colorSpace,o.isVideoTexture);he(c,o);let h,g=o.mipmaps,_=o.isVideoTexture!==!0,x=f.__version===void 0||l===!0,T=u.dataReady,E=w(o,t);if(o.isDepthTexture)m=C(o.format===_e,o.type),x&&(_?n.texStorage2D(e.TEXTURE_2D,1,m,t.width,t.height):n.texImage2D(e.TEXTURE_2D,0,m,t.width,t.height,0,r,p,null));else if(o.isDataTexture){if(g.length>0){_&&x&&n.texStorage2D(e.TEXTURE_2D,E,m,g[0].width,g[0].height);for(let t=0,i=g.length;t<i;t++)h=g[t],_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,p,h.data):n.texImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,r,p,h.data);o.generateMipmaps=!1}else _?(x&&n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height),T&&ye(o,t,r,p)):n.texImage2D(e.TEXTURE_2D,0,m,t.width,t.height,0,r,p,t.data)}else if(o.isCompressedTexture){if(o.isCompressedArrayTexture){_&&x&&n.texStorage3D(e.TEXTURE_2D_ARRAY,E,m,g[0].width,g[0].height,t.depth);for(let i=0,a=g.length;i<a;i++)if(h=g[i],o.format!==1023){if(r!==null){if(_){if(T){if(o.layerUpdates.size>0){let t=N(h.width,h.height,o.format,o.type);for(let a of o.layerUpdates){let o=h.data.subarray(a*t/h.data.BYTES_PER_ELEMENT,(a+1)*t/h.data.BYTES_PER_ELEMENT);n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,a,h.width,h.height,1,r,o)}}else n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,0,h.width,h.height,t.depth,r,h.data)}}else n.compressedTexImage3D(e.TEXTURE_2D_ARRAY,i,m,h.width,h.height,t.depth,0,h.data,0,0)}else z(`WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()`)}else _?T&&n.texSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,0,h.width,h.height,t.depth,r,p,h.data):n.texImage3D(e.TEXTURE_2D_ARRAY,i,m,h.width,h.height,t.depth,0,r,p,h.data);o.layerUpdates.size>0&&o.clearLayerUpdates()}else{_&&x&&n.texStorage2D(e.TEXTURE_2D,E,m,g[0].width,g[0].height);for(let t=0,i=g.length;t<i;t++)h=g[t],o.format===1023?_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,p,h.data):n.texImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,r,p,h.data):r===null?z(`WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()`):_?T&&n.compressedTexSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,h.data):n.compressedTexImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,h.data)}}else if(o.isDataArrayTexture){if(_){if(x&&n.texStorage3D(e.TEXTURE_2D_ARRAY,E,m,t.width,t.height,t.depth),T){if(o.layerUpdates.size>0){let i=N(t.width,t.height,o.format,o.type);for(let a of o.layerUpdates){let o=t.data.subarray(a*i/t.data.BYTES_PER_ELEMENT,(a+1)*i/t.data.BYTES_PER_ELEMENT);n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,a,t.width,t.height,1,r,p,o)}o.clearLayerUpdates()}else n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,0,t.width,t.height,t.depth,r,p,t.data)}}else n.texImage3D(e.TEXTURE_2D_ARRAY,0,m,t.width,t.height,t.depth,0,r,p,t.data)}else if(o.isData3DTexture)_?(x&&n.texStorage3D(e.TEXTURE_3D,E,m,t.width,t.height,t.depth),T&&n.texSubImage3D(e.TEXTURE_3D,0,0,0,0,t.width,t.height,t.depth,r,p,t.data)):n.texImage3D(e.TEXTURE_3D,0,m,t.width,t.height,t.depth,0,r,p,t.data);else if(o.isFramebufferTexture){if(x){if(_)n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height);else{let i=t.width,a=t.height;for(let t=0;t<E;t++)n.texImage2D(e.TEXTURE_2D,t,m,i,a,0,r,p,null),i>>=1,a>>=1}}}else if(o.isHTMLTexture){if(`texElementImage2D`in e){let n=e.canvas;if(n.hasAttribute(`layoutsubtree`)||n.setAttribute(`layoutsubtree`,`true`),t.parentNode!==n){n.appendChild(t),d.add(o),n.onpaint=e=>{let t=e.changedElements;for(let e of d)t.includes(e.image)&&(e.needsUpdate=!0)},n.requestPaint();return}if(e.texElementImage2D.length===3)e.texElementImage2D(e.TEXTURE_2D,e.RGBA8,t);else{let n=e.RGBA,r=e.RGBA,i=e.UNSIGNED_BYTE;e.texElementImage2D(e.TEXTURE_2D,0,n,r,i,t)}e.texParameteri(e.TEXTURE_2D,e.TEXTURE_MIN_FILTER,e.LINEAR),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_S,e.CLAMP_TO_EDGE),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_T,e.CLAMP_TO_EDGE)}}else if(g.length>0){if(_&&x){let t=B(g[0]);n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height)}for(let t=0,i=g.length;t<i;t++)h=g[t],_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,r,p,h):n.texImage2D(e.TEXTURE_2D,t,m,r,p,h);o.generateMipmaps=!1}else if(_){if(x){let r=B(t);n.texStorage2D(e.TEXTURE_2D,E,m,r.width,r.height)}T&&n.texSubImage2D(e.TEXTURE_2D,0,0,0,r,p,t)}else n.texImage2D(e.TEXTURE_2D,0,m,r,p,t);y(o)&&o.mipmapsAutoUpdate===!0&&b(c),f.__version=u.version,o.onUpdate&&o.onUpdate(o)}t.__version=o.version}function xe(t,o,s){if(o.image.length!==6)return;let c=ge(t,o),l=o.source;n.bindTexture(e.TEXTURE_CUBE_MAP,t.__webglTexture,e.TEXTURE0+s);let u=r.get(l);if(l.version!==u.__version||c===!0){n.activeTexture(e.TEXTURE0+s);let t=Ve.getPrimaries(Ve.workingColorSpace),r=o.colorSpace===``?null:Ve.getPrimaries(o.colorSpace),d=o.colorSpace===``||t===r?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,o.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,o.premultiplyAlpha),n.pixelStorei(e.UNPACK_ALIGNMENT,o.unpackAlignment),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,d);let f=o.isCompressedTexture||o.image[0].isCompressedTexture,p=o.image[0]&&o.image[0].isDataTexture,m=[];for(let e=0;e<6;e++)!f&&!p?m[e]=v(o.image[e],!0,i.maxCubemapSize):m[e]=p?o.image[e].image:o.image[e],m[e]=Fe(o,m[e]);let h=m[0],g=a.convert(o.format,o.colorSpace),_=a.convert(o.type),x=S(o.internalFormat,g,_,o.normalized,o.colorSpace),T=o.isVideoTexture!==!0,E=u.__version===void 0||c===!0,D=l.dataReady,O=w(o,h);he(e.TEXTURE_CUBE_MAP,o);let k;if(o.isDepthTexture){if(x=C(o.format===_e,o.type),E){if(T)n.texStorage2D(e.TEXTURE_CUBE_MAP,1,x,h.width,h.height);else for(let t=0;t<6;t++)n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,h.width,h.height,0,g,_,null)}}else if(f){T&&E&&n.texStorage2D(e.TEXTURE_CUBE_MAP,O,x,h.width,h.height);for(let t=0;t<6;t++){k=m[t].mipmaps;for(let r=0;r<k.length;r++){let i=k[r];o.format===1023?T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,0,0,i.width,i.height,g,_,i.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,x,i.width,i.height,0,g,_,i.data):g===null?z(`WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()`):T?D&&n.compressedTexSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,0,0,i.width,i.height,g,i.data):n.compressedTexImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,x,i.width,i.height,0,i.data)}}}else{if(k=o.mipmaps,T&&E){k.length>0&&O++;let t=B(m[0]);n.texStorage2D(e.TEXTURE_CUBE_MAP,O,x,t.width,t.height)}for(let t=0;t<6;t++)if(p){T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,0,0,m[t].width,m[t].height,g,_,m[t].data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,m[t].width,m[t].height,0,g,_,m[t].data);for(let r=0;r<k.length;r++){let i=k[r].image[t].image;T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,0,0,i.width,i.height,g,_,i.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,x,i.width,i.height,0,g,_,i.data)}}else{T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,0,0,g,_,m[t]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,g,_,m[t]);for(let r=0;r<k.length;r++){let i=k[r];T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,0,0,g,_,i.image[t]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,x,g,_,i.image[t])}}}y(o)&&o.mipmapsAutoUpdate===!0&&b(e.TEXTURE_CUBE_MAP),u.__version=l.version,o.onUpdate&&o.onUpdate(o)}t.__version=o.version}function Se(t,i,o,c,l,u){let d=a.convert(o.format,o.colorSpace),f=a.convert(o.type),p=S(o.internalFormat,d,f,o.normalized,o.colorSpace),m=r.get(i),h=r.get(o);if(h.__renderTarget=i,!m.__hasExternalTextures){let t=Math.max(1,i.width>>u),r=Math.max(1,i.height>>u);l===e.TEXTURE_3D||l===e.TEXTURE_2D_ARRAY?n.texImage3D(l,u,p,t,r,i.depth,0,d,f,null):n.texImage2D(l,u,p,t,r,0,d,f,null)}n.bindFramebuffer(e.FRAMEBUFFER,t),Ne(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,c,l,h.__webglTexture,0,Me(i)):(l===e.TEXTURE_2D||l>=e.TEXTURE_CUBE_MAP_POSITIVE_X&&l<=e.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&e.framebufferTexture2D(e.FRAMEBUFFER,c,l,h.__webglTexture,u),n.bindFramebuffer(e.FRAMEBUFFER,null)}function Ce(t,n,r){if(e.bindRenderbuffer(e.RENDERBUFFER,t),n.depthBuffer){let i=n.depthTexture,a=i&&i.isDepthTexture?i.type:null,o=C(n.stencilBuffer,a),c=n.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;Ne(n)?s.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,Me(n),o,n.width,n.height):r?e.renderbufferStorageMultisample(e.RENDERBUFFER,Me(n),o,n.width,n.height):e.renderbufferStorage(e.RENDERBUFFER,o,n.width,n.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,c,e.RENDERBUFFER,t)}else{let t=n.textures;for(let i=0;i<t.length;i++){let o=t[i],c=a.convert(o.format,o.colorSpace),l=a.convert(o.type),u=S(o.internalFormat,c,l,o.normalized,o.colorSpace);Ne(n)?s.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,Me(n),u,n.width,n.height):r?e.renderbufferStorageMultisample(e.RENDERBUFFER,Me(n),u,n.width,n.height):e.renderbufferStorage(e.RENDERBUFFER,u,n.width,n.height)}}e.bindRenderbuffer(e.RENDERBUFFER,null)}function we(t,i,a){let o=i.isWebGLCubeRenderTarget===!0;if(n.bindFramebuffer(e.FRAMEBUFFER,t),!(i.depthTexture&&i.depthTexture.isDepthTexture))throw Error(`THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.`);let c=r.get(i.depthTexture);c.__renderTarget=i;let l=o?i.depthTexture.image[0]:i.depthTexture.image;c.__webglTexture&&l.width===i.width&&l.height===i.height||(l.width=i.width,l.height=i.height,i.depthTexture.needsUpdate=!0),o?fe(i.depthTexture,0):le(i.depthTexture,0);let u=c.__webglTexture,d=Me(i),f=o?e.TEXTURE_CUBE_MAP_POSITIVE_X+a:e.TEXTURE_2D,p=i.depthTexture.format===1027?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;if(i.depthTexture.format===1026)Ne(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,p,f,u,0,d):e.framebufferTexture2D(e.FRAMEBUFFER,p,f,u,0);else if(i.depthTexture.format===1027)Ne(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,p,f,u,0,d):e.framebufferTexture2D(e.FRAMEBUFFER,p,f,u,0);else throw Error(`THREE.WebGLTextures: Unknown depthTexture format.`)}function Te(t){let i=r.get(t),a=t.isWebGLCubeRenderTarget===!0;if(i.__boundDepthTexture!==t.depthTexture){let e=t.depthTexture;if(i.__depthDisposeCallback&&i.__depthDisposeCallback(),e){let t=()=>{delete i.__boundDepthTexture,delete i.__depthDisposeCallback,e.removeEventListener(`dispose`,t)};e.addEventListener(`dispose`,t),i.__depthDisposeCallback=t}i.__boundDepthTexture=e}if(t.depthTexture&&!i.__autoAllocateDepthBuffer){if(a)for(let e=0;e<6;e++)we(i.__webglFramebuffer[e],t,e);else t.texture.mipmaps.length>0?we(i.__webglFramebuffer[0],t,0):we(i.__webglFramebuffer,t,0)}else if(a){i.__webglDepthbuffer=[];for(let r=0;r<6;r++)if(n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer[r]),i.__webglDepthbuffer[r]===void 0)i.__webglDepthbuffer[r]=e.createRenderbuffer(),Ce(i.__webglDepthbuffer[r],t,!1);else{let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,a=i.__webglDepthbuffer[r];e.bindRenderbuffer(e.RENDERBUFFER,a),e.framebufferRenderbuffer(e.FRAMEBUFFER,n,e.RENDERBUFFER,a)}}else if(t.texture.mipmaps.length>0?n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer[0]):n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer),i.__webglDepthbuffer===void 0)i.__webglDepthbuffer=e.createRenderbuffer(),Ce(i.__webglDepthbuffer,t,!1);else{let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,r=i.__webglDepthbuffer;e.bindRenderbuffer(e.RENDERBUFFER,r),e.framebufferRenderbuffer(e.FRAMEBUFFER,n,e.RENDERBUFFER,r)}n.bindFramebuffer(e.FRAMEBUFFER,null)}function Ee(t,n,i){let a=r.get(t);n!==void 0&&Se(a.__webglFramebuffer,t,t.texture,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,0),i!==void 0&&Te(t)}function De(t){let i=t.texture,s=r.get(t),c=r.get(i);t.addEventListener(`dispose`,O),T(t);let l=t.textures,u=t.isWebGLCubeRenderTarget===!0,d=l.length>1;if(d||(c.__webglTexture===void 0&&(c.__webglTexture=e.createTexture()),c.__version=i.version,o.memory.textures++),u){s.__webglFramebuffer=[];for(let t=0;t<6;t++)if(i.mipmaps.length>0){s.__webglFramebuffer[t]=[];for(let n=0;n<i.mipmaps.length;n++)s.__webglFramebuffer[t][n]=e.createFramebuffer()}else s.__webglFramebuffer[t]=e.createFramebuffer()}else{if(i.mipmaps.length>0){s.__webglFramebuffer=[];for(let t=0;t<i.mipmaps.length;t++)s.__webglFramebuffer[t]=e.createFramebuffer()}else s.__webglFramebuffer=e.createFramebuffer();if(d)for(let t=0,n=l.length;t<n;t++){let n=r.get(l[t]);n.__webglTexture===void 0&&(n.__webglTexture=e.createTexture(),o.memory.textures++)}if(t.samples>0&&Ne(t)===!1){s.__webglMultisampledFramebuffer=e.createFramebuffer(),s.__webglColorRenderbuffer=[],n.bindFramebuffer(e.FRAMEBUFFER,s.__webglMultisampledFramebuffer);for(let n=0;n<l.length;n++){let r=l[n];s.__webglColorRenderbuffer[n]=e.createRenderbuffer(),e.bindRenderbuffer(e.RENDERBUFFER,s.__webglColorRenderbuffer[n]);let i=a.convert(r.format,r.colorSpace),o=a.convert(r.type),c=S(r.internalFormat,i,o,r.normalized,r.colorSpace,t.isXRRenderTarget===!0),u=Me(t);e.renderbufferStorageMultisample(e.RENDERBUFFER,u,c,t.width,t.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+n,e.RENDERBUFFER,s.__webglColorRenderbuffer[n])}e.bindRenderbuffer(e.RENDERBUFFER,null),t.depthBuffer&&(s.__webglDepthRenderbuffer=e.createRenderbuffer(),Ce(s.__webglDepthRenderbuffer,t,!0)),n.bindFramebuffer(e.FRAMEBUFFER,null)}}if(u){n.bindTexture(e.TEXTURE_CUBE_MAP,c.__webglTexture),he(e.TEXTURE_CUBE_MAP,i);for(let n=0;n<6;n++)if(i.mipmaps.length>0)for(let r=0;r<i.mipmaps.length;r++)Se(s.__webglFramebuffer[n][r],t,i,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+n,r);else Se(s.__webglFramebuffer[n],t,i,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+n,0);y(i)?b(e.TEXTURE_CUBE_MAP):i.mipmaps.length>0&&e.texParameteri(e.TEXTURE_CUBE_MAP,e.TEXTURE_MAX_LEVEL,i.mipmaps.length-1),n.unbindTexture()}else if(d){for(let i=0,a=l.length;i<a;i++){let a=l[i],o=r.get(a),c=e.TEXTURE_2D;(t.isWebGL3DRenderTarget||t.isWebGLArrayRenderTarget)&&(c=t.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(c,o.__webglTexture),he(c,a),Se(s.__webglFramebuffer,t,a,e.COLOR_ATTACHMENT0+i,c,0),y(a)&&b(c)}n.unbindTexture()}else{let r=e.TEXTURE_2D;if((t.isWebGL3DRenderTarget||t.isWebGLArrayRenderTarget)&&(r=t.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(r,c.__webglTexture),he(r,i),i.mipmaps.length>0)for(let n=0;n<i.mipmaps.length;n++)Se(s.__webglFramebuffer[n],t,i,e.COLOR_ATTACHMENT0,r,n);else Se(s.__webglFramebuffer,t,i,e.COLOR_ATTACHMENT0,r,0);y(i)?b(r):i.mipmaps.length>0&&e.texParameteri(r,e.TEXTURE_MAX_LEVEL,i.mipmaps.length-1),n.unbindTexture()}t.depthBuffer&&Te(t)}function ke(e){let t=e.textures;for(let i=0,a=t.length;i<a;i++){let a=t[i];if(y(a)&&a.mipmapsAutoUpdate===!0){let t=x(e),i=r.get(a).__webglTexture;n.bindTexture(t,i),b(t),n.unbindTexture()}}}let Ae=[];function je(t){if(t.samples>0){if(Ne(t)===!1){let i=t.textures,a=t.width,o=t.height,s=e.COLOR_BUFFER_BIT,l=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,u=r.get(t),d=i.length>1;if(d)for(let t=0;t<i.length;t++)n.bindFramebuffer(e.FRAMEBUFFER,u.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.RENDERBUFFER,null),n.bindFramebuffer(e.FRAMEBUFFER,u.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.TEXTURE_2D,null,0);n.bindFramebuffer(e.READ_FRAMEBUFFER,u.__webglMultisampledFramebuffer),t.texture.mipmaps.length>0?n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglFramebuffer[0]):n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglFramebuffer);for(let n=0;n<i.length;n++){if(t.resolveDepthBuffer&&(t.depthBuffer&&(s|=e.DEPTH_BUFFER_BIT),t.stencilBuffer&&t.resolveStencilBuffer&&(s|=e.STENCIL_BUFFER_BIT)),d){e.framebufferRenderbuffer(e.READ_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.RENDERBUFFER,u.__webglColorRenderbuffer[n]);let t=r.get(i[n]).__webglTexture;e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,t,0)}e.blitFramebuffer(0,0,a,o,0,0,a,o,s,e.NEAREST),c===!0&&(Ae.length=0,Ae.push(e.COLOR_ATTACHMENT0+n),t.depthBuffer&&t.storeMultisampledDepthBuffer===!1&&Ae.push(l),e.invalidateFramebuffer(e.READ_FRAMEBUFFER,Ae))}if(n.bindFramebuffer(e.READ_FRAMEBUFFER,null),n.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),d)for(let t=0;t<i.length;t++){n.bindFramebuffer(e.FRAMEBUFFER,u.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.RENDERBUFFER,u.__webglColorRenderbuffer[t]);let a=r.get(i[t]).__webglTexture;n.bindFramebuffer(e.FRAMEBUFFER,u.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.TEXTURE_2D,a,0)}n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglMultisampledFramebuffer)}else if(t.depthBuffer&&t.storeMultisampledDepthBuffer===!1&&c){let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;e.invalidateFramebuffer(e.DRAW_FRAMEBUFFER,[n])}}}function Me(e){return Math.min(i.maxSamples,e.samples)}function Ne(e){let n=r.get(e);return e.samples>0&&t.has(`WEBGL_multisampled_render_to_texture`)===!0&&n.__useRenderToTexture!==!1}function Pe(e){let t=o.render.frame;u.get(e)!==t&&(u.set(e,t),e.update())}function Fe(e,t){let n=e.colorSpace,r=e.format,i=e.type;return e.isCompressedTexture===!0||e.isVideoTexture===!0||n!==`srgb-linear`&&n!==``&&(Ve.getTransfer(n)===`srgb`?(r!==1023||i!==1009)&&z(`WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType.`):R(`WebGLTextures: Unsupported texture color space:`,n)),t}function B(e){return typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement?(l.width=e.naturalWidth||e.width,l.height=e.naturalHeight||e.height):typeof VideoFrame<`u`&&e instanceof VideoFrame?(l.width=e.displayWidth,l.height=e.displayHeight):(l.width=e.width,l.height=e.height),l}this.allocateTextureUnit=se,this.resetTextureUnits=P,this.getTextureUnits=F,this.setTextureUnits=oe,this.setTexture2D=le,this.setTexture2DArray=ue,this.setTexture3D=de,this.setTextureCube=fe,this.rebindTextures=Ee,this.setupRenderTarget=De,this.updateRenderTargetMipmap=ke,this.updateMultisampleRenderTarget=je,this.setupDepthRenderbuffer=Te,this.setupFrameBufferTexture=Se,this.useMultisampledRTT=Ne,this.dispose=j}function aa(e,t){function n(n,r=``){let i,a=Ve.getTransfer(r);if(n===1009)return e.UNSIGNED_BYTE;if(n===1017)return e.UNSIGNED_SHORT_4_4_4_4;if(n===1018)return e.UNSIGNED_SHORT_5_5_5_1;if(n===35902)return e.UNSIGNED_INT_5_9_9_9_REV;if(n===35899)return e.UNSIGNED_INT_10F_11F_11F_REV;if(n===1010)return e.BYTE;if(n===1011)return e.SHORT;if(n===1012)return e.UNSIGNED_SHORT;if(n===1013)return e.INT;if(n===1014)return e.UNSIGNED_INT;if(n===1015)return e.FLOAT;if(n===1016)return e.HALF_FLOAT;if(n===1021)return e.ALPHA;if(n===1022)return e.RGB;if(n===1023)return e.RGBA;if(n===1026)return e.DEPTH_COMPONENT;if(n===1027)return e.DEPTH_STENCIL;if(n===1028)return e.RED;if(n===1029)return e.RED_INTEGER;if(n===1030)return e.RG;if(n===1031)return e.RG_INTEGER;if(n===1033)return e.RGBA_INTEGER;if(n===33776||n===33777||n===33778||n===33779){if(a===`srgb`){if(i=t.get(`WEBGL_compressed_texture_s3tc_srgb`),i!==null){if(n===33776)return i.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===33777)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===33778)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===33779)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null}else if(i=t.get(`WEBGL_compressed_texture_s3tc`),i!==null){if(n===33776)return i.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===33777)return i.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===33778)return i.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===33779)return i.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null}if(n===35840||n===35841||n===35842||n===35843){if(i=t.get(`WEBGL_compressed_texture_pvrtc`),i!==null){if(n===35840)return i.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===35841)return i.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===35842)return i.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===35843)return i.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null}if(n===36196||n===37492||n===37496||n===37488||n===37489||n===37490||n===37491){if(i=t.get(`WEBGL_compressed_texture_etc`),i!==null){if(n===36196||n===37492)return a===`srgb`?i.COMPRESSED_SRGB8_ETC2:i.COMPRESSED_RGB8_ETC2;if(n===37496)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:i.COMPRESSED_RGBA8_ETC2_EAC;if(n===37488)return i.COMPRESSED_R11_EAC;if(n===37489)return i.COMPRESSED_SIGNED_R11_EAC;if(n===37490)return i.COMPRESSED_RG11_EAC;if(n===37491)return i.COMPRESSED_SIGNED_RG11_EAC}else return null}if(n===37808||n===37809||n===37810||n===37811||n===37812||n===37813||n===37814||n===37815||n===37816||n===37817||n===37818||n===37819||n===37820||n===37821){if(i=t.get(`WEBGL_compressed_texture_astc`),i!==null){if(n===37808)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:i.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===37809)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:i.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===37810)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:i.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===37811)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:i.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===37812)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:i.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===37813)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:i.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===37814)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:i.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===37815)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:i.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===37816)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:i.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===37817)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:i.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===37818)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:i.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===37819)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:i.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===37820)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:i.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===37821)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:i.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null}if(n===36492||n===36494||n===36495){if(i=t.get(`EXT_texture_compression_bptc`),i!==null){if(n===36492)return a===`srgb`?i.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:i.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===36494)return i.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===36495)return i.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null}if(n===36283||n===36284||n===36285||n===36286){if(i=t.get(`EXT_texture_compression_rgtc`),i!==null){if(n===36283)return i.COMPRESSED_RED_RGTC1_EXT;if(n===36284)return i.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===36285)return i.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===36286)return i.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null}return n===1020?e.UNSIGNED_INT_24_8:e[n]===void 0?null:e[n]}return{convert:n}}var oa=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,sa=`
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

}`,ca=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new D(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new it({vertexShader:oa,fragmentShader:sa,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new H(new Ge(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},la=class extends O{constructor(e,t){super();let n=this,r=null,i=1,a=null,o=`local-floor`,s=1,c=null,l=null,u=null,d=null,f=null,p=null,m=typeof XRWebGLBinding<`u`,h=new ca,g={},_=t.getContextAttributes(),v=null,y=null,b=[],x=[],S=new I,w=null,E=null,O=new St;O.viewport=new re;let A=new St;A.viewport=new re;let j=[O,A],M=new ot,N=null,ee=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(e){let t=b[e];return t===void 0&&(t=new Nt,b[e]=t),t.getTargetRaySpace()},this.getControllerGrip=function(e){let t=b[e];return t===void 0&&(t=new Nt,b[e]=t),t.getGripSpace()},this.getHand=function(e){let t=b[e];return t===void 0&&(t=new Nt,b[e]=t),t.getHandSpace()};function te(e){let t=x.indexOf(e.inputSource);if(t===-1)return;let n=b[t];n!==void 0&&(n.update(e.inputSource,e.frame,c||a),n.dispatchEvent({type:e.type,data:e.inputSource}))}function ne(){r.removeEventListener(`select`,te),r.removeEventListener(`selectstart`,te),r.removeEventListener(`selectend`,te),r.removeEventListener(`squeeze`,te),r.removeEventListener(`squeezestart`,te),r.removeEventListener(`squeezeend`,te),r.removeEventListener(`end`,ne),r.removeEventListener(`inputsourceschange`,ie);for(let e=0;e<b.length;e++){let t=x[e];t!==null&&(x[e]=null,b[e].disconnect(t))}N=null,ee=null,h.reset();for(let e in g)delete g[e];if(e.setRenderTarget(v),f=null,d=null,u=null,r=null,y=null,se.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(S.width,S.height,!1),E!==null){let e=E.camera;e.fov=E.fov,e.zoom=E.zoom,e.updateProjectionMatrix(),E=null}n.dispatchEvent({type:`sessionend`})}this.setFramebufferScaleFactor=function(e){i=e,n.isPresenting===!0&&z(`WebXRManager: Cannot change framebuffer scale while presenting.`)},this.setReferenceSpaceType=function(e){o=e,n.isPresenting===!0&&z(`WebXRManager: Cannot change reference space type while presenting.`)},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(e){c=e},this.getBaseLayer=function(){return d===null?f:d},this.getBinding=function(){return u===null&&m&&(u=new XRWebGLBinding(r,t)),u},this.getFrame=function(){return p},this.getSession=function(){return r},this.setSession=async function(l){if(r=l,r!==null){if(v=e.getRenderTarget(),r.addEventListener(`select`,te),r.addEventListener(`selectstart`,te),r.addEventListener(`selectend`,te),r.addEventListener(`squeeze`,te),r.addEventListener(`squeezestart`,te),r.addEventListener(`squeezeend`,te),r.addEventListener(`end`,ne),r.addEventListener(`inputsourceschange`,ie),_.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(S),m&&`createProjectionLayer`in XRWebGLBinding.prototype){let n=null,a=null,o=null;_.depth&&(o=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,n=_.stencil?_e:Dt,a=_.stencil?fe:C);let s={colorFormat:t.RGBA8,depthFormat:o,scaleFactor:i};u=this.getBinding(),d=u.createProjectionLayer(s),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),y=new ge(d.textureWidth,d.textureHeight,{format:kt,type:k,depthTexture:new T(d.textureWidth,d.textureHeight,a,void 0,void 0,void 0,void 0,void 0,void 0,n),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let n={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:i};f=new XRWebGLLayer(r,t,n),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new ge(f.framebufferWidth,f.framebufferHeight,{format:kt,type:k,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(s),c=null,a=await r.requestReferenceSpace(o),se.setContext(r),se.start(),n.isPresenting=!0,n.dispatchEvent({type:`sessionstart`})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return h.getDepthTexture()};function ie(e){for(let t=0;t<e.removed.length;t++){let n=e.removed[t],r=x.indexOf(n);r>=0&&(x[r]=null,b[r].disconnect(n))}for(let t=0;t<e.added.length;t++){let n=e.added[t],r=x.indexOf(n);if(r===-1){for(let e=0;e<b.length;e++)if(e>=x.length){x.push(n),r=e;break}else if(x[e]===null){x[e]=n,r=e;break}if(r===-1)break}let i=b[r];i&&i.connect(n)}}function P(e,t){t===null?e.matrixWorld.copy(e.matrix):e.matrixWorld.multiplyMatrices(t.matrixWorld,e.matrix),e.matrixWorldInverse.copy(e.matrixWorld).invert()}this.updateCamera=function(e){if(r===null)return;let t=e.near,n=e.far;h.texture!==null&&(h.depthNear>0&&(t=h.depthNear),h.depthFar>0&&(n=h.depthFar)),M.near=A.near=O.near=t,M.far=A.far=O.far=n,(N!==M.near||ee!==M.far)&&(r.updateRenderState({depthNear:M.near,depthFar:M.far}),N=M.near,ee=M.far),M.layers.mask=e.layers.mask|6,O.layers.mask=M.layers.mask&-5,A.layers.mask=M.layers.mask&-3;let i=e.parent,a=M.cameras;P(M,i);for(let e=0;e<a.length;e++)P(a[e],i);M.projectionMatrix.copy(O.projectionMatrix),M.projectionMatrixInverse.copy(O.projectionMatrixInverse),E===null&&e.isPerspectiveCamera&&(E={camera:e,fov:e.fov,zoom:e.zoom}),ae(e,M,i)};function ae(e,t,n){n===null?e.matrix.copy(t.matrixWorld):(e.matrix.copy(n.matrixWorld),e.matrix.invert(),e.matrix.multiply(t.matrixWorld)),e.matrix.decompose(e.position,e.quaternion,e.scale),e.updateMatrixWorld(!0),e.projectionMatrix.copy(t.projectionMatrix),e.projectionMatrixInverse.copy(t.projectionMatrixInverse),e.isPerspectiveCamera&&(e.fov=Pe*2*Math.atan(1/e.projectionMatrix.elements[5]),e.zoom=1)}this.getCamera=function(){return M},this.getFoveation=function(){if(d!==null||f!==null)return s},this.setFoveation=function(e){s=e,d!==null&&(d.fixedFoveation=e),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=e)},this.hasDepthSensing=function(){return h.texture!==null},this.getDepthSensingMesh=function(){return h.getMesh(M)},this.getCameraTexture=function(e){return g[e]};let F=null;function oe(t,i){if(l=i.getViewerPose(c||a),p=i,l!==null){let t=l.views;f!==null&&(e.setRenderTargetFramebuffer(y,f.framebuffer),e.setRenderTarget(y));let i=!1;t.length!==M.cameras.length&&(M.cameras.length=0,i=!0);for(let n=0;n<t.length;n++){let r=t[n],a=null;if(f!==null)a=f.getViewport(r);else{let t=u.getViewSubImage(d,r);a=t.viewport,n===0&&(e.setRenderTargetTextures(y,t.colorTexture,t.depthStencilTexture),e.setRenderTarget(y))}let o=j[n];o===void 0&&(o=new St,o.layers.enable(n),o.viewport=new re,j[n]=o),o.matrix.fromArray(r.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.projectionMatrix.fromArray(r.projectionMatrix),o.projectionMatrixInverse.copy(o.projectionMatrix).invert(),o.viewport.set(a.x,a.y,a.width,a.height),n===0&&(M.matrix.copy(o.matrix),M.matrix.decompose(M.position,M.quaternion,M.scale)),i===!0&&M.cameras.push(o)}let a=r.enabledFeatures;if(a&&a.includes(`depth-sensing`)&&r.depthUsage==`gpu-optimized`&&m){u=n.getBinding();let e=u.getDepthInformation(t[0]);e&&e.isValid&&e.texture&&h.init(e,r.renderState)}if(a&&a.includes(`camera-access`)&&m){e.state.unbindTexture(),u=n.getBinding();for(let e=0;e<t.length;e++){let n=t[e].camera;if(n){let e=g[n];e||(e=new D,g[n]=e);let t=u.getCameraImage(n);e.sourceTexture=t}}}}for(let e=0;e<b.length;e++){let t=x[e],n=b[e];t!==null&&n!==void 0&&n.update(t,i,c||a)}F&&F(t,i),i.detectedPlanes&&n.dispatchEvent({type:`planesdetected`,data:i}),p=null}let se=new cn;se.setAnimationLoop(oe),this.setAnimationLoop=function(e){F=e},this.dispose=function(){}}},ua=new b,da=new L;da.set(-1,0,0,0,1,0,0,0,1);function fa(e,t){function n(e,t){e.matrixAutoUpdate===!0&&e.updateMatrix(),t.value.copy(e.matrix)}function r(t,n){n.color.getRGB(t.fogColor.value,F(e)),n.isFog?(t.fogNear.value=n.near,t.fogFar.value=n.far):n.isFogExp2&&(t.fogDensity.value=n.density)}function i(e,t,n,r,i){t.isNodeMaterial?t.uniformsNeedUpdate=!1:t.isMeshBasicMaterial?a(e,t):t.isMeshLambertMaterial?(a(e,t),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)):t.isMeshToonMaterial?(a(e,t),d(e,t)):t.isMeshPhongMaterial?(a(e,t),u(e,t),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)):t.isMeshStandardMaterial?(a(e,t),f(e,t),t.isMeshPhysicalMaterial&&p(e,t,i)):t.isMeshMatcapMaterial?(a(e,t),m(e,t)):t.isMeshDepthMaterial?a(e,t):t.isMeshDistanceMaterial?(a(e,t),h(e,t)):t.isMeshNormalMaterial?a(e,t):t.isLineBasicMaterial?(o(e,t),t.isLineDashedMaterial&&s(e,t)):t.isPointsMaterial?c(e,t,n,r):t.isSpriteMaterial?l(e,t):t.isShadowMaterial?(e.color.value.copy(t.color),e.opacity.value=t.opacity):t.isShaderMaterial&&(t.uniformsNeedUpdate=!1)}function a(e,r){e.opacity.value=r.opacity,r.color&&e.diffuse.value.copy(r.color),r.emissive&&e.emissive.value.copy(r.emissive).multiplyScalar(r.emissiveIntensity),r.map&&(e.map.value=r.map,n(r.map,e.mapTransform)),r.alphaMap&&(e.alphaMap.value=r.alphaMap,n(r.alphaMap,e.alphaMapTransform)),r.bumpMap&&(e.bumpMap.value=r.bumpMap,n(r.bumpMap,e.bumpMapTransform),e.bumpScale.value=r.bumpScale,r.side===1&&(e.bumpScale.value*=-1)),r.normalMap&&(e.normalMap.value=r.normalMap,n(r.normalMap,e.normalMapTransform),e.normalScale.value.copy(r.normalScale),r.side===1&&e.normalScale.value.negate()),r.displacementMap&&(e.displacementMap.value=r.displacementMap,n(r.displacementMap,e.displacementMapTransform),e.displacementScale.value=r.displacementScale,e.displacementBias.value=r.displacementBias),r.emissiveMap&&(e.emissiveMap.value=r.emissiveMap,n(r.emissiveMap,e.emissiveMapTransform)),r.specularMap&&(e.specularMap.value=r.specularMap,n(r.specularMap,e.specularMapTransform)),r.alphaTest>0&&(e.alphaTest.value=r.alphaTest);let i=t.get(r),a=i.envMap,o=i.envMapRotation;a&&(e.envMap.value=a,e.envMapRotation.value.setFromMatrix4(ua.makeRotationFromEuler(o)).transpose(),a.isCubeTexture&&a.isRenderTargetTexture===!1&&e.envMapRotation.value.premultiply(da),e.reflectivity.value=r.reflectivity,e.ior.value=r.ior,e.refractionRatio.value=r.refractionRatio),r.lightMap&&(e.lightMap.value=r.lightMap,e.lightMapIntensity.value=r.lightMapIntensity,n(r.lightMap,e.lightMapTransform)),r.aoMap&&(e.aoMap.value=r.aoMap,e.aoMapIntensity.value=r.aoMapIntensity,n(r.aoMap,e.aoMapTransform))}function o(e,t){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,t.map&&(e.map.value=t.map,n(t.map,e.mapTransform))}function s(e,t){e.dashSize.value=t.dashSize,e.totalSize.value=t.dashSize+t.gapSize,e.scale.value=t.scale}function c(e,t,r,i){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,e.size.value=t.size*r,e.scale.value=i*.5,t.map&&(e.map.value=t.map,n(t.map,e.uvTransform)),t.alphaMap&&(e.alphaMap.value=t.alphaMap,n(t.alphaMap,e.alphaMapTransform)),t.alphaTest>0&&(e.alphaTest.value=t.alphaTest)}function l(e,t){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,e.rotation.value=t.rotation,t.map&&(e.map.value=t.map,n(t.map,e.mapTransform)),t.alphaMap&&(e.alphaMap.value=t.alphaMap,n(t.alphaMap,e.alphaMapTransform)),t.alphaTest>0&&(e.alphaTest.value=t.alphaTest)}function u(e,t){e.specular.value.copy(t.specular),e.shininess.value=Math.max(t.shininess,1e-4)}function d(e,t){t.gradientMap&&(e.gradientMap.value=t.gradientMap)}function f(e,t){e.metalness.value=t.metalness,t.metalnessMap&&(e.metalnessMap.value=t.metalnessMap,n(t.metalnessMap,e.metalnessMapTransform)),e.roughness.value=t.roughness,t.roughnessMap&&(e.roughnessMap.value=t.roughnessMap,n(t.roughnessMap,e.roughnessMapTransform)),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)}function p(e,t,r){e.ior.value=t.ior,t.diffuseRoughness>0&&(e.diffuseRoughness.value=t.diffuseRoughness,t.diffuseRoughnessMap&&(e.diffuseRoughnessMap.value=t.diffuseRoughnessMap,n(t.diffuseRoughnessMap,e.diffuseRoughnessMapTransform))),t.sheen>0&&(e.sheenColor.value.copy(t.sheenColor).multiplyScalar(t.sheen),e.sheenRoughness.value=t.sheenRoughness,t.sheenColorMap&&(e.sheenColorMap.value=t.sheenColorMap,n(t.sheenColorMap,e.sheenColorMapTransform)),t.sheenRoughnessMap&&(e.sheenRoughnessMap.value=t.sheenRoughnessMap,n(t.sheenRoughnessMap,e.sheenRoughnessMapTransform))),t.clearcoat>0&&(e.clearcoat.value=t.clearcoat,e.clearcoatRoughness.value=t.clearcoatRoughness,t.clearcoatMap&&(e.clearcoatMap.value=t.clearcoatMap,n(t.clearcoatMap,e.clearcoatMapTransform)),t.clearcoatRoughnessMap&&(e.clearcoatRoughnessMap.value=t.clearcoatRoughnessMap,n(t.clearcoatRoughnessMap,e.clearcoatRoughnessMapTransform)),t.clearcoatNormalMap&&(e.clearcoatNormalMap.value=t.clearcoatNormalMap,n(t.clearcoatNormalMap,e.clearcoatNormalMapTransform),e.clearcoatNormalScale.value.copy(t.clearcoatNormalScale),t.side===1&&e.clearcoatNormalScale.value.negate())),t.dispersion>0&&(e.dispersion.value=t.dispersion),t.retroreflectivity>0&&(e.retroreflectivity.value=t.retroreflectivity),t.iridescence>0&&(e.iridescence.value=t.iridescence,e.iridescenceIOR.value=t.iridescenceIOR,e.iridescenceThicknessMinimum.value=t.iridescenceThicknessMinimum,e.iridescenceThicknessMaximum.value=t.iridescenceThicknessMaximum,t.iridescenceMap&&(e.iridescenceMap.value=t.iridescenceMap,n(t.iridescenceMap,e.iridescenceMapTransform)),t.iridescenceThicknessMap&&(e.iridescenceThicknessMap.value=t.iridescenceThicknessMap,n(t.iridescenceThicknessMap,e.iridescenceThicknessMapTransform))),t.transmission>0&&(e.transmission.value=t.transmission,e.transmissionSamplerMap.value=r.texture,e.transmissionSamplerSize.value.set(r.width,r.height),t.transmissionMap&&(e.transmissionMap.value=t.transmissionMap,n(t.transmissionMap,e.transmissionMapTransform)),e.thickness.value=t.thickness,t.thicknessMap&&(e.thicknessMap.value=t.thicknessMap,n(t.thicknessMap,e.thicknessMapTransform)),e.attenuationDistance.value=t.attenuationDistance,e.attenuationColor.value.copy(t.attenuationColor)),t.anisotropy>0&&(e.anisotropyVector.value.set(t.anisotropy*Math.cos(t.anisotropyRotation),t.anisotropy*Math.sin(t.anisotropyRotation)),t.anisotropyMap&&(e.anisotropyMap.value=t.anisotropyMap,n(t.anisotropyMap,e.anisotropyMapTransform))),e.specularIntensity.value=t.specularIntensity,e.specularColor.value.copy(t.specularColor),t.specularColorMap&&(e.specularColorMap.value=t.specularColorMap,n(t.specularColorMap,e.specularColorMapTransform)),t.specularIntensityMap&&(e.specularIntensityMap.value=t.specularIntensityMap,n(t.specularIntensityMap,e.specularIntensityMapTransform))}function m(e,t){t.matcap&&(e.matcap.value=t.matcap)}function h(e,n){let r=t.get(n).light;e.referencePosition.value.setFromMatrixPosition(r.matrixWorld),e.nearDistance.value=r.shadow.camera.near,e.farDistance.value=r.shadow.camera.far}return{refreshFogUniforms:r,refreshMaterialUniforms:i}}function pa(e,t,n,r){let i={},a={};function o(e,t){let n=t.program;r.uniformBlockBinding(e,n,i[e.id])}function s(e,n){let o=i[e.id];o===void 0&&(m(e),o=c(e),i[e.id]=o,e.addEventListener(`dispose`,g));let s=n.program;r.updateUBOMapping(e,s);let u=t.render.frame;a[e.id]!==u&&(l(e),a[e.id]=u)}function c(t){let n=e.createBuffer(),r=t.__size,i=t.usage;return e.bindBuffer(e.UNIFORM_BUFFER,n),e.bufferData(e.UNIFORM_BUFFER,r,i),e.bindBuffer(e.UNIFORM_BUFFER,null),n}function l(t){let n=i[t.id],r=t.uniforms,a=t.__cache;e.bindBuffer(e.UNIFORM_BUFFER,n);for(let e=0,t=r.length;e<t;e++){let t=r[e];if(Array.isArray(t))for(let n=0,r=t.length;n<r;n++)u(t[n],e,n,a);else u(t,e,0,a)}e.bindBuffer(e.UNIFORM_BUFFER,null)}function u(t,n,r,i){if(f(t,n,r,i)===!0){let n=t.__offset,r=t.value;if(Array.isArray(r)){let e=0;for(let n=0;n<r.length;n++){let i=r[n],a=h(i,!0);d(i,t.__data,e),e+=a.storage/Float32Array.BYTES_PER_ELEMENT}}else d(r,t.__data,0);e.bufferSubData(e.UNIFORM_BUFFER,n,t.__data)}}function d(e,t,n){typeof e==`number`||typeof e==`boolean`?t[n]=e:e.isMatrix3?(t[n]=e.elements[0],t[n+1]=e.elements[1],t[n+2]=e.elements[2],t[n+3]=0,t[n+4]=e.elements[3],t[n+5]=e.elements[4],t[n+6]=e.elements[5],t[n+7]=0,t[n+8]=e.elements[6],t[n+9]=e.elements[7],t[n+10]=e.elements[8],t[n+11]=0):ArrayBuffer.isView(e)?t.set(e.subarray(0,t.length-n),n):e.toArray(t,n)}function f(e,t,n,r){let i=e.value,a=t+`_`+n;if(Array.isArray(i)){r[a]===void 0&&(r[a]=[]);let e=r[a],t=!1;for(let n=0;n<i.length;n++)p(i[n],e,n)===!0&&(t=!0);return t}return p(i,r,a)}function p(e,t,n){if(t[n]===void 0)return t[n]=typeof e==`number`||typeof e==`boolean`?e:ArrayBuffer.isView(e)?e.slice():e.clone(),!0;{let r=t[n];if(typeof e==`number`||typeof e==`boolean`){if(r!==e)return t[n]=e,!0}else if(ArrayBuffer.isView(e))return!0;else if(r.equals(e)===!1)return r.copy(e),!0}return!1}function m(e){let t=e.uniforms,n=0;for(let e=0,r=t.length;e<r;e++){let r=Array.isArray(t[e])?t[e]:[t[e]];for(let i=0,a=r.length;i<a;i++){let a=r[i],o=Array.isArray(a.value)?a.value:[a.value],s=Array.isArray(t[e])||Array.isArray(a.value),c=n;for(let e=0,t=o.length;e<t;e++){let t=o[e],r=h(t,s),i=n%16,a=i%r.boundary,l=i+a;n+=a,l!==0&&16-l<r.storage&&(n+=16-l),e===0&&(c=n),n+=r.storage}a.__data=new(a.type===`int`?Int32Array:a.type===`uint`?Uint32Array:Float32Array)((n-c)/Float32Array.BYTES_PER_ELEMENT),a.__offset=c}}let r=n%16;return r>0&&(n+=16-r),e.__size=n,e.__cache={},this}function h(e,t){let n={boundary:0,storage:0};return typeof e==`number`||typeof e==`boolean`?(n.boundary=4,n.storage=4):e.isVector2?(n.boundary=8,n.storage=8):e.isVector3||e.isColor?(n.boundary=16,n.storage=12):e.isVector4?(n.boundary=16,n.storage=16):e.isMatrix3?(n.boundary=16,n.storage=48):e.isMatrix4?(n.boundary=16,n.storage=64):e.isTexture?z(`WebGLRenderer: Texture samplers can not be part of an uniforms group.`):ArrayBuffer.isView(e)?(n.boundary=16,n.storage=e.byteLength):z(`WebGLRenderer: Unsupported uniform value type.`,e),t===!0&&(n.boundary=16,n.storage=Math.ceil(n.storage/16)*16),n}function g(t){let n=t.target;n.removeEventListener(`dispose`,g),e.deleteBuffer(i[n.id]),delete i[n.id],delete a[n.id]}function _(){for(let t in i)e.deleteBuffer(i[t]);i={},a={}}return{bind:o,update:s,dispose:_}}var ma=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ha=null;function ga(){return ha===null&&(ha=new B(ma,16,16,me,A),ha.name=`DFG_LUT`,ha.minFilter=M,ha.magFilter=M,ha.wrapS=tt,ha.wrapT=tt,ha.generateMipmaps=!1,ha.needsUpdate=!0),ha}var _a=class{constructor(e={}){let{canvas:t=we(),context:n=null,depth:r=!0,stencil:i=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:s=!0,preserveDrawingBuffer:c=!1,powerPreference:l=`default`,failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=k}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<`u`&&n instanceof WebGLRenderingContext)throw Error(`THREE.WebGLRenderer: WebGL 1 is not supported since r163.`);p=n.getContextAttributes().alpha}else p=a;let m=f,h=new Set([ye,x,Xe]),g=new Set([k,C,ue,fe,$e,le]),_=new Uint32Array(4),v=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},S=null,w=null,T=[],E=[],D=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=0,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let O=this,M=!1,N=null,ee=null,te=null,ne=null;this._outputColorSpace=He;let ie=0,P=0,F=null,oe=-1,de=null,pe=new re,I=new re,L=null,me=new G(0),he=0,_e=t.width,ve=t.height,be=1,xe=null,Se=null,Ce=new re(0,0,_e,ve),Te=new re(0,0,_e,ve),Ee=!1,De=new Qe,Oe=new ce,Ae=!1,je=!1,Me=new b,Ne=new j,Pe=new re,Fe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ie=!1;function Le(){return F===null?be:1}let B=n;function Re(e,n){return t.getContext(e,n)}let ze,Be,V,Ue,H,U,We,Ge,Ke,qe,Je,W,Ye,Ze,et,tt,nt,rt,it,at,ot,st,ct;try{let e={alpha:!0,depth:r,stencil:i,antialias:o,premultipliedAlpha:s,preserveDrawingBuffer:c,powerPreference:l,failIfMajorPerformanceCaveat:u};if(`setAttribute`in t&&t.setAttribute(`data-engine`,`three.js r187`),t.addEventListener(`webglcontextlost`,dt,!1),t.addEventListener(`webglcontextrestored`,ft,!1),t.addEventListener(`webglcontextcreationerror`,pt,!1),B===null){let t=`webgl2`;if(B=Re(t,e),B===null)throw Re(t)?Error(`THREE.WebGLRenderer: Error creating WebGL context with your selected attributes.`):Error(`THREE.WebGLRenderer: Error creating WebGL context.`)}lt()}catch(e){throw t.removeEventListener(`webglcontextlost`,dt,!1),t.removeEventListener(`webglcontextrestored`,ft,!1),t.removeEventListener(`webglcontextcreationerror`,pt,!1),R(`WebGLRenderer: `+e.message),e}function lt(){ze=new Ln(B),ze.init(),ot=new aa(B,ze),Be=new _n(B,ze,e,ot),V=new ra(B,ze),Be.reversedDepthBuffer&&d&&V.buffers.depth.setReversed(!0),ee=B.createFramebuffer(),te=B.createFramebuffer(),ne=B.createFramebuffer(),Ue=new Bn(B),H=new Li,U=new ia(B,ze,V,H,Be,ot,Ue),We=new In(O),Ge=new ln(B),st=new hn(B,Ge),Ke=new Rn(B,Ge,Ue,st),qe=new Hn(B,Ke,Ge,st,Ue),rt=new Vn(B,Be,U),et=new vn(H),Je=new Ii(O,We,ze,Be,st,et),W=new fa(O,H),Ye=new Vi,Ze=new Ji(ze),nt=new mn(O,We,V,qe,p,s),tt=new na(O,qe,Be),ct=new pa(B,Ue,Be,V),it=new gn(B,ze,Ue),at=new zn(B,ze,Ue),Ue.programs=Je.programs,O.capabilities=Be,O.extensions=ze,O.properties=H,O.renderLists=Ye,O.shadowMap=tt,O.state=V,O.info=Ue}m!==1009&&(D=new Wn(m,t.width,t.height,o,r,i));let ut=new la(O,B);this.xr=ut,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let e=ze.get(`WEBGL_lose_context`);e&&e.loseContext()},this.forceContextRestore=function(){let e=ze.get(`WEBGL_lose_context`);e&&e.restoreContext()},this.getPixelRatio=function(){return be},this.setPixelRatio=function(e){e!==void 0&&(be=e,this.setSize(_e,ve,!1))},this.getSize=function(e){return e.set(_e,ve)},this.setSize=function(e,n,r=!0){ut.isPresenting?z(`WebGLRenderer: Can't change size while VR device is presenting.`):(_e=e,ve=n,t.width=Math.floor(e*be),t.height=Math.floor(n*be),r===!0&&(t.style.width=e+`px`,t.style.height=n+`px`),D!==null&&D.setSize(t.width,t.height),this.setViewport(0,0,e,n))},this.getDrawingBufferSize=function(e){return e.set(_e*be,ve*be).floor()},this.setDrawingBufferSize=function(e,n,r){_e=e,ve=n,be=r,t.width=Math.floor(e*r),t.height=Math.floor(n*r),this.setViewport(0,0,e,n)},this.setEffects=function(e){if(m===1009)R(`WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.`);else{if(e){for(let t=0;t<e.length;t++)if(e[t].isOutputPass===!0){z(`WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.`);break}}D.setEffects(e||[])}},this.getCurrentViewport=function(e){return e.copy(pe)},this.getViewport=function(e){return e.copy(Ce)},this.setViewport=function(e,t,n,r){e.isVector4?Ce.set(e.x,e.y,e.z,e.w):Ce.set(e,t,n,r),V.viewport(pe.copy(Ce).multiplyScalar(Le()).round())},this.getScissor=function(e){return e.copy(Te)},this.setScissor=function(e,t,n,r){e.isVector4?Te.set(e.x,e.y,e.z,e.w):Te.set(e,t,n,r),V.scissor(I.copy(Te).multiplyScalar(Le()).round())},this.getScissorTest=function(){return Ee},this.setScissorTest=function(e){V.setScissorTest(Ee=e)},this.setOpaqueSort=function(e){xe=e},this.setTransparentSort=function(e){Se=e},this.getClearColor=function(e){return e.copy(nt.getClearColor())},this.setClearColor=function(){nt.setClearColor(...arguments)},this.getClearAlpha=function(){return nt.getClearAlpha()},this.setClearAlpha=function(){nt.setClearAlpha(...arguments)},this.clear=function(e=!0,t=!0,n=!0){let r=0;if(e){let e=!1;if(F!==null){let t=F.texture.format;e=h.has(t)}if(e){let e=F.texture.type,t=g.has(e),n=nt.getClearColor(),r=nt.getClearAlpha(),i=n.r,a=n.g,o=n.b;t?(_[0]=i,_[1]=a,_[2]=o,_[3]=r,B.clearBufferuiv(B.COLOR,0,_)):(v[0]=i,v[1]=a,v[2]=o,v[3]=r,B.clearBufferiv(B.COLOR,0,v))}else r|=B.COLOR_BUFFER_BIT}t&&(r|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),n&&(r|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),r!==0&&B.clear(r)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(e){e.setRenderer(this),N=e},this.dispose=function(){t.removeEventListener(`webglcontextlost`,dt,!1),t.removeEventListener(`webglcontextrestored`,ft,!1),t.removeEventListener(`webglcontextcreationerror`,pt,!1),nt.dispose(),Ye.dispose(),Ze.dispose(),U.dispose(),H.dispose(),We.dispose(),qe.dispose(),Ke.dispose(),st.dispose(),ct.dispose(),Je.dispose(),ut.dispose(),ut.removeEventListener(`sessionstart`,xt),ut.removeEventListener(`sessionend`,St),Ct.stop()};function dt(e){e.preventDefault(),gt(`WebGLRenderer: Context Lost.`),M=!0}function ft(){gt(`WebGLRenderer: Context Restored.`),M=!1;let e=Ue.autoReset,t=tt.enabled,n=tt.autoUpdate,r=tt.needsUpdate,i=tt.type;lt(),Ue.autoReset=e,tt.enabled=t,tt.autoUpdate=n,tt.needsUpdate=r,tt.type=i}function pt(e){R(`WebGLRenderer: A WebGL context could not be created. Reason: `,e.statusMessage)}function mt(e){let t=e.target;t.removeEventListener(`dispose`,mt),ht(t)}function ht(e){_t(e),H.remove(e)}function _t(e){let t=H.get(e).programs;t!==void 0&&(t.forEach(function(e){Je.releaseProgram(e)}),e.isShaderMaterial&&Je.releaseShaderCache(e))}this.renderBufferDirect=function(e,t,n,r,i,a){t===null&&(t=Fe);let o=i.isMesh&&i.matrixWorld.determinantAffine()<0,s=Pt(e,t,n,r,i);V.setMaterial(r,o);let c=n.index,l=1;if(r.wireframe===!0){if(c=Ke.getWireframeAttribute(n),c===void 0)return;l=2}let u=n.drawRange,d=n.attributes.position,f=u.start*l,p=(u.start+u.count)*l;a!==null&&(f=Math.max(f,a.start*l),p=Math.min(p,(a.start+a.count)*l)),c===null?d!=null&&(f=Math.max(f,0),p=Math.min(p,d.count)):(f=Math.max(f,0),p=Math.min(p,c.count));let m=p-f;if(m<0||m===1/0)return;st.setup(i,r,s,n,c);let h,g=it;if(c!==null&&(h=Ge.get(c),g=at,g.setIndex(h)),i.isMesh)r.wireframe===!0?(V.setLineWidth(r.wireframeLinewidth*Le()),g.setMode(B.LINES)):g.setMode(B.TRIANGLES);else if(i.isLine){let e=r.linewidth;e===void 0&&(e=1),V.setLineWidth(e*Le()),i.isLineSegments?g.setMode(B.LINES):i.isLineLoop?g.setMode(B.LINE_LOOP):g.setMode(B.LINE_STRIP)}else i.isPoints?g.setMode(B.POINTS):i.isSprite&&g.setMode(B.TRIANGLES);if(i.isBatchedMesh){if(ze.get(`WEBGL_multi_draw`))g.renderMultiDraw(i._multiDrawStarts,i._multiDrawCounts,i._multiDrawCount);else{let e=i._multiDrawStarts,t=i._multiDrawCounts,n=i._multiDrawCount,a=c?Ge.get(c).bytesPerElement:1,o=H.get(r).currentProgram.getUniforms();for(let r=0;r<n;r++)o.setValue(B,`_gl_DrawID`,r),g.render(e[r]/a,t[r])}}else if(i.isInstancedMesh)g.renderInstances(f,m,i.count);else if(n.isInstancedBufferGeometry){let e=n._maxInstanceCount===void 0?1/0:n._maxInstanceCount,t=Math.min(n.instanceCount,e);g.renderInstances(f,m,t)}else g.render(f,m)};function vt(e,t,n,r){N!==null&&e.isNodeMaterial&&N.setObject(r,e),Ae===!0&&et.setState(e,n,!1),e.transparent===!0&&e.side===2&&e.forceSinglePass===!1?(e.side=1,e.needsUpdate=!0,At(e,t,r),e.side=0,e.needsUpdate=!0,At(e,t,r),e.side=2):At(e,t,r)}this.compile=function(e,t,n=null){n===null&&(n=e),N!==null&&N.renderStart(e,t,n),w=Ze.get(n),w.init(t),E.push(w),n.traverseVisible(function(e){e.isLight&&e.layers.test(t.layers)&&(w.pushLight(e),e.castShadow&&w.pushShadow(e))}),e!==n&&e.traverseVisible(function(e){e.isLight&&e.layers.test(t.layers)&&(w.pushLight(e),e.castShadow&&w.pushShadow(e))}),w.setupLights(),N!==null&&N.updateLights(w.state.lightsArray),je=this.localClippingEnabled,Ae=et.init(this.clippingPlanes,je),Ae===!0&&et.setGlobalState(this.clippingPlanes,t),N!==null&&tt.render(w.state.shadowsArray,n,t);let r=new Set;return e.traverse(function(e){if(!(e.isMesh||e.isPoints||e.isLine||e.isSprite))return;let i=e.material;if(i){if(Array.isArray(i))for(let a=0;a<i.length;a++){let o=i[a];vt(o,n,t,e),r.add(o)}else vt(i,n,t,e),r.add(i)}}),w=E.pop(),N!==null&&N.renderEnd(),r},this.compileAsync=function(e,t,n=null){let r=this.compile(e,t,n);return new Promise(t=>{function n(){r.forEach(function(e){let t=H.get(e).currentProgram;(t===void 0||t.isReady())&&r.delete(e)}),r.size===0?t(e):setTimeout(n,10)}ze.get(`KHR_parallel_shader_compile`)===null?setTimeout(n,10):n()})};let yt=null;function bt(e){yt&&yt(e)}function xt(){Ct.stop()}function St(){Ct.start()}let Ct=new cn;Ct.setAnimationLoop(bt),typeof self<`u`&&Ct.setContext(self),this.setAnimationLoop=function(e){yt=e,ut.setAnimationLoop(e),e===null?Ct.stop():Ct.start()},ut.addEventListener(`sessionstart`,xt),ut.addEventListener(`sessionend`,St),this.render=function(e,t){if(t!==void 0&&t.isCamera!==!0){R(`WebGLRenderer.render: camera is not an instance of THREE.Camera.`);return}if(M===!0)return;N!==null&&N.renderStart(e,t);let n=ut.enabled===!0&&ut.isPresenting===!0,r=D!==null&&(F===null||n)&&D.begin(O,F);if(e.matrixWorldAutoUpdate===!0&&e.updateMatrixWorld(),t.parent===null&&t.matrixWorldAutoUpdate===!0&&t.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(t),t=ut.getCamera()),e.isScene===!0&&e.onBeforeRender(O,e,t,F),w=Ze.get(e,E.length),w.init(t),w.state.textureUnits=U.getTextureUnits(),E.push(w),Me.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),t.isArrayCamera?Oe.setFromArrayCamera(t):De.setFromProjectionMatrix(Me,se,t.reversedDepth),je=this.localClippingEnabled,Ae=et.init(this.clippingPlanes,je),S=Ye.get(e,T.length),S.init(),T.push(S),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let e=O.xr.getDepthSensingMesh();e!==null&&wt(e,t,-1/0,O.sortObjects)}wt(e,t,0,O.sortObjects),S.finish(),N!==null&&N.updateLights(w.state.lightsArray),O.sortObjects===!0&&S.sort(xe,Se),Ie=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Ie&&nt.addToRenderList(S,e),this.info.autoReset===!0&&this.info.reset(),Ae===!0&&et.beginShadows();let i=w.state.shadowsArray;if(tt.render(i,e,t),Ae===!0&&et.endShadows(),(r&&D.hasRenderPass())===!1){let n=S.opaque,r=S.transmissive;if(w.setupLights(),t.isArrayCamera){let i=t.cameras;if(r.length>0)for(let t=0,a=i.length;t<a;t++){let a=i[t];Et(n,r,e,a)}Ie&&nt.render(e);for(let t=0,n=i.length;t<n;t++){let n=i[t];Tt(S,e,n,n.viewport)}}else r.length>0&&Et(n,r,e,t),Ie&&nt.render(e),Tt(S,e,t)}F!==null&&P===0&&(U.updateMultisampleRenderTarget(F),U.updateRenderTargetMipmap(F)),r&&D.end(O),e.isScene===!0&&e.onAfterRender(O,e,t),st.resetDefaultState(),oe=-1,de=null,E.pop(),E.length>0?(w=E[E.length-1],U.setTextureUnits(w.state.textureUnits),Ae===!0&&et.setGlobalState(O.clippingPlanes,w.state.camera)):w=null,T.pop(),S=T.length>0?T[T.length-1]:null,N!==null&&N.renderEnd()};function wt(e,t,n,r){if(e.visible===!1)return;if(e.layers.test(t.layers)){if(e.isGroup)n=e.renderOrder;else if(e.isLOD)e.autoUpdate===!0&&e.update(t);else if(e.isLight)w.pushLight(e),e.castShadow&&w.pushShadow(e);else if(e.isSprite){let i=t.isArrayCamera?Oe:De;if(!e.frustumCulled||e.intersectsFrustum(i)){r&&Pe.setFromMatrixPosition(e.matrixWorld).applyMatrix4(Me);let i=qe.update(e),a=e.material;a.visible&&S.push(e,i,a,n,Pe.z,null,t)}}else if(e.isMesh||e.isLine||e.isPoints){let i=t.isArrayCamera?Oe:De;if(!e.frustumCulled||e.intersectsFrustum(i)){let i=qe.update(e),a=e.material;if(r&&(e.boundingSphere===void 0?(i.boundingSphere===null&&i.computeBoundingSphere(),Pe.copy(i.boundingSphere.center)):(e.boundingSphere===null&&e.computeBoundingSphere(),Pe.copy(e.boundingSphere.center)),Pe.applyMatrix4(e.matrixWorld).applyMatrix4(Me)),Array.isArray(a)){let r=i.groups;for(let o=0,s=r.length;o<s;o++){let s=r[o],c=a[s.materialIndex];c&&c.visible&&S.push(e,i,c,n,Pe.z,s,t)}}else a.visible&&S.push(e,i,a,n,Pe.z,null,t)}}}let i=e.children;for(let e=0,a=i.length;e<a;e++)wt(i[e],t,n,r)}function Tt(e,t,n,r){let{opaque:i,transmissive:a,transparent:o}=e;w.setupLightsView(n),Ae===!0&&et.setGlobalState(O.clippingPlanes,n),r&&V.viewport(pe.copy(r)),i.length>0&&Dt(i,t,n),a.length>0&&Dt(a,t,n),o.length>0&&Dt(o,t,n),V.buffers.depth.setTest(!0),V.buffers.depth.setMask(!0),V.buffers.color.setMask(!0),V.setPolygonOffset(!1)}function Et(e,t,n,r){if((n.isScene===!0?n.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[r.id]===void 0){let e=ze.has(`EXT_color_buffer_half_float`)||ze.has(`EXT_color_buffer_float`);w.state.transmissionRenderTarget[r.id]=new ge(1,1,{generateMipmaps:!0,type:e?A:k,minFilter:ae,samples:Math.max(4,Be.samples),stencilBuffer:i,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ve.workingColorSpace})}let a=w.state.transmissionRenderTarget[r.id],o=r.viewport||pe;a.setSize(o.z*O.transmissionResolutionScale,o.w*O.transmissionResolutionScale);let s=O.getRenderTarget(),c=O.getActiveCubeFace(),l=O.getActiveMipmapLevel();O.setRenderTarget(a),O.getClearColor(me),he=O.getClearAlpha(),he<1&&O.setClearColor(16777215,.5),O.clear(),Ie&&nt.render(n);let u=O.toneMapping;O.toneMapping=0;let d=r.viewport;if(r.viewport!==void 0&&(r.viewport=void 0),w.setupLightsView(r),Ae===!0&&et.setGlobalState(O.clippingPlanes,r),Dt(e,n,r),U.updateMultisampleRenderTarget(a),U.updateRenderTargetMipmap(a),ze.has(`WEBGL_multisampled_render_to_texture`)===!1){let e=!1;for(let i=0,a=t.length;i<a;i++){let{object:a,geometry:o,material:s,group:c}=t[i];if(s.side===2&&a.layers.test(r.layers)){let t=s.side;s.side=1,s.needsUpdate=!0,Ot(a,n,r,o,s,c),s.side=t,s.needsUpdate=!0,e=!0}}e===!0&&(U.updateMultisampleRenderTarget(a),U.updateRenderTargetMipmap(a))}O.setRenderTarget(s,c,l),O.setClearColor(me,he),d!==void 0&&(r.viewport=d),O.toneMapping=u}function Dt(e,t,n){let r=t.isScene===!0?t.overrideMaterial:null;for(let i=0,a=e.length;i<a;i++){let a=e[i],{object:o,geometry:s,group:c}=a,l=a.material;l.allowOverride===!0&&r!==null&&(l=r),o.layers.test(n.layers)&&Ot(o,t,n,s,l,c)}}function Ot(e,t,n,r,i,a){N!==null&&i.isNodeMaterial&&N.setObject(e,i),e.onBeforeRender(O,t,n,r,i,a),e.modelViewMatrix.multiplyMatrices(n.matrixWorldInverse,e.matrixWorld),e.normalMatrix.getNormalMatrix(e.modelViewMatrix),i.onBeforeRender(O,t,n,r,e,a),i.transparent===!0&&i.side===2&&i.forceSinglePass===!1?(i.side=1,i.needsUpdate=!0,O.renderBufferDirect(n,t,r,i,e,a),i.side=0,i.needsUpdate=!0,O.renderBufferDirect(n,t,r,i,e,a),i.side=2):O.renderBufferDirect(n,t,r,i,e,a),e.onAfterRender(O,t,n,r,i,a)}function kt(e){let t=0;for(let n of e)n.texture!==null&&t++;return t}function At(e,t,n){t.isScene!==!0&&(t=Fe);let r=H.get(e),i=w.state.lights,a=w.state.shadowsArray,o=i.state.version,s=Je.getParameters(e,i.state,a,t,n,w.state.lightProbeGridArray),c=Je.getProgramCacheKey(s),l=r.programs;r.environment=e.isMeshStandardMaterial||e.isMeshLambertMaterial||e.isMeshPhongMaterial?t.environment:null,r.fog=t.fog;let u=e.isMeshStandardMaterial||e.isMeshLambertMaterial&&!e.envMap||e.isMeshPhongMaterial&&!e.envMap;r.envMap=We.get(e.envMap||r.environment,u),r.envMapRotation=r.environment!==null&&e.envMap===null?t.environmentRotation:e.envMapRotation,l===void 0&&(e.addEventListener(`dispose`,mt),l=new Map,r.programs=l,r.programVariants=new Map);let d=l.get(c);if(d!==void 0){if(r.currentProgram===d&&r.lightsStateVersion===o)return Nt(e,s),d}else s.uniforms=Je.getUniforms(e),N!==null&&e.isNodeMaterial&&N.build(e,n,s),e.onBeforeCompile(s,O),d=Je.acquireProgram(s,c),l.set(c,d),r.uniforms=s.uniforms;let f=r.uniforms;return(!e.isShaderMaterial&&!e.isRawShaderMaterial||e.clipping===!0)&&(f.clippingPlanes=et.uniform),Nt(e,s),r.needsLights=It(e),r.lightsStateVersion=o,r.needsLights&&(f.ambientLightColor.value=i.state.ambient,f.lightProbe.value=i.state.probe,f.sunLights.value=i.state.sun,f.sunLightShadows.value=i.state.sunShadow,f.directionalLights.value=i.state.directional,f.directionalLightShadows.value=i.state.directionalShadow,f.spotLights.value=i.state.spot,f.spotLightShadows.value=i.state.spotShadow,f.rectAreaLights.value=i.state.rectArea,f.ltc_1.value=i.state.rectAreaLTC1,f.ltc_2.value=i.state.rectAreaLTC2,f.pointLights.value=i.state.point,f.pointLightShadows.value=i.state.pointShadow,f.hemisphereLights.value=i.state.hemi,f.sunShadowMatrix.value=i.state.sunShadowMatrix,f.sunShadowCascade.value=i.state.sunShadowCascade,f.directionalShadowMatrix.value=i.state.directionalShadowMatrix,f.spotLightMatrix.value=i.state.spotLightMatrix,f.spotLightMap.value=i.state.spotLightMap,f.pointShadowMatrix.value=i.state.pointShadowMatrix),r.numLightProbeGrids=kt(w.state.lightProbeGridArray),r.currentProgram=d,r.uniformsList=null,d}function jt(e,t,n,r,i){let a=H.get(e),o=a.currentProgram.id+`,`+r+`,`+i,s=a.programVariants.get(o);return s===void 0?(s=At(e,t,n),a.programVariants.set(o,s)):(a.currentProgram=s,a.uniformsList=null,a.outputColorSpace=r,a.toneMapping=i),s}function Mt(e){if(e.uniformsList===null){let t=e.currentProgram.getUniforms();e.uniformsList=$r.seqWithValue(t.seq,e.uniforms)}return e.uniformsList}function Nt(e,t){let n=H.get(e);n.outputColorSpace=t.outputColorSpace,n.batching=t.batching,n.batchingColor=t.batchingColor,n.instancing=t.instancing,n.instancingColor=t.instancingColor,n.instancingMorph=t.instancingMorph,n.skinning=t.skinning,n.morphTargets=t.morphTargets,n.morphNormals=t.morphNormals,n.morphColors=t.morphColors,n.morphTargetsCount=t.morphTargetsCount,n.numClippingPlanes=t.numClippingPlanes,n.numIntersection=t.numClipIntersection,n.vertexAlphas=t.vertexAlphas,n.vertexTangents=t.vertexTangents,n.toneMapping=t.toneMapping}function Pt(e,t,n,r,i){t.isScene!==!0&&(t=Fe),U.resetTextureUnits();let a=t.fog,o=r.isMeshStandardMaterial||r.isMeshLambertMaterial||r.isMeshPhongMaterial?t.environment:null,s=F===null?O.outputColorSpace:F.isXRRenderTarget===!0?F.texture.colorSpace:Ve.workingColorSpace,c=r.isMeshStandardMaterial||r.isMeshLambertMaterial&&!r.envMap||r.isMeshPhongMaterial&&!r.envMap,l=We.get(r.envMap||o,c),u=r.vertexColors===!0&&!!n.attributes.color&&n.attributes.color.itemSize===4,d=!!n.attributes.tangent&&(!!r.normalMap||r.anisotropy>0),f=!!n.morphAttributes.position,p=!!n.morphAttributes.normal,m=!!n.morphAttributes.color,h=0;r.toneMapped&&(F===null||F.isXRRenderTarget===!0)&&(h=O.toneMapping);let g=n.morphAttributes.position||n.morphAttributes.normal||n.morphAttributes.color,_=g===void 0?0:g.length,v=H.get(r),b=w.state.lights;if(Ae===!0&&(je===!0||e!==de)){let t=e===de&&r.id===oe;et.setState(r,e,t)}let x=!1,S=!1;r.version===v.__version?v.needsLights&&v.lightsStateVersion!==b.state.version||i.isBatchedMesh&&v.batching===!1||!i.isBatchedMesh&&v.batching===!0||i.isBatchedMesh&&v.batchingColor===!0&&i._colorsTexture===null||i.isBatchedMesh&&v.batchingColor===!1&&i._colorsTexture!==null||i.isInstancedMesh&&v.instancing===!1||!i.isInstancedMesh&&v.instancing===!0||i.isSkinnedMesh&&v.skinning===!1||!i.isSkinnedMesh&&v.skinning===!0||i.isInstancedMesh&&v.instancingColor===!0&&i.instanceColor===null||i.isInstancedMesh&&v.instancingColor===!1&&i.instanceColor!==null||i.isInstancedMesh&&v.instancingMorph===!0&&i.morphTexture===null||i.isInstancedMesh&&v.instancingMorph===!1&&i.morphTexture!==null?x=!0:v.envMap===l?r.fog===!0&&v.fog!==a||v.numClippingPlanes!==void 0&&(v.numClippingPlanes!==et.numPlanes||v.numIntersection!==et.numIntersection)?x=!0:v.vertexAlphas===u&&v.vertexTangents===d&&v.morphTargets===f&&v.morphNormals===p&&v.morphColors===m&&v.morphTargetsCount===_&&v.numLightProbeGrids===kt(w.state.lightProbeGridArray)?(v.outputColorSpace!==s||v.toneMapping!==h)&&(S=!0):x=!0:x=!0:(x=!0,v.__version=r.version);let C=v.currentProgram;(x===!0||S===!0)&&(C=S===!0?jt(r,t,i,s,h):At(r,t,i),N&&r.isNodeMaterial&&N.onUpdateProgram(r,C,v));let T=!1,E=!1,D=!1,k=C.getUniforms(),A=v.uniforms;if(V.useProgram(C.program)&&(T=!0,E=!0,D=!0),r.id!==oe&&(oe=r.id,E=!0),T||de!==e){V.buffers.depth.getReversed()&&e.reversedDepth!==!0&&(e._reversedDepth=!0,e.updateProjectionMatrix()),k.setValue(B,`projectionMatrix`,e.projectionMatrix),k.setValue(B,`viewMatrix`,e.matrixWorldInverse);let t=k.map.cameraPosition;t!==void 0&&t.setValue(B,Ne.setFromMatrixPosition(e.matrixWorld)),Be.logarithmicDepthBuffer&&k.setValue(B,`logDepthBufFC`,2/(Math.log(e.far+1)/Math.LN2)),(r.isMeshPhongMaterial||r.isMeshToonMaterial||r.isMeshLambertMaterial||r.isMeshBasicMaterial||r.isMeshStandardMaterial||r.isShaderMaterial)&&k.setValue(B,`isOrthographic`,e.isOrthographicCamera===!0),de!==e&&(de=e,E=!0,D=!0)}if(v.needsLights&&(b.state.sunShadowMap.length>0&&k.setValue(B,`sunShadowMap`,b.state.sunShadowMap,U),b.state.directionalShadowMap.length>0&&k.setValue(B,`directionalShadowMap`,b.state.directionalShadowMap,U),b.state.spotShadowMap.length>0&&k.setValue(B,`spotShadowMap`,b.state.spotShadowMap,U),b.state.pointShadowMap.length>0&&k.setValue(B,`pointShadowMap`,b.state.pointShadowMap,U)),i.isSkinnedMesh){k.setOptional(B,i,`bindMatrix`),k.setOptional(B,i,`bindMatrixInverse`);let e=i.skeleton;e&&(e.boneTexture===null&&e.computeBoneTexture(),k.setValue(B,`boneTexture`,e.boneTexture,U))}i.isBatchedMesh&&(k.setOptional(B,i,`batchingTexture`),k.setValue(B,`batchingTexture`,i._matricesTexture,U),k.setOptional(B,i,`batchingIdTexture`),k.setValue(B,`batchingIdTexture`,i._indirectTexture,U),k.setOptional(B,i,`batchingColorTexture`),i._colorsTexture!==null&&k.setValue(B,`batchingColorTexture`,i._colorsTexture,U));let j=n.morphAttributes;if((j.position!==void 0||j.normal!==void 0||j.color!==void 0)&&rt.update(i,n,C),(E||v.receiveShadow!==i.receiveShadow)&&(v.receiveShadow=i.receiveShadow,k.setValue(B,`receiveShadow`,i.receiveShadow)),(r.isMeshStandardMaterial||r.isMeshLambertMaterial||r.isMeshPhongMaterial)&&r.envMap===null&&t.environment!==null&&(A.envMapIntensity.value=t.environmentIntensity),A.dfgLUT!==void 0&&(A.dfgLUT.value=ga()),E){if(k.setValue(B,`toneMappingExposure`,O.toneMappingExposure),v.needsLights&&Ft(A,D),a&&r.fog===!0&&W.refreshFogUniforms(A,a),W.refreshMaterialUniforms(A,r,be,ve,w.state.transmissionRenderTarget[e.id]),v.needsLights&&v.numLightProbeGrids>0){let e=y,t=0;for(let n of w.state.lightProbeGridArray)n.texture!==null&&(e.textures[t]=n.texture,e.min[t]=n.boundingBox.min,e.max[t]=n.boundingBox.max,e.resolution[t]=n.resolution,t++);for(let n in e)e[n].length=t;A.probesSH.value=e.textures,A.probesMin.value=e.min,A.probesMax.value=e.max,A.probesResolution.value=e.resolution}$r.upload(B,Mt(v),A,U)}if(r.isShaderMaterial&&r.uniformsNeedUpdate===!0&&($r.upload(B,Mt(v),A,U),r.uniformsNeedUpdate=!1),r.isSpriteMaterial&&k.setValue(B,`center`,i.center),k.setValue(B,`modelViewMatrix`,i.modelViewMatrix),k.setValue(B,`normalMatrix`,i.normalMatrix),k.setValue(B,`modelMatrix`,i.matrixWorld),r.uniformsGroups!==void 0){let e=r.uniformsGroups;for(let t=0,n=e.length;t<n;t++){let n=e[t];ct.update(n,C),ct.bind(n,C)}}return C}function Ft(e,t){e.ambientLightColor.needsUpdate=t,e.lightProbe.needsUpdate=t,e.sunLights.needsUpdate=t,e.sunLightShadows.needsUpdate=t,e.directionalLights.needsUpdate=t,e.directionalLightShadows.needsUpdate=t,e.pointLights.needsUpdate=t,e.pointLightShadows.needsUpdate=t,e.spotLights.needsUpdate=t,e.spotLightShadows.needsUpdate=t,e.rectAreaLights.needsUpdate=t,e.hemisphereLights.needsUpdate=t}function It(e){return e.isMeshLambertMaterial||e.isMeshToonMaterial||e.isMeshPhongMaterial||e.isMeshStandardMaterial||e.isShadowMaterial||e.isShaderMaterial&&e.lights===!0}this.getActiveCubeFace=function(){return ie},this.getActiveMipmapLevel=function(){return P},this.getRenderTarget=function(){return F},this.setRenderTargetTextures=function(e,t,n){let r=H.get(e);r.__autoAllocateDepthBuffer=e.resolveDepthBuffer===!1,r.__autoAllocateDepthBuffer===!1&&(r.__useRenderToTexture=!1),H.get(e.texture).__webglTexture=t,H.get(e.depthTexture).__webglTexture=r.__autoAllocateDepthBuffer?void 0:n,r.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(e,t){let n=H.get(e);n.__webglFramebuffer=t,n.__useDefaultFramebuffer=t===void 0},this.setRenderTarget=function(e,t=0,n=0){F=e,ie=t,P=n;let r=null,i=!1,a=!1;if(e){let o=H.get(e);if(o.__useDefaultFramebuffer!==void 0){V.bindFramebuffer(B.FRAMEBUFFER,o.__webglFramebuffer),pe.copy(e.viewport),I.copy(e.scissor),L=e.scissorTest,V.viewport(pe),V.scissor(I),V.setScissorTest(L),oe=-1;return}if(o.__webglFramebuffer===void 0)U.setupRenderTarget(e);else if(o.__hasExternalTextures)U.rebindTextures(e,H.get(e.texture).__webglTexture,H.get(e.depthTexture).__webglTexture);else if(e.depthBuffer){let t=e.depthTexture;if(o.__boundDepthTexture!==t){if(t!==null&&H.has(t)&&(e.width!==t.image.width||e.height!==t.image.height))throw Error(`THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.`);U.setupDepthRenderbuffer(e)}}let s=e.texture;(s.isData3DTexture||s.isDataArrayTexture||s.isCompressedArrayTexture)&&(a=!0);let c=H.get(e).__webglFramebuffer;e.isWebGLCubeRenderTarget?(r=Array.isArray(c[t])?c[t][n]:c[t],i=!0):r=e.samples>0&&U.useMultisampledRTT(e)===!1?H.get(e).__webglMultisampledFramebuffer:Array.isArray(c)?c[n]:c,pe.copy(e.viewport),I.copy(e.scissor),L=e.scissorTest}else pe.copy(Ce).multiplyScalar(be).floor(),I.copy(Te).multiplyScalar(be).floor(),L=Ee;if(n!==0&&(r=ee),V.bindFramebuffer(B.FRAMEBUFFER,r)&&V.drawBuffers(e,r),V.viewport(pe),V.scissor(I),V.setScissorTest(L),i){let r=H.get(e.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+t,r.__webglTexture,n)}else if(a){let r=t;for(let t=0;t<e.textures.length;t++){let i=H.get(e.textures[t]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+t,i.__webglTexture,n,r)}}else if(e!==null&&n!==0){let t=H.get(e.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,t.__webglTexture,n)}oe=-1};function Lt(e){let t=H.get(e);return(t.__readFormat!==e.format||t.__readType!==e.type)&&(t.__readFormat=e.format,t.__readType=e.type,t.__formatReadable=Be.textureFormatReadable(e.format),t.__typeReadable=Be.textureTypeReadable(e.type)),t}this.readRenderTargetPixels=function(e,t,n,r,i,a,o,s=0){if(!(e&&e.isWebGLRenderTarget)){R(`WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.`);return}let c=H.get(e).__webglFramebuffer;if(e.isWebGLCubeRenderTarget&&o!==void 0&&(c=c[o],Array.isArray(c)&&(c=c[0])),c){V.bindFramebuffer(B.FRAMEBUFFER,c);try{let o=e.textures[s],c=o.format,l=o.type;e.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+s);let u=Lt(o);if(u.__formatReadable===!1){R(`WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.`);return}if(u.__typeReadable===!1){R(`WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.`);return}t>=0&&t<=e.width-r&&n>=0&&n<=e.height-i&&B.readPixels(t,n,r,i,ot.convert(c),ot.convert(l),a)}finally{let e=F===null?null:H.get(F).__webglFramebuffer;V.bindFramebuffer(B.FRAMEBUFFER,e)}}},this.readRenderTargetPixelsAsync=async function(e,t,n,r,i,a,o,s=0){if(!(e&&e.isWebGLRenderTarget))throw Error(`THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.`);let c=H.get(e).__webglFramebuffer;if(e.isWebGLCubeRenderTarget&&o!==void 0&&(c=c[o],Array.isArray(c)&&(c=c[0])),c){if(t>=0&&t<=e.width-r&&n>=0&&n<=e.height-i){V.bindFramebuffer(B.FRAMEBUFFER,c);let o=e.textures[s],l=o.format,u=o.type;e.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+s);let d=Lt(o);if(d.__formatReadable===!1)throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.`);if(d.__typeReadable===!1)throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.`);let f=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,f),B.bufferData(B.PIXEL_PACK_BUFFER,a.byteLength,B.STREAM_READ),B.readPixels(t,n,r,i,ot.convert(l),ot.convert(u),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let p=F===null?null:H.get(F).__webglFramebuffer;V.bindFramebuffer(B.FRAMEBUFFER,p);let m=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await ke(B,m,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,f),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,a),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(f),B.deleteSync(m),a}throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.`)}},this.copyFramebufferToTexture=function(e,t=null,n=0){let r=2**-n,i=Math.floor(e.image.width*r),a=Math.floor(e.image.height*r),o=t===null?0:t.x,s=t===null?0:t.y;U.setTexture2D(e,0),B.copyTexSubImage2D(B.TEXTURE_2D,n,0,0,o,s,i,a),V.unbindTexture()},this.copyTextureToTexture=function(e,t,n=null,r=null,i=0,a=0){let o,s,c,l,u,d,f,p,m,h=e.isCompressedTexture?e.mipmaps[a]:e.image;if(n!==null)o=n.max.x-n.min.x,s=n.max.y-n.min.y,c=n.isBox3?n.max.z-n.min.z:1,l=n.min.x,u=n.min.y,d=n.isBox3?n.min.z:0;else{let t=2**-i;o=Math.floor(h.width*t),s=Math.floor(h.height*t),c=e.isDataArrayTexture?h.depth:e.isData3DTexture?Math.floor(h.depth*t):1,l=0,u=0,d=0}r===null?(f=0,p=0,m=0):(f=r.x,p=r.y,m=r.z);let g=ot.convert(t.format),_=ot.convert(t.type),v;t.isData3DTexture?(U.setTexture3D(t,0),v=B.TEXTURE_3D):t.isDataArrayTexture||t.isCompressedArrayTexture?(U.setTexture2DArray(t,0),v=B.TEXTURE_2D_ARRAY):(U.setTexture2D(t,0),v=B.TEXTURE_2D),V.activeTexture(B.TEXTURE0),V.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,t.flipY),V.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,t.premultiplyAlpha),V.pixelStorei(B.UNPACK_ALIGNMENT,t.unpackAlignment);let y=V.getParameter(B.UNPACK_ROW_LENGTH),b=V.getParameter(B.UNPACK_IMAGE_HEIGHT),x=V.getParameter(B.UNPACK_SKIP_PIXELS),S=V.getParameter(B.UNPACK_SKIP_ROWS),C=V.getParameter(B.UNPACK_SKIP_IMAGES);V.pixelStorei(B.UNPACK_ROW_LENGTH,h.width),V.pixelStorei(B.UNPACK_IMAGE_HEIGHT,h.height),V.pixelStorei(B.UNPACK_SKIP_PIXELS,l),V.pixelStorei(B.UNPACK_SKIP_ROWS,u),V.pixelStorei(B.UNPACK_SKIP_IMAGES,d);let w=e.isDataArrayTexture||e.isData3DTexture,T=t.isDataArrayTexture||t.isData3DTexture;if(e.isDepthTexture){let n=H.get(e),r=H.get(t),h=H.get(n.__renderTarget),g=H.get(r.__renderTarget);V.bindFramebuffer(B.READ_FRAMEBUFFER,h.__webglFramebuffer),V.bindFramebuffer(B.DRAW_FRAMEBUFFER,g.__webglFramebuffer);for(let n=0;n<c;n++)w&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,H.get(e).__webglTexture,i,d+n),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,H.get(t).__webglTexture,a,m+n)),B.blitFramebuffer(l,u,l+o,u+s,f,p,f+o,p+s,B.DEPTH_BUFFER_BIT,B.NEAREST);V.bindFramebuffer(B.READ_FRAMEBUFFER,null),V.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(i!==0||e.isRenderTargetTexture||H.has(e)){let n=H.get(e),r=H.get(t);V.bindFramebuffer(B.READ_FRAMEBUFFER,te),V.bindFramebuffer(B.DRAW_FRAMEBUFFER,ne);for(let e=0;e<c;e++)w?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,n.__webglTexture,i,d+e):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,n.__webglTexture,i),T?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,r.__webglTexture,a,m+e):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,r.__webglTexture,a),i===0?T?B.copyTexSubImage3D(v,a,f,p,m+e,l,u,o,s):B.copyTexSubImage2D(v,a,f,p,l,u,o,s):B.blitFramebuffer(l,u,l+o,u+s,f,p,f+o,p+s,B.COLOR_BUFFER_BIT,B.NEAREST);V.bindFramebuffer(B.READ_FRAMEBUFFER,null),V.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else T?e.isDataTexture||e.isData3DTexture?B.texSubImage3D(v,a,f,p,m,o,s,c,g,_,h.data):t.isCompressedArrayTexture?B.compressedTexSubImage3D(v,a,f,p,m,o,s,c,g,h.data):B.texSubImage3D(v,a,f,p,m,o,s,c,g,_,h):e.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,a,f,p,o,s,g,_,h.data):e.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,a,f,p,h.width,h.height,g,h.data):B.texSubImage2D(B.TEXTURE_2D,a,f,p,o,s,g,_,h);V.pixelStorei(B.UNPACK_ROW_LENGTH,y),V.pixelStorei(B.UNPACK_IMAGE_HEIGHT,b),V.pixelStorei(B.UNPACK_SKIP_PIXELS,x),V.pixelStorei(B.UNPACK_SKIP_ROWS,S),V.pixelStorei(B.UNPACK_SKIP_IMAGES,C),a===0&&t.generateMipmaps===!0&&t.mipmapsAutoUpdate===!0&&B.generateMipmap(v),V.unbindTexture()},this.initRenderTarget=function(e){H.get(e).__webglFramebuffer===void 0&&U.setupRenderTarget(e)},this.initTexture=function(e){e.isCubeTexture?U.setTextureCube(e,0):e.isData3DTexture?U.setTexture3D(e,0):e.isDataArrayTexture||e.isCompressedArrayTexture?U.setTexture2DArray(e,0):U.setTexture2D(e,0),V.unbindTexture()},this.resetState=function(){ie=0,P=0,F=null,V.reset(),st.reset()},typeof __THREE_DEVTOOLS__<`u`&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent(`observe`,{detail:this}))}get coordinateSystem(){return se}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Ve._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ve._getUnpackColorSpace()}},va={type:`change`},ya={type:`start`},ba={type:`end`},xa=new bt,Sa=new V,Ca=Math.cos(70*Ae.DEG2RAD),wa=new j,Ta=2*Math.PI,Y={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Ea=1e-6,Da=class extends ft{constructor(e,t=null){super(e,t),this.state=Y.NONE,this.target=new j,this.cursor=new j,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:`ArrowLeft`,UP:`ArrowUp`,RIGHT:`ArrowRight`,BOTTOM:`ArrowDown`},this.mouseButtons={LEFT:De.ROTATE,MIDDLE:De.DOLLY,RIGHT:De.PAN},this.touches={ONE:wt.ROTATE,TWO:wt.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle=`auto`,this._domElementKeyEvents=null,this._lastPosition=new j,this._lastQuaternion=new W,this._lastTargetPosition=new j,this._quat=new W().setFromUnitVectors(e.up,new j(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ne,this._sphericalDelta=new Ne,this._scale=1,this._panOffset=new j,this._rotateStart=new I,this._rotateEnd=new I,this._rotateDelta=new I,this._panStart=new I,this._panEnd=new I,this._panDelta=new I,this._dollyStart=new I,this._dollyEnd=new I,this._dollyDelta=new I,this._dollyDirection=new j,this._mouse=new I,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=ka.bind(this),this._onPointerDown=Oa.bind(this),this._onPointerUp=Aa.bind(this),this._onContextMenu=La.bind(this),this._onMouseWheel=Na.bind(this),this._onKeyDown=Pa.bind(this),this._onTouchStart=Fa.bind(this),this._onTouchMove=Ia.bind(this),this._onMouseDown=ja.bind(this),this._onMouseMove=Ma.bind(this),this._interceptControlDown=Ra.bind(this),this._interceptControlUp=za.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e===`grab`?this.domElement.style.cursor=`grab`:this.domElement.style.cursor=`auto`}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener(`pointerdown`,this._onPointerDown),this.domElement.addEventListener(`pointercancel`,this._onPointerUp),this.domElement.addEventListener(`contextmenu`,this._onContextMenu),this.domElement.addEventListener(`wheel`,this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener(`keydown`,this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction=`none`}disconnect(){this.state=Y.NONE,this.domElement.removeEventListener(`pointerdown`,this._onPointerDown),this.domElement.ownerDocument.removeEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.removeEventListener(`pointerup`,this._onPointerUp),this.domElement.removeEventListener(`pointercancel`,this._onPointerUp),this.domElement.removeEventListener(`wheel`,this._onMouseWheel),this.domElement.removeEventListener(`contextmenu`,this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener(`keydown`,this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener(`keyup`,this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction=``,this.domElement.style.cursor=`auto`}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener(`keydown`,this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener(`keydown`,this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(va),this.update(),this.state=Y.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;wa.copy(t).sub(this.target),wa.applyQuaternion(this._quat),this._spherical.setFromVector3(wa),this.autoRotate&&this.state===Y.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(n)&&isFinite(r)&&(n<-Math.PI?n+=Ta:n>Math.PI&&(n-=Ta),r<-Math.PI?r+=Ta:r>Math.PI&&(r-=Ta),n<=r?this._spherical.theta=Math.max(n,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+r)/2?Math.max(n,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let i=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let e=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),i=e!=this._spherical.radius}if(wa.setFromSpherical(this._spherical),wa.applyQuaternion(this._quatInverse),t.copy(this.target).add(wa),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let e=null;if(this.object.isPerspectiveCamera){let t=wa.length();e=this._clampDistance(t*this._scale);let n=t-e;this.object.position.addScaledVector(this._dollyDirection,n),this.object.updateMatrixWorld(),i=!!n}else if(this.object.isOrthographicCamera){let t=new j(this._mouse.x,this._mouse.y,0);t.unproject(this.object);let n=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),i=n!==this.object.zoom;let r=new j(this._mouse.x,this._mouse.y,0);r.unproject(this.object),this.object.position.sub(r).add(t),this.object.updateMatrixWorld(),e=wa.length()}else console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled.`),this.zoomToCursor=!1;e!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(e).add(this.object.position):(xa.origin.copy(this.object.position),xa.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(xa.direction))<Ca?this.object.lookAt(this.target):(Sa.setFromNormalAndCoplanarPoint(this.object.up,this.target),xa.intersectPlane(Sa,this.target))))}else if(this.object.isOrthographicCamera){let e=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),e!==this.object.zoom&&(this.object.updateProjectionMatrix(),i=!0)}return this._scale=1,this._performCursorZoom=!1,i||this._lastPosition.distanceToSquared(this.object.position)>Ea||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Ea||this._lastTargetPosition.distanceToSquared(this.target)>Ea?(this.dispatchEvent(va),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e===null?Ta/60/60*this.autoRotateSpeed:Ta/60*this.autoRotateSpeed*e}_getZoomScale(e){let t=Math.abs(e*.01);return .95**(this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){wa.setFromMatrixColumn(t,0),wa.multiplyScalar(-e),this._panOffset.add(wa)}_panUp(e,t){this.screenSpacePanning===!0?wa.setFromMatrixColumn(t,1):(wa.setFromMatrixColumn(t,0),wa.crossVectors(this.object.up,wa)),wa.multiplyScalar(e),this._panOffset.add(wa)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;wa.copy(r).sub(this.target);let i=wa.length();i*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*i/n.clientHeight,this.object.matrix),this._panUp(2*t*i/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - pan disabled.`),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled.`),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled.`),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),r=e-n.left,i=t-n.top,a=n.width,o=n.height;this._mouse.x=r/a*2-1,this._mouse.y=-(i/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Ta*this._rotateDelta.x/t.clientHeight),this._rotateUp(Ta*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Ta*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Ta*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Ta*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Ta*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateStart.set(n,r)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panStart.set(n,r)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,i=Math.sqrt(n*n+r*r);this._dollyStart.set(0,i)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateEnd.set(n,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Ta*this._rotateDelta.x/t.clientHeight),this._rotateUp(Ta*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panEnd.set(n,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,i=Math.sqrt(n*n+r*r);this._dollyEnd.set(0,i),this._dollyDelta.set(0,(this._dollyEnd.y/this._dollyStart.y)**+this.zoomSpeed),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new I,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function Oa(e){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(e.pointerId),this.domElement.ownerDocument.addEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.addEventListener(`pointerup`,this._onPointerUp)),this._isTrackingPointer(e)||(this._addPointer(e),e.pointerType===`touch`?this._onTouchStart(e):this._onMouseDown(e),this._cursorStyle===`grab`&&(this.domElement.style.cursor=`grabbing`)))}function ka(e){this.enabled!==!1&&(e.pointerType===`touch`?this._onTouchMove(e):this._onMouseMove(e))}function Aa(e){switch(this._removePointer(e),this._pointers.length){case 0:this.domElement.releasePointerCapture(e.pointerId),this.domElement.ownerDocument.removeEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.removeEventListener(`pointerup`,this._onPointerUp),this.dispatchEvent(ba),this.state=Y.NONE,this._cursorStyle===`grab`&&(this.domElement.style.cursor=`grab`);break;case 1:let t=this._pointers[0],n=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:n.x,pageY:n.y})}}function ja(e){let t;switch(e.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case De.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(e),this.state=Y.DOLLY;break;case De.ROTATE:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=Y.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=Y.ROTATE}break;case De.PAN:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=Y.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=Y.PAN}break;default:this.state=Y.NONE}this.state!==Y.NONE&&this.dispatchEvent(ya)}function Ma(e){switch(this.state){case Y.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(e);break;case Y.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(e);break;case Y.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(e)}}function Na(e){this.enabled!==!1&&this.enableZoom!==!1&&this.state===Y.NONE&&(e.preventDefault(),this.dispatchEvent(ya),this._handleMouseWheel(this._customWheelEvent(e)),this.dispatchEvent(ba))}function Pa(e){this.enabled!==!1&&this._handleKeyDown(e)}function Fa(e){switch(this._trackPointer(e),this._pointers.length){case 1:switch(this.touches.ONE){case wt.ROTATE:if(this.enableRotate===!1){this.state=Y.NONE;break}this._handleTouchStartRotate(e),this.state=Y.TOUCH_ROTATE;break;case wt.PAN:if(this.enablePan===!1){this.state=Y.NONE;break}this._handleTouchStartPan(e),this.state=Y.TOUCH_PAN;break;default:this.state=Y.NONE}break;case 2:switch(this.touches.TWO){case wt.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(e),this.state=Y.TOUCH_DOLLY_PAN;break;case wt.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(e),this.state=Y.TOUCH_DOLLY_ROTATE;break;default:this.state=Y.NONE}break;default:this.state=Y.NONE}this.state!==Y.NONE&&this.dispatchEvent(ya)}function Ia(e){switch(this._trackPointer(e),this.state){case Y.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(e),this.update();break;case Y.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(e),this.update();break;case Y.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(e),this.update();break;case Y.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(e),this.update();break;default:this.state=Y.NONE}}function La(e){this.enabled!==!1&&e.preventDefault()}function Ra(e){e.key===`Control`&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener(`keyup`,this._interceptControlUp,{passive:!0,capture:!0}))}function za(e){e.key===`Control`&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener(`keyup`,this._interceptControlUp,{passive:!0,capture:!0}))}var Ba=.94,Va={top:0,right:0,bottom:0,left:0},Ha=.35;function Ua(e,t,n,{top:r,right:i,bottom:a,left:o}){let s=Math.tan(n*Math.PI/360),c=Math.max(Ha,1-(o+i)/e),l=Math.max(Ha,1-(r+a)/t),u=(e,t,n)=>Math.max(-1,Math.min(1,e/(t*(1-n))||0))*t*(1-n);return{tanX:s*e/t*c,tanY:s*l,offsetX:u((o-i)/2,e,c),offsetY:u((r-a)/2,t,l)}}var Wa=4;function Ga(e,t,n,r,i){let a=new _t().setFromPoints([...e]).getCenter(new j),o=new j(0,1,0).cross(t).normalize(),s=t.clone().cross(o),c=e.map(e=>{let n=e.clone().sub(a);return{x:n.dot(o),y:n.dot(s),z:n.dot(t)}}),[l,u]=[0,0],d=r;for(let e=0;;e++){d=r;for(let e of c)d=Math.max(d,e.z+Math.max(Math.abs(e.x-l)/(Ba*n.tanX),Math.abs(e.y-u)/(Ba*n.tanY)));if(d=Math.min(i,d),e===Wa||d===r)break;let[t,a]=[new I(1/0,1/0),new I(-1/0,-1/0)];for(let e of c){let n=new I(e.x-l,e.y-u).divideScalar(Math.max(.1,d-e.z));t.min(n),a.max(n)}l+=d*(t.x+a.x)/2,u+=d*(t.y+a.y)/2}let f=a.addScaledVector(o,l).addScaledVector(s,u);return{target:f,position:f.clone().addScaledVector(t,d)}}function Ka(e,{tanX:t,tanY:n},r){let i=Math.tan(r*Math.PI/360),a=e.getSize(new j);return Math.max(a.x/2/Ba*(i/t),a.y/2/Ba*(i/n))}var qa=1.2,Ja=2.4;function Ya(e){return Math.min(Ja,Math.max(1,qa/e))}var Xa=.3,Za=2,Qa=.32,$a=5,eo=400,to=7,no=2.5,ro=.45,io=55,ao=200,oo=2,so=.06,co=1.12,lo=Math.atan2(13,18),uo=[.39,.72],fo=new j(0,0,1),po=class{perspective=new St(io,1,.1,3e3);flat=new nt(-1,1,1,-1,.1,400);controls;planar=!1;approaching={distance:0,remainingS:0};move;insets=Va;offset=new I;halfHeight=10;width=1;height=1;constructor(e){this.perspective.position.set(13,10,17),this.controls=new Da(this.perspective,e),this.controls.target.set(0,1,-1),this.controls.maxPolarAngle=Math.PI*.495,this.controls.enableDamping=!0,this.controls.dampingFactor=.12,this.controls.maxDistance=800,this.controls.minDistance=1,this.controls.addEventListener(`start`,()=>this.move=void 0)}get camera(){return this.planar?this.flat:this.perspective}get viewHeight(){return this.planar?2*this.halfHeight/this.flat.zoom:2*Math.tan(this.perspective.fov*Math.PI/360)*this.perspective.position.distanceTo(this.controls.target)}get distance(){return this.viewHeight/(2*Math.tan(io*Math.PI/360))}setPlanar(e){if(this.planar===e)return;this.planar=e,this.move=void 0;let{controls:t}=this;t.object=this.camera,t.enableRotate=!e,t.mouseButtons.LEFT=e?De.PAN:De.ROTATE,t.touches.ONE=e?wt.PAN:wt.ROTATE,t.maxPolarAngle=Math.PI*(e?.5:.495),e&&this.flat.position.copy(t.target).addScaledVector(fo,ao),this.applyProjection()}frame(e,t=!1){if(e.length===0)return;this.perspective.fov=io;let n=this.freeArea();if(this.planar){let r=new _t().setFromPoints([...e]),i=r.getCenter(new j).setZ(0);this.moveTo(this.straightOn(i,Math.max(oo,Ka(r,n,io))),t);return}let r=t?this.direction():mo(this.width/this.height);this.moveTo({...Ga(e,r,n,$a,eo),halfHeight:0},t)}focus(e,t){let n=Math.max(no,to*t),r=e.clone();if(this.planar)return this.moveTo(this.straightOn(r.setZ(0),Math.max(oo,n/2)),!0);this.moveTo({target:r,position:r.clone().addScaledVector(this.direction(),n),halfHeight:0},!0)}setView(e,t,n){let r=n>0?n:io;if(this.planar){let n=e.distanceTo(t)*Math.tan(r*Math.PI/360);return this.moveTo(this.straightOn(t.clone().setZ(0),n),!1)}this.perspective.fov=r;let i=e.clone().sub(t).multiplyScalar(Ya(this.width/this.height)).add(t);this.moveTo({position:i,target:t.clone(),halfHeight:0},!1),this.applyProjection()}setInsets(e){this.insets=e}update(e){this.advanceMove(e);let t=this.freeArea(),n=1-Math.exp(-9*e),r=this.offset.clone();this.offset.lerp(new I(-t.offsetX,-t.offsetY),n),this.offset.distanceToSquared(r)>1e-4&&this.applyProjection(),this.controls.update()}resize(e,t){this.width=Math.max(1,e),this.height=Math.max(1,t);let n=this.freeArea();this.offset.set(-n.offsetX,-n.offsetY),this.applyProjection()}key(e){let t={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[e];if(t)this.turn(t[0],t[1]);else if(e===`Equal`||e===`NumpadAdd`)this.zoom(1/co);else if(e===`Minus`||e===`NumpadSubtract`)this.zoom(co);else return!1;return this.move=void 0,!0}turn(e,t){let{target:n}=this.controls;if(this.planar){let r=new j(e,t,0).multiplyScalar(this.viewHeight*.04);n.add(r),this.flat.position.add(r);return}let r=new Ne().setFromVector3(this.perspective.position.clone().sub(n));r.theta+=so*e,r.phi=Math.min(this.controls.maxPolarAngle,Math.max(.05,r.phi-so*t)),this.perspective.position.copy(n).add(new j().setFromSpherical(r))}zoom(e){this.planar?(this.flat.zoom/=e,this.applyProjection()):this.perspective.position.sub(this.controls.target).multiplyScalar(e).add(this.controls.target)}direction(){return this.perspective.position.clone().sub(this.controls.target).normalize()}straightOn(e,t){return{target:e,position:e.clone().addScaledVector(fo,ao),halfHeight:t}}pose(){return{position:this.camera.position.clone(),target:this.controls.target.clone(),halfHeight:this.viewHeight/2}}moveTo(e,t){this.move=t?{from:this.pose(),to:e,seconds:0}:void 0,t||this.setPose(e)}setPose({position:e,target:t,halfHeight:n}){this.camera.position.copy(e),this.controls.target.copy(t),this.planar&&(this.halfHeight=n,this.flat.zoom=1,this.applyProjection())}advanceMove(e){if(!this.move)return;let{from:t,to:n}=this.move;this.move.seconds+=e;let r=Math.min(1,this.move.seconds/ro),i=r*r*(3-2*r),a=t.target.clone().lerp(n.target,i),o=t.position.clone().sub(t.target).lerp(n.position.clone().sub(n.target),i),s=t.halfHeight+i*(n.halfHeight-t.halfHeight);this.setPose({target:a,position:a.clone().add(o),halfHeight:s}),r===1&&(this.move=void 0)}freeArea(){return Ua(this.width,this.height,this.perspective.fov,this.insets)}applyProjection(){let{width:e,height:t,offset:n,flat:r,perspective:i}=this,a=e/t;i.aspect=a,Object.assign(r,{left:-a*this.halfHeight,right:a*this.halfHeight,top:this.halfHeight,bottom:-this.halfHeight});for(let a of[i,r])a.setViewOffset(e,t,n.x,n.y,e,t),a.updateProjectionMatrix()}startApproach(e){this.move=void 0,this.approaching={distance:e,remainingS:Za}}follow(e,t,n){let r=this.controls.target,i=new j(e[0],e[1]+Xa,e[2]).sub(r);if(r.add(i),this.camera.position.add(i),this.planar||(this.approaching.remainingS>0&&this.approach(n),t===void 0))return;let a=this.camera.position.clone().sub(r),o=Math.atan2(a.x,a.z),s=Math.atan2(Math.sin(t-o),Math.cos(t-o));a.applyAxisAngle(new j(0,1,0),s*(1-Math.exp(-3*n))),this.camera.position.copy(r).add(a)}approach(e){this.approaching.remainingS-=e;let t=new Ne().setFromVector3(this.camera.position.clone().sub(this.controls.target)),n=1-Math.exp(-4*e);t.radius+=n*(this.approaching.distance-t.radius),t.phi+=n*(Math.PI/2-Qa-t.phi),this.camera.position.copy(this.controls.target).add(new j().setFromSpherical(t))}renderWithin(e,t){let{position:n}=this.camera,{target:r}=this.controls,i=n.clone(),a=i.distanceTo(r);e<a&&!this.planar&&n.lerpVectors(r,i,e/a),t(),n.copy(i)}ray(e,t,n,r){let i=new st;return this.camera.updateMatrixWorld(),i.setFromCamera(new I(e/n*2-1,1-t/r*2),this.camera),i}};function mo(e){let t=Math.min(1,Math.max(0,(1.4-e)/.8)),n=uo[0]+t*(uo[1]-uo[0]);return new j().setFromSphericalCoords(1,Math.PI/2-n,lo)}var ho=8,go=260,_o=112,vo=.22;function yo({level:e,waves:t},n,r){return t.reduce((e,t)=>e+t.amplitude*Math.cos(t.number*(t.x*n+t.z*r)+t.phase),e)}var bo=`
uniform float level;
uniform vec2 center;
uniform int count;
uniform vec2 waves[${ho}];  // amplitude, phase
uniform vec2 waveVectors[${ho}];   // number times direction
varying vec3 vPosition;
varying float vCrest;
#include <fog_pars_vertex>
void main() {
  vec2 at = center + position.xz;
  float lift = 0.0;
  for (int i = 0; i < ${ho}; i++)
    if (i < count) lift += waves[i].x * cos(dot(waveVectors[i], at) + waves[i].y);
  vCrest = lift;
  vPosition = vec3(at.x, level + lift, at.y);
  vec4 mvPosition = viewMatrix * vec4(vPosition, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  #include <fog_vertex>
}`,xo=`
uniform int count;
uniform vec2 waves[${ho}];
uniform vec2 waveVectors[${ho}];
uniform float highest;
uniform vec3 sun;
varying vec3 vPosition;
varying float vCrest;
#include <common>
#include <fog_pars_fragment>
void main() {
  vec2 slope = vec2(0.0);
  for (int i = 0; i < ${ho}; i++)
    if (i < count) slope -= waves[i].x * waveVectors[i] * sin(dot(waveVectors[i], vPosition.xz) + waves[i].y);
  // Ripples: only in the normals, and only near the camera.
  float away = length(cameraPosition - vPosition);
  float near = exp(-away / 25.0);
  vec2 p = vPosition.xz;
  float t = waves[0].y;
  slope += near * 0.06 * vec2(sin(3.1 * p.x + 1.7 * p.y - 2.1 * t) + sin(1.3 * p.x - 4.3 * p.y + 3.3 * t), sin(2.3 * p.y - 2.9 * p.x + 2.7 * t));
  vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y));
  vec3 toEye = normalize(cameraPosition - vPosition);
  if (dot(normal, toEye) < 0.0) normal = -normal;
  float mirror = 0.03 + 0.97 * pow(1.0 - max(0.0, dot(normal, toEye)), 5.0);
  vec3 deep = vec3(0.012, 0.10, 0.14);
  vec3 shallow = vec3(0.04, 0.26, 0.30);
  vec3 sky = vec3(0.20, 0.32, 0.44);
  float crest = highest > 0.0 ? vCrest / highest : 0.0;
  vec3 color = mix(mix(deep, shallow, 0.5 + 0.5 * crest), sky, mirror);
  color += vec3(1.0, 0.94, 0.8) * 0.9 * pow(max(0.0, dot(reflect(-toEye, normal), sun)), 90.0);
  color = mix(color, vec3(0.75, 0.82, 0.85), 0.14 * smoothstep(0.7, 1.0, crest));
  gl_FragColor = vec4(color, mix(0.78, 0.97, mirror));
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #include <fog_fragment>
}`,So=class{scene;sheets=[];used=0;surfaces=[];constructor(e){this.scene=e}begin(){this.used=0,this.surfaces.length=0}add(e,t){this.surfaces.push(e);let n=this.sheets[this.used++]??=this.make();n.visible=!0;let{uniforms:r}=n.material;r.level.value=e.level,r.center.value.set(t.x,t.z),r.count.value=Math.min(ho,e.waves.length),r.highest.value=e.waves.reduce((e,t)=>e+t.amplitude,0),e.waves.slice(0,ho).forEach((e,t)=>{r.waves.value[t].set(e.amplitude,e.phase),r.waveVectors.value[t].set(e.number*e.x,e.number*e.z)})}end(){for(let e=this.used;e<this.sheets.length;e++)this.sheets[e].visible=!1}make(){let e=()=>Array.from({length:ho},()=>new I),t=new it({vertexShader:bo,fragmentShader:xo,uniforms:xe.merge([J.fog,{level:{value:0},center:{value:new I},count:{value:0},highest:{value:0},waves:{value:e()},waveVectors:{value:e()},sun:{value:new j(-14,28,17).normalize()}}]),transparent:!0,depthWrite:!1,side:2,fog:!0}),n=new H(Co(),t);return n.frustumCulled=!1,this.scene.add(n),n}};function Co(){let e=new Ge(2,2,_o,_o).rotateX(-Math.PI/2),t=e.getAttribute(`position`),n=e=>go*(vo*e+.78*e**3);for(let e=0;e<t.count;e++)t.setXYZ(e,n(t.getX(e)),0,n(t.getZ(e)));return e}function wo(e){let{connection:t,view:n,moduleView:r,pointObjectsView:i,camera:a,driving:o,frameTimes:s,jointView:c,sandbox:l,people:u,room:d}=e,{stats:f,qualityName:p,recording:m,prediction:h,controllableEntities:g}=e,_=(e,t,n)=>{a.camera.updateMatrixWorld();let r=new j(e,t,n).project(a.camera);return{x:(r.x+1)/2*innerWidth,y:(1-r.y)/2*innerHeight}};Object.defineProperty(window,"jostle",{value:{get state(){return t.state},get tick(){return t.frames.newest?.frame??0},get entityCount(){return t.frames.newest?.entities.length??0},get pointObjectCount(){return i.count},pointsOf:e=>{let n=[...t.points.objects.values()][e];return n?.hasPoints?[...n.positions.subarray(0,3*n.count)]:void 0},get jointCount(){return c.count},jointIds:()=>[...t.joints.joints.keys()],get selected(){return l.selection.current},get inspected(){let e=l.newestInspection;return e?.body??e?.joint},get selectionVertexCount(){return l.selectionView.lines.count},get room(){return t.data.room},get areaVertexCount(){return d.areaVertexCount},attributesOf:e=>Object.fromEntries([...t.data.attributesOf({kind:`entity`,id:e})].map(([e,{value:t}])=>[e,typeof t.value==`bigint`?Number(t.value):t.value])),get snapshots(){return t.snapshots},get people(){return u.inspect()},get clientId(){return t.welcome?.clientId??0},get resumed(){return t.resumed},get decodeErrors(){return t.decodeErrors},get stats(){return f()},get frameScript(){return{frames:s.frames,median:s.percentile(.5),p90:s.percentile(.9)}},resetFrameScript:()=>s.reset(),get quality(){return p()},get planar(){return a.planar},get cameraTarget(){return[...a.controls.target.toArray(),a.distance]},get inputTick(){return t.inputClock.ready?t.inputClock.tick(v()):0},get recording(){let e=m();return e&&{tick:e.tick,seconds:e.seconds,length:e.length,playing:e.playing}},get prediction(){let e=h();return e&&{followed:e.followed,sent:e.sent,late:e.late,...e.stats}},get controlledEntity(){return o.entity},controllableEntities:g,dynamicBodies:()=>[...t.entities.values()].filter(e=>e.mass>0).map(e=>e.id),entityName:e=>t.entities.get(e)?.name,poseOf:e=>{let t=n.poseOf(e);return t?[...t]:void 0},screenPosition:e=>{let t=n.poseOf(e);return t&&_(t[0],t[1],t[2])},toScreen:_,partCounts:()=>n.partCounts(),moduleLineCount:()=>r.lines.count/2,moduleSolidCount:()=>r.solids.count,moduleSolidMatrix:(e,t)=>[...r.solids.matrixOf(e,t).elements],waterHeights:(e,t)=>r.water.surfaces.map(n=>yo(n,e,t))}})}var To={right:0,forward:1,up:2,yaw:3},Eo=4,Do=1e3,Oo=1e3,ko=.15,Ao={KeyW:[To.forward,1],ArrowUp:[To.forward,1],KeyS:[To.forward,-1],ArrowDown:[To.forward,-1],KeyD:[To.right,1],ArrowRight:[To.right,1],KeyA:[To.right,-1],ArrowLeft:[To.right,-1]},jo=[{code:`Space`,pad:0,bit:0},{code:`ShiftLeft`,pad:1,bit:1},{code:`KeyE`,pad:5,bit:2},{code:`KeyQ`,pad:4,bit:3}];function Mo(e,t){if(!e||!t)return e??t;let n=(e=0,t=0)=>Math.abs(t)>Math.abs(e)?t:e,r=Math.max(e.buttons.length,t.buttons.length);return{axes:[0,1].map(r=>n(e.axes[r],t.axes[r])),buttons:Array.from({length:r},(n,r)=>({pressed:(e.buttons[r]?.pressed??!1)||(t.buttons[r]?.pressed??!1),value:Math.max(e.buttons[r]?.value??0,t.buttons[r]?.value??0)}))}}function No(e){return e===void 0||Math.abs(e)<ko?0:e}function Po(e,t,n){let r=Array(Eo).fill(0);for(let t of e){let e=Ao[t];e&&(r[e[0]]=r[e[0]]+e[1])}let i=0;for(let{code:t,bit:n}of jo)e.has(t)&&(i|=1<<n);if(t){r[To.right]=r[To.right]+No(t.axes[0]),r[To.forward]=r[To.forward]-No(t.axes[1])+(t.buttons[7]?.value??0)-(t.buttons[6]?.value??0);for(let{pad:e,bit:n}of jo)t.buttons[e]?.pressed&&(i|=1<<n)}return r[To.yaw]=n,{axes:r.map(e=>Math.round(Math.min(1,Math.max(-1,e))*Do)+0),buttons:i}}function Fo(e){return Math.atan2(-e.x,-e.z)/Math.PI}var Io=class{send;entity=0;keys=new Set;lastSent;lastSentAt=0;constructor(e){this.send=e}takeControl(e){this.entity=e,this.lastSent=void 0,this.keys.clear(),this.send({kind:{case:`possess`,value:{entity:e}}})}stopControlling(){this.entity!==0&&this.takeControl(0)}reset(){this.entity=0,this.keys.clear()}keyDown(e){return this.entity===0||!(e in Ao||jo.some(t=>t.code===e))?!1:(this.keys.add(e),!0)}keyUp(e){this.keys.delete(e)}blur(){this.keys.clear()}update(e,t,n){if(this.entity===0)return;let r=Po(this.keys,e,t);this.lastSent?.buttons===r.buttons&&this.lastSent.axes.every((e,t)=>e===r.axes[t])&&n-this.lastSentAt<Oo||(this.lastSent=r,this.lastSentAt=n,this.send({kind:{case:`control`,value:r}}))}},Lo=500;function Ro(e,t){for(let n of t.intersectObjects(e.objects,!1)){if(n.instanceId===void 0)continue;let{entity:r,shape:i}=e.ownerAt(n.object,n.instanceId);if(r===0)continue;let a=n.face?.normal.clone()??new j(0,1,0),o=new b;return n.object.getMatrixAt(n.instanceId,o),a.applyNormalMatrix(new L().getNormalMatrix(o)).normalize(),a.dot(t.ray.direction)>0&&a.negate(),{entity:r,shape:i,point:n.point,normal:a,distance:n.distance}}}var zo=1.2,Bo=.25;function Vo(e,t,n,r){let i=n.clone().sub(t),a=new st(t,i.clone().normalize(),0,i.length());for(let t of a.intersectObjects(e.objects,!1)){if(t.instanceId===void 0)continue;let{entity:n}=e.ownerAt(t.object,t.instanceId);if(n!==0&&n!==r&&!e.dynamicPoseOf(n))return Math.max(zo,t.distance-Bo)}return 1/0}function Ho(e,t,n){return Ro(e,new st(new j(t,Lo,n),new j(0,-1,0),0,2*Lo))?.point.y}async function Uo(e,{origin:t,direction:n},r){let i=n.clone().multiplyScalar(Lo),a=({x:e,y:t,z:n})=>({x:e,y:t,z:n}),o=await e.castRays({rays:[{origin:a(t),motion:a(i)}],viewTime:r});if(!o)return;let s=o.rays[0]?.hits[0];if(!s)return{hit:void 0};let{entity:c,shape:l,fraction:u}=s;return{hit:{entity:c,shape:l,point:new j(s.point?.x,s.point?.y,s.point?.z),normal:new j(s.normal?.x,s.normal?.y,s.normal?.z),distance:u*Lo}}}function Wo(e,t,n){return!t||e&&e.entity!==t.hit?.entity&&n(e.entity)?e:t.hit}var Go=class{intervalMs;run;due=!1;running=!1;last=-1/0;timer;constructor(e,t){this.intervalMs=e,this.run=t}request(){this.due=!0,this.next()}next(){if(!this.due||this.running||this.timer!==void 0)return;let e=this.last+this.intervalMs-performance.now();if(e>0){this.timer=setTimeout(()=>{this.timer=void 0,this.next()},e);return}this.due=!1,this.running=!0,this.last=performance.now();let t=()=>{this.running=!1,this.next()};this.run().then(t,e=>{console.error(e),t()})}},Ko=.012;function qo(e,t){let n;for(let[r,i]of e){if(!i.hasPoints||i.description.entity!==0)continue;let e=i.layout.form===a.STRANDS?Yo(i,t):Zo(i,t),o=e?.distanceTo(t.origin)??1/0;e&&o<(n?.distance??1/0)&&(n={object:r,point:e,distance:o})}return n}var Jo=(e,t)=>new j().fromArray(e.positions,3*t);function Yo(e,t){let n=new j,r=new j,i,a=1/0,o=0;for(let s of e.layout.strands){for(let c=o;c+1<o+s;c++){let o=Math.sqrt(t.distanceSqToSegment(Jo(e,c),Jo(e,c+1),n,r)),s=n.distanceTo(t.origin);o>Math.max(e.description.radius,Ko*s)||s>=a||(a=s,i=r.clone())}o+=s}return i}function*Xo({layout:e}){if(e.form===a.TRIANGLES)for(let t=0;t+2<e.triangles.length;t+=3)yield[e.triangles[t],e.triangles[t+1],e.triangles[t+2]];if(e.form===a.GRID)for(let t=0;t+e.columns+1<e.points;t++)(t+1)%e.columns!==0&&(yield[t,t+1,t+e.columns],yield[t+1,t+e.columns+1,t+e.columns])}function Zo(e,t){let n=new j,r;for(let[i,a,o]of Xo(e))t.intersectTriangle(Jo(e,i),Jo(e,a),Jo(e,o),!1,n)&&(!r||n.distanceToSquared(t.origin)<r.distanceToSquared(t.origin))&&(r=n.clone());return r}var Qo={default:{name:`Default`,density:1e3,friction:.5,restitution:0,color:6000111},wood:{name:`Wood`,density:600,friction:.45,restitution:.3,color:12159830},stone:{name:`Stone`,density:2600,friction:.7,restitution:.1,color:9278105},steel:{name:`Steel`,density:7850,friction:.3,restitution:.25,color:11121858},ice:{name:`Ice`,density:917,friction:.03,restitution:.05,color:12575733},rubber:{name:`Rubber`,density:1100,friction:1,restitution:.8,color:3817287}},$o={min:.1,max:2,default:.7},es={min:.001,max:1e6},ts=()=>({size:$o.default,mass:void 0,material:`default`,color:void 0});function ns(e,t,n){return Number.isFinite(e)?Math.min(n,Math.max(t,e)):t}function rs(e,t){let n=ns(t.size,$o.min,$o.max)/2,{density:r,friction:i,restitution:a,color:o}=Qo[t.material],s=t.material==="default"&&t.mass===void 0?{}:{friction:i,restitution:a,...t.mass===void 0?{density:r}:{mass:ns(t.mass,es.min,es.max)}};return{shape:{kind:{box:{case:`box`,value:{halfExtents:{x:n,y:n,z:n}}},sphere:{case:`sphere`,value:{radius:n}},capsule:{case:`capsule`,value:{radius:.63*n,halfLength:.87*n}}}[e],...s},color:t.color??(t.material==="default"?void 0:o),reach:e===`capsule`?1.5*n:n}}var is=[{tool:`drag`,key:`1`,label:`Drag`,hint:`Drag a body, a rope or cloth; drag the ground to turn the camera`,icon:`drag`},{tool:`throw`,key:`2`,label:`Throw`,hint:`Click to throw a ball from the camera`,icon:`throw`},{tool:`box`,key:`3`,label:`Box`,hint:`Click to place a box`,icon:`box`},{tool:`sphere`,key:`4`,label:`Ball`,hint:`Click to place a ball`,icon:`sphere`},{tool:`capsule`,key:`5`,label:`Capsule`,hint:`Click to place a capsule`,icon:`capsule`},{tool:`explode`,key:`6`,label:`Explode`,hint:`Click to trigger an explosion`,icon:`explode`},{tool:`delete`,key:`7`,label:`Delete`,hint:`Click a body that you spawned to delete it`,icon:`delete`},{tool:`drive`,key:`8`,label:`Drive`,hint:`Click a controllable entity to drive it; Esc releases it`,icon:`drive`},{tool:`cut`,key:`9`,label:`Cut`,hint:`Click a rope or cloth to cut it`,icon:`cut`},{tool:`joint`,key:`j`,label:`Joint`,hint:`Click two points to join their bodies; Build chooses the kind`,icon:`joint`},{tool:`inspect`,key:`0`,label:`Inspect`,hint:`Click a body or a joint to inspect it`,icon:`inspect`}],as={drag:`drag`,throw:`spawn`,box:`spawn`,sphere:`spawn`,capsule:`spawn`,explode:`explode`,delete:`delete`,drive:`control`,cut:`joints`,joint:`joints`},os=18,ss=.3,cs=6,ls=6,us=12,ds=550,fs=150,ps=100,ms=e=>({x:e.x,y:e.y,z:e.z});function hs(e){return Promise.race([e,new Promise(e=>setTimeout(()=>e(void 0),fs))])}var gs=class{options;tool=`drag`;enabled=!0;grabbed;pressed;longPress;fingers=new Map;hovering;rightPress;hover=new Go(ps,()=>this.updateHover());canvas;camera;view;connection;queries;constructor(e){this.options=e;let{canvas:t,camera:n,view:r,connection:i,queries:a}=e;[this.canvas,this.camera,this.view,this.connection,this.queries]=[t,n,r,i,a],t.addEventListener(`pointerdown`,e=>this.pointerDown(e),{capture:!0}),t.addEventListener(`pointermove`,e=>this.move(e)),t.addEventListener(`pointerup`,e=>this.pointerUp(e)),t.addEventListener(`pointercancel`,e=>{this.fingers.delete(e.pointerId),this.release()}),t.addEventListener(`pointerleave`,()=>{this.hovering=void 0,e.onHover(void 0)}),t.addEventListener(`dblclick`,t=>{this.tool!==`drag`&&this.enabled||e.onFocus(Ro(r,this.ray(t)))})}get grab(){return this.grabbed}ray(e){let t=this.canvas.getBoundingClientRect();return this.camera.ray(e.clientX-t.left,e.clientY-t.top,t.width,t.height)}send(e){this.connection.send({kind:e})}isDynamic(e){return e!==void 0&&(this.connection.entities.get(e.entity)?.mass??0)>0}isMoving=e=>this.connection.frames.newest?.entities.find(t=>t.id===e)?.atRest===!1;pointerDown(e){if(e.button===2&&(this.rightPress={x:e.clientX,y:e.clientY}),e.pointerType===`touch`&&e.isTrusted){let t=[...this.fingers.values()][0];if(this.fingers.set(e.pointerId,e),t)return this.startGesture(t)}e.isTrusted&&this.down(e)}startGesture(e){let t=this.grabbed!==void 0;if(this.release(),!t)return;let{pointerId:n,clientX:r,clientY:i}=e;this.canvas.dispatchEvent(new PointerEvent(`pointerdown`,{pointerId:n,clientX:r,clientY:i,pointerType:`touch`,bubbles:!0}))}down(e){if(e.button!==0)return;let{clientX:t,clientY:n}=e,r=e.pointerType===`touch`,i=this.ray(e);if(r&&this.startLongPress(i,t,n),!this.enabled)return;if(this.tool===`throw`){this.pressed={x:t,y:n,raycaster:i,touch:r,rendered:void 0,fromServer:Promise.resolve(void 0)};return}let a=Ro(this.view,i),o=this.pointsBefore(a,i),s={x:t,y:n,raycaster:i,touch:r,rendered:a,points:o,fromServer:o?Promise.resolve(void 0):Uo(this.queries,i.ray,this.connection.renderedTime())};if(this.pressed=s,this.tool===`drag`){if(o)return this.startGrab(o.point,{case:`grab`,value:{object:o.object,point:ms(o.point)}},0,e.pointerId);this.isDynamic(a)&&this.grabBody(a,e.pointerId),s.fromServer.then(t=>this.replacePick(s,Wo(a,t,this.isMoving),e.pointerId))}}startLongPress(e,t,n){this.stopLongPress();let r=setTimeout(()=>{this.longPress=void 0,this.release(),this.options.onMenu(Ro(this.view,e),t,n)},ds);this.longPress={timer:r,x:t,y:n}}pointsBefore(e,t){let n=qo(this.connection.points.objects,t.ray);return n&&n.distance<(e?.distance??1/0)?n:void 0}grabBody(e,t){this.startGrab(e.point,{case:`grab`,value:{entity:e.entity,point:ms(e.point)}},e.entity,t)}startGrab(e,t,n,r){this.camera.controls.enabled=!1;let i=this.camera.camera.getWorldDirection(new j);this.grabbed={entity:n,plane:new V().setFromNormalAndCoplanarPoint(i,e),point:this.inFrameOf(n,e),target:e.clone()},this.canvas.setPointerCapture(r),this.send(t),this.send({case:`drag`,value:{target:ms(e)}})}inFrameOf(e,t){let n=this.view.poseOf(e);if(!n)return t.clone();let r=new W(n[3],n[4],n[5],n[6]).conjugate();return t.clone().sub(new j(n[0],n[1],n[2])).applyQuaternion(r)}replacePick(e,t,n){if(!(this.pressed!==e||e.points||this.grabbed?.entity===t?.entity)){if(this.grabbed)this.dropGrab();else if(e.dragged)return;this.isDynamic(t)&&this.grabBody(t,n)}}move(e){let t=this.pressed;if(this.fingers.has(e.pointerId)&&this.fingers.set(e.pointerId,e),t&&this.hasMoved(t,e)&&(t.dragged=!0),this.longPress&&Math.hypot(e.clientX-this.longPress.x,e.clientY-this.longPress.y)>us&&this.stopLongPress(),!this.grabbed){if(e.buttons!==0||e.pointerType===`touch`)return;this.hovering=e,this.hover.request();return}let n=this.ray(e).ray.intersectPlane(this.grabbed.plane,new j);n&&(this.camera.planar||(n.y=Math.max(.05,n.y)),this.grabbed.target.copy(n),this.send({case:`drag`,value:{target:ms(n)}}))}async updateHover(){let e=this.hovering;if(!e)return;let t=this.ray(e),n=Ro(this.view,t),r=this.pointsBefore(n,t),i=Wo(n,await hs(Uo(this.queries,t.ray,this.connection.renderedTime())),this.isMoving);this.hovering&&(this.tool===`drag`&&(this.canvas.style.cursor=r||this.isDynamic(i)?`grab`:``),this.options.onHover(i))}hasMoved(e,t){return Math.hypot(t.clientX-e.x,t.clientY-e.y)>(e.touch?us:ls)}stopLongPress(){clearTimeout(this.longPress?.timer),this.longPress=void 0}pointerUp(e){if(this.fingers.delete(e.pointerId),this.stopLongPress(),e.button===2)return this.rightUp(e);this.up(e)}rightUp(e){let t=this.rightPress;this.rightPress=void 0,!t||Math.hypot(e.clientX-t.x,e.clientY-t.y)>ls||this.options.onMenu(Ro(this.view,this.ray(e)),e.clientX,e.clientY)}up(e){if(this.grabbed)return this.release();let t=this.pressed;this.pressed=void 0,t&&!this.hasMoved(t,e)&&(this.tool===`throw`?this.throwBall(t.raycaster):this.tool!==`drag`&&this.click(t,this.tool))}release(){this.pressed=void 0,this.stopLongPress(),this.grabbed&&this.dropGrab()}dropGrab(){this.grabbed=void 0,this.camera.controls.enabled=!0,this.send({case:`release`,value:{}})}async click(e,t){if(e.points&&t===`cut`)return this.send({case:`cut`,value:{object:e.points.object,point:ms(e.points.point)}});if(e.points&&t===`explode`)return this.explode(e.points.point);let n=Wo(e.rendered,await hs(e.fromServer),this.isMoving)??this.planarHit(e.raycaster);if(t===`inspect`||t===`joint`&&n)return this.options.onSandboxClick(t,n,e.raycaster.ray);if(n)switch(t){case`box`:case`sphere`:case`capsule`:return this.spawn(n,t);case`explode`:return this.explode(n.point);case`delete`:return n.entity===0?void 0:this.send({case:`delete`,value:{entity:n.entity}});case`drive`:return n.entity===0?void 0:this.options.takeControl(n.entity)}}planarHit({ray:e}){let t=this.camera.planar?e.intersectPlane(new V(new j(0,0,1),0),new j):null;return t?{entity:0,shape:0,point:t,normal:new j(0,0,0),distance:t.distanceTo(e.origin)}:void 0}explode(e){this.camera.planar&&(e.z=0),this.options.onExplosion(...e.toArray(),cs),this.send({case:`explode`,value:{center:ms(e),radius:cs,speed:12}})}spawn(e,t){let{shape:n,color:r,reach:i}=rs(t,this.options.spawnOptions),a=e.point.clone().addScaledVector(e.normal,i+.02);this.camera.planar&&(a.z=0),this.options.onSpawn(a,i),this.send({case:`spawn`,value:{shape:n,position:ms(a),...r===void 0?{}:{color:r}}})}throwBall(e){let{origin:t,direction:n}=e.ray,r=t.clone().addScaledVector(n,1),i=n.clone().multiplyScalar(os),a=this.planarHit(e);a&&(r.copy(a.point),i.set(os*Math.sign(this.camera.controls.target.x-r.x||1),0,0)),this.options.onSpawn(r,ss),this.send({case:`spawn`,value:{shape:{kind:{case:`sphere`,value:{radius:ss}}},position:ms(r),linearVelocity:ms(i)}})}},_s=44,vs=class{element;axes=[0,0];buttons=Array.from({length:8},()=>({pressed:!1,value:0}));stick=document.createElement(`div`);knob=document.createElement(`div`);row=document.createElement(`div`);pointer;shownLabels=``;constructor(e){this.element=e,this.stick.className=`stick`,this.knob.className=`knob`,this.row.className=`actions`,this.stick.setAttribute(`role`,`img`),this.stick.setAttribute(`aria-label`,`Stick: drag to steer`),this.stick.append(this.knob),e.append(this.stick,this.row),e.hidden=!0,this.stick.addEventListener(`pointerdown`,e=>{this.pointer=e.pointerId,this.stick.setPointerCapture(e.pointerId),this.steer(e)}),this.stick.addEventListener(`pointermove`,e=>e.pointerId===this.pointer&&this.steer(e));for(let e of[`pointerup`,`pointercancel`,`lostpointercapture`])this.stick.addEventListener(e,e=>e.pointerId===this.pointer&&this.center())}show(e){if(this.element.hidden=e===void 0,!e)return this.releaseAll();let t=e.join(`
`);t!==this.shownLabels&&(this.shownLabels=t,this.releaseAll(),this.row.replaceChildren(...e.flatMap((e,t)=>e?[this.button(e,t)]:[])))}button(e,t){let n=this.buttons[jo.find(e=>e.bit===t).pad],r=document.createElement(`button`);r.type=`button`,r.textContent=e;let i=e=>{n.pressed=e,n.value=+!!e,r.classList.toggle(`pressed`,e)};r.addEventListener(`pointerdown`,e=>{r.setPointerCapture(e.pointerId),i(!0)});for(let e of[`pointerup`,`pointercancel`,`lostpointercapture`])r.addEventListener(e,()=>i(!1));return r.addEventListener(`contextmenu`,e=>e.preventDefault()),r}steer(e){let t=this.stick.getBoundingClientRect(),[n,r]=ys(e.clientX-t.left-t.width/2,e.clientY-t.top-t.height/2);[this.axes[0],this.axes[1]]=[n,r],this.knob.style.transform=`translate(${_s*n}px, ${_s*r}px)`}center(){this.pointer=void 0,this.axes.fill(0),this.knob.style.transform=``}releaseAll(){this.center();for(let e of this.buttons)Object.assign(e,{pressed:!1,value:0})}};function ys(e,t){let n=1/Math.max(_s,Math.hypot(e,t));return[e*n,t*n]}var bs=8,xs=550,Ss=.05,Cs=new b,ws=new G,Ts=new G(16754240),Es=class{ball;marks=Array.from({length:bs},()=>({at:new j,radius:0,startMs:-1/0}));next=0;active=0;constructor(e){let t={transparent:!0,blending:2,depthWrite:!1,fog:!1,toneMapped:!1};this.ball=new Mt(new oe(1,3),new xt(t),bs),this.ball.instanceMatrix.setUsage(be),this.ball.instanceColor=new he(new Float32Array(24),3),this.ball.frustumCulled=!1,this.ball.visible=!1,e.add(this.ball)}add(e,t,n,r,i){if(this.marks.some(({at:r,startMs:a})=>i-a<xs&&Math.hypot(r.x-e,r.y-t,r.z-n)<Ss))return;let a=this.marks[this.next];this.next=(this.next+1)%bs,a.at.set(e,t,n),a.radius=r,a.startMs=i}get activeCount(){return this.active}update(e){let t=this.active;this.active=0,this.marks.forEach(({at:t,radius:n,startMs:r},i)=>{let a=(e-r)/xs,o=a>=0&&a<1;o&&this.active++;let s=o?n*(.12+.5*Math.sqrt(a)):0;this.ball.setMatrixAt(i,Cs.makeScale(s,s,s).setPosition(t)),this.ball.setColorAt(i,ws.copy(Ts).multiplyScalar(o?.5*(1-a)**1.5:0))}),this.ball.visible=this.active>0,(this.active!==0||t!==0)&&(this.ball.instanceMatrix.needsUpdate=!0,this.ball.instanceColor.needsUpdate=!0)}},Ds=new b().makeScale(0,0,0),Os=class{scene;kind;castShadow;mesh;entities;shapes;free=[];used=0;order=0;matricesChanged=!1;colorsChanged=!1;constructor(e,t,n,r,i,a=64){this.scene=e,this.kind=t,this.castShadow=i,this.entities=new Uint32Array(a),this.shapes=new Uint32Array(a),this.mesh=this.makeMesh(n,r,a)}set renderOrder(e){this.mesh.renderOrder=this.order=e}makeMesh(e,t,n){let r=new Mt(e,t,n);return r.instanceMatrix.setUsage(be),r.instanceColor=new he(new Float32Array(n*3).fill(1),3),r.castShadow=this.castShadow,r.receiveShadow=!0,r.frustumCulled=!1,r.count=0,r.renderOrder=this.order,r.userData.instances=this,this.scene.add(r),r}get size(){return this.used}acquire(e,t=0){let n=this.free.pop()??this.mesh.count;return n===this.mesh.instanceMatrix.count&&this.grow(),n===this.mesh.count&&this.mesh.count++,this.used++,this.entities[n]=e,this.shapes[n]=t,this.setMatrix(n,Ds),n}release(e){this.setMatrix(e,Ds),this.entities[e]=0,this.used--,this.free.push(e),this.used>0||(this.free=[],this.mesh.count=0)}entityAt(e){return this.entities[e]??0}shapeAt(e){return this.shapes[e]??0}setMatrix(e,t){t.toArray(this.mesh.instanceMatrix.array,e*16),this.matricesChanged=!0}setColor(e,t){t.toArray(this.mesh.instanceColor.array,e*3),this.colorsChanged=!0}colorAt(e){return new G().fromArray(this.mesh.instanceColor.array,e*3)}upload(){this.matricesChanged&&(this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.boundingSphere=null),this.colorsChanged&&(this.mesh.instanceColor.needsUpdate=!0),this.matricesChanged=this.colorsChanged=!1}dispose(){this.scene.remove(this.mesh),this.mesh.geometry.dispose(),this.mesh.dispose()}grow(){let e=this.mesh,t=e.instanceMatrix.count*2;this.scene.remove(e),this.mesh=this.makeMesh(e.geometry,e.material,t),this.mesh.count=e.count,this.mesh.instanceMatrix.array.set(e.instanceMatrix.array),this.mesh.instanceColor.array.set(e.instanceColor.array),this.entities=ks(this.entities,t),this.shapes=ks(this.shapes,t),this.matricesChanged=this.colorsChanged=!0,e.dispose()}};function ks(e,t){let n=new Uint32Array(t);return n.set(e),n}var As=new Uint32Array(2),js=new Float64Array(As.buffer),Ms=new WeakMap;function Ns(e,t){let n=Ms.get(e);return n===void 0&&Ms.set(e,n=t()),n}function Ps(e,...t){let n=2166136261,r=2654435769,i=0,a=e=>{n=Math.imul(n^e,16777619),n^=n>>>15,r=Math.imul(r^e,2246822507),r^=r>>>13};for(let e of t){for(let t of e)js[0]=t,a(As[0]),a(As[1]),i++;a(44)}let o=e=>(e>>>0).toString(16).padStart(8,`0`);return`${e}:${i}:${o(n)}${o(r)}`}var Fs=0,Is=1,Ls=new j,Rs=new ee,zs=new V,Bs=new j,Vs=new Ot,Hs=class{constructor(){this.tolerance=-1,this.faces=[],this.newFaces=[],this.assigned=new Ks,this.unassigned=new Ks,this.vertices=[]}setFromPoints(e){if(e.length>=4){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.vertices.push(new Gs(e[t]));this._compute()}return this}setFromObject(e){let t=[];return e.updateMatrixWorld(!0),e.traverse(function(e){let n=e.geometry;if(n!==void 0){let r=n.attributes.position;if(r!==void 0)for(let n=0,i=r.count;n<i;n++){let i=new j;i.fromBufferAttribute(r,n).applyMatrix4(e.matrixWorld),t.push(i)}}}),this.setFromPoints(t)}containsPoint(e){let t=this.faces;for(let n=0,r=t.length;n<r;n++)if(t[n].distanceToPoint(e)>this.tolerance)return!1;return!0}intersectRay(e,t){let n=this.faces,r=-1/0,i=1/0;for(let t=0,a=n.length;t<a;t++){let a=n[t],o=a.distanceToPoint(e.origin),s=a.normal.dot(e.direction);if(o>0&&s>=0)return null;let c=s===0?0:-o/s;if(!(c<=0)&&(s>0?i=Math.min(c,i):r=Math.max(c,r),r>i))return null}return r===-1/0?e.at(i,t):e.at(r,t),t}intersectsRay(e){return this.intersectRay(e,Ls)!==null}makeEmpty(){return this.faces=[],this.vertices=[],this}_addVertexToFace(e,t){return e.face=t,t.outside===null?this.assigned.append(e):this.assigned.insertBefore(t.outside,e),t.outside=e,this}_removeVertexFromFace(e,t){return e===t.outside&&(t.outside=e.next!==null&&e.next.face===t?e.next:null),this.assigned.remove(e),this}_removeAllVerticesFromFace(e){if(e.outside!==null){let t=e.outside,n=e.outside;for(;n.next!==null&&n.next.face===e;)n=n.next;return this.assigned.removeSubList(t,n),t.prev=n.next=null,e.outside=null,t}}_deleteFaceVertices(e,t){let n=this._removeAllVerticesFromFace(e);if(n!==void 0){if(t===void 0)this.unassigned.appendChain(n);else{let e=n;do{let n=e.next;t.distanceToPoint(e.point)>this.tolerance?this._addVertexToFace(e,t):this.unassigned.append(e),e=n}while(e!==null)}}return this}_resolveUnassignedPoints(e){if(this.unassigned.isEmpty()===!1){let t=this.unassigned.first();do{let n=t.next,r=this.tolerance,i=null;for(let n=0;n<e.length;n++){let a=e[n];if(a.mark===Fs){let e=a.distanceToPoint(t.point);if(e>r&&(r=e,i=a),r>1e3*this.tolerance)break}}i!==null&&this._addVertexToFace(t,i),t=n}while(t!==null)}return this}_computeExtremes(){let e=new j,t=new j,n=[],r=[];for(let e=0;e<3;e++)n[e]=r[e]=this.vertices[0];e.copy(this.vertices[0].point),t.copy(this.vertices[0].point);for(let i=0,a=this.vertices.length;i<a;i++){let a=this.vertices[i],o=a.point;for(let t=0;t<3;t++)o.getComponent(t)<e.getComponent(t)&&(e.setComponent(t,o.getComponent(t)),n[t]=a);for(let e=0;e<3;e++)o.getComponent(e)>t.getComponent(e)&&(t.setComponent(e,o.getComponent(e)),r[e]=a)}return this.tolerance=3*2**-52*(Math.max(Math.abs(e.x),Math.abs(t.x))+Math.max(Math.abs(e.y),Math.abs(t.y))+Math.max(Math.abs(e.z),Math.abs(t.z))),{min:n,max:r}}_computeInitialHull(){let e=this.vertices,t=this._computeExtremes(),n=t.min,r=t.max,i=0,a=0;for(let e=0;e<3;e++){let t=r[e].point.getComponent(e)-n[e].point.getComponent(e);t>i&&(i=t,a=e)}let o=n[a],s=r[a],c,l;i=0,Rs.set(o.point,s.point);for(let t=0,n=this.vertices.length;t<n;t++){let n=e[t];if(n!==o&&n!==s){Rs.closestPointToPoint(n.point,!0,Bs);let e=Bs.distanceToSquared(n.point);e>i&&(i=e,c=n)}}i=-1,zs.setFromCoplanarPoints(o.point,s.point,c.point);for(let t=0,n=this.vertices.length;t<n;t++){let n=e[t];if(n!==o&&n!==s&&n!==c){let e=Math.abs(zs.distanceToPoint(n.point));e>i&&(i=e,l=n)}}let u=[];if(zs.distanceToPoint(l.point)<0){u.push(Us.create(o,s,c),Us.create(l,s,o),Us.create(l,c,s),Us.create(l,o,c));for(let e=0;e<3;e++){let t=(e+1)%3;u[e+1].getEdge(2).setTwin(u[0].getEdge(t)),u[e+1].getEdge(1).setTwin(u[t+1].getEdge(0))}}else{u.push(Us.create(o,c,s),Us.create(l,o,s),Us.create(l,s,c),Us.create(l,c,o));for(let e=0;e<3;e++){let t=(e+1)%3;u[e+1].getEdge(2).setTwin(u[0].getEdge((3-e)%3)),u[e+1].getEdge(0).setTwin(u[t+1].getEdge(1))}}for(let e=0;e<4;e++)this.faces.push(u[e]);for(let t=0,n=e.length;t<n;t++){let n=e[t];if(n!==o&&n!==s&&n!==c&&n!==l){i=this.tolerance;let e=null;for(let t=0;t<4;t++){let r=this.faces[t].distanceToPoint(n.point);r>i&&(i=r,e=this.faces[t])}e!==null&&this._addVertexToFace(n,e)}}return this}_reindexFaces(){let e=[];for(let t=0;t<this.faces.length;t++){let n=this.faces[t];n.mark===Fs&&e.push(n)}return this.faces=e,this}_nextVertexToAdd(){if(this.assigned.isEmpty()===!1){let e,t=0,n=this.assigned.first().face,r=n.outside;do{let i=n.distanceToPoint(r.point);i>t&&(t=i,e=r),r=r.next}while(r!==null&&r.face===n);return e}}_computeHorizon(e,t,n,r){this._deleteFaceVertices(n),n.mark=Is;let i;i=t===null?t=n.getEdge(0):t.next;do{let t=i.twin,n=t.face;n.mark===Fs&&(n.distanceToPoint(e)>this.tolerance?this._computeHorizon(e,t,n,r):r.push(i)),i=i.next}while(i!==t);return this}_addAdjoiningFace(e,t){let n=Us.create(e,t.tail(),t.head());return this.faces.push(n),n.getEdge(-1).setTwin(t.twin),n.getEdge(0)}_addNewFaces(e,t){this.newFaces=[];let n=null,r=null;for(let i=0;i<t.length;i++){let a=t[i],o=this._addAdjoiningFace(e,a);n===null?n=o:o.next.setTwin(r),this.newFaces.push(o.face),r=o}return n.next.setTwin(r),this}_addVertexToHull(e){let t=[];return this.unassigned.clear(),this._removeVertexFromFace(e,e.face),this._computeHorizon(e.point,null,e.face,t),this._addNewFaces(e,t),this._resolveUnassignedPoints(this.newFaces),this}_cleanup(){return this.assigned.clear(),this.unassigned.clear(),this.newFaces=[],this}_compute(){let e;for(this._computeInitialHull();(e=this._nextVertexToAdd())!==void 0;)this._addVertexToHull(e);return this._reindexFaces(),this._cleanup(),this}},Us=class e{constructor(){this.normal=new j,this.midpoint=new j,this.area=0,this.constant=0,this.outside=null,this.mark=Fs,this.edge=null}static create(t,n,r){let i=new e,a=new Ws(t,i),o=new Ws(n,i),s=new Ws(r,i);return a.next=s.prev=o,o.next=a.prev=s,s.next=o.prev=a,i.edge=a,i.compute()}getEdge(e){let t=this.edge;for(;e>0;)t=t.next,e--;for(;e<0;)t=t.prev,e++;return t}compute(){let e=this.edge.tail(),t=this.edge.head(),n=this.edge.next.head();return Vs.set(e.point,t.point,n.point),Vs.getNormal(this.normal),Vs.getMidpoint(this.midpoint),this.area=Vs.getArea(),this.constant=this.normal.dot(this.midpoint),this}distanceToPoint(e){return this.normal.dot(e)-this.constant}},Ws=class{constructor(e,t){this.vertex=e,this.prev=null,this.next=null,this.twin=null,this.face=t}head(){return this.vertex}tail(){return this.prev?this.prev.vertex:null}length(){let e=this.head(),t=this.tail();return t===null?-1:t.point.distanceTo(e.point)}lengthSquared(){let e=this.head(),t=this.tail();return t===null?-1:t.point.distanceToSquared(e.point)}setTwin(e){return this.twin=e,e.twin=this,this}},Gs=class{constructor(e){this.point=e,this.prev=null,this.next=null,this.face=null}},Ks=class{constructor(){this.head=null,this.tail=null}first(){return this.head}last(){return this.tail}clear(){return this.head=this.tail=null,this}insertBefore(e,t){return t.prev=e.prev,t.next=e,t.prev===null?this.head=t:t.prev.next=t,e.prev=t,this}insertAfter(e,t){return t.prev=e,t.next=e.next,t.next===null?this.tail=t:t.next.prev=t,e.next=t,this}append(e){return this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail,e.next=null,this.tail=e,this}appendChain(e){for(this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail;e.next!==null;)e=e.next;return this.tail=e,this}remove(e){return e.prev===null?this.head=e.next:e.prev.next=e.next,e.next===null?this.tail=e.prev:e.next.prev=e.prev,this}removeSubList(e,t){return e.prev===null?this.head=t.next:e.prev.next=t.next,t.next===null?this.tail=e.prev:t.next.prev=e.prev,this}isEmpty(){return this.head===null}},qs=class extends lt{constructor(e=[]){super();let t=[],n=[],r=new Hs().setFromPoints(e).faces;for(let e=0;e<r.length;e++){let i=r[e],a=i.edge;do{let e=a.head().point;t.push(e.x,e.y,e.z),n.push(i.normal.x,i.normal.y,i.normal.z),a=a.next}while(a!==i.edge)}this.setAttribute(`position`,new de(t,3)),this.setAttribute(`normal`,new de(n,3))}},Js=1e4,Ys=Math.cos(2*Math.PI/180),Xs=Math.cos(20*Math.PI/180);function Zs(e){let t=e.points.map(e=>new j(e.x,e.y,e.z));if(t.length<4||!t.every(e=>Number.isFinite(e.lengthSq())))return;let n=new qs(t).getAttribute(`position`).array;if(n.length!==0)return ec(n,Ys)}function Qs(e){let t=[];for(let n=0;n+2<e.indices.length;n+=3){let[r,i,a]=[0,1,2].map(t=>e.vertices[e.indices[n+t]]);r&&i&&a&&t.push(r.x,r.y,r.z,i.x,i.y,i.z,a.x,a.y,a.z)}if(t.length!==0)return ec(new Float32Array(t),Xs)}function $s(e){let{columns:t,rows:n,heights:r}=e;if(t<2||n<2||r.length<t*n)return;let i=new Float32Array(t*n*3);for(let a=0;a<n;a++)for(let o=0;o<t;o++){let s=a*t+o,c=r[s];i[3*s]=(o-(t-1)/2)*e.spacingX,i[3*s+1]=Number.isFinite(c)?c:0,i[3*s+2]=(a-(n-1)/2)*e.spacingZ}let a=new Set(e.holes),o=[];for(let e=0;e+1<n;e++)for(let n=0;n+1<t;n++){if(a.has(e*(t-1)+n))continue;let i=e*t+n,s=i+t;[i,i+1,s,s+1].every(e=>Number.isFinite(r[e]))&&o.push(i,s,s+1,i,s+1,i+1)}let s=new lt;return s.setAttribute(`position`,new Fe(i,3)),s.setIndex(o),s.computeVertexNormals(),s}function ec(e,t){let n=new lt;n.setAttribute(`position`,new Fe(e,3)),n.computeVertexNormals();let r=n.getAttribute(`normal`).array;return n.setAttribute(`edge`,new Fe(tc(e,r,t),3)),n}function tc(e,t,n){let r=e.length/3,i=nc(e),a=new Map;for(let e=0;e<r;e++){let t=e-e%3,n=i[t+(e+1)%3],o=i[t+(e+2)%3],s=Math.min(n,o)*r+Math.max(n,o),c=a.get(s);c?c.push(e):a.set(s,[e])}let o=new Uint8Array(r).fill(1);for(let[e,r,...i]of a.values()){if(r===void 0||i.length>0)continue;let a=0;for(let n=0;n<3;n++)a+=t[3*e+n]*t[3*r+n];a>=n&&(o[e]=o[r]=0)}let s=new Float32Array(e.length),[c,l,u]=[new j,new j,new j];for(let t=0;t<r;t+=3)for(let n=0;n<3;n++){if(o[t+n]===0){for(let e=0;e<3;e++)s[3*(t+e)+n]=Js;continue}c.fromArray(e,3*(t+n)),l.fromArray(e,3*(t+(n+1)%3)),u.fromArray(e,3*(t+(n+2)%3));let r=u.sub(l),i=r.length(),a=r.cross(c.sub(l)).length();s[3*(t+n)+n]=i>0?a/i:0}return s}function nc(e){let t=new Map,n=new Uint32Array(e.length/3);for(let r=0;r<n.length;r++){let i=`${e[3*r]},${e[3*r+1]},${e[3*r+2]}`,a=t.get(i);a===void 0&&t.set(i,a=t.size),n[r]=a}return n}var rc=[`box`,`slab`,`plane`,`sphere`,`cap`,`tube`,`cylinder`,`cone`],ic={box:()=>new Ye(2,2,2),slab:()=>new Ye(2,2,2),plane:ac,sphere:()=>new qe(1,28,18),cap:()=>new qe(1,20,8,0,Math.PI*2,0,Math.PI/2),tube:()=>new Me(1,1,2,20,1,!0),cylinder:()=>new Me(1,1,2,32),cone:()=>new U(1,2,32,6)};function ac(){let e=new Ge(2,2,6,6).rotateX(-Math.PI/2),t=e.getAttribute(`position`);for(let e=0;e<t.count;e++)t.setXYZ(e,t.getX(e)**5,0,t.getZ(e)**5);return e}var oc=30,sc=2e3,cc=new j(0,1,0),lc=new j(1,1,1),uc=new W().setFromAxisAngle(new j(1,0,0),Math.PI);function dc(e,t=new b){let n=t.clone().multiply(fc(e)),r=(e,t,r=0,i=new W)=>{let a=new b().compose(new j(0,r,0),i,t);return{kind:e,key:e,geometry:ic[e],local:a.premultiply(n)}},i=(e,t,r)=>[{kind:e,key:t,geometry:r,local:n}];switch(e.kind.case){case`sphere`:{let t=e.kind.value.radius;return[r(`sphere`,new j(t,t,t))]}case`box`:{let t=e.kind.value.halfExtents,n=new j(t?.x??.5,t?.y??.5,t?.z??.5);return[r(n.x>=oc&&n.z>=oc?`slab`:`box`,n)]}case`capsule`:{let{radius:t,halfLength:n}=e.kind.value,i=new j(t,t,t);return[r(`tube`,new j(t,n,t)),r(`cap`,i,n),r(`cap`,i,-n,uc)]}case`cylinder`:case`cone`:{let{radius:t,halfLength:n}=e.kind.value;return[r(e.kind.case,new j(t,n,t))]}case`plane`:{let t=e.kind.value.normal,n=t?new j(t.x,t.y,t.z).normalize():cc,i=new W().setFromUnitVectors(cc,n);return[r(`plane`,new j(sc,1,sc),0,i)]}case`hull`:{let t=e.kind.value;return i(`hull`,Ns(t,()=>Ps(`hull`,pc(t.points))),()=>Zs(t))}case`mesh`:{let t=e.kind.value;return i(`mesh`,Ns(t,()=>Ps(`mesh`,pc(t.vertices),t.indices)),()=>Qs(t))}case`heightField`:{let t=e.kind.value,n=[t.columns,t.rows,t.spacingX,t.spacingZ];return i(`field`,Ns(t,()=>Ps(`field`,n,t.heights,t.holes)),()=>$s(t))}case`compound`:return e.kind.value.children.flatMap(e=>dc(e,n));default:return[]}}function fc({position:e,rotation:t}){let n=t?new W(t.x,t.y,t.z,t.w):new W;n.lengthSq()===0&&n.identity();let r=e?new j(e.x,e.y,e.z):new j;return new b().compose(r,n.normalize(),lc)}function*pc(e){for(let{x:t,y:n,z:r}of e)yield t,yield n,yield r}var mc=new b,hc=class{scene;kinds=new Map;material=new Ze({roughness:.6});constructor(e){this.scene=e}begin(){for(let e of this.kinds.values())e.usedCount=0}add(e,t,n,r,i){let a=this.entryOf(e);a.usedCount===a.slots.length&&a.slots.push(a.instances.acquire(0));let o=a.slots[a.usedCount++];a.instances.setMatrix(o,mc.compose(t,n,r)),a.instances.setColor(o,i)}end(){for(let{instances:e,slots:t,usedCount:n}of this.kinds.values()){for(;t.length>n;)e.release(t.pop());e.upload()}}countOf(e){return this.kinds.get(e)?.usedCount??0}get count(){return[...this.kinds.values()].reduce((e,{usedCount:t})=>e+t,0)}matrixOf(e,t){let{instances:n,slots:r}=this.entryOf(e),i=new b;return n.mesh.getMatrixAt(r[t],i),i}entryOf(e){let t=this.kinds.get(e);if(t)return t;let n={instances:new Os(this.scene,e,ic[e](),this.material,!0,32),slots:[],usedCount:0};return this.kinds.set(e,n),n}},gc=1024,_c=class e{object;count=0;positions;colors;constructor(e){this.object=e,e.frustumCulled=!1,e.renderOrder=1,this.reserve(gc),this.end()}static lines(t){let n={vertexColors:!0,depthTest:!1,transparent:!0,opacity:t,fog:!1,toneMapped:!1};return new e(new Te(new lt,new Se(n)))}static points(t){let n=new at({vertexColors:!0,depthTest:!1,transparent:!0,fog:!1,toneMapped:!1,size:t,sizeAttenuation:!1});return new e(new mt(new lt,n))}get capacity(){return this.positions.count}begin(){this.count=0}vertex(e,t,n,r){this.count===this.capacity&&this.reserve(this.capacity*2),this.positions.setXYZ(this.count,e,t,n),this.colors.setXYZ(this.count,r.r,r.g,r.b),this.count++}end(){let{geometry:e}=this.object;if(e.setDrawRange(0,this.count),this.object.visible=this.count>0,this.count!==0)for(let e of[this.positions,this.colors])e.clearUpdateRanges(),e.addUpdateRange(0,this.count*3),e.needsUpdate=!0}reserve(e){let{geometry:t}=this.object;t.dispose();let n=t=>{let n=new Float32Array(e*3);return t&&n.set(t.array),new Fe(n,3).setUsage(be)};this.positions=n(this.positions),this.colors=n(this.colors),t.setAttribute(`position`,this.positions),t.setAttribute(`color`,this.colors)}},vc=5e3,yc=new Map([[`boat`,async()=>(await K(async()=>{let{boats:e}=await import(`./boat-DORtwM3C.js`);return{boats:e}},__vite__mapDeps([0,1,2]),import.meta.url)).boats],[`character`,async()=>(await K(async()=>{let{characters:e}=await import(`./character-D1qa07sR.js`);return{characters:e}},__vite__mapDeps([3,1,2]),import.meta.url)).characters],[`destruction`,async()=>(await K(async()=>{let{destructibles:e}=await import(`./destruction-BqBWabhl.js`);return{destructibles:e}},__vite__mapDeps([4,1,5,2]),import.meta.url)).destructibles],[`fields`,async()=>(await K(async()=>{let{fields:e}=await import(`./fields-BvRz8Tp0.js`);return{fields:e}},__vite__mapDeps([6,1,2]),import.meta.url)).fields],[`fields.waves`,async()=>(await K(async()=>{let{waves:e}=await import(`./fields-BvRz8Tp0.js`);return{waves:e}},__vite__mapDeps([6,1,2]),import.meta.url)).waves],[`hovercraft`,async()=>(await K(async()=>{let{hovercraft:e}=await import(`./hovercraft-Cj2ozCZT.js`);return{hovercraft:e}},__vite__mapDeps([7,1,2]),import.meta.url)).hovercraft],[`ragdoll`,async()=>(await K(async()=>{let{ragdolls:e}=await import(`./ragdoll-BQIEZOv8.js`);return{ragdolls:e}},__vite__mapDeps([8,1,5]),import.meta.url)).ragdolls],[`vehicle`,async()=>(await K(async()=>{let{vehicles:e}=await import(`./vehicle-wLzOpZRd.js`);return{vehicles:e}},__vite__mapDeps([9,1,2]),import.meta.url)).vehicles]]),bc=[...yc.keys()],xc=class{renderers;lines=_c.lines(.9);solids;water;blasts;debug=!1;renderedKinds=[];coloredChannels=[];loaded=new Map;loading=new Set;constructor(e,t=yc){this.renderers=t,e.add(this.lines.object),this.solids=new hc(e),this.water=new So(e),this.blasts=new Es(e)}update(e,t){this.renderedKinds=this.groupByKind(e,e.channels);let{lines:n,solids:r,water:i,blasts:a,debug:o}=this;for(let e of[n,r,i])e.begin();let s={...t,lines:n,solids:r,water:i,blasts:a,debug:o};for(let{renderer:e,data:t}of this.renderedKinds)e.draw?.(t,s);t.decorate?.(r);for(let e of[n,r,i])e.end();a.update(t.nowMs)}bodyColors(e,t,n){let r=e.channels.filter(({kind:t})=>this.rendererOf(e,t)?.bodyColors);if(r.length===this.coloredChannels.length&&r.every((e,t)=>e===this.coloredChannels[t])&&!t)return;this.coloredChannels=r;let i=new Map;for(let{renderer:t,data:a}of this.groupByKind(e,r))for(let[e,r]of t.bodyColors?.(a,n)??[])i.set(e,r);return i}steeringOf(e){return this.controlledRenderer(e)?.steering}controlledStatusText(e){let{steering:t,data:n}=this.controlledRenderer(e)??{};return(n&&t?.statusText?.(n))??``}statusText(){return this.renderedKinds.map(({renderer:e,data:t})=>e.statusText?.(t)??``).filter(e=>e!==``).join(` · `)}rendererOf({kinds:e},t){let n=e[t]?.name??``,r=this.loaded.get(n),i=r?void 0:this.renderers.get(n);if(typeof i!=`function`)return r??i;this.loading.has(n)||(this.loading.add(n),i().then(e=>this.loaded.set(n,e),()=>setTimeout(()=>this.loading.delete(n),vc)))}groupByKind(e,t){let n=new Map;for(let{kind:r,entity:i,values:a}of t){let t=(e.frame-1)%Math.max(e.kinds[r]?.divisor??1,1)/e.tickHz+e.secondsAfter,o=n.get(r);o?o.push({entity:i,values:a,seconds:t}):n.set(r,[{entity:i,values:a,seconds:t}])}return[...n].flatMap(([t,n])=>{let r=this.rendererOf(e,t);return r?[{renderer:r,data:n}]:[]})}controlledRenderer(e){for(let{renderer:t,data:n}of this.renderedKinds){let r=t.steering&&n.find(t=>t.entity===e);if(t.steering&&r)return{steering:t.steering,data:r}}}};function Sc(e,t){let n=Math.max(0,e-1)*Math.max(0,t-1),r=new Uint32Array(6*n),i=0;for(let n=0;n+1<t;n++)for(let t=0;t+1<e;t++){let a=n*e+t;r.set([a,a+e,a+1,a+1,a+e,a+e+1],i),i+=6}return r}function Cc(e,t,n,r){let i=(t,n,r)=>e[3*t+r]-e[3*n+r];for(let e=0;e<n;e++)for(let a=0;a<t;a++){let o=e*t+a,[s,c]=[a>0?o-1:o,a+1<t?o+1:o],[l,u]=[e>0?o-t:o,e+1<n?o+t:o],[d,f,p]=[0,1,2].map(e=>i(c,s,e)),[m,h,g]=[0,1,2].map(e=>i(u,l,e)),_=[h*p-g*f,g*d-m*p,m*f-h*d],v=Math.hypot(..._)||1;for(let e=0;e<3;e++)r[3*o+e]=_[e]/v}}var wc=class{geometry=new lt;positions;normals;constructor(e,t){this.positions=new Float32Array(3*e),this.normals=new Float32Array(3*e);for(let[e,t]of[[`position`,this.positions],[`normal`,this.normals]])this.geometry.setAttribute(e,new Fe(t,3).setUsage(be));this.geometry.setIndex(new Fe(t,1))}changed(){this.geometry.getAttribute(`position`).needsUpdate=!0,this.geometry.getAttribute(`normal`).needsUpdate=!0}},Tc=e=>e+2;function Ec(e,t){let n=[],r=0;for(let i of e){for(let e=0;e+1<i;e++)for(let i=0;i<t;i++){let a=r+e*t+i,o=r+e*t+(i+1)%t;n.push(a,o,a+t,o,o+t,a+t)}r+=i*t}return Uint32Array.from(n)}var Dc=new j,Oc=new j,kc=new j;function Ac(e,t,n,r,i,a,o){Oc.set(0,0,0);let s=(t,n,s)=>{for(let c=0;c<r;c++)for(let l=0;l<3;l++){let u=3*(o+n*r+c)+l;i[u]=e[3*t+l],a[u]=s*Dc.getComponent(l)}};for(let c=0;c<t;c++){let[l,u]=[Math.max(0,c-1),Math.min(t-1,c+1)];Dc.set(...[0,1,2].map(t=>e[3*u+t]-e[3*l+t])),Dc.lengthSq()<1e-16&&Dc.set(0,1,0),Dc.normalize(),Oc.addScaledVector(Dc,-Oc.dot(Dc)),Oc.lengthSq()<1e-6&&(Oc.set(Math.abs(Dc.y)<.9?0:1,+(Math.abs(Dc.y)<.9),0),Oc.addScaledVector(Dc,-Oc.dot(Dc))),Oc.normalize(),kc.crossVectors(Dc,Oc),c===0&&s(0,0,-1),c===t-1&&s(c,t+1,1);for(let t=0;t<r;t++){let s=2*Math.PI*t/r,[l,u]=[Math.cos(s),Math.sin(s)],d=3*(o+(c+1)*r+t);for(let t=0;t<3;t++){let r=l*Oc.getComponent(t)+u*kc.getComponent(t);a[d+t]=r,i[d+t]=e[3*c+t]+n*r}}}}var jc={[a.LOOSE]:10146303,[a.STRANDS]:13214315,[a.GRID]:14178122,[a.TRIANGLES]:14178122,[a.HEIGHTS]:7314011},Mc=.025,Nc=.02,Pc=2e3,Fc=4096,Ic=3,Lc=8,Rc=2;function zc(e,t){let n=e!==a.LOOSE&&e!==a.STRANDS;return new Ze({color:t??jc[e]??16777215,roughness:.8,side:n?2:0,shadowSide:n?2:null})}function Bc(e,t){let n=new H(e.geometry,t);return n.castShadow=n.receiveShadow=!0,n.frustumCulled=!1,n}var Vc=class{object=new pe;instances;look;radius;constructor({description:e}){this.look=zc(a.LOOSE,e.color),this.radius=e.radius||Mc}update({count:e,positions:t}){let n=this.reserve(e);n.count=e;let{array:r}=n.instanceMatrix;for(let n=0;n<e;n++)for(let e=0;e<3;e++)r[16*n+12+e]=t[3*n+e];n.instanceMatrix.clearUpdateRanges(),n.instanceMatrix.addUpdateRange(0,16*e),n.instanceMatrix.needsUpdate=!0}reserve(e){if(this.instances&&this.instances.instanceMatrix.count>=e)return this.instances;this.release();let t=Math.max(64,Math.ceil(1.5*e)),n=new Mt(new oe(1,e>Pc?0:1),this.look,t),{array:r}=n.instanceMatrix;r.fill(0);for(let e=0;e<t;e++)r[16*e]=r[16*e+5]=r[16*e+10]=this.radius,r[16*e+15]=1;return n.instanceMatrix.setUsage(be),n.castShadow=n.receiveShadow=!0,n.frustumCulled=!1,this.object.add(n),this.instances=n}release(){this.instances&&(this.object.remove(this.instances),this.instances.geometry.dispose(),this.instances.dispose())}dispose(){this.release(),this.look.dispose()}},Hc=class{object;surface;parts;radius;constructor({description:e,layout:t}){this.parts=t.points>Fc?1:Ic,this.radius=e.radius||Nc;let n=t.strands.map(e=>Tc((e-1)*this.parts+1));this.surface=new wc(Lc*n.reduce((e,t)=>e+t,0),Ec(n,Lc)),this.object=Bc(this.surface,zc(a.STRANDS,e.color))}update({layout:e,positions:t}){let n=0,r=0;for(let i of e.strands){let e=Yt(t,this.parts,n,i),a=e.length/3;Ac(e,a,this.radius,Lc,this.surface.positions,this.surface.normals,r),n+=i,r+=Tc(a)*Lc}this.surface.changed()}dispose(){this.surface.geometry.dispose(),this.object.material.dispose()}},Uc=class{object;surface;parts;rows;constructor({description:e,layout:t}){this.parts=t.form===a.HEIGHTS||t.points>Fc?1:Rc,this.rows=t.points/t.columns;let[n,r]=this.fine(t.columns);this.surface=new wc(n*r,Sc(n,r)),this.object=Bc(this.surface,zc(t.form,e.color))}update({layout:e,positions:t,count:n}){let r=this.parts===1?t.subarray(0,3*n):Xt(t,e.columns,this.rows,this.parts);this.surface.positions.set(r),Cc(r,...this.fine(e.columns),this.surface.normals),this.surface.changed()}fine(e){return[(e-1)*this.parts+1,(this.rows-1)*this.parts+1]}dispose(){this.surface.geometry.dispose(),this.object.material.dispose()}},Wc=class{object;surface;constructor({description:e,layout:t}){this.surface=new wc(t.points,Uint32Array.from(t.triangles)),this.object=Bc(this.surface,zc(a.TRIANGLES,e.color))}update({positions:e,count:t}){this.surface.positions.set(e.subarray(0,3*t)),this.surface.geometry.computeVertexNormals(),this.surface.changed()}dispose(){this.surface.geometry.dispose(),this.object.material.dispose()}};function Gc(e){switch(e.layout.form){case a.STRANDS:return new Hc(e);case a.GRID:case a.HEIGHTS:return new Uc(e);case a.TRIANGLES:return new Wc(e);default:return new Vc(e)}}var Kc=`points:*`,qc=class{scene;drawers=new Map;constructor(e){this.scene=e}update(e,t){let n=new Set(e.values());for(let[e,t]of this.drawers)n.has(e)||this.remove(e,t);for(let e of n){if(!e.hasPoints)continue;let n=this.drawerOf(e);n.object.visible=this.place(n.object,e.description.entity,t),n.object.visible&&n.update(e)}}get count(){return[...this.drawers.values()].filter(({object:e})=>e.visible).length}place(e,t,n){if(t===0)return!0;let r=n(t);return r?(e.position.set(r[0],r[1],r[2]),e.quaternion.set(r[3],r[4],r[5],r[6]),!0):!1}drawerOf(e){let t=this.drawers.get(e);if(t)return t;let n=Gc(e);return this.drawers.set(e,n),this.scene.add(n.object),n}remove(e,t){this.scene.remove(t.object),t.dispose(),this.drawers.delete(e)}},Jc={heightField:`height field`};function Yc(e){let t=e?.kind.case;return t===void 0?`shape`:Jc[t]??t}function Xc(e,t){if(!e)return`body ${t}`;let n=Yc(e.shapes[0]);return e.name||`${n===`sphere`?`ball`:n} ${t}`}function Zc(e,t){return[e?.name||`no name`,`id ${t.entity}`,Yc(e?.shapes[t.shape]),`${t.distance.toFixed(t.distance<10?2:1)} m away`].join(` · `)}var Qc=12,$c=new G(16765286),el=2.4,tl=new W().setFromAxisAngle(new j(1,0,0),Math.PI),nl=class{panel;take;stopControlling;line=document.createElement(`p`);keys=document.createElement(`p`);choices=document.createElement(`p`);renderedText=``;offered=``;constructor(e,t,n){this.panel=e,this.take=t,this.stopControlling=n,this.keys.className=`keys`,e.append(this.line,this.keys,this.choices)}update(e,t){let{toolSelected:n,controlled:r,keys:i,status:a,worldStatus:o,touch:s}=e;if(this.panel.hidden=!n&&!r&&o===``,this.panel.hidden)return;let c=r?`Driving ${Xc(r,r.id)}${a&&` · ${a}`}`:n?t.length>0?`${s?`Tap`:`Click`} an entity below an arrow, or choose one:`:`This world has no controllable entities`:o,l=r&&!s?`${i||`W A S D or arrows, Space, Shift, E and Q`} · gamepad · Esc releases`:``;this.renderedText!==c+l&&(this.renderedText=c+l,this.line.textContent=c,this.keys.textContent=l),this.offer(r||!n?[]:t.slice(0,Qc),r!==void 0)}offer(e,t){let n=`${t} ${e.map(({id:e})=>e).join()}`;if(this.offered===n)return;this.offered=n;let r=(e,t)=>{let n=document.createElement(`button`);return n.type=`button`,n.textContent=e,n.onclick=()=>{n.blur(),t()},n};this.choices.replaceChildren(...e.map(({id:e,name:t})=>r(t||`${e}`,()=>this.take(e))),...t?[r(`Release`,()=>this.stopControlling())]:[])}};function rl(e,t=!1){if(e.length===0)return``;let n=t?`Select Drive to control`:`Press 8 to drive`;return e.length===1?`${n} ${Xc(e[0],e[0].id)}`:`${n} one of ${e.length} entities`}var il=new j,al=new j(.28,.45,.28);function ol(e,t,n,r){let i=.15*Math.sin(r/250);for(let{id:r}of t){let t=n(r);t&&e.add(`cone`,il.set(t[0],t[1]+el+i,t[2]),tl,al,$c)}}var sl=class extends Error{status;constructor(e,t){super(e),this.status=t}},cl=class{token;send;constructor(e,t=(e,t)=>fetch(e,t)){this.token=e,this.send=t}list(){return this.call(`api/worlds`)}async create(e,t){let n={method:`POST`,headers:{"Content-Type":`application/json`},body:JSON.stringify({name:e,...t})};return(await this.call(`api/worlds`,n)).world}async delete(e){await this.call(`api/worlds/${encodeURIComponent(e)}`,{method:`DELETE`})}scene(e){return this.call(`api/worlds/${encodeURIComponent(e)}/scene`)}async call(e,t){let n=s(this.token,t?.headers),r=await this.send(e,{...t,headers:n}).catch(()=>{throw new sl(`the server does not respond`,0)}),i=await r.text(),a={};try{a=JSON.parse(i)}catch{a={message:i}}if(!r.ok)throw new sl(a.message||`the server responded with HTTP status ${r.status}`,r.status);return a}},ll=class{all=[];count=0;hidden=new Set;listeners=new Set;unread=0;isOpen=!1;add(e){if(e.kind===`message`&&this.hidden.has(e.from))return;let t={...e,number:++this.count};this.all.push(t),this.all.length>200&&this.all.shift(),!this.isOpen&&e.kind===`message`&&!e.own&&this.unread++;for(let e of this.listeners)e(t)}get lines(){return this.all.filter(e=>e.kind!==`message`||!this.hidden.has(e.from))}newestOf(e,t){return this.all.filter(t=>t.kind===`message`&&t.from===e).slice(-t)}setOpen(e){this.isOpen=e,e&&(this.unread=0),this.changed()}isHidden(e){return this.hidden.has(e)}setHidden(e,t){t?this.hidden.add(e):this.hidden.delete(e),this.changed()}clear(){this.all=[],this.hidden.clear(),this.unread=0,this.changed()}listen(e){this.listeners.add(e)}changed(){for(let e of this.listeners)e(void 0)}},ul=`cursor`,dl=100,fl=333,pl=30,ml=8,hl=3e3,gl=450,_l=2e4,vl=.01,yl=1e6,bl=4,xl=.05,Sl=.018,Cl=new j(0,1,0),wl=e=>Math.round(e*1e3)/1e3,Tl=({x:e,y:t,z:n})=>[wl(e),wl(t),wl(n)],El=e=>typeof e==`number`&&Math.abs(e)<=yl,Dl=e=>Number.isInteger(e)&&e>=0&&e<2**32;function Ol({samples:e,grab:t},n){let r=e.map(e=>[Math.round(n-e.atMs),...Tl(e)]);return new TextEncoder().encode(JSON.stringify(t?{p:r,g:[t.entity,...Tl(t.point)]}:{p:r}))}function kl(e,t){let n;try{n=JSON.parse(new TextDecoder().decode(e))}catch{return}if(typeof n!=`object`||!n||!Array.isArray(n.p)||n.p.length>ml)return;let r=[];for(let e of n.p){if(!Array.isArray(e)||e.length!==4||!e.slice(1).every(El))return;let[n,i,a,o]=e;if(typeof n!=`number`||!(n>=0&&n<=hl))return;r.push({atMs:t-n,x:i,y:a,z:o})}r.sort((e,t)=>e.atMs-t.atMs);let i=n.g;if(i===void 0)return{samples:r,grab:void 0};if(Array.isArray(i)&&i.length===4&&Dl(i[0])&&i.slice(1).every(El))return{samples:r,grab:{entity:i[0],point:{x:i[1],y:i[2],z:i[3]}}}}var Al=class{budget;send;samples=[];last;grabbed;sampledMs=-1/0;sentMs=-1/0;pausedUntilMs=-1/0;shown=!1;sent=0;constructor(e,t){this.budget=e,this.send=t}update(e,t,n,r){if(t===0||e<this.pausedUntilMs)return this.reset();n&&this.sample(e,n,r);let i=n===void 0&&this.shown;if(this.samples.length===0&&!i||e-this.sentMs<Math.max(fl,pl*t)||!this.budget.take(e,bl))return;let a=i?[]:this.samples.filter(({atMs:t})=>e-t<=hl).slice(-8),{entity:o=0,point:s=void 0}=r??{};this.send(Ol({samples:a,grab:s&&!i?{entity:o,point:s}:void 0},e)),this.sent++,this.sentMs=e,this.samples=[],this.shown=!i,i&&(this.last=void 0)}sample(e,t,n){let r=n?.entity,i=!this.last||Math.hypot(t.x-this.last.x,t.y-this.last.y,t.z-this.last.z)>vl;e-this.sampledMs<dl||!i&&r===this.grabbed||(this.last={x:t.x,y:t.y,z:t.z},this.grabbed=r,this.sampledMs=e,this.samples.push({atMs:e,...this.last}))}reset(){this.samples=[],this.last=void 0,this.shown=!1}pause(e){this.pausedUntilMs=e}resend(){this.last=void 0}},jl=class{samples=[];grab;add({samples:e,grab:t}){e.length===0&&(this.samples=[]);let n=this.samples.at(-1)?.atMs??-1/0;this.samples.push(...e.filter(({atMs:e})=>e>n)),this.samples=this.samples.slice(-16),this.grab=t}position(e){let t=e-gl,{samples:n}=this,r=n.at(-1);if(!r||e-r.atMs>_l)return;let i=n.findIndex(e=>e.atMs>t);if(i<0)return r;let a=n[i],o=n[i-1]??a,s=a.atMs>o.atMs?Math.min(1,Math.max(0,(t-o.atMs)/(a.atMs-o.atMs))):1;return{x:o.x+s*(a.x-o.x),y:o.y+s*(a.y-o.y),z:o.z+s*(a.z-o.z)}}},Ml=new j,Nl=new j,Pl=new W,Fl=new j,Il=new G,Ll=class{cursors=new Map;receive(e,t,n){let r=kl(t,n);if(!r)return;let i=this.cursors.get(e)??new jl;this.cursors.set(e,i),i.add(r)}remove(e){this.cursors.delete(e)}clear(){this.cursors.clear()}shown(e){let t=[];for(let[n,r]of this.cursors){let i=r.position(e);i&&t.push({client:n,position:i,grab:r.grab})}return t}};function Rl(e,t,n,r,i){let a=Math.max(.2,i/10);if(Nl.set(t.position.x,t.position.y,t.position.z),e.add(`sphere`,Nl,Pl.identity(),Fl.setScalar(xl*a),Il.set(n)),!t.grab)return;let{entity:o,point:s}=t.grab,c=r(o);if(o!==0&&!c)return;Ml.set(s.x,s.y,s.z),c&&(Ml.applyQuaternion(Pl.set(c[3],c[4],c[5],c[6])),Ml.set(Ml.x+c[0],Ml.y+c[1],Ml.z+c[2]));let l=Sl*a;e.add(`sphere`,Ml,Pl.identity(),Fl.setScalar(2.2*l),Il),Nl.sub(Ml);let u=Nl.length();u<.001||(Pl.setFromUnitVectors(Cl,Nl.divideScalar(u)),e.add(`cylinder`,Ml.addScaledVector(Nl,u/2),Pl,Fl.set(l,u/2,l),Il))}var zl=9e3,Bl=4;function Vl(e,t){let n=document.createElement(t);if(n.className=e.kind,e.kind===`message`){let t=document.createElement(`bdi`);t.className=`name`,t.textContent=e.name,t.style.setProperty(`--player`,Rt(e.color)),n.append(t,` `)}let r=document.createElement(`span`);if(r.dir=`auto`,r.className=`text`,r.textContent=e.text,n.append(r),e.refused){let t=document.createElement(`small`);t.textContent=`Not sent: ${e.refused}`,n.classList.add(`refused`),n.append(t)}return n}var Hl=class{element;constructor(e,t){this.element=e,e.setAttribute(`role`,`log`),e.setAttribute(`aria-live`,`polite`),e.setAttribute(`aria-label`,`New messages`),t.listen(n=>{t.isOpen?e.replaceChildren():n&&this.add(n)})}add(e){let t=Vl(e,`p`);for(this.element.append(t);this.element.childElementCount>Bl;)this.element.firstElementChild.remove();setTimeout(()=>t.remove(),zl)}},Ul=10,Wl=class{tokens=Ul;atMs;closedUntilMs=-1/0;take(e,t){return this.tokens=Math.min(Ul,this.tokens+(e-(this.atMs??e))/1e3*5),this.atMs=e,e<this.closedUntilMs||this.tokens<1+t?!1:(this.tokens--,!0)}close(e,t){this.closedUntilMs=e+t,this.tokens=Math.min(this.tokens,1)}},Gl=40,Kl=4,ql=class{layer;shown=new Map;constructor(e){this.layer=e}update(e){let t=e.slice(0,Gl),n=new Set(t.map(({client:e})=>e));for(let[e,{element:t}]of this.shown)n.has(e)||(t.remove(),this.shown.delete(e));for(let e of t)this.place(e)}place({client:e,name:t,color:n,x:r,y:i}){let a=this.shown.get(e);if(!a){let t=document.createElement(`span`),n=document.createElement(`bdi`);t.append(n),a={element:t,label:n,name:``,color:-1},this.layer.append(t),this.shown.set(e,a)}a.name!==t&&(a.label.textContent=a.name=t),a.color!==n&&a.element.style.setProperty(`--player`,Rt(a.color=n));let o=a.element.offsetWidth/2+Kl,s=Math.min(Math.max(r,o),innerWidth-o);a.element.style.transform=`translate(${s.toFixed(1)}px, ${i.toFixed(1)}px) translate(-50%, -100%)`}},Jl={follow:`Follow`,hide:`Mute for me`,show:`Unmute for me`,report:`Report …`,vote:`Vote to kick`,mute:`Mute for all, 5 minutes`,unmute:`End the mute for all`,clean_up:`Delete bodies`,kick:`Kick`,ban:`Ban …`,player:`Make player`,builder:`Make builder`,owner:`Make owner …`},Yl={[i.SPECTATOR]:`spectator`,[i.PLAYER]:`player`,[i.BUILDER]:`builder`,[i.OWNER]:`owner`},Xl={vote:`vote`,mute:`mute`,unmute:`mute`,clean_up:`clean_up`,kick:`kick`,ban:`ban`,player:`set_role`,builder:`set_role`,owner:`set_role`};function Zl({rules:e,ownRole:t,role:n,hidden:r}){let a=[`follow`,r?`show`:`hide`,`report`].map(e=>({action:e,refusal:``}));if(!e.room)return a;let o=t>n,s=[`vote`];o&&s.push(`mute`,`unmute`,`clean_up`,`kick`,`ban`),o&&n===i.BUILDER&&s.push(`player`),o&&n<i.BUILDER&&t>i.BUILDER&&s.push(`builder`),o&&t===i.OWNER&&s.push(`owner`);for(let t of s){let n=Xl[t],r=e.refusal(n,n===`clean_up`?`other`:void 0);(r===``||e.isReplaced(n))&&a.push({action:t,refusal:r})}return a}var Ql=`jostle-join-code:`;function $l(e,t){let n=new URLSearchParams(e);return n.set(`world`,t),`?${n.toString()}`}function eu({origin:e,pathname:t},n,r=``){let i=`${e}${t}?${new URLSearchParams({world:n}).toString()}`;return r?`${i}#${new URLSearchParams({code:r}).toString()}`:i}function tu(e){return e===`localhost`||e.endsWith(`.localhost`)||/^127\./.test(e)||e===`[::1]`}var nu=class{store;constructor(e){this.store=e}get(e){try{return this.store.getItem(Ql+e)??``}catch{return``}}set(e,t){try{this.store.setItem(Ql+e,t)}catch{}}};function ru(e){let t=new URLSearchParams(e.hash.replace(/^#/,``)),n=t.get(`code`);return n===null?``:(t.delete(`code`),e.replaceHash(t.toString()),n)}var iu=[`chat`,ul,`report`],au=`color`,ou=`controls`,su=300,cu=[[`For 1 hour`,3600],[`For 24 hours`,86400],[`Until it is removed`,0]],lu=16,uu=1e4,du=5e3,fu=.35,pu=12,mu=[`Spam`,`Insults`,`Disruptive play`,`Offensive name`],hu=(e,t,n,r=null)=>{let i=document.createElement(e);return i.id=t,n.insertBefore(i,r),i},gu=class{options;log=new ll;joinCodes=new nu(sessionStorage);identity=Pt(localStorage);budget=new Wl;cursors=new Ll;sender=new Al(this.budget,e=>{this.cursorInputs.push(this.sendMessage(ul,e)),this.cursorInputs.length>lu&&this.cursorInputs.shift()});cursorInputs=[];tags;chip;chipText=document.createElement(`span`);outgoing=[];awaiting=new Map;shownCursors=[];hovered;following=0;followedTo;controls=0;worldId=``;world=``;playersPanel;lastNames=new Map;announces=!1;replacesAddress=!0;constructor(e){this.options=e;let t=document.querySelector(`main`),n=document.getElementById(`bottom`),r=hu(`div`,`tags`,t);r.setAttribute(`aria-hidden`,`true`),this.tags=new ql(r),new Hl(hu(`div`,`feed`,n,n.firstElementChild),this.log),this.chip=hu(`section`,`following`,n,document.getElementById(`driver`)),this.chip.setAttribute(`aria-label`,`Followed player`),this.chip.hidden=!0;let i=document.createElement(`button`);i.type=`button`,i.textContent=`Stop`,i.onclick=()=>this.stopFollowing(),this.chip.append(this.chipText,i),this.log.listen(()=>this.showCounts()),addEventListener(`popstate`,()=>{let e=new URLSearchParams(location.search).get(`world`)??``;e!==this.world&&(this.replacesAddress=!0,this.options.join(e,this.joinCodes.get(e)))}),addEventListener(`pagehide`,()=>this.connection.stop()),addEventListener(`pageshow`,({persisted:e})=>{e&&this.options.join(this.world,this.joinCodes.get(this.world))});let{visualViewport:a}=window;a?.addEventListener(`resize`,()=>document.documentElement.style.setProperty(`--keyboard`,`${Math.max(0,Math.round(innerHeight-a.height))}px`))}get connection(){return this.options.connection()}get client(){return this.connection.welcome?.clientId??0}get data(){return this.connection.data}get connectionOptions(){return{name:this.identity.name,color:this.identity.color,players:!0,attributes:!0,room:!0,topics:iu}}initialJoinCode(e){let t=ru({hash:location.hash,replaceHash:e=>history.replaceState(null,``,location.pathname+location.search+(e&&`#${e}`))});return t&&this.joinCodes.set(e,t),this.joinCodes.get(e)}playing(){let{welcome:e}=this.connection;e&&!this.options.isRecorded()&&(e.worldId!==this.worldId&&this.enterWorld(e.worldId,e.worldName||e.worldId),this.announces=!1,this.outgoing.push(...this.awaiting.values()),this.awaiting.clear(),this.controls=0,this.cursorInputs.length=0,this.sender.resend())}enterWorld(e,t){this.worldId=e,this.world=t,this.log.clear(),this.cursors.clear(),this.lastNames.clear(),this.outgoing=[],this.awaiting.clear(),this.stopFollowing();let n=location.pathname+$l(location.search,t);new URLSearchParams(location.search).get(`world`)!==t&&history[this.replacesAddress?`replaceState`:`pushState`](null,``,n),this.replacesAddress=!1,document.title=`${t} – Jostle`}showRoomTitle(){let e=zt(this.data.room?.settings?.title??``,64)||this.world;e&&document.title!==`${e} – Jostle`&&(document.title=`${e} – Jostle`)}dataChanged(){this.playersPanel?.invalidate(),this.showCounts(),this.showRoomTitle(),this.lastNames.clear();for(let e of this.data.players.values())this.lastNames.set(e.client,this.nameOf(e));this.data.players.has(this.client)&&(this.announces=!0)}playerEvent({kind:e,player:t}){if(!t||t.client===this.client||this.options.isRecorded())return;let n=this.nameOf(t);switch(e){case g.JOINED:return this.sender.resend(),this.notice(`${n} joined`);case g.LEFT:return this.cursors.remove(t.client),this.following===t.client&&this.stopFollowing(),this.notice(`${n} left`);case g.DISCONNECTED:return this.cursors.remove(t.client),this.notice(`${n} lost the connection`);case g.RESUMED:return this.notice(`${n} is back`);case g.RENAMED:return this.notice(`${this.lastNames.get(t.client)??`A player`} is now ${n}`)}}message({from:e,topic:t,data:n,direct:r}){if(this.options.isRecorded())return;if(t===`cursor`){e!==this.client&&e!==0&&this.cursors.receive(e,n,performance.now());return}let i=Bt(n);if(!i)return;if(t===`report`)return r?this.receiveReport(e,i):void 0;if(t!==`chat`)return;let a=this.data.players.get(e),o=e===0?`Server`:a?this.nameOf(a):`A player that left`;this.log.add({kind:`message`,from:e,name:o,color:this.colorOf(e,a),text:i,own:e===this.client,timeMs:Date.now()})}rejected(e){let t=this.awaiting.get(e.sequence),n=performance.now(),r=e.code===c.LIMIT&&e.retryAfterMs<=du,i=this.cursorInputs.includes(e.sequence);return(t||i)&&r?this.budget.close(n,e.retryAfterMs||1e3):i&&this.sender.pause(n+uu),t?(this.awaiting.delete(e.sequence),r&&n<t.untilMs?this.outgoing.unshift(t):this.addRefused(t.text,e.message),!0):i}addRefused(e,t){let{name:n,color:r}=this.identity;this.log.add({kind:`message`,from:this.client,name:n,color:r,text:e,own:!0,timeMs:Date.now(),refused:t})}nameOfClient(e){let t=this.data.players.get(e);return t?this.nameOf(t):`Player ${e}`}nameOf(e){return Vt(e.name)||`Player ${e.client}`}colorOf(e,t=this.data.players.get(e)){let n=Number(this.data.value({kind:`player`,id:e},au)??-1);return Ft(n)?n:Ft(t?.color)?t.color:It[e%It.length]}get others(){return[...this.data.players.values()].filter(({client:e,disconnected:t})=>e!==this.client&&!t).length}listed(){return[...this.data.players.values()].map(e=>({client:e.client,name:this.nameOf(e),color:this.colorOf(e.client,e),role:e.role,pingMs:e.pingMs,disconnected:e.disconnected,own:e.client===this.client,hidden:this.log.isHidden(e.client),followed:e.client===this.following}))}saveIdentity(e){let t=e.color!==this.identity.color;this.identity=e,Lt(localStorage,e),this.connection.setIdentity(e.name,e.color),t&&this.setAttribute(au,e.color)}setAttribute(e,t){let n={key:e,value:e!==au&&t===0?{case:void 0}:{case:`integer`,value:BigInt(t)}};this.send({case:`setAttributes`,value:{set:{target:{case:`player`,value:this.client},attributes:[n]}}})}send(e){return this.options.isRecorded()?0:this.connection.send({kind:e})}sendMessage(e,t,n=[],r=!1){return this.send({case:`sendMessage`,value:{topic:e,data:t,to:n,toServer:r}})}notice(e){this.announces&&this.log.add({kind:`notice`,from:0,name:``,color:0,text:e,own:!1,timeMs:Date.now()})}confirm(e){this.log.add({kind:`notice`,from:0,name:``,color:0,text:e,own:!1,timeMs:Date.now()})}say(e){let t=zt(e,300);if(t){if(this.connection.state!==`playing`)return this.addRefused(t,`you are not connected`);this.outgoing.push({text:t,untilMs:performance.now()+du}),this.sendChat(performance.now())}}sendChat(e){for(;this.outgoing.length>0&&this.connection.state===`playing`&&this.budget.take(e,0);){let e=this.outgoing.shift(),t=this.sendMessage(`chat`,new TextEncoder().encode(e.text));this.awaiting.set(t,e),this.awaiting.size>64&&this.awaiting.delete(this.awaiting.keys().next().value)}}report(e,t){let n=this.data.players.get(e);if(!n)return;let r=this.log.newestOf(e,3).map(({text:e})=>zt(e,100)),a=new TextEncoder().encode(JSON.stringify({client:e,name:this.nameOf(n),reason:t,messages:r}));this.sendMessage(`report`,a,[],!0);let o=[...this.data.players.values()].filter(({client:t,role:n,disconnected:r})=>n>=i.BUILDER&&t!==e&&t!==this.client&&!r);o.length>0&&this.sendMessage(`report`,a,o.slice(0,16).map(({client:e})=>e));let s=o.length>0?`the server and the moderators in this world`:`the server`;this.confirm(`You reported ${this.nameOf(n)} to ${s}`)}receiveReport(e,t){try{let{client:n,reason:r}=JSON.parse(t),i=this.data.players.get(Number(n)),a=this.data.players.get(e);if(!i||!a||typeof r!=`string`)return;this.confirm(`${this.nameOf(a)} reports ${this.nameOf(i)}: ${zt(r,60)}`)}catch{}}openMenu(e,t){let n=this.data.players.get(e);if(!n)return this.options.showProblem(`this player left`);let{left:r,bottom:a}=t.getBoundingClientRect(),o=this.log.isHidden(e),s=this.data.players.get(this.client)?.role??i.SPECTATOR,c=Zl({rules:this.options.rules(),ownRole:s,role:n.role,hidden:o}).map(({action:e,refusal:t})=>({label:Jl[e],refusal:t,run:()=>this.act(e,n,r,a)}));this.options.contextMenu.open(this.nameOf(n),c,r,a+4)}act(e,t,n,r){let{client:a}=t,o=this.nameOf(t),s=(e,t)=>this.options.contextMenu.open(e,[...t,{label:`Cancel`,run:()=>{}}],n,r+4);switch(e){case`follow`:return this.follow(a);case`hide`:case`show`:return this.log.setHidden(a,e===`hide`),this.playersPanel?.invalidate(),this.confirm(e===`hide`?`You no longer see messages of ${o}`:`You see messages of ${o} again`);case`report`:return s(`Report ${o}`,mu.map(e=>({label:e,run:()=>this.report(a,e)})));case`vote`:return this.room_({case:`voteKick`,value:{client:a}});case`mute`:return this.room_({case:`mute`,value:{client:a,seconds:su}});case`unmute`:return this.room_({case:`mute`,value:{client:a,seconds:0}});case`clean_up`:return this.room_({case:`cleanUp`,value:{client:a}});case`kick`:return this.room_({case:`kick`,value:{client:a,reason:``}});case`ban`:return s(`Ban ${o}`,cu.map(([e,t])=>({label:e,run:()=>this.room_({case:`ban`,value:{client:a,seconds:t,reason:``}})})));case`player`:return this.room_({case:`setRole`,value:{client:a,role:i.PLAYER}});case`builder`:return this.room_({case:`setRole`,value:{client:a,role:i.BUILDER}});case`owner`:return s(`${o} becomes the owner`,[{label:`Transfer the room`,run:()=>this.room_({case:`setRole`,value:{client:a,role:i.OWNER}})}])}}room_(e){this.send({case:`room`,value:{kind:e}})}follow(e){this.data.players.get(e)&&e!==this.client&&(this.following=e,this.followedTo=void 0,this.chip.hidden=!1,this.playersPanel?.invalidate())}stopFollowing(){return this.following!==0&&(this.following=0,this.chip.hidden=!0,this.playersPanel?.invalidate(),!0)}get followed(){return this.following}anchorOf(e){let t=Number(this.data.value({kind:`player`,id:e},ou)??0),n=t>0?this.options.view.poseOf(t):void 0;if(n)return new j(n[0],n[1],n[2]);let r=this.shownCursors.find(t=>t.client===e);return r&&new j(r.position.x,r.position.y,r.position.z)}updateFollowing(e){if(this.following===0)return;let t=this.data.players.get(this.following);if(!t||this.options.controlled()!==0)return void this.stopFollowing();let n=this.anchorOf(this.following),r=n?`Following ${this.nameOf(t)}`:`Waiting until ${this.nameOf(t)} moves`;if(this.chipText.textContent!==r&&(this.chipText.textContent=r),!n)return;let{camera:i}=this.options;this.followedTo||(this.followedTo=i.controls.target.clone(),i.startApproach(pu)),this.followedTo.lerp(n,1-Math.exp(-6*e)),i.follow(this.followedTo.toArray(),void 0,e)}hover(e){this.hovered=e&&{x:e.x,y:e.y,z:e.z}}update(e){let t=performance.now();if(this.options.isRecorded())return this.shownCursors=[],this.tags.update([]);if(this.connection.state===`playing`){let e=this.options.grab();this.sendChat(t),this.sender.update(t,this.others,e?.target??this.hovered,e);let n=this.options.controlled();n!==this.controls&&this.setAttribute(ou,this.controls=n)}this.shownCursors=this.cursors.shown(t).filter(({client:e})=>this.data.players.has(e)&&!this.log.isHidden(e)),this.updateFollowing(e),this.tags.update(this.tagsToShow())}draw(e,t){for(let n of this.shownCursors)Rl(e,n,this.colorOf(n.client),t,this.options.camera.distance)}tagsToShow(){let e=[],{camera:t}=this.options.camera;for(let n of this.data.players.values()){if(n.client===this.client||this.log.isHidden(n.client))continue;let r=this.anchorOf(n.client);if(!r)continue;let i=Number(this.data.value({kind:`player`,id:n.client},ou)??0);r.y+=i>0?this.heightOf(i):fu*Math.max(.2,this.options.camera.distance/10);let{x:a,y:o,z:s}=r.project(t);s>1||Math.abs(a)>1||Math.abs(o)>1||e.push({client:n.client,name:this.nameOf(n),color:this.colorOf(n.client,n),x:(a+1)/2*innerWidth,y:(1-o)/2*innerHeight,depth:s})}return e.sort((e,t)=>e.depth-t.depth)}heightOf(e){let t=this.options.view.boxOf(e);return t.isEmpty()?1:(t.max.y-t.min.y)/2+.3}registerPanels(){let{panels:e}=this.options;e.register({id:`players`,title:`Players`,hint:`Names, roles and latency; follow, mute and report`,key:`p`,icon:`players`,side:`right`,load:async t=>{let n=await K(()=>import(`./players_panel-Bk36jZnu.js`),__vite__mapDeps([10,11,12]),import.meta.url);return this.playersPanel=new n.PlayersPanel(t,()=>this.listed(),()=>this.data.room!==void 0,(e,t)=>this.openMenu(e,t),()=>e.open(`identity`)),this.playersPanel}}),e.register({id:`chat`,title:`Chat`,hint:`Messages to everybody in this world`,key:`c`,icon:`chat`,side:`left`,load:async e=>{let{chatPanel:t}=await K(async()=>{let{chatPanel:e}=await import(`./chat_panel-2i77UGWq.js`);return{chatPanel:e}},[],import.meta.url);return t(e,{log:this.log,send:e=>this.say(e),leave:()=>document.getElementById(`view`).focus(),openMenu:(e,t)=>this.openMenu(e,t)})}}),e.register({id:`share`,title:`Invite`,hint:`Link and QR code of this world`,key:`i`,icon:`share`,side:`left`,load:async e=>{let{sharePanel:t}=await K(async()=>{let{sharePanel:e}=await import(`./share_panel-DwZuCKmc.js`);return{sharePanel:e}},[],import.meta.url),n=()=>this.joinCodes.get(this.world);return t(e,{link:e=>eu(location,this.world,e?n():``),joinCode:n,title:()=>document.title})}}),e.register({id:`identity`,title:`Your name`,hint:`Name and color that the others see`,key:`n`,icon:`edit`,side:`left`,load:async t=>{let{identityPanel:n}=await K(async()=>{let{identityPanel:e}=await import(`./identity_panel-DFD26-B2.js`);return{identityPanel:e}},__vite__mapDeps([13,11,12]),import.meta.url);return n(t,()=>this.identity,e=>this.saveIdentity(e),()=>e.close(`identity`))}})}askForName(){this.identity.chosen||this.options.panels.open(`identity`)}showCounts(){this.badge(`players`,this.data.players.size>1?this.data.players.size:0,`players`),this.badge(`chat`,this.log.unread,`unread`)}badge(e,t,n){for(let r of document.querySelectorAll(`#panel-buttons [aria-controls=${e}]`)){let i=e===`chat`?`Chat`:`Players`;r.setAttribute(`aria-label`,t>0?`${i}, ${t} ${n}`:i),t>0?r.dataset.count=t>99?`99+`:String(t):delete r.dataset.count}}inspect(){let{world:e,shownCursors:t,following:n,identity:r}=this;return{world:e,following:n,identity:r,cursorMessagesSent:this.sender.sent,cursors:t.map(({client:e,position:t,grab:n})=>({client:e,position:t,grab:n?.entity})),lines:this.log.lines.map(({kind:e,name:t,text:n,refused:r})=>({kind:e,name:t,text:n,refused:r}))}}},_u=[`spectator`,`player`,`builder`,`owner`],vu=[`none`,`own`,`unowned`,`any`],yu={spawn:[`Spawn bodies`,`none any any any`],drag:[`Drag`,`none unowned any any`],push:[`Push`,`none unowned any any`],explode:[`Explode`,`none any any any`],delete:[`Delete`,`none own unowned any`],joints:[`Joints and cuts`,`none unowned any any`],control:[`Drive`,`none any any any`],edit:[`Edit and freeze`,`none own unowned any`],clone:[`Clone`,`none unowned any any`],message:[`Chat`,`any any any any`],vote:[`Vote`,`none any any any`],clean_up:[`Delete all bodies of a player`,`none own own any`],mute:[`Mute`,`none none any any`],kick:[`Kick`,`none none none any`],ban:[`Ban`,`none none none any`],set_role:[`Give roles`,`none none none any`],protect:[`Protect areas`,`none none any any`],pause:[`Pause and step`,`none none any any`],speed:[`Slow motion`,`none none any any`],rewind:[`Rewind`,`none none none any`],reset:[`Reset`,`none none none any`],settings:[`Change settings`,`none none none any`]},bu=Object.keys(yu),xu={none:[],own:[`self`],unowned:[`self`,`scene`],any:[`self`,`scene`,`other`]},Su={self:`an entity of its own`,scene:`an entity of the scene`,other:`an entity of another client`},Cu=[`pause`,`speed`,`rewind`,`reset`,`vote`,`mute`,`kick`,`ban`,`set_role`,`protect`,`clean_up`,`settings`],wu=[`edit`,`delete`];function Tu(e,t){return yu[t][1].split(` `)[_u.indexOf(e)]}function Eu(e){return e===i.UNSPECIFIED?`player`:_u[e-i.SPECTATOR]??`spectator`}var Du=class{room;role;constructor(e,t){this.room=e,this.role=Eu(t)}reach(e){let t=this.room?.settings?.permissions[`${this.role}.${e}`];return vu.find(e=>e===t)??Tu(this.role,e)}refusal(e,t){let{role:n}=this;if(!this.room)return Cu.includes(e)?`The world is no room: only administrators of the server may do this.`:wu.includes(e)&&t!==void 0&&t!==`self`?`The world is no room: you can change only bodies that you own.`:n===`spectator`&&e!==`message`?`Spectators only watch.`:``;let r=this.reach(e);return r===`none`?`room.permissions: ${n}.${e} is none; the role ${n} may not ${e}`:t===void 0||xu[r].includes(t)?``:`room.permissions: ${n}.${e} is ${r}; the role ${n} may not ${e} ${Su[t]}`}may(e,t){return this.refusal(e,t)===``}isReplaced(e){return this.room!==void 0&&this.reach(e)!==Tu(this.role,e)}},Ou=new G(16752478),ku=class{options;current=new Du(void 0,i.UNSPECIFIED);listeners=[];lines=_c.lines(.9);panel;drawn=``;constructor(e){this.options=e,e.scene.add(this.lines.object)}get rules(){return this.current}onChange(e){this.listeners.push(e),e(this.current)}ownerOf(e){let{entities:t,welcome:n}=this.options.connection,r=t.get(e)?.owner??0;return r===0?`scene`:r===n?.clientId?`self`:`other`}send(e){return this.options.connection.send({kind:{case:`room`,value:{kind:e}}})}onDataChanged(){let{data:e,welcome:t}=this.options.connection,n=e.players.get(t?.clientId??0)?.role??i.UNSPECIFIED,r=new Du(e.room,n),a=r.room!==this.current.room||r.role!==this.current.role;if(this.current=r,a)for(let e of this.listeners)e(r);this.panel?.show()}rejected(e){return this.panel?.rejected(e)??!1}register(){this.options.panels.register({id:`room`,title:`Room`,hint:`Settings, permissions, protected areas and bans of this room`,key:`r`,icon:`room`,side:`left`,compact:!0,load:async e=>{let{RoomPanel:t}=await K(async()=>{let{RoomPanel:e}=await import(`./room_panel-DS5cqr15.js`);return{RoomPanel:e}},__vite__mapDeps([14,15,12,16,17,18]),import.meta.url),{connection:n,nameOf:r,selectedBox:i,cameraTarget:a}=this.options,o=()=>[...n.data.players.keys()].filter(e=>e!==n.welcome?.clientId);return this.panel=new t(e,{rules:()=>this.current,send:e=>this.send(e),nameOf:r,clients:o,selectedBox:i,cameraTarget:a}),this.panel.show(),{opened:()=>this.panel?.show()}}})}update(){let e=this.options.panels.isOpen(`room`)&&this.current.room?.settings?.areas||[],t=JSON.stringify(e.map(({min:e,max:t})=>[e,t]));if(t!==this.drawn){this.drawn=t,this.lines.begin();for(let{min:t,max:n}of e)t&&n&&Au(this.lines,t,n);this.lines.end()}}get areaVertexCount(){return this.lines.count}};function Au(e,t,n){let r=e=>[e&1?n.x:t.x,e&2?n.y:t.y,e&4?n.z:t.z];for(let t=0;t<8;t++)for(let n of[1,2,4])if(!(t&n))for(let i of[t,t|n])e.vertex(...r(i),Ou)}var ju=.95,Mu=`by `,Nu=5e3,Pu=e=>{let t=e.charAt(0).toUpperCase()+e.slice(1);return/[.!?…]$/.test(t)?t:`${t}.`};function Fu(e,t,n){return n?t>0&&t<100?Math.min(1,e/(t/100)):e:1}function Iu({connection:e,reason:t,hasPlayed:n,stats:r,mayResume:i,reconnected:a}){if(e===`stopped`)return t?{kind:`stopped`,text:Pu(t),advice:`Choose a world to join.`,action:`worlds`}:void 0;if(e===`waiting`)return{kind:`disconnected`,text:Pu(t||`the connection was lost`),advice:`The viewer tries again automatically. Check your network if this takes longer.`,action:`reconnect`};if(e===`connecting`)return n?{kind:`disconnected`,text:`Reconnecting …`,advice:`The world is shown as it was when the connection was lost.`}:void 0;if(r?.paused.startsWith(Mu))return{kind:`paused`,text:Pu(`This world is paused ${r.paused}`),advice:`Members who may pause it can resume and step it in the panel Time.`};if(r?.paused){let e=`This world is paused: ${r.paused}`;return i?{kind:`paused`,text:Pu(e),advice:`Resume it when the cause is fixed.`,action:`resume`}:{kind:`paused`,text:Pu(e),advice:`An operator can resume it. You can join another world meanwhile.`,action:`worlds`}}if(r&&r.timeScale>0&&r.timeScale<ju)return{kind:`slow`,text:`The server is overloaded: this world runs at ${Math.round(100*r.timeScale)} % of its speed.`,advice:`Delete bodies that you spawned, or join another world.`,action:`worlds`};if(a===`session`)return{kind:`resumed`,text:`Connected again.`,advice:`Your session and your bodies were resumed.`};if(a===`new client`)return{kind:`resumed`,text:`Connected again as a new client.`,advice:`The session had expired: take control of your entity again.`}}var Lu={resume:`Resume`,reconnect:`Reconnect now`,worlds:`Worlds`},Ru=class{options;text=document.createElement(`strong`);advice=document.createElement(`span`);button=document.createElement(`button`);status={connection:`stopped`,reason:``,hasPlayed:!1,stats:void 0,mayResume:!1,reconnected:void 0};asked=``;speedPercent;speedChangedMs=-1/0;shown;constructor(e){this.options=e,this.button.type=`button`,this.button.onclick=()=>this.act();let t=document.createElement(`div`);t.append(this.text,` `,this.advice),e.element.append(t,this.button),e.element.hidden=!0}setConnection(e,t){this.update({connection:e,reason:t,stats:e===`playing`?this.status.stats:void 0})}setReconnected(e){this.update({reconnected:e}),setTimeout(()=>this.update({reconnected:void 0}),Nu)}begin(){this.update({hasPlayed:!1,reconnected:void 0,stats:void 0})}setPlayed(){this.update({hasPlayed:!0})}setStats(e){if(e?.paused?this.asked!==this.options.world()&&(this.asked=this.options.world(),this.request(`GET`).then(e=>this.update({mayResume:e}))):this.asked=``,!e)return this.update({stats:e});let{paused:t,timeScale:n,speedPercent:r}=e,i=performance.now();this.speedPercent!==void 0&&r!==this.speedPercent&&(this.speedChangedMs=i),this.speedPercent=r,this.update({stats:{paused:t,timeScale:Fu(n,r,i-this.speedChangedMs>5500)}})}update(e){this.status={...this.status,...e};let t=Iu(this.status);if(t?.text===this.shown?.text&&t?.advice===this.shown?.advice&&t?.action===this.shown?.action)return;this.shown=t;let{element:n}=this.options;n.hidden=t===void 0,t&&(n.dataset.kind=t.kind,this.text.textContent=t.text,this.advice.textContent=t.advice,this.button.hidden=t.action===void 0,this.button.textContent=t.action?Lu[t.action]:``),this.options.onChange()}act(){switch(this.shown?.action){case`resume`:this.resume();return;case`reconnect`:return this.options.reconnect();case`worlds`:return this.options.openWorlds()}}async resume(){await this.request(`POST`)||this.options.showMessage(`the server did not resume the world`)}async request(e){let t=`api/worlds/${encodeURIComponent(this.options.world())}/resume`;return(await fetch(t,{method:e,headers:s(this.options.token)}).catch(()=>void 0))?.ok??!1}},zu=[.1,.25,.5,1,2,4],Bu=class{panel;button=document.createElement(`button`);slider=document.createElement(`input`);readout=document.createElement(`output`);speed=document.createElement(`select`);stream;constructor(e){this.panel=e,this.button.type=`button`,this.button.onclick=()=>this.toggle(),Object.assign(this.slider,{type:`range`,min:`0`,step:`0.01`}),this.slider.setAttribute(`aria-label`,`Playback time`),this.slider.oninput=()=>this.stream?.seek(Number(this.slider.value)),this.speed.setAttribute(`aria-label`,`Playback speed`);for(let e of zu)this.speed.add(new Option(`${e} ×`,String(e),e===1,e===1));this.speed.onchange=()=>{this.stream&&(this.stream.speed=Number(this.speed.value))},e.append(this.button,this.slider,this.readout,this.speed)}show(e){this.stream=e,this.panel.hidden=e===void 0,e&&(this.slider.max=String(e.length),this.speed.value=String(e.speed))}toggle(){this.stream&&(this.stream.playing?this.stream.playing=!1:this.stream.play())}update(){let{stream:e}=this;if(!e)return;let t=e.playing?`Pause`:`Play`;this.button.textContent!==t&&(this.button.textContent=t),this.slider.value=String(e.seconds),this.readout.textContent=`${e.seconds.toFixed(1)} / ${e.length.toFixed(1)} s · tick ${e.tick}`}},Vu=class{box;last=``;lastAt=0;constructor(e){this.box=e}show(e){let t=performance.now();if(e===this.last&&t-this.lastAt<1500)return;this.last=e,this.lastAt=t;let n=document.createElement(`p`);for(n.textContent=e,this.box.append(n);this.box.childElementCount>3;)this.box.firstElementChild.remove();setTimeout(()=>n.remove(),4e3)}},Hu=new G(16739166),Uu=new G(8176895),Wu=new G(8116367),Gu=new G(12033279),Ku=new G(16765286),qu=new G(10125895),Ju=.12,Yu=1.5,Xu=.06,Zu={$typeName:`jostle.v1.Vec3`,x:0,y:0,z:0},Qu=class{contactPoints=_c.points(7);contactLines=_c.lines(1);boundLines=_c.lines(.55);jointPoints=_c.points(6);jointLines=_c.lines(1);cellLines=_c.lines(.3);buffers=[this.contactPoints,this.contactLines,this.boundLines,this.jointPoints,this.jointLines,this.cellLines];constructor(e){for(let{object:t}of this.buffers)e.add(t)}show(e,t,n){for(let e of this.buffers)e.begin();if(t.contacts)for(let t of e.contacts)this.drawContact(t);if(t.bounds)for(let t of e.bounds)ed(this.boundLines,t,Wu);if(t.broadPhase)for(let t of e.broadPhase)ed(this.cellLines,t,Gu);if(t.joints)for(let t of e.joints)this.drawJoint(t,n);for(let e of this.buffers)e.end()}clear(){for(let e of this.buffers)e.begin(),e.end()}drawContact({point:e=Zu,normal:t=Zu,impulse:n,touching:r}){let i=r?Hu:Uu,a=$u(n);this.contactPoints.vertex(e.x,e.y,e.z,i),this.contactLines.vertex(e.x,e.y,e.z,i),this.contactLines.vertex(e.x+a*t.x,e.y+a*t.y,e.z+a*t.z,i)}drawJoint({anchorA:e=Zu,anchorB:t=Zu,entityA:n,entityB:r},i){for(let[a,o]of[[n,e],[r,t]]){this.jointPoints.vertex(o.x,o.y,o.z,Ku);let e=i(a);e&&(this.jointLines.vertex(e[0],e[1],e[2],qu),this.jointLines.vertex(o.x,o.y,o.z,qu))}this.jointLines.vertex(e.x,e.y,e.z,Ku),this.jointLines.vertex(t.x,t.y,t.z,Ku)}};function $u(e){return Math.min(Yu,Ju+Xu*Math.sqrt(Math.max(0,e)))}function ed(e,{low:t=Zu,high:n=Zu},r){for(let i of[t.y,n.y])e.vertex(t.x,i,t.z,r),e.vertex(n.x,i,t.z,r),e.vertex(n.x,i,t.z,r),e.vertex(n.x,i,n.z,r),e.vertex(n.x,i,n.z,r),e.vertex(t.x,i,n.z,r),e.vertex(t.x,i,n.z,r),e.vertex(t.x,i,t.z,r);for(let i of[t.x,n.x])for(let a of[t.z,n.z])e.vertex(i,t.y,a,r),e.vertex(i,n.y,a,r)}var td=.618034;function nd(e){let t=new Map,n=new G;for(let{entities:r}of e){let e=r.reduce((e,t)=>Math.min(e,t),1/0);if(e===1/0)continue;let i=n.setHSL(e*td%1,.62,.58).getHex();for(let e of r)t.set(e,i)}return t}var rd={ball:{label:`Ball`,hint:`Rotates in all directions about the second point`},hinge:{label:`Hinge`,hint:`Rotates about the normal of the surface at the second point`},slider:{label:`Slider`,hint:`Slides along the line between the two points`},fixed:{label:`Weld`,hint:`Keeps the two bodies together`},rod:{label:`Rod`,hint:`Keeps the distance of the two points`},rope:{label:`Rope`,hint:`Limits the distance of the two points`},spring:{label:`Spring`,hint:`Pulls the two points to their distance`}},id=()=>({kind:`ball`,motorSpeed:0,motorMax:500,frequency:2,breakForce:0}),ad=({x:e,y:t,z:n})=>({x:e,y:t,z:n}),od=({x:e,y:t,z:n,w:r})=>({x:e,y:t,z:n,w:r});function sd({point:e,pose:t}){if(!t)return e.clone();let n=new W(t[3],t[4],t[5],t[6]).normalize().conjugate();return e.clone().sub(new j(t[0],t[1],t[2])).applyQuaternion(n)}function cd(e){let t=e.lengthSq()>1e-12?e.clone().normalize():new j(0,1,0);return new W().setFromUnitVectors(new j(0,0,1),t)}function ld(e,t,n,r=!1){if(e.entity===t.entity)return;let[i,a]=t.entity===0?[t,e]:[e,t],o=t.point.clone().sub(e.point),s=o.length(),c=n.motorSpeed===0?void 0:n.motorSpeed,l=e=>({frame:{position:ad(t.point),rotation:od(cd(e))}}),u={frameA:{position:ad(sd(i))},frameB:{position:ad(sd(a))}},d=r?new j(0,0,1):t.normal,f={ball:()=>({...l(new j(0,0,1)),kind:{case:`ball`,value:{}}}),hinge:()=>({...l(d),kind:{case:`hinge`,value:{...c===void 0?{}:{motorSpeed:c,motorMaxTorque:n.motorMax}}}}),slider:()=>({...l(o),kind:{case:`slider`,value:{...c===void 0?{}:{motorSpeed:c,motorMaxForce:n.motorMax}}}}),fixed:()=>({...l(new j(0,0,1)),kind:{case:`fixed`,value:{}}}),rod:()=>({...u,kind:{case:`distance`,value:{minLength:s,maxLength:s}}}),rope:()=>({...u,kind:{case:`distance`,value:{minLength:0,maxLength:s}}}),spring:()=>({...u,kind:{case:`distance`,value:{minLength:0,maxLength:Math.max(10,4*s),restLength:s,spring:{hertz:n.frequency,dampingRatio:.2}}}})}[n.kind]();return{entityA:i.entity,entityB:a.entity,joint:{...f,collideConnected:n.kind===`rope`||n.kind===`spring`,breakForce:n.breakForce}}}var ud=class{tool;first;selected=!1;constructor(e){this.tool=e}get start(){return this.first&&this.endOf(this.first)?.point}setSelected(e){this.selected=e,this.cancel()}cancel(){let e=this.first!==void 0;return this.first=void 0,this.updateHint(),e}updateHint(){let{label:e,hint:t}=rd[this.tool.options.kind];this.selected?this.first?this.tool.onHint(`${e} from ${this.name(this.first.entity)}: choose the second point`):this.tool.onHint(`${e}: choose the first point. ${t}`):this.tool.onHint(``)}click(e){let t=this.tool.isDynamic(e.entity)?e.entity:0,n={entity:t,point:e.point,normal:e.normal,pose:t===0?void 0:this.tool.poseOf(t)},r=this.first&&this.endOf(this.first);if(!r)return this.first={entity:t,local:dd(e.point,n.pose),normal:e.normal},this.updateHint();let i=ld(r,n,this.tool.options,this.tool.isPlanar());if(!i)return this.tool.onHint(`Choose a point of a body other than ${this.name(t)}`);this.tool.send({case:`createJoint`,value:i}),this.cancel()}name(e){return e===0?`the world`:this.tool.nameOf(e)}endOf({entity:e,local:t,normal:n}){if(e===0)return{entity:e,point:t.clone(),normal:n,pose:void 0};let r=this.tool.poseOf(e);if(!r)return;let i=new W(r[3],r[4],r[5],r[6]);return{entity:e,point:t.clone().applyQuaternion(i).add(new j(r[0],r[1],r[2])),normal:n,pose:r}}};function dd(e,t){if(!t)return e.clone();let n=new W(t[3],t[4],t[5],t[6]).conjugate();return e.clone().sub(new j(t[0],t[1],t[2])).applyQuaternion(n)}var fd=.02,pd=new j,md=new W;function hd({entityB:e,form:t},n){let r=n(e);if(!r)return;let{x:i=0,y:a=0,z:o=0}=t.frameB?.position??{};return pd.set(i,a,o).applyQuaternion(md.set(r[3],r[4],r[5],r[6])),pd.set(pd.x+r[0],pd.y+r[1],pd.z+r[2])}function gd(e,t,n){let[r,i]=[fd,void 0],a=new j;for(let o of e.values()){let e=hd(o,n);if(!e)continue;let s=a.copy(e).sub(t.origin).angleTo(t.direction);s<r&&([r,i]=[s,o.id])}return i}var _d=class{send;constructor(e){this.send=e}setPaused(e){this.room({case:`pause`,value:{paused:e}})}step(e=1){this.room({case:`step`,value:{steps:e}})}setSpeed(e){this.room({case:`speed`,value:{percent:e}})}rewind(e){this.room({case:`rewind`,value:{tick:e}})}reset(){this.room({case:`reset`,value:{}})}undo(){this.send({case:`undo`,value:{}})}edit(e,t){this.send({case:`edit`,value:{...t,entity:e}})}setFrozen(e,t){this.edit(e,{frozen:t})}clone(e,t,n){this.send({case:`clone`,value:{entity:e,offset:t,jointed:n}})}setAttribute(e,t){return this.send({case:`setAttributes`,value:{set:{target:{case:`entity`,value:e},attributes:[t]}}})}delete(e){this.send({case:`delete`,value:{entity:e}})}deleteJoint(e){this.send({case:`deleteJoint`,value:{joint:e}})}room(e){this.send({case:`room`,value:{kind:e}})}},vd=class{selected;listeners=[];get current(){return this.selected}get body(){return this.selected?.kind===`body`?this.selected.id:0}onChange(e){this.listeners.push(e)}select(e){if(e?.kind!==this.selected?.kind||e?.id!==this.selected?.id){this.selected=e;for(let t of this.listeners)t(e)}}retain(e,t){let{selected:n}=this;n&&!(n.kind===`body`?e:t)(n.id)&&this.select(void 0)}},yd=new G(16765286),bd=new G(16739166),xd=new G(7327884),Sd=new G(16765286),Cd=.02,wd={min:.15,max:2.5,scale:.035},Td=.22,Ed=new j,Dd=new j,Od=new j;function kd(e){return Math.min(wd.max,wd.min+wd.scale*Math.sqrt(Math.max(0,e)))}var Ad=class{lines=_c.lines(1);points=_c.points(11);inspected;constructor(e){e.add(this.lines.object,this.points.object)}setInspected(e){this.inspected=e}update(e,t,n,r,i){this.lines.begin(),this.points.begin(),e?.kind===`body`?this.drawBody(e.id,t,r):e&&this.drawJoint(n.get(e.id),t),i&&this.points.vertex(i.x,i.y,i.z,Sd),this.lines.end(),this.points.end()}drawBody(e,t,n){let r=t.boxOf(e);r.isEmpty()||this.drawBox(r.expandByScalar(Cd));let i=this.inspected?.body;if(i?.entity===e)for(let{normal:e,points:t}of i.contacts)for(let{point:r,impulse:i}of t)!r||!e||i<=0||this.drawArrow(r,-e.x,-e.y,-e.z,i*n)}drawJoint(e,t){let n=e&&hd(e,e=>t.poseOf(e));if(e&&n){this.points.vertex(n.x,n.y,n.z,xd);for(let r of[e.entityA,e.entityB]){let e=t.poseOf(r);e&&(this.lines.vertex(n.x,n.y,n.z,xd),this.lines.vertex(e[0],e[1],e[2],xd))}}}drawArrow(e,t,n,r,i){let a=kd(i);Ed.set(t,n,r),Od.set(e.x,e.y,e.z).addScaledVector(Ed,a),this.points.vertex(e.x,e.y,e.z,bd),this.lines.vertex(e.x,e.y,e.z,bd),this.lines.vertex(Od.x,Od.y,Od.z,bd);for(let e of[Math.abs(t)<.8?Dd.set(1,0,0):Dd.set(0,1,0)]){e.cross(Ed).normalize();for(let t of[-1,1])this.lines.vertex(Od.x,Od.y,Od.z,bd),this.lines.vertex(Od.x-Td*a*(Ed.x-t*.5*e.x),Od.y-Td*a*(Ed.y-t*.5*e.y),Od.z-Td*a*(Ed.z-t*.5*e.z),bd)}}drawBox({min:e,max:t}){let n=n=>this.lines.vertex(n&1?t.x:e.x,n&2?t.y:e.y,n&4?t.z:e.z,yd);for(let e of[1,2,4])for(let t=0;t<8;t++)t&e||(n(t),n(t|e))}},jd=200,Md={x:0,y:1.5,z:0},Nd=class{options;spawnOptions=ts();jointOptions=id();selection=new vd;selectionView;commands=new _d(e=>this.options.connection.send({kind:e}));jointTool;inspectorPanel;throttle=new Go(jd,()=>this.query());timePanel;plotsPanel;inspected;constructor(e){this.options=e;let{connection:t,view:n,hint:r}=e;this.selectionView=new Ad(n.scene),this.jointTool=new ud({options:this.jointOptions,poseOf:e=>n.poseOf(e),isDynamic:e=>(t.entities.get(e)?.mass??0)>0,nameOf:e=>this.nameOf(e),isPlanar:e.isPlanar,send:e=>t.send({kind:e}),onHint:e=>{r.textContent=e,r.hidden=e===``}})}register(){this.registerPanels(),this.registerCommands(),this.selection.onChange(()=>this.setInspected(void 0))}get newestInspection(){return this.inspected}nameOf(e){return Xc(this.options.connection.entities.get(e),e)}clientName(e){let{data:t,welcome:n}=this.options.connection;return e===n?.clientId?`you`:t.players.get(e)?.name||`client ${e}`}attributeRefusal(e){let{data:t,welcome:n,entities:r}=this.options.connection,a=t.players.get(n?.clientId??0)?.role??i.SPECTATOR;return a>=i.BUILDER?``:a===i.SPECTATOR?`Spectators cannot change attributes of entities.`:r.get(e)?.owner===n?.clientId?``:`Players can change attributes of entities that they own.`}onDataChanged(){this.inspectorPanel?.showRights()}rejected(e){return this.inspectorPanel?.rejected(e)??!1}registerPanels(){let{panels:e,connection:t,view:n}=this.options;e.register({id:`inspector`,title:`Inspector`,hint:`State of the selected body or joint`,key:`o`,icon:`inspect`,side:`right`,compact:!0,load:async e=>{let{InspectorPanel:r}=await K(async()=>{let{InspectorPanel:e}=await import(`./inspector_panel-Bnu8PzVg.js`);return{InspectorPanel:e}},__vite__mapDeps([19,16,17]),import.meta.url);return this.inspectorPanel=new r(e,{connection:t,selection:this.selection,commands:this.commands,names:{ofEntity:e=>this.nameOf(e),ofClient:e=>this.clientName(e)},poseOf:e=>n.poseOf(e),focus:this.options.focus,refusal:(e,t)=>this.options.room.rules.refusal(e,this.options.room.ownerOf(t)),jointRefusal:()=>this.options.room.rules.refusal(`joints`),attributeRefusal:e=>this.attributeRefusal(e)}),{}}}),e.register({id:`plots`,title:`Plots`,hint:`Motion and forces of the selection over time`,key:`g`,icon:`plot`,side:`right`,compact:!0,load:async n=>{let{PlotsPanel:r}=await K(async()=>{let{PlotsPanel:e}=await import(`./plots_panel-CCxX14jf.js`);return{PlotsPanel:e}},__vite__mapDeps([20,15,17]),import.meta.url),i=new r(n,{connection:t,save:Pd});return this.plotsPanel=i,i.select(this.selection.current),this.selection.onChange(e=>i.select(e)),{opened:()=>e.close(`stats`),update:()=>i.update()}}}),e.register({id:`time`,title:`Time`,hint:`Pause, single step, slow motion, timeline and reset`,key:`y`,icon:`time`,side:`left`,compact:!0,load:async e=>{let{TimePanel:n}=await K(async()=>{let{TimePanel:e}=await import(`./time_panel-C-iAyApW.js`);return{TimePanel:e}},__vite__mapDeps([21,18]),import.meta.url);return this.timePanel=new n(e,{commands:this.commands,refusal:e=>this.options.room.rules.refusal(e),tickHz:()=>t.welcome?.tickHz||60}),this.timePanel.update(this.options.stats()),{}}}),e.register({id:`build`,title:`Build`,hint:`Size, mass, material and color of new bodies, and the kind of new joints`,key:`b`,icon:`build`,side:`left`,compact:!0,load:async e=>{let{BuildPanel:t}=await K(async()=>{let{BuildPanel:e}=await import(`./build_panel-BVMnwDVg.js`);return{BuildPanel:e}},[],import.meta.url);return new t(e,this.spawnOptions,this.jointOptions,()=>this.jointTool.updateHint())}})}registerCommands(){let{commands:e}=this.options,t=e=>()=>this.selection.body!==0&&e(this.selection.body);e.register({key:`k`,label:`Pause or resume the world`,run:()=>this.commands.setPaused(!this.options.stats()?.paused)}),e.register({key:`.`,label:`Simulate one step of the paused world`,run:()=>this.commands.step()}),e.register({key:`z`,label:`Undo your newest action`,run:()=>this.commands.undo()}),e.register({key:`x`,label:`Freeze or unfreeze the selected body`,run:t(e=>this.commands.setFrozen(e,!this.inspected?.body?.frozen))}),e.register({key:`v`,label:`Clone the selected body`,run:t(e=>this.commands.clone(e,Md,!1))})}get isInspecting(){let{panels:e}=this.options;return this.selection.current!==void 0&&(e.isOpen(`inspector`)||e.isOpen(`plots`))}async query(){let{current:e}=this.selection;if(!e)return;let t=await this.options.queries.inspect(e.kind===`body`?{entity:e.id}:{joint:e.id});this.selection.current===e&&this.setInspected(this.isInspecting?t:void 0)}setInspected(e){this.inspected=e,this.inspectorPanel?.show(e),this.selectionView.setInspected(e),e&&this.plotsPanel?.addInspection(e)}menuItems(e,t){let n=(this.options.connection.entities.get(e)?.mass??0)>0,r=this.selection.body===e&&(this.inspected?.body?.frozen??!1),{room:i}=this.options,[a,o]=[`edit`,`clone`].map(t=>i.rules.refusal(t,i.ownerOf(e)));return[{label:`Inspect`,run:()=>this.inspect(e)},...t&&(n||r)?[{label:r?`Unfreeze`:`Freeze`,refusal:a,run:()=>this.commands.setFrozen(e,!r)}]:[],...t&&n?[{label:`Clone`,refusal:o,run:()=>this.commands.clone(e,Md,!1)}]:[],...t&&n?[{label:`Clone with joints`,refusal:o,run:()=>this.commands.clone(e,Md,!0)}]:[]]}inspect(e){this.selection.select({kind:`body`,id:e}),this.options.panels.open(`inspector`)}inspectAt(e,t){let n=gd(this.options.connection.joints.joints,t,e=>this.options.view.poseOf(e));n===void 0?this.selection.select(e&&e.entity!==0?{kind:`body`,id:e.entity}:void 0):this.selection.select({kind:`joint`,id:n}),this.options.panels.open(`inspector`)}onStats(e){this.timePanel?.update(e),this.plotsPanel?.addStats(e)}onWorldChanged(){let{entities:e,joints:t}=this.options.connection;this.selection.retain(t=>e.has(t),e=>t.joints.has(e))}cancel(){if(this.jointTool.cancel())return!0;let e=this.selection.current!==void 0;return this.selection.select(void 0),e}update(){let{view:e,connection:t}=this.options;this.isInspecting?this.throttle.request():this.inspected&&this.setInspected(void 0),this.selectionView.update(this.selection.current,e,t.joints.joints,t.welcome?.tickHz||60,this.jointTool.start)}};function Pd(e,t){let n=URL.createObjectURL(new Blob([t],{type:`text/csv`}));Object.assign(document.createElement(`a`),{href:n,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(n),1e3)}var Fd={dark:{horizon:7176857,zenith:2570316,ground:6972507,exposure:1},light:{horizon:14477554,zenith:8302814,ground:9275260,exposure:1.15}},Id=new j(-14,28,17).normalize(),Ld=60,Rd=14,zd=224,Bd=16,Vd=512,Hd=2.2,Ud=9,Wd=70,Gd=260,Kd=1900,qd=class{sun=new Tt(16774114,2.3);zenith=new Tt(14674679,.65);sky=new ne(14412024,6972507,1.65);fog=new S(0,Wd,Gd);dome=Yd();reach=0;constructor(e){e.fog=this.fog,this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.03,this.sun.shadow.radius=2,this.zenith.shadow.bias=-.002,this.zenith.shadow.normalBias=.05,this.zenith.shadow.radius=7,this.zenith.shadow.mapSize.set(Vd,Vd),e.add(this.dome,this.sky,this.sun,this.sun.target,this.zenith,this.zenith.target),this.setPalette(Fd.dark)}setPalette({horizon:e,zenith:t,ground:n}){this.fog.color.set(e),this.dome.material.uniforms.horizon.value.set(e),this.dome.material.uniforms.above.value.set(t),this.sky.groundColor.set(n)}setQuality({sunShadowPixels:e,contactShadows:t}){this.sun.castShadow=e>0,this.zenith.castShadow=t,e!==0&&this.sun.shadow.mapSize.x!==e&&(this.sun.shadow.mapSize.set(e,e),this.sun.shadow.map?.dispose(),this.sun.shadow.map=null)}update(e,t,n){this.fog.near=n?1e6:Math.max(Wd,Hd*t),this.fog.far=n?2e6:Math.min(Kd,Math.max(Gd,Ud*t));let r=Jd(t);if(r!==this.reach){this.reach=r;for(let{shadow:e}of[this.sun,this.zenith])Object.assign(e.camera,{left:-r,right:r,top:r,bottom:-r,near:1,far:Ld+3*r}),e.camera.updateProjectionMatrix()}let i=r/Bd,{position:a}=this.sun.target;a.copy(e).divideScalar(i).round().multiplyScalar(i),this.zenith.target.position.copy(a),this.sun.position.copy(a).addScaledVector(Id,Ld+r),this.zenith.position.copy(a).add(new j(0,Ld+r,.01))}};function Jd(e){return Math.min(zd,Rd*2**Math.max(0,Math.ceil(Math.log2(e/Rd))))}function Yd(){let e=new it({side:1,depthWrite:!1,depthTest:!1,fog:!1,toneMapped:!1,uniforms:{horizon:{value:new G},above:{value:new G}},vertexShader:`
      varying vec3 vDirection;
      void main() {
        vDirection = position;
        gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0);
      }`,fragmentShader:`
      uniform vec3 horizon;
      uniform vec3 above;
      varying vec3 vDirection;
      void main() {
        float height = max(0.0, normalize(vDirection).y);
        gl_FragColor = vec4(mix(horizon, above, pow(min(1.0, height * 2.2), 0.7)), 1.0);
        #include <colorspace_fragment>
      }`}),t=new H(new qe(100,24,16),e);return t.frustumCulled=!1,t.renderOrder=-1,t}var Xd=64,Zd=300,Qd=.06,$d=.4,ef=.03,tf=new b,nf=new b().makeScale(0,0,0),rf=class{mesh;marks=Array.from({length:Xd},()=>({at:new j,size:0,startMs:-1/0}));next=0;active=0;constructor(e){let t={color:16774084,transparent:!0,opacity:.85,depthWrite:!1,fog:!1,toneMapped:!1};this.mesh=new Mt(new oe(1,1),new xt(t),Xd),this.mesh.instanceMatrix.setUsage(be),this.mesh.frustumCulled=!1,this.mesh.visible=!1,e.add(this.mesh)}add(e,t,n,r,i){let a=this.marks[this.next];this.next=(this.next+1)%Xd,a.at.set(e,t,n),a.size=Math.min($d,Qd+ef*r),a.startMs=i}get activeCount(){return this.active}update(e){let t=this.active;this.active=0;for(let t=0;t<Xd;t++){let{at:n,size:r,startMs:i}=this.marks[t],a=(e-i)/Zd;if(a<0||a>=1){this.mesh.setMatrixAt(t,nf);continue}this.active++;let o=r*Math.sqrt(1-a);this.mesh.setMatrixAt(t,tf.makeScale(o,o,o).setPosition(n))}this.mesh.visible=this.active>0,(this.active>0||t>0)&&(this.mesh.instanceMatrix.needsUpdate=!0)}};function af(e){let{x:t=0,y:n=0,z:r=0}=e?.position??{},i=e?.rotation,a=i?new W(i.x,i.y,i.z,i.w):new W;if(!(![t,n,r,a.x,a.y,a.z,a.w].every(Number.isFinite)||a.lengthSq()<1e-6))return{position:new j(t,n,r),turn:a.normalize()}}var of=new j(0,1,0),sf=new W().setFromAxisAngle(new j(1,0,0),Math.PI/2),cf=1024,lf=8,uf=.55,df=new j,ff=new W,pf=new j,mf=new j;function hf(e,t,n,r,i,a){mf.copy(r).sub(n);let o=mf.length();o>1e-4&&o<1e5&&(ff.setFromUnitVectors(of,mf.divideScalar(o)),e.add(t,pf.copy(n).lerp(r,.5),ff,df.set(i,o/2,i),a))}function gf(e,t,n,r){e.add(`ball`,t,ff.identity(),df.setScalar(n),r)}function _f(e,t,n,r,i,a){e.add(`rod`,t,ff.copy(n).multiply(sf),df.set(r,i,r),a)}function vf(e,t,n,r,i){e.add(`ring`,t,ff.copy(n).multiply(sf),df.setScalar(r),i)}function yf(e,t,n,r,i){let a=Math.max(0,r-t.distanceTo(n));if(a<.02*r)return hf(e,`rod`,t,n,i,`rope`);let o=Math.min(r/2,Math.sqrt(a*r)*uf),s=e=>t.clone().lerp(n,e).addScaledVector(of,-4*o*e*(1-e));for(let t=0;t<8;t++)hf(e,`rod`,s(t/8),s((t+1)/8),i,`rope`)}function bf({points:e,smooth:t=!0,closed:n}){let r=e.slice(0,cf).map(({x:e,y:t,z:n})=>new j(e,t,n));return r.length<2||!r.every(e=>Number.isFinite(e.lengthSq()))?[]:t?new ze(r,n,`catmullrom`).getPoints(lf*r.length):n?[...r,r[0]]:r}function xf({form:e},t,n){let{a:r,turnA:i,b:a,turnB:o,radius:s,ofWorld:c}=t,l=Math.min(.12,Math.max(.012,.26*s)),u=1.25*s+l;switch(c&&e.kind.case!==`path`&&e.kind.case!==`slider`&&n.add(`plate`,r,ff.copy(i),df.setScalar(1.7*l),`metal`),e.kind.case){case`ball`:case`coneTwist`:gf(n,a,1.25*l,e.kind.value.drive?`motor`:`pin`);break;case`hinge`:{let{motorSpeed:t,spring:r}=e.kind.value;_f(n,a,i,.7*l,u,`pin`),t===void 0?r&&r.hertz>0&&vf(n,a,i,2*l,`spring`):vf(n,a,i,2.2*l,`motor`);break}case`wheel`:{let{motorSpeed:t}=e.kind.value;_f(n,a,o,.8*l,u,`pin`),hf(n,`coil`,r,a,1.3*l,`spring`),t!==void 0&&vf(n,a,o,2*l,`motor`);break}case`fixed`:n.add(`plate`,a,ff.copy(o),df.setScalar(1.1*l),e.kind.value.linear||e.kind.value.angular?`spring`:`metal`);break;case`distance`:{let{minLength:t,maxLength:i,spring:o}=e.kind.value;gf(n,r,.8*l,`metal`),gf(n,a,.8*l,`metal`),o&&o.hertz>0?hf(n,`coil`,r,a,1.6*l,`spring`):t<i?yf(n,r,a,i,.35*l):hf(n,`rod`,r,a,.5*l,`metal`);break}case`slider`:{let{limit:t,motorSpeed:o,spring:c}=e.kind.value,u=new j(0,0,1).applyQuaternion(i),[d,f]=t?[t.lower,t.upper]:[-3*s,3*s],p=r.clone().addScaledVector(u,Math.max(-1e3,Math.min(d,a.clone().sub(r).dot(u))));hf(n,`rod`,p,r.clone().addScaledVector(u,Math.min(1e3,Math.max(f,a.clone().sub(r).dot(u)))),.5*l,`rail`),n.add(`plate`,a,ff.copy(i),df.setScalar(1.1*l),o===void 0?`metal`:`motor`),c&&c.hertz>0&&hf(n,`coil`,p,a,1.3*l,`spring`);break}case`sixDof`:gf(n,a,1.1*l,`pin`),hf(n,`rod`,r,a,.5*l,`metal`);break;case`gear`:hf(n,`rod`,r,a,.3*l,`motor`),vf(n,r,i,1.6*l,`motor`),vf(n,a,o,1.6*l,`motor`);break;case`rack`:vf(n,r,i,1.6*l,`motor`),_f(n,a,o,.6*l,u,`rail`);break;case`pulley`:{let{pointA:t,pointB:i}=e.kind.value,o=new j(t?.x??0,t?.y??0,t?.z??0),s=new j(i?.x??0,i?.y??0,i?.z??0);if(!Number.isFinite(o.lengthSq()+s.lengthSq()))break;gf(n,o,1.8*l,`metal`),gf(n,s,1.8*l,`metal`),hf(n,`rod`,r,o,.35*l,`rope`),hf(n,`rod`,o,s,.35*l,`rope`),hf(n,`rod`,s,a,.35*l,`rope`);break}case`path`:{let t=bf(e.kind.value).map(e=>e.applyQuaternion(i).add(r));for(let e=0;e+1<t.length;e++)hf(n,`rod`,t[e],t[e+1],.35*l,`rail`);gf(n,a,1.1*l,e.kind.value.motorSpeed===void 0?`pin`:`motor`);break}}}var Sf={metal:new G(11845062),pin:new G(14278372),motor:new G(16751931),spring:new G(7327884),rope:new G(13807738),rail:new G(9411237)},Cf=8,wf=1e-5;function Tf(){let e=e=>new j(Math.cos(2*Math.PI*e/Cf),2*e/64-1,Math.sin(2*Math.PI*e/Cf));return new ze(Array.from({length:65},(t,n)=>e(n)))}var Ef={ball:()=>new qe(1,14,10),rod:()=>new Me(1,1,2,10),ring:()=>new Re(1,.24,8,20).rotateX(Math.PI/2),coil:()=>new ve(Tf(),128,.16,5),plate:()=>new Ye(2,2,2)},Df=`cylinder`,Of=[0,0,0,0,0,0,1],kf=.3,Af=class{scene;drawn=new Map;instances=new Map;material=new Ze({roughness:.35});current=[];reusable=[];visible=!0;matrix=new b;a=new j;b=new j;turnA=new W;turnB=new W;constructor(e){this.scene=e}get count(){return[...this.drawn.values()].filter(({solids:e})=>e.length>0).length}get solidCount(){return[...this.instances.values()].reduce((e,{size:t})=>e+t,0)}setJoints(e){for(let[t,n]of this.drawn)e.get(t)!==n.joint&&(this.release(n.solids),this.drawn.delete(t));for(let t of e.values()){if(this.drawn.has(t.id))continue;let e=af(t.form.frameA),n=af(t.form.frameB);e&&n&&this.drawn.set(t.id,{joint:t,frameA:e,frameB:n,last:new Float64Array(14).fill(NaN),solids:[]})}}update(e){for(let t of this.drawn.values()){let{entityA:n,entityB:r}=t.joint,i=n===0?Of:e.poseOf(n),a=e.poseOf(r);!this.visible||!i||!a?(this.release(t.solids),t.solids=[],t.last.fill(NaN)):Mf(t.last,i,a)&&this.draw(t,i,a,e)}for(let e of this.instances.values())e.upload()}draw(e,t,n,r){let{joint:i,frameA:a,frameB:o}=e;jf(this.a,this.turnA,a,t),jf(this.b,this.turnB,o,n);let s=[i.entityA,i.entityB].map(e=>r.radiusOf(e)??1/0),c=Math.min(...s),l=c<1/0?c:kf;this.reusable=e.solids,this.current=[],xf(i,{a:this.a,turnA:this.turnA,b:this.b,turnB:this.turnB,radius:l,ofWorld:i.entityA===0},this),this.release(this.reusable),e.solids=this.current}add(e,t,n,r,i){let a=this.instancesOf(e),o=this.reusable.findIndex(t=>t.part===e),s=o>=0?this.reusable.splice(o,1)[0]:{part:e,slot:a.acquire(0)};a.setMatrix(s.slot,this.matrix.compose(t,n,r)),o<0&&a.setColor(s.slot,Sf[i]),this.current.push(s)}release(e){for(let{part:t,slot:n}of e)this.instancesOf(t).release(n)}instancesOf(e){let t=this.instances.get(e);return t||this.instances.set(e,t=new Os(this.scene,Df,Ef[e](),this.material,e!==`plate`)),t}};function jf(e,t,n,r){t.set(r[3],r[4],r[5],r[6]),e.copy(n.position).applyQuaternion(t),e.set(e.x+r[0],e.y+r[1],e.z+r[2]),t.multiply(n.turn)}function Mf(e,t,n){let r=!1;for(let i=0;i<7;i++)Math.abs(e[i]-t[i])<wf||(r=!0),Math.abs(e[7+i]-n[i])<wf||(r=!0);if(!r)return!1;for(let r=0;r<7;r++)e[r]=t[r],e[7+r]=n[r];return!0}var Nf=260,Pf=new G(16765286),Ff=.018,If=new j(0,1,0),Lf=new j,Rf=new j,zf=new W,Bf=new j,Vf=new G,Hf=class{spawns=[];spawned(e,t,n){this.spawns.push({at:e.clone(),radius:t,startMs:n})}get spawnCount(){return this.spawns.length}draw(e,t,n,r,i){this.spawns=this.spawns.filter(({startMs:e})=>i-e<Nf);for(let{at:t,radius:n,startMs:r}of this.spawns){let a=n*(1-(i-r)/Nf);e.add(`sphere`,t,zf.identity(),Bf.set(a,a,a),Vf.copy(Pf))}t&&this.drawGrab(e,t,n,Ff*r/10)}drawGrab(e,{entity:t,point:n,target:r},i,a){let o=i(t);Lf.copy(n),o&&Lf.applyQuaternion(zf.set(o[3],o[4],o[5],o[6])).add(Rf.set(o[0],o[1],o[2])),e.add(`sphere`,r,zf.identity(),Bf.setScalar(3*a),Pf),e.add(`sphere`,Lf,zf.identity(),Bf.setScalar(2.2*a),Pf),Rf.copy(r).sub(Lf);let s=Rf.length();s<.001||(zf.setFromUnitVectors(If,Rf.divideScalar(s)),e.add(`cylinder`,Lf.addScaledVector(Rf,s/2),zf,Bf.set(a,s/2,a),Pf))}},Uf=[{name:`high`,pixelRatioMax:2,sunShadowPixels:2048,contactShadows:!0,blur:!0},{name:`reduced`,pixelRatioMax:1.5,sunShadowPixels:1024,contactShadows:!1,blur:!1},{name:`medium`,pixelRatioMax:1,sunShadowPixels:0,contactShadows:!1,blur:!1},{name:`minimal`,pixelRatioMax:.5,sunShadowPixels:0,contactShadows:!1,blur:!1}],Wf={...Uf[3],name:`low`,pixelRatioMax:.25},Gf=25,Kf=18,qf=1e3,Jf=2,Yf=8,Xf=300,Zf=1500,Qf=2e3,$f=class{levels;level=0;startMs=NaN;lastMs=NaN;windowMs=0;frames=0;slow=0;fast=0;fastNeeded=Yf;beforeDropMs=0;raised=!1;held=!1;constructor(e=Uf.length){this.levels=e}frame(e){Number.isNaN(this.startMs)&&(this.startMs=e);let t=e-this.lastMs;if(this.lastMs=e,!(t<=Zf)||e-this.startMs<Qf)return this.windowMs=this.frames=0,!1;if(this.windowMs+=t,this.frames++,this.windowMs<qf)return!1;let n=this.windowMs/this.frames;return this.windowMs=this.frames=0,this.judge(n)}judge(e){if(this.beforeDropMs>0){let t=e<.9299999999999999*this.beforeDropMs;if(this.beforeDropMs=0,!t)return this.held=!0,this.change(-1)}return this.slow=e>Gf?this.slow+1:0,this.fast=e<Kf?this.fast+1:0,this.slow===0&&(this.held=!1),this.slow>=Jf&&!this.held&&this.level+1<this.levels?(this.raised&&(this.fastNeeded=Math.min(Xf,4*this.fastNeeded)),this.beforeDropMs=e,this.change(1)):this.fast>=this.fastNeeded&&this.level>0&&this.change(-1)}change(e){return this.level+=e,this.raised=e<0,this.slow=this.fast=0,!0}},ep=[`slab`,`plane`,`field`],tp=`
varying vec3 vUnit;  // on the unit geometry
varying vec3 vSize; // m, half extents
varying vec2 vGrid;  // m
`,np=`
vUnit = position;
vSize = vec3(length(instanceMatrix[0].xyz), length(instanceMatrix[1].xyz), length(instanceMatrix[2].xyz));
vec3 gridPosition = instanceMatrix[1].y > 0.999 * vSize.y ? (instanceMatrix * vec4(position, 1.0)).xyz : position * vSize;
vGrid = gridPosition.xz;
`,rp=`
attribute vec3 edge;
varying vec3 vEdge;  // m to each side of the triangle
`,ip=`
vEdge = edge;
`,ap=`
varying vec3 vEdge;
`,op=`
float width = 0.018;
float blur = max(fwidth(toEdge), 1e-5);
float rim = (1.0 - smoothstep(width - blur, width + blur, toEdge)) * min(1.0, width / blur);
diffuseColor.rgb *= 1.0 - 0.45 * rim;
`,sp=`
vec3 inward = (1.0 - abs(vUnit)) * vSize;
float toEdge = max(min(inward.x, inward.y), min(max(inward.x, inward.y), inward.z));
${op}`,cp=`
float toEdge = min(vEdge.x, min(vEdge.y, vEdge.z));
${op}`,lp=`
float aside = abs(vUnit.x) * vSize.x;
float band = 0.2 * vSize.x;
float soft = max(fwidth(aside), 1e-5);
float stripe = 1.0 - smoothstep(band - soft, band + soft, aside);
diffuseColor.rgb = mix(diffuseColor.rgb, vec3(1.0), 0.34 * stripe);
`,up=`
float toEdge = max((1.0 - length(vUnit.xz)) * vSize.x, (1.0 - abs(vUnit.y)) * vSize.y);
${op}`,dp=`
float toEdge = max((1.0 - length(vUnit.xz)) * vSize.x, (1.0 + vUnit.y) * vSize.y);
${op}`,fp=`
float across = abs(vUnit.y);
float soft = max(fwidth(across), 1e-5);
float belt = 1.0 - smoothstep(0.26 - soft, 0.26 + soft, across);
diffuseColor.rgb = mix(diffuseColor.rgb, vec3(1.0), 0.42 * belt);
`,pp=`
for (int i = 0; i < 2; i++) {
  vec2 at = vGrid / (i == 0 ? 1.0 : 10.0);
  vec2 blur = max(fwidth(at), vec2(1e-6));
  vec2 away = abs(fract(at - 0.5) - 0.5) / blur;
  vec2 line = (1.0 - min(away, 1.0)) * (1.0 - smoothstep(0.15, 0.5, blur));
  diffuseColor.rgb *= 1.0 - (i == 0 ? 0.16 : 0.30) * max(line.x, line.y);
}
`,mp=`
vec3 hazardAt = vUnit * vSize;
float hazardWidth = min(0.25, 0.35 * max(vSize.x, max(vSize.y, vSize.z)));
float hazard = (hazardAt.x + hazardAt.y + hazardAt.z) / hazardWidth;
float hazardBlur = max(fwidth(hazard), 1e-5);
float hazardStripe = smoothstep(0.5 - hazardBlur, 0.5 + hazardBlur, abs(fract(0.5 * hazard) - 0.5) * 2.0);
diffuseColor.rgb = mix(diffuseColor.rgb, mix(vec3(0.03), vec3(0.95, 0.62, 0.08), hazardStripe), 0.45 * (1.0 - smoothstep(0.5, 1.5, hazardBlur)));
`,hp=`
float facing = abs(dot(normalize(cross(dFdx(vViewPosition), dFdy(vViewPosition))), normalize(vViewPosition)));
diffuseColor.a *= mix(0.55, 0.16, facing);
`,gp={box:sp,sphere:fp,slab:pp,plane:pp,field:pp,cylinder:lp+up,cone:lp+dp,hull:cp,mesh:cp},_p={solid:.48,static:.85,kinematic:.4,glass:.12};function vp(e,t){let n=ep.includes(e),r=e===`hull`||e===`mesh`,i=t===`glass`,a=new Ze({roughness:n&&!i?.95:_p[t],metalness:t===`kinematic`?.25:0,flatShading:e===`field`,transparent:i,depthWrite:!i,side:e===`field`||e===`mesh`||i?2:0}),o=(gp[e]??``)+(t===`kinematic`?mp:i?hp:``);return a.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace(`#include <common>`,`#include <common>${tp}${r?rp:``}`).replace(`#include <begin_vertex>`,`#include <begin_vertex>${np}${r?ip:``}`),e.fragmentShader=e.fragmentShader.replace(`#include <common>`,`#include <common>${tp}${r?ap:``}`).replace(`#include <color_fragment>`,`#include <color_fragment>${o}`)},a.customProgramCacheKey=()=>o+String(r),a}var yp=3,bp=6;function xp(e){return Sp(e).flatMap(({box:{min:e,max:t}})=>[0,1,2,3,4,5,6,7].map(n=>new j(n&1?t.x:e.x,n&2?t.y:e.y,n&4?t.z:e.z)))}function Sp(e){let t=e.filter(({dynamic:e})=>!e),n=e.filter(({dynamic:e})=>e);if(n.length===0)return t;let r=Cp(n.map(({box:e})=>e.getCenter(new j)));for(let{box:e}of t)r.union(e);let i=n.filter(({box:e})=>r.containsPoint(e.getCenter(new j)));return i.length<.8*n.length?e:[...t,...i]}function Cp(e){let t=new _t;for(let n of[`x`,`y`,`z`]){let r=e.map(e=>e[n]).sort((e,t)=>e-t),i=e=>r[Math.round(e*(r.length-1))],[a,o]=[i(.25),i(.75)],s=Math.max(bp,yp*(o-a));t.min[n]=a-s,t.max[n]=o+s}return t}var wp=[6000111,14711391,15912079,7058322,10980346,15696724,5032384,15100572],Tp=16765286,Ep=9674925,Dp=8358807,Op=12174285,kp=5822184,Ap=new G(3752524),jp=.3,Mp=new G(3108822),Np=.75,Pp=9278878,Fp=45,Ip=400,Lp=8,Rp=[`plane`,`slab`],zp=new j,Bp=new W,Vp=new j(1,1,1),Hp=new b,Up=new b,Wp=new G,Gp=class{scene=new pt;geometries=new Map;materials=new Map;rendered=new Map;tints;bodyColors=new Map;asleepMarked=!1;constructor(){for(let e of rc)this.addInstances(e,e,`solid`,ic[e]())}addInstances(e,t,n,r,i){let a=`${n} ${t}`,o=this.materials.get(a);o||this.materials.set(a,o=vp(t,n));let s=new Os(this.scene,t,r,o,n!==`glass`&&!Rp.includes(t),i);return n===`glass`&&(s.renderOrder=2),this.geometries.set(e,s),s}instancesFor({key:e,kind:t,geometry:n},r){let i=r===`solid`?e:`${r} ${e}`,a=this.geometries.get(i);if(a)return a;let o=n();return o&&this.addInstances(i,t,r,o,Lp)}get objects(){return[...this.geometries.entries()].filter(([e])=>!e.startsWith(`glass `)).map(([,{mesh:e}])=>e)}partCounts(){let e={};for(let{kind:t,size:n}of this.geometries.values())n>0&&(e[t]=(e[t]??0)+n);return e}ownerAt(e,t){let n=e.userData.instances;return{entity:n?.entityAt(t)??0,shape:n?.shapeAt(t)??0}}setEntities(e,t){for(let[t,n]of this.rendered)if(e.get(t)!==n.entity){for(let e of n.parts)e.instances.release(e.slot);this.rendered.delete(t)}for(let n of e.values())this.rendered.has(n.id)||this.rendered.set(n.id,this.addEntity(n,t));for(let[e,t]of this.geometries)t.size>0||rc.includes(e)||(t.dispose(),this.geometries.delete(e))}addEntity(e,t){let n=[],r=1/0;e.shapes.forEach((t,i)=>{let a=Jp(e,t.trigger);for(let o of dc(t)){let t=this.instancesFor(o,a);t&&(n.push({instances:t,slot:t.acquire(e.id,i),local:o.local}),r=Math.min(r,qp(t.mesh.geometry,o.local)))}});let i=new Float64Array(7).fill(NaN);return{entity:e,parts:n,color:Yp(e,t,n.some(({instances:e})=>ep.includes(e.kind))),pose:i,radius:r,asleep:void 0}}update(e){for(let t=0;t<e.count;t++){let n=this.rendered.get(e.ids[t]);if(!n)continue;let r=e.source.entities[t].atRest;n.asleep!==r&&this.applyColor(n,r);let i=!0,a=t*7,{pose:o}=n;for(let t=0;t<7;t++){let n=e.poses[a+t];o[t]!==n&&(o[t]=n,i=!1)}i||this.applyPose(n)}for(let e of this.geometries.values())e.upload()}applyPose({pose:e,parts:t}){zp.set(e[0],e[1],e[2]),Bp.set(e[3],e[4],e[5],e[6]),Hp.compose(zp,Bp,Vp);for(let e=0;e<t.length;e++){let{instances:n,slot:r,local:i}=t[e];n.setMatrix(r,Up.multiplyMatrices(Hp,i))}}applyColor(e,t){e.asleep=t,Wp.set(this.currentColor(e)),t&&e.entity.mass>0&&Wp.lerp(this.asleepMarked?Mp:Ap,this.asleepMarked?Np:jp);for(let{instances:t,slot:n}of e.parts)t.setColor(n,Wp)}currentColor({entity:e,color:t}){let n=e.color??this.bodyColors.get(e.id)??t;return!this.tints||e.mass<=0?n:this.tints.get(e.id)??Pp}setTints(e){let t=this.tints;if(this.tints=e,t||e)for(let[n,r]of this.rendered)t&&e&&t.get(n)===e.get(n)||(r.asleep=void 0)}setBodyColors(e){let t=this.bodyColors;this.bodyColors=e;for(let[n,r]of this.rendered)t.get(n)!==e.get(n)&&(r.asleep=void 0)}markAsleep(e){if(this.asleepMarked!==e){this.asleepMarked=e;for(let e of this.rendered.values())e.asleep=void 0}}poseOf(e){let t=this.rendered.get(e)?.pose;return t&&!Number.isNaN(t[0])?t:void 0}radiusOf(e){let t=this.rendered.get(e)?.radius;return t!==void 0&&t<1/0?t:void 0}boxOf(e){let t=this.rendered.get(e);return t&&!Number.isNaN(t.pose[0])?Kp(t.parts,1/0):new _t}extent(){let e=xp(this.placedBodies(Fp));return e.length>0?e:xp(this.placedBodies(Ip))}placedBodies(e){let t=[];for(let{parts:n,pose:r,entity:i}of this.rendered.values()){if(Number.isNaN(r[0]))continue;let a=Kp(n,e);a.isEmpty()||t.push({box:a,dynamic:i.mass>0})}return t}dynamicPoseOf(e){return(this.rendered.get(e)?.entity.mass??0)>0?this.poseOf(e):void 0}colorOf(e){let t=this.rendered.get(e)?.parts[0];return t&&t.instances.colorAt(t.slot).getHex()}};function Kp(e,t){let n=new _t,r=new _t;for(let{instances:i,slot:a}of e){let{mesh:e}=i;e.geometry.boundingBox??e.geometry.computeBoundingBox(),e.getMatrixAt(a,Up),r.copy(e.geometry.boundingBox).applyMatrix4(Up),Math.max(r.max.x-r.min.x,r.max.z-r.min.z)<t&&n.union(r)}return n}function qp(e,t){e.boundingBox??e.computeBoundingBox();let n=e.boundingBox.getSize(zp),r=new j().setFromMatrixScale(t);return Math.cbrt(n.x*r.x*n.y*r.y*n.z*r.z)/2}function Jp({type:e,mass:t},n){return n?`glass`:e===l.KINEMATIC?`kinematic`:e===l.STATIC&&t<=0?`static`:`solid`}function Yp(e,t,n){return e.color===void 0?e.shapes.length>0&&e.shapes.every(({trigger:e})=>e)?kp:e.type===l.KINEMATIC?Op:e.type===l.STATIC?n?Dp:Ep:e.owner===0?wp[e.id%wp.length]:e.owner===t?Tp:wp[e.owner%wp.length]:e.color}function Xp(e){return e instanceof HTMLElement?e.isContentEditable||e instanceof HTMLTextAreaElement||e instanceof HTMLSelectElement?!0:e instanceof HTMLInputElement&&![`checkbox`,`radio`,`button`,`range`,`color`].includes(e.type):!1}var Zp=class{byKey=new Map;register(e){if(this.byKey.has(e.key))throw Error(`two commands have the key ${e.key}: ${e.label}`);this.byKey.set(e.key,e)}get all(){return[...this.byKey.values()]}run(e){let t=this.byKey.get(e.toLowerCase());return t?.run(),t!==void 0}},Qp=8,$p=class{element;constructor(e){this.element=e,addEventListener(`pointerdown`,e=>{this.element.contains(e.target)||this.close()},{capture:!0}),e.addEventListener(`keydown`,e=>this.key(e))}get isOpen(){return!this.element.hidden}open(e,t,n,r){let i=document.createElement(`p`);i.textContent=e,i.setAttribute(`role`,`presentation`),this.element.setAttribute(`aria-label`,e),this.element.replaceChildren(i,...t.map(({label:e,run:t,refusal:n})=>{let r=document.createElement(`button`);return r.type=`button`,r.setAttribute(`role`,`menuitem`),r.textContent=e,n&&(r.setAttribute(`aria-disabled`,`true`),r.append(Object.assign(document.createElement(`small`),{textContent:n}))),r.onclick=()=>{n||(this.close(),t())},r})),this.element.hidden=!1;let{width:a,height:o}=this.element.getBoundingClientRect();this.element.style.left=`${Math.max(Qp,Math.min(n,innerWidth-a-Qp))}px`,this.element.style.top=`${Math.max(Qp,Math.min(r,innerHeight-o-Qp))}px`,this.buttons[0]?.focus()}close(){return!this.element.hidden&&(this.element.hidden=!0,!0)}get buttons(){return[...this.element.querySelectorAll(`button`)]}key(e){let t=e.key===`ArrowDown`?1:e.key===`ArrowUp`?-1:0;if(t===0)return;e.preventDefault(),e.stopPropagation();let{buttons:n}=this;n[(n.indexOf(document.activeElement)+t+n.length)%n.length]?.focus()}},em={drag:`M8 12V6.5a1.5 1.5 0 0 1 3 0V11m0-.5v-5a1.5 1.5 0 0 1 3 0V11m0-3.5a1.5 1.5 0 0 1 3 0V14a6 6 0 0 1-6 6c-3 0-4.2-1.4-5.6-3.8L4 13.4a1.4 1.4 0 0 1 2.3-1.6L8 14`,throw:`M5 19c1-6 5-11 10-12m0 0-4-2m4 2-2 4M18 17a2 2 0 1 0 0 .1`,box:`M12 3l8 4.5v9L12 21l-8-4.5v-9zM4 7.5l8 4.5 8-4.5M12 12v9`,sphere:`M12 3a9 9 0 1 0 .1 0M3.5 12c3 2.6 14 2.6 17 0`,capsule:`M8 8a4 4 0 0 1 8 0v8a4 4 0 0 1-8 0zM8 12h8`,explode:`M12 2l2 6 5-3-2 5.5 5 2.5-5.5 1.500L18 20l-5-3-1 5-2-5-5 2 2-5-5-1.500 5-2.500L5 5l5 3z`,delete:`M4 7h16M9 7V4h6v3M6 7l1 13h10l1-13M10 11v5M14 11v5`,drive:`M12 3a9 9 0 1 0 .1 0M12 10a2 2 0 1 0 .1 0M3.500 10.500 10 11.500M20.500 10.500 14 11.500M12 14v7`,cut:`M6 4a2.500 2.500 0 1 0 .1 0M6 15a2.500 2.500 0 1 0 .1 0M8 8l12 9M8 16 20 7`,worlds:`M12 3a9 9 0 1 0 .1 0M3 12h18M12 3c-5 5-5 13 0 18M12 3c5 5 5 13 0 18`,stats:`M4 20h16M7 16v-4M12 16V5M17 16V9`,debug:`M12 7a5 5 0 0 1 5 5v2a5 5 0 0 1-10 0v-2a5 5 0 0 1 5-5zM9 4l1.500 3M15 4l-1.500 3M7 12H3M21 12h-4M7 16l-3 2M17 16l3 2`,events:`M5 6h2M5 12h2M5 18h2M10 6h9M10 12h9M10 18h9`,help:`M12 3a9 9 0 1 0 .1 0M9.500 9.500a2.500 2.500 0 1 1 3.500 2.300c-.700.300-1 .800-1 1.700M12 16.500v.1`,fit:`M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5`,theme:`M12 3a9 9 0 1 0 .1 0M12 3v18a9 9 0 0 0 0-18z`,menu:`M4 7h16M4 12h16M4 17h16`,inspect:`M10.500 4a6.500 6.500 0 1 0 .1 0M15.300 15.300 21 21M10.500 8v5M8 10.500h5`,plot:`M4 4v16h16M7 14c2-6 4-6 6-2s4 2 6-5`,time:`M12 4a8.500 8.500 0 1 0 .1 0M12 8v5l3.500 2M9 2h6`,build:`M4 20l9-9M11 9l4 4 5-5-4-4zM4 20h4`,joint:`M7 15a3 3 0 1 0 .1 0M17 3a3 3 0 1 0 .1 0M9.200 15.800 14.900 8.200`,close:`M6 6l12 12M18 6 6 18`,players:`M9 5a3.200 3.200 0 1 0 .1 0M3 20c0-4 2.500-6 6-6s6 2 6 6M16 5.500a3 3 0 0 1 0 5.800M17.500 14.300c2.300.6 3.500 2.500 3.500 5.700`,chat:`M4 5h16v11H10l-4 4v-4H4zM8 9h8M8 12h5`,share:`M14 4h6v6M20 4l-8 8M10 5H5v14h14v-5`,room:`M12 3l7 3v5c0 5-3 8-7 10-4-2-7-5-7-10V6zM9 12l2 2 4-4`,edit:`M4 20l1-5L16 4l4 4L9 19zM13 7l4 4`,more:`M5 11.500a.6.6 0 1 0 .1 0M12 11.500a.6.6 0 1 0 .1 0M19 11.500a.6.6 0 1 0 .1 0`};function tm(e){let t=document.createElementNS(`http://www.w3.org/2000/svg`,`svg`);t.setAttribute(`viewBox`,`0 0 24 24`),t.setAttribute(`aria-hidden`,`true`),t.classList.add(`icon`);let n=document.createElementNS(`http://www.w3.org/2000/svg`,`path`);return n.setAttribute(`d`,em[e]),t.append(n),t}function nm(e,t,n=``){let r=document.createElement(`button`);if(r.type=`button`,r.append(tm(e)),n){let e=document.createElement(`span`);e.textContent=n,r.append(e)}return r.setAttribute(`aria-label`,t),r}var rm=600,im=class{times=new Float64Array(rm);count=0;add(e){this.times[this.count++%rm]=e}reset(){this.count=0}percentile(e){let t=this.times.slice(0,Math.min(rm,this.count)).sort();return t[Math.min(t.length-1,Math.floor(e*t.length))]??0}get frames(){return this.count}},am=class{places;onChange;panels=new Map;open_=[];resizes=new ResizeObserver(()=>this.onChange());narrow=matchMedia(`(max-width: 699px)`);constructor(e,t){this.places=e,this.onChange=t,this.narrow.addEventListener(`change`,()=>{this.narrow.matches&&this.closeOthers(this.open_.at(-1)??``)})}register(e){let{id:t,title:n,hint:r,key:i,side:a}=e,o=document.createElement(`section`);o.id=t,o.className=`panel`,o.hidden=!0,o.setAttribute(`aria-label`,n);let s=document.createElement(`header`),c=document.createElement(`h2`);c.textContent=n;let l=nm(`close`,`Close ${n}`);l.className=`close`,l.onclick=()=>this.close(t),s.append(c,l);let u=document.createElement(`div`);u.className=`body`,u.tabIndex=0,u.setAttribute(`role`,`group`),u.setAttribute(`aria-label`,n),o.append(s,u),this.places[a].append(o),this.resizes.observe(o);let d=nm(e.icon,n,e.compact?``:n);d.title=i?`${r} (${i.toUpperCase()})`:r,d.classList.toggle(`narrow-only`,e.narrowOnly??!1),d.setAttribute(`aria-expanded`,`false`),d.setAttribute(`aria-controls`,t),d.onclick=()=>this.toggle(t),this.places.buttons.append(d),this.panels.set(t,{definition:e,section:o,body:u,button:d,content:void 0,loading:!1})}get definitions(){return[...this.panels.values()].map(({definition:e})=>e)}get isNarrow(){return this.narrow.matches}isOpen(e){return this.open_.includes(e)}get openIds(){return this.open_}toggle(e){this.isOpen(e)?this.close(e):this.open(e)}open(e){let t=this.panels.get(e);t&&!this.isOpen(e)&&(this.narrow.matches&&this.closeOthers(e),t.section.hidden=!1,t.button.setAttribute(`aria-expanded`,`true`),this.open_.push(e),this.show(t))}async show(e){if(!e.content){if(e.loading)return;e.loading=!0,e.body.textContent=`Loading …`;let t=document.createElement(`div`);try{e.content=await e.definition.load(t),e.body.replaceChildren(t)}catch{e.body.textContent=`This panel could not be loaded. Close it and open it again.`;return}finally{e.loading=!1}}this.isOpen(e.definition.id)&&e.content.opened?.()}close(e){let t=this.panels.get(e),n=this.open_.indexOf(e);if(!t||n<0)return;this.open_.splice(n,1);let r=t.section.contains(document.activeElement);t.section.hidden=!0,t.button.setAttribute(`aria-expanded`,`false`),r&&t.button.focus(),t.content?.closed?.()}closeNewest(){let e=this.open_.at(-1);return e!==void 0&&(this.close(e),!0)}closeOthers(e){for(let t of[...this.open_])t!==e&&this.close(t)}update(){for(let e of this.open_)this.panels.get(e).content?.update?.()}},om=120;function sm(e){let t=10**Math.floor(Math.log10(e)),n=e/t;return(n>=5?5:n>=2?2:1)*t}function cm(e){return e>=1e3?`${e/1e3} km`:e>=1?`${Math.round(e)} m`:e>=.01?`${Math.round(100*e)} cm`:`${Number((1e3*e).toPrecision(1))} mm`}var lm=class{element;shown=``;constructor(e){this.element=e}update(e){if(!(e>0)||!Number.isFinite(e))return;let t=sm(om*e),n=Math.round(t/e),r=cm(t);this.shown!==`${n} ${r}`&&(this.shown=`${n} ${r}`,this.element.style.width=`${n}px`,this.element.textContent=r)}},um=`jostle-theme`,dm=class{onChange;system=matchMedia(`(prefers-color-scheme: light)`);constructor(e){this.onChange=e,this.system.addEventListener(`change`,()=>this.apply()),this.apply()}get theme(){let e=this.stored;return e===`dark`||e===`light`?e:this.system.matches?`light`:`dark`}toggle(){let e=this.theme===`dark`?`light`:`dark`;try{localStorage.setItem(um,e)}catch{document.documentElement.dataset.chosenTheme=e}this.apply()}get stored(){try{return localStorage.getItem(um)??void 0}catch{return document.documentElement.dataset.chosenTheme}}apply(){document.documentElement.dataset.theme=this.theme,this.onChange(this.theme)}},fm=class{bar;select;explain;buttons=new Map;hints=new Map;refusals=new Map;constructor(e,t,n,r){this.bar=e,this.select=n,this.explain=r;for(let{tool:n,key:r,label:i,hint:a,icon:o}of t){this.hints.set(n,`${a} (${r.toUpperCase()})`);let t=nm(o,i,i);t.removeAttribute(`aria-label`),t.dataset.tool=n,t.title=this.hints.get(n);let s=document.createElement(`kbd`);s.textContent=r.toUpperCase(),s.setAttribute(`aria-hidden`,`true`),t.append(s),t.onclick=()=>this.choose(n),this.buttons.set(n,t),e.append(t)}}choose(e){let t=this.refusals.get(e);t?this.explain(t):this.select(e)}setRefusals(e){for(let[t,n]of this.buttons){let r=e(t);r?this.refusals.set(t,r):this.refusals.delete(t),n.setAttribute(`aria-disabled`,String(r!==``)),n.title=r||this.hints.get(t)}}refusalOf(e){return this.refusals.get(e)??``}show(e){for(let[t,n]of this.buttons)n.setAttribute(`aria-pressed`,String(t===e)),t===e&&this.bar.scrollWidth>this.bar.clientWidth&&n.scrollIntoView({block:`nearest`,inline:`center`})}},pm=e=>{let t=document.getElementById(e)?.getBoundingClientRect();return t&&t.width>0&&t.height>0?t:void 0};function mm(e,t){let n=pm(`bottom`),r=pm(`bar`),i=hm(`dock-left`),a=hm(`dock-right`),o=Math.max(r?.bottom??0,pm(`banner`)?.bottom??0),s=[...i,...a].filter(t=>t.width>.8*e);return s.length>0?{top:o,right:0,bottom:t-Math.min(...s.map(e=>e.top)),left:0}:{top:o,right:a.length>0?e-Math.min(...a.map(e=>e.left)):0,bottom:n?t-n.top:0,left:i.length>0?Math.max(...i.map(e=>e.right)):0}}function hm(e){return[...document.getElementById(e)?.children??[]].map(e=>e.getBoundingClientRect()).filter(e=>e.height>0)}var gm=[`auto`,`high`,`medium`,`low`],_m=1,vm=1e6,ym=16,bm=1e6;function xm(e){let t=new URLSearchParams(e);return{world:t.get(`world`)??``,recording:t.get(`recording`)||void 0,quality:gm.find(e=>e===t.get(`quality`))??`auto`,predict:t.get(`predict`)===`1`,areaOfInterest:Sm(t),networkConditions:wm(t)}}function Sm(e){let t=(t,n,r)=>{let i=Number(e.get(t)??``);return i>=n&&i<=r?i:0},n=t(`interest`,_m,vm),r=Math.round(t(`kbps`,ym,bm));return n>0||r>0?{radius:n,maxKbps:r}:void 0}var Cm={latency_ms:[`latencyMs`,0,6e4],jitter_ms:[`jitterMs`,0,6e4],jitter_tail_ms:[`jitterTailMs`,0,6e4],stall_ms:[`stallMs`,0,6e4],stall_interval_ms:[`stallIntervalMs`,0,1e9],loss:[`loss`,0,1],loss_burst:[`lossBurst`,1,1e3],retransmit_ms:[`retransmitMs`,0,6e4],rate_kbps:[`rateKbps`,0,1e7],seed:[`seed`,0,2**32-1]};function wm(e){let t={...tn};for(let[n,r]of e){let[e,i,a]=Cm[n]??[],o=Number(r);e&&r!==``&&o>=i&&o<=a&&(t[e]=o)}return nn(t)?t:void 0}var Tm=`jostle-token`;function Em(e,t){let n=new URLSearchParams(e.hash.replace(/^#/,``)),r=n.get(`token`);return r===null?t.getItem(Tm)??``:(n.delete(`token`),e.replaceHash(n.toString()),t.setItem(Tm,r),r)}var Dm=e=>document.getElementById(e),Om=e=>e instanceof Error?e.message:String(e),km=xm(location.search),Am=Dm(`view`),jm=new _a({canvas:Am,antialias:km.quality===`auto`||km.quality===`high`});jm.shadowMap.enabled=!0,jm.shadowMap.type=1,jm.toneMapping=7;var X=new po(Am),Z=new Gp,Mm=new qd(Z.scene),Nm=new t,Pm=new im,Fm=km.quality===`auto`?new $f:void 0,Im={high:Uf[0],medium:Uf[2],low:Wf}[km.quality]??Uf[0];function Lm(e){Im=e,document.documentElement.toggleAttribute(`data-blur`,e.blur),Mm.setQuality(e),Rm()}function Rm(){jm.setPixelRatio(Math.min(Im.pixelRatioMax,Im.pixelRatioMax<1?1:devicePixelRatio)),jm.setSize(innerWidth,innerHeight,!1),zm(),X.resize(innerWidth,innerHeight)}function zm(){X.setInsets(mm(innerWidth,innerHeight))}var Bm=new dm(e=>{Mm.setPalette(Fd[e]),jm.toneMappingExposure=Fd[e].exposure}),Vm=new Vu(Dm(`toasts`)),Hm=Dm(`state`),Um={connecting:`connecting …`,playing:``,waiting:`reconnecting …`,stopped:``},Wm=Em({hash:location.hash,replaceHash:e=>history.replaceState(null,``,location.pathname+location.search+(e&&`#${e}`))},sessionStorage),Gm=!1,Km=0,qm={state:(e,t)=>{let n=Q.welcome?.worldName??``;Hm.textContent=e===`playing`?n:Um[e]||(t?`not connected`:``),Hm.className=e,Nh.setConnection(e,t),e===`playing`&&eh(),e===`playing`&&$m.playing(),e===`stopped`&&t&&Qm.open(`worlds`)},entityList:e=>{Z.setEntities(e,Q.welcome?.clientId??0),uh=Ym?[]:[...e.values()].filter(e=>e.controllable),dh=!0,e.has($.entity)||$.reset(),hh.onWorldChanged()},stats:e=>{Oh=e,kh?.update(e),hh.onStats(e),Nh.setStats(Ym?void 0:e)},joints:e=>{wh.setJoints(e),hh.onWorldChanged()},worldEvents:e=>jh?.addEvents(e,performance.now()+Lh()),inputRejected:e=>$m.rejected(e)||hh.rejected(e)||mh.rejected(e)||Vm.show(e.message||`the server rejected the input`),notice:e=>Vm.show(e),playerEvent:e=>$m.playerEvent(e),dataChanged:()=>{mh.onDataChanged(),$m.dataChanged(),hh.onDataChanged()},userMessage:e=>$m.message(e)},Jm=km.networkConditions?sn(m,km.networkConditions):m,Ym,Xm=[...bc,Kc,...km.predict?[o]:[]],Zm=new $p(Dm(`context-menu`)),Qm=new am({left:Dm(`dock-left`),right:Dm(`dock-right`),buttons:Dm(`panel-buttons`)},zm),$m=new gu({connection:()=>Q,view:Z,camera:X,panels:Qm,contextMenu:Zm,token:Wm,rules:()=>mh.rules,grab:()=>gh.grab,controlled:()=>$.entity,isRecorded:()=>Ym!==void 0,join:nh,showProblem:e=>Vm.show(e)}),Q=new d({url:rh(),...$m.connectionOptions,joinCode:$m.initialJoinCode(km.world),listener:qm,openSocket:e=>Ym?Ym.open():Jm(e),token:Wm,channelKinds:Xm,areaOfInterest:km.areaOfInterest,joints:!0,players:!0,attributes:!0});function eh(){Gm&&Nh.setReconnected(Q.resumed>Km?`session`:`new client`),Gm=!0,Km=Q.resumed,Nh.setPlayed()}function th(){Gm=!1,Nh.begin()}function nh(e,t=``){th(),Q.join(e,t)}function rh(){let e=new URL(`play`,location.href);return e.protocol=location.protocol===`https:`?`wss:`:`ws:`,e.search=e.hash=``,e.href}var ih;async function ah(){let e=e=>{ih=void 0,Vm.show(`prediction is disabled: ${Om(e)}`)};try{let{loadPrediction:t}=await K(async()=>{let{loadPrediction:e}=await import(`./prediction-Cr37pRhx.js`);return{loadPrediction:e}},__vite__mapDeps([22,15]),import.meta.url);ih=await t(Q.frames,e),Q.enablePrediction(ih)}catch(t){e(t)}}km.predict&&ah();var oh=new u(()=>Q.state===`playing`&&!Ym?Q.welcome?.worldId??``:``,p(Wm)),sh=Dm(`readout`),$=new Io(e=>Q.send(e)),ch=new vs(Dm(`touch-controls`)),lh=new Hf,uh=[],dh=!1,fh=matchMedia(`(pointer: coarse)`).matches;addEventListener(`pointerdown`,({pointerType:e})=>fh=e===`touch`,{capture:!0});var ph=new Zp,mh=new ku({scene:Z.scene,panels:Qm,connection:Q,nameOf:e=>$m.nameOfClient(e),selectedBox:()=>hh.selection.body===0?void 0:Z.boxOf(hh.selection.body),cameraTarget:()=>X.controls.target}),hh=new Nd({room:mh,connection:Q,queries:oh,view:Z,panels:Qm,commands:ph,hint:Dm(`tool-hint`),isPlanar:()=>X.planar,focus:_h,stats:()=>Oh}),gh=new gs({canvas:Am,camera:X,view:Z,connection:Q,queries:oh,onHover(e){$m.hover(e?.point),sh.hidden=e===void 0,e&&(sh.textContent=Zc(Q.entities.get(e.entity),e))},takeControl(e){if(!Q.entities.get(e)?.controllable)return Vm.show(`this entity is not controllable`);Yh(e)},onExplosion:(e,t,n,r)=>Th.blasts.add(e,t,n,r,performance.now()),onSpawn:(e,t)=>lh.spawned(e,t,performance.now()),onMenu:vh,spawnOptions:hh.spawnOptions,onSandboxClick:(e,t,n)=>e===`joint`?t&&hh.jointTool.click(t):hh.inspectAt(t,n),onFocus:e=>e&&_h(e.entity)});function _h(e){let t=Z.boxOf(e);if(t.isEmpty())return;let n=t.getSize(new j);X.focus(t.getCenter(new j),Math.max(n.x,n.y,n.z)/2)}function vh(e,t,n){let r=e&&Q.entities.get(e.entity),i=[];r&&i.push(...hh.menuItems(r.id,gh.enabled)),r&&r.mass>0&&i.push({label:`Focus`,run:()=>_h(r.id)}),r?.controllable&&gh.enabled&&i.push({label:`Drive`,refusal:mh.rules.refusal(`control`),run:()=>Yh(r.id)}),r&&gh.enabled&&r.owner!==0&&r.owner===Q.welcome?.clientId&&i.push({label:`Delete`,refusal:mh.rules.refusal(`delete`,`self`),run:()=>Q.send({kind:{case:`delete`,value:{entity:r.id}}})}),i.push({label:`Show all`,run:Kh}),Zm.open(e?Zc(r,e):`View`,i,t,n)}var yh=new fm(Dm(`tools`),is,bh,e=>Vm.show(e));mh.onChange(e=>{yh.setRefusals(t=>as[t]?e.refusal(as[t]):``),yh.refusalOf(gh.tool)&&bh(`inspect`)});function bh(e){gh.tool=e,hh.jointTool.setSelected(e===`joint`),yh.show(e),Am.style.cursor=e===`drag`?``:`crosshair`}var xh=new nl(Dm(`driver`),Yh,()=>$.stopControlling()),Sh=new Qu(Z.scene),Ch=new rf(Z.scene),wh=new Af(Z.scene),Th=new xc(Z.scene),Eh=new qc(Z.scene),Dh=new lm(Dm(`scale`)),Oh,kh,Ah,jh,Mh,Nh=new Ru({element:Dm(`banner`),world:()=>Q.welcome?.worldId??``,token:Wm,showMessage:e=>Vm.show(e),reconnect:()=>Q.retryNow(),openWorlds:()=>Qm.open(`worlds`),onChange:zm});Qm.register({id:`worlds`,title:`Worlds`,hint:`Join, create and delete worlds`,key:`w`,icon:`worlds`,side:`left`,async load(e){let{LobbyPanel:t}=await K(async()=>{let{LobbyPanel:e}=await import(`./lobby_panel-Da-fVIOj.js`);return{LobbyPanel:e}},__vite__mapDeps([23,24,12,18]),import.meta.url);return Mh=new t({content:e,api:new cl(Wm),contextMenu:Zm,close:()=>Qm.close(`worlds`),join:(e,t,n)=>{zh(void 0),n&&$m.joinCodes.set(t,n),nh(e,n)},joinCodeOf:e=>$m.joinCodes.get(e),current:()=>Q.welcome?.worldId??``,showProblem:e=>Vm.show(e)}),Mh}}),Qm.register({id:`stats`,title:`Statistics`,hint:`Latency, bandwidth and load`,key:`s`,icon:`stats`,side:`right`,async load(e){let{StatsPanel:t}=await K(async()=>{let{StatsPanel:e}=await import(`./stats-DGkkpex8.js`);return{StatsPanel:e}},__vite__mapDeps([25,24]),import.meta.url);return kh=new t(e,Q),Oh&&kh.update(Oh),{}}}),Qm.register({id:`debug`,title:`Debug view`,hint:`Contacts, islands, joints and bounds of the solver`,key:`d`,icon:`debug`,side:`left`,async load(e){let{DebugPanel:t}=await K(async()=>{let{DebugPanel:e}=await import(`./debug-DbF6wkaq.js`);return{DebugPanel:e}},[],import.meta.url);return Ah=new t(e,oh,Sh,Z),{}}}),Qm.register({id:`events`,title:`Events`,hint:`Contacts, hits and triggers; opening the panel rejoins the world`,key:`e`,icon:`events`,side:`left`,async load(e){let{EventsPanel:t}=await K(async()=>{let{EventsPanel:e}=await import(`./events-uhH-c3T7.js`);return{EventsPanel:e}},__vite__mapDeps([26,24]),import.meta.url);return jh=new t(e,Ch,e=>{th(),Q.setEventsEnabled(e)},e=>Xc(Q.entities.get(e),e)),jh}}),hh.register(),$m.registerPanels(),mh.register(),Qm.register({id:`help`,title:`Help`,hint:`Tools, keys and gestures`,key:`?`,icon:`help`,side:`left`,async load(e){let{helpPanel:t}=await K(async()=>{let{helpPanel:e}=await import(`./help-CYczXel9.js`);return{helpPanel:e}},[],import.meta.url);return t(e,is,ph.all)}});var Ph=[{icon:`fit`,label:`Show all`,hint:`Shows all bodies`,key:`f`,run:Kh},{icon:`theme`,label:`Theme`,hint:`Light or dark theme`,key:`t`,run:()=>Bm.toggle()}];Qm.register({id:`menu`,title:`Menu`,hint:`Panels and settings`,key:``,icon:`menu`,side:`left`,narrowOnly:!0,async load(e){let{menuPanel:t}=await K(async()=>{let{menuPanel:e}=await import(`./menu-CRopqFG4.js`);return{menuPanel:e}},[],import.meta.url);return t(e,Qm.definitions.filter(({id:e})=>e!==`menu`),e=>Qm.open(e),Ph)}});for(let{icon:e,label:t,hint:n,key:r,run:i}of Ph){let a=nm(e,t);a.title=`${n} (${r.toUpperCase()})`,a.className=`wide-only`,a.onclick=i,Dm(`panel-buttons`).append(a)}for(let{tool:e,key:t,label:n}of is)ph.register({key:t,label:n,run:()=>yh.choose(e)});for(let{id:e,key:t,title:n}of Qm.definitions)t&&ph.register({key:t,label:n,run:()=>Qm.toggle(e)});for(let{key:e,hint:t,run:n}of Ph)ph.register({key:e,label:t,run:n});addEventListener(`keydown`,e=>{if(e.ctrlKey||e.metaKey||e.altKey||Xp(e.target))return;if(e.key===`Escape`)return Fh();if($.keyDown(e.code)||e.target===Am&&X.key(e.code))return e.preventDefault();let t=e.target===document.body||e.target===Am;if(Ym&&e.key===` `&&t)return Rh.toggle();ph.run(e.key)&&e.preventDefault()}),addEventListener(`keyup`,e=>$.keyUp(e.code)),addEventListener(`blur`,()=>$.blur());function Fh(){if(Zm.close())return Am.focus();if($.entity!==0)return $.stopControlling();hh.cancel()||$m.stopFollowing()||Qm.closeNewest()}var Ih=0;function Lh(){let e=Q.frames.newest;return e?Math.max(0,(e.serverUs-Ih)/1e3):0}var Rh=new Bu(Dm(`timeline`));function zh(e){Ym=e,Rh.show(e),gh.enabled=e===void 0,document.documentElement.toggleAttribute(`data-recording`,e!==void 0),zm()}async function Bh(e,t){try{let n=new h(new Uint8Array(await t));n.truncationReason&&Vm.show(`${e}: incomplete recording: ${n.truncationReason}`);for(let{reason:t,length:r,snapshotsSkipped:i}of n.damage)Vm.show(`${e}: damaged recording: ${t}; ${r} bytes and ${i} snapshots are skipped`);$.stopControlling(),zh(new en(n)),nh(``)}catch(t){Vm.show(`${e}: ${Om(t)}`)}}addEventListener(`dragover`,e=>e.preventDefault()),addEventListener(`drop`,e=>{e.preventDefault();let t=e.dataTransfer?.files[0];t?.name.endsWith(`.json`)?Vh(t):t&&Bh(t.name,t.arrayBuffer())});async function Vh(e){for(Qm.open(`worlds`);!Mh;)await new Promise(e=>setTimeout(e,50));await Mh.upload(e)}async function Hh(e){let t=await fetch(e);if(!t.ok)throw Error(`the server responded with HTTP status ${t.status}`);return t.arrayBuffer()}var Uh;function Wh(){let e=Q.welcome?.worldId;Q.state===`playing`&&e!==Uh&&Nm.count!==0&&(Uh=e,X.setPlanar(Q.welcome?.planar??!1),Gh(Q.welcome?.view)||X.frame(Z.extent()),qh())}function Gh(e){let{eye:t,target:n,fieldOfView:r=0}=e??{};if(!t||!n)return!1;let[i,a]=[new j(t.x,t.y,t.z),new j(n.x,n.y,n.z)],o=i.distanceTo(a);if(!(o>.001&&o<1e6))return!1;let s=r*180/Math.PI;return X.setView(i,a,s>=5&&s<=150?s:0),!0}function Kh(){$.entity===0&&X.frame(Z.extent(),!0)}function qh(){if(X.planar)return;let{position:e}=X.camera,t=Ho(Z,e.x,e.z);t!==void 0&&(e.y=Math.max(e.y,t+3))}function Jh(e){let[t,n,r,i]=[e[3],e[4],e[5],e[6]];return Math.atan2(2*(t*r+i*n),1-2*(t*t+n*n))}function Yh(e){$.takeControl(e),X.startApproach(Th.steeringOf(e)?.distance??8)}function Xh(e){let t=$.entity!==0&&fh;if(document.documentElement.toggleAttribute(`data-touch-driving`,t),ch.show(t?Th.steeringOf($.entity)?.buttons??[`1`,`2`]:void 0),$.entity===0)return;let n=Mo(navigator.getGamepads().find(e=>e!==null&&e.mapping===`standard`)??void 0,t?ch:void 0);$.update(n,Fo(X.camera.getWorldDirection(new j)),performance.now());let r=Z.poseOf($.entity);if(!r)return;let i=Th.steeringOf($.entity)?.camera!==`free`;X.follow(r,i?Jh(r):void 0,e)}function Zh(){return $.entity===0||Th.steeringOf($.entity)?.camera!==`free`?1/0:Vo(Z,X.controls.target,X.camera.position,$.entity)}function Qh(){let{frame:t=0,channels:n=e}=Nm.source??{},{channels:r=[],tickHz:i=60}=Q.welcome??{};return{frame:t,channels:n,secondsAfter:Nm.secondsFromSource,kinds:r,tickHz:i}}var $h=e=>Z.poseOf(e);function eg(e){Th.debug=Ah?.on.fields??!1,Th.update(e,{nowMs:performance.now(),cameraTarget:X.controls.target,poseOf:$h,entityOf:e=>Q.entities.get(e),decorate:e=>{gh.tool===`drive`&&$.entity===0&&ol(e,uh,$h,performance.now()),lh.draw(e,gh.grab,$h,X.distance,performance.now()),$m.draw(e,$h)}})}function tg(e){let t=Th.bodyColors(e,dh,Q.entities);dh=!1,t&&Z.setBodyColors(t)}function ng(){xh.update({toolSelected:gh.tool===`drive`,controlled:Q.entities.get($.entity),keys:Th.steeringOf($.entity)?.keys??``,status:Th.controlledStatusText($.entity),worldStatus:Th.statusText()||rl(uh,fh),touch:fh},uh)}function rg(e){let t=v();Ih=Ym?Ym.advance(t):Q.renderClock.advance(t),Nm.update(Q.frames,Ih,t),Ym||ih?.applyTo(Nm,Q.inputClock.position(t),t),Rh.update();let n=Qh();tg(n),Z.update(Nm),wh.update(Z),hh.update(),mh.update(),Wh(),X.update(e),eg(n),Q.samplePoints(Ih),Eh.update(Q.points.objects,$h),ng(),Ah?.update(),Qm.update(),Ch.update(performance.now()),Xh(e),$m.update(e),Q.setInterestFocus(X.controls.target.x,X.controls.target.z),Mm.update(X.controls.target,X.distance,X.planar),Dh.update(X.viewHeight/innerHeight)}var ig=performance.now();jm.setAnimationLoop(()=>{let e=performance.now(),t=Math.min(.5,(e-ig)/1e3);ig=e,Fm?.frame(e)&&Lm(Uf[Fm.level]),rg(t);let n=Zh();Pm.add(performance.now()-e),X.renderWithin(n,()=>jm.render(Z.scene,X.camera)),kh?.frameRendered()}),Lm(Im),bh(`drag`),addEventListener(`resize`,Rm),new ResizeObserver(zm).observe(Dm(`bottom`)),$m.askForName(),Qm.isNarrow||Qm.open(`stats`),km.recording?Bh(km.recording,Hh(km.recording)):nh(km.world,$m.joinCodes.get(km.world)),wo({people:$m,connection:Q,view:Z,moduleView:Th,pointObjectsView:Eh,camera:X,driving:$,frameTimes:Pm,jointView:wh,sandbox:hh,room:mh,stats:()=>Oh,qualityName:()=>Im.name,recording:()=>Ym,prediction:()=>ih,controllableEntities:()=>uh.map(({id:e})=>e)});export{Go as _,bu as a,Tu as c,Vl as d,sl as f,ns as g,$o as h,yu as i,tu as l,Qo as m,rd as n,vu as o,es as p,nd as r,_u as s,nm as t,Yl as u};