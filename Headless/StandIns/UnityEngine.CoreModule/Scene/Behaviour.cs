using StandIns.Scene;

namespace UnityEngine
{
    public class Behaviour : Component
    {
        bool m_enabled = true;

        public bool enabled
        {
            get => m_enabled;
            set
            {
                m_enabled = value;
                SceneLoop.Refresh(this);
            }
        }

        public bool isActiveAndEnabled => m_enabled && !IsDestroyed && gameObject.activeSelf;

        /// <summary>Whether it was told that it is enabled.</summary>
        internal bool IsTold { get; set; }

        internal override void OnDestroyed()
        {
            m_enabled = false;
            SceneLoop.Refresh(this);
            SceneLoop.Send(this, "OnDestroy");
            SceneLoop.Forget(this);
        }
    }

    public class MonoBehaviour : Behaviour
    {
    }
}
