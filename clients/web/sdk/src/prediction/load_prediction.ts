import type { FrameBuffer } from '../interpolation/frame_buffer.js';
import { PredictionController } from './prediction_controller.js';
import { compile, Predictor } from './predictor.js';

/** Where this package has the WebAssembly module; bundlers that understand `new URL(..., import.meta.url)` copy it. */
export const predictorUrl = new URL('./predictor.wasm', import.meta.url);

/** A PredictorError says why there is none. `failed` hears of what goes wrong later. */
export async function loadPrediction(frames: FrameBuffer, failed: (error: unknown) => void): Promise<PredictionController> {
  const predictor = await Predictor.create(await compile(fetch(predictorUrl)));
  return new PredictionController(predictor, frames, failed);
}
