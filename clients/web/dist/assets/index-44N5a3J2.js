(function(){let e=document.createElement(`link`).relList;if(e&&e.supports&&e.supports(`modulepreload`))return;for(let e of document.querySelectorAll(`link[rel="modulepreload"]`))n(e);new MutationObserver(e=>{for(let t of e)if(t.type===`childList`)for(let e of t.addedNodes)e.tagName===`LINK`&&e.rel===`modulepreload`&&n(e)}).observe(document,{childList:!0,subtree:!0});function t(e){let t={};return e.integrity&&(t.integrity=e.integrity),e.referrerPolicy&&(t.referrerPolicy=e.referrerPolicy),t.credentials=e.crossOrigin===`use-credentials`?`include`:e.crossOrigin===`anonymous`?`omit`:`same-origin`,t}function n(e){if(e.ep)return;e.ep=!0;let n=t(e);fetch(e.href,n)}})();var e=3e7,t=class{samples=[];offset=0;add(t,n,r){let i=r-t;i<0||(this.samples.push({offset:n-t-i/2,rtt:i,at:r}),this.samples=this.samples.filter(t=>t.at+e>=r),this.offset=this.samples.reduce((e,t)=>t.rtt<e.rtt?t:e).offset)}get ready(){return this.samples.length>0}serverUs(e){return e+this.offset}get rttMs(){return this.samples.length===0?0:Math.min(...this.samples.map(e=>e.rtt))/1e3}reset(){this.samples=[],this.offset=0}};function n(){return performance.now()*1e3}function r(e,t){return typeof e==`object`&&e&&`$typeName`in e&&typeof e.$typeName==`string`?t===void 0||t.typeName===e.$typeName:!1}var i;(function(e){e[e.DOUBLE=1]=`DOUBLE`,e[e.FLOAT=2]=`FLOAT`,e[e.INT64=3]=`INT64`,e[e.UINT64=4]=`UINT64`,e[e.INT32=5]=`INT32`,e[e.FIXED64=6]=`FIXED64`,e[e.FIXED32=7]=`FIXED32`,e[e.BOOL=8]=`BOOL`,e[e.STRING=9]=`STRING`,e[e.BYTES=12]=`BYTES`,e[e.UINT32=13]=`UINT32`,e[e.SFIXED32=15]=`SFIXED32`,e[e.SFIXED64=16]=`SFIXED64`,e[e.SINT32=17]=`SINT32`,e[e.SINT64=18]=`SINT64`})(i||={});function a(){let e=this.buf,t=this.pos,n=0,r=0;for(let i=0;i<28;i+=7){let a=e[t++];if(n|=(a&127)<<i,!(a&128)){this.pos=t,this.assertBounds(),this.varint64Lo=n,this.varint64Hi=r;return}}let i=e[t++];if(n|=(i&15)<<28,r=(i&112)>>4,!(i&128))this.pos=t,this.assertBounds(),this.varint64Lo=n,this.varint64Hi=r;else{for(let i=3;i<=31;i+=7){let a=e[t++];if(r|=(a&127)<<i,!(a&128)){this.pos=t,this.assertBounds(),this.varint64Lo=n,this.varint64Hi=r;return}}throw Error(`invalid varint`)}}var o=4294967296;function s(e){let t=e[0]===`-`;t&&(e=e.slice(1));let n=1e6,r=0,i=0;function a(t,a){let s=Number(e.slice(t,a));i*=n,r=r*n+s,r>=o&&(i+=r/o|0,r%=o)}return a(-24,-18),a(-18,-12),a(-12,-6),a(-6),t?f(r,i):d(r,i)}function c(e,t){let n=d(e,t),r=n.hi&2147483648;r&&(n=f(n.lo,n.hi));let i=l(n.lo,n.hi);return r?`-`+i:i}function l(e,t){if({lo:e,hi:t}=u(e,t),t<=2097151)return String(o*t+e);let n=e&16777215,r=(e>>>24|t<<8)&16777215,i=t>>16&65535,a=n+r*6777216+i*6710656,s=r+i*8147497,c=i*2,l=1e7;return a>=l&&(s+=Math.floor(a/l),a%=l),s>=l&&(c+=Math.floor(s/l),s%=l),c.toString()+p(s)+p(a)}function u(e,t){return{lo:e>>>0,hi:t>>>0}}function d(e,t){return{lo:e|0,hi:t|0}}function f(e,t){return t=~t,e?e=~e+1:t+=1,d(e,t)}var p=e=>{let t=String(e);return`0000000`.slice(t.length)+t};function m(e,t){if(e>>>0<128)t.push(e);else if(e>=0){for(;e>127;)t.push(e&127|128),e>>>=7;t.push(e)}else{for(let n=0;n<9;n++)t.push(e&127|128),e>>=7;t.push(1)}}function h(){let e=this.buf[this.pos++];if(!(e&128))return this.assertBounds(),e;let t=e&127;if(e=this.buf[this.pos++],t|=(e&127)<<7,!(e&128)||(e=this.buf[this.pos++],t|=(e&127)<<14,!(e&128))||(e=this.buf[this.pos++],t|=(e&127)<<21,!(e&128)))return this.assertBounds(),t;e=this.buf[this.pos++],t|=(e&15)<<28;for(let t=5;e&128&&t<10;t++)e=this.buf[this.pos++];if(e&128)throw Error(`invalid varint`);return this.assertBounds(),t>>>0}var g=_();function _(){let e=new DataView(new ArrayBuffer(8));if(typeof BigInt==`function`&&typeof e.getBigInt64==`function`&&typeof e.getBigUint64==`function`&&typeof e.setBigInt64==`function`&&typeof e.setBigUint64==`function`&&(globalThis.Deno||globalThis.Bun||typeof process!=`object`||{}.BUF_BIGINT_DISABLE!==`1`)){let t=BigInt(`-9223372036854775808`),n=BigInt(`9223372036854775807`),r=BigInt(`0`),i=BigInt(`18446744073709551615`);return{zero:BigInt(0),supported:!0,parse(e){let r=typeof e==`bigint`?e:BigInt(e);if(r>n||r<t)throw Error(`invalid int64: ${e}`);return r},uParse(e){let t=typeof e==`bigint`?e:BigInt(e);if(t>i||t<r)throw Error(`invalid uint64: ${e}`);return t},enc(t){return e.setBigInt64(0,this.parse(t),!0),{lo:e.getInt32(0,!0),hi:e.getInt32(4,!0)}},uEnc(t){return e.setBigInt64(0,this.uParse(t),!0),{lo:e.getInt32(0,!0),hi:e.getInt32(4,!0)}},dec(t,n){return e.setInt32(0,t,!0),e.setInt32(4,n,!0),e.getBigInt64(0,!0)},uDec(t,n){return e.setInt32(0,t,!0),e.setInt32(4,n,!0),e.getBigUint64(0,!0)}}}return{zero:`0`,supported:!1,parse(e){return typeof e!=`string`&&(e=e.toString()),v(e),e},uParse(e){return typeof e!=`string`&&(e=e.toString()),y(e),e},enc(e){return typeof e!=`string`&&(e=e.toString()),v(e),s(e)},uEnc(e){return typeof e!=`string`&&(e=e.toString()),y(e),s(e)},dec(e,t){return c(e,t)},uDec(e,t){return l(e,t)}}}function v(e){if(!/^-?[0-9]+$/.test(e))throw Error(`invalid int64: `+e)}function y(e){if(!/^[0-9]+$/.test(e))throw Error(`invalid uint64: `+e)}function b(e,t){switch(e){case i.STRING:return``;case i.BOOL:return!1;case i.DOUBLE:case i.FLOAT:return 0;case i.INT64:case i.UINT64:case i.SFIXED64:case i.FIXED64:case i.SINT64:return t?`0`:g.zero;case i.BYTES:return new Uint8Array;default:return 0}}function x(e,t){switch(e){case i.BOOL:return t===!1;case i.STRING:return t===``;case i.BYTES:return t instanceof Uint8Array&&!t.byteLength;case i.DOUBLE:case i.FLOAT:return Object.is(t,0);default:return t==0}}var S=2,C=Symbol.for(`reflect unsafe local`);function w(e,t){let n=e[t.localName].case;return n===void 0?n:t.fields.find(e=>e.localName===n)}function T(e,t){let n=t.localName;if(t.oneof)return e[t.oneof.localName].case===n;if(t.presence!=S)return e[n]!==void 0&&Object.prototype.hasOwnProperty.call(e,n);switch(t.fieldKind){case`list`:return e[n].length>0;case`map`:return Object.keys(e[n]).length>0;case`scalar`:return!x(t.scalar,e[n]);case`enum`:return e[n]!==t.enum.values[0].number}throw Error(`message field with implicit presence`)}function E(e,t){return Object.prototype.hasOwnProperty.call(e,t)&&e[t]!==void 0}function D(e,t){if(t.oneof){let n=e[t.oneof.localName];return n.case===t.localName?n.value:void 0}return e[t.localName]}function O(e,t,n){t.oneof?e[t.oneof.localName]={case:t.localName,value:n}:e[t.localName]=n}function k(e,t,n){t===`__proto__`?Object.defineProperty(e,"__proto__",{value:n,writable:!0,enumerable:!0,configurable:!0}):e[t]=n}function A(e,t){return Object.prototype.hasOwnProperty.call(e,t)?e[t]:void 0}function j(e,t){let n=t.localName;if(t.oneof){let r=t.oneof.localName;e[r].case===n&&(e[r]={case:void 0})}else if(t.presence!=S)delete e[n];else switch(t.fieldKind){case`map`:e[n]={};break;case`list`:e[n]=[];break;case`enum`:e[n]=t.enum.values[0].number;break;case`scalar`:e[n]=b(t.scalar,t.longAsString)}}function M(e){return typeof e==`object`&&!!e&&!Array.isArray(e)}function N(e,t){if(M(e)&&C in e&&`add`in e&&`field`in e&&typeof e.field==`function`){if(t!==void 0){let n=t,r=e.field();return n.listKind==r.listKind&&n.scalar===r.scalar&&n.message?.typeName===r.message?.typeName&&n.enum?.typeName===r.enum?.typeName}return!0}return!1}function ee(e,t){if(M(e)&&C in e&&`has`in e&&`field`in e&&typeof e.field==`function`){if(t!==void 0){let n=t,r=e.field();return n.mapKey===r.mapKey&&n.mapKind==r.mapKind&&n.scalar===r.scalar&&n.message?.typeName===r.message?.typeName&&n.enum?.typeName===r.enum?.typeName}return!0}return!1}function te(e,t){return M(e)&&C in e&&`desc`in e&&M(e.desc)&&e.desc.kind===`message`&&(t===void 0||e.desc.typeName==t.typeName)}function P(e){return ae(e.$typeName)}function ne(e){let t=e.fields[0];return ae(e.typeName)&&t!==void 0&&t.fieldKind==`scalar`&&t.name==`value`&&t.number==1}function re(e){switch(e.typeName){case`google.protobuf.Any`:case`google.protobuf.Timestamp`:case`google.protobuf.Duration`:case`google.protobuf.FieldMask`:case`google.protobuf.Struct`:case`google.protobuf.Value`:case`google.protobuf.ListValue`:return!0;default:return ne(e)}}var ie=new Set([`google.protobuf.DoubleValue`,`google.protobuf.FloatValue`,`google.protobuf.Int64Value`,`google.protobuf.UInt64Value`,`google.protobuf.Int32Value`,`google.protobuf.UInt32Value`,`google.protobuf.BoolValue`,`google.protobuf.StringValue`,`google.protobuf.BytesValue`]);function ae(e){return ie.has(e)}var oe=999,se=998,ce=2;function F(e,t){return r(t,e)?t:ue(e)(t)}var le=new WeakMap;function ue(e){let t=le.get(e);return t===void 0&&(t=he(e),le.set(e,t)),t}var de=0,fe=1,pe=2,me=3;function he(e){let t=e.typeName,{properties:n,prototype:r}=ge(e);return e=>{let i;r===void 0?i={$typeName:t}:(i=Object.create(r),i.$typeName=t);for(let t=0;t<n.length;t++){let r=n[t],a=r.name,o=e?.[a];switch(r.kind){case de:o==null?r.constant!==void 0&&(i[a]=r.constant):i[a]=r.convert===void 0?o:r.convert(o);break;case fe:i[a]=r.convert!==void 0&&Array.isArray(o)?o.map(r.convert):o??[];break;case pe:if(r.convert===void 0||!M(o))i[a]=o??{};else{let e={},t=Object.keys(o);for(let n=0;n<t.length;n++)k(e,t[n],r.convert(o[t[n]]));i[a]=e}break;case me:{let e=o;if(e?.case!=null){let t=r.convert.get(e.case);if(t!==void 0){i[a]={case:e.case,value:t(e.value)};break}}i[a]={case:void 0};break}}}return i}}function ge(e){let t=[],n={},r=be(e);for(let a of e.members){let e=a.localName;if(a.kind==`oneof`)t.push({name:e,kind:me,constant:void 0,convert:_e(a)});else switch(a.fieldKind){case`message`:t.push({name:e,kind:de,constant:void 0,convert:ve(a)});break;case`list`:t.push({name:e,kind:fe,constant:void 0,convert:a.listKind==`message`?ve(a)??(e=>e):a.scalar==i.BYTES?ye:void 0});break;case`map`:t.push({name:e,kind:pe,constant:void 0,convert:a.mapKind==`message`?ve(a)??(e=>e):a.scalar==i.BYTES?ye:void 0});break;default:{let o=xe(a);t.push({name:e,kind:de,constant:a.presence==ce?o:void 0,convert:a.fieldKind==`scalar`&&a.scalar==i.BYTES?ye:void 0}),r&&(n[e]=o);break}}}return{properties:t,prototype:r?n:void 0}}function _e(e){let t=new Map;for(let n of e.fields){let e;n.fieldKind==`message`?e=ve(n):n.fieldKind==`scalar`&&n.scalar==i.BYTES&&(e=ye),t.set(n.localName,e??(e=>e))}return t}function ve(e){if(e.fieldKind==`message`&&!e.oneof&&ne(e.message))return e.message.fields[0].scalar==i.BYTES?ye:void 0;if(e.message.typeName==`google.protobuf.Struct`&&e.parent.typeName!==`google.protobuf.Value`)return;let t=e.message,n;return e=>!M(e)||r(e,t)?e:(n??=ue(t),n(e))}function ye(e){return Array.isArray(e)?new Uint8Array(e):e}function be(e){switch(e.file.edition){case oe:return!1;case se:return!0;default:return e.fields.some(e=>e.presence!=ce&&e.fieldKind!=`message`&&!e.oneof)}}function xe(e){let t=e.getDefaultValue();return t===void 0?e.fieldKind==`scalar`?b(e.scalar,e.longAsString):e.enum.values[0].number:e.fieldKind==`scalar`&&e.longAsString?t.toString():t}var Se=[`FieldValueInvalidError`,`FieldListRangeError`,`ForeignFieldError`],I=class extends Error{constructor(e,t,n=`FieldValueInvalidError`){super(t),this.name=n,this.field=()=>e}};function Ce(e){return e instanceof Error&&Se.includes(e.name)&&`field`in e&&typeof e.field==`function`}var L;function we(e){L=Object.assign(Object.assign({},e),{encodeUtf8Into:e.encodeUtf8Into??Te(e.encodeUtf8.bind(e))})}function R(){if(!L){let e=globalThis;if(!e.TextEncoder||!e.TextDecoder)throw Error(`encoding API missing: install TextEncoder and TextDecoder on globalThis`);let t=new e.TextEncoder,n=new e.TextDecoder(`utf-8`,{ignoreBOM:!0}),r,i={encodeUtf8(e){return t.encode(e)},decodeUtf8(t,i){return i?(r||=new e.TextDecoder(`utf-8`,{fatal:!0,ignoreBOM:!0}),r.decode(t)):n.decode(t)},checkUtf8(e){try{return!0}catch{return!1}}};t.encodeInto&&(i.encodeUtf8Into=t.encodeInto.bind(t));let a=String.prototype.isWellFormed;a&&(i.checkUtf8=e=>a.call(e)),we(i)}return L}function Te(e){return(t,n)=>{let r=e(t);return n.set(r),{written:r.byteLength}}}var z;(function(e){e[e.Varint=0]=`Varint`,e[e.Bit64=1]=`Bit64`,e[e.LengthDelimited=2]=`LengthDelimited`,e[e.StartGroup=3]=`StartGroup`,e[e.EndGroup=4]=`EndGroup`,e[e.Bit32=5]=`Bit32`})(z||={});var B=class{constructor(e){this.stackPos=[],this.encodeUtf8Into=e?Te(e):R().encodeUtf8Into,this.buffer=Oe,this.viewCache=ke,this.pos=0}ensureCapacity(e){let t=this.pos+e;if(t>this.buffer.length){let e=this.buffer.length||Ee;for(;e<t;)e*=2;let n=new Uint8Array(e);this.pos>0&&n.set(this.buffer),this.buffer=n}}view(){let e=this.buffer,t=this.viewCache;if(t.byteLength===e.byteLength)return t;let n=new DataView(e.buffer);return this.viewCache=n,n}finish(){let e=this.buffer.slice(0,this.pos);return this.pos=0,this.stackPos=[],e}fork(){return this.stackPos.push(this.pos),this.ensureCapacity(De),this.buffer[this.pos++]=0,this}join(){let e=this.stackPos.pop();if(e===void 0)throw Error(`invalid state, fork stack empty`);let t=this.pos-e-De,n=je(t);return n>De&&(this.ensureCapacity(n-De),this.buffer.copyWithin(e+n,e+De,this.pos)),this.pos=e,this.uint32(t),this.pos+=t,this}tag(e,t){return this.uint32((e<<3|t)>>>0)}raw(e){return this.ensureCapacity(e.length),this.buffer.set(e,this.pos),this.pos+=e.length,this}uint32(e){if(Pe(e),this.ensureCapacity(5),e<128)return this.buffer[this.pos++]=e,this;for(;e>127;)this.buffer[this.pos++]=e&127|128,e>>>=7;return this.buffer[this.pos++]=e,this}int32(e){if(Ne(e),e>=0)return this.uint32(e);this.ensureCapacity(10);for(let t=0;t<9;t++)this.buffer[this.pos++]=e&127|128,e>>=7;return this.buffer[this.pos++]=1,this}bool(e){return this.ensureCapacity(1),this.buffer[this.pos++]=+!!e,this}bytes(e){return this.uint32(e.byteLength),this.raw(e)}string(e){typeof e!=`string`&&(e=String(e));let t=e.length;if(t<=Ae){this.ensureCapacity(t+1);let n=this.buffer,r=this.pos;n[r++]=t;let i=0;for(;i<t;i++){let t=e.charCodeAt(i);if(t>127)break;n[r++]=t}if(i==t)return this.pos=r,this}this.ensureCapacity(t*3+5);let n=je(t),r=this.buffer,i=this.pos,{written:a}=this.encodeUtf8Into(e,r.subarray(i+n)),o=je(a);return o!=n&&r.copyWithin(i+o,i+n,i+n+a),this.uint32(a),this.pos+=a,this}float(e){return Fe(e),this.ensureCapacity(4),this.view().setFloat32(this.pos,e,!0),this.pos+=4,this}double(e){return this.ensureCapacity(8),this.view().setFloat64(this.pos,e,!0),this.pos+=8,this}fixed32(e){return Pe(e),this.ensureCapacity(4),this.view().setUint32(this.pos,e,!0),this.pos+=4,this}sfixed32(e){return Ne(e),this.ensureCapacity(4),this.view().setInt32(this.pos,e,!0),this.pos+=4,this}sint32(e){return Ne(e),this.uint32((e<<1^e>>31)>>>0)}sfixed64(e){let t=g.enc(e);this.ensureCapacity(8);let n=this.view();return n.setInt32(this.pos,t.lo,!0),n.setInt32(this.pos+4,t.hi,!0),this.pos+=8,this}fixed64(e){let t=g.uEnc(e);this.ensureCapacity(8);let n=this.view();return n.setInt32(this.pos,t.lo,!0),n.setInt32(this.pos+4,t.hi,!0),this.pos+=8,this}int64(e){let t=g.enc(e);return this.writeVarint64(t.lo,t.hi)}sint64(e){let t=g.enc(e),n=t.hi>>31,r=t.lo<<1^n,i=(t.hi<<1|t.lo>>>31)^n;return this.writeVarint64(r,i)}uint64(e){let t=g.uEnc(e);return this.writeVarint64(t.lo,t.hi)}writeVarint64(e,t){this.ensureCapacity(10);let n=this.buffer,r=this.pos;for(let i=0;i<28;i+=7){let a=e>>>i,o=!(!(a>>>7)&&t==0);if(n[r++]=(o?a|128:a)&255,!o)return this.pos=r,this}let i=e>>>28&15|(t&7)<<4,a=!!(t>>3);if(n[r++]=(a?i|128:i)&255,!a)return this.pos=r,this;for(let e=3;e<31;e+=7){let i=t>>>e,a=!!(i>>>7);if(n[r++]=(a?i|128:i)&255,!a)return this.pos=r,this}return n[r++]=t>>>31&1,this.pos=r,this}},Ee=128,De=1,Oe=new Uint8Array,ke=new DataView(Oe.buffer),Ae=32;function je(e){return e<128?1:e<16384?2:e<2097152?3:e<268435456?4:5}var Me=class{constructor(e,t=R().decodeUtf8){this.decodeUtf8=t,this.varint64Lo=0,this.varint64Hi=0,this.varint64=a,this.uint32=h,this.buf=e,this.len=e.length,this.pos=0,this.view=new DataView(e.buffer,e.byteOffset,e.byteLength)}tag(){let e=this.pos,t=this.uint32(),n=this.pos-e;if(n>5||n==5&&this.buf[this.pos-1]>15)throw Error(`illegal tag: varint overflows uint32`);let r=t>>>3,i=t&7;if(r<=0||i>5)throw Error(`illegal tag: field no `+r+` wire type `+i);return[r,i]}skip(e,t,n=100){let r=this.pos;switch(e){case z.Varint:for(;this.buf[this.pos++]&128;);break;case z.Bit64:this.pos+=4;case z.Bit32:this.pos+=4;break;case z.LengthDelimited:let r=this.uint32();this.pos+=r;break;case z.StartGroup:if(n<=0)throw Error(`maximum recursion depth reached`);for(;;){let[e,r]=this.tag();if(r===z.EndGroup){if(t!==void 0&&e!==t)throw Error(`invalid end group tag`);break}this.skip(r,e,n-1)}break;default:throw Error(`cant skip wire type `+e)}return this.assertBounds(),this.buf.subarray(r,this.pos)}assertBounds(){if(this.pos>this.len)throw RangeError(`premature EOF`)}int32(){return this.uint32()|0}sint32(){let e=this.uint32();return e>>>1^-(e&1)}int64(){return this.varint64(),g.dec(this.varint64Lo,this.varint64Hi)}uint64(){return this.varint64(),g.uDec(this.varint64Lo,this.varint64Hi)}sint64(){this.varint64();let e=this.varint64Lo,t=this.varint64Hi,n=-(e&1);return e=(e>>>1|(t&1)<<31)^n,t=t>>>1^n,g.dec(e,t)}bool(){let e=this.buf[this.pos];return e<128?(this.pos++,e!==0):(this.varint64(),this.varint64Lo!==0||this.varint64Hi!==0)}fixed32(){return this.view.getUint32((this.pos+=4)-4,!0)}sfixed32(){return this.view.getInt32((this.pos+=4)-4,!0)}fixed64(){return g.uDec(this.sfixed32(),this.sfixed32())}sfixed64(){return g.dec(this.sfixed32(),this.sfixed32())}float(){return this.view.getFloat32((this.pos+=4)-4,!0)}double(){return this.view.getFloat64((this.pos+=8)-8,!0)}bytes(){let e=this.uint32(),t=this.pos;return this.pos+=e,this.assertBounds(),this.buf.subarray(t,t+e)}string(e){let t=this.uint32(),n=this.pos;this.pos+=t,this.assertBounds();let r=this.buf;if(t<=Ae){let i=Array(t);for(let a=0;a<t;a++){let t=r[n+a];if(t>127)return this.decodeUtf8(r.subarray(n,this.pos),e);i[a]=t}return String.fromCharCode.apply(String,i)}return this.decodeUtf8(r.subarray(n,this.pos),e)}};function Ne(e){if(typeof e==`string`)e=Number(e);else if(typeof e!=`number`)throw Error(`invalid int32: `+typeof e);if(!Number.isInteger(e)||e>2147483647||e<-2147483648)throw Error(`invalid int32: `+e)}function Pe(e){if(typeof e==`string`)e=Number(e);else if(typeof e!=`number`)throw Error(`invalid uint32: `+typeof e);if(!Number.isInteger(e)||e>4294967295||e<0)throw Error(`invalid uint32: `+e)}function Fe(e){if(typeof e==`string`){let t=e;if(e=Number(e),Number.isNaN(e)&&t!==`NaN`)throw Error(`invalid float32: `+t)}else if(typeof e!=`number`)throw Error(`invalid float32: `+typeof e);if(!Number.isFinite(Math.fround(e))&&Number.isFinite(e))throw Error(`invalid float32: `+e)}function Ie(e,t){let n=e.fieldKind==`list`?N(t,e):e.fieldKind==`map`?ee(t,e):ze(e,t);if(n===!0)return;let r;switch(e.fieldKind){case`list`:r=`expected ${We(e)}, got ${He(t)}`;break;case`map`:r=`expected ${Ge(e)}, got ${He(t)}`;break;default:r=Ve(e,t,n)}return new I(e,r)}function Le(e,t,n){let r=ze(e,n);if(r!==!0)return new I(e,`list item #${t+1}: ${Ve(e,n,r)}`)}function Re(e,t,n){let r=Be(e.mapKey)(t);if(r!==!0)return new I(e,`invalid map key: ${Ve({scalar:e.mapKey},t,r)}`);let i=ze(e,n);if(i!==!0)return new I(e,`map entry ${He(t)}: ${Ve(e,n,i)}`)}function ze(e,t){return e.scalar===void 0?e.enum===void 0?te(t,e.message):e.enum.open?Be(i.INT32)(t):e.enum.values.some(e=>e.number===t):Be(e.scalar)(t)}function Be(e){switch(e){case i.DOUBLE:return e=>typeof e==`number`;case i.FLOAT:return e=>typeof e==`number`?!Number.isFinite(Math.fround(e))&&Number.isFinite(e)?`${e.toFixed()} out of range`:!0:!1;case i.INT32:case i.SFIXED32:case i.SINT32:return e=>typeof e!=`number`||!Number.isInteger(e)?!1:e>2147483647||e<-2147483648?`${e.toFixed()} out of range`:!0;case i.FIXED32:case i.UINT32:return e=>typeof e!=`number`||!Number.isInteger(e)?!1:e>4294967295||e<0?`${e.toFixed()} out of range`:!0;case i.BOOL:return e=>typeof e==`boolean`;case i.STRING:return e=>typeof e==`string`?R().checkUtf8(e)||`invalid UTF8`:!1;case i.BYTES:return e=>e instanceof Uint8Array;case i.INT64:case i.SFIXED64:case i.SINT64:return e=>{if(typeof e==`bigint`||typeof e==`number`||typeof e==`string`&&e.length>0)try{return g.parse(e),!0}catch{return`${e} out of range`}return!1};case i.FIXED64:case i.UINT64:return e=>{if(typeof e==`bigint`||typeof e==`number`||typeof e==`string`&&e.length>0)try{return g.uParse(e),!0}catch{return`${e} out of range`}return!1}}}function Ve(e,t,n){return n=typeof n==`string`?`: ${n}`:`, got ${He(t)}`,e.scalar===void 0?e.enum===void 0?`expected ${Ue(e.message)}`+n:`expected ${e.enum.toString()}`+n:`expected ${Ke(e.scalar)}`+n}function He(e){switch(typeof e){case`object`:return e===null?`null`:e instanceof Uint8Array?`Uint8Array(${e.length})`:Array.isArray(e)?`Array(${e.length})`:N(e)?We(e.field()):ee(e)?Ge(e.field()):te(e)?Ue(e.desc):r(e)?`message ${e.$typeName}`:`object`;case`string`:return e.length>30?`string`:`"${e.split(`"`).join(`\\"`)}"`;case`boolean`:return String(e);case`number`:return String(e);case`bigint`:return String(e)+`n`;default:return typeof e}}function Ue(e){return`ReflectMessage (${e.typeName})`}function We(e){switch(e.listKind){case`message`:return`ReflectList (${e.message.toString()})`;case`enum`:return`ReflectList (${e.enum.toString()})`;case`scalar`:return`ReflectList (${i[e.scalar]})`}}function Ge(e){switch(e.mapKind){case`message`:return`ReflectMap (${i[e.mapKey]}, ${e.message.toString()})`;case`enum`:return`ReflectMap (${i[e.mapKey]}, ${e.enum.toString()})`;case`scalar`:return`ReflectMap (${i[e.mapKey]}, ${i[e.scalar]})`}}function Ke(e){switch(e){case i.STRING:return`string`;case i.BOOL:return`boolean`;case i.INT64:case i.SINT64:case i.SFIXED64:return`bigint (int64)`;case i.UINT64:case i.FIXED64:return`bigint (uint64)`;case i.BYTES:return`Uint8Array`;case i.DOUBLE:return`number (float64)`;case i.FLOAT:return`number (float32)`;case i.FIXED32:case i.UINT32:return`number (uint32)`;case i.INT32:case i.SFIXED32:case i.SINT32:return`number (int32)`}}var qe=0;function Je(e){if(Ye(e))return{toMessage:e=>Xe(e),toLocal:e=>Ze(e)};if(e.fieldKind==`message`&&!e.oneof&&ne(e.message)){let t=e.message,n=t.fields[0].localName;return{toMessage:e=>{let r=F(t);return e!==void 0&&(r[n]=e),r},toLocal:e=>e[n]}}let t=e.message;return{toMessage:e=>e===void 0?F(t):e,toLocal:e=>e}}function Ye(e){return e.message.typeName==`google.protobuf.Struct`&&e.parent.typeName!=`google.protobuf.Value`}function Xe(e){let t={$typeName:`google.protobuf.Struct`,fields:{}};if(M(e))for(let n of Object.keys(e))k(t.fields,n,$e(e[n]));return t}function Ze(e){let t={};for(let n of Object.keys(e.fields))k(t,n,Qe(e.fields[n]));return t}function Qe(e){switch(e.kind.case){case`structValue`:return Ze(e.kind.value);case`listValue`:return e.kind.value.values.map(Qe);case`nullValue`:case void 0:return null;default:return e.kind.value}}function $e(e){let t={$typeName:`google.protobuf.Value`,kind:{case:void 0}};switch(typeof e){case`number`:t.kind={case:`numberValue`,value:e};break;case`string`:t.kind={case:`stringValue`,value:e};break;case`boolean`:t.kind={case:`boolValue`,value:e};break;case`object`:if(e===null)t.kind={case:`nullValue`,value:qe};else if(Array.isArray(e)){let n={$typeName:`google.protobuf.ListValue`,values:[]};if(Array.isArray(e))for(let t of e)n.values.push($e(t));t.kind={case:`listValue`,value:n}}else t.kind={case:`structValue`,value:Xe(e)}}return t}function et(e,t,n=!0){return new nt(e,t,n)}var tt=new WeakMap,nt=class{get sortedFields(){let e=tt.get(this.desc);if(e)return e;let t=this.desc.fields.concat().sort((e,t)=>e.number-t.number);return tt.set(this.desc,t),t}constructor(e,t,n=!0){this.lists=new Map,this.maps=new Map,this.check=n,this.desc=e,this.message=this[C]=t??F(e),this.fields=e.fields,this.oneofs=e.oneofs,this.members=e.members}findNumber(e){return this._fieldsByNumber||=new Map(this.desc.fields.map(e=>[e.number,e])),this._fieldsByNumber.get(e)}oneofCase(e){return rt(this.message,e),w(this.message,e)}isSet(e){return rt(this.message,e),T(this.message,e)}clear(e){rt(this.message,e),j(this.message,e)}get(e){rt(this.message,e);let t=D(this.message,e);switch(e.fieldKind){case`list`:let n=this.lists.get(e);return n&&n[C]===t||this.lists.set(e,n=new it(e,t,this.check)),n;case`map`:let r=this.maps.get(e);return r&&r[C]===t||this.maps.set(e,r=new at(e,t,this.check)),r;case`message`:return st(e,t,this.check);case`scalar`:return t===void 0?b(e.scalar,!1):mt(e,t);case`enum`:return t??e.enum.values[0].number}}set(e,t){if(rt(this.message,e),this.check){let n=Ie(e,t);if(n)throw n}let n;n=e.fieldKind==`message`?ot(e,t):ee(t)||N(t)?t[C]:ht(e,t),O(this.message,e,n)}getUnknown(){return this.message.$unknown}setUnknown(e){this.message.$unknown=e}};function rt(e,t){if(t.parent.typeName!==e.$typeName)throw new I(t,`cannot use ${t.toString()} with message ${e.$typeName}`,`ForeignFieldError`)}var it=class{field(){return this._field}get size(){return this._arr.length}constructor(e,t,n){this._field=e,this._arr=this[C]=t,this.check=n}get(e){let t=this._arr[e];return t===void 0?void 0:lt(this._field,t,this.check)}set(e,t){if(e<0||e>=this._arr.length)throw new I(this._field,`list item #${e+1}: out of range`);if(this.check){let n=Le(this._field,e,t);if(n)throw n}this._arr[e]=ct(this._field,t)}add(e){if(this.check){let t=Le(this._field,this._arr.length,e);if(t)throw t}this._arr.push(ct(this._field,e))}clear(){this._arr.splice(0,this._arr.length)}[Symbol.iterator](){return this.values()}keys(){return this._arr.keys()}*values(){for(let e of this._arr)yield lt(this._field,e,this.check)}*entries(){for(let e=0;e<this._arr.length;e++)yield[e,lt(this._field,this._arr[e],this.check)]}},at=class{constructor(e,t,n=!0){this.obj=this[C]=t??{},this.check=n,this._field=e}field(){return this._field}set(e,t){if(this.check){let n=Re(this._field,e,t);if(n)throw n}return k(this.obj,ft(e),ut(this._field,t)),this}delete(e){let t=ft(e),n=Object.prototype.hasOwnProperty.call(this.obj,t);return n&&delete this.obj[t],n}clear(){for(let e of Object.keys(this.obj))delete this.obj[e]}get(e){let t=A(this.obj,ft(e));return t!==void 0&&(t=dt(this._field,t,this.check)),t}has(e){return Object.prototype.hasOwnProperty.call(this.obj,ft(e))}*keys(){for(let e of Object.keys(this.obj))yield pt(e,this._field.mapKey)}*entries(){for(let e of Object.entries(this.obj))yield[pt(e[0],this._field.mapKey),dt(this._field,e[1],this.check)]}[Symbol.iterator](){return this.entries()}get size(){return Object.keys(this.obj).length}*values(){for(let e of Object.values(this.obj))yield dt(this._field,e,this.check)}forEach(e,t){for(let n of this.entries())e.call(t,n[1],n[0],this)}};function ot(e,t){return te(t)?P(t.message)&&!e.oneof&&e.fieldKind==`message`?t.message.value:t.desc.typeName==`google.protobuf.Struct`&&e.parent.typeName!=`google.protobuf.Value`?Ze(t.message):t.message:t}function st(e,t,n){return t!==void 0&&(ne(e.message)&&!e.oneof&&e.fieldKind==`message`?t={$typeName:e.message.typeName,value:mt(e.message.fields[0],t)}:e.message.typeName==`google.protobuf.Struct`&&e.parent.typeName!=`google.protobuf.Value`&&M(t)&&(t=Xe(t))),new nt(e.message,t,n)}function ct(e,t){return e.listKind==`message`?ot(e,t):ht(e,t)}function lt(e,t,n){return e.listKind==`message`?st(e,t,n):mt(e,t)}function ut(e,t){return e.mapKind==`message`?ot(e,t):ht(e,t)}function dt(e,t,n){return e.mapKind==`message`?st(e,t,n):t}function ft(e){return typeof e==`string`||typeof e==`number`?e:String(e)}function pt(e,t){switch(t){case i.STRING:return e;case i.INT32:case i.FIXED32:case i.UINT32:case i.SFIXED32:case i.SINT32:{let t=Number.parseInt(e);if(Number.isFinite(t))return t;break}case i.BOOL:switch(e){case`true`:return!0;case`false`:return!1}break;case i.UINT64:case i.FIXED64:try{return g.uParse(e)}catch{}break;default:try{return g.parse(e)}catch{}}return e}function mt(e,t){switch(e.scalar){case i.INT64:case i.SFIXED64:case i.SINT64:`longAsString`in e&&e.longAsString&&typeof t==`string`&&(t=g.parse(t));break;case i.FIXED64:case i.UINT64:`longAsString`in e&&e.longAsString&&typeof t==`string`&&(t=g.uParse(t))}return t}function ht(e,t){switch(e.scalar){case i.INT64:case i.SFIXED64:case i.SINT64:`longAsString`in e&&e.longAsString?t=String(t):(typeof t==`string`||typeof t==`number`)&&(t=g.parse(t));break;case i.FIXED64:case i.UINT64:`longAsString`in e&&e.longAsString?t=String(t):(typeof t==`string`||typeof t==`number`)&&(t=g.uParse(t))}return t}var gt=Uint8Array.prototype.setFromBase64;function _t(e){let t=e.length,n=t-(t+3>>2);!(t&3)&&e[t-1]==`=`&&(n-=e[t-2]==`=`?2:1);let r=new Uint8Array(n),i=-1;if(gt)try{let n=gt.call(r,e);n.read==t&&(i=n.written)}catch{}return i<0&&(i=vt(r,e)),i==n?r:r.subarray(0,i)}function vt(e,t){let n=Et(),r=0,i=0,a,o=0;for(let s=0;s<t.length;s++){if(a=n[t.charCodeAt(s)],a===void 0)switch(t[s]){case`=`:i=0;case`
`:case`\r`:case`	`:case` `:continue;default:throw Error(`invalid base64 string`)}switch(i){case 0:o=a,i=1;break;case 1:e[r++]=o<<2|(a&48)>>4,o=a,i=2;break;case 2:e[r++]=(o&15)<<4|(a&60)>>2,o=a,i=3;break;case 3:e[r++]=(o&3)<<6|a,i=0}}if(i==1)throw Error(`invalid base64 string`);return r}var yt=Uint8Array.prototype.toBase64,bt={std:{alphabet:`base64`,omitPadding:!1},std_raw:{alphabet:`base64`,omitPadding:!0},url:{alphabet:`base64url`,omitPadding:!0}};function xt(e,t=`std`){if(yt)return yt.call(e,bt[t]);let n=Tt(t),r=t==`std`,i=``,a=0,o,s=0;for(let t=0;t<e.length;t++)switch(o=e[t],a){case 0:i+=n[o>>2],s=(o&3)<<4,a=1;break;case 1:i+=n[s|o>>4],s=(o&15)<<2,a=2;break;case 2:i+=n[s|o>>6],i+=n[o&63],a=0}return a&&(i+=n[s],r&&(i+=`=`,a==1&&(i+=`=`))),i}var St,Ct,wt;function Tt(e){return St||(St=`ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/`.split(``),Ct=St.slice(0,-2).concat(`-`,`_`)),e==`url`?Ct:St}function Et(){if(!wt){wt=[];let e=Tt(`std`);for(let t=0;t<e.length;t++)wt[e[t].charCodeAt(0)]=t;wt[45]=e.indexOf(`+`),wt[95]=e.indexOf(`/`)}return wt}function Dt(e){let t=!1,n=[];for(let r=0;r<e.length;r++){let i=e.charAt(r);switch(i){case`_`:t=!0;break;case`0`:case`1`:case`2`:case`3`:case`4`:case`5`:case`6`:case`7`:case`8`:case`9`:n.push(i),t=!1;break;default:t&&(t=!1,i=i.toUpperCase()),n.push(i)}}return n.join(``)}function Ot(e){return e.replace(/[A-Z]/g,e=>`_`+e.toLowerCase())}var kt=new Set([`constructor`,`toString`,`toJSON`,`valueOf`]);function At(e){return kt.has(e)?e+`$`:e}function jt(e){for(let t of e.field)E(t,`jsonName`)||(t.jsonName=Dt(t.name));e.nestedType.forEach(jt)}function Mt(e,t){let n=e.values.find(e=>e.name===t);if(!n)throw Error(`cannot parse ${e} default value: ${t}`);return n.number}function Nt(e,t){switch(e){case i.STRING:return t;case i.BYTES:{let n=Pt(t);if(n===!1)throw Error(`cannot parse ${i[e]} default value: ${t}`);return n}case i.INT64:case i.SFIXED64:case i.SINT64:return g.parse(t);case i.UINT64:case i.FIXED64:return g.uParse(t);case i.DOUBLE:case i.FLOAT:switch(t){case`inf`:return 1/0;case`-inf`:return-1/0;case`nan`:return NaN;default:return parseFloat(t)}case i.BOOL:return t===`true`;case i.INT32:case i.UINT32:case i.SINT32:case i.FIXED32:case i.SFIXED32:return parseInt(t,10)}}function Pt(e){let t=[],n={tail:e,c:``,next(){return this.tail.length!=0&&(this.c=this.tail[0],this.tail=this.tail.substring(1),!0)},take(e){if(this.tail.length>=e){let t=this.tail.substring(0,e);return this.tail=this.tail.substring(e),t}return!1}};for(;n.next();)switch(n.c){case`\\`:if(n.next())switch(n.c){case`\\`:t.push(n.c.charCodeAt(0));break;case`b`:t.push(8);break;case`f`:t.push(12);break;case`n`:t.push(10);break;case`r`:t.push(13);break;case`t`:t.push(9);break;case`v`:t.push(11);break;case`0`:case`1`:case`2`:case`3`:case`4`:case`5`:case`6`:case`7`:{let e=n.c,r=n.take(2);if(r===!1)return!1;let i=parseInt(e+r,8);if(Number.isNaN(i))return!1;t.push(i);break}case`x`:{let e=n.c,r=n.take(2);if(r===!1)return!1;let i=parseInt(e+r,16);if(Number.isNaN(i))return!1;t.push(i);break}case`u`:{let e=n.c,r=n.take(4);if(r===!1)return!1;let i=parseInt(e+r,16);if(Number.isNaN(i))return!1;let a=new Uint8Array(4);new DataView(a.buffer).setInt32(0,i,!0),t.push(a[0],a[1],a[2],a[3]);break}case`U`:{let e=n.c,r=n.take(8);if(r===!1)return!1;let i=g.uEnc(e+r),a=new Uint8Array(8),o=new DataView(a.buffer);o.setInt32(0,i.lo,!0),o.setInt32(4,i.hi,!0),t.push(a[0],a[1],a[2],a[3],a[4],a[5],a[6],a[7]);break}}break;default:t.push(n.c.charCodeAt(0))}return new Uint8Array(t)}function*Ft(e){switch(e.kind){case`file`:for(let t of e.messages)yield t,yield*Ft(t);yield*e.enums,yield*e.services,yield*e.extensions;break;case`message`:for(let t of e.nestedMessages)yield t,yield*Ft(t);yield*e.nestedEnums,yield*e.nestedExtensions}}function It(e,t){return Lt([e,t])}function Lt(e,t){let n=Rt();if(!e.length)return n;if(`$typeName`in e[0]&&e[0].$typeName==`google.protobuf.FileDescriptorSet`){for(let r of e[0].file)t?.(r),sn(r,n);return n}if(`$typeName`in e[0]){let r=e[0],i=e[1],a=new Set;function o(e){let t=[];for(let r of e.dependency){if(n.getFile(r)!=null||a.has(r))continue;let o=i(r);if(!o)throw Error(`Unable to resolve ${r}, imported by ${e.name}`);`kind`in o?n.addFile(o,!1,!0):(a.add(o.name),t.push(o))}return t.concat(...t.map(o))}for(let e of[r,...o(r)].reverse())t?.(e),sn(e,n)}else for(let t of e)for(let e of t.files)n.addFile(e);return n}function Rt(){let e=new Map,t=new Map,n=new Map;return{kind:`registry`,types:e,extendees:t,[Symbol.iterator](){return e.values()},get files(){return n.values()},addFile(e,t,r){if(n.set(e.proto.name,e),!t)for(let t of Ft(e))this.add(t);if(r)for(let n of e.dependencies)this.addFile(n,t,r)},add(n){if(n.kind==`extension`){let e=t.get(n.extendee.typeName);e||t.set(n.extendee.typeName,e=new Map),e.set(n.number,n)}e.set(n.typeName,n)},get(t){return e.get(t)},getFile(e){return n.get(e)},getMessage(t){let n=e.get(t);return n?.kind==`message`?n:void 0},getEnum(t){let n=e.get(t);return n?.kind==`enum`?n:void 0},getExtension(t){let n=e.get(t);return n?.kind==`extension`?n:void 0},getExtensionFor(e,n){return t.get(e.typeName)?.get(n)},getService(t){let n=e.get(t);return n?.kind==`service`?n:void 0}}}var zt=998,Bt=999,Vt=9999,Ht=9,Ut=10,Wt=11,Gt=12,Kt=14,qt=3,Jt=2,Yt=1,Xt=0,Zt=1,Qt=2,$t=3,en=1,tn=2,nn=1,rn=2,an=1002,on={998:{fieldPresence:1,enumType:2,repeatedFieldEncoding:2,utf8Validation:3,messageEncoding:1,jsonFormat:2,enforceNamingStyle:2,defaultSymbolVisibility:1,enforceProtoLimits:1},999:{fieldPresence:2,enumType:1,repeatedFieldEncoding:1,utf8Validation:2,messageEncoding:1,jsonFormat:1,enforceNamingStyle:2,defaultSymbolVisibility:1,enforceProtoLimits:1},1e3:{fieldPresence:1,enumType:1,repeatedFieldEncoding:1,utf8Validation:2,messageEncoding:1,jsonFormat:1,enforceNamingStyle:2,defaultSymbolVisibility:1,enforceProtoLimits:1},1001:{fieldPresence:1,enumType:1,repeatedFieldEncoding:1,utf8Validation:2,messageEncoding:1,jsonFormat:1,enforceNamingStyle:1,defaultSymbolVisibility:2,enforceProtoLimits:1},1002:{fieldPresence:1,enumType:1,repeatedFieldEncoding:1,utf8Validation:2,messageEncoding:1,jsonFormat:1,enforceNamingStyle:3,defaultSymbolVisibility:4,enforceProtoLimits:2}};function sn(e,t){let n={kind:`file`,proto:e,deprecated:e.options?.deprecated??!1,edition:gn(e),name:e.name.replace(/\.proto$/,``),dependencies:_n(e,t),enums:[],messages:[],extensions:[],services:[],toString(){return`file ${e.name}`}},r=new Map,i={get(e){return r.get(e)},add(e){jn(e.proto.options?.mapEntry===!0),r.set(e.typeName,e)}};for(let r of e.enumType)un(r,n,void 0,t);for(let r of e.messageType)dn(r,n,void 0,t,i);for(let r of e.service)fn(r,n,t);cn(n,t);for(let e of r.values())ln(e,t,i);for(let e of n.messages)ln(e,t,i),cn(e,t);t.addFile(n,!0)}function cn(e,t){switch(e.kind){case`file`:for(let n of e.proto.extension){let r=hn(n,e,t);e.extensions.push(r),t.add(r)}break;case`message`:for(let n of e.proto.extension){let r=hn(n,e,t);e.nestedExtensions.push(r),t.add(r)}for(let n of e.nestedMessages)cn(n,t)}}function ln(e,t,n){let r=e.proto.oneofDecl.map(t=>mn(t,e)),i=new Set;for(let a of e.proto.field){let o=Cn(a,r),s=hn(a,e,t,o,n);e.fields.push(s),e.field[s.localName]=s,o===void 0?e.members.push(s):(o.fields.push(s),i.has(o)||(i.add(o),e.members.push(o)))}for(let t of r.filter(e=>i.has(e)))e.oneofs.push(t);for(let r of e.nestedMessages)ln(r,t,n)}function un(e,t,n,r){var i,a;let o=vn(e.name,e.value),s={kind:`enum`,proto:e,deprecated:e.options?.deprecated??!1,file:t,parent:n,open:!0,name:e.name,typeName:xn(e,n,t),value:{},values:[],sharedPrefix:o,toString(){return`enum ${this.typeName}`}};s.open=Dn(s),r.add(s);for(let t of e.value){let e=t.name,n={kind:`enum_value`,proto:t,deprecated:t.options?.deprecated??!1,parent:s,name:e,localName:At(o==null?e:e.substring(o.length)),number:t.number,jsonName:yn(t)??e,toString(){return`enum value ${s.typeName}.${e}`}};s.values.push(n),(i=s.value)[a=t.number]??(i[a]=n)}(n?.nestedEnums??t.enums).push(s)}function dn(e,t,n,r,i){let a={kind:`message`,proto:e,deprecated:e.options?.deprecated??!1,file:t,parent:n,name:e.name,typeName:xn(e,n,t),fields:[],field:{},oneofs:[],members:[],nestedEnums:[],nestedMessages:[],nestedExtensions:[],toString(){return`message ${this.typeName}`}};e.options?.mapEntry===!0?i.add(a):((n?.nestedMessages??t.messages).push(a),r.add(a));for(let n of e.enumType)un(n,t,a,r);for(let n of e.nestedType)dn(n,t,a,r,i)}function fn(e,t,n){let r={kind:`service`,proto:e,deprecated:e.options?.deprecated??!1,file:t,name:e.name,typeName:xn(e,void 0,t),methods:[],method:{},toString(){return`service ${this.typeName}`}};t.services.push(r),n.add(r);for(let t of e.method){let e=pn(t,r,n);r.methods.push(e),r.method[e.localName]=e}}function pn(e,t,n){let r;r=e.clientStreaming&&e.serverStreaming?`bidi_streaming`:e.clientStreaming?`client_streaming`:e.serverStreaming?`server_streaming`:`unary`;let i=n.getMessage(Sn(e.inputType)),a=n.getMessage(Sn(e.outputType));jn(i,`invalid MethodDescriptorProto: input_type ${e.inputType} not found`),jn(a,`invalid MethodDescriptorProto: output_type ${e.inputType} not found`);let o=e.name;return{kind:`rpc`,proto:e,deprecated:e.options?.deprecated??!1,parent:t,name:o,localName:At(o.length?At(o[0].toLowerCase()+o.substring(1)):o),methodKind:r,input:i,output:a,idempotency:e.options?.idempotencyLevel??Xt,toString(){return`rpc ${t.typeName}.${o}`}}}function mn(e,t){return{kind:`oneof`,proto:e,deprecated:!1,parent:t,fields:[],name:e.name,localName:At(Dt(e.name)),toString(){return`oneof ${t.typeName}.${this.name}`}}}function hn(e,t,n,r,i){let a=i===void 0,o={kind:`field`,proto:e,deprecated:e.options?.deprecated??!1,name:e.name,number:e.number,scalar:void 0,message:void 0,enum:void 0,presence:wn(e,r,a,t),utf8Validation:kn(e,t),listKind:void 0,mapKind:void 0,mapKey:void 0,delimitedEncoding:void 0,packed:void 0,longAsString:!1,getDefaultValue:void 0},s;if(a){let r=t.kind==`file`?t:t.file,i=t.kind==`file`?void 0:t,a=xn(e,i,r);o.kind=`extension`,o.file=r,o.parent=i,o.oneof=void 0,o.typeName=a,o.jsonName=`[${a}]`,s=()=>`extension ${a}`;let c=n.getMessage(Sn(e.extendee));jn(c,`invalid FieldDescriptorProto: extendee ${e.extendee} not found`),o.extendee=c}else{let n=t;jn(n.kind==`message`),o.parent=n,o.oneof=r,o.localName=r?Dt(e.name):At(Dt(e.name)),o.jsonName=e.jsonName,s=()=>`field ${n.typeName}.${e.name}`}Object.defineProperty(o,"toString",{value:s,writable:!0,enumerable:!0,configurable:!0});let c=e.label,l=e.type,u=e.options?.jstype;if(c===qt){let r=l==Wt?i?.get(Sn(e.typeName)):void 0;if(r){o.fieldKind=`map`;let{key:e,value:t}=En(r);return o.mapKey=e.scalar,o.mapKind=t.fieldKind,o.message=t.message,o.delimitedEncoding=!1,o.enum=t.enum,o.scalar=t.scalar,o}switch(o.fieldKind=`list`,l){case Wt:case Ut:o.listKind=`message`,o.message=n.getMessage(Sn(e.typeName)),jn(o.message),o.delimitedEncoding=On(e,t);break;case Kt:o.listKind=`enum`,o.enum=n.getEnum(Sn(e.typeName)),jn(o.enum);break;default:o.listKind=`scalar`,o.scalar=l,o.longAsString=u==Yt}return o.packed=Tn(e,t),o}switch(l){case Wt:case Ut:o.fieldKind=`message`,o.message=n.getMessage(Sn(e.typeName)),jn(o.message,`invalid FieldDescriptorProto: type_name ${e.typeName} not found`),o.delimitedEncoding=On(e,t),o.getDefaultValue=()=>void 0;break;case Kt:{let t=n.getEnum(Sn(e.typeName));jn(t!==void 0,`invalid FieldDescriptorProto: type_name ${e.typeName} not found`),o.fieldKind=`enum`,o.enum=n.getEnum(Sn(e.typeName)),o.getDefaultValue=()=>E(e,`defaultValue`)?Mt(t,e.defaultValue):void 0;break}default:o.fieldKind=`scalar`,o.scalar=l,o.longAsString=u==Yt,o.getDefaultValue=()=>E(e,`defaultValue`)?Nt(l,e.defaultValue):void 0}return o}function gn(e){switch(e.syntax){case``:case`proto2`:return zt;case`proto3`:return Bt;case`editions`:if(e.edition===Vt)return an;if(e.edition in on)return e.edition;throw Error(`${e.name}: unsupported edition`);default:throw Error(`${e.name}: unsupported syntax "${e.syntax}"`)}}function _n(e,t){return e.dependency.map(n=>{let r=t.getFile(n);if(!r)throw Error(`Cannot find ${n}, imported by ${e.name}`);return r})}function vn(e,t){let n=bn(e)+`_`;for(let e of t){if(!e.name.toLowerCase().startsWith(n))return;let t=e.name.substring(n.length);if(t.length==0||/^\d/.test(t))return}return n}function yn(e){let t;for(let n of e.options?.$unknown??[]){if(n.no!==998||n.wireType!==z.LengthDelimited)continue;let e=new Me(new Me(n.data).bytes());for(;e.pos<e.len;){let[n,r]=e.tag();n===1&&r===z.LengthDelimited?t=e.string():e.skip(r,n)}}return t}function bn(e){return(e.substring(0,1)+e.substring(1).replace(/[A-Z]/g,e=>`_`+e)).toLowerCase()}function xn(e,t,n){let r;return r=t?`${t.typeName}.${e.name}`:n.proto.package.length>0?`${n.proto.package}.${e.name}`:`${e.name}`,r}function Sn(e){return e.startsWith(`.`)?e.substring(1):e}function Cn(e,t){if(!E(e,`oneofIndex`)||e.proto3Optional)return;let n=t[e.oneofIndex];return jn(n,`invalid FieldDescriptorProto: oneof #${e.oneofIndex} for field #${e.number} not found`),n}function wn(e,t,n,r){if(e.label==Jt)return $t;if(e.label==qt)return Qt;if(t||e.proto3Optional||n)return Zt;let i=An(`fieldPresence`,{proto:e,parent:r});return i==Qt&&(e.type==Wt||e.type==Ut)?Zt:i}function Tn(e,t){if(e.label!=qt)return!1;switch(e.type){case Ht:case Gt:case Ut:case Wt:return!1}let n=e.options;return n&&E(n,`packed`)?n.packed:en==An(`repeatedFieldEncoding`,{proto:e,parent:t})}function En(e){let t=e.fields.find(e=>e.number===1),n=e.fields.find(e=>e.number===2);return jn(t&&t.fieldKind==`scalar`&&t.scalar!=i.BYTES&&t.scalar!=i.FLOAT&&t.scalar!=i.DOUBLE&&n&&n.fieldKind!=`list`&&n.fieldKind!=`map`),{key:t,value:n}}function Dn(e){return nn==An(`enumType`,{proto:e.proto,parent:e.parent??e.file})}function On(e,t){return e.type==Ut||tn==An(`messageEncoding`,{proto:e,parent:t})}function kn(e,t){return rn==An(`utf8Validation`,{proto:e,parent:t})}function An(e,t){let n=t.proto.options?.features;if(n){let t=n[e];if(t!=0)return t}if(`kind`in t){if(t.kind==`message`)return An(e,t.parent??t.file);let n=on[t.edition];if(!n)throw Error(`feature default for edition ${t.edition} not found`);return n[e]}return An(e,t.parent)}function jn(e,t){if(!e)throw Error(t)}function Mn(e){let t=Nn(e);return t.messageType.forEach(jt),It(t,()=>void 0).getFile(t.name)}function Nn(e){return Object.assign(Object.create({syntax:``,edition:0}),Object.assign(Object.assign({$typeName:`google.protobuf.FileDescriptorProto`,dependency:[],publicDependency:[],weakDependency:[],optionDependency:[],service:[],extension:[]},e),{messageType:e.messageType.map(Pn),enumType:e.enumType.map(Ln)}))}function Pn(e){return Object.assign(Object.create({visibility:0}),{$typeName:`google.protobuf.DescriptorProto`,name:e.name,field:e.field?.map(Fn)??[],extension:[],nestedType:e.nestedType?.map(Pn)??[],enumType:e.enumType?.map(Ln)??[],extensionRange:e.extensionRange?.map(e=>Object.assign({$typeName:`google.protobuf.DescriptorProto.ExtensionRange`},e))??[],oneofDecl:[],reservedRange:[],reservedName:[]})}function Fn(e){return Object.assign(Object.create({label:1,typeName:``,extendee:``,defaultValue:``,oneofIndex:0,jsonName:``,proto3Optional:!1}),Object.assign(Object.assign({$typeName:`google.protobuf.FieldDescriptorProto`},e),{options:e.options?In(e.options):void 0}))}function In(e){return Object.assign(Object.create({ctype:0,packed:!1,jstype:0,lazy:!1,unverifiedLazy:!1,deprecated:!1,weak:!1,debugRedact:!1,retention:0}),Object.assign(Object.assign({$typeName:`google.protobuf.FieldOptions`},e),{targets:e.targets??[],editionDefaults:e.editionDefaults?.map(e=>Object.assign({$typeName:`google.protobuf.FieldOptions.EditionDefault`},e))??[],uninterpretedOption:[]}))}function Ln(e){return Object.assign(Object.create({visibility:0}),{$typeName:`google.protobuf.EnumDescriptorProto`,name:e.name,reservedName:[],reservedRange:[],value:e.value.map(e=>Object.assign({$typeName:`google.protobuf.EnumValueDescriptorProto`},e))})}function Rn(e,t,...n){return n.reduce((e,t)=>e.nestedMessages[t],e.messages[t])}var zn=Mn({name:`google/protobuf/descriptor.proto`,package:`google.protobuf`,messageType:[{name:`FileDescriptorSet`,field:[{name:`file`,number:1,type:11,label:3,typeName:`.google.protobuf.FileDescriptorProto`}],extensionRange:[{start:536e6,end:536000001}]},{name:`FileDescriptorProto`,field:[{name:`name`,number:1,type:9,label:1},{name:`package`,number:2,type:9,label:1},{name:`dependency`,number:3,type:9,label:3},{name:`public_dependency`,number:10,type:5,label:3},{name:`weak_dependency`,number:11,type:5,label:3},{name:`option_dependency`,number:15,type:9,label:3},{name:`message_type`,number:4,type:11,label:3,typeName:`.google.protobuf.DescriptorProto`},{name:`enum_type`,number:5,type:11,label:3,typeName:`.google.protobuf.EnumDescriptorProto`},{name:`service`,number:6,type:11,label:3,typeName:`.google.protobuf.ServiceDescriptorProto`},{name:`extension`,number:7,type:11,label:3,typeName:`.google.protobuf.FieldDescriptorProto`},{name:`options`,number:8,type:11,label:1,typeName:`.google.protobuf.FileOptions`},{name:`source_code_info`,number:9,type:11,label:1,typeName:`.google.protobuf.SourceCodeInfo`},{name:`syntax`,number:12,type:9,label:1},{name:`edition`,number:14,type:14,label:1,typeName:`.google.protobuf.Edition`}]},{name:`DescriptorProto`,field:[{name:`name`,number:1,type:9,label:1},{name:`field`,number:2,type:11,label:3,typeName:`.google.protobuf.FieldDescriptorProto`},{name:`extension`,number:6,type:11,label:3,typeName:`.google.protobuf.FieldDescriptorProto`},{name:`nested_type`,number:3,type:11,label:3,typeName:`.google.protobuf.DescriptorProto`},{name:`enum_type`,number:4,type:11,label:3,typeName:`.google.protobuf.EnumDescriptorProto`},{name:`extension_range`,number:5,type:11,label:3,typeName:`.google.protobuf.DescriptorProto.ExtensionRange`},{name:`oneof_decl`,number:8,type:11,label:3,typeName:`.google.protobuf.OneofDescriptorProto`},{name:`options`,number:7,type:11,label:1,typeName:`.google.protobuf.MessageOptions`},{name:`reserved_range`,number:9,type:11,label:3,typeName:`.google.protobuf.DescriptorProto.ReservedRange`},{name:`reserved_name`,number:10,type:9,label:3},{name:`visibility`,number:11,type:14,label:1,typeName:`.google.protobuf.SymbolVisibility`}],nestedType:[{name:`ExtensionRange`,field:[{name:`start`,number:1,type:5,label:1},{name:`end`,number:2,type:5,label:1},{name:`options`,number:3,type:11,label:1,typeName:`.google.protobuf.ExtensionRangeOptions`}]},{name:`ReservedRange`,field:[{name:`start`,number:1,type:5,label:1},{name:`end`,number:2,type:5,label:1}]}]},{name:`ExtensionRangeOptions`,field:[{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`},{name:`declaration`,number:2,type:11,label:3,typeName:`.google.protobuf.ExtensionRangeOptions.Declaration`,options:{retention:2}},{name:`features`,number:50,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`verification`,number:3,type:14,label:1,typeName:`.google.protobuf.ExtensionRangeOptions.VerificationState`,defaultValue:`UNVERIFIED`,options:{retention:2}}],nestedType:[{name:`Declaration`,field:[{name:`number`,number:1,type:5,label:1},{name:`full_name`,number:2,type:9,label:1},{name:`type`,number:3,type:9,label:1},{name:`reserved`,number:5,type:8,label:1},{name:`repeated`,number:6,type:8,label:1}]}],enumType:[{name:`VerificationState`,value:[{name:`DECLARATION`,number:0},{name:`UNVERIFIED`,number:1}]}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`FieldDescriptorProto`,field:[{name:`name`,number:1,type:9,label:1},{name:`number`,number:3,type:5,label:1},{name:`label`,number:4,type:14,label:1,typeName:`.google.protobuf.FieldDescriptorProto.Label`},{name:`type`,number:5,type:14,label:1,typeName:`.google.protobuf.FieldDescriptorProto.Type`},{name:`type_name`,number:6,type:9,label:1},{name:`extendee`,number:2,type:9,label:1},{name:`default_value`,number:7,type:9,label:1},{name:`oneof_index`,number:9,type:5,label:1},{name:`json_name`,number:10,type:9,label:1},{name:`options`,number:8,type:11,label:1,typeName:`.google.protobuf.FieldOptions`},{name:`proto3_optional`,number:17,type:8,label:1}],enumType:[{name:`Type`,value:[{name:`TYPE_DOUBLE`,number:1},{name:`TYPE_FLOAT`,number:2},{name:`TYPE_INT64`,number:3},{name:`TYPE_UINT64`,number:4},{name:`TYPE_INT32`,number:5},{name:`TYPE_FIXED64`,number:6},{name:`TYPE_FIXED32`,number:7},{name:`TYPE_BOOL`,number:8},{name:`TYPE_STRING`,number:9},{name:`TYPE_GROUP`,number:10},{name:`TYPE_MESSAGE`,number:11},{name:`TYPE_BYTES`,number:12},{name:`TYPE_UINT32`,number:13},{name:`TYPE_ENUM`,number:14},{name:`TYPE_SFIXED32`,number:15},{name:`TYPE_SFIXED64`,number:16},{name:`TYPE_SINT32`,number:17},{name:`TYPE_SINT64`,number:18}]},{name:`Label`,value:[{name:`LABEL_OPTIONAL`,number:1},{name:`LABEL_REPEATED`,number:3},{name:`LABEL_REQUIRED`,number:2}]}]},{name:`OneofDescriptorProto`,field:[{name:`name`,number:1,type:9,label:1},{name:`options`,number:2,type:11,label:1,typeName:`.google.protobuf.OneofOptions`}]},{name:`EnumDescriptorProto`,field:[{name:`name`,number:1,type:9,label:1},{name:`value`,number:2,type:11,label:3,typeName:`.google.protobuf.EnumValueDescriptorProto`},{name:`options`,number:3,type:11,label:1,typeName:`.google.protobuf.EnumOptions`},{name:`reserved_range`,number:4,type:11,label:3,typeName:`.google.protobuf.EnumDescriptorProto.EnumReservedRange`},{name:`reserved_name`,number:5,type:9,label:3},{name:`visibility`,number:6,type:14,label:1,typeName:`.google.protobuf.SymbolVisibility`}],nestedType:[{name:`EnumReservedRange`,field:[{name:`start`,number:1,type:5,label:1},{name:`end`,number:2,type:5,label:1}]}]},{name:`EnumValueDescriptorProto`,field:[{name:`name`,number:1,type:9,label:1},{name:`number`,number:2,type:5,label:1},{name:`options`,number:3,type:11,label:1,typeName:`.google.protobuf.EnumValueOptions`}]},{name:`ServiceDescriptorProto`,field:[{name:`name`,number:1,type:9,label:1},{name:`method`,number:2,type:11,label:3,typeName:`.google.protobuf.MethodDescriptorProto`},{name:`options`,number:3,type:11,label:1,typeName:`.google.protobuf.ServiceOptions`}]},{name:`MethodDescriptorProto`,field:[{name:`name`,number:1,type:9,label:1},{name:`input_type`,number:2,type:9,label:1},{name:`output_type`,number:3,type:9,label:1},{name:`options`,number:4,type:11,label:1,typeName:`.google.protobuf.MethodOptions`},{name:`client_streaming`,number:5,type:8,label:1,defaultValue:`false`},{name:`server_streaming`,number:6,type:8,label:1,defaultValue:`false`}]},{name:`FileOptions`,field:[{name:`java_package`,number:1,type:9,label:1},{name:`java_outer_classname`,number:8,type:9,label:1},{name:`java_multiple_files`,number:10,type:8,label:1,defaultValue:`false`,options:{}},{name:`java_generate_equals_and_hash`,number:20,type:8,label:1,options:{deprecated:!0}},{name:`java_string_check_utf8`,number:27,type:8,label:1,defaultValue:`false`},{name:`optimize_for`,number:9,type:14,label:1,typeName:`.google.protobuf.FileOptions.OptimizeMode`,defaultValue:`SPEED`},{name:`go_package`,number:11,type:9,label:1},{name:`cc_generic_services`,number:16,type:8,label:1,defaultValue:`false`},{name:`java_generic_services`,number:17,type:8,label:1,defaultValue:`false`},{name:`py_generic_services`,number:18,type:8,label:1,defaultValue:`false`},{name:`deprecated`,number:23,type:8,label:1,defaultValue:`false`},{name:`cc_enable_arenas`,number:31,type:8,label:1,defaultValue:`true`,options:{}},{name:`objc_class_prefix`,number:36,type:9,label:1},{name:`csharp_namespace`,number:37,type:9,label:1},{name:`swift_prefix`,number:39,type:9,label:1},{name:`php_class_prefix`,number:40,type:9,label:1},{name:`php_namespace`,number:41,type:9,label:1},{name:`php_metadata_namespace`,number:44,type:9,label:1},{name:`ruby_package`,number:45,type:9,label:1},{name:`features`,number:50,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`}],enumType:[{name:`OptimizeMode`,value:[{name:`SPEED`,number:1},{name:`CODE_SIZE`,number:2},{name:`LITE_RUNTIME`,number:3}]}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`MessageOptions`,field:[{name:`message_set_wire_format`,number:1,type:8,label:1,defaultValue:`false`},{name:`no_standard_descriptor_accessor`,number:2,type:8,label:1,defaultValue:`false`},{name:`deprecated`,number:3,type:8,label:1,defaultValue:`false`},{name:`map_entry`,number:7,type:8,label:1},{name:`deprecated_legacy_json_field_conflicts`,number:11,type:8,label:1,options:{deprecated:!0}},{name:`features`,number:12,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`FieldOptions`,field:[{name:`ctype`,number:1,type:14,label:1,typeName:`.google.protobuf.FieldOptions.CType`,defaultValue:`STRING`},{name:`packed`,number:2,type:8,label:1},{name:`jstype`,number:6,type:14,label:1,typeName:`.google.protobuf.FieldOptions.JSType`,defaultValue:`JS_NORMAL`},{name:`lazy`,number:5,type:8,label:1,defaultValue:`false`},{name:`unverified_lazy`,number:15,type:8,label:1,defaultValue:`false`},{name:`deprecated`,number:3,type:8,label:1,defaultValue:`false`},{name:`weak`,number:10,type:8,label:1,defaultValue:`false`,options:{deprecated:!0}},{name:`debug_redact`,number:16,type:8,label:1,defaultValue:`false`},{name:`retention`,number:17,type:14,label:1,typeName:`.google.protobuf.FieldOptions.OptionRetention`},{name:`targets`,number:19,type:14,label:3,typeName:`.google.protobuf.FieldOptions.OptionTargetType`},{name:`edition_defaults`,number:20,type:11,label:3,typeName:`.google.protobuf.FieldOptions.EditionDefault`},{name:`features`,number:21,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`feature_support`,number:22,type:11,label:1,typeName:`.google.protobuf.FieldOptions.FeatureSupport`},{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`}],nestedType:[{name:`EditionDefault`,field:[{name:`edition`,number:3,type:14,label:1,typeName:`.google.protobuf.Edition`},{name:`value`,number:2,type:9,label:1}]},{name:`FeatureSupport`,field:[{name:`edition_introduced`,number:1,type:14,label:1,typeName:`.google.protobuf.Edition`},{name:`edition_deprecated`,number:2,type:14,label:1,typeName:`.google.protobuf.Edition`},{name:`deprecation_warning`,number:3,type:9,label:1},{name:`edition_removed`,number:4,type:14,label:1,typeName:`.google.protobuf.Edition`},{name:`removal_error`,number:5,type:9,label:1}]}],enumType:[{name:`CType`,value:[{name:`STRING`,number:0},{name:`CORD`,number:1},{name:`STRING_PIECE`,number:2}]},{name:`JSType`,value:[{name:`JS_NORMAL`,number:0},{name:`JS_STRING`,number:1},{name:`JS_NUMBER`,number:2}]},{name:`OptionRetention`,value:[{name:`RETENTION_UNKNOWN`,number:0},{name:`RETENTION_RUNTIME`,number:1},{name:`RETENTION_SOURCE`,number:2}]},{name:`OptionTargetType`,value:[{name:`TARGET_TYPE_UNKNOWN`,number:0},{name:`TARGET_TYPE_FILE`,number:1},{name:`TARGET_TYPE_EXTENSION_RANGE`,number:2},{name:`TARGET_TYPE_MESSAGE`,number:3},{name:`TARGET_TYPE_FIELD`,number:4},{name:`TARGET_TYPE_ONEOF`,number:5},{name:`TARGET_TYPE_ENUM`,number:6},{name:`TARGET_TYPE_ENUM_ENTRY`,number:7},{name:`TARGET_TYPE_SERVICE`,number:8},{name:`TARGET_TYPE_METHOD`,number:9}]}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`OneofOptions`,field:[{name:`features`,number:1,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`EnumOptions`,field:[{name:`allow_alias`,number:2,type:8,label:1},{name:`deprecated`,number:3,type:8,label:1,defaultValue:`false`},{name:`deprecated_legacy_json_field_conflicts`,number:6,type:8,label:1,options:{deprecated:!0}},{name:`features`,number:7,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`EnumValueOptions`,field:[{name:`deprecated`,number:1,type:8,label:1,defaultValue:`false`},{name:`features`,number:2,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`debug_redact`,number:3,type:8,label:1,defaultValue:`false`},{name:`feature_support`,number:4,type:11,label:1,typeName:`.google.protobuf.FieldOptions.FeatureSupport`},{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`ServiceOptions`,field:[{name:`features`,number:34,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`deprecated`,number:33,type:8,label:1,defaultValue:`false`},{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`MethodOptions`,field:[{name:`deprecated`,number:33,type:8,label:1,defaultValue:`false`},{name:`idempotency_level`,number:34,type:14,label:1,typeName:`.google.protobuf.MethodOptions.IdempotencyLevel`,defaultValue:`IDEMPOTENCY_UNKNOWN`},{name:`features`,number:35,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`uninterpreted_option`,number:999,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption`}],enumType:[{name:`IdempotencyLevel`,value:[{name:`IDEMPOTENCY_UNKNOWN`,number:0},{name:`NO_SIDE_EFFECTS`,number:1},{name:`IDEMPOTENT`,number:2}]}],extensionRange:[{start:990,end:999},{start:1e3,end:536870912}]},{name:`UninterpretedOption`,field:[{name:`name`,number:2,type:11,label:3,typeName:`.google.protobuf.UninterpretedOption.NamePart`},{name:`identifier_value`,number:3,type:9,label:1},{name:`positive_int_value`,number:4,type:4,label:1},{name:`negative_int_value`,number:5,type:3,label:1},{name:`double_value`,number:6,type:1,label:1},{name:`string_value`,number:7,type:12,label:1},{name:`aggregate_value`,number:8,type:9,label:1}],nestedType:[{name:`NamePart`,field:[{name:`name_part`,number:1,type:9,label:2},{name:`is_extension`,number:2,type:8,label:2}]}]},{name:`FeatureSet`,field:[{name:`field_presence`,number:1,type:14,label:1,typeName:`.google.protobuf.FeatureSet.FieldPresence`,options:{retention:1,targets:[4,1],editionDefaults:[{value:`EXPLICIT`,edition:900},{value:`IMPLICIT`,edition:999},{value:`EXPLICIT`,edition:1e3}]}},{name:`enum_type`,number:2,type:14,label:1,typeName:`.google.protobuf.FeatureSet.EnumType`,options:{retention:1,targets:[6,1],editionDefaults:[{value:`CLOSED`,edition:900},{value:`OPEN`,edition:999}]}},{name:`repeated_field_encoding`,number:3,type:14,label:1,typeName:`.google.protobuf.FeatureSet.RepeatedFieldEncoding`,options:{retention:1,targets:[4,1],editionDefaults:[{value:`EXPANDED`,edition:900},{value:`PACKED`,edition:999}]}},{name:`utf8_validation`,number:4,type:14,label:1,typeName:`.google.protobuf.FeatureSet.Utf8Validation`,options:{retention:1,targets:[4,1],editionDefaults:[{value:`NONE`,edition:900},{value:`VERIFY`,edition:999}]}},{name:`message_encoding`,number:5,type:14,label:1,typeName:`.google.protobuf.FeatureSet.MessageEncoding`,options:{retention:1,targets:[4,1],editionDefaults:[{value:`LENGTH_PREFIXED`,edition:900}]}},{name:`json_format`,number:6,type:14,label:1,typeName:`.google.protobuf.FeatureSet.JsonFormat`,options:{retention:1,targets:[3,6,1],editionDefaults:[{value:`LEGACY_BEST_EFFORT`,edition:900},{value:`ALLOW`,edition:999}]}},{name:`enforce_naming_style`,number:7,type:14,label:1,typeName:`.google.protobuf.FeatureSet.EnforceNamingStyle`,options:{retention:2,targets:[1,2,3,4,5,6,7,8,9],editionDefaults:[{value:`STYLE_LEGACY`,edition:900},{value:`STYLE2024`,edition:1001},{value:`STYLE2026`,edition:1002}]}},{name:`default_symbol_visibility`,number:8,type:14,label:1,typeName:`.google.protobuf.FeatureSet.VisibilityFeature.DefaultSymbolVisibility`,options:{retention:2,targets:[1],editionDefaults:[{value:`EXPORT_ALL`,edition:900},{value:`EXPORT_TOP_LEVEL`,edition:1001},{value:`STRICT`,edition:1002}]}},{name:`enforce_proto_limits`,number:9,type:14,label:1,typeName:`.google.protobuf.FeatureSet.ProtoLimitsFeature.EnforceProtoLimits`,options:{retention:2,targets:[6,3,4,5],editionDefaults:[{value:`LEGACY_NO_EXPLICIT_LIMITS`,edition:900},{value:`PROTO_LIMITS2026`,edition:1002}]}}],nestedType:[{name:`VisibilityFeature`,enumType:[{name:`DefaultSymbolVisibility`,value:[{name:`DEFAULT_SYMBOL_VISIBILITY_UNKNOWN`,number:0},{name:`EXPORT_ALL`,number:1},{name:`EXPORT_TOP_LEVEL`,number:2},{name:`LOCAL_ALL`,number:3},{name:`STRICT`,number:4}]}]},{name:`ProtoLimitsFeature`,enumType:[{name:`EnforceProtoLimits`,value:[{name:`PROTO_LIMITS_UNKNOWN`,number:0},{name:`LEGACY_NO_EXPLICIT_LIMITS`,number:1},{name:`PROTO_LIMITS2026`,number:2}]}]}],enumType:[{name:`FieldPresence`,value:[{name:`FIELD_PRESENCE_UNKNOWN`,number:0},{name:`EXPLICIT`,number:1},{name:`IMPLICIT`,number:2},{name:`LEGACY_REQUIRED`,number:3}]},{name:`EnumType`,value:[{name:`ENUM_TYPE_UNKNOWN`,number:0},{name:`OPEN`,number:1},{name:`CLOSED`,number:2}]},{name:`RepeatedFieldEncoding`,value:[{name:`REPEATED_FIELD_ENCODING_UNKNOWN`,number:0},{name:`PACKED`,number:1},{name:`EXPANDED`,number:2}]},{name:`Utf8Validation`,value:[{name:`UTF8_VALIDATION_UNKNOWN`,number:0},{name:`VERIFY`,number:2},{name:`NONE`,number:3}]},{name:`MessageEncoding`,value:[{name:`MESSAGE_ENCODING_UNKNOWN`,number:0},{name:`LENGTH_PREFIXED`,number:1},{name:`DELIMITED`,number:2}]},{name:`JsonFormat`,value:[{name:`JSON_FORMAT_UNKNOWN`,number:0},{name:`ALLOW`,number:1},{name:`LEGACY_BEST_EFFORT`,number:2}]},{name:`EnforceNamingStyle`,value:[{name:`ENFORCE_NAMING_STYLE_UNKNOWN`,number:0},{name:`STYLE2024`,number:1},{name:`STYLE_LEGACY`,number:2},{name:`STYLE2026`,number:3}]}],extensionRange:[{start:1e3,end:9995},{start:9995,end:1e4},{start:1e4,end:10001}]},{name:`FeatureSetDefaults`,field:[{name:`defaults`,number:1,type:11,label:3,typeName:`.google.protobuf.FeatureSetDefaults.FeatureSetEditionDefault`},{name:`minimum_edition`,number:4,type:14,label:1,typeName:`.google.protobuf.Edition`},{name:`maximum_edition`,number:5,type:14,label:1,typeName:`.google.protobuf.Edition`}],nestedType:[{name:`FeatureSetEditionDefault`,field:[{name:`edition`,number:3,type:14,label:1,typeName:`.google.protobuf.Edition`},{name:`overridable_features`,number:4,type:11,label:1,typeName:`.google.protobuf.FeatureSet`},{name:`fixed_features`,number:5,type:11,label:1,typeName:`.google.protobuf.FeatureSet`}]}]},{name:`SourceCodeInfo`,field:[{name:`location`,number:1,type:11,label:3,typeName:`.google.protobuf.SourceCodeInfo.Location`}],nestedType:[{name:`Location`,field:[{name:`path`,number:1,type:5,label:3,options:{packed:!0}},{name:`span`,number:2,type:5,label:3,options:{packed:!0}},{name:`leading_comments`,number:3,type:9,label:1},{name:`trailing_comments`,number:4,type:9,label:1},{name:`leading_detached_comments`,number:6,type:9,label:3}]}],extensionRange:[{start:536e6,end:536000001}]},{name:`GeneratedCodeInfo`,field:[{name:`annotation`,number:1,type:11,label:3,typeName:`.google.protobuf.GeneratedCodeInfo.Annotation`}],nestedType:[{name:`Annotation`,field:[{name:`path`,number:1,type:5,label:3,options:{packed:!0}},{name:`source_file`,number:2,type:9,label:1},{name:`begin`,number:3,type:5,label:1},{name:`end`,number:4,type:5,label:1},{name:`semantic`,number:5,type:14,label:1,typeName:`.google.protobuf.GeneratedCodeInfo.Annotation.Semantic`}],enumType:[{name:`Semantic`,value:[{name:`NONE`,number:0},{name:`SET`,number:1},{name:`ALIAS`,number:2}]}]}]}],enumType:[{name:`Edition`,value:[{name:`EDITION_UNKNOWN`,number:0},{name:`EDITION_LEGACY`,number:900},{name:`EDITION_PROTO2`,number:998},{name:`EDITION_PROTO3`,number:999},{name:`EDITION_2023`,number:1e3},{name:`EDITION_2024`,number:1001},{name:`EDITION_2026`,number:1002},{name:`EDITION_UNSTABLE`,number:9999},{name:`EDITION_1_TEST_ONLY`,number:1},{name:`EDITION_2_TEST_ONLY`,number:2},{name:`EDITION_99997_TEST_ONLY`,number:99997},{name:`EDITION_99998_TEST_ONLY`,number:99998},{name:`EDITION_99999_TEST_ONLY`,number:99999},{name:`EDITION_MAX`,number:2147483647}]},{name:`SymbolVisibility`,value:[{name:`VISIBILITY_UNSET`,number:0},{name:`VISIBILITY_LOCAL`,number:1},{name:`VISIBILITY_EXPORT`,number:2}]}]}),Bn=Rn(zn,1),Vn;(function(e){e[e.DECLARATION=0]=`DECLARATION`,e[e.UNVERIFIED=1]=`UNVERIFIED`})(Vn||={});var Hn;(function(e){e[e.DOUBLE=1]=`DOUBLE`,e[e.FLOAT=2]=`FLOAT`,e[e.INT64=3]=`INT64`,e[e.UINT64=4]=`UINT64`,e[e.INT32=5]=`INT32`,e[e.FIXED64=6]=`FIXED64`,e[e.FIXED32=7]=`FIXED32`,e[e.BOOL=8]=`BOOL`,e[e.STRING=9]=`STRING`,e[e.GROUP=10]=`GROUP`,e[e.MESSAGE=11]=`MESSAGE`,e[e.BYTES=12]=`BYTES`,e[e.UINT32=13]=`UINT32`,e[e.ENUM=14]=`ENUM`,e[e.SFIXED32=15]=`SFIXED32`,e[e.SFIXED64=16]=`SFIXED64`,e[e.SINT32=17]=`SINT32`,e[e.SINT64=18]=`SINT64`})(Hn||={});var Un;(function(e){e[e.OPTIONAL=1]=`OPTIONAL`,e[e.REPEATED=3]=`REPEATED`,e[e.REQUIRED=2]=`REQUIRED`})(Un||={});var Wn;(function(e){e[e.SPEED=1]=`SPEED`,e[e.CODE_SIZE=2]=`CODE_SIZE`,e[e.LITE_RUNTIME=3]=`LITE_RUNTIME`})(Wn||={});var Gn;(function(e){e[e.STRING=0]=`STRING`,e[e.CORD=1]=`CORD`,e[e.STRING_PIECE=2]=`STRING_PIECE`})(Gn||={});var Kn;(function(e){e[e.JS_NORMAL=0]=`JS_NORMAL`,e[e.JS_STRING=1]=`JS_STRING`,e[e.JS_NUMBER=2]=`JS_NUMBER`})(Kn||={});var qn;(function(e){e[e.RETENTION_UNKNOWN=0]=`RETENTION_UNKNOWN`,e[e.RETENTION_RUNTIME=1]=`RETENTION_RUNTIME`,e[e.RETENTION_SOURCE=2]=`RETENTION_SOURCE`})(qn||={});var Jn;(function(e){e[e.TARGET_TYPE_UNKNOWN=0]=`TARGET_TYPE_UNKNOWN`,e[e.TARGET_TYPE_FILE=1]=`TARGET_TYPE_FILE`,e[e.TARGET_TYPE_EXTENSION_RANGE=2]=`TARGET_TYPE_EXTENSION_RANGE`,e[e.TARGET_TYPE_MESSAGE=3]=`TARGET_TYPE_MESSAGE`,e[e.TARGET_TYPE_FIELD=4]=`TARGET_TYPE_FIELD`,e[e.TARGET_TYPE_ONEOF=5]=`TARGET_TYPE_ONEOF`,e[e.TARGET_TYPE_ENUM=6]=`TARGET_TYPE_ENUM`,e[e.TARGET_TYPE_ENUM_ENTRY=7]=`TARGET_TYPE_ENUM_ENTRY`,e[e.TARGET_TYPE_SERVICE=8]=`TARGET_TYPE_SERVICE`,e[e.TARGET_TYPE_METHOD=9]=`TARGET_TYPE_METHOD`})(Jn||={});var Yn;(function(e){e[e.IDEMPOTENCY_UNKNOWN=0]=`IDEMPOTENCY_UNKNOWN`,e[e.NO_SIDE_EFFECTS=1]=`NO_SIDE_EFFECTS`,e[e.IDEMPOTENT=2]=`IDEMPOTENT`})(Yn||={});var Xn;(function(e){e[e.DEFAULT_SYMBOL_VISIBILITY_UNKNOWN=0]=`DEFAULT_SYMBOL_VISIBILITY_UNKNOWN`,e[e.EXPORT_ALL=1]=`EXPORT_ALL`,e[e.EXPORT_TOP_LEVEL=2]=`EXPORT_TOP_LEVEL`,e[e.LOCAL_ALL=3]=`LOCAL_ALL`,e[e.STRICT=4]=`STRICT`})(Xn||={});var Zn;(function(e){e[e.PROTO_LIMITS_UNKNOWN=0]=`PROTO_LIMITS_UNKNOWN`,e[e.LEGACY_NO_EXPLICIT_LIMITS=1]=`LEGACY_NO_EXPLICIT_LIMITS`,e[e.PROTO_LIMITS2026=2]=`PROTO_LIMITS2026`})(Zn||={});var Qn;(function(e){e[e.FIELD_PRESENCE_UNKNOWN=0]=`FIELD_PRESENCE_UNKNOWN`,e[e.EXPLICIT=1]=`EXPLICIT`,e[e.IMPLICIT=2]=`IMPLICIT`,e[e.LEGACY_REQUIRED=3]=`LEGACY_REQUIRED`})(Qn||={});var $n;(function(e){e[e.ENUM_TYPE_UNKNOWN=0]=`ENUM_TYPE_UNKNOWN`,e[e.OPEN=1]=`OPEN`,e[e.CLOSED=2]=`CLOSED`})($n||={});var er;(function(e){e[e.REPEATED_FIELD_ENCODING_UNKNOWN=0]=`REPEATED_FIELD_ENCODING_UNKNOWN`,e[e.PACKED=1]=`PACKED`,e[e.EXPANDED=2]=`EXPANDED`})(er||={});var tr;(function(e){e[e.UTF8_VALIDATION_UNKNOWN=0]=`UTF8_VALIDATION_UNKNOWN`,e[e.VERIFY=2]=`VERIFY`,e[e.NONE=3]=`NONE`})(tr||={});var nr;(function(e){e[e.MESSAGE_ENCODING_UNKNOWN=0]=`MESSAGE_ENCODING_UNKNOWN`,e[e.LENGTH_PREFIXED=1]=`LENGTH_PREFIXED`,e[e.DELIMITED=2]=`DELIMITED`})(nr||={});var rr;(function(e){e[e.JSON_FORMAT_UNKNOWN=0]=`JSON_FORMAT_UNKNOWN`,e[e.ALLOW=1]=`ALLOW`,e[e.LEGACY_BEST_EFFORT=2]=`LEGACY_BEST_EFFORT`})(rr||={});var ir;(function(e){e[e.ENFORCE_NAMING_STYLE_UNKNOWN=0]=`ENFORCE_NAMING_STYLE_UNKNOWN`,e[e.STYLE2024=1]=`STYLE2024`,e[e.STYLE_LEGACY=2]=`STYLE_LEGACY`,e[e.STYLE2026=3]=`STYLE2026`})(ir||={});var ar;(function(e){e[e.NONE=0]=`NONE`,e[e.SET=1]=`SET`,e[e.ALIAS=2]=`ALIAS`})(ar||={});var or;(function(e){e[e.EDITION_UNKNOWN=0]=`EDITION_UNKNOWN`,e[e.EDITION_LEGACY=900]=`EDITION_LEGACY`,e[e.EDITION_PROTO2=998]=`EDITION_PROTO2`,e[e.EDITION_PROTO3=999]=`EDITION_PROTO3`,e[e.EDITION_2023=1e3]=`EDITION_2023`,e[e.EDITION_2024=1001]=`EDITION_2024`,e[e.EDITION_2026=1002]=`EDITION_2026`,e[e.EDITION_UNSTABLE=9999]=`EDITION_UNSTABLE`,e[e.EDITION_1_TEST_ONLY=1]=`EDITION_1_TEST_ONLY`,e[e.EDITION_2_TEST_ONLY=2]=`EDITION_2_TEST_ONLY`,e[e.EDITION_99997_TEST_ONLY=99997]=`EDITION_99997_TEST_ONLY`,e[e.EDITION_99998_TEST_ONLY=99998]=`EDITION_99998_TEST_ONLY`,e[e.EDITION_99999_TEST_ONLY=99999]=`EDITION_99999_TEST_ONLY`,e[e.EDITION_MAX=2147483647]=`EDITION_MAX`})(or||={});var sr;(function(e){e[e.VISIBILITY_UNSET=0]=`VISIBILITY_UNSET`,e[e.VISIBILITY_LOCAL=1]=`VISIBILITY_LOCAL`,e[e.VISIBILITY_EXPORT=2]=`VISIBILITY_EXPORT`})(sr||={});function cr(e){return Object.assign(Object.assign({readUnknownFields:!0,recursionLimit:100},e),{depth:0})}function lr(e,t,n){let r=F(e);return dr(e).read(r,new Me(t),cr(n),t.byteLength),r}var ur=new WeakMap;function dr(e){let t=ur.get(e);return t===void 0&&(t=fr(e)),t}function fr(e){let t=String(e),n=new Map,r={read:pr(t,n),readGroup:mr(t,n)};ur.set(e,r);for(let t of e.fields)n.set(t.number,gr(t));return r}function pr(e,t){return(n,r,i,a)=>{if(++i.depth>i.recursionLimit)throw Error(`cannot decode ${e} from binary: maximum recursion depth of ${i.recursionLimit} reached`);let o=r.pos+a,s=n.$unknown??[];for(;r.pos<o;){let[e,a]=r.tag(),o=t.get(e);if(o===void 0){let t=r.skip(a,e,i.recursionLimit-i.depth);i.readUnknownFields&&s.push({no:e,wireType:a,data:t})}else o(n,r,i,a)}s.length>0&&(n.$unknown=s),i.depth--}}function mr(e,t){return(n,r,i,a)=>{if(++i.depth>i.recursionLimit)throw Error(`cannot decode ${e} from binary: maximum recursion depth of ${i.recursionLimit} reached`);let o,s,c=n.$unknown??[];for(;r.pos<r.len&&([o,s]=r.tag(),s!=z.EndGroup);){let e=t.get(o);if(e===void 0){let e=r.skip(s,o,i.recursionLimit-i.depth);i.readUnknownFields&&c.push({no:o,wireType:s,data:e})}else e(n,r,i,s)}if(s!=z.EndGroup||o!==a)throw Error(`invalid end group tag`);c.length>0&&(n.$unknown=c),i.depth--}}function hr(e,t,n,r,i){gr(n)(e[C],t,i,r)}function gr(e){switch(e.fieldKind){case`scalar`:return _r(e);case`enum`:return vr(e);case`message`:return yr(e);case`list`:return xr(e);case`map`:return Sr(e)}}function _r(e){let t=Cr(e.scalar,e.utf8Validation,e.longAsString),n=e.localName;if(e.oneof){let r=e.oneof.localName;return(e,i)=>{e[r]={case:n,value:t(i)}}}return(e,r)=>{e[n]=t(r)}}function vr(e){let t=e.localName,n=e.oneof?.localName;if(e.enum.open)return n===void 0?(e,n)=>{e[t]=n.int32()}:(e,r)=>{e[n]={case:t,value:r.int32()}};let r=e.enum.values,i=e.number;return(e,a,o,s)=>{let c=a.int32();if(r.some(e=>e.number===c))n===void 0?e[t]=c:e[n]={case:t,value:c};else if(o.readUnknownFields){let t=[];m(c,t);let n=e.$unknown??[];n.push({no:i,wireType:s,data:new Uint8Array(t)}),e.$unknown=n}}}function yr(e){let t=e.localName,{toMessage:n,toLocal:r}=Je(e),i=br(e);if(e.oneof){let a=e.oneof.localName;return(e,o,s)=>{let c=e[a],l=n(c.case===t?c.value:void 0);i(l,o,s),e[a]={case:t,value:r(l)}}}return(e,a,o)=>{let s=n(e[t]);i(s,a,o),e[t]=r(s)}}function br(e){let t=dr(e.message);if(e.delimitedEncoding){let n=e.number;return(e,r,i)=>t.readGroup(e,r,i,n)}return(e,n,r)=>t.read(e,n,r,n.uint32())}function xr(e){let t=e.localName;if(e.listKind==`message`){let{toMessage:n,toLocal:r}=Je(e),i=br(e);return(e,a,o)=>{let s=n(void 0);i(s,a,o),e[t].push(r(s))}}let n=e.listKind==`enum`?i.INT32:e.scalar,r=e.listKind==`scalar`&&e.longAsString,a=Cr(n,e.utf8Validation,r),o=n!=i.STRING&&n!=i.BYTES;return(e,n,r,i)=>{let s=e[t];if(i==z.LengthDelimited&&o){let e=n.uint32()+n.pos;for(;n.pos<e;)s.push(a(n))}else s.push(a(n))}}function Sr(e){let t=e.localName,n=Cr(e.mapKey,e.utf8Validation,!1),r=b(e.mapKey,!1),a,o;switch(e.mapKind){case`scalar`:{let t=e.scalar,n=Cr(t,e.utf8Validation,!1);if(a=e=>n(e),t==i.BYTES)o=()=>new Uint8Array;else{let e=b(t,!1);o=()=>e}break}case`enum`:{let t=e.enum.values[0].number;a=e=>e.int32(),o=()=>t;break}case`message`:{let{toMessage:t,toLocal:n}=Je(e),r=dr(e.message).read;a=(e,i,a)=>{let o=t(a);return r(o,e,i,e.uint32()),n(o)},o=()=>n(t(void 0));break}}return(e,i,s)=>{let c=e[t],l,u,d=i.uint32(),f=i.pos+d;for(;i.pos<f;){let[e,t]=i.tag();switch(e){case 1:l=n(i);break;case 2:u=a(i,s,u);break;default:i.skip(t,e,s.recursionLimit-s.depth)}}l===void 0&&(l=r),u===void 0&&(u=o()),k(c,l,u)}}function Cr(e,t,n){switch(e){case i.STRING:return e=>e.string(t);case i.BOOL:return e=>e.bool();case i.DOUBLE:return e=>e.double();case i.FLOAT:return e=>e.float();case i.INT32:return e=>e.int32();case i.INT64:return n?e=>String(e.int64()):e=>e.int64();case i.UINT64:return n?e=>String(e.uint64()):e=>e.uint64();case i.FIXED64:return n?e=>String(e.fixed64()):e=>e.fixed64();case i.BYTES:return e=>e.bytes();case i.FIXED32:return e=>e.fixed32();case i.SFIXED32:return e=>e.sfixed32();case i.SFIXED64:return n?e=>String(e.sfixed64()):e=>e.sfixed64();case i.SINT64:return n?e=>String(e.sint64()):e=>e.sint64();case i.UINT32:return e=>e.uint32();case i.SINT32:return e=>e.sint32()}}function wr(e,t){let n=lr(Bn,_t(e));return n.messageType.forEach(jt),n.dependency=t?.map(e=>e.proto.name)??[],It(n,e=>t?.find(t=>t.proto.name===e)).getFile(n.name)}var Tr=Rn(wr(`Chlnb29nbGUvcHJvdG9idWYvYW55LnByb3RvEg9nb29nbGUucHJvdG9idWYiJgoDQW55EhAKCHR5cGVfdXJsGAEgASgJEg0KBXZhbHVlGAIgASgMQnYKE2NvbS5nb29nbGUucHJvdG9idWZCCEFueVByb3RvUAFaLGdvb2dsZS5nb2xhbmcub3JnL3Byb3RvYnVmL3R5cGVzL2tub3duL2FueXBiogIDR1BCqgIeR29vZ2xlLlByb3RvYnVmLldlbGxLbm93blR5cGVzYgZwcm90bzM`),0),Er=2,Dr=3,Or={writeUnknownFields:!0};function kr(e){return e?Object.assign(Object.assign({},Or),e):Or}function Ar(e,t,n){let r=new B;return Mr(e)(r,kr(n),t),r.finish()}var jr=new WeakMap;function Mr(e){let t=jr.get(e);return t===void 0&&(t=Nr(e)),t}function Nr(e){let t=e.typeName,n=e.fields.concat().sort((e,t)=>e.number-t.number),r=n[0],i=[],a=(e,n,a)=>{if(a.$typeName!==t&&r!==void 0)throw new I(r,`cannot use ${r} with message ${a.$typeName}`,`ForeignFieldError`);for(let t=0;t<i.length;t++)i[t](e,n,a);let o=a.$unknown;if(o!==void 0&&n.writeUnknownFields)for(let t=0;t<o.length;t++){let{no:n,wireType:r,data:i}=o[t];e.tag(n,r).raw(i)}};jr.set(e,a);for(let e of n)i.push(Pr(e));return a}function Pr(e){switch(e.fieldKind){case`message`:case`scalar`:case`enum`:return Fr(e);case`list`:return Lr(e);case`map`:return Rr(e)}}function Fr(e){let t=Ir(e),n=e.localName;if(e.oneof){let r=e.oneof.localName;return(e,i,a)=>{let o=a[r];o.case===n&&t(e,i,o.value)}}if(e.presence!=Er){let r=e.presence==Dr?`cannot encode ${e} to binary: required field not set`:void 0;return(e,i,a)=>{let o=a[n];if(o!==void 0&&Object.prototype.hasOwnProperty.call(a,n))t(e,i,o);else if(r!==void 0)throw Error(r)}}if(e.fieldKind==`enum`){let r=e.enum.values[0].number;return(e,i,a)=>{let o=a[n];o!==r&&t(e,i,o)}}switch(e.scalar){case i.BOOL:return(e,r,i)=>{let a=i[n];a!==!1&&t(e,r,a)};case i.STRING:return(e,r,i)=>{let a=i[n];a!==``&&t(e,r,a)};case i.BYTES:return(e,r,i)=>{let a=i[n];(!(a instanceof Uint8Array)||a.byteLength>0)&&t(e,r,a)};case i.DOUBLE:case i.FLOAT:return(e,r,i)=>{let a=i[n];Object.is(a,0)||t(e,r,a)};default:return(e,r,i)=>{let a=i[n];a!=0&&t(e,r,a)}}}function Ir(e){switch(e.fieldKind){case`message`:{let{toMessage:t}=Je(e),n=Wr(e);return(e,r,i)=>{n(e,r,t(i))}}case`scalar`:case`enum`:{let t=e.fieldKind==`enum`?i.INT32:e.scalar,n=e.number,r=Gr(t),a=Vr(t,e.parent.typeName,e.name);return(e,t,i)=>{e.tag(n,r),a(e,i)}}}}function Lr(e){let t=e.localName,n=e.number;switch(e.listKind){case`message`:{let{toMessage:n}=Je(e),r=Wr(e);return(e,i,a)=>{let o=a[t];for(let t=0;t<o.length;t++)r(e,i,n(o[t]))}}case`scalar`:case`enum`:{let r=e.listKind==`enum`?i.INT32:e.scalar,a=Vr(r,e.parent.typeName,e.name);if(e.packed)return(e,r,i)=>{let o=i[t];if(o.length!=0){e.tag(n,z.LengthDelimited).fork();for(let t=0;t<o.length;t++)a(e,o[t]);e.join()}};let o=Gr(r);return(e,r,i)=>{let s=i[t];for(let t=0;t<s.length;t++)e.tag(n,o),a(e,s[t])}}}}function Rr(e){let t=e.localName,n=e.number,r=zr(e);if(e.mapKind==`message`){let{toMessage:i}=Je(e),a=Mr(e.message);return(e,o,s)=>{let c=s[t],l=Object.keys(c);for(let t=0;t<l.length;t++){let s=l[t];e.tag(n,z.LengthDelimited).fork(),r(e,s),e.tag(2,z.LengthDelimited).fork(),a(e,o,i(c[s])),e.join(),e.join()}}}let a=e.mapKind==`enum`?i.INT32:e.scalar,o=Gr(a),s=Vr(a,e.parent.typeName,e.name);return(e,i,a)=>{let c=a[t],l=Object.keys(c);for(let t=0;t<l.length;t++){let i=l[t];e.tag(n,z.LengthDelimited).fork(),r(e,i),e.tag(2,o),s(e,c[i]),e.join()}}}function zr(e){let t=Gr(e.mapKey),n=Vr(e.mapKey,e.parent.typeName,e.name),r=Br(e.mapKey);return(e,i)=>{e.tag(1,t),n(e,r(i))}}function Br(e){switch(e){case i.STRING:return e=>e;case i.BOOL:return e=>e===`true`||e!==`false`&&e;case i.UINT64:case i.FIXED64:return e=>{try{return g.uParse(e)}catch{return e}};case i.INT64:case i.SFIXED64:case i.SINT64:return e=>{try{return g.parse(e)}catch{return e}};default:return e=>{let t=Number.parseInt(e);return Number.isFinite(t)?t:e}}}function Vr(e,t,n){let r=Hr(e);return(e,i)=>{try{r(e,i)}catch(e){throw e instanceof Error?Error(`cannot encode field ${t}.${n} to binary: ${e.message}`):e}}}function Hr(e){switch(e){case i.STRING:return(e,t)=>e.string(t);case i.BOOL:return(e,t)=>e.bool(t);case i.DOUBLE:return(e,t)=>e.double(t);case i.FLOAT:return(e,t)=>e.float(t);case i.INT32:return(e,t)=>e.int32(t);case i.INT64:return(e,t)=>e.int64(t);case i.UINT64:return(e,t)=>e.uint64(t);case i.FIXED64:return(e,t)=>e.fixed64(t);case i.BYTES:return(e,t)=>e.bytes(t);case i.FIXED32:return(e,t)=>e.fixed32(t);case i.SFIXED32:return(e,t)=>e.sfixed32(t);case i.SFIXED64:return(e,t)=>e.sfixed64(t);case i.SINT64:return(e,t)=>e.sint64(t);case i.UINT32:return(e,t)=>e.uint32(t);case i.SINT32:return(e,t)=>e.sint32(t)}}function Ur(e,t,n,r){Pr(r)(e,t,n[C])}function Wr(e){let t=e.number,n=Mr(e.message);return e.delimitedEncoding?(e,r,i)=>{e.tag(t,z.StartGroup),n(e,r,i),e.tag(t,z.EndGroup)}:(e,r,i)=>{e.tag(t,z.LengthDelimited).fork(),n(e,r,i),e.join()}}function Gr(e){switch(e){case i.BYTES:case i.STRING:return z.LengthDelimited;case i.DOUBLE:case i.FIXED64:case i.SFIXED64:return z.Bit64;case i.FIXED32:case i.SFIXED32:case i.FLOAT:return z.Bit32;default:return z.Varint}}function Kr(e,t,n){let r=!1;return n||(n=F(Tr),r=!0),n.value=Ar(e,t),n.typeUrl=Yr(t.$typeName),r?n:void 0}function qr(e,t){return e.typeUrl!==``&&(typeof t==`string`?t:t.typeName)===Xr(e.typeUrl)}function Jr(e,t){if(e.typeUrl===``)return;let n=t.kind==`message`?t:t.getMessage(Xr(e.typeUrl));if(n&&qr(e,n))return lr(n,e.value)}function Yr(e){return`type.googleapis.com/${e}`}function Xr(e){let t=e.lastIndexOf(`/`),n=t>=0?e.substring(t+1):e;if(!n.length)throw Error(`invalid type url: ${e}`);return n}var Zr=wr(`Chxnb29nbGUvcHJvdG9idWYvc3RydWN0LnByb3RvEg9nb29nbGUucHJvdG9idWYihAEKBlN0cnVjdBIzCgZmaWVsZHMYASADKAsyIy5nb29nbGUucHJvdG9idWYuU3RydWN0LkZpZWxkc0VudHJ5GkUKC0ZpZWxkc0VudHJ5EgsKA2tleRgBIAEoCRIlCgV2YWx1ZRgCIAEoCzIWLmdvb2dsZS5wcm90b2J1Zi5WYWx1ZToCOAEi6gEKBVZhbHVlEjAKCm51bGxfdmFsdWUYASABKA4yGi5nb29nbGUucHJvdG9idWYuTnVsbFZhbHVlSAASFgoMbnVtYmVyX3ZhbHVlGAIgASgBSAASFgoMc3RyaW5nX3ZhbHVlGAMgASgJSAASFAoKYm9vbF92YWx1ZRgEIAEoCEgAEi8KDHN0cnVjdF92YWx1ZRgFIAEoCzIXLmdvb2dsZS5wcm90b2J1Zi5TdHJ1Y3RIABIwCgpsaXN0X3ZhbHVlGAYgASgLMhouZ29vZ2xlLnByb3RvYnVmLkxpc3RWYWx1ZUgAQgYKBGtpbmQiMwoJTGlzdFZhbHVlEiYKBnZhbHVlcxgBIAMoCzIWLmdvb2dsZS5wcm90b2J1Zi5WYWx1ZSobCglOdWxsVmFsdWUSDgoKTlVMTF9WQUxVRRAAQn8KE2NvbS5nb29nbGUucHJvdG9idWZCC1N0cnVjdFByb3RvUAFaL2dvb2dsZS5nb2xhbmcub3JnL3Byb3RvYnVmL3R5cGVzL2tub3duL3N0cnVjdHBi+AEBogIDR1BCqgIeR29vZ2xlLlByb3RvYnVmLldlbGxLbm93blR5cGVzYgZwcm90bzM`),Qr=Rn(Zr,0),$r=Rn(Zr,1),ei=Rn(Zr,2),ti;(function(e){e[e.NULL_VALUE=0]=`NULL_VALUE`})(ti||={});function ni(e,t,n){oi(t,e);let r=ii(e.$unknown,t),[i,a,o]=ai(t),s=cr(n);for(let e of r)hr(i,new Me(e.data),a,e.wireType,s);return o()}function ri(e,t,n){oi(t,e);let r=(e.$unknown??[]).filter(e=>e.no!==t.number),[i,a]=ai(t,n),o=new B;Ur(o,{writeUnknownFields:!0},i,a);let s=new Me(o.finish());for(;s.pos<s.len;){let[e,t]=s.tag(),n=s.skip(t,e);r.push({no:e,wireType:t,data:n})}e.$unknown=r}function ii(e,t){if(e===void 0)return[];if(t.fieldKind===`enum`||t.fieldKind===`scalar`){for(let n=e.length-1;n>=0;--n)if(e[n].no==t.number)return[e[n]];return[]}return e.filter(e=>e.no===t.number)}function ai(e,t){let n=e.typeName,r=Object.assign(Object.assign({},e),{kind:`field`,parent:e.extendee,localName:n}),i=Object.assign(Object.assign({},e.extendee),{fields:[r],members:[r],oneofs:[]}),a=F(i,t===void 0?void 0:{[n]:t});return[et(i,a),r,()=>{let t=a[n];if(t===void 0){let t=e.message;return ne(t)?b(t.fields[0].scalar,t.fields[0].longAsString):F(t)}return t}]}function oi(e,t){if(e.extendee.typeName!=t.$typeName)throw Error(`extension ${e.typeName} can only be applied to message ${e.extendee.typeName}`)}var si=Date.parse(`0001-01-01T00:00:00Z`),ci=Date.parse(`9999-12-31T23:59:59Z`),li=3,ui=2,di={alwaysEmitImplicit:!1,enumAsInteger:!1,useProtoFieldName:!1};function fi(e){return e?Object.assign(Object.assign({},di),e):di}function pi(e,t,n){return gi(e)(fi(n),t)}function mi(e,t,n){let r=pi(e,t,n);return JSON.stringify(r,null,n?.prettySpaces??0)}var hi=new WeakMap;function gi(e){let t=hi.get(e);return t===void 0&&(t=_i(e)),t}function _i(e){let t=e.typeName,n=yi(e);if(n!==void 0){let r=e.fields[0],i=(e,i)=>{if(i.$typeName!==t&&r!==void 0)throw new I(r,`cannot use ${r} with message ${i.$typeName}`,`ForeignFieldError`);return n(e,i)};return hi.set(e,i),i}let r=e.fields.concat().sort((e,t)=>e.number-t.number),i=r[0],a=[],o=(n,r)=>{if(r.$typeName!==t&&i!==void 0)throw new I(i,`cannot use ${i} with message ${r.$typeName}`,`ForeignFieldError`);let o={};for(let e=0;e<a.length;e++)a[e](n,r,o);return n.registry&&Ni(o,n,n.registry,r,e),o};hi.set(e,o);for(let e of r){let t=bi(e);a.push(e.jsonName===`__proto__`||e.name===`__proto__`?vi(t):t)}return o}function vi(e){return(t,n,r)=>{let i=Object.create(null);e(t,n,i);for(let e of Object.keys(i))k(r,e,i[e])}}function yi(e){if(e.typeName.startsWith(`google.protobuf.`))switch(e.typeName){case`google.protobuf.Any`:return(e,t)=>Pi(t,e);case`google.protobuf.Timestamp`:return(e,t)=>Bi(t);case`google.protobuf.Duration`:return(e,t)=>Fi(t);case`google.protobuf.FieldMask`:return(e,t)=>Ii(t);case`google.protobuf.Struct`:return(e,t)=>Li(t);case`google.protobuf.Value`:return(e,t)=>Ri(t);case`google.protobuf.ListValue`:return(e,t)=>zi(t);default:if(ne(e)){let t=e.fields[0],n=t.localName,r=b(t.scalar,!1),i=ji(t);return(e,t)=>{let a=t[n];return i(e,a===void 0?r:a)}}return}}function bi(e){switch(e.fieldKind){case`scalar`:case`enum`:case`message`:return xi(e);case`list`:case`map`:{let t=e.fieldKind==`list`?Ti(e):Di(e),n=e.name,r=e.jsonName,i=e.localName;return(e,a,o)=>{let s=t(e,a[i]);s!==void 0&&(o[e.useProtoFieldName?n:r]=s)}}}}function xi(e){let t=Ci(e),n=e.name,r=e.jsonName,a=e.localName;if(e.oneof){let i=e.oneof.localName;return(e,o,s)=>{let c=o[i];c.case===a&&(s[e.useProtoFieldName?n:r]=t(e,c.value))}}if(e.presence!=ui){let i=e.presence==li?`cannot encode ${e} to JSON: required field not set`:void 0;return(e,o,s)=>{let c=o[a];if(c!==void 0&&Object.prototype.hasOwnProperty.call(o,a))s[e.useProtoFieldName?n:r]=t(e,c);else if(i!==void 0)throw Error(i)}}if(e.fieldKind==`enum`){let i=e.enum.values[0].number;return(e,o,s)=>{let c=o[a];(c!==i||e.alwaysEmitImplicit)&&(s[e.useProtoFieldName?n:r]=t(e,c))}}switch(e.scalar){case i.BOOL:return(e,i,o)=>{let s=i[a];(s!==!1||e.alwaysEmitImplicit)&&(o[e.useProtoFieldName?n:r]=t(e,s))};case i.STRING:return(e,i,o)=>{let s=i[a];(s!==``||e.alwaysEmitImplicit)&&(o[e.useProtoFieldName?n:r]=t(e,s))};case i.BYTES:return(e,i,o)=>{let s=i[a];(!(s instanceof Uint8Array)||s.byteLength>0||e.alwaysEmitImplicit)&&(o[e.useProtoFieldName?n:r]=t(e,s))};case i.DOUBLE:case i.FLOAT:return(e,i,o)=>{let s=i[a];(!Object.is(s,0)||e.alwaysEmitImplicit)&&(o[e.useProtoFieldName?n:r]=t(e,s))};default:return(e,i,o)=>{let s=i[a];(s!=0||e.alwaysEmitImplicit)&&(o[e.useProtoFieldName?n:r]=t(e,s))}}}function Si(e){switch(e.fieldKind){case`scalar`:case`enum`:case`message`:return Ci(e);case`list`:return Ti(e);case`map`:return Di(e)}}function Ci(e){switch(e.fieldKind){case`scalar`:return ji(e);case`enum`:return ki(e);case`message`:return wi(e)}}function wi(e){let{toMessage:t}=Je(e),n=gi(e.message);return(e,r)=>n(e,t(r))}function Ti(e){let t=Ei(e);return(e,n)=>{let r=n;if(r.length==0&&!e.alwaysEmitImplicit)return;let i=[];for(let n=0;n<r.length;n++)i.push(t(e,r[n]));return i}}function Ei(e){switch(e.listKind){case`scalar`:return ji(e);case`enum`:return ki(e);case`message`:return wi(e)}}function Di(e){let t=Oi(e);return(e,n)=>{let r=n,i=Object.keys(r);if(i.length==0&&!e.alwaysEmitImplicit)return;let a={};for(let n=0;n<i.length;n++){let o=i[n];k(a,o,t(e,r[o]))}return a}}function Oi(e){switch(e.mapKind){case`scalar`:return ji(e);case`enum`:return ki(e);case`message`:return wi(e)}}function ki(e){let t=e.enum;return t.typeName==`google.protobuf.NullValue`?(e,n)=>{if(typeof n!=`number`)throw Ai(t,n);return null}:(e,n)=>{if(typeof n!=`number`)throw Ai(t,n);return e.enumAsInteger?n:t.value[n]?.jsonName??n}}function Ai(e,t){return Error(`cannot encode ${e} to JSON: expected number, got ${He(t)}`)}function ji(e){switch(e.scalar){case i.INT32:case i.SFIXED32:case i.SINT32:case i.FIXED32:case i.UINT32:return(t,n)=>{if(typeof n!=`number`)throw Mi(e,n);return n};case i.FLOAT:case i.DOUBLE:return(t,n)=>{if(typeof n!=`number`)throw Mi(e,n);return Number.isNaN(n)?`NaN`:n===1/0?`Infinity`:n===-1/0?`-Infinity`:n};case i.STRING:return(t,n)=>{if(typeof n!=`string`)throw Mi(e,n);return n};case i.BOOL:return(t,n)=>{if(typeof n!=`boolean`)throw Mi(e,n);return n};case i.UINT64:case i.FIXED64:case i.INT64:case i.SFIXED64:case i.SINT64:return(t,n)=>{if(typeof n==`bigint`||typeof n==`string`||typeof n==`number`&&Number.isInteger(n))return n.toString();throw Mi(e,n)};case i.BYTES:return(t,n)=>{if(n instanceof Uint8Array)return xt(n);throw Mi(e,n)}}}function Mi(e,t){return Error(`cannot encode ${e} to JSON: ${Ie(e,t)?.message}`)}function Ni(e,t,n,r,i){let a=r.$unknown;if(a===void 0)return;let o=new Set;for(let s=0;s<a.length;s++){let{no:c}=a[s];if(!o.has(c)){o.add(c);let a=n.getExtensionFor(i,c);if(!a)continue;let[s,l]=ai(a,ni(r,a)),u=s[C],d=Si(l)(t,u[l.localName]);d!==void 0&&(e[a.jsonName]=d)}}}function Pi(e,t){if(e.typeUrl===``)return{};let{registry:n}=t,r,i;if(n&&(r=Jr(e,n),r&&(i=n.getMessage(r.$typeName))),!i||!r)throw Error(`cannot encode message ${e.$typeName} to JSON: "${e.typeUrl}" is not in the type registry`);let a=re(i)?{value:gi(i)(t,r)}:gi(i)(t,r);return a[`@type`]=e.typeUrl,a}function Fi(e){let t=Number(e.seconds),n=e.nanos;if(t>315576e6||t<-315576e6)throw Error(`cannot encode message ${e.$typeName} to JSON: value out of range`);if(t>0&&n<0||t<0&&n>0)throw Error(`cannot encode message ${e.$typeName} to JSON: nanos sign must match seconds sign`);let r=e.seconds.toString();if(n!==0){let e=Math.abs(n).toString();e=`0`.repeat(9-e.length)+e,e.substring(3)===`000000`?e=e.substring(0,3):e.substring(6)===`000`&&(e=e.substring(0,6)),r+=`.`+e,n<0&&t==0&&(r=`-`+r)}return r+`s`}function Ii(e){return e.paths.map(t=>{if(Ot(Dt(t))!==t)throw Error(`cannot encode message ${e.$typeName} to JSON: lowerCamelCase of path name "${t}" is irreversible`);return Dt(t)}).join(`,`)}function Li(e){let t={},n=Object.keys(e.fields);for(let r=0;r<n.length;r++){let i=n[r];k(t,i,Ri(e.fields[i]))}return t}function Ri(e){switch(e.kind.case){case`nullValue`:return null;case`numberValue`:if(!Number.isFinite(e.kind.value))throw Error(`${e.$typeName} cannot be NaN or Infinity`);return e.kind.value;case`boolValue`:return e.kind.value;case`stringValue`:return e.kind.value;case`structValue`:return Li(e.kind.value);case`listValue`:return zi(e.kind.value);default:throw Error(`${e.$typeName} must have a value`)}}function zi(e){return e.values.map(Ri)}function Bi(e){let t=Number(e.seconds)*1e3;if(t<si||t>ci)throw Error(`cannot encode message ${e.$typeName} to JSON: must be from 0001-01-01T00:00:00Z to 9999-12-31T23:59:59Z inclusive`);if(e.nanos<0)throw Error(`cannot encode message ${e.$typeName} to JSON: nanos must not be negative`);if(e.nanos>999999999)throw Error(`cannot encode message ${e.$typeName} to JSON: nanos must not be greater than 999999999`);let n=`Z`;if(e.nanos>0){let t=(e.nanos+1e9).toString().substring(1);n=t.substring(3)===`000000`?`.`+t.substring(0,3)+`Z`:t.substring(6)===`000`?`.`+t.substring(0,6)+`Z`:`.`+t+`Z`}return new Date(t).toISOString().replace(`.000Z`,n)}var Vi=2;function Hi(e){return Object.assign(Object.assign({ignoreUnknownFields:!1,recursionLimit:100},e),{depth:0})}function Ui(e,t,n){return Wi(e,fa(t,e.typeName),n)}function Wi(e,t,n){let r=F(e);return Gi(e,r,t,n),r}function Gi(e,t,n,r){try{qi(e)(t,n,Hi(r))}catch(e){throw Ce(e)?Error(`cannot decode ${e.field()} from JSON: ${e.message}`,{cause:e}):e}}var Ki=new WeakMap;function qi(e){let t=Ki.get(e);return t===void 0&&(t=Ji(e)),t}function Ji(e){let t=String(e),n=Yi(e);if(n!==void 0){let r=(e,r,i)=>{if(++i.depth>i.recursionLimit)throw Error(`cannot decode ${t} from JSON: maximum recursion depth of ${i.recursionLimit} reached`);n(e,r,i),i.depth--};return Ki.set(e,r),r}let r=e.typeName,i=new Map,a=(e,n,a)=>{if(++a.depth>a.recursionLimit)throw Error(`cannot decode ${t} from JSON: maximum recursion depth of ${a.recursionLimit} reached`);if(n==null||Array.isArray(n)||typeof n!=`object`)throw Error(`cannot decode ${t} from JSON: ${He(n)}`);let o=new Map,s=new Set,c=Object.keys(n);for(let l=0;l<c.length;l++){let u=c[l],d=n[u],f=i.get(u);if(f!==void 0){let t=f.field;if(s.has(t))throw new I(t,`set multiple times`);if(s.add(t),f.oneofScalarNullSkip&&d===null)continue;if(f.oneof){let e=o.get(f.oneof);if(e!==void 0)throw new I(f.oneof,`oneof set multiple times by ${e.name} and ${t.name}`);o.set(f.oneof,t)}f.read(e,d,a)}else{let n=u.startsWith(`[`)&&u.endsWith(`]`)?a.registry?.getExtension(u.substring(1,u.length-1)):void 0;if(n?.extendee.typeName==r){let[t,r,i]=ai(n);Xi(r)(t[C],d,a),ri(e,n,i())}if(n===void 0&&!a.ignoreUnknownFields)throw Error(`cannot decode ${t} from JSON: key "${u}" is unknown`)}}a.depth--};Ki.set(e,a);for(let t of e.fields){let e={read:Xi(t),field:t,oneof:t.oneof,oneofScalarNullSkip:t.oneof!==void 0&&t.fieldKind==`scalar`};i.set(t.name,e).set(t.jsonName,e)}return a}function Yi(e){if(e.typeName.startsWith(`google.protobuf.`))switch(e.typeName){case`google.protobuf.Any`:return(e,t,n)=>ma(e,t,n);case`google.protobuf.Timestamp`:return(e,t)=>ha(e,t);case`google.protobuf.Duration`:return(e,t)=>ga(e,t);case`google.protobuf.FieldMask`:return(e,t)=>_a(e,t);case`google.protobuf.Struct`:return(e,t,n)=>va(e,t,n);case`google.protobuf.Value`:return(e,t,n)=>ya(e,t,n);case`google.protobuf.ListValue`:return(e,t,n)=>ba(e,t,n);default:if(ne(e)){let t=e.fields[0],n=t.localName,r=t.scalar,i=t.longAsString,a=sa(t);return(e,t)=>{t===null?e[n]=b(r,i):e[n]=a(t)}}return}}function Xi(e){switch(e.fieldKind){case`scalar`:return Zi(e);case`enum`:return $i(e);case`message`:return ea(e);case`list`:return ta(e);case`map`:return ra(e)}}function Zi(e){let t=sa(e),n=e.localName;if(e.oneof){let r=e.oneof.localName;return(e,i)=>{e[r]={case:n,value:t(i)}}}let r=Qi(e);return(e,i)=>{i===null?r(e):e[n]=t(i)}}function Qi(e){let t=e.localName;if(e.presence!=Vi)return e=>{delete e[t]};if(e.fieldKind==`enum`){let n=e.enum.values[0].number;return e=>{e[t]=n}}let n=e.scalar,r=e.longAsString;return e=>{e[t]=b(n,r)}}function $i(e){let t=aa(e.enum),n=oa(e.enum),r=e.localName,i=e.enum.typeName!=`google.protobuf.NullValue`;if(e.oneof){let a=e.oneof.localName;return(o,s,c)=>{if(s===null&&i){o[a].case===r&&(o[a]={case:void 0});return}let l=t(s,c.ignoreUnknownFields);if(l===ia)return;let u=n(l);if(u!==!0)throw new I(e,Ve(e,l,u));o[a]={case:r,value:l}}}let a=Qi(e);return(o,s,c)=>{if(s===null&&i){a(o);return}let l=t(s,c.ignoreUnknownFields);if(l===ia)return;let u=n(l);if(u!==!0)throw new I(e,Ve(e,l,u));o[r]=l}}function ea(e){let t=e.localName,{toMessage:n,toLocal:r}=Je(e),i=qi(e.message),a=e.message.typeName!=`google.protobuf.Value`;if(e.oneof){let o=e.oneof.localName;return(e,s,c)=>{let l=e[o];if(s===null&&a){l.case===t&&(e[o]={case:void 0});return}let u=n(l.case===t?l.value:void 0);i(u,s,c),e[o]={case:t,value:r(u)}}}return(e,o,s)=>{if(o===null&&a){delete e[t];return}let c=n(e[t]);i(c,o,s),e[t]=r(c)}}function ta(e){let t=e.localName,n=na(e);return(r,i,a)=>{if(i===null)return;if(!Array.isArray(i))throw new I(e,`expected Array, got `+He(i));let o=r[t];for(let e=0;e<i.length;e++){let t=n(i[e],a,o.length);t!==ia&&o.push(t)}}}function na(e){switch(e.listKind){case`scalar`:{let t=ca(e),n=Be(e.scalar),r=la(e);return(i,a,o)=>{if(i===null)throw new I(e,`list item must not be null`);let s=t(i),c=n(s);if(c!==!0)throw new I(e,`list item #${o+1}: ${Ve(e,s,c)}`);return r(s)}}case`enum`:{let t=aa(e.enum),n=oa(e.enum),r=e.enum.typeName!=`google.protobuf.NullValue`;return(i,a,o)=>{if(i===null&&r)throw new I(e,`list item must not be null`);let s=t(i,a.ignoreUnknownFields);if(s===ia)return s;let c=n(s);if(c!==!0)throw new I(e,`list item #${o+1}: ${Ve(e,s,c)}`);return s}}case`message`:{let{toMessage:t,toLocal:n}=Je(e),r=qi(e.message),i=e.message.typeName!=`google.protobuf.Value`;return(a,o)=>{if(a===null&&i)throw new I(e,`list item must not be null`);let s=t(void 0);return r(s,a,o),n(s)}}}}function ra(e){let t=e.localName,n=e.mapKey,r=ua(n),i=Be(n),a,o,s=e=>e,c=!0;switch(e.mapKind){case`scalar`:a=ca(e),o=Be(e.scalar),s=la(e);break;case`enum`:{let t=aa(e.enum);a=(e,n)=>t(e,n.ignoreUnknownFields),o=oa(e.enum),c=e.enum.typeName!=`google.protobuf.NullValue`;break}case`message`:{let{toMessage:t,toLocal:n}=Je(e),r=qi(e.message);c=e.message.typeName!=`google.protobuf.Value`,a=(e,i)=>{let a=t(void 0);return r(a,e,i),n(a)};break}}return(l,u,d)=>{if(u===null)return;if(typeof u!=`object`||Array.isArray(u))throw new I(e,`expected object, got `+He(u));let f=l[t],p=new Set,m=Object.keys(u);for(let t=0;t<m.length;t++){let l=m[t],h=u[l],g=r(l);if(p.has(g))throw new I(e,`duplicate map key "${l}"`);if(p.add(g),h===null&&c)throw new I(e,`map value must not be null`);let _=a(h,d);if(_===ia)continue;let v=i(g);if(v!==!0)throw new I(e,`invalid map key: ${Ve({scalar:n},g,v)}`);if(o!==void 0){let t=o(_);if(t!==!0)throw new I(e,`map entry ${He(g)}: ${Ve(e,_,t)}`)}k(f,g,s(_))}}}var ia=Symbol();function aa(e){let t=e.values[0].number,n=new Map;for(let t of e.values)n.set(t.jsonName,t.number);for(let t of e.values)n.set(t.name,t.number);return(r,i)=>{if(r===null)return t;switch(typeof r){case`number`:if(Number.isInteger(r))return r;break;case`string`:{let e=n.get(r);if(e!==void 0)return e;if(i)return ia;break}}throw Error(`cannot decode ${e} from JSON: ${He(r)}`)}}function oa(e){if(e.open)return Be(i.INT32);let t=e.values;return e=>t.some(t=>t.number===e)}function sa(e){let t=ca(e),n=Be(e.scalar),r=la(e);return i=>{let a=t(i),o=n(a);if(o!==!0)throw new I(e,Ve(e,a,o));return r(a)}}function ca(e){switch(e.scalar){case i.DOUBLE:case i.FLOAT:return t=>{if(t===`NaN`)return NaN;if(t===`Infinity`)return 1/0;if(t===`-Infinity`)return-1/0;if(typeof t==`number`){if(Number.isNaN(t))throw new I(e,`unexpected NaN number`);if(!Number.isFinite(t))throw new I(e,`unexpected infinite number`);return t}if(typeof t==`string`){if(t===``||t.trim().length!==t.length)return t;let e=Number(t);return Number.isFinite(e)?e:t}return t};case i.INT32:case i.FIXED32:case i.SFIXED32:case i.SINT32:case i.UINT32:return da;case i.BYTES:return t=>{if(typeof t==`string`){if(t===``)return new Uint8Array;try{return _t(t)}catch(t){throw new I(e,t instanceof Error?t.message:String(t))}}return t};default:return e=>e}}function la(e){let t=e.fieldKind!==`map`&&e.longAsString;switch(e.scalar){case i.INT64:case i.SFIXED64:case i.SINT64:return t?e=>String(e):e=>typeof e==`string`||typeof e==`number`?g.parse(e):e;case i.FIXED64:case i.UINT64:return t?e=>String(e):e=>typeof e==`string`||typeof e==`number`?g.uParse(e):e;default:return e=>e}}function ua(e){switch(e){case i.BOOL:return e=>{switch(e){case`true`:return!0;case`false`:return!1}return e};case i.INT32:case i.FIXED32:case i.UINT32:case i.SFIXED32:case i.SINT32:return da;case i.INT64:case i.SINT64:case i.SFIXED64:case i.UINT64:case i.FIXED64:return e=>/^-?0+$/.test(e)?`0`:e.replace(/^(-?)0+(?=\d)/,`$1`);default:return e=>e}}function da(e){if(typeof e==`string`){if(e===``||e.trim().length!==e.length)return e;let t=Number(e);return Number.isNaN(t)?e:t}return e}function fa(e,t){let n;try{n=JSON.parse(e)}catch(e){let n=e instanceof Error?e.message:String(e);throw Error(`cannot decode message ${t} from JSON: ${n}`,{cause:e})}return pa(e,t),n}function pa(e,t){let n=[],r=!1,i=0;for(;i<e.length;)switch(e[i]){case`{`:n.push(new Set),r=!0,i++;break;case`[`:n.push(null),r=!1,i++;break;case`}`:case`]`:n.pop(),r=!1,i++;break;case`,`:r=n[n.length-1]!=null,i++;break;case`:`:r=!1,i++;break;case`"`:{let a=i++,o=!1;for(;i<e.length;)if(e[i]==`\\`)o=!0,i+=2;else{if(e[i]==`"`)break;i++}let s=i++,c=n[n.length-1];if(r&&c){let n=o?JSON.parse(e.substring(a,s+1)):e.substring(a+1,s);if(c.has(n))throw Error(`cannot decode message ${t} from JSON: duplicate object key "${n}"`);c.add(n)}r=!1;break}default:i++}}function ma(e,t,n){if(t===null||Array.isArray(t)||typeof t!=`object`)throw Error(`cannot decode message ${e.$typeName} from JSON: expected object but got ${He(t)}`);if(Object.keys(t).length==0)return;let r=t[`@type`];if(typeof r!=`string`||r==``)throw Error(`cannot decode message ${e.$typeName} from JSON: "@type" is empty`);let i=r.includes(`/`)?r.substring(r.lastIndexOf(`/`)+1):r;if(!i.length)throw Error(`cannot decode message ${e.$typeName} from JSON: "@type" is invalid`);let a=n.registry?.getMessage(i);if(!a)throw Error(`cannot decode message ${e.$typeName} from JSON: ${r} is not in the type registry`);let o=F(a);if(re(a)&&Object.prototype.hasOwnProperty.call(t,`value`))qi(a)(o,t.value,n);else{let e={};for(let n of Object.keys(t))n!==`@type`&&k(e,n,t[n]);qi(a)(o,e,n)}Kr(a,o,e)}function ha(e,t){if(typeof t!=`string`)throw Error(`cannot decode message ${e.$typeName} from JSON: ${He(t)}`);let n=t.match(/^([0-9]{4})-([0-9]{2})-([0-9]{2})T([0-9]{2}):([0-9]{2}):([0-9]{2})(?:\.([0-9]{1,9}))?(?:Z|([+-][0-9][0-9]:[0-9][0-9]))$/);if(!n)throw Error(`cannot decode message ${e.$typeName} from JSON: invalid RFC 3339 string`);let r=Date.parse(n[1]+`-`+n[2]+`-`+n[3]+`T`+n[4]+`:`+n[5]+`:`+n[6]+(n[8]?n[8]:`Z`));if(Number.isNaN(r))throw Error(`cannot decode message ${e.$typeName} from JSON: invalid RFC 3339 string`);if(r<si||r>ci)throw Error(`cannot decode message ${e.$typeName} from JSON: must be from 0001-01-01T00:00:00Z to 9999-12-31T23:59:59Z inclusive`);e.seconds=g.parse(r/1e3),e.nanos=0,n[7]&&(e.nanos=parseInt(`1`+n[7]+`0`.repeat(9-n[7].length))-1e9)}function ga(e,t){if(typeof t!=`string`)throw Error(`cannot decode message ${e.$typeName} from JSON: ${He(t)}`);let n=t.match(/^(-?[0-9]+)(?:\.([0-9]+))?s/);if(n===null)throw Error(`cannot decode message ${e.$typeName} from JSON: ${He(t)}`);let r=Number(n[1]);if(r>315576e6||r<-315576e6)throw Error(`cannot decode message ${e.$typeName} from JSON: ${He(t)}`);if(e.seconds=g.parse(r),typeof n[2]!=`string`)return;let i=n[2]+`0`.repeat(9-n[2].length);e.nanos=parseInt(i),(r<0||Object.is(r,-0))&&(e.nanos=-e.nanos)}function _a(e,t){if(typeof t!=`string`)throw Error(`cannot decode message ${e.$typeName} from JSON: ${He(t)}`);t!==``&&(e.paths=t.split(`,`).map(t=>{if(t.includes(`_`))throw Error(`cannot decode message ${e.$typeName} from JSON: path names must be lowerCamelCase`);return Ot(t)}))}function va(e,t,n){if(typeof t!=`object`||!t||Array.isArray(t))throw Error(`cannot decode message ${e.$typeName} from JSON ${He(t)}`);let r=Object.keys(t);for(let i=0;i<r.length;i++){let a=r[i],o=F($r);ya(o,t[a],n),k(e.fields,a,o)}}function ya(e,t,n){if(++n.depth>n.recursionLimit)throw Error(`cannot decode ${e.$typeName} from JSON: maximum recursion depth of ${n.recursionLimit} reached`);switch(typeof t){case`number`:e.kind={case:`numberValue`,value:t};break;case`string`:e.kind={case:`stringValue`,value:t};break;case`boolean`:e.kind={case:`boolValue`,value:t};break;case`object`:if(t===null)e.kind={case:`nullValue`,value:ti.NULL_VALUE};else if(Array.isArray(t)){let r=F(ei);ba(r,t,n),e.kind={case:`listValue`,value:r}}else{let r=F(Qr);va(r,t,n),e.kind={case:`structValue`,value:r}}break;default:throw Error(`cannot decode message ${e.$typeName} from JSON ${He(t)}`)}return n.depth--,e}function ba(e,t,n){if(!Array.isArray(t))throw Error(`cannot decode message ${e.$typeName} from JSON ${He(t)}`);for(let r=0;r<t.length;r++){let i=F($r);ya(i,t[r],n),e.values.push(i)}}var xa=class extends Error{};function Sa({unitsPerMeter:e,rotationComponent:t}){return Number.isInteger(e)&&e>=1&&e<=65536&&Number.isInteger(t)&&t>=1&&t<=16383}var Ca=-2147483648,wa=2147483647;function Ta(e,t){return e.largest===t.largest&&e.rotation[0]===t.rotation[0]&&e.rotation[1]===t.rotation[1]&&e.rotation[2]===t.rotation[2]}function Ea(e,t){return e.position[0]===t.position[0]&&e.position[1]===t.position[1]&&e.position[2]===t.position[2]&&Ta(e,t)}var Da=class{frame;at=0;constructor(e){this.frame=e}find(e){let t=this.frame?.entities;if(!t)return;for(;this.at<t.length&&t[this.at].id<e;)this.at++;let n=t[this.at];return n?.id===e?n:void 0}};function Oa(e,t){let n=new Da(e.baseline2),r=new Da(e.baseline2?e.baseline3:void 0),i=[];return(e.baseline?.entities??[]).forEach((e,a)=>{if(t.has(a))return;let o=n.find(e.id);i.push({b1:e,b2:o,b3:o?r.find(e.id):void 0})}),i}function ka(e,t){let n=0,r=0;for(let t=0;t<3;t++)n+=e[t]*e[t],r=Math.max(r,Math.abs(e[t]));return r<=t&&n<=2*t*t}function Aa(e,t){return t.length===0?e:[...e,...t].sort((e,t)=>e.id-t.id)}var ja=255;function Ma(e,t){let n=[0,0,0];if(t===0)return n;let r=t&255,i=t>>>8&255,a=t>>>16;if(r===0||r===ja||a>ja||i===ja&&a!==0)throw new xa(`frame ${e}: invalid baselines ${t}: distances must be 1 to 254`);let o=e;for(let[s,c]of[r,i,a].entries()){if(c===ja)break;if(r=c||r,o-=r,o<=0)throw new xa(`frame ${e}: baselines ${t} are before the first frame`);n[s]=o}return n}var Na=15,Pa=33,Fa=2**Na-1,Ia=24,La=class{at=0;bytes;end;constructor(e){this.bytes=new Uint8Array(e.length+4),this.bytes.set(e),this.end=e.length*8}peek(){if(this.at>this.end)return 0;let{bytes:e}=this,t=this.at>>3;return(e[t]|e[t+1]<<8|e[t+2]<<16|e[t+3]<<24)>>>(this.at&7)}bits(e){if(e>Ia)return this.bits(Ia)+this.bits(e-Ia)*2**Ia;let t=this.peek()&(1<<e)-1;return this.at+=e,t}rice(e){let t=~this.peek()&Fa;if(t===0)return this.at+=Na,this.bits(Pa);let n=31-Math.clz32(t&-t);return this.at+=n+1,(n<<e)+this.bits(e)}expGolomb(e){let t=this.rice(0)+e;return t>40?(this.at=this.end+1,0):this.bits(t)+2**t-2**e}takeEscape(){return(this.peek()&Fa)===Fa&&(this.at+=Na,!0)}get pastEnd(){return this.at>this.end}get position(){return this.at}atCleanEnd(){let e=this.end-this.at;return e>=0&&e<8&&this.bits(e)===0}};function Ra(e){return e%2==1?-(e+1)/2:e/2}function za(e){return e<2**32?32-Math.clz32(e):32+za(Math.floor(e/2**32))}var Ba=new Uint32Array(256);for(let e=0;e<256;e++){let t=e;for(let e=0;e<8;e++)t=t&1?3988292384^t>>>1:t>>>1;Ba[e]=t>>>0}function Va(e){let t=4294967295;for(let n=0;n<e.length;n++)t=Ba[(t^e[n])&255]^t>>>8;return(t^4294967295)>>>0}function Ha(e,t){let n=Math.trunc(t/2);return e>=0?Math.trunc((e+n)/t):-Math.trunc((-e+n)/t)}function Ua(e,t,n){return t===n?e:Ha(e*t,n)}function Wa(e,t,n){let r=0,i=0;for(let t=0;t<4;t++)t!==e.largest&&(n[t]=e.rotation[i++],r+=n[t]*n[t]);let a=Math.floor(Math.sqrt(Math.max(0,t-r)));for(;a*a>t-r&&a>0;)a--;for(;(a+1)*(a+1)<=t-r;)a++;return n[e.largest]=a,n}function Ga(e,t){if(e[0]*t[0]+e[1]*t[1]+e[2]*t[2]+e[3]*t[3]<0)for(let t=0;t<4;t++)e[t]=-e[t]}var Ka=[0,0,0,0],qa=[0,0,0,0],Ja=[0,0,0,0],Ya=[0,0,0,0],Xa=[0,0,0,0],Za=[0,0,0,0],Qa={position:[0,0,0],positionStep:[0,0,0],positionAcceleration:[0,0,0],rotation:Ya,rotationStep:Xa,rotationAcceleration:Za,largest:0,components:[0,0,0],positionChange:0,rotationChange:0};function $a(e,t,n){let{b1:r}=e,i=r.atRest?void 0:e.b2,a=i?e.b3:void 0,{position:o,positionStep:s,positionAcceleration:c,components:l}=Qa,u=0;for(let e=0;e<3;e++){let n=i?r.position[e]-i.position[e]:0,l=i&&a?Ua(i.position[e]-a.position[e],t.dt2,t.dt3):n;o[e]=Math.min(wa,Math.max(Ca,r.position[e]+Ua(n,t.dt1,t.dt2))),s[e]=n,c[e]=n-l,u+=Math.abs(n-l)}let d=2*n*n;Wa(r,d,Ka);for(let e=0;e<4;e++)Ya[e]=Ka[e],Xa[e]=0,Za[e]=0;if(i&&(!Ta(r,i)||a&&!Ta(i,a))){Ga(Wa(i,d,qa),Ka);let e=0;for(let t=0;t<4;t++)Xa[t]=Ka[t]-qa[t],e+=Xa[t]*Xa[t];if(a){Ga(Wa(a,d,Ja),qa);for(let e=0;e<4;e++)Za[e]=Xa[e]-Ua(qa[e]-Ja[e],t.dt2,t.dt3)}if(e<=Math.trunc(d/2)){let r=t.dt1===t.dt2?e:Ha(e*t.dt1*(t.dt1+t.dt2),2*t.dt2*t.dt2),i=r*n>=Math.trunc(d/4);for(let e=0;e<4;e++)Ya[e]=Ka[e]+Ua(Xa[e],t.dt1,t.dt2)-(i?Ha(Ka[e]*r,d):0)}else Xa.fill(0)}let f=0;for(let e=1;e<4;e++)Math.abs(Ya[e])>Math.abs(Ya[f])&&(f=e);let p=Ya[f]<0?-1:1,m=0,h=0;for(let e=0;e<4;e++)e!==f&&(l[h++]=p*Ya[e],m+=Math.abs(Za[e]));return Qa.largest=f,Qa.positionChange=u,Qa.rotationChange=m,Qa}var eo=[`Rn%nb,9eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee.(%x1eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)e(plb%PvdpTeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeh(%xFlFeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)ez.>:,(zxnnhhbXfPPeeeeeeeeeeeeeeeeeeeeeeefprvrpnjfZXdFeeeeeeeeeeeeeeeeeeeeeeeeee)ejxvttzzvpbhhdhbBeeeeeeeeeeeeeeeeeeeeeeeedffnfjljppXdfLeeeeeeeeeeeeeeeeeeeeeeeee)eeeeeLPrbNBD1D9eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeXdRdZXfLTXXfZbZjhnlbXdTXZXfNNTVdTTXbffdbVdddb)XfXTZPdXXXXffdbfnLRVdnJJVdjVTXhthdgfnRVVdpNNTfjVTXlffddhhbZZfhXVXfjZZbjffdbhjXRd)fjVXbhhbXXrffoehhZVXfhVTXhfbVXjbhfhhddbZfdZXZhddZZnbjfdfbbdRhZfbTjXhZZoSoSahbfbZ)fbdZbjbdbdlfjlgjbffbhdbbhjbfbbnbjhfeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeRlNZXbhdfZpfhnjeeeee)RjPTVVfZXZdXdhfeeeeeTfXZZRdXZbZZZfUeeeeebhRTTfhZVbooaWWeeeeedlTRVffZVZhdZmeeeeee)ffXVTffbXXjfjlUeeeeefhZTXhhbbdeeeeeeeeeehhZVZjfdZZjaogWeeeeehhbXbhffZbhdhddeeeee)fbhbddnVWkeeeeeeeeeefffddjbhdXdUmeWeeeeehhfdbjfhfdrflfbplfdfldZkejtlheeeeeeljfdb)lldXfljhbZxhljgljhfbjlbVZnjfdbpjlfbhfZVbhfXXbhhdXbpppfmhhbXZhfZPXjhbXZnhjdblhdbb)hhZTZjhdVZnhjdbfTNTXfTNPThdXVZlZhRbhZTVXhZRPThdZVXlfjdbjdbZbjfZTZhdZXXlffddbhNTX)bhNRVfhXVVldjbfdhTVXdhRNTfhXVXjfhbbffbZZhhXVVffZXZjdfdbjxTNNlzTFJjpVRXjdfdZjrTRT)jvRJPjnVPVndhdbjhbbZhjXTXjjXXZlffdbprdJPpvdDLljbXZeWWeellZTVlnZNRjjbTXndhhhlfdbZ)jhZXbjfbXZldjfdhZdfglfZWkfddgWeeeeeldfbXljbXVldfZbrdhffldhdbjfdZbldfZbnbjhdeeeee)njjjPrllneeeeeeeeeeelhfdblfhdbjZjgkeeeeejffdbpfhddtdpfVeeeeejfbZVjdbdTeeeeeeeeee)hfbVXlhdXbpfZWkeeeeejfbZZnffXZjZdreeeeeehbXPThfbbZeeeeeeeeeehdXRThhbXZgemekeeeee)hfbVXlhdZbljnfZeeeeefhTPVhhbXXeeeeeeeeeefhVNVhhZVXjZZeWeeeeehhbVXjhbZZlflfUeeeee)ntXJLjlZNToagUUeeeeelrVNRllbVVvjhXbeeeeellbTVnlbVXnnddZeeeeeppdNNllbdbekkkeeeeee)nnbPTljdXXpjljUeeeeelnbVXljfZbljjbdeeeeetXjdXvfnvemUmmeeeeeenhfddpdhbZtZjreeeeee)nlhZZphhddphnljlljZZvnhZdphfheeeeeellhdbnlfZbnnhbdnllhhnjhddjjdZbllhbbtjnfdjhdZb)hhdVXhlfXZmeekejhdXZhhbPZljdXZnjjhflhfZbjhbXZlhfZZnjlfbhTRTZhTPRXhdbTZrjjffhbXVZ)hZTRZhdZVZnhjddjdbbbhfbTZjdbZZlfhfbdhTVXbhPNRfhZTXjbhdfdhXVXdhTRVfhZTXnhjZdhfbbZ)hfbVVhfbXZldhdbjvPTVjvPLThlZRZlhjdZjnVVXjpTNVjlZRXpfhbdjhbZZhhZXXjhbXZndhfblhdXX)jldVZjhdZblXlfmlhdXZjlbRVlhdVZpdlfdldfbbjfbXZjfdXbnbjfdjfhZhlhfdZjbhZdooogklfhbb)jfdXbnffZdrbndfndhddjddZZldhbbpblfdeeeeepjhfbxjnhfeeeeeeeeeelhhdbpjjddvpvjaeeeee)lfhbbphjdbrhnjbeeeeejhdTXllhdfeeeeeeeeeejhdVZnhfZbrbrheeeeeejffXZlhhXbpnlffeeeee)jdZRVjjfRbkWkWkeeeeehdbRXlhfXbtntdReeeeelffVZlhhZbzdlZdeeeeehdbRTjhfZXtftPVeeeee)hfZTXjhfXZlhjhmeeeeelffXZlhfZZljhfbeeeeejfbNRjhbRXeeeeeeeeeehhbRVlhdVZphlbZeeeee)lhdXZlhhZZthjXleeeeelhdVXnhhdXpppTTeeeeelhfVZljhZbnflbTeeeeeljfZZnjjbbrjlZjeeeee)ndjjfpphZleeeeeeeeeephjddphjddpjphfeeeeenjjbdphlddpfljbpnlddprpTdrppddthnnkpnlfd)tplVbpnjfdxnnlhpnnjdllhdbpljfdtnpldllhbfhjhbjnnjZhpjnhZnnhZdlnjXfnnhZbtnpjdnljfd)ljdbbllhbbplnhfhXVbZhXRVVhfbbZvjjffjdZZbhZVVZjfbZbpjlfflffdbjhdbZjfbZbpjlhddfXZX)dfTTThfbZbrhjjfffZZZdfVTVffbXZphlhdhffdbhfbZXffbZbnhlhdhnTZZhlRVXjjZZZpfndZhjZZZ)hlVVXjhbXZphlfdjfddbjfbZZjhbbbpfjfbjdfbfjbhbjlbhZfphjhflbhZdjbhZflbfXbpflffldhdb)jddZbjdfbbpdlhdnXnddrXtXdldjXdrVnlanbjdbnZjXdnbhbdpdnhdpdlhdldfbbldhddrdnjfeeeee)tpnpbvlplfttnzeeeeeepjljdtnplfvr#rfeeeeepflhdtlpldxpvrdeeeeenjjbfpllfdooooeeeeee)lhhdbrllhdvnrpZeeeeenfjfbpjlhdvlrnfeeeeelffZZtjhhbvvvveeeeeeldfZZpljfdvprtaeeeee)ndhdbpjlhdrnpldeeeeepVlRbpjjfbrnppeeeeeelZfVZnjjfbvrvnjeeeeendjdbphjfbvlrnfeeeee)tRfPNpjjfbtnzlReeeeenXfVVnhjdb%nplbeeeeendjddphlhdtlrlfeeeeelRZVRphlhdx%%tUeeeee)lXdbZpfjfdxrtpbeeeeepbjfdpflfdtjpjdeeeee(P#xdtfplfxnttbeeeeexTtpdtdnldvltpfeeeee)tbplfrdpjdvfrnfZbbVLeeeeeeeZZZbLeeeeeeeeXVXHeeeeeeeeZZTfeeeeeeeeeXVVHeeeeeeeeZXX)ZeeeeeeeeeZbZXVJWeeeeedbZZbbWeeeeeej#>ebVeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee)eeeeeeeeeeeeeeeeeeeeeeeeeeZdLRVTdZhbTfPfXXdTZXhdhhbZdLPVZfTZXZdPTVbdPTXbdXbZXdVN)XVdbbZRfVTXddZVXffdbbfhLJRdlTVXfjNZVdnPTVfhZdZflPRVflVXXfnPTVfnRRVfjZZZfhXVVhddb)ZffZTZffZXZjfddbhhZNThhbVTjhbXXhjZTVjfbZZhjVTThfbZZhhXVVhhZTZjfdZZhdXXbjdfbbhdZV)ZhfbXZldfdbZWkWWnbffZxblfflbfjarbhbZffZfSlbfddjdbZbjddbbldhddhfbZbnbjfbhdfdbjddb)bnbjhdkkkkenjffalfjfXlnjrethfhfhjhVVlhhddjhddXjjdbbljhdbljdZZnhjfdlhdXZjjfbbphjf)dhdbaehfbXbjbdbVhdZNZjhddXhfZXXjhdZZhfbXZhfbTXjhfbZjjdTVlhfbbjfbZbjfdXblhhdbhTNR)RhVTZZhRNVVhVRTVjdbdZhXRVVhZXXZhXRTXhXTRVhdbZZhjbLZjhdZZjhZVZhhbVblhfbbdjRHXdhVX)XbhRXVdhRTVhhbZZdhTBTdhXXXdhTPVdhTTVhhZZZhjbXVjhdZZhhZVVhhbVZlffbbn#b3DlrVVTlvZP)LltTPPjlZbZlvXJNjpVVXjrVLRjrTPRjlZXXhlZPVjhdbZhlZVZhhZTVlhfbbtzjDJnpbRRrthPNntZP)RljdXXnrdNPllbVXlnbPRlnbPTljdZZllbNXlffbZjjbXXjhbZXlffbbgmeWkjhhXVnVjjZjfbSanfjf)njddPZndfbblffVZlhdXbldhbbjffXXpdjfdlffbblffZZpdjfdekWeenhhbXpjjhblnjjanjlfflhhb)ZnjjddllhXZljhZbpjjfdllhZbpjlfdljfddnjhbdpjlhdjdZZojhfZbhhdZbjfZPXnjfdbjhdVZlhfZ)ZjhdVZjhdVZljhZblldXbnjhdbjjdZbjjfZbnjjdbhPNPPhXVZZfTRdXhVRTVjddbbhXTRVhbZXZhXTR)XhXTTXjdbbbjjdXblhfbbjhbVdjjdXZlhhdbbhRTTdfXZZbfPZXdhTRZhhddZbfTRXffZZZdfTTXdfVT)VhhbZZjhdRZlhfbbhhdVZjhdXZlhhbbhtPTNhpVXVhvPXThrTTVjlbbbhpTRXjlZXZhpVPXhpVRXjjbZ)ZjhfTVlhfbbjfdVXjhdVZlhhbblpfbbljdXZnlfbdljdVXlhfbblldTZlhfZZjjdTZjjdVZlhhbbjhfV)VlfhbbjhdXbjffXbnfjdbxpnnepfhbZpdnhhjZhVbnhhdblfjZZnfhddlhhbZlhhZdnfjddjhdZXpdjf)dlffbblfhbbpdlfdfUUeerlnhZrlnlbpnljXrnnjbnlhdbplljdljhfbnjhfbtlnjdljhfbrlnldljhf)bnjjfdtlpldldZdflhfdZnhfhbjfdfVnjjfbjfbZblhhfbjfdZZjfdZbnjjfbljfbZpjjhdjjfdbjhfd)bpjlhdfVTVZhXXdZhXXdZhVTXZldffbhXTXVjbbdbhZVXXhZVZXlfffbhhfZZnhjhdjhdbbjhfbbpjlh)ddfPRXdfZdbdfXbbdfTZZjfffbdfTVZffbdbdfVXXdfVXXhfffbhhdZZnhjfdjhdbZjfdbZnhjhdhpRJ)ThlXbZjnVdZhnTXXjhffbhnTTXjjbdbhlVXXhlVXZlhfdbjffZZnfjfdjfdbbjfdbbnfjfdhfbXXlffb)blfhfbjfdXZnfhfbhfdXblfhdbjfbZZjfdZbnfjfbjddbdnfjfdjffdbjffbbpflhdlflbXndnhdtdpl)dndlhbrdnjfjfhddpdlhdldhddndhfdpdlhdlfhfdrdnjdldhfbldhfbrdpldddbZTTWeeeeebZbZdbW)eeeeeebbZVHeeeeeeeZZZZbeeeeeeeebbZVVNeeeeeeZZZZZNeeeeeeefdbZXVDeeeeebbbZZZDeeeee)e`.split(`)`).join(``),`Vp%nb:5eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee.(#x1eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,e%vnbxLvdpTeeeeeeeeeeeeeeeeeeeeeeeeeeeeeen%#xDnDeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,e#.>:*(zxrrhhbXfPJeeeeeeeeeeeeeeeeeeeeeeehtvvrpljfZXdBeeeeeeeeeeeeeeeeeeeeeeeeee,el#zxxzxvpbhhdhb5eeeeeeeeeeeeeeeeeeeeeeeedfjhfhjjpnVfhJeeeeeeeeeeeeeeeeeeeeeeeee,eeeeeJRrbTJN9JFeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeXdXhZVdNXXddddZljpndZdTXXXdPVVZdXVXddfhdXdhjb,ZfZVXZddZZVdhhbdjTVVblNPRfhZXXlhllSdjVVXdlRRTdhZXXjdhfdhfddbdfZTXfddZZhhdfbhfXXZ,dhXXVhhdXZhdfjWfhZZZdhXRXhfbXZjfjfdhdfdbdhZXZhddZZldjfdhdfXdfdffZhZdhglZrjkhdddb,ffbbZjdhbbldjfbjdhhbffbZdjdhddndnjdeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeRjPbZdhhjblhjpdeeeee,PjRVXXhXZVXXffZeeeeeThXXZTfbZbPbdbbeeeeeZjRRVdhdZZekkWWeeeeeblTTXdhZXXjdffjeeeee,dfZVXffbZbdbddbeeeeedlXLVhddXZeeeeeeeeeedlXVZffdZbhZfZSeeeeedhZXZhhdZbjdfdbeeeee,ZdhjfVjdekZfrlWeeeeebjbdbfhfZfdflnZeeeeedjddbhhhfbjhlhfnhhdbjndZZllffjrffgWjjfdb,jlbXXljfbdpjjdZnjhfblldbZljfdbphljdhjZXZjlbVVjldXZakkWWjjbXXjlZVZjjdXZlhldZljfdb,jlZXXljfXZnhjfdhVPRXhTLVXhhbVZlfjfehdVVZhbTRVjjZXZnhjfbjfddbjlZTVjjdXZldffbdfTXV,dhPRTjhZVZtdjdZfjXVXdjTPTjjZVXpfhbZhhddZjlZTXlhdXZhfffblrXRPlzVFLllZVVlbjhZlpXTV,ltTNPlnZTVpdjfblhffbjjZVZlhdZZnffhbprdNLptbFLljdXZfeekennbTVlpbNTlldVXpfffdlhfdZ,jlbXVlhdZZnfjhdlffbXlhhZVldjZffUmeklhdbbjjdZZlfhbXndlffpfjfblhdZbnfhdbpdnjdeeeee,llfletjZmekWkkeeeeeehhbdblhfdTnfjfVeeeeejhbdZlfhdbrdjjbeeeeehhXTVhhZaerjjTTeeeee,hhXVXjfbXbhfpbdeeeeehhZZXlhdZbnhhfZeeeeeffVVXhfbZVkkWeeeeeeefhXVXhhbXZhhZameeeee,jjZVZjhdXXnjhbZeeeeehlTVPlfbZZvbhhaeeeeehlVTVjjZXXhdhdVeeeeejjZVZjjbXXljhdXeeeee,pxXFLjldVXpjfUUeeeeelrVPRlnbVTrjlZXeeeeellZVVlldXXnlhdVeeeeerzdDLlnfZZekWeeeeeee,nrbRTnndVXljfdReeeeelnbXXnldZZplddbeeeeexZfhantfXTkWWeeeeeeepjdbXphjdbxjhbleeeee,njhdbnjjdbrjlhbrjlddpnlbftfjdbnntjmpljbbnnjZbpljbdrhlhZpjlfdnnhbbpllddrjnjdnjfVZ,jndVZlnhXbljrZTllfXZllfTZnlhXbpllddnjjdbnjfXZnjhZbphlfdhRPTZhPNTXllfTZvlhdZjbXXZ,hXTRZllfVZpjlddlffdbllfXZnjhZbnfhfdbfTZXbhPPVlhhXZndpffdhZVZdhVPXljfVZpjjbfjffdb,ljdVXlhhZbhfhfbhvTRXjxRRXllfXXphpfdjnZVZjrVRXljfVZpflddlhfdblhdXZlhhZblfffdnjfZX,nnfTXljfZZpdnhfnjhXZllfTZnjhXbpblhfnfjfblffXZnhhZbpblhdnfhbdphjdfrhjddpfpjWphlbd,ljhbdphjbdpfnhfpflhdnhhbbphjddrdnjdeeeeeljjfVnpjjZpjjoeeeeeeljfZbnhhdbpfhfbeeeee,nhhbbphjddrfnhdeeeeejnbTVlhhXZkkWeeeeeeeljdVZljhZbxfxhbeeeeenjfVZnjhZbrhlddeeeee,jlbTVllhZZpfpfUeeeeejjdTXljhXZxfrfdeeeeeljhXZnjhZbpjndbeeeeejjbVZlfhZZxdpjdeeeee,jhbRXlhfVZ#ljZdeeeeelhfXZlhhXbrhjdbeeeeeljbVXnhhVZkkWeeeeeeejjdTXnhhVbnhlZbeeeee,lhfXZnhhZbpfjdfeeeeellhVVphfZfeeeeeeeeeenlfVXpjjXblhndXeeeeenhhXZpjjbbrhnfbeeeee,rdjhjplfZXlRrreeeeeerjlfbrjjdfxjpjbeeeeepjldbrjlfdthnjdtnpndxvrtZttpnftprnZrnpld,rrplftrrnftnrnfvnrnfnllhbtnplfvnrpdnhffdjdbdfrplhdplppenljfdllfddpnlfdrnplfpjljd,nljddpnlffrjnldfTRfbfTLbZnphhbtlpnbhZZddfVRbZljhddplnjfnhjhdljhbbnjjddnfjjddjVhd,bjNZVnhjfbpdllfdjZdbbjRZZlhhdbtjnjblfjhdlhhfdnhjfdjhjjdjvRbZlxNZXnhhddnfljZlnZbb,jrTZZnhhbdphnhdnfhhblhfdZnfjddnhjjdlfhbblfhZdnfjfdphllfnfjddlfhbbpfjddrhnjdpflhd,lfffdpdlddpfljdtbnldxZrnhtbpjftfnlftbpldrbnldtbpldtfpldtdpndnfhfdrdnjdtfrndeeeee,%tzxf*pvpZxlrnbeeeeetjpldvlrld#ntrfeeeeevhrldvjrnfzlvrfeeeeeplnhdtlnhdrrrreeeeee,nhjdbrlnffxntndeeeeephlhdrjnjfvjtnfeeeeeljjdbphndftntteeeeeelhhdbrllfdrnvlheeeee,pflhdphnhdvjtndeeeeetdnjbtdrjdzf#tfeeeeenfhddpjldbtltpbeeeeepflfdrhlhdvjrnfeeeee,lhhdbnjldfpjvpWeeeeenfhbbpfjddtnnjheeeeepfjhdpflhdvjrnfeeeeenfjfbnjnfdzttpeeeeee,pdjfdpflhdtlrpbeeeeepdlhdrfnjdtjrnfeeeee.P*%hzdvtd%jzvdeeeee#Tztfxdtpdzjxtdeeeee,xZtpfxdtpdzhvrfffdbZJSeeeeebbbbZXSeeeeeedbZVXLeeeeeebbZZVLeeeeeeebbZVVbPeeeeeZbZ,ZZpPeeeeeejffZZXVBeeeeddbfZXXReeeeeht%ebZeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,eeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeeee,eeeeeeeeeeeeeeeeeeeeeeeeeeZdPNTXdhlbTfVjZZfXdZldlldZdNNVZfXbZZdPVVZfRVXbdbdZZdTT,dVdbfbRdXXVbdZZbfdffbddLTTdjVbXfhPZVblTVVfhbbbdjPRVfjXZZdjRVXdlTTVfhbbZdfXTXffdd,bdfXZXffZXZhffdbhhVRXhhbdZhhZZXflXVRhhdZXfjVNThhbZZfjVVVfjXTXhhdbbfhVZTjffdbffZZ,XffZXZjfhdbdpZWWfjhbVnbljfflbdTjhfbZdhVRbjfddbhfZbXhhbZZldfdbhfZXVldjhdfdbdbhfdb,ZndljdZWWeehhfbXpjjhbphdbZljffZfhfTTjhhdbhhdVZhjdZbnhhdbjjdVXnhjhdjhdZZjjdbbphlh,bnfXUUjhbbZjhdZdhbbXXjfdddhlZJZjhbbZhhZVXhfZVXjhfbbllbXVlhfdbhjbXZjjbXblhhdbdVRP,XfZVdVfTPTThXRVXjfddbhZTHVhbXbZhZVTXhbVVXjfdbbhjZRRjjddbjjZZVjhZXZlhfdZdhTTTfhXb,XdjVZXdhTTVjhdfbdjVHTfhXZXdjVRVfhVTXjhbZZhjXTXjhdbZjhZVXhjbXXlhfdbpzbDFlpXXVnvbV,LltVRPljbbZltXHNjnZZVjrXNRjrVPTljbbXjpXNXljddZllZXVjjbZXlhffZt#hFFnpbVTtvhVPnpbP,TlldXZntdJPlndXXnrdPRnpbRVlldXXlpbLTlhfbbjldVVljbVVnhfdZkWWeehldZfllhbZnlfbZrflZ,VrnbNTlhhbbllfXXjjdZZnfhdZpldVVnfjhbljdbZlhfbZpflhbUeeeeljjbZnhjffnljdbthjhfnhfb,dpjjdbllhZbnjhZbpjjdbjnfRbrjlhdnjhbdnjhbbrjnhdhhXUUljhZbjjdZZjdZXZnhfdblhdXbnhfb,bjhdXZjhdVXnjhbbjlhRbnjjdblhfXbljfXZpjjdbhRPXbhXVZZhXNZRhVTXVnddbbhVTTXjbZZZhXTV,XhXVTZlfdbbllhXbnjhdbljfXbljfZXphjdbbhPPPdhXbZbhTXXdhVVXlhhfbbhTLXfhbZZdhVVZdhVV,XjhfbbjjdVdnhhdbjhfZZjjfZbphjddjxRRVjrVZZjtTXZhrTPXljfdZjtTNVjnZXZjrVRXjpXTXljfb,bjjfVXnhhdbljdXZljfXbphjdbppjbbljfZZnljfdnlfVbphjbZnnfTbnjhZblnfVZnlfTZphjbbljfX,bphjddljfXblhfZbphlfdpnhlknfhbbxjpjjnlfdZnflZfjjfTbphjddnjhbbnjjZbrhlfdljhXdrfnh,dnhhdbnhjbdrfnhdjjdSgnplldvltpbtlvrdvnppdhfbfXpjlldnljlbnljldtlplfjlfddvlrpdljhj,dljjjdxltpdfbTSajdbfdnhhbdhZZbXnhjjbhbXVVjffhbhdXbbhdZbZnhjjfhjbZZpjnldhjdfbjjdf,brjnldfVNXVfXVfXfVRdZfVPbXjddjbfXNRThZZhbfXRZXfXRZXjddhdhjZbZpjljdhhbdZjhdfbrjnl,dbhLPVfhblbbhRfbdhRbZjhjlddhPTVdhZhbdhRXXdhRZXhhdhdhjZZZphljdhhbdbjhddbrhnjdhtPX,LjpXdZjtTbZjrTZVljfhbhpTTVjlZfbhpTXVhpTXXljdhbfhbbZphljbjhdfbjhddbphnjdlpXPXnhfd,dlhhldjjdZZnhjhdjlbVXlhhfdjjbZZjjdbbpfjhdjjdbbphljdjhdfdjhfdbrhnjdllReenfljfxftr,drftndthrpbjjdbbrfnjdlhhjbnhjjbtfplfjjfbbvfrpdlhhhbnhjhbxftpdhhffbZTHeeeebbbbbZV,TeeeeedddbXRVWeeeebbbbbZVkeeeeedddbXTXpTeeebbbZZXbeTeeeejhfdZXTVHeeeddbbbZVNHeee,e`.split(`,`).join(``)],to=0;function no(e){return to+=e,to-e}var ro=no(1),io=no(40),ao=no(40),oo=no(40),so=no(40),co=no(120),lo=no(1),uo=no(1),fo=no(1),po=no(1),mo=no(40),ho=no(1),go=no(3),_o=no(6),vo=no(3360),yo=no(100),bo=no(4),xo=no(2),So=no(2100),Co=no(100),wo=to,To=`0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+,-./:;<=>`,Eo=[64,64,64,89,133,198,295,439,652,968,1434,2117,3108,4531,6537,9296,12964,17625,23222,29502],Do=8;function Oo(e){let t=new Uint16Array(wo),n=new Uint8Array(wo);for(let r=0;r<wo;r++){let i=To.indexOf(e[r]),a=i>>1;t[r]=a<20?Eo[a]:65536-Eo[39-a],n[r]=i%2==0?0:Do}return{one:t,updates:n}}var ko=eo.map(Oo),Ao={one:new Uint16Array(wo),updates:new Uint8Array(wo)};function jo(e){let{one:t,updates:n}=ko[+(e>2)];return Ao.one.set(t),Ao.updates.set(n),Ao}var Mo=4,No=2**24,Po=16,Fo=Uint16Array.from({length:101},(e,t)=>Math.floor(655360/(10*t+16))),Io=class{bytes;models;at=0;range=4294967295;code=0;constructor(e,t){this.bytes=e,this.models=t;for(let e=0;e<4;e++)this.code=(this.code<<8|this.next())>>>0}next(){let e=this.at++;return e<this.bytes.length?this.bytes[e]:0}shift(){this.range=this.range<<8>>>0,this.code=(this.code<<8|this.next())>>>0}bit(e){let{one:t,updates:n}=this.models,r=t[e],i=n[e],a=Fo[i];i<100&&(n[e]=i+1);let o=Math.imul(this.range>>>16,r)>>>0,s=this.code<o,c;for(s?(this.range=o,c=r+(Math.imul(65535-r,a)>>>16)):(this.code=this.code-o>>>0,this.range=this.range-o>>>0,c=r-(Math.imul(r,a)>>>16)),t[e]=c<64?64:c>65472?65472:c;this.range<No;)this.shift();return s}raw(e){let t=0;for(let n=e;n>0;){let e=Math.min(n,Po);n-=e,this.range>>>=e;let r=Math.min(Math.floor(this.code/this.range),2**e-1);for(this.code=this.code-r*this.range>>>0,t=t*2**e+r;this.range<No;)this.shift()}return t}get pastEnd(){return this.at>this.bytes.length+Mo}get atCleanEnd(){return!this.pastEnd&&this.at>=this.bytes.length}get position(){return Math.min(this.at,this.bytes.length)}},Lo=0,Ro=1,zo=2;function Bo(e){return!e.b2||e.b2.atRest||!Ea(e.b1,e.b2)?Ro:e.b3&&Ea(e.b1,e.b3)?Lo:zo}var Vo=(e,t)=>Math.min(za(Math.abs(e)),t);function Ho(e){return e<0?e<=-4?0:e<=-2?1:2:e>=4?6:e>=2?5:e===1?4:3}function Uo(e){return e===0?0:e<=3?1:2}var Wo=[0,0,0],Go=[0,0,0],Ko=[0,0,0],qo={id:0,position:[0,0,0],largest:3,rotation:[0,0,0],atRest:!1},Jo=class{packed;spec;in;constructor(e,t){this.packed=e,this.spec=t}decode(e,t,n){this.in=new Io(this.packed,jo(t.dt1));let r=e.baseline?.entities.length??0,i=this.in.bit(ro),a=i?this.readRemoved(r):new Set,o=n-(r-a.size);o<0&&this.fail(`more entities than the limit`);let s=i?this.readSpawned(e,o):[],c=this.readSurvivors(Oa(e,a),t);return this.checkEnd(),this.in.atCleanEnd||this.fail(`unexpected bytes at the end`),Aa(c,s)}fail(e){throw new xa(`${e} (at byte ${this.in.position})`)}checkEnd(){this.in.pastEnd&&this.fail(`truncated data`)}count(e){let t=0;for(;t<40&&this.in.bit(e+t);)t++;return 2**t+this.in.raw(t)-1}number(e,t){if(!this.in.bit(e))return 0;let n=this.in.bit(e+1),r=1;return this.in.bit(e+2)&&(r=this.in.bit(e+3)?this.large(t):this.in.bit(e+4)?3:2),n?-r:r}large(e){let t=0;for(;t<12&&this.in.bit(e+t);)t++;let n=2+t;return t===12&&(n+=this.in.raw(5)),(this.in.bit(e+12+t)?3:2)*2**(n-1)+this.in.raw(n-1)}readRemoved(e){let t=this.count(io);t>e&&this.fail(`removed: count ${t} exceeds ${e}`);let n=new Set,r=0;for(let i=0;i<t;i++){let t=r+this.count(ao);t>=e&&this.fail(`removed: index out of range`),n.add(t),r=t+1}return this.checkEnd(),n}readSpawned(e,t){let n=this.count(oo);n>t&&this.fail(`spawned: more entities than the limit`);let r=new Da(e.baseline),i=[],a=qo;for(let e=0;e<n;e++)a=this.readSpawnedEntity(a),this.checkEnd(),r.find(a.id)&&this.fail(`spawned: id is already in the baseline`),i.push(a);return i}readSpawnedEntity(e){let t=e.id+1+this.count(so);t>4294967295&&this.fail(`spawned: id exceeds 32 bits`);let n=[0,0,0];for(let t=0;t<3;t++){let r=this.count(co+t*40),i=r!==0&&this.in.bit(lo);n[t]=this.int32(e.position[t]+(i?-r:r),`spawned: position`)}let{largest:r,rotation:i}=e;return this.in.bit(uo)&&({largest:r,rotation:i}=this.readComponents()),{id:t,position:n,largest:r,rotation:i,atRest:this.in.bit(fo)}}readComponents(){let e=this.in.raw(2),t=za(this.spec.rotationComponent)+1,n=[0,0,0];for(let e=0;e<3;e++)n[e]=this.in.raw(t)-2**(t-1);return this.checkRotation(n),{largest:e,rotation:n}}checkRotation(e){ka(e,this.spec.rotationComponent)||this.fail(`invalid rotation`)}int32(e,t){return(e<-2147483648||e>2147483647)&&this.fail(`${t} out of range`),e}readSurvivors(e,t){let n=[],r=0;for(let t of e)t.b1.atRest&&r++;let i=this.restingRun(r);for(let a of e){if(!a.b1.atRest){n.push(this.readAwake(a,t));continue}if(r--,i>0){i--,n.push(a.b1);continue}let e=this.in.bit(ho);n.push(this.readPose(a,t,e)),i=this.restingRun(r)}return n}restingRun(e){if(e===0)return 0;if(this.in.bit(po))return e;let t=this.count(mo);return t>=e&&this.fail(`run of resting entities exceeds the frame`),this.checkEnd(),t}readAwake(e,t){let n=Bo(e),r=this.in.bit(go+n),i=this.in.bit(_o+2*n+ +!!r);return r?this.readPose(e,t,i):i?{...e.b1,atRest:i}:e.b1}readPose(e,t,n){let r=$a(e,t,this.spec.rotationComponent),i=[0,0,0],a=0;for(let e=0;e<3;e++){let t=r.positionStep[e],n=r.positionAcceleration[e],o=(t===0?n:t)<0,s=Vo(t,3),c=Uo(r.positionChange-Math.abs(n)),l=e===0?0:1+(Vo(a,4)>>1),u=(((s*2+ +(e===1))*7+Ho(o?-n:n))*3+c)*4+l,d=this.number(vo+u*5,yo+s*25);i[e]=this.int32(r.position[e]+(o?-d:d),`position`),a+=Math.abs(d)}let o=this.readLargest(r),s=this.readRotation(r,o,a!==0);return this.checkEnd(),{id:e.b1.id,position:i,largest:o,rotation:s,atRest:n}}readLargest(e){let t=0;for(let n=0;n<4;n++)n!==e.largest&&(t=Math.max(t,Math.abs(e.rotation[n])));let n=Vo(Math.abs(e.rotation[e.largest])-t,15)>>2;if(this.in.bit(bo+n))return e.largest;let r=2;return this.in.bit(xo)||(r=+!!this.in.bit(xo+1)),e.largest+1+r&3}readRotation(e,t,n){let r=e.rotation[t]<0?-1:1,i=0,a=0;for(let n=0;n<4;n++)n!==t&&(Wo[i]=r*e.rotation[n],Go[i]=r*e.rotationStep[n],Ko[i]=r*e.rotationAcceleration[n],a+=Math.abs(Ko[i++]));let o=[0,0,0],s=0;for(let e=0;e<3;e++){let t=Go[e],r=Ko[e],i=(t===0?r:t)<0,c=Vo(t,3),l=e===0?+!!n:2+Vo(s,2),u=((c*7+Ho(i?-r:r))*3+Uo(a-Math.abs(r)))*5+l,d=this.number(So+u*5,Co+c*25);o[e]=Wo[e]+(i?-d:d)+0,s+=Math.abs(d)}return this.checkRotation(o),o}},Yo=4,Xo=5,Zo=12,Qo=255,$o=[0,0,0,1,2,2,3,3,4,5,6,7],es=[0,0,0,1,2,3,4,4,5,6,7,8];function ts(e){return e.b1.atRest||!e.b2?!0:Ea(e.b1,e.b2)&&(!e.b3||Ea(e.b1,e.b3))}var ns=class{spec;in;constructor(e,t){this.spec=t,this.in=new La(e)}decode(e,t,n){let r=Oa(e,new Set(this.readPositions(e.baseline?.entities.length??0,`removed`))),i=this.readSpawned(e,n-r.length),a=this.readSurvivors(r,t);return this.in.atCleanEnd()||this.fail(`unexpected or missing bits at the end`),Aa(a,i)}fail(e){throw new xa(`${e} (at bit ${this.in.position})`)}checkEnd(){this.in.pastEnd&&this.fail(`truncated data`)}readPositions(e,t){let n=this.in.expGolomb(0);this.checkEnd(),n>e&&this.fail(`${t}: count ${n} exceeds ${e}`);let r=[],i=0;for(let a=0;a<n;a++){let n=i+this.in.expGolomb(Yo);this.checkEnd(),n>=e&&this.fail(`${t}: index out of range`),r.push(n),i=n+1}return r}checkRotation(e){ka(e,this.spec.rotationComponent)||this.fail(`invalid rotation`)}readComponents(){let e=za(this.spec.rotationComponent)+1,t=this.in.bits(2),n=[0,0,0];for(let t=0;t<3;t++){let r=this.in.bits(e);n[t]=r>=2**(e-1)?r-2**e:r}return this.checkRotation(n),{largest:t,rotation:n}}int32(e,t){return(e<-2147483648||e>2147483647)&&this.fail(`${t} out of range`),e}readSpawned(e,t){let n=this.in.expGolomb(0);this.checkEnd(),n>t&&this.fail(`spawned: more entities than the limit`);let r=new Da(e.baseline),i=[],a=1;for(let e=0;e<n;e++){let e=a+this.in.expGolomb(Yo);e>4294967295&&this.fail(`spawned: id exceeds 32 bits`);let t=[0,0,0];for(let e=0;e<3;e++)t[e]=this.int32(Ra(this.in.expGolomb(Zo)),`spawned: position`);let{largest:n,rotation:o}=this.readComponents(),s=this.in.bits(1)===1;this.checkEnd(),r.find(e)&&this.fail(`spawned: id is already in the baseline`),i.push({id:e,position:t,largest:n,rotation:o,atRest:s}),a=e+1}return i}readMoved(e,t){let n=$a(e,t,this.spec.rotationComponent),{positionChange:r,rotationChange:i}=n;(ts(e)||!e.b3||Ea(e.b1,e.b2))&&(r=Math.max(r,4*t.dt1),i=Math.max(i,4*t.dt1));let a=$o[Math.min(za(r),11)],o=es[Math.min(za(i),11)],s=[0,0,0];for(let e=0;e<3;e++)s[e]=this.int32(n.position[e]+Ra(this.in.rice(a)),`position`);if(i!==0||this.in.bits(1)!==1){if(this.in.takeEscape()){let{largest:t,rotation:n}=this.readComponents();return{id:e.b1.id,position:s,largest:t,rotation:n,atRest:!1}}for(let e=0;e<3;e++)n.components[e]+=Ra(this.in.rice(o))}this.checkEnd(),this.checkRotation(n.components);let c=[n.components[0],n.components[1],n.components[2]];return{id:e.b1.id,position:s,largest:n.largest,rotation:c,atRest:!1}}readSurvivors(e,t){let n=[],r=this.in.expGolomb(Xo);for(let i of e){let e=ts(i),a;e?(a=r===0,a||r--):a=this.in.bits(1)===1,a?(n.push(this.readMoved(i,t)),e&&(r=this.in.expGolomb(Xo))):n.push(i.b1),this.checkEnd()}r!==0&&this.fail(`run of unchanged entities exceeds the frame`);for(let e of this.readPositions(n.length,`rest toggles`))n[e]={...n[e],atRest:!n[e].atRest};return n}};function rs(e,t,n,r,i=1<<20,a=1){if(!Sa(r))throw new xa(`quantization out of range`);if(a<1||a>2)throw new xa(`unknown codec ${a}; supported: 1 and 2`);let o=n.baseline?n.baseline2:void 0,s=o?n.baseline3:void 0,c={dt1:n.baseline?e-n.baseline.frame:1,dt2:n.baseline&&o?n.baseline.frame-o.frame:1,dt3:o&&s?o.frame-s.frame:1};for(let t of[c.dt1,c.dt2,c.dt3])if(t<1||t>Qo)throw new xa(`frame ${e}: baseline distances must be 1 to 255 ticks`);return{frame:e,entities:(a===2?new Jo(t,r):new ns(t,r)).decode({baseline:n.baseline,baseline2:o,baseline3:s},c,i)}}function is(e){let t=new Uint8Array(24*e.entities.length),n=new DataView(t.buffer),r=0;for(let t of e.entities){n.setUint32(r,t.id,!0);for(let e=0;e<3;e++)n.setInt32(r+4+4*e,t.position[e],!0);n.setUint8(r+16,t.largest);for(let e=0;e<3;e++)n.setInt16(r+17+2*e,t.rotation[e],!0);n.setUint8(r+23,+!!t.atRest),r+=24}return Va(t)}function as(e,t){let n=1/(t.rotationComponent*Math.SQRT2),r=[0,0,0,0],i=1,a=0;for(let t=0;t<4;t++)t!==e.largest&&(r[t]=e.rotation[a++]*n,i-=r[t]*r[t]);return r[e.largest]=Math.sqrt(Math.max(0,i)),{position:[e.position[0]/t.unitsPerMeter,e.position[1]/t.unitsPerMeter,e.position[2]/t.unitsPerMeter],rotation:r}}var os=32,ss=3,cs=12,ls=class{cells=new Map;newest=0;step=1;apply(e,t,n,r,i=0){let a=e.map(e=>({cell:e.cell,state:this.decode(e,n,r)}));this.newest!==0&&i>this.newest&&(this.step=i-this.newest),this.newest=i;for(let e of t)this.cells.delete(e);for(let{cell:e,state:t}of a){let n=this.cells.get(e)??[];n.length>0&&t.frame<=n[n.length-1].frame&&(n=[]),n.push(t),n.length>os&&n.shift(),this.cells.set(e,n)}}frame(e){let t=new Map;for(let e of this.cells.values()){let n=e[e.length-1];for(let e of n.entities){let r=t.get(e.id);(!r||r.number<n.frame)&&t.set(e.id,{entity:e,number:n.frame})}}return{frame:e,entities:[...t.values()].map(e=>e.entity).sort((e,t)=>e.id-t.id)}}blends(e){let t=new Map;for(let n of this.cells.values()){let r=this.progress(n,e);if(r===1)continue;let[i,a]=n.slice(-2),o=0;for(let{id:e}of a.entities){for(;o<i.entities.length&&i.entities[o].id<e;)o++;let n=i.entities[o];n?.id===e&&t.set(e,{from:n,t:r,ticks:a.frame-i.frame})}}return t}progress(e,t){let n=e.length-1;if(n<1)return 1;let r=cs;for(let t=n;t>0&&t+ss>n;t--)r=Math.min(r,e[t].frame-e[t-1].frame);let i=Math.max(0,t-e[n].frame);return r<=this.step?1:Math.min(1,(i+this.step)/r)}clear(){this.cells.clear(),this.newest=0,this.step=1}decode(e,t,n){let r=this.cells.get(e.cell)??[],i=`cell ${e.cell} of tick ${e.number}`;if(e.baselines!==0&&r.length>0&&e.number<=r[r.length-1].frame)throw new xa(`${i} is not newer than its last state`);let[a,o,s]=Ma(e.number,e.baselines).map(e=>{let t=r.find(t=>t.frame===e);if(e!==0&&!t)throw new xa(`${i}: its state ${e} is unknown`);return t}),c=rs(e.number,e.packed,{baseline:a,baseline2:o,baseline3:s},t,void 0,n);if(is(c)!==e.crc)throw new xa(`${i}: CRC mismatch`);return c}},us=[],ds=`jostle.motion`,fs=64,ps=4096,ms=16384,hs=262144,gs=4294967295,_s=(e,t)=>e.kind<t.kind||e.kind===t.kind&&e.entity<t.entity,vs=class{numbers=[];add(e,t,n){if(this.numbers.push(e,t,n?n.length:gs),n)for(let e of n)this.numbers.push(e)}crc(){let e=new DataView(new ArrayBuffer(this.numbers.length*4));return this.numbers.forEach((t,n)=>e.setUint32(4*n,t>>>0,!0)),Va(new Uint8Array(e.buffer))}};function ys(e,t,n){let r=new Int32Array(t);n&&r.set(n.subarray(0,t));let i=16;for(let n=0;n<t;){if(n+=e.expGolomb(0),n>t)throw new xa(`channels: run of equal values exceeds the channel`);if(n===t)break;let a=e.expGolomb(i<8?0:(i>>2)-2);if(a>=4294967295)throw new xa(`channels: difference exceeds 32 bits`);if(i+=za(a)-(i>>2),r[n]=r[n]+Ra(a+1),n++,e.pastEnd)throw new xa(`channels: truncated data`)}return r}function bs(e,t,n){let r=e.bits(2);if(r>2)throw new xa(`channels: ${t}: unknown change ${r}`);if(r!==1&&!n)throw new xa(`channels: ${t} changed but is not in the baseline`);if(r===2)return;let i=r===1?e.expGolomb(3):n.values.length;if(i>ms)throw new xa(`channels: ${t} has more than ${ms} values`);return ys(e,i,n?.values)}function xs(e){let t=e.reduce((e,t)=>e+t.values.length,0);if(e.length>ps)throw new xa(`channels: more than ${ps} channels`);if(t>hs)throw new xa(`channels: more than ${hs} values`)}function Ss(e,t,n){if(e.length===0)return n;let r=new La(e),i=r.expGolomb(1)+1,a=[],o=new vs,[s,c,l]=[0,0,0];for(let e=0;e<i;e++){let t=r.expGolomb(0),i=r.expGolomb(2)+(t===0?c:0);if(s+=t,s>=fs||i>4294967295)throw new xa(`channels: kind or entity out of range`);for(c=i+1;l<n.length&&_s(n[l],{kind:s,entity:i});)a.push(n[l++]);let u=l<n.length&&n[l].kind===s&&n[l].entity===i?n[l++]:void 0,d=bs(r,`kind ${s} of entity ${i}`,u);if(o.add(s,i,d),d&&a.push({kind:s,entity:i,values:d}),r.pastEnd)throw new xa(`channels: truncated data`);e%256==255&&xs(a)}for(;l<n.length;)a.push(n[l++]);if(!r.atCleanEnd())throw new xa(`channels: unexpected bytes after the end`);if(xs(a),o.crc()!==t)throw new xa(`channels: CRC mismatch`);return a}var Cs=32,ws=100;function Ts(e,t,n,r){let[i,a,o,s]=[e.position,t.position,e.rotation,t.rotation];if(Math.hypot(a[0]-i[0],a[1]-i[1],a[2]-i[2])*1e6>ws*r)return[...Array.from(i),...Array.from(o)];let c=[0,1,2,3],l=c.reduce((e,t)=>e+o[t]*s[t],0)<0?-1:1,u=c.map(e=>o[e]+n*(l*s[e]-o[e])),d=Math.hypot(...u);return[...[0,1,2].map(e=>i[e]+n*(a[e]-i[e])),...u.map(e=>e/d)]}var Es=class{blendsOfNewest;frames=[];find(e){return e===0?void 0:this.frames.find(t=>t.quantized.frame===e)?.quantized}channelsOf(e){return this.frames.find(t=>t.quantized.frame===e)?.poseFrame.channels??us}add(e,t,n,r=us,i,a=0){let o=this.blendsOfNewest;this.blendsOfNewest=i;let s=this.newest,c=new Float64Array(e.entities.length*7),l=0;e.entities.forEach((e,t)=>{for(;s&&l<s.entities.length&&s.entities[l].id<e.id;)l++;let r=i?.get(e.id);if(r)return c.set(Ts(as(r.from,n),as(e,n),r.t,r.ticks*a),t*7);if(s?.entities[l]===e&&!o?.has(e.id)){let e=l*7;c.set(s.poses.subarray(e,e+7),t*7);return}let u=as(e,n);c.set(u.position,t*7),c.set(u.rotation,t*7+3)});let u={frame:e.frame,serverUs:t,entities:e.entities,poses:c,channels:r};return this.frames.push({quantized:e,poseFrame:u}),this.frames.length>Cs&&this.frames.shift(),u}hold(e){let t=this.frames[this.frames.length-1];t&&t.poseFrame.serverUs<e&&(t.poseFrame={...t.poseFrame,heldUntilUs:e})}get newest(){return this.frames[this.frames.length-1]?.poseFrame}get newestTwo(){return this.frames.slice(-2).map(e=>e.poseFrame)}around(e){let t=this.frames.length;if(t===0)return;let n=t-1;for(;n>0&&this.frames[n-1].poseFrame.serverUs>=e;)n--;return{a:this.frames[Math.max(0,n-1)].poseFrame,b:this.frames[n].poseFrame}}since(e){let t=this.frames.findIndex(t=>t.poseFrame.serverUs>e);return t<0?[]:this.frames.slice(Math.max(0,t-1)).map(e=>e.poseFrame)}clear(){this.frames=[]}},Ds=1/8,Os=1/16,ks=4,As=4e3,js=10,Ms=3,Ns=120,Ps=class e{ready=!1;speed=1;jumps=0;tickUs=1e6/60;positionTicks=0;updatedUs=0;correctionUs=0;hasMargin=!1;meanMarginUs=0;lastMarginUs=0;jitterUs=As;framesSinceMargin=0;consecutiveOutOfRange=0;sentSequence=0;lastMarginSequence=0;begin(t){Object.assign(this,new e),t>0&&Number.isFinite(t)&&(this.tickUs=1e6/t)}get targetUs(){return this.tickUs+ks*this.jitterUs}get marginUs(){return this.meanMarginUs}onFrame(e,t,n,r){let i=e+(t+n+this.targetUs)/this.tickUs;if(!this.ready){this.ready=!0,this.positionTicks=i,this.updatedUs=r;return}let a=i-this.position(r);++this.framesSinceMargin>Ns&&Math.abs(a)>js&&this.jump(a)}sent(e){this.sentSequence=e}onMargin(e,t){if(e<=this.lastMarginSequence||t===0)return;this.lastMarginSequence=e,this.framesSinceMargin=0,this.hasMargin||(this.meanMarginUs=this.lastMarginUs=t),this.hasMargin=!0;let n=Math.min(Math.abs(t-this.lastMarginUs),2*this.tickUs);this.jitterUs+=Os*(n-this.jitterUs),this.lastMarginUs=t,this.meanMarginUs+=Ds*(t-this.meanMarginUs),this.adjust(t-this.targetUs)}adjust(e){if(Math.abs(e)>js*this.tickUs)return this.jump(-e/this.tickUs);Math.abs(e)<this.tickUs?(this.consecutiveOutOfRange=0,this.speed=1):(this.correctionUs=Math.abs(e),this.consecutiveOutOfRange=e>0?Math.max(0,this.consecutiveOutOfRange)+1:Math.min(0,this.consecutiveOutOfRange)-1,this.consecutiveOutOfRange>=Ms&&(this.speed=.95),this.consecutiveOutOfRange<=-3&&(this.speed=1.05))}jump(e){this.positionTicks+=e,this.jumps++,this.speed=1,this.consecutiveOutOfRange=0,this.hasMargin=!1,this.lastMarginSequence=Math.max(this.lastMarginSequence,this.sentSequence)}position(e){if(this.ready&&e>this.updatedUs){let t=e-this.updatedUs;this.positionTicks+=t*this.speed/this.tickUs,this.updatedUs=e,this.correctionUs-=Math.abs(this.speed-1)*t,this.correctionUs<=0&&(this.speed=1)}return this.positionTicks}tick(e){return Math.ceil(Math.min(2**32-1,Math.max(0,this.position(e))))}},Fs=8192,Is=class{waiting=[];awaitingResult=[];nextUnsent=1;resumed=!1;get last(){return this.waiting[this.waiting.length-1]}get length(){return this.waiting.length}get lastSent(){return this.nextUnsent-1}get newest(){return this.lastSent+this.waiting.length}push(e){this.waiting.push(e)}replaceLast(e){this.waiting[this.waiting.length-1]=e}take(e){let t=this.nextUnsent,n=this.waiting.splice(0,e);for(let e of n)this.awaitingResult.push({sequence:this.nextUnsent++,input:e});return this.awaitingResult.length>Fs&&this.awaitingResult.splice(0,this.awaitingResult.length-Fs),{firstSequence:t,inputs:n}}onResult(e){let t=this.awaitingResult.findIndex(t=>t.sequence>=e);return t<0||this.awaitingResult[t].sequence!==e?!this.resumed:(this.awaitingResult.splice(t,1),!0)}startNewSession(){this.waiting=[],this.awaitingResult=[],this.nextUnsent=1,this.resumed=!1}resumeAfter(e){let t=Math.min(e,this.lastSent),n=this.awaitingResult.filter(e=>e.sequence>t).map(e=>e.input);this.awaitingResult=this.awaitingResult.filter(e=>e.sequence<=t),this.waiting=[...n,...this.waiting],this.nextUnsent=t+1,this.resumed=!0}},Ls=wr(`ChZqb3N0bGUvdjEvY29tbW9uLnByb3RvEglqb3N0bGUudjEiJwoEVmVjMxIJCgF4GAEgASgBEgkKAXkYAiABKAESCQoBehgDIAEoASIyCgRRdWF0EgkKAXgYASABKAESCQoBeRgCIAEoARIJCgF6GAMgASgBEgkKAXcYBCABKAEiKgoIVmlld1RpbWUSDAoEdGljaxgBIAEoDRIQCghmcmFjdGlvbhgCIAEoAmIGcHJvdG8z`),Rs=wr(`ChVqb3N0bGUvdjEvc2NlbmUucHJvdG8SCWpvc3RsZS52MSK6AQoFU2NlbmUSDAoEbmFtZRgBIAEoCRITCgtkZXNjcmlwdGlvbhgCIAEoCRInCgV3b3JsZBgDIAEoCzIYLmpvc3RsZS52MS5Xb3JsZFNldHRpbmdzEh8KBmJvZGllcxgEIAMoCzIPLmpvc3RsZS52MS5Cb2R5EiAKBmpvaW50cxgFIAMoCzIQLmpvc3RsZS52MS5Kb2ludBIiCgdtb2R1bGVzGAYgAygLMhEuam9zdGxlLnYxLk1vZHVsZSKJAwoNV29ybGRTZXR0aW5ncxIgCgdncmF2aXR5GAEgASgLMg8uam9zdGxlLnYxLlZlYzMSFQoIc3Vic3RlcHMYAiABKA1IAIgBARIPCgJoehgDIAEoAUgBiAEBEhUKCHNsZWVwaW5nGAQgASgISAKIAQESDgoGcGxhbmFyGAUgASgIEhcKCmNvbnRpbnVvdXMYBiABKAhIA4gBARIqCgticm9hZF9waGFzZRgHIAEoDjIVLmpvc3RsZS52MS5Ccm9hZFBoYXNlEhYKCWhpdF9zcGVlZBgIIAEoAUgEiAEBEiwKDGpvaW50X3NvbHZlchgJIAEoDjIWLmpvc3RsZS52MS5Kb2ludFNvbHZlchIRCgl0b2xlcmFuY2UYCiABKAESFgoOc3Vic3RlcF9idWRnZXQYCyABKA0SEwoLc3RlcF9idWRnZXQYDCABKA1CCwoJX3N1YnN0ZXBzQgUKA19oekILCglfc2xlZXBpbmdCDQoLX2NvbnRpbnVvdXNCDAoKX2hpdF9zcGVlZCLQBAoEQm9keRIMCgRuYW1lGAEgASgJEiEKBHR5cGUYAiABKA4yEy5qb3N0bGUudjEuQm9keVR5cGUSIQoIcG9zaXRpb24YAyABKAsyDy5qb3N0bGUudjEuVmVjMxIhCghyb3RhdGlvbhgEIAEoCzIPLmpvc3RsZS52MS5RdWF0EigKD2xpbmVhcl92ZWxvY2l0eRgFIAEoCzIPLmpvc3RsZS52MS5WZWMzEikKEGFuZ3VsYXJfdmVsb2NpdHkYBiABKAsyDy5qb3N0bGUudjEuVmVjMxIbCg5saW5lYXJfZGFtcGluZxgHIAEoAUgAiAEBEhwKD2FuZ3VsYXJfZGFtcGluZxgIIAEoAUgBiAEBEhoKDWdyYXZpdHlfc2NhbGUYCSABKAFIAogBARIWCgltYXlfc2xlZXAYCiABKAhIA4gBARIgCgZzaGFwZXMYCyADKAsyEC5qb3N0bGUudjEuU2hhcGUSEgoFY29sb3IYDCABKAdIBIgBARIhCgZyZXBlYXQYDSADKAsyES5qb3N0bGUudjEuUmVwZWF0Eh8KBWxvY2tzGA4gASgLMhAuam9zdGxlLnYxLkxvY2tzEhcKCmNvbnRpbnVvdXMYDyABKAhIBYgBARIRCgRtYXNzGBAgASgBSAaIAQFCEQoPX2xpbmVhcl9kYW1waW5nQhIKEF9hbmd1bGFyX2RhbXBpbmdCEAoOX2dyYXZpdHlfc2NhbGVCDAoKX21heV9zbGVlcEIICgZfY29sb3JCDQoLX2NvbnRpbnVvdXNCBwoFX21hc3MiWAoFTG9ja3MSCQoBeBgBIAEoCBIJCgF5GAIgASgIEgkKAXoYAyABKAgSDgoGdHVybl94GAQgASgIEg4KBnR1cm5feRgFIAEoCBIOCgZ0dXJuX3oYBiABKAgiOAoGUmVwZWF0Eg0KBWNvdW50GAEgASgNEh8KBm9mZnNldBgCIAEoCzIPLmpvc3RsZS52MS5WZWMzIsUHCgVTaGFwZRIjCgZzcGhlcmUYASABKAsyES5qb3N0bGUudjEuU3BoZXJlSAASJQoHY2Fwc3VsZRgCIAEoCzISLmpvc3RsZS52MS5DYXBzdWxlSAASHQoDYm94GAMgASgLMg4uam9zdGxlLnYxLkJveEgAEiEKBXBsYW5lGAQgASgLMhAuam9zdGxlLnYxLlBsYW5lSAASJwoIY3lsaW5kZXIYCiABKAsyEy5qb3N0bGUudjEuQ3lsaW5kZXJIABIfCgRjb25lGAsgASgLMg8uam9zdGxlLnYxLkNvbmVIABIfCgRodWxsGAwgASgLMg8uam9zdGxlLnYxLkh1bGxIABIfCgRtZXNoGA0gASgLMg8uam9zdGxlLnYxLk1lc2hIABIuCgxoZWlnaHRfZmllbGQYDiABKAsyFi5qb3N0bGUudjEuSGVpZ2h0RmllbGRIABInCghjb21wb3VuZBgPIAEoCzITLmpvc3RsZS52MS5Db21wb3VuZEgAEiEKBXNvbGlkGBsgASgLMhAuam9zdGxlLnYxLlNvbGlkSAASEgoIZ2VvbWV0cnkYGSABKAZIABIhCghwb3NpdGlvbhgFIAEoCzIPLmpvc3RsZS52MS5WZWMzEiEKCHJvdGF0aW9uGAYgASgLMg8uam9zdGxlLnYxLlF1YXQSFAoHZGVuc2l0eRgHIAEoAUgBiAEBEhUKCGZyaWN0aW9uGAggASgBSAKIAQESGAoLcmVzdGl0dXRpb24YCSABKAFIA4gBARIRCgRtYXNzGBAgASgBSASIAQESHQoQcm9sbGluZ19mcmljdGlvbhgRIAEoAUgFiAEBEh8KEnRvcnNpb25hbF9mcmljdGlvbhgSIAEoAUgGiAEBEikKEHN1cmZhY2VfdmVsb2NpdHkYEyABKAsyDy5qb3N0bGUudjEuVmVjMxIpCg1mcmljdGlvbl9ydWxlGBQgASgOMhIuam9zdGxlLnYxLkNvbWJpbmUSLAoQcmVzdGl0dXRpb25fcnVsZRgVIAEoDjISLmpvc3RsZS52MS5Db21iaW5lEiEKBmZpbHRlchgWIAEoCzIRLmpvc3RsZS52MS5GaWx0ZXISDwoHdHJpZ2dlchgXIAEoCBIUCgxyZXBvcnRfc3RheXMYGCABKAhCBgoEa2luZEIKCghfZGVuc2l0eUILCglfZnJpY3Rpb25CDgoMX3Jlc3RpdHV0aW9uQgcKBV9tYXNzQhMKEV9yb2xsaW5nX2ZyaWN0aW9uQhUKE190b3JzaW9uYWxfZnJpY3Rpb24iVwoGRmlsdGVyEhUKCGNhdGVnb3J5GAEgASgNSACIAQESEQoEbWFzaxgCIAEoDUgBiAEBEg0KBWdyb3VwGAMgASgRQgsKCV9jYXRlZ29yeUIHCgVfbWFzayIYCgZTcGhlcmUSDgoGcmFkaXVzGAEgASgBIi4KB0NhcHN1bGUSDgoGcmFkaXVzGAEgASgBEhMKC2hhbGZfbGVuZ3RoGAIgASgBIiwKA0JveBIlCgxoYWxmX2V4dGVudHMYASABKAsyDy5qb3N0bGUudjEuVmVjMyIoCgVQbGFuZRIfCgZub3JtYWwYASABKAsyDy5qb3N0bGUudjEuVmVjMyIvCghDeWxpbmRlchIOCgZyYWRpdXMYASABKAESEwoLaGFsZl9sZW5ndGgYAiABKAEiKwoEQ29uZRIOCgZyYWRpdXMYASABKAESEwoLaGFsZl9sZW5ndGgYAiABKAEiJwoESHVsbBIfCgZwb2ludHMYASADKAsyDy5qb3N0bGUudjEuVmVjMyI6CgRNZXNoEiEKCHZlcnRpY2VzGAEgAygLMg8uam9zdGxlLnYxLlZlYzMSDwoHaW5kaWNlcxgCIAMoDSJZCgVTb2xpZBIdCgRtZXNoGAEgASgLMg8uam9zdGxlLnYxLk1lc2gSEQoJcGFydHNfbWF4GAIgASgNEhMKBmV4Y2VzcxgDIAEoAUgAiAEBQgkKB19leGNlc3MicgoLSGVpZ2h0RmllbGQSDwoHY29sdW1ucxgBIAEoDRIMCgRyb3dzGAIgASgNEhEKCXNwYWNpbmdfeBgDIAEoARIRCglzcGFjaW5nX3oYBCABKAESDwoHaGVpZ2h0cxgFIAMoARINCgVob2xlcxgGIAMoDSIuCghDb21wb3VuZBIiCghjaGlsZHJlbhgBIAMoCzIQLmpvc3RsZS52MS5TaGFwZSKNBwoFSm9pbnQSDAoEbmFtZRgBIAEoCRIOCgZib2R5X2EYAiABKAkSDgoGYm9keV9iGAMgASgJEiQKBWZyYW1lGAQgASgLMhUuam9zdGxlLnYxLkpvaW50RnJhbWUSJgoHZnJhbWVfYRgFIAEoCzIVLmpvc3RsZS52MS5Kb2ludEZyYW1lEiYKB2ZyYW1lX2IYBiABKAsyFS5qb3N0bGUudjEuSm9pbnRGcmFtZRIkCgRiYWxsGAcgASgLMhQuam9zdGxlLnYxLkJhbGxKb2ludEgAEiYKBWhpbmdlGAggASgLMhUuam9zdGxlLnYxLkhpbmdlSm9pbnRIABIvCgpjb25lX3R3aXN0GAkgASgLMhkuam9zdGxlLnYxLkNvbmVUd2lzdEpvaW50SAASJgoFZml4ZWQYCiABKAsyFS5qb3N0bGUudjEuRml4ZWRKb2ludEgAEiwKCGRpc3RhbmNlGAsgASgLMhguam9zdGxlLnYxLkRpc3RhbmNlSm9pbnRIABIuCgx2ZWxvY2l0eV9yb3cYECABKAsyFi5qb3N0bGUudjEuVmVsb2NpdHlSb3dIABIoCgZzbGlkZXIYESABKAsyFi5qb3N0bGUudjEuU2xpZGVySm9pbnRIABIpCgdzaXhfZG9mGBIgASgLMhYuam9zdGxlLnYxLlNpeERvZkpvaW50SAASJgoFd2hlZWwYEyABKAsyFS5qb3N0bGUudjEuV2hlZWxKb2ludEgAEiQKBGdyYWIYFCABKAsyFC5qb3N0bGUudjEuR3JhYkpvaW50SAASJAoEZ2VhchgVIAEoCzIULmpvc3RsZS52MS5HZWFySm9pbnRIABIkCgRyYWNrGBYgASgLMhQuam9zdGxlLnYxLlJhY2tKb2ludEgAEigKBnB1bGxleRgXIAEoCzIWLmpvc3RsZS52MS5QdWxsZXlKb2ludEgAEiQKBHBhdGgYGCABKAsyFC5qb3N0bGUudjEuUGF0aEpvaW50SAASGQoRY29sbGlkZV9jb25uZWN0ZWQYDCABKAgSEwoLYnJlYWtfZm9yY2UYDSABKAESFAoMYnJlYWtfdG9ycXVlGA4gASgBEiYKBnNvbHZlchgZIAEoDjIWLmpvc3RsZS52MS5Kb2ludFNvbHZlchImCgZyZXBlYXQYDyABKAsyFi5qb3N0bGUudjEuSm9pbnRSZXBlYXRCBgoEa2luZCI9CgtKb2ludFJlcGVhdBINCgVjb3VudBgBIAEoDRIfCgZvZmZzZXQYAiABKAsyDy5qb3N0bGUudjEuVmVjMyJSCgpKb2ludEZyYW1lEiEKCHBvc2l0aW9uGAEgASgLMg8uam9zdGxlLnYxLlZlYzMSIQoIcm90YXRpb24YAiABKAsyDy5qb3N0bGUudjEuUXVhdCJNCglCYWxsSm9pbnQSJwoFZHJpdmUYASABKAsyGC5qb3N0bGUudjEuUm90YXRpb25Ecml2ZRIXCg9mcmljdGlvbl90b3JxdWUYAiABKAEiewoNUm90YXRpb25Ecml2ZRIhCgZzcHJpbmcYASABKAsyES5qb3N0bGUudjEuU3ByaW5nEh8KBnRhcmdldBgCIAEoCzIPLmpvc3RsZS52MS5RdWF0EhcKCm1heF90b3JxdWUYAyABKAFIAIgBAUINCgtfbWF4X3RvcnF1ZSLUAQoKSGluZ2VKb2ludBIkCgVsaW1pdBgBIAEoCzIQLmpvc3RsZS52MS5MaW1pdEgAiAEBEhgKC21vdG9yX3NwZWVkGAIgASgBSAGIAQESGAoQbW90b3JfbWF4X3RvcnF1ZRgDIAEoARIhCgZzcHJpbmcYBCABKAsyES5qb3N0bGUudjEuU3ByaW5nEhQKDHNwcmluZ19hbmdsZRgFIAEoARIZChFzcHJpbmdfbWF4X3RvcnF1ZRgGIAEoAUIICgZfbGltaXRCDgoMX21vdG9yX3NwZWVkIpEBCg5Db25lVHdpc3RKb2ludBINCgVzd2luZxgBIAEoARIkCgV0d2lzdBgCIAEoCzIQLmpvc3RsZS52MS5MaW1pdEgAiAEBEhcKD2ZyaWN0aW9uX3RvcnF1ZRgDIAEoARInCgVkcml2ZRgEIAEoCzIYLmpvc3RsZS52MS5Sb3RhdGlvbkRyaXZlQggKBl90d2lzdCJTCgpGaXhlZEpvaW50EiEKBmxpbmVhchgBIAEoCzIRLmpvc3RsZS52MS5TcHJpbmcSIgoHYW5ndWxhchgCIAEoCzIRLmpvc3RsZS52MS5TcHJpbmcibwoNRGlzdGFuY2VKb2ludBISCgptaW5fbGVuZ3RoGAEgASgBEhIKCm1heF9sZW5ndGgYAiABKAESIQoGc3ByaW5nGAMgASgLMhEuam9zdGxlLnYxLlNwcmluZxITCgtyZXN0X2xlbmd0aBgEIAEoASLsAQoLU2xpZGVySm9pbnQSJAoFbGltaXQYASABKAsyEC5qb3N0bGUudjEuTGltaXRIAIgBARIYCgttb3Rvcl9zcGVlZBgCIAEoAUgBiAEBEhcKD21vdG9yX21heF9mb3JjZRgDIAEoARIhCgZzcHJpbmcYBCABKAsyES5qb3N0bGUudjEuU3ByaW5nEhUKDXNwcmluZ190cmF2ZWwYBSABKAESFgoOZnJpY3Rpb25fZm9yY2UYBiABKAESGAoQc3ByaW5nX21heF9mb3JjZRgHIAEoAUIICgZfbGltaXRCDgoMX21vdG9yX3NwZWVkIuIBCgtTaXhEb2ZKb2ludBIfCgF4GAEgASgLMhQuam9zdGxlLnYxLkpvaW50QXhpcxIfCgF5GAIgASgLMhQuam9zdGxlLnYxLkpvaW50QXhpcxIfCgF6GAMgASgLMhQuam9zdGxlLnYxLkpvaW50QXhpcxIkCgZ0dXJuX3gYBCABKAsyFC5qb3N0bGUudjEuSm9pbnRBeGlzEiQKBnR1cm5feRgFIAEoCzIULmpvc3RsZS52MS5Kb2ludEF4aXMSJAoGdHVybl96GAYgASgLMhQuam9zdGxlLnYxLkpvaW50QXhpcyLkAQoJSm9pbnRBeGlzEgwKBGZyZWUYASABKAgSJAoFbGltaXQYAiABKAsyEC5qb3N0bGUudjEuTGltaXRIAIgBARIhCgZzcHJpbmcYAyABKAsyES5qb3N0bGUudjEuU3ByaW5nEhEKCXNwcmluZ19hdBgEIAEoARIYCgttb3Rvcl9zcGVlZBgFIAEoAUgBiAEBEhIKCm1vdG9yX21vc3QYBiABKAESEAoIZnJpY3Rpb24YByABKAESEwoLc3ByaW5nX21vc3QYCCABKAFCCAoGX2xpbWl0Qg4KDF9tb3Rvcl9zcGVlZCK7AgoKV2hlZWxKb2ludBIlCgpzdXNwZW5zaW9uGAEgASgLMhEuam9zdGxlLnYxLlNwcmluZxIMCgRyaWRlGAIgASgBEiUKBnRyYXZlbBgDIAEoCzIQLmpvc3RsZS52MS5MaW1pdEgAiAEBEhAKCHN0ZWVyaW5nGAQgASgBEhUKDWZyZWVfc3RlZXJpbmcYBSABKAgSLQoOc3RlZXJpbmdfbGltaXQYBiABKAsyEC5qb3N0bGUudjEuTGltaXRIAYgBARIYCgttb3Rvcl9zcGVlZBgHIAEoAUgCiAEBEhgKEG1vdG9yX21heF90b3JxdWUYCCABKAESFwoPZnJpY3Rpb25fdG9ycXVlGAkgASgBQgkKB190cmF2ZWxCEQoPX3N0ZWVyaW5nX2xpbWl0Qg4KDF9tb3Rvcl9zcGVlZCKLAQoJR3JhYkpvaW50Eh8KBnRhcmdldBgBIAEoCzIPLmpvc3RsZS52MS5WZWMzEiEKBnNwcmluZxgCIAEoCzIRLmpvc3RsZS52MS5TcHJpbmcSFgoJbWF4X2ZvcmNlGAMgASgBSACIAQESFAoMdHVybl9kYW1waW5nGAQgASgBQgwKCl9tYXhfZm9yY2UiKQoJR2VhckpvaW50EhIKBXJhdGlvGAEgASgBSACIAQFCCAoGX3JhdGlvIisKCVJhY2tKb2ludBITCgZyYWRpdXMYASABKAFIAIgBAUIJCgdfcmFkaXVzIn8KC1B1bGxleUpvaW50EiAKB3BvaW50X2EYASABKAsyDy5qb3N0bGUudjEuVmVjMxIgCgdwb2ludF9iGAIgASgLMg8uam9zdGxlLnYxLlZlYzMSDgoGbGVuZ3RoGAMgASgBEhIKBXJhdGlvGAQgASgBSACIAQFCCAoGX3JhdGlvIqECCglQYXRoSm9pbnQSHwoGcG9pbnRzGAEgAygLMg8uam9zdGxlLnYxLlZlYzMSEwoGc21vb3RoGAIgASgISACIAQESDgoGY2xvc2VkGAMgASgIEiQKBWxpbWl0GAQgASgLMhAuam9zdGxlLnYxLkxpbWl0SAGIAQESGAoLbW90b3Jfc3BlZWQYBSABKAFIAogBARIXCg9tb3Rvcl9tYXhfZm9yY2UYBiABKAESIQoGc3ByaW5nGAcgASgLMhEuam9zdGxlLnYxLlNwcmluZxIVCg1zcHJpbmdfdHJhdmVsGAggASgBEhYKDmZyaWN0aW9uX2ZvcmNlGAkgASgBQgkKB19zbW9vdGhCCAoGX2xpbWl0Qg4KDF9tb3Rvcl9zcGVlZCKaAgoLVmVsb2NpdHlSb3cSIQoIbGluZWFyX2EYASABKAsyDy5qb3N0bGUudjEuVmVjMxIiCglhbmd1bGFyX2EYAiABKAsyDy5qb3N0bGUudjEuVmVjMxIhCghsaW5lYXJfYhgDIAEoCzIPLmpvc3RsZS52MS5WZWMzEiIKCWFuZ3VsYXJfYhgEIAEoCzIPLmpvc3RsZS52MS5WZWMzEhIKCndvcmxkX2F4ZXMYBSABKAgSDQoFc3BlZWQYBiABKAESDAoEYmlhcxgHIAEoARIQCghzb2Z0bmVzcxgIIAEoARISCgVsb3dlchgJIAEoAUgAiAEBEhIKBXVwcGVyGAogASgBSAGIAQFCCAoGX2xvd2VyQggKBl91cHBlciIlCgVMaW1pdBINCgVsb3dlchgBIAEoARINCgV1cHBlchgCIAEoASJFCgZTcHJpbmcSDQoFaGVydHoYASABKAESGgoNZGFtcGluZ19yYXRpbxgCIAEoAUgAiAEBQhAKDl9kYW1waW5nX3JhdGlvIpAFCgZNb2R1bGUSCwoDdGFnGAEgASgJEjEKCHNldHRpbmdzGAIgAygLMh8uam9zdGxlLnYxLk1vZHVsZS5TZXR0aW5nc0VudHJ5Ei0KBmJvZGllcxgDIAMoCzIdLmpvc3RsZS52MS5Nb2R1bGUuQm9kaWVzRW50cnkSDQoFc3RhdGUYBCABKAwSMQoKaG92ZXJjcmFmdBgKIAEoCzIbLmpvc3RsZS52MS5Ib3ZlcmNyYWZ0TW9kdWxlSAASLwoJY2hhcmFjdGVyGAsgASgLMhouam9zdGxlLnYxLkNoYXJhY3Rlck1vZHVsZUgAEisKB3ZlaGljbGUYDCABKAsyGC5qb3N0bGUudjEuVmVoaWNsZU1vZHVsZUgAEikKBmZpZWxkcxgNIAEoCzIXLmpvc3RsZS52MS5GaWVsZHNNb2R1bGVIABIrCgdyYWdkb2xsGA4gASgLMhguam9zdGxlLnYxLlJhZ2RvbGxNb2R1bGVIABIzCgtkZXN0cnVjdGlvbhgPIAEoCzIcLmpvc3RsZS52MS5EZXN0cnVjdGlvbk1vZHVsZUgAEiUKBGJvYXQYECABKAsyFS5qb3N0bGUudjEuQm9hdE1vZHVsZUgAEi8KCXBhcnRpY2xlcxgRIAEoCzIaLmpvc3RsZS52MS5QYXJ0aWNsZXNNb2R1bGVIABInCgVjcm93ZBgSIAEoCzIWLmpvc3RsZS52MS5Dcm93ZE1vZHVsZUgAGi8KDVNldHRpbmdzRW50cnkSCwoDa2V5GAEgASgJEg0KBXZhbHVlGAIgASgBOgI4ARotCgtCb2RpZXNFbnRyeRILCgNrZXkYASABKAkSDQoFdmFsdWUYAiABKAk6AjgBQgkKB29iamVjdHMqfAoLSm9pbnRTb2x2ZXISHAoYSk9JTlRfU09MVkVSX1VOU1BFQ0lGSUVEEAASGgoWSk9JTlRfU09MVkVSX0FVVE9NQVRJQxABEhoKFkpPSU5UX1NPTFZFUl9JVEVSQVRJVkUQAhIXChNKT0lOVF9TT0xWRVJfRElSRUNUEAMqhQEKCkJyb2FkUGhhc2USGwoXQlJPQURfUEhBU0VfVU5TUEVDSUZJRUQQABIcChhCUk9BRF9QSEFTRV9EWU5BTUlDX1RSRUUQARIeChpCUk9BRF9QSEFTRV9TT1JUX0FORF9TV0VFUBACEhwKGEJST0FEX1BIQVNFX1VOSUZPUk1fR1JJRBADKoQBCghCb2R5VHlwZRIZChVCT0RZX1RZUEVfVU5TUEVDSUZJRUQQABIUChBCT0RZX1RZUEVfU1RBVElDEAESEwoPQk9EWV9UWVBFX0ZJWEVEEAESFwoTQk9EWV9UWVBFX0tJTkVNQVRJQxACEhUKEUJPRFlfVFlQRV9EWU5BTUlDEAMaAhABKpMBCgdDb21iaW5lEhcKE0NPTUJJTkVfVU5TUEVDSUZJRUQQABITCg9DT01CSU5FX0FWRVJBR0UQARIaChZDT01CSU5FX0dFT01FVFJJQ19NRUFOEAISEwoPQ09NQklORV9NSU5JTVVNEAMSFAoQQ09NQklORV9NVUxUSVBMWRAEEhMKD0NPTUJJTkVfTUFYSU1VTRAFYgZwcm90bzM`,[Ls,wr(`Chdqb3N0bGUvdjEvbW9kdWxlcy5wcm90bxIJam9zdGxlLnYxIikKDFNldHRpbmdSYW5nZRILCgNsb3cYASABKAESDAoEaGlnaBgCIAEoASJQChBIb3ZlcmNyYWZ0TW9kdWxlEjwKBWNyYWZ0GAEgAygLMhUuam9zdGxlLnYxLkhvdmVyY3JhZnRCFurgGBIJAAAAAAAA8D8RAAAAAAAA8D8iwgEKCkhvdmVyY3JhZnQSFwoEYm9keRgBIAEoCUIJ8uAYBWNyYWZ0EisKBmhlaWdodBgCIAEoAUIW6uAYEgkzMzMzMzPTPxEAAAAAAAAIQEgAiAEBEiEKBXNwZWVkGAMgASgBQg3q4BgJEQAAAAAAADRASAGIAQESKwoGcmFkaXVzGAQgASgBQhbq4BgSCQAAAAAAABBAEQAAAAAAQI9ASAKIAQFCCQoHX2hlaWdodEIICgZfc3BlZWRCCQoHX3JhZGl1cyJTCg9DaGFyYWN0ZXJNb2R1bGUSQAoKY2hhcmFjdGVycxgBIAMoCzIULmpvc3RsZS52MS5DaGFyYWN0ZXJCFurgGBIJAAAAAAAA8D8RAAAAAAAAsEAi0gUKCUNoYXJhY3RlchIMCgRib2R5GAEgASgJEikKBG1hc3MYAiABKAFCFurgGBIJAAAAAAAA8D8RAAAAAACIw0BIAIgBARInCgtzbG9wZV9saW1pdBgDIAEoAUIN6uAYCREAAAAAAAD4P0gBiAEBEicKC3N0ZXBfaGVpZ2h0GAQgASgBQg3q4BgJEQAAAAAAAABASAKIAQESJgoKZmxvb3Jfc25hcBgFIAEoAUIN6uAYCREAAAAAAAAAQEgDiAEBEiYKCmp1bXBfc3BlZWQYBiABKAFCDergGAkRAAAAAAAAWUBIBIgBARIvChNncm91bmRfYWNjZWxlcmF0aW9uGAcgASgBQg3q4BgJEQAAAAAAavhASAWIAQESLAoQYWlyX2FjY2VsZXJhdGlvbhgIIAEoAUIN6uAYCREAAAAAAGr4QEgGiAEBEiQKCHN0cmVuZ3RoGAkgASgBQg3q4BgJEQAAAACAhC5BSAeIAQESKQoEc2tpbhgKIAEoAUIW6uAYEgn8qfHSTWJgPxEAAAAAAAAEQEgIiAEBEisKD2Nyb3VjaGVkX2hlaWdodBgLIAEoAUIN6uAYCREAAAAAAAA0QEgJiAEBEiIKBnN0cm9sbBgMIAEoAUIN6uAYCREAAAAAAAA0QEgKiAEBEjAKC3N0cm9sbF90dXJuGA0gASgBQhbq4BgSCQAAAAAAACTAEQAAAAAAACRASAuIAQFCBwoFX21hc3NCDgoMX3Nsb3BlX2xpbWl0Qg4KDF9zdGVwX2hlaWdodEINCgtfZmxvb3Jfc25hcEINCgtfanVtcF9zcGVlZEIWChRfZ3JvdW5kX2FjY2VsZXJhdGlvbkITChFfYWlyX2FjY2VsZXJhdGlvbkILCglfc3RyZW5ndGhCBwoFX3NraW5CEgoQX2Nyb3VjaGVkX2hlaWdodEIJCgdfc3Ryb2xsQg4KDF9zdHJvbGxfdHVybiJFCg1WZWhpY2xlTW9kdWxlEjQKBGNhcnMYASADKAsyDi5qb3N0bGUudjEuQ2FyQhbq4BgSCQAAAAAAAPA/EQAAAAAAQI9AIrMJCgNDYXISFQoEYm9keRgBIAEoCUIH8uAYA2NhchIqCgV0cmFjaxgCIAEoAUIW6uAYEgmamZmZmZm5PxEAAAAAAAA0QEgAiAEBEi8KCndoZWVsX2Jhc2UYAyABKAFCFurgGBIJmpmZmZmZuT8RAAAAAAAASUBIAYgBARIrCgZoZWlnaHQYBCABKAFCFurgGBIJAAAAAAAAJMARAAAAAAAAJEBIAogBARIrCgZyYWRpdXMYBSABKAFCFurgGBIJexSuR+F6lD8RAAAAAAAAJEBIA4gBARIqCgV3aWR0aBgGIAEoAUIW6uAYEgl7FK5H4XqEPxEAAAAAAAAkQEgEiAEBEi0KCHNob3J0ZXN0GAcgASgBQhbq4BgSCQAAAAAAACTAEQAAAAAAACRASAWIAQESLAoHbG9uZ2VzdBgIIAEoAUIW6uAYEgkAAAAAAAAkwBEAAAAAAAAkQEgGiAEBEi4KCWZyZXF1ZW5jeRgJIAEoAUIW6uAYEgmamZmZmZm5PxEAAAAAAABZQEgHiAEBEiMKB2RhbXBpbmcYCiABKAFCDergGAkRAAAAAAAAJEBICIgBARIkCghmcmljdGlvbhgLIAEoAUIN6uAYCREAAAAAAAAkQEgJiAEBEicKC2Zyb250X2RyaXZlGAwgASgBQg3q4BgJEQAAAAAAAPA/SAqIAQESKQoNc3RlZXJpbmdfbW9zdBgNIAEoAUIN6uAYCRFmZmZmZmb2P0gLiAEBEiUKCWFudGlfcm9sbBgOIAEoAUIN6uAYCREAAAAA0BJjQUgMiAEBEicKC3Bvd2VyX3NjYWxlGA8gASgBQg3q4BgJEQAAAAAAAFlASA2IAQESJwoEY2FzdBgQIAEoDjIULmpvc3RsZS52MS5XaGVlbENhc3RIDogBARIkCgh0aHJvdHRsZRgRIAEoAUIN6uAYCREAAAAAAADwP0gPiAEBEiEKBWJyYWtlGBIgASgBQg3q4BgJEQAAAAAAAPA/SBCIAQESLQoIc3RlZXJpbmcYEyABKAFCFurgGBIJAAAAAAAA8L8RAAAAAAAA8D9IEYgBARIxCgxwaWxvdF9yYWRpdXMYFCABKAFCFurgGBIJAAAAAAAAEEARAAAAAACIw0BIEogBARInCgtwaWxvdF9zcGVlZBgVIAEoAUIN6uAYCREAAAAAAABpQEgTiAEBEikKBG1ha2UYFiABKA4yFi5qb3N0bGUudjEuVmVoaWNsZU1ha2VIFIgBAUIICgZfdHJhY2tCDQoLX3doZWVsX2Jhc2VCCQoHX2hlaWdodEIJCgdfcmFkaXVzQggKBl93aWR0aEILCglfc2hvcnRlc3RCCgoIX2xvbmdlc3RCDAoKX2ZyZXF1ZW5jeUIKCghfZGFtcGluZ0ILCglfZnJpY3Rpb25CDgoMX2Zyb250X2RyaXZlQhAKDl9zdGVlcmluZ19tb3N0QgwKCl9hbnRpX3JvbGxCDgoMX3Bvd2VyX3NjYWxlQgcKBV9jYXN0QgsKCV90aHJvdHRsZUIICgZfYnJha2VCCwoJX3N0ZWVyaW5nQg8KDV9waWxvdF9yYWRpdXNCDgoMX3BpbG90X3NwZWVkQgcKBV9tYWtlIuQBCgxGaWVsZHNNb2R1bGUSOQoLdHVyYnVsZW5jZXMYASADKAsyFS5qb3N0bGUudjEuVHVyYnVsZW5jZUIN6uAYCREAAAAAAABQQBIvCgZ3YXRlcnMYAiADKAsyEC5qb3N0bGUudjEuV2F0ZXJCDergGAkRAAAAAAAAUEASNwoHY2VudGVycxgDIAMoCzIXLmpvc3RsZS52MS5DZW50cmFsRmllbGRCDergGAkRAAAAAAAAUEASLwoGYmxhc3RzGAQgAygLMhAuam9zdGxlLnYxLkJsYXN0Qg3q4BgJEQAAAAAAQI9AIv4BCgtGaWVsZFZvbHVtZRI8CgZjZW50ZXIYASABKAsyDy5qb3N0bGUudjEuVmVjM0IW6uAYEgkAAAAA0BJjwREAAAAA0BJjQUgAiAEBEisKBmhhbGZfeBgCIAEoAUIW6uAYEgn8qfHSTWJQPxEAAAAA0BJjQUgBiAEBEisKBmhhbGZfeRgDIAEoAUIW6uAYEgn8qfHSTWJQPxEAAAAA0BJjQUgCiAEBEisKBmhhbGZfehgEIAEoAUIW6uAYEgn8qfHSTWJQPxEAAAAA0BJjQUgDiAEBQgkKB19jZW50ZXJCCQoHX2hhbGZfeEIJCgdfaGFsZl95QgkKB19oYWxmX3oi+wQKClR1cmJ1bGVuY2USOwoGdm9sdW1lGAEgASgLMhYuam9zdGxlLnYxLkZpZWxkVm9sdW1lQg7y4BgKdHVyYnVsZW5jZUgAiAEBEk0KBHdpbmQYAiABKAsyDy5qb3N0bGUudjEuVmVjM0Ip8uAYD3R1cmJ1bGVuY2Vfd2luZOrgGBIJAAAAAACIw8ARAAAAAACIw0BIAYgBARI1CgVzcGVlZBgDIAEoAUIh8uAYEHR1cmJ1bGVuY2Vfc3BlZWTq4BgJEQAAAAAAQI9ASAKIAQESPgoFc2NhbGUYBCABKAFCKvLgGBB0dXJidWxlbmNlX3NjYWxl6uAYEgl7FK5H4XqEPxEAAAAAgIQuQUgDiAEBEjMKBHJhdGUYBSABKAFCIPLgGA90dXJidWxlbmNlX3JhdGXq4BgJEQAAAAAAQI9ASASIAQESQgoHb2N0YXZlcxgGIAEoDUIs8uAYEnR1cmJ1bGVuY2Vfb2N0YXZlc+rgGBIJAAAAAAAA8D8RAAAAAAAAIEBIBYgBARImCgRzZWVkGAcgASgNQhPy4BgPdHVyYnVsZW5jZV9zZWVkSAaIAQESOQoHZGVuc2l0eRgIIAEoAUIj8uAYEnR1cmJ1bGVuY2VfZGVuc2l0eergGAkRAAAAAICELkFIB4gBARIzCgRkcmFnGAkgASgBQiDy4BgPdHVyYnVsZW5jZV9kcmFn6uAYCREAAAAAgIQuQUgIiAEBQgkKB192b2x1bWVCBwoFX3dpbmRCCAoGX3NwZWVkQggKBl9zY2FsZUIHCgVfcmF0ZUIKCghfb2N0YXZlc0IHCgVfc2VlZEIKCghfZGVuc2l0eUIHCgVfZHJhZyLWAwoFV2F0ZXISNgoGdm9sdW1lGAEgASgLMhYuam9zdGxlLnYxLkZpZWxkVm9sdW1lQgny4BgFd2F2ZXNIAIgBARI5CgVsZXZlbBgCIAEoAUIl8uAYC3dhdmVzX2xldmVs6uAYEgkAAAAA0BJjwREAAAAA0BJjQUgBiAEBEjQKB2RlbnNpdHkYAyABKAFCHvLgGA13YXZlc19kZW5zaXR56uAYCREAAAAAgIQuQUgCiAEBEkgKBGZsb3cYBCABKAsyDy5qb3N0bGUudjEuVmVjM0Ik8uAYCndhdmVzX2Zsb3fq4BgSCQAAAAAAiMPAEQAAAAAAiMNASAOIAQESLgoEZHJhZxgFIAEoAUIb8uAYCndhdmVzX2RyYWfq4BgJEQAAAACAhC5BSASIAQESNAoHZGFtcGluZxgGIAEoAUIe8uAYDXdhdmVzX2RhbXBpbmfq4BgJEQAAAAAAiMNASAWIAQESNQoFd2F2ZXMYByADKAsyDy5qb3N0bGUudjEuV2F2ZUIV8uAYBHdhdmXq4BgJEQAAAAAAABBAQgkKB192b2x1bWVCCAoGX2xldmVsQgoKCF9kZW5zaXR5QgcKBV9mbG93QgcKBV9kcmFnQgoKCF9kYW1waW5nItABCgRXYXZlEiAKCWFtcGxpdHVkZRgBIAEoAUIN6uAYCREAAAAAAABZQBIrCgZsZW5ndGgYAiABKAFCFurgGBIJmpmZmZmZuT8RAAAAAACIw0BIAIgBARIsCgdoZWFkaW5nGAMgASgBQhbq4BgSCQAAAAAAQI/AEQAAAAAAQI9ASAGIAQESKgoFcGhhc2UYBCABKAFCFurgGBIJAAAAAABAj8ARAAAAAABAj0BIAogBAUIJCgdfbGVuZ3RoQgoKCF9oZWFkaW5nQggKBl9waGFzZSLgAwoMQ2VudHJhbEZpZWxkEjgKBnZvbHVtZRgBIAEoCzIWLmpvc3RsZS52MS5GaWVsZFZvbHVtZUIL8uAYB2NlbnRyYWxIAIgBARIYCgRib2R5GAIgASgJQgry4BgGY2VudGVyEkwKBXBvaW50GAMgASgLMg8uam9zdGxlLnYxLlZlYzNCJ/LgGA1jZW50cmFsX3BvaW506uAYEgkAAAAA0BJjwREAAAAA0BJjQUgBiAEBEkEKCHN0cmVuZ3RoGAQgASgBQiry4BgQY2VudHJhbF9zdHJlbmd0aOrgGBIJAAAAopQabcIRAAAAopQabUJIAogBARI2CgdmYWxsb2ZmGAUgASgNQiDy4BgPY2VudHJhbF9mYWxsb2Zm6uAYCREAAAAAAAAQQEgDiAEBEj8KB25lYXJlc3QYBiABKAFCKfLgGA9jZW50cmFsX25lYXJlc3Tq4BgSCY3ttaD3xrA+EQAAAACAhC5BSASIAQESKwoIcGVyX21hc3MYByABKAhCFPLgGBBjZW50cmFsX3Blcl9tYXNzSAWIAQFCCQoHX3ZvbHVtZUIICgZfcG9pbnRCCwoJX3N0cmVuZ3RoQgoKCF9mYWxsb2ZmQgoKCF9uZWFyZXN0QgsKCV9wZXJfbWFzcyLmBAoFQmxhc3QSLgoEdGltZRgBIAEoAUIb8uAYCmJsYXN0X3RpbWXq4BgJEQAAAKKUGm1CSACIAQESTAoGY2VudGVyGAIgASgLMg8uam9zdGxlLnYxLlZlYzNCJvLgGAxibGFzdF9jZW50ZXLq4BgSCQAAAADQEmPBEQAAAADQEmNBSAGIAQESOwoGcmFkaXVzGAMgASgBQiby4BgMYmxhc3RfcmFkaXVz6uAYEgn8qfHSTWJQPxEAAAAAAIjDQEgCiAEBEjYKCHN0cmVuZ3RoGAQgASgBQh/y4BgOYmxhc3Rfc3RyZW5ndGjq4BgJEQAAAABlzc1BSAOIAQESNwoEY29yZRgFIAEoAUIk8uAYCmJsYXN0X2NvcmXq4BgSCfyp8dJNYlA/EQAAAAAAiMNASASIAQESNAoHZmFsbG9mZhgGIAEoDUIe8uAYDWJsYXN0X2ZhbGxvZmbq4BgJEQAAAAAAABBASAWIAQESIQoEZmFkZRgHIAEoCEIO8uAYCmJsYXN0X2ZhZGVIBogBARI2CghzdGFuZG9mZhgIIAEoAUIf8uAYDmJsYXN0X3N0YW5kb2Zm6uAYCREAAAAAAABZQEgHiAEBEjoKCm1vc3Rfc3BlZWQYCSABKAFCIfLgGBBibGFzdF9tb3N0X3NwZWVk6uAYCREAAAAAAIjDQEgIiAEBQgcKBV90aW1lQgkKB19jZW50ZXJCCQoHX3JhZGl1c0ILCglfc3RyZW5ndGhCBwoFX2NvcmVCCgoIX2ZhbGxvZmZCBwoFX2ZhZGVCCwoJX3N0YW5kb2ZmQg0KC19tb3N0X3NwZWVkIkQKCkJvYXRNb2R1bGUSNgoFYm9hdHMYASADKAsyDy5qb3N0bGUudjEuQm9hdEIW6uAYEgkAAAAAAADwPxEAAAAAAABwQCLZAgoEQm9hdBIMCgRib2R5GAEgASgJEiwKB3NjcmV3X3kYAiABKAFCFurgGBIJAAAAAAAAFMARAAAAAAAAFEBIAIgBARIsCgdzY3Jld196GAMgASgBQhbq4BgSCQAAAAAAABTAEQAAAAAAABRASAGIAQESIgoGdGhydXN0GAQgASgBQg3q4BgJEQAAAADQEmNBSAKIAQESLgoJdG9wX3NwZWVkGAUgASgBQhbq4BgSCZqZmZmZmbk/EQAAAAAAAFlASAOIAQESJwoLcnVkZGVyX21vc3QYBiABKAFCDergGAkRMzMzMzMz8z9IBIgBARIgCgRrZWVsGAcgASgBQg3q4BgJEQAAAACAhC5BSAWIAQFCCgoIX3NjcmV3X3lCCgoIX3NjcmV3X3pCCQoHX3RocnVzdEIMCgpfdG9wX3NwZWVkQg4KDF9ydWRkZXJfbW9zdEIHCgVfa2VlbCJPCg1SYWdkb2xsTW9kdWxlEj4KB2ZpZ3VyZXMYASADKAsyFS5qb3N0bGUudjEuUmFnZG9sbFJvd0IW6uAYEgkAAAAAAADwPxEAAAAAAABpQCL9AgoKUmFnZG9sbFJvdxIhCgVjb3VudBgBIAEoDUIN6uAYCREAAAAAAABpQEgAiAEBEisKBmhlaWdodBgCIAEoAUIW6uAYEgmamZmZmZnJPxEAAAAAAAA0QEgBiAEBEiwKB3NwYWNpbmcYAyABKAFCFurgGBIJmpmZmZmZuT8RAAAAAABAj0BIAogBARImCgF4GAQgASgBQhbq4BgSCQAAAACAhC7BEQAAAACAhC5BSAOIAQESJgoBeRgFIAEoAUIW6uAYEgkAAAAAgIQuwREAAAAAgIQuQUgEiAEBEiYKAXoYBiABKAFCFurgGBIJAAAAAICELsERAAAAAICELkFIBYgBARIUCgdwb3dlcmVkGAcgASgISAaIAQESFgoJa2luZW1hdGljGAggASgISAeIAQFCCAoGX2NvdW50QgkKB19oZWlnaHRCCgoIX3NwYWNpbmdCBAoCX3hCBAoCX3lCBAoCX3pCCgoIX3Bvd2VyZWRCDAoKX2tpbmVtYXRpYyKBAQoRRGVzdHJ1Y3Rpb25Nb2R1bGUSMAoFd2FsbHMYASADKAsyEi5qb3N0bGUudjEuV2FsbFJvd0IN6uAYCREAAAAAAABZQBI6CglmcmFjdHVyZWQYAiADKAsyGC5qb3N0bGUudjEuRnJhY3R1cmVkQm9keUIN6uAYCREAAAAAAABZQCLEBQoNRnJhY3R1cmVkQm9keRINCgVzaGFwZRgBIAEoDBImCgF4GAIgASgBQhbq4BgSCQAAAACAhC7BEQAAAACAhC5BSACIAQESJgoBeRgDIAEoAUIW6uAYEgkAAAAAgIQuwREAAAAAgIQuQUgBiAEBEiYKAXoYBCABKAFCFurgGBIJAAAAAICELsERAAAAAICELkFIAogBARIsCgdoZWFkaW5nGAUgASgBQhbq4BgSCQAAAAAAABzAEQAAAAAAABxASAOIAQESLAoHZGVuc2l0eRgGIAEoAUIW6uAYEgkAAAAAAADwPxEAAAAAAGr4QEgEiAEBEiwKB3RlbnNpbGUYByABKAFCFurgGBIJAAAAAAAA8D8RAABA5ZwwokJIBYgBARIqCgVzaGVhchgIIAEoAUIW6uAYEgkAAAAAAADwPxEAAEDlnDCiQkgGiAEBEjAKC2NvbXByZXNzaXZlGAkgASgBQhbq4BgSCQAAAAAAAPA/EQAAQOWcMKJCSAeIAQESKwoPZnJhY3R1cmVfZW5lcmd5GAogASgBQg3q4BgJEQAAAABlzc1BSAiIAQESJwoLZGVicmlzX2xpZmUYCyABKAFCDergGAkRAAAAAICELkFICYgBARIpCg1kZWJyaXNfdm9sdW1lGAwgASgBQg3q4BgJEQAAAKKUGm1CSAqIAQESKgoOcGFzc2luZ192b2x1bWUYDSABKAFCDergGAkRAAAAopQabUJIC4gBAUIECgJfeEIECgJfeUIECgJfekIKCghfaGVhZGluZ0IKCghfZGVuc2l0eUIKCghfdGVuc2lsZUIICgZfc2hlYXJCDgoMX2NvbXByZXNzaXZlQhIKEF9mcmFjdHVyZV9lbmVyZ3lCDgoMX2RlYnJpc19saWZlQhAKDl9kZWJyaXNfdm9sdW1lQhEKD19wYXNzaW5nX3ZvbHVtZSKgBwoHV2FsbFJvdxIhCgVjb3VudBgBIAEoDUIN6uAYCREAAAAAAABZQEgAiAEBEiMKB3NwYWNpbmcYAiABKAFCDergGAkRAAAAAABAj0BIAYgBARIqCgV3aWR0aBgDIAEoAUIW6uAYEgmamZmZmZm5PxEAAAAAAABZQEgCiAEBEisKBmhlaWdodBgEIAEoAUIW6uAYEgmamZmZmZm5PxEAAAAAAABZQEgDiAEBEi4KCXRoaWNrbmVzcxgFIAEoAUIW6uAYEgl7FK5H4XqUPxEAAAAAAABZQEgEiAEBEisKBmNodW5rcxgGIAEoDUIW6uAYEgkAAAAAAADwPxEAAAAAAECfQEgFiAEBEiAKBHNlZWQYByABKA1CDergGAkRAAAAAGXNzUFIBogBARImCgF4GAggASgBQhbq4BgSCQAAAACAhC7BEQAAAACAhC5BSAeIAQESJgoBeRgJIAEoAUIW6uAYEgkAAAAAgIQuwREAAAAAgIQuQUgIiAEBEiYKAXoYCiABKAFCFurgGBIJAAAAAICELsERAAAAAICELkFICYgBARIsCgdkZW5zaXR5GAsgASgBQhbq4BgSCQAAAAAAAPA/EQAAAAAAavhASAqIAQESLAoHdGVuc2lsZRgMIAEoAUIW6uAYEgkAAAAAAADwPxEAAEDlnDCiQkgLiAEBEioKBXNoZWFyGA0gASgBQhbq4BgSCQAAAAAAAPA/EQAAQOWcMKJCSAyIAQESKwoPZnJhY3R1cmVfZW5lcmd5GA4gASgBQg3q4BgJEQAAAABlzc1BSA2IAQESJwoLZGVicmlzX2xpZmUYDyABKAFCDergGAkRAAAAAICELkFIDogBARIpCg1kZWJyaXNfdm9sdW1lGBAgASgBQg3q4BgJEQAAAKKUGm1CSA+IAQESKgoOcGFzc2luZ192b2x1bWUYESABKAFCDergGAkRAAAAopQabUJIEIgBAUIICgZfY291bnRCCgoIX3NwYWNpbmdCCAoGX3dpZHRoQgkKB19oZWlnaHRCDAoKX3RoaWNrbmVzc0IJCgdfY2h1bmtzQgcKBV9zZWVkQgQKAl94QgQKAl95QgQKAl96QgoKCF9kZW5zaXR5QgoKCF90ZW5zaWxlQggKBl9zaGVhckISChBfZnJhY3R1cmVfZW5lcmd5Qg4KDF9kZWJyaXNfbGlmZUIQCg5fZGVicmlzX3ZvbHVtZUIRCg9fcGFzc2luZ192b2x1bWUiUwoPUGFydGljbGVzTW9kdWxlEkAKBmdyb3VwcxgBIAMoCzIYLmpvc3RsZS52MS5QYXJ0aWNsZUdyb3VwQhbq4BgSCQAAAAAAAPA/EQAAAAAAAFBAIsILCg1QYXJ0aWNsZUdyb3VwEjYKCmludGVncmF0b3IYASABKA4yHS5qb3N0bGUudjEuUGFydGljbGVJbnRlZ3JhdG9ySACIAQESLQoIc3Vic3RlcHMYAiABKA1CFurgGBIJAAAAAAAA8D8RAAAAAAAAUEBIAYgBARIuCgljb3VudF9tYXgYAyABKA1CFurgGBIJAAAAAAAA8D8RAAAAAABq+EBIAogBARIpCgRtYXNzGAQgASgBQhbq4BgSCZXWJugLLhE+EQAAAACAhC5BSAOIAQESIgoGcmFkaXVzGAUgASgBQg3q4BgJEQAAAAAAAFlASASIAQESMgoNZ3Jhdml0eV9zY2FsZRgGIAEoAUIW6uAYEgkAAAAAAECPwBEAAAAAAECPQEgFiAEBEicKC2xpbmVhcl9kcmFnGAcgASgBQg3q4BgJEQAAAACAhC5BSAaIAQESKgoOcXVhZHJhdGljX2RyYWcYCCABKAFCDergGAkRAAAAAICELkFIB4gBARIYCgtmb2xsb3dfZmxvdxgJIAEoCEgIiAEBEhkKDHdvcmxkX2ZpZWxkcxgKIAEoCEgJiAEBEhUKCGNhdGVnb3J5GAsgASgNSAqIAQESLwoKYXR0cmFjdGlvbhgMIAEoAUIW6uAYEgkAAACilBptwhEAAACilBptQkgLiAEBEi4KCXNvZnRlbmluZxgNIAEoAUIW6uAYEgmN7bWg98awPhEAAAAAAIjDQEgMiAEBEhsKDmNvbGxpZGVfYm9kaWVzGA4gASgISA2IAQESHAoPYm9keV9jYXRlZ29yaWVzGA8gASgNSA6IAQESHgoRY29sbGlkZV9wYXJ0aWNsZXMYECABKAhID4gBARInCgtyZXN0aXR1dGlvbhgRIAEoAUIN6uAYCREAAAAAAADwP0gQiAEBEiQKCGZyaWN0aW9uGBIgASgBQg3q4BgJEQAAAAAAACRASBGIAQESEwoGcGxhbmFyGBMgASgISBKIAQESFQoIY29zbWV0aWMYFCABKAhIE4gBARIhCgVjb2xvchgVIAEoDUIN6uAYCREAAADg//9vQUgUiAEBEjAKB2VtaXR0ZXIYFiABKAsyGi5qb3N0bGUudjEuUGFydGljbGVFbWl0dGVySBWIAQESKgoEZmxvdxgXIAEoCzIXLmpvc3RsZS52MS5QYXJ0aWNsZUZsb3dIFogBARI/CgphdHRyYWN0b3JzGBggAygLMhwuam9zdGxlLnYxLlBhcnRpY2xlQXR0cmFjdG9yQg3q4BgJEQAAAAAAACBAEjcKBnBsYW5lcxgZIAMoCzIYLmpvc3RsZS52MS5QYXJ0aWNsZVBsYW5lQg3q4BgJEQAAAAAAACBAEjoKCXBhcnRpY2xlcxgaIAMoCzIYLmpvc3RsZS52MS5QYXJ0aWNsZVN0YXJ0Qg3q4BgJEQAAAAAAAHBAEjkKB3NwcmluZ3MYGyADKAsyGS5qb3N0bGUudjEuUGFydGljbGVTcHJpbmdCDergGAkRAAAAAAAAkEBCDQoLX2ludGVncmF0b3JCCwoJX3N1YnN0ZXBzQgwKCl9jb3VudF9tYXhCBwoFX21hc3NCCQoHX3JhZGl1c0IQCg5fZ3Jhdml0eV9zY2FsZUIOCgxfbGluZWFyX2RyYWdCEQoPX3F1YWRyYXRpY19kcmFnQg4KDF9mb2xsb3dfZmxvd0IPCg1fd29ybGRfZmllbGRzQgsKCV9jYXRlZ29yeUINCgtfYXR0cmFjdGlvbkIMCgpfc29mdGVuaW5nQhEKD19jb2xsaWRlX2JvZGllc0ISChBfYm9keV9jYXRlZ29yaWVzQhQKEl9jb2xsaWRlX3BhcnRpY2xlc0IOCgxfcmVzdGl0dXRpb25CCwoJX2ZyaWN0aW9uQgkKB19wbGFuYXJCCwoJX2Nvc21ldGljQggKBl9jb2xvckIKCghfZW1pdHRlckIHCgVfZmxvdyL+BgoPUGFydGljbGVFbWl0dGVyEisKBXNoYXBlGAEgASgOMhcuam9zdGxlLnYxLkVtaXR0ZXJTaGFwZUgAiAEBEj4KCHBvc2l0aW9uGAIgASgLMg8uam9zdGxlLnYxLlZlYzNCFurgGBIJAAAAANASY8ERAAAAANASY0FIAYgBARI/CglkaXJlY3Rpb24YAyABKAsyDy5qb3N0bGUudjEuVmVjM0IW6uAYEgkAAAAAgIQuwREAAAAAgIQuQUgCiAEBEiIKBnJhZGl1cxgEIAEoAUIN6uAYCREAAAAAAIjDQEgDiAEBEjkKDGhhbGZfZXh0ZW50cxgFIAEoCzIPLmpvc3RsZS52MS5WZWMzQg3q4BgJEQAAAAAAiMNASASIAQESIAoEcmF0ZRgGIAEoAUIN6uAYCREAAAAAgIQuQUgFiAEBEiEKBWJ1cnN0GAcgASgNQg3q4BgJEQAAAAAAavhASAaIAQESKAoMYnVyc3RfcGVyaW9kGAggASgBQg3q4BgJEQAAAACAhC5BSAeIAQESIQoFc3RhcnQYCSABKAFCDergGAkRAAAAopQabUJICIgBARIkCghkdXJhdGlvbhgKIAEoAUIN6uAYCREAAACilBptQkgJiAEBEiEKBXNwZWVkGAsgASgBQg3q4BgJEQAAAAAAiMNASAqIAQESKAoMc3BlZWRfc3ByZWFkGAwgASgBQg3q4BgJEQAAAAAAAPA/SAuIAQESIAoEY29uZRgNIAEoAUIN6uAYCREaLURU+yEJQEgMiAEBEi0KCGxpZmV0aW1lGA4gASgBQhbq4BgSCfyp8dJNYlA/EQAAAACAhC5BSA2IAQESKwoPbGlmZXRpbWVfc3ByZWFkGA8gASgBQg3q4BgJEQAAAAAAAPA/SA6IAQESEQoEc2VlZBgQIAEoDUgPiAEBQggKBl9zaGFwZUILCglfcG9zaXRpb25CDAoKX2RpcmVjdGlvbkIJCgdfcmFkaXVzQg8KDV9oYWxmX2V4dGVudHNCBwoFX3JhdGVCCAoGX2J1cnN0Qg8KDV9idXJzdF9wZXJpb2RCCAoGX3N0YXJ0QgsKCV9kdXJhdGlvbkIICgZfc3BlZWRCDwoNX3NwZWVkX3NwcmVhZEIHCgVfY29uZUILCglfbGlmZXRpbWVCEgoQX2xpZmV0aW1lX3NwcmVhZEIHCgVfc2VlZCKeAwoMUGFydGljbGVGbG93EjoKBHdpbmQYASABKAsyDy5qb3N0bGUudjEuVmVjM0IW6uAYEgkAAAAAAIjDwBEAAAAAAIjDQEgAiAEBEiEKBXNwZWVkGAIgASgBQg3q4BgJEQAAAAAAQI9ASAGIAQESKgoFc2NhbGUYAyABKAFCFurgGBIJexSuR+F6hD8RAAAAAICELkFIAogBARIgCgRyYXRlGAQgASgBQg3q4BgJEQAAAAAAQI9ASAOIAQESLAoHb2N0YXZlcxgFIAEoDUIW6uAYEgkAAAAAAADwPxEAAAAAAAAgQEgEiAEBEhEKBHNlZWQYBiABKA1IBYgBARIpCgRyYW1wGAcgASgBQhbq4BgSCfyp8dJNYlA/EQAAAACAhC5BSAaIAQESMQoFd2FsbHMYCCADKAsyEy5qb3N0bGUudjEuRmxvd1dhbGxCDergGAkRAAAAAAAAIEBCBwoFX3dpbmRCCAoGX3NwZWVkQggKBl9zY2FsZUIHCgVfcmF0ZUIKCghfb2N0YXZlc0IHCgVfc2VlZEIHCgVfcmFtcCLpAQoIRmxvd1dhbGwSOwoFcG9pbnQYASABKAsyDy5qb3N0bGUudjEuVmVjM0IW6uAYEgkAAAAA0BJjwREAAAAA0BJjQUgAiAEBEjwKBm5vcm1hbBgCIAEoCzIPLmpvc3RsZS52MS5WZWMzQhbq4BgSCQAAAACAhC7BEQAAAACAhC5BSAGIAQESIgoGcmFkaXVzGAMgASgBQg3q4BgJEQAAAACAhC5BSAKIAQESEwoGaW5zaWRlGAQgASgISAOIAQFCCAoGX3BvaW50QgkKB19ub3JtYWxCCQoHX3JhZGl1c0IJCgdfaW5zaWRlIpQCChFQYXJ0aWNsZUF0dHJhY3RvchI7CgVwb2ludBgBIAEoCzIPLmpvc3RsZS52MS5WZWMzQhbq4BgSCQAAAADQEmPBEQAAAADQEmNBSACIAQESLQoIc3RyZW5ndGgYAiABKAFCFurgGBIJAAAAAGXNzcERAAAAAGXNzUFIAYgBARIsCgdmYWxsb2ZmGAMgASgRQhbq4BgSCQAAAAAAAPC/EQAAAAAAABBASAKIAQESMQoMbWluX2Rpc3RhbmNlGAQgASgBQhbq4BgSCY3ttaD3xrA+EQAAAACAhC5BSAOIAQFCCAoGX3BvaW50QgsKCV9zdHJlbmd0aEIKCghfZmFsbG9mZkIPCg1fbWluX2Rpc3RhbmNlIpABCg1QYXJ0aWNsZVBsYW5lEjwKBm5vcm1hbBgBIAEoCzIPLmpvc3RsZS52MS5WZWMzQhbq4BgSCQAAAACAhC7BEQAAAACAhC5BSACIAQESKwoGb2Zmc2V0GAIgASgBQhbq4BgSCQAAAADQEmPBEQAAAADQEmNBSAGIAQFCCQoHX25vcm1hbEIJCgdfb2Zmc2V0ItwBCg1QYXJ0aWNsZVN0YXJ0Ej4KCHBvc2l0aW9uGAEgASgLMg8uam9zdGxlLnYxLlZlYzNCFurgGBIJAAAAANASY8ERAAAAANASY0FIAIgBARI+Cgh2ZWxvY2l0eRgCIAEoCzIPLmpvc3RsZS52MS5WZWMzQhbq4BgSCQAAAAAAiMPAEQAAAAAAiMNASAGIAQESJAoIbGlmZXRpbWUYAyABKAFCDergGAkRAAAAAICELkFIAogBAUILCglfcG9zaXRpb25CCwoJX3ZlbG9jaXR5QgsKCV9saWZldGltZSLKAgoOUGFydGljbGVTcHJpbmcSIAoEZnJvbRgBIAEoDUIN6uAYCREAAAAAAOBvQEgAiAEBEh4KAnRvGAIgASgNQg3q4BgJEQAAAAAAAHBASAGIAQESPAoGYW5jaG9yGAMgASgLMg8uam9zdGxlLnYxLlZlYzNCFurgGBIJAAAAANASY8ERAAAAANASY0FIAogBARInCgtyZXN0X2xlbmd0aBgEIAEoAUIN6uAYCREAAAAAAIjDQEgDiAEBEiUKCXN0aWZmbmVzcxgFIAEoAUIN6uAYCREAAAAAZc3NQUgEiAEBEiMKB2RhbXBpbmcYBiABKAFCDergGAkRAAAAAICELkFIBYgBAUIHCgVfZnJvbUIFCgNfdG9CCQoHX2FuY2hvckIOCgxfcmVzdF9sZW5ndGhCDAoKX3N0aWZmbmVzc0IKCghfZGFtcGluZyL3AwoLQ3Jvd2RNb2R1bGUSMwoFcnVsZXMYASADKAsyFS5qb3N0bGUudjEuQ3Jvd2RSdWxlc0IN6uAYCREAAAAAAADwPxI1CgZyb3V0ZXMYAiADKAsyFi5qb3N0bGUudjEuQ3Jvd2RSb3V0ZXNCDergGAkRAAAAAAAA8D8SMgoFd2FsbHMYAyADKAsyFC5qb3N0bGUudjEuQ3Jvd2RXYWxsQg3q4BgJEQAAAAAAALBAEjoKCW9ic3RhY2xlcxgEIAMoCzIYLmpvc3RsZS52MS5Dcm93ZE9ic3RhY2xlQg3q4BgJEQAAAAAAQI9AEjIKBWdvYWxzGAUgAygLMhQuam9zdGxlLnYxLkNyb3dkR29hbEIN6uAYCREAAAAAAABwQBI0CgZmbG9ja3MYBiADKAsyFS5qb3N0bGUudjEuQ3Jvd2RGbG9ja0IN6uAYCREAAAAAAABQQBI0CgZncm91cHMYByADKAsyFS5qb3N0bGUudjEuQ3Jvd2RHcm91cEIN6uAYCREAAAAAAECPQBI0CgZhZ2VudHMYCCADKAsyFS5qb3N0bGUudjEuQ3Jvd2RBZ2VudEIN6uAYCREAAAAAAACwQBI2Cgd0aHJlYXRzGAkgAygLMhYuam9zdGxlLnYxLkNyb3dkVGhyZWF0Qg3q4BgJEQAAAAAAADBAIpoFCgpDcm93ZFJ1bGVzEhEKBHNlZWQYASABKA1IAIgBARIVCgh2ZXJ0aWNhbBgCIAEoCEgBiAEBEi4KCW5laWdoYm9ycxgDIAEoDUIW6uAYEgkAAAAAAADwPxEAAAAAAAAwQEgCiAEBEioKBXJlYWNoGAQgASgBQhbq4BgSCZqZmZmZmck/EQAAAAAAAElASAOIAQESLAoHaG9yaXpvbhgFIAEoAUIW6uAYEgmamZmZmZmpPxEAAAAAAAA0QEgEiAEBEjEKDHdhbGxfaG9yaXpvbhgGIAEoAUIW6uAYEgmamZmZmZmpPxEAAAAAAAA0QEgFiAEBEjQKD3NpZGVfcHJlZmVyZW5jZRgHIAEoAUIW6uAYEgkAAAAAAADgvxEAAAAAAADgP0gGiAEBEiEKBW5vaXNlGAggASgBQg3q4BgJEQAAAAAAAOA/SAeIAQESJgoKcGFuaWNfdGltZRgJIAEoAUIN6uAYCREAAAAAAECPQEgIiAEBEicKC3BhbmljX3NwZWVkGAogASgBQg3q4BgJEQAAAAAAAElASAmIAQESJQoJY29udGFnaW9uGAsgASgBQg3q4BgJEa5H4XoUru8/SAqIAQESLwoKYmxvd19zcGVlZBgMIAEoAUIW6uAYEgmamZmZmZm5PxEAAAAAAECPQEgLiAEBQgcKBV9zZWVkQgsKCV92ZXJ0aWNhbEIMCgpfbmVpZ2hib3JzQggKBl9yZWFjaEIKCghfaG9yaXpvbkIPCg1fd2FsbF9ob3Jpem9uQhIKEF9zaWRlX3ByZWZlcmVuY2VCCAoGX25vaXNlQg0KC19wYW5pY190aW1lQg4KDF9wYW5pY19zcGVlZEIMCgpfY29udGFnaW9uQg0KC19ibG93X3NwZWVkIroCCgtDcm93ZFJvdXRlcxJMCgZjZW50ZXIYASABKAsyDy5qb3N0bGUudjEuVmVjM0Im8uAYDHJvdXRlX2NlbnRlcurgGBIJAAAAAICELsERAAAAAICELkFIAIgBARI/CgRoYWxmGAIgASgLMg8uam9zdGxlLnYxLlZlYzNCG/LgGApyb3V0ZV9oYWxm6uAYCREAAAAAAIjDQEgBiAEBEjcKBGNlbGwYAyABKAFCJPLgGApyb3V0ZV9jZWxs6uAYEgmamZmZmZmpPxEAAAAAAABZQEgCiAEBEjgKCWNsZWFyYW5jZRgEIAEoAUIg8uAYD3JvdXRlX2NsZWFyYW5jZergGAkRAAAAAAAAJEBIA4gBAUIJCgdfY2VudGVyQgcKBV9oYWxmQgcKBV9jZWxsQgwKCl9jbGVhcmFuY2UiqQEKCUNyb3dkV2FsbBJHCgRmcm9tGAEgASgLMg8uam9zdGxlLnYxLlZlYzNCI/LgGAl3YWxsX2Zyb23q4BgSCQAAAACAhC7BEQAAAACAhC5BSACIAQESQwoCdG8YAiABKAsyDy5qb3N0bGUudjEuVmVjM0Ih8uAYB3dhbGxfdG/q4BgSCQAAAACAhC7BEQAAAACAhC5BSAGIAQFCBwoFX2Zyb21CBQoDX3RvIjAKDUNyb3dkT2JzdGFjbGUSHwoEYm9keRgBIAEoCUIR8uAYDW9ic3RhY2xlX2JvZHki4wIKCUNyb3dkR29hbBIxCgZudW1iZXIYASABKA1CHPLgGAtnb2FsX251bWJlcurgGAkRAAAAAAAALkBIAIgBARJLCgZjZW50ZXIYAiABKAsyDy5qb3N0bGUudjEuVmVjM0Il8uAYC2dvYWxfY2VudGVy6uAYEgkAAAAAgIQuwREAAAAAgIQuQUgBiAEBEj4KBGhhbGYYAyABKAsyDy5qb3N0bGUudjEuVmVjM0Ia8uAYCWdvYWxfaGFsZurgGAkRAAAAAACIw0BIAogBARI3CgNlbmQYBCABKA4yFy5qb3N0bGUudjEuQ3Jvd2RHb2FsRW5kQgzy4BgIZ29hbF9lbmRIA4gBARItCgRuZXh0GAUgASgNQhry4BgJZ29hbF9uZXh06uAYCREAAAAAAAAuQEgEiAEBQgkKB19udW1iZXJCCQoHX2NlbnRlckIHCgVfaGFsZkIGCgRfZW5kQgcKBV9uZXh0IooFCgpDcm93ZEZsb2NrEjkKBXJlYWNoGAEgASgBQiXy4BgLZmxvY2tfcmVhY2jq4BgSCZqZmZmZmbk/EQAAAAAAAFlASACIAQESOgoKc2VwYXJhdGlvbhgCIAEoAUIh8uAYEGZsb2NrX3NlcGFyYXRpb27q4BgJEQAAAAAAAFlASAGIAQESSAoRc2VwYXJhdGlvbl93ZWlnaHQYAyABKAFCKPLgGBdmbG9ja19zZXBhcmF0aW9uX3dlaWdodOrgGAkRAAAAAABAj0BIAogBARJGChBhbGlnbm1lbnRfd2VpZ2h0GAQgASgBQify4BgWZmxvY2tfYWxpZ25tZW50X3dlaWdodOrgGAkRAAAAAAAAWUBIA4gBARJECg9jb2hlc2lvbl93ZWlnaHQYBSABKAFCJvLgGBVmbG9ja19jb2hlc2lvbl93ZWlnaHTq4BgJEQAAAAAAAFlASASIAQESOgoKYWltX3dlaWdodBgGIAEoAUIh8uAYEGZsb2NrX2FpbV93ZWlnaHTq4BgJEQAAAAAAAFlASAWIAQESLgoEcm9hbRgHIAEoAUIb8uAYCmZsb2NrX3JvYW3q4BgJEQAAAAAAavhASAaIAQESSAoEaG9tZRgIIAEoCzIPLmpvc3RsZS52MS5WZWMzQiTy4BgKZmxvY2tfaG9tZergGBIJAAAAAICELsERAAAAAICELkFIB4gBAUIICgZfcmVhY2hCDQoLX3NlcGFyYXRpb25CFAoSX3NlcGFyYXRpb25fd2VpZ2h0QhMKEV9hbGlnbm1lbnRfd2VpZ2h0QhIKEF9jb2hlc2lvbl93ZWlnaHRCDQoLX2FpbV93ZWlnaHRCBwoFX3JvYW1CBwoFX2hvbWUitAoKCkNyb3dkR3JvdXASMAoFY291bnQYASABKA1CHPLgGAtncm91cF9jb3VudOrgGAkRAAAAAAAA0EBIAIgBARIhCgRzZWVkGAIgASgNQg7y4BgKZ3JvdXBfc2VlZEgBiAEBEkwKBmNlbnRlchgDIAEoCzIPLmpvc3RsZS52MS5WZWMzQiby4BgMZ3JvdXBfY2VudGVy6uAYEgkAAAAAgIQuwREAAAAAgIQuQUgCiAEBEj8KBGhhbGYYBCABKAsyDy5qb3N0bGUudjEuVmVjM0Ib8uAYCmdyb3VwX2hhbGbq4BgJEQAAAAAAiMNASAOIAQESPQoGYm9kaWVzGAUgASgOMhYuam9zdGxlLnYxLkNyb3dkQm9kaWVzQhDy4BgMZ3JvdXBfYm9kaWVzSASIAQESOwoGaGVpZ2h0GAYgASgBQiby4BgMZ3JvdXBfaGVpZ2h06uAYEgmamZmZmZm5PxEAAAAAAAA0QEgFiAEBEjcKBG1hc3MYByABKAFCJPLgGApncm91cF9tYXNz6uAYEgn8qfHSTWJQPxEAAAAAAGr4QEgGiAEBEjcKBGtpbmQYCCABKA4yFC5qb3N0bGUudjEuQ3Jvd2RLaW5kQg7y4BgKZ3JvdXBfa2luZEgHiAEBEjsKBnJhZGl1cxgJIAEoAUIm8uAYDGdyb3VwX3JhZGl1c+rgGBIJmpmZmZmZqT8RAAAAAAAAFEBICIgBARIwCgVzcGVlZBgKIAEoAUIc8uAYC2dyb3VwX3NwZWVk6uAYCREAAAAAAABJQEgJiAEBEjgKCW1heF9zcGVlZBgLIAEoAUIg8uAYD2dyb3VwX21heF9zcGVlZOrgGAkRAAAAAAAAWUBICogBARJHCgxhY2NlbGVyYXRpb24YDCABKAFCLPLgGBJncm91cF9hY2NlbGVyYXRpb27q4BgSCZqZmZmZmbk/EQAAAAAAiMNASAuIAQESNwoPc2xvd3NfaW5fY3Jvd2RzGA0gASgIQhny4BgVZ3JvdXBfc2xvd3NfaW5fY3Jvd2RzSAyIAQESMAoFZmxvY2sYDiABKA1CHPLgGAtncm91cF9mbG9ja+rgGAkRAAAAAACAT0BIDYgBARIuCgRnb2FsGA8gASgNQhvy4BgKZ3JvdXBfZ29hbOrgGAkRAAAAAAAALkBIDogBARJMCgZ0YXJnZXQYECABKAsyDy5qb3N0bGUudjEuVmVjM0Im8uAYDGdyb3VwX3RhcmdldOrgGBIJAAAAAICELsERAAAAAICELkFID4gBARJQCgh2ZWxvY2l0eRgRIAEoCzIPLmpvc3RsZS52MS5WZWMzQijy4BgOZ3JvdXBfdmVsb2NpdHnq4BgSCQAAAAAAAFnAEQAAAAAAAFlASBCIAQESIAoGZm9sbG93GBIgASgJQhDy4BgMZ3JvdXBfZm9sbG93EjYKCGRpc3RhbmNlGBMgASgBQh/y4BgOZ3JvdXBfZGlzdGFuY2Xq4BgJEQAAAAAAQI9ASBGIAQFCCAoGX2NvdW50QgcKBV9zZWVkQgkKB19jZW50ZXJCBwoFX2hhbGZCCQoHX2JvZGllc0IJCgdfaGVpZ2h0QgcKBV9tYXNzQgcKBV9raW5kQgkKB19yYWRpdXNCCAoGX3NwZWVkQgwKCl9tYXhfc3BlZWRCDwoNX2FjY2VsZXJhdGlvbkISChBfc2xvd3NfaW5fY3Jvd2RzQggKBl9mbG9ja0IHCgVfZ29hbEIJCgdfdGFyZ2V0QgsKCV92ZWxvY2l0eUILCglfZGlzdGFuY2Ui8wYKCkNyb3dkQWdlbnQSHAoEYm9keRgBIAEoCUIO8uAYCmFnZW50X2JvZHkSNwoEa2luZBgCIAEoDjIULmpvc3RsZS52MS5Dcm93ZEtpbmRCDvLgGAphZ2VudF9raW5kSACIAQESOwoGcmFkaXVzGAMgASgBQiby4BgMYWdlbnRfcmFkaXVz6uAYEgmamZmZmZmpPxEAAAAAAAAUQEgBiAEBEjAKBXNwZWVkGAQgASgBQhzy4BgLYWdlbnRfc3BlZWTq4BgJEQAAAAAAAElASAKIAQESOAoJbWF4X3NwZWVkGAUgASgBQiDy4BgPYWdlbnRfbWF4X3NwZWVk6uAYCREAAAAAAABZQEgDiAEBEkcKDGFjY2VsZXJhdGlvbhgGIAEoAUIs8uAYEmFnZW50X2FjY2VsZXJhdGlvburgGBIJmpmZmZmZuT8RAAAAAACIw0BIBIgBARI3Cg9zbG93c19pbl9jcm93ZHMYByABKAhCGfLgGBVhZ2VudF9zbG93c19pbl9jcm93ZHNIBYgBARIwCgVmbG9jaxgIIAEoDUIc8uAYC2FnZW50X2Zsb2Nr6uAYCREAAAAAAIBPQEgGiAEBEi4KBGdvYWwYCSABKA1CG/LgGAphZ2VudF9nb2Fs6uAYCREAAAAAAAAuQEgHiAEBEkwKBnRhcmdldBgKIAEoCzIPLmpvc3RsZS52MS5WZWMzQiby4BgMYWdlbnRfdGFyZ2V06uAYEgkAAAAAgIQuwREAAAAAgIQuQUgIiAEBElAKCHZlbG9jaXR5GAsgASgLMg8uam9zdGxlLnYxLlZlYzNCKPLgGA5hZ2VudF92ZWxvY2l0eergGBIJAAAAAAAAWcARAAAAAAAAWUBICYgBARIgCgZmb2xsb3cYDCABKAlCEPLgGAxhZ2VudF9mb2xsb3cSNgoIZGlzdGFuY2UYDSABKAFCH/LgGA5hZ2VudF9kaXN0YW5jZergGAkRAAAAAABAj0BICogBAUIHCgVfa2luZEIJCgdfcmFkaXVzQggKBl9zcGVlZEIMCgpfbWF4X3NwZWVkQg8KDV9hY2NlbGVyYXRpb25CEgoQX3Nsb3dzX2luX2Nyb3dkc0IICgZfZmxvY2tCBwoFX2dvYWxCCQoHX3RhcmdldEILCglfdmVsb2NpdHlCCwoJX2Rpc3RhbmNlInUKC0Nyb3dkVGhyZWF0Eh0KBGJvZHkYASABKAlCD/LgGAt0aHJlYXRfYm9keRI8CgZyYWRpdXMYAiABKAFCJ/LgGA10aHJlYXRfcmFkaXVz6uAYEgmamZmZmZm5PxEAAAAAAECPQEgAiAEBQgkKB19yYWRpdXMqeAoLVmVoaWNsZU1ha2USHAoYVkVISUNMRV9NQUtFX1VOU1BFQ0lGSUVEEAASFwoTVkVISUNMRV9NQUtFX1NBTE9PThABEhUKEVZFSElDTEVfTUFLRV9UQU5LEAISGwoXVkVISUNMRV9NQUtFX01PVE9SQ1lDTEUQAyqAAQoJV2hlZWxDYXN0EhoKFldIRUVMX0NBU1RfVU5TUEVDSUZJRUQQABISCg5XSEVFTF9DQVNUX1JBWRABEhUKEVdIRUVMX0NBU1RfU1BIRVJFEAISFwoTV0hFRUxfQ0FTVF9DWUxJTkRFUhADEhMKD1dIRUVMX0NBU1RfQk9EWRAEKv0BChJQYXJ0aWNsZUludGVncmF0b3ISIwofUEFSVElDTEVfSU5URUdSQVRPUl9VTlNQRUNJRklFRBAAEiYKIlBBUlRJQ0xFX0lOVEVHUkFUT1JfRVhQTElDSVRfRVVMRVIQARIrCidQQVJUSUNMRV9JTlRFR1JBVE9SX1NFTUlfSU1QTElDSVRfRVVMRVIQAhImCiJQQVJUSUNMRV9JTlRFR1JBVE9SX0lNUExJQ0lUX0VVTEVSEAMSHgoaUEFSVElDTEVfSU5URUdSQVRPUl9WRVJMRVQQBBIlCiFQQVJUSUNMRV9JTlRFR1JBVE9SX1JVTkdFX0tVVFRBXzQQBSqPAQoMRW1pdHRlclNoYXBlEh0KGUVNSVRURVJfU0hBUEVfVU5TUEVDSUZJRUQQABIXChNFTUlUVEVSX1NIQVBFX1BPSU5UEAESFgoSRU1JVFRFUl9TSEFQRV9ESVNDEAISFQoRRU1JVFRFUl9TSEFQRV9CT1gQAxIYChRFTUlUVEVSX1NIQVBFX1NQSEVSRRAEKnoKDENyb3dkR29hbEVuZBIeChpDUk9XRF9HT0FMX0VORF9VTlNQRUNJRklFRBAAEhcKE0NST1dEX0dPQUxfRU5EX1NUQVkQARIYChRDUk9XRF9HT0FMX0VORF9MRUFWRRACEhcKE0NST1dEX0dPQUxfRU5EX05FWFQQAypUCglDcm93ZEtpbmQSGgoWQ1JPV0RfS0lORF9VTlNQRUNJRklFRBAAEhUKEUNST1dEX0tJTkRfV0FMS0VSEAESFAoQQ1JPV0RfS0lORF9GTFlFUhACKngKC0Nyb3dkQm9kaWVzEhwKGENST1dEX0JPRElFU19VTlNQRUNJRklFRBAAEhoKFkNST1dEX0JPRElFU19LSU5FTUFUSUMQARIYChRDUk9XRF9CT0RJRVNfRFlOQU1JQxACEhUKEUNST1dEX0JPRElFU19OT05FEAM6TgoFcmFuZ2USHS5nb29nbGUucHJvdG9idWYuRmllbGRPcHRpb25zGI2MAyABKAsyFy5qb3N0bGUudjEuU2V0dGluZ1JhbmdlUgVyYW5nZTo5CgdzZXR0aW5nEh0uZ29vZ2xlLnByb3RvYnVmLkZpZWxkT3B0aW9ucxiOjAMgASgJUgdzZXR0aW5nYgZwcm90bzM`,[zn,Ls])]),zs=Rn(Rs,5),Bs=function(e){return e[e.UNSPECIFIED=0]=`UNSPECIFIED`,e[e.STATIC=1]=`STATIC`,e[e.FIXED=1]=`FIXED`,e[e.KINEMATIC=2]=`KINEMATIC`,e[e.DYNAMIC=3]=`DYNAMIC`,e}({}),Vs=function(e){return e[e.UNSPECIFIED=0]=`UNSPECIFIED`,e[e.AVERAGE=1]=`AVERAGE`,e[e.GEOMETRIC_MEAN=2]=`GEOMETRIC_MEAN`,e[e.MINIMUM=3]=`MINIMUM`,e[e.MULTIPLY=4]=`MULTIPLY`,e[e.MAXIMUM=5]=`MAXIMUM`,e}({}),Hs=256*2**20,Us=class{shapes=new Map;partial;clear(){this.shapes.clear(),this.partial=void 0}add({id:e,chunk:t,chunkCount:n,data:r}){t===0&&(this.partial={id:e,bytes:0,chunks:[]});let i=this.partial;if(this.partial=void 0,!i||i.id!==e||i.chunks.length!==t||t>=n||(i.bytes+=r.length,i.bytes>Hs))return!1;if(i.chunks.push(r),t+1<n)return this.partial=i,!0;try{this.shapes.set(e,lr(zs,Ws(i.chunks,i.bytes)).kind)}catch{return!1}return!0}resolve(e){for(let t of e.shapes)t.kind.case===`geometry`&&(t.kind=this.shapes.get(t.kind.value)??{case:void 0})}};function Ws(e,t){let n=new Uint8Array(t),r=0;for(let t of e)n.set(t,r),r+=t.length;return n}var Gs=256,Ks=2e5,qs=5e5,Js=3e5,Ys=6e4,Xs=.25,Zs=1.7,Qs=.95,$s=1/60,ec=1/240,tc=.08,nc=5e5,rc=1e6;function ic(e,t){return e.sort()[Math.floor(t*(e.length-1))]}var ac=class e{lateness=new Float64Array(Gs);intervals=new Float64Array(Gs);arrivals=0;targetDelayUs=Ys;framesUntilUpdate=0;newestUs=0;newestArrivalUs=0;minLatenessUs=0;gapEnded=!1;started=!1;updatedUs=0;delayUs=Ys;renderTimeUs=0;speed=1;onFrame(e,t,n=!1){let r=this.arrivals===0;if(!r&&e<=this.newestUs)return;let i=r?0:e-this.newestUs,a=r?0:t-this.newestArrivalUs;this.gapEnded=a>qs&&!n||this.gapEnded&&a<Xs*i;let o=!r&&!n&&i<Ks&&!this.gapEnded,s=this.arrivals++%Gs;this.lateness[s]=t-e,this.intervals[s]=o?i:0,this.newestUs=e,this.newestArrivalUs=t,this.adapt()}advance(e){if(this.arrivals===0)return 0;let t=e-this.minLatenessUs-this.delayUs;if(this.started||(this.started=!0,this.updatedUs=e,this.renderTimeUs=t),e<=this.updatedUs)return this.renderTimeUs;let n=e-this.updatedUs;this.updatedUs=e;let r=t-(this.renderTimeUs+n);if(r>rc)return this.speed=1,this.renderTimeUs=t;let i=tc*n,a=Math.min(i,Math.max(-i,r*Math.min(1,n/nc)));return this.speed=1+a/n,this.renderTimeUs+=n+a}reset(){Object.assign(this,new e)}adapt(){let e=Math.min(this.arrivals,Gs);this.minLatenessUs=this.lateness[0];for(let t=1;t<e;t++)this.minLatenessUs=Math.min(this.minLatenessUs,this.lateness[t]);this.framesUntilUpdate--===0&&(this.framesUntilUpdate=7,this.updateTargetDelay(e)),this.delayUs+=(this.targetDelayUs>this.delayUs?$s:ec)*(this.targetDelayUs-this.delayUs)}updateTargetDelay(e){let t=new Float64Array(e),n=new Float64Array(e),r=0;for(let i=0;i<e;i++)this.intervals[i]!==0&&(t[r]=this.intervals[i],n[r++]=this.lateness[i]-this.minLatenessUs);if(r===0)return;let i=ic(t.subarray(0,r),.5),a=ic(n.subarray(0,r),Qs);this.targetDelayUs=Math.min(Js,Math.max(Zs*i,i+a))}},oc=5e4;function sc(e,t,n){if(!e)return;let r=Math.min(t-e.serverUs,oc);if(t===0||r<-1e6||!(n>0))return{tick:e.frame,fraction:0};let i=Math.max(1,e.frame+r*n/1e6);return{tick:Math.floor(i),fraction:i-Math.floor(i)}}var cc=16384,lc=new Uint32Array;function uc(e){let t=0;for(let n=e;n!==0;n&=n-1)t++;return t}function dc(e,t,n,r){if(t>cc||r.length!==4*n.reduce((e,t)=>e+uc(t),0))return;let i=new Uint32Array(t);i.set(e.subarray(0,t));let a=new DataView(r.buffer,r.byteOffset,r.length),o=0;for(let e=0;e<8*n.length;e++)if(n[e>>3]>>(e&7)&1){if(e>=t)return;i[e]=a.getUint32(o,!0),o+=4}return i}var fc=class{newest;apply({entity:e,tick:t,module:n,words:r,keyframe:i,changedMask:a,values:o}){let s=i?lc:this.newest?.entity===e?this.newest.words:void 0,c=s&&dc(s,r,a,o);this.newest=c&&{entity:e,tick:t,module:n,words:c}}reset(){this.newest=void 0}},pc=wr(`ChRqb3N0bGUvdjEvcGxheS5wcm90bxIJam9zdGxlLnYxIvEBCg1DbGllbnRNZXNzYWdlEiEKBWhlbGxvGAEgASgLMhAuam9zdGxlLnYxLkhlbGxvSAASJgoFaW5wdXQYAiABKAsyFS5qb3N0bGUudjEuSW5wdXRCYXRjaEgAEh0KA2FjaxgDIAEoCzIOLmpvc3RsZS52MS5BY2tIABIfCgRwaW5nGAQgASgLMg8uam9zdGxlLnYxLlBpbmdIABIhCgVsZWF2ZRgFIAEoCzIQLmpvc3RsZS52MS5MZWF2ZUgAEicKCGludGVyZXN0GAYgASgLMhMuam9zdGxlLnYxLkludGVyZXN0SABCCQoHbWVzc2FnZSKwAgoFSGVsbG8SEAoIcHJvdG9jb2wYASABKA0SDQoFd29ybGQYAiABKAkSDgoGdGlja2V0GAMgASgJEgwKBG5hbWUYBCABKAkSEwoLc25hcHNob3RfaHoYBSABKA0SEQoJc3BlY3RhdG9yGAYgASgIEg4KBmV2ZW50cxgHIAEoCBINCgV0b2tlbhgIIAEoCRIQCghjaGFubmVscxgJIAMoCRINCgVjb2RlYxgKIAEoDRIQCghtYXhfa2JwcxgLIAEoDRIlCghpbnRlcmVzdBgOIAEoCzITLmpvc3RsZS52MS5JbnRlcmVzdBIRCglkYXRhZ3JhbXMYFCABKAgSEQoJcmVzdW1hYmxlGDwgASgIEiEKBnJlc3VtZRg9IAEoCzIRLmpvc3RsZS52MS5SZXN1bWUiJgoGUmVzdW1lEg0KBXRva2VuGAEgASgMEg0KBWZyYW1lGAIgASgNIjoKCEludGVyZXN0Eh4KBWZvY3VzGAEgASgLMg8uam9zdGxlLnYxLlZlYzMSDgoGcmFkaXVzGAIgASgBInsKCklucHV0QmF0Y2gSFgoOZmlyc3Rfc2VxdWVuY2UYASABKA0SIAoGaW5wdXRzGAIgAygLMhAuam9zdGxlLnYxLklucHV0EhsKA2FjaxgDIAEoCzIOLmpvc3RsZS52MS5BY2sSFgoOY2xpZW50X3RpbWVfdXMYBCABKAcilwMKBUlucHV0EiYKBXNwYXduGAEgASgLMhUuam9zdGxlLnYxLlNwYXduSW5wdXRIABIqCgdpbXB1bHNlGAIgASgLMhcuam9zdGxlLnYxLkltcHVsc2VJbnB1dEgAEiQKBGdyYWIYAyABKAsyFC5qb3N0bGUudjEuR3JhYklucHV0SAASJAoEZHJhZxgEIAEoCzIULmpvc3RsZS52MS5EcmFnSW5wdXRIABIqCgdyZWxlYXNlGAUgASgLMhcuam9zdGxlLnYxLlJlbGVhc2VJbnB1dEgAEigKBmRlbGV0ZRgGIAEoCzIWLmpvc3RsZS52MS5EZWxldGVJbnB1dEgAEioKB2V4cGxvZGUYByABKAsyFy5qb3N0bGUudjEuRXhwbG9kZUlucHV0SAASKgoHcG9zc2VzcxgIIAEoCzIXLmpvc3RsZS52MS5Qb3NzZXNzSW5wdXRIABIqCgdjb250cm9sGAkgASgLMhcuam9zdGxlLnYxLkNvbnRyb2xJbnB1dEgAEgwKBHRpY2sYDyABKA1CBgoEa2luZCLmAQoKU3Bhd25JbnB1dBIfCgVzaGFwZRgBIAEoCzIQLmpvc3RsZS52MS5TaGFwZRIhCghwb3NpdGlvbhgCIAEoCzIPLmpvc3RsZS52MS5WZWMzEiEKCHJvdGF0aW9uGAMgASgLMg8uam9zdGxlLnYxLlF1YXQSKAoPbGluZWFyX3ZlbG9jaXR5GAQgASgLMg8uam9zdGxlLnYxLlZlYzMSKQoQYW5ndWxhcl92ZWxvY2l0eRgFIAEoCzIPLmpvc3RsZS52MS5WZWMzEhIKBWNvbG9yGAYgASgHSACIAQFCCAoGX2NvbG9yIn8KA0FpbRIfCgZvcmlnaW4YASABKAsyDy5qb3N0bGUudjEuVmVjMxIfCgZtb3Rpb24YAiABKAsyDy5qb3N0bGUudjEuVmVjMxIOCgZpZ25vcmUYAyABKA0SJgoJdmlld190aW1lGAQgASgLMhMuam9zdGxlLnYxLlZpZXdUaW1lIn0KDEltcHVsc2VJbnB1dBIOCgZlbnRpdHkYASABKA0SIAoHaW1wdWxzZRgCIAEoCzIPLmpvc3RsZS52MS5WZWMzEh4KBXBvaW50GAMgASgLMg8uam9zdGxlLnYxLlZlYzMSGwoDYWltGAQgASgLMg4uam9zdGxlLnYxLkFpbSJYCglHcmFiSW5wdXQSDgoGZW50aXR5GAEgASgNEh4KBXBvaW50GAIgASgLMg8uam9zdGxlLnYxLlZlYzMSGwoDYWltGAMgASgLMg4uam9zdGxlLnYxLkFpbSIsCglEcmFnSW5wdXQSHwoGdGFyZ2V0GAEgASgLMg8uam9zdGxlLnYxLlZlYzMiDgoMUmVsZWFzZUlucHV0Ih0KC0RlbGV0ZUlucHV0Eg4KBmVudGl0eRgBIAEoDSJrCgxFeHBsb2RlSW5wdXQSHwoGY2VudGVyGAEgASgLMg8uam9zdGxlLnYxLlZlYzMSDgoGcmFkaXVzGAIgASgBEg0KBXNwZWVkGAMgASgBEhsKA2FpbRgEIAEoCzIOLmpvc3RsZS52MS5BaW0iHgoMUG9zc2Vzc0lucHV0Eg4KBmVudGl0eRgBIAEoDSItCgxDb250cm9sSW5wdXQSDAoEYXhlcxgBIAMoERIPCgdidXR0b25zGAIgASgNIlMKA0FjaxINCgVmcmFtZRgBIAEoDRIVCg1uZWVkX2tleWZyYW1lGAIgASgIEhQKDGFja19kZWxheV9tcxgDIAEoDRIQCghhY2tfYml0cxgIIAEoByIeCgRQaW5nEhYKDmNsaWVudF90aW1lX3VzGAEgASgGIgcKBUxlYXZlIsACCg1TZXJ2ZXJNZXNzYWdlEiUKB3dlbGNvbWUYASABKAsyEi5qb3N0bGUudjEuV2VsY29tZUgAEjAKDWVudGl0eV91cGRhdGUYAiABKAsyFy5qb3N0bGUudjEuRW50aXR5VXBkYXRlSAASJwoIc25hcHNob3QYAyABKAsyEy5qb3N0bGUudjEuU25hcHNob3RIABIfCgRwb25nGAUgASgLMg8uam9zdGxlLnYxLlBvbmdIABIjCgZub3RpY2UYByABKAsyES5qb3N0bGUudjEuTm90aWNlSAASLAoIZ2VvbWV0cnkYCSABKAsyGC5qb3N0bGUudjEuR2VvbWV0cnlDaHVua0gAQgkKB21lc3NhZ2VKBAgEEAVKBAgGEAdKBAgIEAlSDWlucHV0X3Jlc3VsdHNSBXN0YXRzUgZldmVudHMiWgoKQ2VsbFVwZGF0ZRIMCgRjZWxsGAEgASgNEg4KBm51bWJlchgCIAEoDRIRCgliYXNlbGluZXMYAyABKA0SDgoGcGFja2VkGAQgASgMEgsKA2NyYxgFIAEoByKWBAoHV2VsY29tZRIRCgljbGllbnRfaWQYASABKA0SEAoId29ybGRfaWQYAiABKAkSEgoKd29ybGRfbmFtZRgDIAEoCRIMCgR0aWNrGAQgASgNEg8KB3RpY2tfaHoYBSABKAESEwoLc25hcHNob3RfaHoYBiABKA0SIwoFcXVhbnQYCCABKAsyFC5qb3N0bGUudjEuUXVhbnRTcGVjEhYKDnNlcnZlcl90aW1lX3VzGAkgASgGEiAKB2dyYXZpdHkYCiABKAsyDy5qb3N0bGUudjEuVmVjMxIoCghjaGFubmVscxgLIAMoCzIWLmpvc3RsZS52MS5DaGFubmVsS2luZBINCgVjb2RlYxgMIAEoDRIXCg9hY2tfaW50ZXJ2YWxfbXMYDSABKA0SEAoIZXBvY2hfdXMYDiABKAYSDQoFY2VsbHMYDyABKAgSEAoIc3Vic3RlcHMYECABKA0SMQoJZGF0YWdyYW1zGBQgASgLMh4uam9zdGxlLnYxLkRhdGFncmFtQ3JlZGVudGlhbHMSFAoMcmVzdW1lX3Rva2VuGDwgASgMEg8KB3Jlc3VtZWQYPSABKAgSFwoPc3RhdGVfcHJlc2VydmVkGD4gASgIEhUKDWxhc3Rfc2VxdWVuY2UYPyABKA0SHgoWcmVzdW1lX3RpbWVvdXRfc2Vjb25kcxhAIAEoAUoECAcQCFIKYWNrX3dpbmRvdyI8ChNEYXRhZ3JhbUNyZWRlbnRpYWxzEgwKBHBvcnQYASABKA0SCgoCaWQYAiABKAYSCwoDa2V5GAMgASgMIlIKC0NoYW5uZWxLaW5kEgwKBG5hbWUYASABKAkSJAoEZm9ybRgCIAEoDjIWLmpvc3RsZS52MS5DaGFubmVsRm9ybRIPCgdkaXZpc29yGAMgASgNIkAKCVF1YW50U3BlYxIXCg91bml0c19wZXJfbWV0ZXIYASABKA0SGgoScm90YXRpb25fY29tcG9uZW50GAIgASgNIk0KDUdlb21ldHJ5Q2h1bmsSCgoCaWQYASABKAYSDQoFY2h1bmsYAiABKA0SEwoLY2h1bmtfY291bnQYAyABKA0SDAoEZGF0YRgEIAEoDCJBCgxFbnRpdHlVcGRhdGUSIAoFYWRkZWQYASADKAsyES5qb3N0bGUudjEuRW50aXR5Eg8KB3JlbW92ZWQYAiADKA0iyQIKBkVudGl0eRIKCgJpZBgBIAEoDRIhCgR0eXBlGAIgASgOMhMuam9zdGxlLnYxLkJvZHlUeXBlEiAKBnNoYXBlcxgDIAMoCzIQLmpvc3RsZS52MS5TaGFwZRINCgVvd25lchgEIAEoDRISCgVjb2xvchgFIAEoB0gAiAEBEgwKBG5hbWUYBiABKAkSDAoEbWFzcxgHIAEoARIUCgxjb250cm9sbGFibGUYCCABKAgSFgoObGluZWFyX2RhbXBpbmcYCSABKAESFwoPYW5ndWxhcl9kYW1waW5nGAogASgBEhoKDWdyYXZpdHlfc2NhbGUYCyABKAFIAYgBARIfCgVsb2NrcxgMIAEoCzIQLmpvc3RsZS52MS5Mb2NrcxIPCgdqb2ludGVkGA0gASgIQggKBl9jb2xvckIQCg5fZ3Jhdml0eV9zY2FsZSLcAwoIU25hcHNob3QSDQoFZnJhbWUYASABKA0SEQoJYmFzZWxpbmVzGAIgASgNEg4KBnBhY2tlZBgFIAEoDBILCgNjcmMYBiABKAcSDwoHbGF0ZV91cxgHIAEoEhIQCghjaGFubmVscxgJIAEoDBIUCgxjaGFubmVsc19jcmMYCiABKAcSFwoPdW5jaGFuZ2VkX3RpY2tzGAsgASgNEiQKBXN0YXRzGAwgASgLMhUuam9zdGxlLnYxLldvcmxkU3RhdHMSIQoGZXZlbnRzGA0gAygLMhEuam9zdGxlLnYxLkV2ZW50cxIuCg1jbGllbnRfdXBkYXRlGA8gASgLMhcuam9zdGxlLnYxLkNsaWVudFVwZGF0ZRIkCgVjZWxscxgQIAMoCzIVLmpvc3RsZS52MS5DZWxsVXBkYXRlEhIKCmNlbGxzX2xlZnQYESADKA0SOwoRY29udHJvbGxlZF9lbnRpdHkYEiABKAsyIC5qb3N0bGUudjEuQ29udHJvbGxlZEVudGl0eVN0YXRlSgQIAxAESgQIBBAFSgQICBAJUgpiYXNlX2ZyYW1lUgtiYXNlMl9mcmFtZVILYmFzZTNfZnJhbWVSDnNlcnZlcl90aW1lX3VzUgdtb2R1bGVzIrgBCgxDbGllbnRVcGRhdGUSFgoOaW5wdXRfc2VxdWVuY2UYASABKA0SGwoTZWNob19jbGllbnRfdGltZV91cxgCIAEoBxIZChFzbmFwc2hvdHNfc2tpcHBlZBgDIAEoDRInCgdyZXN1bHRzGAQgAygLMhYuam9zdGxlLnYxLklucHV0UmVzdWx0EhcKD2lucHV0X21hcmdpbl91cxgHIAEoERIWCg5pbnB1dF9yZWNlaXZlZBgMIAEoDSKMAQoVQ29udHJvbGxlZEVudGl0eVN0YXRlEg4KBmVudGl0eRgBIAEoDRIOCgZtb2R1bGUYAiABKAkSDAoEdGljaxgDIAEoDRINCgV3b3JkcxgEIAEoDRIQCghrZXlmcmFtZRgFIAEoCBIUCgxjaGFuZ2VkX21hc2sYBiABKAwSDgoGdmFsdWVzGAcgASgMIqUBCgtJbnB1dFJlc3VsdBIQCghzZXF1ZW5jZRgBIAEoDRIiCgRjb2RlGAIgASgOMhQuam9zdGxlLnYxLklucHV0Q29kZRIMCgR0aWNrGAMgASgNEg4KBmVudGl0eRgEIAEoDRIPCgdtZXNzYWdlGAUgASgJEhkKEXZpZXdfdGltZV9jbGFtcGVkGAYgASgIEhYKDnJldHJ5X2FmdGVyX21zGAcgASgNIjYKBFBvbmcSFgoOY2xpZW50X3RpbWVfdXMYASABKAYSFgoOc2VydmVyX3RpbWVfdXMYAiABKAYivwEKCldvcmxkU3RhdHMSDAoEdGljaxgBIAEoDRIOCgZib2RpZXMYAiABKA0SDQoFYXdha2UYAyABKA0SEAoIY29udGFjdHMYBCABKA0SDwoHY2xpZW50cxgFIAEoDRIUCgxzdGVwX21zX21lYW4YBiABKAESEwoLc3RlcF9tc19tYXgYByABKAESEgoKbGF0ZV90aWNrcxgIIAEoDRIOCgZwYXVzZWQYCSABKAkSEgoKdGltZV9zY2FsZRgKIAEoASI+CgZOb3RpY2USIwoEY29kZRgBIAEoDjIVLmpvc3RsZS52MS5Ob3RpY2VDb2RlEg8KB21lc3NhZ2UYAiABKAkixAMKBkV2ZW50cxIMCgR0aWNrGAEgASgNEi8KDmNvbnRhY3RzX2JlZ2FuGAIgAygLMhcuam9zdGxlLnYxLkNvbnRhY3RFdmVudBIvCg5jb250YWN0c19lbmRlZBgDIAMoCzIXLmpvc3RsZS52MS5Db250YWN0RXZlbnQSKQoIY29udGFjdHMYBCADKAsyFy5qb3N0bGUudjEuQ29udGFjdEV2ZW50EiUKBGhpdHMYBSADKAsyFy5qb3N0bGUudjEuQ29udGFjdEV2ZW50EjEKEHRyaWdnZXJzX2VudGVyZWQYBiADKAsyFy5qb3N0bGUudjEuVHJpZ2dlckV2ZW50EjAKD3RyaWdnZXJzX3N0YXllZBgHIAMoCzIXLmpvc3RsZS52MS5UcmlnZ2VyRXZlbnQSLgoNdHJpZ2dlcnNfbGVmdBgIIAMoCzIXLmpvc3RsZS52MS5UcmlnZ2VyRXZlbnQSMAoMam9pbnRzX2Jyb2tlGAkgAygLMhouam9zdGxlLnYxLkpvaW50QnJlYWtFdmVudBITCgtmZWxsX2FzbGVlcBgKIAMoDRIMCgR3b2tlGAsgAygNEg4KBm1pc3NlZBgMIAEoDSKTAQoMQ29udGFjdEV2ZW50EhAKCGVudGl0eV9hGAEgASgNEhAKCGVudGl0eV9iGAIgASgNEh4KBXBvaW50GAMgASgLMg8uam9zdGxlLnYxLlZlYzMSHwoGbm9ybWFsGAQgASgLMg8uam9zdGxlLnYxLlZlYzMSDQoFc3BlZWQYBSABKAESDwoHaW1wdWxzZRgGIAEoASIvCgxUcmlnZ2VyRXZlbnQSDwoHdHJpZ2dlchgBIAEoDRIOCgZlbnRpdHkYAiABKA0iVAoPSm9pbnRCcmVha0V2ZW50EhAKCGVudGl0eV9hGAEgASgNEhAKCGVudGl0eV9iGAIgASgNEg0KBWZvcmNlGAMgASgBEg4KBnRvcnF1ZRgEIAEoASqMAQoLQ2hhbm5lbEZvcm0SHAoYQ0hBTk5FTF9GT1JNX1VOU1BFQ0lGSUVEEAASFwoTQ0hBTk5FTF9GT1JNX1BBUkFNUxABEhcKE0NIQU5ORUxfRk9STV9QT0lOVFMQAhIWChJDSEFOTkVMX0ZPUk1fRklFTEQQAxIVChFDSEFOTkVMX0ZPUk1fU0VFRBAEKr8BCglJbnB1dENvZGUSGgoWSU5QVVRfQ09ERV9VTlNQRUNJRklFRBAAEhYKEklOUFVUX0NPREVfQVBQTElFRBABEhYKEklOUFVUX0NPREVfSU5WQUxJRBACEhgKFElOUFVUX0NPREVfTk9UX0ZPVU5EEAMSGgoWSU5QVVRfQ09ERV9OT1RfQUxMT1dFRBAEEhQKEElOUFVUX0NPREVfTElNSVQQBRIaChZJTlBVVF9DT0RFX1VOQVZBSUxBQkxFEAYqtwEKCk5vdGljZUNvZGUSGwoXTk9USUNFX0NPREVfVU5TUEVDSUZJRUQQABIYChROT1RJQ0VfQ09ERV9EUkFJTklORxABEhwKGE5PVElDRV9DT0RFX1dPUkxEX0NMT1NFRBACEhcKE05PVElDRV9DT0RFX1JFRlVTRUQQAxIaChZOT1RJQ0VfQ09ERV9SQVRFX0xJTUlUEAQSHwobTk9USUNFX0NPREVfV09STERfUkVTVEFSVEVEEAUyTQoLUGxheVNlcnZpY2USPgoEUGxheRIYLmpvc3RsZS52MS5DbGllbnRNZXNzYWdlGhguam9zdGxlLnYxLlNlcnZlck1lc3NhZ2UoATABYgZwcm90bzM`,[Ls,Rs]),mc=Rn(pc,0),hc=Rn(pc,3),gc=Rn(pc,16),_c=Rn(pc,19),vc=function(e){return e[e.UNSPECIFIED=0]=`UNSPECIFIED`,e[e.APPLIED=1]=`APPLIED`,e[e.INVALID=2]=`INVALID`,e[e.NOT_FOUND=3]=`NOT_FOUND`,e[e.NOT_ALLOWED=4]=`NOT_ALLOWED`,e[e.LIMIT=5]=`LIMIT`,e[e.UNAVAILABLE=6]=`UNAVAILABLE`,e}({}),yc=function(e){return e[e.UNSPECIFIED=0]=`UNSPECIFIED`,e[e.DRAINING=1]=`DRAINING`,e[e.WORLD_CLOSED=2]=`WORLD_CLOSED`,e[e.REFUSED=3]=`REFUSED`,e[e.RATE_LIMIT=4]=`RATE_LIMIT`,e[e.WORLD_RESTARTED=5]=`WORLD_RESTARTED`,e}({}),bc=1,xc=1e3/30,Sc=1e3,Cc=32,wc=[250,500,1e3,2e3,5e3],Tc=5e3,Ec=5e3,Dc=1008,Oc=e=>new WebSocket(e),kc=class{clock=new t;frames=new Es;renderClock=new ac;inputClock=new Ps;entities=new Map;welcome;bytesReceived=0;snapshots=0;decodeErrors=0;ageMs=0;world=``;state=`stopped`;resumed=0;largeShapes=new Us;controlledEntity=new fc;eventsEnabled=!1;socket;spec={unitsPerMeter:512,rotationComponent:511};codec=1;cells=new ls;focus={x:0,z:0};inputs=new Is;resumeToken=new Uint8Array;needKeyframe=!1;ackDue=!1;lastAck=0;decodedAt=0;lastPing=0;attempt=0;timer;retry;lastReceivedUs=0;playingSince=0;lastNotice;predictionListener;lastBatch=0;url;listener;openSocket;token;channelKinds;areaOfInterest;constructor(e){this.url=e.url,this.listener=e.listener,this.openSocket=e.openSocket??Oc,this.token=e.token??``,this.channelKinds=e.channelKinds??[],this.areaOfInterest=e.areaOfInterest}join(e){this.stop(),this.world=e,this.attempt=0,this.connect()}setEventsEnabled(e){this.eventsEnabled!==e&&(this.eventsEnabled=e,(this.state===`playing`||this.state===`connecting`)&&this.join(this.world))}stop(){this.state===`playing`&&this.sendMessage({case:`leave`,value:{}}),this.resumeToken=new Uint8Array,clearTimeout(this.retry),this.dropSocket(),this.setState(`stopped`,``)}retryNow(){this.state===`waiting`&&(clearTimeout(this.retry),this.connect())}enablePrediction(e){if(this.predictionListener=e,this.welcome){e.begin(this.welcome);for(let t of this.entities.values())e.entityAdded(t);e.controlledEntity(this.controlledEntity.newest)}}send(e){if(this.state!==`playing`)return;let t=n(),r=this.predictionListener&&this.inputClock.ready?this.inputClock.tick(t):0,i=this.withViewTime(r>0?{...e,tick:r}:e),a=this.inputs.last;i.kind?.case===`drag`&&a?.kind?.case===`drag`&&a.tick===i.tick?this.inputs.replaceLast(i):this.inputs.push(i),this.predictionListener?.input(this.inputs.newest,r,i),r>0&&t-this.lastBatch>=xc*1e3&&this.sendInputs(t)}renderedTime(){return sc(this.frames.newest,this.renderClock.renderTimeUs,this.welcome?.tickHz??0)}withViewTime(e){let{kind:t}=e;if(t?.case!==`impulse`&&t?.case!==`grab`&&t?.case!==`explode`)return e;let{aim:n}=t.value;if(!n||n.viewTime)return e;let r={...t.value,aim:{...n,viewTime:this.renderedTime()}};return{...e,kind:{case:t.case,value:r}}}setState(e,t){this.state=e,this.listener.state(e,t)}dropSocket(){clearInterval(this.timer),this.socket&&=(this.socket.onclose=this.socket.onmessage=this.socket.onopen=null,this.socket.close(),void 0)}connect(){this.setState(`connecting`,``),this.lastNotice=void 0,this.playingSince=0,this.lastReceivedUs=n();let e=this.openSocket(this.url);this.socket=e,e.binaryType=`arraybuffer`,e.onopen=()=>{let{world:e,token:t,eventsEnabled:n}=this,r={protocol:bc,world:e,name:`browser`,events:n,token:t,channels:[...this.channelKinds],codec:2,maxKbps:this.areaOfInterest?.maxKbps??0,...this.areaOfInterest?{interest:this.interest(this.areaOfInterest)}:{},resumable:!0,...this.resumeToken.length>0?{resume:{token:this.resumeToken,frame:this.frames.newest?.frame??0}}:{}};this.sendMessage({case:`hello`,value:r})},e.onmessage=e=>this.receive(new Uint8Array(e.data)),e.onclose=e=>this.closed(e.code,e.reason),this.timer=setInterval(()=>this.pump(),xc)}closed(e,t){let n=this.lastNotice,r=(n?.code===yc.DRAINING?t||n.message:n?.message||t)||(this.playingSince>0?`the connection was lost`:`the server does not respond`);n?.code===yc.WORLD_CLOSED||n?.code===yc.REFUSED&&e===Dc&&this.playingSince===0?(this.dropSocket(),this.setState(`stopped`,r)):this.reconnect(r)}startNewSession(e){this.resumeToken=new Uint8Array,this.reconnect(e)}reconnect(e){this.dropSocket(),this.playingSince>0&&n()-this.playingSince>Ec*1e3&&(this.attempt=0);let t=wc[Math.min(this.attempt++,wc.length-1)];this.setState(`waiting`,e),this.retry=setTimeout(()=>this.connect(),t)}sendMessage(e){this.socket?.send(Ar(mc,F(mc,{message:e})))}receive(e){this.bytesReceived+=e.length,this.lastReceivedUs=n();let t;try{t=lr(_c,e).message}catch{return this.startNewSession(`the server sent a malformed message`)}switch(t.case){case`welcome`:return this.onWelcome(t.value);case`geometry`:this.largeShapes.add(t.value)||this.startNewSession(`the server sent a malformed shape`);return;case`entityUpdate`:return this.onEntityList(t.value);case`snapshot`:return this.onSnapshot(t.value);case`pong`:return this.clock.add(Number(t.value.clientTimeUs),Number(t.value.serverTimeUs),n());case`notice`:return this.onNotice(t.value)}}onNotice(e){(e.code===yc.RATE_LIMIT||e.code===yc.DRAINING)&&this.listener.notice(e.message),e.code!==yc.RATE_LIMIT&&(this.lastNotice=e)}onWelcome(e){this.welcome=e;let{unitsPerMeter:t,rotationComponent:r}=e.quant??{unitsPerMeter:512,rotationComponent:511};if(this.spec={unitsPerMeter:t,rotationComponent:r},this.codec=e.codec||1,!Sa(this.spec)||this.codec>2)return this.dropSocket(),this.setState(`stopped`,`the server uses an unsupported snapshot codec or quantization`);this.resumeToken=new Uint8Array(e.resumeToken),e.resumed?this.inputs.resumeAfter(e.lastSequence):this.inputs.startNewSession(),this.resumed+=+!!e.resumed,e.statePreserved||(this.clearWorld(e),this.predictionListener?.begin(e)),this.needKeyframe=this.ackDue=!1,this.lastAck=this.decodedAt=0,this.lastPing=0,this.playingSince=n(),this.setState(`playing`,``),this.pump()}clearWorld(e){this.frames.clear(),this.cells.clear(),this.renderClock.reset(),this.inputClock.begin(e.tickHz),this.clock.reset(),this.entities.clear(),this.largeShapes.clear(),this.controlledEntity.reset()}onEntityList(e){for(let t of e.removed)this.entities.delete(t),this.predictionListener?.entityRemoved(t);for(let t of e.added)this.largeShapes.resolve(t),this.entities.set(t.id,t),this.predictionListener?.entityAdded(t);this.listener.entityList(this.entities)}onSnapshot(e){this.ackDue=!0;for(let t of e.clientUpdate?.results??[])this.predictionListener?.result(t);e.controlledEntity&&(this.controlledEntity.apply(e.controlledEntity),this.predictionListener?.controlledEntity(this.controlledEntity.newest)),this.decode(e);for(let t of e.clientUpdate?.results??[])this.inputs.onResult(t.sequence)&&t.code!==vc.APPLIED&&this.listener.inputRejected(t);e.stats&&this.listener.stats(e.stats);for(let t of e.events)this.listener.worldEvents(t);this.inputs.length===0&&this.sendAckIfDue()}decode(e){try{let t=Ma(e.frame,e.baselines),[r,i,a]=t.map(e=>{let t=this.frames.find(e);if(e!==0&&!t)throw new xa(`baseline frame ${e} is unknown`);return t}),o=this.welcome?.cells?this.decodeCells(e):this.decodeWholeFrame(e,{baseline:r,baseline2:i,baseline3:a}),s=this.dueUs(e.frame,e.lateUs),c=Ss(e.channels,e.channelsCrc,this.frames.channelsOf(t[0]));e.unchangedTicks>0&&this.frames.hold(this.dueUs(t[0]+e.unchangedTicks,e.lateUs));let l=this.welcome?.cells?this.cells.blends(e.frame):void 0,u=this.frames.add(o,s,this.spec,c,l,1e6/(this.welcome?.tickHz||60));this.needKeyframe=!1,this.snapshots++,this.decodedAt=n();let d=n();if(this.renderClock.onFrame(s,d,e.unchangedTicks>0),this.clock.ready){let t=this.clock.serverUs(d)-s;this.ageMs=t/1e3,this.inputClock.onFrame(e.frame,t,1e3*this.clock.rttMs/2,d),this.inputClock.onMargin(e.clientUpdate?.inputSequence??0,e.clientUpdate?.inputMarginUs??0)}this.predictionListener?.frame(u)}catch(e){if(!(e instanceof xa))throw e;this.needKeyframe||this.decodeErrors++,this.needKeyframe=!0}}decodeWholeFrame(e,t){let n=rs(e.frame,e.packed,t,this.spec,void 0,this.codec);if(is(n)!==e.crc)throw new xa(`frame ${e.frame}: CRC mismatch`);return n}decodeCells(e){this.cells.apply(e.cells,e.cellsLeft,this.spec,this.codec,e.frame);let t=this.cells.frame(e.frame);return{frame:t.frame,entities:t.entities.filter(e=>this.entities.has(e.id))}}setInterestFocus(e,t){!this.areaOfInterest||Math.hypot(e-this.focus.x,t-this.focus.z)<Math.max(2,this.areaOfInterest.radius/16)||(this.focus={x:e,z:t},this.state===`playing`&&this.sendMessage({case:`interest`,value:this.interest(this.areaOfInterest)}))}interest(e){return F(hc,{focus:{...this.focus,y:0},radius:e.radius})}dueUs(e,t){return Number(this.welcome.epochUs)+Math.round(e*1e6/this.welcome.tickHz)+Number(t)}ack(){return this.ackDue=!1,this.lastAck=n(),F(gc,{frame:this.frames.newest?.frame??0,needKeyframe:this.needKeyframe,ackDelayMs:this.decodedAt===0?0:Math.floor((this.lastAck-this.decodedAt)/1e3)})}sendAckIfDue(){if(!this.ackDue)return;let e=this.lastAck+(this.welcome?.ackIntervalMs??0)*1e3;(this.needKeyframe||n()>=e)&&this.sendMessage({case:`ack`,value:this.ack()})}pump(){let e=n();if(e-this.lastReceivedUs>Tc*1e3)return this.reconnect(`the server does not respond`);this.state===`playing`&&(e-this.lastPing>=Sc*1e3&&(this.lastPing=e,this.sendMessage({case:`ping`,value:{clientTimeUs:BigInt(Math.round(e))}})),this.inputs.length>0?this.sendInputs(e):this.sendAckIfDue())}sendInputs(e){let{firstSequence:t,inputs:n}=this.inputs.take(Cc);this.lastBatch=e,this.inputClock.sent(this.inputs.lastSent);let r=Math.floor(e)%2**32;this.sendMessage({case:`input`,value:{firstSequence:t,inputs:n,ack:this.ack(),clientTimeUs:r}})}},Ac=.1,jc=3,Mc=1.1,Nc=1.5,Pc=.35,Fc=1e-5,Ic=e=>Math.max(Mc,Pc*e.speed),Lc=e=>Math.max(Nc,Pc*e.spin),Rc=(e,t,n)=>Math.max(e*2**(-n/Ac),e-t*n);function zc(e,t,n){let[r,i,a,o]=[e[3],e[4],e[5],e[6]],[s,c,l,u]=[t[3],t[4],t[5],t[6]];n[3]=o*s+r*u+i*l-a*c,n[4]=o*c+i*u+a*s-r*l,n[5]=o*l+a*u+r*c-i*s,n[6]=o*u-r*s-i*c-a*l}function Bc(e,t,n){let r=new Float64Array(7);for(let n=0;n<3;n++)r[n]=e[n]-t[n];if(!(Math.hypot(r[0],r[1],r[2])>jc*Ic(n))){if(zc(e,Float64Array.of(0,0,0,-t[3],-t[4],-t[5],t[6]),r),r[6]<0)for(let e=3;e<7;e++)r[e]=-r[e];return r}}function Vc(e,t){for(let n=0;n<3;n++)e[n]=e[n]+t[n];zc(t,e,e);let n=1/Math.hypot(e[3],e[4],e[5],e[6]);for(let t=3;t<7;t++)e[t]=e[t]*n}function Hc(e,t,n){let r=Math.hypot(e[0],e[1],e[2]),i=Rc(r,Ic(t),n),a=i>Fc?i/r:0;for(let t=0;t<3;t++)e[t]=e[t]*a;let o=Math.hypot(e[3],e[4],e[5]),s=Rc(2*Math.atan2(o,e[6]),Lc(t),n),c=s>Fc&&o>0?Math.sin(s/2)/o:0;for(let t=3;t<6;t++)e[t]=e[t]*c;return e[6]=c>0?Math.cos(s/2):1,a>0||c>0}var Uc=5e4,Wc=100,Gc=25e4;function Kc(e,t,n,r,i){return Math.hypot(n[r]-e[t],n[r+1]-e[t+1],n[r+2]-e[t+2])*1e6>Wc*i}function qc(e,t,n){let r=0,i=e;for(;r<i;){let e=r+i>>1;t(e)<n?r=e+1:i=e}return r<e&&t(r)===n?r:-1}var Jc=({entities:e},t)=>qc(e.length,t=>e[t].id,t),Yc=class{ids=new Uint32Array;poses=new Float64Array;speeds=new Float64Array;count=0;source;update(e,t){let n=e.around(t);if(this.count=n?.b.entities.length??0,this.source=n?.b,!n)return;let{a:r,b:i}=n;this.reserve();let a=r.heldUntilUs??r.serverUs,o=i.serverUs-a,s=o>0?1+Uc/o:1,c=o>0?Math.min(s,Math.max(0,(t-a)/o)):1,l=0;for(let e=0;e<this.count;e++){let t=i.entities[e];for(this.ids[e]=t.id,this.speeds[2*e]=this.speeds[2*e+1]=0;l<r.entities.length&&r.entities[l].id<t.id;)l++;let n=r.entities[l];n?.id!==t.id||n===t?this.copy(i.poses,e,e):Kc(r.poses,l*7,i.poses,e*7,o)?this.copy(c<1?r.poses:i.poses,c<1?l:e,e):this.blend(r.poses,l,i.poses,e,c,o/1e6)}}poseAt(e){return this.poses.subarray(e*7,(e+1)*7)}speedAt(e){return{speed:this.speeds[2*e],spin:this.speeds[2*e+1]}}indexOf(e){return qc(this.count,e=>this.ids[e],e)}reserve(){if(this.ids.length>=this.count)return;let e=Math.ceil(this.count*1.5);this.ids=new Uint32Array(e),this.poses=new Float64Array(e*7),this.speeds=new Float64Array(e*2)}copy(e,t,n){for(let r=0;r<7;r++)this.poses[n*7+r]=e[t*7+r]}blend(e,t,n,r,i,a){let o=t*7,s=r*7,c=0;for(let t=0;t<3;t++){let r=n[s+t]-e[o+t];this.poses[s+t]=e[o+t]+i*r,c+=r*r}let l=0;for(let t=3;t<7;t++)l+=e[o+t]*n[s+t];let u=l<0?-1:1,d=0;for(let t=3;t<7;t++){let r=e[o+t]+i*(u*n[s+t]-e[o+t]);this.poses[s+t]=r,d+=r*r}let f=1/Math.sqrt(d);for(let e=3;e<7;e++)this.poses[s+e]*=f;this.speeds[2*r]=Math.sqrt(c)/a,this.speeds[2*r+1]=2*Math.acos(Math.min(1,Math.abs(l)))/a}};function Xc(e,t,n){let r=e.since(n);for(let e=1;e<r.length;e++){let[n,i]=[r[e-1],r[e]],a=Jc(n,t),o=Jc(i,t);if(a>=0&&o>=0&&Kc(n.poses,a*7,i.poses,o*7,i.serverUs-(n.heldUntilUs??n.serverUs)))return!0}return!1}var Zc=class{secondsFromSource=0;current=new Yc;reference=new Yc;errors=new Map;lastSampleUs=0;lastRenderTimeUs=0;lastNewestFrameUs=0;get ids(){return this.current.ids}get poses(){return this.current.poses}get count(){return this.current.count}get source(){return this.current.source}indexOf(e){return this.current.indexOf(e)}poseOf(e){let t=this.current.indexOf(e);return t<0?void 0:this.current.poseAt(t)}update(e,t,n){let r=e.newest?.serverUs??0,i=Math.max(0,n-this.lastSampleUs);i>Gc||r<this.lastNewestFrameUs?this.errors.clear():this.lastRenderTimeUs>this.lastNewestFrameUs&&r>this.lastNewestFrameUs&&this.updateErrors(e),this.current.update(e,t),this.secondsFromSource=this.source?Math.min(Uc,t-this.source.serverUs)/1e6:0;for(let[e,t]of this.errors){let n=this.current.indexOf(e);n>=0&&Hc(t,this.current.speedAt(n),i/1e6)?Vc(this.current.poseAt(n),t):this.errors.delete(e)}this.lastSampleUs=n,this.lastRenderTimeUs=t,this.lastNewestFrameUs=r}updateErrors(e){let t=this.reference;t.update(e,this.lastRenderTimeUs);for(let n=0;n<this.count;n++){let r=this.ids[n],i=t.indexOf(r);if(i<0)continue;let a=this.current.poseAt(n),o=t.poseAt(i);if(a.every((e,t)=>e===o[t]))this.errors.delete(r);else{let n=Xc(e,r,this.lastNewestFrameUs)?void 0:Bc(a,o,t.speedAt(i));n?this.errors.set(r,n):this.errors.delete(r)}}}},Qc=`modulepreload`,$c=function(e,t){return new URL(e,t).href},el={},tl=function(e){return e.pathname.endsWith(`.css`)},nl=function(e,t,n){if(t in e)return e[t];let r=n();if(!r){e[t]=void 0;return}let i=r.then(()=>{e[t]=void 0},n=>{throw e[t]=void 0,n});return e[t]=i,i},rl=function(e,t,n){let r=Promise.resolve();if(t&&t.length>0){let e,i=document.querySelector(`meta[property=csp-nonce]`),a=i?.nonce||i?.getAttribute(`nonce`);function o(e){return Promise.all(e.map(e=>Promise.resolve(e).then(e=>({status:`fulfilled`,value:e}),e=>({status:`rejected`,reason:e}))))}function s(e){return import.meta.resolve?new URL(import.meta.resolve(e)):new URL(e,import.meta.url)}r=o(t.map(t=>{t=$c(t,n);let r=s(t),i=tl(r);return nl(el,r.href,()=>{if(e===void 0){e={all:new Set,styles:new Set};let t=document.getElementsByTagName(`link`);for(let n=t.length-1;n>=0;n--){let r=t[n];e.all.add(r.href),r.rel===`stylesheet`&&e.styles.add(r.href)}}if((i?e.styles:e.all).has(r.href))return;let t=document.createElement(`link`);if(t.rel=i?`stylesheet`:Qc,i||(t.as=`script`),t.crossOrigin=``,t.href=r.href,a&&t.setAttribute(`nonce`,a),document.head.appendChild(t),i)return new Promise((e,n)=>{let i=a=>{t.removeEventListener(`load`,i),t.removeEventListener(`error`,i),a.type===`error`?n(Error(`Unable to preload CSS for ${r}`)):e(a)};t.addEventListener(`load`,i),t.addEventListener(`error`,i)})})}).filter(e=>e!==void 0))}function i(e){let t=new Event(`vite:preloadError`,{cancelable:!0});if(t.payload=e,window.dispatchEvent(t),!t.defaultPrevented)throw e}return r.then(t=>{for(let e of t||[])e.status===`rejected`&&i(e.reason);return e().catch(i)})},il=wr(`ChVqb3N0bGUvdjEvcXVlcnkucHJvdG8SCWpvc3RsZS52MSJfCgtRdWVyeUZpbHRlchIXCgpjYXRlZ29yaWVzGAEgASgNSACIAQESGAoQaW5jbHVkZV90cmlnZ2VycxgCIAEoCBIOCgZpZ25vcmUYAyABKA1CDQoLX2NhdGVnb3JpZXMiRwoDUmF5Eh8KBm9yaWdpbhgBIAEoCzIPLmpvc3RsZS52MS5WZWMzEh8KBm1vdGlvbhgCIAEoCzIPLmpvc3RsZS52MS5WZWMzIrABCg9DYXN0UmF5c1JlcXVlc3QSDQoFd29ybGQYASABKAkSHAoEcmF5cxgCIAMoCzIOLmpvc3RsZS52MS5SYXkSIAoEbW9kZRgDIAEoDjISLmpvc3RsZS52MS5IaXRNb2RlEiYKBmZpbHRlchgEIAEoCzIWLmpvc3RsZS52MS5RdWVyeUZpbHRlchImCgl2aWV3X3RpbWUYBSABKAsyEy5qb3N0bGUudjEuVmlld1RpbWUiWgoQQ2FzdFJheXNSZXNwb25zZRIMCgR0aWNrGAEgASgNEh0KBHJheXMYAiADKAsyDy5qb3N0bGUudjEuSGl0cxIZChF2aWV3X3RpbWVfY2xhbXBlZBgDIAEoCCIkCgRIaXRzEhwKBGhpdHMYASADKAsyDi5qb3N0bGUudjEuSGl0IncKA0hpdBIOCgZlbnRpdHkYASABKA0SEAoIZnJhY3Rpb24YAiABKAESHgoFcG9pbnQYAyABKAsyDy5qb3N0bGUudjEuVmVjMxIfCgZub3JtYWwYBCABKAsyDy5qb3N0bGUudjEuVmVjMxINCgVzaGFwZRgFIAEoDSK8AQoRQ2FzdFNoYXBlc1JlcXVlc3QSDQoFd29ybGQYASABKAkSJgoGc2hhcGVzGAIgAygLMhYuam9zdGxlLnYxLk1vdmluZ1NoYXBlEiAKBG1vZGUYAyABKA4yEi5qb3N0bGUudjEuSGl0TW9kZRImCgZmaWx0ZXIYBCABKAsyFi5qb3N0bGUudjEuUXVlcnlGaWx0ZXISJgoJdmlld190aW1lGAUgASgLMhMuam9zdGxlLnYxLlZpZXdUaW1lIk8KC01vdmluZ1NoYXBlEh8KBXNoYXBlGAEgASgLMhAuam9zdGxlLnYxLlNoYXBlEh8KBm1vdGlvbhgCIAEoCzIPLmpvc3RsZS52MS5WZWMzIl4KEkNhc3RTaGFwZXNSZXNwb25zZRIMCgR0aWNrGAEgASgNEh8KBnNoYXBlcxgCIAMoCzIPLmpvc3RsZS52MS5IaXRzEhkKEXZpZXdfdGltZV9jbGFtcGVkGAMgASgIIrwBCg5PdmVybGFwUmVxdWVzdBINCgV3b3JsZBgBIAEoCRIhCgVzaGFwZRgCIAEoCzIQLmpvc3RsZS52MS5TaGFwZUgAEiAKBXBvaW50GAMgASgLMg8uam9zdGxlLnYxLlZlYzNIABImCgZmaWx0ZXIYBCABKAsyFi5qb3N0bGUudjEuUXVlcnlGaWx0ZXISJgoJdmlld190aW1lGAUgASgLMhMuam9zdGxlLnYxLlZpZXdUaW1lQgYKBHdoYXQiTAoPT3ZlcmxhcFJlc3BvbnNlEgwKBHRpY2sYASABKA0SEAoIZW50aXRpZXMYAiADKA0SGQoRdmlld190aW1lX2NsYW1wZWQYAyABKAgirAEKFENsb3Nlc3RQb2ludHNSZXF1ZXN0Eg0KBXdvcmxkGAEgASgJEh8KBnBvaW50cxgCIAMoCzIPLmpvc3RsZS52MS5WZWMzEhQKDG1heF9kaXN0YW5jZRgDIAEoARImCgZmaWx0ZXIYBCABKAsyFi5qb3N0bGUudjEuUXVlcnlGaWx0ZXISJgoJdmlld190aW1lGAUgASgLMhMuam9zdGxlLnYxLlZpZXdUaW1lImkKFUNsb3Nlc3RQb2ludHNSZXNwb25zZRIMCgR0aWNrGAEgASgNEicKBnBvaW50cxgCIAMoCzIXLmpvc3RsZS52MS5DbG9zZXN0UG9pbnQSGQoRdmlld190aW1lX2NsYW1wZWQYAyABKAgicQoMQ2xvc2VzdFBvaW50Eg4KBmVudGl0eRgBIAEoDRIQCghkaXN0YW5jZRgCIAEoARIeCgVwb2ludBgDIAEoCzIPLmpvc3RsZS52MS5WZWMzEh8KBm5vcm1hbBgEIAEoCzIPLmpvc3RsZS52MS5WZWMzInUKDERlYnVnUmVxdWVzdBINCgV3b3JsZBgBIAEoCRIQCghjb250YWN0cxgCIAEoCBIPCgdpc2xhbmRzGAMgASgIEg4KBmJvdW5kcxgEIAEoCBIOCgZqb2ludHMYBSABKAgSEwoLYnJvYWRfcGhhc2UYBiABKAgi+gEKDURlYnVnUmVzcG9uc2USDAoEdGljaxgBIAEoDRIpCghjb250YWN0cxgCIAMoCzIXLmpvc3RsZS52MS5EZWJ1Z0NvbnRhY3QSJwoHaXNsYW5kcxgDIAMoCzIWLmpvc3RsZS52MS5EZWJ1Z0lzbGFuZBIjCgZib3VuZHMYBCADKAsyEy5qb3N0bGUudjEuRGVidWdCb3gSJQoGam9pbnRzGAUgAygLMhUuam9zdGxlLnYxLkRlYnVnSm9pbnQSKAoLYnJvYWRfcGhhc2UYBiADKAsyEy5qb3N0bGUudjEuRGVidWdCb3gSEQoJdHJ1bmNhdGVkGAcgASgIIoYBCgxEZWJ1Z0NvbnRhY3QSHgoFcG9pbnQYASABKAsyDy5qb3N0bGUudjEuVmVjMxIfCgZub3JtYWwYAiABKAsyDy5qb3N0bGUudjEuVmVjMxISCgpzZXBhcmF0aW9uGAMgASgBEg8KB2ltcHVsc2UYBCABKAESEAoIdG91Y2hpbmcYBSABKAgiLwoLRGVidWdJc2xhbmQSEAoIZW50aXRpZXMYASADKA0SDgoGYXNsZWVwGAIgASgIIkcKCERlYnVnQm94EhwKA2xvdxgBIAEoCzIPLmpvc3RsZS52MS5WZWMzEh0KBGhpZ2gYAiABKAsyDy5qb3N0bGUudjEuVmVjMyKEAQoKRGVidWdKb2ludBIQCghlbnRpdHlfYRgBIAEoDRIQCghlbnRpdHlfYhgCIAEoDRIhCghhbmNob3JfYRgDIAEoCzIPLmpvc3RsZS52MS5WZWMzEiEKCGFuY2hvcl9iGAQgASgLMg8uam9zdGxlLnYxLlZlYzMSDAoEa2luZBgFIAEoCSpdCgdIaXRNb2RlEhgKFEhJVF9NT0RFX1VOU1BFQ0lGSUVEEAASFAoQSElUX01PREVfQ0xPU0VTVBABEhAKDEhJVF9NT0RFX0FOWRACEhAKDEhJVF9NT0RFX0FMTBADMvACCgxRdWVyeVNlcnZpY2USQwoIQ2FzdFJheXMSGi5qb3N0bGUudjEuQ2FzdFJheXNSZXF1ZXN0Ghsuam9zdGxlLnYxLkNhc3RSYXlzUmVzcG9uc2USSQoKQ2FzdFNoYXBlcxIcLmpvc3RsZS52MS5DYXN0U2hhcGVzUmVxdWVzdBodLmpvc3RsZS52MS5DYXN0U2hhcGVzUmVzcG9uc2USQAoHT3ZlcmxhcBIZLmpvc3RsZS52MS5PdmVybGFwUmVxdWVzdBoaLmpvc3RsZS52MS5PdmVybGFwUmVzcG9uc2USUgoNQ2xvc2VzdFBvaW50cxIfLmpvc3RsZS52MS5DbG9zZXN0UG9pbnRzUmVxdWVzdBogLmpvc3RsZS52MS5DbG9zZXN0UG9pbnRzUmVzcG9uc2USOgoFRGVidWcSFy5qb3N0bGUudjEuRGVidWdSZXF1ZXN0Ghguam9zdGxlLnYxLkRlYnVnUmVzcG9uc2ViBnByb3RvMw`,[Ls,Rs]),al=Rn(il,2),ol=Rn(il,3),sl=Rn(il,14),cl=Rn(il,15),ll=1e4,ul=[404,501],dl=429;function fl(e){let{retryAfterMs:t}=JSON.parse(e);return typeof t==`number`?t:0}function pl(e,t={}){return e===``?t:{...t,Authorization:`Bearer ${e}`}}var ml=e=>(t,n,r)=>fetch(t,{method:`POST`,headers:pl(e,{"Content-Type":`application/json`}),body:n,signal:r}),hl=class{world;post;notServed=new Set;notBeforeMs=0;constructor(e,t=ml(``)){this.world=e,this.post=t}castRays(e){return this.call(`CastRays`,al,e,ol)}debug(e){return this.call(`Debug`,sl,e,cl)}async call(e,t,n,r){let i=this.world(),a=`${e} in ${i}`;if(!(i===``||this.notServed.has(a)||performance.now()<this.notBeforeMs))try{let o=F(t,{...n,world:i}),s=await this.post(`api/query/${e}`,mi(t,o),AbortSignal.timeout(ll));ul.includes(s.status)&&this.notServed.add(a);let c=await s.text();return s.status===dl&&(this.notBeforeMs=performance.now()+fl(c)),s.status===200&&this.world()===i?Ui(r,c,{ignoreUnknownFields:!0}):void 0}catch{return}}},gl=2e5,_l=1e6,vl=25e4,yl=class{recording;binaryType=``;onopen=null;onmessage=null;onclose=null;playing=!0;speed=1;renderTimeUs;firstUs;lastUs;lastFrameUs=0;next=0;welcomed=!1;seekUs;constructor(e){this.recording=e,this.firstUs=this.renderTimeUs=e.dueUs(e.firstTick),this.lastUs=e.dueUs(e.lastTick)}open(){return this.welcomed=!1,queueMicrotask(()=>this.onopen?.()),this}send(e){let{message:t}=lr(mc,e);if(t.case===`hello`)this.welcomed=!0,this.seekUs??=this.renderTimeUs;else if(t.case===`ping`){let{clientTimeUs:e}=t.value,n=F(_c,{message:{case:`pong`,value:{clientTimeUs:e,serverTimeUs:BigInt(Math.round(this.renderTimeUs))}}});this.deliver(Ar(_c,n))}}close(){this.welcomed=!1}get tick(){let{welcome:e,firstTick:t,lastTick:n}=this.recording,r=Math.round((this.renderTimeUs-this.firstUs)*e.tickHz/1e6);return Math.min(n,t+r)}get seconds(){return(this.renderTimeUs-this.firstUs)/1e6}get length(){return(this.lastUs-this.firstUs)/1e6}seek(e){this.seekUs=Math.min(this.lastUs,Math.max(this.firstUs,this.firstUs+e*1e6))}play(){this.renderTimeUs>=this.lastUs&&this.seek(0),this.playing=!0}advance(e){let t=Math.min(vl,Math.max(0,e-this.lastFrameUs));if(this.lastFrameUs=e,!this.welcomed)return this.renderTimeUs;if(this.seekUs!==void 0){let e=this.seekUs-this.renderTimeUs;this.renderTimeUs=this.seekUs,this.seekUs=void 0,(this.next===0||e<0||e>_l)&&this.begin()}else this.playing&&(this.renderTimeUs=Math.min(this.lastUs,this.renderTimeUs+t*this.speed),this.renderTimeUs>=this.lastUs&&(this.playing=!1));return this.deliverMessages(),this.renderTimeUs}begin(){let{messages:e}=this.recording,t=this.recording.keyframeBefore(this.recording.firstTick);for(let n=t;n<e.length;n++)e[n].keyframe&&e[n].dueUs<=this.renderTimeUs&&(t=n);this.deliver(e[0].bytes);for(let n=1;n<t;n++)e[n].persistent&&this.deliver(e[n].bytes);this.next=t}deliverMessages(){let{messages:e}=this.recording;for(;this.next<e.length&&e[this.next].dueUs<=this.renderTimeUs+gl;this.next++)this.deliver(e[this.next].bytes)}deliver(e){this.onmessage?.({data:e.slice().buffer})}},bl=class extends Error{},xl=16,Sl=16,Cl=8,wl=2**26,Tl=2**26,El=1,Dl=(e,t)=>new bl(`byte ${e}: ${t}`),Ol=(e,t)=>[...t].every((t,n)=>e[n]===t.charCodeAt(0)),kl=class{messages;welcome;firstTick;lastTick;truncationReason;damage;constructor(e){let t=new DataView(e.buffer,e.byteOffset,e.length);if(e.length<xl||!Ol(e,`JREC`))throw Dl(0,`not a recording: must start with "JREC"; create one with jostle-record`);let n=t.getUint32(4,!0);if(n!==El)throw Dl(4,`unsupported version ${n}; supported: ${El}`);let r=[],i=[],a=``,o=!1,s=0,c;for(let n=xl;n<e.length&&(e.length-n<4||t.getUint32(n,!0)!==0);){let l=jl(e,t,n);if(typeof l==`string`){let r=`byte ${n}: ${l}`,s=c&&Ml(e,t,n);if(!s){a=r;break}i.push({byte:n,length:s-n,reason:r,snapshotsSkipped:0}),o=!0,n=s;continue}let{message:u,length:d}=l;if(!c){if(u.case!==`welcome`)throw Dl(n,`the first message is not a Welcome`);if(c=u.value,c.cells)throw Dl(n,`recordings of an area of interest cannot be played`);if(!(c.tickHz>0))throw Dl(n,`invalid tick rate ${c.tickHz} Hz`)}let f=u.case===`snapshot`?u.value:void 0;f&&(s=Number(c.epochUs)+Math.round(f.frame*1e6/c.tickHz)+Number(f.lateUs)),n+=Sl+d;let p=f?.baselines===0;p&&(o=!1),f&&o?i.at(-1).snapshotsSkipped++:r.push({bytes:e.subarray(n-d,n),frame:f?.frame??0,dueUs:s,keyframe:p,persistent:u.case===`entityUpdate`||u.case===`geometry`})}let l=r.find(({keyframe:e})=>e);if(!c||!l)throw new bl(`the recording has no keyframe${a&&`: ${a}`}`);this.messages=r,this.welcome=c,this.truncationReason=a,this.damage=i,this.firstTick=l.frame,this.lastTick=Math.max(...Al(r))}keyframeBefore(e){let t=-1;for(let n=0;n<this.messages.length;n++){let{keyframe:r,frame:i}=this.messages[n];r&&(t<0||i<=e)&&(t=n)}return t}dueUs(e){let t=this.messages[this.keyframeBefore(e)].dueUs;for(let n of this.messages)n.frame>0&&n.frame<=e&&(t=Math.max(t,n.dueUs));return t}};function Al(e){return e.filter(({frame:e})=>e>0).slice(-2).map(({frame:e})=>e)}function jl(e,t,n){if(e.length-n<Sl)return`truncated record header`;let r=t.getUint32(n,!0);if(r>wl)return`invalid message length ${r}; must be 1 to ${wl} bytes`;let i=n+Sl+r;if(i>e.length)return`truncated message: ${e.length-n-Sl} of ${r} bytes`;if(Va(e.subarray(n+Cl,i))!==t.getUint32(n+4,!0))return`CRC mismatch: the record is damaged`;try{return{message:lr(_c,e.subarray(n+Sl,i)).message,length:r}}catch{return`the record is not a ServerMessage`}}function Ml(e,t,n){let r=Tl;for(let i=n+1;i+Sl<e.length;i++){let n=t.getUint32(i,!0);if(!(n===0||n>wl||n>e.length-i-Sl)){if(n>r)return;if(r-=n,typeof jl(e,t,i)!=`string`)return i}}}var Nl={latencyMs:0,jitterMs:0,jitterTailMs:0,stallMs:0,stallIntervalMs:5e3,loss:0,lossBurst:1,retransmitMs:200,duplicate:0,reorder:0,reorderMs:20,rateKbps:0,seed:1};function Pl(e){let{latencyMs:t,jitterMs:n,jitterTailMs:r,stallMs:i,loss:a,duplicate:o,reorder:s,rateKbps:c}=e;return[t,n,r,i,a,o,s,c].some(e=>e>0)}var Fl=e=>Math.round(1e3*e),Il=class{conditions;delivery;random;lastArrival=0;stall=0;free=0;started=!1;previousLost=!1;constructor(e,t=0,n=`stream`){this.conditions=e,this.delivery=n,this.random=e.seed^Math.imul(2654435769,t)}send(e,t=0){let{stallIntervalMs:n,retransmitMs:r,duplicate:i,reorder:a,reorderMs:o}=this.conditions;this.started||(this.started=!0,this.stall=e+Fl(n*(.5+this.nextUniform())));let s=this.departure(e,t),c=this.nextTransitMs(),l=this.nextLost();if(l&&this.delivery===`datagrams`)return{copies:0,arrivalUs:0};if(l&&(c+=r),this.lastArrival=this.skipStalls(Math.max(s+Fl(c),this.lastArrival)),this.delivery===`stream`)return{copies:1,arrivalUs:this.lastArrival};let u=i>0&&this.nextUniform()<i?2:1,d=a>0&&this.nextUniform()<a;return{copies:u,arrivalUs:this.lastArrival+(d?Fl(o):0)}}departure(e,t){let{rateKbps:n}=this.conditions;return n>0?(this.free=Math.max(this.free,e)+8e3*t/n,Math.round(this.free)):e}nextTransitMs(){let{latencyMs:e,jitterMs:t,jitterTailMs:n}=this.conditions,r=e;return t>0&&(r+=t*this.nextUniform()),n>0&&(r-=n*Math.log(1-this.nextUniform())),r}nextLost(){let{loss:e,lossBurst:t}=this.conditions;if(!(e>0))return!1;let n=e;return t>1&&e<1&&(n=this.previousLost?1-1/t:e/(t*(1-e))),this.previousLost=this.nextUniform()<n}skipStalls(e){let{stallMs:t,stallIntervalMs:n}=this.conditions;if(!(t>0))return e;let r=Fl(t);for(;e>=this.stall+r;)this.stall+=Math.max(Fl(n*(.5+this.nextUniform())),r+1e3);return e>=this.stall?this.stall+r:e}nextUniform(){this.random=this.random+1831565813|0;let e=Math.imul(this.random^this.random>>>15,this.random|1);return e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/2**32}},Ll=class{due=[];simulator;constructor(e,t){this.simulator=new Il(e,t)}push(e,t){this.due.push({at:this.simulator.send(Math.round(n()),e).arrivalUs,deliver:t}),this.due.length===1&&this.schedule()}schedule(){setTimeout(()=>this.deliverDue(),Math.max(0,Math.ceil((this.due[0].at-n())/1e3)))}deliverDue(){for(;this.due.length>0&&this.due[0].at<=n();)this.due.shift().deliver();this.due.length>0&&this.schedule()}};function Rl(e,t){return n=>{let r=e(n),i=new Ll(t,0),a=new Ll(t,1),o=!1,s={get binaryType(){return r.binaryType},set binaryType(e){r.binaryType=e},onopen:null,onmessage:null,onclose:null,send:e=>a.push(e.byteLength,()=>o||r.send(e)),close:()=>{o=!0,r.close()}};return r.onopen=()=>s.onopen?.(),r.onmessage=e=>i.push(e.data.byteLength,()=>s.onmessage?.(e)),r.onclose=e=>{o=!0,i.push(0,()=>s.onclose?.(e))},s}}var zl={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Bl={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Vl=1e3,Hl=1001,Ul=1002,Wl=1003,Gl=1004,Kl=1005,ql=1006,Jl=1007,Yl=1008,Xl=1009,Zl=1010,Ql=1011,$l=1012,eu=1013,tu=1014,nu=1015,ru=1016,iu=1017,au=1018,ou=1020,su=35902,cu=35899,lu=1021,uu=1022,du=1023,fu=1026,pu=1027,mu=1028,hu=1029,gu=1030,_u=1031,vu=1033,yu=33776,bu=33777,xu=33778,Su=33779,Cu=35840,wu=35841,Tu=35842,Eu=35843,Du=36196,Ou=37492,ku=37496,Au=37488,ju=37489,Mu=37490,Nu=37491,Pu=37808,Fu=37809,Iu=37810,Lu=37811,Ru=37812,zu=37813,Bu=37814,Vu=37815,Hu=37816,Uu=37817,Wu=37818,Gu=37819,Ku=37820,qu=37821,Ju=36492,Yu=36494,Xu=36495,Zu=36283,Qu=36284,$u=36285,ed=36286,td=2300,nd=2301,rd=2302,id=2303,ad=2400,od=2401,sd=2402,cd=3200,ld=`srgb`,ud=`srgb-linear`,dd=`linear`,fd=`srgb`,pd=7680,md=35044,hd=35048,gd=2e3;function _d(e){for(let t=e.length-1;t>=0;--t)if(e[t]>=65535)return!0;return!1}function vd(e){return ArrayBuffer.isView(e)&&!(e instanceof DataView)}function yd(e){return document.createElementNS(`http://www.w3.org/1999/xhtml`,e)}function bd(){let e=yd(`canvas`);return e.style.display=`block`,e}var xd={};function Sd(...e){let t=`THREE.`+e.shift();console.log(t,...e)}function Cd(e){let t=e[0];if(typeof t==`string`&&t.startsWith(`TSL:`)){let t=e[1];t&&t.isStackTrace?e[0]+=` `+t.getLocation():e[1]=`Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.`}return e}function V(...e){e=Cd(e);let t=`THREE.`+e.shift();{let n=e[0];n&&n.isStackTrace?console.warn(n.getError(t)):console.warn(t,...e)}}function H(...e){e=Cd(e);let t=`THREE.`+e.shift();{let n=e[0];n&&n.isStackTrace?console.error(n.getError(t)):console.error(t,...e)}}function wd(...e){let t=e.join(` `);t in xd||(xd[t]=!0,V(...e))}function Td(e,t,n){return new Promise(function(r,i){function a(){switch(e.clientWaitSync(t,e.SYNC_FLUSH_COMMANDS_BIT,0)){case e.WAIT_FAILED:i();break;case e.TIMEOUT_EXPIRED:setTimeout(a,n);break;default:r()}}setTimeout(a,n)})}var Ed={0:0,2:6,4:4,3:5,1:1,6:2,7:7,5:3},Dd=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n!==void 0&&n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let e=r.indexOf(t);e!==-1&&r.splice(e,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let t=n.slice(0);for(let n=0,r=t.length;n<r;n++)t[n].call(this,e);e.target=null}}},Od=`00.01.02.03.04.05.06.07.08.09.0a.0b.0c.0d.0e.0f.10.11.12.13.14.15.16.17.18.19.1a.1b.1c.1d.1e.1f.20.21.22.23.24.25.26.27.28.29.2a.2b.2c.2d.2e.2f.30.31.32.33.34.35.36.37.38.39.3a.3b.3c.3d.3e.3f.40.41.42.43.44.45.46.47.48.49.4a.4b.4c.4d.4e.4f.50.51.52.53.54.55.56.57.58.59.5a.5b.5c.5d.5e.5f.60.61.62.63.64.65.66.67.68.69.6a.6b.6c.6d.6e.6f.70.71.72.73.74.75.76.77.78.79.7a.7b.7c.7d.7e.7f.80.81.82.83.84.85.86.87.88.89.8a.8b.8c.8d.8e.8f.90.91.92.93.94.95.96.97.98.99.9a.9b.9c.9d.9e.9f.a0.a1.a2.a3.a4.a5.a6.a7.a8.a9.aa.ab.ac.ad.ae.af.b0.b1.b2.b3.b4.b5.b6.b7.b8.b9.ba.bb.bc.bd.be.bf.c0.c1.c2.c3.c4.c5.c6.c7.c8.c9.ca.cb.cc.cd.ce.cf.d0.d1.d2.d3.d4.d5.d6.d7.d8.d9.da.db.dc.dd.de.df.e0.e1.e2.e3.e4.e5.e6.e7.e8.e9.ea.eb.ec.ed.ee.ef.f0.f1.f2.f3.f4.f5.f6.f7.f8.f9.fa.fb.fc.fd.fe.ff`.split(`.`),kd=1234567,Ad=Math.PI/180,jd=180/Math.PI;function Md(){let e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0,r=Math.random()*4294967295|0;return(Od[e&255]+Od[e>>8&255]+Od[e>>16&255]+Od[e>>24&255]+`-`+Od[t&255]+Od[t>>8&255]+`-`+Od[t>>16&15|64]+Od[t>>24&255]+`-`+Od[n&63|128]+Od[n>>8&255]+`-`+Od[n>>16&255]+Od[n>>24&255]+Od[r&255]+Od[r>>8&255]+Od[r>>16&255]+Od[r>>24&255]).toLowerCase()}function U(e,t,n){return Math.max(t,Math.min(n,e))}function Nd(e,t){return(e%t+t)%t}function Pd(e,t,n,r,i){return r+(e-t)*(i-r)/(n-t)}function Fd(e,t,n){return e===t?0:(n-e)/(t-e)}function Id(e,t,n){return(1-n)*e+n*t}function Ld(e,t,n,r){return Id(e,t,1-Math.exp(-n*r))}function Rd(e,t=1){return t-Math.abs(Nd(e,t*2)-t)}function zd(e,t,n){return e<=t?0:e>=n?1:(e=(e-t)/(n-t),e*e*(3-2*e))}function Bd(e,t,n){return e<=t?0:e>=n?1:(e=(e-t)/(n-t),e*e*e*(e*(e*6-15)+10))}function Vd(e,t){return e+Math.floor(Math.random()*(t-e+1))}function Hd(e,t){return e+Math.random()*(t-e)}function Ud(e){return e*(.5-Math.random())}function Wd(e){e!==void 0&&(kd=e);let t=kd+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Gd(e){return e*Ad}function Kd(e){return e*jd}function qd(e){return e>0&&Number.isInteger(e)&&2**Math.round(Math.log2(e))===e}function Jd(e){return 2**Math.ceil(Math.log(e)/Math.LN2)}function Yd(e){return 2**Math.floor(Math.log(e)/Math.LN2)}function Xd(e,t,n,r,i){let a=Math.cos,o=Math.sin,s=a(n/2),c=o(n/2),l=a((t+r)/2),u=o((t+r)/2),d=a((t-r)/2),f=o((t-r)/2),p=a((r-t)/2),m=o((r-t)/2);switch(i){case`XYX`:e.set(s*u,c*d,c*f,s*l);break;case`YZY`:e.set(c*f,s*u,c*d,s*l);break;case`ZXZ`:e.set(c*d,c*f,s*u,s*l);break;case`XZX`:e.set(s*u,c*m,c*p,s*l);break;case`YXY`:e.set(c*p,s*u,c*m,s*l);break;case`ZYZ`:e.set(c*m,c*p,s*u,s*l);break;default:V(`MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: `+i)}}function Zd(e){switch(e.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Qd(e,t){if(t.constructor===Float32Array)return e;let n=Zd(t);if(n===void 0)throw Error(`THREE.MathUtils: Invalid component type.`);return Math.max(e/n,-1)}function $d(e,t){if(t.constructor===Float32Array)return e;let n=Zd(t);if(n===void 0)throw Error(`THREE.MathUtils: Invalid component type.`);return Math.round(e*n)}var ef={DEG2RAD:Ad,RAD2DEG:jd,generateUUID:Md,clamp:U,euclideanModulo:Nd,mapLinear:Pd,inverseLerp:Fd,lerp:Id,damp:Ld,pingpong:Rd,smoothstep:zd,smootherstep:Bd,randInt:Vd,randFloat:Hd,randFloatSpread:Ud,seededRandom:Wd,degToRad:Gd,radToDeg:Kd,isPowerOfTwo:qd,ceilPowerOfTwo:Jd,floorPowerOfTwo:Yd,setQuaternionFromProperEuler:Xd,normalize:$d,denormalize:Qd},W=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw Error(`THREE.Vector2: index is out of range: `+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw Error(`THREE.Vector2: index is out of range: `+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=U(this.x,e.x,t.x),this.y=U(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=U(this.x,e,t),this.y=U(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(U(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(U(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),i=this.x-e.x,a=this.y-e.y;return this.x=i*n-a*r+e.x,this.y=i*r+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},tf=class{constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,i,a,o){let s=n[r+0],c=n[r+1],l=n[r+2],u=n[r+3],d=i[a+0],f=i[a+1],p=i[a+2],m=i[a+3];if(u!==m||s!==d||c!==f||l!==p){let e=s*d+c*f+l*p+u*m;e<0&&(d=-d,f=-f,p=-p,m=-m,e=-e);let t=1-o;if(e<.9995){let n=Math.acos(e),r=Math.sin(n);t=Math.sin(t*n)/r,o=Math.sin(o*n)/r,s=s*t+d*o,c=c*t+f*o,l=l*t+p*o,u=u*t+m*o}else{s=s*t+d*o,c=c*t+f*o,l=l*t+p*o,u=u*t+m*o;let e=1/Math.sqrt(s*s+c*c+l*l+u*u);s*=e,c*=e,l*=e,u*=e}}e[t]=s,e[t+1]=c,e[t+2]=l,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,r,i,a){let o=n[r],s=n[r+1],c=n[r+2],l=n[r+3],u=i[a],d=i[a+1],f=i[a+2],p=i[a+3];return e[t]=o*p+l*u+s*f-c*d,e[t+1]=s*p+l*d+c*u-o*f,e[t+2]=c*p+l*f+o*d-s*u,e[t+3]=l*p-o*u-s*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,i=e._z,a=e._order,o=Math.cos,s=Math.sin,c=o(n/2),l=o(r/2),u=o(i/2),d=s(n/2),f=s(r/2),p=s(i/2);switch(a){case`XYZ`:this._x=d*l*u+c*f*p,this._y=c*f*u-d*l*p,this._z=c*l*p+d*f*u,this._w=c*l*u-d*f*p;break;case`YXZ`:this._x=d*l*u+c*f*p,this._y=c*f*u-d*l*p,this._z=c*l*p-d*f*u,this._w=c*l*u+d*f*p;break;case`ZXY`:this._x=d*l*u-c*f*p,this._y=c*f*u+d*l*p,this._z=c*l*p+d*f*u,this._w=c*l*u-d*f*p;break;case`ZYX`:this._x=d*l*u-c*f*p,this._y=c*f*u+d*l*p,this._z=c*l*p-d*f*u,this._w=c*l*u+d*f*p;break;case`YZX`:this._x=d*l*u+c*f*p,this._y=c*f*u+d*l*p,this._z=c*l*p-d*f*u,this._w=c*l*u-d*f*p;break;case`XZY`:this._x=d*l*u-c*f*p,this._y=c*f*u-d*l*p,this._z=c*l*p+d*f*u,this._w=c*l*u+d*f*p;break;default:V(`Quaternion: .setFromEuler() encountered an unknown order: `+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],i=t[8],a=t[1],o=t[5],s=t[9],c=t[2],l=t[6],u=t[10],d=n+o+u;if(d>0){let e=.5/Math.sqrt(d+1);this._w=.25/e,this._x=(l-s)*e,this._y=(i-c)*e,this._z=(a-r)*e}else if(n>o&&n>u){let e=2*Math.sqrt(1+n-o-u);this._w=(l-s)/e,this._x=.25*e,this._y=(r+a)/e,this._z=(i+c)/e}else if(o>u){let e=2*Math.sqrt(1+o-n-u);this._w=(i-c)/e,this._x=(r+a)/e,this._y=.25*e,this._z=(s+l)/e}else{let e=2*Math.sqrt(1+u-n-o);this._w=(a-r)/e,this._x=(i+c)/e,this._y=(s+l)/e,this._z=.25*e}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(U(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x*=e,this._y*=e,this._z*=e,this._w*=e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,i=e._z,a=e._w,o=t._x,s=t._y,c=t._z,l=t._w;return this._x=n*l+a*o+r*c-i*s,this._y=r*l+a*s+i*o-n*c,this._z=i*l+a*c+n*s-r*o,this._w=a*l-n*o-r*s-i*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,i=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,r=-r,i=-i,a=-a,o=-o);let s=1-t;if(o<.9995){let e=Math.acos(o),c=Math.sin(e);s=Math.sin(s*e)/c,t=Math.sin(t*e)/c,this._x=this._x*s+n*t,this._y=this._y*s+r*t,this._z=this._z*s+i*t,this._w=this._w*s+a*t,this._onChangeCallback()}else this._x=this._x*s+n*t,this._y=this._y*s+r*t,this._z=this._z*s+i*t,this._w=this._w*s+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),i=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),i*Math.sin(t),i*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw Error(`THREE.Vector3: index is out of range: `+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw Error(`THREE.Vector3: index is out of range: `+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(rf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(rf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,i=e.elements;return this.x=i[0]*t+i[3]*n+i[6]*r,this.y=i[1]*t+i[4]*n+i[7]*r,this.z=i[2]*t+i[5]*n+i[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,i=e.elements,a=1/(i[3]*t+i[7]*n+i[11]*r+i[15]);return this.x=(i[0]*t+i[4]*n+i[8]*r+i[12])*a,this.y=(i[1]*t+i[5]*n+i[9]*r+i[13])*a,this.z=(i[2]*t+i[6]*n+i[10]*r+i[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,i=e.x,a=e.y,o=e.z,s=e.w,c=2*(a*r-o*n),l=2*(o*t-i*r),u=2*(i*n-a*t);return this.x=t+s*c+a*u-o*l,this.y=n+s*l+o*c-i*u,this.z=r+s*u+i*l-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,i=e.elements;return this.x=i[0]*t+i[4]*n+i[8]*r,this.y=i[1]*t+i[5]*n+i[9]*r,this.z=i[2]*t+i[6]*n+i[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=U(this.x,e.x,t.x),this.y=U(this.y,e.y,t.y),this.z=U(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=U(this.x,e,t),this.y=U(this.y,e,t),this.z=U(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(U(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,i=e.z,a=t.x,o=t.y,s=t.z;return this.x=r*s-i*o,this.y=i*a-n*s,this.z=n*o-r*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return nf.copy(this).projectOnVector(e),this.sub(nf)}reflect(e){return this.sub(nf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(U(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},nf=new G,rf=new tf,K=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,i,a,o,s,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,i,a,o,s,c)}set(e,t,n,r,i,a,o,s,c){let l=this.elements;return l[0]=e,l[1]=r,l[2]=o,l[3]=t,l[4]=i,l[5]=s,l[6]=n,l[7]=a,l[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,i=this.elements,a=n[0],o=n[3],s=n[6],c=n[1],l=n[4],u=n[7],d=n[2],f=n[5],p=n[8],m=r[0],h=r[3],g=r[6],_=r[1],v=r[4],y=r[7],b=r[2],x=r[5],S=r[8];return i[0]=a*m+o*_+s*b,i[3]=a*h+o*v+s*x,i[6]=a*g+o*y+s*S,i[1]=c*m+l*_+u*b,i[4]=c*h+l*v+u*x,i[7]=c*g+l*y+u*S,i[2]=d*m+f*_+p*b,i[5]=d*h+f*v+p*x,i[8]=d*g+f*y+p*S,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],i=e[3],a=e[4],o=e[5],s=e[6],c=e[7],l=e[8];return t*a*l-t*o*c-n*i*l+n*o*s+r*i*c-r*a*s}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],i=e[3],a=e[4],o=e[5],s=e[6],c=e[7],l=e[8],u=l*a-o*c,d=o*s-l*i,f=c*i-a*s,p=t*u+n*d+r*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let m=1/p;return e[0]=u*m,e[1]=(r*c-l*n)*m,e[2]=(o*n-r*a)*m,e[3]=d*m,e[4]=(l*t-r*s)*m,e[5]=(r*i-o*t)*m,e[6]=f*m,e[7]=(n*s-c*t)*m,e[8]=(a*t-n*i)*m,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,i,a,o){let s=Math.cos(i),c=Math.sin(i);return this.set(n*s,n*c,-n*(s*a+c*o)+a+e,-r*c,r*s,-r*(-c*a+s*o)+o+t,0,0,1),this}scale(e,t){return wd(`Matrix3: .scale() is deprecated. Use .makeScale() instead.`),this.premultiply(af.makeScale(e,t)),this}rotate(e){return wd(`Matrix3: .rotate() is deprecated. Use .makeRotation() instead.`),this.premultiply(af.makeRotation(-e)),this}translate(e,t){return wd(`Matrix3: .translate() is deprecated. Use .makeTranslation() instead.`),this.premultiply(af.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let e=0;e<9;e++)if(t[e]!==n[e])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},af=new K,of=new K().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),sf=new K().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function cf(){let e={enabled:!0,workingColorSpace:ud,spaces:{},convert:function(e,t,n){return this.enabled===!1||t===n||!t||!n||(this.spaces[t].transfer===`srgb`&&(e.r=lf(e.r),e.g=lf(e.g),e.b=lf(e.b)),this.spaces[t].primaries!==this.spaces[n].primaries&&(e.applyMatrix3(this.spaces[t].toXYZ),e.applyMatrix3(this.spaces[n].fromXYZ)),this.spaces[n].transfer===`srgb`&&(e.r=uf(e.r),e.g=uf(e.g),e.b=uf(e.b))),e},workingToColorSpace:function(e,t){return this.convert(e,this.workingColorSpace,t)},colorSpaceToWorking:function(e,t){return this.convert(e,t,this.workingColorSpace)},getPrimaries:function(e){return this.spaces[e].primaries},getTransfer:function(e){return e===``?dd:this.spaces[e].transfer},getToneMappingMode:function(e){return this.spaces[e].outputColorSpaceConfig.toneMappingMode||`standard`},getLuminanceCoefficients:function(e,t=this.workingColorSpace){return e.fromArray(this.spaces[t].luminanceCoefficients)},define:function(e){Object.assign(this.spaces,e)},_getMatrix:function(e,t,n){return e.copy(this.spaces[n].fromXYZ).multiply(this.spaces[t].toXYZ)},_getDrawingBufferColorSpace:function(e){return this.spaces[e].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(e=this.workingColorSpace){return this.spaces[e].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],n=[.2126,.7152,.0722],r=[.3127,.329];return e.define({[ud]:{primaries:t,whitePoint:r,transfer:dd,toXYZ:of,fromXYZ:sf,luminanceCoefficients:n,workingColorSpaceConfig:{unpackColorSpace:ld},outputColorSpaceConfig:{drawingBufferColorSpace:ld}},[ld]:{primaries:t,whitePoint:r,transfer:fd,toXYZ:of,fromXYZ:sf,luminanceCoefficients:n,outputColorSpaceConfig:{drawingBufferColorSpace:ld}}}),e}var q=cf();function lf(e){return e<.04045?e*.0773993808:(e*.9478672986+.0521327014)**2.4}function uf(e){return e<.0031308?e*12.92:1.055*e**.41666-.055}var df,ff=class{static getDataURL(e,t=`image/png`){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>`u`)return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{df===void 0&&(df=yd(`canvas`)),df.width=e.width,df.height=e.height;let t=df.getContext(`2d`);e instanceof ImageData?t.putImageData(e,0,0):t.drawImage(e,0,0,e.width,e.height),n=df}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<`u`&&e instanceof HTMLCanvasElement||typeof ImageBitmap<`u`&&e instanceof ImageBitmap){let t=yd(`canvas`);t.width=e.width,t.height=e.height;let n=t.getContext(`2d`);n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),i=r.data;for(let e=0;e<i.length;e++)i[e]=lf(i[e]/255)*255;return n.putImageData(r,0,0),t}if(e.data){let t=e.data.slice(0);for(let e=0;e<t.length;e++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[e]=Math.floor(lf(t[e]/255)*255):t[e]=lf(t[e]);return{data:t,width:e.width,height:e.height}}return V(`ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied.`),e}},pf=0,mf=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:pf++}),this.uuid=Md(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<`u`&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<`u`&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t===null?e.set(0,0,0):e.set(t.width||0,t.height||0,t.depth||0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e==`string`;if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:``},r=this.data;if(r!==null){let e;if(Array.isArray(r)){e=[];for(let t=0,n=r.length;t<n;t++)r[t].isDataTexture?e.push(hf(r[t].image)):e.push(hf(r[t]))}else e=hf(r);n.url=e}return t||(e.images[this.uuid]=n),n}};function hf(e){return typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<`u`&&e instanceof HTMLCanvasElement||typeof ImageBitmap<`u`&&e instanceof ImageBitmap?ff.getDataURL(e):e.data?{data:Array.from(e.data),width:e.width,height:e.height,type:e.data.constructor.name}:(V(`Texture: Unable to serialize Texture.`),{})}var gf=0,_f=new G,vf=class e extends Dd{constructor(t=e.DEFAULT_IMAGE,n=e.DEFAULT_MAPPING,r=Hl,i=Hl,a=ql,o=Yl,s=du,c=Xl,l=e.DEFAULT_ANISOTROPY,u=``){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:gf++}),this.uuid=Md(),this.name=``,this.source=new mf(t),this.mipmaps=[],this.mapping=n,this.channel=0,this.wrapS=r,this.wrapT=i,this.magFilter=a,this.minFilter=o,this.anisotropy=l,this.format=s,this.internalFormat=null,this.type=c,this.offset=new W(0,0),this.repeat=new W(1,1),this.center=new W(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new K,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(_f).x}get height(){return this.source.getSize(_f).y}get depth(){return this.source.getSize(_f).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){V(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];r===void 0?V(`Texture.setValues(): property '${t}' does not exist.`):r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e==`string`;if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:`Texture`,generator:`Texture.toJSON`},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:`dispose`})}transformUv(e){if(this.mapping!==300)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Vl:e.x-=Math.floor(e.x);break;case Hl:e.x=e.x<0?0:1;break;case Ul:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x-=Math.floor(e.x)}if(e.y<0||e.y>1)switch(this.wrapT){case Vl:e.y-=Math.floor(e.y);break;case Hl:e.y=e.y<0?0:1;break;case Ul:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y-=Math.floor(e.y)}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};vf.DEFAULT_IMAGE=null,vf.DEFAULT_MAPPING=300,vf.DEFAULT_ANISOTROPY=1;var yf=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw Error(`THREE.Vector4: index is out of range: `+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw Error(`THREE.Vector4: index is out of range: `+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w===void 0?1:e.w,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,i=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*r+a[12]*i,this.y=a[1]*t+a[5]*n+a[9]*r+a[13]*i,this.z=a[2]*t+a[6]*n+a[10]*r+a[14]*i,this.w=a[3]*t+a[7]*n+a[11]*r+a[15]*i,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,i,a=.01,o=.1,s=e.elements,c=s[0],l=s[4],u=s[8],d=s[1],f=s[5],p=s[9],m=s[2],h=s[6],g=s[10];if(Math.abs(l-d)<a&&Math.abs(u-m)<a&&Math.abs(p-h)<a){if(Math.abs(l+d)<o&&Math.abs(u+m)<o&&Math.abs(p+h)<o&&Math.abs(c+f+g-3)<o)return this.set(1,0,0,0),this;t=Math.PI;let e=(c+1)/2,s=(f+1)/2,_=(g+1)/2,v=(l+d)/4,y=(u+m)/4,b=(p+h)/4;return e>s&&e>_?e<a?(n=0,r=.707106781,i=.707106781):(n=Math.sqrt(e),r=v/n,i=y/n):s>_?s<a?(n=.707106781,r=0,i=.707106781):(r=Math.sqrt(s),n=v/r,i=b/r):_<a?(n=.707106781,r=.707106781,i=0):(i=Math.sqrt(_),n=y/i,r=b/i),this.set(n,r,i,t),this}let _=Math.sqrt((h-p)*(h-p)+(u-m)*(u-m)+(d-l)*(d-l));return Math.abs(_)<.001&&(_=1),this.x=(h-p)/_,this.y=(u-m)/_,this.z=(d-l)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=U(this.x,e.x,t.x),this.y=U(this.y,e.y,t.y),this.z=U(this.z,e.z,t.z),this.w=U(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=U(this.x,e,t),this.y=U(this.y,e,t),this.z=U(this.z,e,t),this.w=U(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(U(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},bf=class extends Dd{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ql,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new yf(0,0,e,t),this.scissorTest=!1,this.viewport=new yf(0,0,e,t),this.textures=[];let r=n.count;for(let i=0;i<r;i++)this.textures[i]=new vf({width:e,height:t,depth:n.depth}),this.textures[i].isRenderTargetTexture=!0,this.textures[i].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ql,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let e=0;e<this.textures.length;e++)this.textures[e].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,i=this.textures.length;r<i;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let n=Object.assign({},e.textures[t].image);this.textures[t].source=new mf(n)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null){if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture}else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:`dispose`})}},xf=class extends bf{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Sf=class extends vf{constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Wl,this.minFilter=Wl,this.wrapR=Hl,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}},Cf=class extends vf{constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Wl,this.minFilter=Wl,this.wrapR=Hl,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}},J=class e{static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,i,a,o,s,c,l,u,d,f,p,m,h){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,i,a,o,s,c,l,u,d,f,p,m,h)}set(e,t,n,r,i,a,o,s,c,l,u,d,f,p,m,h){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=r,g[1]=i,g[5]=a,g[9]=o,g[13]=s,g[2]=c,g[6]=l,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=m,g[15]=h,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new e().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/wf.setFromMatrixColumn(e,0).length(),i=1/wf.setFromMatrixColumn(e,1).length(),a=1/wf.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*i,t[5]=n[5]*i,t[6]=n[6]*i,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,i=e.z,a=Math.cos(n),o=Math.sin(n),s=Math.cos(r),c=Math.sin(r),l=Math.cos(i),u=Math.sin(i);if(e.order===`XYZ`){let e=a*l,n=a*u,r=o*l,i=o*u;t[0]=s*l,t[4]=-s*u,t[8]=c,t[1]=n+r*c,t[5]=e-i*c,t[9]=-o*s,t[2]=i-e*c,t[6]=r+n*c,t[10]=a*s}else if(e.order===`YXZ`){let e=s*l,n=s*u,r=c*l,i=c*u;t[0]=e+i*o,t[4]=r*o-n,t[8]=a*c,t[1]=a*u,t[5]=a*l,t[9]=-o,t[2]=n*o-r,t[6]=i+e*o,t[10]=a*s}else if(e.order===`ZXY`){let e=s*l,n=s*u,r=c*l,i=c*u;t[0]=e-i*o,t[4]=-a*u,t[8]=r+n*o,t[1]=n+r*o,t[5]=a*l,t[9]=i-e*o,t[2]=-a*c,t[6]=o,t[10]=a*s}else if(e.order===`ZYX`){let e=a*l,n=a*u,r=o*l,i=o*u;t[0]=s*l,t[4]=r*c-n,t[8]=e*c+i,t[1]=s*u,t[5]=i*c+e,t[9]=n*c-r,t[2]=-c,t[6]=o*s,t[10]=a*s}else if(e.order===`YZX`){let e=a*s,n=a*c,r=o*s,i=o*c;t[0]=s*l,t[4]=i-e*u,t[8]=r*u+n,t[1]=u,t[5]=a*l,t[9]=-o*l,t[2]=-c*l,t[6]=n*u+r,t[10]=e-i*u}else if(e.order===`XZY`){let e=a*s,n=a*c,r=o*s,i=o*c;t[0]=s*l,t[4]=-u,t[8]=c*l,t[1]=e*u+i,t[5]=a*l,t[9]=n*u-r,t[2]=r*u-n,t[6]=o*l,t[10]=i*u+e}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Ef,e,Df)}lookAt(e,t,n){let r=this.elements;return Af.subVectors(e,t),Af.lengthSq()===0&&(Af.z=1),Af.normalize(),Of.crossVectors(n,Af),Of.lengthSq()===0&&(Math.abs(n.z)===1?Af.x+=1e-4:Af.z+=1e-4,Af.normalize(),Of.crossVectors(n,Af)),Of.normalize(),kf.crossVectors(Af,Of),r[0]=Of.x,r[4]=kf.x,r[8]=Af.x,r[1]=Of.y,r[5]=kf.y,r[9]=Af.y,r[2]=Of.z,r[6]=kf.z,r[10]=Af.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,i=this.elements,a=n[0],o=n[4],s=n[8],c=n[12],l=n[1],u=n[5],d=n[9],f=n[13],p=n[2],m=n[6],h=n[10],g=n[14],_=n[3],v=n[7],y=n[11],b=n[15],x=r[0],S=r[4],C=r[8],w=r[12],T=r[1],E=r[5],D=r[9],O=r[13],k=r[2],A=r[6],j=r[10],M=r[14],N=r[3],ee=r[7],te=r[11],P=r[15];return i[0]=a*x+o*T+s*k+c*N,i[4]=a*S+o*E+s*A+c*ee,i[8]=a*C+o*D+s*j+c*te,i[12]=a*w+o*O+s*M+c*P,i[1]=l*x+u*T+d*k+f*N,i[5]=l*S+u*E+d*A+f*ee,i[9]=l*C+u*D+d*j+f*te,i[13]=l*w+u*O+d*M+f*P,i[2]=p*x+m*T+h*k+g*N,i[6]=p*S+m*E+h*A+g*ee,i[10]=p*C+m*D+h*j+g*te,i[14]=p*w+m*O+h*M+g*P,i[3]=_*x+v*T+y*k+b*N,i[7]=_*S+v*E+y*A+b*ee,i[11]=_*C+v*D+y*j+b*te,i[15]=_*w+v*O+y*M+b*P,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],i=e[12],a=e[1],o=e[5],s=e[9],c=e[13],l=e[2],u=e[6],d=e[10],f=e[14],p=e[3],m=e[7],h=e[11],g=e[15],_=s*f-c*d,v=o*f-c*u,y=o*d-s*u,b=a*f-c*l,x=a*d-s*l,S=a*u-o*l;return t*(m*_-h*v+g*y)-n*(p*_-h*b+g*x)+r*(p*v-m*b+g*S)-i*(p*y-m*x+h*S)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],i=e[1],a=e[5],o=e[9],s=e[2],c=e[6],l=e[10];return t*(a*l-o*c)-n*(i*l-o*s)+r*(i*c-a*s)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],i=e[3],a=e[4],o=e[5],s=e[6],c=e[7],l=e[8],u=e[9],d=e[10],f=e[11],p=e[12],m=e[13],h=e[14],g=e[15],_=t*o-n*a,v=t*s-r*a,y=t*c-i*a,b=n*s-r*o,x=n*c-i*o,S=r*c-i*s,C=l*m-u*p,w=l*h-d*p,T=l*g-f*p,E=u*h-d*m,D=u*g-f*m,O=d*g-f*h,k=_*O-v*D+y*E+b*T-x*w+S*C;if(k===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let A=1/k;return e[0]=(o*O-s*D+c*E)*A,e[1]=(r*D-n*O-i*E)*A,e[2]=(m*S-h*x+g*b)*A,e[3]=(d*x-u*S-f*b)*A,e[4]=(s*T-a*O-c*w)*A,e[5]=(t*O-r*T+i*w)*A,e[6]=(h*y-p*S-g*v)*A,e[7]=(l*S-d*y+f*v)*A,e[8]=(a*D-o*T+c*C)*A,e[9]=(n*T-t*D-i*C)*A,e[10]=(p*x-m*y+g*_)*A,e[11]=(u*y-l*x-f*_)*A,e[12]=(o*w-a*E-s*C)*A,e[13]=(t*E-n*w+r*C)*A,e[14]=(m*v-p*b-h*_)*A,e[15]=(l*b-u*v+d*_)*A,this}scale(e){let t=this.elements,n=e.x,r=e.y,i=e.z;return t[0]*=n,t[4]*=r,t[8]*=i,t[1]*=n,t[5]*=r,t[9]*=i,t[2]*=n,t[6]*=r,t[10]*=i,t[3]*=n,t[7]*=r,t[11]*=i,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),i=1-n,a=e.x,o=e.y,s=e.z,c=i*a,l=i*o;return this.set(c*a+n,c*o-r*s,c*s+r*o,0,c*o+r*s,l*o+n,l*s-r*a,0,c*s-r*o,l*s+r*a,i*s*s+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,i,a){return this.set(1,n,i,0,e,1,a,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,i=t._x,a=t._y,o=t._z,s=t._w,c=i+i,l=a+a,u=o+o,d=i*c,f=i*l,p=i*u,m=a*l,h=a*u,g=o*u,_=s*c,v=s*l,y=s*u,b=n.x,x=n.y,S=n.z;return r[0]=(1-(m+g))*b,r[1]=(f+y)*b,r[2]=(p-v)*b,r[3]=0,r[4]=(f-y)*x,r[5]=(1-(d+g))*x,r[6]=(h+_)*x,r[7]=0,r[8]=(p+v)*S,r[9]=(h-_)*S,r[10]=(1-(d+m))*S,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let i=this.determinantAffine();if(i===0)return n.set(1,1,1),t.identity(),this;let a=wf.set(r[0],r[1],r[2]).length(),o=wf.set(r[4],r[5],r[6]).length(),s=wf.set(r[8],r[9],r[10]).length();i<0&&(a=-a),Tf.copy(this);let c=1/a,l=1/o,u=1/s;return Tf.elements[0]*=c,Tf.elements[1]*=c,Tf.elements[2]*=c,Tf.elements[4]*=l,Tf.elements[5]*=l,Tf.elements[6]*=l,Tf.elements[8]*=u,Tf.elements[9]*=u,Tf.elements[10]*=u,t.setFromRotationMatrix(Tf),n.x=a,n.y=o,n.z=s,this}makePerspective(e,t,n,r,i,a,o=gd,s=!1){let c=this.elements,l=2*i/(t-e),u=2*i/(n-r),d=(t+e)/(t-e),f=(n+r)/(n-r),p,m;if(s)p=i/(a-i),m=a*i/(a-i);else if(o===2e3)p=-(a+i)/(a-i),m=-2*a*i/(a-i);else if(o===2001)p=-a/(a-i),m=-a*i/(a-i);else throw Error(`THREE.Matrix4.makePerspective(): Invalid coordinate system: `+o);return c[0]=l,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=m,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,r,i,a,o=gd,s=!1){let c=this.elements,l=2/(t-e),u=2/(n-r),d=-(t+e)/(t-e),f=-(n+r)/(n-r),p,m;if(s)p=1/(a-i),m=a/(a-i);else if(o===2e3)p=-2/(a-i),m=-(a+i)/(a-i);else if(o===2001)p=-1/(a-i),m=-i/(a-i);else throw Error(`THREE.Matrix4.makeOrthographic(): Invalid coordinate system: `+o);return c[0]=l,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=m,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let e=0;e<16;e++)if(t[e]!==n[e])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},wf=new G,Tf=new J,Ef=new G(0,0,0),Df=new G(1,1,1),Of=new G,kf=new G,Af=new G,jf=new J,Mf=new tf,Nf=class e{constructor(t=0,n=0,r=0,i=e.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=n,this._z=r,this._order=i}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,i=r[0],a=r[4],o=r[8],s=r[1],c=r[5],l=r[9],u=r[2],d=r[6],f=r[10];switch(t){case`XYZ`:this._y=Math.asin(U(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-l,f),this._z=Math.atan2(-a,i)):(this._x=Math.atan2(d,c),this._z=0);break;case`YXZ`:this._x=Math.asin(-U(l,-1,1)),Math.abs(l)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(s,c)):(this._y=Math.atan2(-u,i),this._z=0);break;case`ZXY`:this._x=Math.asin(U(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(s,i));break;case`ZYX`:this._y=Math.asin(-U(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(s,i)):(this._x=0,this._z=Math.atan2(-a,c));break;case`YZX`:this._z=Math.asin(U(s,-1,1)),Math.abs(s)<.9999999?(this._x=Math.atan2(-l,c),this._y=Math.atan2(-u,i)):(this._x=0,this._y=Math.atan2(o,f));break;case`XZY`:this._z=Math.asin(-U(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(o,i)):(this._x=Math.atan2(-l,f),this._y=0);break;default:V(`Euler: .setFromRotationMatrix() encountered an unknown order: `+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return jf.makeRotationFromQuaternion(e),this.setFromRotationMatrix(jf,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Mf.setFromEuler(this),this.setFromQuaternion(Mf,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Nf.DEFAULT_ORDER=`XYZ`;var Pf=class{constructor(){this.mask=1}set(e){this.mask=1<<e>>>0}enable(e){this.mask|=1<<e}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e}disable(e){this.mask&=~(1<<e)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return!!(this.mask&1<<e)}},Ff=0,If=new G,Lf=new tf,Rf=new J,zf=new G,Bf=new G,Vf=new G,Hf=new tf,Uf=new G(1,0,0),Wf=new G(0,1,0),Gf=new G(0,0,1),Kf={type:`added`},qf={type:`removed`},Jf={type:`childadded`,child:null},Yf={type:`childremoved`,child:null},Xf=class e extends Dd{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ff++}),this.uuid=Md(),this.name=``,this.type=`Object3D`,this.parent=null,this.children=[],this.up=e.DEFAULT_UP.clone();let t=new G,n=new Nf,r=new tf,i=new G(1,1,1);function a(){r.setFromEuler(n,!1)}function o(){n.setFromQuaternion(r,void 0,!1)}n._onChange(a),r._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:n},quaternion:{configurable:!0,enumerable:!0,value:r},scale:{configurable:!0,enumerable:!0,value:i},modelViewMatrix:{value:new J},normalMatrix:{value:new K}}),this.matrix=new J,this.matrixWorld=new J,this.matrixAutoUpdate=e.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=e.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Pf,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Lf.setFromAxisAngle(e,t),this.quaternion.multiply(Lf),this}rotateOnWorldAxis(e,t){return Lf.setFromAxisAngle(e,t),this.quaternion.premultiply(Lf),this}rotateX(e){return this.rotateOnAxis(Uf,e)}rotateY(e){return this.rotateOnAxis(Wf,e)}rotateZ(e){return this.rotateOnAxis(Gf,e)}translateOnAxis(e,t){return If.copy(e).applyQuaternion(this.quaternion),this.position.add(If.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Uf,e)}translateY(e){return this.translateOnAxis(Wf,e)}translateZ(e){return this.translateOnAxis(Gf,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Rf.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?zf.copy(e):zf.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),Bf.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Rf.lookAt(Bf,zf,this.up):Rf.lookAt(zf,Bf,this.up),this.quaternion.setFromRotationMatrix(Rf),r&&(Rf.extractRotation(r.matrixWorld),Lf.setFromRotationMatrix(Rf),this.quaternion.premultiply(Lf.invert()))}add(e){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return e===this?(H(`Object3D.add: object can't be added as a child of itself.`,e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Kf),Jf.child=e,this.dispatchEvent(Jf),Jf.child=null):H(`Object3D.add: object not an instance of THREE.Object3D.`,e),this)}remove(e){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.remove(arguments[e]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(qf),Yf.child=e,this.dispatchEvent(Yf),Yf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Rf.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Rf.multiply(e.parent.matrixWorld)),e.applyMatrix4(Rf),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Kf),Jf.child=e,this.dispatchEvent(Jf),Jf.child=null,this}getObjectById(e){return this.getObjectByProperty(`id`,e)}getObjectByName(e){return this.getObjectByProperty(`name`,e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let r=this.children[n].getObjectByProperty(e,t);if(r!==void 0)return r}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let i=0,a=r.length;i<a;i++)r[i].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Bf,e,Vf),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Bf,Hf,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,i=this.matrix.elements;i[12]+=t-i[0]*t-i[4]*n-i[8]*r,i[13]+=n-i[1]*t-i[5]*n-i[9]*r,i[14]+=r-i[2]*t-i[6]*n-i[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let e=this.children;for(let t=0,r=e.length;t<r;t++)e[t].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e==`string`,n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:`Object`,generator:`Object3D.toJSON`});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type=`InstancedMesh`,r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type=`BatchedMesh`,r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(e=>({...e,boundingBox:e.boundingBox?e.boundingBox.toJSON():void 0,boundingSphere:e.boundingSphere?e.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(e=>({...e})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function i(t,n){return t[n.uuid]===void 0&&(t[n.uuid]=n.toJSON(e)),n.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=i(e.geometries,this.geometry);let t=this.geometry.parameters;if(t!==void 0&&t.shapes!==void 0){let n=t.shapes;if(Array.isArray(n))for(let t=0,r=n.length;t<r;t++){let r=n[t];i(e.shapes,r)}else i(e.shapes,n)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(i(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0){if(Array.isArray(this.material)){let t=[];for(let n=0,r=this.material.length;n<r;n++)t.push(i(e.materials,this.material[n]));r.material=t}else r.material=i(e.materials,this.material)}if(this.children.length>0){r.children=[];for(let t=0;t<this.children.length;t++)r.children.push(this.children[t].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let t=0;t<this.animations.length;t++){let n=this.animations[t];r.animations.push(i(e.animations,n))}}if(t){let t=a(e.geometries),r=a(e.materials),i=a(e.textures),o=a(e.images),s=a(e.shapes),c=a(e.skeletons),l=a(e.animations),u=a(e.nodes);t.length>0&&(n.geometries=t),r.length>0&&(n.materials=r),i.length>0&&(n.textures=i),o.length>0&&(n.images=o),s.length>0&&(n.shapes=s),c.length>0&&(n.skeletons=c),l.length>0&&(n.animations=l),u.length>0&&(n.nodes=u)}return n.object=r,n;function a(e){let t=[];for(let n in e){let r=e[n];delete r.metadata,t.push(r)}return t}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot===null?null:e.pivot.clone(),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let t=0;t<e.children.length;t++){let n=e.children[t];this.add(n.clone())}return this}dispose(){this.dispatchEvent({type:`dispose`})}};Xf.DEFAULT_UP=new G(0,1,0),Xf.DEFAULT_MATRIX_AUTO_UPDATE=!0,Xf.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Zf=class extends Xf{constructor(){super(),this.isGroup=!0,this.type=`Group`}},Qf={type:`move`},$f=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Zf,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Zf,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Zf,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:`connected`,data:e}),this}disconnect(e){return this.dispatchEvent({type:`disconnected`,data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,i=null,a=null,o=this._targetRay,s=this._grip,c=this._hand;if(e&&t.session.visibilityState!==`visible-blurred`){if(c&&e.hand){a=!0;for(let r of e.hand.values()){let e=t.getJointPose(r,n),i=this._getHandJoint(c,r);e!==null&&(i.matrix.fromArray(e.transform.matrix),i.matrix.decompose(i.position,i.quaternion,i.scale),i.matrixWorldNeedsUpdate=!0,i.jointRadius=e.radius),i.visible=e!==null}let r=c.joints[`index-finger-tip`],i=c.joints[`thumb-tip`],o=r.position.distanceTo(i.position);c.inputState.pinching&&o>.025?(c.inputState.pinching=!1,this.dispatchEvent({type:`pinchend`,handedness:e.handedness,target:this})):!c.inputState.pinching&&o<=.015&&(c.inputState.pinching=!0,this.dispatchEvent({type:`pinchstart`,handedness:e.handedness,target:this}))}else s!==null&&e.gripSpace&&(i=t.getPose(e.gripSpace,n),i!==null&&(s.matrix.fromArray(i.transform.matrix),s.matrix.decompose(s.position,s.quaternion,s.scale),s.matrixWorldNeedsUpdate=!0,i.linearVelocity?(s.hasLinearVelocity=!0,s.linearVelocity.copy(i.linearVelocity)):s.hasLinearVelocity=!1,i.angularVelocity?(s.hasAngularVelocity=!0,s.angularVelocity.copy(i.angularVelocity)):s.hasAngularVelocity=!1,s.eventsEnabled&&s.dispatchEvent({type:`gripUpdated`,data:e,target:this})));o!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&i!==null&&(r=i),r!==null&&(o.matrix.fromArray(r.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,r.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(r.linearVelocity)):o.hasLinearVelocity=!1,r.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(r.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(Qf)))}return o!==null&&(o.visible=r!==null),s!==null&&(s.visible=i!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Zf;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},ep={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},tp={h:0,s:0,l:0},np={h:0,s:0,l:0};function rp(e,t,n){return n<0&&(n+=1),n>1&&--n,n<1/6?e+(t-e)*6*n:n<1/2?t:n<2/3?e+(t-e)*6*(2/3-n):e}var Y=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let t=e;t&&t.isColor?this.copy(t):typeof t==`number`?this.setHex(t):typeof t==`string`&&this.setStyle(t)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ld){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,q.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=q.workingColorSpace){return this.r=e,this.g=t,this.b=n,q.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=q.workingColorSpace){if(e=Nd(e,1),t=U(t,0,1),n=U(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,i=2*n-r;this.r=rp(i,r,e+1/3),this.g=rp(i,r,e),this.b=rp(i,r,e-1/3)}return q.colorSpaceToWorking(this,r),this}setStyle(e,t=ld){function n(t){t!==void 0&&parseFloat(t)<1&&V(`Color: Alpha component of `+e+` will be ignored.`)}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let i,a=r[1],o=r[2];switch(a){case`rgb`:case`rgba`:if(i=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(i[4]),this.setRGB(Math.min(255,parseInt(i[1],10))/255,Math.min(255,parseInt(i[2],10))/255,Math.min(255,parseInt(i[3],10))/255,t);if(i=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(i[4]),this.setRGB(Math.min(100,parseFloat(i[1]))/100,Math.min(100,parseFloat(i[2]))/100,Math.min(100,parseFloat(i[3]))/100,t);break;case`hsl`:case`hsla`:if(i=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(i[4]),this.setHSL(parseFloat(i[1])/360,parseFloat(i[2])/100,parseFloat(i[3])/100,t);break;default:V(`Color: Unknown color model `+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let n=r[1],i=n.length;if(i===3)return this.setRGB(parseInt(n.charAt(0),16)/15,parseInt(n.charAt(1),16)/15,parseInt(n.charAt(2),16)/15,t);if(i===6)return this.setHex(parseInt(n,16),t);V(`Color: Invalid hex color `+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ld){let n=ep[e.toLowerCase()];return n===void 0?V(`Color: Unknown color `+e):this.setHex(n,t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=lf(e.r),this.g=lf(e.g),this.b=lf(e.b),this}copyLinearToSRGB(e){return this.r=uf(e.r),this.g=uf(e.g),this.b=uf(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ld){return q.workingToColorSpace(ip.copy(this),e),Math.round(U(ip.r*255,0,255))*65536+Math.round(U(ip.g*255,0,255))*256+Math.round(U(ip.b*255,0,255))}getHexString(e=ld){return(`000000`+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=q.workingColorSpace){q.workingToColorSpace(ip.copy(this),t);let n=ip.r,r=ip.g,i=ip.b,a=Math.max(n,r,i),o=Math.min(n,r,i),s,c,l=(o+a)/2;if(o===a)s=0,c=0;else{let e=a-o;switch(c=l<=.5?e/(a+o):e/(2-a-o),a){case n:s=(r-i)/e+(r<i?6:0);break;case r:s=(i-n)/e+2;break;case i:s=(n-r)/e+4}s/=6}return e.h=s,e.s=c,e.l=l,e}getRGB(e,t=q.workingColorSpace){return q.workingToColorSpace(ip.copy(this),t),e.r=ip.r,e.g=ip.g,e.b=ip.b,e}getStyle(e=ld){q.workingToColorSpace(ip.copy(this),e);let t=ip.r,n=ip.g,r=ip.b;return e===`srgb`?`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`:`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`}offsetHSL(e,t,n){return this.getHSL(tp),this.setHSL(tp.h+e,tp.s+t,tp.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(tp),e.getHSL(np);let n=Id(tp.h,np.h,t),r=Id(tp.s,np.s,t),i=Id(tp.l,np.l,t);return this.setHSL(n,r,i),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,i=e.elements;return this.r=i[0]*t+i[3]*n+i[6]*r,this.g=i[1]*t+i[4]*n+i[7]*r,this.b=i[2]*t+i[5]*n+i[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ip=new Y;Y.NAMES=ep;var ap=class e{constructor(e,t=1,n=1e3){this.isFog=!0,this.name=``,this.color=new Y(e),this.near=t,this.far=n}clone(){return new e(this.color,this.near,this.far)}toJSON(){return{type:`Fog`,name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},op=class extends Xf{constructor(){super(),this.isScene=!0,this.type=`Scene`,this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Nf,this.environmentIntensity=1,this.environmentRotation=new Nf,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<`u`&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent(`observe`,{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background===null?null:e.background.clone(),this.environment=e.environment===null?null:e.environment.clone(),this.fog=e.fog===null?null:e.fog.clone(),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial===null?null:e.overrideMaterial.clone(),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},sp=new G,cp=new G,lp=new G,up=new G,dp=new G,fp=new G,pp=new G,mp=new G,hp=new G,gp=new G,_p=new yf,vp=new yf,yp=new yf,bp=class e{constructor(e=new G,t=new G,n=new G){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),sp.subVectors(e,t),r.cross(sp);let i=r.lengthSq();return i>0?r.multiplyScalar(1/Math.sqrt(i)):r.set(0,0,0)}static getBarycoord(e,t,n,r,i){sp.subVectors(r,t),cp.subVectors(n,t),lp.subVectors(e,t);let a=sp.dot(sp),o=sp.dot(cp),s=sp.dot(lp),c=cp.dot(cp),l=cp.dot(lp),u=a*c-o*o;if(u===0)return i.set(0,0,0),null;let d=1/u,f=(c*s-o*l)*d,p=(a*l-o*s)*d;return i.set(1-f-p,p,f)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,up)!==null&&up.x>=0&&up.y>=0&&up.x+up.y<=1}static getInterpolation(e,t,n,r,i,a,o,s){return this.getBarycoord(e,t,n,r,up)===null?(s.x=0,s.y=0,`z`in s&&(s.z=0),`w`in s&&(s.w=0),null):(s.setScalar(0),s.addScaledVector(i,up.x),s.addScaledVector(a,up.y),s.addScaledVector(o,up.z),s)}static getInterpolatedAttribute(e,t,n,r,i,a){return _p.setScalar(0),vp.setScalar(0),yp.setScalar(0),_p.fromBufferAttribute(e,t),vp.fromBufferAttribute(e,n),yp.fromBufferAttribute(e,r),a.setScalar(0),a.addScaledVector(_p,i.x),a.addScaledVector(vp,i.y),a.addScaledVector(yp,i.z),a}static isFrontFacing(e,t,n,r){return sp.subVectors(n,t),cp.subVectors(e,t),sp.cross(cp).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return sp.subVectors(this.c,this.b),cp.subVectors(this.a,this.b),sp.cross(cp).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return e.getNormal(this.a,this.b,this.c,t)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,n){return e.getBarycoord(t,this.a,this.b,this.c,n)}getInterpolation(t,n,r,i,a){return e.getInterpolation(t,this.a,this.b,this.c,n,r,i,a)}containsPoint(t){return e.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return e.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,i=this.c,a,o;dp.subVectors(r,n),fp.subVectors(i,n),mp.subVectors(e,n);let s=dp.dot(mp),c=fp.dot(mp);if(s<=0&&c<=0)return t.copy(n);hp.subVectors(e,r);let l=dp.dot(hp),u=fp.dot(hp);if(l>=0&&u<=l)return t.copy(r);let d=s*u-l*c;if(d<=0&&s>=0&&l<=0&&s-l>0)return a=s/(s-l),t.copy(n).addScaledVector(dp,a);gp.subVectors(e,i);let f=dp.dot(gp),p=fp.dot(gp);if(p>=0&&f<=p)return t.copy(i);let m=f*c-s*p;if(m<=0&&c>=0&&p<=0)return o=c/(c-p),t.copy(n).addScaledVector(fp,o);let h=l*p-f*u;if(h<=0&&u-l>=0&&f-p>=0)return pp.subVectors(i,r),o=(u-l)/(u-l+(f-p)),t.copy(r).addScaledVector(pp,o);let g=1/(h+m+d);return a=m*g,o=d*g,t.copy(n).addScaledVector(dp,a).addScaledVector(fp,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},xp=class{constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Cp.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Cp.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Cp.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute(`position`);if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let t=0,n=r.count;t<n;t++)e.isMesh===!0?e.getVertexPosition(t,Cp):Cp.fromBufferAttribute(r,t),Cp.applyMatrix4(e.matrixWorld),this.expandByPoint(Cp);else e.boundingBox===void 0?(n.boundingBox===null&&n.computeBoundingBox(),wp.copy(n.boundingBox)):(e.boundingBox===null&&e.computeBoundingBox(),wp.copy(e.boundingBox)),wp.applyMatrix4(e.matrixWorld),this.union(wp)}let r=e.children;for(let e=0,n=r.length;e<n;e++)this.expandByObject(r[e],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Cp),Cp.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(jp),Mp.subVectors(this.max,jp),Tp.subVectors(e.a,jp),Ep.subVectors(e.b,jp),Dp.subVectors(e.c,jp),Op.subVectors(Ep,Tp),kp.subVectors(Dp,Ep),Ap.subVectors(Tp,Dp);let t=[0,-Op.z,Op.y,0,-kp.z,kp.y,0,-Ap.z,Ap.y,Op.z,0,-Op.x,kp.z,0,-kp.x,Ap.z,0,-Ap.x,-Op.y,Op.x,0,-kp.y,kp.x,0,-Ap.y,Ap.x,0];return!Fp(t,Tp,Ep,Dp,Mp)||(t=[1,0,0,0,1,0,0,0,1],!Fp(t,Tp,Ep,Dp,Mp))?!1:(Np.crossVectors(Op,kp),t=[Np.x,Np.y,Np.z],Fp(t,Tp,Ep,Dp,Mp))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Cp).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Cp).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()||(Sp[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Sp[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Sp[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Sp[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Sp[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Sp[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Sp[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Sp[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Sp)),this}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Sp=[new G,new G,new G,new G,new G,new G,new G,new G],Cp=new G,wp=new xp,Tp=new G,Ep=new G,Dp=new G,Op=new G,kp=new G,Ap=new G,jp=new G,Mp=new G,Np=new G,Pp=new G;function Fp(e,t,n,r,i){for(let a=0,o=e.length-3;a<=o;a+=3){Pp.fromArray(e,a);let o=i.x*Math.abs(Pp.x)+i.y*Math.abs(Pp.y)+i.z*Math.abs(Pp.z),s=t.dot(Pp),c=n.dot(Pp),l=r.dot(Pp);if(Math.max(-Math.max(s,c,l),Math.min(s,c,l))>o)return!1}return!0}var Ip=new G,Lp=new W,Rp=0,zp=class extends Dd{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw TypeError(`THREE.BufferAttribute: array should be a Typed Array.`);this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Rp++}),this.name=``,this.array=e,this.itemSize=t,this.count=e===void 0?0:e.length/t,this.normalized=n,this.usage=md,this.updateRanges=[],this.gpuType=nu,this.version=0,this._normalizationScale=e===void 0?void 0:Zd(e)}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,i=this.itemSize;r<i;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Lp.fromBufferAttribute(this,t),Lp.applyMatrix3(e),this.setXY(t,Lp.x,Lp.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Ip.fromBufferAttribute(this,t),Ip.applyMatrix3(e),this.setXYZ(t,Ip.x,Ip.y,Ip.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Ip.fromBufferAttribute(this,t),Ip.applyMatrix4(e),this.setXYZ(t,Ip.x,Ip.y,Ip.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Ip.fromBufferAttribute(this,t),Ip.applyNormalMatrix(e),this.setXYZ(t,Ip.x,Ip.y,Ip.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Ip.fromBufferAttribute(this,t),Ip.transformDirection(e),this.setXYZ(t,Ip.x,Ip.y,Ip.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=i,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:`dispose`})}_denormalize(e){let t=this._normalizationScale;return t===void 0?Qd(e,this.array):Math.max(e/t,-1)}_normalize(e){let t=this._normalizationScale;return t===void 0?$d(e,this.array):Math.round(e*t)}},Bp=class extends zp{constructor(e,t,n){super(new Uint16Array(e),t,n)}},Vp=class extends zp{constructor(e,t,n){super(new Uint32Array(e),t,n)}},Hp=class extends zp{constructor(e,t,n){super(new Float32Array(e),t,n)}},Up=new xp,Wp=new G,Gp=new G,Kp=class{constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t===void 0?Up.setFromPoints(e).getCenter(n):n.copy(t);let r=0;for(let t=0,i=e.length;t<i;t++)r=Math.max(r,n.distanceToSquared(e[t]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius*=e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Wp.subVectors(e,this.center);let t=Wp.lengthSq();if(t>this.radius*this.radius){let e=Math.sqrt(t),n=(e-this.radius)*.5;this.center.addScaledVector(Wp,n/e),this.radius+=n}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Gp.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Wp.copy(e.center).add(Gp)),this.expandByPoint(Wp.copy(e.center).sub(Gp))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},qp=0,Jp=new J,Yp=new Xf,Xp=new G,Zp=new xp,Qp=new xp,$p=new G,em=class e extends Dd{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:qp++}),this.uuid=Md(),this.name=``,this.type=`BufferGeometry`,this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return this.index=Array.isArray(e)?new(_d(e)?Vp:Bp)(e,1):e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let t=new K().getNormalMatrix(e);n.applyNormalMatrix(t),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Jp.makeRotationFromQuaternion(e),this.applyMatrix4(Jp),this}rotateX(e){return Jp.makeRotationX(e),this.applyMatrix4(Jp),this}rotateY(e){return Jp.makeRotationY(e),this.applyMatrix4(Jp),this}rotateZ(e){return Jp.makeRotationZ(e),this.applyMatrix4(Jp),this}translate(e,t,n){return Jp.makeTranslation(e,t,n),this.applyMatrix4(Jp),this}scale(e,t,n){return Jp.makeScale(e,t,n),this.applyMatrix4(Jp),this}lookAt(e){return Yp.lookAt(e),Yp.updateMatrix(),this.applyMatrix4(Yp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Xp).negate(),this.translate(Xp.x,Xp.y,Xp.z),this}setFromPoints(e){let t=this.getAttribute(`position`);if(t===void 0){let t=[];for(let n=0,r=e.length;n<r;n++){let r=e[n];t.push(r.x,r.y,r.z||0)}this.setAttribute(`position`,new Hp(t,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let n=e[r];t.setXYZ(r,n.x,n.y,n.z||0)}e.length>t.count&&V(`BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry.`),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xp);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute)H(`BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.`,this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));else{if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let e=0,n=t.length;e<n;e++){let n=t[e];Zp.setFromBufferAttribute(n),this.morphTargetsRelative?($p.addVectors(this.boundingBox.min,Zp.min),this.boundingBox.expandByPoint($p),$p.addVectors(this.boundingBox.max,Zp.max),this.boundingBox.expandByPoint($p)):(this.boundingBox.expandByPoint(Zp.min),this.boundingBox.expandByPoint(Zp.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&H(`BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.`,this)}}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Kp);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute)H(`BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.`,this),this.boundingSphere.set(new G,1/0);else if(e){let n=this.boundingSphere.center;if(Zp.setFromBufferAttribute(e),t)for(let e=0,n=t.length;e<n;e++){let n=t[e];Qp.setFromBufferAttribute(n),this.morphTargetsRelative?($p.addVectors(Zp.min,Qp.min),Zp.expandByPoint($p),$p.addVectors(Zp.max,Qp.max),Zp.expandByPoint($p)):(Zp.expandByPoint(Qp.min),Zp.expandByPoint(Qp.max))}Zp.getCenter(n);let r=0;for(let t=0,i=e.count;t<i;t++)$p.fromBufferAttribute(e,t),r=Math.max(r,n.distanceToSquared($p));if(t)for(let i=0,a=t.length;i<a;i++){let a=t[i],o=this.morphTargetsRelative;for(let t=0,i=a.count;t<i;t++)$p.fromBufferAttribute(a,t),o&&(Xp.fromBufferAttribute(e,t),$p.add(Xp)),r=Math.max(r,n.distanceToSquared($p))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&H(`BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.`,this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){H(`BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)`);return}let n=t.position,r=t.normal,i=t.uv,a=this.getAttribute(`tangent`);(a===void 0||a.count!==n.count)&&(a=new zp(new Float32Array(4*n.count),4),this.setAttribute(`tangent`,a));let o=[],s=[],c=new Uint8Array(n.count);for(let e=0;e<n.count;e++)o[e]=new G,s[e]=new G;let l=new G,u=new G,d=new G,f=new W,p=new W,m=new W,h=new G,g=new G;function _(e,t,r){c[e]=c[t]=c[r]=1,l.fromBufferAttribute(n,e),u.fromBufferAttribute(n,t),d.fromBufferAttribute(n,r),f.fromBufferAttribute(i,e),p.fromBufferAttribute(i,t),m.fromBufferAttribute(i,r),u.sub(l),d.sub(l),p.sub(f),m.sub(f);let a=1/(p.x*m.y-m.x*p.y);isFinite(a)&&(h.copy(u).multiplyScalar(m.y).addScaledVector(d,-p.y).multiplyScalar(a),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-m.x).multiplyScalar(a),o[e].add(h),o[t].add(h),o[r].add(h),s[e].add(g),s[t].add(g),s[r].add(g))}let v=this.groups;v.length===0&&(v=[{start:0,count:e.count}]);for(let t=0,n=v.length;t<n;++t){let n=v[t],r=n.start,i=n.count;for(let t=r,n=r+i;t<n;t+=3)_(e.getX(t+0),e.getX(t+1),e.getX(t+2))}let y=new G,b=new G,x=new G,S=new G;function C(e){x.fromBufferAttribute(r,e),S.copy(x);let t=o[e];y.copy(t),y.sub(x.multiplyScalar(x.dot(t))).normalize(),b.crossVectors(S,t);let n=b.dot(s[e])<0?-1:1;a.setXYZW(e,y.x,y.y,y.z,n)}for(let e=0,t=n.count;e<t;++e)c[e]&&C(e);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute(`position`);if(t!==void 0){let n=this.getAttribute(`normal`);if(n===void 0||n.count!==t.count)n=new zp(new Float32Array(t.count*3),3),this.setAttribute(`normal`,n);else for(let e=0,t=n.count;e<t;e++)n.setXYZ(e,0,0,0);let r=new G,i=new G,a=new G,o=new G,s=new G,c=new G,l=new G,u=new G;if(e)for(let d=0,f=e.count;d<f;d+=3){let f=e.getX(d+0),p=e.getX(d+1),m=e.getX(d+2);r.fromBufferAttribute(t,f),i.fromBufferAttribute(t,p),a.fromBufferAttribute(t,m),l.subVectors(a,i),u.subVectors(r,i),l.cross(u),o.fromBufferAttribute(n,f),s.fromBufferAttribute(n,p),c.fromBufferAttribute(n,m),o.add(l),s.add(l),c.add(l),n.setXYZ(f,o.x,o.y,o.z),n.setXYZ(p,s.x,s.y,s.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let e=0,o=t.count;e<o;e+=3)r.fromBufferAttribute(t,e+0),i.fromBufferAttribute(t,e+1),a.fromBufferAttribute(t,e+2),l.subVectors(a,i),u.subVectors(r,i),l.cross(u),n.setXYZ(e+0,l.x,l.y,l.z),n.setXYZ(e+1,l.x,l.y,l.z),n.setXYZ(e+2,l.x,l.y,l.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)$p.fromBufferAttribute(e,t),$p.normalize(),e.setXYZ(t,$p.x,$p.y,$p.z)}toNonIndexed(){function t(e,t){let n=e.array,r=e.itemSize,i=e.normalized,a=new n.constructor(t.length*r),o=0,s=0;for(let i=0,c=t.length;i<c;i++){o=e.isInterleavedBufferAttribute?t[i]*e.data.stride+e.offset:t[i]*r;for(let e=0;e<r;e++)a[s++]=n[o++]}return new zp(a,r,i)}if(this.index===null)return V(`BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed.`),this;let n=new e,r=this.index.array,i=this.attributes;for(let e in i){let a=i[e],o=t(a,r);n.setAttribute(e,o)}let a=this.morphAttributes;for(let e in a){let i=[],o=a[e];for(let e=0,n=o.length;e<n;e++){let n=o[e],a=t(n,r);i.push(a)}n.morphAttributes[e]=i}n.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let e=0,t=o.length;e<t;e++){let t=o[e];n.addGroup(t.start,t.count,t.materialIndex)}return n}toJSON(){let e={metadata:{version:4.7,type:`BufferGeometry`,generator:`BufferGeometry.toJSON`}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?`BufferGeometry`:this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let t=this.parameters;for(let n in t)t[n]!==void 0&&(e[n]=t[n]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let t in n){let r=n[t];e.data.attributes[t]=r.toJSON(e.data)}let r={},i=!1;for(let t in this.morphAttributes){let n=this.morphAttributes[t],a=[];for(let t=0,r=n.length;t<r;t++){let r=n[t];a.push(r.toJSON(e.data))}a.length>0&&(r[t]=a,i=!0)}i&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let e in r){let n=r[e];this.setAttribute(e,n.clone(t))}let i=e.morphAttributes;for(let e in i){let n=[],r=i[e];for(let e=0,i=r.length;e<i;e++)n.push(r[e].clone(t));this.morphAttributes[e]=n}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let e=0,t=a.length;e<t;e++){let t=a[e];this.addGroup(t.start,t.count,t.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let s=e.boundingSphere;return s!==null&&(this.boundingSphere=s.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:`dispose`})}},tm=new G,nm=new G,rm=new K,im=class{constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=tm.subVectors(n,t).cross(nm.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(tm),i=this.normal.dot(r);if(i===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/i;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(r,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||rm.getNormalMatrix(e),r=this.coplanarPoint(tm).applyMatrix4(e),i=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(i),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},am=0,om=class extends Dd{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:am++}),this.uuid=Md(),this.name=``,this.type=`Material`,this.blending=1,this.side=0,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=204,this.blendDst=205,this.blendEquation=100,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Y(0,0,0),this.blendAlpha=0,this.depthFunc=3,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=519,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=pd,this.stencilZFail=pd,this.stencilZPass=pd,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){V(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];r===void 0?V(`Material: '${t}' is not a property of THREE.${this.type}.`):r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e==`string`;t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:`Material`,generator:`Material.toJSON`}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(e=>e.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(e){let t=[];for(let n in e){let r=e[n];delete r.metadata,t.push(r)}return t}if(t){let t=r(e.textures),i=r(e.images);t.length>0&&(n.textures=t),i.length>0&&(n.images=i)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Y().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(e=>new im().fromJSON(e))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(this.vertexColors=typeof e.vertexColors==`number`?e.vertexColors>0:e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let t=e.normalScale;Array.isArray(t)===!1&&(t=[t,t]),this.normalScale=new W().fromArray(t)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new W().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let e=t.length;n=Array(e);for(let r=0;r!==e;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:`dispose`})}set needsUpdate(e){e===!0&&this.version++}},sm=new G,cm=new G,lm=new G,um=new G,dm=class{constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,sm)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=sm.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(sm.copy(this.origin).addScaledVector(this.direction,t),sm.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){cm.copy(e).add(t).multiplyScalar(.5),lm.copy(t).sub(e).normalize(),um.copy(this.origin).sub(cm);let i=e.distanceTo(t)*.5,a=-this.direction.dot(lm),o=um.dot(this.direction),s=-um.dot(lm),c=um.lengthSq(),l=Math.abs(1-a*a),u,d,f,p;if(l>0){if(u=a*s-o,d=a*o-s,p=i*l,u>=0){if(d>=-p){if(d<=p){let e=1/l;u*=e,d*=e,f=u*(u+a*d+2*o)+d*(a*u+d+2*s)+c}else d=i,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*s)+c}else d=-i,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*s)+c}else d<=-p?(u=Math.max(0,-(-a*i+o)),d=u>0?-i:Math.min(Math.max(-i,-s),i),f=-u*u+d*(d+2*s)+c):d<=p?(u=0,d=Math.min(Math.max(-i,-s),i),f=d*(d+2*s)+c):(u=Math.max(0,-(a*i+o)),d=u>0?i:Math.min(Math.max(-i,-s),i),f=-u*u+d*(d+2*s)+c)}else d=a>0?-i:i,u=Math.max(0,-(a*d+o)),f=-u*u+d*(d+2*s)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),r&&r.copy(cm).addScaledVector(lm,d),f}intersectSphere(e,t){if(e.radius<0)return null;sm.subVectors(e.center,this.origin);let n=sm.dot(this.direction),r=sm.dot(sm)-n*n,i=e.radius*e.radius;if(r>i)return null;let a=Math.sqrt(i-r),o=n-a,s=n+a;return s<0?null:o<0?this.at(s,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,i,a,o,s,c=1/this.direction.x,l=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,r=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,r=(e.min.x-d.x)*c),l>=0?(i=(e.min.y-d.y)*l,a=(e.max.y-d.y)*l):(i=(e.max.y-d.y)*l,a=(e.min.y-d.y)*l),n>a||i>r||((i>n||isNaN(n))&&(n=i),(a<r||isNaN(r))&&(r=a),u>=0?(o=(e.min.z-d.z)*u,s=(e.max.z-d.z)*u):(o=(e.max.z-d.z)*u,s=(e.min.z-d.z)*u),n>s||o>r)||((o>n||n!==n)&&(n=o),(s<r||r!==r)&&(r=s),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,sm)!==null}intersectTriangle(e,t,n,r,i){let a=this.origin,o=this.direction,s=o.x,c=o.y,l=o.z,u=e.x-a.x,d=e.y-a.y,f=e.z-a.z,p=t.x-a.x,m=t.y-a.y,h=t.z-a.z,g=n.x-a.x,_=n.y-a.y,v=n.z-a.z,y=Math.abs(s),b=Math.abs(c),x=Math.abs(l),S,C,w,T,E,D,O,k,A,j,M,N;if(y>=b&&y>=x?(w=s,D=u,A=p,N=g,s>=0?(S=c,C=l,T=d,E=f,O=m,k=h,j=_,M=v):(S=l,C=c,T=f,E=d,O=h,k=m,j=v,M=_)):b>=x?(w=c,D=d,A=m,N=_,c>=0?(S=l,C=s,T=f,E=u,O=h,k=p,j=v,M=g):(S=s,C=l,T=u,E=f,O=p,k=h,j=g,M=v)):(w=l,D=f,A=h,N=v,l>=0?(S=s,C=c,T=u,E=d,O=p,k=m,j=g,M=_):(S=c,C=s,T=d,E=u,O=m,k=p,j=_,M=g)),w===0)return null;let ee=S/w,te=C/w,P=1/w,ne=T-ee*D,re=E-te*D,ie=O-ee*A,ae=k-te*A,oe=j-ee*N,se=M-te*N,ce=oe*ae-se*ie,F=ne*se-re*oe,le=ie*re-ae*ne;if(r){if(ce<0||F<0||le<0)return null}else if((ce<0||F<0||le<0)&&(ce>0||F>0||le>0))return null;let ue=ce+F+le;if(ue===0)return null;let de=P*(ce*D+F*A+le*N);return(ue>0?de<0:de>0)?null:this.at(de/ue,i)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},fm=class extends om{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type=`MeshBasicMaterial`,this.color=new Y(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Nf,this.combine=0,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap=`round`,this.wireframeLinejoin=`round`,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},pm=new J,mm=new dm,hm=new Kp,gm=new G,_m=new G,vm=new G,ym=new G,bm=new G,xm=new G,Sm=new G,Cm=new G,wm=class extends Xf{constructor(e=new em,t=new fm){super(),this.isMesh=!0,this.type=`Mesh`,this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.morphTargetInfluences=e.morphTargetInfluences===void 0?void 0:e.morphTargetInfluences.slice(),this.morphTargetDictionary=e.morphTargetDictionary===void 0?void 0:Object.assign({},e.morphTargetDictionary),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,t=Object.keys(e);if(t.length>0){let n=e[t[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let e=0,t=n.length;e<t;e++){let t=n[e].name||String(e);this.morphTargetInfluences.push(0),this.morphTargetDictionary[t]=e}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,i=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let o=this.morphTargetInfluences;if(i&&o){xm.set(0,0,0);for(let n=0,r=i.length;n<r;n++){let r=o[n],s=i[n];r!==0&&(bm.fromBufferAttribute(s,e),a?xm.addScaledVector(bm,r):xm.addScaledVector(bm.sub(t),r))}t.add(xm)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,i=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),hm.copy(n.boundingSphere),hm.applyMatrix4(i),mm.copy(e.ray).recast(e.near),hm.containsPoint(mm.origin)===!1&&(mm.intersectSphere(hm,gm)===null||mm.origin.distanceToSquared(gm)>(e.far-e.near)**2)||(pm.copy(i).invert(),mm.copy(e.ray).applyMatrix4(pm),(n.boundingBox===null||mm.intersectsBox(n.boundingBox)!==!1)&&this._computeIntersections(e,t,mm)))}_computeIntersections(e,t,n){let r,i=this.geometry,a=this.material,o=i.index,s=i.attributes.position,c=i.attributes.uv,l=i.attributes.uv1,u=i.attributes.normal,d=i.groups,f=i.drawRange;if(o!==null){if(Array.isArray(a))for(let i=0,s=d.length;i<s;i++){let s=d[i],p=a[s.materialIndex],m=Math.max(s.start,f.start),h=Math.min(o.count,Math.min(s.start+s.count,f.start+f.count));for(let i=m,a=h;i<a;i+=3){let a=o.getX(i),d=o.getX(i+1),f=o.getX(i+2);r=Em(this,p,e,n,c,l,u,a,d,f),r&&(r.faceIndex=Math.floor(i/3),r.face.materialIndex=s.materialIndex,t.push(r))}}else{let i=Math.max(0,f.start),s=Math.min(o.count,f.start+f.count);for(let d=i,f=s;d<f;d+=3){let i=o.getX(d),s=o.getX(d+1),f=o.getX(d+2);r=Em(this,a,e,n,c,l,u,i,s,f),r&&(r.faceIndex=Math.floor(d/3),t.push(r))}}}else if(s!==void 0){if(Array.isArray(a))for(let i=0,o=d.length;i<o;i++){let o=d[i],p=a[o.materialIndex],m=Math.max(o.start,f.start),h=Math.min(s.count,Math.min(o.start+o.count,f.start+f.count));for(let i=m,a=h;i<a;i+=3){let a=i,s=i+1,d=i+2;r=Em(this,p,e,n,c,l,u,a,s,d),r&&(r.faceIndex=Math.floor(i/3),r.face.materialIndex=o.materialIndex,t.push(r))}}else{let i=Math.max(0,f.start),o=Math.min(s.count,f.start+f.count);for(let s=i,d=o;s<d;s+=3){let i=s,o=s+1,d=s+2;r=Em(this,a,e,n,c,l,u,i,o,d),r&&(r.faceIndex=Math.floor(s/3),t.push(r))}}}}};function Tm(e,t,n,r,i,a,o,s){let c;if(c=t.side===1?r.intersectTriangle(o,a,i,!0,s):r.intersectTriangle(i,a,o,t.side===0,s),c===null)return null;Cm.copy(s),Cm.applyMatrix4(e.matrixWorld);let l=n.ray.origin.distanceTo(Cm);return l<n.near||l>n.far?null:{distance:l,point:Cm.clone(),object:e}}function Em(e,t,n,r,i,a,o,s,c,l){e.getVertexPosition(s,_m),e.getVertexPosition(c,vm),e.getVertexPosition(l,ym);let u=Tm(e,t,n,r,_m,vm,ym,Sm);if(u){let e=new G;bp.getBarycoord(Sm,_m,vm,ym,e),i&&(u.uv=bp.getInterpolatedAttribute(i,s,c,l,e,new W)),a&&(u.uv1=bp.getInterpolatedAttribute(a,s,c,l,e,new W)),o&&(u.normal=bp.getInterpolatedAttribute(o,s,c,l,e,new G),u.normal.dot(r.direction)>0&&u.normal.multiplyScalar(-1));let t={a:s,b:c,c:l,normal:new G,materialIndex:0};bp.getNormal(_m,vm,ym,t.normal),u.face=t,u.barycoord=e}return u}var Dm=class extends vf{constructor(e=null,t=1,n=1,r,i,a,o,s,c=Wl,l=Wl,u,d){super(null,a,o,s,c,l,r,i,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},Om=class extends zp{constructor(e,t,n,r=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},km=new J,Am=new J,jm=[],Mm=new xp,Nm=new J,Pm=new wm,Fm=new Kp,Im=class extends wm{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Om(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let e=0;e<n;e++)this.setMatrixAt(e,Nm)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new xp),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,km),Mm.copy(e.boundingBox).applyMatrix4(km),this.boundingBox.union(Mm)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Kp),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,km),Fm.copy(e.boundingSphere).applyMatrix4(km),this.boundingSphere.union(Fm)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture===null?null:e.morphTexture.clone(),this.instanceColor=e.instanceColor===null?null:e.instanceColor.clone(),this.count=e.count,this.boundingBox=e.boundingBox===null?null:e.boundingBox.clone(),this.boundingSphere=e.boundingSphere===null?null:e.boundingSphere.clone(),this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,r=this.morphTexture.source.data.data,i=e*(n.length+1)+1;for(let e=0;e<n.length;e++)n[e]=r[i+e]}raycast(e,t){let n=this.matrixWorld,r=this.count;if(Pm.geometry=this.geometry,Pm.material=this.material,Pm.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Fm.copy(this.boundingSphere),Fm.applyMatrix4(n),e.ray.intersectsSphere(Fm)!==!1))for(let i=0;i<r;i++){this.getMatrixAt(i,km),Am.multiplyMatrices(n,km),Pm.matrixWorld=Am,Pm.raycast(e,jm);for(let e=0,n=jm.length;e<n;e++){let n=jm[e];n.instanceId=i,n.object=this,t.push(n)}jm.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Om(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,r=n.length+1;this.morphTexture===null&&(this.morphTexture=new Dm(new Float32Array(r*this.count),r,this.count,mu,nu));let i=this.morphTexture.source.data.data,a=0;for(let e=0;e<n.length;e++)a+=n[e];let o=this.geometry.morphTargetsRelative?1:1-a,s=r*e;return i[s]=o,i.set(n,s+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Lm=new Kp,Rm=new W(.5,.5),zm=new G,Bm=class{constructor(e=new im,t=new im,n=new im,r=new im,i=new im,a=new im){this.planes=[e,t,n,r,i,a]}set(e,t,n,r,i,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(r),o[4].copy(i),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=gd,n=!1){let r=this.planes,i=e.elements,a=i[0],o=i[1],s=i[2],c=i[3],l=i[4],u=i[5],d=i[6],f=i[7],p=i[8],m=i[9],h=i[10],g=i[11],_=i[12],v=i[13],y=i[14],b=i[15];if(r[0].setComponents(c-a,f-l,g-p,b-_).normalize(),r[1].setComponents(c+a,f+l,g+p,b+_).normalize(),r[2].setComponents(c+o,f+u,g+m,b+v).normalize(),r[3].setComponents(c-o,f-u,g-m,b-v).normalize(),n)r[4].setComponents(s,d,h,y).normalize(),r[5].setComponents(c-s,f-d,g-h,b-y).normalize();else if(r[4].setComponents(c-s,f-d,g-h,b-y).normalize(),t===2e3)r[5].setComponents(c+s,f+d,g+h,b+y).normalize();else if(t===2001)r[5].setComponents(s,d,h,y).normalize();else throw Error(`THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: `+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Lm.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Lm.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Lm)}intersectsSprite(e){return Lm.center.set(0,0,0),Lm.radius=.7071067811865476+Rm.distanceTo(e.center),Lm.applyMatrix4(e.matrixWorld),this.intersectsSphere(Lm)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let e=0;e<6;e++)if(t[e].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(zm.x=r.normal.x>0?e.max.x:e.min.x,zm.y=r.normal.y>0?e.max.y:e.min.y,zm.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(zm)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Vm=new J,Hm=class e{constructor(){this.coordinateSystem=gd,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let e=0;e<t.length;e++){let r=t[e];Vm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[e]===void 0&&(n[e]=new Bm),n[e].setFromProjectionMatrix(Vm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Bm),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new e().copy(this)}},Um=class extends om{constructor(e){super(),this.isLineBasicMaterial=!0,this.type=`LineBasicMaterial`,this.color=new Y(16777215),this.map=null,this.linewidth=1,this.linecap=`round`,this.linejoin=`round`,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Wm=new G,Gm=new G,Km=new J,qm=new dm,Jm=new Kp,Ym=new G,Xm=new G,Zm=class extends Xf{constructor(e=new em,t=new Um){super(),this.isLine=!0,this.type=`Line`,this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.morphTargetInfluences=e.morphTargetInfluences===void 0?void 0:e.morphTargetInfluences.slice(),this.morphTargetDictionary=e.morphTargetDictionary===void 0?void 0:Object.assign({},e.morphTargetDictionary),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let e=1,r=t.count;e<r;e++)Wm.fromBufferAttribute(t,e-1),Gm.fromBufferAttribute(t,e),n[e]=n[e-1],n[e]+=Wm.distanceTo(Gm);e.setAttribute(`lineDistance`,new Hp(n,1))}else V(`Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.`);return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,i=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Jm.copy(n.boundingSphere),Jm.applyMatrix4(r),Jm.radius+=i,e.ray.intersectsSphere(Jm)===!1)return;Km.copy(r).invert(),qm.copy(e.ray).applyMatrix4(Km);let o=i/((this.scale.x+this.scale.y+this.scale.z)/3),s=o*o,c=this.isLineSegments?2:1,l=n.index,u=n.attributes.position;if(l!==null){let n=Math.max(0,a.start),r=Math.min(l.count,a.start+a.count);for(let i=n,a=r-1;i<a;i+=c){let n=l.getX(i),r=l.getX(i+1),a=Qm(this,e,qm,s,n,r,i);a&&t.push(a)}if(this.isLineLoop){let i=l.getX(r-1),a=l.getX(n),o=Qm(this,e,qm,s,i,a,r-1);o&&t.push(o)}}else{let n=Math.max(0,a.start),r=Math.min(u.count,a.start+a.count);for(let i=n,a=r-1;i<a;i+=c){let n=Qm(this,e,qm,s,i,i+1,i);n&&t.push(n)}if(this.isLineLoop){let i=Qm(this,e,qm,s,r-1,n,r-1);i&&t.push(i)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,t=Object.keys(e);if(t.length>0){let n=e[t[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let e=0,t=n.length;e<t;e++){let t=n[e].name||String(e);this.morphTargetInfluences.push(0),this.morphTargetDictionary[t]=e}}}}};function Qm(e,t,n,r,i,a,o){let s=e.geometry.attributes.position;if(Wm.fromBufferAttribute(s,i),Gm.fromBufferAttribute(s,a),n.distanceSqToSegment(Wm,Gm,Ym,Xm)>r)return;Ym.applyMatrix4(e.matrixWorld);let c=t.ray.origin.distanceTo(Ym);if(!(c<t.near||c>t.far))return{distance:c,point:Xm.clone().applyMatrix4(e.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:e}}var $m=new G,eh=new G,th=class extends Zm{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type=`LineSegments`}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let e=0,r=t.count;e<r;e+=2)$m.fromBufferAttribute(t,e),eh.fromBufferAttribute(t,e+1),n[e]=e===0?0:n[e-1],n[e+1]=n[e]+$m.distanceTo(eh);e.setAttribute(`lineDistance`,new Hp(n,1))}else V(`LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.`);return this}},nh=class extends om{constructor(e){super(),this.isPointsMaterial=!0,this.type=`PointsMaterial`,this.color=new Y(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},rh=new J,ih=new dm,ah=new Kp,oh=new G,sh=class extends Xf{constructor(e=new em,t=new nh){super(),this.isPoints=!0,this.type=`Points`,this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.morphTargetInfluences=e.morphTargetInfluences===void 0?void 0:e.morphTargetInfluences.slice(),this.morphTargetDictionary=e.morphTargetDictionary===void 0?void 0:Object.assign({},e.morphTargetDictionary),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,i=e.params.Points.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ah.copy(n.boundingSphere),ah.applyMatrix4(r),ah.radius+=i,e.ray.intersectsSphere(ah)===!1)return;rh.copy(r).invert(),ih.copy(e.ray).applyMatrix4(rh);let o=i/((this.scale.x+this.scale.y+this.scale.z)/3),s=o*o,c=n.index,l=n.attributes.position;if(c!==null){let n=Math.max(0,a.start),i=Math.min(c.count,a.start+a.count);for(let a=n,o=i;a<o;a++){let n=c.getX(a);oh.fromBufferAttribute(l,n),ch(oh,n,s,r,e,t,this)}}else{let n=Math.max(0,a.start),i=Math.min(l.count,a.start+a.count);for(let a=n,o=i;a<o;a++)oh.fromBufferAttribute(l,a),ch(oh,a,s,r,e,t,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,t=Object.keys(e);if(t.length>0){let n=e[t[0]];if(n!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let e=0,t=n.length;e<t;e++){let t=n[e].name||String(e);this.morphTargetInfluences.push(0),this.morphTargetDictionary[t]=e}}}}};function ch(e,t,n,r,i,a,o){let s=ih.distanceSqToPoint(e);if(s<n){let n=new G;ih.closestPointToPoint(e,n),n.applyMatrix4(r);let c=i.ray.origin.distanceTo(n);if(c<i.near||c>i.far)return;a.push({distance:c,distanceToRay:Math.sqrt(s),point:n,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var lh=class extends vf{constructor(e=[],t=301,n,r,i,a,o,s,c,l){super(e,t,n,r,i,a,o,s,c,l),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},uh=class extends vf{constructor(e,t,n=tu,r,i,a,o=Wl,s=Wl,c,l=fu,u=1){if(l!==1026&&l!==1027)throw Error(`THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat`);super({width:e,height:t,depth:u},r,i,a,o,s,l,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new mf(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},dh=class extends uh{constructor(e,t=tu,n=301,r,i,a=Wl,o=Wl,s,c=fu){let l={width:e,height:e,depth:1},u=[l,l,l,l,l,l];super(e,e,t,n,r,i,a,o,s,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},fh=class extends vf{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ph=class e extends em{constructor(e=1,t=1,n=1,r=1,i=1,a=1){super(),this.type=`BoxGeometry`,this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:i,depthSegments:a};let o=this;r=Math.floor(r),i=Math.floor(i),a=Math.floor(a);let s=[],c=[],l=[],u=[],d=0,f=0;p(`z`,`y`,`x`,-1,-1,n,t,e,a,i,0),p(`z`,`y`,`x`,1,-1,n,t,-e,a,i,1),p(`x`,`z`,`y`,1,1,e,n,t,r,a,2),p(`x`,`z`,`y`,1,-1,e,n,-t,r,a,3),p(`x`,`y`,`z`,1,-1,e,t,n,r,i,4),p(`x`,`y`,`z`,-1,-1,e,t,-n,r,i,5),this.setIndex(s),this.setAttribute(`position`,new Hp(c,3)),this.setAttribute(`normal`,new Hp(l,3)),this.setAttribute(`uv`,new Hp(u,2));function p(e,t,n,r,i,a,p,m,h,g,_){let v=a/h,y=p/g,b=a/2,x=p/2,S=m/2,C=h+1,w=g+1,T=0,E=0,D=new G;for(let a=0;a<w;a++){let o=a*y-x;for(let s=0;s<C;s++)D[e]=(s*v-b)*r,D[t]=o*i,D[n]=S,c.push(D.x,D.y,D.z),D[e]=0,D[t]=0,D[n]=m>0?1:-1,l.push(D.x,D.y,D.z),u.push(s/h),u.push(1-a/g),T+=1}for(let e=0;e<g;e++)for(let t=0;t<h;t++){let n=d+t+C*e,r=d+t+C*(e+1),i=d+(t+1)+C*(e+1),a=d+(t+1)+C*e;s.push(n,r,a),s.push(r,i,a),E+=6}o.addGroup(f,E,_),f+=E,d+=T}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(t){return new e(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},mh=class e extends em{constructor(e=1,t=1,n=1,r=32,i=1,a=!1,o=0,s=Math.PI*2){super(),this.type=`CylinderGeometry`,this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:r,heightSegments:i,openEnded:a,thetaStart:o,thetaLength:s};let c=this;r=Math.floor(r),i=Math.floor(i);let l=[],u=[],d=[],f=[],p=0,m=[],h=n/2,g=0;_(),a===!1&&(e>0&&v(!0),t>0&&v(!1)),this.setIndex(l),this.setAttribute(`position`,new Hp(u,3)),this.setAttribute(`normal`,new Hp(d,3)),this.setAttribute(`uv`,new Hp(f,2));function _(){let a=new G,_=new G,v=0,y=(t-e)/n;for(let c=0;c<=i;c++){let l=[],g=c/i,v=g*(t-e)+e;for(let e=0;e<=r;e++){let t=e/r,i=t*s+o,c=Math.sin(i),m=Math.cos(i);_.x=v*c,_.y=-g*n+h,_.z=v*m,u.push(_.x,_.y,_.z),a.set(c,y,m).normalize(),d.push(a.x,a.y,a.z),f.push(t,1-g),l.push(p++)}m.push(l)}for(let n=0;n<r;n++)for(let r=0;r<i;r++){let a=m[r][n],o=m[r+1][n],s=m[r+1][n+1],c=m[r][n+1];(e>0||r!==0)&&(l.push(a,o,c),v+=3),(t>0||r!==i-1)&&(l.push(o,s,c),v+=3)}c.addGroup(g,v,0),g+=v}function v(n){let i=p,a=new W,m=new G,_=0,v=n===!0?e:t,y=n===!0?1:-1;for(let e=1;e<=r;e++)u.push(0,h*y,0),d.push(0,y,0),f.push(.5,.5),p++;let b=p;for(let e=0;e<=r;e++){let t=e/r*s+o,n=Math.cos(t),i=Math.sin(t);m.x=v*i,m.y=h*y,m.z=v*n,u.push(m.x,m.y,m.z),d.push(0,y,0),a.x=n*.5+.5,a.y=i*.5*y+.5,f.push(a.x,a.y),p++}for(let e=0;e<r;e++){let t=i+e,r=b+e;n===!0?l.push(r,r+1,t):l.push(r+1,r,t),_+=3}c.addGroup(g,_,n===!0?1:2),g+=_}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(t){return new e(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},hh=class e extends mh{constructor(e=1,t=1,n=32,r=1,i=!1,a=0,o=Math.PI*2){super(0,e,t,n,r,i,a,o),this.type=`ConeGeometry`,this.parameters={radius:e,height:t,radialSegments:n,heightSegments:r,openEnded:i,thetaStart:a,thetaLength:o}}static fromJSON(t){return new e(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},gh=class e extends em{constructor(e=[],t=[],n=1,r=0){super(),this.type=`PolyhedronGeometry`,this.parameters={vertices:e,indices:t,radius:n,detail:r};let i=[],a=[];o(r),c(n),l(),this.setAttribute(`position`,new Hp(i,3)),this.setAttribute(`normal`,new Hp(i.slice(),3)),this.setAttribute(`uv`,new Hp(a,2)),r===0?this.computeVertexNormals():this.normalizeNormals();function o(e){let n=new G,r=new G,i=new G;for(let a=0;a<t.length;a+=3)f(t[a+0],n),f(t[a+1],r),f(t[a+2],i),s(n,r,i,e)}function s(e,t,n,r){let i=r+1,a=[];for(let r=0;r<=i;r++){a[r]=[];let o=e.clone().lerp(n,r/i),s=t.clone().lerp(n,r/i),c=i-r;for(let e=0;e<=c;e++)e===0&&r===i?a[r][e]=o:a[r][e]=o.clone().lerp(s,e/c)}for(let e=0;e<i;e++)for(let t=0;t<2*(i-e)-1;t++){let n=Math.floor(t/2);t%2==0?(d(a[e][n+1]),d(a[e+1][n]),d(a[e][n])):(d(a[e][n+1]),d(a[e+1][n+1]),d(a[e+1][n]))}}function c(e){let t=new G;for(let n=0;n<i.length;n+=3)t.x=i[n+0],t.y=i[n+1],t.z=i[n+2],t.normalize().multiplyScalar(e),i[n+0]=t.x,i[n+1]=t.y,i[n+2]=t.z}function l(){let e=new G;for(let t=0;t<i.length;t+=3){e.x=i[t+0],e.y=i[t+1],e.z=i[t+2];let n=h(e)/2/Math.PI+.5,r=g(e)/Math.PI+.5;a.push(n,1-r)}p(),u()}function u(){for(let e=0;e<a.length;e+=6){let t=a[e+0],n=a[e+2],r=a[e+4];Math.max(t,n,r)>.9&&Math.min(t,n,r)<.1&&(t<.2&&(a[e+0]+=1),n<.2&&(a[e+2]+=1),r<.2&&(a[e+4]+=1))}}function d(e){i.push(e.x,e.y,e.z)}function f(t,n){let r=t*3;n.x=e[r+0],n.y=e[r+1],n.z=e[r+2]}function p(){let e=new G,t=new G,n=new G,r=new G,o=new W,s=new W,c=new W;for(let l=0,u=0;l<i.length;l+=9,u+=6){e.set(i[l+0],i[l+1],i[l+2]),t.set(i[l+3],i[l+4],i[l+5]),n.set(i[l+6],i[l+7],i[l+8]),o.set(a[u+0],a[u+1]),s.set(a[u+2],a[u+3]),c.set(a[u+4],a[u+5]),r.copy(e).add(t).add(n).divideScalar(3);let d=h(r);m(o,u+0,e,d),m(s,u+2,t,d),m(c,u+4,n,d)}}function m(e,t,n,r){r<0&&e.x===1&&(a[t]=e.x-1),n.x===0&&n.z===0&&(a[t]=r/2/Math.PI+.5)}function h(e){return Math.atan2(e.z,-e.x)}function g(e){return Math.atan2(-e.y,Math.sqrt(e.x*e.x+e.z*e.z))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(t){return new e(t.vertices,t.indices,t.radius,t.detail)}},_h=class e extends gh{constructor(e=1,t=0){let n=(1+Math.sqrt(5))/2,r=[-1,n,0,1,n,0,-1,-n,0,1,-n,0,0,-1,n,0,1,n,0,-1,-n,0,1,-n,n,0,-1,n,0,1,-n,0,-1,-n,0,1];super(r,[0,11,5,0,5,1,0,1,7,0,7,10,0,10,11,1,5,9,5,11,4,11,10,2,10,7,6,7,1,8,3,9,4,3,4,2,3,2,6,3,6,8,3,8,9,4,9,5,2,4,11,6,2,10,8,6,7,9,8,1],e,t),this.type=`IcosahedronGeometry`,this.parameters={radius:e,detail:t}}static fromJSON(t){return new e(t.radius,t.detail)}},vh=class e extends em{constructor(e=1,t=1,n=1,r=1){super(),this.type=`PlaneGeometry`,this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let i=e/2,a=t/2,o=Math.floor(n),s=Math.floor(r),c=o+1,l=s+1,u=e/o,d=t/s,f=[],p=[],m=[],h=[];for(let e=0;e<l;e++){let t=e*d-a;for(let n=0;n<c;n++){let r=n*u-i;p.push(r,-t,0),m.push(0,0,1),h.push(n/o),h.push(1-e/s)}}for(let e=0;e<s;e++)for(let t=0;t<o;t++){let n=t+c*e,r=t+c*(e+1),i=t+1+c*(e+1),a=t+1+c*e;f.push(n,r,a),f.push(r,i,a)}this.setIndex(f),this.setAttribute(`position`,new Hp(p,3)),this.setAttribute(`normal`,new Hp(m,3)),this.setAttribute(`uv`,new Hp(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(t){return new e(t.width,t.height,t.widthSegments,t.heightSegments)}},yh=class e extends em{constructor(e=1,t=32,n=16,r=0,i=Math.PI*2,a=0,o=Math.PI){super(),this.type=`SphereGeometry`,this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:r,phiLength:i,thetaStart:a,thetaLength:o},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let s=Math.min(a+o,Math.PI),c=0,l=[],u=new G,d=new G,f=[],p=[],m=[],h=[];for(let f=0;f<=n;f++){let g=[],_=f/n,v=a+_*o,y=e*Math.cos(v),b=Math.sqrt(e*e-y*y),x=0;f===0&&a===0?x=.5/t:f===n&&s===Math.PI&&(x=-.5/t);for(let e=0;e<=t;e++){let n=e/t,a=r+n*i;u.x=-b*Math.cos(a),u.y=y,u.z=b*Math.sin(a),p.push(u.x,u.y,u.z),d.copy(u).normalize(),m.push(d.x,d.y,d.z),h.push(n+x,1-_),g.push(c++)}l.push(g)}for(let e=0;e<n;e++)for(let r=0;r<t;r++){let t=l[e][r+1],i=l[e][r],o=l[e+1][r],c=l[e+1][r+1];(e!==0||a>0)&&f.push(t,i,c),(e!==n-1||s<Math.PI)&&f.push(i,o,c)}this.setIndex(f),this.setAttribute(`position`,new Hp(p,3)),this.setAttribute(`normal`,new Hp(m,3)),this.setAttribute(`uv`,new Hp(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(t){return new e(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function bh(e){let t={};for(let n in e){t[n]={};for(let r in e[n]){let i=e[n][r];if(Sh(i))i.isRenderTargetTexture?(V(`UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms().`),t[n][r]=null):t[n][r]=i.clone();else if(Array.isArray(i)){if(Sh(i[0])){let e=[];for(let t=0,n=i.length;t<n;t++)e[t]=i[t].clone();t[n][r]=e}else t[n][r]=i.slice()}else t[n][r]=i}}return t}function xh(e){let t={};for(let n=0;n<e.length;n++){let r=bh(e[n]);for(let e in r)t[e]=r[e]}return t}function Sh(e){return e&&(e.isColor||e.isMatrix3||e.isMatrix4||e.isVector2||e.isVector3||e.isVector4||e.isTexture||e.isQuaternion)}function Ch(e){let t=[];for(let n=0;n<e.length;n++)t.push(e[n].clone());return t}function wh(e){let t=e.getRenderTarget();return t===null?e.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:q.workingColorSpace}var Th={clone:bh,merge:xh},Eh=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Dh=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Oh=class extends om{constructor(e){super(),this.isShaderMaterial=!0,this.type=`ShaderMaterial`,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Eh,this.fragmentShader=Dh,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=bh(e.uniforms),this.uniformsGroups=Ch(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let n in this.uniforms){let r=this.uniforms[n].value;r&&r.isTexture?t.uniforms[n]={type:`t`,value:r.toJSON(e).uuid}:r&&r.isColor?t.uniforms[n]={type:`c`,value:r.getHex()}:r&&r.isVector2?t.uniforms[n]={type:`v2`,value:r.toArray()}:r&&r.isVector3?t.uniforms[n]={type:`v3`,value:r.toArray()}:r&&r.isVector4?t.uniforms[n]={type:`v4`,value:r.toArray()}:r&&r.isMatrix3?t.uniforms[n]={type:`m3`,value:r.toArray()}:r&&r.isMatrix4?t.uniforms[n]={type:`m4`,value:r.toArray()}:t.uniforms[n]={value:r}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let e in this.extensions)this.extensions[e]===!0&&(n[e]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case`t`:this.uniforms[n].value=t[r.value]||null;break;case`c`:this.uniforms[n].value=new Y().setHex(r.value);break;case`v2`:this.uniforms[n].value=new W().fromArray(r.value);break;case`v3`:this.uniforms[n].value=new G().fromArray(r.value);break;case`v4`:this.uniforms[n].value=new yf().fromArray(r.value);break;case`m3`:this.uniforms[n].value=new K().fromArray(r.value);break;case`m4`:this.uniforms[n].value=new J().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let t in e.extensions)this.extensions[t]=e.extensions[t];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},kh=class extends Oh{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type=`RawShaderMaterial`}},Ah=class extends om{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type=`MeshStandardMaterial`,this.defines={STANDARD:``},this.color=new Y(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Y(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=0,this.normalScale=new W(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Nf,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap=`round`,this.wireframeLinejoin=`round`,this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:``},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},jh=class extends om{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type=`MeshDepthMaterial`,this.depthPacking=cd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Mh=class extends om{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type=`MeshDistanceMaterial`,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Nh(e,t){return!e||e.constructor===t?e:typeof t.BYTES_PER_ELEMENT==`number`?new t(e):Array.prototype.slice.call(e)}function Ph(e){return e!==void 0&&e.inTangents!==void 0&&e.outTangents!==void 0}var Fh=class{constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r===void 0?new t.constructor(n):r,this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],i=t[n-1];validate_interval:{seek:{let a;linear_scan:{forward_scan:if(!(e<r)){for(let a=n+2;;){if(r===void 0){if(e<i)break forward_scan;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(i=r,r=t[++n],e<r)break seek}a=t.length;break linear_scan}if(!(e>=i)){let o=t[1];e<o&&(n=2,i=o);for(let a=n-2;;){if(i===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===a)break;if(r=i,i=t[--n-1],e>=i)break seek}a=n,n=0;break linear_scan}break validate_interval}for(;n<a;){let r=n+a>>>1;e<t[r]?a=r:n=r+1}if(r=t[n],i=t[n-1],i===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,i,r)}return this.interpolate_(n,i,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,i=e*r;for(let e=0;e!==r;++e)t[e]=n[i+e];return t}interpolate_(){throw Error(`THREE.Interpolant: Call to abstract method.`)}intervalChanged_(){}},Ih=class extends Fh{constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ad,endingEnd:ad}}intervalChanged_(e,t,n){let r=this.parameterPositions,i=e-2,a=e+1,o=r[i],s=r[a];if(o===void 0)switch(this.getSettings_().endingStart){case od:i=e,o=2*t-n;break;case sd:i=r.length-2,o=t+r[i]-r[i+1];break;default:i=e,o=n}if(s===void 0)switch(this.getSettings_().endingEnd){case od:a=e,s=2*n-t;break;case sd:a=1,s=n+r[1]-r[0];break;default:a=e-1,s=t}let c=(n-t)*.5,l=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(s-n),this._offsetPrev=i*l,this._offsetNext=a*l}interpolate_(e,t,n,r){let i=this.resultBuffer,a=this.sampleValues,o=this.valueSize,s=e*o,c=s-o,l=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-t)/(r-t),m=p*p,h=m*p,g=-d*h+2*d*m-d*p,_=(1+d)*h+(-1.5-2*d)*m+(-.5+d)*p+1,v=(-1-f)*h+(1.5+f)*m+.5*p,y=f*h-f*m;for(let e=0;e!==o;++e)i[e]=g*a[l+e]+_*a[c+e]+v*a[s+e]+y*a[u+e];return i}},Lh=class extends Fh{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let i=this.resultBuffer,a=this.sampleValues,o=this.valueSize,s=e*o,c=s-o,l=(n-t)/(r-t),u=1-l;for(let e=0;e!==o;++e)i[e]=a[c+e]*u+a[s+e]*l;return i}},Rh=class extends Fh{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},zh=class extends Fh{interpolate_(e,t,n,r){let i=this.resultBuffer,a=this.sampleValues,o=this.valueSize,s=e*o,c=s-o,l=this.inTangents,u=this.outTangents;if(!l||!u){let e=(n-t)/(r-t),l=1-e;for(let t=0;t!==o;++t)i[t]=a[c+t]*l+a[s+t]*e;return i}let d=o*2,f=e-1;for(let p=0;p!==o;++p){let o=a[c+p],m=a[s+p],h=f*d+p*2,g=u[h],_=u[h+1],v=e*d+p*2,y=l[v],b=l[v+1],x=Hh(n,t,g,y,r);i[p]=Bh(x,o,_,b,m)}return i}};function Bh(e,t,n,r,i){let a=1-e;return a*a*a*t+3*a*a*e*n+3*a*e*e*r+e*e*e*i}function Vh(e,t,n,r,i){let a=1-e;return 3*a*a*(n-t)+6*a*e*(r-n)+3*e*e*(i-r)}function Hh(e,t,n,r,i){let a=(e-t)/(i-t);for(let o=0;o<8;o++){let o=Bh(a,t,n,r,i)-e;if(Math.abs(o)<1e-10)break;let s=Vh(a,t,n,r,i);if(Math.abs(s)<1e-10)break;a=Math.max(0,Math.min(1,a-o/s))}return a}var Uh=class{constructor(e,t,n,r){if(e===void 0)throw Error(`THREE.KeyframeTrack: track name is undefined`);if(t===void 0||t.length===0)throw Error(`THREE.KeyframeTrack: no keyframes in track named `+e);this.name=e,this.times=Nh(t,this.TimeBufferType),this.values=Nh(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Nh(e.times,Array),values:Nh(e.values,Array)};let t=e.getInterpolation();t!==e.DefaultInterpolation&&(n.interpolation=t),Ph(e.settings)&&(n.settings={inTangents:Nh(e.settings.inTangents,Array),outTangents:Nh(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Rh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Lh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ih(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new zh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case td:t=this.InterpolantFactoryMethodDiscrete;break;case nd:t=this.InterpolantFactoryMethodLinear;break;case rd:t=this.InterpolantFactoryMethodSmooth;break;case id:t=this.InterpolantFactoryMethodBezier}if(t===void 0){let t=`unsupported interpolation for `+this.ValueTypeName+` keyframe track named `+this.name;if(this.createInterpolant===void 0){if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw Error(t)}return V(`KeyframeTrack:`,t),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return td;case this.InterpolantFactoryMethodLinear:return nd;case this.InterpolantFactoryMethodSmooth:return rd;case this.InterpolantFactoryMethodBezier:return id}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;Ph(this.settings)&&(Wh(this.settings.inTangents,e),Wh(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;Ph(this.settings)&&(Gh(this.settings.inTangents,e),Gh(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,i=0,a=r-1;for(;i!==r&&n[i]<e;)++i;for(;a!==-1&&n[a]>t;)--a;if(++a,i!==0||a!==r){i>=a&&(a=Math.max(a,1),i=a-1);let e=this.getValueSize();this.times=n.slice(i,a),this.values=this.values.slice(i*e,a*e)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(H(`KeyframeTrack: Invalid value size in track.`,this),e=!1);let n=this.times,r=this.values,i=n.length;i===0&&(H(`KeyframeTrack: Track is empty.`,this),e=!1);let a=null;for(let t=0;t!==i;t++){let r=n[t];if(typeof r==`number`&&isNaN(r)){H(`KeyframeTrack: Time is not a valid number.`,this,t,r),e=!1;break}if(a!==null&&a>r){H(`KeyframeTrack: Out of order keys.`,this,t,r,a),e=!1;break}a=r}if(r!==void 0&&vd(r))for(let t=0,n=r.length;t!==n;++t){let n=r[t];if(isNaN(n)){H(`KeyframeTrack: Value is not a valid number.`,this,t,n),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===rd,i=e.length-1,a=1;for(let o=1;o<i;++o){let i=!1,s=e[o];if(s!==e[o+1]&&(o!==1||s!==e[0])){if(r)i=!0;else{let e=o*n,r=e-n,a=e+n;for(let o=0;o!==n;++o){let n=t[e+o];if(n!==t[r+o]||n!==t[a+o]){i=!0;break}}}}if(i){if(o!==a){e[a]=e[o];let r=o*n,i=a*n;for(let e=0;e!==n;++e)t[i+e]=t[r+e]}++a}}if(i>0){e[a]=e[i];for(let e=i*n,r=a*n,o=0;o!==n;++o)t[r+o]=t[e+o];++a}return a===e.length?(this.times=e,this.values=t):(this.times=e.slice(0,a),this.values=t.slice(0,a*n)),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,Ph(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Wh(e,t){for(let n=0,r=e.length;n!==r;n+=2)e[n]+=t}function Gh(e,t){for(let n=0,r=e.length;n!==r;n+=2)e[n]*=t}Uh.prototype.ValueTypeName=``,Uh.prototype.TimeBufferType=Float32Array,Uh.prototype.ValueBufferType=Float32Array,Uh.prototype.DefaultInterpolation=nd;var Kh=class extends Uh{constructor(e,t,n){super(e,t,n)}};Kh.prototype.ValueTypeName=`bool`,Kh.prototype.ValueBufferType=Array,Kh.prototype.DefaultInterpolation=td,Kh.prototype.InterpolantFactoryMethodLinear=void 0,Kh.prototype.InterpolantFactoryMethodSmooth=void 0;var qh=class extends Uh{constructor(e,t,n,r){super(e,t,n,r)}};qh.prototype.ValueTypeName=`color`;var Jh=class extends Uh{constructor(e,t,n,r){super(e,t,n,r)}};Jh.prototype.ValueTypeName=`number`;var Yh=class extends Fh{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let i=this.resultBuffer,a=this.sampleValues,o=this.valueSize,s=(n-t)/(r-t),c=e*o;for(let e=c+o;c!==e;c+=4)tf.slerpFlat(i,0,a,c-o,a,c,s);return i}},Xh=class extends Uh{constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new Yh(this.times,this.values,this.getValueSize(),e)}};Xh.prototype.ValueTypeName=`quaternion`,Xh.prototype.InterpolantFactoryMethodSmooth=void 0;var Zh=class extends Uh{constructor(e,t,n){super(e,t,n)}};Zh.prototype.ValueTypeName=`string`,Zh.prototype.ValueBufferType=Array,Zh.prototype.DefaultInterpolation=td,Zh.prototype.InterpolantFactoryMethodLinear=void 0,Zh.prototype.InterpolantFactoryMethodSmooth=void 0;var Qh=class extends Uh{constructor(e,t,n,r){super(e,t,n,r)}};Qh.prototype.ValueTypeName=`vector`;var $h=class extends Xf{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type=`Light`,this.color=new Y(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},eg=class extends $h{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type=`HemisphereLight`,this.position.copy(Xf.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Y(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},tg=new J,ng=new G,rg=new G,ig=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new W(512,512),this.mapType=Xl,this.map=null,this.mapPass=null,this.matrix=new J,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Bm,this._frameExtents=new W(1,1),this._viewportCount=1,this._viewports=[new yf(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;ng.setFromMatrixPosition(e.matrixWorld),t.position.copy(ng),rg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(rg),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,r){tg.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(tg,e.coordinateSystem,e.reversedDepth);let i=this._frameExtents,a=r?r.z/i.x:1,o=r?r.w/i.y:1,s=r?r.x/i.x:0,c=r?r.y/i.y:0;e.coordinateSystem===2001||e.reversedDepth?t.set(.5*a,0,0,.5*a+s,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):t.set(.5*a,0,0,.5*a+s,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),t.multiply(tg)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ag=new G,og=new tf,sg=new G,cg=class extends Xf{constructor(){super(),this.isCamera=!0,this.type=`Camera`,this.matrixWorldInverse=new J,this.projectionMatrix=new J,this.projectionMatrixInverse=new J,this.coordinateSystem=gd,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ag,og,sg),sg.x===1&&sg.y===1&&sg.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ag,og,sg.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ag,og,sg),sg.x===1&&sg.y===1&&sg.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ag,og,sg.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},lg=new G,ug=new W,dg=new W,fg=class extends cg{constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type=`PerspectiveCamera`,this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=jd*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ad*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return jd*2*Math.atan(Math.tan(Ad*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){lg.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(lg.x,lg.y).multiplyScalar(-e/lg.z),lg.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(lg.x,lg.y).multiplyScalar(-e/lg.z)}getViewSize(e,t){return this.getViewBounds(e,ug,dg),t.subVectors(dg,ug)}setViewOffset(e,t,n,r,i,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=i,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ad*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,i=-.5*r,a=this.view;if(this.view!==null&&this.view.enabled){let e=a.fullWidth,o=a.fullHeight;i+=a.offsetX*r/e,t-=a.offsetY*n/o,r*=a.width/e,n*=a.height/o}let o=this.filmOffset;o!==0&&(i+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(i,i+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},pg=class extends cg{constructor(e=-1,t=1,n=1,r=-1,i=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type=`OrthographicCamera`,this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=i,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,i,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=i,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,i=n-e,a=n+e,o=r+t,s=r-t;if(this.view!==null&&this.view.enabled){let e=(this.right-this.left)/this.view.fullWidth/this.zoom,t=(this.top-this.bottom)/this.view.fullHeight/this.zoom;i+=e*this.view.offsetX,a=i+e*this.view.width,o-=t*this.view.offsetY,s=o-t*this.view.height}this.projectionMatrix.makeOrthographic(i,a,o,s,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},mg=class extends ig{constructor(){super(new pg(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},hg=class extends $h{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type=`DirectionalLight`,this.position.copy(Xf.DEFAULT_UP),this.updateMatrix(),this.target=new Xf,this.shadow=new mg}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},gg=-90,_g=1,vg=class extends Xf{constructor(e,t,n){super(),this.type=`CubeCamera`,this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new fg(gg,_g,e,t);r.layers=this.layers,this.add(r);let i=new fg(gg,_g,e,t);i.layers=this.layers,this.add(i);let a=new fg(gg,_g,e,t);a.layers=this.layers,this.add(a);let o=new fg(gg,_g,e,t);o.layers=this.layers,this.add(o);let s=new fg(gg,_g,e,t);s.layers=this.layers,this.add(s);let c=new fg(gg,_g,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,i,a,o,s]=t;for(let e of t)this.remove(e);if(e===2e3)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),i.up.set(0,0,-1),i.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),s.up.set(0,1,0),s.lookAt(0,0,-1);else if(e===2001)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),i.up.set(0,0,1),i.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),s.up.set(0,-1,0),s.lookAt(0,0,-1);else throw Error(`THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: `+e);for(let e of t)this.add(e),e.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[i,a,o,s,c,l]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let m=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let h=!1;h=e.isWebGLRenderer===!0?e.state.buffers.depth.getReversed():e.reversedDepthBuffer,e.setRenderTarget(n,0,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,i),e.setRenderTarget(n,1,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(n,4,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=m,e.setRenderTarget(n,5,r),h&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(u,d,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},yg=class extends fg{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}},bg=`\\[\\]\\.:\\/`,xg=RegExp(`[\\[\\]\\.:\\/]`,`g`),Sg=`[^\\[\\]\\.:\\/]`,Cg=`[^`+bg.replace(`\\.`,``)+`]`,wg=`((?:WC+[\\/:])*)`.replace(`WC`,Sg),Tg=`(WCOD+)?`.replace(`WCOD`,Cg),Eg=`(?:\\.(WC+)(?:\\[(.+)\\])?)?`.replace(`WC`,Sg),Dg=`\\.(WC+)(?:\\[(.+)\\])?`.replace(`WC`,Sg),Og=RegExp(`^`+wg+Tg+Eg+Dg+`$`),kg=[`material`,`materials`,`bones`,`map`],Ag=class{constructor(e,t,n){let r=n||jg.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,i=n.length;r!==i;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},jg=class e{constructor(t,n,r){this.path=n,this.parsedPath=r||e.parseTrackName(n),this.node=e.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,n,r){return t&&t.isAnimationObjectGroup?new e.Composite(t,n,r):new e(t,n,r)}static sanitizeNodeName(e){return e.replace(/\s/g,`_`).replace(xg,``)}static parseTrackName(e){let t=Og.exec(e);if(t===null)throw Error(`THREE.PropertyBinding: Cannot parse trackName: `+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(`.`);if(r!==void 0&&r!==-1){let e=n.nodeName.substring(r+1);kg.indexOf(e)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=e)}if(n.propertyName===null||n.propertyName.length===0)throw Error(`THREE.PropertyBinding: can not parse propertyName from trackName: `+e);return n}static findNode(e,t){if(t===void 0||t===``||t===`.`||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(e){for(let r=0;r<e.length;r++){let i=e[r];if(i.name===t||i.uuid===t)return i;let a=n(i.children);if(a)return a}return null},r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,i=n.length;r!==i;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,i=n.length;r!==i;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,i=n.length;r!==i;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,i=n.length;r!==i;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let t=this.node,n=this.parsedPath,r=n.objectName,i=n.propertyName,a=n.propertyIndex;if(t||(t=e.findNode(this.rootNode,n.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){V(`PropertyBinding: No target node found for track: `+this.path+`.`);return}if(r){let e=n.objectIndex;switch(r){case`materials`:if(!t.material){H(`PropertyBinding: Can not bind to material as node does not have a material.`,this);return}if(!t.material.materials){H(`PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.`,this);return}t=t.material.materials;break;case`bones`:if(!t.skeleton){H(`PropertyBinding: Can not bind to bones as node does not have a skeleton.`,this);return}t=t.skeleton.bones;for(let n=0;n<t.length;n++)if(t[n].name===e){e=n;break}break;case`map`:if(`map`in t){t=t.map;break}if(!t.material){H(`PropertyBinding: Can not bind to material as node does not have a material.`,this);return}if(!t.material.map){H(`PropertyBinding: Can not bind to material.map as node.material does not have a map.`,this);return}t=t.material.map;break;default:if(t[r]===void 0){H(`PropertyBinding: Can not bind to objectName of node undefined.`,this);return}t=t[r]}if(e!==void 0){if(t[e]===void 0){H(`PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.`,this,t);return}t=t[e]}}let o=t[i];if(o===void 0){let e=n.nodeName;H(`PropertyBinding: Trying to update property for track: `+e+`.`+i+` but it wasn't found.`,t);return}let s=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?s=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(s=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(a!==void 0){if(i===`morphTargetInfluences`){if(!t.geometry){H(`PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.`,this);return}if(!t.geometry.morphAttributes){H(`PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.`,this);return}t.morphTargetDictionary[a]!==void 0&&(a=t.morphTargetDictionary[a])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=a}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=i;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][s]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jg.Composite=Ag,jg.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3},jg.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2},jg.prototype.GetterByBindingType=[jg.prototype._getValue_direct,jg.prototype._getValue_array,jg.prototype._getValue_arrayElement,jg.prototype._getValue_toArray],jg.prototype.SetterByBindingTypeAndVersioning=[[jg.prototype._setValue_direct,jg.prototype._setValue_direct_setNeedsUpdate,jg.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jg.prototype._setValue_array,jg.prototype._setValue_array_setNeedsUpdate,jg.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jg.prototype._setValue_arrayElement,jg.prototype._setValue_arrayElement_setNeedsUpdate,jg.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jg.prototype._setValue_fromArray,jg.prototype._setValue_fromArray_setNeedsUpdate,jg.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Mg=new J,Ng=class{constructor(e,t,n=0,r=1/0){this.ray=new dm(e,t),this.near=n,this.far=r,this.camera=null,this.layers=new Pf,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):H(`Raycaster: Unsupported camera type: `+t.type)}setFromXRController(e){return Mg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Mg),this}intersectObject(e,t=!0,n=[]){return Fg(e,this,n,t),n.sort(Pg),n}intersectObjects(e,t=!0,n=[]){for(let r=0,i=e.length;r<i;r++)Fg(e[r],this,n,t);return n.sort(Pg),n}};function Pg(e,t){return e.distance-t.distance}function Fg(e,t,n,r){let i=!0;if(e.layers.test(t.layers)&&e.raycast(t,n)===!1&&(i=!1),i===!0&&r===!0){let r=e.children;for(let e=0,i=r.length;e<i;e++)Fg(r[e],t,n,!0)}}var Ig=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){let e=1e-6;return this.phi=U(this.phi,e,Math.PI-e),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(U(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};(class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let i=this.elements;return i[0]=e,i[2]=t,i[1]=n,i[3]=r,this}});var Lg=new G,Rg=new G,zg=new G,Bg=new G,Vg=new G,Hg=new G,Ug=new G,Wg=class{constructor(e=new G,t=new G){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){Lg.subVectors(e,this.start),Rg.subVectors(this.end,this.start);let n=Rg.dot(Rg);if(n===0)return 0;let r=Rg.dot(Lg)/n;return t&&(r=U(r,0,1)),r}closestPointToPoint(e,t,n){let r=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(r).add(this.start)}distanceSqToLine3(e,t=Hg,n=Ug){let r=1e-8*1e-8,i,a,o=this.start,s=e.start,c=this.end,l=e.end;zg.subVectors(c,o),Bg.subVectors(l,s),Vg.subVectors(o,s);let u=zg.dot(zg),d=Bg.dot(Bg),f=Bg.dot(Vg);if(u<=r&&d<=r)return t.copy(o),n.copy(s),t.distanceToSquared(n);if(u<=r)i=0,a=f/d,a=U(a,0,1);else{let e=zg.dot(Vg);if(d<=r)a=0,i=U(-e/u,0,1);else{let t=zg.dot(Bg),n=u*d-t*t;i=n===0?0:U((t*f-e*d)/n,0,1),a=(t*i+f)/d,a<0?(a=0,i=U(-e/u,0,1)):a>1&&(a=1,i=U((t-e)/u,0,1))}}return t.copy(o).addScaledVector(zg,i),n.copy(s).addScaledVector(Bg,a),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}},Gg=class extends Dd{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Kg(e,t,n,r){let i=qg(r);switch(n){case lu:return e*t;case mu:return e*t/i.components*i.byteLength;case hu:return e*t/i.components*i.byteLength;case gu:return e*t*2/i.components*i.byteLength;case _u:return e*t*2/i.components*i.byteLength;case uu:return e*t*3/i.components*i.byteLength;case du:return e*t*4/i.components*i.byteLength;case vu:return e*t*4/i.components*i.byteLength;case yu:case bu:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case xu:case Su:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case wu:case Eu:return Math.max(e,16)*Math.max(t,8)/4;case Cu:case Tu:return Math.max(e,8)*Math.max(t,8)/2;case Du:case Ou:case Au:case ju:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*8;case ku:case Mu:case Nu:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case Pu:return Math.floor((e+3)/4)*Math.floor((t+3)/4)*16;case Fu:return Math.floor((e+4)/5)*Math.floor((t+3)/4)*16;case Iu:return Math.floor((e+4)/5)*Math.floor((t+4)/5)*16;case Lu:return Math.floor((e+5)/6)*Math.floor((t+4)/5)*16;case Ru:return Math.floor((e+5)/6)*Math.floor((t+5)/6)*16;case zu:return Math.floor((e+7)/8)*Math.floor((t+4)/5)*16;case Bu:return Math.floor((e+7)/8)*Math.floor((t+5)/6)*16;case Vu:return Math.floor((e+7)/8)*Math.floor((t+7)/8)*16;case Hu:return Math.floor((e+9)/10)*Math.floor((t+4)/5)*16;case Uu:return Math.floor((e+9)/10)*Math.floor((t+5)/6)*16;case Wu:return Math.floor((e+9)/10)*Math.floor((t+7)/8)*16;case Gu:return Math.floor((e+9)/10)*Math.floor((t+9)/10)*16;case Ku:return Math.floor((e+11)/12)*Math.floor((t+9)/10)*16;case qu:return Math.floor((e+11)/12)*Math.floor((t+11)/12)*16;case Ju:case Yu:case Xu:return Math.ceil(e/4)*Math.ceil(t/4)*16;case Zu:case Qu:return Math.ceil(e/4)*Math.ceil(t/4)*8;case $u:case ed:return Math.ceil(e/4)*Math.ceil(t/4)*16}throw Error(`Unable to determine texture byte length for ${n} format.`)}function qg(e){switch(e){case Xl:case Zl:return{byteLength:1,components:1};case $l:case Ql:case ru:return{byteLength:2,components:1};case iu:case au:return{byteLength:2,components:4};case tu:case eu:case nu:return{byteLength:4,components:1};case su:case cu:return{byteLength:4,components:3}}throw Error(`THREE.TextureUtils: Unknown texture type ${e}.`)}typeof __THREE_DEVTOOLS__<`u`&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent(`register`,{detail:{revision:`187`}})),typeof window<`u`&&(window.__THREE__?V(`WARNING: Multiple instances of Three.js being imported.`):window.__THREE__=`187`);function Jg(){let e=null,t=!1,n=null,r=null;function i(t,a){r=e.requestAnimationFrame(i),n(t,a)}return{start:function(){t!==!0&&n!==null&&e!==null&&(r=e.requestAnimationFrame(i),t=!0)},stop:function(){e!==null&&e.cancelAnimationFrame(r),t=!1},setAnimationLoop:function(e){n=e},setContext:function(t){e=t}}}function Yg(e){let t=new WeakMap;function n(t,n){let r=t.array,i=t.usage,a=r.byteLength,o=e.createBuffer();e.bindBuffer(n,o),e.bufferData(n,r,i),t.onUploadCallback();let s;if(r instanceof Float32Array)s=e.FLOAT;else if(typeof Float16Array<`u`&&r instanceof Float16Array)s=e.HALF_FLOAT;else if(r instanceof Uint16Array)s=t.isFloat16BufferAttribute?e.HALF_FLOAT:e.UNSIGNED_SHORT;else if(r instanceof Int16Array)s=e.SHORT;else if(r instanceof Uint32Array)s=e.UNSIGNED_INT;else if(r instanceof Int32Array)s=e.INT;else if(r instanceof Int8Array)s=e.BYTE;else if(r instanceof Uint8Array)s=e.UNSIGNED_BYTE;else if(r instanceof Uint8ClampedArray)s=e.UNSIGNED_BYTE;else throw Error(`THREE.WebGLAttributes: Unsupported buffer data format: `+r);return{buffer:o,type:s,bytesPerElement:r.BYTES_PER_ELEMENT,version:t.version,size:a}}function r(t,n,r){let i=n.array,a=n.updateRanges;if(e.bindBuffer(r,t),a.length===0)e.bufferSubData(r,0,i);else{a.sort((e,t)=>e.start-t.start);let t=0;for(let e=1;e<a.length;e++){let n=a[t],r=a[e];r.start<=n.start+n.count+1?n.count=Math.max(n.count,r.start+r.count-n.start):(++t,a[t]=r)}a.length=t+1;for(let t=0,n=a.length;t<n;t++){let n=a[t];e.bufferSubData(r,n.start*i.BYTES_PER_ELEMENT,i,n.start,n.count)}n.clearUpdateRanges()}n.onUploadCallback()}function i(e){return e.isInterleavedBufferAttribute&&(e=e.data),t.get(e)}function a(n){n.isInterleavedBufferAttribute&&(n=n.data);let r=t.get(n);r&&(e.deleteBuffer(r.buffer),t.delete(n))}function o(e,i){if(e.isInterleavedBufferAttribute&&(e=e.data),e.isGLBufferAttribute){let n=t.get(e);(!n||n.version<e.version)&&t.set(e,{buffer:e.buffer,type:e.type,bytesPerElement:e.elementSize,version:e.version});return}let a=t.get(e);if(a===void 0)t.set(e,n(e,i));else if(a.version<e.version){if(a.size!==e.array.byteLength)throw Error(`THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.`);r(a.buffer,e,i),a.version=e.version}}return{get:i,remove:a,update:o}}var X={alphahash_fragment:`#ifdef USE_ALPHAHASH
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
}`},Z={common:{diffuse:{value:new Y(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new K},alphaMap:{value:null},alphaMapTransform:{value:new K},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new K}},envmap:{envMap:{value:null},envMapRotation:{value:new K},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new K}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new K}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new K},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new K},normalScale:{value:new W(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new K},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new K}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new K}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new K}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Y(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Y(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new K},alphaTest:{value:0},uvTransform:{value:new K}},sprite:{diffuse:{value:new Y(16777215)},opacity:{value:1},center:{value:new W(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new K},alphaMap:{value:null},alphaMapTransform:{value:new K},alphaTest:{value:0}}},Xg={basic:{uniforms:xh([Z.common,Z.specularmap,Z.envmap,Z.aomap,Z.lightmap,Z.fog]),vertexShader:X.meshbasic_vert,fragmentShader:X.meshbasic_frag},lambert:{uniforms:xh([Z.common,Z.specularmap,Z.envmap,Z.aomap,Z.lightmap,Z.emissivemap,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.fog,Z.lights,{emissive:{value:new Y(0)},envMapIntensity:{value:1}}]),vertexShader:X.meshlambert_vert,fragmentShader:X.meshlambert_frag},phong:{uniforms:xh([Z.common,Z.specularmap,Z.envmap,Z.aomap,Z.lightmap,Z.emissivemap,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.fog,Z.lights,{emissive:{value:new Y(0)},specular:{value:new Y(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:X.meshphong_vert,fragmentShader:X.meshphong_frag},standard:{uniforms:xh([Z.common,Z.envmap,Z.aomap,Z.lightmap,Z.emissivemap,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.roughnessmap,Z.metalnessmap,Z.fog,Z.lights,{emissive:{value:new Y(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:X.meshphysical_vert,fragmentShader:X.meshphysical_frag},toon:{uniforms:xh([Z.common,Z.aomap,Z.lightmap,Z.emissivemap,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.gradientmap,Z.fog,Z.lights,{emissive:{value:new Y(0)}}]),vertexShader:X.meshtoon_vert,fragmentShader:X.meshtoon_frag},matcap:{uniforms:xh([Z.common,Z.bumpmap,Z.normalmap,Z.displacementmap,Z.fog,{matcap:{value:null}}]),vertexShader:X.meshmatcap_vert,fragmentShader:X.meshmatcap_frag},points:{uniforms:xh([Z.points,Z.fog]),vertexShader:X.points_vert,fragmentShader:X.points_frag},dashed:{uniforms:xh([Z.common,Z.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:X.linedashed_vert,fragmentShader:X.linedashed_frag},depth:{uniforms:xh([Z.common,Z.displacementmap]),vertexShader:X.depth_vert,fragmentShader:X.depth_frag},normal:{uniforms:xh([Z.common,Z.bumpmap,Z.normalmap,Z.displacementmap,{opacity:{value:1}}]),vertexShader:X.meshnormal_vert,fragmentShader:X.meshnormal_frag},sprite:{uniforms:xh([Z.sprite,Z.fog]),vertexShader:X.sprite_vert,fragmentShader:X.sprite_frag},background:{uniforms:{uvTransform:{value:new K},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:X.background_vert,fragmentShader:X.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new K}},vertexShader:X.backgroundCube_vert,fragmentShader:X.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:X.cube_vert,fragmentShader:X.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:X.equirect_vert,fragmentShader:X.equirect_frag},distance:{uniforms:xh([Z.common,Z.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:X.distance_vert,fragmentShader:X.distance_frag},shadow:{uniforms:xh([Z.lights,Z.fog,{color:{value:new Y(0)},opacity:{value:1}}]),vertexShader:X.shadow_vert,fragmentShader:X.shadow_frag}};Xg.physical={uniforms:xh([Xg.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new K},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new K},clearcoatNormalScale:{value:new W(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new K},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new K},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new K},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new K},sheen:{value:0},sheenColor:{value:new Y(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new K},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new K},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new K},transmissionSamplerSize:{value:new W},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new K},attenuationDistance:{value:0},attenuationColor:{value:new Y(0)},specularColor:{value:new Y(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new K},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new K},anisotropyVector:{value:new W},anisotropyMap:{value:null},anisotropyMapTransform:{value:new K}}]),vertexShader:X.meshphysical_vert,fragmentShader:X.meshphysical_frag};var Zg={r:0,b:0,g:0},Qg=new J,$g=new K;$g.set(-1,0,0,0,1,0,0,0,1);function e_(e,t,n,r,i,a){let o=new Y(0),s=i===!0?0:1,c,l,u=null,d=0,f=null;function p(e){let n=e.isScene===!0?e.background:null;if(n&&n.isTexture){let r=e.backgroundBlurriness>0;n=t.get(n,r)}return n}function m(t){let r=!1,i=p(t);i===null?g(o,s):i&&i.isColor&&(g(i,1),r=!0);let c=e.xr.getEnvironmentBlendMode();c===`additive`?n.buffers.color.setClear(0,0,0,1,a):c===`alpha-blend`&&n.buffers.color.setClear(0,0,0,0,a),(e.autoClear||r)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),e.clear(e.autoClearColor,e.autoClearDepth,e.autoClearStencil))}function h(t,n){let i=p(n);i&&i.isCubeTexture?(l===void 0&&(l=new wm(new ph(1,1,1),new Oh({name:`BackgroundCubeMaterial`,uniforms:bh(Xg.backgroundCube.uniforms),vertexShader:Xg.backgroundCube.vertexShader,fragmentShader:Xg.backgroundCube.fragmentShader,side:1,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute(`normal`),l.geometry.deleteAttribute(`uv`),l.onBeforeRender=function(e,t,n){this.matrixWorld.copyPosition(n.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),r.update(l)),l.material.uniforms.envMap.value=i,l.material.uniforms.backgroundBlurriness.value=n.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=n.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Qg.makeRotationFromEuler(n.backgroundRotation)).transpose(),i.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply($g),l.material.toneMapped=q.getTransfer(i.colorSpace)!==fd,(u!==i||d!==i.version||f!==e.toneMapping)&&(l.material.needsUpdate=!0,u=i,d=i.version,f=e.toneMapping),l.layers.enableAll(),t.unshift(l,l.geometry,l.material,0,0,null)):i&&i.isTexture&&(c===void 0&&(c=new wm(new vh(2,2),new Oh({name:`BackgroundMaterial`,uniforms:bh(Xg.background.uniforms),vertexShader:Xg.background.vertexShader,fragmentShader:Xg.background.fragmentShader,side:0,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute(`normal`),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),r.update(c)),c.material.uniforms.t2D.value=i,c.material.uniforms.backgroundIntensity.value=n.backgroundIntensity,c.material.toneMapped=q.getTransfer(i.colorSpace)!==fd,i.matrixAutoUpdate===!0&&i.updateMatrix(),c.material.uniforms.uvTransform.value.copy(i.matrix),(u!==i||d!==i.version||f!==e.toneMapping)&&(c.material.needsUpdate=!0,u=i,d=i.version,f=e.toneMapping),c.layers.enableAll(),t.unshift(c,c.geometry,c.material,0,0,null))}function g(t,r){t.getRGB(Zg,wh(e)),n.buffers.color.setClear(Zg.r,Zg.g,Zg.b,r,a)}function _(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(e,t=1){o.set(e),s=t,g(o,s)},getClearAlpha:function(){return s},setClearAlpha:function(e){s=e,g(o,s)},render:m,addToRenderList:h,dispose:_}}function t_(e,t){let n=e.getParameter(e.MAX_VERTEX_ATTRIBS),r={},i=f(null),a=i,o=!1;function s(n,r,i,s,c){let u=!1,f=d(n,s,i,r);a!==f&&(a=f,l(a.object)),u=p(n,s,i,c),u&&m(n,s,i,c),c!==null&&t.update(c,e.ELEMENT_ARRAY_BUFFER),(u||o)&&(o=!1,b(n,r,i,s),c!==null&&e.bindBuffer(e.ELEMENT_ARRAY_BUFFER,t.get(c).buffer))}function c(){return e.createVertexArray()}function l(t){return e.bindVertexArray(t)}function u(t){return e.deleteVertexArray(t)}function d(e,t,n,i){let a=i.wireframe===!0,o=r[t.id];o===void 0&&(o={},r[t.id]=o);let s=e.isInstancedMesh===!0?e.id:0,l=o[s];l===void 0&&(l={},o[s]=l);let u=l[n.id];u===void 0&&(u={},l[n.id]=u);let d=u[a];return d===void 0&&(d=f(c()),u[a]=d),d}function f(e){let t=[],r=[],i=[];for(let e=0;e<n;e++)t[e]=0,r[e]=0,i[e]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:t,enabledAttributes:r,attributeDivisors:i,object:e,attributes:{},index:null}}function p(e,t,n,r){let i=a.attributes,o=t.attributes,s=0,c=n.getAttributes();for(let t in c)if(c[t].location>=0){let n=i[t],r=o[t];if(r===void 0&&(t===`instanceMatrix`&&e.instanceMatrix&&(r=e.instanceMatrix),t===`instanceColor`&&e.instanceColor&&(r=e.instanceColor)),n===void 0||n.attribute!==r||r&&n.data!==r.data)return!0;s++}return a.attributesNum!==s||a.index!==r}function m(e,t,n,r){let i={},o=t.attributes,s=0,c=n.getAttributes();for(let t in c)if(c[t].location>=0){let n=o[t];n===void 0&&(t===`instanceMatrix`&&e.instanceMatrix&&(n=e.instanceMatrix),t===`instanceColor`&&e.instanceColor&&(n=e.instanceColor));let r={};r.attribute=n,n&&n.data&&(r.data=n.data),i[t]=r,s++}a.attributes=i,a.attributesNum=s,a.index=r}function h(){let e=a.newAttributes;for(let t=0,n=e.length;t<n;t++)e[t]=0}function g(e){_(e,0)}function _(t,n){let r=a.newAttributes,i=a.enabledAttributes,o=a.attributeDivisors;r[t]=1,i[t]===0&&(e.enableVertexAttribArray(t),i[t]=1),o[t]!==n&&(e.vertexAttribDivisor(t,n),o[t]=n)}function v(){let t=a.newAttributes,n=a.enabledAttributes;for(let r=0,i=n.length;r<i;r++)n[r]!==t[r]&&(e.disableVertexAttribArray(r),n[r]=0)}function y(t,n,r,i,a,o,s){s===!0?e.vertexAttribIPointer(t,n,r,a,o):e.vertexAttribPointer(t,n,r,i,a,o)}function b(n,r,i,a){h();let o=a.attributes,s=i.getAttributes(),c=r.defaultAttributeValues;for(let r in s){let i=s[r];if(i.location>=0){let s=o[r];if(s===void 0&&(r===`instanceMatrix`&&n.instanceMatrix&&(s=n.instanceMatrix),r===`instanceColor`&&n.instanceColor&&(s=n.instanceColor)),s!==void 0){let r=s.normalized,o=s.itemSize,c=t.get(s);if(c===void 0)continue;let l=c.buffer,u=c.type,d=c.bytesPerElement,f=u===e.INT||u===e.UNSIGNED_INT||s.gpuType===1013;if(s.isInterleavedBufferAttribute){let t=s.data,c=t.isInterleavedBuffer===!0?t.stride:t.itemSize,p=s.offset;if(t.isInstancedInterleavedBuffer||t.isInstancedBufferAttribute){for(let e=0;e<i.locationSize;e++)_(i.location+e,t.meshPerAttribute);n.isInstancedMesh!==!0&&a._maxInstanceCount===void 0&&(a._maxInstanceCount=t.meshPerAttribute*t.count)}else for(let e=0;e<i.locationSize;e++)g(i.location+e);e.bindBuffer(e.ARRAY_BUFFER,l);for(let e=0;e<i.locationSize;e++)y(i.location+e,o/i.locationSize,u,r,c*d,(p+o/i.locationSize*e)*d,f)}else{if(s.isInstancedBufferAttribute){for(let e=0;e<i.locationSize;e++)_(i.location+e,s.meshPerAttribute);n.isInstancedMesh!==!0&&a._maxInstanceCount===void 0&&(a._maxInstanceCount=s.meshPerAttribute*s.count)}else for(let e=0;e<i.locationSize;e++)g(i.location+e);e.bindBuffer(e.ARRAY_BUFFER,l);for(let e=0;e<i.locationSize;e++)y(i.location+e,o/i.locationSize,u,r,o*d,o/i.locationSize*e*d,f)}}else if(c!==void 0){let t=c[r];if(t!==void 0)switch(t.length){case 2:e.vertexAttrib2fv(i.location,t);break;case 3:e.vertexAttrib3fv(i.location,t);break;case 4:e.vertexAttrib4fv(i.location,t);break;default:e.vertexAttrib1fv(i.location,t)}}}}v()}function x(){T();for(let e in r){let t=r[e];for(let e in t){let n=t[e];for(let e in n){let t=n[e];for(let e in t)u(t[e].object),delete t[e];delete n[e]}}delete r[e]}}function S(e){if(r[e.id]===void 0)return;let t=r[e.id];for(let e in t){let n=t[e];for(let e in n){let t=n[e];for(let e in t)u(t[e].object),delete t[e];delete n[e]}}delete r[e.id]}function C(e){for(let t in r){let n=r[t];for(let t in n){let r=n[t];if(r[e.id]===void 0)continue;let i=r[e.id];for(let e in i)u(i[e].object),delete i[e];delete r[e.id]}}}function w(e){for(let t in r){let n=r[t],i=e.isInstancedMesh===!0?e.id:0,a=n[i];if(a!==void 0){for(let e in a){let t=a[e];for(let e in t)u(t[e].object),delete t[e];delete a[e]}delete n[i],Object.keys(n).length===0&&delete r[t]}}}function T(){E(),o=!0,a!==i&&(a=i,l(a.object))}function E(){i.geometry=null,i.program=null,i.wireframe=!1}return{setup:s,reset:T,resetDefaultState:E,dispose:x,releaseStatesOfGeometry:S,releaseStatesOfObject:w,releaseStatesOfProgram:C,initAttributes:h,enableAttribute:g,disableUnusedAttributes:v}}function n_(e,t,n){let r;function i(e){r=e}function a(t,i){e.drawArrays(r,t,i),n.update(i,r,1)}function o(t,i,a){a!==0&&(e.drawArraysInstanced(r,t,i,a),n.update(i,r,a))}function s(e,i,a){if(a===0)return;t.get(`WEBGL_multi_draw`).multiDrawArraysWEBGL(r,e,0,i,0,a);let o=0;for(let e=0;e<a;e++)o+=i[e];n.update(o,r,1)}this.setMode=i,this.render=a,this.renderInstances=o,this.renderMultiDraw=s}function r_(e,t,n,r){let i;function a(){if(i!==void 0)return i;if(t.has(`EXT_texture_filter_anisotropic`)===!0){let n=t.get(`EXT_texture_filter_anisotropic`);i=e.getParameter(n.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else i=0;return i}function o(t){return t===1023||r.convert(t)===e.getParameter(e.IMPLEMENTATION_COLOR_READ_FORMAT)}function s(n){let i=n===1016&&(t.has(`EXT_color_buffer_half_float`)||t.has(`EXT_color_buffer_float`));return!(n!==1009&&n!==1015&&!i&&r.convert(n)!==e.getParameter(e.IMPLEMENTATION_COLOR_READ_TYPE))}function c(t){if(t===`highp`){if(e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.HIGH_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.HIGH_FLOAT).precision>0)return`highp`;t=`mediump`}return t===`mediump`&&e.getShaderPrecisionFormat(e.VERTEX_SHADER,e.MEDIUM_FLOAT).precision>0&&e.getShaderPrecisionFormat(e.FRAGMENT_SHADER,e.MEDIUM_FLOAT).precision>0?`mediump`:`lowp`}let l=n.precision===void 0?`highp`:n.precision,u=c(l);u!==l&&(V(`WebGLRenderer:`,l,`not supported, using`,u,`instead.`),l=u);let d=n.reversedDepthBuffer===!0&&t.has(`EXT_clip_control`),f=n.logarithmicDepthBuffer===!0&&d===!1;n.reversedDepthBuffer===!0&&d===!1&&V(`WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.`),n.logarithmicDepthBuffer===!0&&d===!0&&V(`WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.`);let p=e.getParameter(e.MAX_TEXTURE_IMAGE_UNITS),m=e.getParameter(e.MAX_VERTEX_TEXTURE_IMAGE_UNITS),h=e.getParameter(e.MAX_TEXTURE_SIZE),g=e.getParameter(e.MAX_CUBE_MAP_TEXTURE_SIZE),_=e.getParameter(e.MAX_VERTEX_ATTRIBS),v=e.getParameter(e.MAX_VERTEX_UNIFORM_VECTORS),y=e.getParameter(e.MAX_VARYING_VECTORS),b=e.getParameter(e.MAX_FRAGMENT_UNIFORM_VECTORS),x=e.getParameter(e.MAX_SAMPLES),S=e.getParameter(e.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:a,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:s,precision:l,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:m,maxTextureSize:h,maxCubemapSize:g,maxAttributes:_,maxVertexUniforms:v,maxVaryings:y,maxFragmentUniforms:b,maxSamples:x,samples:S}}function i_(e){let t=this,n=null,r=0,i=!1,a=!1,o=new im,s=new K,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(e,t){let n=e.length!==0||t||r!==0||i;return i=t,r=e.length,n},this.beginShadows=function(){a=!0,u(null)},this.endShadows=function(){a=!1},this.setGlobalState=function(e,t){n=u(e,t,0)},this.setState=function(t,o,s){let d=t.clippingPlanes,f=t.clipIntersection,p=t.clipShadows,m=e.get(t);if(!i||d===null||d.length===0||a&&!p)a?u(null):l();else{let e=a?0:r,t=e*4,i=m.clippingState||null;c.value=i,i=u(d,o,t,s);for(let e=0;e!==t;++e)i[e]=n[e];m.clippingState=i,this.numIntersection=f?this.numPlanes:0,this.numPlanes+=e}};function l(){c.value!==n&&(c.value=n,c.needsUpdate=r>0),t.numPlanes=r,t.numIntersection=0}function u(e,n,r,i){let a=e===null?0:e.length,l=null;if(a!==0){if(l=c.value,i!==!0||l===null){let t=r+a*4,i=n.matrixWorldInverse;s.getNormalMatrix(i),(l===null||l.length<t)&&(l=new Float32Array(t));for(let t=0,n=r;t!==a;++t,n+=4)o.copy(e[t]).applyMatrix4(i,s),o.normal.toArray(l,n),l[n+3]=o.constant}c.value=l,c.needsUpdate=!0}return t.numPlanes=a,t.numIntersection=0,l}}var a_=class extends xf{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new lh(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new ph(5,5,5),i=new Oh({name:`CubemapFromEquirect`,uniforms:bh(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:1,blending:0});i.uniforms.tEquirect.value=t;let a=new wm(r,i),o=t.minFilter;return t.minFilter===1008&&(t.minFilter=ql),new vg(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let i=e.getRenderTarget();for(let i=0;i<6;i++)e.setRenderTarget(this,i),e.clear(t,n,r);e.setRenderTarget(i)}},o_=256,s_=3,c_=20,l_=256,u_=16,d_=3,f_=new G,p_=new Y,m_=class e{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new vg(1,10,null),this._boxMesh=new wm(new ph(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,i={}){let{size:a=256,position:o=f_}=i,s=this._renderer;this._setSize(a);let c=this._allocateTarget(),l=this._getSourceTarget(!0);t>0&&(l.texture.mipmapsAutoUpdate=!1);let u=s.autoClear,d=s.autoClearColor,f=s.autoClearDepth,p=s.autoClearStencil,m=e.background;s.autoClear=!0,s.autoClearColor=!0,s.autoClearDepth=!0,s.autoClearStencil=!0,m===null&&(e.background=s.getClearColor(p_));let h=new vg(n,r,l);return h.position.copy(o),h.update(s,e),s.autoClear=u,s.autoClearColor=d,s.autoClearDepth=f,s.autoClearStencil=p,e.background=m,t>0&&(l.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=x_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=b_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(o_,Yd(e))}_fromTexture(e,t){e.mapping===301||e.mapping===302?this._setSize(e.image.length===0?o_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=h_(e,!1,!1),n=Math.log2(e)-s_;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name=`PMREM`,t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=h_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,i=this._cubeCamera;r.material=n,i.renderTarget=e,i.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),i.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===301||e.mapping===302?(this._cubemapMaterial===null&&(this._cubemapMaterial=x_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=b_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=__(),this._integrationMaterial=v_());let n=this._cubeSize,r=t.texture.mipmaps.length-1,i=this._ggxMaterial.uniforms;i.envMap.value=this._sourceTarget.texture;let a=this._integrationMaterial.uniforms;a.envMap.value=this._sourceTarget.texture,a.sourceLod.value=Math.log2(n/u_);for(let o=0;o<=r;o++){let s=e.lodToRoughness(o,r);if(o>r-d_)a.roughness.value=s,this._renderCube(t,o,this._integrationMaterial);else{let e=s>0?Math.log2(n)+.5*Math.log2(6/(l_*s**4))+.5:0;i.roughness.value=s,i.lodBias.value=e,this._renderCube(t,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=y_());let n=this._blurMaterial,r=n.uniforms,i=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=i.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(i,0,n)}};function h_(e,t,n){return new a_(e,{minFilter:Yl,generateMipmaps:t,type:ru,colorSpace:ud,depthBuffer:n})}function g_(e,t,n){return new Oh({name:e,uniforms:t,vertexShader:X.cube_vert,fragmentShader:n,side:1,blending:0,depthTest:!1,depthWrite:!1})}function __(){return g_(`PMREMGGXConvolution`,{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${l_}u

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
	`)}function v_(){return g_(`PMREMGGXIntegration`,{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:u_}},`

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
	`)}function y_(){return g_(`PMREMSphericalGaussianBlur`,{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${c_}
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
	`)}function b_(){return g_(`PMREMEquirectangularToCubemap`,{envMap:{value:null}},`

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
	`)}function x_(){return g_(`PMREMCubemapToCubemap`,{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function S_(e){let t=new WeakMap,n=new WeakMap,r=null;function i(e,t=!1){return e==null?null:t?o(e):a(e)}function a(n){if(n&&n.isTexture){let r=n.mapping;if(r===303||r===304){if(t.has(n)){let e=t.get(n).texture;return s(e,n.mapping)}{let r=n.image;if(r&&r.height>0){let i=new a_(r.height);return i.fromEquirectangularTexture(e,n),t.set(n,i),n.addEventListener(`dispose`,l),s(i.texture,n.mapping)}return null}}}return n}function o(t){if(t&&t.isTexture&&t.isPMREMTexture!==!0){let i=t.mapping,a=i===303||i===304,o=i===301||i===302;if(a||o){let i=n.get(t),s=i===void 0?0:i.texture.pmremVersion;if(t.isRenderTargetTexture&&t.pmremVersion!==s)return r===null&&(r=new m_(e)),i=a?r.fromEquirectangular(t,i):r.fromCubemap(t,i),i.texture.pmremVersion=t.pmremVersion,n.set(t,i),i.texture;if(i!==void 0)return i.texture;{let s=t.image;return a&&s&&s.height>0||o&&s&&c(s)?(r===null&&(r=new m_(e)),i=a?r.fromEquirectangular(t):r.fromCubemap(t),i.texture.pmremVersion=t.pmremVersion,n.set(t,i),t.addEventListener(`dispose`,u),i.texture):null}}}return t}function s(e,t){return t===303?e.mapping=301:t===304&&(e.mapping=302),e}function c(e){let t=0;for(let n=0;n<6;n++)e[n]!==void 0&&t++;return t===6}function l(e){let n=e.target;n.removeEventListener(`dispose`,l);let r=t.get(n);r!==void 0&&(t.delete(n),r.dispose())}function u(e){let t=e.target;t.removeEventListener(`dispose`,u);let r=n.get(t);r!==void 0&&(n.delete(t),r.dispose())}function d(){t=new WeakMap,n=new WeakMap,r!==null&&(r.dispose(),r=null)}return{get:i,dispose:d}}function C_(e){let t={};function n(n){if(t[n]!==void 0)return t[n];let r=e.getExtension(n);return t[n]=r,r}return{has:function(e){return n(e)!==null},init:function(){n(`EXT_color_buffer_float`),n(`WEBGL_clip_cull_distance`),n(`OES_texture_float_linear`),n(`EXT_color_buffer_half_float`),n(`WEBGL_multisampled_render_to_texture`),n(`WEBGL_render_shared_exponent`)},get:function(e){let t=n(e);return t===null&&wd(`WebGLRenderer: `+e+` extension not supported.`),t}}}function w_(e,t,n,r){let i={},a=new WeakMap,o=new FinalizationRegistry(e=>delete i[e]);function s(e){c(e.target)}function c(e){e.index!==null&&t.remove(e.index);for(let n in e.attributes)t.remove(e.attributes[n]);e.removeEventListener(`dispose`,s),delete i[e.id],o.unregister(e);let c=a.get(e);c&&(t.remove(c),a.delete(e)),r.releaseStatesOfGeometry(e),e.isInstancedBufferGeometry===!0&&delete e._maxInstanceCount,n.memory.geometries--}function l(e,t){return i[t.id]===void 0&&(t.addEventListener(`dispose`,s),i[t.id]=new WeakRef(t),o.register(t,t.id,t),n.memory.geometries++),t}function u(n){let r=n.attributes;for(let n in r)t.update(r[n],e.ARRAY_BUFFER)}function d(e){let n=e.index,r=e.attributes.position,i=0;if(r===void 0)return;let o=n===null?r.array.length/3-1:n.array.length,s=new(r.count>=65535?Vp:Bp)(Math.ceil(o/3)*6,1),c=s.array;if(n!==null){let e=n.array;i=n.version;for(let t=0,n=0;t<o;t+=3){let r=e[t+0],i=e[t+1],a=e[t+2];c[n++]=r,c[n++]=i,c[n++]=i,c[n++]=a,c[n++]=a,c[n++]=r}}else{i=r.version;for(let e=0,t=0;e<o;e+=3){let n=e+0,r=e+1,i=e+2;c[t++]=n,c[t++]=r,c[t++]=r,c[t++]=i,c[t++]=i,c[t++]=n}}s.version=i;let l=a.get(e);l&&t.remove(l),a.set(e,s)}function f(e){let t=a.get(e);if(t){let n=e.index;n!==null&&t.version<n.version&&d(e)}else d(e);return a.get(e)}function p(){for(let e in i){let t=i[e].deref();t!==void 0&&c(t)}}return{get:l,update:u,getWireframeAttribute:f,dispose:p}}function T_(e,t,n){let r;function i(e){r=e}let a,o;function s(e){a=e.type,o=e.bytesPerElement}function c(t,i){e.drawElements(r,i,a,t*o),n.update(i,r,1)}function l(t,i,s){s!==0&&(e.drawElementsInstanced(r,i,a,t*o,s),n.update(i,r,s))}function u(e,i,o){if(o===0)return;t.get(`WEBGL_multi_draw`).multiDrawElementsWEBGL(r,i,0,a,e,0,o);let s=0;for(let e=0;e<o;e++)s+=i[e];n.update(s,r,1)}this.setMode=i,this.setIndex=s,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function E_(e){let t={geometries:0,textures:0},n={frame:0,calls:0,triangles:0,points:0,lines:0};function r(t,r,i){switch(n.calls++,r){case e.TRIANGLES:n.triangles+=t/3*i;break;case e.LINES:n.lines+=t/2*i;break;case e.LINE_STRIP:n.lines+=i*(t-1);break;case e.LINE_LOOP:n.lines+=i*t;break;case e.POINTS:n.points+=i*t;break;default:H(`WebGLInfo: Unknown draw mode:`,r)}}function i(){n.calls=0,n.triangles=0,n.points=0,n.lines=0}return{memory:t,render:n,programs:null,autoReset:!0,reset:i,update:r}}function D_(e,t,n){let r=new WeakMap,i=new yf;function a(a,o,s){let c=a.morphTargetInfluences,l=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=l===void 0?0:l.length,d=r.get(o);if(d===void 0||d.count!==u){d!==void 0&&d.texture.dispose();let e=o.morphAttributes.position!==void 0,n=o.morphAttributes.normal!==void 0,a=o.morphAttributes.color!==void 0,s=o.morphAttributes.position||[],c=o.morphAttributes.normal||[],l=o.morphAttributes.color||[],f=0;e===!0&&(f=1),n===!0&&(f=2),a===!0&&(f=3);let p=o.attributes.position.count*f,m=1;p>t.maxTextureSize&&(m=Math.ceil(p/t.maxTextureSize),p=t.maxTextureSize);let h=new Float32Array(p*m*4*u),g=new Sf(h,p,m,u);g.type=nu,g.needsUpdate=!0;let _=f*4;for(let t=0;t<u;t++){let r=s[t],o=c[t],u=l[t],d=p*m*4*t;for(let t=0;t<r.count;t++){let s=t*_;e===!0&&(i.fromBufferAttribute(r,t),h[d+s+0]=i.x,h[d+s+1]=i.y,h[d+s+2]=i.z,h[d+s+3]=0),n===!0&&(i.fromBufferAttribute(o,t),h[d+s+4]=i.x,h[d+s+5]=i.y,h[d+s+6]=i.z,h[d+s+7]=0),a===!0&&(i.fromBufferAttribute(u,t),h[d+s+8]=i.x,h[d+s+9]=i.y,h[d+s+10]=i.z,h[d+s+11]=u.itemSize===4?i.w:1)}}d={count:u,texture:g,size:new W(p,m)},r.set(o,d);function v(){g.dispose(),r.delete(o),o.removeEventListener(`dispose`,v)}o.addEventListener(`dispose`,v)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)s.getUniforms().setValue(e,`morphTexture`,a.morphTexture,n);else{let t=0;for(let e=0;e<c.length;e++)t+=c[e];let n=o.morphTargetsRelative?1:1-t;s.getUniforms().setValue(e,`morphTargetBaseInfluence`,n),s.getUniforms().setValue(e,`morphTargetInfluences`,c)}s.getUniforms().setValue(e,`morphTargetsTexture`,d.texture,n),s.getUniforms().setValue(e,`morphTargetsTextureSize`,d.size)}return{update:a}}function O_(e,t,n,r,i){let a=new WeakMap;function o(r){let o=i.render.frame,s=r.geometry,l=t.get(r,s);if(a.get(l)!==o&&(t.update(l),a.set(l,o)),r.isInstancedMesh&&(r.hasEventListener(`dispose`,c)===!1&&r.addEventListener(`dispose`,c),a.get(r)!==o&&(n.update(r.instanceMatrix,e.ARRAY_BUFFER),r.instanceColor!==null&&n.update(r.instanceColor,e.ARRAY_BUFFER),a.set(r,o))),r.isSkinnedMesh){let e=r.skeleton;a.get(e)!==o&&(e.update(),a.set(e,o))}return l}function s(){a=new WeakMap}function c(e){let t=e.target;t.removeEventListener(`dispose`,c),r.releaseStatesOfObject(t),n.remove(t.instanceMatrix),t.instanceColor!==null&&n.remove(t.instanceColor)}return{update:o,dispose:s}}var k_={1:`LINEAR_TONE_MAPPING`,2:`REINHARD_TONE_MAPPING`,3:`CINEON_TONE_MAPPING`,4:`ACES_FILMIC_TONE_MAPPING`,6:`AGX_TONE_MAPPING`,7:`NEUTRAL_TONE_MAPPING`,5:`CUSTOM_TONE_MAPPING`};function A_(e,t,n,r,i,a){let o=new xf(t,n,{type:e,depthBuffer:i,stencilBuffer:a,samples:r?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),s=null,c=null,l=null,u=new em;u.setAttribute(`position`,new Hp([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute(`uv`,new Hp([0,2,0,0,2,0],2));let d=new kh({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new wm(u,d),p=new pg(-1,1,1,-1,0,1),m=null,h=null,g=!1,_,v=null,y=[],b=!1;this.setSize=function(e,t){o.setSize(e,t),s!==null&&s.setSize(e,t),c!==null&&c.setSize(e,t);for(let n=0;n<y.length;n++){let r=y[n];r.setSize&&r.setSize(e,t)}},this.setEffects=function(e){y=e,b=y.length>0&&y[0].isRenderPass===!0;let t=o.width,n=o.height;y.length>0&&s===null&&(s=new xf(t,n,{type:ru,depthBuffer:!1,stencilBuffer:!1}),c=new xf(t,n,{type:ru,depthBuffer:!1,stencilBuffer:!1}));let r=i===!0&&y.some(e=>e.needsDepthTexture===!0);r!==(o.depthTexture!==null)&&(r===!0&&l===null&&(l=new uh(t,n),a===!0&&(l.format=pu,l.type=ou)),o.dispose(),o.depthTexture=r?l:null,o.resolveDepthBuffer=r,o.storeMultisampledDepthBuffer=r);for(let e=0;e<y.length;e++){let i=y[e];i.setSize&&i.setSize(t,n),r&&i.needsDepthTexture===!0&&i.setDepthTexture&&i.setDepthTexture(l)}},this.begin=function(e,t){if(g||e.toneMapping===0&&y.length===0)return!1;if(v=t,t!==null){let e=t.width,n=t.height;(o.width!==e||o.height!==n)&&this.setSize(e,n)}return b===!1&&e.setRenderTarget(o),_=e.toneMapping,e.toneMapping=0,!0},this.hasRenderPass=function(){return b},this.end=function(e,t){e.toneMapping=_,g=!0;let n=o,r=s;for(let i=0;i<y.length;i++){let a=y[i];a.enabled!==!1&&(a.render(e,r,n,t),a.needsSwap!==!1&&(n=r,r=r===s?c:s))}if(m!==e.outputColorSpace||h!==e.toneMapping){m=e.outputColorSpace,h=e.toneMapping,d.defines={},q.getTransfer(m)===`srgb`&&(d.defines.SRGB_TRANSFER=``);let t=k_[h];t&&(d.defines[t]=``),d.needsUpdate=!0}d.uniforms.tDiffuse.value=n.texture,e.setRenderTarget(v),e.render(f,p),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),s!==null&&s.dispose(),c!==null&&c.dispose(),u.dispose(),d.dispose()}}var j_=new vf,M_=new uh(1,1),N_=new dh(1),P_=new Sf,F_=new Cf,I_=new lh,L_=[],R_=[],z_=new Float32Array(16),B_=new Float32Array(9),V_=new Float32Array(4);function H_(e,t,n){let r=e[0];if(r<=0||r>0)return e;let i=t*n,a=L_[i];if(a===void 0&&(a=new Float32Array(i),L_[i]=a),t!==0){r.toArray(a,0);for(let r=1,i=0;r!==t;++r)i+=n,e[r].toArray(a,i)}return a}function U_(e,t){if(e.length!==t.length)return!1;for(let n=0,r=e.length;n<r;n++)if(e[n]!==t[n])return!1;return!0}function W_(e,t){for(let n=0,r=t.length;n<r;n++)e[n]=t[n]}function G_(e,t){let n=R_[t];n===void 0&&(n=new Int32Array(t),R_[t]=n);for(let r=0;r!==t;++r)n[r]=e.allocateTextureUnit();return n}function K_(e,t){let n=this.cache;n[0]!==t&&(e.uniform1f(this.addr,t),n[0]=t)}function q_(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2f(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(U_(n,t))return;e.uniform2fv(this.addr,t),W_(n,t)}}function J_(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3f(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else if(t.r!==void 0)(n[0]!==t.r||n[1]!==t.g||n[2]!==t.b)&&(e.uniform3f(this.addr,t.r,t.g,t.b),n[0]=t.r,n[1]=t.g,n[2]=t.b);else{if(U_(n,t))return;e.uniform3fv(this.addr,t),W_(n,t)}}function Y_(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4f(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(U_(n,t))return;e.uniform4fv(this.addr,t),W_(n,t)}}function X_(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(U_(n,t))return;e.uniformMatrix2fv(this.addr,!1,t),W_(n,t)}else{if(U_(n,r))return;V_.set(r),e.uniformMatrix2fv(this.addr,!1,V_),W_(n,r)}}function Z_(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(U_(n,t))return;e.uniformMatrix3fv(this.addr,!1,t),W_(n,t)}else{if(U_(n,r))return;B_.set(r),e.uniformMatrix3fv(this.addr,!1,B_),W_(n,r)}}function Q_(e,t){let n=this.cache,r=t.elements;if(r===void 0){if(U_(n,t))return;e.uniformMatrix4fv(this.addr,!1,t),W_(n,t)}else{if(U_(n,r))return;z_.set(r),e.uniformMatrix4fv(this.addr,!1,z_),W_(n,r)}}function $_(e,t){let n=this.cache;n[0]!==t&&(e.uniform1i(this.addr,t),n[0]=t)}function ev(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2i(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(U_(n,t))return;e.uniform2iv(this.addr,t),W_(n,t)}}function tv(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3i(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(U_(n,t))return;e.uniform3iv(this.addr,t),W_(n,t)}}function nv(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4i(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(U_(n,t))return;e.uniform4iv(this.addr,t),W_(n,t)}}function rv(e,t){let n=this.cache;n[0]!==t&&(e.uniform1ui(this.addr,t),n[0]=t)}function iv(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y)&&(e.uniform2ui(this.addr,t.x,t.y),n[0]=t.x,n[1]=t.y);else{if(U_(n,t))return;e.uniform2uiv(this.addr,t),W_(n,t)}}function av(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z)&&(e.uniform3ui(this.addr,t.x,t.y,t.z),n[0]=t.x,n[1]=t.y,n[2]=t.z);else{if(U_(n,t))return;e.uniform3uiv(this.addr,t),W_(n,t)}}function ov(e,t){let n=this.cache;if(t.x!==void 0)(n[0]!==t.x||n[1]!==t.y||n[2]!==t.z||n[3]!==t.w)&&(e.uniform4ui(this.addr,t.x,t.y,t.z,t.w),n[0]=t.x,n[1]=t.y,n[2]=t.z,n[3]=t.w);else{if(U_(n,t))return;e.uniform4uiv(this.addr,t),W_(n,t)}}function sv(e){return e.version===0&&(e.compareFunction=519,e.needsUpdate=!0),e}function cv(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i);let a;a=this.type===e.SAMPLER_2D_SHADOW?sv(M_):j_,n.setTexture2D(t||a,i)}function lv(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i),n.setTexture3D(t||F_,i)}function uv(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i);let a;a=this.type===e.SAMPLER_CUBE_SHADOW?sv(N_):I_,n.setTextureCube(t||a,i)}function dv(e,t,n){let r=this.cache,i=n.allocateTextureUnit();r[0]!==i&&(e.uniform1i(this.addr,i),r[0]=i),n.setTexture2DArray(t||P_,i)}function fv(e){switch(e){case 5126:return K_;case 35664:return q_;case 35665:return J_;case 35666:return Y_;case 35674:return X_;case 35675:return Z_;case 35676:return Q_;case 5124:case 35670:return $_;case 35667:case 35671:return ev;case 35668:case 35672:return tv;case 35669:case 35673:return nv;case 5125:return rv;case 36294:return iv;case 36295:return av;case 36296:return ov;case 35678:case 36198:case 36298:case 36306:case 35682:return cv;case 35679:case 36299:case 36307:return lv;case 35680:case 36300:case 36308:case 36293:return uv;case 36289:case 36303:case 36311:case 36292:return dv}}function pv(e,t){e.uniform1fv(this.addr,t)}function mv(e,t){let n=H_(t,this.size,2);e.uniform2fv(this.addr,n)}function hv(e,t){let n=H_(t,this.size,3);e.uniform3fv(this.addr,n)}function gv(e,t){let n=H_(t,this.size,4);e.uniform4fv(this.addr,n)}function _v(e,t){let n=H_(t,this.size,4);e.uniformMatrix2fv(this.addr,!1,n)}function vv(e,t){let n=H_(t,this.size,9);e.uniformMatrix3fv(this.addr,!1,n)}function yv(e,t){let n=H_(t,this.size,16);e.uniformMatrix4fv(this.addr,!1,n)}function bv(e,t){e.uniform1iv(this.addr,t)}function xv(e,t){e.uniform2iv(this.addr,t)}function Sv(e,t){e.uniform3iv(this.addr,t)}function Cv(e,t){e.uniform4iv(this.addr,t)}function wv(e,t){e.uniform1uiv(this.addr,t)}function Tv(e,t){e.uniform2uiv(this.addr,t)}function Ev(e,t){e.uniform3uiv(this.addr,t)}function Dv(e,t){e.uniform4uiv(this.addr,t)}function Ov(e,t,n){let r=this.cache,i=t.length,a=G_(n,i);U_(r,a)||(e.uniform1iv(this.addr,a),W_(r,a));let o;o=this.type===e.SAMPLER_2D_SHADOW?sv(M_):j_;for(let e=0;e!==i;++e)n.setTexture2D(t[e]||o,a[e])}function kv(e,t,n){let r=this.cache,i=t.length,a=G_(n,i);U_(r,a)||(e.uniform1iv(this.addr,a),W_(r,a));for(let e=0;e!==i;++e)n.setTexture3D(t[e]||F_,a[e])}function Av(e,t,n){let r=this.cache,i=t.length,a=G_(n,i);U_(r,a)||(e.uniform1iv(this.addr,a),W_(r,a));let o;o=this.type===e.SAMPLER_CUBE_SHADOW?sv(N_):I_;for(let e=0;e!==i;++e)n.setTextureCube(t[e]||o,a[e])}function jv(e,t,n){let r=this.cache,i=t.length,a=G_(n,i);U_(r,a)||(e.uniform1iv(this.addr,a),W_(r,a));for(let e=0;e!==i;++e)n.setTexture2DArray(t[e]||P_,a[e])}function Mv(e){switch(e){case 5126:return pv;case 35664:return mv;case 35665:return hv;case 35666:return gv;case 35674:return _v;case 35675:return vv;case 35676:return yv;case 5124:case 35670:return bv;case 35667:case 35671:return xv;case 35668:case 35672:return Sv;case 35669:case 35673:return Cv;case 5125:return wv;case 36294:return Tv;case 36295:return Ev;case 36296:return Dv;case 35678:case 36198:case 36298:case 36306:case 35682:return Ov;case 35679:case 36299:case 36307:return kv;case 35680:case 36300:case 36308:case 36293:return Av;case 36289:case 36303:case 36311:case 36292:return jv}}var Nv=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=fv(t.type)}},Pv=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Mv(t.type)}},Fv=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let i=0,a=r.length;i!==a;++i){let a=r[i];a.setValue(e,t[a.id],n)}}},Iv=/(\w+)(\])?(\[|\.)?/g;function Lv(e,t){e.seq.push(t),e.map[t.id]=t}function Rv(e,t,n){let r=e.name,i=r.length;for(Iv.lastIndex=0;;){let a=Iv.exec(r),o=Iv.lastIndex,s=a[1],c=a[2]===`]`,l=a[3];if(c&&(s|=0),l===void 0||l===`[`&&o+2===i){Lv(n,l===void 0?new Nv(s,e,t):new Pv(s,e,t));break}{let e=n.map[s];e===void 0&&(e=new Fv(s),Lv(n,e)),n=e}}}var zv=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let r=0;r<n;++r){let n=e.getActiveUniform(t,r);Rv(n,e.getUniformLocation(t,n.name),this)}let r=[],i=[];for(let t of this.seq)t.type===e.SAMPLER_2D_SHADOW||t.type===e.SAMPLER_CUBE_SHADOW||t.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(t):i.push(t);r.length>0&&(this.seq=r.concat(i))}setValue(e,t,n,r){let i=this.map[t];i!==void 0&&i.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let i=0,a=t.length;i!==a;++i){let a=t[i],o=n[a.id];o.needsUpdate!==!1&&a.setValue(e,o.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,i=e.length;r!==i;++r){let i=e[r];i.id in t&&n.push(i)}return n}};function Bv(e,t,n){let r=e.createShader(t);return e.shaderSource(r,n),e.compileShader(r),r}var Vv=37297,Hv=0;function Uv(e,t){let n=e.split(`
`),r=[],i=Math.max(t-6,0),a=Math.min(t+6,n.length);for(let e=i;e<a;e++){let i=e+1;r.push(`${i===t?`>`:` `} ${i}: ${n[e]}`)}return r.join(`
`)}var Wv=new K;function Gv(e){q._getMatrix(Wv,q.workingColorSpace,e);let t=`mat3( ${Wv.elements.map(e=>e.toFixed(4))} )`;switch(q.getTransfer(e)){case dd:return[t,`LinearTransferOETF`];case fd:return[t,`sRGBTransferOETF`];default:return V(`WebGLProgram: Unsupported color space: `,e),[t,`LinearTransferOETF`]}}function Kv(e,t,n){let r=e.getShaderParameter(t,e.COMPILE_STATUS),i=(e.getShaderInfoLog(t)||``).trim();if(r&&i===``)return``;let a=/ERROR: 0:(\d+)/.exec(i);if(a){let r=parseInt(a[1]);return n.toUpperCase()+`

`+i+`

`+Uv(e.getShaderSource(t),r)}return i}function qv(e,t){let n=Gv(t);return[`vec4 ${e}( vec4 value ) {`,`	return ${n[1]}( vec4( ${n[0]} * value.rgb, value.a ) );`,`}`].join(`
`)}var Jv={1:`Linear`,2:`Reinhard`,3:`Cineon`,4:`ACESFilmic`,6:`AgX`,7:`Neutral`,5:`Custom`};function Yv(e,t){let n=Jv[t];return n===void 0?(V(`WebGLProgram: Unsupported toneMapping:`,t),`vec3 `+e+`( vec3 color ) { return LinearToneMapping( color ); }`):`vec3 `+e+`( vec3 color ) { return `+n+`ToneMapping( color ); }`}var Xv=new G;function Zv(){return q.getLuminanceCoefficients(Xv),[`float luminance( const in vec3 rgb ) {`,`	const vec3 weights = vec3( ${Xv.x.toFixed(4)}, ${Xv.y.toFixed(4)}, ${Xv.z.toFixed(4)} );`,`	return dot( weights, rgb );`,`}`].join(`
`)}function Qv(e){return[e.extensionClipCullDistance?`#extension GL_ANGLE_clip_cull_distance : require`:``,e.extensionMultiDraw?`#extension GL_ANGLE_multi_draw : require`:``].filter(ty).join(`
`)}function $v(e){let t=[];for(let n in e){let r=e[n];r!==!1&&t.push(`#define `+n+` `+r)}return t.join(`
`)}function ey(e,t){let n={},r=e.getProgramParameter(t,e.ACTIVE_ATTRIBUTES);for(let i=0;i<r;i++){let r=e.getActiveAttrib(t,i),a=r.name,o=1;r.type===e.FLOAT_MAT2&&(o=2),r.type===e.FLOAT_MAT3&&(o=3),r.type===e.FLOAT_MAT4&&(o=4),n[a]={type:r.type,location:e.getAttribLocation(t,a),locationSize:o}}return n}function ty(e){return e!==``}function ny(e,t){let n=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return e.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,n).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function ry(e,t){return e.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var iy=/^[ \t]*#include +<([\w\d./]+)>/gm;function ay(e){return e.replace(iy,oy)}function oy(e,t){let n=X[t];if(n===void 0)throw Error(`THREE.WebGLProgram: Can not resolve #include <`+t+`>`);return ay(n)}var sy=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function cy(e){return e.replace(sy,ly)}function ly(e,t,n,r){let i=``;for(let e=parseInt(t);e<parseInt(n);e++)i+=r.replace(/\[\s*i\s*\]/g,`[ `+e+` ]`).replace(/UNROLLED_LOOP_INDEX/g,e);return i}function uy(e){let t=`precision ${e.precision} float;
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
#define LOW_PRECISION`),t}var dy={1:`SHADOWMAP_TYPE_PCF`,3:`SHADOWMAP_TYPE_VSM`};function fy(e){return dy[e.shadowMapType]||`SHADOWMAP_TYPE_BASIC`}var py={302:`ENVMAP_MODE_REFRACTION`};function my(e){return e.envMap===!1?`ENVMAP_MODE_REFLECTION`:py[e.envMapMode]||`ENVMAP_MODE_REFLECTION`}var hy={0:`ENVMAP_BLENDING_MULTIPLY`,1:`ENVMAP_BLENDING_MIX`,2:`ENVMAP_BLENDING_ADD`};function gy(e){return e.envMap===!1?`ENVMAP_BLENDING_NONE`:hy[e.combine]||`ENVMAP_BLENDING_NONE`}function _y(e,t,n,r){let i=e.getContext(),a=n.defines,o=n.vertexShader,s=n.fragmentShader,c=fy(n),l=n.envMapPMREM===!0?`ENVMAP_TYPE_PMREM`:`ENVMAP_TYPE_CUBE`,u=my(n),d=gy(n),f=Qv(n),p=$v(a),m=i.createProgram(),h,g,_=n.glslVersion?`#version `+n.glslVersion+`
`:``;n.isRawShaderMaterial?(h=[`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p].filter(ty).join(`
`),h.length>0&&(h+=`
`),g=[`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p].filter(ty).join(`
`),g.length>0&&(g+=`
`)):(h=[uy(n),`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p,n.extensionClipCullDistance?`#define USE_CLIP_DISTANCE`:``,n.batching?`#define USE_BATCHING`:``,n.batchingColor?`#define USE_BATCHING_COLOR`:``,n.instancing?`#define USE_INSTANCING`:``,n.instancingColor?`#define USE_INSTANCING_COLOR`:``,n.instancingMorph?`#define USE_INSTANCING_MORPH`:``,n.useFog&&n.fog?`#define USE_FOG`:``,n.useFog&&n.fogExp2?`#define FOG_EXP2`:``,n.map?`#define USE_MAP`:``,n.envMap?`#define USE_ENVMAP`:``,n.envMap?`#define `+u:``,n.lightMap?`#define USE_LIGHTMAP`:``,n.aoMap?`#define USE_AOMAP`:``,n.bumpMap?`#define USE_BUMPMAP`:``,n.normalMap?`#define USE_NORMALMAP`:``,n.normalMapObjectSpace?`#define USE_NORMALMAP_OBJECTSPACE`:``,n.normalMapTangentSpace?`#define USE_NORMALMAP_TANGENTSPACE`:``,n.displacementMap?`#define USE_DISPLACEMENTMAP`:``,n.emissiveMap?`#define USE_EMISSIVEMAP`:``,n.anisotropy?`#define USE_ANISOTROPY`:``,n.anisotropyMap?`#define USE_ANISOTROPYMAP`:``,n.clearcoatMap?`#define USE_CLEARCOATMAP`:``,n.clearcoatRoughnessMap?`#define USE_CLEARCOAT_ROUGHNESSMAP`:``,n.clearcoatNormalMap?`#define USE_CLEARCOAT_NORMALMAP`:``,n.diffuseRoughnessMap?`#define USE_DIFFUSE_ROUGHNESSMAP`:``,n.iridescenceMap?`#define USE_IRIDESCENCEMAP`:``,n.iridescenceThicknessMap?`#define USE_IRIDESCENCE_THICKNESSMAP`:``,n.specularMap?`#define USE_SPECULARMAP`:``,n.specularColorMap?`#define USE_SPECULAR_COLORMAP`:``,n.specularIntensityMap?`#define USE_SPECULAR_INTENSITYMAP`:``,n.roughnessMap?`#define USE_ROUGHNESSMAP`:``,n.metalnessMap?`#define USE_METALNESSMAP`:``,n.alphaMap?`#define USE_ALPHAMAP`:``,n.alphaHash?`#define USE_ALPHAHASH`:``,n.transmission?`#define USE_TRANSMISSION`:``,n.transmissionMap?`#define USE_TRANSMISSIONMAP`:``,n.thicknessMap?`#define USE_THICKNESSMAP`:``,n.sheenColorMap?`#define USE_SHEEN_COLORMAP`:``,n.sheenRoughnessMap?`#define USE_SHEEN_ROUGHNESSMAP`:``,n.mapUv?`#define MAP_UV `+n.mapUv:``,n.alphaMapUv?`#define ALPHAMAP_UV `+n.alphaMapUv:``,n.lightMapUv?`#define LIGHTMAP_UV `+n.lightMapUv:``,n.aoMapUv?`#define AOMAP_UV `+n.aoMapUv:``,n.emissiveMapUv?`#define EMISSIVEMAP_UV `+n.emissiveMapUv:``,n.bumpMapUv?`#define BUMPMAP_UV `+n.bumpMapUv:``,n.normalMapUv?`#define NORMALMAP_UV `+n.normalMapUv:``,n.displacementMapUv?`#define DISPLACEMENTMAP_UV `+n.displacementMapUv:``,n.metalnessMapUv?`#define METALNESSMAP_UV `+n.metalnessMapUv:``,n.roughnessMapUv?`#define ROUGHNESSMAP_UV `+n.roughnessMapUv:``,n.anisotropyMapUv?`#define ANISOTROPYMAP_UV `+n.anisotropyMapUv:``,n.clearcoatMapUv?`#define CLEARCOATMAP_UV `+n.clearcoatMapUv:``,n.clearcoatNormalMapUv?`#define CLEARCOAT_NORMALMAP_UV `+n.clearcoatNormalMapUv:``,n.clearcoatRoughnessMapUv?`#define CLEARCOAT_ROUGHNESSMAP_UV `+n.clearcoatRoughnessMapUv:``,n.diffuseRoughnessMapUv?`#define DIFFUSE_ROUGHNESSMAP_UV `+n.diffuseRoughnessMapUv:``,n.iridescenceMapUv?`#define IRIDESCENCEMAP_UV `+n.iridescenceMapUv:``,n.iridescenceThicknessMapUv?`#define IRIDESCENCE_THICKNESSMAP_UV `+n.iridescenceThicknessMapUv:``,n.sheenColorMapUv?`#define SHEEN_COLORMAP_UV `+n.sheenColorMapUv:``,n.sheenRoughnessMapUv?`#define SHEEN_ROUGHNESSMAP_UV `+n.sheenRoughnessMapUv:``,n.specularMapUv?`#define SPECULARMAP_UV `+n.specularMapUv:``,n.specularColorMapUv?`#define SPECULAR_COLORMAP_UV `+n.specularColorMapUv:``,n.specularIntensityMapUv?`#define SPECULAR_INTENSITYMAP_UV `+n.specularIntensityMapUv:``,n.transmissionMapUv?`#define TRANSMISSIONMAP_UV `+n.transmissionMapUv:``,n.thicknessMapUv?`#define THICKNESSMAP_UV `+n.thicknessMapUv:``,n.vertexTangents&&n.flatShading===!1?`#define USE_TANGENT`:``,n.vertexNormals?`#define HAS_NORMAL`:``,n.vertexColors?`#define USE_COLOR`:``,n.vertexAlphas?`#define USE_COLOR_ALPHA`:``,n.vertexUv1s?`#define USE_UV1`:``,n.vertexUv2s?`#define USE_UV2`:``,n.vertexUv3s?`#define USE_UV3`:``,n.pointsUvs?`#define USE_POINTS_UV`:``,n.flatShading?`#define FLAT_SHADED`:``,n.skinning?`#define USE_SKINNING`:``,n.morphTargets?`#define USE_MORPHTARGETS`:``,n.morphNormals&&n.flatShading===!1?`#define USE_MORPHNORMALS`:``,n.morphColors?`#define USE_MORPHCOLORS`:``,n.morphTargetsCount>0?`#define MORPHTARGETS_TEXTURE_STRIDE `+n.morphTextureStride:``,n.morphTargetsCount>0?`#define MORPHTARGETS_COUNT `+n.morphTargetsCount:``,n.doubleSided?`#define DOUBLE_SIDED`:``,n.flipSided?`#define FLIP_SIDED`:``,n.shadowMapEnabled?`#define USE_SHADOWMAP`:``,n.shadowMapEnabled?`#define `+c:``,n.sizeAttenuation?`#define USE_SIZEATTENUATION`:``,n.numLightProbes>0?`#define USE_LIGHT_PROBES`:``,n.logarithmicDepthBuffer?`#define USE_LOGARITHMIC_DEPTH_BUFFER`:``,n.reversedDepthBuffer?`#define USE_REVERSED_DEPTH_BUFFER`:``,`uniform mat4 modelMatrix;`,`uniform mat4 modelViewMatrix;`,`uniform mat4 projectionMatrix;`,`uniform mat4 viewMatrix;`,`uniform mat3 normalMatrix;`,`uniform vec3 cameraPosition;`,`uniform bool isOrthographic;`,`#ifdef USE_INSTANCING`,`	attribute mat4 instanceMatrix;`,`#endif`,`#ifdef USE_INSTANCING_COLOR`,`	attribute vec3 instanceColor;`,`#endif`,`#ifdef USE_INSTANCING_MORPH`,`	uniform sampler2D morphTexture;`,`#endif`,`attribute vec3 position;`,`attribute vec3 normal;`,`attribute vec2 uv;`,`#ifdef USE_UV1`,`	attribute vec2 uv1;`,`#endif`,`#ifdef USE_UV2`,`	attribute vec2 uv2;`,`#endif`,`#ifdef USE_UV3`,`	attribute vec2 uv3;`,`#endif`,`#ifdef USE_TANGENT`,`	attribute vec4 tangent;`,`#endif`,`#if defined( USE_COLOR_ALPHA )`,`	attribute vec4 color;`,`#elif defined( USE_COLOR )`,`	attribute vec3 color;`,`#endif`,`#ifdef USE_SKINNING`,`	attribute vec4 skinIndex;`,`	attribute vec4 skinWeight;`,`#endif`,`
`].filter(ty).join(`
`),g=[uy(n),`#define SHADER_TYPE `+n.shaderType,`#define SHADER_NAME `+n.shaderName,p,n.useFog&&n.fog?`#define USE_FOG`:``,n.useFog&&n.fogExp2?`#define FOG_EXP2`:``,n.alphaToCoverage?`#define ALPHA_TO_COVERAGE`:``,n.map?`#define USE_MAP`:``,n.matcap?`#define USE_MATCAP`:``,n.envMap?`#define USE_ENVMAP`:``,n.envMap?`#define `+l:``,n.envMap?`#define `+u:``,n.envMap?`#define `+d:``,n.envMapPMREM?`#define ENVMAP_MAX_LOD `+n.envMapMaxLod+`.0`:``,n.envMapPMREM?`#define ENVMAP_SIZE `+n.envMapSize+`.0`:``,n.lightMap?`#define USE_LIGHTMAP`:``,n.aoMap?`#define USE_AOMAP`:``,n.bumpMap?`#define USE_BUMPMAP`:``,n.normalMap?`#define USE_NORMALMAP`:``,n.normalMapObjectSpace?`#define USE_NORMALMAP_OBJECTSPACE`:``,n.normalMapTangentSpace?`#define USE_NORMALMAP_TANGENTSPACE`:``,n.packedNormalMap?`#define USE_PACKED_NORMALMAP`:``,n.emissiveMap?`#define USE_EMISSIVEMAP`:``,n.anisotropy?`#define USE_ANISOTROPY`:``,n.anisotropyMap?`#define USE_ANISOTROPYMAP`:``,n.clearcoat?`#define USE_CLEARCOAT`:``,n.clearcoatMap?`#define USE_CLEARCOATMAP`:``,n.clearcoatRoughnessMap?`#define USE_CLEARCOAT_ROUGHNESSMAP`:``,n.clearcoatNormalMap?`#define USE_CLEARCOAT_NORMALMAP`:``,n.diffuseRoughness?`#define USE_DIFFUSE_ROUGHNESS`:``,n.diffuseRoughnessMap?`#define USE_DIFFUSE_ROUGHNESSMAP`:``,n.dispersion?`#define USE_DISPERSION`:``,n.retroreflection?`#define USE_RETROREFLECTION`:``,n.iridescence?`#define USE_IRIDESCENCE`:``,n.iridescenceMap?`#define USE_IRIDESCENCEMAP`:``,n.iridescenceThicknessMap?`#define USE_IRIDESCENCE_THICKNESSMAP`:``,n.specularMap?`#define USE_SPECULARMAP`:``,n.specularColorMap?`#define USE_SPECULAR_COLORMAP`:``,n.specularIntensityMap?`#define USE_SPECULAR_INTENSITYMAP`:``,n.roughnessMap?`#define USE_ROUGHNESSMAP`:``,n.metalnessMap?`#define USE_METALNESSMAP`:``,n.alphaMap?`#define USE_ALPHAMAP`:``,n.alphaTest?`#define USE_ALPHATEST`:``,n.alphaHash?`#define USE_ALPHAHASH`:``,n.sheen?`#define USE_SHEEN`:``,n.sheenColorMap?`#define USE_SHEEN_COLORMAP`:``,n.sheenRoughnessMap?`#define USE_SHEEN_ROUGHNESSMAP`:``,n.transmission?`#define USE_TRANSMISSION`:``,n.transmissionMap?`#define USE_TRANSMISSIONMAP`:``,n.thicknessMap?`#define USE_THICKNESSMAP`:``,n.vertexTangents&&n.flatShading===!1?`#define USE_TANGENT`:``,n.vertexColors||n.instancingColor?`#define USE_COLOR`:``,n.vertexAlphas||n.batchingColor?`#define USE_COLOR_ALPHA`:``,n.vertexUv1s?`#define USE_UV1`:``,n.vertexUv2s?`#define USE_UV2`:``,n.vertexUv3s?`#define USE_UV3`:``,n.pointsUvs?`#define USE_POINTS_UV`:``,n.gradientMap?`#define USE_GRADIENTMAP`:``,n.flatShading?`#define FLAT_SHADED`:``,n.doubleSided?`#define DOUBLE_SIDED`:``,n.flipSided?`#define FLIP_SIDED`:``,n.shadowMapEnabled?`#define USE_SHADOWMAP`:``,n.shadowMapEnabled?`#define `+c:``,n.premultipliedAlpha?`#define PREMULTIPLIED_ALPHA`:``,n.numLightProbes>0?`#define USE_LIGHT_PROBES`:``,n.decodeVideoTexture?`#define DECODE_VIDEO_TEXTURE`:``,n.decodeVideoTextureEmissive?`#define DECODE_VIDEO_TEXTURE_EMISSIVE`:``,n.logarithmicDepthBuffer?`#define USE_LOGARITHMIC_DEPTH_BUFFER`:``,n.reversedDepthBuffer?`#define USE_REVERSED_DEPTH_BUFFER`:``,`uniform mat4 viewMatrix;`,`uniform vec3 cameraPosition;`,`uniform bool isOrthographic;`,n.toneMapping===0?``:`#define TONE_MAPPING`,n.toneMapping===0?``:X.tonemapping_pars_fragment,n.toneMapping===0?``:Yv(`toneMapping`,n.toneMapping),n.dithering?`#define DITHERING`:``,n.opaque?`#define OPAQUE`:``,X.colorspace_pars_fragment,qv(`linearToOutputTexel`,n.outputColorSpace),Zv(),n.useDepthPacking?`#define DEPTH_PACKING `+n.depthPacking:``,`
`].filter(ty).join(`
`)),o=ay(o),o=ny(o,n),o=ry(o,n),s=ay(s),s=ny(s,n),s=ry(s,n),o=cy(o),s=cy(s),n.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,h=[f,`#define attribute in`,`#define varying out`,`#define texture2D texture`].join(`
`)+`
`+h,g=[`#define varying in`,n.glslVersion===`300 es`?``:`layout(location = 0) out highp vec4 pc_fragColor;`,n.glslVersion===`300 es`?``:`#define gl_FragColor pc_fragColor`,`#define gl_FragDepthEXT gl_FragDepth`,`#define texture2D texture`,`#define textureCube texture`,`#define texture2DProj textureProj`,`#define texture2DLodEXT textureLod`,`#define texture2DProjLodEXT textureProjLod`,`#define textureCubeLodEXT textureLod`,`#define texture2DGradEXT textureGrad`,`#define texture2DProjGradEXT textureProjGrad`,`#define textureCubeGradEXT textureGrad`].join(`
`)+`
`+g);let v=_+h+o,y=_+g+s,b=Bv(i,i.VERTEX_SHADER,v),x=Bv(i,i.FRAGMENT_SHADER,y);i.attachShader(m,b),i.attachShader(m,x),n.index0AttributeName===void 0?n.hasPositionAttribute===!0&&i.bindAttribLocation(m,0,`position`):i.bindAttribLocation(m,0,n.index0AttributeName),i.linkProgram(m);function S(t){if(e.debug.checkShaderErrors){let n=i.getProgramInfoLog(m)||``,r=i.getShaderInfoLog(b)||``,a=i.getShaderInfoLog(x)||``,o=n.trim(),s=r.trim(),c=a.trim(),l=!0,u=!0;if(i.getProgramParameter(m,i.LINK_STATUS)===!1){if(l=!1,typeof e.debug.onShaderError==`function`)e.debug.onShaderError(i,m,b,x);else{let e=Kv(i,b,`vertex`),n=Kv(i,x,`fragment`);H(`WebGLProgram: Shader Error `+i.getError()+` - VALIDATE_STATUS `+i.getProgramParameter(m,i.VALIDATE_STATUS)+`

Material Name: `+t.name+`
Material Type: `+t.type+`

Program Info Log: `+o+`
`+e+`
`+n)}}else o===``?(s===``||c===``)&&(u=!1):V(`WebGLProgram: Program Info Log:`,o);u&&(t.diagnostics={runnable:l,programLog:o,vertexShader:{log:s,prefix:h},fragmentShader:{log:c,prefix:g}})}i.deleteShader(b),i.deleteShader(x),C=new zv(i,m),w=ey(i,m)}let C;this.getUniforms=function(){return C===void 0&&S(this),C};let w;this.getAttributes=function(){return w===void 0&&S(this),w};let T=n.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return T===!1&&(T=i.getProgramParameter(m,Vv)),T},this.destroy=function(){r.releaseStatesOfProgram(this),i.deleteProgram(m),this.program=void 0},this.type=n.shaderType,this.name=n.shaderName,this.id=Hv++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=x,this}var vy=0,yy=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let e of t)e.usedTimes--,e.usedTimes===0&&this.shaderCache.delete(e.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new by(e),t.set(e,n)),n}},by=class{constructor(e){this.id=vy++,this.code=e,this.usedTimes=0}};function xy(e){return e===1030||e===37490||e===36285}function Sy(e,t,n,r,i,a){let o=new Pf,s=new yy,c=new Set,l=[],u=new Map,d=r.logarithmicDepthBuffer,f={MeshDepthMaterial:`depth`,MeshDistanceMaterial:`distance`,MeshNormalMaterial:`normal`,MeshBasicMaterial:`basic`,MeshLambertMaterial:`lambert`,MeshPhongMaterial:`phong`,MeshToonMaterial:`toon`,MeshStandardMaterial:`physical`,MeshPhysicalMaterial:`physical`,MeshMatcapMaterial:`matcap`,LineBasicMaterial:`basic`,LineDashedMaterial:`dashed`,PointsMaterial:`points`,ShadowMaterial:`shadow`,SpriteMaterial:`sprite`};function p(e){return c.add(e),e===0?`uv`:`uv${e}`}function m(i,o,l,u,m,h){let g=u.fog,_=m.geometry,v=i.isMeshStandardMaterial||i.isMeshLambertMaterial||i.isMeshPhongMaterial?u.environment:null,y=i.isMeshStandardMaterial||i.isMeshLambertMaterial&&!i.envMap||i.isMeshPhongMaterial&&!i.envMap,b=t.get(i.envMap||v,y),x=f[i.type],S=r.precision;i.precision!==null&&(S=r.getMaxPrecision(i.precision),S!==i.precision&&V(`WebGLProgram.getParameters:`,i.precision,`not supported, using`,S,`instead.`));let C=_.morphAttributes.position||_.morphAttributes.normal||_.morphAttributes.color,w=C===void 0?0:C.length,T=0;_.morphAttributes.position!==void 0&&(T=1),_.morphAttributes.normal!==void 0&&(T=2),_.morphAttributes.color!==void 0&&(T=3);let E,D,O,k;if(x){let e=Xg[x];E=e.vertexShader,D=e.fragmentShader}else{E=i.vertexShader,D=i.fragmentShader;let e=s.getVertexShaderStage(i),t=s.getFragmentShaderStage(i);s.update(i,e,t),O=e.id,k=t.id}let A=e.getRenderTarget(),j=e.state.buffers.depth.getReversed(),M=m.isInstancedMesh===!0,N=m.isBatchedMesh===!0,ee=!!i.map,te=!!i.matcap,P=!!b,ne=P&&b.isPMREMTexture===!0,re=!!i.aoMap,ie=!!i.lightMap,ae=!!i.bumpMap&&i.wireframe===!1,oe=!!i.normalMap,se=!!i.displacementMap,ce=!!i.emissiveMap,F=!!i.metalnessMap,le=!!i.roughnessMap,ue=i.anisotropy>0,de=i.clearcoat>0,fe=i.diffuseRoughness>0,pe=i.dispersion>0,me=i.retroreflectivity>0,he=i.iridescence>0,ge=i.sheen>0,_e=i.transmission>0,ve=ue&&!!i.anisotropyMap,ye=de&&!!i.clearcoatMap,be=de&&!!i.clearcoatNormalMap,xe=de&&!!i.clearcoatRoughnessMap,Se=fe&&!!i.diffuseRoughnessMap,I=he&&!!i.iridescenceMap,Ce=he&&!!i.iridescenceThicknessMap,L=ge&&!!i.sheenColorMap,we=ge&&!!i.sheenRoughnessMap,R=!!i.specularMap,Te=!!i.specularColorMap,z=!!i.specularIntensityMap,B=_e&&!!i.transmissionMap,Ee=_e&&!!i.thicknessMap,De=!!i.gradientMap,Oe=!!i.alphaMap,ke=i.alphaTest>0,Ae=!!i.alphaHash,je=!!i.extensions,Me=0;i.toneMapped&&(A===null||A.isXRRenderTarget===!0)&&(Me=e.toneMapping);let Ne=ne?b.isCompressedCubeTexture?b.image[0].mipmaps:b.mipmaps:null,Pe={shaderID:x,shaderType:i.type,shaderName:i.name,vertexShader:E,fragmentShader:D,defines:i.defines,customVertexShaderID:O,customFragmentShaderID:k,isRawShaderMaterial:i.isRawShaderMaterial===!0,glslVersion:i.glslVersion,precision:S,batching:N,batchingColor:N&&m._colorsTexture!==null,instancing:M,instancingColor:M&&m.instanceColor!==null,instancingMorph:M&&m.morphTexture!==null,outputColorSpace:A===null?e.outputColorSpace:A.isXRRenderTarget===!0?A.texture.colorSpace:q.workingColorSpace,alphaToCoverage:!!i.alphaToCoverage,map:ee,matcap:te,envMap:P,envMapMode:P&&b.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ne.length-1:null,envMapSize:ne?Ne[0].width:null,aoMap:re,lightMap:ie,bumpMap:ae,normalMap:oe,displacementMap:se,emissiveMap:ce,normalMapObjectSpace:oe&&i.normalMapType===1,normalMapTangentSpace:oe&&i.normalMapType===0,packedNormalMap:oe&&i.normalMapType===0&&xy(i.normalMap.format),metalnessMap:F,roughnessMap:le,anisotropy:ue,anisotropyMap:ve,clearcoat:de,clearcoatMap:ye,clearcoatNormalMap:be,clearcoatRoughnessMap:xe,diffuseRoughness:fe,diffuseRoughnessMap:Se,dispersion:pe,retroreflection:me,iridescence:he,iridescenceMap:I,iridescenceThicknessMap:Ce,sheen:ge,sheenColorMap:L,sheenRoughnessMap:we,specularMap:R,specularColorMap:Te,specularIntensityMap:z,transmission:_e,transmissionMap:B,thicknessMap:Ee,gradientMap:De,opaque:i.transparent===!1&&i.blending===1&&i.alphaToCoverage===!1,alphaMap:Oe,alphaTest:ke,alphaHash:Ae,combine:i.combine,mapUv:ee&&p(i.map.channel),aoMapUv:re&&p(i.aoMap.channel),lightMapUv:ie&&p(i.lightMap.channel),bumpMapUv:ae&&p(i.bumpMap.channel),normalMapUv:oe&&p(i.normalMap.channel),displacementMapUv:se&&p(i.displacementMap.channel),emissiveMapUv:ce&&p(i.emissiveMap.channel),metalnessMapUv:F&&p(i.metalnessMap.channel),roughnessMapUv:le&&p(i.roughnessMap.channel),anisotropyMapUv:ve&&p(i.anisotropyMap.channel),clearcoatMapUv:ye&&p(i.clearcoatMap.channel),clearcoatNormalMapUv:be&&p(i.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:xe&&p(i.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:Se&&p(i.diffuseRoughnessMap.channel),iridescenceMapUv:I&&p(i.iridescenceMap.channel),iridescenceThicknessMapUv:Ce&&p(i.iridescenceThicknessMap.channel),sheenColorMapUv:L&&p(i.sheenColorMap.channel),sheenRoughnessMapUv:we&&p(i.sheenRoughnessMap.channel),specularMapUv:R&&p(i.specularMap.channel),specularColorMapUv:Te&&p(i.specularColorMap.channel),specularIntensityMapUv:z&&p(i.specularIntensityMap.channel),transmissionMapUv:B&&p(i.transmissionMap.channel),thicknessMapUv:Ee&&p(i.thicknessMap.channel),alphaMapUv:Oe&&p(i.alphaMap.channel),vertexTangents:!!_.attributes.tangent&&(oe||ue),vertexNormals:!!_.attributes.normal,vertexColors:i.vertexColors,vertexAlphas:i.vertexColors===!0&&!!_.attributes.color&&_.attributes.color.itemSize===4,pointsUvs:m.isPoints===!0&&!!_.attributes.uv&&(ee||Oe),fog:!!g,useFog:i.fog===!0,fogExp2:!!g&&g.isFogExp2,flatShading:i.wireframe===!1&&(i.flatShading===!0||_.attributes.normal===void 0&&oe===!1&&(i.isMeshLambertMaterial||i.isMeshPhongMaterial||i.isMeshStandardMaterial||i.isMeshPhysicalMaterial)),sizeAttenuation:i.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:j,skinning:m.isSkinnedMesh===!0,hasPositionAttribute:_.attributes.position!==void 0,morphTargets:_.morphAttributes.position!==void 0,morphNormals:_.morphAttributes.normal!==void 0,morphColors:_.morphAttributes.color!==void 0,morphTargetsCount:w,morphTextureStride:T,numSunLights:o.sun.length,numDirLights:o.directional.length,numPointLights:o.point.length,numSpotLights:o.spot.length,numSpotLightMaps:o.spotLightMap.length,numRectAreaLights:o.rectArea.length,numHemiLights:o.hemi.length,numSunLightShadows:o.sunShadowMap.length,numDirLightShadows:o.directionalShadowMap.length,numPointLightShadows:o.pointShadowMap.length,numSpotLightShadows:o.spotShadowMap.length,numSpotLightShadowsWithMaps:o.numSpotLightShadowsWithMaps,numLightProbes:o.numLightProbes,numLightProbeGrids:h.filter(e=>e.texture!==null).length,numClippingPlanes:a.numPlanes,numClipIntersection:a.numIntersection,dithering:i.dithering,shadowMapEnabled:e.shadowMap.enabled&&l.length>0,shadowMapType:e.shadowMap.type,toneMapping:Me,decodeVideoTexture:ee&&i.map.isVideoTexture===!0&&q.getTransfer(i.map.colorSpace)===`srgb`,decodeVideoTextureEmissive:ce&&i.emissiveMap.isVideoTexture===!0&&q.getTransfer(i.emissiveMap.colorSpace)===`srgb`,premultipliedAlpha:i.premultipliedAlpha,doubleSided:i.side===2,flipSided:i.side===1,useDepthPacking:i.depthPacking>=0,depthPacking:i.depthPacking||0,index0AttributeName:i.index0AttributeName,extensionClipCullDistance:je&&i.extensions.clipCullDistance===!0&&n.has(`WEBGL_clip_cull_distance`),extensionMultiDraw:(je&&i.extensions.multiDraw===!0||N)&&n.has(`WEBGL_multi_draw`),rendererExtensionParallelShaderCompile:n.has(`KHR_parallel_shader_compile`),customProgramCacheKey:i.customProgramCacheKey()};return Pe.vertexUv1s=c.has(1),Pe.vertexUv2s=c.has(2),Pe.vertexUv3s=c.has(3),c.clear(),Pe}function h(t){let n=[];if(t.shaderID?n.push(t.shaderID):(n.push(t.customVertexShaderID),n.push(t.customFragmentShaderID)),t.defines!==void 0)for(let e in t.defines)n.push(e),n.push(t.defines[e]);return t.isRawShaderMaterial===!1&&(g(n,t),_(n,t),n.push(e.outputColorSpace)),n.push(t.customProgramCacheKey),n.join()}function g(e,t){e.push(t.precision),e.push(t.outputColorSpace),e.push(t.envMapMode),e.push(t.envMapPMREM),e.push(t.envMapMaxLod),e.push(t.envMapSize),e.push(t.mapUv),e.push(t.alphaMapUv),e.push(t.lightMapUv),e.push(t.aoMapUv),e.push(t.bumpMapUv),e.push(t.normalMapUv),e.push(t.displacementMapUv),e.push(t.emissiveMapUv),e.push(t.metalnessMapUv),e.push(t.roughnessMapUv),e.push(t.anisotropyMapUv),e.push(t.clearcoatMapUv),e.push(t.clearcoatNormalMapUv),e.push(t.clearcoatRoughnessMapUv),e.push(t.diffuseRoughnessMapUv),e.push(t.iridescenceMapUv),e.push(t.iridescenceThicknessMapUv),e.push(t.sheenColorMapUv),e.push(t.sheenRoughnessMapUv),e.push(t.specularMapUv),e.push(t.specularColorMapUv),e.push(t.specularIntensityMapUv),e.push(t.transmissionMapUv),e.push(t.thicknessMapUv),e.push(t.combine),e.push(t.fogExp2),e.push(t.sizeAttenuation),e.push(t.morphTargetsCount),e.push(t.numSunLights),e.push(t.numDirLights),e.push(t.numPointLights),e.push(t.numSpotLights),e.push(t.numSpotLightMaps),e.push(t.numHemiLights),e.push(t.numRectAreaLights),e.push(t.numSunLightShadows),e.push(t.numDirLightShadows),e.push(t.numPointLightShadows),e.push(t.numSpotLightShadows),e.push(t.numSpotLightShadowsWithMaps),e.push(t.numLightProbes),e.push(t.numLightProbeGrids),e.push(t.shadowMapType),e.push(t.toneMapping),e.push(t.numClippingPlanes),e.push(t.numClipIntersection),e.push(t.depthPacking)}function _(e,t){o.disableAll(),t.instancing&&o.enable(0),t.instancingColor&&o.enable(1),t.instancingMorph&&o.enable(2),t.matcap&&o.enable(3),t.envMap&&o.enable(4),t.normalMapObjectSpace&&o.enable(5),t.normalMapTangentSpace&&o.enable(6),t.clearcoat&&o.enable(7),t.iridescence&&o.enable(8),t.alphaTest&&o.enable(9),t.vertexColors&&o.enable(10),t.vertexAlphas&&o.enable(11),t.vertexUv1s&&o.enable(12),t.vertexUv2s&&o.enable(13),t.vertexUv3s&&o.enable(14),t.vertexTangents&&o.enable(15),t.anisotropy&&o.enable(16),t.alphaHash&&o.enable(17),t.batching&&o.enable(18),t.dispersion&&o.enable(19),t.retroreflection&&o.enable(24),t.diffuseRoughness&&o.enable(25),t.batchingColor&&o.enable(20),t.gradientMap&&o.enable(21),t.packedNormalMap&&o.enable(22),t.vertexNormals&&o.enable(23),e.push(o.mask),o.disableAll(),t.fog&&o.enable(0),t.useFog&&o.enable(1),t.flatShading&&o.enable(2),t.logarithmicDepthBuffer&&o.enable(3),t.reversedDepthBuffer&&o.enable(4),t.skinning&&o.enable(5),t.morphTargets&&o.enable(6),t.morphNormals&&o.enable(7),t.morphColors&&o.enable(8),t.premultipliedAlpha&&o.enable(9),t.shadowMapEnabled&&o.enable(10),t.doubleSided&&o.enable(11),t.flipSided&&o.enable(12),t.useDepthPacking&&o.enable(13),t.dithering&&o.enable(14),t.transmission&&o.enable(15),t.sheen&&o.enable(16),t.opaque&&o.enable(17),t.pointsUvs&&o.enable(18),t.decodeVideoTexture&&o.enable(19),t.decodeVideoTextureEmissive&&o.enable(20),t.alphaToCoverage&&o.enable(21),t.numLightProbeGrids>0&&o.enable(22),t.hasPositionAttribute&&o.enable(23),e.push(o.mask)}function v(e){let t=f[e.type],n;if(t){let e=Xg[t];n=Th.clone(e.uniforms)}else n=e.uniforms;return n}function y(t,n){let r=u.get(n);return r===void 0?(r=new _y(e,n,t,i),l.push(r),u.set(n,r)):++r.usedTimes,r}function b(e){if(--e.usedTimes===0){let t=l.indexOf(e);l[t]=l[l.length-1],l.pop(),u.delete(e.cacheKey),e.destroy()}}function x(e){s.remove(e)}function S(){s.dispose()}return{getParameters:m,getProgramCacheKey:h,getUniforms:v,acquireProgram:y,releaseProgram:b,releaseShaderCache:x,programs:l,dispose:S}}function Cy(){let e=new WeakMap;function t(t){return e.has(t)}function n(t){let n=e.get(t);return n===void 0&&(n={},e.set(t,n)),n}function r(t){e.delete(t)}function i(t,n,r){e.get(t)[n]=r}function a(){e=new WeakMap}return{has:t,get:n,remove:r,update:i,dispose:a}}function wy(e,t){return e.groupOrder===t.groupOrder?e.renderOrder===t.renderOrder?e.material.id===t.material.id?e.materialVariant===t.materialVariant?e.z===t.z?e.id-t.id:e.z-t.z:e.materialVariant-t.materialVariant:e.material.id-t.material.id:e.renderOrder-t.renderOrder:e.groupOrder-t.groupOrder}function Ty(e,t){return e.groupOrder===t.groupOrder?e.renderOrder===t.renderOrder?e.z===t.z?e.id-t.id:t.z-e.z:e.renderOrder-t.renderOrder:e.groupOrder-t.groupOrder}function Ey(){let e=[],t=0,n=[],r=[],i=[];function a(){t=0,n.length=0,r.length=0,i.length=0}function o(e){let t=0;return e.isInstancedMesh&&(t+=2),e.isSkinnedMesh&&(t+=1),t}function s(n,r,i,a,s,c){let l=e[t];return l===void 0?(l={id:n.id,object:n,geometry:r,material:i,materialVariant:o(n),groupOrder:a,renderOrder:n.renderOrder,z:s,group:c},e[t]=l):(l.id=n.id,l.object=n,l.geometry=r,l.material=i,l.materialVariant=o(n),l.groupOrder=a,l.renderOrder=n.renderOrder,l.z=s,l.group=c),t++,l}function c(e,t,a,o,c,l,u){u.reversedDepth===!0&&(c=-c);let d=s(e,t,a,o,c,l);a.transmission>0?r.push(d):a.transparent===!0?i.push(d):n.push(d)}function l(e,t,a,o,c,l){let u=s(e,t,a,o,c,l);a.transmission>0?r.unshift(u):a.transparent===!0?i.unshift(u):n.unshift(u)}function u(e,t){n.length>1&&n.sort(e||wy),r.length>1&&r.sort(t||Ty),i.length>1&&i.sort(t||Ty)}function d(){for(let n=t,r=e.length;n<r;n++){let t=e[n];if(t.id===null)break;t.id=null,t.object=null,t.geometry=null,t.material=null,t.group=null}}return{opaque:n,transmissive:r,transparent:i,init:a,push:c,unshift:l,finish:d,sort:u}}function Dy(){let e=new WeakMap;function t(t,n){let r=e.get(t),i;return r===void 0?(i=new Ey,e.set(t,[i])):n>=r.length?(i=new Ey,r.push(i)):i=r[n],i}function n(){e=new WeakMap}return{get:t,dispose:n}}function Oy(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case`SunLight`:case`DirectionalLight`:n={direction:new G,color:new Y};break;case`SpotLight`:n={position:new G,direction:new G,color:new Y,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case`PointLight`:n={position:new G,color:new Y,distance:0,decay:0};break;case`HemisphereLight`:n={direction:new G,skyColor:new Y,groundColor:new Y};break;case`RectAreaLight`:n={color:new Y,position:new G,halfWidth:new G,halfHeight:new G}}return e[t.id]=n,n}}}function ky(){let e={};return{get:function(t){if(e[t.id]!==void 0)return e[t.id];let n;switch(t.type){case`SunLight`:case`DirectionalLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new W};break;case`SpotLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new W};break;case`PointLight`:n={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new W,shadowCameraNear:1,shadowCameraFar:1e3}}return e[t.id]=n,n}}}var Ay=0;function jy(e,t){return(t.castShadow?2:0)-(e.castShadow?2:0)+ +!!t.map-!!e.map}function My(e){let t=new Oy,n=ky(),r={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let e=0;e<9;e++)r.probe.push(new G);let i=new G,a=new J,o=new J;function s(i){let a=0,o=0,s=0;for(let e=0;e<9;e++)r.probe[e].set(0,0,0);let c=0,l=0,u=0,d=0,f=0,p=0,m=0,h=0,g=0,_=0,v=0,y=0,b=0,x=0;i.sort(jy);for(let e=0,S=i.length;e<S;e++){let S=i[e],C=S.color,w=S.intensity,T=S.distance,E=null;if(S.shadow&&S.shadow.map&&(E=S.shadow.map.texture.format===1030?S.shadow.map.texture:S.shadow.map.depthTexture||S.shadow.map.texture),S.isAmbientLight)a+=C.r*w,o+=C.g*w,s+=C.b*w;else if(S.isLightProbe){for(let e=0;e<9;e++)r.probe[e].addScaledVector(S.sh.coefficients[e],w);x++}else if(S.isSunLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize.copy(e.mapSize).multiply(e.getFrameExtents()),r.sunShadow[l]=t,r.sunShadowMap[l]=E;let i=e.getViewportCount();for(let t=0;t<i;t++)r.sunShadowMatrix[u+t]=e.getMatrix(t),r.sunShadowCascade[u+t]=e._cascadeData[t];u+=i,l++}r.sun[c]=e,c++}else if(S.isDirectionalLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize=e.mapSize,r.directionalShadow[d]=t,r.directionalShadowMap[d]=E,r.directionalShadowMatrix[d]=S.shadow.matrix,g++}r.directional[d]=e,d++}else if(S.isSpotLight){let e=t.get(S);e.position.setFromMatrixPosition(S.matrixWorld),e.color.copy(C).multiplyScalar(w),e.distance=T,e.coneCos=Math.cos(S.angle),e.penumbraCos=Math.cos(S.angle*(1-S.penumbra)),e.decay=S.decay,r.spot[p]=e;let i=S.shadow;if(S.map&&(r.spotLightMap[y]=S.map,y++,i.updateMatrices(S),S.castShadow&&b++),r.spotLightMatrix[p]=i.matrix,S.castShadow){let e=n.get(S);e.shadowIntensity=i.intensity,e.shadowBias=i.bias,e.shadowNormalBias=i.normalBias,e.shadowRadius=i.radius,e.shadowMapSize=i.mapSize,r.spotShadow[p]=e,r.spotShadowMap[p]=E,v++}p++}else if(S.isRectAreaLight){let e=t.get(S);e.color.copy(C).multiplyScalar(w),e.halfWidth.set(S.width*.5,0,0),e.halfHeight.set(0,S.height*.5,0),r.rectArea[m]=e,m++}else if(S.isPointLight){let e=t.get(S);if(e.color.copy(S.color).multiplyScalar(S.intensity),e.distance=S.distance,e.decay=S.decay,S.castShadow){let e=S.shadow,t=n.get(S);t.shadowIntensity=e.intensity,t.shadowBias=e.bias,t.shadowNormalBias=e.normalBias,t.shadowRadius=e.radius,t.shadowMapSize=e.mapSize,t.shadowCameraNear=e.camera.near,t.shadowCameraFar=e.camera.far,r.pointShadow[f]=t,r.pointShadowMap[f]=E,r.pointShadowMatrix[f]=S.shadow.matrix,_++}r.point[f]=e,f++}else if(S.isHemisphereLight){let e=t.get(S);e.skyColor.copy(S.color).multiplyScalar(w),e.groundColor.copy(S.groundColor).multiplyScalar(w),r.hemi[h]=e,h++}}m>0&&(e.has(`OES_texture_float_linear`)===!0?(r.rectAreaLTC1=Z.LTC_FLOAT_1,r.rectAreaLTC2=Z.LTC_FLOAT_2):(r.rectAreaLTC1=Z.LTC_HALF_1,r.rectAreaLTC2=Z.LTC_HALF_2)),r.ambient[0]=a,r.ambient[1]=o,r.ambient[2]=s;let S=r.hash;(S.sunLength!==c||S.directionalLength!==d||S.pointLength!==f||S.spotLength!==p||S.rectAreaLength!==m||S.hemiLength!==h||S.numSunShadows!==l||S.numDirectionalShadows!==g||S.numPointShadows!==_||S.numSpotShadows!==v||S.numSpotMaps!==y||S.numLightProbes!==x)&&(r.sun.length=c,r.directional.length=d,r.spot.length=p,r.rectArea.length=m,r.point.length=f,r.hemi.length=h,r.sunShadow.length=l,r.sunShadowMap.length=l,r.sunShadowMatrix.length=u,r.sunShadowCascade.length=u,r.directionalShadow.length=g,r.directionalShadowMap.length=g,r.directionalShadowMatrix.length=g,r.pointShadow.length=_,r.pointShadowMap.length=_,r.pointShadowMatrix.length=_,r.spotShadow.length=v,r.spotShadowMap.length=v,r.spotLightMatrix.length=v+y-b,r.spotLightMap.length=y,r.numSpotLightShadowsWithMaps=b,r.numLightProbes=x,S.sunLength=c,S.directionalLength=d,S.pointLength=f,S.spotLength=p,S.rectAreaLength=m,S.hemiLength=h,S.numSunShadows=l,S.numDirectionalShadows=g,S.numPointShadows=_,S.numSpotShadows=v,S.numSpotMaps=y,S.numLightProbes=x,r.version=Ay++)}function c(e,t){let n=0,s=0,c=0,l=0,u=0,d=0,f=t.matrixWorldInverse;for(let t=0,p=e.length;t<p;t++){let p=e[t];if(p.isSunLight){let e=r.sun[n];e.direction.setFromMatrixPosition(p.matrixWorld),e.direction.transformDirection(f),n++}else if(p.isDirectionalLight){let e=r.directional[s];e.direction.setFromMatrixPosition(p.matrixWorld),i.setFromMatrixPosition(p.target.matrixWorld),e.direction.sub(i),e.direction.transformDirection(f),s++}else if(p.isSpotLight){let e=r.spot[l];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),e.direction.setFromMatrixPosition(p.matrixWorld),i.setFromMatrixPosition(p.target.matrixWorld),e.direction.sub(i),e.direction.transformDirection(f),l++}else if(p.isRectAreaLight){let e=r.rectArea[u];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),o.identity(),a.copy(p.matrixWorld),a.premultiply(f),o.extractRotation(a),e.halfWidth.set(p.width*.5,0,0),e.halfHeight.set(0,p.height*.5,0),e.halfWidth.applyMatrix4(o),e.halfHeight.applyMatrix4(o),u++}else if(p.isPointLight){let e=r.point[c];e.position.setFromMatrixPosition(p.matrixWorld),e.position.applyMatrix4(f),c++}else if(p.isHemisphereLight){let e=r.hemi[d];e.direction.setFromMatrixPosition(p.matrixWorld),e.direction.transformDirection(f),d++}}}return{setup:s,setupView:c,state:r}}function Ny(e){let t=new My(e),n=[],r=[],i=[];function a(e){u.camera=e,n.length=0,r.length=0,i.length=0}function o(e){e.isLightProbeGrid?i.push(e):n.push(e)}function s(e){r.push(e)}function c(){t.setup(n),i.sort((e,t)=>e.priority-t.priority||e.id-t.id)}function l(e){t.setupView(n,e)}let u={lightsArray:n,shadowsArray:r,lightProbeGridArray:i,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:a,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:s}}function Py(e){let t=new WeakMap;function n(n,r=0){let i=t.get(n),a;return i===void 0?(a=new Ny(e),t.set(n,[a])):r>=i.length?(a=new Ny(e),i.push(a)):a=i[r],a}function r(){t=new WeakMap}return{get:n,dispose:r}}var Fy=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Iy=`uniform sampler2D shadow_pass;
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
}`,Ly=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],Ry=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],zy=new J,By=new G,Vy=new G;function Hy(e,t,n){let r=new Bm,i=new W,a=new W,o=new yf,s=new jh,c=new Mh,l={},u=n.maxTextureSize,d={0:1,1:0,2:2},f=new Oh({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new W},radius:{value:4}},vertexShader:Fy,fragmentShader:Iy}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new em;m.setAttribute(`position`,new zp(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let h=new wm(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=1;let _=this.type;this.render=function(t,n,s){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||t.length===0)return;this.type===2&&(V(`WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead.`),this.type=1);let c=e.getRenderTarget(),l=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),f=e.state;f.setBlending(0),f.buffers.depth.getReversed()===!0?f.buffers.color.setClear(0,0,0,0):f.buffers.color.setClear(1,1,1,1),f.buffers.depth.setTest(!0),f.setScissorTest(!1);let p=_!==this.type;p&&n.traverse(function(e){e.material&&(Array.isArray(e.material)?e.material.forEach(e=>e.needsUpdate=!0):e.material.needsUpdate=!0)});for(let c=0,l=t.length;c<l;c++){let l=t[c],d=l.shadow;if(d===void 0){V(`WebGLShadowMap:`,l,`has no shadow.`);continue}if(d.autoUpdate===!1&&d.needsUpdate===!1)continue;i.copy(d.mapSize);let m=d.getFrameExtents();i.multiply(m),a.copy(d.mapSize),(i.x>u||i.y>u)&&(i.x>u&&(a.x=Math.floor(u/m.x),i.x=a.x*m.x,d.mapSize.x=a.x),i.y>u&&(a.y=Math.floor(u/m.y),i.y=a.y*m.y,d.mapSize.y=a.y));let h=e.state.buffers.depth.getReversed();if(d.camera._reversedDepth=h,d.map===null||p===!0){if(d.map!==null&&(d.map.depthTexture!==null&&(d.map.depthTexture.dispose(),d.map.depthTexture=null),d.map.dispose()),this.type===3){if(l.isPointLight){V(`WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.`);continue}d.map=new xf(i.x,i.y,{format:gu,type:ru,minFilter:ql,magFilter:ql,generateMipmaps:!1}),d.map.texture.name=l.name+`.shadowMap`,d.map.depthTexture=new uh(i.x,i.y,nu),d.map.depthTexture.name=l.name+`.shadowMapDepth`,d.map.depthTexture.format=fu,d.map.depthTexture.compareFunction=null,d.map.depthTexture.minFilter=Wl,d.map.depthTexture.magFilter=Wl}else l.isPointLight?(d.map=new a_(i.x),d.map.depthTexture=new dh(i.x,tu)):(d.map=new xf(i.x,i.y),d.map.depthTexture=new uh(i.x,i.y,tu)),d.map.depthTexture.name=l.name+`.shadowMap`,d.map.depthTexture.format=fu,this.type===1?(d.map.depthTexture.compareFunction=h?518:515,d.map.depthTexture.minFilter=ql,d.map.depthTexture.magFilter=ql):(d.map.depthTexture.compareFunction=null,d.map.depthTexture.minFilter=Wl,d.map.depthTexture.magFilter=Wl);d.camera.updateProjectionMatrix()}d.map.isWebGLCubeRenderTarget!==!0&&(d.map.width!==i.x||d.map.height!==i.y)&&d.map.setSize(i.x,i.y);let g=d.map.isWebGLCubeRenderTarget?6:d.getViewportCount();l.isPointLight!==!0&&d.updateMatrices(l,s);let _=d.camera.layers.mask&4294967294?d.camera.layers:s.layers;for(let t=0;t<g;t++){let i=d.getCamera(t);if(l.isPointLight){let e=d.camera,n=d.matrix,r=l.distance||e.far;r!==e.far&&(e.far=r,e.updateProjectionMatrix()),By.setFromMatrixPosition(l.matrixWorld),e.position.copy(By),Vy.copy(e.position),Vy.add(Ly[t]),e.up.copy(Ry[t]),e.lookAt(Vy),e.updateMatrixWorld(),n.makeTranslation(-By.x,-By.y,-By.z),zy.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),d._frustum.setFromProjectionMatrix(zy,e.coordinateSystem,e.reversedDepth)}if(d.map.isWebGLCubeRenderTarget)e.setRenderTarget(d.map,t),e.clear();else{t===0&&(e.setRenderTarget(d.map),e.clear());let n=d.getViewport(t);o.set(a.x*n.x,a.y*n.y,a.x*n.z,a.y*n.w),f.viewport(o)}r=d.getFrustum(t),b(n,s,i,l,_,this.type)}d.isPointLightShadow!==!0&&this.type===3&&v(d,s),d.needsUpdate=!1}_=this.type,g.needsUpdate=!1,e.setRenderTarget(c,l,d)};function v(n,r){let a=t.update(h);f.defines.VSM_SAMPLES!==n.blurSamples&&(f.defines.VSM_SAMPLES=n.blurSamples,p.defines.VSM_SAMPLES=n.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),n.mapPass===null?n.mapPass=new xf(i.x,i.y,{format:gu,type:ru}):(n.mapPass.width!==n.map.width||n.mapPass.height!==n.map.height)&&n.mapPass.setSize(n.map.width,n.map.height),f.uniforms.shadow_pass.value=n.map.depthTexture,f.uniforms.resolution.value.set(n.map.width,n.map.height),f.uniforms.radius.value=n.radius,e.setRenderTarget(n.mapPass),e.clear(),e.renderBufferDirect(r,null,a,f,h,null),p.uniforms.shadow_pass.value=n.mapPass.texture,p.uniforms.resolution.value.set(n.map.width,n.map.height),p.uniforms.radius.value=n.radius,e.setRenderTarget(n.map),e.clear(),e.renderBufferDirect(r,null,a,p,h,null)}function y(t,n,r,i){let a=null,o=r.isPointLight===!0?t.customDistanceMaterial:t.customDepthMaterial;if(o!==void 0)a=o;else if(a=r.isPointLight===!0?c:s,e.localClippingEnabled&&n.clipShadows===!0&&Array.isArray(n.clippingPlanes)&&n.clippingPlanes.length!==0||n.displacementMap&&n.displacementScale!==0||n.alphaMap&&n.alphaTest>0||n.map&&n.alphaTest>0||n.alphaToCoverage===!0){let e=a.uuid,t=n.uuid,r=l[e];r===void 0&&(r={},l[e]=r);let i=r[t];i===void 0&&(i=a.clone(),r[t]=i,n.addEventListener(`dispose`,x)),a=i}if(a.visible=n.visible,a.wireframe=n.wireframe,i===3?a.side=n.shadowSide===null?n.side:n.shadowSide:a.side=n.shadowSide===null?d[n.side]:n.shadowSide,a.alphaMap=n.alphaMap,a.alphaTest=n.alphaToCoverage===!0?.5:n.alphaTest,a.map=n.map,a.clipShadows=n.clipShadows,a.clippingPlanes=n.clippingPlanes,a.clipIntersection=n.clipIntersection,a.displacementMap=n.displacementMap,a.displacementScale=n.displacementScale,a.displacementBias=n.displacementBias,a.wireframeLinewidth=n.wireframeLinewidth,a.linewidth=n.linewidth,r.isPointLight===!0&&a.isMeshDistanceMaterial===!0){let t=e.properties.get(a);t.light=r}return a}function b(n,i,a,o,s,c){if(n.visible===!1)return;if(n.layers.test(s)&&(n.isMesh||n.isLine||n.isPoints)&&(n.castShadow||n.receiveShadow&&c===3)&&(!n.frustumCulled||n.intersectsFrustum(r))){n.modelViewMatrix.multiplyMatrices(a.matrixWorldInverse,n.matrixWorld);let r=t.update(n),s=n.material;if(Array.isArray(s)){let t=r.groups;for(let l=0,u=t.length;l<u;l++){let u=t[l],d=s[u.materialIndex];if(d&&d.visible){let t=y(n,d,o,c);n.onBeforeShadow(e,n,i,a,r,t,u),e.renderBufferDirect(a,null,r,t,n,u),n.onAfterShadow(e,n,i,a,r,t,u)}}}else if(s.visible){let t=y(n,s,o,c);n.onBeforeShadow(e,n,i,a,r,t,null),e.renderBufferDirect(a,null,r,t,n,null),n.onAfterShadow(e,n,i,a,r,t,null)}}let l=n.children;for(let e=0,t=l.length;e<t;e++)b(l[e],i,a,o,s,c)}function x(e){e.target.removeEventListener(`dispose`,x);for(let t in l){let n=l[t],r=e.target.uuid;r in n&&(n[r].dispose(),delete n[r])}}}function Uy(e,t){function n(){let t=!1,n=new yf,r=null,i=new yf(0,0,0,0);return{setMask:function(n){r!==n&&!t&&(e.colorMask(n,n,n,n),r=n)},setLocked:function(e){t=e},setClear:function(t,r,a,o,s){s===!0&&(t*=o,r*=o,a*=o),n.set(t,r,a,o),i.equals(n)===!1&&(e.clearColor(t,r,a,o),i.copy(n))},reset:function(){t=!1,r=null,i.set(-1,0,0,0)}}}function r(){let n=!1,r=!1,i=null,a=null,o=null;return{setReversed:function(e){if(r!==e){let n=t.get(`EXT_clip_control`);e?n.clipControlEXT(n.LOWER_LEFT_EXT,n.ZERO_TO_ONE_EXT):n.clipControlEXT(n.LOWER_LEFT_EXT,n.NEGATIVE_ONE_TO_ONE_EXT),r=e;let i=o;o=null,this.setClear(i)}},getReversed:function(){return r},setTest:function(t){t?F(e.DEPTH_TEST):le(e.DEPTH_TEST)},setMask:function(t){i!==t&&!n&&(e.depthMask(t),i=t)},setFunc:function(t){if(r&&(t=Ed[t]),a!==t){switch(t){case 0:e.depthFunc(e.NEVER);break;case 1:e.depthFunc(e.ALWAYS);break;case 2:e.depthFunc(e.LESS);break;case 3:e.depthFunc(e.LEQUAL);break;case 4:e.depthFunc(e.EQUAL);break;case 5:e.depthFunc(e.GEQUAL);break;case 6:e.depthFunc(e.GREATER);break;case 7:e.depthFunc(e.NOTEQUAL);break;default:e.depthFunc(e.LEQUAL)}a=t}},setLocked:function(e){n=e},setClear:function(t){o!==t&&(o=t,r&&(t=1-t),e.clearDepth(t))},reset:function(){n=!1,i=null,a=null,o=null,r=!1}}}function i(){let t=!1,n=null,r=null,i=null,a=null,o=null,s=null,c=null,l=null;return{setTest:function(n){t||(n?F(e.STENCIL_TEST):le(e.STENCIL_TEST))},setMask:function(r){n!==r&&!t&&(e.stencilMask(r),n=r)},setFunc:function(t,n,o){(r!==t||i!==n||a!==o)&&(e.stencilFunc(t,n,o),r=t,i=n,a=o)},setOp:function(t,n,r){(o!==t||s!==n||c!==r)&&(e.stencilOp(t,n,r),o=t,s=n,c=r)},setLocked:function(e){t=e},setClear:function(t){l!==t&&(e.clearStencil(t),l=t)},reset:function(){t=!1,n=null,r=null,i=null,a=null,o=null,s=null,c=null,l=null}}}let a=new n,o=new r,s=new i,c={},l=new WeakMap,u={},d={},f={},p=new WeakMap,m=[],h=null,g=!1,_=null,v=null,y=null,b=null,x=null,S=null,C=null,w=new Y(0,0,0),T=0,E=!1,D=null,O=null,k=null,A=null,j=null,M=e.getParameter(e.MAX_COMBINED_TEXTURE_IMAGE_UNITS),N=!1,ee=0,te=e.getParameter(e.VERSION);te.indexOf(`WebGL`)===-1?te.indexOf(`OpenGL ES`)!==-1&&(ee=parseFloat(/^OpenGL ES (\d)/.exec(te)[1]),N=ee>=2):(ee=parseFloat(/^WebGL (\d)/.exec(te)[1]),N=ee>=1);let P=null,ne={},re=e.getParameter(e.SCISSOR_BOX),ie=e.getParameter(e.VIEWPORT),ae=new yf().fromArray(re),oe=new yf().fromArray(ie);function se(t,n,r,i){let a=new Uint8Array(4),o=e.createTexture();e.bindTexture(t,o),e.texParameteri(t,e.TEXTURE_MIN_FILTER,e.NEAREST),e.texParameteri(t,e.TEXTURE_MAG_FILTER,e.NEAREST);for(let o=0;o<r;o++)t===e.TEXTURE_3D||t===e.TEXTURE_2D_ARRAY?e.texImage3D(n,0,e.RGBA,1,1,i,0,e.RGBA,e.UNSIGNED_BYTE,a):e.texImage2D(n+o,0,e.RGBA,1,1,0,e.RGBA,e.UNSIGNED_BYTE,a);return o}let ce={};ce[e.TEXTURE_2D]=se(e.TEXTURE_2D,e.TEXTURE_2D,1),ce[e.TEXTURE_CUBE_MAP]=se(e.TEXTURE_CUBE_MAP,e.TEXTURE_CUBE_MAP_POSITIVE_X,6),ce[e.TEXTURE_2D_ARRAY]=se(e.TEXTURE_2D_ARRAY,e.TEXTURE_2D_ARRAY,1,1),ce[e.TEXTURE_3D]=se(e.TEXTURE_3D,e.TEXTURE_3D,1,1),a.setClear(0,0,0,1),o.setClear(1),s.setClear(0),F(e.DEPTH_TEST),o.setFunc(3),_e(!1),ve(1),F(e.CULL_FACE),he(0);function F(t){u[t]!==!0&&(e.enable(t),u[t]=!0)}function le(t){u[t]!==!1&&(e.disable(t),u[t]=!1)}function ue(t,n){return f[t]!==n&&(e.bindFramebuffer(t,n),f[t]=n,t===e.DRAW_FRAMEBUFFER&&(f[e.FRAMEBUFFER]=n),t===e.FRAMEBUFFER&&(f[e.DRAW_FRAMEBUFFER]=n),!0)}function de(t,n){let r=m,i=!1;if(t){r=p.get(n),r===void 0&&(r=[],p.set(n,r));let a=t.textures;if(r.length!==a.length||r[0]!==e.COLOR_ATTACHMENT0){for(let t=0,n=a.length;t<n;t++)r[t]=e.COLOR_ATTACHMENT0+t;r.length=a.length,i=!0}}else r[0]!==e.BACK&&(r[0]=e.BACK,i=!0);i&&e.drawBuffers(r)}function fe(t){return h!==t&&(e.useProgram(t),h=t,!0)}let pe={100:e.FUNC_ADD,101:e.FUNC_SUBTRACT,102:e.FUNC_REVERSE_SUBTRACT};pe[103]=e.MIN,pe[104]=e.MAX;let me={200:e.ZERO,201:e.ONE,202:e.SRC_COLOR,204:e.SRC_ALPHA,210:e.SRC_ALPHA_SATURATE,208:e.DST_COLOR,206:e.DST_ALPHA,203:e.ONE_MINUS_SRC_COLOR,205:e.ONE_MINUS_SRC_ALPHA,209:e.ONE_MINUS_DST_COLOR,207:e.ONE_MINUS_DST_ALPHA,211:e.CONSTANT_COLOR,212:e.ONE_MINUS_CONSTANT_COLOR,213:e.CONSTANT_ALPHA,214:e.ONE_MINUS_CONSTANT_ALPHA};function he(t,n,r,i,a,o,s,c,l,u){if(t===0)g===!0&&(le(e.BLEND),g=!1);else if(g===!1&&(F(e.BLEND),g=!0),t!==5){if(t!==_||u!==E){if((v!==100||x!==100)&&(e.blendEquation(e.FUNC_ADD),v=100,x=100),u)switch(t){case 1:e.blendFuncSeparate(e.ONE,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case 2:e.blendFunc(e.ONE,e.ONE);break;case 3:e.blendFuncSeparate(e.ZERO,e.ONE_MINUS_SRC_COLOR,e.ZERO,e.ONE);break;case 4:e.blendFuncSeparate(e.DST_COLOR,e.ONE_MINUS_SRC_ALPHA,e.ZERO,e.ONE);break;default:H(`WebGLState: Invalid blending: `,t)}else switch(t){case 1:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE_MINUS_SRC_ALPHA,e.ONE,e.ONE_MINUS_SRC_ALPHA);break;case 2:e.blendFuncSeparate(e.SRC_ALPHA,e.ONE,e.ONE,e.ONE);break;case 3:H(`WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true`);break;case 4:H(`WebGLState: MultiplyBlending requires material.premultipliedAlpha = true`);break;default:H(`WebGLState: Invalid blending: `,t)}y=null,b=null,S=null,C=null,w.set(0,0,0),T=0,_=t,E=u}}else a||=n,o||=r,s||=i,(n!==v||a!==x)&&(e.blendEquationSeparate(pe[n],pe[a]),v=n,x=a),(r!==y||i!==b||o!==S||s!==C)&&(e.blendFuncSeparate(me[r],me[i],me[o],me[s]),y=r,b=i,S=o,C=s),(c.equals(w)===!1||l!==T)&&(e.blendColor(c.r,c.g,c.b,l),w.copy(c),T=l),_=t,E=!1}function ge(t,n){t.side===2?le(e.CULL_FACE):F(e.CULL_FACE);let r=t.side===1;n&&(r=!r),_e(r),t.blending===1&&t.transparent===!1?he(0):he(t.blending,t.blendEquation,t.blendSrc,t.blendDst,t.blendEquationAlpha,t.blendSrcAlpha,t.blendDstAlpha,t.blendColor,t.blendAlpha,t.premultipliedAlpha),o.setFunc(t.depthFunc),o.setTest(t.depthTest),o.setMask(t.depthWrite),a.setMask(t.colorWrite);let i=t.stencilWrite;s.setTest(i),i&&(s.setMask(t.stencilWriteMask),s.setFunc(t.stencilFunc,t.stencilRef,t.stencilFuncMask),s.setOp(t.stencilFail,t.stencilZFail,t.stencilZPass)),be(t.polygonOffset,t.polygonOffsetFactor,t.polygonOffsetUnits),t.alphaToCoverage===!0?F(e.SAMPLE_ALPHA_TO_COVERAGE):le(e.SAMPLE_ALPHA_TO_COVERAGE)}function _e(t){D!==t&&(t?e.frontFace(e.CW):e.frontFace(e.CCW),D=t)}function ve(t){t===0?le(e.CULL_FACE):(F(e.CULL_FACE),t!==O&&(t===1?e.cullFace(e.BACK):t===2?e.cullFace(e.FRONT):e.cullFace(e.FRONT_AND_BACK))),O=t}function ye(t){t!==k&&(N&&e.lineWidth(t),k=t)}function be(t,n,r){t?(F(e.POLYGON_OFFSET_FILL),(A!==n||j!==r)&&(A=n,j=r,o.getReversed()&&(n=-n,r=-r),e.polygonOffset(n,r))):le(e.POLYGON_OFFSET_FILL)}function xe(t){t?F(e.SCISSOR_TEST):le(e.SCISSOR_TEST)}function Se(t){t===void 0&&(t=e.TEXTURE0+M-1),P!==t&&(e.activeTexture(t),P=t)}function I(t,n,r){r===void 0&&(r=P===null?e.TEXTURE0+M-1:P);let i=ne[r];i===void 0&&(i={type:void 0,texture:void 0},ne[r]=i),(i.type!==t||i.texture!==n)&&(P!==r&&(e.activeTexture(r),P=r),e.bindTexture(t,n||ce[t]),i.type=t,i.texture=n)}function Ce(){let t=ne[P];t!==void 0&&t.type!==void 0&&(e.bindTexture(t.type,null),t.type=void 0,t.texture=void 0)}function L(){try{e.compressedTexImage2D(...arguments)}catch(e){H(`WebGLState:`,e)}}function we(){try{e.compressedTexImage3D(...arguments)}catch(e){H(`WebGLState:`,e)}}function R(){try{e.texSubImage2D(...arguments)}catch(e){H(`WebGLState:`,e)}}function Te(){try{e.texSubImage3D(...arguments)}catch(e){H(`WebGLState:`,e)}}function z(){try{e.compressedTexSubImage2D(...arguments)}catch(e){H(`WebGLState:`,e)}}function B(){try{e.compressedTexSubImage3D(...arguments)}catch(e){H(`WebGLState:`,e)}}function Ee(){try{e.texStorage2D(...arguments)}catch(e){H(`WebGLState:`,e)}}function De(){try{e.texStorage3D(...arguments)}catch(e){H(`WebGLState:`,e)}}function Oe(){try{e.texImage2D(...arguments)}catch(e){H(`WebGLState:`,e)}}function ke(){try{e.texImage3D(...arguments)}catch(e){H(`WebGLState:`,e)}}function Ae(t){return d[t]===void 0?e.getParameter(t):d[t]}function je(t,n){d[t]!==n&&(e.pixelStorei(t,n),d[t]=n)}function Me(t){ae.equals(t)===!1&&(e.scissor(t.x,t.y,t.z,t.w),ae.copy(t))}function Ne(t){oe.equals(t)===!1&&(e.viewport(t.x,t.y,t.z,t.w),oe.copy(t))}function Pe(t,n){let r=l.get(n);r===void 0&&(r=new WeakMap,l.set(n,r));let i=r.get(t);i===void 0&&(i=e.getUniformBlockIndex(n,t.name),e.uniformBlockBinding(n,i,i),r.set(t,i))}function Fe(t,n,r){let i=l.get(n).get(t);c[i]!==r&&(e.bindBufferBase(e.UNIFORM_BUFFER,i,r),c[i]=r)}function Ie(){e.disable(e.BLEND),e.disable(e.CULL_FACE),e.disable(e.DEPTH_TEST),e.disable(e.POLYGON_OFFSET_FILL),e.disable(e.SCISSOR_TEST),e.disable(e.STENCIL_TEST),e.disable(e.SAMPLE_ALPHA_TO_COVERAGE),e.blendEquation(e.FUNC_ADD),e.blendFunc(e.ONE,e.ZERO),e.blendFuncSeparate(e.ONE,e.ZERO,e.ONE,e.ZERO),e.blendColor(0,0,0,0),e.colorMask(!0,!0,!0,!0),e.clearColor(0,0,0,0),e.depthMask(!0),e.depthFunc(e.LESS),o.setReversed(!1),e.clearDepth(1),e.stencilMask(4294967295),e.stencilFunc(e.ALWAYS,0,4294967295),e.stencilOp(e.KEEP,e.KEEP,e.KEEP),e.clearStencil(0),e.cullFace(e.BACK),e.frontFace(e.CCW),e.polygonOffset(0,0),e.activeTexture(e.TEXTURE0),e.bindFramebuffer(e.FRAMEBUFFER,null),e.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),e.bindFramebuffer(e.READ_FRAMEBUFFER,null),e.useProgram(null),e.lineWidth(1),e.scissor(0,0,e.canvas.width,e.canvas.height),e.viewport(0,0,e.canvas.width,e.canvas.height),e.pixelStorei(e.PACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_ALIGNMENT,4),e.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,!1),e.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),e.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,e.BROWSER_DEFAULT_WEBGL),e.pixelStorei(e.PACK_ROW_LENGTH,0),e.pixelStorei(e.PACK_SKIP_PIXELS,0),e.pixelStorei(e.PACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_ROW_LENGTH,0),e.pixelStorei(e.UNPACK_IMAGE_HEIGHT,0),e.pixelStorei(e.UNPACK_SKIP_PIXELS,0),e.pixelStorei(e.UNPACK_SKIP_ROWS,0),e.pixelStorei(e.UNPACK_SKIP_IMAGES,0),u={},d={},P=null,ne={},f={},c={},p=new WeakMap,m=[],h=null,g=!1,_=null,v=null,y=null,b=null,x=null,S=null,C=null,w=new Y(0,0,0),T=0,E=!1,D=null,O=null,k=null,A=null,j=null,ae.set(0,0,e.canvas.width,e.canvas.height),oe.set(0,0,e.canvas.width,e.canvas.height),a.reset(),o.reset(),s.reset()}return{buffers:{color:a,depth:o,stencil:s},enable:F,disable:le,bindFramebuffer:ue,drawBuffers:de,useProgram:fe,setBlending:he,setMaterial:ge,setFlipSided:_e,setCullFace:ve,setLineWidth:ye,setPolygonOffset:be,setScissorTest:xe,activeTexture:Se,bindTexture:I,unbindTexture:Ce,compressedTexImage2D:L,compressedTexImage3D:we,texImage2D:Oe,texImage3D:ke,pixelStorei:je,getParameter:Ae,updateUBOMapping:Pe,uniformBlockBinding:Fe,texStorage2D:Ee,texStorage3D:De,texSubImage2D:R,texSubImage3D:Te,compressedTexSubImage2D:z,compressedTexSubImage3D:B,scissor:Me,viewport:Ne,reset:Ie}}function Wy(e,t,n,r,i,a,o){let s=t.has(`WEBGL_multisampled_render_to_texture`)?t.get(`WEBGL_multisampled_render_to_texture`):null,c=typeof navigator>`u`?!1:/OculusBrowser/g.test(navigator.userAgent),l=new W,u=new WeakMap,d=new Set,f,p=new WeakMap,m=new Set,h=new FinalizationRegistry(e=>m.delete(e)),g=!1;try{g=typeof OffscreenCanvas<`u`&&new OffscreenCanvas(1,1).getContext(`2d`)!==null}catch{}function _(e,t){return g?new OffscreenCanvas(e,t):yd(`canvas`)}function v(e,t,n){let r=1,i=Ee(e);if((i.width>n||i.height>n)&&(r=n/Math.max(i.width,i.height)),r<1){if(typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<`u`&&e instanceof HTMLCanvasElement||typeof ImageBitmap<`u`&&e instanceof ImageBitmap||typeof VideoFrame<`u`&&e instanceof VideoFrame){let n=Math.floor(r*i.width),a=Math.floor(r*i.height);f===void 0&&(f=_(n,a));let o=t?_(n,a):f;return o.width=n,o.height=a,o.getContext(`2d`).drawImage(e,0,0,n,a),V(`WebGLRenderer: Texture has been resized from (`+i.width+`x`+i.height+`) to (`+n+`x`+a+`).`),o}return`data`in e&&V(`WebGLRenderer: Image in DataTexture is too big (`+i.width+`x`+i.height+`).`),e}return e}function y(e){return e.generateMipmaps}function b(t){e.generateMipmap(t)}function x(t){return t.isWebGLCubeRenderTarget?e.TEXTURE_CUBE_MAP:t.isWebGL3DRenderTarget?e.TEXTURE_3D:t.isWebGLArrayRenderTarget||t.isCompressedArrayTexture?e.TEXTURE_2D_ARRAY:e.TEXTURE_2D}function S(n,r,i,a,o,s=!1){if(n!==null){if(e[n]!==void 0)return e[n];V(`WebGLRenderer: Attempt to use non-existing WebGL internal format '`+n+`'`)}let c;a&&(c=t.get(`EXT_texture_norm16`),c||V(`WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension`));let l=r;if(r===e.RED&&(i===e.FLOAT&&(l=e.R32F),i===e.HALF_FLOAT&&(l=e.R16F),i===e.UNSIGNED_BYTE&&(l=e.R8),i===e.UNSIGNED_SHORT&&c&&(l=c.R16_EXT),i===e.SHORT&&c&&(l=c.R16_SNORM_EXT)),r===e.RED_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.R8UI),i===e.UNSIGNED_SHORT&&(l=e.R16UI),i===e.UNSIGNED_INT&&(l=e.R32UI),i===e.BYTE&&(l=e.R8I),i===e.SHORT&&(l=e.R16I),i===e.INT&&(l=e.R32I)),r===e.RG&&(i===e.FLOAT&&(l=e.RG32F),i===e.HALF_FLOAT&&(l=e.RG16F),i===e.UNSIGNED_BYTE&&(l=e.RG8),i===e.UNSIGNED_SHORT&&c&&(l=c.RG16_EXT),i===e.SHORT&&c&&(l=c.RG16_SNORM_EXT)),r===e.RG_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RG8UI),i===e.UNSIGNED_SHORT&&(l=e.RG16UI),i===e.UNSIGNED_INT&&(l=e.RG32UI),i===e.BYTE&&(l=e.RG8I),i===e.SHORT&&(l=e.RG16I),i===e.INT&&(l=e.RG32I)),r===e.RGB_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RGB8UI),i===e.UNSIGNED_SHORT&&(l=e.RGB16UI),i===e.UNSIGNED_INT&&(l=e.RGB32UI),i===e.BYTE&&(l=e.RGB8I),i===e.SHORT&&(l=e.RGB16I),i===e.INT&&(l=e.RGB32I)),r===e.RGBA_INTEGER&&(i===e.UNSIGNED_BYTE&&(l=e.RGBA8UI),i===e.UNSIGNED_SHORT&&(l=e.RGBA16UI),i===e.UNSIGNED_INT&&(l=e.RGBA32UI),i===e.BYTE&&(l=e.RGBA8I),i===e.SHORT&&(l=e.RGBA16I),i===e.INT&&(l=e.RGBA32I)),r===e.RGB&&(i===e.UNSIGNED_SHORT&&c&&(l=c.RGB16_EXT),i===e.SHORT&&c&&(l=c.RGB16_SNORM_EXT),i===e.UNSIGNED_INT_5_9_9_9_REV&&(l=e.RGB9_E5),i===e.UNSIGNED_INT_10F_11F_11F_REV&&(l=e.R11F_G11F_B10F)),r===e.RGBA){let t=s?dd:q.getTransfer(o);i===e.FLOAT&&(l=e.RGBA32F),i===e.HALF_FLOAT&&(l=e.RGBA16F),i===e.UNSIGNED_BYTE&&(l=t===`srgb`?e.SRGB8_ALPHA8:e.RGBA8),i===e.UNSIGNED_SHORT&&c&&(l=c.RGBA16_EXT),i===e.SHORT&&c&&(l=c.RGBA16_SNORM_EXT),i===e.UNSIGNED_SHORT_4_4_4_4&&(l=e.RGBA4),i===e.UNSIGNED_SHORT_5_5_5_1&&(l=e.RGB5_A1)}return(l===e.R16F||l===e.R32F||l===e.RG16F||l===e.RG32F||l===e.RGBA16F||l===e.RGBA32F)&&t.get(`EXT_color_buffer_float`),l}function C(t,n){let r;return t?n===null||n===1014||n===1020?r=e.DEPTH24_STENCIL8:n===1015?r=e.DEPTH32F_STENCIL8:n===1012&&(r=e.DEPTH24_STENCIL8,V(`DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.`)):n===null||n===1014||n===1020?r=e.DEPTH_COMPONENT24:n===1015?r=e.DEPTH_COMPONENT32F:n===1012&&(r=e.DEPTH_COMPONENT16),r}function w(e,t){return y(e)===!0||e.isFramebufferTexture&&e.minFilter!==1003&&e.minFilter!==1006?Math.log2(Math.max(t.width,t.height))+1:e.mipmaps.length>0?e.mipmaps.length:e.isCompressedTexture&&Array.isArray(e.image)?t.mipmaps.length:1}function T(e){let t=new WeakRef(e);r.get(e).__ref=t,m.add(t),h.register(e,t,t)}function E(e){let t=r.get(e).__ref;t!==void 0&&(m.delete(t),h.unregister(t))}function D(e){k(e.target)}function O(e){A(e.target)}function k(e){e.removeEventListener(`dispose`,D),E(e),M(e),e.isVideoTexture&&u.delete(e),e.isHTMLTexture&&d.delete(e)}function A(e){e.removeEventListener(`dispose`,O),E(e),ee(e)}function j(){for(let e of m){let t=e.deref();t!==void 0&&(t.isRenderTarget===!0?A(t):k(t))}m.clear(),d.clear()}function M(e){let t=r.get(e);if(t.__webglInit===void 0)return;let n=e.source,i=p.get(n);if(i){let r=i[t.__cacheKey];r.usedTimes--,r.usedTimes===0&&N(e),Object.keys(i).length===0&&p.delete(n)}r.remove(e)}function N(t){let n=r.get(t);e.deleteTexture(n.__webglTexture);let i=t.source,a=p.get(i);delete a[n.__cacheKey],o.memory.textures--}function ee(t){let n=r.get(t);n.__depthDisposeCallback&&n.__depthDisposeCallback();let i=t.depthTexture;if(i&&i.renderTarget===t&&k(i),t.isWebGLCubeRenderTarget)for(let t=0;t<6;t++){if(Array.isArray(n.__webglFramebuffer[t]))for(let r=0;r<n.__webglFramebuffer[t].length;r++)e.deleteFramebuffer(n.__webglFramebuffer[t][r]);else e.deleteFramebuffer(n.__webglFramebuffer[t]);n.__webglDepthbuffer&&e.deleteRenderbuffer(n.__webglDepthbuffer[t])}else{if(Array.isArray(n.__webglFramebuffer))for(let t=0;t<n.__webglFramebuffer.length;t++)e.deleteFramebuffer(n.__webglFramebuffer[t]);else e.deleteFramebuffer(n.__webglFramebuffer);if(n.__webglDepthbuffer&&e.deleteRenderbuffer(n.__webglDepthbuffer),n.__webglMultisampledFramebuffer&&e.deleteFramebuffer(n.__webglMultisampledFramebuffer),n.__webglColorRenderbuffer)for(let t=0;t<n.__webglColorRenderbuffer.length;t++)n.__webglColorRenderbuffer[t]&&e.deleteRenderbuffer(n.__webglColorRenderbuffer[t]);n.__webglDepthRenderbuffer&&e.deleteRenderbuffer(n.__webglDepthRenderbuffer)}let a=t.textures;for(let t=0,n=a.length;t<n;t++){let n=r.get(a[t]);n.__webglTexture&&(e.deleteTexture(n.__webglTexture),o.memory.textures--),r.remove(a[t])}r.remove(t)}let te=0;function P(){te=0}function ne(){return te}function re(e){te=e}function ie(){let e=te;return e>=i.maxTextures&&V(`WebGLTextures: Trying to use `+(e+1)+` texture units while this GPU supports only `+i.maxTextures),te+=1,e}function ae(e){let t=[];return t.push(e.wrapS),t.push(e.wrapT),t.push(e.wrapR||0),t.push(e.magFilter),t.push(e.minFilter),t.push(e.anisotropy),t.push(e.internalFormat),t.push(e.format),t.push(e.type),t.push(e.generateMipmaps),t.push(e.mipmapsAutoUpdate),t.push(e.premultiplyAlpha),t.push(e.flipY),t.push(e.unpackAlignment),t.push(e.colorSpace),t.join()}function oe(t,i){let a=r.get(t);if(t.isVideoTexture&&z(t),t.isRenderTargetTexture===!1&&t.isExternalTexture!==!0&&t.version>0&&a.__version!==t.version){let e=t.image;if(e===null)V(`WebGLRenderer: Texture marked for update but no image data found.`);else if(e.complete===!1)V(`WebGLRenderer: Texture marked for update but image is incomplete`);else{ge(a,t,i);return}}else t.isExternalTexture&&(a.__webglTexture=t.sourceTexture?t.sourceTexture:null);n.bindTexture(e.TEXTURE_2D,a.__webglTexture,e.TEXTURE0+i)}function se(t,i){let a=r.get(t);t.isRenderTargetTexture===!1&&t.version>0&&a.__version!==t.version?ge(a,t,i):(t.isExternalTexture&&(a.__webglTexture=t.sourceTexture?t.sourceTexture:null),n.bindTexture(e.TEXTURE_2D_ARRAY,a.__webglTexture,e.TEXTURE0+i))}function ce(t,i){let a=r.get(t);t.isRenderTargetTexture===!1&&t.version>0&&a.__version!==t.version?ge(a,t,i):n.bindTexture(e.TEXTURE_3D,a.__webglTexture,e.TEXTURE0+i)}function F(t,i){let a=r.get(t);t.version>0&&a.__version!==t.version?_e(a,t,i):n.bindTexture(e.TEXTURE_CUBE_MAP,a.__webglTexture,e.TEXTURE0+i)}let le={[Vl]:e.REPEAT,[Hl]:e.CLAMP_TO_EDGE,[Ul]:e.MIRRORED_REPEAT},ue={[Wl]:e.NEAREST,[Gl]:e.NEAREST_MIPMAP_NEAREST,[Kl]:e.NEAREST_MIPMAP_LINEAR,[ql]:e.LINEAR,[Jl]:e.LINEAR_MIPMAP_NEAREST,[Yl]:e.LINEAR_MIPMAP_LINEAR},de={512:e.NEVER,519:e.ALWAYS,513:e.LESS,515:e.LEQUAL,514:e.EQUAL,518:e.GEQUAL,516:e.GREATER,517:e.NOTEQUAL};function fe(n,a){if(a.type===1015&&t.has(`OES_texture_float_linear`)===!1&&(a.magFilter===1006||a.magFilter===1007||a.magFilter===1005||a.magFilter===1008||a.minFilter===1006||a.minFilter===1007||a.minFilter===1005||a.minFilter===1008)&&V(`WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device.`),e.texParameteri(n,e.TEXTURE_WRAP_S,le[a.wrapS]),e.texParameteri(n,e.TEXTURE_WRAP_T,le[a.wrapT]),(n===e.TEXTURE_3D||n===e.TEXTURE_2D_ARRAY)&&e.texParameteri(n,e.TEXTURE_WRAP_R,le[a.wrapR]),e.texParameteri(n,e.TEXTURE_MAG_FILTER,ue[a.magFilter]),e.texParameteri(n,e.TEXTURE_MIN_FILTER,ue[a.minFilter]),a.compareFunction&&(e.texParameteri(n,e.TEXTURE_COMPARE_MODE,e.COMPARE_REF_TO_TEXTURE),e.texParameteri(n,e.TEXTURE_COMPARE_FUNC,de[a.compareFunction])),t.has(`EXT_texture_filter_anisotropic`)===!0){if(a.magFilter===1003||a.minFilter!==1005&&a.minFilter!==1008||a.type===1015&&t.has(`OES_texture_float_linear`)===!1)return;if(a.anisotropy>1||r.get(a).__currentAnisotropy){let o=t.get(`EXT_texture_filter_anisotropic`);e.texParameterf(n,o.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(a.anisotropy,i.getMaxAnisotropy())),r.get(a).__currentAnisotropy=a.anisotropy}}}function pe(t,n){let r=!1;t.__webglInit===void 0&&(t.__webglInit=!0,n.addEventListener(`dispose`,D),T(n));let i=n.source,a=p.get(i);a===void 0&&(a={},p.set(i,a));let s=ae(n);if(s!==t.__cacheKey){a[s]===void 0&&(a[s]={texture:e.createTexture(),usedTimes:0},o.memory.textures++,r=!0),a[s].usedTimes++;let i=a[t.__cacheKey];i!==void 0&&(a[t.__cacheKey].usedTimes--,i.usedTimes===0&&N(n)),t.__cacheKey=s,t.__webglTexture=a[s].texture}return r}function me(e,t,n){return Math.floor(Math.floor(e/n)/t)}function he(t,r,i,a){let o=t.updateRanges;if(o.length===0)n.texSubImage2D(e.TEXTURE_2D,0,0,0,r.width,r.height,i,a,r.data);else{o.sort((e,t)=>e.start-t.start);let s=0;for(let e=1;e<o.length;e++){let t=o[s],n=o[e],i=t.start+t.count,a=me(n.start,r.width,4),c=me(t.start,r.width,4);n.start<=i+1&&a===c&&me(n.start+n.count-1,r.width,4)===a?t.count=Math.max(t.count,n.start+n.count-t.start):(++s,o[s]=n)}o.length=s+1;let c=n.getParameter(e.UNPACK_ROW_LENGTH),l=n.getParameter(e.UNPACK_SKIP_PIXELS),u=n.getParameter(e.UNPACK_SKIP_ROWS);n.pixelStorei(e.UNPACK_ROW_LENGTH,r.width);for(let t=0,s=o.length;t<s;t++){let s=o[t],c=Math.floor(s.start/4),l=Math.ceil(s.count/4),u=c%r.width,d=Math.floor(c/r.width),f=l;n.pixelStorei(e.UNPACK_SKIP_PIXELS,u),n.pixelStorei(e.UNPACK_SKIP_ROWS,d),n.texSubImage2D(e.TEXTURE_2D,0,u,d,f,1,i,a,r.data)}t.clearUpdateRanges(),n.pixelStorei(e.UNPACK_ROW_LENGTH,c),n.pixelStorei(e.UNPACK_SKIP_PIXELS,l),n.pixelStorei(e.UNPACK_SKIP_ROWS,u)}}function ge(t,o,s){let c=e.TEXTURE_2D;(o.isDataArrayTexture||o.isCompressedArrayTexture)&&(c=e.TEXTURE_2D_ARRAY),o.isData3DTexture&&(c=e.TEXTURE_3D);let l=pe(t,o),u=o.source;n.bindTexture(c,t.__webglTexture,e.TEXTURE0+s);let f=r.get(u);if(u.version!==f.__version||l===!0){if(n.activeTexture(e.TEXTURE0+s),!(typeof ImageBitmap<`u`&&o.image instanceof ImageBitmap)){let t=q.getPrimaries(q.workingColorSpace),r=o.colorSpace===``?null:q.getPrimaries(o.colorSpace),i=o.colorSpace===``||t===r?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,o.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,o.premultiplyAlpha),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,i)}n.pixelStorei(e.UNPACK_ALIGNMENT,o.unpackAlignment);let t=v(o.image,!1,i.maxTextureSize);t=B(o,t);let r=a.convert(o.format,o.colorSpace),p=a.convert(o.type),m=S(o.internalFormat,r,p,o.normalized,o.colorSpace,o.isVideoTexture);fe(c,o);let h,g=o.mipmaps,_=o.isVideoTexture!==!0,x=f.__version===void 0||l===!0,T=u.dataReady,E=w(o,t);if(o.isDepthTexture)m=C(o.format===pu,o.type),x&&(_?n.texStorage2D(e.TEXTURE_2D,1,m,t.width,t.height):n.texImage2D(e.TEXTURE_2D,0,m,t.width,t.height,0,r,p,null));else if(o.isDataTexture){if(g.length>0){_&&x&&n.texStorage2D(e.TEXTURE_2D,E,m,g[0].width,g[0].height);for(let t=0,i=g.length;t<i;t++)h=g[t],_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,p,h.data):n.texImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,r,p,h.data);o.generateMipmaps=!1}else _?(x&&n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height),T&&he(o,t,r,p)):n.texImage2D(e.TEXTURE_2D,0,m,t.width,t.height,0,r,p,t.data)}else if(o.isCompressedTexture){if(o.isCompressedArrayTexture){_&&x&&n.texStorage3D(e.TEXTURE_2D_ARRAY,E,m,g[0].width,g[0].height,t.depth);for(let i=0,a=g.length;i<a;i++)if(h=g[i],o.format!==1023){if(r!==null){if(_){if(T){if(o.layerUpdates.size>0){let t=Kg(h.width,h.height,o.format,o.type);for(let a of o.layerUpdates){let o=h.data.subarray(a*t/h.data.BYTES_PER_ELEMENT,(a+1)*t/h.data.BYTES_PER_ELEMENT);n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,a,h.width,h.height,1,r,o)}}else n.compressedTexSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,0,h.width,h.height,t.depth,r,h.data)}}else n.compressedTexImage3D(e.TEXTURE_2D_ARRAY,i,m,h.width,h.height,t.depth,0,h.data,0,0)}else V(`WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()`)}else _?T&&n.texSubImage3D(e.TEXTURE_2D_ARRAY,i,0,0,0,h.width,h.height,t.depth,r,p,h.data):n.texImage3D(e.TEXTURE_2D_ARRAY,i,m,h.width,h.height,t.depth,0,r,p,h.data);o.layerUpdates.size>0&&o.clearLayerUpdates()}else{_&&x&&n.texStorage2D(e.TEXTURE_2D,E,m,g[0].width,g[0].height);for(let t=0,i=g.length;t<i;t++)h=g[t],o.format===1023?_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,p,h.data):n.texImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,r,p,h.data):r===null?V(`WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()`):_?T&&n.compressedTexSubImage2D(e.TEXTURE_2D,t,0,0,h.width,h.height,r,h.data):n.compressedTexImage2D(e.TEXTURE_2D,t,m,h.width,h.height,0,h.data)}}else if(o.isDataArrayTexture){if(_){if(x&&n.texStorage3D(e.TEXTURE_2D_ARRAY,E,m,t.width,t.height,t.depth),T){if(o.layerUpdates.size>0){let i=Kg(t.width,t.height,o.format,o.type);for(let a of o.layerUpdates){let o=t.data.subarray(a*i/t.data.BYTES_PER_ELEMENT,(a+1)*i/t.data.BYTES_PER_ELEMENT);n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,a,t.width,t.height,1,r,p,o)}o.clearLayerUpdates()}else n.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,0,t.width,t.height,t.depth,r,p,t.data)}}else n.texImage3D(e.TEXTURE_2D_ARRAY,0,m,t.width,t.height,t.depth,0,r,p,t.data)}else if(o.isData3DTexture)_?(x&&n.texStorage3D(e.TEXTURE_3D,E,m,t.width,t.height,t.depth),T&&n.texSubImage3D(e.TEXTURE_3D,0,0,0,0,t.width,t.height,t.depth,r,p,t.data)):n.texImage3D(e.TEXTURE_3D,0,m,t.width,t.height,t.depth,0,r,p,t.data);else if(o.isFramebufferTexture){if(x){if(_)n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height);else{let i=t.width,a=t.height;for(let t=0;t<E;t++)n.texImage2D(e.TEXTURE_2D,t,m,i,a,0,r,p,null),i>>=1,a>>=1}}}else if(o.isHTMLTexture){if(`texElementImage2D`in e){let n=e.canvas;if(n.hasAttribute(`layoutsubtree`)||n.setAttribute(`layoutsubtree`,`true`),t.parentNode!==n){n.appendChild(t),d.add(o),n.onpaint=e=>{let t=e.changedElements;for(let e of d)t.includes(e.image)&&(e.needsUpdate=!0)},n.requestPaint();return}if(e.texElementImage2D.length===3)e.texElementImage2D(e.TEXTURE_2D,e.RGBA8,t);else{let n=e.RGBA,r=e.RGBA,i=e.UNSIGNED_BYTE;e.texElementImage2D(e.TEXTURE_2D,0,n,r,i,t)}e.texParameteri(e.TEXTURE_2D,e.TEXTURE_MIN_FILTER,e.LINEAR),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_S,e.CLAMP_TO_EDGE),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_WRAP_T,e.CLAMP_TO_EDGE)}}else if(g.length>0){if(_&&x){let t=Ee(g[0]);n.texStorage2D(e.TEXTURE_2D,E,m,t.width,t.height)}for(let t=0,i=g.length;t<i;t++)h=g[t],_?T&&n.texSubImage2D(e.TEXTURE_2D,t,0,0,r,p,h):n.texImage2D(e.TEXTURE_2D,t,m,r,p,h);o.generateMipmaps=!1}else if(_){if(x){let r=Ee(t);n.texStorage2D(e.TEXTURE_2D,E,m,r.width,r.height)}T&&n.texSubImage2D(e.TEXTURE_2D,0,0,0,r,p,t)}else n.texImage2D(e.TEXTURE_2D,0,m,r,p,t);y(o)&&o.mipmapsAutoUpdate===!0&&b(c),f.__version=u.version,o.onUpdate&&o.onUpdate(o)}t.__version=o.version}function _e(t,o,s){if(o.image.length!==6)return;let c=pe(t,o),l=o.source;n.bindTexture(e.TEXTURE_CUBE_MAP,t.__webglTexture,e.TEXTURE0+s);let u=r.get(l);if(l.version!==u.__version||c===!0){n.activeTexture(e.TEXTURE0+s);let t=q.getPrimaries(q.workingColorSpace),r=o.colorSpace===``?null:q.getPrimaries(o.colorSpace),d=o.colorSpace===``||t===r?e.NONE:e.BROWSER_DEFAULT_WEBGL;n.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,o.flipY),n.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,o.premultiplyAlpha),n.pixelStorei(e.UNPACK_ALIGNMENT,o.unpackAlignment),n.pixelStorei(e.UNPACK_COLORSPACE_CONVERSION_WEBGL,d);let f=o.isCompressedTexture||o.image[0].isCompressedTexture,p=o.image[0]&&o.image[0].isDataTexture,m=[];for(let e=0;e<6;e++)!f&&!p?m[e]=v(o.image[e],!0,i.maxCubemapSize):m[e]=p?o.image[e].image:o.image[e],m[e]=B(o,m[e]);let h=m[0],g=a.convert(o.format,o.colorSpace),_=a.convert(o.type),x=S(o.internalFormat,g,_,o.normalized,o.colorSpace),T=o.isVideoTexture!==!0,E=u.__version===void 0||c===!0,D=l.dataReady,O=w(o,h);fe(e.TEXTURE_CUBE_MAP,o);let k;if(o.isDepthTexture){if(x=C(o.format===pu,o.type),E){if(T)n.texStorage2D(e.TEXTURE_CUBE_MAP,1,x,h.width,h.height);else for(let t=0;t<6;t++)n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,h.width,h.height,0,g,_,null)}}else if(f){T&&E&&n.texStorage2D(e.TEXTURE_CUBE_MAP,O,x,h.width,h.height);for(let t=0;t<6;t++){k=m[t].mipmaps;for(let r=0;r<k.length;r++){let i=k[r];o.format===1023?T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,0,0,i.width,i.height,g,_,i.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,x,i.width,i.height,0,g,_,i.data):g===null?V(`WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()`):T?D&&n.compressedTexSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,0,0,i.width,i.height,g,i.data):n.compressedTexImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r,x,i.width,i.height,0,i.data)}}}else{if(k=o.mipmaps,T&&E){k.length>0&&O++;let t=Ee(m[0]);n.texStorage2D(e.TEXTURE_CUBE_MAP,O,x,t.width,t.height)}for(let t=0;t<6;t++)if(p){T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,0,0,m[t].width,m[t].height,g,_,m[t].data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,m[t].width,m[t].height,0,g,_,m[t].data);for(let r=0;r<k.length;r++){let i=k[r].image[t].image;T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,0,0,i.width,i.height,g,_,i.data):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,x,i.width,i.height,0,g,_,i.data)}}else{T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,0,0,g,_,m[t]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,0,x,g,_,m[t]);for(let r=0;r<k.length;r++){let i=k[r];T?D&&n.texSubImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,0,0,g,_,i.image[t]):n.texImage2D(e.TEXTURE_CUBE_MAP_POSITIVE_X+t,r+1,x,g,_,i.image[t])}}}y(o)&&o.mipmapsAutoUpdate===!0&&b(e.TEXTURE_CUBE_MAP),u.__version=l.version,o.onUpdate&&o.onUpdate(o)}t.__version=o.version}function ve(t,i,o,c,l,u){let d=a.convert(o.format,o.colorSpace),f=a.convert(o.type),p=S(o.internalFormat,d,f,o.normalized,o.colorSpace),m=r.get(i),h=r.get(o);if(h.__renderTarget=i,!m.__hasExternalTextures){let t=Math.max(1,i.width>>u),r=Math.max(1,i.height>>u);l===e.TEXTURE_3D||l===e.TEXTURE_2D_ARRAY?n.texImage3D(l,u,p,t,r,i.depth,0,d,f,null):n.texImage2D(l,u,p,t,r,0,d,f,null)}n.bindFramebuffer(e.FRAMEBUFFER,t),Te(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,c,l,h.__webglTexture,0,R(i)):(l===e.TEXTURE_2D||l>=e.TEXTURE_CUBE_MAP_POSITIVE_X&&l<=e.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&e.framebufferTexture2D(e.FRAMEBUFFER,c,l,h.__webglTexture,u),n.bindFramebuffer(e.FRAMEBUFFER,null)}function ye(t,n,r){if(e.bindRenderbuffer(e.RENDERBUFFER,t),n.depthBuffer){let i=n.depthTexture,a=i&&i.isDepthTexture?i.type:null,o=C(n.stencilBuffer,a),c=n.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;Te(n)?s.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,R(n),o,n.width,n.height):r?e.renderbufferStorageMultisample(e.RENDERBUFFER,R(n),o,n.width,n.height):e.renderbufferStorage(e.RENDERBUFFER,o,n.width,n.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,c,e.RENDERBUFFER,t)}else{let t=n.textures;for(let i=0;i<t.length;i++){let o=t[i],c=a.convert(o.format,o.colorSpace),l=a.convert(o.type),u=S(o.internalFormat,c,l,o.normalized,o.colorSpace);Te(n)?s.renderbufferStorageMultisampleEXT(e.RENDERBUFFER,R(n),u,n.width,n.height):r?e.renderbufferStorageMultisample(e.RENDERBUFFER,R(n),u,n.width,n.height):e.renderbufferStorage(e.RENDERBUFFER,u,n.width,n.height)}}e.bindRenderbuffer(e.RENDERBUFFER,null)}function be(t,i,a){let o=i.isWebGLCubeRenderTarget===!0;if(n.bindFramebuffer(e.FRAMEBUFFER,t),!(i.depthTexture&&i.depthTexture.isDepthTexture))throw Error(`THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.`);let c=r.get(i.depthTexture);c.__renderTarget=i;let l=o?i.depthTexture.image[0]:i.depthTexture.image;c.__webglTexture&&l.width===i.width&&l.height===i.height||(l.width=i.width,l.height=i.height,i.depthTexture.needsUpdate=!0),o?F(i.depthTexture,0):oe(i.depthTexture,0);let u=c.__webglTexture,d=R(i),f=o?e.TEXTURE_CUBE_MAP_POSITIVE_X+a:e.TEXTURE_2D,p=i.depthTexture.format===1027?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;if(i.depthTexture.format===1026)Te(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,p,f,u,0,d):e.framebufferTexture2D(e.FRAMEBUFFER,p,f,u,0);else if(i.depthTexture.format===1027)Te(i)?s.framebufferTexture2DMultisampleEXT(e.FRAMEBUFFER,p,f,u,0,d):e.framebufferTexture2D(e.FRAMEBUFFER,p,f,u,0);else throw Error(`THREE.WebGLTextures: Unknown depthTexture format.`)}function xe(t){let i=r.get(t),a=t.isWebGLCubeRenderTarget===!0;if(i.__boundDepthTexture!==t.depthTexture){let e=t.depthTexture;if(i.__depthDisposeCallback&&i.__depthDisposeCallback(),e){let t=()=>{delete i.__boundDepthTexture,delete i.__depthDisposeCallback,e.removeEventListener(`dispose`,t)};e.addEventListener(`dispose`,t),i.__depthDisposeCallback=t}i.__boundDepthTexture=e}if(t.depthTexture&&!i.__autoAllocateDepthBuffer){if(a)for(let e=0;e<6;e++)be(i.__webglFramebuffer[e],t,e);else t.texture.mipmaps.length>0?be(i.__webglFramebuffer[0],t,0):be(i.__webglFramebuffer,t,0)}else if(a){i.__webglDepthbuffer=[];for(let r=0;r<6;r++)if(n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer[r]),i.__webglDepthbuffer[r]===void 0)i.__webglDepthbuffer[r]=e.createRenderbuffer(),ye(i.__webglDepthbuffer[r],t,!1);else{let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,a=i.__webglDepthbuffer[r];e.bindRenderbuffer(e.RENDERBUFFER,a),e.framebufferRenderbuffer(e.FRAMEBUFFER,n,e.RENDERBUFFER,a)}}else if(t.texture.mipmaps.length>0?n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer[0]):n.bindFramebuffer(e.FRAMEBUFFER,i.__webglFramebuffer),i.__webglDepthbuffer===void 0)i.__webglDepthbuffer=e.createRenderbuffer(),ye(i.__webglDepthbuffer,t,!1);else{let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,r=i.__webglDepthbuffer;e.bindRenderbuffer(e.RENDERBUFFER,r),e.framebufferRenderbuffer(e.FRAMEBUFFER,n,e.RENDERBUFFER,r)}n.bindFramebuffer(e.FRAMEBUFFER,null)}function Se(t,n,i){let a=r.get(t);n!==void 0&&ve(a.__webglFramebuffer,t,t.texture,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,0),i!==void 0&&xe(t)}function I(t){let i=t.texture,s=r.get(t),c=r.get(i);t.addEventListener(`dispose`,O),T(t);let l=t.textures,u=t.isWebGLCubeRenderTarget===!0,d=l.length>1;if(d||(c.__webglTexture===void 0&&(c.__webglTexture=e.createTexture()),c.__version=i.version,o.memory.textures++),u){s.__webglFramebuffer=[];for(let t=0;t<6;t++)if(i.mipmaps.length>0){s.__webglFramebuffer[t]=[];for(let n=0;n<i.mipmaps.length;n++)s.__webglFramebuffer[t][n]=e.createFramebuffer()}else s.__webglFramebuffer[t]=e.createFramebuffer()}else{if(i.mipmaps.length>0){s.__webglFramebuffer=[];for(let t=0;t<i.mipmaps.length;t++)s.__webglFramebuffer[t]=e.createFramebuffer()}else s.__webglFramebuffer=e.createFramebuffer();if(d)for(let t=0,n=l.length;t<n;t++){let n=r.get(l[t]);n.__webglTexture===void 0&&(n.__webglTexture=e.createTexture(),o.memory.textures++)}if(t.samples>0&&Te(t)===!1){s.__webglMultisampledFramebuffer=e.createFramebuffer(),s.__webglColorRenderbuffer=[],n.bindFramebuffer(e.FRAMEBUFFER,s.__webglMultisampledFramebuffer);for(let n=0;n<l.length;n++){let r=l[n];s.__webglColorRenderbuffer[n]=e.createRenderbuffer(),e.bindRenderbuffer(e.RENDERBUFFER,s.__webglColorRenderbuffer[n]);let i=a.convert(r.format,r.colorSpace),o=a.convert(r.type),c=S(r.internalFormat,i,o,r.normalized,r.colorSpace,t.isXRRenderTarget===!0),u=R(t);e.renderbufferStorageMultisample(e.RENDERBUFFER,u,c,t.width,t.height),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+n,e.RENDERBUFFER,s.__webglColorRenderbuffer[n])}e.bindRenderbuffer(e.RENDERBUFFER,null),t.depthBuffer&&(s.__webglDepthRenderbuffer=e.createRenderbuffer(),ye(s.__webglDepthRenderbuffer,t,!0)),n.bindFramebuffer(e.FRAMEBUFFER,null)}}if(u){n.bindTexture(e.TEXTURE_CUBE_MAP,c.__webglTexture),fe(e.TEXTURE_CUBE_MAP,i);for(let n=0;n<6;n++)if(i.mipmaps.length>0)for(let r=0;r<i.mipmaps.length;r++)ve(s.__webglFramebuffer[n][r],t,i,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+n,r);else ve(s.__webglFramebuffer[n],t,i,e.COLOR_ATTACHMENT0,e.TEXTURE_CUBE_MAP_POSITIVE_X+n,0);y(i)?b(e.TEXTURE_CUBE_MAP):i.mipmaps.length>0&&e.texParameteri(e.TEXTURE_CUBE_MAP,e.TEXTURE_MAX_LEVEL,i.mipmaps.length-1),n.unbindTexture()}else if(d){for(let i=0,a=l.length;i<a;i++){let a=l[i],o=r.get(a),c=e.TEXTURE_2D;(t.isWebGL3DRenderTarget||t.isWebGLArrayRenderTarget)&&(c=t.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(c,o.__webglTexture),fe(c,a),ve(s.__webglFramebuffer,t,a,e.COLOR_ATTACHMENT0+i,c,0),y(a)&&b(c)}n.unbindTexture()}else{let r=e.TEXTURE_2D;if((t.isWebGL3DRenderTarget||t.isWebGLArrayRenderTarget)&&(r=t.isWebGL3DRenderTarget?e.TEXTURE_3D:e.TEXTURE_2D_ARRAY),n.bindTexture(r,c.__webglTexture),fe(r,i),i.mipmaps.length>0)for(let n=0;n<i.mipmaps.length;n++)ve(s.__webglFramebuffer[n],t,i,e.COLOR_ATTACHMENT0,r,n);else ve(s.__webglFramebuffer,t,i,e.COLOR_ATTACHMENT0,r,0);y(i)?b(r):i.mipmaps.length>0&&e.texParameteri(r,e.TEXTURE_MAX_LEVEL,i.mipmaps.length-1),n.unbindTexture()}t.depthBuffer&&xe(t)}function Ce(e){let t=e.textures;for(let i=0,a=t.length;i<a;i++){let a=t[i];if(y(a)&&a.mipmapsAutoUpdate===!0){let t=x(e),i=r.get(a).__webglTexture;n.bindTexture(t,i),b(t),n.unbindTexture()}}}let L=[];function we(t){if(t.samples>0){if(Te(t)===!1){let i=t.textures,a=t.width,o=t.height,s=e.COLOR_BUFFER_BIT,l=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT,u=r.get(t),d=i.length>1;if(d)for(let t=0;t<i.length;t++)n.bindFramebuffer(e.FRAMEBUFFER,u.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.RENDERBUFFER,null),n.bindFramebuffer(e.FRAMEBUFFER,u.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.TEXTURE_2D,null,0);n.bindFramebuffer(e.READ_FRAMEBUFFER,u.__webglMultisampledFramebuffer),t.texture.mipmaps.length>0?n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglFramebuffer[0]):n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglFramebuffer);for(let n=0;n<i.length;n++){if(t.resolveDepthBuffer&&(t.depthBuffer&&(s|=e.DEPTH_BUFFER_BIT),t.stencilBuffer&&t.resolveStencilBuffer&&(s|=e.STENCIL_BUFFER_BIT)),d){e.framebufferRenderbuffer(e.READ_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.RENDERBUFFER,u.__webglColorRenderbuffer[n]);let t=r.get(i[n]).__webglTexture;e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,t,0)}e.blitFramebuffer(0,0,a,o,0,0,a,o,s,e.NEAREST),c===!0&&(L.length=0,L.push(e.COLOR_ATTACHMENT0+n),t.depthBuffer&&t.storeMultisampledDepthBuffer===!1&&L.push(l),e.invalidateFramebuffer(e.READ_FRAMEBUFFER,L))}if(n.bindFramebuffer(e.READ_FRAMEBUFFER,null),n.bindFramebuffer(e.DRAW_FRAMEBUFFER,null),d)for(let t=0;t<i.length;t++){n.bindFramebuffer(e.FRAMEBUFFER,u.__webglMultisampledFramebuffer),e.framebufferRenderbuffer(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.RENDERBUFFER,u.__webglColorRenderbuffer[t]);let a=r.get(i[t]).__webglTexture;n.bindFramebuffer(e.FRAMEBUFFER,u.__webglFramebuffer),e.framebufferTexture2D(e.DRAW_FRAMEBUFFER,e.COLOR_ATTACHMENT0+t,e.TEXTURE_2D,a,0)}n.bindFramebuffer(e.DRAW_FRAMEBUFFER,u.__webglMultisampledFramebuffer)}else if(t.depthBuffer&&t.storeMultisampledDepthBuffer===!1&&c){let n=t.stencilBuffer?e.DEPTH_STENCIL_ATTACHMENT:e.DEPTH_ATTACHMENT;e.invalidateFramebuffer(e.DRAW_FRAMEBUFFER,[n])}}}function R(e){return Math.min(i.maxSamples,e.samples)}function Te(e){let n=r.get(e);return e.samples>0&&t.has(`WEBGL_multisampled_render_to_texture`)===!0&&n.__useRenderToTexture!==!1}function z(e){let t=o.render.frame;u.get(e)!==t&&(u.set(e,t),e.update())}function B(e,t){let n=e.colorSpace,r=e.format,i=e.type;return e.isCompressedTexture===!0||e.isVideoTexture===!0||n!==`srgb-linear`&&n!==``&&(q.getTransfer(n)===`srgb`?(r!==1023||i!==1009)&&V(`WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType.`):H(`WebGLTextures: Unsupported texture color space:`,n)),t}function Ee(e){return typeof HTMLImageElement<`u`&&e instanceof HTMLImageElement?(l.width=e.naturalWidth||e.width,l.height=e.naturalHeight||e.height):typeof VideoFrame<`u`&&e instanceof VideoFrame?(l.width=e.displayWidth,l.height=e.displayHeight):(l.width=e.width,l.height=e.height),l}this.allocateTextureUnit=ie,this.resetTextureUnits=P,this.getTextureUnits=ne,this.setTextureUnits=re,this.setTexture2D=oe,this.setTexture2DArray=se,this.setTexture3D=ce,this.setTextureCube=F,this.rebindTextures=Se,this.setupRenderTarget=I,this.updateRenderTargetMipmap=Ce,this.updateMultisampleRenderTarget=we,this.setupDepthRenderbuffer=xe,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=Te,this.dispose=j}function Gy(e,t){function n(n,r=``){let i,a=q.getTransfer(r);if(n===1009)return e.UNSIGNED_BYTE;if(n===1017)return e.UNSIGNED_SHORT_4_4_4_4;if(n===1018)return e.UNSIGNED_SHORT_5_5_5_1;if(n===35902)return e.UNSIGNED_INT_5_9_9_9_REV;if(n===35899)return e.UNSIGNED_INT_10F_11F_11F_REV;if(n===1010)return e.BYTE;if(n===1011)return e.SHORT;if(n===1012)return e.UNSIGNED_SHORT;if(n===1013)return e.INT;if(n===1014)return e.UNSIGNED_INT;if(n===1015)return e.FLOAT;if(n===1016)return e.HALF_FLOAT;if(n===1021)return e.ALPHA;if(n===1022)return e.RGB;if(n===1023)return e.RGBA;if(n===1026)return e.DEPTH_COMPONENT;if(n===1027)return e.DEPTH_STENCIL;if(n===1028)return e.RED;if(n===1029)return e.RED_INTEGER;if(n===1030)return e.RG;if(n===1031)return e.RG_INTEGER;if(n===1033)return e.RGBA_INTEGER;if(n===33776||n===33777||n===33778||n===33779){if(a===`srgb`){if(i=t.get(`WEBGL_compressed_texture_s3tc_srgb`),i!==null){if(n===33776)return i.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===33777)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===33778)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===33779)return i.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null}else if(i=t.get(`WEBGL_compressed_texture_s3tc`),i!==null){if(n===33776)return i.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===33777)return i.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===33778)return i.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===33779)return i.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null}if(n===35840||n===35841||n===35842||n===35843){if(i=t.get(`WEBGL_compressed_texture_pvrtc`),i!==null){if(n===35840)return i.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===35841)return i.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===35842)return i.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===35843)return i.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null}if(n===36196||n===37492||n===37496||n===37488||n===37489||n===37490||n===37491){if(i=t.get(`WEBGL_compressed_texture_etc`),i!==null){if(n===36196||n===37492)return a===`srgb`?i.COMPRESSED_SRGB8_ETC2:i.COMPRESSED_RGB8_ETC2;if(n===37496)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:i.COMPRESSED_RGBA8_ETC2_EAC;if(n===37488)return i.COMPRESSED_R11_EAC;if(n===37489)return i.COMPRESSED_SIGNED_R11_EAC;if(n===37490)return i.COMPRESSED_RG11_EAC;if(n===37491)return i.COMPRESSED_SIGNED_RG11_EAC}else return null}if(n===37808||n===37809||n===37810||n===37811||n===37812||n===37813||n===37814||n===37815||n===37816||n===37817||n===37818||n===37819||n===37820||n===37821){if(i=t.get(`WEBGL_compressed_texture_astc`),i!==null){if(n===37808)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:i.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===37809)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:i.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===37810)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:i.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===37811)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:i.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===37812)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:i.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===37813)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:i.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===37814)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:i.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===37815)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:i.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===37816)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:i.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===37817)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:i.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===37818)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:i.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===37819)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:i.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===37820)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:i.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===37821)return a===`srgb`?i.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:i.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null}if(n===36492||n===36494||n===36495){if(i=t.get(`EXT_texture_compression_bptc`),i!==null){if(n===36492)return a===`srgb`?i.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:i.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===36494)return i.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===36495)return i.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null}if(n===36283||n===36284||n===36285||n===36286){if(i=t.get(`EXT_texture_compression_rgtc`),i!==null){if(n===36283)return i.COMPRESSED_RED_RGTC1_EXT;if(n===36284)return i.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===36285)return i.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===36286)return i.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null}return n===1020?e.UNSIGNED_INT_24_8:e[n]===void 0?null:e[n]}return{convert:n}}var Ky=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,qy=`
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

}`,Jy=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new fh(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Oh({vertexShader:Ky,fragmentShader:qy,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new wm(new vh(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Yy=class extends Dd{constructor(e,t){super();let n=this,r=null,i=1,a=null,o=`local-floor`,s=1,c=null,l=null,u=null,d=null,f=null,p=null,m=typeof XRWebGLBinding<`u`,h=new Jy,g={},_=t.getContextAttributes(),v=null,y=null,b=[],x=[],S=new W,C=null,w=null,T=new fg;T.viewport=new yf;let E=new fg;E.viewport=new yf;let D=[T,E],O=new yg,k=null,A=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(e){let t=b[e];return t===void 0&&(t=new $f,b[e]=t),t.getTargetRaySpace()},this.getControllerGrip=function(e){let t=b[e];return t===void 0&&(t=new $f,b[e]=t),t.getGripSpace()},this.getHand=function(e){let t=b[e];return t===void 0&&(t=new $f,b[e]=t),t.getHandSpace()};function j(e){let t=x.indexOf(e.inputSource);if(t===-1)return;let n=b[t];n!==void 0&&(n.update(e.inputSource,e.frame,c||a),n.dispatchEvent({type:e.type,data:e.inputSource}))}function M(){r.removeEventListener(`select`,j),r.removeEventListener(`selectstart`,j),r.removeEventListener(`selectend`,j),r.removeEventListener(`squeeze`,j),r.removeEventListener(`squeezestart`,j),r.removeEventListener(`squeezeend`,j),r.removeEventListener(`end`,M),r.removeEventListener(`inputsourceschange`,N);for(let e=0;e<b.length;e++){let t=x[e];t!==null&&(x[e]=null,b[e].disconnect(t))}k=null,A=null,h.reset();for(let e in g)delete g[e];if(e.setRenderTarget(v),f=null,d=null,u=null,r=null,y=null,re.stop(),n.isPresenting=!1,e.setPixelRatio(C),e.setSize(S.width,S.height,!1),w!==null){let e=w.camera;e.fov=w.fov,e.zoom=w.zoom,e.updateProjectionMatrix(),w=null}n.dispatchEvent({type:`sessionend`})}this.setFramebufferScaleFactor=function(e){i=e,n.isPresenting===!0&&V(`WebXRManager: Cannot change framebuffer scale while presenting.`)},this.setReferenceSpaceType=function(e){o=e,n.isPresenting===!0&&V(`WebXRManager: Cannot change reference space type while presenting.`)},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(e){c=e},this.getBaseLayer=function(){return d===null?f:d},this.getBinding=function(){return u===null&&m&&(u=new XRWebGLBinding(r,t)),u},this.getFrame=function(){return p},this.getSession=function(){return r},this.setSession=async function(l){if(r=l,r!==null){if(v=e.getRenderTarget(),r.addEventListener(`select`,j),r.addEventListener(`selectstart`,j),r.addEventListener(`selectend`,j),r.addEventListener(`squeeze`,j),r.addEventListener(`squeezestart`,j),r.addEventListener(`squeezeend`,j),r.addEventListener(`end`,M),r.addEventListener(`inputsourceschange`,N),_.xrCompatible!==!0&&await t.makeXRCompatible(),C=e.getPixelRatio(),e.getSize(S),m&&`createProjectionLayer`in XRWebGLBinding.prototype){let n=null,a=null,o=null;_.depth&&(o=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,n=_.stencil?pu:fu,a=_.stencil?ou:tu);let s={colorFormat:t.RGBA8,depthFormat:o,scaleFactor:i};u=this.getBinding(),d=u.createProjectionLayer(s),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),y=new xf(d.textureWidth,d.textureHeight,{format:du,type:Xl,depthTexture:new uh(d.textureWidth,d.textureHeight,a,void 0,void 0,void 0,void 0,void 0,void 0,n),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let n={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:i};f=new XRWebGLLayer(r,t,n),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new xf(f.framebufferWidth,f.framebufferHeight,{format:du,type:Xl,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(s),c=null,a=await r.requestReferenceSpace(o),re.setContext(r),re.start(),n.isPresenting=!0,n.dispatchEvent({type:`sessionstart`})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return h.getDepthTexture()};function N(e){for(let t=0;t<e.removed.length;t++){let n=e.removed[t],r=x.indexOf(n);r>=0&&(x[r]=null,b[r].disconnect(n))}for(let t=0;t<e.added.length;t++){let n=e.added[t],r=x.indexOf(n);if(r===-1){for(let e=0;e<b.length;e++)if(e>=x.length){x.push(n),r=e;break}else if(x[e]===null){x[e]=n,r=e;break}if(r===-1)break}let i=b[r];i&&i.connect(n)}}function ee(e,t){t===null?e.matrixWorld.copy(e.matrix):e.matrixWorld.multiplyMatrices(t.matrixWorld,e.matrix),e.matrixWorldInverse.copy(e.matrixWorld).invert()}this.updateCamera=function(e){if(r===null)return;let t=e.near,n=e.far;h.texture!==null&&(h.depthNear>0&&(t=h.depthNear),h.depthFar>0&&(n=h.depthFar)),O.near=E.near=T.near=t,O.far=E.far=T.far=n,(k!==O.near||A!==O.far)&&(r.updateRenderState({depthNear:O.near,depthFar:O.far}),k=O.near,A=O.far),O.layers.mask=e.layers.mask|6,T.layers.mask=O.layers.mask&-5,E.layers.mask=O.layers.mask&-3;let i=e.parent,a=O.cameras;ee(O,i);for(let e=0;e<a.length;e++)ee(a[e],i);O.projectionMatrix.copy(T.projectionMatrix),O.projectionMatrixInverse.copy(T.projectionMatrixInverse),w===null&&e.isPerspectiveCamera&&(w={camera:e,fov:e.fov,zoom:e.zoom}),te(e,O,i)};function te(e,t,n){n===null?e.matrix.copy(t.matrixWorld):(e.matrix.copy(n.matrixWorld),e.matrix.invert(),e.matrix.multiply(t.matrixWorld)),e.matrix.decompose(e.position,e.quaternion,e.scale),e.updateMatrixWorld(!0),e.projectionMatrix.copy(t.projectionMatrix),e.projectionMatrixInverse.copy(t.projectionMatrixInverse),e.isPerspectiveCamera&&(e.fov=jd*2*Math.atan(1/e.projectionMatrix.elements[5]),e.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(d!==null||f!==null)return s},this.setFoveation=function(e){s=e,d!==null&&(d.fixedFoveation=e),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=e)},this.hasDepthSensing=function(){return h.texture!==null},this.getDepthSensingMesh=function(){return h.getMesh(O)},this.getCameraTexture=function(e){return g[e]};let P=null;function ne(t,i){if(l=i.getViewerPose(c||a),p=i,l!==null){let t=l.views;f!==null&&(e.setRenderTargetFramebuffer(y,f.framebuffer),e.setRenderTarget(y));let i=!1;t.length!==O.cameras.length&&(O.cameras.length=0,i=!0);for(let n=0;n<t.length;n++){let r=t[n],a=null;if(f!==null)a=f.getViewport(r);else{let t=u.getViewSubImage(d,r);a=t.viewport,n===0&&(e.setRenderTargetTextures(y,t.colorTexture,t.depthStencilTexture),e.setRenderTarget(y))}let o=D[n];o===void 0&&(o=new fg,o.layers.enable(n),o.viewport=new yf,D[n]=o),o.matrix.fromArray(r.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.projectionMatrix.fromArray(r.projectionMatrix),o.projectionMatrixInverse.copy(o.projectionMatrix).invert(),o.viewport.set(a.x,a.y,a.width,a.height),n===0&&(O.matrix.copy(o.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),i===!0&&O.cameras.push(o)}let a=r.enabledFeatures;if(a&&a.includes(`depth-sensing`)&&r.depthUsage==`gpu-optimized`&&m){u=n.getBinding();let e=u.getDepthInformation(t[0]);e&&e.isValid&&e.texture&&h.init(e,r.renderState)}if(a&&a.includes(`camera-access`)&&m){e.state.unbindTexture(),u=n.getBinding();for(let e=0;e<t.length;e++){let n=t[e].camera;if(n){let e=g[n];e||(e=new fh,g[n]=e);let t=u.getCameraImage(n);e.sourceTexture=t}}}}for(let e=0;e<b.length;e++){let t=x[e],n=b[e];t!==null&&n!==void 0&&n.update(t,i,c||a)}P&&P(t,i),i.detectedPlanes&&n.dispatchEvent({type:`planesdetected`,data:i}),p=null}let re=new Jg;re.setAnimationLoop(ne),this.setAnimationLoop=function(e){P=e},this.dispose=function(){}}},Xy=new J,Zy=new K;Zy.set(-1,0,0,0,1,0,0,0,1);function Qy(e,t){function n(e,t){e.matrixAutoUpdate===!0&&e.updateMatrix(),t.value.copy(e.matrix)}function r(t,n){n.color.getRGB(t.fogColor.value,wh(e)),n.isFog?(t.fogNear.value=n.near,t.fogFar.value=n.far):n.isFogExp2&&(t.fogDensity.value=n.density)}function i(e,t,n,r,i){t.isNodeMaterial?t.uniformsNeedUpdate=!1:t.isMeshBasicMaterial?a(e,t):t.isMeshLambertMaterial?(a(e,t),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)):t.isMeshToonMaterial?(a(e,t),d(e,t)):t.isMeshPhongMaterial?(a(e,t),u(e,t),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)):t.isMeshStandardMaterial?(a(e,t),f(e,t),t.isMeshPhysicalMaterial&&p(e,t,i)):t.isMeshMatcapMaterial?(a(e,t),m(e,t)):t.isMeshDepthMaterial?a(e,t):t.isMeshDistanceMaterial?(a(e,t),h(e,t)):t.isMeshNormalMaterial?a(e,t):t.isLineBasicMaterial?(o(e,t),t.isLineDashedMaterial&&s(e,t)):t.isPointsMaterial?c(e,t,n,r):t.isSpriteMaterial?l(e,t):t.isShadowMaterial?(e.color.value.copy(t.color),e.opacity.value=t.opacity):t.isShaderMaterial&&(t.uniformsNeedUpdate=!1)}function a(e,r){e.opacity.value=r.opacity,r.color&&e.diffuse.value.copy(r.color),r.emissive&&e.emissive.value.copy(r.emissive).multiplyScalar(r.emissiveIntensity),r.map&&(e.map.value=r.map,n(r.map,e.mapTransform)),r.alphaMap&&(e.alphaMap.value=r.alphaMap,n(r.alphaMap,e.alphaMapTransform)),r.bumpMap&&(e.bumpMap.value=r.bumpMap,n(r.bumpMap,e.bumpMapTransform),e.bumpScale.value=r.bumpScale,r.side===1&&(e.bumpScale.value*=-1)),r.normalMap&&(e.normalMap.value=r.normalMap,n(r.normalMap,e.normalMapTransform),e.normalScale.value.copy(r.normalScale),r.side===1&&e.normalScale.value.negate()),r.displacementMap&&(e.displacementMap.value=r.displacementMap,n(r.displacementMap,e.displacementMapTransform),e.displacementScale.value=r.displacementScale,e.displacementBias.value=r.displacementBias),r.emissiveMap&&(e.emissiveMap.value=r.emissiveMap,n(r.emissiveMap,e.emissiveMapTransform)),r.specularMap&&(e.specularMap.value=r.specularMap,n(r.specularMap,e.specularMapTransform)),r.alphaTest>0&&(e.alphaTest.value=r.alphaTest);let i=t.get(r),a=i.envMap,o=i.envMapRotation;a&&(e.envMap.value=a,e.envMapRotation.value.setFromMatrix4(Xy.makeRotationFromEuler(o)).transpose(),a.isCubeTexture&&a.isRenderTargetTexture===!1&&e.envMapRotation.value.premultiply(Zy),e.reflectivity.value=r.reflectivity,e.ior.value=r.ior,e.refractionRatio.value=r.refractionRatio),r.lightMap&&(e.lightMap.value=r.lightMap,e.lightMapIntensity.value=r.lightMapIntensity,n(r.lightMap,e.lightMapTransform)),r.aoMap&&(e.aoMap.value=r.aoMap,e.aoMapIntensity.value=r.aoMapIntensity,n(r.aoMap,e.aoMapTransform))}function o(e,t){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,t.map&&(e.map.value=t.map,n(t.map,e.mapTransform))}function s(e,t){e.dashSize.value=t.dashSize,e.totalSize.value=t.dashSize+t.gapSize,e.scale.value=t.scale}function c(e,t,r,i){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,e.size.value=t.size*r,e.scale.value=i*.5,t.map&&(e.map.value=t.map,n(t.map,e.uvTransform)),t.alphaMap&&(e.alphaMap.value=t.alphaMap,n(t.alphaMap,e.alphaMapTransform)),t.alphaTest>0&&(e.alphaTest.value=t.alphaTest)}function l(e,t){e.diffuse.value.copy(t.color),e.opacity.value=t.opacity,e.rotation.value=t.rotation,t.map&&(e.map.value=t.map,n(t.map,e.mapTransform)),t.alphaMap&&(e.alphaMap.value=t.alphaMap,n(t.alphaMap,e.alphaMapTransform)),t.alphaTest>0&&(e.alphaTest.value=t.alphaTest)}function u(e,t){e.specular.value.copy(t.specular),e.shininess.value=Math.max(t.shininess,1e-4)}function d(e,t){t.gradientMap&&(e.gradientMap.value=t.gradientMap)}function f(e,t){e.metalness.value=t.metalness,t.metalnessMap&&(e.metalnessMap.value=t.metalnessMap,n(t.metalnessMap,e.metalnessMapTransform)),e.roughness.value=t.roughness,t.roughnessMap&&(e.roughnessMap.value=t.roughnessMap,n(t.roughnessMap,e.roughnessMapTransform)),t.envMap&&(e.envMapIntensity.value=t.envMapIntensity)}function p(e,t,r){e.ior.value=t.ior,t.diffuseRoughness>0&&(e.diffuseRoughness.value=t.diffuseRoughness,t.diffuseRoughnessMap&&(e.diffuseRoughnessMap.value=t.diffuseRoughnessMap,n(t.diffuseRoughnessMap,e.diffuseRoughnessMapTransform))),t.sheen>0&&(e.sheenColor.value.copy(t.sheenColor).multiplyScalar(t.sheen),e.sheenRoughness.value=t.sheenRoughness,t.sheenColorMap&&(e.sheenColorMap.value=t.sheenColorMap,n(t.sheenColorMap,e.sheenColorMapTransform)),t.sheenRoughnessMap&&(e.sheenRoughnessMap.value=t.sheenRoughnessMap,n(t.sheenRoughnessMap,e.sheenRoughnessMapTransform))),t.clearcoat>0&&(e.clearcoat.value=t.clearcoat,e.clearcoatRoughness.value=t.clearcoatRoughness,t.clearcoatMap&&(e.clearcoatMap.value=t.clearcoatMap,n(t.clearcoatMap,e.clearcoatMapTransform)),t.clearcoatRoughnessMap&&(e.clearcoatRoughnessMap.value=t.clearcoatRoughnessMap,n(t.clearcoatRoughnessMap,e.clearcoatRoughnessMapTransform)),t.clearcoatNormalMap&&(e.clearcoatNormalMap.value=t.clearcoatNormalMap,n(t.clearcoatNormalMap,e.clearcoatNormalMapTransform),e.clearcoatNormalScale.value.copy(t.clearcoatNormalScale),t.side===1&&e.clearcoatNormalScale.value.negate())),t.dispersion>0&&(e.dispersion.value=t.dispersion),t.retroreflectivity>0&&(e.retroreflectivity.value=t.retroreflectivity),t.iridescence>0&&(e.iridescence.value=t.iridescence,e.iridescenceIOR.value=t.iridescenceIOR,e.iridescenceThicknessMinimum.value=t.iridescenceThicknessMinimum,e.iridescenceThicknessMaximum.value=t.iridescenceThicknessMaximum,t.iridescenceMap&&(e.iridescenceMap.value=t.iridescenceMap,n(t.iridescenceMap,e.iridescenceMapTransform)),t.iridescenceThicknessMap&&(e.iridescenceThicknessMap.value=t.iridescenceThicknessMap,n(t.iridescenceThicknessMap,e.iridescenceThicknessMapTransform))),t.transmission>0&&(e.transmission.value=t.transmission,e.transmissionSamplerMap.value=r.texture,e.transmissionSamplerSize.value.set(r.width,r.height),t.transmissionMap&&(e.transmissionMap.value=t.transmissionMap,n(t.transmissionMap,e.transmissionMapTransform)),e.thickness.value=t.thickness,t.thicknessMap&&(e.thicknessMap.value=t.thicknessMap,n(t.thicknessMap,e.thicknessMapTransform)),e.attenuationDistance.value=t.attenuationDistance,e.attenuationColor.value.copy(t.attenuationColor)),t.anisotropy>0&&(e.anisotropyVector.value.set(t.anisotropy*Math.cos(t.anisotropyRotation),t.anisotropy*Math.sin(t.anisotropyRotation)),t.anisotropyMap&&(e.anisotropyMap.value=t.anisotropyMap,n(t.anisotropyMap,e.anisotropyMapTransform))),e.specularIntensity.value=t.specularIntensity,e.specularColor.value.copy(t.specularColor),t.specularColorMap&&(e.specularColorMap.value=t.specularColorMap,n(t.specularColorMap,e.specularColorMapTransform)),t.specularIntensityMap&&(e.specularIntensityMap.value=t.specularIntensityMap,n(t.specularIntensityMap,e.specularIntensityMapTransform))}function m(e,t){t.matcap&&(e.matcap.value=t.matcap)}function h(e,n){let r=t.get(n).light;e.referencePosition.value.setFromMatrixPosition(r.matrixWorld),e.nearDistance.value=r.shadow.camera.near,e.farDistance.value=r.shadow.camera.far}return{refreshFogUniforms:r,refreshMaterialUniforms:i}}function $y(e,t,n,r){let i={},a={};function o(e,t){let n=t.program;r.uniformBlockBinding(e,n,i[e.id])}function s(e,n){let o=i[e.id];o===void 0&&(m(e),o=c(e),i[e.id]=o,e.addEventListener(`dispose`,g));let s=n.program;r.updateUBOMapping(e,s);let u=t.render.frame;a[e.id]!==u&&(l(e),a[e.id]=u)}function c(t){let n=e.createBuffer(),r=t.__size,i=t.usage;return e.bindBuffer(e.UNIFORM_BUFFER,n),e.bufferData(e.UNIFORM_BUFFER,r,i),e.bindBuffer(e.UNIFORM_BUFFER,null),n}function l(t){let n=i[t.id],r=t.uniforms,a=t.__cache;e.bindBuffer(e.UNIFORM_BUFFER,n);for(let e=0,t=r.length;e<t;e++){let t=r[e];if(Array.isArray(t))for(let n=0,r=t.length;n<r;n++)u(t[n],e,n,a);else u(t,e,0,a)}e.bindBuffer(e.UNIFORM_BUFFER,null)}function u(t,n,r,i){if(f(t,n,r,i)===!0){let n=t.__offset,r=t.value;if(Array.isArray(r)){let e=0;for(let n=0;n<r.length;n++){let i=r[n],a=h(i,!0);d(i,t.__data,e),e+=a.storage/Float32Array.BYTES_PER_ELEMENT}}else d(r,t.__data,0);e.bufferSubData(e.UNIFORM_BUFFER,n,t.__data)}}function d(e,t,n){typeof e==`number`||typeof e==`boolean`?t[n]=e:e.isMatrix3?(t[n]=e.elements[0],t[n+1]=e.elements[1],t[n+2]=e.elements[2],t[n+3]=0,t[n+4]=e.elements[3],t[n+5]=e.elements[4],t[n+6]=e.elements[5],t[n+7]=0,t[n+8]=e.elements[6],t[n+9]=e.elements[7],t[n+10]=e.elements[8],t[n+11]=0):ArrayBuffer.isView(e)?t.set(e.subarray(0,t.length-n),n):e.toArray(t,n)}function f(e,t,n,r){let i=e.value,a=t+`_`+n;if(Array.isArray(i)){r[a]===void 0&&(r[a]=[]);let e=r[a],t=!1;for(let n=0;n<i.length;n++)p(i[n],e,n)===!0&&(t=!0);return t}return p(i,r,a)}function p(e,t,n){if(t[n]===void 0)return t[n]=typeof e==`number`||typeof e==`boolean`?e:ArrayBuffer.isView(e)?e.slice():e.clone(),!0;{let r=t[n];if(typeof e==`number`||typeof e==`boolean`){if(r!==e)return t[n]=e,!0}else if(ArrayBuffer.isView(e))return!0;else if(r.equals(e)===!1)return r.copy(e),!0}return!1}function m(e){let t=e.uniforms,n=0;for(let e=0,r=t.length;e<r;e++){let r=Array.isArray(t[e])?t[e]:[t[e]];for(let i=0,a=r.length;i<a;i++){let a=r[i],o=Array.isArray(a.value)?a.value:[a.value],s=Array.isArray(t[e])||Array.isArray(a.value),c=n;for(let e=0,t=o.length;e<t;e++){let t=o[e],r=h(t,s),i=n%16,a=i%r.boundary,l=i+a;n+=a,l!==0&&16-l<r.storage&&(n+=16-l),e===0&&(c=n),n+=r.storage}a.__data=new(a.type===`int`?Int32Array:a.type===`uint`?Uint32Array:Float32Array)((n-c)/Float32Array.BYTES_PER_ELEMENT),a.__offset=c}}let r=n%16;return r>0&&(n+=16-r),e.__size=n,e.__cache={},this}function h(e,t){let n={boundary:0,storage:0};return typeof e==`number`||typeof e==`boolean`?(n.boundary=4,n.storage=4):e.isVector2?(n.boundary=8,n.storage=8):e.isVector3||e.isColor?(n.boundary=16,n.storage=12):e.isVector4?(n.boundary=16,n.storage=16):e.isMatrix3?(n.boundary=16,n.storage=48):e.isMatrix4?(n.boundary=16,n.storage=64):e.isTexture?V(`WebGLRenderer: Texture samplers can not be part of an uniforms group.`):ArrayBuffer.isView(e)?(n.boundary=16,n.storage=e.byteLength):V(`WebGLRenderer: Unsupported uniform value type.`,e),t===!0&&(n.boundary=16,n.storage=Math.ceil(n.storage/16)*16),n}function g(t){let n=t.target;n.removeEventListener(`dispose`,g),e.deleteBuffer(i[n.id]),delete i[n.id],delete a[n.id]}function _(){for(let t in i)e.deleteBuffer(i[t]);i={},a={}}return{bind:o,update:s,dispose:_}}var eb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),tb=null;function nb(){return tb===null&&(tb=new Dm(eb,16,16,gu,ru),tb.name=`DFG_LUT`,tb.minFilter=ql,tb.magFilter=ql,tb.wrapS=Hl,tb.wrapT=Hl,tb.generateMipmaps=!1,tb.needsUpdate=!0),tb}var rb=class{constructor(e={}){let{canvas:t=bd(),context:n=null,depth:r=!0,stencil:i=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:s=!0,preserveDrawingBuffer:c=!1,powerPreference:l=`default`,failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Xl}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<`u`&&n instanceof WebGLRenderingContext)throw Error(`THREE.WebGLRenderer: WebGL 1 is not supported since r163.`);p=n.getContextAttributes().alpha}else p=a;let m=f,h=new Set([vu,_u,hu]),g=new Set([Xl,tu,$l,ou,iu,au]),_=new Uint32Array(4),v=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},b=null,x=null,S=[],C=[],w=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=0,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,E=!1,D=null,O=null,k=null,A=null;this._outputColorSpace=ld;let j=0,M=0,N=null,ee=-1,te=null,P=new yf,ne=new yf,re=null,ie=new Y(0),ae=0,oe=t.width,se=t.height,ce=1,F=null,le=null,ue=new yf(0,0,oe,se),de=new yf(0,0,oe,se),fe=!1,pe=new Bm,me=new Hm,he=!1,ge=!1,_e=new J,ve=new G,ye=new yf,be={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},xe=!1;function Se(){return N===null?ce:1}let I=n;function Ce(e,n){return t.getContext(e,n)}let L,we,R,Te,z,B,Ee,De,Oe,ke,Ae,je,Me,Ne,Pe,Fe,Ie,Le,Re,ze,Be,Ve,He;try{let e={alpha:!0,depth:r,stencil:i,antialias:o,premultipliedAlpha:s,preserveDrawingBuffer:c,powerPreference:l,failIfMajorPerformanceCaveat:u};if(`setAttribute`in t&&t.setAttribute(`data-engine`,`three.js r187`),t.addEventListener(`webglcontextlost`,Ge,!1),t.addEventListener(`webglcontextrestored`,Ke,!1),t.addEventListener(`webglcontextcreationerror`,qe,!1),I===null){let t=`webgl2`;if(I=Ce(t,e),I===null)throw Ce(t)?Error(`THREE.WebGLRenderer: Error creating WebGL context with your selected attributes.`):Error(`THREE.WebGLRenderer: Error creating WebGL context.`)}Ue()}catch(e){throw t.removeEventListener(`webglcontextlost`,Ge,!1),t.removeEventListener(`webglcontextrestored`,Ke,!1),t.removeEventListener(`webglcontextcreationerror`,qe,!1),H(`WebGLRenderer: `+e.message),e}function Ue(){L=new C_(I),L.init(),Be=new Gy(I,L),we=new r_(I,L,e,Be),R=new Uy(I,L),we.reversedDepthBuffer&&d&&R.buffers.depth.setReversed(!0),O=I.createFramebuffer(),k=I.createFramebuffer(),A=I.createFramebuffer(),Te=new E_(I),z=new Cy,B=new Wy(I,L,R,z,we,Be,Te),Ee=new S_(T),De=new Yg(I),Ve=new t_(I,De),Oe=new w_(I,De,Te,Ve),ke=new O_(I,Oe,De,Ve,Te),Le=new D_(I,we,B),Pe=new i_(z),Ae=new Sy(T,Ee,L,we,Ve,Pe),je=new Qy(T,z),Me=new Dy,Ne=new Py(L),Ie=new e_(T,Ee,R,ke,p,s),Fe=new Hy(T,ke,we),He=new $y(I,Te,we,R),Re=new n_(I,L,Te),ze=new T_(I,L,Te),Te.programs=Ae.programs,T.capabilities=we,T.extensions=L,T.properties=z,T.renderLists=Me,T.shadowMap=Fe,T.state=R,T.info=Te}m!==1009&&(w=new A_(m,t.width,t.height,o,r,i));let We=new Yy(T,I);this.xr=We,this.getContext=function(){return I},this.getContextAttributes=function(){return I.getContextAttributes()},this.forceContextLoss=function(){let e=L.get(`WEBGL_lose_context`);e&&e.loseContext()},this.forceContextRestore=function(){let e=L.get(`WEBGL_lose_context`);e&&e.restoreContext()},this.getPixelRatio=function(){return ce},this.setPixelRatio=function(e){e!==void 0&&(ce=e,this.setSize(oe,se,!1))},this.getSize=function(e){return e.set(oe,se)},this.setSize=function(e,n,r=!0){We.isPresenting?V(`WebGLRenderer: Can't change size while VR device is presenting.`):(oe=e,se=n,t.width=Math.floor(e*ce),t.height=Math.floor(n*ce),r===!0&&(t.style.width=e+`px`,t.style.height=n+`px`),w!==null&&w.setSize(t.width,t.height),this.setViewport(0,0,e,n))},this.getDrawingBufferSize=function(e){return e.set(oe*ce,se*ce).floor()},this.setDrawingBufferSize=function(e,n,r){oe=e,se=n,ce=r,t.width=Math.floor(e*r),t.height=Math.floor(n*r),this.setViewport(0,0,e,n)},this.setEffects=function(e){if(m===1009)H(`WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.`);else{if(e){for(let t=0;t<e.length;t++)if(e[t].isOutputPass===!0){V(`WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.`);break}}w.setEffects(e||[])}},this.getCurrentViewport=function(e){return e.copy(P)},this.getViewport=function(e){return e.copy(ue)},this.setViewport=function(e,t,n,r){e.isVector4?ue.set(e.x,e.y,e.z,e.w):ue.set(e,t,n,r),R.viewport(P.copy(ue).multiplyScalar(Se()).round())},this.getScissor=function(e){return e.copy(de)},this.setScissor=function(e,t,n,r){e.isVector4?de.set(e.x,e.y,e.z,e.w):de.set(e,t,n,r),R.scissor(ne.copy(de).multiplyScalar(Se()).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(e){R.setScissorTest(fe=e)},this.setOpaqueSort=function(e){F=e},this.setTransparentSort=function(e){le=e},this.getClearColor=function(e){return e.copy(Ie.getClearColor())},this.setClearColor=function(){Ie.setClearColor(...arguments)},this.getClearAlpha=function(){return Ie.getClearAlpha()},this.setClearAlpha=function(){Ie.setClearAlpha(...arguments)},this.clear=function(e=!0,t=!0,n=!0){let r=0;if(e){let e=!1;if(N!==null){let t=N.texture.format;e=h.has(t)}if(e){let e=N.texture.type,t=g.has(e),n=Ie.getClearColor(),r=Ie.getClearAlpha(),i=n.r,a=n.g,o=n.b;t?(_[0]=i,_[1]=a,_[2]=o,_[3]=r,I.clearBufferuiv(I.COLOR,0,_)):(v[0]=i,v[1]=a,v[2]=o,v[3]=r,I.clearBufferiv(I.COLOR,0,v))}else r|=I.COLOR_BUFFER_BIT}t&&(r|=I.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),n&&(r|=I.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),r!==0&&I.clear(r)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(e){e.setRenderer(this),D=e},this.dispose=function(){t.removeEventListener(`webglcontextlost`,Ge,!1),t.removeEventListener(`webglcontextrestored`,Ke,!1),t.removeEventListener(`webglcontextcreationerror`,qe,!1),Ie.dispose(),Me.dispose(),Ne.dispose(),B.dispose(),z.dispose(),Ee.dispose(),ke.dispose(),Oe.dispose(),Ve.dispose(),He.dispose(),Ae.dispose(),We.dispose(),We.removeEventListener(`sessionstart`,et),We.removeEventListener(`sessionend`,tt),nt.stop()};function Ge(e){e.preventDefault(),Sd(`WebGLRenderer: Context Lost.`),E=!0}function Ke(){Sd(`WebGLRenderer: Context Restored.`),E=!1;let e=Te.autoReset,t=Fe.enabled,n=Fe.autoUpdate,r=Fe.needsUpdate,i=Fe.type;Ue(),Te.autoReset=e,Fe.enabled=t,Fe.autoUpdate=n,Fe.needsUpdate=r,Fe.type=i}function qe(e){H(`WebGLRenderer: A WebGL context could not be created. Reason: `,e.statusMessage)}function Je(e){let t=e.target;t.removeEventListener(`dispose`,Je),Ye(t)}function Ye(e){Xe(e),z.remove(e)}function Xe(e){let t=z.get(e).programs;t!==void 0&&(t.forEach(function(e){Ae.releaseProgram(e)}),e.isShaderMaterial&&Ae.releaseShaderCache(e))}this.renderBufferDirect=function(e,t,n,r,i,a){t===null&&(t=be);let o=i.isMesh&&i.matrixWorld.determinantAffine()<0,s=pt(e,t,n,r,i);R.setMaterial(r,o);let c=n.index,l=1;if(r.wireframe===!0){if(c=Oe.getWireframeAttribute(n),c===void 0)return;l=2}let u=n.drawRange,d=n.attributes.position,f=u.start*l,p=(u.start+u.count)*l;a!==null&&(f=Math.max(f,a.start*l),p=Math.min(p,(a.start+a.count)*l)),c===null?d!=null&&(f=Math.max(f,0),p=Math.min(p,d.count)):(f=Math.max(f,0),p=Math.min(p,c.count));let m=p-f;if(m<0||m===1/0)return;Ve.setup(i,r,s,n,c);let h,g=Re;if(c!==null&&(h=De.get(c),g=ze,g.setIndex(h)),i.isMesh)r.wireframe===!0?(R.setLineWidth(r.wireframeLinewidth*Se()),g.setMode(I.LINES)):g.setMode(I.TRIANGLES);else if(i.isLine){let e=r.linewidth;e===void 0&&(e=1),R.setLineWidth(e*Se()),i.isLineSegments?g.setMode(I.LINES):i.isLineLoop?g.setMode(I.LINE_LOOP):g.setMode(I.LINE_STRIP)}else i.isPoints?g.setMode(I.POINTS):i.isSprite&&g.setMode(I.TRIANGLES);if(i.isBatchedMesh){if(L.get(`WEBGL_multi_draw`))g.renderMultiDraw(i._multiDrawStarts,i._multiDrawCounts,i._multiDrawCount);else{let e=i._multiDrawStarts,t=i._multiDrawCounts,n=i._multiDrawCount,a=c?De.get(c).bytesPerElement:1,o=z.get(r).currentProgram.getUniforms();for(let r=0;r<n;r++)o.setValue(I,`_gl_DrawID`,r),g.render(e[r]/a,t[r])}}else if(i.isInstancedMesh)g.renderInstances(f,m,i.count);else if(n.isInstancedBufferGeometry){let e=n._maxInstanceCount===void 0?1/0:n._maxInstanceCount,t=Math.min(n.instanceCount,e);g.renderInstances(f,m,t)}else g.render(f,m)};function Ze(e,t,n,r){D!==null&&e.isNodeMaterial&&D.setObject(r,e),he===!0&&Pe.setState(e,n,!1),e.transparent===!0&&e.side===2&&e.forceSinglePass===!1?(e.side=1,e.needsUpdate=!0,lt(e,t,r),e.side=0,e.needsUpdate=!0,lt(e,t,r),e.side=2):lt(e,t,r)}this.compile=function(e,t,n=null){n===null&&(n=e),D!==null&&D.renderStart(e,t,n),x=Ne.get(n),x.init(t),C.push(x),n.traverseVisible(function(e){e.isLight&&e.layers.test(t.layers)&&(x.pushLight(e),e.castShadow&&x.pushShadow(e))}),e!==n&&e.traverseVisible(function(e){e.isLight&&e.layers.test(t.layers)&&(x.pushLight(e),e.castShadow&&x.pushShadow(e))}),x.setupLights(),D!==null&&D.updateLights(x.state.lightsArray),ge=this.localClippingEnabled,he=Pe.init(this.clippingPlanes,ge),he===!0&&Pe.setGlobalState(this.clippingPlanes,t),D!==null&&Fe.render(x.state.shadowsArray,n,t);let r=new Set;return e.traverse(function(e){if(!(e.isMesh||e.isPoints||e.isLine||e.isSprite))return;let i=e.material;if(i){if(Array.isArray(i))for(let a=0;a<i.length;a++){let o=i[a];Ze(o,n,t,e),r.add(o)}else Ze(i,n,t,e),r.add(i)}}),x=C.pop(),D!==null&&D.renderEnd(),r},this.compileAsync=function(e,t,n=null){let r=this.compile(e,t,n);return new Promise(t=>{function n(){r.forEach(function(e){let t=z.get(e).currentProgram;(t===void 0||t.isReady())&&r.delete(e)}),r.size===0?t(e):setTimeout(n,10)}L.get(`KHR_parallel_shader_compile`)===null?setTimeout(n,10):n()})};let Qe=null;function $e(e){Qe&&Qe(e)}function et(){nt.stop()}function tt(){nt.start()}let nt=new Jg;nt.setAnimationLoop($e),typeof self<`u`&&nt.setContext(self),this.setAnimationLoop=function(e){Qe=e,We.setAnimationLoop(e),e===null?nt.stop():nt.start()},We.addEventListener(`sessionstart`,et),We.addEventListener(`sessionend`,tt),this.render=function(e,t){if(t!==void 0&&t.isCamera!==!0){H(`WebGLRenderer.render: camera is not an instance of THREE.Camera.`);return}if(E===!0)return;D!==null&&D.renderStart(e,t);let n=We.enabled===!0&&We.isPresenting===!0,r=w!==null&&(N===null||n)&&w.begin(T,N);if(e.matrixWorldAutoUpdate===!0&&e.updateMatrixWorld(),t.parent===null&&t.matrixWorldAutoUpdate===!0&&t.updateMatrixWorld(),We.enabled===!0&&We.isPresenting===!0&&(w===null||w.isCompositing()===!1)&&(We.cameraAutoUpdate===!0&&We.updateCamera(t),t=We.getCamera()),e.isScene===!0&&e.onBeforeRender(T,e,t,N),x=Ne.get(e,C.length),x.init(t),x.state.textureUnits=B.getTextureUnits(),C.push(x),_e.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),t.isArrayCamera?me.setFromArrayCamera(t):pe.setFromProjectionMatrix(_e,gd,t.reversedDepth),ge=this.localClippingEnabled,he=Pe.init(this.clippingPlanes,ge),b=Me.get(e,S.length),b.init(),S.push(b),this.info.render.frame++,We.enabled===!0&&We.isPresenting===!0){let e=T.xr.getDepthSensingMesh();e!==null&&rt(e,t,-1/0,T.sortObjects)}rt(e,t,0,T.sortObjects),b.finish(),D!==null&&D.updateLights(x.state.lightsArray),T.sortObjects===!0&&b.sort(F,le),xe=We.enabled===!1||We.isPresenting===!1||We.hasDepthSensing()===!1,xe&&Ie.addToRenderList(b,e),this.info.autoReset===!0&&this.info.reset(),he===!0&&Pe.beginShadows();let i=x.state.shadowsArray;if(Fe.render(i,e,t),he===!0&&Pe.endShadows(),(r&&w.hasRenderPass())===!1){let n=b.opaque,r=b.transmissive;if(x.setupLights(),t.isArrayCamera){let i=t.cameras;if(r.length>0)for(let t=0,a=i.length;t<a;t++){let a=i[t];at(n,r,e,a)}xe&&Ie.render(e);for(let t=0,n=i.length;t<n;t++){let n=i[t];it(b,e,n,n.viewport)}}else r.length>0&&at(n,r,e,t),xe&&Ie.render(e),it(b,e,t)}N!==null&&M===0&&(B.updateMultisampleRenderTarget(N),B.updateRenderTargetMipmap(N)),r&&w.end(T),e.isScene===!0&&e.onAfterRender(T,e,t),Ve.resetDefaultState(),ee=-1,te=null,C.pop(),C.length>0?(x=C[C.length-1],B.setTextureUnits(x.state.textureUnits),he===!0&&Pe.setGlobalState(T.clippingPlanes,x.state.camera)):x=null,S.pop(),b=S.length>0?S[S.length-1]:null,D!==null&&D.renderEnd()};function rt(e,t,n,r){if(e.visible===!1)return;if(e.layers.test(t.layers)){if(e.isGroup)n=e.renderOrder;else if(e.isLOD)e.autoUpdate===!0&&e.update(t);else if(e.isLight)x.pushLight(e),e.castShadow&&x.pushShadow(e);else if(e.isSprite){let i=t.isArrayCamera?me:pe;if(!e.frustumCulled||e.intersectsFrustum(i)){r&&ye.setFromMatrixPosition(e.matrixWorld).applyMatrix4(_e);let i=ke.update(e),a=e.material;a.visible&&b.push(e,i,a,n,ye.z,null,t)}}else if(e.isMesh||e.isLine||e.isPoints){let i=t.isArrayCamera?me:pe;if(!e.frustumCulled||e.intersectsFrustum(i)){let i=ke.update(e),a=e.material;if(r&&(e.boundingSphere===void 0?(i.boundingSphere===null&&i.computeBoundingSphere(),ye.copy(i.boundingSphere.center)):(e.boundingSphere===null&&e.computeBoundingSphere(),ye.copy(e.boundingSphere.center)),ye.applyMatrix4(e.matrixWorld).applyMatrix4(_e)),Array.isArray(a)){let r=i.groups;for(let o=0,s=r.length;o<s;o++){let s=r[o],c=a[s.materialIndex];c&&c.visible&&b.push(e,i,c,n,ye.z,s,t)}}else a.visible&&b.push(e,i,a,n,ye.z,null,t)}}}let i=e.children;for(let e=0,a=i.length;e<a;e++)rt(i[e],t,n,r)}function it(e,t,n,r){let{opaque:i,transmissive:a,transparent:o}=e;x.setupLightsView(n),he===!0&&Pe.setGlobalState(T.clippingPlanes,n),r&&R.viewport(P.copy(r)),i.length>0&&ot(i,t,n),a.length>0&&ot(a,t,n),o.length>0&&ot(o,t,n),R.buffers.depth.setTest(!0),R.buffers.depth.setMask(!0),R.buffers.color.setMask(!0),R.setPolygonOffset(!1)}function at(e,t,n,r){if((n.isScene===!0?n.overrideMaterial:null)!==null)return;if(x.state.transmissionRenderTarget[r.id]===void 0){let e=L.has(`EXT_color_buffer_half_float`)||L.has(`EXT_color_buffer_float`);x.state.transmissionRenderTarget[r.id]=new xf(1,1,{generateMipmaps:!0,type:e?ru:Xl,minFilter:Yl,samples:Math.max(4,we.samples),stencilBuffer:i,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:q.workingColorSpace})}let a=x.state.transmissionRenderTarget[r.id],o=r.viewport||P;a.setSize(o.z*T.transmissionResolutionScale,o.w*T.transmissionResolutionScale);let s=T.getRenderTarget(),c=T.getActiveCubeFace(),l=T.getActiveMipmapLevel();T.setRenderTarget(a),T.getClearColor(ie),ae=T.getClearAlpha(),ae<1&&T.setClearColor(16777215,.5),T.clear(),xe&&Ie.render(n);let u=T.toneMapping;T.toneMapping=0;let d=r.viewport;if(r.viewport!==void 0&&(r.viewport=void 0),x.setupLightsView(r),he===!0&&Pe.setGlobalState(T.clippingPlanes,r),ot(e,n,r),B.updateMultisampleRenderTarget(a),B.updateRenderTargetMipmap(a),L.has(`WEBGL_multisampled_render_to_texture`)===!1){let e=!1;for(let i=0,a=t.length;i<a;i++){let{object:a,geometry:o,material:s,group:c}=t[i];if(s.side===2&&a.layers.test(r.layers)){let t=s.side;s.side=1,s.needsUpdate=!0,st(a,n,r,o,s,c),s.side=t,s.needsUpdate=!0,e=!0}}e===!0&&(B.updateMultisampleRenderTarget(a),B.updateRenderTargetMipmap(a))}T.setRenderTarget(s,c,l),T.setClearColor(ie,ae),d!==void 0&&(r.viewport=d),T.toneMapping=u}function ot(e,t,n){let r=t.isScene===!0?t.overrideMaterial:null;for(let i=0,a=e.length;i<a;i++){let a=e[i],{object:o,geometry:s,group:c}=a,l=a.material;l.allowOverride===!0&&r!==null&&(l=r),o.layers.test(n.layers)&&st(o,t,n,s,l,c)}}function st(e,t,n,r,i,a){D!==null&&i.isNodeMaterial&&D.setObject(e,i),e.onBeforeRender(T,t,n,r,i,a),e.modelViewMatrix.multiplyMatrices(n.matrixWorldInverse,e.matrixWorld),e.normalMatrix.getNormalMatrix(e.modelViewMatrix),i.onBeforeRender(T,t,n,r,e,a),i.transparent===!0&&i.side===2&&i.forceSinglePass===!1?(i.side=1,i.needsUpdate=!0,T.renderBufferDirect(n,t,r,i,e,a),i.side=0,i.needsUpdate=!0,T.renderBufferDirect(n,t,r,i,e,a),i.side=2):T.renderBufferDirect(n,t,r,i,e,a),e.onAfterRender(T,t,n,r,i,a)}function ct(e){let t=0;for(let n of e)n.texture!==null&&t++;return t}function lt(e,t,n){t.isScene!==!0&&(t=be);let r=z.get(e),i=x.state.lights,a=x.state.shadowsArray,o=i.state.version,s=Ae.getParameters(e,i.state,a,t,n,x.state.lightProbeGridArray),c=Ae.getProgramCacheKey(s),l=r.programs;r.environment=e.isMeshStandardMaterial||e.isMeshLambertMaterial||e.isMeshPhongMaterial?t.environment:null,r.fog=t.fog;let u=e.isMeshStandardMaterial||e.isMeshLambertMaterial&&!e.envMap||e.isMeshPhongMaterial&&!e.envMap;r.envMap=Ee.get(e.envMap||r.environment,u),r.envMapRotation=r.environment!==null&&e.envMap===null?t.environmentRotation:e.envMapRotation,l===void 0&&(e.addEventListener(`dispose`,Je),l=new Map,r.programs=l,r.programVariants=new Map);let d=l.get(c);if(d!==void 0){if(r.currentProgram===d&&r.lightsStateVersion===o)return ft(e,s),d}else s.uniforms=Ae.getUniforms(e),D!==null&&e.isNodeMaterial&&D.build(e,n,s),e.onBeforeCompile(s,T),d=Ae.acquireProgram(s,c),l.set(c,d),r.uniforms=s.uniforms;let f=r.uniforms;return(!e.isShaderMaterial&&!e.isRawShaderMaterial||e.clipping===!0)&&(f.clippingPlanes=Pe.uniform),ft(e,s),r.needsLights=ht(e),r.lightsStateVersion=o,r.needsLights&&(f.ambientLightColor.value=i.state.ambient,f.lightProbe.value=i.state.probe,f.sunLights.value=i.state.sun,f.sunLightShadows.value=i.state.sunShadow,f.directionalLights.value=i.state.directional,f.directionalLightShadows.value=i.state.directionalShadow,f.spotLights.value=i.state.spot,f.spotLightShadows.value=i.state.spotShadow,f.rectAreaLights.value=i.state.rectArea,f.ltc_1.value=i.state.rectAreaLTC1,f.ltc_2.value=i.state.rectAreaLTC2,f.pointLights.value=i.state.point,f.pointLightShadows.value=i.state.pointShadow,f.hemisphereLights.value=i.state.hemi,f.sunShadowMatrix.value=i.state.sunShadowMatrix,f.sunShadowCascade.value=i.state.sunShadowCascade,f.directionalShadowMatrix.value=i.state.directionalShadowMatrix,f.spotLightMatrix.value=i.state.spotLightMatrix,f.spotLightMap.value=i.state.spotLightMap,f.pointShadowMatrix.value=i.state.pointShadowMatrix),r.numLightProbeGrids=ct(x.state.lightProbeGridArray),r.currentProgram=d,r.uniformsList=null,d}function ut(e,t,n,r,i){let a=z.get(e),o=a.currentProgram.id+`,`+r+`,`+i,s=a.programVariants.get(o);return s===void 0?(s=lt(e,t,n),a.programVariants.set(o,s)):(a.currentProgram=s,a.uniformsList=null,a.outputColorSpace=r,a.toneMapping=i),s}function dt(e){if(e.uniformsList===null){let t=e.currentProgram.getUniforms();e.uniformsList=zv.seqWithValue(t.seq,e.uniforms)}return e.uniformsList}function ft(e,t){let n=z.get(e);n.outputColorSpace=t.outputColorSpace,n.batching=t.batching,n.batchingColor=t.batchingColor,n.instancing=t.instancing,n.instancingColor=t.instancingColor,n.instancingMorph=t.instancingMorph,n.skinning=t.skinning,n.morphTargets=t.morphTargets,n.morphNormals=t.morphNormals,n.morphColors=t.morphColors,n.morphTargetsCount=t.morphTargetsCount,n.numClippingPlanes=t.numClippingPlanes,n.numIntersection=t.numClipIntersection,n.vertexAlphas=t.vertexAlphas,n.vertexTangents=t.vertexTangents,n.toneMapping=t.toneMapping}function pt(e,t,n,r,i){t.isScene!==!0&&(t=be),B.resetTextureUnits();let a=t.fog,o=r.isMeshStandardMaterial||r.isMeshLambertMaterial||r.isMeshPhongMaterial?t.environment:null,s=N===null?T.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:q.workingColorSpace,c=r.isMeshStandardMaterial||r.isMeshLambertMaterial&&!r.envMap||r.isMeshPhongMaterial&&!r.envMap,l=Ee.get(r.envMap||o,c),u=r.vertexColors===!0&&!!n.attributes.color&&n.attributes.color.itemSize===4,d=!!n.attributes.tangent&&(!!r.normalMap||r.anisotropy>0),f=!!n.morphAttributes.position,p=!!n.morphAttributes.normal,m=!!n.morphAttributes.color,h=0;r.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(h=T.toneMapping);let g=n.morphAttributes.position||n.morphAttributes.normal||n.morphAttributes.color,_=g===void 0?0:g.length,v=z.get(r),b=x.state.lights;if(he===!0&&(ge===!0||e!==te)){let t=e===te&&r.id===ee;Pe.setState(r,e,t)}let S=!1,C=!1;r.version===v.__version?v.needsLights&&v.lightsStateVersion!==b.state.version||i.isBatchedMesh&&v.batching===!1||!i.isBatchedMesh&&v.batching===!0||i.isBatchedMesh&&v.batchingColor===!0&&i._colorsTexture===null||i.isBatchedMesh&&v.batchingColor===!1&&i._colorsTexture!==null||i.isInstancedMesh&&v.instancing===!1||!i.isInstancedMesh&&v.instancing===!0||i.isSkinnedMesh&&v.skinning===!1||!i.isSkinnedMesh&&v.skinning===!0||i.isInstancedMesh&&v.instancingColor===!0&&i.instanceColor===null||i.isInstancedMesh&&v.instancingColor===!1&&i.instanceColor!==null||i.isInstancedMesh&&v.instancingMorph===!0&&i.morphTexture===null||i.isInstancedMesh&&v.instancingMorph===!1&&i.morphTexture!==null?S=!0:v.envMap===l?r.fog===!0&&v.fog!==a||v.numClippingPlanes!==void 0&&(v.numClippingPlanes!==Pe.numPlanes||v.numIntersection!==Pe.numIntersection)?S=!0:v.vertexAlphas===u&&v.vertexTangents===d&&v.morphTargets===f&&v.morphNormals===p&&v.morphColors===m&&v.morphTargetsCount===_&&v.numLightProbeGrids===ct(x.state.lightProbeGridArray)?(v.outputColorSpace!==s||v.toneMapping!==h)&&(C=!0):S=!0:S=!0:(S=!0,v.__version=r.version);let w=v.currentProgram;(S===!0||C===!0)&&(w=C===!0?ut(r,t,i,s,h):lt(r,t,i),D&&r.isNodeMaterial&&D.onUpdateProgram(r,w,v));let E=!1,O=!1,k=!1,A=w.getUniforms(),j=v.uniforms;if(R.useProgram(w.program)&&(E=!0,O=!0,k=!0),r.id!==ee&&(ee=r.id,O=!0),E||te!==e){R.buffers.depth.getReversed()&&e.reversedDepth!==!0&&(e._reversedDepth=!0,e.updateProjectionMatrix()),A.setValue(I,`projectionMatrix`,e.projectionMatrix),A.setValue(I,`viewMatrix`,e.matrixWorldInverse);let t=A.map.cameraPosition;t!==void 0&&t.setValue(I,ve.setFromMatrixPosition(e.matrixWorld)),we.logarithmicDepthBuffer&&A.setValue(I,`logDepthBufFC`,2/(Math.log(e.far+1)/Math.LN2)),(r.isMeshPhongMaterial||r.isMeshToonMaterial||r.isMeshLambertMaterial||r.isMeshBasicMaterial||r.isMeshStandardMaterial||r.isShaderMaterial)&&A.setValue(I,`isOrthographic`,e.isOrthographicCamera===!0),te!==e&&(te=e,O=!0,k=!0)}if(v.needsLights&&(b.state.sunShadowMap.length>0&&A.setValue(I,`sunShadowMap`,b.state.sunShadowMap,B),b.state.directionalShadowMap.length>0&&A.setValue(I,`directionalShadowMap`,b.state.directionalShadowMap,B),b.state.spotShadowMap.length>0&&A.setValue(I,`spotShadowMap`,b.state.spotShadowMap,B),b.state.pointShadowMap.length>0&&A.setValue(I,`pointShadowMap`,b.state.pointShadowMap,B)),i.isSkinnedMesh){A.setOptional(I,i,`bindMatrix`),A.setOptional(I,i,`bindMatrixInverse`);let e=i.skeleton;e&&(e.boneTexture===null&&e.computeBoneTexture(),A.setValue(I,`boneTexture`,e.boneTexture,B))}i.isBatchedMesh&&(A.setOptional(I,i,`batchingTexture`),A.setValue(I,`batchingTexture`,i._matricesTexture,B),A.setOptional(I,i,`batchingIdTexture`),A.setValue(I,`batchingIdTexture`,i._indirectTexture,B),A.setOptional(I,i,`batchingColorTexture`),i._colorsTexture!==null&&A.setValue(I,`batchingColorTexture`,i._colorsTexture,B));let M=n.morphAttributes;if((M.position!==void 0||M.normal!==void 0||M.color!==void 0)&&Le.update(i,n,w),(O||v.receiveShadow!==i.receiveShadow)&&(v.receiveShadow=i.receiveShadow,A.setValue(I,`receiveShadow`,i.receiveShadow)),(r.isMeshStandardMaterial||r.isMeshLambertMaterial||r.isMeshPhongMaterial)&&r.envMap===null&&t.environment!==null&&(j.envMapIntensity.value=t.environmentIntensity),j.dfgLUT!==void 0&&(j.dfgLUT.value=nb()),O){if(A.setValue(I,`toneMappingExposure`,T.toneMappingExposure),v.needsLights&&mt(j,k),a&&r.fog===!0&&je.refreshFogUniforms(j,a),je.refreshMaterialUniforms(j,r,ce,se,x.state.transmissionRenderTarget[e.id]),v.needsLights&&v.numLightProbeGrids>0){let e=y,t=0;for(let n of x.state.lightProbeGridArray)n.texture!==null&&(e.textures[t]=n.texture,e.min[t]=n.boundingBox.min,e.max[t]=n.boundingBox.max,e.resolution[t]=n.resolution,t++);for(let n in e)e[n].length=t;j.probesSH.value=e.textures,j.probesMin.value=e.min,j.probesMax.value=e.max,j.probesResolution.value=e.resolution}zv.upload(I,dt(v),j,B)}if(r.isShaderMaterial&&r.uniformsNeedUpdate===!0&&(zv.upload(I,dt(v),j,B),r.uniformsNeedUpdate=!1),r.isSpriteMaterial&&A.setValue(I,`center`,i.center),A.setValue(I,`modelViewMatrix`,i.modelViewMatrix),A.setValue(I,`normalMatrix`,i.normalMatrix),A.setValue(I,`modelMatrix`,i.matrixWorld),r.uniformsGroups!==void 0){let e=r.uniformsGroups;for(let t=0,n=e.length;t<n;t++){let n=e[t];He.update(n,w),He.bind(n,w)}}return w}function mt(e,t){e.ambientLightColor.needsUpdate=t,e.lightProbe.needsUpdate=t,e.sunLights.needsUpdate=t,e.sunLightShadows.needsUpdate=t,e.directionalLights.needsUpdate=t,e.directionalLightShadows.needsUpdate=t,e.pointLights.needsUpdate=t,e.pointLightShadows.needsUpdate=t,e.spotLights.needsUpdate=t,e.spotLightShadows.needsUpdate=t,e.rectAreaLights.needsUpdate=t,e.hemisphereLights.needsUpdate=t}function ht(e){return e.isMeshLambertMaterial||e.isMeshToonMaterial||e.isMeshPhongMaterial||e.isMeshStandardMaterial||e.isShadowMaterial||e.isShaderMaterial&&e.lights===!0}this.getActiveCubeFace=function(){return j},this.getActiveMipmapLevel=function(){return M},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(e,t,n){let r=z.get(e);r.__autoAllocateDepthBuffer=e.resolveDepthBuffer===!1,r.__autoAllocateDepthBuffer===!1&&(r.__useRenderToTexture=!1),z.get(e.texture).__webglTexture=t,z.get(e.depthTexture).__webglTexture=r.__autoAllocateDepthBuffer?void 0:n,r.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(e,t){let n=z.get(e);n.__webglFramebuffer=t,n.__useDefaultFramebuffer=t===void 0},this.setRenderTarget=function(e,t=0,n=0){N=e,j=t,M=n;let r=null,i=!1,a=!1;if(e){let o=z.get(e);if(o.__useDefaultFramebuffer!==void 0){R.bindFramebuffer(I.FRAMEBUFFER,o.__webglFramebuffer),P.copy(e.viewport),ne.copy(e.scissor),re=e.scissorTest,R.viewport(P),R.scissor(ne),R.setScissorTest(re),ee=-1;return}if(o.__webglFramebuffer===void 0)B.setupRenderTarget(e);else if(o.__hasExternalTextures)B.rebindTextures(e,z.get(e.texture).__webglTexture,z.get(e.depthTexture).__webglTexture);else if(e.depthBuffer){let t=e.depthTexture;if(o.__boundDepthTexture!==t){if(t!==null&&z.has(t)&&(e.width!==t.image.width||e.height!==t.image.height))throw Error(`THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.`);B.setupDepthRenderbuffer(e)}}let s=e.texture;(s.isData3DTexture||s.isDataArrayTexture||s.isCompressedArrayTexture)&&(a=!0);let c=z.get(e).__webglFramebuffer;e.isWebGLCubeRenderTarget?(r=Array.isArray(c[t])?c[t][n]:c[t],i=!0):r=e.samples>0&&B.useMultisampledRTT(e)===!1?z.get(e).__webglMultisampledFramebuffer:Array.isArray(c)?c[n]:c,P.copy(e.viewport),ne.copy(e.scissor),re=e.scissorTest}else P.copy(ue).multiplyScalar(ce).floor(),ne.copy(de).multiplyScalar(ce).floor(),re=fe;if(n!==0&&(r=O),R.bindFramebuffer(I.FRAMEBUFFER,r)&&R.drawBuffers(e,r),R.viewport(P),R.scissor(ne),R.setScissorTest(re),i){let r=z.get(e.texture);I.framebufferTexture2D(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_CUBE_MAP_POSITIVE_X+t,r.__webglTexture,n)}else if(a){let r=t;for(let t=0;t<e.textures.length;t++){let i=z.get(e.textures[t]);I.framebufferTextureLayer(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0+t,i.__webglTexture,n,r)}}else if(e!==null&&n!==0){let t=z.get(e.texture);I.framebufferTexture2D(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,t.__webglTexture,n)}ee=-1};function gt(e){let t=z.get(e);return(t.__readFormat!==e.format||t.__readType!==e.type)&&(t.__readFormat=e.format,t.__readType=e.type,t.__formatReadable=we.textureFormatReadable(e.format),t.__typeReadable=we.textureTypeReadable(e.type)),t}this.readRenderTargetPixels=function(e,t,n,r,i,a,o,s=0){if(!(e&&e.isWebGLRenderTarget)){H(`WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.`);return}let c=z.get(e).__webglFramebuffer;if(e.isWebGLCubeRenderTarget&&o!==void 0&&(c=c[o],Array.isArray(c)&&(c=c[0])),c){R.bindFramebuffer(I.FRAMEBUFFER,c);try{let o=e.textures[s],c=o.format,l=o.type;e.textures.length>1&&I.readBuffer(I.COLOR_ATTACHMENT0+s);let u=gt(o);if(u.__formatReadable===!1){H(`WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.`);return}if(u.__typeReadable===!1){H(`WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.`);return}t>=0&&t<=e.width-r&&n>=0&&n<=e.height-i&&I.readPixels(t,n,r,i,Be.convert(c),Be.convert(l),a)}finally{let e=N===null?null:z.get(N).__webglFramebuffer;R.bindFramebuffer(I.FRAMEBUFFER,e)}}},this.readRenderTargetPixelsAsync=async function(e,t,n,r,i,a,o,s=0){if(!(e&&e.isWebGLRenderTarget))throw Error(`THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.`);let c=z.get(e).__webglFramebuffer;if(e.isWebGLCubeRenderTarget&&o!==void 0&&(c=c[o],Array.isArray(c)&&(c=c[0])),c){if(t>=0&&t<=e.width-r&&n>=0&&n<=e.height-i){R.bindFramebuffer(I.FRAMEBUFFER,c);let o=e.textures[s],l=o.format,u=o.type;e.textures.length>1&&I.readBuffer(I.COLOR_ATTACHMENT0+s);let d=gt(o);if(d.__formatReadable===!1)throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.`);if(d.__typeReadable===!1)throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.`);let f=I.createBuffer();I.bindBuffer(I.PIXEL_PACK_BUFFER,f),I.bufferData(I.PIXEL_PACK_BUFFER,a.byteLength,I.STREAM_READ),I.readPixels(t,n,r,i,Be.convert(l),Be.convert(u),0),I.bindBuffer(I.PIXEL_PACK_BUFFER,null);let p=N===null?null:z.get(N).__webglFramebuffer;R.bindFramebuffer(I.FRAMEBUFFER,p);let m=I.fenceSync(I.SYNC_GPU_COMMANDS_COMPLETE,0);return I.flush(),await Td(I,m,4),I.bindBuffer(I.PIXEL_PACK_BUFFER,f),I.getBufferSubData(I.PIXEL_PACK_BUFFER,0,a),I.bindBuffer(I.PIXEL_PACK_BUFFER,null),I.deleteBuffer(f),I.deleteSync(m),a}throw Error(`THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.`)}},this.copyFramebufferToTexture=function(e,t=null,n=0){let r=2**-n,i=Math.floor(e.image.width*r),a=Math.floor(e.image.height*r),o=t===null?0:t.x,s=t===null?0:t.y;B.setTexture2D(e,0),I.copyTexSubImage2D(I.TEXTURE_2D,n,0,0,o,s,i,a),R.unbindTexture()},this.copyTextureToTexture=function(e,t,n=null,r=null,i=0,a=0){let o,s,c,l,u,d,f,p,m,h=e.isCompressedTexture?e.mipmaps[a]:e.image;if(n!==null)o=n.max.x-n.min.x,s=n.max.y-n.min.y,c=n.isBox3?n.max.z-n.min.z:1,l=n.min.x,u=n.min.y,d=n.isBox3?n.min.z:0;else{let t=2**-i;o=Math.floor(h.width*t),s=Math.floor(h.height*t),c=e.isDataArrayTexture?h.depth:e.isData3DTexture?Math.floor(h.depth*t):1,l=0,u=0,d=0}r===null?(f=0,p=0,m=0):(f=r.x,p=r.y,m=r.z);let g=Be.convert(t.format),_=Be.convert(t.type),v;t.isData3DTexture?(B.setTexture3D(t,0),v=I.TEXTURE_3D):t.isDataArrayTexture||t.isCompressedArrayTexture?(B.setTexture2DArray(t,0),v=I.TEXTURE_2D_ARRAY):(B.setTexture2D(t,0),v=I.TEXTURE_2D),R.activeTexture(I.TEXTURE0),R.pixelStorei(I.UNPACK_FLIP_Y_WEBGL,t.flipY),R.pixelStorei(I.UNPACK_PREMULTIPLY_ALPHA_WEBGL,t.premultiplyAlpha),R.pixelStorei(I.UNPACK_ALIGNMENT,t.unpackAlignment);let y=R.getParameter(I.UNPACK_ROW_LENGTH),b=R.getParameter(I.UNPACK_IMAGE_HEIGHT),x=R.getParameter(I.UNPACK_SKIP_PIXELS),S=R.getParameter(I.UNPACK_SKIP_ROWS),C=R.getParameter(I.UNPACK_SKIP_IMAGES);R.pixelStorei(I.UNPACK_ROW_LENGTH,h.width),R.pixelStorei(I.UNPACK_IMAGE_HEIGHT,h.height),R.pixelStorei(I.UNPACK_SKIP_PIXELS,l),R.pixelStorei(I.UNPACK_SKIP_ROWS,u),R.pixelStorei(I.UNPACK_SKIP_IMAGES,d);let w=e.isDataArrayTexture||e.isData3DTexture,T=t.isDataArrayTexture||t.isData3DTexture;if(e.isDepthTexture){let n=z.get(e),r=z.get(t),h=z.get(n.__renderTarget),g=z.get(r.__renderTarget);R.bindFramebuffer(I.READ_FRAMEBUFFER,h.__webglFramebuffer),R.bindFramebuffer(I.DRAW_FRAMEBUFFER,g.__webglFramebuffer);for(let n=0;n<c;n++)w&&(I.framebufferTextureLayer(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,z.get(e).__webglTexture,i,d+n),I.framebufferTextureLayer(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,z.get(t).__webglTexture,a,m+n)),I.blitFramebuffer(l,u,l+o,u+s,f,p,f+o,p+s,I.DEPTH_BUFFER_BIT,I.NEAREST);R.bindFramebuffer(I.READ_FRAMEBUFFER,null),R.bindFramebuffer(I.DRAW_FRAMEBUFFER,null)}else if(i!==0||e.isRenderTargetTexture||z.has(e)){let n=z.get(e),r=z.get(t);R.bindFramebuffer(I.READ_FRAMEBUFFER,k),R.bindFramebuffer(I.DRAW_FRAMEBUFFER,A);for(let e=0;e<c;e++)w?I.framebufferTextureLayer(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,n.__webglTexture,i,d+e):I.framebufferTexture2D(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,n.__webglTexture,i),T?I.framebufferTextureLayer(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,r.__webglTexture,a,m+e):I.framebufferTexture2D(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,r.__webglTexture,a),i===0?T?I.copyTexSubImage3D(v,a,f,p,m+e,l,u,o,s):I.copyTexSubImage2D(v,a,f,p,l,u,o,s):I.blitFramebuffer(l,u,l+o,u+s,f,p,f+o,p+s,I.COLOR_BUFFER_BIT,I.NEAREST);R.bindFramebuffer(I.READ_FRAMEBUFFER,null),R.bindFramebuffer(I.DRAW_FRAMEBUFFER,null)}else T?e.isDataTexture||e.isData3DTexture?I.texSubImage3D(v,a,f,p,m,o,s,c,g,_,h.data):t.isCompressedArrayTexture?I.compressedTexSubImage3D(v,a,f,p,m,o,s,c,g,h.data):I.texSubImage3D(v,a,f,p,m,o,s,c,g,_,h):e.isDataTexture?I.texSubImage2D(I.TEXTURE_2D,a,f,p,o,s,g,_,h.data):e.isCompressedTexture?I.compressedTexSubImage2D(I.TEXTURE_2D,a,f,p,h.width,h.height,g,h.data):I.texSubImage2D(I.TEXTURE_2D,a,f,p,o,s,g,_,h);R.pixelStorei(I.UNPACK_ROW_LENGTH,y),R.pixelStorei(I.UNPACK_IMAGE_HEIGHT,b),R.pixelStorei(I.UNPACK_SKIP_PIXELS,x),R.pixelStorei(I.UNPACK_SKIP_ROWS,S),R.pixelStorei(I.UNPACK_SKIP_IMAGES,C),a===0&&t.generateMipmaps===!0&&t.mipmapsAutoUpdate===!0&&I.generateMipmap(v),R.unbindTexture()},this.initRenderTarget=function(e){z.get(e).__webglFramebuffer===void 0&&B.setupRenderTarget(e)},this.initTexture=function(e){e.isCubeTexture?B.setTextureCube(e,0):e.isData3DTexture?B.setTexture3D(e,0):e.isDataArrayTexture||e.isCompressedArrayTexture?B.setTexture2DArray(e,0):B.setTexture2D(e,0),R.unbindTexture()},this.resetState=function(){j=0,M=0,N=null,R.reset(),Ve.reset()},typeof __THREE_DEVTOOLS__<`u`&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent(`observe`,{detail:this}))}get coordinateSystem(){return gd}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=q._getDrawingBufferColorSpace(e),t.unpackColorSpace=q._getUnpackColorSpace()}},ib=.92,ab=.68,ob=.98;function sb(e,t,n,r,i,a){let o=e.getCenter(new G),s=new G(0,1,0).cross(t).normalize(),c=t.clone().cross(s),l=Math.tan(n*Math.PI/360),u=i;for(let n=0;n<8;n++){let i=new G(n&1?e.max.x:e.min.x,n&2?e.max.y:e.min.y,n&4?e.max.z:e.min.z).sub(o),[a,d,f]=[Math.abs(i.dot(s)),i.dot(c),i.dot(t)];u=Math.max(u,a/(ob*l*r)+f,(d/l+ib*f)/.79,(ab*f-d/l)/.81)}u=Math.min(u,a);let d=o.addScaledVector(c,-.13*l*u);return{target:d,position:d.clone().addScaledVector(t,u)}}var cb={type:`change`},lb={type:`start`},ub={type:`end`},db=new dm,fb=new im,pb=Math.cos(70*ef.DEG2RAD),mb=new G,hb=2*Math.PI,Q={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},gb=1e-6,_b=class extends Gg{constructor(e,t=null){super(e,t),this.state=Q.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:`ArrowLeft`,UP:`ArrowUp`,RIGHT:`ArrowRight`,BOTTOM:`ArrowDown`},this.mouseButtons={LEFT:zl.ROTATE,MIDDLE:zl.DOLLY,RIGHT:zl.PAN},this.touches={ONE:Bl.ROTATE,TWO:Bl.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle=`auto`,this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new tf,this._lastTargetPosition=new G,this._quat=new tf().setFromUnitVectors(e.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ig,this._sphericalDelta=new Ig,this._scale=1,this._panOffset=new G,this._rotateStart=new W,this._rotateEnd=new W,this._rotateDelta=new W,this._panStart=new W,this._panEnd=new W,this._panDelta=new W,this._dollyStart=new W,this._dollyEnd=new W,this._dollyDelta=new W,this._dollyDirection=new G,this._mouse=new W,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=yb.bind(this),this._onPointerDown=vb.bind(this),this._onPointerUp=bb.bind(this),this._onContextMenu=Db.bind(this),this._onMouseWheel=Cb.bind(this),this._onKeyDown=wb.bind(this),this._onTouchStart=Tb.bind(this),this._onTouchMove=Eb.bind(this),this._onMouseDown=xb.bind(this),this._onMouseMove=Sb.bind(this),this._interceptControlDown=Ob.bind(this),this._interceptControlUp=kb.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e===`grab`?this.domElement.style.cursor=`grab`:this.domElement.style.cursor=`auto`}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener(`pointerdown`,this._onPointerDown),this.domElement.addEventListener(`pointercancel`,this._onPointerUp),this.domElement.addEventListener(`contextmenu`,this._onContextMenu),this.domElement.addEventListener(`wheel`,this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener(`keydown`,this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction=`none`}disconnect(){this.state=Q.NONE,this.domElement.removeEventListener(`pointerdown`,this._onPointerDown),this.domElement.ownerDocument.removeEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.removeEventListener(`pointerup`,this._onPointerUp),this.domElement.removeEventListener(`pointercancel`,this._onPointerUp),this.domElement.removeEventListener(`wheel`,this._onMouseWheel),this.domElement.removeEventListener(`contextmenu`,this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener(`keydown`,this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener(`keyup`,this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction=``,this.domElement.style.cursor=`auto`}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener(`keydown`,this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener(`keydown`,this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(cb),this.update(),this.state=Q.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;mb.copy(t).sub(this.target),mb.applyQuaternion(this._quat),this._spherical.setFromVector3(mb),this.autoRotate&&this.state===Q.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(n)&&isFinite(r)&&(n<-Math.PI?n+=hb:n>Math.PI&&(n-=hb),r<-Math.PI?r+=hb:r>Math.PI&&(r-=hb),n<=r?this._spherical.theta=Math.max(n,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+r)/2?Math.max(n,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let i=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let e=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),i=e!=this._spherical.radius}if(mb.setFromSpherical(this._spherical),mb.applyQuaternion(this._quatInverse),t.copy(this.target).add(mb),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let e=null;if(this.object.isPerspectiveCamera){let t=mb.length();e=this._clampDistance(t*this._scale);let n=t-e;this.object.position.addScaledVector(this._dollyDirection,n),this.object.updateMatrixWorld(),i=!!n}else if(this.object.isOrthographicCamera){let t=new G(this._mouse.x,this._mouse.y,0);t.unproject(this.object);let n=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),i=n!==this.object.zoom;let r=new G(this._mouse.x,this._mouse.y,0);r.unproject(this.object),this.object.position.sub(r).add(t),this.object.updateMatrixWorld(),e=mb.length()}else console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled.`),this.zoomToCursor=!1;e!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(e).add(this.object.position):(db.origin.copy(this.object.position),db.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(db.direction))<pb?this.object.lookAt(this.target):(fb.setFromNormalAndCoplanarPoint(this.object.up,this.target),db.intersectPlane(fb,this.target))))}else if(this.object.isOrthographicCamera){let e=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),e!==this.object.zoom&&(this.object.updateProjectionMatrix(),i=!0)}return this._scale=1,this._performCursorZoom=!1,i||this._lastPosition.distanceToSquared(this.object.position)>gb||8*(1-this._lastQuaternion.dot(this.object.quaternion))>gb||this._lastTargetPosition.distanceToSquared(this.target)>gb?(this.dispatchEvent(cb),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e===null?hb/60/60*this.autoRotateSpeed:hb/60*this.autoRotateSpeed*e}_getZoomScale(e){let t=Math.abs(e*.01);return .95**(this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){mb.setFromMatrixColumn(t,0),mb.multiplyScalar(-e),this._panOffset.add(mb)}_panUp(e,t){this.screenSpacePanning===!0?mb.setFromMatrixColumn(t,1):(mb.setFromMatrixColumn(t,0),mb.crossVectors(this.object.up,mb)),mb.multiplyScalar(e),this._panOffset.add(mb)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;mb.copy(r).sub(this.target);let i=mb.length();i*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*i/n.clientHeight,this.object.matrix),this._panUp(2*t*i/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - pan disabled.`),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled.`),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn(`WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled.`),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),r=e-n.left,i=t-n.top,a=n.width,o=n.height;this._mouse.x=r/a*2-1,this._mouse.y=-(i/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hb*this._rotateDelta.x/t.clientHeight),this._rotateUp(hb*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(hb*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-hb*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(hb*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-hb*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateStart.set(n,r)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panStart.set(n,r)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,i=Math.sqrt(n*n+r*r);this._dollyStart.set(0,i)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateEnd.set(n,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(hb*this._rotateDelta.x/t.clientHeight),this._rotateUp(hb*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panEnd.set(n,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,r=e.pageY-t.y,i=Math.sqrt(n*n+r*r);this._dollyEnd.set(0,i),this._dollyDelta.set(0,(this._dollyEnd.y/this._dollyStart.y)**+this.zoomSpeed),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new W,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function vb(e){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(e.pointerId),this.domElement.ownerDocument.addEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.addEventListener(`pointerup`,this._onPointerUp)),this._isTrackingPointer(e)||(this._addPointer(e),e.pointerType===`touch`?this._onTouchStart(e):this._onMouseDown(e),this._cursorStyle===`grab`&&(this.domElement.style.cursor=`grabbing`)))}function yb(e){this.enabled!==!1&&(e.pointerType===`touch`?this._onTouchMove(e):this._onMouseMove(e))}function bb(e){switch(this._removePointer(e),this._pointers.length){case 0:this.domElement.releasePointerCapture(e.pointerId),this.domElement.ownerDocument.removeEventListener(`pointermove`,this._onPointerMove),this.domElement.ownerDocument.removeEventListener(`pointerup`,this._onPointerUp),this.dispatchEvent(ub),this.state=Q.NONE,this._cursorStyle===`grab`&&(this.domElement.style.cursor=`grab`);break;case 1:let t=this._pointers[0],n=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:n.x,pageY:n.y})}}function xb(e){let t;switch(e.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case zl.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(e),this.state=Q.DOLLY;break;case zl.ROTATE:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=Q.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=Q.ROTATE}break;case zl.PAN:if(e.ctrlKey||e.metaKey||e.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(e),this.state=Q.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(e),this.state=Q.PAN}break;default:this.state=Q.NONE}this.state!==Q.NONE&&this.dispatchEvent(lb)}function Sb(e){switch(this.state){case Q.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(e);break;case Q.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(e);break;case Q.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(e)}}function Cb(e){this.enabled!==!1&&this.enableZoom!==!1&&this.state===Q.NONE&&(e.preventDefault(),this.dispatchEvent(lb),this._handleMouseWheel(this._customWheelEvent(e)),this.dispatchEvent(ub))}function wb(e){this.enabled!==!1&&this._handleKeyDown(e)}function Tb(e){switch(this._trackPointer(e),this._pointers.length){case 1:switch(this.touches.ONE){case Bl.ROTATE:if(this.enableRotate===!1){this.state=Q.NONE;break}this._handleTouchStartRotate(e),this.state=Q.TOUCH_ROTATE;break;case Bl.PAN:if(this.enablePan===!1){this.state=Q.NONE;break}this._handleTouchStartPan(e),this.state=Q.TOUCH_PAN;break;default:this.state=Q.NONE}break;case 2:switch(this.touches.TWO){case Bl.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(e),this.state=Q.TOUCH_DOLLY_PAN;break;case Bl.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(e),this.state=Q.TOUCH_DOLLY_ROTATE;break;default:this.state=Q.NONE}break;default:this.state=Q.NONE}this.state!==Q.NONE&&this.dispatchEvent(lb)}function Eb(e){switch(this._trackPointer(e),this.state){case Q.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(e),this.update();break;case Q.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(e),this.update();break;case Q.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(e),this.update();break;case Q.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(e),this.update();break;default:this.state=Q.NONE}}function Db(e){this.enabled!==!1&&e.preventDefault()}function Ob(e){e.key===`Control`&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener(`keyup`,this._interceptControlUp,{passive:!0,capture:!0}))}function kb(e){e.key===`Control`&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener(`keyup`,this._interceptControlUp,{passive:!0,capture:!0}))}var Ab=.3,jb=2,Mb=.32,Nb=9,Pb=95,Fb=new G(13,9,18).normalize(),Ib=class{camera=new fg(55,1,.1,500);controls;approaching={distance:0,remainingS:0};constructor(e){this.camera.position.set(13,10,17),this.controls=new _b(this.camera,e),this.controls.target.set(0,1,-1),this.controls.maxPolarAngle=Math.PI*.495,this.controls.enableDamping=!0,this.controls.dampingFactor=.12,this.controls.maxDistance=160,this.controls.minDistance=1}frame(e){if(e.isEmpty())return;let{position:t,target:n}=sb(e,Fb,this.camera.fov,this.camera.aspect,Nb,Pb);this.camera.position.copy(t),this.controls.target.copy(n)}startApproach(e){this.approaching={distance:e,remainingS:jb}}follow(e,t,n){let r=this.controls.target,i=new G(e[0],e[1]+Ab,e[2]).sub(r);if(r.add(i),this.camera.position.add(i),this.approaching.remainingS>0&&this.approach(n),t===void 0)return;let a=this.camera.position.clone().sub(r),o=Math.atan2(a.x,a.z),s=Math.atan2(Math.sin(t-o),Math.cos(t-o));a.applyAxisAngle(new G(0,1,0),s*(1-Math.exp(-3*n))),this.camera.position.copy(r).add(a)}approach(e){this.approaching.remainingS-=e;let t=new Ig().setFromVector3(this.camera.position.clone().sub(this.controls.target)),n=1-Math.exp(-4*e);t.radius+=n*(this.approaching.distance-t.radius),t.phi+=n*(Math.PI/2-Mb-t.phi),this.camera.position.copy(this.controls.target).add(new G().setFromSpherical(t))}renderWithin(e,t){let{position:n}=this.camera,{target:r}=this.controls,i=n.clone(),a=i.distanceTo(r);e<a&&n.lerpVectors(r,i,e/a),t(),n.copy(i)}resize(e,t){this.camera.aspect=e/Math.max(1,t),this.camera.updateProjectionMatrix()}ray(e,t,n,r){let i=new Ng;return i.setFromCamera(new W(e/n*2-1,1-t/r*2),this.camera),i}},Lb=8,Rb=260,zb=112,Bb=.22;function Vb({level:e,waves:t},n,r){return t.reduce((e,t)=>e+t.amplitude*Math.cos(t.number*(t.x*n+t.z*r)+t.phase),e)}var Hb=`
uniform float level;
uniform vec2 center;
uniform int count;
uniform vec2 waves[${Lb}];  // amplitude, phase
uniform vec2 waveVectors[${Lb}];   // number times direction
varying vec3 vPosition;
varying float vCrest;
#include <fog_pars_vertex>
void main() {
  vec2 at = center + position.xz;
  float lift = 0.0;
  for (int i = 0; i < ${Lb}; i++)
    if (i < count) lift += waves[i].x * cos(dot(waveVectors[i], at) + waves[i].y);
  vCrest = lift;
  vPosition = vec3(at.x, level + lift, at.y);
  vec4 mvPosition = viewMatrix * vec4(vPosition, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  #include <fog_vertex>
}`,Ub=`
uniform int count;
uniform vec2 waves[${Lb}];
uniform vec2 waveVectors[${Lb}];
uniform float highest;
uniform vec3 sun;
varying vec3 vPosition;
varying float vCrest;
#include <common>
#include <fog_pars_fragment>
void main() {
  vec2 slope = vec2(0.0);
  for (int i = 0; i < ${Lb}; i++)
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
}`,Wb=class{scene;sheets=[];used=0;surfaces=[];constructor(e){this.scene=e}begin(){this.used=0,this.surfaces.length=0}add(e,t){this.surfaces.push(e);let n=this.sheets[this.used++]??=this.make();n.visible=!0;let{uniforms:r}=n.material;r.level.value=e.level,r.center.value.set(t.x,t.z),r.count.value=Math.min(Lb,e.waves.length),r.highest.value=e.waves.reduce((e,t)=>e+t.amplitude,0),e.waves.slice(0,Lb).forEach((e,t)=>{r.waves.value[t].set(e.amplitude,e.phase),r.waveVectors.value[t].set(e.number*e.x,e.number*e.z)})}end(){for(let e=this.used;e<this.sheets.length;e++)this.sheets[e].visible=!1}make(){let e=()=>Array.from({length:Lb},()=>new W),t=new Oh({vertexShader:Hb,fragmentShader:Ub,uniforms:Th.merge([Z.fog,{level:{value:0},center:{value:new W},count:{value:0},highest:{value:0},waves:{value:e()},waveVectors:{value:e()},sun:{value:new G(18,30,12).normalize()}}]),transparent:!0,depthWrite:!1,side:2,fog:!0}),n=new wm(Gb(),t);return n.frustumCulled=!1,this.scene.add(n),n}};function Gb(){let e=new vh(2,2,zb,zb).rotateX(-Math.PI/2),t=e.getAttribute(`position`),n=e=>Rb*(Bb*e+.78*e**3);for(let e=0;e<t.count;e++)t.setXYZ(e,n(t.getX(e)),0,n(t.getZ(e)));return e}function Kb({connection:e,view:t,moduleView:r,camera:i,driving:a,statsPanel:o,recording:s,prediction:c,controllableEntities:l}){Object.defineProperty(window,"jostle",{value:{get state(){return e.state},get tick(){return e.frames.newest?.frame??0},get entityCount(){return e.frames.newest?.entities.length??0},get snapshots(){return e.snapshots},get clientId(){return e.welcome?.clientId??0},get resumed(){return e.resumed},get decodeErrors(){return e.decodeErrors},get stats(){return o.latest},get inputTick(){return e.inputClock.ready?e.inputClock.tick(n()):0},get recording(){let e=s();return e&&{tick:e.tick,seconds:e.seconds,length:e.length,playing:e.playing}},get prediction(){let e=c();return e&&{followed:e.followed,sent:e.sent,late:e.late,...e.stats}},get controlledEntity(){return a.entity},controllableEntities:l,dynamicBodies:()=>[...e.entities.values()].filter(e=>e.mass>0).map(e=>e.id),entityName:t=>e.entities.get(t)?.name,poseOf:e=>{let n=t.poseOf(e);return n?[...n]:void 0},screenPosition:e=>{let n=t.poseOf(e);if(!n)return;let r=new G(n[0],n[1],n[2]).project(i.camera);return{x:(r.x+1)/2*innerWidth,y:(1-r.y)/2*innerHeight}},partCounts:()=>t.partCounts(),moduleLineCount:()=>r.lines.count/2,moduleSolidCount:()=>r.solids.count,moduleSolidMatrix:(e,t)=>[...r.solids.matrixOf(e,t).elements],waterHeights:(e,t)=>r.water.surfaces.map(n=>Vb(n,e,t))}})}var qb={right:0,forward:1,up:2,yaw:3},Jb=4,Yb=1e3,Xb=1e3,Zb=.15,Qb={KeyW:[qb.forward,1],ArrowUp:[qb.forward,1],KeyS:[qb.forward,-1],ArrowDown:[qb.forward,-1],KeyD:[qb.right,1],ArrowRight:[qb.right,1],KeyA:[qb.right,-1],ArrowLeft:[qb.right,-1]},$b=[{code:`Space`,pad:0,bit:0},{code:`ShiftLeft`,pad:1,bit:1},{code:`KeyE`,pad:5,bit:2},{code:`KeyQ`,pad:4,bit:3}];function ex(e){return e===void 0||Math.abs(e)<Zb?0:e}function tx(e,t,n){let r=Array(Jb).fill(0);for(let t of e){let e=Qb[t];e&&(r[e[0]]=r[e[0]]+e[1])}let i=0;for(let{code:t,bit:n}of $b)e.has(t)&&(i|=1<<n);if(t){r[qb.right]=r[qb.right]+ex(t.axes[0]),r[qb.forward]=r[qb.forward]-ex(t.axes[1])+(t.buttons[7]?.value??0)-(t.buttons[6]?.value??0);for(let{pad:e,bit:n}of $b)t.buttons[e]?.pressed&&(i|=1<<n)}return r[qb.yaw]=n,{axes:r.map(e=>Math.round(Math.min(1,Math.max(-1,e))*Yb)+0),buttons:i}}function nx(e){return Math.atan2(-e.x,-e.z)/Math.PI}var rx=class{send;entity=0;keys=new Set;lastSent;lastSentAt=0;constructor(e){this.send=e}takeControl(e){this.entity=e,this.lastSent=void 0,this.keys.clear(),this.send({kind:{case:`possess`,value:{entity:e}}})}stopControlling(){this.entity!==0&&this.takeControl(0)}reset(){this.entity=0,this.keys.clear()}keyDown(e){return this.entity===0||!(e in Qb||$b.some(t=>t.code===e))?!1:(this.keys.add(e),!0)}keyUp(e){this.keys.delete(e)}blur(){this.keys.clear()}update(e,t,n){if(this.entity===0)return;let r=tx(this.keys,e,t);this.lastSent?.buttons===r.buttons&&this.lastSent.axes.every((e,t)=>e===r.axes[t])&&n-this.lastSentAt<Xb||(this.lastSent=r,this.lastSentAt=n,this.send({kind:{case:`control`,value:r}}))}},ix=500;function ax(e,t){for(let n of t.intersectObjects(e.objects,!1)){if(n.instanceId===void 0)continue;let{entity:r,shape:i}=e.ownerAt(n.object,n.instanceId);if(r===0)continue;let a=n.face?.normal.clone()??new G(0,1,0),o=new J;return n.object.getMatrixAt(n.instanceId,o),a.applyNormalMatrix(new K().getNormalMatrix(o)).normalize(),a.dot(t.ray.direction)>0&&a.negate(),{entity:r,shape:i,point:n.point,normal:a,distance:n.distance}}}var ox=1.2,sx=.25;function cx(e,t,n,r){let i=n.clone().sub(t),a=new Ng(t,i.clone().normalize(),0,i.length());for(let t of a.intersectObjects(e.objects,!1)){if(t.instanceId===void 0)continue;let{entity:n}=e.ownerAt(t.object,t.instanceId);if(n!==0&&n!==r&&!e.dynamicPoseOf(n))return Math.max(ox,t.distance-sx)}return 1/0}function lx(e,t,n){return ax(e,new Ng(new G(t,ix,n),new G(0,-1,0),0,2*ix))?.point.y}async function ux(e,{origin:t,direction:n},r){let i=n.clone().multiplyScalar(ix),a=({x:e,y:t,z:n})=>({x:e,y:t,z:n}),o=await e.castRays({rays:[{origin:a(t),motion:a(i)}],viewTime:r});if(!o)return;let s=o.rays[0]?.hits[0];if(!s)return{hit:void 0};let{entity:c,shape:l,fraction:u}=s;return{hit:{entity:c,shape:l,point:new G(s.point?.x,s.point?.y,s.point?.z),normal:new G(s.normal?.x,s.normal?.y,s.normal?.z),distance:u*ix}}}function dx(e,t,n){return!t||e&&e.entity!==t.hit?.entity&&n(e.entity)?e:t.hit}var fx=class{intervalMs;run;due=!1;running=!1;last=-1/0;timer;constructor(e,t){this.intervalMs=e,this.run=t}request(){this.due=!0,this.next()}next(){if(!this.due||this.running||this.timer!==void 0)return;let e=this.last+this.intervalMs-performance.now();if(e>0){this.timer=setTimeout(()=>{this.timer=void 0,this.next()},e);return}this.due=!1,this.running=!0,this.last=performance.now();let t=()=>{this.running=!1,this.next()};this.run().then(t,e=>{console.error(e),t()})}},px=[{tool:`drag`,key:`1`,label:`Drag`,hint:`Drag a body; drag the ground to turn the camera`},{tool:`throw`,key:`2`,label:`Throw`,hint:`Click to throw a ball from the camera`},{tool:`box`,key:`3`,label:`Box`,hint:`Click to place a box`},{tool:`sphere`,key:`4`,label:`Ball`,hint:`Click to place a ball`},{tool:`capsule`,key:`5`,label:`Capsule`,hint:`Click to place a capsule`},{tool:`explode`,key:`6`,label:`Explode`,hint:`Click to trigger an explosion`},{tool:`delete`,key:`7`,label:`Delete`,hint:`Click a body that you spawned to delete it`},{tool:`drive`,key:`8`,label:`Drive`,hint:`Click a controllable entity to drive it; Esc releases it`}],mx=18,hx=6,gx=6,_x=150,vx=100,yx=e=>({x:e.x,y:e.y,z:e.z});function bx(e){return Promise.race([e,new Promise(e=>setTimeout(()=>e(void 0),_x))])}var xx=class{canvas;camera;view;connection;queries;onHover;takeControl;onExplosion;tool=`drag`;enabled=!0;grabbed;pressed;hovering;hover=new fx(vx,()=>this.updateHover());constructor(e,t,n,r,i,a,o,s){this.canvas=e,this.camera=t,this.view=n,this.connection=r,this.queries=i,this.onHover=a,this.takeControl=o,this.onExplosion=s,e.addEventListener(`pointerdown`,e=>this.down(e),{capture:!0}),e.addEventListener(`pointermove`,e=>this.move(e)),e.addEventListener(`pointerup`,e=>this.up(e)),e.addEventListener(`pointercancel`,()=>this.release()),e.addEventListener(`pointerleave`,()=>{this.hovering=void 0,this.onHover(void 0)})}ray(e){let t=this.canvas.getBoundingClientRect();return this.camera.ray(e.clientX-t.left,e.clientY-t.top,t.width,t.height)}send(e){this.connection.send({kind:e})}isDynamic(e){return e!==void 0&&(this.connection.entities.get(e.entity)?.mass??0)>0}isMoving=e=>this.connection.frames.newest?.entities.find(t=>t.id===e)?.atRest===!1;down(e){if(e.button!==0||!this.enabled)return;let{x:t,y:n}={x:e.clientX,y:e.clientY},r=this.ray(e);if(this.tool===`throw`){this.pressed={x:t,y:n,raycaster:r,rendered:void 0,fromServer:Promise.resolve(void 0)};return}let i=ax(this.view,r),a={x:t,y:n,raycaster:r,rendered:i,fromServer:ux(this.queries,r.ray,this.connection.renderedTime())};this.pressed=a,this.tool===`drag`&&(this.isDynamic(i)&&this.grab(i,e.pointerId),a.fromServer.then(t=>this.replacePick(a,dx(i,t,this.isMoving),e.pointerId)))}grab(e,t){this.camera.controls.enabled=!1;let n=this.camera.camera.getWorldDirection(new G);this.grabbed={entity:e.entity,plane:new im().setFromNormalAndCoplanarPoint(n,e.point)},this.canvas.setPointerCapture(t),this.send({case:`grab`,value:{entity:e.entity,point:yx(e.point)}}),this.send({case:`drag`,value:{target:yx(e.point)}})}replacePick(e,t,n){if(this.pressed===e&&this.grabbed?.entity!==t?.entity){if(this.grabbed)this.dropGrab();else if(e.dragged)return;this.isDynamic(t)&&this.grab(t,n)}}move(e){let t=this.pressed;if(t&&Math.hypot(e.clientX-t.x,e.clientY-t.y)>gx&&(t.dragged=!0),!this.grabbed){if(e.buttons!==0)return;this.hovering=e,this.hover.request();return}let n=this.ray(e).ray.intersectPlane(this.grabbed.plane,new G);n&&(n.y=Math.max(.05,n.y),this.send({case:`drag`,value:{target:yx(n)}}))}async updateHover(){let e=this.hovering;if(!e)return;let t=this.ray(e),n=dx(ax(this.view,t),await bx(ux(this.queries,t.ray,this.connection.renderedTime())),this.isMoving);this.hovering&&(this.tool===`drag`&&(this.canvas.style.cursor=this.isDynamic(n)?`grab`:``),this.onHover(n))}up(e){if(this.grabbed)return this.release();let t=this.pressed;this.pressed=void 0,!t||Math.hypot(e.clientX-t.x,e.clientY-t.y)>gx||(this.tool===`throw`?this.throwBall(t.raycaster):this.tool!==`drag`&&this.click(t,this.tool))}release(){this.pressed=void 0,this.grabbed&&this.dropGrab()}dropGrab(){this.grabbed=void 0,this.camera.controls.enabled=!0,this.send({case:`release`,value:{}})}async click(e,t){let n=dx(e.rendered,await bx(e.fromServer),this.isMoving);if(n)switch(t){case`box`:return this.spawn(n,.35,{case:`box`,value:{halfExtents:{x:.35,y:.35,z:.35}}});case`sphere`:return this.spawn(n,.35,{case:`sphere`,value:{radius:.35}});case`capsule`:return this.spawn(n,.6,{case:`capsule`,value:{radius:.22,halfLength:.35}});case`explode`:return this.onExplosion(...n.point.toArray(),hx),this.send({case:`explode`,value:{center:yx(n.point),radius:hx,speed:12}});case`delete`:return this.send({case:`delete`,value:{entity:n.entity}});case`drive`:return this.takeControl(n.entity)}}spawn(e,t,n){let r=e.point.clone().addScaledVector(e.normal,t+.02);this.send({case:`spawn`,value:{shape:{kind:n},position:yx(r)}})}throwBall(e){let{origin:t,direction:n}=e.ray,r=t.clone().addScaledVector(n,1);this.send({case:`spawn`,value:{shape:{kind:{case:`sphere`,value:{radius:.3}}},position:yx(r),linearVelocity:yx(n.clone().multiplyScalar(mx))}})}},Sx=8,Cx=550,wx=.05,Tx=new J,Ex=new Y,Dx=new Y(16754240),Ox=class{ball;marks=Array.from({length:Sx},()=>({at:new G,radius:0,startMs:-1/0}));next=0;active=0;constructor(e){let t={transparent:!0,blending:2,depthWrite:!1,fog:!1,toneMapped:!1};this.ball=new Im(new _h(1,3),new fm(t),Sx),this.ball.instanceMatrix.setUsage(hd),this.ball.instanceColor=new Om(new Float32Array(24),3),this.ball.frustumCulled=!1,this.ball.visible=!1,e.add(this.ball)}add(e,t,n,r,i){if(this.marks.some(({at:r,startMs:a})=>i-a<Cx&&Math.hypot(r.x-e,r.y-t,r.z-n)<wx))return;let a=this.marks[this.next];this.next=(this.next+1)%Sx,a.at.set(e,t,n),a.radius=r,a.startMs=i}get activeCount(){return this.active}update(e){let t=this.active;this.active=0,this.marks.forEach(({at:t,radius:n,startMs:r},i)=>{let a=(e-r)/Cx,o=a>=0&&a<1;o&&this.active++;let s=o?n*(.12+.5*Math.sqrt(a)):0;this.ball.setMatrixAt(i,Tx.makeScale(s,s,s).setPosition(t)),this.ball.setColorAt(i,Ex.copy(Dx).multiplyScalar(o?.5*(1-a)**1.5:0))}),this.ball.visible=this.active>0,(this.active!==0||t!==0)&&(this.ball.instanceMatrix.needsUpdate=!0,this.ball.instanceColor.needsUpdate=!0)}},kx=new DataView(new ArrayBuffer(4)),Ax=class{values;failed=!1;at=0;constructor(e){this.values=e}get left(){return this.values.length-this.at}value(){return this.left>0?this.values[this.at++]:(this.failed=!0,0)}quantized(e,t,n){let r=this.value(),i=2**n-1;return r>=0&&r<=i?e+r/i*(t-e):(this.failed=!0,e)}f32(){kx.setInt32(0,this.value());let e=kx.getFloat32(0);return Number.isFinite(e)?e:(this.failed=!0,0)}},jx=8;function Mx(e){let t=new Ax(e),n=()=>t.quantized(-8,jx,16),r={propeller:[n(),n(),n()],throttle:t.quantized(-1,1,8),rudder:t.quantized(-1,1,8),wet:!!(t.value()&1)};return t.failed||t.left>0?void 0:r}var Nx=new Y(2829619),Px=new Y(14212579),Fx=new Y(15660791),Ix=7,Lx=new G,Rx=new tf,zx=new tf,Bx=new G,Vx=new G,Hx=new G(0,1,0);function Ux(e,t,{solids:n,nowMs:r}){Lx.set(t[0],t[1],t[2]),Rx.set(t[3],t[4],t[5],t[6]),zx.setFromAxisAngle(Hx,-.5*e.rudder).premultiply(Rx);let[i,a,o]=e.propeller,s=(e,t)=>Bx.set(i,a+e,o+.4+t).applyQuaternion(Rx).add(Lx);if(n.add(`box`,s(.45,0),zx,Vx.set(.1,.7,.16),Nx),n.add(`box`,s(1.15,.05),zx,Vx.set(.24,.26,.34),Px),!(!e.wet||Math.abs(e.throttle)<.05))for(let t=0;t<Ix;t++){let s=(r/700+t/Ix)%1,c=.5*Math.sin(5*t)*s,l=.3*Math.abs(e.throttle)*(1-s);Bx.set(i+c,a+.45,o+.7+2.2*s*Math.sign(e.throttle)).applyQuaternion(Rx).add(Lx),n.add(`sphere`,Bx,Rx,Vx.set(l,.5*l,l),Fx)}}var Wx={draw(e,t){for(let{entity:n,values:r}of e){let e=Mx(r),i=t.poseOf(n);e&&i&&Ux(e,i,t)}},steering:{keys:`W forward · S reverse · A D rudder`,camera:`behind`,distance:11,statusText:({values:e})=>Mx(e)?.wet===!1?`propeller out of the water`:``}},Gx=[`on ground`,`sliding`,`airborne`],Kx=1.5;function qx(e){let t=new Ax(e),n=t.value(),r=Gx[n>>2&3];if(!r)return;let i={rigid:!!(n&1),crouched:!!(n&2),ground:r,heading:t.quantized(-Math.PI,Math.PI,8),speed:t.quantized(0,20,8),verticalSpeed:t.quantized(-20,20,8)};return t.failed||t.left>0?void 0:i}var Jx=new Y(1053722),Yx=new Y(2237739),Xx=new Y(15852499),Zx=new Y(5916210),Qx=new G(0,1,0),$x=new tf,eS=new G,tS=new G;function nS(e,t,n,{solids:r,entityOf:i}){let a=i(t)?.shapes[0];if(a?.kind.case!==`capsule`)return;let{radius:o,halfLength:s}=a.kind.value;$x.setFromAxisAngle(Qx,e.heading);let c=n[1]+(a.position?.y??0),l=(e,t,i,a,o,s,l,u)=>{eS.set(t,0,-a).applyQuaternion($x),eS.set(n[0]+eS.x,c+i,n[2]+eS.z),r.add(e,eS,$x,tS.set(o,s,l),u)},u=-n[0]*Math.sin(e.heading)-n[2]*Math.cos(e.heading),d=e.ground===`airborne`?.9:Math.sin(Math.PI*u/Kx)*Math.min(1,e.speed/2);l(`sphere`,0,s+.12*o,.62*o,.62*o,.36*o,.5*o,Jx),l(`box`,0,.35*s,-.95*o,.55*o,.45*s,.3*o,Zx);for(let e of[-1,1])l(`sphere`,e*.5*o,-s-.82*o,e*d*.9*o+.15*o,.36*o,.26*o,.55*o,Yx),l(`sphere`,e*1.12*o,-.05*s,-e*d*.9*o+.2*o,.3*o,.3*o,.3*o,Xx)}var rS={draw(e,t){for(let{entity:n,values:r}of e){let e=qx(r),i=t.poseOf(n);e&&i&&nS(e,n,i,t)}},steering:{keys:`W A S D walk relative to the camera · drag to turn the camera · Space jump · Shift crouch`,camera:`free`,distance:5.5,statusText({values:e}){let t=qx(e);return t?`${t.speed.toFixed(1)} m/s${t.ground===`on ground`?``:` · ${t.ground}`}${t.crouched?` · crouched`:``}`:``}}};function iS({name:e,owner:t}){return e===``&&t===0}function aS(e){let t=new Ax(e),n=[];for(;t.left>0;)n.push({pieces:t.value(),bonds:t.value(),initialBonds:t.value()});return t.failed?void 0:n}var oS=.618034,sS=new Y;function cS(e){let t=e*oS%1;return sS.setHSL(.045+.035*t,.3+.16*(e*oS*7%1),.48+.16*t).getHex()}var lS={bodyColors(e,t){let n=new Map;for(let e of t.values())iS(e)&&e.shapes.length>0&&e.shapes.every(({kind:e})=>e.case===`hull`)&&n.set(e.id,cS(e.id));return n},statusText(e){let t=e.flatMap(({values:e})=>aS(e)??[]);if(t.length===0)return``;let n=e=>t.reduce((t,n)=>t+n[e],0),r=n(`initialBonds`)>0?100*n(`bonds`)/n(`initialBonds`):100;return`${t.length} ${t.length===1?`wall`:`walls`} in ${n(`pieces`)} ${n(`pieces`)===1?`piece`:`pieces`} · ${Math.floor(r)} % of the bonds intact`}},uS=[`central`,`turbulence`,`user`],dS=4,fS=8,pS=64,mS=8,hS=4,gS=3,_S=[1,2,4],vS=e=>[e.f32(),e.f32(),e.f32()];function yS(e,t,n){let r=e.value();(r<0||r>t)&&(e.failed=!0);let i=[];for(;!e.failed&&i.length<r;)i.push(n(e));return i}function bS(e,t,n){let r=[];for(;!e.failed&&e.left>0;)r.length===t?e.failed=!0:r.push(n(e));return r}function xS(e){let t={amplitude:e.f32(),length:e.f32(),heading:e.quantized(0,2*Math.PI,16),phase:e.quantized(0,2*Math.PI,16),omega:e.f32()};return t.length>0||(e.failed=!0),t}function SS(e){return{level:e.f32(),density:e.f32(),waves:yS(e,fS,xS)}}function CS(e){let t=new Ax(e),n=bS(t,dS,SS);return t.failed?void 0:n}function wS(e){let t=uS[e.value()];return t===`central`?{kind:t,point:vS(e)}:t===`turbulence`?{kind:t,wind:vS(e),speed:e.f32()}:(t===void 0&&(e.failed=!0),{kind:`user`})}function TS(e){let t=new Ax(e),n=yS(t,pS,wS),r=bS(t,mS,()=>({point:vS(t),radius:t.f32()}));return t.failed?void 0:{others:n,blasts:r}}function ES({level:e,waves:t},n){return{level:e,waves:t.map(({amplitude:e,length:t,heading:r,phase:i,omega:a})=>({amplitude:e,number:2*Math.PI/t,x:Math.cos(r),z:Math.sin(r),phase:i-a*n}))}}var DS=new Y(10146303),OS=new Y(16752112);function kS(e,{lines:t,cameraTarget:n}){let[r,i,a]=e,o=Math.hypot(r,i,a);if(o===0)return;let s=Math.min(2.5,.4*o)/o,c=e=>e*gS,l=e=>Math.round(e/gS)*gS;for(let e=-4;e<=hS;e++)for(let o=-4;o<=hS;o++){let[u,d,f]=[l(n.x)+c(e),n.y+2.5,l(n.z)+c(o)],[p,m,h]=[u+s*r,d+s*i,f+s*a];t.vertex(u,d,f,DS),t.vertex(p,m,h,DS);for(let e of[-1,1])t.vertex(p,m,h,DS),t.vertex(p-s*(.25*r+e*.12*a),m-.25*s*i,h-s*(.25*a-e*.12*r),DS)}}function AS([e,t,n],{lines:r}){for(let i of _S)for(let a=0;a<32;a++)for(let o of[a,a+1]){let a=2*Math.PI*o/32;r.vertex(e+i*Math.cos(a),t,n+i*Math.sin(a),OS)}}var jS={draw(e,{water:t,cameraTarget:n}){for(let{values:r,seconds:i}of e)for(let e of CS(r)??[])t.add(ES(e,i),n)}},MS={draw(e,t){for(let{values:n}of e){let{others:e,blasts:r}=TS(n)??{others:[],blasts:[]};for(let{point:e,radius:n}of r)t.blasts.add(...e,n,t.nowMs);if(t.debug)for(let n of e)n.kind===`turbulence`&&kS(n.wind,t),n.kind===`central`&&AS(n.point,t)}}},NS=4,PS=2,FS=4,IS=new Y(4029641),LS=new Y(16757575);function RS(e){let t=new Ax(e),n=()=>t.quantized(-2,PS,16),r=Array.from({length:NS},()=>({position:[n(),n(),n()],ray:t.quantized(0,FS,16),thrust:t.quantized(0,1,8)}));return t.failed||t.left>0?void 0:r}var zS=new G,BS=new G,VS=new G,HS=new tf,US=new Y;function WS({entity:e,values:t},{lines:n,poseOf:r}){let i=RS(t),a=r(e);if(i&&a){VS.set(a[0],a[1],a[2]),HS.set(a[3],a[4],a[5],a[6]);for(let{position:e,ray:t,thrust:r}of i){zS.set(...e),BS.copy(zS).setY(zS.y-t),US.lerpColors(IS,LS,r);for(let e of[zS,BS])e.applyQuaternion(HS).add(VS),n.vertex(e.x,e.y,e.z,US)}}}var GS={draw(e,t){for(let n of e)WS(n,t)},steering:{keys:`W S forward and back · A D turn`,camera:`behind`,distance:9}},KS=[`limp`,`powered`,`kinematic`],qS=64,JS=11,YS=2,XS=[1,3,4],ZS=[YS,5,6],QS=[15087942,1931380,16032353,4553629,8599788,2792847,16758531,13936037,5800279,12348453],$S=[2829634,3427905,6180927,4014171],eC=[15912359,14262374,9263675,15250570];function tC(e){return e.length===1?KS[e[0]]:void 0}var nC=e=>e.filter(({values:e})=>tC(e)).map(({entity:e})=>e);function rC(e,t){let n=new Set(e);return e.map(e=>{let r=[];for(let i=e;r.length<qS&&(i===e||!n.has(i));i++){let e=t.get(i);if(!e||!iS(e)||e.shapes[0]?.kind.case!==`capsule`)break;r.push(i)}return r})}var iC=new G,aC=new tf,oC=new G,sC=new G,cC=new Y(1447965),lC=new Y(3877408),uC={draw(e,{solids:t,poseOf:n,entityOf:r}){for(let i of nC(e)){let e=i+YS,a=r(e)?.shapes[0],o=n(e);if(!o||a?.kind.case!==`capsule`||!dC(i,r))continue;let{radius:s,halfLength:c}=a.kind.value;iC.set(o[0],o[1],o[2]),aC.set(o[3],o[4],o[5],o[6]);let l=(e,n,r,i,a,o,s)=>{oC.set(e,n,r).applyQuaternion(aC).add(iC),t.add(`sphere`,oC,aC,sC.set(i,a,o),s)};for(let e of[-1,1])l(e*.38*s,.4*c,.88*s,.15*s,.18*s,.15*s,cC);l(0,c+.25*s,-.16*s,1.02*s,.88*s,1*s,lC)}},bodyColors(e,t){let n=new Map;return rC(nC(e),t).forEach((e,t)=>{let r=QS[t%QS.length],i=$S[t%$S.length],a=eC[t%eC.length],o=e.length===JS;e.forEach((e,t)=>{let s=!o||XS.includes(t)?r:ZS.includes(t)?a:i;n.set(e,s)})}),n}};function dC(e,t){for(let n=0;n<JS;n++){let r=t(e+n);if(!r||!iS(r)||r.shapes[0]?.kind.case!==`capsule`)return!1}return!0}var fC=8,pC=new Y(1381914),mC=new Y(8003374),hC=new Y(13225686),gC=new Y(3817290);function _C(e){let t=e.quantized(0,2,8),n=e.quantized(0,1,8),r=()=>e.quantized(-8,fC,16),i=[r(),r(),r()],a=e.value();return{radius:t,width:n,center:i,touches:!!(a&1),slides:!!(a&2),angle:e.quantized(0,2*Math.PI,16),spin:e.quantized(-400,400,16),steering:e.quantized(-Math.PI/2,Math.PI/2,16)}}function vC(e){let t=new Ax(e),n={gear:t.value(),engine:t.quantized(0,1,8),wheels:[]};for(;t.left>0&&!t.failed;)n.wheels.push(_C(t));return t.failed?void 0:n}var yC=new G,bC=new tf,xC=new G,SC=new tf,CC=new tf,wC=new G,TC=new G(1,0,0),EC=new G(0,1,0),DC=new tf().setFromAxisAngle(new G(0,0,1),-Math.PI/2);function OC(e,t,{solids:n}){xC.set(...e.center).applyQuaternion(bC).add(yC),SC.copy(bC),SC.multiply(CC.setFromAxisAngle(EC,-e.steering)),SC.multiply(CC.setFromAxisAngle(TC,-(e.angle+e.spin*t)));let r=.5*e.width,i=CC.copy(SC).multiply(DC);n.add(`cylinder`,xC,i,wC.set(e.radius,r,e.radius),e.slides?mC:pC),n.add(`cylinder`,xC,i,wC.set(.64*e.radius,1.03*r,.64*e.radius),hC),n.add(`box`,xC,SC,wC.set(1.08*r,.6*e.radius,.09*e.radius),gC),n.add(`box`,xC,SC,wC.set(1.08*r,.09*e.radius,.6*e.radius),gC)}function kC({wheels:e}){return e.length===0?0:e.reduce((e,{spin:t,radius:n})=>e+t*n,0)/e.length}var AC={draw(e,t){for(let{entity:n,values:r,seconds:i}of e){let e=vC(r),a=t.poseOf(n);if(e&&a){yC.set(a[0],a[1],a[2]),bC.set(a[3],a[4],a[5],a[6]);for(let n of e.wheels)OC(n,i,t)}}},steering:{keys:`W throttle · S brake, then reverse · A D steer · Space hand brake · E Q shift gears (manual gearbox)`,camera:`behind`,distance:8,statusText({values:e}){let t=vC(e);if(!t)return``;let n=t.gear<0?`reverse`:t.gear===0?`neutral`:`gear ${t.gear}`;return`${Math.abs(3.6*kC(t)).toFixed(0)} km/h · ${n}`}}},jC=new J().makeScale(0,0,0),MC=class{scene;kind;castShadow;mesh;entities;shapes;free=[];used=0;matricesChanged=!1;colorsChanged=!1;constructor(e,t,n,r,i,a=64){this.scene=e,this.kind=t,this.castShadow=i,this.entities=new Uint32Array(a),this.shapes=new Uint32Array(a),this.mesh=this.makeMesh(n,r,a)}makeMesh(e,t,n){let r=new Im(e,t,n);return r.instanceMatrix.setUsage(hd),r.instanceColor=new Om(new Float32Array(n*3).fill(1),3),r.castShadow=this.castShadow,r.receiveShadow=!0,r.frustumCulled=!1,r.count=0,r.userData.instances=this,this.scene.add(r),r}get size(){return this.used}acquire(e,t=0){let n=this.free.pop()??this.mesh.count;return n===this.mesh.instanceMatrix.count&&this.grow(),n===this.mesh.count&&this.mesh.count++,this.used++,this.entities[n]=e,this.shapes[n]=t,this.setMatrix(n,jC),n}release(e){this.setMatrix(e,jC),this.entities[e]=0,this.used--,this.free.push(e),this.used>0||(this.free=[],this.mesh.count=0)}entityAt(e){return this.entities[e]??0}shapeAt(e){return this.shapes[e]??0}setMatrix(e,t){t.toArray(this.mesh.instanceMatrix.array,e*16),this.matricesChanged=!0}setColor(e,t){t.toArray(this.mesh.instanceColor.array,e*3),this.colorsChanged=!0}colorAt(e){return new Y().fromArray(this.mesh.instanceColor.array,e*3)}upload(){this.matricesChanged&&(this.mesh.instanceMatrix.needsUpdate=!0,this.mesh.boundingSphere=null),this.colorsChanged&&(this.mesh.instanceColor.needsUpdate=!0),this.matricesChanged=this.colorsChanged=!1}dispose(){this.scene.remove(this.mesh),this.mesh.geometry.dispose(),this.mesh.dispose()}grow(){let e=this.mesh,t=e.instanceMatrix.count*2;this.scene.remove(e),this.mesh=this.makeMesh(e.geometry,e.material,t),this.mesh.count=e.count,this.mesh.instanceMatrix.array.set(e.instanceMatrix.array),this.mesh.instanceColor.array.set(e.instanceColor.array),this.entities=NC(this.entities,t),this.shapes=NC(this.shapes,t),this.matricesChanged=this.colorsChanged=!0,e.dispose()}};function NC(e,t){let n=new Uint32Array(t);return n.set(e),n}var PC=new Uint32Array(2),FC=new Float64Array(PC.buffer),IC=new WeakMap;function LC(e,t){let n=IC.get(e);return n===void 0&&IC.set(e,n=t()),n}function RC(e,...t){let n=2166136261,r=2654435769,i=0,a=e=>{n=Math.imul(n^e,16777619),n^=n>>>15,r=Math.imul(r^e,2246822507),r^=r>>>13};for(let e of t){for(let t of e)FC[0]=t,a(PC[0]),a(PC[1]),i++;a(44)}let o=e=>(e>>>0).toString(16).padStart(8,`0`);return`${e}:${i}:${o(n)}${o(r)}`}var zC=0,BC=1,VC=new G,HC=new Wg,UC=new im,WC=new G,GC=new bp,KC=class{constructor(){this.tolerance=-1,this.faces=[],this.newFaces=[],this.assigned=new XC,this.unassigned=new XC,this.vertices=[]}setFromPoints(e){if(e.length>=4){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.vertices.push(new YC(e[t]));this._compute()}return this}setFromObject(e){let t=[];return e.updateMatrixWorld(!0),e.traverse(function(e){let n=e.geometry;if(n!==void 0){let r=n.attributes.position;if(r!==void 0)for(let n=0,i=r.count;n<i;n++){let i=new G;i.fromBufferAttribute(r,n).applyMatrix4(e.matrixWorld),t.push(i)}}}),this.setFromPoints(t)}containsPoint(e){let t=this.faces;for(let n=0,r=t.length;n<r;n++)if(t[n].distanceToPoint(e)>this.tolerance)return!1;return!0}intersectRay(e,t){let n=this.faces,r=-1/0,i=1/0;for(let t=0,a=n.length;t<a;t++){let a=n[t],o=a.distanceToPoint(e.origin),s=a.normal.dot(e.direction);if(o>0&&s>=0)return null;let c=s===0?0:-o/s;if(!(c<=0)&&(s>0?i=Math.min(c,i):r=Math.max(c,r),r>i))return null}return r===-1/0?e.at(i,t):e.at(r,t),t}intersectsRay(e){return this.intersectRay(e,VC)!==null}makeEmpty(){return this.faces=[],this.vertices=[],this}_addVertexToFace(e,t){return e.face=t,t.outside===null?this.assigned.append(e):this.assigned.insertBefore(t.outside,e),t.outside=e,this}_removeVertexFromFace(e,t){return e===t.outside&&(t.outside=e.next!==null&&e.next.face===t?e.next:null),this.assigned.remove(e),this}_removeAllVerticesFromFace(e){if(e.outside!==null){let t=e.outside,n=e.outside;for(;n.next!==null&&n.next.face===e;)n=n.next;return this.assigned.removeSubList(t,n),t.prev=n.next=null,e.outside=null,t}}_deleteFaceVertices(e,t){let n=this._removeAllVerticesFromFace(e);if(n!==void 0){if(t===void 0)this.unassigned.appendChain(n);else{let e=n;do{let n=e.next;t.distanceToPoint(e.point)>this.tolerance?this._addVertexToFace(e,t):this.unassigned.append(e),e=n}while(e!==null)}}return this}_resolveUnassignedPoints(e){if(this.unassigned.isEmpty()===!1){let t=this.unassigned.first();do{let n=t.next,r=this.tolerance,i=null;for(let n=0;n<e.length;n++){let a=e[n];if(a.mark===zC){let e=a.distanceToPoint(t.point);if(e>r&&(r=e,i=a),r>1e3*this.tolerance)break}}i!==null&&this._addVertexToFace(t,i),t=n}while(t!==null)}return this}_computeExtremes(){let e=new G,t=new G,n=[],r=[];for(let e=0;e<3;e++)n[e]=r[e]=this.vertices[0];e.copy(this.vertices[0].point),t.copy(this.vertices[0].point);for(let i=0,a=this.vertices.length;i<a;i++){let a=this.vertices[i],o=a.point;for(let t=0;t<3;t++)o.getComponent(t)<e.getComponent(t)&&(e.setComponent(t,o.getComponent(t)),n[t]=a);for(let e=0;e<3;e++)o.getComponent(e)>t.getComponent(e)&&(t.setComponent(e,o.getComponent(e)),r[e]=a)}return this.tolerance=3*2**-52*(Math.max(Math.abs(e.x),Math.abs(t.x))+Math.max(Math.abs(e.y),Math.abs(t.y))+Math.max(Math.abs(e.z),Math.abs(t.z))),{min:n,max:r}}_computeInitialHull(){let e=this.vertices,t=this._computeExtremes(),n=t.min,r=t.max,i=0,a=0;for(let e=0;e<3;e++){let t=r[e].point.getComponent(e)-n[e].point.getComponent(e);t>i&&(i=t,a=e)}let o=n[a],s=r[a],c,l;i=0,HC.set(o.point,s.point);for(let t=0,n=this.vertices.length;t<n;t++){let n=e[t];if(n!==o&&n!==s){HC.closestPointToPoint(n.point,!0,WC);let e=WC.distanceToSquared(n.point);e>i&&(i=e,c=n)}}i=-1,UC.setFromCoplanarPoints(o.point,s.point,c.point);for(let t=0,n=this.vertices.length;t<n;t++){let n=e[t];if(n!==o&&n!==s&&n!==c){let e=Math.abs(UC.distanceToPoint(n.point));e>i&&(i=e,l=n)}}let u=[];if(UC.distanceToPoint(l.point)<0){u.push(qC.create(o,s,c),qC.create(l,s,o),qC.create(l,c,s),qC.create(l,o,c));for(let e=0;e<3;e++){let t=(e+1)%3;u[e+1].getEdge(2).setTwin(u[0].getEdge(t)),u[e+1].getEdge(1).setTwin(u[t+1].getEdge(0))}}else{u.push(qC.create(o,c,s),qC.create(l,o,s),qC.create(l,s,c),qC.create(l,c,o));for(let e=0;e<3;e++){let t=(e+1)%3;u[e+1].getEdge(2).setTwin(u[0].getEdge((3-e)%3)),u[e+1].getEdge(0).setTwin(u[t+1].getEdge(1))}}for(let e=0;e<4;e++)this.faces.push(u[e]);for(let t=0,n=e.length;t<n;t++){let n=e[t];if(n!==o&&n!==s&&n!==c&&n!==l){i=this.tolerance;let e=null;for(let t=0;t<4;t++){let r=this.faces[t].distanceToPoint(n.point);r>i&&(i=r,e=this.faces[t])}e!==null&&this._addVertexToFace(n,e)}}return this}_reindexFaces(){let e=[];for(let t=0;t<this.faces.length;t++){let n=this.faces[t];n.mark===zC&&e.push(n)}return this.faces=e,this}_nextVertexToAdd(){if(this.assigned.isEmpty()===!1){let e,t=0,n=this.assigned.first().face,r=n.outside;do{let i=n.distanceToPoint(r.point);i>t&&(t=i,e=r),r=r.next}while(r!==null&&r.face===n);return e}}_computeHorizon(e,t,n,r){this._deleteFaceVertices(n),n.mark=BC;let i;i=t===null?t=n.getEdge(0):t.next;do{let t=i.twin,n=t.face;n.mark===zC&&(n.distanceToPoint(e)>this.tolerance?this._computeHorizon(e,t,n,r):r.push(i)),i=i.next}while(i!==t);return this}_addAdjoiningFace(e,t){let n=qC.create(e,t.tail(),t.head());return this.faces.push(n),n.getEdge(-1).setTwin(t.twin),n.getEdge(0)}_addNewFaces(e,t){this.newFaces=[];let n=null,r=null;for(let i=0;i<t.length;i++){let a=t[i],o=this._addAdjoiningFace(e,a);n===null?n=o:o.next.setTwin(r),this.newFaces.push(o.face),r=o}return n.next.setTwin(r),this}_addVertexToHull(e){let t=[];return this.unassigned.clear(),this._removeVertexFromFace(e,e.face),this._computeHorizon(e.point,null,e.face,t),this._addNewFaces(e,t),this._resolveUnassignedPoints(this.newFaces),this}_cleanup(){return this.assigned.clear(),this.unassigned.clear(),this.newFaces=[],this}_compute(){let e;for(this._computeInitialHull();(e=this._nextVertexToAdd())!==void 0;)this._addVertexToHull(e);return this._reindexFaces(),this._cleanup(),this}},qC=class e{constructor(){this.normal=new G,this.midpoint=new G,this.area=0,this.constant=0,this.outside=null,this.mark=zC,this.edge=null}static create(t,n,r){let i=new e,a=new JC(t,i),o=new JC(n,i),s=new JC(r,i);return a.next=s.prev=o,o.next=a.prev=s,s.next=o.prev=a,i.edge=a,i.compute()}getEdge(e){let t=this.edge;for(;e>0;)t=t.next,e--;for(;e<0;)t=t.prev,e++;return t}compute(){let e=this.edge.tail(),t=this.edge.head(),n=this.edge.next.head();return GC.set(e.point,t.point,n.point),GC.getNormal(this.normal),GC.getMidpoint(this.midpoint),this.area=GC.getArea(),this.constant=this.normal.dot(this.midpoint),this}distanceToPoint(e){return this.normal.dot(e)-this.constant}},JC=class{constructor(e,t){this.vertex=e,this.prev=null,this.next=null,this.twin=null,this.face=t}head(){return this.vertex}tail(){return this.prev?this.prev.vertex:null}length(){let e=this.head(),t=this.tail();return t===null?-1:t.point.distanceTo(e.point)}lengthSquared(){let e=this.head(),t=this.tail();return t===null?-1:t.point.distanceToSquared(e.point)}setTwin(e){return this.twin=e,e.twin=this,this}},YC=class{constructor(e){this.point=e,this.prev=null,this.next=null,this.face=null}},XC=class{constructor(){this.head=null,this.tail=null}first(){return this.head}last(){return this.tail}clear(){return this.head=this.tail=null,this}insertBefore(e,t){return t.prev=e.prev,t.next=e,t.prev===null?this.head=t:t.prev.next=t,e.prev=t,this}insertAfter(e,t){return t.prev=e,t.next=e.next,t.next===null?this.tail=t:t.next.prev=t,e.next=t,this}append(e){return this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail,e.next=null,this.tail=e,this}appendChain(e){for(this.head===null?this.head=e:this.tail.next=e,e.prev=this.tail;e.next!==null;)e=e.next;return this.tail=e,this}remove(e){return e.prev===null?this.head=e.next:e.prev.next=e.next,e.next===null?this.tail=e.prev:e.next.prev=e.prev,this}removeSubList(e,t){return e.prev===null?this.head=t.next:e.prev.next=t.next,t.next===null?this.tail=e.prev:t.next.prev=e.prev,this}isEmpty(){return this.head===null}},ZC=class extends em{constructor(e=[]){super();let t=[],n=[],r=new KC().setFromPoints(e).faces;for(let e=0;e<r.length;e++){let i=r[e],a=i.edge;do{let e=a.head().point;t.push(e.x,e.y,e.z),n.push(i.normal.x,i.normal.y,i.normal.z),a=a.next}while(a!==i.edge)}this.setAttribute(`position`,new Hp(t,3)),this.setAttribute(`normal`,new Hp(n,3))}},QC=1e4,$C=Math.cos(2*Math.PI/180),ew=Math.cos(20*Math.PI/180);function tw(e){let t=e.points.map(e=>new G(e.x,e.y,e.z));if(t.length<4||!t.every(e=>Number.isFinite(e.lengthSq())))return;let n=new ZC(t).getAttribute(`position`).array;if(n.length!==0)return iw(n,$C)}function nw(e){let t=[];for(let n=0;n+2<e.indices.length;n+=3){let[r,i,a]=[0,1,2].map(t=>e.vertices[e.indices[n+t]]);r&&i&&a&&t.push(r.x,r.y,r.z,i.x,i.y,i.z,a.x,a.y,a.z)}if(t.length!==0)return iw(new Float32Array(t),ew)}function rw(e){let{columns:t,rows:n,heights:r}=e;if(t<2||n<2||r.length<t*n)return;let i=new Float32Array(t*n*3);for(let a=0;a<n;a++)for(let o=0;o<t;o++){let s=a*t+o,c=r[s];i[3*s]=(o-(t-1)/2)*e.spacingX,i[3*s+1]=Number.isFinite(c)?c:0,i[3*s+2]=(a-(n-1)/2)*e.spacingZ}let a=new Set(e.holes),o=[];for(let e=0;e+1<n;e++)for(let n=0;n+1<t;n++){if(a.has(e*(t-1)+n))continue;let i=e*t+n,s=i+t;[i,i+1,s,s+1].every(e=>Number.isFinite(r[e]))&&o.push(i,s,s+1,i,s+1,i+1)}let s=new em;return s.setAttribute(`position`,new zp(i,3)),s.setIndex(o),s.computeVertexNormals(),s}function iw(e,t){let n=new em;n.setAttribute(`position`,new zp(e,3)),n.computeVertexNormals();let r=n.getAttribute(`normal`).array;return n.setAttribute(`edge`,new zp(aw(e,r,t),3)),n}function aw(e,t,n){let r=e.length/3,i=ow(e),a=new Map;for(let e=0;e<r;e++){let t=e-e%3,n=i[t+(e+1)%3],o=i[t+(e+2)%3],s=Math.min(n,o)*r+Math.max(n,o),c=a.get(s);c?c.push(e):a.set(s,[e])}let o=new Uint8Array(r).fill(1);for(let[e,r,...i]of a.values()){if(r===void 0||i.length>0)continue;let a=0;for(let n=0;n<3;n++)a+=t[3*e+n]*t[3*r+n];a>=n&&(o[e]=o[r]=0)}let s=new Float32Array(e.length),[c,l,u]=[new G,new G,new G];for(let t=0;t<r;t+=3)for(let n=0;n<3;n++){if(o[t+n]===0){for(let e=0;e<3;e++)s[3*(t+e)+n]=QC;continue}c.fromArray(e,3*(t+n)),l.fromArray(e,3*(t+(n+1)%3)),u.fromArray(e,3*(t+(n+2)%3));let r=u.sub(l),i=r.length(),a=r.cross(c.sub(l)).length();s[3*(t+n)+n]=i>0?a/i:0}return s}function ow(e){let t=new Map,n=new Uint32Array(e.length/3);for(let r=0;r<n.length;r++){let i=`${e[3*r]},${e[3*r+1]},${e[3*r+2]}`,a=t.get(i);a===void 0&&t.set(i,a=t.size),n[r]=a}return n}var sw=[`box`,`slab`,`plane`,`sphere`,`cap`,`tube`,`cylinder`,`cone`],cw={box:()=>new ph(2,2,2),slab:()=>new ph(2,2,2),plane:()=>new vh(2,2).rotateX(-Math.PI/2),sphere:()=>new yh(1,28,18),cap:()=>new yh(1,20,8,0,Math.PI*2,0,Math.PI/2),tube:()=>new mh(1,1,2,20,1,!0),cylinder:()=>new mh(1,1,2,32),cone:()=>new hh(1,2,32,6)},lw=30,uw=500,dw=new G(0,1,0),fw=new G(1,1,1),pw=new tf().setFromAxisAngle(new G(1,0,0),Math.PI);function mw(e,t=new J){let n=t.clone().multiply(hw(e)),r=(e,t,r=0,i=new tf)=>{let a=new J().compose(new G(0,r,0),i,t);return{kind:e,key:e,geometry:cw[e],local:a.premultiply(n)}},i=(e,t,r)=>[{kind:e,key:t,geometry:r,local:n}];switch(e.kind.case){case`sphere`:{let t=e.kind.value.radius;return[r(`sphere`,new G(t,t,t))]}case`box`:{let t=e.kind.value.halfExtents,n=new G(t?.x??.5,t?.y??.5,t?.z??.5);return[r(n.x>=lw&&n.z>=lw?`slab`:`box`,n)]}case`capsule`:{let{radius:t,halfLength:n}=e.kind.value,i=new G(t,t,t);return[r(`tube`,new G(t,n,t)),r(`cap`,i,n),r(`cap`,i,-n,pw)]}case`cylinder`:case`cone`:{let{radius:t,halfLength:n}=e.kind.value;return[r(e.kind.case,new G(t,n,t))]}case`plane`:{let t=e.kind.value.normal,n=t?new G(t.x,t.y,t.z).normalize():dw,i=new tf().setFromUnitVectors(dw,n);return[r(`plane`,new G(uw,1,uw),0,i)]}case`hull`:{let t=e.kind.value;return i(`hull`,LC(t,()=>RC(`hull`,gw(t.points))),()=>tw(t))}case`mesh`:{let t=e.kind.value;return i(`mesh`,LC(t,()=>RC(`mesh`,gw(t.vertices),t.indices)),()=>nw(t))}case`heightField`:{let t=e.kind.value,n=[t.columns,t.rows,t.spacingX,t.spacingZ];return i(`field`,LC(t,()=>RC(`field`,n,t.heights,t.holes)),()=>rw(t))}case`compound`:return e.kind.value.children.flatMap(e=>mw(e,n));default:return[]}}function hw({position:e,rotation:t}){let n=t?new tf(t.x,t.y,t.z,t.w):new tf;n.lengthSq()===0&&n.identity();let r=e?new G(e.x,e.y,e.z):new G;return new J().compose(r,n.normalize(),fw)}function*gw(e){for(let{x:t,y:n,z:r}of e)yield t,yield n,yield r}var _w=new J,vw=class{scene;kinds=new Map;material=new Ah({roughness:.6});constructor(e){this.scene=e}begin(){for(let e of this.kinds.values())e.usedCount=0}add(e,t,n,r,i){let a=this.entryOf(e);a.usedCount===a.slots.length&&a.slots.push(a.instances.acquire(0));let o=a.slots[a.usedCount++];a.instances.setMatrix(o,_w.compose(t,n,r)),a.instances.setColor(o,i)}end(){for(let{instances:e,slots:t,usedCount:n}of this.kinds.values()){for(;t.length>n;)e.release(t.pop());e.upload()}}countOf(e){return this.kinds.get(e)?.usedCount??0}get count(){return[...this.kinds.values()].reduce((e,{usedCount:t})=>e+t,0)}matrixOf(e,t){let{instances:n,slots:r}=this.entryOf(e),i=new J;return n.mesh.getMatrixAt(r[t],i),i}entryOf(e){let t=this.kinds.get(e);if(t)return t;let n={instances:new MC(this.scene,e,cw[e](),this.material,!0,32),slots:[],usedCount:0};return this.kinds.set(e,n),n}},yw=1024,bw=class e{object;count=0;positions;colors;constructor(e){this.object=e,e.frustumCulled=!1,e.renderOrder=1,this.reserve(yw),this.end()}static lines(t){let n={vertexColors:!0,depthTest:!1,transparent:!0,opacity:t,fog:!1,toneMapped:!1};return new e(new th(new em,new Um(n)))}static points(t){let n=new nh({vertexColors:!0,depthTest:!1,transparent:!0,fog:!1,toneMapped:!1,size:t,sizeAttenuation:!1});return new e(new sh(new em,n))}get capacity(){return this.positions.count}begin(){this.count=0}vertex(e,t,n,r){this.count===this.capacity&&this.reserve(this.capacity*2),this.positions.setXYZ(this.count,e,t,n),this.colors.setXYZ(this.count,r.r,r.g,r.b),this.count++}end(){let{geometry:e}=this.object;if(e.setDrawRange(0,this.count),this.object.visible=this.count>0,this.count!==0)for(let e of[this.positions,this.colors])e.clearUpdateRanges(),e.addUpdateRange(0,this.count*3),e.needsUpdate=!0}reserve(e){let{geometry:t}=this.object;t.dispose();let n=t=>{let n=new Float32Array(e*3);return t&&n.set(t.array),new zp(n,3).setUsage(hd)};this.positions=n(this.positions),this.colors=n(this.colors),t.setAttribute(`position`,this.positions),t.setAttribute(`color`,this.colors)}},xw=new Map([[`boat`,Wx],[`character`,rS],[`destruction`,lS],[`fields`,MS],[`fields.waves`,jS],[`hovercraft`,GS],[`ragdoll`,uC],[`vehicle`,AC]]),Sw=[...xw.keys()],Cw=class{renderers;lines=bw.lines(.9);solids;water;blasts;debug=!1;renderedKinds=[];coloredChannels=[];constructor(e,t=xw){this.renderers=t,e.add(this.lines.object),this.solids=new vw(e),this.water=new Wb(e),this.blasts=new Ox(e)}update(e,t){this.renderedKinds=this.groupByKind(e,e.channels);let{lines:n,solids:r,water:i,blasts:a,debug:o}=this;for(let e of[n,r,i])e.begin();let s={...t,lines:n,solids:r,water:i,blasts:a,debug:o};for(let{renderer:e,data:t}of this.renderedKinds)e.draw?.(t,s);t.decorate?.(r);for(let e of[n,r,i])e.end();a.update(t.nowMs)}bodyColors(e,t,n){let r=e.channels.filter(({kind:t})=>this.rendererOf(e,t)?.bodyColors);if(r.length===this.coloredChannels.length&&r.every((e,t)=>e===this.coloredChannels[t])&&!t)return;this.coloredChannels=r;let i=new Map;for(let{renderer:t,data:a}of this.groupByKind(e,r))for(let[e,r]of t.bodyColors?.(a,n)??[])i.set(e,r);return i}steeringOf(e){return this.controlledRenderer(e)?.steering}controlledStatusText(e){let{steering:t,data:n}=this.controlledRenderer(e)??{};return(n&&t?.statusText?.(n))??``}statusText(){return this.renderedKinds.map(({renderer:e,data:t})=>e.statusText?.(t)??``).filter(e=>e!==``).join(` · `)}rendererOf({kinds:e},t){return this.renderers.get(e[t]?.name??``)}groupByKind(e,t){let n=new Map;for(let{kind:r,entity:i,values:a}of t){let t=(e.frame-1)%Math.max(e.kinds[r]?.divisor??1,1)/e.tickHz+e.secondsAfter,o=n.get(r);o?o.push({entity:i,values:a,seconds:t}):n.set(r,[{entity:i,values:a,seconds:t}])}return[...n].flatMap(([t,n])=>{let r=this.rendererOf(e,t);return r?[{renderer:r,data:n}]:[]})}controlledRenderer(e){for(let{renderer:t,data:n}of this.renderedKinds){let r=t.steering&&n.find(t=>t.entity===e);if(t.steering&&r)return{steering:t.steering,data:r}}}},ww=new Y(16739166),Tw=new Y(8176895),Ew=new Y(8116367),Dw=new Y(12033279),Ow=new Y(16765286),kw=new Y(10125895),Aw=.12,jw=1.5,Mw=.06,Nw={$typeName:`jostle.v1.Vec3`,x:0,y:0,z:0},Pw=class{contactPoints=bw.points(7);contactLines=bw.lines(1);boundLines=bw.lines(.55);jointPoints=bw.points(6);jointLines=bw.lines(1);cellLines=bw.lines(.3);buffers=[this.contactPoints,this.contactLines,this.boundLines,this.jointPoints,this.jointLines,this.cellLines];constructor(e){for(let{object:t}of this.buffers)e.add(t)}show(e,t,n){for(let e of this.buffers)e.begin();if(t.contacts)for(let t of e.contacts)this.drawContact(t);if(t.bounds)for(let t of e.bounds)Iw(this.boundLines,t,Ew);if(t.broadPhase)for(let t of e.broadPhase)Iw(this.cellLines,t,Dw);if(t.joints)for(let t of e.joints)this.drawJoint(t,n);for(let e of this.buffers)e.end()}clear(){for(let e of this.buffers)e.begin(),e.end()}drawContact({point:e=Nw,normal:t=Nw,impulse:n,touching:r}){let i=r?ww:Tw,a=Fw(n);this.contactPoints.vertex(e.x,e.y,e.z,i),this.contactLines.vertex(e.x,e.y,e.z,i),this.contactLines.vertex(e.x+a*t.x,e.y+a*t.y,e.z+a*t.z,i)}drawJoint({anchorA:e=Nw,anchorB:t=Nw,entityA:n,entityB:r},i){for(let[a,o]of[[n,e],[r,t]]){this.jointPoints.vertex(o.x,o.y,o.z,Ow);let e=i(a);e&&(this.jointLines.vertex(e[0],e[1],e[2],kw),this.jointLines.vertex(o.x,o.y,o.z,kw))}this.jointLines.vertex(e.x,e.y,e.z,Ow),this.jointLines.vertex(t.x,t.y,t.z,Ow)}};function Fw(e){return Math.min(jw,Aw+Mw*Math.sqrt(Math.max(0,e)))}function Iw(e,{low:t=Nw,high:n=Nw},r){for(let i of[t.y,n.y])e.vertex(t.x,i,t.z,r),e.vertex(n.x,i,t.z,r),e.vertex(n.x,i,t.z,r),e.vertex(n.x,i,n.z,r),e.vertex(n.x,i,n.z,r),e.vertex(t.x,i,n.z,r),e.vertex(t.x,i,n.z,r),e.vertex(t.x,i,t.z,r);for(let i of[t.x,n.x])for(let a of[t.z,n.z])e.vertex(i,t.y,a,r),e.vertex(i,n.y,a,r)}var Lw=.618034;function Rw(e){let t=new Map,n=new Y;for(let{entities:r}of e){let e=r.reduce((e,t)=>Math.min(e,t),1/0);if(e===1/0)continue;let i=n.setHSL(e*Lw%1,.62,.58).getHex();for(let e of r)t.set(e,i)}return t}var zw=200,Bw=2,Vw=[`sleep`,`fields`],Hw=[{toggle:`contacts`,label:`Contacts`,hint:`Points and normals: red touching, blue near; longer means a larger impulse`},{toggle:`islands`,label:`Islands`,hint:`One color per island`},{toggle:`sleep`,label:`Sleep`,hint:`Sleeping bodies are blue`},{toggle:`bounds`,label:`Bounds`,hint:`Bounding box of each shape`},{toggle:`joints`,label:`Joints`,hint:`Lines from each body to its anchor`},{toggle:`fields`,label:`Fields`,hint:`Wind as arrows, attractors as rings`},{toggle:`broadPhase`,label:`Broad phase`,hint:`Grid cells or tree nodes`}],Uw=class{queries;lines;view;on={contacts:!1,islands:!1,sleep:!1,bounds:!1,joints:!1,broadPhase:!1,fields:!1};missedResponses=0;note=document.createElement(`p`);throttle=new fx(zw,()=>this.query());constructor(e,t,n,r){this.queries=t,this.lines=n,this.view=r;let i=document.createElement(`h2`);i.textContent=`Debug view`,e.append(i,...Hw.map(({toggle:e,label:t,hint:n})=>this.row(e,t,n)),this.note),this.note.className=`note`}row(e,t,n){let r=document.createElement(`label`);r.title=n;let i=document.createElement(`input`);return i.type=`checkbox`,i.name=e,i.onchange=()=>{this.on[e]=i.checked,i.blur(),this.toggled()},r.append(i,t),r}get needsServer(){return Hw.some(({toggle:e})=>!Vw.includes(e)&&this.on[e])}toggled(){this.view.markAsleep(this.on.sleep),this.on.islands||this.view.setTints(void 0),this.needsServer||(this.lines.clear(),this.note.textContent=``)}update(){this.needsServer&&this.throttle.request()}async query(){if(!this.needsServer)return;let{contacts:e,islands:t,bounds:n,joints:r,broadPhase:i}=this.on,a=await this.queries.debug({contacts:e,islands:t,bounds:n,joints:r,broadPhase:i});if(this.needsServer){if(this.missedResponses=a?0:this.missedResponses+1,!a){if(this.missedResponses<Bw)return;this.lines.clear(),this.view.setTints(void 0),this.note.textContent=`The server did not respond.`}else this.lines.show(a,this.on,e=>this.view.dynamicPoseOf(e)),this.on.islands&&this.view.setTints(Rw(a.islands)),this.note.textContent=Ww(a,this.on)}}};function Ww(e,t){let n=[],r=(e,t,r,i)=>{e&&n.push(`${t} ${t===1?r:i}`)};return r(t.contacts,e.contacts.length,`contact`,`contacts`),r(t.islands,e.islands.length,`island`,`islands`),r(t.bounds,e.bounds.length,`box`,`boxes`),r(t.joints,e.joints.length,`joint`,`joints`),r(t.broadPhase,e.broadPhase.length,`cell`,`cells`),n.join(`, `)+(e.truncated?`; truncated`:``)}var Gw={heightField:`height field`};function Kw(e){let t=e?.kind.case;return t===void 0?`shape`:Gw[t]??t}function qw(e,t){if(!e)return`body ${t}`;let n=Kw(e.shapes[0]);return e.name||`${n===`sphere`?`ball`:n} ${t}`}function Jw(e,t){return[e?.name||`no name`,`id ${t.entity}`,Kw(e?.shapes[t.shape]),`${t.distance.toFixed(t.distance<10?2:1)} m away`].join(` · `)}var Yw=12,Xw=new Y(16765286),Zw=2.4,Qw=new tf().setFromAxisAngle(new G(1,0,0),Math.PI),$w=class{panel;take;stopControlling;line=document.createElement(`p`);keys=document.createElement(`p`);choices=document.createElement(`p`);renderedText=``;offered=``;constructor(e,t,n){this.panel=e,this.take=t,this.stopControlling=n,this.keys.className=`keys`,e.append(this.line,this.keys,this.choices)}update(e,t){let{toolSelected:n,controlled:r,keys:i,status:a,worldStatus:o}=e;if(this.panel.hidden=!n&&!r&&o===``,this.panel.hidden)return;let s=r?`Driving ${qw(r,r.id)}${a&&` · ${a}`}`:n?t.length>0?`Click an entity below an arrow, or choose one:`:`This world has no controllable entities`:o,c=r?`${i||`W A S D or arrows, Space, Shift, E and Q`} · gamepad · Esc releases`:``;this.renderedText!==s+c&&(this.renderedText=s+c,this.line.textContent=s,this.keys.textContent=c),this.offer(r||!n?[]:t.slice(0,Yw),r!==void 0)}offer(e,t){let n=`${t} ${e.map(({id:e})=>e).join()}`;if(this.offered===n)return;this.offered=n;let r=(e,t)=>{let n=document.createElement(`button`);return n.type=`button`,n.textContent=e,n.onclick=()=>{n.blur(),t()},n};this.choices.replaceChildren(...e.map(({id:e,name:t})=>r(t||`${e}`,()=>this.take(e))),...t?[r(`Release`,()=>this.stopControlling())]:[])}};function eT(e){return e.length===0?``:e.length===1?`Press 8 to drive ${qw(e[0],e[0].id)}`:`Press 8 to drive one of ${e.length} entities`}var tT=new G,nT=new G(.28,.45,.28);function rT(e,t,n,r){let i=.15*Math.sin(r/250);for(let{id:r}of t){let t=n(r);t&&e.add(`cone`,tT.set(t[0],t[1]+Zw+i,t[2]),Qw,nT,Xw)}}var iT=2;function aT(e,t){let n=[],r=({entityA:e,entityB:t})=>`${e} ${t}`,i=(e,n)=>`${t(e.entityA)} ${n} ${t(e.entityB)}`,a=new Set(e.hits.map(r));e.missed>0&&n.push(`events of ${sT(e.missed,`tick`,`ticks`)} missed`),n.push(...oT(e.fellAsleep,`fell asleep`,t),...oT(e.woke,`woke`,t));for(let t of e.contactsEnded)n.push(i(t,`separated from`));for(let t of e.contactsBegan)a.has(r(t))||n.push(i(t,`touched`));for(let r of e.triggersLeft)n.push(`${t(r.entity)} left ${t(r.trigger)}`);for(let r of e.triggersEntered)n.push(`${t(r.entity)} entered ${t(r.trigger)}`);for(let t of e.hits)n.push(`${i(t,`hit`)} at ${t.speed.toFixed(1)} m/s`);for(let r of e.jointsBroke)n.push(`joint broke between ${t(r.entityA)} and ${t(r.entityB)} (${Math.round(r.force)} N)`);return n}function oT(e,t,n){return e.length>iT?[`${e.length} bodies ${t}`]:e.map(e=>`${n(e)} ${t}`)}function sT(e,t,n){return`${e} ${e===1?t:n}`}var cT=class{max;entries=[];constructor(e){this.max=e}add(e){let t=this.entries[this.entries.length-1];t?.text===e?t.count++:(this.entries.push({text:e,count:1}),this.entries.length>this.max&&this.entries.shift())}clear(){this.entries.length=0}get lines(){return this.entries.map(({text:e,count:t})=>t>1?`${e} × ${t}`:e)}},lT=12,uT=class{panel;marks;setEnabled;nameOf;recent=new cT(lT);list=document.createElement(`ol`);changed=!0;constructor(e,t,n,r){this.panel=e,this.marks=t,this.setEnabled=n,this.nameOf=r;let i=document.createElement(`h2`);i.textContent=`Events`,e.append(i,this.list)}toggle(){this.panel.hidden=!this.panel.hidden,this.panel.hidden&&this.clear(),this.setEnabled(!this.panel.hidden)}clear(){this.recent.clear(),this.changed=!0}addEvents(e,t){for(let t of aT(e,this.nameOf))this.recent.add(t);for(let{point:n,speed:r}of e.hits)n&&this.marks.add(n.x,n.y,n.z,r,t);this.changed=!0}update(){if(!this.changed||this.panel.hidden)return;this.changed=!1;let{lines:e}=this.recent,t=e.length>0?e:[`No events yet.`];this.list.replaceChildren(...t.map(e=>{let t=document.createElement(`li`);return t.textContent=e,t}))}},dT=.95;function fT(e){return e.paused?`This world is paused: ${e.paused}`:e.timeScale<=0||e.timeScale>=dT?``:`The server is overloaded: this world runs at ${Math.round(100*e.timeScale)} % of its speed`}var pT=class{box;world;showMessage;token;text=document.createElement(`span`);button=document.createElement(`button`);asked=``;constructor(e,t,n,r){this.box=e,this.world=t,this.showMessage=n,this.token=r,this.button.type=`button`,this.button.textContent=`Resume`,this.button.hidden=!0,this.button.onclick=()=>void this.resume(),e.append(this.text,this.button),e.hidden=!0}update(e){let t=e?fT(e):``;this.box.hidden=t===``,this.text.textContent!==t&&(this.text.textContent=t),e?.paused?this.asked!==this.world()&&(this.asked=this.world(),this.request(`GET`).then(e=>this.button.hidden=!e)):(this.button.hidden=!0,this.asked=``)}async resume(){this.button.hidden=!0,await this.request(`POST`)||this.showMessage(`the server did not resume the world`)}async request(e){let t=`api/worlds/${encodeURIComponent(this.world())}/resume`;return(await fetch(t,{method:e,headers:pl(this.token)}).catch(()=>void 0))?.ok??!1}},mT=120,hT={width:150,height:26},gT=class{unit;color;digits;row=document.createElement(`div`);value=document.createElement(`output`);canvas=document.createElement(`canvas`);history=[];constructor(e,t,n,r=0){this.unit=t,this.color=n,this.digits=r;let i=document.createElement(`span`);i.textContent=e,this.canvas.width=hT.width*2,this.canvas.height=hT.height*2,this.row.className=`plot`,this.row.append(i,this.value,this.canvas)}add(e){this.history.push(e),this.history.length>mT&&this.history.shift(),this.value.textContent=`${e.toFixed(this.digits)}${this.unit}`,this.draw()}draw(){let e=this.canvas.getContext(`2d`,{willReadFrequently:!0});if(!e)return;let{width:t,height:n}=this.canvas,r=Math.max(1e-6,...this.history)*1.1;e.clearRect(0,0,t,n),e.beginPath(),this.history.forEach((i,a)=>{let o=a/119*t,s=n-2-i/r*(n-4);a===0?e.moveTo(o,s):e.lineTo(o,s)}),e.strokeStyle=this.color,e.lineWidth=3,e.stroke()}},_T=class{connection;latest;tick=document.createElement(`p`);plots={age:new gT(`Latency`,` ms`,`#ffd166`,1),rtt:new gT(`Round trip`,` ms`,`#ef8354`,1),bandwidth:new gT(`Bandwidth`,` kbit/s`,`#5b8def`),awake:new gT(`Awake`,``,`#81b29a`),asleep:new gT(`Asleep`,``,`#8896a5`),step:new gT(`Step`,` ms`,`#b388eb`,2),fps:new gT(`Frame rate`,` /s`,`#e5e9ee`)};lastBytes=0;lastAt=performance.now();frames=0;constructor(e,t){this.connection=t,this.tick.className=`tick`,e.append(this.tick,...Object.values(this.plots).map(e=>e.row))}frameRendered(){this.frames++}update(e){this.latest=e;let t=performance.now(),n=Math.max(.01,(t-this.lastAt)/1e3),r=this.connection.bytesReceived-this.lastBytes;this.lastBytes=this.connection.bytesReceived,this.lastAt=t,this.tick.textContent=`tick ${e.tick} · ${e.bodies} bodies · ${sT(e.clients,`client`,`clients`)}`+(e.lateTicks>0?` · ${e.lateTicks} late ticks`:``)+(e.paused?` · paused: ${e.paused}`:``),this.plots.age.add(this.connection.ageMs),this.plots.rtt.add(this.connection.clock.rttMs),this.plots.bandwidth.add(r*8/1e3/n),this.plots.awake.add(e.awake),this.plots.asleep.add(this.asleep()),this.plots.step.add(e.stepMsMean),this.plots.fps.add(this.frames/n),this.frames=0}asleep(){let e=0;for(let t of this.connection.frames.newest?.entities??[])t.atRest&&(this.connection.entities.get(t.id)?.mass??0)>0&&e++;return e}},vT=[.1,.25,.5,1,2,4],yT=class{panel;button=document.createElement(`button`);slider=document.createElement(`input`);readout=document.createElement(`output`);speed=document.createElement(`select`);stream;constructor(e){this.panel=e,this.button.type=`button`,this.button.onclick=()=>this.toggle(),Object.assign(this.slider,{type:`range`,min:`0`,step:`0.01`}),this.slider.setAttribute(`aria-label`,`Playback time`),this.slider.oninput=()=>this.stream?.seek(Number(this.slider.value)),this.speed.setAttribute(`aria-label`,`Playback speed`);for(let e of vT)this.speed.add(new Option(`${e} ×`,String(e),e===1,e===1));this.speed.onchange=()=>{this.stream&&(this.stream.speed=Number(this.speed.value))},e.append(this.button,this.slider,this.readout,this.speed)}show(e){this.stream=e,this.panel.hidden=e===void 0,e&&(this.slider.max=String(e.length),this.speed.value=String(e.speed))}toggle(){this.stream&&(this.stream.playing?this.stream.playing=!1:this.stream.play())}update(){let{stream:e}=this;if(!e)return;let t=e.playing?`Pause`:`Play`;this.button.textContent!==t&&(this.button.textContent=t),this.slider.value=String(e.seconds),this.readout.textContent=`${e.seconds.toFixed(1)} / ${e.length.toFixed(1)} s · tick ${e.tick}`}},bT=class{box;last=``;lastAt=0;constructor(e){this.box=e}show(e){let t=performance.now();if(e===this.last&&t-this.lastAt<1500)return;this.last=e,this.lastAt=t;let n=document.createElement(`p`);for(n.textContent=e,this.box.append(n);this.box.childElementCount>3;)this.box.firstElementChild.remove();setTimeout(()=>n.remove(),4e3)}};function xT(e,t=``,n=``){let r=document.createElement(e);return r.textContent=t,n&&(r.className=n),r}var ST=class{panel;join;showMessage;current;token;constructor(e,t,n,r,i=``){this.panel=e,this.join=t,this.showMessage=n,this.current=r,this.token=i}async toggle(){this.panel.hidden?await this.show():this.panel.hidden=!0}async show(){this.panel.hidden=!1,await this.refresh()}async call(e,t){let n=pl(this.token,t?.headers),r=await fetch(e,{...t,headers:n}).catch(()=>{throw Error(`the server does not respond`)}),i=await r.text(),a={};try{a=JSON.parse(i)}catch{a={message:i}}if(!r.ok)throw Error(a.message||`the server responded with HTTP status ${r.status}`);return a}async run(e){try{await e()}catch(e){this.showMessage(e instanceof Error?e.message:String(e))}}refresh(){return this.run(async()=>this.render(await this.call(`api/worlds`)))}render({worlds:e,scenes:t}){this.panel.replaceChildren(xT(`h2`,`Worlds`));for(let t of e)this.panel.append(this.worldRow(t)),t.oldestRestorableTick>0&&this.panel.append(this.restoreRow(t,e));this.panel.append(xT(`h2`,`New world from a scene`));for(let n of t){let t=xT(`button`,``,`scene`);t.type=`button`,t.append(xT(`strong`,n.name),xT(`span`,n.description)),t.onclick=()=>this.run(()=>this.create(n.name,{sceneName:n.name},e)),this.panel.append(t)}}worldRow(e){let t=xT(`div`,``,`world`),n=e.id===this.current(),r=`${e.bodies} bodies, ${e.awake} awake, ${sT(e.clients,`client`,`clients`)}`;t.append(xT(`strong`,e.name+(n?` (current)`:``)),xT(`span`,r));let i=xT(`button`,`Join`);i.type=`button`,i.disabled=n,i.onclick=()=>{this.panel.hidden=!0,this.join(e.id)};let a=xT(`button`,`Delete`,`danger`);return a.type=`button`,a.onclick=()=>{a.textContent===`Delete`?(a.textContent=`Confirm`,setTimeout(()=>a.textContent=`Delete`,3e3)):this.run(async()=>{await this.call(`api/worlds/${encodeURIComponent(e.id)}`,{method:`DELETE`}),await this.refresh()})},t.append(i,a),t}restoreRow(e,t){let n=xT(`div`,``,`restore`),r=Math.max(e.oldestRestorableTick,e.tick-Math.ceil(e.hz)),i=xT(`input`);Object.assign(i,{type:`range`,min:String(e.oldestRestorableTick),max:String(r),value:String(r)}),i.setAttribute(`aria-label`,`Tick of ${e.name}`);let a=xT(`output`),o=xT(`button`,`Restore copy`);o.type=`button`,o.title=`Create a new world from this tick`,o.onclick=()=>{let n=Number(i.value),r={world:e.id,tick:n};this.run(()=>this.create(`${e.name}-at-${n}`,{checkpoint:r},t))};let s=()=>{let t=(e.tick-Number(i.value))/e.hz;a.textContent=`tick ${i.value}, ${t.toFixed(1)} s ago`};return i.oninput=s,s(),n.append(i,a,o),n}async create(e,t,n){let r=new Set(n.map(e=>e.name)),i=e;for(let t=2;r.has(i);t++)i=`${e}-${t}`;let a=await this.call(`api/worlds`,{method:`POST`,headers:{"Content-Type":`application/json`},body:JSON.stringify({name:i,...t})});this.panel.hidden=!0,this.join(a.world.id)}},CT=64,wT=300,TT=.06,ET=.4,DT=.03,OT=new J,kT=new J().makeScale(0,0,0),AT=class{mesh;marks=Array.from({length:CT},()=>({at:new G,size:0,startMs:-1/0}));next=0;active=0;constructor(e){let t={color:16774084,transparent:!0,opacity:.85,depthWrite:!1,fog:!1,toneMapped:!1};this.mesh=new Im(new _h(1,1),new fm(t),CT),this.mesh.instanceMatrix.setUsage(hd),this.mesh.frustumCulled=!1,this.mesh.visible=!1,e.add(this.mesh)}add(e,t,n,r,i){let a=this.marks[this.next];this.next=(this.next+1)%CT,a.at.set(e,t,n),a.size=Math.min(ET,TT+DT*r),a.startMs=i}get activeCount(){return this.active}update(e){let t=this.active;this.active=0;for(let t=0;t<CT;t++){let{at:n,size:r,startMs:i}=this.marks[t],a=(e-i)/wT;if(a<0||a>=1){this.mesh.setMatrixAt(t,kT);continue}this.active++;let o=r*Math.sqrt(1-a);this.mesh.setMatrixAt(t,OT.makeScale(o,o,o).setPosition(n))}this.mesh.visible=this.active>0,(this.active>0||t>0)&&(this.mesh.instanceMatrix.needsUpdate=!0)}},jT=`
varying vec3 vUnit;  // on the unit geometry
varying vec3 vSize; // m, half extents
`,MT=`
vUnit = position;
vSize = vec3(length(instanceMatrix[0].xyz), length(instanceMatrix[1].xyz), length(instanceMatrix[2].xyz));
`,NT=`
attribute vec3 edge;
varying vec3 vEdge;  // m to each side of the triangle
`,PT=`
vEdge = edge;
`,FT=`
varying vec3 vEdge;
`,IT=`
float width = 0.018;
float blur = max(fwidth(toEdge), 1e-5);
float rim = (1.0 - smoothstep(width - blur, width + blur, toEdge)) * min(1.0, width / blur);
diffuseColor.rgb *= 1.0 - 0.45 * rim;
`,LT=`
vec3 inward = (1.0 - abs(vUnit)) * vSize;
float toEdge = max(min(inward.x, inward.y), min(max(inward.x, inward.y), inward.z));
${IT}`,RT=`
float toEdge = min(vEdge.x, min(vEdge.y, vEdge.z));
${IT}`,zT=`
float aside = abs(vUnit.x) * vSize.x;
float band = 0.2 * vSize.x;
float soft = max(fwidth(aside), 1e-5);
float stripe = 1.0 - smoothstep(band - soft, band + soft, aside);
diffuseColor.rgb = mix(diffuseColor.rgb, vec3(1.0), 0.34 * stripe);
`,BT=`
float toEdge = max((1.0 - length(vUnit.xz)) * vSize.x, (1.0 - abs(vUnit.y)) * vSize.y);
${IT}`,VT=`
float toEdge = max((1.0 - length(vUnit.xz)) * vSize.x, (1.0 + vUnit.y) * vSize.y);
${IT}`,HT=`
float across = abs(vUnit.y);
float soft = max(fwidth(across), 1e-5);
float belt = 1.0 - smoothstep(0.26 - soft, 0.26 + soft, across);
diffuseColor.rgb = mix(diffuseColor.rgb, vec3(1.0), 0.42 * belt);
`,UT=`
vec2 meters = vUnit.xz * vSize.xz;
for (int i = 0; i < 2; i++) {
  float spacing = i == 0 ? 1.0 : 5.0;
  vec2 at = meters / spacing;
  vec2 blur = max(fwidth(at), vec2(1e-6));
  vec2 away = abs(fract(at - 0.5) - 0.5) / blur;
  vec2 line = (1.0 - min(away, 1.0)) * (1.0 - smoothstep(0.15, 0.5, blur));
  diffuseColor.rgb *= 1.0 - (i == 0 ? 0.10 : 0.16) * max(line.x, line.y);
}
`,WT={box:LT,sphere:HT,slab:UT,plane:UT,field:UT,cylinder:zT+BT,cone:zT+VT,hull:RT,mesh:RT};function GT(e){let t=e===`slab`||e===`plane`||e===`field`,n=e===`hull`||e===`mesh`,r=new Ah({roughness:t?.95:.6,metalness:0,flatShading:e===`field`,side:e===`field`||e===`mesh`?2:0}),i=WT[e];return i===void 0||(r.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace(`#include <common>`,`#include <common>${n?NT:jT}`).replace(`#include <begin_vertex>`,`#include <begin_vertex>${n?PT:MT}`),e.fragmentShader=e.fragmentShader.replace(`#include <common>`,`#include <common>${n?FT:jT}`).replace(`#include <color_fragment>`,`#include <color_fragment>${i}`)},r.customProgramCacheKey=()=>i),r}function KT(e,t){let n=new Oh({side:1,depthWrite:!1,depthTest:!1,fog:!1,toneMapped:!1,uniforms:{horizon:{value:e},above:{value:t}},vertexShader:`
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
      }`}),r=new wm(new yh(100,24,16),n);return r.frustumCulled=!1,r.renderOrder=-1,r}var qT=[6000111,14711391,15912079,7058322,10980346,15696724,5032384,15100572],JT=16765286,YT=6713983,XT=new Y(3752524),ZT=.3,QT=new Y(3108822),$T=.75,eE=9278878,tE=new Y(3886174),nE=new Y(922652),rE=new G(18,30,12).normalize().multiplyScalar(60),iE=2048,aE=45,oE=8,sE=[`plane`,`slab`],cE=new G,lE=new tf,uE=new G(1,1,1),dE=new J,fE=new J,pE=new Y,mE=class{scene=new op;geometries=new Map;materials=new Map;rendered=new Map;sun=new hg(16773596,2.7);shadowReach=0;tints;bodyColors=new Map;asleepMarked=!1;constructor(){this.scene.fog=new ap(tE,45,170),this.scene.add(KT(tE,nE)),this.scene.add(new eg(13623541,5196354,1.35)),this.sun.castShadow=!0,this.sun.shadow.mapSize.set(iE,iE),this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.03,this.scene.add(this.sun,this.sun.target);for(let e of sw)this.addInstances(e,e,cw[e]());this.updateSun(new G,25)}addInstances(e,t,n,r){let i=this.materials.get(t);i||this.materials.set(t,i=GT(t));let a=new MC(this.scene,t,n,i,!sE.includes(t),r);return this.geometries.set(e,a),a}instancesFor({key:e,kind:t,geometry:n}){let r=this.geometries.get(e);if(r)return r;let i=n();return i&&this.addInstances(e,t,i,oE)}get objects(){return[...this.geometries.values()].map(e=>e.mesh)}partCounts(){let e={};for(let{kind:t,size:n}of this.geometries.values())n>0&&(e[t]=(e[t]??0)+n);return e}ownerAt(e,t){let n=e.userData.instances;return{entity:n?.entityAt(t)??0,shape:n?.shapeAt(t)??0}}updateSun(e,t){let n=Math.min(112,14*2**Math.max(0,Math.ceil(Math.log2(t/14))));if(n!==this.shadowReach){this.shadowReach=n;let{camera:e}=this.sun.shadow;Object.assign(e,{left:-n,right:n,top:n,bottom:-n,near:1,far:60+2*n}),e.updateProjectionMatrix()}let r=n/16,{position:i}=this.sun.target;i.copy(e).divideScalar(r).round().multiplyScalar(r),this.sun.position.copy(i).add(rE)}setEntities(e,t){for(let[t,n]of this.rendered)if(e.get(t)!==n.entity){for(let e of n.parts)e.instances.release(e.slot);this.rendered.delete(t)}for(let n of e.values())this.rendered.has(n.id)||this.rendered.set(n.id,this.addEntity(n,t));for(let[e,t]of this.geometries)t.size>0||sw.includes(e)||(t.dispose(),this.geometries.delete(e))}addEntity(e,t){let n=[];e.shapes.forEach((t,r)=>{for(let i of mw(t)){let t=this.instancesFor(i);t&&n.push({instances:t,slot:t.acquire(e.id,r),local:i.local})}});let r=new Float64Array(7).fill(NaN);return{entity:e,parts:n,color:hE(e,t),pose:r,asleep:void 0}}update(e){for(let t=0;t<e.count;t++){let n=this.rendered.get(e.ids[t]);if(!n)continue;let r=e.source.entities[t].atRest;n.asleep!==r&&this.applyColor(n,r);let i=!0,a=t*7,{pose:o}=n;for(let t=0;t<7;t++){let n=e.poses[a+t];o[t]!==n&&(o[t]=n,i=!1)}i||this.applyPose(n)}for(let e of this.geometries.values())e.upload()}applyPose({pose:e,parts:t}){cE.set(e[0],e[1],e[2]),lE.set(e[3],e[4],e[5],e[6]),dE.compose(cE,lE,uE);for(let e=0;e<t.length;e++){let{instances:n,slot:r,local:i}=t[e];n.setMatrix(r,fE.multiplyMatrices(dE,i))}}applyColor(e,t){e.asleep=t,pE.set(this.currentColor(e)),t&&e.entity.mass>0&&pE.lerp(this.asleepMarked?QT:XT,this.asleepMarked?$T:ZT);for(let{instances:t,slot:n}of e.parts)t.setColor(n,pE)}currentColor({entity:e,color:t}){let n=e.color??this.bodyColors.get(e.id)??t;return!this.tints||e.mass<=0?n:this.tints.get(e.id)??eE}setTints(e){let t=this.tints;if(this.tints=e,t||e)for(let[n,r]of this.rendered)t&&e&&t.get(n)===e.get(n)||(r.asleep=void 0)}setBodyColors(e){let t=this.bodyColors;this.bodyColors=e;for(let[n,r]of this.rendered)t.get(n)!==e.get(n)&&(r.asleep=void 0)}markAsleep(e){if(this.asleepMarked!==e){this.asleepMarked=e;for(let e of this.rendered.values())e.asleep=void 0}}poseOf(e){let t=this.rendered.get(e)?.pose;return t&&!Number.isNaN(t[0])?t:void 0}bounds(){let e=new xp,t=new xp;for(let{parts:n,pose:r}of this.rendered.values())if(!Number.isNaN(r[0]))for(let{instances:r,slot:i}of n)r.mesh.geometry.boundingBox??r.mesh.geometry.computeBoundingBox(),r.mesh.getMatrixAt(i,fE),t.copy(r.mesh.geometry.boundingBox).applyMatrix4(fE),Math.max(t.max.x-t.min.x,t.max.z-t.min.z)<aE&&e.union(t);return e}dynamicPoseOf(e){return(this.rendered.get(e)?.entity.mass??0)>0?this.poseOf(e):void 0}colorOf(e){let t=this.rendered.get(e)?.parts[0];return t&&t.instances.colorAt(t.slot).getHex()}};function hE(e,t){return e.color===void 0?e.type===Bs.STATIC?YT:e.owner===0?qT[e.id%qT.length]:e.owner===t?JT:qT[e.owner%qT.length]:e.color}var gE=[`high`,`medium`,`low`],_E=1,vE=1e6,yE=16,bE=1e6;function xE(e){let t=new URLSearchParams(e);return{world:t.get(`world`)??``,recording:t.get(`recording`)||void 0,quality:gE.find(e=>e===t.get(`quality`))??`high`,predict:t.get(`predict`)===`1`,areaOfInterest:SE(t),networkConditions:wE(t)}}function SE(e){let t=(t,n,r)=>{let i=Number(e.get(t)??``);return i>=n&&i<=r?i:0},n=t(`interest`,_E,vE),r=Math.round(t(`kbps`,yE,bE));return n>0||r>0?{radius:n,maxKbps:r}:void 0}var CE={latency_ms:[`latencyMs`,0,6e4],jitter_ms:[`jitterMs`,0,6e4],jitter_tail_ms:[`jitterTailMs`,0,6e4],stall_ms:[`stallMs`,0,6e4],stall_interval_ms:[`stallIntervalMs`,0,1e9],loss:[`loss`,0,1],loss_burst:[`lossBurst`,1,1e3],retransmit_ms:[`retransmitMs`,0,6e4],rate_kbps:[`rateKbps`,0,1e7],seed:[`seed`,0,2**32-1]};function wE(e){let t={...Nl};for(let[n,r]of e){let[e,i,a]=CE[n]??[],o=Number(r);e&&r!==``&&o>=i&&o<=a&&(t[e]=o)}return Pl(t)?t:void 0}var TE=`jostle-token`;function EE(e,t){let n=new URLSearchParams(e.hash.replace(/^#/,``)),r=n.get(`token`);return r===null?t.getItem(TE)??``:(n.delete(`token`),e.replaceHash(n.toString()),t.setItem(TE,r),r)}var DE=e=>document.getElementById(e),OE=e=>e instanceof Error?e.message:String(e),kE=xE(location.search),{quality:AE}=kE,jE=DE(`view`),ME=DE(`state`);document.documentElement.dataset.quality=AE;var NE=new rb({canvas:jE,antialias:AE===`high`});NE.shadowMap.enabled=AE===`high`,NE.shadowMap.type=1,NE.toneMapping=4;var PE=new Ib(jE),FE=new mE,IE=new Zc,LE=new bT(DE(`toasts`)),RE={connecting:`connecting …`,playing:``,waiting:`reconnecting …`,stopped:``},zE=EE({hash:location.hash,replaceHash:e=>history.replaceState(null,``,location.pathname+location.search+(e&&`#${e}`))},sessionStorage),BE={state:(e,t)=>{let n=$.welcome?.worldName??``;ME.textContent=e===`playing`?`in ${n}`:[t,RE[e]].filter(Boolean).join(` — `),ME.className=e,e!==`playing`&&qE.update(void 0),e===`stopped`&&t&&oD.show()},entityList:e=>{FE.setEntities(e,$.welcome?.clientId??0),ZE=HE?[]:[...e.values()].filter(e=>e.controllable),QE=!0,e.has(XE.entity)||XE.reset()},stats:e=>{KE.update(e),qE.update(HE?void 0:e)},worldEvents:e=>aD.addEvents(e,performance.now()+lD()),inputRejected:e=>LE.show(e.message||`the server rejected the input`),notice:e=>LE.show(e)},VE=kE.networkConditions?Rl(Oc,kE.networkConditions):Oc,HE,UE=kE.predict?[...Sw,ds]:Sw,$=new kc({url:sD(),listener:BE,openSocket:e=>HE?HE.open():VE(e),token:zE,channelKinds:UE,areaOfInterest:kE.areaOfInterest}),WE;async function GE(){let e=e=>{WE=void 0,LE.show(`prediction is disabled: ${OE(e)}`)};try{let{loadPrediction:t}=await rl(async()=>{let{loadPrediction:e}=await import(`./prediction-BqlHjluZ.js`);return{loadPrediction:e}},[],import.meta.url);WE=await t($.frames,e),$.enablePrediction(WE)}catch(t){e(t)}}kE.predict&&GE();var KE=new _T(DE(`stats`),$),qE=new pT(DE(`pause-banner`),()=>$.welcome?.worldId??``,e=>LE.show(e),zE),JE=new hl(()=>$.state===`playing`&&!HE?$.welcome?.worldId??``:``,ml(zE)),YE=DE(`readout`),XE=new rx(e=>$.send(e)),ZE=[],QE=!1,$E,eD=new xx(jE,PE,FE,$,JE,e=>{YE.hidden=e===void 0,e&&(YE.textContent=Jw($.entities.get(e.entity),e))},e=>{if(!$.entities.get(e)?.controllable)return LE.show(`this entity is not controllable`);_D(e)},(e,t,n,r)=>iD.blasts.add(e,t,n,r,performance.now())),tD=new $w(DE(`driver`),_D,()=>XE.stopControlling()),nD=new Uw(DE(`debug`),JE,new Pw(FE.scene),FE),rD=new AT(FE.scene),iD=new Cw(FE.scene),aD=new uT(DE(`events`),rD,e=>$.setEventsEnabled(e),e=>qw($.entities.get(e),e)),oD=new ST(DE(`worlds`),e=>{dD(void 0),$.join(e)},e=>LE.show(e),()=>$.welcome?.worldId??``,zE);function sD(){let e=new URL(`play`,location.href);return e.protocol=location.protocol===`https:`?`wss:`:`ws:`,e.search=e.hash=``,e.href}var cD=0;function lD(){let e=$.frames.newest;return e?Math.max(0,(e.serverUs-cD)/1e3):0}var uD=new yT(DE(`timeline`));function dD(e){HE=e,uD.show(e),eD.enabled=e===void 0,document.documentElement.toggleAttribute(`data-recording`,e!==void 0)}async function fD(e,t){try{let n=new kl(new Uint8Array(await t));n.truncationReason&&LE.show(`${e}: incomplete recording: ${n.truncationReason}`);for(let{reason:t,length:r,snapshotsSkipped:i}of n.damage)LE.show(`${e}: damaged recording: ${t}; ${r} bytes and ${i} snapshots are skipped`);XE.stopControlling(),dD(new yl(n)),$.join(``)}catch(t){LE.show(`${e}: ${OE(t)}`)}}addEventListener(`dragover`,e=>e.preventDefault()),addEventListener(`drop`,e=>{e.preventDefault();let t=e.dataTransfer?.files[0];t&&fD(t.name,t.arrayBuffer())});async function pD(e){let t=await fetch(e);if(!t.ok)throw Error(`the server responded with HTTP status ${t.status}`);return t.arrayBuffer()}function mD(e){eD.tool=e;for(let t of DE(`tools`).querySelectorAll(`button`))t.setAttribute(`aria-pressed`,String(t.dataset.tool===e));jE.style.cursor=e===`drag`?``:`crosshair`}for(let{tool:e,key:t,label:n,hint:r}of px){let i=document.createElement(`button`);i.type=`button`,i.dataset.tool=e,i.title=`${r} (${t})`,i.innerHTML=`<kbd>${t}</kbd> ${n}`,i.onclick=()=>mD(e),DE(`tools`).append(i)}mD(`drag`),DE(`help`).innerHTML=`<h2>Controls</h2><dl>${px.map(({key:e,label:t,hint:n})=>`<dt><kbd>${e}</kbd> ${t}</dt><dd>${n}</dd>`).join(``)}<dt>Camera</dt><dd>Drag the ground to turn, right button to pan, wheel to zoom; two fingers on touch screens</dd>
<dt><kbd>D</kbd></dt><dd>Debug view of the solver</dd>
<dt><kbd>E</kbd></dt><dd>Events; opening the panel rejoins the world</dd>
<dt><kbd>W</kbd> <kbd>S</kbd> <kbd>?</kbd></dt><dd>Worlds, statistics, this help</dd></dl>`;var hD=e=>{DE(e).hidden=!DE(e).hidden};DE(`worlds-button`).onclick=()=>void oD.toggle(),DE(`stats-button`).onclick=()=>hD(`stats`),DE(`debug-button`).onclick=()=>hD(`debug`),DE(`events-button`).onclick=()=>aD.toggle(),DE(`help-button`).onclick=()=>hD(`help`),addEventListener(`keydown`,e=>{if(e.ctrlKey||e.metaKey||e.altKey)return;if(e.key===`Escape`&&XE.stopControlling(),XE.keyDown(e.code))return e.preventDefault();HE&&e.key===` `&&e.target===document.body&&uD.toggle();let t=px.find(({key:t})=>t===e.key);t&&mD(t.tool),e.key===`w`&&oD.toggle(),e.key===`s`&&hD(`stats`),e.key===`d`&&hD(`debug`),e.key===`e`&&aD.toggle(),e.key===`?`&&hD(`help`)}),addEventListener(`keyup`,e=>XE.keyUp(e.code)),addEventListener(`blur`,()=>XE.blur());function gD(e){let[t,n,r,i]=[e[3],e[4],e[5],e[6]];return Math.atan2(2*(t*r+i*n),1-2*(t*t+n*n))}function _D(e){XE.takeControl(e),PE.startApproach(iD.steeringOf(e)?.distance??8)}var vD=performance.now();function yD(){let e=performance.now(),t=Math.min(.5,(e-vD)/1e3);if(vD=e,XE.entity===0)return;let n=navigator.getGamepads().find(e=>e!==null&&e.mapping===`standard`)??void 0;XE.update(n,nx(PE.camera.getWorldDirection(new G)),e);let r=FE.poseOf(XE.entity);if(!r)return;let i=iD.steeringOf(XE.entity)?.camera!==`free`;PE.follow(r,i?gD(r):void 0,t)}function bD(){return XE.entity===0||iD.steeringOf(XE.entity)?.camera!==`free`?1/0:cx(FE,PE.controls.target,PE.camera.position,XE.entity)}function xD(){let e=$.welcome?.worldId;if($.state!==`playing`||e===$E||IE.count===0)return;$E=e,PE.frame(FE.bounds());let{position:t}=PE.camera,n=lx(FE,t.x,t.z);n!==void 0&&(t.y=Math.max(t.y,n+3))}function SD(){let{frame:e=0,channels:t=us}=IE.source??{},{channels:n=[],tickHz:r=60}=$.welcome??{};return{frame:e,channels:t,secondsAfter:IE.secondsFromSource,kinds:n,tickHz:r}}function CD(e){iD.debug=nD.on.fields,iD.update(e,{nowMs:performance.now(),cameraTarget:PE.controls.target,poseOf:e=>FE.poseOf(e),entityOf:e=>$.entities.get(e),decorate:e=>{eD.tool===`drive`&&XE.entity===0&&rT(e,ZE,e=>FE.poseOf(e),performance.now())}})}function wD(e){let t=iD.bodyColors(e,QE,$.entities);QE=!1,t&&FE.setBodyColors(t)}function TD(){tD.update({toolSelected:eD.tool===`drive`,controlled:$.entities.get(XE.entity),keys:iD.steeringOf(XE.entity)?.keys??``,status:iD.controlledStatusText(XE.entity),worldStatus:iD.statusText()||eT(ZE)},ZE)}function ED(){NE.setPixelRatio(AE===`low`?.25:AE===`medium`?1:Math.min(2,devicePixelRatio)),NE.setSize(innerWidth,innerHeight,!1),PE.resize(innerWidth,innerHeight)}addEventListener(`resize`,ED),ED(),innerWidth<700&&(DE(`stats`).hidden=!0),NE.setAnimationLoop(()=>{PE.controls.update();let e=n();cD=HE?HE.advance(e):$.renderClock.advance(e),IE.update($.frames,cD,e),HE||WE?.applyTo(IE,$.inputClock.position(e),e),uD.update();let t=SD();wD(t),FE.update(IE),xD(),CD(t),TD(),nD.update(),aD.update(),rD.update(performance.now()),yD(),$.setInterestFocus(PE.controls.target.x,PE.controls.target.z),FE.updateSun(PE.controls.target,PE.camera.position.distanceTo(PE.controls.target)),PE.renderWithin(bD(),()=>NE.render(FE.scene,PE.camera)),KE.frameRendered()}),kE.recording?fD(kE.recording,pD(kE.recording)):$.join(kE.world),Kb({connection:$,view:FE,moduleView:iD,camera:PE,driving:XE,statsPanel:KE,recording:()=>HE,prediction:()=>WE,controllableEntities:()=>ZE.map(({id:e})=>e)});export{ds as i,Bs as n,Vs as r,vc as t};