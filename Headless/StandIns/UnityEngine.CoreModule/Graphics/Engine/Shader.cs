using System;
using StandIns.Graphics;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>A .shader file; a host loads it by its path (HeadlessShaders.Load).</summary>
    public sealed class Shader : Object
    {
        internal Shader(ShaderLabSource source)
        {
            Source = source;
            name = source.Name;
        }

        internal ShaderLabSource Source { get; }

        public bool isSupported => GpuDevice.TryGet(out _) != null;

        public int passCount => Source.Passes.Count;

        public LocalKeywordSpace keywordSpace => new LocalKeywordSpace(Source);

        public static int PropertyToID(string name) => PropertyNames.IdOf(name);

        public static void EnableKeyword(string keyword) => KeywordSet.Global.Set(keyword, true);

        public static void DisableKeyword(string keyword) => KeywordSet.Global.Set(keyword, false);

        public static bool IsKeywordEnabled(string keyword) => KeywordSet.Global.Contains(keyword);

        public static void SetGlobalFloat(int nameID, float value) => PropertySheet.Global.Set(nameID, PropertyValue.Of(value));

        /// <summary>As a float, which is what Unity makes of it.</summary>
        public static void SetGlobalInt(int nameID, int value) =>
            PropertySheet.Global.Set(nameID, PropertyValue.Of((float)value));

        public static void SetGlobalInteger(int nameID, int value) => PropertySheet.Global.Set(nameID, PropertyValue.Of(value));

        public static void SetGlobalVector(int nameID, Vector4 value) =>
            PropertySheet.Global.Set(nameID, PropertyValue.Of(value));

        public static void SetGlobalMatrix(int nameID, Matrix4x4 value) =>
            PropertySheet.Global.Set(nameID, PropertyValue.Of(value));

        public static void SetGlobalBuffer(int nameID, GraphicsBuffer value) => PropertySheet.Global.Set(nameID, value);

        public static void SetGlobalTexture(int nameID, Texture value) => PropertySheet.Global.Set(nameID, value);
    }
}
