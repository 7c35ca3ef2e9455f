/** Digits of base 85, as Python has them but for the comma, which begins no element. */
const DIGITS =
  "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;,=>?@^_`{|}~";
const OF = Object.fromEntries([...DIGITS].map((digit, value) => [digit, value]));
/** The text that an element of the file holds compressed. @param {string} id */
export async function unpacked(id) {
  const digits = document.getElementById(id)?.textContent ?? "";
  const words = new DataView(new ArrayBuffer(4 * Math.ceil(digits.length / 5)));
  for (let i = 0; i < digits.length; i += 5) {
    let word = 0;
    for (let k = i; k < i + 5; k++) word = 85 * word + (OF[digits[k]] ?? 84); // none at the end
    words.setUint32((4 * i) / 5, word);
  }
  const bytes = new Uint8Array(words.buffer, 0, Math.floor((4 * digits.length) / 5));
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(plain).text();
}
