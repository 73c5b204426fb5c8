using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
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

        /// <summary>Nothing here keeps a list of a scene's objects.</summary>
        public static GameObject Find(string name) => throw new System.NotSupportedException("there are no scenes here to find " + name + " in");

        /// <summary>Without its mesh.</summary>
        public static GameObject CreatePrimitive(PrimitiveType type) => new GameObject(type.ToString());

        public T AddComponent<T>() where T : Component
        {
            foreach (var required in typeof(T).GetCustomAttributes<RequireComponent>())
                if (m_components.Find(required.m_Type0.IsInstanceOfType) == null)
                    Add((Component)Activator.CreateInstance(required.m_Type0));
            return (T)Add(Activator.CreateInstance<T>());
        }

        public T GetComponent<T>() => m_components.Find(c => c is T) is T found ? found : default;

        /// <summary>Objects have no children here: its own.</summary>
        public T[] GetComponentsInChildren<T>(bool includeInactive) =>
            includeInactive || activeSelf ? m_components.OfType<T>().ToArray() : new T[0];

        Component Add(Component component)
        {
            component.gameObject = this;
            m_components.Add(component);
            if (component is Behaviour behaviour)
            {
                SceneLoop.Refresh(behaviour);
                SceneLoop.Added(behaviour);
            }
            return component;
        }

        internal override void OnDestroyed()
        {
            foreach (var component in m_components)
                DestroyImmediate(component);
        }
    }
}
