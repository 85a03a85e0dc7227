// Colors of numbers. A color is an array of three numbers from 0 to 1.

// A dark to light sequence that can be told apart by everybody, and in gray: blue, green, yellow.
const sequence = [[0.27, 0.00, 0.33], [0.23, 0.32, 0.55], [0.13, 0.57, 0.55], [0.37, 0.79, 0.38], [0.99, 0.91, 0.14]];

function sequentialColor(t)
{
  const x = Math.min(Math.max(t, 0), 1) * (sequence.length - 1), i = Math.min(Math.floor(x), sequence.length - 2);
  return sequence[i].map((c, k) => c + (x - i) * (sequence[i + 1][k] - c));
}

// Neighbors in the order of numbers get hues that are far apart: steps of the golden section.
function categoricalColor(n)
{
  const hue = ((n * 0.6180339887498949) % 1 + 1) % 1, lightness = 0.52 + 0.16 * (n & 1);
  const c = new THREE.Color().setHSL(hue, 0.55, lightness);
  return [c.r, c.g, c.b];
}

// Red for positive, blue for negative numbers, lighter from 2 on.
function signedColor(x)
{
  if(x === 0)
    return [0.6, 0.6, 0.6];
  const light = Math.abs(x) > 1 ? 0.45 : 0;
  return x > 0 ? [0.85, light, 0.1] : [0.1, light, 0.9];
}

// The range of numbers that a sequence of colors stands for: a given one, or that of the values that are finite.
function rangeOf(numbers)
{
  let low = Infinity, high = -Infinity;
  for(const x of numbers.values)
    if(isFinite(x))
    {
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
  if(low > high)
    low = high = 0;
  return { low: numbers.low === null ? low : numbers.low, high: numbers.high === null ? high : numbers.high };
}

function colorOfNumber(x, numbers, range)
{
  if(!isFinite(x))
    return [0.6, 0.6, 0.6];
  if(numbers.scale === "categories")
    return categoricalColor(x);
  if(numbers.scale === "signed")
    return signedColor(x);
  return sequentialColor(range.high !== range.low ? (x - range.low) / (range.high - range.low) : 0.5);
}

function cssColor(color)
{
  return "rgb(" + color.map(c => Math.round(255 * c)).join(",") + ")";
}

// A number as people read it.
function numberText(x)
{
  return Number.isInteger(x) ? String(x) : Number.isFinite(x) ? String(Number(x.toPrecision(5))) : String(x);
}
