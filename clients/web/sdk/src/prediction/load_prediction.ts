import type { FrameBuffer } from '../interpolation/frame_buffer.js';
import { PredictionController } from './prediction_controller.js';
import { compile, Predictor } from './predictor.js';

/**
 * URL of predictor.wasm in this package. Bundlers that support `new URL(..., import.meta.url)` copy the
 * file.
 */
export const predictorUrl = new URL('./predictor.wasm', import.meta.url);

/**
 * Loads the predictor; pass the controller to Connection.enablePrediction(). Throws PredictorError if
 * that fails. `onFailure` is called if the predictor fails later; nothing is predicted afterwards.
 * `module`: the bytes of predictor.wasm, where `fetch` cannot read predictorUrl.
 */
export async function loadPrediction(
  frames: FrameBuffer,
  onFailure: (error: unknown) => void,
  module?: BufferSource,
): Promise<PredictionController> {
  const predictor = await Predictor.create(await compile(module ?? fetch(predictorUrl)));
  return new PredictionController(predictor, frames, onFailure);
}
