using System.Collections.Generic;
using System.Reflection;
using UnityEngine;

namespace StandIns.Scene
{
    /// <summary>What the engine's loop tells behaviours, as in an editor that does not play: those that are ExecuteAlways, and no
    /// others.</summary>
    static class SceneLoop
    {
        static readonly List<Behaviour> s_told = new List<Behaviour>();

        /// <summary>One Update of all that are enabled.</summary>
        public static void Update()
        {
            for (int i = 0; i < s_told.Count; i++)
                Send(s_told[i], "Update");
        }

        /// <summary>As if somebody had moved it.</summary>
        public static void Place(Transform transform, Matrix4x4 localToWorld) => transform.localToWorldMatrix = localToWorld;

        internal static T[] Find<T>() where T : Object
        {
            var found = new List<T>();
            foreach (var behaviour in s_told)
                if (behaviour is T wanted)
                    found.Add(wanted);
            return found.ToArray();
        }

        internal static void Refresh(Behaviour behaviour)
        {
            bool isOn = behaviour.isActiveAndEnabled;
            if (isOn == behaviour.IsTold || behaviour.GetType().GetCustomAttribute<ExecuteAlways>() == null)
                return;
            behaviour.IsTold = isOn;
            if (isOn)
                s_told.Add(behaviour);
            else
                s_told.Remove(behaviour);
            Send(behaviour, isOn ? "OnEnable" : "OnDisable");
        }

        internal static void Forget(Behaviour behaviour) => s_told.Remove(behaviour);

        internal static void Send(Behaviour behaviour, string message) => behaviour.GetType().GetMethod(message,
            BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)?.Invoke(behaviour, null);
    }
}
