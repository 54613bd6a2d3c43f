// How numbers are written: so many digits, a true minus, powers of ten only where they must be.

function plain(value, digits) {
  var size = Math.abs(value);
  return (size !== 0 && (size < 0.001 || size >= 1e6) ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits))))
    .replace("-", "\u2212");
}
