using System;
using System.Collections.Generic;

namespace UnityEditor
{
    /// <summary>Keeps what was said, and lets a test press the buttons.</summary>
    public static class Progress
    {
        [Flags]
        public enum Options
        {
            None = 0,
            Sticky = 1,
            Indefinite = 2,
            Synchronous = 4,
            Managed = 8,
            Unmanaged = 16,
        }

        public enum Status
        {
            Running = 0,
            Succeeded = 1,
            Failed = 2,
            Canceled = 3,
            Paused = 4,
        }

        public enum TimeDisplayMode
        {
            NoTimeShown = 0,
            ShowRunningTime = 1,
            ShowRemainingTime = 2,
        }

        internal sealed class Entry
        {
            public string Name;
            public string Description;
            public float Share;
            public Status Status;
            public Func<bool> Cancel;
            public Func<bool, bool> Pause;
        }

        internal static readonly List<Entry> Entries = new List<Entry>();

        public static int Start(string name, string description = null, Options options = Options.None, int parentId = -1)
        {
            Entries.Add(new Entry { Name = name, Description = description });
            return Entries.Count - 1;
        }

        public static void Report(int id, float progress, string description)
        {
            Entries[id].Share = progress;
            Entries[id].Description = description;
        }

        public static void Finish(int id, Status status = Status.Succeeded) => Entries[id].Status = status;

        public static bool Cancel(int id)
        {
            if (Entries[id].Cancel?.Invoke() != true)
                return false;
            Entries[id].Status = Status.Canceled;
            return true;
        }

        public static bool Pause(int id) => Entries[id].Pause?.Invoke(true) == true;

        public static bool Resume(int id) => Entries[id].Pause?.Invoke(false) == true;

        public static void SetTimeDisplayMode(int id, TimeDisplayMode displayMode)
        {
        }

        public static void SetRemainingTime(int id, long seconds)
        {
        }

        public static void RegisterCancelCallback(int id, Func<bool> callback) => Entries[id].Cancel = callback;

        public static void RegisterPauseCallback(int id, Func<bool, bool> callback) => Entries[id].Pause = callback;
    }
}
