// SPDX-License-Identifier: MIT
// The reasons to be slow, as people read them: names, explanations and colours.

interface LimitLook {
  name: string;
  colour: string;
  meaning: string;
}

// The first eight colours are those of Okabe and Ito (2008), which all kinds of colour blindness
// keep apart; rare limits have darker ones of Tol's muted scheme.
const LOOKS: Record<string, LimitLook> = {
  feed: {
    name: 'programmed feed',
    colour: '#009e73',
    meaning: 'the tool moves as fast as the program asks'
  },
  acceleration:
      {name: 'acceleration', colour: '#d55e00', meaning: 'an axis reaches its acceleration limit'},
  jerk: {name: 'jerk', colour: '#cc79a7', meaning: 'an axis reaches its jerk limit'},
  axis_velocity:
      {name: 'axis velocity', colour: '#0072b2', meaning: 'an axis reaches its velocity limit'},
  corner: {
    name: 'corner',
    colour: '#e69f00',
    meaning: 'a change of direction must be slow, or at rest'
  },
  chord: {
    name: 'chord error',
    colour: '#56b4e9',
    meaning: 'the step of one period must stay within the chord tolerance'
  },
  contour: {
    name: 'contour error',
    colour: '#999933',
    meaning: 'what the drives leave must stay within the contour tolerance'
  },
  rapid: {name: 'rapid', colour: '#8c8c8c', meaning: 'a rapid at the velocity limits of the axes'},
  roughness: {
    name: 'roughness',
    colour: '#f0e442',
    meaning: 'a higher feed would leave more than the Rmax asked for'
  },
  pulse_rate: {
    name: 'pulse rate',
    colour: '#332288',
    meaning: 'an axis would need more pulses per second than it may have'
  },
  drive: {
    name: 'drive',
    colour: '#ddcc77',
    meaning: 'a motor reaches the current or the voltage of its drive'
  },
  tangential: {
    name: 'tangential acceleration',
    colour: '#882255',
    meaning: 'the limit of acceleration along the path'
  },
  normal: {
    name: 'normal acceleration',
    colour: '#44aa99',
    meaning: 'the limit of acceleration across the path'
  },
  custom: {name: 'custom', colour: '#aa4499', meaning: 'a constraint that a program has added'},
  override: {name: 'feed override', colour: '#117733', meaning: 'the override is below 100 %'},
  hold: {name: 'feed hold', colour: '#661100', meaning: 'the operator holds the feed'},
  stop: {
    name: 'standstill',
    colour: '#555555',
    meaning: 'dwells, rests, and the start and end of moves'
  },
};

export function limitName(limit: string): string {
  return LOOKS[limit]?.name ?? limit.replace(/_/g, ' ');
}

export function limitColour(limit: string): string {
  return LOOKS[limit]?.colour ?? '#aaaaaa';
}

export function limitMeaning(limit: string): string {
  return LOOKS[limit]?.meaning ?? '';
}
