export { loadPrediction } from './load_prediction.js';
export { PredictionController } from './prediction_controller.js';
export { PredictorError, type PredictorStats } from './predictor.js';
