namespace StandIns.Scene;

/// <summary>What the engine's loop tells behaviours: in play mode all of them, in an editor that does not play those that are
/// ExecuteAlways, and no others.</summary>
static class SceneLoop
{
    static readonly List<Behaviour> s_told = new List<Behaviour>();
    static readonly List<Object> s_leaving = new List<Object>();

    public static List<GameObject> Objects { get; } = new List<GameObject>(); // All that are in scenes, active or not.

    public static bool IsPlaying { get; set; } // What was there before is not told anew.

    /// <summary>One frame: an Update of all that are enabled, a LateUpdate, then what was destroyed in it goes.</summary>
    public static void Update()
    {
        UnityEngine.Graphics.ClearPrimitives();
        for (int i = 0; i < s_told.Count; i++)
        {
            var behaviour = s_told[i];
            if (!behaviour.IsStarted)
                Send(behaviour, "Start");
            behaviour.IsStarted = true;
            Send(behaviour, "Update");
        }
        for (int i = 0; i < s_told.Count; i++)
            Send(s_told[i], "LateUpdate");
        foreach (var removing in s_leaving.ToArray())
            Object.DestroyImmediate(removing);
        s_leaving.Clear();
    }

    /// <summary>As if somebody had moved it.</summary>
    public static void Place(Transform transform, Matrix4x4 localToWorld) => transform.localToWorldMatrix = localToWorld;

    internal static void DestroyLater(Object removing) => s_leaving.Add(removing);

    internal static T[] Find<T>() where T : Object => Objects.OfType<T>()
        .Concat(Objects.SelectMany(o => o.Components).OfType<T>())
        .ToArray();

    internal static void Clear()
    {
        foreach (var root in Objects.ToArray())
            Object.DestroyImmediate(root);
    }

    internal static void Refresh(Behaviour behaviour)
    {
        bool isOn = behaviour.isActiveAndEnabled;
        if (!IsPlaying && !behaviour.IsTold && !IsToldAlways(behaviour))
            return;
        if (!behaviour.IsAwake && behaviour.gameObject.activeInHierarchy)
        {
            behaviour.IsAwake = true;
            Send(behaviour, "Awake");
            isOn = behaviour.isActiveAndEnabled;
        }
        if (isOn == behaviour.IsTold)
            return;
        behaviour.IsTold = isOn;
        if (isOn)
            s_told.Add(behaviour);
        else
            s_told.Remove(behaviour);
        Send(behaviour, isOn ? "OnEnable" : "OnDisable");
    }

    internal static void Added(Behaviour behaviour)
    {
        if (!IsPlaying)
            Send(behaviour, "Reset");
    }

    static bool IsToldAlways(Behaviour behaviour) => behaviour.GetType().GetCustomAttribute<ExecuteAlways>() != null;

    internal static void Send(Object to, string message) => to.GetType().GetMethod(message,
        BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)?.Invoke(to, null);
}
