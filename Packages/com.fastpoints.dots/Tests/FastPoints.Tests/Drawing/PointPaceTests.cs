using System;
using System.Collections.Generic;
using FastPoints.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Drawing
{
    /// <summary>A GPU that takes a time for other work and one for each point, and is measured four frames late.</summary>
    public class PointPaceTests
    {
        const float TargetMs = 10;
        const int LatencyFrames = 4; // Of Unity's FrameTimingManager.
        const int Settled = 240; // Frames after a change: four seconds at 60 Hz.

        sealed class SimulatedCard
        {
            public double OtherMs = 2, MsPerMillion = 4, Power = 1;
            public double Noise; // Standard deviation, as a share of the time.
            public double SpikeShare; // Of the frames that take five times as long.
            public int MaxPoints = 100_000_000;
            public PointPace Pace;
            readonly Queue<int> m_inFlight = new Queue<int>();
            Unity.Mathematics.Random m_random = new Unity.Mathematics.Random(7);

            public double TimeOf(int points) => OtherMs + MsPerMillion * math.pow(points * 1e-6, Power);

            public double TimeNow => TimeOf(Pace.Points);

            public void Draw()
            {
                m_inFlight.Enqueue(Pace.Points);
                if (m_inFlight.Count <= LatencyFrames)
                    return;
                double normal = math.sqrt(-2 * math.log(m_random.NextDouble(1e-9, 1))) *
                    math.cos(2 * math.PI_DBL * m_random.NextDouble());
                double ms = TimeOf(m_inFlight.Dequeue()) * math.max(0.1, 1 + Noise * normal);
                Pace.Add((float)(m_random.NextDouble() < SpikeShare ? 5 * ms : ms), TargetMs, MaxPoints);
            }

            public void Draw(int frames)
            {
                for (int frame = 0; frame < frames; frame++)
                    Draw();
            }
        }

        static SimulatedCard Card(int points, double noise = 0, double spikes = 0, double power = 1) => new SimulatedCard
        {
            Pace = new PointPace(points),
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
        public void Add_ACardsTimes_HoldsTheTargetWithinATenth(int points, double noise, double spikes, double power)
        {
            var card = Card(points, noise, spikes, power);
            card.Draw(Settled);
            for (int frame = 0; frame < 1000; frame++)
            {
                card.Draw();
                Assert.That(card.TimeNow, Is.EqualTo(TargetMs).Within(0.1 * TargetMs), "frame " + frame);
            }
        }

        [TestCase(1)]
        [TestCase(1.6)]
        public void Add_ACardHalfAsFast_ComesToRestWithoutOscillation(double power)
        {
            var card = Card(2_000_000, power: power);
            card.Draw(Settled);
            card.MsPerMillion *= 2;
            int turns = 0, last = card.Pace.Points, direction = -1;
            for (int frame = 0; frame < Settled; frame++)
            {
                card.Draw();
                int change = Math.Sign(card.Pace.Points - last);
                turns += change != 0 && change != direction ? 1 : 0;
                direction = change != 0 ? change : direction;
                last = card.Pace.Points;
            }
            Assert.That(turns, Is.Zero, "the number of points went back up");
            Assert.That(card.TimeNow, Is.EqualTo(TargetMs).Within(0.1 * TargetMs));
            int atRest = card.Pace.Points;
            card.Draw(1000);
            Assert.That(card.Pace.Points, Is.EqualTo(atRest));
        }

        [Test]
        public void Add_SpikesOfFourFrames_ChangeNothing()
        {
            var pace = new PointPace(1_000_000);
            for (int frame = 0; frame < 900; frame++)
                pace.Add(frame % 9 < 4 ? 100 : TargetMs, TargetMs, int.MaxValue);
            Assert.That(pace.Points, Is.EqualTo(1_000_000));
        }

        [Test]
        public void Add_OtherWorkTakesTheTime_StopsAtTheFewest()
        {
            var card = Card(2_000_000);
            card.OtherMs = 20;
            card.Draw(1000);
            Assert.That(card.Pace.Points, Is.EqualTo(PointPace.MinPoints));
            card.OtherMs = 2;
            card.Draw(2 * Settled);
            Assert.That(card.TimeNow, Is.EqualTo(TargetMs).Within(0.1 * TargetMs));
        }

        [Test]
        public void Add_NoMorePointsToDraw_DoesNotRunAway()
        {
            var card = Card(100_000);
            card.MaxPoints = 500_000;
            card.Draw(1000);
            Assert.That(card.Pace.Points, Is.EqualTo(500_000));
        }
    }
}
