/** The numbers of a scene: matrices of low rank, as src/scene.ts describes them. */
export class Blocks {
  #parts = [];
  #length = 0;

  /** value[row][column] = mean[column] + Σ coefficients[row][r] · basis[r][column] */
  lowRank(mean, basis, coefficients) {
    const { parts: shapes, scales: basisScale } = quantised(basis);
    const columns = basis.length === 0 ? [] : transposed(coefficients);
    const { parts: factors, scales: coefficientScale } = quantised(columns);
    return {
      rows: coefficients.length,
      columns: mean.length,
      rank: basis.length,
      mean: this.#add(Float32Array.from(mean)),
      basis: this.#add(Int16Array.from(shapes.flat())),
      basisScale,
      coefficients: this.#add(Int16Array.from(transposed(factors).flat())),
      coefficientScale,
    };
  }

  /** A matrix as it is: a basis vector a column. */
  dense(rows) {
    const mean = rows[0].map((_, c) => rows.reduce((sum, row) => sum + row[c], 0) / rows.length);
    const single = Float32Array.from(mean);
    const basis = mean.map((_, c) => mean.map((_, k) => (k === c ? 1 : 0)));
    return this.lowRank(mean, basis, rows.map((row) => row.map((value, c) => value - single[c])));
  }

  bytes() {
    return Buffer.concat(this.#parts);
  }

  #add(array) {
    const at = this.#length;
    const bytes = Buffer.from(array.buffer, array.byteOffset, array.byteLength);
    this.#parts.push(bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4));
    this.#length += Math.ceil(bytes.length / 4) * 4;
    return at;
  }
}

function transposed(rows) {
  return (rows[0] ?? []).map((_, c) => rows.map((row) => row[c]));
}

/** Each row as int16 with a scale of its own. */
function quantised(rows) {
  const scales = rows.map((row) => row.reduce((most, value) => Math.max(most, Math.abs(value)), 0) / 32767 || 1);
  return { scales, parts: rows.map((row, r) => row.map((value) => Math.round(value / scales[r]))) };
}
