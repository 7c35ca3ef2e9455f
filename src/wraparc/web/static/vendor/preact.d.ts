// The types of the vendored file, which is the published one of this version.
export * from "preact";
