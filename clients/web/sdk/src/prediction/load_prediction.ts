// Brings the predictor, which is fetched only when somebody wants it.

import type { FrameBuffer } from '../frame_buffer';
import { PredictionController } from './prediction_controller';
import { compile, Predictor } from './predictor';
import wasmUrl from './predictor.wasm?url';

/** A PredictorError says why there is none. `failed` hears of what goes wrong later. */
export async function loadPrediction(frames: FrameBuffer, failed: (error: unknown) => void): Promise<PredictionController> {
  const predictor = await Predictor.create(await compile(fetch(wasmUrl)));
  return new PredictionController(predictor, frames, failed);
}
