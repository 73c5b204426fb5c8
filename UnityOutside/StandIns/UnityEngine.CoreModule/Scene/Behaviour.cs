namespace UnityEngine;

public class Behaviour : Component
{
    bool m_enabled = true;

    public bool enabled
    {
        get
        {
            CheckIsThere();
            return m_enabled;
        }
        set
        {
            CheckIsThere();
            m_enabled = value;
            SceneLoop.Refresh(this);
        }
    }

    public bool isActiveAndEnabled => enabled && gameObject.activeInHierarchy;
    internal bool IsAwake { get; set; }
    internal bool IsTold { get; set; }
    internal bool IsStarted { get; set; }

    internal override void OnDestroyed()
    {
        m_enabled = false;
        SceneLoop.Refresh(this);
        // What never woke is not told that it goes.
        if (IsAwake)
            SceneLoop.Send(this, "OnDestroy");
    }
}

public class MonoBehaviour : Behaviour { }
