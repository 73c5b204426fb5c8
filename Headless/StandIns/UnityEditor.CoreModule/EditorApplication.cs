using System;

namespace UnityEditor
{
    [AttributeUsage(AttributeTargets.Class)]
    public class InitializeOnLoadAttribute : Attribute
    {
    }

    public sealed class EditorApplication
    {
        public delegate void CallbackFunction();

        public static CallbackFunction update;

        /// <summary>How often frames were asked for.</summary>
        internal static int s_queuedUpdates;

        public static bool isPlaying { get; set; }

        public static event Action quitting;

        public static void QueuePlayerLoopUpdate() => s_queuedUpdates++;

        internal static void Quit() => quitting?.Invoke();
    }

    public static class AssemblyReloadEvents
    {
        public delegate void AssemblyReloadCallback();

        public static event AssemblyReloadCallback beforeAssemblyReload;

        internal static void Reload() => beforeAssemblyReload?.Invoke();
    }
}
