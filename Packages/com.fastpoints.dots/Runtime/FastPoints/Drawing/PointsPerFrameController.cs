using Unity.Mathematics;

namespace FastPoints.Drawing
{
    // A feedback controller of the points that a frame may draw, so that the GPU takes a given time. Measured times come late,
    // are noisy, have spikes and a part that no points cause, so the number changes by less than the error asks for, and
    // seldom.
    internal unsafe struct PointsPerFrameController
    {
        public const int MinPoints = 10_000;
        const int Window = 9; // Of times whose median counts: four frames from before a change, or spikes, do not move it.
        const float DeadBand = 0.04f; // Errors of this share of the time are left alone.
        const float Damping = 0.6f; // Exponent of a step: converges for any time that grows slower than the points' third power.
        const float MaxStep = 1.5f;

        fixed float m_times[Window]; // In order.
        int m_count;

        public PointsPerFrameController(int points) : this() => Points = points;

        public int Points { get; private set; }

        // A frame's time. With more than maxPoints a frame would draw no more.
        public void Add(float gpuMs, float targetMs, int maxPoints)
        {
            int at = m_count++;
            for (; at > 0 && m_times[at - 1] > gpuMs; at--)
                m_times[at] = m_times[at - 1];
            m_times[at] = gpuMs;
            if (m_count < Window)
                return;
            float wanted = targetMs / m_times[Window / 2];
            m_count = 0;
            if (math.abs(wanted - 1) <= DeadBand)
                return;
            float step = math.clamp(math.pow(wanted, Damping), 1 / MaxStep, MaxStep);
            Points = (int)math.clamp((double)Points * step, MinPoints, math.max(MinPoints, maxPoints));
        }
    }
}
