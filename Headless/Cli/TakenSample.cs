using System;
using System.Collections.Generic;
using FastPoints.Points;
using FastPoints.Preview;

namespace FastPoints.Cli
{
    /// <summary>A sample that is to be measured: beginnings of one batch, each there after some seconds.</summary>
    public sealed class TakenSample(PointBatch points, PositionTransform transform, IReadOnlyList<SampleWave> waves) : IDisposable
    {
        public PointBatch Points { get; } = points;
        public PositionTransform Transform { get; } = transform;

        /// <summary>Seconds are from the open call.</summary>
        public IReadOnlyList<SampleWave> Waves { get; } = waves;

        /// <summary>Until all of it was there.</summary>
        public double Seconds => Waves.Count == 0 ? 0 : Waves[^1].Seconds;

        public void Dispose() => Points.Dispose();
    }
}
