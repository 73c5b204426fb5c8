using StandIns;

namespace UnityEngine;

/// <summary>Somebody uses an object that is destroyed.</summary>
public class MissingReferenceException(string message) : SystemException(message) { }

/// <summary>Equal to null once it is destroyed, though the reference is not.</summary>
public partial class Object
{
    static int s_lastId;
    readonly int m_id = Interlocked.Increment(ref s_lastId);
    string m_name = "";
    HideFlags m_hideFlags;
    bool m_isDestroyed;

    public string name
    {
        get => There(m_name);
        set
        {
            CheckIsThere();
            m_name = value;
        }
    }

    public HideFlags hideFlags
    {
        get => There(m_hideFlags);
        set
        {
            CheckIsThere();
            m_hideFlags = value;
        }
    }

#if UNITY_6000_3_OR_NEWER
    public EntityId GetEntityId() => There(new EntityId { Id = m_id });
#else
    public int GetInstanceID() => There(m_id);
#endif

    internal int Id => m_id;
    internal bool IsDestroyed => m_isDestroyed;

    /// <summary>At the frame's end, in play mode; in edit mode it is refused.</summary>
    public static void Destroy(Object obj)
    {
        if (!Application.isPlaying)
            Debug.LogError("Destroy may not be called from edit mode! Use DestroyImmediate instead.");
        else
            SceneLoop.DestroyLater(obj);
    }

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
    public override string ToString() => m_isDestroyed ? "null" : $"{m_name} ({GetType().FullName})";

    /// <summary>Its own fields can be read after it was destroyed; what the engine keeps of it is gone.</summary>
    internal void CheckIsThere()
    {
        if (m_isDestroyed)
            throw new MissingReferenceException("The object of type '" + GetType().FullName +
                "' has been destroyed but you are still trying to access it.");
    }

    internal T There<T>(T value)
    {
        CheckIsThere();
        return value;
    }

    /// <summary>Whether it is null or destroyed. An asset that is destroyed may have come back, which only the main thread
    /// can tell; where the object is all there is of it, it cannot.</summary>
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

    internal virtual void OnDestroyed() { }
}
