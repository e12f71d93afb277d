import { describe, expect, it } from 'vitest';
import { duration, Rates, shortNumber } from './rates';

describe('Rates', () => {
  it('divides the growth of each counter by the elapsed time', () => {
    const rates = new Rates();
    expect(rates.read([{ name: 'poses', value: 500 }], 10)).toEqual([{ name: 'poses', total: 500, perSecond: 0 }]);
    expect(rates.read([{ name: 'poses', value: 800 }], 12)).toEqual([{ name: 'poses', total: 800, perSecond: 150 }]);
  });

  it('is 0 after the server restarted', () => {
    const rates = new Rates();
    rates.read([{ name: 'poses', value: 500 }], 10);
    expect(rates.read([{ name: 'poses', value: 20 }], 11)[0]?.perSecond).toBe(0);
    expect(rates.read([{ name: 'poses', value: 30 }], 12)[0]?.perSecond).toBe(10);
  });
});

describe('text of numbers', () => {
  it('has three digits and a unit', () => {
    expect([0, 7, 999, 1234, 12345, 123456, 1234567, 0.5].map(shortNumber)).toEqual(['0', '7', '999', '1.23 k', '12.3 k', '123 k', '1.23 M', '0.50']);
  });

  it('has the two largest units of a duration', () => {
    expect([5, 75, 3700, 93784].map(duration)).toEqual(['5 s', '1 min 15 s', '1 h 1 min', '1 d 2 h']);
  });
});
