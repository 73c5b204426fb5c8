namespace UnityEngine;

public partial class ScriptableObject : Object
{
    public static T CreateInstance<T>() where T : ScriptableObject
    {
        var made = Activator.CreateInstance<T>();
        SceneLoop.Send(made, "OnEnable");
        return made;
    }

    internal override void OnDestroyed()
    {
        SceneLoop.Send(this, "OnDisable");
        SceneLoop.Send(this, "OnDestroy");
    }
}
