"use strict";
// Small helpers of the page: elements, numbers in words, messages.

const byId = (id) => document.getElementById(id);

/** Makes an element. `attributes` are set as they are; `children` are nodes or texts. */
function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** The same in SVG. */
function drawing(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

const clamp = (value, least, most) => Math.min(Math.max(value, least), most);
const count = (value) => value.toLocaleString("en");
const fixed = (value, digits = 4) => value.toFixed(digits);
const triple = (color, digits = 4) => color.map((value) => fixed(value, digits)).join("  ");

/** A number with about three digits, for tables. */
function short(value) {
  if (value === 0) return "0";
  if (Math.abs(value) < 0.001) return value.toExponential(1);
  return value.toFixed(value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 4);
}

function milliseconds(time) {
  return time < 10 ? `${time.toFixed(1)} ms` : time < 1000 ? `${Math.round(time)} ms` : `${(time / 1000).toFixed(2)} s`;
}

/** CSS colour of a linear colour from 0 to 1. The library's levels are linear, too. */
function cssColor(color) {
  return `rgb(${color.map((value) => Math.round(clamp(value, 0, 1) * 255)).join(" ")})`;
}

const swatch = (color) =>
  element("span", { class: "swatch", style: `background:${cssColor(color)}`, "aria-hidden": "true" });

/** Calls `action` when nothing has asked for it for `wait` milliseconds. */
function debounced(wait, action) {
  let timer = 0;
  return (...values) => {
    clearTimeout(timer);
    timer = setTimeout(() => action(...values), wait);
  };
}

let sayTimer = 0;

/** Shows a line under the picture for some seconds; screen readers speak it. */
function say(text, seconds = 6) {
  clearTimeout(sayTimer);
  byId("status").textContent = text;
  if (text) sayTimer = setTimeout(() => (byId("status").textContent = ""), seconds * 1000);
}

/** Value of a switch of radio buttons. `changed` is called with each new value. */
function radios(name, changed) {
  for (const input of document.querySelectorAll(`input[name="${name}"]`)) {
    input.addEventListener("change", () => input.checked && changed(input.value));
  }
}
