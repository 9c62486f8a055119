// Legends as switches: a click or a key press hides a curve in every plot, pointing at it fades the others.
'use strict';
for (const key of document.querySelectorAll('.plot .key')) {
  const own = (element) => element.dataset.series === key.dataset.series;
  const curves = () => [...document.querySelectorAll('.plot .series')];

  const toggle = () => {
    const shown = key.getAttribute('aria-pressed') !== 'true';
    for (const other of document.querySelectorAll('.plot .key'))
      if (own(other)) other.setAttribute('aria-pressed', String(shown));
    for (const curve of curves().filter(own)) curve.classList.toggle('hidden', !shown);
  };
  const fade = (on) => {
    for (const curve of curves()) curve.classList.toggle('faded', on && !own(curve));
  };

  key.addEventListener('click', toggle);
  key.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    toggle();
  });
  key.addEventListener('pointerenter', () => fade(true));
  key.addEventListener('pointerleave', () => fade(false));
}
