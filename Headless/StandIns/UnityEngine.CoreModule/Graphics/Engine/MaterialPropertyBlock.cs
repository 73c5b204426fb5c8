using StandIns.Graphics;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>Values for one draw, before the material's.</summary>
    public sealed class MaterialPropertyBlock
    {
        public bool isEmpty => Sheet.IsEmpty;

        internal PropertySheet Sheet { get; } = new PropertySheet();

        public void Clear() => Sheet.Clear();

        public void SetFloat(int nameID, float value) => Sheet.Set(nameID, PropertyValue.Of(value));

        /// <summary>As a float, which is what Unity makes of it.</summary>
        public void SetInt(int nameID, int value) => Sheet.Set(nameID, PropertyValue.Of((float)value));

        public void SetInteger(int nameID, int value) => Sheet.Set(nameID, PropertyValue.Of(value));

        public void SetVector(int nameID, Vector4 value) => Sheet.Set(nameID, PropertyValue.Of(value));

        public void SetColor(int nameID, Color value) => Sheet.Set(nameID, PropertyValue.Of((Vector4)value));

        public void SetMatrix(int nameID, Matrix4x4 value) => Sheet.Set(nameID, PropertyValue.Of(value));

        public void SetFloatArray(int nameID, float[] values) => Sheet.Set(nameID, values);

        public void SetVectorArray(int nameID, Vector4[] values) => Sheet.Set(nameID, values);

        public void SetMatrixArray(int nameID, Matrix4x4[] values) => Sheet.Set(nameID, values);

        public void SetBuffer(int nameID, GraphicsBuffer value) => Sheet.Set(nameID, value);

        public void SetTexture(int nameID, Texture value) => Sheet.Set(nameID, value);

        public void SetTexture(int nameID, RenderTexture value, RenderTextureSubElement element) =>
            Sheet.Set(nameID, value, element == RenderTextureSubElement.Depth);
    }
}
