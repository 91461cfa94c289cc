/** `optimal` finds the shortest path. `ta` and `tra` take less time and may find longer paths. */
export type PathAlgorithm = 'ta' | 'tra' | 'optimal';
export type PathStatus = 'found' | 'start-blocked' | 'goal-blocked' | 'no-path';
export type PieceKind = 'line' | 'arc';
export type SvgTheme = 'automatic' | 'light' | 'dark';

export const PATH_ALGORITHMS = ['ta', 'tra', 'optimal'] as const;
export const PATH_STATUSES = ['found', 'start-blocked', 'goal-blocked', 'no-path'] as const;
export const PIECE_KINDS = ['line', 'arc'] as const;
export const SVG_THEMES = ['automatic', 'light', 'dark'] as const;
