using System;
using UnityEngine;

namespace UnityEditor.EditorTools
{
    public abstract class ToolAttribute : Attribute
    {
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class EditorToolAttribute : ToolAttribute
    {
        public EditorToolAttribute(string displayName, Type componentToolTarget = null)
        {
        }
    }

    public abstract class EditorTool : ScriptableObject
    {
        public virtual void OnActivated()
        {
        }

        public virtual void OnWillBeDeactivated()
        {
        }

        public virtual void OnToolGUI(EditorWindow window)
        {
        }
    }
}
