import{a,b}from"../../chunk-GFJ2TGXT.js";import"../../chunk-67AWL4ZT.js";import"../../chunk-A4SERXLY.js";import"../../chunk-B5GBOS53.js";export{b as moreInputs,a as pulleyName};
