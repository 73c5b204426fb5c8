using System;
using System.Collections.Generic;
using StandIns.Scene;

namespace UnityEngine
{
    public sealed class GameObject : Object
    {
        readonly List<Component> m_components = new List<Component>();

        public GameObject(string name)
        {
            this.name = name;
            transform = new Transform { gameObject = this };
            m_components.Add(transform);
        }

        public Transform transform { get; }

        public bool activeSelf { get; private set; } = true;

        public void SetActive(bool value)
        {
            activeSelf = value;
            foreach (var component in m_components)
                if (component is Behaviour behaviour)
                    SceneLoop.Refresh(behaviour);
        }

        public T AddComponent<T>() where T : Component
        {
            var component = Activator.CreateInstance<T>();
            component.gameObject = this;
            m_components.Add(component);
            if (component is Behaviour behaviour)
                SceneLoop.Refresh(behaviour);
            return component;
        }

        public T GetComponent<T>() => m_components.Find(c => c is T) is T found ? found : default;

        internal override void OnDestroyed()
        {
            foreach (var component in m_components)
                DestroyImmediate(component);
        }
    }
}
