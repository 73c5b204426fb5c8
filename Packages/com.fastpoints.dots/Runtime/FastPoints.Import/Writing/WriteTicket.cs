using System;
using System.Threading;

namespace FastPoints.Writing
{
    /// <summary>One file that is on its way to the disk.</summary>
    internal sealed class WriteTicket
    {
        readonly object m_lock = new object();
        bool m_isDone;
        Exception m_failure;

        /// <summary>Whether the file is complete on disk; waits at most so long for it.</summary>
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

        /// <summary>Until the bytes are no longer needed, written or not. Throws nothing: for clearing up.</summary>
        public void Wait()
        {
            lock (m_lock)
                while (!m_isDone)
                    Monitor.Wait(m_lock);
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
