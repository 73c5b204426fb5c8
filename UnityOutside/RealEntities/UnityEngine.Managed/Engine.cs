using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;

[assembly: InternalsVisibleTo("Unity.Burst")]
[assembly: InternalsVisibleTo("Unity.Collections")]
[assembly: InternalsVisibleTo("Unity.Entities")]
[assembly: InternalsVisibleTo("Unity.Entities.Hybrid")]
[assembly: InternalsVisibleTo("Unity.Properties")]
[assembly: InternalsVisibleTo("Unity.Serialization")]

namespace UnityEngine
{
    [Serializable]
    public struct Hash128 : IComparable<Hash128>, IEquatable<Hash128>
    {
        internal ulong u64_0;
        internal ulong u64_1;

        public Hash128(ulong u64_0, ulong u64_1)
        {
            this.u64_0 = u64_0;
            this.u64_1 = u64_1;
        }

        public Hash128(uint u32_0, uint u32_1, uint u32_2, uint u32_3)
            : this(((ulong)u32_1 << 32) | u32_0, ((ulong)u32_3 << 32) | u32_2) { }

        public bool isValid => u64_0 != 0 || u64_1 != 0;

        /// <summary>By another function than Unity's.</summary>
        public static unsafe Hash128 Compute(void* data, int size) => Of(new Span<byte>(data, size).ToArray());
        public static Hash128 Compute(string data) => Of(Encoding.UTF8.GetBytes(data));
        public static Hash128 Compute<T>(List<T> data) where T : struct =>
            Of(MemoryMarshal.AsBytes(data.ToArray().AsSpan()).ToArray());

        static Hash128 Of(byte[] bytes)
        {
            using var function = MD5.Create();
            return MemoryMarshal.Read<Hash128>(function.ComputeHash(bytes));
        }

        public int CompareTo(Hash128 other) => (u64_0, u64_1).CompareTo((other.u64_0, other.u64_1));
        public bool Equals(Hash128 other) => u64_0 == other.u64_0 && u64_1 == other.u64_1;
        public override bool Equals(object other) => other is Hash128 hash && Equals(hash);
        public override int GetHashCode() => (u64_0, u64_1).GetHashCode();
        public override string ToString() => u64_0.ToString("x16") + u64_1.ToString("x16");
        public static bool operator ==(Hash128 a, Hash128 b) => a.Equals(b);
        public static bool operator !=(Hash128 a, Hash128 b) => !a.Equals(b);
        public static bool operator <(Hash128 a, Hash128 b) => a.CompareTo(b) < 0;
        public static bool operator >(Hash128 a, Hash128 b) => a.CompareTo(b) > 0;
    }

    [Serializable]
    public struct LazyLoadReference<T> where T : Object
    {
        public int instanceID { get; set; }
    }

    public enum CompressionType { None, Lzma, Lz4, Lz4HC }
    public enum WeightedMode { None, In, Out, Both }
    public enum WrapMode { Default = 0, Once = 1, Clamp = 1, Loop = 2, PingPong = 4, ClampForever = 8 }

    public struct Keyframe
    {
        public float time, value, inTangent, outTangent, inWeight, outWeight;
        public WeightedMode weightedMode;

        public Keyframe(float time, float value, float inTangent, float outTangent, float inWeight, float outWeight)
        {
            (this.time, this.value, this.inTangent, this.outTangent) = (time, value, inTangent, outTangent);
            (this.inWeight, this.outWeight, weightedMode) = (inWeight, outWeight, WeightedMode.None);
        }
    }

    public class AnimationCurve
    {
        readonly List<Keyframe> m_keys = new List<Keyframe>();

        public int length => m_keys.Count;
        public WrapMode preWrapMode { get; set; }
        public WrapMode postWrapMode { get; set; }
        public Keyframe this[int index] => m_keys[index];

        public int AddKey(Keyframe key)
        {
            m_keys.Add(key);
            return m_keys.Count - 1;
        }
    }

    static class MethodImplOptionsEx
    {
        public const MethodImplOptions AggressiveInlining = MethodImplOptions.AggressiveInlining;
    }
}

namespace UnityEngine.LowLevel
{
    public struct PlayerLoopSystem
    {
        public delegate void UpdateFunction();
        public Type type;
        public PlayerLoopSystem[] subSystemList;
        public UpdateFunction updateDelegate;
        public IntPtr updateFunction;
        public IntPtr loopConditionFunction;
        public override string ToString() => type?.Name;
    }

    public class PlayerLoop
    {
        static readonly Type[] s_steps =
        {
            typeof(UnityEngine.PlayerLoop.Initialization),
            typeof(UnityEngine.PlayerLoop.Update),
            typeof(UnityEngine.PlayerLoop.PreLateUpdate),
        };

        static PlayerLoopSystem s_current = GetDefaultPlayerLoop();

        public static PlayerLoopSystem GetDefaultPlayerLoop() => new PlayerLoopSystem
        {
            subSystemList = Array.ConvertAll(s_steps,
                step => new PlayerLoopSystem { type = step, subSystemList = new PlayerLoopSystem[0] }),
        };

        public static PlayerLoopSystem GetCurrentPlayerLoop() => s_current;
        public static void SetPlayerLoop(PlayerLoopSystem loop) => s_current = loop;
    }
}

namespace UnityEngine.PlayerLoop
{
    public struct Initialization { }
    public struct Update { }
    public struct PreLateUpdate { }
}

namespace UnityEngine.SceneManagement
{
    public enum LoadSceneMode { Single, Additive }

    [Flags]
    public enum LocalPhysicsMode { None, Physics2D, Physics3D }
}

// Nothing is downloaded.
namespace UnityEngine.Networking
{
    public class DownloadHandlerFile : IDisposable
    {
        public DownloadHandlerFile(string path, bool append) { }
        public bool removeFileOnAbort { get; set; }
        public void Dispose() { }
    }

    public class UnityWebRequest : IDisposable
    {
        public const string kHttpVerbGET = "GET";
        public UnityWebRequest(string url, string method, DownloadHandlerFile downloadHandler, object uploadHandler) { }
        public UnityWebRequestAsyncOperation SendWebRequest() => throw new NotSupportedException();
        public ulong downloadedBytes => 0;
        public bool isDone => true;
        public string error => null;
        public void Abort() { }
        public void Dispose() { }
    }

    public class UnityWebRequestAsyncOperation
    {
        public UnityWebRequest webRequest => null;
        public bool isDone => true;
    }
}

namespace UnityEditor
{
    static class NoEditor { }
}

namespace Unity.IL2CPP.CompilerServices
{
    class Il2CppEagerStaticClassConstructionAttribute : Attribute { }
}

namespace Unity.Burst.LowLevel
{
    /// <summary>Nothing is compiled by Burst.</summary>
    public static unsafe class BurstCompilerService
    {
        static readonly Dictionary<UnityEngine.Hash128, (IntPtr At, uint Bytes)> s_shared =
            new Dictionary<UnityEngine.Hash128, (IntPtr, uint)>();

        public enum BurstLogType { Info, Warning, Error }

        public static bool IsInitialized => false;

        public static void* GetOrCreateSharedMemory(ref UnityEngine.Hash128 key, uint size_of, uint alignment)
        {
            lock (s_shared)
            {
                if (!s_shared.TryGetValue(key, out var known))
                {
                    byte* memory = (byte*)Marshal.AllocHGlobal((int)size_of + 63);
                    known = ((IntPtr)(((long)memory + 63) & ~63L), size_of);
                    new Span<byte>((void*)known.At, (int)size_of).Clear();
                    s_shared.Add(key, known);
                }
                return known.Bytes < size_of ? null : (void*)known.At;
            }
        }

        public static int CompileAsyncDelegateMethod(object delegateMethod, string compilerOptions) => 0;
        public static void* GetAsyncCompiledAsyncDelegateMethod(int userID) => null;
        public static string GetDisassembly(System.Reflection.MethodInfo m, string compilerOptions) => "";
        public static bool LoadBurstLibrary(string fullPathToLibBurstGenerated) => false;
        public static void SetCurrentExecutionMode(uint environment) { }
        public static uint GetCurrentExecutionMode() => 0;
        public static void Log(void* userData, BurstLogType logType, byte* message, byte* fileName, int lineNumber) =>
            UnityEngine.Debug.Log(Marshal.PtrToStringUTF8((IntPtr)message));
    }
}
