// Client-side prediction. Its own entry point, so that applications without prediction do not load it.

export { loadPrediction, predictorUrl } from './load_prediction.js';
export { PredictionController } from './prediction_controller.js';
export { PredictorError, type PredictorStats } from './predictor.js';
