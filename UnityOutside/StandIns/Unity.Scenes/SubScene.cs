using UnityEditor;
using UnityEngine;

namespace Unity.Scenes;

/// <summary>Nothing here bakes or streams a scene.</summary>
public class SubScene : MonoBehaviour
{
    public bool AutoLoadScene = true;

    public SceneAsset SceneAsset { get; set; }
}
