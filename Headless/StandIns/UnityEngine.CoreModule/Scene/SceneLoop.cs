using System.Collections.Generic;
using System.Reflection;
using UnityEngine;

namespace StandIns.Scene
{
    /// <summary>What the engine's loop tells behaviours: in an editor that does not play, those that are ExecuteAlways, and no
    /// others.</summary>
    static class SceneLoop
    {
        static readonly List<Behaviour> s_told = new List<Behaviour>();

        /// <summary>Whether behaviours that are made from now on are told whatever they are, as in play mode. Nothing else
        /// changes.</summary>
        public static bool TellsAll { get; set; }

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
            if (isOn == behaviour.IsTold || !(behaviour.IsTold || TellsAll || IsToldAlways(behaviour)))
                return;
            behaviour.IsTold = isOn;
            if (isOn)
                s_told.Add(behaviour);
            else
                s_told.Remove(behaviour);
            Send(behaviour, isOn ? "OnEnable" : "OnDisable");
        }

        /// <summary>An editor that does not play has a component that was added just now set itself up.</summary>
        internal static void Added(Behaviour behaviour)
        {
            if (!TellsAll)
                Send(behaviour, "Reset");
        }

        static bool IsToldAlways(Behaviour behaviour) => behaviour.GetType().GetCustomAttribute<ExecuteAlways>() != null;

        internal static void Forget(Behaviour behaviour) => s_told.Remove(behaviour);

        internal static void Send(Behaviour behaviour, string message) => behaviour.GetType().GetMethod(message,
            BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)?.Invoke(behaviour, null);
    }
}
