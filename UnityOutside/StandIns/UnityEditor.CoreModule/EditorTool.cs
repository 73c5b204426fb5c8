namespace UnityEditor.EditorTools;

public abstract class ToolAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Class)]
public sealed class EditorToolAttribute : ToolAttribute
{
    public EditorToolAttribute(string displayName, Type componentToolTarget = null) { }
}

/// <summary>One is active: before scripts are reloaded it is told that it will not be, and afterwards that it is.</summary>
public abstract class EditorTool : ScriptableObject
{
    internal bool IsActive { get; private set; }

    internal void Activate()
    {
        OnActivated();
        IsActive = true;
        AssemblyReloadEvents.beforeAssemblyReload += Deactivate;
    }

    internal void Deactivate()
    {
        AssemblyReloadEvents.beforeAssemblyReload -= Deactivate;
        if (IsActive)
            OnWillBeDeactivated();
        IsActive = false;
    }

    public virtual void OnActivated() { }
    public virtual void OnWillBeDeactivated() { }
    public virtual void OnToolGUI(EditorWindow window) { }
}
