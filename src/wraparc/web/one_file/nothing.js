// What only a page with a server has: its address is asked for, it names keys that are unknown, and
// finds reserves.
export const entry = () => null;
export const mend = () => null;
export const find = null;
export const reserve = null;
