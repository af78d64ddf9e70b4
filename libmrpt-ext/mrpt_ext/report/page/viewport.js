// From map coordinates [m], y upwards, to pixels of the canvas, y downwards.

const kMargin = 28; // [pixels]
const kSmallestExtent = 0.5; // [m]

export class Viewport {
  /** `extent`: [low x, low y, high x, high y] that fit() shows. */
  constructor(extent) {
    this.extent = extent;
    this.width = 1;
    this.height = 1;
    this.scale = 1; // [pixels/m]
    this.centre = { x: 0, y: 0 };
  }

  /** Height of a canvas of this width that shows the extent well. */
  heightFor(width, tallest) {
    const [lowX, lowY, highX, highY] = this.extent;
    const shape = Math.max(highY - lowY, kSmallestExtent) / Math.max(highX - lowX, kSmallestExtent);
    return Math.min(Math.max((width - 2 * kMargin) * shape + 2 * kMargin, 220), tallest);
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
  }

  fit() {
    const [lowX, lowY, highX, highY] = this.extent;
    const across = (this.width - 2 * kMargin) / Math.max(highX - lowX, kSmallestExtent);
    const upwards = (this.height - 2 * kMargin) / Math.max(highY - lowY, kSmallestExtent);
    this.scale = Math.min(across, upwards);
    this.centre = { x: (lowX + highX) / 2, y: (lowY + highY) / 2 };
  }

  /** Pixels of a point. */
  x(x) {
    return this.width / 2 + this.scale * (x - this.centre.x);
  }
  y(y) {
    return this.height / 2 - this.scale * (y - this.centre.y);
  }

  pan(rightwards, downwards) {
    this.centre.x -= rightwards / this.scale;
    this.centre.y += downwards / this.scale;
  }

  zoom(factor) {
    this.scale *= factor;
  }
}
