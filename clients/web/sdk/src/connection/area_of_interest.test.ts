import { describe, expect, it } from 'vitest';
import { areaOfInterestFromQuery } from './area_of_interest.js';

describe('what a viewer asks to be told', () => {
  it('is all of the world unless its address says otherwise', () => {
    expect(areaOfInterestFromQuery('?world=yard')).toBeUndefined();
    expect(areaOfInterestFromQuery('?sight=150')).toEqual({ radius: 150, maxKbps: 0 });
    expect(areaOfInterestFromQuery('?kbps=500&sight=x')).toEqual({ radius: 0, maxKbps: 500 });
  });

  it('leaves out what a server would refuse', () => {
    for (const search of ['?sight=-3', '?sight=0.5', '?kbps=3', '?kbps=NaN', '?sight=1e9'])
      expect(areaOfInterestFromQuery(search), search).toBeUndefined();
  });
});
