using System.Threading;

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
            bool noX = x is null || x.m_isDestroyed, noY = y is null || y.m_isDestroyed;
            return noX || noY ? noX && noY : ReferenceEquals(x, y);
        }

        public static bool operator !=(Object x, Object y) => !(x == y);

        public static implicit operator bool(Object exists) => exists != null;

        public override bool Equals(object other) => other is Object o ? this == o : other is null && m_isDestroyed;

        public override int GetHashCode() => m_id;

        public override string ToString() => $"{name} ({GetType().FullName})";

        internal virtual void OnDestroyed()
        {
        }
    }
}
