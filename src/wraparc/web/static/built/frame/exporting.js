import{a,b}from"../chunk-UZQTAYWE.js";import"../chunk-IOBEHHJW.js";export{b as file,a as pictures};
