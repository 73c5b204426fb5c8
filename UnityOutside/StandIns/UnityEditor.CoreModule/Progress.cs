namespace UnityEditor;

/// <summary>Keeps what was said, and lets a test press the buttons. What has ended is not spoken of again: Unity may have
/// taken it out of its list.</summary>
public static class Progress
{
    [Flags]
    public enum Options { None = 0, Sticky = 1, Indefinite = 2, Synchronous = 4, Managed = 8, Unmanaged = 16 }

    public enum Status { Running = 0, Succeeded = 1, Failed = 2, Canceled = 3, Paused = 4 }
    public enum TimeDisplayMode { NoTimeShown = 0, ShowRunningTime = 1, ShowRemainingTime = 2 }

    internal sealed class Entry
    {
        public string Name;
        public string Description;
        public float Share;
        public Status Status;
        public bool IsManaged;
        public Func<bool> Cancel;
        public Func<bool, bool> Pause;

        public bool HasEnded => Status != Status.Running && Status != Status.Paused;
    }

    internal static readonly List<Entry> Entries = new List<Entry>();

    /// <summary>Managed, unless it is said that it is not: Unity's default for scripts.</summary>
    public static int Start(string name, string description = null, Options options = Options.None, int parentId = -1)
    {
        Entries.Add(new Entry { Name = name, Description = description, IsManaged = (options & Options.Unmanaged) == 0 });
        return Entries.Count - 1;
    }

    public static void Report(int id, float progress, string description)
    {
        var entry = Going(id);
        entry.Share = progress;
        entry.Description = description;
    }

    public static void Finish(int id, Status status = Status.Succeeded) => Going(id).Status = status;

    public static bool Cancel(int id)
    {
        var entry = Entries[id];
        if (entry.HasEnded || entry.Cancel?.Invoke() != true)
            return false;
        entry.Status = Status.Canceled;
        return true;
    }

    public static bool Pause(int id) => Pause(Entries[id], true);
    public static bool Resume(int id) => Pause(Entries[id], false);

    /// <summary>Before scripts are reloaded Unity cancels what it manages, as its window's button would.</summary>
    internal static void CancelManaged()
    {
        for (int id = 0; id < Entries.Count; id++)
            if (Entries[id].IsManaged)
                Cancel(id);
    }

    static Entry Going(int id) => Entries[id].HasEnded
        ? throw new InvalidOperationException("the progress of " + Entries[id].Name + " has ended: " + Entries[id].Status)
        : Entries[id];

    static bool Pause(Entry entry, bool isPaused)
    {
        if (entry.HasEnded || entry.Pause?.Invoke(isPaused) != true)
            return false;
        entry.Status = isPaused ? Status.Paused : Status.Running;
        return true;
    }

    public static void SetTimeDisplayMode(int id, TimeDisplayMode displayMode) { }
    public static void SetRemainingTime(int id, long seconds) { }
    public static void RegisterCancelCallback(int id, Func<bool> callback) => Entries[id].Cancel = callback;
    public static void RegisterPauseCallback(int id, Func<bool, bool> callback) => Entries[id].Pause = callback;
}
