using System;
using System.Threading;
using FastPoints.Core;

namespace FastPoints.Build
{
    /// <summary>One file that waits to be written to disk.</summary>
    internal sealed class WriteTicket
    {
        readonly object m_lock = new object();
        readonly Action m_stopRetrying;
        bool m_isDone;
        Exception m_failure;

        /// <param name="stopRetrying">Called where somebody waits for what is not done yet.</param>
        public WriteTicket(Action stopRetrying) => m_stopRetrying = stopRetrying;

        /// <summary>Whether the file is complete on disk; waits at most this long for it.</summary>
        /// <exception cref="Base.PointCloudException">It could not be written.</exception>
        public bool IsDone(int waitMs)
        {
            lock (m_lock)
            {
                if (!m_isDone && waitMs > 0)
                    Monitor.Wait(m_lock, waitMs);
                if (m_failure != null)
                    throw m_failure;
                return m_isDone;
            }
        }

        /// <summary>Waits until the bytes are no longer needed, written or not. It throws nothing, so that it suits
        /// clean-up: what the system refuses is not tried again meanwhile.</summary>
        public void Wait()
        {
            lock (m_lock)
            {
                if (!m_isDone)
                    m_stopRetrying();
                while (!m_isDone)
                    Monitor.Wait(m_lock);
            }
        }

        internal void Finish(Exception failure)
        {
            lock (m_lock)
            {
                m_failure = failure;
                m_isDone = true;
                Monitor.PulseAll(m_lock);
            }
        }
    }
}
