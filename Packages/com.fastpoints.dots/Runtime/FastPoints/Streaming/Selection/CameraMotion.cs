using System;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    internal sealed class CameraMotion : IDisposable
    {
        // A step this many times as long as the one before is a cut, not a motion.
        const double MaxSpeedUp = 4;

        NativeList<StreamView> m_last = new NativeList<StreamView>(Allocator.Persistent);
        NativeList<StreamView> m_predicted = new NativeList<StreamView>(Allocator.Persistent);
        double m_lastStep;

        public NativeArray<StreamView> Predicted => m_predicted.AsArray();

        // False if the views stand still, cut, or changed in number.
        public bool TryPredictView(NativeArray<StreamView> views, int frames)
        {
            double step = 0;
            bool isKnown = views.Length == m_last.Length && frames > 0;
            m_predicted.Clear();
            for (int v = 0; v < views.Length && isKnown; v++)
            {
                var view = views[v];
                var motion = view.EyeWorld - m_last[v].EyeWorld;
                // A light's moves with the cameras, but by leaps.
                if (view.IsLight)
                    motion = 0;
                step = math.max(step, math.length(motion));
                view.EyeWorld += motion * frames;
                m_predicted.Add(view);
            }
            m_last.Clear();
            m_last.AddRange(views);
            bool isMoving = isKnown && step > 0 && step <= MaxSpeedUp * m_lastStep;
            m_lastStep = step;
            return isMoving;
        }

        public void Dispose()
        {
            if (!m_last.IsCreated)
                return;
            m_last.Dispose();
            m_predicted.Dispose();
        }
    }
}
