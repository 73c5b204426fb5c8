[assembly: InternalsVisibleTo("UnityEngine.Managed")]
[assembly: InternalsVisibleTo("Unity.Burst")]
[assembly: InternalsVisibleTo("Unity.Properties")]
[assembly: InternalsVisibleTo("Unity.Serialization")]
[assembly: InternalsVisibleTo("Unity.Transforms")]

namespace AOT
{
    [AttributeUsage(AttributeTargets.Method)]
    public class MonoPInvokeCallbackAttribute(Type type) : Attribute
    {
        public readonly Type Type = type;
    }
}

namespace UnityEngine
{
    public partial class Application
    {
        internal static bool HasARGV(string name) => false;
        internal static string GetValueForARGV(string name) => null;
    }

    public partial struct Bounds
    {
        public Vector3 extents
        {
            readonly get => m_extents;
            set => m_extents = value;
        }
    }

    public partial class Debug
    {
        public static void Log(object message, Object context) => Log(message);
        public static void LogWarning(object message, Object context) => LogWarning(message);
        public static void LogError(object message, Object context) => LogError(message);
        public static void LogException(Exception exception, Object context) => LogException(exception);
        public static void LogAssertion(object message) => Write(LogType.Assert, message);
        public static void Assert(bool condition) => Assert(condition, "Assertion failed");

        public static void Assert(bool condition, string message)
        {
            if (!condition)
                LogAssertion(message);
        }
    }

    public partial class GameObject
    {
        public GameObject() : this("New Game Object") { }

        internal static void InstantiateGameObjects(int sourceInstanceID, int count, NativeArray<int> newInstanceIDs,
            NativeArray<int> newTransformInstanceIDs, SceneManagement.Scene destinationScene) =>
            throw new NotSupportedException();
        internal static SceneManagement.Scene GetScene(int instanceID) => throw new NotSupportedException();
    }

    public partial struct Mathf
    {
        public static int RoundToInt(float f) => (int)MathF.Round(f);
        public static int FloorToInt(float f) => (int)MathF.Floor(f);
        public static int CeilToInt(float f) => (int)MathF.Ceiling(f);
        public static int Min(int a, int b) => Math.Min(a, b);
        public static int Max(int a, int b) => Math.Max(a, b);
        public static float Min(float a, float b) => Math.Min(a, b);
        public static float Max(float a, float b) => Math.Max(a, b);
        public static float Sqrt(float f) => MathF.Sqrt(f);
    }

    public partial class Object
    {
        public static void DontDestroyOnLoad(Object target) { }
    }

    public partial class Resources
    {
        public static void InstanceIDToObjectList(NativeArray<int> instanceIDs, List<Object> objects)
        {
            objects.Clear();
            objects.AddRange(instanceIDs.Select(InstanceIDToObject));
        }

        public static Object InstanceIDToObject(int instanceID) => null;
        public static bool InstanceIDIsValid(int instanceId) => false;
        public static object UnloadUnusedAssets() => null;
    }

    public partial class RuntimeInitializeOnLoadMethodAttribute
    {
        public RuntimeInitializeOnLoadMethodAttribute() { }
    }

    public partial class ScriptableObject
    {
        public static ScriptableObject CreateInstance(Type type)
        {
            var made = (ScriptableObject)Activator.CreateInstance(type);
            SceneLoop.Send(made, "OnEnable");
            return made;
        }
    }

    public partial class Time
    {
        public static float unscaledTime => 0;
        public static float fixedDeltaTime => 0.02f;
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class SerializeReference : Attribute { }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class ExecuteInEditMode : Attribute { }

    public class PlayerPrefs
    {
        public static int GetInt(string key, int defaultValue = 0) => defaultValue;
        public static void SetInt(string key, int value) { }
        public static string GetString(string key, string defaultValue = "") => defaultValue;
        public static void SetString(string key, string value) { }
    }

    static class ResourcesAPIInternal
    {
        internal static class EntitiesAssetGC
        {
            internal delegate void AdditionalRootsHandlerDelegate(IntPtr state);
            internal static void MarkInstanceIDsAsRoot(IntPtr instanceIDs, int count, IntPtr state) { }
            internal static void RegisterAdditionalRootsHandler(AdditionalRootsHandlerDelegate handler) { }
        }
    }
}

namespace UnityEngine.SceneManagement
{
    public partial class SceneManager
    {
        internal static Action<Scene> sceneUnloaded;
    }
}

namespace UnityEngine.Serialization
{
    public partial class FormerlySerializedAsAttribute
    {
        public string oldName => OldName;
    }
}
