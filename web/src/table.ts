/** A matrix of low rank, whose rows are reconstructed when they are drawn. */
import type { Matrix } from "./scene";

export class Table {
  readonly rows: number;
  readonly columns: number;
  private readonly rank: number;
  private readonly mean: Float32Array;
  /** rank × columns, scaled. */
  private readonly basis: Float64Array;
  /** rows × rank, to be multiplied by `scale`. */
  private readonly coefficients: Int16Array;
  private readonly scale: Float64Array;

  constructor(matrix: Matrix, data: ArrayBuffer) {
    const { rows, columns, rank } = matrix;
    this.rows = rows;
    this.columns = columns;
    this.rank = rank;
    this.mean = new Float32Array(data, matrix.mean, columns);
    this.coefficients = new Int16Array(data, matrix.coefficients, rows * rank);
    this.scale = Float64Array.from(matrix.coefficientScale);
    this.basis = Float64Array.from(new Int16Array(data, matrix.basis, rank * columns));
    for (let i = 0; i < this.basis.length; i++) this.basis[i] *= matrix.basisScale[Math.floor(i / columns)];
  }

  /** Writes the row at `position` to `out`; between rows the coefficients are interpolated linearly. */
  row(position: number, out: Float64Array): void {
    const { rank, columns, basis, coefficients, scale, mean } = this;
    const before = Math.min(Math.max(Math.floor(position), 0), this.rows - 1);
    const after = Math.min(before + 1, this.rows - 1);
    const share = Math.min(Math.max(position - before, 0), 1);
    for (let c = 0; c < columns; c++) out[c] = mean[c];
    for (let r = 0; r < rank; r++) {
      const here = coefficients[before * rank + r];
      const next = coefficients[after * rank + r];
      const factor = (here + share * (next - here)) * scale[r];
      const from = r * columns;
      for (let c = 0; c < columns; c++) out[c] += factor * basis[from + c];
    }
  }

  /** All rows of the only column. */
  series(): Float64Array {
    const out = new Float64Array(this.rows);
    const row = new Float64Array(this.columns);
    for (let i = 0; i < this.rows; i++) {
      this.row(i, row);
      out[i] = row[0];
    }
    return out;
  }
}
