namespace UnityEditor;

[Flags]
public enum ImportAssetOptions { Default = 0, ForceUpdate = 1 }

public enum RemoveAssetOptions { MoveAssetToTrash = 0 }
