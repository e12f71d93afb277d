import { expect, it } from 'vitest';
import { bannerText } from './pause_banner';

it('names the reason of a pause', () => {
  expect(bannerText({ paused: 'by an operator', timeScale: 0 })).toBe('This world is paused: by an operator');
});

it('shows the speed of a world that falls behind by more than 5 %', () => {
  expect(bannerText({ paused: '', timeScale: 0.714 })).toBe('The server is overloaded: this world runs at 71 % of its speed');
  expect(bannerText({ paused: '', timeScale: 0.96 })).toBe('');
  expect(bannerText({ paused: '', timeScale: 1 })).toBe('');
});
