using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Drawing
{
    /// <summary>A GPU that takes a time for other work and one for each point, and is measured four frames late.</summary>
    public class PointsPerFrameControllerTests
    {
        const float TargetMs = 10;
        const int LatencyFrames = 4; // Of Unity's FrameTimingManager.
        const int SettlingFrames = 240; // Frames after a change: four seconds at 60 Hz.

        sealed class SimulatedGpu
        {
            public double OtherMs = 2, MsPerMillion = 4, Power = 1;
            public double Noise; // Standard deviation, as a share of the time.
            public double SpikeShare; // Of the frames that take five times as long.
            public int MaxPoints = 100_000_000;
            public PointsPerFrameController Controller;
            readonly Queue<int> m_inFlight = new Queue<int>();
            Unity.Mathematics.Random m_random = new Unity.Mathematics.Random(7);

            public double TimeOf(int points) => OtherMs + MsPerMillion * math.pow(points * 1e-6, Power);

            public double TimeNow => TimeOf(Controller.Points);

            public void Draw()
            {
                m_inFlight.Enqueue(Controller.Points);
                if (m_inFlight.Count <= LatencyFrames)
                    return;
                double normal = math.sqrt(-2 * math.log(m_random.NextDouble(1e-9, 1))) *
                    math.cos(2 * math.PI_DBL * m_random.NextDouble());
                double ms = TimeOf(m_inFlight.Dequeue()) * math.max(0.1, 1 + Noise * normal);
                Controller.Add((float)(m_random.NextDouble() < SpikeShare ? 5 * ms : ms), TargetMs, MaxPoints);
            }

            public void Draw(int frames)
            {
                for (int frame = 0; frame < frames; frame++)
                    Draw();
            }
        }

        static SimulatedGpu Gpu(int points, double noise = 0, double spikes = 0, double power = 1) => new SimulatedGpu
        {
            Controller = new PointsPerFrameController(points),
            Noise = noise,
            SpikeShare = spikes,
            Power = power,
        };

        [TestCase(100_000, 0, 0, 1)]
        [TestCase(20_000_000, 0, 0, 1)]
        [TestCase(2_000_000, 0.05, 0, 1)]
        [TestCase(500_000, 0.1, 0.05, 1)]
        [TestCase(500_000, 0.02, 0.1, 1)]
        [TestCase(20_000_000, 0.05, 0.02, 0.6)]
        [TestCase(1_000_000, 0.05, 0.02, 1.6)]
        public void Add_NoisyTimes_HoldsTheTargetWithinATenth(int points, double noise, double spikes, double power)
        {
            var gpu = Gpu(points, noise, spikes, power);
            gpu.Draw(SettlingFrames);
            for (int frame = 0; frame < 1000; frame++)
            {
                gpu.Draw();
                Assert.That(gpu.TimeNow, Is.EqualTo(TargetMs).Within(0.1 * TargetMs), "frame " + frame);
            }
        }

        [TestCase(1)]
        [TestCase(1.6)]
        public void Add_GpuSlowsDown_ConvergesWithoutOscillation(double power)
        {
            var gpu = Gpu(2_000_000, power: power);
            gpu.Draw(SettlingFrames);
            gpu.MsPerMillion *= 2;
            int turns = 0, last = gpu.Controller.Points, direction = -1;
            for (int frame = 0; frame < SettlingFrames; frame++)
            {
                gpu.Draw();
                int change = Math.Sign(gpu.Controller.Points - last);
                turns += change != 0 && change != direction ? 1 : 0;
                direction = change != 0 ? change : direction;
                last = gpu.Controller.Points;
            }
            Assert.That(turns, Is.Zero, "the number of points went back up");
            Assert.That(gpu.TimeNow, Is.EqualTo(TargetMs).Within(0.1 * TargetMs));
            int atRest = gpu.Controller.Points;
            gpu.Draw(1000);
            Assert.That(gpu.Controller.Points, Is.EqualTo(atRest));
        }

        [Test]
        public void Add_SpikesOfFourFrames_ChangeNothing()
        {
            var controller = new PointsPerFrameController(1_000_000);
            for (int frame = 0; frame < 900; frame++)
                controller.Add(frame % 9 < 4 ? 100 : TargetMs, TargetMs, int.MaxValue);
            Assert.That(controller.Points, Is.EqualTo(1_000_000));
        }

        [Test]
        public void Add_OtherWorkTakesTheTime_StopsAtMinPoints()
        {
            var gpu = Gpu(2_000_000);
            gpu.OtherMs = 20;
            gpu.Draw(1000);
            Assert.That(gpu.Controller.Points, Is.EqualTo(PointsPerFrameController.MinPoints));
            gpu.OtherMs = 2;
            gpu.Draw(2 * SettlingFrames);
            Assert.That(gpu.TimeNow, Is.EqualTo(TargetMs).Within(0.1 * TargetMs));
        }

        [Test]
        public void Add_NoMorePointsToDraw_StopsAtMaxPoints()
        {
            var gpu = Gpu(100_000);
            gpu.MaxPoints = 500_000;
            gpu.Draw(1000);
            Assert.That(gpu.Controller.Points, Is.EqualTo(500_000));
        }
    }
}
