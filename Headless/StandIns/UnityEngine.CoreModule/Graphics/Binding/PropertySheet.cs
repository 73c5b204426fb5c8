using System.Collections.Generic;
using UnityEngine;

namespace StandIns.Graphics
{
    /// <summary>Values by name: of a material, a property block, a compute shader, or of all.</summary>
    sealed class PropertySheet
    {
        /// <summary>What Shader.SetGlobal and CommandBuffer.SetGlobal set.</summary>
        internal static readonly PropertySheet Global = new PropertySheet();

        readonly Dictionary<int, PropertyValue> m_values = new Dictionary<int, PropertyValue>();

        internal bool IsEmpty => m_values.Count == 0;

        internal void Clear() => m_values.Clear();

        internal void CopyFrom(PropertySheet other)
        {
            m_values.Clear();
            foreach (KeyValuePair<int, PropertyValue> pair in other.m_values)
                m_values.Add(pair.Key, pair.Value);
        }

        internal bool TryGet(int name, out PropertyValue value) => m_values.TryGetValue(name, out value);

        internal void Set(int name, in PropertyValue value) => m_values[name] = value;

        /// <summary>A name that stands for no buffer or texture is as if it had not been set.</summary>
        internal void Set(int name, GraphicsBuffer value)
        {
            if (value == null)
                m_values.Remove(name);
            else
                m_values[name] = PropertyValue.Of(value);
        }

        internal void Set(int name, Texture value, bool isDepth = false)
        {
            if (value == null)
                m_values.Remove(name);
            else
                m_values[name] = PropertyValue.Of(value, isDepth);
        }
    }
}
