// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Decompression of zlib streams (RFC 1950 and 1951), for browsers without DecompressionStream.

const LENGTH_BASE = [3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258];
const LENGTH_BITS = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
const DISTANCE_BASE = [1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577];
const DISTANCE_BITS = [0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13];
const ORDER_OF_CODE_LENGTHS = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
const END_OF_BLOCK = 256;
const LONGEST_CODE = 15;

/** A canonical Huffman code, from the length of each symbol's code. */
class HuffmanCode {
  constructor(lengths) {
    this.count = new Uint16Array(LONGEST_CODE + 1);
    for (const length of lengths) this.count[length]++;
    this.count[0] = 0;
    const next = new Uint16Array(LONGEST_CODE + 2);
    for (let i = 1; i <= LONGEST_CODE; ++i) next[i + 1] = next[i] + this.count[i];
    this.symbols = new Uint16Array(lengths.length);
    lengths.forEach((length, symbol) => {
      if (length > 0) this.symbols[next[length]++] = symbol;
    });
  }

  decode(bits) {
    let code = 0, first = 0, index = 0;
    for (let length = 1; length <= LONGEST_CODE; ++length) {
      code |= bits.take(1);
      const count = this.count[length];
      if (code - first < count) return this.symbols[index + code - first];
      index += count;
      first = (first + count) << 1;
      code <<= 1;
    }
    throw new Error("damaged data: no such code");
  }
}

/** The bits of bytes, least significant first. */
class Bits {
  constructor(bytes, position) {
    this.bytes = bytes;
    this.position = position;
    this.buffer = 0;
    this.available = 0;
  }

  take(n) {
    while (this.available < n) {
      if (this.position >= this.bytes.length) throw new Error("damaged data: it ends too early");
      this.buffer |= this.bytes[this.position++] << this.available;
      this.available += 8;
    }
    const value = this.buffer & ((1 << n) - 1);
    this.buffer >>>= n;
    this.available -= n;
    return value;
  }

  skipToByte() {
    this.buffer = 0;
    this.available = 0;
  }
}

function fixedCodes() {
  const lengths = Array.from({ length: 288 }, (_, i) => (i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8));
  return [new HuffmanCode(lengths), new HuffmanCode(new Array(30).fill(5))];
}

function transmittedCodes(bits) {
  const literals = bits.take(5) + 257, distances = bits.take(5) + 1, codes = bits.take(4) + 4;
  const lengthsOfCodes = new Array(19).fill(0);
  for (let i = 0; i < codes; ++i) lengthsOfCodes[ORDER_OF_CODE_LENGTHS[i]] = bits.take(3);
  const code = new HuffmanCode(lengthsOfCodes);
  const lengths = [];
  while (lengths.length < literals + distances) {
    const symbol = code.decode(bits);
    if (symbol < 16) lengths.push(symbol);
    else {
      const value = symbol === 16 ? lengths[lengths.length - 1] : 0;
      const times = symbol === 16 ? 3 + bits.take(2) : symbol === 17 ? 3 + bits.take(3) : 11 + bits.take(7);
      for (let i = 0; i < times; ++i) lengths.push(value);
    }
  }
  return [new HuffmanCode(lengths.slice(0, literals)), new HuffmanCode(lengths.slice(literals, literals + distances))];
}

/** The contents of the zlib stream `bytes`, which are `size` bytes. */
export function inflate(bytes, size) {
  const out = new Uint8Array(size);
  const bits = new Bits(bytes, 2);
  let at = 0, last = 0;
  while (!last) {
    last = bits.take(1);
    const kind = bits.take(2);
    if (kind === 0) {
      bits.skipToByte();
      const length = bits.bytes[bits.position] | (bits.bytes[bits.position + 1] << 8);
      bits.position += 4;
      out.set(bits.bytes.subarray(bits.position, bits.position + length), at);
      bits.position += length;
      at += length;
      continue;
    }
    if (kind === 3) throw new Error("damaged data: no such block");
    const [literals, distances] = kind === 1 ? fixedCodes() : transmittedCodes(bits);
    for (;;) {
      const symbol = literals.decode(bits);
      if (symbol === END_OF_BLOCK) break;
      if (symbol < END_OF_BLOCK) {
        out[at++] = symbol;
        continue;
      }
      const length = LENGTH_BASE[symbol - 257] + bits.take(LENGTH_BITS[symbol - 257]);
      const code = distances.decode(bits);
      const distance = DISTANCE_BASE[code] + bits.take(DISTANCE_BITS[code]);
      for (let i = 0; i < length; ++i, ++at) out[at] = out[at - distance];
    }
  }
  if (at !== size) throw new Error(`damaged data: ${at} bytes, not ${size}`);
  return out;
}
