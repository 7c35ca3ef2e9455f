// The token of this start of the server: by it the server knows this window, and this window it.

/** It is of this origin, its port too, and of this window alone; no cookie has it. */
const PLACE = "wraparc.start";
const store = /** @type {Record<string, string>} */ (kept());
function kept() {
  try {
    return sessionStorage;
  } catch {
    return {}; // a browser that keeps nothing: until the window is loaded again
  }
}
export const token = () => store[PLACE] || "";
/** @param {string} value */
export function keepToken(value) {
  store[PLACE] = value;
}

/** Take a token from the address: no bookmark, no link and no history has it then. */
export function takeToken() {
  const at = new URL(location.href);
  const brought = at.searchParams.get("token");
  if (!brought) return;
  keepToken(brought);
  at.searchParams.delete("token");
  history.replaceState(history.state, "", at);
}

/** Whether a browser can check a proof: over plain HTTP only on this machine. */
export const { subtle } = globalThis.crypto ?? {};
const encoded = (/** @type {string} */ text) => new TextEncoder().encode(text);
/**
 * Ask the server to prove that it knows a token, which it is not sent. Fails if none answers.
 * @param {string} secret @param {AbortSignal} signal @returns {Promise<[boolean, Response]>}
 */
export async function proof(secret, signal) {
  const nonce = `${crypto.randomUUID?.()}`;
  const response = await fetch(`/api/v1/same/${nonce}`, { signal });
  const bytes = await response.arrayBuffer();
  if (bytes.byteLength !== 32) throw 0; // no calculator
  if (!secret || !subtle) return [true, response];
  const how = { name: "HMAC", hash: "SHA-256" };
  const key = await subtle.importKey("raw", encoded(secret), how, false, ["verify"]);
  return [await subtle.verify("HMAC", key, bytes, encoded(nonce)), response];
}
