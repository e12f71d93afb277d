import { describe, expect, it } from 'vitest';
import { axisOf } from './axis_ticks';
import { formatValue } from './line_plot';
import { SERIES_POINTS_MAX, seriesToCsv, TimeSeries } from './time_series';

describe('TimeSeries', () => {
  it('drops samples that are older than its length', () => {
    const series = new TimeSeries('Speed', 'm/s', 10);
    for (let second = 0; second <= 30; second++) series.add(second, second * second);
    expect(series.points.map(({ seconds }) => seconds)).toEqual([20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30]);
  });

  it('stores at most 4096 samples and ignores numbers that are not finite', () => {
    const series = new TimeSeries('Speed', 'm/s', 1e9);
    for (let k = 0; k < 5000; k++) series.add(k, 1);
    series.add(6000, NaN);
    expect(series.points.length).toBe(SERIES_POINTS_MAX);
    expect(series.newest).toEqual({ seconds: 4999, value: 1 });
  });

  it('begins again after a rewind', () => {
    const series = new TimeSeries('Height', 'm', 60);
    for (const seconds of [1, 2, 3]) series.add(seconds, 5);
    series.add(1.5, 7);
    expect(series.points).toEqual([{ seconds: 1.5, value: 7 }]);
  });

  it('finds the sample closest to a time', () => {
    const series = new TimeSeries('Height', 'm', 60);
    for (const seconds of [1, 2, 4]) series.add(seconds, 10 * seconds);
    expect([0, 1.4, 1.6, 2.9, 3.1, 9].map((seconds) => series.at(seconds)?.value)).toEqual([10, 10, 20, 20, 40, 40]);
  });
});

describe('seriesToCsv', () => {
  it('has one row per time, with empty cells, units and quoted names', () => {
    const height = new TimeSeries('Height, above "0"', 'm', 60);
    const contacts = new TimeSeries('Contacts', '', 60);
    height.add(0.5, 1.25);
    height.add(1, 1.5);
    contacts.add(1, 3);
    contacts.add(1.5, 4);
    expect(seriesToCsv([height, contacts])).toBe('time (s),"Height, above ""0"" (m)",Contacts\r\n0.5,1.25,\r\n1,1.5,3\r\n1.5,,4\r\n');
  });
});

describe('axisOf', () => {
  it('covers the values with round steps', () => {
    expect(axisOf(0.3, 8.7, 3)).toEqual({ min: 0, max: 10, ticks: [0, 5, 10], digits: 0 });
    expect(axisOf(-0.012, 0.031, 5).ticks.map((tick) => tick.toFixed(2))).toEqual(['-0.02', '-0.01', '0.00', '0.01', '0.02', '0.03', '0.04']);
  });

  it('has a range for a constant value', () => {
    const { min, max } = axisOf(9.81, 9.81, 3);
    expect(min).toBeLessThan(9.81);
    expect(max).toBeGreaterThan(9.81);
  });
});

it('formatValue has four significant digits', () => {
  expect([0, 0.01234567, 3.14159, 123.456, 98765.4, 1.5e9].map(formatValue)).toEqual(['0', '0.01235', '3.142', '123.5', '98765', '1.50e+9']);
});
