using System;
using System.Diagnostics;
using System.Threading;
using StandIns;

namespace UnityEngine
{
    /// <summary>Equal to null once it is destroyed, though the reference is not.</summary>
    public class Object
    {
        static int s_lastId;
        readonly int m_id = Interlocked.Increment(ref s_lastId);
        bool m_isDestroyed;

        public string name { get; set; } = "";

        public HideFlags hideFlags { get; set; }

        internal int Id => m_id;

        internal bool IsDestroyed => m_isDestroyed;

        /// <summary>Unity waits for the frame's end; nothing here goes before the device is done with it anyway.</summary>
        public static void Destroy(Object obj) => DestroyImmediate(obj, false);

        public static void DestroyImmediate(Object obj) => DestroyImmediate(obj, false);

        public static void DestroyImmediate(Object obj, bool allowDestroyingAssets)
        {
            if (obj is null || obj.m_isDestroyed)
                return;
            obj.OnDestroyed();
            obj.m_isDestroyed = true;
        }

        public static bool operator ==(Object x, Object y)
        {
            if (x is null || y is null)
                return IsGone(x) && IsGone(y);
            return ReferenceEquals(x, y);
        }

        public static bool operator !=(Object x, Object y) => !(x == y);

        public static implicit operator bool(Object exists) => exists != null;

        public override bool Equals(object other) => other is Object o ? this == o : other is null && m_isDestroyed;

        public override int GetHashCode() => m_id;

        public override string ToString() => $"{name} ({GetType().FullName})";

        /// <summary>Whether it is null or destroyed. An asset that is destroyed may have come back, which only the main thread can
        /// tell; where the object is all there is of it, it cannot.</summary>
        static bool IsGone(Object obj)
        {
            if (obj is null)
                return true;
            if (!obj.m_isDestroyed)
                return false;
            if (!(obj is MonoBehaviour || obj is ScriptableObject))
                CheckThread();
            return true;
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        static void CheckThread()
        {
            if (!MainThread.IsCurrent)
                throw new InvalidOperationException("EnsureRunningOnMainThread can only be called from the main thread");
        }

        internal virtual void OnDestroyed()
        {
        }
    }
}
